// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_REDUCED_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_REDUCED_SYSTEM_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Linear_combinations.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A function of a system, and what it is as a polynomial when it has no breaks.
struct Reducible_function
{
  Spline_function function;
  std::optional<Power_polynomial> polynomial;
  Relation relation;
  double cost = 0; // coefficients
  bool is_changed = false;

  Reducible_function(Spline_function f, std::size_t dimension, Relation r) : function(std::move(f)), relation(r)
  {
    double size = 0;
    for (const Spline_term& term : function.terms())
      for (const auto& piece : term.pieces)
        size += static_cast<double>(piece.size());
    cost = size;
    if (size > most_coefficients)
      return;
    polynomial = restricted(function, Partial_point(dimension));
    if (polynomial)
      cost = number_of_coefficients(*polynomial);
  }

  Reducible_function(Power_polynomial p, Relation r)
    : polynomial(std::move(p)), relation(r), cost(number_of_coefficients(*polynomial)), is_changed(true)
  {}

  static constexpr double most_coefficients = 2000; // of a polynomial that is looked at

  std::vector<int> unknowns() const
  {
    if (polynomial)
      return polynomial->variables();
    std::vector<int> result;
    for (const Spline_term& term : function.terms())
      result.insert(result.end(), term.variables.begin(), term.variables.end());
    return result;
  }

  Spline_function take_function() { return is_changed ? Spline_function(*polynomial) : std::move(function); }
};

/*
Rewrites the equalities of a system by linear combinations, and eliminates unknowns by equalities of degree one, as long
as this lowers the number of coefficients. Neither changes the ring of functions modulo the equalities: solutions stay
regular, isolated, and of their multiplicities.
*/
class Reduced_system
{
  using Domain = Constraint_system_d::Domain;

  // An equality of degree one with the unknown that it is solved for.
  struct Pivot
  {
    std::size_t equality;
    int unknown;
    double gain, terms, steepness;

    // More is gained; else fewer terms are made; else errors grow less.
    bool is_better_than(const Pivot& other) const
    {
      return std::tuple(-gain, terms, steepness) < std::tuple(-other.gain, other.terms, other.steepness);
    }
  };

  static constexpr double most_products = 500, most_products_in_all = 100000; // of terms

  static constexpr double most_new_coefficients = 100; // for one unknown less, of curves and surfaces

  std::function<void()> m_check;
  std::size_t m_freedom; // unknowns that the equalities leave
  double m_products_left = most_products_in_all;
  std::vector<Domain> m_domain;
  std::vector<Reducible_function> m_equalities, m_inequalities;
  std::vector<Eliminated_unknown> m_eliminated;
  std::vector<bool> m_is_eliminated;
  bool m_is_impossible = false, m_is_dependent = false, m_is_changed = false;

public:
  // `check` as of decomposition_of(), `freedom` as of elimination_of().
  Reduced_system(const Constraint_system_d& system, const std::function<void()>& check, std::size_t freedom = 0)
    : m_check(check ? check : [] {}), m_freedom(freedom)
  {
    const auto n = static_cast<std::size_t>(system.dimension());
    m_is_eliminated.assign(n, false);
    m_check();
    for (std::size_t j = 0; j < n; ++j)
      m_domain.push_back(system.domain(static_cast<int>(j)));
    for (const Spline_function& function : system.equalities())
      m_equalities.emplace_back(function, n, Relation::EQUAL);
    for (const auto& [function, relation] : system.inequalities())
      m_inequalities.emplace_back(function, n, relation);
  }

  void reduce()
  {
    for (bool goes_on = true; goes_on && !m_is_impossible && !m_is_dependent;) {
      m_check();
      combine();
      drop_constants();
      goes_on = false;
      while (!m_is_impossible && !m_is_dependent && eliminate_one())
        goes_on = true;
    }
  }

  // It is proved to have no solutions.
  bool is_impossible() const { return m_is_impossible; }

  // Equalities depend on others, so that what is left has too few of them: nothing is gained.
  bool is_dependent() const { return m_is_dependent; }

