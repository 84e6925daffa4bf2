// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_FUNCTION_H

#include <CGAL/Spline_constraints_d/function/Value_and_gradient.h>
#include <CGAL/Spline_constraints_d/function/concepts.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A quotient \f$n/w\f$ of two polynomials or splines on the same domain, the numerator and the weight.

Operations form numerator and weight separately and never divide, so that they are exact where the number type is.
Nothing is cancelled; operands with the same weight keep it. A weight may take any sign and even vanish until
`certify_positive_weight()` has been called: the solver, which looks at numerators only, may do so only on certified
functions.

\tparam Function a `MultivariateSpline`: `Bernstein_tensor` or `Bspline_function`.

\cgalModels{MultivariateFunction}
*/
template <MultivariateSpline Function>
class Rational_function
{
public:
  //! the type of parameters and values.
  using Number_type = typename Function::Number_type;

private:
  using NT = Number_type;

  Function m_numerator;
  Function m_weight;

public:
  /*!
  the function `numerator / weight`.
  \throws Invalid_input when the domains differ or all coefficients of the weight are zero.
  */
  Rational_function(Function numerator, Function weight)
    : m_numerator(std::move(numerator)), m_weight(std::move(weight))
  {
    if (m_numerator.dimension() != m_weight.dimension())
      throw Invalid_input("Rational_function: numerator and weight have different dimensions, " +
                          std::to_string(m_numerator.dimension()) + " and " + std::to_string(m_weight.dimension()));
    for (int j = 0; j < m_weight.dimension(); ++j) {
      const std::pair<NT, NT> a = m_numerator.domain(j), b = m_weight.domain(j);
      if (are_certainly_different(a.first, b.first) || are_certainly_different(a.second, b.second))
        throw Invalid_input("Rational_function: numerator and weight have different domains on axis " +
                            std::to_string(j));
    }
    if (vanishes(m_weight))
      throw Invalid_input("Rational_function: the weight is zero everywhere");
  }

  //! the numerator.
  const Function& numerator() const { return m_numerator; }

  //! the weight.
  const Function& weight() const { return m_weight; }

  //! number of axes.
  int dimension() const { return m_weight.dimension(); }

  //! the range of the parameter of an axis.
  std::pair<NT, NT> domain(int axis) const { return m_weight.domain(axis); }

  /*!
  proves that the weight has one sign on the whole domain, and makes it the positive one by negating numerator and
  weight where needed.

  The proof is that all Bernstein coefficients have this sign, on parts of the domain found by halving. It concerns the
  weight as stored: for `double` it is made in exact arithmetic, for interval types it holds for all functions enclosed.
  \throws Invalid_input when the weight is zero somewhere, has both signs, or comes so close to zero that the limits of
  `options` do not suffice.
  */
  void certify_positive_weight(const Weight_options& options = {})
  {
    if (internal::certified_weight_sign(m_weight, options) < 0) {
      m_numerator = -m_numerator;
      m_weight = -m_weight;
    }
  }

  //! the value at a point. \throws Invalid_input when the weight is zero there, or as the evaluation of numerator and
  //! weight.
  NT operator()(std::span<const NT> u) const
  {
    const NT below = m_weight(u);
    check_value(below);
    return m_numerator(u) / below;
  }

  //! value and first derivatives at a point. \throws Invalid_input as the evaluation.
  Value_and_gradient<NT> value_and_gradient(std::span<const NT> u) const
  {
    Value_and_gradient<NT> result = m_numerator.value_and_gradient(u);
    const Value_and_gradient<NT> below = m_weight.value_and_gradient(u);
    check_value(below.value);
    result.value = NT(result.value) / below.value;
    for (std::size_t j = 0; j < result.gradient.size(); ++j)
      result.gradient[j] = NT(result.gradient[j] - NT(result.value * below.gradient[j])) / below.value;
    return result;
  }

  /*!
  bounds of the function on its domain: where the coefficients of the weight have one sign, the values lie between the
  least and the largest quotient of coefficients of equal degrees; elsewhere the domain is halved until they have.
  Rounding is not accounted for.
  \throws Invalid_input as `certify_positive_weight()`.
  */
  std::pair<NT, NT> bounds(const Weight_options& options = {}) const
  {
    const auto [above, below] = matching_pieces();
    std::vector<NT> quotients;
    internal::for_each_part_of_one_sign(above, below, options, [&](const auto& numerator, const auto& weight) {
      for (std::size_t i = 0; i < weight.coefficients().size(); ++i)
        quotients.push_back(numerator.coefficients()[i] / weight.coefficients()[i]);
      const std::pair<NT, NT> hull = internal::least_and_greatest(quotients);
      quotients = {hull.first, hull.second};
    });
    return {quotients[0], quotients[1]};
  }

