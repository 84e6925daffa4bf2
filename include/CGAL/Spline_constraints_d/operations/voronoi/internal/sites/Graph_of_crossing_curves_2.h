// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_GRAPH_OF_CROSSING_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_GRAPH_OF_CROSSING_CURVES_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Curve_crossings_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/site_graphs_2.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The graph of curves, cut where they cross, without parts that an earlier curve has, too; and of isolated points.
class Graph_of_crossing_curves
{
  const Curve_crossings_2& m_crossings;
  std::shared_ptr<Site_graph_2<>> m_graph = std::make_shared<Site_graph_2<>>();
  std::vector<std::optional<std::size_t>> m_vertices;   // of the crossings, made when they are needed

public:
  Graph_of_crossing_curves(const Curve_crossings_2& crossings, const std::vector<Site_curve_2>& curves,
                           const std::vector<Exact_pair>& points, Search_control* control = nullptr)
    : m_crossings(crossings), m_vertices(crossings.size())
  {
    const Upward_rounding_guard guard;
    Regular_check check(control, 16);
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (const Homogeneous_piece& piece : curves[i].pieces) {
        check();
        add_parts(piece, i);
      }
    for (const Exact_pair& point : points)
      m_graph->add_point(point);
    for (const Coincident_parts_2& parts : m_crossings.coincident_parts())
      m_graph->add_coincident_parts(parts);
    m_graph->close(m_crossings.are_complete(), m_crossings.are_cut(), control);
  }

  std::shared_ptr<const Site_graph_2<>> operator()() const { return m_graph; }

private:
  using Cut = Curve_crossings_2::Cut;

  // Where a part begins or ends: in a crossing, if any.
  struct Limit
  {
    Exact_rational parameter;
    std::optional<Cut> cut{};

    bool is_exact() const { return !cut || cut->is_exact(); }
  };

  // Those of a piece between successive cuts.
  void add_parts(const Homogeneous_piece& piece, std::size_t curve)
  {
    const std::vector<Limit> limits = limits_of_parts(piece, curve);
    for (std::size_t i = 1; i < limits.size(); ++i) {
      const Exact_rational &begin = limits[i - 1].parameter, &end = limits[i].parameter;
      if (m_crossings.is_redundant(curve, {begin, end}))
        continue;
      Homogeneous_piece part = piece.within({begin, end});
      const auto place = [&](const Limit& limit) {
        return limit.cut ? std::optional(Site_graph_2<>::Place_of_end{
                               vertex(limit.cut->crossing), Exact_rational(limit.cut->width() / (end - begin))})
                         : std::nullopt;
      };
      m_graph->add_arc(std::move(part), curve, {place(limits[i - 1]), place(limits[i])});
    }
  }

  // The ends of a piece and all cuts. A part at whose end the derivative is zero, which is decided exactly, does not
  // reach up to a crossing that is not known exactly.
  std::vector<Limit> limits_of_parts(const Homogeneous_piece& piece, std::size_t curve) const
  {
    std::vector<Limit> result{{piece.domain.first}};
    for (const Cut& cut : m_crossings.cuts(curve, piece.domain))
      result.push_back({cut.middle(), cut});
    result.push_back({piece.domain.second});
    for (const bool end : {false, true}) {
      const std::size_t i = end ? result.size() - 1 : 1;
      if (piece.stops_at(end) && !result[end ? i - 1 : i].is_exact())
        result.insert(result.begin() + static_cast<std::ptrdiff_t>(i),
                      {Exact_rational((result[i - 1].parameter + result[i].parameter) / 2)});
    }
    return result;
  }

  std::size_t vertex(std::size_t crossing)
  {
    std::optional<std::size_t>& result = m_vertices[crossing];
    if (!result)
      result = m_crossings.point(crossing) ? m_graph->add_point(*m_crossings.point(crossing))
                                           : m_graph->add_crossing(m_crossings.near_point(crossing));
    return *result;
  }
};

template <class Concurrency_tag>
std::shared_ptr<const Site_graph_2<>> graph_of_crossing_curves(const Planar_operands& operands,
                                                               Search_control* control = nullptr)
{
  const std::vector<Site_curve_2> curves = site_curves(operands.curves, control);
  return Graph_of_crossing_curves(Curve_crossings_2::of<Concurrency_tag>(curves, operands.points, control), curves,
                                  operands.points, control)();
}

// The same without cuts at crossings, unless curves touch.
template <class Concurrency_tag>
std::shared_ptr<const Site_graph_2<>> graph_without_overlaps(const Planar_operands& operands,
                                                             Search_control* control = nullptr)
{
  const std::vector<Site_curve_2> curves = site_curves(operands.curves, control);
  return Graph_of_crossing_curves(Curve_crossings_2::overlaps_of<Concurrency_tag>(curves, control), curves,
                                  operands.points, control)();
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_GRAPH_OF_CROSSING_CURVES_2_H
