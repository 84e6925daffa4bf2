// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swept volumes of random solids between two bicubic surfaces, against certified membership of random points.

#include "random_swept_solids.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace random_swept_solid_test {

using namespace random_swept_solids;

TEST(Random_swept_solid, against_certified_points)
{
  int complete = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Random_sweep sweep = random_sweep(seed);
    const SC::Swept_volume_3 swept = SC::swept_volume(sweep.solid, sweep.motion, {.chord_error = 0.02});
    for (const auto& part : swept.undecided()) // thin cells may leave the topology open
      EXPECT_NE(part.reason.find("topology"), std::string::npos) << seed << ": " << part;
    complete += swept.is_complete();
    EXPECT_TRUE(!swept.is_complete() || swept.euler_characteristic() == 2) << seed; // short ways without loops
    ASSERT_FALSE(swept.mesh().is_empty()) << seed;
    EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
    EXPECT_TRUE(swept.mesh().is_valid());
    EXPECT_GT(swept.volume(), 0);
    const Comparison found = compare(sweep, swept, 40, seed);
    EXPECT_GT(found.points, 35u) << seed;
    EXPECT_EQ(found.wrong, 0u) << seed;
    EXPECT_LT(std::abs(found.volume - swept.volume()), 4 * found.deviation) << seed << ": " << swept;
  }
  EXPECT_EQ(complete, 5);
}

// Triangles of two sheets that are near each other may leave a slit, with a handle that the truth has not.
TEST(Random_swept_solid, thin_handles)
{
  for (const unsigned seed : {18u, 30u}) { // which had one each
    const Random_sweep sweep = random_sweep(seed);
    const SC::Swept_volume_3 swept = SC::swept_volume(sweep.solid, sweep.motion, {.chord_error = 0.02});
    EXPECT_TRUE(swept.is_complete()) << seed << ": " << swept;
    EXPECT_EQ(swept.number_of_components(), 1u) << seed;
    EXPECT_EQ(swept.euler_characteristic(), 2) << seed;
    EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
    EXPECT_TRUE(swept.mesh().is_valid());
    const Comparison found = compare(sweep, swept, 40, seed);
    EXPECT_GT(found.points, 35u) << seed;
    EXPECT_EQ(found.wrong, 0u) << seed;
  }
}

// All is the same of a sweep that is turned and moved, but for the error of triangles, which are others.
TEST(Random_swept_solid, rigid_motions)
{
  const Rational a = Rational(2) / 7, b = Rational(3) / 7, c = Rational(6) / 7;
  const std::vector<K::Aff_transformation_3> maps{
      {a, b, c, 1, b, -c, a, -2, c, a, -b, Rational(1) / 3},
      {0, Rational(3) / 5, Rational(4) / 5, 0, 0, -Rational(4) / 5, Rational(3) / 5, 5, 1, 0, 0, 0}};
  for (const unsigned seed : {8u, 11u}) {
    const Random_sweep sweep = random_sweep(seed);
    const SC::Swept_volume_3 swept = SC::swept_volume(sweep.solid, sweep.motion, {.chord_error = 0.02});
    EXPECT_TRUE(swept.is_complete()) << seed << ": " << swept;
    for (const auto& map : maps) {
      const auto constant = [&](const Rational& value) {
        const auto [begin, end] = sweep.motion.domain();
        return Motion::Function({0}, {{begin, end}}, {value});
      };
      std::array<std::array<Motion::Function, 3>, 3> columns;
      std::array<Motion::Function, 3> path;
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
          columns[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] = constant(map.m(i, k));
        path[static_cast<std::size_t>(i)] = constant(map.m(i, 3));
      }
      const Motion moved = Motion(columns, path, constant(1)) * sweep.motion;
      const SC::Swept_volume_3 other = SC::swept_volume(sweep.solid, moved, {.chord_error = 0.02});
      EXPECT_TRUE(other.is_complete()) << seed << ": " << other;
      EXPECT_EQ(other.number_of_components(), swept.number_of_components()) << seed;
      EXPECT_EQ(other.euler_characteristic(), swept.euler_characteristic()) << seed;
      EXPECT_NEAR(other.volume(), swept.volume(), 0.01 * swept.area()) << seed;
    }
  }
}

} // namespace random_swept_solid_test
