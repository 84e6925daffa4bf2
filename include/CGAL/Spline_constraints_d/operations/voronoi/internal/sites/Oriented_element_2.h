// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ORIENTED_ELEMENT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ORIENTED_ELEMENT_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

using Common::range_at;

// One of the ends of an arc: its begin or its end.
struct Arc_end
{
  std::size_t arc;
  bool is_end;

  double parameter() const { return is_end ? 1 : 0; }
  bool operator==(const Arc_end&) const = default;
};

inline Range range_at(const Arc_end& end, double width) { return range_at(end.parameter(), width); }

/*
One side of an arc, or the normals of a vertex between two sides: what disks touch. Elements are traversed with the free
side on the left: an arc on its left side from 0 to 1, on its right side from 1 to 0; and a normal cone clockwise from
its first normal to its second one, with the normal (1-u) n0 + u n1, so that all normals are polynomials in u.
*/
template <Enclosing_number Interval = Common::Interval>
struct Oriented_element
{
  using Interval_pair = std::array<Interval, 2>;

  bool is_normal_cone;
  std::size_t object;        // an arc, or a vertex
  bool is_reversed = false;  // the right side of an arc
  std::array<Exact_pair, 2> exact_normals{};
  std::array<Interval_pair, 2> normals{};
  std::array<std::vector<Arc_end>, 2> perpendicular_ends{};   // to the exact normals, of arcs that end in the vertex
  std::size_t next = 0;      // where the traversal goes on
  std::size_t cycle = 0, component = 0;   // of the traversal, and of the connected arcs that it belongs to
};

// Enclosures of the point of an element, its normal, which has any length, and their derivatives.
template <Enclosing_number Interval = Common::Interval>
struct Element_jet
{
  using Interval_pair = std::array<Interval, 2>;

  Interval_pair point, point_derivative, normal, normal_derivative;
};

// The arc that goes on in the direction in which another one ends, and the ratio of its speed to that of the other one
// there; of any size, if one of them is zero.
template <Enclosing_number Interval = Common::Interval>
struct Smooth_continuation
{
  Arc_end end;
  Interval speed_ratio;
};

// The arc that goes on in nearly that direction: with its parameter multiplied by a number the derivative has a small
// jump there. The angle is reflex on the left side of the way to that arc, or on the right one.
template <Enclosing_number Interval = Common::Interval>
struct Nearly_smooth_continuation
{
  using Interval_pair = std::array<Interval, 2>;

  Arc_end end;
  double scale;
  Interval_pair jump;
  bool is_left_reflex;
};

// How an arc goes on: smoothly, as each of those that leave the vertex in the direction in which it arrives, of which
// one may be that which is meant; or nearly so.
template <Enclosing_number Interval>
struct Arc_continuations
{
  std::optional<Smooth_continuation<Interval>> only;
  std::vector<Smooth_continuation<Interval>> smooth;
  std::optional<Nearly_smooth_continuation<Interval>> nearly_smooth;

  const Smooth_continuation<Interval>* smooth_at(const Arc_end& end) const
  {
    const auto result = std::find_if(smooth.begin(), smooth.end(),
                                     [&](const Smooth_continuation<Interval>& next) { return next.end == end; });
    return result == smooth.end() ? nullptr : &*result;
  }

  bool hold(const Arc_end& end) const
  {
    return smooth_at(end) != nullptr || (nearly_smooth && nearly_smooth->end == end);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ORIENTED_ELEMENT_2_H
