// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// B-spline surfaces near surfaces of solutions: exact ones, distances at points that the fit has not seen, atlases with
// the topology that was proved, edges that charts share, areas and volumes, maps from more unknowns, limits.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surface_fitting.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace surface_fitting_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Rational = SC::Exact_rational;

namespace {

using Point = std::vector<double>;

// The largest value of a function that is the distance from the surface, nearly, at random points of all charts.
template <class Distance>
double largest_distance(const SC::Surface_atlas_d& atlas, const Distance& distance)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> parameter(0, 1);
  constexpr int count = 2000;
  double result = 0;
  for (const SC::Fitted_surface_d& chart : atlas.charts)
    for (int k = 0; k < count; ++k)
      result = (std::max)(result, distance(chart(parameter(random), parameter(random))));
  return result;
}

// The distances of points from all charts: from the nearest point of some grid, steps to neighbours that are nearer,
// and smaller steps where there are none.
class Distance_from_atlas
{
  static constexpr int tiles = 24;

  std::vector<SC::Bspline_surface_3<K>> m_surfaces;
  std::vector<std::vector<K::Point_3>> m_points;

public:
  explicit Distance_from_atlas(const SC::Surface_atlas_d& atlas)
  {
    for (const SC::Fitted_surface_d& chart : atlas.charts) {
      m_surfaces.push_back(chart.surface_3<K>());
      m_points.emplace_back();
      for (int i = 0; i <= tiles; ++i)
        for (int j = 0; j <= tiles; ++j)
          m_points.back().push_back(m_surfaces.back()(static_cast<double>(i) / tiles, static_cast<double>(j) / tiles));
    }
  }

  double operator()(const K::Point_3& point) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t chart = 0; chart < m_surfaces.size(); ++chart) {
      const auto is_nearer = [&](const K::Point_3& a, const K::Point_3& b) {
        return CGAL::squared_distance(a, point) < CGAL::squared_distance(b, point);
      };
      const auto nearest = std::min_element(m_points[chart].begin(), m_points[chart].end(), is_nearer);
      const auto index = static_cast<int>(nearest - m_points[chart].begin());
      if (const double own = CGAL::squared_distance(*nearest, point); std::sqrt(own) < result + 0.1)
        result = (std::min)(result,
                            distance(m_surfaces[chart], point, own,
                                     {static_cast<double>(index / (tiles + 1)) / tiles,
                                      static_cast<double>(index % (tiles + 1)) / tiles}));
    }
    return result;
  }

private:
  static double distance(const SC::Bspline_surface_3<K>& surface, const K::Point_3& point, double least,
                         std::array<double, 2> place)
  {
    for (double step = 1.0 / tiles; step > 1e-6;) {
      const std::array<double, 2> before = place;
      for (const int i : {-1, 0, 1})
        for (const int j : {-1, 0, 1}) {
          const std::array<double, 2> next{(std::clamp)(before[0] + i * step, 0., 1.),
                                           (std::clamp)(before[1] + j * step, 0., 1.)};
          if (const double own = CGAL::squared_distance(surface(next[0], next[1]), point); own < least) {
            least = own;
            place = next;
          }
        }
      if (place == before)
        step /= 2;
    }
    return std::sqrt(least);
  }
};

// The area of all charts, and the volume that closed ones are around, by a sum over points.
std::array<double, 2> area_and_volume(const SC::Surface_atlas_d& atlas)
{
  constexpr int tiles = 200;
  std::array<double, 2> result{};
  for (const SC::Fitted_surface_d& chart : atlas.charts) {
    const SC::Bspline_surface_3<K> surface = chart.surface_3<K>();
    for (int i = 0; i < tiles; ++i)
      for (int j = 0; j < tiles; ++j) {
        const double u = (i + 0.5) / tiles, v = (j + 0.5) / tiles;
        const K::Vector_3 normal = surface.normal(u, v) / (tiles * tiles);
        result[0] += std::sqrt(normal.squared_length());
        result[1] += (surface(u, v) - CGAL::ORIGIN) * normal / 3;
      }
  }
  return result;
}

double greatest_difference(const Point& a, const Point& b)
{
  double result = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    result = (std::max)(result, std::abs(a[k] - b[k]));
  return result;
}

Point point_of_edge(const SC::Fitted_edge_d& edge, double t)
{
  const auto point = edge.curve_3<K>()(t);
  return {point.x(), point.y(), point.z()};
}

