// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random dense cubic and quartic surfaces in a cube, 200 unless the command line says how many: how many are complete,
// how often their Euler characteristic is that of a Morse count, and times.

#include "morse_count.h"

#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <random>
#include <vector>

int main(int argc, char** argv)
{
  namespace SC = CGAL::Spline_constraints;
  const int samples = argc > 1 ? std::atoi(argv[1]) : 200;
  std::mt19937 random(5353);
  int complete = 0, counted = 0, equal = 0;
  std::size_t surfaces = 0, closed = 0, loops = 0;
  int least = 0, greatest = 0;
  std::vector<double> seconds;
  for (int k = 0; k < samples; ++k) {
    const morse_count::Polynomial f = morse_count::Polynomial::random(3 + k % 2, random);
    const SC::Surface_solution_set_d set = SC::solve_surfaces(morse_count::surface_in_cube(f));
    const std::optional<int> expected = morse_count::Morse_count(f)();
    seconds.push_back(set.summary().seconds);
    complete += set.is_complete() ? 1 : 0;
    counted += expected.has_value() ? 1 : 0;
    equal += set.is_complete() && expected == set.euler_characteristic() ? 1 : 0;
    if (!set.is_complete() || expected != set.euler_characteristic())
      std::cout << "number " << k << ", Morse count " << (expected ? std::to_string(*expected) : "none") << ", " << set
                << "\n"
                << f.in_unknowns({0, 1, 2}) << "\n";
    surfaces += set.surfaces().size();
    loops += set.number_of_boundary_loops();
    for (const SC::Solution_surface& surface : set.surfaces())
      closed += surface.is_closed() ? 1 : 0;
    least = (std::min)(least, set.euler_characteristic());
    greatest = (std::max)(greatest, set.euler_characteristic());
  }
  std::sort(seconds.begin(), seconds.end());
  std::cout << samples << " systems: " << complete << " complete, " << counted << " Morse counts, " << equal
            << " equal; " << surfaces << " surfaces, " << closed << " closed, " << loops
            << " boundary loops, characteristics " << least << " to " << greatest << "; median "
            << 1e3 * seconds[seconds.size() / 2] << " ms, longest " << 1e3 * seconds.back() << " ms\n";
}
