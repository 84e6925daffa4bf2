// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace read_SVG_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = K::FT;
using Point = K::Point_2;
using Curves = std::vector<SC::SVG_curve<K>>;

namespace {

const std::string head = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 10 10'>\n", tail = "\n</svg>\n";

Curves read(const std::string& elements)
{
  std::istringstream in(head + elements + tail);
  Curves curves = SC::IO::read_SVG<K>(in, "test.svg");
  for (auto& curve : curves)   // the tests think with the y-axis downwards
    curve.curve = curve.curve.transformed(K::Aff_transformation_2(1, 0, 0, 0, -1, 0));
  return curves;
}

SC::Bspline_curve_2<K> one(const std::string& element)
{
  const Curves curves = read(element);
  EXPECT_EQ(curves.size(), 1u) << element;
  return curves.at(0).curve;
}

SC::Bspline_curve_2<K> path(const std::string& data, const std::string& more = "")
{
  return one("<path d='" + data + "' " + more + "/>");
}

std::vector<Point> points(const SC::Bspline_curve_2<K>& curve) { return curve.control_points(); }

FT ratio(int a, int b) { return FT(a) / FT(b); }

// Points of the curve satisfy (x-cx)^2/rx^2 + (y-cy)^2/ry^2 = 1, exactly.
void expect_on_ellipse(const SC::Bspline_curve_2<K>& curve, const Point& center, const FT& rx, const FT& ry)
{
  const auto [begin, end] = curve.domain();
  for (int i = 0; i <= 7; ++i) {
    const Point p = curve(begin + (end - begin) * i / 7);
    EXPECT_EQ(CGAL::square((p.x() - center.x()) / rx) + CGAL::square((p.y() - center.y()) / ry), FT(1)) << i;
  }
}

TEST(Read_SVG, paths_of_lines)
{
  const std::vector<Point> square{{1, 2}, {4, 2}, {4, 5}, {1, 5}, {1, 2}};
  EXPECT_EQ(points(path("M1 2L4 2 4 5 1 5Z")), square);
  EXPECT_EQ(points(path("M1,2 4,2 4,5 1,5z")), square);
  EXPECT_EQ(points(path("m1 2 3 0 0 3-3 0z")), square);
  EXPECT_EQ(points(path("M 1 2 H 4 V 5 H 1 V 2")), square);
  EXPECT_EQ(points(path("m1 2h3v3h-3v-3z")), square);
  EXPECT_EQ(path("m1 2h3v3h-3v-3z").degree(), 1);
  EXPECT_EQ(points(path("M.5.25L-1.5e1+2E-1")),
            (std::vector<Point>{{ratio(1, 2), ratio(1, 4)}, {FT(-15), ratio(1, 5)}}));
  EXPECT_EQ(points(path("M0.1 0.1L0.3 1", "id='x'"))[0], Point(ratio(1, 10), ratio(1, 10)));
  EXPECT_EQ(points(path("M0 0 0 0 1 1 1 1 2 0")), (std::vector<Point>{{0, 0}, {1, 1}, {2, 0}}));   // length zero
}

TEST(Read_SVG, subpaths)
{
  const Curves curves = read("<path d='M0 0h1z m2 3 h1 M9 9 M5 5 l1 1z l2 0' id='many'/>");
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(points(curves[1].curve), (std::vector<Point>{{2, 3}, {3, 3}}));
  EXPECT_EQ(points(curves[3].curve), (std::vector<Point>{{5, 5}, {7, 5}}));   // after Z from the begin of the subpath
  for (const auto& curve : curves) {
    EXPECT_EQ(curve.id, "many");
    EXPECT_EQ(curve.element, "path");
    EXPECT_EQ(curve.line, 2);
    EXPECT_EQ(curve.column, 1);
  }
  EXPECT_TRUE(read("<path d=''/><path/><path d='M1 1'/><path d='M1 1z'/><g/><text>M</text><defs><line x2='1'/></defs>")
                  .empty());
}

TEST(Read_SVG, bezier_curves)
{
  EXPECT_EQ(points(path("M0 0C1 2 3 4 5 6")), (std::vector<Point>{{0, 0}, {1, 2}, {3, 4}, {5, 6}}));
  EXPECT_EQ(points(path("m1 1c1 2 3 4 5 6s1 1 2 2")),
            (std::vector<Point>{{1, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}, {7, 8}, {8, 9}}));
  EXPECT_EQ(points(path("M0 0S1 1 2 0")), (std::vector<Point>{{0, 0}, {0, 0}, {1, 1}, {2, 0}}));
  EXPECT_EQ(points(path("M0 0Q1 1 2 0T4 0t2 0")),
            (std::vector<Point>{{0, 0}, {1, 1}, {2, 0}, {3, -1}, {4, 0}, {5, 1}, {6, 0}}));
  const auto mixed = path("M0 0L3 0Q4 0 4 1C4 2 3 2 2 2");
  EXPECT_EQ(mixed.degree(), 3);
  EXPECT_EQ(mixed(FT(1)), Point(3, 0));
  EXPECT_EQ(mixed(ratio(1, 2)), Point(ratio(3, 2), 0));
  EXPECT_EQ(mixed(ratio(3, 2)), Point(ratio(15, 4), ratio(1, 4)));
  EXPECT_FALSE(mixed.is_rational());
}

TEST(Read_SVG, arcs_with_rational_centers_are_exact)
{
  const auto quarter = path("M2 0A2 2 0 0 1 0 2");
  expect_on_ellipse(quarter, Point(0, 0), FT(2), FT(2));
  EXPECT_EQ(quarter.source(), Point(2, 0));
  EXPECT_EQ(quarter.target(), Point(0, 2));
  EXPECT_GT(quarter(ratio(1, 2)).x(), FT(1));
  expect_on_ellipse(path("M2 0A2 2 0 1 0 0 2"), Point(0, 0), FT(2), FT(2));
  expect_on_ellipse(path("M2 0A2 2 0 0 0 0 2"), Point(2, 2), FT(2), FT(2));
  expect_on_ellipse(path("M2 0A2 2 0 1 1 0 2"), Point(2, 2), FT(2), FT(2));
  expect_on_ellipse(path("M3 4a5 5 0 01-6 0"), Point(0, 0), FT(5), FT(5));
  expect_on_ellipse(path("M4 0A4 3 0 0 1 0 3"), Point(0, 0), FT(4), FT(3));
  expect_on_ellipse(path("M3 0A4 3 90 0 1 0 4"), Point(0, 0), FT(3), FT(4));
  expect_on_ellipse(path("M-4 0A1 1 0 0 1 4 0"), Point(0, 0), FT(4), FT(4));   // scaled half axes
  EXPECT_EQ(points(path("M0 0A0 1 0 0 1 4 0")), (std::vector<Point>{{0, 0}, {4, 0}}));
}

TEST(Read_SVG, weights_of_many_arcs_stay_small)
{
  std::string data = "M0 0";
  for (int i = 0; i < 300; ++i)
    data += "a1 1 0 0 1 1 1a1 1 0 0 0 1 1";
  const auto curve = path(data);
  EXPECT_EQ(curve.target(), Point(600, 600));
  for (int i = 0; i < 600; ++i)
    for (int j = 0; j <= 4; ++j)   // the centers are in turn left of the begin and right of it
      EXPECT_EQ(CGAL::squared_distance(curve(FT(i) + ratio(j, 4)), i % 2 == 0 ? Point(i, i + 1) : Point(i + 1, i)),
                FT(1));
  for (const FT& w : curve.control_weights()) {
    EXPECT_GE(w, FT(1));
    EXPECT_LE(w, FT(2));
  }
}

TEST(Read_SVG, arcs_with_irrational_centers_are_parts_of_one_circle)
{
  for (const std::string flags : {"0 1", "0 0", "1 1", "1 0"}) {
    const auto arc = path("M0 0A2 2 0 " + flags + " 1 1.5");
    EXPECT_EQ(arc.source(), Point(0, 0));
    EXPECT_EQ(arc.target(), Point(1, ratio(3, 2)));
    const Point center = CGAL::circumcenter(arc(FT(0)), arc(ratio(1, 2)), arc(FT(1)));
    const FT square = CGAL::squared_distance(center, arc(FT(0)));
    for (int i = 0; i <= 9; ++i)
      EXPECT_EQ(CGAL::squared_distance(center, arc(ratio(2 * i, 9))), square);
    EXPECT_LT(CGAL::abs(square - 4), FT(1e-24));
    // The center is left of the chord exactly for small positive and large negative arcs; the large arc is longer.
    const bool is_left = flags == "0 1" || flags == "1 0";
    EXPECT_EQ(CGAL::orientation(Point(0, 0), arc.target(), center), is_left ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN);
    EXPECT_EQ(CGAL::squared_distance(arc(FT(1)), Point(ratio(1, 2), ratio(3, 4))) > FT(4), flags[0] == '1');
  }
}

TEST(Read_SVG, shapes)
{
  EXPECT_EQ(points(one("<line x1='1' y1='2' x2='3px' y2='1in'/>")), (std::vector<Point>{{1, 2}, {3, 96}}));
  EXPECT_EQ(points(one("<line x2='25.4mm' y2='3pt'/>"))[1], Point(96, 4));
  EXPECT_EQ(points(one("<polyline points='0,0 1,2, 3 4'/>")), (std::vector<Point>{{0, 0}, {1, 2}, {3, 4}}));
  EXPECT_EQ(points(one("<polygon points='0,0 1,2,3 4'/>")), (std::vector<Point>{{0, 0}, {1, 2}, {3, 4}, {0, 0}}));
  EXPECT_EQ(points(one("<rect x='1' y='1' width='2' height='3'/>")),
            (std::vector<Point>{{1, 1}, {3, 1}, {3, 4}, {1, 4}, {1, 1}}));
  const auto rounded = one("<rect width='10' height='6' rx='2'/>");
  EXPECT_TRUE(rounded.is_closed());
  EXPECT_EQ(rounded(FT(0)), Point(2, 0));
  EXPECT_EQ(rounded(FT(2)), Point(10, 2));
  expect_on_ellipse(rounded.restricted(1, 2), Point(8, 2), 2, 2);
  expect_on_ellipse(rounded.restricted(7, 8), Point(2, 2), 2, 2);
  expect_on_ellipse(one("<circle cx='1' cy='-1' r='.5'/>"), Point(1, -1), ratio(1, 2), ratio(1, 2));
  expect_on_ellipse(one("<svg:ellipse cx='1' cy='2' rx='3' ry='4'/>"), Point(1, 2), 3, 4);
  EXPECT_EQ(one("<circle r='1'/>").source(), Point(1, 0));
  EXPECT_TRUE(read("<circle/><rect width='3'/><ellipse rx='2'/><line/><polygon points=''/>").empty());
}

TEST(Read_SVG, transformations)
{
  const auto image = [](const std::string& transform) {
    return points(one("<line x1='1' y1='0' x2='1' y2='2' transform='" + transform + "'/>"));
  };
  EXPECT_EQ(image("translate(3)"), (std::vector<Point>{{4, 0}, {4, 2}}));
  EXPECT_EQ(image("translate(3,-1)"), (std::vector<Point>{{4, -1}, {4, 1}}));
  EXPECT_EQ(image("scale(2)"), (std::vector<Point>{{2, 0}, {2, 4}}));
  EXPECT_EQ(image("scale(1 -1)"), (std::vector<Point>{{1, 0}, {1, -2}}));
  EXPECT_EQ(image("rotate(90)"), (std::vector<Point>{{0, 1}, {-2, 1}}));
  EXPECT_EQ(image("rotate(-90, 1, 0)"), (std::vector<Point>{{1, 0}, {3, 0}}));
  EXPECT_EQ(image("rotate(540)"), (std::vector<Point>{{-1, 0}, {-1, -2}}));
  EXPECT_EQ(image("skewX(45)")[0], Point(1, 0));
  EXPECT_LT(CGAL::squared_distance(image("skewX(45)")[1], Point(3, 2)), FT(1e-30));
  EXPECT_EQ(image("matrix(1 2 3 4 5 6)"), (std::vector<Point>{{6, 8}, {12, 16}}));
  EXPECT_EQ(image("translate(10 0) scale(2)"), (std::vector<Point>{{12, 0}, {12, 4}}));
  EXPECT_EQ(points(one("<g transform='translate(10 0)'><g transform='scale(2)'><line x1='1' x2='2'/></g></g>")),
            (std::vector<Point>{{12, 0}, {14, 0}}));
  const std::vector<Point> turned = image("rotate(30)");   // still a rotation
  EXPECT_EQ(CGAL::squared_distance(turned[0], turned[1]), FT(4));
  EXPECT_LT(CGAL::abs(turned[0].y() - ratio(1, 2)), FT(1e-15));
}

TEST(Read_SVG, places_and_documents)
{
  std::istringstream in("\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!-- <line x2='7'/> -->\r\n<svg>\r\n  <g>\r\n    <line "
                        "id='a&amp;b' x2='1'/>\r\n  </g> <path d='M0 0\n1 1'/></svg>");
  const Curves curves = SC::IO::read_SVG<K>(in, "test.svg");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].id, "a&b");
  EXPECT_EQ(curves[0].line, 5);
  EXPECT_EQ(curves[0].column, 5);
  EXPECT_EQ(curves[1].line, 6);
  EXPECT_EQ(curves[1].column, 8);
}

