// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_PAIR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_PAIR_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Parameter_place.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Turned_segment.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/meetings_in_space.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Two operands of closed forms by their numbers, what is zero on them, where points are on them, and the common points
// that are found.
template <int d>
class Elementary_pair
{
protected:
  using Point = Coordinates<Interval, d>;
  using Operand = Elementary_operand<d>;

  std::array<Operand, 2> m_operands;
  Scratch_list<Elementary_point<d>> m_points;

private:
  mutable std::array<std::array<double, 2>, d> m_control_points{};   // of a point or segment

protected:
  Elementary_pair(const Operand& first, const Operand& second)
    : m_operands{in_simplest_form(first), in_simplest_form(second)}
  {}

  // A curve of degree one is a segment.
  static Operand in_simplest_form(const Operand& operand)
  {
    if (operand.kind != Elementary_kind::CURVE || operand.degrees[0] != 1 || !operand.is_one_piece())
      return operand;
    Operand result(operand);
    result.kind = Elementary_kind::SEGMENT;
    for (std::size_t i = 0; i < d; ++i) {
      result.numbers[i] = operand.coefficients[i][0];
      result.numbers[d + i] = operand.coefficients[i][1];
    }
    return result;
  }

  bool has_finite_numbers(std::size_t k) const
  {
    return std::all_of(m_operands[k].numbers.begin(), m_operands[k].numbers.end(),
                       [](double x) { return std::isfinite(x); });
  }

  std::size_t number_of_parameters(std::size_t k) const
  {
    switch (m_operands[k].kind) {
    case Elementary_kind::POINT: return 0;
    case Elementary_kind::PLANE:
    case Elementary_kind::TRIANGLE:
    case Elementary_kind::TURNED_SEGMENT:
    case Elementary_kind::PATCH: return 2;
    case Elementary_kind::SPHERE: return d - 1;
    default: return 1;
    }
  }

  bool is_line(std::size_t k) const
  {
    const Elementary_kind kind = m_operands[k].kind;
    return kind == Elementary_kind::EQUATION_LINE || kind == Elementary_kind::VECTOR_LINE ||
        kind == Elementary_kind::RAY || kind == Elementary_kind::SEGMENT;
  }

  bool is_sphere(std::size_t k) const
  {
    return m_operands[k].kind == Elementary_kind::SPHERE && m_operands[k].numbers[d] > 0;
  }

  bool is_plane(std::size_t k) const
  {
    const auto& n = m_operands[k].numbers;
    return m_operands[k].kind == Elementary_kind::PLANE && (n[0] != 0 || n[1] != 0 || n[2] != 0);
  }

  bool is_triangle(std::size_t k) const { return m_operands[k].kind == Elementary_kind::TRIANGLE; }
  bool is_turned(std::size_t k) const { return m_operands[k].kind == Elementary_kind::TURNED_SEGMENT; }

  bool has_side(std::size_t k) const
  {
    if constexpr (d == 2)
      if (is_line(k))
        return known_sign(squared_length(affine_line<Interval>(m_operands[k]).direction)) > 0;
    if constexpr (d == 3) {
      if (is_plane(k))
        return true;
      if (is_turned(k))
        return is_turned_segment(m_operands[k]);
      if (is_triangle(k))
        return known_sign(squared_length(Triangle_frame<Interval>(m_operands[k]).normal())) > 0;
    }
    return is_sphere(k);
  }

  template <class Number>
  Number side_of(std::size_t k, const Coordinates<Number, d>& point) const
  {
    if constexpr (d == 2) {
      if (is_line(k))
        return side_of_line(m_operands[k], point);
    } else if (is_plane(k))
      return side_of_plane(m_operands[k], point);
    else if (is_turned(k))
      return Turned_segment<Number>(m_operands[k]).polar(point, point);
    else if (is_triangle(k)) {
      const Triangle_frame<Number> frame(m_operands[k]);
      return inner_product(frame.normal(), difference(point, frame.corner));
    }
    return side_of_sphere(m_operands[k], point);
  }

