// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_CUTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_CUTS_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Cuts curves in points that are known to be solutions of the same system, by proof: where they are poles of a function,
say.

A solution in the box of a piece, with a parameter between those of its ends, belongs to the piece: there is no other
one. This is how a point finds its place; one that is too near to a vertex does not.
*/
class Curve_cuts
{
  using Box = Curve_vertex::Exact_box;

  const Curve_solution_set_d& m_set;
  std::vector<Curve_vertex> m_vertices;
  std::vector<bool> m_is_cut;   // per vertex

public:
  explicit Curve_cuts(const Curve_solution_set_d& set)
    : m_set(set), m_vertices(set.vertices()), m_is_cut(m_vertices.size(), false)
  {}

  // The curves between the points; the points that were not placed are appended to `rest`.
  Curve_solution_set_d operator()(const std::vector<Box>& points, std::vector<Box>& rest)
  {
    std::vector<bool> is_placed(points.size(), false);
    std::vector<Solution_curve> curves;
    for (Solution_curve curve : m_set.curves()) {
      curve.pieces = cut_pieces(curve.pieces, points, is_placed);
      if (curve.is_closed)
        start_at_cut(curve);
      append_parts(curve, curves);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_placed[i])
        rest.push_back(points[i]);
    return Curve_solution_set_d(std::move(m_vertices), std::move(curves), m_set.points(), m_set.singular_points(),
                                m_set.undecided_regions(), m_set.summary());
  }

private:
  std::vector<Curve_piece> cut_pieces(const std::vector<Curve_piece>& pieces, const std::vector<Box>& points,
                                      std::vector<bool>& is_placed)
  {
    std::vector<Curve_piece> result;
    for (const Curve_piece& piece : pieces) {
      std::vector<std::size_t> cuts;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (!is_placed[i] && holds(piece, points[i])) {
          is_placed[i] = true;
          cuts.push_back(m_vertices.size());
          m_vertices.push_back({points[i], false, false, true});
          m_is_cut.push_back(true);
        }
      const auto place = [&](std::size_t i) { return m_vertices[i].box[piece.parameter].first; };
      std::sort(cuts.begin(), cuts.end(), [&](std::size_t i, std::size_t k) { return place(i) < place(k); });
      if (!cuts.empty() && place(piece.ends[1]) < place(piece.ends[0]))
        std::reverse(cuts.begin(), cuts.end());
      cuts.push_back(piece.ends[1]);
      std::size_t begin = piece.ends[0];
      for (const std::size_t end : cuts)
        result.push_back({piece.box, piece.parameter, {std::exchange(begin, end), end}});
    }
    return result;
  }

  bool holds(const Curve_piece& piece, const Box& point) const
  {
    if (piece.parameter < 0)
      return false;
    for (std::size_t j = 0; j < point.size(); ++j)
      if (point[j].first < piece.box[j].first || piece.box[j].second < point[j].second)
        return false;
    const auto range = [&](std::size_t i) { return m_vertices[i].box[piece.parameter]; };
    auto [first, last] = std::pair(range(piece.ends[0]), range(piece.ends[1]));
    if (last.first < first.first)
      std::swap(first, last);
    return first.second < point[piece.parameter].first && point[piece.parameter].second < last.first;
  }

  void start_at_cut(Solution_curve& curve) const
  {
    const auto first = std::find_if(curve.pieces.begin(), curve.pieces.end(),
                                    [&](const Curve_piece& piece) { return m_is_cut[piece.ends[0]]; });
    curve.is_closed = first == curve.pieces.end();
    if (!curve.is_closed)
      std::rotate(curve.pieces.begin(), first, curve.pieces.end());
  }

  void append_parts(const Solution_curve& curve, std::vector<Solution_curve>& curves) const
  {
    std::vector<Curve_piece> part;
    for (std::size_t p = 0; p < curve.pieces.size(); ++p) {
      part.push_back(curve.pieces[p]);
      if (p + 1 == curve.pieces.size() || m_is_cut[part.back().ends[1]])
        curves.push_back({std::exchange(part, {}), curve.is_closed});
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_CUTS_H
