// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CONSTRAINT_PROPAGATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CONSTRAINT_PROPAGATION_H

#include <CGAL/Spline_constraints_d/function/internal/elementary/inverse_ranges.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Narrows boxes by one constraint and one unknown after the other: seen as a polynomial in this unknown, with the others
in their ranges, it has no zeros where they are cut off. What has narrowed much wakes the other constraints with the
same unknown (propagation to a hull of Benhamou, Goualard, Granvilliers and Puget). A pass over a constraint takes time
in proportion to its terms. Of an elementary function, what is left for its values is carried back to the unknown.
*/
class Constraint_propagation
{
  // The product of a factor with an unknown, or with a function.
  struct Summand
  {
    Interval value, factor;
    int unknown; // or -1: none
    const Sparse_system::Elementary_part* function;
  };

  const Sparse_system& m_system;
  std::vector<char> m_is_awake;
  std::vector<int> m_queue;
  std::vector<Interval> m_values, m_term_values; // of the univariate parts, and of the terms, of the constraint in hand
  std::vector<Interval> m_elementary_values;     // of the elementary parts of the constraint in hand
  std::vector<Interval> m_arguments, m_function_values; // as they were last asked for
  std::vector<Summand> m_summands;                      // of the constraint in hand, where something is not bounded
  Univariate_interval_polynomial m_polynomial;

  static constexpr double woken_by = 0.9;   // when so much of a width is left
  static constexpr std::size_t passes = 20; // over each constraint, on the mean: the rest is left to splits

public:
  explicit Constraint_propagation(const Sparse_system& system)
    : m_system(system), m_is_awake(system.constraints(), 0),
      m_arguments(system.functions(), elementary::point(std::numeric_limits<double>::infinity())),
      m_function_values(system.functions())
  {}

  void wake_all()
  {
    for (int i = 0; i < m_system.constraints(); ++i)
      wake(i);
  }
  void wake_constraints_of(int unknown)
  {
    for (const int i : m_system.constraints_of(unknown))
      wake(i);
  }

  // Narrows the box by the constraints that are awake and those they wake; false when no solution is left.
  bool narrow(Box_of_ranges& box)
  {
    bool is_left = true;
    const std::size_t most = passes * m_system.constraints();
    for (std::size_t k = 0; k < m_queue.size(); ++k) {
      m_is_awake[m_queue[k]] = 0;
      is_left = is_left && (k >= most || narrow_by(m_queue[k], box));
    }
    m_queue.clear();
    return is_left;
  }

private:
  void wake(int constraint)
  {
    if (m_is_awake[constraint] == 0) {
      m_is_awake[constraint] = 1;
      m_queue.push_back(constraint);
    }
  }

  Interval part_value(const Sparse_system::Univariate_part& part, const Box_of_ranges& box)
  {
    const auto coefficients = m_system.coefficients(part);
    m_polynomial.reset(part.degree);
    for (int e = 1; e <= part.degree; ++e)
      m_polynomial[e] = coefficients[e - 1];
    return m_polynomial.range(box[part.unknown]);
  }

  Interval term_value(const Sparse_system::Mixed_term& term, const Box_of_ranges& box) const
  {
    return term.coefficient * m_system.product(term.monomial, box);
  }

  Interval elementary_value(const Sparse_system::Elementary_part& part, const Box_of_ranges& box);
  void wake_others(int unknown, int constraint)
  {
    for (const int other : m_system.constraints_of(unknown))
      if (other != constraint)
        wake(other);
  }

