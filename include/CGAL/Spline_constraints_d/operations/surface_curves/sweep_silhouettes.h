// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

An affine motion: at the time \f$t\f$ it takes the point \f$(x,y,z)\f$ to \f$C(t) + x\,a_0(t) + y\,a_1(t) +
z\,a_2(t)\f$.
*/
template <SplineKernel Kernel>
struct Affine_motion
{
  //! the path \f$C\f$ of the origin; its parameter is the time.
  Bspline_curve_3<Kernel> path;

  //! the images \f$a_0, a_1, a_2\f$ of the unit vectors, points standing for the vectors from the origin to them, with
  //! the same domain; none for a translation.
  std::vector<Bspline_curve_3<Kernel>> axes{};
};

namespace internal {
namespace Surface_curves {

using Space_map = Spline_map<1, 3>;

// A part of a motion between times where a velocity jumps.
struct Smooth_motion
{
  std::vector<Space_map> maps;   // the path, and the three axes if there are any

  // The vector moved, or its velocity.
  Vector_expression<3> moved(const Vector_expression<3>& x, const Unknown& t, bool is_velocity) const
  {
    const auto at = [&](std::size_t k) { return is_velocity ? derivative(maps[k])(t) : maps[k](t); };
    if (maps.size() == 1)
      return is_velocity ? at(0) : at(0) + x;
    return at(0) + at(1) * x[0] + at(2) * x[1] + at(3) * x[2];
  }

  // The normal of what a plane with the given normal is moved to: normals are transformed by the matrix of cofactors.
  Vector_expression<3> moved_normal(const Vector_expression<3>& n, const Unknown& t) const
  {
    if (maps.size() == 1)
      return n;
    const Vector_expression<3> a = maps[1](t), b = maps[2](t), c = maps[3](t);
    return cross(b, c) * n[0] + cross(c, a) * n[1] + cross(a, b) * n[2];
  }

  std::array<double, 3> moved(const std::array<double, 3>& x, double time) const
  {
    const auto [begin, end] = maps[0].domain(0);
    const std::array<Exact_rational, 1> t{(std::max)(begin, (std::min)(Exact_rational(time), end))};
    const auto at = [&](std::size_t k, std::size_t i) { return to_nearest_double(maps[k](t)[i]); };
    std::array<double, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = maps.size() == 1 ? at(0, i) + x[i] : at(0, i) + at(1, i) * x[0] + at(2, i) * x[1] + at(3, i) * x[2];
    return result;
  }

