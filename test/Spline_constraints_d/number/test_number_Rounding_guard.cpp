// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <gtest/gtest.h>

#include "test_number_utilities.h"

#include <stdexcept>
#include <thread>
#include <type_traits>

namespace number_Rounding_guard_test {

using CGAL::Spline_constraints::Empty_rounding_guard;
using CGAL::Spline_constraints::Upward_rounding_guard;

static_assert(!std::is_copy_constructible_v<Upward_rounding_guard> &&
              !std::is_copy_assignable_v<Upward_rounding_guard>);
static_assert(!std::is_copy_constructible_v<Empty_rounding_guard> && !std::is_copy_assignable_v<Empty_rounding_guard>);

namespace {

// 1/3 as computed now: tells the mode by what it does instead of by what the control register says.
double third()
{
  volatile double one = 1, three = 3;
  return one / three;
}

TEST(Rounding_guard, upward_guard_sets_and_restores_every_mode)
{
  int modes = 0;
  number_testing::in_each_rounding_mode([&modes]() {
    const CGAL::FPU_CW_t before = CGAL::FPU_get_cw();
    {
      Upward_rounding_guard guard;
      EXPECT_EQ(CGAL::FPU_get_cw(), static_cast<CGAL::FPU_CW_t>(CGAL_FE_UPWARD));
      EXPECT_EQ(third(), 0x1.5555555555556p-2);
    }
    EXPECT_EQ(CGAL::FPU_get_cw(), before);
    ++modes;
  });
  EXPECT_EQ(modes, 4);
}

TEST(Rounding_guard, nested_guards_restore_what_each_found)
{
  number_testing::in_each_rounding_mode([]() {
    const CGAL::FPU_CW_t before = CGAL::FPU_get_cw();
    {
      Upward_rounding_guard outer;
      {
        const CGAL::Protect_FPU_rounding<true> other(CGAL_FE_DOWNWARD);
        EXPECT_EQ(third(), 0x1.5555555555555p-2);
        {
          Upward_rounding_guard inner;
          Empty_rounding_guard empty;
          EXPECT_EQ(third(), 0x1.5555555555556p-2);
        }
        EXPECT_EQ(CGAL::FPU_get_cw(), static_cast<CGAL::FPU_CW_t>(CGAL_FE_DOWNWARD));
      }
      EXPECT_EQ(CGAL::FPU_get_cw(), static_cast<CGAL::FPU_CW_t>(CGAL_FE_UPWARD));
    }
    EXPECT_EQ(CGAL::FPU_get_cw(), before);
  });
}

TEST(Rounding_guard, exception_restores_the_mode)
{
  number_testing::in_each_rounding_mode([]() {
    const CGAL::FPU_CW_t before = CGAL::FPU_get_cw();
    EXPECT_THROW(
        {
          Upward_rounding_guard guard;
          throw std::runtime_error("through the guard");
        },
        std::runtime_error);
    EXPECT_EQ(CGAL::FPU_get_cw(), before);
  });
}

TEST(Rounding_guard, empty_guard_changes_nothing)
{
  number_testing::in_each_rounding_mode([]() {
    const CGAL::FPU_CW_t before = CGAL::FPU_get_cw();
    Empty_rounding_guard guard;
    EXPECT_EQ(CGAL::FPU_get_cw(), before);
  });
}

TEST(Rounding_guard, mode_belongs_to_the_thread)
{
  CGAL::FPU_CW_t seen_inside = 0, seen_after = 0;
  const CGAL::FPU_CW_t before = CGAL::FPU_get_cw();
  std::thread worker([&]() {
    {
      Upward_rounding_guard guard;
      seen_inside = CGAL::FPU_get_cw();
    }
    seen_after = CGAL::FPU_get_cw();
  });
  worker.join();
  EXPECT_EQ(seen_inside, static_cast<CGAL::FPU_CW_t>(CGAL_FE_UPWARD));
  EXPECT_EQ(seen_after, before);
  EXPECT_EQ(CGAL::FPU_get_cw(), before);
}

} // namespace

} // namespace number_Rounding_guard_test
