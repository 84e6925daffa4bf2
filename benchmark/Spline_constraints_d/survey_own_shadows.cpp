// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What random surfaces hide of themselves: how many of these answers are complete, how many cells are undecided, times,
// and labels beside rays. Exit status: 0 if no label differs.
//
//   survey_own_shadows [FIRST END [RAYS]]

#include "random_own_shadows.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <vector>

int main(int argc, char** argv)
{
  const int first = argc > 2 ? std::atoi(argv[1]) : 0, end = argc > 2 ? std::atoi(argv[2]) : 44,
            rays = argc > 3 ? std::atoi(argv[3]) : 100;
  int complete = 0, right = 0, wrong = 0;
  std::vector<double> seconds;
  for (int i = first; i < end; ++i) {
    const random_own_shadows::Scene scene = random_own_shadows::scene(static_cast<unsigned>(i));
    const std::clock_t begin = std::clock();
    const auto regions = scene.visible_regions();
    seconds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    const auto counts = random_own_shadows::compare_with_rays(regions, scene, rays);
    complete += regions.is_complete() ? 1 : 0;
    right += counts.free + counts.obstructed;
    wrong += counts.wrong;
    std::cout << i << ": " << regions.cells().size() << " cells, " << regions.undecided().size() << " undecided, "
              << regions.regions().size() << " regions, " << seconds.back() << " s; rays: " << counts.free << " free, "
              << counts.obstructed << " not, " << counts.wrong << " differ" << std::endl;
  }
  std::sort(seconds.begin(), seconds.end());
  std::cout << end - first << " surfaces: " << complete << " complete; median " << seconds[seconds.size() / 2]
            << " s, longest " << seconds.back() << " s; " << right << " rays agree, " << wrong << " differ\n";
  return wrong == 0 ? 0 : 1;
}
