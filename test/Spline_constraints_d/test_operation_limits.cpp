// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits of time, and visitors that stop a run, of operations: a limit that is not reached changes no answer; one that
// is reached, or a stop, gives an incomplete answer that says why, and the visitor is asked only a few times more; it
// is told of the progress. One operation or more of intersections, curves on surfaces, distances, loci and features of
// curves.

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Evolute_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/bitangents_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_arcs_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_features_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/ray_traps_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/tangent_circles_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/distances/hausdorff_distance.h>
#include <CGAL/Spline_constraints_d/operations/intersections/contact_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/locus_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/pairwise_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>
#include <CGAL/Spline_constraints_d/operations/loci/alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/envelope_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/point_curve_bisector_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/self_bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/parabolic_lines.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/plane_sections.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/self_intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/umbilics.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace operation_limits_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Surface = SC::Bspline_surface_3<K>;

// Counts what it is asked and told, and stops the run from one of the questions on.
struct Watcher
{
  static constexpr std::size_t slow_questions = 8;

  std::size_t stops_at = (std::numeric_limits<std::size_t>::max)(), questions = 0, told = 0;
  bool is_slow = false; // so that there is something to tell at the next question

  void on_progress(double fraction)
  {
    ++told;
    EXPECT_TRUE(0 <= fraction && fraction <= 1);
  }

  bool stop()
  {
    if (is_slow && questions < slow_questions)
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
    return ++questions >= stops_at;
  }
};

// What all results have, and what this one has found.
struct Outcome
{
  bool is_complete;
  std::vector<SC::Undecided_part> undecided;
  SC::Summary summary;
  std::string found;
};

template <class Result>
Outcome outcome(const Result& result, const std::vector<std::size_t>& numbers)
{
  std::ostringstream found;
  for (const std::size_t number : numbers)
    found << number << ' ';
  return {result.is_complete(), result.undecided(), result.summary(), found.str()};
}

template <class Set>
Outcome outcome_of_curves(const Set& set)
{
  return outcome(
      set,
      {set.number_of_closed_curves(), set.number_of_open_curves(), set.points().size(), set.singular_points().size()});
}

struct Operation
{
  std::string name;
  std::function<Outcome(const SC::Solver_options&)> run;
};

Curve wave(double height)
{
  return Curve(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3},
               std::vector<Point>{{0, 0}, {1, height}, {2, -height}, {3, height}, {4, -height}, {5, 0}});
}

Curve loop()
{
  return Curve(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, std::vector<Point>{{0, 0}, {4, 3}, {2, 5}, {0, 3}, {4, 0}});
}

Surface hills(double height)
{
  std::vector<K::Point_3> points;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      points.emplace_back(i, j, (i + j) % 2 == 0 ? height : -height + 0.1 * i);
  const std::vector<double> knots{0, 0, 0, 0, 1, 2, 2, 2, 2};
  return Surface({3, 3}, knots, knots, points);
}

Surface board()
{
  return SC::bilinear_surface<K>(K::Point_3(0, 0, 0), K::Point_3(0, 4, 0.125), K::Point_3(4, 0, 0.25),
                                 K::Point_3(4, 4, 0.5));
}

Curve circle(double x, double y, double squared_radius)
{
  return SC::to_bspline_curve(K::Circle_2(Point(x, y), squared_radius));
}

