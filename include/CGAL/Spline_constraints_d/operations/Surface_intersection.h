// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_INTERSECTION_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/Surface_intersection_point.h>
#include <CGAL/Spline_constraints_d/operations/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

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
\ingroup PkgSplineConstraintsDOperations

A point of a polyline along an intersection curve.
*/
template <SplineKernel Kernel>
struct Intersection_sample
{
  //! the point, next to both surfaces.
  typename Kernel::Point_3 point;

  //! its parameters on both surfaces, zero on one that has none. At a seam, they are those of the side that the arc lies on.
  std::array<std::array<double, 2>, 2> parameters;
};

/*!
\ingroup PkgSplineConstraintsDOperations

All that two surfaces have in common: curves, whose number and connections are proved, singular points, single points, and what is undecided.

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
  internal::Surface_equations m_surfaces;
  Curve_solution_set_d m_solutions;
  std::vector<Intersection_curve> m_curves;
  std::vector<Special_point> m_points, m_singular_points, m_undecided;
  std::vector<std::size_t> m_pinch_points;   // vertices
  Summary m_summary;

public:
#ifndef DOXYGEN_RUNNING
  Surface_intersection(internal::Surface_equations surfaces, Curve_solution_set_d solutions)
    : m_surfaces(std::move(surfaces)), m_solutions(std::move(solutions)), m_summary(m_solutions.summary())
  {
    if (!m_surfaces.has_system())
      return;
    const internal::Seam_joints joints(m_surfaces.system(), m_solutions, m_surfaces.closed_unknowns(), {}, m_surfaces.exchange());
    m_curves = joints.curves();
    m_summary.is_complete = m_summary.is_complete && joints.unmatched().empty();
    for (const std::size_t i : joints.points())
      m_points.push_back(special_point(Intersection_kind::END_POINT, m_solutions.vertices()[i].box));
    for (const std::size_t i : m_solutions.singular_points())
      m_singular_points.push_back(special_point(Intersection_kind::TANGENT, m_solutions.vertices()[i].box));
    m_pinch_points = joints.equal_pairs();
    for (const std::size_t i : m_pinch_points)
      m_singular_points.push_back(special_point(Intersection_kind::TANGENT, m_solutions.vertices()[i].box));
    for (const Undecided_region& region : m_solutions.undecided())
      m_undecided.push_back(special_point(Intersection_kind::UNDECIDED, hull(region.boxes)));
    for (const std::size_t i : joints.unmatched())
      m_undecided.push_back(special_point(Intersection_kind::UNDECIDED, m_solutions.vertices()[i].box));
  }
#endif

  //! the curves. A curve that is not closed ends on an edge of a surface, at a singular point or where it is undecided how it goes on.
  const std::vector<Intersection_curve>& curves() const { return m_curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_curves); }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_curves.size() - number_of_closed_curves(); }

  //! singular points: where curves cross, where surfaces touch without having others in common near it, and pinch points of one surface, where a curve ends in which it meets itself.
  const std::vector<Special_point>& singular_points() const { return m_singular_points; }

  //! points on an edge of a surface without others near them.
  const std::vector<Special_point>& points() const { return m_points; }

  //! the regions where nothing is proved, and the ends on a seam that were not matched with one on the other side: the ranges hold their parameters.
  const std::vector<Special_point>& undecided() const { return m_undecided; }

  //! whether the curves, points and singular points are all that the surfaces have in common, and the curves are connected as they say, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the first (`side` 0) or last (`side` 1) point of a curve; of a closed one, which is `TRANSVERSAL` there, the first one.
  Special_point end(const Intersection_curve& curve, int side) const
  {
    const Intersection_arc& arc = side == 0 || curve.is_closed ? curve.arcs.front() : curve.arcs.back();
    const std::vector<Curve_piece>& pieces = m_solutions.curves()[arc.index].pieces;
    const std::size_t i = (side == 0 || curve.is_closed) != arc.is_reversed ? pieces.front().ends[0] : pieces.back().ends[1];
    const Curve_vertex& vertex = m_solutions.vertices()[i];
    const auto has_it = [i](const Undecided_region& region) { return std::find(region.vertices.begin(), region.vertices.end(), i) != region.vertices.end(); };
    const bool is_pinch_point = std::find(m_pinch_points.begin(), m_pinch_points.end(), i) != m_pinch_points.end();
    const bool is_undecided = vertex.is_on_inequality || std::any_of(m_solutions.undecided().begin(), m_solutions.undecided().end(), has_it);
    return special_point(curve.is_closed                        ? Intersection_kind::TRANSVERSAL
                         : vertex.is_singular || is_pinch_point ? Intersection_kind::TANGENT
                         : is_undecided                         ? Intersection_kind::UNDECIDED
                                                                : Intersection_kind::END_POINT,
                         vertex.box);
  }

  /*!
  points along an arc, so many that the arc passes the middles of their chords at no more than a given distance, in space as well as in the parameters. Their parameters solve the equations up to rounding;
  see `to_polyline()`.
  \param arc an arc of one of the curves.
  \param error the distance in space; positive.
  \param parameter_error the distance in each of the domains; positive.
  \throws Invalid_input when a distance is not positive.
  */
  std::vector<Sample> samples(const Intersection_arc& arc, double error, double parameter_error = std::numeric_limits<double>::infinity()) const
  {
    if (!(error > 0) || !(parameter_error > 0))
      throw Invalid_input("Surface_intersection: the error must be positive");
    const auto is_chord = [&](const auto& from, const auto& sample, const auto& to) {
      using internal::distance_from_middle;
      return distance_from_middle(from.image, sample.image, to.image) <= error && distance_from_middle(from.unknowns, sample.unknowns, to.unknowns) <= parameter_error;
    };
    const auto point = [&](const std::vector<double>& unknowns) { return m_surfaces.point(unknowns); };
    std::vector<Sample> result;
    for (const auto& [unknowns, image] : internal::curve_samples(m_surfaces.system(), m_solutions, m_solutions.curves()[arc.index], point, is_chord))
      result.push_back({internal::kernel_object<Kernel, Point>(image), {parameters(0, unknowns), parameters(1, unknowns)}});
    if (arc.is_reversed)
      std::reverse(result.begin(), result.end());
    return result;
  }

  /*!
  points along a curve, so many that the curve passes the middles of their chords at no more than a given distance; a closed curve begins and ends with the same one.
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

  //! the curves as the solver found them: its unknowns are the parameters of the surfaces that have some, of the first one only, if both are height fields over the same coordinates; then, if they are needed, the coordinates in space.
  const Curve_solution_set_d& solutions() const { return m_solutions; }

  //! the equations that were solved, for `curve_differentials()` and `fit_spline()`. \pre The bounds of the surfaces meet, as they do if there is a curve.
  const Constraint_system_d& system() const
  {
    CGAL_precondition(m_surfaces.has_system());
    return m_surfaces.system();
  }

  //! the work.
  const Summary& summary() const { return m_summary; }

private:
  Special_point special_point(Intersection_kind kind, const Curve_vertex::Exact_box& box) const { return Special_point(m_surfaces, kind, box); }

  static Curve_vertex::Exact_box hull(const std::vector<Curve_vertex::Exact_box>& boxes)
  {
    Curve_vertex::Exact_box result = boxes.front();
    for (const Curve_vertex::Exact_box& box : boxes)
      for (std::size_t j = 0; j < box.size(); ++j)
        result[j] = {(std::min)(result[j].first, box[j].first), (std::max)(result[j].second, box[j].second)};
    return result;
  }

  std::array<double, 2> parameters(std::size_t surface, const std::vector<double>& unknowns) const
  {
    if (!m_surfaces.is_parametric(surface))
      return {};
    return {m_surfaces.parameter(surface, 0)(unknowns), m_surfaces.parameter(surface, 1)(unknowns)};
  }
};

//! \ingroup PkgSplineConstraintsDOperations
//! writes one line: the numbers of curves, singular points and undecided regions.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Surface_intersection<Kernel>& intersection)
{
  return internal::write_counts(out, intersection);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_INTERSECTION_H