// Charts have the boundaries that edges say, in cycles around the square, and edges one or two charts.
void expect_joined(const SC::Surface_atlas_d& atlas)
{
  for (std::size_t c = 0; c < atlas.charts.size(); ++c) {
    const SC::Fitted_surface_d& chart = atlas.charts[c];
    ASSERT_GE(chart.boundary.size(), 4u);
    const auto lines = chart.trimming_curves_2<K>();
    for (std::size_t k = 0; k < chart.boundary.size(); ++k) {
      const SC::Fitted_surface_d::Side &side = chart.boundary[k],
                                       &next = chart.boundary[(k + 1) % chart.boundary.size()];
      const SC::Fitted_edge_d& edge = atlas.edges[side.edge];
      EXPECT_EQ(std::count(edge.charts.begin(), edge.charts.end(), c), 1);
      EXPECT_EQ(edge.ends[side.is_reversed ? 0 : 1], atlas.edges[next.edge].ends[next.is_reversed ? 1 : 0]);
      EXPECT_EQ(side.parameters[side.is_reversed ? 0 : 1], next.parameters[next.is_reversed ? 1 : 0]);
      for (const double t : {0., 0.125, 0.4, 0.77, 1.}) {
        const K::Point_2 place = lines[k](t);
        const auto in_space = chart.surface_3<K>()(place.x(), place.y());
        EXPECT_LE(greatest_difference({in_space.x(), in_space.y(), in_space.z()}, point_of_edge(edge, t)), 1e-11);
      }
    }
  }
  for (const SC::Fitted_edge_d& edge : atlas.edges)
    for (const int end : {0, 1})
      EXPECT_LE(greatest_difference(end == 0 ? edge.control_points.front() : edge.control_points.back(),
                                    atlas.vertices[edge.ends[static_cast<std::size_t>(end)]]),
                1e-14);
}

double distance_from_unit_sphere(const Point& p) { return std::abs(std::hypot(p[0], p[1], p[2]) - 1); }

} // namespace

TEST(Surface_fitting, plane_is_exact)
{
  const auto [x, y, z] = SC::unknowns({0, 1}, {0, 1}, {0, 1});
  const auto set = SC::solve_surfaces(x + y + z == Rational(3) / 2); // a hexagon
  const SC::Surface_atlas_d atlas = SC::fit_bspline_surfaces(set, {.tolerance = 1e-12});
  EXPECT_TRUE(atlas.is_complete());
  ASSERT_EQ(atlas.charts.size(), 1u);
  EXPECT_EQ(atlas.charts[0].boundary.size(), 6u);
  EXPECT_EQ(atlas.vertices.size(), 6u);
  EXPECT_EQ(atlas.euler_characteristic(), 1);
  EXPECT_GT(atlas.test_points, 0u);
  EXPECT_LE(largest_distance(atlas, [](const Point& p) { return std::abs(p[0] + p[1] + p[2] - 1.5); }), 1e-12);
  expect_joined(atlas);
}

TEST(Surface_fitting, bilinear_patch_is_exact)
{
  const auto [x, y, z] = SC::unknowns({-1, 1}, {-1, 1}, {-2, 2});
  for (const int degree : {2, 3, 5}) {
    const SC::Surface_atlas_d atlas =
        SC::fit_bspline_surfaces(SC::solve_surfaces(z == x * y), {.degree = degree, .tolerance = 1e-12});
    EXPECT_TRUE(atlas.is_complete());
    ASSERT_EQ(atlas.charts.size(), 1u);
    EXPECT_EQ(atlas.charts[0].number_of_pieces(), 1u);
    EXPECT_EQ(atlas.charts[0].control_points.size(), static_cast<std::size_t>((degree + 1) * (degree + 1)));
    EXPECT_LE(atlas.error, 1e-12);
    EXPECT_LE(largest_distance(atlas, [](const Point& p) { return std::abs(p[2] - p[0] * p[1]); }), 1e-12);
    EXPECT_NEAR(area_and_volume(atlas)[0], 5.1231, 1e-3); // of z = x y over the square
    expect_joined(atlas);
  }
}

TEST(Surface_fitting, half_and_cap_of_a_sphere)
{
  for (const Rational& height : {Rational(0), Rational(0.5)}) {
    const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {height, 2});
    const auto set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
    const double low = CGAL::to_double(height);
    for (const double tolerance : {1e-2, 1e-4}) {
      const SC::Surface_atlas_d atlas = SC::fit_bspline_surfaces(set, {.tolerance = tolerance});
      EXPECT_TRUE(atlas.is_complete());
      ASSERT_EQ(atlas.charts.size(), 1u);
      EXPECT_EQ(atlas.charts[0].boundary.size(), 4u);
      EXPECT_LE(atlas.error, tolerance);
      EXPECT_GT(atlas.error, 0);
      const auto distance = [&](const Point& p) { return (std::max)(distance_from_unit_sphere(p), low - p[2]); };
      EXPECT_LE(largest_distance(atlas, distance), 1.5 * tolerance);
      EXPECT_NEAR(area_and_volume(atlas)[0], 2 * std::numbers::pi * (1 - low), 20 * tolerance);
      const Distance_from_atlas distance_from_atlas(atlas);
      std::mt19937 random(2);
      std::normal_distribution<double> coordinate;
      for (int k = 0; k < 200; ++k) {
        Point p{coordinate(random), coordinate(random), std::abs(coordinate(random))};
        const double length = std::hypot(p[0], p[1], p[2]);
        if (p[2] >= low * length) {
          EXPECT_LE(distance_from_atlas({p[0] / length, p[1] / length, p[2] / length}), 1.5 * tolerance);
        }
      }
    }
  }
}

