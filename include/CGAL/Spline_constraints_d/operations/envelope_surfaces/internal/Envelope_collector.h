// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_COLLECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_COLLECTOR_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/inequalities_as_unknowns.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// Adds the inequality that a formula is not negative, with values up to one, as those of the other unknowns.
template <class Check>
void add_not_negative(const Expression& formula, Constraint_system_d& system, const Check& check)
{
  Spline_function function = (formula >= 0).spline_function(check);
  if (const Exact_rational most = bounds_in_domain(function, system).second; most > 0)
    function *= Exact_rational(1 / most);
  system.add(std::move(function), Relation::GREATER_EQUAL);
}

// Gathers what an operation finds, system by system.
class Envelope_collector
{
  Operation_budget m_budget;
  std::vector<Envelope_part_3> m_parts;
  std::vector<Undecided_part> m_undecided;

public:
  explicit Envelope_collector(const Solver_options& options) : m_budget(options) {}

  Operation_budget& budget() { return m_budget; }

  void add_undecided(const Curve_vertex::Exact_box& box, const std::string& reason)
  {
    m_undecided.push_back({double_ranges(box), {}, reason});
  }

  // The surfaces of a system, perhaps only some of them, and the curves on them where a function is zero, which is made
  // only where there are surfaces. If there are such curves, surfaces are cut along them; if that leaves something
  // undecided, they are not.
  void add(const Constraint_system_d& system, const std::function<Spline_function()>& feature,
           const Vector_expression<3>& image, std::vector<int> closed_unknowns, std::vector<Envelope_pole> poles,
           const std::function<Surface_solution_set_d(const Surface_solution_set_d&)>& part_of_interest = {},
           const std::optional<std::pair<int, Exact_rational>>& constant_unknown = std::nullopt,
           std::vector<Vector_expression<3>> feet = {}, int product_of_sides = 0)
  {
    if (m_budget.must_stop()) {
      add_undecided(domain_of(system), in_words(m_budget.reason()));
      return;
    }
    const Solver_options options = m_budget.remaining();
    Run_control control(options);
    Surface_solution_set_d found = surfaces_after_elimination<Certified_solver_traits, CGAL::Sequential_tag>(
        system, options, control, false);
    m_budget.add(found.summary());
    if (part_of_interest)
      found = part_of_interest(found);
    m_parts.push_back({std::move(found), image, std::move(closed_unknowns), std::move(poles)});
    m_parts.back().constant_unknown = constant_unknown;
    m_parts.back().feet = std::move(feet);
    m_parts.back().product_of_sides = product_of_sides;
    if (!feature || m_parts.back().solutions.patches().empty())
      return;
    if (const Spline_function cusps = feature(); !is_zero_everywhere(cusps)) {
      Constraint_system_d zeros(system);
      zeros.add(cusps, Relation::EQUAL);
      Envelope_part_3& part = m_parts.back();
      part.cusps = curves_within_budget(zeros, m_budget, {});
      if (part.cusps->vertices().empty() || m_budget.must_stop())
        return;
      Surface_solution_set_d cut = solve_surfaces(system, {cusps}, m_budget.remaining());
      Summary work = cut.summary();
      work.is_complete = true;
      m_budget.add(work);
      if (cut.is_complete())
        part.solutions = std::move(cut);
    }
  }

  Envelope_surface_3 result() &&
  {
    Summary work = m_budget.total();
    work.seconds = m_budget.seconds();
    work.is_complete = work.is_complete && m_undecided.empty();
    return {std::move(m_parts), std::move(m_undecided), work};
  }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_COLLECTOR_H
