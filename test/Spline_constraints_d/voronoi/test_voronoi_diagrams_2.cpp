// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams: of points and of a triangle in closed form, of points as CGAL finds them; of curves, every disk on
// every edge is empty and touches both sites, the numbers of vertices, edges and regions satisfy Euler's formula, and
// motions do not change them.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/exact_disk_curvatures.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace voronoi_diagrams_2_test {

TEST(VoronoiDiagrams, ThreePoints)
{
  const Diagram diagram = SC::voronoi_diagram(Curves(), {P(0, 0), P(4, 0), P(0, 2)});
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(counts(diagram), (Counts{0, 0, 1, 3, 3}));
  EXPECT_EQ(diagram.number_of_regions(), 3U);
  for (const auto& vertex : diagram.vertices())
    if (!vertex.is_at_infinity) {
      EXPECT_NEAR(distance(*vertex.point, P(2, 1)), 0, 1e-12);
      EXPECT_NEAR(*vertex.radius, std::sqrt(5.0), 1e-12);
      EXPECT_EQ(vertex.edges.size(), 3U);
    }
  expect_euler(diagram);
}

TEST(VoronoiDiagrams, PointsAsCGALFindsThem)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 100);
  for (int run = 0; run < 5; ++run) {
    std::vector<P> points;
    for (int i = 0; i < 20; ++i)
      points.emplace_back(coordinate(random), coordinate(random));
    CGAL::Delaunay_triangulation_2<K> triangulation(points.begin(), points.end());
    const Diagram diagram = SC::voronoi_diagram(Curves(), points);
    EXPECT_TRUE(diagram.is_complete());
    const std::size_t edges = triangulation.number_of_vertices() + triangulation.number_of_faces() - 1;
    EXPECT_EQ(diagram.edges().size(), edges);
    EXPECT_EQ(counts(diagram).branching, triangulation.number_of_faces());
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face)
      EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
        return !v.is_at_infinity && distance(*v.point, triangulation.dual(face)) < 1e-7 * (1 + *v.radius);
      }));
    expect_euler(diagram);
  }
}

// Whether the bounds of a vertex are narrow and hold an exact point, and a squared radius.
bool is_proved_to_be(const Diagram::Vertex& vertex, const SC::Exact_rational& x, const SC::Exact_rational& y,
                     const SC::Exact_rational& squared_radius)
{
  const auto holds = [](double low, const SC::Exact_rational& value, double high) {
    return high - low < 1e-9 && SC::Exact_rational(low) <= value && value <= SC::Exact_rational(high);
  };
  const auto& [least, most] = vertex.radius_bounds;
  return holds(vertex.box.xmin(), x, vertex.box.xmax()) && holds(vertex.box.ymin(), y, vertex.box.ymax()) &&
      most - least < 1e-9 && SC::Exact_rational(least) * least <= squared_radius &&
      squared_radius <= SC::Exact_rational(most) * most;
}

