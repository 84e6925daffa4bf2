// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tests of floor 0 once more where CGAL::Exact_rational is mpq_class. The switches have to come before any header
// of CGAL.
#undef CGAL_USE_GMPXX
#undef CGAL_DO_NOT_USE_BOOST_MP
#undef CGAL_DISABLE_GMP
#define CGAL_USE_GMPXX 1

#include "number/test_number_Mpfr_interval.cpp"
#include "number/test_number_Number_traits.cpp"
#include "number/test_number_enclosure.cpp"

namespace {

TEST(Exact_rational, is_the_type_this_test_is_about) { EXPECT_TRUE((std::is_same_v<CGAL::Exact_rational, mpq_class>)); }

} // namespace
