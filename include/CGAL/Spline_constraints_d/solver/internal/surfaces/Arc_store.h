// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_STORE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_STORE_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Arc_indices = std::vector<std::size_t>;

// The values of the unknowns left without one, and that one again.
inline Plane_point with_plane(Plane_point point, int axis, const Exact_rational& value)
{
  for (Exact_ranges* ranges : {&point.box, &point.region})
    ranges->insert(ranges->begin() + axis, {value, value});
  point.is_fixed.insert(point.is_fixed.begin() + axis, true);
  return point;
}

// An arc on a plane, and what it was cut into. It may be a part of an edge of the domain.
struct Stored_arc
{
  std::shared_ptr<const Exact_ranges> shared_box; // with its parts
  int plane, parameter;
  std::array<std::size_t, 2> ends;
  std::vector<std::size_t> parts = {}; // in the order from its first end; none: it was not cut
  bool is_on_edge = false;

  const Exact_ranges& box() const { return *shared_box; }
};

/*
The arcs on all planes, with the points between them. Boxes on both sides of a plane refer to the same arcs. One that is
cut on one side keeps its index, for the other side, and knows its parts.
*/
class Arc_store
{
  std::vector<std::shared_ptr<const Plane_point>> m_vertices; // shared with stores of tasks
  std::vector<Stored_arc> m_arcs;
  std::multimap<std::vector<double>, std::size_t> m_places; // of the points on several planes: near the lower ends

public:
  // Where arcs are cut, with the points in the order from their first ends.
  using Cuts = std::map<std::size_t, std::vector<std::size_t>>;

  std::size_t number_of_vertices() const { return m_vertices.size(); }
  const Plane_point& vertex(std::size_t i) const { return *m_vertices[i]; }
  const std::shared_ptr<const Plane_point>& shared_vertex(std::size_t i) const { return m_vertices[i]; }
  const std::vector<Stored_arc>& arcs() const { return m_arcs; }

  // The index of a point, the same for one with the same box on the same planes: there is just one such solution, as
  // the box was found for the system on these planes. If it comes back otherwise the arcs do not join, and the boxes
  // around are left undecided.
  std::size_t add_vertex(std::shared_ptr<const Plane_point> point)
  {
    std::vector<double> place;
    for (const auto& [lower, upper] : point->box)
      place.push_back(CGAL::to_double(lower));
    const auto [first, last] = m_places.equal_range(place);
    const auto known = std::find_if(first, last, [&](const auto& entry) {
      return vertex(entry.second).is_fixed == point->is_fixed && vertex(entry.second).box == point->box;
    });
    if (known != last)
      return known->second;
    if (point->planes() > 1)
      m_places.emplace_hint(last, std::move(place), m_vertices.size());
    return add_known_vertex(std::move(point));
  }

  std::size_t add_vertex(Plane_point point)
  {
    return add_vertex(std::make_shared<const Plane_point>(std::move(point)));
  }

  // One that is not added again.
  std::size_t add_known_vertex(std::shared_ptr<const Plane_point> point)
  {
    m_vertices.push_back(std::move(point));
    return m_vertices.size() - 1;
  }

  std::size_t add_arc(Stored_arc arc)
  {
    m_arcs.push_back(std::move(arc));
    return m_arcs.size() - 1;
  }

  std::vector<std::size_t> add_vertices(std::vector<Plane_point> points)
  {
    std::vector<std::size_t> result;
    for (Plane_point& point : points)
      result.push_back(add_vertex(std::move(point)));
    return result;
  }

  // Adds the pieces of curves on a plane, whose ends are numbered as these vertices, and returns the indices.
  Arc_indices add_arcs(const std::vector<Curve_piece>& pieces, const std::vector<std::size_t>& vertices, int axis,
                       const Exact_rational& value)
  {
    Arc_indices result;
    for (const Curve_piece& piece : pieces) {
      Exact_ranges box = piece.box;
      box.insert(box.begin() + axis, {value, value});
      const int parameter = piece.parameter + (piece.parameter >= axis ? 1 : 0); // -1 stays
      result.push_back(add_arc({std::make_shared<const Exact_ranges>(std::move(box)),
                                axis,
                                parameter,
                                {vertices[piece.ends[0]], vertices[piece.ends[1]]}}));
    }
    return result;
  }

