// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of implicit surfaces: this package beside Surface_mesher and Mesh_3 of CGAL, and the Coxeter triangulation of
// Gudhi where that is installed, in one run. Each is given the parameter with which the greatest distance of middles of
// triangles from the surface, measured by the same code, is that of the problem. Prints a table in Markdown.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/make_surface_mesh.h>

#if __has_include(<gudhi/Manifold_tracing.h>)
#include <gudhi/Coxeter_triangulation.h>
#include <gudhi/Coxeter_triangulation/Cell_complex/Cell_complex.h>
#include <gudhi/Implicit_manifold_intersection_oracle.h>
#include <gudhi/Manifold_tracing.h>
#define PEERS_GUDHI
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>

namespace peers {
namespace {

namespace SC = CGAL::Spline_constraints;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

double square(double x) { return x * x; }

// Formulas with integers, of expressions as well as doubles.
constexpr auto sphere = [](const auto& x, const auto& y, const auto& z) {
  return square(x) + square(y) + square(z) - 1;
};
constexpr auto torus = [](const auto& x, const auto& y, const auto& z) { // of radii 1 and 3/10
  const auto ring = square(x) + square(y);
  return square(100 * ring + 100 * square(z) + 91) - 40000 * ring;
};
constexpr auto tangle_cube = [](const auto& x, const auto& y, const auto& z) {
  const auto quartic = [](const auto& t) { return 5 * square(square(t)) - 25 * square(t); };
  return quartic(x) + quartic(y) + quartic(z) + 59;
};
constexpr auto chebyshev_sum = [](const auto& x, const auto& y, const auto& z) {
  const auto t6 = [](const auto& t) { return 32 * square(t * t * t) - 48 * square(square(t)) + 18 * square(t) - 1; };
  return t6(x) + t6(y) + t6(z);
};
constexpr auto torus_and_ball = [](const auto& x, const auto& y, const auto& z) { // of radius 1e-3 about (1/8, 1/4, 0)
  return torus(x, y, z) * (square(8000 * x - 1000) + square(8000 * y - 2000) + square(8000 * z) - 64);
};

using Function = std::function<double(double, double, double)>;

// The distance of a point from the surface beside it, by Newton's method.
double distance_from_surface(const Function& f, const Point& from)
{
  constexpr int steps = 20;
  constexpr double h = 1e-6;
  Point p = from;
  for (int k = 0; k < steps; ++k) {
    const double x = p.x(), y = p.y(), z = p.z();
    const Vector slope =
        Vector(f(x + h, y, z) - f(x - h, y, z), f(x, y + h, z) - f(x, y - h, z), f(x, y, z + h) - f(x, y, z - h)) /
        (2 * h);
    p = p - f(x, y, z) / slope.squared_length() * slope;
  }
  return std::sqrt(CGAL::squared_distance(from, p));
}

// Of middles of triangles and of edges: where a surface bends to both sides it is far from edges alone.
double measured_error(const Function& f, const Mesh& mesh)
{
  double result = 0;
  const auto add = [&](const Point& p) { result = (std::max)(result, distance_from_surface(f, p)); };
  for (const auto face : mesh.faces()) {
    const auto h = mesh.halfedge(face);
    add(CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))));
  }
  for (const auto e : mesh.edges())
    add(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return result;
}

double share_of_small_angles(const Mesh& mesh)
{
  std::size_t small = 0;
  for (const auto h : mesh.halfedges())
    if (!mesh.is_border(h))
      small += CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                       mesh.point(mesh.target(mesh.next(h)))) < 20
          ? 1
          : 0;
  return static_cast<double>(small) / (3.0 * static_cast<double>(mesh.number_of_faces()));
}

struct Answer
{
  Mesh mesh;
  double seconds = 0;
};

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

template <class Surface>
Answer with_this_package(const Surface& surface, double radius, double error)
{
  const Clock::time_point start = Clock::now();
  const SC::Exact_rational bound(radius);
  const auto [x, y, z] = SC::unknowns({-bound, bound}, {-bound, bound}, {-bound, bound});
  const SC::Solution_surface_mesh result =
      SC::to_surface_mesh(SC::solve_surfaces(surface(x, y, z) == 0),
                          {.chord_error = error, .angle = 1}); // the others have no bound on angles
  const double seconds = seconds_since(start);
  Answer answer{result.mesh, seconds};
  if (!result.is_complete())
    std::printf("incomplete\n");
  return answer;
}

