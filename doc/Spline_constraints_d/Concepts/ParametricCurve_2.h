// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `ParametricCurve_2` describes a rational curve in the plane, piecewise so on a range of parameters, as
geometric operations need it: its homogeneous coordinates are what constraints are made of, and evaluation turns
parameters that were found into points.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Bspline_curve<Kernel,2>}
\cgalHasModelsEnd
*/
class ParametricCurve_2
{
public:
  //! a `SplineKernel`.
  typedef unspecified_type Kernel;

  //! one parameter.
  static constexpr int number_of_parameters = 1;

  /*!
  the numerators of the coordinates, as exact splines of the parameters. Their domains are that of the curve, those of
  all and of the weight are the same; degrees and knots may differ.
  */
  std::array<Bspline_function<Exact_rational>, 2> homogeneous_coordinates() const;

  //! the common denominator, which is positive on the whole domain; a constant, best of degree 0, if the curve is
  //! polynomial.
  Bspline_function<Exact_rational> weight() const;

  //! whether the weight is not constant.
  bool is_rational() const;

  //! the range of the parameter of an axis, as that of `weight()`.
  std::pair<Kernel::FT, Kernel::FT> domain(int axis) const;

  //! the point at parameters of the domain. \throws Invalid_input outside of it.
  Kernel::Point_2 operator()(const Kernel::FT& t) const;
};
