// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SURFACE_CURVES_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SURFACE_CURVES_3_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/Surface_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// What makes curves go on where the domain of a system ends: unknowns whose two ends are a seam, and faces that are one
// point in space.
struct Domain_joints
{
  std::vector<std::size_t> closed_unknowns;
  std::vector<Seam_joints::Face> poles;
};

} // namespace Surface_curves
} // namespace internal

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
  using Coordinates = std::array<double, 3>;
  using Point_of_unknowns = std::function<Coordinates(const std::vector<double>&)>;

  struct Part
  {
    Constraint_system_d system;
    Curve_solution_set_d solutions;
  };

  Point_of_unknowns m_point;
  std::vector<Part> m_parts;
  std::vector<Curve> m_curves;
  std::vector<Curve_vertex> m_points, m_singular_points;
  std::vector<Undecided_region> m_undecided;
  Summary m_summary;

public:
#ifndef DOXYGEN_RUNNING
  explicit Surface_curves_3(Point_of_unknowns point) : m_point(std::move(point)) {}

  // The curves of a part, and lines where a factor vanishes that the system does not have.
  void add(Constraint_system_d system, Curve_solution_set_d solutions,
           const internal::Surface_curves::Domain_joints& joints_of_domain,
           const std::vector<Surface_curve>& lines = {})
  {
    const std::size_t index = m_parts.size();
    m_parts.push_back({std::move(system), std::move(solutions)});
    const Curve_solution_set_d& set = m_parts.back().solutions;
    const internal::Intersections::Seam_joints joints(m_parts.back().system, set, joints_of_domain.closed_unknowns,
                                                      joints_of_domain.poles);
    for (Intersection_curve& curve : joints.curves()) {
      const int multiplicity = internal::Common::common_multiplicity(
          curve.arcs, [&](const Intersection_arc& arc) { return set.curves()[arc.index].multiplicity(); });
      m_curves.push_back({index, std::move(curve.arcs), curve.is_closed, {}, multiplicity});
    }
    add_special_points(set, joints, lines);
    m_undecided.insert(m_undecided.end(), set.undecided_regions().begin(), set.undecided_regions().end());
    m_summary.nodes += set.summary().nodes;
    m_summary.seconds += set.summary().seconds;
    for (const std::size_t i : joints.unmatched())
      m_undecided.push_back({{set.vertices()[i].box}, {i}, Undecided_reason::DOMAIN_BOUNDARY});
    m_summary.is_complete = m_summary.is_complete && set.is_complete() && joints.unmatched().empty();
    for (auto line = lines.begin(); line != lines.end(); ++line) {
      m_curves.push_back(*line);
      m_curves.back().part = index;
      for (auto other = lines.begin(); other != line; ++other)
        if (other->line->axis != line->line->axis)
          add_crossing(*other->line, *line->line);
    }
  }

  // A face of the last part that is one point in space and a solution: reported if no curve ends there. It is an
  // isolated solution, unless the face is on the edge of a surface.
  void add_pole(const Constant_parameter& pole, bool is_on_edge)
  {
    const Part& part = m_parts.back();
    const auto is_there = [&](std::size_t i) {
      return part.solutions.vertices()[i].box[static_cast<std::size_t>(pole.axis)] == std::pair(pole.value, pole.value);
    };
    const auto ends_there = [&](const Curve& curve) {
      return curve.part + 1 == m_parts.size() && curve.line && curve.line->axis != pole.axis;
    };
    if (std::any_of(m_curves.begin(), m_curves.end(), ends_there))
      return;
    for (const Solution_curve& curve : part.solutions.curves())
      for (const std::size_t i : curve.vertices())
        if (is_there(i))
          return;
    Curve_vertex vertex{{part.system.domain(0), part.system.domain(1)}, true, !is_on_edge, false};
    vertex.box[static_cast<std::size_t>(pole.axis)] = {pole.value, pole.value};
    for (std::vector<Curve_vertex>* list : {&m_points, &m_singular_points})   // zeros of what is left of the equation
      std::erase_if(*list, [&](const Curve_vertex& other) { return is_on(pole, other); });
    (is_on_edge ? m_points : m_singular_points).push_back(std::move(vertex));
  }

  // A part where nothing but solutions is found.
  void add_undecided(const Curve_vertex::Exact_box& box)
  {
    m_undecided.push_back({{box}, {}, Undecided_reason::CONTINUUM});
    m_summary.is_complete = false;
  }
