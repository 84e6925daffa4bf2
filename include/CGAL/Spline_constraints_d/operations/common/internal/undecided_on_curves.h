// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_UNDECIDED_ON_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_UNDECIDED_ON_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Locus_system.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A part of a curve, and the index of the curve in the input.
struct Curve_range
{
  const Planar_map& curve;
  std::size_t operand;
  Exact_range range;
};

void extend(std::vector<Undecided_part::Range>& box, const Coordinate_ranges<2>& by);

// What is undecided on parts of curves; its place is the box around these parts.
Undecided_part undecided_on_curves(const std::vector<Curve_range>& parts, std::string reason);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE void extend(std::vector<Undecided_part::Range>& box, const Coordinate_ranges<2>& by)
{
  if (box.empty())
    box.assign(by.begin(), by.end());
  for (std::size_t i = 0; i < box.size(); ++i)
    box[i] = {(std::min)(box[i].first, by[i].first), (std::max)(box[i].second, by[i].second)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Undecided_part undecided_on_curves(const std::vector<Curve_range>& parts,
                                                                  std::string reason)
{
  Undecided_part result{{}, {}, std::move(reason)};
  for (const auto& [curve, operand, range] : parts) {
    result.parameters.push_back({operand, {double_range(range)}});
    for (const Differentiated_map& piece : polynomial_pieces(curve, 0))
      if (range.first <= piece.end() && piece.begin() <= range.second) {
        const auto [u] = parameters(piece.map());
        extend(result.place, coordinate_ranges<2>(piece(0, u), {u}, {range}));
      }
  }
  return result;
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_UNDECIDED_ON_CURVES_H
