// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_POLYGONS_OF_BANDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_POLYGONS_OF_BANDS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Banded_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/parts_of_plane.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

[[noreturn]] inline void refuse(const std::string& what) { throw Invalid_input("Approximate_polygon_2: " + what); }

inline std::string edge_name(std::size_t i) { return "edge " + std::to_string(i); }

inline std::string edge_names(std::size_t i, std::size_t j)
{
  return "edges " + std::to_string(i) + " and " + std::to_string(j);
}

// A function for each edge of a polygon that is zero on its line, and positive on the left of it, or on the right.
inline std::vector<Line_function_2> edge_functions(const Polygon& polygon, bool is_positive_on_the_left)
{
  std::vector<Line_function_2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Point left(p.x() - (q.y() - p.y()), p.y() + (q.x() - p.x()));
    const Line_function_2 f = Line_function_2::through(p, q, left);
    result.push_back(is_positive_on_the_left ? f : -f);
  }
  return result;
}

// The lines that bound the strip of an edge; positive outside.
struct Sides
{
  Line_function_2 inner, outer;

  // The line of the edge at a corner that ends the band of the other edge there.
  const Line_function_2& end(bool is_reflex) const { return is_reflex ? inner : outer; }
};

inline std::vector<Sides> sides_of_strips(const Polygon& polygon, const std::vector<Line_function_2>& edges,
                                          const std::vector<Edge_strip_2>& strips)
{
  std::vector<Sides> result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Sides sides{edges[i].parallel_through(strips[i].inner), edges[i].parallel_through(strips[i].outer)};
    if (!CGAL::is_positive(sides.inner(strips[i].outer)))
      refuse("the strip of " + edge_name(i) + " has no interior");
    if (CGAL::is_negative(sides.inner(polygon[i])) || CGAL::is_positive(sides.outer(polygon[i])))
      refuse(edge_name(i) + " is not in its strip");
    result.push_back(sides);
  }
  return result;
}

// Along an edge, from its tail to its head.
inline bool are_in_order(const Polygon& polygon, std::size_t edge, const Point& p, const Point& q)
{
  const Exact_kernel::Vector_2 direction = polygon[(edge + 1) % polygon.size()] - polygon[edge];
  return CGAL::is_positive((q - p) * direction);
}

/*
The strips of an edge and of the one before it have a parallelogram in common, and so have that of the edge and of the
next one. They must be apart, in the order of the edge: then both are in its band, and lines through both of its ends
meet those of the neighbours in them.
*/
inline Band_2 band_of_edge(const Polygon& polygon, const std::vector<Sides>& sides, const std::vector<bool>& is_reflex,
                           std::size_t i)
{
  const std::size_t n = sides.size(), previous = (i + n - 1) % n, next = (i + 1) % n;
  const bool is_tail_reflex = is_reflex[i], is_head_reflex = is_reflex[next];
  for (const Line_function_2& side : {sides[i].inner, sides[i].outer})
    if (!are_in_order(polygon, i, common_zero(side, sides[previous].end(!is_tail_reflex)),
                      common_zero(side, sides[next].end(!is_head_reflex))))
      refuse("the strip of " + edge_name(i) + " is too wide: its parts in those of " + edge_names(previous, next) +
             " overlap");
  const Line_function_2 &tail = sides[previous].end(is_tail_reflex), &head = sides[next].end(is_head_reflex);
  return Band_2(common_zero(sides[i].inner, tail), common_zero(sides[i].outer, tail), common_zero(sides[i].inner, head),
                common_zero(sides[i].outer, head));
}

inline void check_bands(const std::vector<Band_2>& bands)
{
  const std::size_t n = bands.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && !are_disjoint(bands[i], bands[j]))
        refuse("the bands of " + edge_names(i, j) + ", which are no neighbours, meet");
}

