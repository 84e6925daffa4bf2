// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits and visitors of Voronoi diagrams, medial axes, trimmed bisectors, sectors and offsets: they end the search
// where they say, what is there then is a part of the whole answer, and what is not is said to be undecided, with the
// reason. Limits that are not reached change nothing.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <list>
#include <ranges>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace voronoi_limits_2_test {

namespace {

using Offset = SC::Trimmed_offset_2<K>;

// Stops the search when it is asked for the n-th time.
class Stop_at_question
{
  std::size_t m_first;

public:
  std::size_t questions = 0;

  explicit Stop_at_question(std::size_t first) : m_first(first) {}

  void on_progress(double) {}
  bool stop() { return ++questions >= m_first; }
};

// Waves next to each other, which cross a circle.
Curves waves()
{
  Curves result;
  for (int i = 0; i < 4; ++i)
    result.push_back(bezier({P(0, 2 * i), P(3, 2 * i + 3), P(5, 2 * i - 2), P(8, 2 * i + 1)}));
  result.push_back(SC::circle_curve(P(4, 3.25), 2.));
  return result;
}

Curves rooms()
{
  return {SC::polyline_curve(std::vector<P>{{0, 0}, {9, 0}, {9, 5}, {4, 6}, {0, 5}, {0, 0}}),
          SC::circle_curve(P(3, 2.5), 1.), bezier({P(6, 2), P(8, 1), P(8, 5), P(6, 2)})};
}

template <class Result>
void expect_undecided(const Result& result, SC::Undecided_reason reason, const std::string& words)
{
  EXPECT_FALSE(result.is_complete());
  EXPECT_FALSE(result.summary().is_complete);
  EXPECT_EQ(result.summary().why_not, reason);
  EXPECT_TRUE(std::ranges::any_of(result.undecided(),
                                  [&](const SC::Undecided_part& part) { return part.reason == words; }));
}

// All operands, each once, with all of its parameters.
template <class Result>
void expect_all_undecided(const Result& result, const std::vector<std::vector<SC::Undecided_part::Range>>& domains)
{
  expect_undecided(result, SC::Undecided_reason::TIME, "time limit");
  ASSERT_EQ(result.undecided().size(), domains.size());
  for (std::size_t i = 0; i < domains.size(); ++i) {
    ASSERT_EQ(result.undecided()[i].parameters.size(), 1U);
    EXPECT_EQ(result.undecided()[i].parameters[0].operand, i);
    EXPECT_EQ(result.undecided()[i].parameters[0].ranges, domains[i]);
    EXPECT_EQ(result.undecided()[i].reason, "time limit");
  }
}

bool are_equal(const SC::Voronoi_edge_2& a, const SC::Voronoi_edge_2& b)
{
  return a.sites == b.sites && a.parameters == b.parameters;
}

bool has_edge(const Diagram& diagram, const SC::Voronoi_edge_2& edge)
{
  return std::ranges::any_of(diagram.edges(), [&](const auto& other) { return are_equal(edge, other); });
}

// What is proved is there in the whole diagram. Returns the number of edges.
std::size_t expect_part(const Diagram& part, const Diagram& whole)
{
  std::size_t result = 0;
  if (part.sites().empty())
    return result;
  EXPECT_EQ(part.sites().size(), whole.sites().size());
  for (const auto& edge : part.edges())
    if (part.vertices()[edge.vertices[0]].is_resolved && part.vertices()[edge.vertices[1]].is_resolved) {
      ++result;
      EXPECT_TRUE(has_edge(whole, edge));
    }
  return result;
}

void expect_equal(const Diagram& a, const Diagram& b)
{
  EXPECT_EQ(a.is_complete(), b.is_complete());
  EXPECT_EQ(a.summary().nodes, b.summary().nodes);
  ASSERT_EQ(a.edges().size(), b.edges().size());
  ASSERT_EQ(a.vertices().size(), b.vertices().size());
  for (std::size_t i = 0; i < a.edges().size(); ++i)
    EXPECT_TRUE(are_equal(a.edges()[i], b.edges()[i]) && a.edges()[i].vertices == b.edges()[i].vertices);
  for (std::size_t i = 0; i < a.vertices().size(); ++i)
    EXPECT_TRUE(a.vertices()[i].point == b.vertices()[i].point && a.vertices()[i].edges == b.vertices()[i].edges);
}

const SC::Solver_options no_time{.time_limit = 1e-9};

} // namespace

