// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_DIVISIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_DIVISIONS_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Found_curves.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Makes points that are known to be solutions ends of the curves that pass through them.
class Curve_divisions
{
protected:
  Found_curves& m_all;
  std::size_t m_first;         // of the pieces
  Vertex_indices m_vertices;   // that a point may be

public:
  Curve_divisions(Found_curves& all, std::size_t first, Vertex_indices vertices)
    : m_all(all), m_first(first), m_vertices(std::move(vertices))
  {}

  // Whether the vertex, a solution, is a point of the curves; it is singular then.
  bool add(std::size_t i) { return joins_vertex(i) || splits_piece(i); }

private:
  void make_singular(std::size_t i)
  {
    m_all.vertices.make_singular(i);
    std::erase(m_all.points, i);
  }

  // The point is a vertex.
  bool joins_vertex(std::size_t i)
  {
    const auto same = std::find_if(m_vertices.begin(), m_vertices.end(),
                                   [&](std::size_t k) { return is_same(m_all.vertices[i], m_all.vertices[k]); });
    if (same == m_vertices.end())
      return false;
    m_all.vertices.identify(i, *same);
    m_all.for_each_index([&](std::size_t& k) { k = k == *same ? i : k; });
    make_singular(i);
    return true;
  }

  // Both are solutions. A regular vertex is the only one in its region on its plane, or where its inequality is zero.
  static bool is_same(const Plane_point& point, const Plane_point& vertex)
  {
    const auto is_number = [](const auto& range) { return range.first == range.second; };
    if (point.box == vertex.box && std::all_of(point.box.begin(), point.box.end(), is_number))
      return true;
    if (vertex.kind != Plane_point::REGULAR || !is_within(point.box, vertex.region))
      return false;
    if (const std::optional<std::size_t> plane = vertex.first_plane())
      return point.is_fixed[*plane] && point.box[*plane] == vertex.box[*plane];
    return vertex.inequality && point.inequality == vertex.inequality;
  }

  // The point lies in a piece, which becomes two.
  bool splits_piece(std::size_t i)
  {
    const Exact_ranges& point = m_all.vertices[i].box;
    for (std::size_t p = m_first; p < m_all.pieces.size(); ++p) {
      Curve_piece& piece = m_all.pieces[p];
      if (piece.parameter < 0 || !is_within(point, piece.box))
        continue;
      const auto range = [&](std::size_t k) { return m_all.vertices[k].box[piece.parameter]; };
      auto [first, last] = std::pair(range(piece.ends[0]), range(piece.ends[1]));
      if (last.first < first.first)
        std::swap(first, last);
      if (!(first.second < point[piece.parameter].first && point[piece.parameter].second < last.first))
        continue;
      Curve_piece rest = piece;
      piece.ends[1] = rest.ends[0] = i;
      m_all.pieces.push_back(std::move(rest));
      make_singular(i);
      return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_DIVISIONS_H
