// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEARLY_DOUBLE_ROOT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEARLY_DOUBLE_ROOT_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/rational_coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Guesses whether a narrow box holds a double root that no precision of some bits tells from two simple ones or from none: Newton's iteration for the point where n - 1 combinations of the
equalities and the derivative of the last one along their kernel are zero, and the value of the last one there.

Nothing depends on the guess but how long a box is subdivided that stays undecided in the end.
*/
class Nearly_double_root
{
  using Number = Mpfr_interval;   // as a number: its middle is what counts

  std::vector<Power_polynomial> m_equalities;
  std::size_t m_dimension;
  std::vector<Number> m_rows;      // gradient, unit vector and value of each equality
  std::vector<Number> m_hessians;  // of each equality
  std::vector<int> m_row;          // per unknown; -1: the free one

public:
  Nearly_double_root(const Constraint_system_d& system, const std::vector<Exact_rational>& point) : m_dimension(point.size())
  {
    for (const Spline_function& function : system.equalities())
      m_equalities.push_back(polynomial_at(function, point));
  }

  // The box is given by its middle and its width; the value is compared with 2^-bits times the curvature.
  bool operator()(std::vector<Exact_rational> point, double width, int bits)
  {
    constexpr int most_steps = 16;
    if (m_equalities.size() != m_dimension)
      return false;
    for (int step = 0, precision = 128; step < most_steps; ++step) {
      const Mpfr_precision_scope scope(precision);
      evaluate(point);
      m_row = gauss_jordan(m_rows, row_length(), m_dimension, m_dimension - 1, [](const Number& x) { return size(x); });
      if (m_row.empty())
        return false;
      const auto [move, value] = newton_step();
      double longest = 0;
      for (std::size_t j = 0; j < m_dimension; ++j) {
        longest = (std::max)(longest, std::abs(CGAL::to_double(move[j])));
        point[j] = round_to_dyadic(Exact_rational(point[j] + move[j]), precision);
      }
      if (!(longest <= 4 * width))
        return false;
      if (longest < std::ldexp(1.0, -precision / 2)) {
        if (precision > 2 * bits)
          return value < std::ldexp(1.0, -bits);
        precision = (std::min)(2 * precision, 2 * bits + 64);
      }
    }
    return false;
  }

private:
  std::size_t row_length() const { return 1 + 2 * m_dimension; }

  // Values and derivatives of first and second order.
  void evaluate(const std::vector<Exact_rational>& point)
  {
    const std::size_t n = m_dimension;
    m_rows.assign(n * row_length(), Number(0));
    m_hessians.assign(n * n * n, Number(0));
    std::vector<std::vector<Number>> powers(n);
    for (std::size_t j = 0; j < n; ++j) {
      int degree = 0;
      for (const Power_polynomial& f : m_equalities)
        degree = (std::max)(degree, f.degree(static_cast<int>(j)));
      powers[j].push_back(Number(1));
      for (int e = 1; e <= degree; ++e)
        powers[j].push_back(powers[j].back() * Number(point[j]));
    }
    std::vector<int> exponents(n);
    // The monomial differentiated by some unknowns.
    const auto derivative = [&](Number value, std::initializer_list<std::size_t> axes) {
      std::vector<int> left = exponents;
      for (std::size_t j : axes)
        value *= Number(left[j]--);
      for (std::size_t j = 0; j < n; ++j)
        if (left[j] > 0)
          value *= powers[j][left[j]];
      return value;
    };
    for (std::size_t i = 0; i < n; ++i) {
      Number* row = m_rows.data() + i * row_length();
      row[n + i] = Number(1);
      for (const auto& [monomial, coefficient] : m_equalities[i].terms()) {
        std::fill(exponents.begin(), exponents.end(), 0);
        for (const auto& [v, e] : monomial.powers)
          exponents[v] = e;
        const Number c(coefficient);
        row[2 * n] += derivative(c, {});
        for (std::size_t j = 0; j < n; ++j)
          if (exponents[j] > 0) {
            row[j] += derivative(c, {j});
            for (std::size_t l = 0; l <= j; ++l)
              if (exponents[l] > (l == j ? 1 : 0)) {
                const Number second = derivative(c, {j, l});
                m_hessians[(i * n + j) * n + l] += second;
                if (l != j)
                  m_hessians[(i * n + l) * n + j] += second;
              }
          }
      }
    }
  }

  static double size(const Number& x) { return x.is_bounded() ? std::abs(CGAL::to_double(x.midpoint())) : 0; }

  // To the point with w = 0 and no slope of the last row along the kernel; and the size of the last row there, relative to its curvature.
  std::pair<std::vector<Exact_rational>, double> newton_step()
  {
    const std::size_t n = m_dimension, length = row_length();
    const std::size_t free = static_cast<std::size_t>(std::find(m_row.begin(), m_row.end(), -1) - m_row.begin());
    const Number* last = m_rows.data() + (n - 1) * length;
    std::vector<Number> kernel(n, Number(1)), move(n, Number(0));
    for (std::size_t j = 0; j < n; ++j)
      if (j != free) {
        kernel[j] = -m_rows[m_row[j] * length + free];
        move[j] = -m_rows[m_row[j] * length + 2 * n];
      }
    Number curvature(0), mixed(last[free]);   // of the last row: along the kernel, and along kernel and move
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t l = 0; l < n; ++l) {
          const Number entry = last[n + i] * m_hessians[(i * n + j) * n + l] * kernel[j];
          curvature += entry * kernel[l];
          mixed += entry * move[l];
        }
    const bool are_bounded = std::all_of(m_rows.begin(), m_rows.end(), [](const Number& x) { return x.is_bounded(); });   // no pivot was zero up to rounding
    if (!are_bounded || !mixed.is_bounded() || !curvature.is_bounded() || CGAL::is_zero(curvature.midpoint()))
      return {std::vector<Exact_rational>(n, Exact_rational(1e300)), HUGE_VAL};
    const Exact_rational s = -mixed.midpoint() / curvature.midpoint();
    std::vector<Exact_rational> result;
    for (std::size_t j = 0; j < n; ++j)
      result.push_back(move[j].midpoint() + s * kernel[j].midpoint());
    return {result, size(last[2 * n]) / size(curvature)};
  }
};

// The same for an open box.
template <class Box>
bool is_nearly_double_root(const Constraint_system_d& system, const Box& box, int bits)
{
  std::vector<Exact_rational> middle;
  double width = 0;
  for (std::size_t j = 0; j < box.lower.size(); ++j) {
    middle.push_back((Exact_rational(box.lower[j]) + Exact_rational(box.upper[j])) / Exact_rational(2));
    width = (std::max)(width, CGAL::to_double(Exact_rational(Exact_rational(box.upper[j]) - Exact_rational(box.lower[j]))));
  }
  return Nearly_double_root(system, middle)(middle, width, bits);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEARLY_DOUBLE_ROOT_H
