// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_CURVE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_CURVE_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The parameters inside of a piece, in order, where its derivative is zero, as in a cusp or where it turns back, if
// they are rational with short fractions.
inline std::vector<Exact_rational> rational_stops(const Homogeneous_piece& piece)
{
  const auto& [x, y, w] = piece.coordinates;
  const std::array<Bernstein_tensor<Exact_rational>, 2> d{x.derivative(0) * w - x * w.derivative(0),
                                                          y.derivative(0) * w - y * w.derivative(0)};
  const auto has_sign = [](const auto& f) {
    return std::ranges::all_of(f.coefficients(), [](const auto& c) { return c > 0; }) ||
        std::ranges::all_of(f.coefficients(), [](const auto& c) { return c < 0; });
  };
  if (has_sign(d[0]) || has_sign(d[1]))
    return {};
  const bool is_vertical = std::ranges::all_of(d[0].coefficients(), [](const auto& c) { return c == 0; });
  std::vector<Exact_rational> result;
  for (const Exact_root& root : inner_roots(d[is_vertical], power_of_two(-16)))
    if (const std::array<Exact_rational, 1> u{root.lower()}; root.is_point() && d[!is_vertical](u) == 0)
      result.push_back(Exact_rational(piece.domain.first + u[0] * (piece.domain.second - piece.domain.first)));
  return result;
}

// The pieces of a curve, cut where it stops.
inline std::vector<Homogeneous_piece> pieces_between_stops(const Operand_curve_2& curve)
{
  std::vector<Homogeneous_piece> result;
  for (const Homogeneous_piece& piece : homogeneous_pieces(curve, Planar_map(curve))) {
    Parameter_range rest = piece.domain;
    for (const Exact_rational& stop : rational_stops(piece)) {
      result.push_back(piece.within({rest.first, stop}));
      rest.first = stop;
    }
    result.push_back(piece.within(rest));
  }
  return result;
}

// A curve that is a site. Where it stops it has a break.
struct Site_curve_2
{
  Spline_patch<2> patch;
  std::vector<Homogeneous_piece> pieces;

  explicit Site_curve_2(const Operand_curve_2& curve) : patch(curve), pieces(pieces_between_stops(curve))
  {
    const std::vector<Exact_rational> breaks = patch.breaks(0);
    for (const Homogeneous_piece& piece : pieces)
      if (!std::binary_search(breaks.begin(), breaks.end(), piece.domain.second))
        patch = patch.with_break(0, piece.domain.second);
  }
};

inline std::vector<Site_curve_2> site_curves(const std::vector<Operand_curve_2>& curves,
                                             Search_control* control = nullptr)
{
  Regular_check check(control, 1);
  std::vector<Site_curve_2> result;
  for (const Operand_curve_2& curve : curves) {
    check();
    result.emplace_back(curve);
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_CURVE_2_H
