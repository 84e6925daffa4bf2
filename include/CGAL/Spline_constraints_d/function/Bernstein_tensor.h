// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_TENSOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_TENSOR_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/function/bernstein_kernels.h>
#include <CGAL/Spline_constraints_d/function/bernstein_product.h>
#include <CGAL/Spline_constraints_d/function/internal/axis_embedding.h>
#include <CGAL/Spline_constraints_d/function/internal/tensor_layers.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#endif

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A polynomial in any number of variables in Bernstein form on the unit box:
\f$f(u) = \sum_{k} b_k \prod_j B^{d_j}_{k_j}(u_j)\f$ with one degree \f$d_j\f$ per axis.

Coefficients are stored densely in row-major order, the last axis fastest. Zero axes are a constant. All operations are
exact when `NT` is; for `double` every coefficient carries the rounding errors of the formula stated at each operation,
in whatever rounding mode is set, and for an interval type results enclose. Operations do not look for overflow:
coefficients near the largest double may become infinite.

\tparam NT a field number type: a floating point type, `CGAL::Interval_nt<false>` under its protector, or an exact
rational.

\cgalModels{MultivariateFunction,MultivariateSpline}
*/
template <class NT>
class Bernstein_tensor
{
  static_assert(!std::is_integral_v<NT>,
                "Bernstein_tensor needs a field: integers cannot be divided by binomial coefficients");

  std::vector<int> m_degrees;
  std::vector<NT> m_coefficients;

  template <class Other>
  friend class Bernstein_tensor;

  // Results of operations: nothing left to check.
  struct Unchecked {};
  Bernstein_tensor(Unchecked, std::vector<int> degrees, std::vector<NT> coefficients)
    : m_degrees(std::move(degrees)), m_coefficients(std::move(coefficients))
  {}

public:
  //! the type of coefficients, parameters and values.
  using Number_type = NT;

  //! the constant zero without axes.
  Bernstein_tensor() : m_coefficients(1, NT(0)) {}

  /*!
  the tensor with the given degrees and \f$\prod_j (d_j + 1)\f$ coefficients, row-major, last axis fastest.
  \throws Invalid_input for a negative degree, a wrong number of coefficients, a coefficient that is not finite, or when
  the size overflows.
  */
  Bernstein_tensor(std::vector<int> degrees, std::vector<NT> coefficients)
    : m_degrees(std::move(degrees)), m_coefficients(std::move(coefficients))
  {
    const std::size_t size = internal::checked_tensor_size<NT>(m_degrees, "Bernstein_tensor");
    internal::check_count(m_coefficients.size(), size, "Bernstein_tensor: number of coefficients");
    internal::check_finite(m_coefficients, "Bernstein_tensor: coefficient");
  }

  //! the constant function on `dimension` axes, of degree 0 on each.
  //! \throws Invalid_input when `dimension` is negative or the value not finite.
  static Bernstein_tensor constant(int dimension, const NT& value)
  {
    check_dimension(dimension);
    return Bernstein_tensor(std::vector<int>(dimension, 0), {value});
  }

  //! the function \f$u \mapsto u_{axis}\f$, of degree 1 on that axis and 0 on the others.
  //! \throws Invalid_input when there is no such axis.
  static Bernstein_tensor coordinate(int dimension, int axis)
  {
    check_dimension(dimension);
    if (axis < 0 || axis >= dimension)
      throw Invalid_input("Bernstein_tensor: no axis " + std::to_string(axis) + " among " + std::to_string(dimension));
    std::vector<int> degrees(dimension, 0);
    degrees[axis] = 1;
    return Bernstein_tensor(Unchecked(), std::move(degrees), {NT(0), NT(1)});
  }

  /*!
  the polynomial \f$\sum_k a_k \prod_j u_j^{k_j}\f$ from its dense power coefficients, in the same order as Bernstein
  coefficients. Complexity: \f$O(N \sum_j d_j)\f$ for \f$N\f$ coefficients.
  \throws Invalid_input as the constructor.
  */
  static Bernstein_tensor from_power(std::vector<int> degrees, std::vector<NT> power_coefficients)
  {
    const std::vector<std::pair<NT, NT>> unit(degrees.size(), std::pair<NT, NT>(NT(0), NT(1)));
    return from_power_on_box(std::move(degrees), std::move(power_coefficients), unit);
  }

