// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_IRRATIONAL_MULTIPLE_ROOT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_IRRATIONAL_MULTIPLE_ROOT_H

#include <CGAL/Spline_constraints_d/solver/internal/certification/algebraic_position.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Algebraic_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Number_field_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
What is proved of the zeros of n equalities in a region around a point z where n - 1 of them are zero and the
determinant of the Jacobian of all is: `MULTIPLE_ROOT`, z is the only one; `NO_ROOT`; `CLOSE_ROOTS`, there are at most
two, simple ones, on both sides of z.
*/
struct Multiple_root_search
{
  // That is looked for, where there are not too many unknowns: derivatives along curves are determinants of
  // polynomials.
  static constexpr int most_multiplicity = 8;
  static constexpr std::size_t most_unknowns = 3;

  enum Outcome { MULTIPLE_ROOT, NO_ROOT, CLOSE_ROOTS, NOTHING_PROVED };

  Outcome outcome = NOTHING_PROVED;
  int multiplicity = 0;                 // of the multiple root
  Exact_box region;                     // of the proof
  std::optional<Algebraic_root> root;   // z
  std::vector<Power_polynomial> equalities;   // the last one is not among those that are zero at z

  bool covers(const Exact_box& box) const { return !region.empty() && contains(region, box); }
};

inline Exact_rational width_of_domain(const Constraint_system_d& system, std::size_t j)
{
  const auto& [lower, upper] = system.domain(static_cast<int>(j));
  return lower < upper ? Exact_rational(upper - lower) : Exact_rational(1);
}

// The box of a share of some radii around a centre.
inline Exact_box surrounding(const std::vector<Exact_rational>& centre, const std::vector<Exact_rational>& radii,
                             double share)
{
  Exact_box result;
  for (std::size_t j = 0; j < centre.size(); ++j) {
    const Exact_rational radius = radii[j] * Exact_rational(share);
    result.emplace_back(Exact_rational(centre[j] - radius), Exact_rational(centre[j] + radius));
  }
  return result;
}

// The polynomials in an order such that the gradients of all but the last are independent at a point: it has the
// largest part in the combination of gradients that is nearly zero.
inline std::vector<Power_polynomial> dependent_last(std::vector<Power_polynomial> polynomials,
                                                    const std::vector<Exact_rational>& point)
{
  const std::size_t n = point.size();
  const auto rows = eliminated_jacobian(polynomials, point, n - 1);
  if (rows.empty())
    return {};
  const auto part = [&](std::size_t k) { return std::abs(CGAL::to_double(rows[(n - 1) * 2 * n + n + k].midpoint())); };
  std::size_t last = 0;
  for (std::size_t k = 1; k < n; ++k)
    if (part(k) > part(last))
      last = k;
  std::rotate(polynomials.begin() + last, polynomials.begin() + last + 1, polynomials.end());
  return polynomials;
}

// A regular root of equations around a small box, and a region around it where the argument of `search_multiple_root()`
// holds.
inline bool find_root_around(const Constraint_system_d& system, const Exact_box& box,
                             const Algebraic_equations& equations, Multiple_root_search& result)
{
  const std::size_t n = box.size();
  const std::vector<Exact_rational> centre = Algebraic_root::guess(equations, middle_of(box));
  if (centre.empty())
    return false;
  Exact_rational reach(0x1p-100);   // as a part of the domain: from the zero to the farthest side of the box
  for (std::size_t j = 0; j < n; ++j) {
    const Exact_rational farthest = (std::max)(Exact_rational(CGAL::abs(Exact_rational(centre[j] - box[j].first))),
                                               Exact_rational(CGAL::abs(Exact_rational(centre[j] - box[j].second))));
    reach = (std::max)(reach, Exact_rational(farthest / width_of_domain(system, j)));
  }
  for (int factor = 64; factor >= 4; factor /= 4) {
    std::vector<Exact_rational> radii;
    for (std::size_t j = 0; j < n; ++j)
      radii.push_back(round_to_dyadic(Exact_rational(reach * Exact_rational(factor) * width_of_domain(system, j)), 8));
    result.root = Algebraic_root::in(equations, surrounding(centre, radii, 1));
    if (!result.root)
      continue;
    const double share = 0.99 * (1 - result.root->contraction()) / (1 + result.root->contraction());
    result.region = surrounding(centre, radii, share);
    if (share >= 0.25 && result.covers(box) && result.root->refine(result.root->bits_of_width() + 64) &&
        contains(surrounding(centre, radii, 0.001), result.root->box())) {
      if (!integer_equalities(system, result.region))   // beyond a break the equalities are others
        result.region = box;
      return true;
    }
  }
  result.root.reset();
  result.region.clear();
  return false;
}