// Nothing is found without time, and nothing is claimed.
TEST(VoronoiLimits, TinyTimeLimit)
{
  const Diagram diagram = SC::voronoi_diagram(waves(), {P(1, 9)}, no_time);
  expect_all_undecided(diagram, {{{0, 1}}, {{0, 1}}, {{0, 1}}, {{0, 1}}, {{0, 4}}, {}});
  EXPECT_TRUE(diagram.sites().empty() && diagram.edges().empty() && diagram.vertices().empty());
  EXPECT_TRUE(diagram.nearest_sites(P(0, 0)).empty());
  EXPECT_TRUE(diagram.sites_of_curve(0).empty());
  EXPECT_FALSE(diagram.cell(std::vector<std::size_t>()).is_complete);
  EXPECT_THROW(diagram.cell(0), SC::Invalid_input);
  EXPECT_THROW(diagram.polyline(0, 0.1), SC::Invalid_input);

  const auto region = SC::planar_region(rooms());
  expect_all_undecided(SC::medial_axis(region, no_time), {{{0, 5}}, {{0, 4}}, {{0, 1}}});
  expect_all_undecided(SC::trimmed_offset(region, -0.1, no_time), {{{0, 5}}, {{0, 4}}, {{0, 1}}});

  const Offset offset = SC::trimmed_offset(waves(), 0.1, {}, no_time);
  expect_all_undecided(offset, {{{0, 1}}, {{0, 1}}, {{0, 1}}, {{0, 1}}, {{0, 4}}});
  EXPECT_TRUE(offset.boundaries().empty() && offset.polygons_with_holes(0.1).empty());
  EXPECT_THROW(offset.polyline(0, 0.1), SC::Invalid_input);
}

TEST(VoronoiLimits, TinyTimeLimitOfPairs)
{
  const Curve a = waves()[0], b = waves()[4];
  const P p(3, 9), q(4, 8);
  using Ranges = std::vector<SC::Undecided_part::Range>;
  const Ranges all{{0, 1}}, turns{{0, 4}}, none;
  expect_all_undecided(SC::trimmed_bisector(a, b, no_time), {all, turns});
  expect_all_undecided(SC::trimmed_bisector(a, p, no_time), {all, none});
  expect_all_undecided(SC::trimmed_bisector(p, b, no_time), {none, turns});
  expect_all_undecided(SC::trimmed_bisector(p, q, no_time), {none, none});
  expect_all_undecided(SC::trimmed_self_bisector(b, no_time), {turns});
  for (const double alpha : {0.25, 0.75}) {
    expect_all_undecided(SC::trimmed_alpha_sector(a, b, alpha, no_time), {all, turns});
    expect_all_undecided(SC::trimmed_alpha_sector(a, p, alpha, no_time), {all, none});
    expect_all_undecided(SC::trimmed_alpha_sector(p, b, alpha, no_time), {none, turns});
    // the sites are known at once, and only the nearer one is searched
    expect_undecided(SC::trimmed_alpha_sector(p, q, alpha, no_time), SC::Undecided_reason::TIME, "time limit");
  }
}

// A visitor that stops the search is hardly asked again, and more questions never lead to less.
TEST(VoronoiLimits, StopsOfDiagrams)
{
  const Diagram whole = SC::voronoi_diagram(waves());
  ASSERT_TRUE(whole.is_complete());
  Stop_at_question never(static_cast<std::size_t>(-1));
  expect_equal(SC::voronoi_diagram(waves(), {}, {.visitor = never}), whole);
  ASSERT_GT(never.questions, 400U);
  std::size_t found = 0;
  std::set<std::size_t> numbers;
  for (std::size_t share = 1; share < 12; ++share) {   // behind that, what has been found is worked out
    SCOPED_TRACE(share);
    Stop_at_question visitor(1 + share * never.questions / 16);
    const Diagram part = SC::voronoi_diagram(waves(), {}, {.visitor = visitor});
    expect_undecided(part, SC::Undecided_reason::STOPPED, "stopped");
    EXPECT_LT(visitor.questions, 5 + share * never.questions / 16);
    const std::size_t edges = expect_part(part, whole);
    EXPECT_GE(edges, found);
    found = edges;
    numbers.insert(found);
    for (std::size_t s = 0; s < part.sites().size(); ++s)
      part.cell(s);
  }
  EXPECT_GT(numbers.size(), 3U);
}

TEST(VoronoiLimits, NodesOfDiagrams)
{
  const auto region = SC::planar_region(rooms());
  const Diagram whole = SC::medial_axis(region);
  ASSERT_TRUE(whole.is_complete());
  ASSERT_GT(whole.summary().nodes, 20U);
  for (const std::size_t limit : {std::size_t(1), whole.summary().nodes / 2, whole.summary().nodes - 1}) {
    SCOPED_TRACE(limit);
    const Diagram part = SC::medial_axis(region, {.node_limit = limit});
    expect_undecided(part, SC::Undecided_reason::NODES, "node limit");
    EXPECT_EQ(part.summary().nodes, limit);
    const std::size_t edges = expect_part(part, whole);
    EXPECT_LT(edges, whole.edges().size());
  }
  expect_equal(SC::medial_axis(region, {.node_limit = whole.summary().nodes}), whole);
  expect_equal(SC::medial_axis(region, {.time_limit = 1e6, .node_limit = 1000000}), whole);
}

