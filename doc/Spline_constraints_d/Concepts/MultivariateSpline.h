// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `MultivariateSpline` describes a continuous piecewise polynomial on a box, closed under sum, product and
derivative. `Rational_function` takes its numerator and weight from a model of it.

Operations between two functions throw `Invalid_input` when their domains differ.

\cgalRefines{MultivariateFunction}
\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Bernstein_tensor<NT>}
\cgalHasModels{CGAL::Spline_constraints::Bspline_function<NT>}
\cgalHasModelsEnd
*/
class MultivariateSpline
{
public:
  //! sum.
  friend MultivariateSpline operator+(const MultivariateSpline& f, const MultivariateSpline& g);

  //! difference.
  friend MultivariateSpline operator-(const MultivariateSpline& f, const MultivariateSpline& g);

  //! product.
  friend MultivariateSpline operator*(const MultivariateSpline& f, const MultivariateSpline& g);

  //! product with a constant.
  friend MultivariateSpline operator*(const MultivariateSpline& f, const Number_type& factor);

  //! the negative.
  MultivariateSpline operator-() const;

  //! the partial derivative. \throws Invalid_input when it is not continuous.
  MultivariateSpline derivative(int axis) const;

  //! value and first derivatives at a point of the domain.
  Value_and_gradient<Number_type> value_and_gradient(std::span<const Number_type> u) const;

  //! the polynomials the function consists of, each on the unit box, in row-major order of the cells, the last axis
  //! fastest.
  std::vector<Bernstein_tensor<Number_type>> bezier_pieces() const;
};
