// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_CIRCULAR_POLYGONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_CIRCULAR_POLYGONS_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_enums.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// Closed polylines as runs of vertices that a segment or an arc of a circle passes, each as long as possible.
class Circular_runs
{
public:
  using Point = std::array<double, 2>;

private:
  const std::vector<Point>& m_points;   // of a polygon
  double m_error;

public:
  // The first vertex of a run, and one in the middle, if it is an arc; the run ends with the first vertex of the next
  // one.
  struct Run
  {
    std::size_t begin;
    std::optional<std::size_t> middle;
  };

  Circular_runs(const std::vector<Point>& points, double error) : m_points(points), m_error(error) {}

  std::vector<Run> operator()() const;

private:
  const Point& point(std::size_t i) const { return m_points[i % m_points.size()]; }

  static double distance(const Point& p, const Point& q) { return std::hypot(q[0] - p[0], q[1] - p[1]); }

  static std::size_t middle(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

  // The end of a run that is as long as doubling and halving its length finds it; at least one edge.
  template <class Is_possible>
  std::size_t farthest(std::size_t begin, const Is_possible& is_possible) const
  {
    std::size_t length = 1, step = 1;
    const auto is_end = [&](std::size_t steps) {
      return begin + steps <= m_points.size() && is_possible(begin + steps);
    };
    while (is_end(length + step)) {
      length += step;
      step *= 2;
    }
    for (; step > 0; step /= 2)
      if (is_end(length + step))
        length += step;
    return begin + length;
  }

  // Whether the edges in between are near the segment, in its direction.
  bool is_straight(std::size_t begin, std::size_t end) const;

  // Whether the edges in between are near the arc of a circle through the ends and the vertex in the middle, which is
  // less than half a circle: their ends are near it, in order, and the rest is not farther than that and the height of
  // the arc over an edge.
  bool is_round(std::size_t begin, std::size_t end) const;
};

template <class Traits, class Kernel>
typename Traits::Polygon_2 circular_polygon(const CGAL::Polygon_2<Kernel>& polygon, double error, const Traits& traits)
{
  using Arc = typename Traits::X_monotone_curve_2;
  using Curve = typename Traits::Curve_2;
  using Rational_point = std::decay_t<decltype(std::declval<const Curve&>().supporting_circle().center())>;
  std::vector<Circular_runs::Point> points;
  for (const auto& p : polygon) {
    const Circular_runs::Point q{CGAL::to_double(p.x()), CGAL::to_double(p.y())};
    if (!(std::abs(q[0]) <= most_magnitude && std::abs(q[1]) <= most_magnitude))   // sweeps fail with much greater ones
      throw Invalid_input("to_circular_polygons: a coordinate is not between -2^250 and 2^250");
    if (points.empty() || q != points.back())
      points.push_back(q);
  }
  while (points.size() > 1 && points.back() == points.front())
    points.pop_back();
  if (points.size() < 2)
    return {};
  const auto point = [&](std::size_t i) {
    return Rational_point(points[i % points.size()][0], points[i % points.size()][1]);
  };
  std::vector<Arc> arcs;
  const auto runs = Circular_runs(points, error)();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Rational_point begin = point(runs[i].begin), end = point(runs[(i + 1) % runs.size()].begin);
    const Curve curve = runs[i].middle ? Curve(begin, point(*runs[i].middle), end) : Curve(begin, end);
    traits.make_x_monotone_2_object()(
        curve,
        CGAL::dispatch_output<typename Traits::Point_2, Arc>(CGAL::Emptyset_iterator(), std::back_inserter(arcs)));
  }
  return {arcs.begin(), arcs.end()};
}

template <class Region, class Traits>
std::vector<typename Traits::Polygon_with_holes_2> circular_polygons(const Region& region, double error,
                                                                     const Traits& traits)
{
  std::vector<typename Traits::Polygon_with_holes_2> result;
  for (const auto& polygon : region.polygons_with_holes(error / 3)) {
    const auto converted = [&](const auto& boundary) { return circular_polygon(boundary, error * 2 / 3, traits); };
    std::vector<typename Traits::Polygon_2> holes;
    std::transform(polygon.holes_begin(), polygon.holes_end(), std::back_inserter(holes), converted);
    result.emplace_back(converted(polygon.outer_boundary()), holes.begin(), holes.end());
  }
  return result;
}

