// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Smooth surfaces through the vertices of meshes: pieces fit exactly, whatever is chosen; quadrics are reproduced;
// sides and hits are those of the sphere; meshes are closed and have the topology that is proved.

#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/smooth_surfaces_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace smooth_surfaces_3_test {

namespace SC = CGAL::Spline_constraints;
using K = SC::Smooth_surface_3::Kernel;
using FT = SC::Exact_rational;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Polynomial = SC::Power_polynomial;

namespace {

using Triangles = std::vector<std::array<std::size_t, 3>>;

const Triangles faces_of_octahedron{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

void add_faces(Mesh& mesh, const std::vector<Point>& points, const Triangles& triangles, bool are_reversed = false)
{
  std::vector<Vertex> vertices;
  for (const Point& p : points)
    vertices.push_back(mesh.add_vertex(p));
  for (const auto& [a, b, c] : triangles)
    mesh.add_face(vertices[a], vertices[are_reversed ? c : b], vertices[are_reversed ? b : c]);
}

std::vector<Point> ends_of_axes(const FT& a, const FT& b, const FT& c, const Vector& center = {0, 0, 0})
{
  std::vector<Point> result{{a, 0, 0}, {FT(-a), 0, 0}, {0, b, 0}, {0, FT(-b), 0}, {0, 0, c}, {0, 0, FT(-c)}};
  for (Point& p : result)
    p = p + center;
  return result;
}

Mesh octahedron(const FT& a, const FT& b, const FT& c)
{
  Mesh mesh;
  add_faces(mesh, ends_of_axes(a, b, c), faces_of_octahedron);
  return mesh;
}

using Gradients = Mesh::Property_map<Vertex, Vector>;

template <class Function>
Gradients gradients_by(Mesh& mesh, const Function& function)
{
  const Gradients result = mesh.add_property_map<Vertex, Vector>("v:given").first;
  for (const Vertex v : mesh.vertices())
    result[v] = function(mesh.point(v));
  return result;
}

Vector from_origin(const Point& p) { return 2 * (p - CGAL::ORIGIN); }

SC::Smooth_surface_3 unit_sphere()
{
  Mesh mesh = octahedron(1, 1, 1);
  return SC::smooth_surface(mesh, gradients_by(mesh, from_origin));
}

FT power_of_sphere(const Point& p) { return (p - CGAL::ORIGIN).squared_length() - 1; }

Mesh torus(int around, int across)
{
  Mesh mesh;
  std::vector<Point> points;
  Triangles triangles;
  const auto place = [&](int i, int j) {
    return static_cast<std::size_t>(i % around) * across + static_cast<std::size_t>(j % across);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      points.emplace_back((2 + 0.75 * std::cos(b)) * std::cos(a), (2 + 0.75 * std::cos(b)) * std::sin(a),
                          0.75 * std::sin(b));
      triangles.push_back({place(i, j), place(i + 1, j), place(i + 1, j + 1)});
      triangles.push_back({place(i, j), place(i + 1, j + 1), place(i, j + 1)});
    }
  add_faces(mesh, points, triangles);
  return mesh;
}

FT random_fraction(std::mt19937& random)
{
  return FT(std::uniform_int_distribution<int>(-20, 20)(random)) / FT(std::uniform_int_distribution<int>(1, 9)(random));
}

Vector random_vector(std::mt19937& random)
{
  const FT x = random_fraction(random), y = random_fraction(random), z = random_fraction(random);
  return {x, y, z};
}

int euler_characteristic(const SC::Smooth_surface_mesh_3::Mesh& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
      static_cast<int>(mesh.number_of_faces());
}

template <class Action>
std::string message_of(const Action& action)
{
  try {
    action();
  } catch (const SC::Invalid_input& error) {
    return error.what();
  }
  return "nothing thrown";
}

// The number of faces that two pieces share, and of those where a derivative of one is not that of the other.
std::pair<int, int> shared_and_broken_faces(const SC::Smooth_surface_3& surface)
{
  std::map<std::set<Point>, std::vector<std::pair<std::size_t, std::array<int, 3>>>> faces;
  for (std::size_t i = 0; i < surface.number_of_patches(); ++i)
    for (int opposite = 0; opposite < 4; ++opposite) {
      std::vector<std::pair<Point, int>> corners;
      for (int k = 0; k < 4; ++k)
        if (k != opposite)
          corners.emplace_back(surface.patch(i).vertex(k), k);
      std::sort(corners.begin(), corners.end());
      faces[{corners[0].first, corners[1].first, corners[2].first}].push_back(
          {i, {corners[0].second, corners[1].second, corners[2].second}});
    }
  std::pair<int, int> result(0, 0);
  for (const auto& [points, sides] : faces) {
    if (sides.size() != 2)
      continue;
    ++result.first;
    const auto first = surface.patch(sides[0].first), second = surface.patch(sides[1].first);
    bool fits = first.form().face(sides[0].second) == second.form().face(sides[1].second);
    for (int axis = 0; axis < 3; ++axis)
      fits = fits && first.derivative(axis).face(sides[0].second) == second.derivative(axis).face(sides[1].second);
    result.second += fits ? 0 : 1;
  }
  return result;
}

} // namespace

TEST(Smooth_surfaces_3, pieces_fit_whatever_is_chosen)
{
  std::mt19937 random(1);
  Mesh mesh = octahedron(2, 3, 1);
  const auto gradients =
      gradients_by(mesh, [&](const Point& p) { return from_origin(p) + random_vector(random) / 60; });
  SC::Smooth_surface_shape shape;
  shape.height = [](std::size_t, bool, const FT&) { return FT(FT(1) / 10); };
  shape.apex_value = [&](const auto&, const FT&) { return random_fraction(random); };
  shape.apex_gradient = [&](const auto&, const Vector&) { return random_vector(random); };
  shape.edge_gradient = [&](std::size_t, std::size_t, const Vector&) { return random_vector(random); };
  shape.gap_value = [&](const auto&, const FT&) { return random_fraction(random); };
  shape.gap_position = FT(2) / FT(5);
  const auto surface = SC::smooth_surface(mesh, gradients, shape);
  EXPECT_EQ(surface.number_of_patches(), 96u);
  EXPECT_EQ(surface.number_of_coefficients(), 686u);
  EXPECT_EQ(shared_and_broken_faces(surface), std::pair(144, 0));
  std::size_t interpolated = 0;
  for (const Vertex v : mesh.vertices())
    interpolated += surface.value(mesh.point(v)) == FT(0) && surface.gradient(mesh.point(v)) == gradients[v];
  EXPECT_EQ(interpolated, 6u);
}

TEST(Smooth_surfaces_3, reproduces_quadrics)
{
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1), z = Polynomial::variable(2);
  const auto sphere = unit_sphere();
  ASSERT_EQ(sphere.number_of_patches(), 96u);
  for (std::size_t i = 0; i < sphere.number_of_patches(); ++i)
    EXPECT_EQ(sphere.patch(i).polynomial(), x * x + y * y + z * z - Polynomial(1));
  EXPECT_TRUE(sphere.is_complete());

