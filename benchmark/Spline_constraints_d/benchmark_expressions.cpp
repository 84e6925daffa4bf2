// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time to write the constraints of Apollonius (seed 000, equations 12 to 16) for three curves, to expand them into
// dense tensors, exactly, and to solve them; and the same for ray-traps.
#include <CGAL/Spline_constraints_d/function/Rational_function.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/linear_elimination.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using Spline = SC::Bspline_function<Rational>;

struct Operand
{
  std::array<Spline, 2> coordinates;
  Spline weight;
  bool is_rational;

  SC::Spline_map<1, 2> map() const
  {
    return is_rational ? SC::Spline_map<1, 2>(coordinates, weight) : SC::Spline_map<1, 2>(coordinates);
  }
};

using Operands = std::array<Operand, 3>;

Spline spline(int degree, const std::vector<int>& knots, const std::vector<int>& coefficients)
{
  return Spline({degree}, {std::vector<Rational>(knots.begin(), knots.end())},
                std::vector<Rational>(coefficients.begin(), coefficients.end()));
}

// A circle in four rational quadratic pieces, the middle two of which are one polynomial.
Operand circle(int x, int y, int radius)
{
  const std::vector<int> knots{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  const Spline weight = spline(2, knots, {1, 1, 2, 1, 1, 1, 2, 1, 1});
  const Spline cosine = spline(2, knots, {1, 1, 0, -1, -1, -1, 0, 1, 1}),
               sine = spline(2, knots, {0, 1, 2, 1, 0, -1, -2, -1, 0});
  return {
      {cosine * Rational(radius) + weight * Rational(x), sine * Rational(radius) + weight * Rational(y)}, weight, true};
}

// A smooth B-spline with four pieces and small integer control points around a center.
Operand random_curve(std::mt19937& random, int degree, bool is_rational, int x, int y)
{
  std::vector<int> knots(degree + 1, 0), xs, ys, ws;
  knots.insert(knots.end(), {1, 2, 3});
  knots.insert(knots.end(), degree + 1, 4);
  for (int i = 0; i < degree + 4; ++i) {
    ws.push_back(is_rational ? 1 + static_cast<int>(random() % 3) : 1);
    xs.push_back((x + static_cast<int>(random() % 7) - 3) * ws.back());
    ys.push_back((y + static_cast<int>(random() % 7) - 3) * ws.back());
  }
  return {{spline(degree, knots, xs), spline(degree, knots, ys)}, spline(degree, knots, ws), is_rational};
}

Operands circles() { return {circle(0, 0, 1), circle(5, 0, 2), circle(1, 6, 1)}; }

Operands random_curves(int degree, bool is_rational)
{
  std::mt19937 random(1);
  return {random_curve(random, degree, is_rational, 0, 0), random_curve(random, degree, is_rational, 20, 0),
          random_curve(random, degree, is_rational, 0, 20)};
}

std::vector<SC::Constraint> constraints(const Operands& operands)
{
  const SC::Spline_map<1, 2> c1 = operands[0].map(), c2 = operands[1].map(), c3 = operands[2].map();
  auto [u, v, w] = SC::parameters(c1, c2, c3);
  const auto a = c1(u), b = c2(v), c = c3(w);
  const auto p = meet(equidistant_hyperplane(a, b), equidistant_hyperplane(a, c));
  return {dot(p - a, derivative(c1)(u)) == 0, dot(p - b, derivative(c2)(v)) == 0, dot(p - c, derivative(c3)(w)) == 0};
}

void write_and_expand(benchmark::State& state, const Operands& operands)
{
  std::size_t coefficients = 0;
  for (auto _ : state) {
    coefficients = 0;
    for (const SC::Constraint& constraint : constraints(operands)) {
      const SC::Spline_function function = constraint.spline_function();
      for (const SC::Spline_term& term : function.terms())
        coefficients += term.pieces.size() * term.piece_size();
    }
  }
  state.counters["coefficients"] = static_cast<double>(coefficients);
}

void write_only(benchmark::State& state, const Operands& operands)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(constraints(operands));
}

// Seed 000, equation 6, squared.
std::vector<SC::Constraint> ray_trap_constraints(const Operands& operands)
{
  const std::array<SC::Spline_map<1, 2>, 3> c{operands[0].map(), operands[1].map(), operands[2].map()};
  const auto t = SC::parameters(c[0], c[1], c[2]);
  std::vector<SC::Constraint> result;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3, after = (i + 1) % 3;
    const auto n = normal(c[i], t[i]), in = c[before](t[before]) - c[i](t[i]), out = c[after](t[after]) - c[i](t[i]);
    result.push_back(square(dot(in, n)) * squared_norm(out) == square(dot(out, n)) * squared_norm(in));
    result.push_back(dot(in, n) * dot(out, n) > 0);
  }
  return result;
}

void solve_only(benchmark::State& state, const std::vector<SC::Constraint>& constraints)
{
  const SC::Constraint_system_d system = SC::make_system(constraints);
  std::size_t solutions = 0;
  for (auto _ : state)
    solutions = SC::solve(system).size();
  state.counters["solutions"] = static_cast<double>(solutions);
}

// The constraints of Apollonius with rational functions of three parameters, which are multiplied out in every step.
void multiply_out_at_once(benchmark::State& state, const Operands& operands)
{
  using Function = SC::Rational_function<Spline>;
  const std::vector<std::pair<Rational, Rational>> domain(3, {Rational(0), Rational(4)});
  for (auto _ : state) {
    std::vector<std::vector<Function>> points(3), tangents(3);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 2; ++k) {
        points[i].emplace_back(operands[i].coordinates[k].embedded(domain, {i}),
                               operands[i].weight.embedded(domain, {i}));
        tangents[i].push_back(points[i][k].derivative(i));
      }
    const auto square = [](const std::vector<Function>& a) { return a[0] * a[0] + a[1] * a[1]; };
    std::vector<std::vector<Function>> rows{points[1], points[2]};
    std::vector<Function> right;
    for (int r = 0; r < 2; ++r) {
      for (int k = 0; k < 2; ++k)
        rows[r][k] = rows[r][k] - points[0][k];
      right.push_back(square(points[r + 1]) - square(points[0]));
    }
    const Function d = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    const std::vector<Function> p{(right[0] * rows[1][1] - right[1] * rows[0][1]) / d,
                                  (rows[0][0] * right[1] - rows[1][0] * right[0]) / d};
    for (int i = 0; i < 3; ++i)
      benchmark::DoNotOptimize((p[0] - points[i][0]) * tangents[i][0] + (p[1] - points[i][1]) * tangents[i][1]);
  }
}

BENCHMARK_CAPTURE(write_and_expand, circles, circles())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_and_expand, quadratics, random_curves(2, false))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_and_expand, cubics, random_curves(3, false))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_and_expand, rational_quadratics, random_curves(2, true))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_and_expand, rational_cubics, random_curves(3, true))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_only, circles, circles())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_only, rational_cubics, random_curves(3, true))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_only, circles, constraints(circles()))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_only, ray_traps_of_circles, ray_trap_constraints(circles()))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(multiply_out_at_once, quadratics, random_curves(2, false))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

} // namespace
