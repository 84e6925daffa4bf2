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

// Two patches, by their positions in their collections, or one and itself; and where they meet.
struct Pair_with_common_points
{
  std::size_t first, second;
  std::vector<Common_point> points;
  Summary work;
};

// What was found of pairs, in lexicographic order, before the end of the run.
struct Pairs_with_common_points
{
  std::vector<Pair_with_common_points> pairs;
  std::vector<std::size_t> rest = {};   // the first ones of the pairs that were not looked at
  Undecided_reason reason = Undecided_reason::NONE;   // why they were not
};

// Which patches of one collection, or of two, may meet each other, and where they do. There is an answer for each pair
// of patches whose boxes meet.
template <int d>
class Pairwise_common_points
{
  using Patches = std::vector<Spline_patch<d>>;

  Solver_options m_options;

public:
  explicit Pairwise_common_points(const Solver_options& options) : m_options(options) { m_options.check(); }

  // Of different patches of a collection.
  template <class Concurrency_tag>
  Pairs_with_common_points among(const Patches& patches) const
  {
    return solved<Concurrency_tag>(pairs_with_meeting_boxes(patches), patches, patches);
  }

  // Of curves, also those of each one with itself.
  template <class Concurrency_tag>
  Pairs_with_common_points among_and_within(const Patches& curves) const
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
  Pairs_with_common_points between(const Patches& first, const Patches& second) const
  {
    return solved<Concurrency_tag>(pairs_with_meeting_boxes(first, second), first, second);
  }

private:
  template <class Concurrency_tag>
  Pairs_with_common_points solved(const std::vector<Index_pair>& pairs, const Patches& first,
                                  const Patches& second) const
  {
    return found<Concurrency_tag>(pairs, [&](const Index_pair& pair, Budgeted_solver& solve) {
      return common_points<d>(Patch_pair<d>(first[pair.first], second[pair.second]), solve);
    });
  }

  template <class Concurrency_tag, class Find>
  Pairs_with_common_points found(const std::vector<Index_pair>& pairs, const Find& find) const
  {
    Pairs_with_common_points result;
    result.pairs.resize(pairs.size());
    std::vector<char> is_done(pairs.size(), false);
    const Operation_budget budget(m_options);
    std::atomic<std::size_t> nodes = 0;   // of pairs that are done
    std::atomic<Undecided_reason> reason = Undecided_reason::NONE;
    parallel_for<Concurrency_tag>(pairs.size(), [&](std::size_t i, std::size_t) {
      if (reason != Undecided_reason::NONE)
        return;
      Budgeted_solver solve(budget.after(nodes));
      if (m_options.node_limit > 0 && nodes >= m_options.node_limit)
        reason = Undecided_reason::NODES;
      else if (solve.must_stop())
        reason = solve.reason();
      else {
        std::vector<Common_point> points = find(pairs[i], solve);
        nodes += solve.total().nodes;
        result.pairs[i] = {pairs[i].first, pairs[i].second, std::move(points), solve.total()};
        is_done[i] = true;
      }
    });
    result.reason = reason;
    keep_those_done(pairs, is_done, result);
    return result;
  }

  static void keep_those_done(const std::vector<Index_pair>& pairs, const std::vector<char>& is_done,
                              Pairs_with_common_points& result)
  {
    std::size_t size = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (is_done[i])
        std::swap(result.pairs[size++], result.pairs[i]);
      else if (result.rest.empty() || result.rest.back() != pairs[i].first)
        result.rest.push_back(pairs[i].first);
    result.pairs.resize(size);
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PAIRWISE_COMMON_POINTS_H
