// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Self-bisectors: axes of symmetry of conics, ends at centers of curvature in all vertices, and every point at the same
// distance along both normals.

#include "pair_locus_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/bitangents_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/self_bisector_curves_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace self_bisector_curves_2_test {

namespace {

using Function = SC::Bspline_function<SC::Exact_rational>;

// The ellipse with these semi-axes as one rational polynomial of degree 4 on [0,1]: the squares of complex numbers
// z(t), over |z|^2.
Curve ellipse(int a, int b)
{
  const Function x({2}, {{0, 0, 0, 1, 1, 1}}, {1, 0, -1}), y({2}, {{0, 0, 0, 1, 1, 1}}, {0, 2, 0}), xx = x * x,
                                                                                                    yy = y * y;
  return Curve::from_homogeneous_coordinates({(xx - yy) * SC::Exact_rational(a), x * y * SC::Exact_rational(2 * b)},
                                             xx + yy);
}

// Calls check(x, y) for points of all curves, which are at the same distance from the curve along both normals; not for
// those on the diagonal and at common ends of pieces, which are exactly there.
template <class Check>
void check_points(const Locus& locus, const Curve& curve, const Check& check)
{
  visit_points(locus, curve, curve, [&](const Vector& p, const std::array<Foot, 2>& feet) {
    EXPECT_NEAR(checked_distance(p, feet[0]), checked_distance(p, feet[1]), 1e-10 * (1 + p[0] * p[0] + p[1] * p[1]));
    check(p[0], p[1]);
  });
}

// The ends of curves on the diagonal, which includes the seam of a closed curve, with the errors of their distances
// from the centers of curvature.
std::vector<double> errors_on_diagonal(const Locus& locus, const Curve& c)
{
  std::vector<double> result;
  for (const Locus::Curve& curve : locus.curves()) {
    const auto samples = locus.polyline(curve, 1e-2, 10);
    for (const auto* sample : {&samples.front(), &samples.back()})
      if (const auto [u, v] = sample->parameters;
          u == v || (c.is_closed() && u == c.domain().first && v == c.domain().second)) {
        const auto derivatives = c.derivatives(u, 2);
        const SC::Exact_rational factor(
            derivatives[1].squared_length() /
            (derivatives[1].x() * derivatives[2].y() - derivatives[1].y() * derivatives[2].x()));
        const Vector center =
                         rounded(Point(c(u).x() - factor * derivatives[1].y(), c(u).y() + factor * derivatives[1].x())),
                     p = rounded(sample->point);
        result.push_back(std::hypot(p[0] - center[0], p[1] - center[1]) / (1 + std::hypot(p[0], p[1])));
      }
  }
  return result;
}

// Those that are not ends of an open curve.
std::size_t number_of_vertices(const Curve& c)
{
  const auto extremes = SC::curvature_extremes(c).features();
  return static_cast<std::size_t>(std::count_if(extremes.begin(), extremes.end(), [&](const auto& extreme) {
    const auto& [begin, end] = extreme.point_on_curve().parameter_range();
    return (extreme.kind() == SC::Curve_feature_kind::MAXIMUM || extreme.kind() == SC::Curve_feature_kind::MINIMUM) &&
        (c.is_closed() || (c.domain().first < begin && end < c.domain().second));
  }));
}

// One end on the diagonal for each vertex, in its center of curvature; and a pole for each line that touches the curve
// twice.
void check_topology(const Locus& locus, const Curve& curve)
{
  EXPECT_TRUE(locus.is_complete()) << locus;
  check_points(locus, curve, [](double, double) {});
  const std::vector<double> errors = errors_on_diagonal(locus, curve);
  EXPECT_EQ(errors.size(), number_of_vertices(curve));
  for (const double error : errors)
    EXPECT_NEAR(error, 0, 1e-9);
  EXPECT_EQ(locus.number_of_poles(), SC::bitangents(curve).bitangents().size());
}

} // namespace

