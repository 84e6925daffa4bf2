// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Equations that can be solved block by block: the blocks of planted ones are found, in an order that can be solved and
// in which large ones are not solved anew for small ones that they do not need; linkages of which each joint has two
// places for each place of the one before.

#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>

#include "random_systems.h"
#include "solver_test_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace blocks_test {

namespace SC = CGAL::Spline_constraints;
using namespace solver_test;
using SC::Power_polynomial;
using SC::Relation;
using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;

namespace {

SC::internal::Block_order order_of(int dimension, const Constraints& constraints)
{
  const SC::internal::Sparse_system system(dimension, constraints, [] {});
  return SC::internal::Block_order(system);
}

// Blocks of the given sizes, each a cycle of squares, with products of unknowns of other blocks before; unknowns and
// equalities are shuffled. Tells the planted block of each unknown.
Constraints planted_blocks(const std::vector<int>& sizes, std::mt19937& engine, std::vector<int>& block_of)
{
  const int dimension = std::accumulate(sizes.begin(), sizes.end(), 0);
  std::vector<int> name(dimension);
  std::iota(name.begin(), name.end(), 0);
  std::shuffle(name.begin(), name.end(), engine);
  block_of.resize(dimension);
  const auto unknown = [&](int place) { return Power_polynomial::variable(name[place]); };
  Constraints result;
  int first = 0;
  for (int b = 0; b < static_cast<int>(sizes.size()); first += sizes[b++])
    for (int k = 0; k < sizes[b]; ++k) {
      const Power_polynomial own = unknown(first + k);
      block_of[name[first + k]] = b;
      Power_polynomial f = own * own + unknown(first + (k + 1) % sizes[b]) - 3;
      if (first > 0 && engine() % 2 == 0)
        f += own * unknown(static_cast<int>(engine() % first));
      result.emplace_back(f, Relation::EQUAL);
    }
  std::shuffle(result.begin(), result.end(), engine);
  return result;
}

} // namespace

TEST(BlocksOfEquations, planted)
{
  std::mt19937 engine(5630);
  std::size_t needs = 0;
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    std::vector<int> sizes;
    for (int b = 0; b < 1 + round % 7; ++b)
      sizes.push_back(1 + static_cast<int>(engine() % 5));
    std::vector<int> block_of;
    const Constraints constraints = planted_blocks(sizes, engine, block_of);
    const int dimension = static_cast<int>(constraints.size());
    const auto order = order_of(dimension, constraints);
    ASSERT_EQ(order.blocks().size(), sizes.size());
    std::set<int> equalities;
    for (std::size_t b = 0; b < order.blocks().size(); ++b) {
      const auto& block = order.blocks()[b];
      ASSERT_FALSE(block.unknowns().empty());
      EXPECT_EQ(block.unknowns().size(), block.equalities().size());
      EXPECT_EQ(static_cast<int>(block.unknowns().size()), sizes[block_of[block.unknowns().front()]]);
      for (const int j : block.unknowns()) {
        EXPECT_EQ(order.block(j), static_cast<int>(b));
        EXPECT_EQ(block_of[j], block_of[block.unknowns().front()]);
      }
      for (const int i : block.equalities()) {
        EXPECT_TRUE(equalities.insert(i).second);
        for (const int j : constraints[i].first.variables()) {
          EXPECT_LE(order.block(j), static_cast<int>(b));
          needs += order.block(j) < static_cast<int>(b);
        }
      }
    }
    EXPECT_EQ(static_cast<int>(equalities.size()), dimension);
  }
  EXPECT_GT(needs, 100u);
}

