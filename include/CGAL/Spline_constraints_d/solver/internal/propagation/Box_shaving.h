// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_BOX_SHAVING_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_BOX_SHAVING_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Constraint_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Narrows a box by slices of the range of one unknown: slices at both ends go as long as propagation leaves nothing of
them (3B consistency of Lhomme), and the box becomes the hull of what it leaves of the first and the last slice that
stay and of all that is between them (constructive disjunction of Trombettoni and Chabert).
*/
class Box_shaving
{
  Constraint_propagation& m_propagation;
  const std::function<void()>& m_check;
  Box_of_ranges m_slice, m_hull;
  bool m_has_hull = false;
  std::size_t m_slices = 0;

public:
  // `check()` may end the work by an exception.
  Box_shaving(Constraint_propagation& propagation, const std::function<void()>& check)
    : m_propagation(propagation), m_check(check)
  {}

  // False when nothing is left. No constraint is awake before and after it.
  bool operator()(int unknown, Box_of_ranges& box);

  // How many were looked at in all.
  std::size_t slices() const { return m_slices; }

private:
  // Adds what is left of a slice to the hull; false when nothing is.
  bool add(const Box_of_ranges& box, int unknown, double lower, double upper);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool Box_shaving::operator()(int unknown, Box_of_ranges& box)
{
  constexpr int most_slices = 10;
  constexpr double much = 0.9; // of a width: what is left then wakes constraints
  m_check();
  if (box[unknown].inf() == box[unknown].sup())
    return true;
  m_has_hull = false;
  double lower = box[unknown].inf(), upper = box[unknown].sup();
  const double step = width(box[unknown]) / most_slices;
  bool is_lower_open = true, is_upper_open = true;
  for (int left = most_slices; is_lower_open && lower < upper; --left) {
    const double end = left > 1 ? (std::min)(lower + step, upper) : upper;
    is_lower_open = !add(box, unknown, lower, end);
    lower = end;
  }
  for (int left = most_slices; is_upper_open && lower < upper; --left) {
    const double end = left > 1 ? (std::max)(upper - step, lower) : lower;
    is_upper_open = !add(box, unknown, end, upper);
    upper = end;
  }
  if (lower < upper)
    add(box, unknown, lower, upper);
  if (!m_has_hull)
    return false;
  for (std::size_t j = 0; j < box.size(); ++j) {
    if (width(m_hull[j]) < much * width(box[j]))
      m_propagation.wake_constraints_of(static_cast<int>(j));
    box[j] = m_hull[j];
  }
  return m_propagation.narrow(box);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Box_shaving::add(const Box_of_ranges& box, int unknown, double lower, double upper)
{
  ++m_slices;
  m_slice = box;
  m_slice[unknown] = Interval(lower, upper);
  m_propagation.wake_constraints_of(unknown);
  if (!m_propagation.narrow(m_slice))
    return false;
  if (m_has_hull)
    extend(m_hull, m_slice);
  else
    m_hull = m_slice;
  m_has_hull = true;
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_BOX_SHAVING_H