// The boundaries that are closed are some of all.
TEST(VoronoiLimits, NodesOfOffsets)
{
  const Curves curves = rooms();
  const Offset whole = SC::trimmed_offset(curves, 0.25);
  ASSERT_TRUE(whole.is_complete());
  const auto closed = [](const Offset& offset) {
    return static_cast<std::size_t>(
        std::ranges::count_if(offset.boundaries(), [](const auto& boundary) { return boundary.is_closed; }));
  };
  std::size_t last = 0;
  for (std::size_t share = 0; share < 8; ++share) {
    SCOPED_TRACE(share);
    const std::size_t limit = 1 + share * whole.summary().nodes / 8;
    const Offset part = SC::trimmed_offset(curves, 0.25, {}, {.node_limit = limit});
    expect_undecided(part, SC::Undecided_reason::NODES, "node limit");
    EXPECT_EQ(part.summary().nodes, limit);
    for (const SC::Undecided_part& undecided : part.undecided()) {
      ASSERT_EQ(undecided.place.size(), 2U);   // about within the distance of the curves
      EXPECT_TRUE(-1 < undecided.place[0].first && undecided.place[0].second < 10);
      EXPECT_TRUE(-1 < undecided.place[1].first && undecided.place[1].second < 7);
    }
    EXPECT_GE(closed(part), last);
    last = closed(part);
    EXPECT_LT(last, closed(whole));
    EXPECT_LE(part.polygons_with_holes(0.01).size(), whole.polygons_with_holes(0.01).size());
    for (std::size_t arc = 0; arc < part.arcs().size(); ++arc)
      EXPECT_GT(part.polyline(arc, 0.01).size(), 1U);
  }
  EXPECT_GT(last, 0U);
  const Offset same = SC::trimmed_offset(curves, 0.25, {}, {.time_limit = 1e6, .node_limit = whole.summary().nodes});
  EXPECT_TRUE(same.is_complete());
  ASSERT_EQ(same.arcs().size(), whole.arcs().size());
  for (std::size_t arc = 0; arc < same.arcs().size(); ++arc)
    EXPECT_EQ(same.arcs()[arc].parameters, whole.arcs()[arc].parameters);
}

TEST(VoronoiLimits, NodesOfPairs)
{
  const Curve a = waves()[0], b = waves()[1];
  const auto bisector = SC::trimmed_bisector(a, b);
  const auto sector = SC::trimmed_alpha_sector(a, b, 0.75);
  ASSERT_TRUE(bisector.is_complete() && sector.is_complete());
  for (const std::size_t parts : {8, 4, 2}) {
    const auto part_of_bisector = SC::trimmed_bisector(a, b, {.node_limit = bisector.summary().nodes / parts});
    expect_undecided(part_of_bisector, SC::Undecided_reason::NODES, "node limit");
    for (const auto& chain : part_of_bisector.chains())
      part_of_bisector.polylines(chain, 0.1, 10);
    const auto part_of_sector = SC::trimmed_alpha_sector(a, b, 0.75, {.node_limit = sector.summary().nodes / parts});
    expect_undecided(part_of_sector, SC::Undecided_reason::NODES, "node limit");
    for (std::size_t arc = 0; arc < part_of_sector.arcs().size(); ++arc)
      EXPECT_GT(part_of_sector.polyline(arc, 0.1).size(), 1U);
  }
  EXPECT_TRUE(SC::trimmed_bisector(a, b, {.node_limit = bisector.summary().nodes}).is_complete());
  EXPECT_TRUE(SC::trimmed_alpha_sector(a, b, 0.75, {.node_limit = sector.summary().nodes}).is_complete());
}

namespace {

// Waits at a question, so that there is a report; keeps what it is told.
class Slow_visitor
{
  std::size_t m_questions = 0;

public:
  std::vector<double> reports;

