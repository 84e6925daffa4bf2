// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_COMPLEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_COMPLEX_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_findings.h>
#include <CGAL/Spline_constraints_d/solver/internal/union_of_boxes.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The complex that patches make with their arcs and vertices: each arc belongs to at most two patches, and what shares
arcs is connected. All cells are disks, so that the Euler characteristic is the alternating sum of their numbers, where
a vertex counts once for each fan of patches around it. Where there are several, surfaces meet, or one itself, in a
singular point.
*/
class Surface_complex
{
  Surface_findings m_found;
  std::vector<Surface_arc> m_arcs;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> m_place_of_arc, m_place_of_vertex; // `none` for those that are not used
  std::vector<std::size_t> m_stored_arcs, m_stored_vertices;  // of those that are
  std::vector<Curve_vertex> m_vertices;
  std::vector<std::size_t> m_first_corner;    // per patch
  std::vector<std::size_t> m_singular_points; // vertices

  using Sets = boost::disjoint_sets_with_storage<>;

  struct Side_of_patch
  {
    std::size_t patch, side;
  };

public:
  explicit Surface_complex(Surface_findings&& found)
    : m_found(std::move(found)), m_place_of_arc(m_found.arcs.arcs().size(), none),
      m_place_of_vertex(m_found.arcs.number_of_vertices(), none)
  {}

  template <class Concurrency_tag>
  Surface_solution_set_d solution_set(std::shared_ptr<const Constraint_system_d> system, int dimension)
  {
    const Exact_ranges domain = domain_of(*system);
    for (Surface_patch& patch : m_found.patches)
      use_uncut_arcs(patch, domain);
    std::vector<std::size_t> points = m_found.points;
    for (std::size_t& i : points)
      i = vertex(i, domain);
    for (Surface_patch& patch : m_found.patches)
      if (patch.apex)
        patch.apex = vertex(*patch.apex, domain);
    take_boxes<Concurrency_tag>();
    std::vector<Undecided_surface_region> undecided = regions();
    std::vector<Solution_surface> surfaces = connected_surfaces(undecided);
    Summary summary = m_found.summary;
    const auto is_incomplete_for = [&](Undecided_reason reason) {
      summary.is_complete = false;
      summary.why_not = reason;
    };
    for (const Curve_solution_set_d& curves : m_found.lone_curves) {
      summary.nodes += curves.summary().nodes;
      if (!curves.is_complete())
        is_incomplete_for(curves.summary().why_not);
    }
    if (!undecided.empty())
      is_incomplete_for(undecided.front().reason);
    Surface_solution_set_d result(std::move(system), dimension, std::move(m_vertices), std::move(m_arcs),
                                  std::move(m_found.patches), std::move(surfaces), std::move(points),
                                  std::move(m_singular_points), std::move(undecided), summary);
    for (Curve_solution_set_d& curves : m_found.lone_curves)
      result.add_lone_curves(std::move(curves));
    return result;
  }

private:
  void use_uncut_arcs(Surface_patch& patch, const Exact_ranges& domain)
  {
    std::vector<Surface_patch::Side> boundary;
    for (const Surface_patch::Side& side : patch.boundary) {
      Arc_indices parts = m_found.arcs.parts_of({side.arc});
      if (side.is_reversed)
        std::reverse(parts.begin(), parts.end());
      for (const std::size_t part : parts) {
        boundary.push_back({arc(part, domain), side.is_reversed});
        ++m_arcs[boundary.back().arc].patches;
      }
    }
    patch.boundary = std::move(boundary);
  }

  std::size_t arc(std::size_t stored, const Exact_ranges& domain)
  {
    std::size_t& place = m_place_of_arc[stored];
    if (place == none) {
      place = m_arcs.size();
      const Stored_arc& own = m_found.arcs.arcs()[stored];
      m_arcs.push_back({{}, own.plane, own.parameter, {vertex(own.ends[0], domain), vertex(own.ends[1], domain)}});
      m_stored_arcs.push_back(stored);
    }
    return place;
  }