#endif

  //! the curves, one part of the domain after the other.
  const std::vector<Curve>& curves() const { return m_curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_curves); }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_curves.size() - number_of_closed_curves(); }

  //! where curves cross, and isolated solutions, in the domain of the unknowns. Where a curve with a
  //! `Surface_curve::line` meets others, none of them ends.
  const std::vector<Curve_vertex>& singular_points() const { return m_singular_points; }

  //! single points: solutions on the edge of a part that no other one of the part is near, since a curve only touches
  //! it from outside.
  const std::vector<Curve_vertex>& points() const { return m_points; }

  //! where nothing is proved, in the domain of the unknowns.
  const std::vector<Undecided_region>& undecided() const { return m_undecided; }

  //! whether these are all solutions, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }

  //! the curves of a part in the domain of its unknowns, as the solver found them.
  const Curve_solution_set_d& solutions(std::size_t part) const { return m_parts[part].solutions; }

  //! the point where the unknowns have these values; values outside of the domain are moved to its boundary.
  Point point(const std::vector<double>& unknowns) const
  {
    return internal::kernel_object<Kernel, Point>(m_point(unknowns));
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
    internal::check_error(error, "Surface_curves_3");
    const Part& part = m_parts[curve.part];
    const auto is_chord = [&](const auto& from, const auto& sample, const auto& to) {
      return internal::distance_from_middle(from.image, sample.image, to.image) <= error;
    };
    std::vector<Sample> result;
    const auto append = [&](const auto& samples) {
      for (const auto& [unknowns, image] : samples)
        result.push_back({internal::kernel_object<Kernel, Point>(image), unknowns});
    };
    if (curve.line)
      append(line_samples(part.system, *curve.line, is_chord));
    for (const Intersection_arc& arc : curve.arcs) {
      auto samples =
          internal::curve_samples(part.system, part.solutions, part.solutions.curves()[arc.index], m_point, is_chord);
      if (arc.is_reversed)
        std::reverse(samples.begin(), samples.end());
      append(samples);
    }
    if (curve.is_closed)
      result.back().point = result.front().point;
    return result;
  }

private:
  static bool is_on(const Constant_parameter& line, const Curve_vertex& vertex)
  {
    const auto& [lower, upper] = vertex.box[static_cast<std::size_t>(line.axis)];
    return lower == line.value && upper == line.value;
  }

  // The single and the singular points of a part, each once, though a seam has two sides. On a line another factor of
  // the equation is zero: solutions there are singular points.
  void add_special_points(const Curve_solution_set_d& set, const internal::Intersections::Seam_joints& joints,
                          const std::vector<Surface_curve>& lines)
  {
    std::vector<std::size_t> singular = set.singular_points();
    std::vector<bool> is_on_line(set.vertices().size(), false);   // of representatives
    const auto is_on_a_line = [&](const Curve_vertex& vertex) {
      return std::any_of(lines.begin(), lines.end(),
                         [&](const Surface_curve& line) { return is_on(*line.line, vertex); });
    };
    for (std::size_t i = 0; i < set.vertices().size(); ++i)
      if (is_on_a_line(set.vertices()[i])) {
        singular.push_back(i);
        is_on_line[joints.representative(i)] = true;
      }
    for (const std::size_t i : joints.points())
      if (!is_on_line[joints.representative(i)])
        m_points.push_back(set.vertices()[i]);
    for (const std::size_t i : joints.without_repetitions(singular))
      m_singular_points.push_back(set.vertices()[i]);
  }

  // Where two lines cross, unless other curves pass there too, so that it is known.
  void add_crossing(const Constant_parameter& a, const Constant_parameter& b)
  {
    Curve_vertex vertex{Curve_vertex::Exact_box(2), true, true, false};
    for (const Constant_parameter& line : {a, b})
      vertex.box[static_cast<std::size_t>(line.axis)] = {line.value, line.value};
    const auto is_it = [&](const Curve_vertex& known) { return known.box == vertex.box; };
    if (std::none_of(m_singular_points.begin(), m_singular_points.end(), is_it))
      m_singular_points.push_back(std::move(vertex));
  }

  template <class Is_chord>
  auto line_samples(const Constraint_system_d& system, const Constant_parameter& line, const Is_chord& is_chord) const
  {
    constexpr int pieces = 16;
    const auto axis = static_cast<std::size_t>(1 - line.axis);
    const double first = CGAL::to_double(system.domain(1 - line.axis).first),
                 last = CGAL::to_double(system.domain(1 - line.axis).second);
    const auto at = [&](double t) {
      std::vector<double> unknowns(2, CGAL::to_double(line.value));
      unknowns[axis] = t;
      return internal::Curve_sample<decltype(m_point(unknowns))>{unknowns, m_point(unknowns)};
    };
    const auto between = [&](const auto& from, const auto& to) {
      return at(from.unknowns[axis] / 2 + to.unknowns[axis] / 2);
    };
    std::vector result{at(first)};
    for (int i = 1; i <= pieces; ++i)
      internal::Common::append_samples(result, at(first + (last - first) * i / pieces), between, is_chord, {0, 48});
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
