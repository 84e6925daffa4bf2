// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPES_OF_TWO_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPES_OF_TWO_SURFACES_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Envelope_collector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// A smooth part of a surface with two fields of tangents that span its tangent planes, at poles, too.
struct Surface_with_tangents
{
  Smooth_surface surface;
  std::array<Vector_of_functions<3>, 2> tangents;
};

// The parts of a surface, cut where a normal or the direction of a tangent jumps.
inline std::vector<Surface_with_tangents> surfaces_with_tangents(const Spline_patch<3>& patch,
                                                                 const std::function<void()>& check)
{
  std::vector<Surface_with_tangents> result;
  for (const Oriented_patch& part : oriented_patches(patch, check))
    for (Smooth_surface& own : smooth_surfaces(part.patch, check)) {
      const std::vector<Parameter_range> domain{own.patch.domain(0), own.patch.domain(1)};
      std::array<Vector_of_functions<3>, 2> tangents = part.tangents;
      for (Vector_of_functions<3>& field : tangents)
        for (const int axis : {0, 1})
          field = part_of<3>(field, axis, domain[static_cast<std::size_t>(axis)]);
      for (const int axis : {0, 1}) // the part may be one of a closed surface
        own.is_closed[static_cast<std::size_t>(axis)] =
            part.is_seam[static_cast<std::size_t>(axis)] && own.is_closed[static_cast<std::size_t>(axis)];
      result.push_back({std::move(own), std::move(tangents)});
    }
  return result;
}

// The sum of the points of two parts S(u, v) and R(s, t) where their normals m and n are parallel.
class Pair_of_surfaces
{
  const Smooth_surface& m_first;
  const Surface_with_tangents& m_second;
  std::vector<Unknown> m_unknowns;

public:
  //! \pre Both arguments live longer.
  Pair_of_surfaces(const Smooth_surface& first, const Surface_with_tangents& second)
    : m_first(first), m_second(second), m_unknowns(unknowns_in(domain()))
  {}

  Curve_vertex::Exact_box domain() const
  {
    const Spline_patch<3>&a = m_first.patch, &b = m_second.surface.patch;
    return {a.domain(0), a.domain(1), b.domain(0), b.domain(1)};
  }

  // <m, R_s> = <m, R_t> = 0
  Constraint_system_d system(const Operation_budget& budget) const
  {
    const Vector_expression<3> m = Parametric_vector<3>(m_first.normal)(first());
    Constraint_system_d result(domain());
    for (const Vector_of_functions<3>& tangent : m_second.tangents)
      result.add(dot(m, Parametric_vector<3>(tangent)(second())) == 0, [&] { budget.check(); });
    return result;
  }

  Vector_expression<3> image() const
  {
    return Parametric_vector<3>(m_first.patch)(first()) + Parametric_vector<3>(m_second.surface.patch)(second());
  }

  // Whether m and n have the same direction in a box with a solution, if that is certain.
  std::optional<bool> is_same_direction(const Curve_vertex::Exact_box& box) const
  {
    const auto bounds = [&](const Smooth_surface& surface, std::size_t place) {
      return Spline_patch<3>(surface.normal, surface.patch.weight(), false)
          .part(clipped({box[place], box[place + 1]}, {surface.patch.domain(0), surface.patch.domain(1)}))
          .values();
    };
    const Rational_interval product = dot(bounds(m_first, 0), bounds(m_second.surface, 2));
    if (product.lower > 0)
      return true;
    return product.upper < 0 ? std::optional(false) : std::nullopt;
  }

private:
  std::span<const Unknown> first() const { return std::span(m_unknowns).first(2); }
  std::span<const Unknown> second() const { return std::span(m_unknowns).subspan(2); }
};

