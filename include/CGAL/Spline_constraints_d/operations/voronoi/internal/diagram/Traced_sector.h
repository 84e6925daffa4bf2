// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_SECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_SECTOR_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_sector.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Sector_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/arcs_of_chain.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The disks of a sector, as its arcs and chains, and what is asked of these later.
*/
class Traced_sector
{
  using Part = Sector_disks::Arc;
  // one; or several, where the normals of a vertex come in several normal cones
  using Parts = std::vector<Part>;

  Sector_disks m_disks;
  double m_factor;       // of the distances
  bool m_is_exchanged;   // the nearer operand is the second one
  std::vector<Parts> m_parts_of_arc;
  std::vector<Trimmed_alpha_sector_arc_2> m_arcs;
  std::vector<Trimmed_alpha_sector_chain_2> m_chains;
  std::vector<Undecided_range> m_undecided;

public:
  // Chains that there is no time for are undecided.
  Traced_sector(Sector_disks disks, double factor, bool is_exchanged, Search_control& control)
    : m_disks(std::move(disks)), m_factor(factor), m_is_exchanged(is_exchanged), m_undecided(m_disks.undecided())
  {
    const Upward_rounding_guard guard;
    for (const Free_chains::Chain& chain : m_disks.chains())
      append_chain(chain, control);
  }

  const std::vector<Undecided_range>& undecided() const { return m_undecided; }

  // All that there is of it, but for what is not decided.
  void describe(Curve_sector& result) const
  {
    result.arcs = m_arcs;
    result.chains = m_chains;
  }

  std::vector<Sector_sample> samples(std::size_t arc, double error) const
  {
    const Upward_rounding_guard guard;
    using Located = std::pair<double, Sector_sample>;
    std::vector<Sector_sample> result;
    for (const Part& part : m_parts_of_arc[arc]) {
      const auto located = [&](double u) { return Located(u, sample(part, u)); };
      const auto between = [&](const Located& from, const Located& to) {
        return located(from.first / 2 + to.first / 2);
      };
      const auto is_chord = [&](const Located& from, const Located& middle, const Located& to) {
        return distance_from_middle(from.second.point, middle.second.point, to.second.point) <= error;
      };
      std::vector<Located> along{located(part.begin)};
      append_samples(along, located(part.end), between, is_chord);
      for (std::size_t i = result.empty() ? 0 : 1; i < along.size(); ++i)   // parts share their ends
        result.push_back(along[i].second);
    }
    return result;
  }

private:
  static double middle(const Interval& x) { return x.inf() / 2 + x.sup() / 2; }

  // Of an arc of the graph, or, of vertices, none.
  std::optional<double> curve_parameter(bool is_point, std::size_t arc, double u) const
  {
    return is_point ? std::nullopt : std::optional(m_disks.graph().curve_parameter(arc, u));
  }

  // In the order of the operands.
  template <class T>
  std::array<T, 2> in_order(const T& nearer, const T& farther) const
  {
    return m_is_exchanged ? std::array<T, 2>{farther, nearer} : std::array<T, 2>{nearer, farther};
  }

  static bool touches_vertex(const Part& part) { return part.footpoint.kind == Disk_footpoint::Kind::VERTEX; }

  Sector_sample sample(const Part& part, double u) const
  {
    const Oriented_element<>& element = m_disks.element(part);
    const Sector_disks::Disk disk = m_disks.disk(part, u);
    const double radius = middle(disk.radius);
    return {{middle(disk.center[0]), middle(disk.center[1])},
            in_order(radius, m_factor * radius),
            in_order(curve_parameter(element.is_normal_cone, element.object, u),
                     curve_parameter(touches_vertex(part), part.footpoint.index, disk.parameter))};
  }

  Trimmed_alpha_sector_arc_2 described(const Parts& parts) const
  {
    const Part& first = parts.front();
    const auto begin = sample(first, first.begin).parameters, end = sample(parts.back(), parts.back().end).parameters;
    Trimmed_alpha_sector_arc_2 result{in_order(m_disks.element(first).is_normal_cone, touches_vertex(first)), {}};
    for (std::size_t k = 0; k < 2; ++k)
      if (begin[k] && end[k])
        result.parameters[k] = {*begin[k], *end[k]};
    return result;
  }

  // Whether the nearest points go on in the next normal cone of the same vertex.
  bool goes_on(const Part& before, const Part& after) const
  {
    const Oriented_element<> &a = m_disks.element(before), &b = m_disks.element(after);
    return before.element != after.element && a.is_normal_cone && b.is_normal_cone && a.object == b.object &&
        before.footpoint == after.footpoint;
  }

  void append_chain(const Free_chains::Chain& chain, Search_control& control)
  {
    Parts parts_of_chain;
    for (const std::size_t piece : chain.pieces) {
      const Parts parts = m_disks.arcs(piece);
      parts_of_chain.insert(parts_of_chain.end(), parts.begin(), parts.end());
    }
    std::vector<Parts> arcs = arcs_of_chain(
        parts_of_chain, chain.is_closed, [&](const Part& before, const Part& after) { return goes_on(before, after); });
    if (m_is_exchanged)
      reverse(arcs);
    Trimmed_alpha_sector_chain_2 result{{}, chain.is_closed};
    std::vector<Trimmed_alpha_sector_arc_2> described_arcs;
    for (const Parts& parts : arcs) {
      if (control.is_overdue()) {
        for (const Part& part : parts_of_chain)
          m_undecided.push_back({part.element, range_of(part), control.reason()});
        return;
      }
      result.arcs.push_back(m_arcs.size() + described_arcs.size());
      described_arcs.push_back(described(parts));
    }
    m_arcs.insert(m_arcs.end(), described_arcs.begin(), described_arcs.end());
    m_parts_of_arc.insert(m_parts_of_arc.end(), arcs.begin(), arcs.end());
    m_chains.push_back(std::move(result));
  }

  static Range range_of(const Part& part)
  {
    return {(std::min)(part.begin, part.end), (std::max)(part.begin, part.end)};
  }

  static void reverse(std::vector<Parts>& arcs)
  {
    std::reverse(arcs.begin(), arcs.end());
    for (Parts& parts : arcs) {
      std::reverse(parts.begin(), parts.end());
      for (Part& part : parts)
        std::swap(part.begin, part.end);
    }
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Sector_sample> samples_of_arc(const Curve_sector& sector, std::size_t arc,
                                                                         double error)
{
  check_error(error, "Trimmed_alpha_sector_2");
  if (arc >= sector.arcs.size())
    throw Invalid_input("Trimmed_alpha_sector_2: there is no arc " + std::to_string(arc));
  return sector.traced->samples(arc, error);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_SECTOR_H
