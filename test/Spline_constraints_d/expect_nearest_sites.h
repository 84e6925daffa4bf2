// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// No answer of a diagram and its arrangement in random points is wrong.
#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_EXPECT_NEAREST_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_EXPECT_NEAREST_SITES_H

#include "nearest_site_checks.h"

#include <gtest/gtest.h>

namespace nearest_site_checks {

inline void expect_no_wrong_answers(const Scene& asked)
{
  constexpr std::size_t queries = 250;
  constexpr int samples = 24;
  constexpr double error = 0.02;
  const Nearest_site_check check(asked, samples);
  const Answers answers = check.answers(queries, error, 2);
  EXPECT_TRUE(answers.is_complete);
  EXPECT_TRUE(answers.has_same_topology);
  EXPECT_EQ(answers.queries, queries);
  EXPECT_EQ(answers.wrong_faces, 0U);
  EXPECT_EQ(answers.wrong_sites, 0U);
  EXPECT_LT(answers.other_regions, 5U);
  EXPECT_GT(3 * answers.regions, 2 * check.diagram().number_of_regions());
  EXPECT_GT(answers.regions, 1U);
}

} // namespace nearest_site_checks

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_EXPECT_NEAREST_SITES_H
