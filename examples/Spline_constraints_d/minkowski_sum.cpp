// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Minkowski sum of the region of a drawing and one with curved edges and corners, like letters written with the nib
// of a pen: all that the nib covers when it is moved through the letters.
//
//   minkowski_sum [DRAWING.svg]
//
// Writes minkowski_sum.svg. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;

int main(int argc, char* argv[])
{
  try {
    const auto letters = SC::IO::read_SVG_curves<K>(argc > 1 ? argv[1] : DATA_DIRECTORY "letters.svg");
    const std::vector<SC::Bspline_curve_2<K>> nib{SC::bezier_curve<K>({{-2, -2}, {0.5, -1.5}, {2, 0}, {2, 2}}),
                                                  SC::bezier_curve<K>({{2, 2}, {-0.5, 1.5}, {-2, 0}, {-2, -2}})};
    const auto sum = SC::minkowski_sum(SC::planar_region(letters), SC::planar_region(nib));

    const auto layers = SC::planar_layers(sum, 2e-2);
    std::ofstream file("minkowski_sum.svg");
    SC::SVG_writer picture(file, layers.front().areas);
    SC::draw(picture, layers, 3);
    picture.layer("nibs");
    for (const auto& letter : letters)
      for (const auto& piece : letter.bezier_pieces())
        for (const auto& curve : nib)
          picture.curve(
              curve.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, piece(piece.domain().first) - CGAL::ORIGIN)),
              "#aaa", 1);
    picture.layer("letters");
    for (const auto& letter : letters)
      picture.curve(letter, "black", 3);

    for (const auto& boundary : sum.boundaries())
      std::cout << (boundary.is_hole ? "a hole of " : "an outer boundary of ") << boundary.arcs.size() << " arcs\n";
    std::cout << "complete: " << (sum.is_complete() ? "yes" : "no") << '\n';
    return sum.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
