// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The kernel of a region with a smooth boundary, and what is seen of the region from a point that is not in it.
//
// Writes region_kernel.svg. Exit status: 0 when all is proved, 3 when a part is not.
#include "printed_numbers.h"

#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  const auto curve = SC::Bspline_curve_2<K>::from_periodic(
      3, {0, 1, 2, 3, 4, 5, 6, 7, 8},
      {{6, 0}, {1.25, 1.25}, {0, 5}, {-1.25, 1.25}, {-5, 0}, {-1.25, -1.25}, {0, -4}, {1.25, -1.25}});
  const auto kernel = SC::region_kernel(curve);
  const K::Point_2 viewpoint(3.5, 0.25); // on the right of some tangents
  const auto visible = SC::visible_part(viewpoint, curve);

  std::ofstream file("region_kernel.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-4.2, -3.5, 4.9, 4.1), 600);
  picture.layer("visible");
  picture.polygon(visible.polygon(1e-3), "#eeeeee");
  for (std::size_t i = 0; i < visible.edges().size(); ++i)
    if (visible.edges()[i].kind == SC::Visible_edge_kind::SEGMENT)
      picture.polyline(visible.polyline(i, 1e-3), "#888888", 2);
  SC::draw(picture, kernel, 4);
  picture.layer("curve");
  picture.curve(curve, "black", 2);
  picture.layer("vertices");
  std::size_t arcs = 0, segments = 0;
  for (std::size_t i = 0; i < kernel.edges().size(); ++i) {
    ++(kernel.edges()[i].kind == SC::Kernel_edge_kind::ARC ? arcs : segments);
    picture.point(kernel.source(i), "black", 7);
  }
  picture.point(viewpoint, "black", 9);

  if (!kernel.is_complete() || !visible.is_complete()) {
    std::cout << "the kernel, or what is seen, is not decided\n";
    return 3;
  }
  std::cout << "kernel of " << arcs << " arcs and " << segments << " segments, area " << number_within(kernel.area())
            << " (" << difference_of(kernel.area()) << ")\n";
  std::cout << "seen from (" << viewpoint << "): area " << number_within(visible.area()) << " of "
            << number_within(SC::planar_region(curve).area()) << '\n';
}
