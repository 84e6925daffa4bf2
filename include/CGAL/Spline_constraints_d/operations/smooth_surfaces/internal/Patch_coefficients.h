// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PATCH_COEFFICIENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PATCH_COEFFICIENTS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/simplex_conversion.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Neighborhood.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Oriented_mesh.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

using Form = Bernstein_simplex<Exact_rational, 3>;
using Coefficient_map = std::map<std::array<std::size_t, 3>, Exact_rational>; // by nodes in order

Simplex_vertices<3> coordinates_of(const std::array<const Exact_kernel::Point_3*, 4>& points);

inline Form::Barycentric barycentric_of(const Simplex_vertices<3>& vertices, const Exact_kernel::Point_3& p)
{
  return barycentric_coordinates<3>(vertices, {p.x(), p.y(), p.z()});
}

/*
The quadratic polynomial that default values are taken of, on the tetrahedron of a facet and an apex: zero at the
corners, with the mean slopes of their gradients along edges, their slopes towards the apex, and a value there.
*/
class Facet_quadric
{
  Simplex_vertices<3> m_vertices;
  std::array<std::array<Exact_rational, 4>, 4> m_coefficients;

public:
  Facet_quadric() = default;

  Facet_quadric(const Oriented_mesh& mesh, std::size_t facet, const Exact_kernel::Point_3& apex);

  const Exact_rational& apex_value() const { return m_coefficients[3][3]; }
  void set_apex_value(const Exact_rational& value) { m_coefficients[3][3] = value; }

  // The polar form.
  Exact_rational operator()(const Exact_kernel::Point_3& p, const Exact_kernel::Point_3& q) const
  {
    return form(barycentric_of(m_vertices, p), barycentric_of(m_vertices, q));
  }

  Exact_kernel::Vector_3 gradient_at_apex() const;

private:
  Exact_rational form(const Form::Barycentric& a, const Form::Barycentric& b) const;

  /*
  Such that the second derivative along the normal is half of the trace of those in the facet; but if the slope along
  the normal would change its sign, it goes down to a quarter; a and b are edges, n goes from the center to the apex.
  \pre The value at the apex is 0.
  */
  Exact_rational value_of_trace(const Exact_kernel::Vector_3& a, const Exact_kernel::Vector_3& b,
                                const Exact_kernel::Vector_3& n) const;
};

/*
The coefficients of all tetrahedra of a neighbourhood in closed form; equal nodes have one coefficient, so that pieces
fit. All affine functions that are the second and last argument of polar forms with both ends of an edge are one
function, so that derivatives fit around edges, too; within a facet by the split of Clough and Tocher, and one quadratic
function in each layer; across gaps by definition.
*/
class Patch_coefficients
{
  using Point = Exact_kernel::Point_3;
  using Vector = Exact_kernel::Vector_3;
  using FT = Exact_rational;

  const Oriented_mesh& m_mesh;
  const Neighborhood& m_neighborhood;
  const Smooth_surface_shape& m_shape;
  Coefficient_map m_values;
  std::vector<Facet_quadric> m_quadrics; // of both sides of all facets
  std::vector<Vector> m_slopes;          // across edges, of the function

public:
  // \throws Run_stopped when the run ends.
  Patch_coefficients(const Oriented_mesh& mesh, const Neighborhood& neighborhood, const Smooth_surface_shape& shape,
                     Common::Run_of_steps& run);

  const Coefficient_map& values() const { return m_values; }

  Form form_of(const Patch_place& patch) const;

private:
  static std::array<std::size_t, 3> key(std::size_t a, std::size_t b, std::size_t c);

  const FT& at(std::size_t a, std::size_t b, std::size_t c) const { return m_values.at(key(a, b, c)); }
  void set(std::size_t a, std::size_t b, std::size_t c, const FT& value) { m_values[key(a, b, c)] = value; }
  const Point& point(std::size_t node) const { return m_neighborhood.points[node]; }
  const Node_numbers& numbers() const { return m_neighborhood.numbers; }

