// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether inequalities can be satisfied, against the number of unknowns. The argument is that number; the time is of
// ten random problems, and the counters are of one.

#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Polynomial = SC::Power_polynomial;
using Conditions = std::vector<std::pair<Polynomial, SC::Relation>>;

namespace {

class Problems
{
  std::mt19937 m_random{7};
  int m_dimension;

public:
  explicit Problems(int dimension) : m_dimension(dimension) {}

  int dimension() const { return m_dimension; }
  double normal() { return std::normal_distribution<>()(m_random); }
  static Polynomial rounded(double x) { return Polynomial(std::round(1024 * x) / 1024); }
  static Polynomial variable(int j) { return Polynomial::variable(j); }

  // Around n + 1 points; `size`: compared with the least radius for which they meet, about.
  Conditions balls(double size)
  {
    Conditions result;
    const int n = m_dimension;
    std::vector<std::vector<double>> centres;
    for (int k = 0; k <= n; ++k) {
      std::vector<double>& centre = centres.emplace_back();
      double length = 0;
      for (int j = 0; j < n; ++j) {
        centre.push_back(normal());
        length += centre.back() * centre.back();
      }
      for (double& x : centre)
        x /= std::sqrt(length);
    }
    for (const std::vector<double>& centre : centres) {
      Polynomial ball = -rounded(size * size);
      for (int j = 0; j < n; ++j)
        ball += (variable(j) - rounded(centre[j])) * (variable(j) - rounded(centre[j]));
      result.emplace_back(std::move(ball), SC::Relation::LESS_EQUAL);
    }
    return result;
  }

  // [-1,1]^n, and a box in a random position whose centre is at a distance in a random direction.
  Conditions boxes(double distance)
  {
    const int n = m_dimension;
    std::vector<std::vector<double>> axes; // by Gram and Schmidt
    for (int k = 0; k < n; ++k) {
      std::vector<double> axis(n);
      for (double& x : axis)
        x = normal();
      for (const std::vector<double>& other : axes) {
        double product = 0;
        for (int j = 0; j < n; ++j)
          product += axis[j] * other[j];
        for (int j = 0; j < n; ++j)
          axis[j] -= product * other[j];
      }
      double length = 0;
      for (const double x : axis)
        length += x * x;
      for (double& x : axis)
        x /= std::sqrt(length);
      axes.push_back(std::move(axis));
    }
    Conditions result;
    for (int k = 0; k < n; ++k) {
      Polynomial turned = k == 0 ? -rounded(distance) : Polynomial();
      for (int j = 0; j < n; ++j)
        turned += rounded(axes[k][j]) * variable(j);
      for (const Polynomial& coordinate : {variable(k), turned}) {
        result.emplace_back(coordinate - 1, SC::Relation::LESS_EQUAL);
        result.emplace_back(coordinate + 1, SC::Relation::GREATER_EQUAL);
      }
    }
    return result;
  }

  // x A x + b x + level <= 0 with random numbers; with A = B B^T if they are to be convex.
  Conditions quadrics(int number, bool is_convex, double level)
  {
    const int n = m_dimension;
    Conditions result;
    for (int k = 0; k < number; ++k) {
      std::vector<double> b(n * n);
      for (double& x : b)
        x = normal() / std::sqrt(n);
      Polynomial quadric = rounded(level);
      for (int i = 0; i < n; ++i) {
        quadric += rounded(normal()) * variable(i);
        for (int j = 0; j < n; ++j) {
          double entry = is_convex ? 0 : 0.5 * (b[i * n + j] + b[j * n + i]);
          for (int l = 0; l < n && is_convex; ++l)
            entry += b[i * n + l] * b[j * n + l];
          quadric += rounded(entry) * variable(i) * variable(j);
        }
      }
      result.emplace_back(std::move(quadric), SC::Relation::LESS_EQUAL);
    }
    return result;
  }

