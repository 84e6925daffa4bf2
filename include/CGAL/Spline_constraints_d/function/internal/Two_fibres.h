// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_TWO_FIBRES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_TWO_FIBRES_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/decompositions_declarations.h>
#include <CGAL/Spline_constraints_d/function/internal/integer_factors_declarations.h>
#include <CGAL/Spline_constraints_d/function/internal/left_components.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The parameters with the same value as a rational number a, as the zeros of a polynomial with the full degree, and its
factors. Where f = g o h and h(a) = 0, that is a fractional linear function away, the numerator of h divides this
polynomial, has the degree of h, and a as a zero.
*/
class Fibre
{
  std::size_t m_degree;
  std::vector<Integer_factor> m_factors; // the first one is that of a

public:
  Fibre(const Integer_coefficients& polynomial, const Exact_rational& a, Interruption& interruption)
    : m_degree(polynomial.size() - 1), m_factors(integer_factors(polynomial, interruption))
  {
    const Integer_coefficients linear{Big_integer(-numerator_of(a)), denominator_of(a)};
    const auto own = std::find_if(m_factors.begin(), m_factors.end(),
                                  [&](const Integer_factor& factor) { return factor.polynomial == linear; });
    std::rotate(m_factors.begin(), own, own + 1);
  }

  // How many divisors have a as a zero, by their degrees.
  std::vector<double> numbers_of_divisors() const
  {
    std::vector<double> result(m_degree + 1, 0);
    result[0] = 1;
    for (const Integer_factor& factor : m_factors) {
      const std::size_t degree = factor.polynomial.size() - 1;
      std::vector<double> next(m_degree + 1, 0);
      for (int k = &factor == &m_factors.front() ? 1 : 0; k <= factor.multiplicity; ++k)
        for (std::size_t i = 0; i + k * degree <= m_degree; ++i)
          next[i + k * degree] += result[i];
      result = std::move(next);
    }
    return result;
  }

  // Those of one degree.
  std::vector<Integer_coefficients> divisors(std::size_t degree) const
  {
    std::vector<Integer_coefficients> result;
    add_divisors(0, degree, Integer_coefficients(1, Big_integer(1)), result);
    return result;
  }

private:
  void add_divisors(std::size_t first, std::size_t degree, const Integer_coefficients& product,
                    std::vector<Integer_coefficients>& result) const
  {
    if (first == m_factors.size()) {
      if (degree == 0)
        result.push_back(product);
      return;
    }
    const Integer_factor& factor = m_factors[first];
    const std::size_t own = factor.polynomial.size() - 1;
    Integer_coefficients extended = product;
    for (int k = 0; k <= factor.multiplicity && k * own <= degree; ++k) {
      if (k > 0)
        extended = product_of(extended, factor.polynomial);
      if (first > 0 || k > 0)
        add_divisors(first + 1, degree - k * own, extended, result);
    }
  }
};

/*
All f = g o h with proper h, up to fractional linear functions between them: one can choose h to have a zero at a number
a and a pole at b, if f is different there. Then its numerator and denominator are known up to constants among the
divisors of two fibres. Fibres are added until those degrees that are left have few candidates: almost all fibres of a
function that has no such h have two factors only, as Hilbert's irreducibility theorem says.
*/
class Two_fibres
{
  struct Point
  {
    Exact_rational a, value; // the value of f, if it is no pole
    bool is_pole;
    Fibre fibre;
    std::vector<double> numbers_of_divisors;
  };

  const Polynomial_quotient& m_function;
  Interruption& m_interruption;
  std::size_t m_degree;
  std::vector<Point> m_points;
  std::vector<std::size_t> m_degrees_left; // of h
  int m_tried = 0;

public:
  Two_fibres(const Polynomial_quotient& f, Interruption& interruption)
    : m_function(f), m_interruption(interruption), m_degree(static_cast<std::size_t>(f.degree()))
  {
    for (std::size_t k = 2; 2 * k <= m_degree; ++k)
      if (m_degree % k == 0)
        m_degrees_left.push_back(k);
  }

  std::vector<Found_decomposition> operator()()
  {
    constexpr std::size_t least_points = 3, most_points = 16;
    constexpr double few_candidates = 64;
    while (!m_degrees_left.empty() && m_points.size() < most_points &&
           (m_points.size() < least_points || number_of_candidates() > few_candidates)) {
      add_point();
      std::erase_if(m_degrees_left, [&](std::size_t k) { return m_points.back().numbers_of_divisors[k] == 0; });
    }
    std::vector<Found_decomposition> result;
    for (const std::size_t k : m_degrees_left)
      add_decompositions(k, result);
    return result;
  }

private:
  // The numbers 0, 1, -1, 1/2, -1/2, 2, -2, 1/3, ..., the next one that can be taken.
  void add_point()
  {
    for (;;) {
      const Exact_rational a = small_rational(m_tried++);
      const Big_integer p = numerator_of(a), q = denominator_of(a);
      const Big_integer above = homogeneous_value(m_function.numerator_coefficients(), m_degree, p, q),
                        below = homogeneous_value(m_function.denominator_coefficients(), m_degree, p, q);
      Integer_coefficients polynomial;
      add_multiple(polynomial, m_function.numerator_coefficients(), below);
      add_multiple(polynomial, m_function.denominator_coefficients(), Big_integer(-above));
      polynomial = primitive_part(trimmed(std::move(polynomial)));
      if (polynomial.size() <= m_degree)
        continue; // the value at infinity
      const bool is_pole = below == 0;
      Fibre fibre(polynomial, a, m_interruption);
      std::vector<double> numbers = fibre.numbers_of_divisors();
      m_points.push_back(
          {a, is_pole ? Exact_rational(0) : *m_function(a), is_pole, std::move(fibre), std::move(numbers)});
      return;
    }
  }

  // The two points that leave the fewest pairs, with their number.
  std::pair<double, std::pair<const Point*, const Point*>> best_pair(std::size_t k) const
  {
    std::pair<double, std::pair<const Point*, const Point*>> result{std::numeric_limits<double>::infinity(), {}};
    for (const Point& a : m_points)
      for (const Point& b : m_points)
        if (a.is_pole != b.is_pole || a.value != b.value) {
          const double number = a.numbers_of_divisors[k] * b.numbers_of_divisors[k];
          if (number < result.first)
            result = {number, {&a, &b}};
        }
    return result;
  }

  double number_of_candidates() const
  {
    double result = 0;
    for (const std::size_t k : m_degrees_left)
      result += best_pair(k).first;
    return result;
  }

  void add_decompositions(std::size_t k, std::vector<Found_decomposition>& result)
  {
    while (best_pair(k).second.first == nullptr) // all have the same value
      add_point();
    const auto [a, b] = best_pair(k).second;
    const std::vector<Integer_coefficients> poles = b->fibre.divisors(k);
    for (const Integer_coefficients& zeros : a->fibre.divisors(k))
      for (const Integer_coefficients& below : poles) {
        m_interruption.add_work(8 * m_degree * m_degree);
        const Pencil pencil(zeros, below);
        if (std::optional<Polynomial_quotient> g = left_component(m_function, pencil))
          result.push_back({std::move(*g), pencil.function()});
      }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_TWO_FIBRES_H
