// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Common_inflections_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Convolution_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Curvature_sign_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_interior_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
The part of the convolution of two boundaries that the boundary of the Minkowski sum is on: sums of points with the same
direction, where the sum of both curvatures is not negative. Elsewhere the regions, one of them reflected, overlap near
their contact. So both do not turn to the right, or rest in a reflex corner.

Where directions of both regions are the same at joints or on straight parts, those of the first region are taken for
slightly farther to the left. So each sum of straight parts is two pieces, one after the other.
*/
class Convolution_2
{
  static constexpr double share_of_work = 0.25;   // of all of a sum, about

  std::array<const Region_elements_2*, 2> m_regions;
  const Sum_interior_2& m_interior;
  Run_of_steps& m_control;
  Common_inflections_2 m_inflections;
  std::vector<Convolution_piece_2> m_pieces;
  std::vector<Interval_pair> m_doubtful;

public:
  // \throws Run_stopped
  Convolution_2(const Region_elements_2& first, const Region_elements_2& second, const Sum_interior_2& interior,
                Run_of_steps& control)
    : m_regions{&first, &second}, m_interior(interior), m_control(control), m_inflections(first, second, control)
  {
    for (std::size_t i = 0; i < first.elements().size(); ++i) {
      m_control.check();
      for (std::size_t j = 0; j < second.elements().size(); ++j)
        add_sums({i, j});
      m_control.add_progress(share_of_work / static_cast<double>(first.elements().size()));
    }
  }

  const std::vector<Convolution_piece_2>& pieces() const { return m_pieces; }

  // Boxes with points of the convolution that are in none of the pieces, because the sign of the sum of curvatures is
  // not certain, and that are not proved to be inside of the sum either.
  const std::vector<Interval_pair>& doubtful() const { return m_doubtful; }

private:
  const Region_element& element(std::size_t region, std::size_t index) const
  {
    return m_regions[region]->elements()[index];
  }

  void add_sums(const std::array<std::size_t, 2>& elements)
  {
    const Region_element &a = element(0, elements[0]), &b = element(1, elements[1]);
    if ((a.is_corner && a.turn != Turn::LEFT) || (b.is_corner && b.turn != Turn::LEFT) ||
        (a.is_corner && b.is_corner) || !may_have_common_direction(a, b))
      return;
    m_control.check();
    const bool can_first_turn = a.turn == Turn::LEFT && !b.is_corner,
               can_second_turn = b.turn == Turn::LEFT && !a.is_corner;
    if (can_first_turn || can_second_turn)
      add_pieces(elements, can_first_turn && can_second_turn ? curvature(1, b) > curvature(0, a) : can_second_turn);
    else if (!m_inflections.next_to(elements).empty())
      return;
    else if (a.turn == Turn::UNKNOWN || b.turn == Turn::UNKNOWN)
      add_unknown_sums(elements, a.turn == Turn::UNKNOWN ? 0 : 1);
  }

  bool is_inside(const Interval_pair& box) const { return CGAL::certainly(m_interior.contains(box, m_control)); }

  void add_doubtful(const Interval_pair& box)
  {
    if (!CGAL::certainly(m_interior.contains(box, m_control, Sum_interior_2::Effort::THOROUGH)))
      m_doubtful.push_back(box);
  }

  // Of two elements that turn to the left the one with the larger curvature is the turning one: where the curvature is
  // nearly zero, the point is not a smooth function of the direction.
  double curvature(std::size_t region, const Region_element& element) const
  {
    if (element.is_corner)
      return std::numeric_limits<double>::infinity();
    const auto at = [&](double t) {
      const Tangent_jet<> jet = tangent_jet(m_regions[region]->arcs()[element.arc], {t, t});
      // infinite where the derivative is zero
      return jet.turn().inf() / (jet.speed.sup() * std::pow(jet.squared_length().inf(), 1.5));
    };
    return (std::min)(at(element.range.begin), at(element.range.end));
  }