TEST(VoronoiDiagrams, VerticesHaveProvedBounds)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(0, 100);
  std::vector<P> points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(coordinate(random), coordinate(random));
  const Diagram of_points = SC::voronoi_diagram(Curves(), points);
  using Exact_point = CGAL::Point_2<CGAL::Simple_cartesian<SC::Exact_rational>>;
  const auto exact = [&](const auto& footpoint) {
    return Exact_point(of_points.sites()[footpoint.site].point.x(), of_points.sites()[footpoint.site].point.y());
  };
  for (const auto& vertex : of_points.vertices())
    if (!vertex.is_at_infinity) {
      const Exact_point p = exact(vertex.footpoints[0]),
                        center = CGAL::circumcenter(p, exact(vertex.footpoints[1]), exact(vertex.footpoints[2]));
      EXPECT_TRUE(is_proved_to_be(vertex, center.x(), center.y(), CGAL::squared_distance(p, center))) << *vertex.point;
    }
  EXPECT_GT(of_points.vertices().size(), 50U);

  const auto has_vertex = [](const Diagram& diagram, const SC::Exact_rational& x, const SC::Exact_rational& y,
                             const SC::Exact_rational& squared_radius) {
    return std::any_of(diagram.vertices().begin(), diagram.vertices().end(),
                       [&](const auto& v) { return is_proved_to_be(v, x, y, squared_radius); });
  };
  const Diagram triangle =
      SC::voronoi_diagram(Curves{bezier({P(0, 0), P(4, 0)}), bezier({P(4, 0), P(0, 3)}), bezier({P(0, 3), P(0, 0)})});
  EXPECT_TRUE(has_vertex(triangle, 1, 1, 1));
  EXPECT_TRUE(has_vertex(triangle, 4, 0, 0));
  EXPECT_TRUE(has_vertex(SC::voronoi_diagram(Curves{SC::circle_curve(P(1, 2), 3.)}), 1, 2, 9));
  // y = x^2, all of it, cut at 1/2, and the half of it, has the center of curvature (0,1/2); also if it goes on as y =
  // x^2 / 2, which is less curved.
  const SC::Exact_rational half(1, 2), quarter(1, 4);
  EXPECT_TRUE(has_vertex(SC::voronoi_diagram(Curves{bezier({P(-1, 1), P(0, -1), P(1, 1)})}), 0, half, quarter));
  EXPECT_TRUE(has_vertex(SC::voronoi_diagram(Curves{bezier({P(0, 0), P(0.5, 0), P(1, 1)})}), 0, half, quarter));
  EXPECT_TRUE(has_vertex(
      SC::voronoi_diagram(Curves{bezier({P(0, 0), P(0.5, 0), P(1, 1)}), bezier({P(0, 0), P(-1, 0), P(-2, 2)})}), 0,
      half, quarter));
  // Footpoints: the disk of radius 3/2 around (0, 5/2) touches y = x^2 in x = -sqrt(2) and sqrt(2), and y = 4 in x = 0.
  const Diagram segment =
      SC::voronoi_diagram(Curves{bezier({P(-2, 4), P(0, -4), P(2, 4)}), bezier({P(-2, 4), P(2, 4)})});
  for (const auto& vertex : segment.vertices())
    if (is_proved_to_be(vertex, 0, SC::Exact_rational(5, 2), SC::Exact_rational(9, 4)))
      for (const auto& footpoint : vertex.footpoints) {
        const SC::Exact_rational low = 4 * SC::Exact_rational((*footpoint.parameter_bounds)[0]) - 2,
                                 high = 4 * SC::Exact_rational((*footpoint.parameter_bounds)[1]) - 2;
        EXPECT_TRUE(footpoint.site == 0 ? (low * low - 2) * (high * high - 2) <= 0 : low * high <= 0);
        EXPECT_LT(high - low, 1e-9);
      }
  EXPECT_TRUE(has_vertex(segment, 0, SC::Exact_rational(5, 2), SC::Exact_rational(9, 4)));
}

using CGAL::Interval_nt;

// The number of vertices whose bounds meet others. In a crossing of curves are several.
std::ptrdiff_t vertices_in(const Diagram& diagram, const Interval_nt<>& x, const Interval_nt<>& y,
                           const Interval_nt<>& radius)
{
  return std::count_if(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
    const bool is_in_box = x.do_overlap({v.box.xmin(), v.box.xmax()}) && y.do_overlap({v.box.ymin(), v.box.ymax()});
    return !v.is_at_infinity && is_in_box && radius.do_overlap({v.radius_bounds[0], v.radius_bounds[1]});
  });
}

// A motion by which integers stay integers: the bounds of each vertex, moved, meet those of as many vertices of the
// moved diagram.
TEST(VoronoiDiagrams, BoundsOfVerticesMove)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> coordinate(0, 1000);
  const auto moved = [](const P& p) { return P(3 * p.x() - 4 * p.y(), 4 * p.x() + 3 * p.y()); };
  std::size_t vertices = 0;
  for (int run = 0; run < 5; ++run) {
    Curves curves, others;
    for (int i = 0; i < 3; ++i) {
      std::vector<P> points;
      for (int j = 0; j < 4; ++j)
        points.emplace_back(coordinate(random), coordinate(random));
      curves.push_back(bezier(points));
      std::transform(points.begin(), points.end(), points.begin(), moved);
      others.push_back(bezier(points));
    }
    const Diagram a = SC::voronoi_diagram(curves), b = SC::voronoi_diagram(others);
    EXPECT_TRUE(a.is_complete() && b.is_complete());
    EXPECT_EQ(counts(a), counts(b));
    expect_vertex_bounds(a);
    for (const auto& v : a.vertices()) {
      if (v.is_at_infinity)
        continue;
      const Interval_nt<> x(v.box.xmin(), v.box.xmax()), y(v.box.ymin(), v.box.ymax()),
          r(v.radius_bounds[0], v.radius_bounds[1]);
      EXPECT_EQ(vertices_in(b, 3 * x - 4 * y, 4 * x + 3 * y, 5 * r), vertices_in(a, x, y, r)) << *v.point;
      ++vertices;
    }
  }
  EXPECT_GT(vertices, 100U);
}

