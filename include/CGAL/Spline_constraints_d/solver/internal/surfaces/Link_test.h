// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LINK_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LINK_TEST_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_store.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_crossings.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_point.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Space_equation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Proves that the surface in a box within the region of a cone point p inside it is the cone with apex p over the curves
on the boundary of the box, all of which are regular.

It is if everywhere on the surface but in p a tangent vector exists along which phi decreases, and which at the boundary
leads into the box: its flow takes all points to p, each along a line that begins on the boundary. Inside that is so as
phi has no critical point. On a face with the outward normal n there is no such vector only where
grad phi = a grad f + b n with b <= 0, on an edge only where grad phi = a grad f + b n + c m with b <= 0 and c <= 0
(Gordan's theorem).

Faces of the domain through p may cross the cone (see Quadratic_cone_test). There the flow stays on the face, and the
lines begin on the others; so where such a face with the normal N meets another one, c must be positive in
grad phi = a grad f + b N + c n.
*/
class Link_test
{
  const Cone_point& m_point;
  const Space_equation& m_space;
  Exact_ranges m_box;                  // in space
  std::vector<Domain_face> m_crossing; // that cross the cone

  using Ends = std::array<std::array<double, 2>, 3>; // of a box, in the differences

public:
  // A box over which the other unknowns are a graph.
  Link_test(const Cone_point& point, const Space_equation& space, const Exact_ranges& box,
            std::vector<Domain_face> crossing)
    : m_point(point), m_space(space), m_box(space.part_of(box)), m_crossing(std::move(crossing))
  {}

  // `arcs`: all curves on the boundary.
  bool operator()(const Arc_store& store, const Arc_indices& arcs) const
  {
    const Upward_rounding_guard guard;
    return std::all_of(arcs.begin(), arcs.end(), [&](std::size_t a) {
      const Stored_arc& arc = store.arcs()[a];
      return std::any_of(m_crossing.begin(), m_crossing.end(),
                         [&](const Domain_face& face) { return face.has(arc); }) ||
          (arc.parameter >= 0 && is_regular(store.vertex(arc.ends[0])) && is_regular(store.vertex(arc.ends[1])) &&
           is_good_arc(arc, store));
    });
  }

private:
  // On which side of the box a value is: -1, 1, or 0 between.
  int side(std::size_t j, const Exact_rational& value) const
  {
    return value == m_box[j].first ? -1 : value == m_box[j].second ? 1 : 0;
  }

  // Inside a face, or good on an edge. Corners are not looked at.
  bool is_regular(const Plane_point& vertex) const
  {
    if (vertex.kind != Plane_point::REGULAR || vertex.is_singular)
      return false;
    const Exact_ranges box = m_space.part_of(vertex.box);
    std::vector<std::size_t> faces, others;
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_fixed = vertex.is_fixed[static_cast<std::size_t>(m_space.unknowns()[j])];
      (is_fixed && side(j, box[j].first) != 0 ? faces : others).push_back(j);
    }
    for (const Domain_face& face : m_crossing)
      if (face.has(vertex))
        return is_regular_on(face.unknown, box, faces);
    if (faces.size() != 2)
      return faces.size() == 1;
    const Interval_box place = m_point.difference(box), own = m_point.equation(place).gradient,
                       slope = m_point.slope(place);
    if (contains_zero(own[others[0]]))
      return false;
    const Interval factor = slope[others[0]] / own[others[0]];
    return std::any_of(faces.begin(), faces.end(),
                       [&](std::size_t j) { return is_outward(slope[j] - factor * own[j], side(j, box[j].first)); });
  }

  // On a face that crosses the cone, and one other.
  bool is_regular_on(int unknown, const Exact_ranges& box, std::vector<std::size_t> faces) const
  {
    if (const std::optional<std::size_t> own = m_space.place_of(unknown))
      faces.erase(std::remove(faces.begin(), faces.end(), *own), faces.end());
    if (faces.size() != 1)
      return false;
    const Interval_box place = m_point.difference(box), normal = m_space.gradient_of(unknown, box),
                       own = m_point.equation(place).gradient, slope = m_point.slope(place);
    Interval_box other{Interval(0), Interval(0), Interval(0)};
    other[faces[0]] = Interval(1);
    const Interval below = determinant(other, own, normal);
    return !contains_zero(below) &&
        is_outward(determinant(slope, own, normal) / below, side(faces[0], box[faces[0]].first));
  }

  static Interval determinant(const Interval_box& a, const Interval_box& b, const Interval_box& c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  static bool is_outward(const Interval& x, int side) { return side > 0 ? x.inf() > 0 : x.sup() < 0; }

  bool is_good_arc(const Stored_arc& arc, const Arc_store& store) const
  {
    constexpr int most_parts = 1000;
    const std::optional<std::size_t> face = m_space.place_of(arc.plane);
    const int side_of_box = face ? side(*face, m_space.part_of(arc.box())[*face].first) : 0;
    if (side_of_box == 0)
      return false;
    std::vector<Ends> parts{ends_of(arc, store)};
    for (int looked_at = 0; !parts.empty(); ++looked_at) {
      if (looked_at == most_parts)
        return false;
      const Ends part = parts.back();
      parts.pop_back();
      if (!is_good(part, *face, side_of_box))
        split(part, *face, parts);
    }
    return true;
  }

  // The box around an arc.
  Ends ends_of(const Stored_arc& arc, const Arc_store& store) const
  {
    Exact_ranges box = m_space.part_of(arc.box());
    for (std::size_t j = 0; j < 3; ++j)
      box[j] = {(std::max)(box[j].first, m_box[j].first), (std::min)(box[j].second, m_box[j].second)};
    if (const std::optional<std::size_t> j = m_space.place_of(arc.parameter)) {
      const std::size_t unknown = static_cast<std::size_t>(arc.parameter);
      const auto &first = store.vertex(arc.ends[0]).box[unknown], &last = store.vertex(arc.ends[1]).box[unknown];
      box[*j] = {(std::max)(box[*j].first, (std::min)(first.first, last.first)),
                 (std::min)(box[*j].second, (std::max)(first.second, last.second))};
    }
    const Interval_box differences = m_point.difference(box);
    Ends result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = {differences[k].inf(), differences[k].sup()};
    return result;
  }

  // Whether there is no bad point in a part of a face.
  bool is_good(const Ends& part, std::size_t face, int side_of_box) const
  {
    const Interval_box place{Interval(part[0][0], part[0][1]), Interval(part[1][0], part[1][1]),
                             Interval(part[2][0], part[2][1])};
    const Interval_polynomial::Value own = m_point.equation(place);
    if (!contains_zero(own.value))
      return true;
    const Interval_box& gradient = own.gradient;
    const Interval_box slope = m_point.slope(place);
    const std::size_t first = face == 0 ? 1 : 0, second = 3 - face - first;
    if (!contains_zero(gradient[first] * slope[second] - gradient[second] * slope[first]))
      return true;
    const std::array<std::size_t, 2> along{first, second};
    return std::any_of(along.begin(), along.end(), [&](std::size_t j) {
      return !contains_zero(gradient[j]) &&
          is_outward(slope[face] - slope[j] / gradient[j] * gradient[face], side_of_box);
    });
  }

  static void split(const Ends& part, std::size_t face, std::vector<Ends>& parts)
  {
    const std::size_t first = face == 0 ? 1 : 0, second = 3 - face - first;
    const std::size_t axis = part[first][1] - part[first][0] < part[second][1] - part[second][0] ? second : first;
    Ends lower = part, upper = part;
    lower[axis][1] = upper[axis][0] = 0.5 * part[axis][0] + 0.5 * part[axis][1];
    parts.push_back(lower);
    parts.push_back(upper);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LINK_TEST_H
