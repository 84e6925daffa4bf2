// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_UNDECIDED_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_UNDECIDED_CURVES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// A box where nothing is proved.
inline Curve_solution_set_d undecided_curves(Curve_vertex::Exact_box box, Undecided_reason reason)
{
  Summary summary;
  summary.is_complete = false;
  return Curve_solution_set_d({}, {}, {}, {}, {{{std::move(box)}, {}, reason}}, summary);
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_UNDECIDED_CURVES_H
