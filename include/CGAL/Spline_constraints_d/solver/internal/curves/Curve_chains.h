// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_CHAINS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_CHAINS_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/union_of_boxes.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Joins pieces that share vertices to curves, and undecided boxes that touch to regions.
class Curve_chains
{
  const Exact_ranges& m_domain;
  const Curve_vertices& m_points;
  std::vector<Curve_piece> m_pieces;
  std::vector<Undecided_box> m_boxes;
  std::vector<std::vector<std::size_t>> m_pieces_at;   // per vertex
  std::vector<bool> m_is_used;                         // per piece

public:
  Curve_chains(const Exact_ranges& domain, const Curve_vertices& points, std::vector<Curve_piece> pieces,
               std::vector<Undecided_box> boxes)
    : m_domain(domain), m_points(points), m_pieces(std::move(pieces)), m_boxes(std::move(boxes)),
      m_pieces_at(points.size()), m_is_used(m_pieces.size(), false)
  {
    for (std::size_t p = 0; p < m_pieces.size(); ++p)
      for (const std::size_t end : m_pieces[p].ends)
        m_pieces_at[end].push_back(p);
  }

  // With the vertices that anything refers to.
  Curve_solution_set_d solution_set(std::vector<std::size_t> isolated_points, Summary summary)
  {
    std::vector<Undecided_region> undecided = regions();
    std::vector<Solution_curve> curves = chains();
    std::vector<std::size_t> singular_points;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points[i].is_singular_point())
        singular_points.push_back(i);

    std::vector<Curve_vertex> vertices;
    std::map<std::size_t, std::size_t> place;
    const auto renumber = [&](std::size_t& i) {
      const auto [entry, is_new] = place.try_emplace(i, vertices.size());
      if (is_new)
        vertices.push_back(
            {m_points[i].box, is_on_boundary(i), m_points[i].is_singular_point(), m_points[i].inequality.has_value()});
      i = entry->second;
    };
    for (Solution_curve& curve : curves)
      for (Curve_piece& piece : curve.pieces)
        std::for_each(piece.ends.begin(), piece.ends.end(), renumber);
    for (Undecided_region& region : undecided)
      std::for_each(region.vertices.begin(), region.vertices.end(), renumber);
    std::for_each(isolated_points.begin(), isolated_points.end(), renumber);
    std::for_each(singular_points.begin(), singular_points.end(), renumber);

    if (!undecided.empty()) {
      summary.is_complete = false;
      summary.why_not = undecided.front().reason;
    }
    return Curve_solution_set_d(std::move(vertices), std::move(curves), std::move(isolated_points),
                                std::move(singular_points), std::move(undecided), summary);
  }

private:
  bool is_on_boundary(std::size_t i) const
  {
    const Plane_point& point = m_points[i];
    for (std::size_t j = 0; j < m_domain.size(); ++j)
      if (point.is_fixed[j] && (point.box[j].first == m_domain[j].first || point.box[j].first == m_domain[j].second))
        return true;
    return false;
  }

  // A curve goes on through a vertex that two pieces share, not through a singular point, nor where a strict inequality
  // is zero.
  bool goes_on(std::size_t vertex) const
  {
    return m_pieces_at[vertex].size() == 2 && !m_points[vertex].is_excluded && !m_points[vertex].is_singular_point();
  }

  std::vector<Solution_curve> chains()
  {
    std::vector<Solution_curve> result;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (!goes_on(i))
        for (const std::size_t p : m_pieces_at[i])
          if (!m_is_used[p])
            result.push_back(chain(p, i));
    for (std::size_t p = 0; p < m_pieces.size(); ++p)
      if (!m_is_used[p])
        result.push_back(chain(p, m_pieces[p].ends[0]));
    return result;
  }

  Solution_curve chain(std::size_t piece, std::size_t vertex)
  {
    const std::size_t first = vertex;
    Solution_curve result{{}, false};
    for (;;) {
      m_is_used[piece] = true;
      result.pieces.push_back(m_pieces[piece]);
      Curve_piece& last = result.pieces.back();
      if (last.ends[0] != vertex)
        std::swap(last.ends[0], last.ends[1]);
      vertex = last.ends[1];
      if (!goes_on(vertex))
        return result;
      const std::vector<std::size_t>& both = m_pieces_at[vertex];
      const std::size_t next = both[0] == piece ? both[1] : both[0];
      if (m_is_used[next]) {
        result.is_closed = vertex == first;
        return result;
      }
      piece = next;
    }
  }

  std::vector<Undecided_region> regions() const
  {
    std::vector<Exact_ranges> boxes;
    for (const Undecided_box& own : m_boxes)
      boxes.push_back(own.box);
    const std::vector<std::size_t> root = roots_of_touching(boxes);
    std::map<std::size_t, Undecided_region> all;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
      Undecided_region& region =
          all.try_emplace(root[i], Undecided_region{{}, {}, m_boxes[root[i]].reason}).first->second;
      region.boxes.push_back(m_boxes[i].box);
      region.vertices.insert(region.vertices.end(), m_boxes[i].vertices.begin(), m_boxes[i].vertices.end());
    }
    std::vector<Undecided_region> result;
    for (auto& [r, region] : all) {
      // Vertices between two boxes of the region are not where a curve reaches it.
      std::sort(region.vertices.begin(), region.vertices.end());
      region.vertices.erase(std::unique(region.vertices.begin(), region.vertices.end()), region.vertices.end());
      std::erase_if(region.vertices, [&](std::size_t i) { return m_pieces_at[i].empty(); });
      result.push_back(std::move(region));
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_CHAINS_H
