// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_OFFSET_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_OFFSET_SURFACE_3_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

The offset of a surface: the points \f$S(u,v) + r\,N/|N|\f$ with the normal \f$N = S_u \times S_v\f$, at the signed
distance \f$r\f$, on the side of \f$N\f$ if \f$r > 0\f$.

A point \f$P\f$ is on it when \f$\langle P - S, S_u\rangle = \langle P - S, S_v\rangle = 0\f$, \f$|P-S|^2 = r^2\f$ and
\f$r\,\langle P - S, N\rangle > 0\f$; otherwise as `Offset_curve_2`. The surface has to be regular and without edges
inside: a sphere with its poles is refused. Cut it into such parts. Where the offset is rational, `rational_offset()` is
this surface.

\cgalModels{Locus}
*/
class Offset_surface_3
{
  Bspline_surface_3<internal::Exact_kernel> m_rational_surface;
  Spline_map<2, 3> m_surface;
  std::array<Spline_map<2, 3>, 2> m_derivatives;
  Exact_rational m_distance;
  internal::Exact_range m_length_of_normal;

public:
  //! number of coordinates.
  static constexpr int dimension = 3;
  //! the parameters are those of the surface.
  static constexpr int number_of_parameters = 2;
  //! a surface in space.
  static constexpr int codimension = 1;

  /*!
  the offset of a surface.
  \tparam Surface a model of `ParametricSurface_3`.
  \param surface the surface.
  \param distance the signed distance, exactly; not zero.
  \throws Invalid_input when the distance is zero or not finite, a derivative jumps, or the normal vanishes, or nearly
  so; messages say where.
  */
  template <ParametricSurface_3 Surface>
  Offset_surface_3(const Surface& surface, const typename Surface::Kernel::FT& distance)
    : m_rational_surface(Bspline_surface_3<internal::Exact_kernel>::from_homogeneous_coordinates(
          surface.homogeneous_coordinates(), surface.weight())),
      m_surface(surface), m_derivatives{derivative(m_surface, 0), derivative(m_surface, 1)},
      m_distance(internal::converted_number<Exact_rational>(distance))
  {
    if (m_distance == Exact_rational(0))
      throw Invalid_input("Offset_surface_3: the distance is zero");
    m_length_of_normal =
        internal::length_range<3>(normal(), {domain(0), domain(1)}, "Offset_surface_3: the normal of the surface");
  }

  //! the surface itself.
  const Spline_map<2, 3>& surface() const { return m_surface; }

#ifndef DOXYGEN_RUNNING
  const Bspline_surface_3<internal::Exact_kernel>& rational_surface() const { return m_rational_surface; }
#endif

  //! the signed distance.
  const Exact_rational& distance() const { return m_distance; }

  //! the range of a parameter.
  std::pair<Exact_rational, Exact_rational> domain(int axis) const { return m_surface.domain(axis); }

  /// \name Model of Locus
  /// @{

  //! one piece.
  std::vector<Locus_piece<3>> locus_pieces() const;

  //! surfaces have no ends.
  std::vector<Locus_end<3>> locus_ends() const { return {}; }

  /// @}

private:
  internal::Vector_formula<3> normal() const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Locus_piece<3>> Offset_surface_3::locus_pieces() const
{
  const auto at = [](const Spline_map<2, 3>& map) -> internal::Vector_formula<3> {
    return [map](std::span<const Unknown> u) { return map(u[0], u[1]); };
  };
  Locus_piece<3> piece = internal::offset_piece<3>(at(m_surface), {at(m_derivatives[0]), at(m_derivatives[1])},
                                                   normal(), m_distance, {domain(0), domain(1)}, m_length_of_normal);
  for (int axis : {0, 1})
    piece.is_without_end[axis] =
        m_surface.is_closed(axis) && m_derivatives[0].is_closed(axis) && m_derivatives[1].is_closed(axis);
  return {piece};
}

CGAL_SPLINE_CONSTRAINTS_INLINE internal::Vector_formula<3> Offset_surface_3::normal() const
{
  return [derivatives = m_derivatives](std::span<const Unknown> u) {
    return cross(derivatives[0](u[0], u[1]), derivatives[1](u[0], u[1]));
  };
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_OFFSET_SURFACE_3_H
