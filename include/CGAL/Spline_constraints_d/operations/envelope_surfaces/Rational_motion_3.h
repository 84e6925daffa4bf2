// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_RATIONAL_MOTION_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_RATIONAL_MOTION_3_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

An affine motion whose coefficients are rational splines of the time, exactly: it takes a point \f$x\f$ to \f$(M(t)\,x +
c(t)) / w(t)\f$. Made by the functions below, and composed by `*`.
*/
class Rational_motion_3
{
public:
  //! a spline of the time, in exact numbers.
  using Function = Bspline_function<Exact_rational>;

  //! the kernel of exact numbers that its values belong to.
  using Kernel = CGAL::Simple_cartesian<Exact_rational>;

private:
  std::array<std::array<Function, 3>, 4> m_columns; // of M, and c
  Function m_weight;

public:
  /*!
  the motion with these columns of \f$M\f$, this \f$c\f$ and this \f$w\f$.
  \throws Invalid_input when a function is not one of the time alone, domains differ, or \f$w\f$ is not proved to have
  one sign.
  */
  Rational_motion_3(const std::array<std::array<Function, 3>, 3>& columns, const std::array<Function, 3>& path,
                    const Function& weight);

  //! the motion that a path and the images of the unit vectors give. \throws Invalid_input when there are axes, but not
  //! three, or domains differ.
  template <SplineKernel K>
  Rational_motion_3(const Affine_motion<K>& motion) : Rational_motion_3(along(motion.path))
  {
    if (motion.axes.empty())
      return;
    if (motion.axes.size() != 3)
      throw Invalid_input("Rational_motion_3: a motion has three axes or none");
    const internal::Common::Exact_map<3> path = internal::Common::exact_map<3>(motion.path);
    std::vector<internal::Common::Exact_map<3>> maps;
    for (const auto& axis : motion.axes)
      maps.push_back(internal::Common::exact_map<3>(axis));
    maps.push_back(path);
    std::vector<Function> weights; // different ones
    const auto weight_of = [](const auto& map) {
      return map.is_rational ? map.weight
                             : Function({0}, {{map.numerators[0].domain(0).first, map.numerators[0].domain(0).second}},
                                        {Exact_rational(1)});
    };
    std::vector<std::size_t> own;
    for (const auto& map : maps) {
      const Function weight = weight_of(map);
      std::size_t k = 0;
      while (k < weights.size() && !(weights[k] == weight))
        ++k;
      if (k == weights.size())
        weights.push_back(weight);
      own.push_back(k);
    }
    std::array<std::array<Function, 3>, 4> columns;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        columns[k][i] = maps[k].numerators[i];
        for (std::size_t j = 0; j < weights.size(); ++j)
          if (j != own[k])
            columns[k][i] = columns[k][i] * weights[j];
      }
    Function weight = weights[0];
    for (std::size_t j = 1; j < weights.size(); ++j)
      weight = weight * weights[j];
    *this = Rational_motion_3({columns[0], columns[1], columns[2]}, columns[3], weight);
  }

  //! the translation that takes the origin along a curve, whose parameter is the time.
  template <ParametricCurve_3 Curve>
  static Rational_motion_3 along(const Curve& path)
  {
    const internal::Common::Exact_map<3> map = internal::Common::exact_map<3>(path);
    const Function one = constant(map.numerators[0].domain(0), 1), zero = one * Exact_rational(0),
                   weight = map.is_rational ? map.weight : one;
    return Rational_motion_3({{{weight, zero, zero}, {zero, weight, zero}, {zero, zero, weight}}}, map.numerators,
                             weight);
  }

  /*!
  the rotation about the origin by a quaternion \f$a = a_0 + a_1 i + a_2 j + a_3 k\f$, of any length that is not zero:
  it takes \f$x\f$ to \f$a x \bar a / |a|^2\f$. All rational rotations are of this form.
  \throws Invalid_input when the domains differ, or it is not proved that \f$a \neq 0\f$.
  */
  static Rational_motion_3 rotation(const std::array<Function, 4>& a);

  /*!
  the rotation about a line by the angle \f$2 \arctan(q\,|d| / p)\f$, where \f$d\f$ is the direction of the line.
  \param center a point of the line.
  \param direction its direction, of any length.
  \param p,q splines of the time, which are not zero at the same time.
  \throws Invalid_input when the direction is zero, and as above.
  */
  template <SplineKernel K>
  static Rational_motion_3 rotation(const CGAL::Point_3<K>& center, const CGAL::Vector_3<K>& direction,
                                    const Function& p, const Function& q)
  {
    const auto d = internal::exact_object(direction);
    if (d == CGAL::NULL_VECTOR)
      throw Invalid_input("Rational_motion_3: the direction of an axis is zero");
    return around(rotation({p, q * d.x(), q * d.y(), q * d.z()}), center);
  }

  //! one full turn about a line, anticlockwise seen against its direction, while the time goes from 0 to 2.
  //! \throws Invalid_input when the direction is zero.
  template <SplineKernel K>
  static Rational_motion_3 full_turn(const CGAL::Point_3<K>& center, const CGAL::Vector_3<K>& direction)
  {
    const auto d = internal::exact_object(direction);
    if (d == CGAL::NULL_VECTOR)
      throw Invalid_input("Rational_motion_3: the direction of an axis is zero");
    const Exact_rational scale = internal::near_inverse_root(d.squared_length());
    const Function p({1}, {{0, 0, 2, 2}}, {1, -1}), q({1}, {{0, 0, 1, 2, 2}}, {0, scale, 0});
    return rotation(center, direction, p, q);
  }

  //! the scaling from a fixed point by a factor that depends on the time. \throws Invalid_input when the factor is not
  //! proved to have one sign.
  template <SplineKernel K>
  static Rational_motion_3 scaling(const CGAL::Point_3<K>& center, const Function& factor)
  {
    internal::certified_weight_sign(factor, {});
    const Function one = constant(factor.domain(0), 1), zero = one * Exact_rational(0);
    return around(Rational_motion_3({{{factor, zero, zero}, {zero, factor, zero}, {zero, zero, factor}}},
                                    {zero, zero, zero}, one),
                  center);
  }

  //! the first motion, applied to what the second one has moved. \throws Invalid_input when the domains differ.
  friend Rational_motion_3 operator*(const Rational_motion_3& first, const Rational_motion_3& second);

  //! the first and the last time.
  std::pair<Exact_rational, Exact_rational> domain() const { return m_weight.domain(0); }

  //! the columns of \f$M\f$, and \f$c\f$ as the last one.
  const std::array<std::array<Function, 3>, 4>& columns() const { return m_columns; }

  //! \f$w > 0\f$.
  const Function& weight() const { return m_weight; }

  //! the map at a time, exactly. \throws Invalid_input when the time is outside of the domain.
  CGAL::Aff_transformation_3<Kernel> operator()(const Exact_rational& time) const;

  //! the map at a time back, exactly: with a fixed point it is the path of this point seen from the moving space.
  //! \throws Invalid_input when the map at this time has none, or the time is outside of the domain.
  CGAL::Aff_transformation_3<Kernel> inverse(const Exact_rational& time) const;

  //! whether the maps at two times are the same. \throws Invalid_input when a time is outside of the domain.
  bool has_same_map(const Exact_rational& time, const Exact_rational& other) const;

