// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_TRACED_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_TRACED_CURVES_H

#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Proper_reparametrization.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/Curve_tracer.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/traced_curves_declarations.h>
#include <CGAL/Spline_constraints_d/geometry/internal/proper_maps.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Proper {

template <int d>
Curve_functions functions_of(const Bspline_curve<Exact_kernel, d>& curve)
{
  return {curve.representation().functions(), curve.is_rational()};
}

inline int tracing_index_of(const Curve_functions& curve)
{
  Interruption none({});
  int result = 0;
  for (const Curve_part& part : parts_of(curve))
    result = (std::max)(result, proper_map(part.map, none).tracing_index());
  return result;
}

inline bool are_on_one_curve(const Curve_functions& first, const Curve_functions& second)
{
  Interruption none({});
  std::vector<Curve_part> parts = parts_of(first);
  for (Curve_part& part : parts_of(second))
    parts.push_back(std::move(part));
  const Curve_map map = proper_map(parts.front().map, none).map;
  return std::all_of(parts.begin() + 1, parts.end(), [&](const Curve_part& part) {
    return map_between(map, proper_map(part.map, none).map, none).has_value();
  });
}

template <int d>
Proper_component<d> component_of(Curve_tracer::Component&& component)
{
  std::array<Bspline_function<Exact_rational>, d> numerators;
  std::copy_n(component.functions.begin(), d, numerators.begin());
  return {Bspline_curve<Exact_kernel, d>::from_homogeneous_coordinates(numerators, component.functions.back()),
          component.degree, component.is_closed, std::move(component.coverage)};
}

template <int d>
Proper_reparametrization<d> proper_reparametrization_of(const Bspline_curve<Exact_kernel, d>& curve,
                                                        const Solver_options& options)
{
  options.check();
  Run_control control(options);
  const std::size_t pieces = curve.breaks().size() - 1;
  Proper_reparametrization<d> result;
  try {
    control.check();
    Interruption interruption([&] { control.check(); });
    Curve_tracer::Result traced = Curve_tracer()(functions_of(curve), interruption);
    for (Curve_tracer::Component& component : traced.components)
      result.components.push_back(component_of<d>(std::move(component)));
    result.stretches = std::move(traced.stretches);
    result.work = summary_of(control, pieces, Undecided_reason::NONE, true);
  } catch (const Run_stopped& stop) {
    const auto [begin, end] = curve.domain();
    result.unfinished.push_back(
        {{}, {{0, {{to_nearest_double(begin), to_nearest_double(end)}}}}, in_words(stop.reason)});
    result.work = summary_of(control, pieces, stop.reason, false);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int tracing_index(const Bspline_curve<Exact_kernel, 2>& curve)
{
  return tracing_index_of(functions_of(curve));
}

CGAL_SPLINE_CONSTRAINTS_INLINE int tracing_index(const Bspline_curve<Exact_kernel, 3>& curve)
{
  return tracing_index_of(functions_of(curve));
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool have_same_support(const Bspline_curve<Exact_kernel, 2>& first,
                                                      const Bspline_curve<Exact_kernel, 2>& second)
{
  return are_on_one_curve(functions_of(first), functions_of(second));
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool have_same_support(const Bspline_curve<Exact_kernel, 3>& first,
                                                      const Bspline_curve<Exact_kernel, 3>& second)
{
  return are_on_one_curve(functions_of(first), functions_of(second));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Proper_reparametrization<2>
proper_reparametrization(const Bspline_curve<Exact_kernel, 2>& curve, const Solver_options& options)
{
  return proper_reparametrization_of(curve, options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Proper_reparametrization<3>
proper_reparametrization(const Bspline_curve<Exact_kernel, 3>& curve, const Solver_options& options)
{
  return proper_reparametrization_of(curve, options);
}

} // namespace Proper
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_TRACED_CURVES_H
