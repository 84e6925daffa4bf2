// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_SHAPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_SHAPE_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/Point_3.h>
#include <CGAL/Vector_3.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

What can be chosen of a smooth surface beside its vertices and gradients, see `smooth_surface()`. Each is a function of
the place and of the value that is taken where the function is empty. All values may be chosen: the pieces stay smooth
across their faces. Faces and vertices have the numbers of the mesh. Where operators of `FT` return expressions, as
those of GMP do, a lambda has to say what it returns: `[](...) -> FT { ... }`.
*/
struct Smooth_surface_shape
{
  //! the kernel.
  using Kernel = internal::Exact_kernel;
  //! the numbers.
  using FT = Exact_rational;
  //! a point.
  using Point_3 = Kernel::Point_3;
  //! a vector.
  using Vector_3 = Kernel::Vector_3;

  //! The apex above or below a face: the center of the face, moved along its normal.
  struct Apex
  {
    std::size_t face; ///< the face
    bool is_outer;    ///< whether it is above
    Point_3 point;    ///< where it is
  };

  //! A point between the apexes of two faces with a common edge.
  struct Gap
  {
    std::size_t source; ///< an end of the edge
    std::size_t target; ///< the other one
    bool is_outer;      ///< whether it is above
    std::size_t face;   ///< the face whose apex is meant
    Point_3 point;      ///< the point
    Point_3 apex;       ///< the apex
  };

  //! the height \f$h > 0\f$ of an apex, which is \f$w \pm h N\f$ for the center \f$w\f$ of a face with the corners
  //! \f$p,q,r\f$, and \f$N = (q-p) \times (r-p)\f$. With it there is no search for heights.
  std::function<FT(std::size_t face, bool is_outer, const FT& value)> height = {};

  //! the value of the function at an apex: less of it pulls the surface to the apex. By default that of the quadratic
  //! polynomial with the vertices, mean slopes along the edges and, along the normal, the half of the second
  //! derivatives in the face, that of a sphere for a sphere, unless the slope along the normal would change its sign.
  std::function<FT(const Apex& apex, const FT& value)> apex_value = {};

  //! the gradient at an apex; by default that of this polynomial, with the value at the apex.
  std::function<Vector_3(const Apex& apex, const Vector_3& value)> apex_gradient = {};

  //! the slope across an edge: by default half of the sum of the gradients at its ends. The part along the edge does
  //! not matter.
  std::function<Vector_3(std::size_t source, std::size_t target, const Vector_3& value)> edge_gradient = {};

  //! the Bernstein coefficient with the gap point twice and the apex; by default that of this polynomial, unless those
  //! of both faces are different and the slope from the edge to the gap point would change its sign.
  std::function<FT(const Gap& gap, const FT& value)> gap_value = {};

  //! where a gap point divides the segment from the apex of one face to that of the other, in (0,1).
  FT gap_position = FT(1) / FT(2);
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_SHAPE_H
