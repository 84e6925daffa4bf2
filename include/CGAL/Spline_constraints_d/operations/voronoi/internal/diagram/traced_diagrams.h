// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_DIAGRAMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_DIAGRAMS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Traced_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/bisecting_chains.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/operands_of_sites.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/region_elements.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/undecided_parts.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The diagram of some elements of a graph.
template <class Concurrency_tag>
Curve_diagram diagram_of_graph(std::shared_ptr<const Site_graph_2<>> graph, std::vector<std::size_t> elements,
                               const Operand_numbers& numbers, const std::string& operation, Search_control& control)
{
  Disk_diagram disks = disk_diagram<Concurrency_tag>(*graph, std::move(elements), operation, control);
  Curve_diagram result;
  const auto traced = std::make_shared<const Traced_diagram>(std::move(graph), std::move(disks), control);
  result.undecided = undecided_parts(traced->graph(), numbers, traced->undecided());
  traced->describe(result);
  result.summary = control.summary(result.undecided.empty());
  result.traced = traced;
  return result;
}

template <class Concurrency_tag>
Curve_diagram diagram_of_curves(const Planar_operands& operands, const Solver_options& options,
                                const std::string& operation)
{
  Search_control control(options);
  const Operand_numbers numbers(operands);
  try {
    const auto graph = graph_of_crossing_curves<Concurrency_tag>(operands, &control);
    return diagram_of_graph<Concurrency_tag>(graph, all_elements(*graph), numbers, operation, control);
  } catch (const Run_stopped& stopped) {
    return without_answer<Curve_diagram>(numbers, stopped, control);
  }
}

template <class Concurrency_tag>
Curve_diagram diagram_of_region(const Region_operand& region, const Solver_options& options)
{
  Search_control control(options);
  const Operand_numbers numbers(Planar_operands{region.curves, {}});
  try {
    const auto graph = region_graph(region, &control);
    return diagram_of_graph<Concurrency_tag>(graph, region_elements(*graph, region, true), numbers, "medial_axis",
                                             control);
  } catch (const Run_stopped& stopped) {
    return without_answer<Curve_diagram>(numbers, stopped, control);
  }
}

template <class Concurrency_tag>
Bisecting_chains bisector_of_operands(const Ordered_operands& operands, const Solver_options& options)
{
  Search_control control(options);
  const Operand_numbers numbers(operands);
  if (operands.points.size() == 2 && operands.points[0] == operands.points[1])
    throw Invalid_input("trimmed_bisector: the points are equal");
  Bisecting_chains result;
  std::vector<int> sides;
  try {
    const auto graph = graph_of_crossing_curves<Concurrency_tag>(operands, &control);
    sides = sides_of_sites(operands, *graph);
    result.diagram =
        diagram_of_graph<Concurrency_tag>(graph, all_elements(*graph), numbers, "trimmed_bisector", control);
  } catch (const Run_stopped& stopped) {
    result.diagram = without_answer<Curve_diagram>(numbers, stopped, control);
  }
  result.chains = bisecting_chains(result.diagram, sides);
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_DIAGRAMS_H
