// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_MESH_JOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_MESH_JOINTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
Joins a mesh to itself along boundary curves that are the same curve in space, by the equations: those on two faces of
the domain, or two on a face that is one point at a time. Each side has its own vertices on the curve. They are put into
one order along it; a vertex of the second side moves along the curve to one of the first that is near, and all others
are put into the edges of the other side. Nothing is joined but vertices with the same place in this order.
*/
class Mesh_joints
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;

  Solution_surface_mesh& m_result;
  Mesh& m_mesh;
  std::vector<std::size_t> m_same; // by vertex, one that is joined to it

public:
  // A boundary curve: the vertices in the order of its halfedges, the first one again at the end if it is closed.
  using Chain = std::vector<Vertex>;

  explicit Mesh_joints(Solution_surface_mesh& result) : m_result(result), m_mesh(result.mesh) { forget(); }

  // Those on a face of the domain.
  std::vector<Chain> chains_on(int unknown, double value) const
  {
    const auto is_on_face = [&](Vertex v) { return m_result.unknowns[v][static_cast<std::size_t>(unknown)] == value; };
    std::map<Vertex, Vertex> next;
    std::map<Vertex, bool> has_previous;
    for (const Halfedge h : m_mesh.halfedges())
      if (m_mesh.is_border(h) && is_on_face(m_mesh.source(h)) && is_on_face(m_mesh.target(h))) {
        next[m_mesh.source(h)] = m_mesh.target(h);
        has_previous[m_mesh.target(h)] = true;
      }
    std::vector<Chain> result;
    const auto follow = [&](Vertex start) {
      Chain chain{start};
      for (auto step = next.find(start); step != next.end(); step = next.find(chain.back())) {
        chain.push_back(step->second);
        next.erase(step);
      }
      result.push_back(std::move(chain));
    };
    std::vector<Vertex> starts;
    for (const auto& [from, to] : next)
      if (!has_previous.contains(from))
        starts.push_back(from);
    for (const Vertex start : starts)
      follow(start);
    while (!next.empty())
      follow(next.begin()->first);
    return result;
  }

  // The chains of a face with those of another one, which are followed the other way. Whether each has found its own.
  bool join(std::vector<Chain> first, std::vector<Chain> second)
  {
    for (const Chain& own : first) {
      const auto other = nearest_to(own, second);
      if (other == second.end() || !zip(own, *other))
        return false;
      second.erase(other);
    }
    if (!second.empty())
      return false;
    rebuild();
    return true;
  }

  // The chains of a face in pairs.
  bool join_pairs(std::vector<Chain> chains)
  {
    while (!chains.empty()) {
      const Chain own = std::move(chains.back());
      chains.pop_back();
      const auto other = nearest_to(own, chains);
      if (other == chains.end() || !zip(own, *other))
        return false;
      chains.erase(other);
    }
    rebuild();
    return true;
  }

  // Each chain becomes one vertex. Before, edges to it are flipped where others would become the same ones.
  void contract(const std::vector<Chain>& chains)
  {
    for (const Chain& chain : chains) {
      const std::set<Vertex> vertices(chain.begin(), chain.end());
      constexpr int most_rounds = 16;
      for (int round = 0; round < most_rounds && flip_surplus_edges(vertices); ++round) {
      }
      for (const Vertex v : chain)
        m_same[v] = chain.front();
    }
    rebuild();
  }

