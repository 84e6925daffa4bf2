// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SURFACE_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SURFACE_CELLS_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/cell_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

using Cell_vector = std::array<Cell_polynomial, 3>;

inline Cell_polynomial dot(const Cell_vector& a, const Cell_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Cell_vector cross(const Cell_vector& a, const Cell_vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Cell_vector operator*(const Cell_polynomial& f, const Cell_vector& a) { return {f * a[0], f * a[1], f * a[2]}; }

inline Cell_vector operator+(const Cell_vector& a, const Cell_vector& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Cell_vector operator-(const Cell_vector& a, const Cell_vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Cell_vector constant_vector(const std::array<Exact_rational, 3>& v)
{
  return {Cell_polynomial::constant(2, v[0]), Cell_polynomial::constant(2, v[1]), Cell_polynomial::constant(2, v[2])};
}

// The vector times a polynomial.
inline Cell_vector operator*(const std::array<Exact_rational, 3>& v, const Cell_polynomial& f)
{
  return {f * v[0], f * v[1], f * v[2]};
}

inline Cell_vector numerators_of(const Surface_cell_3& cell)
{
  return {cell.coordinates[0], cell.coordinates[1], cell.coordinates[2]};
}

inline std::array<Exact_rational, 3> value_of(const Cell_vector& f, const Parameters& local)
{
  return {f[0](local), f[1](local), f[2](local)};
}

// The polynomial pieces of a surface, with positive weights.
inline std::vector<Surface_cell_3> cells_of(const Spline_patch<3>& surface)
{
  const std::array<std::vector<Exact_rational>, 2> breaks{surface.breaks(0), surface.breaks(1)};
  std::vector<Surface_cell_3> result;
  for (std::size_t i = 1; i < breaks[0].size(); ++i)
    for (std::size_t j = 1; j < breaks[1].size(); ++j) {
      const Surface_cell_3::Range u(breaks[0][i - 1], breaks[0][i]), v(breaks[1][j - 1], breaks[1][j]);
      const Spline_patch<3> part = surface.part({u, v});
      const auto piece = [](const Exact_function& f) { return f.bezier_pieces().front(); };
      const auto& [x, y, z] = part.numerators();
      result.push_back({{u, v}, {piece(x), piece(y), piece(z), piece(part.weight())}});
    }
  return result;
}

// In the lowest degrees.
inline std::vector<Cell_polynomial> tensors_of(const std::vector<Power_polynomial>& polynomials)
{
  std::vector<int> degrees{0, 0};
  for (const Power_polynomial& f : polynomials)
    for (const auto& [monomial, coefficient] : f.terms())
      for (const int axis : {0, 1})
        degrees[static_cast<std::size_t>(axis)] =
            (std::max)(degrees[static_cast<std::size_t>(axis)], static_cast<int>(monomial.exponent(axis)));
  std::vector<Cell_polynomial> result;
  for (const Power_polynomial& f : polynomials)
    result.push_back(tensor_of(f, degrees));
  return result;
}

// A polynomial without the factors that it has in common with one that has no zeros.
inline Cell_polynomial without_factors_of(const Cell_polynomial& weight, const Cell_polynomial& f)
{
  if (is_zero(f) || (weight.degree(0) == 0 && weight.degree(1) == 0))
    return f;
  Power_polynomial rest = polynomial_of(f);
  const Power_polynomial own = polynomial_of(weight);
  while (const auto common = common_factor({rest, own}))
    rest = common->cofactors[0];
  return tensors_of({rest}).front();
}

// A positive multiple of a vector, in lower degrees if the coordinates have factors in common: those that vanish on
// sides of the unit box only, and those that are proved to have one sign.
inline Cell_vector without_positive_factors(Cell_vector f)
{
  if (std::ranges::all_of(f, is_zero))
    return f;
  for (const int axis : {0, 1})
    for (const int side : {0, 1}) {
      const auto vanishes = [&](const Cell_polynomial& x) { return is_zero(x) || is_zero(x.face(axis, side)); };
      while (std::ranges::all_of(f, vanishes))
        for (Cell_polynomial& x : f)
          if (!is_zero(x))
            x = divided_by_side(x, axis, side);
    }
  std::vector<Power_polynomial> powers;
  for (const Cell_polynomial& x : f)
    powers.push_back(polynomial_of(x));
  while (const auto common = common_factor(powers)) {
    int sign = 0;
    try {
      sign = certified_weight_sign(tensors_of({common->factor}).front(), {.maximal_depth = 8, .maximal_parts = 200});
    } catch (const Invalid_input&) {
      break;
    }
    powers = common->cofactors;
    if (sign < 0)
      for (Power_polynomial& x : powers)
        x = -x;
  }
  const std::vector<Cell_polynomial> result = tensors_of(powers);
  return {result[0], result[1], result[2]};
}

// A positive multiple of the normal of X/w with w > 0, by the derivatives along the axes.
inline Cell_vector normal_of(const Surface_cell_3& cell)
{
  const Cell_vector x = numerators_of(cell);
  const Cell_polynomial& w = cell.coordinates[3];
  const auto derivative = [&](int axis) {
    return Cell_vector{x[0].derivative(axis), x[1].derivative(axis), x[2].derivative(axis)};
  };
  const Cell_vector along_u = derivative(0), along_v = derivative(1);
  return without_positive_factors(w * cross(along_u, along_v) + w.derivative(0) * cross(along_v, x) +
                                  w.derivative(1) * cross(x, along_u));
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SURFACE_CELLS_H
