// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_POSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_POSITION_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_refinement.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/algebraic_position.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/point_values.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
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
  case Relation::NOT_EQUAL: return lower == 0 && upper == 0;
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
  case Relation::NOT_EQUAL: return lower > 0 || upper < 0;
  case Relation::GREATER: break;
  }
  return lower > 0;
}

/*
Decides whether the root in an enclosure lies in the domain and satisfies the inequalities: by the enclosure at hand, by
the simplest rational point in it (if that is a root, it is *the* root, and everything is decided exactly), and by the
same two for enclosures of 200 and 800 bits. Last, by those of its coordinates that are rational.
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
  Partial_point m_values;   // coordinates that are known exactly
  std::vector<double> m_corner;
  std::optional<Node_view> m_view;   // made when it is needed

public:
  Root_position(const Constraint_system_d& system, const System_layout& layout, Exact_source& source)
    : m_system(system), m_layout(layout), m_source(source)
  {
    m_lower.reserve(layout.dimension);
    m_upper.reserve(layout.dimension);
    for (int j = 0; j < layout.dimension; ++j) {
      m_lower.push_back(to_double_interval(system.domain(j).first));
      m_upper.push_back(to_double_interval(system.domain(j).second));
    }
  }

  Position decide(const Certified_region<Coordinate>& region, const Root_enclosure<Coordinate>& enclosure)
  {
    m_values.assign(m_layout.dimension, std::nullopt);
    Position position = position_of(enclosure);
    if (position == Position::INSIDE || position == Position::OUTSIDE)
      return position;
    if constexpr (std::is_same_v<Coordinate, double>)
      if (finds_corner(enclosure))
        if (const auto exact = position_at(m_corner); exact.first)
          return exact.second;
    Root_enclosure<Exact_rational> fine;
    fine.lower.assign(enclosure.lower.begin(), enclosure.lower.end());
    fine.upper.assign(enclosure.upper.begin(), enclosure.upper.end());
    if (const auto exact = position_of_rational_root(fine); exact.first)
      return exact.second;
    Certified_region<Exact_rational> exact_region;
    exact_region.lower.assign(region.lower.begin(), region.lower.end());
    exact_region.upper.assign(region.upper.begin(), region.upper.end());
    exact_region.inverse = region.inverse;
    exact_region.scale = region.scale;
    exact_region.bounds = region.bounds;
    exact_region.contraction = region.contraction;
    exact_region.weights = region.weights;
    exact_region.source = region.source;
    exact_region.matrix = region.matrix;
    Root_refinement<Exact_rational> refinement;
    for (const int bits : {200, 800}) {
      fine = refinement.refine(exact_region, bits);
      position = position_of(fine);
      if (position == Position::INSIDE || position == Position::OUTSIDE)
        return position;
      if (const auto exact = position_of_rational_root(fine); exact.first)
        return exact.second;
    }
    m_values = rational_coordinates(m_system, exact_region, fine);
    position = position_of(fine);
    return position == Position::INSIDE || position == Position::OUTSIDE
        ? position
        : position_of_algebraic_root(exact_region, fine, position);
  }

private:
  // By exact signs at a root of n of the equalities: in the region it is the one that is asked for if it satisfies the
  // others, and otherwise there is none.
  Position position_of_algebraic_root(const Certified_region<Exact_rational>& region,
                                      const Root_enclosure<Exact_rational>& enclosure, Position unknown)
  {
    Exact_box box;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const Exact_rational lower = (enclosure.lower[j] + region.lower[j]) / Exact_rational(2),
                           upper = (enclosure.upper[j] + region.upper[j]) / Exact_rational(2);
      const Exact_rational reach(0x1p-80);   // a small box, but much wider than the enclosure
      box.emplace_back((std::max)(lower, Exact_rational(enclosure.lower[j] - reach)),
                       (std::min)(upper, Exact_rational(enclosure.upper[j] + reach)));
    }
    const auto equalities = integer_equalities(m_system, box);
    if (!equalities || box.size() < 2)
      return unknown;
    const std::vector<Power_polynomial> ordered = independent_first(*equalities, middle_of(box));
    if (ordered.empty())
      return unknown;
    auto root =
        Algebraic_root::in(Algebraic_equations({ordered.begin(), ordered.begin() + m_layout.dimension}, false), box);
    if (!root)
      return unknown;
    for (std::size_t i = m_layout.dimension; i < ordered.size(); ++i) {
      const auto sign = root->sign_of(ordered[i]);
      if (!sign)
        return Position::ON_EQUALITY;
      if (*sign != CGAL::ZERO)
        return Position::OUTSIDE;
    }
    return algebraic_position(m_system, *root);
  }

  template <class C>
  Position position_of(const Root_enclosure<C>& enclosure)
  {
    bool is_on_boundary = false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const C &lower = enclosure.lower[j], &upper = enclosure.upper[j];
      if (lower >= C(m_lower[j].second) && upper <= C(m_upper[j].first))
        continue;
      if constexpr (std::is_same_v<C, double>)
        if (has_double_ends(j) && !m_values[j]) {
          if (upper < m_lower[j].first || m_upper[j].first < lower)
            return Position::OUTSIDE;
          is_on_boundary = true;
          continue;
        }
      const Exact_rational lo = m_values[j] ? *m_values[j] : Exact_rational(lower),
                           hi = m_values[j] ? *m_values[j] : Exact_rational(upper);
      if (hi < m_system.domain(j).first || m_system.domain(j).second < lo)
        return Position::OUTSIDE;
      is_on_boundary = is_on_boundary || lo < m_system.domain(j).first || m_system.domain(j).second < hi;
    }
    // More equalities than unknowns: the root is one of n combinations of them, and each has to vanish there.
    const bool is_overdetermined = m_layout.equalities > m_layout.dimension;
    bool is_on_inequality = false, is_on_equality = false;
    if (is_overdetermined || !m_system.inequalities().empty()) {
      if (!m_view) {
        m_view.emplace(m_layout);
        m_coefficients.resize(m_layout.size);
        m_errors.resize(m_layout.errors);
      }
      bool is_excluded = true;   // on all pieces
      m_source.visit_cells(
          std::span<const C>(enclosure.lower), std::span<const C>(enclosure.upper), [&](const Cell& cell) {
            m_source.bernstein_coefficients(cell, std::span<const C>(enclosure.lower),
                                            std::span<const C>(enclosure.upper), m_coefficients.data(), m_errors.data(),
                                            m_scale);
            m_view->reset(m_coefficients.data(), m_errors.data());
            bool is_excluded_here = false;
            for (int f = is_overdetermined ? 0 : m_layout.equalities; f < m_layout.functions; ++f) {
              const bool is_equality = f < m_layout.equalities;
              const Relation relation =
                  is_equality ? Relation::EQUAL : m_system.inequalities()[f - m_layout.equalities].relation;
              if (is_certainly_violated(relation, m_view->lower(f), m_view->upper(f)))
                is_excluded_here = true;
              if (!is_certainly_satisfied(relation, m_view->lower(f), m_view->upper(f)) &&
                  !is_satisfied_by_values(f, relation))
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

  // The known coordinates alone decide the function.
  bool is_satisfied_by_values(int f, Relation relation) const
  {
    if (std::none_of(m_values.begin(), m_values.end(), [](const auto& value) { return value.has_value(); }))
      return false;
    const auto polynomial = restricted(function_of(m_system, f), m_values);
    return polynomial && polynomial->is_constant() && is_satisfied(relation, CGAL::sign(polynomial->constant_term()));
  }

  // An end of the domain, or the simplest rational.
  Exact_rational likely_coordinate(int j, const Exact_rational& lower, const Exact_rational& upper) const
  {
    for (const Exact_rational& end : {m_system.domain(j).first, m_system.domain(j).second})
      if (lower <= end && end <= upper)
        return end;
    return simplest_rational_between(lower, upper);
  }

  bool has_double_ends(int j) const
  {
    return m_lower[j].first == m_lower[j].second && m_upper[j].first == m_upper[j].second;
  }

  // Puts a corner of the domain that lies in the enclosure into m_corner, if there is one and its coordinates are
  // doubles.
  bool finds_corner(const Root_enclosure<double>& enclosure)
  {
    m_corner.clear();
    for (int j = 0; j < m_layout.dimension && has_double_ends(j); ++j)
      for (double end : {m_lower[j].first, m_upper[j].first})
        if (enclosure.lower[j] <= end && end <= enclosure.upper[j]) {
          m_corner.push_back(end);
          break;
        }
    return static_cast<int>(m_corner.size()) == m_layout.dimension;
  }

  // The sign of a function at a point: in integers where the coordinates are dyadic.
  template <class C>
  class Signs_at_point
  {
    const Constraint_system_d& m_system;
    const std::vector<C>& m_point;
    std::vector<Exact_source::Value> m_values;

  public:
    Signs_at_point(const Constraint_system_d& system, Exact_source& source, const std::vector<C>& point)
      : m_system(system), m_point(point)
    {
      const std::span<const C> coordinates(point);
      if (std::all_of(point.begin(), point.end(),
                      [](const C& x) { return std::is_same_v<C, double> || is_dyadic(Exact_rational(x)); }))
        source.evaluate(source.cell_of(coordinates), coordinates, m_values);
    }

    CGAL::Sign operator()(int f) const
    {
      if (!m_values.empty())
        return CGAL::sign(m_values[f].mantissa);
      return CGAL::sign(evaluate_exactly(function_of(m_system, f), {m_point.begin(), m_point.end()}));
    }
  };

  std::pair<bool, Position> position_of_rational_root(const Root_enclosure<Exact_rational>& enclosure)
  {
    std::vector<Exact_rational> point;
    for (int j = 0; j < m_layout.dimension; ++j)
      point.push_back(likely_coordinate(j, enclosure.lower[j], enclosure.upper[j]));
    return position_at(point);
  }

  // Whether the equalities vanish at a point, and if so, where it is.
  template <class C>
  std::pair<bool, Position> position_at(const std::vector<C>& point)
  {
    const Signs_at_point<C> sign(m_system, m_source, point);
    for (int f = 0; f < m_layout.equalities; ++f)
      if (sign(f) != CGAL::ZERO)
        return {false, Position::INSIDE};
    for (int j = 0; j < m_layout.dimension; ++j)
      if (const Exact_rational x(point[j]); x < m_system.domain(j).first || m_system.domain(j).second < x)
        return {true, Position::OUTSIDE};
    for (int f = m_layout.equalities; f < m_layout.functions; ++f)
      if (!is_satisfied(m_system.inequalities()[f - m_layout.equalities].relation, sign(f)))
        return {true, Position::OUTSIDE};
    return {true, Position::INSIDE};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_POSITION_H
