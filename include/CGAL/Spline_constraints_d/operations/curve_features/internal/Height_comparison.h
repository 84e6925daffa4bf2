// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_INTERNAL_HEIGHT_COMPARISON_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_INTERNAL_HEIGHT_COMPARISON_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Sign_sequence.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/critical_values.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Curve_features {

/*
Heights of the points of a curve in a direction, compared. Ranges of heights come from the coefficients of the curve on
the range of the parameter: about the critical points that are compared, heights differ by the square of its width.
Heights that are not told apart by that are zeros of polynomials, which decide whether they are equal.
*/
class Height_comparison
{
  struct Candidate
  {
    std::pair<Exact_rational, Exact_rational> parameters, heights;
    bool has_heights;
    bool is_exact() const { return has_heights && heights.first == heights.second; }
  };

  const std::vector<Differentiated_map>& m_pieces;
  Exact_pair m_direction;
  Bspline_function<Exact_rational> m_height, m_weight;
  Budgeted_solver& m_solve;
  std::vector<Candidate> m_candidates;

public:
  template <class Curve>
  Height_comparison(const Curve& curve, const std::vector<Differentiated_map>& pieces, const Exact_pair& direction,
                    const std::vector<Sign_event>& events, Budgeted_solver& solve)
    : m_pieces(pieces), m_direction(direction),
      m_height(curve.homogeneous_coordinates()[0] * direction[0] + curve.homogeneous_coordinates()[1] * direction[1]),
      m_weight(curve.weight()), m_solve(solve)
  {
    for (const Sign_event& event : events)
      m_candidates.push_back(candidate(event));
  }

  // Whether no candidate is higher (sign 1), or lower (sign -1), than one of them.
  CGAL::Uncertain<bool> is_global(std::size_t i, int sign) const;

private:
  Candidate candidate(const Sign_event& event) const;

  // Coefficients on common knots.
  static std::vector<std::pair<Exact_rational, Exact_rational>> quotients(const Bspline_function<Exact_rational>& h,
                                                                          const Bspline_function<Exact_rational>& w);

  CGAL::Uncertain<CGAL::Sign> compare(const Candidate& a, const Candidate& b) const;

  // Whether the polynomials of the heights of two critical points have one zero each where both heights are, and it is
  // the same.
  bool have_common_height(const Candidate& a, const Candidate& b) const;

  Expression height_polynomial(const Candidate& candidate, const Unknown& height) const;

  // Whether the critical point in a range has a given height: a system of two equations in one unknown, decided
  // exactly.
  bool attains(const Candidate& candidate, const Exact_rational& height) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<bool> Height_comparison::is_global(std::size_t i, int sign) const
{
  CGAL::Uncertain<bool> result = true;
  for (std::size_t j = 0; j < m_candidates.size(); ++j) {
    if (m_solve.must_stop())
      return CGAL::Uncertain<bool>::indeterminate();
    const CGAL::Uncertain<CGAL::Sign> comparison =
        i == j ? CGAL::Uncertain<CGAL::Sign>(CGAL::ZERO) : compare(m_candidates[j], m_candidates[i]);
    if (!comparison.is_certain())
      result = CGAL::Uncertain<bool>::indeterminate();
    else if (comparison.make_certain() * sign > 0)
      return false;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Height_comparison::Candidate Height_comparison::candidate(const Sign_event& event) const
{
  const auto& [lower, upper] = event.range;
  Candidate result{event.range, {}, true};
  if (lower == upper || event.is_family()) {
    const std::array<Exact_rational, 1> t{lower};
    result.heights.first = result.heights.second = Exact_rational(m_height(t) / m_weight(t));
    return result;
  }
  const Bspline_function<Exact_rational> h = m_height.restricted(0, lower, upper),
                                         w = m_weight.restricted(0, lower, upper);
  bool is_first = true;
  for (const auto& [a, b] : quotients(h, w)) {
    if (sign_of(b) == 0 || sign_of(b) != sign_of(w.coefficients()[0])) {
      result.has_heights = false;
      return result;
    }
    const Exact_rational quotient(a / b);
    result.heights.first = is_first ? quotient : (std::min)(result.heights.first, quotient);
    result.heights.second = is_first ? quotient : (std::max)(result.heights.second, quotient);
    is_first = false;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<Exact_rational, Exact_rational>>
Height_comparison::quotients(const Bspline_function<Exact_rational>& h, const Bspline_function<Exact_rational>& w)
{
  const Bspline_function<Exact_rational> zero = h * Exact_rational(0) + w * Exact_rational(0), a = h + zero,
                                         b = w + zero;
  std::vector<std::pair<Exact_rational, Exact_rational>> result;
  for (std::size_t i = 0; i < a.coefficients().size(); ++i)
    result.emplace_back(a.coefficients()[i], b.coefficients()[i]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<CGAL::Sign> Height_comparison::compare(const Candidate& a,
                                                                                      const Candidate& b) const
{
  if (a.has_heights && b.has_heights) {
    if (a.heights.first > b.heights.second)
      return CGAL::POSITIVE;
    if (a.heights.second < b.heights.first)
      return CGAL::NEGATIVE;
  }
  if ((a.is_exact() && b.is_exact()) || (a.is_exact() && attains(b, a.heights.first)) ||
      (b.is_exact() && attains(a, b.heights.first)) ||
      (a.has_heights && b.has_heights && !a.is_exact() && !b.is_exact() && have_common_height(a, b)))
    return CGAL::ZERO;
  return CGAL::Uncertain<CGAL::Sign>::indeterminate();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Height_comparison::have_common_height(const Candidate& a, const Candidate& b) const
{
  const std::vector<Unknown> height = unknowns(
      {{Bound((std::min)(a.heights.first, b.heights.first)), Bound((std::max)(a.heights.second, b.heights.second))}});
  const std::array<Expression, 2> polynomials{height_polynomial(a, height[0]), height_polynomial(b, height[0])};
  if (polynomials[0].numerator().is_zero() || polynomials[1].numerator().is_zero())
    return false;
  return m_solve({polynomials[0] == 0}).size() == 1 && m_solve({polynomials[1] == 0}).size() == 1 &&
      m_solve({polynomials[0] == 0, polynomials[1] == 0}).size() == 1;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression Height_comparison::height_polynomial(const Candidate& candidate,
                                                                               const Unknown& height) const
{
  const auto piece = std::find_if(m_pieces.begin(), m_pieces.end(),
                                  [&](const auto& p) { return candidate.parameters.second <= p.end(); });
  const auto tensor = [&](const Bspline_function<Exact_rational>& function) {
    return function.restricted(0, piece->begin(), piece->end()).bezier_pieces().front();
  };
  return Expression(critical_value_polynomial(tensor(m_height), tensor(m_weight), height.numerator()), Monomial(),
                    height.symbols());
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Height_comparison::attains(const Candidate& candidate,
                                                               const Exact_rational& height) const
{
  for (const Differentiated_map& piece : m_pieces) {
    const Exact_rational lower = (std::max)(candidate.parameters.first, piece.begin()),
                         upper = (std::min)(candidate.parameters.second, piece.end());
    if (!(lower < upper))
      continue;
    const std::vector<Unknown> u = unknowns({{Bound(lower), Bound(upper)}});
    const Vector_expression<2> direction{m_direction[0], m_direction[1]};
    if (!m_solve({dot(piece(1, u[0]), direction) == 0, dot(piece(0, u[0]), direction) == height}).empty())
      return true;
  }
  return false;
}
#endif

} // namespace Curve_features
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_INTERNAL_HEIGHT_COMPARISON_H
