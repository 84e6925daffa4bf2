// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_MESH_OF_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_MESH_OF_SURFACE_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Surface_fibers.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

/*
The parts of a surface over flags are triangles, whose edges are cut into as many equal parts, in the weights of their
fibres. Points of sides belong to all flags there, and have their name: so neighbours share them, whatever was computed,
and the mesh is a subdivision of the one given.
*/
class Surface_mesher
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;
  using Mesh = Smooth_surface_mesh_3::Mesh;
  using Name = std::array<std::size_t, 4>;

  const Surface_data& m_data;
  Surface_fibers m_fibers;
  std::vector<Bernstein_simplex<double, 3>> m_forms;
  std::vector<Point> m_places;
  Common::Run_of_steps& m_run;

  int m_parts = 1; // of a side
  Smooth_surface_mesh_3 m_result;
  std::map<Name, Mesh::Vertex_index> m_vertices;

public:
  Surface_mesher(const Surface_data& data, Common::Run_of_steps& run) : m_data(data), m_fibers(data), m_run(run)
  {
    for (const Form& form : data.forms)
      m_forms.push_back(form.converted<double>([](const Exact_rational& x) { return CGAL::to_double(x); }));
    for (const auto& p : data.neighborhood.points)
      m_places.push_back(point_of(p));
  }

  // With sides cut into so many parts; nothing when the run ends before.
  std::optional<Smooth_surface_mesh_3> operator()(int parts)
  {
    m_parts = parts;
    m_result = Smooth_surface_mesh_3();
    m_vertices.clear();
    for (std::size_t f = 0; f < m_data.mesh.facets.size(); ++f)
      for (int corner = 0; corner < 3; ++corner)
        for (const int edge : {corner, (corner + 2) % 3})
          if (const Flag flag{f, corner, edge}; m_fibers.is_certified(flag) && !add_flag(flag))
            return std::nullopt;
    return std::move(m_result);
  }

