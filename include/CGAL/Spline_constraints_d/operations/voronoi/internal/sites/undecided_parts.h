// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_UNDECIDED_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_UNDECIDED_PARTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Undecided_part_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A part of an element.
struct Element_range
{
  std::size_t element;
  Range range;
};

// The part of a curve that a part of an element belongs to: of a normal cone, the end of one of the arcs there; of an
// isolated point, no curve.
inline Undecided_part_2 part_of_curve(const Site_graph_2<>& graph, const Element_range& part)
{
  const Oriented_element<>& element = graph.elements()[part.element];
  if (!element.is_normal_cone)
    return {graph.curve_of_arc(element.object), graph.curve_parameter(element.object, part.range.begin),
            graph.curve_parameter(element.object, part.range.end)};
  const auto& ends = graph.vertices()[element.object].ends;
  if (ends.empty())
    return {std::numeric_limits<std::size_t>::max(), 0, 0};
  const double t = graph.curve_parameter(ends.front().arc, ends.front().parameter());
  return {graph.curve_of_arc(ends.front().arc), t, t};
}

// Those parts of curves, in order, where parts that meet are one. Of a graph that is not proved, where curves may
// overlap, all of each curve.
inline std::vector<Undecided_part_2> undecided_parts(const Site_graph_2<>& graph, std::vector<Element_range> ranges)
{
  for (std::size_t f = 0; f < graph.elements().size() && !graph.is_proved(); ++f)
    ranges.push_back({f, Range()});
  std::vector<Undecided_part_2> parts, result;
  for (const Element_range& range : ranges)
    parts.push_back(part_of_curve(graph, range));
  std::sort(parts.begin(), parts.end(), [](const Undecided_part_2& a, const Undecided_part_2& b) {
    return std::tie(a.curve, a.from, a.to) < std::tie(b.curve, b.from, b.to);
  });
  for (const Undecided_part_2& part : parts)
    if (!result.empty() && result.back().curve == part.curve && part.from <= result.back().to)
      result.back().to = (std::max)(result.back().to, part.to);
    else
      result.push_back(part);
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_UNDECIDED_PARTS_H
