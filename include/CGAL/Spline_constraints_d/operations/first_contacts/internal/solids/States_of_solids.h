// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_STATES_OF_SOLIDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_STATES_OF_SOLIDS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_state.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Separation.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_contact_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/identities.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_membership.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
How a moving solid lies to one that does not move. They overlap if a point of one boundary is inside of the other solid.
They are apart if it is proved that the boundaries do not meet, and one point of each connected part is outside of the
other solid. Solids that touch are neither.
*/
class States_of_solids
{
  using Solid_boundary = Swept_volumes::Solid_boundary;
  using Point_3 = Rational_motion_3::Kernel::Point_3;

  const Moving_solids& m_solids;
  const Solid_contact_search& m_search;
  Budgeted_solver& m_solve;
  std::array<Swept_volumes::Solid_membership, 2> m_membership;
  std::array<Vector_bounds<3>, 2> m_bounds; // of the solids, each in its own space

public:
  static constexpr const char* not_decided = "how the solids lie to each other at this time";

  States_of_solids(const Moving_solids& solids, const Solid_contact_search& search, Budgeted_solver& solve)
    : m_solids(solids), m_search(search),
      m_solve(solve), m_membership{Swept_volumes::Solid_membership(solids.moving, solve.budget()),
                                   Swept_volumes::Solid_membership(solids.fixed, solve.budget())},
      m_bounds{bounds_of(solids.moving), bounds_of(solids.fixed)}
  {}

  // Next to a contact, solids overlap at its places if they do so at all.
  Contact_state at(const Exact_rational& time, const std::vector<Solid_candidate>& candidates)
  {
    constexpr std::size_t few = 1000, many = 20000;
    if (are_boundaries_separate(time, few))
      return state_of_separate_boundaries(time);
    if (is_any_inside(places_near(time, candidates), time))
      return Contact_state::OVERLAPPING;
    if (are_boundaries_separate(time, many))
      return state_of_separate_boundaries(time);
    return is_any_inside(some_places(), time) ? Contact_state::OVERLAPPING : Contact_state::UNDECIDED;
  }

  // Whether a point of the moving boundary is inside at a time before, and its path does not leave until the end.
  bool overlap_lasts(const Parameter_range& time, const Exact_rational& before)
  {
    const Exact_rational begin = time_close_before(time, before);
    constexpr int halvings = 12;
    for (const Contact_place& place : some_places()) {
      if (place.solid != 0 || m_solve.has_ended() || !is_inside(place, begin))
        continue;
      const Vector_bounds<3> path = bounds_of_path(place.point, {begin, time.second});
      if (std::ranges::all_of(m_solids.fixed.patches(),
                              [&](const auto& patch) { return misses(path, patch, halvings); }))
        return true;
    }
    return false;
  }

private:
  // A point of a solid, in its own space.
  struct Contact_place
  {
    std::size_t solid;
    Exact_vector point;
  };

  static Vector_bounds<3> bounds_of(const Solid_boundary& solid)
  {
    Vector_bounds<3> result = solid[0].values();
    for (const auto& patch : solid.patches()) {
      const Vector_bounds<3> own = patch.values();
      for (std::size_t i = 0; i < 3; ++i)
        result[i] = hull(result[i], own[i]);
    }
    return result;
  }

  Exact_vector middle_of_place(const Solid_candidate& candidate, std::size_t solid) const
  {
    std::vector<Exact_rational> parameters;
    for (const Parameter_range& range : candidate.parameters[solid])
      parameters.push_back(middle_of(range));
    return m_search.element(solid, candidate.elements[solid]).map(parameters);
  }

  // On both solids, of the candidates that are next in time.
  std::vector<Contact_place> places_near(const Exact_rational& time,
                                         const std::vector<Solid_candidate>& candidates) const
  {
    constexpr std::size_t few = 8;
    std::vector<const Solid_candidate*> near;
    for (const Solid_candidate& candidate : candidates)
      near.push_back(&candidate);
    const auto distance = [&](const Solid_candidate* c) {
      const Exact_rational difference(middle_of(c->time) - time);
      return difference < 0 ? Exact_rational(-difference) : difference;
    };
    std::ranges::stable_sort(near, {}, distance);
    near.resize((std::min)(near.size(), few));
    std::vector<Contact_place> result;
    for (const Solid_candidate* candidate : near)
      for (const std::size_t k : {0, 1})
        result.push_back({k, middle_of_place(*candidate, k)});
    return result;
  }

