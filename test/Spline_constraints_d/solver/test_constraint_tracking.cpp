// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Constraints that change with time, followed: an arm with two links through its singular position, with every point
// checked in exact numbers; regions that shrink to a point and vanish; places where relaxation does not help; random
// moving balls; splines of time; linked domains and their ranges; the cost of steps counted; the idioms; limits and bad
// input.

#include <CGAL/Spline_constraints_d/function/Graph_evaluation.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/constraint_idioms.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_tracker.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>

#include "linked_arm.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <sstream>
#include <vector>

namespace constraint_tracking_test {

namespace SC = CGAL::Spline_constraints;
using SC::Constraint;
using SC::Constraint_tracker;
using SC::Expression;
using SC::Tracking_status;
using SC::Tracking_step;
using SC::Vector_expression;
using Rational = SC::Exact_rational;
using Point = std::vector<Rational>;

namespace {

Rational fraction(int numerator, int denominator) { return Rational(numerator) / Rational(denominator); }

bool holds(const Constraint& constraint, const Point& point)
{
  for (const auto& condition : constraint.conditions)
    if (constraint.symbols->value(condition, point) == 0)
      return false;
  return is_satisfied(constraint.relation, CGAL::sign(constraint.symbols->value(constraint.function, point)));
}

// tan(angle / 2) of the first joint and, from the folded arm on, of the second one.
struct Arm
{
  std::vector<SC::Unknown> joints = SC::unknowns({{0, 4}, {-1, 1}, {0, 2}}),
                           hand = SC::unknowns({{-2, 2}, {-2, 2}, {0, 2}});
  Expression time = joints[2];
  Vector_expression<2> elbow = linked_arm::direction(joints[0]),
                       end = elbow - linked_arm::turned(elbow, linked_arm::direction(joints[1]));
};

} // namespace

// Pai's example 1: from (1,0) to (-1,0) within 1/20 of the line, through (0,0), where the arm is folded and the
// Jacobian of the hand by the joints is singular.
TEST(Constraint_tracking, arm_through_its_singularity)
{
  const Arm arm;
  const Expression &x = arm.hand[0], &y = arm.hand[1], &t = arm.hand[2];
  const Rational width = fraction(1, 20);
  Constraint_tracker tracker(arm.joints[2], {fraction(4, 7), fraction(4, 7), 0});
  tracker.link(arm.hand, {arm.end[0], arm.end[1], arm.time});
  tracker.add(y <= width);
  tracker.add(-y <= width);
  tracker.add(SC::pusher(x, 1, 1, t));
  Rational last_x = 2;
  int held = 0, repaired = 0;
  bool is_bent_left = false, is_bent_right = false;
  for (int k = 0; k <= 80; ++k) {
    const Rational now = fraction(k, 40);
    const Tracking_step step = tracker.advance(now);
    ASSERT_TRUE(step.has_point()) << step;
    held += step.status == Tracking_status::HELD;
    repaired += step.status == Tracking_status::REPAIRED;
    EXPECT_EQ(step.point[2], now);
    EXPECT_EQ(step.point, tracker.point());
    const auto [hand_x, hand_y] = arm.end(step.point);
    EXPECT_LE(hand_y * hand_y, width * width);
    EXPECT_LE(hand_x, 1 - now);
    EXPECT_LT(hand_x - last_x, fraction(1, 10));
    last_x = hand_x;
    is_bent_left = is_bent_left || step.point[1] > 0;
    is_bent_right = is_bent_right || step.point[1] < 0;
    // Products and quotients: U <= 2 sum c_i; all operations: less than 4 sum c_i.
    EXPECT_LE(step.gradients.multiplications, 2 * step.violated.multiplications);
    EXPECT_TRUE(step.violated.total() == 0 || step.gradients.total() < 4 * step.violated.total());
    EXPECT_LE(step.path.size(), 65u) << step;
  }
  EXPECT_EQ(held + repaired, 81);
  EXPECT_GT(repaired, 10);
  EXPECT_TRUE(is_bent_left && is_bent_right) << "the elbow goes through the folded position";
  const auto end = arm.end(tracker.point());
  EXPECT_LE(end[0], -1);

  // The second joint turns by a right angle at most, so that the hand is at most sqrt(2) away.
  const std::size_t farther = tracker.add(x <= fraction(-3, 2));
  EXPECT_EQ(tracker.advance(2).status, Tracking_status::INFEASIBLE);
  tracker.remove(farther);
  tracker.add(x <= fraction(-7, 5));
  const Tracking_step far = tracker.advance(2);
  ASSERT_TRUE(far.has_point()) << far;
  EXPECT_LE(arm.end(far.point)[0], fraction(-7, 5));
}

// Arms with many links: a domain for each elbow, so that no formula gets long.
TEST(Constraint_tracking, chains_of_domains)
{
  for (const int n : {3, 8}) {
    const linked_arm::Arm arm(n);
    Constraint_tracker tracker(arm.joints.back(), Point(n + 1, fraction(1, 10)), {.is_search_allowed = false});
    arm.link(tracker);
    const Rational width = fraction(1, 50);
    tracker.add(SC::toleranced_move(arm.end(), Vector_expression(n * (1 - arm.time()) / 2, 1 + arm.time()), width));
    EXPECT_LT(tracker.operations_of_check().total(), 60u * n);
    for (int k = 0; k <= 20; ++k) {
      const Tracking_step step = tracker.advance(fraction(k, 20));
      ASSERT_TRUE(step.has_point()) << n << ' ' << step;
      const auto [x, y] = arm.end(step.point);
      const Rational dx = x - n * (1 - step.time) / 2, dy = y - 1 - step.time;
      EXPECT_LE(dx * dx + dy * dy, width * width);
    }
  }
}

// The gradient of a lifted constraint is D l^T grad f.
TEST(Constraint_tracking, lifted_gradients)
{
  const Arm arm;
  const Expression f = square(arm.hand[0] - 1) * arm.hand[1] + arm.hand[2];
  SC::Expression_graph graph(3);
  const std::vector<SC::Expression_graph::Node> link{graph.node(arm.end[0]), graph.node(arm.end[1]), graph.unknown(2)};
  const auto lifted = graph.composition(f, link);
  auto nodes = graph.gradient(lifted);
  SC::Graph_evaluation<Rational> evaluation(graph, nodes);
  const Point joints{fraction(3, 4), 0, fraction(1, 2)}; // folded: D l is singular
  evaluation.set_point(joints);
  evaluation.evaluate();
  const auto end = arm.end(joints);
  EXPECT_EQ(end, (std::array<Rational, 2>{0, 0}));
  const Point image{end[0], end[1], joints[2]};
  std::array<std::array<Rational, 2>, 2> jacobian;
  for (int j = 0; j < 2; ++j) {
    Rational sum = 0;
    for (int i = 0; i < 2; ++i) {
      jacobian[i][j] = derivative(arm.end[i], arm.joints[j])(joints);
      sum += derivative(f, arm.hand[i])(image) * jacobian[i][j];
    }
    EXPECT_EQ(evaluation[nodes[j]], sum);
  }
  EXPECT_EQ(jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0], 0);
  EXPECT_EQ(evaluation[nodes[2]], 1);
}

