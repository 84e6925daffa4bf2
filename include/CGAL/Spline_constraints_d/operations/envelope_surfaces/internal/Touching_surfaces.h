// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TOUCHING_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TOUCHING_SURFACES_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// Bounds of equations over a box of their unknowns: of the values, and of the derivatives in rows of one equation each.
template <std::size_t equations, std::size_t unknowns>
struct Linear_bounds
{
  using Interval = CGAL::Interval_nt<false>;

  std::array<Interval, equations> values;
  std::array<std::array<Interval, unknowns>, equations> slopes;
};

// A part of a sheet over a box of two of its unknowns: bounds of the derivatives of all unknowns by these two, half the
// widths of the box, and the only solution above the middle of the box; without that, the box of all.
template <class Feet, std::size_t unknowns>
struct Graph_bounds
{
  using Interval = CGAL::Interval_nt<false>;

  std::array<Interval, unknowns> box, middle;
  Feet feet, middle_feet;
  std::array<Foot_grid::Bounds, 2> bounds; // of the feet on both operands
  std::array<std::array<Interval, 2>, unknowns> slopes;
  std::array<double, 2> half_widths;
};

// Of the balls that touch a piece of a surface, where the unknowns at `first` are the parameters of the piece.
template <class Graph>
Touching_balls balls_on_surface(const Graph& graph, const Foot_frame& frame, const Foot_grid::Bounds& foot,
                                const Foot_frame& middle, std::size_t piece, std::size_t first,
                                const CGAL::Interval_nt<false>& x, const CGAL::Interval_nt<false>& middle_x,
                                const std::array<CGAL::Interval_nt<false>, 2>& slopes_of_x)
{
  Touching_balls result;
  result.foot = foot;
  result.normal = frame.normal;
  result.x = x;
  result.center = combination(frame.point, x, frame.normal);
  result.is_bounded = true;
  result.tangents = frame.tangents;
  result.normals = frame.normals;
  result.slopes = slopes_of_x;
  result.half_widths = graph.half_widths;
  result.piece = piece;
  for (const std::size_t axis : {0, 1}) {
    result.box[axis] = {graph.box[first + axis].inf(), graph.box[first + axis].sup()};
    result.foot_slopes[axis] = graph.slopes[first + axis];
  }
  for (const std::size_t axis : {0, 1}) {
    result.centers[axis] = combination({0, 0, 0}, slopes_of_x[axis], frame.normal);
    for (const std::size_t own : {0, 1})
      result.centers[axis] = combination(result.centers[axis], graph.slopes[first + own][axis],
                                         combination(frame.tangents[own], x, frame.normals[own]));
  }
  result.middle.foot = Ball_nets::bounds_of_point(middle.point);
  result.middle.normal = middle.normal;
  result.middle.x = middle_x;
  result.middle.center = combination(middle.point, middle_x, middle.normal);
  return result;
}

inline bool have_common_point(const CGAL::Interval_nt<false>& a, const CGAL::Interval_nt<false>& b)
{
  return a.inf() <= b.sup() && b.inf() <= a.sup();
}

// What is known of the same centers twice; false if there are none.
inline bool intersect_centers(Touching_balls& a, Touching_balls& b)
{
  bool result = true;
  const auto unite = [&](Interval_vector& first, Interval_vector& second) {
    for (const std::size_t c : {0, 1, 2})
      if (have_common_point(first[c], second[c]))
        first[c] = second[c] = intersection(first[c], second[c]);
      else
        result = false;
  };
  unite(a.center, b.center);
  unite(a.middle.center, b.middle.center);
  for (const std::size_t axis : {0, 1})
    unite(a.centers[axis], b.centers[axis]);
  return result;
}

// Of the centers, from the middle of the box on.
inline void add_mean_values(Touching_balls& balls)
{
  for (const std::size_t c : {0, 1, 2}) {
    CGAL::Interval_nt<false> change(0);
    for (const std::size_t axis : {0, 1})
      change += CGAL::abs(balls.centers[axis][c]) * CGAL::Interval_nt<false>(balls.half_widths[axis]);
    const CGAL::Interval_nt<false> all = balls.middle.center[c] + CGAL::Interval_nt<false>(-change.sup(), change.sup());
    if (have_common_point(balls.center[c], all))
      balls.center[c] = intersection(balls.center[c], all);
  }
}

