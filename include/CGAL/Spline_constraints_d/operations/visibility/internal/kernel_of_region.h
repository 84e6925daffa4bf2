// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_OF_REGION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_OF_REGION_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_centre_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_edges_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_of_region_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/kernel_elements.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

using Box = std::vector<Undecided_part::Range>;

// \throws Run_stopped
inline std::vector<Tangent_family> tangents_of(const std::vector<Boundary_loop_2>& loops, Run_of_steps& run)
{
  std::vector<Tangent_family> result;
  for (const Boundary_loop_2& loop : loops)
    for (const Boundary_piece& piece : loop.pieces()) {
      run.check();
      result.emplace_back(piece);
    }
  return result;
}

inline std::vector<Exact_pair> corners_of(const Box& box)
{
  const Exact_rational x0 = to_rational(box[0].first), x1 = to_rational(box[0].second),
                       y0 = to_rational(box[1].first), y1 = to_rational(box[1].second);
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Box box_around(const std::vector<Exact_pair>& points)
{
  Box result;
  for (const auto& [x, y] : points)
    result = united_box(std::move(result), {to_double_interval(x), to_double_interval(y)});
  return result;
}

// Between the source of an edge and that of the next one.
inline Undecided_part undecided_edge(const Kernel_of_region_2& kernel, std::size_t i)
{
  Box box;
  for (const auto& [x, y] : {kernel.vertices[i], kernel.vertices[kernel.after(i)]})
    box = united_box(std::move(box),
                     {std::pair(to_double_interval(x.lower).first, to_double_interval(x.upper).second),
                      std::pair(to_double_interval(y.lower).first, to_double_interval(y.upper).second)});
  const auto& [source, target] = kernel.edges[i].parameters;
  return {std::move(box),
          {{kernel.edges[i].curve,
            {{to_double_interval((std::min)(source.first, target.first)).first,
              to_double_interval((std::max)(source.second, target.second)).second}}}},
          "tangents are not told apart"};
}

// What is not decided when all is done.
inline std::vector<Undecided_part> undecided_parts(const Kernel_of_region_2& kernel, const Box& polygon)
{
  std::vector<Undecided_part> result;
  for (std::size_t i = 0; i < kernel.edges.size(); ++i)
    if (kernel.edges[i].kind == Kernel_edge_kind::UNDECIDED)
      result.push_back(undecided_edge(kernel, i));
  if (!kernel.centre && kernel.may_have_interior)
    result.push_back({polygon, {}, "no point of the interior is found, nor a proof that there is none"});
  if (!kernel.centre && !kernel.may_have_interior && !kernel.flat.empty() && !kernel.is_straight)
    result.push_back({polygon, {}, "it is not told which of these points see all of the region"});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Kernel_of_region_2 kernel_of_region(
    const std::vector<std::vector<Boundary_piece>>& curves, const std::vector<Boundary_loop_2>& loops,
    const Solver_options& options)
{
  Run_of_steps run(options);
  const Upward_rounding_guard guard;
  Kernel_of_region_2 result;
  result.may_have_interior = loops.size() == 1;
  Box polygon = box_of_pieces(curves);
  try {
    result.parts = Curve_parts_2(curves, run);
    const std::vector<Tangent_family> tangents = tangents_of(loops, run);
    for (const Tangent_family& tangent : tangents)
      result.is_straight = result.is_straight && power_coefficients(tangent.curvature()).empty();
    const Kernel_centre_2 centre(tangents, corners_of(polygon), run);
    polygon = box_around(centre.polygon());
    result.centre = centre.centre();
    if (centre.is_flat()) {
      result.may_have_interior = false;
      result.flat = centre.polygon();
    }
    if (result.centre)
      Kernel_edges_2(Kernel_boundary_2(kernel_elements(tangents, *result.centre, run), run), result);
    result.undecided = undecided_parts(result, polygon);
  } catch (const Run_stopped& stop) {
    result.undecided = {{polygon, {}, in_words(stop.reason)}};
  }
  result.summary = run.summary(result.undecided.empty());
  return result;
}

// Of the triangle with a point.
inline Rational_interval twice_triangle(const Exact_pair& point, const Vector_bounds<2>& p, const Vector_bounds<2>& q)
{
  const auto arm = [&](const Vector_bounds<2>& bounds, std::size_t k) {
    return bounds[k] - Rational_interval(point[k]);
  };
  return arm(p, 0) * arm(q, 1) - arm(p, 1) * arm(q, 0);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<Exact_rational, Exact_rational>
area_of_kernel(const Kernel_of_region_2& kernel, double error)
{
  Rational_interval result(Exact_rational(0), Exact_rational(0));
  std::vector<Boundary_piece> arcs;
  for (std::size_t i = 0; i < kernel.edges.size(); ++i)
    if (kernel.edges[i].kind == Kernel_edge_kind::ARC)
      kernel.parts.append_sector(kernel.edges[i].curve, kernel.edges[i].parameters[0], kernel.edges[i].parameters[1],
                                 *kernel.centre, arcs, result);
    else
      result = result +
          twice_triangle(*kernel.centre, kernel.vertices[i], kernel.vertices[kernel.after(i)]) *
              Rational_interval(Convex_hull::one_half());
  if (!arcs.empty())
    result = result + Boundary_loop_2(arcs).signed_area(to_rational(error) / 2);
  return {result.lower, result.upper};
}

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_OF_REGION_H
