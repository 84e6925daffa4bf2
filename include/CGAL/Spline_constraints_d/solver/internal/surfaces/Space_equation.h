// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SPACE_EQUATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SPACE_EQUATION_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Interval_polynomial.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The one equality in three unknowns that a system without breaks comes down to when each of the others gives one more
unknown as a polynomial in these, and that is in no other: those that stand for inequalities and features do. Where the
values of these lie inside of their ranges, the surface is a graph over that of the one equality in space. If all
equalities give unknowns, the first one is taken, as for a graph over a plane.
*/
class Space_equation
{
  // An unknown that an equality gives, with its coefficient there, and its value as a polynomial of those in space.
  struct Given
  {
    int unknown;
    std::size_t equality;
    Exact_rational coefficient;
    Power_polynomial value = {};
  };

  const Constraint_system_d* m_system;
  std::array<int, 3> m_unknowns{};
  std::size_t m_equality = 0;
  std::vector<Given> m_given;
  std::vector<Interval_polynomial> m_values; // of what is given, in this order, for bounds

  explicit Space_equation(const Constraint_system_d& system) : m_system(&system) {}

public:
  // None if a system is no such.
  static std::optional<Space_equation> of(const Constraint_system_d& system)
  {
    const std::size_t n = static_cast<std::size_t>(system.dimension());
    if (n < 3 || system.equalities().size() != n - 2)
      return std::nullopt;
    Space_equation result(system);
    std::vector<bool> is_given(n, false);
    std::size_t others = 0;
    for (std::size_t e = 0; e < n - 2; ++e)
      if (const std::optional<Given> given = given_by(system, e)) {
        result.m_given.push_back(*given);
        is_given[static_cast<std::size_t>(given->unknown)] = true;
      } else {
        result.m_equality = e;
        ++others;
      }
    if (others == 0) {
      is_given[static_cast<std::size_t>(result.m_given.front().unknown)] = false;
      result.m_given.erase(result.m_given.begin());
      others = 1;
    }
    if (others != 1)
      return std::nullopt;
    for (std::size_t j = 0, k = 0; j < n; ++j)
      if (!is_given[j])
        result.m_unknowns[k++] = static_cast<int>(j);
    for (Given& given : result.m_given) {
      given.value = result.in_space(given.equality) * Power_polynomial(Exact_rational(-1 / given.coefficient));
      result.m_values.emplace_back(given.value);
    }
    return result;
  }

  // Of the system, those of the equality in space; and its index.
  const std::array<int, 3>& unknowns() const { return m_unknowns; }
  std::size_t index() const { return m_equality; }

  // In the unknowns 0, 1 and 2.
  Power_polynomial polynomial() const { return in_space(m_equality); }

  // What a box is in space.
  Exact_ranges part_of(const Exact_ranges& box) const
  {
    Exact_ranges result;
    for (const int j : m_unknowns)
      result.push_back(box[static_cast<std::size_t>(j)]);
    return result;
  }

  // The place of an unknown among those in space.
  std::optional<std::size_t> place_of(int unknown) const
  {
    const auto found = std::find(m_unknowns.begin(), m_unknowns.end(), unknown);
    return found == m_unknowns.end() ? std::nullopt
                                     : std::optional(static_cast<std::size_t>(found - m_unknowns.begin()));
  }

