// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_JET_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_JET_H

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The value of a function of one variable with its first three derivatives. Evaluating a formula on such numbers
// differentiates it along a curve, by the product rule.
template <class NT>
struct Jet
{
  NT value, first, second, third;

  Jet(NT value, NT first, NT second) : Jet(std::move(value), std::move(first), std::move(second), number(0)) {}
  Jet(NT value, NT first, NT second, NT third)
    : value(std::move(value)), first(std::move(first)), second(std::move(second)), third(std::move(third))
  {}
  explicit Jet(const Exact_rational& constant) : Jet(number(constant), number(0), number(0)) {}

  Jet& operator+=(const Jet& other) { return *this = *this + other; }
  Jet& operator*=(const Jet& other) { return *this = *this * other; }

  friend Jet operator+(const Jet& f, const Jet& g)
  {
    return {f.value + g.value, f.first + g.first, f.second + g.second, f.third + g.third};
  }

  friend Jet operator*(const Jet& f, const Jet& g)
  {
    const NT mixed = f.first * g.first, higher = f.second * g.first + f.first * g.second;
    return {f.value * g.value, f.first * g.value + f.value * g.first,
            f.second * g.value + mixed + mixed + f.value * g.second,
            f.third * g.value + higher + higher + higher + f.value * g.third};
  }

  // From f = q g.
  friend Jet operator/(const Jet& f, const Jet& g)
  {
    const NT value = f.value / g.value, first = (f.first - value * g.first) / g.value, mixed = first * g.first,
             second = (f.second - mixed - mixed - value * g.second) / g.value,
             higher = second * g.first + first * g.second;
    return {value, first, second, (f.third - higher - higher - higher - value * g.third) / g.value};
  }

private:
  static NT number(const Exact_rational& x) { return Number_traits<NT>::from_rational(x); }
};

// The value of a spline, on the piece that a place is in.
template <class NT>
NT spline_value(const Spline_function& function, std::span<const Exact_rational> place, std::span<const NT> point)
{
  NT result(Exact_rational(0));
  for (const Spline_term& term : function.terms()) {
    std::size_t piece = 0;
    std::vector<NT> own;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      piece = piece * term.cells(j) + cell_at(term.breaks[j], place[term.variables[j]]);
      own.push_back(point[term.variables[j]]);
    }
    result += tensor_value(term.pieces[piece], term.degrees, std::span<const NT>(own));
  }
  return result;
}

// The value of a formula, with the pieces of splines that a place is in.
template <class NT>
NT expression_value(const Expression& formula, std::span<const Exact_rational> place, std::span<const NT> point)
{
  if (formula.symbols() == nullptr)
    return NT(formula.numerator().constant_term());
  const NT numerator = formula.symbols()->value(formula.numerator(), place, point);
  return formula.denominator().powers.empty()
      ? numerator
      : numerator / formula.symbols()->value(polynomial_of(formula.denominator()), place, point);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_JET_H
