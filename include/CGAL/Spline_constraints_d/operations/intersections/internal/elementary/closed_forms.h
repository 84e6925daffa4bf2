// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_CLOSED_FORMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_CLOSED_FORMS_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_operand.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/unit_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
Formulas of common points that are written once for two types of numbers: intervals of doubles, under upward rounding,
and rational numbers, for signs that intervals do not tell.
*/
template <class Number>
concept Formula_number = std::same_as<Number, Interval> || std::same_as<Number, Exact_rational>;

template <Formula_number Number>
Number number_of(double x)
{
  if constexpr (std::same_as<Number, Interval>)
    return Interval(x);
  else
    return to_rational(x);
}

template <Formula_number Number, std::size_t d>
using Coordinates = std::array<Number, d>;

template <Formula_number Number, std::size_t d>
Coordinates<Number, d> sum(const Coordinates<Number, d>& a, const Number& t, const Coordinates<Number, d>& v)
{
  Coordinates<Number, d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = a[i] + t * v[i];
  return result;
}

template <Formula_number Number, std::size_t d>
Coordinates<Number, d> difference(const Coordinates<Number, d>& a, const Coordinates<Number, d>& b)
{
  Coordinates<Number, d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = a[i] - b[i];
  return result;
}

template <Formula_number Number, std::size_t d>
Number inner_product(const Coordinates<Number, d>& a, const Coordinates<Number, d>& b)
{
  Number result = a[0] * b[0];
  for (std::size_t i = 1; i < d; ++i)
    result += a[i] * b[i];
  return result;
}

template <Formula_number Number, std::size_t d>
Number squared_length(const Coordinates<Number, d>& a)
{
  Number result = CGAL::square(a[0]);
  for (std::size_t i = 1; i < d; ++i)
    result += CGAL::square(a[i]);
  return result;
}

