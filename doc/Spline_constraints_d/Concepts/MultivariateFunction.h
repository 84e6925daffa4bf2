// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `MultivariateFunction` describes a continuous real function on a box of parameters that can be evaluated,
bounded together with its first derivatives, and restricted to smaller boxes. That is all a subdivision needs in order
to throw away boxes by proof.

A model is a value: copies are independent. The language concept of the same name in
`CGAL/Spline_constraints_d/function/concepts.h` checks what a compiler can check.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Bernstein_tensor<NT>}
\cgalHasModels{CGAL::Spline_constraints::Bspline_function<NT>}
\cgalHasModels{CGAL::Spline_constraints::Rational_function<Function>}
\cgalHasModelsEnd
*/
class MultivariateFunction
{
public:
  //! the type of parameters and values.
  typedef unspecified_type Number_type;

  //! number of axes.
  int dimension() const;

  //! begin and end of the range of a parameter.
  std::pair<Number_type, Number_type> domain(int axis) const;

  //! the value at a point of the domain, which has one parameter per axis.
  //! \throws Invalid_input when the number of parameters is not `dimension()`.
  Number_type operator()(std::span<const Number_type> u) const;

  //! two numbers between which all values on the domain lie. On a box split again and again they converge to the value.
  std::pair<Number_type, Number_type> bounds() const;

  //! two numbers between which the derivative along an axis lies wherever it exists.
  std::pair<Number_type, Number_type> derivative_bounds(int axis) const;

  /*!
  the function on a part of the domain. The ranges of the other axes stay. On `axis` the model chooses the new
  `domain()`, and the affine map from it onto [`begin`, `end`] relates the two functions: it is the identity for
  splines, whose parameters keep their meaning, and the map from [0,1] for Bernstein tensors, which live on the unit
  box.
  */
  MultivariateFunction restricted(int axis, const Number_type& begin, const Number_type& end) const;

  //! the functions on the two parts of the domain before and after `t`, as `restricted()` gives them.
  std::pair<MultivariateFunction, MultivariateFunction> split(int axis, const Number_type& t) const;
};
