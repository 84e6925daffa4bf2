// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_COMMON_FACTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_COMMON_FACTOR_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions
A polynomial that divides some others, with the quotients.
*/
struct Common_factor
{
  Power_polynomial factor;                   ///< not constant; integer coefficients without a common divisor
  std::vector<Power_polynomial> cofactors;   ///< \f$f_i\f$ = `factor` `cofactors[i]`, exactly
};

namespace internal {

// A polynomial with integer coefficients: f times a positive constant.
using Integer_terms = std::vector<std::pair<Monomial, Big_integer>>;

Integer_terms integer_terms(const Power_polynomial& f, Big_integer& denominator);

/*
Polynomials as integers: the values at a point with large integer coordinates, from which coefficients below half of the
first coordinate can be read back as digits. Each coordinate is larger than all values of the unknowns before it.
*/
class Integer_evaluation
{
  std::vector<int> m_variables, m_degrees;
  std::vector<std::vector<Big_integer>> m_powers;   // of the coordinate, per unknown

public:
  Integer_evaluation(const std::map<int, int>& degrees, long first_bits);

  // Bits of the largest values, to judge the cost before.
  static double bits(const std::map<int, int>& degrees, long first_bits);

  Big_integer operator()(const Integer_terms& terms) const;

  // The polynomial whose digits a value shows; nothing when it has more of them than the degrees allow.
  std::optional<Integer_terms> interpolate(const Big_integer& value) const
  {
    Integer_terms result;
    return interpolate(value, m_variables.size(), Monomial(), result) ? std::optional(result) : std::nullopt;
  }

private:
  bool interpolate(Big_integer value, std::size_t unknowns, const Monomial& monomial, Integer_terms& result) const;
};

void divide_by_content(Integer_terms& terms);

Power_polynomial polynomial_of(const Integer_terms& terms, const Big_integer& denominator);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Integer_terms integer_terms(const Power_polynomial& f, Big_integer& denominator)
{
  denominator = 1;
  for (const auto& [monomial, coefficient] : f.terms())
    denominator = lcm(denominator, denominator_of(coefficient));
  Integer_terms result;
  for (const auto& [monomial, coefficient] : f.terms())
    result.emplace_back(monomial, Big_integer(numerator_of(coefficient) * (denominator / denominator_of(coefficient))));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void divide_by_content(Integer_terms& terms)
{
  Big_integer content(0);
  for (const auto& [monomial, coefficient] : terms)
    content = gcd(content, coefficient);
  for (auto& [monomial, coefficient] : terms)
    coefficient /= content;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_of(const Integer_terms& terms,
                                                              const Big_integer& denominator)
{
  Power_polynomial result;
  for (const auto& [monomial, coefficient] : terms) {
    Power_polynomial term(Exact_rational(scaled_rational(coefficient, 0) / scaled_rational(denominator, 0)));
    for (const auto& [variable, exponent] : monomial.powers)
      term *= pow(Power_polynomial::variable(variable), exponent);
    result += std::move(term);
  }
  return result;
}
#endif

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Integer_evaluation::Integer_evaluation(const std::map<int, int>& degrees,
                                                                      long first_bits)
{
  long bits = first_bits;
  for (const auto& [variable, degree] : degrees) {
    m_variables.push_back(variable);
    m_degrees.push_back(degree);
    // An odd digit pattern: at powers of two or their neighbours, values have small common divisors too often.
    Big_integer coordinate(1);
    shift_left(coordinate, static_cast<unsigned long>(bits));
    coordinate += coordinate / 3 + 2 * variable + 41;
    auto& powers = m_powers.emplace_back(1, Big_integer(1));
    for (int e = 1; e <= degree; ++e)
      powers.push_back(Big_integer(powers.back() * coordinate));
    bits = (bits + 1) * (degree + 1) + 8;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE double Integer_evaluation::bits(const std::map<int, int>& degrees, long first_bits)
{
  double result = static_cast<double>(first_bits);
  for (const auto& [variable, degree] : degrees)
    result = (result + 1) * (degree + 1) + 8;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Big_integer Integer_evaluation::operator()(const Integer_terms& terms) const
{
  Big_integer sum(0);
  for (const auto& [monomial, coefficient] : terms) {
    Big_integer product(coefficient);
    for (const auto& [variable, exponent] : monomial.powers)
      product *=
          m_powers[std::lower_bound(m_variables.begin(), m_variables.end(), variable) - m_variables.begin()][exponent];
    sum += product;
  }
  return sum;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Integer_evaluation::interpolate(Big_integer value, std::size_t unknowns,
                                                                    const Monomial& monomial,
                                                                    Integer_terms& result) const
{
  if (unknowns == 0) {
    if (value != 0)
      result.emplace_back(monomial, value);
    return true;
  }
  const std::size_t last = unknowns - 1;
  if (m_degrees[last] == 0)
    return interpolate(std::move(value), last, monomial, result);
  const Big_integer& base = m_powers[last][1];
  for (int exponent = 0; value != 0; ++exponent) {
    if (exponent > m_degrees[last])
      return false;
    Big_integer digit; // the balanced remainder
    mpz_fdiv_qr(value.backend().data(), digit.backend().data(), value.backend().data(), base.backend().data());
    if (2 * digit > base) {
      digit -= base;
      ++value;
    }
    if (!interpolate(std::move(digit), last, monomial.with_exponent(m_variables[last], exponent), result))
      return false;
  }
  return true;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

A common factor of polynomials that are not all zero, as a rule the greatest one; nothing when none was found.

The heuristic of Char, Geddes and Gonnet (GCDHEU, 1989): polynomials become integers by evaluation at a point with large
integer coordinates, and the digits of the greatest common divisor of these are the coefficients of the factor. A factor
is returned only when its products with the cofactors are the polynomials, so it is exact; that none is returned proves
nothing, also when the integers would have more than 2^22 bits. Zero polynomials have the cofactor zero.

The cost is that of one greatest common divisor of integers with about \f$b \prod_j (d_j+1)\f$ bits, for coefficients of
\f$b\f$ bits and degrees \f$d_j\f$.
*/
std::optional<Common_factor> common_factor(const std::vector<Power_polynomial>& polynomials);

namespace internal {

// A common factor of a polynomial and its derivatives.
std::optional<Common_factor> repeated_factor(const Power_polynomial& polynomial);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Common_factor> repeated_factor(const Power_polynomial& polynomial)
{
  std::vector<Power_polynomial> all{polynomial};
  for (int variable : polynomial.variables())
    all.push_back(polynomial.derivative(variable));
  return common_factor(all);
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions
a polynomial with the same zeros, real and complex, without the repeated factors that `common_factor()` finds.
*/
inline Power_polynomial square_free_part(const Power_polynomial& polynomial)
{
  const auto repeated = internal::repeated_factor(polynomial);
  return repeated ? repeated->cofactors[0] : polynomial;
}

/*!
\ingroup PkgSplineConstraintsDFunctions
polynomials \f$g_1, \dots, g_m\f$ with \f$f = c\, g_1 g_2^2 \cdots g_m^m\f$ for a constant \f$c\f$, exactly, where no
\f$g_k\f$ has repeated factors that `common_factor()` finds, nor two of them a common one. Just \f$f\f$ if it has none.

Source: Yun, On square-free decomposition algorithms, 1976; with all derivatives in the place of one.
*/
std::vector<Power_polynomial> square_free_factors(const Power_polynomial& f);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Common_factor>
common_factor(const std::vector<Power_polynomial>& polynomials)
{
  using namespace internal;
  std::vector<Integer_terms> terms;
  std::vector<Big_integer> denominators(polynomials.size());
  std::map<int, int> degrees; // of all of them
  long bits = 0;
  int total_degree = 0;
  for (std::size_t i = 0; i < polynomials.size(); ++i) {
    terms.push_back(integer_terms(polynomials[i], denominators[i]));
    for (const auto& [variable, degree] : polynomials[i].degrees())
      degrees[variable] = (std::max)(degrees[variable], degree);
    for (const auto& [monomial, coefficient] : terms.back())
      bits = (std::max)(bits, bit_length(coefficient));
    total_degree = (std::max)(total_degree, polynomials[i].total_degree());
  }
  // Coefficients of a factor are at most about 2^degree times as large.
  for (const long first_bits : {bits + total_degree + 16, 2 * bits + 2 * total_degree + 61}) {
    if (Integer_evaluation::bits(degrees, first_bits) > 0x1p22)
      return std::nullopt;
    const Integer_evaluation evaluation(degrees, first_bits);
    std::vector<Big_integer> values;
    Big_integer divisor(0);
    for (const Integer_terms& f : terms) {
      values.push_back(evaluation(f));
      divisor = gcd(divisor, values.back());
    }
    std::optional<Integer_terms> factor = evaluation.interpolate(divisor);
    if (!factor || factor->empty())
      continue;
    divide_by_content(*factor);
    Common_factor result{polynomial_of(*factor, Big_integer(1)), {}};
    if (result.factor.is_constant())
      return std::nullopt;
    const Big_integer value = evaluation(*factor);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::optional<Integer_terms> cofactor =
          values[i] % value == 0 ? evaluation.interpolate(Big_integer(values[i] / value)) : std::nullopt;
      if (!cofactor)
        break;
      result.cofactors.push_back(polynomial_of(*cofactor, denominators[i]));
      if (!(result.factor * result.cofactors.back() == polynomials[i])) {
        result.cofactors.pop_back();
        break;
      }
    }
    if (result.cofactors.size() == polynomials.size())
      return result;
  }
  return std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Power_polynomial> square_free_factors(const Power_polynomial& f)
{
  std::vector<Power_polynomial> result; // at first g_k g_{k+1} ... g_m
  for (Power_polynomial rest = f;;) {
    const auto repeated = internal::repeated_factor(rest);
    result.push_back(repeated ? repeated->cofactors[0] : rest);
    if (!repeated)
      break;
    rest = repeated->factor;
  }
  for (std::size_t k = 0; k + 1 < result.size(); ++k) {
    const auto common = common_factor({result[k], result[k + 1]});
    if (!common || !common->cofactors[1].is_constant())
      return {f};
    result[k] = common->cofactors[0];
  }
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_COMMON_FACTOR_H