TEST(VoronoiDiagrams, Triangle)
{
  // Sides 3, 4, 5: the incenter is (1, 1).
  const Curves sides{bezier({P(0, 0), P(4, 0)}), bezier({P(4, 0), P(0, 3)}), bezier({P(0, 3), P(0, 0)})};
  const Diagram diagram = SC::voronoi_diagram(sides);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(counts(diagram), (Counts{3, 0, 1, 0, 3}));
  for (const auto& vertex : diagram.vertices())
    if (vertex.edges.size() == 3) {
      EXPECT_NEAR(distance(*vertex.point, P(1, 1)), 0, 1e-12);
      EXPECT_NEAR(*vertex.radius, 1, 1e-12);
    }
  expect_euler(diagram);
  expect_empty_disks(diagram, sides);
}

// Vertices whose disks touch a point, or the quarter of a circle, in the direction of an axis, or the end of a segment
// at a right angle: there a normal cone of normals, an arc or a side ends and the next one begins.
TEST(VoronoiDiagrams, VerticesWhereContactsGoOver)
{
  const auto circle = [](double x, double y, double radius = 1) { return SC::circle_curve(P(x, y), radius); };
  struct Scene
  {
    Curves curves;
    std::vector<P> points;
    std::vector<P> vertices;   // of degree three or more
  };
  const std::vector<Scene> scenes{
    {{bezier({P(0, 0), P(8, 0)}), bezier({P(0, 4), P(8, 4)})}, {P(4, 2)}, {P(2, 2), P(6, 2)}},
    {{bezier({P(0, 0), P(8, 4)}), bezier({P(-2, 4), P(6, 8)})}, {P(3, 4)}, {P(1, 3), P(5, 5)}},
    {{circle(-4, 0), circle(4, 0)}, {P(0, 4)}, {P(0, 0.9)}},
    {{circle(-4, 0), circle(4, 0), circle(0, 4), circle(0, -4)}, {}, {P(0, 0)}},
    {{circle(0, 0, 8), bezier({P(-4, 0), P(-2, 0)})}, {P(2, 0)}, {P(0, 3.75), P(0, -3.75)}},
    {{circle(0, 0, 8), bezier({P(-4, 0), P(-2, 0)}), bezier({P(4, 0), P(2, 0)})}, {}, {P(0, 3.75), P(0, -3.75)}},
    {{bezier({P(-4, 0), P(8, 0)}), bezier({P(-4, 4), P(2, 4)})}, {P(4, 2)}, {P(2, 2), P(11, 11)}},
    {{bezier({P(0, 0), P(8, 0)}), bezier({P(0, 4), P(8, 4)})}, {P(-2, 2)}, {P(0, 2)}}};
  for (const Scene& scene : scenes) {
    const Diagram diagram = SC::voronoi_diagram(scene.curves, scene.points);
    EXPECT_TRUE(diagram.is_complete());
    EXPECT_EQ(counts(diagram).branching, scene.vertices.size());
    for (const P& vertex : scene.vertices)
      EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(),
                              [&](const auto& v) {
                                return v.edges.size() > 2 && v.point && distance(*v.point, vertex) < 1e-12;
                              }));
    expect_euler(diagram);
  }
}

