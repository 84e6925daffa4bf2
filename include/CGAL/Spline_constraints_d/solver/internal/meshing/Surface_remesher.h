// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_REMESHER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_REMESHER_H

#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_points.h>

#include <CGAL/boost/graph/Euler_operations.h>

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

// What is known of the vertices of a mesh besides their unknowns.
struct Remeshed_vertex
{
  std::size_t patch;           // whose polynomials are used there
  std::vector<int> fixed = {}; // the unknowns that the features at the vertex fix
  bool is_corner = false;      // features end or turn there, so that it stays
  double length = 0;           // that edges should have
  Surface_differentials_3::Vector normal = {};
};

using Remeshed_vertices =
    Solution_surface_mesh::Mesh::Property_map<Solution_surface_mesh::Mesh::Vertex_index, Remeshed_vertex>;

/*
Makes the triangles of a mesh well-shaped and as large as its options allow, while its topology and features stay: edges
are split, collapsed and flipped, and vertices move along the surface (Botsch, Kobbelt 2004, A remeshing approach to
multiresolution modeling, with lengths from curvatures). Vertices are moved to the surface by Newton's method; what
would fold triangles is not done.
*/
class Surface_remesher
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;
  using Point = Surface_image::Point;
  using Vector = Surface_image::Vector;
  using Unknowns = Surface_points::Point;

  Solution_surface_mesh& m_result;
  Mesh& m_mesh;
  Mesh_points& m_points;
  Run_control& m_control;
  Remeshed_vertices m_vertices;
  double m_longest;

  static constexpr double least_cosine = 0.5; // of normals of triangles with those of the surface

public:
  Surface_remesher(Solution_surface_mesh& result, Mesh_points& points, Remeshed_vertices vertices, Run_control& control)
    : m_result(result), m_mesh(result.mesh), m_points(points), m_control(control), m_vertices(vertices)
  {
    CGAL::Bbox_3 box;
    for (const Vertex v : m_mesh.vertices())
      box += m_mesh.point(v).bbox();
    constexpr double share = 0.25; // of the extent, for edges of a plane
    m_longest = share * (std::max)({box.x_span(), box.y_span(), box.z_span()});
    for (const Vertex v : m_mesh.vertices())
      describe(v);
  }

  void run()
  {
    constexpr int iterations = 6;
    for (int k = 0; k < iterations && !m_control.must_stop(true); ++k) {
      split_long_edges();
      collapse_short_edges();
      flip_edges();
      smooth();
    }
    refine_to_error();
    m_mesh.collect_garbage();
  }

  // The greatest distance of middles of edges and triangles from points of the surface beside them.
  double measured_error()
  {
    double result = 0;
    for (const Edge e : m_mesh.edges())
      if (const std::optional<Sample> middle = middle_of(e)) {
        const Halfedge h = m_mesh.halfedge(e);
        result = (std::max)(
            result,
            CGAL::squared_distance(middle->image,
                                   CGAL::midpoint(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)))));
      }
    result = std::sqrt(result);
    for (const Face face : m_mesh.faces())
      result = (std::max)(result, distance_at_middle(corners_of(face)));
    return result;
  }

