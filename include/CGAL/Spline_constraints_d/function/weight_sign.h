// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_WEIGHT_SIGN_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_WEIGHT_SIGN_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

How far a weight is subdivided to prove its sign before it is rejected.
*/
struct Weight_options
{
  //! number of halvings of one piece.
  int maximal_depth = 60;
  //! number of parts looked at.
  std::size_t maximal_parts = 20000;
};

namespace internal {

template <class NT>
CGAL::Uncertain<CGAL::Sign> sign_of_number(const NT& x)
{
  if constexpr (Totally_comparable<NT>)
    return x < NT(0) ? CGAL::NEGATIVE : NT(0) < x ? CGAL::POSITIVE : CGAL::ZERO;
  else
    return Number_traits<NT>::sign(x);
}

template <class NT>
bool certainly_has_sign(const NT& x, CGAL::Sign sign)
{
  const CGAL::Uncertain<CGAL::Sign> possible = sign_of_number(x);
  return possible.is_certain() && possible.make_certain() == sign;
}

// +1 or -1 when all coefficients certainly have this sign, else 0.
template <class NT>
int common_sign(const std::pair<NT, NT>& bounds)
{
  return certainly_has_sign(bounds.first, CGAL::POSITIVE) ? 1
      : certainly_has_sign(bounds.second, CGAL::NEGATIVE) ? -1
                                                          : 0;
}

// Throws when a corner of the tensor, where coefficients are values, certainly does not have the sign; sign 0 takes
// that of the first corner that has one.
template <class NT>
void check_corners(const Bernstein_tensor<NT>& weight, int& sign)
{
  const std::vector<std::size_t> strides = tensor_strides(weight.degrees());
  const std::vector<int> sides(weight.degrees().size(), 1);
  for_each_index(sides, [&](const std::vector<int>& side) {
    std::size_t position = 0;
    for (std::size_t j = 0; j < side.size(); ++j)
      position += strides[j] * static_cast<std::size_t>(side[j] * weight.degrees()[j]);
    const NT& value = weight.coefficients()[position];
    const int here = common_sign<NT>({value, value});
    if (here == 0 && certainly_has_sign(value, CGAL::ZERO))
      throw Invalid_input("Rational_function: the weight is zero at a point of the domain");
    if (here * sign < 0)
      throw Invalid_input("Rational_function: the weight has both signs");
    sign = here != 0 ? here : sign;
  });
}

/*
Proves that a weight has one sign and hands `visit(numerator, weight)` parts that cover everything, on each of which all
coefficients of the weight have this sign. The sign is returned; without proof within the limits Invalid_input is
thrown.
*/
template <class NT, class Visit>
int for_each_part_of_one_sign(const std::vector<Bernstein_tensor<NT>>& numerators,
                              const std::vector<Bernstein_tensor<NT>>& weights, const Weight_options& options,
                              const Visit& visit)
{
  struct Part
  {
    Bernstein_tensor<NT> numerator, weight;
    int depth;
  };
  int sign = 0;
  std::size_t parts = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    std::vector<Part> open{{numerators[c], weights[c], 0}};
    while (!open.empty()) {
      const Part part = std::move(open.back());
      open.pop_back();
      check_corners(part.weight, sign);
      const int here = common_sign(part.weight.bounds());
      if (here != 0) {
        visit(part.numerator, part.weight);
        continue;
      }
      // Halve the axes in turn, those along which the weight varies.
      const int dimension = part.weight.dimension();
      int axis = 0;
      for (int k = 0; k < dimension; ++k) {
        axis = (part.depth + k) % dimension;
        if (part.weight.degree(axis) > 0)
          break;
      }
      if (dimension == 0 || part.weight.degree(axis) == 0 || part.depth >= options.maximal_depth ||
          ++parts > options.maximal_parts)
        throw Invalid_input(
            "Rational_function: the sign of the weight could not be proved (it is zero or close to zero in piece " +
            std::to_string(c) + ")");
      auto [first_numerator, second_numerator] = part.numerator.split(axis);
      auto [first_weight, second_weight] = part.weight.split(axis);
      open.push_back({std::move(second_numerator), std::move(second_weight), part.depth + 1});
      open.push_back({std::move(first_numerator), std::move(first_weight), part.depth + 1});
    }
  }
  return sign;
}

// The Bézier pieces of a spline, exact when its number type is a floating point type: each double is a rational number.
template <class Function>
auto exact_pieces(const Function& function)
{
  using NT = typename Function::Number_type;
  if constexpr (std::is_floating_point_v<NT>)
    return function.template converted<Exact_rational>([](const NT& x) { return Exact_rational(x); }).bezier_pieces();
  else
    return function.bezier_pieces();
}

// The sign of a weight, proved. Throws Invalid_input when it vanishes, has both signs, or the proof goes beyond the
// limits.
template <class Function>
int certified_weight_sign(const Function& weight, const Weight_options& options)
{
  if (const int sign = common_sign(weight.bounds()))
    return sign;
  const auto pieces = exact_pieces(weight);
  return for_each_part_of_one_sign(pieces, pieces, options, [](const auto&, const auto&) {});
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_WEIGHT_SIGN_H