  // Elements with a common direction turn by less than 45 degrees each, so that all of their directions are within 90
  // degrees of each other.
  static bool may_have_common_direction(const Region_element& a, const Region_element& b)
  {
    for (const Exact_pair& d : a.exact_directions)
      for (const Exact_pair& e : b.exact_directions)
        if (sign_of(exact_dot(d, e)) < 0)
          return false;
    return true;
  }

  // A small part with an inflection, and an element that does not turn to the left, or is one like that too: common
  // directions, unless the sum of both curvatures is negative.
  void add_unknown_sums(const std::array<std::size_t, 2>& elements, std::size_t unknown)
  {
    constexpr double least_width = 0x1p-20, least_straight_width = 0x1p-8;
    const Region_element &a = element(unknown, elements[unknown]), &b = element(1 - unknown, elements[1 - unknown]);
    const auto curvature = [](const Tangent_jet<>& jet) {   // times the speed
      const Interval square = jet.squared_length();
      return jet.turn() / (square * CGAL::sqrt(square));
    };
    if (b.turn == Turn::STRAIGHT && side_of_inflection(unknown, a, b.exact_directions[0]) != 0)
      return;   // the arc crosses the side, which has its direction in one point
    const Tangent_jet<> p = tangent_jet(m_regions[unknown]->arcs()[a.arc], a.range);
    for (std::vector<Range> todo{b.range}; !todo.empty();) {
      const Range part = todo.back();
      todo.pop_back();
      const Tangent_jet<> q = tangent_jet(m_regions[1 - unknown]->arcs()[b.arc], part);
      if (certain_sign(cross(p.tangent, q.tangent)) != 0 ||
          certain_sign(q.speed * curvature(p) + p.speed * curvature(q)) < 0)
        continue;
      const bool is_cut = b.turn == Turn::RIGHT ? part.width() > least_width
                                                : b.turn == Turn::STRAIGHT && part.width() > least_straight_width &&
              !is_inside(p.point + q.point);
      if (is_cut) {
        todo.push_back({part.begin, part.middle()});
        todo.push_back({part.middle(), part.end});
      } else
        add_doubtful(p.point + q.point);
    }
  }

  // On which side of a direction of the turning element one of the moving element is: 1 on the left, and -1 on the
  // right.
  struct Side
  {
    int sign;
    bool is_tie;
  };

  Side side(std::size_t turning, const Region_element& a, std::size_t a_end, const Region_element& b,
            std::size_t b_end) const
  {
    int sign = certain_sign(cross(a.directions[a_end], b.directions[b_end]));
    if (sign == 0)
      sign = sign_of(exact_cross(a.exact_directions[a_end], b.exact_directions[b_end]));
    return sign == 0 ? Side{turning == 0 ? -1 : 1, true} : Side{sign, false};
  }

  void add_pieces(const std::array<std::size_t, 2>& elements, std::size_t turning)
  {
    const Region_element &a = element(turning, elements[turning]), &b = element(1 - turning, elements[1 - turning]);
    const std::vector<std::size_t> inflections = m_inflections.next_to(elements);
    if (b.turn == Turn::UNKNOWN && !inflections.empty())
      return;
    if (b.turn == Turn::UNKNOWN)
      return add_inflection(elements, turning);
    std::array<Convolution_end, 2> ends;
    for (std::size_t e = 0; e < 2; ++e)
      if (const auto end = end_of_piece(elements, turning, e))
        ends[e] = *end;
      else
        return;
    for (const std::size_t inflection : inflections)
      set_inflection(inflection, elements[1 - turning], 1 - turning, ends);
    const Convolution_piece_2 piece(m_regions, elements, turning, ends);
    if (b.turn == Turn::RIGHT && !a.is_corner) {
      if (!piece.is_point())
        add_convex_parts(piece);
    } else
      m_pieces.push_back(piece);
  }

