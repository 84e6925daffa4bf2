// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces of arrangements of curves on surfaces: their number, samples, neighbours and regions; meshes with a proved
// error.

#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_by_zeros.h>
#endif

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace trimmed_surfaces_3_test {

namespace SC = CGAL::Spline_constraints;
namespace SR = SC::internal::Surface_regions;
using Number = SC::Exact_rational;
using Tensor = SC::Bernstein_tensor<Number>;

namespace {

constexpr double pi = 3.14159265358979323846;

const Tensor u = Tensor::coordinate(2, 0), v = Tensor::coordinate(2, 1), one = Tensor::constant(2, Number(1));

Number ratio(int a, int b) { return Number(Number(a) / b); }

Tensor circle(const Number& x, const Number& y, const Number& squared_radius)
{
  return (u - x) * (u - x) + (v - y) * (v - y) - squared_radius;
}

// The unit square with a label that counts which of the polynomials are negative, as bits.
SR::Trimming signs_on_square(const std::vector<Tensor>& zeros)
{
  const SC::Surface_cell_3 cell{{SC::Surface_cell_3::Range(0, 1), {0, 1}}, {u, v, u * v * Number(0), one}};
  return {{cell},
          {},
          [=](std::size_t) { return zeros; },
          [=](std::size_t, const SR::Parameters& p) {
            int label = 0;
            for (std::size_t i = 0; i < zeros.size(); ++i) {
              const Number value = zeros[i](p);
              EXPECT_NE(value, 0);
              label += value < 0 ? 1 << i : 0;
            }
            return std::optional(label);
          }};
}

SC::Trimmed_surface_3 trimmed(const SR::Trimming& trimming, const SC::Solver_options& options = {.tolerance = 1e-8})
{
  SR::Operation_budget budget(options);
  return SR::trimmed_by_zeros(trimming, budget);
}

// By the shoelace formula, without holes.
double area_of(const SC::Surface_face_3& face)
{
  Number twice(0);
  for (const auto& loop : face.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &p = loop[i].source, &q = loop[(i + 1) % loop.size()].source;
      twice += p.x() * q.y() - p.y() * q.x();
    }
  return 0.5 * CGAL::to_double(twice);
}

} // namespace

TEST(TrimmedSurfaces, DiskHasTwoFaces)
{
  const auto surface = trimmed(signs_on_square({circle(ratio(1, 3), ratio(2, 5), ratio(1, 25))}));
  ASSERT_TRUE(surface.is_complete());
  ASSERT_EQ(surface.faces().size(), 2u);
  EXPECT_EQ(surface.number_of_regions(0), 1u);
  EXPECT_EQ(surface.number_of_regions(1), 1u);
  for (const auto& face : surface.faces()) {
    const double area = pi / 25;
    EXPECT_NEAR(area_of(face), face.label == 1 ? area : 1 - area, 1e-3);
    EXPECT_EQ(face.loops.size(), face.label == 1 ? 1u : 2u);
  }
}

TEST(TrimmedSurfaces, CrossingCirclesHaveFourFaces)
{
  const auto surface = trimmed(signs_on_square(
      {circle(ratio(2, 5), ratio(1, 2), ratio(1, 20)), circle(ratio(3, 5), ratio(1, 2), ratio(1, 20))}));
  ASSERT_TRUE(surface.is_complete());
  ASSERT_EQ(surface.faces().size(), 4u);
  std::set<std::optional<int>> labels;
  double area = 0;
  for (const auto& face : surface.faces()) {
    labels.insert(face.label);
    area += area_of(face);
    for (const auto& loop : face.loops)
      for (const auto& edge : loop)
        EXPECT_TRUE(!edge.neighbour || surface.faces()[*edge.neighbour].label != face.label);
  }
  EXPECT_EQ(labels, (std::set<std::optional<int>>{0, 1, 2, 3}));
  EXPECT_DOUBLE_EQ(area, 1);
}

// Eight circles that each cross many others, too many for one product: areas, and as many regions as Euler's formula
// says for a connected arrangement.
TEST(TrimmedSurfaces, ManyCurvesAreToldApart)
{
  std::vector<Tensor> circles;
  for (int i = 0; i < 8; ++i)
    circles.push_back(circle(ratio(30 + 7 * i + i % 3, 111), ratio(50 + 5 * (i % 2) + i, 113), ratio(1, 30)));
  const auto surface = trimmed(signs_on_square(circles));
  ASSERT_TRUE(surface.is_complete());
  double area = 0;
  std::vector<double> inside(8, 0.);
  for (const auto& face : surface.faces()) {
    area += area_of(face);
    for (std::size_t i = 0; i < 8; ++i)
      inside[i] += (*face.label >> i & 1) != 0 ? area_of(face) : 0;
  }
  EXPECT_DOUBLE_EQ(area, 1);
  for (const double a : inside)
    EXPECT_NEAR(a, pi / 30, 1e-3);
  // Two circles cross in two points if their centers are nearer than a diameter; the label names the circles.
  std::size_t crossings = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < i; ++j) {
      const auto x = [](int k) { return (30 + 7 * k + k % 3) / 111.; };
      const auto y = [](int k) { return (50 + 5 * (k % 2) + k) / 113.; };
      crossings += std::hypot(x(i) - x(j), y(i) - y(j)) < 2 * std::sqrt(1 / 30.) ? 2 : 0;
    }
  EXPECT_EQ(surface.regions().size(), crossings + 2);
}

