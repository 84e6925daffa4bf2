// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/opencascade.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

namespace SC = CGAL::Spline_constraints;
using E = Exact_cartesian;
using FT = Exact_rational;

// A closed curve with a double knot inside, and one at the seam that occurs once or more.
opencascade::handle<Geom2d_BSplineCurve> periodic_curve(int degree, int multiplicity_at_the_seam, bool is_rational)
{
  const std::vector<double> knots{0, 1, 1.5, 3, 4};
  TColStd_Array1OfReal own_knots(1, 5);
  TColStd_Array1OfInteger multiplicities(1, 5);
  int size = 0;
  for (int i = 1; i <= 5; ++i) {
    own_knots(i) = knots[static_cast<std::size_t>(i) - 1];
    multiplicities(i) = i == 1 || i == 5 ? multiplicity_at_the_seam : i == 3 ? 2 : 1;
    size += i < 5 ? multiplicities(i) : 0;
  }
  Random_source random(degree);
  TColgp_Array1OfPnt2d poles(1, size);
  TColStd_Array1OfReal weights(1, size);
  for (int i = 1; i <= size; ++i) {
    poles(i) = gp_Pnt2d(random.integer(-9, 9), random.integer(-9, 9));
    weights(i) = is_rational ? random.integer(1, 5) : 1;
  }
  return new Geom2d_BSplineCurve(poles, weights, own_knots, multiplicities, degree, true);
}

TEST(Opencascade, curves_have_the_same_points)
{
  for (const int degree : {2, 3})
    for (const int multiplicity : {1, 2})
      for (const bool is_rational : {false, true}) {
        const auto curve = periodic_curve(degree, multiplicity, is_rational);
        const auto spline = SC::to_bspline_curve<E>(*curve);
        EXPECT_EQ(spline.is_rational(), is_rational);
        EXPECT_TRUE(spline.is_closed());
        EXPECT_EQ(spline.domain(), (std::pair<FT, FT>(0, 4)));
        for (int i = 0; i <= 32; ++i) {
          const gp_Pnt2d p = curve->Value(i / 8.);
          const auto q = spline(FT(i) / 8);
          EXPECT_NEAR(p.X(), CGAL::to_double(q.x()), 1e-12) << degree << ' ' << multiplicity << ' ' << i;
          EXPECT_NEAR(p.Y(), CGAL::to_double(q.y()), 1e-12) << degree << ' ' << multiplicity << ' ' << i;
        }
        // There are no periodic curves of ours, so that the way back gives a closed one; ours again is the same map,
        // exactly.
        EXPECT_TRUE(SC::to_bspline_curve<E>(*SC::to_opencascade(spline)) == spline);
      }
}

TEST(Opencascade, curves_survive_the_way_there_and_back)
{
  Random_geometry random(3);
  for (int i = 0; i < 20; ++i) {
    // Control points and knots that are doubles.
    const int degree = random.integer(1, 4);
    std::vector<FT> knots(static_cast<std::size_t>(degree) + 1, FT(0)), weights;
    for (const int inner : {1, 3})
      knots.push_back(FT(inner));
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, FT(4));
    std::vector<E::Point_3> points;
    for (int k = 0; k < degree + 3; ++k) {
      points.emplace_back(random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9));
      weights.push_back(FT(random.integer(1, 9)));
    }
    const SC::Bspline_curve_3<E> curve(degree, knots, points, weights);
    const auto there = SC::to_opencascade(curve);
    EXPECT_EQ(there->NbPoles(), degree + 3);
    EXPECT_TRUE(SC::to_bspline_curve<E>(*there) == curve);
    const gp_Pnt p = there->Value(0.7);
    EXPECT_NEAR(p.Z(), CGAL::to_double(curve(FT(7) / 10).z()), 1e-12);
  }
  const auto circle = SC::circle_curve(CGAL::Simple_cartesian<double>::Point_2(1, 2), 3.);
  EXPECT_TRUE(SC::to_bspline_curve<CGAL::Simple_cartesian<double>>(*SC::to_opencascade(circle)) == circle);
  const SC::Bspline_curve_2<E> point(0, {0, 1}, {{2, 3}});
  expect_invalid([&] { SC::to_opencascade(point); }, "OpenCASCADE refuses");
}

TEST(Opencascade, surfaces_survive_the_way_there_and_back)
{
  const auto torus = SC::torus_surface(E::Point_3(0, 0, 0), FT(3), FT(1));
  const auto there = SC::to_opencascade(torus);
  const auto back = SC::to_bspline_surface<E>(*there);
  EXPECT_TRUE(back == torus);
  const gp_Pnt p = there->Value(0.3, 1.7);
  EXPECT_NEAR(p.X(), CGAL::to_double(torus(FT(3) / 10, FT(17) / 10).x()), 1e-12);
  // Periodic along its second axis: the knots and poles of a ring.
  opencascade::handle<Geom_BSplineSurface> ring = opencascade::handle<Geom_BSplineSurface>::DownCast(there->Copy());
  ring->SetVPeriodic();
  EXPECT_TRUE(ring->IsVPeriodic());
  const auto unwrapped = SC::to_bspline_surface<E>(*ring);
  EXPECT_TRUE(unwrapped.is_closed(1));
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) {
      const auto q = unwrapped(FT(i) / 2, FT(j) / 2);
      const gp_Pnt r = ring->Value(i / 2., j / 2.);
      EXPECT_NEAR(r.X(), CGAL::to_double(q.x()), 1e-12);
      EXPECT_NEAR(r.Z(), CGAL::to_double(q.z()), 1e-12);
    }
}

} // namespace
