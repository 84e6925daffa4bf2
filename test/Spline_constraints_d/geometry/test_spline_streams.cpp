// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves and surfaces written to a stream and read back: the same knots and control points, in every kernel.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/spline_streams.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace spline_streams_test {

namespace SC = CGAL::Spline_constraints;

// Reads them over another object, one after the other.
template <class Object>
void expect_same_after_reading(const Object& object, const Object& other)
{
  std::stringstream stream;
  stream << object << '\n' << other << '\n';
  Object first = other, second = object;
  ASSERT_TRUE(stream >> first >> second);
  for (const auto& [read, written] : {std::pair(&first, &object), std::pair(&second, &other)}) {
    EXPECT_TRUE(*read == *written);
    const auto &a = read->representation().functions(), &b = written->representation().functions();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].coefficients(), b[i].coefficients());
      for (int axis = 0; axis < a[i].dimension(); ++axis)
        EXPECT_EQ(a[i].knots(axis), b[i].knots(axis));
    }
  }
}

template <class K>
void expect_round_trips()
{
  using FT = typename K::FT;
  const FT third = FT(1) / FT(3), tenth = FT(1) / FT(10);
  const SC::Bspline_curve_2<K> spline(2, {FT(0), FT(0), FT(0), third, FT(1), FT(1), FT(1)},
                                      {{tenth, FT(-7)}, {FT(1), third}, {FT(2), FT(0)}, {FT(3), FT(1e300)}});
  expect_same_after_reading(spline,
                            SC::circle_curve<K>(typename K::Point_2(third, tenth), typename K::Point_2(FT(2), FT(1))));
  const SC::Bspline_curve_3<K> unclamped(2, {FT(0), FT(1), FT(2), FT(3), FT(4), FT(5)},
                                         {{FT(0), FT(1), third}, {tenth, FT(0), FT(0)}, {FT(0), FT(0), FT(-2)}},
                                         {FT(1), third, FT(2)});
  expect_same_after_reading(unclamped, unclamped.elevated({4}));
  const auto torus = SC::torus_surface<K>(typename K::Point_3(0, 0, 0), FT(3), FT(1));
  expect_same_after_reading(torus, torus.with_knot(0, third));
}

TEST(Spline_streams, WhatIsWrittenIsReadBack)
{
  expect_round_trips<CGAL::Simple_cartesian<double>>();
  expect_round_trips<CGAL::Epick>();
  expect_round_trips<CGAL::Epeck>();
  expect_round_trips<CGAL::Simple_cartesian<CGAL::Exact_rational>>();
}

TEST(Spline_streams, BadInput)
{
  using K = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const SC::Bspline_curve_2<K> segment(1, {0, 0, 1, 1}, {{0, 0}, {1, 2}});
  const auto reads = [&](const std::string& text) {
    SC::Bspline_curve_2<K> curve = segment;
    std::istringstream in(text);
    in >> curve;
    EXPECT_TRUE(in || curve == segment) << text;
    return static_cast<bool>(in);
  };
  EXPECT_TRUE(reads("1 2 0  1 2 0 0 1 1  0 1  0 -2/3"));
  EXPECT_TRUE(reads("1 2 0  1 2 0 0 1 1  00 010  0 -2/03"));
  for (const char* text :
       {"", "1 2 0", "2 2 0  1 2 0 0 1 1  0 1  0 2", "1 3 0  1 2 0 0 1 1  0 1  0 2", "1 2 2  1 2 0 0 1 1  0 1  0 2 1 1",
        "1 2 0  -1 2 0 0 1 1  0 1  0 2", "1 2 0  1 2 0 0 1 1  0 1  0", "1 2 0  1 2 0 0 1 1  0 1  0 2/0",
        "1 2 0  1 2 0 0 1 1  0 1  0 2/", "1 2 0  1 2 0 0 1 1  0 1  0 /2", "1 2 0  1 2 0 0 1 1  0 1  0 --2",
        "1 2 0  1 2 0 0 1 1  0 1  0 nan", "1 2 0  1 2 1 1 0 0  0 1  0 2", "1 2 1  1 2 0 0 1 1  0 1  0 2  1 -1",
        "1 2 0  1 1000000000 0 0 1 1  0 1  0 2"})
    EXPECT_FALSE(reads(text)) << text;
}

} // namespace spline_streams_test