  bool is_changed() const { return m_is_changed; }
  const Domain& domain(int unknown) const { return m_domain[unknown]; }
  bool is_eliminated(int unknown) const { return m_is_eliminated[unknown]; }
  std::vector<Reducible_function>& equalities() { return m_equalities; }
  std::vector<Reducible_function>& inequalities() { return m_inequalities; }
  std::vector<Eliminated_unknown>& eliminated() { return m_eliminated; }

private:
  std::size_t unknowns_left() const { return m_is_eliminated.size() - m_eliminated.size(); }

  void combine()
  {
    std::vector<Power_polynomial> polynomials;
    for (const Reducible_function& equality : m_equalities)
      if (equality.polynomial)
        polynomials.push_back(*equality.polynomial);
    if (polynomials.size() < 2)
      return;
    auto combinations = Linear_combinations(polynomials, m_check).cheapest();
    if (!combinations)
      return;
    m_is_changed = true;
    std::erase_if(m_equalities, [](const Reducible_function& equality) { return equality.polynomial.has_value(); });
    for (Power_polynomial& polynomial : *combinations)
      m_equalities.emplace_back(std::move(polynomial), Relation::EQUAL);
  }

  void drop_constants()
  {
    const auto is_constant = [](const Reducible_function& f) { return f.polynomial && f.polynomial->is_constant(); };
    for (auto* functions : {&m_equalities, &m_inequalities})
      for (const Reducible_function& f : *functions)
        if (is_constant(f) && !is_satisfied(f.relation, CGAL::sign(f.polynomial->constant_term())))
          m_is_impossible = true;
    if (std::erase_if(m_equalities, is_constant) + std::erase_if(m_inequalities, is_constant) > 0)
      m_is_changed = true;
    m_is_dependent = m_equalities.size() + m_freedom < unknowns_left();
  }

  bool eliminate_one()
  {
    if (unknowns_left() < m_freedom + 2)
      return false;
    std::optional<Pivot> best;
    for (std::size_t i = 0; i < m_equalities.size(); ++i)
      if (m_equalities[i].polynomial && m_equalities[i].polynomial->total_degree() == 1)
        for (const int unknown : m_equalities[i].polynomial->variables())
          if (const std::optional<Pivot> pivot = pivot_of(i, unknown); pivot && (!best || pivot->is_better_than(*best)))
            best = pivot;
    if (!best)
      return false;
    eliminate(*best);
    return true;
  }

  // What elimination of an unknown by an equality gains, unless that cannot be done, makes more coefficients, or takes
  // too long to be told.
  std::optional<Pivot> pivot_of(std::size_t equality, int unknown)
  {
    m_check();
    const Power_polynomial value = value_of(equality, unknown);
    if (value.variables().size() == 1 && !is_proper(range_that_keeps(unknown, value)))
      return std::nullopt;
    double terms = 0,
           gain = m_equalities[equality].cost - number_of_bounds(unknown, value) * number_of_coefficients(value);
    const auto add = [&](const Reducible_function& f) {
      if (!f.polynomial) {
        const std::vector<int> unknowns = f.unknowns();
        return std::find(unknowns.begin(), unknowns.end(), unknown) == unknowns.end();
      }
      const int degree = f.polynomial->degree(unknown);
      if (degree == 0)
        return true;
      const double products = std::pow(value.terms().size(), degree) * f.polynomial->terms().size();
      if (products > most_products || products > m_products_left)
        return false;
      m_products_left -= products;
      const Power_polynomial substituted = f.polynomial->substituted(unknown, value);
      gain += f.cost - number_of_coefficients(substituted);
      terms += static_cast<double>(substituted.terms().size()) - static_cast<double>(f.polynomial->terms().size());
      return true;
    };
    for (std::size_t i = 0; i < m_equalities.size(); ++i)
      if (i != equality && !add(m_equalities[i]))
        return std::nullopt;
    const double least_gain = m_freedom > 0 ? -most_new_coefficients : 0;
    if (gain < least_gain || !std::all_of(m_inequalities.begin(), m_inequalities.end(), add) || gain < least_gain)
      return std::nullopt;
    double steepness = 0;
    for (const auto& [monomial, coefficient] : value.terms())
      if (!monomial.powers.empty())
        steepness = (std::max)(steepness, std::abs(CGAL::to_double(coefficient)));
    return Pivot{equality, unknown, gain, terms, steepness};
  }

