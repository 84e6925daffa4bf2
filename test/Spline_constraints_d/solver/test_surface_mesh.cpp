// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of surfaces of solutions: the topology that was proved, no triangles that cross, vertices on the surface,
// distances and angles within their bounds, curvatures, boundaries and breaks that are kept, maps from more unknowns.

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace surface_mesh_test {

namespace SC = CGAL::Spline_constraints;
namespace PMP = CGAL::Polygon_mesh_processing;
using Mesh = SC::Solution_surface_mesh::Mesh;
using Rational = SC::Exact_rational;

namespace {

int characteristic(const Mesh& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
      static_cast<int>(mesh.number_of_faces());
}

double share_of_angles_below(const Mesh& mesh, double degrees)
{
  std::size_t below = 0;
  for (const auto h : mesh.halfedges())
    if (!mesh.is_border(h)) {
      const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                 &c = mesh.point(mesh.target(mesh.next(h)));
      below += CGAL::approximate_angle(a, b, c) < degrees ? 1 : 0;
    }
  return static_cast<double>(below) / (3.0 * static_cast<double>(mesh.number_of_faces()));
}

std::size_t number_of_boundaries(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> cycles;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  return cycles.size();
}

// What every mesh of a complete answer is.
void check(const SC::Solution_surface_mesh& result, const SC::Surface_solution_set_d& set, double error)
{
  EXPECT_TRUE(result.is_complete());
  ASSERT_GT(result.mesh.number_of_faces(), 0u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(result.mesh));
  EXPECT_EQ(characteristic(result.mesh), set.euler_characteristic());
  EXPECT_EQ(number_of_boundaries(result.mesh), set.number_of_boundary_loops());
  EXPECT_LE(result.error, 1.05 * error); // points beside middles are found up to a small part of their distance
  EXPECT_GT(result.error, 0);
  EXPECT_EQ(PMP::does_self_intersect(result.mesh), false);
  for (const auto e : result.mesh.edges())
    if (result.mesh.is_border(e)) {
      EXPECT_TRUE(result.is_feature[e]);
    }
}

using Function = std::function<double(const std::vector<double>&)>;

void check_vertices(const SC::Solution_surface_mesh& result, const Function& f, double bound)
{
  for (const auto v : result.mesh.vertices())
    EXPECT_LE(std::abs(f(result.unknowns[v])), bound);
}

double square(double x) { return x * x; }

double torus_value(const std::vector<double>& p)
{
  const double ring = square(p[0]) + square(p[1]);
  return square(ring + square(p[2]) + 0.91) - 4 * ring;
}

} // namespace

TEST(Surface_mesh, sphere)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  std::vector<double> missing_volume;
  for (const double error : {0.02, 0.005}) {
    const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = error});
    check(result, set, error);
    EXPECT_TRUE(CGAL::is_closed(result.mesh));
    EXPECT_TRUE(PMP::is_outward_oriented(result.mesh));
    EXPECT_LE(share_of_angles_below(result.mesh, 20), 0.01);
    check_vertices(
        result, [](const std::vector<double>& p) { return square(p[0]) + square(p[1]) + square(p[2]) - 1; }, 1e-14);
    missing_volume.push_back(4 * CGAL_PI / 3 - PMP::volume(result.mesh));
    for (const auto v : result.mesh.vertices()) {
      const SC::Surface_differentials_3& own = result.differentials[v];
      EXPECT_NEAR(own.curvatures[0], -1, 1e-12);
      EXPECT_NEAR(own.curvatures[1], -1, 1e-12);
      EXPECT_NEAR(own.normal * (result.mesh.point(v) - CGAL::ORIGIN), 1, 1e-12);
    }
  }
  EXPECT_GT(missing_volume[1], 0);
  EXPECT_GT(missing_volume[0] / missing_volume[1], 2.5); // in proportion to the error
  EXPECT_LT(missing_volume[0] / missing_volume[1], 6.5);
}