template <class Surface>
Answer with_surface_mesher(const Surface& surface, double radius, double error)
{
  using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
  using Traits = Triangulation::Geom_traits;
  const Clock::time_point start = Clock::now();
  const auto function = [&](const Traits::Point_3& p) { return surface(p.x(), p.y(), p.z()); };
  constexpr double precision = 1e-6, least_angle = 25;
  const double around = 2 * radius; // the sphere is around the box
  const CGAL::Implicit_surface_3<Traits, decltype(function)> implicit(
      function, Traits::Sphere_3(CGAL::ORIGIN, square(around)), precision);
  Triangulation triangulation;
  CGAL::Complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  CGAL::make_surface_mesh(complex, implicit,
                          CGAL::Surface_mesh_default_criteria_3<Triangulation>(least_angle, radius, error),
                          CGAL::Manifold_tag());
  Answer answer;
  CGAL::Surface_mesh<Traits::Point_3> mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  answer.seconds = seconds_since(start);
  CGAL::copy_face_graph(mesh, answer.mesh);
  return answer;
}

template <class Surface>
Answer with_mesh_3(const Surface& surface, double radius, double error)
{
  using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
  using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  namespace parameters = CGAL::parameters;
  const Clock::time_point start = Clock::now();
  constexpr double precision = 1e-6, least_angle = 25;
  const double around = 2 * radius;
  const Domain domain = Domain::create_implicit_mesh_domain(
      [&](const Kernel::Point_3& p) { return surface(p.x(), p.y(), p.z()); },
      Kernel::Sphere_3(CGAL::ORIGIN, square(around)), parameters::relative_error_bound = precision);
  const CGAL::Mesh_criteria_3<Triangulation> criteria(parameters::facet_angle = least_angle,
                                                      parameters::facet_distance = error);
  const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude(),
                                                     parameters::manifold());
  Answer answer;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);
  answer.seconds = seconds_since(start);
  CGAL::copy_face_graph(mesh, answer.mesh);
  return answer;
}

// The coarsest of a few meshes that keeps the error. Errors grow with the parameter, nearly in proportion.
template <class Mesher>
Answer at_error(const Mesher& mesher, const Function& f, double error)
{
  constexpr int most_rounds = 5;
  constexpr double least_share = 0.9;
  Answer best;
  double parameter = error;
  for (int round = 0; round < most_rounds; ++round) {
    Answer answer = mesher(parameter);
    const double share = measured_error(f, answer.mesh) / error;
    if (share <= 1 && (best.mesh.is_empty() || answer.mesh.number_of_vertices() < best.mesh.number_of_vertices()))
      best = std::move(answer);
    if (least_share <= share && share <= 1)
      break;
    constexpr double aim = 0.95;
    parameter *= aim / share;
  }
  return best;
}

void print_row(const char* name, const char* program, const Function& f, const Answer& answer)
{
  const Mesh& mesh = answer.mesh;
  Mesh copy = mesh;
  const auto component = copy.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t components = CGAL::Polygon_mesh_processing::connected_components(copy, component);
  const long characteristic = static_cast<long>(mesh.number_of_vertices()) - static_cast<long>(mesh.number_of_edges()) +
      static_cast<long>(mesh.number_of_faces());
  std::printf("| %s | %s | %zu | %.0f | %.2e | %.2f | %zu | %ld | %s |\n", name, program,
              static_cast<std::size_t>(mesh.number_of_vertices()), 1e3 * answer.seconds, measured_error(f, mesh),
              100 * share_of_small_angles(mesh), components, characteristic, CGAL::is_closed(mesh) ? "yes" : "no");
  std::fflush(stdout);
}

template <class Surface>
void compare(const char* name, const Surface& surface, double radius, double error)
{
  const Function f = [&](double x, double y, double z) { return surface(x, y, z); };
  print_row(name, "this package", f,
            at_error([&](double bound) { return with_this_package(surface, radius, bound); }, f, error));
  print_row(name, "Surface_mesher", f,
            at_error([&](double bound) { return with_surface_mesher(surface, radius, bound); }, f, error));
  print_row(name, "Mesh_3", f, at_error([&](double bound) { return with_mesh_3(surface, radius, bound); }, f, error));
}

#ifdef PEERS_GUDHI

