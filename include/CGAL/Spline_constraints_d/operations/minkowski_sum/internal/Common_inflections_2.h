// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_COMMON_INFLECTIONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_COMMON_INFLECTIONS_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// An inflection of two arcs that are translated copies of each other.
struct Common_inflection
{
  std::array<std::size_t, 2> elements;   // of both regions, that hold it
  Range range;                           // of these
  Range near;                            // a larger one, where all sums with common directions are known
  bool is_fold_convex;                   // see below
};

/*
The inflections that two regions have in common, as where a region is added to itself. Sums C(u) + C(v) with common
directions are those with u = v, and a fold: let m and s be half of the sum and of the difference of v and u, A and D
the means

  A = (C'(u) + C'(v)) / 2,   D = (C'(v) - C'(u)) / 2s,   C'(u) x C'(v) = 2 s A x D.

All are smooth functions of m and q = s^2, and Q = A x D = 0 is the graph of a function m(q) where Q_m = A_m x D + A x
D_m is not zero. Along it the sum moves with the derivative 2 m_q A + D, where m_q = -Q_q / Q_m, A_q is half of a third
derivative, and D_q is a sixth of a fourth one. Both branches, v > u and v < u, are the same points: a curve that begins
in the sum of the inflections. It belongs to the convolution, as the sum of the curvatures is positive, if the arc that
turns to the right runs in its direction.
*/
class Common_inflections_2
{
  std::vector<Common_inflection> m_inflections;

public:
  // \throws Run_stopped
  Common_inflections_2(const Region_elements_2& first, const Region_elements_2& second, Run_of_steps& control)
  {
    for (std::size_t i = 0; i < first.elements().size(); ++i) {
      if (!is_inflection(first, i))
        continue;
      control.check();
      for (std::size_t j = 0; j < second.elements().size(); ++j)
        if (is_inflection(second, j) && are_same(first, i, second, j))
          add(first, {i, j});
    }
  }

  const Common_inflection& operator[](std::size_t index) const { return m_inflections[index]; }

  // Those that two elements hold or reach: none, one, or one at each end.
  std::vector<std::size_t> next_to(const std::array<std::size_t, 2>& elements) const
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < m_inflections.size(); ++i) {
      const auto reaches = [&](std::size_t k) {
        return elements[k] + 1 >= m_inflections[i].elements[k] && elements[k] <= m_inflections[i].elements[k] + 1;
      };
      if (reaches(0) && reaches(1))
        result.push_back(i);
    }
    return result;
  }

private:
  // Whether the turn changes, within one arc.
  static bool is_inflection(const Region_elements_2& region, std::size_t i)
  {
    const std::vector<Region_element>& all = region.elements();
    if (all[i].turn != Turn::UNKNOWN || i == 0 || i + 1 == all.size())
      return false;
    const Region_element &before = all[i - 1], &behind = all[i + 1];
    const auto turns = [](const Region_element& e, Turn turn) { return !e.is_corner && e.turn == turn; };
    return before.arc == all[i].arc && behind.arc == all[i].arc &&
        ((turns(before, Turn::LEFT) && turns(behind, Turn::RIGHT)) ||
         (turns(before, Turn::RIGHT) && turns(behind, Turn::LEFT)));
  }

  static bool are_same(const Region_elements_2& first, std::size_t i, const Region_elements_2& second, std::size_t j)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      const Range &a = first.elements()[i + k - 1].range, &b = second.elements()[j + k - 1].range;
      if (a.begin != b.begin || a.end != b.end)
        return false;
    }
    return translation(first.arcs()[first.elements()[i].arc], second.arcs()[second.elements()[j].arc], false)
        .has_value();
  }

  void add(const Region_elements_2& region, const std::array<std::size_t, 2>& elements)
  {
    constexpr double least_width = 0x1p-20;
    const std::size_t i = elements[0];
    const Region_element &before = region.elements()[i - 1], &behind = region.elements()[i + 1];
    const Range range = region.elements()[i].range;
    const Site_arc_2<>& arc = region.arcs()[before.arc];
    for (double width = 0.25; width > least_width; width /= 2) {
      const Range near{(std::max)(range.begin - width, before.range.begin),
                       (std::min)(range.end + width, behind.range.end)};
      if (const int sign = direction_of_fold(arc, near);
          sign != 0 && has_other_directions(arc, range, near.begin) && has_other_directions(arc, range, near.end)) {
        m_inflections.push_back({elements, range, near, (sign > 0) == (before.turn == Turn::LEFT)});
        return;
      }
    }
  }

  // Whether no direction in a range is that of a point.
  static bool has_other_directions(const Site_arc_2<>& arc, const Range& range, double t)
  {
    return certain_sign(cross(arc.jet(range, 1)[1], arc.jet({t, t}, 1)[1])) != 0;
  }

  // Whether the fold runs with the arc (1) or against it (-1), if both parameters are in a range; 0 if that is not
  // certain.
  static int direction_of_fold(const Site_arc_2<>& arc, const Range& range)
  {
    const Curve_jet<> c = arc.jet(range, 4);
    const Interval two(2), six(6);
    const Interval_pair &a = c[1], &d = c[2];
    const Interval qm = cross(d, d) + cross(a, c[3]), qq = cross(c[3], d) / two + cross(a, c[4]) / six;
    if (!(dot(a, a).inf() > 0) || certain_sign(qm) == 0)
      return 0;
    return certain_sign(dot(d - (two * qq / qm) * a, a));
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_COMMON_INFLECTIONS_2_H