TEST(Surface_mesh, torus_and_its_curvatures)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const SC::Surface_solution_set_d set =
      SC::solve_surfaces(square(ring + square(z) + Rational(91) / 100) - 4 * ring == 0);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = 0.01});
  check(result, set, 0.01);
  EXPECT_TRUE(PMP::is_outward_oriented(result.mesh));
  EXPECT_LE(share_of_angles_below(result.mesh, 20), 0.01);
  EXPECT_NEAR(PMP::area(result.mesh), 11.8435252813, 0.1);
  EXPECT_NEAR(PMP::volume(result.mesh), 1.7765287922, 0.05);
  check_vertices(result, torus_value, 1e-13);
  for (const auto v : result.mesh.vertices()) {
    const auto& p = result.mesh.point(v);
    const double distance = std::hypot(p.x(), p.y()), cosine = (distance - 1) / 0.3;
    const SC::Surface_differentials_3& own = result.differentials[v];
    EXPECT_NEAR(own.gaussian_curvature(), cosine / (0.3 * distance), 1e-9);
    EXPECT_NEAR(own.mean_curvature(), -0.5 * (1 / 0.3 + cosine / distance), 1e-9);
    EXPECT_NEAR(own.directions[0] * own.directions[1], 0, 1e-12);
    EXPECT_NEAR(own.directions[0] * own.normal, 0, 1e-12);
    // the meridian bends more: its direction has no part along the circles of latitude
    EXPECT_NEAR(own.directions[0].x() * -p.y() + own.directions[0].y() * p.x(), 0, 1e-9);
  }
}

TEST(Surface_mesh, boundaries_stay_on_faces_of_the_domain)
{
  const auto [x, y, z] = SC::unknowns({-0.8, 0.8}, {-0.8, 0.8}, {-0.8, 0.8});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  for (const bool is_remeshed : {false, true}) {
    const SC::Solution_surface_mesh result =
        SC::to_surface_mesh(set, {.chord_error = 0.01, .is_remeshed = is_remeshed});
    check(result, set, is_remeshed ? 0.01 : 0.015); // triangles of patches have fine edges, but not middles
    for (const auto v : result.mesh.vertices())
      if (result.mesh.is_border(v)) {
        const std::vector<double>& p = result.unknowns[v];
        EXPECT_EQ(std::count_if(p.begin(), p.end(), [](double t) { return std::abs(t) == 0.8; }), 1);
      }
  }
}

// Under random rational rotations.
TEST(Surface_mesh, tangle_cube)
{
  std::mt19937 random(53);
  std::uniform_int_distribution<int> any(-4, 4);
  const auto [x, y, z] = SC::unknowns({-4, 4}, {-4, 4}, {-4, 4});
  for (int round = 0; round < 2; ++round) {
    const int a = 5 + any(random), b = any(random), c = any(random), d = any(random);
    const Rational s = Rational(1) / (a * a + b * b + c * c + d * d);
    const auto row = [&, &x = x, &y = y, &z = z](int p, int q, int r) {
      return Rational(p * s) * x + Rational(q * s) * y + Rational(r * s) * z;
    };
    const auto quartic = [](const SC::Expression& t) { return square(square(t)) - 5 * square(t); };
    const SC::Surface_solution_set_d set = SC::solve_surfaces(
        quartic(row(a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c))) +
            quartic(row(2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b))) +
            quartic(row(2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d)) + Rational(59) / 5 ==
        0);
    ASSERT_EQ(set.euler_characteristic(), -8);
    const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = 0.03});
    check(result, set, 0.03);
    EXPECT_TRUE(CGAL::is_closed(result.mesh));
    EXPECT_LE(share_of_angles_below(result.mesh, 20), 0.01);
    EXPECT_NEAR(PMP::area(result.mesh), 101, 2);
  }
}

