// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_POINTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_operand.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// All common points of two operands by closed forms; nothing where there are none for them, or where these do not
// decide everything. Defined in Elementary_finder.h.
template <int d>
std::optional<Elementary_points<d>> elementary_points(const Elementary_operand<d>& first,
                                                      const Elementary_operand<d>& second);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template std::optional<Elementary_points<2>> elementary_points<2>(const Elementary_operand<2>&,
                                                                         const Elementary_operand<2>&);
extern template std::optional<Elementary_points<3>> elementary_points<3>(const Elementary_operand<3>&,
                                                                         const Elementary_operand<3>&);
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_POINTS_H