TEST(Constraint_tracking, steps_of_the_relaxation)
{
  const auto [x, y, t] = SC::unknowns({-8, 8}, {-8, 8}, {0, 1});
  Constraint_tracker tracker(t, {3, 4, 0}, {.offset = 1 / 256.});
  tracker.add(square(x) + square(y) <= 1);
  const Tracking_step step = tracker.advance(0);
  EXPECT_EQ(step.status, Tracking_status::REPAIRED);
  // r <- (r^2 + 1) / (2 r) - delta, where half of the width of the domain is 8.
  double r = 5;
  int k = 0;
  for (const auto& point : step.path) {
    EXPECT_NEAR(std::hypot(point[0], point[1]), r, 1e-12);
    EXPECT_NEAR(point[0] * 4, point[1] * 3, 1e-12);
    r = (r * r + 1) / (2 * r) - 8 / 256. / (k++ < 4 ? 1 : 4);
  }
  EXPECT_GE(step.path.size(), 4u);
  EXPECT_EQ(step.values.total(), (step.path.size() - 1) * tracker.operations_of_check().total());
  EXPECT_EQ(tracker.advance(1).status, Tracking_status::HELD);
  std::ostringstream text;
  text << step;
  EXPECT_NE(text.str().find("time 0: repaired; "), std::string::npos);
}

