// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The cells of Voronoi diagrams: of points as CGAL finds them, of curves with what bounds them, in order; every edge
// bounds two cells, and both sites are the nearest ones along it; the cells of all regions fill a box.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>

#include <CGAL/Delaunay_triangulation_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace voronoi_cells_test {

// Chains are connected, their edges have one of the sites on the left and another site on the right, and each point of
// them is nearest to both.
void expect_boundary(const Diagram& diagram, const std::vector<std::size_t>& sites, const Curves& curves)
{
  const Diagram::Cell cell = diagram.cell(sites);
  const std::set<std::size_t> inner(sites.begin(), sites.end());
  for (const auto& [edges, is_closed] : cell.chains) {
    ASSERT_FALSE(edges.empty());
    EXPECT_TRUE(!is_closed || edges.back().vertices[1] == edges.front().vertices[0]);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto& edge = edges[i];
      EXPECT_TRUE(i == 0 || edges[i - 1].vertices[1] == edge.vertices[0]);
      EXPECT_TRUE(inner.contains(edge.sites[1]) && !inner.contains(edge.sites[0]));
      const auto& stored = diagram.edges()[edge.index];
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(edge.sites[k], stored.sites[k ^ edge.is_reversed]);
        EXPECT_EQ(edge.vertices[k], stored.vertices[k ^ edge.is_reversed]);
      }
      for (const auto& sample : diagram.polyline(edge, 0.05, 50))
        for (std::size_t k = 0; k < 2; ++k) {
          const auto& site = diagram.sites()[edge.sites[k]];
          EXPECT_NEAR(distance(sample.point, site.is_point ? site.point : curves[*site.curve](*sample.parameters[k])),
                      sample.radius, 1e-8 * (1 + sample.radius));
        }
    }
  }
}

// Every edge between two sites is once on the boundary of each, in a diagram that is complete.
void expect_all_edges_twice(const Diagram& diagram, const Curves& curves)
{
  std::vector<int> sides(diagram.edges().size(), 0);
  for (std::size_t s = 0; s < diagram.sites().size(); ++s) {
    expect_boundary(diagram, {s}, curves);
    EXPECT_TRUE(diagram.cell(s).is_complete);
    for (const auto& chain : diagram.cell(s).chains)
      for (const auto& edge : chain.edges)
        ++sides[edge.index];
  }
  for (std::size_t e = 0; e < sides.size(); ++e)
    EXPECT_EQ(sides[e], diagram.edges()[e].sites[0] == diagram.edges()[e].sites[1] ? 0 : 2);
}

TEST(VoronoiCells, OfPointsAsCGALFindsThem)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 100);
  std::vector<P> points;
  for (int i = 0; i < 30; ++i)
    points.emplace_back(coordinate(random), coordinate(random));
  const CGAL::Delaunay_triangulation_2<K> triangulation(points.begin(), points.end());
  const Diagram diagram = SC::voronoi_diagram(Curves(), points);
  ASSERT_TRUE(diagram.is_complete());
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    const auto site = static_cast<std::size_t>(std::find_if(diagram.sites().begin(), diagram.sites().end(),
                                                            [&](const auto& s) { return s.point == v->point(); }) -
                                               diagram.sites().begin());
    std::vector<P> neighbors;   // counterclockwise, behind the infinite vertex if there is one
    bool is_unbounded = false;
    auto n = triangulation.incident_vertices(v), begin = n;
    do
      if (triangulation.is_infinite(n))
        is_unbounded = true, begin = n;
    while (++n != triangulation.incident_vertices(v));
    n = begin;
    do
      if (!triangulation.is_infinite(n))
        neighbors.push_back(n->point());
    while (++n != begin);
    const auto cell = diagram.cell(site);
    ASSERT_EQ(cell.chains.size(), 1U);
    EXPECT_EQ(cell.chains[0].is_closed, !is_unbounded);
    std::vector<P> adjacent;
    for (const auto& edge : cell.chains[0].edges)
      adjacent.push_back(diagram.sites()[edge.sites[0]].point);
    ASSERT_EQ(adjacent.size(), neighbors.size());
    if (!is_unbounded)
      std::rotate(adjacent.begin(), std::find(adjacent.begin(), adjacent.end(), neighbors.front()), adjacent.end());
    EXPECT_EQ(adjacent, neighbors);
  }
  expect_all_edges_twice(diagram, {});
}

