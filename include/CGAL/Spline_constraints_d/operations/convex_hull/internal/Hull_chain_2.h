// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_CHAIN_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_CHAIN_2_H

#include <CGAL/Spline_constraints_d/operations/convex_hull/Hull_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_contacts_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

// Pieces that follow each other, of one or several curves.
using Hull_chain = std::vector<Hull_piece_2>;

inline Hull_chain reversed(const Hull_chain& chain)
{
  Hull_chain result;
  for (auto piece = chain.rbegin(); piece != chain.rend(); ++piece)
    result.push_back(piece->reversed());
  return result;
}

// Whether the control points turn left all along, by less than a right angle: then the pieces are convex.
inline bool is_convex(const Hull_chain& chain)
{
  std::vector<Exact_pair> sides;
  for (const Hull_piece_2& piece : chain)
    for (std::size_t i = 0; i + 1 < piece.points().size(); ++i) {
      sides.push_back(exact_difference(piece.points()[i + 1], piece.points()[i]));
      const auto turns_left_from = [&](const Exact_pair& side) {
        return exact_cross(side, sides.back()) >= 0 && exact_dot(side, sides.back()) > 0;
      };
      if (!turns_left_from(sides.front()) || (sides.size() > 1 && !turns_left_from(sides[sides.size() - 2])))
        return false;
    }
  return true;
}

inline bool has_end(const Hull_chain& chain, const Exact_pair& point)
{
  return std::any_of(chain.begin(), chain.end(),
                     [&](const Hull_piece_2& piece) { return piece.begin() == point || piece.end() == point; });
}

// A chain without pieces is a point.
inline std::vector<Exact_pair> points_of(const Hull_chain& chain, const Exact_pair& point)
{
  std::vector<Exact_pair> result;
  for (const Hull_piece_2& piece : chain)
    result.insert(result.end(), piece.points().begin(), piece.points().end());
  return chain.empty() ? std::vector<Exact_pair>{point} : result;
}

// Whether all points of the second list are further counterclockwise along a line with this normal.
inline bool have_order(const std::vector<Exact_pair>& first, const std::vector<Exact_pair>& second,
                       const Exact_pair& normal)
{
  const auto is_less = [&](const Exact_pair& a, const Exact_pair& b) {
    return exact_cross(normal, exact_difference(b, a)) > 0;
  };
  return is_less(*std::max_element(first.begin(), first.end(), is_less),
                 *std::min_element(second.begin(), second.end(), is_less));
}

inline std::vector<Hull_contact_operand> operands(const Hull_chain& chain, const Exact_pair& point)
{
  if (chain.empty())
    return {{nullptr, point}};
  std::vector<Hull_contact_operand> result;
  for (const Hull_piece_2& piece : chain)
    result.push_back({&piece, {}});
  return result;
}

inline Boundary_vertex_2 vertex_on(const Hull_piece_2& piece, const Parameter_range& local)
{
  const auto& [begin, end] = piece.curve().parameters;
  const Exact_rational first(begin + local.first * (end - begin)), second(begin + local.second * (end - begin));
  return {piece.curve().curve, std::minmax(first, second)};
}

inline void append_arcs(std::span<const Hull_piece_2> pieces, std::vector<Hull_edge_2>& edges)
{
  for (const Hull_piece_2& piece : pieces)
    edges.push_back({Hull_edge_kind::ARC, vertex_on(piece, {0, 0}), vertex_on(piece, {1, 1})});
}

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_CHAIN_2_H
