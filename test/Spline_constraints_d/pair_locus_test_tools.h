// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_PAIR_LOCUS_TEST_TOOLS_H
#define TEST_PAIR_LOCUS_TEST_TOOLS_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Locus = SC::Curve_pair_locus_2<K>;
using Vector = std::array<double, 2>;

inline Vector rounded(const std::array<SC::Exact_rational, 2>& p)
{
  return {CGAL::to_double(p[0]), CGAL::to_double(p[1])};
}
inline Vector rounded(const Point& p) { return rounded(std::array<SC::Exact_rational, 2>{p.x(), p.y()}); }

inline void expect_numbers(const Locus& locus, std::size_t closed, std::size_t open, std::size_t singular,
                           std::size_t poles)
{
  EXPECT_TRUE(locus.is_complete()) << locus;
  EXPECT_TRUE(locus.undecided().empty());
  EXPECT_EQ(locus.number_of_closed_curves(), closed) << locus;
  EXPECT_EQ(locus.number_of_open_curves(), open) << locus;
  EXPECT_TRUE(locus.points().empty()) << locus;
  EXPECT_EQ(locus.singular_points().size(), singular) << locus;
  EXPECT_EQ(locus.number_of_poles(), poles) << locus;
}

// A point of a curve and the direction of the curve there.
struct Foot
{
  Vector point, direction;
};

inline Foot foot(const SC::Spline_map<1, 2>& curve, const SC::Spline_map<1, 2>& derivative, double parameter)
{
  const std::array<SC::Exact_rational, 1> t{SC::Exact_rational(parameter)};
  const Vector tangent = rounded(derivative(t));
  const double length = std::hypot(tangent[0], tangent[1]);
  return {rounded(curve(t)), {tangent[0] / length, tangent[1] / length}};
}

// Calls visit(point, feet on both curves) for points along all curves of a locus, two of each at least.
template <class Visit>
void visit_points(const Locus& locus, const Curve& c1, const Curve& c2, const Visit& visit, double error = 1e-2,
                  double radius = 10)
{
  const SC::Spline_map<1, 2> first(c1), second(c2), first_derivative = derivative(first),
                                                    second_derivative = derivative(second);
  for (const Locus::Curve& curve : locus.curves()) {
    const auto samples = locus.polyline(curve, error, radius);
    EXPECT_GE(samples.size(), 2u);
    for (const auto& sample : samples)
      visit(rounded(sample.point),
            std::array<Foot, 2>{foot(first, first_derivative, sample.parameters[0]),
                                foot(second, second_derivative, sample.parameters[1])});
  }
}

// The distance of a point from its foot on a curve, along the normal there. Errors grow with the square of the distance
// from the origin.
inline double checked_distance(const Vector& p, const Foot& foot)
{
  const double dx = p[0] - foot.point[0], dy = p[1] - foot.point[1];
  EXPECT_NEAR(dx * foot.direction[0] + dy * foot.direction[1], 0, 1e-12 * (1 + p[0] * p[0] + p[1] * p[1]));
  return std::hypot(dx, dy);
}

inline std::vector<Point> random_points(std::mt19937& random, int coordinate, std::size_t count = 4)
{
  std::uniform_int_distribution<int> next(-coordinate, coordinate);
  std::vector<Point> result;
  while (result.size() < count) {
    const int x = next(random), y = next(random);
    result.emplace_back(x, y);
  }
  return result;
}

#endif // TEST_PAIR_LOCUS_TEST_TOOLS_H
