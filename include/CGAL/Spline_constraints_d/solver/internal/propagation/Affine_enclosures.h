// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_AFFINE_ENCLOSURES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_AFFINE_ENCLOSURES_H

#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Equation_block.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A number and its multiplier in a sum.
using Weighted_index = std::pair<int, double>;

/*
Sums of multiples of equalities on a box, as affine functions with an interval that they differ by, or by their
derivatives on the box. Multiples of the same monomial are added up before anything is bounded: what cancels is not lost
(affine arithmetic of Comba and Stolfi, in which the monomials are the noise symbols).
*/
class Affine_enclosures
{
  // A power of an offset is the slope times it and some number of the rest.
  struct Power_enclosure
  {
    Interval slope, rest;
  };

  // A function of an unknown: at the centre, the slope and the rest for the box, and the derivative on it.
  struct Function_enclosure
  {
    Interval value, slope, rest, derivative;
  };

  const Sparse_system& m_system;
  std::vector<double> m_centre;
  std::vector<Interval> m_offset;                    // of the box from the centre
  std::vector<Interval> m_values, m_rests, m_slopes; // of monomials; slopes by their factors
  std::vector<std::size_t> m_first_power;            // of an unknown
  std::vector<Power_enclosure> m_powers;             // of an unknown, from the first one on, as the following
  std::vector<Interval> m_sums;                      // of coefficients: of powers of an unknown, from the first one on
  std::vector<Interval> m_monomial_sums, m_linear;
  std::vector<char> m_has_monomial, m_has_unknown, m_has_powers;
  std::vector<int> m_monomials, m_unknowns; // that occur in the sum
  std::vector<int> m_with_powers;
  std::vector<Function_enclosure> m_functions;
  std::vector<Interval> m_function_sums;
  std::vector<char> m_has_function;
  std::vector<int> m_with_functions;
  Interval m_constant, m_rest;
  Univariate_interval_polynomial m_polynomial;

public:
  explicit Affine_enclosures(const Sparse_system& system);

  // What follows is on this box, and of these equalities.
  void set_box(const Box_of_ranges& box, const Equation_block& block);

  double centre(int unknown) const { return m_centre[unknown]; }
  // Of the box from its centre; may be narrowed.
  Interval& offset(int unknown) { return m_offset[unknown]; }

  // The slope at the centre and the width of the rest of one equality, both as they come: calls visit(unknown, slope),
  // then returns half of the width.
  template <class Visitor>
  double visit_slopes(int constraint, const Visitor& visit)
  {
    form_sum(std::span<const Weighted_index>(), constraint);
    enclose_affinely();
    for (const int j : m_unknowns)
      visit(j, middle(m_linear[j]));
    return 0.5 * width(m_rest);
  }

  // Makes the sum of multiples of constraints affine: it is constant() + sum of slope(j) times offset of j + rest().
  void set_sum(std::span<const Weighted_index> multiples)
  {
    form_sum(multiples, -1);
    enclose_affinely();
  }

  // The same with slopes that enclose those on all of the box, and no rest.
  void set_sum_of_derivatives(std::span<const Weighted_index> multiples, const Box_of_ranges& box)
  {
    form_sum(multiples, -1);
    enclose_derivatives(box);
  }

  const std::vector<int>& unknowns() const { return m_unknowns; }
  const Interval& slope(int unknown) const { return m_linear[unknown]; }
  // At the centre.
  const Interval& constant() const { return m_constant; }
  const Interval& rest() const { return m_rest; }

private:
  void form_sum(std::span<const Weighted_index> multiples, int single);
  void add_multiple(int constraint, double factor);
  void enclose_affinely();
  void enclose_powers(int unknown);
  void enclose_function(int function, const Box_of_ranges& box);
  void enclose_derivatives(const Box_of_ranges& box);

