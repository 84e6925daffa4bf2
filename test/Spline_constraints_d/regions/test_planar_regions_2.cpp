// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions between curves: known areas, orientations and sides; boundaries that touch, and parts that are there twice;
// all kinds of bad boundaries.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_region_streams_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace planar_regions_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using R = Exact_rational;
using Point = Exact_cartesian::Point_2;
using Curve = SC::Bspline_curve_2<Exact_cartesian>;
using Curves = std::vector<Curve>;
using Region = SC::Planar_region_2<Exact_cartesian>;

Curve segment(const Point& p, const Point& q) { return SC::segment_curve<Exact_cartesian>(p, q); }
Curve circle(const R& x, const R& y, const R& radius) { return SC::circle_curve(Point(x, y), radius); }
Curve polygon(std::vector<Point> points)
{
  points.push_back(Point(points.front()));
  return SC::polyline_curve<Exact_cartesian>(points);
}

// The number lies between the bounds, up to the rounding of the number itself, and these are close.
void expect_area(const Region& region, double area)
{
  const auto [lower, upper] = region.area(1e-12);
  EXPECT_LE(CGAL::to_double(R(upper - lower)), 2e-12);
  EXPECT_NEAR(CGAL::to_double(lower), area, 1e-13 * (1 + std::abs(area)) + 2e-12);
  EXPECT_NEAR(CGAL::to_double(upper), area, 1e-13 * (1 + std::abs(area)) + 2e-12);
}

TEST(planar_regions_2, disk)
{
  for (const Curve& curve : {circle(1, 2, 3), circle(1, 2, 3).reversed()}) {
    const Region disk = SC::planar_region(curve);
    expect_area(disk, 9 * CGAL_PI);
    ASSERT_EQ(disk.boundaries().size(), 1u);
    EXPECT_FALSE(disk.boundaries()[0].is_hole);
    EXPECT_EQ(disk.boundaries()[0].arcs[0].is_reversed, !(curve == circle(1, 2, 3)));
    EXPECT_EQ(disk.bounded_side(Point(R(1) + R(9) / 5, R(2) + R(12) / 5)), CGAL::ON_BOUNDARY);
    EXPECT_EQ(disk.bounded_side(Point(R(1) + R(9) / 5 + R(1) / 1000000000, R(2) + R(12) / 5)), CGAL::ON_UNBOUNDED_SIDE);
    EXPECT_EQ(disk.bounded_side(Point(R(1) + R(9) / 5 - R(1) / 1000000000, R(2) + R(12) / 5)), CGAL::ON_BOUNDED_SIDE);
    EXPECT_EQ(disk.bounded_side(Point(1, 5)), CGAL::ON_BOUNDARY);
    EXPECT_EQ(disk.bounded_side(Point(1, 2)), CGAL::ON_BOUNDED_SIDE);
  }
}

TEST(planar_regions_2, chains_in_any_order_and_direction)
{
  // A half disk of radius 5 on a rectangle: its arcs meet with a common tangent.
  const Point a(-5, 0), b(5, 0), c(5, 2), d(-5, 2), e(3, 6);
  Curves curves{segment(a, b), segment(b, c), SC::circular_arc_curve(Point(0, 2), c, e),
                SC::circular_arc_curve(Point(0, 2), e, d), segment(d, a)};
  std::mt19937 random(7);
  for (int trial = 0; trial < 8; ++trial) {
    std::shuffle(curves.begin(), curves.end(), random);
    for (Curve& curve : curves)
      if (random() % 2 == 0)
        curve = curve.reversed();
    const Region region(curves);
    expect_area(region, 20 + 25 * CGAL_PI / 2);
    ASSERT_EQ(region.boundaries().size(), 1u);
    ASSERT_EQ(region.boundaries()[0].arcs.size(), curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const auto &arc = region.boundaries()[0].arcs[i], &next = region.boundaries()[0].arcs[(i + 1) % curves.size()];
      EXPECT_EQ(arc.is_reversed ? curves[arc.curve].source() : curves[arc.curve].target(),
                next.is_reversed ? curves[next.curve].target() : curves[next.curve].source());
    }
    EXPECT_EQ(region.bounded_side(Point(0, 0)), CGAL::ON_BOUNDARY);
    EXPECT_EQ(region.bounded_side(Point(6, 0)), CGAL::ON_UNBOUNDED_SIDE);
    EXPECT_EQ(region.bounded_side(Point(0, 6)), CGAL::ON_BOUNDED_SIDE);
    EXPECT_EQ(region.bounded_side(Point(0, 7)), CGAL::ON_BOUNDARY);
    EXPECT_EQ(region.bounded_side(Point(-5, 2)), CGAL::ON_BOUNDARY);
  }
}