  std::size_t vertex(std::size_t stored, const Exact_ranges& domain)
  {
    std::size_t& place = m_place_of_vertex[stored];
    if (place == none) {
      place = m_vertices.size();
      const Plane_point& own = m_found.arcs.vertex(stored);
      bool is_on_boundary = false;
      for (std::size_t j = 0; j < domain.size(); ++j)
        is_on_boundary = is_on_boundary ||
            (own.is_fixed[j] && (own.box[j].first == domain[j].first || own.box[j].first == domain[j].second));
      m_vertices.push_back({{}, is_on_boundary, own.is_singular_point(), false});
      m_stored_vertices.push_back(stored);
    }
    return place;
  }

  // Copies the boxes, and frees the stored ones: exact numbers are many small pieces of memory.
  template <class Concurrency_tag>
  void take_boxes()
  {
    parallel_for<Concurrency_tag>(m_arcs.size(), [&](std::size_t i, std::size_t) {
      m_arcs[i].box = m_found.arcs.arcs()[m_stored_arcs[i]].box();
    });
    parallel_for<Concurrency_tag>(m_vertices.size(), [&](std::size_t i, std::size_t) {
      m_vertices[i].box = m_found.arcs.vertex(m_stored_vertices[i]).box;
    });
    parallel_for<Concurrency_tag>((std::max)(m_place_of_arc.size(), m_place_of_vertex.size()),
                                  [&](std::size_t i, std::size_t) { m_found.arcs.free_boxes(i); });
  }

