// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_ELEMENTARY_PROOF_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_ELEMENTARY_PROOF_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/jets.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/Constraints_on_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/mpfr_functions.h>

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
namespace verification {

using Elementary_ranges = std::vector<std::pair<Exact_rational, Exact_rational>>;

inline bool lies_in(const Elementary_ranges& inner, const Elementary_ranges& outer)
{
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].first < outer[j].first || outer[j].second < inner[j].second)
      return false;
  return true;
}

/*
Proves answers with elementary functions once more, by the operator of Krawczyk in intervals of many bits. Nothing is
shared with the search for all solutions but the polynomials and what the values are.
*/
class Elementary_proof
{
  using Ranges = Elementary_ranges;
  using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;
  using Box = std::vector<Mpfr_interval>;

  using Jet = elementary::Jet<Mpfr_interval>;

  const Ranges& m_domain;
  const Constraints& m_constraints;
  const Elementary_values& m_values;
  std::function<void()> m_check;
  std::vector<const Power_polynomial*> m_equalities;

public:
  // `check()` may end the work by an exception.
  Elementary_proof(const Ranges& domain, const Constraints& constraints, const Elementary_values& values,
                   std::function<void()> check = {})
    : m_domain(domain), m_constraints(constraints), m_values(values), m_check(std::move(check))
  {
    for (const auto& [polynomial, relation] : constraints)
      if (relation == Relation::EQUAL)
        m_equalities.push_back(&polynomial);
  }

  // The only zero of the equalities in a region around a box, and whether it is a solution where that is decided.
  struct Zero
  {
    Ranges region, enclosure;
    std::optional<bool> is_solution;
  };

  // Nothing when no such region is found.
  std::optional<Zero> zero_near(const Ranges& box) const;

  // That a box holds exactly one solution.
  bool has_one_solution(const Ranges& box) const;

  // That it holds one.
  bool has_solution(const Ranges& box) const;

private:
  std::size_t dimension() const { return m_domain.size(); }

