// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cubic splines near curves of solutions: their distance from the equations, ends in singular points, smoothness at the
// seam, images in space.

#include <CGAL/Spline_constraints_d/geometry/curves/spline_fitting.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace spline_fitting_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

namespace {

// The largest value of a function that is the distance from the curve, nearly, at many points of a spline.
template <class Distance>
double largest_distance(const SC::Fitted_spline_d& spline, const Distance& distance)
{
  constexpr int count = 3000;
  double result = 0;
  for (int i = 0; i <= count; ++i)
    result = (std::max)(
        result, distance(spline(spline.breaks.front() + (spline.breaks.back() - spline.breaks.front()) * i / count)));
  return result;
}

struct Solved
{
  SC::Constraint_system_d system;
  SC::Curve_solution_set_d set;

  explicit Solved(const std::vector<SC::Constraint>& constraints)
    : system(make_system(constraints)), set(SC::solve_curves(system))
  {}
};

} // namespace

TEST(Spline_fitting, circle)
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  const Solved circle({square(x) + square(y) == 4});
  ASSERT_EQ(circle.set.curves().size(), 1u);
  std::size_t pieces = 0;
  for (const double tolerance : {1e-3, 1e-6, 1e-8}) {
    const SC::Fitted_spline_d spline = SC::fit_spline(circle.system, circle.set, circle.set.curves()[0], tolerance);
    EXPECT_TRUE(spline.is_closed);
    EXPECT_LE(spline.error, tolerance);
    EXPECT_GT(spline.error, 0);
    EXPECT_EQ(spline.control_points.size() + 1, spline.breaks.size());
    EXPECT_LE(largest_distance(spline, [](const auto& p) { return std::abs(std::hypot(p[0], p[1]) - 2); }),
              2 * spline.error);
    EXPECT_NEAR(spline.breaks.back(), 4 * std::acos(-1.0), 1e-3);   // the arc length
    pieces = spline.breaks.size();

    // Closed, and twice continuously differentiable at the seam.
    const auto curve = spline.curve_2<K>();
    const double begin = curve.domain().first, end = curve.domain().second;
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(curve(begin), curve(end))), 0, 1e-12);
    for (const int order : {1, 2})
      for (const int i : {0, 1})
        EXPECT_NEAR(curve.derivative(end, order)[i], curve.derivative(begin, order)[i], 1e-8);
    EXPECT_NEAR(curve(1)[0], spline(1)[0], 1e-12);
  }
  EXPECT_LT(pieces, 600u);
}

TEST(Spline_fitting, Viviani_ends_in_the_node)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const Solved viviani({x*x + y*y + z*z == 4, square(x - 1) + y*y == 1});
  ASSERT_EQ(viviani.set.curves().size(), 2u);
  for (const SC::Solution_curve& curve : viviani.set.curves()) {
    const SC::Fitted_spline_d spline = SC::fit_spline(viviani.system, viviani.set, curve, 1e-6);
    EXPECT_LE(spline.error, 1e-6);
    const auto in_space = spline.curve_3<K>();
    EXPECT_EQ(in_space.degree(), 3);
    for (const K::Point_3& end : {in_space.source(), in_space.target()}) {
      EXPECT_NEAR(end.x(), 2, 1e-12);
      EXPECT_NEAR(end.y(), 0, 1e-12);
      EXPECT_NEAR(end.z(), 0, 1e-12);
    }
    // A point is no further from a surface than from the curve in it.
    const auto distance = [](const std::vector<double>& p) {
      return (std::max)(std::abs(std::hypot(p[0], p[1], p[2]) - 2), std::abs(std::hypot(p[0] - 1, p[1]) - 1));
    };
    EXPECT_LE(largest_distance(spline, distance), 2e-6);
  }
}

TEST(Spline_fitting, branches_of_a_figure_eight)
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const Solved eight({square(x*x + y*y) == x*x - y*y});
  ASSERT_EQ(eight.set.curves().size(), 2u);
  for (const SC::Solution_curve& curve : eight.set.curves()) {
    const SC::Fitted_spline_d spline = SC::fit_spline(eight.system, eight.set, curve, 1e-6);
    EXPECT_LE(spline.error, 1e-6);
    EXPECT_FALSE(spline.is_closed);
    for (const double t : {spline.breaks.front(), spline.breaks.back()})
      EXPECT_NEAR(std::hypot(spline(t)[0], spline(t)[1]), 0, 1e-12);
    const auto distance = [](const std::vector<double>& p) {
      const double r = p[0] * p[0] + p[1] * p[1], value = r * r - p[0] * p[0] + p[1] * p[1];
      return std::abs(value) / (std::hypot(4 * r * p[0] - 2 * p[0], 4 * r * p[1] + 2 * p[1]) + 1e-9);
    };
    EXPECT_LE(largest_distance(spline, distance), 2e-6);
  }
}

TEST(Spline_fitting, images_in_space)
{
  // The great circle x + y + z = 0 on the sphere, in stereographic coordinates.
  auto [u, v] = SC::unknowns({-4, 4}, {-4, 4});
  const Solved circle({2*u + 2*v + 1 - u*u - v*v == 0});
  ASSERT_EQ(circle.set.curves().size(), 1u);
  const auto on_sphere = [&](double error) {
    std::vector<K::Point_3> result;
    for (const std::vector<double>& p : SC::to_polyline(circle.system, circle.set, circle.set.curves()[0], error)) {
      const double size = 1 + p[0]*p[0] + p[1]*p[1];
      result.emplace_back(2 * p[0] / size, 2 * p[1] / size, 2 / size - 1);
    }
    return result;
  };
  const SC::Fitted_spline_d spline = SC::fit_spline(on_sphere, true, 1e-6);
  EXPECT_LE(spline.error, 1e-6);
  EXPECT_LE(largest_distance(spline,
                             [](const auto& p) {
                               return std::hypot(std::hypot(p[0], p[1], p[2]) - 1, (p[0] + p[1] + p[2]) / std::sqrt(3));
                             }),
            2e-6);
}

TEST(Spline_fitting, straight_lines_and_bad_input)
{
  auto [x, y] = SC::unknowns({0, 2}, {0, 2});
  const Solved line({x == y});
  ASSERT_EQ(line.set.curves().size(), 1u);
  const SC::Fitted_spline_d spline = SC::fit_spline(line.system, line.set, line.set.curves()[0], 1e-6);
  EXPECT_LE(spline.error, 1e-6);
  EXPECT_EQ(spline.breaks.size(), 2u);
  EXPECT_LE(largest_distance(spline, [](const auto& p) { return std::abs(p[0] - p[1]); }), 1e-14);
  EXPECT_THROW(spline.curve_3<K>(), SC::Invalid_input);
  EXPECT_THROW(SC::fit_spline(line.system, line.set, line.set.curves()[0], 0), SC::Invalid_input);
  EXPECT_THROW(SC::fit_spline(
                   [](double) {
                     return std::vector<K::Point_2>{{1, 1}, {1, 1}};
                   },
                   false, 1e-6),
               SC::Invalid_input);
}

} // namespace spline_fitting_test