TEST(Self_bisector_curves_2, parabola_has_its_axis)
{
  const Curve parabola = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}});   // y = x^2
  const Locus locus = SC::self_bisector_curves(parabola);
  expect_numbers(locus, 0, 1, 0, 0);
  double lowest = 9, highest = 0;
  check_points(locus, parabola, [&](double x, double y) {
    EXPECT_NEAR(x, 0, 1e-12);
    lowest = (std::min)(lowest, y);
    highest = (std::max)(highest, y);
  });
  EXPECT_NEAR(lowest, 0.5, 1e-14);    // the center of curvature
  EXPECT_NEAR(highest, 1.5, 1e-14);   // x^2 + 1/2 for the ends of the curve
  EXPECT_EQ(errors_on_diagonal(locus, parabola).size(), 1u);
}

// Of each axis the part between the centers of curvature: (+-3/2, 0) and (0, +-3). The other axis goes through the
// seam.
TEST(Self_bisector_curves_2, ellipse_has_its_axes)
{
  const Curve curve = ellipse(2, 1);
  const Locus locus = SC::self_bisector_curves(curve);
  expect_numbers(locus, 0, 2, 0, 0);
  double width = 0, height = 0;
  check_points(locus, curve, [&](double x, double y) {
    EXPECT_NEAR(x * y, 0, 1e-11);
    width = (std::max)(width, std::abs(x));
    height = (std::max)(height, std::abs(y));
  });
  EXPECT_NEAR(width, 1.5, 1e-12);
  EXPECT_NEAR(height, 3, 1e-12);
}

// All circles inside of the same circle touch it: undecided, as a whole.
TEST(Self_bisector_curves_2, circles_and_lines)
{
  for (const Curve& circle : {ellipse(1, 1), SC::to_bspline_curve(K::Circle_2(Point(1, 2), 9))}) {
    const Locus locus = SC::self_bisector_curves(circle);
    EXPECT_FALSE(locus.is_complete());
    EXPECT_TRUE(locus.curves().empty());
    ASSERT_FALSE(locus.undecided().empty());
    for (const SC::Undecided_region& region : locus.undecided_regions())
      EXPECT_EQ(region.reason, SC::Undecided_reason::CONTINUUM);
  }
  expect_numbers(SC::self_bisector_curves(SC::polyline_curve(std::vector<Point>{{0, 0}, {3, 1}})), 0, 0, 0, 0);
}

// The bisectors of the angles of a triangle, which begin in the corners.
TEST(Self_bisector_curves_2, triangle)
{
  const std::vector<Point> corners{{0, 0}, {4, 0}, {1, 3}, {0, 0}};
  const Curve triangle = SC::polyline_curve(corners);
  const Locus locus = SC::self_bisector_curves(triangle);
  EXPECT_TRUE(locus.is_complete()) << locus;
  std::array<double, 3> nearest{9, 9, 9};
  for (const Locus::Curve& curve : locus.curves())
    for (const auto& sample : locus.polyline(curve, 1e-2, 10)) {
      const auto [x, y] = rounded(sample.point);
      const std::array<double, 3> d{y, (12 - 3 * x - 3 * y) / std::sqrt(18.0), (3 * x - y) / std::sqrt(10.0)};
      EXPECT_NEAR((d[0] * d[0] - d[1] * d[1]) * (d[1] * d[1] - d[2] * d[2]) * (d[2] * d[2] - d[0] * d[0]), 0, 1e-9);
      for (std::size_t i = 0; i < 3; ++i)
        nearest[i] = (std::min)(nearest[i], std::hypot(x - rounded(corners[i])[0], y - rounded(corners[i])[1]));
    }
  for (const double distance : nearest)
    EXPECT_NEAR(distance, 0, 1e-12);
}