  /*!
  the polynomial \f$\sum_k a_k \prod_j x_j^{k_j}\f$ on the box of points \f$x_j = (1-u_j)\,\mathit{box}_j.\mathit{first}
  + u_j\,\mathit{box}_j.\mathit{second}\f$. A range may run backwards or be a single point.
  \throws Invalid_input as the constructor, and when the box has the wrong number of ranges or a bound that is not
  finite.
  */
  static Bernstein_tensor from_power_on_box(std::vector<int> degrees, std::vector<NT> power_coefficients,
                                            std::span<const std::pair<NT, NT>> box)
  {
    Bernstein_tensor result(std::move(degrees), std::move(power_coefficients));
    internal::check_count(box.size(), result.m_degrees.size(), "Bernstein_tensor: ranges of the box");
    for (std::size_t j = 0; j < box.size(); ++j) {
      if (!internal::is_finite_number(box[j].first) || !internal::is_finite_number(box[j].second))
        throw Invalid_input("Bernstein_tensor: range " + std::to_string(j) + " of the box is not finite");
      result.transform(j, internal::from_power_matrix(result.m_degrees[j], box[j].first, box[j].second));
    }
    return result;
  }

  //! number of axes.
  int dimension() const { return static_cast<int>(m_degrees.size()); }

  //! degree along an axis.
  int degree(int axis) const
  {
    CGAL_precondition(is_axis(axis));
    return m_degrees[axis];
  }

  //! all degrees.
  const std::vector<int>& degrees() const { return m_degrees; }

  //! the Bernstein coefficients, row-major, last axis fastest.
  const std::vector<NT>& coefficients() const& { return m_coefficients; }

  //! the same, moved out of a tensor that is not needed any more.
  std::vector<NT> coefficients() && { return std::move(m_coefficients); }

  //! the range of every parameter: [0,1].
  std::pair<NT, NT> domain(int axis) const
  {
    CGAL_precondition(is_axis(axis));
    CGAL_USE(axis);
    return {NT(0), NT(1)};
  }

  //! the polynomial itself, as the only piece of a spline.
  std::vector<Bernstein_tensor> bezier_pieces() const { return {*this}; }

  //! the coefficients in the powers of the parameters, in the same order. \sa from_power()
  std::vector<NT> power_coefficients() const
  {
    Bernstein_tensor result = *this;
    for (std::size_t j = 0; j < m_degrees.size(); ++j)
      result.transform(j, internal::to_power_matrix<NT>(m_degrees[j]));
    return std::move(result.m_coefficients);
  }

  /*!
  the value at a point, which may lie outside of the unit box.
  In `double` and inside the box the error is at most \f$\gamma_m \max|b|\f$ with \f$m = \sum_j (5 d_j + 2)\f$,
  \f$\gamma_m = m\epsilon/(1-m\epsilon)\f$ and
  \f$\epsilon = 2^{-52}\f$ (any rounding mode). Complexity: one multiplication per coefficient, \f$O(d_j^2)\f$ more per
  axis.
  \throws Invalid_input when the number of parameters differs from the dimension.
  */
  NT operator()(std::span<const NT> u) const { return internal::contracted_value(m_coefficients, weights(u, 0)); }

  //! value and first derivatives at a point. \throws Invalid_input as the evaluation.
  Value_and_gradient<NT> value_and_gradient(std::span<const NT> u) const
  {
    return internal::contracted_gradient(m_coefficients, weights(u, 1));
  }

  //! the symmetric matrix of second derivatives at a point, row by row. \throws Invalid_input as the evaluation.
  std::vector<NT> hessian(std::span<const NT> u) const
  {
    return internal::contracted_hessian(m_coefficients, weights(u, 2));
  }

  /*!
  least and largest coefficient: bounds of the function on the unit box, attained at its corners. Rounding of the
  coefficients themselves is not accounted for. For interval types the two numbers enclose the least and largest
  coefficient.
  */
  std::pair<NT, NT> bounds() const { return internal::least_and_greatest(m_coefficients); }

  //! bounds of the derivative along an axis on the unit box. \sa bounds()
  std::pair<NT, NT> derivative_bounds(int axis) const { return derivative(axis).bounds(); }

