// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ZASSENHAUS_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ZASSENHAUS_FACTORS_H

#include <CGAL/Spline_constraints_d/function/internal/Hensel_lifting.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/modular_common_divisor.h>
#include <CGAL/Spline_constraints_d/function/internal/prime_field_factors.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The irreducible factors over the rational numbers of a polynomial without multiple ones (Zassenhaus 1969): factors
modulo a prime are lifted to a modulus above twice the coefficients that a factor can have (Mignotte 1974), and products
of one, two, ... of them are divided by. The degrees that factors can have modulo several primes exclude most.
*/
class Zassenhaus_factors
{
  using Polynomial = Prime_residues::Polynomial;

  Integer_coefficients m_rest; // what is not factored yet; primitive
  Interruption& m_interruption;
  std::vector<bool> m_degrees; // which ones a factor can have
  std::vector<Integer_coefficients> m_lifted;
  Big_integer m_modulus, m_half;
  Big_integer m_trace_bound; // of the second coefficients of factors with the leading coefficient of the rest
  std::vector<Integer_coefficients> m_result;

public:
  // \pre A primitive polynomial of positive degree without multiple factors that is not zero at zero.
  Zassenhaus_factors(Integer_coefficients f, Interruption& interruption)
    : m_rest(std::move(f)), m_interruption(interruption)
  {}

  std::vector<Integer_coefficients> operator()()
  {
    const auto [prime, factors] = factors_modulo_prime();
    if (factors.size() > 1) {
      const Hensel_lifting lifting(Prime_residues(prime), Big_integer(2 * coefficient_bound() + 1), m_interruption);
      m_lifted = lifting(m_rest, factors);
      m_modulus = lifting.modulus();
      m_half = m_modulus / 2;
      set_trace_bound();
      for (std::size_t count = 1; 2 * count <= m_lifted.size();)
        if (!find_product_of(count))
          ++count;
    }
    m_result.push_back(std::move(m_rest));
    return std::move(m_result);
  }

private:
  // For the prime, of several ones, with the fewest factors; none if some primes show that there are no proper ones.
  std::pair<Prime_residues::Number, std::vector<Polynomial>> factors_modulo_prime()
  {
    constexpr int most_primes = 6;
    m_degrees.assign(m_rest.size(), true);
    std::pair<Prime_residues::Number, std::vector<Polynomial>> result;
    Prime_residues::Number prime = 0x1001;
    for (int count = 0; count < most_primes;) {
      prime = prime < 0x400 ? Prime_residues::prime_below(0x7fffffff) : Prime_residues::prime_below(prime);
      const Prime_residues field(prime);
      const Polynomial f = field.of(m_rest);
      if (f.size() < m_rest.size() || field.common_divisor(f, field.derivative(f)).size() > 1)
        continue;
      std::vector<Polynomial> factors = Prime_field_factors(field, field.monic(f), m_interruption)();
      keep_degrees_of(factors);
      if (count == 0 || factors.size() < result.second.size())
        result = {prime, std::move(factors)};
      if (std::accumulate(m_degrees.begin(), m_degrees.end(), 0) == 2) // nothing and all
        return {prime, {}};
      ++count;
    }
    return result;
  }

  void keep_degrees_of(const std::vector<Polynomial>& factors)
  {
    std::vector<bool> sums(m_rest.size(), false);
    sums[0] = true;
    for (const Polynomial& factor : factors)
      for (std::size_t k = sums.size(); k-- >= factor.size();)
        sums[k] = sums[k] || sums[k + 1 - factor.size()];
    for (std::size_t k = 0; k < sums.size(); ++k)
      m_degrees[k] = m_degrees[k] && sums[k];
  }

  // Of the coefficients of a factor with the leading coefficient of the polynomial.
  Big_integer coefficient_bound() const
  {
    Big_integer squares(0), root;
    for (const Big_integer& x : m_rest)
      add_product(squares, x, x);
    mpz_sqrt(root.backend().data(), squares.backend().data());
    Big_integer result(root + 1);
    shift_left(result, static_cast<unsigned long>(m_rest.size()));
    return result;
  }

