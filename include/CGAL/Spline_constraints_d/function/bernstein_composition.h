// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_COMPOSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_COMPOSITION_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The part of `outer` whose coefficients from `first` on belong to the axes from `axis` on, composed with the inner
// functions of these axes.
template <class NT>
Bernstein_tensor<NT> composed_from(const Bernstein_tensor<NT>& outer, const std::vector<Bernstein_tensor<NT>>& inner,
                                   std::size_t axis, std::size_t first)
{
  const int dimension = inner[0].dimension();
  if (axis == inner.size())
    return Bernstein_tensor<NT>::constant(dimension, outer.coefficients()[first]);
  // Horner's scheme in Bernstein form: powers of g grow from the left while every step multiplies the sum by 1 - g.
  const int degree = outer.degrees()[axis];
  const std::size_t stride = tensor_strides(outer.degrees())[axis];
  const Bernstein_tensor<NT> complement = NT(1) - inner[axis];
  const std::vector<NT> binomial = binomials<NT>(degree);
  Bernstein_tensor<NT> power = Bernstein_tensor<NT>::constant(dimension, NT(1));
  Bernstein_tensor<NT> sum = composed_from(outer, inner, axis + 1, first);
  for (int k = 1; k <= degree; ++k) {
    power *= inner[axis];
    sum *= complement;
    sum += composed_from(outer, inner, axis + 1, first + k * stride) * power * binomial[k];
  }
  return sum;
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

returns the composition \f$v \mapsto f(g_0(v), g_1(v), \dots)\f$ of a tensor with one inner function per axis, all of
the same dimension: any polynomial substitution, affine changes of variables included. Its degree along axis \f$k\f$ is
\f$\sum_j d_j \deg_k g_j\f$. Exact where `NT` is.

\throws Invalid_input when the inner functions are of the wrong number or differ in dimension, or when `outer` has no
axes.
*/
template <class NT>
Bernstein_tensor<NT> compose(const Bernstein_tensor<NT>& outer, const std::vector<Bernstein_tensor<NT>>& inner)
{
  internal::check_count(inner.size(), outer.degrees().size(), "compose: inner functions");
  if (inner.empty())
    throw Invalid_input("compose: a function without axes cannot be composed");
  for (std::size_t j = 1; j < inner.size(); ++j)
    internal::check_count(inner[j].degrees().size(), inner[0].degrees().size(),
                          "compose: dimension of inner function " + std::to_string(j));
  return internal::composed_from(outer, inner, 0, 0);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_COMPOSITION_H