TEST(Surface_fitting, atlas_of_a_sphere)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  const SC::Surface_atlas_d atlas = SC::fit_bspline_surfaces(set, {.tolerance = 1e-4});
  EXPECT_TRUE(atlas.is_complete());
  EXPECT_GE(atlas.charts.size(), 2u);
  EXPECT_EQ(atlas.euler_characteristic(), 2);
  EXPECT_LE(atlas.error, 1e-4);
  EXPECT_LE(largest_distance(atlas, distance_from_unit_sphere), 1.5e-4);
  for (const SC::Fitted_edge_d& edge : atlas.edges)
    EXPECT_EQ(edge.charts.size(), 2u);
  expect_joined(atlas);
  const auto [area, volume] = area_and_volume(atlas);
  EXPECT_NEAR(area, 4 * std::numbers::pi, 2e-3);
  EXPECT_NEAR(volume, 4 * std::numbers::pi / 3, 1e-3);
}

TEST(Surface_fitting, atlas_of_a_torus)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const auto torus = square(ring + square(z) + Rational(91) / 100) - 4 * ring;
  const SC::Surface_atlas_d atlas = SC::fit_bspline_surfaces(SC::solve_surfaces(torus == 0), {.tolerance = 1e-3});
  EXPECT_TRUE(atlas.is_complete());
  EXPECT_GE(atlas.charts.size(), 2u);
  EXPECT_EQ(atlas.euler_characteristic(), 0);
  EXPECT_EQ(atlas.euler_characteristic(0), 0);
  const auto distance = [](const Point& p) { return std::abs(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.3); };
  EXPECT_LE(atlas.error, 1e-3);
  EXPECT_LE(largest_distance(atlas, distance), 1.5e-3);
  expect_joined(atlas);
  const auto [area, volume] = area_and_volume(atlas);
  EXPECT_NEAR(area, 11.8435252813, 2e-2);
  EXPECT_NEAR(volume, 1.7765287922, 1e-2);
  const Distance_from_atlas distance_from_atlas(atlas);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
  for (int k = 0; k < 200; ++k) {
    const double a = angle(random), b = angle(random), r = 1 + 0.3 * std::cos(b);
    EXPECT_LE(distance_from_atlas({r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b)}), 1.5e-3);
  }
}

TEST(Surface_fitting, random_graphs)
{
  std::mt19937 random(4);
  std::uniform_int_distribution<int> coefficient(-8, 8);
  for (int round = 0; round < 5; ++round) {
    const auto [x, y, z] = SC::unknowns({-1, 1}, {-1, 1}, {-40, 40});
    std::array<int, 10> c{};
    for (int& entry : c)
      entry = coefficient(random);
    const auto height = [&](const auto& a, const auto& b) {
      return c[0] * a + c[1] * b + c[2] * a * a + c[3] * a * b + c[4] * b * b + c[5] * a * a * a + c[6] * a * a * b +
          c[7] * a * b * b + c[8] * b * b * b;
    };
    const SC::Surface_atlas_d atlas =
        SC::fit_bspline_surfaces(SC::solve_surfaces(8 * z == height(x, y)), {.tolerance = 1e-4});
    EXPECT_TRUE(atlas.is_complete());
    ASSERT_EQ(atlas.charts.size(), 1u);
    EXPECT_EQ(atlas.vertices.size(), 4u);
    EXPECT_LE(atlas.error, 1e-4);
    constexpr double greatest_slope = 20;
    EXPECT_LE(largest_distance(atlas, [&](const Point& p) { return std::abs(p[2] - height(p[0], p[1]) / 8); }),
              greatest_slope * 1e-4);
    for (const SC::Fitted_edge_d& edge : atlas.edges)
      EXPECT_EQ(edge.charts.size(), 1u);
    expect_joined(atlas);
  }
}

