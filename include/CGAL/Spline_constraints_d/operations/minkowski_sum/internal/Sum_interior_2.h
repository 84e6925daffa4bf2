// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_INTERIOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_INTERIOR_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Crossing_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Tangential_crossing_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Traced_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
Which points are inside of the Minkowski sum of two regions A and B: p is if the interiors of A and p - B meet, where
their boundaries cross, or one boundary is inside of the other region.
*/
class Sum_interior_2
{
public:
  enum class Effort { USUAL, THOROUGH };

private:
  std::array<const Region_elements_2*, 2> m_regions;
  std::array<std::vector<Traced_curve_2>, 2> m_arcs;

public:
  Sum_interior_2(const Region_elements_2& first, const Region_elements_2& second) : m_regions{&first, &second}
  {
    for (std::size_t k = 0; k < 2; ++k)
      for (const Site_arc_2<>& arc : m_regions[k]->arcs())
        m_arcs[k].emplace_back(
            [&arc](const Range& range) {
              const Tangent_jet<> jet = tangent_jet(arc, range, false);
              return Traced_jet{jet.point, jet.tangent, jet.speed, Interval(0)};   // curvatures are not needed
            },
            Range{0, 1}, Range{0, 1});
  }

  // Whether all points within these bounds are inside; not certain where boundaries touch or may touch for one of them.
  // More is decided with points of boundaries farther away, which takes much longer.
  // \throws Run_stopped
  CGAL::Uncertain<bool> contains(const Interval_pair& p, Run_of_steps& control, Effort effort = Effort::USUAL) const
  {
    control.check();
    bool is_decided = true;
    for (std::size_t i = 0; i < m_arcs[0].size(); ++i)
      for (std::size_t j = 0; j < m_arcs[1].size(); ++j) {
        const Traced_curve_2 &a = m_arcs[0][i], &b = m_arcs[1][j];
        const Traced_view_2 first(a), second(b, p);
        if (!may_meet(first.box(a.whole()), second.box(b.whole())))
          continue;
        for (const Crossing_2& crossing : Crossing_finder_2<>(first, second, {}, true)(control))
          if (crossing.is_certain || Tangential_crossing_2(first, second).is_near(crossing.ranges) ||
              (effort == Effort::THOROUGH && has_point_inside(p, {i, j}, crossing.ranges, control)))
            return true;
          else
            is_decided = false;
      }
    if (!is_decided)
      return CGAL::Uncertain<bool>::indeterminate();
    const Exact_pair point{to_rational(p[0].inf()), to_rational(p[1].inf())};
    return has_boundary_inside(0, point, control) || has_boundary_inside(1, point, control);
  }

private:
  // Whether the begin of a boundary of one region is inside of the other region, reflected; the boundaries do not meet.
  bool has_boundary_inside(std::size_t k, const Exact_pair& point, Run_of_steps& control) const
  {
    const std::vector<Boundary_loop_2>& loops = m_regions[k]->loops();
    return std::any_of(loops.begin(), loops.end(), [&](const Boundary_loop_2& loop) {
      control.check();
      const Exact_pair q = loop.source();
      return is_inside(1 - k, {Exact_rational(point[0] - q[0]), Exact_rational(point[1] - q[1])});
    });
  }

  // Whether a point that is not on the boundary is inside of a region.
  bool is_inside(std::size_t k, const Exact_pair& point) const
  {
    const std::vector<Boundary_loop_2>& loops = m_regions[k]->loops();
    return std::accumulate(loops.begin(), loops.end(), 0, [&](int turns, const Boundary_loop_2& loop) {
             return turns + loop.winding_number(point);
           }) > 0;
  }

  /*
  Whether a point of one boundary, near a contact, is inside of the other region, reflected, wherever p is within its
  bounds. Regions that overlap next to the contact by less than these bounds, or on the other side of a joint, overlap
  by more farther away: so they do around most cusps of the convolution.
  */
  bool has_point_inside(const Interval_pair& p, const std::array<std::size_t, 2>& arcs,
                        const std::array<Range, 2>& ranges, Run_of_steps& control) const
  {
    constexpr double least_step = 0x1p-10;
    for (double step = 0.25; step >= least_step; step /= 4)
      for (const std::size_t k : {0, 1})
        for (const double way : {-step, step}) {
          control.check();
          const auto [arc, t] = place(k, arcs[k], ranges[k].middle() + way);
          const Interval_pair point = p - m_arcs[k][arc]({t, t}).point;
          const auto is_apart = [&](const Traced_curve_2& curve) {
            return Crossing_finder_2<>::is_apart(curve, curve.whole(), point);
          };
          if (std::all_of(m_arcs[1 - k].begin(), m_arcs[1 - k].end(), is_apart) &&
              is_inside(1 - k, {to_rational(point[0].inf()), to_rational(point[1].inf())}))
            return true;
        }
    return false;
  }

  // A parameter between -1 and 2 of an arc, on this or the arc before or behind.
  std::pair<std::size_t, double> place(std::size_t k, std::size_t arc, double t) const
  {
    if (t < 0)
      return {m_regions[k]->previous_arc(arc), t + 1};
    return t > 1 ? std::pair(m_regions[k]->next_arc(arc), t - 1) : std::pair(arc, t);
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_INTERIOR_2_H
