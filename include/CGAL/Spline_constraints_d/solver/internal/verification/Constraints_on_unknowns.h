// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_CONSTRAINTS_ON_UNKNOWNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_CONSTRAINTS_ON_UNKNOWNS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A value that is the sine or the cosine of an angle with these rational ones, plus whole turns.
struct Rational_wave
{
  int value; // its place among the values
  Exact_rational sine, cosine;
  long turns;
};

/*
The same constraints with numbers in place of all unknowns but some, which are numbered anew; and of some values, for
which there are equalities then, that their arguments are the angles.
*/
struct Constraints_on_unknowns
{
  std::vector<std::pair<Power_polynomial, Relation>> constraints;
  Elementary_values values;

  // Throws where a function is not defined for a number.
  Constraints_on_unknowns(const std::vector<std::pair<Power_polynomial, Relation>>& given,
                          const Elementary_values& given_values, const std::vector<Exact_rational>& point,
                          const std::vector<int>& unknowns, const std::vector<Rational_wave>& waves = {});

private:
  void add_angle(const Power_polynomial& argument, const Rational_wave& wave);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE
Constraints_on_unknowns::Constraints_on_unknowns(const std::vector<std::pair<Power_polynomial, Relation>>& given,
                                                 const Elementary_values& given_values,
                                                 const std::vector<Exact_rational>& point,
                                                 const std::vector<int>& unknowns,
                                                 const std::vector<Rational_wave>& waves)
{
  std::map<int, Power_polynomial> replacements;
  for (std::size_t j = 0; j < point.size(); ++j)
    replacements.emplace(static_cast<int>(j), Power_polynomial(point[j]));
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    replacements[unknowns[k]] = Power_polynomial::variable(static_cast<int>(k));
  const auto replaced = [&](const Power_polynomial& polynomial) {
    Power_polynomial result;
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      Power_polynomial term(coefficient);
      for (const auto& [symbol, exponent] : monomial.powers)
        term *= pow(replacements.at(symbol), exponent);
      result += term;
    }
    return result;
  };
  int index = Elementary_values::first_index;
  for (const auto& [function, exponent, given_argument] : given_values.all()) {
    const Power_polynomial argument = replaced(given_argument);
    const auto wave = std::ranges::find(waves, index - Elementary_values::first_index, &Rational_wave::value);
    if (wave != waves.end() && !argument.is_constant()) {
      add_angle(argument, *wave);
      replacements.emplace(index++, function == Elementary_function::SINE ? wave->sine : wave->cosine);
    } else
      replacements.emplace(index++,
                           function == Elementary_function::POWER ? values.power(argument, exponent)
                                                                  : values.value(function, argument));
  }
  for (const auto& [polynomial, relation] : given)
    constraints.emplace_back(replaced(polynomial), relation);
}

// Once for each argument: an angle is twice the arc tangent of sin/(1 + cos).
CGAL_SPLINE_CONSTRAINTS_INLINE void Constraints_on_unknowns::add_angle(const Power_polynomial& argument,
                                                                       const Rational_wave& wave)
{
  const Power_polynomial pi = values.pi();
  const Power_polynomial angle =
      wave.cosine == -1 ? pi : 2 * values.atan(Exact_rational(wave.sine / (1 + wave.cosine)));
  std::pair<Power_polynomial, Relation> equality(argument - angle - 2 * Exact_rational(wave.turns) * pi,
                                                 Relation::EQUAL);
  if (std::ranges::find(constraints, equality) == constraints.end())
    constraints.push_back(std::move(equality));
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_CONSTRAINTS_ON_UNKNOWNS_H
