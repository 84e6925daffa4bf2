// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_TRIANGLE_SHELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_TRIANGLE_SHELLS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_complex.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The triangles around the edges of a complex, and the shells that they bound: connected parts of the boundaries of the
// cells that the triangles cut space into. A triangle has a shell on its side 0, where its normal points to, and one on
// its side 1.
class Triangle_shells
{
public:
  // A triangle at an edge from `ends[0]` to `ends[1]`; its side 0 is met next counterclockwise around the edge, or its
  // side 1.
  struct Leaf
  {
    std::size_t triangle;
    std::size_t opposite; // corner
    bool has_edge;        // and not the reversed one, in its boundary

    int next_side() const { return has_edge ? 0 : 1; }
    int last_side() const { return has_edge ? 1 : 0; }
  };

  struct Edge
  {
    std::array<std::size_t, 2> ends;
    std::vector<Leaf> leaves; // counterclockwise around it, seen against its direction
  };

private:
  const Triangle_complex& m_complex;
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_shell_of; // of a side of a triangle
  std::size_t m_shells = 0;
  bool m_is_closed = true;

public:
  explicit Triangle_shells(const Triangle_complex& complex) : m_complex(complex)
  {
    collect_edges();
    for (Edge& edge : m_edges)
      sort_leaves(edge);
    connect_sides();
  }

  // Whether each edge bounds an even number of triangles, counted with their multiplicities.
  bool is_closed() const { return m_is_closed; }

  std::size_t number_of_shells() const { return m_shells; }
  std::size_t shell_of(std::size_t triangle, int side) const { return m_shell_of[2 * triangle + side]; }
  const std::vector<Edge>& edges() const { return m_edges; }

private:
  void collect_edges()
  {
    struct Hash
    {
      std::size_t operator()(const std::array<std::size_t, 2>& ends) const
      {
        return ends[0] * 0x9e3779b97f4a7c15u ^ ends[1];
      }
    };
    std::unordered_map<std::array<std::size_t, 2>, std::size_t, Hash> index_of;
    for (std::size_t triangle = 0; triangle < m_complex.triangles.size(); ++triangle)
      for (int k = 0; k < 3; ++k) {
        const Corners& corners = m_complex.triangles[triangle];
        const std::size_t from = corners[k], to = corners[(k + 1) % 3];
        const std::array<std::size_t, 2> ends{(std::min)(from, to), (std::max)(from, to)};
        const auto [place, is_new] = index_of.try_emplace(ends, m_edges.size());
        if (is_new)
          m_edges.push_back({ends, {}});
        m_edges[place->second].leaves.push_back({triangle, corners[(k + 2) % 3], from == ends[0]});
      }
    for (const Edge& edge : m_edges) {
      int boundary = 0;
      for (const Leaf& leaf : edge.leaves)
        boundary += m_complex.multiplicity[leaf.triangle];
      m_is_closed = m_is_closed && boundary % 2 == 0;
    }
  }

  // By angles from the first leaf on, as exact signs. Another leaf in the plane of the first one is on the other side.
  void sort_leaves(Edge& edge) const
  {
    if (edge.leaves.size() < 3)
      return;
    const auto &p = m_complex.points[edge.ends[0]], &q = m_complex.points[edge.ends[1]];
    const auto& first = m_complex.points[edge.leaves.front().opposite];
    const auto turn = [&](const auto& from, const auto& to) { return CGAL::orientation(p, q, from, to); };
    const auto half = [&](const Leaf& leaf) { // 0: the first one; angles up to pi, pi, beyond pi
      if (leaf.opposite == edge.leaves.front().opposite)
        return 0;
      if (m_complex.planes[leaf.triangle] == m_complex.planes[edge.leaves.front().triangle])
        return 2;
      const CGAL::Sign sign = turn(first, m_complex.points[leaf.opposite]);
      return sign == CGAL::POSITIVE ? 1 : sign == CGAL::ZERO ? 2 : 3;
    };
    std::vector<std::pair<int, Leaf>> leaves;
    for (const Leaf& leaf : edge.leaves)
      leaves.emplace_back(half(leaf), leaf);
    std::sort(leaves.begin(), leaves.end(), [&](const auto& a, const auto& b) {
      if (a.first != b.first)
        return a.first < b.first;
      return a.first % 2 == 1 &&
          turn(m_complex.points[a.second.opposite], m_complex.points[b.second.opposite]) == CGAL::POSITIVE;
    });
    for (std::size_t i = 0; i < leaves.size(); ++i)
      edge.leaves[i] = leaves[i].second;
  }

  void connect_sides()
  {
    const std::size_t count = 2 * m_complex.triangles.size();
    std::vector<std::size_t> rank(count), parent(count);
    boost::disjoint_sets<std::size_t*, std::size_t*> shells(rank.data(), parent.data());
    for (std::size_t i = 0; i < count; ++i)
      shells.make_set(i);
    for (const Edge& edge : m_edges)
      for (std::size_t i = 0; i < edge.leaves.size(); ++i) {
        const Leaf &leaf = edge.leaves[i], &next = edge.leaves[(i + 1) % edge.leaves.size()];
        shells.union_set(2 * leaf.triangle + leaf.next_side(), 2 * next.triangle + next.last_side());
      }
    std::unordered_map<std::size_t, std::size_t> index_of;
    for (std::size_t i = 0; i < count; ++i)
      m_shell_of.push_back(index_of.try_emplace(shells.find_set(i), index_of.size()).first->second);
    m_shells = index_of.size();
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_TRIANGLE_SHELLS_H
