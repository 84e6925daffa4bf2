// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Products of Bernstein tensors: the kernel against the loop over index vectors that anyone would write first.

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using CGAL::Spline_constraints::Bernstein_tensor;
using CGAL::Spline_constraints::Exact_rational;

template <class NT>
NT random_number(std::mt19937_64& engine, int bits);

template <>
double random_number<double>(std::mt19937_64& engine, int)
{
  return std::uniform_real_distribution<double>(-1, 1)(engine);
}

// A fraction with numerators of so many bits over a small denominator, as exact input has; or, for 53 bits, a double.
template <>
Exact_rational random_number<Exact_rational>(std::mt19937_64& engine, int bits)
{
  if (bits == 53)
    return Exact_rational(random_number<double>(engine, bits));
  const double numerator = static_cast<double>(std::uniform_int_distribution<long>(-(1L << bits), 1L << bits)(engine));
  return Exact_rational(numerator) / Exact_rational(std::uniform_int_distribution<int>(1, 8)(engine));
}

template <class NT>
Bernstein_tensor<NT> random_tensor(std::mt19937_64& engine, const std::vector<int>& degrees, int bits)
{
  std::size_t size = 1;
  for (int d : degrees)
    size *= d + 1;
  std::vector<NT> coefficients;
  for (std::size_t i = 0; i < size; ++i)
    coefficients.push_back(random_number<NT>(engine, bits));
  return Bernstein_tensor<NT>(degrees, coefficients);
}

template <class NT>
std::vector<std::vector<NT>> pascal_triangle(int rows)
{
  std::vector<std::vector<NT>> triangle{{NT(1)}};
  while (static_cast<int>(triangle.size()) <= rows) {
    std::vector<NT> row = triangle.back();
    row.push_back(NT(0));
    for (std::size_t k = row.size() - 1; k >= 1; --k)
      row[k] += row[k - 1];
    triangle.push_back(row);
  }
  return triangle;
}

std::vector<int> index_vector(std::size_t position, const std::vector<int>& degrees)
{
  std::vector<int> index(degrees.size());
  for (std::size_t j = degrees.size(); j-- > 0;) {
    index[j] = static_cast<int>(position % (degrees[j] + 1));
    position /= degrees[j] + 1;
  }
  return index;
}

template <class NT>
Bernstein_tensor<NT> naive_product(const Bernstein_tensor<NT>& f, const Bernstein_tensor<NT>& g)
{
  std::vector<int> degrees = f.degrees();
  std::size_t size = 1;
  for (std::size_t j = 0; j < degrees.size(); ++j)
    size *= (degrees[j] += g.degrees()[j]) + 1;
  const auto binomial = pascal_triangle<NT>(*std::max_element(degrees.begin(), degrees.end()));
  std::vector<NT> result(size, NT(0));
  for (std::size_t a = 0; a < f.coefficients().size(); ++a) {
    const std::vector<int> i = index_vector(a, f.degrees());
    for (std::size_t b = 0; b < g.coefficients().size(); ++b) {
      const std::vector<int> k = index_vector(b, g.degrees());
      NT factor(1);
      std::size_t position = 0;
      for (std::size_t j = 0; j < degrees.size(); ++j) {
        factor = factor * binomial[f.degrees()[j]][i[j]] * binomial[g.degrees()[j]][k[j]] /
            binomial[degrees[j]][i[j] + k[j]];
        position = position * (degrees[j] + 1) + i[j] + k[j];
      }
      result[position] += factor * f.coefficients()[a] * g.coefficients()[b];
    }
  }
  return Bernstein_tensor<NT>(degrees, result);
}

// The two tensors of the Apollonius constraints after elimination: 13 x 5 x 5 by 9 x 9 x 5 coefficients.
template <class NT, bool is_naive>
void product(benchmark::State& state)
{
  std::mt19937_64 engine(1);
  const int bits = static_cast<int>(state.range(0));
  const auto f = random_tensor<NT>(engine, {12, 4, 4}, bits), g = random_tensor<NT>(engine, {8, 8, 4}, bits);
  for (auto _ : state)
    benchmark::DoNotOptimize(is_naive ? naive_product(f, g) : f * g);
}

// Small ones: two quadratic polynomials in two variables.
template <class NT>
void small_product(benchmark::State& state)
{
  std::mt19937_64 engine(1);
  const auto f = random_tensor<NT>(engine, {2, 2}, static_cast<int>(state.range(0))),
             g = random_tensor<NT>(engine, {2, 2}, static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(f * g);
}

// Functions of different variables.
template <class NT>
void separable_product(benchmark::State& state)
{
  std::mt19937_64 engine(1);
  const int bits = static_cast<int>(state.range(0));
  const auto f = random_tensor<NT>(engine, {12, 0, 4}, bits), g = random_tensor<NT>(engine, {0, 8, 0}, bits);
  for (auto _ : state)
    benchmark::DoNotOptimize(f * g);
}

template <class NT>
void evaluation(benchmark::State& state)
{
  std::mt19937_64 engine(1);
  const auto f = random_tensor<NT>(engine, {12, 4, 4}, static_cast<int>(state.range(0)));
  const std::vector<NT> u{NT(0.25), NT(0.5), NT(0.625)};
  for (auto _ : state)
    benchmark::DoNotOptimize(f.value_and_gradient(u));
}

BENCHMARK(product<double, false>)->Arg(53)->Unit(benchmark::kMicrosecond);
BENCHMARK(product<double, true>)->Arg(53)->Unit(benchmark::kMicrosecond);
BENCHMARK(product<Exact_rational, false>)->Arg(8)->Arg(30)->Arg(53)->Unit(benchmark::kMicrosecond);
BENCHMARK(product<Exact_rational, true>)->Arg(8)->Arg(30)->Arg(53)->Unit(benchmark::kMicrosecond);
BENCHMARK(small_product<double>)->Arg(53);
BENCHMARK(small_product<Exact_rational>)->Arg(8)->Arg(53);
BENCHMARK(separable_product<double>)->Arg(53);
BENCHMARK(separable_product<Exact_rational>)->Arg(8)->Arg(53);
BENCHMARK(evaluation<double>)->Arg(53);
BENCHMARK(evaluation<Exact_rational>)->Arg(8)->Arg(53);

} // namespace
