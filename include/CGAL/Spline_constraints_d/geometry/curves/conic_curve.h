// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CONIC_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CONIC_CURVE_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A conic through the origin: xx x^2 + xy x y + yy y^2 + x x + y y = 0. With the bilinear form B of the quadratic part and
its linear part l, a point in direction d lies at the parameter -l(d) / B(d,d): lines through the origin meet it in one
more point (stereographic projection).
*/
struct Conic_through_origin
{
  using Vector = Exact_kernel::Vector_2;
  Exact_rational xx, xy, yy, x, y;

  // Twice the bilinear form.
  Exact_rational form(const Vector& a, const Vector& b) const
  {
    return Exact_rational(2 * xx * a.x() * b.x() + xy * (a.x() * b.y() + a.y() * b.x()) + 2 * yy * a.y() * b.y());
  }

  Exact_rational linear(const Vector& a) const { return Exact_rational(x * a.x() + y * a.y()); }

  // The direction of the tangent at the origin, and one that is conjugate to it.
  Vector tangent() const { return {Exact_rational(-y), x}; }

  Vector conjugate() const
  {
    const Vector a = tangent();
    return {Exact_rational(-(xy * a.x() + 2 * yy * a.y())), Exact_rational(2 * xx * a.x() + xy * a.y())};
  }

  // The coordinates (sigma, tau) of a vector in these directions, up to a factor.
  std::pair<Exact_rational, Exact_rational> direction_of(const Vector& p) const
  {
    const Vector a = tangent(), b = conjugate();
    return {Exact_rational(p.x() * b.y() - p.y() * b.x()), Exact_rational(a.x() * p.y() - a.y() * p.x())};
  }

  bool is_ellipse() const { return Exact_rational(form(tangent(), tangent()) * form(conjugate(), conjugate())) > 0; }

  // The height of the rectangle along which the directions to an ellipse run.
  Exact_rational height_of_path() const
  {
    return near_inverse_root(Exact_rational(form(conjugate(), conjugate()) / form(tangent(), tangent())));
  }

  // Zero exactly for pairs of lines: the determinant of the symmetric matrix, four times.
  Exact_rational determinant() const { return Exact_rational(xy * x * y - xx * y * y - yy * x * x); }
};

// The null space of four equations in five unknowns, if it is a line: Gauss-Jordan elimination in exact numbers.
std::array<Exact_rational, 5> null_vector(std::array<std::array<Exact_rational, 5>, 4> rows);

Conic_through_origin conic_through(const std::array<Exact_kernel::Vector_2, 4>& points);

// The points -2 tau l(b) (sigma a + tau b) / (A sigma^2 + B tau^2), where a is the tangent at the origin, b conjugate
// to it, and A, B their quadratic forms.
Bspline_curve_2<Exact_kernel> conic_arc(const Conic_through_origin& conic, const Exact_kernel::Point_2& origin,
                                        std::span<const Exact_kernel::Vector_2> others);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Exact_rational, 5>
null_vector(std::array<std::array<Exact_rational, 5>, 4> rows)
{
  std::array<std::size_t, 4> pivots{};
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 5 && rank < 4; ++column) {
    const auto pivot = std::find_if(rows.begin() + rank, rows.end(), [&](const auto& row) { return row[column] != 0; });
    if (pivot == rows.end())
      continue;
    std::swap(*pivot, rows[rank]);
    const Exact_rational head = rows[rank][column];
    for (Exact_rational& entry : rows[rank])
      entry /= head;
    for (std::size_t r = 0; r < 4; ++r)
      if (r != rank) {
        const Exact_rational factor = rows[r][column];
        for (std::size_t c = 0; c < 5; ++c)
          rows[r][c] -= factor * rows[rank][c];
      }
    pivots[rank++] = column;
  }
  if (rank < 4)
    throw Invalid_input(
        "conic_curve: more than one conic runs through the points (two are the same, or four are on a line)");
  std::size_t free_column = 0;
  while (free_column < 4 && pivots[free_column] == free_column)
    ++free_column;
  std::array<Exact_rational, 5> result;
  result[free_column] = Exact_rational(1);
  for (std::size_t r = 0; r < 4; ++r)
    result[pivots[r]] = -rows[r][free_column];
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Conic_through_origin conic_through(const std::array<Exact_kernel::Vector_2, 4>& points)
{
  std::array<std::array<Exact_rational, 5>, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) {
    const Exact_rational px = points[i].x(), py = points[i].y();
    rows[i] = {Exact_rational(px * px), Exact_rational(px * py), Exact_rational(py * py), px, py};
  }
  const std::array<Exact_rational, 5> a = null_vector(rows);
  const Conic_through_origin conic{a[0], a[1], a[2], a[3], a[4]};
  if (conic.determinant() == 0)
    throw Invalid_input("conic_curve: the conic through the points is a pair of lines (three of them are on a line)");
  return conic;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Bspline_curve_2<Exact_kernel> conic_arc(const Conic_through_origin& conic,
                                                                       const Exact_kernel::Point_2& origin,
                                                                       std::span<const Exact_kernel::Vector_2> others)
{
  using Vector = Exact_kernel::Vector_2;
  const Vector tangent = conic.tangent(), conjugate = conic.conjugate();
  const Exact_rational A = conic.form(tangent, tangent), B = conic.form(conjugate, conjugate);

  const auto curve_on = [&](const Direction_path& path) {
    const Vector_function<2> a(path.domain(), tangent), b(path.domain(), conjugate);
    const Vector_function<2> numerators = (a * path.sigma_tau + b * path.squared_tau) *
        Scalar_function(path.domain(), Exact_rational(-2 * conic.linear(conjugate)));
    return object_around<Bspline_curve_2<Exact_kernel>>(origin, numerators,
                                                        path.squared_sigma * A + path.squared_tau * B);
  };
  if (conic.is_ellipse())
    return curve_on(Direction_path::half_round(conic.height_of_path()));
  // An open branch is seen from the origin in directions around the tangent: tau / sigma orders its points.
  Exact_rational first(0), last(0);
  for (const Vector& p : others) {
    const auto [sigma, tau] = conic.direction_of(p);
    if (Exact_rational((A * sigma * sigma + B * tau * tau) * A) <= 0)
      throw Invalid_input("conic_curve: the points are on both branches of a hyperbola");
    const Exact_rational slope = tau / sigma;
    first = (std::min)(first, slope);
    last = (std::max)(last, slope);
  }
  return curve_on(Direction_path::line(first, last));
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDConstructions

the conic through five points, as a rational quadratic curve. If it is an ellipse, the whole of it, closed, over
\f$[0,4]\f$, from the first point. If it is a parabola or a hyperbola, its least arc through all five points, with the
slopes of the lines from the first point as the parameter; of a parabola it is polynomial.

The conic is found by elimination and projected from the first point onto lines, exactly; so it is exact where the
kernel is. In kernels of doubles the control points of the conic through the given doubles are rounded.
\throws Invalid_input when the points do not determine one conic, it is a pair of lines (three points on a line), or the
points are on both branches of a hyperbola; and for coordinates that are not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> conic_curve(const std::array<CGAL::Point_2<Kernel>, 5>& points)
{
  const auto origin = internal::exact_object(points[0]);
  std::array<internal::Exact_kernel::Vector_2, 4> others;
  for (std::size_t i = 0; i < 4; ++i)
    others[i] = internal::exact_object(points[i + 1]) - origin;
  return Bspline_curve_2<Kernel>(internal::conic_arc(internal::conic_through(others), origin, others));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CONIC_CURVE_H
