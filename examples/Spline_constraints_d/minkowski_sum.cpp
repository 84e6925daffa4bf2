// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Minkowski sum of two regions with curved edges: all that one of them covers when it is moved along the other one. The second region has corners, and closes the bay of the first one, so that the sum has a hole.
//
// Writes minkowski_sum.svg. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sums_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;

int main()
{
  try {
    const auto bay = SC::Bspline_curve_2<K>::from_periodic(3, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {{0, 0}, {8, -1}, {9, 4}, {2, 0.5}, {2, 6.5}, {9, 3}, {8, 8}, {0, 7}});
    const std::vector<SC::Bspline_curve_2<K>> leaf{SC::bezier_curve<K>({{0, -1}, {1, -0.5}, {1, 0.75}, {0, 1.25}}), SC::bezier_curve<K>({{0, 1.25}, {-0.5, 0.5}, {-0.5, -0.25}, {0, -1}})};
    const auto a = SC::planar_region(bay), b = SC::planar_region(leaf);
    const auto sum = SC::minkowski_sum(a, b);

    const auto layers = SC::planar_layers(sum, 2e-3);
    std::ofstream file("minkowski_sum.svg");
    SC::SVG_writer picture(file, layers.front().areas);
    SC::draw(picture, layers, 3);
    picture.layer("copies");
    for (double t = 0; t < bay.domain().second; t += 0.25)
      for (const auto& curve : leaf)
        picture.curve(curve.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, bay(t) - CGAL::ORIGIN)), "#aaa", 1);
    picture.layer("bay");
    picture.curve(bay, "black", 3);

    for (const auto& boundary : sum.boundaries())
      std::cout << (boundary.is_hole ? "a hole of " : "an outer boundary of ") << boundary.arcs.size() << " arcs\n";
    std::cout << "complete: " << (sum.is_complete() ? "yes" : "no") << '\n';
    return sum.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
