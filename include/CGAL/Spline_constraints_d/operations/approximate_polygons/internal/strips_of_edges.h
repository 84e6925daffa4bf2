// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_STRIPS_OF_EDGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_STRIPS_OF_EDGES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Signature_cells_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Banded_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/Polygon_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

template <class Kernel>
Polygon exact_polygon(const CGAL::Polygon_2<Kernel>& polygon)
{
  Polygon result;
  for (const auto& p : polygon.vertices())
    result.push_back(exact_object(p));
  return result;
}

// A number that is at most the length of a vector, and less than that by a factor of more than 1 - 2^-40 only; the
// length, if this is rational with few digits. The vector is not zero.
Exact_rational length_below(const Exact_kernel::Vector_2& v);

std::vector<Edge_strip_2> strips_of_width(const Polygon& polygon, const std::vector<Exact_rational>& half_widths);

std::vector<Edge_strip_2> strips_between(const Polygon& inner, const Polygon& outer);

// Defined in cells_of_signatures.h; the compiled library has it.
Signature_cells_2 cells_of_signatures(const Banded_polygon_2& polygon, const Solver_options& options);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational length_below(const Exact_kernel::Vector_2& v)
{
  const Exact_rational scale = (std::max)(Exact_rational(CGAL::abs(v.x())), Exact_rational(CGAL::abs(v.y())));
  const Exact_rational square((v.x() * v.x() + v.y() * v.y()) / (scale * scale)); // between 1 and 2
  Exact_rational root = to_rational(std::sqrt(CGAL::to_double(square)));
  if (root * root > square)
    root *= to_rational(1 - 0x1p-45);
  return Exact_rational(scale * root);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Edge_strip_2> strips_of_width(const Polygon& polygon,
                                                                         const std::vector<Exact_rational>& half_widths)
{
  if (half_widths.size() != polygon.size())
    throw Invalid_input("approximate_polygon: " + std::to_string(half_widths.size()) + " half widths for " +
                        std::to_string(polygon.size()) + " edges");
  const bool is_clockwise = polygon.size() > 2 && CGAL::is_negative(polygon.area());
  std::vector<Edge_strip_2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!(half_widths[i] > 0))
      throw Invalid_input("approximate_polygon: the half width of edge " + std::to_string(i) + " is not positive");
    const auto edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (edge == CGAL::NULL_VECTOR)
      throw Invalid_input("approximate_polygon: edge " + std::to_string(i) + " has no length");
    const auto to_left =
        edge.perpendicular(CGAL::COUNTERCLOCKWISE) * Exact_rational(half_widths[i] / length_below(edge));
    const auto outwards = is_clockwise ? to_left : -to_left;
    result.push_back({polygon[i] - outwards, polygon[i] + outwards});
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Edge_strip_2> strips_between(const Polygon& inner, const Polygon& outer)
{
  if (inner.size() != outer.size())
    throw Invalid_input("approximate_polygon_between: " + std::to_string(inner.size()) + " and " +
                        std::to_string(outer.size()) + " edges");
  std::vector<Edge_strip_2> result;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const std::size_t next = (i + 1) % outer.size();
    const auto edge = inner[next] - inner[i];
    if (CGAL::determinant(edge, outer[next] - outer[i]) != 0 || edge == CGAL::NULL_VECTOR)
      throw Invalid_input("approximate_polygon_between: the edges " + std::to_string(i) + " are not parallel");
    result.push_back({inner[i], outer[i]});
  }
  return result;
}
#endif

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_STRIPS_OF_EDGES_H
