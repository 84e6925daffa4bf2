// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_HEALED_SPLINES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_HEALED_SPLINES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/healing/Primitive_kind.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

template <class Spline>
struct Healed_spline
{
  Spline spline;
  Primitive_kind kind = Primitive_kind::UNDECIDED;
  double displacement = 0;

  bool is_done() const { return kind != Primitive_kind::UNDECIDED; }
};

// Curves in d-space, and surfaces, if that is space, in the order of those that were given; and the system of
// coordinates in which their numbers are simplest: its axes and origin.
template <int d>
struct Healed_splines
{
  std::vector<Healed_spline<Bspline_curve<Exact_kernel, d>>> curves;
  std::vector<Healed_spline<Bspline_surface_3<Exact_kernel>>> surfaces;
  std::array<Exact_kernel::Vector_3, 3> axes;
  Exact_kernel::Point_3 origin;
};

// Defined in Primitive_healer.h.
Healed_splines<2> healed_splines(std::vector<Bspline_curve<Exact_kernel, 2>> curves, double tolerance,
                                 Run_control& control);
Healed_splines<3> healed_splines(std::vector<Bspline_curve<Exact_kernel, 3>> curves,
                                 std::vector<Bspline_surface_3<Exact_kernel>> surfaces, double tolerance,
                                 Run_control& control);

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_HEALED_SPLINES_H