TEST(Surface_mesh, without_remeshing)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const SC::Surface_solution_set_d set =
      SC::solve_surfaces(square(ring + square(z) + Rational(91) / 100) - 4 * ring == 0);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = 0.02, .is_remeshed = false});
  check(result, set, 0.03);
  check_vertices(result, torus_value, 1e-13);
}

// What an inequality cuts off ends in a curve of edges; triangles still face the side that the gradient points to.
TEST(Surface_mesh, inequality)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const SC::Surface_solution_set_d set =
      SC::solve_surfaces(square(ring + square(z) + Rational(91) / 100) - 4 * ring == 0, x + y >= Rational(1) / 4);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = 0.01});
  check(result, set, 0.01);
  EXPECT_EQ(set.number_of_boundary_loops(), 2u);
  for (const auto v : result.mesh.vertices()) {
    const auto& p = result.mesh.point(v);
    EXPECT_NEAR(result.unknowns[v][3], p.x() + p.y() - 0.25, 1e-13);
    EXPECT_EQ(result.mesh.is_border(v), result.unknowns[v][3] == 0);
    const double factor = 1 - 1 / std::hypot(p.x(), p.y()); // towards the circle in the middle of the torus
    const CGAL::Simple_cartesian<double>::Vector_3 outward(p.x() * factor, p.y() * factor, p.z());
    EXPECT_GT(result.differentials[v].normal * outward, 0);
  }
  for (const auto f : result.mesh.faces()) {
    const auto h = result.mesh.halfedge(f);
    const auto &a = result.mesh.point(result.mesh.source(h)), &b = result.mesh.point(result.mesh.target(h)),
               &c = result.mesh.point(result.mesh.target(result.mesh.next(h)));
    EXPECT_GT(CGAL::cross_product(b - a, c - a) * result.differentials[result.mesh.target(h)].normal, 0);
  }
}

// (p, q, r) / (3/2 - s) of the Clifford torus is a ring whose sections are ellipses.
TEST(Surface_mesh, image_of_a_surface_in_four_unknowns)
{
  const auto [p, q, r, s] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, Rational(5) / 4});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(p) + square(q) == 1, square(r) + square(s) == 1);
  const SC::Expression factor = 1 / (Rational(3) / 2 - s);
  const SC::Solution_surface_mesh result =
      SC::to_surface_mesh(set, SC::Vector_expression<3>(p * factor, q * factor, r * factor), {.chord_error = 0.02});
  check(result, set, 0.02);
  EXPECT_LE(share_of_angles_below(result.mesh, 20), 0.01);
  const double width = 0.8, height = 2 / std::sqrt(5.0), volume = 2 * CGAL_PI * 1.2 * CGAL_PI * width * height;
  EXPECT_NEAR(std::abs(PMP::volume(result.mesh)), volume, 0.03 * volume);
  for (const auto v : result.mesh.vertices()) {
    const auto& own = result.mesh.point(v);
    const double radius = std::hypot(own.x(), own.y()), cosine = (radius - 1.2) / width;
    EXPECT_NEAR(square(cosine) + square(own.z() / height), 1, 1e-12);
    // the curvatures of the ellipse and of the circle of latitude
    const double gradient = std::hypot(cosine / width, own.z() / square(height));
    const double ellipse = 1 / (square(width * height) * gradient * gradient * gradient),
                 circle = cosine / width / gradient / radius;
    EXPECT_NEAR(result.differentials[v].gaussian_curvature(), ellipse * circle, 1e-8);
  }
}

