// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection_point.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Solved_part.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Joined_parts.h>
#endif

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
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

  //! its parameters on both surfaces, zero on one that has none. At a seam, they are those of the side that the arc
  //! lies on.
  std::array<std::array<double, 2>, 2> parameters;
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
  std::vector<internal::Intersections::Solved_part> m_parts;
  std::vector<Intersection_curve> m_curves;
  std::vector<Special_point> m_points, m_singular_points, m_undecided;
  std::vector<internal::Intersections::Part_vertex> m_pinch_points, m_unmatched;
  Summary m_summary;

public:
#ifndef DOXYGEN_RUNNING
  Surface_intersection(internal::Intersections::Surface_equations surfaces, Curve_solution_set_d solutions)
    : Surface_intersection(
          std::vector<internal::Intersections::Solved_part>{{std::move(surfaces), std::move(solutions)}})
  {}

  // Of one part at least. If that has no system, the surfaces have nothing in common.
  explicit Surface_intersection(std::vector<internal::Intersections::Solved_part> parts) : m_parts(std::move(parts))
  {
    if (!m_parts.front().surfaces.has_system())
      return;
    internal::Intersections::Joined_curves joined = internal::Intersections::joined_curves(m_parts);
    m_curves = std::move(joined.curves);
    for (Intersection_curve& curve : m_curves)
      curve.multiplicity = internal::Common::common_multiplicity(curve.arcs, [&](const Intersection_arc& arc) {
        return m_parts[arc.part].solutions.curves()[arc.index].multiplicity();
      });
    m_pinch_points = std::move(joined.equal_pairs);
    m_unmatched = std::move(joined.unmatched);
    const auto add = [&](std::vector<Special_point>& list, Intersection_kind kind,
                         const std::vector<internal::Intersections::Part_vertex>& vertices) {
      for (const internal::Intersections::Part_vertex& point : vertices)
        list.push_back(special_point(kind, point));
    };
    add(m_points, Intersection_kind::END_POINT, joined.points);
    add(m_singular_points, Intersection_kind::TANGENT, joined.singular_points);
    add(m_singular_points, Intersection_kind::TANGENT, m_pinch_points);
    for (const internal::Intersections::Solved_part& part : m_parts) {
      for (const Undecided_region& region : part.solutions.undecided_regions())
        m_undecided.push_back(Special_point(part.surfaces, Intersection_kind::UNDECIDED, hull(region.boxes)));
      m_summary += part.solutions.summary();
    }
    add(m_undecided, Intersection_kind::UNDECIDED, m_unmatched);
    m_summary.is_complete = m_summary.is_complete && m_unmatched.empty();
  }
