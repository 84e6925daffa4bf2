// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Planar operations on the outlines of real glyphs: areas in closed form, Euler's formula of medial axes, offsets
// against Minkowski sums with a disk, hulls between those of points that CGAL makes.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace glyphs_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;
using Polygon = CGAL::Polygon_2<K>;

// The outlines of "Rag&8", eleven of them, or of "Rg&", six.
Curves glyphs(const std::string& font)
{
  return SC::IO::read_SVG_curves<K>("../../examples/Spline_constraints_d/data/glyphs/" + font + ".svg");
}

Curves letter_g()
{
  const Curves all = glyphs("sans");
  return {all.at(2), all.at(3)};
}

SC::Exact_rational cross(const Point& p, const Point& q) { return SC::Exact_rational(p.x() * q.y() - p.y() * q.x()); }

// Between the curves and the origin, of lines and parabolas.
SC::Exact_rational signed_area(const Curves& curves)
{
  SC::Exact_rational result(0);
  for (const auto& curve : curves)
    for (const auto& piece : curve.bezier_pieces()) {
      const std::vector<Point> p = piece.control_points();
      if (p.size() == 2)
        result += cross(p[0], p[1]) / 2;
      else
        result += (2 * cross(p[0], p[1]) + 2 * cross(p[1], p[2]) + cross(p[0], p[2])) / 6;
    }
  return result;
}

double area(const std::vector<CGAL::Polygon_with_holes_2<K>>& polygons)
{
  SC::Exact_rational result(0);
  for (const auto& polygon : polygons) {
    result += polygon.outer_boundary().area();
    for (const auto& hole : polygon.holes())
      result += hole.area();
  }
  return SC::to_nearest_double(result);
}

TEST(Glyphs, AreasAndMedialAxes)
{
  struct Expected
  {
    const char* font;
    std::size_t outlines, holes;
  };
  for (const auto& [font, outlines, holes] : {Expected{"serif", 11, 6}, Expected{"sans", 6, 3}}) {
    const Curves curves = glyphs(font);
    ASSERT_EQ(curves.size(), outlines);
    const auto region = SC::planar_region(curves);
    EXPECT_EQ(region.number_of_holes(), holes);
    const auto [lower, upper] = region.area();
    EXPECT_EQ(lower, upper);
    EXPECT_EQ(lower, CGAL::abs(signed_area(curves)));   // outlines of fonts are oriented

    const auto axis = SC::medial_axis(region);
    EXPECT_TRUE(axis.is_complete());
    EXPECT_EQ(axis.number_of_regions(), outlines);
    // as many cycles as holes, in as many trees as glyphs
    EXPECT_EQ(axis.vertices().size() + holes, axis.edges().size() + (outlines - holes));
  }
}

// The grown region, which is the sum with a disk, made by different code; and the shrunk one. The hole of the letter
// and its strokes remain.
TEST(Glyphs, OffsetsAndSumsWithADisk)
{
  const auto region = SC::planar_region(letter_g());
  const double exact = SC::to_nearest_double(region.area().first);
  const auto grown = SC::trimmed_offset(region, 40), shrunk = SC::trimmed_offset(region, -40);
  ASSERT_TRUE(grown.is_complete() && shrunk.is_complete());
  const auto sum = SC::minkowski_sum(region, SC::planar_region(SC::circle_curve(Point(0, 0), SC::Exact_rational(40))));
  ASSERT_TRUE(sum.is_complete());
  const auto polygons = grown.polygons_with_holes(0.05);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].number_of_holes(), 1U);
  // within 0.05 along less than 10,000 units, twice
  EXPECT_NEAR(area(polygons), area(sum.polygons_with_holes(0.05)), 1000);
  EXPECT_GT(area(polygons), exact + 100000);
  const auto inner = shrunk.polygons_with_holes(0.05);
  ASSERT_EQ(inner.size(), 1U);
  EXPECT_EQ(inner[0].number_of_holes(), 1U);
  EXPECT_LT(area(inner), exact - 100000);
}

TEST(Glyphs, Hulls)
{
  for (const char* font : {"serif", "sans"}) {
    const Curves curves = glyphs(font);
    const auto hull = SC::convex_hull(curves);
    ASSERT_TRUE(hull.is_complete());
    std::vector<Point> controls, ends;
    for (const auto& curve : curves)
      for (const auto& piece : curve.bezier_pieces()) {
        const std::vector<Point> p = piece.control_points();
        controls.insert(controls.end(), p.begin(), p.end());
        ends.push_back(p.front());
      }
    const auto area_of_hull = [](const std::vector<Point>& points) {
      Polygon result;
      CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(result));
      return SC::Exact_rational(result.area());
    };
    EXPECT_GT(hull.area().first, area_of_hull(ends));
    EXPECT_LT(hull.area().second, area_of_hull(controls));
  }
}

} // namespace glyphs_test
