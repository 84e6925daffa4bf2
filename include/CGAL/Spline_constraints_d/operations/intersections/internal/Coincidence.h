// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COINCIDENCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COINCIDENCE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The points origin + sum of parameters times directions.
template <int d>
struct Affine_frame
{
  using Coordinates = std::array<Exact_rational, d>;

  Coordinates origin;
  std::vector<Coordinates> directions;
};

template <int d>
typename Affine_frame<d>::Coordinates point_of(const Affine_frame<d>& frame,
                                               const std::vector<Exact_rational>& parameters)
{
  auto result = frame.origin;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (int i = 0; i < d; ++i)
      result[i] += Exact_rational(parameters[k] * frame.directions[k][i]);
  return result;
}

// The affine map that agrees with a patch at a corner and the corners next to it.
template <int d>
Affine_frame<d> frame_at_corner(const Spline_patch<d>& patch)
{
  const std::vector<Exact_rational> corner = patch.first_corner();
  Affine_frame<d> result{patch(corner), {}};
  for (int axis = 0; axis < patch.number_of_parameters(); ++axis) {
    std::vector<Exact_rational> next = corner;
    next[axis] = patch.domain(axis).second;
    auto direction = patch(next);
    for (int i = 0; i < d; ++i)
      direction[i] = Exact_rational((direction[i] - patch(corner)[i]) / (next[axis] - corner[axis]));
    result.directions.push_back(direction);
  }
  for (std::size_t k = 0; k < corner.size(); ++k)
    for (int i = 0; i < d; ++i)
      result.origin[i] -= Exact_rational(corner[k] * result.directions[k][i]);
  return result;
}

// The points of a patch in its parameters, if these are affine coordinates. A point always has them.
template <int d>
std::optional<Affine_frame<d>> affine_frame(const Spline_patch<d>& patch)
{
  const Affine_frame<d> frame = frame_at_corner(patch);
  const int n = patch.number_of_parameters();
  if (n == 0)
    return frame;
  if (point_of(frame, patch.middle()) != patch(patch.middle()))   // most patches end here
    return std::nullopt;
  std::vector<std::vector<Exact_rational>> knots, corners(1);
  for (int axis = 0; axis < n; ++axis) {
    const auto [begin, end] = patch.domain(axis);
    knots.push_back({begin, begin, end, end});
    std::vector<std::vector<Exact_rational>> longer;
    for (const std::vector<Exact_rational>& corner : corners)
      for (const Exact_rational& next : {begin, end}) {
        longer.push_back(corner);
        longer.back().push_back(next);
      }
    corners = std::move(longer);
  }
  for (int i = 0; i < d; ++i) {
    std::vector<Exact_rational> values;
    for (const std::vector<Exact_rational>& corner : corners)
      values.push_back(point_of(frame, corner)[i]);
    if (!(patch.numerators()[i] == patch.weight() * Exact_function(std::vector<int>(n, 1), knots, values)))
      return std::nullopt;
  }
  return frame;
}

// A patch in coordinates in which a frame is the first axes: its parameters there, then zeros. None if the directions
// of the frame are linearly dependent.
template <int d>
std::optional<Spline_patch<d>> in_coordinates_of(Affine_frame<d> frame, const Spline_patch<d>& patch)
{
  Vector_of_functions<d> x = patch.numerators();
  for (int i = 0; i < d; ++i)
    x[i] = x[i] - patch.weight() * frame.origin[i];
  auto& directions = frame.directions;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < d; ++i)
      if (CGAL::abs(directions[k][pivot]) < CGAL::abs(directions[k][i]))
        pivot = i;
    const Exact_rational length = directions[k][pivot];
    if (length == 0)
      return std::nullopt;
    std::swap(x[k], x[pivot]);
    x[k] = x[k] * Exact_rational(1 / length);
    for (auto& direction : directions) {
      std::swap(direction[k], direction[pivot]);
      direction[k] = Exact_rational(direction[k] / length);
    }
    const auto own = directions[k];
    for (std::size_t i = 0; i < d; ++i)
      if (i != k && own[i] != 0) {
        x[i] = x[i] - x[k] * own[i];
        for (auto& direction : directions)
          direction[i] -= Exact_rational(direction[k] * own[i]);
      }
  }
  return patch.with_numerators(std::move(x));
}

/*
The equations A = B of two patches. If the points of one of them are affine in its parameters, these are eliminated: in
coordinates in which it is a coordinate axis or plane, the parameters are coordinates of the other one, and the
remaining coordinates have to be zero.
*/
template <int d>
class Coincidence
{
  Patch_pair<d> m_pair;
  std::size_t m_eliminated = 2;                // the operand whose parameters are; 2: none
  std::optional<Spline_patch<d>> m_position;   // the other one in its coordinates

public:
  explicit Coincidence(Patch_pair<d> pair) : m_pair(std::move(pair))
  {
    const std::size_t larger = m_pair[0].number_of_parameters() < m_pair[1].number_of_parameters() ? 1 : 0;
    for (const std::size_t operand : {larger, 1 - larger})
      if (!m_position)
        if (const auto frame = affine_frame(m_pair[operand])) {
          m_position = in_coordinates_of(*frame, m_pair[1 - operand]);
          m_eliminated = m_position ? operand : 2;
        }
  }

  // Whether the parameters of an operand are.
  bool has_eliminated(std::size_t operand) const { return m_eliminated == operand; }