TEST(planar_regions_2, holes_and_parts)
{
  // A ring, with a disk in its hole, and a square beside it.
  const Region region(
      Curves{circle(0, 0, 2), circle(0, 0, 5), circle(0, 0, 1), polygon({{6, 0}, {6, 1}, {7, 1}, {7, 0}})});
  expect_area(region, (25 - 4 + 1) * CGAL_PI + 1);
  EXPECT_EQ(region.number_of_holes(), 1u);
  ASSERT_EQ(region.boundaries().size(), 4u);
  for (const auto& boundary : region.boundaries())
    EXPECT_EQ(boundary.is_hole, boundary.arcs[0].curve == 0);
  std::mt19937 random(11);
  int inside = 0;
  for (int i = 0; i < 200; ++i) {
    const R x = R(int(random() % 161) - 80) / 10, y = R(int(random() % 161) - 80) / 10, square = x * x + y * y;
    const bool is_in_square = x > 6 && x < 7 && y > 0 && y < 1,
               is_on_square = !is_in_square && x >= 6 && x <= 7 && y >= 0 && y <= 1;
    const bool is_on = square == 4 || square == 25 || square == 1 || is_on_square;
    const bool is_in = square < 1 || (square > 4 && square < 25) || is_in_square;
    inside += is_in;
    EXPECT_EQ(region.bounded_side(Point(x, y)),
              is_on       ? CGAL::ON_BOUNDARY
                  : is_in ? CGAL::ON_BOUNDED_SIDE
                          : CGAL::ON_UNBOUNDED_SIDE)
        << x << ' ' << y;
  }
  EXPECT_GT(inside, 20);
}

