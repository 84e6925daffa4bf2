// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_STORE_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_STORE_H

#include <CGAL/Spline_constraints_d/function/Operation_count.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

class Symbol_table;

enum class Graph_operation : std::uint8_t
{
  UNKNOWN,
  CONSTANT,
  NEGATION,
  SUM,
  DIFFERENCE,
  PRODUCT,
  QUOTIENT,
  SQUARE_ROOT,
  SINE,
  COSINE,
  TANGENT,
  EXPONENTIAL,
  LOGARITHM,
  ARC_TANGENT
};

// An operation and its operands; of an unknown its index, of a constant its place among the constants.
struct Graph_vertex
{
  Graph_operation operation;
  int first, second;

  bool is_leaf() const { return operation == Graph_operation::UNKNOWN || operation == Graph_operation::CONSTANT; }
  bool is_binary() const { return operation >= Graph_operation::SUM && operation <= Graph_operation::QUOTIENT; }
};

/*
The vertices of an expression graph. Each comes after its operands, so that the order of the indices is topological;
equal ones are there once (hash-consing), where operands of sums and products are in increasing order. Unknowns come
first. Definitions: graph_operations.h and graph_derivatives.h.
*/
class Graph_store
{
  int m_unknowns;
  std::vector<Graph_vertex> m_vertices;
  std::vector<Exact_rational> m_constants;
  std::map<Exact_rational, int> m_index_of_constant;
  std::unordered_map<std::uint64_t, int> m_index;

public:
  static constexpr int maximal_size = 1 << 28;

  explicit Graph_store(int unknowns);

  int number_of_unknowns() const { return m_unknowns; }
  int size() const { return static_cast<int>(m_vertices.size()); }
  const Graph_vertex& operator[](int vertex) const { return m_vertices[vertex]; }

  bool is_constant(int vertex) const { return m_vertices[vertex].operation == Graph_operation::CONSTANT; }
  bool is_constant(int vertex, int value) const { return is_constant(vertex) && constant_at(vertex) == value; }
  // \pre is_constant(vertex)
  const Exact_rational& constant_at(int vertex) const { return m_constants[m_vertices[vertex].first]; }

  int constant(const Exact_rational& value);
  int negation(int a);
  int sum(int a, int b);
  int difference(int a, int b);
  int product(int a, int b);
  int quotient(int a, int b);
  int power(int base, int exponent);
  int function(Graph_operation operation, int a);
  int function_derivative(int vertex, int by); // times that of its operand

  // A polynomial in the unknowns and symbols of a table, with vertices in place of unknowns, and of other symbols that
  // have one.
  int composition(const Power_polynomial& polynomial, const Symbol_table* symbols, std::span<const int> arguments,
                  const std::map<int, int>& symbols_with_vertex = {});

  // The partial derivatives by all unknowns (reverse), and the derivative along a direction (forward).
  std::vector<int> gradient(int vertex);
  int directional_derivative(int vertex, std::span<const int> direction);

  // Those that the roots need, themselves included, in increasing order.
  std::vector<int> needed_by(std::span<const int> roots) const;
  Operation_count operations(std::span<const int> roots) const;
  std::size_t memory() const;

private:
  int enter(Graph_operation operation, int first, int second);
  int derivative_of(int vertex, const std::vector<int>& of_operands);
  int one_plus_square(int a) { return sum(constant(1), product(a, a)); }
};

inline void count_operation(Operation_count& count, Graph_operation operation)
{
  switch (operation) {
  case Graph_operation::UNKNOWN:
  case Graph_operation::CONSTANT:
    break;
  case Graph_operation::NEGATION:
  case Graph_operation::SUM:
  case Graph_operation::DIFFERENCE:
    ++count.additions;
    break;
  case Graph_operation::PRODUCT:
  case Graph_operation::QUOTIENT:
    ++count.multiplications;
    break;
  case Graph_operation::SQUARE_ROOT:
  case Graph_operation::SINE:
  case Graph_operation::COSINE:
  case Graph_operation::TANGENT:
  case Graph_operation::EXPONENTIAL:
  case Graph_operation::LOGARITHM:
  case Graph_operation::ARC_TANGENT:
    ++count.functions;
    break;
  }
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_GRAPH_GRAPH_STORE_H