std::vector<Operation> intersections()
{
  const auto count = [](const auto& set) {
    return outcome(set,
                   {set.size(), set.count(SC::Intersection_kind::TRANSVERSAL),
                    set.count(SC::Intersection_kind::TANGENT), set.count(SC::Intersection_kind::END_POINT)});
  };
  return {{"intersections",
           [=](const SC::Solver_options& options) { return count(SC::intersections(wave(3), wave(-2), options)); }},
          {"self_intersections",
           [=](const SC::Solver_options& options) { return count(SC::self_intersections(loop(), options)); }},
          {"pairwise_intersections",
           [](const SC::Solver_options& options) {
             const auto set = SC::pairwise_intersections(std::vector{wave(3), wave(-2), loop()}, options);
             return outcome(set, {set.pairs().size()});
           }},
          {"contact_points",
           [=](const SC::Solver_options& options) {
             return count(
                 SC::contact_points(hills(1), K::Plane_3(K::Point_3(0, 0, 0.5), K::Vector_3(0, 0, 1)), options));
           }},
          {"intersections with an offset",
           [=](const SC::Solver_options& options) {
             return count(SC::intersections(SC::Offset_curve_2(wave(1), 0.25), wave(-2), options));
           }},
          {"intersection_curves",
           [](const SC::Solver_options& options) {
             return outcome_of_curves(SC::intersection_curves(hills(1), board(), options));
           }},
          {"self_intersection_curves", [](const SC::Solver_options& options) {
             return outcome_of_curves(SC::self_intersection_curves(hills(2), options));
           }}};
}

std::vector<Operation> surface_curves()
{
  return {
      {"silhouettes",
       [](const SC::Solver_options& options) {
         return outcome_of_curves(SC::silhouettes(hills(1), K::Vector_3(1, 2, 0.5), options));
       }},
      {"parabolic_lines",
       [](const SC::Solver_options& options) { return outcome_of_curves(SC::parabolic_lines(hills(1), options)); }},
      {"plane_sections",
       [](const SC::Solver_options& options) {
         return outcome_of_curves(
             SC::plane_sections(hills(1), K::Vector_3(0, 0, 1), std::vector<double>{0.125}, options).front());
       }},
      {"sweep_silhouettes",
       [](const SC::Solver_options& options) {
         const SC::Affine_motion<K> motion{SC::bezier_curve(std::vector<K::Point_3>{{0, 0, 0}, {1, 0, 1}, {2, 1, 0}})};
         return outcome_of_curves(SC::sweep_silhouettes(SC::sphere_surface<K>(K::Point_3(0, 0, 0), 1), motion,
                                                        std::vector<K::Point_3>{{9, 8, 7}}, options)
                                      .front());
       }},
      {"accessibility_boundaries",
       [](const SC::Solver_options& options) {
         return outcome_of_curves(
             SC::accessibility_boundaries(hills(0.25), K::Sphere_3(K::Point_3(2, 2, 3), 1), {}, options));
       }},
      {"umbilics", [](const SC::Solver_options& options) {
         const auto set = SC::umbilics(hills(1), options);
         return outcome(set, {set.points().size()});
       }}};
}

std::vector<Operation> distances()
{
  return {{"closest_points",
           [](const SC::Solver_options& options) {
             const auto set = SC::closest_points(wave(3), circle(2, 9, 1), options);
             return outcome(set, {set.size(), set.is_unique()});
           }},
          {"projections",
           [](const SC::Solver_options& options) {
             const auto set = SC::projections(Point(1, 1), wave(3), options);
             return outcome(set, {set.feet().size()});
           }},
          {"hausdorff_distance", [](const SC::Solver_options& options) {
             const auto distance = SC::hausdorff_distance(wave(3), wave(2), 1e-8, options);
             EXPECT_LE(distance.distance_range().first, distance.distance_range().second);
             return outcome(distance, {distance.curve()});
           }}};
}

std::vector<Operation> loci()
{
  const Curve a = SC::bezier_curve(std::vector<Point>{{-3, 3}, {-1, -5}, {1, 5}, {3, -1}}),
              b = SC::bezier_curve(std::vector<Point>{{-3, -3}, {0, -1}, {1, -5}, {4, -3}});
  return {
      {"bisector_curves",
       [=](const SC::Solver_options& options) { return outcome_of_curves(SC::bisector_curves(a, b, options)); }},
      {"alpha_sectors",
       [=](const SC::Solver_options& options) { return outcome_of_curves(SC::alpha_sectors(a, b, 0.25, options)); }},
      {"envelope_curves",
       [=](const SC::Solver_options& options) {
         return outcome_of_curves(SC::envelope_curves(a, b, SC::Tangent_directions::ANY, options));
       }},
      {"self_bisector_curves",
       [=](const SC::Solver_options& options) { return outcome_of_curves(SC::self_bisector_curves(a, options)); }},
      {"point_curve_bisector", [=](const SC::Solver_options& options) {
         const auto bisector = SC::point_curve_bisector(Point(1, 4), a, 0x1p-10, options);
         return outcome(bisector, {bisector.curves().size(), bisector.poles().size()});
       }}};
}

