// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_QUADRATIC_CONE_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_QUADRATIC_CONE_TEST_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_point.h>

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

/*
Proves that a point p where f and its gradient are zero is a cone or isolated, if the second derivative is regular
there: p may be any point of a small box.

In a convex box around p let f(x) = d' Q d / 2 and grad f(x) = Q' d with d = x - p, where Q and Q' are averages of the
second derivative in the box. In coordinates in which these are S + E and S + E', S a diagonal of +-1 and the norms of E
and E' at most e < 1/3, let phi = |d|^2. Where f is zero and grad f = lambda d, |d' S d| <= e |d|^2 and so
|lambda| <= 2 e; as S d = lambda d - E' d, |d| <= 3 e |d| and d = 0. The same holds where grad f = 0.

Let g = 0 be a surface through p with the unit normal w there, of which the gradient of g over its length at p differs
by eta < 1/4 at most, and d = v + t w with v perpendicular to w. As a mean of gradients is perpendicular to d,
|t| <= eta |d| and |d| <= k |v| with k = 1 / (1 - eta); so d is no multiple of grad g. Where f and g are zero and
alpha d + grad f + gamma grad g = 0, let A be S on the plane perpendicular to w. The share in that plane is
alpha v + A v + r = 0. Along w one has |gamma| <= k (|alpha| eta + 1 + e) |d|, so that
|r| <= k (e + eta + k eta (1 + e) + k eta^2 |alpha|) |v|. And |alpha| |v|^2 <= |v' A v| + |r| |v|, where
|v' A v| <= k^2 (e + 3 eta) |v|^2 as f = 0. If |A v| is always greater than |alpha| |v| + |r|, there is no such point
but p: the curve f = g = 0 is regular but for p, and phi has no critical point on it. The eigenvalues of A are s and
s (2 c^2 - 1), where -s is the sign in S that is there once and c the component of w that belongs to it.
*/
class Quadratic_cone_test
{
  using Matrix = std::array<std::array<double, 3>, 3>;

  Power_polynomial m_centred; // f in the differences from the middle
  Exact_point m_middle;
  std::vector<Interval_polynomial> m_second; // derivatives, of the lower triangle

  static constexpr double largest_error = 0.3;

public:
  Quadratic_cone_test(const Power_polynomial& equation, const Exact_point& middle)
    : m_centred(centred(equation, middle)), m_middle(middle)
  {
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k <= j; ++k)
        m_second.emplace_back(m_centred.derivative(j).derivative(k));
  }

  // `point`: a small box with p; `lengths`: of the domain.
  std::optional<Cone_point> operator()(const Exact_ranges& point, const std::vector<double>& lengths) const
  {
    const Upward_rounding_guard guard;
    Cone_point result{point, m_middle, Interval_polynomial(m_centred), {}, {2, 2, 2}, {}};
    const auto [basis, signs] = normal_form(second_derivative(result.difference(point)), lengths);
    if (signs[0] == 0)
      return std::nullopt;
    for (double share = 0x1p-2; share >= 0x1p-12; share /= 2) {
      Exact_point distances;
      for (const double length : lengths)
        distances.emplace_back(share * length);
      result.region = box_around(m_middle, distances);
      if (is_within(point, result.region) &&
          error(second_derivative(result.difference(result.region)), basis, signs) < largest_error) {
        use_inverse(basis, result);
        return result;
      }
    }
    return std::nullopt;
  }

  // Whether a surface through p crosses the cone within a convex box around p as above. `normal`: its gradient at p;
  // `normals`: those in the box.
  bool is_crossed(const Cone_point& point, const Exact_ranges& box, const std::vector<double>& lengths,
                  const Interval_box& normal, const Interval_box& normals) const
  {
    const Upward_rounding_guard guard;
    const auto [basis, signs] = normal_form(second_derivative(point.difference(point.point)), lengths);
    const int sum = signs[0] + signs[1] + signs[2];
    if (signs[0] == 0 || std::abs(sum) == 3)
      return false;
    const std::size_t single = static_cast<std::size_t>(std::find(signs.begin(), signs.end(), -sum) - signs.begin());
    const Interval_box w = in_basis(basis, normal), others = in_basis(basis, normals);
    Interval length(0), difference(0);
    for (std::size_t k = 0; k < 3; ++k) {
      length += CGAL::square(w[k]);
      difference += CGAL::square(others[k] - w[k]);
    }
    const Interval e(error(second_derivative(point.difference(box)), basis, signs));
    if (!(length.inf() > 0 && e.sup() < largest_error))
      return false;
    constexpr double largest_turn = 0.25;
    const Interval eta = CGAL::sqrt(Interval((difference / length).sup())), one(1);
    if (!(eta.sup() < largest_turn))
      return false;
    const Interval k = one / (one - eta), share = CGAL::square(k * eta);
    const Interval rest = k * (e + eta) + CGAL::square(k) * eta * (one + e);
    const Interval alpha = (CGAL::square(k) * (e + Interval(3) * eta) + rest) / (one - share);
    const Interval second = Interval(2) * CGAL::square(w[single]) / length - one;
    return (alpha + rest + share * alpha).sup() < (std::min)((std::max)(second.inf(), -second.sup()), 1.0);
  }

