// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FOUND_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FOUND_INTERSECTION_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_kind.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/surface_shapes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

class Constraint_system_d;

namespace internal {
namespace Intersections {

struct Solved_part;

// A vertex of the solutions of one of several parts.
struct Part_vertex
{
  std::size_t part, vertex;

  friend bool operator==(const Part_vertex&, const Part_vertex&) = default;
};

// A point that two surfaces have in common, with what is known of its parameters.
struct Common_surface_point
{
  using Range = std::pair<Exact_rational, Exact_rational>;

  Intersection_kind kind;
  std::array<Exact_rational, 3> point;        // in the middle of the ranges
  std::array<std::vector<Range>, 2> ranges{}; // of parametric surfaces
  std::array<std::array<double, 2>, 2> parameters{};
  std::array<std::array<bool, 2>, 2> is_at_end{};
};

// A point of a polyline, and its parameters on the surfaces that have some.
struct Common_surface_sample
{
  std::array<double, 3> point;
  std::array<std::optional<std::array<double, 2>>, 2> parameters;
};

// What two surfaces have in common, for those of all kernels.
struct Found_intersection
{
  std::shared_ptr<const std::vector<Solved_part>> parts; // the equations and their solutions
  std::vector<Intersection_curve> curves = {};
  std::vector<Common_surface_point> points = {}, singular_points = {};
  std::vector<Part_vertex> pinch_points = {}, unmatched = {};
  Summary summary = {};
  std::string reason_of_stop = {}; // of a run that the operation ended itself
};

// The curves that two surfaces have in common; defined in found_intersections.h, as all that follows.
Found_intersection intersection_of(const Shape& first, const Shape& second, const Solver_options& options);

// The first (0) or last (1) point of a curve.
Common_surface_point end_of_curve(const Found_intersection& found, const Intersection_curve& curve, int side);

// Points along an arc, whose chords are so near to it in space, and in the parameters if that is asked for.
std::vector<Common_surface_sample> samples_of_arc(const Found_intersection& found, const Intersection_arc& arc,
                                                  double error, std::optional<double> parameter_error);

// What is undecided: as points in the middles of regions, and as parts of the answer.
std::vector<Common_surface_point> undecided_points_of(const Found_intersection& found);
std::vector<Undecided_part> undecided_parts_of(const Found_intersection& found);

// One of the systems that were solved.
std::size_t number_of_parts_of(const Found_intersection& found);
const Curve_solution_set_d& solutions_of_part(const Found_intersection& found, std::size_t part);
const Constraint_system_d& system_of_part(const Found_intersection& found, std::size_t part);

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FOUND_INTERSECTION_H
