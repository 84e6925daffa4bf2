// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_PIECE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_PIECE_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Chord_cone_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Curvature_jet.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Traced_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// Whether two vectors have the same direction.
inline bool are_parallel(const Exact_pair& a, const Exact_pair& b)
{
  return sign_of(exact_cross(a, b)) == 0 && sign_of(exact_dot(a, b)) > 0;
}

// The tangent of half of the angle between two directions.
inline Interval tangent_of_half_angle(const Interval_pair& a, const Interval_pair& b)
{
  return cross(a, b) / (CGAL::sqrt(squared_norm(a) * squared_norm(b)) + dot(a, b));
}

// The diagonal of a box.
inline Interval diameter(const Interval_pair& box)
{
  const auto width = [](const Interval& x) { return Interval(x.sup()) - Interval(x.inf()); };
  return CGAL::sqrt(CGAL::square(width(box[0])) + CGAL::square(width(box[1])));
}

// An end of a piece: a range that the parameter is in, and the joints of the elements of both regions that it is at.
struct Convolution_end
{
  Range range;
  std::array<std::optional<std::size_t>, 2> joints;
  // of the piece, in the exact end; not where a piece is cut somewhere near a cusp
  std::optional<Exact_pair> direction{};
  std::optional<Exact_pair> point{};       // if it is found to be rational
  std::optional<std::size_t> inflection{}; // that both regions have in common there
};

/*
The sums of the points of two elements with the same direction. One of them, the turning one, turns to the left, so that
it has one point for each direction; the parameter is that of the other one, the moving arc.
*/
class Convolution_piece_2
{
  std::array<const Region_elements_2*, 2> m_regions;
  std::array<std::size_t, 2> m_elements;   // of the two regions
  std::size_t m_turning;                   // the region of the turning element
  std::array<Convolution_end, 2> m_ends;
  bool m_is_double = false;   // the same arc, with the same parameter

public:
  Convolution_piece_2(const std::array<const Region_elements_2*, 2>& regions,
                      const std::array<std::size_t, 2>& elements, std::size_t turning,
                      const std::array<Convolution_end, 2>& ends)
    : m_regions(regions), m_elements(elements), m_turning(turning), m_ends(ends),
      m_is_double((ends[0].inflection || ends[1].inflection) && element(0).turn == element(1).turn)
  {}

  const std::array<Convolution_end, 2>& ends() const { return m_ends; }
  Range range() const { return {m_ends[0].range.begin, m_ends[1].range.end}; }
  Range inner_range() const { return {m_ends[0].range.end, m_ends[1].range.begin}; }

  const Convolution_end& end(int e) const { return m_ends[static_cast<std::size_t>(e)]; }
  bool has_corner() const { return element(m_turning).is_corner; }
  const Region_element& turning_element() const { return element(m_turning); }
  const Region_element& moving_element() const { return element(1 - m_turning); }
  const Site_arc_2<>& turning_arc() const { return arc(m_turning); }
  const Site_arc_2<>& moving_arc() const { return arc(1 - m_turning); }
  bool is_straight() const { return element(1 - m_turning).turn == Turn::STRAIGHT; }

  // Whether it is proved to be one point: the sum of arcs of equal circles on opposite sides of their tangents, or of
  // an arc and its reflection, as from both halves of an arc that is symmetric about its inflection. The turning
  // element has each direction once.
  bool is_point() const
  {
    if (has_corner() || moving_element().turn != Turn::RIGHT)
      return false;
    const auto &a = turning_arc().circle(), &b = moving_arc().circle();
    const double reflected = 1 - inner_range().middle();
    const Range& all = turning_element().range;
    return (a && b && a->second == b->second) ||
        (all.begin < reflected && reflected < all.end && are_reflected(turning_arc(), moving_arc()));
  }

  bool is_circular() const { return moving_arc().circle() && (has_corner() || turning_arc().circle()); }

  // Whether it turns to one side, by at most 45 degrees, or not at all.
  bool is_convex() const { return element(1 - m_turning).turn != Turn::UNKNOWN; }

  // The directions of chords from an end, if its direction and that of the other end are known.
  std::optional<Chord_cone_2> chord_cone(int end) const
  {
    const auto &first = m_ends[0].direction, &last = m_ends[1].direction;
    return is_convex() && first && last ? std::optional<Chord_cone_2>(std::in_place, *first, *last, end) : std::nullopt;
  }