  Smooth_motion restricted(const Exact_rational& begin, const Exact_rational& end) const
  {
    Smooth_motion result;
    for (const Space_map& map : maps)
      result.maps.push_back(map.restricted(0, begin, end));
    return result;
  }
};

template <SplineKernel Kernel>
std::vector<Smooth_motion> smooth_parts(const Affine_motion<Kernel>& motion)
{
  if (!motion.axes.empty() && motion.axes.size() != 3)
    throw Invalid_input("sweep_silhouettes: a motion has three axes or none");
  Smooth_motion whole{{Space_map(motion.path)}};
  for (const Bspline_curve_3<Kernel>& axis : motion.axes)
    whole.maps.emplace_back(axis);
  std::vector<Exact_rational> times;
  for (const Space_map& map : whole.maps) {
    if (map.domain(0) != whole.maps[0].domain(0))
      throw Invalid_input("sweep_silhouettes: the path and the axes have different domains");
    times = united(times, map.breaks(0));
  }
  // The times where a derivative jumps, and both ends.
  std::vector<Exact_rational> cuts{times.front()};
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    const auto velocity = [&](const Space_map& map, std::size_t k) {
      return derivative(map.restricted(0, times[k], times[k + 1]))(std::array{times[i]});
    };
    if (std::any_of(whole.maps.begin(), whole.maps.end(),
                    [&](const Space_map& map) { return velocity(map, i - 1) != velocity(map, i); }))
      cuts.push_back(times[i]);
  }
  cuts.push_back(times.back());
  std::vector<Smooth_motion> result;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    result.push_back(whole.restricted(cuts[i - 1], cuts[i]));
  return result;
}

// The equations of both surface and envelope: a tangent plane of the moved surface contains its velocity, and the eye.
inline std::vector<Constraint> silhouette_of_sweep(const Spline_patch<3>& surface,
                                                   const Vector_of_functions<3>& normals, const Smooth_motion& motion,
                                                   const Exact_kernel::Point_3& eye, std::span<const Unknown> u)
{
  const Vector_expression<3> x = Parametric_vector<3>(surface)(u.first(2)),
                             normal = motion.moved_normal(Parametric_vector<3>(normals)(u.first(2)), u[2]);
  const Vector_expression<3> from_eye = motion.moved(x, u[2], false) -
      vector_of<3>([&](std::size_t i) { return Expression(eye.cartesian(static_cast<int>(i))); });
  return {dot(motion.moved(x, u[2], true), normal) == 0, dot(from_eye, normal) == 0};
}

template <SplineKernel Kernel>
Surface_curves_3<Kernel> sweep_silhouettes(const Spline_patch<3>& surface,
                                           const std::vector<Continuous_part<4>>& planes,
                                           const std::vector<Smooth_motion>& motion, const Exact_kernel::Point_3& eye,
                                           const Solver_options& options)
{
  Surface_curves_3<Kernel> result(
      [on_surface = point_on_surface(surface), motion](const std::vector<double>& unknowns) {
        const auto part = std::find_if(motion.begin(), motion.end() - 1, [&](const Smooth_motion& m) {
          return unknowns[2] <= CGAL::to_double(m.maps[0].domain(0).second);
        });
        return part->moved(on_surface(unknowns), unknowns[2]);
      });
  for (const Continuous_part<4>& part : planes)
    for (const Smooth_motion& moved : motion) {
      const Curve_vertex::Exact_box domain{part.functions.domain(0), part.functions.domain(1), moved.maps[0].domain(0)};
      if (part.functions.is_zero()) {
        result.add_undecided(domain);
        continue;
      }
      const Spline_patch<3> patch = surface.part({domain[0], domain[1]});
      const auto [x, y, z, offset] = part.functions.splines();
      Constraint_system_d system(domain);
      for (const Constraint& equation : silhouette_of_sweep(patch, {x, y, z}, moved, eye, unknowns_in(domain)))
        system.add(equation);
      Domain_joints joints;
      for (const int axis : {0, 1})
        if (patch.is_closed(axis) && part.functions.ratio(axis, part.functions.size(axis) - 1, 0))
          joints.closed_unknowns.push_back(static_cast<std::size_t>(axis));
      Curve_solution_set_d solutions = internal::curves_within(system, options);
      result.add(std::move(system), std::move(solutions), joints);
    }
  return result;
}

} // namespace Surface_curves
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the silhouettes of the envelope of a moving surface, seen from points: where a moved surface and the envelope of all of
them have the same tangent plane, which contains the eye. With a matrix \f$A(t)\f$, the columns of which are the axes,
the moved surface is \f$T = C + A S\f$, its normal that of the surface times the matrix of cofactors of \f$A\f$, and
\f[ \langle C' + A' S,\ \mathrm{cof}(A)\,(S_u \times S_v)\rangle = 0, \qquad \langle T - p,\ \mathrm{cof}(A)\,(S_u
\times S_v)\rangle = 0. \f] The unknowns are the two parameters of the surface and the time; the topology of the curves
is proved. Both are transparent, and neither the surface in its first and last position nor what of the envelope is
inside of the swept volume is looked at.

In the source the normal is multiplied by \f$A\f$ itself, which holds for rotations and uniform scalings only.

Curves end at the first and last time, and where the normal of the surface or a velocity jumps. Where the surface moves
along itself, where it stands still, and along a break or seam of it the answer is undecided. Curves through poles are
not joined.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param motion the motion.
\param viewpoints the eyes.
\param options those of `solve_curves()`; limits hold for each viewpoint and each two smooth parts.
\return the curves for each viewpoint, in their order. Points are those of the moved surface.
\throws Invalid_input when there are axes, but not three, the domains of path and axes differ, a coordinate is not
finite, a weight is not proved to have one sign, or an option makes no sense.

Complexity: that of `solve_curves()` with two equations in three unknowns. Source: \cgalCite{kes-gcps-05}, section 5,
equation (33).
*/
template <internal::Surface_curves::Surface_operand Surface>
std::vector<Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>>
sweep_silhouettes(const Surface& surface,
                  const Affine_motion<internal::Surface_curves::Operand_kernel<Surface>>& motion,
                  const std::vector<CGAL::Point_3<internal::Surface_curves::Operand_kernel<Surface>>>& viewpoints,
                  const Solver_options& options = {.tolerance = 1e-8})
{
  using Kernel = internal::Surface_curves::Operand_kernel<Surface>;
  options.check();
  const internal::Common::Spline_patch<3> patch = internal::Common::Intersection_operand<Surface>::patch(surface);
  const std::vector<internal::Common::Continuous_part<4>> planes = internal::Intersections::tangent_planes(patch);
  const std::vector<internal::Surface_curves::Smooth_motion> parts = internal::Surface_curves::smooth_parts(motion);
  std::vector<Surface_curves_3<Kernel>> result;
  for (const CGAL::Point_3<Kernel>& eye : viewpoints)
    result.push_back(internal::Surface_curves::sweep_silhouettes<Kernel>(patch, planes, parts,
                                                                         internal::exact_object(eye), options));
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTES_H
