// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How programs print special points that nearly coincide, beside intersections.
#ifndef NEAR_COINCIDENCES_H
#define NEAR_COINCIDENCES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/distances/near_coincidences.h>

#include <cstddef>
#include <iostream>
#include <utility>

// What the points are, their parameters, and the distance. The names of both objects are written by functions.
template <int parameters_of_first, int parameters_of_second, class Near_coincidence, class Write_first,
          class Write_second>
void print_near_coincidence(const Near_coincidence& near, const Write_first& write_first,
                            const Write_second& write_second)
{
  namespace SC = CGAL::Spline_constraints;
  const auto write = [&](std::size_t i, int parameters, const auto& write_name) {
    std::cout << ' ' << near.kind(i);
    write_name();
    std::cout.precision(17);
    for (int axis = 0; axis < parameters; ++axis) {
      const auto& [begin, end] = near.parameter_range(i, static_cast<std::size_t>(axis));
      std::cout << (axis == 0 ? " with " : " ") << (axis == 1 ? "v" : parameters == 1 ? "t" : "u");
      if (begin == end)
        std::cout << " = " << SC::to_nearest_double(begin);
      else
        std::cout << " in [" << SC::to_nearest_double(begin) << ',' << SC::to_nearest_double(end) << ']';
    }
  };
  std::cout << "near coincidence:";
  write(0, parameters_of_first, write_first);
  std::cout << ",";
  write(1, parameters_of_second, write_second);
  const auto [lower, upper] = near.distance_range();
  std::cout << ", distance in [" << lower << ',' << upper << "]";
}

#endif // NEAR_COINCIDENCES_H