  //! the partial derivative: \f$d\f$ times the forward differences; of degree 0 on the axis when the degree is 0 or 1.
  Bernstein_tensor derivative(int axis) const
  {
    CGAL_precondition(is_axis(axis));
    if (m_degrees[axis] == 0)
      return Bernstein_tensor(Unchecked(), m_degrees, std::vector<NT>(m_coefficients.size(), NT(0)));
    std::vector<int> degrees = m_degrees;
    --degrees[axis];
    return Bernstein_tensor(Unchecked(), std::move(degrees),
                            internal::scaled_differences(m_coefficients, internal::axis_view(m_degrees, axis)));
  }

  /*!
  the same function with higher degrees.
  \throws Invalid_input when a degree is below the present one, their number differs from the dimension, or the size
  overflows.
  */
  Bernstein_tensor elevated(const std::vector<int>& degrees) const
  {
    internal::check_count(degrees.size(), m_degrees.size(), "Bernstein_tensor: degrees to elevate to");
    for (std::size_t j = 0; j < degrees.size(); ++j)
      if (degrees[j] < m_degrees[j])
        throw Invalid_input("Bernstein_tensor: degree " + std::to_string(m_degrees[j]) + " of axis " +
                            std::to_string(j) + " cannot be elevated to " + std::to_string(degrees[j]));
    internal::checked_tensor_size<NT>(degrees, "Bernstein_tensor");
    Bernstein_tensor result = *this;
    for (std::size_t j = 0; j < degrees.size(); ++j)
      if (degrees[j] > m_degrees[j])
        result.transform(j, internal::elevation_matrix<NT>(m_degrees[j], degrees[j]));
    return result;
  }

  /*!
  the part over \f$[t_0,t_1]\f$ along an axis, as a function on the unit box again: \f$u_{axis}\f$ becomes \f$(1-u)\,t_0
  + u\,t_1\f$. Both parameters may lie outside of [0,1], in any order. Divides nothing. Complexity: \f$O(N d + d^3)\f$.
  \throws Invalid_input when a parameter is not finite.
  */
  Bernstein_tensor restricted(int axis, const NT& t0, const NT& t1) const
  {
    CGAL_precondition(is_axis(axis));
    check_parameter(t0);
    check_parameter(t1);
    Bernstein_tensor result = *this;
    result.transform(axis, internal::restriction_matrix<NT>(m_degrees[axis], t0, t1));
    return result;
  }

  //! the part over a box, as a function on the unit box. \throws Invalid_input also when the number of ranges differs
  //! from the dimension.
  Bernstein_tensor restricted_to_box(std::span<const std::pair<NT, NT>> box) const
  {
    internal::check_count(box.size(), m_degrees.size(), "Bernstein_tensor: ranges of the box");
    Bernstein_tensor result = *this;
    for (std::size_t j = 0; j < box.size(); ++j)
      result = result.restricted(static_cast<int>(j), box[j].first, box[j].second);
    return result;
  }

  //! the function with `shift + scale * u` in place of \f$u_{axis}\f$. \throws Invalid_input when the substituted range
  //! is not finite.
  Bernstein_tensor substituted_affine(int axis, const NT& shift, const NT& scale) const
  {
    const NT end = shift + scale;
    return restricted(axis, shift, end);
  }

  /*!
  the parts before and after a parameter of an axis, each as a function on the unit box: the de Casteljau algorithm.
  In `double` and for \f$0 \le t \le 1\f$ each coefficient is off by at most \f$4 d \epsilon \max|b|\f$, \f$\epsilon =
  2^{-52}\f$.
  \throws Invalid_input when the parameter is not finite.
  */
  std::pair<Bernstein_tensor, Bernstein_tensor> split(int axis, const NT& t) const
  {
    CGAL_precondition(is_axis(axis));
    check_parameter(t);
    std::pair<Bernstein_tensor, Bernstein_tensor> parts(*this, *this);
    internal::split_at(parts.first.m_coefficients.data(), parts.second.m_coefficients.data(),
                       internal::axis_view(m_degrees, axis), t);
    return parts;
  }

  //! the same at one half, where each step is an addition and an exact halving.
  std::pair<Bernstein_tensor, Bernstein_tensor> split(int axis) const
  {
    CGAL_precondition(is_axis(axis));
    std::pair<Bernstein_tensor, Bernstein_tensor> parts(*this, *this);
    internal::split_at_one_half(parts.first.m_coefficients.data(), parts.second.m_coefficients.data(),
                                internal::axis_view(m_degrees, axis));
    return parts;
  }

