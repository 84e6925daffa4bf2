// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points, lines and curves with surfaces, and points with curves, against exact answers.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace surface_intersections_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Intersection_kind;
using K = Exact_cartesian;
using FT = Exact_rational;
using Function = SC::Bspline_function<FT>;
using Curve = SC::Bspline_curve_3<K>;
using Surface = SC::Bspline_surface_3<K>;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Line = K::Line_3;
using Range = std::pair<FT, FT>;

FT ratio(int a, int b) { return FT(a) / FT(b); }

Function polynomial(const std::vector<int>& degrees, const std::vector<FT>& power)
{
  return Function::from_tensor(SC::Bernstein_tensor<FT>::from_power(degrees, power),
                               std::vector<Range>(degrees.size(), Range(0, 1)));
}

const Function t = polynomial({1}, {0, 1}), one = polynomial({0}, {1});
const Function u = polynomial({1, 0}, {0, 1}), v = polynomial({0, 1}, {0, 1}), one_on_square = polynomial({0, 0}, {1});

// The graph of u^2 v, as a bicubic.
const Surface graph =
    Surface::from_homogeneous_coordinates({u + v * FT(0), u* FT(0) + v, u* u* v}, one_on_square).elevated({3, 3});

// The curve (t, 1-t), lifted by a height above the graph.
Curve curve_above_graph(const Function& height)
{
  return Curve::from_homogeneous_coordinates({t, FT(1) - t, t * t * (FT(1) - t) + height}, one);
}

Function product_of_zeros(const std::vector<FT>& zeros)
{
  Function result = one;
  for (const FT& zero : zeros)
    result = result * (t - zero);
  return result;
}

bool holds(const Range& range, const FT& x) { return range.first <= x && x <= range.second; }

CGAL::Aff_transformation_3<K> random_map(Random_source& random)
{
  std::vector<FT> m;
  for (int i = 0; i < 12; ++i)
    m.push_back(ratio(random.integer(-20, 20), random.integer(1, 5)));
  for (const int i : {0, 5, 10})
    m[i] += 60;   // regular
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]};
}

template <class Intersections>
void expect_kinds(const Intersections& found, std::size_t transversal, std::size_t tangent = 0,
                  std::size_t end_points = 0, std::size_t overlaps = 0)
{
  EXPECT_TRUE(found.is_complete()) << found.summary();
  EXPECT_EQ(found.count(Intersection_kind::TRANSVERSAL), transversal);
  EXPECT_EQ(found.count(Intersection_kind::TANGENT), tangent);
  EXPECT_EQ(found.count(Intersection_kind::END_POINT), end_points);
  EXPECT_EQ(found.count(Intersection_kind::OVERLAP), overlaps);
  EXPECT_EQ(found.size(), transversal + tangent + end_points + overlaps);
}

const Surface unit_sphere = SC::sphere_surface(Point(0, 0, 0), FT(1));

TEST(Surface_intersections, LinesAndASphere)
{
  const auto through = SC::intersections(Line(Point(0, 0, 0), Vector(2, 1, 2)), unit_sphere);
  expect_kinds(through, 2);
  EXPECT_TRUE(holds(through[0].parameter_range(0), ratio(-1, 3)) && holds(through[1].parameter_range(0), ratio(1, 3)));
  EXPECT_NEAR(CGAL::to_double(through[1].point().x()), 2.0 / 3, 1e-12);

  const Vector tangent(1, -2, 0);   // at (2,1,2)/3
  const Point touching(ratio(2, 3), ratio(1, 3), ratio(2, 3));
  const auto contact = SC::intersections(Line(touching, tangent), unit_sphere);
  expect_kinds(contact, 0, 1);
  EXPECT_EQ(contact[0].multiplicity(), 2);
  const FT little(1e-30);
  expect_kinds(SC::intersections(Line(touching + Vector(0, 0, little), tangent), unit_sphere), 0);
  expect_kinds(SC::intersections(Line(touching - Vector(0, 0, little), tangent), unit_sphere), 2);
  EXPECT_TRUE(SC::intersections(Line(Point(7, 0, 0), tangent), unit_sphere).empty());
}

