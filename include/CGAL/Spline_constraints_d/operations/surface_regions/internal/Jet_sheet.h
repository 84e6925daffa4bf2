// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_JET_SHEET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_JET_SHEET_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Interval_jet.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/surface_cells.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// How the pieces of a surface meet along a line where one parameter is constant.
enum class Joint_of_pieces : std::uint8_t
{
  EDGE,      // an end of the surface, or a crease
  POINT,     // a pole
  DIRECTION, // tangent planes agree
  DERIVATIVE // derivatives agree
};

// A surface as a tree of rectangles of its parameters with their jets, made when they are asked for.
class Jet_sheet
{
public:
  struct Node
  {
    Interval_jet jet;
    std::array<std::array<Joint_of_pieces, 2>, 2> sides; // by axis and end; DERIVATIVE inside of a piece
    std::size_t piece;
    int depth;
    bool has_second = false;
    std::array<std::array<const Node*, 2>, 2> halves{}; // along an axis

    bool has_edge(std::size_t axis, std::size_t end) const { return sides[axis][end] == Joint_of_pieces::EDGE; }

    bool has_edge() const { return has_edge(0, 0) || has_edge(0, 1) || has_edge(1, 0) || has_edge(1, 1); }
  };

private:
  std::array<std::vector<double>, 2> m_breaks;
  std::array<bool, 2> m_is_closed;                      // without a crease or another speed along the seam
  std::vector<Interval_piece> m_pieces;                 // those with the same range of the first parameter together
  std::array<std::vector<Joint_of_pieces>, 2> m_joints; // at the breaks of an axis
  std::deque<Node> m_nodes;
  std::vector<Node*> m_roots;

public:
  explicit Jet_sheet(const Spline_patch<3>& surface)
  {
    const std::vector<Surface_cell_3> cells = cells_of(surface);
    for (const std::size_t axis : {0, 1})
      for (const Exact_rational& x : surface.breaks(static_cast<int>(axis)))
        m_breaks[axis].push_back(middle_of(interval_of(x)));
    for (const Surface_cell_3& cell : cells)
      m_pieces.emplace_back(cell.coordinates, cell.domain);
    for (const std::size_t axis : {0, 1}) {
      const std::size_t pieces = m_breaks[axis].size() - 1;
      for (std::size_t i = 0; i <= pieces; ++i)
        m_joints[axis].push_back(joint(surface, cells, axis, i));
      m_is_closed[axis] = m_joints[axis].front() == Joint_of_pieces::DERIVATIVE;
    }
    for (std::size_t i = 0; i + 1 < m_breaks[0].size(); ++i)
      for (std::size_t j = 0; j + 1 < m_breaks[1].size(); ++j) {
        const std::size_t piece = m_roots.size();
        const Parameter_rectangle box{{{m_breaks[0][i], m_breaks[0][i + 1]}, {m_breaks[1][j], m_breaks[1][j + 1]}}};
        m_nodes.push_back({m_pieces[piece].jet(box, false),
                           {{{m_joints[0][i], m_joints[0][i + 1]}, {m_joints[1][j], m_joints[1][j + 1]}}},
                           piece,
                           0});
        m_roots.push_back(&m_nodes.back());
      }
  }

  const std::vector<Node*>& roots() const { return m_roots; }

  // The range of a parameter.
  std::pair<double, double> domain(std::size_t axis) const { return {m_breaks[axis].front(), m_breaks[axis].back()}; }

  double period(std::size_t axis) const
  {
    return m_is_closed[axis] ? m_breaks[axis].back() - m_breaks[axis].front() : 0;
  }

  // The jet of a node with second derivatives.
  const Interval_jet& full_jet(const Node& of)
  {
    Node& node = const_cast<Node&>(of); // one of ours
    if (!node.has_second)
      node.jet = m_pieces[node.piece].jet(node.jet.box, true);
    node.has_second = true;
    return node.jet;
  }

  // The halves of a node along an axis.
  const std::array<const Node*, 2>& halves(const Node& of, std::size_t axis)
  {
    Node& node = const_cast<Node&>(of); // one of ours
    if (node.halves[axis][0])
      return node.halves[axis];
    for (const std::size_t half : {0, 1}) {
      Node part{{}, node.sides, node.piece, node.depth + 1};
      Parameter_rectangle box = node.jet.box;
      (half == 0 ? box[axis].second : box[axis].first) = middle_of(node.jet.box[axis]);
      part.sides[axis][1 - half] = Joint_of_pieces::DERIVATIVE;
      part.jet = m_pieces[node.piece].jet(box, false);
      m_nodes.push_back(part);
      node.halves[axis][half] = &m_nodes.back();
    }
    return node.halves[axis];
  }

