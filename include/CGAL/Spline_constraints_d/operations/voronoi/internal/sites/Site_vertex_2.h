// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_VERTEX_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_VERTEX_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Oriented_element_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A point that is a site, or in which arcs end. Of one that is not known exactly, the exact point is next to it.
template <Enclosing_number Interval>
struct Site_vertex
{
  using Interval_pair = std::array<Interval, 2>;

  Exact_pair exact_point;
  Interval_pair point{any_number<Interval>(), any_number<Interval>()};
  std::vector<Arc_end> ends{};        // of the arcs here, counterclockwise
  std::vector<std::size_t> normal_cones{};
  bool is_exact = true;
  Interval_pair rest{Interval(0), Interval(0)};   // the exact point less the begin of the enclosure

  // If it is exact.
  void enclose()
  {
    if (!is_exact)
      return;
    point = interval_pair_of<Interval>(exact_point);
    for (std::size_t k = 0; k < 2; ++k)
      rest[k] = interval_of<Interval>(Exact_rational(exact_point[k] - Exact_rational(point[k].inf())));
  }

  // If it is not, by an arc that ends there.
  void enclose_by_end(const Site_arc_2<Interval>& arc, bool is_end)
  {
    if (!is_exact)
      point = common_part(point, arc.point({is_end ? 1.0 : 0.0, is_end ? 1.0 : 0.0}));
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_VERTEX_2_H