  // of others the values at apexes have to be given
  const auto gradient = [](const Point& p) { return Vector(p.x() / 2, p.y() * 2 / 9, p.z() * 2); };
  const Polynomial ellipsoid = Polynomial(FT(1) / 4) * x * x + Polynomial(FT(1) / 9) * y * y + z * z - Polynomial(1);
  Mesh mesh = octahedron(2, 3, 1);
  SC::Smooth_surface_shape shape;
  shape.apex_value = [&](const auto& apex, const FT&) {
    const Point& p = apex.point;
    return FT(p.x() * p.x() / 4 + p.y() * p.y() / 9 + p.z() * p.z() - 1);
  };
  for (const bool is_searched : {false, true}) {
    if (!is_searched)
      shape.height = [](std::size_t, bool, const FT&) { return FT(FT(1) / 10); };
    else
      shape.height = {};
    const auto surface = SC::smooth_surface(mesh, gradients_by(mesh, gradient), shape);
    EXPECT_EQ(surface.number_of_coefficients(), 686u);
    for (std::size_t i = 0; i < surface.number_of_patches(); ++i)
      EXPECT_EQ(surface.patch(i).polynomial(), ellipsoid);
    EXPECT_EQ(surface.is_complete(), is_searched);
  }
}

TEST(Smooth_surfaces_3, sides_are_exact)
{
  const auto sphere = unit_sphere();
  std::mt19937 random(2);
  std::uniform_int_distribution<int> coordinate(-64, 64);
  std::map<CGAL::Bounded_side, int> count;
  const auto check = [&](const Point& p) {
    const CGAL::Bounded_side expected =
        static_cast<CGAL::Bounded_side>(-static_cast<int>(CGAL::sign(power_of_sphere(p))));
    EXPECT_EQ(sphere.bounded_side(p), expected) << p;
    ++count[expected];
  };
  for (int i = 0; i < 300; ++i) {
    const FT size = FT(1) / FT(i % 3 == 0 ? 16 : i % 3 == 1 ? 64 : 400); // far, around, near the center
    check({coordinate(random) * size, coordinate(random) * size, coordinate(random) * size});
  }
  for (const auto& [p, q] : std::vector<std::pair<int, int>>{{3, 4}, {5, 12}, {8, 15}, {20, 21}}) { // on the sphere
    const FT r = FT(p * p + q * q), s = FT(1) / FT(7);
    const FT cosine = FT(q * q - p * p) / r, sine = FT(2 * p * q) / r, u = (1 - s * s) / (1 + s * s),
             v = 2 * s / (1 + s * s);
    check({FT(cosine * u), FT(sine * u), v});
    check({FT(cosine * u), FT(sine * u), FT(v + FT(1) / FT(1000000))});
  }
  check({0, 0, 0});
  check({0, 0, 2});
  check({0, 0, 1});
  EXPECT_GT(count[CGAL::ON_BOUNDED_SIDE], 100);
  EXPECT_GT(count[CGAL::ON_UNBOUNDED_SIDE], 100);
  EXPECT_GE(count[CGAL::ON_BOUNDARY], 5);
}

