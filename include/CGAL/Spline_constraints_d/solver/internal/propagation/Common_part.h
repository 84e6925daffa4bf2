// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_COMMON_PART_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_COMMON_PART_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Constraints of which many have most of their terms in common, as sums over all unknowns, say it in each of them again.
With one unknown more, v, that is equal to the common part, each of them is v and what is its own: two constraints know
through v what one knew of all unknowns.
*/
class Common_part
{
  std::vector<Polynomial_constraint> m_constraints;
  bool m_is_found = false;

public:
  // `check()` may end the work by an exception.
  Common_part(const std::vector<Polynomial_constraint>& constraints, int dimension, const std::function<void()>& check)
    : m_constraints(constraints)
  {
    const Power_polynomial common = majority(constraints, check);
    if (common.terms().size() < 2)
      return;
    const Power_polynomial name = Power_polynomial::variable(dimension);
    std::vector<Polynomial_constraint> shorter;
    std::size_t terms = common.terms().size() + 1, old_terms = 0;
    for (const auto& [polynomial, relation] : constraints) {
      check();
      Power_polynomial own = polynomial - common + name;
      const bool is_shorter = own.terms().size() < polynomial.terms().size();
      shorter.emplace_back(is_shorter ? std::move(own) : polynomial, relation);
      old_terms += polynomial.terms().size();
      terms += shorter.back().first.terms().size();
    }
    if (2 * terms > old_terms)
      return;
    shorter.emplace_back(common - name, Relation::EQUAL);
    m_constraints = std::move(shorter);
    m_is_found = true;
  }

  bool is_found() const { return m_is_found; }
  // With the new unknown, if there is one: then the last one says what it is.
  const std::vector<Polynomial_constraint>& constraints() const { return m_constraints; }

private:
  // The terms that most of the equalities have with one coefficient.
  static Power_polynomial majority(const std::vector<Polynomial_constraint>& constraints,
                                   const std::function<void()>& check)
  {
    std::map<Monomial, std::map<Exact_rational, std::size_t>> votes;
    std::size_t equalities = 0;
    for (const auto& [polynomial, relation] : constraints) {
      check();
      if (relation != Relation::EQUAL)
        continue;
      ++equalities;
      for (const auto& [monomial, coefficient] : polynomial.terms())
        if (!monomial.powers.empty())
          ++votes[monomial][coefficient];
    }
    Power_polynomial result;
    for (const auto& [monomial, coefficients] : votes)
      for (const auto& [coefficient, count] : coefficients)
        if (2 * count > equalities)
          result += polynomial_of_term(monomial, coefficient);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_COMMON_PART_H
