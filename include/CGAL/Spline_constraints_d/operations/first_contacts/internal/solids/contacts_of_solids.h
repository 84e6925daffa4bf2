// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_CONTACTS_OF_SOLIDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_CONTACTS_OF_SOLIDS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_timeline.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_contact_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/States_of_solids.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/solid_contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_membership.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// A solid whose surfaces are cut into polynomial and rational pieces. \throws Invalid_input when it is not closed.
inline Swept_volumes::Solid_boundary solid_of_pieces(const std::vector<Common::Exact_map<3>>& surfaces,
                                                     const std::string& name)
{
  const Swept_volumes::Solid_boundary solid = Swept_volumes::solid_boundary_of(surfaces, name);
  std::vector<Swept_volumes::Solid_boundary::Lines> lines(solid.size());
  for (std::size_t patch = 0; patch < solid.size(); ++patch)
    for (const int axis : {0, 1})
      for (const Exact_rational& value : solid[patch].breaks(axis))
        if (0 < value && value < 1)
          lines[patch][static_cast<std::size_t>(axis)].insert(value);
  return solid.cut_along(std::move(lines));
}

// What both operations begin with: checks of the input, and the search, which a function is called with.
template <class Function>
auto search_contacts_of_solids(const std::vector<Common::Exact_map<3>>& moving, const Rational_motion_3& motion,
                               const std::vector<Common::Exact_map<3>>& fixed, const Solver_options& options,
                               const std::string& name, const Function& function)
{
  Budgeted_solver solve(options);
  Swept_volumes::has_positive_maps(motion, name); // or else it throws
  const auto own = solid_of_pieces(moving, name + ", moving solid"),
             other = solid_of_pieces(fixed, name + ", fixed solid");
  const Moving_solids solids{own, motion, other, options.tolerance};
  Solid_contact_search search(solids, solve);
  return function(States_of_solids(solids, search, solve), search, solve);
}

CGAL_SPLINE_CONSTRAINTS_INLINE First_contact_3 first_contact_of(const std::vector<Common::Exact_map<3>>& moving,
                                                                const Rational_motion_3& motion,
                                                                const std::vector<Common::Exact_map<3>>& fixed,
                                                                const Solver_options& options)
{
  const auto first = [&](States_of_solids states, Solid_contact_search& search,
                         Budgeted_solver& solve) -> First_contact_3 {
    const Parameter_range begin(motion.domain().first, motion.domain().first);
    switch (const Contact_state state = states.at(begin.first, {})) {
    case Contact_state::APART:
      return earliest_contact<Contact_3, Solid_contact_search, Solid_candidate>(search, solve);
    case Contact_state::OVERLAPPING:
      return {state, begin, true, {}, {}, summary_of(solve, true)};
    default:
      return undecided_first_contact<Contact_3>(motion.domain(), solve, States_of_solids::not_decided);
    }
  };
  return search_contacts_of_solids(moving, motion, fixed, options, "first contact", first);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Contact_events_3 contact_events_of(const std::vector<Common::Exact_map<3>>& moving,
                                                                  const Rational_motion_3& motion,
                                                                  const std::vector<Common::Exact_map<3>>& fixed,
                                                                  const Solver_options& options)
{
  const auto events = [](States_of_solids states, Solid_contact_search& search,
                         Budgeted_solver& solve) -> Contact_events_3 {
    const auto found = distinct_contacts(search, all_candidates<Solid_candidate>(search));
    return Contact_timeline<Contact_3, Solid_contact_search, Solid_candidate, States_of_solids>(states, search,
                                                                                                solve)(found);
  };
  return search_contacts_of_solids(moving, motion, fixed, options, "contact events", events);
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_CONTACTS_OF_SOLIDS_H
