// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Recognises lines, circles, planes, spheres, cylinders, cones and tori in data of CAD programs, which are rounded, and
// makes them exact: prints what each curve and surface is, and how far at most any of its points is moved.
//
//   exact_primitives [FILE] [--tolerance T] [--time-limit S]
//
// FILE is of GoTools (.g2) or IRIT (.itd); without it, data/surfaces/rounded_parts.g2 is taken. Exit status: 0 when all
// was looked at, 3 when not, 2 for bad input.
#include "arguments.h"
#include "healing.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>

#include <iostream>
#include <ranges>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

#ifndef DATA_DIRECTORY
#define DATA_DIRECTORY "data/"
#endif

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    double tolerance = 1e-9;
    std::vector<std::string> words = arguments_and_time_limit(argc, argv, options), files;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--tolerance" && i + 1 < words.size())
        tolerance = number_of<double>(words[++i]);
      else
        files.push_back(words[i]);
    if (files.empty())
      files = {DATA_DIRECTORY "surfaces/rounded_parts.g2"};
    if (files.size() != 1)
      throw SC::Invalid_input("usage: exact_primitives [FILE] [--tolerance T] [--time-limit S]");
    const auto file = files[0].ends_with(".g2") ? SC::IO::read_g2<K>(files[0]) : SC::IO::read_IRIT<K>(files[0]);

    const auto objects = std::views::transform([](const auto& entry) { return entry.object; });
    const auto [curves, surfaces] =
        SC::with_exact_primitives(file.curves_3 | objects, file.surfaces_3 | objects, tolerance, options);
    const auto print = [](const auto& entries, const auto& healed, const char* what) {
      for (std::size_t i = 0; i < entries.size(); ++i)
        std::cout << what << " in line " << entries[i].line << ": " << healed.primitives[i].kind
                  << ", moved by at most " << healed.primitives[i].displacement << '\n';
    };
    print(file.curves_3, curves, "curve");
    print(file.surfaces_3, surfaces, "surface");
    print_healing(curves, surfaces);
    return curves.is_complete() && surfaces.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
