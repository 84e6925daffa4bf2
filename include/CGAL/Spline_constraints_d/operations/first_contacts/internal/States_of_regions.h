// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_STATES_OF_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_STATES_OF_REGIONS_H

#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_equations.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/State_of_regions.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// A box around the images of a point in a part of the time; it is as large as its control points say.
inline Vector_bounds<2> box_of_path(const Rational_motion_2& motion, const Exact_pair& point,
                                    const Parameter_range& time)
{
  const auto& columns = motion.columns();
  const Rational_interval weight(part_of(motion.weight(), 0, time).bounds());
  Vector_bounds<2> result;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto f = columns[0][i] * point[0] + columns[1][i] * point[1] + columns[2][i];
    result[i] = Rational_interval(part_of(f, 0, time).bounds()) / weight;
  }
  return result;
}

// Whether a box has no point of a piece, or is not told apart from it by so many halvings.
inline bool misses(const Vector_bounds<2>& box, const std::array<Exact_tensor, 3>& coordinates, int halvings)
{
  const auto& [x, y, w] = coordinates;
  const auto is_beyond = [&, &w = w](const Exact_tensor& f, const Rational_interval& range) {
    return (f - w * range.lower).bounds().second < 0 || (f - w * range.upper).bounds().first > 0;
  };
  if (is_beyond(x, box[0]) || is_beyond(y, box[1]))
    return true;
  if (halvings == 0)
    return false;
  const auto [x0, x1] = x.split(0);
  const auto [y0, y1] = y.split(0);
  const auto [w0, w1] = w.split(0);
  return misses(box, {x0, y0, w0}, halvings - 1) && misses(box, {x1, y1, w1}, halvings - 1);
}

// Whether a point that is inside of a region at one time is so in all of a part of the time, which contains that one.
inline bool stays_inside(const std::vector<Boundary_loop_2>& region, const Rational_motion_2& motion,
                         const Exact_pair& point, const Parameter_range& time)
{
  constexpr int halvings = 40;
  if (!(part_of(motion.weight(), 0, time).bounds().first > 0))
    return false;
  const Vector_bounds<2> box = box_of_path(motion, point, time);
  return std::ranges::all_of(region, [&](const Boundary_loop_2& loop) {
    return std::ranges::all_of(loop.pieces(),
                               [&](const Boundary_piece& piece) { return misses(box, piece.coordinates, halvings); });
  });
}

// How a moving region lies to one that does not move.
class States_of_regions
{
  const Moving_regions& m_regions;
  Budgeted_solver& m_solve;

public:
  static constexpr const char* not_decided = "how the regions lie to each other at this time";

  States_of_regions(const Moving_regions& regions, Budgeted_solver& solve) : m_regions(regions), m_solve(solve) {}

  Contact_state at(const Exact_rational& time, const std::vector<Contact_candidate>& = {})
  {
    return State_of_regions(moved(m_regions.moving, m_regions.motion, time), m_regions.fixed, m_solve)();
  }

  // Whether a point of the boundary of one region is inside of the other one at a time before and until the end.
  bool overlap_lasts(const Parameter_range& time, const Exact_rational& before)
  {
    const Exact_rational begin = time_close_before(time, before);
    const auto moving = moved(m_regions.moving, m_regions.motion, begin);
    State_of_regions state(moving, m_regions.fixed, m_solve);
    const auto back = m_regions.motion(begin).inverse();
    for (const Exact_pair& p : state.inner_points(0)) {
      const auto own = back.transform(Rational_motion_2::Kernel::Point_2(p[0], p[1]));
      if (stays_inside(m_regions.fixed, m_regions.motion, {own.x(), own.y()}, {begin, time.second}))
        return true;
    }
    const Rational_motion_2 inverse = m_regions.motion.inverse();
    for (const Exact_pair& p : state.inner_points(1))
      if (stays_inside(m_regions.moving, inverse, p, {begin, time.second}))
        return true;
    return false;
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_STATES_OF_REGIONS_H