  // Extends a piece of the moving element to an inflection that both regions have in common.
  void set_inflection(std::size_t index, std::size_t moving, std::size_t region,
                      std::array<Convolution_end, 2>& ends) const
  {
    const Common_inflection& inflection = m_inflections[index];
    const std::size_t e = moving < inflection.elements[region] ? 1 : 0;
    const Range &range = ends[e].range;
    ends[e] = {e == 1 ? Range{range.begin, inflection.range.end} : Range{inflection.range.begin, range.end}, {}};
    ends[e].inflection = index;
  }

  // Where the moving element has begun (e = 0) to have common directions with the turning one, or ceases to (e = 1): in
  // its end, or inside in the first or last direction of the turning element.
  std::optional<Convolution_end> end_of_piece(const std::array<std::size_t, 2>& elements, std::size_t turning,
                                              std::size_t e) const
  {
    const Region_element &a = element(turning, elements[turning]), &b = element(1 - turning, elements[1 - turning]);
    const std::size_t limit = (b.turn != Turn::RIGHT) == (e == 0) ? 0 : 1;
    const int inside = limit == 0 ? 1 : -1;
    const Side here = side(turning, a, limit, b, e), there = side(turning, a, limit, b, 1 - e);
    Convolution_end result{};
    const auto set_joint = [&](std::size_t region, int end) {
      result.joints[region] = m_regions[region]->joint(elements[region], end);
    };
    const double end = e == 0 ? b.range.begin : b.range.end;
    if (here.sign == inside || here.is_tie) {
      if (here.sign != inside && there.sign != inside)
        return std::nullopt;
      result.range = {end, end};
      result.direction = b.exact_directions[e];
      set_joint(1 - turning, static_cast<int>(e));
      for (std::size_t k = 0; k < 2; ++k)
        if (side(turning, a, k, b, e).is_tie)
          set_joint(turning, static_cast<int>(k));
      return result;
    }
    if (there.sign != inside || there.is_tie)
      return std::nullopt;
    result.direction = a.exact_directions[limit];
    result.range = parameter_of_direction(1 - turning, b, a.exact_directions[limit], e == 0 ? -here.sign : here.sign);
    set_joint(turning, static_cast<int>(limit));
    return result;
  }

  // Where an element has a direction that it passes once, and behind which its own directions are on the left (sign 1)
  // or right (-1).
  Range parameter_of_direction(std::size_t region, const Region_element& element, const Exact_pair& direction,
                               int sign) const
  {
    constexpr double enough = 0x1p-40;
    const Range result = parameter_of_direction<Interval>(region, element.arc, element.range, direction, sign);
    return result.width() > enough ? parameter_of_direction<Fine_interval>(region, element.arc, result, direction, sign)
                                   : result;
  }

  // In a range, with the signs that a number type tells.
  template <Enclosing_number Number>
  Range parameter_of_direction(std::size_t region, std::size_t index, Range result, const Exact_pair& exact_direction,
                               int sign) const
  {
    const auto& arc = m_regions[region]->template arc<Number>(index);
    const std::array<Number, 2> direction{interval_of<Number>(exact_direction[0]),
                                          interval_of<Number>(exact_direction[1])};
    for (bool is_shorter = true; is_shorter;) {
      is_shorter = false;
      for (const double part : {0.5, 0.25, 0.75}) {
        const double t = result.begin + part * result.width();
        if (!(result.begin < t && t < result.end))
          continue;
        if (const int s = certain_sign(cross(direction, tangent_jet(arc, {t, t}, false).tangent)); s != 0) {
          (s == sign ? result.end : result.begin) = t;
          is_shorter = true;
          break;
        }
      }
    }
    return result;
  }