// A disk that shrinks beside a wall: it touches it at the time 1/2, and not afterwards.
TEST(Constraint_tracking, regions_that_vanish)
{
  const auto [x, y, t] = SC::unknowns({-2, 2}, {-2, 2}, {0, 1});
  Constraint_tracker tracker(t, {1, 1, 0});
  tracker.add(SC::funnel(Vector_expression(x, y), Vector_expression(0, 0), 1 - t));
  tracker.add(x >= fraction(1, 2));
  for (int k = 0; k < 50; ++k) {
    const Tracking_step step = tracker.advance(fraction(k, 100));
    ASSERT_TRUE(step.has_point()) << step;
    EXPECT_LE(step.point[0] * step.point[0] + step.point[1] * step.point[1], (1 - step.time) * (1 - step.time));
    EXPECT_GE(step.point[0], fraction(1, 2));
  }
  const Tracking_step touching = tracker.advance(fraction(1, 2));
  EXPECT_EQ(touching.status, Tracking_status::FOUND);
  EXPECT_EQ(touching.point, (Point{fraction(1, 2), 0, fraction(1, 2)}));
  const Tracking_step none = tracker.advance(fraction(501, 1000));
  EXPECT_EQ(none.status, Tracking_status::INFEASIBLE);
  EXPECT_TRUE(none.is_complete());
  EXPECT_TRUE(none.point.empty());
  EXPECT_EQ(tracker.point(), touching.point);
  EXPECT_TRUE(tracker.advance(fraction(1, 4)).has_point()) << "back in time";
}

TEST(Constraint_tracking, where_relaxation_does_not_help)
{
  const auto [x, y, t] = SC::unknowns({-2, 2}, {-2, 2}, {0, 1});
  // No gradient at the start.
  Constraint_tracker tracker(t, {0, 0, 0});
  const std::size_t outside = tracker.add(square(x) + square(y) >= 1);
  const Tracking_step step = tracker.advance(0);
  EXPECT_EQ(step.status, Tracking_status::FOUND);
  EXPECT_GE(step.point[0] * step.point[0] + step.point[1] * step.point[1], 1);
  EXPECT_GT(step.summary().nodes, 0u);

  // The same without search.
  Constraint_tracker without(t, {0, 0, 0}, {.is_search_allowed = false});
  without.add(square(x) + square(y) >= 1);
  const Tracking_step nothing = without.advance(0);
  EXPECT_EQ(nothing.status, Tracking_status::NOT_FOUND);
  EXPECT_FALSE(nothing.is_complete());
  ASSERT_EQ(nothing.undecided().size(), 1u);
  EXPECT_EQ(nothing.undecided()[0].reason, "relaxation found nothing");

  // Constraints come and go.
  const std::size_t inside = tracker.add(square(x) + square(y) < 1);
  EXPECT_EQ(tracker.advance(0).status, Tracking_status::INFEASIBLE);
  tracker.remove(outside);
  EXPECT_TRUE(tracker.advance(0).has_point());
  tracker.remove(inside);
  EXPECT_THROW(tracker.advance(0), SC::Invalid_input);
  EXPECT_THROW(tracker.remove(inside), SC::Invalid_input);

  // A divisor that vanishes at the start: 1 / x says nothing there.
  Constraint_tracker divided(t, {0, 0, 0});
  divided.add(1 / x <= 1);
  const Tracking_step beside = divided.advance(0);
  ASSERT_TRUE(beside.has_point()) << beside;
  EXPECT_NE(beside.point[0], 0);
  EXPECT_LE(1 / beside.point[0], 1);
}

// Balls that move on parabolas, all of which hold one moving point.
TEST(Constraint_tracking, random_moving_balls)
{
  std::mt19937 random(7);
  const auto number = [&](int size) { return fraction(static_cast<int>(random() % (2 * size + 1)) - size, size); };
  int repaired = 0;
  for (int run = 0; run < 40; ++run) {
    const int n = 2 + run % 4;
    std::vector<std::array<SC::Bound, 2>> ranges(n, {-6, 6});
    ranges.push_back({0, 1});
    const auto x = SC::unknowns(ranges);
    const Expression& t = x[n];
    std::vector<Expression> planted;
    for (int i = 0; i < n; ++i)
      planted.push_back(number(20) + 2 * number(20) * t + 2 * number(20) * t * t);
    std::vector<Constraint> constraints;
    for (int k = 0; k < 2 * n; ++k) {
      Expression distance = 0;
      Rational offset = 0;
      for (int i = 0; i < n; ++i) {
        const Rational shift = number(10);
        distance += square(x[i] - planted[i] - shift);
        offset += shift * shift;
      }
      constraints.push_back(distance <= offset + fraction(1, 10));
    }
    Constraint_tracker tracker(x[n], Point(n + 1, 0));
    tracker.add(constraints);
    for (int k = 0; k <= 10; ++k) {
      const Tracking_step step = tracker.advance(fraction(k, 10));
      ASSERT_TRUE(step.has_point()) << run << ' ' << step;
      repaired += step.status == Tracking_status::REPAIRED;
      for (const Constraint& constraint : constraints)
        EXPECT_TRUE(holds(constraint, step.point));
    }
  }
  EXPECT_GT(repaired, 200);
}

