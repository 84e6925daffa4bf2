// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LABEL_TREE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LABEL_TREE_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_part_label.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Nearest_feet.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// A sphere, and the one that its bisector is cut at, as intervals.
struct Ball_scene
{
  using Interval = CGAL::Interval_nt<false>;

  Interval_vector center;
  Interval radius; // with a sign
  Interval_vector center_of_reach;
  Interval squared_reach;
  Interval farthest; // from the center of the first one, within reach
};

/*
The feet of a piece in boxes that are cut into four as long as their label is not known. Boxes are cut beside their
middle: in symmetrical scenes, labels change there.

In a box with a trend the label changes along one arc at most, which is a graph over the other parameter: it is the sign
of the least power of some parts of the surface, which increases, or decreases, along each line. Where the arc leaves
the box it changes sign once along a side, or not at all. So the signs in the four corners tell which sides the arc goes
through.
*/
class Label_tree
{
public:
  using Answer = Nearest_feet::Answer;
  using Box = std::array<std::array<double, 2>, 2>;

  enum class State
  {
    OUT_OF_REACH,
    NEAREST,
    NOT_NEAREST,
    BOTH, // with an arc
    UNKNOWN,
    CUT
  };

  struct Node
  {
    Box box;
    State state = State::UNKNOWN;
    int side = 0;           // of the poles; 0 if it may have some
    bool is_within = false; // reach
    std::array<std::size_t, 4> children{};
    int axis = 0, trend = 0;                    // if there is an arc: where the label changes, and how
    Nearest_feet::Competitors competitors = {}; // these parts of the surface decide it
    std::array<int, 4> corners{};               // the signs at (0,0), (0,1), (1,0), (1,1)
  };

private:
  std::size_t m_piece;
  Ball_nets m_nets;
  const Ball_scene& m_scene;
  Nearest_feet& m_feet;
  const Operation_budget& m_budget;
  std::vector<Node> m_nodes;

public:
  // \pre rounding is upwards, here and below
  Label_tree(std::size_t piece, const Homogeneous_polynomials& surface, const Ball_scene& scene, Nearest_feet& feet,
             const Operation_budget& budget)
    : m_piece(piece), m_nets(surface), m_scene(scene), m_feet(feet), m_budget(budget)
  {
    add({{{0, 1}, {0, 1}}}, m_nets, 0);
  }

  const Node& node(std::size_t index) const { return m_nodes[index]; }

  // The one without children that parameters are in.
  const Node& leaf(const std::array<Exact_rational, 2>& at) const
  {
    std::size_t index = 0;
    while (m_nodes[index].state == State::CUT) {
      const Node& first = m_nodes[m_nodes[index].children[0]];
      const int a = at[0] > Exact_rational(first.box[0][1]) ? 1 : 0,
                b = at[1] > Exact_rational(first.box[1][1]) ? 1 : 0;
      index = m_nodes[index].children[static_cast<std::size_t>(2 * a + b)];
    }
    return m_nodes[index];
  }

  // The sign, and a number that is near to the least power; zero if it is not known.
  std::pair<int, double> least_power(const Node& node, const std::array<double, 2>& at)
  {
    const Box box{{{at[0], at[0]}, {at[1], at[1]}}};
    const Touching_balls ball = balls(m_nets.restricted(box), box);
    if (!ball.is_bounded)
      return {0, 0};
    return m_feet.least_power(ball, node.competitors);
  }

  std::optional<int> label(const std::array<Exact_rational, 2>& at)
  {
    const Node& own = leaf(at);
    switch (own.state) {
    case State::NEAREST:
      return Bisector_part_label::NEAREST;
    case State::NOT_NEAREST:
      return Bisector_part_label::NOT_NEAREST;
    case State::BOTH: {
      const int sign = least_power(own, {to_nearest_double(at[0]), to_nearest_double(at[1])}).first;
      return sign > 0 ? std::optional<int>(Bisector_part_label::NEAREST)
          : sign < 0  ? std::optional<int>(Bisector_part_label::NOT_NEAREST)
                      : std::nullopt;
    }
    default:
      return std::nullopt;
    }
  }

  // Boxes that have one label within reach on each side of poles, or arcs and neither poles nor points out of reach, or
  // are undecided.
  std::vector<std::size_t> blocks() const
  {
    std::vector<std::size_t> result;
    add_blocks(result, 0);
    return result;
  }

  bool is_within(std::size_t index) const { return contents(index).is_within; }

  // The boxes with arcs in a node.
  std::vector<std::size_t> arcs(std::size_t index) const
  {
    std::vector<std::size_t> result, open{index};
    while (!open.empty()) {
      const Node& own = m_nodes[open.back()];
      if (own.state == State::BOTH)
        result.push_back(open.back());
      open.pop_back();
      if (own.state == State::CUT)
        open.insert(open.end(), own.children.begin(), own.children.end());
    }
    return result;
  }

private:
  // If something is not known of a smallest box, it is not of the one of the first of these depths around it.
  static constexpr int depth_of_undecided = 5, most_depth = 8;
  static constexpr double cut = 15. / 32;

