// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_CURVE_COLLECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_CURVE_COLLECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/Surface_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/hull_of_region.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Found_surface_curves.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

struct Surface_curve_part
{
  Constraint_system_d system;
  Curve_solution_set_d solutions;
};

// What makes curves go on where the domain of a system ends: unknowns whose two ends are a seam, and faces that are one
// point in space.
struct Domain_joints
{
  std::vector<std::size_t> closed_unknowns;
  std::vector<Seam_joints::Face> poles;
};

// Joins the curves of parts, one after the other.
class Surface_curve_collector
{
  Found_surface_curves m_found;

public:
  explicit Surface_curve_collector(Place_of_unknowns place)
    : m_found{std::move(place), std::make_shared<std::vector<Surface_curve_part>>()}
  {}

  const Found_surface_curves& found() const { return m_found; }

  // The curves of a part, and lines where a factor vanishes that the system does not have.
  void add(Constraint_system_d system, Curve_solution_set_d solutions, const Domain_joints& joints_of_domain,
           const std::vector<Surface_curve>& lines = {});

  // A face of the last part that is one point in space and a solution: reported if no curve ends there. It is an
  // isolated solution, unless the face is on the edge of a surface.
  void add_pole(const Constant_parameter& pole, bool is_on_edge);

  // A part where nothing but solutions is found, or none are looked for.
  void add_undecided(const Curve_vertex::Exact_box& box, Undecided_reason reason = Undecided_reason::CONTINUUM)
  {
    m_found.undecided.push_back({{box}, {}, reason});
    m_found.summary.is_complete = false;
  }

private:
  static bool is_on(const Constant_parameter& line, const Curve_vertex& vertex)
  {
    const auto& [lower, upper] = vertex.box[static_cast<std::size_t>(line.axis)];
    return lower == line.value && upper == line.value;
  }

  // The single and the singular points of a part, each once, though a seam has two sides. On a line another factor of
  // the equation is zero: solutions there are singular points.
  void add_special_points(const Curve_solution_set_d& set, const Seam_joints& joints,
                          const std::vector<Surface_curve>& lines);

  // Where two lines cross, unless other curves pass there too, so that it is known.
  void add_crossing(const Constant_parameter& a, const Constant_parameter& b);
};