// The arcs of general polygons in one arrangement, decided exactly: whether they meet in their ends only, and have a
// region on the left of all, and none on the right.
template <class Traits>
class Arcs_around_a_region
{
  using Labelled_traits = CGAL::Arr_consolidated_curve_data_traits_2<Traits, std::size_t>;
  using Arrangement = CGAL::Arrangement_2<Labelled_traits>;

  const Traits& m_traits;
  std::vector<typename Labelled_traits::X_monotone_curve_2> m_arcs;   // with their indices
  std::vector<CGAL::Arr_halfedge_direction> m_directions;
  bool m_is_any_boundary_empty = false;

public:
  Arcs_around_a_region(const std::vector<typename Traits::Polygon_with_holes_2>& polygons, const Traits& traits)
    : m_traits(traits)
  {
    for (const auto& polygon : polygons) {
      add(polygon.outer_boundary());
      for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
        add(*hole);
    }
  }

  bool operator()() const
  {
    Arrangement arrangement;
    CGAL::insert(arrangement, m_arcs.begin(), m_arcs.end());
    if (m_is_any_boundary_empty || arrangement.number_of_edges() != m_arcs.size())
      return false;
    std::set<const typename Arrangement::Face*> inner, outer{&*arrangement.unbounded_face()};
    for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end(); ++edge) {
      const auto& labels = edge->curve().data();
      if (labels.size() != 1)
        return false;   // arcs overlap
      const bool is_along_arc = edge->direction() == m_directions[*labels.begin()];
      inner.insert(&*(is_along_arc ? edge->face() : edge->twin()->face()));
      outer.insert(&*(is_along_arc ? edge->twin()->face() : edge->face()));
    }
    return std::none_of(inner.begin(), inner.end(), [&](const auto* face) { return outer.contains(face); });
  }

private:
  void add(const typename Traits::Polygon_2& boundary)
  {
    m_is_any_boundary_empty = m_is_any_boundary_empty || boundary.is_empty();
    for (auto arc = boundary.curves_begin(); arc != boundary.curves_end(); ++arc) {
      m_arcs.emplace_back(*arc, typename Labelled_traits::Data_container(m_directions.size()));
      m_directions.push_back(m_traits.compare_endpoints_xy_2_object()(*arc) == CGAL::SMALLER ? CGAL::ARR_LEFT_TO_RIGHT
                                                                                             : CGAL::ARR_RIGHT_TO_LEFT);
    }
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Circular_runs::Run> Circular_runs::operator()() const
{
  std::vector<Run> result;
  for (std::size_t begin = 0, end = 0; begin < m_points.size(); begin = end) {
    const std::size_t straight = farthest(begin, [&](std::size_t end) { return is_straight(begin, end); });
    const std::size_t round = farthest(begin, [&](std::size_t end) { return is_round(begin, end); });
    end = (std::max)(straight, round);
    result.push_back({begin, round > straight ? std::optional(middle(begin, round)) : std::nullopt});
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Circular_runs::is_straight(std::size_t begin, std::size_t end) const
{
  const Point &p = point(begin), &q = point(end);
  const double length = distance(p, q);
  double last = 0;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const Point arm{point(i)[0] - p[0], point(i)[1] - p[1]}, side{(q[0] - p[0]) / length, (q[1] - p[1]) / length};
    const double along = arm[0] * side[0] + arm[1] * side[1];
    if (!(std::abs(side[0] * arm[1] - side[1] * arm[0]) <= m_error && along >= last && along <= length))
      return false;
    last = along;
  }
  return length > 0;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Circular_runs::is_round(std::size_t begin, std::size_t end) const
{
  const Point &p = point(begin), &m = point(middle(begin, end)), &q = point(end);
  const Point a{m[0] - p[0], m[1] - p[1]}, b{q[0] - m[0], q[1] - m[1]};
  const double turn = a[0] * b[1] - a[1] * b[0], a2 = a[0] * a[0] + a[1] * a[1],
               c2 = (a[0] + b[0]) * (a[0] + b[0]) + (a[1] + b[1]) * (a[1] + b[1]);
  if (turn == 0 || !(a[0] * b[0] + a[1] * b[1] > 0))
    return false;
  const Point c{a[0] + b[0], a[1] + b[1]};
  const Point to_center{(c[1] * a2 - a[1] * c2) / (2 * turn), (a[0] * c2 - c[0] * a2) / (2 * turn)};
  const Point center{p[0] + to_center[0], p[1] + to_center[1]};
  const double radius = std::hypot(to_center[0], to_center[1]);
  double off = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Point r{point(i)[0] - center[0], point(i)[1] - center[1]},
        s{point(i + 1)[0] - center[0], point(i + 1)[1] - center[1]};
    const double next = std::abs(std::hypot(s[0], s[1]) - radius), half = distance(r, s) / 2;
    const bool is_in_order = (r[0] * s[1] - r[1] * s[0] > 0) == (turn > 0);
    // the height is at most that
    if (!(is_in_order && half < radius && (std::max)(off, next) + half * half / radius <= m_error))
      return false;
    off = next;
  }
  return true;
}
#endif

} // namespace Regions
} // namespace internal

