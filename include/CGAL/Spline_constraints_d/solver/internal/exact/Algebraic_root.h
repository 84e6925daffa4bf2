// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_ALGEBRAIC_ROOT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_ALGEBRAIC_ROOT_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Polynomial_jets.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/zero_bound.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <class Coordinate>
bool contains(const Coordinate_box<Coordinate>& outer, const Coordinate_box<Coordinate>& inner)
{
  for (std::size_t j = 0; j < outer.size(); ++j)
    if (inner[j].first < outer[j].first || outer[j].second < inner[j].second)
      return false;
  return true;
}

template <class Coordinate>
Coordinate_box<Coordinate> make_box(const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper)
{
  Coordinate_box<Coordinate> box;
  box.reserve(lower.size());
  for (std::size_t j = 0; j < lower.size(); ++j)
    box.emplace_back(lower[j], upper[j]);
  return box;
}

// Along the first row. Division would not do: intervals that hold zero are no pivots, and polynomials have no quotient.
template <class Number>
Number determinant_of(const std::vector<Number>& matrix, std::size_t n)
{
  if (n == 1)
    return matrix[0];
  Number sum(0);
  for (std::size_t c = 0; c < n; ++c) {
    std::vector<Number> minor;
    for (std::size_t i = 1; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (j != c)
          minor.push_back(matrix[i * n + j]);
    const Number term = matrix[c] * determinant_of(minor, n - 1);
    if (c % 2 == 0)
      sum += term;
    else
      sum -= term;
  }
  return sum;
}

/*
n equations in n unknowns: polynomials; or the first n - 1 of n polynomials and the determinant of the Jacobian of all
of them, which is zero at their multiple roots. The determinant is not expanded.
*/
class Algebraic_equations
{
  using Number = Mpfr_interval;

  std::vector<Power_polynomial> m_polynomials;
  bool m_ends_with_determinant;
  std::vector<Exact_rational> m_origin;
  std::vector<Power_polynomial> m_around_origin;   // in the differences to it; empty when there is none

public:
  // Values, and derivatives in row-major order.
  struct Values
  {
    std::vector<Number> values, jacobian;
  };

  // With integer coefficients.
  Algebraic_equations(std::vector<Power_polynomial> polynomials, bool ends_with_determinant)
    : m_polynomials(std::move(polynomials)), m_ends_with_determinant(ends_with_determinant)
  {}

  // Near an origin, the ranges of polynomials of a high degree are much narrower when they are expanded around it.
  Algebraic_equations(std::vector<Power_polynomial> polynomials, bool ends_with_determinant,
                      std::vector<Exact_rational> origin)
    : m_polynomials(std::move(polynomials)), m_ends_with_determinant(ends_with_determinant),
      m_origin(std::move(origin)), m_around_origin(m_polynomials)
  {
    for (Power_polynomial& f : m_around_origin)
      for (std::size_t j = 0; j < m_origin.size(); ++j)
        f = f.substituted(static_cast<int>(j),
                          Power_polynomial::variable(static_cast<int>(j)) + Power_polynomial(m_origin[j]));
  }

  std::size_t dimension() const { return m_polynomials.size(); }
  const std::vector<Power_polynomial>& polynomials() const { return m_polynomials; }

  Values operator()(const std::vector<Number>& box) const
  {
    const std::size_t n = dimension();
    std::vector<Number> place = box;
    for (std::size_t j = 0; j < m_origin.size(); ++j)
      place[j] -= Number(m_origin[j]);
    const Polynomial_jets jets(m_origin.empty() ? m_polynomials : m_around_origin, place,
                               m_ends_with_determinant ? 2 : 1);
    Values result;
    for (std::size_t i = 0; i < n; ++i) {
      result.values.push_back(jets.value(i));
      for (std::size_t j = 0; j < n; ++j)
        result.jacobian.push_back(jets.gradient(i, j));
    }
    if (m_ends_with_determinant) {
      const std::vector<Number> jacobian = result.jacobian;
      result.values.back() = determinant_of(jacobian, n);
      for (std::size_t k = 0; k < n; ++k) {
        Number derivative(0);
        for (std::size_t i = 0; i < n; ++i) {   // by the product rule, row by row
          std::vector<Number> matrix = jacobian;
          for (std::size_t j = 0; j < n; ++j)
            matrix[i * n + j] = jets.hessian(i, j, k);
          derivative += determinant_of(matrix, n);
        }
        result.jacobian[(n - 1) * n + k] = derivative;
      }
    }
    return result;
  }

  // The sizes that the zero bound needs; those of the determinant follow from those of the polynomials.
  Polynomial_size size() const
  {
    const std::size_t n = dimension();
    Polynomial_size result, determinant;
    for (std::size_t i = 0; i < n; ++i) {
      const Polynomial_size own = size_of(m_polynomials[i]);
      if (!m_ends_with_determinant || i + 1 < n)
        result = larger(result, own);
      determinant.degree += (std::max)(own.degree - 1, 0);
      // each entry of a row: derivatives of one polynomial
      determinant.bits += own.bits + std::log2((std::max)(own.degree, 1));
      determinant.bits += std::log2(static_cast<double>(i + 1));             // of n! products
    }
    return m_ends_with_determinant ? larger(result, determinant) : result;
  }
};

/*
A regular real root of n equations in n unknowns, the only one in the box that it was found in: its enclosure can be
made as narrow as is asked for, and the sign of a polynomial at the root is decided, zero as well: a polynomial that is
not zero there is larger than the `zero_bound()`.
*/
class Algebraic_root
{
  using Number = Mpfr_interval;

  // Beyond this a sign takes seconds. Where zero would take more, a few bits are tried for another sign.
  static constexpr double m_most_bits = 1 << 16, m_few_bits = 1 << 11;

  Algebraic_equations m_equations;
  std::vector<Number> m_box;
  Exact_box m_region;
  double m_contraction = 0;
  CGAL::Sign m_orientation = CGAL::ZERO;

  Algebraic_root(Algebraic_equations equations, std::vector<Number> box)
    : m_equations(std::move(equations)), m_box(std::move(box))
  {}

public:
  // Proves by Krawczyk's operator that there is one root in the box; nothing when that fails.
  static std::optional<Algebraic_root> in(const Algebraic_equations& equations, const Exact_box& box)
  {
    long bits = 256;
    // values are as small as the box times the smallest slope, which near another root is as small as the box
    for (const auto& [lower, upper] : box)
      bits = (std::max)(bits, 256 + 3 * bit_length(denominator_of(Exact_rational(upper - lower))));
    const Mpfr_precision_scope scope(bits);
    std::vector<Number> numbers;
    for (const auto& [lower, upper] : box)
      numbers.emplace_back(lower, upper);
    Algebraic_root root(equations, std::move(numbers));
    const auto image = root.krawczyk_image(bits);
    if (!image)
      return std::nullopt;
    for (std::size_t j = 0; j < box.size(); ++j)
      if (image->box[j].lower() <= box[j].first || box[j].second <= image->box[j].upper())
        return std::nullopt;
    const auto orientation = determinant_of(root.m_equations(root.m_box).jacobian, box.size()).sign();
    if (!orientation.is_certain())
      return std::nullopt;
    root.m_orientation = orientation.make_certain();
    root.m_box = image->box;
    root.m_contraction = image->contraction;
    root.m_region = box;
    return root;
  }

  // A few steps of Newton's method: a guess of a root, with some bits.
  static std::vector<Exact_rational> guess(const Algebraic_equations& equations, std::vector<Exact_rational> point,
                                           int bits = 256)
  {
    const std::size_t n = point.size();
    const Mpfr_precision_scope scope(bits);
    for (int step = 0, steps = 10; step < steps; ++step) {
      const auto at_point = equations(std::vector<Number>(point.begin(), point.end()));
      const std::vector<Number> inverse = inverse_of_middle(at_point.jacobian, n);
      if (inverse.empty())
        return {};
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k)
          point[i] -= Number(inverse[i * n + k] * at_point.values[k]).midpoint();
      for (Exact_rational& x : point)
        x = round_to_dyadic(x, bits);
    }
    return point;
  }

  // The largest sum of a row of |I - C J| on the box of the proof, with its radii as weights.
  double contraction() const { return m_contraction; }

  // The sign of the determinant of the Jacobian of the equations on this box.
  CGAL::Sign orientation() const { return m_orientation; }

  // The box in which it was proved to be alone.
  const Exact_box& region() const { return m_region; }

  // An enclosure, narrower after each refinement.
  Exact_box box() const
  {
    Exact_box result;
    for (const Number& x : m_box)
      result.emplace_back(x.lower(), x.upper());
    return result;
  }

  // It is not wider than 2^-bits; `bits_of_point` when it is one point.
  static constexpr long bits_of_point = 1L << 20;

  long bits_of_width() const
  {
    double result = bits_of_point;
    for (const Number& x : m_box)
      result = (std::min)(result, bits_of_size(x - x));
    return static_cast<long>(result);
  }

  // Every number in x has at least so many zeros behind the binary point.
  static double bits_of_size(const Number& x)
  {
    const auto of_end = [](mpfr_srcptr end) {
      return mpfr_zero_p(end) ? HUGE_VAL : mpfr_number_p(end) ? -static_cast<double>(mpfr_get_exp(end)) : -HUGE_VAL;
    };
    return (std::min)(of_end(x.lower_mpfr()), of_end(x.upper_mpfr()));
  }

  // Until the box is not wider than 2^-bits. False when rounding does not let it become so narrow.
  bool refine(long bits)
  {
    for (long reached = bits_of_width(); reached < (std::min)(bits, bits_of_point);) {
      const long precision = (std::min)(2 * (std::max)(reached, 32L), bits) + 96;
      const Mpfr_precision_scope scope(precision);
      const auto image = krawczyk_image(precision);
      if (!image)
        return false;
      for (std::size_t j = 0; j < m_box.size(); ++j)
        m_box[j] = intersection(m_box[j], image->box[j]);
      const long next = bits_of_width();
      if (next < reached + 4)
        return false;
      reached = next;
    }
    return true;
  }

  // The range of a polynomial on the enclosure.
  Number value_of(const Power_polynomial& polynomial) const
  {
    const Mpfr_precision_scope scope(m_box.front().precision() + 384);
    return Polynomial_jets(std::span<const Power_polynomial>(&polynomial, 1), m_box, 0).value(0);
  }

  // Of a polynomial at the root; nothing when that would take too many bits, or is stopped.
  std::optional<CGAL::Sign> sign_of(const Power_polynomial& polynomial, const std::function<bool()>& must_stop = {})
  {
    if (polynomial.is_constant())
      return CGAL::sign(polynomial.constant_term());
    const auto scaled = with_integer_coefficients(polynomial);
    if (!scaled)
      return std::nullopt;
    const double bound = zero_bound_bits(m_equations.dimension(), larger(m_equations.size(), size_of(*scaled)));
    const double last = bound + size_of(*scaled).bits + 64;   // the value is about as small as the box is narrow
    const double most = last <= m_most_bits ? last : m_few_bits;
    for (double bits = 256; bits <= most; bits = (std::min)(2 * bits, last)) {
      if ((must_stop && must_stop()) || !refine(static_cast<long>(bits)))
        return std::nullopt;
      const Number value = value_of(*scaled);
      if (const auto sign = value.sign(); sign.is_certain())
        return sign.make_certain();
      if (bits_of_size(value) > bound)
        return CGAL::ZERO;
      if (bits >= last)
        return std::nullopt;
    }
    return std::nullopt;
  }

  // Of numbers, whatever their rounding errors: any matrix near the inverse serves.
  static std::vector<Number> inverse_of_middle(const std::vector<Number>& jacobian, std::size_t n)
  {
    std::vector<Number> rows(2 * n * n, Number(0));
    for (std::size_t i = 0; i < n; ++i) {
      rows[2 * n * i + n + i] = Number(1);
      for (std::size_t j = 0; j < n; ++j) {
        if (!jacobian[i * n + j].is_bounded())
          return {};
        rows[2 * n * i + j] = Number(jacobian[i * n + j].midpoint());
      }
    }
    const std::vector<int> row_of = gauss_jordan(rows, 2 * n, n, n, [](const Number& x) {
      return x.is_bounded() ? std::abs(CGAL::to_double(x.midpoint())) : 0.0;
    });
    std::vector<Number> result;
    for (std::size_t i = 0; i < n && !row_of.empty(); ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const Number& entry = rows[2 * n * row_of[i] + n + j];
        if (!entry.is_bounded())
          return {};
        result.emplace_back(entry.midpoint());
      }
    return result;
  }

private:
  static Number intersection(const Number& a, const Number& b)
  {
    const Exact_rational lower = (std::max)(a.lower(), b.lower()), upper = (std::min)(a.upper(), b.upper());
    return Number(lower, upper, (std::max)(a.precision(), b.precision()));
  }

  /*
  c - C f(c) + (I - C J(X)) (X - c), with the middle c of the box X. All roots in X lie in it; if it lies in the
  interior of X, there is exactly one (Krawczyk 1969).
  */
  struct Image
  {
    std::vector<Number> box;
    double contraction = 0;   // the largest sum of a row of |I - C J|, with the radii of X as weights
  };

  std::optional<Image> krawczyk_image(long precision) const
  {
    const std::size_t n = m_box.size();
    std::vector<Number> centre, offset;
    for (const Number& x : m_box) {
      centre.emplace_back(round_to_dyadic(x.midpoint(), static_cast<int>(precision)));
      offset.push_back(x - centre.back());
    }
    const auto at_centre = m_equations(centre), on_box = m_equations(m_box);
    const std::vector<Number> inverse = inverse_of_middle(on_box.jacobian, n);
    if (inverse.empty())
      return std::nullopt;
    Image image;
    for (std::size_t i = 0; i < n; ++i) {
      Number sum = centre[i];
      double row = 0;
      for (std::size_t k = 0; k < n; ++k)
        sum -= inverse[i * n + k] * at_centre.values[k];
      for (std::size_t j = 0; j < n; ++j) {
        Number entry(i == j ? 1 : 0);
        for (std::size_t k = 0; k < n; ++k)
          entry -= inverse[i * n + k] * on_box.jacobian[k * n + j];
        sum += entry * offset[j];
        const auto [lower, upper] = entry.to_double_interval();
        row += (std::max)(-lower, upper) * (offset[j].width() / offset[i].width()) * (1 + 1e-12);
      }
      if (!sum.is_bounded())
        return std::nullopt;
      image.contraction = (std::max)(image.contraction, row);
      image.box.push_back(std::move(sum));
    }
    return image;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_ALGEBRAIC_ROOT_H
