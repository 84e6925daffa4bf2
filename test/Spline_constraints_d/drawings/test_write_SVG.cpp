// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace write_SVG_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = K::FT;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;

namespace {

std::string written(const std::vector<Curve>& curves)
{
  std::ostringstream out;
  SC::IO::write_SVG(out, curves);
  return out.str();
}

std::vector<Curve> read(const std::string& drawing)
{
  std::istringstream in(drawing);
  std::vector<Curve> result;
  for (const auto& curve : SC::IO::read_SVG<K>(in, "written.svg"))
    result.push_back(curve.curve);
  return result;
}

TEST(Write_SVG, decimals_are_exact)
{
  const auto text = [](int a, int b) {
    return SC::internal::decimal_text(SC::Exact_rational(a) / SC::Exact_rational(b));
  };
  EXPECT_EQ(text(0, 1), "0");
  EXPECT_EQ(text(-7, 1), "-7");
  EXPECT_EQ(text(100, 1), "100");
  EXPECT_EQ(text(1, 10), "0.1");
  EXPECT_EQ(text(-5, 4), "-1.25");
  EXPECT_EQ(text(3, 2000), "0.0015");
  EXPECT_EQ(text(1, 1024), "0.0009765625");
  EXPECT_EQ(text(1, 3), "0.3333333333333333");
}

TEST(Write_SVG, polynomial_curves_are_read_back_exactly)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> number(-1000, 1000);
  std::vector<Curve> curves;
  for (int degree = 1; degree <= 3; ++degree)
    for (int spans = 1; spans <= 4; ++spans) {
      std::vector<Point> points;
      for (int i = 0; i < degree + spans; ++i)
        // without thirds in the Bezier pieces
        points.emplace_back(FT(144 * number(random)) / 10, FT(9 * number(random)) / 64);
      curves.emplace_back(degree, SC::internal::integer_knots<FT>(degree, points.size()), points);
    }
  const std::vector<Curve> again = read(written(curves));
  ASSERT_EQ(again.size(), curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i)
    EXPECT_TRUE(again[i] == curves[i]) << i;
}

// Groups with names, one after the other; the curves in them are read back in their order.
TEST(Write_SVG, layers)
{
  std::ostringstream out;
  const std::vector<Curve> curves{SC::segment_curve(Point(0, 0), Point(1, 2)),
                                  SC::segment_curve(Point(1, 1), Point(2, 0)),
                                  SC::segment_curve(Point(2, 2), Point(0, 1))};
  {
    SC::SVG_writer writer(out, CGAL::Bbox_2(0, 0, 2, 2));
    writer.curve(curves[0]);
    writer.layer("sites");
    writer.curve(curves[1]);
    writer.layer("the user's <edges>");
    writer.curve(curves[2]);
  }
  const std::string text = out.str();
  const auto first = text.find("<g inkscape:groupmode='layer' inkscape:label='sites'>"),
             second = text.find("</g>\n<g inkscape:groupmode='layer' inkscape:label='the user&apos;s &lt;edges&gt;'>");
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
  EXPECT_TRUE(text.ends_with("/>\n</g>\n</g>\n</svg>\n"));
  EXPECT_TRUE(read(text) == curves);
}

TEST(Write_SVG, chords_are_near_the_curve)
{
  const Curve circle = SC::circle_curve(Point(1, 2), FT(5));
  const std::vector<Curve> curves = read(written({circle}));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].degree(), 1);
  EXPECT_GT(curves[0].size(), 20u);
  EXPECT_LT(curves[0].size(), 400u);
  const double error = 11. / 600 / 10;   // a tenth of a pixel
  for (std::size_t i = 0; i + 1 < 2 * curves[0].size(); ++i) {   // ends and middles of the chords
    const double distance = std::sqrt(CGAL::to_double(CGAL::squared_distance(Point(1, 2), curves[0](FT(i) / 2))));
    EXPECT_LE(distance, 5 + 1e-12);
    EXPECT_GE(distance, 5 - error - 1e-12);
  }
}

TEST(Write_SVG, a_zero_weight_and_a_high_degree_are_drawn)
{
  using NT = SC::Exact_rational;
  using F = SC::Bspline_function<NT>;
  const std::vector<NT> knots{0, 0, 0, 1, 1, 1};
  const auto function = [&](const NT& a, const NT& b, const NT& c) { return F({2}, {knots}, {a, b, c}); };
  const Curve half_circle =
      Curve::from_homogeneous_coordinates({function(1, 0, -1), function(0, 1, 0)}, function(1, 0, 1));
  const Curve quartic = SC::bezier_curve(std::vector<Point>{{0, 0}, {1, 2}, {2, -2}, {3, 2}, {4, 0}});
  const std::vector<Curve> curves = read(written({half_circle, quartic}));
  ASSERT_EQ(curves.size(), 2u);
  for (const Point& p : curves[0].control_points())
    EXPECT_NEAR(CGAL::to_double(CGAL::squared_distance(p, Point(0, 0))), 1, 1e-12);
  EXPECT_EQ(curves[0].target(), Point(-1, 0));
  EXPECT_EQ(curves[1].target(), Point(4, 0));
}

