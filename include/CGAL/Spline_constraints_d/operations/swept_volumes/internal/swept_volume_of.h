// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_OF_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_OF_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/Swept_volume_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/Cell_labels.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/Sweep_membership.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Boundary_of_cells.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Shell_samples.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/cut_triangles.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Sweep_sheets.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_membership.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/corner_fans.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/swept_volume_finders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The boundary of a solid as patches with the same normals on both sides of each line inside of them, and the envelope
// of each one while it moves.
class Smooth_patches
{
  using Lines = Solid_boundary::Lines;

  Solid_boundary m_solid;
  std::vector<Envelope_surface_3> m_envelopes;

public:
  Smooth_patches(const Solid_boundary& solid, const Rational_motion_3& motion, Common::Operation_budget& budget)
    : m_solid(solid)
  {
    const Touching_corners touching_corner(motion);
    cut_along(kinks(budget));
    do {
      while (!budget.must_stop() && cut_at_corners(touching_corner))
        ;
      find_envelopes(motion, budget);
      // a line that touches its envelope all the time sweeps a part of it as an edge does
    } while (cut_along(touching_lines()));
  }

  const Solid_boundary& solid() const { return m_solid; }
  const std::vector<Envelope_surface_3>& envelopes() const { return m_envelopes; }

  // Where nothing was found of the envelopes. Where the surface moves along itself, there is none.
  std::vector<Undecided_part> undecided() const
  {
    std::vector<Undecided_part> result;
    for (std::size_t patch = 0; patch < m_envelopes.size(); ++patch)
      for (Undecided_part part : m_envelopes[patch].undecided()) {
        if (part.reason == Envelope_surfaces::moves_along_itself)
          continue;
        for (std::size_t axis = 0; axis < (std::min)(part.place.size(), std::size_t(2)); ++axis)
          part.place[axis] = m_solid.original_range(patch, static_cast<int>(axis), part.place[axis]);
        if (m_solid.number_of_operands() > 1)
          part.reason += ", of surface " + std::to_string(m_solid.operand(patch));
        result.push_back(std::move(part));
      }
    return result;
  }

private:
  // Cuts patches, if there are lines.
  bool cut_along(std::vector<Lines> lines)
  {
    if (std::all_of(lines.begin(), lines.end(), [](const Lines& own) { return own[0].empty() && own[1].empty(); }))
      return false;
    m_solid = m_solid.cut_along(std::move(lines));
    return true;
  }

  std::vector<Lines> kinks(const Common::Operation_budget& budget) const
  {
    std::vector<Lines> result(m_solid.size());
    for (std::size_t patch = 0; patch < m_solid.size() && !budget.must_stop(); ++patch) {
      if (m_solid[patch].possible_kinks(0).empty() && m_solid[patch].possible_kinks(1).empty())
        continue;
      for (const auto& part : Envelope_surfaces::smooth_surfaces(m_solid[patch], [] {}))
        for (const int axis : {0, 1})
          for (const Exact_rational& end : {part.patch.domain(axis).first, part.patch.domain(axis).second})
            add(result[patch], axis, end);
    }
    return result;
  }

  // Cuts patches at corners that touch their envelope all the time; along all breaks before.
  bool cut_at_corners(const Touching_corners& touching_corner)
  {
    std::vector<std::optional<int>> corners;
    std::vector<Lines> breaks(m_solid.size());
    for (std::size_t patch = 0; patch < m_solid.size(); ++patch) {
      corners.push_back(touching_corner(m_solid[patch]));
      if (corners.back())
        for (const int axis : {0, 1})
          for (const Exact_rational& value : m_solid[patch].breaks(axis))
            add(breaks[patch], axis, value);
    }
    if (std::none_of(corners.begin(), corners.end(), [](const auto& own) { return own.has_value(); }))
      return false;
    if (!cut_along(std::move(breaks)))
      m_solid = m_solid.with_fans(corners);
    return true;
  }

