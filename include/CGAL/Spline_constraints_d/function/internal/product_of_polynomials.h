// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_PRODUCT_OF_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_PRODUCT_OF_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Expansion_budget.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_form.h>
#include <CGAL/Spline_constraints_d/function/internal/Monomial_packing.h>
#include <CGAL/Spline_constraints_d/function/internal/Polynomial_terms.h>
#include <CGAL/Spline_constraints_d/function/internal/expansion_limits.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Sums the products of all pairs of terms; `key_of_product(i, j)` names the monomial of a pair.
template <class Sums, class Key_of_product>
void add_products(Sums& sums, const Integer_form& a, const Integer_form& b, const Key_of_product& key_of_product)
{
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
    for (std::size_t j = 0; j < b.coefficients.size(); ++j)
      add_product(sums[key_of_product(i, j)], a.coefficients[i], b.coefficients[j]);
    check_number_of_terms(sums.size());
  }
}

// Calls visit(monomial, coefficient) for each monomial of the product: one integer multiplication and one addition for
// each pair of terms. A coefficient may be zero.
template <class Visitor>
void visit_product(const Polynomial_terms& a, const Polynomial_terms& b, Expansion_budget& budget, const Visitor& visit)
{
  const Integer_form f(a, budget), g(b, budget);
  const Monomial_packing packing(degrees_of(a), degrees_of(b));
  const double pairs = static_cast<double>(a.size()) * static_cast<double>(b.size());
  budget.spend(pairs * (arithmetic_work(f.words, g.words) + (packing.fits() ? 0 : 10)));
  const Big_integer denominator = f.denominator * g.denominator;

  if (packing.fits()) {
    std::vector<std::uint64_t> keys_a, keys_b;
    for (const Monomial* monomial : f.monomials)
      keys_a.push_back(packing.packed(*monomial));
    for (const Monomial* monomial : g.monomials)
      keys_b.push_back(packing.packed(*monomial));
    std::unordered_map<std::uint64_t, Big_integer> sums;
    add_products(sums, f, g, [&](std::size_t i, std::size_t j) { return keys_a[i] + keys_b[j]; });
    for (const auto& [key, sum] : sums)
      visit(packing.unpacked(key), quotient(sum, denominator));
  } else {
    std::map<Monomial, Big_integer> sums;
    add_products(sums, f, g, [&](std::size_t i, std::size_t j) { return *f.monomials[i] * *g.monomials[j]; });
    for (const auto& [monomial, sum] : sums)
      visit(monomial, quotient(sum, denominator));
  }
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_PRODUCT_OF_POLYNOMIALS_H