// The derivative of a polynomial along the curve where others, one less than unknowns, are zero: the determinant of the
// Jacobian of all. Nothing if that is long.
inline std::optional<Power_polynomial> derivative_along_curve(const std::vector<Power_polynomial>& others,
                                                              const Power_polynomial& polynomial)
{
  constexpr double most_products = 1 << 18;
  const std::size_t n = others.size() + 1;
  std::vector<Power_polynomial> jacobian;
  double products = static_cast<double>(polynomial.terms().size());
  for (const Power_polynomial& f : others)
    products *= static_cast<double>(f.terms().size());
  if (products > most_products)
    return std::nullopt;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      jacobian.push_back((i + 1 < n ? others[i] : polynomial).derivative(static_cast<int>(j)));
  return with_integer_coefficients(determinant_of(jacobian, n));
}

// Whether all polynomials are zero at a root, which is the only one of its equations in its region; false when that is
// not proved. The sign of a number that is given by its polynomial is faster than the zero bound, which needs more bits
// for each derivative.
inline bool are_zero_at(const std::vector<Power_polynomial>& polynomials,
                        const std::vector<Power_polynomial>& equations, Algebraic_root& root,
                        const std::function<bool()>& must_stop)
{
  constexpr long bits_of_look = 512;
  const auto is_not_zero = [&](const Power_polynomial& f) {
    return CGAL::certainly(root.value_of(f).sign() != CGAL::ZERO);
  };
  if (!root.refine(bits_of_look) || std::any_of(polynomials.begin(), polynomials.end(), is_not_zero))
    return false;
  if (const auto point = Number_field_point::near(root)) {
    const auto is_zero = [&](const Power_polynomial& f) { return point->is_zero_of(f); };
    if (std::all_of(equations.begin(), equations.end(), is_zero))
      return std::all_of(polynomials.begin(), polynomials.end(), is_zero);
  }
  return std::all_of(polynomials.begin(), polynomials.end(),
                     [&](const Power_polynomial& f) { return root.sign_of(f, must_stop) == CGAL::ZERO; });
}

/*
Looks for a multiple root of as many equalities as unknowns around a small box, an irrational one as well, where the
Jacobian has rank n - 1.

Let p_0 be the last equality f_n, p_1 the determinant D of the Jacobian of all, and p_{k+1} that of f_1, ..., f_{n-1}
and p_k: the derivative of p_k along the curve where the first n - 1 equalities are zero. A regular zero z of f_1, ...,
f_{n-1} and p_{m-1} is a root of multiplicity m, if p_0, ..., p_{m-2} are zero there.

Let G be these n functions, and z the zero that Newton's method finds. With C near the inverse of the Jacobian J_G of G,
and |I - C J_G| <= q < 1 in the norm of a box X around z with radius 1, which proves z:
1. |C G(x) - (x - z)| <= q |x - z| in X. So for x with |x - z| <= (1-q)/(1+q) the equations C G(y) = t C G(x), 0 <= t <=
  1, have a solution y(t) in X, which depends smoothly on t.
2. If x satisfies the first n - 1 equalities, so do all y(t), and p_{m-1}(y(t)) = t p_{m-1}(x). Then d/dt p_k(y(t)) =
  lambda p_{k+1}(y(t)) for all k, with lambda = p_{m-1}(x) / det J_G(y(t)), and
   det J_G has one sign s on X.
3. So for x /= z, p_{m-1}, and one after the other p_{m-2}, ..., p_0, have no zero on the curve for t > 0: z is the only
  root there.
4. For m = 2, d/dt f_n(y(t)) = t D(x)^2 / det J_G(y(t)), and f_n(x) - f_n(z) has the sign s for all x /= z that satisfy
  the others. If f_n(z) has the sign s, there is no root. Whether f_n(z) = 0 is decided by the zero bound; this takes
  long for some systems, and may be stopped. Where it asks for too many bits, and for m > 2, the coordinates of z are
  looked for among the polynomials in one of them.
*/
inline Multiple_root_search search_multiple_root(const Constraint_system_d& system, const Exact_box& box,
                                                 int most_multiplicity, const std::function<bool()>& must_stop = {})
{
  Multiple_root_search result;
  const std::size_t n = box.size();
  if (n > 5 || system.equalities().size() != n)
    return result;
  const auto equalities = integer_equalities(system, box);
  if (!equalities)
    return result;
  result.equalities = dependent_last(*equalities, middle_of(box));
  if (result.equalities.empty())
    return result;
  const std::vector<Power_polynomial> others(result.equalities.begin(), result.equalities.end() - 1);
  std::vector<Power_polynomial> derivatives{result.equalities.back()};   // p_0, p_1, ...
  std::vector<Exact_rational> origin = middle_of(box);
  for (Exact_rational& x : origin)
    x = round_to_dyadic(x, 32);
  if (n > Multiple_root_search::most_unknowns)
    most_multiplicity = 2;
  for (int m = 2; m <= most_multiplicity; ++m) {
    std::vector<Power_polynomial> functions = others;
    functions.push_back(derivatives.back());
    const bool is_found = find_root_around(
        system, box, m == 2 ? Algebraic_equations(functions, true) : Algebraic_equations(functions, true, origin),
        result);
    const auto sign = is_found && m == 2 ? result.root->sign_of(derivatives.back(), must_stop) : std::nullopt;
    if (sign) {
      result.multiplicity = 2;
      result.outcome = *sign == CGAL::ZERO                 ? Multiple_root_search::MULTIPLE_ROOT
                       : *sign == result.root->orientation() ? Multiple_root_search::NO_ROOT
                                                             : Multiple_root_search::CLOSE_ROOTS;
      return result;
    }
    const auto next = derivative_along_curve(others, derivatives.back());
    if (is_found) {
      functions.back() = next ? *next : Power_polynomial(1);
      if (next && are_zero_at(derivatives, functions, *result.root, must_stop)) {
        result.multiplicity = m;
        result.outcome = Multiple_root_search::MULTIPLE_ROOT;
      } else if (m > 2)
        result = {};
      return result;
    }
    if (!next || (must_stop && must_stop()))
      return {};
    derivatives.push_back(*next);
  }
  return {};
}