CGAL_SPLINE_CONSTRAINTS_INLINE Banded_polygon_2 banded_polygon(Polygon polygon, const std::vector<Edge_strip_2>& strips)
{
  const std::size_t n = polygon.size();
  if (n < 3)
    refuse("less than three vertices");
  if (strips.size() != n)
    refuse(std::to_string(strips.size()) + " strips for " + std::to_string(n) + " edges");
  Banded_polygon_2 result;
  result.is_clockwise = CGAL::is_negative(polygon.area());
  const std::vector<Line_function_2> edges = edge_functions(polygon, result.is_clockwise);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t previous = (i + n - 1) % n;
    const CGAL::Sign turn = CGAL::sign(determinant(edges[previous], edges[i]));
    if (turn == CGAL::ZERO)
      refuse(edge_names(previous, i) + " are parallel");
    result.is_reflex.push_back((turn == CGAL::POSITIVE) == result.is_clockwise);
  }
  const std::vector<Sides> sides = sides_of_strips(polygon, edges, strips);
  for (std::size_t i = 0; i < n; ++i)
    result.bands.push_back(band_of_edge(polygon, sides, result.is_reflex, i));
  check_bands(result.bands);
  result.window = window_of_lines(result.bands);
  result.polygon = std::move(polygon);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool is_model_of(const Banded_polygon_2& banded, const Polygon& polygon)
{
  const std::size_t n = banded.size();
  if (polygon.size() != n)
    return false;
  const std::vector<Line_function_2> edges = edge_functions(polygon, banded.is_clockwise);
  for (std::size_t i = 0; i < n; ++i) {
    const Band_2& band = banded.bands[i];
    if (polygon[i] == polygon[(i + 1) % n] || CGAL::is_positive(edges[i](band.tail_inner)) ||
        CGAL::is_positive(edges[i](band.head_inner)) || CGAL::is_negative(edges[i](band.tail_outer)) ||
        CGAL::is_negative(edges[i](band.head_outer)))
      return false;
  }
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Polygon model_of(const Banded_polygon_2& banded,
                                                const std::vector<std::pair<Exact_rational, Exact_rational>>& ratios)
{
  const std::size_t n = banded.size();
  if (ratios.size() != n)
    refuse(std::to_string(ratios.size()) + " pairs of ratios for " + std::to_string(n) + " edges");
  std::vector<Line_function_2> lines;
  for (std::size_t i = 0; i < n; ++i) {
    for (const Exact_rational& ratio : {ratios[i].first, ratios[i].second})
      if (ratio < 0 || ratio > 1)
        refuse("a ratio of " + edge_name(i) + " is not between 0 and 1");
    const Band_2& band = banded.bands[i];
    const Point tail = band.tail_inner + ratios[i].first * (band.tail_outer - band.tail_inner),
                head = band.head_inner + ratios[i].second * (band.head_outer - band.head_inner);
    lines.push_back(Line_function_2::through(tail, head, tail));
  }
  Polygon result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(common_zero(lines[(i + n - 1) % n], lines[i]));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::string> signature_in(const Banded_polygon_2& banded,
                                                                       const Polygon& model, const Point& point)
{
  if (!is_model_of(banded, model))
    refuse("the signature of a point in a polygon that is no model");
  std::string result;
  for (const Line_function_2& edge : edge_functions(model, banded.is_clockwise)) {
    const CGAL::Sign side = CGAL::sign(edge(point));
    if (side == CGAL::ZERO)
      return std::nullopt;
    result.push_back(side == CGAL::POSITIVE ? 'L' : 'R');
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<bool> is_inside_of(const Banded_polygon_2& banded, const Point& point)
{
  for (const Band_2& band : banded.bands)
    if (band.has(point))
      return CGAL::Uncertain<bool>::indeterminate();
  return banded.polygon.bounded_side(point) == CGAL::ON_BOUNDED_SIDE;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Signature_location location_of(const Banded_polygon_2& banded,
                                                              const std::string& signature)
{
  const std::size_t n = banded.size();
  if (signature.size() != n || signature.find_first_not_of("LR") != std::string::npos)
    refuse("the signature '" + signature + "' has not a letter L or R for each of " + std::to_string(n) + " edges");
  std::vector<Part_of_plane> parts{whole_plane(banded)};
  while (!parts.empty()) {
    const Part_of_plane part = std::move(parts.back());
    parts.pop_back();
    const std::size_t band = part.zones.size();
    if (band == n)
      return Location_rule(banded, part)(signature);
    add_cut_parts(part, banded.bands[band], signature[band] == 'R' ? Zone::OUTER : Zone::INNER, parts);
  }
  return Signature_location::NO_MODEL;
}

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_POLYGONS_OF_BANDS_H