// The surfaces of a set that are asked for, as a set of its own.
inline Surface_solution_set_d surfaces_of(const Surface_solution_set_d& set, const std::vector<bool>& is_kept)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> surface_at(set.surfaces().size(), none), patch_at(set.patches().size(), none),
      arc_at(set.arcs().size(), none), vertex_at(set.vertices().size(), none);
  std::vector<Solution_surface> surfaces;
  std::vector<Surface_patch> patches;
  std::vector<Surface_arc> arcs;
  std::vector<Curve_vertex> vertices;
  const auto new_vertex = [&](std::size_t& vertex) {
    if (vertex_at[vertex] == none) {
      vertex_at[vertex] = vertices.size();
      vertices.push_back(set.vertices()[vertex]);
    }
    vertex = vertex_at[vertex];
  };
  const auto new_arc = [&](std::size_t& arc) {
    if (arc_at[arc] == none) {
      arc_at[arc] = arcs.size();
      arcs.push_back(set.arcs()[arc]);
      for (std::size_t& end : arcs.back().ends)
        new_vertex(end);
    }
    arc = arc_at[arc];
  };
  for (std::size_t k = 0; k < set.surfaces().size(); ++k)
    if (is_kept[k]) {
      surface_at[k] = surfaces.size();
      surfaces.push_back(set.surfaces()[k]);
    }
  for (std::size_t p = 0; p < set.patches().size(); ++p)
    if (is_kept[set.patches()[p].surface]) {
      patch_at[p] = patches.size();
      patches.push_back(set.patches()[p]);
      patches.back().surface = surface_at[patches.back().surface];
      for (Surface_patch::Side& side : patches.back().boundary)
        new_arc(side.arc);
      if (patches.back().apex)
        new_vertex(*patches.back().apex);
    }
  for (Solution_surface& surface : surfaces) {
    for (std::size_t& patch : surface.patches)
      patch = patch_at[patch];
    for (std::vector<std::size_t>& loop : surface.boundary)
      for (std::size_t& arc : loop)
        new_arc(arc);
  }
  std::vector<std::size_t> points = set.points(), singular = set.singular_points();
  for (std::size_t& point : points)
    new_vertex(point);
  std::erase_if(singular, [&](std::size_t point) { return vertex_at[point] == none; });
  for (std::size_t& point : singular)
    new_vertex(point);
  std::vector<Undecided_surface_region> undecided = set.undecided_regions();
  for (Undecided_surface_region& region : undecided) {
    std::erase_if(region.arcs, [&](std::size_t arc) { return arc_at[arc] == none; });
    for (std::size_t& arc : region.arcs)
      arc = arc_at[arc];
  }
  return {std::make_shared<Constraint_system_d>(set.system()),
          set.dimension(),
          std::move(vertices),
          std::move(arcs),
          std::move(patches),
          std::move(surfaces),
          std::move(points),
          std::move(singular),
          std::move(undecided),
          set.summary()};
}

// Those on which the normals have the same direction: on a connected surface they have so everywhere or nowhere.
inline Surface_solution_set_d with_same_direction(const Surface_solution_set_d& set, const Pair_of_surfaces& pair,
                                                  Envelope_collector& result)
{
  std::vector<bool> is_kept;
  for (const Solution_surface& surface : set.surfaces()) {
    std::optional<bool> is_same;
    for (const std::size_t p : surface.patches)
      for (const Surface_patch::Side& side : set.patches()[p].boundary)
        if (!is_same)
          is_same = pair.is_same_direction(set.vertices()[set.arcs()[side.arc].ends[0]].box);
    if (!is_same)
      result.add_undecided(pair.domain(), "whether normals have the same direction");
    is_kept.push_back(is_same.value_or(true));
  }
  return surfaces_of(set, is_kept);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Envelope_surface_3 envelope_surface_of(const Exact_map<3>& first,
                                                                      const Exact_map<3>& second,
                                                                      const Solver_options& options)
{
  Envelope_collector result(options);
  const Spline_patch<3> a(first), b(second);
  try {
    const auto check = [&] { result.budget().check(); };
    const std::vector<Smooth_surface> parts = smooth_surfaces(a, check);
    const std::vector<Surface_with_tangents> others = surfaces_with_tangents(b, check);
    for (const Smooth_surface& part : parts)
      for (const Surface_with_tangents& other : others) {
        if (part.is_degenerate() || other.surface.is_degenerate())
          throw Invalid_input("envelope_surface: a piece of a surface is a curve or a point");
        const Pair_of_surfaces pair(part, other);
        result.add(pair.system(result.budget()), {}, pair.image(), closed_unknowns(part, other.surface),
                   poles(part, other.surface),
                   [&](const Surface_solution_set_d& set) { return with_same_direction(set, pair, result); });
      }
  } catch (const Run_stopped& stop) {
    result.add_undecided({a.domain(0), a.domain(1), b.domain(0), b.domain(1)}, in_words(stop.reason));
  }
  return std::move(result).result();
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPES_OF_TWO_SURFACES_H
