// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Layers of the coefficients of a node: functions on its faces beside exact values, and the points and curves that are
// found there in doubles beside those of the solver.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Layer_curves.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace layers_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using Node = SC::internal::Box_node<double>;
using SC::internal::Block;
using SC::internal::Face_restriction;
using SC::internal::Layer_points;
using SC::internal::System_layout;

void add_block(System_layout& layout, std::vector<int> axes, std::vector<int> degrees, std::vector<int> functions)
{
  Block& block = layout.blocks.emplace_back();
  for (const int degree : degrees)
    block.points *= static_cast<std::size_t>(degree) + 1;
  block.axes = std::move(axes);
  block.degrees = std::move(degrees);
  block.functions = std::move(functions);
}

// Two functions on all kinds of unknowns, so that blocks become one on some faces and not on others.
System_layout layout_of_functions()
{
  System_layout layout;
  layout.dimension = 3;
  layout.equalities = layout.functions = 2;
  add_block(layout, {0, 1, 2}, {2, 1, 3}, {0, 1});
  add_block(layout, {0, 1}, {3, 2}, {0, 1});
  add_block(layout, {1}, {4}, {0});
  add_block(layout, {2}, {2}, {0});
  add_block(layout, {}, {}, {0});
  add_block(layout, {0}, {1}, {1});
  layout.place_blocks();
  return layout;
}

Rational power(const Rational& x, int exponent)
{
  Rational result(1);
  for (int k = 0; k < exponent; ++k)
    result *= x;
  return result;
}

Rational bernstein(int degree, int index, const Rational& t)
{
  Rational binomial(1);
  for (int k = 0; k < index; ++k)
    binomial = binomial * Rational(degree - k) / Rational(k + 1);
  return binomial * power(t, index) * power(1 - t, degree - index);
}

// Of the polynomial that has the coefficients as they are, at a point in local coordinates.
Rational value(const System_layout& layout, const Node& node, int function, const std::vector<Rational>& point)
{
  Rational result(0);
  for (const Block& block : layout.blocks)
    for (std::size_t f = 0; f < block.functions.size(); ++f)
      for (std::size_t p = 0; block.functions[f] == function && p < block.points; ++p) {
        Rational term(node.coefficients()[block.offset + p * block.functions.size() + f]);
        for (std::size_t j = 0; j < block.axes.size(); ++j) {
          const std::size_t layer = block.lengths[j + 1] / block.functions.size();
          const int index = static_cast<int>(p / layer) % (block.degrees[j] + 1);
          term *= bernstein(block.degrees[j], index, point[static_cast<std::size_t>(block.axes[j])]);
        }
        result += term;
      }
  return result;
}

double error_of(const System_layout& layout, const Node& node, int function)
{
  double result = 0;
  for (const Block& block : layout.blocks)
    for (std::size_t f = 0; f < block.functions.size(); ++f)
      if (block.functions[f] == function)
        result += node.errors()[block.first_error + f];
  return result;
}

// A node with random numbers, which it takes for exact.
Node random_node(const System_layout& layout, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-1, 1);
  Node node;
  node.allocate(layout);
  for (double& x : node.coefficients())
    x = number(random);
  for (double& size : node.sizes())
    size = 1;
  for (int j = 0; j < layout.dimension; ++j) {
    node.lower[j] = -j;
    node.upper[j] = 1 + j;
  }
  return node;
}

TEST(Layers, FunctionsOnFacesAreThoseOfTheNode)
{
  std::mt19937 random(1);
  const System_layout layout = layout_of_functions();
  for (int axis = 0; axis < 3; ++axis) {
    const Face_restriction restriction(layout, axis);
    ASSERT_EQ(restriction.layout().dimension, 2);
    Node face;
    face.allocate(restriction.layout());
    for (int round = 0; round < 10; ++round) {
      const Node node = random_node(layout, random);
      const bool is_upper = round % 2 == 1;
      restriction(node, is_upper, face);
      std::vector<Rational> point{Rational(round, 11), Rational(2 * round + 1, 23)}, in_space = point;
      in_space.insert(in_space.begin() + axis, Rational(is_upper ? 1 : 0));
      for (int f = 0; f < 2; ++f) {
        const double error = error_of(restriction.layout(), face, f);
        EXPECT_LE(CGAL::abs(Rational(value(layout, node, f, in_space) - value(restriction.layout(), face, f, point))),
                  Rational(error));
        EXPECT_LT(error, 1e-13);
      }
      for (int j = 0; j < 3; ++j)
        if (j != axis) {
          EXPECT_EQ(face.lower[restriction.unknown_on_face(j)], node.lower[j]);
          EXPECT_EQ(face.upper[restriction.unknown_on_face(j)], node.upper[j]);
        }
    }
  }
}

