// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_NEAREST_ON_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_NEAREST_ON_CURVE_H

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Touching_curve.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Ball_powers.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Nearest_feet.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Power_nets.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
Whether feet on a curve C are its nearest points: whether balls around P that touch it there have no point of it inside,
for all feet in a range at once.

Where the second derivative of half the squared distance, |C'|^2 + <C - P, C''>, is positive on segments next to each
other, the foot among them, the first one increases, across joints without a kink, too, and is zero at the foot: it is
the nearest point of these segments.
*/
class Nearest_on_curve
{
  using Interval = CGAL::Interval_nt<false>;
  using Verdict = Nearest_feet::Verdict;
  using Answer = Nearest_feet::Answer;

  struct Segment
  {
    std::size_t piece;
    double begin, end; // in its unit interval
    Curve_nets nets;
    Curve_nets::Frame frame;
    Foot_grid::Bounds bounds;
    Interval_vector sample; // its middle
    int depth;
    std::optional<std::array<std::size_t, 2>> halves = {};
  };

  static constexpr int first_depth = 3, most_depth = 8;

  std::vector<Curve_nets> m_nets;
  std::vector<bool> m_goes_on; // behind a piece, without a kink; behind the last one with the first one
  Power_nets m_powers;
  std::vector<Segment> m_segments;
  std::vector<std::size_t> m_roots;

public:
  //! \pre rounding is upwards, here and below.
  explicit Nearest_on_curve(const std::vector<Polynomial_piece>& curve) : m_powers(curve)
  {
    for (std::size_t piece = 0; piece < curve.size(); ++piece) {
      m_nets.emplace_back(curve[piece]);
      m_goes_on.push_back(is_smooth(curve[piece], curve[(piece + 1) % curve.size()]));
      m_roots.push_back(add_segment(piece, 0, 1, m_nets.back(), 0));
    }
  }

  const Curve_nets& nets(std::size_t piece) const { return m_nets[piece]; }

  Verdict operator()(const Touching_balls& balls)
  {
    if (!balls.is_bounded)
      return {};
    const Curve_nets::Frame foot = m_nets[balls.piece].restricted(balls.box[0][0], balls.box[0][1]).frame();
    if (second_derivative(foot, balls).sup() < 0)
      return {Answer::NO}; // the distance has no local minimum at the foot
    std::vector<std::size_t> others;
    if (!find_segments(balls, others))
      return {Answer::NO};
    if (others.empty())
      return {Answer::YES};
    remove_near_foot(balls, others);
    return verdict_on(balls, others);
  }

  // The sign of the least power of what decides a label, for one ball, and a number that is near to it.
  std::pair<int, double> least_power(const Touching_ball& ball, const Nearest_feet::Competitors& competitors) const
  {
    double least = std::numeric_limits<double>::infinity();
    int sign = 1;
    for (std::size_t k = 0; k < competitors.parts.size() && sign >= 0; ++k)
      sign = (std::min)(sign, m_powers.sign_of_power(competitors.parts[k], ball, least));
    return {sign, least};
  }

private:
  static Interval second_derivative(const Curve_nets::Frame& frame, const Touching_ball& ball)
  {
    const Interval_vector way = combination(frame.point, Interval(-1), ball.center);
    return CGAL::square(frame.first[0]) + CGAL::square(frame.first[1]) + CGAL::square(frame.first[2]) +
        dot(way, frame.second);
  }

  // Whether a piece ends where another one begins, in the same direction.
  static bool is_smooth(const Polynomial_piece& first, const Polynomial_piece& second)
  {
    const auto at = [](const Polynomial_piece& piece, int parameter) {
      std::array<std::array<Exact_rational, 3>, 2> result; // point and direction
      const std::array<Exact_rational, 1> place{Exact_rational(parameter)};
      const Exact_rational w = piece.weight()(place), slope = piece.weight().derivative(0)(place);
      for (std::size_t c = 0; c < 3; ++c) {
        const Exact_rational x = piece.coordinates[c](place);
        result[0][c] = x / w;
        result[1][c] = w * piece.coordinates[c].derivative(0)(place) - slope * x;
      }
      return result;
    };
    const auto a = at(first, 1), b = at(second, 0);
    if (a[0] != b[0])
      return false;
    Exact_rational product(0);
    for (std::size_t c = 0; c < 3; ++c) {
      product += a[1][c] * b[1][c];
      if (a[1][c] * b[1][(c + 1) % 3] != a[1][(c + 1) % 3] * b[1][c])
        return false;
    }
    return product > 0;
  }