std::vector<Operation> curve_features()
{
  const auto size = [](const auto& list) { return outcome(list, {list.size()}); };
  return {{"bitangents", [=](const SC::Solver_options& options) { return size(SC::bitangents(wave(3), options)); }},
          {"inflections", [=](const SC::Solver_options& options) { return size(SC::inflections(wave(3), options)); }},
          {"curvature_extremes",
           [=](const SC::Solver_options& options) { return size(SC::curvature_extremes(wave(3), options)); }},
          {"extreme_points",
           [=](const SC::Solver_options& options) {
             return size(SC::extreme_points(wave(3), K::Vector_2(1, 2), options));
           }},
          {"tangent_circles",
           [=](const SC::Solver_options& options) {
             return size(SC::tangent_circles(SC::segment_curve(Point(0, 0), Point(9, 1)),
                                             SC::segment_curve(Point(0, 5), Point(9, 6)),
                                             SC::segment_curve(Point(-1, 0), Point(-2, 6)), options));
           }},
          {"ray_traps",
           [=](const SC::Solver_options& options) {
             return size(SC::ray_traps(std::vector{circle(0, 0, 1), circle(5, 1, 2)}, options));
           }},
          {"offset_arcs",
           [](const SC::Solver_options& options) {
             const auto set = SC::offset_arcs(SC::Offset_curve_2(wave(1), 0.5), 1e-2, options);
             return outcome(set, {set.arcs().size(), set.cusps().size()});
           }},
          {"self-intersections of an offset", [=](const SC::Solver_options& options) {
             return size(SC::self_intersections(SC::Offset_curve_2(wave(2), 0.5), options));
           }}};
}

constexpr std::size_t few = 128; // of thousands

void expect_incomplete(const Outcome& result, SC::Undecided_reason reason)
{
  EXPECT_FALSE(result.is_complete);
  EXPECT_FALSE(result.summary.is_complete);
  ASSERT_FALSE(result.undecided.empty());
  bool says_why = false;
  for (const SC::Undecided_part& part : result.undecided) {
    EXPECT_FALSE(part.reason.empty());
    says_why = says_why || part.reason == SC::internal::in_words(reason);
    for (const SC::Undecided_part::Range& range : part.place)
      EXPECT_LE(range.first, range.second) << part;
    for (const SC::Undecided_part::Parameters& operand : part.parameters)
      for (const SC::Undecided_part::Range& range : operand.ranges)
        EXPECT_LE(range.first, range.second) << part;
  }
  EXPECT_TRUE(says_why) << result.undecided.front();
}

void check(const std::vector<Operation>& operations)
{
  for (const Operation& operation : operations) {
    SCOPED_TRACE("name: " + operation.name);
    const SC::Solver_options plain{.tolerance = 1e-6};
    const Outcome expected = operation.run(plain);

    Watcher watcher{.is_slow = true};
    SC::Solver_options generous = plain;
    generous.time_limit = 1e5;
    generous.visitor = watcher;
    const Outcome same = operation.run(generous);
    EXPECT_EQ(same.found, expected.found);
    EXPECT_EQ(same.is_complete, expected.is_complete);
    EXPECT_EQ(same.undecided.size(), expected.undecided.size());
    EXPECT_EQ(same.is_complete, same.undecided.empty());
    ASSERT_GT(watcher.questions, 0u) << operation.name;
    EXPECT_TRUE(watcher.told > 0 || watcher.questions <= Watcher::slow_questions);

    SC::Solver_options short_time = plain;
    short_time.time_limit = 1e-9;
    expect_incomplete(operation.run(short_time), SC::Undecided_reason::TIME);

    for (const std::size_t stop : {std::size_t(1), watcher.questions / 4 + 1, watcher.questions / 2 + 1}) {
      SCOPED_TRACE("name: stop at " + std::to_string(stop));
      Watcher stopping{.stops_at = stop};
      SC::Solver_options stopped = plain;
      stopped.visitor = stopping;
      const Outcome result = operation.run(stopped);
      EXPECT_LE(stopping.questions, stop + few);
      if (stop == 1)
        expect_incomplete(result, SC::Undecided_reason::STOPPED);
      else
        EXPECT_EQ(result.is_complete, result.undecided.empty());
    }
  }
}