// Polynomials with coefficients of few digits.
SC::Expression random_polynomial(const std::vector<SC::Expression>& unknowns, std::mt19937& random)
{
  std::uniform_int_distribution<int> number(-16, 16);
  SC::Expression result = SC::Expression(Rational(number(random), 16));
  for (const SC::Expression& x : unknowns) {
    result = result + Rational(number(random), 8) * x;
    for (const SC::Expression& y : unknowns)
      result = result + Rational(number(random), 16) * x * y;
  }
  return result;
}

// The node of a system on its domain, from the exact functions.
struct Whole_node
{
  System_layout layout;
  SC::internal::Exact_source source;
  SC::Summary summary;
  SC::internal::Node_analysis<double> analysis;

  explicit Whole_node(const SC::Constraint_system_d& system)
    : layout(system), source(system, layout), analysis(layout, source, summary, true)
  {}

  void write(const SC::Constraint_system_d& system, Node& node)
  {
    for (int j = 0; j < layout.dimension; ++j) {
      node.lower[j] = CGAL::to_double(system.domain(j).first);
      node.upper[j] = CGAL::to_double(system.domain(j).second);
    }
    analysis.rebuild(SC::internal::Cell(static_cast<std::size_t>(layout.dimension), 0), node);
    analysis.look_at(node);
  }
};

TEST(Layers, PointsAreAllThatTheSolverFinds)
{
  std::mt19937 random(2);
  int certain = 0, found = 0;
  for (int round = 0; round < 60; ++round) {
    auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
    const std::vector<SC::Expression> both{x, y};
    const SC::Constraint_system_d system =
        SC::make_system(std::array{random_polynomial(both, random) == 0, random_polynomial(both, random) == 0});
    Whole_node whole(system);
    Layer_points points(whole.layout);
    whole.write(system, points.node());
    const auto roots = points();
    if (!roots)
      continue;
    ++certain;
    const auto expected = SC::solve(system);
    ASSERT_TRUE(expected.is_complete());
    ASSERT_EQ(roots->size(), expected.size());
    for (const auto& solution : expected) {
      const auto box = solution.exact_box();
      std::size_t around = 0;
      for (const Layer_points::Root& root : *roots) {
        bool is_around = true;
        for (std::size_t j = 0; j < 2; ++j) {
          const auto& [least, most] = box[j];
          is_around = is_around && least <= Rational(root.box[j].second) && Rational(root.box[j].first) <= most;
          EXPECT_LE(root.region[j].first, root.box[j].first);
          EXPECT_LE(root.box[j].second, root.region[j].second);
          EXPECT_LT(root.box[j].second - root.box[j].first, 1e-10);
        }
        around += is_around ? 1 : 0;
      }
      EXPECT_EQ(around, 1u);
      ++found;
    }
  }
  EXPECT_GE(certain, 50);
  EXPECT_GE(found, 30);
}

// No point is on the boundary: what is found is a closed curve.
TEST(Layers, CurvesOnAPlaneThroughAnEllipsoid)
{
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 0});
  const SC::Constraint_system_d system =
      SC::make_system(std::array{square(x) + 2 * square(y - Rational(1, 8)) + 3 * square(z) + x * z == 1});
  Whole_node whole(system);
  ASSERT_TRUE(SC::internal::Layer_curves::fit(whole.layout));
  Node node;
  node.allocate(whole.layout);
  whole.write(system, node);
  SC::Solver_options options;
  SC::internal::Run_control control(options);
  SC::internal::Layer_curves curves(whole.layout, 2, options, control);
  curves.start(node); // z = 0: an ellipse
  for (const int unknown : {0, 1})
    for (const bool is_upper : {false, true})
      EXPECT_TRUE(curves.add_points_on_side(unknown, is_upper));
  EXPECT_TRUE(curves.points().empty());
  ASSERT_TRUE(curves.find_curves());
  ASSERT_FALSE(curves.pieces().empty());
  std::vector<int> ends(curves.points().size(), 0);
  for (const auto& piece : curves.pieces())
    for (const std::size_t end : piece.ends)
      ++ends[end];
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_EQ(ends[i], 2) << "a closed curve";
    const auto& box = curves.points()[i].box;
    const double a = box[0].first, b = box[1].first - 0.125;
    EXPECT_NEAR(a * a + 2 * b * b, 1, 1e-9);
  }
}

} // namespace

} // namespace layers_test