TEST(Write_SVG, points_and_labels_are_no_curves)
{
  std::ostringstream out;
  {
    SC::SVG_writer writer(out, CGAL::Bbox_2(0, 0, 4, 2), 400);
    writer.curve(SC::segment_curve(Point(0, 0), Point(1, 1)), "red", 3);
    writer.point(Point(1, 1));
    writer.label(Point(1, 1), "a < b & c");
  }
  EXPECT_NE(out.str().find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_NE(out.str().find("stroke='red' stroke-width='0.03'"), std::string::npos);
  const std::vector<Curve> curves = read(out.str());
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].target(), Point(1, 1));
}

TEST(Write_SVG, views_without_extent_are_refused)
{
  std::ostringstream out;
  EXPECT_THROW(SC::SVG_writer(out, CGAL::Bbox_2(0, 0, 0, 1)), SC::Invalid_input);
  EXPECT_THROW(SC::SVG_writer(out, CGAL::Bbox_2(0, 0, std::numeric_limits<double>::infinity(), 1)), SC::Invalid_input);
  EXPECT_THROW(SC::SVG_writer(out, CGAL::Bbox_2(0, 0, 1, 1), 0), SC::Invalid_input);
  EXPECT_THROW(SC::IO::write_SVG(out, std::vector<Curve>{}), SC::Invalid_input);
  EXPECT_TRUE(out.str().empty());
}

TEST(Write_SVG, polygons)
{
  const std::vector<Point> outer{{0, 0}, {2, 0}, {2, 1}}, inner{{1, 0.25}, {1.5, 0.5}, {1.5, 0.25}};
  CGAL::Polygon_with_holes_2<K> ring(CGAL::Polygon_2<K>(outer.begin(), outer.end()));
  ring.add_hole(CGAL::Polygon_2<K>(inner.begin(), inner.end()));
  std::ostringstream out;
  {
    SC::SVG_writer writer(out, CGAL::Bbox_2(0, 0, 2, 1), 100);
    writer.polygon(outer, "red");
    writer.polygon(ring, "blue");
  }
  EXPECT_NE(out.str().find("<path d='M0 0L2 0L2 1Z' fill='red'"), std::string::npos);
  EXPECT_NE(out.str().find("<path d='M0 0L2 0L2 1ZM1 0.25L1.5 0.5L1.5 0.25Z' fill='blue' fill-rule='evenodd'"),
            std::string::npos);
}

// Points of a kernel, coordinates in a row and samples make the same line; it is rounded, but by a fiftieth of a pixel
// at most in each coordinate.
TEST(Write_SVG, polylines)
{
  struct Sample
  {
    Point point;
    double radius;
  };
  const std::vector<Point> points{{FT(1) / 3, FT(2) / 3}, {-1, FT(-1) / 7}, {12, 5}};
  std::vector<std::array<double, 2>> rows;
  std::vector<Sample> samples;
  for (const Point& p : points) {
    rows.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
    samples.push_back({p, 1});
  }
  for (const double pixel : {1e-6, 0.01, 0.7, 30.}) {
    std::ostringstream out;
    {
      SC::SVG_writer writer(out, CGAL::Bbox_2(0, 0, 100 * pixel, pixel), 100);
      EXPECT_NEAR(writer.pixel(), pixel, 1e-12 * pixel);
      EXPECT_NEAR(writer.extent(), 100 * pixel, 1e-10 * pixel);
      writer.polyline(points);
      writer.polyline(rows);
      writer.polyline(samples);
    }
    const std::vector<Curve> curves = read(out.str());
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_TRUE(curves[0] == curves[1]);
    EXPECT_TRUE(curves[0] == curves[2]);
    const auto written_points = curves[0].bezier_pieces();
    ASSERT_EQ(written_points.size(), 2u);
    EXPECT_LE(CGAL::squared_distance(written_points[0].source(), points[0]), 2 * CGAL::square(FT(pixel) / 50));
    EXPECT_LE(CGAL::squared_distance(written_points[1].source(), points[1]), 2 * CGAL::square(FT(pixel) / 50));
    EXPECT_LE(CGAL::squared_distance(written_points[1].target(), points[2]), 2 * CGAL::square(FT(pixel) / 50));
  }
}

TEST(Write_SVG, circles)
{
  std::ostringstream out;
  {
    SC::SVG_writer writer(out, CGAL::Bbox_2(-4, -4, 4, 4), 100);
    writer.circle(Point(1, -2), FT(3) / 2, "green", 2);
  }
  const std::vector<Curve> curves = read(out.str());
  ASSERT_EQ(curves.size(), 1u);
  for (int i = 0; i <= 12; ++i) {
    const auto [begin, end] = curves[0].domain();
    EXPECT_EQ(CGAL::squared_distance(Point(1, -2), curves[0](begin + (end - begin) * FT(i) / 12)), FT(9) / 4);
  }
}

// The drawing shows the boxes of all objects, with a margin on all sides.
TEST(Write_SVG, views_around_objects)
{
  std::ostringstream out;
  {
    const SC::SVG_writer writer(out, std::vector<Point>{{0, 1}, {8, 5}, {4, 3}}, 200, 0.25);
    EXPECT_EQ(writer.extent(), 12);
    EXPECT_EQ(writer.pixel(), 12. / 200);
  }
  EXPECT_NE(out.str().find("viewBox='-2 -7 12 8' width='200'"), std::string::npos);
  EXPECT_THROW(SC::SVG_writer(out, std::vector<Point>{}), SC::Invalid_input);
  EXPECT_THROW(SC::SVG_writer(out, std::vector<Point>{{1, 1}}), SC::Invalid_input);
}

} // namespace

} // namespace write_SVG_test