// A point between two parallel segments, whose cell is bounded by parts of two parabolas; those of the segments are
// bounded on one side by three edges.
TEST(VoronoiCells, PointBetweenSegments)
{
  const Curves curves{SC::segment_curve(P(0, 0), P(8, 0)), SC::segment_curve(P(0, 4), P(8, 4))};
  const Diagram diagram = SC::voronoi_diagram(curves, {P(4, 2)});
  ASSERT_TRUE(diagram.is_complete());
  expect_all_edges_twice(diagram, curves);
  const auto point =
      static_cast<std::size_t>(std::find_if(diagram.sites().begin(), diagram.sites().end(),
                                            [](const auto& s) { return s.is_point && s.point == P(4, 2); }) -
                               diagram.sites().begin());
  const auto cell = diagram.cell(point);
  ASSERT_EQ(cell.chains.size(), 1U);
  EXPECT_TRUE(cell.chains[0].is_closed);
  // of the polygon of samples: between the parabolas 1 + (x - 4)^2 / 4 and 3 - (x - 4)^2 / 4, for |x - 4| <= 2: 16/3
  double area = 0;
  for (const auto& edge : cell.chains[0].edges) {
    const auto samples = diagram.polyline(edge, 1e-6);
    for (std::size_t i = 1; i < samples.size(); ++i)
      area += CGAL::determinant(samples[i - 1].point - P(4, 2), samples[i].point - P(4, 2)) / 2;
  }
  EXPECT_NEAR(area, 16. / 3, 1e-4);   // positive: counterclockwise

  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(diagram.sites_of_curve(c).size(), 3U);
    const auto of_piece = diagram.cell(c);
    ASSERT_EQ(of_piece.chains.size(), 1U);
    EXPECT_FALSE(of_piece.chains[0].is_closed);
    EXPECT_EQ(of_piece.chains[0].edges.size(), 3U);
    // with the cells of both ends: from infinity to infinity
    const auto of_curve = diagram.cell(diagram.sites_of_curve(c));
    ASSERT_EQ(of_curve.chains.size(), 1U);
    EXPECT_FALSE(of_curve.chains[0].is_closed);
    for (const bool end : {false, true}) {
      const auto& edge = end ? of_curve.chains[0].edges.back() : of_curve.chains[0].edges.front();
      EXPECT_TRUE(diagram.vertices()[edge.vertices[end]].is_at_infinity);
    }
    expect_boundary(diagram, diagram.sites_of_curve(c), curves);
  }
}

// A closed curve with a point inside and a segment outside, in a larger circle: its cell has an outer boundary, and the
// cell of the point as a hole.
TEST(VoronoiCells, OfAClosedCurveInsideAndOutside)
{
  const Curves curves{SC::circle_curve(P(0, 0), 10), bezier({P(-3, 0), P(-3, 5), P(3, 5), P(3, 0)}),
                      bezier({P(3, 0), P(3, -5), P(-3, -5), P(-3, 0)}), bezier({P(6, -1), P(6, 2)})};
  const Diagram diagram = SC::voronoi_diagram(curves, {P(0.5, 0.25)});
  ASSERT_TRUE(diagram.is_complete());
  expect_all_edges_twice(diagram, curves);
  std::vector<std::size_t> sites = diagram.sites_of_curve(1);
  const std::vector<std::size_t> other = diagram.sites_of_curve(2);
  sites.insert(sites.end(), other.begin(), other.end());   // both joints twice
  expect_boundary(diagram, sites, curves);
  const auto cell = diagram.cell(sites);
  EXPECT_TRUE(cell.is_complete);
  ASSERT_EQ(cell.chains.size(), 2U);
  EXPECT_TRUE(cell.chains[0].is_closed && cell.chains[1].is_closed);
  std::multiset<bool> is_hole;
  for (const auto& chain : cell.chains) {
    const auto& site = diagram.sites()[chain.edges.front().sites[0]];
    const bool has_point = site.is_point && site.point == P(0.5, 0.25);
    is_hole.insert(has_point);
    double area = 0;
    for (const auto& edge : chain.edges) {
      const auto samples = diagram.polyline(edge, 0.01);
      for (std::size_t i = 1; i < samples.size(); ++i)
        area += CGAL::determinant(samples[i - 1].point - P(0, 0), samples[i].point - P(0, 0)) / 2;
    }
    EXPECT_EQ(area < 0, has_point);   // the cell is on the left
  }
  EXPECT_EQ(is_hole, (std::multiset<bool>{false, true}));

  const auto arrangement = SC::to_arrangement(diagram, 0.01, CGAL::Bbox_2(-12, -12, 13, 12));
  ASSERT_TRUE(arrangement.has_same_topology);
  CGAL::Exact_predicates_exact_constructions_kernel::FT area = 0;
  std::vector<std::size_t> holes;
  for (std::size_t r = 0; r < diagram.number_of_regions(); ++r) {
    const auto polygons = SC::region_polygons(arrangement, r);
    for (const auto& polygon : polygons) {
      EXPECT_TRUE(polygon.outer_boundary().is_simple());
      area += polygon.outer_boundary().area();
      for (const auto& hole : polygon.holes())
        area += hole.area();
    }
    holes.push_back(polygons.size() == 1 ? polygons[0].number_of_holes() : 99);
  }
  EXPECT_EQ(area, 25 * 24);
  std::sort(holes.begin(), holes.end());
  // the closed curve has the cell of the point as a hole, and the circle those of all others together
  EXPECT_EQ(holes, (std::vector<std::size_t>{0, 0, 1, 1}));
}

