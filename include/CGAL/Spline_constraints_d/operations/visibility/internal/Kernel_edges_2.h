// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_EDGES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_EDGES_2_H

#include <CGAL/Spline_constraints_d/operations/regions/internal/joined_edges.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_of_region_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

// The edges of a kernel, from its corners as they are seen from its centre.
class Kernel_edges_2
{
  using Boundary = Kernel_boundary_2;
  using Corner = Boundary::Corner;
  using Place = Kernel_element_2::Place;
  using Bounds = Kernel_of_region_2::Bounds;

  Kernel_of_region_2& m_kernel;

public:
  Kernel_edges_2(const Boundary& boundary, Kernel_of_region_2& kernel) : m_kernel(kernel)
  {
    append_edges(boundary);
    join_arcs();
  }

private:
  // From each corner to the next one, along one element: on its tangent at the begin, on the arc, and on its tangent at
  // the end.
  void append_edges(const Boundary& boundary)
  {
    const std::vector<Corner>& corners = boundary.corners();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const Corner &corner = corners[c], &next = corners[(c + 1) % corners.size()];
      const std::size_t i = corner.elements[1];
      const Kernel_element_2& element = boundary.elements()[i];
      const auto begin = element.range_of_end(0), end = element.range_of_end(1);
      const bool is_decided = corner.is_decided && next.is_decided && next.elements[0] == i &&
          is_one_place(corner.summits[1]) && is_one_place(next.summits[0]);
      const Bounds source = moved(corner.point);
      if (!is_decided) {
        append(Kernel_edge_kind::UNDECIDED, element, begin, end, source);
        continue;
      }
      if (element.is_line()) {
        append(Kernel_edge_kind::SEGMENT, element, begin, begin, source);
        continue;
      }
      const Place from = corner.summits[1][0].place, to = next.summits[0][0].place;
      if (from == Place::BEGIN)
        append(Kernel_edge_kind::SEGMENT, element, begin, begin, source);
      if (from != Place::END && to != Place::BEGIN) {
        const Parameters first = from == Place::BEGIN ? begin : range(corner.summits[1]),
                         last = to == Place::END ? end : range(next.summits[0]);
        append(Kernel_edge_kind::ARC, element, first, last, from == Place::BEGIN ? bounds(element, begin) : source);
      }
      if (to == Place::END)
        append(Kernel_edge_kind::SEGMENT, element, end, end, from == Place::END ? source : bounds(element, end));
    }
  }

  using Parameters = Parameter_range;
  using Summits = std::array<Kernel_element_2::Summit, 2>;

  static bool is_one_place(const Summits& summits) { return summits[0].place == summits[1].place; }
  static Parameters range(const Summits& summits)
  {
    return {(std::min)(summits[0].range.first, summits[1].range.first),
            (std::max)(summits[0].range.second, summits[1].range.second)};
  }

  void append(Kernel_edge_kind kind, const Kernel_element_2& element, const Parameters& first,
              const Parameters& last, const Bounds& source)
  {
    m_kernel.edges.push_back({kind, element.curve(), {element.on_curve(first), element.on_curve(last)}});
    m_kernel.vertices.push_back(source);
  }

  Bounds moved(Bounds bounds) const
  {
    for (std::size_t k = 0; k < 2; ++k)
      bounds[k] = bounds[k] + Rational_interval((*m_kernel.centre)[k]);
    return bounds;
  }

  // Of the points of a curve in a range.
  Bounds bounds(const Kernel_element_2& element, const Parameters& range) const
  {
    const auto [first, last] = element.on_curve(range);
    const Exact_pair point = m_kernel.parts.point(element.curve(), first);
    Bounds result{Rational_interval(point[0]), Rational_interval(point[1])};
    for (const Hull_piece_2& piece : m_kernel.parts.between(element.curve(), first, last))
      for (const Exact_pair& p : piece.points())
        for (std::size_t k = 0; k < 2; ++k)
          result[k] = hull(result[k], Rational_interval(p[k]));
    return result;
  }

  // One edge for successive arcs of one curve; the first one does not go on from the last one.
  void join_arcs()
  {
    using Edge = std::pair<Kernel_edge_2, Bounds>;   // with its source
    const auto goes_on = [](const Edge& a, const Edge& b) {
      const Kernel_edge_2 &edge = a.first, &next = b.first;
      return edge.kind == Kernel_edge_kind::ARC && next.kind == Kernel_edge_kind::ARC && edge.curve == next.curve &&
          edge.parameters[1] == next.parameters[0] && edge.is_reversed() == next.is_reversed();
    };
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < m_kernel.edges.size(); ++i)
      edges.emplace_back(m_kernel.edges[i], m_kernel.vertices[i]);
    edges = joined_edges(std::move(edges), goes_on, [](Edge& edge, const Edge& next) {
      edge.first.parameters[1] = next.first.parameters[1];
    });
    m_kernel.edges.clear();
    m_kernel.vertices.clear();
    for (const auto& [edge, source] : edges) {
      m_kernel.edges.push_back(edge);
      m_kernel.vertices.push_back(source);
    }
  }
};

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_EDGES_2_H