struct Clifford_torus
{
  Eigen::VectorXd operator()(const Eigen::VectorXd& p) const
  {
    return Eigen::Vector2d(square(p[0]) + square(p[1]) - 1, square(p[2]) + square(p[3]) - 1);
  }
  std::size_t amb_d() const { return 4; }
  std::size_t cod_d() const { return 2; }
  Eigen::VectorXd seed() const { return Eigen::Vector4d(0.6, 0.8, 0.28, 0.96); }
};

double distance_from_clifford_torus(const Eigen::VectorXd& p)
{
  return std::hypot(std::hypot(p[0], p[1]) - 1, std::hypot(p[2], p[3]) - 1);
}

// The vertices of a cell complex of Gudhi are not on the surface, but on chords of it.
void compare_clifford_torus(double size)
{
  namespace Coxeter = Gudhi::coxeter_triangulation;
  Clock::time_point start = Clock::now();
  const Clifford_torus function;
  Coxeter::Coxeter_triangulation<> triangulation(function.amb_d());
  triangulation.change_offset(Eigen::Vector4d(0.123, 0.0456, 0.0789, 0.03));
  triangulation.change_matrix(size * triangulation.matrix());
  using Tracing = Coxeter::Manifold_tracing<Coxeter::Coxeter_triangulation<>>;
  Tracing::Out_simplex_map simplices;
  Coxeter::manifold_tracing_algorithm(std::array{function.seed()}, triangulation, Coxeter::make_oracle(function),
                                      simplices);
  Coxeter::Cell_complex<Tracing::Out_simplex_map> complex(2);
  complex.construct_complex(simplices);
  const double seconds = seconds_since(start);
  long characteristic = 0;
  for (std::size_t d = 0; d < 3; ++d)
    characteristic += (d == 1 ? -1 : 1) * static_cast<long>(complex.interior_simplex_cell_maps()[d].size());
  double error = 0;
  for (const auto& [cell, point] : complex.cell_point_map())
    error = (std::max)(error, distance_from_clifford_torus(point));
  std::printf("| Clifford torus | Gudhi | %zu | %.0f | %.2e | %ld |\n", complex.cell_point_map().size(), 1e3 * seconds,
              error, characteristic);

  start = Clock::now();
  const auto [p, q, r, s] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  const SC::Surface_solution_set_d set = SC::solve_surfaces(square(p) + square(q) == 1, square(r) + square(s) == 1);
  const double of_topology = seconds_since(start);
  // (p, q, r) / (3 - s) maps it to a ring, one to one
  const SC::Expression factor = 3 / (3 - s);
  const SC::Solution_surface_mesh result =
      SC::to_surface_mesh(set, SC::Vector_expression<3>(factor * p, factor * q, factor * r), {.chord_error = error});
  const double all = seconds_since(start);
  double own_error = 0;
  for (const auto face : result.mesh.faces()) {
    Eigen::VectorXd middle = Eigen::VectorXd::Zero(4);
    for (const auto v : result.mesh.vertices_around_face(result.mesh.halfedge(face)))
      for (Eigen::Index j = 0; j < 4; ++j)
        middle[j] += result.unknowns[v][static_cast<std::size_t>(j)] / 3;
    own_error = (std::max)(own_error, distance_from_clifford_torus(middle));
  }
  std::printf("| Clifford torus | this package | %zu | %.0f (topology %.0f) | %.2e | %d |\n",
              static_cast<std::size_t>(result.mesh.number_of_vertices()), 1e3 * all, 1e3 * of_topology, own_error,
              set.euler_characteristic());
}

#endif

} // namespace
} // namespace peers

int main()
{
  using namespace peers;
  std::printf(
      "| surface | program | vertices | ms | error | angles below 20 degrees, %% | components | characteristic | "
      "closed |\n|---|---|--:|--:|--:|--:|--:|--:|---|\n");
  compare("sphere", sphere, 2, 1e-3);
  compare("torus", torus, 2, 1e-3);
  compare("tangle cube", tangle_cube, 3, 4e-3);
  compare("Chebyshev", chebyshev_sum, 1.25, 2e-3);
  compare("torus and ball", torus_and_ball, 2, 1e-3);
#ifdef PEERS_GUDHI
  std::printf("\n| surface | program | vertices | ms | error | characteristic |\n|---|---|--:|--:|--:|--:|\n");
  compare_clifford_torus(0.1);
#endif
}