  Vector slope_across(std::size_t e) const;

  // Twice the vertex, and the node.
  void set_at_vertex(std::size_t vertex, std::size_t node)
  {
    set(vertex, vertex, node, FT(m_mesh.gradients[vertex] * (point(node) - point(vertex))) / 3);
  }

  // Both ends of the edge, and the node.
  void set_at_edge(std::size_t e, std::size_t node);

  void fill_facet(std::size_t f);

  // What has the center and the node, or the center twice: from what has two corners and the node.
  void fill_center(std::size_t f, std::size_t node);

  void fill_apex(std::size_t f, int side);

  void fill_gap(std::size_t e, int side);

  // A third value; or one with which the second difference is a quarter of the first, if it would have another sign.
  static FT without_turn(const FT& first, const FT& second, const FT& third)
  {
    const FT slope = second - first;
    return (slope > 0 ? third > second : third < second) ? third : FT(second + slope / 4);
  }

  // The coefficient of the quadratic polynomial, as one of degree 3; but if the two facets have different ones, such
  // that the slope from the middle of the edge to the gap point keeps its sign.
  FT gap_value(std::size_t e, int side, int k) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Simplex_vertices<3>
coordinates_of(const std::array<const Exact_kernel::Point_3*, 4>& points)
{
  Simplex_vertices<3> result;
  for (int i = 0; i < 4; ++i)
    result[i] = {points[i]->x(), points[i]->y(), points[i]->z()};
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Facet_quadric::Facet_quadric(const Oriented_mesh& mesh, std::size_t facet,
                                                            const Exact_kernel::Point_3& apex)
{
  std::array<const Exact_kernel::Point_3*, 4> x;
  for (int i = 0; i < 3; ++i)
    x[i] = &mesh.points[mesh.facets[facet][i]];
  x[3] = &apex;
  m_vertices = coordinates_of(x);
  for (int i = 0; i < 3; ++i) {
    const auto& own = mesh.gradients[mesh.facets[facet][i]];
    m_coefficients[i][i] = Exact_rational(0);
    m_coefficients[i][3] = m_coefficients[3][i] = Exact_rational(own * (*x[3] - *x[i])) / 2;
    for (int j = 0; j < 3; ++j)
      if (j != i)
        m_coefficients[i][j] =
            Exact_rational(own * (*x[j] - *x[i]) + mesh.gradients[mesh.facets[facet][j]] * (*x[i] - *x[j])) / 4;
  }
  m_coefficients[3][3] = Exact_rational(0);
  m_coefficients[3][3] = value_of_trace(*x[1] - *x[0], *x[2] - *x[0], apex - CGAL::centroid(*x[0], *x[1], *x[2]));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_kernel::Vector_3 Facet_quadric::gradient_at_apex() const
{
  std::array<Exact_rational, 3> result;
  const Form::Barycentric origin = barycentric_of(m_vertices, {0, 0, 0}), apex{0, 0, 0, 1};
  for (int axis = 0; axis < 3; ++axis) {
    Form::Barycentric direction = barycentric_of(m_vertices, {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0});
    for (int i = 0; i < 4; ++i)
      direction[i] -= origin[i];
    result[axis] = 2 * form(apex, direction);
  }
  return {result[0], result[1], result[2]};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Facet_quadric::form(const Form::Barycentric& a,
                                                                  const Form::Barycentric& b) const
{
  Exact_rational result(0);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      result += m_coefficients[i][j] * a[i] * b[j];
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Facet_quadric::value_of_trace(const Exact_kernel::Vector_3& a,
                                                                            const Exact_kernel::Vector_3& b,
                                                                            const Exact_kernel::Vector_3& n) const
{
  const Form::Barycentric da{-1, 1, 0, 0}, db{-1, 0, 1, 0};
  const Exact_rational third = Exact_rational(1) / 3;
  const Form::Barycentric center{third, third, third, 0},
      dn{Exact_rational(-third), Exact_rational(-third), Exact_rational(-third), 1};
  const Exact_rational aa = a * a, ab = a * b, bb = b * b;
  const Exact_rational trace =
      (bb * form(da, da) - 2 * ab * form(da, db) + aa * form(db, db)) / Exact_rational(aa * bb - ab * ab);
  Exact_rational second = trace / 2 * Exact_rational(n * n); // halves of derivatives by a parameter that is 1 there
  const Exact_rational first = form(center, dn);
  if (first > 0 ? second <= -first : second >= -first)
    second = -first * 3 / 4;
  return second - form(dn, dn);
}

CGAL_SPLINE_CONSTRAINTS_INLINE
Patch_coefficients::Patch_coefficients(const Oriented_mesh& mesh, const Neighborhood& neighborhood,
                                       const Smooth_surface_shape& shape, Common::Run_of_steps& run)
  : m_mesh(mesh), m_neighborhood(neighborhood), m_shape(shape)
{
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    m_slopes.push_back(slope_across(e));
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    run.check();
    fill_facet(f);
    for (const int side : {OUTER, INNER})
      fill_apex(f, side);
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    run.check();
    for (const int side : {OUTER, INNER})
      fill_gap(e, side);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Form Patch_coefficients::form_of(const Patch_place& patch) const
{
  std::vector<FT> coefficients;
  for (Simplex_index<3> index(3); index.is_valid(); ++index) {
    std::vector<std::size_t> nodes;
    for (int i = 0; i < 4; ++i)
      nodes.insert(nodes.end(), index.exponent(i), patch.nodes[i]);
    coefficients.push_back(at(nodes[0], nodes[1], nodes[2]));
  }
  return Form(3, std::move(coefficients));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<std::size_t, 3> Patch_coefficients::key(std::size_t a, std::size_t b,
                                                                                  std::size_t c)
{
  std::array<std::size_t, 3> result{a, b, c};
  std::sort(result.begin(), result.end());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Patch_coefficients::Vector Patch_coefficients::slope_across(std::size_t e) const
{
  const auto& [p, q] = m_mesh.edges[e].ends;
  const Vector slope = (m_mesh.gradients[p] + m_mesh.gradients[q]) / FT(2);
  return m_shape.edge_gradient ? m_shape.edge_gradient(m_mesh.vertex_names[p], m_mesh.vertex_names[q], slope) : slope;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Patch_coefficients::set_at_edge(std::size_t e, std::size_t node)
{
  const auto& [p, q] = m_mesh.edges[e].ends;
  const Vector along = point(q) - point(p), to_node = point(node) - point(p);
  const FT share = FT(to_node * along) / FT(along * along);
  const FT at_source = FT(m_mesh.gradients[p] * along) / 3, at_target = FT(m_mesh.gradients[q] * along) / -3;
  set(p, q, node, at_source + (at_target - at_source) * share + FT(m_slopes[e] * (to_node - share * along)) / 3);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Patch_coefficients::fill_facet(std::size_t f)
{
  const auto& corners = m_mesh.facets[f];
  const std::size_t center = numbers().center(f);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      set_at_vertex(corners[i], corners[j]);
    set_at_vertex(corners[i], center);
    set_at_edge(m_mesh.edges_of_facets[f][i], center);
  }
  fill_center(f, center);
  set(center, center, center,
      (at(center, center, corners[0]) + at(center, center, corners[1]) + at(center, center, corners[2])) / 3);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Patch_coefficients::fill_center(std::size_t f, std::size_t node)
{
  const auto& corners = m_mesh.facets[f];
  const std::size_t center = numbers().center(f);
  for (int i = 0; i < 3; ++i)
    set(center, corners[i], node,
        (at(corners[i], corners[i], node) + at(corners[i], corners[(i + 1) % 3], node) +
         at(corners[i], corners[(i + 2) % 3], node)) /
            3);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Patch_coefficients::fill_apex(std::size_t f, int side)
{
  const auto& corners = m_mesh.facets[f];
  const std::size_t center = numbers().center(f), apex = numbers().apex(f, side);
  Facet_quadric& quadric = m_quadrics.emplace_back(m_mesh, f, point(apex));
  const Smooth_surface_shape::Apex place{m_mesh.facet_names[f], side == OUTER, point(apex)};
  if (m_shape.apex_value)
    quadric.set_apex_value(m_shape.apex_value(place, quadric.apex_value()));
  Vector gradient = quadric.gradient_at_apex();
  if (m_shape.apex_gradient)
    gradient = m_shape.apex_gradient(place, gradient);

  const FT& value = quadric.apex_value();
  set(apex, apex, apex, value);
  for (const std::size_t node : {corners[0], corners[1], corners[2], center})
    set(apex, apex, node, value + FT(gradient * (point(node) - point(apex))) / 3);
  for (int i = 0; i < 3; ++i) {
    set_at_vertex(corners[i], apex);
    set_at_edge(m_mesh.edges_of_facets[f][i], apex);
  }
  fill_center(f, apex);
  set(center, center, apex,
      (at(center, corners[0], apex) + at(center, corners[1], apex) + at(center, corners[2], apex)) / 3);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Patch_coefficients::fill_gap(std::size_t e, int side)
{
  const auto& [ends, facets] = m_mesh.edges[e];
  const std::size_t gap = numbers().gap(e, side);
  const std::array<std::size_t, 2> apexes{numbers().apex(facets[0], side), numbers().apex(facets[1], side)};
  for (const std::size_t v : ends)
    set_at_vertex(v, gap);
  set_at_edge(e, gap);
  for (int k = 0; k < 2; ++k) {
    const std::size_t apex = apexes[k];
    const std::array<std::size_t, 4> nodes{numbers().center(facets[k]), ends[0], ends[1], apex};
    const Form::Barycentric beta = barycentric_of(
        coordinates_of({&point(nodes[0]), &point(nodes[1]), &point(nodes[2]), &point(nodes[3])}), point(gap));
    for (const std::size_t m : {ends[0], ends[1], apex}) {
      FT sum(0);
      for (int i = 0; i < 4; ++i)
        sum += beta[i] * at(nodes[i], m, apex);
      set(gap, m, apex, sum);
    }
    set(gap, gap, apex, gap_value(e, side, k));
  }
  const FT& mu = m_shape.gap_position;
  for (const std::size_t m : {ends[0], ends[1], gap})
    set(gap, gap, m, mu * at(gap, m, apexes[0]) + (1 - mu) * at(gap, m, apexes[1]));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Patch_coefficients::FT Patch_coefficients::gap_value(std::size_t e, int side,
                                                                                    int k) const
{
  const auto& [ends, facets] = m_mesh.edges[e];
  const auto& [p, q] = ends;
  const std::size_t node = numbers().gap(e, side), apex_node = numbers().apex(facets[k], side);
  const Point &gap = point(node), &apex = point(apex_node);
  const Facet_quadric &quadric = m_quadrics[2 * facets[k] + side], &other = m_quadrics[2 * facets[1 - k] + side];
  const FT at_gap = quadric(gap, gap);
  FT value = (at_gap + 2 * quadric(gap, apex)) / 3;
  if (at_gap != other(gap, gap))
    value = without_turn((at(p, p, apex_node) + 2 * at(p, q, apex_node) + at(q, q, apex_node)) / 4,
                         (at(p, node, apex_node) + at(q, node, apex_node)) / 2, value);
  return m_shape.gap_value ? m_shape.gap_value({m_mesh.vertex_names[ends[0]], m_mesh.vertex_names[ends[1]],
                                                side == OUTER, m_mesh.facet_names[facets[k]], gap, apex},
                                               value)
                           : value;
}
#endif

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PATCH_COEFFICIENTS_H
