// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors and sectors that are trimmed by their nearest feet: all kept between flat surfaces and cylinders, a trough
// that is cut at a known angle, a dome, labels against distances from dense samples, limits, bad input.

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/surface_bisector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/trimmed_surface_bisectors.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace trimmed_surface_bisectors_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_3;
using Surface = SC::Bspline_surface_3<K>;
using Curve = SC::Bspline_curve_3<K>;
using SC::Nearest_feet_label;
using SC::Touched_side;

constexpr SC::Touched_sides between{Touched_side::POSITIVE, Touched_side::NEGATIVE};
const SC::Surface_mesh_options coarse{.chord_error = 0.01, .angle = 10};

namespace {

Surface plane(double z, double size = 1)
{
  return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                 {{-size, -size, z}, {-size, size, z}, {size, -size, z}, {size, size, z}});
}

// Over a square, with random heights of control points up to a number.
Surface random_surface(int degree, double z, double height, std::mt19937& random)
{
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      points.emplace_back(static_cast<double>(i) / degree, static_cast<double>(j) / degree,
                          z + height * (static_cast<int>(random() % 201) - 100) / 100);
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0);
  knots.resize(2 * knots.size(), 1);
  return Surface({degree, degree}, knots, knots, points);
}

// z = 1 - 2 x^2
Surface trough()
{
  return Surface(
      {2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1},
      {{-0.5, -0.5, 0.5}, {-0.5, 0.5, 0.5}, {0, -0.5, 1.5}, {0, 0.5, 1.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}});
}

std::vector<Point> samples(const Surface& surface)
{
  constexpr int steps = 64;
  std::vector<Point> result;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      result.push_back(surface(i / double(steps), j / double(steps)));
  return result;
}

std::vector<Point> samples(const Curve& curve)
{
  constexpr int steps = 512;
  std::vector<Point> result;
  for (int i = 0; i <= steps; ++i)
    result.push_back(curve(i / double(steps)));
  return result;
}

double distance_from(const std::vector<Point>& points, const Point& p)
{
  double result = std::numeric_limits<double>::infinity();
  for (const Point& q : points)
    result = (std::min)(result, CGAL::squared_distance(p, q));
  return std::sqrt(result);
}

// The point for parameters in the unit square that may be rounded.
Point at(const Surface& surface, double u, double v)
{
  return surface(std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0));
}

double length(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

struct Counts
{
  std::size_t kept = 0, removed = 0, undecided = 0;
};

// Labels of the vertices of the untrimmed mesh, with their feet on both operands: no sample is nearer than a foot that
// is nearest, and some sample is not much farther than one that is not.
template <class First, class Second>
Counts checked_labels(const SC::Trimmed_envelope_surface_3& trimmed, const First& first, const Second& second,
                      const std::function<std::array<double, 2>(const std::vector<double>&, const Point&)>& distances)
{
  Counts result;
  const std::vector<Point> of_first = samples(first), of_second = samples(second);
  for (std::size_t i = 0; i < trimmed.untrimmed().parts().size(); ++i) {
    const SC::Envelope_part_3& part = trimmed.untrimmed().parts()[i];
    const SC::Solution_surface_mesh mesh =
        SC::to_surface_mesh(part.solutions, part.image, {.chord_error = 0.005, .angle = 10});
    for (const auto v : mesh.mesh.vertices()) {
      const Point& p = mesh.mesh.point(v);
      const std::array<double, 2> own = distances(mesh.unknowns[v], p);
      const double gap = (std::min)(distance_from(of_first, p) - own[0], distance_from(of_second, p) - own[1]);
      switch (trimmed.label(i, mesh.unknowns[v])) {
      case Nearest_feet_label::NEAREST:
        ++result.kept;
        EXPECT_GT(gap, -1e-9) << p;
        break;
      case Nearest_feet_label::NOT_NEAREST:
        ++result.removed;
        EXPECT_LT(gap, 1e-3) << p;
        break;
      default:
        ++result.undecided;
      }
    }
  }
  return result;
}

Counts checked_labels(const SC::Trimmed_envelope_surface_3& trimmed, const Surface& first, const Surface& second)
{
  return checked_labels(trimmed, first, second, [&](const std::vector<double>& x, const Point& p) {
    return std::array{length(p, at(first, x[0], x[1])), length(p, at(second, x[2], x[3]))};
  });
}

SC::Solution_surface_mesh expect_all_kept(const SC::Trimmed_envelope_surface_3& trimmed)
{
  EXPECT_TRUE(trimmed.is_complete()) << trimmed;
  EXPECT_GT(trimmed.number_of_cells(Nearest_feet_label::NEAREST), 0u);
  EXPECT_EQ(trimmed.number_of_cells(Nearest_feet_label::NEAREST), trimmed.cells().size());
  SC::Solution_surface_mesh result = trimmed.mesh(coarse);
  EXPECT_EQ(result.mesh.number_of_faces(), trimmed.untrimmed().mesh(coarse).mesh.number_of_faces());
  return result;
}

} // namespace

