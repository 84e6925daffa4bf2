// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits and visitors of operations on regions: an answer that was not finished says so, and where; after a visitor
// wants to stop, it is asked only few times more; limits that are not reached do not change an answer.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>
#include <CGAL/Spline_constraints_d/operations/joints/exact_joints_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace region_limits_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;

namespace {

// Stops a run from some question on.
struct Counting_visitor
{
  std::size_t questions_before_stop = std::numeric_limits<std::size_t>::max();
  std::size_t questions = 0, reports = 0;
  double greatest_progress = 0;

  void on_progress(double share)
  {
    ++reports;
    EXPECT_GE(share, greatest_progress);
    EXPECT_LE(share, 1);
    greatest_progress = share;
  }

  bool stop() { return ++questions > questions_before_stop; }
};

// A smooth closed curve around the origin, of so many pieces.
Curve wavy_outline(int pieces, double radius, double depth, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> wave(-depth, depth);
  std::vector<double> knots;
  std::vector<Point> points;
  for (int i = 0; i <= pieces; ++i)
    knots.push_back(i);
  for (int i = 0; i < pieces; ++i) {
    const double angle = 2 * CGAL_PI * i / pieces, distance = radius + wave(random);
    const auto rounded = [](double x) { return std::round(1024 * x) / 1024; };
    points.emplace_back(rounded(distance * std::cos(angle)), rounded(distance * std::sin(angle)));
  }
  return Curve::from_periodic(3, knots, points);
}

// Walls of rooms that nearly end on each other.
std::vector<Curve> walls()
{
  std::vector<Curve> result;
  for (int i = 0; i < 8; ++i) {
    const double x = 4 * i;
    result.push_back(SC::bezier_curve<K>({Point(x, 0), Point(x + 3.875, 0)}));
    result.push_back(SC::bezier_curve<K>({Point(x + 1, 0.125), Point(x + 1, 5)}));
    result.push_back(SC::bezier_curve<K>({Point(x, 5.25), Point(x + 2, 6), Point(x + 4, 5.125)}));
  }
  return result;
}

// What all results have in common.
struct Answer
{
  bool is_complete;
  std::vector<SC::Undecided_part> undecided;
  SC::Summary summary;
  std::string text; // what was found
};

template <class Result>
Answer answer(const Result& result, const std::string& text)
{
  return {result.is_complete(), result.undecided(), result.summary(), text};
}

template <class Result>
std::string text_of_edges(const Result& result)
{
  std::string text;
  for (const auto& edge : result.edges())
    text += std::to_string(static_cast<int>(edge.kind)) + ' ';
  return text + std::to_string(result.is_complete() ? SC::to_nearest_double(result.area().first) : 0);
}

std::string text_of_boundaries(const SC::Minkowski_sum_2<K>& sum)
{
  std::string text;
  for (const auto& boundary : sum.boundaries()) {
    text += boundary.is_hole ? "hole: " : "outer: ";
    for (const auto& arc : boundary.arcs)
      for (const auto& [begin, end] : arc.parameters)
        text += std::to_string(begin) + ' ' + std::to_string(end) + ' ';
  }
  return text;
}

struct Operation
{
  std::string name;
  std::function<Answer(const SC::Solver_options&)> run;
};

std::vector<Operation> operations()
{
  const Curve outline = wavy_outline(12, 4, 0.5, 1), other = wavy_outline(8, 2, 0.25, 2),
              flat = wavy_outline(10, 6, 0.01, 4);
  const auto region = SC::planar_region(outline), small = SC::planar_region(other);
  const std::vector<Curve> crossing{outline, other.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, {3, 1}))};
  return {{"planar_region",
           [=](const auto& options) {
             const auto result = SC::planar_region(outline, options);
             return answer(result, result.is_complete() ? std::to_string(result.boundaries().size()) : "");
           }},
          {"minkowski_sum",
           [=](const auto& options) {
             const auto result = SC::minkowski_sum(region, small, options);
             return answer(result, text_of_boundaries(result));
           }},
          {"swept_area",
           [=](const auto& options) {
             const auto result = SC::swept_area(small, outline, options);
             return answer(result, text_of_boundaries(result));
           }},
          {"swept_area of a curve",
           [=](const auto& options) {
             const auto result = SC::swept_area(other, flat, options);
             return answer(result, text_of_boundaries(result));
           }},
          {"convex_hull",
           [=](const auto& options) {
             const auto result = SC::convex_hull(crossing, {Point(9, 9)}, options);
             return answer(result, text_of_edges(result));
           }},
          {"with_exact_joints",
       [=](const auto& options) {
         const auto result = SC::with_exact_joints<Exact>(walls(), 0.5, 0.1, options);
         return answer(result, std::to_string(result.joints) + ' ' + std::to_string(result.displacement));
       }},
      {"visible_part",
           [=](const auto& options) {
             const auto result = SC::visible_part(Point(0.125, 0.25), crossing, options);
             return answer(result, text_of_edges(result));
           }},
          {"region_kernel", [=](const auto& options) {
             const auto result = SC::region_kernel(flat, options);
             return answer(result, text_of_edges(result));
           }}};
}

