// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POWER_POLYNOMIAL_IMPL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POWER_POLYNOMIAL_IMPL_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline void check_number_of_terms(std::size_t size)
{
  if (size > Power_polynomial::maximal_number_of_terms)
    throw Invalid_input("Power_polynomial: more than " + std::to_string(Power_polynomial::maximal_number_of_terms) +
                        " terms");
}

inline void check_degree(long long degree)
{
  if (degree > Power_polynomial::maximal_degree)
    throw Invalid_input("Power_polynomial: the total degree exceeds " +
                        std::to_string(Power_polynomial::maximal_degree));
}

inline void check_coefficient_bits(long bits)
{
  if (bits > Power_polynomial::maximal_coefficient_bits)
    throw Invalid_input("Power_polynomial: a coefficient of more than " +
                        std::to_string(Power_polynomial::maximal_coefficient_bits) + " bits");
}

inline void check_coefficient(const Exact_rational& value)
{
  check_coefficient_bits(bit_length(numerator_of(value)));
  check_coefficient_bits(bit_length(denominator_of(value)));
}

// A polynomial over one denominator, with integer coefficients.
struct Integer_form
{
  Big_integer denominator = 1;
  std::vector<const Monomial*> monomials;
  std::vector<Big_integer> coefficients;
  double words = 0;   // of the largest coefficient

  Integer_form(const Power_polynomial& p, Expansion_budget& budget)
  {
    for (const auto& [monomial, coefficient] : p.terms()) {
      const Big_integer d = denominator_of(coefficient);
      if (d == 1)
        continue;
      budget.spend(arithmetic_work(bit_length(denominator) / 64.0, bit_length(d) / 64.0));
      denominator = lcm(denominator, d);
      check_coefficient_bits(bit_length(denominator));
    }
    budget.spend(static_cast<double>(p.terms().size()) * (1 + bit_length(denominator) / 64.0));
    for (const auto& [monomial, coefficient] : p.terms()) {
      monomials.push_back(&monomial);
      coefficients.push_back(numerator_of(coefficient) * (denominator / denominator_of(coefficient)));
      words = (std::max)(words, bit_length(coefficients.back()) / 64.0);
    }
  }
};

/*
Monomials as single integers: the exponents are the digits of a number in mixed radix, large enough that the digits of a
product of two do not overflow. Then monomials multiply by one integer addition.
*/
class Monomial_packing
{
  std::vector<std::pair<int, std::uint64_t>> m_radices;   // unknown, one more than its degree in the product
  bool m_fits = true;

public:
  Monomial_packing(const Power_polynomial& a, const Power_polynomial& b)
  {
    std::map<int, int> degrees = a.degrees();
    for (const auto& [variable, degree] : b.degrees())
      degrees[variable] += degree;
    std::uint64_t range = 1;
    for (const auto& [variable, degree] : degrees) {
      const std::uint64_t radix = static_cast<std::uint64_t>(degree) + 1;
      m_radices.emplace_back(variable, radix);
      m_fits = m_fits && range <= UINT64_MAX / radix;
      range *= radix;
    }
  }

  bool fits() const { return m_fits; }

  std::uint64_t packed(const Monomial& monomial) const
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

  Monomial unpacked(std::uint64_t key) const
  {
    Monomial result;
    for (auto digit = m_radices.rbegin(); digit != m_radices.rend(); key /= digit->second, ++digit)
      if (key % digit->second != 0)
        result.powers.emplace_back(digit->first, static_cast<int>(key % digit->second));
    std::reverse(result.powers.begin(), result.powers.end());
    return result;
  }
};

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

inline Exact_rational power_of_number(Exact_rational base, int exponent)
{
  Exact_rational result(1);
  for (; exponent > 0; exponent >>= 1) {
    if (exponent & 1) {
      result *= base;
      check_coefficient(result);
    }
    if (exponent > 1) {
      base *= base;
      check_coefficient(base);
    }
  }
  return result;
}

} // namespace internal

inline void Power_polynomial::add_term(const Monomial& monomial, const Exact_rational& coefficient,
                                       internal::Expansion_budget& budget)
{
  if (CGAL::is_zero(coefficient))
    return;
  const auto [position, is_new] = m_terms.try_emplace(monomial, coefficient);
  if (!is_new) {
    position->second += coefficient;
    if (CGAL::is_zero(position->second)) {
      m_terms.erase(position);
      budget.spend(1);
      return;
    }
  }
  const double words = internal::size_in_words(position->second);
  // 4: the tree's node
  budget.spend(4 + internal::arithmetic_work(words, words) + static_cast<double>(monomial.powers.size()) / 2);
  if (words > maximal_coefficient_bits / 64)
    internal::check_coefficient(position->second);
  internal::check_number_of_terms(m_terms.size());
}

