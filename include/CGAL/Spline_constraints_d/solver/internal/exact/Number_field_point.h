// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_NUMBER_FIELD_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_NUMBER_FIELD_POINT_H

#include <CGAL/Spline_constraints_d/solver/internal/exact/Algebraic_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/integer_relation.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial in one number t, modulo a polynomial q that is zero there: if it is zero, so is the number. Rationals
// come without q.
class Residue
{
  using Coefficients = std::vector<Exact_rational>;   // of 1, t, t^2, ...; of q without the leading one, which is 1

  std::shared_ptr<const Coefficients> m_modulus;
  Coefficients m_coefficients;

public:
  explicit Residue(const Exact_rational& x) : m_coefficients{x} {}
  Residue(Coefficients coefficients, std::shared_ptr<const Coefficients> modulus)
    : m_modulus(std::move(modulus)), m_coefficients(std::move(coefficients))
  {}

  bool is_zero() const
  {
    return std::all_of(m_coefficients.begin(), m_coefficients.end(), [](const Exact_rational& c) { return c == 0; });
  }

  Residue& operator+=(const Residue& other)
  {
    take_modulus(other);
    m_coefficients.resize((std::max)(m_coefficients.size(), other.m_coefficients.size()));
    for (std::size_t i = 0; i < other.m_coefficients.size(); ++i)
      m_coefficients[i] += other.m_coefficients[i];
    return *this;
  }

  Residue& operator*=(const Residue& other)
  {
    take_modulus(other);
    Coefficients product(m_coefficients.size() + other.m_coefficients.size() - 1);
    for (std::size_t i = 0; i < m_coefficients.size(); ++i)
      for (std::size_t j = 0; j < other.m_coefficients.size(); ++j)
        product[i + j] += m_coefficients[i] * other.m_coefficients[j];
    for (; m_modulus && product.size() > m_modulus->size(); product.pop_back())
      for (std::size_t i = 0, shift = product.size() - 1 - m_modulus->size(); i < m_modulus->size(); ++i)
        product[i + shift] -= product.back() * (*m_modulus)[i];
    m_coefficients = std::move(product);
    return *this;
  }

  // The range of the number, for a range of t.
  Mpfr_interval value(const Mpfr_interval& t) const
  {
    Mpfr_interval result(0);
    for (auto c = m_coefficients.rbegin(); c != m_coefficients.rend(); ++c)
      result = result * t + Mpfr_interval(*c);
    return result;
  }

private:
  void take_modulus(const Residue& other)
  {
    if (!m_modulus)
      m_modulus = other.m_modulus;
  }
};

/*
A point whose coordinates are polynomials in one of them, which is a root of a polynomial q of low degree in a range
where q changes its sign. At such a point it is decided exactly, and soon, that a polynomial is zero.
*/
class Number_field_point
{
  static constexpr int m_most_degree = 6;
  static constexpr long m_bits_of_term = 96;   // coefficients of half as many bits are found

  std::vector<Residue> m_coordinates;

public:
  // Guesses the polynomials from many digits of a root. The point lies in the region of the root; whether it is the
  // root, the caller has to prove.
  static std::optional<Number_field_point> near(Algebraic_root& root)
  {
    const long bits = m_bits_of_term * (m_most_degree + 2);
    if (!root.refine(bits + 64))
      return std::nullopt;
    const Mpfr_precision_scope scope(bits + 64);
    const Exact_box box = root.box();
    std::vector<Exact_rational> point, polynomial;
    for (const auto& [lower, upper] : box)
      point.push_back(Exact_rational((lower + upper) / 2));
    std::size_t axis = 0;   // with the polynomial of the highest degree
    for (std::size_t j = 0; j < point.size(); ++j) {
      const auto own = polynomial_of(point[j]);
      if (own.empty())
        return std::nullopt;
      if (own.size() > polynomial.size()) {
        polynomial = own;
        axis = j;
      }
    }
    if (value_of(polynomial, box[axis].first) * value_of(polynomial, box[axis].second) > 0)
      return std::nullopt;
    const int degree = static_cast<int>(polynomial.size()) - 1;
    polynomial.pop_back();
    const auto modulus = std::make_shared<const std::vector<Exact_rational>>(std::move(polynomial));
    Number_field_point result;
    for (std::size_t j = 0; j < point.size(); ++j) {
      std::vector<Exact_rational> coordinate{Exact_rational(0), Exact_rational(1)};
      if (j != axis || degree == 1)
        coordinate = coefficients_of(point[j], point[axis], degree);
      if (coordinate.empty())
        return std::nullopt;
      result.m_coordinates.emplace_back(std::move(coordinate), modulus);
      const Mpfr_interval range = result.m_coordinates.back().value(Mpfr_interval(box[axis].first, box[axis].second));
      if (!range.is_bounded() || range.lower() < root.region()[j].first || root.region()[j].second < range.upper())
        return std::nullopt;
    }
    return result;
  }

  bool is_zero_of(const Power_polynomial& polynomial) const
  {
    return polynomial.value(std::span<const Residue>(m_coordinates)).is_zero();
  }

private:
  static std::vector<Exact_rational> powers_of(const Exact_rational& t, int degree)
  {
    std::vector<Exact_rational> result{Exact_rational(1)};
    for (int i = 0; i < degree; ++i)
      result.push_back(Exact_rational(result.back() * t));
    return result;
  }

  static Exact_rational value_of(const std::vector<Exact_rational>& polynomial, const Exact_rational& t)
  {
    Exact_rational result(0);
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c)
      result = result * t + *c;
    return result;
  }

  // The monic polynomial of least degree that seems to be zero at a number; empty when none is found.
  static std::vector<Exact_rational> polynomial_of(const Exact_rational& t)
  {
    for (int degree = 1; degree <= m_most_degree; ++degree) {
      const auto relation = integer_relation(powers_of(t, degree), m_bits_of_term * (degree + 1));
      if (!relation.empty() && relation.back() != 0)
        return quotients(relation, relation.back(), degree + 1);
    }
    return {};
  }

  // Those of the polynomial in t of less than a degree that seems to be x; empty when none is found.
  static std::vector<Exact_rational> coefficients_of(const Exact_rational& x, const Exact_rational& t, int degree)
  {
    std::vector<Exact_rational> numbers = powers_of(t, degree - 1);
    numbers.push_back(x);
    const auto relation = integer_relation(numbers, m_bits_of_term * (degree + 1));
    return relation.empty() || relation.back() == 0 ? std::vector<Exact_rational>()
                                                    : quotients(relation, Big_integer(-relation.back()), degree);
  }

  static std::vector<Exact_rational> quotients(const std::vector<Big_integer>& numerators,
                                               const Big_integer& denominator, int count)
  {
    std::vector<Exact_rational> result;
    for (int i = 0; i < count; ++i)
      result.push_back(quotient(numerators[i], denominator));
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_NUMBER_FIELD_POINT_H