// A rational surface as the map: a quarter of a cylinder. In doubles its splines have a common denominator, so that
// their scale matters.
TEST(Surface_mesh, image_under_a_rational_surface)
{
  const auto spline = [](std::vector<Rational> points) {
    for (Rational& point : points)
      point /= 3;
    return SC::Bspline_function<Rational>({2, 1}, {{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}}, std::move(points));
  };
  const SC::Spline_map<2, 3> cylinder(
      {spline({1, 1, 1, 1, 0, 0}), spline({0, 0, 1, 1, 2, 2}), spline({0, 1, 0, 1, 0, 2})}, spline({1, 1, 1, 1, 2, 2}));
  const auto [u, v, w] = SC::unknowns({0, 1}, {0, 1}, {-1, 1});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(w == (u - v) / 5);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, cylinder(u, v), {.chord_error = 0.002});
  check(result, set, 0.002);
  EXPECT_NEAR(PMP::area(result.mesh), CGAL_PI / 2, 0.01);
  for (const auto vertex : result.mesh.vertices()) {
    const auto& own = result.mesh.point(vertex);
    EXPECT_NEAR(square(own.x()) + square(own.y()), 1, 1e-13);
    EXPECT_NEAR(result.unknowns[vertex][1], own.z(), 1e-13);
    EXPECT_NEAR(std::abs(result.differentials[vertex].mean_curvature()), 0.5, 1e-9);
    EXPECT_NEAR(result.differentials[vertex].gaussian_curvature(), 0, 1e-9);
  }
}

// The circles of a torus in its plane of symmetry and its meridians in another plane, which cross: four circles cut
// into eight arcs, which lie on the planes up to rounding.
TEST(Surface_mesh, features_are_edges)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const std::array constraints{square(ring + square(z) + Rational(91) / 100) - 4 * ring == 0};
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const SC::Surface_solution_set_d set = SC::solve_surfaces(system, {z.polynomial(), (3 * x + 4 * y).polynomial()});
  ASSERT_TRUE(set.is_complete()) << set;
  EXPECT_EQ(set.surfaces().size(), 1u);
  EXPECT_EQ(set.euler_characteristic(), 0);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = 0.005});
  check(result, set, 0.005);
  EXPECT_TRUE(PMP::is_outward_oriented(result.mesh));
  double horizontal = 0, vertical = 0;
  const auto side = [](double height) { return std::abs(height) < 1e-15 ? 0 : height > 0 ? 1 : -1; };
  for (const auto e : result.mesh.edges()) {
    const auto h = result.mesh.halfedge(e);
    const auto &a = result.mesh.point(result.mesh.source(h)), &b = result.mesh.point(result.mesh.target(h));
    EXPECT_GE(side(a.z()) * side(b.z()), 0); // none crosses
    if (!result.is_feature[e])
      continue;
    const double length = std::sqrt(CGAL::squared_distance(a, b));
    const bool is_horizontal = side(a.z()) == 0 && side(b.z()) == 0;
    (is_horizontal ? horizontal : vertical) += length;
    if (!is_horizontal) {
      EXPECT_NEAR(3 * a.x() + 4 * a.y(), 0, 1e-13);
      EXPECT_NEAR(3 * b.x() + 4 * b.y(), 0, 1e-13);
    }
  }
  EXPECT_NEAR(horizontal, 4 * CGAL_PI, 0.1);
  EXPECT_NEAR(vertical, 1.2 * CGAL_PI, 0.05);
  EXPECT_THROW(SC::solve_surfaces(system, {SC::Power_polynomial::variable(3)}), SC::Invalid_input);
}

