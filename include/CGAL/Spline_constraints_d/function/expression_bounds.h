// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_BOUNDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_BOUNDS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/function/internal/Formula_expansion.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_range = std::pair<Exact_rational, Exact_rational>;

// The least and the greatest Bernstein coefficient on the parts of the box in all cells.
Exact_range bounds_of_term(const Spline_term& term, const Unknown_domains& box);

// A polynomial in symbols, expanded, for its bounds on many boxes.
class Polynomial_bounds
{
  Spline_function m_function; // times the scale
  Exact_rational m_scale = 1;

public:
  Polynomial_bounds(const Symbol_table& symbols, const Power_polynomial& polynomial);

  Exact_range operator()(const Unknown_domains& box) const;
};

// The two halves of a box along its widest axis. \pre there is an axis
std::pair<Unknown_domains, Unknown_domains> halves_of(const Unknown_domains& box);

inline Exact_range hull_of(const Exact_range& a, const Exact_range& b)
{
  return {(std::min)(a.first, b.first), (std::max)(a.second, b.second)};
}

// A formula, for its bounds on many boxes.
class Expression_bounds
{
  Polynomial_bounds m_numerator, m_denominator;

public:
  explicit Expression_bounds(const Expression& formula)
    : m_numerator(*formula.symbols(), formula.numerator()),
      m_denominator(*formula.symbols(), polynomial_of(formula.denominator()))
  {}

  // Nothing where the bounds of the denominator hold zero, after so many halvings of parts of the box.
  std::optional<Exact_range> operator()(const Unknown_domains& box, int halvings) const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_range bounds_of_term(const Spline_term& term, const Unknown_domains& box)
{
  if (term.variables.empty())
    return {term.pieces[0][0], term.pieces[0][0]};
  std::vector<int> last_cells, first, steps;
  for (std::size_t j = 0; j < term.variables.size(); ++j) {
    const auto& [lower, upper] = box[term.variables[j]];
    last_cells.push_back(static_cast<int>(term.cells(j)) - 1);
    first.push_back(static_cast<int>(cell_at(term.breaks[j], lower)));
    steps.push_back(static_cast<int>(cell_at(term.breaks[j], upper)) - first.back());
  }
  const std::vector<std::size_t> strides = tensor_strides(last_cells);
  std::optional<Exact_range> result;
  for_each_index(steps, [&](const std::vector<int>& step) {
    std::size_t cell = 0;
    Unknown_domains part;
    for (std::size_t j = 0; j < step.size(); ++j) {
      const std::size_t k = static_cast<std::size_t>(first[j] + step[j]);
      cell += strides[j] * k;
      part.push_back(box[term.variables[j]]);
      if (step[j] > 0)
        part.back().first = term.breaks[j][k];
      if (step[j] < steps[j])
        part.back().second = term.breaks[j][k + 1];
    }
    const auto tensor = Bernstein_tensor<Exact_rational>::from_power_on_box(term.degrees, term.pieces[cell], part);
    const auto [least, greatest] = std::minmax_element(tensor.coefficients().begin(), tensor.coefficients().end());
    result = result ? Exact_range((std::min)(result->first, *least), (std::max)(result->second, *greatest))
                    : Exact_range(*least, *greatest);
  });
  return *result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<Unknown_domains, Unknown_domains> halves_of(const Unknown_domains& box)
{
  const auto widest =
      std::max_element(box.begin(), box.end(),
                       [](const auto& a, const auto& b) { return a.second - a.first < b.second - b.first; }) -
      box.begin();
  std::pair<Unknown_domains, Unknown_domains> result(box, box);
  result.first[widest].second = result.second[widest].first =
      Exact_rational((box[widest].first + box[widest].second) / 2);
  return result;
}
#endif

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Polynomial_bounds::Polynomial_bounds(const Symbol_table& symbols,
                                                                    const Power_polynomial& polynomial)
{
  symbols.require_no_values(polynomial, "bounds");
  const Power_polynomial without_formulas = symbols.without_formulas(polynomial);
  const Formula_expansion expansion(symbols, without_formulas);
  m_function = expansion.scaled_function();
  m_scale = scaled_rational(expansion.denominator(), 0);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_range Polynomial_bounds::operator()(const Unknown_domains& box) const
{
  Exact_range result(0, 0);
  for (const Spline_term& term : m_function.terms()) {
    const auto [lower, upper] = bounds_of_term(term, box);
    result.first += lower / m_scale;
    result.second += upper / m_scale;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_range> Expression_bounds::operator()(const Unknown_domains& box,
                                                                                        int halvings) const
{
  const Exact_range below = m_denominator(box);
  if (below.first <= 0 && below.second >= 0) {
    if (halvings == 0)
      return std::nullopt;
    const auto [first, second] = halves_of(box);
    const auto a = (*this)(first, halvings - 1), b = a ? (*this)(second, halvings - 1) : a;
    return b ? std::optional(hull_of(*a, *b)) : std::nullopt;
  }
  const Exact_range above = m_numerator(box);
  const std::array<Exact_rational, 4> quotients{
      Exact_rational(above.first / below.first), Exact_rational(above.first / below.second),
      Exact_rational(above.second / below.first), Exact_rational(above.second / below.second)};
  const auto [least, greatest] = std::minmax_element(quotients.begin(), quotients.end());
  return Exact_range(*least, *greatest);
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

bounds of a formula: numbers that its values on a box lie between; nothing when they do not show that its denominator is
different from zero.

They are the least and the greatest Bernstein coefficient of the numerator, over those of the denominator; on boxes of
width \f$h\f$ they exceed the values by \f$O(h^2)\f$ for polynomials and \f$O(h)\f$ for quotients.
\param formula the formula.
\param box a range for each unknown that was made together with those in the formula, within its own range.
\param halvings how often parts of the box are halved where the bounds of the denominator hold zero.
\throws Invalid_input when the box has a wrong number of ranges, and as `Constraint::spline_function()`.
*/
std::optional<std::pair<Exact_rational, Exact_rational>> bounds(const Expression& formula, const Unknown_domains& box,
                                                                int halvings = 4);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::pair<Exact_rational, Exact_rational>>
bounds(const Expression& formula, const Unknown_domains& box, int halvings)
{
  if (formula.symbols() == nullptr)
    return internal::Exact_range(formula.numerator().constant_term(), formula.numerator().constant_term());
  internal::check_count(box.size(), formula.symbols()->domains().size(), "bounds: ranges of the box");
  return internal::Expression_bounds(formula)(box, halvings);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_BOUNDS_H