void expect_incomplete(const Answer& answer, SC::Undecided_reason reason)
{
  EXPECT_FALSE(answer.is_complete);
  EXPECT_FALSE(answer.summary.is_complete);
  EXPECT_EQ(answer.summary.why_not, reason);
  ASSERT_FALSE(answer.undecided.empty());
  for (const SC::Undecided_part& part : answer.undecided) {
    EXPECT_EQ(part.place.size(), 2U);
    for (const auto& [lower, upper] : part.place)
      EXPECT_LE(lower, upper);
    EXPECT_FALSE(part.reason.empty());
  }
}

} // namespace

TEST(region_limits_2, generous_limits_change_nothing)
{
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    Counting_visitor visitor;
    const Answer free = operation.run({}),
                 limited = operation.run({.time_limit = 1e6, .node_limit = 100000000, .visitor = visitor});
    EXPECT_TRUE(free.is_complete);
    EXPECT_TRUE(limited.is_complete);
    EXPECT_TRUE(free.undecided.empty());
    EXPECT_TRUE(free.summary.is_complete);
    EXPECT_EQ(free.summary.nodes, limited.summary.nodes);
    EXPECT_EQ(free.text, limited.text);
    EXPECT_GT(visitor.questions, 0U);
    EXPECT_GT(free.summary.nodes, 0U);
    EXPECT_GT(free.summary.seconds, 0);
  }
}

TEST(region_limits_2, no_time)
{
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    expect_incomplete(operation.run({.time_limit = 1e-9}), SC::Undecided_reason::TIME);
  }
}

TEST(region_limits_2, few_nodes)
{
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    expect_incomplete(operation.run({.node_limit = 2}), SC::Undecided_reason::NODES);
  }
}

// From each of many questions on. What happens between two of these is not long, and once a run is to stop there are
// only few.
TEST(region_limits_2, stop)
{
  constexpr std::size_t most_questions_after_stop = 100, stops = 12;
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    Counting_visitor all;
    operation.run({.visitor = all});
    ASSERT_GT(all.questions, 1U);
    for (std::size_t k = 0; k < stops; ++k) {
      Counting_visitor visitor;
      visitor.questions_before_stop = k * (all.questions - 1) / stops;
      expect_incomplete(operation.run({.visitor = visitor}), SC::Undecided_reason::STOPPED);
      EXPECT_GT(visitor.questions, visitor.questions_before_stop);
      EXPECT_LE(visitor.questions, visitor.questions_before_stop + most_questions_after_stop);
    }
  }
}

// A sum that is stopped while it is told which arcs are inside of it has some of its boundary already.
TEST(region_limits_2, parts_of_a_sum)
{
  const auto region = SC::planar_region(wavy_outline(12, 4, 0.5, 1)),
             small = SC::planar_region(wavy_outline(8, 2, 0.25, 2));
  Counting_visitor all;
  const auto sum = SC::minkowski_sum(region, small, {.visitor = all});
  ASSERT_TRUE(sum.is_complete());
  bool has_parts = false;
  for (std::size_t k = 1; k < all.questions && !has_parts; k *= 2) {
    Counting_visitor visitor;
    visitor.questions_before_stop = all.questions - k;
    const auto part = SC::minkowski_sum(region, small, {.visitor = visitor});
    has_parts = !part.is_complete() && !part.boundaries().empty();
    if (has_parts) {
      EXPECT_FALSE(part.undecided().front().parameters.empty());
      for (const auto& boundary : part.boundaries())
        EXPECT_FALSE(boundary.arcs.empty());
    }
  }
  EXPECT_TRUE(has_parts);
  const auto none = SC::minkowski_sum(region, small, {.time_limit = 1e-9});
  EXPECT_TRUE(none.boundaries().empty());
  EXPECT_TRUE(none.polygons_with_holes(0.1).empty());
  // the box is around the whole sum
  const auto box = sum.polygons_with_holes(0.01).front().outer_boundary().bbox();
  EXPECT_LE(none.undecided().front().place[0].first, box.xmin());
  EXPECT_GE(none.undecided().front().place[1].second, box.ymax());
}

