// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_FINE_LEVEL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_FINE_LEVEL_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Fine_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Some curves, of which some may be scaled sites, on the level above doubles: made when a thread needs it for the first
// time.
class Fine_level
{
  const Site_graph_2<>& m_graph;
  const Scaled_sites<>* m_scaled;
  mutable std::once_flag m_is_made;
  mutable std::optional<Site_graph_2<Fine_interval>> m_fine_graph;
  mutable std::optional<Scaled_sites<Fine_interval>> m_fine_scaled;

public:
  // of sweeps along an element, and of one of them with many candidates
  static constexpr int most_nodes = 50, most_nodes_of_many = 16;
  static constexpr std::size_t most_candidates = 100;              // that are not many
  // of candidates along an element, where what was proved in surveys needed 7500 at most, and what a try costs besides
  static constexpr std::size_t most_bounds = 10000, bounds_of_try = 10;

  explicit Fine_level(const Site_graph_2<>& graph, const Scaled_sites<>* scaled = nullptr)
    : m_graph(graph), m_scaled(scaled)
  {}

  // Whether a part of an element of some size, 1 if it is large, is tried in a sweep that divides parts by a ratio,
  // below one half: at some widths, so that where doubles do not decide at all they need not be divided to the end.
  static bool is_tried(const Range& range, double split_ratio, double size = 1)
  {
    constexpr double most_width = 0x1p-20;
    constexpr int halvings = 4;   // between two tries
    const auto step = [](double width) { return std::ilogb(width) / halvings; };
    const double width = range.width() * size;
    return width < most_width && (range.width() == 1 || step(width) != step(width / (1 - split_ratio)));
  }

  const Site_graph_2<Fine_interval>& graph() const
  {
    std::call_once(m_is_made, [&] {
      m_fine_graph.emplace(m_graph);
      if (m_scaled != nullptr)
        m_fine_scaled.emplace(m_scaled->squared_factor, m_scaled->arcs, m_scaled->vertices);
    });
    return *m_fine_graph;
  }

  Disk_curvature<Fine_interval> curvature() const
  {
    const auto& fine_graph = graph();
    return Disk_curvature<Fine_interval>(fine_graph, m_fine_scaled ? &*m_fine_scaled : nullptr);
  }

  // Candidates with enclosures of this level; neighbouring ones of an arc as one, as those are divided again that need
  // be.
  std::vector<Disk_candidate<Fine_interval>> candidates(std::vector<Disk_candidate<>> candidates) const
  {
    std::sort(candidates.begin(), candidates.end(), [](const Disk_candidate<>& a, const Disk_candidate<>& b) {
      return std::tuple(a.kind, a.index, a.range.begin) < std::tuple(b.kind, b.index, b.range.begin);
    });
    std::vector<Disk_candidate<Fine_interval>> result;
    for (const Disk_candidate<>& candidate : candidates)
      if (candidate.kind == Candidate_kind::ARC && !result.empty() && result.back().kind == Candidate_kind::ARC &&
          result.back().index == candidate.index && result.back().range.end == candidate.range.begin)
        result.back().range.end = candidate.range.end;
      else
        result.push_back({candidate.kind, candidate.index, candidate.range});
    for (Disk_candidate<Fine_interval>& candidate : result)
      if (candidate.kind == Candidate_kind::ARC)
        candidate.jet = graph().arcs()[candidate.index].jet(candidate.range);
    return result;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_FINE_LEVEL_H