  // The arc of some, on the plane of the point, that the point lies on; none if this is not certain of just one.
  std::optional<std::size_t> arc_of(const Plane_point& point, int plane, const Arc_indices& arcs) const
  {
    std::optional<std::size_t> result;
    for (const std::size_t a : arcs) {
      const Stored_arc& arc = m_arcs[a];
      if (arc.plane != plane || arc.parameter < 0 || arc.box()[plane] != point.box[plane] ||
          !is_within(point.box, arc.box()) || !is_between_ends(point, arc))
        continue;
      if (result)
        return std::nullopt;
      result = a;
    }
    return result;
  }

  // Whether a point of the curve that an arc is a part of certainly lies between its ends.
  bool is_between_ends(const Plane_point& point, const Stored_arc& arc) const
  {
    auto [first, last] = ends_of(arc);
    if (last.first < first.first)
      std::swap(first, last);
    return first.second < point.box[arc.parameter].first && point.box[arc.parameter].second < last.first;
  }

  // When only the parts of arcs are asked for from now on: frees the memory of one arc and one vertex.
  void free_boxes(std::size_t i)
  {
    if (i < m_arcs.size())
      m_arcs[i].shared_box.reset();
    if (i < m_vertices.size())
      m_vertices[i].reset();
  }

  // Puts the points of the cuts in order along their arcs; false when it is not certain.
  bool sort(Cuts& cuts, const std::vector<Plane_point>& points) const
  {
    for (auto& [a, own] : cuts) {
      const Stored_arc& arc = m_arcs[a];
      const auto place = [&](std::size_t i) { return points[i].box[arc.parameter]; };
      std::sort(own.begin(), own.end(), [&](std::size_t i, std::size_t k) { return place(i).first < place(k).first; });
      for (std::size_t k = 1; k < own.size(); ++k)
        if (!(place(own[k - 1]).second < place(own[k]).first))
          return false;
      if (const auto [first, last] = ends_of(arc); last.first < first.first)
        std::reverse(own.begin(), own.end());
    }
    return true;
  }

  // Cuts an arc at vertices in this order, and returns the parts.
  const Arc_indices& cut(std::size_t arc, const std::vector<std::size_t>& vertices)
  {
    std::size_t begin = m_arcs[arc].ends[0];
    Arc_indices parts;
    for (std::size_t k = 0; k <= vertices.size(); ++k) {
      const std::size_t end = k < vertices.size() ? vertices[k] : m_arcs[arc].ends[1];
      Stored_arc part = m_arcs[arc];
      part.ends = {std::exchange(begin, end), end};
      part.parts.clear();
      parts.push_back(m_arcs.size());
      m_arcs.push_back(std::move(part));
    }
    m_arcs[arc].parts = std::move(parts);
    return m_arcs[arc].parts;
  }

  // The parts of arcs that were not cut, those of each arc in order.
  Arc_indices parts_of(const Arc_indices& arcs) const
  {
    Arc_indices result;
    for (const std::size_t a : arcs)
      append_parts(a, result);
    return result;
  }

private:
  void append_parts(std::size_t arc, Arc_indices& result) const
  {
    if (m_arcs[arc].parts.empty())
      result.push_back(arc);
    for (const std::size_t part : m_arcs[arc].parts)
      append_parts(part, result);
  }

  std::pair<Exact_ranges::value_type, Exact_ranges::value_type> ends_of(const Stored_arc& arc) const
  {
    return {vertex(arc.ends[0]).box[arc.parameter], vertex(arc.ends[1]).box[arc.parameter]};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_STORE_H