// z = |x| as a spline: the edge where it breaks is kept.
TEST(Surface_mesh, breaks_of_splines_are_edges)
{
  SC::Spline_term ridge{{0}, {1}, {{Rational(-1), Rational(0), Rational(1)}}, {{0, -1}, {0, 1}}};
  SC::Constraint_system_d system({{-1, 1}, {-1, 1}, {Rational(-1) / 2, 2}});
  system.add(SC::Spline_function(SC::Power_polynomial::variable(2)) - SC::Spline_function(ridge), SC::Relation::EQUAL);
  const SC::Surface_solution_set_d set = SC::solve_surfaces(system);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.edge_length = 0.3});
  EXPECT_TRUE(result.is_complete());
  EXPECT_EQ(characteristic(result.mesh), 1);
  double ridge_length = 0;
  for (const auto e : result.mesh.edges()) {
    const auto h = result.mesh.halfedge(e);
    const auto &a = result.mesh.point(result.mesh.source(h)), &b = result.mesh.point(result.mesh.target(h));
    EXPECT_LE(CGAL::squared_distance(a, b), square(0.3));
    EXPECT_GE(a.x() * b.x(), 0); // no edge crosses it
    if (!result.mesh.is_border(e) && result.is_feature[e]) {
      EXPECT_TRUE(a.x() == 0 && b.x() == 0);
      ridge_length += std::sqrt(CGAL::squared_distance(a, b));
    }
  }
  EXPECT_NEAR(ridge_length, 2, 1e-12);
  EXPECT_NEAR(PMP::area(result.mesh), 4 * std::sqrt(2.0), 1e-12);
}

// A double cone, and the four nodes of Cayley's cubic: a vertex for each fan of triangles at an apex.
TEST(Surface_mesh, singular_points)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-1, 1});
  const SC::Surface_solution_set_d cone = SC::solve_surfaces(square(x) + square(y) == square(z));
  ASSERT_EQ(cone.euler_characteristic(), 2);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(cone, {.chord_error = 0.01});
  EXPECT_TRUE(result.is_complete());
  EXPECT_LE(result.error, 0.012);
  EXPECT_EQ(characteristic(result.mesh), 2);
  EXPECT_EQ(number_of_boundaries(result.mesh), 2u);
  EXPECT_EQ(std::count(result.mesh.points().begin(), result.mesh.points().end(), Mesh::Point(0, 0, 0)), 2);
  EXPECT_NEAR(PMP::area(result.mesh), 2 * std::sqrt(2.0) * CGAL_PI, 0.1);

  const SC::Solution_surface_mesh half = // each side has a corner there
      SC::to_surface_mesh(SC::solve_surfaces(square(x) + square(y) == square(z), 3 * x >= y), {.chord_error = 0.01});
  EXPECT_TRUE(half.is_complete());
  EXPECT_LE(half.error, 0.012);
  EXPECT_EQ(characteristic(half.mesh), 2);
  EXPECT_EQ(number_of_boundaries(half.mesh), 2u);
  EXPECT_EQ(std::count(half.mesh.points().begin(), half.mesh.points().end(), Mesh::Point(0, 0, 0)), 2);
  EXPECT_NEAR(PMP::area(half.mesh), std::sqrt(2.0) * CGAL_PI, 0.05);

  const auto [p, q, r] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const SC::Surface_solution_set_d cayley =
      SC::solve_surfaces(square(p) + square(q) - square(p) * r + square(q) * r + square(r) == 1);
  ASSERT_TRUE(cayley.is_complete());
  ASSERT_EQ(cayley.singular_points().size(), 4u);
  const SC::Solution_surface_mesh nodes = SC::to_surface_mesh(cayley, {.chord_error = 0.03});
  EXPECT_EQ(characteristic(nodes.mesh), cayley.euler_characteristic());
  EXPECT_EQ(number_of_boundaries(nodes.mesh), cayley.number_of_boundary_loops());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(nodes.mesh));
  EXPECT_LE(share_of_angles_below(nodes.mesh, 20), 0.001); // at the nodes, too, which have no normals
  EXPECT_EQ(std::count_if(nodes.mesh.vertices().begin(), nodes.mesh.vertices().end(),
                          [&](const auto v) { return nodes.differentials[v].normal == CGAL::NULL_VECTOR; }),
            8);                                                                 // two sides of each
  EXPECT_LE(std::count_if(nodes.mesh.edges().begin(), nodes.mesh.edges().end(), // no clusters of tiny triangles
                          [&](const auto e) {
                            const auto h = nodes.mesh.halfedge(e);
                            return CGAL::squared_distance(nodes.mesh.point(nodes.mesh.source(h)),
                                                          nodes.mesh.point(nodes.mesh.target(h))) < square(1e-3);
                          }),
            20);
  for (const auto f : nodes.mesh.faces()) { // oriented as the gradient is, beside the nodes, too
    const auto h = nodes.mesh.halfedge(f);
    const auto &a = nodes.mesh.point(nodes.mesh.source(h)), &b = nodes.mesh.point(nodes.mesh.target(h)),
               &c = nodes.mesh.point(nodes.mesh.target(nodes.mesh.next(h)));
    EXPECT_GT(CGAL::cross_product(b - a, c - a) *
                  (nodes.differentials[nodes.mesh.target(h)].normal + nodes.differentials[nodes.mesh.source(h)].normal),
              0);
  }
}

