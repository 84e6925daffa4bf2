// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SPARSE_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SPARSE_SYSTEM_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/numbers.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The range of each unknown.
using Box_of_ranges = std::vector<Interval>;

// To the smallest box around both.
inline void extend(Box_of_ranges& box, const Box_of_ranges& by)
{
  for (std::size_t j = 0; j < box.size(); ++j)
    box[j] = Interval((std::min)(box[j].inf(), by[j].inf()), (std::max)(box[j].sup(), by[j].sup()));
}

// A function of scale times an unknown plus shift.
struct Elementary_term
{
  elementary::Operation operation;
  int unknown = 0;
  Interval scale = Interval(1), shift = Interval(0);

  Interval argument(const Box_of_ranges& box) const { return scale * box[unknown] + shift; }
};
// By the indices that they have in polynomials: numbers anywhere, functions as terms of their own.
struct Elementary_terms
{
  elementary::Numbers numbers;
  std::map<int, Elementary_term> functions;
};

/*
Constraints as sums of monomials, laid out for passes over them: of each constraint the parts in one unknown alone,
which are bounded as polynomials in it, multiples of elementary functions of an unknown, and the other terms, whose
monomials are shared by all constraints. The last unknowns may be defined by the last constraints, each by one, as what
the constraint is without them and in terms of unknowns before them.
*/
class Sparse_system
{
public:
  struct Factor
  {
    int unknown, exponent;
  };
  // Coefficients of the powers 1, 2, ... of an unknown.
  struct Univariate_part
  {
    int unknown, degree;
    std::size_t first_coefficient;
  };
  // A multiple of an elementary function.
  struct Elementary_part
  {
    int function;
    Interval coefficient;
  };
  struct Mixed_term
  {
    int monomial;
    Interval coefficient;
  };
  // Where an unknown occurs in a constraint: its univariate part, or -1, and factors of mixed terms.
  struct Occurrence
  {
    int unknown, part, degree;
    std::size_t first_place, last_place;
  };
  struct Place
  {
    int term;
    std::size_t factor;
  };

private:
  int m_dimension, m_defined;
  std::vector<Interval> m_constants, m_slack, m_coefficients;
  std::vector<Univariate_part> m_parts;
  std::vector<Mixed_term> m_terms;
  std::vector<Elementary_term> m_functions;
  std::map<int, int> m_places_of_functions;
  std::vector<Elementary_part> m_elementary_parts;
  std::vector<Factor> m_factors;
  std::vector<Occurrence> m_occurrences;
  std::vector<Place> m_places;
  std::vector<std::size_t> m_first_part{0}, m_first_term{0}, m_first_factor{0}, m_first_occurrence{0},
      m_first_elementary_part{0};
  std::vector<std::vector<int>> m_constraints_of;
  std::vector<int> m_equalities, m_degrees;

public:
  // Of polynomials that are compared with zero. `check()` may end the work by an exception.
  Sparse_system(int dimension, const std::vector<Polynomial_constraint>& constraints,
                const std::function<void()>& check, const Elementary_terms& elementary_terms = {}, int defined = 0);

  int dimension() const { return m_dimension; }
  // How many unknowns, the last ones, are defined.
  int defined() const { return m_defined; }
  // No functions and no unknowns that stand for them.
  bool is_polynomial() const { return m_functions.empty() && m_defined == 0; }
  // The constraint that defines one of them.
  int definition(int unknown) const { return constraints() - dimension() + unknown; }
  int constraints() const { return static_cast<int>(m_constants.size()); }
  std::size_t monomials() const { return m_first_factor.size() - 1; }
  std::size_t factors() const { return m_factors.size(); }

  // The constraints that are equalities.
  const std::vector<int>& equalities() const { return m_equalities; }
  // The largest exponent of an unknown in univariate parts.
  int degree(int unknown) const { return m_degrees[unknown]; }
  const std::vector<int>& constraints_of(int unknown) const { return m_constraints_of[unknown]; }

  const Interval& constant(int constraint) const { return m_constants[constraint]; }
  // A constraint says that its function plus some number of this interval is zero.
  const Interval& slack(int constraint) const { return m_slack[constraint]; }

