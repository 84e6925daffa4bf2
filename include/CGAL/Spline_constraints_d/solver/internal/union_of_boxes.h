// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_UNION_OF_BOXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_UNION_OF_BOXES_H

#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The unknown whose ranges begin at the most places: boxes along a face all have the same one of another unknown.
inline std::size_t axis_of_sweep(const std::vector<Exact_ranges>& boxes)
{
  std::size_t result = 0, most = 0;
  for (std::size_t j = 0; !boxes.empty() && j < boxes.front().size(); ++j) {
    std::vector<double> places;
    for (const Exact_ranges& box : boxes)
      places.push_back(CGAL::to_double(box[j].first));
    std::sort(places.begin(), places.end());
    const auto count = static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
    if (count > most) {
      most = count;
      result = j;
    }
  }
  return result;
}

// Of each box one of those that it is connected to, the same for all of them. By a sweep.
inline std::vector<std::size_t> roots_of_touching(const std::vector<Exact_ranges>& boxes)
{
  std::vector<std::size_t> root(boxes.size()), order(boxes.size());
  std::iota(root.begin(), root.end(), 0);
  std::iota(order.begin(), order.end(), 0);
  const auto find = [&](std::size_t i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  const std::size_t axis = axis_of_sweep(boxes);
  const auto range = [&](std::size_t i) -> const std::pair<Exact_rational, Exact_rational>& { return boxes[i][axis]; };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return range(i).first < range(k).first; });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size() && range(order[b]).first <= range(order[a]).second; ++b)
      if (find(order[a]) != find(order[b]) && touch(boxes[order[a]], boxes[order[b]]))
        root[find(order[a])] = find(order[b]);
  for (std::size_t i = 0; i < root.size(); ++i)
    root[i] = find(i);
  return root;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_UNION_OF_BOXES_H
