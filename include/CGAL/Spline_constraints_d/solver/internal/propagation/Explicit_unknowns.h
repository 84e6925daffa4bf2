// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_EXPLICIT_UNKNOWNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_EXPLICIT_UNKNOWNS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Unknowns that one equality gives as a function of another unknown, or as a multiple of a product, and that occur
linearly in all other constraints: y = p(x). They are replaced there, which makes no more parts in one unknown and
products than before, where their ranges do not say more than the function. Half of the unknowns of systems that name
intermediate values go in this way.
*/
class Explicit_unknowns
{
  struct Definition
  {
    int unknown;
    std::size_t constraint;
    Power_polynomial value;
  };

  int m_all;
  std::vector<Polynomial_constraint> m_constraints;
  std::vector<int> m_kept;
  std::vector<Definition> m_definitions; // each in terms of unknowns that are kept or defined later
  std::optional<Sparse_system> m_values;

public:
  // `check()` may end the work by an exception.
  Explicit_unknowns(const Box_of_ranges& domain, const std::vector<Polynomial_constraint>& constraints,
                    const std::function<void()>& check)
    : m_all(static_cast<int>(domain.size())), m_constraints(constraints)
  {
    for (std::vector<Definition> found = find(domain, check); !found.empty(); found = find(domain, check))
      replace(std::move(found), check);
    number_kept_unknowns(check);
  }

  // What is left, in fewer unknowns.
  int dimension() const { return static_cast<int>(m_kept.size()); }
  const std::vector<Polynomial_constraint>& constraints() const { return m_constraints; }

  // A box without them.
  Box_of_ranges reduced(const Box_of_ranges& box) const
  {
    Box_of_ranges result;
    for (const int j : m_kept)
      result.push_back(box[j]);
    return result;
  }

  // A box with ranges that hold their values.
  Box_of_ranges expanded(const Box_of_ranges& box) const
  {
    Box_of_ranges result(m_all, Interval(0));
    for (std::size_t k = 0; k < m_kept.size(); ++k)
      result[m_kept[k]] = box[k];
    for (int k = static_cast<int>(m_definitions.size()) - 1; k >= 0; --k)
      result[m_definitions[k].unknown] = m_values->value(k, result);
    return result;
  }

private:
  std::vector<Definition> find(const Box_of_ranges& domain, const std::function<void()>& check) const;
  std::vector<char> linear_unknowns() const;
  void replace(std::vector<Definition> definitions, const std::function<void()>& check);
  void number_kept_unknowns(const std::function<void()>& check);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
// The unknown of a monomial that is nothing else, or -1.
inline int lone_unknown(const Monomial& monomial)
{
  return monomial.powers.size() == 1 && monomial.powers.begin()->second == 1 ? monomial.powers.begin()->first : -1;
}

// Whether it is a function of one unknown, or a multiple of one product.
inline bool is_simple(const Power_polynomial& polynomial)
{
  return polynomial.variables().size() == 1 || (polynomial.terms().size() == 1 && polynomial.variables().size() > 1);
}

// Those that occur in monomials alone.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<char> Explicit_unknowns::linear_unknowns() const
{
  std::vector<char> result(m_all, 1);
  for (const auto& [polynomial, relation] : m_constraints)
    for (const auto& [monomial, coefficient] : polynomial.terms())
      if (lone_unknown(monomial) < 0)
        for (const auto& [unknown, exponent] : monomial.powers)
          result[unknown] = 0;
  return result;
}

// Only those that one equality alone defines: what many equalities define holds them together. No unknown is in two of
// the definitions.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Explicit_unknowns::Definition>
Explicit_unknowns::find(const Box_of_ranges& domain, const std::function<void()>& check) const
{
  constexpr std::size_t most_terms = 16;
  const std::vector<char> is_linear = linear_unknowns();
  std::map<int, std::vector<Definition>> definitions;
  for (std::size_t i = 0; i < m_constraints.size(); ++i) {
    const auto& [polynomial, relation] = m_constraints[i];
    if (relation != Relation::EQUAL || polynomial.terms().size() > most_terms)
      continue;
    check();
    for (const auto& [monomial, coefficient] : polynomial.terms())
      if (const int y = lone_unknown(monomial); y >= 0 && is_linear[y] != 0) {
        Power_polynomial value = Power_polynomial::variable(y) - polynomial / Power_polynomial(coefficient);
        if (is_simple(value))
          definitions[y].push_back({y, i, std::move(value)});
      }
  }
  std::vector<Definition> result;
  std::vector<char> is_used(m_all, 0);
  for (auto& [y, found] : definitions) {
    Definition& definition = found.front();
    std::vector<int> unknowns = definition.value.variables();
    unknowns.push_back(y);
    if (found.size() > 1 || std::ranges::any_of(unknowns, [&](int j) { return is_used[j] != 0; }))
      continue;
    const Interval range = Sparse_system(m_all, {{definition.value, Relation::EQUAL}}, check).value(0, domain);
    if (!(range.inf() >= domain[y].inf() && range.sup() <= domain[y].sup()))
      continue;
    for (const int j : unknowns)
      is_used[j] = 1;
    result.push_back(std::move(definition));
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Explicit_unknowns::replace(std::vector<Definition> definitions,
                                                               const std::function<void()>& check)
{
  std::vector<const Definition*> definition_of(m_all, nullptr);
  std::vector<char> is_definition(m_constraints.size(), 0);
  for (const Definition& definition : definitions) {
    definition_of[definition.unknown] = &definition;
    is_definition[definition.constraint] = 1;
  }
  std::vector<Polynomial_constraint> others;
  for (std::size_t i = 0; i < m_constraints.size(); ++i) {
    if (is_definition[i] != 0)
      continue;
    check();
    Polynomial_constraint& constraint = others.emplace_back(std::move(m_constraints[i]));
    for (const int j : constraint.first.variables())
      if (definition_of[j] != nullptr)
        constraint.first = constraint.first.substituted(j, definition_of[j]->value);
  }
  m_constraints = std::move(others);
  std::ranges::move(definitions, std::back_inserter(m_definitions));
}

// All constraints are in terms of them alone.
CGAL_SPLINE_CONSTRAINTS_INLINE void Explicit_unknowns::number_kept_unknowns(const std::function<void()>& check)
{
  std::vector<char> is_kept(m_all, 1);
  std::vector<Polynomial_constraint> values;
  for (const Definition& definition : m_definitions) {
    is_kept[definition.unknown] = 0;
    values.emplace_back(definition.value, Relation::EQUAL);
  }
  for (int j = 0; j < m_all; ++j)
    if (is_kept[j] != 0)
      m_kept.push_back(j);
  if (m_definitions.empty())
    return;
  m_values.emplace(m_all, values, check);
  for (auto& [polynomial, relation] : m_constraints) {
    check();
    polynomial = renumbered(polynomial, m_kept);
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_EXPLICIT_UNKNOWNS_H
