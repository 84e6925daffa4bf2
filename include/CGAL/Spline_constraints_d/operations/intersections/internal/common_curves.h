// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_CURVES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Contact_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Curves_through_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Implicit_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Overlapping_patches.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Pole_systems.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Solved_part.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/curves_on_implicit_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The equations of two surfaces, looked for when they are needed.
class Equations_of_surfaces
{
  const Surface_equations& m_surfaces;
  std::array<bool, 2> m_is_known{};
  const Operation_budget& m_budget;
  std::array<std::optional<Power_polynomial>, 2> m_polynomials;

public:
  Equations_of_surfaces(const Surface_equations& surfaces, const Operation_budget& budget)
    : m_surfaces(surfaces), m_budget(budget)
  {}

  const Power_polynomial* operator()(std::size_t surface)
  {
    if (!std::exchange(m_is_known[surface], true))
      m_polynomials[surface] = m_surfaces.is_parametric(surface)
          ? equation_of(*m_surfaces.surface(surface).patch)
          : std::optional(m_surfaces.surface(surface).polynomial);
    return m_polynomials[surface] ? &*m_polynomials[surface] : nullptr;
  }

  const std::array<std::optional<Power_polynomial>, 2>& both()
  {
    for (const std::size_t surface : {0, 1})
      (*this)(surface);
    return m_polynomials;
  }

private:
  // None as well where the run ends before it is found: nothing is solved by it then.
  std::optional<Power_polynomial> equation_of(const Spline_patch<3>& patch) const
  {
    return implicit_equation(patch, [this] { return m_budget.must_stop(); });
  }
};

// The common curves of two parametric surfaces, one of which is an Implicit_patch. Nothing if none is, or not all is
// proved while the equations in all parameters may tell of more.
inline std::optional<Solved_part> curves_on_implicit_patches(const Surface_equations& surfaces,
                                                             Equations_of_surfaces& equations,
                                                             Operation_budget& budget)
{
  if (!surfaces.has_system() || !surfaces.has_all_parameters())
    return std::nullopt;
  std::optional<Solved_part> rest;
  for (const std::size_t implicit : {0, 1}) {
    const Spline_patch<3>& surface = *surfaces.surface(implicit).patch;
    const Power_polynomial* const polynomial = equations(implicit);
    const std::optional<Implicit_patch> patch =
        polynomial != nullptr ? Implicit_patch::make(surface, *polynomial) : std::nullopt;
    if (!patch)
      continue;
    const Curves_on_implicit_patch curves(surfaces, implicit, *patch);
    std::optional<Solved_part> found = curves(budget);
    if (found && found->solutions.is_complete())
      return found;
    if (found && !curves.has_sides())
      rest = std::move(found);
  }
  return rest;
}

// The curves of two parametric surfaces with poles that lie on the other one, by equations that are regular there, if
// that proves all of them.
inline std::optional<Solved_part> curves_with_poles(const Surface_equations& surfaces,
                                                    const std::vector<Common_pole>& poles,
                                                    Equations_of_surfaces& equations, Operation_budget& budget,
                                                    const Curve_search& search)
{
  std::array<bool, 2> has_common_pole{};
  for (const Common_pole& common : poles)
    has_common_pole[common.pole.surface] = true;
  for (const Pole_system& equation : Pole_systems(surfaces, equations.both())(has_common_pole)) {
    const Curve_solution_set_d common =
        Common_point_filter(surfaces, equation.is_one_point)(curves_within_budget(equation.system, budget, search));
    if (common.is_complete())
      return joined_at_poles(Surface_equations(surfaces, equation.system), common, poles);
  }
  return std::nullopt;
}

// The curves that satisfy the equations of two surfaces; other equations, if these are singular along curves, or at
// poles.
inline Solved_part curves_in_all_parameters(Surface_equations surfaces, Equations_of_surfaces& equations,
                                            Operation_budget& budget)
{
  if (!surfaces.has_system())
    return {std::move(surfaces), Curve_solution_set_d({}, {}, {}, {}, {}, Summary())};
  Curve_search search{.closed_unknowns = surfaces.closed_unknowns()};
  for (const Surface_pole& pole : surfaces.poles())
    search.points.emplace_back(pole.unknown, pole.value);
  std::vector<Common_pole> poles;
  if (!surfaces.has_coordinates())
    poles = Common_poles(surfaces, [&](std::size_t surface) { return equations(surface); }, budget)();
  if (!poles.empty() && surfaces.has_all_parameters())
    if (std::optional<Solved_part> result = curves_with_poles(surfaces, poles, equations, budget, search))
      return std::move(*result);
  std::vector<Contact_curves> contacts;
  bool has_looked = false;
  const auto has_contact_curves = [&] {
    if (std::exchange(has_looked, true) || !surfaces.has_all_parameters() || budget.must_stop())
      return !contacts.empty();
    const auto& polynomials = equations.both();
    for (const std::size_t implicit : {0, 1})
      if (const std::optional<Contact_curves> found = Contact_curves::make(surfaces, polynomials, implicit))
        contacts.push_back(*found);
    const auto common_zeros =
        polynomials[0] && polynomials[1] ? Regular_pair::make({*polynomials[0], *polynomials[1]}) : std::nullopt;
    for (const std::size_t implicit : {0, 1})
      for (const Contact_curves& found : Contact_curves::along_lines(surfaces, polynomials, implicit, common_zeros))
        contacts.push_back(found);
    return !contacts.empty();
  };
  search.gives_up = has_contact_curves;
  Curve_solution_set_d solutions = curves_within_budget(surfaces.system(), budget, search);
  search.gives_up = [] { return false; };
  std::optional<Constraint_system_d> other;
  for (auto contact = contacts.begin(); contact != contacts.end() && (!other || !solutions.is_complete()); ++contact) {
    if (budget.must_stop())
      break;
    Constraint_system_d system = contact->system();
    Curve_solution_set_d common = contact->common_points(curves_within_budget(system, budget, search));
    if (!other || common.is_complete()) {
      other = std::move(system);
      solutions = std::move(common);
    }
  }
  if (other)
    surfaces = Surface_equations(surfaces, std::move(*other));
  return joined_at_poles(std::move(surfaces), solutions, poles);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solved_part curves_in_all_parameters(const Surface_equations& surfaces,
                                                                    Operation_budget& budget)
{
  Equations_of_surfaces equations(surfaces, budget);
  return curves_in_all_parameters(surfaces, equations, budget);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solved_part common_curves(const Surface_equations& surfaces, Operation_budget& budget)
{
  Equations_of_surfaces equations(surfaces, budget);
  if (surfaces.has_system() &&
      (surfaces.has_all_parameters()
           ? Overlapping_patches(surfaces)([&](std::size_t surface) { return equations(surface); })
           : are_overlapping_height_fields(surfaces)))
    return overlapping_part(surfaces);
  std::optional<Solved_part> curves = curves_on_implicit_patches(surfaces, equations, budget);
  return curves ? std::move(*curves) : curves_in_all_parameters(surfaces, equations, budget);
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_CURVES_H