private:
  static Function constant(const std::pair<Exact_rational, Exact_rational>& domain, const Exact_rational& value)
  {
    return Function({0}, {{domain.first, domain.second}}, {value});
  }

  // A linear motion about another fixed point than the origin.
  template <SplineKernel K>
  static Rational_motion_3 around(const Rational_motion_3& linear, const CGAL::Point_3<K>& center)
  {
    const auto o = internal::exact_object(center);
    std::array<Function, 3> path = linear.m_columns[3];
    for (std::size_t i = 0; i < 3; ++i)
      path[i] = linear.m_weight * o[static_cast<int>(i)] -
          (linear.m_columns[0][i] * o.x() + linear.m_columns[1][i] * o.y() + linear.m_columns[2][i] * o.z());
    return Rational_motion_3({linear.m_columns[0], linear.m_columns[1], linear.m_columns[2]}, path, linear.m_weight);
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE
Rational_motion_3::Rational_motion_3(const std::array<std::array<Function, 3>, 3>& columns,
                                     const std::array<Function, 3>& path, const Function& weight)
  : m_columns{columns[0], columns[1], columns[2], path}, m_weight(weight)
{
  for (const auto& column : m_columns)
    for (const Function& f : column)
      if (f.dimension() != 1 || weight.dimension() != 1 || f.domain(0) != weight.domain(0))
        throw Invalid_input("Rational_motion_3: not all functions are splines of the time on the same domain");
  if (internal::certified_weight_sign(m_weight, {}) > 0)
    return;
  m_weight = -m_weight;
  for (auto& column : m_columns)
    for (Function& f : column)
      f = -f;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_motion_3 Rational_motion_3::rotation(const std::array<Function, 4>& a)
{
  const auto product = [&](std::size_t i, std::size_t k) { return a[i] * a[k]; };
  const auto twice = [](const Function& f) { return f * Exact_rational(2); };
  const Function s = product(0, 0), x = product(1, 1), y = product(2, 2), z = product(3, 3), weight = s + x + y + z;
  const Function xy = product(1, 2), xz = product(1, 3), yz = product(2, 3), sx = product(0, 1), sy = product(0, 2),
                 sz = product(0, 3), zero = weight * Exact_rational(0);
  return Rational_motion_3({{{s + x - y - z, twice(xy + sz), twice(xz - sy)},
                             {twice(xy - sz), s - x + y - z, twice(yz + sx)},
                             {twice(xz + sy), twice(yz - sx), s - x - y + z}}},
                           {zero, zero, zero}, weight);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_motion_3 operator*(const Rational_motion_3& first,
                                                           const Rational_motion_3& second)
{
  std::array<std::array<Bspline_function<Exact_rational>, 3>, 4> columns;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      Bspline_function<Exact_rational> sum = first.m_columns[0][i] * second.m_columns[k][0] +
          first.m_columns[1][i] * second.m_columns[k][1] + first.m_columns[2][i] * second.m_columns[k][2];
      columns[k][i] = k < 3 ? sum : sum + first.m_columns[3][i] * second.m_weight;
    }
  return Rational_motion_3({columns[0], columns[1], columns[2]}, columns[3], first.m_weight * second.m_weight);
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Aff_transformation_3<Rational_motion_3::Kernel>
Rational_motion_3::operator()(const Exact_rational& time) const
{
  const std::array<Exact_rational, 1> t{time};
  const Exact_rational w = m_weight(t);
  const auto entry = [&](std::size_t i, std::size_t k) { return Exact_rational(m_columns[k][i](t) / w); };
  return {entry(0, 0), entry(0, 1), entry(0, 2), entry(0, 3), entry(1, 0), entry(1, 1),
          entry(1, 2), entry(1, 3), entry(2, 0), entry(2, 1), entry(2, 2), entry(2, 3)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Aff_transformation_3<Rational_motion_3::Kernel>
Rational_motion_3::inverse(const Exact_rational& time) const
{
  const CGAL::Aff_transformation_3<Kernel> map = (*this)(time);
  const auto m = [&](int i, int k) { return map.m(i, k); };
  if (m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) - m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
          m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0)) ==
      0)
    throw Invalid_input("Rational_motion_3: the map at this time is not invertible");
  return map.inverse();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Rational_motion_3::has_same_map(const Exact_rational& time,
                                                                    const Exact_rational& other) const
{
  const std::array<Exact_rational, 1> first{time}, last{other};
  const Exact_rational w = m_weight(first), other_w = m_weight(last);
  for (const auto& column : m_columns)
    for (const Function& f : column)
      if (f(first) * other_w != f(last) * w)
        return false;
  return true;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_RATIONAL_MOTION_3_H