// A grid of lines, some of them sides of the square, and a diagonal through the crossings.
TEST(TrimmedSurfaces, LinesThroughCommonPoints)
{
  const auto surface = trimmed(signs_on_square({u, v - Number(1), u - ratio(1, 2), v - ratio(1, 2), u - v}));
  ASSERT_TRUE(surface.is_complete());
  ASSERT_EQ(surface.faces().size(), 6u);
  std::multiset<double> areas;
  for (const auto& face : surface.faces())
    areas.insert(area_of(face));
  EXPECT_EQ(areas, (std::multiset<double>{0.125, 0.125, 0.125, 0.125, 0.25, 0.25}));
}

TEST(TrimmedSurfaces, WithoutCurvesThereIsOneFace)
{
  const auto surface = trimmed(signs_on_square({circle(3, 3, 1)}));
  ASSERT_TRUE(surface.is_complete());
  ASSERT_EQ(surface.faces().size(), 1u);
  EXPECT_EQ(surface.faces()[0].label, 0);
}

// Curves that are not where labels change do not part regions.
TEST(TrimmedSurfaces, EqualLabelsAreOneRegion)
{
  SR::Trimming trimming = signs_on_square({u - ratio(1, 3), v - u * u});
  trimming.label = [](std::size_t, const SR::Parameters& p) { return std::optional(p[0] < ratio(1, 3) ? 1 : 0); };
  const auto surface = trimmed(trimming);
  ASSERT_TRUE(surface.is_complete());
  EXPECT_EQ(surface.faces().size(), 4u);
  EXPECT_EQ(surface.number_of_regions(0), 1u);
  EXPECT_EQ(surface.number_of_regions(1), 1u);
}

// Two cells of a cylinder: a strip through the border of the cells and the seam.
TEST(TrimmedSurfaces, RegionsGoOnAcrossBordersAndSeams)
{
  SR::Trimming trimming = signs_on_square({v - ratio(1, 3), v - ratio(2, 3)});
  trimming.cells = {trimming.cells[0], trimming.cells[0]};
  trimming.cells[1].domain[0] = {1, 3};
  trimming.label = [](std::size_t, const SR::Parameters& p) {
    return std::optional(p[1] < ratio(1, 3) || p[1] > ratio(2, 3) ? 0 : 1);
  };
  const auto open = trimmed(trimming);
  EXPECT_TRUE(open.is_complete());
  EXPECT_EQ(open.faces().size(), 6u);
  EXPECT_EQ(open.number_of_regions(0), 2u);
  EXPECT_EQ(open.number_of_regions(1), 1u);
  trimming.is_closed = {false, true};
  const auto closed = trimmed(trimming);
  EXPECT_TRUE(closed.is_complete());
  EXPECT_EQ(closed.number_of_regions(0), 1u);
  EXPECT_EQ(closed.number_of_regions(1), 1u);
}

