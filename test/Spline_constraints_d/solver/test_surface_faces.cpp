// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of solutions that touch faces of the domain along curves, from inside and from outside, and that pass
// through edges of the domain: their numbers, characteristics and loops, curves that are left alone, meshes; under
// random changes of the unknowns that keep the faces, and inequalities under random rotations.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include "surface_test_checks.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace surface_faces_test {

namespace SC = CGAL::Spline_constraints;
namespace PMP = CGAL::Polygon_mesh_processing;
using SC::Power_polynomial;
using SC::Relation;
using Rational = SC::Exact_rational;
using surface_test_checks::check_complex, surface_test_checks::Counts, surface_test_checks::counts_of,
    surface_test_checks::cube, surface_test_checks::number, surface_test_checks::rotated, surface_test_checks::square,
    surface_test_checks::system, surface_test_checks::variable;
using Domain = std::vector<std::pair<Rational, Rational>>;
using Function = std::function<Power_polynomial(const std::array<Power_polynomial, 3>&)>;

namespace {

const Rational half = Rational(1) / 2;

// Around the third axis, with radii 1 and 1/2.
Power_polynomial torus(const std::array<Power_polynomial, 3>& p)
{
  const Power_polynomial ring = square(p[0]) + square(p[1]);
  return square(ring + square(p[2]) + number(Rational(3) / 4)) - number(4) * ring;
}

Power_polynomial cylinder(const std::array<Power_polynomial, 3>& p) { return square(p[0]) + square(p[1]) - number(1); }

// A surface in a box under a change of the unknowns: in another order, mirrored, scaled and moved.
SC::Constraint_system_d changed(const Function& f, const Domain& domain, std::mt19937& random)
{
  std::array<std::size_t, 3> order{0, 1, 2};
  std::shuffle(order.begin(), order.end(), random);
  std::uniform_int_distribution<int> any(1, 9);
  std::array<Power_polynomial, 3> old;
  Domain changed(3);
  for (std::size_t j = 0; j < 3; ++j) { // the old unknown is (new - shift) / scale
    const Rational scale = Rational(any(random) % 2 == 0 ? 1 : -1) * any(random) / any(random),
                   shift = Rational(any(random)) / any(random);
    old[j] = (variable(static_cast<int>(order[j])) - number(shift)) / number(scale);
    changed[order[j]] =
        std::minmax<Rational>({Rational(scale * domain[j].first + shift), Rational(scale * domain[j].second + shift)});
  }
  return system(changed, {f(old)});
}

// What a surface in a box is: the same after each change.
struct Expected
{
  Counts counts;
  std::size_t lone_curves = 0;
};

std::size_t number_of_lone_curves(const SC::Surface_solution_set_d& set)
{
  std::size_t result = 0;
  for (const SC::Curve_solution_set_d& curves : set.lone_curves())
    result += curves.curves().size();
  return result;
}

void check(const Function& f, const Domain& domain, const Expected& expected)
{
  std::mt19937 random(7);
  for (int k = 0; k < 4; ++k) {
    const SC::Constraint_system_d own =
        k == 0 ? system(domain, {f({variable(0), variable(1), variable(2)})}) : changed(f, domain, random);
    const SC::Surface_solution_set_d set = SC::solve_surfaces(own);
    EXPECT_TRUE(set.is_complete()) << k << ": " << set;
    check_complex(set);
    EXPECT_EQ(counts_of(set), expected.counts) << k;
    EXPECT_EQ(number_of_lone_curves(set), expected.lone_curves) << k;
    EXPECT_TRUE(set.points().empty() && set.singular_points().empty()) << k << ": " << set;
  }
}

// A mesh of a complete answer, with these loops; its area.
double area_of_mesh(const SC::Constraint_system_d& system, double error)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(system);
  EXPECT_TRUE(set.is_complete());
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = error});
  const auto& mesh = result.mesh;
  EXPECT_TRUE(result.is_complete() && CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_LE(result.error, 1.05 * error);
  EXPECT_FALSE(PMP::does_self_intersect(mesh));
  EXPECT_EQ(static_cast<int>(mesh.number_of_vertices() + mesh.number_of_faces()) -
                static_cast<int>(mesh.number_of_edges()),
            set.euler_characteristic());
  std::vector<SC::Solution_surface_mesh::Mesh::Halfedge_index> cycles;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  EXPECT_EQ(cycles.size(), set.number_of_boundary_loops());
  for (const auto v : mesh.vertices())
    for (int j = 0; j < 3; ++j)
      EXPECT_TRUE(CGAL::to_double(system.domain(j).first) <= mesh.point(v)[j] &&
                  mesh.point(v)[j] <= CGAL::to_double(system.domain(j).second));
  return PMP::area(mesh);
}

} // namespace