  // Both parts, cut where the parameter is a rational number within the inner range.
  std::array<Convolution_piece_2, 2> split(const Exact_rational& t, const Exact_pair& point) const
  {
    const auto [below, above] = to_double_interval(t);
    const Convolution_end end{{below, above}, {}, moving_arc().tangent_at(t), point};
    std::array<Convolution_piece_2, 2> result{*this, *this};
    result[0].m_ends[1] = result[1].m_ends[0] = end;
    return result;
  }

  // Finds rational points of ends.
  void find_end_points()
  {
    for (Convolution_end& end : m_ends)
      if (end.direction && !end.point)
        if (const std::optional<Exact_rational> t = simple_number(end.range);
            t && are_parallel(*end.direction, moving_arc().tangent_at(*t)))
          end.point = exact_point(*t);
  }

  // The point where the parameter is this number, if the parameter of the turning arc there is found to be rational
  // too.
  std::optional<Exact_pair> exact_point(const Exact_rational& t) const
  {
    const Exact_pair b = moving_arc().at(t);
    Exact_rational u(1);
    if (!has_corner()) {
      const Exact_pair direction = moving_arc().tangent_at(t);
      const std::optional<Exact_rational> candidate = m_is_double
          ? t
          : simple_number(turning_parameter<Interval>({interval_of(direction[0]), interval_of(direction[1])},
                                                      turning_element().range));
      if (!candidate || !are_parallel(direction, turning_arc().tangent_at(*candidate)))
        return std::nullopt;
      u = *candidate;
    }
    const Exact_pair a = turning_arc().at(u);
    return Exact_pair{Exact_rational(a[0] + b[0]), Exact_rational(a[1] + b[1])};
  }

  // The parameter of a rational point that is proved to be on the piece, between its ends.
  std::optional<Exact_rational> parameter_of(const Exact_pair& point) const
  {
    const Interval_pair p{interval_of(point[0]), interval_of(point[1])};
    const std::optional<Range> first = outermost_place(p, range(), true),
                               last = first ? outermost_place(p, range(), false) : first;
    if (!last)
      return std::nullopt;
    const Range inner = inner_range(), place = united(*first, *last);
    if (!(inner.begin < place.end && place.begin < inner.end))
      return std::nullopt;
    const std::optional<Exact_rational> t =
        moving_arc().is_segment() ? parameter_on_line(point, to_rational(place.middle())) : simple_number(place);
    if (!t || !(to_rational(inner.begin) < *t && *t < to_rational(inner.end)) || exact_point(*t) != point)
      return std::nullopt;
    return t;
  }

  // A rational number with few digits in a range. Where a number there is known to have a certain property, it is
  // likely to be this one, if any.
  static std::optional<Exact_rational> simple_number(const Range& range)
  {
    constexpr double most_width = 0x1p-12;
    if (range.is_number())
      return to_rational(range.begin);
    return range.width() < most_width
        ? std::optional(simplest_rational_between(to_rational(range.begin), to_rational(range.end)))
        : std::nullopt;
  }

  // A part between numbers, or cusps that are the only ones in these ranges: its new ends, which are not at joints.
  Convolution_piece_2 restricted(const Range& begin, const Range& end) const
  {
    Convolution_piece_2 result(*this);
    if (begin.begin > m_ends[0].range.begin)
      result.m_ends[0] = {begin, {}};
    if (end.end < m_ends[1].range.end)
      result.m_ends[1] = {end, {}};
    return result;
  }

  /*
  The point, the direction, that of the moving arc, and the curvature. With parallel tangents a = l b of the two arcs
  and their derivatives m a and n b, the derivative of the sum is b times

    n + m l^3 (b x b') / (a x a').
  */
  Traced_jet operator()(const Range& range) const
  {
    const Region_element &turning = element(m_turning), &moving = element(1 - m_turning);
    const Tangent_jet<> b = tangent_jet(moving_arc(), range);
    const Interval square = b.squared_length(),
                   turn = moving.turn == Turn::STRAIGHT ? Interval(0) : b.turn() / (square * CGAL::sqrt(square));
    if (turning.is_corner)
      return {turning_arc().point({1, 1}) + b.point, b.tangent, b.speed, turn / b.speed};
    const Tangent_jet<> a = tangent_jet(turning_arc(), turning_range(range, b.tangent));
    if (moving.turn == Turn::STRAIGHT)
      return {a.point + b.point, b.tangent, b.speed, turn};
    const Interval ratio = dot(a.tangent, b.tangent) / square,
                   speed = m_is_double ? Interval(2) * b.speed
                                       : b.speed + a.speed * ratio * CGAL::square(ratio) * (b.turn() / a.turn());
    return {a.point + b.point, b.tangent,
            certain_sign(speed) == 0 && has_sum_of_curvatures() ? speed_near_cusp(range, speed) : speed, turn / speed};
  }

