// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A region is written and read again without rounding, and handed to the Boolean operations of CGAL: exactly, as its
// boundaries are circles and segments, and within a given error, as do offsets.
#include <CGAL/Spline_constraints_d/geometry/conversions/circle_segment_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_region_streams_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_circular_polygons_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_general_polygons_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

#include <iostream>
#include <sstream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Gps_circle_segment_traits_2<K>;
using Region = SC::Planar_region_2<K>;

CGAL::General_polygon_set_2<Traits> set_of(const std::vector<Traits::Polygon_with_holes_2>& polygons)
{
  CGAL::General_polygon_set_2<Traits> result;
  for (const auto& polygon : polygons)
    result.insert(polygon);
  return result;
}

int main()
{
  const K::Point_2 center(0, 0);
  const Region ring(std::vector{SC::circle_curve(center, K::FT(3)), SC::circle_curve(center, K::FT(2))});
  std::stringstream text;
  text << ring;
  Region read(std::vector{SC::circle_curve(center, K::FT(1))});
  text >> read;
  std::cout << "read: " << read.curves().size() << " curves, " << read.number_of_holes() << " hole\n";

  const auto exact = SC::to_general_polygons<Traits>(
      read, [](const auto& piece) { return SC::to_circle_segment_traits_curves<Traits::Curve_2>(piece); });
  const auto grown = SC::trimmed_offset(read, 0.5);
  const auto near = SC::to_circular_polygons<Traits>(grown, 1e-3);
  std::cout << "grown: " << near.size() << " part, " << near.front().number_of_holes() << " hole\n";
  auto margin = set_of(near);
  margin.difference(set_of(exact));
  std::vector<Traits::Polygon_with_holes_2> parts;
  margin.polygons_with_holes(std::back_inserter(parts));
  std::cout << "without the ring itself: " << parts.size() << " parts\n";
  return read.number_of_holes() == 1 && parts.size() == 2 ? 0 : 1;
}