TEST(Smooth_surfaces_3, hits_are_exact)
{
  const auto sphere = unit_sphere();
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-32, 32);
  std::map<std::size_t, int> count;
  const auto check = [&](const Point& p, const Point& q, bool is_ray) {
    const auto hits = is_ray ? sphere.intersections(K::Ray_3(p, q)) : sphere.intersections(K::Segment_3(p, q));
    // the polynomial a t^2 + b t + c
    const Vector d = q - p, o = p - CGAL::ORIGIN;
    const FT a = d * d, b = 2 * (o * d), c = o * o - 1;
    const auto value = [&](const FT& t) { return FT((a * t + b) * t + c); };
    std::size_t expected = 0;
    if (const FT discriminant = b * b - 4 * a * c; discriminant > 0)
      for (const int sign : {-1, 1}) { // is the root in the range: by its place between a number and the vertex
        const FT vertex = -b / (2 * a);
        const auto is_before = [&](const FT& t) { // whether the root is less
          return sign < 0 ? t > vertex || value(t) < 0 : t > vertex && value(t) > 0;
        };
        expected += !is_before(0) && (is_ray || is_before(1));
      }
    ASSERT_EQ(hits.size(), expected) << p << " to " << q;
    for (const auto& hit : hits) {
      EXPECT_TRUE(hit.lower == hit.upper ? value(hit.lower) == 0 : value(hit.lower) * value(hit.upper) < 0);
      EXPECT_LT(FT(hit.upper - hit.lower), FT(1e-15));
      EXPECT_TRUE(hit.is_crossing());
      EXPECT_EQ(hit.before, &hit == &hits.front() && (hits.size() == 2 || c > 0) ? CGAL::POSITIVE : CGAL::NEGATIVE);
    }
    ++count[expected];
  };
  const auto random_point = [&](int size) {
    const FT scale = FT(1) / size;
    return Point(coordinate(random) * scale, coordinate(random) * scale, coordinate(random) * scale);
  };
  for (int i = 0; i < 90; ++i) {
    const Point p = random_point(i % 3 == 0 ? 15 : 50) + Vector(0, 0, FT(1) / 1000); // no end is on the sphere
    check(p, random_point(17) + Vector(0, 0, FT(1) / 1001), i % 2 == 0);
  }
  check({FT(1) / 8, 0, -3}, {FT(1) / 8, 0, 3}, false); // in common faces
  check({0, 0, -3}, {0, 0, 3}, true);                  // through vertices of the mesh
  EXPECT_GT(count[0], 5);
  EXPECT_GT(count[1], 5);
  EXPECT_GT(count[2], 5);

  // a tangent: touches from outside; and from a point of the surface
  const auto contact = sphere.intersections(K::Segment_3({-1, 0, 1}, {1, 0, 1}));
  ASSERT_EQ(contact.size(), 1u);
  EXPECT_EQ(contact[0].lower, FT(1) / 2);
  EXPECT_EQ(contact[0].upper, FT(1) / 2);
  EXPECT_EQ(contact[0].before, CGAL::POSITIVE);
  EXPECT_EQ(contact[0].after, CGAL::POSITIVE);
  const auto start = sphere.intersections(K::Ray_3(Point(1, 0, 0), Point(0, 0, 0)));
  ASSERT_EQ(start.size(), 2u);
  EXPECT_EQ(start[0].before, CGAL::ZERO);
  EXPECT_EQ(start[0].after, CGAL::NEGATIVE);
  EXPECT_EQ(start[1].lower, FT(2));
  EXPECT_EQ(message_of([&] {
              sphere.intersections(K::Segment_3({1, 0, 0}, {1, 0, 0}));
            }),
            "intersections: the two points of the segment or ray are equal");
}

