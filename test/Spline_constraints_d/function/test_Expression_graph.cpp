// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Computational graphs: equal parts stand once; the two-link arm of Pai's figures 4 and 5; a product of all unknowns;
// 1,000 random graphs with the operations of their gradients counted, and the gradients compared in exact numbers with
// the derivatives of expanded formulas, and in a finite field with the forward mode; evaluation in doubles, intervals,
// rationals and expressions, without allocation; bad input.

#include <CGAL/Spline_constraints_d/function/Expression_graph.h>
#include <CGAL/Spline_constraints_d/function/Graph_evaluation.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_mpfr.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include "random_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <vector>

namespace expression_graph_test {

namespace SC = CGAL::Spline_constraints;
using random_graphs::random_formula;
using random_graphs::Random_formula;
using SC::Expression;
using SC::Expression_graph;
using SC::Graph_evaluation;
using SC::Operation_count;
using Node = Expression_graph::Node;
using Nodes = std::vector<Node>;
using Rational = SC::Exact_rational;
using Point = std::vector<Rational>;

namespace {

Nodes with(Nodes nodes, const Node& another)
{
  nodes.push_back(another);
  return nodes;
}

Point values(const Expression_graph& graph, const Nodes& nodes, const Point& point)
{
  Graph_evaluation<Rational> evaluation(graph, nodes);
  evaluation.set_point(point);
  evaluation.evaluate();
  Point result;
  for (const Node& node : nodes)
    result.push_back(evaluation[node]);
  return result;
}

// A number type of a user: integers modulo a prime, where 1/0 is 0.
struct Modular
{
  static constexpr std::int64_t prime = 2147483647;
  std::int64_t value;

