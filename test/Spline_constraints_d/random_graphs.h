// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_GRAPHS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_GRAPHS_H

// Random formulas of a graph, and, where it is asked for, the same expanded.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Expression_graph.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace random_graphs {

namespace SC = CGAL::Spline_constraints;
using SC::Expression;
using SC::Expression_graph;
using Node = Expression_graph::Node;

struct Random_formula
{
  Node node;
  Expression expanded;
  int degree; // of numerator and denominator, at most
};

inline Random_formula random_operation(const Random_formula& a, const Random_formula& b, bool expands,
                                       std::mt19937& random)
{
  const auto make = [&](const Node& node, const auto& expanded, int degree) {
    return Random_formula{node, expands ? expanded() : Expression(0), (std::min)(degree, 1 << 20)};
  };
  const int both = a.degree + b.degree, number = 1 + static_cast<int>(random() % 5);
  const unsigned operation = random() % 12;
  if (operation < 2)
    return make(
        a.node + b.node, [&] { return a.expanded + b.expanded; }, both);
  if (operation < 4)
    return make(
        a.node - b.node, [&] { return a.expanded - b.expanded; }, both);
  if (operation < 7 || (operation < 10 && expands && b.expanded.numerator().is_zero()))
    return make(
        a.node * b.node, [&] { return a.expanded * b.expanded; }, both);
  if (operation < 10)
    return make(
        a.node / b.node, [&] { return a.expanded / b.expanded; }, both);
  if (operation == 10)
    return make(
        -a.node, [&] { return -a.expanded; }, a.degree);
  return make(
      number * a.node, [&] { return number * a.expanded; }, a.degree);
}

// An operation on two of the formulas that are there, one of them a late one, so that few are useless. Its degree is
// bounded, and it is no constant.
inline Random_formula random_formula(const std::vector<Random_formula>& formulas, int largest_degree, bool expands,
                                     std::mt19937& random)
{
  for (;;) {
    const std::size_t size = formulas.size(), late = size - 1 - random() % (std::min)(size, std::size_t(4));
    const Random_formula result = random_operation(formulas[random() % size], formulas[late], expands, random);
    if (result.degree <= largest_degree && !result.node.is_constant())
      return result;
  }
}

} // namespace random_graphs

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_GRAPHS_H
