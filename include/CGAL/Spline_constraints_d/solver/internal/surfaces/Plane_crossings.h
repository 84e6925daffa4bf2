// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_PLANE_CROSSINGS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_PLANE_CROSSINGS_H

#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_store.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Space_equation.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What is found on a plane: arcs and their ends, and which of these cut arcs around.
struct Plane_arcs
{
  std::vector<Plane_point> points = {};
  std::vector<Curve_piece> pieces = {}; // on the plane
  Arc_store::Cuts cuts = {};
};

// A point of a plane in the plane.
inline Plane_point without_axis(Plane_point point, int axis)
{
  for (Exact_ranges* ranges : {&point.box, &point.region})
    ranges->erase(ranges->begin() + axis);
  point.is_fixed.erase(point.is_fixed.begin() + axis);
  return point;
}

// Where a plane meets arcs: on each face of a box that has arcs which may reach it, and on edges of the domain.
class Plane_crossings
{
  const Arc_store& m_store;
  const Arc_indices& m_arcs;
  const int m_axis;
  const Exact_rational& m_value;

public:
  Plane_crossings(const Arc_store& store, const Arc_indices& arcs, int axis, const Exact_rational& value)
    : m_store(store), m_arcs(arcs), m_axis(axis), m_value(value)
  {}

  // No end of an arc may be on the plane.
  bool are_ends_beside() const
  {
    for (const std::size_t a : m_arcs)
      for (const std::size_t i : m_store.arcs()[a].ends) {
        const auto& [lower, upper] = m_store.vertex(i).box[m_axis];
        if (lower <= m_value && m_value <= upper)
          return false;
      }
    return true;
  }

  // Whether the plane may meet an arc on an edge of the domain.
  bool meet_edges() const
  {
    return std::any_of(m_arcs.begin(), m_arcs.end(), [&](std::size_t a) { return meets_edge(m_store.arcs()[a]); });
  }

  // Where it does: the only points of the edges where their parameter has its value there, by `add_point(point)`. False
  // if the plane fixes another unknown.
  template <std::invocable<const Plane_point&> Add_point>
  bool find_on_edges(const Space_equation& space, const Add_point& add_point, Plane_arcs& found) const
  {
    for (const std::size_t a : m_arcs) {
      const Stored_arc& arc = m_store.arcs()[a];
      if (!meets_edge(arc))
        continue;
      if (arc.parameter != m_axis)
        return false;
      Exact_ranges place = space.part_of(arc.box());
      place[*space.place_of(m_axis)] = {m_value, m_value};
      place = space.with_values(place);
      std::vector<bool> is_fixed(place.size(), false);
      for (const int j : space.unknowns())
        is_fixed[static_cast<std::size_t>(j)] = true;
      found.cuts[a].push_back(found.points.size());
      add_point(Plane_point{Plane_point::REGULAR, place, place, std::move(is_fixed)});
    }
    return true;
  }

  // All solutions on the plane and a face, each on just one of the arcs there. `add_points(face, place)` adds those on
  // a face, or is not certain.
  template <std::predicate<int, const Exact_rational&> Add_points>
  bool find_on_faces(const Add_points& add_points, Plane_arcs& found) const
  {
    std::set<std::pair<int, Exact_rational>> faces;
    for (const std::size_t a : m_arcs) {
      const Stored_arc& arc = m_store.arcs()[a];
      if (!arc.is_on_edge && may_meet(arc))
        faces.emplace(arc.plane, arc.box()[arc.plane].first);
    }
    for (const auto& [face, place] : faces) {
      const std::size_t before = found.points.size();
      if (face == m_axis || !add_points(face, place))
        return false;
      for (std::size_t i = before; i < found.points.size(); ++i) {
        if (found.points[i].planes() != 2)
          return false;
        const std::optional<std::size_t> arc = m_store.arc_of(found.points[i], face, m_arcs);
        if (!arc)
          return false;
        found.cuts[*arc].push_back(i);
      }
    }
    return are_sides_consistent(found.cuts);
  }

private:
  bool may_meet(const Stored_arc& arc) const
  {
    return arc.box()[m_axis].first <= m_value && m_value <= arc.box()[m_axis].second;
  }

  bool meets_edge(const Stored_arc& arc) const
  {
    return arc.is_on_edge && (arc.parameter == m_axis ? has_ends_on_both_sides(arc) : may_meet(arc));
  }

  bool is_above(std::size_t vertex) const { return m_value < m_store.vertex(vertex).box[m_axis].first; }

  bool has_ends_on_both_sides(const Stored_arc& arc) const { return is_above(arc.ends[0]) != is_above(arc.ends[1]); }

  // An arc crosses the plane at each of its points there.
  bool are_sides_consistent(const Arc_store::Cuts& cuts) const
  {
    return std::all_of(m_arcs.begin(), m_arcs.end(), [&](std::size_t a) {
      const auto own = cuts.find(a);
      const std::size_t count = own == cuts.end() ? 0 : own->second.size();
      return has_ends_on_both_sides(m_store.arcs()[a]) == (count % 2 == 1);
    });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_PLANE_CROSSINGS_H
