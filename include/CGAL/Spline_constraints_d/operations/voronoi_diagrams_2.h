// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_DIAGRAMS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_DIAGRAMS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/Voronoi_diagram_2.h>

#include <memory>
#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

the Voronoi diagram of curves and points in the plane: which of them is nearest to a point, trimmed and connected by proof.

Curves may share end points; they must not cross or touch otherwise.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, std::ranges::input_range Range>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
auto voronoi_diagram(const Range& curves, const std::vector<typename std::ranges::range_value_t<Range>::Kernel::Point_2>& points = {})
{
  using Kernel = typename std::ranges::range_value_t<Range>::Kernel;
  auto graph = std::make_shared<internal::Site_graph_2>();
  std::size_t index = 0;
  for (const auto& curve : curves) {
    for (internal::Homogeneous_piece& piece : internal::homogeneous_pieces(curve, internal::Planar_map(curve)))
      graph->add_arc(std::move(piece), index);
    ++index;
  }
  for (const auto& point : points)
    graph->add_point({internal::converted_number<Exact_rational>(point.x()), internal::converted_number<Exact_rational>(point.y())});
  graph->close();
  auto diagram = std::make_shared<internal::Disk_diagram>(internal::disk_diagram<Concurrency_tag>(*graph));
  return Voronoi_diagram_2<Kernel>(graph, diagram);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_DIAGRAMS_2_H
