// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_POSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_POSITION_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Root_refinement.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// No value in [lower, upper] satisfies the relation to zero.
inline bool is_certainly_violated(Relation relation, double lower, double upper)
{
  switch (relation) {
  case Relation::EQUAL: return lower > 0 || upper < 0;
  case Relation::LESS: return lower >= 0;
  case Relation::LESS_EQUAL: return lower > 0;
  case Relation::GREATER_EQUAL: return upper < 0;
  case Relation::GREATER: break;
  }
  return upper <= 0;
}

// Every value in [lower, upper] satisfies the relation to zero.
inline bool is_certainly_satisfied(Relation relation, double lower, double upper)
{
  switch (relation) {
  case Relation::EQUAL: return lower == 0 && upper == 0;
  case Relation::LESS: return upper < 0;
  case Relation::LESS_EQUAL: return upper <= 0;
  case Relation::GREATER_EQUAL: return lower >= 0;
  case Relation::GREATER: break;
  }
  return lower > 0;
}

// The value of a spline at any rational point, in exact arithmetic.
inline Exact_rational evaluate_exactly(const Spline_function& function, const std::vector<Exact_rational>& point)
{
  Exact_rational sum(0);
  for (const Spline_term& term : function.terms()) {
    std::size_t cell = 0;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      const auto& breaks = term.breaks[j];
      std::size_t own = 0;
      while (own + 1 < term.cells(j) && breaks[own + 1] <= point[term.variables[j]])
        ++own;
      cell = cell * term.cells(j) + own;
    }
    std::vector<Exact_rational> values = term.pieces[cell];
    for (std::size_t j = term.variables.size(); j-- > 0;) {   // Horner along the last axis that is left
      const std::size_t line = static_cast<std::size_t>(term.degrees[j]) + 1, lines = values.size() / line;
      for (std::size_t i = 0; i < lines; ++i) {
        Exact_rational value = values[i * line + line - 1];
        for (std::size_t k = line - 1; k-- > 0;)
          value = value * point[term.variables[j]] + values[i * line + k];
        values[i] = value;
      }
      values.resize(lines);
    }
    sum += values[0];
  }
  return sum;
}

// Whether a spline without breaks is zero on the whole hyperplane where an unknown has a value, in exact arithmetic.
inline bool vanishes_where(const Spline_function& function, int unknown, const Exact_rational& value)
{
  std::map<std::vector<std::pair<int, int>>, Exact_rational> sum;   // monomials of the other unknowns
  for (const Spline_term& term : function.terms()) {
    if (term.pieces.size() != 1)
      return false;
    std::vector<int> k(term.degrees.size(), 0);
    for (const Exact_rational& coefficient : term.pieces[0]) {
      Exact_rational factor = coefficient;
      std::vector<std::pair<int, int>> monomial;
      for (std::size_t j = 0; j < k.size(); ++j)
        if (term.variables[j] != unknown && k[j] > 0)
          monomial.emplace_back(term.variables[j], k[j]);
        else if (term.variables[j] == unknown)
          for (int power = 0; power < k[j]; ++power)
            factor *= value;
      sum[monomial] += factor;
      for (std::size_t j = k.size(); j-- > 0 && ++k[j] > term.degrees[j];)
        k[j] = 0;
    }
  }
  return std::all_of(sum.begin(), sum.end(), [](const auto& entry) { return entry.second == Exact_rational(0); });
}

enum class Position { INSIDE, OUTSIDE, ON_DOMAIN_BOUNDARY, ON_INEQUALITY, ON_EQUALITY };

/*
Decides whether the root in an enclosure lies in the domain and satisfies the inequalities: by the enclosure at hand, by the simplest rational
point in it (if that is a root, it is *the* root, and everything is decided exactly), and by the same two for enclosures of 200 and 800 bits.
*/
template <class NT>
class Root_position
{
  using Coordinate = typename Number_traits<NT>::Coordinate;

  const Constraint_system_d& m_system;
  const System_layout& m_layout;
  Exact_source& m_source;
  std::vector<std::pair<double, double>> m_lower, m_upper;   // double enclosures of the ends of the domain
  std::vector<double> m_coefficients, m_errors;
  std::vector<long> m_scale;
  std::vector<bool> m_is_pinned;   // coordinates that are known to be exactly an end of the domain
  Node_view m_view;

public:
  Root_position(const Constraint_system_d& system, const System_layout& layout, Exact_source& source)
    : m_system(system), m_layout(layout), m_source(source), m_coefficients(layout.size), m_errors(layout.errors), m_view(layout)
  {
    for (int j = 0; j < layout.dimension; ++j) {
      m_lower.push_back(to_double_interval(system.domain(j).first));
      m_upper.push_back(to_double_interval(system.domain(j).second));
    }
  }

