// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FOUND_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FOUND_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/hull_of_region.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Found_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Joined_parts.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Solved_part.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/common_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/primitives/Rounded_primitives.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A common point of two surfaces in a box of the unknowns.
inline Common_surface_point common_surface_point(const Surface_equations& surfaces, Intersection_kind kind,
                                                 const Curve_vertex::Exact_box& box)
{
  std::vector<Exact_rational> middle;
  for (const Parameter_range& range : box)
    middle.push_back(middle_of(range));
  Common_surface_point result{kind, surfaces.point(middle)};
  for (std::size_t surface = 0; surface < 2; ++surface) {
    if (!surfaces.is_parametric(surface))
      continue;
    std::vector<double> unknowns;
    for (const Exact_rational& x : middle)
      unknowns.push_back(to_nearest_double(x));
    result.parameters[surface] = surfaces.parameters(surface, unknowns);
    for (const Parameter_range& range : surfaces.parameter_ranges(surface, box)) {
      std::vector<Parameter_range>& ranges = result.ranges[surface];
      const Parameter_range domain = surfaces.parameter_domain(surface, static_cast<int>(ranges.size()));
      result.is_at_end[surface][ranges.size()] =
          range.first == range.second && (range.first == domain.first || range.first == domain.second);
      ranges.push_back(range);
    }
  }
  return result;
}

inline Common_surface_point common_surface_point(const std::vector<Solved_part>& parts, Intersection_kind kind,
                                                 const Part_vertex& point)
{
  const Solved_part& part = parts[point.part];
  return common_surface_point(part.surfaces, kind, part.solutions.vertices()[point.vertex].box);
}

