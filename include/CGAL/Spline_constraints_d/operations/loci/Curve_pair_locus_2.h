// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_LOCUS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_LOCUS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_curve.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_sample.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Found_pair_locus.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_locus_collector.h>
#endif

#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

Curves in the plane whose points belong to one point on each of two curves, or to two of one curve: their bisector, for
example. They are solutions of equations in both parameters, with a proved topology.

A curve of the result ends where one of the parameters is at the end of its part, in a singular point, or at infinity.
It goes on across the seam of a closed curve that is smooth there, and in other parts where an operation says so.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Curve_pair_locus_2
{
public:
  //! a point of a polyline.
  using Sample = Curve_pair_sample<Kernel>;

  //! a part of one of the curves without seams or breaks inside.
  using Arc = Curve_pair_arc;
  //! one of the curves.
  using Curve = Curve_pair_curve;

private:
  internal::Loci::Found_pair_locus m_found;

public:
  //! what an operation has found, with points of the kernel.
  explicit Curve_pair_locus_2(internal::Loci::Found_pair_locus found) : m_found(std::move(found)) {}

  //! the curves, one after the other by parts.
  const std::vector<Curve>& curves() const { return m_found.curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_found.curves); }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_found.curves.size() - number_of_closed_curves(); }

  //! single points: solutions at the end of a part that no other one is near, since a curve only touches the part from
  //! outside.
  const std::vector<Curve_vertex>& points() const { return m_found.points; }

  //! where curves cross in the plane of the parameters, or isolated solutions.
  const std::vector<Curve_vertex>& singular_points() const { return m_found.singular_points; }

  //! where nothing is proved, poles that do not find their place on a curve, and ends on a seam that were not matched
  //! with one on the other side: by the parameters of both points. Where these are in the plane is not told.
  std::vector<Undecided_part> undecided() const { return internal::Loci::undecided_parts_of(m_found); }

  //! the same, with boxes in the domain of the unknowns.
  const std::vector<Undecided_region>& undecided_regions() const { return m_found.undecided; }

  //! how often a curve goes to infinity and comes back from the other side: two ends each.
  std::size_t number_of_poles() const { return m_found.poles; }

  //! whether these are all solutions, by proof.
  bool is_complete() const { return m_found.summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_found.summary; }

  //! the curves of two parts in the plane of the unknowns, which are their parameters unless an operation says
  //! otherwise, as the solver found them, but cut at infinity.
  const Curve_solution_set_d& solutions(std::size_t part) const
  {
    return internal::Loci::solutions_of_part(m_found, part);
  }

  //! the equations of a part, for `curve_differentials()`: with `image()` by a formula of a point in the unknowns, as
  //! \f$C_1(u) + C_2(v)\f$ of an envelope, they give tangent and curvature of its curves. `Constraint_system_d.h` has
  //! to be included for more than that.
  const Constraint_system_d& system(std::size_t part) const { return internal::Loci::system_of_part(m_found, part); }

  //! whether the first (`side` 0) or last (`side` 1) end of a curve is at infinity.
  bool ends_at_infinity(const Curve& curve, int side) const
  {
    return internal::Loci::ends_at_infinity(m_found, curve, side);
  }

  /*!
  points along a curve, so many that it passes the middles of their chords at no more than a given distance. Far from
  the origin a larger distance will do: all is seen in the stereographic projection to a sphere of the given radius.
  Ends at infinity are left out; a point on a seam comes twice, with the parameters on both sides.
  \param curve one of the curves.
  \param error the distance; positive.
  \param radius the distance from the origin from which on less precision is needed; positive.
  \throws Invalid_input when a distance is not positive.
  */
  std::vector<Sample> polyline(const Curve& curve, double error, double radius) const
  {
    std::vector<Sample> result;
    for (const auto& [point, parameters] : internal::Loci::samples_of_curve(m_found, curve, error, radius))
      result.push_back({typename Kernel::Point_2(point[0], point[1]), parameters});
    return result;
  }
};

//! \ingroup PkgSplineConstraintsDLoci
//! writes one line: the numbers of curves, single points, singular points and undecided regions.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Curve_pair_locus_2<Kernel>& locus)
{
  return internal::write_counts(out, locus);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_LOCUS_2_H