TEST(Smooth_surfaces_3, is_certified_for_perturbed_gradients)
{
  std::mt19937 random(4);
  for (const int percent : {10, 10, 10, 25, 25, 25}) {
    Mesh mesh = octahedron(1, 1, 1);
    const FT amplitude = FT(percent) / FT(10000);
    std::uniform_int_distribution<int> number(-100, 100);
    const auto surface = SC::smooth_surface(
        mesh, gradients_by(mesh, [&](const Point& p) {
          return from_origin(p) +
              2 * Vector(amplitude * number(random), amplitude * number(random), amplitude * number(random));
        }));
    EXPECT_TRUE(surface.is_complete()) << surface;
    EXPECT_EQ(surface.number_of_certified_patches(), 96u);
    EXPECT_EQ(shared_and_broken_faces(surface), std::pair(144, 0));

    const auto triangles = SC::to_surface_mesh(surface, {.chord_error = 0.02});
    EXPECT_TRUE(triangles.is_complete());
    EXPECT_LE(triangles.error, 0.02);
    EXPECT_TRUE(CGAL::is_closed(triangles.mesh));
    EXPECT_EQ(euler_characteristic(triangles.mesh), 2);
    // vertices are on the surface: beside them are both sides
    int step = 0;
    for (const auto v : triangles.mesh.vertices()) {
      if (++step % 40 != 0)
        continue;
      const auto beside = [&](double distance) { return triangles.mesh.point(v) + distance * triangles.normals[v]; };
      EXPECT_EQ(surface.bounded_side(beside(1e-9)), CGAL::ON_UNBOUNDED_SIDE);
      EXPECT_EQ(surface.bounded_side(beside(-1e-9)), CGAL::ON_BOUNDED_SIDE);
    }
    EXPECT_GT(step, 400);
  }
}

TEST(Smooth_surfaces_3, meshes_are_subdivisions)
{
  const auto sphere = unit_sphere();
  for (int halvings = 0; halvings < 4; ++halvings) {
    const auto triangles = SC::to_surface_mesh(sphere, {.chord_error = 1e-9, .most_halvings = halvings});
    EXPECT_EQ(triangles.mesh.number_of_faces(), 48u << (2 * halvings));
    EXPECT_TRUE(CGAL::is_closed(triangles.mesh));
    EXPECT_FALSE(triangles.is_complete()); // not so fine
    EXPECT_EQ(triangles.undecided().size(), 1u);
    for (const auto v : triangles.mesh.vertices()) {
      const auto normal = triangles.mesh.point(v) - CGAL::ORIGIN;
      EXPECT_NEAR(normal.squared_length(), 1, 1e-14);
      EXPECT_LT((normal - triangles.normals[v]).squared_length(), 1e-24);
    }
    double volume = 0;
    for (const auto face : triangles.mesh.faces()) {
      const auto h = triangles.mesh.halfedge(face);
      const auto &p = triangles.mesh.point(triangles.mesh.source(h)),
                 &q = triangles.mesh.point(triangles.mesh.target(h)),
                 &r = triangles.mesh.point(triangles.mesh.target(triangles.mesh.next(h)));
      const double part = CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN) / 6;
      EXPECT_GT(part, 0);
      volume += part;
    }
    EXPECT_NEAR(volume, 4 * std::numbers::pi / 3, 2.0 / (1 << (2 * halvings)));
  }
}