// The disk around (0, 1) touches the vertex of a parabola and a line, or another parabola, and a point on its
// horizontal diameter: an end of the normals that are looked at together.
TEST(VoronoiDiagrams, PointBesideVerticesOfParabolas)
{
  const Curve above = bezier({P(-1, 3), P(0, 1), P(1, 3)});
  for (const Curve& below : {bezier({P(-3, 0), P(4, 0)}), bezier({P(-1, -1), P(0, 1), P(1, -1)})})
    for (const double x : {-1.0, 1.0}) {
      const Curves curves{below, above};
      const Diagram diagram = SC::voronoi_diagram(curves, {P(x, 1)});
      EXPECT_TRUE(diagram.is_complete());
      expect_euler(diagram);
      expect_empty_disks(diagram, curves, 0.05, 20);
      EXPECT_EQ(std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                              [](const auto& v) {
                                return v.edges.size() == 3 && v.point && distance(*v.point, P(0, 1)) < 1e-12;
                              }),
                1);
    }
}

// A closed curve of four cubics, nearly a circle, symmetric about its axes and the lines between them.
Curves rounded_square(double x, double y, double radius, double handle)
{
  Curves result;
  for (const auto& [a, b, c, d] :
       std::vector<std::array<double, 4>>{{1, 0, 0, 1}, {0, 1, -1, 0}, {-1, 0, 0, -1}, {0, -1, 1, 0}}) {
    const auto at = [&, a = a, b = b, c = c, d = d](double s, double t) {
      return P(x + s * a + t * c, y + s * b + t * d);
    };
    result.push_back(bezier({at(radius, 0), at(radius, handle), at(handle, radius), at(0, radius)}));
  }
  return result;
}

TEST(VoronoiDiagrams, SymmetricDrawings)
{
  // Disks on the axis of both arms touch them, and a joint of the outline or both sides of it, in points that are not
  // rational.
  Curves hook = rounded_square(0, 0, 4, 2.25);
  hook.push_back(bezier({P(0, -2), P(3, 1)}));
  hook.push_back(bezier({P(0, -2), P(-2, 0)}));
  const Diagram diagram = SC::voronoi_diagram(hook);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(counts(diagram).branching, 1U);
  EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(),
                          [](const auto& v) {
                            return v.edges.size() == 3 && v.point && std::abs(v.point->x()) < 1e-9;
                          }));
  expect_euler(diagram);
}

TEST(VoronoiDiagrams, HalfPlanesThatTouchThreeCircles)
{
  // The cell of the circle in the middle ends in them on both sides: two vertices at infinity, each of two edges.
  Curves circles;
  for (const double y : {-6, 0, 6})
    circles.push_back(SC::circle_curve(P(0, y), 2));
  const Diagram diagram = SC::voronoi_diagram(circles);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(counts(diagram).far, 2U);
  expect_euler(diagram);
}

TEST(VoronoiDiagrams, HalfPlanesThatTouchCopies)
{
  // Three copies of a curve in a row: above, where they are touched is not rational; below, they are touched in their
  // last points, and the first one also in both of its ends. So it is if a segment cuts one of them at a parameter that
  // is not rational.
  Curves copies;
  for (const double k : {0, 1, 2})
    copies.push_back(bezier({P(6 * k, k), P(6 * k + 1, k + 2), P(6 * k + 3, k + 3), P(6 * k + 5, k)}));
  for (const bool is_cut : {false, true}) {
    if (is_cut)
      copies.push_back(bezier({P(6, 2), P(7.5, 2)}));
    const Diagram diagram = SC::voronoi_diagram(copies);
    EXPECT_TRUE(diagram.is_complete());
    EXPECT_EQ(counts(diagram).far, 3U);
    EXPECT_EQ(std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                            [](const auto& v) { return v.is_at_infinity && v.edges.size() == 2; }),
              2);
    expect_euler(diagram);
  }
}

TEST(VoronoiDiagrams, FansOfACommonDisk)
{
  // Four wedges that point to a center: the disk there touches each in the middle of the normals of its point.
  Curves wedges;
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
    for (const int side : {-1, 1})
      wedges.push_back(bezier({P(x, y), P(3 * x - side * y, 3 * y + side * x)}));
  const Diagram diagram = SC::voronoi_diagram(wedges);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(),
                          [](const auto& v) {
                            return v.edges.size() == 4 && v.point && distance(*v.point, P(0, 0)) < 1e-12;
                          }));
  expect_euler(diagram);
}

