// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_SECTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_SECTORS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_sector.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Traced_sector.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/operands_of_sites.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/undecided_parts.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The elements of the first operand, and the sites of the second one, whose distances are divided by a factor > 1.
struct Sector_sites
{
  std::vector<std::size_t> elements;
  std::shared_ptr<const Scaled_sites<>> scaled;
};

inline Sector_sites sector_sites(const Ordered_operands& operands, const Site_graph_2<>& graph,
                                 const Exact_rational& factor)
{
  std::vector<bool> arcs, vertices;   // those of the second operand
  for (std::size_t i = 0; i < graph.arcs().size(); ++i)
    arcs.push_back(is_on_arc(operands, 1, graph, i));
  for (const Site_graph_2<>::Vertex& vertex : graph.vertices())
    vertices.push_back(is_at_vertex(operands, 1, graph, vertex));
  Sector_sites result;
  for (std::size_t f = 0; f < graph.elements().size(); ++f)
    if (const Oriented_element<>& element = graph.elements()[f];
        !(element.is_normal_cone ? vertices : arcs)[element.object])
      result.elements.push_back(f);
  result.scaled =
      std::make_shared<const Scaled_sites<>>(Exact_rational(factor * factor), std::move(arcs), std::move(vertices));
  return result;
}

// The points that are `factor` > 1 times as far from the second operand as from the first one; both may have been
// exchanged.
template <class Concurrency_tag>
Curve_sector sector_with_factor(const Ordered_operands& operands, const Exact_rational& factor, bool is_exchanged,
                                const Solver_options& options)
{
  Search_control control(options);
  const Operand_numbers numbers(operands, is_exchanged);
  try {
    const auto graph = graph_of_crossing_curves<Concurrency_tag>(operands, &control);
    const auto [elements, scaled] = sector_sites(operands, *graph, factor);
    Sector_disks disks = sector_disks<Concurrency_tag>(graph, scaled, elements, control);
    Curve_sector result;
    const auto traced =
        std::make_shared<const Traced_sector>(std::move(disks), to_nearest_double(factor), is_exchanged, control);
    result.undecided = undecided_parts(*graph, numbers, traced->undecided());
    traced->describe(result);
    result.summary = control.summary(result.undecided.empty());
    result.traced = traced;
    return result;
  } catch (const Run_stopped& stopped) {
    return without_answer<Curve_sector>(numbers, stopped, control);
  }
}

// With 1 - alpha >= alpha, the points are (1 - alpha) / alpha times as far from the second operand as from the first
// one.
template <class Concurrency_tag>
Curve_sector sector_of_operands(const Ordered_operands& operands, const Exact_rational& alpha,
                                const Solver_options& options)
{
  const Exact_rational rest(1 - alpha);
  if (!(alpha > 0 && rest > 0))
    throw Invalid_input("trimmed_alpha_sector: alpha is not between 0 and 1");
  if (alpha == rest)
    throw Invalid_input("trimmed_alpha_sector: alpha is 1/2; trimmed_bisector() is for this");
  if (alpha < rest)
    return sector_with_factor<Concurrency_tag>(operands, Exact_rational(rest / alpha), false, options);
  return sector_with_factor<Concurrency_tag>(exchanged(operands), Exact_rational(alpha / rest), true, options);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_SECTORS_H
