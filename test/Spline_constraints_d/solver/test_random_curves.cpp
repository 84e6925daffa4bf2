// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// 500 random curves in three unknowns, beside a sweep of a plane: f(x,y) = 0 is lifted to z = q(x,y), and both
// equations are mixed. The sweep knows of the curve only its fibers, its vertical tangents and where it meets the sides
// of the square, from the solver for points.

#include "curve_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

namespace random_curves_test {

using Rational = SC::Exact_rational;
using SC::Power_polynomial;

namespace {

struct Counts
{
  std::size_t closed = 0, open = 0;
};

// Curves in the square [-1,1]^2, by a sweep along x.
class Sweep
{
  struct Event
  {
    double x, y;   // y = -1 or 1: the curve enters or leaves there; else two branches meet
  };

  const Power_polynomial& m_f;
  std::vector<Event> m_events;
  std::vector<std::vector<std::size_t>> m_fibers;   // branches from below, before and behind each event
  std::vector<std::size_t> m_parent, m_ends;        // of branches

public:
  explicit Sweep(const Power_polynomial& f) : m_f(f) {}

  // Nothing if events are too close to each other.
  std::optional<Counts> operator()()
  {
    if (!find_events() || !make_fibers())
      return std::nullopt;
    for (std::size_t e = 0; e < m_events.size(); ++e)
      if (!connect(m_events[e], m_fibers[e], m_fibers[e + 1]))
        return std::nullopt;
    for (const std::size_t branch : m_fibers.front())
      ++m_ends[branch];
    for (const std::size_t branch : m_fibers.back())
      ++m_ends[branch];
    return counted();
  }

  // Where the curves meet the sides of the square. \pre The sweep has a result.
  std::vector<std::array<double, 2>> boundary_points() const
  {
    std::vector<std::array<double, 2>> result;
    for (const Event& event : m_events)
      if (std::abs(event.y) == 1)
        result.push_back({event.x, event.y});
    for (const double x : {-1.0, 1.0})
      for (const double y : roots_at(x))
        result.push_back({x, y});
    return result;
  }

private:
  static SC::Constraint_system_d system(int dimension, const std::vector<Power_polynomial>& equations)
  {
    SC::Constraint_system_d result(
        std::vector<SC::Constraint_system_d::Domain>(static_cast<std::size_t>(dimension), {-1, 1}));
    for (const Power_polynomial& equation : equations)
      result.add(equation, SC::Relation::EQUAL);
    return result;
  }

  static Power_polynomial variable(int i) { return Power_polynomial::variable(i); }

  bool find_events()
  {
    for (const int side : {-1, 1}) {
      const auto points = SC::solve(system(1, {m_f.substituted(1, Power_polynomial(Rational(side)))}));
      for (const auto& point : points)
        m_events.push_back({point.point()[0], static_cast<double>(side)});
      if (points.count(SC::Solution_kind::CERTIFIED) != points.size())
        return false;
    }
    const auto points = SC::solve(system(2, {m_f, m_f.derivative(1)}));
    for (const auto& point : points)
      m_events.push_back({point.point()[0], point.point()[1]});
    std::sort(m_events.begin(), m_events.end(), [](const Event& a, const Event& b) { return a.x < b.x; });
    bool is_apart = points.is_complete() && points.count(SC::Solution_kind::CERTIFIED) == points.size();
    double before = -1;
    for (const Event& event : m_events) {
      is_apart = is_apart && event.x - before > 1e-5 && event.x < 1 - 1e-5;
      before = event.x;
    }
    return is_apart;
  }

  std::vector<double> roots_at(double x) const
  {
    std::vector<double> result;
    for (const auto& root :
         SC::solve(system(1, {m_f.substituted(0, Power_polynomial(Rational(x))).substituted(1, variable(0))})))
      result.push_back(root.point()[0]);
    return result;
  }

  bool make_fibers()
  {
    double before = -1;
    for (std::size_t e = 0; e <= m_events.size(); ++e) {
      const double next = e < m_events.size() ? m_events[e].x : 1;
      m_fibers.emplace_back();
      for (std::size_t i = roots_at(0.5 * (before + next)).size(); i > 0; --i) {
        m_fibers.back().push_back(m_parent.size());
        m_parent.push_back(m_parent.size());
      }
      before = next;
    }
    m_ends.assign(m_parent.size(), 0);
    return true;
  }

