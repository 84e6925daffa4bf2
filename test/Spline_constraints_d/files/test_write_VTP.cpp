// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/write_VTP.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace write_VTP_test {

namespace SC = CGAL::Spline_constraints;

namespace {

template <class Kernel>
std::string written(const std::vector<std::vector<CGAL::Point_3<Kernel>>>& polylines)
{
  std::ostringstream out;
  SC::IO::write_VTP(out, polylines);
  return out.str();
}

// What stands between the tags of an array.
std::string array(const std::string& file, const std::string& attribute)
{
  const std::size_t tag = file.find(attribute), begin = file.find('>', tag) + 2;
  return tag == std::string::npos ? "no such array" : file.substr(begin, file.find("</DataArray>", begin) - begin);
}

} // namespace

TEST(Write_VTP, polylines)
{
  using Kernel = CGAL::Simple_cartesian<SC::Exact_rational>;
  using Point = Kernel::Point_3;
  const SC::Exact_rational third = SC::Exact_rational(1) / 3;
  const std::string file =
      written<Kernel>({{Point(0, 0, 0), Point(1, third, 0)}, {Point(2, 0, -1), Point(0.25, 5, 6), Point(2, 0, -1)}});
  EXPECT_NE(file.find("NumberOfPoints=\"5\""), std::string::npos);
  EXPECT_NE(file.find("NumberOfLines=\"2\""), std::string::npos);
  EXPECT_EQ(array(file, "NumberOfComponents"), "0 0 0\n1 0.3333333333333333 0\n2 0 -1\n0.25 5 6\n2 0 -1\n");
  EXPECT_EQ(array(file, "Name=\"component\""), "0\n1\n");
  EXPECT_EQ(array(file, "Name=\"connectivity\""), "0\n1\n2\n3\n4\n");
  EXPECT_EQ(array(file, "Name=\"offsets\""), "2\n5\n");
}

TEST(Write_VTP, points_are_vertices)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  const std::string file =
      written<Kernel>({{Point(0, 0, 0), Point(1, 0, 0)}, {Point(2, 0, -1)}, {Point(3, 0, 0), Point(4, 0, 0)}});
  EXPECT_NE(file.find("NumberOfVerts=\"1\" NumberOfLines=\"2\""), std::string::npos);
  EXPECT_EQ(array(file, "NumberOfComponents"), "2 0 -1\n0 0 0\n1 0 0\n3 0 0\n4 0 0\n");
  EXPECT_EQ(array(file, "Name=\"component\""), "1\n0\n2\n");
  const std::string vertices = file.substr(file.find("<Verts>")), lines = file.substr(file.find("<Lines>"));
  EXPECT_EQ(array(vertices, "Name=\"connectivity\""), "0\n");
  EXPECT_EQ(array(vertices, "Name=\"offsets\""), "1\n");
  EXPECT_EQ(array(lines, "Name=\"connectivity\""), "1\n2\n3\n4\n");
  EXPECT_EQ(array(lines, "Name=\"offsets\""), "2\n4\n");
}

TEST(Write_VTP, nothing)
{
  const std::string file = written<CGAL::Simple_cartesian<double>>({});
  EXPECT_NE(file.find("NumberOfPoints=\"0\""), std::string::npos);
  EXPECT_EQ(array(file, "Name=\"offsets\""), "");
}

} // namespace write_VTP_test