#endif

  //! the curves. A curve that is not closed ends on an edge of a surface, at a singular point or where it is undecided
  //! how it goes on.
  const std::vector<Intersection_curve>& curves() const { return m_curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_curves); }

  //! number of curves along which the surfaces touch: those whose kind is `TANGENT`.
  std::size_t number_of_contact_curves() const
  {
    return static_cast<std::size_t>(
        std::count_if(m_curves.begin(), m_curves.end(),
                      [](const Intersection_curve& curve) { return curve.kind() == Intersection_kind::TANGENT; }));
  }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_curves.size() - number_of_closed_curves(); }

  //! singular points: where curves cross, where surfaces touch without having others in common near it, poles that no
  //! curve goes on through, and pinch points of one surface, where a curve ends in which it meets itself.
  const std::vector<Special_point>& singular_points() const { return m_singular_points; }

  //! single points, of the kind `END_POINT`: on an edge of a surface, where a curve only touches it from outside, so
  //! that no other common point is near.
  const std::vector<Special_point>& points() const { return m_points; }

  //! the regions where nothing is proved, and the ends on a seam or break that were not matched with one on the other
  //! side: the ranges hold their parameters.
  const std::vector<Special_point>& undecided() const { return m_undecided; }

  //! whether the curves, points and singular points are all that the surfaces have in common, and the curves are
  //! connected as they say, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the first (`side` 0) or last (`side` 1) point of a curve; of a closed one, which has the kind of the curve there,
  //! the first one.
  Special_point end(const Intersection_curve& curve, int side) const
  {
    const Intersection_arc& arc = side == 0 || curve.is_closed ? curve.arcs.front() : curve.arcs.back();
    const Curve_solution_set_d& set = m_parts[arc.part].solutions;
    const std::vector<Curve_piece>& pieces = set.curves()[arc.index].pieces;
    const internal::Intersections::Part_vertex end{
        arc.part, (side == 0 || curve.is_closed) != arc.is_reversed ? pieces.front().ends[0] : pieces.back().ends[1]};
    const Curve_vertex& vertex = set.vertices()[end.vertex];
    const auto has_it = [&](const Undecided_region& region) {
      return std::find(region.vertices.begin(), region.vertices.end(), end.vertex) != region.vertices.end();
    };
    const auto is_one_of = [&](const std::vector<internal::Intersections::Part_vertex>& points) {
      return std::find(points.begin(), points.end(), end) != points.end();
    };
    const bool is_undecided = (vertex.is_on_inequality && !m_parts[arc.part].surfaces.has_edges_on_inequalities()) ||
        is_one_of(m_unmatched) || std::any_of(set.undecided_regions().begin(), set.undecided_regions().end(), has_it);
    return special_point(curve.is_closed                                   ? curve.kind()
                         : vertex.is_singular || is_one_of(m_pinch_points) ? Intersection_kind::TANGENT
                         : is_undecided                                    ? Intersection_kind::UNDECIDED
                                                                           : Intersection_kind::END_POINT,
                         end);
  }

  /*!
  points along an arc, so many that the arc passes the middles of their chords at no more than a given distance, in
  space as well as in the parameters. Their parameters solve the equations up to rounding; see `to_polyline()`.
  \param arc an arc of one of the curves.
  \param error the distance in space; positive.
  \param parameter_error the distance in each of the domains; positive.
  \throws Invalid_input when a distance is not positive.
  */
  std::vector<Sample> samples(const Intersection_arc& arc, double error,
                              double parameter_error = std::numeric_limits<double>::infinity()) const
  {
    if (!(error > 0) || !(parameter_error > 0))
      throw Invalid_input("Surface_intersection: the error must be positive");
    const auto is_chord = [&](const auto& from, const auto& sample, const auto& to) {
      using internal::distance_from_middle;
      return distance_from_middle(from.image, sample.image, to.image) <= error &&
          distance_from_middle(from.unknowns, sample.unknowns, to.unknowns) <= parameter_error;
    };
    const auto& [surfaces, set, poles] = m_parts[arc.part];
    const auto point = [&surfaces = surfaces](const std::vector<double>& unknowns) { return surfaces.point(unknowns); };
    std::vector<Sample> result;
    for (const auto& [unknowns, image] :
         internal::curve_samples(surfaces.system(), set, set.curves()[arc.index], point, is_chord))
      result.push_back({internal::kernel_object<Kernel, Point>(image),
                        {parameters(surfaces, 0, unknowns), parameters(surfaces, 1, unknowns)}});
    if (arc.is_reversed)
      std::reverse(result.begin(), result.end());
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
  std::size_t number_of_parts() const { return m_parts.size(); }

  //! the curves of a part as the solver found them: its unknowns are the parameters of the surfaces that have some, of
  //! the first one only, if both are height fields over the same coordinates, and of one only, if the other one is
  //! given by its equation; then, if they are needed, the coordinates in space.
  const Curve_solution_set_d& solutions(std::size_t part = 0) const { return m_parts[part].solutions; }

  //! the equations that were solved, for `curve_differentials()` and `fit_spline()`. \pre The bounds of the surfaces
  //! meet, as they do if there is a curve.
  const Constraint_system_d& system(std::size_t part = 0) const
  {
    CGAL_precondition(m_parts[part].surfaces.has_system());
    return m_parts[part].surfaces.system();
  }

  //! the work.
  const Summary& summary() const { return m_summary; }

private:
  Special_point special_point(Intersection_kind kind, const internal::Intersections::Part_vertex& point) const
  {
    const auto& [surfaces, solutions, poles] = m_parts[point.part];
    return Special_point(surfaces, kind, solutions.vertices()[point.vertex].box);
  }

  static Curve_vertex::Exact_box hull(const std::vector<Curve_vertex::Exact_box>& boxes)
  {
    Curve_vertex::Exact_box result = boxes.front();
    for (const Curve_vertex::Exact_box& box : boxes)
      for (std::size_t j = 0; j < box.size(); ++j)
        result[j] = {(std::min)(result[j].first, box[j].first), (std::max)(result[j].second, box[j].second)};
    return result;
  }

  static std::array<double, 2> parameters(const internal::Intersections::Surface_equations& surfaces,
                                          std::size_t surface, const std::vector<double>& unknowns)
  {
    if (!surfaces.is_parametric(surface))
      return {};
    return surfaces.parameters(surface, unknowns);
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
