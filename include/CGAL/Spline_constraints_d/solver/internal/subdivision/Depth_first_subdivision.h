// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_DEPTH_FIRST_SUBDIVISION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_DEPTH_FIRST_SUBDIVISION_H

#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What comes of looking at a box.
enum class Box_verdict
{
  DONE,    // nothing is left to do
  AGAIN,   // it has changed
  SPLIT
};

// Where a box is split, and what is known of its parts.
template <class State>
struct Box_split
{
  int axis;
  double place;   // between the ends of the box
  State lower, upper;
};

// Says what becomes of boxes. `State` is what it knows of one.
template <class Examiner, class Node>
concept BoxExaminer = requires(Examiner examiner, Node& node, typename Examiner::State& state, int depth) {
  { examiner.goes_on(node, state, depth) } -> std::same_as<bool>;   // counts the box, or puts it aside
  { examiner.examine(node, state, depth) } -> std::same_as<Box_verdict>;
  // none: the box is left as it is, and that is noted
  { examiner.split(node, state, depth) } -> std::same_as<std::optional<Box_split<typename Examiner::State>>>;
};

/*
The driver of the solver, for points and for curves of solutions: subdivides a box depth-first. The nodes, one for each
level, are made once.
*/
template <class Number_type>
class Depth_first_subdivision
{
  using Node = Box_node<Number_type>;

  const System_layout& m_layout;
  std::deque<Node> m_nodes;   // one per level: references stay valid while it grows

public:
  explicit Depth_first_subdivision(const System_layout& layout) : m_layout(layout) {}

  // The node that the box to begin with is written to.
  Node& root() { return level(0); }

  template <BoxExaminer<Node> Examiner>
  void run(Examiner& examiner, typename Examiner::State state, int depth)
  {
    subdivide(examiner, 0, std::move(state), depth);
  }

private:
  Node& level(std::size_t index)
  {
    while (m_nodes.size() <= index)
      m_nodes.emplace_back().allocate(m_layout);
    return m_nodes[index];
  }

  // The lower part of a split stays in its place, the upper part goes one level up and is finished first.
  template <class Examiner>
  void subdivide(Examiner& examiner, std::size_t index, typename Examiner::State state, int depth)
  {
    Node& node = level(index);
    while (examiner.goes_on(node, state, depth)) {
      const Box_verdict verdict = examiner.examine(node, state, depth);
      if (verdict == Box_verdict::DONE)
        return;
      if (verdict == Box_verdict::AGAIN)
        continue;
      auto parts = examiner.split(node, state, depth);
      if (!parts)
        return;
      node.split(m_layout, parts->axis, parts->place, level(index + 1));
      subdivide(examiner, index + 1, std::move(parts->upper), ++depth);
      state = std::move(parts->lower);
    }
  }
};

// When a box shrinks to a part of it. No axis becomes a small part of its width at once: one that collapses would hide
// the others.
struct Box_contraction
{
  static constexpr double least_gain = 0.1, thinnest = 0x1p-10;

  // Makes the part as wide as it has to be. `least_share(j)`: of the width of axis j.
  template <std::invocable<int> Least_share>
  static void widen(Local_box& part, const Least_share& least_share)
  {
    for (int j = 0; j < part.dimension(); ++j)
      part.widen(j, (std::max)(thinnest, least_share(j)));
  }

  // Whether the part is so much smaller than the box that it is worth a pass, if it may not be less than shares of its
  // width.
  template <std::invocable<int> Least_share>
  static bool is_worth_a_pass(const Local_box& part, const Least_share& least_share)
  {
    constexpr double greatest_volume = 0.5;
    double volume = 1;
    for (int j = 0; j < part.dimension(); ++j)
      if (const double width = (std::max)(part.width(j), least_share(j)); width <= 1 - least_gain)
        volume *= width;
    return volume <= greatest_volume;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_DEPTH_FIRST_SUBDIVISION_H