// However memory is laid out.
TEST(Surface_mesh, same_mesh_each_time)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {0, 2});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  const Mesh first = SC::to_surface_mesh(set, {.chord_error = 0.01}).mesh;
  ASSERT_GT(first.number_of_faces(), 100u);
  std::vector<std::vector<double>> between; // other blocks of memory
  for (std::size_t k = 1; k < 8; ++k) {
    for (std::size_t i = 0; i < 100; ++i)
      between.emplace_back(1 + (i * i * k) % 997);
    const Mesh again = SC::to_surface_mesh(set, {.chord_error = 0.01}).mesh;
    ASSERT_EQ(again.number_of_vertices(), first.number_of_vertices());
    ASSERT_EQ(again.number_of_faces(), first.number_of_faces());
    EXPECT_TRUE(std::equal(first.points().begin(), first.points().end(), again.points().begin()));
    for (const auto face : first.faces())
      EXPECT_EQ(first.target(first.halfedge(face)), again.target(again.halfedge(face)));
  }
}

TEST(Surface_mesh, limits_and_bad_input)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  EXPECT_THROW(SC::to_surface_mesh(set, {.chord_error = 0}), SC::Invalid_input);
  EXPECT_THROW(SC::to_surface_mesh(set, {.angle = -1}), SC::Invalid_input);
  const SC::Solution_surface_mesh stopped = SC::to_surface_mesh(set, {.chord_error = 1e-3}, {.time_limit = 1e-9});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
  EXPECT_FALSE(stopped.summary().is_complete);
  const SC::Solution_surface_mesh copy = SC::to_surface_mesh(set);
  const SC::Solution_surface_mesh other = copy;
  EXPECT_EQ(other.unknowns[*other.mesh.vertices().begin()], copy.unknowns[*copy.mesh.vertices().begin()]);

  const auto [p, q, r, s] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  EXPECT_THROW(SC::to_surface_mesh(set, SC::Vector_expression<3>(p, q, s)), SC::Invalid_input);
}

// The sphere of dimension two in five unknowns, of which linear equalities give two; the mesh is a projection.
TEST(Surface_mesh, unknowns_that_were_eliminated)
{
  const auto [p, q, r, s, t] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(
      square(p) + square(q) + square(r) + square(s) + square(t) == 1, s == p / 3 + q / 5, t == r / 2 - p / 7);
  const SC::Solution_surface_mesh result = SC::to_surface_mesh(set, {.chord_error = 0.01});
  check(result, set, 0.01);
  EXPECT_TRUE(CGAL::is_closed(result.mesh));
  EXPECT_LE(share_of_angles_below(result.mesh, 20), 0.01);
  for (const auto v : result.mesh.vertices()) {
    const std::vector<double>& own = result.unknowns[v];
    double norm = 0;
    for (const double x : own)
      norm += square(x);
    EXPECT_NEAR(norm, 1, 1e-13);
    EXPECT_NEAR(own[3], own[0] / 3 + own[1] / 5, 1e-14);
    EXPECT_NEAR(own[4], own[2] / 2 - own[0] / 7, 1e-14);
  }
}

} // namespace surface_mesh_test
