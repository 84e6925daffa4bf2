// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_THICK_RAYS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_THICK_RAYS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/access_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/exact_triples.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/surface_cells.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
Rays of the radius r: the points within the distance r of the ray S + t O, t >= 0, for S = X/w, and triangles in their
way. With a vertex V, an edge from V along e and the normal n of a triangle, the distance r is that of

  0  the line and an edge    <V - S, O x e>^2 = r^2 |O x e|^2
  0  the source and the plane  <V - S, n>^2 = r^2 |n|^2
  1  the line and a vertex   |(V - S) x O|^2 = r^2 |O|^2
  1  the source and an edge    |(V - S) x e|^2 = r^2 |e|^2
  2  the source and a vertex   |V - S|^2 = r^2.

Curves of neighbouring levels would touch, at irrational parameters as a rule. So r is greater by a little on each
level, and they cross. What a condition leaves at the end of an edge, or where the foot on the ray is the source, is
then inside of one of the next level, so that the union of all is bounded by these curves alone: it has all rays that
are within r of a triangle, and none that is not within r (1 + 2 / 256).
*/
class Thick_rays
{
  using Edge = std::array<Exact_triple, 2>;
  using Plane = std::pair<Exact_triple, Exact_rational>; // n and <n, x> on it

  std::vector<Exact_triangle> m_triangles;
  std::array<Exact_rational, 3> m_squares; // of the radii of the levels
  std::set<Exact_triple> m_vertices;
  std::set<Edge> m_edges;
  std::set<Plane> m_planes;

public:
  // The direction, if all rays have the same one.
  Thick_rays(const std::vector<Exact_triangle>& triangles, const Exact_rational& radius,
             const std::optional<Exact_triple>& direction)
    : m_triangles(triangles)
  {
    for (std::size_t level = 0; level < 3; ++level) {
      const Exact_rational own(radius * (1 + Exact_rational(static_cast<int>(level), 256)));
      m_squares[level] = own * own;
    }
    for (const Exact_triangle& triangle : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Exact_triple &p = triangle[i], &q = triangle[(i + 1) % 3];
        m_vertices.insert(p);
        m_edges.insert(p < q ? Edge{p, q} : Edge{q, p});
      }
      Exact_triple normal = normal_of_triangle(triangle);
      const Exact_rational first = *std::ranges::find_if(normal, [](const Exact_rational& x) { return x != 0; });
      for (Exact_rational& x : normal)
        x /= first;
      m_planes.emplace(normal, dot(normal, triangle[0]));
    }
    if (direction && !is_thick())
      std::erase_if(m_edges, [&](const Edge& edge) { return is_covered(edge, *direction); });
  }

  // What vanishes where such a distance is the radius.
  std::vector<Cell_polynomial> zeros(const Surface_cell_3& cell, const Cell_vector& direction) const
  {
    const Cell_vector x = numerators_of(cell);
    const Cell_polynomial &w = cell.coordinates[3], squared_weight = w * w, square = dot(direction, direction);
    std::vector<Cell_polynomial> result;
    const auto add = [&](const Cell_polynomial& length, const Cell_polynomial& unit, std::size_t level) {
      result.push_back(length - unit * squared_weight * m_squares[level]);
    };
    const Cell_polynomial one = Cell_polynomial::constant(2, Exact_rational(1));
    for (const auto& [p, q] : m_edges) {
      const Exact_triple along = difference(q, p);
      const Cell_vector offset = p * w - x, edge = constant_vector(along), across = cross(direction, edge);
      const Cell_polynomial volume = dot(offset, across);
      if (!is_thick())
        result.push_back(volume);
      else {
        add(volume * volume, dot(across, across), 0);
        const Cell_vector moment = cross(offset, edge);
        add(dot(moment, moment), one * dot(along, along), 1);
      }
    }
    for (const auto& [normal, level] : m_planes) {
      const Cell_polynomial height = w * level - dot(constant_vector(normal), x);
      if (!is_thick())
        result.push_back(height);
      else
        add(height * height, one * dot(normal, normal), 0);
    }
    if (is_thick())
      for (const Exact_triple& vertex : m_vertices) {
        const Cell_vector offset = vertex * w - x, moment = cross(offset, direction);
        add(dot(moment, moment), square, 1);
        add(dot(offset, offset), one, 2);
      }
    return result;
  }

  // Whether a triangle is in the way of a ray.
  bool is_hit(const Exact_triple& source, const Exact_triple& direction) const
  {
    return std::ranges::any_of(m_triangles,
                               [&](const Exact_triangle& x) { return is_hit_inside(x, source, direction); }) ||
        (is_thick() &&
         (std::ranges::any_of(m_vertices, [&](const Exact_triple& x) { return is_near(x, source, direction); }) ||
          std::ranges::any_of(m_edges, [&](const Edge& x) { return is_near(x, source, direction); })));
  }