  Power_polynomial value_of(std::size_t equality, int unknown) const
  {
    const Power_polynomial& polynomial = *m_equalities[equality].polynomial;
    const Exact_rational slope = polynomial.terms().find(Monomial{{{unknown, 1}}})->second;
    return polynomial.substituted(unknown, Power_polynomial()) / Power_polynomial(Exact_rational(-slope));
  }

  void eliminate(const Pivot& pivot)
  {
    const Power_polynomial value = value_of(pivot.equality, pivot.unknown);
    m_equalities.erase(m_equalities.begin() + static_cast<std::ptrdiff_t>(pivot.equality));
    for (auto* functions : {&m_equalities, &m_inequalities})
      for (Reducible_function& f : *functions)
        if (f.polynomial && f.polynomial->degree(pivot.unknown) > 0)
          f = Reducible_function(f.polynomial->substituted(pivot.unknown, value), f.relation);
    keep_in_domain(pivot.unknown, value);
    m_is_changed = m_is_eliminated[pivot.unknown] = true;
    for (Eliminated_unknown& other : m_eliminated)
      other = affine(other.unknown, polynomial_of(other).substituted(pivot.unknown, value));
    m_eliminated.push_back(affine(pivot.unknown, value));
    drop_constants();
  }

  static Eliminated_unknown affine(int unknown, const Power_polynomial& value)
  {
    Eliminated_unknown result{unknown, value.constant_term(), {}};
    for (const auto& [monomial, coefficient] : value.terms())
      if (!monomial.powers.empty())
        result.slopes.emplace_back(monomial.powers[0].first, coefficient);
    return result;
  }

  static Power_polynomial polynomial_of(const Eliminated_unknown& eliminated)
  {
    Power_polynomial result(eliminated.constant);
    for (const auto& [unknown, slope] : eliminated.slopes)
      result += Power_polynomial(slope) * Power_polynomial::variable(unknown);
    return result;
  }

  // The range of a value of degree one.
  Domain range_of(const Power_polynomial& value) const
  {
    Domain result(Exact_rational(0), Exact_rational(0));
    for (const auto& [monomial, coefficient] : value.terms()) {
      Exact_rational ends[] = {coefficient, coefficient};
      if (!monomial.powers.empty()) {
        const Domain& domain = m_domain[monomial.powers[0].first];
        ends[0] *= domain.first;
        ends[1] *= domain.second;
      }
      result.first += (std::min)(ends[0], ends[1]);
      result.second += (std::max)(ends[0], ends[1]);
    }
    return result;
  }

  // Of the one unknown of a value, where the value lies in the domain of the unknown that it takes the place of.
  Domain range_that_keeps(int unknown, const Power_polynomial& value) const
  {
    const int other = value.variables()[0];
    const Exact_rational constant = value.constant_term(), slope = value.terms().rbegin()->second;
    Exact_rational ends[] = {(m_domain[unknown].first - constant) / slope,
                             (m_domain[unknown].second - constant) / slope};
    if (ends[1] < ends[0])
      std::swap(ends[0], ends[1]);
    return {(std::max)(ends[0], m_domain[other].first), (std::min)(ends[1], m_domain[other].second)};
  }

  // Empty is welcome, a single number is not: a domain is to have some width.
  static bool is_proper(const Domain& range) { return range.first != range.second; }

  // How many inequalities keep the value in the domain of the unknown.
  int number_of_bounds(int unknown, const Power_polynomial& value) const
  {
    if (value.variables().size() < 2 || m_freedom > 0)
      return 0;
    const Domain range = range_of(value);
    return (range.first < m_domain[unknown].first ? 1 : 0) + (m_domain[unknown].second < range.second ? 1 : 0);
  }

  void keep_in_domain(int unknown, const Power_polynomial& value)
  {
    const Domain range = range_of(value), &domain = m_domain[unknown];
    if (domain.second < range.first || range.second < domain.first) {
      m_is_impossible = true;
      return;
    }
    if (value.variables().size() == 1) {
      m_domain[value.variables()[0]] = range_that_keeps(unknown, value);
      return;
    }
    if (m_freedom > 0) // the answers are looked at
      return;
    if (range.first < domain.first)
      m_inequalities.emplace_back(value - Power_polynomial(domain.first), Relation::GREATER_EQUAL);
    if (domain.second < range.second)
      m_inequalities.emplace_back(value - Power_polynomial(domain.second), Relation::LESS_EQUAL);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_REDUCED_SYSTEM_H
