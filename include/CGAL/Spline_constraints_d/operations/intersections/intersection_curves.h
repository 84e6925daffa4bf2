// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTION_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTION_CURVES_H

#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Contact_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Curves_through_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Implicit_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Pole_systems.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/curves_on_implicit_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The equations of two surfaces, looked for when they are needed.
class Equations_of_surfaces
{
  const Surface_equations& m_surfaces;
  std::array<bool, 2> m_is_known{};
  std::array<std::optional<Power_polynomial>, 2> m_polynomials;

public:
  explicit Equations_of_surfaces(const Surface_equations& surfaces) : m_surfaces(surfaces) {}

  const Power_polynomial* operator()(std::size_t surface)
  {
    if (!std::exchange(m_is_known[surface], true))
      m_polynomials[surface] = m_surfaces.is_parametric(surface)
          ? implicit_equation(*m_surfaces.surface(surface).patch)
          : std::optional(m_surfaces.surface(surface).polynomial);
    return m_polynomials[surface] ? &*m_polynomials[surface] : nullptr;
  }

  const std::array<std::optional<Power_polynomial>, 2>& both()
  {
    for (const std::size_t surface : {0, 1})
      (*this)(surface);
    return m_polynomials;
  }
};

// The common curves of two parametric surfaces, one of which is an Implicit_patch. Nothing if none is, or not all is
// proved while the equations in all parameters may tell of more.
inline std::optional<Solved_part> curves_on_implicit_patches(const Surface_equations& surfaces,
                                                             Equations_of_surfaces& equations,
                                                             const Solver_options& options)
{
  if (!surfaces.has_system() || !surfaces.has_all_parameters())
    return std::nullopt;
  std::optional<Solved_part> rest;
  for (const std::size_t implicit : {0, 1}) {
    const Spline_patch<3>& surface = *surfaces.surface(implicit).patch;
    const Power_polynomial* const polynomial = equations(implicit);
    const std::optional<Implicit_patch> patch =
        polynomial != nullptr ? Implicit_patch::make(surface, *polynomial) : std::nullopt;
    if (!patch)
      continue;
    const Curves_on_implicit_patch curves(surfaces, implicit, *patch);
    std::optional<Solved_part> found = curves(options);
    if (found && found->solutions.is_complete())
      return found;
    if (found && !curves.has_sides())
      rest = std::move(found);
  }
  return rest;
}

// The curves of two parametric surfaces with poles that lie on the other one, by equations that are regular there, if
// that proves all of them.
inline std::optional<Solved_part> curves_with_poles(const Surface_equations& surfaces,
                                                    const std::vector<Common_pole>& poles,
                                                    Equations_of_surfaces& equations, const Solver_options& options,
                                                    const Curve_search& search)
{
  std::array<bool, 2> has_common_pole{};
  for (const Common_pole& common : poles)
    has_common_pole[common.pole.surface] = true;
  for (const Pole_system& equation : Pole_systems(surfaces, equations.both())(has_common_pole)) {
    const Curve_solution_set_d common =
        Common_point_filter(surfaces, equation.is_one_point)(all_curves(equation.system, options, search));
    if (common.is_complete())
      return joined_at_poles(Surface_equations(surfaces, equation.system), common, poles);
  }
  return std::nullopt;
}

// The curves that satisfy the equations of two surfaces; other equations, if these are singular along curves, or at
// poles.
inline Solved_part common_curves(Surface_equations surfaces, Equations_of_surfaces& equations,
                                 const Solver_options& options)
{
  if (!surfaces.has_system())
    return {std::move(surfaces), Curve_solution_set_d({}, {}, {}, {}, {}, Summary())};
  Curve_search search{.closed_unknowns = surfaces.closed_unknowns()};
  for (const Surface_pole& pole : surfaces.poles())
    search.points.emplace_back(pole.unknown, pole.value);
  std::vector<Common_pole> poles;
  if (!surfaces.has_coordinates())
    poles = Common_poles(surfaces, [&](std::size_t surface) { return equations(surface); }, options)();
  if (!poles.empty() && surfaces.has_all_parameters())
    if (std::optional<Solved_part> result = curves_with_poles(surfaces, poles, equations, options, search))
      return std::move(*result);
  std::vector<Contact_curves> contacts;
  bool has_looked = false;
  const auto has_contact_curves = [&] {
    if (std::exchange(has_looked, true) || !surfaces.has_all_parameters())
      return !contacts.empty();
    const auto& polynomials = equations.both();
    for (const std::size_t implicit : {0, 1})
      if (const std::optional<Contact_curves> found = Contact_curves::make(surfaces, polynomials, implicit))
        contacts.push_back(*found);
    const auto common_zeros =
        polynomials[0] && polynomials[1] ? Regular_pair::make({*polynomials[0], *polynomials[1]}) : std::nullopt;
    for (const std::size_t implicit : {0, 1})
      for (const Contact_curves& found : Contact_curves::along_lines(surfaces, polynomials, implicit, common_zeros))
        contacts.push_back(found);
    return !contacts.empty();
  };
  search.gives_up = has_contact_curves;
  Curve_solution_set_d solutions = all_curves(surfaces.system(), options, search);
  search.gives_up = [] { return false; };
  std::optional<Constraint_system_d> other;
  for (auto contact = contacts.begin(); contact != contacts.end() && (!other || !solutions.is_complete()); ++contact) {
    Constraint_system_d system = contact->system();
    Curve_solution_set_d common = contact->common_points(all_curves(system, options, search));
    if (!other || common.is_complete()) {
      other = std::move(system);
      solutions = std::move(common);
    }
  }
  if (other)
    surfaces = Surface_equations(surfaces, std::move(*other));
  return joined_at_poles(std::move(surfaces), solutions, poles);
}

} // namespace Intersections
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