private:
  static Interval_box in_basis(const Matrix& basis, const Interval_box& gradient)
  {
    Interval_box result{Interval(0), Interval(0), Interval(0)};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        result[k] += Interval(basis[j][k]) * gradient[j];
    return result;
  }

  std::array<Interval_box, 3> second_derivative(const Interval_box& box) const
  {
    std::array<Interval_box, 3> result;
    auto next = m_second.begin();
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k <= j; ++k)
        result[j][k] = result[k][j] = (*next++)(box).value;
    return result;
  }

  // Columns in which a form is about a diagonal of the signs; these are zero if it seems to be singular.
  static std::pair<Matrix, std::array<int, 3>> normal_form(const std::array<Interval_box, 3>& form,
                                                           const std::vector<double>& lengths)
  {
    constexpr double singular = 0x1p-30;
    Matrix own, columns{};
    for (std::size_t j = 0; j < 3; ++j) {
      columns[j][j] = 1;
      for (std::size_t k = 0; k < 3; ++k)
        own[j][k] = middle_of(form[j][k]) * lengths[j] * lengths[k];
    }
    for (int sweep = 0; sweep < 12; ++sweep)
      for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
        rotate(own, columns, static_cast<std::size_t>(p), static_cast<std::size_t>(q));
    const double largest = (std::max)({std::abs(own[0][0]), std::abs(own[1][1]), std::abs(own[2][2])});
    std::array<int, 3> signs{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      if (!(std::abs(own[k][k]) > singular * largest))
        return {columns, {0, 0, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      signs[k] = own[k][k] > 0 ? 1 : -1;
      for (std::size_t j = 0; j < 3; ++j)
        columns[j][k] *= lengths[j] / std::sqrt(std::abs(own[k][k]));
    }
    return {columns, signs};
  }

  // One of Jacobi's rotations, which makes an entry zero.
  static void rotate(Matrix& own, Matrix& columns, std::size_t p, std::size_t q)
  {
    const double angle = 0.5 * std::atan2(2 * own[p][q], own[p][p] - own[q][q]), c = std::cos(angle),
                 s = std::sin(angle);
    const auto turn = [&](double& first, double& second) {
      const double before = first;
      first = c * before + s * second;
      second = c * second - s * before;
    };
    for (std::size_t k = 0; k < 3; ++k)
      turn(own[p][k], own[q][k]);
    for (std::size_t k = 0; k < 3; ++k) {
      turn(own[k][p], own[k][q]);
      turn(columns[k][p], columns[k][q]);
    }
  }

  // A bound on the norm of the form in a basis without the signs, by the sums of rows.
  static double error(const std::array<Interval_box, 3>& form, const Matrix& basis, const std::array<int, 3>& signs)
  {
    double result = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      Interval sum(0);
      for (std::size_t b = 0; b < 3; ++b) {
        Interval entry(a == b ? -signs[a] : 0);
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k)
            entry += form[j][k] * (Interval(basis[j][a]) * Interval(basis[k][b]));
        sum += Interval((std::max)(std::abs(entry.inf()), std::abs(entry.sup())));
      }
      if (!(sum.sup() < largest_error))
        return 1; // also when it is no number
      result = (std::max)(result, sum.sup());
    }
    return result;
  }

  // d = basis u, exactly.
  static void use_inverse(const Matrix& basis, Cone_point& result)
  {
    std::array<Exact_point, 3> rows;
    for (std::size_t j = 0; j < 3; ++j)
      rows[j].assign(basis[j].begin(), basis[j].end());
    const std::array<Exact_point, 3> inverse = inverse_of(rows);
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        result.rows[j][k] = interval_of(inverse[j][k]);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_QUADRATIC_CONE_TEST_H
