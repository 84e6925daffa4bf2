// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_OFFSET_CURVE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_OFFSET_CURVE_2_H

#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The point of the offset of a curve at a parameter, which is clipped to its domain, rounded.
std::array<double, 2> offset_point(const Differentiated_map& curve, const Exact_rational& distance,
                                   const Exact_rational& t);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::array<double, 2>
offset_point(const Differentiated_map& curve, const Exact_rational& distance, const Exact_rational& t)
{
  const Exact_rational place = (std::max)(curve.begin(), (std::min)(t, curve.end()));
  const Exact_pair p = curve.at(0, place), tangent = curve.at(1, place);
  const double dx = to_nearest_double(tangent[0]), dy = to_nearest_double(tangent[1]),
               factor = to_nearest_double(distance) / std::hypot(dx, dy);
  return {to_nearest_double(p[0]) - factor * dy, to_nearest_double(p[1]) + factor * dx};
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

The offset of a planar curve: the points \f$C(u) + r\,N(u)/|N(u)|\f$ with the normal \f$N = (-y', x')\f$, at the signed
distance \f$r\f$, to the left of the curve if \f$r > 0\f$.

It is not rational as a rule, but constraints describe it exactly: \f$q^2 = |N|^2\f$ for the point \f$C + r N/q\f$, or
\f$\langle P - C, C'\rangle = 0\f$, \f$|P-C|^2 = r^2\f$ and
\f$r\,\langle P - C, N\rangle > 0\f$ for a given point \f$P\f$. The offset is taken as a whole, with its cusps and what
an offset for machining would trim.

At a corner the offset has a gap; it consists of the offsets of the smooth parts, without arcs between them.

\cgalModels{Locus}
*/
class Offset_curve_2
{
  internal::Planar_map m_curve;
  Exact_rational m_distance;
  std::vector<internal::Smooth_part> m_parts;
  std::vector<internal::Exact_range> m_speeds;

public:
  //! number of coordinates.
  static constexpr int dimension = 2;
  //! the parameter is that of the curve.
  static constexpr int number_of_parameters = 1;
  //! a curve in the plane.
  static constexpr int codimension = 1;

  /*!
  the offset of a curve.
  \tparam Curve a model of `ParametricCurve_2`.
  \param curve the curve.
  \param distance the signed distance, exactly; not zero.
  \throws Invalid_input when the distance is zero or not finite, or the derivative of the curve vanishes, or nearly so;
  the message says where.
  */
  template <ParametricCurve_2 Curve>
  Offset_curve_2(const Curve& curve, const typename Curve::Kernel::FT& distance)
    : m_curve(curve), m_distance(internal::converted_number<Exact_rational>(distance)),
      m_parts(internal::smooth_parts(m_curve))
  {
    if (m_distance == Exact_rational(0))
      throw Invalid_input("Offset_curve_2: the distance is zero");
    for (const internal::Smooth_part& part : m_parts)
      m_speeds.push_back(internal::length_range<2>(tangent_of(part), {part.curve.map().domain(0)},
                                                   "Offset_curve_2: the derivative of the curve"));
  }

  //! the curve itself.
  const Spline_map<1, 2>& curve() const { return m_curve; }

  //! the signed distance.
  const Exact_rational& distance() const { return m_distance; }

  //! the range of the parameter.
  std::pair<Exact_rational, Exact_rational> domain(int = 0) const { return m_curve.domain(0); }

  //! the point at a parameter, rounded; at a corner, that of the part after it. \throws Invalid_input when the
  //! parameter is not in the domain.
  std::array<double, 2> operator()(const Exact_rational& t) const;

  /// \name Model of Locus
  /// @{

  //! one piece for each smooth part.
  std::vector<Locus_piece<2>> locus_pieces() const;

  //! both ends; the seam of a closed curve, too.
  std::vector<Locus_end<2>> locus_ends() const;

  /// @}

private:
  static internal::Vector_formula<2> tangent_of(const internal::Smooth_part& part)
  {
    return [curve = part.curve](std::span<const Unknown> u) { return curve(1, u[0]); };
  }

  Locus_piece<2> piece(const internal::Vector_formula<2>& point, const internal::Vector_formula<2>& tangent,
                       const Unknown_domains& parameters, const internal::Exact_range& speed) const
  {
    const auto normal = [tangent](std::span<const Unknown> u) { return perpendicular(tangent(u)); };
    return internal::offset_piece<2>(point, {tangent}, normal, m_distance, parameters, speed);
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::array<double, 2> Offset_curve_2::operator()(const Exact_rational& t) const
{
  if (t < domain().first || domain().second < t)
    throw Invalid_input("Offset_curve_2: the parameter is outside of the domain");
  std::size_t i = 0;
  while (i + 1 < m_parts.size() && m_parts[i].curve.end() <= t)
    ++i;
  return internal::offset_point(m_parts[i].curve, m_distance, t);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Locus_piece<2>> Offset_curve_2::locus_pieces() const
{
  std::vector<Locus_piece<2>> result;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    const internal::Differentiated_map& curve = m_parts[i].curve;
    const auto point = [curve](std::span<const Unknown> u) { return curve(0, u[0]); };
    result.push_back(piece(point, tangent_of(m_parts[i]), {curve.map().domain(0)}, m_speeds[i]));
    result.back().is_without_end[0] = !m_parts[i].has_end;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Locus_end<2>> Offset_curve_2::locus_ends() const
{
  const auto end = [this](const internal::Differentiated_map& curve, const Exact_rational& t) {
    const internal::Vector_formula<2> tangent = internal::constant_formula<2>(curve.at(1, t));
    return Locus_end<2>{t,
                        piece(internal::constant_formula<2>(curve.at(0, t)), tangent, {},
                              internal::length_range<2>(tangent, {}, "Offset_curve_2: the derivative at an end"))};
  };
  const internal::Differentiated_map &first = m_parts.front().curve, &last = m_parts.back().curve;
  return {end(first, first.begin()), end(last, last.end())};
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_OFFSET_CURVE_2_H
