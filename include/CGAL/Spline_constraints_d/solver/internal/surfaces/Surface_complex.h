// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_COMPLEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_COMPLEX_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/union_of_boxes.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The complex that patches make with their arcs and vertices: each arc belongs to at most two patches, and what shares
arcs is connected. All cells are disks, so that the Euler characteristic is the alternating sum of their numbers.
*/
class Surface_complex
{
  Surface_findings m_found;
  std::vector<Surface_arc> m_arcs;
  std::map<std::size_t, std::size_t> m_place_of_arc, m_place_of_vertex;
  std::vector<Curve_vertex> m_vertices;

public:
  explicit Surface_complex(Surface_findings&& found) : m_found(std::move(found)) {}

  Surface_solution_set_d solution_set(std::shared_ptr<const Constraint_system_d> system, int dimension)
  {
    const Exact_ranges domain = domain_of(*system);
    for (Surface_patch& patch : m_found.patches)
      use_uncut_arcs(patch, domain);
    std::vector<std::size_t> points = m_found.points;
    for (std::size_t& i : points)
      i = vertex(i, domain);
    std::vector<Undecided_surface_region> undecided = regions();
    std::vector<Solution_surface> surfaces = connected_surfaces(undecided);
    Summary summary = m_found.summary;
    if (!undecided.empty()) {
      summary.is_complete = false;
      summary.why_not = undecided.front().reason;
    }
    return Surface_solution_set_d(std::move(system), dimension, std::move(m_vertices), std::move(m_arcs),
                                  std::move(m_found.patches), std::move(surfaces), std::move(points),
                                  std::move(undecided), summary);
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
    const auto [place, is_new] = m_place_of_arc.try_emplace(stored, m_arcs.size());
    if (is_new) {
      const Stored_arc& own = m_found.arcs.arcs()[stored];
      m_arcs.push_back({own.box, own.plane, own.parameter, {vertex(own.ends[0], domain), vertex(own.ends[1], domain)}});
    }
    return place->second;
  }

  std::size_t vertex(std::size_t stored, const Exact_ranges& domain)
  {
    const auto [place, is_new] = m_place_of_vertex.try_emplace(stored, m_vertices.size());
    if (is_new) {
      const Plane_point& own = m_found.arcs.vertices()[stored];
      bool is_on_boundary = false;
      for (std::size_t j = 0; j < domain.size(); ++j)
        is_on_boundary = is_on_boundary ||
            (own.is_fixed[j] && (own.box[j].first == domain[j].first || own.box[j].first == domain[j].second));
      m_vertices.push_back({own.box, is_on_boundary, own.is_singular_point(), false});
    }
    return place->second;
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
        if (const auto place = m_place_of_arc.find(part); place != m_place_of_arc.end())
          region.arcs.push_back(place->second);
    }
    std::vector<Undecided_surface_region> result;
    for (auto& [r, region] : all) {
      std::sort(region.arcs.begin(), region.arcs.end());
      region.arcs.erase(std::unique(region.arcs.begin(), region.arcs.end()), region.arcs.end());
      result.push_back(std::move(region));
    }
    return result;
  }

  std::vector<Solution_surface> connected_surfaces(const std::vector<Undecided_surface_region>& undecided)
  {
    std::vector<Surface_patch>& patches = m_found.patches;
    boost::disjoint_sets_with_storage<> sets(patches.size());
    std::vector<std::vector<std::size_t>> patches_at(m_arcs.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (const Surface_patch::Side& side : patches[p].boundary) {
        patches_at[side.arc].push_back(p);
        sets.union_set(patches_at[side.arc].front(), p);
      }
    std::map<std::size_t, std::size_t> place;
    std::vector<Solution_surface> result;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto [entry, is_new] = place.try_emplace(sets.find_set(p), result.size());
      if (is_new)
        result.push_back({{}, 0, {}, false});
      patches[p].surface = entry->second;
      result[entry->second].patches.push_back(p);
    }
    std::set<std::size_t> open_arcs;
    for (const Undecided_surface_region& region : undecided)
      open_arcs.insert(region.arcs.begin(), region.arcs.end());
    for (Solution_surface& surface : result)
      describe(surface, open_arcs);
    return result;
  }

  void describe(Solution_surface& surface, const std::set<std::size_t>& open_arcs) const
  {
    std::set<std::size_t> arcs, vertices;
    for (const std::size_t p : surface.patches)
      for (const Surface_patch::Side& side : m_found.patches[p].boundary) {
        arcs.insert(side.arc);
        vertices.insert(m_arcs[side.arc].ends.begin(), m_arcs[side.arc].ends.end());
      }
    surface.euler_characteristic =
        static_cast<int>(vertices.size()) - static_cast<int>(arcs.size()) + static_cast<int>(surface.patches.size());
    std::erase_if(arcs, [&](std::size_t a) { return m_arcs[a].patches != 1; });
    surface.is_open_ended =
        std::any_of(arcs.begin(), arcs.end(), [&](std::size_t a) { return open_arcs.count(a) > 0; });
    surface.boundary = loops_of(arcs);
  }

  std::vector<std::vector<std::size_t>> loops_of(const std::set<std::size_t>& arcs) const
  {
    std::map<std::size_t, std::vector<std::size_t>> arcs_at;
    for (const std::size_t a : arcs)
      for (const std::size_t end : m_arcs[a].ends)
        arcs_at[end].push_back(a);
    std::set<std::size_t> left = arcs;
    std::vector<std::vector<std::size_t>> result;
    while (!left.empty()) {
      std::vector<std::size_t>& loop = result.emplace_back();
      std::size_t arc = *left.begin(), vertex = m_arcs[arc].ends[0];
      for (auto next = left.begin(); next != left.end();) {
        arc = *next;
        loop.push_back(arc);
        left.erase(next);
        vertex = m_arcs[arc].ends[m_arcs[arc].ends[0] == vertex ? 1 : 0];
        next = left.end();
        for (const std::size_t a : arcs_at[vertex])
          if (next == left.end())
            next = left.find(a);
      }
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_COMPLEX_H
