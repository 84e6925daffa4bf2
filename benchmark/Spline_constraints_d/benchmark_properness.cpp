// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Factors of polynomials, decompositions of rational functions, tracing indices of curves, and equations in one unknown
// beside their decompositions. The arguments are degrees; each run takes the next of 20 random inputs.

#include <CGAL/Spline_constraints_d/function/rational_decomposition.h>
#include <CGAL/Spline_constraints_d/function/rational_factors.h>
#include <CGAL/Spline_constraints_d/geometry/curves/proper_curves.h>
#include <CGAL/Spline_constraints_d/solver.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Polynomial = SC::Power_polynomial;
using Function = SC::Polynomial_quotient;
using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;

namespace {

const Polynomial x = Polynomial::variable(0);

Polynomial random_polynomial(int degree, std::mt19937& random)
{
  Polynomial result = Polynomial(1 + static_cast<int>(random() % 4)) * pow(x, degree);
  for (int k = 0; k < degree; ++k)
    result += Polynomial(static_cast<int>(random() % 19) - 9) * pow(x, k);
  return result;
}

// Calls an operation with inputs that are made before.
template <class Make, class Operation>
void run(benchmark::State& state, const Make& make, const Operation& operation)
{
  std::mt19937 random(3);
  std::vector<decltype(make(random))> inputs;
  for (int k = 0; k < 20; ++k)
    inputs.push_back(make(random));
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(operation(inputs[next++ % inputs.size()]));
}

void factors_of_product(benchmark::State& state)
{
  const int degree = static_cast<int>(state.range(0));
  run(
      state, [&](auto& random) { return random_polynomial(degree, random) * random_polynomial(degree, random); },
      [](const Polynomial& f) { return SC::rational_factors(f); });
}

void decompositions_of_rational_function(benchmark::State& state)
{
  const auto function = [](int degree, auto& random) {
    const Polynomial numerator = random_polynomial(degree, random);
    return Function(numerator, random_polynomial(degree, random));
  };
  const int r = static_cast<int>(state.range(0)), s = static_cast<int>(state.range(1));
  run(
      state,
      [&](auto& random) { return s == 1 ? function(r, random) : composed(function(r, random), function(s, random)); },
      [](const Function& f) { return SC::decompositions(f); });
}

void decompositions_of_polynomial(benchmark::State& state)
{
  const int r = static_cast<int>(state.range(0)), s = static_cast<int>(state.range(1));
  run(
      state,
      [&](auto& random) { return Function(random_polynomial(r, random).substituted(0, random_polynomial(s, random))); },
      [](const Function& f) { return SC::decompositions(f); });
}

// A rational curve of the degree r after a polynomial of the degree s.
SC::Bspline_curve<Exact, 2> random_curve(int r, int s, std::mt19937& random)
{
  const Polynomial h = random_polynomial(s, random);
  const auto function = [&](const Polynomial& f) {
    std::vector<SC::Exact_rational> powers(static_cast<std::size_t>(r * s) + 1, SC::Exact_rational(0)), knots;
    for (const auto& [monomial, coefficient] : f.substituted(0, h).terms())
      powers[static_cast<std::size_t>(monomial.exponent(0))] = coefficient;
    const std::array<std::pair<SC::Exact_rational, SC::Exact_rational>, 1> box{{{-1, 1}}};
    knots.assign(powers.size(), SC::Exact_rational(-1));
    knots.insert(knots.end(), powers.size(), SC::Exact_rational(1));
    return SC::Bspline_function<SC::Exact_rational>(
        {r * s}, {knots},
        SC::Bernstein_tensor<SC::Exact_rational>::from_power_on_box({r * s}, powers, box).coefficients());
  };
  const Polynomial first = random_polynomial(r, random), second = random_polynomial(r, random);
  return SC::Bspline_curve<Exact, 2>::from_homogeneous_coordinates({function(first), function(second)},
                                                                   function(1 + x * x));
}

void tracing_index_of_curve(benchmark::State& state)
{
  run(
      state,
      [&](auto& random) {
        return random_curve(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), random);
      },
      [](const auto& curve) { return SC::tracing_index(curve); });
}

void proper_reparametrization_of_curve(benchmark::State& state)
{
  run(
      state,
      [&](auto& random) {
        return random_curve(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), random);
      },
      [](const auto& curve) { return SC::proper_reparametrization(curve); });
}

// g(T_s) for a product g of r linear factors, whose zeros are all in [-1,1].
Polynomial composed_equation(int r, int s, std::mt19937& random)
{
  Polynomial chebyshev = x, previous(1), g(1);
  for (int k = 1; k < s; ++k)
    previous = std::exchange(chebyshev, 2 * x * chebyshev - previous);
  for (int k = 0; k < r; ++k)
    g *= 1000 * x - Polynomial(static_cast<int>(random() % 1900) - 950);
  return g.substituted(0, chebyshev);
}

void solve_composed_equation(benchmark::State& state)
{
  run(
      state,
      [&](auto& random) {
        return composed_equation(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), random);
      },
      [](const Polynomial& f) {
        SC::Constraint_system_d system({{SC::Exact_rational(-1), SC::Exact_rational(1)}});
        system.add(SC::Spline_function(f), SC::Relation::EQUAL);
        return SC::solve(system).size();
      });
}

void decompose_composed_equation(benchmark::State& state)
{
  run(
      state,
      [&](auto& random) {
        return Function(composed_equation(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), random));
      },
      [](const Function& f) { return SC::decompositions(f); });
}

void composed_degrees(benchmark::internal::Benchmark* benchmark)
{
  for (const auto& degrees : {std::pair(2, 2), {3, 3}, {4, 4}, {6, 6}, {10, 10}})
    benchmark->Args({degrees.first, degrees.second});
}

BENCHMARK(factors_of_product)->Arg(6)->Arg(10)->Arg(20)->Arg(40);
BENCHMARK(decompositions_of_rational_function)->Args({2, 2})->Args({4, 4})->Args({6, 6})->Args({12, 1})->Args({36, 1});
BENCHMARK(decompositions_of_polynomial)->Args({3, 3})->Args({6, 6})->Args({10, 10});
BENCHMARK(tracing_index_of_curve)->Args({3, 1})->Args({9, 1})->Args({3, 3})->Args({6, 3})->Args({6, 6});
BENCHMARK(proper_reparametrization_of_curve)->Args({3, 3})->Args({6, 3})->Args({6, 6});
BENCHMARK(solve_composed_equation)->Apply(composed_degrees);
BENCHMARK(decompose_composed_equation)->Apply(composed_degrees);

} // namespace