  // Finds a factor that is the product of so many lifted ones.
  bool find_product_of(std::size_t count)
  {
    std::vector<std::size_t> chosen(count);
    std::iota(chosen.begin(), chosen.end(), std::size_t(0));
    do {
      m_interruption.add_work(64 * count);
      if (std::optional<Integer_coefficients> factor = product_if_factor(chosen)) {
        m_rest = *exact_quotient(std::move(m_rest), *factor);
        m_result.push_back(std::move(*factor));
        set_trace_bound();
        for (std::size_t k = count; k-- > 0;)
          m_lifted.erase(m_lifted.begin() + static_cast<std::ptrdiff_t>(chosen[k]));
        return true;
      }
    } while (advance(chosen));
    return false;
  }

  // The next of the increasing sequences, if there is one.
  bool advance(std::vector<std::size_t>& chosen) const
  {
    const std::size_t count = chosen.size();
    for (std::size_t k = count; k-- > 0;)
      if (chosen[k] < m_lifted.size() - (count - k)) {
        std::iota(chosen.begin() + static_cast<std::ptrdiff_t>(k), chosen.end(), chosen[k] + 1);
        return true;
      }
    return false;
  }

  std::optional<Integer_coefficients> product_if_factor(const std::vector<std::size_t>& chosen) const
  {
    std::size_t degree = 0;
    for (const std::size_t k : chosen)
      degree += m_lifted[k].size() - 1;
    if (!m_degrees[degree] || !has_possible_trace(chosen) || !has_possible_constant(chosen))
      return std::nullopt;
    Integer_coefficients product(1, m_rest.back());
    for (const std::size_t k : chosen) {
      product = product_of(product, m_lifted[k]);
      for (Big_integer& x : product)
        x = symmetric_residue(x);
    }
    m_interruption.add_work(product.size() * m_rest.size() * product.size());
    product = primitive_part(std::move(product));
    return exact_quotient(m_rest, product) ? std::optional(std::move(product)) : std::nullopt;
  }

  // The second coefficient is minus the sum of at most n zeros, which are at most 1 + max |a_i| / |a_n| (Cauchy), times
  // the leading one.
  void set_trace_bound()
  {
    Big_integer greatest(0);
    for (const Big_integer& x : m_rest)
      greatest = (std::max)(greatest, Big_integer(abs(x)));
    m_trace_bound = (greatest + abs(m_rest.back())) * static_cast<unsigned long>(m_rest.size());
  }

  // Nearly all products that are no factors have a longer second coefficient (Abbott, Shoup, Zimmermann 2000).
  bool has_possible_trace(const std::vector<std::size_t>& chosen) const
  {
    Big_integer trace(0);
    for (const std::size_t k : chosen)
      trace += m_lifted[k][m_lifted[k].size() - 2];
    return abs(symmetric_residue(Big_integer(trace * m_rest.back()))) <= m_trace_bound;
  }

  // Whether the constant coefficient of the product, with the leading coefficient of the rest, divides that of the rest
  // times this leading coefficient.
  bool has_possible_constant(const std::vector<std::size_t>& chosen) const
  {
    Big_integer constant = m_rest.back();
    for (const std::size_t k : chosen)
      constant = constant * m_lifted[k].front() % m_modulus;
    constant = symmetric_residue(constant);
    const Big_integer multiple = m_rest.front() * m_rest.back();
    return constant != 0 && mpz_divisible_p(multiple.backend().data(), constant.backend().data());
  }

  Big_integer symmetric_residue(const Big_integer& x) const
  {
    Big_integer result;
    mpz_fdiv_r(result.backend().data(), x.backend().data(), m_modulus.backend().data());
    if (result > m_half)
      result -= m_modulus;
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ZASSENHAUS_FACTORS_H