TEST(TrimmedSurfaces, ZeroFunctionsAndLimitsLeaveCellsUndecided)
{
  const auto zero = trimmed(signs_on_square({u * Number(0)}));
  EXPECT_FALSE(zero.is_complete());
  EXPECT_TRUE(zero.faces().empty());
  ASSERT_EQ(zero.undecided().size(), 1u);
  EXPECT_EQ(zero.undecided()[0].parameters[0].ranges[0].second, 1);
  const auto ended = trimmed(signs_on_square({circle(ratio(1, 3), ratio(2, 5), ratio(1, 25))}), {.time_limit = 1e-9});
  EXPECT_FALSE(ended.is_complete());
  EXPECT_TRUE(ended.faces().empty());
}

// An octant of the unit sphere by stereographic projection, with a hole.
TEST(TrimmedSurfaces, MeshIsWithinItsError)
{
  SR::Trimming trimming = signs_on_square({circle(ratio(1, 2), ratio(1, 2), ratio(1, 16))});
  const Tensor square = u * u + v * v;
  trimming.cells[0].coordinates = {u * Number(2), v * Number(2), square - Number(1), square + Number(1)};
  const auto surface = trimmed(trimming);
  for (const double error : {1e-2, 1e-3}) {
    const auto mesh = SC::to_surface_mesh(surface, 0, error);
    ASSERT_TRUE(mesh.is_complete());
    EXPECT_LE(mesh.error, error);
    EXPECT_GT(mesh.error, 0.05 * error);
    EXPECT_GT(mesh.mesh.number_of_faces(), 20u);
    EXPECT_LT(mesh.mesh.number_of_faces(), 10 / error);
    EXPECT_TRUE(mesh.mesh.is_valid());
    // 4 du dv / (1 + u^2 + v^2)^2 over the square, where it is pi/2 - 2 * ..., by a sum.
    double area = 0;
    constexpr int n = 1000;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double x = (i + 0.5) / n, y = (j + 0.5) / n;
        if (std::hypot(x - 0.5, y - 0.5) > 0.25)
          area += 4 / std::pow(1 + x * x + y * y, 2) / n / n;
      }
    EXPECT_NEAR(mesh.area(), area, 5 * error);
    for (const auto face : mesh.mesh.faces()) {
      double x = 0, y = 0, z = 0;
      for (const auto vertex : CGAL::vertices_around_face(mesh.mesh.halfedge(face), mesh.mesh)) {
        const auto& p = mesh.mesh.point(vertex);
        EXPECT_NEAR(std::hypot(p.x(), p.y(), p.z()), 1, 1e-12);
        const auto& at = mesh.parameters[vertex];
        EXPECT_NEAR(CGAL::to_double(surface.point(at.x(), at.y()).z()), p.z(), 1e-12);
        x += p.x() / 3;
        y += p.y() / 3;
        z += p.z() / 3;
      }
      EXPECT_LE(1 - std::hypot(x, y, z), mesh.error);
    }
  }
  EXPECT_THROW(SC::to_surface_mesh(surface, 0, 0), SC::Invalid_input);
  EXPECT_EQ(SC::to_surface_mesh(surface, 7, 0.1).mesh.number_of_faces(), 0u);
  EXPECT_FALSE(SC::to_surface_mesh(surface, 0, 1e-9, {.node_limit = 20}).is_complete());
}

} // namespace trimmed_surfaces_3_test
