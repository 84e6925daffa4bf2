// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_COINCIDENT_PARTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_COINCIDENT_PARTS_2_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A piece that two curves have in common: all points of the second one are proved to be points of the first one, and
// the ends are the same. The second curve may run backwards there.
struct Curve_overlap_2
{
  std::array<std::pair<Exact_rational, Exact_rational>, 2> parameters;
  bool is_reversed;
};

// With the indices of the curves; of one curve, if parts of it overlap.
struct Coincident_parts_2
{
  std::array<std::size_t, 2> curves;
  Curve_overlap_2 overlap;

  bool hold(std::size_t k, std::size_t curve, const std::pair<Exact_rational, Exact_rational>& range) const
  {
    return curves[k] == curve && overlap.parameters[k].first <= range.first &&
        range.second <= overlap.parameters[k].second;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_COINCIDENT_PARTS_2_H
