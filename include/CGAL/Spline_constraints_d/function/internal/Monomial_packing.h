// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_MONOMIAL_PACKING_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_MONOMIAL_PACKING_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Monomials as single integers: the exponents are the digits of a number in mixed radix, large enough that the digits of a
product of two do not overflow. Then monomials multiply by one integer addition.
*/
class Monomial_packing
{
  std::vector<std::pair<int, std::uint64_t>> m_radices;   // unknown, one more than its degree in the product
  bool m_fits = true;

public:
  // Of the products of monomials whose unknowns have at most these degrees.
  Monomial_packing(const std::map<int, int>& degrees_a, const std::map<int, int>& degrees_b);

  bool fits() const { return m_fits; }

  std::uint64_t packed(const Monomial& monomial) const;

  Monomial unpacked(std::uint64_t key) const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Monomial_packing::Monomial_packing(const std::map<int, int>& degrees_a,
                                                                  const std::map<int, int>& degrees_b)
{
  std::map<int, int> degrees = degrees_a;
  for (const auto& [variable, degree] : degrees_b)
    degrees[variable] += degree;
  std::uint64_t range = 1;
  for (const auto& [variable, degree] : degrees) {
    const std::uint64_t radix = static_cast<std::uint64_t>(degree) + 1;
    m_radices.emplace_back(variable, radix);
    m_fits = m_fits && range <= UINT64_MAX / radix;
    range *= radix;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::uint64_t Monomial_packing::packed(const Monomial& monomial) const
{
  std::uint64_t key = 0;
  auto power = monomial.powers.begin();
  for (const auto& [variable, radix] : m_radices) {
    key *= radix;
    if (power != monomial.powers.end() && power->first == variable)
      key += static_cast<std::uint64_t>((power++)->second);
  }
  return key;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial Monomial_packing::unpacked(std::uint64_t key) const
{
  Monomial result;
  for (auto digit = m_radices.rbegin(); digit != m_radices.rend(); key /= digit->second, ++digit)
    if (key % digit->second != 0)
      result.powers.emplace_back(digit->first, static_cast<int>(key % digit->second));
  std::reverse(result.powers.begin(), result.powers.end());
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_MONOMIAL_PACKING_H
