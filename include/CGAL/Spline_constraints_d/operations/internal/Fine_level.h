// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_FINE_LEVEL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_FINE_LEVEL_H

#include <CGAL/Spline_constraints_d/operations/internal/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/internal/Fine_interval.h>

#include <mutex>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Some curves, of which some may be scaled sites, on the level above doubles: made when a thread needs it for the first time.
class Fine_level
{
  const Site_graph_2& m_graph;
  const Scaled_sites* m_scaled;
  mutable std::once_flag m_is_made;
  mutable std::optional<Basic_site_graph_2<Fine_interval>> m_fine_graph;
  mutable std::optional<Basic_scaled_sites<Fine_interval>> m_fine_scaled;

public:
  explicit Fine_level(const Site_graph_2& graph, const Scaled_sites* scaled = nullptr) : m_graph(graph), m_scaled(scaled) {}

  const Basic_site_graph_2<Fine_interval>& graph() const
  {
    std::call_once(m_is_made, [&] {
      m_fine_graph.emplace(m_graph);
      if (m_scaled != nullptr)
        m_fine_scaled.emplace(m_scaled->squared_factor, m_scaled->arcs, m_scaled->vertices);
    });
    return *m_fine_graph;
  }

  Basic_disk_curvature<Fine_interval> curvature() const
  {
    const auto& fine_graph = graph();
    return Basic_disk_curvature<Fine_interval>(fine_graph, m_fine_scaled ? &*m_fine_scaled : nullptr);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_FINE_LEVEL_H
