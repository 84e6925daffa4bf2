// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_INTERIOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_INTERIOR_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/internal/Crossing_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Tangential_crossing_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Traced_curve_2.h>

#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Which points are inside of the Minkowski sum of two regions A and B: p is if the interiors of A and p - B meet, where their boundaries cross, or one boundary is inside of the other region.
*/
class Sum_interior_2
{
  std::array<const Region_elements_2*, 2> m_regions;
  std::array<std::vector<Traced_curve_2>, 2> m_arcs;

public:
  Sum_interior_2(const Region_elements_2& first, const Region_elements_2& second) : m_regions{&first, &second}
  {
    for (std::size_t k = 0; k < 2; ++k)
      for (const Site_arc_2& arc : m_regions[k]->arcs())
        m_arcs[k].emplace_back(
          [&arc](const Range& range) {
            const Tangent_jet jet = tangent_jet(arc, range, false);
            return Traced_jet{jet.point, jet.tangent, jet.speed, Interval(0)};   // curvatures are not needed
          },
          Range{0, 1}, Range{0, 1});
  }

  // Whether all points within these bounds are inside; not certain where boundaries touch or may touch for one of them.
  CGAL::Uncertain<bool> contains(const Interval_pair& p) const
  {
    bool is_decided = true;
    for (const Traced_curve_2& a : m_arcs[0])
      for (const Traced_curve_2& b : m_arcs[1]) {
        const Traced_view_2 first(a), second(b, p);
        if (!may_meet(first.box(a.whole()), second.box(b.whole())))
          continue;
        for (const Crossing_2& crossing : Crossing_finder_2(first, second, {}, true)())
          if (crossing.is_certain || Tangential_crossing_2(first, second).is_near(crossing.ranges))
            return true;
          else
            is_decided = false;
      }
    if (!is_decided)
      return CGAL::Uncertain<bool>::indeterminate();
    const Exact_pair point{to_rational(p[0].inf()), to_rational(p[1].inf())};
    return has_boundary_inside(0, point) || has_boundary_inside(1, point);
  }

private:
  // Whether the begin of a boundary of one region is inside of the other region, reflected; the boundaries do not meet.
  bool has_boundary_inside(std::size_t k, const Exact_pair& point) const
  {
    for (const Boundary_loop_2& loop : m_regions[k]->loops()) {
      const Exact_pair q = loop.source(), reflected{Exact_rational(point[0] - q[0]), Exact_rational(point[1] - q[1])};
      int turns = 0;
      for (const Boundary_loop_2& other : m_regions[1 - k]->loops())
        turns += other.winding_number(reflected);
      if (turns > 0)
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_INTERIOR_2_H