// Samples along a line where a parameter is constant.
template <class Point_of, class Is_chord>
auto line_samples(const Constraint_system_d& system, const Constant_parameter& line, const Point_of& point_of,
                  const Is_chord& is_chord)
{
  constexpr int pieces = 16;
  const auto axis = static_cast<std::size_t>(1 - line.axis);
  const double first = CGAL::to_double(system.domain(1 - line.axis).first),
               last = CGAL::to_double(system.domain(1 - line.axis).second);
  const auto at = [&](double t) {
    std::vector<double> unknowns(2, CGAL::to_double(line.value));
    unknowns[axis] = t;
    return Curve_sample<std::array<double, 3>>{unknowns, point_of(unknowns)};
  };
  const auto between = [&](const auto& from, const auto& to) {
    return at(from.unknowns[axis] / 2 + to.unknowns[axis] / 2);
  };
  std::vector result{at(first)};
  for (int i = 1; i <= pieces; ++i)
    append_samples(result, at(first + (last - first) * i / pieces), between, is_chord, {0, 48});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<std::array<double, 3>, std::vector<double>>>
samples_of_curve(const Found_surface_curves& found, const Surface_curve& curve, double error)
{
  check_error(error, "Surface_curves_3");
  const Surface_curve_part& part = (*found.parts)[curve.part];
  const auto is_chord = [&](const auto& from, const auto& sample, const auto& to) {
    return distance_from_middle(from.image, sample.image, to.image) <= error;
  };
  std::vector<std::pair<std::array<double, 3>, std::vector<double>>> result;
  const auto append = [&](const auto& samples) {
    for (const auto& [unknowns, image] : samples)
      result.emplace_back(image, unknowns);
  };
  if (curve.line)
    append(line_samples(part.system, *curve.line, found.place.point, is_chord));
  for (const Intersection_arc& arc : curve.arcs) {
    auto samples =
        curve_samples(part.system, part.solutions, part.solutions.curves()[arc.index], found.place.point, is_chord);
    if (arc.is_reversed)
      std::reverse(samples.begin(), samples.end());
    append(samples);
  }
  if (curve.is_closed)
    result.back().first = result.front().first;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Curve_solution_set_d& solutions_of_part(const Found_surface_curves& found,
                                                                             std::size_t part)
{
  return (*found.parts)[part].solutions;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Constraint_system_d& system_of_part(const Found_surface_curves& found,
                                                                         std::size_t part)
{
  return (*found.parts)[part].system;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Undecided_part> undecided_parts_of(const Found_surface_curves& found)
{
  std::vector<Undecided_part> result;
  for (const Undecided_region& region : found.undecided) {
    const std::vector<Undecided_part::Range> ranges = ranges_of(region);
    Undecided_part part{found.place.bounds(hull_of(region)), {}, in_words(region.reason)};
    std::size_t first = 0;
    for (std::size_t operand = 0; operand < found.place.parameters.size(); ++operand) {
      const std::size_t last = first + found.place.parameters[operand];
      if (last <= ranges.size())
        part.parameters.push_back({operand,
                                   {ranges.begin() + static_cast<std::ptrdiff_t>(first),
                                    ranges.begin() + static_cast<std::ptrdiff_t>(last)}});
      first = last;
    }
    result.push_back(std::move(part));
  }
  return result;
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_curve_collector::add(Constraint_system_d system,
                                                                 Curve_solution_set_d solutions,
                                                                 const Domain_joints& joints_of_domain,
                                                                 const std::vector<Surface_curve>& lines)
{
  const std::size_t index = (*m_found.parts).size();
  (*m_found.parts).push_back({std::move(system), std::move(solutions)});
  const Curve_solution_set_d& set = (*m_found.parts).back().solutions;
  const Seam_joints joints((*m_found.parts).back().system, set, joints_of_domain.closed_unknowns,
                           joints_of_domain.poles);
  for (Intersection_curve& curve : joints.curves()) {
    const int multiplicity = common_multiplicity(
        curve.arcs, [&](const Intersection_arc& arc) { return set.curves()[arc.index].multiplicity(); });
    m_found.curves.push_back({index, std::move(curve.arcs), curve.is_closed, {}, multiplicity});
  }
  add_special_points(set, joints, lines);
  m_found.undecided.insert(m_found.undecided.end(), set.undecided_regions().begin(), set.undecided_regions().end());
  for (const std::size_t i : joints.unmatched())
    m_found.undecided.push_back({{set.vertices()[i].box}, {i}, Undecided_reason::DOMAIN_BOUNDARY});
  m_found.summary += set.summary();
  m_found.summary.is_complete = m_found.summary.is_complete && joints.unmatched().empty();
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    m_found.curves.push_back(*line);
    m_found.curves.back().part = index;
    for (auto other = lines.begin(); other != line; ++other)
      if (other->line->axis != line->line->axis)
        add_crossing(*other->line, *line->line);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_curve_collector::add_pole(const Constant_parameter& pole, bool is_on_edge)
{
  const Surface_curve_part& part = (*m_found.parts).back();
  const auto is_there = [&](std::size_t i) {
    return part.solutions.vertices()[i].box[static_cast<std::size_t>(pole.axis)] == std::pair(pole.value, pole.value);
  };
  const auto ends_there = [&](const Surface_curve& curve) {
    return curve.part + 1 == (*m_found.parts).size() && curve.line && curve.line->axis != pole.axis;
  };
  if (std::any_of(m_found.curves.begin(), m_found.curves.end(), ends_there))
    return;
  for (const Solution_curve& curve : part.solutions.curves())
    for (const std::size_t i : curve.vertices())
      if (is_there(i))
        return;
  Curve_vertex vertex{{part.system.domain(0), part.system.domain(1)}, true, !is_on_edge, false};
  vertex.box[static_cast<std::size_t>(pole.axis)] = {pole.value, pole.value};
  // zeros of what is left of the equation
  for (std::vector<Curve_vertex>* list : {&m_found.points, &m_found.singular_points})
    std::erase_if(*list, [&](const Curve_vertex& other) { return is_on(pole, other); });
  (is_on_edge ? m_found.points : m_found.singular_points).push_back(std::move(vertex));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_curve_collector::add_special_points(const Curve_solution_set_d& set,
                                                                                const Seam_joints& joints,
                                                                                const std::vector<Surface_curve>& lines)
{
  std::vector<std::size_t> singular = set.singular_points();
  std::vector<bool> is_on_line(set.vertices().size(), false); // of representatives
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
      m_found.points.push_back(set.vertices()[i]);
  for (const std::size_t i : joints.without_repetitions(singular))
    m_found.singular_points.push_back(set.vertices()[i]);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_curve_collector::add_crossing(const Constant_parameter& a,
                                                                          const Constant_parameter& b)
{
  Curve_vertex vertex{Curve_vertex::Exact_box(2), true, true, false};
  for (const Constant_parameter& line : {a, b})
    vertex.box[static_cast<std::size_t>(line.axis)] = {line.value, line.value};
  const auto is_it = [&](const Curve_vertex& known) { return known.box == vertex.box; };
  if (std::none_of(m_found.singular_points.begin(), m_found.singular_points.end(), is_it))
    m_found.singular_points.push_back(std::move(vertex));
}
#endif

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_CURVE_COLLECTOR_H
