// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_FINDERS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Touched_sides.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Trimmed_envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// Why there is no envelope of a part of a surface.
inline constexpr const char* moves_along_itself = "the surface moves along itself";

// What an envelope of a moving surface is for: itself, with its cuspidal edges; or to bound what is swept, with the
// positions at the ends of all parts of the motion, which are left out where they touch the envelope everywhere.
enum class Envelope_use
{
  SURFACE,
  BOUNDARY
};

// Defined in the header of each operation in this folder; the compiled library has them.
Envelope_surface_3 sweep_envelope_of(const Exact_map<3>& surface, const Rational_motion_3& motion,
                                     const Solver_options& options, Envelope_use use = Envelope_use::SURFACE);
Envelope_surface_3 offset_surface_of(const Exact_map<3>& surface, const Exact_rational& distance,
                                     const Solver_options& options);
Envelope_surface_3 envelope_surface_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                       const Solver_options& options);
Envelope_surface_3 curve_surface_bisector_of(const Exact_map<3>& curve, const Exact_map<3>& surface,
                                             const Exact_rational& radius, const Solver_options& options);
Envelope_surface_3 surface_bisector_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                       const Exact_rational& radius, const Touched_sides& sides,
                                       const Solver_options& options);
Envelope_surface_3 alpha_sector_surface_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                           const Exact_rational& alpha, const Touched_sides& sides,
                                           const Solver_options& options);

Trimmed_envelope_surface_3 trimmed_surface_bisector_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                                       const Exact_rational& radius, const Touched_sides& sides,
                                                       const Solver_options& options);
Trimmed_envelope_surface_3 trimmed_curve_surface_bisector_of(const Exact_map<3>& curve, const Exact_map<3>& surface,
                                                             const Exact_rational& radius,
                                                             const Solver_options& options);
Trimmed_envelope_surface_3 trimmed_alpha_sector_surface_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                                           const Exact_rational& alpha, const Touched_sides& sides,
                                                           const Solver_options& options);

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_FINDERS_H