  // The middle and a corner of some patches.
  std::vector<Contact_place> some_places() const
  {
    constexpr std::size_t many = 24;
    std::vector<Contact_place> result;
    for (const std::size_t k : {0, 1}) {
      const Solid_boundary& solid = m_solids.solid(k);
      for (std::size_t patch = 0; patch < solid.size(); patch += 1 + solid.size() / many) {
        result.push_back({k, solid[patch](solid[patch].first_corner())});
        result.push_back({k, solid[patch](solid[patch].middle())});
      }
    }
    return result;
  }

  bool is_any_inside(const std::vector<Contact_place>& places, const Exact_rational& time)
  {
    return std::ranges::any_of(places, [&](const Contact_place& place) {
      return !m_solve.has_ended() && is_inside(place, time).value_or(false);
    });
  }

  // Of the other solid; nothing, where that was not decided.
  std::optional<bool> is_inside(const Contact_place& place, const Exact_rational& time)
  {
    const std::size_t other = 1 - place.solid;
    const Point_3 point(place.point[0], place.point[1], place.point[2]),
        seen =
            place.solid == 0 ? m_solids.motion(time).transform(point) : m_solids.motion.inverse(time).transform(point);
    for (int i = 0; i < 3; ++i) {
      const Rational_interval& range = m_bounds[other][static_cast<std::size_t>(i)];
      if (seen[i] < range.lower || range.upper < seen[i])
        return false;
    }
    return m_membership[other].is_inside(seen);
  }

  Contact_state state_of_separate_boundaries(const Exact_rational& time)
  {
    for (const std::size_t k : {0, 1}) {
      const Solid_boundary& solid = m_solids.solid(k);
      for (std::size_t patch = 0; patch < solid.size(); ++patch) {
        if (solid.component(patch) != patch)
          continue;
        const auto is_in_other = is_inside({k, solid[patch](solid[patch].middle())}, time);
        if (!is_in_other)
          return Contact_state::UNDECIDED;
        if (*is_in_other)
          return Contact_state::OVERLAPPING;
      }
    }
    return Contact_state::APART;
  }

  // See are_separate().
  bool are_boundaries_separate(const Exact_rational& time, std::size_t most) const
  {
    std::vector<Spline_patch<3>> moved;
    for (const Spline_patch<3>& patch : m_solids.moving.patches())
      moved.push_back(moved_patch(patch, time));
    return are_separate(moved, m_solids.fixed.patches(), most);
  }

  // Across the axis on which points change most.
  static std::array<Spline_patch<3>, 2> halves_across(const Spline_patch<3>& patch)
  {
    const auto change = [&](int axis) {
      const Parameter_range range = patch.domain(axis);
      Exact_rational result(0);
      for (const Rational_interval& slope : patch.tangents(axis))
        result += (std::max)(Exact_rational(-slope.lower), slope.upper);
      return Exact_rational(result * (range.second - range.first));
    };
    return patch.halves(change(0) < change(1) ? 1 : 0);
  }

  Spline_patch<3> moved_patch(const Spline_patch<3>& patch, const Exact_rational& time) const
  {
    const auto map = m_solids.motion(time);
    Vector_of_functions<3> result;
    for (int i = 0; i < 3; ++i) {
      const auto& [x, y, z] = patch.numerators();
      const Exact_function sum = x * map.m(i, 0) + y * map.m(i, 1) + z * map.m(i, 2);
      result[static_cast<std::size_t>(i)] =
          patch.is_rational() ? sum + patch.weight() * map.m(i, 3) : sum + map.m(i, 3);
    }
    return patch.with_numerators(std::move(result));
  }

  Vector_bounds<3> bounds_of_path(const Exact_vector& point, const Parameter_range& time) const
  {
    const Moving_space space(m_solids.motion, time);
    const Vector_of_functions<3> path = space.image_of_point(point);
    return Spline_patch<3>(path, space.weight(), true).values();
  }

  // Whether a box has no point of a patch, or is not told apart from it by so many halvings.
  static bool misses(const Vector_bounds<3>& box, const Spline_patch<3>& patch, int halvings)
  {
    if (are_apart(box, patch.values()))
      return true;
    return halvings > 0 &&
        std::ranges::all_of(halves_across(patch), [&](const auto& half) { return misses(box, half, halvings - 1); });
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_STATES_OF_SOLIDS_H