  // A part of the turning arc, and how far its parameter there is from the middle.
  template <Enclosing_number Number>
  struct Turning_place
  {
    Range around;
    Number step;

    Range middle() const { return {around.middle(), around.middle()}; }
  };

  // Where the turning arc has the direction b of the moving one at a number: at u + s, if u is near there and D is its
  // tangent, with b x (D(u) + s D') = 0 for a derivative D' from between. Where that arc is nearly straight, doubles do
  // not tell what is near, but the level above does.
  template <Enclosing_number Number>
  Turning_place<Number> turning_place(double t) const
  {
    constexpr double enough = 0x1p-40;
    const auto &a = arc_on_level<Number>(m_turning), &b = arc_on_level<Number>(1 - m_turning);
    const bool is_at_inflection = m_ends[0].inflection || m_ends[1].inflection;
    const std::array<Number, 2> direction = b.direction_over({t, t});
    Turning_place<Number> result{turning_range({t, t}), {}};
    if (std::same_as<Number, Fine_interval> && !is_at_inflection && result.around.width() > enough)
      result.around = turning_parameter(direction, result.around);
    result.step = interval_of<Number>(result.around) - Number(result.around.middle());
    if (!is_at_inflection) {
      const std::array<Number, 2> normal = turned_left(direction);
      const Number slope = dot(normal, a.tangent_jet(result.around)[1]);
      if (certain_sign(slope) != 0)
        result.step = common_part(result.step, -dot(normal, a.direction_over(result.middle())) / slope);
    }
    return result;
  }

  // The point at a number, on the level above doubles: from that place, this is a(u) + s a'(u) + s^2/2 a'' with a''
  // from between.
  Fine_pair fine_point(double t) const
  {
    const auto &a = arc_on_level<Fine_interval>(m_turning), &b = arc_on_level<Fine_interval>(1 - m_turning);
    const Fine_pair point = b.point({t, t});
    if (has_corner())
      return a.point({1, 1}) + point;
    const auto place = turning_place<Fine_interval>(t);
    const auto near = a.jet(place.middle(), 1), between = a.jet(place.around, 2);
    return point + near[0] + place.step * near[1] + CGAL::square(place.step) / Fine_interval(2) * between[2];
  }

  // The sign of the speed, of a piece with two arcs. Nearly straight turning arcs, as next to inflections, leave it
  // certain.
  template <Enclosing_number Number = Interval>
  int sign_of_speed(const Range& range) const
  {
    const auto b = tangent_jet(arc_on_level<Number>(1 - m_turning), range),
               a = tangent_jet(arc_on_level<Number>(m_turning), turning_range(range, in_doubles(b.tangent)));
    const Number ratio = dot(a.tangent, b.tangent) / b.squared_length();
    return certain_sign(b.speed * a.turn() + a.speed * ratio * CGAL::square(ratio) * b.turn());
  }

  /*
  The same for polynomial arcs that are nearly straight, where products of bounds of derivatives do not tell how they
  turn: by the Bernstein coefficients of C' x C'', whose errors are small beside them. The moving arc turns to one side,
  so that parameters of the turning one are between those at both ends.
  */
  int sign_of_speed_by_turns(const Range& range) const
  {
    const auto is_simple = [](const Site_arc_2<>& arc) { return arc.is_polynomial() && !arc.has_singular_end(); };
    if (has_corner() || is_straight() || !is_convex() || !is_simple(turning_arc()) || !is_simple(moving_arc()))
      return 0;
    const Range u =
        united(turning_place<Fine_interval>(range.begin).around, turning_place<Fine_interval>(range.end).around);
    const auto turn = [&](std::size_t region, const Range& part) {
      return in_doubles(m_regions[region]->turn_polynomial(element(region).arc)(0, part));
    };
    const Interval_pair a = turning_arc().direction_over(u), b = moving_arc().direction_over(range);
    const Interval ratio = dot(a, b) / squared_norm(b);
    return certain_sign(turn(m_turning, u) + ratio * CGAL::square(ratio) * turn(1 - m_turning, range));
  }

