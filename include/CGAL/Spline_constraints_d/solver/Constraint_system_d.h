// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONSTRAINT_SYSTEM_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONSTRAINT_SYSTEM_D_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

A system of equalities and inequalities between multivariate splines and zero, on a box: what the solver solves.

The system owns its functions and holds them exactly, whatever number type the solver will compute with: doubles are
exact numbers, and rationals stay exact.
*/
class Constraint_system_d
{
public:
  //! the closed range of one unknown.
  using Domain = std::pair<Exact_rational, Exact_rational>;

  //! an inequality `function relation 0`.
  struct Inequality
  {
    Spline_function function;
    Relation relation;
  };

private:
  std::vector<Domain> m_domain;
  std::vector<Spline_function> m_equalities;
  std::vector<Inequality> m_inequalities;

public:
  //! a system without constraints on the box that is the product of the given ranges.
  //! \throws Invalid_input when there is no unknown, or a range is empty (the message names its index).
  explicit Constraint_system_d(std::vector<Domain> domain);

  //! the same with bounds given as doubles.
  //! \throws Invalid_input also when a bound is not a finite number.
  static Constraint_system_d on_box(const std::vector<std::pair<double, double>>& domain);

  //! adds the constraint `function relation 0`. A `Power_polynomial` converts to a `Spline_function`.
  //! \throws Invalid_input when the function uses an unknown that the system does not have, or is not defined on the
  //! whole domain.
  void add(Spline_function function, Relation relation);

  /*!
  adds a constraint written as a formula, and its conditions, those that the system does not have yet: a zero of what a
  formula is divided by is no solution of it.
  \param constraint the formula and its relation to zero.
  \param check as of `Constraint::spline_function()`.
  \throws Invalid_input as the other function, as `Constraint::spline_function()`, and when an unknown has a larger
  domain in the system than its range in the formula, which proofs about divisors rely on.
  */
  void add(const Constraint& constraint, const std::function<void()>& check = {});

  //! number of unknowns.
  int dimension() const { return static_cast<int>(m_domain.size()); }

  //! the range of an unknown.
  const Domain& domain(int unknown) const { return m_domain[unknown]; }

  //! the functions that are to vanish.
  const std::vector<Spline_function>& equalities() const { return m_equalities; }

  //! the inequalities.
  const std::vector<Inequality>& inequalities() const { return m_inequalities; }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Constraint_system_d::Constraint_system_d(std::vector<Domain> domain)
  : m_domain(std::move(domain))
{
  if (m_domain.empty())
    throw Invalid_input("Constraint_system_d: no unknowns");
  for (std::size_t i = 0; i < m_domain.size(); ++i)
    if (m_domain[i].second < m_domain[i].first)
      throw Invalid_input("Constraint_system_d: the domain of unknown " + std::to_string(i) + " is empty");
}

CGAL_SPLINE_CONSTRAINTS_INLINE Constraint_system_d
Constraint_system_d::on_box(const std::vector<std::pair<double, double>>& domain)
{
  std::vector<Domain> exact;
  for (std::size_t i = 0; i < domain.size(); ++i) {
    if (!std::isfinite(domain[i].first) || !std::isfinite(domain[i].second))
      throw Invalid_input("Constraint_system_d: the domain of unknown " + std::to_string(i) + " is not finite");
    exact.emplace_back(Exact_rational(domain[i].first), Exact_rational(domain[i].second));
  }
  return Constraint_system_d(std::move(exact));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Constraint_system_d::add(Spline_function function, Relation relation)
{
  for (const Spline_term& term : function.terms())
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      const int v = term.variables[j];
      const auto name = [&] { return "Constraint_system_d: unknown " + std::to_string(v); };
      if (v >= dimension())
        throw Invalid_input(name() + " of a constraint is not in the system");
      if (!term.breaks[j].empty() &&
          (domain(v).first < term.breaks[j].front() || term.breaks[j].back() < domain(v).second))
        throw Invalid_input(name() + " ranges beyond the domain of a spline");
    }
  if (relation == Relation::EQUAL)
    m_equalities.push_back(std::move(function));
  else
    m_inequalities.push_back({std::move(function), relation});
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Constraint_system_d::add(const Constraint& constraint,
                                                             const std::function<void()>& check)
{
  for (int i = 0; constraint.domains != nullptr && i < dimension() && i < static_cast<int>(constraint.domains->size());
       ++i)
    if (const Domain& range = (*constraint.domains)[i];
        domain(i).first < range.first || range.second < domain(i).second)
      throw Invalid_input("Constraint_system_d: unknown " + std::to_string(i) +
                          " of a formula ranges beyond its own range");
  add(constraint.spline_function(check), constraint.relation);
  for (Spline_function& condition : constraint.condition_functions(check)) {
    const auto is_condition = [&](const Inequality& known) {
      return known.relation == Relation::NOT_EQUAL && known.function.terms() == condition.terms();
    };
    if (std::none_of(m_inequalities.begin(), m_inequalities.end(), is_condition))
      add(std::move(condition), Relation::NOT_EQUAL);
  }
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONSTRAINT_SYSTEM_D_H
