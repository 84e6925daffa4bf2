// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_SOLVER_TEST_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_SOLVER_TEST_SYSTEMS_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

// Systems whose solutions are known, shared by the tests of the solver.
namespace solver_test {

namespace SC = CGAL::Spline_constraints;
using SC::Relation;
using Rational = SC::Exact_rational;
using Polynomial = SC::Power_polynomial;
using System = SC::Constraint_system_d;

inline Rational fraction(int numerator, int denominator) { return Rational(numerator) / Rational(denominator); }

// A coordinate of a solution: a range of width zero when it is rational, else one that is known to hold it.
struct Coordinate
{
  Rational lower, upper;

  // Rationals, integers, and formulas of rationals.
  template <std::convertible_to<Rational> T>
  Coordinate(const T& value) : lower(value), upper(lower) {}
  static Coordinate between(const Rational& lower, const Rational& upper)
  {
    Coordinate result(lower);
    result.upper = upper;
    return result;
  }
  static Coordinate near(double value, double error = 4e-15)
  {
    return between(Rational(value) - Rational(error), Rational(value) + Rational(error));
  }

  // The positive square root of a number up to 100 that is not a square, to some 300 bits.
  static Coordinate square_root(const Rational& number)
  {
    Rational lower(0), width(16);
    for (int bits = 0; bits < 304; ++bits) {
      width /= 2;
      const Rational middle = lower + width;
      if (middle * middle < number)
        lower = middle;
    }
    return between(lower, lower + width);
  }

  bool is_rational() const { return lower == upper; }

  // A short number: this one, or one close by.
  Rational about() const { return is_rational() ? lower : Rational(CGAL::to_double(lower)); }

  friend Coordinate operator+(const Coordinate& a, const Coordinate& b)
  {
    return between(a.lower + b.lower, a.upper + b.upper);
  }
  friend Coordinate operator-(const Coordinate& a, const Coordinate& b)
  {
    return between(a.lower - b.upper, a.upper - b.lower);
  }
  friend Coordinate operator*(const Coordinate& a, const Coordinate& b)
  {
    const auto [least, largest] = std::minmax({Rational(a.lower * b.lower), Rational(a.lower * b.upper),
                                               Rational(a.upper * b.lower), Rational(a.upper * b.upper)});
    return between(least, largest);
  }
};

using Point = std::vector<Coordinate>;

struct Problem
{
  std::string name;
  System system;
  std::size_t count;           // of the solutions
  std::vector<Point> known;    // all of them, some, or none
};

inline Problem all_known(std::string name, System system, std::vector<Point> known)
{
  const std::size_t count = known.size();
  return {std::move(name), std::move(system), count, std::move(known)};
}

inline std::vector<Polynomial> variables(int count)
{
  std::vector<Polynomial> result;
  for (int i = 0; i < count; ++i)
    result.push_back(Polynomial::variable(i));
  return result;
}

inline System cube(int dimension, const Rational& lower, const Rational& upper)
{
  return System(std::vector<System::Domain>(dimension, {lower, upper}));
}

inline System with_equalities(System system, const std::vector<Polynomial>& functions)
{
  for (const Polynomial& function : functions)
    system.add(function, Relation::EQUAL);
  return system;
}

inline Polynomial square(const Polynomial& p) { return p * p; }

// The polynomial with all unknowns replaced.
inline Polynomial composed(const Polynomial& p, const std::vector<Polynomial>& replacements)
{
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    Polynomial product(coefficient);
    for (const auto& [variable, exponent] : monomial.powers)
      product *= pow(replacements[variable], exponent);
    result += product;
  }
  return result;
}

inline std::vector<Polynomial> composed(const std::vector<Polynomial>& functions,
                                        const std::vector<Polynomial>& replacements)
{
  std::vector<Polynomial> result;
  for (const Polynomial& function : functions)
    result.push_back(composed(function, replacements));
  return result;
}

inline Coordinate value_at(const Polynomial& p, const Point& point)
{
  Coordinate result(0);
  for (const auto& [monomial, coefficient] : p.terms()) {
    Coordinate product(coefficient);
    for (const auto& [variable, exponent] : monomial.powers)
      for (int i = 0; i < exponent; ++i)
        product = product * point[variable];
    result = result + product;
  }
  return result;
}

inline Polynomial chebyshev(int degree, const Polynomial& x)
{
  Polynomial before(1), current = x;
  for (int k = 1; k < degree; ++k) {
    Polynomial next = Polynomial(2) * x * current - before;
    before = std::exchange(current, std::move(next));
  }
  return degree == 0 ? before : current;
}