TEST(VoronoiDiagrams, FanOnTheLineOfASegment)
{
  // The half-plane below touches a corner and a segment.
  const Diagram diagram = SC::voronoi_diagram(Curves{bezier({P(-2, 1), P(0, 0)}), bezier({P(0, 0), P(-1, 2)}),
                                                     bezier({P(2, 0), P(5, 0)}), bezier({P(5, 0), P(4, 3)})});
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
}

TEST(VoronoiDiagrams, NumbersWithRoots)
{
  const auto number = [](int a, int b) { return SC::internal::Voronoi::Number_with_root{a, b}; };
  EXPECT_TRUE(number(1, 4) == number(3, 0));
  EXPECT_TRUE(number(3, 0) == number(1, 4));
  EXPECT_TRUE(number(-2, 9) == number(0, 1));
  EXPECT_TRUE(number(5, 2) == number(5, 2));
  EXPECT_FALSE(number(5, 2) == number(5, 3));
  EXPECT_FALSE(number(5, 2) == number(4, 2));
  EXPECT_FALSE(number(1, 4) == number(-1, 0));   // 1 - 2
  EXPECT_FALSE(number(-1, 0) == number(1, 4));
  EXPECT_FALSE(number(0, 8) == number(1, 2));
}

TEST(VoronoiDiagrams, CircleHasItsCenter)
{
  const Diagram diagram = SC::voronoi_diagram(Curves{SC::ellipse_curve(P(1, 2), K::Vector_2(3, 0), K::Vector_2(0, 3))});
  EXPECT_TRUE(diagram.is_complete());
  ASSERT_EQ(diagram.vertices().size(), 1U);
  EXPECT_NEAR(distance(*diagram.vertices()[0].point, P(1, 2)), 0, 1e-12);
  EXPECT_NEAR(*diagram.vertices()[0].radius, 3, 1e-12);
  EXPECT_TRUE(diagram.edges().empty());
}

