// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_RATIONAL_MOTION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_RATIONAL_MOTION_2_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Point_2.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFirstContacts

An affine motion of the plane whose coefficients are rational splines of the time, exactly: it takes a point \f$x\f$ to
\f$(M(t)\,x + c(t)) / w(t)\f$, and its maps are invertible at all times. Made by the functions below, and composed by
`*`.
*/
class Rational_motion_2
{
public:
  //! a spline of the time, in exact numbers.
  using Function = Bspline_function<Exact_rational>;

  //! the kernel of exact numbers that its values belong to.
  using Kernel = CGAL::Simple_cartesian<Exact_rational>;

private:
  std::array<std::array<Function, 2>, 3> m_columns; // of M, and c
  Function m_weight;
  int m_orientation = 1; // of the determinant of M

public:
  /*!
  the motion with these columns of \f$M\f$, this \f$c\f$ and this \f$w\f$.
  \throws Invalid_input when a function is not one of the time alone, domains differ, \f$w\f$ is not proved to have
  one sign, or it is not proved that \f$\det M \neq 0\f$ at all times.
  */
  Rational_motion_2(const std::array<std::array<Function, 2>, 2>& columns, const std::array<Function, 2>& path,
                    const Function& weight);

  //! the translation that takes the origin along a curve, whose parameter is the time.
  template <ParametricCurve_2 Curve>
  static Rational_motion_2 along(const Curve& path)
  {
    const internal::Common::Exact_map<2> map = internal::Common::exact_map<2>(path);
    const Function one = constant(map.numerators[0].domain(0), Exact_rational(1)), zero = one * Exact_rational(0),
                   weight = map.is_rational ? map.weight : one;
    return Rational_motion_2({{{weight, zero}, {zero, weight}}}, map.numerators, weight);
  }

  /*!
  the rotation about a point by the angle \f$2 \arctan(q / p)\f$, anticlockwise; with \f$p = 1\f$, \f$q\f$ is the
  tangent of half of the angle. All rational rotations are of this form.
  \param center the point.
  \param p,q splines of the time, which are not zero at the same time.
  \throws Invalid_input when the domains differ, or it is not proved that there is no common zero.
  */
  template <SplineKernel K>
  static Rational_motion_2 rotation(const CGAL::Point_2<K>& center, const Function& p, const Function& q)
  {
    const auto o = internal::exact_object(center);
    const Function cosine = p * p - q * q, sine = p * q * Exact_rational(2), weight = p * p + q * q;
    return Rational_motion_2(
        {{{cosine, sine}, {-sine, cosine}}},
        {weight * o.x() - (cosine * o.x() - sine * o.y()), weight * o.y() - (sine * o.x() + cosine * o.y())}, weight);
  }

  //! one full turn about a point, anticlockwise, while the time goes from 0 to 2.
  template <SplineKernel K>
  static Rational_motion_2 full_turn(const CGAL::Point_2<K>& center)
  {
    return rotation(center, Function({1}, {{0, 0, 2, 2}}, {1, -1}), Function({1}, {{0, 0, 1, 2, 2}}, {0, 1, 0}));
  }

  //! the map of a point at each time is that of the image under `second` by `first`.
  //! \throws Invalid_input when the domains differ.
  friend Rational_motion_2 operator*(const Rational_motion_2& first, const Rational_motion_2& second);

  //! the motion back: with `*`, one body seen from another one that moves, too.
  Rational_motion_2 inverse() const;

  //! the same from one time to another.
  //! \throws Invalid_input when the second time is not after the first one, or one is outside of the domain.
  Rational_motion_2 restricted(const Exact_rational& begin, const Exact_rational& end) const;

  //! the first and the last time.
  std::pair<Exact_rational, Exact_rational> domain() const { return m_weight.domain(0); }

  //! the columns of \f$M\f$, and \f$c\f$ as the last one.
  const std::array<std::array<Function, 2>, 3>& columns() const { return m_columns; }

  //! \f$w > 0\f$.
  const Function& weight() const { return m_weight; }

  //! whether the maps keep orientations; or else they reverse them, at all times.
  bool keeps_orientation() const { return m_orientation > 0; }

  //! the map at a time, exactly. \throws Invalid_input when the time is outside of the domain.
  CGAL::Aff_transformation_2<Kernel> operator()(const Exact_rational& time) const;

private:
  static Function constant(const std::pair<Exact_rational, Exact_rational>& domain, const Exact_rational& value)
  {
    return Function({0}, {{domain.first, domain.second}}, {value});
  }

  Function determinant() const { return m_columns[0][0] * m_columns[1][1] - m_columns[0][1] * m_columns[1][0]; }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE
Rational_motion_2::Rational_motion_2(const std::array<std::array<Function, 2>, 2>& columns,
                                     const std::array<Function, 2>& path, const Function& weight)
  : m_columns{columns[0], columns[1], path}, m_weight(weight)
{
  for (const auto& column : m_columns)
    for (const Function& f : column)
      if (f.dimension() != 1 || weight.dimension() != 1 || f.domain(0) != weight.domain(0))
        throw Invalid_input("Rational_motion_2: not all functions are splines of the time on the same domain");
  if (internal::certified_weight_sign(m_weight, {}) < 0) {
    m_weight = -m_weight;
    for (auto& column : m_columns)
      for (Function& f : column)
        f = -f;
  }
  try {
    m_orientation = internal::certified_weight_sign(determinant(), {});
  } catch (const Invalid_input&) {
    throw Invalid_input("Rational_motion_2: it is not proved that the map is invertible at all times");
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_motion_2 operator*(const Rational_motion_2& first,
                                                           const Rational_motion_2& second)
{
  if (first.domain() != second.domain())
    throw Invalid_input("Rational_motion_2: motions that are composed have different domains");
  std::array<std::array<Bspline_function<Exact_rational>, 2>, 3> columns;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i) {
      const Bspline_function<Exact_rational> sum =
          first.m_columns[0][i] * second.m_columns[k][0] + first.m_columns[1][i] * second.m_columns[k][1];
      columns[k][i] = k < 2 ? sum : sum + first.m_columns[2][i] * second.m_weight;
    }
  return Rational_motion_2({columns[0], columns[1]}, columns[2], first.m_weight * second.m_weight);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_motion_2 Rational_motion_2::inverse() const
{
  const auto& [a, b, c] = m_columns;
  return Rational_motion_2({{{m_weight * b[1], -(m_weight * a[1])}, {-(m_weight * b[0]), m_weight * a[0]}}},
                           {b[0] * c[1] - b[1] * c[0], a[1] * c[0] - a[0] * c[1]}, determinant());
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_motion_2 Rational_motion_2::restricted(const Exact_rational& begin,
                                                                               const Exact_rational& end) const
{
  const auto part = [&](const Function& f) { return f.restricted(0, begin, end); };
  const auto vector = [&](const std::array<Function, 2>& v) { return std::array<Function, 2>{part(v[0]), part(v[1])}; };
  return Rational_motion_2({vector(m_columns[0]), vector(m_columns[1])}, vector(m_columns[2]), part(m_weight));
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Aff_transformation_2<Rational_motion_2::Kernel>
Rational_motion_2::operator()(const Exact_rational& time) const
{
  const std::array<Exact_rational, 1> t{time};
  const Exact_rational w = m_weight(t);
  const auto entry = [&](std::size_t i, std::size_t k) { return Exact_rational(m_columns[k][i](t) / w); };
  return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 0), entry(1, 1), entry(1, 2)};
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_RATIONAL_MOTION_2_H