  explicit Modular(std::int64_t x) : value(((x % prime) + prime) % prime) {}
  explicit Modular(const Rational& x) : Modular(0)
  {
    const auto [numerator, denominator] = SC::internal::parts_of(x);
    *this = residue(numerator) / residue(denominator);
  }
  static Modular residue(const SC::Exact_integer& n)
  {
    return Modular(
        static_cast<std::int64_t>(CGAL::to_double(CGAL::mod(n, SC::Exact_integer(static_cast<long>(prime))))));
  }
  friend Modular operator+(Modular a, Modular b) { return Modular(a.value + b.value); }
  friend Modular operator-(Modular a, Modular b) { return Modular(a.value - b.value); }
  friend Modular operator-(Modular a) { return Modular(-a.value); }
  friend Modular operator*(Modular a, Modular b) { return Modular(a.value * b.value); }
  friend Modular operator/(Modular a, Modular b)
  {
    Modular power = b;
    for (std::int64_t e = prime - 2; e > 0; e /= 2, power = power * power)
      if (e % 2 != 0)
        a = a * power;
    return a;
  }
};

Point random_point(int size, std::mt19937& random)
{
  Point result;
  for (int i = 0; i < size; ++i)
    result.push_back(Rational(static_cast<int>(random() % 199) - 99) / Rational(101));
  return result;
}

} // namespace

TEST(Expression_graph, equal_parts_stand_once)
{
  Expression_graph graph(2);
  const Node x = graph.unknown(0), y = graph.unknown(1);
  EXPECT_EQ(x + y, y + x);
  EXPECT_EQ(x * y, y * x);
  EXPECT_NE(x - y, y - x);
  EXPECT_EQ((x + y) * (y + x), square(x + y));
  EXPECT_EQ(x + (-y), x - y);
  EXPECT_EQ((-x) + y, y - x);
  EXPECT_EQ(-(-x), x);
  EXPECT_EQ(x + 0, x);
  EXPECT_EQ(1 * x, x);
  EXPECT_EQ(-1 * x, -x);
  EXPECT_EQ(x / 2, Rational(1, 2) * x);
  EXPECT_EQ(x - x, graph.constant(0));
  EXPECT_EQ(0 * x, graph.constant(0));
  EXPECT_EQ((x * y) / (x * y), graph.constant(1));
  EXPECT_EQ(graph.constant(2) * 3 + 0.25, graph.constant(Rational(25, 4)));
  EXPECT_EQ(pow(x, -2), 1 / (x * x));
  EXPECT_EQ(pow(x, 4), square(square(x)));
  const std::size_t size = graph.size();
  EXPECT_EQ(square(x + y) + pow(x, 4), pow(x, 4) + (y + x) * (x + y));
  EXPECT_EQ(graph.size(), size + 1);

  // (x + 1)^20: one sum, four squares, and the product with another of them.
  EXPECT_EQ(graph.operations(pow(x + 1, 20)), (Operation_count{1, 5, 0}));
  const Nodes both{x * y + 1, x * y - 1};
  EXPECT_EQ(graph.operations(both), (Operation_count{2, 1, 0}));
  EXPECT_EQ(graph.operations(x).total(), 0u);
  EXPECT_GE(graph.memory(), graph.size() * 12);
}

// y2 = l1 sin t1 + l2 sin(t1 + t2): its derivative by t1 is x2, found and not computed again.
TEST(Expression_graph, arm_with_two_links)
{
  Expression_graph graph(4);
  const Node t1 = graph.unknown(0), t2 = graph.unknown(1), l1 = graph.unknown(2), l2 = graph.unknown(3);
  const Node x2 = l1 * cos(t1) + l2 * cos(t1 + t2), y2 = l1 * sin(t1) + l2 * sin(t1 + t2);
  const std::size_t size = graph.size();
  const Nodes gradient = graph.gradient(y2);
  EXPECT_EQ(gradient[0], x2);
  EXPECT_EQ(gradient[1], l2 * cos(t1 + t2));
  EXPECT_EQ(gradient[2], sin(t1));
  EXPECT_EQ(gradient[3], sin(t1 + t2));
  EXPECT_EQ(graph.size(), size + 1) << "the constant 1 alone is new";
  const Nodes along{graph.constant(1), graph.constant(0), graph.constant(0), graph.constant(0)};
  EXPECT_EQ(graph.directional_derivative(y2, along), x2);

  Graph_evaluation<double> evaluation(graph, with(gradient, y2));
  evaluation.set_point(std::vector<double>{0.3, 0.5, 2, 1});
  evaluation.evaluate();
  EXPECT_NEAR(evaluation[y2], 2 * std::sin(0.3) + std::sin(0.8), 1e-15);
  EXPECT_NEAR(evaluation[gradient[0]], 2 * std::cos(0.3) + std::cos(0.8), 1e-15);
  const Node root = sqrt(l1 * l1 + l2 * l2), by_l1 = graph.gradient(root)[2];
  Graph_evaluation<double> of_root(graph, Nodes{root, by_l1});
  of_root.set_point(std::vector<double>{0, 0, 3, 4});
  of_root.evaluate();
  EXPECT_DOUBLE_EQ(of_root[root], 5);
  EXPECT_DOUBLE_EQ(of_root[by_l1], 0.6);
}

// All functions, as nodes and in a formula: derivatives both ways, against differences, in enclosures.
TEST(Expression_graph, functions)
{
  const auto [u, v] = SC::unknowns({0.1, 1}, {0.1, 1});
  const SC::Expression formula =
      exp(u * v) + log(u + v) * tan(u) - atan(v / u) + sqrt(u) * sin(v) * cos(u) + SC::Expression::pi() / (1 + u);
  Expression_graph graph(2);
  const Node x = graph.unknown(0), y = graph.unknown(1), one = graph.constant(1);
  const Node by_hand =
      exp(x * y) + log(x + y) * tan(x) - atan(y / x) + sqrt(x) * sin(y) * cos(x) + 4 * atan(one) / (1 + x);
  const Node f = graph.node(formula);
  const Nodes gradient = graph.gradient(f), gradient_by_hand = graph.gradient(by_hand);
  const Node along = graph.directional_derivative(f, Nodes{graph.constant(2), graph.constant(-3)});
  Nodes all = with(gradient, f);
  for (const Node& other : {by_hand, gradient_by_hand[0], gradient_by_hand[1], along})
    all.push_back(other);
  using Interval = CGAL::Interval_nt<false>;
  Graph_evaluation<double> evaluation(graph, all);
  Graph_evaluation<Interval> enclosure(graph, all);
  const auto value_at = [&](double a, double b) {
    evaluation.set_point(std::vector<double>{a, b});
    evaluation.evaluate();
    return evaluation[f];
  };
  for (int k = 1; k <= 20; ++k) {
    const double a = 0.045 * k, b = 1 - 0.03 * k, h = 0x1p-20;
    const double by_a = (value_at(a + h, b) - value_at(a - h, b)) / (2 * h);
    const double by_b = (value_at(a, b + h) - value_at(a, b - h)) / (2 * h);
    value_at(a, b);
    EXPECT_NEAR(evaluation[f], evaluation[by_hand], 1e-13);
    EXPECT_NEAR(evaluation[gradient[0]], by_a, 1e-6);
    EXPECT_NEAR(evaluation[gradient[1]], by_b, 1e-6);
    EXPECT_NEAR(evaluation[gradient_by_hand[0]], evaluation[gradient[0]], 1e-12);
    EXPECT_NEAR(evaluation[gradient_by_hand[1]], evaluation[gradient[1]], 1e-12);
    EXPECT_NEAR(evaluation[along], 2 * evaluation[gradient[0]] - 3 * evaluation[gradient[1]], 1e-12);
    const SC::Upward_rounding_guard guard;
    enclosure.set_point(std::vector<Interval>{a, b});
    enclosure.evaluate();
    for (const Node& node : all) {
      EXPECT_LT(enclosure[node].sup() - enclosure[node].inf(), 1e-11);
      EXPECT_NEAR(enclosure[node].inf(), evaluation[node], 1e-11);
    }
  }
  Graph_evaluation<SC::Expression> back(graph, Nodes{by_hand});
  back.set_point(std::vector<SC::Expression>{u, v});
  back.evaluate();
  EXPECT_TRUE((back[by_hand] - formula).numerator().is_zero());
  EXPECT_THROW(graph.node(cosh(u)), SC::Invalid_input);
}

// Speelpenning's function, the product of all unknowns.
TEST(Expression_graph, product_of_all_unknowns)
{
  std::mt19937 random(1);
  for (const int n : {2, 3, 10, 100}) {
    Expression_graph graph(n);
    Node f = graph.unknown(0);
    for (int i = 1; i < n; ++i)
      f = f * graph.unknown(i);
    const Nodes gradient = graph.gradient(f);
    EXPECT_EQ(graph.operations(f).total(), static_cast<std::size_t>(n - 1));
    EXPECT_EQ(graph.operations(with(gradient, f)).total(), static_cast<std::size_t>(n == 2 ? 1 : 3 * n - 5));
    Point point;
    for (int i = 0; i < n; ++i)
      point.push_back(Rational(1 + static_cast<int>(random() % 50)) / Rational(7));
    const Point exact = values(graph, with(gradient, f), point);
    for (int i = 0; i < n; ++i)
      EXPECT_EQ(exact[i] * point[i], exact[n]);
  }
}

TEST(Expression_graph, gradients_of_random_graphs)
{
  std::mt19937 random(20);
  double largest = 0, largest_products = 0;
  std::size_t compared = 0, operations = 0;
  for (int run = 0; run < 1000; ++run) {
    const bool is_small = run % 2 == 0;
    const int unknowns = 1 + static_cast<int>(random() % 4);
    Expression_graph graph(unknowns);
    std::vector<Random_formula> formulas;
    const auto x = SC::unknowns(unknowns, {-1, 1});
    for (int i = 0; i < unknowns; ++i)
      formulas.push_back({graph.unknown(i), x[i], 1});
    for (int step = 0; step < (is_small ? 8 : 200) || graph.operations(formulas.back().node).total() == 0; ++step)
      formulas.push_back(random_formula(formulas, is_small ? 5 : 1 << 20, is_small, random));
    const auto& [f, expanded, degree] = formulas.back();

    const Nodes gradient = graph.gradient(f);
    const Operation_count own = graph.operations(f), all = graph.operations(with(gradient, f));
    EXPECT_LT(all.total(), 5 * own.total());
    EXPECT_LE(all.multiplications, 3 * own.multiplications);
    operations += own.total();
    largest = (std::max)(largest, double(all.total()) / own.total());
    if (own.multiplications > 0)
      largest_products = (std::max)(largest_products, double(all.multiplications) / own.multiplications);

    // Along a direction, in the field of the integers modulo a prime; and the derivatives of the expanded formula.
    Nodes direction;
    std::vector<Modular> point;
    for (int i = 0; i < unknowns; ++i) {
      direction.push_back(graph.constant(static_cast<int>(random() % 100)));
      point.emplace_back(Rational(static_cast<int>(random() % 1000000)));
    }
    const Node along = graph.directional_derivative(f, direction);
    Graph_evaluation<Modular> evaluation(graph, with(with(with(gradient, f), along), graph.constant(1)));
    evaluation.set_point(point);
    evaluation.evaluate();
    Modular sum(0);
    for (int i = 0; i < unknowns; ++i)
      sum = sum + Modular(direction[i].store()->constant_at(direction[i].index())) * evaluation[gradient[i]];
    EXPECT_EQ(sum.value, evaluation[along].value);
    if (!is_small)
      continue;
    const Point place = random_point(unknowns, random);
    try {
      const Point exact = values(graph, with(gradient, f), place);
      EXPECT_EQ(expanded(place), exact[unknowns]);
      for (int i = 0; i < unknowns; ++i)
        EXPECT_EQ(derivative(expanded, x[i])(place), exact[i]);
      ++compared;
    } catch (const SC::Invalid_input&) { // a divisor is zero
    }
  }
  EXPECT_GT(compared, 480u);
  EXPECT_GT(operations, 40000u) << "most operations of the random formulas are not needed";
  RecordProperty("operations", std::to_string(largest));
  RecordProperty("multiplications", std::to_string(largest_products));
  EXPECT_GT(largest, 3) << "the bounds were tried by hardly anything";
  EXPECT_EQ(largest_products, 3);
}

TEST(Expression_graph, formulas_and_compositions)
{
  const auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const Expression f = (pow(x, 3) * y - 2 * x * x + 5) / (1 + x * x) + y / (x - 3);
  Expression_graph graph(2);
  const Node node = graph.node(f);
  EXPECT_EQ(graph.node(f), node);
  const Point point{Rational(2, 3), Rational(-7, 5)};
  EXPECT_EQ(values(graph, {node}, point)[0], f(point));
  // In nested form.
  EXPECT_EQ(graph.operations(graph.node(pow(x, 3) + 2 * x * x + 3 * x + 4)), (Operation_count{3, 2, 0}));

  // Lifted by a map: the gradient is D l^T grad f, found without D l.
  const auto [a, b] = SC::unknowns({-1, 1}, {-1, 1});
  const Expression u = a * b / (2 + a), v = a - b;
  const Node lifted = graph.composition(f, Nodes{graph.node(u), graph.node(v)});
  const Point base{Rational(1, 3), Rational(2, 7)}, image{u(base), v(base)};
  const Point exact = values(graph, with(graph.gradient(lifted), lifted), base);
  EXPECT_EQ(exact[2], f(image));
  EXPECT_EQ(exact[0],
            derivative(f, x)(image) * derivative(u, a)(base) + derivative(f, y)(image) * derivative(v, a)(base));
  EXPECT_EQ(exact[1],
            derivative(f, x)(image) * derivative(u, b)(base) + derivative(f, y)(image) * derivative(v, b)(base));

  // Evaluated in expressions, a graph is expanded.
  Graph_evaluation<Expression> expansion(graph, Nodes{lifted});
  expansion.set_point(std::vector<Expression>{a, b});
  expansion.evaluate();
  EXPECT_EQ(expansion[lifted](base), f(image));
}

TEST(Expression_graph, enclosures)
{
  const SC::Upward_rounding_guard guard;
  using Interval = CGAL::Interval_nt<false>;
  Expression_graph graph(2);
  const Node x = graph.unknown(0), y = graph.unknown(1), f = pow(x, 2) * y / 3 - 1 / (x + y), root = sqrt(x);
  Graph_evaluation<Interval> evaluation(graph, Nodes{f, root});
  for (int k = 1; k < 50; ++k) {
    const Point point{Rational(k, 7), Rational(11, k)};
    evaluation.set_point(std::vector<Interval>{SC::Number_traits<Interval>::from_rational(point[0]),
                                               SC::Number_traits<Interval>::from_rational(point[1])});
    evaluation.evaluate();
    const Rational exact = values(graph, {f}, point)[0];
    EXPECT_LE(Rational(evaluation[f].inf()), exact);
    EXPECT_GE(Rational(evaluation[f].sup()), exact);
    EXPECT_LT(evaluation[f].sup() - evaluation[f].inf(), 1e-12);
    EXPECT_LE(Rational(evaluation[root].inf()) * Rational(evaluation[root].inf()), point[0]);
    EXPECT_GE(Rational(evaluation[root].sup()) * Rational(evaluation[root].sup()), point[0]);
  }
  // Guarded intervals, and those of many bits.
  const Point point{Rational(1, 3), Rational(2, 7)};
  const Rational exact = values(graph, {f}, point)[0];
  Graph_evaluation<CGAL::Interval_nt<true>> guarded(graph, Nodes{f});
  guarded.set_point(
      std::vector<CGAL::Interval_nt<true>>{SC::to_double_interval(point[0]), SC::to_double_interval(point[1])});
  guarded.evaluate();
  EXPECT_TRUE(Rational(guarded[f].inf()) <= exact && exact <= Rational(guarded[f].sup()));
  Graph_evaluation<SC::Mpfr_interval> precise(graph, Nodes{f});
  precise.set_point(std::vector<SC::Mpfr_interval>{SC::Mpfr_interval(point[0]), SC::Mpfr_interval(point[1])});
  precise.evaluate();
  const auto [lower, upper] = precise[f].to_double_interval();
  EXPECT_TRUE(Rational(lower) <= exact && exact <= Rational(upper) && upper - lower < 1e-15);

  // A square of an interval around zero is not negative.
  Graph_evaluation<Interval> of_square(graph, Nodes{square(x)});
  of_square.set_point(std::vector<Interval>{{-1, 2}, {0, 0}});
  of_square.evaluate();
  EXPECT_EQ(of_square[square(x)].inf(), 0);
}

TEST(Expression_graph, nothing_is_computed_twice)
{
  Expression_graph graph(2);
  const Node x = graph.unknown(0), y = graph.unknown(1), f = square(x * y + 1), g = x * y - 1;
  Graph_evaluation<double> evaluation(graph);
  const std::size_t of_f = evaluation.prepare(Nodes{f}), of_g = evaluation.prepare(Nodes{g}),
                    of_gradient = evaluation.prepare(graph.gradient(f));
  evaluation.set_point(std::vector<double>{2, 3});
  evaluation.evaluate(of_f);
  EXPECT_EQ(evaluation.operations(), (Operation_count{1, 2, 0}));
  evaluation.evaluate(of_f);
  EXPECT_EQ(evaluation.operations().total(), 3u);
  evaluation.evaluate(of_g);
  EXPECT_EQ(evaluation.operations().total(), 4u);
  EXPECT_EQ(evaluation[f], 49);
  EXPECT_EQ(evaluation[g], 5);
  evaluation.evaluate(of_gradient); // 2 (x y + 1), as a sum; its products with x and y
  EXPECT_EQ(evaluation.operations(), (Operation_count{3, 4, 0}));
  const std::size_t memory = evaluation.memory();
  for (int k = 0; k < 1000; ++k) {
    evaluation.set_point(std::vector<double>{1. * k, 1});
    evaluation.evaluate(of_f);
    EXPECT_EQ(evaluation[f], (k + 1.) * (k + 1.));
  }
  EXPECT_EQ(evaluation.memory(), memory);
}

// Deep and wide ones take neither recursion nor quadratic time.
TEST(Expression_graph, large_graphs)
{
  Expression_graph graph(1);
  const Node x = graph.unknown(0);
  Node f = x;
  for (int k = 0; k < 100000; ++k)
    f = k % 2 == 0 ? f * x : f + 1;
  const Node derivative = graph.gradient(f)[0];
  Graph_evaluation<double> evaluation(graph, Nodes{f, derivative});
  evaluation.set_point(std::vector<double>{0.5});
  evaluation.evaluate();
  EXPECT_DOUBLE_EQ(evaluation[f], 2);          // f = x f + 1
  EXPECT_DOUBLE_EQ(evaluation[derivative], 4); // f' = f + x f'
}

TEST(Expression_graph, bad_input)
{
  EXPECT_THROW(Expression_graph(0), SC::Invalid_input);
  Expression_graph graph(2), other(2);
  const Node x = graph.unknown(0), y = graph.unknown(1);
  EXPECT_THROW(graph.unknown(2), SC::Invalid_input);
  EXPECT_THROW(graph.unknown(-1), SC::Invalid_input);
  EXPECT_THROW(x + other.unknown(0), SC::Invalid_input);
  EXPECT_THROW(graph.gradient(other.unknown(0)), SC::Invalid_input);
  EXPECT_THROW(graph.directional_derivative(x, Nodes{x}), SC::Invalid_input);
  EXPECT_THROW(x / 0, SC::Invalid_input);
  EXPECT_THROW(x / (y - y), SC::Invalid_input);
  EXPECT_THROW(x * std::nan(""), SC::Invalid_input);
  EXPECT_THROW(pow(x, 1 << 30), SC::Invalid_input);
  EXPECT_THROW(pow(graph.constant(2), 1000000), SC::Invalid_input);
  EXPECT_THROW(values(graph, {x / y}, {1, 0}), SC::Invalid_input);
  EXPECT_THROW(values(graph, {sin(x)}, {1, 0}), SC::Invalid_input);
  EXPECT_THROW(values(graph, {x}, {1}), SC::Invalid_input);
  EXPECT_THROW(Graph_evaluation<double>(graph, Nodes{other.unknown(0)}), SC::Invalid_input);
  const auto u = SC::unknowns(3, {0, 1});
  EXPECT_THROW(graph.node(u[0] + u[2]), SC::Invalid_input);
  EXPECT_THROW(graph.composition(u[0] + u[1], Nodes{x}), SC::Invalid_input);
}

} // namespace expression_graph_test