TEST(Surface_intersections, PolesOfASphere)
{
  const auto both = SC::intersections(Line(Point(0, 0, 0), Vector(0, 0, 2)), unit_sphere);
  expect_kinds(both, 0, 0, 2);
  EXPECT_EQ(both[0].parameter_range(0), Range(ratio(-1, 2), ratio(-1, 2)));
  EXPECT_EQ(both[1].parameter_range(0), Range(ratio(1, 2), ratio(1, 2)));
  EXPECT_EQ(both[1].parameter_range(1, 1), Range(2, 2));
  EXPECT_EQ(both[1].parameter_range(1, 0), Range(0, 4));   // every one
  EXPECT_TRUE(both[1].is_at_end(1, 1) && !both[1].is_at_end(1, 0) && !both[1].is_at_end(0));
  EXPECT_EQ(both[1].point(), Point(0, 0, 1));

  expect_kinds(SC::intersections(Line(Point(0, 0, 1), Vector(1, 2, 3)), unit_sphere), 1, 0, 1);
  expect_kinds(SC::intersections(Line(Point(0, 0, 1), Vector(3, 4, 0)), unit_sphere), 0, 0, 1);   // touches
  const auto inwards = SC::intersections(K::Ray_3(Point(0, 0, 1), Vector(1, 2, -3)), unit_sphere);
  expect_kinds(inwards, 1, 0, 1);
  EXPECT_TRUE(inwards[0].is_at_end(0) && inwards[0].is_at_end(1, 1));
  expect_kinds(SC::intersections(Point(0, 0, -1), unit_sphere), 0, 0, 1);

  // A circle that leaves the sphere at the pole and comes back at (1,0,0), on the seam.
  const auto circle = SC::circle_curve(Point(1, 0, 1), Vector(0, 1, 0), Point(2, 0, 1));
  const auto crossings = SC::intersections(circle, unit_sphere);
  EXPECT_TRUE(crossings.is_complete()) << crossings.summary();
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_EQ(crossings.count(Intersection_kind::UNDECIDED) + crossings.count(Intersection_kind::TANGENT), 0u);
  EXPECT_EQ(crossings[0].is_at_end(1, 1) + crossings[1].is_at_end(1, 1), 1);
}

// (s^3 - s, 0, s^2) for s in [-2,2] crosses itself at the pole, where x^2 + z^2 - 1 = (s^2 - 1) (s^4 + 1) is zero, and
// nowhere else.
TEST(Surface_intersections, CurveTwiceThroughAPole)
{
  const Function s = t * FT(4) - FT(2);
  const auto found =
      SC::intersections(Curve::from_homogeneous_coordinates({s * s * s - s, s * FT(0), s * s}, one), unit_sphere);
  expect_kinds(found, 0, 0, 2);
  EXPECT_TRUE(holds(found[0].parameter_range(0), ratio(1, 4)) && holds(found[1].parameter_range(0), ratio(3, 4)));
}

TEST(Surface_intersections, ApexAndRulingsOfACone)
{
  const Surface cone = SC::cone_surface(Point(0, 0, 0), Vector(0, 0, 5), Point(5, 0, 5));
  expect_kinds(SC::intersections(Line(Point(0, 0, 0), Vector(3, 1, 1)), cone), 0, 0, 1);
  expect_kinds(SC::intersections(Line(Point(0, 0, 0), Vector(1, 1, 9)), cone), 0, 0, 1);
  const auto ruling = SC::intersections(Line(Point(0, 0, 0), Vector(3, 4, 5)), cone);
  expect_kinds(ruling, 0, 0, 1, 1);
  EXPECT_EQ(ruling[1].parameter_range(0), Range(0, 1));
  EXPECT_EQ(ruling[1].parameter_range(1, 1), Range(0, 1));
  // A parabola through the apex, which stays inside.
  const auto parabola = SC::bezier_curve(std::vector<Point>{{-1, 0, 4}, {0, 0, -4}, {1, 0, 4}});
  expect_kinds(SC::intersections(parabola, cone), 1, 0, 2);   // and twice on the cone: |x| = 4 x^2, once on the seam
}

