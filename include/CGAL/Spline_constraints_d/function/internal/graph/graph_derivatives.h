// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_DERIVATIVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_DERIVATIVES_H

#include <CGAL/Spline_constraints_d/function/internal/graph/Graph_store.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Sums of contributions to the derivatives of a function by the vertices that it needs, as vertices.
class Graph_adjoints
{
  Graph_store& m_store;
  std::vector<int> m_adjoints; // -1: zero

public:
  Graph_adjoints(Graph_store& store, int root) : m_store(store), m_adjoints(root + 1, -1)
  {
    m_adjoints[root] = m_store.constant(1);
  }

  bool is_zero(int vertex) const { return vertex >= static_cast<int>(m_adjoints.size()) || m_adjoints[vertex] < 0; }
  int operator[](int vertex) const { return m_adjoints[vertex]; }

  void add(int vertex, int contribution)
  {
    m_adjoints[vertex] = is_zero(vertex) ? contribution : m_store.sum(m_adjoints[vertex], contribution);
  }
  void subtract(int vertex, int contribution)
  {
    m_adjoints[vertex] =
        is_zero(vertex) ? m_store.negation(contribution) : m_store.difference(m_adjoints[vertex], contribution);
  }

  // What a vertex contributes to the derivatives by its operands: at most four operations, two of them multiplications.
  void propagate(int vertex)
  {
    const auto [operation, a, b] = m_store[vertex];
    const int own = m_adjoints[vertex];
    const auto varies = [&](int operand) { return !m_store.is_constant(operand); };
    switch (operation) {
    case Graph_operation::UNKNOWN:
    case Graph_operation::CONSTANT:
      break;
    case Graph_operation::NEGATION:
      subtract(a, own);
      break;
    case Graph_operation::SUM:
    case Graph_operation::DIFFERENCE:
      if (varies(a))
        add(a, own);
      if (varies(b))
        operation == Graph_operation::SUM ? add(b, own) : subtract(b, own);
      break;
    case Graph_operation::PRODUCT:
      if (varies(a))
        add(a, m_store.product(own, b));
      if (varies(b))
        add(b, m_store.product(own, a));
      break;
    case Graph_operation::QUOTIENT: {
      const int by_dividend = m_store.quotient(own, b);
      if (varies(a))
        add(a, by_dividend);
      subtract(b, m_store.product(by_dividend, vertex));
      break;
    }
    case Graph_operation::SQUARE_ROOT:
    case Graph_operation::SINE:
    case Graph_operation::COSINE:
    case Graph_operation::TANGENT:
    case Graph_operation::EXPONENTIAL:
    case Graph_operation::LOGARITHM:
    case Graph_operation::ARC_TANGENT:
      add(a, m_store.function_derivative(vertex, own));
      break;
    }
  }
};

// W. Baur and V. Strassen: from the function back to the unknowns, each vertex once.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<int> Graph_store::gradient(int vertex)
{
  Graph_adjoints adjoints(*this, vertex);
  const std::vector<int> needed = needed_by(std::span<const int>(&vertex, 1));
  for (auto v = needed.rbegin(); v != needed.rend(); ++v)
    if (!adjoints.is_zero(*v))
      adjoints.propagate(*v);
  std::vector<int> result;
  for (int i = 0; i < m_unknowns; ++i)
    result.push_back(adjoints.is_zero(i) ? constant(0) : adjoints[i]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::function_derivative(int vertex, int by)
{
  const auto [operation, a, unused] = m_vertices[vertex];
  switch (operation) {
  case Graph_operation::SQUARE_ROOT:
    return quotient(by, product(constant(2), vertex));
  case Graph_operation::SINE:
    return product(by, function(Graph_operation::COSINE, a));
  case Graph_operation::COSINE:
    return negation(product(by, function(Graph_operation::SINE, a)));
  case Graph_operation::TANGENT:
    return product(by, one_plus_square(vertex));
  case Graph_operation::EXPONENTIAL:
    return product(by, vertex);
  case Graph_operation::LOGARITHM:
    return quotient(by, a);
  default: // arc tangent
    return quotient(by, one_plus_square(a));
  }
}

// By the derivatives of the operands.
CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::derivative_of(int vertex, const std::vector<int>& of_operands)
{
  const auto [operation, a, b] = m_vertices[vertex];
  const int da = of_operands[a], db = m_vertices[vertex].is_binary() ? of_operands[b] : -1;
  switch (operation) {
  case Graph_operation::UNKNOWN:
  case Graph_operation::CONSTANT:
    break;
  case Graph_operation::NEGATION:
    return negation(da);
  case Graph_operation::SUM:
    return sum(da, db);
  case Graph_operation::DIFFERENCE:
    return difference(da, db);
  case Graph_operation::PRODUCT:
    return sum(product(da, b), product(a, db));
  case Graph_operation::QUOTIENT:
    return quotient(difference(da, product(vertex, db)), b);
  case Graph_operation::SQUARE_ROOT:
  case Graph_operation::SINE:
  case Graph_operation::COSINE:
  case Graph_operation::TANGENT:
  case Graph_operation::EXPONENTIAL:
  case Graph_operation::LOGARITHM:
  case Graph_operation::ARC_TANGENT:
    return function_derivative(vertex, da);
  }
  return constant(0);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Graph_store::directional_derivative(int vertex, std::span<const int> direction)
{
  std::vector<int> derivatives(vertex + 1, constant(0));
  for (const int v : needed_by(std::span<const int>(&vertex, 1)))
    if (m_vertices[v].operation == Graph_operation::UNKNOWN)
      derivatives[v] = direction[m_vertices[v].first];
    else if (!m_vertices[v].is_leaf())
      derivatives[v] = derivative_of(v, derivatives);
  return derivatives[vertex];
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_DERIVATIVES_H
