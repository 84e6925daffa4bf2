// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_LOCAL_WEIGHTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_LOCAL_WEIGHTS_H

#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#endif

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Which control points of a spline matter at a point, and their weights in the value and all derivatives up to an order.
The splines on the same knots share them. Exact weights are integers, and so are then the control points, over common
denominators.
*/
template <class NT>
class Local_weights
{
  using Number = std::conditional_t<is_exact_rational<NT>, Short_integer, NT>;

  std::vector<int> m_lower, m_degrees, m_extents;
  Contraction_weights<Number> m_weights;
  Number m_denominator = Number(1);           // of all exact weights
  Short_integer m_denominator_of_axis = 1;   // of the axis added last

public:
  //! \throws Invalid_input when the point is of the wrong dimension or outside of the domain; `who` begins the message.
  Local_weights(const std::vector<Knot_axis<NT>>& axes, std::span<const NT> u, int order, std::string_view who)
    : m_weights(u.size())
  {
    if (u.size() != axes.size())
      check_count(u.size(), axes.size(), std::string(who) + "parameters of a point");
    for (std::vector<int>* numbers : {&m_lower, &m_degrees, &m_extents})
      numbers->reserve(u.size());
    for (std::size_t j = 0; j < u.size(); ++j) {
      if (!(axes[j].begin() <= u[j] && u[j] <= axes[j].end()))
        throw Invalid_input(std::string(who) + "parameter " + std::to_string(j) + " is outside of the domain");
      m_extents.push_back(static_cast<int>(axes[j].size()) - 1);
      if (const bool is_at_begin = u[j] == axes[j].begin();
          order == 0 && (is_at_begin || u[j] == axes[j].end()) && axes[j].is_clamped())
        add_control_point(m_weights[j], is_at_begin ? 0 : m_extents.back());
      else
        add_span(m_weights[j], axes[j], u[j], order);
    }
  }

  NT value(const std::vector<NT>& control_points) const
  {
    if constexpr (!is_exact_rational<NT>)
      if (is_single_piece())
        return contracted_value(control_points, m_weights);
    const auto [data, denominator] = numbers(control_points);
    return quotient_of(contracted_value(data, m_weights), denominator);
  }

  Value_and_gradient<NT> value_and_gradient(const std::vector<NT>& control_points) const
  {
    const auto [data, denominator] = numbers(control_points);
    const Value_and_gradient<Number> result = contracted_gradient(data, m_weights);
    return {quotient_of(result.value, denominator), quotients_of(result.gradient, denominator)};
  }

  std::vector<NT> hessian(const std::vector<NT>& control_points) const
  {
    const auto [data, denominator] = numbers(control_points);
    return quotients_of(contracted_hessian(data, m_weights), denominator);
  }

  // Calls report(orders, value) for all derivatives up to an order.
  template <class Report>
  void derivatives(const std::vector<NT>& control_points, int order, const Report& report) const
  {
    const auto [data, denominator] = numbers(control_points);
    std::vector<int> orders;
    contract(data.data(), data.size(), m_weights, order, orders,
             [&, &divisor = denominator](const std::vector<int>& derivative, const Number& value) {
               report(derivative, quotient_of(value, divisor));
             });
  }

private:
  // At an end of clamped knots, where the value is that of a control point.
  void add_control_point(std::vector<std::vector<Number>>& weights, int index)
  {
    m_lower.push_back(index);
    m_degrees.push_back(0);
    weights.push_back({Number(1)});
  }

  void add_span(std::vector<std::vector<Number>>& weights, const Knot_axis<NT>& axis, const NT& u, int order)
  {
    const std::size_t span = span_of(axis, u);
    m_lower.push_back(static_cast<int>(span) - axis.degree);
    m_degrees.push_back(axis.degree);
    for (int r = 0; r <= order; ++r)
      add_weights(weights, derivative_weights(axis, span, u, r));
  }

  static void add_weights(std::vector<std::vector<NT>>& all, std::vector<NT> weights)
  {
    all.push_back(std::move(weights));
  }

  // All orders over the denominator of the first one, which those of the others divide.
  void add_weights(std::vector<std::vector<Short_integer>>& all, Integer_weights weights)
    requires is_exact_rational<NT>
  {
    if (all.empty())
      m_denominator *= m_denominator_of_axis = weights.denominator;
    else if (const Short_integer factor = m_denominator_of_axis / weights.denominator; factor != 1)
      for (Short_integer& weight : weights.numerators)
        weight *= factor;
    all.push_back(std::move(weights.numerators));
  }

  bool is_single_piece() const { return m_extents == m_degrees; }

  // The control points that matter, and what to divide results by.
  std::pair<std::vector<Number>, Number> numbers(const std::vector<NT>& control_points) const
  {
    std::vector<NT> block;
    if (!is_single_piece())
      block = tensor_block(control_points, m_extents, m_lower, m_degrees);
    if constexpr (is_exact_rational<NT>) {
      std::vector<Short_integer> numerators;
      const Short_integer denominator = over_common_denominator(is_single_piece() ? control_points : block, numerators);
      return {std::move(numerators), denominator * m_denominator};
    } else
      return {is_single_piece() ? control_points : std::move(block), m_denominator};
  }

  static NT quotient_of(const Number& value, [[maybe_unused]] const Number& denominator)
  {
    if constexpr (is_exact_rational<NT>) {
      NT result;
      set_quotient(result, value, denominator);
      return result;
    } else
      return value;
  }

  static std::vector<NT> quotients_of(const std::vector<Number>& values, const Number& denominator)
  {
    std::vector<NT> result;
    for (const Number& value : values)
      result.push_back(quotient_of(value, denominator));
    return result;
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template class Local_weights<double>;
extern template class Local_weights<Exact_rational>;
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_LOCAL_WEIGHTS_H