TEST(Surface_intersections, CylinderWithItsSeam)
{
  const Surface cylinder = SC::cylinder_surface(Point(0, 0, 0), FT(5), FT(2));
  const auto through_seam = SC::intersections(K::Ray_3(Point(7, 0, 1), Point(5, 0, 1)), cylinder);
  expect_kinds(through_seam, 1, 0, 1);
  EXPECT_TRUE(holds(through_seam[0].parameter_range(0), 1) && through_seam[0].is_at_end(1, 0) &&
              !through_seam[0].is_at_end(1, 1));
  EXPECT_EQ(through_seam[0].parameter_range(1, 0), Range(0, 0));
  // Along a ruling: a part of it, and the seam, found from both sides.
  const auto ruling = SC::intersections(K::Segment_3(Point(3, 4, 1), Point(3, 4, 5)), cylinder);
  expect_kinds(ruling, 0, 0, 0, 1);
  EXPECT_EQ(ruling[0].parameter_range(0), Range(0, ratio(1, 4)));
  EXPECT_EQ(ruling[0].parameter_range(1, 1), Range(ratio(1, 2), 1));
  expect_kinds(SC::intersections(Line(Point(5, 0, 0), Vector(0, 0, 1)), cylinder), 0, 0, 0, 1);
  // The lower edge, at irrational parameters.
  const auto edge = SC::intersections(Line(Point(0, 0, 0), Vector(1, 2, 0)), cylinder);
  expect_kinds(edge, 0, 0, 2);
  EXPECT_TRUE(edge[0].is_at_end(1, 1) && !edge[0].is_at_end(1, 0));
}

// Lines of a surface where one parameter is constant, forwards and backwards, with other parameters, and longer than
// the surface.
TEST(Surface_intersections, IsoparametricCurves)
{
  const auto overlap_with = [](const auto& curve, const auto& surface) {
    const auto intersections = SC::intersections(curve, surface);
    EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
    EXPECT_EQ(intersections.size(), 1u);
    EXPECT_EQ(intersections.count(Intersection_kind::OVERLAP), 1u);
    return intersections[0];
  };
  const auto cylinder = SC::cylinder_surface<K>(Point(0, 0, 0), FT(1), FT(2));
  const auto around = overlap_with(cylinder.iso_curve(1, ratio(1, 3)), cylinder);
  EXPECT_EQ(around.parameter_range(1, 0), Range(0, 4));
  EXPECT_EQ(around.parameter_range(1, 1), Range(ratio(1, 3), ratio(1, 3)));

  const std::vector<Point> net{{0, 0, 0}, {0, 1, 1}, {0, 2, 0}, {1, 0, 1}, {1, 1, 3},
                               {1, 2, 1}, {2, 0, 0}, {2, 1, 1}, {2, 2, 2}};
  const Surface surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, net);
  const auto line = surface.iso_curve(0, ratio(1, 3));
  const auto backwards = overlap_with(line.reversed(0).with_domain(0, FT(2), FT(5)).elevated({4}), surface);
  EXPECT_EQ(backwards.parameter_range(0), Range(2, 5));
  EXPECT_EQ(backwards.parameter_range(1, 1), Range(0, 1));
  const auto longer = overlap_with(line, surface.restricted(1, ratio(1, 4), ratio(1, 2)));
  EXPECT_EQ(longer.parameter_range(0), Range(ratio(1, 4), ratio(1, 2)));
}