private:
  bool is_thick() const { return m_squares[0] > 0; }

  // Whether triangles on both sides of an edge, as seen along the rays, cover what is beside it: it bounds nothing
  // then.
  bool is_covered(const Edge& edge, const Exact_triple& direction) const
  {
    const Exact_triple across = cross(direction, difference(edge[1], edge[0]));
    bool has_left = false, has_right = false;
    for (const Exact_triangle& triangle : m_triangles) {
      if (std::ranges::count(triangle, edge[0]) == 0 || std::ranges::count(triangle, edge[1]) == 0)
        continue;
      for (const Exact_triple& p : triangle) {
        const Exact_rational side = dot(across, difference(p, edge[0]));
        has_left = has_left || side > 0;
        has_right = has_right || side < 0;
      }
    }
    return has_left && has_right;
  }

  static Exact_triple normal_of_triangle(const Exact_triangle& triangle)
  {
    return cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
  }

  static Exact_triple moved(const Exact_triple& p, const Exact_rational& t, const Exact_triple& along)
  {
    return {Exact_rational(p[0] + t * along[0]), Exact_rational(p[1] + t * along[1]),
            Exact_rational(p[2] + t * along[2])};
  }

  // Of a point over the inside of a triangle, or on it.
  static bool is_over(const Exact_triangle& triangle, const Exact_triple& normal, const Exact_triple& p)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const Exact_triple side = difference(triangle[(i + 1) % 3], triangle[i]);
      if (dot(normal, cross(side, difference(p, triangle[i]))) < 0)
        return false;
    }
    return true;
  }

  // Passed, or near the source.
  bool is_hit_inside(const Exact_triangle& triangle, const Exact_triple& source, const Exact_triple& direction) const
  {
    const Exact_triple normal = normal_of_triangle(triangle);
    const Exact_rational slope = dot(normal, direction), height = dot(normal, difference(triangle[0], source));
    if (height * height <= m_squares[0] * dot(normal, normal) && is_over(triangle, normal, source))
      return true;
    if (slope == 0)
      return false; // in its plane, it meets an edge
    const Exact_rational t(height / slope);
    return t >= 0 && is_over(triangle, normal, moved(source, t, direction));
  }

  bool is_near(const Exact_triple& vertex, const Exact_triple& source, const Exact_triple& direction) const
  {
    const Exact_triple offset = difference(vertex, source);
    const Exact_rational distance = dot(offset, offset), ahead = dot(offset, direction),
                         square = dot(direction, direction);
    return distance <= m_squares[2] || (ahead >= 0 && distance * square - ahead * ahead <= m_squares[1] * square);
  }

  // With the feet of the perpendiculars on the edge and the ray, not on the lines only.
  bool is_near(const Edge& edge, const Exact_triple& source, const Exact_triple& direction) const
  {
    const Exact_triple along = difference(edge[1], edge[0]), offset = difference(edge[0], source),
                       moment = cross(offset, along), across = cross(direction, along);
    const Exact_rational a = dot(direction, direction), b = dot(direction, along), c = dot(along, along),
                         d = dot(offset, direction), e = dot(offset, along);
    if (e <= 0 && -e <= c && dot(moment, moment) <= m_squares[1] * c)
      return true;
    // t determinant and l determinant for the point S + t O next to V + l e
    const Exact_rational determinant(a * c - b * b), t(d * c - e * b), l(d * b - e * a), volume = dot(offset, across);
    return determinant > 0 && t >= 0 && l >= 0 && l <= determinant &&
        volume * volume <= m_squares[0] * dot(across, across);
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_THICK_RAYS_H
