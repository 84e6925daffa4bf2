// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_g2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace read_g2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = K::FT;
using P2 = K::Point_2;
using P3 = K::Point_3;
using Curve_2 = SC::Bspline_curve_2<K>;
using Curve_3 = SC::Bspline_curve_3<K>;
using Surface = SC::Bspline_surface_3<K>;

namespace {

SC::Spline_file<K> read(const std::string& content)
{
  std::istringstream in(content);
  return SC::IO::read_g2<K>(in, "test.g2");
}

TEST(Read_g2, curves)
{
  const auto file = read("100 1 0 4 255 0 0 255\n2 0\n4 3\n0 0 0 0.5 1 1 1\n0 0  1 0.1  2 0  3 -1e-1\n\n"
                         "  100 1 0 0  2 1  3 3  0 0 0 1 1 1\n1 0 1\n1 1 1\n0 2 2\n"
                         "100 1 0 0  3 0  2 2  0 0 1 1  1 2 3  4 5 6");
  ASSERT_EQ(file.curves_2.size(), 2u);
  ASSERT_EQ(file.curves_3.size(), 1u);
  EXPECT_TRUE(file.surfaces_3.empty());
  const FT tenth = FT(1) / 10;
  EXPECT_EQ(file.curves_2[0].object.control_points(), (std::vector<P2>{{0, 0}, {1, tenth}, {2, 0}, {3, -tenth}}));
  EXPECT_EQ(file.curves_2[0].object.knots()[3], FT(1) / 2);
  EXPECT_EQ(file.curves_2[0].line, 1);
  EXPECT_EQ(file.curves_2[1].line, 7);
  EXPECT_EQ(file.curves_2[1].column, 3);
  const P2 p = file.curves_2[1].object(FT(1) / 3);   // a quarter of the unit circle
  EXPECT_EQ(CGAL::squared_distance(p, P2(0, 0)), FT(1));
  EXPECT_EQ(file.curves_2[1].object.control_weights(), (std::vector<FT>{1, 1, 2}));
  EXPECT_EQ(file.curves_3[0].object.target(), P3(4, 5, 6));
}

TEST(Read_g2, surfaces_have_the_first_parameter_fastest)
{
  const auto file = read("200 1 0 0\n3 0\n3 2\n0 0 1 2 2\n2 2\n0 0 1 1\n0 0 0  1 0 0  2 0 0\n0 1 0  1 1 5  2 1 0\n");
  ASSERT_EQ(file.surfaces_3.size(), 1u);
  const Surface& surface = file.surfaces_3[0].object;
  EXPECT_EQ(surface(FT(2), FT(0)), P3(2, 0, 0));
  EXPECT_EQ(surface(FT(1), FT(1)), P3(1, 1, 5));
}

TEST(Read_g2, what_is_written_is_read_back)
{
  std::mt19937 random(3);
  const auto number = [&](int lower, int upper) {
    return FT(std::uniform_int_distribution<int>(lower, upper)(random)) / 8;
  };
  const auto knots = [](int degree, int size) {
    std::vector<FT> result(degree + 1, FT(0));
    for (int i = 1; i < size - degree; ++i)
      result.push_back(FT(i) / 4);
    result.insert(result.end(), degree + 1, FT(size - degree) / 4);
    return result;
  };
  std::ostringstream out;
  std::vector<Curve_2> curves_2;
  std::vector<Curve_3> curves_3;
  std::vector<Surface> surfaces;
  for (int trial = 0; trial < 12; ++trial) {
    const int p = 1 + trial % 4, q = 1 + trial % 3, m = p + 1 + trial % 5, n = q + 1 + trial % 2;
    const auto some = [&](int size) {
      std::vector<FT> result;
      for (int i = 0; i < size && trial % 2 == 1; ++i)
        result.push_back(number(1, 30));
      return result;
    };
    std::vector<P2> points_2;
    std::vector<P3> points_3, net;
    for (int i = 0; i < m; ++i) {
      points_2.emplace_back(number(-99, 99), number(-99, 99));
      points_3.emplace_back(number(-99, 99), number(-99, 99), number(-99, 99));
    }
    for (int i = 0; i < m * n; ++i)
      net.emplace_back(number(-99, 99), number(-99, 99), number(-99, 99));
    curves_2.emplace_back(p, knots(p, m), points_2, some(m));
    curves_3.emplace_back(p, knots(p, m), points_3, some(m));
    surfaces.emplace_back(std::array<int, 2>{p, q}, knots(p, m), knots(q, n), net, some(m * n));
    SC::IO::write_g2(out, curves_2.back());
    SC::IO::write_g2(out, surfaces.back());
    SC::IO::write_g2(out, curves_3.back());
  }
  const auto file = read(out.str());
  ASSERT_EQ(file.curves_2.size(), 12u);
  ASSERT_EQ(file.curves_3.size(), 12u);
  ASSERT_EQ(file.surfaces_3.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_TRUE(file.curves_2[i].object == curves_2[i]) << i;
    EXPECT_EQ(file.curves_2[i].object.is_rational(), i % 2 == 1);
    EXPECT_TRUE(file.curves_3[i].object == curves_3[i]) << i;
    EXPECT_TRUE(file.surfaces_3[i].object == surfaces[i]) << i;
    EXPECT_EQ(file.surfaces_3[i].object.knots(1), surfaces[i].knots(1));
  }
}

TEST(Read_g2, errors_tell_the_place)
{
  struct Bad_input
  {
    std::string content;
    int line, column;
    std::string text, part;
  };
  const std::vector<Bad_input> bad_inputs{
      {"210 1 0 0", 1, 1, "210", "only the classes"},
      {"x", 1, 1, "x", "the type of a class"},
      {"100 1 0", 1, 8, "", "the number of auxiliary data"},
      {"100 1 0 0\n4 0", 2, 1, "4", "the dimension"},
      {"100 1 0 0\n2 2", 2, 3, "2", "whether there are weights"},
      {"100 1 0 0\n2 0\n1000 4", 3, 1, "1000", "fits the file"},
      {"100 1 0 0\n2 0\n2 3\n0 0 0 1 1", 3, 3, "3", "the order"},
      {"100 1 0 0\n2 0\n2 0\n0 0 0 1 1", 3, 3, "0", "the order"},
      {"100 1 0 0\n2 0\n2 2.0\n0 0 0 1 1", 3, 3, "2.0", "the order, an integer"},
      {"100 1 0 0\n2 0\n2 -2\n0 0 0 1 1", 3, 3, "-2", "the order"},
      {"100 1 0 0\n2 0\n2 2\n0 0 1 b", 4, 7, "b", "a knot"},
      {"100 1 0 0\n2 0\n2 2\n0 0 1 1\n1 2 3", 5, 6, "", "a coordinate"},
      {"100 1 0 0\n2 0\n2 2\n0 0 1 1\n1 2 nan 1", 5, 5, "nan", "a coordinate"},
      {"\n100 1 0 0\n2 0\n2 2\n0 1 0 1\n1 2 3 1", 2, 1, "100", "knot"},
      {"100 1 0 0\n2 1\n2 2\n0 0 1 1\n1 2 1 3 1 -1", 1, 1, "100", "weight"},
      {"200 1 0 0\n2 0\n1 1\n0 1\n1 1\n0 1\n0 0", 1, 1, "200", "in the plane"},
      {"200 1 0 0\n3 0\n40 1\n" +
           [] {
             std::string s;
             for (int i = 0; i <= 40; ++i)
               s += "0 ";
             return s;
           }() +
           "\n9 1\n0 1 2 3 4 5 6 7 8 9\n1 1 1",
       7, 1, "1", "too short"},
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
  EXPECT_THROW(SC::IO::read_g2<K>("/no/such/file.g2"), SC::Parse_error);
  EXPECT_TRUE(read(" \n").curves_2.empty());
}

} // namespace

} // namespace read_g2_test