TEST(Operation_limits, intersections) { check(intersections()); }
TEST(Operation_limits, surface_curves) { check(surface_curves()); }
TEST(Operation_limits, distances) { check(distances()); }
TEST(Operation_limits, loci) { check(loci()); }
TEST(Operation_limits, curve_features) { check(curve_features()); }

// Of a collection in which each two curves meet in one point.
std::vector<Curve> grid(int lines)
{
  std::vector<Curve> result;
  for (int i = 0; i < lines; ++i) {
    result.push_back(SC::segment_curve(Point(i, -1), Point(i, lines)));
    result.push_back(SC::segment_curve(Point(-1, i), Point(lines, i)));
  }
  return result;
}

// Pairs that are left at a stop are told of by one part for each curve, and cost no questions.
TEST(Operation_limits, pairs_are_left_at_a_stop)
{
  constexpr int lines = 12;
  const std::vector<Curve> curves = grid(lines);
  Watcher watcher;
  const auto all = SC::pairwise_intersections(curves, {.visitor = watcher});
  ASSERT_EQ(all.pairs().size(), static_cast<std::size_t>(lines * lines));
  EXPECT_TRUE(all.is_complete());
  for (const std::size_t stop : {std::size_t(1), watcher.questions / 2}) {
    Watcher stopping{.stops_at = stop};
    const auto some = SC::pairwise_intersections(curves, {.visitor = stopping});
    EXPECT_LE(stopping.questions, stop + 1);   // the system in hand, and the operation
    expect_incomplete(outcome(some, {}), SC::Undecided_reason::STOPPED);
    EXPECT_LT(some.pairs().size(), all.pairs().size());
    EXPECT_EQ(some.pairs().empty(), stop == 1);
    for (std::size_t i = 0; i < some.pairs().size(); ++i) {   // those before the stop
      EXPECT_EQ(some.pairs()[i].first, all.pairs()[i].first);
      EXPECT_EQ(some.pairs()[i].second, all.pairs()[i].second);
    }
    const auto undecided = some.undecided();
    EXPECT_LE(undecided.size(), curves.size());
    for (std::size_t i = some.pairs().size(); i < all.pairs().size(); ++i) {   // in a part each
      const auto point = all.pairs()[i].intersections[0].point();
      EXPECT_TRUE(std::any_of(undecided.begin(), undecided.end(), [&](const SC::Undecided_part& part) {
        return part.parameters[0].operand == all.pairs()[i].first && part.place[0].first <= point.x() &&
               point.x() <= part.place[0].second && part.place[1].first <= point.y() &&
               point.y() <= part.place[1].second;
      }));
    }
  }
}

TEST(Operation_limits, pairs_are_left_where_there_are_no_nodes)
{
  const std::vector<Curve> curves = grid(12);
  const auto all = SC::pairwise_intersections(curves);
  const auto some = SC::pairwise_intersections(curves, {.node_limit = all.summary().nodes / 2});
  expect_incomplete(outcome(some, {}), SC::Undecided_reason::NODES);
  EXPECT_GT(some.pairs().size(), 0u);
  EXPECT_LT(some.pairs().size(), all.pairs().size());
  EXPECT_LT(some.summary().nodes, all.summary().nodes);
}

