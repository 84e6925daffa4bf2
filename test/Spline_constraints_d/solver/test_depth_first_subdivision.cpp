// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The driver of the solver with an examiner that has nothing but what the driver may ask for.

#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Depth_first_subdivision.h>

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

namespace depth_first_subdivision_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::internal::Box_split;
using SC::internal::Box_verdict;
using SC::internal::System_layout;
using Node = SC::internal::Box_node<double>;

// One linear function of two unknowns.
System_layout layout_of_linear_function()
{
  System_layout layout;
  layout.dimension = 2;
  layout.equalities = layout.functions = 1;
  auto& block = layout.blocks.emplace_back();
  block.axes = {0, 1};
  block.degrees = {1, 1};
  block.functions = {0};
  block.points = 4;
  layout.place_blocks();
  return layout;
}

struct Box
{
  double lower[2], upper[2];

  double area() const { return (upper[0] - lower[0]) * (upper[1] - lower[1]); }
};

// Splits boxes along the axes in turns until they are thin, looks twice at those of one half, and puts aside what is
// left after a number of looks.
struct Halving
{
  struct State
  {
    Box box;
    int looks = 0;

    // neither is asked for by the driver
    State() = delete;
    explicit State(const Box& b) : box(b) {}
  };

  int looks_left;
  double least_width;
  std::vector<Box> done = {}, pending = {};
  int depth_of_done = 0;

  bool goes_on(Node& node, State& state, int)
  {
    for (int j = 0; j < 2; ++j) {
      EXPECT_EQ(node.lower[j], state.box.lower[j]);
      EXPECT_EQ(node.upper[j], state.box.upper[j]);
    }
    if (looks_left-- > 0)
      return true;
    pending.push_back(state.box);
    return false;
  }

  Box_verdict examine(Node& node, State& state, int depth)
  {
    if (node.lower[0] >= 0.5 && state.looks++ == 0)
      return Box_verdict::AGAIN;
    if (node.upper[0] - node.lower[0] > least_width)
      return Box_verdict::SPLIT;
    done.push_back(state.box);
    depth_of_done = depth;
    return Box_verdict::DONE;
  }

  std::optional<Box_split<State>> split(Node&, State& state, int depth)
  {
    const int axis = depth % 2;
    State lower(state.box), upper(state.box);
    lower.box.upper[axis] = upper.box.lower[axis] = (state.box.lower[axis] + state.box.upper[axis]) / 2;
    return Box_split<State>{axis, 0.5, std::move(lower), std::move(upper)};
  }
};

Halving subdivided(int looks, double least_width)
{
  const System_layout layout = layout_of_linear_function();
  SC::internal::Depth_first_subdivision<double> driver(layout);
  driver.root().lower = {0, 0};
  driver.root().upper = {1, 1};
  Halving examiner{looks, least_width};
  driver.run(examiner, Halving::State({{0, 0}, {1, 1}}), 0);
  return examiner;
}

double area(const std::vector<Box>& boxes)
{
  double sum = 0;
  for (const Box& box : boxes)
    sum += box.area();
  return sum;
}

TEST(DepthFirstSubdivision, AllPartsAreFinishedOnce)
{
  const Halving all = subdivided(1000, 0.25);
  EXPECT_EQ(all.done.size(), 8u);   // a quarter wide, half as high
  EXPECT_EQ(area(all.done), 1);
  EXPECT_TRUE(all.pending.empty());
  EXPECT_EQ(all.depth_of_done, 3);
  EXPECT_EQ(all.looks_left, 1000 - 15 - 7);   // 15 boxes, and those on the right again: 1, 2 and 4
  for (std::size_t i = 0; i < all.done.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_TRUE(all.done[i].lower[0] != all.done[k].lower[0] || all.done[i].lower[1] != all.done[k].lower[1]);
  EXPECT_EQ(all.done.front().lower[0], 0.75);   // upper parts first
  EXPECT_EQ(all.done.front().lower[1], 0.5);
  EXPECT_EQ(all.done.back().lower[0], 0);
}

TEST(DepthFirstSubdivision, NothingIsLostWhenTheBudgetEnds)
{
  for (int looks = 0; looks < 25; ++looks) {
    const Halving some = subdivided(looks, 0.25);
    EXPECT_EQ(area(some.done) + area(some.pending), 1) << looks;
    EXPECT_EQ(some.pending.empty(), looks >= 22) << looks;
  }
}

} // namespace

} // namespace depth_first_subdivision_test