  //! the restriction to \f$u_{axis} = 0\f$ (`side` 0) or \f$u_{axis} = 1\f$ (`side` 1), of one dimension less.
  Bernstein_tensor face(int axis, int side) const
  {
    CGAL_precondition(is_axis(axis) && (side == 0 || side == 1));
    std::vector<int> degrees = m_degrees;
    degrees.erase(degrees.begin() + axis);
    return Bernstein_tensor(Unchecked(), std::move(degrees),
                            internal::layer_of_tensor(m_coefficients, internal::axis_view(m_degrees, axis),
                                                      side == 0 ? 0 : m_degrees[axis]));
  }

  /*!
  the function of `dimension` parameters that depends on `axes` only: own axis `i` becomes axis `axes[i]`, the others
  get degree 0. With `dimension` unchanged this permutes the axes.
  \throws Invalid_input when an axis is missing, repeated, or not below `dimension`.
  */
  Bernstein_tensor embedded(int dimension, const std::vector<int>& axes) const
  {
    check_dimension(dimension);
    std::vector<int> degrees = internal::embedded_degrees(m_degrees, dimension, axes);
    std::vector<NT> coefficients = internal::embedded_coefficients(m_coefficients, m_degrees, degrees, axes);
    return Bernstein_tensor(Unchecked(), std::move(degrees), std::move(coefficients));
  }

  //! the tensor whose coefficients are the images of these ones. \throws Invalid_input when an image is not finite.
  template <class Target, class Conversion>
  Bernstein_tensor<Target> converted(const Conversion& conversion) const
  {
    std::vector<Target> coefficients;
    coefficients.reserve(m_coefficients.size());
    for (const NT& coefficient : m_coefficients)
      coefficients.push_back(conversion(coefficient));
    return Bernstein_tensor<Target>(m_degrees, std::move(coefficients));
  }

  //! sum; lower degrees are elevated. \throws Invalid_input when the dimensions differ.
  Bernstein_tensor& operator+=(const Bernstein_tensor& other)
  {
    return combine(other, [](NT& a, const NT& b) { a += b; });
  }

  //! difference; lower degrees are elevated. \throws Invalid_input when the dimensions differ.
  Bernstein_tensor& operator-=(const Bernstein_tensor& other)
  {
    return combine(other, [](NT& a, const NT& b) { a -= b; });
  }

  /*!
  product; degrees add up. One multiplication per pair of coefficients for inexact types; fractions are multiplied as
  integers over a common denominator. In `double` each coefficient is off by at most \f$\gamma_m \max|a| \max|b|\f$,
  \f$m = T + 6 s\f$, where \f$s\f$ is the number of axes on which both factors have positive degree and \f$T\f$ the
  product of the smaller degrees plus 1 (degrees up to 56).
  \throws Invalid_input when the dimensions differ, the size overflows, or binomial coefficients overflow an inexact
  number type.
  */
  Bernstein_tensor& operator*=(const Bernstein_tensor& other)
  {
    check_same_dimension(other);
    std::vector<int> degrees = m_degrees;
    for (std::size_t j = 0; j < degrees.size(); ++j) {
      if (degrees[j] > (std::numeric_limits<int>::max)() - other.m_degrees[j])
        throw Invalid_input("Bernstein_tensor: the degree of a product overflows at axis " + std::to_string(j));
      degrees[j] += other.m_degrees[j];
    }
    internal::checked_tensor_size<NT>(degrees, "Bernstein_tensor");
    m_coefficients = internal::bernstein_product(m_degrees, m_coefficients, other.m_degrees, other.m_coefficients);
    m_degrees = std::move(degrees);
    return *this;
  }

  //! adds a constant. Constants come by value since they may be one of the coefficients.
  Bernstein_tensor& operator+=(NT value) { return apply([&](NT& x) { x += value; }); }

  //! subtracts a constant.
  Bernstein_tensor& operator-=(NT value) { return apply([&](NT& x) { x -= value; }); }

  //! multiplies by a constant.
  Bernstein_tensor& operator*=(NT factor) { return apply([&](NT& x) { x *= factor; }); }

