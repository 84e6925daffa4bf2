// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_ELEMENTARY_VALUES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_ELEMENTARY_VALUES_H

#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

An elementary function of a polynomial in unknowns and in values that were made before.
*/
struct Elementary_value
{
  Elementary_function function = Elementary_function::ABSOLUTE_VALUE; //!< which one.
  Exact_rational exponent;                                            //!< of `POWER`.
  Power_polynomial argument;                                          //!< what it is taken of.
};

/*!
\ingroup PkgSplineConstraintsDFunctions

Values of elementary functions, as further unknowns of polynomials: \f$e^x - x - 2\f$ is the polynomial
`values.exp(x) - x - 2`, in the unknown `x` and the value. The index of the value
\f$k\f$ is `first_index` \f$+ k\f$; equal ones are made once. A point where one of the values is not defined is no
solution of constraints that are solved together with them, even where these have no longer need of it.

Exactness: all of it. A value that is rational by the laws of the function, as \f$e^0\f$ or \f$\sqrt{9/4}\f$, is this
number.
*/
class Elementary_values
{
  std::vector<Elementary_value> m_values;
  std::unordered_map<std::string, int> m_places;

public:
  //! indices of unknowns from here on stand for values.
  static constexpr int first_index = 1 << 20;

  //! the values, each in terms of those before it.
  const std::vector<Elementary_value>& all() const { return m_values; }

  /*!
  a function of a polynomial.
  \param function which one; of `POWER` see `power()`.
  \param argument what it is taken of.
  \throws Invalid_input when the argument is a rational number for which the function is not defined.
  */
  Power_polynomial value(Elementary_function function, const Power_polynomial& argument)
  {
    if (function == Elementary_function::RECIPROCAL)
      return reciprocal(argument);
    if (function == Elementary_function::POWER)
      throw Invalid_input("Elementary_values: a power needs an exponent");
    return enter({function, Exact_rational(), argument});
  }

  //! \name Some of these by their names, of a polynomial as `value()`
  //! @{
  //! \f$e^x\f$. \param x what it is taken of.
  Power_polynomial exp(const Power_polynomial& x) { return value(Elementary_function::EXPONENTIAL, x); }
  //! the logarithm to the base \f$e\f$. \param x what it is taken of.
  Power_polynomial log(const Power_polynomial& x) { return value(Elementary_function::LOGARITHM, x); }
  //! the square root. \param x what it is taken of.
  Power_polynomial sqrt(const Power_polynomial& x) { return value(Elementary_function::SQUARE_ROOT, x); }
  //! the sine. \param x what it is taken of.
  Power_polynomial sin(const Power_polynomial& x) { return value(Elementary_function::SINE, x); }
  //! the cosine. \param x what it is taken of.
  Power_polynomial cos(const Power_polynomial& x) { return value(Elementary_function::COSINE, x); }
  //! the tangent. \param x what it is taken of.
  Power_polynomial tan(const Power_polynomial& x) { return value(Elementary_function::TANGENT, x); }
  //! the arc tangent. \param x what it is taken of.
  Power_polynomial atan(const Power_polynomial& x) { return value(Elementary_function::ARC_TANGENT, x); }
  //! four times `atan(1)`.
  Power_polynomial pi() { return 4 * atan(Power_polynomial(1)); }
  //! @}

  /*!
  one divided by a polynomial; of products it is the product of the reciprocals.
  \param divisor the polynomial.
  \throws Invalid_input when it is zero.
  */
  Power_polynomial reciprocal(const Power_polynomial& divisor);

  /*!
  a polynomial to the power of a constant. Exponents that are integers make powers of the polynomial or its reciprocal,
  halves of integers make powers of the square root; of all others see `Elementary_function::POWER`.
  \param base the polynomial.
  \param exponent the constant.
  \throws Invalid_input when the base is a number of which there is no such power, or an integer exponent is too large.
  */
  Power_polynomial power(const Power_polynomial& base, const Exact_rational& exponent);

  /*!
  a polynomial as text, with the functions in it; `read_minibex()` can read it.
  \param polynomial in unknowns and values.
  \param names of the unknowns.
  \throws Invalid_input when there are too few names, or the text is longer than ten million characters.
  */
  std::string text(const Power_polynomial& polynomial, std::span<const std::string> names) const;

