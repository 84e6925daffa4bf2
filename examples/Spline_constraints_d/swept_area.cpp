// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a broad nib writes: all that a region covers when it is moved along a curve.
//
// Writes swept_area.svg, and swept_area.wkt, with the area as well-known text. Exit status: 0 when nothing is
// undecided, 3 when something is.
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;

int main()
{
  const auto nib =
      SC::polyline_curve(std::vector<Point>{{-0.75, -0.5}, {-0.625, -0.75}, {0.75, 0.5}, {0.625, 0.75}, {-0.75, -0.5}});
  const SC::Bspline_curve_2<K> path(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4},
                                    {{9, 6}, {7, 2}, {3, -1}, {-1, 3}, {3, 8}, {6, 1}, {9, 0.5}});
  const auto area = SC::swept_area(SC::planar_region(nib), path);

  const auto layers = SC::planar_layers(area, 2e-3);
  std::ofstream text("swept_area.wkt");
  SC::IO::write_WKT(text, layers);
  std::ofstream file("swept_area.svg");
  SC::SVG_writer picture(file, layers.front().areas);
  SC::draw(picture, layers);
  picture.layer("copies");
  for (double t = 0; t <= 4; t += 0.25)
    picture.curve(nib.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, path(t) - CGAL::ORIGIN)), "#888", 1);
  picture.layer("path");
  picture.curve(path, "black", 2);

  std::size_t boundaries = 0;   // parts of boundaries may be parts of the same one
  for (const auto& boundary : area.boundaries()) {
    boundaries += boundary.is_hole || boundary.outer;
    std::cout << (boundary.is_hole     ? "a hole of "
                      : boundary.outer ? "an outer boundary of "
                                       : "a part of a boundary, of ")
              << boundary.arcs.size() << " arcs\n";
  }
  for (const auto& part : area.undecided())
    std::cout << part << '\n';
  std::cout << "boundaries: " << (area.is_complete() ? "" : "at least ") << boundaries
            << "; undecided: " << area.undecided().size() << "; complete: " << (area.is_complete() ? "yes" : "no")
            << '\n';
  return area.is_complete() ? 0 : 3;
}
