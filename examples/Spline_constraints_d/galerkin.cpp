// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The method of Galerkin with B-splines in exact numbers: -u'' + c u = f between 0 and 1, where u is zero at both ends
// and f is a polynomial. Matrices are integrals of products of splines and their derivatives, all of them rational
// numbers. Splines of the degree of u give u itself, on any knots; of cubic ones, the error is as it is, without any
// rounding: its integral with each test function is zero, and its square falls with the eighth power of the knots'
// distance.
//
// Exit status: 0 when all that is so, 1 when not.
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using Function = SC::Bspline_function<Number>;

namespace {

// A B-spline has as its integral the length of its support, divided by its order.
Number integral(const Function& f)
{
  const std::size_t order = f.degree(0) + 1;
  Number sum = 0;
  for (std::size_t i = 0; i < f.size(0); ++i)
    sum += f.coefficients()[i] * (f.knots(0)[i + order] - f.knots(0)[i]);
  return sum / order;
}

// Clamped, with these breaks.
std::vector<Number> knots(int degree, std::vector<Number> breaks)
{
  breaks.insert(breaks.begin(), degree, 0);
  breaks.insert(breaks.end(), degree, 1);
  return breaks;
}

std::vector<Function> basis(int degree, const std::vector<Number>& knots)
{
  std::vector<Function> result;
  for (std::size_t i = 0, n = knots.size() - degree - 1; i < n; ++i) {
    std::vector<Number> coefficients(n, 0);
    coefficients[i] = 1;
    result.push_back(Function({degree}, {knots}, coefficients));
  }
  return result;
}

// Of a positive definite matrix: without pivoting, exactly.
std::vector<Number> solution(std::vector<std::vector<Number>> matrix, std::vector<Number> right)
{
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i)
      if (matrix[i][k] != 0) {
        const Number factor = matrix[i][k] / matrix[k][k];
        for (std::size_t j = k; j < n; ++j)
          matrix[i][j] -= factor * matrix[k][j];
        right[i] -= factor * right[k];
      }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j)
      right[k] -= matrix[k][j] * right[j];
    right[k] /= matrix[k][k];
  }
  return right;
}

struct Problem
{
  Number c;
  Function f;

  // Stiffness and mass: the integral of u' v' + c u v over the support of v, the i-th B-spline.
  Number energy(Function u, Function v, std::size_t i) const
  {
    u = on_support(u, v, i);
    v = on_support(v, v, i);
    return integral(u.derivative(0) * v.derivative(0)) + c * integral(u * v);
  }

  static Function on_support(const Function& f, const Function& spline, std::size_t i)
  {
    return f.restricted(0, spline.knots(0)[i], spline.knots(0)[i + spline.degree(0) + 1]);
  }

  // The spline of which -u'' + c u - f is orthogonal to all splines on these knots that are zero at both ends.
  Function solved(const std::vector<Function>& basis) const
  {
    const std::size_t n = basis.size() - 2, order = basis.front().degree(0) + 1;
    std::vector<std::vector<Number>> matrix(n, std::vector<Number>(n, 0));
    std::vector<Number> right;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < std::min(n, i + order); ++j)
        matrix[i][j] = matrix[j][i] = energy(basis[i + 1], basis[j + 1], j + 1);
      const Function& spline = basis[i + 1];
      right.push_back(integral(on_support(f, spline, i + 1) * on_support(spline, spline, i + 1)));
    }
    std::vector<Number> coefficients = solution(std::move(matrix), std::move(right));
    coefficients.insert(coefficients.begin(), 0);
    coefficients.push_back(0);
    return Function({basis.front().degree(0)}, {basis.front().knots(0)}, coefficients);
  }
};

} // namespace

int main()
{
  const Function x({1}, {{0, 0, 1, 1}}, {0, 1}), u = x * (x - Number(1)) * (x * x * x * x - x * Number(2) + Number(3));
  bool is_right = true;
  for (const Number& c : {Number(0), Number(Number(5) / 3)}) {
    const Problem problem{c, u * c - u.derivative(0).derivative(0)};

    const auto uneven = basis(6, knots(6, {0, Number(1) / 7, Number(1) / 3, Number(1) / 2, Number(9) / 10, 1}));
    const bool is_exact = problem.solved(uneven) == u;
    std::cout << "c = " << c << ": of degree 6, " << (is_exact ? "exact" : "not exact") << "; squared errors of cubic "
              << "splines:";
    is_right = is_right && is_exact;

    double last_error = 0;
    for (const int cells : {4, 8, 16, 32}) {
      std::vector<Number> breaks;
      for (int k = 0; k <= cells; ++k)
        breaks.push_back(Number(k) / cells);
      const auto cubic = basis(3, knots(3, breaks));
      const Function error = u - problem.solved(cubic);
      for (std::size_t i = 1; i + 1 < cubic.size(); ++i)
        is_right = is_right && problem.energy(error, cubic[i], i) == 0;
      const double squared_error = CGAL::to_double(integral(error * error));
      std::cout << ' ' << squared_error;
      if (last_error > 0) {
        std::cout << " (/ " << std::lround(last_error / squared_error) << ")";
        is_right = is_right && last_error / squared_error > 200 && last_error / squared_error < 300;
      }
      last_error = squared_error;
    }
    std::cout << '\n';
  }
  return is_right ? 0 : 1;
}