  // The arc of a region on the level of a number type.
  template <Enclosing_number Number>
  const Site_arc_2<Number>& arc_on_level(std::size_t region) const
  {
    return m_regions[region]->template arc<Number>(element(region).arc);
  }

  /*
  The sum of both curvatures at a number, and its derivative over a range: with the angle p of the tangents, which is
  the same for both arcs, this is

    k_b' + k_a' p_b' / p_a'.

  So the sum is known over a range up to the square of its width. Any number where the derivative of an arc is zero in
  an end, or a number is not proved to be on the piece.
  */
  template <Enclosing_number Number>
  Number sum_of_curvatures(double t) const
  {
    if (const Range inner = inner_range(); !has_sum_of_curvatures() || t < inner.begin || inner.end < t)
      return any_number<Number>();
    const auto& a = arc_on_level<Number>(m_turning);
    const auto place = turning_place<Number>(t);
    return curvature_jet(arc_on_level<Number>(1 - m_turning), {t, t}).curvature +
        curvature_jet(a, place.middle()).curvature + place.step * curvature_jet(a, place.around).change;
  }

  Interval change_of_curvatures(const Range& range) const
  {
    if (!has_sum_of_curvatures())
      return any_number();
    const auto b = curvature_jet(moving_arc(), range), a = curvature_jet(turning_arc(), turning_range(range));
    return b.change + a.change * b.turn / a.turn;
  }

  // Tangential to the piece.
  Interval_pair direction(const Range& range) const { return tangent_jet(moving_arc(), range, false).tangent; }

  // The parameters of the arcs of both regions, about.
  std::array<double, 2> parameters(double t) const
  {
    std::array<double, 2> result{t, t};
    result[m_turning] = has_corner() ? 1 : turning_range({t, t}).middle();
    return result;
  }

  // The parameters of the turning arc in a range of the moving one.
  Range turning_range(const Range& range) const { return turning_range(range, direction(range)); }

  const Region_element& element(std::size_t region) const { return m_regions[region]->elements()[m_elements[region]]; }
  const Site_arc_2<>& arc(std::size_t region) const { return arc_on_level<Interval>(region); }

  // Whether the ends of two pieces are the same, so that one goes on as the other one: if both regions are at the same
  // joint, or corner; or one is, and the other one has its direction, which an element that turns has once.
  static bool are_same(const Convolution_piece_2& p, int p_end, const Convolution_piece_2& q, int q_end)
  {
    const auto have_common_place = [&](std::size_t region) {
      const std::optional<std::size_t> a = p.place(p_end, region), b = q.place(q_end, region);
      return a && b && *a == *b;
    };
    const auto have_common_direction = [&](std::size_t region) {   // that of a joint
      const auto &a = p.m_ends[p_end].joints[region], &b = q.m_ends[q_end].joints[region];
      return a && b && *a == *b && p.m_elements[1 - region] == q.m_elements[1 - region] &&
          p.element(1 - region).turn != Turn::STRAIGHT;
    };
    const auto &inflection = p.m_ends[p_end].inflection, &other = q.m_ends[q_end].inflection;
    return (inflection && inflection == other) || (have_common_place(0) && have_common_place(1)) ||
        have_common_direction(0) || have_common_direction(1) ||
        (have_common_place(0) && are_opposite(p, p_end, q, q_end, 1)) ||
        (have_common_place(1) && are_opposite(p, p_end, q, q_end, 0));
  }

private:
  // On a segment, the parameter of a point of its line; some other one tells where that is.
  std::optional<Exact_rational> parameter_on_line(const Exact_pair& point, const Exact_rational& other) const
  {
    const std::optional<Exact_pair> p = exact_point(other);
    if (!p)
      return std::nullopt;
    const Exact_pair q = moving_arc().at(other);
    return moving_arc().parameter_of_foot(
        {Exact_rational(point[0] - (*p)[0] + q[0]), Exact_rational(point[1] - (*p)[1] + q[1])});
  }

  // Near a cusp, where points move little, they are known better from one of them and the derivative.
  bool may_hold(const Interval_pair& point, const Range& part) const
  {
    const Traced_jet jet = (*this)(part);
    const Range inner = inner_range(), middle{part.middle(), part.middle()};
    if (!may_meet(point, jet.point) || !(inner.begin <= middle.begin && middle.end <= inner.end))
      return may_meet(point, jet.point);
    return may_meet(point, (*this)(middle).point + (jet.speed * (part.interval() - middle.interval())) * jet.direction);
  }