TEST(Surface_faces, touched_along_curves_from_inside)
{
  const Rational outer = Rational(3) / 2;
  check(torus, {{-outer, outer}, {-outer, outer}, {-half, half}}, {{{0, 0}}});
  check(torus, {{0, outer}, {-outer, outer}, {-half, half}}, {{{0, 2}}});
  check(torus, {{Rational(1) / 3, outer}, {-2, 2}, {-half, half}}, {{{0, 2}}}); // circles cut at irrational places
  check(cylinder, {{-1, 1}, {-1, 1}, {0, 1}}, {{{0, 2}}});
  check([](const auto& p) { return square(p[0]) + square(p[1] - p[2]) - number(1); }, {{-1, 1}, {-2, 2}, {0, 1}},
        {{{0, 2}}});
  check([](const auto& p) { return square(p[0]) * (p[1] + number(2)) - p[2]; }, {{-1, 1}, {-1, 1}, {0, 3}}, {{{1, 1}}});
  // a face that the surface crosses in a line which it touches
  check([](const auto& p) { return square(p[0]) * p[0] - p[2]; }, {{-1, 1}, {-1, 1}, {0, 1}}, {{{1, 1}}});
}

TEST(Surface_faces, touched_along_curves_from_outside)
{
  check(torus, {{-2, 2}, {-2, 2}, {half, 1}}, {{}, 1});
  check(cylinder, {{1, 2}, {-1, 1}, {0, 1}}, {{}, 1});
  const SC::Surface_solution_set_d circle =
      SC::solve_surfaces(system({{-2, 2}, {-2, 2}, {half, 1}}, {torus({variable(0), variable(1), variable(2)})}));
  ASSERT_EQ(circle.lone_curves().size(), 1u);
  EXPECT_EQ(circle.lone_curves()[0].number_of_closed_curves(), 1u);
  for (const SC::Curve_vertex& vertex : circle.lone_curves()[0].vertices()) {
    const std::vector<double> point = vertex.point();
    EXPECT_NEAR(std::hypot(point[0], point[1]), 1, 1e-12);
    EXPECT_EQ(vertex.box[2], std::pair(half, half));
  }
  std::ostringstream line;
  line << circle;
  EXPECT_NE(line.str().find("; touching the domain in 1 curves"), std::string::npos) << line.str();
}

TEST(Surface_faces, edges_of_the_domain)
{
  const auto saddle = [](const auto& p) { return p[0] * p[1] - p[2]; };
  check(saddle, {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}}});
  check(saddle, {{0, 2}, {0, 3}, {0, 7}}, {{{1, 1}}});
  check(saddle, {{0, Rational(1) / 3}, {0, Rational(1) / 7}, {0, 5}}, {{{1, 1}}});
  check([](const auto& p) { return p[0] - p[2]; }, {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}}});
  check([](const auto& p) { return p[0] + p[2] - number(1); }, {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}}});
  check(cylinder, {{-1, 1}, {0, 1}, {0, 1}}, {{{1, 1}}}); // tangent planes along edges
  check(cylinder, {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}}});
  check([](const auto& p) { return square(p[0]) * p[0] * p[1] - p[2]; }, {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}}});
  check([](const auto& p) { return (p[0] - p[2]) * (number(1) + p[0] * p[2]) + p[0] * p[1] * p[2]; },
        {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}}});
}