  // Corners of a cube, x_j^2 >= 1, near the plane where their sum is zero: none if n is odd.
  Conditions corners()
  {
    Conditions result;
    Polynomial sum;
    for (int j = 0; j < m_dimension; ++j) {
      result.emplace_back(variable(j) * variable(j) - 1, SC::Relation::GREATER_EQUAL);
      sum += variable(j);
    }
    result.emplace_back(2 * sum - 1, SC::Relation::LESS_EQUAL);
    result.emplace_back(2 * sum + 1, SC::Relation::GREATER_EQUAL);
    return result;
  }
};

template <class Make>
void solve_ten(benchmark::State& state, double reach, const Make& make)
{
  const int n = static_cast<int>(state.range(0));
  Problems problems(n);
  std::vector<Conditions> all;
  for (int k = 0; k < 10; ++k)
    all.push_back(make(problems));
  const std::vector<SC::Constraint_system_d::Domain> domain(n, {SC::Exact_rational(-reach), SC::Exact_rational(reach)});
  double nodes = 0, feasible = 0, undecided = 0;
  for (auto _ : state)
    for (const Conditions& conditions : all) {
      const SC::Feasibility_d answer =
          SC::Feasibility_solver_d({.tolerance = 1e-6, .time_limit = 60})(domain, conditions);
      nodes += static_cast<double>(answer.summary().nodes);
      feasible += answer.is_feasible();
      undecided += !answer.is_complete();
    }
  const double runs = 10. * static_cast<double>(state.iterations());
  state.counters["nodes"] = nodes / runs;
  state.counters["feasible"] = feasible / runs;
  state.counters["undecided"] = undecided / runs;
}

void balls_that_meet(benchmark::State& state)
{
  solve_ten(state, 2, [](Problems& problems) { return problems.balls(1.05); });
}
void balls_that_do_not(benchmark::State& state)
{
  solve_ten(state, 2, [](Problems& problems) { return problems.balls(0.6); });
}
void boxes_that_meet(benchmark::State& state)
{
  solve_ten(state, 8, [](Problems& problems) { return problems.boxes(1.5); });
}
void boxes_that_do_not(benchmark::State& state)
{
  solve_ten(state, 8, [](Problems& problems) { return problems.boxes(4); });
}
void convex_quadrics(benchmark::State& state)
{
  solve_ten(state, 2, [](Problems& problems) { return problems.quadrics(problems.dimension() + 1, true, 0.05); });
}
void random_quadrics(benchmark::State& state)
{
  solve_ten(state, 1, [](Problems& problems) { return problems.quadrics(problems.dimension(), false, 0.5); });
}
void twice_as_many_quadrics(benchmark::State& state)
{
  solve_ten(state, 1, [](Problems& problems) { return problems.quadrics(2 * problems.dimension(), false, 0.5); });
}
void corners_of_a_cube(benchmark::State& state)
{
  solve_ten(state, 1, [](Problems& problems) { return problems.corners(); });
}

#define FROM_TWO_TO_TWELVE ->Arg(2)->Arg(4)->Arg(6)->Arg(8)->Arg(10)->Arg(12)->Unit(benchmark::kMillisecond)
BENCHMARK(balls_that_meet) FROM_TWO_TO_TWELVE;
BENCHMARK(balls_that_do_not) FROM_TWO_TO_TWELVE;
BENCHMARK(boxes_that_meet) FROM_TWO_TO_TWELVE;
BENCHMARK(boxes_that_do_not) FROM_TWO_TO_TWELVE;
BENCHMARK(convex_quadrics) FROM_TWO_TO_TWELVE;
BENCHMARK(random_quadrics) FROM_TWO_TO_TWELVE;
BENCHMARK(twice_as_many_quadrics)->Arg(2)->Arg(4)->Arg(5)->Arg(6)->Unit(benchmark::kMillisecond);
BENCHMARK(corners_of_a_cube)->Arg(3)->Arg(5)->Arg(7)->Arg(9)->Arg(11)->Unit(benchmark::kMillisecond);

} // namespace
