// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_MONOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_MONOMIAL_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <compare>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A product of powers of unknowns; the empty product is 1.
*/
struct Monomial
{
  //! pairs (unknown, exponent): unknowns increase and are non-negative, exponents are positive.
  std::vector<std::pair<int, int>> powers;

  //! lexicographic order of the pairs; it serves containers and means nothing else.
  auto operator<=>(const Monomial&) const = default;

  //! the sum of the exponents.
  int total_degree() const
  {
    int result = 0;
    for (const auto& power : powers)
      result += power.second;
    return result;
  }

  //! the exponent of an unknown, 0 when it does not occur.
  int exponent(int variable) const
  {
    const auto position = std::lower_bound(powers.begin(), powers.end(), std::pair<int, int>(variable, 0));
    return position != powers.end() && position->first == variable ? position->second : 0;
  }

  //! the monomial with the exponent of one unknown replaced; 0 removes the unknown.
  Monomial with_exponent(int variable, int exponent) const;

  //! product: exponents add.
  friend Monomial operator*(const Monomial& a, const Monomial& b);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Monomial Monomial::with_exponent(int variable, int exponent) const
{
  Monomial result(*this);
  const auto position = std::lower_bound(result.powers.begin(), result.powers.end(), std::pair<int, int>(variable, 0));
  const bool occurs = position != result.powers.end() && position->first == variable;
  if (exponent == 0) {
    if (occurs)
      result.powers.erase(position);
  } else if (occurs)
    position->second = exponent;
  else
    result.powers.insert(position, {variable, exponent});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial operator*(const Monomial& a, const Monomial& b)
{
  Monomial result;
  result.powers.reserve(a.powers.size() + b.powers.size());
  auto i = a.powers.begin(), j = b.powers.begin();
  while (i != a.powers.end() && j != b.powers.end())
    if (i->first == j->first) {
      result.powers.emplace_back(i->first, i->second + j->second);
      ++i;
      ++j;
    } else
      result.powers.push_back(i->first < j->first ? *i++ : *j++);
  result.powers.insert(result.powers.end(), i, a.powers.end());
  result.powers.insert(result.powers.end(), j, b.powers.end());
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_MONOMIAL_H