  std::optional<std::vector<Jet>> jets_of_values(const Box& box) const;
  static Jet jet_of(const Power_polynomial& polynomial, const Box& box, const std::vector<Jet>& values);
  std::optional<std::vector<Jet>> jets_of_equalities(const Box& box) const;
  std::optional<Box> image(const Box& box, bool is_strict) const;
  Box shrunk(Box root) const;
  std::optional<bool> is_admissible(const Box& root) const;
  std::vector<Rational_wave> rational_waves(const Box& root) const;
  bool has_zero_at(const std::vector<Exact_rational>& point, const std::vector<int>& unknowns,
                   const std::vector<Rational_wave>& waves, Zero& zero) const;
  void look_for_rational_coordinates(const Box& root, Zero& zero) const;
  bool is_rational_solution(const std::vector<Exact_rational>& point) const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
inline Mpfr_interval interval_of(const Exact_rational& x) { return Mpfr_interval(x); }

CGAL_SPLINE_CONSTRAINTS_INLINE Elementary_proof::Jet
Elementary_proof::jet_of(const Power_polynomial& polynomial, const Box& box, const std::vector<Jet>& values)
{
  return elementary::jet_of<Mpfr_interval>(polynomial, box, values, interval_of);
}

// Nothing where it is not certain that all of them can be differentiated; numbers need not be.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::vector<Elementary_proof::Jet>>
Elementary_proof::jets_of_values(const Box& box) const
{
  return elementary::jets_of_values<Mpfr_interval>(m_values, box, interval_of,
                                                   [](const Elementary_value& value, const Mpfr_interval& x) {
                                                     return mpfr_function(value.function, value.exponent, x);
                                                   });
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::vector<Elementary_proof::Jet>>
Elementary_proof::jets_of_equalities(const Box& box) const
{
  const auto values = jets_of_values(box);
  if (!values)
    return std::nullopt;
  std::vector<Jet> result;
  for (const Power_polynomial* equality : m_equalities)
    result.push_back(jet_of(*equality, box, *values));
  return result;
}

/*
The image K = y - C F(y) + (I - C J)(X - y) of a box X, cut by X; nothing when it is empty or no C is found. If it is
strict, K has to lie inside of X: then X has exactly one zero.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Elementary_proof::Box> Elementary_proof::image(const Box& box,
                                                                                            bool is_strict) const
{
  const std::size_t n = dimension();
  Box middle;
  for (const Mpfr_interval& range : box)
    middle.push_back(Mpfr_interval(range.midpoint()));
  const auto on_box = jets_of_equalities(box), at_middle = jets_of_equalities(middle);
  if (!on_box || !at_middle)
    return std::nullopt;
  Mpfr_matrix jacobian(n), approximate(n);
  for (std::size_t i = 0; i < n; ++i)
    for (const auto& [unknown, derivative] : (*on_box)[i].gradient) {
      if (!derivative.is_bounded())
        return std::nullopt;
      jacobian(i, unknown) = derivative;
      approximate(i, unknown) = Mpfr_interval(derivative.midpoint());
    }
  const auto inverse = approximate_inverse(std::move(approximate), m_check);
  if (!inverse)
    return std::nullopt;
  Box result;
  for (std::size_t i = 0; i < n; ++i) {
    Mpfr_interval sum = middle[i];
    std::vector<Mpfr_interval> row(n, Mpfr_interval(0));
    for (std::size_t k = 0; k < n; ++k)
      if (const Mpfr_interval& c = (*inverse)(i, k); !c.is_same(Mpfr_interval(0))) {
        sum -= c * (*at_middle)[k].value;
        for (const auto& [unknown, derivative] : (*on_box)[k].gradient)
          row[unknown] -= c * derivative;
      }
    row[i] += Mpfr_interval(1);
    for (std::size_t j = 0; j < n; ++j)
      sum += row[j] * (box[j] - middle[j]);
    if (!sum.is_bounded() || (is_strict && !(box[i].lower() < sum.lower() && sum.upper() < box[i].upper())))
      return std::nullopt;
    const auto cut = common_part(sum, box[i]);
    if (!cut)
      return std::nullopt;
    result.push_back(*cut);
  }
  return result;
}

// Whether all points of an enclosure of a root lie in the domain and satisfy the inequalities, or none does.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<bool> Elementary_proof::is_admissible(const Box& root) const
{
  bool is_open = false;
  for (std::size_t j = 0; j < dimension(); ++j) {
    if (root[j].upper() < m_domain[j].first || m_domain[j].second < root[j].lower())
      return false;
    is_open = is_open || root[j].lower() < m_domain[j].first || m_domain[j].second < root[j].upper();
  }
  const auto values = jets_of_values(root);
  if (!values)
    return std::nullopt;
  for (const auto& [polynomial, relation] : m_constraints) {
    if (relation == Relation::EQUAL)
      continue;
    const CGAL::Uncertain<CGAL::Sign> sign = jet_of(polynomial, root, *values).value.sign();
    if (!CGAL::is_certain(sign))
      is_open = true;
    else if (!is_satisfied(relation, CGAL::get_certain(sign)))
      return false;
  }
  return is_open ? std::nullopt : std::optional<bool>(true);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool
Elementary_proof::is_rational_solution(const std::vector<Exact_rational>& point) const
{
  const auto values = m_values.rational_values(point);
  if (!values)
    return false;
  for (std::size_t j = 0; j < dimension(); ++j)
    if (point[j] < m_domain[j].first || m_domain[j].second < point[j])
      return false;
  return std::ranges::all_of(m_constraints, [&](const auto& constraint) {
    return is_satisfied(constraint.second, CGAL::sign(m_values.rational_value(constraint.first, point, *values)));
  });
}

// As far as the operator does.
CGAL_SPLINE_CONSTRAINTS_INLINE Elementary_proof::Box Elementary_proof::shrunk(Box root) const
{
  constexpr int most_steps = 12;
  constexpr double least_gain = 0.5;
  for (int step = 0; step < most_steps; ++step) {
    auto next = image(root, false);
    if (!next)
      return root;
    bool is_gain = false;
    for (std::size_t j = 0; j < dimension(); ++j)
      is_gain = is_gain || (*next)[j].width() < least_gain * root[j].width();
    root = std::move(*next);
    if (!is_gain)
      return root;
  }
  return root;
}

inline Elementary_ranges ranges_of(const std::vector<Mpfr_interval>& box)
{
  Elementary_ranges result;
  for (const Mpfr_interval& range : box)
    result.emplace_back(range.lower(), range.upper());
  return result;
}

inline bool is_short(const Exact_rational& x)
{
  constexpr long most_bits = 64;
  return bit_length(numerator_of(x)) + bit_length(denominator_of(x)) <= most_bits;
}

// Sines and cosines of angles that look as if both were rational.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Rational_wave> Elementary_proof::rational_waves(const Box& root) const
{
  std::vector<Rational_wave> result;
  const auto values = jets_of_values(root);
  for (std::size_t k = 0; values && k < m_values.all().size(); ++k) {
    const auto& [function, exponent, argument] = m_values.all()[k];
    if (function != Elementary_function::SINE && function != Elementary_function::COSINE)
      continue;
    const Mpfr_interval angle = jet_of(argument, root, *values).value;
    const auto simplest = [&](Elementary_function wave) {
      const Mpfr_interval value = mpfr_function(wave, Exact_rational(), angle)->value;
      return simplest_rational_between(value.lower(), value.upper());
    };
    const Exact_rational sine = simplest(Elementary_function::SINE), cosine = simplest(Elementary_function::COSINE);
    if (!is_short(sine) || !is_short(cosine) || sine * sine + cosine * cosine != 1)
      continue;
    const double turns =
        (CGAL::to_double(angle.midpoint()) - std::atan2(CGAL::to_double(sine), CGAL::to_double(cosine))) /
        (2 * std::acos(-1.0));
    if (std::abs(turns) < 0x1p40)
      result.push_back({static_cast<int>(k), sine, cosine, std::lround(turns)});
  }
  return result;
}

// Of equalities that are linear combinations of those before them nothing is left.
inline void leave_independent_equalities(std::vector<std::pair<Power_polynomial, Relation>>& constraints)
{
  std::vector<Power_polynomial> rows;
  std::erase_if(constraints, [&](const auto& constraint) {
    if (constraint.second != Relation::EQUAL)
      return false;
    Power_polynomial rest = constraint.first;
    for (const Power_polynomial& row : rows) {
      const auto& [leading, factor] = *row.terms().rbegin();
      const auto term = std::ranges::find(rest.terms(), leading, [](const auto& t) { return t.first; });
      if (term != rest.terms().end())
        rest -= Exact_rational(term->second / factor) * row;
    }
    if (!rest.is_zero())
      rows.push_back(rest);
    return rest.is_zero();
  });
}

/*
Whether the zero has given coordinates but on some unknowns, and values that are given: then there is one of the
constraints on these unknowns, as many independent equalities being left. What is known then of the zero is noted.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE bool Elementary_proof::has_zero_at(const std::vector<Exact_rational>& point,
                                                                  const std::vector<int>& unknowns,
                                                                  const std::vector<Rational_wave>& waves,
                                                                  Zero& zero) const
try {
  Constraints_on_unknowns rest(m_constraints, m_values, point, unknowns, waves);
  leave_independent_equalities(rest.constraints);
  Ranges domain;
  Box box;
  for (const int j : unknowns) {
    domain.push_back(m_domain[j]);
    const auto& [lower, upper] = zero.enclosure[j];
    box.emplace_back((std::max)(Exact_rational(lower - (lower - zero.region[j].first) / 1024), zero.region[j].first),
                     (std::min)(Exact_rational(upper + (zero.region[j].second - upper) / 1024), zero.region[j].second));
  }
  const Elementary_proof of_rest(domain, rest.constraints, rest.values, m_check);
  if (of_rest.m_equalities.size() != unknowns.size())
    return false;
  const auto inside = of_rest.image(box, true);
  if (!inside)
    return false;
  const Box root = of_rest.shrunk(*inside);
  for (std::size_t j = 0; j < dimension(); ++j)
    zero.enclosure[j] = {point[j], point[j]};
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    zero.enclosure[unknowns[k]] = {root[k].lower(), root[k].upper()};
  for (std::size_t j = 0; j < dimension(); ++j)
    if (zero.enclosure[j].second < m_domain[j].first || m_domain[j].second < zero.enclosure[j].first)
      zero.is_solution = false;
  if (!zero.is_solution)
    zero.is_solution = of_rest.is_admissible(root);
  return true;
} catch (const Invalid_input&) { // a function is not defined there
  return false;
}

// Of all coordinates that look rational, or of those that may lie at ends of the domain; with such angles.
CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_proof::look_for_rational_coordinates(const Box& root, Zero& zero) const
{
  const std::vector<Rational_wave> waves = rational_waves(root);
  for (const bool is_at_end : {false, true}) {
    std::vector<Exact_rational> point;
    std::vector<int> unknowns;
    for (std::size_t j = 0; j < dimension(); ++j) {
      const auto& [lower, upper] = zero.enclosure[j];
      point.push_back(simplest_rational_between(lower, upper));
      bool is_known = is_short(point[j]);
      if (is_at_end) {
        is_known = false;
        for (const Exact_rational& end : {m_domain[j].first, m_domain[j].second})
          if (lower <= end && end <= upper) {
            point[j] = end;
            is_known = true;
          }
      }
      if (!is_known)
        unknowns.push_back(static_cast<int>(j));
    }
    if ((unknowns.size() < dimension() || !waves.empty()) && has_zero_at(point, unknowns, waves, zero))
      return;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Elementary_proof::Zero>
Elementary_proof::zero_near(const Ranges& box) const
{
  constexpr mpfr_prec_t bits = 256;
  constexpr int inflations[] = {45, 60, 90, 120, 160}; // by 2^-k
  if (m_equalities.size() != dimension())
    return std::nullopt;
  const Mpfr_precision_scope precision(bits);
  for (const int k : inflations) {
    Box region;
    for (const auto& [lower, upper] : box) {
      const Exact_rational size = (std::max)(Exact_rational(1), Exact_rational(CGAL::abs(lower)));
      const Exact_rational margin = (upper - lower) / 8 + size * scaled_rational(Big_integer(1), -k);
      region.emplace_back(Exact_rational(lower - margin), Exact_rational(upper + margin));
    }
    if (const auto inside = image(region, true)) {
      const Box root = shrunk(*inside);
      Zero result{ranges_of(region), ranges_of(root), is_admissible(root)};
      if (!result.is_solution || !lies_in(result.enclosure, box))
        look_for_rational_coordinates(root, result);
      return result;
    }
  }
  return std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Elementary_proof::has_one_solution(const Ranges& box) const
{
  const auto zero = zero_near(box);
  return zero && zero->is_solution.value_or(false) && lies_in(zero->enclosure, box);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Elementary_proof::has_solution(const Ranges& box) const
{
  std::vector<Exact_rational> point;
  for (const auto& [lower, upper] : box)
    point.push_back(simplest_rational_between(lower, upper));
  return is_rational_solution(point) || has_one_solution(box);
}
#endif

// Whether an answer with values of elementary functions is proved.
bool is_proved(const std::vector<std::pair<Exact_rational, Exact_rational>>& domain,
               const std::vector<std::pair<Power_polynomial, Relation>>& constraints, const Elementary_values& values,
               Solution_kind kind, const std::vector<std::pair<Exact_rational, Exact_rational>>& box);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool is_proved(const std::vector<std::pair<Exact_rational, Exact_rational>>& domain,
                                              const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                                              const Elementary_values& values, Solution_kind kind,
                                              const std::vector<std::pair<Exact_rational, Exact_rational>>& box)
{
  if (box.size() != domain.size())
    return false;
  const Elementary_proof proof(domain, constraints, values);
  return kind == Solution_kind::CERTIFIED ? proof.has_one_solution(box)
      : kind == Solution_kind::CLUSTER    ? proof.has_solution(box)
                                          : false;
}
#endif

} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_ELEMENTARY_PROOF_H
