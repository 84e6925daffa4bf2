// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_PAIR_OF_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_PAIR_OF_SITES_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

inline bool meet(const std::vector<Parameter_range>& a, const std::vector<Parameter_range>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), [](const Parameter_range& x, const Parameter_range& y) {
    return x.first <= y.second && y.first <= x.second;
  });
}

// A site of each of two operands, and boxes of all their parameters, which together hold the pairs of points that are
// looked for.
template <int d>
struct Pair_of_sites
{
  using Site = Spline_site<d>;
  using Box = std::vector<Parameter_range>;

  const Site *a, *b;
  const std::vector<Box>* boxes;

  // The number of parameters that are not fixed.
  std::size_t unknowns() const { return a->free_axes().size() + b->free_axes().size(); }

  // Whether a box may hold one of the pairs that are looked for, with the parameters of these sites: those of a piece
  // are not at a joint where the derivative is not zero.
  bool may_be_in(const Box& box) const
  {
    Box ranges = a->ranges();
    const Box others = b->ranges();
    ranges.insert(ranges.end(), others.begin(), others.end());
    return std::equal(
        box.begin(), box.end(), ranges.begin(), [](const Parameter_range& x, const Parameter_range& range) {
          return range.first == range.second ? x.first <= range.first && range.first <= x.second
                                             : x.first < x.second && x.first < range.second && range.first < x.second;
        });
  }

  // All parameters, where those that are free are in a box.
  Box with_fixed_parameters(const Box& box) const
  {
    Box result;
    auto next = box.begin();
    for (const Site* site : {a, b}) {
      const Box ranges = site->ranges();
      for (int axis = 0; axis < static_cast<int>(ranges.size()); ++axis)
        result.push_back(std::find(site->free_axes().begin(), site->free_axes().end(), axis) != site->free_axes().end()
                             ? *next++
                             : ranges[axis]);
    }
    return result;
  }

  // The same, of each operand.
  std::array<std::vector<Parameter_range>, 2> ranges_of(const Box& box) const
  {
    const Box all = with_fixed_parameters(box);
    const auto split = all.begin() + static_cast<std::ptrdiff_t>(a->ranges().size());
    return {std::vector<Parameter_range>(all.begin(), split), std::vector<Parameter_range>(split, all.end())};
  }

  Exact_rational squared_distance_at(const std::vector<Exact_rational>& point) const
  {
    const std::span<const Exact_rational> parameters(point);
    const auto split = static_cast<std::size_t>(a->patch().number_of_parameters());
    return squared_distance_of<d>(a->patch()(parameters.first(split)), b->patch()(parameters.subspan(split)));
  }

  // Bounds of the squared distance on a box of all parameters.
  Rational_interval range_on(const Box& box) const
  {
    const auto split = box.begin() + a->patch().number_of_parameters();
    return squared_distance_bounds<d>(a->patch().part(Box(box.begin(), split)), b->patch().part(Box(split, box.end())));
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_PAIR_OF_SITES_H
