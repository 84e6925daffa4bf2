// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_MESHER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_MESHER_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Patch_triangulation.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
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
Triangles of all patches. Arcs are polylines, which the patches on both sides share, and are made finer where one of
them needs it; the others are triangulated again then.
*/
class Surface_mesher
{
  using Triangle = std::array<std::size_t, 3>;

  Mesh_points& m_points;
  Run_control& m_control;
  const Surface_solution_set_d& m_set;
  std::vector<std::vector<std::size_t>> m_patches_of_arc;
  std::vector<std::vector<std::size_t>> m_chains; // of arcs: points, from one end to the other
  std::vector<std::vector<Triangle>> m_triangles; // of patches
  std::vector<std::size_t> m_failed;              // patches

public:
  Surface_mesher(Mesh_points& points, Run_control& control)
    : m_points(points), m_control(control), m_set(points.set()), m_patches_of_arc(m_set.arcs().size())
  {
    for (std::size_t p = 0; p < m_set.patches().size(); ++p)
      for (const Surface_patch::Side& side : m_set.patches()[p].boundary)
        m_patches_of_arc[side.arc].push_back(p);
  }

  // The indices of points that triangles have, oriented as the surfaces are, for each patch.
  const std::vector<std::vector<Triangle>>& operator()()
  {
    m_chains.assign(m_set.arcs().size(), {});
    m_triangles.assign(m_set.patches().size(), {});
    m_failed.clear();
    if (m_points.size() == 0)
      add_vertices();
    for (std::size_t a = 0; a < m_chains.size(); ++a)
      make_chain(a);
    for (const Surface_patch& patch : m_set.patches())
      if (patch.apex)
        straighten_chains(patch);
    triangulate_all();
    for (std::size_t p = 0; p < m_triangles.size(); ++p)
      orient(p);
    return m_triangles;
  }

  const std::vector<std::vector<std::size_t>>& chains() const { return m_chains; }

  // The patches that have no triangles: they were stopped, or their boundaries cross themselves however fine they are.
  const std::vector<std::size_t>& failed() const { return m_failed; }

private:
  // The points of the vertices come first, with the planes of all arcs that end there.
  void add_vertices()
  {
    std::vector<std::set<int>> planes(m_set.vertices().size());
    std::vector<std::optional<std::size_t>> patch(m_set.vertices().size());
    for (std::size_t a = m_set.arcs().size(); a-- > 0;)
      for (const std::size_t end : m_set.arcs()[a].ends) {
        planes[end].insert(m_set.arcs()[a].plane);
        if (!m_patches_of_arc[a].empty())
          patch[end] = m_patches_of_arc[a].front();
      }
    for (std::size_t p = 0; p < m_set.patches().size(); ++p)
      if (const std::optional<std::size_t> apex = m_set.patches()[p].apex)
        patch[*apex] = p;
    for (std::size_t i = 0; i < m_set.vertices().size(); ++i) {
      if (!patch[i]) {   // of a curve or a point in which a surface touches the domain
        m_points.add_unused();
        continue;
      }
      std::vector<int> fixed(planes[i].begin(), planes[i].end());
      std::vector<double> point = m_set.vertices()[i].point();
      std::vector<double> moved = point;
      if (fixed.size() == 2 && m_points.surface().move_to_surface(*patch[i], fixed, moved) &&
          Surface_points::is_in(Surface_points::around(m_set.vertices()[i].box), moved))
        point = std::move(moved);
      m_points.add(*patch[i], std::move(point), std::move(fixed));
    }
  }

  void make_chain(std::size_t a)
  {
    const auto& [first, last] = m_set.arcs()[a].ends;
    m_chains[a] = {first};
    append(a, first, last, 0);
  }

  // Arcs on faces of the domain that end in an apex are one chord up to the next patch, which the first of them has:
  // triangles with the apex and two points of such a curve would have no area where it is straight.
  void straighten_chains(const Surface_patch& patch)
  {
    const std::size_t sides = patch.boundary.size();
    for (std::size_t first = 0; first < sides; ++first)
      for (const bool is_forward : {true, false}) {
        const auto side = [&](std::size_t k) {
          return patch.boundary[(is_forward ? first + k : first + sides - k) % sides];
        };
        const auto end_of = [&](std::size_t k) {
          return m_set.arcs()[side(k).arc].ends[side(k).is_reversed == is_forward ? 0 : 1];
        };
        const auto& ends = m_set.arcs()[side(0).arc].ends;
        if (end_of(0) == patch.apex || ends[end_of(0) == ends[0] ? 1 : 0] != patch.apex || !is_on_domain(side(0).arc))
          continue;
        std::size_t count = 1;
        for (; count < sides && is_on_domain(side(count).arc); ++count)
          m_chains[side(count).arc].clear();
        m_chains[side(0).arc] = {*patch.apex, end_of(count - 1)};
        if (ends[0] != patch.apex)
          std::reverse(m_chains[side(0).arc].begin(), m_chains[side(0).arc].end());
      }
  }