  // The undecided boxes that touch, with the arcs of patches that they have.
  std::vector<Undecided_surface_region> regions() const
  {
    std::vector<Exact_ranges> boxes;
    for (const Undecided_surface_box& own : m_found.undecided)
      boxes.push_back(own.box);
    const std::vector<std::size_t> root = roots_of_touching(boxes);
    std::map<std::size_t, Undecided_surface_region> all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      Undecided_surface_region& region =
          all.try_emplace(root[i], Undecided_surface_region{{}, {}, m_found.undecided[root[i]].reason}).first->second;
      region.boxes.push_back(boxes[i]);
      for (const std::size_t part : m_found.arcs.parts_of(m_found.undecided[i].arcs))
        if (m_place_of_arc[part] != none)
          region.arcs.push_back(m_place_of_arc[part]);
    }
    std::vector<Undecided_surface_region> result;
    for (auto& [r, region] : all) {
      std::sort(region.arcs.begin(), region.arcs.end());
      region.arcs.erase(std::unique(region.arcs.begin(), region.arcs.end()), region.arcs.end());
      result.push_back(std::move(region));
    }
    return result;
  }

  // Joins what shares arcs: patches to surfaces, and corners of patches at a vertex to fans.
  std::vector<Solution_surface> connected_surfaces(const std::vector<Undecided_surface_region>& undecided)
  {
    std::vector<Surface_patch>& patches = m_found.patches;
    std::size_t corners = 0;
    for (const Surface_patch& patch : patches) {
      m_first_corner.push_back(corners);
      corners += patch.boundary.size();
    }
    Sets surfaces(patches.size()), fans(corners);
    std::vector<std::optional<Side_of_patch>> sides(m_arcs.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t k = 0; k < patches[p].boundary.size(); ++k) {
        std::optional<Side_of_patch>& other = sides[patches[p].boundary[k].arc];
        if (!other) {
          other = {p, k};
          continue;
        }
        surfaces.union_set(p, other->patch);
        for (const std::size_t end : {0, 1})
          fans.union_set(corner({p, k}, end), corner(*other, end));
      }
    find_singular_points(fans);
    std::set<std::size_t> open_arcs;
    for (const Undecided_surface_region& region : undecided)
      open_arcs.insert(region.arcs.begin(), region.arcs.end());
    std::map<std::size_t, std::size_t> place;
    std::vector<Solution_surface> result;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto [entry, is_new] = place.try_emplace(surfaces.find_set(p), result.size());
      if (is_new)
        result.push_back({{}, 0, {}, false});
      patches[p].surface = entry->second;
      result[entry->second].patches.push_back(p);
    }
    for (Solution_surface& surface : result)
      describe(surface, open_arcs, fans);
    return result;
  }

  // Of a patch, where the arc of a side has its end: corner k is where side k begins.
  std::size_t corner(const Side_of_patch& own, std::size_t end) const
  {
    const std::vector<Surface_patch::Side>& boundary = m_found.patches[own.patch].boundary;
    const bool is_begin = (end == 0) != boundary[own.side].is_reversed;
    return m_first_corner[own.patch] + (is_begin ? own.side : (own.side + 1) % boundary.size());
  }

  std::size_t vertex_at(const Surface_patch::Side& side) const
  {
    return m_arcs[side.arc].ends[side.is_reversed ? 1 : 0];
  }

  // The vertices with several fans, and those inside of patches.
  void find_singular_points(Sets& fans)
  {
    std::map<std::size_t, std::size_t> fan_at;
    std::set<std::size_t> result;
    for (std::size_t p = 0; p < m_found.patches.size(); ++p) {
      if (m_found.patches[p].apex)
        result.insert(*m_found.patches[p].apex);
      for (std::size_t k = 0; k < m_found.patches[p].boundary.size(); ++k) {
        const std::size_t own = vertex_at(m_found.patches[p].boundary[k]), fan = fans.find_set(m_first_corner[p] + k);
        if (fan_at.try_emplace(own, fan).first->second != fan)
          result.insert(own);
      }
    }
    m_singular_points.assign(result.begin(), result.end());
    for (const std::size_t i : m_singular_points)
      m_vertices[i].is_singular = true;
  }

  // A vertex counts once for each of its fans.
  void describe(Solution_surface& surface, const std::set<std::size_t>& open_arcs, Sets& fans) const
  {
    std::set<std::size_t> arcs, own_fans;
    std::map<std::size_t, std::vector<std::size_t>> boundary_at; // of fans
    for (const std::size_t p : surface.patches)
      for (std::size_t k = 0; k < m_found.patches[p].boundary.size(); ++k) {
        const std::size_t a = m_found.patches[p].boundary[k].arc;
        arcs.insert(a);
        own_fans.insert(fans.find_set(m_first_corner[p] + k));
        for (const std::size_t end : {0, 1})
          if (m_arcs[a].patches == 1)
            boundary_at[fans.find_set(corner({p, k}, end))].push_back(a);
        surface.is_open_ended = surface.is_open_ended || (m_arcs[a].patches == 1 && open_arcs.count(a) > 0);
      }
    surface.euler_characteristic =
        static_cast<int>(own_fans.size()) - static_cast<int>(arcs.size()) + static_cast<int>(surface.patches.size());
    surface.boundary = loops_of(boundary_at);
  }

  // A fan at the boundary has two arcs there: each arc leads from one fan to the next.
  static std::vector<std::vector<std::size_t>>
  loops_of(const std::map<std::size_t, std::vector<std::size_t>>& boundary_at)
  {
    std::map<std::size_t, std::vector<std::size_t>> fans_of; // of arcs
    for (const auto& [fan, arcs] : boundary_at)
      for (const std::size_t a : arcs)
        fans_of[a].push_back(fan);
    std::set<std::size_t> done;
    std::vector<std::vector<std::size_t>> result;
    for (const auto& [first, ends] : fans_of) {
      if (done.count(first) > 0)
        continue;
      std::vector<std::size_t>& loop = result.emplace_back();
      std::size_t arc = first, fan = ends[0];
      do {
        loop.push_back(arc);
        done.insert(arc);
        fan = fans_of[arc][fans_of[arc][0] == fan ? 1 : 0];
        const std::vector<std::size_t>& both = boundary_at.at(fan);
        arc = both[0] == arc ? both[1] : both[0];
      } while (arc != first);
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_COMPLEX_H
