// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACE_FITTING_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACE_FITTING_H

#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Surface_atlas_d.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Atlas_fitting.h>
#endif

#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

How near B-spline surfaces are to surfaces of solutions, see `fit_bspline_surfaces()`.
*/
struct Surface_fit_options
{
  //! of the polynomials along each parameter, from 2 to 9.
  int degree = 3;

  //! how far charts may be from the surface, in space if there is a map to space, else in the space of the unknowns.
  double tolerance = 1e-3;

  //! how many pieces a chart may have along each parameter before it is called undecided.
  std::size_t most_spans = 64;

  //! the triangles that charts are made of; how fine they are does not limit how near the charts come.
  Surface_mesh_options mesh = {};
};

namespace internal {

// Of the image of the unknowns in space; a null pointer stands for the unknowns themselves.
Surface_atlas_d fitted_atlas(const Surface_solution_set_d& set, const Vector_expression<3>* image,
                             const Surface_fit_options& options, const Solver_options& run);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Surface_atlas_d fitted_atlas(const Surface_solution_set_d& set,
                                                            const Vector_expression<3>* image,
                                                            const Surface_fit_options& options,
                                                            const Solver_options& run)
{
  constexpr int least_degree = 2, most_degree = 9;
  if (options.degree < least_degree || options.degree > most_degree)
    throw Invalid_input("fit_bspline_surfaces: the degree " + std::to_string(options.degree) + " is not from 2 to 9");
  if (!(options.tolerance > 0))
    throw Invalid_input("fit_bspline_surfaces: the tolerance must be positive");
  if (options.most_spans == 0)
    throw Invalid_input("fit_bspline_surfaces: a chart has one piece at least");
  if (set.surfaces().empty())
    throw Invalid_input("fit_bspline_surfaces: there is no surface");
  Run_control control(run);
  const Solution_surface_mesh mesh = mesh_of_solutions(set, image, options.mesh, run);
  std::optional<Image_functions> functions;
  if (image != nullptr)
    functions = image_functions(*image, domain_of_problem(set));
  Surface_projection projection(set, functions ? &*functions : nullptr);
  Surface_atlas_d result =
      Atlas_fitting(mesh, projection, {options.degree, options.tolerance, options.most_spans}, control)();
  result.undecided_parts.insert(result.undecided_parts.begin(), mesh.undecided().begin(), mesh.undecided().end());
  return result;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

B-spline surfaces near surfaces of solutions, in the space of their unknowns: an atlas of charts, each of which is a
disk.

A surface that is a disk is one chart, or one for each part between breaks of splines. All others are cut into charts:
closed ones, those with handles and those with several boundaries. A chart is also cut where no surface without folds
is found for it. Charts meet in common edges, whose curves they share, so that they are joined continuously, up to
rounding; tangent planes differ across edges as the error allows.

Vertices of a mesh give a first surface; points of the true surface, which Newton's method finds beside the last one,
are then fitted by least squares in each round, and spans that are too far away are halved. The error is measured
between the points that were fitted: see `Surface_atlas_d::error`, which proves nothing.

\param set the solutions.
\param options how near the charts are.
\param run the limit of time, and a visitor. What was not done in time is undecided.
\throws Invalid_input when the tolerance, the number of pieces or a bound of the mesh is not positive, the degree is not
from 2 to 9, or there is no surface.

Complexity: for each round a point for each of \f$(2d+3)^2\f$ samples of a piece, and one dense linear system per
parameter; rounds are at most logarithmic in the number of pieces.

Source: \cgalCite{ek-gcs-01}, section 2.3; see \ref Spline_constraints_d_surface_fitting_proofs.
*/
inline Surface_atlas_d fit_bspline_surfaces(const Surface_solution_set_d& set, const Surface_fit_options& options = {},
                                            const Solver_options& run = {})
{
  return internal::fitted_atlas(set, nullptr, options, run);
}

/*!
\ingroup PkgSplineConstraintsDGeometry

the same near the image of surfaces of solutions, in any number of unknowns, under a map to space. Control points have
the coordinates in space first, then those of all unknowns, in which nothing is said of the error.

\param set the solutions.
\param image the point of space as formulas of the unknowns.
\param options how near the charts are, in space.
\param run the limit of time, and a visitor. What was not done in time is undecided.
\throws Invalid_input as above, or when a formula has unknowns that the system does not have.
*/
inline Surface_atlas_d fit_bspline_surfaces(const Surface_solution_set_d& set, const Vector_expression<3>& image,
                                            const Surface_fit_options& options = {}, const Solver_options& run = {})
{
  return internal::fitted_atlas(set, &image, options, run);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACE_FITTING_H
