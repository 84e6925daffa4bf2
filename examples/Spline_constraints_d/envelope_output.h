// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the programs for envelope surfaces have in common: operands from files, the counts as the last line, a picture
// with the surface, its cuspidal edges and the operands, or a file of triangles.
#ifndef ENVELOPE_OUTPUT_H
#define ENVELOPE_OUTPUT_H

#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Trimmed_envelope_surface_3.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using Kernel_of_operands = CGAL::Simple_cartesian<double>;
using Surface_operand = CGAL::Spline_constraints::Bspline_surface_3<Kernel_of_operands>;
using Curve_operand = CGAL::Spline_constraints::Bspline_curve_3<Kernel_of_operands>;

inline auto operands_in(const std::string& path)
{
  namespace IO = CGAL::Spline_constraints::IO;
  return path.ends_with(".g2") ? IO::read_g2<Kernel_of_operands>(path) : IO::read_IRIT<Kernel_of_operands>(path);
}

inline Surface_operand surface_in(const std::string& path)
{
  const auto file = operands_in(path);
  if (file.surfaces_3.empty())
    throw CGAL::Spline_constraints::Invalid_input(path + ": no surface");
  return file.surfaces_3.front().object;
}

// All of a file: the boundary of a solid.
inline std::vector<Surface_operand> surfaces_in(const std::string& path)
{
  std::vector<Surface_operand> result;
  for (const auto& surface : operands_in(path).surfaces_3)
    result.push_back(surface.object);
  if (result.empty())
    throw CGAL::Spline_constraints::Invalid_input(path + ": no surface");
  return result;
}

inline Curve_operand curve_in(const std::string& path)
{
  const auto file = operands_in(path);
  if (file.curves_3.empty())
    throw CGAL::Spline_constraints::Invalid_input(path + ": no curve in space");
  return file.curves_3.front().object;
}

// Of an operand, for pictures.
inline CGAL::Surface_mesh<Kernel_of_operands::Point_3> grid_on(const Surface_operand& surface, int steps = 24)
{
  CGAL::Surface_mesh<Kernel_of_operands::Point_3> result;
  const auto parameter = [&](int axis, int i) {
    const auto [begin, end] = surface.domain(axis);
    return i == steps ? end : begin + (end - begin) * i / steps;
  };
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      result.add_vertex(surface(parameter(0, i), parameter(1, j)));
  using Vertex = CGAL::Surface_mesh<Kernel_of_operands::Point_3>::Vertex_index;
  const auto at = [&](int i, int j) { return Vertex(static_cast<unsigned>(i * (steps + 1) + j)); };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      result.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      result.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return result;
}

// The surface in blue, of which the other side is orange, with boundaries, and cuspidal edges in red.
inline void add_envelope(CGAL::Spline_constraints::Scene_3& scene,
                         const CGAL::Spline_constraints::Solution_surface_mesh& mesh)
{
  scene.add(mesh.mesh,
            {.color = CGAL::IO::Color(150, 195, 235), .back = CGAL::IO::Color(240, 190, 120), .has_edges = false});
  for (const auto e : mesh.mesh.edges()) {
    const auto h = mesh.mesh.halfedge(e);
    const auto p = mesh.mesh.source(h), q = mesh.mesh.target(h);
    const auto is_cusp = [&](const auto v) { return mesh.unknowns[v].size() > 3 && mesh.unknowns[v].back() == 0; };
    const std::vector line{mesh.mesh.point(p), mesh.mesh.point(q)};
    if (mesh.is_feature[e] && !mesh.mesh.is_border(e) && is_cusp(p) && is_cusp(q))
      scene.add_polyline(line, {.color = "#c00020", .width = 3, .nearer = 0.02});
    else if (mesh.mesh.is_border(e))
      scene.add_polyline(line, {.color = "#335", .width = 1.5});
  }
}