// Problem 1: T_d(x_i) = x_{i+1 mod n}; its d^n solutions follow the angles 2 pi k / (d^n -+ 1).
inline Problem cyclic_chebyshev(int n, int degree)
{
  const std::vector<Polynomial> x = variables(n);
  std::vector<Polynomial> functions;
  for (int i = 0; i < n; ++i)
    functions.push_back(chebyshev(degree, x[i]) - x[(i + 1) % n]);
  long count = 1;
  for (int i = 0; i < n; ++i)
    count *= degree;
  std::vector<Point> known;
  const auto add = [&](long k, long modulus) {
    Point point;
    for (int i = 0; i < n; ++i) {
      point.push_back(k % modulus == 0           ? Coordinate(1)
                          : 2 * k % modulus == 0 ? Coordinate(-1)
                          : 4 * k % modulus == 0 ? Coordinate(0)
                          : 3 * k % modulus == 0 ? Coordinate(fraction(-1, 2))
                          : 6 * k % modulus == 0
                          ? Coordinate(fraction(1, 2))
                          : Coordinate::near(
                                std::cos(2 * std::acos(-1.0) * static_cast<double>(k) / static_cast<double>(modulus))));
      k = k * degree % modulus;
    }
    known.push_back(std::move(point));
  };
  for (long k = 0; 2 * k <= count - 1; ++k)
    add(k, count - 1);
  for (long k = 1; 2 * k < count + 1; ++k)
    add(k, count + 1);
  return all_known("cyclic Chebyshev " + std::to_string(n) + ", " + std::to_string(degree),
                   with_equalities(cube(n, -1, 1), functions), std::move(known));
}