  void on_progress(double share) { reports.push_back(share); }
  bool stop()
  {
    if (++m_questions % 50 == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
    return false;
  }
};

} // namespace

TEST(VoronoiLimits, TellsProgress)
{
  Slow_visitor visitor;
  expect_equal(SC::voronoi_diagram(waves(), {}, {.visitor = visitor}), SC::voronoi_diagram(waves()));
  ASSERT_FALSE(visitor.reports.empty());
  EXPECT_TRUE(std::ranges::is_sorted(visitor.reports));
  EXPECT_TRUE(std::ranges::all_of(visitor.reports, [](double share) { return 0 <= share && share <= 1; }));
  EXPECT_GT(visitor.reports.back(), 0);
}

namespace {

// Is stopped by another thread, once it has been asked some times.
class Flag
{
public:
  std::atomic<std::size_t> questions = 0;
  std::atomic<bool> is_set = false;

  void on_progress(double) {}
  bool stop()
  {
    if (++questions == 30)
      is_set.wait(false);
    return is_set;
  }
};

} // namespace

TEST(VoronoiLimits, StopFromAnotherThread)
{
  Flag flag;
  std::thread other([&] {
    while (flag.questions < 30)
      std::this_thread::yield();
    flag.is_set = true;
    flag.is_set.notify_all();
  });
  const Offset offset = SC::trimmed_offset(waves(), 0.125, {}, {.visitor = flag});
  other.join();
  expect_undecided(offset, SC::Undecided_reason::STOPPED, "stopped");
  EXPECT_LT(flag.questions, 35U);
}

// Without samples of all edges, an arrangement is not complete.
TEST(VoronoiLimits, Arrangements)
{
  const Diagram diagram = SC::voronoi_diagram(waves(), std::list<P>{P(1, 9)});
  const CGAL::Bbox_2 box(-1, -1, 9, 10);
  const auto whole = SC::to_arrangement(diagram, 0.01, box),
             same = SC::to_arrangement(diagram, 0.01, box, {.node_limit = 1000000}),
             part = SC::to_arrangement(diagram, 0.01, box, {.node_limit = 3});
  EXPECT_TRUE(whole.is_complete() && whole.has_same_topology && whole.undecided().empty());
  EXPECT_EQ(same.arrangement.number_of_faces(), whole.arrangement.number_of_faces());
  expect_undecided(part, SC::Undecided_reason::NODES, "node limit");
  EXPECT_FALSE(part.has_same_topology);
  ASSERT_EQ(part.undecided().size(), diagram.edges().size() - 3);
  EXPECT_EQ(part.undecided()[0].parameters[0].operand, 3U);
  EXPECT_EQ(part.polylines.size(), diagram.edges().size());
  EXPECT_FALSE(SC::to_arrangement(diagram, 0.01, 10., no_time).is_complete());
}

// Curves and points come in any ranges, also those that are read but once.
TEST(VoronoiLimits, Ranges)
{
  const Curves curves = waves();
  const std::list<Curve> list(curves.begin(), curves.end());
  const std::list<P> points{P(1, 9), P(2, 8)};
  const Diagram expected = SC::voronoi_diagram(curves, {P(1, 9), P(2, 8)});
  expect_equal(SC::voronoi_diagram(list, points), expected);
  expect_equal(SC::voronoi_diagram(std::views::iota(std::size_t(0), curves.size()) |
                                       std::views::filter([](std::size_t) { return true; }) |
                                       std::views::transform([&](std::size_t i) { return curves[i]; }),
                                   points),
               expected);
  EXPECT_EQ(SC::trimmed_offset(list, 0.125, points).arcs().size(),
            SC::trimmed_offset(curves, 0.125, {P(1, 9), P(2, 8)}).arcs().size());
}

TEST(VoronoiLimits, BadOptions)
{
  const Curve a = waves()[0], b = waves()[1];
  const SC::Solver_options negative{.time_limit = -1};
  EXPECT_THROW(SC::voronoi_diagram(waves(), {}, negative), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_offset(waves(), 1, {}, negative), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_bisector(a, b, negative), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_alpha_sector(a, b, 0.25, negative), SC::Invalid_input);
  EXPECT_THROW(SC::medial_axis(SC::planar_region(rooms()), negative), SC::Invalid_input);
}

// An isolated point that is not decided has the number behind those of the curves.
TEST(VoronoiLimits, NumbersOfPoints)
{
  const Diagram part = SC::voronoi_diagram(Curves{waves()[0]}, {P(1, 9), P(4, 7)}, {.node_limit = 1});
  std::set<std::size_t> operands;
  for (const SC::Undecided_part& undecided : part.undecided()) {
    ASSERT_EQ(undecided.parameters.size(), 1U);
    operands.insert(undecided.parameters[0].operand);
    EXPECT_EQ(undecided.parameters[0].ranges.size(), undecided.parameters[0].operand == 0 ? 1U : 0U);
  }
  EXPECT_EQ(operands, (std::set<std::size_t>{0, 1, 2}));
}

} // namespace voronoi_limits_2_test