// Rational rigid motions change no numbers.
TEST(Self_bisector_curves_2, random_cubics)
{
  std::mt19937 random(4);
  const K::Aff_transformation_2 motion(SC::Exact_rational(3, 5), SC::Exact_rational(-4, 5), 2, SC::Exact_rational(4, 5),
                                       SC::Exact_rational(3, 5), -1);
  std::size_t ends = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const Curve curve = SC::bezier_curve(random_points(random, 8));
    const Locus locus = SC::self_bisector_curves(curve);
    expect_numbers(SC::self_bisector_curves(curve.transformed(motion)), locus.number_of_closed_curves(),
                   locus.number_of_open_curves(), locus.singular_points().size(), locus.number_of_poles());
    check_topology(locus, curve);
    ends += number_of_vertices(curve);
  }
  EXPECT_GT(ends, 8u);
}

// A line touches it twice.
TEST(Self_bisector_curves_2, quartic)
{
  const Curve curve = SC::bezier_curve(std::vector<Point>{{-3, 3}, {-2, -5}, {0, 6}, {2, -5}, {3, 4}});
  const Locus locus = SC::self_bisector_curves(curve);
  check_topology(locus, curve);
  EXPECT_EQ(locus.number_of_poles(), 1u);
}

// An open and a closed cubic spline, whose curvature is continuous; the parabola in two pieces.
TEST(Self_bisector_curves_2, splines)
{
  const Curve spline(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3},
                     std::vector<Point>{{0, 0}, {1, 4}, {3, -3}, {5, 4}, {6, 1}, {8, 2}});
  check_topology(SC::self_bisector_curves(spline), spline);
  EXPECT_GT(number_of_vertices(spline), 2u);
  // Breaks without a jump of any derivative change no numbers.
  const Curve quartic = SC::bezier_curve(std::vector<Point>{{-3, 3}, {-2, -5}, {0, 6}, {2, -5}, {3, 4}});
  const Locus whole = SC::self_bisector_curves(quartic),
              cut = SC::self_bisector_curves(
                  quartic.with_knot(SC::Exact_rational(2, 5)).with_knot(SC::Exact_rational(5, 7)));
  expect_numbers(cut, whole.number_of_closed_curves(), whole.number_of_open_curves(), whole.singular_points().size(),
                 whole.number_of_poles());
  EXPECT_EQ(cut.points().size(), whole.points().size());
  const Curve closed = Curve::from_periodic(3, {0, 1, 2, 3, 4}, {{6, 1}, {1, 5}, {-4, 1}, {2, 0}});
  check_topology(SC::self_bisector_curves(closed), closed);
  EXPECT_GE(number_of_vertices(closed), 4u);   // the theorem of the four vertices
  // Its axis is that of x: it passes pairs of breaks, which other parts have in a corner only.
  const Locus symmetric =
      SC::self_bisector_curves(Curve::from_periodic(3, {0, 1, 2, 3, 4}, {{4, 0}, {1, 3}, {-3, 0}, {1, -3}}));
  expect_numbers(symmetric, 0, 6, 0, symmetric.number_of_poles());

  const Curve parabola = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}})
                             .with_knot(SC::Exact_rational(1, 3))
                             .with_knot(SC::Exact_rational(1, 3));
  const Locus axis = SC::self_bisector_curves(parabola);
  expect_numbers(axis, 0, 1, 0, 0);   // joined where a parameter passes the break
  double lowest = 9, highest = 0;
  check_points(axis, parabola, [&](double x, double y) {
    EXPECT_NEAR(x, 0, 1e-12);
    lowest = (std::min)(lowest, y);
    highest = (std::max)(highest, y);
  });
  EXPECT_NEAR(lowest, 0.5, 1e-14);
  EXPECT_NEAR(highest, 1.5, 1e-14);
}

TEST(Self_bisector_curves_2, bad_input)
{
  EXPECT_THROW(SC::self_bisector_curves(ellipse(2, 1), {.tolerance = 0}), SC::Invalid_input);
  const Curve cusp = SC::bezier_curve(std::vector<Point>{{3, 2}, {-5, -6}, {8, -5}, {-8, 3}, {-4, 7}});   // at 1/3
  EXPECT_THROW(SC::self_bisector_curves(cusp), SC::Invalid_input);
}

} // namespace self_bisector_curves_2_test
