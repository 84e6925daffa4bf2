// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_GRAPH_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_GRAPH_H

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Operation_count.h>
#include <CGAL/Spline_constraints_d/function/internal/graph/Graph_store.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/function/internal/graph/graph_derivatives.h>
#include <CGAL/Spline_constraints_d/function/internal/graph/graph_operations.h>
#endif

#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

Formulas in unknowns as one computational (Kantorovich) graph: a vertex for each operation, and only one for those that
are equal.

An `Expression` is expanded; a graph is not. \f$(x+1)^{20}\f$ has six operations here, and two formulas with a part in
common compute it once. Operands of sums and products are ordered, so that \f$a+b\f$ is \f$b+a\f$; operations on
constants are done, exactly, when they are entered, and \f$a \pm 0\f$, \f$a - a\f$, \f$0\,a\f$, \f$1\,a\f$, \f$a/1\f$,
\f$a/a\f$ and \f$-(-a)\f$ are simplified as in the field of rational functions: where a divisor is zero, that may make a
formula defined. Functions have no exact values.

Derivatives are vertices of the same graph, so that what they share with functions, or with each other, is found, and
they can be differentiated again. Values: `Graph_evaluation`.

Copies of a graph share its vertices. Threads may evaluate formulas at the same time, while none adds vertices.

Complexity: an operation is entered in constant expected time, a constant in logarithmic time.

Source: D. K. Pai, Least Constraint (ACC 1991), section 3; the gradient is that of W. Baur and V. Strassen (1983).
*/
class Expression_graph
{
  std::shared_ptr<internal::Graph_store> m_store;

public:
  /*!
  A formula in a graph: the vertex of its last operation. `+`, `-`, `*`, `/`, `pow`, `sqrt`, `sin`, `cos`, `tan`,
  `exp`, `log` and `atan` of nodes, and of nodes and numbers, make further ones; `==` tells whether two are the same.
  \throws Invalid_input when nodes of different graphs meet, or the divisor is the number zero.
  */
  class Node
  {
    std::shared_ptr<internal::Graph_store> m_store;
    int m_vertex;

  public:
#ifndef DOXYGEN_RUNNING
    Node(std::shared_ptr<internal::Graph_store> store, int vertex) : m_store(std::move(store)), m_vertex(vertex) {}
    const std::shared_ptr<internal::Graph_store>& store() const { return m_store; }
#endif

    //! its place in the graph: it comes after all vertices that it needs.
    int index() const { return m_vertex; }

    //! whether it is a number.
    bool is_constant() const { return m_store->is_constant(m_vertex); }

    bool operator==(const Node&) const = default;

    friend Node operator-(const Node& a) { return {a.m_store, a.m_store->negation(a.m_vertex)}; }
    friend Node operator+(const Node& a, const Node& b) { return a.joined(b, &internal::Graph_store::sum); }
    friend Node operator-(const Node& a, const Node& b) { return a.joined(b, &internal::Graph_store::difference); }
    friend Node operator*(const Node& a, const Node& b) { return a.joined(b, &internal::Graph_store::product); }
    friend Node operator/(const Node& a, const Node& b) { return a.joined(b, &internal::Graph_store::quotient); }