private:
  static Point point_of(const Exact_kernel::Point_3& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // Rows are at equal weights of the corner.
  bool add_flag(const Flag& flag)
  {
    for (int row = 0; row < m_parts; ++row) {
      if (m_run.must_stop())
        return false;
      for (int i = 0; i <= row; ++i) {
        add_triangle(flag, {vertex(flag, row, i), vertex(flag, row + 1, i), vertex(flag, row + 1, i + 1)},
                     {row + 2.0 / 3, i + 1.0 / 3});
        if (i < row)
          add_triangle(flag, {vertex(flag, row, i), vertex(flag, row + 1, i + 1), vertex(flag, row, i + 1)},
                       {row + 1.0 / 3, i + 2.0 / 3});
      }
    }
    return true;
  }

  void add_triangle(const Flag& flag, std::array<Mesh::Vertex_index, 3> corners, const std::array<double, 2>& middle)
  {
    // by the edge from the corner the triangle of corner, middle of the edge and center is counterclockwise
    if (!flag.is_edge_from_corner())
      std::swap(corners[1], corners[2]);
    auto face = m_result.mesh.add_face(corners[0], corners[1], corners[2]);
    if (face == Mesh::null_face()) { // where pieces are left out, the others at a vertex may be several fans
      for (Mesh::Vertex_index& corner : corners)
        add_vertex(corner, Point(m_result.mesh.point(corner)), Vector(m_result.normals[corner]));
      face = m_result.mesh.add_face(corners[0], corners[1], corners[2]);
    }
    m_result.face[face] = m_data.mesh.facet_names[flag.facet];
    const Point p = m_result.mesh.point(corners[0]), q = m_result.mesh.point(corners[1]),
                r = m_result.mesh.point(corners[2]);
    const Vector normal = CGAL::cross_product(q - p, r - p);
    const auto rounded = [&](double x) { return std::round(x / m_parts * 0x1p30) * 0x1p-30; };
    const double b_and_c = rounded(middle[0]), c = rounded(middle[1]);
    const Point on_surface = place_of(m_fibers(flag, {1 - b_and_c, b_and_c - c, c}));
    const double length = std::sqrt(normal.squared_length());
    if (length > 0)
      m_result.error = (std::max)(m_result.error, std::abs(normal * (on_surface - p)) / length);
  }

  // The weights of middle of the edge and center are row / m_parts together, of the center i / m_parts.
  Mesh::Vertex_index vertex(const Flag& flag, int row, int i)
  {
    const auto [known, is_new] = m_vertices.try_emplace(name_of(flag, row, i));
    if (!is_new)
      return known->second;
    m_run.add_nodes(1);
    const std::size_t corner = m_data.mesh.facets[flag.facet][flag.corner];
    if (row == 0) {
      const auto& gradient = m_data.mesh.gradients[corner];
      add_vertex(known->second, m_places[corner],
                 {CGAL::to_double(gradient.x()), CGAL::to_double(gradient.y()), CGAL::to_double(gradient.z())});
    } else {
      const double whole = m_parts;
      const Surface_point point = m_fibers(flag, {(m_parts - row) / whole, (row - i) / whole, i / whole});
      add_vertex(known->second, place_of(point), gradient_at(point));
    }
    return known->second;
  }

  void add_vertex(Mesh::Vertex_index& vertex, const Point& point, const Vector& normal)
  {
    vertex = m_result.mesh.add_vertex(point);
    m_result.normals[vertex] = normal / std::sqrt(normal.squared_length());
  }

  // One for all flags that have the point on their sides.
  Name name_of(const Flag& flag, int row, int i) const
  {
    const std::size_t facet = flag.facet, edge = m_data.mesh.edges_of_facets[facet][flag.edge],
                      corner = m_data.mesh.facets[facet][flag.corner], at = i;
    const bool has_corner = row<m_parts, has_center = i> 0, has_middle = i < row;
    if (!has_middle && !has_center)
      return {0, corner, 0, 0};
    if (!has_corner && !has_center)
      return {1, edge, 0, 0};
    if (!has_corner && !has_middle)
      return {2, facet, 0, 0};
    if (!has_center)
      return {3, edge, corner, static_cast<std::size_t>(row)};
    if (!has_middle)
      return {4, facet, corner, at};
    if (!has_corner)
      return {5, facet, edge, at};
    return {6 + 6 * facet + 2 * flag.corner + (flag.is_edge_from_corner() ? 0 : 1), static_cast<std::size_t>(row), at,
            0};
  }

  Point place_of(const Surface_point& point) const
  {
    const auto& nodes = m_data.neighborhood.patches[point.patch].nodes;
    Vector sum(0, 0, 0);
    for (int i = 0; i < 4; ++i)
      sum = sum + point.barycentric[i] * (m_places[nodes[i]] - CGAL::ORIGIN);
    return CGAL::ORIGIN + sum;
  }

  Vector gradient_at(const Surface_point& point) const
  {
    const auto& nodes = m_data.neighborhood.patches[point.patch].nodes;
    const Point& origin = m_places[nodes[0]];
    const Vector u = m_places[nodes[1]] - origin, v = m_places[nodes[2]] - origin, w = m_places[nodes[3]] - origin;
    const auto slope = [&](int i) { return m_forms[point.patch].derivative(0, i)(point.barycentric); };
    return (slope(1) * CGAL::cross_product(v, w) + slope(2) * CGAL::cross_product(w, u) +
            slope(3) * CGAL::cross_product(u, v)) /
        CGAL::determinant(u, v, w);
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Smooth_surface_mesh_3 mesh_of_surface(const Surface_data& data,
                                                                     const Smooth_surface_fineness& fineness,
                                                                     const Solver_options& options)
{
  if (!(fineness.chord_error > 0) || fineness.most_halvings < 0 || fineness.most_halvings > 12)
    throw Invalid_input("to_surface_mesh: the chord error must be positive, the number of halvings from 0 to 12");
  Common::Run_of_steps run(options);
  Surface_mesher mesher(data, run);
  Smooth_surface_mesh_3 result;
  bool is_fine = false;
  for (int halvings = 0; halvings <= fineness.most_halvings && !is_fine; ++halvings) {
    auto finer = mesher(1 << halvings);
    if (!finer)
      break;
    result = std::move(*finer);
    is_fine = result.error <= fineness.chord_error;
  }
  result.undecided_parts = data.undecided;
  if (run.is_stopped())
    result.undecided_parts.push_back({{}, {}, in_words(run.reason())});
  else if (!is_fine)
    result.undecided_parts.push_back({{}, {}, "coarser than the chord error after the most halvings"});
  result.work = run.summary(result.is_complete());
  return result;
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_MESH_OF_SURFACE_H
