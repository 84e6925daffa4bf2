// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Diagrams and offsets that CGAL knows as well: of circles, by its Apollonius graph; of segments and points, by its
// segment Delaunay graph; of polygons, by its approximated offsets.
#include "polygon_area.h"
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/approximated_offset_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace comparisons_with_CGAL_2_test {

namespace {

using Double_kernel = CGAL::Simple_cartesian<double>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// A finite face of a graph of CGAL.
struct Expected_vertex
{
  P point;
  std::set<std::size_t> sites;   // of its three vertices
};

// All vertices are those of CGAL, as many as its graph has finite faces, and touch the sites of these. Where an edge
// goes on with another site, or ends in a corner, they list some of them only. Sites are compared by what `name` makes
// of those of the diagram.
template <class Name>
void expect_vertices(const Diagram& diagram, const std::vector<Expected_vertex>& expected, std::size_t number,
                     const Name& name)
{
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(expected.size(), number);
  EXPECT_GT(number, 2U);
  std::set<std::size_t> found;
  for (const auto& [point, sites] : expected) {
    EXPECT_EQ(sites.size(), 3U) << point;
    const auto vertex = std::find_if(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
      return !v.is_at_infinity && distance(*v.point, point) < 1e-6 * (1 + *v.radius);
    });
    ASSERT_NE(vertex, diagram.vertices().end()) << point;
    EXPECT_TRUE(found.insert(static_cast<std::size_t>(vertex - diagram.vertices().begin())).second) << point;
    std::set<std::size_t> touched;
    for (const auto& footpoint : vertex->footpoints)
      touched.insert(name(footpoint.site));
    EXPECT_EQ(touched.size(), vertex->edges.size()) << point;
    EXPECT_TRUE(std::includes(sites.begin(), sites.end(), touched.begin(), touched.end())) << point;
  }
}

// One in each of eight cells, with integers or with decimal numbers, of which the control points of circles are not
// those of circles if they are rounded; `survey_scenes circles` compares more.
TEST(ComparisonsWithCGAL, CirclesAndApolloniusGraph)
{
  using Traits = CGAL::Apollonius_graph_traits_2<Double_kernel>;
  std::mt19937 random(1);
  for (int run = 0; run < 4; ++run) {
    const int unit = run % 2 == 1 ? 100 : 1;   // of hundredths
    std::uniform_int_distribution<int> hundredths(300 / unit, 700 / unit), radii(100 / unit, 290 / unit);
    Curves circles;
    std::vector<P> centers;
    CGAL::Apollonius_graph_2<Traits> graph;
    for (int i = 0; i < 8; ++i) {
      const double x = 10 * (i % 3) + hundredths(random) * unit / 100.0,
                   y = 10 * (i / 3) + hundredths(random) * unit / 100.0, radius = radii(random) * unit / 100.0;
      centers.emplace_back(x, y);
      circles.push_back(SC::circle_curve(centers.back(), radius));
      graph.insert(Traits::Site_2(Traits::Point_2(x, y), radius));
    }
    const auto circle_of = [&](const Traits::Site_2& site) {
      return static_cast<std::size_t>(std::find(centers.begin(), centers.end(), P(site.point().x(), site.point().y())) -
                                      centers.begin());
    };
    std::vector<Expected_vertex> expected;
    for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
      const auto &a = face->vertex(0)->site(), &b = face->vertex(1)->site(), &c = face->vertex(2)->site();
      const auto p = Traits().construct_Apollonius_vertex_2_object()(a, b, c);
      expected.push_back({P(p.x(), p.y()), {circle_of(a), circle_of(b), circle_of(c)}});
    }
    const Diagram diagram = SC::voronoi_diagram(circles);
    expect_vertices(diagram, expected, counts(diagram).branching,
                    [&](std::size_t site) { return *diagram.sites()[site].curve; });
  }
}

class Segment_scene
{
  using Traits = CGAL::Segment_Delaunay_graph_traits_without_intersections_2<Double_kernel, CGAL::Field_with_sqrt_tag>;
  using Site_point = Double_kernel::Point_2;