// The interior does not depend on the boundaries.
TEST(region_limits_2, interior_without_boundaries)
{
  const auto disk = SC::planar_region(SC::circle_curve(Point(0, 0), 1.0));
  Counting_visitor all;
  SC::minkowski_sum(disk, disk, {.visitor = all});
  Counting_visitor visitor;
  visitor.questions_before_stop = all.questions / 2;
  const auto sum = SC::minkowski_sum(disk, disk, {.visitor = visitor});
  EXPECT_FALSE(sum.is_complete());
  EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(Point(1.5, 0.25))));
  EXPECT_TRUE(CGAL::certainly_not(sum.has_in_interior(Point(1.5, 1.75))));
}

// An answer about a region that is not complete is undecided itself, and names its curves.
TEST(region_limits_2, operands_that_are_not_decided)
{
  const auto outline = wavy_outline(12, 4, 0.5, 1);
  const auto whole = SC::planar_region(outline), none = SC::planar_region(outline, {.time_limit = 1e-9});
  ASSERT_TRUE(whole.is_complete());
  ASSERT_FALSE(none.is_complete());
  const auto expect_curve = [](const auto& result, std::size_t operand) {
    EXPECT_FALSE(result.is_complete());
    EXPECT_FALSE(result.summary().is_complete);
    EXPECT_EQ(result.summary().why_not, SC::Undecided_reason::TIME);
    ASSERT_EQ(result.undecided().size(), 1U);
    const SC::Undecided_part& part = result.undecided().front();
    EXPECT_EQ(part.reason, "time limit");
    ASSERT_EQ(part.parameters.size(), 1U);
    EXPECT_EQ(part.parameters.front().operand, operand);
    EXPECT_LT(part.parameters.front().ranges.front().first, part.parameters.front().ranges.front().second);
  };
  expect_curve(SC::medial_axis(none), 0);
  expect_curve(SC::trimmed_offset(none, 0.25), 0);
  expect_curve(SC::minkowski_sum(none, whole), 0);
  const auto sum = SC::minkowski_sum(whole, none);
  expect_curve(sum, 1);
  EXPECT_TRUE(sum.boundaries().empty());
  EXPECT_TRUE(sum.polygons_with_holes(0.1).empty());
  EXPECT_FALSE(CGAL::is_certain(sum.has_in_interior(Point(0, 0))));
  const auto box = SC::minkowski_sum(whole, whole).polygons_with_holes(0.01).front().outer_boundary().bbox();
  for (int k = 0; k < 2; ++k) {   // around the whole sum
    EXPECT_LE(sum.undecided().front().place[k].first, box.min(k));
    EXPECT_GE(sum.undecided().front().place[k].second, box.max(k));
  }
  expect_curve(SC::swept_area(none, SC::segment_curve(Point(0, 0), Point(3, 1))), 0);
  expect_curve(SC::region_distance(none, whole), 0);
  const auto distance = SC::region_distance(whole, none);
  expect_curve(distance, 1);
  EXPECT_EQ(distance.squared_distance_range().first, 0);
  EXPECT_GT(distance.squared_distance_range().second, 0);
  EXPECT_FALSE(CGAL::is_certain(distance.do_meet()));
  EXPECT_FALSE(SC::region_kernel(none).is_complete());
}

// There is no region before it is proved to be one.
TEST(region_limits_2, regions_that_are_not_decided)
{
  const auto region = SC::planar_region(wavy_outline(12, 4, 0.5, 1), {.time_limit = 1e-9});
  EXPECT_FALSE(region.is_complete());
  EXPECT_EQ(region.curves().size(), 1U);
  EXPECT_THROW(region.boundaries(), SC::Invalid_input);
  EXPECT_THROW(region.area(), SC::Invalid_input);
  EXPECT_THROW(region.bounded_side(Point(0, 0)), SC::Invalid_input);
  EXPECT_TRUE(SC::planar_region(wavy_outline(12, 4, 0.5, 1)).is_complete());
}

TEST(region_limits_2, options_without_sense)
{
  const auto region = SC::planar_region(wavy_outline(5, 4, 0.5, 1));
  EXPECT_THROW(SC::minkowski_sum(region, region, {.time_limit = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::region_kernel(region, {.tolerance = 0}), SC::Invalid_input);
  EXPECT_THROW(SC::convex_hull(wavy_outline(5, 4, 0.5, 1), {.time_limit = -1}), SC::Invalid_input);
}

TEST(region_limits_2, progress)
{
  Counting_visitor visitor;
  const auto sum = SC::minkowski_sum(SC::planar_region(wavy_outline(40, 8, 0.5, 1)),
                                     SC::planar_region(wavy_outline(30, 2, 0.25, 2)), {.visitor = visitor});
  EXPECT_TRUE(sum.is_complete());
  EXPECT_GT(visitor.reports, 0U);
  EXPECT_GT(visitor.greatest_progress, 0);
}

} // namespace region_limits_2_test
