// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_LEFT_COMPONENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_LEFT_COMPONENTS_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/modular_common_divisor.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The pencil of polynomials that are multiples of p plus multiples of q: all functions that are fractional linear ones of
p/q have the same. Its normal form: q has a lower degree than p, which has no term of that degree; both are primitive,
with positive leading coefficients. The matrix takes the given pair there.
*/
struct Pencil
{
  Integer_coefficients p, q;
  std::array<Big_integer, 4> matrix{1, 0, 0, 1}; // p = m0 a + m1 b, q = m2 a + m3 b, for the given a and b

  // \pre They are linearly independent.
  Pencil(Integer_coefficients a, Integer_coefficients b) : p(std::move(a)), q(std::move(b))
  {
    if (p.size() < q.size())
      exchange();
    if (p.size() == q.size())
      combine(q, p, {2, 3}, {0, 1}, p.size() - 1);
    combine(p, q, {0, 1}, {2, 3}, q.size() - 1);
    make_primitive(p, {0, 1});
    make_primitive(q, {2, 3});
  }

  Polynomial_quotient function() const { return Polynomial_quotient(p, q); }

  // The fractional linear function that takes a/b to p/q.
  Polynomial_quotient of_given() const
  {
    return Polynomial_quotient(Integer_coefficients{matrix[1], matrix[0]}, Integer_coefficients{matrix[3], matrix[2]});
  }

private:
  using Row = std::array<std::size_t, 2>;

  void exchange()
  {
    std::swap(p, q);
    std::swap(matrix[0], matrix[2]);
    std::swap(matrix[1], matrix[3]);
  }

  // Takes the term of a degree, in which g has one, out of f.
  void combine(Integer_coefficients& f, const Integer_coefficients& g, Row row, Row other, std::size_t degree)
  {
    const Big_integer of_g = g[degree], of_f = f[degree];
    for (Big_integer& x : f)
      x *= of_g;
    add_multiple(f, g, Big_integer(-of_f));
    f = trimmed(std::move(f));
    for (std::size_t k = 0; k < 2; ++k)
      matrix[row[k]] = matrix[row[k]] * of_g - matrix[other[k]] * of_f;
  }

  // The numbers that they are divided by are kept in the other row: only the quotient of both rows counts.
  void make_primitive(Integer_coefficients& f, Row row)
  {
    Big_integer content(0);
    for (const Big_integer& x : f)
      content = gcd(content, x);
    if (f.back() < 0)
      content = -content;
    for (Big_integer& x : f)
      mpz_divexact(x.backend().data(), x.backend().data(), content.backend().data());
    const std::size_t first = row[0] == 0 ? 2 : 0;
    matrix[first] *= content;
    matrix[first + 1] *= content;
  }
};

/*
The polynomials g with f = sum_i g_i p^i q^(r-i), for polynomials f of degree at most r times that of p. The degrees of
these products increase with i, so that the coefficients are found from the top.
*/
class Left_components
{
  Pencil m_pencil;
  std::vector<Integer_coefficients> m_products;

public:
  Left_components(const Pencil& pencil, std::size_t degree) : m_pencil(pencil)
  {
    const std::vector<Integer_coefficients> p = powers_of(pencil.p, degree + 1), q = powers_of(pencil.q, degree + 1);
    for (std::size_t i = 0; i <= degree; ++i)
      m_products.push_back(product_of(p[i], q[degree - i]));
  }

  std::optional<std::vector<Exact_rational>> operator()(const Integer_coefficients& f) const
  {
    std::vector<Exact_rational> rest;
    for (const Big_integer& x : f)
      rest.push_back(scaled_rational(x, 0));
    std::vector<Exact_rational> result(m_products.size(), Exact_rational(0));
    for (std::size_t i = m_products.size(); i-- > 0;) {
      const Integer_coefficients& product = m_products[i];
      for (std::size_t k = product.size(); k < rest.size(); ++k)
        if (rest[k] != 0)
          return std::nullopt;
      if (rest.size() < product.size())
        continue;
      rest.resize(product.size());
      result[i] = rest.back() / scaled_rational(product.back(), 0);
      if (result[i] != 0)
        for (std::size_t k = 0; k < product.size(); ++k)
          rest[k] -= result[i] * scaled_rational(product[k], 0);
    }
    if (std::any_of(rest.begin(), rest.end(), [](const Exact_rational& x) { return x != 0; }))
      return std::nullopt;
    return result;
  }
};

// Whether there are such ones modulo a prime: if not, there are none.
inline bool has_left_component_modulo(const Prime_residues& field, const Pencil& pencil, std::size_t degree,
                                      const std::array<Integer_coefficients, 2>& polynomials)
{
  using Polynomial = Prime_residues::Polynomial;
  const Polynomial p = field.of(pencil.p), q = field.of(pencil.q);
  if (p.size() < pencil.p.size() || q.size() < pencil.q.size())
    return true; // the prime says nothing
  std::vector<Polynomial> powers_of_p(1, Polynomial{1}), powers_of_q(1, Polynomial{1}), products;
  for (std::size_t i = 0; i < degree; ++i) {
    powers_of_p.push_back(field.product(powers_of_p.back(), p));
    powers_of_q.push_back(field.product(powers_of_q.back(), q));
  }
  for (std::size_t i = 0; i <= degree; ++i)
    products.push_back(field.product(powers_of_p[i], powers_of_q[degree - i]));
  return std::all_of(polynomials.begin(), polynomials.end(), [&](const Integer_coefficients& f) {
    Polynomial rest = field.of(f);
    for (std::size_t i = products.size(); i-- > 0;) {
      if (rest.size() > products[i].size())
        return false;
      if (rest.size() == products[i].size())
        field.add_multiple(rest, products[i],
                           field.prime() - rest.back() * field.inverse(products[i].back()) % field.prime());
    }
    return rest.empty();
  });
}

// The function g with f = g o (p/q), if there is one.
inline std::optional<Polynomial_quotient> left_component(const Polynomial_quotient& f, const Pencil& pencil)
{
  const auto n = static_cast<std::size_t>(f.degree()), k = pencil.p.size() - 1;
  if (k == 0 || n % k != 0)
    return std::nullopt;
  static const Prime_residues field(0x7fffffff);
  if (!has_left_component_modulo(field, pencil, n / k, {f.numerator_coefficients(), f.denominator_coefficients()}))
    return std::nullopt;
  const Left_components components(pencil, n / k);
  const auto above = components(f.numerator_coefficients()), below = components(f.denominator_coefficients());
  if (!above || !below)
    return std::nullopt;
  std::vector<Integer_coefficients> both = with_integers({*above, *below});
  return Polynomial_quotient(std::move(both[0]), std::move(both[1]));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_LEFT_COMPONENTS_H
