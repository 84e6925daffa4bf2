// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTES_OF_SWEEP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTES_OF_SWEEP_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

using Space_map = Spline_map<1, 3>;

inline Space_map space_map(const Exact_map<3>& map)
{
  return map.is_rational ? Space_map(map.numerators, map.weight) : Space_map(map.numerators);
}

// A part of a motion between times where a velocity jumps.
struct Smooth_motion
{
  std::vector<Space_map> maps; // the path, and the three axes if there are any

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

inline std::vector<Smooth_motion> smooth_parts(const Exact_map<3>& path, const std::vector<Exact_map<3>>& axes)
{
  Smooth_motion whole{{space_map(path)}};
  for (const Exact_map<3>& axis : axes)
    whole.maps.push_back(space_map(axis));
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
                                                   const Exact_triple& eye, std::span<const Unknown> u)
{
  const Vector_expression<3> x = Parametric_vector<3>(surface)(u.first(2)),
                             normal = motion.moved_normal(Parametric_vector<3>(normals)(u.first(2)), u[2]);
  const Vector_expression<3> from_eye =
      motion.moved(x, u[2], false) - vector_of<3>([&](std::size_t i) { return Expression(eye[i]); });
  return {dot(motion.moved(x, u[2], true), normal) == 0, dot(from_eye, normal) == 0};
}

// What the points in a box are moved to at some times, by a path and its axes, if there are some.
inline Vector_bounds<3> moved_bounds(const std::vector<Spline_patch<3>>& motion, const Vector_bounds<3>& x,
                                     const Parameter_range& times)
{
  const auto at = [&](std::size_t k) { return motion[k].part(clipped({times}, {motion[k].domain(0)})).values(); };
  Vector_bounds<3> result = at(0);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      if (motion.size() > 1)
        result[i] = result[i] + at(k + 1)[i] * x[k];
      else if (i == k)
        result[i] = result[i] + x[i];
  return result;
}

// What points, given by parameters of a surface and a time, are moved to.
inline Place_of_unknowns place_in_motion(const Spline_patch<3>& surface, const std::vector<Spline_patch<3>>& maps,
                                         const std::vector<Smooth_motion>& motion)
{
  const auto point = [on_surface = place_on_surface(surface).point, motion](const std::vector<double>& unknowns) {
    const auto part = std::find_if(motion.begin(), motion.end() - 1, [&](const Smooth_motion& m) {
      return unknowns[2] <= CGAL::to_double(m.maps[0].domain(0).second);
    });
    return part->moved(on_surface(unknowns), unknowns[2]);
  };
  const auto bounds = [surface, maps](const Curve_vertex::Exact_box& box) {
    const Parameter_box domain{surface.domain(0), surface.domain(1)};
    return double_ranges(moved_bounds(maps, surface.part(clipped({box[0], box[1]}, domain)).values(), box[2]));
  };
  return {point, bounds, {2, 1}};
}

// The silhouettes of the envelope for one eye.
class Silhouettes_of_sweep
{
  const Spline_patch<3>& m_surface;
  const std::vector<Smooth_motion>& m_motion;
  Place_of_unknowns m_place;
  Operation_budget& m_budget;

public:
  Silhouettes_of_sweep(const Spline_patch<3>& surface, const std::vector<Smooth_motion>& motion,
                       Place_of_unknowns place, Operation_budget& budget)
    : m_surface(surface), m_motion(motion), m_place(std::move(place)), m_budget(budget)
  {}

  Found_surface_curves operator()(const std::vector<Continuous_part<4>>& planes, const Exact_triple& eye) const
  {
    Surface_curve_collector result(m_place);
    for (const Continuous_part<4>& part : planes)
      for (const Smooth_motion& moved : m_motion)
        add(result, part.functions, moved, eye);
    return result.found();
  }

  // Where nothing is looked for.
  Found_surface_curves undecided(Undecided_reason reason) const
  {
    Surface_curve_collector result(m_place);
    for (const Smooth_motion& moved : m_motion)
      result.add_undecided({m_surface.domain(0), m_surface.domain(1), moved.maps[0].domain(0)}, reason);
    return result.found();
  }

private:
  void add(Surface_curve_collector& result, const Cell_functions<4>& planes, const Smooth_motion& moved,
           const Exact_triple& eye) const
  {
    const Curve_vertex::Exact_box domain{planes.domain(0), planes.domain(1), moved.maps[0].domain(0)};
    if (planes.is_zero() || m_budget.must_stop()) {
      result.add_undecided(domain, planes.is_zero() ? Undecided_reason::CONTINUUM : m_budget.reason());
      return;
    }
    const Spline_patch<3> patch = m_surface.part({domain[0], domain[1]});
    const auto [x, y, z, offset] = planes.splines();
    Constraint_system_d system(domain);
    for (const Constraint& equation : silhouette_of_sweep(patch, {x, y, z}, moved, eye, unknowns_in(domain)))
      system.add(equation);
    Domain_joints joints;
    for (const int axis : {0, 1})
      if (patch.is_closed(axis) && planes.ratio(axis, planes.size(axis) - 1, 0))
        joints.closed_unknowns.push_back(static_cast<std::size_t>(axis));
    Curve_solution_set_d solutions = curves_within_budget(system, m_budget);
    result.add(std::move(system), std::move(solutions), joints);
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Found_surface_curves>
sweep_silhouettes_of(const Exact_map<3>& surface, const Exact_map<3>& path, const std::vector<Exact_map<3>>& axes,
                     const std::vector<Exact_triple>& eyes, const Solver_options& options)
{
  Operation_budget budget(options);
  const Spline_patch<3> patch(surface);
  const std::vector<Smooth_motion> motion = smooth_parts(path, axes);
  std::vector<Spline_patch<3>> maps{Spline_patch<3>(path)};
  for (const Exact_map<3>& axis : axes)
    maps.emplace_back(axis);
  const Silhouettes_of_sweep silhouettes(patch, motion, place_in_motion(patch, maps, motion), budget);
  std::vector<Found_surface_curves> result;
  try {
    const std::vector<Continuous_part<4>> planes = tangent_planes(patch, [&] { budget.check(); });
    for (const Exact_triple& eye : eyes)
      result.push_back(silhouettes(planes, eye));
  } catch (const Run_stopped& stop) {
    result.assign(eyes.size(), silhouettes.undecided(stop.reason));
  }
  return result;
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTES_OF_SWEEP_H
