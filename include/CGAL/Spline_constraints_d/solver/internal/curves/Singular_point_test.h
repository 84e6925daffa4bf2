// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SINGULAR_POINT_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SINGULAR_POINT_TEST_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_polynomials.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Polynomial_jets.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A singular point of the curves of solutions, and how many branches end in it.
struct Proved_singularity
{
  Exact_ranges box;
  std::size_t branches;   // 4: two curves cross; 0: the point is isolated
};

/*
Proves that a small box holds just one singular point of n - 1 polynomials f, and that the solutions in the box are four
branches that end there, or none.

A singular point p is a zero of f and of all minors of the Jacobian J. If n - 2 combinations g of the equations can be
solved for as many unknowns w, and lambda is the left null vector of J(p), then the gradient of h = lambda f vanishes at
p. For two solutions x and y of g = 0 in the box x - y = B d, with d the difference of the two other unknowns and B in
an interval matrix, so that h(x) = d' Q d / 2 with d = x - p and the derivative of h along g = 0 is Q d, each with some
Q in the interval matrix B' H B, where H bounds the second derivatives of h. In coordinates where Q is diag(+-1, +-1) up
to errors of at most e < 1/3:

- if the signs are equal, h is zero in p only;
- otherwise zeros have ||d1| - |d2|| <= e (|d1| + |d2|), four cones, and in each of them the derivative by d1 has one
  sign: at most one zero for each d2, no closed curve, and near p there is one branch in each cone
  by the lemma of Morse.
*/
class Singular_point_test
{
  using Interval = CGAL::Interval_nt<false>;   // within an Upward_rounding_guard
  using Matrix = std::vector<std::vector<Interval>>;

  const Curve_polynomials& m_curves;
  const Exact_ranges& m_box;
  Run_control& m_control;
  Exact_point m_middle;
  // the equations in the differences from the middle of the box, so that intervals do not cancel
  std::vector<Power_polynomial> m_centred;
  std::size_t m_dimension;

  static constexpr double largest_error = 0.3;

public:
  Singular_point_test(const Curve_polynomials& curves, const Exact_ranges& box, Run_control& control)
    : m_curves(curves), m_box(box), m_control(control), m_dimension(box.size())
  {
    for (const auto& [lower, upper] : m_box)
      m_middle.push_back(Exact_rational((lower + upper) / 2));
    for (const Power_polynomial& equation : m_curves.equations())
      m_centred.push_back(centred(equation, m_middle));
  }

  std::optional<Proved_singularity> operator()() const
  {
    const std::optional<Exact_ranges> point = m_curves.singular_point_in(m_box, m_control);
    if (!point)
      return std::nullopt;
    const Mpfr_precision_scope precision(128);
    const Upward_rounding_guard guard;
    const std::optional<std::array<Interval, 3>> form = quadratic_form(*point);
    const std::optional<std::size_t> branches = form ? branches_of(*form) : std::nullopt;
    return branches ? std::optional(Proved_singularity{*point, *branches}) : std::nullopt;
  }

private:
  Polynomial_jets jets(const Exact_ranges& box, int order) const
  {
    std::vector<Mpfr_interval> numbers;
    for (std::size_t j = 0; j < m_dimension; ++j)
      numbers.emplace_back(Exact_rational(box[j].first - m_middle[j]), Exact_rational(box[j].second - m_middle[j]));
    return Polynomial_jets(m_centred, numbers, order);
  }

  static Interval rounded(const Mpfr_interval& x)
  {
    const auto enclosure = Number_traits<Mpfr_interval>::enclosure(x);
    return {enclosure.inf(), enclosure.sup()};
  }

  Matrix jacobian(const Polynomial_jets& jets) const
  {
    Matrix result(m_centred.size(), std::vector<Interval>(m_dimension));
    for (std::size_t i = 0; i < m_centred.size(); ++i)
      for (std::size_t j = 0; j < m_dimension; ++j)
        result[i][j] = rounded(jets.gradient(i, j));
    return result;
  }

  static double magnitude(const Interval& x) { return (std::max)(std::abs(x.inf()), std::abs(x.sup())); }
  static Interval around_zero(double radius) { return {-radius, radius}; }

