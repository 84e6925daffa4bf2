// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_PAIRWISE_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_PAIRWISE_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_operand.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Pairwise_common_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/intersections_at.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

Whether the intersections of a collection of curves include those of each curve with itself.
*/
enum class Self_intersections { EXCLUDED, INCLUDED };

/*!
\ingroup PkgSplineConstraintsDIntersections

Two curves of a collection that meet, or may meet; or a curve and itself.
*/
template <SplineKernel Kernel, int d>
struct Intersecting_pair
{
  //! the positions of the two curves in the collection; with two collections, each in its own. The same ones where a
  //! curve meets itself.
  std::size_t first, second;
  //! where they meet; never empty.
  Spline_constraints::Intersections<Kernel, d> intersections;
};

/*!
\ingroup PkgSplineConstraintsDIntersections

All intersections between the curves of one collection, or of two.
*/
template <SplineKernel Kernel, int d>
class Pairwise_intersections
{
public:
  //! two curves that meet.
  using Pair = Intersecting_pair<Kernel, d>;

private:
  std::vector<Pair> m_pairs;
  std::size_t m_number_of_first;
  std::vector<Undecided_part> m_rest;
  Summary m_summary;

public:
  //! these pairs, and what is undecided since pairs were not looked at. Curves of a second collection are operands
  //! behind the first ones.
  Pairwise_intersections(std::vector<Pair> pairs, std::size_t number_of_first, std::vector<Undecided_part> rest,
                         const Summary& work)
    : m_pairs(std::move(pairs)), m_number_of_first(number_of_first), m_rest(std::move(rest)), m_summary(work)
  {}

  //! the pairs of curves that meet, or are not proved not to, in lexicographic order. Those that were not looked at,
  //! since the run had ended, are none of them.
  const std::vector<Pair>& pairs() const { return m_pairs; }

