// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_SPLINE_STREAMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_SPLINE_STREAMS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Writes an integer, or a quotient of two, as digits: p or p/q.
void write_rational(std::ostream& out, const Exact_rational& x);

// What `write_rational()` writes; else none, and the stream fails.
std::optional<Exact_rational> read_rational(std::istream& in);

template <class Object>
void write_spline(std::ostream& out, const Object& object)
{
  const auto& functions = object.representation().functions();
  const auto write = [&](const auto& numbers) {
    for (const auto& x : numbers) {
      out << ' ';
      write_rational(out, converted_number<Exact_rational>(x));
    }
  };
  out << Object::number_of_parameters << ' ' << Object::ambient_dimension << ' ' << (object.is_rational() ? 1 : 0);
  for (int axis = 0; axis < Object::number_of_parameters; ++axis) {
    out << "  " << functions[0].degree(axis) << ' ' << functions[0].size(axis);
    write(functions[0].knots(axis));
  }
  for (const auto& function : functions) {
    out << ' ';
    write(function.coefficients());
  }
}

template <class Number>
std::vector<Number> read_numbers(std::istream& in, std::size_t count)
{
  std::vector<Number> result;
  while (result.size() < count) {
    const std::optional<Exact_rational> x = read_rational(in);
    if (!x)
      break;
    result.push_back(converted_number<Number>(*x));
  }
  return result;
}

template <class Object>
void read_spline(std::istream& in, Object& object)
{
  using Number = typename Object::Number_type;
  constexpr int d = Object::ambient_dimension;
  int parameters = 0, dimension = 0, is_rational = 0;
  std::vector<int> degrees;
  std::vector<std::vector<Number>> knots;
  std::size_t size = 1;
  in >> parameters >> dimension >> is_rational;
  bool is_valid =
      in && parameters == Object::number_of_parameters && dimension == d && (is_rational == 0 || is_rational == 1);
  for (int axis = 0; is_valid && axis < parameters; ++axis) {
    constexpr int most = 1 << 20;   // so that sums and products of sizes do not overflow
    int degree = -1, count = 0;
    in >> degree >> count;
    is_valid = in && 0 <= degree && degree < count && count < most;
    if (is_valid) {
      degrees.push_back(degree);
      knots.push_back(read_numbers<Number>(in, static_cast<std::size_t>(degree) + static_cast<std::size_t>(count) + 1));
      size *= static_cast<std::size_t>(count);
    }
  }
  std::vector<std::vector<Number>> coefficients;
  for (int i = 0; is_valid && in && i < d + is_rational; ++i)
    coefficients.push_back(read_numbers<Number>(in, size));
  if (!is_valid || !in) {
    in.setstate(std::ios::failbit);
    return;
  }
  try {
    std::vector<Bspline_function<Number>> functions;
    for (std::vector<Number>& numbers : coefficients)
      functions.emplace_back(degrees, knots, std::move(numbers));
    object = Object(Homogeneous_spline<Number, d>(std::move(functions), "a curve or surface"));
  } catch (const Invalid_input&) {
    in.setstate(std::ios::failbit);
  }
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void write_rational(std::ostream& out, const Exact_rational& x)
{
  const Big_integer denominator = denominator_of(x);
  out << numerator_of(x).str();
  if (denominator != 1)
    out << '/' << denominator.str();
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_rational> read_rational(std::istream& in)
{
  std::string text;
  in >> text;
  const std::size_t slash = text.find('/'), begin = text.starts_with('-') ? 1 : 0;
  const std::string numerator = text.substr(begin, slash == std::string::npos ? slash : slash - begin),
                    denominator = slash == std::string::npos ? "1" : text.substr(slash + 1);
  const auto is_number = [](const std::string& digits) {
    return !digits.empty() && std::all_of(digits.begin(), digits.end(), [](char c) { return '0' <= c && c <= '9'; });
  };
  const auto is_zero = [](const std::string& digits) { return digits.find_first_not_of('0') == std::string::npos; };
  if (!in || !is_number(numerator) || !is_number(denominator) || is_zero(denominator)) {
    in.setstate(std::ios::failbit);
    return std::nullopt;
  }
  const auto integer = [&](const std::string& digits) { // a leading zero would be an octal number
    return is_zero(digits) ? Exact_rational(0)
                           : scaled_rational(Big_integer(digits.substr(digits.find_first_not_of('0'))), 0);
  };
  const Exact_rational result(integer(numerator) / integer(denominator));
  return begin == 1 ? Exact_rational(-result) : result;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

writes a curve as numbers with spaces between them: 1 for its parameter, the dimension, 1 if it is rational and else 0;
the degree, the number of control points, the knots; and the control points, one coordinate of all of them after the
other, at last the weights. Coordinates of rational curves are multiplied by the weights. Numbers are integers or
quotients \f$p/q\f$ in any kernel, so they are exact.
*/
template <SplineKernel Kernel, int d>
std::ostream& operator<<(std::ostream& out, const Bspline_curve<Kernel, d>& curve)
{
  internal::write_spline(out, curve);
  return out;
}

/*!
\ingroup PkgSplineConstraintsDGeometry

reads a curve that was written in this way: it has the same knots and control points. Kernels of doubles round what a
kernel of other numbers has written. If there is no valid curve, the stream fails and the curve remains as it was.
*/
template <SplineKernel Kernel, int d>
std::istream& operator>>(std::istream& in, Bspline_curve<Kernel, d>& curve)
{
  internal::read_spline(in, curve);
  return in;
}

//! \ingroup PkgSplineConstraintsDGeometry
//! writes a surface: 2 for its parameters, the dimension, whether it is rational; degree, number of control points and
//! knots of both axes; coordinates and weights as those of a curve, the second axis fastest.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Bspline_surface_3<Kernel>& surface)
{
  internal::write_spline(out, surface);
  return out;
}

//! \ingroup PkgSplineConstraintsDGeometry
//! reads a surface, as a curve is read.
template <SplineKernel Kernel>
std::istream& operator>>(std::istream& in, Bspline_surface_3<Kernel>& surface)
{
  internal::read_spline(in, surface);
  return in;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_SPLINE_STREAMS_H