  std::span<const Univariate_part> parts(int constraint) const { return slice(m_parts, m_first_part, constraint); }
  std::span<const Mixed_term> terms(int constraint) const { return slice(m_terms, m_first_term, constraint); }
  std::span<const Elementary_part> elementary_parts(int constraint) const
  {
    return slice(m_elementary_parts, m_first_elementary_part, constraint);
  }
  int functions() const { return static_cast<int>(m_functions.size()); }
  const Elementary_term& function(int index) const { return m_functions[index]; }
  std::span<const Occurrence> occurrences(int constraint) const
  {
    return slice(m_occurrences, m_first_occurrence, constraint);
  }
  std::span<const Interval> coefficients(const Univariate_part& part) const
  {
    return {m_coefficients.data() + part.first_coefficient, static_cast<std::size_t>(part.degree)};
  }
  std::span<const Place> places(const Occurrence& occurrence) const
  {
    return {m_places.data() + occurrence.first_place, occurrence.last_place - occurrence.first_place};
  }
  // Whether an unknown is in several of the parts and terms of a constraint.
  bool repeats_unknown(int constraint) const
  {
    const auto functions = elementary_parts(constraint);
    return std::ranges::any_of(occurrences(constraint), [&](const Occurrence& o) {
      return places(o).size() + (o.part >= 0 ? 1 : 0) > 1 ||
          std::ranges::any_of(functions,
                              [&](const Elementary_part& p) { return function(p.function).unknown == o.unknown; });
    });
  }
  std::size_t first_factor(int monomial) const { return m_first_factor[monomial]; }
  std::size_t last_factor(int monomial) const { return m_first_factor[monomial + 1]; }
  const Factor& factor(std::size_t index) const { return m_factors[index]; }

  // The product of the factors of a monomial but one, on a box; all of them by default.
  Interval product(int monomial, const Box_of_ranges& box,
                   std::size_t but = (std::numeric_limits<std::size_t>::max)()) const
  {
    Interval result(1);
    bool is_first = true;
    for (std::size_t f = first_factor(monomial); f < last_factor(monomial); ++f)
      if (f != but) {
        const Interval value = power(box[m_factors[f].unknown], m_factors[f].exponent);
        result = is_first ? value : result * value;
        is_first = false;
      }
    return result;
  }

  // The values of the function of a constraint on a box; any where it is not certain to be defined.
  Interval value(int constraint, const Box_of_ranges& box) const;

  // A constraint as a polynomial in one of its unknowns, the others being in their ranges, but for its constant term.
  void set_polynomial_in(const Occurrence& occurrence, int constraint, const Box_of_ranges& box,
                         Univariate_interval_polynomial& polynomial) const
  {
    polynomial.reset(occurrence.degree);
    if (occurrence.part >= 0) {
      const auto part = coefficients(parts(constraint)[occurrence.part]);
      for (std::size_t e = 0; e < part.size(); ++e)
        polynomial[static_cast<int>(e) + 1] = part[e];
    }
    for (const Place& place : places(occurrence)) {
      const Mixed_term& term = terms(constraint)[place.term];
      polynomial[m_factors[place.factor].exponent] += term.coefficient * product(term.monomial, box, place.factor);
    }
  }

private:
  template <class T>
  static std::span<const T> slice(const std::vector<T>& all, const std::vector<std::size_t>& first, int index)
  {
    return {all.data() + first[index], first[index + 1] - first[index]};
  }