all curves that two surfaces have in common, with proofs of their number and of how they are connected; with a plane as
one of the surfaces, plane sections and contour lines of the other one.

Operands are taken exactly, and all is decided by `solve_curves()`: no closed curve is lost, however small, nothing is
joined by distance. Of a parametric surface and a plane, sphere or other implicit surface \f$f = 0\f$ the equation is
\f$f(S(u,v)) = 0\f$; of two parametric surfaces \f$A(u,v) = B(s,t)\f$, three equations in four unknowns, or one in two
if both are polynomial height fields over the same two coordinates; of two implicit ones \f$f = g = 0\f$ in space. Of a
parametric surface that is proved to be all of an equation \f$f = 0\f$ of degree four at most, or the part of it between
planes that its edges lie in, as rectangles, spheres, cylinders, cones, tori and their pieces are, and another
parametric one, it is \f$f(B(s,t)) = 0\f$ as well. An implicit surface that ends at its box within the bounds of a
parametric one adds the coordinates as unknowns.

A curve that crosses the seam of a closed surface is joined there: both ends are solutions of the same equations, so
they are the same point when no others come into question.

The surfaces may touch: points where they do so alone, or where two curves cross, are singular points, if they lie
neither on an edge, a seam or a break nor have a degenerate quadratic part. Contact curves are found where one surface
is implicit and the equation has a repeated factor, on each piece of the other surface; of two implicit surfaces, where
a pair of polynomials with the same common zeros that are regular is found, or two of them; and of two parametric
surfaces, where an equation of one of them, of degree four at most, has a repeated factor on the other one (see the
manual). `Intersection_curve::kind()` tells them from others. Other contacts are undecided, and so are pieces of surface
that coincide. A curve along an edge, a seam or a break is found where one equation says so, as it does of a parametric
surface and an implicit one or one with an equation, where it is on an edge of both if the planes of the edge separate
them, and along contacts of two parametric ones that both have an equation.

A curve goes on through a pole, an edge of a surface that is one point, if the surface has a tangent plane there and two
branches end in it in opposite directions. A pole that lies on the other surface is a singular point otherwise, such as
the apex of a cone, where it lies on no other edge; none, one or many branches end there. Of two parametric surfaces
this is found, as a rule, if the one that a pole lies on has an equation of degree four at most, and no seam or pole
there; else what is near the pole is undecided.

\tparam A,B models of `ParametricSurface_3`, objects of CGAL with a conversion to one of these, `CGAL::Plane_3`,
`CGAL::Sphere_3`, or `Implicit_surface_3`, not both `CGAL::Plane_3`. Both have the same kernel, which is that of the
result; `Implicit_surface_3` goes with any, two of them have results in
        `CGAL::Simple_cartesian<double>`.
\param a the first surface.
\param b the second surface.
\param options those of `solve_curves()`.
\throws Invalid_input when a coordinate is not finite, an object of CGAL is degenerate, a weight is not proved to have
one sign, the boxes of two implicit surfaces have no more than a face in common, or an option makes no sense.

Complexity: that of `solve_curves()`; of splines with many pieces only those whose bounds meet are looked at. The
implicit equation of a surface, if it is needed, costs the exact solution of 35 linear equations at most.

Source: \cgalCite{p-cgl-03}.
*/
template <class A, class B>
requires internal::Intersections::Surface_pair<A, B>
    Surface_intersection<internal::Intersections::Common_surface_kernel<A, B>>
    intersection_curves(const A& a, const B& b, const Solver_options& options = {.tolerance = 1e-8})
{
  options.check();
  const internal::Intersections::Surface_equations surfaces(internal::Intersections::surface_shape(a),
                                                            internal::Intersections::surface_shape(b));
  internal::Intersections::Equations_of_surfaces equations(surfaces);
  std::optional<internal::Intersections::Solved_part> curves =
      internal::Intersections::curves_on_implicit_patches(surfaces, equations, options);
  std::vector<internal::Intersections::Solved_part> parts{
      curves ? std::move(*curves) : internal::Intersections::common_curves(surfaces, equations, options)};
  return Surface_intersection<internal::Intersections::Common_surface_kernel<A, B>>(std::move(parts));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTION_CURVES_H