//! \ingroup PkgSplineConstraintsDRegions
//! what has polygons with holes within any distance: `Planar_region_2`, `Trimmed_offset_2`, `Minkowski_sum_2`.
template <class Region>
concept Approximable_region_2 = requires(const Region& region) {
  region.polygons_with_holes(0.1).front().outer_boundary();
  region.polygons_with_holes(0.1).front().holes_begin();
};

/*!
\ingroup PkgSplineConstraintsDRegions

a region, an offset, a Minkowski sum or a swept area as general polygons with holes of CGAL, whose edges are segments
and arcs of circles, for its Boolean operations and arrangements.

The result is that of `polygons_with_holes()` with a third of the error, in which each run of chords is replaced by one
segment or arc through its ends, and a point between them, that is as long as the rest of the error allows. So edges
that are straight or round are one edge, or a few, and others have less arcs than chords. Edges begin and end in the
same points exactly: doubles.

Edges meet in common ends only, and the polygons have disjoint interiors. That is decided exactly; if it is not so, the
error is halved, up to eight times. Where boundaries touch with a common tangent, as those of a disk and a round hole
do, no error may be small enough: then the region is refused.

\tparam Traits `Gps_circle_segment_traits_2` over a kernel with exact numbers.
\param region the region; where an offset or sum is not complete, what has no closed boundary is left out, as from
polygons.
\param error edges are not farther than that from the boundaries, and these from them, up to rounding; positive.
\param traits the traits class.
\throws Invalid_input when the error is not positive, the absolute value of a coordinate is greater than \f$2^{250}\f$,
edges meet elsewhere with all of these errors, or a `Planar_region_2` is not complete.

Complexity: for each error that is tried, \f$O(n \log n)\f$ for \f$n\f$ chords, and a sweep over the arcs.
*/
template <class Traits, Approximable_region_2 Region>
std::vector<typename Traits::Polygon_with_holes_2> to_circular_polygons(const Region& region, double error,
                                                                        const Traits& traits = Traits())
{
  internal::check_error(error, "to_circular_polygons");
  constexpr int most_refinements = 8;
  for (int i = 0; i <= most_refinements; ++i, error /= 2) {
    auto result = internal::Regions::circular_polygons(region, error, traits);
    if (internal::Regions::Arcs_around_a_region<Traits>(result, traits)())
      return result;
  }
  throw Invalid_input("to_circular_polygons: edges meet elsewhere than in common ends, also if the error is " +
                      std::to_string(1 << most_refinements) + " times less");
}

//! \ingroup PkgSplineConstraintsDRegions
//! puts these general polygons to an output iterator.
//! \throws Invalid_input as above.
template <class Traits, Approximable_region_2 Region,
          std::output_iterator<typename Traits::Polygon_with_holes_2> OutputIterator>
OutputIterator to_circular_polygons(const Region& region, double error, OutputIterator out,
                                    const Traits& traits = Traits())
{
  return std::ranges::copy(to_circular_polygons<Traits>(region, error, traits), out).out;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_CIRCULAR_POLYGONS_2_H