  // Branches below the event go on in the same order, and those above.
  bool connect(const Event& event, const std::vector<std::size_t>& before, const std::vector<std::size_t>& behind)
  {
    const bool is_begin = before.size() < behind.size();
    const std::vector<std::size_t>&fewer = is_begin ? before : behind, &more = is_begin ? behind : before;
    const bool is_side = std::abs(event.y) == 1;
    const std::size_t difference = is_side ? 1 : 2;
    if (more.size() - fewer.size() != difference)
      return false;
    std::size_t below = event.y == 1 ? fewer.size() : 0;
    if (!is_side)
      for (const double y : roots_at(event.x + (is_begin ? -1e-8 : 1e-8))) {
        if (std::abs(y - event.y) < 2e-3)
          return false;
        below += y < event.y;
      }
    for (std::size_t i = 0; i < fewer.size(); ++i)
      unite(fewer[i], more[i < below ? i : i + difference]);
    is_side ? static_cast<void>(++m_ends[more[below]]) : unite(more[below], more[below + 1]);
    return true;
  }

  std::size_t root(std::size_t branch) const
  {
    while (m_parent[branch] != branch)
      branch = m_parent[branch];
    return branch;
  }

  void unite(std::size_t a, std::size_t b) { m_parent[root(a)] = root(b); }

  Counts counted() const
  {
    std::vector<std::size_t> ends(m_parent.size(), 0);
    for (std::size_t i = 0; i < ends.size(); ++i)
      ends[root(i)] += m_ends[i];
    Counts result;
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (root(i) == i)
        ++(ends[i] == 0 ? result.closed : result.open);
    return result;
  }
};

Power_polynomial random_polynomial(int degree, int size, std::mt19937& random)
{
  std::uniform_int_distribution<int> coefficient(-size, size);
  Power_polynomial result;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      Power_polynomial term(Rational(coefficient(random)));
      for (int k = 0; k < i; ++k)
        term = term * Power_polynomial::variable(0);
      for (int k = 0; k < j; ++k)
        term = term * Power_polynomial::variable(1);
      result = result + term;
    }
  return result;
}

// Two circles that are deformed: most often closed curves.
Power_polynomial random_ovals(std::mt19937& random)
{
  std::uniform_int_distribution<int> centre(-6, 6), square_of_radius(5, 40);
  const auto circle = [&] {
    const Power_polynomial x = Power_polynomial::variable(0) - Power_polynomial(Rational(centre(random), 10)),
                           y = Power_polynomial::variable(1) - Power_polynomial(Rational(centre(random), 10));
    return x * x + y * y - Power_polynomial(Rational(square_of_radius(random), 100));
  };
  return Power_polynomial(Rational(100)) * circle() * circle() +
      Power_polynomial(Rational(1, 10)) * random_polynomial(3, 9, random);
}

} // namespace

// Each of these points in the plane is below or above one end of an open curve, and there are no other ends.
void expect_ends(const SC::Curve_solution_set_d& set, const std::vector<std::array<double, 2>>& expected)
{
  std::vector<std::array<double, 2>> ends;
  for (const SC::Solution_curve& curve : set.curves())
    if (!curve.is_closed)
      for (const std::size_t i : {curve.pieces.front().ends[0], curve.pieces.back().ends[1]}) {
        const std::vector<double> point = set.vertices()[i].point();
        ends.push_back({point[0], point[1]});
      }
  ASSERT_EQ(ends.size(), expected.size());
  for (const auto& [x, y] : expected)
    EXPECT_EQ(std::count_if(ends.begin(), ends.end(),
                            [x = x, y = y](const auto& end) { return std::hypot(end[0] - x, end[1] - y) < 1e-9; }),
              1);
}

TEST(Random_curves, numbers_and_ends_of_curves_in_three_unknowns)
{
  std::mt19937 random(2026);
  std::size_t compared = 0, closed = 0, open = 0;
  for (int trial = 0; trial < 540 && compared < 500; ++trial) {
    const Power_polynomial f = trial % 3 == 0 ? random_ovals(random) : random_polynomial(2 + trial % 3, 30, random),
                           q = random_polynomial(2, 3, random);
    Sweep sweep(f);
    const std::optional<Counts> expected = sweep();
    if (!expected)
      continue;
    ++compared;
    closed += expected->closed;
    open += expected->open;
    const Power_polynomial lift = Power_polynomial::variable(2) - q, x = Power_polynomial::variable(0);
    // |q| <= 18
    SC::Constraint_system_d system(std::vector<SC::Constraint_system_d::Domain>{{-1, 1}, {-1, 1}, {-20, 20}});
    system.add(f + x * lift, SC::Relation::EQUAL);
    system.add(lift + Power_polynomial(Rational(1, 8)) * (f + x * lift), SC::Relation::EQUAL);
    const auto set = SC::solve_curves(system);
    expect_curves(set, expected->closed, expected->open, std::to_string(trial));
    expect_ends(set, sweep.boundary_points());
  }
  EXPECT_EQ(compared, 500u);
  EXPECT_GT(closed, 100u);
  EXPECT_GT(open, 500u);
}

} // namespace random_curves_test
