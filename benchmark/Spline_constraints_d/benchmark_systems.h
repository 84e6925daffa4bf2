// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_BENCHMARK_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_BENCHMARK_SYSTEMS_H

#include "../../test/Spline_constraints_d/solver_test_systems.h"

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>

#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Systems that the benchmarks solve, beyond those of the tests.
namespace solver_benchmark {

namespace SC = CGAL::Spline_constraints;
using solver_test::Polynomial;
using solver_test::Rational;
using solver_test::Relation;
using solver_test::square;
using solver_test::System;

// What has a name for the table. The builders of the tests come with the solutions, which are not needed here.
struct Named_system
{
  std::string name;
  System system;
};

inline Named_system named(std::string name, const solver_test::Problem& problem)
{
  return {std::move(name), problem.system};
}

inline Named_system broyden(int n)
{
  return named("broyden/" + std::to_string(n), solver_test::broyden_tridiagonal(n));
}

inline Named_system cyclic(int n, int degree)
{
  return named("cyclic/" + std::to_string(n) + '/' + std::to_string(degree), solver_test::cyclic_chebyshev(n, degree));
}

inline Named_system mixed(int n, int degree)
{
  return named("mixed/" + std::to_string(n) + '/' + std::to_string(degree), solver_test::mixed_chebyshev(n, degree));
}

// The N^2 intersections of the curves y = T_N(x) and x = T_N(y).
inline Named_system chebyshev_curves(int degree)
{
  return named("chebyshev_curves/" + std::to_string(degree), solver_test::cyclic_chebyshev(2, degree));
}

inline Named_system brown(int n)
{
  return named("brown/" + std::to_string(n), solver_test::brown(n, Rational(100000000)));
}

// Katsura's equations with n + 1 unknowns: sum over l of u_|l| u_|m-l| = u_m for m = 0..n-1, and sum of u_|l| = 1.
inline Named_system katsura(int n)
{
  const std::vector<Polynomial> u = solver_test::variables(n + 1);
  std::vector<Polynomial> functions{-1 + u[0]};
  for (int l = 1; l <= n; ++l)
    functions[0] += 2 * u[l];
  for (int m = 0; m < n; ++m) {
    Polynomial f = -u[m];
    for (int l = -n; l <= n; ++l)
      if (std::abs(m - l) <= n)
        f += u[std::abs(l)] * u[std::abs(m - l)];
    functions.push_back(std::move(f));
  }
  const Rational side = solver_test::fraction(3, 2);
  return {"katsura/" + std::to_string(n),
          solver_test::with_equalities(solver_test::cube(n + 1, -side, side), functions)};
}

// Two double roots.
inline Named_system circle_and_hyperbola()
{
  const auto v = solver_test::variables(2);
  return {
      "cluster/circle_and_hyperbola",
      solver_test::with_equalities(solver_test::cube(2, -3, 3), {square(v[0]) + square(v[1]) - 2, v[0] * v[1] - 1})};
}

// The parabola (2t - 1, (2t - 1)^2) and the line from (-3/2, height) to (5/4, height): they cross, touch or miss each
// other.
inline Named_system parabola_and_line(const std::string& name, const Rational& height)
{
  const auto v = solver_test::variables(2);
  return {
      "degenerate/" + name,
      solver_test::with_equalities(solver_test::cube(2, 0, 1),
                                   {2 * v[0] - 1 + solver_test::fraction(3, 2) - solver_test::fraction(11, 4) * v[1],
                                    square(2 * v[0] - 1) - height})};
}

// Two pieces of one cubic that overlap.
inline Named_system overlap()
{
  const auto v = solver_test::variables(2);
  const Polynomial a = 3 * v[0] / 4, b = 3 * v[1] / 4 + solver_test::fraction(1, 4);
  return {"degenerate/overlap",
          solver_test::with_equalities(solver_test::cube(2, 0, 1), {a - b, pow(a, 3) - a - pow(b, 3) + b})};
}

// A line of solutions and four roots beside it.
inline Named_system common_line()
{
  const auto v = solver_test::variables(2);
  const Polynomial line = v[0] - v[1];
  return {"degenerate/common_line",
          solver_test::with_equalities(
              solver_test::cube(2, -2, 2),
              {line * (square(v[0]) + square(v[1]) - 2), line * (v[0] * v[1] - solver_test::fraction(1, 2))})};
}

// Three quadrics that share two circles.
inline Named_system pencil_of_quadrics()
{
  const auto v = solver_test::variables(3);
  const Polynomial sphere = square(v[0]) + square(v[1]) + square(v[2]) - 2,
                   cone = square(v[0]) + square(v[1]) - square(v[2]);
  return {"degenerate/pencil_of_quadrics",
          solver_test::with_equalities(solver_test::cube(3, -2, 2), {sphere, cone, sphere * v[0] + cone * v[1]})};
}

// The unit directions of the lines that touch four spheres: 12 double roots with irrational coordinates.
inline Named_system irrational_double_roots()
{
  const auto v = solver_test::variables(3);
  const Polynomial x = square(v[0]), y = square(v[1]), z = square(v[2]);
  return {"degenerate/irrational_double_roots",
          solver_test::with_equalities(
              solver_test::cube(3, -1, 1),
              {v[0] * v[1] * v[2], x * y + y * z + z * x - solver_test::fraction(1, 4), x + y + z - 1})};
}

// A triple root (Griewank and Osborne) and one of multiplicity four, both in the origin.
inline Named_system griewank_osborne()
{
  const auto v = solver_test::variables(2);
  return {"cluster/griewank_osborne",
          solver_test::with_equalities(solver_test::cube(2, -3, 3),
                                       {29 * pow(v[0], 3) / 16 - 2 * v[0] * v[1], v[1] - square(v[0])})};
}

inline Named_system two_pairs_of_lines()
{
  const auto v = solver_test::variables(2);
  return {"cluster/two_pairs_of_lines",
          solver_test::with_equalities(solver_test::cube(2, -3, 3), {square(v[0]) - square(v[1]), v[0] * v[1]})};
}

// A coordinate function of a clamped uniform cubic B-spline curve.
inline SC::Spline_function cubic_spline(int variable, const std::vector<Rational>& control)
{
  std::vector<Rational> knots(4, Rational(0));
  const int pieces = static_cast<int>(control.size()) - 3;
  for (int k = 1; k < pieces; ++k)
    knots.push_back(Rational(k));
  knots.resize(knots.size() + 4, Rational(pieces));
  const SC::Bspline_function<Rational> spline({3}, {knots}, control);
  return SC::Spline_function::from_bezier_pieces({variable}, {spline.breaks(0)}, spline.bezier_pieces());
}

using Control_polygon = std::vector<std::pair<Rational, Rational>>;

inline System spline_curves(const Control_polygon& a, const Control_polygon& b)
{
  std::vector<Rational> ax, ay, bx, by;
  for (const auto& [x, y] : a) {
    ax.push_back(x);
    ay.push_back(y);
  }
  for (const auto& [x, y] : b) {
    bx.push_back(-x);
    by.push_back(-y);
  }
  System system(std::vector<System::Domain>{{0, Rational(static_cast<int>(a.size()) - 3)},
                                            {0, Rational(static_cast<int>(b.size()) - 3)}});
  system.add(cubic_spline(0, ax) + cubic_spline(1, bx), Relation::EQUAL);
  system.add(cubic_spline(0, ay) + cubic_spline(1, by), Relation::EQUAL);
  return system;
}

// A zigzag of 12 control points and its transpose.
inline Named_system wiggly_splines()
{
  Control_polygon a, b;
  for (int i = 0; i < 12; ++i) {
    a.emplace_back(Rational(i), Rational(i % 2 == 0 ? -11 : 22));
    b.emplace_back(a.back().second, a.back().first);
  }
  return {"splines/wiggly", spline_curves(a, b)};
}

// 12 random control points each.
inline Named_system random_splines()
{
  std::mt19937_64 engine(2);
  const auto random = [&] { return solver_test::fraction(static_cast<int>(engine() % 2001) - 1000, 1000); };
  Control_polygon curves[2];
  for (Control_polygon& curve : curves)
    for (int i = 0; i < 12; ++i) {
      const Rational x = random();
      curve.emplace_back(x, random());
    }
  return {"splines/random", spline_curves(curves[0], curves[1])};
}

// Polynomials in one unknown: Chebyshev's, Wilkinson's, and random ones with coefficients up to 100.
inline Named_system univariate(std::string name, const Rational& lower, const Rational& upper,
                               const Polynomial& function)
{
  return {"univariate/" + std::move(name), solver_test::with_equalities(System({{lower, upper}}), {function})};
}

inline Named_system univariate_chebyshev(int degree)
{
  return univariate("chebyshev/" + std::to_string(degree), -1, 1,
                    solver_test::chebyshev(degree, Polynomial::variable(0)));
}

inline Named_system wilkinson(int degree)
{
  Polynomial function(1);
  for (int i = 1; i <= degree; ++i)
    function *= Polynomial::variable(0) - i;
  return univariate("wilkinson/" + std::to_string(degree), 0, degree + 1, function);
}

inline Named_system random_polynomial(int degree)
{
  std::mt19937 random(static_cast<unsigned>(degree));
  Polynomial function;
  for (int k = 0; k <= degree; ++k)
    function += Rational(static_cast<int>(random() % 201) - 100) * pow(Polynomial::variable(0), k);
  return univariate("random/" + std::to_string(degree), -2, 2, function);
}

// An irrational root of multiplicity two, and a rational one of multiplicity three.
inline Named_system multiple_roots()
{
  const Polynomial x = Polynomial::variable(0);
  return univariate("multiple_roots", 0, 2, square(x * x - 2) * pow(x - 1, 3));
}

// A receiver with the error of its clock, from the distances to four stations one apart in a box of 2000.
inline Named_system multilateration()
{
  const auto x = solver_test::variables(4);
  System system = solver_test::cube(4, -1000, 1000);
  for (int station = 0; station < 4; ++station) {
    Polynomial squares = -square(x[3] + 5 + (station == 3 ? 9 : 12));
    for (int j = 0; j < 3; ++j)
      squares += square(x[j] - (j == station ? 1 : 0));
    system.add(squares, Relation::EQUAL);
  }
  return {"multilateration", std::move(system)};
}

// Two systems without a common unknown: the solutions are n^2 m^2.
inline Named_system independent_chebyshev_curves(int n, int m)
{
  const auto x = solver_test::variables(4);
  const auto chebyshev = [](int degree, const Polynomial& v) { return solver_test::chebyshev(degree, v); };
  return {"independent/" + std::to_string(n) + '/' + std::to_string(m),
          solver_test::with_equalities(solver_test::cube(4, -1, 1),
                                       {chebyshev(n, x[0]) - x[1], chebyshev(n, x[1]) - x[0], chebyshev(m, x[2]) - x[3],
                                        chebyshev(m, x[3]) - x[2]})};
}

// Random quadrics through a point in space, of dimension n, cut by n - 2 random hyperplanes through it.
inline Named_system hyperplanes_and_quadrics(int n)
{
  std::mt19937 random(2027);
  const auto coefficient = [&] { return Rational(static_cast<int>(random() % 19) - 9); };
  const auto x = solver_test::variables(n);
  std::vector<Polynomial> functions;
  for (int i = 0; i < n; ++i) {
    Polynomial f;
    for (int j = 0; j < n; ++j)
      f += coefficient() * (x[j] - Rational(j % 3) / 4) * (i < 2 ? x[j] + coefficient() / 9 : Polynomial(Rational(1)));
    functions.push_back(std::move(f));
  }
  return {"hyperplanes_and_quadrics/" + std::to_string(n),
          solver_test::with_equalities(solver_test::cube(n, -2, 2), functions)};
}

// Systems of two random quadratic equations in two unknowns.
inline std::vector<System> quadratic_systems(int count)
{
  std::mt19937 random(2026);
  const auto coefficient = [&] { return Rational(static_cast<int>(random() % 21) - 10); };
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1);
  std::vector<System> systems;
  for (int i = 0; i < count; ++i) {
    std::vector<Polynomial> functions;
    for (int k = 0; k < 2; ++k)
      functions.push_back(coefficient() * x * x + coefficient() * x * y + coefficient() * y * y + coefficient() * x +
                          coefficient() * y + coefficient());
    systems.push_back(solver_test::with_equalities(solver_test::cube(2, -1, 1), functions));
  }
  return systems;
}

} // namespace solver_benchmark

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_BENCHMARK_SYSTEMS_H