  Decided_place place_of(std::size_t k, const Point& point, [[maybe_unused]] const Operand& other) const
  {
    if constexpr (d == 2) {
      if (is_line(k))
        return place_on(k, parameter_on_line(m_operands[k], point));
    } else if (is_plane(k))
      return place_on_plane(m_operands[k], other, point);
    else if (is_triangle(k))
      return place_on_triangle(sides_of_triangle(m_operands[k], point));
    else if (is_turned(k))
      return place_on_turned_segment(Turned_segment<Interval>(m_operands[k]), point);
    return place_on_sphere(m_operands[k], difference(point, coordinates_of<Interval>(m_operands[k])));
  }

  // A segment or point as a curve.
  Operand curve_of_points(std::size_t k, std::size_t size) const
  {
    Operand result(m_operands[k]);
    if (result.coefficients[0].empty()) {
      result.degrees = {static_cast<int>(size) - 1, 0};
      for (std::size_t i = 0; i < d; ++i) {
        m_control_points[i] = {result.numbers[i], result.numbers[size == 1 ? i : d + i]};
        result.coefficients[i] = std::span<const double>(m_control_points[i].data(), size);
      }
    }
    return result;
  }

  // Whether a curve ends where it begins, or is not seen not to.
  static bool is_closed(const Operand& curve)
  {
    const std::size_t degree = static_cast<std::size_t>(curve.degrees[0]), size = curve.coefficients[0].size();
    const auto first = piece_of<Exact_rational>(curve, degree).front(),
               last = piece_of<Exact_rational>(curve, curve.is_one_piece() ? degree : size - 1).back();
    return first == last;
  }

  // Adds a common point, unless it is on one of them only. False where this is not decided.
  bool add(const Decided_place& place, const Decided_place& other_place, std::size_t k, const Point& point,
           int multiplicity)
  {
    using enum Decided_place::State;
    if (place.state == NONE || other_place.state == NONE)
      return true;
    if (place.state == UNDECIDED || other_place.state == UNDECIDED)
      return false;
    Elementary_point<d> result{Intersection_kind::TRANSVERSAL, {}, {}, multiplicity, std::nullopt, {}};
    bool is_at_end = false, goes_on = d == 2 && number_of_parameters(0) + number_of_parameters(1) == 2;
    for (const std::size_t i : {0, 1}) {
      const std::size_t begin = i == 0 ? 0 : number_of_parameters(0);
      const Parameter_place& own = i == k ? place.place : other_place.place;
      for (std::size_t axis = 0; axis < number_of_parameters(i); ++axis) {
        const Interval& parameter = own.parameters[axis];
        result.parameters[begin + axis] = {parameter.inf(), parameter.sup()};
        result.is_at_end[begin + axis] = own.is_at_end[axis];
        is_at_end = is_at_end || own.is_at_end[axis];
        goes_on = goes_on && (!own.is_at_end[axis] || m_operands[i].kind == Elementary_kind::SPHERE);
      }
    }
    const bool is_pole = place.place.is_pole || other_place.place.is_pole;
    result.kind = multiplicity > 1 && !is_pole ? Intersection_kind::TANGENT
        : is_at_end                            ? Intersection_kind::END_POINT
                                               : Intersection_kind::TRANSVERSAL;
    if (is_pole)
      result.multiplicity = 0;
    if (goes_on)
      result.passage = multiplicity > 1 ? Passage::TOUCHES : Passage::CROSSES;
    for (std::size_t i = 0; i < d; ++i)
      result.point[i] = point[i].inf() + (point[i].sup() - point[i].inf()) / 2;
    m_points.push_back(std::move(result));
    return true;
  }

  // From the unit interval to a range.
  static Interval on_range(const std::array<double, 2>& range, const Interval& t)
  {
    const auto [begin, end] = range;
    if (begin == 0 && end == 1)
      return t;
    if (t.is_same(Interval(1)))
      return Interval(end);
    return common_part(Interval(begin) + (Interval(end) - Interval(begin)) * t, Interval(begin, end));
  }

  // The place on a line or segment, with the parameter of its own domain.
  Decided_place place_on(std::size_t line, const Interval& t) const
  {
    Decided_place result = place_on_line(m_operands[line].kind, t);
    if (m_operands[line].kind == Elementary_kind::SEGMENT && result.state == Decided_place::State::FOUND)
      result.place.parameters[0] = on_range(m_operands[line].domain[0], result.place.parameters[0]);
    return result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_PAIR_H
