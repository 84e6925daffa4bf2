// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_FOUND_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_FOUND_CURVES_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What is known of the curves of a system.
struct Found_curves
{
  Curve_vertices vertices;
  std::vector<Curve_piece> pieces = {};
  std::vector<Undecided_box> undecided = {};
  Vertex_indices points = {};   // that no piece ends in
  Summary summary = {};

  // Whether each vertex is one of a curve, or a solution by itself.
  std::vector<bool> solutions() const
  {
    std::vector<bool> result(vertices.size(), false);
    for (const Curve_piece& piece : pieces)
      for (const std::size_t i : piece.ends)
        result[i] = true;
    for (const std::size_t i : points)
      result[i] = true;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result[i] = result[i] || vertices[i].is_singular_point();
    return result;
  }

  // Calls change(index) for all references to vertices.
  template <class Change>
  void for_each_index(const Change& change)
  {
    for (Curve_piece& piece : pieces)
      std::for_each(piece.ends.begin(), piece.ends.end(), change);
    for (Undecided_box& box : undecided)
      std::for_each(box.vertices.begin(), box.vertices.end(), change);
    std::for_each(points.begin(), points.end(), change);
  }

  // Adds others. Returns the indices of their vertices here.
  Vertex_indices merge(Found_curves&& others)
  {
    const Vertex_indices place = vertices.merge(std::move(others.vertices), {});
    others.for_each_index([&](std::size_t& i) { i = place[i]; });
    pieces.insert(pieces.end(), others.pieces.begin(), others.pieces.end());
    undecided.insert(undecided.end(), others.undecided.begin(), others.undecided.end());
    points.insert(points.end(), others.points.begin(), others.points.end());
    summary += others.summary;
    return place;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_FOUND_CURVES_H
