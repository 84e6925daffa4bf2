// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SMOOTH_NORMALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SMOOTH_NORMALS_H

#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/unit_normal_of_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// A polynomial on the unit square, as a function on a cell.
inline Exact_function function_on_cell(const Power_polynomial& f, const Spline_patch<3>& cell)
{
  const std::vector<int> degrees{f.degree(0), f.degree(1)};
  std::vector<std::vector<Exact_rational>> knots;
  for (const int axis : {0, 1}) {
    const auto [begin, end] = cell.domain(axis);
    knots.emplace_back(static_cast<std::size_t>(degrees[static_cast<std::size_t>(axis)]) + 1, begin);
    knots.back().resize(2 * knots.back().size(), end);
  }
  return Exact_function(degrees, std::move(knots), tensor_of(f, degrees).coefficients());
}

inline Homogeneous_polynomials polynomials_of(const Spline_patch<3>& cell)
{
  const auto piece = [](const Exact_function& f) { return polynomial_of(f.bezier_pieces().front()); };
  const auto& [x, y, z] = cell.numerators();
  return {piece(x), piece(y), piece(z), cell.is_rational() ? piece(cell.weight()) : Power_polynomial(1)};
}

/*
The normals of a surface, on the side of S_u x S_v, in the lowest degree: what their coordinates have in common on a
cell is divided out, so that they do not vanish at poles and tips. They are continuous on each part that is returned.
Before each cell `check()` may end the work by an exception.
*/
template <class Check>
std::vector<Continuous_part<3>> smooth_normals(const Spline_patch<3>& patch, const Check& check)
{
  const auto normal = [&](const Spline_patch<3>& cell) {
    check();
    std::vector<Power_polynomial> result = normal_of(polynomials_of(cell));
    if (std::any_of(result.begin(), result.end(), [](const Power_polynomial& f) { return !f.is_zero(); }))
      result = oriented_normal(result);
    return Vector_of_functions<3>{function_on_cell(result[0], cell), function_on_cell(result[1], cell),
                                  function_on_cell(result[2], cell)};
  };
  return continuous_parts(Cell_functions<3>(patch, normal), true);
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SMOOTH_NORMALS_H
