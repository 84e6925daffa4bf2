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
values of these lie inside of their ranges, the surface is a graph over that of the one equality in space.
*/
class Space_equation
{
  // An unknown that an equality gives, with its coefficient there.
  struct Given
  {
    int unknown;
    std::size_t equality;
    Exact_rational coefficient;
  };

  const Constraint_system_d* m_system;
  std::array<int, 3> m_unknowns{};
  std::size_t m_equality = 0;
  std::vector<Given> m_given;
  std::vector<Interval_polynomial> m_values; // of what is given, in this order

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
    if (others != 1)
      return std::nullopt;
    for (std::size_t j = 0, k = 0; j < n; ++j)
      if (!is_given[j])
        result.m_unknowns[k++] = static_cast<int>(j);
    for (const Given& given : result.m_given)
      result.m_values.emplace_back(result.in_space(given.equality) *
                                   Power_polynomial(Exact_rational(-1 / given.coefficient)));
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

  // Whether what is given has values inside of its ranges all over a box.
  bool is_graph_over(const Exact_ranges& box) const
  {
    const Exact_ranges whole = with_values(part_of(box));
    return std::all_of(m_given.begin(), m_given.end(), [&](const Given& given) {
      const auto &value = whole[static_cast<std::size_t>(given.unknown)],
                 &range = box[static_cast<std::size_t>(given.unknown)];
      return range.first < value.first && value.second < range.second;
    });
  }

  // A box in space, and bounds of what is given there.
  Exact_ranges with_values(const Exact_ranges& box_in_space) const
  {
    Exact_ranges result(m_given.size() + 3);
    for (std::size_t k = 0; k < 3; ++k)
      result[static_cast<std::size_t>(m_unknowns[k])] = box_in_space[k];
    const Upward_rounding_guard guard;
    Interval_box box;
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = Interval(interval_of(box_in_space[k].first).inf(), interval_of(box_in_space[k].second).sup());
    for (std::size_t i = 0; i < m_given.size(); ++i) {
      const Interval value = m_values[i](box).value;
      result[static_cast<std::size_t>(m_given[i].unknown)] = {Exact_rational(value.inf()), Exact_rational(value.sup())};
    }
    return result;
  }

private:
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