  std::size_t add_segment(std::size_t piece, double begin, double end, const Curve_nets& nets, int depth)
  {
    const Curve_nets::Frame frame = nets.frame();
    m_segments.push_back(
        {piece, begin, end, nets, frame, nets.bounds(), nets.restricted(0.5, 0.5).frame().point, depth});
    return m_segments.size() - 1;
  }

  std::array<std::size_t, 2> halves(std::size_t segment)
  {
    if (!m_segments[segment].halves) {
      const Segment own = m_segments[segment];
      const double middle = 0.5 * (own.begin + own.end);
      const std::size_t first = add_segment(own.piece, own.begin, middle, own.nets.restricted(0, 0.5), own.depth + 1);
      const std::size_t second = add_segment(own.piece, middle, own.end, own.nets.restricted(0.5, 1), own.depth + 1);
      m_segments[segment].halves = {first, second};
    }
    return *m_segments[segment].halves;
  }

  // Those that are not certainly outside of all balls; false if a point is certainly inside.
  bool find_segments(const Touching_balls& balls, std::vector<std::size_t>& result)
  {
    std::vector<std::size_t> open(m_roots);
    while (!open.empty()) {
      const std::size_t segment = open.back();
      open.pop_back();
      const Segment& own = m_segments[segment];
      if (Ball_powers::change_of_power(balls, own.bounds).least > 0)
        continue;
      if (Ball_powers::greatest_power(balls, own.sample) < 0)
        return false;
      if (own.depth < first_depth || (own.depth < most_depth && !is_convex(own, balls))) {
        const std::array<std::size_t, 2> parts = halves(segment);
        open.insert(open.end(), parts.begin(), parts.end());
      } else
        result.push_back(segment);
    }
    return true;
  }

  static bool is_convex(const Segment& segment, const Touching_ball& ball)
  {
    return second_derivative(segment.frame, ball).inf() > 0;
  }

  // Segments that are convex and next to each other and the feet.
  void remove_near_foot(const Touching_balls& balls, std::vector<std::size_t>& others) const
  {
    const Curve_nets::Frame foot = m_nets[balls.piece].restricted(balls.box[0][0], balls.box[0][1]).frame();
    if (!(second_derivative(foot, balls).inf() > 0))
      return;
    struct Range
    {
      std::size_t piece;
      double begin, end;
    };
    std::vector<Range> known{{balls.piece, balls.box[0][0], balls.box[0][1]}};
    const auto take = [&](std::size_t k) {
      const Segment& own = m_segments[k];
      const auto touches = [&](const Range& range) {
        return own.piece == range.piece && own.begin <= range.end && range.begin <= own.end;
      };
      const auto range = std::ranges::find_if(known, touches);
      if (range == known.end() || !is_convex(own, balls))
        return false;
      *range = {own.piece, (std::min)(own.begin, range->begin), (std::max)(own.end, range->end)};
      return true;
    };
    while (std::erase_if(others, take) > 0)
      for (std::size_t k = 0; k < known.size() && known.size() <= 2 * m_nets.size(); ++k) {
        const Range own = known[k];
        const std::size_t next = (own.piece + 1) % m_nets.size(),
                          last = (own.piece + m_nets.size() - 1) % m_nets.size();
        const auto is_known = [&](std::size_t piece, double at) {
          return std::ranges::any_of(
              known, [&](const Range& range) { return range.piece == piece && range.begin <= at && at <= range.end; });
        };
        if (own.end == 1 && m_goes_on[own.piece] && !is_known(next, 0))
          known.push_back({next, 0, 0});
        if (own.begin == 0 && m_goes_on[last] && !is_known(last, 1))
          known.push_back({last, 1, 1});
      }
  }

  Verdict verdict_on(const Touching_balls& balls, const std::vector<std::size_t>& others) const
  {
    if (others.empty())
      return {Answer::YES};
    Verdict result;
    for (const std::size_t axis : {0, 1}) {
      int trend = 0;
      bool is_common = true;
      for (const std::size_t k : others) {
        const int own = Ball_powers::change_of_power(balls, m_segments[k].bounds).trends[axis];
        is_common = is_common && own != 0 && (trend == 0 || own == trend);
        trend = own;
      }
      result.trends[axis] = is_common ? trend : 0;
    }
    if (result.trends[0] == 0 && result.trends[1] == 0)
      return {};
    for (const std::size_t k : others)
      result.competitors.parts.push_back({m_segments[k].piece, {{{m_segments[k].begin, m_segments[k].end}, {0, 1}}}});
    return result;
  }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_NEAREST_ON_CURVE_H