TEST(Surface_faces, edges_that_are_touched)
{
  check([](const auto& p) { return p[0] + p[2]; }, {{0, 1}, {0, 1}, {0, 1}}, {{}, 1});
  check([](const auto& p) { return p[0] * p[1] + p[2]; }, {{0, 1}, {0, 1}, {0, 1}}, {{}, 2});
  // parts of an edge, up to where surfaces begin: at rational and irrational places
  check([](const auto& p) { return p[0] * p[1] - p[2]; }, {{0, 1}, {-1, 1}, {0, 1}}, {{{1, 1}}, 1});
  const Rational third = Rational(1) / 3;
  check([&](const auto& p) { return p[0] * (p[1] - number(half)) * (p[1] - number(third)) - p[2]; },
        {{0, 1}, {0, 1}, {0, 1}}, {{{1, 1}, {1, 1}}, 1});
  check([](const auto& p) { return p[0] * (square(p[1]) - number(half)) - p[2]; }, {{0, 1}, {0, 1}, {0, 1}},
        {{{1, 1}}, 1});
  check([](const auto& p) { return p[0] * (square(p[0]) - number(3) * square(p[1])) - p[2]; }, {{0, 1}, {0, 1}, {0, 1}},
        {{{1, 1}}, 1});
}

// Planes and a cylinder as inequalities that touch along circles, a bound on an edge that is a solution, four unknowns.
TEST(Surface_faces, inequalities_and_more_unknowns)
{
  std::mt19937 random(11);
  const auto solved = [](const std::vector<Power_polynomial>& equalities, const Power_polynomial& positive,
                         const Domain& domain) {
    SC::Constraint_system_d result = system(domain, equalities);
    result.add(positive, Relation::GREATER_EQUAL);
    const SC::Surface_solution_set_d set = SC::solve_surfaces(result);
    EXPECT_TRUE(set.is_complete()) << set;
    check_complex(set);
    return std::pair(counts_of(set), number_of_lone_curves(set));
  };
  using Answer = std::pair<Counts, std::size_t>;
  for (int k = 0; k < 2; ++k) {
    const auto own = rotated(random);
    EXPECT_EQ(solved({torus(own)}, own[2] - number(half), cube(2)), (Answer{{}, 1}));
    const Power_polynomial sphere = square(own[0]) + square(own[1]) + square(own[2]) - number(1);
    EXPECT_EQ(solved({sphere}, -cylinder(own), cube(2)), (Answer{{{2, 0}}, 0}));
    EXPECT_EQ(solved({sphere}, cylinder(own), cube(2)), (Answer{{}, 1}));
  }
  const Power_polynomial x = variable(0), y = variable(1), z = variable(2), w = variable(3);
  EXPECT_EQ(solved({torus({x, y, z})}, number(half) - z, {{-2, 2}, {-2, 2}, {-1, 1}}), (Answer{{{0, 0}}, 0}));
  EXPECT_EQ(solved({x * y - z}, number(1) - x - y, Domain(3, {0, 1})), (Answer{{{1, 1}}, 0}));
  const SC::Surface_solution_set_d clifford =
      SC::solve_surfaces(system(cube(1, 4), {square(x) + square(y) - number(1), square(z) + square(w) - number(1)}));
  EXPECT_TRUE(clifford.is_complete());
  check_complex(clifford);
  EXPECT_EQ(counts_of(clifford), (Counts{{0, 0}}));
}

