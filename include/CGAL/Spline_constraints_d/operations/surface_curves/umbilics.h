// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_UMBILICS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_UMBILICS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Umbilic_finder.h>
#endif

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

Umbilics of a surface.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Umbilics_3
{
public:
  //! an umbilic.
  struct Umbilic
  {
    //! the point, up to rounding.
    typename Kernel::Point_3 point;
    //! its parameters with their proof: certified, or a cluster with a multiplicity.
    Solution_d<double> parameters;
  };

private:
  std::vector<Umbilic> m_points;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what `umbilics()` has found, with points of the kernel.
  explicit Umbilics_3(internal::Surface_curves::Found_umbilics found)
    : m_undecided(std::move(found.undecided)), m_summary(found.summary)
  {
    for (auto& [point, parameters] : found.points)
      m_points.push_back({internal::kernel_object<Kernel, typename Kernel::Point_3>(point), std::move(parameters)});
  }

  //! all that are proved, each once.
  const std::vector<Umbilic>& points() const { return m_points; }

  //! where nothing is proved: boxes in space, and in the domain of the surface, which is operand 0.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! whether these are all umbilics, by proof: nothing is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the umbilics of a surface, where its curvature is the same in all directions: points at which the lines of curvature are
singular. A flat point is one, too.

The coefficients of both fundamental forms are proportional there, \f$LF = ME\f$ and \f$LG = NE\f$; on a regular
surface, where \f$E > 0\f$, \f$MG = NF\f$ follows. For \f$S = X/w\f$ all of them are replaced by polynomials that are
positive multiples, as for `parabolic_lines()`. That the surface is regular at a solution is proved.

Factors that vanish all along an edge or a break, as at a pole, are divided out, and this line is undecided; so are
pieces of spheres and planes, and whole curves of umbilics. Where the curvature jumps at a break, the umbilics of both
sides count, each with the curvature of its own side.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of two equations in two unknowns, of degrees \f$5d-2\f$ at most for polynomial surfaces of degrees
\f$d\f$, and \f$8d-2\f$ for rational ones. Source: \cgalCite{pm-sicad-02}.
*/
template <internal::Surface_curves::Surface_operand Surface>
Umbilics_3<internal::Surface_curves::Operand_kernel<Surface>> umbilics(const Surface& surface,
                                                                       const Solver_options& options = {})
{
  return Umbilics_3<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Surface_curves::umbilics_of(internal::Common::Intersection_operand<Surface>::map(surface), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_UMBILICS_H
