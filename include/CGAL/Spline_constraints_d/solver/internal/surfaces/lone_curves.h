// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LONE_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LONE_CURVES_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Face_equation.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The sign of a polynomial on a box, where it is certain.
inline CGAL::Uncertain<CGAL::Sign> sign_on(const Power_polynomial& polynomial, const Exact_ranges& ranges)
{
  const Mpfr_precision_scope precision(128);
  std::vector<Mpfr_interval> box;
  for (const auto& [lower, upper] : ranges)
    box.emplace_back(lower, upper);
  return polynomial.value(std::span<const Mpfr_interval>(box)).sign();
}

// At a point.
inline bool vanishes_at(const Power_polynomial& polynomial, const Exact_ranges& place)
{
  std::vector<Exact_rational> point;
  for (const auto& [value, same] : place)
    point.push_back(value);
  return CGAL::is_zero(polynomial(point));
}

// Faces of the domain, by an unknown and its value each. Surfaces only touch all of them, from outside, where a
// polynomial is positive; points at which it is zero are ends of such curves.
struct Lone_part
{
  std::vector<std::pair<int, Exact_rational>> faces;
  Power_polynomial outside;

  bool has(const Plane_point& point) const
  {
    return std::all_of(faces.begin(), faces.end(),
                       [&](const auto& face) {
                         const auto axis = static_cast<std::size_t>(face.first);
                         return point.is_fixed[axis] && point.box[axis].first == face.second;
                       }) &&
        CGAL::certainly(sign_on(outside, point.box) != CGAL::NEGATIVE);
  }
};

// Curves in faces of the domain, where solutions have the values of the faces, exactly.
inline Curve_solution_set_d moved_to_faces(const Curve_solution_set_d& found,
                                           const std::vector<std::pair<int, Exact_rational>>& faces)
{
  std::vector<Curve_vertex> vertices = found.vertices();
  std::vector<Solution_curve> curves = found.curves();
  for (const auto& [axis, value] : faces) {
    for (Curve_vertex& vertex : vertices)
      vertex.box[axis] = {value, value};
    for (Solution_curve& curve : curves)
      for (Curve_piece& piece : curve.pieces)
        piece.box[axis] = {value, value};
  }
  return {std::move(vertices),     std::move(curves),         found.points(),
          found.singular_points(), found.undecided_regions(), found.summary()};
}

/*
The curves of solutions of equalities on faces of the domain where a polynomial is not negative; none where it is a
constant that is. There is one equality less than unknowns, less one for each face.
*/
template <class Concurrency_tag>
std::optional<Curve_solution_set_d> curves_on_faces(Constraint_system_d system, const Lone_part& part,
                                                    const Solver_options& options, Run_control& control)
{
  if (!part.outside.is_constant())
    system.add(part.outside, Relation::GREATER_EQUAL);
  else if (CGAL::is_negative(part.outside.constant_term()))
    return std::nullopt;
  for (const auto& [axis, value] : part.faces) {
    system.add(Spline_function(), Relation::EQUAL); // in the place of which the equality of the face comes
    system = *system_on_face(system, {system.equalities().size() - 1, axis, value});
  }
  Curve_solution_set_d result =
      moved_to_faces(all_curves<Certified_solver_traits, Concurrency_tag>(system, options, control, {}), part.faces);
  // single points at which the polynomial is zero are on surfaces beside
  const bool has_solutions = !result.is_complete() || !result.curves().empty() ||
      std::any_of(result.vertices().begin(), result.vertices().end(), [&](const Curve_vertex& vertex) {
        return CGAL::certainly(sign_on(part.outside, vertex.box) == CGAL::POSITIVE);
      });
  return has_solutions ? std::optional(std::move(result)) : std::nullopt;
}

// What is known of the curves along which surfaces touch a face of the domain.
struct Touching_curves
{
  Lone_part part = {};
  std::optional<Curve_solution_set_d> outside = std::nullopt; // from there
  std::vector<Exact_ranges> open = {};                        // where this is not known
  std::size_t nodes = 0;
};

/*
Near a curve where the equality has a factor with an even exponent, and neither the derivative across the face nor the
factor with odd exponents is zero, the solutions are a graph over the face, on one side of it and on it along the curve
alone.
*/
inline Touching_curves touching_curves(const Face_equation& face, const Solver_options& options, Run_control& control)
{
  Touching_curves result{{{{face.axis(), face.value()}}, face.outside()}};
  if (!face.has_touching())
    return result;
  const Constraint_system_d touching = face.touching_system();
  if (!result.part.outside.is_constant() || result.part.outside.is_zero()) {
    Constraint_system_d changes = touching;
    changes.add(result.part.outside, Relation::EQUAL);
    Curve_vertices solver(options);
    for (const Solution_d<double>& place :
         solver.solve(on_plane(changes, domain_of(changes), face.axis(), face.value())))
      for (Exact_ranges box : place.cover().empty() ? std::vector<Exact_ranges>{place.exact_box()} : place.cover()) {
        box.insert(box.begin() + face.axis(), {face.value(), face.value()});
        result.open.push_back(std::move(box));
      }
    result.nodes += solver.work().nodes;
  }
  result.outside = curves_on_faces<CGAL::Sequential_tag>(touching, result.part, options, control);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LONE_CURVES_H