// To double precision, whatever the size.
inline Exact_rational approximate_square_root(const Exact_rational& x)
{
  const long half_exponent = (bit_length(numerator_of(x)) - bit_length(denominator_of(x))) / 2;
  return Exact_rational(std::sqrt(CGAL::to_double(Exact_rational(x * power_of_two(-2 * half_exponent))))) *
      power_of_two(half_exponent);
}

/*
The two roots of `CLOSE_ROOTS`, each proved in a box of its own, however close they are; none when that fails. On the
curve of the first n - 1 equalities they lie where D(x)^2 = -2 f_n(z) det J_G(z), about; there Newton's method begins.
*/
inline std::vector<Algebraic_root> close_roots(const Constraint_system_d& system, Multiple_root_search& search)
{
  const std::size_t n = search.equalities.size();
  const Power_polynomial& last = search.equalities.back();
  // of the last equality beside its coefficients
  const double size = (std::max)(Algebraic_root::bits_of_size(search.root->value_of(last)), 0.0) + size_of(last).bits;
  const int bits = 4 * static_cast<int>(size) + 512;
  search.root->refine(bits);
  const Mpfr_precision_scope scope(bits);
  const std::vector<Exact_rational> z = middle_of(search.root->box());
  const std::vector<Mpfr_interval> at_z(z.begin(), z.end());
  const Algebraic_equations equations(search.equalities, false);
  const auto jacobian = Algebraic_equations(search.equalities, true)(at_z).jacobian;
  const std::vector<Mpfr_interval> inverse = Algebraic_root::inverse_of_middle(jacobian, n);
  const Exact_rational square =
      Exact_rational(equations(at_z).values.back().midpoint() * determinant_of(jacobian, n).midpoint()) *
      Exact_rational(-2);
  if (inverse.empty() || !(square > Exact_rational(0)))
    return {};
  const Exact_rational level = approximate_square_root(square);
  std::vector<Exact_rational> step, radii;
  Exact_rational longest(0);
  for (std::size_t j = 0; j < n; ++j) {
    step.push_back(Exact_rational(inverse[j * n + n - 1].midpoint() * level));
    longest = (std::max)(longest, Exact_rational(CGAL::abs(step[j]) / width_of_domain(system, j)));
  }
  for (std::size_t j = 0; j < n; ++j)
    radii.push_back(round_to_dyadic(Exact_rational(longest * width_of_domain(system, j)), 8));
  std::vector<Algebraic_root> result;
  for (const int side : {-1, 1}) {
    std::vector<Exact_rational> start;
    for (std::size_t j = 0; j < n; ++j)
      start.push_back(Exact_rational(z[j] + Exact_rational(side) * step[j]));
    const std::vector<Exact_rational> guess = Algebraic_root::guess(equations, start, bits);
    std::optional<Algebraic_root> root;
    for (double share = 0x1p-6; share >= 0x1p-24 && !root && !guess.empty(); share /= 64)
      root = Algebraic_root::in(equations, surrounding(guess, radii, share));
    if (!root || !contains(search.region, root->box()) || !contains(surrounding(start, radii, 0.25), root->box()))
      return {};
    result.push_back(std::move(*root));
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_IRRATIONAL_MULTIPLE_ROOT_H