  // A small part with an inflection, all of which has common directions with the turning element, or none.
  void add_inflection(const std::array<std::size_t, 2>& elements, std::size_t turning)
  {
    const Region_element &a = element(turning, elements[turning]), &b = element(1 - turning, elements[1 - turning]);
    const Interval_pair direction = tangent_jet(m_regions[1 - turning]->arcs()[b.arc], b.range, false).tangent;
    int first = certain_sign(cross(a.directions[0], direction)), last = certain_sign(cross(direction, a.directions[1]));
    if (first == 0)
      first = side_of_inflection(1 - turning, b, a.exact_directions[0]);
    if (last == 0)
      last = -side_of_inflection(1 - turning, b, a.exact_directions[1]);
    if (first < 0 || last < 0)
      return;
    std::array<Convolution_end, 2> ends{Convolution_end{{b.range.begin, b.range.begin}, {}},
                                        Convolution_end{{b.range.end, b.range.end}, {}}};
    for (std::size_t e = 0; e < 2; ++e) {
      ends[e].direction = b.exact_directions[e];
      ends[e].joints[1 - turning] = m_regions[1 - turning]->joint(elements[1 - turning], static_cast<int>(e));
    }
    const Convolution_piece_2 piece(m_regions, elements, turning, ends);
    if (first > 0 && last > 0 &&
        (a.is_corner || piece.sign_of_speed(b.range) > 0 || piece.sign_of_speed<Fine_interval>(b.range) > 0))
      m_pieces.push_back(piece);
    else
      add_doubtful(piece(b.range).point);
  }

  /*
  On which side of a direction those of a small part with an inflection are, if it is exactly that of the inflection, in
  a rational parameter: 1 on the left, -1 on the right. There an arc turns back, so that its directions are on one side;
  no others need to be told apart in this point.
  */
  int side_of_inflection(std::size_t region, const Region_element& element, const Exact_pair& direction) const
  {
    const std::optional<Exact_rational> t = Convolution_piece_2::simple_number(element.range);
    if (!t)
      return 0;
    const Site_arc_2<>& arc = m_regions[region]->arcs()[element.arc];
    const std::array<Exact_tensor, 2> d = arc.has_singular_end() ? arc.tangent() : arc.derivative_numerators();
    const Exact_tensor side = d[1] * direction[0] - d[0] * direction[1], change = side.derivative(0);
    const std::array<Exact_rational, 1> at{*t};
    if (sign_of(side(at)) != 0 || sign_of(change(at)) != 0)
      return 0;
    const std::vector<Exact_rational> c =
        change.derivative(0)
            .restricted(0, to_rational(element.range.begin), to_rational(element.range.end))
            .coefficients();
    const int sign = sign_of(c.front());
    return std::all_of(c.begin(), c.end(), [&](const Exact_rational& x) { return sign_of(x) == sign; }) ? sign : 0;
  }

  // The parts of a piece along which the sum of both curvatures is positive, so that it runs in the direction of the
  // moving arc. What is inside of the sum, as most zeros of it are, need not be cut further. At a simple zero, a cusp,
  // the regions cross in third order, so that it is inside, too; so a part may end there, somewhere in a range.
  void add_convex_parts(const Convolution_piece_2& piece)
  {
    constexpr double least_width = 0x1p-44, first_ratio = 0x1p-8, ratio = 0x1p-4, enough = 0.95, most_parts = 0x1p17;
    const Curvature_sign_2 sign(piece);
    // where the sum of the curvatures is zero all along, or nearly so; it gets shorter only slowly near points with the
    // same tangent as an inflection of both regions
    constexpr int most_idle_rounds = 2;
    std::vector<Range> convex, cusps, unknown{without_fold(piece, convex)};
    int idle_rounds = 0;
    for (double width = first_ratio * unknown.front().width(); idle_rounds < most_idle_rounds && !unknown.empty() &&
         width >= least_width && total_width(unknown) <= most_parts * width;
         width *= ratio) {
      std::vector<Range> parts;
      for (const Range& range : unknown) {
        m_control.check();
        append_by_sign(sign, range, width, convex, parts);
      }
      if (total_width(parts) < enough * total_width(unknown))
        std::erase_if(parts,
                      [&](const Range& part) { return is_inside(piece(part).point); });
      else
        ++idle_rounds;
      std::erase_if(parts,
                    [&](const Range& part) { return separate_by_cusp(sign, part, piece.range(), convex, cusps); });
      unknown = std::move(parts);
    }
    for (const Range& part : unknown)
      add_doubtful(piece(part).point);
    std::sort(convex.begin(), convex.end(), [](const Range& a, const Range& b) { return a.begin < b.begin; });
    std::vector<Range> joined;
    for (const Range& part : convex)
      append(part, joined);
    for (const Range& part : joined) {
      Range begin{part.begin, part.begin}, end{part.end, part.end};
      for (const Range& cusp : cusps)
        if (cusp.end == part.begin)
          begin = cusp;
        else if (cusp.begin == part.end)
          end = cusp;
      m_pieces.push_back(piece.restricted(begin, end));
    }
  }

