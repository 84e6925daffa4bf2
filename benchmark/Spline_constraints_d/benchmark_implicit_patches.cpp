// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A polynomial of degree k in Bernstein form on a tetrahedron, beside that on a box around it, with k as the degree of
// each axis; and convexity of random patches.

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/patch_convexity.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using Simplex_function = SC::Simplex_function_3;

// Of a numerator with 20 bits and a small denominator.
template <class NT>
std::vector<NT> random_numbers(std::size_t count, unsigned seed = 1)
{
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> numerator(-(1 << 20), 1 << 20), denominator(1, 8);
  std::vector<NT> result;
  while (result.size() < count) {
    const NT top(numerator(engine));
    result.push_back(NT(top / NT(denominator(engine))));
  }
  return result;
}

template <class NT>
SC::Bernstein_simplex<NT, 3> on_tetrahedron(int degree)
{
  return {degree, random_numbers<NT>(SC::Bernstein_simplex<NT, 3>::number_of_coefficients(degree))};
}

template <class NT>
SC::Bernstein_tensor<NT> on_box(int degree)
{
  const auto size = static_cast<std::size_t>(degree + 1);
  return {{degree, degree, degree}, random_numbers<NT>(size * size * size)};
}

template <class NT>
void value_on_tetrahedron(benchmark::State& state)
{
  const auto f = on_tetrahedron<NT>(static_cast<int>(state.range(0)));
  const std::array<NT, 4> tau{NT(0.25), NT(0.125), NT(0.5), NT(0.125)};
  for (auto _ : state)
    benchmark::DoNotOptimize(f(tau));
}

template <class NT>
void value_on_box(benchmark::State& state)
{
  const auto f = on_box<NT>(static_cast<int>(state.range(0)));
  const std::array<NT, 3> u{NT(0.25), NT(0.125), NT(0.5)};
  for (auto _ : state)
    benchmark::DoNotOptimize(f(u));
}

template <class NT>
void halves_of_tetrahedron(benchmark::State& state)
{
  const auto f = on_tetrahedron<NT>(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(f.split(0, 1));
}

template <class NT>
void halves_of_box(benchmark::State& state)
{
  const auto f = on_box<NT>(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(f.split(0));
}

template <class NT>
void square_on_tetrahedron(benchmark::State& state)
{
  const auto f = on_tetrahedron<NT>(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(f * f);
}

template <class NT>
void square_on_box(benchmark::State& state)
{
  const auto f = on_box<NT>(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(f * f);
}

// A different patch each time: a plane with other coefficients added.
void convexity(benchmark::State& state, Exact_rational factor)
{
  const int degree = static_cast<int>(state.range(0));
  const auto plane = SC::Bernstein_simplex<Exact_rational, 3>::affine(
      {Exact_rational(1), Exact_rational(-1), Exact_rational(-1), Exact_rational(-1)});
  const CGAL::Tetrahedron_3<Simplex_function::Kernel> tetrahedron({0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  unsigned seed = 0;
  std::size_t decided = 0, nodes = 0;
  for (auto _ : state) {
    SC::Bernstein_simplex<Exact_rational, 3> f(
        degree,
        random_numbers<Exact_rational>(SC::Bernstein_simplex<Exact_rational, 3>::number_of_coefficients(degree),
                                       ++seed));
    f = plane + f * factor;
    const auto shape = SC::patch_convexity(Simplex_function(tetrahedron, f));
    decided += shape.is_complete();
    nodes += shape.summary().nodes;
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["decided"] = static_cast<double>(decided) / runs;
  state.counters["nodes"] = static_cast<double>(nodes) / runs;
}

BENCHMARK(value_on_tetrahedron<double>)->Arg(3)->Arg(6);
BENCHMARK(value_on_box<double>)->Arg(3)->Arg(6);
BENCHMARK(value_on_tetrahedron<Exact_rational>)->Arg(3)->Arg(6);
BENCHMARK(value_on_box<Exact_rational>)->Arg(3)->Arg(6);
BENCHMARK(halves_of_tetrahedron<double>)->Arg(3)->Arg(6);
BENCHMARK(halves_of_box<double>)->Arg(3)->Arg(6);
BENCHMARK(halves_of_tetrahedron<Exact_rational>)->Arg(3)->Arg(6);
BENCHMARK(halves_of_box<Exact_rational>)->Arg(3)->Arg(6);
BENCHMARK(square_on_tetrahedron<double>)->Arg(3)->Arg(6);
BENCHMARK(square_on_box<double>)->Arg(3)->Arg(6);
BENCHMARK(square_on_tetrahedron<Exact_rational>)->Arg(3)->Arg(6);
BENCHMARK(square_on_box<Exact_rational>)->Arg(3)->Arg(6);
BENCHMARK_CAPTURE(convexity, flat, Exact_rational(0x1p-23))
    ->Arg(2)
    ->Arg(3)
    ->Arg(4)
    ->Arg(6)
    ->Arg(8)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(convexity, wild, Exact_rational(0x1p-20))
    ->Arg(2)
    ->Arg(3)
    ->Arg(4)
    ->Arg(6)
    ->Arg(8)
    ->Unit(benchmark::kMillisecond);

} // namespace
