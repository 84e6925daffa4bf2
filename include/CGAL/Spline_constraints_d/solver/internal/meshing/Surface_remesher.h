// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_REMESHER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_REMESHER_H

#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Remeshed_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Makes the triangles of a mesh well-shaped and as large as its options allow, while its topology and features stay: edges
are split, collapsed and flipped, and vertices move along the surface (Botsch, Kobbelt 2004, A remeshing approach to
multiresolution modeling, with lengths from curvatures). Edges are too long first, so that most of this is done with few
triangles. Vertices stay near the surface, and are moved onto it by Newton's method in the end; what would fold
triangles is not done.
*/
class Surface_remesher : Remeshed_surface
{
  Run_control& m_control;
  Sample m_before;
  double m_enough_of_moves = 0.02; // as m_enough

  static constexpr double least_cosine = 0.5; // of normals of triangles with those of the surface

public:
  Surface_remesher(Solution_surface_mesh& result, Mesh_points& points, Remeshed_vertices vertices, Run_control& control)
    : Remeshed_surface(result, points, vertices), m_control(control)
  {}

  // False if a vertex is lost, which may happen unless vertices stay on the surface up to rounding all the time. The
  // error is measured, too.
  bool run(bool is_exact)
  {
    if (is_exact)
      m_enough = m_enough_of_moves = 0;
    for (const Vertex v : m_mesh.vertices())
      describe(v);
    reserve();
    for (const double coarseness : {4.0, 2.0, 1.0}) {
      if (m_control.must_stop(true))
        break;
      m_coarseness = coarseness;
      split_long_edges();
      collapse_short_edges();
      flip_edges();
      smooth();
    }
    flip_edges();
    smooth();
    m_mesh.collect_garbage();
    if (!is_exact && !move_to_surface())
      return false;
    for (const Vertex v : m_mesh.vertices())
      describe(v);
    refine_to_error();
    return true;
  }

  // Measures the greatest distance of middles of edges and triangles from points of the surface beside them. Returns
  // the edges that are not fine, and the longest ones of triangles whose middle is too far from the surface.
  std::vector<Edge> measure_error()
  {
    constexpr double enough = 0.02;
    const double enough_before = std::exchange(m_enough, enough);
    m_edges.resize(m_mesh.num_edges());
    m_faces.resize(m_mesh.num_faces());
    std::vector<Edge> coarse;
    m_result.error = 0;
    for (const Face face : m_mesh.faces()) {
      const Measured& own = measured(face);
      m_result.error = (std::max)(m_result.error, own.distance);
      if (!own.is_fine)
        coarse.push_back(longest_edge(face));
    }
    for (const Edge e : m_mesh.edges()) {
      const Measured& own = measured(e);
      m_result.error = (std::max)(m_result.error, own.distance);
      if (!own.is_fine)
        coarse.push_back(e);
    }
    m_enough = enough_before;
    std::sort(coarse.begin(), coarse.end());
    coarse.erase(std::unique(coarse.begin(), coarse.end()), coarse.end());
    return coarse;
  }

private:
  // Room for about as many vertices as there will be: equilateral triangles have areas of 0.43 times their squared
  // edges, and there are two of them for a vertex.
  void reserve()
  {
    double vertices = 0;
    for (const Face face : m_mesh.faces()) {
      const auto [a, b, c] = corners_of(face);
      const double length = (std::min)({data(a).length, data(b).length, data(c).length});
      vertices +=
          Surface_image::length(normal_of(m_mesh.point(a), m_mesh.point(b), m_mesh.point(c))) / (length * length);
    }
    constexpr double margin = 0.7, most = 1e7;
    const auto count = static_cast<Mesh::size_type>((std::min)(most, margin * vertices));
    m_mesh.reserve(count, 3 * count, 2 * count);
  }

  const Measured& measured(Face face)
  {
    Measured& own = m_faces[face];
    if (!own.is_known) {
      const double distance = distance_at_middle(face);
      own = {distance, distance <= m_points.options().chord_error, true};
    }
    return own;
  }

  const Measured& measured(Edge e)
  {
    Measured& own = m_edges[e];
    if (!own.is_known)
      own = find_middle(e) ? Measured{distance_of_middle(e), is_fine_with_middle(e), true} : Measured{0, true, true};
    return own;
  }

