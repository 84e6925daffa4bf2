// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_POWERS_OF_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_POWERS_OF_ZEROS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Along the zeros of a polynomial p(a,b) next to a = b = 0, for positive a and b, powers a = s^m and b = t^n for which s
and t are nearly proportional: those of the edge of the Newton polygon whose ends have different signs; nothing if there
is no such edge, or are several of them.
*/
inline std::optional<std::pair<int, int>> powers_of_zeros(const Power_polynomial& p)
{
  struct Corner
  {
    int a, b, sign;
  };
  std::map<int, Corner> lowest;   // by the exponent of b, the term with the least one of a
  for (const auto& [monomial, coefficient] : p.terms()) {
    const Corner corner{monomial.exponent(0), monomial.exponent(1), sign_of(coefficient)};
    const auto [position, is_new] = lowest.emplace(corner.b, corner);
    if (!is_new && corner.a < position->second.a)
      position->second = corner;
  }
  std::vector<Corner> hull;   // from the least exponent of b to the least one of a
  for (const auto& [exponent, corner] : lowest) {
    if (!hull.empty() && corner.a >= hull.back().a)
      continue;
    const auto is_above = [&](const Corner& first, const Corner& middle) {
      return (first.a - middle.a) * (corner.b - first.b) <= (first.a - corner.a) * (middle.b - first.b);
    };
    while (hull.size() > 1 && is_above(hull[hull.size() - 2], hull.back()))
      hull.pop_back();
    hull.push_back(corner);
  }
  std::optional<std::pair<int, int>> result;
  for (std::size_t i = 1; i < hull.size(); ++i)
    if (const int a = hull[i - 1].a - hull[i].a, b = hull[i].b - hull[i - 1].b, divisor = std::gcd(a, b);
        hull[i - 1].sign != hull[i].sign) {
      if (result)
        return std::nullopt;
      result.emplace(b / divisor, a / divisor);
    }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_POWERS_OF_ZEROS_H
