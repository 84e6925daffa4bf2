// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the programs for bisectors in space have in common: operands from files, pictures with several groups, meshes as
// files, the line that sums up.
#ifndef BISECTOR_SCENE_H
#define BISECTOR_SCENE_H

#include "arguments.h"
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/bisector_parts_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Curve = SC::Bspline_curve_3<K>;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Color = std::array<double, 3>;

const Color operand_color{190, 210, 235}, bisector_color{245, 190, 120};

// Options of the programs, and the other words.
struct Bisector_arguments
{
  std::vector<std::string> words;
  std::string output;
  double reach = 0, error = 0; // of the mesh; 0: by the size of the operands
  SC::Solver_options options{.tolerance = 1e-8};

  Bisector_arguments(int argc, char* argv[])
  {
    const std::vector<std::string> all = arguments_and_time_limit(argc, argv, options);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i] == "--output" && i + 1 < all.size())
        output = all[++i];
      else if (all[i] == "--reach" && i + 1 < all.size())
        reach = number_of<double>(all[++i]);
      else if (all[i] == "--error" && i + 1 < all.size())
        error = number_of<double>(all[++i]);
      else
        words.push_back(all[i]);
  }
};

inline Surface read_surface(const std::string& path)
{
  const auto file = SC::IO::read_g2<K>(path);
  if (file.surfaces_3.empty())
    throw SC::Invalid_input(path + ": no surface");
  return file.surfaces_3.front().object;
}

inline Curve read_curve(const std::string& path)
{
  const auto file = SC::IO::read_g2<K>(path);
  if (file.curves_3.empty())
    throw SC::Invalid_input(path + ": no curve in space");
  return file.curves_3.front().object;
}

// A ball around points that is a few times as large as their box.
inline K::Sphere_3 reach_around(const std::vector<K::Point_3>& points, double reach)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const K::Point_3 center(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                          0.5 * (box.zmin() + box.zmax()));
  const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const double radius = reach > 0 ? reach : 2 * diagonal;
  return {center, radius * radius};
}

inline std::vector<K::Point_3> points_of(const Surface& surface)
{
  std::vector<K::Point_3> result;
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 16; ++j) {
      const auto at = [&](int axis, int k) {
        return std::lerp(surface.domain(axis).first, surface.domain(axis).second, k / 16.0);
      };
      result.push_back(surface(at(0, i), at(1, j)));
    }
  return result;
}

inline std::vector<K::Point_3> points_of(const Curve& curve)
{
  std::vector<K::Point_3> result;
  for (int i = 0; i <= 64; ++i)
    result.push_back(curve(std::lerp(curve.domain(0).first, curve.domain(0).second, i / 64.0)));
  return result;
}

// One example of a picture, moved to its place.
class Group
{
  Scene& m_scene;
  K::Aff_transformation_3 m_motion;

public:
  Group(Scene& scene, const K::Vector_3& place) : m_scene(scene), m_motion(CGAL::TRANSLATION, place) {}

  // On the screen, x to the right and y up.
  static K::Vector_3 place(double x, double y)
  {
    const K::Vector_3 right = CGAL::cross_product(K::Vector_3(0, 0, 1), Scene::direction());
    return right * (x / std::sqrt(right.squared_length())) + K::Vector_3(0, 0, y);
  }

  void add(const Surface& surface, int tiles = 16) { m_scene.add(surface.transformed(m_motion), operand_color, tiles); }

  void add(const Curve& curve)
  {
    std::vector<K::Point_3> points = points_of(curve);
    for (K::Point_3& point : points)
      point = m_motion(point);
    m_scene.add(points, "#204080", 3, true);
  }

  void add(const K::Point_3& point) { m_scene.mark(m_motion(point), "#c00020"); }

  void add(Mesh mesh, const Color& color = bisector_color)
  {
    for (const auto vertex : mesh.vertices())
      mesh.point(vertex) = m_motion(mesh.point(vertex));
    m_scene.add(mesh, color);
  }
};

// The regions of parts that have a label, as one mesh.
inline Mesh mesh_of(const std::vector<SC::Trimmed_surface_3>& parts, const std::vector<int>& labels, double error)
{
  Mesh result;
  for (const SC::Trimmed_surface_3& part : parts)
    for (const int label : labels)
      result += SC::to_surface_mesh(part, label, error).mesh;
  return result;
}

// The bisector within a sphere, and a line about it; the number of parts is that between the poles.
inline Mesh show(const std::string& name, const SC::Rational_bisector_3& bisector, const K::Sphere_3& reach)
{
  std::size_t parts = 0;
  for (const SC::Trimmed_surface_3& surface : SC::bisector_parts(bisector))
    parts += surface.number_of_regions(SC::WITH_POSITIVE_WEIGHT) + surface.number_of_regions(SC::WITH_NEGATIVE_WEIGHT);
  std::cout << name << ": degree (" << bisector.degree(0) << ',' << bisector.degree(1) << "), " << parts
            << (parts == 1 ? " part\n" : " parts\n");
  return mesh_of(SC::bisector_parts(bisector, reach), {SC::WITH_POSITIVE_WEIGHT, SC::WITH_NEGATIVE_WEIGHT}, 0.06);
}

#endif // BISECTOR_SCENE_H
