// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_CURVE_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_CURVE_FINDERS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Found_intersection.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Silhouette_event_kind.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Found_surface_curves.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// A bounded surface: a model of `ParametricSurface_3` or an object of CGAL that is converted to one.
template <class Surface>
concept Surface_operand =
    Intersection_operand<Surface>::is_bounded && Intersection_operand<Surface>::number_of_parameters == 2 &&
    Intersection_operand<Surface>::dimension == 3;

template <class Surface>
using Operand_kernel = typename Intersection_operand<Surface>::Kernel;

using Exact_triple = std::array<Exact_rational, 3>;

// A point or vector of a kernel.
template <class Object>
Exact_triple exact_triple(const Object& object)
{
  const auto exact = exact_object(object);
  return {exact.x(), exact.y(), exact.z()};
}

// Where a surface meets itself; defined in self_intersections_of_surface.h.
Found_intersection self_intersection_of(const Exact_map<3>& surface, const Solver_options& options);

// Where the tangent planes of a surface contain a point with the homogeneous coordinates of the eye, where its Gaussian
// curvature is zero, and where its points have inner products with a vector that are these levels; defined in
// zeros_on_surface.h.
Found_surface_curves silhouettes_of(const Exact_map<3>& surface, const std::array<Exact_rational, 4>& eye,
                                    const Solver_options& options);
Found_surface_curves parabolic_lines_of(const Exact_map<3>& surface, const Solver_options& options);
std::vector<Found_surface_curves> plane_sections_of(const Exact_map<3>& surface, const Exact_triple& direction,
                                                    const std::vector<Exact_rational>& levels,
                                                    const Solver_options& options);

// The silhouettes of what a surface sweeps, moved along a path, with its axes if there are three; defined in
// silhouettes_of_sweep.h.
std::vector<Found_surface_curves> sweep_silhouettes_of(const Exact_map<3>& surface, const Exact_map<3>& path,
                                                       const std::vector<Exact_map<3>>& axes,
                                                       const std::vector<Exact_triple>& eyes,
                                                       const Solver_options& options);

// The directions of a tool, see `Tool_axis`.
struct Exact_tool_axis
{
  std::optional<Exact_triple> direction, hemisphere;
  std::optional<Exact_map<3>> field;
  Exact_rational radius = 0;
};

// Where rays along the axis of a tool only touch a surface or a sphere; defined in Access_boundaries.h.
Found_surface_curves access_boundaries_of(const Exact_map<3>& surface, const Exact_map<3>& check,
                                          const Exact_tool_axis& axis, const Solver_options& options);
Found_surface_curves access_boundaries_of(const Exact_map<3>& surface, const Exact_triple& center,
                                          const Exact_rational& squared_radius, const Exact_tool_axis& axis,
                                          const Solver_options& options);

// The umbilics of a surface; defined in Umbilic_finder.h.
struct Found_umbilics
{
  std::vector<std::pair<std::array<double, 3>, Solution_d<double>>> points = {};
  std::vector<Undecided_part> undecided = {};
  Summary summary = {};
};
Found_umbilics umbilics_of(const Exact_map<3>& surface, const Solver_options& options);

// Where and when silhouettes change while the eye moves along a path, or a direction does; defined in
// Silhouette_event_finder.h.
struct Found_silhouette_events
{
  struct Event
  {
    Silhouette_event_kind kind;
    std::vector<std::pair<Exact_rational, Exact_rational>> box;   // parameters and, at last, the time
    std::array<double, 3> point;
  };
  std::vector<Event> events = {};
  std::pair<Exact_rational, Exact_rational> times = {};
  std::vector<std::pair<std::vector<std::pair<Exact_rational, Exact_rational>>, Undecided_reason>> undecided_boxes = {};
  std::vector<Undecided_part> undecided = {};
  Summary summary = {};
};
Found_silhouette_events silhouette_events_of(const Exact_map<3>& surface, const Exact_map<3>& path, bool is_parallel,
                                             const Solver_options& options);

// The same of what a surface sweeps, with the path of the eye at last; defined in Sweep_event_finder.h.
Found_silhouette_events sweep_silhouette_events_of(const Exact_map<3>& surface, const Exact_map<3>& path,
                                                   const std::vector<Exact_map<3>>& axes, const Exact_map<3>& eye,
                                                   const Solver_options& options);

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_CURVE_FINDERS_H