  //! bounds of the derivative along an axis. \throws Invalid_input as `bounds()` and `derivative()`.
  std::pair<NT, NT> derivative_bounds(int axis) const { return derivative(axis).bounds(); }

  /*!
  the partial derivative \f$(n' w - n w') / w^2\f$, or \f$n'/w\f$ when the weight does not depend on the axis.
  \throws Invalid_input when the derivative of numerator or weight is not continuous.
  */
  Rational_function derivative(int axis) const
  {
    const Function weight_derivative = m_weight.derivative(axis);
    if (vanishes(weight_derivative))
      return Rational_function(m_numerator.derivative(axis), m_weight);
    return Rational_function(m_numerator.derivative(axis) * m_weight - m_numerator * weight_derivative,
                             m_weight * m_weight);
  }

  //! the function on a part of its domain, as numerator and weight do it.
  Rational_function restricted(int axis, const NT& begin, const NT& end) const
  {
    return Rational_function(m_numerator.restricted(axis, begin, end), m_weight.restricted(axis, begin, end));
  }

  //! the parts before and after a parameter of an axis.
  std::pair<Rational_function, Rational_function> split(int axis, const NT& t) const
  {
    auto above = m_numerator.split(axis, t);
    auto below = m_weight.split(axis, t);
    return {Rational_function(std::move(above.first), std::move(below.first)),
            Rational_function(std::move(above.second), std::move(below.second))};
  }

  //! sum. \throws Invalid_input when the domains differ.
  friend Rational_function operator+(const Rational_function& a, const Rational_function& b)
  {
    if (have_equal_weights(a, b))
      return Rational_function(a.m_numerator + b.m_numerator, a.m_weight);
    return Rational_function(a.m_numerator * b.m_weight + b.m_numerator * a.m_weight, a.m_weight * b.m_weight);
  }

  //! difference. \throws Invalid_input when the domains differ.
  friend Rational_function operator-(const Rational_function& a, const Rational_function& b) { return a + (-b); }

  //! product. \throws Invalid_input when the domains differ.
  friend Rational_function operator*(const Rational_function& a, const Rational_function& b)
  {
    return Rational_function(a.m_numerator * b.m_numerator, a.m_weight * b.m_weight);
  }

  //! quotient; the numerator of `b` becomes part of the weight. \throws Invalid_input when it is zero everywhere or the
  //! domains differ.
  friend Rational_function operator/(const Rational_function& a, const Rational_function& b)
  {
    if (have_equal_weights(a, b))
      return Rational_function(a.m_numerator, b.m_numerator);
    return Rational_function(a.m_numerator * b.m_weight, a.m_weight * b.m_numerator);
  }

  //! the negative.
  Rational_function operator-() const { return Rational_function(-m_numerator, m_weight); }

private:
  static bool are_certainly_different(const NT& a, const NT& b)
  {
    const NT difference = a - b;
    return internal::certainly_has_sign(difference, CGAL::POSITIVE) ||
        internal::certainly_has_sign(difference, CGAL::NEGATIVE);
  }

  static void check_value(const NT& weight)
  {
    if (internal::is_known_zero(weight))
      throw Invalid_input("Rational_function: the weight is zero at the point of evaluation");
  }

  // Whether all coefficients are zero.
  static bool vanishes(const Function& function)
  {
    const std::pair<NT, NT> bounds = function.bounds();
    return internal::is_known_zero(bounds.first) && internal::is_known_zero(bounds.second);
  }

  static bool have_equal_weights(const Rational_function& a, const Rational_function& b)
  {
    if constexpr (std::equality_comparable<Function>)
      return a.m_weight == b.m_weight;
    else
      return false;
  }

  // Bézier pieces of numerator and weight on the same cells and of the same degrees: adding zero times the other brings
  // degrees and breaks together.
  std::pair<std::vector<Bernstein_tensor<NT>>, std::vector<Bernstein_tensor<NT>>> matching_pieces() const
  {
    const Function nothing = m_weight * NT(0) + m_numerator * NT(0);
    return {(m_numerator + nothing).bezier_pieces(), (m_weight + nothing).bezier_pieces()};
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_FUNCTION_H
