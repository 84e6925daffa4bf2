// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PIPE_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PIPE_SURFACE_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The continuous function of one parameter with these pieces between breaks.
inline Exact_function joined(const std::vector<Bernstein_tensor<Exact_rational>>& pieces, const std::vector<Exact_rational>& breaks, const std::string& discontinuity)
{
  const int degree = pieces[0].degree(0);
  std::vector<Exact_rational> knots(1, breaks[0]), coefficients = pieces[0].coefficients();
  for (const Exact_rational& t : breaks)
    knots.insert(knots.end(), static_cast<std::size_t>(degree), t);
  knots.push_back(breaks.back());
  for (std::size_t c = 1; c < pieces.size(); ++c) {
    const std::vector<Exact_rational>& next = pieces[c].coefficients();
    if (next.front() != coefficients.back())
      throw Invalid_input(discontinuity);
    coefficients.insert(coefficients.end(), next.begin() + 1, next.end());
  }
  return Exact_function({degree}, {knots}, std::move(coefficients));
}

// A multiple of the first derivative of a curve that is a piecewise polynomial: the derivative itself, of rational curves times the square of the weight.
inline Vector_function<3> direction_function(const Exact_space_curve& curve, const std::string& who)
{
  const auto coordinates = curve.homogeneous_coordinates();
  const std::vector<Exact_rational> breaks = curve.breaks();
  const auto weights = curve.weight().bezier_pieces();
  return Vector_function<3>::by_coordinate([&](int i) {
    auto pieces = coordinates[i].bezier_pieces();
    for (std::size_t c = 0; c < pieces.size(); ++c) {
      const Exact_rational width = breaks[c + 1] - breaks[c];
      const auto derivative = pieces[c].derivative(0) * Exact_rational(1 / width);
      pieces[c] = curve.is_rational() ? derivative * weights[c] - pieces[c] * (weights[c].derivative(0) * Exact_rational(1 / width)) : derivative;
    }
    return joined(pieces, breaks, who + ": the spine is not continuously differentiable");
  });
}

inline Exact_surface pipe(const Exact_space_curve& spine, const Exact_space_curve& normal, const std::string& who)
{
  if (spine.domain() != normal.domain())
    throw Invalid_input(who + ": the spine and its normal have different domains");
  const Vector_function<3> direction = direction_function(spine, who), m(normal.homogeneous_coordinates());
  const Scalar_function squared_weight = Scalar_function(normal.weight()) * normal.weight();
  const Exact_rational begin = normal.domain().first;
  const Exact_rational squared_radius = (normal(begin) - CGAL::ORIGIN).squared_length();
  if (squared_radius == 0 || !(dot(m, m) == squared_weight * squared_radius))
    throw Invalid_input(who + ": the normal is zero or its length is not constant");
  if (dot(m, direction).function().bounds() != std::pair(Exact_rational(0), Exact_rational(0)))
    throw Invalid_input(who + ": the normal is not at a right angle to the spine");

  const std::vector<Exact_rational> middle(1, Exact_rational((begin + normal.domain().second) / 2));
  const Exact_rational squared_speed = dot(direction, direction).function()(middle);
  const Direction_path turn = Direction_path::half_round(squared_speed == 0 ? Exact_rational(1) : near_inverse_root(squared_speed));
  const Exact_box domain{turn.domain()[0], spine.weight().domain(0)};
  const Direction_path path = turn.on_axis(domain, 0);
  const Curve_on_axis<3> center(spine, domain, 1), arm(normal, domain, 1);
  const Vector_function<3> axis = direction.on_axis(domain, 1);
  const Scalar_function arm_weight = rotation_weight(axis, path) * arm.weight;
  return quotient_surface(center.numerators * arm_weight + rotated(arm.numerators, axis, path) * center.weight, center.weight * arm_weight);
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the pipe around a spine: the surface of the circles in its normal planes, swept by turning a rational normal once around the tangent. Axis 0 is the turn, over
\f$[0,4]\f$; axis 1 is that of the spine. Points of the curve `normal` stand for the vectors from the origin to them; these have to be at a right angle to the spine and
of one length, the radius, everywhere.

All pipes of rational spines are rational \cgalCite{pp-crpcs-97}, but over the rational numbers only where such a normal can be given; it is all that is needed,
since the turn is rational in the derivative of the spine, whatever its length. For a planar spine it is a constant. Exact where the kernel is. Where the radius is larger
than the radius of curvature the pipe meets itself.
\throws Invalid_input when the domains differ, the spine is not continuously differentiable or its derivative vanishes, or the normal is not at a right angle to it or not
of constant length (decided exactly).
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> pipe_surface(const Bspline_curve_3<Kernel>& spine, const Bspline_curve_3<Kernel>& normal)
{
  return Bspline_surface_3<Kernel>(internal::pipe(internal::Exact_space_curve(spine), internal::Exact_space_curve(normal), "pipe_surface"));
}

//! the pipe around a spine in a plane; the radius is the length of the given vector, which is at a right angle to the plane. \throws Invalid_input as above.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> pipe_surface(const Bspline_curve_3<Kernel>& spine, const CGAL::Vector_3<Kernel>& normal)
{
  const auto arm = CGAL::ORIGIN + internal::exact_object(normal);
  const internal::Exact_space_curve curve(spine);
  const auto [begin, end] = curve.domain();
  return Bspline_surface_3<Kernel>(internal::pipe(curve, internal::Exact_space_curve(1, {begin, begin, end, end}, {arm, arm}), "pipe_surface"));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PIPE_SURFACE_H