// Problem 2: the same seen in a mirror, which makes all equations dense.
inline Problem mixed_chebyshev(int n, int degree)
{
  const Problem plain = cyclic_chebyshev(n, degree);
  Rational length(0);
  for (int i = 1; i <= n; ++i)
    length += Rational(i * i);
  std::vector<std::vector<Rational>> mirror(n, std::vector<Rational>(n));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      mirror[i][j] = Rational(i == j ? 1 : 0) - Rational(2 * (i + 1) * (j + 1)) / length;

  const std::vector<Polynomial> y = variables(n);
  std::vector<Polynomial> x(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      x[i] += Polynomial(mirror[i][j]) * y[j];
  std::vector<Polynomial> functions;
  for (int i = 0; i < n; ++i)
    functions.push_back(chebyshev(degree, x[i]) - x[(i + 1) % n]);

  std::vector<Point> known;
  for (const Point& point : plain.known) {
    Point image;
    for (int i = 0; i < n; ++i) {
      Coordinate sum(0);
      for (int j = 0; j < n; ++j)
        sum = sum + mirror[i][j] * point[j];
      image.push_back(sum);
    }
    known.push_back(std::move(image));
  }
  const Rational side(std::ceil(1024 * std::sqrt(n)) / 1024);
  return all_known("mixed Chebyshev " + std::to_string(n) + ", " + std::to_string(degree),
                   with_equalities(cube(n, -side, side), functions), std::move(known));
}

// Problem 3.
inline Problem circle_and_ellipse()
{
  const auto x = variables(2);
  return all_known(
      "circle and ellipse",
      with_equalities(cube(2, 0, 1), {square(x[0]) + square(x[1]) - 1, square(x[0]) / 4 + 4 * square(x[1]) - 1}),
      {{Coordinate::near(2 / std::sqrt(5)), Coordinate::near(1 / std::sqrt(5))}});
}

// Problem 7.
inline Problem curves_of_degree_six()
{
  const auto v = variables(2);
  const Polynomial &x = v[0], &y = v[1];
  const auto point = [](double a, double b) { return Point{Coordinate::near(a, 1e-9), Coordinate::near(b, 1e-9)}; };
  return all_known("curves of degree six",
                   with_equalities(cube(2, -3, 3),
                                   {(pow(x, 4) + pow(y, 4) - 1) * (x * x + y * y - 2) + pow(x, 5) * y,
                                    x * x + 2 * x * y * y - 2 * y * y - Rational(0.5)}),
                   {point(0.820978892, -0.697132646), point(0.899917921, -1.244182761),
                    point(-0.936897967, 0.312284082), point(-1.671421393, 0.655205186)});
}

// A Bezier curve as a polynomial in one unknown.
inline Polynomial bezier(const std::vector<Rational>& control, const Polynomial& t)
{
  std::vector<Polynomial> points(control.begin(), control.end());
  while (points.size() > 1) {   // de Casteljau
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = (1 - t) * points[i] + t * points[i + 1];
    points.pop_back();
  }
  return points[0];
}

inline System curve_intersection(const std::vector<std::pair<Rational, Rational>>& a,
                                 const std::vector<std::pair<Rational, Rational>>& b)
{
  std::array<std::vector<Rational>, 4> control;
  for (const auto& [x, y] : a) {
    control[0].push_back(x);
    control[1].push_back(y);
  }
  for (const auto& [x, y] : b) {
    control[2].push_back(x);
    control[3].push_back(y);
  }
  const auto t = variables(2);
  return with_equalities(cube(2, 0, 1), {bezier(control[0], t[0]) - bezier(control[2], t[1]),
                                         bezier(control[1], t[0]) - bezier(control[3], t[1])});
}

// Problem 8: y = T3(x) and x = T3(y), at x = 2 t - 1 and y = 2 s - 1.
inline Problem bezier_cubics()
{
  const Rational third = fraction(1, 3);
  const std::vector<std::pair<Rational, Rational>> curve{{-1, -1}, {-third, 5}, {third, -5}, {1, 1}};
  std::vector<std::pair<Rational, Rational>> mirror;
  for (const auto& [x, y] : curve)
    mirror.emplace_back(y, x);
  Problem angles = cyclic_chebyshev(2, 3);
  for (Point& point : angles.known)
    for (Coordinate& c : point) {
      c.lower = (c.lower + 1) / 2;
      c.upper = (c.upper + 1) / 2;
    }
  return all_known("cubic Bezier curves", curve_intersection(curve, mirror), angles.known);
}

// Problem 22.
inline Problem wiggly_beziers()
{
  std::vector<std::pair<Rational, Rational>> curve, transposed;
  for (int i = 0; i <= 10; ++i) {
    curve.emplace_back(fraction(i, 10), i % 2 == 0 ? 1 : -1);
    transposed.emplace_back(curve.back().second, curve.back().first);
  }
  return {"wiggly Bezier curves", curve_intersection(curve, transposed), 4, {{Coordinate(1), Coordinate(1)}}};
}

// Problem 11: circles tangent to unit circles at (0,2), (-sqrt 3,-1), (sqrt 3,-1), touched from the sides (1: outside,
// -1: inside), which are unknowns too. The first coordinate is in units of sqrt 3.
inline Problem apollonius()
{
  const auto v = variables(6);
  const int centre[3][2] = {{0, 2}, {-1, -1}, {1, -1}};
  std::vector<Polynomial> functions;
  for (int k = 0; k < 3; ++k) {
    functions.push_back(3 * square(v[0] - centre[k][0]) + square(v[1] - centre[k][1]) - square(v[2] + v[3 + k]));
    functions.push_back(square(v[3 + k]) - 1);
  }
  std::vector<Point> known{{0, 0, 1, 1, 1, 1}, {0, 0, 3, -1, -1, -1}};
  for (int k = 0; k < 3; ++k) {   // around one of the circles, or around the two others
    const Rational x = fraction(centre[k][0], 1), y = fraction(centre[k][1], 1);
    Point far{-x, -y, 3, 1, 1, 1}, close{x * 3 / 5, y * 3 / 5, fraction(9, 5), 1, 1, 1};
    for (int i = 0; i < 3; ++i) {
      far[3 + i] = i == k ? 1 : -1;
      close[3 + i] = i == k ? -1 : 1;
    }
    known.push_back(far);
    known.push_back(close);
  }
  std::vector<System::Domain> domain{{-4, 4}, {-4, 4}, {0, 4}, {-2, 2}, {-2, 2}, {-2, 2}};
  return all_known("Apollonius", with_equalities(System(domain), functions), known);
}

// Problem 12.
inline Problem bitangents()
{
  const auto n = variables(2);
  const double h = std::sqrt(3) / 2;
  return all_known("bitangents",
                   with_equalities(cube(2, -1, 1), {square(n[0]) + square(n[1]) - 1, square(4 * n[0] + 1) - 1}),
                   {{0, 1}, {0, -1}, {fraction(-1, 2), Coordinate::near(h)}, {fraction(-1, 2), Coordinate::near(-h)}});
}

// Problem 13.
inline Problem tritangent_planes()
{
  const auto n = variables(3);
  std::vector<Point> known;
  for (int sign : {-1, 1}) {
    known.push_back({0, 0, sign});
    known.push_back({fraction(-1, 2), 0, Coordinate::near(sign * std::sqrt(0.75))});
    known.push_back({0, fraction(-1, 2), Coordinate::near(sign * std::sqrt(0.75))});
    known.push_back({fraction(-1, 2), fraction(-1, 2), Coordinate::near(sign * std::sqrt(0.5))});
  }
  return all_known("tritangent planes",
                   with_equalities(cube(3, -1, 1),
                                   {square(n[0]) + square(n[1]) + square(n[2]) - 1, square(4 * n[0] + 1) - 1,
                                    square(4 * n[1] + 1) - 1}),
                   known);
}

// Problem 14: unit direction v of a line and its point p next to the origin. Of each pair of directions an inequality
// takes one.
inline Problem lines_tangent_to_spheres()
{
  const auto v = variables(6);
  const int centre[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  System system = cube(6, -1, 1);
  for (const auto& c : centre) {
    Polynomial along, distance;
    for (int j = 0; j < 3; ++j) {
      along += c[j] * v[j];
      distance += square(c[j] - v[3 + j]);
    }
    system.add(distance - square(along) - fraction(1394, 625), Relation::EQUAL);
  }
  system.add(v[0] * v[3] + v[1] * v[4] + v[2] * v[5], Relation::EQUAL);
  system.add(square(v[0]) + square(v[1]) + square(v[2]) - 1, Relation::EQUAL);
  system.add(7 * v[0] + 5 * v[1] + 3 * v[2], Relation::GREATER);
  std::vector<Point> known;
  for (int zero = 0; zero < 3; ++zero)
    for (int first : {3, 4})
      for (int sign : {-1, 1}) {
        Rational d[3] = {0, 0, 0};
        d[zero == 0 ? 1 : 0] = fraction(first, 5);
        d[zero == 2 ? 1 : 2] = fraction(sign * (7 - first), 5);
        const int weight[3] = {7, 5, 3};
        Rational side(0);
        for (int j = 0; j < 3; ++j)
          side += weight[j] * d[j];
        Point point;
        for (const Rational& x : d)
          point.emplace_back(side > Rational(0) ? x : Rational(-x));
        for (int j = 0; j < 3; ++j)
          point.emplace_back(Rational(-d[(j + 1) % 3] * d[(j + 2) % 3]));
        known.push_back(std::move(point));
      }
  return all_known("lines tangent to four spheres", std::move(system), std::move(known));
}

// Problem 15: x_1 = ... = x_{n-1} = t and x_n = n + 1 - n t with n t^n - (n+1) t^{n-1} + 1 = 0; for odd n there are
// three such t, 1 among them.
inline Problem brown(int n, const Rational& half_width)
{
  const auto x = variables(n);
  Polynomial sum, product(1);
  for (const Polynomial& xi : x) {
    sum += xi;
    product *= xi;
  }
  std::vector<Polynomial> functions;
  for (int i = 0; i + 1 < n; ++i)
    functions.push_back(x[i] + sum - (n + 1));
  functions.push_back(product - 1);
  std::vector<Point> known{Point(n, Coordinate(1))};
  for (double t : {0.8, -0.5}) {
    for (int i = 0; i < 100; ++i)   // Newton
      t -= ((n * t - (n + 1)) * std::pow(t, n - 1) + 1) / ((n * n * t - (n * n - 1)) * std::pow(t, n - 2));
    Point point(n, Coordinate::near(t, 1e-13));
    point.back() = Coordinate::near(n + 1 - n * t, 1e-12);
    known.push_back(std::move(point));
  }
  return all_known("Brown " + std::to_string(n), with_equalities(cube(n, -half_width, half_width), functions),
                   std::move(known));
}

// Problem 23.
inline Problem broyden_tridiagonal(int n)
{
  const auto x = variables(n);
  std::vector<Polynomial> functions;
  for (int i = 0; i < n; ++i) {
    Polynomial f = (3 - 2 * x[i]) * x[i] + 1;
    if (i > 0)
      f -= x[i - 1];
    if (i + 1 < n)
      f -= 2 * x[i + 1];
    functions.push_back(std::move(f));
  }
  return {"Broyden tridiagonal " + std::to_string(n), with_equalities(cube(n, -2, 2), functions), 2, {}};
}

// Katsura's equations with three unknowns, solved by hand: u1 = 0, or 7 u0^2 - 6 u0 + 1 = 0 with u1 = u0 / 2, u2 = 1/2
// - u0.
inline Problem katsura_2()
{
  const auto u = variables(3);
  std::vector<Point> known{{1, 0, 0}, {fraction(1, 3), 0, fraction(1, 3)}};
  for (int sign : {-1, 1}) {
    const double u0 = (3 + sign * std::sqrt(2)) / 7;
    known.push_back({Coordinate::near(u0), Coordinate::near(u0 / 2), Coordinate::near(0.5 - u0)});
  }
  return all_known("katsura 2",
                   with_equalities(cube(3, -2, 2), {u[0] + 2 * u[1] + 2 * u[2] - 1,
                                                    square(u[0]) + 2 * square(u[1]) + 2 * square(u[2]) - u[0],
                                                    2 * u[0] * u[1] + 2 * u[1] * u[2] - u[1]}),
                   known);
}

// A spline of one unknown that is the k-th polynomial between breaks k and k + 1. The polynomials may use any one
// unknown.
inline SC::Spline_function piecewise(int variable, const std::vector<Rational>& breaks,
                                     const std::vector<Polynomial>& polynomials)
{
  std::vector<SC::Bernstein_tensor<Rational>> pieces;
  for (std::size_t k = 0; k < polynomials.size(); ++k) {
    const SC::Spline_term term = SC::Spline_function(polynomials[k]).terms().front();
    std::vector<std::pair<Rational, Rational>> box;
    if (!term.degrees.empty())
      box.emplace_back(breaks[k], breaks[k + 1]);
    const auto piece = SC::Bernstein_tensor<Rational>::from_power_on_box(term.degrees, term.pieces[0], box);
    pieces.push_back(term.degrees.empty() ? SC::Bernstein_tensor<Rational>::constant(1, term.pieces[0][0]) : piece);
  }
  return SC::Spline_function::from_bezier_pieces({variable}, {breaks}, pieces);
}

// A polynomial in one unknown in Bezier pieces: a spline that is as smooth as can be.
inline SC::Spline_function in_pieces(const Polynomial& p, int variable, const std::vector<Rational>& breaks)
{
  return piecewise(variable, breaks, std::vector<Polynomial>(breaks.size() - 1, p));
}

// Problem 1 for two unknowns with every equation cut at breaks, zero and 1/2 among them.
inline Problem cyclic_chebyshev_in_pieces(int degree)
{
  Problem result = cyclic_chebyshev(2, degree);
  result.name += " in pieces";
  const auto x = variables(2);
  const std::vector<Rational> breaks{-1, fraction(-1, 2), 0, fraction(1, 2), fraction(3, 4), 1};
  System system = cube(2, -1, 1);
  for (int i = 0; i < 2; ++i)
    system.add(in_pieces(chebyshev(degree, x[i]), i, breaks) - SC::Spline_function(x[1 - i]), Relation::EQUAL);
  result.system = std::move(system);
  return result;
}

// A polygon with the vertices (k, heights[k]) as a function of one unknown.
inline SC::Spline_function polygon(int variable, const std::vector<Rational>& heights)
{
  std::vector<Rational> breaks;
  std::vector<SC::Bernstein_tensor<Rational>> pieces;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    breaks.push_back(fraction(static_cast<int>(k), 1));
    if (k > 0)
      pieces.emplace_back(std::vector<int>{1}, std::vector<Rational>{heights[k - 1], heights[k]});
  }
  return SC::Spline_function::from_bezier_pieces({variable}, {breaks}, pieces);
}

// y = a zigzag of x and x = 2 y: a crossing in the kink at (2,1) and three between kinks.
inline Problem zigzag()
{
  const auto x = variables(2);
  System system(std::vector<System::Domain>{{0, 6}, {-1, 5}});
  system.add(polygon(0, {1, -1, 1, 4, 3, 1, 4}) - SC::Spline_function(x[1]), Relation::EQUAL);
  system.add(x[0] - 2 * x[1], Relation::EQUAL);
  // 1 - 2x = x/2 on [0,1], 11 - 2x = x/2 on [4,5], -14 + 3x = x/2 on [5,6]
  return all_known("zigzag", std::move(system),
                   {{fraction(2, 5), fraction(1, 5)},
                    {2, 1},
                    {fraction(22, 5), fraction(11, 5)},
                    {fraction(28, 5), fraction(14, 5)}});
}

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_SOLVER_TEST_SYSTEMS_H