// A hand follows a B-spline of the time, which is a coordinate of its domain.
TEST(Constraint_tracking, splines_of_time)
{
  using Function = SC::Bspline_function<Rational>;
  const std::vector<Rational> knots{0, 0, 0, 1, 2, 2, 2};
  const SC::Spline_map<1, 2> path(
      std::array<Function, 2>{Function({2}, {knots}, {0, 1, 0, 1}), Function({2}, {knots}, {0, 0, 1, 1})});
  const auto joints = SC::unknowns({{-3, 3}, {-3, 3}, {0, 2}});
  const auto hand = SC::unknowns({{-9, 9}, {-9, 9}, {0, 2}});
  Constraint_tracker tracker(joints[2], {0, 0, 0});
  tracker.link(hand, {joints[0] + joints[1] / 2, joints[1] - joints[0] / 3, joints[2]});
  const Rational tolerance = fraction(1, 100);
  tracker.add(SC::toleranced_move(Vector_expression(hand[0], hand[1]), path(hand[2]), tolerance));
  int repaired = 0;
  for (int k = 0; k <= 40; ++k) {
    const Tracking_step step = tracker.advance(fraction(k, 20));
    ASSERT_TRUE(step.has_point()) << step;
    repaired += step.status == Tracking_status::REPAIRED;
    const Point& p = step.point;
    const auto target = path(std::vector<Rational>{p[2]});
    const Rational dx = p[0] + p[1] / 2 - target[0], dy = p[1] - p[0] / 3 - target[1];
    EXPECT_LE(dx * dx + dy * dy, tolerance * tolerance);
  }
  EXPECT_GT(repaired, 30);
  // A spline of another unknown is none.
  Constraint_tracker other(joints[2], {0, 0, 0});
  const auto u = SC::unknowns({{0, 2}, {0, 1}});
  other.link(u, {joints[0], joints[1]});
  other.add(path(u[0])[0] <= 1);
  EXPECT_THROW(other.advance(0), SC::Invalid_input);
}

// Domains are linked in chains, and the ranges of their unknowns hold.
TEST(Constraint_tracking, ranges_of_linked_domains)
{
  const auto base = SC::unknowns({{-4, 4}, {0, 1}});
  const auto middle = SC::unknowns({{-9, 9}, {0, 1}}), last = SC::unknowns({{-3, 2}, {-1, 3}});
  Constraint_tracker tracker(base[1], {0, 0});
  tracker.link(middle, {square(base[0]) - 1, base[1]});
  tracker.link(last, {middle[0] * 2, middle[1]});
  tracker.add(last[0] >= 2 * last[1]);
  for (int k = 0; k < 10; ++k) {
    const Tracking_step step = tracker.advance(fraction(k, 10));
    ASSERT_TRUE(step.has_point()) << step;
    const Rational value = 2 * (step.point[0] * step.point[0] - 1);
    EXPECT_GE(value, 2 * step.time);
    EXPECT_LE(value, 2);
  }
  // At the time 1 exactly one value is left, and the point is irrational.
  const Tracking_step irrational = tracker.advance(1);
  EXPECT_EQ(irrational.status, Tracking_status::NOT_FOUND);
  ASSERT_EQ(irrational.undecided().size(), 1u);
  EXPECT_EQ(irrational.undecided()[0].reason, "a point exists, but no rational one was found");
}