/*
Points at distances from pieces F(u, v) and G(s, t) of two surfaces whose ratio is 1 : |c|, with unit normals n and m:

  F + x n = G + c x m.

The unknowns are u, v, s, t in unit boxes, and x.
*/
class Touching_surfaces
{
public:
  static constexpr std::size_t equations = 3, unknowns = 5;
  using Interval = CGAL::Interval_nt<false>;
  using Box = std::array<Interval, unknowns>;
  using Feet = std::array<Foot_frame, 2>;
  using Graph = Graph_bounds<Feet, unknowns>;

private:
  const Ball_nets *m_first, *m_second;
  std::array<std::size_t, 2> m_pieces;
  Interval m_factor, m_greatest; // c, and of |x|, 0 if it is not limited

public:
  //! \pre The nets live longer; rounding is upwards, here and below.
  Touching_surfaces(const Ball_nets& first, const Ball_nets& second, const std::array<std::size_t, 2>& pieces,
                    const Interval& factor, const Interval& greatest)
    : m_first(&first), m_second(&second), m_pieces(pieces), m_factor(factor), m_greatest(greatest)
  {}

  // None if a normal may be zero.
  std::optional<Feet> feet(const Box& box) const
  {
    Feet result;
    for (const std::size_t k : {0, 1}) {
      const std::optional<Foot_frame> frame = nets(box, k).frame();
      if (!frame)
        return std::nullopt;
      result[k] = *frame;
    }
    return result;
  }

  std::array<Foot_grid::Bounds, 2> bounds(const Box& box) const
  {
    return {nets(box, 0).bounds(), nets(box, 1).bounds()};
  }

  // Of x, for these feet; none if there is no such x.
  std::optional<Interval> steps(const Feet& feet) const
  {
    const Foot_frame &a = feet[0], &b = feet[1];
    const Interval_vector way = combination(b.point, Interval(-1), a.point),
                          normal = combination(a.normal, -m_factor, b.normal);
    Interval greatest = m_greatest;
    if (!(greatest.sup() > 0))
      greatest = square_root(dot(way, way)) / CGAL::abs(Interval(1) - CGAL::abs(m_factor));
    Interval result(-greatest.sup(), greatest.sup());
    Interval_vector middle;
    for (const std::size_t c : {0, 1, 2})
      middle[c] = Foot_grid::midpoint(normal[c]);
    const Interval below = dot(normal, middle);
    if (below.inf() > 0 || below.sup() < 0) {
      const Interval step = dot(way, middle) / below;
      if (!have_common_point(step, result))
        return std::nullopt;
      result = intersection(result, step);
    }
    return result;
  }

  Linear_bounds<equations, unknowns> linear(const Feet& feet, const Interval& x) const
  {
    const Foot_frame &a = feet[0], &b = feet[1];
    const Interval y = m_factor * x;
    const std::array<Interval_vector, unknowns> columns{
        combination(a.tangents[0], x, a.normals[0]), combination(a.tangents[1], x, a.normals[1]),
        negated(combination(b.tangents[0], y, b.normals[0])), negated(combination(b.tangents[1], y, b.normals[1])),
        combination(a.normal, -m_factor, b.normal)};
    Linear_bounds<equations, unknowns> result;
    result.values = combination(combination(a.point, x, a.normal), Interval(-1), combination(b.point, y, b.normal));
    for (std::size_t i = 0; i < equations; ++i)
      for (std::size_t j = 0; j < unknowns; ++j)
        result.slopes[i][j] = columns[j][i];
    return result;
  }

  // On the first and the second surface; none if there are none.
  std::optional<std::array<Touching_balls, 2>> balls(const Graph& graph) const
  {
    std::array<Touching_balls, 2> result;
    for (const std::size_t k : {0, 1}) {
      const Interval factor = k == 0 ? Interval(1) : m_factor;
      result[k] = balls_on_surface(graph, graph.feet[k], graph.bounds[k], graph.middle_feet[k], m_pieces[k], 2 * k,
                                   factor * graph.box[4], factor * graph.middle[4],
                                   {factor * graph.slopes[4][0], factor * graph.slopes[4][1]});
    }
    if (!intersect_centers(result[0], result[1]))
      return std::nullopt;
    for (Touching_balls& balls : result)
      add_mean_values(balls);
    return result;
  }

private:
  Ball_nets nets(const Box& box, std::size_t operand) const
  {
    const auto range = [&](std::size_t i) {
      return std::array<double, 2>{box[2 * operand + i].inf(), box[2 * operand + i].sup()};
    };
    return (operand == 0 ? m_first : m_second)->restricted({range(0), range(1)});
  }

  static Interval_vector negated(const Interval_vector& a) { return {-a[0], -a[1], -a[2]}; }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TOUCHING_SURFACES_H
