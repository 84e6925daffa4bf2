// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_REGION_DISTANCES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_REGION_DISTANCES_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/undecided_region.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

The distance of two regions of the plane, and where they are nearest to each other.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Region_distance_2
{
public:
  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;

  //! points of the boundaries of both regions.
  struct Pair
  {
    std::array<std::size_t, 2> curves;   ///< the indices of the curves, of the first region and of the second one
    Point_pair<Kernel, 2> points;        ///< the points on them
  };

private:
  std::vector<Pair> m_pairs;
  std::vector<Undecided_part> m_undecided;
  Range m_squared_distance;
  Summary m_summary;

public:
  //! these pairs, and a range of the square of the distance.
  Region_distance_2(std::vector<Pair> pairs, std::vector<Undecided_part> undecided, Range squared_distance,
                    const Summary& work)
    : m_pairs(std::move(pairs)), m_undecided(std::move(undecided)), m_squared_distance(std::move(squared_distance)),
      m_summary(work)
  {
    m_summary.is_complete = m_undecided.empty();
  }

  //! where the boundaries are nearest to each other: every pair of nearest points is one of these, or belongs to a
  //! continuum that is one. None if a boundary of one region is inside of the other.
  const std::vector<Pair>& pairs() const { return m_pairs; }

  //! the square of the distance lies between these numbers; they are equal where it is known exactly. It is zero where
  //! the regions have a point in common.
  const Range& squared_distance_range() const { return m_squared_distance; }

  //! the distance lies between these doubles.
  std::pair<double, double> distance_range() const { return internal::Distances::root_range(m_squared_distance); }

  //! whether the regions, with their boundaries, have a point in common; indeterminate where boundaries that may touch
  //! are not proved to, or not to.
  CGAL::Uncertain<bool> do_meet() const
  {
    const bool may_meet = !(m_squared_distance.first > 0), do_certainly = m_squared_distance.second == 0;
    return {do_certainly, may_meet};
  }

  //! whether none of the pairs is undecided, and all were looked at that may be nearest.
  bool is_complete() const { return m_summary.is_complete; }

  //! boxes around boundaries of the first region that may have other pairs of nearest points, and why that is not
  //! decided. Of a region that is not complete, its curves, those of the second one counted behind those of the first.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

namespace internal {
namespace Distances {

// Whether a boundary of one region has its first point inside of the other one: they overlap then, whether boundaries
// meet or not.
template <class Region>
bool has_boundary_in(const Region& a, const Region& b)
{
  return std::any_of(a.loops().begin(), a.loops().end(), [&](const Boundary_loop_2& loop) {
    return b.bounded_side(loop.pieces().front().at(0)) == CGAL::ON_BOUNDED_SIDE;
  });
}

// Parts of the curves of two regions, and the square of the distance of their boxes.
struct Curves_by_distance
{
  Exact_rational least_squared_distance;
  std::size_t first, second;
};

inline Exact_rational squared_distance_of_boxes(const CGAL::Bbox_2& a, const CGAL::Bbox_2& b)
{
  Exact_rational result(0);
  for (int k = 0; k < 2; ++k) {
    const Exact_rational gap = (std::max)(
        Exact_rational(to_rational((std::max)(a.min(k), b.min(k))) - to_rational((std::min)(a.max(k), b.max(k)))),
        Exact_rational(0));
    result += gap * gap;
  }
  return result;
}

// The parts of the curves of a region that belong to its boundaries, with the indices of the curves. Where boundaries
// only touch they are not cut.
template <SplineKernel Kernel>
std::vector<std::pair<std::size_t, Bspline_curve_2<Kernel>>> parts_on_boundaries(const Planar_region_2<Kernel>& region)
{
  std::vector<std::pair<std::size_t, Bspline_curve_2<Kernel>>> result;
  for (std::size_t c = 0; c < region.curves().size(); ++c) {
    const auto& arcs = region.arcs_of_curves()[c];
    for (std::size_t i = 0, last = 0; i < arcs.size(); i = last + 1) {
      for (last = i; last + 1 < arcs.size() && arcs[last].parameters[1] == arcs[last + 1].parameters[0];)
        ++last;
      // exact: a knot
      const auto at = [](const Exact_rational& t) { return converted_number<typename Kernel::FT>(t); };
      result.emplace_back(c, region.curves()[c].restricted(at(arcs[i].parameters[0]), at(arcs[last].parameters[1])));
    }
  }
  return result;
}

// That of their first points, which is an upper bound.
template <class Curve>
Exact_rational squared_distance_of_begins(const Curve& a, const Curve& b)
{
  const auto p = exact_object(a(a.domain(0).first)), q = exact_object(b(b.domain(0).first));
  return CGAL::squared_distance(p, q);
}

inline Undecided_part undecided_curve(const CGAL::Bbox_2& box, Undecided_reason reason)
{
  return {{{box.xmin(), box.xmax()}, {box.ymin(), box.ymax()}}, {}, in_words(reason)};
}

template <class Parts>
std::vector<Curves_by_distance> curves_by_distance(const Parts& a, const Parts& b)
{
  std::vector<Curves_by_distance> result;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      result.push_back({squared_distance_of_boxes(a[i].second.bbox(), b[j].second.bbox()), i, j});
  std::sort(result.begin(), result.end(), [](const auto& p, const auto& q) {
    return std::tie(p.least_squared_distance, p.first, p.second) <
        std::tie(q.least_squared_distance, q.first, q.second);
  });
  return result;
}

// Of regions of which one at least is not complete: their points are in boxes around the curves.
template <SplineKernel Kernel>
Region_distance_2<Kernel> undecided_distance(const Planar_region_2<Kernel>& a, const Planar_region_2<Kernel>& b)
{
  std::array<CGAL::Bbox_2, 2> boxes;
  std::vector<Undecided_part> undecided;
  Undecided_reason reason = Undecided_reason::NONE;
  for (const auto* region : {&a, &b}) {
    for (const Bspline_curve_2<Kernel>& curve : region->curves())
      boxes[region == &b] += curve.bbox();
    if (region->is_complete())
      continue;
    undecided.push_back(undecided_region(*region, region == &b ? a.curves().size() : 0));
    reason = region->summary().why_not;
  }
  Exact_rational most(0);
  for (int k = 0; k < 2; ++k) {
    const Exact_rational extent(to_rational((std::max)(boxes[0].max(k), boxes[1].max(k))) -
                                to_rational((std::min)(boxes[0].min(k), boxes[1].min(k))));
    most += Exact_rational(extent * extent);
  }
  return {{}, std::move(undecided), {squared_distance_of_boxes(boxes[0], boxes[1]), most}, undecided_summary(reason)};
}

} // namespace Distances
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDDistances

the distance of two regions, with all pairs of nearest points.

It is zero if a boundary of one region is inside of the other one, which is decided exactly. Else it is the least of the
distances of their curves, each of which `closest_points()` encloses. They are looked at in the order of the distances
of their boxes, as long as that is not larger than a distance that is known.

\param a the first region.
\param b the second region. Where one of them is not complete, all that is known are bounds from boxes around both.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: \f$O(nm \log nm)\f$ for \f$n\f$ and \f$m\f$ curves, and `closest_points()` for those pairs whose boxes are
near.
*/
template <SplineKernel Kernel>
Region_distance_2<Kernel> region_distance(const Planar_region_2<Kernel>& a, const Planar_region_2<Kernel>& b,
                                          const Solver_options& options = {})
{
  using Result = Region_distance_2<Kernel>;
  internal::Common::Operation_budget budget(options);
  if (!a.is_complete() || !b.is_complete())
    return internal::Distances::undecided_distance(a, b);
  if (internal::Distances::has_boundary_in(a, b) || internal::Distances::has_boundary_in(b, a))
    return Result({}, {}, {Exact_rational(0), Exact_rational(0)}, budget.total());
  std::vector<typename Result::Pair> pairs;
  std::vector<Undecided_part> undecided;
  std::optional<typename Result::Range> distance;
  const auto first = internal::Distances::parts_on_boundaries(a), second = internal::Distances::parts_on_boundaries(b);
  const auto include = [&](const typename Result::Range& range) {
    distance = distance
        ? typename Result::Range{(std::min)(distance->first, range.first), (std::min)(distance->second, range.second)}
        : range;
  };
  for (const internal::Distances::Curves_by_distance& curves : internal::Distances::curves_by_distance(first, second)) {
    if (distance && curves.least_squared_distance > distance->second)
      break;
    const Bspline_curve_2<Kernel>&c = first[curves.first].second, &other = second[curves.second].second;
    if (budget.must_stop()) {
      include({curves.least_squared_distance, internal::Distances::squared_distance_of_begins(c, other)});
      undecided.push_back(internal::Distances::undecided_curve(c.bbox(), budget.reason()));
      continue;
    }
    const auto nearest = closest_points(c, other, budget.remaining());
    include(nearest.squared_distance_range());
    budget.add(nearest.summary());
    for (const auto& points : nearest)
      pairs.push_back({{first[curves.first].first, second[curves.second].first}, points});
    for (const Undecided_part& part : nearest.undecided())
      undecided.push_back({part.place, {}, part.reason});
  }
  std::erase_if(pairs, [&](const auto& pair) { return pair.points.squared_distance_range().first > distance->second; });
  if (std::none_of(pairs.begin(), pairs.end(),
                   [](const auto& pair) { return pair.points.kind() == Solution_kind::UNDECIDED; }) &&
      !budget.must_stop())
    undecided.clear(); // they are farther
  return Result(std::move(pairs), std::move(undecided), *distance, budget.total());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_REGION_DISTANCES_2_H