TEST(Surface_fitting, several_surfaces_in_four_unknowns)
{
  const auto [x, y, z, w] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  const auto set = SC::solve_surfaces(square(x) + square(y) == 1, square(z) + square(w) == 1); // Clifford's torus
  const SC::Surface_atlas_d atlas = SC::fit_bspline_surfaces(set, {.tolerance = 1e-3});
  EXPECT_TRUE(atlas.is_complete());
  EXPECT_EQ(atlas.euler_characteristic(), 0);
  const auto distance = [](const Point& p) {
    return (std::max)(std::abs(std::hypot(p[0], p[1]) - 1), std::abs(std::hypot(p[2], p[3]) - 1));
  };
  EXPECT_LE(largest_distance(atlas, distance), 1.5e-3);
  EXPECT_EQ(atlas.charts[0].control_points[0].size(), 4u);

  // As a torus in space, whose control points have the unknowns behind the coordinates in space.
  const SC::Vector_expression<3> map((2 + z) * x, (2 + z) * y, w);
  const SC::Surface_atlas_d in_space = SC::fit_bspline_surfaces(set, map, {.tolerance = 1e-3});
  EXPECT_TRUE(in_space.is_complete());
  EXPECT_EQ(in_space.euler_characteristic(), 0);
  EXPECT_EQ(in_space.charts[0].control_points[0].size(), 7u);
  EXPECT_LE(largest_distance(in_space,
                             [](const Point& p) { return std::abs(std::hypot(std::hypot(p[0], p[1]) - 2, p[2]) - 1); }),
            1.5e-3);
  EXPECT_NEAR(std::abs(area_and_volume(in_space)[1]), 4 * std::numbers::pi * std::numbers::pi, 0.1);

  const auto [a, b, c] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto first = square(a - 1) + square(b) + square(c) - Rational(1) / 2,
             second = square(a + 1) + square(b) + square(c) - Rational(1) / 4;
  const SC::Surface_atlas_d spheres = SC::fit_bspline_surfaces(SC::solve_surfaces(first * second == 0));
  EXPECT_TRUE(spheres.is_complete());
  EXPECT_EQ(spheres.euler_characteristic(), 4);
  EXPECT_EQ(spheres.euler_characteristic(0), 2);
  EXPECT_EQ(spheres.euler_characteristic(1), 2);
}

// The same splines each time.
TEST(Surface_fitting, calls_agree)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {0, 2});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  const SC::Surface_atlas_d first = SC::fit_bspline_surfaces(set, {.tolerance = 1e-2});
  ASSERT_EQ(first.charts.size(), 1u);
  ASSERT_GT(first.charts[0].control_points.size(), 16u);
  for (int k = 0; k < 4; ++k) {
    const SC::Surface_atlas_d again = SC::fit_bspline_surfaces(set, {.tolerance = 1e-2});
    ASSERT_EQ(again.charts.size(), 1u);
    EXPECT_EQ(again.charts[0].control_points, first.charts[0].control_points);
    EXPECT_EQ(again.error, first.error);
  }
}

TEST(Surface_fitting, limits_are_reported)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {0, 2});
  const auto set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  const SC::Surface_atlas_d coarse = SC::fit_bspline_surfaces(set, {.tolerance = 1e-8, .most_spans = 2});
  EXPECT_FALSE(coarse.is_complete());
  ASSERT_EQ(coarse.charts.size(), 1u);
  EXPECT_GT(coarse.error, 1e-8);
  EXPECT_LE(largest_distance(coarse, distance_from_unit_sphere), 1.5 * coarse.error);
  const SC::Surface_atlas_d stopped = SC::fit_bspline_surfaces(set, {}, {.time_limit = 1e-9});
  EXPECT_FALSE(stopped.is_complete());
}

TEST(Surface_fitting, bad_input)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto set = SC::solve_surfaces(x + y + z == 0);
  for (const double tolerance : {0., -1., std::nan("")})
    EXPECT_THROW(SC::fit_bspline_surfaces(set, {.tolerance = tolerance}), SC::Invalid_input);
  for (const int degree : {-1, 0, 1, 10})
    EXPECT_THROW(SC::fit_bspline_surfaces(set, {.degree = degree}), SC::Invalid_input);
  EXPECT_THROW(SC::fit_bspline_surfaces(set, {.most_spans = 0}), SC::Invalid_input);
  EXPECT_THROW(SC::fit_bspline_surfaces(set, {.mesh = {.chord_error = 0}}), SC::Invalid_input);
  EXPECT_THROW(SC::fit_bspline_surfaces(SC::solve_surfaces(square(x) + square(y) + square(z) == -1)),
               SC::Invalid_input);
  const auto [a, b, c, d] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  EXPECT_THROW(SC::fit_bspline_surfaces(set, SC::Vector_expression<3>(a, b, c + d)), SC::Invalid_input);
}

} // namespace surface_fitting_test