TEST(planar_regions_2, glyph)
{
  // The outline of a letter like an O, of cubic pieces with common tangents; areas of polynomial curves are exact. The
  // hole is the outline at half the size, moved.
  const auto outline = [](const R& factor, const R& x) {
    const auto p = [&](const R& a, const R& b) { return Point(factor * a + x, factor * b); };
    return Curves{SC::bezier_curve<Exact_cartesian>({p(0, -4), p(2, -4), p(3, -2), p(3, 0)}),
                  SC::bezier_curve<Exact_cartesian>({p(3, 0), p(3, 2), p(2, 4), p(0, 4)}),
                  SC::bezier_curve<Exact_cartesian>({p(-3, 0), p(-3, 2), p(-2, 4), p(0, 4)}),
                  SC::bezier_curve<Exact_cartesian>({p(-3, 0), p(-3, -2), p(-2, -4), p(0, -4)})};
  };
  const Region outer(outline(1, 0));
  Curves both = outline(1, 0);
  for (const Curve& curve : outline(R(1) / 2, R(1) / 3))
    both.push_back(curve);
  const Region letter(both);
  const R area = outer.area().first;
  EXPECT_EQ(outer.area().second, area);
  EXPECT_EQ(letter.area().first, R(area * 3 / 4));
  EXPECT_EQ(letter.area().second, R(area * 3 / 4));
  EXPECT_GT(area, R(12 * 2));   // the polygon through the four ends
  EXPECT_LT(area, R(48));       // the box
  EXPECT_EQ(letter.number_of_holes(), 1u);
  EXPECT_EQ(letter.bounded_side(Point(R(1) / 3, 0)), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(letter.bounded_side(Point(-2, 0)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(letter.bounded_side(Point(R(11) / 6, 0)), CGAL::ON_BOUNDARY);
}

TEST(planar_regions_2, polygons)
{
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{1, 1}, {1, 2}, {2, 1}};
  CGAL::Polygon_with_holes_2<Exact_cartesian> polygon_with_hole(
      CGAL::Polygon_2<Exact_cartesian>(square.begin(), square.end()));
  polygon_with_hole.add_hole(CGAL::Polygon_2<Exact_cartesian>(hole.begin(), hole.end()));
  const Region region = SC::planar_region(polygon_with_hole);
  EXPECT_EQ(region.area(), std::make_pair(R(R(31) / 2), R(R(31) / 2)));
  EXPECT_EQ(region.number_of_holes(), 1u);
  EXPECT_EQ(region.bounded_side(Point(R(3) / 2, R(3) / 2)), CGAL::ON_BOUNDARY);
}

// Holes have to be inside of the outer boundary, and outside of each other; in either direction. They may touch.
TEST(planar_regions_2, holes_in_the_wrong_place)
{
  using Polygon = CGAL::Polygon_2<Exact_cartesian>;
  const auto square = [](int x, int y, int size, bool is_clockwise) {
    const std::vector<Point> corners{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    Polygon result(corners.begin(), corners.end());
    if (is_clockwise)
      result.reverse_orientation();
    return result;
  };
  for (const bool is_clockwise : {false, true}) {
    const auto region = [&](const Polygon& outer, const std::vector<Polygon>& holes) {
      return SC::planar_region(CGAL::Polygon_with_holes_2<Exact_cartesian>(outer, holes.begin(), holes.end()));
    };
    const Polygon outer = square(0, 0, 9, is_clockwise), inner = square(1, 1, 4, !is_clockwise);
    EXPECT_EQ(region(outer, {inner, square(6, 6, 1, is_clockwise)}).area().first, 81 - 16 - 1);
    // they touch in a corner
    EXPECT_EQ(region(outer, {inner, square(5, 5, 1, is_clockwise)}).area().first, 81 - 16 - 1);
    expect_invalid([&] { region(outer, {inner, square(12, 0, 1, is_clockwise)}); }, "hole 1 is outside");
    expect_invalid(
        [&] {
          region(outer, {square(2, 2, 1, is_clockwise), inner});
        },
        "hole 0 is outside of the outer boundary, or inside of another hole");
    expect_invalid([&] { region(inner, {outer}); }, "hole 0");
  }
}

// The same curves and boundaries are read; what is no region is refused, and nothing is changed.
TEST(planar_regions_2, streams)
{
  const Region ring(Curves{circle(R(1) / 3, 0, 5), polygon({{-1, -1}, {1, -1}, {R(2) / 7, 1}}), circle(20, 0, 1)}),
      other = SC::planar_region(circle(0, 0, 1));
  std::stringstream stream;
  stream << ring << '\n' << other;
  Region first = other, second = ring;
  ASSERT_TRUE(stream >> first >> second);
  EXPECT_EQ(first.curves(), ring.curves());
  EXPECT_EQ(second.curves(), other.curves());
  ASSERT_EQ(first.boundaries().size(), 3u);
  EXPECT_EQ(first.number_of_holes(), 1u);
  EXPECT_EQ(first.area(), ring.area());
  std::ostringstream written, twice;
  written << first;
  twice << 2 << '\n' << circle(0, 0, 1) << '\n' << circle(0, 0, 1);
  const std::string text = written.str();
  for (const std::string& bad : {std::string(), std::string("0"), std::string("-1"), std::string("two"),
                                 "4" + text.substr(1), text.substr(0, text.size() / 2), twice.str()}) {
    std::istringstream in(bad);
    EXPECT_FALSE(in >> second) << bad;
    EXPECT_EQ(second.curves(), other.curves());
  }
}

TEST(planar_regions_2, bad_boundaries)
{
  const auto expect_refused = [](const Curves& curves, const std::string& fragment) {
    expect_invalid([&] { Region region(curves); }, fragment);
  };
  const Point a(0, 0), b(4, 0), c(4, 4), d(0, 4);
  expect_refused({}, "there are no curves");
  expect_refused({segment(a, b), segment(b, c)},
                 "the boundary is open: no other curve goes on from curve 0 at parameter 0, curve 1 at parameter 1");
  expect_refused({segment(a, b), segment(b, c), segment(c, d), segment(d, Point(0, R(1) / 1000000000))},
                 "no other curve goes on from curve 0 at parameter 0, curve 3 at parameter 1");
  expect_refused({polygon({a, b, c}), segment(a, d)},
                 "an odd number of ends of curves are the same point: curve 0 at parameter 0, curve 0 at parameter 3");
  expect_refused({polygon({a, b, d, c})}, "curve 0 at parameter 1.5 and curve 0 at parameter 3.5 cross");
  expect_refused({segment(a, b), segment(b, d), segment(d, c), segment(c, a)},
                 "curve 1 at parameter 0.5 and curve 3 at parameter 0.5 cross");
  // at the seam
  expect_refused({polygon({a, {2, 1}, {2, -1}, a, {-2, 1}, {-2, -1}})},
                 "curve 0 at parameter 3 and curve 0 at parameter 0 cross");
  expect_refused({circle(0, 0, 2), circle(0, 0, 5), circle(3, 0, 1), circle(4, 0, 1)}, "and curve 3 at parameter");
  expect_refused({circle(0, 0, 5), circle(6, 0, 5)}, "curve 0 at parameter 0.5 and curve 1 at parameter 1.5 cross");
  expect_refused({circle(0, 0, 5), circle(5, 0, 5)}, " cross");   // at irrational parameters
  expect_refused({segment(a, b), segment(b, b), segment(b, c), segment(c, a)},
                 "Planar_region_2: the piece of curve 1 between the parameters 0 and 1 is a point");
  expect_refused({polygon({a, b, b, c})}, "the piece of curve 0 between the parameters 1 and 2 is a point");
  expect_refused({segment(a, b), segment(b, a)}, "all curves are there twice");
  expect_refused({circle(0, 0, 2), circle(0, 0, 2), circle(9, 0, 1)}, "all of the boundary curve 0");
}

// Rings are simple, there are so many, some of them around holes, and the area is this.
void expect_rings(const Curves& curves, std::size_t rings, std::size_t holes, const R& area)
{
  const Region region(curves);
  EXPECT_EQ(region.boundaries().size(), rings);
  EXPECT_EQ(region.number_of_holes(), holes);
  EXPECT_EQ(region.area(), std::make_pair(area, area));
  EXPECT_TRUE(region.has_touching_boundaries());
  std::size_t corners = 0;
  for (const auto& polygon : region.polygons_with_holes(1e-3)) {
    EXPECT_TRUE(polygon.outer_boundary().is_simple());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      EXPECT_TRUE(hole->is_simple());
    corners += polygon.outer_boundary().size();
  }
  EXPECT_GT(corners, 0u);
}

// Lobes, holes and parts that have a vertex in common, or one on a side of another one, in one outline or in several.
TEST(planar_regions_2, outlines_that_touch)
{
  const Point a(0, 0), b(4, 0), c(4, 4), d(0, 4);
  expect_rings({polygon({a, {2, 1}, {2, -1}, a, {-2, -1}, {-2, 1}})}, 2, 0, 4);
  expect_rings({polygon({{2, 1}, {2, -1}, a, {-2, -1}, {-2, 1}, a})}, 2, 0, 4);
  expect_rings({polygon({a, b, c}), polygon({a, d, Point(-4, 4)})}, 2, 0, 16);
  expect_rings({polygon({a, b, c, d}), polygon({a, {2, 1}, {1, 2}})}, 2, 1, R(29) / 2);
  expect_rings({polygon({a, b, c, d, a, {1, 2}, {2, 1}})}, 2, 1, R(29) / 2);
  // in three points
  expect_rings({polygon({a, b, c, d}), polygon({{1, 0}, {4, R(4) / 3}, {R(1) / 3, 4}})}, 2, 1,
               R(16) - (R(3) * 4 + R(2) / 3 * R(4) / 3) / 2);
  expect_rings({polygon({a, b, c, {R(4) / 3, 0}, d})}, 2, 0, 8);
  // Open curves are put together so that none of them crosses another one.
  const Point m(2, 2);
  expect_rings({segment(a, m), segment(m, b), segment(b, a), segment(c, m), segment(m, d), segment(d, c)}, 2, 0, 8);
  expect_rings({segment(a, m), segment(m, c), segment(c, d), segment(d, m), segment(m, b), segment(b, a)}, 2, 0, 8);
  const auto parabola = [](int y) { return SC::bezier_curve<Exact_cartesian>({{0, 0}, {2, y}, {4, 0}}); };
  // a ring that is nowhere wide at both ends
  expect_rings({parabola(2), parabola(4), parabola(-2), parabola(-4)}, 2, 0, R(16) / 3);
  // Three triangles around a point.
  expect_rings({polygon({a, {2, 0}, {2, 1}, a, {-1, 2}, {-2, 2}, a, {-1, -2}, {1, -2}})}, 3, 0, 4);
  // Tangential contacts, from outside and from within.
  const Region disks(Curves{circle(0, 0, 5), circle(R(27) / 5, R(36) / 5, 4), circle(-R(9) / 5, -R(12) / 5, 2)});
  EXPECT_EQ(disks.boundaries().size(), 3u);
  EXPECT_EQ(disks.number_of_holes(), 1u);
  EXPECT_EQ(disks.boundaries()[2].outer, 0u);
  expect_area(disks, (25 + 16 - 4) * CGAL_PI);
  EXPECT_EQ(disks.bounded_side(Point(3, 4)), CGAL::ON_BOUNDARY);
}

// What is there twice is no boundary.
TEST(planar_regions_2, slits)
{
  const Point a(0, 0), b(4, 0), c(4, 4), d(0, 4);
  const Region keyhole(Curves{polygon({a, b, c, d, a, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}})}),
      spike(Curves{polygon({a, b, {4, 2}, {7, 2}, {4, 2}, c, d})}), slit(Curves{polygon({a, b, c, d, {1, 1}, d})});
  EXPECT_EQ(keyhole.area().first, 15);
  EXPECT_EQ(keyhole.number_of_holes(), 1u);
  EXPECT_FALSE(keyhole.has_touching_boundaries());
  EXPECT_EQ(keyhole.bounded_side(Point(R(1) / 2, R(1) / 2)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(keyhole.boundaries()[1].arcs.size(), 1u);
  EXPECT_EQ(keyhole.boundaries()[1].arcs[0].parameters, (std::array<R, 2>{R(5), R(9)}));
  EXPECT_EQ(spike.area().first, 16);
  EXPECT_EQ(spike.bounded_side(Point(5, 2)), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(slit.area().first, 16);
  EXPECT_EQ(slit.bounded_side(Point(1, 1)), CGAL::ON_BOUNDED_SIDE);
  // Two squares become one rectangle.
  const Region rectangle(Curves{polygon({a, b, c, d}), polygon({b, {8, 0}, {8, 4}, c})});
  EXPECT_EQ(rectangle.boundaries().size(), 1u);
  EXPECT_EQ(rectangle.area().first, 32);
  EXPECT_EQ(rectangle.bounded_side(Point(4, 1)), CGAL::ON_BOUNDED_SIDE);
}

// Outlines with a part of a side in common, as rooms beside each other: the wall is no boundary there.
TEST(planar_regions_2, common_walls)
{
  const Point a(0, 0), b(4, 0), c(4, 4), d(0, 4);
  const auto expect_one_ring = [](const Curves& curves, const R& area) {
    const Region region(curves);
    EXPECT_EQ(region.boundaries().size(), 1u);
    EXPECT_EQ(region.area(), std::make_pair(area, area));
    EXPECT_FALSE(region.has_touching_boundaries());
    return region;
  };
  const Region rooms = expect_one_ring({polygon({a, b, c, d}), polygon({{4, 1}, {8, 1}, {8, 5}, {4, 5}})}, 32);
  EXPECT_EQ(rooms.bounded_side(Point(4, 2)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(rooms.bounded_side(Point(4, R(1) / 2)), CGAL::ON_BOUNDARY);
  EXPECT_EQ(rooms.bounded_side(Point(4, R(9) / 2)), CGAL::ON_BOUNDARY);
  expect_one_ring({polygon({a, b, c, d}), polygon({{1, 0}, {2, 0}, {2, 1}})}, R(31) / 2);   // a notch
  expect_one_ring({polygon({a, b, {4, 8}, {0, 8}}), polygon({{4, 1}, {8, 1}, {8, 5}, {4, 5}}),
                   polygon({{4, 5}, {6, 5}, {6, 7}, {4, 7}})},
                  52);
  // with corners in a straight wall
  expect_one_ring({polygon({a, b, {4, 2}, {4, 3}, {4, 5}, {0, 5}}), polygon({{4, 1}, {8, 1}, {8, 4}, {4, 4}})}, 32);
  expect_one_ring(
      {polygon({a, b, c, d}), polygon({{1, 1}, {1, 0}, {2, 0}, {2, 1}}), polygon({{3, 1}, {3, 0}, {4, 0}, {4, 1}})},
      14);
  // Below and above a part of a parabola.
  const auto arch = SC::bezier_curve<Exact_cartesian>({{0, 0}, {2, 4}, {4, 0}});
  expect_one_ring({arch, segment(b, a), arch.restricted(R(1) / 4, R(3) / 4),
                   SC::polyline_curve(std::vector<Point>{{3, R(3) / 2}, {3, 3}, {1, 3}, {1, R(3) / 2}})},
                  R(23) / 3);
  // The same with a wall in two pieces, at other speeds, and beside a drop of one piece, which ends where it begins.
  expect_one_ring({arch, segment(b, a), arch.restricted(R(1) / 4, R(1) / 3), arch.restricted(R(1) / 3, R(3) / 4),
                   SC::polyline_curve(std::vector<Point>{{3, R(3) / 2}, {3, 3}, {1, 3}, {1, R(3) / 2}})},
                  R(23) / 3);
  const auto drop = SC::bezier_curve<Exact_cartesian>({{0, 0}, {4, -3}, {4, 3}, {0, 0}});
  const Region beside_drop(
      Curves{drop, drop.restricted(R(1) / 8, R(1) / 3), drop.restricted(R(1) / 3, R(3) / 8),
             SC::polyline_curve(std::vector<Point>{drop(R(3) / 8), {4, -3}, {0, -3}, drop(R(1) / 8)})});
  EXPECT_EQ(beside_drop.boundaries().size(), 1u);
  EXPECT_EQ(beside_drop.bounded_side(drop(R(1) / 4)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(beside_drop.bounded_side(drop(R(3) / 4)), CGAL::ON_BOUNDARY);
  // at different speeds
  expect_invalid(
      [&] {
        Region region(Curves{SC::bezier_curve<Exact_cartesian>({b, {4, 1}, c}),
                             SC::polyline_curve(std::vector<Point>{c, d, a, b}),
                             polygon({{4, 1}, {8, 1}, {8, 5}, {4, 5}})});
      },
      "meet in a common part");
}

} // namespace

} // namespace planar_regions_2_test
