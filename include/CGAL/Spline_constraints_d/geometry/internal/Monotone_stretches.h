// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_MONOTONE_STRETCHES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_MONOTONE_STRETCHES_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_root.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Proper {

using Number_range = std::pair<Exact_rational, Exact_rational>;

/*
A rational function on [0,1], cut where it turns back, and where it has the value of a seam, a rational number or
infinity. All signs are exact.
*/
class Monotone_stretches
{
public:
  // A place where it is cut, or an end.
  struct Cut
  {
    Exact_root root;
    bool is_seam;
  };

private:
  Polynomial_quotient m_function;
  Integer_polynomial m_slope, m_seam; // the numerator of the derivative; zero where the value is that of the seam
  Integer_polynomial m_turns;         // the simple factors of the slope at whose zeros the sign changes
  std::vector<Cut> m_cuts;

public:
  // Without a number, the seam is at infinity.
  Monotone_stretches(Polynomial_quotient function, const std::optional<Exact_rational>& seam)
    : m_function(std::move(function)),
      m_slope(numerator_of_derivative(m_function.numerator_coefficients(), m_function.denominator_coefficients())),
      m_turns(Integer_coefficients(1, Big_integer(1)))
  {
    m_seam = seam ? difference_to(*seam) : Integer_polynomial(m_function.denominator_coefficients());
    for (const auto& [factor, exponent] : m_slope.square_free_factors())
      if (exponent % 2 == 1)
        m_turns = m_turns * factor;
    find_cuts();
  }

  const std::vector<Cut>& cuts() const { return m_cuts; }

  bool meets_seam() const
  {
    return std::any_of(m_cuts.begin(), m_cuts.end(), [](const Cut& cut) { return cut.is_seam; });
  }

  // Whether it increases between two successive cuts.
  bool increases_after(std::size_t cut) const
  {
    const Exact_rational begin = m_cuts[cut].root.upper(), width = m_cuts[cut + 1].root.lower() - begin;
    Exact_rational share(0.5);
    for (;; share = share / Exact_rational(2) + Exact_rational(0.125)) // one of them is no zero of the slope
      if (const CGAL::Sign sign = m_slope.sign_at(Exact_rational(begin + share * width)); sign != CGAL::ZERO)
        return sign == CGAL::POSITIVE;
  }

  // The value at a cut, if it is rational, or else an enclosure without short fractions; nothing if it is infinite.
  std::optional<Number_range> value_at(std::size_t cut)
  {
    Exact_root& root = m_cuts[cut].root;
    if (!root.is_point() && root.sign_of_value(Integer_polynomial(m_function.denominator_coefficients())) == CGAL::ZERO)
      return std::nullopt;
    while (!root.is_point()) {
      const auto range = range_near(root);
      if (range && range->second - range->first <= power_of_two(-100)) {
        const Exact_rational simplest = simplest_rational_between(range->first, range->second);
        if (root.sign_of_value(difference_to(simplest)) == CGAL::ZERO)
          return Number_range(simplest, simplest);
        return range;
      }
      root.narrow(Exact_rational(root.width() * power_of_two(-32)));
    }
    const std::optional<Exact_rational> value = m_function(root.lower());
    return value ? std::optional(Number_range(*value, *value)) : std::nullopt;
  }

private:
  // The numerator of the difference to a number.
  Integer_polynomial difference_to(const Exact_rational& x) const
  {
    Integer_coefficients result;
    add_multiple(result, m_function.numerator_coefficients(), denominator_of(x));
    add_multiple(result, m_function.denominator_coefficients(), Big_integer(-numerator_of(x)));
    return Integer_polynomial(std::move(result));
  }

  void find_cuts()
  {
    // Each place once: zeros of both, and multiple ones of the seam, are simple in the product.
    Integer_polynomial all(Integer_coefficients(1, Big_integer(1)));
    for (const auto& [factor, exponent] : (m_turns * m_seam).square_free_factors())
      all = all * factor;
    const Exact_rational zero(0), one(1);
    all.remove_root(zero);
    all.remove_root(one);
    const auto polynomial = std::make_shared<const Integer_polynomial>(primitive_part(all.coefficients()));
    std::vector<Exact_root> roots = isolate_roots(
        polynomial, zero, one, [] { return false; }, [](const auto&, const auto&) {});
    // Rational roots are the simplest numbers in intervals that are so narrow.
    const Big_integer& leading = polynomial->leading_coefficient();
    const Exact_rational width =
        (std::min)(power_of_two(-160), Exact_rational(quotient(Big_integer(1), Big_integer(4 * leading * leading))));
    for (Exact_root& root : roots) {
      if (!root.is_point())
        root.narrow(width);
      root.settle_on_simplest_rational();
    }
    std::sort(roots.begin(), roots.end(),
              [](const Exact_root& a, const Exact_root& b) { return a.lower() < b.lower(); });
    roots.insert(roots.begin(), Exact_root(zero));
    roots.push_back(Exact_root(one));
    for (std::size_t i = 1; i < roots.size(); ++i)
      while (!(roots[i - 1].upper() < roots[i].lower())) {
        roots[i - 1].halve();
        roots[i].halve();
      }
    for (Exact_root& root : roots) {
      const bool is_seam = root.sign_of_value(m_seam) == CGAL::ZERO;
      m_cuts.push_back({std::move(root), is_seam});
    }
  }

  // Nothing, where the denominator may be zero. The ends are dyadic.
  std::optional<Number_range> range_near(const Exact_root& root) const
  {
    const auto range_of = [&](const Integer_coefficients& f) {
      const Integer_polynomial polynomial{Integer_coefficients(f)};
      const auto bernstein = polynomial.bernstein(root.lower(), root.upper());
      const auto [least, greatest] = std::minmax_element(bernstein.values.begin(), bernstein.values.end());
      const Exact_rational unit = power_of_two(bernstein.exponent) / scaled_rational(polynomial.denominator(), 0);
      return Number_range(scaled_rational(*least, 0) * unit, scaled_rational(*greatest, 0) * unit);
    };
    const Number_range below = range_of(m_function.denominator_coefficients());
    if (below.first <= 0 && below.second >= 0)
      return std::nullopt;
    const Number_range above = m_function.numerator_coefficients().empty()
        ? Number_range(Exact_rational(0), Exact_rational(0))
        : range_of(m_function.numerator_coefficients());
    const std::vector<Exact_rational> quotients{
        Exact_rational(above.first / below.first), Exact_rational(above.first / below.second),
        Exact_rational(above.second / below.first), Exact_rational(above.second / below.second)};
    const auto [least, greatest] = std::minmax_element(quotients.begin(), quotients.end());
    return Number_range(*least, *greatest);
  }
};

} // namespace Proper
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_MONOTONE_STRETCHES_H