// An unknown that is the time in a roundabout way has its range, too.
TEST(Constraint_tracking, ranges_of_the_time)
{
  const auto base = SC::unknowns({{-4, 4}, {0, 1}}), middle = SC::unknowns({{-4, 4}, {-1, 1}}),
             last = SC::unknowns({{-4, 4}, {0, fraction(1, 2)}});
  Constraint_tracker tracker(base[1], {0, 0});
  tracker.link(middle, {base[0], -base[1]});
  tracker.link(last, {middle[0], -middle[1]});
  tracker.add(last[0] >= last[1]);
  EXPECT_TRUE(tracker.advance(0.5).has_point());
  EXPECT_EQ(tracker.advance(0.75).status, Tracking_status::INFEASIBLE);
}

// U is at most twice the sum of the costs of the violated constraints, but not of the check, as they share it.
TEST(Constraint_tracking, cost_of_shared_constraints)
{
  const int n = 12, count = 10;
  std::vector<std::array<SC::Bound, 2>> ranges(n, {-1, 1});
  ranges.push_back({0, 1});
  const auto x = SC::unknowns(ranges);
  const auto y = SC::unknowns({{-1, 1}, {0, 1}});
  Expression product = x[0];
  for (int i = 1; i < n; ++i)
    product *= x[i];
  Constraint_tracker tracker(x[n], Point(n + 1, fraction(3, 4)), {.most_steps = 1, .is_search_allowed = false});
  tracker.link(y, {product, x[n]});
  for (int k = 0; k < count; ++k)
    tracker.add(square(y[0] + 2 + k) <= 1);
  const Tracking_step step = tracker.advance(0);
  EXPECT_LE(step.gradients.multiplications, 2 * step.violated.multiplications);
  EXPECT_LT(step.gradients.total(), 4 * step.violated.total());
  EXPECT_EQ(step.values.multiplications, static_cast<std::size_t>(n - 1 + count));
  EXPECT_EQ(step.violated.multiplications, static_cast<std::size_t>(n * count));
  EXPECT_EQ(step.gradients.multiplications, 220u) << "ten times the check, which has 21";
}

TEST(Constraint_tracking, idioms)
{
  const auto [x, y, t] = SC::unknowns({-9, 9}, {-9, 9}, {0, 4});
  const Vector_expression p(x, y), c(1, t);
  const auto range = SC::interval(x, -1, t);
  EXPECT_TRUE(holds(range[0], {-1, 0, 0}) && !holds(range[0], {-2, 0, 0}));
  EXPECT_TRUE(holds(range[1], {2, 0, 2}) && !holds(range[1], {2, 0, 1}));
  const Constraint pusher = SC::pusher(x, 1, 2, t);
  EXPECT_TRUE(holds(pusher, {-1, 0, 1}) && !holds(pusher, {fraction(-9, 10), 0, 1}));
  const auto funnel = SC::funnel(p, c, 2 - t);
  EXPECT_TRUE(holds(funnel[0], {2, 1, 1}) && !holds(funnel[0], {fraction(21, 10), 1, 1}));
  EXPECT_TRUE(holds(funnel[1], {1, 2, 2}) && !holds(funnel[1], {1, 3, 3})) << "empty after the time 2";
  const Constraint move = SC::toleranced_move(p, c, fraction(1, 2));
  EXPECT_TRUE(holds(move, {1, fraction(5, 2), 2}) && !holds(move, {1, fraction(13, 5), 2}));
  for (const Constraint& region : {x * y<1, x * y <= 1, x * y> 1, x * y >= 1})
    for (const Point& point : {Point{1, 1, 0}, Point{2, 1, 0}, Point{0, 1, 0}})
      EXPECT_NE(holds(region, point), holds(SC::obstacle(region), point)) << region;
  EXPECT_THROW(SC::obstacle(x == 1), SC::Invalid_input);
  EXPECT_THROW(SC::obstacle(x != 1), SC::Invalid_input);
  EXPECT_THROW(SC::toleranced_move(p, c, -1), SC::Invalid_input);
}

