// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONCEPTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONCEPTS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>

#include <concepts>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link MultivariateFunction `MultivariateFunction`\endlink: a function on
a box that can be evaluated, bounded with its derivatives, split and restricted.
*/
template <class Function>
concept MultivariateFunction = std::copyable<Function> &&
    requires(const Function& function, int axis, const typename Function::Number_type& t,
             std::span<const typename Function::Number_type> u)
{
  {
    function.dimension()
    } -> std::convertible_to<int>;
  {
    function.domain(axis)
    } -> std::same_as<std::pair<typename Function::Number_type, typename Function::Number_type>>;
  {
    function(u)
    } -> std::same_as<typename Function::Number_type>;
  {
    function.bounds()
    } -> std::same_as<std::pair<typename Function::Number_type, typename Function::Number_type>>;
  {
    function.derivative_bounds(axis)
    } -> std::same_as<std::pair<typename Function::Number_type, typename Function::Number_type>>;
  {
    function.split(axis, t)
    } -> std::same_as<std::pair<Function, Function>>;
  {
    function.restricted(axis, t, t)
    } -> std::same_as<Function>;
};

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link MultivariateSpline `MultivariateSpline`\endlink: a
`MultivariateFunction` that consists of polynomial pieces and can be added, multiplied and differentiated within its own
type.
*/
template <class Function>
concept MultivariateSpline = MultivariateFunction<Function> &&
    requires(const Function& f, int axis, const typename Function::Number_type& t,
             std::span<const typename Function::Number_type> u)
{
  {
    f + f
    } -> std::same_as<Function>;
  {
    f - f
    } -> std::same_as<Function>;
  {
    f* f
    } -> std::same_as<Function>;
  {
    f* t
    } -> std::same_as<Function>;
  {
    -f
    } -> std::same_as<Function>;
  {
    f.derivative(axis)
    } -> std::same_as<Function>;
  {
    f.value_and_gradient(u)
    } -> std::same_as<Value_and_gradient<typename Function::Number_type>>;
  {
    f.bezier_pieces()
    } -> std::same_as<std::vector<Bernstein_tensor<typename Function::Number_type>>>;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONCEPTS_H