TEST(Read_SVG, rounded_to_doubles)
{
  std::istringstream in("<svg><line x1='0.1' x2='0.3' y2='1e-1'/><path d='M1 0A1 1 0 0 1 0 1'/></svg>");
  const auto curves = SC::IO::read_SVG<CGAL::Exact_predicates_inexact_constructions_kernel>(in, "test.svg");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].curve.target().x(), 0.3);
  EXPECT_EQ(curves[1].curve.target().y(), -1);
}

struct Bad_input
{
  std::string elements;
  int column;
  std::string text, part;
};

TEST(Read_SVG, errors_tell_the_place)
{
  const std::vector<Bad_input> bad_inputs{
    {"<path d='L1 1'/>", 10, "L1", "begins with M"},
    {"<path d='M1'/>", 12, "", "a coordinate"},
    {"<path d='M1 1L2'/>", 16, "", "a coordinate"},
    {"<path d='M1 1 X'/>", 15, "X", "a command"},
    {"<path d='M1 1L1 1,'/>", 19, "", "a coordinate"},
    {"<path d='M1 1L,1 1'/>", 15, ",1", "a coordinate"},
    {"<path d='M1 1A1 1 0 2 0 3 3'/>", 21, "2", "a flag"},
    {"<path d='M1 1A1 1 0 0 0 3'/>", 26, "", "a coordinate"},
    {"<path d='M1 1z 3'/>", 16, "3", "a command"},
    {"<path d='M1e999 1'/>", 11, "1e999", "too many digits"},
    {"<path d='M1" + std::string(500, '0') + " 1'/>", 11, "1" + std::string(59, '0'), "too many digits"},
    {"<path d='M1&#32;1'/>", 12, "&#32;1", "a coordinate"},
    {"<path d='M0 0A1 1 0 1 0 1e-200 0'/>", 14, "A1", "too close"},
    {"<line x2='3%'/>", 12, "%", "expected px"},
    {"<line x2='3em'/>", 12, "em", "expected px"},
    {"<line x2='left'/>", 11, "left", "a length"},
    {"<circle r='-1'/>", 12, "-1", "negative"},
    {"<polygon points='1 2 3'/>", 23, "", "a coordinate"},
    {"<g transform='turn(3)'/>", 15, "turn", "not a transformation"},
    {"<g transform='rotate(3 4)'/>", 15, "rotate", "not with so many numbers"},
    {"<g transform='rotate'/>", 15, "rotate", "in parentheses"},
    {"<g transform='scale(0)'/>", 15, "scale", "not invertible"},
    {"<g transform='matrix(1 2 2 4 0 0)'/>", 15, "matrix", "not invertible"},
    {"<g transform='scale(1'/>", 22, "", "a number or ')'"},
    {"<use href='#a'/>", 2, "use", "not supported"},
    {"<g><svg/></g>", 5, "svg", "not supported"},
  };
  for (const Bad_input& bad : bad_inputs) {
    try {
      read(bad.elements);
      ADD_FAILURE() << "no error in " << bad.elements.substr(0, 100);
    } catch (const SC::Parse_error& error) {
      EXPECT_EQ(error.file(), "test.svg");
      EXPECT_EQ(error.line(), 2) << error.what();
      EXPECT_EQ(error.column(), bad.column) << error.what();
      EXPECT_EQ(error.text(), bad.text) << error.what();
      EXPECT_NE(std::string(error.what()).find(bad.part), std::string::npos) << error.what();
    }
  }
}

TEST(Read_SVG, bad_documents)
{
  std::string deep;
  for (int i = 0; i < 300; ++i)
    deep += "<g>";
  for (int i = 0; i < 300; ++i)
    deep += "</g>";
  for (const std::string& content :
       {std::string(), std::string("text"), std::string("<svg"), std::string("<svg><g></svg>"), std::string("<html/>"),
        std::string("<svg>\0</svg>", 12), std::string("<svg><path d='M0 0"), "<svg>" + deep + "</svg>"}) {
    std::istringstream in(content);
    EXPECT_THROW(SC::IO::read_SVG<K>(in, "test.svg"), SC::Parse_error) << content.substr(0, 40);
  }
  EXPECT_THROW(SC::IO::read_SVG<K>("/no/such/file.svg"), SC::Parse_error);
  EXPECT_THROW(SC::IO::read_SVG<K>("/"), SC::Parse_error);
}

} // namespace

} // namespace read_SVG_test
