// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_EDGE_DIRECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_EDGE_DIRECTIONS_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Mesh_charts.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Surface_projection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The directions of edges in their ends. Those on boundaries and features are what they are; all others divide the angles
between these evenly, so that charts have angles there that are far from reflex ones: 120 degrees as a rule. Angles are
those in the plane of two tangents, which has the order of the edges, and no metric that would matter.
*/
class Edge_directions
{
  using Coordinates = Surface_projection::Coordinates;
  using Vertex = Mesh_charts::Vertex;

  // An edge at a vertex, with the angle of its first chords, and that which it should have.
  struct Entry
  {
    std::size_t edge, end;
    bool is_fixed;
    double angle, aim;
  };

  std::vector<std::array<std::optional<Coordinates>, 2>> m_directions;

public:
  // `look_near` prepares the projection for an edge.
  template <class Look_near>
  Edge_directions(const Mesh_charts& charts, const Chart_network& network, Surface_projection& projection,
                  const Look_near& look_near)
    : m_directions(network.edges().size())
  {
    std::map<Vertex, std::vector<Entry>> at;
    for (std::size_t e = 0; e < network.edges().size(); ++e)
      for (const std::size_t end : {0, 1}) {
        const std::vector<Vertex>& vertices = network.edges()[e].vertices;
        at[end == 0 ? vertices.front() : vertices.back()].push_back({e, end, network.edges()[e].is_feature, 0, 0});
      }
    for (auto& [v, entries] : at) {
      look_near(network.edges()[entries.front().edge]);
      const Eigen::MatrixXd tangents = projection.tangents(charts.points()[v]);
      for (Entry& entry : entries)
        entry.angle = projection.angle(tangents, first_chord(charts, network.edges()[entry.edge], entry.end));
      spread(entries);
      for (const Entry& entry : entries)
        if (!entry.is_fixed) {
          const Coordinates direction = std::cos(entry.aim) * tangents.row(0) + std::sin(entry.aim) * tangents.row(1);
          const double length = length_of(charts, network.edges()[entry.edge]);
          m_directions[entry.edge][entry.end] = (entry.end == 0 ? length : -length) * direction.normalized();
        }
    }
  }

  // The derivatives of an edge at its beginning and at its end, where they are free.
  const std::array<std::optional<Coordinates>, 2>& operator[](std::size_t edge) const { return m_directions[edge]; }

private:
  static Coordinates first_chord(const Mesh_charts& charts, const Chart_edge& edge, std::size_t end)
  {
    constexpr std::size_t chords = 2; // those of triangles go to and fro
    const std::size_t last = edge.vertices.size() - 1, k = (std::min)(chords, last);
    return end == 0 ? charts.points()[edge.vertices[k]] - charts.points()[edge.vertices[0]]
                    : charts.points()[edge.vertices[last - k]] - charts.points()[edge.vertices[last]];
  }

  static double length_of(const Mesh_charts& charts, const Chart_edge& edge)
  {
    double result = 0;
    for (std::size_t k = 1; k < edge.vertices.size(); ++k)
      result += (charts.points()[edge.vertices[k]] - charts.points()[edge.vertices[k - 1]]).norm();
    return result;
  }

  // Sets the angles that edges should have.
  static void spread(std::vector<Entry>& entries)
  {
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.angle < b.angle; });
    const std::size_t n = entries.size();
    const auto first = std::find_if(entries.begin(), entries.end(), [](const Entry& entry) { return entry.is_fixed; });
    if (first == entries.end())
      return spread_evenly(entries);
    std::rotate(entries.begin(), first, entries.end());
    for (std::size_t k = 0; k < n;) {
      std::size_t next = k + 1;
      while (next < n && !entries[next].is_fixed)
        ++next;
      double range = entries[next % n].angle - entries[k].angle;
      while (range <= 0)
        range += 2 * std::numbers::pi;
      for (std::size_t i = k; i < next; ++i)
        entries[i].aim = entries[k].angle + range * static_cast<double>(i - k) / static_cast<double>(next - k);
      k = next;
    }
  }

  // All around, turned so that angles change least.
  static void spread_evenly(std::vector<Entry>& entries)
  {
    const double step = 2 * std::numbers::pi / static_cast<double>(entries.size());
    double turn = 0;
    for (std::size_t k = 0; k < entries.size(); ++k)
      turn += (entries[k].angle - step * static_cast<double>(k)) / static_cast<double>(entries.size());
    for (std::size_t k = 0; k < entries.size(); ++k)
      entries[k].aim = turn + step * static_cast<double>(k);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_EDGE_DIRECTIONS_H