  void add_slope(int unknown, const Interval& slope)
  {
    if (m_has_unknown[unknown] == 0) {
      m_has_unknown[unknown] = 1;
      m_unknowns.push_back(unknown);
      m_linear[unknown] = slope;
    } else
      m_linear[unknown] += slope;
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Affine_enclosures::Affine_enclosures(const Sparse_system& system)
  : m_system(system), m_centre(system.dimension()), m_offset(system.dimension()), m_values(system.monomials()),
    m_rests(system.monomials()), m_slopes(system.factors()), m_monomial_sums(system.monomials()),
    m_linear(system.dimension()), m_has_monomial(system.monomials(), 0), m_has_unknown(system.dimension(), 0),
    m_has_powers(system.dimension(), 0), m_functions(system.functions()), m_function_sums(system.functions()),
    m_has_function(system.functions(), 0)
{
  std::size_t powers = 0;
  for (int j = 0; j < system.dimension(); ++j) {
    m_first_power.push_back(powers);
    powers += system.degree(j);
  }
  m_powers.resize(powers);
  m_sums.resize(powers);
}

// A power is its value and slope at the centre and a rest of second order; of products the rests are those of the two
// factors and the product of what depends on the place.
CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::set_box(const Box_of_ranges& box, const Equation_block& block)
{
  for (const int j : block.occurring_unknowns()) {
    m_centre[j] = middle(box[j]);
    m_offset[j] = box[j] - Interval(m_centre[j]);
    enclose_powers(j);
  }
  for (const int k : block.functions())
    enclose_function(k, box);
  for (const int k : block.monomials()) {
    const std::size_t first = m_system.first_factor(k);
    for (std::size_t f = first; f < m_system.last_factor(k); ++f) {
      const auto [unknown, exponent] = m_system.factor(f);
      const Interval centre(m_centre[unknown]);
      const Interval value = power(centre, exponent), slope = Interval(exponent) * power(centre, exponent - 1);
      Interval rest(0);
      if (exponent > 1)
        rest = CGAL::square(m_offset[unknown]) * Interval(0.5 * exponent * (exponent - 1)) *
            power(box[unknown], exponent - 2);
      if (f == first) {
        m_values[k] = value;
        m_slopes[f] = slope;
        m_rests[k] = rest;
        continue;
      }
      Interval varying = m_rests[k];
      for (std::size_t g = first; g < f; ++g) {
        varying += m_slopes[g] * m_offset[m_system.factor(g).unknown];
        m_slopes[g] *= value;
      }
      m_slopes[f] = slope * m_values[k];
      m_rests[k] = m_values[k] * rest + value * m_rests[k] + varying * (slope * m_offset[unknown] + rest);
      m_values[k] *= value;
    }
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::form_sum(std::span<const Weighted_index> multiples, int single)
{
  for (const int k : m_monomials)
    m_has_monomial[k] = 0;
  for (const int j : m_unknowns)
    m_has_unknown[j] = 0;
  for (const int j : m_with_powers)
    m_has_powers[j] = 0;
  for (const int k : m_with_functions)
    m_has_function[k] = 0;
  m_monomials.clear();
  m_unknowns.clear();
  m_with_powers.clear();
  m_with_functions.clear();
  m_constant = Interval(0);
  if (single >= 0)
    add_multiple(single, 1);
  for (const auto& [constraint, factor] : multiples)
    add_multiple(constraint, factor);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::add_multiple(int constraint, double factor)
{
  const Interval multiplier(factor);
  m_constant += multiplier * m_system.constant(constraint);
  for (const auto& part : m_system.parts(constraint)) {
    const auto coefficients = m_system.coefficients(part);
    Interval* sums = m_sums.data() + m_first_power[part.unknown];
    if (m_has_powers[part.unknown] == 0) {
      m_has_powers[part.unknown] = 1;
      m_with_powers.push_back(part.unknown);
      std::fill_n(sums, m_system.degree(part.unknown), Interval(0));
    }
    for (std::size_t e = 0; e < coefficients.size(); ++e)
      sums[e] += multiplier * coefficients[e];
  }
  for (const auto& part : m_system.elementary_parts(constraint)) {
    const Interval multiple = multiplier * part.coefficient;
    if (m_has_function[part.function] == 0) {
      m_has_function[part.function] = 1;
      m_with_functions.push_back(part.function);
      m_function_sums[part.function] = multiple;
    } else
      m_function_sums[part.function] += multiple;
  }
  for (const auto& term : m_system.terms(constraint)) {
    const Interval multiple = multiplier * term.coefficient;
    if (m_has_monomial[term.monomial] == 0) {
      m_has_monomial[term.monomial] = 1;
      m_monomials.push_back(term.monomial);
      m_monomial_sums[term.monomial] = multiple;
    } else
      m_monomial_sums[term.monomial] += multiple;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::enclose_affinely()
{
  m_rest = Interval(0);
  for (const int j : m_with_powers) {
    // the polynomial in the offset
    const int degree = m_system.degree(j);
    const Interval* sums = m_sums.data() + m_first_power[j];
    const Interval centre(m_centre[j]);
    m_polynomial.reset(degree);
    for (int e = 1; e <= degree; ++e)
      m_polynomial[e] = sums[e - 1];
    for (int k = 0; k < degree; ++k)
      for (int e = degree; e-- > k;)
        m_polynomial[e] += centre * m_polynomial[e + 1];
    m_constant += m_polynomial[0];
    Interval slope = m_polynomial[1];
    for (int e = 2; e <= degree; ++e) {
      const Power_enclosure& enclosure = m_powers[m_first_power[j] + e - 1];
      slope += m_polynomial[e] * enclosure.slope;
      m_rest += m_polynomial[e] * enclosure.rest;
    }
    add_slope(j, slope);
  }
  for (const int k : m_monomials) {
    const Interval& sum = m_monomial_sums[k];
    m_constant += sum * m_values[k];
    m_rest += sum * m_rests[k];
    for (std::size_t f = m_system.first_factor(k); f < m_system.last_factor(k); ++f)
      add_slope(m_system.factor(f).unknown, sum * m_slopes[f]);
  }
  for (const int k : m_with_functions) {
    const Interval& sum = m_function_sums[k];
    m_constant += sum * m_functions[k].value;
    m_rest += sum * m_functions[k].rest;
    add_slope(m_system.function(k).unknown, sum * m_functions[k].slope);
  }
}

/*
A function of u on a range with the centre c differs from f(c) + s (u - c) by h(u). Where f is convex, h is largest at
an end, and at least (f'(c) - s)(u - c); concave functions are the same upside down. Elsewhere the derivative bounds h,
or the values do when s = 0.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::enclose_function(int function, const Box_of_ranges& box)
{
  const Elementary_term& symbol = m_system.function(function);
  const elementary::Operation& operation = symbol.operation;
  Function_enclosure& enclosure = m_functions[function];
  Interval argument = symbol.argument(box);
  const Interval centre = symbol.scale * Interval(m_centre[symbol.unknown]) + symbol.shift;
  enclosure = {elementary::entire_line(), Interval(0), Interval(0), elementary::entire_line()};
  if (!is_finite(argument) || !elementary::is_in_domain(operation, centre))
    return;
  enclosure.value = elementary::range_of_values(operation, centre);
  const Interval values = elementary::range_of_values(operation, argument), offset = argument - centre;
  const Interval derivative = elementary::range_of_derivative(operation, argument, values);
  enclosure.derivative = symbol.scale * derivative;
  enclosure.rest = values - enclosure.value;
  if (!is_finite(derivative) || width(argument) == 0)
    return;
  // The values alone have a sign that slopes lose.
  constexpr double least_gain = 0.75;
  const auto use = [&](const Interval& slope, const Interval& rest) {
    if (width(rest) < least_gain * width(enclosure.rest)) {
      enclosure.slope = symbol.scale * slope;
      enclosure.rest = rest;
    }
  };
  if (const int sign = elementary::convexity(operation, argument, values); sign != 0) {
    const Interval lower = elementary::value_at(operation, argument.inf()) - enclosure.value;
    const Interval upper = elementary::value_at(operation, argument.sup()) - enclosure.value;
    const Interval secant = (upper - lower) / (Interval(argument.sup()) - Interval(argument.inf()));
    if (!is_finite(secant))
      return;
    const Interval slope(middle(secant));
    const Interval at_lower = lower - slope * (Interval(argument.inf()) - centre);
    const Interval at_upper = upper - slope * (Interval(argument.sup()) - centre);
    const Interval tangent = elementary::range_of_derivative(operation, centre, enclosure.value) - slope;
    const double below = (elementary::point(magnitude(tangent)) * elementary::point(magnitude(offset))).sup();
    use(slope,
        sign > 0 ? Interval(-below, (std::max)(at_lower.sup(), at_upper.sup()))
                 : Interval((std::min)(at_lower.inf(), at_upper.inf()), below));
  } else
    use(Interval(middle(derivative)), (derivative - Interval(middle(derivative))) * offset);
}

// Of the powers of an offset from zero: the third one differs least from a linear function with this slope.
CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::enclose_powers(int unknown)
{
  const double reach = magnitude(m_offset[unknown]);
  for (int e = 2; e <= m_system.degree(unknown); ++e) {
    Power_enclosure& enclosure = m_powers[m_first_power[unknown] + e - 1];
    const double slope = e % 2 == 0 ? 0 : 0.75 * std::pow(reach, e - 1);
    if (slope == 0 || !std::isfinite(slope)) {
      enclosure = {Interval(0), power(m_offset[unknown], e)};
      continue;
    }
    m_polynomial.reset(e);
    m_polynomial[1] = Interval(-slope);
    m_polynomial[e] = Interval(1);
    enclosure = {Interval(slope), m_polynomial.range_by_parts(m_offset[unknown])};
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Affine_enclosures::enclose_derivatives(const Box_of_ranges& box)
{
  m_rest = Interval(0);
  for (const int j : m_with_powers) {
    const int degree = m_system.degree(j);
    m_polynomial.reset(degree);
    for (int e = 1; e <= degree; ++e)
      m_polynomial[e] = m_sums[m_first_power[j] + e - 1];
    m_constant += m_polynomial.value(m_centre[j]);
    add_slope(j, m_polynomial.range_of_derivative(box[j]));
  }
  for (const int k : m_monomials) {
    m_constant += m_monomial_sums[k] * m_values[k];
    for (std::size_t f = m_system.first_factor(k); f < m_system.last_factor(k); ++f) {
      const auto [unknown, exponent] = m_system.factor(f);
      add_slope(unknown,
                m_monomial_sums[k] * m_system.product(k, box, f) * Interval(exponent) *
                    power(box[unknown], exponent - 1));
    }
  }
  for (const int k : m_with_functions) {
    m_constant += m_function_sums[k] * m_functions[k].value;
    add_slope(m_system.function(k).unknown, m_function_sums[k] * m_functions[k].derivative);
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_AFFINE_ENCLOSURES_H
