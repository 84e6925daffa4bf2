// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_ARRANGEMENT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_ARRANGEMENT_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/Voronoi_diagram_2.h>
#include <CGAL/Spline_constraints_d/operations/to_arrangement_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

The edges of a Voronoi diagram or a medial axis as an arrangement of chords.
*/
template <SplineKernel Kernel>
struct Voronoi_arrangement_2
{
  //! the arrangement. Labels are indices of edges of the diagram, and of chords of the polylines.
  Polyline_arrangement_2 arrangement;

  //! the samples of each edge that the chords join: with the parameters of both sites, and the radius.
  std::vector<std::vector<Voronoi_sample_2<Kernel>>> polylines;

  //! whether the arrangement is proved to have the connections of the diagram: chords meet in their ends only, and edges around each vertex have the same order.
  bool has_same_topology;
};

namespace internal {

// A chord at one of the ends of a polyline.
struct End_chord
{
  std::size_t edge;
  CGAL::Exact_predicates_exact_constructions_kernel::Direction_2 direction;
};

// Whether the chords that leave a vertex are in the clockwise order of the edges there.
inline bool has_order_of_edges(std::vector<End_chord> chords, const std::vector<std::size_t>& edges)
{
  if (chords.size() != edges.size())
    return false;
  std::sort(chords.begin(), chords.end(), [](const End_chord& a, const End_chord& b) { return b.direction < a.direction; });   // directions increase counterclockwise
  for (std::size_t shift = 0; shift < edges.size(); ++shift) {
    bool is_equal = true;
    for (std::size_t i = 0; i < edges.size(); ++i)
      is_equal = is_equal && chords[(i + shift) % edges.size()].edge == edges[i];
    if (is_equal)
      return true;
  }
  return edges.empty();
}

template <class Diagram, class Point>
bool has_topology_of(const Diagram& diagram, const Polyline_arrangement_2& arrangement, const std::vector<std::vector<Point>>& polylines, double most_radius)
{
  if (!is_crossing_free(arrangement, polylines))
    return false;
  std::vector<std::vector<End_chord>> chords(diagram.vertices().size());
  for (std::size_t e = 0; e < polylines.size(); ++e)
    if (const auto& p = polylines[e]; p.size() > 1) {
      const auto& [first, last] = diagram.edges()[e].vertices;
      chords[first].push_back({e, (p[1] - p[0]).direction()});
      chords[last].push_back({e, (p[p.size() - 2] - p.back()).direction()});
    }
  for (std::size_t v = 0; v < chords.size(); ++v)
    if (const auto& vertex = diagram.vertices()[v]; vertex.radius <= most_radius && !has_order_of_edges(chords[v], vertex.edges))
      return false;
  return true;
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDOperations

a Voronoi diagram or a medial axis as an arrangement of chords of its edges.

Edges that have a vertex in common end in the same vertex of the arrangement, the point of the vertex, rounded; so do those that end in the angles between curves that cross, in one point. Edges to infinity are cut.

Whether the arrangement has the connections of the diagram is decided exactly; if not, the error is halved, up to eight times. Then each connected part of it can be deformed to that part of the diagram without a change of the connections.

\param diagram the diagram.
\param error a distance between edges and chords, see `Voronoi_diagram_2::polyline()`; positive.
\param most_radius edges to infinity are cut where the radius of the disks is larger, and so are vertices of such radius; positive and finite.
\throws Invalid_input when the error is not positive, or the radius is not positive or not finite.

Complexity: that of a sweep, \f$O(n \log n)\f$ for \f$n\f$ chords, for each error that is tried.
*/
template <SplineKernel Kernel>
Voronoi_arrangement_2<Kernel> to_arrangement(const Voronoi_diagram_2<Kernel>& diagram, double error, double most_radius)
{
  constexpr int most_refinements = 8;
  if (!(most_radius > 0 && std::isfinite(most_radius)))
    throw Invalid_input("to_arrangement: the radius must be positive and finite");
  using Point = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;
  Voronoi_arrangement_2<Kernel> result{{}, {}, false};
  for (int i = 0; i <= most_refinements && !result.has_same_topology; ++i, error /= 2) {
    std::vector<std::vector<Point>> polylines;
    result.polylines.clear();
    for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
      auto samples = diagram.polyline(e, error, most_radius);
      const auto& [first, last] = diagram.edges()[e].vertices;
      const auto is_kept = [&](std::size_t v) { return !samples.empty() && !diagram.vertices()[v].is_at_infinity && diagram.vertices()[v].radius <= most_radius; };
      if (is_kept(first))
        samples.front().point = diagram.vertices()[first].point;
      if (is_kept(last))
        samples.back().point = diagram.vertices()[last].point;
      auto& polyline = polylines.emplace_back();
      for (const auto& sample : samples)
        polyline.emplace_back(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()));
      result.polylines.push_back(std::move(samples));
    }
    result.arrangement = to_arrangement(polylines);
    result.has_same_topology = internal::has_topology_of(diagram, result.arrangement, polylines, most_radius);
  }
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_ARRANGEMENT_2_H
