// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `ParametricMap` describes a curve or surface that shows the exact splines it consists of. A `Spline_map`,
which formulas use, can be made of it.

All splines have the same domain, and one axis for each parameter.
*/
class ParametricMap
{
public:
  //! number of parameters, 1 for a curve and 2 for a surface.
  static constexpr int number_of_parameters;

  //! the coordinates, two in the plane and three in space; if the map is rational, those times the weight.
  std::array<Bspline_function<Exact_rational>, dimension> homogeneous_coordinates() const;

  //! tells whether there is a weight. If not, `weight()` is not looked at.
  bool is_rational() const;

  //! what the coordinates are divided by. It has no zero.
  Bspline_function<Exact_rational> weight() const;
};
