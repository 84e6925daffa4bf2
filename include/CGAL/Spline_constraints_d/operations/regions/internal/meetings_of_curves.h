// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_MEETINGS_OF_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_MEETINGS_OF_CURVES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// Where two curves meet, by their positions, or one meets itself.
struct Meeting_of_curves
{
  std::size_t first, second;
  std::vector<Common_point> points;
};

// Where curves meet each other and themselves, in lexicographic order.
// \throws Run_stopped
inline std::vector<Meeting_of_curves> meetings_of_curves(const std::vector<Spline_patch<2>>& curves, Run_of_steps& run)
{
  std::vector<Index_pair> pairs = pairs_with_meeting_boxes(curves);
  for (std::size_t i = 0; i < curves.size(); ++i)
    pairs.emplace_back(i, i);
  std::sort(pairs.begin(), pairs.end());
  std::vector<Meeting_of_curves> result;
  for (const auto& [i, k] : pairs) {
    run.check();
    Budgeted_solver solve(run.options_of_systems());
    std::vector<Common_point> points =
        i == k ? self_common_points<2>(curves[i], solve) : common_points<2>(Patch_pair<2>(curves[i], curves[k]), solve);
    run.add_nodes(solve.total().nodes);
    if (!points.empty())
      result.push_back({i, k, std::move(points)});
  }
  run.check();
  return result;
}

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_MEETINGS_OF_CURVES_H