private:
  struct Sample
  {
    Unknowns unknowns;
    Point image;
    std::size_t patch;
  };

  Remeshed_vertex& data(Vertex v) { return m_vertices[v]; }
  const Unknowns& unknowns(Vertex v) const { return m_result.unknowns[v]; }
  bool is_feature(Edge e) const { return m_result.is_feature[e]; }

  void describe(Vertex v)
  {
    const Surface_mesh_options& options = m_points.options();
    const Surface_differentials_3 own = m_points.image().differentials(data(v).patch, unknowns(v));
    const double curvature = (std::max)(std::abs(own.curvatures[0]), std::abs(own.curvatures[1]));
    // the middle of an equilateral triangle is l^2 / 6 times the curvature away; edges are longer by a third at most
    constexpr double margin = 0.8, share = 4; // see Mesh_points::is_fine()
    double length = (std::min)(options.edge_length, m_longest);
    if (curvature > 0) {
      const double of_error = margin * std::sqrt(6 * options.chord_error / curvature);
      length = (std::min)({length, of_error, (std::max)(margin * options.angle / curvature, of_error / share)});
    }
    data(v).length = length;
    data(v).normal = own.normal;
    m_result.differentials[v] = own;
  }

  double length_of(Edge e) const
  {
    const Halfedge h = m_mesh.halfedge(e);
    return std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))));
  }

  double aim(Vertex a, Vertex b) { return (std::min)(data(a).length, data(b).length); }

  // The point of the surface beside the middle of some vertices; that of a feature, on it. None if it is far away.
  std::optional<Sample> middle_of(std::span<const Vertex> vertices, std::span<const int> fixed)
  {
    Unknowns middle(unknowns(vertices[0]).size(), 0);
    Vector sum(0, 0, 0);
    for (const Vertex v : vertices) {
      for (std::size_t j = 0; j < middle.size(); ++j)
        middle[j] += unknowns(v)[j] / static_cast<double>(vertices.size());
      sum = sum + (m_mesh.point(v) - CGAL::ORIGIN);
    }
    for (const int j : fixed)
      middle[static_cast<std::size_t>(j)] = unknowns(vertices[0])[static_cast<std::size_t>(j)];
    std::size_t patch = data(vertices[0]).patch;
    for (const Vertex v : vertices)
      patch = m_points.surface().nearer(patch, data(v).patch, middle);
    if (!m_points.surface().move_to_surface(patch, fixed, middle))
      return std::nullopt;
    const Point image = m_points.image()(patch, middle), center = CGAL::ORIGIN + sum / vertices.size();
    const double size = CGAL::squared_distance(m_mesh.point(vertices[0]), m_mesh.point(vertices[1]));
    if (!(CGAL::squared_distance(image, center) < 0.25 * size))
      return std::nullopt;
    return Sample{std::move(middle), image, patch};
  }

  std::optional<Sample> middle_of(Edge e)
  {
    const Halfedge h = m_mesh.halfedge(e);
    const std::array<Vertex, 2> ends{m_mesh.source(h), m_mesh.target(h)};
    return middle_of(ends, fixed_along(e));
  }

  // The unknowns that are fixed along a feature: those at both ends.
  std::vector<int> fixed_along(Edge e)
  {
    std::vector<int> result;
    if (!is_feature(e))
      return result;
    const Halfedge h = m_mesh.halfedge(e);
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h);
    for (const int j : data(a).fixed)
      if (const auto& others = data(b).fixed; std::find(others.begin(), others.end(), j) != others.end() &&
          unknowns(a)[static_cast<std::size_t>(j)] == unknowns(b)[static_cast<std::size_t>(j)])
        result.push_back(j);
    return result;
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
        if (const std::optional<Sample> middle = middle_of(e))
          split(e, *middle);
    }
  }

  bool is_fine(Edge e)
  {
    const std::optional<Sample> middle = middle_of(e);
    return !middle || is_fine(e, *middle);
  }

  bool is_fine(Edge e, const Sample& middle) const
  {
    const Halfedge h = m_mesh.halfedge(e);
    return m_points.is_fine(m_mesh.point(m_mesh.source(h)), middle.image, m_mesh.point(m_mesh.target(h)));
  }

  Vertex split(Edge e, const Sample& middle)
  {
    const bool is_on_feature = is_feature(e);
    const Halfedge h = m_mesh.halfedge(e);
    Remeshed_vertex own{middle.patch, fixed_along(e)};
    const Halfedge first = CGAL::Euler::split_edge(h, m_mesh); // to the new vertex, before h
    const Vertex vertex = m_mesh.target(first);
    data(vertex) = std::move(own);
    place(vertex, middle);
    describe(vertex);
    m_result.is_feature[m_mesh.edge(first)] = m_result.is_feature[m_mesh.edge(h)] = is_on_feature;
    for (const Halfedge in : {first, m_mesh.opposite(h)})
      if (const Face face = m_mesh.face(in); face != Mesh::null_face()) {
        const Halfedge diagonal = CGAL::Euler::split_face(in, m_mesh.next(m_mesh.next(in)), m_mesh);
        m_result.is_feature[m_mesh.edge(diagonal)] = false;
        for (const Halfedge side : {diagonal, m_mesh.opposite(diagonal)})
          m_result.surface[m_mesh.face(side)] = m_result.surface[face];
      }
    return vertex;
  }

  void place(Vertex v, const Sample& sample)
  {
    m_mesh.point(v) = sample.image;
    m_result.unknowns[v] = sample.unknowns;
    data(v).patch = sample.patch;
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
    if (data(gone).is_corner || (!data(gone).fixed.empty() && !is_feature(e)) ||
        !CGAL::Euler::does_satisfy_link_condition(e, m_mesh) || !stays_upright(h))
      return false;
    const Remeshed_vertex own = data(kept);
    const Sample place_kept{unknowns(kept), m_mesh.point(kept), own.patch};
    const Surface_differentials_3 differentials = m_result.differentials[kept];
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
    m_result.differentials[vertex] = differentials;
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
    const std::array<Vertex, 2> ends{a, b};
    const std::optional<Sample> middle = middle_of(ends, fixed);
    return middle && m_points.is_fine(m_mesh.point(a), middle->image, m_mesh.point(b));
  }

  // Flips edges while that makes the least angle of their two triangles greater.
  void flip_edges()
  {
    constexpr int most_passes = 4;
    bool has_changed = true;
    for (int pass = 0; pass < most_passes && std::exchange(has_changed, false); ++pass)
      for (const Edge e : m_mesh.edges())
        if (!m_mesh.is_border(e) && !is_feature(e) && is_better_flipped(m_mesh.halfedge(e))) {
          CGAL::Euler::flip_edge(m_mesh.halfedge(e), m_mesh);
          has_changed = true;
        }
  }

  bool is_better_flipped(Halfedge h)
  {
    const Halfedge o = m_mesh.opposite(h);
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h), c = m_mesh.target(m_mesh.next(h)),
                 d = m_mesh.target(m_mesh.next(o));
    if (c == d || m_mesh.halfedge(c, d) != Mesh::null_halfedge())
      return false;
    const Point &pa = m_mesh.point(a), &pb = m_mesh.point(b), &pc = m_mesh.point(c), &pd = m_mesh.point(d);
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
    const std::optional<Sample> moved = moved_along_surface(v, sum / weight);
    if (!moved)
      return;
    const Sample before{unknowns(v), m_mesh.point(v), data(v).patch};
    const Vector normal = data(v).normal;
    place(v, *moved);
    data(v).normal = m_points.image().normal(data(v).patch, unknowns(v));
    for (const Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v))) {
      const std::array<Vertex, 3> corners{m_mesh.source(in), v, m_mesh.target(m_mesh.next(in))};
      if (!is_upright(corners, {m_mesh.point(corners[0]), m_mesh.point(v), m_mesh.point(corners[2])})) {
        place(v, before);
        data(v).normal = normal;
        return;
      }
    }
  }

  // The tangents' share of a displacement, followed to the surface; none if that leads elsewhere.
  std::optional<Sample> moved_along_surface(Vertex v, const Vector& displacement)
  {
    const Surface_image::Tangents tangents = m_points.image().tangents(data(v).patch, unknowns(v));
    const auto& [s, t] = tangents.images;
    const double e = s * s, f = s * t, g = t * t, determinant = e * g - f * f;
    if (!(determinant > 0))
      return std::nullopt;
    const double a = displacement * s, b = displacement * t;
    const double first = (g * a - f * b) / determinant, second = (e * b - f * a) / determinant;
    Sample result{unknowns(v), {}, data(v).patch};
    for (std::size_t j = 0; j < result.unknowns.size(); ++j) {
      const auto row = static_cast<Eigen::Index>(j);
      result.unknowns[j] += first * tangents.unknowns(row, 0) + second * tangents.unknowns(row, 1);
    }
    for (const Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      result.patch = m_points.surface().nearer(result.patch, data(m_mesh.source(in)).patch, result.unknowns);
    if (!m_points.surface().move_to_surface(result.patch, {}, result.unknowns))
      return std::nullopt;
    result.image = m_points.image()(result.patch, result.unknowns);
    const Vector aim = first * s + second * t;
    const double error = (result.image - (m_mesh.point(v) + aim)).squared_length();
    return error <= 0.25 * aim.squared_length() ? std::optional(std::move(result)) : std::nullopt;
  }

  // Splits the edges that are not fine, and those of triangles whose middle is too far from the surface.
  void refine_to_error()
  {
    constexpr int most_passes = 8;
    for (int pass = 0; pass < most_passes && !m_control.must_stop(true); ++pass) {
      std::vector<Edge> coarse;
      for (const Face face : m_mesh.faces()) {
        Edge longest = m_mesh.edge(m_mesh.halfedge(face));
        for (const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(face)))
          if (length_of(m_mesh.edge(h)) > length_of(longest))
            longest = m_mesh.edge(h);
        if (distance_at_middle(corners_of(face)) > m_points.options().chord_error)
          coarse.push_back(longest);
      }
      for (const Edge e : m_mesh.edges())
        if (!is_fine(e))
          coarse.push_back(e);
      std::sort(coarse.begin(), coarse.end());
      coarse.erase(std::unique(coarse.begin(), coarse.end()), coarse.end());
      if (coarse.empty())
        return;
      for (const Edge e : coarse)
        if (const std::optional<Sample> middle = middle_of(e))
          split(e, *middle);
      flip_edges();
    }
  }

  std::array<Vertex, 3> corners_of(Face face) const
  {
    const Halfedge h = m_mesh.halfedge(face);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))};
  }

  double distance_at_middle(const std::array<Vertex, 3>& corners)
  {
    const std::optional<Sample> middle = middle_of(corners, {});
    return middle ? std::sqrt(CGAL::squared_distance(
                        middle->image,
                        CGAL::centroid(m_mesh.point(corners[0]), m_mesh.point(corners[1]), m_mesh.point(corners[2]))))
                  : 0;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_REMESHER_H