private:
  void forget()
  {
    m_same.resize(m_mesh.num_vertices());
    std::iota(m_same.begin(), m_same.end(), 0);
  }

  // A vertex beside a chain has edges to vertices in a row on it, or they are flipped but for one row. Tells whether
  // some were.
  bool flip_surplus_edges(const std::set<Vertex>& chain)
  {
    std::set<Vertex> beside;
    for (const Vertex v : chain)
      for (const Vertex w : m_mesh.vertices_around_target(m_mesh.halfedge(v)))
        if (!chain.contains(w))
          beside.insert(w);
    bool result = false;
    for (const Vertex w : beside) {
      std::vector<std::vector<Halfedge>> rows = rows_of_edges(w, chain);
      const auto rank = [&](const std::vector<Halfedge>& row) { // features stay
        const auto features = std::count_if(row.begin(), row.end(),
                                            [&](Halfedge h) { return bool(m_result.is_feature[m_mesh.edge(h)]); });
        return std::pair(features, row.size());
      };
      std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return rank(b) < rank(a); });
      for (std::size_t k = 1; k < rows.size(); ++k)
        for (const Halfedge h : rows[k])
          result = flip(h) || result;
    }
    return result;
  }

  // The halfedges from a vertex to those of a chain, in the rows that others separate.
  std::vector<std::vector<Halfedge>> rows_of_edges(Vertex from, const std::set<Vertex>& chain) const
  {
    std::vector<Halfedge> around;
    for (const Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(from)))
      around.push_back(m_mesh.opposite(h));
    const auto is_on_chain = [&](Halfedge h) { return chain.contains(m_mesh.target(h)); };
    const auto start = std::find_if_not(around.begin(), around.end(), is_on_chain);
    if (start == around.end())
      return {around};
    std::rotate(around.begin(), start, around.end());
    std::vector<std::vector<Halfedge>> rows;
    bool is_in_row = false;
    for (const Halfedge h : around) {
      if (is_on_chain(h) && !is_in_row)
        rows.emplace_back();
      is_in_row = is_on_chain(h);
      if (is_in_row)
        rows.back().push_back(h);
    }
    return rows;
  }

  // Flips an edge inside, unless it is a feature or there is one between the other two vertices.
  bool flip(Halfedge h)
  {
    const Halfedge other = m_mesh.opposite(h);
    if (m_mesh.is_border(h) || m_mesh.is_border(other) || m_result.is_feature[m_mesh.edge(h)])
      return false;
    const Vertex a = m_mesh.target(m_mesh.next(h)), b = m_mesh.target(m_mesh.next(other));
    if (a == b || m_mesh.halfedge(a, b) != Mesh::null_halfedge())
      return false;
    CGAL::Euler::flip_edge(h, m_mesh);
    return true;
  }

  double squared_distance(Vertex a, Vertex b) const { return CGAL::squared_distance(m_mesh.point(a), m_mesh.point(b)); }

  static bool is_closed(const Chain& chain) { return chain.front() == chain.back(); }

  // The one that begins where this one ends and the other way around, or passes closest to the start of a closed one.
  std::vector<Chain>::iterator nearest_to(const Chain& own, std::vector<Chain>& others) const
  {
    auto result = others.end();
    double least = std::numeric_limits<double>::infinity();
    for (auto other = others.begin(); other != others.end(); ++other) {
      if (is_closed(own) != is_closed(*other))
        continue;
      double distance = std::numeric_limits<double>::infinity();
      if (is_closed(own))
        for (const Vertex v : *other)
          distance = (std::min)(distance, squared_distance(own.front(), v));
      else
        distance = squared_distance(own.front(), other->back()) + squared_distance(own.back(), other->front());
      if (distance < least) {
        least = distance;
        result = other;
      }
    }
    return result;
  }

  // A vertex on each side of a curve; a null one is still to be made.
  using Node = std::array<Vertex, 2>;

  // Whether both chains are along the same curve.
  bool zip(const Chain& first, Chain second)
  {
    std::reverse(second.begin(), second.end());
    if (is_closed(first)) {
      second.pop_back();
      const auto nearest = std::min_element(second.begin(), second.end(), [&](Vertex a, Vertex b) {
        return squared_distance(first.front(), a) < squared_distance(first.front(), b);
      });
      std::rotate(second.begin(), nearest, second.end());
      second.push_back(second.front());
    }
    const auto places = places_along(first, second);
    if (!places)
      return false;
    std::vector<Node> nodes = in_order(first, second, *places);
    complete(nodes, 0);
    complete(nodes, 1);
    for (const Node& node : nodes) {
      copy(node[0], node[1]);
      m_same[node[1]] = m_same[node[0]];
    }
    return true;
  }

  // Of the vertices of the first chain, the index of a vertex of the second one plus the share of its edge before them.
  std::optional<std::vector<double>> places_along(const Chain& first, const Chain& second) const
  {
    std::vector<double> result{0};
    std::size_t edge = 0;
    for (std::size_t k = 1; k + 1 < first.size(); ++k) {
      auto [share, distance] = projection(first[k], second[edge], second[edge + 1]);
      while (edge + 2 < second.size()) {
        const auto [next_share, next_distance] = projection(first[k], second[edge + 1], second[edge + 2]);
        if (next_distance > distance)
          break;
        ++edge;
        share = next_share;
        distance = next_distance;
      }
      if (distance > squared_distance(second[edge], second[edge + 1]) &&
          distance > squared_distance(first[k - 1], first[k]))
        return std::nullopt; // they run apart
      result.push_back((std::max)(result.back(), static_cast<double>(edge) + share));
    }
    result.push_back(static_cast<double>(second.size() - 1));
    return result;
  }

  // Of a point on a segment: the share of the segment before it, and the squared distance.
  std::pair<double, double> projection(Vertex v, Vertex from, Vertex to) const
  {
    const auto along = m_mesh.point(to) - m_mesh.point(from), own = m_mesh.point(v) - m_mesh.point(from);
    const double length = along.squared_length(), share = length > 0 ? std::clamp(along * own / length, 0.0, 1.0) : 0.0;
    return {share, (own - share * along).squared_length()};
  }

  // Both chains merged: ends are pairs, and so are vertices that are near; the others are alone.
  static std::vector<Node> in_order(const Chain& first, const Chain& second, const std::vector<double>& places)
  {
    constexpr double near = 0.4;
    const std::size_t last = second.size() - 1;
    std::vector<Node> result{{first.front(), second.front()}};
    std::size_t taken = 1; // vertices of the second chain that are in the result
    std::vector<std::size_t> alone;
    const auto flush = [&](std::size_t until) { // up to a vertex of the second chain
      for (const std::size_t k : alone) {
        for (; taken < until && static_cast<double>(taken) < places[k]; ++taken)
          result.push_back({Mesh::null_vertex(), second[taken]});
        result.push_back({first[k], Mesh::null_vertex()});
      }
      for (; taken < until; ++taken)
        result.push_back({Mesh::null_vertex(), second[taken]});
      alone.clear();
    };
    for (std::size_t k = 1; k + 1 < first.size(); ++k) {
      const auto nearest = static_cast<std::size_t>(places[k] + 0.5);
      if (nearest >= taken && nearest < last && std::abs(places[k] - static_cast<double>(nearest)) < near) {
        flush(nearest);
        result.push_back({first[k], second[nearest]});
        taken = nearest + 1;
      } else
        alone.push_back(k);
    }
    flush(last);
    result.push_back({first.back(), second.back()});
    return result;
  }

  // Makes the vertices that a side lacks, in its edges.
  void complete(std::vector<Node>& nodes, std::size_t side)
  {
    Vertex before = nodes.front()[side];
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      Vertex& own = nodes[i][side];
      if (own == Mesh::null_vertex()) {
        std::size_t k = i;
        while (nodes[k][side] == Mesh::null_vertex())
          ++k;
        own = split(before, nodes[k][side], nodes[i][1 - side]);
      }
      before = own;
    }
  }

  // A vertex on a boundary edge, with the place of another one.
  Vertex split(Vertex from, Vertex to, Vertex place)
  {
    Halfedge inside = m_mesh.halfedge(from, to);
    if (m_mesh.is_border(inside))
      inside = m_mesh.opposite(inside);
    const std::size_t surface = m_result.surface[m_mesh.face(inside)];
    const bool is_feature = m_result.is_feature[m_mesh.edge(inside)];
    const Halfedge begin = CGAL::Euler::split_edge(inside, m_mesh);
    const Vertex result = m_mesh.target(begin);
    const Halfedge diagonal = CGAL::Euler::split_face(begin, m_mesh.next(inside), m_mesh);
    for (const Halfedge h : {diagonal, m_mesh.opposite(diagonal)})
      m_result.surface[m_mesh.face(h)] = surface;
    m_result.is_feature[m_mesh.edge(begin)] = m_result.is_feature[m_mesh.edge(inside)] = is_feature;
    m_result.is_feature[m_mesh.edge(diagonal)] = false;
    copy(place, result);
    m_same.push_back(m_same.size());
    return result;
  }

  void copy(Vertex from, Vertex to)
  {
    m_mesh.point(to) = m_mesh.point(from);
    m_result.unknowns[to] = std::vector<double>(m_result.unknowns[from]);
    m_result.differentials[to] = Surface_differentials_3(m_result.differentials[from]);
  }

  Vertex representative(Vertex v) const
  {
    std::size_t result = v;
    while (m_same[result] != result)
      result = m_same[result];
    return Vertex(static_cast<Mesh::size_type>(result));
  }

  // With one vertex for those that are joined. What was a feature only as a part of the boundary is none inside.
  void rebuild()
  {
    Solution_surface_mesh joined;
    std::vector<Vertex> copies(m_mesh.num_vertices(), Mesh::null_vertex());
    const auto vertex = [&](Vertex v) {
      const Vertex own = representative(v);
      if (copies[own] == Mesh::null_vertex()) {
        copies[own] = joined.mesh.add_vertex(m_mesh.point(own));
        joined.unknowns[copies[own]] = m_result.unknowns[own];
        joined.differentials[copies[own]] = m_result.differentials[own];
      }
      return copies[own];
    };
    for (const auto f : m_mesh.faces()) {
      std::vector<Vertex> corners;
      for (const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
        corners.push_back(vertex(v));
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        continue;
      const auto face = joined.mesh.add_face(corners);
      if (face != Mesh::null_face())
        joined.surface[face] = m_result.surface[f];
      else
        joined.undecided_parts.push_back({{}, {}, "triangles that do not join others"});
    }
    for (const auto e : m_mesh.edges()) {
      const Halfedge h = m_mesh.halfedge(e);
      const Vertex from = copies[representative(m_mesh.source(h))], to = copies[representative(m_mesh.target(h))];
      if (!m_result.is_feature[e] || from == to || from == Mesh::null_vertex() || to == Mesh::null_vertex())
        continue;
      const Halfedge own = joined.mesh.halfedge(from, to);
      if (own != Mesh::null_halfedge())
        joined.is_feature[joined.mesh.edge(own)] = !m_mesh.is_border(e) || joined.mesh.is_border(joined.mesh.edge(own));
    }
    joined.error = m_result.error;
    joined.work = m_result.work;
    joined.undecided_parts.insert(joined.undecided_parts.begin(), m_result.undecided_parts.begin(),
                                  m_result.undecided_parts.end());
    m_result = std::move(joined);
    forget();
  }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_MESH_JOINTS_H
