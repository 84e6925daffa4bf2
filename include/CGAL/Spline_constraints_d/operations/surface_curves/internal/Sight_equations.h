// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SIGHT_EQUATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SIGHT_EQUATIONS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
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

// The four coordinates of planes that depend on the parameters of a surface, or derivatives of these.
using Plane_functions = std::array<Exact_function, 4>;

inline Plane_functions derivative(Plane_functions planes, int axis)
{
  for (Exact_function& f : planes)
    f = f.derivative(axis);
  return planes;
}

// The functions where the parameters are in ranges; without those that have one value there.
inline Plane_functions on_face(Plane_functions planes, const Parameter_box& box)
{
  for (int axis = 2; axis-- > 0;)
    for (Exact_function& f : planes)
      f = part_of(f, axis, box[static_cast<std::size_t>(axis)]);
  return planes;
}

inline bool vanish(const Plane_functions& planes)
{
  return std::all_of(planes.begin(), planes.end(), [](const Exact_function& f) {
    return f.bounds() == std::pair(Exact_rational(0), Exact_rational(0));
  });
}

// The sign of a number in an interval; 0: not known.
inline int sign_of(const Rational_interval& x) { return x.lower > 0 ? 1 : x.upper < 0 ? -1 : 0; }

// A solution: the parameters of the surface, and the time; a region around it without others.
struct Sight_solution
{
  Parameter_box box, region;
  Solution_kind kind;
  Undecided_reason reason = Undecided_reason::NONE;

  bool is_certified() const { return kind == Solution_kind::CERTIFIED; }

  // One solution, which may be outside of the domain, next to its boundary.
  bool is_one() const { return is_certified() || reason == Undecided_reason::DOMAIN_BOUNDARY; }
};

/*
Equations <n(u,v), P(t)> = 0 of the planes n of a surface, or their derivatives, and the homogeneous coordinates P of an
eye at the time t; and intervals of such products.
*/
class Sight_equations
{
  Plane_functions m_eye;
  Budgeted_solver m_solver;

public:
  Sight_equations(Plane_functions eye, const Solver_options& options) : m_eye(std::move(eye)), m_solver(options) {}

  Parameter_range times() const { return m_eye[0].domain(0); }
  Budgeted_solver& solver() { return m_solver; }

  // The common zeros of some functions on a face of a cell, in a box of both parameters and of the time. A parameter
  // whose range is one number is none of the functions. Throws Run_stopped when the run has ended before.
  std::vector<Sight_solution> solve(const std::vector<Plane_functions>& functions, const Parameter_box& box)
  {
    m_solver.budget().check();
    Parameter_box free;
    for (const Parameter_range& range : box)
      if (range.first < range.second)
        free.push_back(range);
    const std::vector<Unknown> all = unknowns_in(free);
    const std::span<const Unknown> unknowns(all);
    std::vector<Constraint> constraints;
    for (const Plane_functions& planes : functions)
      if (!vanish(planes))
        constraints.push_back(product(planes, unknowns.first(all.size() - 1), unknowns.last(1)) == 0);
    if (constraints.size() < all.size())
      return sign_on(functions.front(), box) == 0
          ? std::vector<Sight_solution>{{box, box, Solution_kind::CONTINUUM, Undecided_reason::CONTINUUM}}
          : std::vector<Sight_solution>();
    std::vector<Sight_solution> result;
    for (const Solution_d<double>& solution : m_solver(constraints, all))
      result.push_back({with_fixed(solution.exact_box(), box), with_fixed(solution.exact_uniqueness_region(), box),
                        solution.kind(),
                        solution.kind() == Solution_kind::CONTINUUM ? Undecided_reason::CONTINUUM : solution.reason()});
    return result;
  }

  // Bounds of <n, P> for functions on a cell, where the parameters and the time are in a box.
  Rational_interval value(const Plane_functions& planes, const Parameter_box& box) const
  {
    return product_of_bounds(on_face(planes, box), [&](const Exact_function& f) { return part_of(f, 0, box[2]); });
  }

  // The same of <n, P'>; the range of times has an interior.
  Rational_interval velocity(const Plane_functions& planes, const Parameter_box& box) const
  {
    Rational_interval result(Exact_rational(0));
    const Plane_functions here = on_face(planes, box);
    for (std::size_t i = 0; i < 4; ++i)
      result = result +
          Rational_interval(here[i].bounds()) * Rational_interval(part_of(m_eye[i], 0, box[2]).derivative_bounds(0));
    return result;
  }

private:
  Expression product(const Plane_functions& planes, std::span<const Unknown> u, std::span<const Unknown> t) const
  {
    Expression result = formula(planes[0], u) * formula(m_eye[0], t);
    for (std::size_t i = 1; i < 4; ++i)
      result = result + formula(planes[i], u) * formula(m_eye[i], t);
    return result;
  }

  template <class Part>
  Rational_interval product_of_bounds(const Plane_functions& planes, const Part& eye) const
  {
    Rational_interval result(Exact_rational(0));
    for (std::size_t i = 0; i < 4; ++i)
      result = result + Rational_interval(planes[i].bounds()) * Rational_interval(eye(m_eye[i]).bounds());
    return result;
  }

  // Of functions on a face, at all of the times in the box.
  int sign_on(const Plane_functions& planes, const Parameter_box& box) const
  {
    return sign_of(product_of_bounds(planes, [&](const Exact_function& f) { return part_of(f, 0, box[2]); }));
  }

  static Parameter_box with_fixed(const Parameter_box& free, const Parameter_box& box)
  {
    Parameter_box result = box;
    auto next = free.begin();
    for (Parameter_range& range : result)
      if (range.first < range.second && next != free.end())
        range = *next++;
    return clipped(with_short_ends(std::move(result)), box);
  }
};

// Points of events, their order, and what is undecided, of which there are boxes of unknowns, the last one the time of
// the eye.
inline void finish(Found_silhouette_events& found, const Place_of_unknowns& place, const Budgeted_solver& solver,
                   const Parameter_range& times)
{
  for (auto& event : found.events) {
    std::vector<double> unknowns;
    for (std::size_t j = 0; j + 1 < event.box.size(); ++j)
      unknowns.push_back(to_nearest_double(middle_of(event.box[j])));
    event.point = place.point(unknowns);
  }
  std::stable_sort(found.events.begin(), found.events.end(),
                   [](const auto& a, const auto& b) { return a.box.back() < b.box.back(); });
  for (const auto& [box, reason] : found.undecided_boxes) {
    std::vector<Undecided_part::Parameters> parameters;
    std::size_t unknown = 0;
    for (const std::size_t number : {place.parameters[0], box.size() - 1 - place.parameters[0], std::size_t(1)}) {
      if (number > 0)
        parameters.push_back({parameters.size(), {}});
      for (std::size_t k = 0; k < number; ++k)
        parameters.back().ranges.push_back(double_range(box[unknown++]));
    }
    found.undecided.push_back({place.bounds(Parameter_box(box.begin(), box.end() - 1)), parameters, in_words(reason)});
  }
  found.times = times;
  found.summary = solver.total();
  found.summary.is_complete = found.undecided.empty();
  if (!found.undecided.empty() && found.summary.why_not == Undecided_reason::NONE)
    found.summary.why_not = found.undecided_boxes.front().second;
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SIGHT_EQUATIONS_H
