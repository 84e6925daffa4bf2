// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_CURVE_SURFACE_BISECTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_CURVE_SURFACE_BISECTORS_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Envelope_collector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
The centers of spheres that touch a curve C(t) and a smooth part of a surface S(u, v) with the normal n: with d = S - C,

  B = S + x n,  x = -|d|^2 / (2 <d, n>),  <|d|^2 n - 2 <d, n> d, C'> = 0,

up to a radius r: |x n| <= r.
*/
struct Curve_and_surface
{
  Constraint_system_d system;
  Vector_expression<3> image;
  std::vector<Vector_expression<3>> feet; // on the surface and the curve
};

inline Curve_and_surface curve_and_surface(const Spline_patch<3>& curve, const Smooth_surface& surface,
                                           const Exact_rational& radius, const Operation_budget& budget)
{
  const Curve_vertex::Exact_box domain{surface.patch.domain(0), surface.patch.domain(1), curve.domain(0)};
  const std::vector<Unknown> unknowns = unknowns_in(domain);
  const std::span<const Unknown> u = std::span(unknowns).first(2), t = std::span(unknowns).last(1);
  const Parametric_vector<3> c(curve);
  const Vector_expression<3> s = Parametric_vector<3>(surface.patch)(u), n = Parametric_vector<3>(surface.normal)(u),
                             d = s - c(t), slope = c.tangent(0)(t);
  const Expression square = squared_norm(d), height = dot(d, n);
  Constraint_system_d system(domain);
  const auto check = [&] { budget.check(); };
  system.add(square * dot(n, slope) - 2 * height * dot(d, slope) == 0, check);
  add_not_negative(4 * radius * radius * height * height - square * square * squared_norm(n), system, check);
  return {std::move(system), s - n * (square / (2 * height)), {s, c(t)}};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Envelope_surface_3 curve_surface_bisector_of(const Exact_map<3>& curve,
                                                                            const Exact_map<3>& surface,
                                                                            const Exact_rational& radius,
                                                                            const Solver_options& options)
{
  if (!(radius > 0))
    throw Invalid_input("curve_surface_bisector: the radius is not positive");
  Envelope_collector result(options);
  const Spline_patch<3> whole_curve(curve), patch(surface);
  std::vector<Exact_rational> cuts = whole_curve.possible_kinks(0);
  cuts.insert(cuts.begin(), whole_curve.domain(0).first);
  cuts.push_back(whole_curve.domain(0).second);
  try {
    for (const Smooth_surface& part : smooth_surfaces(patch, [&] { result.budget().check(); }))
      for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (part.is_degenerate())
          throw Invalid_input("curve_surface_bisector: a piece of the surface is a curve or a point");
        const Curve_and_surface pair =
            curve_and_surface(whole_curve.part(0, {cuts[i - 1], cuts[i]}), part, radius, result.budget());
        result.add(pair.system, {}, pair.image, part.closed_axes(), {}, {}, {}, pair.feet);
      }
  } catch (const Run_stopped& stop) {
    result.add_undecided({patch.domain(0), patch.domain(1), whole_curve.domain(0)}, in_words(stop.reason));
  }
  return std::move(result).result();
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_CURVE_SURFACE_BISECTORS_H
