// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PAIRWISE_COMMON_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PAIRWISE_COMMON_POINTS_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Which patches of one collection, or of two, may meet each other, and where they do. There is an answer for each pair
// of patches whose boxes meet, in lexicographic order.
template <int d>
class Pairwise_common_points
{
  using Patches = std::vector<Spline_patch<d>>;

  Solver_options m_options;

public:
  // Of two patches, by their positions, or of one with itself.
  struct Pair
  {
    std::size_t first, second;
    std::vector<Common_point> points;
    Summary work;
  };

  explicit Pairwise_common_points(const Solver_options& options) : m_options(options) { m_options.check(); }

  // Of different patches of a collection.
  template <class Concurrency_tag>
  std::vector<Pair> among(const Patches& patches) const
  {
    return solved<Concurrency_tag>(pairs_with_meeting_boxes(patches), patches, patches);
  }

  // Of curves, also those of each one with itself.
  template <class Concurrency_tag>
  std::vector<Pair> among_and_within(const Patches& curves) const
  {
    std::vector<Index_pair> pairs = pairs_with_meeting_boxes(curves);
    for (std::size_t i = 0; i < curves.size(); ++i)
      pairs.emplace_back(i, i);
    std::sort(pairs.begin(), pairs.end());
    const auto find = [&](const Index_pair& pair, Budgeted_solver& solve) {
      return pair.first == pair.second
          ? self_common_points<d>(curves[pair.first], solve)
          : common_points<d>(Patch_pair<d>(curves[pair.first], curves[pair.second]), solve);
    };
    return found<Concurrency_tag>(pairs, find);
  }

  // Of a patch of one collection, and one of another one.
  template <class Concurrency_tag>
  std::vector<Pair> between(const Patches& first, const Patches& second) const
  {
    return solved<Concurrency_tag>(pairs_with_meeting_boxes(first, second), first, second);
  }

private:
  template <class Concurrency_tag>
  std::vector<Pair> solved(const std::vector<Index_pair>& pairs, const Patches& first, const Patches& second) const
  {
    return found<Concurrency_tag>(pairs, [&](const Index_pair& pair, Budgeted_solver& solve) {
      return common_points<d>(Patch_pair<d>(first[pair.first], second[pair.second]), solve);
    });
  }

  template <class Concurrency_tag, class Find>
  std::vector<Pair> found(const std::vector<Index_pair>& pairs, const Find& find) const
  {
    std::vector<Pair> result(pairs.size());
    const Operation_budget budget(m_options);
    std::atomic<std::size_t> nodes = 0; // of pairs that are done
    parallel_for<Concurrency_tag>(pairs.size(), [&](std::size_t i, std::size_t) {
      Budgeted_solver solve(budget.after(nodes));
      std::vector<Common_point> points = find(pairs[i], solve);
      nodes += solve.total().nodes;
      result[i] = {pairs[i].first, pairs[i].second, std::move(points), solve.total()};
    });
    return result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PAIRWISE_COMMON_POINTS_H
