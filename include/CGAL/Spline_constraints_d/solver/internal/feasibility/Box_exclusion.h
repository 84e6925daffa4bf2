// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_BOX_EXCLUSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_BOX_EXCLUSION_H

#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_problem.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_run.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Drops boxes that hold no solution, and the parts of others along their faces, and records what it drops with the
multipliers that prove it. Each function returns whether nothing is left.
*/
class Box_exclusion
{
  const Feasibility_problem& m_problem;
  Polynomial_family<Interval>& m_enclosures;
  Feasibility_run& m_run;
  bool m_is_recorded;

public:
  Box_exclusion(const Feasibility_problem& problem, Polynomial_family<Interval>& enclosures, Feasibility_run& run,
                bool is_recorded)
    : m_problem(problem), m_enclosures(enclosures), m_run(run), m_is_recorded(is_recorded)
  {}

  // By single constraints; lists the inequalities that are not satisfied on all of what is left.
  bool by_constraints(Double_box& box, std::vector<std::size_t>& active)
  {
    active.clear();
    for (std::size_t i = 0; i < m_problem.size(); ++i) {
      if (m_problem[i].relation == Relation::NOT_EQUAL)
        continue;
      if (m_run.must_stop()) { // what was not looked at may be violated
        if (m_problem[i].is_inequality())
          active.push_back(i);
        continue;
      }
      const std::vector<Interval>& coefficients = m_enclosures.coefficients(i);
      std::vector<Interval> ranges;
      for (std::size_t j = 0; j < box.size(); ++j)
        ranges.emplace_back(box.lower[j], box.upper[j]);
      m_enclosures.set_point(ranges);
      const Interval value = m_enclosures.value(coefficients);
      const bool is_equality = m_problem[i].relation == Relation::EQUAL;
      std::vector<double> multipliers(m_problem.size(), 0.0);
      multipliers[i] = value.inf() > 0 || !is_equality ? 1 : -1;
      if (value.inf() > 0 || (m_problem[i].relation == Relation::LESS && value.inf() >= 0) ||
          (is_equality && value.sup() < 0))
        return exclude(box, multipliers);
      if (!is_equality) {
        if (value.sup() < 0 || (m_problem[i].relation == Relation::LESS_EQUAL && value.sup() <= 0))
          continue;
        active.push_back(i);
      }
      for (const double sign : {1.0, -1.0}) {
        if (sign < 0 && !is_equality)
          break;
        multipliers[i] = sign;
        if (by_combination(box, multipliers, box.middle()))
          return true;
      }
    }
    return false;
  }

  // By a combination, whose least point is guessed.
  bool by_combination(Double_box& box, const std::vector<double>& multipliers, const std::vector<double>& guess)
  {
    const Double_box before = box;
    const Convex_bound bound(m_enclosures, m_enclosures.combination(multipliers), before, guess);
    if (is_positive(bound, multipliers))
      return exclude(before, multipliers);
    Double_box after = box;
    if (!bound.contract(after))
      return exclude(before, multipliers);
    // Little is not worth the parts of the record.
    for (std::size_t j = 0; j < box.size(); ++j)
      if (after.upper[j] - after.lower[j] < 0.9 * (box.upper[j] - box.lower[j])) {
        exclude_between(box, j, after.lower[j], after.upper[j], multipliers);
        box.lower[j] = after.lower[j];
        box.upper[j] = after.upper[j];
      }
    return false;
  }

  // By a proof from elsewhere.
  template <class Multiplier>
  bool exclude(const Double_box& box, const std::vector<Multiplier>& multipliers)
  {
    if (m_is_recorded) {
      std::vector<Undecided_part::Range> place;
      for (std::size_t j = 0; j < box.size(); ++j)
        place.emplace_back(box.lower[j], box.upper[j]);
      m_run.exclude(std::move(place), {multipliers.begin(), multipliers.end()});
    }
    return true;
  }

private:
  bool is_positive(const Convex_bound& bound, const std::vector<double>& multipliers) const
  {
    const double lower = bound.lower();
    if (lower > 0)
      return true;
    bool is_strict = false;
    for (std::size_t i = 0; i < multipliers.size(); ++i)
      is_strict = is_strict || (m_problem[i].relation == Relation::LESS && multipliers[i] > 0);
    return is_strict && lower >= 0;
  }

  void exclude_between(const Double_box& box, std::size_t axis, double lower, double upper,
                       const std::vector<double>& multipliers)
  {
    Double_box part = box;
    if (box.lower[axis] < lower) {
      part.upper[axis] = lower;
      exclude(part, multipliers);
    }
    if (upper < box.upper[axis]) {
      part.lower[axis] = upper;
      part.upper[axis] = box.upper[axis];
      exclude(part, multipliers);
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_BOX_EXCLUSION_H
