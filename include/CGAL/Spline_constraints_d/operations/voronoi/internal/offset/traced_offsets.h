// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TRACED_OFFSETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TRACED_OFFSETS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Curve_offset.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Traced_offset.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/region_elements.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/undecided_parts.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Of a free set, which is on the left of the chains, or of the other one.
template <class Concurrency_tag>
Curve_offset offset_of_graph(std::shared_ptr<const Site_graph_2<>> graph, const Exact_rational& radius,
                             const std::vector<std::size_t>& elements, bool is_set_free,
                             const Operand_numbers& numbers, Search_control& control)
{
  Curve_offset result;
  const auto traced = std::make_shared<const Traced_offset>(
      offset_cycles<Concurrency_tag>(std::move(graph), radius, elements, is_set_free, control), !is_set_free);
  const Offset_cycles& cycles = traced->cycles();
  result.undecided = undecided_parts(cycles.graph(), numbers, cycles.undecided(),
                                     [&](const Undecided_range& range) { return cycles.place(range); });
  traced->describe(result);
  result.summary = control.summary(result.undecided.empty());
  result.traced = traced;
  return result;
}

template <class Concurrency_tag>
Curve_offset offset_of_curves(const Planar_operands& operands, const Exact_rational& radius,
                              const Solver_options& options)
{
  if (CGAL::sign(radius) != CGAL::POSITIVE)
    throw Invalid_input("trimmed_offset: the distance must be positive");
  Search_control control(options);
  const Operand_numbers numbers(operands);
  try {
    const auto graph = graph_without_overlaps<Concurrency_tag>(operands, &control);
    return offset_of_graph<Concurrency_tag>(graph, radius, all_elements(*graph), false, numbers, control);
  } catch (const Run_stopped& stopped) {
    return without_answer<Curve_offset>(numbers, stopped, control);
  }
}

template <class Concurrency_tag>
Curve_offset offset_of_region(const Region_operand& region, const Exact_rational& distance,
                              const Solver_options& options)
{
  const CGAL::Sign sign = CGAL::sign(distance);
  if (sign == CGAL::ZERO)
    throw Invalid_input("trimmed_offset: the distance must not be zero");
  const bool is_inside = sign == CGAL::NEGATIVE;
  Search_control control(options);
  const Operand_numbers numbers(Planar_operands{region.curves, {}});
  try {
    const auto graph = region_graph(region, &control);
    return offset_of_graph<Concurrency_tag>(graph, CGAL::abs(distance), region_elements(*graph, region, is_inside),
                                            is_inside, numbers, control);
  } catch (const Run_stopped& stopped) {
    return without_answer<Curve_offset>(numbers, stopped, control);
  }
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TRACED_OFFSETS_H
