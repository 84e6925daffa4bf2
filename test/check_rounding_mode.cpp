// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of every test executable: each test leaves the rounding mode as it was. CGAL::sqrt() of an interval without a
// guard, for one, does not.
#include <CGAL/FPU.h>

#include <gtest/gtest.h>

namespace {

class Rounding_mode_check : public testing::EmptyTestEventListener
{
  void OnTestEnd(const testing::TestInfo& test) override
  {
    EXPECT_EQ(CGAL::FPU_get_cw(), CGAL_FE_TONEAREST) << test.name();
  }
};

[[maybe_unused]] const bool is_checked = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new Rounding_mode_check);
  return true;
}();

} // namespace
