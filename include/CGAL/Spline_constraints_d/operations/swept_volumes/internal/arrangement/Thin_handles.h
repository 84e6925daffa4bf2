// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_THIN_HANDLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_THIN_HANDLES_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Boundary_of_cells.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Short_loops.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

/*
Closes handles of a boundary that are thinner than the chord error where they are proved to be wrong. Over a short loop
of the boundary, the cone from its center is a disk; it is thin, if no point of it is farther from the loop than the
chord error. If it lies in what the mesh leaves free, but its center is swept, or the other way round, the mesh is cut
along the loop, and each side gets the disk.
*/
class Thin_handles
{
public:
  using Mesh = Boundary_of_cells::Mesh;

private:
  using Loop = Short_loops::Loop;
  using Segment = CGAL::Simple_cartesian<double>::Segment_3;
  using Triangle = CGAL::Simple_cartesian<double>::Triangle_3;

  Mesh m_mesh;
  double m_chord_error;

public:
  Thin_handles(Mesh mesh, double chord_error) : m_mesh(std::move(mesh)), m_chord_error(chord_error) {}

  // How many there were; `is_swept` tells it of points, or nothing.
  template <class Is_swept>
  int close(const Is_swept& is_swept)
  {
    int result = 0;
    while (close_one(is_swept))
      ++result;
    return result;
  }

  Mesh& mesh() { return m_mesh; }

private:
  template <class Is_swept>
  bool close_one(const Is_swept& is_swept)
  {
    constexpr int errors = 16;
    int tests = 32;
    for (const Loop& loop : Short_loops(m_mesh, errors * m_chord_error)()) {
      const Mesh::Point center = center_of(loop);
      if (!has_thin_disk(loop, center))
        continue;
      if (is_swept(center) == std::optional<bool>(is_free(loop, center))) {
        m_mesh = cut_along(loop, center);
        return true;
      }
      if (--tests == 0)
        break;
    }
    return false;
  }

  // That of its length.
  Mesh::Point center_of(const Loop& loop) const
  {
    const Mesh::Point& origin = m_mesh.point(m_mesh.source(loop.halfedges.front()));
    CGAL::Simple_cartesian<double>::Vector_3 sum = CGAL::NULL_VECTOR;
    double length = 0;
    for (const auto halfedge : loop.halfedges) {
      const Mesh::Point &p = m_mesh.point(m_mesh.source(halfedge)), &q = m_mesh.point(m_mesh.target(halfedge));
      const double own = std::sqrt(CGAL::squared_distance(p, q));
      sum = sum + own * (CGAL::midpoint(p, q) - origin);
      length += own;
    }
    return length > 0 ? origin + sum / length : origin;
  }

  Segment segment(Mesh::Halfedge_index halfedge) const
  {
    return {m_mesh.point(m_mesh.source(halfedge)), m_mesh.point(m_mesh.target(halfedge))};
  }

  bool has_thin_disk(const Loop& loop, const Mesh::Point& center) const
  {
    constexpr int halvings = 10;
    std::vector<Segment> segments;
    for (const auto halfedge : loop.halfedges)
      segments.push_back(segment(halfedge));
    return std::all_of(segments.begin(), segments.end(), [&](const Segment& own) {
      return is_near({center, own.source(), own.target()}, segments, halvings);
    });
  }

  // Whether no point of a triangle is farther from the segments than the chord error, by halves of it.
  bool is_near(const Triangle& triangle, const std::vector<Segment>& segments, int halvings) const
  {
    const Mesh::Point middle = CGAL::centroid(triangle);
    double radius = 0, distance = std::numeric_limits<double>::infinity();
    int apex = 0; // opposite to the longest side
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      radius = (std::max)(radius, CGAL::squared_distance(middle, triangle.vertex(k)));
      const double side = CGAL::squared_distance(triangle.vertex(k + 1), triangle.vertex(k + 2));
      if (side > longest) {
        longest = side;
        apex = k;
      }
    }
    for (const Segment& own : segments)
      distance = (std::min)(distance, CGAL::squared_distance(middle, own));
    distance = std::sqrt(distance);
    if (distance > m_chord_error)
      return false;
    if (distance + std::sqrt(radius) <= m_chord_error)
      return true;
    const Mesh::Point &tip = triangle.vertex(apex), &p = triangle.vertex(apex + 1), &q = triangle.vertex(apex + 2);
    const Mesh::Point half = CGAL::midpoint(p, q);
    return halvings > 0 && is_near({tip, p, half}, segments, halvings - 1) &&
        is_near({tip, half, q}, segments, halvings - 1);
  }

  // Whether the disk over the loop lies outside of the mesh, as normals tell at most of the loop.
  bool is_free(const Loop& loop, const Mesh::Point& center) const
  {
    double sum = 0;
    for (const auto halfedge : loop.halfedges) {
      const Mesh::Point &p = m_mesh.point(m_mesh.source(halfedge)), &q = m_mesh.point(m_mesh.target(halfedge));
      for (const auto side : {halfedge, m_mesh.opposite(halfedge)}) {
        const Mesh::Point& apex = m_mesh.point(m_mesh.target(m_mesh.next(side)));
        const auto normal = CGAL::normal(m_mesh.point(m_mesh.source(side)), m_mesh.point(m_mesh.target(side)), apex);
        if (const double size = std::sqrt(normal.squared_length()); size > 0)
          sum += std::sqrt(CGAL::squared_distance(p, q)) / size * (normal * (center - CGAL::midpoint(p, q)));
      }
    }
    return sum > 0;
  }

  // The vertices of the loop twice: once for the faces on its left, and once for those on its right.
  Mesh cut_along(const Loop& loop, const Mesh::Point& center) const
  {
    Mesh result;
    for (const auto vertex : m_mesh.vertices())
      result.add_vertex(m_mesh.point(vertex));
    std::vector<std::array<Mesh::Vertex_index, 3>> corners;
    for (const auto face : m_mesh.faces()) {
      const auto first = m_mesh.halfedge(face);
      corners.push_back({m_mesh.target(first), m_mesh.target(m_mesh.next(first)), m_mesh.source(first)});
    }
    const auto center_of_left = result.add_vertex(center), center_of_right = result.add_vertex(center);
    std::vector<Mesh::Vertex_index> left;
    auto last = loop.halfedges.back();
    for (const auto halfedge : loop.halfedges) {
      const auto vertex = m_mesh.source(halfedge);
      left.push_back(result.add_vertex(m_mesh.point(vertex)));
      for (auto out = halfedge;; out = m_mesh.opposite(m_mesh.prev(out))) {
        auto& own = corners[m_mesh.face(out)];
        std::replace(own.begin(), own.end(), vertex, left.back());
        if (m_mesh.prev(out) == last)
          break;
      }
      last = halfedge;
    }
    for (const auto& own : corners)
      result.add_face(own[0], own[1], own[2]);
    for (std::size_t k = 0; k < left.size(); ++k) {
      const auto halfedge = loop.halfedges[k];
      result.add_face(left[(k + 1) % left.size()], left[k], center_of_left);
      result.add_face(m_mesh.source(halfedge), m_mesh.target(halfedge), center_of_right);
    }
    return result;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_THIN_HANDLES_H