// C = S(q) for the graph S, and the images of both.
TEST(Surface_intersections, CurvesAlongASurface)
{
  const auto along = [](const Function& q, const Function& r) {
    return Curve::from_homogeneous_coordinates({q, r, q * q * r}, one);
  };
  Random_source random(5);
  const auto map = random_map(random);
  const auto overlap_with = [&](const Curve& curve, const Surface& surface) {
    const auto intersections = SC::intersections(curve.transformed(map), surface.transformed(map));
    EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
    EXPECT_EQ(intersections.size(), 1u);
    EXPECT_EQ(intersections.count(Intersection_kind::OVERLAP), 1u);
    return intersections[0];
  };
  const auto expect_ranges = [](const auto& overlap, const Range& on_curve, const Range& first, const Range& second) {
    EXPECT_EQ(overlap.parameter_range(0), on_curve);
    EXPECT_EQ(overlap.parameter_range(1, 0), first);
    EXPECT_EQ(overlap.parameter_range(1, 1), second);
  };
  const Range unit(0, 1);
  expect_ranges(overlap_with(along(t, FT(1) - t), graph), unit, unit, unit);
  expect_ranges(overlap_with(along(t, t * t), graph), unit, unit, unit);
  expect_ranges(overlap_with(along(t, t * t * t), graph), unit, unit, unit);
  expect_ranges(overlap_with(along(t, FT(2) * t - ratio(1, 2)), graph), Range(ratio(1, 4), ratio(3, 4)),
                Range(ratio(1, 4), ratio(3, 4)), unit);
  expect_ranges(overlap_with(along(t, t * t * ratio(16, 9)), graph), Range(0, ratio(3, 4)), Range(0, ratio(3, 4)),
                unit);
  expect_ranges(overlap_with(along(t, FT(1) - t), graph.with_knot(0, ratio(1, 2))), unit, unit, unit);

  // both ends and the vertex within the range, which is an enclosure
  const auto vertex = overlap_with(along(t, (FT(2) * t - FT(1)) * (FT(2) * t - FT(1))), graph);
  EXPECT_TRUE(holds(vertex.parameter_range(1, 1), FT(0)) && holds(vertex.parameter_range(1, 1), FT(1)));

  const Function weight = FT(1) + t * (FT(1) - t), weight_on_square = one_on_square + u * v;
  const Surface rational =
      Surface::from_homogeneous_coordinates({u + v * FT(0), u * FT(0) + v, u * u * v}, weight_on_square);
  expect_ranges(
      overlap_with(Curve::from_homogeneous_coordinates({t, FT(1) - t, t * t * (FT(1) - t)}, weight), rational), unit,
      unit, unit);

  // It enters and leaves the surface.
  const auto twice = SC::intersections(along(t, (FT(2) * t - FT(1)) * (FT(2) * t - FT(1)) * ratio(25, 9)), graph);
  EXPECT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].parameter_range(0), Range(ratio(1, 5), ratio(4, 5)));

  // It leaves the surface at 1/sqrt(2).
  const auto irrational = SC::intersections(along(t, FT(2) * t * t), graph);
  EXPECT_TRUE(irrational.is_complete());
  ASSERT_EQ(irrational.size(), 1u);
  EXPECT_EQ(irrational[0].kind(), Intersection_kind::OVERLAP);
  EXPECT_EQ(irrational[0].parameter_range(0).first, 0);
  EXPECT_NEAR(CGAL::to_double(irrational[0].parameter_range(0).second), 0.5 * std::sqrt(2), 1e-12);
}

