// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tests of floor 0 once more where CGAL::Exact_rational is made of Boost's own integers. The switches have to
// come before any header of CGAL.
#undef CGAL_USE_GMPXX
#undef CGAL_DO_NOT_USE_BOOST_MP
#undef CGAL_DISABLE_GMP
#define CGAL_DISABLE_GMP 1
#define CMAKE_OVERRIDDEN_DEFAULT_ENT_BACKEND 3   // of CGAL 6: its BOOST_BACKEND, also with Boost before 1.80

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes a branch of Boost's small-integer storage for uninitialized.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "number/test_number_Mpfr_interval.cpp"
#include "number/test_number_Number_traits.cpp"
#include "number/test_number_enclosure.cpp"

namespace {

TEST(Exact_rational, is_the_type_this_test_is_about)
{
  EXPECT_TRUE((std::is_same_v<CGAL::Spline_constraints::Exact_integer, boost::multiprecision::cpp_int>));
}

} // namespace
