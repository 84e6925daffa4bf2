// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_POINT_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Rounded_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// A point of a piece, or all of them for ranges of parameters, and its first derivatives, in intervals. Rounding has to
// be upward.
template <int d>
struct Piece_point
{
  std::array<Interval, d> point;
  std::array<std::array<Interval, d>, 2> tangents;

  // At doubles or in intervals.
  template <class Parameter>
  Piece_point(const Rounded_piece<d>& piece, const std::array<Parameter, 2>& x)
  {
    const auto jet = [&](const Rounded_tensor& f) {
      if (f.error == 0)
        return jet_at<Interval>(
            piece.degrees, [&](std::size_t k) { return Interval(f.begin[k]); }, x);
      return jet_at<Interval>(
          piece.degrees, [&](std::size_t k) { return Interval(f.begin[k]) + Interval(-f.error, f.error); }, x);
    };
    Second_jet<Interval> weight{};
    if (piece.is_rational())
      weight = jet(piece.weights);
    for (int i = 0; i < d; ++i) {
      const Second_jet<Interval> numerator = jet(piece.points[i]);
      point[i] = piece.is_rational() ? numerator.value / weight.value : numerator.value;
      for (int axis = 0; axis < piece.axes; ++axis)
        tangents[axis][i] = piece.is_rational() ? (numerator.first[axis] - point[i] * weight.first[axis]) / weight.value
                                                : numerator.first[axis];
    }
  }
};

// Half the squared distance of points of two pieces, with its gradient by their parameters.
template <int d>
struct Distance_jet
{
  Interval squared_distance;
  std::array<Interval, 2> half_gradient{Interval(0), Interval(0)};
  std::array<std::array<Interval, d>, 2> points;

  // At parameters of the pieces, those of the first one before those of the second one.
  Distance_jet(const Rounded_piece<d>& a, const Rounded_piece<d>& b, const std::array<double, 2>& x)
  {
    const Piece_point<d> first(a, x), second(b, a.axes == 0 ? x : std::array<double, 2>{x[1], 0.0});
    points = {first.point, second.point};
    const std::array<Interval, d> offset = first.point - second.point;
    squared_distance = squared_norm(offset);
    for (int axis = 0; axis < a.axes; ++axis)
      half_gradient[axis] = dot(offset, first.tangents[axis]);
    for (int axis = 0; axis < b.axes; ++axis)
      half_gradient[a.axes + axis] = -dot(offset, second.tangents[axis]);
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_POINT_H
