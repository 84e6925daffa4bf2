// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_SURFACES_AFTER_ELIMINATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_SURFACES_AFTER_ELIMINATION_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Box_lifting.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/curves_after_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/united_surfaces.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The sign of the determinant of the derivatives of polynomials by all unknowns but two, at a point where equalities of
degree one give eliminated unknowns. There it is, up to a sign that depends on the two alone, that of the system without
these unknowns: their columns and the equalities that give them can be split off. So it is the same for all such points
over a box in which that one has no zero.
*/
class Sign_of_minor
{
  std::size_t m_dimension;
  std::vector<std::vector<Power_polynomial>> m_derivatives; // of each equality

public:
  explicit Sign_of_minor(const Constraint_system_d& system) : m_dimension(static_cast<std::size_t>(system.dimension()))
  {
    for (const Spline_function& equality : system.equalities()) {
      const std::optional<Power_polynomial> polynomial = restricted(equality, Partial_point(m_dimension));
      if (!polynomial)
        return;
      m_derivatives.emplace_back();
      for (int j = 0; j < system.dimension(); ++j)
        m_derivatives.back().push_back(polynomial->derivative(j));
    }
  }

  // No equality has breaks.
  bool is_defined() const { return m_derivatives.size() + 2 == m_dimension; }

  int operator()(const std::vector<Exact_rational>& point, const std::array<int, 2>& parameters) const
  {
    std::vector<Exact_rational> matrix;
    for (const std::vector<Power_polynomial>& row : m_derivatives)
      for (std::size_t j = 0; j < m_dimension; ++j)
        if (std::find(parameters.begin(), parameters.end(), static_cast<int>(j)) == parameters.end())
          matrix.push_back(row[j](point));
    return sign_of_determinant(std::move(matrix), m_derivatives.size());
  }
};

// The same surfaces in the unknowns of the whole system, which has no inequalities.
inline Surface_solution_set_d lifted(const Surface_solution_set_d& found, const Constraint_system_d& system,
                                     const Sign_of_minor& sign, Box_lifting& lifting)
{
  std::vector<Curve_vertex> vertices = found.vertices();
  for (Curve_vertex& vertex : vertices)
    vertex.box = lifting.vertex(vertex.box);
  std::vector<Surface_arc> arcs = found.arcs();
  for (Surface_arc& arc : arcs) {
    arc.box = lifting(arc.box);
    arc.plane = lifting.unknown(arc.plane);
    arc.parameter = lifting.unknown(arc.parameter);
  }
  std::vector<Surface_patch> patches = found.patches();
  for (Surface_patch& patch : patches) {
    const std::vector<Exact_rational> middle = lifting.point(middle_of(patch.box));
    patch.box = lifting(patch.box);
    if (patch.apex)
      continue;
    for (int& parameter : patch.parameters)
      parameter = lifting.unknown(parameter);
    patch.orientation = sign(middle, patch.parameters);
  }
  std::vector<Undecided_surface_region> undecided = found.undecided_regions();
  for (Undecided_surface_region& region : undecided)
    for (Exact_box& box : region.boxes)
      box = lifting(box);
  Surface_solution_set_d result{std::make_shared<const Constraint_system_d>(system),
                                system.dimension(),
                                std::move(vertices),
                                std::move(arcs),
                                std::move(patches),
                                found.surfaces(),
                                found.points(),
                                found.singular_points(),
                                std::move(undecided),
                                found.summary()};
  for (const Curve_solution_set_d& curves : found.lone_curves())
    result.add_lone_curves(lifted(curves, lifting));
  return result;
}

/*
All surfaces of solutions, as curves_after_elimination() finds curves, of systems of equalities without breaks.
`splits`: into systems with one factor of an equality each.
*/
template <class Traits, class Concurrency_tag>
Surface_solution_set_d surfaces_after_elimination(const Constraint_system_d& system, const Solver_options& options,
                                                  Run_control& control, bool splits)
{
  check_codimension(system, 2, "solve_surfaces");
  if (splits)
    if (const std::vector<Factor_system> parts = factor_systems(system); is_split(system, parts))
      return united_surfaces<Traits, Concurrency_tag>(system, parts, options, control);
  Summary work;
  const auto is_empty = [&](const Constraint_system_d& on_bound) {
    const Curve_solution_set_d found = all_curves<Traits, Concurrency_tag>(
        on_bound, options_for_bound(options, work, control), control, {.are_faces_undecided = true});
    work.nodes += found.summary().nodes;
    return found.is_complete() && found.vertices().empty();
  };
  const auto with_work = [&](Surface_solution_set_d found) {
    found.set_work(found.summary().nodes + work.nodes, found.summary().seconds);
    return found;
  };
  System_decomposition decomposition;
  if (system.inequalities().empty())
    decomposition = elimination_within_bounds(system, 2, control, is_empty);
  if (const Sign_of_minor sign(system); !decomposition.eliminated.empty() && sign.is_defined()) {
    const Surface_solution_set_d found =
        all_surfaces<Traits, Concurrency_tag>(decomposition.parts.front().system, rest_of(options, work), control);
    Box_lifting lifting(system, decomposition);
    const Surface_solution_set_d result = lifted(found, system, sign, lifting);
    if (lifting.are_in_domain() && (result.is_complete() || has_limits_reached(result.undecided_regions())))
      return with_work(result);
    work.nodes += found.summary().nodes;
  }
  return with_work(all_surfaces<Traits, Concurrency_tag>(system, rest_of(options, work), control));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_SURFACES_AFTER_ELIMINATION_H
