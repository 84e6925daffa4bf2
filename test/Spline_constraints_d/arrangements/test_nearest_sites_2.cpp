// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// In random points between straight and circular sites, the face of the arrangement of a Voronoi diagram that point
// location finds, and the nearest sites, are as distances from the curves tell; `benchmark_nearest_sites` asks far
// more.
#include "expect_nearest_sites.h"

#include <gtest/gtest.h>

namespace nearest_sites_2_test {

namespace {

using namespace nearest_site_checks;

TEST(NearestSites, PointsAndSegments) { expect_no_wrong_answers(scene(0, 1)); }
TEST(NearestSites, Circles) { expect_no_wrong_answers(scene(1, 1, 1)); }   // one in another
TEST(NearestSites, CircularArcs) { expect_no_wrong_answers(scene(2, 1, 4)); }

} // namespace

} // namespace nearest_sites_2_test
