// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection_point.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Found_intersection.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/intersections/internal/found_intersections.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

A point of a polyline along an intersection curve.
*/
template <SplineKernel Kernel>
struct Intersection_sample
{
  //! the point, next to both surfaces.
  typename Kernel::Point_3 point;

  //! its parameters on both surfaces; none on one that has none. At a seam, they are those of the side that the arc
  //! lies on.
  std::array<std::optional<std::array<double, 2>>, 2> parameters;
};

/*!
\ingroup PkgSplineConstraintsDIntersections

All that two surfaces have in common: curves, whose number and connections are proved, singular points, single points,
and what is undecided.

Surfaces are numbered 0 and 1, their parameters, the axes, too.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Surface_intersection
{
public:
  //! a point that is not just one of many along a curve.
  using Special_point = Surface_intersection_point<Kernel>;
  //! the points of the kernel.
  using Point = typename Kernel::Point_3;
  //! a point of a polyline.
  using Sample = Intersection_sample<Kernel>;

private:
  internal::Intersections::Found_intersection m_found;
  std::vector<Special_point> m_points, m_singular_points;

public:
  //! what an operation has found, with points of the kernel.
  explicit Surface_intersection(internal::Intersections::Found_intersection found)
    : m_found(std::move(found)), m_points(special_points(m_found.points)),
      m_singular_points(special_points(m_found.singular_points))
  {}

  //! the curves. A curve that is not closed ends on an edge of a surface, at a singular point or where it is undecided
  //! how it goes on.
  const std::vector<Intersection_curve>& curves() const { return m_found.curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_found.curves); }

  //! number of curves along which the surfaces touch: those whose kind is `TANGENT`.
  std::size_t number_of_contact_curves() const
  {
    return static_cast<std::size_t>(
        std::count_if(m_found.curves.begin(), m_found.curves.end(),
                      [](const Intersection_curve& curve) { return curve.kind() == Intersection_kind::TANGENT; }));
  }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_found.curves.size() - number_of_closed_curves(); }

  //! singular points: where curves cross, where surfaces touch without having others in common near it, poles that no
  //! curve goes on through, and pinch points of one surface, where a curve ends in which it meets itself.
  const std::vector<Special_point>& singular_points() const { return m_singular_points; }

  //! single points, of the kind `END_POINT`: on an edge of a surface, where a curve only touches it from outside, so
  //! that no other common point is near.
  const std::vector<Special_point>& points() const { return m_points; }

  //! where it is undecided what the surfaces have in common: regions of their domains, and ends on a seam or break that
  //! were not matched with one on the other side. The box in space holds the points of the first surface, or of the
  //! second one if that is the only one with parameters.
  std::vector<Undecided_part> undecided() const { return internal::Intersections::undecided_parts_of(m_found); }

  //! the same, as points in the middle of the boxes.
  std::vector<Special_point> undecided_points() const
  {
    return special_points(internal::Intersections::undecided_points_of(m_found));
  }

  //! whether the curves, points and singular points are all that the surfaces have in common, and the curves are
  //! connected as they say, by proof.
  bool is_complete() const { return m_found.summary.is_complete; }

  //! the first (`side` 0) or last (`side` 1) point of a curve; of a closed one, which has the kind of the curve there,
  //! the first one.
  Special_point end(const Intersection_curve& curve, int side) const
  {
    return Special_point(internal::Intersections::end_of_curve(m_found, curve, side));
  }

  /*!
  points along an arc, so many that the arc passes the middles of their chords at no more than a given distance, in
  space as well as in the parameters. Their parameters solve the equations up to rounding; see `to_polyline()`.
  \param arc an arc of one of the curves.
  \param error the distance in space; positive.
  \param parameter_error the distance in each of the domains, positive; none: parameters do not matter.
  \throws Invalid_input when a distance is not positive.
  */
  std::vector<Sample> samples(const Intersection_arc& arc, double error,
                              std::optional<double> parameter_error = std::nullopt) const
  {
    std::vector<Sample> result;
    for (const auto& [point, parameters] :
         internal::Intersections::samples_of_arc(m_found, arc, error, parameter_error))
      result.push_back({internal::kernel_object<Kernel, Point>(point), parameters});
    return result;
  }

  /*!
  points along a curve, so many that the curve passes the middles of their chords at no more than a given distance; a
  closed curve begins and ends with the same one.
  \param curve one of the curves.
  \param error the distance; positive.
  \throws Invalid_input when the distance is not positive.
  */
  std::vector<Point> polyline(const Intersection_curve& curve, double error) const
  {
    std::vector<Point> result;
    for (const Intersection_arc& arc : curve.arcs) {
      if (!result.empty())
        result.pop_back();   // the first point of the next arc
      for (const Sample& sample : samples(arc, error))
        result.push_back(sample.point);
    }
    if (curve.is_closed)
      result.back() = result.front();
    return result;
  }

  //! number of systems that were solved: one, but for self-intersections of a surface with several pieces.
  std::size_t number_of_parts() const { return internal::Intersections::number_of_parts_of(m_found); }

  //! the curves of a part as the solver found them: its unknowns are the parameters of the surfaces that have some, of
  //! the first one only, if both are height fields over the same coordinates, and of one only, if the other one is
  //! given by its equation; then, if they are needed, the coordinates in space.
  const Curve_solution_set_d& solutions(std::size_t part = 0) const
  {
    return internal::Intersections::solutions_of_part(m_found, part);
  }

  //! the equations that were solved, for `curve_differentials()` and `fit_spline()`. `Constraint_system_d.h` has to be
  //! included for more than that. \pre The bounds of the surfaces meet, as they do if there is a curve.
  const Constraint_system_d& system(std::size_t part = 0) const
  {
    return internal::Intersections::system_of_part(m_found, part);
  }

  //! the work.
  const Summary& summary() const { return m_found.summary; }

private:
  static std::vector<Special_point>
  special_points(const std::vector<internal::Intersections::Common_surface_point>& all)
  {
    return std::vector<Special_point>(all.begin(), all.end());
  }
};

//! \ingroup PkgSplineConstraintsDIntersections
//! writes one line: the numbers of curves, single points, singular points and undecided regions.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Surface_intersection<Kernel>& intersection)
{
  return internal::write_counts(out, intersection);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_H