TEST(Smooth_surfaces_3, has_the_topology_of_the_mesh)
{
  Mesh ring = torus(8, 5);
  const auto surface = SC::smooth_surface(ring, SC::balanced_gradients(ring, SC::estimated_normals(ring)));
  EXPECT_TRUE(surface.is_complete());
  EXPECT_EQ(surface.number_of_components(), 1u);
  EXPECT_EQ(surface.euler_characteristic(), 0);
  EXPECT_EQ(surface.bounded_side(Point(0, 0, 0)), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(surface.bounded_side(Point(2, 0, 0)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(surface.intersections(K::Segment_3({-4, 0, 0}, {4, 0, FT(1) / 8})).size(), 4u);
  const auto triangles = SC::to_surface_mesh(surface, {.chord_error = 0.05});
  EXPECT_TRUE(CGAL::is_closed(triangles.mesh));
  EXPECT_EQ(euler_characteristic(triangles.mesh), 0);

  // a ball with a cavity, and another one
  Mesh mesh;
  add_faces(mesh, ends_of_axes(8, 8, 8), faces_of_octahedron);
  add_faces(mesh, ends_of_axes(1, 1, 1), faces_of_octahedron, true);
  add_faces(mesh, ends_of_axes(2, 2, 2, {20, 0, 0}), faces_of_octahedron);
  const auto balls = SC::smooth_surface(mesh, SC::balanced_gradients(mesh, SC::estimated_normals(mesh)));
  EXPECT_TRUE(balls.is_complete()) << balls;
  EXPECT_EQ(balls.number_of_components(), 3u);
  EXPECT_EQ(balls.euler_characteristic(), 6);
  EXPECT_EQ(balls.bounded_side(Point(0, 0, 0)), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(balls.bounded_side(Point(2, 0, 0)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(balls.bounded_side(Point(10, 0, 0)), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(balls.bounded_side(Point(20, 0, 0)), CGAL::ON_BOUNDED_SIDE);
}

TEST(Smooth_surfaces_3, is_pulled_to_apexes)
{
  Mesh mesh = octahedron(1, 1, 1);
  const auto gradients = gradients_by(mesh, from_origin);
  SC::Smooth_surface_shape shape;
  shape.apex_value = [](const auto& apex, const FT& value) {
    return apex.is_outer && apex.face == 0 ? FT(value / 4) : value;
  };
  const auto ball = unit_sphere(), pulled = SC::smooth_surface(mesh, gradients, shape);
  EXPECT_TRUE(pulled.is_complete());
  EXPECT_EQ(shared_and_broken_faces(pulled), std::pair(144, 0));
  const auto far_along = [](const SC::Smooth_surface_3& surface, const Vector& direction) {
    const auto hits = surface.intersections(K::Ray_3(Point(0, 0, 0), direction));
    EXPECT_EQ(hits.size(), 1u);
    return hits[0].upper;
  };
  EXPECT_GT(far_along(pulled, {1, 1, 1}), FT(far_along(ball, {1, 1, 1}) + FT(1) / 50));
  EXPECT_EQ(far_along(pulled, {-1, -1, -1}), far_along(ball, {-1, -1, -1})); // the change is local
}

TEST(Smooth_surfaces_3, lengths_of_gradients_of_quadrics_are_found)
{
  Mesh mesh;
  add_faces(mesh, ends_of_axes(2, 3, 1), faces_of_octahedron);
  const auto gradient = [](const Point& p) { return Vector(p.x() / 2, p.y() * 2 / 9, p.z() * 2); };
  const auto normals = gradients_by(mesh, [&](const Point& p) {
    const Vector g = gradient(p);
    return g / FT(std::sqrt(CGAL::to_double(g.squared_length())));
  });
  const auto found = SC::balanced_gradients(mesh, normals);
  const double ratio = CGAL::to_double(found[Vertex(0)].x() / gradient(mesh.point(Vertex(0))).x());
  EXPECT_GT(ratio, 0.1);
  for (const Vertex v : mesh.vertices()) {
    const Vector expected = FT(ratio) * gradient(mesh.point(v));
    EXPECT_LT(CGAL::to_double((found[v] - expected).squared_length()), 1e-12);
  }
}

TEST(Smooth_surfaces_3, tells_what_is_not_proved)
{
  Mesh coarse = torus(4, 3);
  const auto failed = SC::smooth_surface(coarse, SC::balanced_gradients(coarse, SC::estimated_normals(coarse)));
  EXPECT_FALSE(failed.is_complete());
  EXPECT_FALSE(failed.summary().is_complete);
  EXPECT_EQ(failed.undecided().size(), failed.number_of_patches() - failed.number_of_certified_patches());
  ASSERT_FALSE(failed.undecided().empty());
  EXPECT_EQ(failed.undecided()[0].place.size(), 3u);
  EXPECT_LT(failed.undecided()[0].parameters[0].operand, 24u);
  const auto triangles = SC::to_surface_mesh(failed, {.chord_error = 1});
  EXPECT_FALSE(triangles.is_complete());
  EXPECT_LT(triangles.mesh.number_of_faces(), 24u * 6);

  Mesh mesh = torus(8, 5);
  const auto gradients = SC::balanced_gradients(mesh, SC::estimated_normals(mesh));
  for (const SC::Solver_options& options :
       {SC::Solver_options{.time_limit = 1e-9}, SC::Solver_options{.node_limit = 500}}) {
    const auto stopped = SC::smooth_surface(mesh, gradients, {}, options);
    EXPECT_FALSE(stopped.is_complete());
    EXPECT_FALSE(stopped.undecided().empty());
    EXPECT_FALSE(SC::to_surface_mesh(stopped).is_complete());
  }
  const auto surface = SC::smooth_surface(mesh, gradients);
  EXPECT_FALSE(SC::to_surface_mesh(surface, {}, {.node_limit = 100}).is_complete());
}

TEST(Smooth_surfaces_3, refuses_bad_input)
{
  const auto refusal = [](Mesh& mesh) {
    const auto gradients = gradients_by(mesh, from_origin);
    return message_of([&] { SC::smooth_surface(mesh, gradients); });
  };
  Mesh empty, open, flat, quadrangle;
  EXPECT_EQ(refusal(empty), "smooth_surface: the mesh has no faces");
  add_faces(open, ends_of_axes(1, 1, 1), Triangles(faces_of_octahedron.begin(), faces_of_octahedron.end() - 1));
  EXPECT_EQ(refusal(open),
            "smooth_surface: the mesh is not closed: its edge from vertex 3 to vertex 0 has face 3 only");
  auto points = ends_of_axes(1, 1, 1);
  points[4] = {FT(1) / 2, FT(1) / 2, 0};
  add_faces(flat, points, faces_of_octahedron);
  EXPECT_EQ(refusal(flat), "smooth_surface: the corners of face 0 are on a line");
  quadrangle.add_face(std::vector<Vertex>{quadrangle.add_vertex(Point(0, 0, 0)), quadrangle.add_vertex(Point(1, 0, 0)),
                                          quadrangle.add_vertex(Point(1, 1, 0)),
                                          quadrangle.add_vertex(Point(0, 1, 0))});
  EXPECT_EQ(refusal(quadrangle), "smooth_surface: face 0 has 4 corners; triangulate it first");

  Mesh mesh = octahedron(1, 1, 1);
  const auto with_gradient = [&](const Vector& g) {
    auto gradients = gradients_by(mesh, from_origin);
    gradients[Vertex(2)] = g;
    return message_of([&] { SC::smooth_surface(mesh, gradients); });
  };
  EXPECT_EQ(with_gradient({0, 0, 0}), "smooth_surface: the normal at vertex 2 is zero");
  EXPECT_EQ(with_gradient({0, -1, 0}),
            "smooth_surface: the normal at vertex 2 does not point to the outer side of face 0");
  Mesh isolated = octahedron(1, 1, 1);
  isolated.add_vertex(Point(5, 5, 5));
  EXPECT_EQ(refusal(isolated), "smooth_surface: vertex 6 has no face");

  SC::Smooth_surface_shape shape;
  shape.gap_position = FT(1);
  const auto gradients = gradients_by(mesh, from_origin);
  EXPECT_EQ(message_of([&] { SC::smooth_surface(mesh, gradients, shape); }),
            "smooth_surface: the gap position is not between 0 and 1");
  shape = {};
  shape.height = [](std::size_t face, bool, const FT&) { return FT(face == 3 ? 0 : 1); };
  EXPECT_EQ(message_of([&] { SC::smooth_surface(mesh, gradients, shape); }),
            "smooth_surface: the height at face 3 is not positive");
  EXPECT_EQ(message_of([&] { SC::to_surface_mesh(unit_sphere(), {.chord_error = 0}); }),
            "to_surface_mesh: the chord error must be positive, the number of halvings from 0 to 12");
}

} // namespace smooth_surfaces_3_test