// Prints what is undecided, and the counts as the last line: those of the surfaces of solutions, and behind them the
// Euler characteristic with seams and poles joined, if there are some. Exit status: 0 when nothing is undecided, or 3.
inline int print_envelope(const CGAL::Spline_constraints::Envelope_surface_3& surface)
{
  std::size_t components = 0, loops = 0, points = 0;
  int characteristic = 0;
  for (const auto& part : surface.parts()) {
    const auto& set = part.solutions;
    components += set.surfaces().size();
    loops += set.number_of_boundary_loops();
    points += set.points().size() + set.singular_points().size();
    characteristic += set.euler_characteristic();
  }
  for (const auto& part : surface.undecided())
    std::cout << part << '\n';
  const bool is_complete = surface.is_complete();
  const char* const least = is_complete ? "" : "at least ";
  std::cout << "surfaces: " << least << components << " components, Euler characteristic " << characteristic;
  if (characteristic != surface.euler_characteristic())
    std::cout << " (joined: " << surface.euler_characteristic() << ')';
  std::cout << ", " << loops << " boundary loops, " << least << points << " singular points, "
            << surface.undecided().size() << " undecided; complete: " << (is_complete ? "yes" : "no") << "; nodes "
            << surface.summary().nodes << "; seconds " << surface.summary().seconds << '\n';
  return is_complete ? 0 : 3;
}

// Of a trimmed surface: prints what is undecided, and in the last line the areas of triangles that are kept, removed
// and undecided, and the numbers of cells. Exit status: 0 when nothing is undecided, or 3.
inline int print_trimmed(const CGAL::Spline_constraints::Trimmed_envelope_surface_3& surface,
                         const CGAL::Spline_constraints::Solution_surface_mesh& trimmed,
                         const CGAL::Spline_constraints::Solution_surface_mesh& untrimmed)
{
  using Mesh = CGAL::Spline_constraints::Solution_surface_mesh::Mesh;
  using CGAL::Spline_constraints::Nearest_feet_label;
  const auto area = [](const Mesh& mesh, Mesh::Face_index f) {
    std::vector<Kernel_of_operands::Point_3> corners;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(mesh.point(v));
    return std::sqrt(CGAL::squared_area(corners[0], corners[1], corners[2]));
  };
  Mesh labelled = trimmed.mesh; // finding a map is different in CGAL 6, adding one that is there is not
  const auto labels = labelled.add_property_map<Mesh::Face_index, Nearest_feet_label>("f:label").first;
  double kept = 0, undecided = 0, all = 0;
  for (const auto f : trimmed.mesh.faces())
    (labels[f] == Nearest_feet_label::NEAREST ? kept : undecided) += area(trimmed.mesh, f);
  for (const auto f : untrimmed.mesh.faces())
    all += area(untrimmed.mesh, f);
  for (const auto& part : surface.undecided())
    std::cout << part << '\n';
  std::cout << "area kept " << kept << ", removed " << std::max(0.0, all - kept - undecided) << ", undecided "
            << undecided << "; " << surface << '\n';
  return surface.is_complete() ? 0 : 3;
}

// Two surfaces below and above what lies between them, from the side.
inline void draw_between(std::ostream& out, const Surface_operand& below, const Surface_operand& above,
                         const std::vector<CGAL::Spline_constraints::Solution_surface_mesh>& meshes,
                         double height_of_viewer = 0.3)
{
  CGAL::Spline_constraints::Scene_3 scene({.to_viewer = {-0.45, -0.85, height_of_viewer}, .most_splits = 20000});
  scene.add(grid_on(below), {.color = CGAL::IO::Color(215, 215, 215)});
  scene.add(grid_on(above), {.color = CGAL::IO::Color(230, 120, 110)});
  for (const auto& mesh : meshes) {
    scene.add(mesh.mesh, {.color = CGAL::IO::Color(150, 195, 235), .has_edges = false});
    for (const auto e : mesh.mesh.edges())
      if (const auto h = mesh.mesh.halfedge(e); mesh.mesh.is_border(e))
        scene.add_polyline(std::vector{mesh.mesh.point(mesh.mesh.source(h)), mesh.mesh.point(mesh.mesh.target(h))},
                           {.color = "#335", .width = 1.5, .nearer = 0.05});
  }
  scene.write(out);
}

// A bicubic surface over a square with these heights of its control points.
inline Surface_operand surface_of_heights(const std::vector<double>& heights)
{
  std::vector<Kernel_of_operands::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(2 * i - 3, 2 * j - 3, heights[static_cast<std::size_t>(4 * i + j)]);
  return Surface_operand({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
}

#endif // ENVELOPE_OUTPUT_H