  // The first small part, or the last one, of a range that a point may be on.
  std::optional<Range> outermost_place(const Interval_pair& point, const Range& part, bool is_first) const
  {
    constexpr double enough = 0x1p-40;
    if (!may_hold(point, part))
      return std::nullopt;
    if (!(part.width() > enough))
      return part;
    const Range before{part.begin, part.middle()}, behind{part.middle(), part.end};
    const std::optional<Range> result = outermost_place(point, is_first ? before : behind, is_first);
    return result ? result : outermost_place(point, is_first ? behind : before, is_first);
  }

  bool has_sum_of_curvatures() const
  {
    return !has_corner() && !turning_arc().has_singular_end() && !moving_arc().has_singular_end();
  }

  // The speed, which has bounds, is the sum of both curvatures divided by that of the turning arc.
  Interval speed_near_cusp(const Range& range, const Interval& bounds) const
  {
    const Interval sum = sum_of_curvatures<Interval>(range.middle()) +
        change_of_curvatures(range) * (range.interval() - Interval(range.middle()));
    return common_part(bounds, sum / curvature_jet(turning_arc(), turning_range(range)).curvature);
  }

  // Whether a region is in the same point in two ends, of an arc and of the same one in the opposite direction: where
  // this has a direction that its elements, which overlap, have once together.
  static bool are_opposite(const Convolution_piece_2& p, int p_end, const Convolution_piece_2& q, int q_end,
                           std::size_t region)
  {
    const Region_element &a = p.element(region), &b = q.element(region);
    const auto &d = p.end(p_end).direction, &e = q.end(q_end).direction;
    return !a.is_corner && !b.is_corner && (a.turn == Turn::LEFT || a.turn == Turn::RIGHT) &&
        p.m_regions[region]->is_other_side(a.arc, b.arc) && a.range.begin < 1 - b.range.begin &&
        1 - b.range.end < a.range.end && d && e && sign_of(exact_cross(*d, *e)) == 0 && sign_of(exact_dot(*d, *e)) < 0;
  }

  // The number of the joint that a region is at in an end of the piece. At a corner, whose elements are all at one
  // point, that of the first one.
  std::optional<std::size_t> place(int end, std::size_t region) const
  {
    if (m_ends[end].joints[region])
      return m_regions[region]->place_of_joint(*m_ends[end].joints[region]);
    return element(region).is_corner ? std::optional(m_regions[region]->place_of_joint(m_elements[region]))
                                     : std::nullopt;
  }

  // With the direction of the moving arc. An end at an inflection is that of no element of the turning arc alone.
  Range turning_range(const Range& range, const Interval_pair& direction) const
  {
    if (m_is_double)
      return range;
    const Range& all = element(m_turning).range;
    Range result = turning_parameter(direction, all);
    for (const Convolution_end& end : m_ends)
      if (const bool is_behind = end.range.middle() > all.middle();
          end.inflection && (is_behind ? result.end == all.end : result.begin == all.begin))
        result = united(result, end.range);
    return result;
  }

  // Where the turning arc has a direction within these bounds, in a range: a zero of a function that increases. By
  // Newton's method, or from a few signs where that does not help, as the slope is nearly zero.
  template <Enclosing_number Number>
  Range turning_parameter(const std::array<Number, 2>& direction, Range u) const
  {
    constexpr double enough = 0.8;
    const auto& a = arc_on_level<Number>(m_turning);
    const auto value = [&](double t) { return cross(direction, tangent_jet(a, {t, t}, false).tangent); };
    for (;;) {
      Range next = u;
      if (const Number slope = cross(direction, tangent_jet(a, u).change); certain_sign(slope) > 0) {
        const Number zero = Number(u.middle()) - value(u.middle()) / slope;
        next = {(std::min)((std::max)(zero.inf(), u.begin), u.end), (std::max)((std::min)(zero.sup(), u.end), u.begin)};
      }
      if (!(next.width() < enough * u.width()))
        for (const double part : {0.5, 0.25, 0.75}) {
          const double t = u.begin + part * u.width();
          if (const int sign = certain_sign(value(t)); sign != 0 && next.begin < t && t < next.end) {
            (sign > 0 ? next.end : next.begin) = t;
            break;
          }
        }
      if (!(next.width() < enough * u.width()))
        return next;
      u = next;
    }
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_PIECE_2_H
