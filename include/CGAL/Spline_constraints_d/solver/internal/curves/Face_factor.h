// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_FACE_FACTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_FACE_FACTOR_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A spline and the factor x - c, zero at an end c of the range of an unknown, or at a break in it. Where it is zero there,
all of its terms are, as a rule: those with other unknowns.
*/
class Face_factor
{
  const Spline_function& m_function;
  const int m_unknown;
  const Exact_rational m_value;
  const bool m_has_below, m_has_above;   // whether the domain goes on
  // of the cells at the face, on one side or both, the places among those of the unknown
  std::pair<std::size_t, std::size_t> m_layers;

public:
  Face_factor(const Spline_function& function, int unknown, const std::pair<Exact_rational, Exact_rational>& range,
              const Exact_rational& value)
    : m_function(function), m_unknown(unknown), m_value(value), m_has_below(range.first < value),
      m_has_above(value < range.second), m_layers(0, 0)
  {
    if (!function.terms().empty() && axis_of(function.terms().front()))
      m_layers = layers();
  }

  // Whether all terms are zero on the face, and have the same breaks of the unknown.
  bool divides() const
  {
    for (const Spline_term& term : m_function.terms()) {
      const std::optional<std::size_t> axis = axis_of(term);
      if (!axis || term.breaks[*axis] != breaks() || !vanishes(term, *axis))
        return false;
    }
    return !m_function.terms().empty();
  }

  // Divided by x - c in the cells at the face and, so that it stays continuous, by constants in the others. \pre
  // `divides()`
  Spline_function quotient() const
  {
    Spline_function result;
    for (Spline_term term : m_function.terms()) {
      const std::size_t axis = *axis_of(term);
      for (std::size_t c = 0; c < term.pieces.size(); ++c)
        if (is_at_face(term, axis, c))
          divide(term, axis, c);
        else
          for (Exact_rational& coefficient : term.pieces[c])
            coefficient /= distance(layer_of(term, axis, c));
      result += Spline_function(std::move(term));
    }
    return result;
  }

  // Divides a function by the factor as often as it can be. Returns how often this is.
  static int divide_out(Spline_function& function, int unknown, const std::pair<Exact_rational, Exact_rational>& range,
                        const Exact_rational& value)
  {
    int exponent = 0;
    for (; Face_factor(function, unknown, range, value).divides(); ++exponent)
      function = Face_factor(function, unknown, range, value).quotient();
    return exponent;
  }

private:
  std::optional<std::size_t> axis_of(const Spline_term& term) const
  {
    const auto place = std::find(term.variables.begin(), term.variables.end(), m_unknown);
    return place == term.variables.end() ? std::nullopt
                                         : std::optional(static_cast<std::size_t>(place - term.variables.begin()));
  }

  const std::vector<Exact_rational>& breaks() const
  {
    return m_function.terms().front().breaks[*axis_of(m_function.terms().front())];
  }

  std::pair<std::size_t, std::size_t> layers() const
  {
    if (breaks().empty())
      return {0, 0};
    const auto place = [&](const auto& next) { return static_cast<std::size_t>(next - breaks().begin()) - 1; };
    const std::size_t above = place(std::upper_bound(breaks().begin() + 1, breaks().end() - 1, m_value)),
                      below = place(std::lower_bound(breaks().begin() + 1, breaks().end() - 1, m_value));
    return {m_has_below ? below : above, m_has_above ? above : below};
  }

  // From the face to the next break, with the sign of that side of it.
  Exact_rational distance(std::size_t layer) const
  {
    const auto [first, last] = m_layers;
    const bool is_above = m_has_below && m_has_above ? last < layer : m_has_above;
    return Exact_rational(breaks()[is_above ? last + 1 : first] - m_value);
  }

  static std::size_t layer_of(const Spline_term& term, std::size_t axis, std::size_t cell)
  {
    std::size_t inner = 1;
    for (std::size_t j = axis + 1; j < term.variables.size(); ++j)
      inner *= term.cells(j);
    return cell / inner % term.cells(axis);
  }

  bool is_at_face(const Spline_term& term, std::size_t axis, std::size_t cell) const
  {
    const auto [first, last] = m_layers;
    const std::size_t layer = layer_of(term, axis, cell);
    return first <= layer && layer <= last;
  }

  bool vanishes(const Spline_term& term, std::size_t axis) const
  {
    for (std::size_t c = 0; c < term.pieces.size(); ++c) {
      if (!is_at_face(term, axis, c))
        continue;
      bool is_zero = true;
      std::vector<Exact_rational> piece = term.pieces[c];
      visit_rows(piece, term.degrees, axis, [&](const Exact_rational* a, std::size_t step) {
        Exact_rational sum(0);
        for (int k = term.degrees[axis]; is_zero && k >= 0; --k)
          sum = Exact_rational(sum * m_value + a[static_cast<std::size_t>(k) * step]);
        is_zero = is_zero && CGAL::is_zero(sum);
      });
      if (!is_zero)
        return false;
    }
    return true;
  }

  void divide(Spline_term& term, std::size_t axis, std::size_t cell) const
  {
    visit_rows(term.pieces[cell], term.degrees, axis, [&](Exact_rational* a, std::size_t step) {
      Exact_rational quotient(0);
      for (int k = term.degrees[axis]; k >= 0; --k) {
        const Exact_rational coefficient = std::exchange(a[static_cast<std::size_t>(k) * step], quotient);
        quotient = Exact_rational(coefficient + m_value * quotient);
      }
    });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_FACE_FACTOR_H
