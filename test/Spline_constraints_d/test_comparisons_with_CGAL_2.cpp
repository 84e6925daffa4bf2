// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Diagrams and offsets that CGAL knows as well: of circles, by its Apollonius graph; of segments and points, by its segment Delaunay graph; of polygons, by its approximated offsets.
#include "polygon_area.h"
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/trimmed_offsets_2.h>

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/approximated_offset_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <vector>

namespace {

using Double_kernel = CGAL::Simple_cartesian<double>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// All vertices are those of CGAL, as many as its graph has finite faces.
void expect_vertices(const Diagram& diagram, const std::vector<P>& expected, std::size_t number)
{
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(expected.size(), number);
  EXPECT_GT(number, 2U);
  for (const P& p : expected)
    EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) { return !v.is_at_infinity && distance(v.point, p) < 1e-6 * (1 + v.radius); })) << p;
}

// One in each of five cells, with integers or with decimal numbers, of which the control points of circles are not those of circles if they are rounded; `survey_scenes circles` compares more.
TEST(ComparisonsWithCGAL, CirclesAndApolloniusGraph)
{
  using Traits = CGAL::Apollonius_graph_traits_2<Double_kernel>;
  std::mt19937 random(1);
  for (int run = 0; run < 2; ++run) {
    const int unit = run == 1 ? 100 : 1;   // of hundredths
    std::uniform_int_distribution<int> hundredths(300 / unit, 700 / unit), radii(100 / unit, 290 / unit);
    Curves circles;
    CGAL::Apollonius_graph_2<Traits> graph;
    for (int i = 0; i < 5; ++i) {
      const double x = 10 * (i % 2) + hundredths(random) * unit / 100.0, y = 10 * (i / 2) + hundredths(random) * unit / 100.0, radius = radii(random) * unit / 100.0;
      circles.push_back(SC::circle_curve(P(x, y), radius));
      graph.insert(Traits::Site_2(Traits::Point_2(x, y), radius));
    }
    std::vector<P> expected;
    for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
      const auto p = Traits().construct_Apollonius_vertex_2_object()(face->vertex(0)->site(), face->vertex(1)->site(), face->vertex(2)->site());
      expected.emplace_back(p.x(), p.y());
    }
    const Diagram diagram = SC::voronoi_diagram(circles);
    expect_vertices(diagram, expected, counts(diagram).branching);
  }
}

class Segment_scene
{
  using Traits = CGAL::Segment_Delaunay_graph_traits_without_intersections_2<Double_kernel, CGAL::Field_with_sqrt_tag>;
  using Site_point = Double_kernel::Point_2;

  Curves m_segments;
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
    m_graph.insert(Site_point(p.x(), p.y()), Site_point(q.x(), q.y()));
  }

  // The graph has a finite face for each corner, too, where an edge of the diagram ends.
  void expect_same_vertices(std::size_t corners) const
  {
    std::vector<P> expected;
    for (auto face = m_graph.finite_faces_begin(); face != m_graph.finite_faces_end(); ++face) {
      const Site_point p = m_graph.primal(face);
      expected.emplace_back(p.x(), p.y());
    }
    const Diagram diagram = SC::voronoi_diagram(m_segments, m_points);
    const Counts numbers = counts(diagram);
    EXPECT_EQ(numbers.tips, corners);
    expect_vertices(diagram, expected, numbers.branching + numbers.passing + numbers.tips);
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
    const double x = CGAL::to_double(arc->source().x()), y = CGAL::to_double(arc->source().y()), u = CGAL::to_double(arc->target().x()), v = CGAL::to_double(arc->target().y());
    result += (x * v - u * y) / 2;
    if (arc->is_circular()) {
      const double square = CGAL::to_double(arc->supporting_circle().squared_radius()), angle = 2 * std::asin((std::min)(1.0, std::hypot(u - x, v - y) / (2 * std::sqrt(square))));
      result += (arc->orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1) * square / 2 * (angle - std::sin(angle));
    }
  }
  return result;
}

TEST(ComparisonsWithCGAL, PolygonsAndApproximatedOffsets)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 0.5), length(2, 6);
  for (int run = 0; run < 10; ++run) {
    const int n = 5 + run % 5;
    CGAL::Polygon_2<K> star;
    CGAL::Polygon_2<Exact_kernel> exact;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * (i + part(random)) / n, radius = length(random);
      star.push_back(P(radius * std::cos(angle), radius * std::sin(angle)));
      exact.push_back(Exact_kernel::Point_2(star[star.size() - 1].x(), star[star.size() - 1].y()));
    }
    const auto region = SC::planar_region(star);
    const auto outer = CGAL::approximated_offset_2(exact, Exact_kernel::FT(0.5), 1e-6);
    double expected = area_with_arcs(outer.outer_boundary());
    for (auto hole = outer.holes_begin(); hole != outer.holes_end(); ++hole)
      expected += area_with_arcs(*hole);
    const auto grown = SC::trimmed_offset(region, 0.5), shrunk = SC::trimmed_offset(region, -0.5);
    EXPECT_TRUE(grown.is_complete());
    EXPECT_NEAR(total_area(grown.polygons_with_holes(1e-5)), expected, 1e-3);
    std::vector<CGAL::Gps_circle_segment_traits_2<Exact_kernel>::Polygon_2> inner;
    CGAL::approximated_inset_2(exact, Exact_kernel::FT(0.5), 1e-6, std::back_inserter(inner));
    EXPECT_FALSE(inner.empty());
    expected = 0;
    for (const auto& polygon : inner)
      expected += std::abs(area_with_arcs(polygon));   // they are clockwise
    EXPECT_TRUE(shrunk.is_complete());
    EXPECT_EQ(shrunk.boundaries().size(), inner.size());
    EXPECT_NEAR(total_area(shrunk.polygons_with_holes(1e-5)), expected, 1e-3);
  }
}

} // namespace
