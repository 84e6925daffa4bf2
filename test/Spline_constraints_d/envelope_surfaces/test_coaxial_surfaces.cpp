// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors, alpha-sectors and offsets of patches of revolution about one axis, beside those of random profiles in the
// plane: all points of the proved planar ones, revolved, are on them.

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/alpha_sector_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/offset_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/surface_bisector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/trimmed_surface_bisectors.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace coaxial_surfaces_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Surface = SC::Bspline_surface_3<K>;
using Mesh = SC::Solution_surface_mesh;

// Normals of surfaces point downwards.
constexpr SC::Touched_sides between{SC::Touched_side::NEGATIVE, SC::Touched_side::POSITIVE};

namespace {

// The distance from the axis, and the height.
Curve random_profile(double height, std::mt19937& random)
{
  std::uniform_int_distribution<int> part(-64, 64);
  std::vector<P> points;
  for (int i = 0; i < 3; ++i)
    points.emplace_back(2 + i, height + part(random) / 256.0);
  return SC::bezier_curve(points);
}

// About the third axis, by angles with tangents between -3/4 and 3/4, or turned, so that not both end at once.
Surface revolved(const Curve& profile, bool is_turned)
{
  const double cosine = is_turned ? 0.96 : 1, sine = is_turned ? 0.28 : 0;
  std::vector<K::Point_3> points;
  std::vector<double> weights;
  for (const auto& [x, y, weight] : {std::array{0.8, -0.6, 1.0}, std::array{1.25, 0.0, 0.8}, std::array{0.8, 0.6, 1.0}})
    for (const P& p : profile.control_points()) {
      points.emplace_back((cosine * x - sine * y) * p.x(), (sine * x + cosine * y) * p.x(), p.y());
      weights.push_back(weight);
    }
  return Surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, points, weights);
}

double distance_from(const Mesh& mesh, const K::Point_3& p)
{
  double result = 1e9;
  for (const auto f : mesh.mesh.faces()) {
    std::vector<K::Point_3> corners;
    for (const auto v : mesh.mesh.vertices_around_face(mesh.mesh.halfedge(f)))
      corners.push_back(mesh.mesh.point(v));
    result = (std::min)(result, CGAL::squared_distance(p, K::Triangle_3(corners[0], corners[1], corners[2])));
  }
  return std::sqrt(result);
}

// Points of the plane, revolved, that are not farther from a mesh than that may be from its surface.
void expect_on(const Mesh& mesh, const std::vector<P>& points)
{
  EXPECT_GT(points.size(), 2u);
  for (const P& p : points)
    for (const double angle : {-0.25, 0.0, 0.5})
      EXPECT_LT(distance_from(mesh, K::Point_3(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y())), 0.02);
}

// Vertices whose feet have the same angle as they have.
void expect_in_half_planes(const Mesh& mesh, const Surface& a, const Surface& b)
{
  EXPECT_GT(mesh.mesh.number_of_vertices(), 10u);
  for (const auto v : mesh.mesh.vertices()) {
    const K::Point_3& p = mesh.mesh.point(v);
    const std::vector<double>& x = mesh.unknowns[v];
    for (const K::Point_3& foot : {a(x[0], x[1]), b(x[2], x[3])})
      EXPECT_NEAR(p.x() * foot.y() - p.y() * foot.x(), 0, 1e-8);
  }
}

bool is_inside(const std::optional<double>& parameter) { return parameter && *parameter > 0.001 && *parameter < 0.999; }

} // namespace

TEST(Coaxial_surfaces, bisectors_and_sectors)
{
  std::mt19937 random(19);
  for (int round = 0; round < 3; ++round) {
    const Curve low = random_profile(0, random), high = random_profile(1, random);
    const Surface a = revolved(low, false), b = revolved(high, true);
    const auto planar = SC::trimmed_bisector(low, high);
    ASSERT_TRUE(planar.is_complete());
    std::vector<P> points;
    for (const auto& chain : planar.chains())
      for (const auto& polyline : planar.polylines(chain, 0.0005, 0.95))
        for (const auto& sample : polyline)
          if (is_inside(sample.parameters[0]) && is_inside(sample.parameters[1]))
            points.push_back(sample.point);
    const SC::Envelope_surface_3 bisector = SC::surface_bisector(a, b, 1, between);
    EXPECT_TRUE(bisector.is_complete()) << bisector;
    const Mesh mesh = bisector.mesh({.chord_error = 0.01});
    expect_in_half_planes(mesh, a, b);
    expect_on(mesh, points);
    // what is nearest in the plane is kept in space, or undecided
    const SC::Solver_options limits{.tolerance = 1e-8, .node_limit = bisector.summary().nodes + 2000};
    expect_on(SC::trimmed_surface_bisector(a, b, 1, between, limits).mesh({.chord_error = 0.01}), points);

    const auto planar_sector = SC::trimmed_alpha_sector(low, high, 0.25);
    ASSERT_TRUE(planar_sector.is_complete());
    points.clear();
    for (std::size_t i = 0; i < planar_sector.arcs().size(); ++i)
      for (const auto& sample : planar_sector.polyline(i, 0.0005))
        if (is_inside(sample.parameters[0]) && is_inside(sample.parameters[1]) &&
            sample.point.y() > low(std::clamp(sample.point.x() / 2 - 1, 0.0, 1.0)).y()) // not on the other side
          points.push_back(sample.point);
    const SC::Envelope_surface_3 sector = SC::alpha_sector_surface(a, b, 0.25, between);
    EXPECT_TRUE(sector.is_complete()) << sector;
    const Mesh sector_mesh = sector.mesh({.chord_error = 0.01});
    expect_in_half_planes(sector_mesh, a, b);
    expect_on(sector_mesh, points);
  }
}

TEST(Coaxial_surfaces, offsets)
{
  std::mt19937 random(20);
  for (int round = 0; round < 10; ++round) {
    const Curve profile = random_profile(0, random);
    const SC::Envelope_surface_3 offset = SC::offset_surface(revolved(profile, false), 0.25);
    EXPECT_TRUE(offset.is_complete()) << offset;
    const Mesh mesh = offset.mesh({.chord_error = 0.01});
    std::array<std::vector<P>, 2> points;
    for (int i = 0; i <= 16; ++i) {
      const P p = profile(i / 16.0);
      const K::Vector_2 d = profile.derivative(i / 16.0, 1);
      const double scale = 0.25 / std::sqrt(d.squared_length());
      for (const int side : {0, 1})
        points[static_cast<std::size_t>(side)].push_back(p + (side == 0 ? scale : -scale) * K::Vector_2(-d.y(), d.x()));
    }
    const auto is_on = [&](const std::vector<P>& all) {
      return distance_from(mesh, K::Point_3(all[8].x(), 0, all[8].y())) < 0.02;
    };
    EXPECT_NE(is_on(points[0]), is_on(points[1]));
    expect_on(mesh, is_on(points[0]) ? points[0] : points[1]);
  }
}

} // namespace coaxial_surfaces_test
