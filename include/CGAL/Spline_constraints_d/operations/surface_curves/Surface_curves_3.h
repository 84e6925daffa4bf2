// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SURFACE_CURVES_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SURFACE_CURVES_3_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/Surface_curve.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Found_surface_curves.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_curve_collector.h>
#endif

#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

A point of a polyline along a curve on a surface.
*/
template <SplineKernel Kernel>
struct Surface_curve_sample
{
  //! the point.
  typename Kernel::Point_3 point;

  //! its parameters on the surface, then further unknowns of the operation, if it has some.
  std::vector<double> parameters;
};

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

Curves on a surface: its silhouettes, for example. They are the solutions of equations whose first two unknowns are the
parameters of the surface, with a proved topology.

The domain is cut into parts where an equation jumps: along creases of the surface, as a rule. A curve ends where one of
the parameters is at the end of a part, and in singular points. It goes on across the seam of a surface that is smooth
there, and through a pole, an edge that is one point, if no other curves end in it.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Surface_curves_3
{
public:
  //! a curve.
  using Curve = Surface_curve;
  //! the points of the kernel.
  using Point = typename Kernel::Point_3;
  //! a point of a polyline.
  using Sample = Surface_curve_sample<Kernel>;

private:
  internal::Surface_curves::Found_surface_curves m_found;

public:
  //! what an operation has found, with points of the kernel.
  explicit Surface_curves_3(internal::Surface_curves::Found_surface_curves found) : m_found(std::move(found)) {}

  //! the curves, one part of the domain after the other.
  const std::vector<Curve>& curves() const { return m_found.curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_found.curves); }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_found.curves.size() - number_of_closed_curves(); }

  //! where curves cross, and isolated solutions, in the domain of the unknowns. Where a curve with a
  //! `Surface_curve::line` meets others, none of them ends.
  const std::vector<Curve_vertex>& singular_points() const { return m_found.singular_points; }

  //! single points: solutions on the edge of a part that no other one of the part is near, since a curve only touches
  //! it from outside.
  const std::vector<Curve_vertex>& points() const { return m_found.points; }

  //! where nothing is proved: boxes in space, with the parameters of the surface, which is operand 0, and those of the
  //! second operand, if the unknowns have some.
  std::vector<Undecided_part> undecided() const { return internal::Surface_curves::undecided_parts_of(m_found); }

  //! the same, with the boxes in the domain of the unknowns.
  const std::vector<Undecided_region>& undecided_regions() const { return m_found.undecided; }

  //! whether these are all solutions, by proof.
  bool is_complete() const { return m_found.summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_found.summary; }

  //! the curves of a part in the domain of its unknowns, as the solver found them.
  const Curve_solution_set_d& solutions(std::size_t part) const
  {
    return internal::Surface_curves::solutions_of_part(m_found, part);
  }

  //! the equations of a part, for `curve_differentials()`: with `image()` by the surface as a `Spline_map` of the first
  //! two unknowns, they give tangent, curvature and torsion of its curves in space. A curve with a
  //! `Surface_curve::line` is not on them. `Constraint_system_d.h` has to be included for more than that.
  const Constraint_system_d& system(std::size_t part) const
  {
    return internal::Surface_curves::system_of_part(m_found, part);
  }

  //! the point where the unknowns have these values; values outside of the domain are moved to its boundary.
  Point point(const std::vector<double>& unknowns) const
  {
    return internal::kernel_object<Kernel, Point>(m_found.place.point(unknowns));
  }

  /*!
  points along a curve, so many that it passes the middles of their chords at no more than a given distance; a point on
  a seam comes twice, with the parameters on both sides, and so does a pole. A closed curve begins and ends in the same
  point.
  \param curve one of the curves.
  \param error the distance in space; positive.
  \throws Invalid_input when the distance is not positive.
  */
  std::vector<Sample> polyline(const Curve& curve, double error) const
  {
    std::vector<Sample> result;
    for (auto& [point, unknowns] : internal::Surface_curves::samples_of_curve(m_found, curve, error))
      result.push_back({internal::kernel_object<Kernel, Point>(point), std::move(unknowns)});
    return result;
  }
};

//! \ingroup PkgSplineConstraintsDSurfaceCurves
//! writes one line: the numbers of curves, single points, singular points and undecided regions.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Surface_curves_3<Kernel>& curves)
{
  return internal::write_counts(out, curves);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SURFACE_CURVES_3_H
