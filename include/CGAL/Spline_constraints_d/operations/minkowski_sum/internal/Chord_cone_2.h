// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CHORD_CONE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CHORD_CONE_2_H

#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
The directions of the chords from an end of a curve that turns to one side, by at most 45 degrees, or not at all: those
between its first and its last direction, without both; or the only one. Two curves with a common end, whose cones have
no direction in common, have no other common point. This is decided exactly, so that the curves may be tangential in the
end and their curvatures may be the same there, as those of a segment and a cubic whose first three control points are
on a line.
*/
class Chord_cone_2
{
  std::array<Exact_pair, 2> m_directions;   // the right and the left one

public:
  // Of a curve with these directions, from its begin (0) or end (1).
  Chord_cone_2(const Exact_pair& first, const Exact_pair& last, int end) : m_directions{first, last}
  {
    if (end == 1)
      for (Exact_pair& d : m_directions)
        d = {Exact_rational(-d[0]), Exact_rational(-d[1])};
    if (sign_of(exact_cross(m_directions[0], m_directions[1])) < 0)
      std::swap(m_directions[0], m_directions[1]);
  }

  static bool are_disjoint(const Chord_cone_2& a, const Chord_cone_2& b)
  {
    for (const Exact_pair& d : a.m_directions)
      for (const Exact_pair& e : b.m_directions)
        if (sign_of(exact_dot(d, e)) < 0)
          return true;
    const int after = sign_of(exact_cross(a.m_directions[1], b.m_directions[0])),
              before = sign_of(exact_cross(b.m_directions[1], a.m_directions[0]));
    return (after >= 0 || before >= 0) && !(a.is_single() && b.is_single() && after == 0);
  }

private:
  bool is_single() const { return sign_of(exact_cross(m_directions[0], m_directions[1])) == 0; }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CHORD_CONE_2_H
