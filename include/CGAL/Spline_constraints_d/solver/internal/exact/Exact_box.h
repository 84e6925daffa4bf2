// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_EXACT_BOX_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_EXACT_BOX_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A closed range per unknown.
template <class Coordinate>
using Coordinate_box = std::vector<std::pair<Coordinate, Coordinate>>;
using Exact_box = Coordinate_box<Exact_rational>;

inline std::vector<Exact_rational> middle_of(const Exact_box& box)
{
  std::vector<Exact_rational> result;
  for (const auto& [lower, upper] : box)
    result.push_back(Exact_rational((lower + upper) / Exact_rational(2)));
  return result;
}

inline bool touch(const Exact_box& a, const Exact_box& b)
{
  for (std::size_t j = 0; j < a.size(); ++j)
    if (a[j].second < b[j].first || b[j].second < a[j].first)
      return false;
  return true;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_EXACT_BOX_H