  Curves m_segments;
  std::vector<std::array<P, 2>> m_ends;   // of the segments
  std::vector<P> m_points;
  CGAL::Segment_Delaunay_graph_2<Traits> m_graph;

public:
  void insert(const P& p)
  {
    m_points.push_back(p);
    m_graph.insert(Site_point(p.x(), p.y()));
  }

  void insert(const P& p, const P& q)
  {
    m_segments.push_back(bezier({p, q}));
    m_ends.push_back({p, q});
    m_graph.insert(Site_point(p.x(), p.y()), Site_point(q.x(), q.y()));
  }

  // The graph has a finite face for each corner, too, where an edge of the diagram ends.
  void expect_same_vertices(std::size_t corners) const
  {
    const Diagram diagram = SC::voronoi_diagram(m_segments, m_points);
    std::vector<Expected_vertex> expected;
    for (auto face = m_graph.finite_faces_begin(); face != m_graph.finite_faces_end(); ++face) {
      const Site_point p = m_graph.primal(face);
      expected.push_back({P(p.x(), p.y()), {}});
      for (const int i : {0, 1, 2})
        expected.back().sites.insert(site_in_diagram(diagram, face->vertex(i)->site()));
    }
    const Counts numbers = counts(diagram);
    EXPECT_EQ(numbers.tips, corners);
    expect_vertices(diagram, expected, numbers.branching + numbers.passing + numbers.tips,
                    [](std::size_t site) { return site; });
  }

private:
  // The index of a site of the graph in the diagram.
  std::size_t site_in_diagram(const Diagram& diagram, const Traits::Site_2& wanted) const
  {
    const auto point = [](const Site_point& p) { return P(p.x(), p.y()); };
    const auto is_wanted = [&](const Diagram::Site& site) {
      if (site.is_point || wanted.is_point())
        return site.is_point && wanted.is_point() && site.point == point(wanted.point());
      const auto& [p, q] = m_ends[*site.curve];
      const P source = point(wanted.segment().source()), target = point(wanted.segment().target());
      return (p == source && q == target) || (p == target && q == source);
    };
    const auto found = std::find_if(diagram.sites().begin(), diagram.sites().end(), is_wanted);
    EXPECT_NE(found, diagram.sites().end());
    return static_cast<std::size_t>(found - diagram.sites().begin());
  }
};

TEST(ComparisonsWithCGAL, SegmentsAndSegmentDelaunayGraph)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(1, 9);
  for (int run = 0; run < 10; ++run) {
    Segment_scene scene;
    for (int i = 0; i < 6; ++i) {
      const auto in_cell = [&] {
        const double x = 10 * (i % 3) + coordinate(random), y = 10 * (i / 3) + coordinate(random);
        return P(x, y);
      };
      const P p = in_cell(), q = in_cell();
      if (i % 3 == run % 3)
        scene.insert(p);
      else
        scene.insert(p, q);
    }
    scene.expect_same_vertices(0);
  }
}

// Polygons and polylines: their segments share end points.
TEST(ComparisonsWithCGAL, PolygonsAndSegmentDelaunayGraph)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(0.1, 0.6), length(1, 4.5);
  for (int run = 0; run < 10; ++run) {
    Segment_scene scene;
    std::size_t corners = 0;
    for (int i = 0; i < 2; ++i) {
      const bool is_closed = (run + i) % 2 == 0;
      const int n = 3 + (run + i) % 3;
      std::vector<P> points;
      for (int k = 0; k < n; ++k) {
        const double angle = 2 * CGAL_PI * (k + part(random)) / n, radius = length(random);
        points.emplace_back(10 * i + radius * std::cos(angle), radius * std::sin(angle));
      }
      for (int k = 0; k < (is_closed ? n : n - 1); ++k)
        scene.insert(points[k], points[(k + 1) % n]);
      corners += is_closed ? n : n - 2;
    }
    scene.insert(P(5 + part(random), 8));
    scene.expect_same_vertices(corners);
  }
}

