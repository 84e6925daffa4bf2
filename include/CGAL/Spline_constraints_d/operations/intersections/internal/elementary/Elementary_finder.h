// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_FINDER_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Affine_overlap.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_pair.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/unit_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

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
  : private Elementary_pair<d>
{
  using Pair = Elementary_pair<d>;
  using typename Pair::Operand;
  using typename Pair::Point;
  using Pair::add;
  using Pair::curve_of_points;
  using Pair::has_finite_numbers;
  using Pair::has_side;
  using Pair::is_closed;
  using Pair::is_line;
  using Pair::is_sphere;
  using Pair::is_triangle;
  using Pair::is_turned;
  using Pair::m_operands;
  using Pair::m_points;
  using Pair::number_of_parameters;
  using Pair::on_range;
  using Pair::place_of;
  using Pair::place_on;
  using Pair::side_of;

  static constexpr std::size_t most_degree = 25;   // the binomial coefficients of twice it are doubles

public:
  Elementary_finder(const Operand& first, const Operand& second) : Pair(first, second) {}

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
    m_points.sort(is_before<d>);
    return Elementary_points<d>{split, size, 0, std::move(m_points)};
  }

private:
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
    return (kind == Elementary_kind::CURVE || kind == Elementary_kind::SEGMENT) && find_on_curve(curve, other);
  }

  // --- a point

  bool find_point(std::size_t point, std::size_t other)
  {
    const auto side = [&]<class Number>(const Number&) {
      return this->side_of(other, coordinates_of<Number>(this->m_operands[point]));
    };
    if (!has_side(other))
      return false;
    const Interval bounds = side(Interval());
    const int sign = is_certain(bounds) ? known_sign(bounds) : known_sign(side(Exact_rational()));
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
    if (known_sign(area) == 0)
      return std::nullopt;
    const auto between = difference(b.origin, a.origin);
    return Meeting{enclosure_of(Number(determinant(between, b.direction) / area)),
                   enclosure_of(Number(determinant(between, a.direction) / area))};
  }

  bool find_on_lines(std::size_t first, std::size_t second) requires(d == 2)
  {
    const auto add_meeting = [&](const Meeting& x) {
      const auto a = affine_line<Interval>(m_operands[first]);
      return add(place_on(first, x.t), place_on(second, x.s), first,
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
    const Interval volume = volume_between_lines<Interval>(a, b);
    if (known_sign(volume) != 0 || (!is_certain(volume) && volume_between_lines<Exact_rational>(a, b) != 0))
      return true;
    const auto meeting = meeting_in_plane(a, b);
    if (!meeting)
      return are_apart_and_parallel(a, b);
    const auto points = affine_line<Interval>(a);
    return add(place_on(first, (*meeting)[0]), place_on(second, (*meeting)[1]), first,
               sum(points.origin, (*meeting)[0], points.direction), 1);
  }

  bool find_on_line_and_triangle(std::size_t line, std::size_t triangle) requires(d == 3)
  {
    const auto add_meeting = [&](const Meeting_with_triangle& x) {
      const auto points = affine_line<Interval>(m_operands[line]);
      return add(place_on(line, x.t), place_on_triangle(x.sides), line,
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
      return equation_on_line(Turned_segment<Number>(this->m_operands[surface]),
                              affine_line<Number>(this->m_operands[line]));
    };
    auto [a, b, c] = equation(Interval());
    Interval discriminant = CGAL::square(b) - a * c;
    int sign = known_sign(discriminant);
    if (!is_certain(discriminant)) {
      const auto exact = equation(Exact_rational());
      const Exact_rational value(exact[1] * exact[1] - exact[0] * exact[2]);
      a = enclosure_of(exact[0]);
      b = enclosure_of(exact[1]);
      discriminant = enclosure_of(value);
      sign = known_sign(value);
    }
    if (known_sign(a) == 0)
      return false;
    const auto points = affine_line<Interval>(m_operands[line]);
    const Turned_segment<Interval> form(m_operands[surface]);
    const auto add_root = [&](const Interval& t, int multiplicity) {
      const Point point = sum(points.origin, t, points.direction);
      return add(place_on(line, t), place_on_turned_segment(form, point), line, point,
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
      Decided_place place = place_on(line, t);
      for (const double end : {0.0, 1.0})
        if (place.state == Decided_place::State::UNDECIDED && t.inf() <= end && end <= t.sup() &&
            side_of_sphere(m_operands[sphere], coordinates_of<Exact_rational>(operand, end == 0 ? 0 : d)) == 0)
          place = place_on(line, Interval(end));
      return add(place, place_on_sphere(m_operands[sphere], arm), line,
                 sum(points.origin, t, points.direction), multiplicity);
    });
  }

  bool find_on_circles(std::size_t first, std::size_t second) requires(d == 2)
  {
    const Point center = coordinates_of<Interval>(m_operands[first]),
                between = difference(center, coordinates_of<Interval>(m_operands[second]));
    if (known_sign(squared_length(between)) == 0)
      return false;
    const auto form = [&]<class Number>(const Number&) {
      return radical_line<Number>(this->m_operands[first], this->m_operands[second]);
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
    int sign = known_sign(f.discriminant);
    if (!is_certain(f.discriminant) || known_sign(f.a) == 0) {
      const auto exact = sphere_equation(form(Exact_rational()), sphere);
      if (exact.a == 0)
        return false;
      f = enclosure_of(exact);
      sign = known_sign(exact.discriminant);
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
    if (known_sign(x) != 0 || x.is_same(Interval(0)))
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

  template <class Number>
  Scratch_vector<Number> composition(const Control_polygon<Number, d>& curve, std::size_t other) const
  {
    if (m_operands[other].kind == Elementary_kind::SPHERE)
      return sphere_composition(curve, m_operands[other]);
    if constexpr (d == 3)
      if (is_turned(other)) {
        const Turned_segment<Number> surface(m_operands[other]);
        return quadratic_composition<Number>(
            curve.size() - 1, [&](std::size_t i, std::size_t k) { return surface.polar(curve[i], curve[k]); });
      }
    return linear_composition(curve, [&](const Coordinates<Number, d>& point) { return this->side_of(other, point); });
  }

  bool find_on_curve(std::size_t k, std::size_t other)
  {
    const Operand curve = curve_of_points(k, 2);
    const std::size_t degree = static_cast<std::size_t>(curve.degrees[0]);
    if (!has_side(other) || degree == 0 || degree > most_degree)
      return false;
    if (curve.is_one_piece())
      return find_on_piece(k, other, curve, degree, curve.domain[0]);
    for (std::size_t i = degree; i < curve.coefficients[0].size(); ++i)
      if (curve.knots[i] < curve.knots[i + 1])
        if (!find_on_piece(k, other, curve, i, {curve.knots[i], curve.knots[i + 1]}))
          return false;
    return true;
  }

  // A piece of a curve, which begins at the knot with this index. What may be a common point at an inner break is left.
  bool find_on_piece(std::size_t k, std::size_t other, const Operand& curve, std::size_t first_knot,
                     const std::array<double, 2>& range)
  {
    const auto piece = piece_of<Interval>(curve, first_knot);
    Scratch_vector<Interval> f = composition(piece, other);
    std::array<bool, 2> is_root_at_end{};
    for (const std::size_t side : {0, 1}) {
      Interval& value = side == 0 ? f.front() : f.back();
      if (!is_certain(value)) {
        const auto exact_piece = piece_of<Exact_rational>(curve, first_knot);
        value = enclosure_of(side_of(other, side == 0 ? exact_piece.front() : exact_piece.back()));
      }
      is_root_at_end[side] = known_sign(value) == 0;
      if (is_root_at_end[side] && (range[side] != curve.domain[0][side] || is_closed(curve)))
        return false;
    }
    f = without_roots_at_ends(std::move(f), is_root_at_end);
    if (f.empty() || known_sign(f.front()) == 0 || known_sign(f.back()) == 0)
      return false;
    const auto add_root = [&](const Interval& t, int multiplicity) {
      const Point point = point_of_curve(piece, t);
      Decided_place place{Decided_place::State::FOUND, {{on_range(range, t), Interval(0)}}};
      place.place.is_at_end[0] = t.is_same(Interval(0)) || t.is_same(Interval(1));
      return add(place, place_of(other, point, curve), k, point, multiplicity);
    };
    const auto roots = unit_roots(f, [&] {
      return without_roots_at_ends(composition(piece_of<Exact_rational>(curve, first_knot), other), is_root_at_end);
    });
    return roots && (!is_root_at_end[0] || add_root(Interval(0), 1)) &&
        (!is_root_at_end[1] || add_root(Interval(1), 1)) &&
        std::all_of(roots->begin(), roots->end(),
                    [&](const Unit_root& root) { return add_root(root.t, root.is_double ? 2 : 1); });
  }

};

template <int d>
std::optional<Elementary_points<d>> elementary_points(const Elementary_operand<d>& first,
                                                      const Elementary_operand<d>& second)
{
  using enum Elementary_kind;
  const auto is_curved = [](const Elementary_operand<d>& x) {
    return x.kind == PATCH || (x.kind == CURVE && !(x.degrees[0] == 1 && x.is_one_piece()));
  };
  if (first.kind == OTHER || second.kind == OTHER)
    return std::nullopt;
  const Upward_rounding_guard guard;
  if (is_curved(first) && is_curved(second)) {
    auto overlap = first.kind == CURVE && second.kind == CURVE ? Affine_overlap<d>(first, second)() : std::nullopt;
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