// An open cubic has two bends, with a tip of the diagram in the center of curvature of each.
TEST(VoronoiDiagrams, TwoCubics)
{
  const Curves curves{bezier({P(0, 0), P(1, 2), P(2, -2), P(3, 0)}), bezier({P(0, 3), P(1, 5), P(2, 2), P(3, 4)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.number_of_regions(), 2U);
  EXPECT_EQ(counts(diagram).tips, 4U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Its narrow turn is nearest to the begin on the side that does not come next around the begin, while the other side
// has the begin as a footpoint, too.
TEST(VoronoiDiagrams, CubicWithANarrowTurn)
{
  const Curves curves{bezier({P(1.1604, 2.6275), P(1.4585, 2.1156), P(1.72, 2.7627), P(1.71, 2.741)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// A closed curve of one piece begins and ends in its corner.
TEST(VoronoiDiagrams, ClosedCubicWithACorner)
{
  const Curves curves{bezier({P(0, 0), P(4, -2), P(4, 3), P(0, 0)}), bezier({P(-2, -1), P(-2, 2)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.number_of_regions(), 2U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

Curves cubics_in_cells(std::mt19937& random, int rows)
{
  std::uniform_real_distribution<double> coordinate(1, 9);
  Curves curves;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) {
      std::vector<double> x(4);
      std::generate(x.begin(), x.end(), [&] { return coordinate(random); });
      std::sort(x.begin(), x.end());
      std::vector<P> points;
      for (const double t : x)
        points.push_back(i % 2 == 0 ? P(10 * i + t, 10 * j + coordinate(random))
                                    : P(10 * i + coordinate(random), 10 * j + t));
      curves.push_back(bezier(points));
    }
  return curves;
}

TEST(VoronoiDiagrams, RandomScenes)
{
  std::mt19937 random(7);
  const K::Aff_transformation_2 motion(0.6, -0.8, 3, 0.8, 0.6, -5);
  int complete = 0;
  for (int run = 0; run < 3; ++run) {
    const Curves curves = cubics_in_cells(random, 2);
    const Diagram diagram = SC::voronoi_diagram(curves);
    if (!diagram.is_complete())
      continue;
    ++complete;
    expect_euler(diagram);
    expect_empty_disks(diagram, curves);
    Curves moved;
    for (const Curve& curve : curves)
      moved.push_back(curve.transformed(motion));
    EXPECT_EQ(counts(SC::voronoi_diagram(moved)), counts(diagram));
  }
  EXPECT_EQ(complete, 3);
}

// The scene of benchmark_voronoi_diagrams.
TEST(VoronoiDiagrams, HundredCubics)
{
  std::mt19937 random(1);
  const Curves curves = cubics_in_cells(random, 10);
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.sites().size(), 300U);
  EXPECT_EQ(diagram.number_of_regions(), 100U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves, 0.5);
}

// From 2 to 11 cubics in a square, most of which cross others: diagrams are complete, and nothing contradicts them.
TEST(VoronoiDiagrams, RandomScenesOfCurvesThatCross)
{
  std::size_t crossing = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    const double side = 6 * std::sqrt(static_cast<double>(seed + 1));
    std::uniform_real_distribution<double> place(0, side), offset(-5, 5);
    Curves curves;
    for (unsigned i = 0; i <= seed; ++i) {
      const P center(place(random), place(random));
      std::vector<P> points;
      for (int k = 0; k < 4; ++k) {
        const double x = center.x() + offset(random), y = center.y() + offset(random);
        points.emplace_back(x, y);
      }
      curves.push_back(bezier(points));
    }
    const Diagram diagram = SC::voronoi_diagram(curves);
    EXPECT_TRUE(diagram.is_complete()) << "seed " << seed;
    expect_euler(diagram);
    expect_empty_disks(diagram, curves, 0.5);
    crossing += diagram.sites().size() > 3 * curves.size();   // curves are cut there
  }
  EXPECT_GT(crossing, 5U);
}

// Random points, against the distances from many points of all sites. In benchmark_nearest_sites there are 100,000, and
// distances are those from the curves.
TEST(VoronoiDiagrams, NearestSites)
{
  std::mt19937 random(3);
  const Curves curves = cubics_in_cells(random, 2);
  const Diagram diagram = SC::voronoi_diagram(curves, {P(10, 10)});
  constexpr int steps = 64, queries = 1000;
  std::vector<std::vector<P>> points;
  for (const auto& site : diagram.sites()) {
    points.push_back({site.point});
    for (int i = 0; i <= steps && !site.is_point; ++i)
      points.back().push_back(curves[*site.curve](static_cast<double>(i) / steps));
  }
  const auto distance_from = [&](std::size_t site, const P& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const P& q : points[site])
      least = (std::min)(least, CGAL::squared_distance(p, q));
    return std::sqrt(least);
  };
  std::uniform_real_distribution<double> coordinate(-5, 25);
  std::vector<int> answers(diagram.sites().size(), 0);
  for (int i = 0; i < queries; ++i) {
    const P p(coordinate(random), coordinate(random));
    const auto sites = diagram.nearest_sites(p);
    ASSERT_EQ(sites.size(), 1U);
    ++answers[sites[0]];
    const double distance = distance_from(sites[0], p);
    for (std::size_t site = 0; site < points.size(); ++site)
      EXPECT_LT(distance, distance_from(site, p) + 0.02) << "site " << site;
  }
  EXPECT_GT(std::count_if(answers.begin(), answers.end(), [](int number) { return number > 0; }),
            static_cast<std::ptrdiff_t>(answers.size() / 2));

  // On an edge there are two, in a vertex three.
  const Diagram three = SC::voronoi_diagram(Curves(), {P(0, 0), P(4, 0), P(0, 2)});
  EXPECT_EQ(three.nearest_sites(P(2, -7)), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(three.nearest_sites(P(2, 1)), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(three.nearest_sites(P(3, 1)), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(SC::voronoi_diagram(Curves()).nearest_sites(P(0, 0)).empty());
}

// Distances that are equal but for 1e-12 to 1e-24: from the vertices of two parabolas, y = +- (1 + x^2), and from two
// points.
TEST(VoronoiDiagrams, NearestOfTwoThatAreNearlyEqual)
{
  using Sites = std::vector<std::size_t>;
  const Diagram parabolas = SC::voronoi_diagram(
                    Curves{bezier({P(-2, -5), P(-0.5, 1), P(1, -2)}), bezier({P(-1, 2), P(0.5, -1), P(2, 5)})}),
                points = SC::voronoi_diagram(Curves(), {P(-1, 0), P(1, 0)});
  for (const int exponent : {40, 56, 60, 80}) {
    const double shift = std::exp2(-exponent);
    EXPECT_EQ(parabolas.nearest_sites(P(0, -shift)), Sites{0}) << exponent;
    EXPECT_EQ(parabolas.nearest_sites(P(0, shift)), Sites{1}) << exponent;
    EXPECT_EQ(points.nearest_sites(P(-shift, 5)), Sites{0}) << exponent;
    EXPECT_EQ(points.nearest_sites(P(shift, 5)), Sites{1}) << exponent;
  }
  EXPECT_EQ(parabolas.nearest_sites(P(0, 0)), (Sites{0, 1}));
  EXPECT_EQ(points.nearest_sites(P(0, 5)), (Sites{0, 1}));
}

// What drawings contain: pieces on one line, tiny segments, segments that are given twice, concentric circles. The
// bisectors of different curves are known.
template <class Is_on_bisector>
void expect_bisector(const Curves& curves, const Is_on_bisector& is_on_bisector)
{
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  std::size_t samples = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, 0.1, 10)) {
      const auto& [a, b] = diagram.edges()[e].sites;
      if (const double offset = is_on_bisector(sample.point, diagram.sites()[a], diagram.sites()[b]);
          !std::isnan(offset)) {
        ++samples;
        EXPECT_NEAR(offset, 0, 1e-9);
      }
    }
  EXPECT_GT(samples, 3U);
}

TEST(VoronoiDiagrams, PiecesOfDrawings)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Curve left = bezier({P(0, 0), P(1, 0)}), right = bezier({P(2, 0), P(3, 0)}),
              tiny = bezier({P(2, 0), P(2 + 1e-9, 0)});
  const auto ends = [none](const P& p, const auto& a, const auto& b) {
    return a.is_point && b.is_point && a.point.x() * b.point.x() == 2 ? p.x() - 1.5 : none;
  };
  expect_bisector({left, right}, ends);
  expect_bisector({left, tiny}, ends);
  expect_bisector({left, right, left}, ends);
  const auto circle = [](double r) { return SC::ellipse_curve(P(0, 0), K::Vector_2(r, 0), K::Vector_2(0, r)); };
  expect_bisector({circle(1), circle(2)}, [none](const P& p, const auto& a, const auto& b) {
    return a.is_point || b.is_point ? none : distance(p, P(0, 0)) - 1.5;
  });
}

TEST(VoronoiDiagrams, BadInput)
{
  EXPECT_THROW(SC::voronoi_diagram(Curves{bezier({P(1, 1), P(1, 1)})}), SC::Invalid_input);
  const Diagram diagram = SC::voronoi_diagram(Curves(), {P(0, 0), P(1, 0)});
  EXPECT_THROW(diagram.polyline(0, 0), SC::Invalid_input);
  EXPECT_THROW(diagram.polyline(7, 0.1), SC::Invalid_input);
  EXPECT_EQ(diagram.polyline(0, 0.1, 0.1).size(), 0U);   // all disks are larger
}

// What is not decided is named: the disk of the greatest curvature of a parabola touches a point, too.
TEST(VoronoiDiagrams, NamesWhatIsUndecided)
{
  const Curves curves{bezier({P(-1, 1), P(0, -1), P(1, 1)})};
  const Diagram diagram = SC::voronoi_diagram(curves, {P(0, 1)});
  EXPECT_FALSE(diagram.is_complete());
  const std::vector<SC::Undecided_part> parts = diagram.undecided();
  EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [](const SC::Undecided_part& part) {
    const auto& [operand, ranges] = part.parameters.at(0);
    return operand == 0 && ranges.at(0).first <= 0.5 && 0.5 <= ranges.at(0).second && !part.reason.empty();
  }));
  expect_empty_disks(diagram, curves);   // what is there is right
  EXPECT_TRUE(SC::voronoi_diagram(curves).undecided().empty());
}

} // namespace voronoi_diagrams_2_test
