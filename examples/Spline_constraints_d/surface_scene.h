// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws surfaces, as tiles, and meshes in parallel projection, with curves on them.
#ifndef SURFACE_SCENE_H
#define SURFACE_SCENE_H

#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

class Scene
{
  using K = CGAL::Simple_cartesian<double>;
  using Surface = CGAL::Spline_constraints::Bspline_surface_3<K>;
  using Mesh = CGAL::Surface_mesh<K::Point_3>;
  using Color = std::array<double, 3>;

  static constexpr int default_tiles = 28;   // per axis
  static constexpr double turn = 0.52, rise = 0.6;

  CGAL::Spline_constraints::Scene_3 m_scene{
      {.to_viewer = {-std::cos(rise) * std::sin(turn), -std::cos(rise) * std::cos(turn), std::sin(rise)}}};
  double m_extent = 0;   // of the largest surface

public:
  // To the viewer, who looks from above, turned by 30 degrees.
  static K::Vector_3 direction()
  {
    return {-std::cos(rise) * std::sin(turn), -std::cos(rise) * std::cos(turn), std::sin(rise)};
  }

  // What goes to the right in the picture.
  static K::Vector_3 to_the_right() { return {std::cos(turn), -std::sin(turn), 0}; }

  void add(const Surface& surface, const Color& color, int tiles = default_tiles)
  {
    const auto point = [&](int i, int j) {
      const auto at = [&](int axis, int k) {
        return std::lerp(surface.domain(axis).first, surface.domain(axis).second, static_cast<double>(k) / tiles);
      };
      return surface(at(0, i), at(1, j));
    };
    std::vector<std::array<K::Point_3, 3>> triangles;
    for (int i = 0; i < tiles; ++i)
      for (int j = 0; j < tiles; ++j) {
        triangles.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
        triangles.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
      }
    constexpr double crease = 40;
    add(triangles, color, crease);
  }

  void add(const Mesh& mesh, const Color& color)
  {
    std::vector<std::array<K::Point_3, 3>> triangles;
    for (const auto face : mesh.faces()) {
      const auto halfedge = mesh.halfedge(face);
      triangles.push_back({mesh.point(mesh.source(halfedge)), mesh.point(mesh.target(halfedge)),
                           mesh.point(mesh.target(mesh.next(halfedge)))});
    }
    add(triangles, color, 180);   // needles at poles are no creases
  }

  // On the surfaces: nearer than their tiles. What these hide is left out, or drawn as a thin line.
  void add(const std::vector<K::Point_3>& polyline, const std::string& color, double width = 3,
           bool shows_hidden = false)
  {
    using CGAL::Spline_constraints::Hidden_line;
    m_scene.add_polyline(polyline, {.color = color,
                                    .width = width,
                                    .hidden = shows_hidden ? Hidden_line::THIN : Hidden_line::LEFT_OUT,
                                    .nearer = m_extent / default_tiles});
  }

  // Seen also where it is hidden.
  void mark(const K::Point_3& point, const std::string& color)
  {
    m_scene.add_point(point, {.color = color,
                              .width = 10,
                              .hidden = CGAL::Spline_constraints::Hidden_line::THIN,
                              .nearer = m_extent / default_tiles});
  }

  void write(std::ostream& out) const { m_scene.write(out); }

private:
  // Corners that are equal but for rounding are one vertex: a closed surface has no boundary, a pole is a point.
  void add(const std::vector<std::array<K::Point_3, 3>>& triangles, const Color& color, double crease)
  {
    CGAL::Bbox_3 box;
    for (const auto& triangle : triangles)
      box += CGAL::bbox_3(triangle.begin(), triangle.end());
    const double extent = std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    m_extent = std::max(m_extent, extent);
    Mesh mesh;
    std::map<std::array<long long, 3>, Mesh::Vertex_index> vertices;
    const auto vertex = [&](const K::Point_3& p) {
      const double unit = 1.234e-8 * extent;
      const auto found = vertices.try_emplace({std::llround(p.x() / unit), std::llround(p.y() / unit),
                                               std::llround(p.z() / unit)});
      if (found.second)
        found.first->second = mesh.add_vertex(p);
      return found.first->second;
    };
    for (const auto& [a, b, c] : triangles)
      if (const auto i = vertex(a), j = vertex(b), k = vertex(c); i != j && j != k && k != i)
        if (mesh.add_face(i, j, k) == Mesh::null_face())   // where surfaces meet in more than edges
          mesh.add_face(mesh.add_vertex(a), mesh.add_vertex(b), mesh.add_vertex(c));
    const auto part = [](double x) { return static_cast<unsigned char>(std::min(x, 255.)); };
    const CGAL::IO::Color color_of_sides(part(color[0]), part(color[1]), part(color[2]));
    m_scene.add(mesh, {.color = color_of_sides, .back = color_of_sides, .crease = crease});
  }
};

#endif // SURFACE_SCENE_H