template <Formula_number Number>
Number determinant(const Coordinates<Number, 2>& a, const Coordinates<Number, 2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// The square of the area between two vectors.
template <Formula_number Number>
Number squared_area(const Coordinates<Number, 2>& a, const Coordinates<Number, 2>& b)
{
  return CGAL::square(determinant(a, b));
}

template <Formula_number Number>
Number squared_area(const Coordinates<Number, 3>& a, const Coordinates<Number, 3>& b)
{
  const auto square = [&](std::size_t i, std::size_t k) -> Number { return CGAL::square(a[i] * b[k] - a[k] * b[i]); };
  return square(0, 1) + square(1, 2) + square(2, 0);
}

// Some of the numbers of an operand as coordinates.
template <Formula_number Number, int d>
Coordinates<Number, d> coordinates_of(const Elementary_operand<d>& operand, std::size_t begin = 0)
{
  Coordinates<Number, d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = number_of<Number>(operand.numbers[begin + i]);
  return result;
}

// The control points of a Bezier piece.
template <Formula_number Number, std::size_t d>
using Control_polygon = Scratch_vector<Coordinates<Number, d>>;

/*
Of the piece of a curve between the knot with an index and the next one: the values of the polar form of the piece, by
de Boor's scheme, where the second knot takes the place of none, one and more of the arguments, and the first one that
of the others.
*/
template <Formula_number Number, int d>
Control_polygon<Number, d> piece_of(const Elementary_operand<d>& curve, std::size_t first_knot)
{
  const std::size_t degree = static_cast<std::size_t>(curve.degrees[0]), first = first_knot - degree;
  const auto knot = [&](std::size_t i) { return number_of<Number>(curve.knots[i]); };
  Control_polygon<Number, d> own(degree + 1);
  for (std::size_t j = 0; j <= degree; ++j)
    for (std::size_t i = 0; i < d; ++i)
      own[j][i] = number_of<Number>(curve.coefficients[i][first + j]);
  if (curve.is_one_piece())
    return own;
  Control_polygon<Number, d> result;
  for (std::size_t count = 0; count <= degree; ++count) {
    Control_polygon<Number, d> row = own;
    for (std::size_t r = 1; r <= degree; ++r)
      for (std::size_t j = 0; j + r <= degree; ++j) {
        const Number low = knot(first + j + r), high = knot(first_knot + j + 1),
                     t = (knot(r <= degree - count ? first_knot : first_knot + 1) - low) / (high - low);
        row[j] = sum(row[j], t, difference(row[j + 1], row[j]));
      }
    result.push_back(row[0]);
  }
  return result;
}

// The points origin + t direction.
template <Formula_number Number, std::size_t d>
struct Affine_line
{
  Coordinates<Number, d> origin, direction;
};

// The line a x + b y + c = 0 from its point next to the origin on.
template <Formula_number Number>
Affine_line<Number, 2> affine_line(const Number& a, const Number& b, const Number& c)
{
  const Number factor = -c / Number(CGAL::square(a) + CGAL::square(b));
  return {{a * factor, b * factor}, {b, -a}};
}

template <Formula_number Number, int d>
Affine_line<Number, d> affine_line(const Elementary_operand<d>& line)
{
  if constexpr (d == 2)
    if (line.kind == Elementary_kind::EQUATION_LINE)
      return affine_line(number_of<Number>(line.numbers[0]), number_of<Number>(line.numbers[1]),
                         number_of<Number>(line.numbers[2]));
  const Coordinates<Number, d> first = coordinates_of<Number>(line), second = coordinates_of<Number>(line, d);
  return {first, line.kind == Elementary_kind::VECTOR_LINE ? second : difference(second, first)};
}

// The line through the common points of two circles, if there are any: where |x - p|^2 - r^2 = |x - q|^2 - s^2.
template <Formula_number Number>
Affine_line<Number, 2> radical_line(const Elementary_operand<2>& first, const Elementary_operand<2>& second)
{
  const Coordinates<Number, 2> p = coordinates_of<Number>(first), w = difference(coordinates_of<Number>(second), p);
  const Number square = squared_length(w),
               height = (square + number_of<Number>(first.numbers[2]) - number_of<Number>(second.numbers[2])) /
      (number_of<Number>(2) * square);
  return {sum(p, height, w), {-w[1], w[0]}};
}

/*
|w + t v|^2 - r^2 = a t^2 + 2 b t + c with the vector w from the center of a circle or sphere to the origin of a line.
The discriminant is a r^2 - |w x v|^2, where nothing of the order of w cancels (Lagrange's identity).
*/
template <Formula_number Number, std::size_t d>
struct Sphere_equation
{
  Coordinates<Number, d> w, v;
  Number a, b, c, discriminant;
};

template <Formula_number Number, std::size_t n, int d>
Sphere_equation<Number, n> sphere_equation(const Affine_line<Number, n>& line, const Elementary_operand<d>& sphere)
{
  const Coordinates<Number, n> w = difference(line.origin, coordinates_of<Number>(sphere)), &v = line.direction;
  const Number squared_radius = number_of<Number>(sphere.numbers[d]), a = squared_length(v);
  return {w, v, a, inner_product(w, v), squared_length(w) - squared_radius, a * squared_radius - squared_area(w, v)};
}

template <std::size_t d>
Coordinates<Interval, d> enclosure_of(const Coordinates<Exact_rational, d>& x)
{
  Coordinates<Interval, d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = enclosure_of(x[i]);
  return result;
}

template <std::size_t d>
Sphere_equation<Interval, d> enclosure_of(const Sphere_equation<Exact_rational, d>& f)
{
  return {enclosure_of(f.w), enclosure_of(f.v), enclosure_of(f.a),
          enclosure_of(f.b), enclosure_of(f.c), enclosure_of(f.discriminant)};
}

// The value at a point of what is zero on a line of the plane, by its equation or by two points.
template <Formula_number Number>
Number side_of_line(const Elementary_operand<2>& line, const Coordinates<Number, 2>& point)
{
  const auto number = [&](std::size_t i) { return number_of<Number>(line.numbers[i]); };
  if (line.kind == Elementary_kind::EQUATION_LINE)
    return number(0) * point[0] + number(1) * point[1] + number(2);
  const Affine_line<Number, 2> by_points = affine_line<Number>(line);
  return determinant(by_points.direction, difference(point, by_points.origin));
}

template <Formula_number Number>
Number side_of_plane(const Elementary_operand<3>& plane, const Coordinates<Number, 3>& point)
{
  return inner_product(coordinates_of<Number>(plane), point) + number_of<Number>(plane.numbers[3]);
}

template <Formula_number Number, std::size_t n, int d>
Number side_of_sphere(const Elementary_operand<d>& sphere, const Coordinates<Number, n>& point)
{
  return squared_length(difference(point, coordinates_of<Number>(sphere))) - number_of<Number>(sphere.numbers[d]);
}

/*
The composition of a curve with what is zero on the other operand, in Bernstein form: of a linear form the values at the
control points, of a square those of its polar form, products summed up.
*/
template <Formula_number Number, std::size_t d, class Side>
Scratch_vector<Number> linear_composition(const Control_polygon<Number, d>& curve, const Side& side)
{
  Scratch_vector<Number> result;
  for (const Coordinates<Number, d>& point : curve)
    result.push_back(side(point));
  return result;
}

inline double binomial_number(std::size_t n, std::size_t k)
{
  double result = 1;   // exact as long as it is an integer of 53 bits
  for (std::size_t i = 1; i <= k; ++i)
    result = result * static_cast<double>(n - k + i) / static_cast<double>(i);
  return result;
}

template <Formula_number Number, class Polar>
Scratch_vector<Number> quadratic_composition(std::size_t degree, const Polar& polar)
{
  Scratch_vector<Number> result(2 * degree + 1, number_of<Number>(0));
  for (std::size_t i = 0; i <= degree; ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      const double weight = binomial_number(degree, i) * binomial_number(degree, k) * (i == k ? 1 : 2);
      result[i + k] += number_of<Number>(weight) * polar(i, k);
    }
  for (std::size_t k = 0; k <= 2 * degree; ++k)
    result[k] /= number_of<Number>(binomial_number(2 * degree, k));
  return result;
}

template <Formula_number Number, std::size_t n, int d>
Scratch_vector<Number> sphere_composition(const Control_polygon<Number, n>& curve, const Elementary_operand<d>& sphere)
{
  const Coordinates<Number, n> center = coordinates_of<Number>(sphere);
  const Number squared_radius = number_of<Number>(sphere.numbers[d]);
  Control_polygon<Number, n> arms;
  for (const Coordinates<Number, n>& point : curve)
    arms.push_back(difference(point, center));
  return quadratic_composition<Number>(curve.size() - 1, [&](std::size_t i, std::size_t k) -> Number {
    return (i == k ? squared_length(arms[i]) : inner_product(arms[i], arms[k])) - squared_radius;
  });
}

// The value of a Bernstein polynomial, rounded, by its form of Horner's scheme.
inline double rounded_value(std::span<const double> coefficients, double t)
{
  const std::size_t degree = coefficients.size() - 1;
  const double rest = 1 - t;
  double power = 1, binomial = 1, result = coefficients[0] * rest;
  for (std::size_t i = 1; i < degree; ++i) {
    power *= t;
    binomial *= static_cast<double>(degree - i + 1) / static_cast<double>(i);
    result = (result + power * binomial * coefficients[i]) * rest;
  }
  return result + power * t * coefficients[degree];
}

// A point of a Bezier piece, by de Casteljau's scheme.
template <std::size_t d>
Coordinates<Interval, d> point_of_curve(Control_polygon<Interval, d> curve, const Interval& t)
{
  const Interval rest = Interval(1) - t;
  for (std::size_t size = curve.size(); size-- > 1;)
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t i = 0; i < d; ++i)
        curve[j][i] = rest * curve[j][i] + t * curve[j + 1][i];
  return curve[0];
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_CLOSED_FORMS_H
