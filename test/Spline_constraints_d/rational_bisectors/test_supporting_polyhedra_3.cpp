// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Convex polyhedra around trimmed bisectors: no vertex is nearer to a sample than to the point, nor above a paraboloid.

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/supporting_polyhedra_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace supporting_polyhedra_3_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Number = SC::Exact_rational;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

namespace {

Exact::Point_3 converted(const Point& p) { return {Exact::FT(p.x()), Exact::FT(p.y()), Exact::FT(p.z())}; }

} // namespace

TEST(Supporting_polyhedra_3, around_a_paraboloid)
{
  const auto plane = SC::plane_patch<K>(Point(-2, -2, 0), Vector(4, 0, 0), Vector(0, 4, 0));
  const Point q(0, 0, 1);
  std::size_t faces = 0;
  for (const int samples : {3, 5, 9}) {
    const auto polyhedron = SC::supporting_polyhedron(q, plane, samples, Number(2));
    ASSERT_TRUE(CGAL::is_closed(polyhedron));
    EXPECT_GT(polyhedron.number_of_faces(), std::max<std::size_t>(faces, 6));
    faces = polyhedron.number_of_faces();
    for (int i = 0; i < samples; ++i)
      for (int j = 0; j < samples; ++j) {
        const Exact::Point_3 sample =
            converted(plane(Number(Number(i) / (samples - 1)), Number(Number(j) / (samples - 1))));
        for (const auto vertex : polyhedron.vertices())
          EXPECT_NE(CGAL::compare_distance_to_point(polyhedron.point(vertex), converted(q), sample), CGAL::LARGER);
      }
    // Inside of the cube, vertices are on planes that touch the paraboloid z = (x^2 + y^2 + 1) / 2: below it.
    std::size_t inner = 0;
    for (const auto vertex : polyhedron.vertices()) {
      const Exact::Point_3& p = polyhedron.point(vertex);
      if (CGAL::abs(p.x()) == 2 || CGAL::abs(p.y()) == 2 || p.z() == 3)
        continue;
      ++inner;
      EXPECT_LE(2 * p.z(), p.x() * p.x() + p.y() * p.y() + 1);
    }
    EXPECT_GE(inner, 4u);
  }
}

TEST(Supporting_polyhedra_3, bad_input)
{
  const auto sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  EXPECT_THROW(SC::supporting_polyhedron(Point(0, 0, 2), sphere, 1, Number(1)), SC::Invalid_input);
  EXPECT_THROW(SC::supporting_polyhedron(Point(0, 0, 2), sphere, 5, Number(0)), SC::Invalid_input);
  EXPECT_THROW(SC::supporting_polyhedron(Point(0, 0, 1), sphere, 5, Number(1)), SC::Invalid_input);
}

} // namespace supporting_polyhedra_3_test
