// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_ARRANGEMENT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_ARRANGEMENT_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/regions/Polyline_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/polyline_arrangements.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRegions

the arrangement of polylines in the plane: of bisectors, envelopes, contour lines, and others that operations return.

The arrangement of the polylines is exact. That of the curves it resembles as far as the polylines do: curves that pass
each other more closely than chords pass the curves may cross there, and two that touch need not.

\param polylines points in order; a closed curve begins and ends with the same one. Equal points, as in common ends,
become one vertex. A polyline of one point becomes an isolated vertex, if no other one passes there.
\tparam Point `CGAL::Point_2` of any kernel whose coordinates convert to double; they are rounded to doubles.
\throws Invalid_input when the absolute value of a coordinate is not \f$2^{250}\f$ at most (the message names the
polyline).

Complexity: that of a sweep, \f$O((n+k) \log n)\f$ for \f$n\f$ chords with \f$k\f$ crossings.
*/
template <class Point>
Polyline_arrangement_2 to_arrangement(const std::vector<std::vector<Point>>& polylines)
{
  return internal::Regions::polyline_arrangement<Polyline_arrangement_2>(polylines);
}

/*!
\ingroup PkgSplineConstraintsDRegions

The curves of solutions of an equation in two unknowns as an arrangement of chords.
*/
struct Solution_arrangement_2
{
  //! the arrangement. Labels are indices of curves of the set, and of chords of the polylines.
  Polyline_arrangement_2 arrangement;

  //! the polylines, in the order of the curves; behind them isolated solutions, as single points.
  std::vector<std::vector<CGAL::Exact_predicates_exact_constructions_kernel::Point_2>> polylines;

  //! whether chords meet in their ends only: if not, points so close to each other have been rounded that the faces may
  //! be wrong.
  bool is_crossing_free;

  //! what is not decided of the solutions; of an arrangement that a limit ended, the box of all of them.
  std::vector<Undecided_part> undecided_parts = {};
  Summary work = {}; ///< see `summary()`

  //! whether the faces are those of the curves, by proof.
  bool is_complete() const { return is_crossing_free && undecided_parts.empty(); }

  //! `undecided_parts`: there may be other solutions in their places.
  const std::vector<Undecided_part>& undecided() const { return undecided_parts; }

  //! the work; a node is a polyline.
  const Summary& summary() const { return work; }
};

namespace internal {
namespace Regions {

std::vector<Undecided_part::Range> box_of(const Constraint_system_d& system);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Undecided_part::Range> box_of(const Constraint_system_d& system)
{
  std::vector<Undecided_part::Range> result;
  for (int i = 0; i < system.dimension(); ++i)
    result.push_back(to_double_range(system.domain(i)));
  return result;
}
#endif

} // namespace Regions
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDRegions

the arrangement of all curves of solutions of an equation in two unknowns.

Branches that meet in a singular point end in the same vertex, isolated solutions are isolated vertices.

Faces are those of the curves, however coarse the chords are. For the chords of a piece lie in its box: two pieces in
one box belong to different ranges of the parameter, and other boxes have no inner point in common with it. So chords do
not cross, and within each box they join the same points of its boundary as the curves do. Coordinates are rounded to
doubles; whether that has made chords meet is decided exactly. Boxes where nothing is proved,
`Curve_solution_set_d::undecided()`, leave gaps. The polylines can be ended by limits and a visitor, and then there is
no arrangement; the sweep over them is one step.

\param system the system that was solved.
\param set its solutions.
\param error the distance between a curve and its chords, see `to_polyline()`; positive.
\param options limits of time and nodes, a visitor; the rest of the options has no effect.
\throws Invalid_input when there are not two unknowns, the error is not positive, a coordinate is too great, as above,
or an option makes no sense.
*/
Solution_arrangement_2 to_arrangement(const Constraint_system_d& system, const Curve_solution_set_d& set, double error,
                                      const Solver_options& options = {});

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Solution_arrangement_2 to_arrangement(const Constraint_system_d& system,
                                                                     const Curve_solution_set_d& set, double error,
                                                                     const Solver_options& options)
{
  if (system.dimension() != 2)
    throw Invalid_input("to_arrangement: " + std::to_string(system.dimension()) + " unknowns instead of two");
  internal::Common::Run_of_steps run(options);
  Solution_arrangement_2 result{{}, {}, false};
  for (const Solution_curve& curve : set.curves()) {
    if (run.must_stop()) {
      result.polylines.clear();
      result.undecided_parts = {{internal::Regions::box_of(system), {}, internal::in_words(run.reason())}};
      result.work = run.summary(false);
      return result;
    }
    auto& polyline = result.polylines.emplace_back();
    for (const std::vector<double>& p : to_polyline(system, set, curve, error))
      polyline.emplace_back(p[0], p[1]);
  }
  for (const auto* isolated : {&set.points(), &set.singular_points()})
    for (const std::size_t i : *isolated)
      result.polylines.push_back({{set.vertices()[i].point()[0], set.vertices()[i].point()[1]}});
  result.arrangement = to_arrangement(result.polylines);
  result.is_crossing_free = internal::Regions::is_crossing_free(result.arrangement, result.polylines);
  result.undecided_parts = set.undecided();
  result.work = run.summary(result.is_complete());
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_ARRANGEMENT_2_H
