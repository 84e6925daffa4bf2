// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_RATIONAL_OFFSET_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_RATIONAL_OFFSET_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/spline_cells.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/unit_normal_of_piece.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The continuous surface with these pieces on the cells of a grid, in row-major order, each of which may be multiplied by
a constant: that which makes it fit the one before. None if their homogeneous coordinates do not fit.
*/
std::optional<Bspline_surface_3<Exact_kernel>> joined_surface(std::vector<Homogeneous_polynomials> pieces,
                                                              const std::array<std::vector<Exact_rational>, 2>& breaks);

/*
The surface whose pieces `change(piece, unit normal)` makes of those of a surface that has a rational unit normal, in
the lowest degree if they fit together then.
*/
template <class Change>
std::optional<Bspline_surface_3<Exact_kernel>> surface_of_unit_normals(const Bspline_surface_3<Exact_kernel>& surface,
                                                                       const Change& change)
{
  const auto numerators = surface.homogeneous_coordinates();
  const std::array<std::vector<Bernstein_tensor<Exact_rational>>, 3> coordinates{
      numerators[0].bezier_pieces(), numerators[1].bezier_pieces(), numerators[2].bezier_pieces()};
  const auto weights = surface.is_rational()
      ? surface.weight().bezier_pieces()
      : std::vector(coordinates[0].size(), Bernstein_tensor<Exact_rational>::constant(2, Exact_rational(1)));
  std::vector<Homogeneous_polynomials> pieces, simpler;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    Homogeneous_polynomials piece;
    for (const auto& coordinate : coordinates)
      piece.push_back(polynomial_of(coordinate[c]));
    piece.push_back(polynomial_of(weights[c]));
    const std::optional<Unit_normal> normal = unit_normal(piece);
    if (!normal)
      return std::nullopt;
    pieces.push_back(change(piece, *normal));
    simpler.push_back(without_common_factors(pieces.back()));
  }
  const std::array<std::vector<Exact_rational>, 2> breaks{surface.breaks(0), surface.breaks(1)};
  if (auto result = joined_surface(std::move(simpler), breaks))
    return result;
  return joined_surface(std::move(pieces), breaks);
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Bspline_surface_3<Exact_kernel>>
joined_surface(std::vector<Homogeneous_polynomials> pieces, const std::array<std::vector<Exact_rational>, 2>& breaks)
{
  const std::size_t columns = breaks[1].size() - 1;
  for (std::size_t c = 1; c < pieces.size(); ++c) {
    const bool is_first_in_row = c % columns == 0;
    const Homogeneous_polynomials& before = pieces[is_first_in_row ? c - columns : c - 1];
    const Exact_rational weight = value_at(pieces[c][3], 0, 0),
                         weight_before = is_first_in_row ? value_at(before[3], 1, 0) : value_at(before[3], 0, 1);
    if (weight == 0)
      return std::nullopt;
    const Exact_rational factor(weight_before / weight);
    for (Power_polynomial& f : pieces[c])
      f *= Power_polynomial(factor);
  }
  std::vector<int> degrees(2, 1);
  for (const Homogeneous_polynomials& piece : pieces)
    for (const Power_polynomial& f : piece)
      for (const int axis : {0, 1})
        degrees[axis] = (std::max)(degrees[axis], f.degree(axis));
  Break_grid<Exact_rational> grid(2);
  for (const int axis : {0, 1})
    for (const Exact_rational& t : breaks[axis])
      grid[axis].push_back({t, degrees[axis]});
  std::array<Bspline_function<Exact_rational>, 4> coordinates;
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<Bernstein_tensor<Exact_rational>> tensors;
    for (const Homogeneous_polynomials& piece : pieces)
      tensors.push_back(tensor_of(piece[i], degrees));
    auto [axes, control_points] = assembled_cells(degrees, grid, tensors);
    coordinates[i] = Bspline_function<Exact_rational>::on_axes(std::move(axes), std::move(control_points));
    if (coordinates[i].bezier_pieces() != tensors)
      return std::nullopt;
  }
  return Bspline_surface_3<Exact_kernel>::from_homogeneous_coordinates({coordinates[0], coordinates[1], coordinates[2]},
                                                                       coordinates[3]);
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

the unit normal of a surface as a rational function of its parameters, exactly, where it is one; points stand for the
vectors from the origin to them. So it is where on each piece the squared length of the normal is the square of a
polynomial with rational coefficients, up to squares: for spheres, cylinders and tori as functions of this package make
them, for cones whose angle has a rational sine and cosine, Dupin cyclides, canal surfaces, planes with a rational unit
normal, and other surfaces with a Pythagorean normal. Otherwise, or if common factors are not found by
`common_factor()`, or the normal is not continuous, nothing.

Factors that all coordinates of \f$S_u \times S_v\f$ have in common are divided out, so that poles of spheres and tips
of cones have normals, too. The normal is on the side of \f$S_u \times S_v\f$ in the middle of each piece, and on the
other side where such a factor has another sign: beyond the tip of a double cone.

\tparam Kernel a `SplineKernel`.
\throws Invalid_input when the weight is not proved to have one sign.

Complexity: greatest common divisors of polynomials of three times the degrees, for each piece of the surface; one
evaluation, if the length of the normal in one point is not rational.

Source: Pottmann, Rational curves and surfaces with rational offsets, 1995.
*/
template <SplineKernel Kernel>
std::optional<Bspline_surface_3<CGAL::Simple_cartesian<Exact_rational>>>
rational_unit_normal(const Bspline_surface_3<Kernel>& surface)
{
  return internal::surface_of_unit_normals(
      Bspline_surface_3<internal::Exact_kernel>(surface),
      [](const internal::Homogeneous_polynomials&, const internal::Unit_normal& normal) {
        return internal::Homogeneous_polynomials{normal.direction[0], normal.direction[1], normal.direction[2],
                                                 normal.length};
      });
}

/*!
\ingroup PkgSplineConstraintsDGeometry

the offset of a surface at a signed distance along its `rational_unit_normal()`, as a rational surface with the same
parameters, exactly, where there is one. Its degrees are as low as common factors of homogeneous coordinates allow, if
the pieces then fit together.

\tparam Kernel a `SplineKernel`.
\throws Invalid_input as `rational_unit_normal()`, and when the distance is not finite.

Complexity: that of `rational_unit_normal()`.
*/
template <SplineKernel Kernel>
std::optional<Bspline_surface_3<CGAL::Simple_cartesian<Exact_rational>>>
rational_offset(const Bspline_surface_3<Kernel>& surface, const typename Kernel::FT& distance)
{
  const auto step = internal::converted_number<Exact_rational>(distance);
  return internal::surface_of_unit_normals(
      Bspline_surface_3<internal::Exact_kernel>(surface),
      [&](const internal::Homogeneous_polynomials& piece, const internal::Unit_normal& normal) {
        return internal::piece_at_distance(piece, normal, step);
      });
}

//! \ingroup PkgSplineConstraintsDGeometry
//! an offset as a rational surface, as above. All that is known of rational surfaces can be done with it, also what is
//! not supported for `Offset_surface_3`.
inline std::optional<Bspline_surface_3<CGAL::Simple_cartesian<Exact_rational>>>
rational_offset(const Offset_surface_3& offset)
{
  return rational_offset(offset.rational_surface(), offset.distance());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_RATIONAL_OFFSET_H
