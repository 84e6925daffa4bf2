// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_GRAPH_OF_CROSSING_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_GRAPH_OF_CROSSING_CURVES_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/internal/Curve_crossings_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/site_graphs_2.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The graph of curves, cut where they cross, without parts that an earlier curve has, too; and of isolated points.
class Graph_of_crossing_curves
{
  const Curve_crossings_2& m_crossings;
  std::shared_ptr<Site_graph_2> m_graph = std::make_shared<Site_graph_2>();
  std::vector<std::optional<std::size_t>> m_vertices;   // of the crossings, made when they are needed

public:
  Graph_of_crossing_curves(const Curve_crossings_2& crossings, const std::vector<Site_curve_2>& curves, const std::vector<Exact_pair>& points) : m_crossings(crossings), m_vertices(crossings.size())
  {
    const Upward_rounding_guard guard;
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (const Homogeneous_piece& piece : curves[i].pieces)
        add_parts(piece, i);
    for (const Exact_pair& point : points)
      m_graph->add_point(point);
    for (const Coincident_parts_2& parts : m_crossings.coincident_parts())
      m_graph->add_coincident_parts(parts);
    m_graph->close(m_crossings.are_complete());
  }

  std::shared_ptr<const Site_graph_2> operator()() const { return m_graph; }

private:
  using Cut = Curve_crossings_2::Cut;

  // Those of a piece between successive cuts.
  void add_parts(const Homogeneous_piece& piece, std::size_t curve)
  {
    const std::vector<Cut> cuts = m_crossings.cuts(curve, piece.domain);
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      const Exact_rational begin = i == 0 ? piece.domain.first : cuts[i - 1].middle(), end = i == cuts.size() ? piece.domain.second : cuts[i].middle();
      if (m_crossings.is_redundant(curve, {begin, end}))
        continue;
      Homogeneous_piece part{{begin, end}, piece.coordinates};
      for (Bernstein_tensor<Exact_rational>& tensor : part.coordinates)
        tensor = tensor.restricted(0, piece.local(begin), piece.local(end));
      const auto place = [&](const Cut& cut) { return Site_graph_2::Place_of_end{vertex(cut.crossing), Exact_rational(cut.width() / (end - begin))}; };
      m_graph->add_arc(std::move(part), curve, {i == 0 ? std::nullopt : std::optional(place(cuts[i - 1])), i == cuts.size() ? std::nullopt : std::optional(place(cuts[i]))});
    }
  }

  std::size_t vertex(std::size_t crossing)
  {
    std::optional<std::size_t>& result = m_vertices[crossing];
    if (!result)
      result = m_crossings.point(crossing) ? m_graph->add_point(*m_crossings.point(crossing)) : m_graph->add_crossing(m_crossings.near_point(crossing));
    return *result;
  }
};

template <SplineKernel Kernel>
std::vector<Exact_pair> exact_points(const std::vector<CGAL::Point_2<Kernel>>& points)
{
  std::vector<Exact_pair> result;
  for (const auto& point : points)
    result.push_back(exact_coordinates(point));
  return result;
}

template <class Concurrency_tag, SplineKernel Kernel>
std::shared_ptr<const Site_graph_2> graph_of_crossing_curves(const std::vector<Site_curve_2>& curves, const std::vector<CGAL::Point_2<Kernel>>& points)
{
  const std::vector<Exact_pair> exact = exact_points(points);
  return Graph_of_crossing_curves(Curve_crossings_2::of<Concurrency_tag, Kernel>(curves, exact), curves, exact)();
}

// The same without cuts at crossings, unless curves touch.
template <class Concurrency_tag, SplineKernel Kernel>
std::shared_ptr<const Site_graph_2> graph_without_overlaps(const std::vector<Site_curve_2>& curves, const std::vector<CGAL::Point_2<Kernel>>& points)
{
  return Graph_of_crossing_curves(Curve_crossings_2::overlaps_of<Concurrency_tag, Kernel>(curves), curves, exact_points(points))();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_GRAPH_OF_CROSSING_CURVES_2_H