  bool is_on_domain(std::size_t a) const
  {
    const auto& [lower, upper] = m_set.system().domain(m_set.arcs()[a].plane);
    const Exact_rational& value = m_set.arcs()[a].box[static_cast<std::size_t>(m_set.arcs()[a].plane)].first;
    return value == lower || value == upper;
  }

  // The points of an arc behind one up to another; chords are halved once at least, for their middles may be near by
  // chance.
  void append(std::size_t a, std::size_t from, std::size_t to, int depth)
  {
    constexpr int most_depth = 24;
    const Surface_arc& arc = m_set.arcs()[a];
    if (arc.parameter >= 0 && !m_patches_of_arc[a].empty() && depth < most_depth && !m_control.must_stop(false))
      if (const std::optional<std::size_t> middle = m_points.add_between(a, m_patches_of_arc[a].front(), from, to);
          middle && (depth == 0 || !m_points.is_fine(from, *middle, to))) {
        append(a, from, *middle, depth + 1);
        append(a, *middle, to, depth + 1);
        return;
      }
    m_chains[a].push_back(to);
  }

  // In the last round arcs stay as they are, so that all patches see the same.
  void triangulate_all()
  {
    constexpr int most_rounds = 8;
    std::set<std::size_t> open;
    for (std::size_t p = 0; p < m_triangles.size(); ++p)
      open.insert(p);
    for (int round = 0; round <= most_rounds && !open.empty(); ++round) {
      std::set<std::size_t> next;
      for (const std::size_t p : open) {
        if (m_control.must_stop(true))
          break;
        const std::set<Patch_triangulation::Chord> coarse = triangulate(p, round == most_rounds);
        if (round < most_rounds)
          for (const Surface_patch::Side& side : m_set.patches()[p].boundary)
            if (halve(side.arc, coarse))
              next.insert(m_patches_of_arc[side.arc].begin(), m_patches_of_arc[side.arc].end());
      }
      open = std::move(next);
    }
    if (m_control.must_stop(false))
      m_triangles.assign(m_triangles.size(), {}); // arcs may have changed on one side alone
    for (std::size_t p = 0; p < m_triangles.size(); ++p)
      if (m_triangles[p].empty())
        m_failed.push_back(p);
  }

  std::vector<std::size_t> loop_of(std::size_t patch) const
  {
    std::vector<std::size_t> result;
    for (const Surface_patch::Side& side : m_set.patches()[patch].boundary) {
      std::vector<std::size_t> chain = m_chains[side.arc];
      if (side.is_reversed)
        std::reverse(chain.begin(), chain.end());
      if (!chain.empty())
        result.insert(result.end(), chain.begin(), chain.end() - 1);
    }
    return result;
  }

  // Triangulates a patch. The chords of its boundary that are too long for it, all where they cross each other. Unless
  // this is the last round, there are triangles only where no chord is too long.
  std::set<Patch_triangulation::Chord> triangulate(std::size_t patch, bool is_last)
  {
    if (m_set.patches()[patch].apex) {
      m_triangles[patch] = cone_of(patch);
      return turning_chords(patch);
    }
    Patch_triangulation triangulation(m_points, patch);
    const std::vector<std::size_t> loop = loop_of(patch);
    std::set<Patch_triangulation::Chord> coarse;
    m_triangles[patch].clear();
    if (triangulation.set_boundary(loop)) {
      coarse = triangulation.steep_chords();
      if (coarse.empty() || is_last)
        coarse.merge(triangulation.refine());
      if (coarse.empty() || is_last)
        m_triangles[patch] = triangulation.triangles();
    } else
      for (std::size_t k = 0; k < loop.size(); ++k)
        coarse.insert(std::minmax(loop[k], loop[(k + 1) % loop.size()]));
    return coarse;
  }

