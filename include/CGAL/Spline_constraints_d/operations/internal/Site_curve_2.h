// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SITE_CURVE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SITE_CURVE_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_patch.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A curve that is a site, whatever its type.
struct Site_curve_2
{
  Spline_patch<2> patch;
  std::vector<Homogeneous_piece> pieces;

  template <ParametricCurve_2 Curve>
  explicit Site_curve_2(const Curve& curve) : patch(curve), pieces(homogeneous_pieces(curve, Planar_map(curve)))
  {}
};

template <class Curves>
std::vector<Site_curve_2> site_curves(const Curves& curves)
{
  std::vector<Site_curve_2> result;
  for (const auto& curve : curves)
    result.emplace_back(curve);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SITE_CURVE_2_H