// Of chords, and of what is between them and arcs of circles.
template <class Polygon>
double area_with_arcs(const Polygon& polygon)
{
  double result = 0;
  for (auto arc = polygon.curves_begin(); arc != polygon.curves_end(); ++arc) {
    const double x = CGAL::to_double(arc->source().x()), y = CGAL::to_double(arc->source().y()),
                 u = CGAL::to_double(arc->target().x()), v = CGAL::to_double(arc->target().y());
    result += (x * v - u * y) / 2;
    if (arc->is_circular()) {
      const double square = CGAL::to_double(arc->supporting_circle().squared_radius()),
                   angle = 2 * std::asin((std::min)(1.0, std::hypot(u - x, v - y) / (2 * std::sqrt(square))));
      result += (arc->orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1) * square / 2 * (angle - std::sin(angle));
    }
  }
  return result;
}

using Arc_polygon = CGAL::Gps_circle_segment_traits_2<Exact_kernel>::Polygon_2;

// An arc of a polygon of CGAL, in doubles: a segment, or part of a circle, at most half of it.
struct Rounded_arc
{
  P source, target, center;
  double radius;   // 0 of a segment
  int turn;        // 1 if it is counterclockwise, -1 if it is clockwise

  P middle() const
  {
    if (turn == 0)
      return CGAL::midpoint(source, target);
    const K::Vector_2 right = (target - source).perpendicular(CGAL::CLOCKWISE);
    return center + turn * radius / std::sqrt(right.squared_length()) * right;
  }

  double distance_from(const P& p) const
  {
    if (turn == 0)
      return std::sqrt(CGAL::squared_distance(p, K::Segment_2(source, target)));
    const P on_circle = center + radius / distance(center, p) * (p - center);
    if (CGAL::orientation(source, target, on_circle) == (turn > 0 ? CGAL::RIGHT_TURN : CGAL::LEFT_TURN))
      return distance(p, on_circle);
    return (std::min)(distance(p, source), distance(p, target));
  }
};

std::vector<Rounded_arc> rounded_arcs(const std::vector<Arc_polygon>& boundaries)
{
  std::vector<Rounded_arc> result;
  for (const Arc_polygon& boundary : boundaries)
    for (auto arc = boundary.curves_begin(); arc != boundary.curves_end(); ++arc) {
      result.push_back({rounded(arc->source()), rounded(arc->target()), P(0, 0), 0, 0});
      if (arc->is_circular()) {
        result.back().center = rounded(arc->supporting_circle().center());
        result.back().radius = std::sqrt(CGAL::to_double(arc->supporting_circle().squared_radius()));
        result.back().turn = arc->orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1;
      }
    }
  return result;
}

// From the boundaries of polygons.
double least_distance(const P& p, const std::vector<CGAL::Polygon_2<K>>& polygons)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& polygon : polygons)
    for (auto edge = polygon.edges_begin(); edge != polygon.edges_end(); ++edge)
      least = (std::min)(least, CGAL::squared_distance(p, *edge));
  return std::sqrt(least);
}

constexpr double offset_distance = 0.5, chord_error = 1e-5, error_of_CGAL = 1e-6;

// All points of both boundaries have the distance from the polygon, and those of one are points of the other one, up to
// errors of chords and of CGAL.
void expect_same_boundaries(const SC::Trimmed_offset_2<K>& offset, const std::vector<Arc_polygon>& boundaries,
                            const CGAL::Polygon_2<K>& polygon)
{
  constexpr double error = 2 * (chord_error + error_of_CGAL);
  std::vector<CGAL::Polygon_2<K>> polygons;
  for (const auto& part : offset.polygons_with_holes(chord_error)) {
    polygons.push_back(part.outer_boundary());
    polygons.insert(polygons.end(), part.holes_begin(), part.holes_end());
  }
  EXPECT_FALSE(polygons.empty());
  const std::vector<Rounded_arc> arcs = rounded_arcs(boundaries);
  EXPECT_FALSE(arcs.empty());
  const std::vector<CGAL::Polygon_2<K>> given{polygon};
  double from_distance = 0, from_offset = 0, from_expected = 0;   // the greatest ones
  for (const Rounded_arc& arc : arcs)
    for (const P& p : {arc.source, arc.middle()}) {
      from_distance = (std::max)(from_distance, std::abs(least_distance(p, given) - offset_distance));
      from_offset = (std::max)(from_offset, least_distance(p, polygons));
    }
  for (const auto& found : polygons)
    for (auto edge = found.edges_begin(); edge != found.edges_end(); ++edge)
      for (const P& p : {edge->source(), CGAL::midpoint(edge->source(), edge->target())}) {
        double least = std::numeric_limits<double>::infinity();
        for (const Rounded_arc& arc : arcs)
          least = (std::min)(least, arc.distance_from(p));
        from_distance = (std::max)(from_distance, std::abs(least_distance(p, given) - offset_distance));
        from_expected = (std::max)(from_expected, least);
      }
  EXPECT_LT(from_distance, error);
  EXPECT_LT(from_offset, error);
  EXPECT_LT(from_expected, error);
}