// Joins the curves of one part at least. If that has no system, the surfaces have nothing in common.
inline Found_intersection found_intersection(std::vector<Solved_part> solved)
{
  Found_intersection result{std::make_shared<const std::vector<Solved_part>>(std::move(solved))};
  const std::vector<Solved_part>& parts = *result.parts;
  for (const Solved_part& part : parts)
    result.summary += part.solutions.summary();
  if (!parts.front().surfaces.has_system())
    return result;
  Joined_curves joined = joined_curves(parts);
  result.curves = std::move(joined.curves);
  for (Intersection_curve& curve : result.curves)
    curve.multiplicity = common_multiplicity(curve.arcs, [&](const Intersection_arc& arc) {
      return parts[arc.part].solutions.curves()[arc.index].multiplicity();
    });
  result.pinch_points = std::move(joined.equal_pairs);
  result.unmatched = std::move(joined.unmatched);
  const auto add = [&](std::vector<Common_surface_point>& list, Intersection_kind kind,
                       const std::vector<Part_vertex>& vertices) {
    for (const Part_vertex& point : vertices)
      list.push_back(common_surface_point(parts, kind, point));
  };
  add(result.points, Intersection_kind::END_POINT, joined.points);
  add(result.singular_points, Intersection_kind::TANGENT, joined.singular_points);
  add(result.singular_points, Intersection_kind::TANGENT, result.pinch_points);
  result.summary.is_complete = result.summary.is_complete && result.unmatched.empty();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_intersection intersection_of(const Shape& first, const Shape& second,
                                                                  const Solver_options& options)
{
  Rounded_primitives watch(*first, *second, options);
  Solver_options watched = options;
  watched.visitor = watch;
  Operation_budget budget(watched);
  Found_intersection result = found_intersection({common_curves(Surface_equations(*first, *second), budget)});
  result.reason_of_stop = watch.reason();
  if (!result.reason_of_stop.empty() && result.summary.why_not == Undecided_reason::STOPPED)
    result.summary.why_not = Undecided_reason::CONTINUUM;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Common_surface_point end_of_curve(const Found_intersection& found,
                                                                 const Intersection_curve& curve, int side)
{
  const std::vector<Solved_part>& parts = *found.parts;
  const Intersection_arc& arc = side == 0 || curve.is_closed ? curve.arcs.front() : curve.arcs.back();
  const Curve_solution_set_d& set = parts[arc.part].solutions;
  const std::vector<Curve_piece>& pieces = set.curves()[arc.index].pieces;
  const Part_vertex end{
      arc.part, (side == 0 || curve.is_closed) != arc.is_reversed ? pieces.front().ends[0] : pieces.back().ends[1]};
  const Curve_vertex& vertex = set.vertices()[end.vertex];
  const auto has_it = [&](const Undecided_region& region) {
    return std::find(region.vertices.begin(), region.vertices.end(), end.vertex) != region.vertices.end();
  };
  const auto is_one_of = [&](const std::vector<Part_vertex>& points) {
    return std::find(points.begin(), points.end(), end) != points.end();
  };
  const bool is_undecided = (vertex.is_on_inequality && !parts[arc.part].surfaces.has_edges_on_inequalities()) ||
      is_one_of(found.unmatched) || std::any_of(set.undecided_regions().begin(), set.undecided_regions().end(), has_it);
  return common_surface_point(parts,
                              curve.is_closed                                           ? curve.kind()
                                  : vertex.is_singular || is_one_of(found.pinch_points) ? Intersection_kind::TANGENT
                                  : is_undecided                                        ? Intersection_kind::UNDECIDED
                                                                                        : Intersection_kind::END_POINT,
                              end);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Common_surface_sample> samples_of_arc(const Found_intersection& found,
                                                                                 const Intersection_arc& arc,
                                                                                 double error,
                                                                                 std::optional<double> parameter_error)
{
  if (!(error > 0) || (parameter_error && !(*parameter_error > 0)))
    throw Invalid_input("Surface_intersection: the error must be positive");
  const auto is_chord = [&](const auto& from, const auto& sample, const auto& to) {
    return distance_from_middle(from.image, sample.image, to.image) <= error &&
        (!parameter_error || distance_from_middle(from.unknowns, sample.unknowns, to.unknowns) <= *parameter_error);
  };
  const auto& [surfaces, set, poles, is_overlap] = (*found.parts)[arc.part];
  const auto point = [&surfaces = surfaces](const std::vector<double>& unknowns) { return surfaces.point(unknowns); };
  const auto parameters = [&surfaces = surfaces](std::size_t surface, const std::vector<double>& unknowns) {
    return surfaces.is_parametric(surface) ? std::optional(surfaces.parameters(surface, unknowns)) : std::nullopt;
  };
  std::vector<Common_surface_sample> result;
  for (const auto& [unknowns, image] : curve_samples(surfaces.system(), set, set.curves()[arc.index], point, is_chord))
    result.push_back({image, {parameters(0, unknowns), parameters(1, unknowns)}});
  if (arc.is_reversed)
    std::reverse(result.begin(), result.end());
  return result;
}

// Calls a function with the equations, the box and the reason of each part that is undecided.
template <class Function>
void for_each_undecided_box(const Found_intersection& found, const Function& function)
{
  for (const Solved_part& part : *found.parts)
    for (const Undecided_region& region : part.solutions.undecided_regions())
      function(part.surfaces, hull_of(region), region.reason);
  for (const Part_vertex& point : found.unmatched) {
    const Solved_part& part = (*found.parts)[point.part];
    function(part.surfaces, part.solutions.vertices()[point.vertex].box, Undecided_reason::DOMAIN_BOUNDARY);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Common_surface_point> undecided_points_of(const Found_intersection& found)
{
  std::vector<Common_surface_point> result;
  for_each_undecided_box(found, [&](const Surface_equations& surfaces, const Curve_vertex::Exact_box& box, auto) {
    result.push_back(common_surface_point(surfaces, Intersection_kind::UNDECIDED, box));
  });
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Undecided_part> undecided_parts_of(const Found_intersection& found)
{
  std::vector<Undecided_part> result;
  const bool is_overlap = found.parts->front().is_overlap;
  for_each_undecided_box(
      found, [&](const Surface_equations& surfaces, const Curve_vertex::Exact_box& box, Undecided_reason reason) {
        const bool is_stopped = reason == Undecided_reason::STOPPED && !found.reason_of_stop.empty();
        Undecided_part part{double_ranges(surfaces.values(box)),
                            {},
                            is_overlap       ? "the surfaces overlap"
                                : is_stopped ? found.reason_of_stop
                                             : in_words(reason)};
        for (std::size_t surface = 0; surface < 2; ++surface)
          if (surfaces.is_parametric(surface))
            part.parameters.push_back({surface, double_ranges(surfaces.parameter_ranges(surface, box))});
        result.push_back(std::move(part));
      });
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t number_of_parts_of(const Found_intersection& found)
{
  return found.parts->size();
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Curve_solution_set_d& solutions_of_part(const Found_intersection& found,
                                                                             std::size_t part)
{
  return (*found.parts)[part].solutions;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Constraint_system_d& system_of_part(const Found_intersection& found,
                                                                         std::size_t part)
{
  CGAL_precondition((*found.parts)[part].surfaces.has_system());
  return (*found.parts)[part].surfaces.system();
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FOUND_INTERSECTIONS_H
