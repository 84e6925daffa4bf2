// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_PROBLEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_PROBLEM_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A positive multiple, the same of all polynomials that are positive multiples of each other.
inline Power_polynomial with_unit_coefficient(const Power_polynomial& polynomial)
{
  if (polynomial.is_zero())
    return polynomial;
  return polynomial / Power_polynomial(Exact_rational(CGAL::abs(polynomial.terms().begin()->second)));
}

/*
Polynomials compared with zero on a box: by =, <=, < and !=, the others with their signs changed. An unknown whose range
is one number does not occur in them.
*/
class Feasibility_problem
{
public:
  struct Condition
  {
    Power_polynomial function;
    Relation relation;
    bool is_inequality() const { return relation == Relation::LESS || relation == Relation::LESS_EQUAL; }
  };

private:
  Exact_ranges m_domain;
  std::vector<Condition> m_conditions;

public:
  explicit Feasibility_problem(Exact_ranges domain) : m_domain(std::move(domain)) {}

  void add(Power_polynomial function, Relation relation)
  {
    for (int j = 0; j < dimension(); ++j)
      if (!is_free(j) && function.degree(j) > 0)
        function = function.substituted(j, Power_polynomial(m_domain[j].first));
    if (relation == Relation::GREATER || relation == Relation::GREATER_EQUAL)
      m_conditions.push_back(
          {-std::move(function), relation == Relation::GREATER ? Relation::LESS : Relation::LESS_EQUAL});
    else
      m_conditions.push_back({std::move(function), relation});
  }

  int dimension() const { return static_cast<int>(m_domain.size()); }
  const Exact_ranges& domain() const { return m_domain; }
  const std::vector<Condition>& conditions() const { return m_conditions; }
  std::size_t size() const { return m_conditions.size(); }
  const Condition& operator[](std::size_t i) const { return m_conditions[i]; }

  bool is_free(int unknown) const { return m_domain[unknown].first < m_domain[unknown].second; }
  std::vector<int> free_unknowns() const
  {
    std::vector<int> result;
    for (int j = 0; j < dimension(); ++j)
      if (is_free(j))
        result.push_back(j);
    return result;
  }

  std::size_t number_of_equalities() const
  {
    return std::count_if(m_conditions.begin(), m_conditions.end(),
                         [](const Condition& condition) { return condition.relation == Relation::EQUAL; });
  }

  std::vector<Power_polynomial> functions() const
  {
    std::vector<Power_polynomial> result;
    for (const Condition& condition : m_conditions)
      result.push_back(condition.function);
    return result;
  }

  // The same on another box. Inequalities that become multiples of each other there are one: as two they would have a
  // continuum of multipliers.
  Feasibility_problem on(const Exact_ranges& box) const
  {
    Feasibility_problem all(box), result(box);
    for (const Condition& condition : m_conditions)
      all.add(condition.function, condition.relation);
    std::vector<Power_polynomial> normal;
    for (const Condition& condition : all.m_conditions) {
      normal.push_back(with_unit_coefficient(condition.function));
      bool is_known = false;
      for (std::size_t k = 0; k < result.size() && !is_known; ++k) {
        Condition& other = result.m_conditions[k];
        is_known = condition.is_inequality() && other.is_inequality() && normal[k] == normal.back();
        if (is_known && condition.relation == Relation::LESS)
          other.relation = Relation::LESS;
      }
      if (is_known)
        normal.pop_back();
      else
        result.m_conditions.push_back(condition);
    }
    return result;
  }

  Feasibility_problem without_inequations() const
  {
    Feasibility_problem result(m_domain);
    for (const Condition& condition : m_conditions)
      if (condition.relation != Relation::NOT_EQUAL)
        result.m_conditions.push_back(condition);
    return result;
  }

  bool is_satisfied_at(const std::vector<Exact_rational>& point) const
  {
    return std::all_of(m_conditions.begin(), m_conditions.end(), [&](const Condition& condition) {
      return is_satisfied(condition.relation, CGAL::sign(condition.function(point)));
    });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_PROBLEM_H
