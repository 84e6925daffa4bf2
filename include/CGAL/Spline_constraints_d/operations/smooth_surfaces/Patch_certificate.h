// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_PATCH_CERTIFICATE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_PATCH_CERTIFICATE_H

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

What is proved of a tetrahedron of a smooth surface. If all of it is proved of all of them, the surface is that of the
mesh, moved along segments: see \ref Spline_constraints_d_smooth_surfaces_proofs.
*/
struct Patch_certificate
{
  //! whether, wherever the function is zero, it increases outwards: along the normal of the face, or, in a gap, from
  //! the middle of the edge to the gap point.
  bool is_monotone = false;

  //! whether the function is positive on the outer faces of a tetrahedron above the mesh, negative on those of one
  //! below it, but for vertices of the mesh.
  bool has_signs = false;

  //! whether it meets all others in common faces, edges and vertices only.
  bool is_apart = false;

  //! whether all that is proved.
  bool is_certified() const { return is_monotone && has_signs && is_apart; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_PATCH_CERTIFICATE_H
