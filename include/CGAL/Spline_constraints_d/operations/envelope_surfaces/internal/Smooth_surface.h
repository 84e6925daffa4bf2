// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SMOOTH_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SMOOTH_SURFACE_H

#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/unit_normal_of_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
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

// A part of a surface with a continuous field of normals, on the side of S_u x S_v.
struct Smooth_surface
{
  Spline_patch<3> patch;
  Vector_of_functions<3> normal; // of any length
  std::array<std::vector<Exact_rational>, 2> breaks;
  std::array<bool, 2> is_closed; // both ends of an axis: the same points with the same normals

  bool is_degenerate() const
  {
    return std::all_of(normal.begin(), normal.end(), [](const Exact_function& f) {
      return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                         [](const Exact_rational& x) { return x == 0; });
    });
  }

  std::vector<int> closed_axes() const
  {
    std::vector<int> result;
    for (const int axis : {0, 1})
      if (is_closed[static_cast<std::size_t>(axis)])
        result.push_back(axis);
    return result;
  }

  // Whether the direction of the normal is the same along a line of constant u or v.
  bool has_one_normal(const Constant_parameter& line) const
  {
    const Vector_of_functions<3> n = part_of<3>(normal, line.axis, {line.value, line.value});
    const std::array<Exact_rational, 1> begin{n[0].domain(0).first};
    const std::array<Exact_rational, 3> own{n[0](begin), n[1](begin), n[2](begin)};
    const auto is_zero = [](const Exact_function& f) {
      return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                         [](const Exact_rational& x) { return x == 0; });
    };
    return is_zero(n[0] * own[1] - n[1] * own[0]) && is_zero(n[1] * own[2] - n[2] * own[1]) &&
        is_zero(n[2] * own[0] - n[0] * own[2]) && (own[0] != 0 || own[1] != 0 || own[2] != 0);
  }

  // The edges that are one point with one tangent plane.
  std::vector<Constant_parameter> poles() const
  {
    std::vector<Constant_parameter> result;
    for (const int axis : {0, 1})
      for (const Exact_rational& value : {patch.domain(axis).first, patch.domain(axis).second})
        if (patch.pole(axis, value) && has_one_normal({axis, value}))
          result.push_back({axis, value});
    return result;
  }
};

// Of two parts, the parameters of the first one before those of the second: those with the same points at both ends.
inline std::vector<int> closed_unknowns(const Smooth_surface& first, const Smooth_surface& second)
{
  std::vector<int> result = first.closed_axes();
  for (const int axis : second.closed_axes())
    result.push_back(axis + 2);
  return result;
}

// The edges of both that are one point.
inline std::vector<Envelope_pole> poles(const Smooth_surface& first, const Smooth_surface& second)
{
  std::vector<Envelope_pole> result;
  for (const Constant_parameter& pole : first.poles())
    result.push_back({pole.axis, pole.value, true});
  for (const Constant_parameter& pole : second.poles())
    result.push_back({pole.axis + 2, pole.value, true});
  return result;
}

/*
The parts of a surface on which normals are continuous. These are in the lowest degree: what their coordinates have in
common on a cell is divided out, so that they do not vanish at poles and tips. Before each cell `check()` may end the
work by an exception.
*/
inline std::vector<Smooth_surface> smooth_surfaces(const Spline_patch<3>& patch, const std::function<void()>& check)
{
  const auto normal = [&](const Spline_patch<3>& cell) {
    check();
    std::vector<Power_polynomial> result = normal_of(polynomials_of(cell));
    if (std::any_of(result.begin(), result.end(), [](const Power_polynomial& f) { return !f.is_zero(); }))
      result = oriented_normal(result);
    return Vector_of_functions<3>{function_on_cell(result[0], cell), function_on_cell(result[1], cell),
                                  function_on_cell(result[2], cell)};
  };
  std::vector<Smooth_surface> result;
  for (const Continuous_part<3>& part : continuous_parts(Cell_functions<3>(patch, normal), true)) {
    const Cell_functions<3>& own = part.functions;
    const auto is_closed = [&](int axis) {
      const auto ratio = own.ratio(axis, own.size(axis) - 1, 0);
      return own.domain(axis) == patch.domain(axis) && patch.is_closed(axis) && ratio && *ratio > 0;
    };
    result.push_back({patch.part({own.domain(0), own.domain(1)}),
                      own.splines(),
                      {own.breaks(0), own.breaks(1)},
                      {is_closed(0), is_closed(1)}});
  }
  return result;
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SMOOTH_SURFACE_H