  /*
  Whether the solutions in a box are those of the equality in space over it, but for what faces of the domain cut off
  that have only a point p: each side of the box lies inside of its cell, and beyond all values of what is given there;
  or it is one of the domain, and p lies before it, or on it.
  */
  bool is_free_but_for(const Exact_ranges& p, const Exact_ranges& box, const Exact_ranges& cell,
                       const Exact_ranges& domain) const
  {
    const Exact_ranges values = with_values(part_of(box)), point = with_values(p);
    for (std::size_t j = 0; j < box.size(); ++j) {
      const auto& [lower, upper] = box[j];
      const auto& [least, most] = point[j];
      const bool is_given = !place_of(static_cast<int>(j));
      const bool is_lower_free = is_given ? lower < values[j].first : cell[j].first < lower && lower < least,
                 is_upper_free = is_given ? values[j].second < upper : upper < cell[j].second && most < upper;
      const auto is_on = [&point, j](const Exact_rational& end) {
        return point[j].first == end && point[j].second == end;
      };
      if (!is_lower_free && !(lower == domain[j].first && (lower < least || is_on(lower))))
        return false;
      if (!is_upper_free && !(upper == domain[j].second && (most < upper || is_on(upper))))
        return false;
    }
    return true;
  }

  // A box in space, and bounds of what is given there; those of a rational point are exact.
  Exact_ranges with_values(const Exact_ranges& box_in_space) const
  {
    Exact_ranges result(m_given.size() + 3);
    std::vector<Exact_rational> point;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [lower, upper] = box_in_space[k];
      result[static_cast<std::size_t>(m_unknowns[k])] = {lower, upper};
      if (lower == upper)
        point.push_back(lower);
    }
    const Upward_rounding_guard guard;
    const Interval_box box = intervals_of(box_in_space);
    for (std::size_t i = 0; i < m_given.size(); ++i) {
      auto& range = result[static_cast<std::size_t>(m_given[i].unknown)];
      if (point.size() == 3) {
        const Exact_rational value = m_given[i].value(point);
        range = {value, value};
      } else {
        const Interval value = m_values[i](box).value;
        range = {Exact_rational(value.inf()), Exact_rational(value.sup())};
      }
    }
    return result;
  }

  // Of an unknown as a function in space, bounded in a box there.
  Interval_box gradient_of(int unknown, const Exact_ranges& box_in_space) const
  {
    Interval_box result{Interval(0), Interval(0), Interval(0)};
    if (const std::optional<std::size_t> place = place_of(unknown))
      result[*place] = Interval(1);
    else {
      const Upward_rounding_guard guard;
      const auto given =
          std::find_if(m_given.begin(), m_given.end(), [&](const Given& own) { return own.unknown == unknown; });
      result = m_values[static_cast<std::size_t>(given - m_given.begin())](intervals_of(box_in_space)).gradient;
    }
    return result;
  }

private:
  static Interval_box intervals_of(const Exact_ranges& box)
  {
    Interval_box result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = Interval(interval_of(box[k].first).inf(), interval_of(box[k].second).sup());
    return result;
  }

  // The unknown that an equality gives: it is in no other, and here in a term of its own, of degree one.
  static std::optional<Given> given_by(const Constraint_system_d& system, std::size_t equality)
  {
    const auto terms_with = [&](std::size_t e, int unknown) {
      const std::vector<Spline_term>& terms = system.equalities()[e].terms();
      return std::count_if(terms.begin(), terms.end(), [&](const Spline_term& term) {
        return std::find(term.variables.begin(), term.variables.end(), unknown) != term.variables.end();
      });
    };
    for (const Spline_term& term : system.equalities()[equality].terms()) {
      if (term.degrees != std::vector<int>{1} || term.pieces.size() != 1 || term.pieces[0][1] == 0)
        continue;
      std::ptrdiff_t count = 0;
      for (std::size_t e = 0; e < system.equalities().size(); ++e)
        count += terms_with(e, term.variables[0]);
      if (count == 1)
        return Given{term.variables[0], equality, term.pieces[0][1]};
    }
    return std::nullopt;
  }

  // An equality where what is given is zero.
  Power_polynomial in_space(std::size_t equality) const
  {
    Partial_point values(static_cast<std::size_t>(m_system->dimension()));
    for (const Given& given : m_given)
      values[static_cast<std::size_t>(given.unknown)] = Exact_rational(0);
    return *restricted(m_system->equalities()[equality], values);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SPACE_EQUATION_H