std::size_t number_of_holes(const SC::Trimmed_offset_2<K>& offset)
{
  return static_cast<std::size_t>(std::count_if(offset.boundaries().begin(), offset.boundaries().end(),
                                                [](const auto& boundary) { return boundary.is_hole; }));
}

// Compares what has grown and shrunk with offsets of CGAL; returns how many holes the first one has.
std::size_t expect_offsets_of_CGAL(const CGAL::Polygon_2<K>& polygon)
{
  CGAL::Polygon_2<Exact_kernel> exact;
  for (const P& p : polygon)
    exact.push_back(Exact_kernel::Point_2(p.x(), p.y()));
  const auto region = SC::planar_region(polygon);
  const auto sum_of_areas = [](const std::vector<Arc_polygon>& boundaries) {
    double result = 0;
    for (const auto& boundary : boundaries)
      result += area_with_arcs(boundary);
    return result;
  };
  const auto outer = CGAL::approximated_offset_2(exact, Exact_kernel::FT(offset_distance), error_of_CGAL);
  std::vector<Arc_polygon> boundaries{outer.outer_boundary()};
  boundaries.insert(boundaries.end(), outer.holes_begin(), outer.holes_end());
  const auto grown = SC::trimmed_offset(region, offset_distance), shrunk = SC::trimmed_offset(region, -offset_distance);
  EXPECT_TRUE(grown.is_complete());
  EXPECT_EQ(grown.boundaries().size(), boundaries.size());
  EXPECT_EQ(number_of_holes(grown), boundaries.size() - 1);
  EXPECT_NEAR(total_area(grown.polygons_with_holes(chord_error)), sum_of_areas(boundaries), 1e-3);
  expect_same_boundaries(grown, boundaries, polygon);
  std::vector<Arc_polygon> inner;
  CGAL::approximated_inset_2(exact, Exact_kernel::FT(offset_distance), error_of_CGAL, std::back_inserter(inner));
  EXPECT_FALSE(inner.empty());
  EXPECT_TRUE(shrunk.is_complete());
  EXPECT_EQ(shrunk.boundaries().size(), inner.size());
  EXPECT_EQ(number_of_holes(shrunk), 0U);
  // those of CGAL are clockwise
  EXPECT_NEAR(total_area(shrunk.polygons_with_holes(chord_error)), std::abs(sum_of_areas(inner)), 1e-3);
  expect_same_boundaries(shrunk, inner, polygon);
  return number_of_holes(grown);
}

// Stars, and a letter C that is closed when it grows.
TEST(ComparisonsWithCGAL, PolygonsAndApproximatedOffsets)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 0.5), length(2, 6);
  for (int run = 0; run < 10; ++run) {
    const int n = 5 + run % 5;
    CGAL::Polygon_2<K> star;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * (i + part(random)) / n, from_center = length(random);
      star.push_back(P(from_center * std::cos(angle), from_center * std::sin(angle)));
    }
    expect_offsets_of_CGAL(star);
  }
  const std::vector<P> letter{P(0, 0),    P(6, 0.5),   P(6.25, 2.625), P(5, 2.5),   P(4.5, 1.75), P(1.5, 1.5),
                              P(1.25, 5), P(4.5, 4.5), P(4.75, 3.25),  P(6, 3.375), P(5.75, 6.5), P(-0.25, 6)};
  EXPECT_EQ(expect_offsets_of_CGAL({letter.begin(), letter.end()}), 1U);
}

} // namespace

} // namespace comparisons_with_CGAL_2_test