  // The entries (0,0), (0,1), (1,1) of B' H B, in the two unknowns that g is not solved for.
  std::optional<std::array<Interval, 3>> quadratic_form(const Exact_ranges& point) const
  {
    const Polynomial_jets on_box = jets(m_box, 2);
    const Matrix on_all = jacobian(on_box), at_point = jacobian(jets(point, 1));
    const std::size_t equations = m_centred.size(), solved = equations - 1, length = m_dimension + equations;
    std::vector<double> rows(equations * length, 0.0);   // (J | I)
    for (std::size_t i = 0; i < equations; ++i) {
      for (std::size_t j = 0; j < m_dimension; ++j)
        rows[i * length + j] = 0.5 * (at_point[i][j].inf() + at_point[i][j].sup());
      rows[i * length + m_dimension + i] = 1;
    }
    const std::vector<int> row_of =
        gauss_jordan(rows, length, m_dimension, solved, [](double x) { return std::abs(x); });
    if (row_of.empty())
      return std::nullopt;
    const auto transformed = [&](const Matrix& jacobian, std::size_t row, std::size_t column) {
      Interval sum(0);
      for (std::size_t l = 0; l < equations; ++l)
        sum += Interval(rows[row * length + m_dimension + l]) * jacobian[l][column];
      return sum;
    };
    std::vector<std::size_t> solved_for, others;
    for (std::size_t j = 0; j < m_dimension; ++j)
      (row_of[j] >= 0 ? solved_for : others).push_back(j);

    // How far the derivatives of g by w are from the identity, in the row sums; then those of w by the others are
    // known.
    Interval defect(0);
    for (std::size_t i = 0; i < solved; ++i) {
      Interval sum(0);
      for (const std::size_t j : solved_for)
        sum += Interval(magnitude(transformed(on_all, i, j) - Interval(row_of[j] == static_cast<int>(i) ? 1 : 0)));
      defect = Interval((std::max)(defect.sup(), sum.sup()));
    }
    if (!(defect.sup() < 0.5))
      return std::nullopt;
    const double excess = (defect / (Interval(1) - defect)).sup();
    std::vector<std::array<Interval, 2>> basis(m_dimension);   // B
    for (std::size_t c = 0; c < 2; ++c) {
      basis[others[c]] = {Interval(c == 0 ? 1 : 0), Interval(c == 1 ? 1 : 0)};
      double largest = 0;
      for (std::size_t i = 0; i < solved; ++i)
        largest = (std::max)(largest, magnitude(transformed(on_all, i, others[c])));
      const double error = (Interval(excess) * Interval(largest)).sup();
      for (const std::size_t j : solved_for)
        basis[j][c] = -transformed(on_all, static_cast<std::size_t>(row_of[j]), others[c]) + around_zero(error);
    }

    // The null vector is the last row of T, up to a small combination of the others that makes its products with the
    // columns of w zero.
    double residual = 0;
    for (const std::size_t j : solved_for)
      residual = (std::max)(residual, magnitude(transformed(at_point, solved, j)));
    Interval correction = Interval(residual) / (Interval(1) - defect) * Interval(static_cast<double>(m_dimension));
    std::vector<Interval> null_vector;
    for (std::size_t l = 0; l < equations; ++l) {
      Interval sum(0);
      for (std::size_t i = 0; i < solved; ++i)
        sum += Interval(std::abs(rows[i * length + m_dimension + l]));
      null_vector.push_back(Interval(rows[solved * length + m_dimension + l]) + around_zero((correction * sum).sup()));
    }

    std::array<Interval, 3> form{Interval(0), Interval(0), Interval(0)};
    for (std::size_t j = 0; j < m_dimension; ++j)
      for (std::size_t k = 0; k < m_dimension; ++k) {
        Interval second(0);
        for (std::size_t l = 0; l < equations; ++l)
          second += null_vector[l] * rounded(on_box.hessian(l, j, k));
        form[0] += basis[j][0] * second * basis[k][0];
        form[1] += basis[j][0] * second * basis[k][1];
        form[2] += basis[j][1] * second * basis[k][1];
      }
    return form;
  }

  // By the signs of the eigenvalues, in coordinates that make them about +-1.
  static std::optional<std::size_t> branches_of(const std::array<Interval, 3>& form)
  {
    const auto middle = [](const Interval& x) { return 0.5 * (x.inf() + x.sup()); };
    const double a = middle(form[0]), b = middle(form[1]), c = middle(form[2]);
    const double angle = 0.5 * std::atan2(2 * b, a - c), cosine = std::cos(angle), sine = std::sin(angle);
    const double first = a * cosine * cosine + 2 * b * cosine * sine + c * sine * sine,
                 second = a * sine * sine - 2 * b * cosine * sine + c * cosine * cosine;
    if (!(std::abs(first) > 0 && std::abs(second) > 0))
      return std::nullopt;
    const double p = 1 / std::sqrt(std::abs(first)), q = 1 / std::sqrt(std::abs(second));
    const std::array<std::array<Interval, 2>, 2> directions{
        {{Interval(p * cosine), Interval(p * sine)}, {Interval(-q * sine), Interval(q * cosine)}}};
    const auto product = [&](std::size_t i, std::size_t k) {
      const auto &u = directions[i], &v = directions[k];
      return u[0] * form[0] * v[0] + u[0] * form[1] * v[1] + u[1] * form[1] * v[0] + u[1] * form[2] * v[1];
    };
    const double error = (std::max)({magnitude(product(0, 0) - Interval(first > 0 ? 1 : -1)), magnitude(product(0, 1)),
                                     magnitude(product(1, 1) - Interval(second > 0 ? 1 : -1))});
    if (!(error < largest_error))
      return std::nullopt;
    return (first > 0) == (second > 0) ? 0 : 4;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SINGULAR_POINT_TEST_H