// A circle that is no line of the parameters, on a sphere and on parts of it: inside where its points satisfy
// inequalities.
TEST(Surface_intersections, CirclesOnASphere)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), FT(3));
  const Curve circle = SC::circle_curve(Point(1, 2, 1), Vector(1, 2, 1), Point(2, 1, 2));
  const auto whole = SC::intersections(circle, sphere);
  EXPECT_TRUE(whole.is_complete());
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].kind(), Intersection_kind::OVERLAP);
  EXPECT_EQ(whole[0].parameter_range(0), Range(0, 4));
  EXPECT_EQ(SC::intersections(sphere, circle).count(Intersection_kind::OVERLAP), 1u);

  // Parts below and above a parallel, on both sides of the equator.
  const auto [begin, end] = sphere.domain(1);
  int inside = 0;
  for (const int eighths : {3, 5}) {
    const FT parallel(begin + (end - begin) * ratio(eighths, 8)), height = sphere(FT(0), parallel).z();
    for (const Surface& part : {sphere.restricted(1, begin, parallel), sphere.restricted(1, parallel, end)}) {
      const auto [first, last] = part.domain(1);
      const CGAL::Sign side = CGAL::sign(sphere(FT(0), FT((first + last) / 2)).z() - height);
      const auto pieces = SC::intersections(circle, part);
      EXPECT_TRUE(pieces.is_complete()) << pieces.summary();
      EXPECT_EQ(pieces.count(Intersection_kind::OVERLAP), pieces.size());
      for (int k = 0; k <= 64; ++k) {
        const FT at = ratio(k, 16);
        const CGAL::Sign own = CGAL::sign(circle(at).z() - height);
        const bool is_inside = own == side || own == CGAL::ZERO;
        inside += is_inside;
        EXPECT_EQ(std::any_of(pieces.begin(), pieces.end(),
                              [&](const auto& piece) { return holds(piece.parameter_range(0), at); }),
                  is_inside)
            << at;
      }
    }
  }
  EXPECT_GE(inside, 2 * 65);   // each parameter is in one part of two pairs

  // Another radius, and a circle beside the part.
  expect_kinds(SC::intersections(SC::circle_curve(Point(0, 0, 2), Vector(0, 1, 1), Point(1, 0, 2)), sphere), 0);
  const Surface lower = sphere.restricted(1, begin, FT((begin + end) / 2)),
                upper = sphere.restricted(1, FT((begin + end) / 2), end);
  expect_kinds(SC::intersections(SC::circle_curve(Point(0, 0, 2), Vector(0, 0, 1), Point(1, 2, 2)),
                                 sphere(FT(0), begin).z() < 0 ? lower : upper),
               0);
}

// Ellipses on a cylinder that is too short for them, and on a cone; a circle of Villarceau on one half of a torus. A
// part of the curve is on the surface where its points are between two heights.
TEST(Surface_intersections, ConicsOnCylindersConesAndTori)
{
  struct Problem
  {
    Curve curve;
    Surface surface;
    int axis, lower, upper;   // the coordinate of the heights
    std::size_t overlaps;
  };
  const Curve villarceau = SC::circle_curve(Point(0, 3, 0), Vector(-3, 0, 4), Point(0, -2, 0));
  const Surface torus = SC::torus_surface(Point(0, 0, 0), FT(5), FT(3));
  const std::vector<Problem> problems{
      {SC::ellipse_curve<K>(Point(0, 0, 0), Vector(1, 0, 3), Vector(0, 1, 0)),
       SC::cylinder_surface(Point(0, 0, -2), FT(1), FT(4)), 2, -2, 2, 2},
      {SC::ellipse_curve<K>(Point(ratio(3, 2), 0, ratio(5, 2)), Vector(ratio(5, 2), 0, ratio(3, 2)), Vector(0, 2, 0)),
       SC::cone_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 3)), 2, 0, 3, 1},
      {villarceau, torus.restricted(0, 0, 2), 1, 0, 10, 1}};
  for (const Problem& problem : problems) {
    const auto pieces = SC::intersections(problem.curve, problem.surface);
    EXPECT_TRUE(pieces.is_complete()) << pieces.summary();
    EXPECT_EQ(pieces.count(Intersection_kind::OVERLAP), problem.overlaps);
    EXPECT_EQ(pieces.size(), problem.overlaps);
    int inside = 0;
    for (int k = 0; k <= 64; ++k) {
      const FT at = ratio(k, 16), height = problem.curve(at).cartesian(problem.axis);
      const bool is_inside = problem.lower <= height && height <= problem.upper;
      inside += is_inside;
      EXPECT_EQ(std::any_of(pieces.begin(), pieces.end(),
                            [&](const auto& piece) { return holds(piece.parameter_range(0), at); }),
                is_inside)
          << at;
    }
    EXPECT_GT(inside, 10);
  }
  // Off the surface by little, the curve meets it in points, if at all.
  const auto moved =
      villarceau.transformed(CGAL::Aff_transformation_3<K>(CGAL::TRANSLATION, Vector(0, ratio(1, 1000), 0)));
  EXPECT_EQ(SC::intersections(moved, torus).count(Intersection_kind::OVERLAP), 0u);
}