  /*!
  the values at a rational point, one after the other; nothing when one of them is not rational by the laws of the
  functions, or not defined.
  \param point a number for each unknown that occurs.
  */
  std::optional<std::vector<Exact_rational>> rational_values(const std::vector<Exact_rational>& point) const;

  /*!
  a polynomial at a point.
  \param polynomial in unknowns and values.
  \param point a number for each unknown.
  \param values what `rational_values()` gives for this point.
  */
  Exact_rational rational_value(const Power_polynomial& polynomial, const std::vector<Exact_rational>& point,
                                const std::vector<Exact_rational>& values) const;

private:
  Power_polynomial enter(Elementary_value value);
};

namespace internal {

// The value at a rational number where that is rational by the laws of the function; nothing elsewhere, also where the
// function is not defined.
std::optional<Exact_rational> rational_value_of(Elementary_function function, const Exact_rational& exponent,
                                                const Exact_rational& x);

// Whether a function is defined at a rational number.
bool is_defined_at(Elementary_function function, const Exact_rational& exponent, const Exact_rational& x);

// Different texts for different values.
std::string text_of(const Elementary_value& value);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::string text_of(const Elementary_value& value)
{
  std::string result =
      std::to_string(static_cast<int>(value.function)) + ' ' + Power_polynomial(value.exponent).to_string();
  for (const auto& [monomial, coefficient] : value.argument.terms()) {
    result += ' ' + Power_polynomial(coefficient).to_string();
    for (const auto& [unknown, exponent] : monomial.powers)
      result += '*' + std::to_string(unknown) + '^' + std::to_string(exponent);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool is_defined_at(Elementary_function function, const Exact_rational& exponent,
                                                  const Exact_rational& x)
{
  switch (function) {
  case Elementary_function::RECIPROCAL:
    return x != 0;
  case Elementary_function::POWER:
    return x > 0 || (x == 0 && exponent > 0);
  case Elementary_function::SQUARE_ROOT:
    return x >= 0;
  case Elementary_function::LOGARITHM:
    return x > 0;
  case Elementary_function::ARC_SINE:
  case Elementary_function::ARC_COSINE:
    return -1 <= x && x <= 1;
  default:
    return true;
  }
}

// The square root of an integer that is a square.
inline std::optional<Big_integer> root_of_square(const Big_integer& n)
{
  const Big_integer root = boost::multiprecision::sqrt(n);
  return root * root == n ? std::optional<Big_integer>(root) : std::nullopt;
}

// e^x, sin x, tan x, ... of a rational number other than 0 are transcendental (Lindemann), and so are logarithms, arcs.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_rational>
rational_value_of(Elementary_function function, const Exact_rational& exponent, const Exact_rational& x)
{
  if (!is_defined_at(function, exponent, x))
    return std::nullopt;
  const auto only_at = [&](int place, int value) {
    return x == place ? std::optional<Exact_rational>(value) : std::nullopt;
  };
  switch (function) {
  case Elementary_function::RECIPROCAL:
    return Exact_rational(Exact_rational(1) / x);
  case Elementary_function::POWER:
    return x == 0 ? only_at(0, 0) : only_at(1, 1);
  case Elementary_function::SQUARE_ROOT: {
    const auto above = root_of_square(numerator_of(x)), below = root_of_square(denominator_of(x));
    if (!above || !below)
      return std::nullopt;
    return Exact_rational(scaled_rational(*above, 0) / scaled_rational(*below, 0));
  }
  case Elementary_function::EXPONENTIAL:
  case Elementary_function::COSINE:
  case Elementary_function::HYPERBOLIC_COSINE:
    return only_at(0, 1);
  case Elementary_function::LOGARITHM:
  case Elementary_function::ARC_COSINE:
    return only_at(1, 0);
  case Elementary_function::ABSOLUTE_VALUE:
    return x < 0 ? Exact_rational(-x) : x;
  default:
    return only_at(0, 0);
  }
}
#endif

} // namespace internal

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Elementary_values::enter(Elementary_value value)
{
  if (value.argument.is_constant()) {
    const Exact_rational x = value.argument.constant_term();
    if (!internal::is_defined_at(value.function, value.exponent, x))
      throw Invalid_input("a function of a number for which it is not defined");
    if (const auto known = internal::rational_value_of(value.function, value.exponent, x))
      return *known;
  }
  const std::string key = internal::text_of(value);
  const auto [place, is_new] = m_places.try_emplace(key, static_cast<int>(m_values.size()));
  if (is_new)
    m_values.push_back(std::move(value));
  return Power_polynomial::variable(first_index + place->second);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Elementary_values::reciprocal(const Power_polynomial& divisor)
{
  if (divisor.is_zero())
    throw Invalid_input("division by zero");
  if (divisor.terms().size() > 1)
    return enter({Elementary_function::RECIPROCAL, Exact_rational(), divisor});
  const auto& [monomial, coefficient] = *divisor.terms().begin();
  Power_polynomial result(Exact_rational(Exact_rational(1) / coefficient));
  for (const auto& [unknown, exponent] : monomial.powers)
    result *=
        pow(enter({Elementary_function::RECIPROCAL, Exact_rational(), Power_polynomial::variable(unknown)}), exponent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Elementary_values::power(const Power_polynomial& base,
                                                                         const Exact_rational& exponent)
{
  const auto integer_power = [&](const Power_polynomial& root, const internal::Big_integer& times) {
    if (times < -Power_polynomial::maximal_degree || times > Power_polynomial::maximal_degree)
      throw Invalid_input("an exponent that is too large");
    const int count = static_cast<int>(times.convert_to<long>());
    return count >= 0 ? pow(root, count) : pow(reciprocal(root), -count);
  };
  const internal::Big_integer numerator = internal::numerator_of(exponent);
  const internal::Big_integer denominator = internal::denominator_of(exponent);
  if (denominator == 1)
    return integer_power(base, numerator);
  if (denominator == 2)
    return integer_power(enter({Elementary_function::SQUARE_ROOT, Exact_rational(), base}), numerator);
  return enter({Elementary_function::POWER, exponent, base});
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string Elementary_values::text(const Power_polynomial& polynomial,
                                                                   std::span<const std::string> names) const
{
  constexpr std::size_t most_characters = 10'000'000;
  std::size_t length = 0;
  std::vector<std::string> all(names.begin(), names.end());
  std::vector<int> indices;
  for (std::size_t j = 0; j < names.size(); ++j)
    indices.push_back(static_cast<int>(j));
  const auto require_names = [&](const Power_polynomial& p) {
    for (const int j : p.variables())
      if (j < first_index && j >= static_cast<int>(names.size()))
        throw Invalid_input("Elementary_values: no name for unknown " + std::to_string(j));
  };
  const auto write = [&](const Power_polynomial& p) {
    require_names(p);
    return internal::renumbered(p, indices).to_string(all);
  };
  for (std::size_t k = 0; k < m_values.size(); ++k) {
    const auto& [function, exponent, argument] = m_values[k];
    const std::string inner = '(' + write(argument) + ')';
    all.push_back(function == Elementary_function::RECIPROCAL ? "(1/" + inner + ')'
                      : function == Elementary_function::POWER
                      ? '(' + inner + "^(" + Power_polynomial(exponent).to_string() + "))"
                      : std::string(name_of(function)) + inner);
    length += all.back().size();
    if (length > most_characters)
      throw Invalid_input("Elementary_values: the text is too long");
    indices.push_back(first_index + static_cast<int>(k));
  }
  return write(polynomial);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational
Elementary_values::rational_value(const Power_polynomial& polynomial, const std::vector<Exact_rational>& point,
                                  const std::vector<Exact_rational>& values) const
{
  Exact_rational result(0);
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Exact_rational term = coefficient;
    for (const auto& [unknown, exponent] : monomial.powers) {
      const Exact_rational& factor = unknown < first_index ? point.at(unknown) : values.at(unknown - first_index);
      for (int e = 0; e < exponent; ++e)
        term *= factor;
    }
    result += term;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::vector<Exact_rational>>
Elementary_values::rational_values(const std::vector<Exact_rational>& point) const
{
  std::vector<Exact_rational> result;
  for (const auto& [function, exponent, argument] : m_values) {
    const auto value = internal::rational_value_of(function, exponent, rational_value(argument, point, result));
    if (!value)
      return std::nullopt;
    result.push_back(*value);
  }
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_ELEMENTARY_VALUES_H
