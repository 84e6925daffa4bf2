// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_IRRATIONAL_DOUBLE_ROOT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_IRRATIONAL_DOUBLE_ROOT_H

#include <CGAL/Spline_constraints_d/solver/Algebraic_root.h>
#include <CGAL/Spline_constraints_d/solver/algebraic_position.h>

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
What is proved of the zeros of n equalities in a region around a point z where n - 1 of them are zero and the determinant of the Jacobian of all is: `DOUBLE_ROOT`, z is the only one and counts
twice; `NO_ROOT`; `CLOSE_ROOTS`, there are at most two, simple ones, on both sides of z.
*/
struct Double_root_search
{
  enum Outcome { DOUBLE_ROOT, NO_ROOT, CLOSE_ROOTS, NOTHING_PROVED };

  Outcome outcome = NOTHING_PROVED;
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
inline Exact_box surrounding(const std::vector<Exact_rational>& centre, const std::vector<Exact_rational>& radii, double share)
{
  Exact_box result;
  for (std::size_t j = 0; j < centre.size(); ++j) {
    const Exact_rational radius = radii[j] * Exact_rational(share);
    result.emplace_back(Exact_rational(centre[j] - radius), Exact_rational(centre[j] + radius));
  }
  return result;
}

// The polynomials in an order such that the gradients of all but the last are independent at a point: it has the largest part in the combination of gradients that is nearly zero.
inline std::vector<Power_polynomial> dependent_last(std::vector<Power_polynomial> polynomials, const std::vector<Exact_rational>& point)
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

/*
Looks for a double root of as many equalities as unknowns around a small box, irrational ones as well.

Let G be the first n - 1 equalities and D, the determinant of the Jacobian J of all of them, and z the zero of G that Newton's method finds. With C near the inverse of the Jacobian J_G of G, and
|I - C J_G| <= q < 1 in the norm of a box X around z with radius 1, which proves z:
1. |C G(x) - (x - z)| <= q |x - z| in X. So for x with |x - z| <= (1-q)/(1+q) the equations C G(y) = t C G(x), 0 <= t <= 1, have a solution y(t) in X, which depends smoothly on t.
2. If x satisfies the first n - 1 equalities, so do all y(t), with D(y(t)) = t D(x). Then d/dt f_n(y(t)) = t D(x)^2 / det J_G(y(t)) by Cramer's rule, and det J_G has one sign s on X.
3. So f_n(x) - f_n(z) has the sign s for all x /= z that satisfy the others. If f_n(z) = 0 then z is the only root there, and since f_n grows with t^2 its multiplicity is two; if f_n(z) has the sign s,
   there is none.
Whether f_n(z) = 0 is decided by the zero bound; this takes long for some systems, and may be stopped.
*/
inline Double_root_search search_double_root(const Constraint_system_d& system, const Exact_box& box, const std::function<bool()>& must_stop = {})
{
  Double_root_search result;
  const std::size_t n = box.size();
  if (n > 5 || system.equalities().size() != n)
    return result;
  const auto equalities = integer_equalities(system, box);
  if (!equalities)
    return result;
  result.equalities = dependent_last(*equalities, middle_of(box));
  if (result.equalities.empty())
    return result;
  const Algebraic_equations equations(result.equalities, true);
  const std::vector<Exact_rational> centre = Algebraic_root::guess(equations, middle_of(box));
  if (centre.empty())
    return result;
  Exact_rational reach(0x1p-100);   // as a part of the domain: from the zero to the farthest side of the box
  for (std::size_t j = 0; j < n; ++j) {
    const Exact_rational farthest = (std::max)(Exact_rational(CGAL::abs(Exact_rational(centre[j] - box[j].first))), Exact_rational(CGAL::abs(Exact_rational(centre[j] - box[j].second))));
    reach = (std::max)(reach, Exact_rational(farthest / width_of_domain(system, j)));
  }
  for (int factor = 64; factor >= 4 && !result.root; factor /= 4) {
    std::vector<Exact_rational> radii;
    for (std::size_t j = 0; j < n; ++j)
      radii.push_back(round_to_dyadic(Exact_rational(reach * Exact_rational(factor) * width_of_domain(system, j)), 8));
    result.root = Algebraic_root::in(equations, surrounding(centre, radii, 1));
    if (!result.root)
      continue;
    const double share = 0.99 * (1 - result.root->contraction()) / (1 + result.root->contraction());
    if (share < 0.25 || !result.root->refine(result.root->bits_of_width() + 64) || !contains(surrounding(centre, radii, 0.001), result.root->box()))
      result.root.reset();
    else
      result.region = surrounding(centre, radii, share);
  }
  if (!result.root)
    return {};
  if (!result.covers(box))
    return {};
  if (!integer_equalities(system, result.region))   // beyond a break the equalities are others
    result.region = box;
  const auto sign = result.root->sign_of(result.equalities.back(), must_stop);
  result.outcome = !sign                                   ? Double_root_search::NOTHING_PROVED
                   : *sign == CGAL::ZERO                   ? Double_root_search::DOUBLE_ROOT
                   : *sign == result.root->orientation()   ? Double_root_search::NO_ROOT
                                                           : Double_root_search::CLOSE_ROOTS;
  return result;
}

// To double precision, whatever the size.
inline Exact_rational approximate_square_root(const Exact_rational& x)
{
  const long half_exponent = (bit_length(numerator_of(x)) - bit_length(denominator_of(x))) / 2;
  return Exact_rational(std::sqrt(CGAL::to_double(Exact_rational(x * power_of_two(-2 * half_exponent))))) * power_of_two(half_exponent);
}

/*
The two roots of `CLOSE_ROOTS`, each proved in a box of its own, however close they are; none when that fails. On the curve of the first n - 1 equalities they lie where D(x)^2 = -2 f_n(z) det J_G(z),
about; there Newton's method begins.
*/
inline std::vector<Algebraic_root> close_roots(const Constraint_system_d& system, Double_root_search& search)
{
  const std::size_t n = search.equalities.size();
  const Power_polynomial& last = search.equalities.back();
  const double size = (std::max)(Algebraic_root::bits_of_size(search.root->value_of(last)), 0.0) + size_of(last).bits;   // of the last equality beside its coefficients
  const int bits = 4 * static_cast<int>(size) + 512;
  search.root->refine(bits);
  const Mpfr_precision_scope scope(bits);
  const std::vector<Exact_rational> z = middle_of(search.root->box());
  const std::vector<Mpfr_interval> at_z(z.begin(), z.end());
  const Algebraic_equations equations(search.equalities, false);
  const auto jacobian = Algebraic_equations(search.equalities, true)(at_z).jacobian;
  const std::vector<Mpfr_interval> inverse = Algebraic_root::inverse_of_middle(jacobian, n);
  const Exact_rational square = Exact_rational(equations(at_z).values.back().midpoint() * Algebraic_equations::determinant(jacobian, n).midpoint()) * Exact_rational(-2);
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

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_IRRATIONAL_DOUBLE_ROOT_H