  static Vector normal_of(const Point& a, const Point& b, const Point& c) { return CGAL::cross_product(b - a, c - a); }

  // Whether a triangle with these corners faces the side that the normals of its vertices do.
  bool is_upright(const std::array<Vertex, 3>& vertices, const std::array<Point, 3>& points)
  {
    const Vector normal = normal_of(points[0], points[1], points[2]);
    const double size = Surface_image::length(normal);
    for (const Vertex v : vertices)
      if (!(normal * data(v).normal > least_cosine * size) && data(v).normal != CGAL::NULL_VECTOR)
        return false;
    return size > 0;
  }

  // The greatest of the squared cosines of the angles of a triangle, with their signs: less where the least angle is
  // greater.
  static double sharpness(const Point& a, const Point& b, const Point& c)
  {
    const Vector u = b - a, v = c - b, w = a - c;
    const double uu = u.squared_length(), vv = v.squared_length(), ww = w.squared_length();
    const auto cosine = [](double product, double square) { return product * std::abs(product) / square; };
    return (std::max)({cosine(-(u * w), uu * ww), cosine(-(u * v), uu * vv), cosine(-(v * w), vv * ww)});
  }

  void split_long_edges()
  {
    constexpr int most_passes = 8;
    constexpr double too_long = 4.0 / 3;
    for (int pass = 0; pass < most_passes; ++pass) {
      std::vector<std::pair<double, Edge>> edges;
      for (const Edge e : m_mesh.edges()) {
        const Halfedge h = m_mesh.halfedge(e);
        const double ratio = length_of(e) / aim(m_mesh.source(h), m_mesh.target(h));
        if (ratio > too_long || (is_feature(e) && !is_fine(e)))
          edges.emplace_back(-ratio, e);
      }
      if (edges.empty() || m_control.must_stop(true))
        return;
      std::sort(edges.begin(), edges.end());
      for (const auto& [ratio, e] : edges)
        if (find_middle(e))
          split(e);
      flip_edges(1); // else edges across halves of triangles would be split in turn
    }
  }

  void collapse_short_edges()
  {
    constexpr double too_short = 4.0 / 5;
    std::vector<std::pair<double, Edge>> edges;
    for (const Edge e : m_mesh.edges()) {
      const Halfedge h = m_mesh.halfedge(e);
      const double ratio = length_of(e) / aim(m_mesh.source(h), m_mesh.target(h));
      if (ratio < too_short)
        edges.emplace_back(ratio, e);
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [ratio, e] : edges) {
      if (m_mesh.is_removed(e))
        continue;
      const Halfedge h = m_mesh.halfedge(e);
      if (length_of(e) < too_short * aim(m_mesh.source(h), m_mesh.target(h)) && !collapse(h))
        collapse(m_mesh.opposite(h));
    }
  }

  // Moves the source of an edge to its target; false if that is not possible.
  bool collapse(Halfedge h)
  {
    const Vertex gone = m_mesh.source(h), kept = m_mesh.target(h);
    const Edge e = m_mesh.edge(h);
    if (data(gone).is_corner || (!data(gone).fixed.empty() && !is_feature(e)) || !stays_upright(h) ||
        !CGAL::Euler::does_satisfy_link_condition(e, m_mesh))
      return false;
    const Remeshed_vertex own = data(kept);
    const Sample place_kept{unknowns(kept), m_mesh.point(kept), own.patch};
    std::vector<std::pair<Vertex, bool>> sides; // edges that become one, and whether it is a feature
    for (const Halfedge side : {h, m_mesh.opposite(h)})
      if (!m_mesh.is_border(side)) {
        const Halfedge next = m_mesh.next(side);
        sides.emplace_back(m_mesh.target(next),
                           is_feature(m_mesh.edge(next)) || is_feature(m_mesh.edge(m_mesh.next(next))));
      }
    const Vertex vertex = CGAL::Euler::collapse_edge(e, m_mesh);
    data(vertex) = own;
    place(vertex, place_kept);
    for (const auto& [other, is_on_feature] : sides)
      m_result.is_feature[m_mesh.edge(m_mesh.halfedge(vertex, other))] = is_on_feature;
    return true;
  }