TEST(VoronoiCells, RandomScenes)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 10);
  const auto point = [&] { return P(coordinate(random), coordinate(random)); };
  int complete = 0;
  for (int run = 0; run < 2; ++run) {
    Curves curves;
    for (int i = 0; i < 2; ++i)
      curves.push_back(bezier({point(), point(), point(), point()}));
    const std::vector<P> points{point(), point()};
    const Diagram diagram = SC::voronoi_diagram(curves, points);
    if (!diagram.is_complete())
      continue;
    ++complete;
    expect_all_edges_twice(diagram, curves);
    const auto arrangement = SC::to_arrangement(diagram, 0.05, CGAL::Bbox_2(-5, -5, 15, 15));
    CGAL::Exact_predicates_exact_constructions_kernel::FT area = 0;
    for (std::size_t r = 0; r < diagram.number_of_regions(); ++r)
      for (const auto& polygon : SC::region_polygons(arrangement, r)) {
        area += polygon.outer_boundary().area();
        for (const auto& hole : polygon.holes())
          area += hole.area();
      }
    EXPECT_EQ(area, 400);
  }
  EXPECT_EQ(complete, 2);
}

TEST(VoronoiCells, OneSiteHasAllOfTheBox)
{
  const Diagram diagram = SC::voronoi_diagram(Curves(), {P(1, 2)});
  EXPECT_TRUE(diagram.cell(0).is_complete);
  EXPECT_TRUE(diagram.cell(0).chains.empty());
  const auto polygons = SC::region_polygons(SC::to_arrangement(diagram, 0.1, CGAL::Bbox_2(0, 0, 3, 4)), 0);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].outer_boundary().area(), 12);
}

// Of a rectangle, 4 x 2: each side has the triangle or trapezoid over it.
TEST(VoronoiCells, OfAMedialAxis)
{
  const Curves sides{bezier({P(0, 0), P(4, 0)}), bezier({P(4, 0), P(4, 2)}), bezier({P(4, 2), P(0, 2)}),
                     bezier({P(0, 2), P(0, 0)})};
  const Diagram axis = SC::medial_axis(SC::planar_region(sides));
  ASSERT_TRUE(axis.is_complete());
  for (std::size_t s = 0; s < axis.sites().size(); ++s) {
    const auto cell = axis.cell(s);
    EXPECT_TRUE(cell.is_complete);
    ASSERT_EQ(cell.chains.size(), axis.sites()[s].is_point ? 0U : 1U);
    for (const auto& chain : cell.chains)
      EXPECT_EQ(chain.edges.size(), *axis.sites()[s].curve % 2 == 0 ? 3U : 2U);
  }
}

// Three curves that pass through two points with irrational parameters: where they cross is not proved, and no cell
// claims to be.
TEST(VoronoiCells, IncompleteDiagramsSaySo)
{
  const Curves curves{bezier({P(-2, 2), P(0, -6), P(2, 2)}), bezier({P(-2, -2), P(0, 6), P(2, -2)}),
                      bezier({P(-3, 0), P(3, 0)})};
  const Diagram diagram = SC::voronoi_diagram(curves, {P(10, 11)});
  ASSERT_FALSE(diagram.is_complete());
  for (std::size_t s = 0; s < diagram.sites().size(); ++s)
    EXPECT_FALSE(diagram.cell(s).is_complete);
}

// The message names the curve and the parameters.
TEST(VoronoiCells, PiecesThatArePoints)
{
  const Curves curves{bezier({P(9, 0), P(9, 1)}),
                      SC::polyline_curve(std::vector<P>{P(0, 0), P(1, 1), P(1, 1), P(2, 0)})};
  try {
    (void)SC::voronoi_diagram(curves);
    FAIL();
  } catch (const SC::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find("curve 1 between the parameters 1 and 2 is a point"), std::string::npos)
        << error.what();
  }
}

TEST(VoronoiCells, RefusesUnknownSites)
{
  const Diagram diagram = SC::voronoi_diagram(Curves(), {P(0, 0), P(1, 0)});
  EXPECT_THROW((void)diagram.cell(2), SC::Invalid_input);
  EXPECT_TRUE(diagram.cell(std::vector<std::size_t>{}).chains.empty());
  EXPECT_TRUE(diagram.cell(std::vector<std::size_t>{0, 1}).chains.empty());   // all of the plane
  EXPECT_EQ(diagram.cell(0).chains.size(), 1U);
}

} // namespace voronoi_cells_test