  std::vector<Lines> touching_lines() const
  {
    std::vector<Lines> result(m_solid.size());
    for (std::size_t patch = 0; patch < m_solid.size(); ++patch)
      for (const Envelope_part_3& part : m_envelopes[patch].parts())
        if (part.constant_unknown)
          add(result[patch], part.constant_unknown->first, part.constant_unknown->second);
    return result;
  }

  static void add(Lines& lines, int axis, const Exact_rational& value)
  {
    if (0 < value && value < 1)
      lines[static_cast<std::size_t>(axis)].insert(value);
  }

  void find_envelopes(const Rational_motion_3& motion, Common::Operation_budget& budget)
  {
    m_envelopes.clear();
    for (const Solid_boundary::Patch& patch : m_solid.patches()) {
      m_envelopes.push_back(
          Envelope_surfaces::sweep_envelope_of({patch.numerators(), patch.weight(), patch.is_rational()}, motion,
                                               budget.remaining(), Envelope_surfaces::Envelope_use::BOUNDARY));
      budget.add(m_envelopes.back().summary());
    }
  }
};

// The boundary as triangles that cross each other; the cells that these cut space into; which of them are swept; the
// triangles between those that are and those that are not.
CGAL_SPLINE_CONSTRAINTS_INLINE Swept_volume_3 swept_volume_of(const std::vector<Common::Exact_map<3>>& surfaces,
                                                              const Rational_motion_3& motion,
                                                              const Surface_mesh_options& fineness,
                                                              const Solver_options& options)
{
  if (!(fineness.chord_error > 0 && std::isfinite(fineness.chord_error)))
    throw Invalid_input("swept_volume: the chord error must be positive and finite");
  Common::Operation_budget budget(options);
  const Solid_boundary solid = solid_boundary_of(surfaces, "swept volume");
  Sweep_membership membership(solid, motion, budget);
  double error = fineness.chord_error;
  Boundary_of_cells::Mesh mesh;
  std::vector<Thin_cell> thin_cells;
  std::vector<Undecided_part> undecided;
  const auto add_undecided = [&](const auto& parts) { undecided.insert(undecided.end(), parts.begin(), parts.end()); };

  const auto has_outer_normals = membership.has_outer_normals(has_positive_maps(motion, "swept volume"));
  if (!has_outer_normals)
    undecided.push_back({{}, {}, "on which side of the surface the solid lies"});
  const Smooth_patches smooth(solid, motion, budget);
  add_undecided(smooth.undecided());
  if (has_outer_normals && !budget.must_stop()) {
    std::vector<bool> is_outer;
    for (std::size_t patch = 0; patch < smooth.solid().size(); ++patch)
      is_outer.push_back((*has_outer_normals)[smooth.solid().operand(patch)]);
    Sweep_sheets sheets(smooth.solid(), motion, is_outer, smooth.envelopes(), fineness, budget);
    add_undecided(sheets.undecided());
    error = (std::max)(error, sheets.error());
    if (const auto complex = triangle_complex_of(sheets.soup(), [&] { return budget.must_stop(); })) {
      const Triangle_shells shells(*complex);
      if (!shells.is_closed())
        undecided.push_back({{}, {}, "the triangles do not bound cells"});
      Cell_labels labels(*complex, shells, fineness.chord_error, membership);
      add_undecided(labels.undecided());
      thin_cells = labels.thin_cells();
      mesh = std::move(labels.mesh());
    }
  }
  if (budget.must_stop())
    undecided.push_back({{}, {}, in_words(budget.reason())});
  Summary work = budget.total();
  work.seconds = budget.seconds();
  work.is_complete = undecided.empty();
  return {std::move(mesh), error, std::move(thin_cells), std::move(undecided), work};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::vector<std::pair<Exact_rational, Exact_rational>>>
sweep_intervals_of(const std::vector<Common::Exact_map<3>>& surfaces, const Rational_motion_3& motion,
                   const std::array<Exact_rational, 3>& point, const Solver_options& options)
{
  Common::Operation_budget budget(options);
  const Solid_boundary solid = solid_boundary_of(surfaces, "swept volume");
  has_positive_maps(motion, "swept volume"); // or else it throws
  return Sweep_membership(solid, motion, budget).intervals(point);
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_OF_H