inline Power_polynomial& Power_polynomial::add(Power_polynomial other, internal::Expansion_budget& budget)
{
  if (m_terms.size() < other.m_terms.size())
    m_terms.swap(other.m_terms);
  for (const auto& [monomial, coefficient] : other.m_terms)
    add_term(monomial, coefficient, budget);
  return *this;
}

inline void Power_polynomial::negate(internal::Expansion_budget& budget)
{
  budget.spend(static_cast<double>(m_terms.size()));
  for (auto& [monomial, coefficient] : m_terms)
    coefficient = -coefficient;
}

inline Power_polynomial& Power_polynomial::divide(const Power_polynomial& divisor, internal::Expansion_budget& budget)
{
  if (!divisor.is_constant())
    throw Invalid_input("Power_polynomial: division by a polynomial that is not a constant");
  if (divisor.is_zero())
    throw Invalid_input("Power_polynomial: division by zero");
  *this = times_term(Monomial(), Exact_rational(Exact_rational(1) / divisor.constant_term()), budget);
  return *this;
}

inline Power_polynomial Power_polynomial::times_term(const Monomial& monomial, const Exact_rational& coefficient,
                                                     internal::Expansion_budget& budget) const
{
  const long long degree = monomial.total_degree();
  const double words = internal::size_in_words(coefficient);
  Power_polynomial result;
  for (const auto& [own_monomial, own_coefficient] : m_terms) {
    internal::check_degree(degree + own_monomial.total_degree());
    budget.spend(internal::arithmetic_work(words, internal::size_in_words(own_coefficient)));
    result.add_term(own_monomial * monomial, Exact_rational(own_coefficient * coefficient), budget);
  }
  return result;
}

inline Power_polynomial Power_polynomial::product(const Power_polynomial& a, const Power_polynomial& b,
                                                  internal::Expansion_budget& budget)
{
  if (a.is_zero() || b.is_zero())
    return Power_polynomial();
  if (a.m_terms.size() == 1)
    return b.times_term(a.m_terms.begin()->first, a.m_terms.begin()->second, budget);
  if (b.m_terms.size() == 1)
    return a.times_term(b.m_terms.begin()->first, b.m_terms.begin()->second, budget);
  internal::check_degree(static_cast<long long>(a.total_degree()) + b.total_degree());

  const internal::Integer_form f(a, budget), g(b, budget);
  const internal::Monomial_packing packing(a, b);
  const double pairs = static_cast<double>(a.m_terms.size()) * static_cast<double>(b.m_terms.size());
  budget.spend(pairs * (internal::arithmetic_work(f.words, g.words) + (packing.fits() ? 0 : 10)));
  const internal::Big_integer denominator = f.denominator * g.denominator;

  Power_polynomial result;
  if (packing.fits()) {
    std::vector<std::uint64_t> keys_a, keys_b;
    for (const Monomial* monomial : f.monomials)
      keys_a.push_back(packing.packed(*monomial));
    for (const Monomial* monomial : g.monomials)
      keys_b.push_back(packing.packed(*monomial));
    std::unordered_map<std::uint64_t, internal::Big_integer> sums;
    internal::add_products(sums, f, g, [&](std::size_t i, std::size_t j) { return keys_a[i] + keys_b[j]; });
    for (const auto& [key, sum] : sums)
      result.add_term(packing.unpacked(key), internal::quotient(sum, denominator), budget);
  } else {
    std::map<Monomial, internal::Big_integer> sums;
    internal::add_products(sums, f, g, [&](std::size_t i, std::size_t j) { return *f.monomials[i] * *g.monomials[j]; });
    for (const auto& [monomial, sum] : sums)
      result.add_term(monomial, internal::quotient(sum, denominator), budget);
  }
  return result;
}

