// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws surfaces as tiles in parallel projection, those behind first, with curves on them.
#ifndef SURFACE_SCENE_H
#define SURFACE_SCENE_H

#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

class Scene
{
  using K = CGAL::Simple_cartesian<double>;
  using Surface = CGAL::Spline_constraints::Bspline_surface_3<K>;

  struct Patch
  {
    double depth;
    std::vector<K::Point_2> corners;   // two of a chord, one of a mark
    std::string color;
    double width = 0;
  };

  std::vector<Patch> m_patches, m_hidden;
  CGAL::Bbox_2 m_box;

  static constexpr int default_tiles = 28;   // per axis
  static constexpr double turn = 0.52, rise = 0.6;

public:
  // To the viewer, who looks from above, turned by 30 degrees.
  static K::Vector_3 direction()
  {
    return {-std::cos(rise) * std::sin(turn), -std::cos(rise) * std::cos(turn), std::sin(rise)};
  }

  // What goes to the right in the picture.
  static K::Vector_3 to_the_right() { return {std::cos(turn), -std::sin(turn), 0}; }

  void add(const Surface& surface, const std::array<double, 3>& color, int tiles = default_tiles)
  {
    const auto point = [&](int i, int j) {
      const auto at = [&](int axis, int k) {
        return std::lerp(surface.domain(axis).first, surface.domain(axis).second, static_cast<double>(k) / tiles);
      };
      return surface(at(0, i), at(1, j));
    };
    for (int i = 0; i < tiles; ++i)
      for (int j = 0; j < tiles; ++j) {
        const std::vector<K::Point_3> corners{point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)};
        const K::Vector_3 normal = CGAL::cross_product(corners[2] - corners[0], corners[3] - corners[1]);
        add_patch(corners, shaded(color, light_on(normal)), 0);
      }
  }

  // Both sides of a mesh.
  void add(const CGAL::Surface_mesh<K::Point_3>& mesh, const std::array<double, 3>& color)
  {
    for (const auto face : mesh.faces()) {
      std::vector<K::Point_3> corners;
      for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
        corners.push_back(mesh.point(vertex));
      add_patch(corners, shaded(color, light_on(CGAL::normal(corners[0], corners[1], corners[2]))), 0);
    }
  }

  // The triangles of a mesh that show their back.
  void add_backs(const CGAL::Surface_mesh<K::Point_3>& mesh, const std::array<double, 3>& color)
  {
    for (const auto face : mesh.faces()) {
      std::vector<K::Point_3> corners;
      for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
        corners.push_back(mesh.point(vertex));
      const K::Vector_3 normal = CGAL::normal(corners[0], corners[1], corners[2]);
      if (normal * direction() < 0)
        add_patch(corners, shaded(color, light_on(normal)), 0);
    }
  }

  // A polygon on a surface, for what is between triangles that are drawn on it; those of a higher level are on top.
  void add_ground(const std::vector<K::Point_3>& polygon, const K::Vector_3& normal,
                  const std::array<double, 3>& color, int level)
  {
    constexpr double far_away = 1e6;
    add_patch(polygon, shaded(color, light_on(normal)), level - far_away);
  }

  // On the surfaces: nearer than their tiles. What these hide is left out, or drawn as a thin line.
  void add(const std::vector<K::Point_3>& polyline, const std::string& color, double width = 3,
           bool shows_hidden = false)
  {
    const double tile = (m_box.xmax() - m_box.xmin()) / default_tiles;
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
      add_patch({polyline[i], polyline[i + 1]}, color, 1.5 * tile, width);
      if (shows_hidden)
        m_hidden.push_back(m_patches.back());
    }
  }

  // In front of all.
  void mark(const K::Point_3& point, const std::string& color)
  {
    add_patch({point}, color, std::numeric_limits<double>::infinity(), 10);
  }

  void write(std::ostream& out)
  {
    const double margin = (m_box.xmax() - m_box.xmin()) / 40;
    CGAL::Spline_constraints::SVG_writer picture(
        out, CGAL::Bbox_2(m_box.xmin() - margin, m_box.ymin() - margin, m_box.xmax() + margin, m_box.ymax() + margin),
        640);
    std::stable_sort(m_patches.begin(), m_patches.end(),
                     [](const Patch& a, const Patch& b) { return a.depth < b.depth; });
    for (const Patch& patch : m_patches)
      if (patch.corners.size() == 1)
        picture.point(patch.corners[0], patch.color, patch.width);
      else if (patch.corners.size() == 2)
        picture.curve(CGAL::Spline_constraints::polyline_curve(patch.corners), patch.color, patch.width);
      else
        picture.polygon(patch.corners, patch.color);
    for (const Patch& patch : m_hidden)
      picture.curve(CGAL::Spline_constraints::polyline_curve(patch.corners), patch.color, 0.8);
  }

private:
  static double light_on(const K::Vector_3& normal)
  {
    return 0.45 + 0.55 * std::abs(normal * K::Vector_3(0.2, -0.4, 0.9)) / std::sqrt(normal.squared_length());
  }

  static std::string shaded(const std::array<double, 3>& color, double light)
  {
    std::string result = "#";
    for (const double part : color)
      for (const int digit : {static_cast<int>(part * light) / 16, static_cast<int>(part * light) % 16})
        result += "0123456789abcdef"[digit];
    return result;
  }

  void add_patch(const std::vector<K::Point_3>& corners, const std::string& color, double nearer, double width = 0)
  {
    const double grid = corners.size() <= 2 ? 1024 : 100;   // for short numbers in the file
    Patch patch{nearer, {}, color, width};
    for (const K::Point_3& p : corners) {
      const double across = std::cos(turn) * p.x() - std::sin(turn) * p.y(),
                   away = std::sin(turn) * p.x() + std::cos(turn) * p.y();
      patch.corners.emplace_back(std::round(grid * across) / grid,
                                 std::round(grid * (std::cos(rise) * p.z() + std::sin(rise) * away)) / grid);
      patch.depth += (std::sin(rise) * p.z() - std::cos(rise) * away) / static_cast<double>(corners.size());
      m_box += patch.corners.back().bbox();
    }
    m_patches.push_back(patch);
  }
};

#endif // SURFACE_SCENE_H