  Position decide(const Certified_region<Coordinate>& region, const Root_enclosure<Coordinate>& enclosure)
  {
    m_is_pinned.assign(m_layout.dimension, false);
    Position position = position_of(enclosure);
    if (position == Position::INSIDE || position == Position::OUTSIDE)
      return position;
    Certified_region<Exact_rational> exact_region;
    exact_region.lower.assign(region.lower.begin(), region.lower.end());
    exact_region.upper.assign(region.upper.begin(), region.upper.end());
    exact_region.inverse = region.inverse;
    exact_region.scale = region.scale;
    exact_region.bounds = region.bounds;
    exact_region.contraction = region.contraction;
    Root_refinement<Exact_rational> refinement(m_layout, m_source);
    Root_enclosure<Exact_rational> fine;
    fine.lower.assign(enclosure.lower.begin(), enclosure.lower.end());
    fine.upper.assign(enclosure.upper.begin(), enclosure.upper.end());
    for (const int bits : {200, 800}) {
      if (const auto exact = position_of_rational_root(fine); exact.first)
        return exact.second;
      fine = refinement.refine(exact_region, bits);
      position = position_of(fine);
      if (position == Position::INSIDE || position == Position::OUTSIDE)
        return position;
    }
    if (const auto exact = position_of_rational_root(fine); exact.first)
      return exact.second;
    return pin_to_boundary(fine) ? position_of(fine) : position;
  }

private:
  /*
  An equality that is zero on the whole face x_j = a, and whose derivative by x_j is not zero in the enclosure, has all its zeros there on that face: 0 = f(x) - f(x
  with x_j = a) = (x_j - a) times a value of the derivative. Such a coordinate is exactly a. Returns whether there is one.
  */
  bool pin_to_boundary(const Root_enclosure<Exact_rational>& enclosure)
  {
    using Corner = std::span<const Exact_rational>;
    m_source.bernstein_coefficients(m_source.cell_of(Corner(enclosure.lower)), Corner(enclosure.lower), Corner(enclosure.upper),
                                    m_coefficients.data(), m_errors.data(), m_scale);
    m_view.reset(m_coefficients.data(), m_errors.data());
    bool has_pinned = false;
    for (int j = 0; j < m_layout.dimension; ++j)
      for (const Exact_rational& end : {m_system.domain(j).first, m_system.domain(j).second})
        if (enclosure.lower[j] < end && end < enclosure.upper[j])
          for (int i = 0; i < m_layout.equalities; ++i)
            if ((m_view.derivative_lower(i)[j] > 0 || m_view.derivative_upper(i)[j] < 0) &&
                vanishes_where(m_system.equalities()[i], j, end)) {
              m_is_pinned[j] = has_pinned = true;
              break;
            }
    return has_pinned;
  }

  template <class C>
  Position position_of(const Root_enclosure<C>& enclosure)
  {
    bool is_on_boundary = false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const C &lower = enclosure.lower[j], &upper = enclosure.upper[j];
      if (m_is_pinned[j] || (lower >= C(m_lower[j].second) && upper <= C(m_upper[j].first)))
        continue;
      const Exact_rational lo(lower), hi(upper);
      if (hi < m_system.domain(j).first || m_system.domain(j).second < lo)
        return Position::OUTSIDE;
      is_on_boundary = is_on_boundary || lo < m_system.domain(j).first || m_system.domain(j).second < hi;
    }
    // More equalities than unknowns: the root is one of n combinations of them, and each has to vanish there.
    const bool is_overdetermined = m_layout.equalities > m_layout.dimension;
    bool is_on_inequality = false, is_on_equality = false;
    if (is_overdetermined || !m_system.inequalities().empty()) {
      bool is_excluded = true;   // on all pieces
      m_source.visit_cells(std::span<const C>(enclosure.lower), std::span<const C>(enclosure.upper), [&](const Cell& cell) {
        m_source.bernstein_coefficients(cell, std::span<const C>(enclosure.lower), std::span<const C>(enclosure.upper),
                                        m_coefficients.data(), m_errors.data(), m_scale);
        m_view.reset(m_coefficients.data(), m_errors.data());
        bool is_excluded_here = false;
        for (int f = is_overdetermined ? 0 : m_layout.equalities; f < m_layout.functions; ++f) {
          const bool is_equality = f < m_layout.equalities;
          const Relation relation = is_equality ? Relation::EQUAL : m_system.inequalities()[f - m_layout.equalities].relation;
          if (is_certainly_violated(relation, m_view.lower(f), m_view.upper(f)))
            is_excluded_here = true;
          if (!is_certainly_satisfied(relation, m_view.lower(f), m_view.upper(f)))
            (is_equality ? is_on_equality : is_on_inequality) = true;
        }
        is_excluded = is_excluded && is_excluded_here;
      });
      if (is_excluded)
        return Position::OUTSIDE;
    }
    return is_on_boundary     ? Position::ON_DOMAIN_BOUNDARY
           : is_on_inequality ? Position::ON_INEQUALITY
           : is_on_equality   ? Position::ON_EQUALITY
                              : Position::INSIDE;
  }

  std::pair<bool, Position> position_of_rational_root(const Root_enclosure<Exact_rational>& enclosure) const
  {
    std::vector<Exact_rational> point;
    for (int j = 0; j < m_layout.dimension; ++j)
      point.push_back(simplest_rational_between(enclosure.lower[j], enclosure.upper[j]));
    for (const Spline_function& function : m_system.equalities())
      if (evaluate_exactly(function, point) != Exact_rational(0))
        return {false, Position::INSIDE};
    for (int j = 0; j < m_layout.dimension; ++j)
      if (point[j] < m_system.domain(j).first || m_system.domain(j).second < point[j])
        return {true, Position::OUTSIDE};
    for (const auto& inequality : m_system.inequalities())
      if (!is_satisfied(inequality.relation, CGAL::sign(evaluate_exactly(inequality.function, point))))
        return {true, Position::OUTSIDE};
    return {true, Position::INSIDE};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_POSITION_H