// A block of three and one of one need the same unknown: the latter, though it is named first, is solved last.
TEST(BlocksOfEquations, large_ones_first)
{
  const Power_polynomial a = Power_polynomial::variable(0), x = Power_polynomial::variable(1);
  const Power_polynomial u = Power_polynomial::variable(2), v = Power_polynomial::variable(3),
                         w = Power_polynomial::variable(4);
  const auto order = order_of(5,
                              {{a * a - x, Relation::EQUAL},
                               {x * x - 2, Relation::EQUAL},
                               {u * v - x, Relation::EQUAL},
                               {v * w - x, Relation::EQUAL},
                               {u + w * w - 3, Relation::EQUAL}});
  ASSERT_EQ(order.blocks().size(), 3u);
  EXPECT_EQ(order.blocks()[0].unknowns(), std::vector<int>{1});
  EXPECT_EQ(order.blocks()[1].unknowns(), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(order.blocks()[2].unknowns(), std::vector<int>{0});
}

// Without a matching, or with more or fewer equalities, all is one block with all equalities, but no inequality.
TEST(BlocksOfEquations, one_block)
{
  const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1),
                         z = Power_polynomial::variable(2);
  const Constraints without_matching{{x - 1, Relation::EQUAL}, {x * x - 1, Relation::EQUAL}, {y - z, Relation::EQUAL}};
  const Constraints too_many{{x - 1, Relation::EQUAL},
                             {y - 1, Relation::EQUAL},
                             {z, Relation::GREATER},
                             {x * y - 1, Relation::EQUAL},
                             {z * z - 1, Relation::EQUAL}};
  const Constraints too_few{{x - 1, Relation::EQUAL}, {y - 1, Relation::EQUAL}};
  for (const Constraints& constraints : {without_matching, too_many, too_few}) {
    const auto order = order_of(3, constraints);
    ASSERT_EQ(order.blocks().size(), 1u);
    EXPECT_EQ(order.blocks().front().unknowns(), (std::vector<int>{0, 1, 2}));
    std::vector<int> equalities;
    for (std::size_t i = 0; i < constraints.size(); ++i)
      if (constraints[i].second == Relation::EQUAL)
        equalities.push_back(static_cast<int>(i));
    EXPECT_EQ(order.blocks().front().equalities(), equalities);
  }
}

// Joints at known distances from the origin and from the joint before, which leaves two places each: the numbers of
// places are known, and one of them all.
TEST(BlocksOfEquations, linkages)
{
  Random_numbers random(5631);
  for (const int joints : {1, 3, 5, 7}) {
    SCOPED_TRACE(joints);
    Rational x(3), y(0);
    Power_polynomial last_x(x), last_y(y);
    Constraints constraints;
    Point known;
    for (int k = 0; k < joints; ++k) {
      // turned from the one before, and longer or shorter
      const Rational t = Rational(random.integer(2, 9)) / 10, length = Rational(random.integer(6, 14)) / 10;
      const Rational cosine = length * (1 - t * t) / (1 + t * t), sine = length * 2 * t / (1 + t * t);
      const Rational next_x = cosine * x - sine * y, next_y = sine * x + cosine * y;
      const Rational radius = next_x * next_x + next_y * next_y;
      const Rational distance = (next_x - x) * (next_x - x) + (next_y - y) * (next_y - y);
      const Power_polynomial own_x = Power_polynomial::variable(2 * k), own_y = Power_polynomial::variable(2 * k + 1);
      constraints.emplace_back(pow(own_x, 2) + pow(own_y, 2) - radius, Relation::EQUAL);
      constraints.emplace_back(pow(own_x - last_x, 2) + pow(own_y - last_y, 2) - distance, Relation::EQUAL);
      x = next_x;
      y = next_y;
      last_x = own_x;
      last_y = own_y;
      known.push_back(x);
      known.push_back(y);
    }
    EXPECT_EQ(order_of(2 * joints, constraints).blocks().size(), static_cast<std::size_t>(joints));
    const std::vector<SC::Constraint_system_d::Domain> domain(2 * joints,
                                                              {Rational(-1000000000), Rational(1000000000)});
    const auto solutions = SC::Propagation_solver_d()(domain, constraints);
    EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
    EXPECT_EQ(solutions.count(SC::Solution_kind::CERTIFIED), std::size_t(1) << joints);
    EXPECT_EQ(solutions.size(), std::size_t(1) << joints);
    expect_consistent_regions(solutions);
    std::size_t holders = 0;
    for (const auto& solution : solutions)
      holders += meets(solution.exact_box(), known);
    EXPECT_EQ(holders, 1u);
    // one split, and a few more, for each joint of each of them
    EXPECT_LT(solutions.summary().nodes, 10u * (std::size_t(1) << joints));
  }
}

} // namespace blocks_test
