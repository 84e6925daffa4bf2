// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of patches of planes, quadrics, tori and bilinear surfaces in the positions that mechanical parts have:
// numbers of closed and open curves and of singular points, by geometry, and points on both surfaces.

#include "pairs_of_primitives.h"

#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace patches_of_primitives {

double distance(const Surface& surface, const std::array<double, 2>& uv, const Point& p)
{
  const auto within = [&](int axis) {
    return (std::min)((std::max)(Rational(uv[axis]), surface.domain(axis).first), surface.domain(axis).second);
  };
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(surface(within(0), within(1)), p)));
}

TEST(Pairs_of_primitives, patches)
{
  std::size_t decided = 0;
  for (const pairs_of_primitives::Pair& pair : pairs_of_primitives::all_pairs()) {
    const bool is_slow =
        pair.name.starts_with("tor") || pair.name.ends_with("torus") || pair.name.starts_with("ball in torus");
    if (pair.has_common_pole || is_slow)
      continue;
    SCOPED_TRACE(pair.name);
    const auto set = SC::intersection_curves(pair.a.patch, pair.b.patch);
    EXPECT_EQ(set.is_complete(), pair.counts[0] != "u");
    if (!set.is_complete())
      continue;
    ++decided;
    std::ostringstream counts;
    counts << set.number_of_closed_curves() << '/' << set.number_of_open_curves() << '/'
           << set.singular_points().size();
    EXPECT_EQ(counts.str(), pair.counts[0]);
    EXPECT_TRUE(set.points().empty());
    for (const auto& curve : set.curves()) {
      const auto samples = set.samples(curve.arcs.front(), 0.5);
      for (const auto& sample : {samples.front(), samples[samples.size() / 2], samples.back()}) {
        EXPECT_LT(distance(pair.a.patch, sample.parameters[0].value(), sample.point), 1e-9);
        EXPECT_LT(distance(pair.b.patch, sample.parameters[1].value(), sample.point), 1e-9);
      }
      for (const int side : {0, 1})
        EXPECT_NE(set.end(curve, side).kind(), SC::Intersection_kind::UNDECIDED);
    }
    for (const auto& point : set.singular_points()) {
      EXPECT_LT(distance(pair.a.patch, {point.parameter(0, 0), point.parameter(0, 1)}, point.point()), 1e-7);
      EXPECT_LT(distance(pair.b.patch, {point.parameter(1, 0), point.parameter(1, 1)}, point.point()), 1e-7);
    }
  }
  EXPECT_GT(decided, 70u);
}

} // namespace patches_of_primitives
