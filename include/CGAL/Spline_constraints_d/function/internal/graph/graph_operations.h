// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_OPERATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_OPERATIONS_H

#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>
#include <CGAL/Spline_constraints_d/function/internal/expansion_limits.h>
#include <CGAL/Spline_constraints_d/function/internal/graph/Graph_store.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

CGAL_SPLINE_CONSTRAINTS_INLINE Graph_store::Graph_store(int unknowns) : m_unknowns(unknowns)
{
  if (unknowns < 1)
    throw Invalid_input("Expression_graph: " + std::to_string(unknowns) + " unknowns");
  for (int i = 0; i < unknowns; ++i)
    enter(Graph_operation::UNKNOWN, i, 0);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::enter(Graph_operation operation, int first, int second)
{
  const std::uint64_t key = (static_cast<std::uint64_t>(operation) << 60) | (static_cast<std::uint64_t>(first) << 30) |
      static_cast<std::uint64_t>(second);
  const auto [position, is_new] = m_index.try_emplace(key, size());
  if (is_new) {
    if (size() >= maximal_size)
      throw Invalid_input("Expression_graph: more than " + std::to_string(maximal_size) + " vertices");
    m_vertices.push_back({operation, first, second});
  }
  return position->second;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::constant(const Exact_rational& value)
{
  if (const auto position = m_index_of_constant.find(value); position != m_index_of_constant.end())
    return position->second;
  check_coefficient(value);
  m_constants.push_back(value);
  const int result = enter(Graph_operation::CONSTANT, static_cast<int>(m_constants.size()) - 1, 0);
  m_index_of_constant.emplace(value, result);
  return result;
}

// What follows simplifies as in the field of rational functions: 0 a is 0 wherever a is defined.

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::negation(int a)
{
  if (is_constant(a))
    return constant(-constant_at(a));
  return m_vertices[a].operation == Graph_operation::NEGATION ? m_vertices[a].first
                                                              : enter(Graph_operation::NEGATION, a, 0);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::sum(int a, int b)
{
  if (is_constant(a) && is_constant(b))
    return constant(constant_at(a) + constant_at(b));
  if (is_constant(a, 0) || is_constant(b, 0))
    return is_constant(a, 0) ? b : a;
  if (m_vertices[b].operation == Graph_operation::NEGATION)
    return difference(a, m_vertices[b].first);
  if (m_vertices[a].operation == Graph_operation::NEGATION)
    return difference(b, m_vertices[a].first);
  return enter(Graph_operation::SUM, (std::min)(a, b), (std::max)(a, b));
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::difference(int a, int b)
{
  if (is_constant(a) && is_constant(b))
    return constant(constant_at(a) - constant_at(b));
  if (a == b)
    return constant(0);
  if (is_constant(b, 0))
    return a;
  if (is_constant(a, 0))
    return negation(b);
  return enter(Graph_operation::DIFFERENCE, a, b);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::product(int a, int b)
{
  if (is_constant(a) && is_constant(b))
    return constant(constant_at(a) * constant_at(b));
  if (is_constant(b))
    std::swap(a, b);
  if (is_constant(a, 0))
    return a;
  if (is_constant(a, 1))
    return b;
  if (is_constant(a, -1))
    return negation(b);
  return enter(Graph_operation::PRODUCT, (std::min)(a, b), (std::max)(a, b));
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::quotient(int a, int b)
{
  if (is_constant(b, 0))
    throw Invalid_input("Expression_graph: division by zero");
  if (is_constant(b))
    return product(constant(Exact_rational(1) / constant_at(b)), a);
  if (a == b)
    return constant(1);
  return is_constant(a, 0) ? a : enter(Graph_operation::QUOTIENT, a, b);
}

// By repeated squaring, the powers on the way shared.
CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::power(int base, int exponent)
{
  if (exponent < 0)
    return quotient(constant(1), power(base, -exponent));
  if (exponent > maximal_degree)
    throw Invalid_input("Expression_graph: an exponent exceeds " + std::to_string(maximal_degree));
  int result = constant(1);
  for (int square = base; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0)
      result = product(result, square);
    if (exponent > 1)
      square = product(square, square);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::function(Graph_operation operation, int a)
{
  return enter(operation, a, 0);
}

// Polynomials in symbols as vertices.
class Formula_composition
{
  using Terms = std::vector<std::pair<Monomial, Exact_rational>>;

  Graph_store& m_store;
  const Symbol_table* m_symbols;
  std::span<const int> m_arguments;
  std::map<int, int> m_vertices; // of symbols

public:
  Formula_composition(Graph_store& store, const Symbol_table* symbols, std::span<const int> arguments,
                      const std::map<int, int>& vertices)
    : m_store(store), m_symbols(symbols), m_arguments(arguments), m_vertices(vertices)
  {}

  int operator()(const Power_polynomial& polynomial)
  {
    return horner({polynomial.terms().begin(), polynomial.terms().end()});
  }

private:
  // Again and again, what most terms have in common is factored out of them.
  int horner(Terms terms)
  {
    int result = m_store.constant(0);
    while (!terms.empty()) {
      std::map<int, std::size_t> occurrences;
      for (const auto& [monomial, coefficient] : terms)
        for (const auto& [symbol, exponent] : monomial.powers)
          ++occurrences[symbol];
      if (occurrences.empty())
        return m_store.sum(result, m_store.constant(terms[0].second));
      const int symbol = std::max_element(occurrences.begin(), occurrences.end(), [](const auto& a, const auto& b) {
                           return a.second < b.second;
                         })->first;
      Terms with, without;
      for (auto& term : terms)
        (term.first.exponent(symbol) > 0 ? with : without).push_back(std::move(term));
      int common = with[0].first.exponent(symbol);
      for (const auto& term : with)
        common = (std::min)(common, term.first.exponent(symbol));
      for (auto& [monomial, coefficient] : with)
        monomial = monomial.with_exponent(symbol, monomial.exponent(symbol) - common);
      const int power = m_store.power(vertex_of(symbol), common);
      result = m_store.sum(result, m_store.product(power, horner(std::move(with))));
      terms = std::move(without);
    }
    return result;
  }

  int vertex_of(int symbol)
  {
    if (const auto known = m_vertices.find(symbol); known != m_vertices.end())
      return known->second;
    if (m_symbols == nullptr || m_symbols->is_unknown(symbol)) {
      if (static_cast<std::size_t>(symbol) >= m_arguments.size())
        throw Invalid_input("Expression_graph: " + std::to_string(m_arguments.size()) +
                            " arguments for a formula in unknown " + std::to_string(symbol));
      return m_arguments[symbol];
    }
    const Symbol& entry = (*m_symbols)[symbol];
    if (entry.kind == Symbol::Kind::VALUE)
      return m_vertices[symbol] = vertex_of_value(entry);
    if (entry.kind != Symbol::Kind::FORMULA)
      throw Invalid_input(entry.kind == Symbol::Kind::SPLINE
                              ? "Expression_graph: a spline occurs in the formula, which is no rational function"
                              : "Expression_graph: an unknown without a range occurs in the formula");
    return m_vertices[symbol] = (*this)(entry.formula);
  }

  int vertex_of_value(const Symbol& value)
  {
    const int argument = (*this)(value.formula);
    switch (value.function) {
    case Elementary_function::RECIPROCAL:
      return m_store.quotient(m_store.constant(1), argument);
    case Elementary_function::SQUARE_ROOT:
      return m_store.function(Graph_operation::SQUARE_ROOT, argument);
    case Elementary_function::EXPONENTIAL:
      return m_store.function(Graph_operation::EXPONENTIAL, argument);
    case Elementary_function::LOGARITHM:
      return m_store.function(Graph_operation::LOGARITHM, argument);
    case Elementary_function::SINE:
      return m_store.function(Graph_operation::SINE, argument);
    case Elementary_function::COSINE:
      return m_store.function(Graph_operation::COSINE, argument);
    case Elementary_function::TANGENT:
      return m_store.function(Graph_operation::TANGENT, argument);
    case Elementary_function::ARC_TANGENT:
      return m_store.function(Graph_operation::ARC_TANGENT, argument);
    default:
      throw Invalid_input("Expression_graph: " + in_words(value.function) + " occurs in the formula");
    }
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::composition(const Power_polynomial& polynomial,
                                                            const Symbol_table* symbols, std::span<const int> arguments,
                                                            const std::map<int, int>& symbols_with_vertex)
{
  return Formula_composition(*this, symbols, arguments, symbols_with_vertex)(polynomial);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<int> Graph_store::needed_by(std::span<const int> roots) const
{
  const int end = roots.empty() ? 0 : 1 + *std::max_element(roots.begin(), roots.end());
  std::vector<bool> is_needed(end, false);
  for (const int root : roots)
    is_needed[root] = true;
  for (int v = end; v-- > 0;)
    if (is_needed[v] && !m_vertices[v].is_leaf()) {
      is_needed[m_vertices[v].first] = true;
      if (m_vertices[v].is_binary())
        is_needed[m_vertices[v].second] = true;
    }
  std::vector<int> result;
  for (int v = 0; v < end; ++v)
    if (is_needed[v])
      result.push_back(v);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Operation_count Graph_store::operations(std::span<const int> roots) const
{
  Operation_count result;
  for (const int v : needed_by(roots))
    count_operation(result, m_vertices[v].operation);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t Graph_store::memory() const
{
  constexpr std::size_t links = 4 * sizeof(void*); // of a node of a tree, or of a hash table with its bucket
  return m_vertices.capacity() * sizeof(Graph_vertex) +
      m_constants.size() * (2 * sizeof(Exact_rational) + sizeof(int) + links) +
      m_index.size() * (sizeof(std::pair<std::uint64_t, int>) + links);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_OPERATIONS_H