// An equality that is zero on edges of the domain, where another one is not: x y = z (1 + w^2) and x y w = 1/4.
TEST(Surface_faces, edges_that_one_equality_has)
{
  const Power_polynomial x = variable(0), y = variable(1), z = variable(2), w = variable(3);
  const SC::Surface_solution_set_d set = SC::solve_surfaces(system(
      {{0, 1}, {0, 1}, {0, 1}, {half, 1}}, {x * y - z * (number(1) + square(w)), x * y * w - number(Rational(1) / 4)}));
  EXPECT_TRUE(set.is_complete()) << set;
  check_complex(set);
  EXPECT_EQ(counts_of(set), (Counts{{1, 1}}));
}

// Splines with breaks: each cell has a part of the face, or of the edge.
TEST(Surface_faces, splines_with_breaks)
{
  const Rational third = Rational(1) / 3;
  const auto solved = [](const Domain& domain, const SC::Spline_function& f) {
    SC::Constraint_system_d result(domain);
    result.add(f, Relation::EQUAL);
    const SC::Surface_solution_set_d set = SC::solve_surfaces(result);
    EXPECT_TRUE(set.is_complete()) << set;
    check_complex(set);
    return std::pair(counts_of(set), number_of_lone_curves(set));
  };
  using Answer = std::pair<Counts, std::size_t>;
  const std::vector<std::vector<Rational>> four_products(4, {0, 0, 0, 1}); // x y in each cell
  EXPECT_EQ(solved({{0, 1}, {-1, 1}, {0, 1}},
                   SC::Spline_function(SC::Spline_term{{0, 1}, {1, 1}, {{0, half, 1}, {-1, third, 1}}, four_products}) +
                       SC::Spline_function(-variable(2))),
            (Answer{{{1, 1}}, 1}));
  const SC::Spline_function parabola(SC::Spline_term{{0}, {2}, {{-1, third, 1}}, {{-1, 0, 1}, {-1, 0, 1}}});
  EXPECT_EQ(solved({{-1, 1}, {-1, 1}, {0, 1}}, parabola + SC::Spline_function(square(variable(1)))),
            (Answer{{{0, 2}}, 0}));
}

TEST(Surface_faces, meshes)
{
  const Power_polynomial x = variable(0), y = variable(1), z = variable(2);
  const Rational outer = Rational(3) / 2;
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(area_of_mesh(system({{-outer, outer}, {-outer, outer}, {-half, half}}, {torus({x, y, z})}), 0.01),
              2 * pi * pi, 0.2);
  EXPECT_NEAR(area_of_mesh(system({{-1, 1}, {0, 1}, {0, 1}}, {cylinder({x, y, z})}), 0.01), pi, 0.03);
  // integral of sqrt(1 + x^2 + y^2) over the unit square
  EXPECT_NEAR(area_of_mesh(system(Domain(3, {0, 1}), {x * y - z}), 0.001), 1.280789, 0.001);
  EXPECT_NEAR(area_of_mesh(system(Domain(3, {0, 1}), {x - z}), 0.01), std::sqrt(2.0), 1e-12);
}

// Where a curve that is touched meets one that is crossed, or the surface is singular, little is undecided.
TEST(Surface_faces, what_is_undecided)
{
  const Power_polynomial x = variable(0), y = variable(1), z = variable(2);
  for (const SC::Constraint_system_d& own :
       {system({{-1, 1}, {-1, 1}, {0, 1}}, {square(x) * y - z}), system(Domain(3, {0, 1}), {x * y - square(z)})}) {
    const SC::Surface_solution_set_d set = SC::solve_surfaces(own);
    EXPECT_FALSE(set.is_complete());
    check_complex(set);
    EXPECT_EQ(set.surfaces().size(), 1u);
    const std::vector<SC::Undecided_part> undecided = set.undecided();
    ASSERT_EQ(undecided.size(), 1u);
    for (const auto& [lower, upper] : undecided[0].place) {
      EXPECT_NEAR(lower, 0, 1e-6);
      EXPECT_NEAR(upper, 0, 1e-6);
    }
  }
}

} // namespace surface_faces_test
