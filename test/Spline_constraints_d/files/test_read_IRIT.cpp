// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace read_IRIT_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = K::FT;
using P2 = K::Point_2;
using P3 = K::Point_3;

namespace {

SC::Spline_file<K> read(const std::string& content)
{
  std::istringstream in(content);
  return SC::IO::read_IRIT<K>(in, "test.itd");
}

TEST(Read_IRIT, curves_in_groups)
{
  const auto file = read("Irit Version 4.0,\nDate: today.\n\n"
                         "[OBJECT GROUP\n"
                         "  [OBJECT [rgb \"1,]2\"] [color 3] ARC\n"
                         "    [CURVE BSPLINE 3 3 P2\n      [KV 0 0 0 1 1 1]\n      [1 1 0] [1 1 1] [2 0 2]]\n"
                         "  ]\n"
                         "  [OBJECT\n    [CURVE BEZIER 3 E3 [width 2]\n [0 0 0] [.1 2 3] [4 0 -1e0]\n]]\n"
                         "]\n"
                         "[OBJECT M [MATRIX 1 0 [0]]] [OBJECT P [POLYGON 1 [3 [0 0 0]]]]\n"
                         "[CURVE BSPLINE 2 2 E2 [KV 0 0 1 1] [0 0] [1 1]]\n");
  ASSERT_EQ(file.curves_2.size(), 2u);
  ASSERT_EQ(file.curves_3.size(), 1u);
  EXPECT_EQ(file.curves_2[0].name, "ARC");
  EXPECT_EQ(file.curves_2[0].line, 6);
  EXPECT_EQ(file.curves_2[0].column, 5);
  EXPECT_EQ(CGAL::squared_distance(file.curves_2[0].object(FT(1) / 3), P2(0, 0)), FT(1));
  EXPECT_EQ(file.curves_2[0].object.target(), P2(0, 1));
  EXPECT_EQ(file.curves_3[0].name, "GROUP");
  EXPECT_EQ(file.curves_3[0].object.control_points(), (std::vector<P3>{{0, 0, 0}, {FT(1) / 10, 2, 3}, {4, 0, -1}}));
  EXPECT_EQ(file.curves_2[1].name, "");
  EXPECT_EQ(file.curves_2[1].object.target(), P2(1, 1));
}

TEST(Read_IRIT, surfaces_have_the_first_parameter_fastest)
{
  const auto file =
      read("[SURFACE BSPLINE 3 2 2 2 E3 [KV 0 0 1 2 2] [KV 0 0 1 1] [0 0 0] [1 0 0] [2 0 0] [0 1 0] [1 1 5] [2 1 0]]\n"
           "[SURFACE BEZIER 2 2 P3 [1 0 0 0] [2 2 0 0] [1 0 1 0] [2 2 2 4]]");
  ASSERT_EQ(file.surfaces_3.size(), 2u);
  EXPECT_EQ(file.surfaces_3[0].object(FT(1), FT(1)), P3(1, 1, 5));
  EXPECT_EQ(file.surfaces_3[0].object(FT(2), FT(0)), P3(2, 0, 0));
  EXPECT_EQ(file.surfaces_3[1].object(FT(1), FT(1)), P3(1, 1, 2));
  EXPECT_EQ(file.surfaces_3[1].object(FT(1), FT(0)), P3(1, 0, 0));
}

TEST(Read_IRIT, periodic_axes_are_closed)
{
  const auto file = read("[CURVE BSPLINE 4 3 E2 [KVP -2 -1 0 1 2 3 4 5 6] [1 0] [0 1] [-1 0] [0 -1]]\n"
                         "[SURFACE BSPLINE 2 4 2 3 E3 [KV 0 0 1 1] [KVP -1 -0.5 0 0.5 1 1.5 2 2.5 3] [1 0 0] [1 0 1] "
                         "[0 1 0] [0 1 1] [-1 0 0] [-1 0 1] [0 -1 0] [0 -1 1]]");
  ASSERT_EQ(file.curves_2.size(), 1u);
  ASSERT_EQ(file.surfaces_3.size(), 1u);
  const auto& curve = file.curves_2[0].object;
  EXPECT_EQ(curve.domain(), (std::pair<FT, FT>(0, 4)));
  EXPECT_TRUE(curve.is_closed());
  EXPECT_EQ(curve.tangent(FT(0)), curve.tangent(FT(4)));
  EXPECT_EQ(curve(FT(0)), P2(FT(1) / 2, FT(1) / 2));
  const auto& surface = file.surfaces_3[0].object;
  EXPECT_TRUE(surface.is_closed(1));
  EXPECT_FALSE(surface.is_closed(0));
  EXPECT_EQ(surface(FT(1), FT(0)), P3(FT(1) / 2, FT(1) / 2, 1));
}

TEST(Read_IRIT, errors_tell_the_place)
{
  struct Bad_input
  {
    std::string content;
    int line, column;
    std::string text, part;
  };
  const std::vector<Bad_input> bad_inputs{
    {"[OBJECT A\n  [CURVE SPIRAL", 2, 10, "SPIRAL", "BSPLINE or BEZIER"},
    {"[OBJECT A", 1, 1, "[OBJECT", "not closed"},
    {"[OBJECT A]]", 1, 11, "]", "not opened"},
    {"x\n [POLYGON [1 2]", 2, 2, "[POLYGON", "not closed"},
    {"[OBJECT \"a]", 1, 1, "[OBJECT", "not closed"},
    {"[CURVE BEZIER 2000 E2]", 1, 15, "2000", "fits the file"},
    {"[CURVE BSPLINE 2 3 E2 [KV 0 0 0 1 1]]", 1, 18, "3", "the order"},
    {"[CURVE BEZIER 2 E4 [0 0] [1 1]]", 1, 17, "E4", "E2, E3, P2 or P3"},
    {"[CURVE BSPLINE 2 2 E2 [0 0] [1 1]]", 1, 24, "0", "KV or KVP"},
    {"[CURVE BSPLINE 2 2 E2 [KV 0 0 1]\n[0 0] [1 1]]", 1, 32, "]", "a knot"},
    {"[CURVE BSPLINE 2 2 E2\n [KV 0 0 1 1 2] [0 0] [1 1]]", 2, 14, "2", "expected ']'"},
    {"[CURVE BEZIER 2 E2\n[0 0] [1]]", 2, 9, "]]", "a coordinate"},
    {"[CURVE BEZIER 2 E2\n[0 0]]", 2, 6, "]", "expected '['"},
    {"[CURVE BEZIER 2 E2 [0 0] [1 1] [2 2]]", 1, 32, "[2", "expected ']'"},
    {"\n[CURVE BSPLINE 2 2 E2 [KV 0 1 0 1] [0 0] [1 1]]", 2, 1, "[CURVE", "knot"},
    {"[CURVE BEZIER 2 P2 [1 0 0] [-1 1 1]]", 1, 1, "[CURVE", "weight"},
    {"[SURFACE BEZIER 1 1 E2 [0 0]]", 1, 1, "[SURFACE", "in the plane"},
    {"[OBJECT [TRIMSRF [SURFACE]]]", 1, 9, "[TRIMSRF", "not supported"},
  };
  for (const Bad_input& bad : bad_inputs)
    try {
      read(bad.content);
      ADD_FAILURE() << "no error in " << bad.content;
    } catch (const SC::Parse_error& error) {
      EXPECT_EQ(error.line(), bad.line) << error.what();
      EXPECT_EQ(error.column(), bad.column) << error.what();
      EXPECT_EQ(error.text(), bad.text) << error.what();
      EXPECT_NE(std::string(error.what()).find(bad.part), std::string::npos) << error.what();
    }
  for (const std::string& begin : {std::string("[OBJECT "), std::string("[POLYGON ")}) {
    std::string deep;
    for (int i = 0; i < 100000; ++i)
      deep += begin;
    EXPECT_THROW(read(deep), SC::Parse_error);
  }
  EXPECT_THROW(SC::IO::read_IRIT<K>("/no/such/file.itd"), SC::Parse_error);
}

} // namespace

} // namespace read_IRIT_test
