// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams as arrangements: vertices, edges and faces are those of the diagram, and labels lead to its edges.
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi_diagrams_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;

// The numbers of vertices with one edge, and with three or more.
std::pair<std::size_t, std::size_t> ends_and_branches(const SC::Polyline_arrangement_2& arrangement)
{
  std::pair<std::size_t, std::size_t> result;
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
    result.first += v->degree() == 1;
    result.second += v->degree() > 2;
  }
  return result;
}

TEST(VoronoiArrangement, ThreePoints)
{
  const auto diagram = SC::voronoi_diagram(Curves(), {P(0, 0), P(4, 0), P(0, 2)});
  const auto result = SC::to_arrangement(diagram, 0.01, 10);
  EXPECT_TRUE(result.has_same_topology);
  EXPECT_EQ(ends_and_branches(result.arrangement), (std::pair<std::size_t, std::size_t>(3, 1)));
  EXPECT_EQ(result.arrangement.number_of_faces(), 1U);   // rays are cut
  std::vector<int> chords(3, 0);
  for (auto edge = result.arrangement.edges_begin(); edge != result.arrangement.edges_end(); ++edge) {
    const auto& label = edge->curve().data().front();
    ++chords[label.curve];
    for (const std::size_t i : {label.chord, label.chord + 1})
      EXPECT_LE(result.polylines[label.curve][i].radius, 10.01);
  }
  EXPECT_TRUE(std::all_of(chords.begin(), chords.end(), [](int number) { return number > 0; }));
}

// The diagram of curves in a frame has no rays inside; faces are its regions. Coarse chords are refined.
TEST(VoronoiArrangement, CurvesInAFrame)
{
  const std::vector<P> corners{P(-3, -4), P(8, -3), P(7, 9), P(-4, 8)};
  Curves curves{SC::bezier_curve(std::vector<P>{P(0, 0), P(1, 2), P(2, -2), P(3, 0)}), SC::bezier_curve(std::vector<P>{P(0, 3), P(1, 5), P(2, 2), P(3, 4)})};
  for (std::size_t i = 0; i < 4; ++i)
    curves.push_back(SC::bezier_curve(std::vector<P>{corners[i], corners[(i + 1) % 4]}));
  const auto diagram = SC::voronoi_diagram(curves);
  ASSERT_TRUE(diagram.is_complete());
  const auto result = SC::to_arrangement(diagram, 1, 100);
  EXPECT_TRUE(result.has_same_topology);
  const auto count = [&](auto is_wanted) { return static_cast<std::size_t>(std::count_if(diagram.vertices().begin(), diagram.vertices().end(), is_wanted)); };
  EXPECT_EQ(ends_and_branches(result.arrangement), std::pair(count([](const auto& v) { return v.edges.size() == 1; }), count([](const auto& v) { return v.edges.size() > 2; })));
  EXPECT_EQ(result.arrangement.number_of_faces(), 3U);   // as many as there are regions
  EXPECT_EQ(diagram.number_of_regions(), 3U);
}

// In a crossing an edge of the diagram ends in each of the four angles: these are one vertex of the arrangement.
TEST(VoronoiArrangement, CurvesThatCross)
{
  const auto expect_one_crossing = [](const Curves& curves) {
    const auto diagram = SC::voronoi_diagram(curves);
    ASSERT_TRUE(diagram.is_complete());
    const auto result = SC::to_arrangement(diagram, 0.05, 20);
    EXPECT_TRUE(result.has_same_topology);
    EXPECT_EQ(std::count_if(result.arrangement.vertices_begin(), result.arrangement.vertices_end(), [](const auto& v) { return v.degree() == 4; }), 1);
  };
  expect_one_crossing({SC::bezier_curve(std::vector<P>{P(0, 0), P(4, 1)}), SC::bezier_curve(std::vector<P>{P(1, 3), P(2, -2)})});
  expect_one_crossing({SC::bezier_curve(std::vector<P>{P(0, 0), P(6, 4), P(-2, 4.2), P(4.1, 0.3)})});
}

TEST(VoronoiArrangement, BadInput)
{
  const auto diagram = SC::voronoi_diagram(Curves(), {P(0, 0), P(4, 0)});
  EXPECT_THROW(SC::to_arrangement(diagram, 0, 10), SC::Invalid_input);
  EXPECT_THROW(SC::to_arrangement(diagram, 0.1, std::numeric_limits<double>::infinity()), SC::Invalid_input);
}