TEST(Trimmed_surface_bisectors, flat_surfaces)
{
  const SC::Solution_surface_mesh mesh =
      expect_all_kept(SC::trimmed_surface_bisector(plane(0), plane(2, 1.25), 3, between));
  for (const Point& p : mesh.mesh.points())
    EXPECT_NEAR(p.z(), 1, 1e-14);
  std::mt19937 random(5);
  const Surface a = random_surface(3, 0, 0.01, random), b = random_surface(3, 1, 0.01, random);
  expect_all_kept(SC::trimmed_surface_bisector(a, b, 2, between));
  expect_all_kept(SC::trimmed_alpha_sector_surface(a, b, 0.25, between));
}

// z = (x^2 - y^2) / (4 h) between cylinders with axes at right angles.
TEST(Trimmed_surface_bisectors, perpendicular_cylinders)
{
  // half of a cylinder along the first axis, above or below
  const auto half = [&](int side) {
    return Surface({1, 2}, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1},
                   {{-1, 0.375, side * 0.5},
                    {-1, 0, side * 0.78125},
                    {-1, -0.375, side * 0.5},
                    {1, 0.375, side * 0.5},
                    {1, 0, side * 0.78125},
                    {1, -0.375, side * 0.5}},
                   {1, 0.8, 1, 1, 0.8, 1});
  };
  const Surface low = half(1).transformed({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1}),
                high = half(-1).transformed({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1});
  const SC::Solution_surface_mesh mesh = expect_all_kept(SC::trimmed_surface_bisector(low, high, 2));
  for (const Point& p : mesh.mesh.points())
    EXPECT_NEAR(p.z(), (p.x() * p.x() - p.y() * p.y()) / 4, 1e-12);
}

// Of the plane z = 0 and the trough, spheres with feet (x, y, 1 - 2 x^2) have another foot at -x as near where their
// centers have x = 0: this is so for 64 x^4 - 64 x^2 + 8 = 0, x = sin(pi/8). Farther inside feet are not nearest.
TEST(Trimmed_surface_bisectors, trough)
{
  const double border = std::sin(std::acos(-1) / 8);
  const Surface roof = trough();
  const SC::Trimmed_envelope_surface_3 trimmed = SC::trimmed_surface_bisector(plane(0), roof, 2, between);
  EXPECT_TRUE(trimmed.is_complete()) << trimmed;
  EXPECT_GT(trimmed.number_of_cells(Nearest_feet_label::BOTH), 0u);
  const Counts counts = checked_labels(trimmed, plane(0), roof, [&](const std::vector<double>& x, const Point& p) {
    return std::array{p.z(), length(p, at(roof, x[2], x[3]))};
  });
  EXPECT_GT(counts.kept, 10u);
  EXPECT_GT(counts.removed, 10u);
  EXPECT_EQ(counts.undecided, 0u);
  const SC::Solution_surface_mesh mesh = trimmed.mesh(coarse);
  double least = 1;
  for (const auto v : mesh.mesh.vertices()) {
    const double x = std::abs(mesh.unknowns[v][2] - 0.5);
    EXPECT_GT(x, border - 1e-12);
    least = (std::min)(least, x);
  }
  EXPECT_NEAR(least, border, 1e-4);
  SC::Solution_surface_mesh::Mesh labelled = mesh.mesh; // finding a map is different in CGAL 6, adding a known one not
  const auto labels = labelled.add_property_map<CGAL::SM_Face_index, Nearest_feet_label>("f:label").first;
  EXPECT_GT(mesh.mesh.number_of_faces(), 10u);
  for (const auto f : mesh.mesh.faces())
    EXPECT_EQ(labels[f], Nearest_feet_label::NEAREST);
  // every cell with one label is on its side
  for (const SC::Trimmed_cell_3& cell : trimmed.cells()) {
    const auto& [begin, end] = cell.box[2];
    const bool may_be_kept = end - 0.5 > border || begin - 0.5 < -border,
               may_be_removed = begin - 0.5 < border && end - 0.5 > -border;
    EXPECT_TRUE(cell.label == Nearest_feet_label::NEAREST ? may_be_kept : may_be_removed);
  }
}

