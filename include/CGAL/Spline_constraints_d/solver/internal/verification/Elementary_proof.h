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
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/mpfr_functions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace verification {

/*
Proves answers with elementary functions once more, by the operator of Krawczyk in intervals of many bits. Nothing is
shared with the search for all solutions but the polynomials and what the values are.
*/
class Elementary_proof
{
  using Ranges = std::vector<std::pair<Exact_rational, Exact_rational>>;
  using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;
  using Box = std::vector<Mpfr_interval>;

  using Jet = elementary::Jet<Mpfr_interval>;

  const Ranges& m_domain;
  const Constraints& m_constraints;
  const Elementary_values& m_values;
  std::vector<const Power_polynomial*> m_equalities;

public:
  Elementary_proof(const Ranges& domain, const Constraints& constraints, const Elementary_values& values)
    : m_domain(domain), m_constraints(constraints), m_values(values)
  {
    for (const auto& [polynomial, relation] : constraints)
      if (relation == Relation::EQUAL)
        m_equalities.push_back(&polynomial);
  }

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
  bool is_admissible(const Box& root) const;
  bool is_rational_solution(const std::vector<Exact_rational>& point) const;
  bool is_root_proved(Box region, const Ranges& box) const;
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
  const auto inverse = approximate_inverse(std::move(approximate));
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

// Whether all points of an enclosure of a root lie in the domain and satisfy the inequalities.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Elementary_proof::is_admissible(const Box& root) const
{
  for (std::size_t j = 0; j < dimension(); ++j)
    if (root[j].lower() < m_domain[j].first || m_domain[j].second < root[j].upper())
      return false;
  const auto values = jets_of_values(root);
  return values && std::ranges::all_of(m_constraints, [&](const auto& constraint) {
           const auto& [polynomial, relation] = constraint;
           if (relation == Relation::EQUAL)
             return true;
           const CGAL::Uncertain<CGAL::Sign> sign = jet_of(polynomial, root, *values).value.sign();
           return CGAL::is_certain(sign) && is_satisfied(relation, CGAL::get_certain(sign));
         });
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

// The region is shrunk around its root.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Elementary_proof::is_root_proved(Box region, const Ranges& box) const
{
  constexpr int most_steps = 12;
  auto shrunk = image(region, true);
  for (int step = 0; step < most_steps && shrunk; ++step) {
    region = *shrunk;
    bool is_inside = true;
    std::vector<Exact_rational> simplest;
    for (std::size_t j = 0; j < dimension(); ++j) {
      is_inside = is_inside && box[j].first <= region[j].lower() && region[j].upper() <= box[j].second;
      simplest.push_back(simplest_rational_between(region[j].lower(), region[j].upper()));
    }
    if (is_inside && is_admissible(region))
      return true;
    bool is_in_box = true;
    for (std::size_t j = 0; j < dimension(); ++j)
      is_in_box = is_in_box && box[j].first <= simplest[j] && simplest[j] <= box[j].second;
    if (is_in_box && is_rational_solution(simplest)) // the only zero
      return true;
    shrunk = image(region, false);
  }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Elementary_proof::has_one_solution(const Ranges& box) const
{
  constexpr mpfr_prec_t bits = 256;
  constexpr int inflations[] = {160, 120, 90, 60, 45}; // by 2^-k
  if (m_equalities.size() != dimension())
    return false;
  const Mpfr_precision_scope precision(bits);
  for (const int k : inflations) {
    Box region;
    for (const auto& [lower, upper] : box) {
      const Exact_rational size = (std::max)(Exact_rational(1), Exact_rational(CGAL::abs(lower)));
      const Exact_rational margin = (upper - lower) / 8 + size * scaled_rational(Big_integer(1), -k);
      region.emplace_back(Exact_rational(lower - margin), Exact_rational(upper + margin));
    }
    if (is_root_proved(std::move(region), box))
      return true;
  }
  return false;
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