  // Whether the triangles around the source of an edge stay as they should when it moves to the target.
  bool stays_upright(Halfedge h)
  {
    constexpr double too_long = 4.0 / 3;
    const Vertex gone = m_mesh.source(h), kept = m_mesh.target(h);
    for (const Halfedge in : m_mesh.halfedges_around_target(m_mesh.opposite(h))) {
      const Vertex other = m_mesh.source(in);
      if (other == kept)
        continue;
      const double length = std::sqrt(CGAL::squared_distance(m_mesh.point(kept), m_mesh.point(other)));
      if (length > too_long * aim(kept, other))
        return false;
      if (is_feature(m_mesh.edge(in)) && !would_be_fine(other, kept, fixed_along(m_mesh.edge(in))))
        return false;
      if (m_mesh.is_border(in))
        continue;
      const Vertex last = m_mesh.target(m_mesh.next(in));
      if (last == kept)
        continue;
      if (!is_upright({other, kept, last}, {m_mesh.point(other), m_mesh.point(kept), m_mesh.point(last)}))
        return false;
    }
    return gone != kept;
  }

  bool would_be_fine(Vertex a, Vertex b, const std::vector<int>& fixed)
  {
    return find_middle(std::array{a, b}, fixed) && m_points.is_fine(m_mesh.point(a), m_middle.image, m_mesh.point(b));
  }

  // Flips edges while that makes the least angle of their two triangles greater.
  void flip_edges(int most_passes = 4)
  {
    bool has_changed = true;
    for (int pass = 0; pass < most_passes && std::exchange(has_changed, false); ++pass)
      for (const Edge e : m_mesh.edges())
        if (!m_mesh.is_border(e) && !is_feature(e) && is_better_flipped(m_mesh.halfedge(e))) {
          forget(e);
          CGAL::Euler::flip_edge(m_mesh.halfedge(e), m_mesh);
          has_changed = true;
        }
  }