// A spiral that goes to and fro over itself, of many pieces.
Curve scribble(int pieces)
{
  std::vector<Point> points;
  for (int i = 0; i < pieces + 3; ++i)
    points.emplace_back(i % 7, (i * i) % 11);
  std::vector<double> knots(4, 0);
  for (int i = 1; i < pieces; ++i)
    knots.push_back(i);
  knots.insert(knots.end(), 4, pieces);
  return Curve(3, knots, points);
}

// Pairs of arcs that are left are told of by one part for each arc: there are many times more of them.
TEST(Operation_limits, arcs_of_a_curve_are_left_at_a_stop)
{
  const Curve curve = scribble(24);
  Watcher watcher;
  const auto all = SC::self_intersections(curve, {.visitor = watcher});
  ASSERT_GT(all.size(), 24u);
  EXPECT_TRUE(all.is_complete());
  constexpr std::size_t most_arcs = 24 * 10;
  for (std::size_t part = 0; part < 8; ++part) {
    Watcher stopping{.stops_at = part * watcher.questions / 8 + 1};
    const auto some = SC::self_intersections(curve, {.visitor = stopping});
    EXPECT_LE(stopping.questions, stopping.stops_at + 1);
    expect_incomplete(outcome(some, {}), SC::Undecided_reason::STOPPED);
    EXPECT_LE(some.count(SC::Intersection_kind::UNDECIDED), most_arcs);
    for (const auto& x : all) {
      const auto holds = [&](const auto& y) {
        return y.parameter_range(0).first <= x.parameter_range(0).second &&
               x.parameter_range(0).first <= y.parameter_range(0).second &&
               y.parameter_range(1).first <= x.parameter_range(1).second &&
               x.parameter_range(1).first <= y.parameter_range(1).second;
      };
      EXPECT_TRUE(std::any_of(some.begin(), some.end(), holds));   // found, or undecided
    }
  }
  SC::Solver_options few_nodes{.node_limit = all.summary().nodes / 2};
  const auto some = SC::self_intersections(curve, few_nodes);
  expect_incomplete(outcome(some, {}), SC::Undecided_reason::NODES);
  EXPECT_LE(some.count(SC::Intersection_kind::UNDECIDED), most_arcs);
}

// A run that has ended keeps the bounds of the distance.
TEST(Operation_limits, closest_points_are_within_bounds_at_a_stop)
{
  const Surface a = hills(1), b = SC::sphere_surface<K>(K::Point_3(2, 2, 4), 1);
  Watcher watcher;
  const auto all = SC::closest_points(a, b, {.visitor = watcher});
  const auto [least, most] = all.distance_range();
  for (std::size_t part = 0; part < 8; ++part) {
    Watcher stopping{.stops_at = part * watcher.questions / 8 + 1};
    const auto some = SC::closest_points(a, b, {.visitor = stopping});
    EXPECT_LE(stopping.questions, stopping.stops_at + 1);
    EXPECT_FALSE(some.is_complete());
    EXPECT_LE(some.distance_range().first, most);
    EXPECT_LE(least, some.distance_range().second);
  }
}

// Two formulas of ten thousand cells: that they are written out is a part of the run.
TEST(Operation_limits, formulas_with_many_cells_are_asked_about)
{
  const SC::Spline_map<1, 2> a(scribble(100)), b(scribble(99));
  const auto [u, v] = SC::parameters(a, b);
  const SC::Constraint constraint = a(u)[0] * b(v)[1] == 0;
  std::size_t questions = 0;
  const SC::Spline_function all = constraint.spline_function([&] { ++questions; });
  EXPECT_GT(questions, 4u);
  EXPECT_EQ(all.terms(), constraint.spline_function().terms());
  struct Stop
  {};
  const std::size_t stop = questions / 2;
  questions = 0;
  EXPECT_THROW(constraint.spline_function([&] {
    if (++questions == stop)
      throw Stop();
  }),
               Stop);
  EXPECT_EQ(questions, stop);
}

} // namespace operation_limits_test
