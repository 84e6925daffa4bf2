// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_BSPLINE_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_BSPLINE_SURFACE_3_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/geometry/Parametric_spline.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/periodic_knots.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A tensor-product B-spline surface in space, rational or not, of any degrees, on any valid knots. Axis 0 is that of the
parameter \f$u\f$, axis 1 that of \f$v\f$; control points are stored row-major: \f$P_{ij}\f$ with index \f$i n_1 + j\f$,
where \f$n_1\f$ is the number of control points along axis 1.

Parameters outside of the domain, and what is not a number, are rejected with `Invalid_input` by all functions.
Derivatives are from the right at knots, at the ends of the domain from inside.

\tparam Kernel_ a `SplineKernel`.

\cgalModels{ParametricSurface_3}
*/
template <SplineKernel Kernel_>
class Bspline_surface_3
  : public Parametric_spline<Bspline_surface_3<Kernel_>, Kernel_, 3>
{
  using Base = Parametric_spline<Bspline_surface_3, Kernel_, 3>;
  using typename Base::NT;
  using typename Base::Representation;
  using Coordinates = std::array<NT, 3>;
  friend Base;

public:
  using typename Base::FT;
  using typename Base::Kernel;
  using typename Base::Point;
  using typename Base::Vector;

  //! number of parameters.
  static constexpr int number_of_parameters = 2;

  // For the package.
  explicit Bspline_surface_3(Representation map) : Base(std::move(map)) {}

  /// \name Construction
  /// @{

  /*!
  the surface of these control points, rational if there are weights.
  \throws Invalid_input as the constructor of `Bspline_curve`.
  */
  Bspline_surface_3(const std::array<int, 2>& degrees, const std::vector<FT>& knots_u, const std::vector<FT>& knots_v,
                    const std::vector<Point>& points, const std::vector<FT>& weights = {})
    : Base(Representation({degrees[0], degrees[1]}, {Base::numbers(knots_u), Base::numbers(knots_v)},
                          Base::coordinates(points), Base::numbers(weights), "Bspline_surface_3"))
  {}

  //! the surface in another kernel: exactly, or with doubles next to the numerators, weights and knots. \throws
  //! Invalid_input when what was rounded is no valid surface.
  template <SplineKernel Other>
  requires(!std::same_as<Other, Kernel_>) explicit Bspline_surface_3(const Bspline_surface_3<Other>& other)
    : Base(other.representation().template converted<NT>("Bspline_surface_3"))
  {}

  //! the surface `numerators / weight`, on the knots of all of them.
  //! \throws Invalid_input when they are not functions of as many parameters, the domains differ, or the weight is not
  //! positive (or not negative).
  static Bspline_surface_3 from_homogeneous_coordinates(const std::array<Bspline_function<NT>, 3>& numerators,
                                                        const Bspline_function<NT>& weight)
  {
    return Bspline_surface_3(Base::from_functions(numerators, weight, "Bspline_surface_3"));
  }

  /*!
  the surface of control points and knots that are periodic along the axes marked in `is_periodic`, unwrapped along them
  as by `Bspline_curve::from_periodic()`: a periodic axis with \f$n\f$ control points has \f$n+1\f$ knots.
  \throws Invalid_input as `Bspline_curve::from_periodic()`.
  */
  static Bspline_surface_3 from_periodic(const std::array<int, 2>& degrees, const std::vector<FT>& knots_u,
                                         const std::vector<FT>& knots_v, const std::vector<Point>& points,
                                         const std::array<bool, 2>& is_periodic, const std::vector<FT>& weights = {})
  {
    std::vector<std::vector<NT>> all_knots{Base::numbers(knots_u), Base::numbers(knots_v)};
    std::array<std::size_t, 2> given, unwrapped;
    for (int j = 0; j < 2; ++j) {
      const std::size_t number_of_knots = all_knots[j].size();
      if (is_periodic[j])
        all_knots[j] =
            internal::unwrapped_knots(degrees[j], all_knots[j], "Bspline_surface_3: axis " + std::to_string(j));
      const std::size_t order = static_cast<std::size_t>((std::max)(degrees[j], 0)) + 1;
      if (all_knots[j].size() < 2 * order)
        throw Invalid_input("Bspline_surface_3: axis " + std::to_string(j) + " has too few knots");
      unwrapped[j] = all_knots[j].size() - order;
      given[j] = is_periodic[j] ? number_of_knots - 1 : unwrapped[j];
    }
    internal::check_count(points.size(), given[0] * given[1], "Bspline_surface_3: control points");
    if (!weights.empty())
      internal::check_count(weights.size(), points.size(), "Bspline_surface_3: weights");
    std::vector<Point> all_points;
    std::vector<FT> all_weights;
    for (std::size_t i = 0; i < unwrapped[0]; ++i)
      for (std::size_t j = 0; j < unwrapped[1]; ++j) {
        const std::size_t k = (i % given[0]) * given[1] + j % given[1];
        all_points.push_back(points[k]);
        if (!weights.empty())
          all_weights.push_back(weights[k]);
      }
    return Bspline_surface_3(Representation({degrees[0], degrees[1]}, all_knots, Base::coordinates(all_points),
                                            Base::numbers(all_weights), "Bspline_surface_3"));
  }

  /// @}
  /// \name Points and Derivatives
  /// @{

  //! the point at parameters.
  Point operator()(const FT& u, const FT& v) const
  {
    return internal::kernel_object<Kernel, Point>(derivative_table(u, v, 0).at({0, 0}));
  }

  //! the partial derivative of these orders. \throws Invalid_input when an order is negative.
  Vector derivative(const FT& u, const FT& v, int order_u, int order_v) const
  {
    if (order_u < 0 || order_v < 0)
      throw Invalid_input("Bspline_surface_3: the order of a derivative is negative");
    return internal::kernel_object<Kernel, Vector>(derivative_table(u, v, order_u + order_v).at({order_u, order_v}));
  }

  //! \f$\partial S/\partial u \times \partial S/\partial v\f$, not normalised; zero where the parametrisation is
  //! singular.
  Vector normal(const FT& u, const FT& v) const
  {
    const auto table = derivative_table(u, v, 1);
    return internal::kernel_object<Kernel, Vector>(cross(table.at({1, 0}), table.at({0, 1})));
  }

  //! the Gaussian curvature, a rational number. \throws Invalid_input where the parametrisation is singular.
  FT gaussian_curvature(const FT& u, const FT& v) const
  {
    const Fundamental_forms forms = fundamental_forms(u, v);
    const NT area = forms.squared_area();
    return internal::converted_number<FT>(NT(NT(NT(forms.L * forms.N) - NT(forms.M * forms.M)) / NT(area * area)));
  }

  //! the square of the mean curvature, a rational number. \throws Invalid_input where the parametrisation is singular.
  FT squared_mean_curvature(const FT& u, const FT& v) const
  {
    return internal::converted_number<FT>(mean_curvature_terms(u, v).first);
  }

  //! the mean curvature with respect to `normal()`: the square root of a double that is next to
  //! `squared_mean_curvature()`, with its sign. \throws Invalid_input as that.
  double mean_curvature(const FT& u, const FT& v) const
  {
    const auto [square, sign] = mean_curvature_terms(u, v);
    const double value = std::sqrt(internal::converted_number<double>(square));
    return sign < NT(0) ? -value : value;
  }

  /// @}
  /// \name Operations
  /// For those along one axis, see `Parametric_spline`.
  /// @{

  //! the surface with its two parameters exchanged.
  Bspline_surface_3 transposed() const
  {
    return this->mapped([](const auto& f) { return internal::transposed(f); });
  }

  //! the curve on which the parameter of an axis has one value; its parameter is the other one.
  Bspline_curve_3<Kernel> iso_curve(int axis, const FT& t) const
  {
    return Bspline_curve_3<Kernel>(
        this->representation().mapped([&](const auto& f) { return f.slice(axis, Base::number(t)); }));
  }

  /// @}

private:
  // Coefficients of the first fundamental form, and those of the second times the length of the normal.
  struct Fundamental_forms
  {
    NT E, F, G, L, M, N;

    NT squared_area() const { return NT(E * G) - NT(F * F); }
  };

  static Coordinates cross(const Coordinates& a, const Coordinates& b)
  {
    return {NT(NT(a[1] * b[2]) - NT(a[2] * b[1])), NT(NT(a[2] * b[0]) - NT(a[0] * b[2])),
            NT(NT(a[0] * b[1]) - NT(a[1] * b[0]))};
  }

  static NT dot(const Coordinates& a, const Coordinates& b)
  {
    return NT(NT(a[0] * b[0]) + NT(a[1] * b[1])) + NT(a[2] * b[2]);
  }

  std::map<std::vector<int>, Coordinates> derivative_table(const FT& u, const FT& v, int order) const
  {
    const std::array<NT, 2> parameters{Base::number(u), Base::number(v)};
    return this->representation().derivatives(parameters, order);
  }

  Fundamental_forms fundamental_forms(const FT& u, const FT& v) const
  {
    const auto table = derivative_table(u, v, 2);
    const Coordinates &along_u = table.at({1, 0}), &along_v = table.at({0, 1});
    const Coordinates normal = cross(along_u, along_v);
    if (dot(normal, normal) == NT(0))
      throw Invalid_input("Bspline_surface_3: no curvature where the parametrisation is singular");
    return {dot(along_u, along_u),         dot(along_u, along_v),         dot(along_v, along_v),
            dot(table.at({2, 0}), normal), dot(table.at({1, 1}), normal), dot(table.at({0, 2}), normal)};
  }

  // The square of the mean curvature, and a number of its sign.
  std::pair<NT, NT> mean_curvature_terms(const FT& u, const FT& v) const
  {
    const Fundamental_forms forms = fundamental_forms(u, v);
    const NT twice = NT(NT(forms.E * forms.N) + NT(forms.G * forms.L)) - NT(NT(2) * NT(forms.F * forms.M));
    const NT area = forms.squared_area();
    return {NT(NT(twice * twice) / NT(NT(4) * NT(NT(area * area) * area))), twice};
  }
};

#define CGAL_SPLINE_CONSTRAINTS_BSPLINE_SURFACES(EXTERN, NT)                                                           \
  EXTERN template class Parametric_spline<Bspline_surface_3<CGAL::Simple_cartesian<NT>>,                               \
                                          CGAL::Simple_cartesian<NT>, 3>;                                              \
  EXTERN template class Bspline_surface_3<CGAL::Simple_cartesian<NT>>;

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_BSPLINE_SURFACES(extern, double)
CGAL_SPLINE_CONSTRAINTS_BSPLINE_SURFACES(extern, Exact_rational)
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_BSPLINE_SURFACE_3_H
