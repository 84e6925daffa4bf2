// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_BISECTED_OPERANDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_BISECTED_OPERANDS_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Two curves, two points, or one of each, in order: those of both kinds.
template <SplineKernel Kernel>
struct Bisected_operands
{
  std::vector<Site_curve_2> curves;
  std::vector<CGAL::Point_2<Kernel>> points;
  std::array<std::pair<bool, std::size_t>, 2> places;   // of each operand: whether it is a point, and its index

  template <class A, class B>
  Bisected_operands(const A& a, const B& b) : places{add(a), add(b)} {}

  // Whether an operand passes through a vertex or ends there.
  bool is_at(std::size_t operand, const Site_graph_2<>& graph, const Site_graph_2<>::Vertex& vertex) const
  {
    const auto& [is_point, index] = places[operand];
    if (is_point)
      return vertex.is_exact && vertex.exact_point == exact_coordinates(points[index]);
    return std::any_of(vertex.ends.begin(), vertex.ends.end(),
                       [&graph, i = index](const Arc_end& end) { return graph.is_part_of(end.arc, i); });
  }

  bool is_on(std::size_t operand, const Site_graph_2<>& graph, std::size_t arc) const
  {
    return !places[operand].first && graph.is_part_of(arc, places[operand].second);
  }

private:
  template <ParametricCurve_2 Curve>
  std::pair<bool, std::size_t> add(const Curve& curve)
  {
    curves.emplace_back(curve);
    return {false, curves.size() - 1};
  }

  std::pair<bool, std::size_t> add(const CGAL::Point_2<Kernel>& point)
  {
    points.push_back(point);
    return {true, points.size() - 1};
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_BISECTED_OPERANDS_H
