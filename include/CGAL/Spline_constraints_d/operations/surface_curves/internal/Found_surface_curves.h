// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_FOUND_SURFACE_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_FOUND_SURFACE_CURVES_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Surface_curve.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

class Constraint_system_d;

namespace internal {
namespace Surface_curves {

// What unknowns are in space.
struct Place_of_unknowns
{
  std::function<std::array<double, 3>(const std::vector<double>&)> point;
  // ranges of the coordinates of all points with unknowns in a box
  std::function<std::vector<Undecided_part::Range>(const Curve_vertex::Exact_box&)> bounds;
  // per operand, how many of the unknowns are its parameters: those of the first one come first
  std::vector<std::size_t> parameters;
};

// A system and its solutions, complete in Surface_curve_collector.h.
struct Surface_curve_part;

// Curves on a surface, for those of all kernels.
struct Found_surface_curves
{
  Place_of_unknowns place;
  std::shared_ptr<std::vector<Surface_curve_part>> parts = {};
  std::vector<Surface_curve> curves = {};
  std::vector<Curve_vertex> points = {}, singular_points = {};
  std::vector<Undecided_region> undecided = {};
  Summary summary = {};
};

// Points along a curve with the unknowns that they belong to, whose chords are so near to it; defined in
// Surface_curve_collector.h, as what follows.
std::vector<std::pair<std::array<double, 3>, std::vector<double>>>
samples_of_curve(const Found_surface_curves& found, const Surface_curve& curve, double error);

// The curves of a part as the solver found them, and the system.
const Curve_solution_set_d& solutions_of_part(const Found_surface_curves& found, std::size_t part);
const Constraint_system_d& system_of_part(const Found_surface_curves& found, std::size_t part);

// The regions with their places in space.
std::vector<Undecided_part> undecided_parts_of(const Found_surface_curves& found);

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_FOUND_SURFACE_CURVES_H