TEST(Constraint_tracking, limits)
{
  struct Stop
  {
    void on_box(const SC::Node_view&) {}
    void on_progress(double) {}
    bool stop() const { return true; }
  } stop;
  std::vector<std::array<SC::Bound, 2>> ranges(9, {-1, 1});
  ranges.push_back({0, 1});
  const auto x = SC::unknowns(ranges);
  Expression sum = 0;
  for (int i = 0; i < 9; ++i)
    sum += x[i];
  const auto add = [&](Constraint_tracker& tracker) { // far from convex: no sum of nine signs is zero
    for (int i = 0; i < 9; ++i)
      tracker.add(square(x[i]) >= fraction(81, 100));
    tracker.add(square(sum) <= fraction(1, 1000));
  };
  Constraint_tracker stopped(x[9], Point(10, 0), {.search = {.tolerance = 1e-6, .visitor = stop}});
  add(stopped);
  const Tracking_step at_once = stopped.advance(0);
  EXPECT_EQ(at_once.status, Tracking_status::NOT_FOUND);
  EXPECT_FALSE(at_once.undecided().empty());
  EXPECT_EQ(at_once.summary().why_not, SC::Undecided_reason::STOPPED);
  Constraint_tracker short_search(x[9], Point(10, 0), {.search = {.tolerance = 1e-6, .node_limit = 30}});
  add(short_search);
  const Tracking_step few = short_search.advance(0);
  EXPECT_EQ(few.status, Tracking_status::NOT_FOUND);
  EXPECT_FALSE(few.undecided().empty());
  EXPECT_LE(few.summary().nodes, 40u);
  Constraint_tracker timed(x[9], Point(10, 0), {.search = {.tolerance = 1e-6, .time_limit = 0.05}});
  add(timed);
  EXPECT_LT(timed.advance(0).summary().seconds, 0.35);
}

TEST(Constraint_tracking, bad_input)
{
  const auto [x, y, t] = SC::unknowns({-2, 2}, {-2, 2}, {0, 1});
  const auto hand = SC::unknowns({{-1, 1}, {0, 1}});
  const auto alone = SC::unknowns({{0, 1}});
  EXPECT_THROW(Constraint_tracker(t, {0, 0}), SC::Invalid_input);
  EXPECT_THROW(Constraint_tracker(alone[0], {0}), SC::Invalid_input);
  EXPECT_THROW(Constraint_tracker(t, {0, 0, 0}, {.relaxation = 0}), SC::Invalid_input);
  EXPECT_THROW(Constraint_tracker(t, {0, 0, 0}, {.relaxation = 2.5}), SC::Invalid_input);
  EXPECT_THROW(Constraint_tracker(t, {0, 0, 0}, {.offset = 0}), SC::Invalid_input);
  EXPECT_THROW(Constraint_tracker(t, {0, 0, 0}, {.offset = std::nan("")}), SC::Invalid_input);
  EXPECT_THROW(Constraint_tracker(t, {0, 0, 0}, {.search = {.tolerance = -1}}), SC::Invalid_input);
  Constraint_tracker tracker(t, {5, -7, 0});
  EXPECT_EQ(tracker.point(), (Point{2, -2, 0})) << "moved into the domain";
  EXPECT_THROW(tracker.advance(0), SC::Invalid_input);
  EXPECT_THROW(tracker.operations_of_check(), SC::Invalid_input);
  EXPECT_THROW(tracker.add(x == y), SC::Invalid_input);
  EXPECT_THROW(tracker.add(Expression(1) <= 2), SC::Invalid_input);
  EXPECT_THROW(tracker.add(hand[0] <= 0), SC::Invalid_input);
  EXPECT_THROW(tracker.remove(0), SC::Invalid_input);
  EXPECT_THROW(tracker.link(hand, {x}), SC::Invalid_input);
  EXPECT_THROW(tracker.link(std::vector{hand[0]}, {x}), SC::Invalid_input);
  EXPECT_THROW(tracker.link(std::vector{hand[1], hand[0]}, {x, y}), SC::Invalid_input);
  EXPECT_THROW(tracker.link(hand, {hand[0], y}), SC::Invalid_input);
  EXPECT_THROW(tracker.link(std::vector{x, y, t}, {x, y, t}), SC::Invalid_input);
  const auto too_short = SC::unknowns({{-1, 1}, {0, fraction(1, 2)}});
  EXPECT_THROW(tracker.link(too_short, {x, t}), SC::Invalid_input);
  tracker.link(hand, {x, t});
  EXPECT_THROW(tracker.link(hand, {x, t}), SC::Invalid_input);
  tracker.add(hand[0] <= 0);
  EXPECT_THROW(tracker.advance(2), SC::Invalid_input);
  EXPECT_THROW(tracker.advance(std::nan("")), SC::Invalid_input);
  EXPECT_TRUE(tracker.advance(1).has_point());
  tracker.add(sin(x) + y <= t);
  EXPECT_THROW(tracker.advance(1), SC::Invalid_input) << "elementary functions";
}

} // namespace constraint_tracking_test