// Where centers of curvature are near, many cells are undecided, up to a limit.
TEST(Trimmed_surface_bisectors, random_surfaces)
{
  std::mt19937 random(17);
  Counts all;
  for (int round = 0; round < 3; ++round) {
    const int degree = 2 + round % 2;
    const double height = round == 0 ? 0.3 : 0.1;
    const Surface a = random_surface(degree, 0, height, random), b = random_surface(degree, 1, height, random);
    const SC::Solver_options limits{.tolerance = 1e-8, .node_limit = 10000};
    const Counts own = checked_labels(round < 2 ? SC::trimmed_surface_bisector(a, b, 2, between, limits)
                                                : SC::trimmed_alpha_sector_surface(a, b, 0.25, between, limits),
                                      a, b);
    all.kept += own.kept;
    all.removed += own.removed;
  }
  EXPECT_GT(all.kept, 50u);
  EXPECT_GT(all.removed, 5u);
}

TEST(Trimmed_surface_bisectors, curve_and_surface)
{
  const Surface roof = trough();
  const Curve line(1, {0, 0, 1, 1}, {Point(-0.4, 0, 0), Point(0.4, 0, 0)});
  const Curve arch(2, {0, 0, 0, 1, 1, 1}, {Point(-0.5, 0, -0.5), Point(0, 0, 1), Point(0.5, 0, -0.5)});
  for (const Curve& curve : {line, arch}) {
    const SC::Trimmed_envelope_surface_3 trimmed =
        SC::trimmed_curve_surface_bisector(curve, roof, 1, {.tolerance = 1e-8, .node_limit = 6000});
    const Counts counts = checked_labels(trimmed, roof, curve, [&](const std::vector<double>& x, const Point& p) {
      return std::array{length(p, at(roof, x[0], x[1])), length(p, curve(std::clamp(x[2], 0.0, 1.0)))};
    });
    EXPECT_GT(counts.kept, 10u) << trimmed;
    EXPECT_GT(counts.removed, 10u) << trimmed;
  }
}

TEST(Trimmed_surface_bisectors, bad_input_and_limits)
{
  EXPECT_THROW(SC::trimmed_surface_bisector(plane(0), plane(2), 0), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_surface_bisector(plane(0), plane(0), 1), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_alpha_sector_surface(plane(0), plane(2), 0.5), SC::Invalid_input);
  const Curve line(1, {0, 0, 1, 1}, {Point(-1, 0, 1), Point(1, 0, 1)});
  EXPECT_THROW(SC::trimmed_curve_surface_bisector(line, plane(0), -1), SC::Invalid_input);
  const auto roof = trough();
  EXPECT_FALSE(SC::trimmed_surface_bisector(plane(0), roof, 2, between, {.time_limit = 1e-9}).is_complete());
  const std::size_t nodes = SC::surface_bisector(plane(0), roof, 2, between).summary().nodes;
  const SC::Trimmed_envelope_surface_3 some =
      SC::trimmed_surface_bisector(plane(0), roof, 2, between, {.tolerance = 1e-8, .node_limit = nodes + 10});
  EXPECT_FALSE(some.is_complete());
  EXPECT_TRUE(some.untrimmed().is_complete());
  EXPECT_GT(some.number_of_cells(Nearest_feet_label::UNDECIDED), 0u);
  ASSERT_FALSE(some.undecided().empty());
  EXPECT_EQ(some.undecided()[0].reason, "node limit");
  EXPECT_EQ(some.undecided()[0].place.size(), 4u);
}

} // namespace trimmed_surface_bisectors_test