  std::size_t add(const Box& box, const Ball_nets& nets, int depth)
  {
    m_budget.check();
    const std::size_t index = m_nodes.size();
    m_nodes.push_back({box});
    Node own{box};
    set_state(own, nets, depth);
    if (own.state == State::UNKNOWN && depth < most_depth) {
      own.state = State::CUT;
      const auto middle = [&](std::size_t axis) {
        // an odd number divided by a power of two that is not greater than necessary, so that numbers stay short
        const double scale = std::ldexp(16, depth);
        return (2 * std::floor((box[axis][0] + (box[axis][1] - box[axis][0]) * cut) * scale) + 1) / (2 * scale);
      };
      const std::array<double, 2> at{middle(0), middle(1)};
      std::size_t k = 0;
      bool is_known = true;
      for (const int a : {0, 1})
        for (const int b : {0, 1}) {
          if (!is_known)
            break;
          const auto range = [](const std::array<double, 2>& all, double m, int side) {
            return side == 0 ? std::array<double, 2>{all[0], m} : std::array<double, 2>{m, all[1]};
          };
          const Box part{range(box[0], at[0], a), range(box[1], at[1], b)};
          own.children[k] = add(part, m_nets.restricted(part), depth + 1);
          is_known = depth < depth_of_undecided || m_nodes[own.children[k]].state != State::UNKNOWN;
          ++k;
        }
      if (!is_known) {
        m_nodes.resize(index + 1);
        own.state = State::UNKNOWN;
      }
    }
    m_nodes[index] = std::move(own);
    return index;
  }

  Touching_balls balls(const Ball_nets& nets, const Box& box) const
  {
    Touching_balls result = nets.balls(m_scene.center, m_scene.radius);
    result.piece = m_piece;
    result.box = box;
    return result;
  }

  void set_state(Node& own, const Ball_nets& nets, int depth)
  {
    const Touching_balls balls = this->balls(nets, own.box);
    if (balls.distance.inf() > m_scene.farthest.sup()) {
      own.state = State::OUT_OF_REACH;
      return;
    }
    if (!balls.is_bounded)
      return;
    own.side = balls.height.inf() > 0 ? 1 : -1;
    CGAL::Interval_nt<false> square(0);
    for (std::size_t c = 0; c < 3; ++c)
      square += CGAL::square(balls.center[c] - m_scene.center_of_reach[c]);
    own.is_within = square.sup() < m_scene.squared_reach.inf();
    if (square.inf() > m_scene.squared_reach.sup()) {
      own.state = State::OUT_OF_REACH;
      return;
    }
    // x + r and r have different signs: the distance is that from the farthest point of the sphere.
    if (own.side > 0 ? m_scene.radius.inf() > 0 : m_scene.radius.sup() < 0) {
      own.state = State::NOT_NEAREST;
      return;
    }
    constexpr int least_depth = 2;
    if (depth < least_depth)
      return;
    Nearest_feet::Verdict verdict = m_feet(balls);
    if (verdict.answer != Answer::UNKNOWN)
      own.state = verdict.answer == Answer::YES ? State::NEAREST : State::NOT_NEAREST;
    else if (own.is_within)
      set_arc(own, verdict);
  }

  // If the label has a trend.
  void set_arc(Node& own, Nearest_feet::Verdict& verdict)
  {
    for (const std::size_t axis : {0, 1}) {
      if (verdict.trends[axis] == 0 || !(verdict.trends[1 - axis] != 0 || changes_once_on_sides(own, axis)))
        continue;
      own.axis = static_cast<int>(axis);
      own.trend = verdict.trends[axis];
      own.competitors = verdict.competitors;
      std::size_t k = 0;
      for (const double u : own.box[0])
        for (const double v : own.box[1]) {
          own.corners[k] = least_power(own, {u, v}).first;
          if (own.corners[k++] == 0)
            return;
        }
      const bool is_one = std::ranges::all_of(own.corners, [&](int sign) { return sign == own.corners[0]; });
      own.state = !is_one ? State::BOTH : own.corners[0] > 0 ? State::NEAREST : State::NOT_NEAREST;
      return;
    }
  }

  // Whether the label changes once at most along both sides where the parameter of an axis is constant.
  bool changes_once_on_sides(const Node& own, std::size_t axis)
  {
    return std::ranges::all_of(own.box[axis], [&](double at) {
      Box side = own.box;
      side[axis] = {at, at};
      const Touching_balls balls = this->balls(m_nets.restricted(side), side);
      if (!balls.is_bounded)
        return false;
      const Nearest_feet::Verdict verdict = m_feet(balls);
      return verdict.answer != Answer::UNKNOWN || verdict.trends[1 - axis] != 0;
    });
  }

  // What a node has, of states within reach on each side of the poles.
  struct Contents
  {
    std::array<std::optional<State>, 2> states;
    bool has_arcs = false, has_unknown = false, is_mixed = false, is_within = true;
  };

  Contents contents(std::size_t index) const
  {
    Contents result;
    std::vector<std::size_t> open{index};
    while (!open.empty()) {
      const Node& own = m_nodes[open.back()];
      open.pop_back();
      if (own.state == State::CUT) {
        open.insert(open.end(), own.children.begin(), own.children.end());
        continue;
      }
      result.is_within = result.is_within && own.is_within;
      if (own.state == State::OUT_OF_REACH)
        continue;
      result.has_arcs = result.has_arcs || own.state == State::BOTH;
      for (const int side : {-1, 1}) {
        if (own.side == -side)
          continue;
        auto& known = result.states[side < 0 ? 0 : 1];
        result.is_mixed = result.is_mixed || (known && *known != own.state);
        known = own.state;
        result.has_unknown = result.has_unknown || own.state == State::UNKNOWN;
      }
    }
    return result;
  }

  void add_blocks(std::vector<std::size_t>& result, std::size_t index) const
  {
    const Contents all = contents(index);
    const bool is_one = !all.is_mixed && !all.has_arcs,
               is_cut_by_arcs = all.has_arcs && all.is_within && !all.has_unknown;
    if (m_nodes[index].state != State::CUT || is_one || is_cut_by_arcs)
      result.push_back(index);
    else
      for (const std::size_t child : m_nodes[index].children)
        add_blocks(result, child);
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LABEL_TREE_H
