// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors in space as rational surfaces with exact coefficients, drawn into rational_bisectors.svg: of a point and a
// bicubic surface; of a sphere and a point outside and inside of it, here with a polyhedron around the bisector; of two
// skew lines; of a point and a curve.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/supporting_polyhedra_3.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
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
using Range = SC::Rational_bisector_3::Range;
using Color = std::array<double, 3>;

const Color operand_color{190, 210, 235}, bisector_color{245, 190, 120};

// One example of the picture, moved to its place.
class Group
{
  Scene& m_scene;
  K::Aff_transformation_3 m_motion;

public:
  Group(Scene& scene, const K::Vector_3& place) : m_scene(scene), m_motion(CGAL::TRANSLATION, place) {}

  void add(const Surface& surface, const Color& color, int tiles)
  {
    m_scene.add(surface.transformed(m_motion), color, tiles);
  }

  void add(const Curve& curve)
  {
    std::vector<K::Point_3> points;
    const auto [begin, end] = curve.domain(0);
    for (int k = 0; k <= 40; ++k)
      points.push_back(m_motion(curve(begin + (end - begin) * k / 40)));
    m_scene.add(points, "#204080", 3, true);
  }

  void add(const K::Point_3& point) { m_scene.mark(m_motion(point), "#c00020"); }

  // Of each piece of a bisector, what is within a box of parameters, which has to be without poles.
  void add(const std::string& name, const SC::Rational_bisector_3& bisector, const std::array<Range, 2>& box, int tiles)
  {
    for (const auto& piece : bisector.pieces()) {
      std::array<Range, 2> part;
      for (const int axis : {0, 1})
        part[axis] = {std::max(box[axis].first, piece.domain()[axis].first),
                      std::min(box[axis].second, piece.domain()[axis].second)};
      if (part[0].first < part[0].second && part[1].first < part[1].second)
        add(Surface(piece.part(part)), bisector_color, tiles);
    }
    std::cout << name << ": degree (" << bisector.degree(0) << ',' << bisector.degree(1) << "), "
              << bisector.pieces().size() << (bisector.pieces().size() == 1 ? " piece, " : " pieces, ")
              << (bisector.is_free_of_poles() ? "no poles" : "poles possible") << '\n';
  }
};

Surface landscape()
{
  const double height[4][4] = {{0, 0.2, -0.3, 0}, {0.2, -0.6, 0.6, 0}, {0, 0.9, -0.6, 0}, {0.1, -0.1, 0.1, 0.2}};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i - 1.5 + 0.25 * height[j][i], j - 1.5 + 0.25 * height[3 - i][j], height[i][j]);
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  return Surface({3, 3}, knots, knots, points);
}

// On the screen, x to the right and y up.
K::Vector_3 place(double x, double y)
{
  const K::Vector_3 right = CGAL::cross_product(K::Vector_3(0, 0, 1), Scene::direction());
  return right * (x / std::sqrt(right.squared_length())) + K::Vector_3(0, 0, y);
}

int main()
{
  Scene scene;
  const std::array<Range, 2> all{Range(0, 4), Range(0, 4)};

  Group of_bicubic(scene, place(-4.5, 0));
  const K::Point_3 above(0, 0, 2);
  of_bicubic.add(landscape(), operand_color, 12);
  of_bicubic.add(above);
  of_bicubic.add("point and bicubic surface", SC::point_surface_bisector(above, landscape()), all, 18);

  Group outside(scene, place(0, 0));
  const Surface sphere = SC::sphere_surface<K>(K::Point_3(0, 0, 0), 1);
  const K::Point_3 outer(0, 0, 2.5);
  outside.add(sphere, operand_color, 12);
  outside.add(outer);
  const std::array<Range, 2> around_pole{Range(0, 4), Range(1.625, 2)};
  outside.add("point outside of a sphere", SC::point_surface_bisector(outer, sphere), around_pole, 6);

  Group inside(scene, place(3, 0));
  const K::Point_3 inner(0.25, -0.25, 0.5);
  for (const auto& half : {sphere.restricted(0, 0, 1), sphere.restricted(0, 3, 4)})   // that behind
    inside.add(half, operand_color, 8);
  inside.add(inner);
  inside.add("point inside of a sphere", SC::point_surface_bisector(inner, sphere), all, 5);
  const auto around = SC::supporting_polyhedron(inner, sphere, 5, 2.0);   // what the bisector is within
  std::cout << "a polyhedron around it: " << around.number_of_faces() << " faces, "
            << (CGAL::is_closed(around) ? "closed" : "open") << '\n';

  Group of_lines(scene, place(-3, -4));
  const Curve first = SC::bezier_curve(std::vector<K::Point_3>{{-1.5, 0, -0.5}, {1.5, 0, -0.5}}),
              second = SC::bezier_curve(std::vector<K::Point_3>{{0, -1.5, 0.5}, {0, 1.5, 0.5}});
  of_lines.add(first);
  of_lines.add(second);
  of_lines.add("two skew lines", SC::curve_bisector_surface(first, second), all, 11);

  Group of_curve(scene, place(2, -4));
  const Curve arch = SC::bezier_curve(std::vector<K::Point_3>{{-2, 0, -1}, {0, 0.5, 1.5}, {2, 0, -1}});
  const K::Point_3 below(0, 0, -1.5);
  of_curve.add(arch);
  of_curve.add(below);
  of_curve.add("point and parabola", SC::point_curve_bisector_surface(below, arch, {-0.2, 0.2}),
               {Range(0, 1), Range(-1, 1)}, 10);

  std::ofstream file("rational_bisectors.svg");
  scene.write(file);
  return file ? 0 : 1;
}
