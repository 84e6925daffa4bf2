// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CONTROL_POINTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CONTROL_POINTS_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The control points of a piece of a curve and their weights.
class Control_points_2
{
  std::array<std::vector<Exact_rational>, 3> m_coefficients;

public:
  explicit Control_points_2(const Homogeneous_piece& piece)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      const Bernstein_tensor<Exact_rational>& f = piece.coordinates[k];
      m_coefficients[k] = (f.degree(0) < piece.degree() ? f.elevated({piece.degree()}) : f).coefficients();
    }
  }

  std::size_t size() const { return m_coefficients[2].size(); }
  const Exact_rational& weight(std::size_t i) const { return m_coefficients[2][i]; }
  Exact_pair point(std::size_t i) const
  {
    return {Exact_rational(m_coefficients[0][i] / weight(i)), Exact_rational(m_coefficients[1][i] / weight(i))};
  }
};

// Whether an affine map takes a piece to another one, or to itself, with the parameter 1 - t or t: it does so with
// their control points.
template <class Map>
bool is_image(const Homogeneous_piece& a, const Map& map, const Homogeneous_piece& b, bool is_reversed)
{
  if (a.degree() != b.degree())
    return false;
  const Control_points_2 p(a), q(b);
  const std::size_t last = p.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t j = is_reversed ? last - i : i, first = is_reversed ? last : 0;
    if (p.weight(i) * q.weight(first) != q.weight(j) * p.weight(0) || map(p.point(i)) != q.point(j))
      return false;
  }
  return true;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CONTROL_POINTS_2_H