  // A triangle for each chord of a patch with an apex that does not end there, the orientation of which is that along
  // its boundary.
  std::vector<Triangle> cone_of(std::size_t patch)
  {
    const std::size_t apex = *m_set.patches()[patch].apex;
    const std::vector<std::size_t> loop = loop_of(patch);
    std::vector<Triangle> result;
    double turn = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t a = loop[k], b = loop[(k + 1) % loop.size()];
      if (a == apex || b == apex)
        continue;
      result.push_back({apex, a, b});
      const Surface_image::Vector normal = m_points.image().normal(patch, m_points[a].unknowns);
      turn +=
          CGAL::cross_product(m_points[b].image - m_points[a].image, m_points[apex].image - m_points[a].image) * normal;
    }
    if (turn < 0)
      for (Triangle& triangle : result)
        std::swap(triangle[1], triangle[2]);
    return result;
  }

  // The chords of a patch with an apex whose triangles turn away from the normals of the surface too far.
  std::set<Patch_triangulation::Chord> turning_chords(std::size_t patch)
  {
    constexpr double least_cosine = 0.75;
    std::set<Patch_triangulation::Chord> result;
    for (const auto& [apex, a, b] : m_triangles[patch]) {
      const Surface_image::Vector normal =
          CGAL::cross_product(m_points[a].image - m_points[apex].image, m_points[b].image - m_points[apex].image);
      for (const std::size_t i : {a, b})
        if (!(normal * m_points.image().normal(patch, m_points[i].unknowns) >=
              least_cosine * Surface_image::length(normal)))
          result.insert(std::minmax(a, b));
    }
    return result;
  }

  // Puts points in the middle of some chords of an arc; whether it has one of them.
  bool halve(std::size_t a, const std::set<Patch_triangulation::Chord>& chords)
  {
    if (m_chains[a].empty())
      return false;
    std::vector<std::size_t> finer{m_chains[a].front()};
    for (std::size_t k = 1; k < m_chains[a].size(); ++k) {
      const std::size_t from = m_chains[a][k - 1], to = m_chains[a][k];
      if (m_set.arcs()[a].parameter >= 0 && chords.count(std::minmax(from, to)) > 0)
        if (const auto middle = m_points.add_between(a, m_patches_of_arc[a].front(), from, to))
          finer.push_back(*middle);
      finer.push_back(to);
    }
    const bool has_changed = finer.size() > m_chains[a].size();
    m_chains[a] = std::move(finer);
    return has_changed;
  }

  // Triangles are counterclockwise in the plane of the parameters. The gradients of the equalities and two directions
  // on the surface are positively oriented if the minor is positive and the parameters come last in an even order. With
  // each inequality, g - s = 0, the orientation changes.
  void orient(std::size_t p)
  {
    const Surface_patch& patch = m_set.patches()[p];
    if (patch.apex)
      return;
    const int n = m_set.system().dimension();
    const int exchanges = (n - 1 - patch.parameters[1]) + (n - 2 - patch.parameters[0]) + n - m_set.dimension();
    if (patch.orientation * (exchanges % 2 == 0 ? 1 : -1) < 0)
      for (Triangle& triangle : m_triangles[p])
        std::swap(triangle[1], triangle[2]);
  }
};

// Numbers points of triangles anew where surfaces meet, or one itself, in a point: there each fan of triangles gets a
// point of its own. Returns the points that the new ones beyond `points` are copies of.
inline std::vector<std::size_t> separate_fans(std::vector<std::array<std::size_t, 3>>& triangles,
                                              const std::set<std::size_t>& singular, std::size_t points)
{
  std::vector<std::size_t> copies;
  for (const std::size_t apex : singular) {
    std::vector<std::size_t> around;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (std::find(triangles[t].begin(), triangles[t].end(), apex) != triangles[t].end())
        around.push_back(t);
    boost::disjoint_sets_with_storage<> fans(around.size());
    std::map<std::size_t, std::size_t> at; // other ends of edges at the apex
    for (std::size_t k = 0; k < around.size(); ++k)
      for (const std::size_t i : triangles[around[k]])
        if (i != apex)
          if (const auto [place, is_new] = at.try_emplace(i, k); !is_new)
            fans.union_set(k, place->second);
    std::map<std::size_t, std::size_t> point_of;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const auto [place, is_new] = point_of.try_emplace(fans.find_set(k), apex);
      if (is_new && point_of.size() > 1) {
        place->second = points + copies.size();
        copies.push_back(apex);
      }
      std::replace(triangles[around[k]].begin(), triangles[around[k]].end(), apex, place->second);
    }
  }
  return copies;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_MESHER_H
