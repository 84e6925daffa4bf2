// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_GRAPH_EVALUATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_GRAPH_EVALUATION_H

#include <CGAL/Spline_constraints_d/function/Expression_graph.h>
#include <CGAL/Spline_constraints_d/function/Operation_count.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_double.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_exact.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_interval.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

// What formulas of a graph can be evaluated in: see doc/Spline_constraints_d/Concepts/GraphNumber.h.
template <class NT>
concept GraphNumber = std::copyable<NT> && requires(const NT& a, const NT& b)
{
  {
    a + b
    } -> std::convertible_to<NT>;
  {
    a - b
    } -> std::convertible_to<NT>;
  {
    a* b
    } -> std::convertible_to<NT>;
  {
    a / b
    } -> std::convertible_to<NT>;
  {
    -a
    } -> std::convertible_to<NT>;
} && !std::integral<NT>;

namespace internal {

template <class NT>
NT graph_constant(const Exact_rational& value)
{
  if constexpr (requires { Number_traits<NT>::from_rational(value); })
    return Number_traits<NT>::from_rational(value);
  else if constexpr (std::constructible_from<NT, const Exact_rational&>)
    return NT(value);
  else
    return NT(to_double_interval(value)); // CGAL::Interval_nt<true>
}

template <class NT>
NT graph_square(const NT& a)
{
  return a * a;
}
template <bool is_protected>
CGAL::Interval_nt<is_protected> graph_square(const CGAL::Interval_nt<is_protected>& a)
{
  return CGAL::square(a);
}

template <class NT>
NT graph_quotient(const NT& a, const NT& b)
{
  if constexpr (std::same_as<NT, Exact_rational>)
    if (b == 0)
      throw Invalid_input("Graph_evaluation: a divisor is zero at the point");
  return a / b;
}

inline Elementary_function function_of(Graph_operation operation)
{
  switch (operation) {
  case Graph_operation::SINE:
    return Elementary_function::SINE;
  case Graph_operation::COSINE:
    return Elementary_function::COSINE;
  case Graph_operation::TANGENT:
    return Elementary_function::TANGENT;
  case Graph_operation::EXPONENTIAL:
    return Elementary_function::EXPONENTIAL;
  case Graph_operation::LOGARITHM:
    return Elementary_function::LOGARITHM;
  case Graph_operation::ARC_TANGENT:
    return Elementary_function::ARC_TANGENT;
  default:
    return Elementary_function::SQUARE_ROOT;
  }
}

inline double function_value(Graph_operation operation, double a)
{
  switch (operation) {
  case Graph_operation::SINE:
    return std::sin(a);
  case Graph_operation::COSINE:
    return std::cos(a);
  case Graph_operation::TANGENT:
    return std::tan(a);
  case Graph_operation::EXPONENTIAL:
    return std::exp(a);
  case Graph_operation::LOGARITHM:
    return std::log(a);
  case Graph_operation::ARC_TANGENT:
    return std::atan(a);
  default:
    return std::sqrt(a);
  }
}

// Functions of doubles; of intervals, on the part where they are defined; of formulas.
template <class NT>
NT graph_function(Graph_operation operation, const NT& a)
{
  if constexpr (std::same_as<NT, Expression>)
    return Expression::function_of(function_of(operation), a);
  else if constexpr (std::floating_point<NT>)
    return static_cast<NT>(function_value(operation, static_cast<double>(a)));
  else if constexpr (std::same_as<NT, CGAL::Interval_nt<false>> || std::same_as<NT, CGAL::Interval_nt<true>>) {
    const Upward_rounding_guard guard;
    const elementary::Interval x(a.inf(), a.sup());
    const elementary::Interval values = elementary::range_of_values({function_of(operation)}, x);
    return NT(values.inf(), values.sup());
  } else
    throw Invalid_input("Graph_evaluation: " + in_words(function_of(operation)) + " has no value in these numbers");
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

Values of formulas of an `Expression_graph` at many points. Nothing is computed twice at a point, and what is computed
is counted. All storage is there when the formulas have been prepared: to evaluate them allocates nothing but what the
numbers themselves do.

In exact numbers values are exact; in intervals they enclose as far as these do (`CGAL::Interval_nt<false>` under an
`Upward_rounding_guard`), functions on the part where they are defined; doubles round. For other numbers the header of
their `Number_traits` has to be included.
\tparam NT a model of `GraphNumber`; with `Expression`, formulas are composed and expanded.
*/
template <GraphNumber NT>
class Graph_evaluation
{
  std::shared_ptr<const internal::Graph_store> m_store;
  std::vector<NT> m_values;                 // of vertices
  std::vector<std::uint32_t> m_points;      // at which they were computed; 0: constants
  std::vector<std::vector<int>> m_formulas; // the operations that a formula needs, in their order
  std::uint32_t m_point = 1;
  Operation_count m_operations;

public:
  //! of no formula so far.
  explicit Graph_evaluation(const Expression_graph& graph) : m_store(graph.store()) {}

  //! of these formulas: `graph.gradient(f)` has several that are evaluated together.
  Graph_evaluation(const Expression_graph& graph, std::span<const Expression_graph::Node> formulas)
    : Graph_evaluation(graph)
  {
    prepare(formulas);
  }

  //! makes a list of what these formulas need. \return its number. What is known at the point stays known.
  //! \throws Invalid_input when a formula is of another graph.
  std::size_t prepare(std::span<const Expression_graph::Node> formulas)
  {
    std::vector<int> vertices;
    for (const Expression_graph::Node& formula : formulas) {
      if (formula.store() != m_store)
        throw Invalid_input("Graph_evaluation: a node of another graph");
      vertices.push_back(formula.index());
    }
    const std::size_t size = m_store->size();
    m_values.resize(size, internal::graph_constant<NT>(0));
    m_points.resize(size, 0);
    std::vector<int>& operations = m_formulas.emplace_back();
    for (const int v : m_store->needed_by(vertices))
      if (m_store->is_constant(v))
        m_values[v] = internal::graph_constant<NT>(m_store->constant_at(v));
      else if (!(*m_store)[v].is_leaf())
        operations.push_back(v);
    return m_formulas.size() - 1;
  }

  //! what follows is at this point. \throws Invalid_input when it has a wrong number of coordinates.
  void set_point(std::span<const NT> point)
  {
    if (point.size() != static_cast<std::size_t>(m_store->number_of_unknowns()))
      throw Invalid_input("Graph_evaluation: a point with " + std::to_string(point.size()) + " coordinates for " +
                          std::to_string(m_store->number_of_unknowns()) + " unknowns");
    CGAL_precondition(!m_formulas.empty());
    if (++m_point == 0) { // after 2^32 points
      m_points.assign(m_points.size(), 0);
      m_point = 1;
    }
    for (std::size_t i = 0; i < point.size(); ++i)
      m_values[i] = point[i];
  }

  //! computes formulas of this number, as far as they have not been at this point.
  //! \throws Invalid_input when an exact divisor is zero, or a function has no value in these numbers.
  void evaluate(std::size_t number = 0)
  {
    evaluate(number, [] {});
  }

  //! the same; `check()` is called before each operation, and may end the work by an exception.
  template <std::invocable Check>
  void evaluate(std::size_t number, const Check& check)
  {
    for (const int v : m_formulas[number])
      if (m_points[v] != m_point) {
        check();
        compute(v);
        m_points[v] = m_point;
      }
  }

  //! the value of a formula, or of a part of one. \pre it was computed at this point
  const NT& operator[](const Expression_graph::Node& node) const { return m_values[node.index()]; }

  //! the operations that were done since the last `reset_operations()`.
  const Operation_count& operations() const { return m_operations; }
  void reset_operations() { m_operations = {}; }

  //! bytes that the workspace takes, without what numbers allocate.
  std::size_t memory() const
  {
    std::size_t result = m_values.capacity() * sizeof(NT) + m_points.capacity() * sizeof(std::uint32_t);
    for (const std::vector<int>& operations : m_formulas)
      result += operations.capacity() * sizeof(int);
    return result;
  }

private:
  void compute(int vertex)
  {
    using internal::Graph_operation;
    const auto [operation, first, second] = (*m_store)[vertex];
    internal::count_operation(m_operations, operation);
    const NT& a = m_values[first];
    const NT& b = m_values[second];
    switch (operation) {
    case Graph_operation::UNKNOWN:
    case Graph_operation::CONSTANT:
      break;
    case Graph_operation::NEGATION:
      m_values[vertex] = -a;
      break;
    case Graph_operation::SUM:
      m_values[vertex] = a + b;
      break;
    case Graph_operation::DIFFERENCE:
      m_values[vertex] = a - b;
      break;
    case Graph_operation::PRODUCT:
      m_values[vertex] = first == second ? internal::graph_square(a) : NT(a * b);
      break;
    case Graph_operation::QUOTIENT:
      m_values[vertex] = internal::graph_quotient<NT>(a, b);
      break;
    case Graph_operation::SQUARE_ROOT:
    case Graph_operation::SINE:
    case Graph_operation::COSINE:
    case Graph_operation::TANGENT:
    case Graph_operation::EXPONENTIAL:
    case Graph_operation::LOGARITHM:
    case Graph_operation::ARC_TANGENT:
      m_values[vertex] = internal::graph_function(operation, a);
      break;
    }
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_GRAPH_EVALUATION_H
