// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_RATIONAL_BISECTORS_OF_MAPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_RATIONAL_BISECTORS_OF_MAPS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Found_surface_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

using Bisector_range = Rational_bisector_piece_3::Range;

// Defined in rational_bisector_pieces.h; the compiled library has them.
Rational_bisector_3 point_surface_bisector(const Exact_map<3>& point, const Exact_map<3>& surface,
                                           const Solver_options& options);
Rational_bisector_3 sphere_surface_bisector(const Exact_map<3>& center, const Exact_rational& radius,
                                            const Exact_map<3>& surface, const Solver_options& options);
Rational_bisector_3 point_curve_bisector(const Exact_map<3>& point, const Exact_map<3>& curve,
                                         const Bisector_range& lambda, const Solver_options& options);
Rational_bisector_3 curve_bisector(const Exact_map<3>& first, const Exact_map<3>& second,
                                   const Solver_options& options);

// A polynomial on the unit box of a piece.
using Function_of_piece = std::function<Bernstein_tensor<Exact_rational>(const Rational_bisector_piece_3&)>;

// The zeros of functions of all pieces, for each part of the bisector that is continuous; defined in
// zeros_on_bisector.h.
std::vector<Found_surface_curves> zeros_on_bisector(const Rational_bisector_3& bisector,
                                                    const Function_of_piece& function, const Solver_options& options);

// A sphere that bisectors are cut at.
struct Reach
{
  Rational_bisector_3::Kernel::Point_3 center;
  Exact_rational squared_radius;
};

// Defined in parts_of_bisector.h.
std::vector<Trimmed_surface_3> parts_of_bisector(const Rational_bisector_3& bisector, const std::optional<Reach>& reach,
                                                 const Solver_options& options);
// A sphere whose radius has a sign, see `sphere_surface_bisector()`; a point for the radius zero.
struct Oriented_sphere
{
  Rational_bisector_3::Kernel::Point_3 center;
  Exact_rational radius;
};

// With the labels NEAREST and NOT_NEAREST; defined in trimmed_sphere_bisector.h.
std::vector<Trimmed_surface_3> trimmed_sphere_bisector(const Oriented_sphere& sphere, const Exact_map<3>& surface,
                                                       const Rational_bisector_3& bisector, const Reach& reach,
                                                       const Solver_options& options);
Bisector_mesh_3 mesh_of_bisector(const Rational_bisector_3& bisector, const Trimmed_surface_3& part, int label,
                                 double error, const Solver_options& options);

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_RATIONAL_BISECTORS_OF_MAPS_H