  friend Bernstein_tensor operator+(Bernstein_tensor a, const Bernstein_tensor& b) { return std::move(a += b); }
  friend Bernstein_tensor operator-(Bernstein_tensor a, const Bernstein_tensor& b) { return std::move(a -= b); }
  friend Bernstein_tensor operator*(Bernstein_tensor a, const Bernstein_tensor& b) { return std::move(a *= b); }
  friend Bernstein_tensor operator+(Bernstein_tensor a, const NT& b) { return std::move(a += b); }
  friend Bernstein_tensor operator-(Bernstein_tensor a, const NT& b) { return std::move(a -= b); }
  friend Bernstein_tensor operator*(Bernstein_tensor a, const NT& b) { return std::move(a *= b); }
  friend Bernstein_tensor operator+(const NT& a, Bernstein_tensor b) { return std::move(b += a); }
  friend Bernstein_tensor operator-(const NT& a, const Bernstein_tensor& b) { return -b + a; }
  friend Bernstein_tensor operator*(const NT& a, Bernstein_tensor b) { return std::move(b *= a); }

  //! the negative.
  Bernstein_tensor operator-() const
  {
    Bernstein_tensor result = *this;
    return std::move(result.apply([](NT& x) { x = -x; }));
  }

  //! whether two tensors are the same polynomial: equal coefficients once both have the common degrees. Decides only
  //! where `NT` is exact.
  friend bool operator==(const Bernstein_tensor& a, const Bernstein_tensor& b)
    requires internal::Totally_comparable<NT>
  {
    if (a.m_degrees == b.m_degrees)
      return a.m_coefficients == b.m_coefficients;
    if (a.m_degrees.size() != b.m_degrees.size())
      return false;
    const std::vector<int> degrees = common_degrees(a, b);
    return a.elevated(degrees).m_coefficients == b.elevated(degrees).m_coefficients;
  }

private:
  bool is_axis(int axis) const { return 0 <= axis && axis < dimension(); }

  static void check_dimension(int dimension)
  {
    if (dimension < 0)
      throw Invalid_input("Bernstein_tensor: negative dimension " + std::to_string(dimension));
  }

  static void check_parameter(const NT& t)
  {
    if (!internal::is_finite_number(t))
      throw Invalid_input("Bernstein_tensor: a parameter to cut at is not finite");
  }

  void check_same_dimension(const Bernstein_tensor& other) const
  {
    internal::check_count(other.m_degrees.size(), m_degrees.size(),
                          "Bernstein_tensor: dimension of the second operand");
  }

  static std::vector<int> common_degrees(const Bernstein_tensor& a, const Bernstein_tensor& b)
  {
    std::vector<int> degrees = a.m_degrees;
    for (std::size_t j = 0; j < degrees.size(); ++j)
      degrees[j] = (std::max)(degrees[j], b.m_degrees[j]);
    return degrees;
  }

  template <class Change>
  Bernstein_tensor& apply(const Change& change)
  {
    std::for_each(m_coefficients.begin(), m_coefficients.end(), change);
    return *this;
  }

  void transform(std::size_t axis, const internal::Row_matrix<NT>& matrix)
  {
    m_coefficients = internal::transform_axis(m_coefficients, internal::axis_view(m_degrees, axis), matrix);
    m_degrees[axis] = static_cast<int>(matrix.rows) - 1;
  }

  internal::Contraction_weights<NT> weights(std::span<const NT> u, int order) const
  {
    internal::check_count(u.size(), m_degrees.size(), "Bernstein_tensor: parameters of a point");
    internal::Contraction_weights<NT> result;
    for (std::size_t j = 0; j < u.size(); ++j)
      result.push_back(internal::bernstein_derivatives(m_degrees[j], u[j], order));
    return result;
  }

  template <class Combination>
  Bernstein_tensor& combine(const Bernstein_tensor& other, const Combination& combination)
  {
    check_same_dimension(other);
    if (m_degrees != other.m_degrees) {
      const std::vector<int> degrees = common_degrees(*this, other);
      const Bernstein_tensor elevated_other = other.elevated(degrees);
      *this = elevated(degrees);
      return combine(elevated_other, combination);
    }
    for (std::size_t i = 0; i < m_coefficients.size(); ++i)
      combination(m_coefficients[i], other.m_coefficients[i]);
    return *this;
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template class Bernstein_tensor<double>;
extern template class Bernstein_tensor<Exact_rational>;
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_TENSOR_H
