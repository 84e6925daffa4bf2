// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SUM_OF_PRODUCTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SUM_OF_PRODUCTS_H

#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

#ifdef __SIZEOF_INT128__
#define CGAL_SPLINE_CONSTRAINTS_D_HAS_WIDE_INTEGER 1
__extension__ typedef __int128 Wide_integer;

inline void add_product(Wide_integer& sum, Wide_integer a, Wide_integer b) { sum += a * b; }

// \pre |value| < 2^127
inline void convert(const Big_integer& value, Wide_integer& result)
{
  std::uint64_t words[2] = {0, 0};
  mpz_export(words, nullptr, -1, sizeof(std::uint64_t), 0, 0, value.backend().data());
  result = static_cast<Wide_integer>(words[1]) << 64 | static_cast<Wide_integer>(words[0]);
  if (value < 0)
    result = -result;
}

// Sets a big integer, in place.
inline void assign(mpz_ptr target, Wide_integer value)
{
  const bool is_negative = value < 0;
  const Wide_integer absolute = is_negative ? -value : value;
  const std::uint64_t words[2] = {static_cast<std::uint64_t>(absolute), static_cast<std::uint64_t>(absolute >> 64)};
  mpz_import(target, words[1] == 0 ? 1 : 2, -1, sizeof(std::uint64_t), 0, 0, words);
  if (is_negative)
    mpz_neg(target, target);
}
#endif

inline void convert(const Big_integer& value, Big_integer& result) { result = value; }
inline void assign(mpz_ptr target, const Big_integer& value) { mpz_set(target, value.backend().data()); }

// Rationals that are these integers; without temporaries where the type allows it, since allocations are most of the
// cost of an expansion.
template <class Rational, class Integer>
std::vector<Rational> to_rationals(const std::vector<Integer>& integers)
{
  std::vector<Rational> result(integers.size());
  for (std::size_t i = 0; i < integers.size(); ++i) {
    if constexpr (Writable_as_mpq<Rational>)
      assign(mpq_numref(writable_mpq_of(result[i])), integers[i]);
    else {
      Big_integer integer;
      assign(integer.backend().data(), integers[i]);
      result[i] = scaled_rational<Rational>(integer, 0);
    }
  }
  return result;
}

/*
A sum of products sum_i s_i a_i (x) b_i (x) ... of vectors of integers, one of each factor. The products of the last
factors are summed first, for each vector of the factors before them, so that the whole result is passed only once for
each distinct vector of the first factor.
*/
class Sum_of_products
{
public:
  struct Factor
  {
    std::size_t length;
    std::vector<std::vector<Big_integer>> vectors;
  };

  struct Product
  {
    std::vector<std::size_t> vectors;   // of each factor
    Big_integer scale;
  };

private:
  const std::vector<Factor>& m_factors;
  std::vector<Product> m_products;   // in lexicographic order

public:
  Sum_of_products(const std::vector<Factor>& factors, std::vector<Product> products)
    : m_factors(factors), m_products(std::move(products))
  {
    std::sort(m_products.begin(), m_products.end(),
              [](const Product& a, const Product& b) { return a.vectors < b.vectors; });
  }

  // A number of bits that no sum exceeds in absolute value, with or without the first factors: nonzero integers are at
  // least one.
  long bits() const
  {
    std::vector<std::vector<long>> lengths;
    for (const Factor& factor : m_factors) {
      auto& of_vectors = lengths.emplace_back();
      for (const auto& vector : factor.vectors) {
        long most = 1;
        for (const Big_integer& x : vector)
          most = (std::max)(most, bit_length(x));
        of_vectors.push_back(most);
      }
    }
    long most = 0;
    for (const Product& product : m_products) {
      long sum = bit_length(product.scale);
      for (std::size_t f = 0; f < product.vectors.size(); ++f)
        sum += lengths[f][product.vectors[f]];
      most = (std::max)(most, sum);
    }
    return most + bit_length(Big_integer(m_products.size()));
  }

  // The vector of the whole sum, the last factor fastest.
  template <class Integer>
  std::vector<Integer> sum(Interruption& interruption) const
  {
    std::vector<std::vector<std::vector<Integer>>> factors;
    for (const Factor& factor : m_factors) {
      auto& vectors = factors.emplace_back();
      for (const auto& vector : factor.vectors) {
        auto& converted = vectors.emplace_back(vector.size());
        for (std::size_t i = 0; i < vector.size(); ++i)
          convert(vector[i], converted[i]);
      }
    }
    return sum(factors, 0, m_products.data(), m_products.data() + m_products.size(), interruption);
  }

private:
  template <class Integer>
  std::vector<Integer> sum(const std::vector<std::vector<std::vector<Integer>>>& factors, std::size_t level,
                           const Product* first, const Product* last, Interruption& interruption) const
  {
    if (level == factors.size()) {
      Integer scale;
      convert(first->scale, scale);
      return {scale};
    }
    std::size_t rest = 1;
    for (std::size_t f = level + 1; f < m_factors.size(); ++f)
      rest *= m_factors[f].length;
    std::vector<Integer> result(m_factors[level].length * rest, Integer(0));
    while (first != last) {
      const Product* next = first;
      while (next != last && next->vectors[level] == first->vectors[level])
        ++next;
      const std::vector<Integer> inner = sum(factors, level + 1, first, next, interruption);
      Integer* target = result.data();
      for (const Integer& x : factors[level][first->vectors[level]]) {
        if (x != 0)
          for (std::size_t k = 0; k < rest; ++k)
            add_product(target[k], x, inner[k]);
        target += rest;
        interruption.add_work(rest);
      }
      first = next;
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SUM_OF_PRODUCTS_H