  // Over a rectangle that may go across breaks and the seam, as a whole; nothing if it goes beyond an end. With second
  // derivatives if all derivatives agree along the breaks in it, otherwise not.
  std::optional<Interval_jet> jet(const Parameter_rectangle& box, bool has_second) const
  {
    std::array<std::vector<Span>, 2> spans;
    for (const std::size_t axis : {0, 1})
      if (!add_spans(axis, box[axis], has_second, spans[axis]))
        return std::nullopt;
    std::optional<Interval_jet> result;
    const std::array<double, 2> middle{middle_of(box[0]), middle_of(box[1])};
    for (const Span& u : spans[0])
      for (const Span& v : spans[1]) {
        const std::size_t piece = u.piece * (m_breaks[1].size() - 1) + v.piece;
        Interval_jet own = m_pieces[piece].jet({u.range, v.range}, has_second);
        if (!result) {
          result = own;
          continue;
        }
        result->value = hull_of(result->value, own.value);
        for (std::size_t k = 0; k < 2; ++k)
          result->first[k] = hull_of(result->first[k], own.first[k]);
        for (std::size_t k = 0; has_second && k < 3; ++k)
          result->second[k] = hull_of(result->second[k], own.second[k]);
      }
    const bool is_point = box[0].first == box[0].second && box[1].first == box[1].second;
    if (spans[0].size() * spans[1].size() > 1 && !is_point)
      result->middle = jet({{{middle[0], middle[0]}, {middle[1], middle[1]}}}, false)->value;
    result->box = box;
    return result;
  }

private:
  struct Span
  {
    std::size_t piece;
    std::pair<double, double> range;
  };

  bool add_spans(std::size_t axis, const std::pair<double, double>& range, bool has_second,
                 std::vector<Span>& result) const
  {
    const std::vector<double>& breaks = m_breaks[axis];
    const double length = period(axis);
    if (range.first < breaks.front() - length || range.second > breaks.back() + length ||
        (length > 0 && range.second - range.first > length))
      return false;
    for (int turn = length > 0 ? -1 : 0; turn <= (length > 0 ? 1 : 0); ++turn)
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double shift = turn * length;
        const double begin = (std::max)(range.first - shift, breaks[i]),
                     end = (std::min)(range.second - shift, breaks[i + 1]);
        if (begin > end || (begin == end && range.first < range.second))
          continue;
        if (has_second && !result.empty() && m_joints[axis][i] != Joint_of_pieces::DERIVATIVE)
          return false;
        result.push_back({i, {begin, end}});
      }
    return !result.empty();
  }

  static Joint_of_pieces joint(const Spline_patch<3>& surface, const std::vector<Surface_cell_3>& cells,
                               std::size_t axis, std::size_t i)
  {
    const int own = static_cast<int>(axis);
    const std::vector<Exact_rational> breaks = surface.breaks(own);
    const std::size_t pieces = breaks.size() - 1, others = cells.size() / pieces;
    const bool is_end = i == 0 || i == pieces;
    if (is_end && surface.part(own, {breaks[i], breaks[i]}).is_one_point())
      return Joint_of_pieces::POINT;
    if (is_end && !surface.is_closed(own))
      return Joint_of_pieces::EDGE;
    Joint_of_pieces result = Joint_of_pieces::DERIVATIVE;
    for (std::size_t j = 0; j < others; ++j) {
      const auto cell = [&](std::size_t k) -> const Surface_cell_3& {
        return cells[axis == 0 ? k * others + j : j * pieces + k];
      };
      result = (std::min)(result, joint(cell(i == 0 ? pieces - 1 : i - 1), cell(i == pieces ? 0 : i), own));
    }
    return result;
  }

  // Of the end of one cell and the beginning of another one, with the same points.
  static Joint_of_pieces joint(const Surface_cell_3& a, const Surface_cell_3& b, int axis)
  {
    const Cell_vector before = derivative_on_side(a, axis, 1), after = derivative_on_side(b, axis, 0);
    const Cell_polynomial wa = a.coordinates[3].face(axis, 1), wb = b.coordinates[3].face(axis, 0);
    bool is_same = true;
    for (std::size_t i = 0; i < 3; ++i)
      is_same = is_same && before[i] * wb * wb == after[i] * wa * wa;
    if (is_same)
      return Joint_of_pieces::DERIVATIVE;
    const Cell_vector across = cross(before, after);
    const bool is_parallel = std::ranges::all_of(across, is_zero);
    return is_parallel && has_one_sign(dot(before, after)) && dot(before, after).bounds().first > 0
        ? Joint_of_pieces::DIRECTION
        : Joint_of_pieces::EDGE;
  }

  // w^2 times the derivative by the parameter of an axis.
  static Cell_vector derivative_on_side(const Surface_cell_3& cell, int axis, int side)
  {
    const auto& [begin, end] = cell.domain[static_cast<std::size_t>(axis)];
    const Cell_polynomial &weight = cell.coordinates[3], w = weight.face(axis, side),
                          slope = weight.derivative(axis).face(axis, side);
    Cell_vector result{w, w, w};
    for (std::size_t i = 0; i < 3; ++i) {
      const Cell_polynomial& x = cell.coordinates[i];
      result[i] =
          (x.derivative(axis).face(axis, side) * w - x.face(axis, side) * slope) * Exact_rational(1 / (end - begin));
    }
    return result;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_JET_SHEET_H
