// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_PAIRWISE_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_PAIRWISE_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
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
struct Pairwise_intersections
{
  //! the pairs of curves that meet, or are not proved not to, in lexicographic order.
  std::vector<Intersecting_pair<Kernel, d>> pairs;

  //! whether no intersection is missing, by proof, and none is undecided; and the work of the solver.
  Summary summary;
};

namespace internal {
namespace Intersections {

template <class Range>
concept Range_of_curves = std::ranges::input_range<Range> && Parametric_curve<std::ranges::range_value_t<Range>>;

// Which curves of one collection, or of two, may meet each other, and where they do.
template <SplineKernel Kernel, int d>
class Pairwise_intersector
{
  using Patches = std::vector<Spline_patch<d>>;

  Solver_options m_options;

public:
  explicit Pairwise_intersector(const Solver_options& options) : m_options(options) { m_options.check(); }

  template <class Concurrency_tag>
  Pairwise_intersections<Kernel, d> within(const Patches& curves, Self_intersections self_intersections) const
  {
    std::vector<Index_pair> pairs = pairs_with_meeting_boxes(curves);
    if (self_intersections == Self_intersections::INCLUDED) {
      for (std::size_t i = 0; i < curves.size(); ++i)
        pairs.emplace_back(i, i);
      std::sort(pairs.begin(), pairs.end());
    }
    return intersected<Concurrency_tag>(pairs, [&](const Index_pair& pair) {
      return pair.first == pair.second
          ? self_intersections_of<Kernel, d>(curves[pair.first], m_options)
          : intersections_of<Kernel, d>(Patch_pair<d>(curves[pair.first], curves[pair.second]), m_options);
    });
  }

  template <class Concurrency_tag>
  Pairwise_intersections<Kernel, d> between(const Patches& first, const Patches& second) const
  {
    return intersected<Concurrency_tag>(pairs_with_meeting_boxes(first, second), [&](const Index_pair& pair) {
      return intersections_of<Kernel, d>(Patch_pair<d>(first[pair.first], second[pair.second]), m_options);
    });
  }

private:
  template <class Concurrency_tag, class Intersect>
  static Pairwise_intersections<Kernel, d> intersected(const std::vector<Index_pair>& pairs, const Intersect& intersect)
  {
    std::vector<std::optional<Spline_constraints::Intersections<Kernel, d>>> answers(pairs.size());
    parallel_for<Concurrency_tag>(pairs.size(), [&](std::size_t i, std::size_t) { answers[i] = intersect(pairs[i]); });
    Pairwise_intersections<Kernel, d> result;
    result.summary.is_complete = true;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      result.summary += answers[i]->summary();
      if (!answers[i]->empty())
        result.pairs.push_back({pairs[i].first, pairs[i].second, std::move(*answers[i])});
    }
    return result;
  }
};

template <class Range>
using Pairwise_intersector_of = Pairwise_intersector<typename std::ranges::range_value_t<Range>::Kernel,
                                                     Spline_operand<std::ranges::range_value_t<Range>>::dimension>;

template <class Range>
auto patches_of(const Range& range)
{
  std::vector<Spline_patch<Spline_operand<std::ranges::range_value_t<Range>>::dimension>> result;
  for (const auto& curve : range)
    result.emplace_back(curve);
  return result;
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
\param options those of the solver; limits hold for each pair alone.
\param self_intersections whether those of each curve with itself are found too.
\throws Invalid_input when the weight of a curve is not proved to have one sign, or an option makes no sense.

Complexity: \f$O(n \log^d n + k)\f$ for \f$n\f$ curves with \f$k\f$ pairs of boxes that meet, and the systems of these
pairs.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, internal::Intersections::Range_of_curves Range>
auto pairwise_intersections(const Range& curves, const Solver_options& options = {},
                            Self_intersections self_intersections = Self_intersections::EXCLUDED)
{
  return internal::Intersections::Pairwise_intersector_of<Range>(options).template within<Concurrency_tag>(
      internal::Intersections::patches_of(curves), self_intersections);
}

/*!
\ingroup PkgSplineConstraintsDIntersections

all intersections between the curves of one collection and those of another one, as `pairwise_intersections()` of one
collection.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`.
\tparam Range,Other_range ranges of curves of the same type, models of `ParametricCurve_2` or of `ParametricCurve_3`.
\param curves the first collection.
\param others the second collection.
\param options those of the solver; limits hold for each pair alone.
\throws Invalid_input when the weight of a curve is not proved to have one sign, or an option makes no sense.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, internal::Intersections::Range_of_curves Range,
          internal::Intersections::Range_of_curves Other_range>
requires std::same_as<std::ranges::range_value_t<Range>, std::ranges::range_value_t<Other_range>>
auto pairwise_intersections(const Range& curves, const Other_range& others, const Solver_options& options = {})
{
  return internal::Intersections::Pairwise_intersector_of<Range>(options).template between<Concurrency_tag>(
      internal::Intersections::patches_of(curves), internal::Intersections::patches_of(others));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_PAIRWISE_INTERSECTIONS_H