  void add(const Power_polynomial& polynomial, Relation relation, std::map<Monomial, int>& monomials,
           const Elementary_terms& elementary_terms);
  void add_elementary_part(int symbol, const Interval& coefficient, const Elementary_terms& elementary_terms);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE
Sparse_system::Sparse_system(int dimension, const std::vector<Polynomial_constraint>& constraints,
                             const std::function<void()>& check, const Elementary_terms& elementary_terms, int defined)
  : m_dimension(dimension), m_defined(defined), m_constraints_of(dimension), m_degrees(dimension, 0)
{
  std::map<Monomial, int> monomials;
  for (const auto& [polynomial, relation] : constraints) {
    check();
    add(polynomial, relation, monomials, elementary_terms);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Interval Sparse_system::value(int constraint, const Box_of_ranges& box) const
{
  Interval result = m_constants[constraint];
  Univariate_interval_polynomial polynomial;
  for (const Univariate_part& part : parts(constraint)) {
    const auto own = coefficients(part);
    polynomial.reset(part.degree);
    for (int e = 1; e <= part.degree; ++e)
      polynomial[e] = own[e - 1];
    result += polynomial.range(box[part.unknown]);
  }
  for (const Mixed_term& term : terms(constraint))
    result += term.coefficient * product(term.monomial, box);
  for (const Elementary_part& part : elementary_parts(constraint)) {
    const Elementary_term& symbol = m_functions[part.function];
    const Interval argument = symbol.argument(box);
    if (!elementary::is_in_domain(symbol.operation, argument))
      return elementary::entire_line();
    result += part.coefficient * elementary::range_of_values(symbol.operation, argument);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Sparse_system::add_elementary_part(int symbol, const Interval& coefficient,
                                                                       const Elementary_terms& elementary_terms)
{
  const auto [place, is_new] = m_places_of_functions.try_emplace(symbol, functions());
  if (is_new)
    m_functions.push_back(elementary_terms.functions.at(symbol));
  m_elementary_parts.push_back({place->second, coefficient});
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Sparse_system::add(const Power_polynomial& polynomial, Relation relation,
                                                       std::map<Monomial, int>& monomials,
                                                       const Elementary_terms& elementary_terms)
{
  struct Own
  {
    std::vector<Interval> coefficients;
    std::vector<Place> places;
    int degree = 0;
  };
  const int constraint = constraints();
  std::map<int, Own> of_unknowns;
  Interval constant(0);
  const auto add_term = [&](const Monomial& monomial, const Interval& coefficient) {
    if (monomial.powers.empty()) {
      constant = coefficient;
      return;
    }
    if (monomial.powers.size() == 1) {
      const auto [unknown, exponent] = monomial.powers.front();
      if (unknown >= m_dimension) {
        add_elementary_part(unknown, coefficient, elementary_terms);
        return;
      }
      Own& own = of_unknowns[unknown];
      if (static_cast<int>(own.coefficients.size()) < exponent)
        own.coefficients.resize(exponent, Interval(0));
      own.coefficients[exponent - 1] = coefficient;
      return;
    }
    const auto [position, is_new] = monomials.try_emplace(monomial, static_cast<int>(this->monomials()));
    if (is_new) {
      for (const auto& [unknown, exponent] : monomial.powers)
        m_factors.push_back({unknown, exponent});
      m_first_factor.push_back(m_factors.size());
    }
    const int term = static_cast<int>(m_terms.size() - m_first_term.back());
    m_terms.push_back({position->second, coefficient});
    std::size_t factor = m_first_factor[position->second];
    for (const auto& [unknown, exponent] : monomial.powers) {
      Own& own = of_unknowns[unknown];
      own.places.push_back({term, factor++});
      own.degree = (std::max)(own.degree, exponent);
    }
  };
  if (elementary_terms.numbers.empty())
    for (const auto& [monomial, coefficient] : polynomial.terms())
      add_term(monomial, enclosure_of(coefficient));
  else
    for (const auto& [monomial, coefficient] : elementary::without_numbers(polynomial, elementary_terms.numbers))
      add_term(monomial, coefficient);
  int parts = 0;
  for (const auto& [unknown, own] : of_unknowns) {
    const int degree = static_cast<int>(own.coefficients.size());
    m_occurrences.push_back({unknown, degree > 0 ? parts : -1, (std::max)(degree, own.degree), m_places.size(),
                             m_places.size() + own.places.size()});
    m_places.insert(m_places.end(), own.places.begin(), own.places.end());
    m_constraints_of[unknown].push_back(constraint);
    if (degree > 0) {
      m_parts.push_back({unknown, degree, m_coefficients.size()});
      m_coefficients.insert(m_coefficients.end(), own.coefficients.begin(), own.coefficients.end());
      m_degrees[unknown] = (std::max)(m_degrees[unknown], degree);
      ++parts;
    }
  }
  m_first_elementary_part.push_back(m_elementary_parts.size());
  for (const Elementary_part& part : elementary_parts(constraint)) {
    std::vector<int>& others = m_constraints_of[m_functions[part.function].unknown];
    if (others.empty() || others.back() != constraint)
      others.push_back(constraint);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool is_upper = relation == Relation::LESS || relation == Relation::LESS_EQUAL;
  const bool is_lower = relation == Relation::GREATER || relation == Relation::GREATER_EQUAL;
  if (relation == Relation::EQUAL)
    m_equalities.push_back(constraint);
  const bool is_any = relation == Relation::NOT_EQUAL;
  m_slack.emplace_back(is_lower || is_any ? -infinity : 0.0, is_upper || is_any ? infinity : 0.0);
  m_constants.push_back(constant);
  m_first_part.push_back(m_parts.size());
  m_first_term.push_back(m_terms.size());
  m_first_occurrence.push_back(m_occurrences.size());
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SPARSE_SYSTEM_H
