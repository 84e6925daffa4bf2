// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_BANDED_POLYGON_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_BANDED_POLYGON_2_H

#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Edge_strip_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Signature_location.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Band_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Uncertain.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

using Polygon = CGAL::Polygon_2<Exact_kernel>;

// What an approximate polygon is made of.
struct Banded_polygon_2
{
  Polygon polygon; // a model
  bool is_clockwise = false;
  std::vector<bool> is_reflex; // of the corner at the tail of each edge
  std::vector<Band_2> bands;
  Polygon window; // all points in which lines of bands, or diagonals, meet are in its interior

  std::size_t size() const { return bands.size(); }
};

// What an approximate polygon does; see there. Defined in polygons_of_bands.h; the compiled library has it.
Banded_polygon_2 banded_polygon(Polygon polygon, const std::vector<Edge_strip_2>& strips);
bool is_model_of(const Banded_polygon_2& banded, const Polygon& polygon);
Polygon model_of(const Banded_polygon_2& banded, const std::vector<std::pair<Exact_rational, Exact_rational>>& ratios);
std::optional<std::string> signature_in(const Banded_polygon_2& banded, const Polygon& model, const Point& point);
CGAL::Uncertain<bool> is_inside_of(const Banded_polygon_2& banded, const Point& point);
Signature_location location_of(const Banded_polygon_2& banded, const std::string& signature);

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_BANDED_POLYGON_2_H