TEST(Surface_intersections, RaysMeetATorusInOrder)
{
  const Surface torus = SC::torus_surface(Point(0, 0, 0), FT(3), FT(1));
  const auto four = SC::intersections(K::Ray_3(Point(-10, -1, ratio(1, 3)), Vector(5, ratio(1, 2), 0)), torus);
  expect_kinds(four, 4);
  for (std::size_t i = 1; i < four.size(); ++i)
    EXPECT_LT(four[i - 1].parameter_range(0).second, four[i].parameter_range(0).first);
  expect_kinds(SC::intersections(K::Ray_3(Point(0, 0, ratio(1, 3)), Vector(-5, ratio(1, 2), 0)), torus), 2);
  expect_kinds(SC::intersections(Line(Point(0, 0, 0), Vector(0, 0, 1)), torus), 0);
}

TEST(Surface_intersections, CurveWeavesThroughABicubic)
{
  const std::vector<FT> zeros{ratio(1, 6), ratio(2, 6), ratio(3, 6), ratio(4, 6), ratio(5, 6)};
  const Curve curve = curve_above_graph(FT(40) * product_of_zeros(zeros));
  Random_source random(3);
  for (int round = 0; round < 4; ++round) {
    const auto map = round == 0 ? CGAL::Aff_transformation_3<K>(CGAL::IDENTITY) : random_map(random);
    const Surface surface = graph.transformed(map);
    const Curve moved = curve.transformed(map);
    const auto five = SC::intersections(moved, surface);
    expect_kinds(five, 5);
    ASSERT_EQ(five.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_TRUE(holds(five[i].parameter_range(0), zeros[i]) && holds(five[i].parameter_range(1, 0), zeros[i]) &&
                  holds(five[i].parameter_range(1, 1), FT(1 - zeros[i])));
    // Ends of the curve, an edge and a corner of the surface at common points.
    const auto ends = SC::intersections(moved.restricted(zeros[0], zeros[4]), surface);
    expect_kinds(ends, 3, 0, 2);
    EXPECT_TRUE(ends[0].is_at_end(0) && ends[4].is_at_end(0) && !ends[0].is_at_end(1));
    const auto edge = SC::intersections(surface.restricted(0, zeros[2], 1), moved);
    expect_kinds(edge, 2, 0, 1);
    EXPECT_TRUE(edge[0].is_at_end(0, 0) && !edge[0].is_at_end(0, 1) && !edge[0].is_at_end(1));
    const auto corner = SC::intersections(moved, surface.restricted(0, zeros[2], 1).restricted(1, zeros[2], 1));
    expect_kinds(corner, 0, 0, 1);
    EXPECT_TRUE(corner[0].is_at_end(1, 0) && corner[0].is_at_end(1, 1) &&
                holds(corner[0].parameter_range(0), zeros[2]));
  }
}

TEST(Surface_intersections, CurveTouchesABicubic)
{
  const auto touching =
      SC::intersections(curve_above_graph(product_of_zeros({ratio(1, 3), ratio(1, 3), ratio(2, 3)})), graph);
  expect_kinds(touching, 1, 1);
  EXPECT_EQ(touching[0].multiplicity(), 2);
  EXPECT_TRUE(holds(touching[0].parameter_range(0), ratio(1, 3)));
  const Function square = product_of_zeros({ratio(1, 3), ratio(1, 3)});
  expect_kinds(SC::intersections(curve_above_graph(square + FT(1e-40)), graph), 0);
  expect_kinds(SC::intersections(curve_above_graph(square - FT(1e-40)), graph), 2);
}

// Through the common point of a random curve and surface; nothing that is found changes under affine maps.
TEST(Surface_intersections, PlantedPoints)
{
  Random_geometry random(11);
  for (int round = 0; round < 12; ++round) {
    const bool is_rational = round % 3 == 0;
    const Surface surface({2, 2 + round % 2}, std::vector<FT>{0, 0, 0, ratio(1, 2), 1, 1, 1},
                          round % 2 == 0 ? std::vector<FT>{0, 0, 0, 1, 1, 1} : std::vector<FT>{0, 0, 0, 0, 1, 1, 1, 1},
                          random.points<K, 3>(12 + 4 * (round % 2)),
                          is_rational ? random.weights(12 + 4 * (round % 2)) : std::vector<FT>());
    Curve curve(3, {0, 0, 0, 0, 1, 1, 1, 1}, random.points<K, 3>(4));
    const FT a = round % 4 == 1 ? FT(1) : ratio(random.integer(1, 9), 10), b = ratio(random.integer(1, 9), 10),
             s = round % 4 == 2 ? FT(0) : ratio(random.integer(1, 9), 10);
    curve = curve.transformed(CGAL::Aff_transformation_3<K>(CGAL::TRANSLATION, surface(a, b) - curve(s)));
    const auto found = SC::intersections(curve, surface);
    ASSERT_TRUE(found.is_complete()) << round << ' ' << found.summary();
    EXPECT_EQ(std::count_if(found.begin(), found.end(),
                            [&](const auto& x) {
                              return holds(x.parameter_range(0), s) && holds(x.parameter_range(1, 0), a) &&
                                  holds(x.parameter_range(1, 1), b) && x.is_at_end(0) == (s == 0) &&
                                  x.is_at_end(1) == (a == 1);
                            }),
              1)
        << round;
    const auto map = random_map(random);
    const auto images = SC::intersections(surface.transformed(map), curve.transformed(map));
    EXPECT_EQ(images.size(), found.size());
    for (const Intersection_kind kind :
         {Intersection_kind::TRANSVERSAL, Intersection_kind::END_POINT, Intersection_kind::TANGENT})
      EXPECT_EQ(images.count(kind), found.count(kind)) << round;
    // The point, also off by little.
    const auto point = SC::intersections(curve(s), surface);
    EXPECT_TRUE(point.is_complete());
    EXPECT_EQ(std::count_if(point.begin(), point.end(),
                            [&](const auto& x) {
                              return holds(x.parameter_range(1, 0), a) && holds(x.parameter_range(1, 1), b);
                            }),
              1)
        << round;
    const auto off = SC::intersections(curve(s) + Vector(FT(1e-50), FT(2e-50), 0), surface);
    EXPECT_TRUE(off.is_complete() &&
                std::none_of(off.begin(), off.end(),
                             [&](const auto& x) {
                               return holds(x.parameter_range(1, 0), a) && holds(x.parameter_range(1, 1), b);
                             }))
        << round;
  }
}

TEST(Surface_intersections, PointsOnCurves)
{
  // (t^2 - 1, t^3 - t) for t in [-2,2] crosses itself at the origin.
  const Function s = t * FT(4) - FT(2);
  const auto nodal = SC::Bspline_curve_2<K>::from_homogeneous_coordinates({s * s - FT(1), s * s * s - s}, one);
  const auto node = SC::intersections(K::Point_2(0, 0), nodal);
  expect_kinds(node, 2);
  EXPECT_TRUE(holds(node[0].parameter_range(1), ratio(1, 4)) && holds(node[1].parameter_range(1), ratio(3, 4)));
  EXPECT_EQ(node[0].point(), K::Point_2(0, 0));
  expect_kinds(SC::intersections(nodal, K::Point_2(0, FT(1e-99))), 0);
  const auto circle = SC::circle_curve(K::Point_2(0, 0), FT(5));
  expect_kinds(SC::intersections(K::Point_2(5, 0), circle), 0, 0, 1);   // the seam
  expect_kinds(SC::intersections(K::Point_2(3, 4), circle), 1);
  expect_kinds(SC::intersections(K::Point_2(3, 4), K::Point_2(3, 4)), 1);
  expect_kinds(SC::intersections(K::Point_2(3, 4), K::Point_2(4, 3)), 0);
  // The point with the irrational parameter sqrt(1/2) of (t^2, t^4, t^2 + 1).
  const auto quartic = Curve::from_homogeneous_coordinates({t * t, t * t * t * t, t * t + FT(1)}, one);
  const auto irrational = SC::intersections(quartic, Point(ratio(1, 2), ratio(1, 4), ratio(3, 2)));
  expect_kinds(irrational, 1);
  EXPECT_NEAR(irrational[0].parameter(0), std::sqrt(0.5), 1e-15);
  expect_kinds(SC::intersections(quartic, Point(ratio(1, 2), ratio(1, 4), ratio(3, 2) + FT(1e-60))), 0);
}

TEST(Surface_intersections, ObjectsOfAKernel)
{
  const auto circle = SC::circle_curve(Point(0, 0, 0), Vector(0, 0, 1), Point(5, 0, 0));
  expect_kinds(SC::intersections(K::Plane_3(1, 0, 0, -3), circle), 2);
  expect_kinds(SC::intersections(circle, K::Plane_3(3, 4, 0, -25)), 0, 1);
  expect_kinds(SC::intersections(circle, K::Plane_3(3, 4, 0, -26)), 0);
  const auto inside = SC::intersections(K::Plane_3(0, 0, 1, 0), circle);
  expect_kinds(inside, 0, 0, 0, 1);
  EXPECT_EQ(inside[0].parameter_range(1), Range(0, 4));
  const auto quarter = SC::intersections(SC::plane_patch(Point(0, 0, 0), Vector(0, 6, 0), Vector(6, 0, 0)), circle);
  expect_kinds(quarter, 0, 0, 0, 1);
  EXPECT_EQ(quarter[0].parameter_range(1), Range(0, 1));

  expect_kinds(SC::intersections(K::Segment_3(Point(0, 0, 0), Point(2, 1, 3)), K::Sphere_3(Point(0, 0, 0), 3)), 1);
  expect_kinds(SC::intersections(K::Triangle_3(Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)),
                                 K::Segment_3(Point(1, 1, -1), Point(1, 1, 2))),
               1);
  expect_kinds(SC::intersections(K::Triangle_3(Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)),
                                 K::Line_3(Point(0, 0, 0), Point(1, 1, 2))),
               0, 0, 1);

  const auto plane_circle = SC::circle_curve(K::Point_2(0, 0), FT(5));
  const auto chord = SC::intersections(K::Line_2(K::Point_2(-7, 3), K::Point_2(-6, 3)), plane_circle);
  expect_kinds(chord, 2);
  EXPECT_LT(chord[0].parameter(0), chord[1].parameter(0));
  const auto ray = SC::intersections(K::Ray_2(K::Point_2(0, 3), K::Point_2(2, 3)), plane_circle);
  expect_kinds(ray, 1);
  EXPECT_TRUE(holds(ray[0].parameter_range(0), 2));
  expect_kinds(SC::intersections(K::Ray_2(K::Point_2(4, 3), K::Point_2(5, 3)), plane_circle), 0, 0, 1);
  expect_kinds(SC::intersections(K::Circle_2(K::Point_2(6, 0), 25), K::Segment_2(K::Point_2(3, 9), K::Point_2(3, 0))),
               1);
}

TEST(Surface_intersections, KernelOfLazyNumbers)
{
  using E = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto found =
      SC::intersections(E::Ray_3(E::Point_3(0, 0, 0), E::Vector_3(0, 0, 3)), E::Sphere_3(E::Point_3(0, 0, 0), 9));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].point(), E::Point_3(0, 0, 3));
}

TEST(Surface_intersections, BadInput)
{
  expect_invalid([&] { SC::intersections(Line(Point(0, 0, 0), Vector(0, 0, 0)), unit_sphere); }, "degenerate");
  expect_invalid([&] { SC::intersections(K::Plane_3(0, 0, 0, 1), unit_sphere.iso_curve(0, 1)); }, "degenerate");
  expect_invalid([&] { SC::intersections(Point(0, 0, 0), unit_sphere, {.tolerance = -1}); }, "tolerance");
  using D = Double_cartesian;
  expect_invalid([&] { SC::intersections(D::Point_3(0, 0, NAN), SC::sphere_surface(D::Point_3(0, 0, 0), 1.)); },
                 "finite");
}

} // namespace

} // namespace surface_intersections_test
