// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Minkowski sum of the region of a drawing and one with curved edges and corners, like letters written with the nib
// of a pen: all that the nib covers when it is moved through the letters.
//
//   minkowski_sum [DRAWING.svg] [--time-limit S]
//
// Writes minkowski_sum.svg, if nothing is undecided. Exit status: 0 when nothing is undecided, 3 when something is, 2
// for bad input.
#include "arguments.h"

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

using Curves = std::vector<SC::Bspline_curve_2<K>>;

void write_picture(const SC::Minkowski_sum_2<K>& sum, const Curves& letters, const Curves& nib)
{
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
}

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto arguments = arguments_and_time_limit(argc, argv, options);
    const auto letters = SC::IO::read_SVG_curves<K>(arguments.empty() ? DATA_DIRECTORY "letters.svg" : arguments[0]);
    const Curves nib{SC::bezier_curve<K>({{-2, -2}, {0.5, -1.5}, {2, 0}, {2, 2}}),
                     SC::bezier_curve<K>({{2, 2}, {-0.5, 1.5}, {-2, 0}, {-2, -2}})};
    const auto region = SC::planar_region(letters, options);
    if (!region.is_complete()) {
      std::cout << region.undecided().front() << "\nthe region: undecided; complete: no\n";
      return 3;
    }
    const auto sum = SC::minkowski_sum(region, SC::planar_region(nib), after(region.summary().seconds, options));

    if (sum.is_complete())
      write_picture(sum, letters, nib);

    std::size_t boundaries = 0;   // parts of boundaries may be parts of the same one
    for (const auto& boundary : sum.boundaries()) {
      boundaries += boundary.is_hole || boundary.outer;
      std::cout << (boundary.is_hole     ? "a hole of "
                        : boundary.outer ? "an outer boundary of "
                                         : "a part of a boundary, of ")
                << boundary.arcs.size() << " arcs\n";
    }
    for (const auto& part : sum.undecided())
      std::cout << part << '\n';
    std::cout << "boundaries: " << (sum.is_complete() ? "" : "at least ") << boundaries
              << "; undecided: " << sum.undecided().size() << "; complete: " << (sum.is_complete() ? "yes" : "no")
              << '\n';
    return sum.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
