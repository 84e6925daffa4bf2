// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same as `test_nearest_sites_2` between free-form curves, and within a region.
#include "expect_nearest_sites.h"

#include <gtest/gtest.h>

namespace nearest_sites_of_splines_2_test {

namespace {

using namespace nearest_site_checks;

TEST(NearestSitesOfSplines, Splines) { expect_no_wrong_answers(scene(3, 1, 2)); }
TEST(NearestSitesOfSplines, ClosedCurves) { expect_no_wrong_answers(scene(4, 1, 2)); }   // one in another
TEST(NearestSitesOfSplines, CurvesThatCross) { expect_no_wrong_answers(scene(5, 1, 4)); }
TEST(NearestSitesOfSplines, AllKinds) { expect_no_wrong_answers(scene(6, 1, 3)); }
TEST(NearestSitesOfSplines, MedialAxis) { expect_no_wrong_answers(scene(7, 1)); }

} // namespace

} // namespace nearest_sites_of_splines_2_test
