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
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/Swept_volume_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/Cell_labels.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/Sweep_membership.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Boundary_of_cells.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Shell_samples.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/cut_triangles.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Sweep_sheets.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/swept_volume_finders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Where nothing was found of the envelope. Where the surface moves along itself, it has none.
inline std::vector<Undecided_part> undecided_of_sheets(const Envelope_surface_3& envelope)
{
  std::vector<Undecided_part> result = envelope.undecided();
  std::erase_if(result, [](const auto& part) { return part.reason == Envelope_surfaces::moves_along_itself; });
  return result;
}

// Whether the maps of a motion keep orientations. \throws Invalid_input when it is not proved that they are invertible.
inline bool has_positive_maps(const Rational_motion_3& motion)
{
  const auto& c = motion.columns();
  const auto minor = [&](std::size_t i, std::size_t k) { return c[1][i] * c[2][k] - c[1][k] * c[2][i]; };
  const auto determinant = c[0][0] * minor(1, 2) + c[0][1] * minor(2, 0) + c[0][2] * minor(0, 1);
  try {
    return certified_weight_sign(determinant, {}) > 0;
  } catch (const Invalid_input&) {
    throw Invalid_input("swept volume: it is not proved that the maps of the motion are invertible at all times");
  }
}

// The boundary as triangles that cross each other; the cells that these cut space into; which of them are swept; the
// triangles between those that are and those that are not.
CGAL_SPLINE_CONSTRAINTS_INLINE Swept_volume_3 swept_volume_of(const Common::Exact_map<3>& surface,
                                                              const Rational_motion_3& motion,
                                                              const Surface_mesh_options& fineness,
                                                              const Solver_options& options)
{
  if (!(fineness.chord_error > 0 && std::isfinite(fineness.chord_error)))
    throw Invalid_input("swept_volume: the chord error must be positive and finite");
  Common::Operation_budget budget(options);
  const Common::Spline_patch<3> patch(surface);
  check_closed(patch);
  Sweep_membership membership(patch, motion, budget);
  double error = fineness.chord_error;
  Boundary_of_cells::Mesh mesh;
  std::vector<Thin_cell> thin_cells;
  std::vector<Undecided_part> undecided;
  const auto add_undecided = [&](const auto& parts) { undecided.insert(undecided.end(), parts.begin(), parts.end()); };

  const std::optional<bool> has_outer_normals = membership.has_outer_normals(has_positive_maps(motion));
  if (!has_outer_normals)
    undecided.push_back({{}, {}, "on which side of the surface the solid lies"});
  const Envelope_surface_3 envelope = Envelope_surfaces::sweep_envelope_of(surface, motion, budget.remaining(), false);
  budget.add(envelope.summary());
  add_undecided(undecided_of_sheets(envelope));
  if (has_outer_normals && !budget.must_stop()) {
    Sweep_sheets sheets(patch, motion, *has_outer_normals, envelope, fineness, budget);
    add_undecided(sheets.undecided());
    error = (std::max)(error, sheets.error());
    if (const auto complex = triangle_complex_of(sheets.soup(), [&] { return budget.must_stop(); })) {
      const Triangle_shells shells(*complex);
      if (!shells.is_closed())
        undecided.push_back({{}, {}, "the triangles do not bound cells"});
      const Cell_labels labels(*complex, shells, fineness.chord_error, membership);
      add_undecided(labels.undecided());
      thin_cells = labels.thin_cells();
      mesh = Boundary_of_cells(*complex, shells, labels.is_inside())();
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
sweep_intervals_of(const Common::Exact_map<3>& surface, const Rational_motion_3& motion,
                   const std::array<Exact_rational, 3>& point, const Solver_options& options)
{
  Common::Operation_budget budget(options);
  const Common::Spline_patch<3> patch(surface);
  check_closed(patch);
  has_positive_maps(motion); // or else it throws
  return Sweep_membership(patch, motion, budget).intervals(point);
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_OF_H
