// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The beginning of benchmark/Spline_constraints_d/soak_solver: random and adversarial systems with planted solutions,
// by two number types; no root is lost, and none is too many.

#include "soak_comparison.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace soak_test {

using namespace solver_test;

TEST(Soak, NothingLostAndNothingExtra)
{
  Soak_report report;
  for (std::uint64_t seed = 1; seed <= 80; ++seed)
    report.add(seed, Soak_comparison(seed));
  EXPECT_EQ(report.findings, "");
  const Soak_counts sum = report.sum();
  EXPECT_EQ(sum[Soak_counts::SYSTEMS], 80u);
  EXPECT_EQ(sum[Soak_counts::LOST], 0u);
  EXPECT_EQ(sum[Soak_counts::EXTRA], 0u);
  EXPECT_GE(sum[Soak_counts::PLANTED], 200u);
  EXPECT_GE(sum[Soak_counts::MATCHED], 150u);
  EXPECT_EQ(report.kinds.size(), 12u);
  EXPECT_EQ(Soak_report::read(report.text()).text(), report.text());
}

// Two roots close to each other: more precision encloses one of them a second time, in a box that is tiny on three axes
// alone and lies in no region.
TEST(Soak, RootInAThinBoxIsThereOnce)
{
  const Soak_comparison comparison(22573);
  EXPECT_EQ(comparison.problem().planted.size(), 12u);
  EXPECT_EQ(comparison.counts()[Soak_counts::LOST] + comparison.counts()[Soak_counts::EXTRA], 0u);
}

// Gradients at an open box are so nearly dependent that 256 bits do not tell a pivot from zero.
TEST(Soak, GradientsThatRoundingCannotTellApart)
{
  const Soak_comparison comparison(580490);
  EXPECT_EQ(comparison.counts()[Soak_counts::SYSTEMS], 1u);
  EXPECT_EQ(comparison.counts()[Soak_counts::LOST] + comparison.counts()[Soak_counts::EXTRA], 0u);
}

// Four roots so close to each other that 128 bits leave boxes open. One box is beside a root of another box: it holds
// none.
TEST(Soak, RootBesideABoxIsNotInIt)
{
  const Soak_comparison comparison(689866);
  EXPECT_EQ(comparison.problem().planted.size(), 4u);
  EXPECT_EQ(comparison.counts()[Soak_counts::LOST] + comparison.counts()[Soak_counts::EXTRA], 0u);
}

// What is not a solution, and a solution that was not planted, are found out.
TEST(Soak, FindsWhatIsWrong)
{
  const std::vector<Polynomial> x = variables(2);
  const Soak_system right{"right",
                          with_equalities(cube(2, -2, 2), {square(x[0]) + square(x[1]) - 2, x[0] - x[1]}),
                          {{Rational(1), Rational(1)}, {Rational(-1), Rational(-1)}},
                          true};
  const Soak_counts counts = Soak_comparison(right).counts();
  EXPECT_EQ(counts[Soak_counts::MATCHED], 2u);
  EXPECT_EQ(counts[Soak_counts::LOST] + counts[Soak_counts::EXTRA], 0u);

  Soak_system wrong = right;
  wrong.planted[0][0] = Rational(1) + Rational(1e-9);
  const Soak_comparison comparison(wrong);
  EXPECT_EQ(comparison.counts()[Soak_counts::LOST], 1u);  // the planted one
  EXPECT_EQ(comparison.counts()[Soak_counts::EXTRA], 3u); // it is not in the exact run either; and (1, 1) is in both
  Soak_report report;
  report.add(7, comparison);
  EXPECT_EQ(report.findings, "seed 7 (right, 2 unknowns): 1 lost, 3 extra\n");

  Soak_system simple = right;
  simple.multiplicities = {1, 2};
  EXPECT_EQ(Soak_comparison(simple).counts()[Soak_counts::EXTRA], 2u);
}

} // namespace soak_test