    template <std::convertible_to<Power_polynomial> T>
    friend Node operator+(const Node& a, const T& b)
    {
      return a + a.number(b);
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator-(const Node& a, const T& b)
    {
      return a - a.number(b);
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator*(const Node& a, const T& b)
    {
      return a * a.number(b);
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator/(const Node& a, const T& b)
    {
      return a / a.number(b);
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator+(const T& a, const Node& b)
    {
      return b.number(a) + b;
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator-(const T& a, const Node& b)
    {
      return b.number(a) - b;
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator*(const T& a, const Node& b)
    {
      return b.number(a) * b;
    }
    template <std::convertible_to<Power_polynomial> T>
    friend Node operator/(const T& a, const Node& b)
    {
      return b.number(a) / b;
    }

    //! a power, by repeated squaring; one with a negative exponent is divided by.
    //! \throws Invalid_input when the exponent exceeds `Power_polynomial::maximal_degree`.
    friend Node pow(const Node& base, int exponent)
    {
      return {base.m_store, base.m_store->power(base.m_vertex, exponent)};
    }
    friend Node square(const Node& a) { return a * a; }
    friend Node sqrt(const Node& a) { return a.function(internal::Graph_operation::SQUARE_ROOT); }
    friend Node sin(const Node& a) { return a.function(internal::Graph_operation::SINE); }
    friend Node cos(const Node& a) { return a.function(internal::Graph_operation::COSINE); }
    friend Node tan(const Node& a) { return a.function(internal::Graph_operation::TANGENT); }
    friend Node exp(const Node& a) { return a.function(internal::Graph_operation::EXPONENTIAL); }
    friend Node log(const Node& a) { return a.function(internal::Graph_operation::LOGARITHM); }
    friend Node atan(const Node& a) { return a.function(internal::Graph_operation::ARC_TANGENT); }

  private:
    Node number(const Power_polynomial& value) const
    {
      if (!value.is_constant())
        throw Invalid_input("Expression_graph: a polynomial where a number is needed");
      return {m_store, m_store->constant(value.constant_term())};
    }
    Node joined(const Node& other, int (internal::Graph_store::*operation)(int, int)) const
    {
      if (m_store != other.m_store)
        throw Invalid_input("Expression_graph: nodes of different graphs in one formula");
      return {m_store, ((*m_store).*operation)(m_vertex, other.m_vertex)};
    }
    Node function(internal::Graph_operation operation) const
    {
      return {m_store, m_store->function(operation, m_vertex)};
    }
  };

  //! a graph with this many unknowns and nothing else.
  //! \throws Invalid_input when there is none.
  explicit Expression_graph(int unknowns) : m_store(std::make_shared<internal::Graph_store>(unknowns)) {}

#ifndef DOXYGEN_RUNNING
  const std::shared_ptr<internal::Graph_store>& store() const { return m_store; }
#endif

  int number_of_unknowns() const { return m_store->number_of_unknowns(); }

  //! an unknown. \throws Invalid_input when there is none of this index.
  Node unknown(int index) const
  {
    if (index < 0 || index >= number_of_unknowns())
      throw Invalid_input("Expression_graph: unknown " + std::to_string(index) + " of " +
                          std::to_string(number_of_unknowns()));
    return {m_store, index};
  }

  //! all unknowns in their order.
  std::vector<Node> unknowns() const
  {
    std::vector<Node> result;
    for (int i = 0; i < number_of_unknowns(); ++i)
      result.push_back(unknown(i));
    return result;
  }

  //! a number. \throws Invalid_input when its numerator or denominator is longer than `Power_polynomial` allows.
  Node constant(const Exact_rational& value) { return {m_store, m_store->constant(value)}; }

  /*!
  a formula. Its expanded polynomials are entered in nested (Horner) form: again and again the factor that most terms
  have in common is taken out. Complexity: quadratic in the number of terms, in the worst case.
  \throws Invalid_input when a spline, an unknown without a range or a function that nodes have not occurs, or the graph
  has too few unknowns.
  */
  Node node(const Expression& formula) { return composition(formula, unknowns()); }

  /*!
  a formula with nodes in place of its unknowns: \f$f(l_0(x), l_1(x), \ldots)\f$. So functions on one domain are lifted
  to another, by maps that link them.
  \throws Invalid_input as `node()`, and when there are too few nodes, or one is of another graph.
  */
  Node composition(const Expression& formula, std::span<const Node> arguments)
  {
    const std::vector<int> vertices = vertices_of(arguments);
    const auto enter = [&](const Power_polynomial& polynomial) {
      return m_store->composition(polynomial, formula.symbols().get(), vertices);
    };
    const int above = enter(formula.numerator());
    return {m_store, m_store->quotient(above, enter(internal::polynomial_of(formula.denominator())))};
  }

  /*!
  the partial derivatives by all unknowns, in their order (reverse mode).

  If the formula is a rational function with \f$T \ge 1\f$ operations, \f$\mu\f$ of them products or quotients, then
  the formula and its derivatives together have less than \f$5 T\f$ operations, at most \f$3 \mu\f$ of them products or
  quotients, however many unknowns there are: see \ref Spline_constraints_d_graph_proofs "Proofs".
  Complexity: linear in the size of the graph.
  */
  std::vector<Node> gradient(const Node& formula)
  {
    std::vector<Node> result;
    for (const int vertex : m_store->gradient(own(formula)))
      result.emplace_back(m_store, vertex);
    return result;
  }

  //! the derivative along a direction, which has a node for each unknown (forward mode): at most four operations for
  //! each of the formula. \throws Invalid_input when the direction has a wrong number of coordinates.
  Node directional_derivative(const Node& formula, std::span<const Node> direction)
  {
    if (direction.size() != static_cast<std::size_t>(number_of_unknowns()))
      throw Invalid_input("Expression_graph: a direction with " + std::to_string(direction.size()) +
                          " coordinates for " + std::to_string(number_of_unknowns()) + " unknowns");
    return {m_store, m_store->directional_derivative(own(formula), vertices_of(direction))};
  }

  //! how many vertices there are, with unknowns and constants, and with what is not used any more.
  std::size_t size() const { return m_store->size(); }

  //! bytes that the graph takes, about: digits of long constants are not counted.
  std::size_t memory() const { return m_store->memory(); }

  //! how many operations it takes to evaluate all of these formulas; what they share is counted once.
  //! \throws Invalid_input when one is of another graph.
  Operation_count operations(std::span<const Node> formulas) const
  {
    return m_store->operations(vertices_of(formulas));
  }
  Operation_count operations(const Node& formula) const { return operations({&formula, 1}); }

private:
  int own(const Node& node) const
  {
    if (node.store() != m_store)
      throw Invalid_input("Expression_graph: a node of another graph");
    return node.index();
  }
  std::vector<int> vertices_of(std::span<const Node> nodes) const
  {
    std::vector<int> result;
    for (const Node& node : nodes)
      result.push_back(own(node));
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_GRAPH_H
