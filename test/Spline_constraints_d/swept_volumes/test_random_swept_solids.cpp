// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swept volumes of random solids between two bicubic surfaces, against certified membership of random points.

#include "random_swept_solids.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>

namespace random_swept_solid_test {

using namespace random_swept_solids;

TEST(Random_swept_solid, against_certified_points)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Random_sweep sweep = random_sweep(seed);
    const SC::Swept_volume_3 swept = SC::swept_volume(sweep.solid, sweep.motion, {.chord_error = 0.02});
    for (const auto& part : swept.undecided()) // thin cells may leave the topology open
      EXPECT_NE(part.reason.find("topology"), std::string::npos) << seed << ": " << part;
    ASSERT_FALSE(swept.mesh().is_empty()) << seed;
    EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
    EXPECT_TRUE(swept.mesh().is_valid());
    EXPECT_GT(swept.volume(), 0);
    const Comparison found = compare(sweep, swept, 40, seed);
    EXPECT_GT(found.points, 35u) << seed;
    EXPECT_EQ(found.wrong, 0u) << seed;
    EXPECT_LT(std::abs(found.volume - swept.volume()), 4 * found.deviation) << seed << ": " << swept;
  }
}

} // namespace random_swept_solid_test
