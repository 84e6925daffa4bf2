// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_FINDER_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Affine_overlap.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Parameter_place.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Turned_segment.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/meetings_in_space.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <list>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The common points of two operands by closed forms: where what is zero on one of them, a form of degree one or two, is
zero on the other one, a curve. Intervals of doubles decide, and rational numbers only the signs that these leave open.
Functions return whether they have decided everything; where one has not, nothing of its points is used.
*/
template <int d>
class Elementary_finder
{
  using Point = Coordinates<Interval, d>;
  using Operand = Elementary_operand<d>;
  static constexpr std::size_t most_degree = 25;   // the binomial coefficients of twice it are doubles

  std::array<Operand, 2> m_operands;
  std::list<Elementary_point<d>> m_points;
  mutable std::array<std::array<double, 2>, d> m_control_points{};   // of a point or segment

public:
  Elementary_finder(const Operand& first, const Operand& second)
    : m_operands{in_simplest_form(first), in_simplest_form(second)}
  {}

  std::optional<Elementary_points<d>> operator()()
  {
    if (!has_finite_numbers(0) || !has_finite_numbers(1))
      return std::nullopt;
    if (!find(0, 1)) {
      m_points.clear();
      if (!find(1, 0))
        return std::nullopt;
    }
    const std::size_t split = number_of_parameters(0), size = split + number_of_parameters(1);
    for (const Elementary_point<d>& point : m_points)
      for (std::size_t j = 0; j < size; ++j)
        if (!std::isfinite(point.parameters[j].first) || !std::isfinite(point.parameters[j].second))
          return std::nullopt;
    m_points.sort([](const auto& x, const auto& y) { return x.parameters < y.parameters; });
    return Elementary_points<d>{split, size, std::move(m_points)};
  }

private:
  // A curve of degree one is a segment.
  static Operand in_simplest_form(const Operand& operand)
  {
    if (operand.kind != Elementary_kind::BEZIER || operand.degrees[0] != 1)
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

  // The common points of a point or curve with what has a form that is zero on it.
  bool find(std::size_t curve, std::size_t other)
  {
    const Elementary_kind kind = m_operands[curve].kind;
    if (kind == Elementary_kind::POINT)
      return find_point(curve, other);
    if (is_line(curve) && is_sphere(other))
      return find_on_line_and_sphere(curve, other);
    if constexpr (d == 2) {
      if (is_line(curve) && is_line(other))
        return find_on_lines(curve, other);
      if (is_sphere(curve) && is_sphere(other))
        return find_on_circles(curve, other);
    } else {
      if (is_line(curve) && is_line(other))
        return find_on_lines_in_space(curve, other);
      if (is_line(curve) && is_triangle(other))
        return find_on_line_and_triangle(curve, other);
      if (is_line(curve) && is_turned(other))
        return find_on_line_and_turned_segment(curve, other);
    }
    return kind == Elementary_kind::BEZIER || kind == Elementary_kind::SEGMENT ? find_on_curve(curve, other) : false;
  }

  // --- a point

  bool find_point(std::size_t point, std::size_t other)
  {
    const auto side = [&]<class Number>(const Number&) {
      return side_of(other, coordinates_of<Number>(m_operands[point]));
    };
    if (!has_side(other))
      return false;
    int sign = sign_of(side(Interval()));
    if (sign == 0)
      sign = sign_of(side(Exact_rational()));
    if (sign != 0)
      return true;
    const Point place = coordinates_of<Interval>(m_operands[point]);
    return add({Decided_place::State::FOUND}, place_of(other, place, curve_of_points(point, 1)), point, place, 1);
  }

  // --- two lines of the plane

  struct Meeting
  {
    Interval t, s;
  };

  template <class Number>
  std::optional<Meeting> meeting(std::size_t first, std::size_t second) const requires(d == 2)
  {
    const auto a = affine_line<Number>(m_operands[first]), b = affine_line<Number>(m_operands[second]);
    const Number area = determinant(a.direction, b.direction);
    if (sign_of(area) == 0)
      return std::nullopt;
    const auto between = difference(b.origin, a.origin);
    return Meeting{enclosure_of(Number(determinant(between, b.direction) / area)),
                   enclosure_of(Number(determinant(between, a.direction) / area))};
  }

  bool find_on_lines(std::size_t first, std::size_t second) requires(d == 2)
  {
    const auto add_meeting = [&](const Meeting& x) {
      const auto a = affine_line<Interval>(m_operands[first]);
      return add(place_on_line(m_operands[first].kind, x.t), place_on_line(m_operands[second].kind, x.s), first,
                 sum(a.origin, x.t, a.direction), 1);
    };
    if (const auto x = meeting<Interval>(first, second); x && add_meeting(*x))
      return true;
    if (const auto x = meeting<Exact_rational>(first, second))
      return add_meeting(*x);
    // parallel ones that are apart have no common points
    const auto a = affine_line<Exact_rational>(m_operands[first]), b = affine_line<Exact_rational>(m_operands[second]);
    return squared_length(a.direction) != 0 && squared_length(b.direction) != 0 &&
        determinant(a.direction, difference(b.origin, a.origin)) != 0;
  }

  // --- lines of space and triangles

  bool find_on_lines_in_space(std::size_t first, std::size_t second) requires(d == 3)
  {
    const Operand &a = m_operands[first], &b = m_operands[second];
    if (sign_of(volume_between_lines<Interval>(a, b)) != 0 || volume_between_lines<Exact_rational>(a, b) != 0)
      return true;
    const auto meeting = meeting_in_plane(a, b);
    if (!meeting)
      return are_apart_and_parallel(a, b);
    const auto points = affine_line<Interval>(a);
    return add(place_on_line(a.kind, (*meeting)[0]), place_on_line(b.kind, (*meeting)[1]), first,
               sum(points.origin, (*meeting)[0], points.direction), 1);
  }

  bool find_on_line_and_triangle(std::size_t line, std::size_t triangle) requires(d == 3)
  {
    const auto add_meeting = [&](const Meeting_with_triangle& x) {
      const auto points = affine_line<Interval>(m_operands[line]);
      return add(place_on_line(m_operands[line].kind, x.t), place_on_triangle(x.sides), line,
                 sum(points.origin, x.t, points.direction), 1);
    };
    if (const auto x = meeting_with_triangle<Interval>(m_operands[line], m_operands[triangle]); x && add_meeting(*x))
      return true;
    if (const auto x = meeting_with_triangle<Exact_rational>(m_operands[line], m_operands[triangle]))
      return add_meeting(*x);
    return is_beside_triangle(m_operands[line], m_operands[triangle]);
  }

  // --- a line and a cylinder or cone

  bool find_on_line_and_turned_segment(std::size_t line, std::size_t surface) requires(d == 3)
  {
    if (!is_turned_segment(m_operands[surface]))
      return false;
    const auto equation = [&]<class Number>(const Number&) {
      return equation_on_line(Turned_segment<Number>(m_operands[surface]), affine_line<Number>(m_operands[line]));
    };
    auto [a, b, c] = equation(Interval());
    Interval discriminant = CGAL::square(b) - a * c;
    int sign = sign_of(discriminant);
    if (sign == 0) {
      const auto exact = equation(Exact_rational());
      const Exact_rational value(exact[1] * exact[1] - exact[0] * exact[2]);
      a = enclosure_of(exact[0]);
      b = enclosure_of(exact[1]);
      discriminant = enclosure_of(value);
      sign = sign_of(value);
    }
    if (sign_of(a) == 0)
      return false;
    const auto points = affine_line<Interval>(m_operands[line]);
    const Turned_segment<Interval> form(m_operands[surface]);
    const auto add_root = [&](const Interval& t, int multiplicity) {
      const Point point = sum(points.origin, t, points.direction);
      return add(place_on_line(m_operands[line].kind, t), place_on_turned_segment(form, point), line, point,
                 multiplicity);
    };
    if (sign < 0)
      return true;
    if (sign == 0)
      return add_root(-b / a, 2);
    const Interval root = CGAL::sqrt(discriminant);
    return add_root((-b - root) / a, 1) && add_root((root - b) / a, 1);
  }

  // --- a line and a circle or sphere, two circles

  bool find_on_line_and_sphere(std::size_t line, std::size_t sphere)
  {
    const Operand& operand = m_operands[line];
    const auto form = [&]<class Number>(const Number&) { return affine_line<Number>(operand); };
    return for_roots_on_sphere(form, m_operands[sphere], [&](const Interval& t, int multiplicity, const Point& arm) {
      const Affine_line<Interval, d> points = affine_line<Interval>(operand);
      Decided_place place = place_on_line(operand.kind, t);
      for (const double end : {0.0, 1.0})
        if (place.state == Decided_place::State::UNDECIDED && t.inf() <= end && end <= t.sup() &&
            side_of_sphere(m_operands[sphere], coordinates_of<Exact_rational>(operand, end == 0 ? 0 : d)) == 0)
          place = place_on_line(operand.kind, Interval(end));
      return add(place, place_on_sphere(m_operands[sphere], arm), line,
                 sum(points.origin, t, points.direction), multiplicity);
    });
  }

  bool find_on_circles(std::size_t first, std::size_t second) requires(d == 2)
  {
    const Point center = coordinates_of<Interval>(m_operands[first]),
                between = difference(center, coordinates_of<Interval>(m_operands[second]));
    if (sign_of(squared_length(between)) == 0)
      return false;
    const auto form = [&]<class Number>(const Number&) {
      return radical_line<Number>(m_operands[first], m_operands[second]);
    };
    return for_roots_on_sphere(form, m_operands[first], [&](const Interval&, int multiplicity, const Point& arm) {
      return add(place_on_sphere(m_operands[first], arm),
                 place_on_sphere(m_operands[second], sum(arm, Interval(1), between)), first,
                 sum(arm, Interval(1), center), multiplicity);
    });
  }

  /*
  Calls a function for the roots on a line of the equation of a sphere, with the multiplicity and the vector from the
  center. Coordinates that are zero on the seam are exactly so.
  */
  template <class Form, class Function>
  static bool for_roots_on_sphere(const Form& form, const Operand& sphere, const Function& function)
  {
    Sphere_equation<Interval, d> f = sphere_equation(form(Interval()), sphere);
    int sign = sign_of(f.discriminant);
    if (sign == 0 || sign_of(f.a) == 0) {
      const auto exact = sphere_equation(form(Exact_rational()), sphere);
      if (exact.a == 0)
        return false;
      f = enclosure_of(exact);
      sign = sign_of(exact.discriminant);
    }
    if (sign < 0)
      return true;
    const auto add_root = [&](const Interval& t, int multiplicity) {
      Point arm = sum(f.w, t, f.v);
      settle_zeros(form, sphere, t, arm);
      return function(t, multiplicity, arm);
    };
    if (sign == 0)
      return add_root(-f.b / f.a, 2);
    const Interval root = CGAL::sqrt(f.discriminant), lower = (-f.b - root) / f.a, upper = (root - f.b) / f.a;
    return lower.sup() < upper.inf() && add_root(lower, 1) && add_root(upper, 1);
  }

  // Coordinate 0 of a sphere is zero on the seam, and with it coordinate 1 at the poles; on a circle coordinate 1 is.
  template <class Form>
  static void settle_zeros(const Form& form, const Operand& sphere, const Interval& t, Point& arm)
  {
    if constexpr (d == 2) {
      if (arm[0].sup() >= 0)
        settle_zero(form, sphere, t, arm[1], 1);
    } else if (arm[1].sup() >= 0) {
      settle_zero(form, sphere, t, arm[0], 0);
      if (arm[0].is_same(Interval(0)))
        settle_zero(form, sphere, t, arm[1], 1);
    }
  }

  // Where a coordinate may be zero at the only root in a range, it is if it is zero at a root of the equation there.
  template <class Form>
  static void settle_zero(const Form& form, const Operand& sphere, const Interval& t, Interval& x, std::size_t i)
  {
    if (sign_of(x) != 0 || x.is_same(Interval(0)))
      return;
    const auto f = sphere_equation(form(Exact_rational()), sphere);
    if (f.v[i] == 0) {
      x = enclosure_of(f.w[i]);
      return;
    }
    const Exact_rational zero(-f.w[i] / f.v[i]);
    if (t.inf() <= zero && zero <= t.sup() && (f.a * zero + 2 * f.b) * zero + f.c == 0)
      x = Interval(0);
  }

  // --- a curve and what has a form of degree one or two

  bool has_side(std::size_t k) const
  {
    if constexpr (d == 2)
      if (is_line(k))
        return sign_of(squared_length(affine_line<Interval>(m_operands[k]).direction)) > 0;
    if constexpr (d == 3) {
      if (is_plane(k))
        return true;
      if (is_turned(k))
        return is_turned_segment(m_operands[k]);
      if (is_triangle(k))
        return sign_of(squared_length(Triangle_frame<Interval>(m_operands[k]).normal())) > 0;
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

  template <class Number>
  std::vector<Number> composition(const Operand& curve, std::size_t other) const
  {
    if (m_operands[other].kind == Elementary_kind::SPHERE)
      return sphere_composition<Number>(curve, m_operands[other]);
    if constexpr (d == 3)
      if (is_turned(other)) {
        const Turned_segment<Number> surface(m_operands[other]);
        return quadratic_composition<Number>(curve.coefficients[0].size() - 1, [&](std::size_t i, std::size_t k) {
          return surface.polar(control_point_of<Number>(curve, i), control_point_of<Number>(curve, k));
        });
      }
    return linear_composition<Number>(curve, [&](const auto& point) { return side_of(other, point); });
  }

  Decided_place place_of(std::size_t k, const Point& point, [[maybe_unused]] const Operand& other) const
  {
    if constexpr (d == 2) {
      if (is_line(k))
        return place_on_line(m_operands[k].kind, parameter_on_line(m_operands[k], point));
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
    if (result.kind != Elementary_kind::BEZIER && result.coefficients[0].empty())
      for (std::size_t i = 0; i < d; ++i) {
        m_control_points[i] = {result.numbers[i], result.numbers[size == 1 ? i : d + i]};
        result.coefficients[i] = std::span<const double>(m_control_points[i].data(), size);
      }
    return result;
  }

  bool find_on_curve(std::size_t k, std::size_t other)
  {
    const Operand curve = curve_of_points(k, 2);
    const std::size_t degree = curve.coefficients[0].size() - 1;
    if (!has_side(other) || degree == 0 || degree > most_degree)
      return false;
    const auto add_root = [&](const Interval& t, int multiplicity) {
      const Point point = point_of_curve(curve, t);
      return add(place_on_line(Elementary_kind::SEGMENT, t), place_of(other, point, curve), k, point, multiplicity);
    };
    std::vector<Interval> f = composition<Interval>(curve, other);
    std::array<bool, 2> is_root_at_end{};
    for (const std::size_t side : {0, 1}) {
      Interval& value = side == 0 ? f.front() : f.back();
      if (sign_of(value) == 0) {
        const Exact_rational exact = side_of(other, control_point_of<Exact_rational>(curve, side * degree));
        is_root_at_end[side] = exact == 0;
        value = enclosure_of(exact);
      }
    }
    const bool is_closed = control_point_of<Interval>(curve, 0) == control_point_of<Interval>(curve, degree);
    if (is_closed && (is_root_at_end[0] || is_root_at_end[1]))
      return false;
    f = without_roots_at_ends(std::move(f), is_root_at_end);
    if (sign_of(f.front()) == 0 || sign_of(f.back()) == 0)
      return false;
    const auto roots = unit_roots(
        f, [&] { return without_roots_at_ends(composition<Exact_rational>(curve, other), is_root_at_end); });
    return roots && (!is_root_at_end[0] || add_root(Interval(0), 1)) &&
        (!is_root_at_end[1] || add_root(Interval(1), 1)) &&
        std::all_of(roots->begin(), roots->end(),
                    [&](const Unit_root& root) { return add_root(root.t, root.is_double ? 2 : 1); });
  }

  // --- answers

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
        const Interval parameter = on_domain(m_operands[i], own.parameters[axis]);
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

  // From the unit interval to the domain of a curve.
  static Interval on_domain(const Operand& operand, const Interval& t)
  {
    const auto [begin, end] = operand.domain[0];
    if ((begin == 0 && end == 1) || operand.coefficients[0].empty())
      return t;
    if (t.is_same(Interval(1)))
      return Interval(end);
    return common_part(Interval(begin) + (Interval(end) - Interval(begin)) * t, Interval(begin, end));
  }
};

template <int d>
std::optional<Elementary_points<d>> elementary_points(const Elementary_operand<d>& first,
                                                      const Elementary_operand<d>& second)
{
  using enum Elementary_kind;
  const auto is_curved = [](const Elementary_operand<d>& x) {
    return x.kind == PATCH || (x.kind == BEZIER && x.degrees[0] != 1);
  };
  if (first.kind == OTHER || second.kind == OTHER)
    return std::nullopt;
  const Upward_rounding_guard guard;
  if (is_curved(first) && is_curved(second)) {
    auto overlap = first.kind == BEZIER && second.kind == BEZIER ? Affine_overlap<d>(first, second)() : std::nullopt;
    if (!overlap)
      return std::nullopt;
    Elementary_points<d> result{1, 2};
    result.points.push_back(std::move(*overlap));
    return result;
  }
  return Elementary_finder<d>(first, second)();
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_FINDER_H
