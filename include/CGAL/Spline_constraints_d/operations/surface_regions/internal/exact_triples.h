// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_EXACT_TRIPLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_EXACT_TRIPLES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

inline Exact_rational dot(const Exact_triple& a, const Exact_triple& b)
{
  return Exact_rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

inline Exact_triple cross(const Exact_triple& a, const Exact_triple& b)
{
  return {Exact_rational(a[1] * b[2] - a[2] * b[1]), Exact_rational(a[2] * b[0] - a[0] * b[2]),
          Exact_rational(a[0] * b[1] - a[1] * b[0])};
}

inline Exact_triple difference(const Exact_triple& a, const Exact_triple& b)
{
  return {Exact_rational(a[0] - b[0]), Exact_rational(a[1] - b[1]), Exact_rational(a[2] - b[2])};
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_EXACT_TRIPLES_H