  bool narrow_by(int constraint, Box_of_ranges& box);
  bool narrow_by_elementary_parts(int constraint, Interval total, Box_of_ranges& box);
  bool narrow_unbounded(int constraint, Box_of_ranges& box);
  bool is_bounded(int constraint, const Box_of_ranges& box);
  bool narrow_range(int unknown, const Interval& to, int constraint, Box_of_ranges& box);
  bool narrow_argument(const Sparse_system::Elementary_part& part, const Interval& values, int constraint,
                       Box_of_ranges& box);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Interval
Constraint_propagation::elementary_value(const Sparse_system::Elementary_part& part, const Box_of_ranges& box)
{
  const Elementary_term& function = m_system.function(part.function);
  const Interval argument = function.argument(box);
  Interval& known_argument = m_arguments[part.function];
  if (!(argument.inf() == known_argument.inf() && argument.sup() == known_argument.sup())) {
    m_function_values[part.function] = elementary::range_of_values(function.operation, argument);
    known_argument = argument;
  }
  return part.coefficient * m_function_values[part.function];
}

// Narrows the unknown of a function to where it is defined and has some of the values.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::narrow_argument(const Sparse_system::Elementary_part& part,
                                                                            const Interval& values, int constraint,
                                                                            Box_of_ranges& box)
{
  const Elementary_term& function = m_system.function(part.function);
  Interval argument = function.argument(box);
  if (!elementary::narrow_argument(function.operation, values, argument))
    return false;
  const Interval solved = (argument - function.shift) / function.scale;
  return narrow_range(function.unknown, solved, constraint, box);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::narrow_range(int unknown, const Interval& to,
                                                                         int constraint, Box_of_ranges& box)
{
  Interval& range = box[unknown];
  if (to.inf() > range.sup() || to.sup() < range.inf())
    return false;
  const Interval narrowed = common_part(to, range);
  if (!(narrowed.inf() > range.inf() || narrowed.sup() < range.sup()))
    return true;
  const bool has_narrowed_much = !is_finite(range) || width(narrowed) < woken_by * width(range);
  range = narrowed;
  if (has_narrowed_much)
    wake_others(unknown, constraint);
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::narrow_by_elementary_parts(int constraint, Interval total,
                                                                                       Box_of_ranges& box)
{
  const auto parts = m_system.elementary_parts(constraint);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Interval rest = without_summand(total, m_elementary_values[k]);
    if (!narrow_argument(parts[k], -rest / parts[k].coefficient, constraint, box))
      return false;
    total = rest + (m_elementary_values[k] = elementary_value(parts[k], box));
  }
  return true;
}

// Sums of infinite ranges say nothing of their summands.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::is_bounded(int constraint, const Box_of_ranges& box)
{
  for (const auto& part : m_system.elementary_parts(constraint))
    if (!is_finite(elementary_value(part, box)) || !is_finite(box[m_system.function(part.function).unknown]))
      return false;
  for (const auto& occurrence : m_system.occurrences(constraint))
    if (!is_finite(box[occurrence.unknown]))
      return false;
  return true;
}

/*
Each summand is what the others leave: this bounds an unknown that it is linear in, with a factor that is not zero, or
the argument of a function. Sums of lower ends, and of upper ones, are never differences of infinities.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::narrow_unbounded(int constraint, Box_of_ranges& box)
{
  m_summands.clear();
  for (const auto& part : m_system.elementary_parts(constraint))
    m_summands.push_back({elementary_value(part, box), part.coefficient, -1, &part});
  for (const auto& part : m_system.parts(constraint)) {
    const auto coefficients = m_system.coefficients(part);
    Interval value(0);
    for (int e = 1; e <= part.degree; ++e)
      value += extended_product(coefficients[e - 1], extended_power(box[part.unknown], e));
    m_summands.push_back({value, coefficients[0], part.degree == 1 ? part.unknown : -1, nullptr});
  }
  for (const auto& term : m_system.terms(constraint)) {
    Summand summand{term.coefficient, term.coefficient, -1, nullptr};
    int unbounded = 0;
    for (std::size_t f = m_system.first_factor(term.monomial); f < m_system.last_factor(term.monomial); ++f) {
      const auto [own, exponent] = m_system.factor(f);
      const Interval factor = extended_power(box[own], exponent);
      summand.value = extended_product(summand.value, factor);
      if (is_finite(box[own]))
        summand.factor = extended_product(summand.factor, factor);
      else {
        summand.unknown = exponent == 1 ? own : -1;
        ++unbounded;
      }
    }
    if (unbounded != 1)
      summand.unknown = -1;
    m_summands.push_back(summand);
  }
  for (Summand& summand : m_summands)
    if (std::isnan(summand.value.inf()) || std::isnan(summand.value.sup()) || !is_finite(summand.factor)) {
      summand.value = elementary::entire_line();
      summand.unknown = -1;
    }
  for (const Summand& summand : m_summands) {
    Interval others = m_system.constant(constraint) + m_system.slack(constraint);
    for (const Summand& other : m_summands)
      if (&other != &summand)
        others += other.value;
    if (const Interval total = others + summand.value; total.inf() > 0 || total.sup() < 0)
      return false;
    if (summand.function != nullptr && !narrow_argument(*summand.function, -others / summand.factor, constraint, box))
      return false;
    if (summand.unknown >= 0 && !has_zero(summand.factor) &&
        !narrow_range(summand.unknown, -others / summand.factor, constraint, box))
      return false;
  }
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::narrow_by(int constraint, Box_of_ranges& box)
{
  const auto elementary_parts = m_system.elementary_parts(constraint);
  if (!m_system.is_polynomial() && !is_bounded(constraint, box))
    return narrow_unbounded(constraint, box);
  const auto parts = m_system.parts(constraint);
  const auto terms = m_system.terms(constraint);
  Interval total = m_system.constant(constraint) + m_system.slack(constraint);
  m_values.clear();
  m_term_values.clear();
  for (const auto& part : parts)
    total += m_values.emplace_back(part_value(part, box));
  for (const auto& term : terms)
    total += m_term_values.emplace_back(term_value(term, box));
  m_elementary_values.clear();
  for (const auto& part : elementary_parts)
    total += m_elementary_values.emplace_back(elementary_value(part, box));
  if (total.inf() > 0 || total.sup() < 0)
    return false;
  for (const auto& occurrence : m_system.occurrences(constraint)) {
    Interval& range = box[occurrence.unknown];
    if (range.inf() == range.sup())
      continue;
    Interval rest = total;
    if (occurrence.part >= 0)
      rest = without_summand(rest, m_values[occurrence.part]);
    for (const auto& place : m_system.places(occurrence))
      rest = without_summand(rest, m_term_values[place.term]);
    m_system.set_polynomial_in(occurrence, constraint, box, m_polynomial);
    m_polynomial[0] = rest;
    Interval narrowed = range;
    if (!m_polynomial.cut(narrowed))
      return false;
    if (!(width(narrowed) < width(range)))
      continue;
    const bool has_narrowed_much = width(narrowed) < woken_by * width(range);
    range = narrowed;
    total = rest;
    if (occurrence.part >= 0)
      total += m_values[occurrence.part] = part_value(parts[occurrence.part], box);
    for (const auto& place : m_system.places(occurrence))
      total += m_term_values[place.term] = term_value(terms[place.term], box);
    if (has_narrowed_much)
      wake_others(occurrence.unknown, constraint);
  }
  return narrow_by_elementary_parts(constraint, total, box);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CONSTRAINT_PROPAGATION_H