  //! whether no intersection is missing, by proof, and none is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! what is undecided, where in space and on the curves, and why. Operands are numbered as the curves of the
  //! collection; those of a second one go on where the first one ends. Where the run ended before all pairs were looked
  //! at, there is one part for all those that were not of each curve of the (first) collection: this curve as a whole.
  std::vector<Undecided_part> undecided() const
  {
    std::vector<Undecided_part> result;
    for (const Pair& pair : m_pairs)
      for (Undecided_part& part : pair.intersections.undecided()) {
        for (Undecided_part::Parameters& parameters : part.parameters)
          parameters.operand = parameters.operand == 0 ? pair.first : m_number_of_first + pair.second;
        result.push_back(std::move(part));
      }
    result.insert(result.end(), m_rest.begin(), m_rest.end());
    return result;
  }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

namespace internal {
namespace Intersections {

template <class Range>
concept Range_of_curves = std::ranges::input_range<Range> && Parametric_curve<std::ranges::range_value_t<Range>>;

template <class Range>
using Operand_of_range = Spline_operand<std::ranges::range_value_t<Range>>;

template <class Range>
auto patches_of(Range&& range)
{
  std::vector<Spline_patch<Operand_of_range<Range>::dimension>> result;
  for (const auto& curve : range)
    result.emplace_back(curve);
  return result;
}

// Those of the pairs that have any, in points of the kernel of the curves. `is_one`: of one collection.
template <SplineKernel Kernel, int d>
Pairwise_intersections<Kernel, d> pairwise_intersections_at(Pairs_with_common_points found,
                                                            const std::vector<Spline_patch<d>>& first,
                                                            const std::vector<Spline_patch<d>>& second, bool is_one)
{
  std::vector<Intersecting_pair<Kernel, d>> result;
  std::vector<Undecided_part> rest;
  Summary summary;
  for (Pair_with_common_points& pair : found.pairs) {
    auto intersections = intersections_at<Kernel, d>(std::move(pair.points),
                                                     Patch_pair<d>(first[pair.first], second[pair.second]), pair.work);
    summary += intersections.summary();
    if (!intersections.empty())
      result.push_back({pair.first, pair.second, std::move(intersections)});
  }
  for (const std::size_t i : found.rest)
    rest.push_back(
        {double_ranges(first[i].values()), {{i, {double_range(first[i].domain(0))}}}, in_words(found.reason)});
  if (!rest.empty()) {
    summary.is_complete = false;
    summary.why_not = found.reason;
  }
  return {std::move(result), is_one ? 0 : first.size(), std::move(rest), summary};
}

} // namespace Intersections
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

all intersections between each two curves of a collection, such as the paths of a drawing; on request also those of each
curve with itself, as pairs of a curve with itself.

Only pairs whose bounding boxes meet are solved (`CGAL::box_self_intersection_d()`), and in a pair of splines only
pieces whose bounds meet. The answers are those of `intersections()` for each pair, and those of `self_intersections()`.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to hand
pairs to all cores through TBB. The answers are the same.
\tparam Range a range of curves that are models of `ParametricCurve_2`, or of `ParametricCurve_3`.
\param curves the curves.
\param options those of the solver; limits hold for the operation as a whole.
\param self_intersections whether those of each curve with itself are found too.
\throws Invalid_input when the weight of a curve is not proved to have one sign, or an option makes no sense.

Complexity: \f$O(n \log^d n + k)\f$ for \f$n\f$ curves with \f$k\f$ pairs of boxes that meet, and the systems of these
pairs.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, internal::Intersections::Range_of_curves Range>
auto pairwise_intersections(Range&& curves, const Solver_options& options = {},
                            Self_intersections self_intersections = Self_intersections::EXCLUDED)
{
  using Operand = internal::Intersections::Operand_of_range<Range>;
  constexpr int d = Operand::dimension;
  const internal::Intersections::Pairwise_common_points<d> points(options);
  const auto patches = internal::Intersections::patches_of(curves);
  return internal::Intersections::pairwise_intersections_at<typename Operand::Kernel, d>(
      self_intersections == Self_intersections::INCLUDED ? points.template among_and_within<Concurrency_tag>(patches)
                                                         : points.template among<Concurrency_tag>(patches),
      patches, patches, true);
}

/*!
\ingroup PkgSplineConstraintsDIntersections

all intersections between the curves of one collection and those of another one, as `pairwise_intersections()` of one
collection.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`.
\tparam Range,Other_range ranges of curves of the same type, models of `ParametricCurve_2` or of `ParametricCurve_3`.
\param curves the first collection.
\param others the second collection.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when the weight of a curve is not proved to have one sign, or an option makes no sense.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, internal::Intersections::Range_of_curves Range,
          internal::Intersections::Range_of_curves Other_range>
requires std::same_as<std::ranges::range_value_t<Range>, std::ranges::range_value_t<Other_range>>
auto pairwise_intersections(Range&& curves, Other_range&& others, const Solver_options& options = {})
{
  using Operand = internal::Intersections::Operand_of_range<Range>;
  constexpr int d = Operand::dimension;
  const internal::Intersections::Pairwise_common_points<d> points(options);
  const auto first = internal::Intersections::patches_of(curves), second = internal::Intersections::patches_of(others);
  return internal::Intersections::pairwise_intersections_at<typename Operand::Kernel, d>(
      points.template between<Concurrency_tag>(first, second), first, second, false);
}

/*!
\ingroup PkgSplineConstraintsDIntersections

the pairs of `pairwise_intersections()` of one collection, written to an output iterator: also those that are undecided.
\param curves,options,self_intersections as above.
\param output takes objects of type `Intersecting_pair` with the kernel and dimension of the curves.
\returns the output iterator behind the last one.
\throws Invalid_input as the function above.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, internal::Intersections::Range_of_curves Range, class Output>
requires std::output_iterator<Output,
                              Intersecting_pair<typename internal::Intersections::Operand_of_range<Range>::Kernel,
                                                internal::Intersections::Operand_of_range<Range>::dimension>>
    Output pairwise_intersections(Range&& curves, Output output, const Solver_options& options = {},
                                  Self_intersections self_intersections = Self_intersections::EXCLUDED)
{
  const auto found = pairwise_intersections<Concurrency_tag>(curves, options, self_intersections);
  return std::copy(found.pairs().begin(), found.pairs().end(), output);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_PAIRWISE_INTERSECTIONS_H
