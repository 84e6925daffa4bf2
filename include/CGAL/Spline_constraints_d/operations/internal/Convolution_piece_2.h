// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CONVOLUTION_PIECE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CONVOLUTION_PIECE_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Traced_curve_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// An end of a piece: a range that the parameter is in, and the joints of the elements of both regions that it is at.
struct Convolution_end
{
  Range range;
  std::array<std::optional<std::size_t>, 2> joints;
};

/*
The sums of the points of two elements with the same direction. One of them, the turning one, turns to the left, so that it has one point for each direction; the parameter is that of the other one, the moving arc.
*/
class Convolution_piece_2
{
  std::array<const Region_elements_2*, 2> m_regions;
  std::array<std::size_t, 2> m_elements;   // of the two regions
  std::size_t m_turning;                   // the region of the turning element
  std::array<Convolution_end, 2> m_ends;

public:
  Convolution_piece_2(const std::array<const Region_elements_2*, 2>& regions, const std::array<std::size_t, 2>& elements, std::size_t turning, const std::array<Convolution_end, 2>& ends)
    : m_regions(regions), m_elements(elements), m_turning(turning), m_ends(ends)
  {}

  const std::array<Convolution_end, 2>& ends() const { return m_ends; }
  Range range() const { return {m_ends[0].range.begin, m_ends[1].range.end}; }
  Range inner_range() const { return {m_ends[0].range.end, m_ends[1].range.begin}; }

  // A part, whose new ends are not at joints.
  Convolution_piece_2 restricted(const Range& range) const
  {
    Convolution_piece_2 result(*this);
    if (range.begin > m_ends[0].range.begin)
      result.m_ends[0] = {{range.begin, range.begin}, {}};
    if (range.end < m_ends[1].range.end)
      result.m_ends[1] = {{range.end, range.end}, {}};
    return result;
  }

  /*
  The point and the derivative. With parallel derivatives a' = l b' of the two arcs, the derivative of the sum is b' times

    1 + l^3 (b' x b'') / (a' x a'').
  */
  Traced_jet operator()(const Range& range) const
  {
    const Region_element &turning = element(m_turning), &moving = element(1 - m_turning);
    const Curve_jet b = arc(1 - m_turning).jet(range, 2);
    if (turning.is_corner)
      return {arc(m_turning).point({1, 1}) + b[0], b[1]};
    const Curve_jet a = arc(m_turning).jet(turning_parameter(b[1]), 2);
    if (moving.turn == Turn::STRAIGHT)
      return {a[0] + b[0], b[1]};
    const Interval ratio = dot(a[1], b[1]) / squared_norm(b[1]), factor = Interval(1) + ratio * CGAL::square(ratio) * (cross(b[1], b[2]) / cross(a[1], a[2]));
    return {a[0] + b[0], factor * b[1]};
  }

  // The parameters of the arcs of both regions, about.
  std::array<double, 2> parameters(double t) const
  {
    std::array<double, 2> result{t, t};
    result[m_turning] = element(m_turning).is_corner ? 1 : turning_parameter(arc(1 - m_turning).jet({t, t}, 1)[1]).middle();
    return result;
  }

  const Region_element& element(std::size_t region) const { return m_regions[region]->elements()[m_elements[region]]; }
  const Site_arc_2& arc(std::size_t region) const { return m_regions[region]->arcs()[element(region).arc]; }

  // Whether the ends of two pieces are the same, so that one goes on as the other one: if both regions are at the same joint, or corner; or one is, and the other one has its direction, which an element that turns has once.
  static bool are_same(const Convolution_piece_2& p, int p_end, const Convolution_piece_2& q, int q_end)
  {
    const auto have_common_place = [&](std::size_t region) {
      const std::optional<std::size_t> a = p.place(p_end, region), b = q.place(q_end, region);
      return a && b && *a == *b;
    };
    const auto have_common_direction = [&](std::size_t region) {   // that of a joint
      const auto &a = p.m_ends[p_end].joints[region], &b = q.m_ends[q_end].joints[region];
      return a && b && *a == *b && p.m_elements[1 - region] == q.m_elements[1 - region] && p.element(1 - region).turn != Turn::STRAIGHT;
    };
    return (have_common_place(0) && have_common_place(1)) || have_common_direction(0) || have_common_direction(1);
  }

private:
  // The number of the joint that a region is at in an end of the piece. At a corner, whose elements are all at one point, that of the first one.
  std::optional<std::size_t> place(int end, std::size_t region) const
  {
    if (m_ends[end].joints[region])
      return m_regions[region]->place_of_joint(*m_ends[end].joints[region]);
    return element(region).is_corner ? std::optional(m_regions[region]->place_of_joint(m_elements[region])) : std::nullopt;
  }

  // Where the derivative of the turning arc has a direction within these bounds: a zero of a function that increases. By Newton's method, or from a few signs where the slope is not certain.
  Range turning_parameter(const Interval_pair& direction) const
  {
    constexpr double enough = 0.8;
    const Site_arc_2& a = arc(m_turning);
    const auto value = [&](double t) { return cross(direction, a.jet({t, t}, 1)[1]); };
    for (Range u = element(m_turning).range;;) {
      Range next = u;
      if (const Interval slope = cross(direction, a.jet(u, 2)[2]); certain_sign(slope) > 0) {
        const Interval zero = Interval(u.middle()) - value(u.middle()) / slope;
        next = {(std::min)((std::max)(zero.inf(), u.begin), u.end), (std::max)((std::min)(zero.sup(), u.end), u.begin)};
      } else
        for (const double part : {0.5, 0.25, 0.75}) {
          const double t = u.begin + part * u.width();
          if (const int sign = certain_sign(value(t)); sign != 0) {
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

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CONVOLUTION_PIECE_2_H
