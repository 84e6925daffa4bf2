// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_BSPLINE_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_BSPLINE_CURVE_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/geometry/Parametric_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/periodic_knots.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A B-spline curve in the plane or in space, rational or not, of any degree, on any valid knots. `Bspline_curve_2` and
`Bspline_curve_3` are names for the two.

A curve of degree \f$p\f$ with \f$n\f$ control points \f$P_i\f$ and weights \f$w_i\f$ is \f$C(t) = \sum_i w_i P_i N_i(t)
/ \sum_i w_i N_i(t)\f$, where \f$N_i\f$ are the B-splines of the \f$n+p+1\f$ knots; its domain and the rules for knots
are those of `Bspline_function`.

Parameters outside of the domain, and what is not a number, are rejected with `Invalid_input` by all functions.

\tparam Kernel_ a `SplineKernel`.
\tparam d 2 or 3.

\cgalModels{ParametricCurve_2,ParametricCurve_3}
*/
template <SplineKernel Kernel_, int d>
class Bspline_curve
  : public Parametric_spline<Bspline_curve<Kernel_, d>, Kernel_, d>
{
  static_assert(d == 2 || d == 3, "Bspline_curve is for the plane and for space");

  using Base = Parametric_spline<Bspline_curve, Kernel_, d>;
  using typename Base::NT;
  using typename Base::Representation;
  using Coordinates = std::array<NT, d>;
  friend Base;

public:
  using typename Base::FT;
  using typename Base::Kernel;
  using typename Base::Point;
  using typename Base::Vector;

  using Base::breaks;
  using Base::degree;
  using Base::domain;
  using Base::elevated;
  using Base::is_closed;
  using Base::knots;
  using Base::restricted;
  using Base::reversed;
  using Base::size;
  using Base::split;
  using Base::with_domain;
  using Base::with_knot;
  using Base::without_knot;

  //! number of parameters.
  static constexpr int number_of_parameters = 1;

  // For the package.
  explicit Bspline_curve(Representation map) : Base(std::move(map)) {}

  /// \name Construction
  /// @{

  /*!
  the curve of these control points, rational if there are weights.
  \throws Invalid_input as `Bspline_function`; and when the number of weights is not that of the points, one is zero or
  not finite, or the weight function is not positive (or not negative) on the whole domain. Messages name the index.
  */
  Bspline_curve(int degree, const std::vector<FT>& knots, const std::vector<Point>& points,
                const std::vector<FT>& weights = {})
    : Base(Representation({degree}, {Base::numbers(knots)}, Base::coordinates(points), Base::numbers(weights),
                          "Bspline_curve"))
  {}

  //! the curve in another kernel: exactly, or with doubles next to the numerators, weights and knots. \throws
  //! Invalid_input when what was rounded is no valid curve.
  template <SplineKernel Other>
  requires(!std::same_as<Other, Kernel_>) explicit Bspline_curve(const Bspline_curve<Other, d>& other)
    : Base(other.representation().template converted<NT>("Bspline_curve"))
  {}

  //! the curve `numerators / weight`, on the knots of all of them.
  //! \throws Invalid_input when they are not functions of as many parameters, the domains differ, or the weight is not
  //! positive (or not negative).
  static Bspline_curve from_homogeneous_coordinates(const std::array<Bspline_function<NT>, d>& numerators,
                                                    const Bspline_function<NT>& weight)
  {
    return Bspline_curve(Base::from_functions(numerators, weight, "Bspline_curve"));
  }

  /*!
  the closed curve of \f$n\f$ control points on \f$n+1\f$ periodic knots \f$u_0 \le \dots \le u_n\f$, where \f$u_n\f$
  stands for \f$u_0\f$ again, unwrapped: the knots are continued periodically by `degree` to both sides, the first
  `degree` control points come again at the end, and the domain is the period \f$[u_0, u_n]\f$. Exact numbers make it
  closed, and as smooth at the seam as inside; continued doubles are rounded.
  \throws Invalid_input as the constructor, and for a degree below 1, an empty period, or a knot that occurs too often
  across the seam.
  */
  static Bspline_curve from_periodic(int degree, const std::vector<FT>& period, std::vector<Point> points,
                                     std::vector<FT> weights = {})
  {
    const std::vector<NT> all_knots = internal::unwrapped_knots(degree, Base::numbers(period), "Bspline_curve");
    internal::check_count(points.size(), period.size() - 1, "Bspline_curve: control points of a period");
    if (!weights.empty())
      internal::check_count(weights.size(), points.size(), "Bspline_curve: weights");
    for (int i = 0; i < degree; ++i) {
      points.push_back(Point(points[i]));
      if (!weights.empty())
        weights.push_back(FT(weights[i]));
    }
    return Bspline_curve(
        Representation({degree}, {all_knots}, Base::coordinates(points), Base::numbers(weights), "Bspline_curve"));
  }

  /// @}
  /// \name Representation
  /// @{

  int degree() const { return this->degree(0); }
  std::size_t size() const { return this->size(0); }
  std::vector<FT> knots() const { return this->knots(0); }
  std::vector<FT> breaks() const { return this->breaks(0); }
  std::pair<FT, FT> domain() const { return this->domain(0); }

  /// @}
  /// \name Points and Derivatives
  /// @{

  //! the point at a parameter.
  Point operator()(const FT& t) const { return internal::kernel_object<Kernel, Point>(all_derivatives(t, 0)[0]); }

  //! the point at the begin of the domain.
  Point source() const { return (*this)(domain().first); }

  //! the point at the end of the domain.
  Point target() const { return (*this)(domain().second); }

  //! the derivatives of order 0 (the vector from the origin to the point) up to `order`; at a knot from the right, at
  //! the end of the domain from the left.
  std::vector<Vector> derivatives(const FT& t, int order) const
  {
    std::vector<Vector> result;
    for (const Coordinates& derivative : all_derivatives(t, order))
      result.push_back(internal::kernel_object<Kernel, Vector>(derivative));
    return result;
  }

  //! one derivative. \throws Invalid_input when the order is negative.
  Vector derivative(const FT& t, int order = 1) const { return derivatives(t, order).back(); }

  //! the first derivative, not normalised.
  Vector tangent(const FT& t) const { return derivative(t, 1); }

  //! the tangent turned by a right angle to the left, \f$(-y', x')\f$, not normalised.
  Vector normal(const FT& t) const
    requires (d == 2)
  {
    return tangent(t).perpendicular(CGAL::COUNTERCLOCKWISE);
  }

  //! \f$C' \times C''\f$, not normalised.
  Vector binormal(const FT& t) const
    requires (d == 3)
  {
    const std::vector<Vector> derivative = derivatives(t, 2);
    return CGAL::cross_product(derivative[1], derivative[2]);
  }

  //! the direction from the point to its centre of curvature, \f$(C' \times C'') \times C'\f$, not normalised.
  Vector principal_normal(const FT& t) const
    requires (d == 3)
  {
    return CGAL::cross_product(binormal(t), tangent(t));
  }

  //! the square of the curvature, \f$\|C' \times C''\|^2 / \|C'\|^6\f$: rational. \throws Invalid_input when \f$C'\f$
  //! is zero.
  FT squared_curvature(const FT& t) const { return internal::converted_number<FT>(curvature_terms(t).first); }

  //! the curvature; in the plane positive where the curve turns to the left. The square root of a double that is next
  //! to `squared_curvature()`. \throws Invalid_input as that.
  double curvature(const FT& t) const
  {
    const auto [square, turn] = curvature_terms(t);
    const double value = std::sqrt(internal::converted_number<double>(square));
    return d == 2 && turn < NT(0) ? -value : value;
  }

  /// @}
  /// \name Operations
  /// For those with an axis, see `Parametric_spline`.
  /// @{

  Bspline_curve restricted(const FT& begin, const FT& end) const { return this->restricted(0, begin, end); }
  std::pair<Bspline_curve, Bspline_curve> split(const FT& t) const { return this->split(0, t); }
  Bspline_curve reversed() const { return this->reversed(0); }
  Bspline_curve with_domain(const FT& begin, const FT& end) const { return this->with_domain(0, begin, end); }
  Bspline_curve elevated(int degree) const { return this->elevated(std::vector<int>{degree}); }
  Bspline_curve with_knot(const FT& t) const { return this->with_knot(0, t); }
  std::optional<Bspline_curve> without_knot(const FT& t) const { return this->without_knot(0, t); }
  bool is_closed() const { return this->is_closed(0); }

  /// @}

private:
  std::vector<Coordinates> all_derivatives(const FT& t, int order) const
  {
    const std::array<NT, 1> u{Base::number(t)};
    std::vector<Coordinates> result;
    for (const auto& entry : this->representation().derivatives(u, order))
      result.push_back(entry.second);
    return result;
  }

  // The squared curvature, and the component of C' x C'' in the plane of the first two axes.
  std::pair<NT, NT> curvature_terms(const FT& t) const
  {
    const std::vector<Coordinates> derivative = all_derivatives(t, 2);
    const Coordinates &a = derivative[1], &b = derivative[2];
    NT squared_speed(0), squared_product(0);
    for (int i = 0; i < d; ++i) {
      squared_speed += a[i] * a[i];
      for (int j = 0; j < i; ++j) {
        const NT minor = NT(a[j] * b[i]) - NT(a[i] * b[j]);
        squared_product += minor * minor;
      }
    }
    if (squared_speed == NT(0))
      throw Invalid_input("Bspline_curve: the curve has no curvature where its first derivative is zero");
    return {NT(squared_product / NT(NT(squared_speed * squared_speed) * squared_speed)),
            NT(NT(a[0] * b[1]) - NT(a[1] * b[0]))};
  }
};

#define CGAL_SPLINE_CONSTRAINTS_BSPLINE_CURVES(EXTERN, NT)                                                             \
  EXTERN template class Parametric_spline<Bspline_curve<CGAL::Simple_cartesian<NT>, 2>,                                \
                                          CGAL::Simple_cartesian<NT>, 2>;                                              \
  EXTERN template class Parametric_spline<Bspline_curve<CGAL::Simple_cartesian<NT>, 3>,                                \
                                          CGAL::Simple_cartesian<NT>, 3>;                                              \
  EXTERN template class Bspline_curve<CGAL::Simple_cartesian<NT>, 2>;                                                  \
  EXTERN template class Bspline_curve<CGAL::Simple_cartesian<NT>, 3>;

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_BSPLINE_CURVES(extern, double)
CGAL_SPLINE_CONSTRAINTS_BSPLINE_CURVES(extern, Exact_rational)
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_BSPLINE_CURVE_H