  // The operand that is not, in coordinates in which the other one is one of the first axes, or the plane of two. \pre
  // There is one.
  const Spline_patch<d>& position() const { return *m_position; }

  // The range of the unknowns: the parameters that are not eliminated.
  Parameter_box unknown_ranges() const { return unknowns_of(m_pair.domain()); }

  // The unknowns as symbols.
  std::vector<Unknown> unknowns() const
  {
    std::vector<std::array<Bound, 2>> ranges;
    for (const auto& [lower, upper] : unknown_ranges())
      ranges.push_back({Bound(lower), Bound(upper)});
    return ranges.empty() ? std::vector<Unknown>() : Spline_constraints::unknowns(ranges);
  }

  // The equations, and that all parameters are in their ranges, without the upper ends of some of these.
  std::vector<Constraint> constraints(std::span<const Unknown> u, const std::vector<bool>& is_open) const
  {
    std::vector<Constraint> result =
        m_position ? constraints_on_position(u, is_open) : equations(difference(u), 0, u.size());
    const std::vector<bool> open = unknowns_of(is_open);
    for (std::size_t j = 0; j < u.size(); ++j)
      if (open[j])
        result.push_back(u[j] < u[j].domain().second);
    return result;
  }

  // A normal of an operand that is a surface.
  Vector_expression<d> normal(std::size_t operand, std::span<const Unknown> u) const
    requires (d == 3)
  {
    if (m_eliminated == operand) {
      const Affine_frame<d> frame = frame_at_corner(m_pair[operand]);
      const auto constant = [&](int k) {
        return vector_of<d>([&](std::size_t i) { return Expression(frame.directions[k][i]); });
      };
      return cross(constant(0), constant(1));
    }
    return cross(tangent(operand, 0, u), tangent(operand, 1, u));
  }

  // The derivative by an axis of an operand that is not eliminated.
  Vector_expression<d> tangent(std::size_t operand, int axis, std::span<const Unknown> u) const
  {
    const std::size_t begin = m_position || operand == 0 ? 0 : m_pair.first_parameter(1);
    return Parametric_vector<d>(m_pair[operand])
        .tangent(axis)(u.subspan(begin, m_pair[operand].number_of_parameters()));
  }

  // All parameters, where the unknowns are in a box.
  Parameter_box all_parameters(const Parameter_box& box) const
  {
    if (!m_position)
      return clipped(box, m_pair.domain());
    const Parameter_box other = clipped(box, unknown_ranges()), near = clipped(with_short_ends(box), unknown_ranges());
    Parameter_box own;
    for (int k = 0; k < m_pair[m_eliminated].number_of_parameters(); ++k) {
      const Rational_interval range = m_position->coordinate(k).part(near).tight_values()[0];
      own.emplace_back(range.lower, range.upper);
    }
    own.insert(m_eliminated == 0 ? own.end() : own.begin(), other.begin(), other.end());
    return clipped(own, m_pair.domain());
  }

  // A box of unknowns, with the whole ranges of the parameters that are eliminated.
  Parameter_box with_whole_ranges(const Parameter_box& box) const
  {
    Parameter_box result = m_pair.domain();
    std::copy(box.begin(), box.end(), result.begin() + static_cast<std::ptrdiff_t>(first_unknown()));
    return clipped(result, m_pair.domain());
  }

private:
  std::size_t first_unknown() const { return m_position && m_eliminated == 0 ? m_pair.first_parameter(1) : 0; }

  template <class Sequence>
  Sequence unknowns_of(const Sequence& all) const
  {
    const std::size_t count =
        m_position ? static_cast<std::size_t>(m_pair[1 - m_eliminated].number_of_parameters()) : all.size();
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first_unknown());
    return Sequence(begin, begin + static_cast<std::ptrdiff_t>(count));
  }

  Vector_expression<d> difference(std::span<const Unknown> u) const
  {
    const std::size_t split = m_pair.first_parameter(1);
    return Parametric_vector<d>(m_pair[0])(u.first(split)) - Parametric_vector<d>(m_pair[1])(u.subspan(split));
  }

  std::vector<Constraint> constraints_on_position(std::span<const Unknown> u, const std::vector<bool>& is_open) const
  {
    const Spline_patch<d>& own = m_pair[m_eliminated];
    const Vector_expression<d> position = Parametric_vector<d>(*m_position)(u);
    std::vector<Constraint> result = equations(position, own.number_of_parameters(), u.size());
    for (int k = 0; k < own.number_of_parameters(); ++k) {
      const auto [begin, end] = own.domain(k);
      result.push_back(position[k] >= begin);
      result.push_back(is_open[m_pair.first_parameter(m_eliminated) + k] ? position[k] < end : position[k] <= end);
    }
    return result;
  }

  // That coordinates are zero, without those that are everywhere, as long as there are as many equations as unknowns.
  static std::vector<Constraint> equations(const Vector_expression<d>& x, int first, std::size_t number_of_unknowns)
  {
    std::vector<Constraint> result;
    for (int i = first; i < d; ++i)
      result.push_back(x[i] == 0);
    for (auto trivial = result.begin(); trivial != result.end() && result.size() > number_of_unknowns;)
      trivial = trivial->function.is_zero() ? result.erase(trivial) : trivial + 1;
    return result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COINCIDENCE_H
