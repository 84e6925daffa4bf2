// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_PART_WITH_NORMALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_PART_WITH_NORMALS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// Bounds of a function with positive values, of which the lower one is at least half of a value; none if it is not
// proved to be positive after some steps.
inline std::optional<Parameter_range> positive_bounds(const Exact_function& function)
{
  using Tensor = Bernstein_tensor<Exact_rational>;
  struct Piece
  {
    Tensor values;
    Exact_rational least;
    int axis;
  };
  constexpr int most_steps = 256;
  Parameter_range result{Exact_rational(0), Exact_rational(0)};
  std::optional<Exact_rational> least_value; // of those known
  std::vector<Piece> pieces;                 // a heap, that with the lowest bound first
  const auto is_higher = [](const Piece& a, const Piece& b) { return b.least < a.least; };
  const auto add = [&](Tensor values, int axis) {
    const Exact_rational least = values.bounds().first, value = values.coefficients().front();
    if (!least_value || value < *least_value)
      least_value = value;
    pieces.push_back({std::move(values), least, axis});
    std::push_heap(pieces.begin(), pieces.end(), is_higher);
  };
  for (Tensor& piece : function.bezier_pieces()) {
    result.second = (std::max)(result.second, piece.bounds().second);
    add(std::move(piece), 0);
  }
  for (int step = 0; step<most_steps&& * least_value> 0; ++step) {
    result.first = pieces.front().least;
    if (result.first > 0 && 2 * result.first >= *least_value)
      return result;
    std::pop_heap(pieces.begin(), pieces.end(), is_higher);
    const Piece piece = std::move(pieces.back());
    pieces.pop_back();
    std::pair<Tensor, Tensor> halves = piece.values.split(piece.axis, Exact_rational(1) / 2);
    add(std::move(halves.first), 1 - piece.axis);
    add(std::move(halves.second), 1 - piece.axis);
  }
  return result.first > 0 ? std::optional(result) : std::nullopt;
}

// Rational numbers below and above the root of a positive number.
inline Parameter_range root_bounds(const Exact_rational& square)
{
  const Exact_rational near = Exact_rational(1) / near_inverse_root(square);
  Parameter_range result{near, near};
  while (result.first * result.first >= square)
    result.first *= Exact_rational(15) / 16;
  while (result.second * result.second <= square)
    result.second *= Exact_rational(17) / 16;
  return result;
}

// A smooth part of a surface S(u, v) with normals n(u, v) / w(u, v) that are not longer than about one. The weight w is
// that of the surface: so normals of planes, and of most spheres, cylinders, cones and tori are unit vectors.
class Part_with_normals
{
  Smooth_surface m_surface;
  Parameter_range m_squares; // bounds of |n / w|^2
  bool m_is_unit;

  Part_with_normals(Smooth_surface surface, Parameter_range squares, bool is_unit)
    : m_surface(std::move(surface)), m_squares(std::move(squares)), m_is_unit(is_unit)
  {}

public:
  // None if the normals are not proved to be different from zero.
  static std::optional<Part_with_normals> make(Smooth_surface surface)
  {
    Vector_of_functions<3>& n = surface.normal;
    const Exact_function square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2],
                         weight = surface.patch.weight() * surface.patch.weight();
    const std::vector<Exact_rational> corner = surface.patch.first_corner();
    const Exact_rational ratio = square(corner) / weight(corner);
    std::optional<Parameter_range> squares = Parameter_range(ratio, ratio);
    bool is_unit = ratio > 0 && square == weight * ratio && rational_square_root(ratio);
    if (!is_unit) {
      squares = positive_bounds(square);
      const std::optional<Parameter_range> of_weight = positive_bounds(weight);
      if (!squares || !of_weight)
        return std::nullopt;
      squares = {squares->first / of_weight->second, squares->second / of_weight->first};
    }
    const Exact_rational scale = near_inverse_root(squares->second), factor = scale * scale;
    for (Exact_function& coordinate : n)
      coordinate = coordinate * scale;
    return Part_with_normals(std::move(surface), {squares->first * factor, squares->second * factor}, is_unit);
  }

  const Smooth_surface& surface() const { return m_surface; }

  Vector_expression<3> point(std::span<const Unknown> u) const { return Parametric_vector<3>(m_surface.patch)(u); }
  Vector_expression<3> normal(std::span<const Unknown> u) const
  {
    return Parametric_vector<3>(m_surface.patch.with_numerators(m_surface.normal))(u);
  }

  // Whether all normals are unit vectors.
  bool has_unit_normals() const { return m_is_unit; }

  // Numbers below and above the lengths of all normals.
  Parameter_range lengths() const { return {root_bounds(m_squares.first).first, root_bounds(m_squares.second).second}; }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_PART_WITH_NORMALS_H
