// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ROLLING_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ROLLING_DISKS_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The disks of a given radius r that touch an element near points where the curvature is exactly 1/r, and not greater next
to them: no bounds tell that these disks are free.

Let a curve have a curvature of at most 1/r towards a disk that touches it, and a tangent that turns by less than 90
degrees from that in the point of footpoint. It is the graph of a function over that tangent, and in the distance x from
the point, the sine of the angle of the curve is the integral of the curvature, at most x/r, as it is for the circle. So
the curve is not inside of the disk: this rolls along it.

With Q = X' x X'' and S = |X'|^2 the curvature is k = Q / S^(3/2), and k' has the sign of G = (X' x X''') S - 3 Q
<X',X''>. That k is 1/r in a point is decided exactly, as is whether G is zero there; then bounds of G, or of G', tell
that k is less next to it.
*/
class Rolling_disks
{
  static constexpr double most_way = 0.5;   // between such a point and the parts of arcs that are looked at

  // A point of an arc, and the side on which the disks are: 1 left, -1 right.
  struct Place
  {
    std::size_t arc;
    Exact_rational parameter;
    int side;
  };

  const Site_graph_2<>& m_graph;
  const Oriented_element<>& m_element;
  Exact_rational m_squared_radius;
  Interval m_radius;
  std::vector<Place> m_places;   // of the element, with the curvature of the disks

public:
  Rolling_disks(const Site_graph_2<>& graph, std::size_t element, const Exact_rational& radius)
    : m_graph(graph), m_element(graph.elements()[element]), m_squared_radius(radius * radius),
      m_radius(interval_of<Interval>(radius))
  {
    if (are_places_exact())
      for (const bool end : {false, true})
        add_place(Exact_rational(end ? 1 : 0), range_at(end ? 1 : 0, 0));
  }

  // Looks for a place in a part of the element, where it has the simplest parameter.
  void look_for_place_in(const Range& range)
  {
    if (are_places_exact() && certain_sign(slope_of_curvature(arc().jet(range))[0]) == 0)
      add_place(simplest_rational_between(Exact_rational(range.begin), Exact_rational(range.end)), range);
  }

  // Removes the candidates that disks of a part of the element roll along.
  void erase_below(const Range& range, std::vector<Disk_candidate<>>& candidates) const
  {
    for (const Place& place : m_places) {
      const Range own = range_with(place, range, candidates);
      if (!roll(range, place, own))
        continue;
      erase(place, own, candidates);
      for (const bool end : {false, true})
        if (place.parameter == Exact_rational(end ? 1 : 0))
          for (const Smooth_continuation<>& next : m_graph.continuations({place.arc, end}).smooth)
            erase_beyond(place, next.end, range, candidates);
    }
  }

private:
  // Those of the arc that goes on where a place is.
  void erase_beyond(const Place& place, const Arc_end& next, const Range& range,
                    std::vector<Disk_candidate<>>& candidates) const
  {
    if (!m_graph.is_exact(next))
      return;
    const Place beyond{next.arc, Exact_rational(next.is_end ? 1 : 0),
                       next.is_end == (place.parameter == 1) ? -place.side : place.side};
    if (const Range other = range_with(beyond, {next.parameter(), next.parameter()}, candidates);
        roll(range, beyond, other))
      erase(beyond, other, candidates);
  }

  const Site_arc_2<>& arc() const { return m_graph.arcs()[m_element.object]; }

  bool are_places_exact() const
  {
    return !m_element.is_normal_cone && !arc().is_on_line_or_circle() && !arc().has_singular_end() &&
        m_graph.are_ends_exact(m_element.object);
  }

  // If that is where it is, by bounds and exactly.
  void add_place(const Exact_rational& parameter, const Range& range)
  {
    const Place place{m_element.object, parameter, m_element.is_reversed ? -1 : 1};
    const bool is_known =
        std::any_of(m_places.begin(), m_places.end(), [&](const Place& other) { return other.parameter == parameter; });
    if (!is_known && certain_sign(excess_of_curvature(place, arc().jet(range, 2))) == 0 && sign_of_excess(place) == 0)
      m_places.push_back(place);
  }

  // The sign of k - 1/r.
  int sign_of_excess(const Place& place) const
  {
    return sign_of(Exact_rational(
        place.side * m_graph.arcs()[place.arc].signed_square_of_curvature(place.parameter) * m_squared_radius - 1));
  }

  // k - 1/r, times r S^(3/2).
  Interval excess_of_curvature(const Place& place, const Curve_jet<>& x) const
  {
    const Interval square = squared_norm(x[1]);
    return Interval(place.side) * m_radius * dot(turned_left(x[1]), x[2]) - square * CGAL::sqrt(square);
  }

  // G and its derivative.
  static std::array<Interval, 2> slope_of_curvature(const Curve_jet<>& x)
  {
    const auto cross = [&](std::size_t i, std::size_t j) { return dot(turned_left(x[i]), x[j]); };
    const Interval square = squared_norm(x[1]), along = dot(x[1], x[2]), turn = cross(1, 2), three(3);
    return {cross(1, 3) * square - three * turn * along,
            (cross(2, 3) + cross(1, 4)) * square - cross(1, 3) * along -
                three * turn * (squared_norm(x[2]) + dot(x[1], x[3]))};
  }

  // The range of an arc from a place to what is left of it nearby.
  static Range range_with(const Place& place, Range range, const std::vector<Disk_candidate<>>& candidates)
  {
    const Interval t = interval_of<Interval>(place.parameter);
    range = united(range, {t.inf(), t.sup()});
    for (const Disk_candidate<>& c : candidates)
      if (is_near(place, c))
        range = united(range, c.range);
    return range;
  }

  static bool is_near(const Place& place, const Disk_candidate<>& c)
  {
    const Interval t = interval_of<Interval>(place.parameter);
    return c.kind == Candidate_kind::ARC && c.index == place.arc && c.range.begin > t.sup() - most_way &&
        c.range.end < t.inf() + most_way;
  }

  static void erase(const Place& place, const Range& range, std::vector<Disk_candidate<>>& candidates)
  {
    std::erase_if(candidates, [&](const Disk_candidate<>& c) {
      return is_near(place, c) && c.range.begin >= range.begin && c.range.end <= range.end;
    });
  }

  // Whether the disks that touch a part of the element roll along a range of its arc, or of one that goes on from that
  // smoothly in a place. The part is in the range, or the disks are known to roll as far as that place.
  bool roll(const Range& part, const Place& place, const Range& range) const
  {
    const Site_arc_2<>& other = m_graph.arcs()[place.arc];
    const Interval way(place.side * (m_element.is_reversed ? -1 : 1));   // whether the other arc has the same direction
    if (other.has_singular_end() || !(dot(arc().jet(part, 1)[1], way * other.jet(range, 1)[1]).inf() > 0))
      return false;
    const Curve_jet<> x = other.jet(range);
    return excess_of_curvature(place, x).sup() <= 0 ||
        (sign_of_excess(place) <= 0 && (other.is_on_line_or_circle() || is_curvature_less_beside(place, range, x)));
  }

  // Whether the curvature falls on both sides of a place, as far as the range goes.
  bool is_curvature_less_beside(const Place& place, const Range& range, const Curve_jet<>& x) const
  {
    const auto [slope, change] = slope_of_curvature(x);
    const int sign = place.side * certain_sign(slope);
    if ((sign < 0 && place.parameter == Exact_rational(range.begin)) ||
        (sign > 0 && place.parameter == Exact_rational(range.end)))
      return true;
    return place.side * certain_sign(change) < 0 &&
        m_graph.arcs()[place.arc].is_curvature_stationary_at(place.parameter);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ROLLING_DISKS_H
