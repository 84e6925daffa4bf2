// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CONSTRAINT_PROPAGATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CONSTRAINT_PROPAGATION_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Narrows boxes by one constraint and one unknown after the other: seen as a polynomial in this unknown, with the others
in their ranges, it has no zeros where they are cut off. What has narrowed much wakes the other constraints with the
same unknown (propagation to a hull of Benhamou, Goualard, Granvilliers and Puget). A pass over a constraint takes time
in proportion to its terms.
*/
class Constraint_propagation
{
  const Sparse_system& m_system;
  std::vector<char> m_is_awake;
  std::vector<int> m_queue;
  std::vector<Interval> m_values, m_term_values; // of the univariate parts, and of the terms, of the constraint in hand
  Univariate_interval_polynomial m_polynomial;

  static constexpr double woken_by = 0.9;   // when so much of a width is left
  static constexpr std::size_t passes = 20; // over each constraint, on the mean: the rest is left to splits

public:
  explicit Constraint_propagation(const Sparse_system& system) : m_system(system), m_is_awake(system.constraints(), 0)
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

  bool narrow_by(int constraint, Box_of_ranges& box);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool Constraint_propagation::narrow_by(int constraint, Box_of_ranges& box)
{
  const auto parts = m_system.parts(constraint);
  const auto terms = m_system.terms(constraint);
  Interval total = m_system.constant(constraint) + m_system.slack(constraint);
  m_values.clear();
  m_term_values.clear();
  for (const auto& part : parts)
    total += m_values.emplace_back(part_value(part, box));
  for (const auto& term : terms)
    total += m_term_values.emplace_back(term_value(term, box));
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
      for (const int other : m_system.constraints_of(occurrence.unknown))
        if (other != constraint)
          wake(other);
  }
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CONSTRAINT_PROPAGATION_H
