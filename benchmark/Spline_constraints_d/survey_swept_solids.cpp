// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swept volumes of random solids between two bicubic surfaces beside random points, of which it is proved whether they
// are swept:
//
//   survey_swept_solids [FIRST END [POINTS [CHORD_ERROR]]]
//
// for the seeds from FIRST (1) to before END (51). Exit status 1 if a point is on the wrong side, or a boundary is not
// closed.

#include "random_swept_solids.h"

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace random_swept_solids;

int main(int argc, char** argv)
{
  const auto argument = [&](int k, double otherwise) { return k < argc ? std::atof(argv[k]) : otherwise; };
  const auto first = static_cast<unsigned>(argument(1, 1)), end = static_cast<unsigned>(argument(2, 51));
  const auto points = static_cast<std::size_t>(argument(3, 200));
  const double chord_error = argument(4, 0.02);
  int complete = 0, closed = 0;
  std::size_t wrong = 0, decided = 0;
  double seconds = 0, worst = 0;
  for (unsigned seed = first; seed < end; ++seed) {
    const Random_sweep sweep = random_sweep(seed);
    const SC::Swept_volume_3 swept = SC::swept_volume(sweep.solid, sweep.motion, {.chord_error = chord_error});
    const Comparison found = compare(sweep, swept, points, seed);
    const double deviations = std::abs(found.volume - swept.volume()) / found.deviation;
    std::cout << seed << ": " << swept << "; points " << found.points << ", wrong " << found.wrong
              << ", volume by points " << found.volume << " (" << deviations << " standard deviations)\n";
    for (const auto& part : swept.undecided())
      std::cout << "  " << part << '\n';
    complete += swept.is_complete();
    closed += CGAL::is_closed(swept.mesh()) && !swept.mesh().is_empty();
    wrong += found.wrong;
    decided += found.points;
    seconds += swept.summary().seconds;
    worst = std::max(worst, deviations);
  }
  std::cout << end - first << " solids: " << closed << " closed, " << complete << " complete, " << wrong << " of "
            << decided << " points wrong, volumes within " << worst << " standard deviations, " << seconds
            << " seconds\n";
  return wrong > 0 || closed < static_cast<int>(end - first) ? 1 : 0;
}