inline Power_polynomial Power_polynomial::power(const Power_polynomial& base, int exponent,
                                                internal::Expansion_budget& budget)
{
  if (exponent < 0)
    throw Invalid_input("Power_polynomial: negative exponent " + std::to_string(exponent));
  if (exponent == 0)
    return Power_polynomial(1);
  internal::check_degree(static_cast<long long>(base.total_degree()) * exponent);
  Power_polynomial result;
  if (base.m_terms.size() <= 1) {
    for (const auto& [monomial, coefficient] : base.m_terms) {
      Monomial raised = monomial;
      for (auto& power_of_unknown : raised.powers)
        power_of_unknown.second *= exponent;
      result.add_term(raised, internal::power_of_number(coefficient, exponent), budget);
    }
    return result;
  }
  bool has_result = false;
  for (Power_polynomial square = base;; square = product(square, square, budget)) {
    if (exponent & 1) {
      result = has_result ? product(result, square, budget) : square;
      has_result = true;
    }
    exponent >>= 1;
    if (exponent == 0)
      return result;
  }
}

inline Power_polynomial Power_polynomial::derivative(int variable) const
{
  internal::Expansion_budget budget = default_budget();
  Power_polynomial result;
  for (const auto& [monomial, coefficient] : m_terms)
    if (const int exponent = monomial.exponent(variable); exponent > 0)
      result.add_term(monomial.with_exponent(variable, exponent - 1),
                      Exact_rational(coefficient * Exact_rational(exponent)), budget);
  return result;
}

template <class NT>
NT Power_polynomial::value(std::span<const NT> point) const
{
  if (const int last = largest_variable(); last >= 0 && static_cast<std::size_t>(last) >= point.size())
    throw Invalid_input("Power_polynomial: a point of " + std::to_string(point.size()) + " coordinates, but unknown "
                        + std::to_string(last) + " occurs");
  std::map<std::pair<int, int>, NT> powers;   // each power of a coordinate is computed once
  NT result(Exact_rational(0));
  for (const auto& [monomial, coefficient] : m_terms) {
    NT value(coefficient);
    for (const auto& power_of_unknown : monomial.powers) {
      auto position = powers.find(power_of_unknown);
      if (position == powers.end()) {
        NT power(Exact_rational(1)), square(point[static_cast<std::size_t>(power_of_unknown.first)]);
        for (int rest = power_of_unknown.second; rest > 0; rest >>= 1) {
          if (rest & 1)
            power *= square;
          if (rest > 1)
            square *= square;
        }
        position = powers.emplace(power_of_unknown, power).first;
      }
      value *= position->second;
    }
    result += value;
  }
  return result;
}

inline Power_polynomial Power_polynomial::substituted(int variable, const Power_polynomial& replacement) const
{
  internal::Expansion_budget budget = default_budget();
  std::map<int, Power_polynomial> by_exponent;
  for (const auto& [monomial, coefficient] : m_terms)
    by_exponent[monomial.exponent(variable)].add_term(monomial.with_exponent(variable, 0), coefficient, budget);
  // Horner's scheme over the exponents that occur.
  Power_polynomial result;
  int exponent = by_exponent.empty() ? 0 : by_exponent.rbegin()->first;
  for (auto summand = by_exponent.rbegin(); summand != by_exponent.rend(); ++summand) {
    result = product(result, power(replacement, exponent - summand->first, budget), budget);
    result.add(std::move(summand->second), budget);
    exponent = summand->first;
  }
  return product(result, power(replacement, exponent, budget), budget);
}

inline std::string Power_polynomial::to_string(std::span<const std::string> names) const
{
  if (const int last = largest_variable(); last >= 0 && static_cast<std::size_t>(last) >= names.size())
    throw Invalid_input("Power_polynomial: " + std::to_string(names.size()) + " names, but unknown " +
                        std::to_string(last) + " occurs");
  std::ostringstream out;
  out.imbue(std::locale::classic());
  for (const auto& [monomial, coefficient] : m_terms) {
    const bool is_negative = CGAL::is_negative(coefficient);
    if (&coefficient == &m_terms.begin()->second)
      out << (is_negative ? "-" : "");
    else
      out << (is_negative ? " - " : " + ");
    const Exact_rational size = is_negative ? Exact_rational(-coefficient) : coefficient;
    const bool shows_coefficient = monomial.powers.empty() || size != Exact_rational(1);
    if (shows_coefficient)
      out << internal::numerator_of(size);
    if (const internal::Big_integer denominator = internal::denominator_of(size); denominator != 1)
      out << '/' << denominator;
    for (std::size_t i = 0; i < monomial.powers.size(); ++i) {
      out << (i > 0 || shows_coefficient ? "*" : "") << names[static_cast<std::size_t>(monomial.powers[i].first)];
      if (monomial.powers[i].second > 1)
        out << '^' << monomial.powers[i].second;
    }
  }
  return m_terms.empty() ? "0" : out.str();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POWER_POLYNOMIAL_IMPL_H