  // Whether the sum of both curvatures has one zero in a part, not next to an end of the piece, and the signs around
  // this are known.
  static bool separate_by_cusp(const Curvature_sign_2& sign, const Range& part, const Range& all,
                               std::vector<Range>& convex, std::vector<Range>& cusps)
  {
    const std::optional<Curvature_sign_2::Cusp> cusp = sign.only_cusp(part);
    if (!cusp || cusp->range.begin <= all.begin || cusp->range.end >= all.end)
      return false;
    const Range rest = cusp->sign_before > 0 ? Range{part.begin, cusp->range.begin} : Range{cusp->range.end, part.end};
    if (!rest.is_number())
      convex.push_back(rest);
    cusps.push_back(cusp->range);
    return true;
  }

  // A piece without its part next to an inflection that both regions have in common, where the sign is known; this is a
  // convex one, if that is positive.
  Range without_fold(const Convolution_piece_2& piece, std::vector<Range>& convex) const
  {
    constexpr int most_halvings = 16;
    Range result = piece.range();
    for (const int e : {0, 1})
      if (const auto index = piece.end(e).inflection) {
        const Common_inflection& inflection = m_inflections[*index];
        double share = 1;
        for (int k = 0; k < most_halvings; ++k, share /= 2) {
          const double from = e == 0 ? piece.end(0).range.end : piece.end(1).range.begin,
                       far = e == 0 ? (std::min)(inflection.near.end, result.end)
                                    : (std::max)(inflection.near.begin, result.begin),
                       t = from + share * (far - from);
          const Range u = piece.turning_range({t, t});
          if (!(inflection.near.begin <= u.begin && u.end <= inflection.near.end))
            continue;
          if (inflection.is_fold_convex)
            convex.push_back(e == 0 ? Range{result.begin, t} : Range{t, result.end});
          (e == 0 ? result.begin : result.end) = t;
          break;
        }
      }
    return result;
  }

  // Parts where the sum of the curvatures is positive, and others of a small width where its sign is not certain.
  void append_by_sign(const Curvature_sign_2& sign_of, const Range& range, double width, std::vector<Range>& positive,
                      std::vector<Range>& unknown) const
  {
    const int sign = sign_of(range);
    if (sign != 0 || range.width() <= width) {
      if (sign >= 0)
        append(range, sign > 0 ? positive : unknown);
      return;
    }
    append_by_sign(sign_of, {range.begin, range.middle()}, width, positive, unknown);
    append_by_sign(sign_of, {range.middle(), range.end}, width, positive, unknown);
  }

  static double total_width(const std::vector<Range>& ranges)
  {
    return std::accumulate(ranges.begin(), ranges.end(), 0.0,
                           [](double sum, const Range& range) { return sum + range.width(); });
  }

  // Appends a range, or joins it with the last one.
  static void append(const Range& range, std::vector<Range>& ranges)
  {
    if (!ranges.empty() && ranges.back().end == range.begin)
      ranges.back().end = range.end;
    else
      ranges.push_back(range);
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_2_H
