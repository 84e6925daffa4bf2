// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_INTERNAL_CONIC_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_INTERNAL_CONIC_PARTS_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/internal/univariate_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/curves/conic_curve.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// r x^2 + s y^2 + t x y + u x + v y + w = 0, in the letters of CGAL.
struct Conic_equation
{
  Exact_rational r, s, t, u, v, w;

  // That of a conic through a point, which is moved to the origin for it.
  static Conic_equation of(const Conic_through_origin& conic, const Exact_kernel::Point_2& origin)
  {
    Conic_equation result{conic.xx, conic.yy, conic.xy, conic.x, conic.y, Exact_rational(0)};
    const Exact_kernel::Point_2 opposite = CGAL::ORIGIN - (origin - CGAL::ORIGIN);
    const Conic_through_origin moved = result.around(opposite);
    result.w = result(opposite);
    result.u = moved.x;
    result.v = moved.y;
    return result;
  }

  Exact_rational operator()(const Exact_kernel::Point_2& p) const
  {
    return Exact_rational((r * p.x() + t * p.y() + u) * p.x() + (s * p.y() + v) * p.y() + w);
  }

  // With a point of the conic as the origin.
  Conic_through_origin around(const Exact_kernel::Point_2& p) const
  {
    return {r, t, s, Exact_rational(2 * r * p.x() + t * p.y() + u), Exact_rational(2 * s * p.y() + t * p.x() + v)};
  }

  Conic_equation opposite() const
  {
    return {Exact_rational(-r), Exact_rational(-s), Exact_rational(-t),
            Exact_rational(-u), Exact_rational(-v), Exact_rational(-w)};
  }
};

// An arc of a conic that is no pair of lines, or a segment, which is collinear; the ends of a whole ellipse are the
// same point.
struct Conic_part
{
  Exact_kernel::Point_2 source, target;
  CGAL::Orientation orientation;
  Conic_equation conic;   // of an arc

  bool is_whole() const { return source == target; }

  // Whether a point of the conic is in the interior of the arc. An arc of an ellipse lies on one side of its chord.
  bool has_inside(const Exact_kernel::Point_2& p) const { return CGAL::orientation(source, p, target) == orientation; }
};

// A piece of degree one or two that is on a line runs back on it exactly if it does so at an end: the derivative is a
// quadratic polynomial over a positive one, and its middle Bernstein coefficient has the direction of the chord.
template <class Piece>
bool is_segment(const Piece& piece)
{
  const Exact_kernel::Vector_2 chord = piece.target() - piece.source();
  const auto [begin, end] = piece.domain();
  return chord != CGAL::NULL_VECTOR && piece.derivatives(begin, 1)[1] * chord >= 0 &&
      piece.derivatives(end, 1)[1] * chord >= 0;
}

// A piece as one of degree two on [0,1], if it is one: in the powers of its parameter, without the common factor of its
// homogeneous coordinates.
template <class Piece>
std::optional<Piece> as_quadratic(const Piece& piece)
{
  std::vector<Power_polynomial> coordinates;
  for (const auto& f : piece.homogeneous_coordinates())
    coordinates.push_back(univariate_polynomial(f));
  coordinates.push_back(univariate_polynomial(piece.weight()));
  if (const std::optional<Common_factor> common = common_factor(coordinates))
    coordinates = common->cofactors;
  std::vector<Bspline_function<Exact_rational>> quadratics;
  for (const Power_polynomial& f : coordinates) {
    std::vector<Exact_rational> powers(3, Exact_rational(0));
    for (const auto& [monomial, coefficient] : f.terms()) {
      if (monomial.exponent(0) > 2)
        return std::nullopt;
      powers[monomial.exponent(0)] = coefficient;
    }
    quadratics.push_back(Bspline_function<Exact_rational>(
        {2}, {{0, 0, 0, 1, 1, 1}}, Bernstein_tensor<Exact_rational>::from_power({2}, powers).coefficients()));
  }
  return Piece::from_homogeneous_coordinates({quadratics[0], quadratics[1]}, quadratics[2]);
}

// What a polynomial or rational piece is, if it is of degree one or two, elevated or not. As a projective image of a
// parabola it runs along its conic once.
template <class Piece>
std::optional<std::pair<Conic_part, std::array<Exact_kernel::Point_2, 5>>> conic_part_of(const Piece& piece)
{
  if (piece.degree() > 2) {
    const std::optional<Piece> quadratic = as_quadratic(piece);
    return quadratic ? conic_part_of(*quadratic) : std::nullopt;
  }
  std::array<Exact_kernel::Point_2, 5> points;
  const auto [begin, end] = piece.domain();
  for (int i = 0; i < 5; ++i)
    points[i] = piece(Exact_rational(begin + (end - begin) * i / 4));
  Conic_part part{points[0], points[4], CGAL::orientation(points[0], points[2], points[4]), {}};
  if (part.orientation != CGAL::COLLINEAR) {
    std::array<Exact_kernel::Vector_2, 4> others;
    std::transform(points.begin() + 1, points.end(), others.begin(), [&](const auto& p) { return p - points[0]; });
    part.conic = Conic_equation::of(conic_through(others), points[0]);
  } else if (!is_segment(piece))
    return std::nullopt;
  return std::pair(part, points);
}

// The arcs and segments that a curve consists of, if its pieces are of degree one or two, elevated or not, and no
// point. Pieces that follow each other on one conic, in the same sense and less than once around, are one arc.
template <class Curve>
std::optional<std::vector<Conic_part>> conic_parts(const Curve& curve)
{
  std::vector<Conic_part> result;
  for (const auto& piece : curve.bezier_pieces()) {
    const auto next = conic_part_of(piece);
    if (!next)
      return std::nullopt;
    const auto& [part, points] = *next;
    const bool goes_on = !result.empty() && part.orientation != CGAL::COLLINEAR &&
        result.back().orientation == part.orientation && !result.back().is_whole() &&
        !part.has_inside(result.back().source) &&
        std::all_of(points.begin(), points.end(), [&](const auto& p) { return result.back().conic(p) == 0; });
    if (goes_on)
      result.back().target = part.target;
    else
      result.push_back(part);
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_INTERNAL_CONIC_PARTS_H
