// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `ParametricSurface_3` describes a rational surface in space, piecewise so on a rectangle of parameters, as
geometric operations need it: its homogeneous coordinates are what constraints are made of, and evaluation turns
parameters that were found into points.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Bspline_surface_3<Kernel>}
\cgalHasModelsEnd
*/
class ParametricSurface_3
{
public:
  //! a `SplineKernel`.
  typedef unspecified_type Kernel;

  //! two parameters.
  static constexpr int number_of_parameters = 2;

  /*!
  the numerators of the coordinates, as exact splines of the parameters. Their domains are that of the surface, those of
  all and of the weight are the same; degrees and knots may differ.
  */
  std::array<Bspline_function<Exact_rational>, 3> homogeneous_coordinates() const;

  //! the common denominator, which is positive on the whole domain; a constant, best of degree 0, if the surface is
  //! polynomial.
  Bspline_function<Exact_rational> weight() const;

  //! whether the weight is not constant.
  bool is_rational() const;

  //! the range of the parameter of an axis, as that of `weight()`.
  std::pair<Kernel::FT, Kernel::FT> domain(int axis) const;

  //! the point at parameters of the domain. \throws Invalid_input outside of it.
  Kernel::Point_3 operator()(const Kernel::FT& u, const Kernel::FT& v) const;
};
