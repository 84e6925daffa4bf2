// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_BOX_LIFTING_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_BOX_LIFTING_H

#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Glance_at_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Whether the system has so many equalities less than unknowns, of proper ranges, and some to eliminate an unknown by.
inline bool may_eliminate(const Constraint_system_d& system, std::size_t freedom)
{
  if (system.equalities().size() + freedom != static_cast<std::size_t>(system.dimension()))
    return false;
  for (int j = 0; j < system.dimension(); ++j)
    if (system.domain(j).first == system.domain(j).second)
      return false;
  return Glance_at_system(system).may_eliminate();
}

/*
Boxes of a system from which unknowns were eliminated, with the ranges of these. All solutions, except for undecided
ones, are in the domain if no set of solutions reaches a bound on an eliminated unknown, and no vertex lies beyond one.
*/
class Box_lifting
{
  const Constraint_system_d& m_system;
  const System_part& m_part;
  const std::vector<Eliminated_unknown>& m_eliminated;
  bool m_is_in_domain = true;

public:
  Box_lifting(const Constraint_system_d& system, const System_decomposition& decomposition)
    : m_system(system), m_part(decomposition.parts.front()), m_eliminated(decomposition.eliminated)
  {}

  // The part with an equality more, for each bound on an eliminated unknown: what lies on it.
  std::vector<Constraint_system_d> systems_on_bounds() const
  {
    std::vector<Constraint_system_d> result;
    for (const Eliminated_unknown& eliminated : m_eliminated) {
      const auto range = range_in_part(eliminated);
      const auto& [lower, upper] = m_system.domain(eliminated.unknown);
      if (range.first < lower)
        result.push_back(system_where(eliminated, lower));
      if (upper < range.second)
        result.push_back(system_where(eliminated, upper));
    }
    return result;
  }

  int unknown(int of_part) const { return m_part.unknowns[static_cast<std::size_t>(of_part)]; }

  // With the ranges of eliminated unknowns in their domains, or else outside of them.
  Exact_box operator()(const Exact_box& of_part) const
  {
    Exact_box box = placed(of_part);
    for (const Eliminated_unknown& eliminated : m_eliminated) {
      const auto range = range_of(eliminated, box), domain = m_system.domain(eliminated.unknown);
      const bool meets = range.first <= domain.second && domain.first <= range.second;
      box[eliminated.unknown] =
          meets ? std::pair((std::max)(range.first, domain.first), (std::min)(range.second, domain.second)) : range;
    }
    return box;
  }

  // The same of a vertex.
  Exact_box vertex(const Exact_box& of_part)
  {
    const Exact_box box = placed(of_part);
    for (const Eliminated_unknown& eliminated : m_eliminated) {
      const auto range = range_of(eliminated, box), domain = m_system.domain(eliminated.unknown),
                 all = range_in_part(eliminated);
      m_is_in_domain = m_is_in_domain &&
          (domain.first < range.first || is_bound(domain.first, all.first, eliminated)) &&
          (range.second < domain.second || is_bound(all.second, domain.second, eliminated));
    }
    return (*this)(of_part);
  }

  // Of all vertices until now.
  bool are_in_domain() const { return m_is_in_domain; }

  // With the values of eliminated unknowns.
  std::vector<Exact_rational> point(const std::vector<Exact_rational>& of_part) const
  {
    Exact_box box;
    for (const Exact_rational& x : of_part)
      box.emplace_back(x, x);
    box = placed(box);
    for (const Eliminated_unknown& eliminated : m_eliminated)
      box[eliminated.unknown] = range_of(eliminated, box);
    return middle_of(box);
  }

private:
  // No value in the domain of the part is beyond the bound. On it are points on the boundary of the domain of the part,
  // unless the value is constant.
  static bool is_bound(const Exact_rational& less, const Exact_rational& more, const Eliminated_unknown& eliminated)
  {
    return less <= more && !eliminated.slopes.empty();
  }

  Constraint_system_d::Domain range_in_part(const Eliminated_unknown& eliminated) const
  {
    Exact_box part;
    for (int j = 0; j < m_part.system.dimension(); ++j)
      part.push_back(m_part.system.domain(j));
    return range_of(eliminated, placed(part));
  }

  Constraint_system_d system_where(const Eliminated_unknown& eliminated, const Exact_rational& value) const
  {
    Power_polynomial difference(Exact_rational(eliminated.constant - value));
    for (const auto& [unknown, slope] : eliminated.slopes) {
      const auto place = std::lower_bound(m_part.unknowns.begin(), m_part.unknowns.end(), unknown);
      difference +=
          Power_polynomial(slope) * Power_polynomial::variable(static_cast<int>(place - m_part.unknowns.begin()));
    }
    Constraint_system_d result = m_part.system;
    result.add(Spline_function(difference), Relation::EQUAL);
    return result;
  }

  Exact_box placed(const Exact_box& of_part) const
  {
    Exact_box result(static_cast<std::size_t>(m_system.dimension()));
    for (std::size_t j = 0; j < of_part.size(); ++j)
      result[m_part.unknowns[j]] = of_part[j];
    return result;
  }
};

/*
Eliminates unknowns from a system with `freedom` equalities less than unknowns, where no set of solutions of what is
left reaches a bound on one of them: `is_empty(system)` proves that a system has no solutions.
*/
template <class Is_empty>
System_decomposition elimination_within_bounds(const Constraint_system_d& system, std::size_t freedom,
                                               Run_control& control, const Is_empty& is_empty)
{
  if (!may_eliminate(system, freedom))
    return {};
  try {
    System_decomposition result = elimination_of(system, freedom, [&] { control.check(); });
    if (result.eliminated.empty())
      return {};
    const auto on_bounds = Box_lifting(system, result).systems_on_bounds();
    return std::all_of(on_bounds.begin(), on_bounds.end(), is_empty) ? result : System_decomposition();
  } catch (const Run_stopped&) { // so are the runs that follow
    return {};
  }
}

// Of the run that is to prove, after some work, that a bound is not reached: few nodes.
inline Solver_options options_for_bound(const Solver_options& options, const Summary& work, Run_control& control)
{
  constexpr std::size_t most_nodes = 500;
  Solver_options result = control.options_of_parts(rest_of(options, work));
  result.node_limit = result.node_limit == 0 ? most_nodes : (std::min)(result.node_limit, most_nodes);
  return result;
}

// Something is undecided since the run was ended.
template <class Region>
bool has_limits_reached(const std::vector<Region>& undecided)
{
  return std::any_of(undecided.begin(), undecided.end(), [](const Region& region) {
    return region.reason == Undecided_reason::TIME || region.reason == Undecided_reason::NODES ||
        region.reason == Undecided_reason::STOPPED;
  });
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_BOX_LIFTING_H