  bool is_better_flipped(Halfedge h)
  {
    const Halfedge o = m_mesh.opposite(h);
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h), c = m_mesh.target(m_mesh.next(h)),
                 d = m_mesh.target(m_mesh.next(o));
    const Point &pa = m_mesh.point(a), &pb = m_mesh.point(b), &pc = m_mesh.point(c), &pd = m_mesh.point(d);
    if ((pa - pc) * (pb - pc) >= 0 && (pa - pd) * (pb - pd) >= 0) // it would be the longer diagonal
      return false;
    if (c == d || m_mesh.halfedge(c, d) != Mesh::null_halfedge())
      return false;
    constexpr double gain = 1e-6;
    return (std::max)(sharpness(pa, pd, pc), sharpness(pb, pc, pd)) <
        (std::max)(sharpness(pa, pb, pc), sharpness(pb, pa, pd)) - gain &&
        is_upright({a, d, c}, {pa, pd, pc}) && is_upright({b, c, d}, {pb, pc, pd});
  }

  // Moves vertices that are on no feature towards the middle of their neighbours, along the surface.
  void smooth()
  {
    for (const Vertex v : m_mesh.vertices())
      if (data(v).fixed.empty() && !data(v).is_corner && !m_mesh.is_isolated(v))
        smooth(v);
  }

  void smooth(Vertex v)
  {
    Vector sum(0, 0, 0);
    double weight = 0;
    for (const Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v))) {
      const Point &p = m_mesh.point(m_mesh.source(in)), &q = m_mesh.point(m_mesh.target(m_mesh.next(in)));
      const double area = Surface_image::length(normal_of(m_mesh.point(v), p, q));
      sum = sum + area * ((p - m_mesh.point(v)) + (q - m_mesh.point(v))) / 3;
      weight += area;
    }
    if (!(weight > 0))
      return;
    m_before.unknowns = unknowns(v);
    m_before.image = m_mesh.point(v);
    m_before.patch = data(v).patch;
    const Vector normal = data(v).normal;
    if (!find_moved(v, sum / weight))
      return;
    place(v, m_middle);
    data(v).normal = m_points.image().is_level_set() ? Surface_image::unit(m_points.surface().last_gradients())
                                                     : m_points.image().normal(data(v).patch, unknowns(v));
    for (const Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v))) {
      const std::array<Vertex, 3> corners{m_mesh.source(in), v, m_mesh.target(m_mesh.next(in))};
      if (!is_upright(corners, {m_mesh.point(corners[0]), m_mesh.point(v), m_mesh.point(corners[2])})) {
        place(v, m_before);
        data(v).normal = normal;
        return;
      }
    }
  }

  // Follows the tangents' share of a displacement to the surface, up to a small part of it: m_middle is there then.
  // False if that leads elsewhere.
  bool find_moved(Vertex v, const Vector& displacement)
  {
    m_middle.unknowns = unknowns(v);
    m_middle.patch = data(v).patch;
    const std::optional<Vector> aim = add_along_tangents(v, displacement, m_middle.unknowns);
    if (!aim)
      return false;
    for (const Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      m_middle.patch = m_points.surface().nearer(m_middle.patch, data(m_mesh.source(in)).patch, m_middle.unknowns);
    const double size = Surface_image::length(*aim);
    if (!m_points.surface().move_to_surface(m_middle.patch, {}, m_middle.unknowns,
                                            m_points.image().is_level_set() ? m_enough_of_moves * size : 0))
      return false;
    m_middle.image = m_points.image()(m_middle.patch, m_middle.unknowns);
    return (m_middle.image - (m_mesh.point(v) + *aim)).squared_length() <= 0.25 * size * size;
  }

  // Adds what moves the image by the tangents' share of a displacement, which it returns.
  std::optional<Vector> add_along_tangents(Vertex v, const Vector& displacement, Unknowns& point)
  {
    if (m_points.image().is_level_set()) {
      const Vector aim = displacement - displacement * data(v).normal * data(v).normal;
      for (std::size_t j = 0; j < 3; ++j)
        point[j] += aim[static_cast<int>(j)];
      return aim;
    }
    const Surface_image::Tangents tangents = m_points.image().tangents(data(v).patch, unknowns(v));
    const auto& [s, t] = tangents.images;
    const double e = s * s, f = s * t, g = t * t, determinant = e * g - f * f;
    if (!(determinant > 0))
      return std::nullopt;
    const double a = displacement * s, b = displacement * t;
    const double first = (g * a - f * b) / determinant, second = (e * b - f * a) / determinant;
    for (std::size_t j = 0; j < point.size(); ++j) {
      const auto row = static_cast<Eigen::Index>(j);
      point[j] += first * tangents.unknowns(row, 0) + second * tangents.unknowns(row, 1);
    }
    return first * s + second * t;
  }

  Edge longest_edge(Face face) const
  {
    Edge result = m_mesh.edge(m_mesh.halfedge(face));
    for (const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(face)))
      if (length_of(m_mesh.edge(h)) > length_of(result))
        result = m_mesh.edge(h);
    return result;
  }

  // Splits edges, at points of the surface up to rounding, until triangles are fine.
  void refine_to_error()
  {
    constexpr int most_passes = 8;
    std::vector<Edge> coarse = measure_error();
    for (int pass = 0; pass < most_passes && !coarse.empty() && !m_control.must_stop(true); ++pass) {
      const double enough = std::exchange(m_enough, 0);
      for (const Edge e : coarse)
        if (find_middle(e))
          split(e);
      m_enough = enough;
      flip_edges();
      coarse = measure_error();
    }
  }

  // Vertices are solutions up to rounding afterwards; false if one is not near any.
  bool move_to_surface()
  {
    for (const Vertex v : m_mesh.vertices()) {
      const Remeshed_vertex& own = data(v);
      if (!own.is_corner) {
        m_before.unknowns = unknowns(v);
        constexpr double rounding = 0x1p-20; // of edges; steps do not become shorter beside singular points
        if (!m_points.surface().move_to_surface(own.patch, own.fixed, m_before.unknowns) &&
            !m_points.surface().move_to_surface(own.patch, own.fixed, m_before.unknowns, rounding * own.length))
          return false;
        m_before.image = m_points.image()(own.patch, m_before.unknowns);
        m_before.patch = own.patch;
        constexpr double share = 0.1;
        const double most = share * own.length;
        if (!(CGAL::squared_distance(m_before.image, m_mesh.point(v)) < most * most))
          return false;
        place(v, m_before);
      }
    }
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_REMESHER_H
