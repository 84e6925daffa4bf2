// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ALGEBRAIC_POSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ALGEBRAIC_POSITION_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Algebraic_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

enum class Position { INSIDE, OUTSIDE, ON_DOMAIN_BOUNDARY, ON_INEQUALITY, ON_EQUALITY };

// No break of the function between two of its pieces lies in the box.
inline bool is_one_piece(const Spline_function& function, const Exact_box& box)
{
  for (const Spline_term& term : function.terms())
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      const auto& [lower, upper] = box[term.variables[j]];
      const auto& breaks = term.breaks[j];
      for (std::size_t k = 1; k + 1 < breaks.size(); ++k)
        if (lower <= breaks[k] && breaks[k] <= upper)
          return false;
    }
  return true;
}

// The equalities on a box as polynomials with integer coefficients, up to positive factors; nothing when one has a
// break there, or coefficients that are too long.
inline std::optional<std::vector<Power_polynomial>> integer_equalities(const Constraint_system_d& system,
                                                                       const Exact_box& box)
{
  std::vector<Power_polynomial> result;
  for (const Spline_function& function : system.equalities()) {
    if (!is_one_piece(function, box))
      return std::nullopt;
    const auto polynomial = with_integer_coefficients(polynomial_at(function, middle_of(box)));
    if (!polynomial)
      return std::nullopt;
    result.push_back(*polynomial);
  }
  return result;
}

// Gauss-Jordan elimination of the Jacobian at a point, beside it a unit matrix: as many pivots as `rank`; empty when
// there are fewer.
inline std::vector<Mpfr_interval> eliminated_jacobian(const std::vector<Power_polynomial>& polynomials,
                                                      const std::vector<Exact_rational>& point, std::size_t rank)
{
  const std::size_t n = point.size(), m = polynomials.size();
  const Mpfr_precision_scope scope(256);
  const Polynomial_jets jets(polynomials, std::vector<Mpfr_interval>(point.begin(), point.end()), 2);
  std::vector<Mpfr_interval> rows(m * (n + m), Mpfr_interval(0));
  for (std::size_t i = 0; i < m; ++i) {
    rows[i * (n + m) + n + i] = Mpfr_interval(1);
    // Rows of one length: factors of equations mean nothing. But a gradient that is zero at the root is only small at a
    // point beside it.
    constexpr double small = 0x1p-30;
    double longest = 0;
    for (std::size_t j = 0; j < n; ++j) {
      longest = (std::max)(longest, std::abs(CGAL::to_double(jets.gradient(i, j).midpoint())));
      for (std::size_t l = 0; l < n; ++l)
        longest = (std::max)(longest, small * std::abs(CGAL::to_double(jets.hessian(i, j, l).midpoint())));
    }
    for (std::size_t j = 0; j < n && longest > 0 && longest < HUGE_VAL; ++j)
      rows[i * (n + m) + j] = Mpfr_interval(Exact_rational(jets.gradient(i, j).midpoint() / Exact_rational(longest)));
  }
  // what rounding cannot tell from zero is no pivot
  const auto size = [](const Mpfr_interval& x) {
    return x.is_bounded() && CGAL::is_certain(x.sign()) ? std::abs(CGAL::to_double(x.midpoint())) : 0.0;
  };
  return gauss_jordan(rows, n + m, n, rank, size).empty() ? std::vector<Mpfr_interval>() : rows;
}

// n of the polynomials with independent gradients at a point, and the others after them; empty when there are none.
inline std::vector<Power_polynomial> independent_first(const std::vector<Power_polynomial>& polynomials,
                                                       const std::vector<Exact_rational>& point)
{
  const std::size_t n = point.size(), m = polynomials.size();
  const auto rows = eliminated_jacobian(polynomials, point, n);
  std::vector<Power_polynomial> result, others;
  for (std::size_t k = 0; k < m && !rows.empty(); ++k) {
    bool is_pivot = false;   // takes part in the rows of the pivots
    for (std::size_t i = 0; i < n; ++i)
      is_pivot = is_pivot || !rows[i * (n + m) + n + k].is_same(Mpfr_interval(0));
    (is_pivot ? result : others).push_back(polynomials[k]);
  }
  if (result.size() != n)
    return {};
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

// Whether a root that satisfies the equalities lies in the domain and satisfies the inequalities, decided by exact
// signs; nothing about a root where an inequality has a break.
inline Position algebraic_position(const Constraint_system_d& system, Algebraic_root& root)
{
  Position result = Position::INSIDE;
  const Exact_box box = root.box();
  for (int j = 0; j < system.dimension(); ++j) {
    const auto sign_beside = [&](const Exact_rational& end) {
      const bool is_beside = box[j].second < end || end < box[j].first;
      return is_beside ? std::optional(box[j].second < end ? CGAL::NEGATIVE : CGAL::POSITIVE)
                       : root.sign_of(Power_polynomial::variable(j) - Power_polynomial(end));
    };
    const auto above = sign_beside(system.domain(j).first), below = sign_beside(system.domain(j).second);
    if (above == CGAL::NEGATIVE || below == CGAL::POSITIVE)
      return Position::OUTSIDE;
    if (!above || !below)
      result = Position::ON_DOMAIN_BOUNDARY;
  }
  for (const auto& inequality : system.inequalities()) {
    const auto sign = is_one_piece(inequality.function, box)
        ? root.sign_of(polynomial_at(inequality.function, middle_of(box)))
        : std::nullopt;
    if (sign && !is_satisfied(inequality.relation, *sign))
      return Position::OUTSIDE;
    if (!sign && result == Position::INSIDE)
      result = Position::ON_INEQUALITY;
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ALGEBRAIC_POSITION_H
