// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_SITE_PAIRS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_SITE_PAIRS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Nearest_parts.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Pair_of_sites.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
The pairs of sites of two operands, which together hold the pairs of points that are looked for: all of them, or those
in regions that hold all pairs of nearest points.
*/
template <int d>
class Site_pairs
{
  using Site = Spline_site<d>;
  using Box = std::vector<Parameter_range>;

  struct Region
  {
    std::array<std::vector<Site>, 2> sites;
    std::vector<Box> boxes;   // of all parameters, which together hold the pairs that are looked for
  };

  const std::array<Spline_patch<d>, 2>& m_operands;
  Joint_rule m_rule;
  std::array<std::vector<std::vector<Axis_part>>, 2> m_parts;
  std::vector<Region> m_regions;

public:
  Site_pairs(const std::array<Spline_patch<d>, 2>& operands, const Joint_rule& rule)
    : m_operands(operands), m_rule(rule), m_parts{parts_of_axes(operands[0], rule), parts_of_axes(operands[1], rule)}
  {}

  void find_all()
  {
    m_regions = {
        {{sites_of(m_operands[0], m_parts[0], m_rule), sites_of(m_operands[1], m_parts[1], m_rule)}, {whole_domain()}}};
  }

  // Of the pairs that may be nearest, if none has a larger squared distance than some bound, which may become smaller.
  // Cells that may hold nearest points are in one region if they are neighbours. `check()` may end the work by an
  // exception.
  template <class Check>
  void find_nearest(Exact_rational& upper, const Check& check)
  {
    const Nearest_parts<d> nearest(m_operands[0], m_operands[1], {joints_of(0), joints_of(1)}, upper, check);
    if (std::isfinite(nearest.upper())) // as squares of doubles need not be
      upper = (std::min)(upper, to_rational(nearest.upper()));
    const std::vector<Box> boxes = nearest.boxes();
    for (const Box& hull : separate_hulls(nearest.boxes_of_cells())) {
      check();
      Region& region = m_regions.emplace_back();
      std::size_t next = 0;
      for (const std::size_t operand : {0, 1}) {
        std::vector<std::vector<Axis_part>> parts;
        for (const std::vector<Axis_part>& all : m_parts[operand])
          parts.push_back(parts_within(all, hull[next++]));
        region.sites[operand] = sites_of(m_operands[operand], parts, m_rule);
      }
      std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(region.boxes),
                   [&](const Box& box) { return meet(box, hull); });
    }
  }

  // Those with few unknowns first: they make others too far.
  std::vector<Pair_of_sites<d>> pairs() const
  {
    std::vector<Pair_of_sites<d>> result;
    for (const Region& region : m_regions)
      for (const Site& a : region.sites[0])
        for (const Site& b : region.sites[1]) {
          const Pair_of_sites<d> sites{&a, &b, &region.boxes};
          if (std::any_of(region.boxes.begin(), region.boxes.end(),
                          [&](const Box& box) { return sites.may_be_in(box); }))
            result.push_back(sites);
        }
    std::stable_sort(result.begin(), result.end(),
                     [&](const auto& x, const auto& y) { return x.unknowns() < y.unknowns(); });
    return result;
  }

private:
  Box whole_domain() const
  {
    Box result;
    for (const Spline_patch<d>& operand : m_operands)
      for (int axis = 0; axis < operand.number_of_parameters(); ++axis)
        result.push_back(operand.domain(axis));
    return result;
  }

  // The joints of an operand, by its breaks. Both ends of a closed axis are the same.
  Joints joints_of(std::size_t operand) const
  {
    Joints result;
    for (int axis = 0; axis < m_operands[operand].number_of_parameters(); ++axis) {
      const std::vector<Exact_rational> breaks = m_operands[operand].breaks(axis);
      std::vector<bool>& is_joint = result.emplace_back(breaks.size(), false);
      for (const Axis_part& part : m_parts[operand][axis])
        if (part.range.first == part.range.second)
          is_joint[static_cast<std::size_t>(std::lower_bound(breaks.begin(), breaks.end(), part.range.first) -
                                            breaks.begin())] = true;
      if (m_operands[operand].is_closed(axis))
        is_joint.back() = is_joint.front();
    }
    return result;
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_SITE_PAIRS_H
