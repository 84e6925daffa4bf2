// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKED_FORMULAS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKED_FORMULAS_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Expression_graph.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Unknowns that were made together, and what they are in unknowns of domains before; the basic one has no formulas.
struct Linked_domain
{
  std::shared_ptr<Symbol_table> symbols;
  std::vector<Expression> formulas;
};

inline std::optional<std::size_t> index_of_domain(const std::vector<Linked_domain>& domains,
                                                  const Symbol_table* symbols)
{
  for (std::size_t i = 0; i < domains.size(); ++i)
    if (domains[i].symbols.get() == symbols)
      return i;
  return std::nullopt;
}

// A formula compared with zero by <, <= or !=.
struct Tracked_formula
{
  Expression_graph::Node function;
  Relation relation;
};

/*
The constraints of all domains in one graph, in the unknowns of the basic domain. Splines of the time are further
unknowns of the graph: at a time they are numbers.
*/
class Tracked_formulas
{
  struct Spline_of_time
  {
    std::shared_ptr<const Integer_spline> spline;
    std::size_t arguments; // each of them the time
  };

  using Node = Expression_graph::Node;

  std::size_t m_dimension;
  int m_time;
  Expression_graph m_graph;
  std::vector<Spline_of_time> m_splines;
  std::vector<std::vector<int>> m_coordinates;     // of each domain, as vertices
  std::vector<std::map<int, int>> m_known_symbols; // of each domain, as vertices
  std::vector<Tracked_formula> m_formulas;
  std::set<std::pair<int, Relation>> m_known;

public:
  Tracked_formulas(const std::vector<Linked_domain>& domains, int time,
                   std::span<const std::optional<Constraint>> constraints)
    : m_dimension(domains[0].symbols->domains().size()), m_time(time), m_graph(number_of_inputs(domains))
  {
    for (const Linked_domain& domain : domains)
      enter(domain, domains);
    for (const std::optional<Constraint>& constraint : constraints)
      if (constraint)
        enter(*constraint, *index_of_domain(domains, constraint->symbols.get()));
  }

  std::size_t dimension() const { return m_dimension; }
  int time() const { return m_time; }
  Expression_graph& graph() { return m_graph; }
  const std::vector<Tracked_formula>& formulas() const { return m_formulas; }

  // The values of all unknowns of the graph after those of the basic domain.
  std::vector<Exact_rational> splines_at(const Exact_rational& time) const
  {
    std::vector<Exact_rational> result(m_graph.number_of_unknowns() - m_dimension, Exact_rational(0));
    for (std::size_t k = 0; k < m_splines.size(); ++k)
      result[k] = (*m_splines[k].spline)(std::vector<Exact_rational>(m_splines[k].arguments, time));
    return result;
  }

private:
  // At most one for each spline.
  static int number_of_inputs(const std::vector<Linked_domain>& domains)
  {
    int result = static_cast<int>(domains[0].symbols->domains().size());
    for (const Linked_domain& domain : domains)
      for (int s = 0; s < domain.symbols->size(); ++s)
        result += (*domain.symbols)[s].kind == Symbol::Kind::SPLINE;
    return result;
  }

  void enter(const Linked_domain& domain, const std::vector<Linked_domain>& domains)
  {
    std::vector<int> coordinates;
    if (m_coordinates.empty())
      for (std::size_t i = 0; i < m_dimension; ++i)
        coordinates.push_back(static_cast<int>(i));
    for (const Expression& formula : domain.formulas) {
      const Symbol_table* symbols = formula.symbols().get();
      const std::size_t from = index_of_domain(domains, symbols).value_or(0); // of a constant, any
      coordinates.push_back(m_graph.store()->quotient(vertex_of(formula.numerator(), symbols, from),
                                                      vertex_of(polynomial_of(formula.denominator()), symbols, from)));
    }
    m_coordinates.push_back(coordinates);
    const Unknown_domains& ranges = domain.symbols->domains();
    const auto& [begin, end] = domains[0].symbols->domains()[m_time];
    std::vector<bool> is_time;
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      is_time.push_back(coordinates[i] == m_time && ranges[i].first <= begin && end <= ranges[i].second);
    enter_splines(*domain.symbols, is_time);
    // The ranges of linked unknowns are constraints.
    for (std::size_t i = 0; i < domain.formulas.size(); ++i)
      if (!is_time[i]) {
        const Node value(m_graph.store(), coordinates[i]);
        add(ranges[i].first - value, Relation::LESS_EQUAL);
        add(value - ranges[i].second, Relation::LESS_EQUAL);
      }
  }

  void enter_splines(const Symbol_table& symbols, const std::vector<bool>& is_time)
  {
    std::map<int, int>& known = m_known_symbols.emplace_back();
    for (int s = 0, size = symbols.size(); s < size; ++s) {
      const Symbol& symbol = symbols[s];
      if (symbol.kind != Symbol::Kind::SPLINE ||
          !std::all_of(symbol.unknowns.begin(), symbol.unknowns.end(), [&](int u) { return is_time[u]; }))
        continue;
      known[s] = static_cast<int>(m_dimension + m_splines.size());
      m_splines.push_back({symbol.spline, symbol.unknowns.size()});
    }
  }

  void enter(const Constraint& constraint, std::size_t domain)
  {
    const Node function(m_graph.store(), vertex_of(constraint.function, constraint.symbols.get(), domain));
    switch (constraint.relation) {
    case Relation::GREATER:
      add(-function, Relation::LESS);
      break;
    case Relation::GREATER_EQUAL:
      add(-function, Relation::LESS_EQUAL);
      break;
    default:
      add(function, constraint.relation);
      break;
    }
    for (const Power_polynomial& condition : constraint.conditions)
      add(Node(m_graph.store(), vertex_of(condition, constraint.symbols.get(), domain)), Relation::NOT_EQUAL);
  }

  // Once: domains that are linked in a chain repeat the ranges of unknowns that they pass on.
  void add(const Node& function, Relation relation)
  {
    if (m_known.emplace(function.index(), relation).second)
      m_formulas.push_back({function, relation});
  }

  int vertex_of(const Power_polynomial& polynomial, const Symbol_table* symbols, std::size_t domain)
  {
    if (symbols != nullptr)
      symbols->require_no_values(polynomial, "Constraint_tracker");
    return m_graph.store()->composition(polynomial, symbols, m_coordinates[domain], m_known_symbols[domain]);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKED_FORMULAS_H
