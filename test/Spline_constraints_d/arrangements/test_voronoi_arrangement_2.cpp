// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams as arrangements: vertices, edges and faces are those of the diagram, and labels lead to its edges.
#include "arrangement_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Arr_iostream.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace voronoi_arrangement_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;
using Voronoi_arrangement = SC::Voronoi_arrangement_2<K>;

// The numbers of vertices with one edge, and with three or more.
std::pair<std::size_t, std::size_t> ends_and_branches(const Voronoi_arrangement::Arrangement& arrangement)
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
  Curves curves{SC::bezier_curve(std::vector<P>{P(0, 0), P(1, 2), P(2, -2), P(3, 0)}),
                SC::bezier_curve(std::vector<P>{P(0, 3), P(1, 5), P(2, 2), P(3, 4)})};
  for (std::size_t i = 0; i < 4; ++i)
    curves.push_back(SC::bezier_curve(std::vector<P>{corners[i], corners[(i + 1) % 4]}));
  const auto diagram = SC::voronoi_diagram(curves);
  ASSERT_TRUE(diagram.is_complete());
  const auto result = SC::to_arrangement(diagram, 1, 100);
  EXPECT_TRUE(result.has_same_topology);
  const auto count = [&](auto is_wanted) {
    return static_cast<std::size_t>(std::count_if(diagram.vertices().begin(), diagram.vertices().end(), is_wanted));
  };
  EXPECT_EQ(ends_and_branches(result.arrangement),
            std::pair(count([](const auto& v) { return v.edges.size() == 1; }),
                      count([](const auto& v) { return v.edges.size() > 2; })));
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
    EXPECT_EQ(std::count_if(result.arrangement.vertices_begin(), result.arrangement.vertices_end(),
                            [](const auto& v) { return v.degree() == 4; }),
              1);
  };
  expect_one_crossing(
      {SC::bezier_curve(std::vector<P>{P(0, 0), P(4, 1)}), SC::bezier_curve(std::vector<P>{P(1, 3), P(2, -2)})});
  expect_one_crossing({SC::bezier_curve(std::vector<P>{P(0, 0), P(6, 4), P(-2, 4.2), P(4.1, 0.3)})});
}

// The regions of a face that point location finds.
std::vector<std::size_t>
regions_at(const CGAL::Arr_walk_along_line_point_location<Voronoi_arrangement::Arrangement>& location, const P& p)
{
  const auto found = location.locate({p.x(), p.y()});
  const auto* face = get_if<Voronoi_arrangement::Arrangement::Face_const_handle>(&found);
  return face ? (*face)->data() : std::vector<std::size_t>();
}

// The disk around the only vertex, (2, 1), touches all three points: they are footpoints, each in the angle between two
// edges. In a box the cells are faces, and point location finds the nearest point.
TEST(VoronoiArrangement, NearestPointByPointLocation)
{
  const std::vector<P> points{P(0, 0), P(4, 0), P(0, 2)};
  const auto diagram = SC::voronoi_diagram(Curves(), points);
  const auto result = SC::to_arrangement(diagram, 0.01, CGAL::Bbox_2(-2, -3, 7, 5));
  EXPECT_TRUE(result.has_same_topology);
  EXPECT_EQ(result.arrangement.number_of_faces(), 4U);
  EXPECT_EQ(result.arrangement.unbounded_face()->data().size(), 0U);
  std::size_t vertices = 0;
  for (auto v = result.arrangement.vertices_begin(); v != result.arrangement.vertices_end(); ++v)
    if (v->data()) {
      ++vertices;
      const auto& vertex = diagram.vertices()[*v->data()];
      EXPECT_TRUE(vertex.is_resolved);
      ASSERT_EQ(vertex.footpoints.size(), 3U);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(!vertex.footpoints[i].parameter);
        for (const std::size_t edge : {vertex.edges[i], vertex.edges[(i + 1) % 3]}) {
          const auto& sites = diagram.edges()[edge].sites;
          EXPECT_TRUE(vertex.footpoints[i].site == sites[0] || vertex.footpoints[i].site == sites[1]);
        }
      }
    }
  EXPECT_EQ(vertices, 1U);
  const CGAL::Arr_walk_along_line_point_location<Voronoi_arrangement::Arrangement> location(result.arrangement);
  std::set<std::size_t> nearest;
  for (double x = -1.8; x < 7; x += 0.3)
    for (double y = -2.9; y < 5; y += 0.3) {
      const P p(x, y);
      const auto regions = regions_at(location, p);
      ASSERT_EQ(regions.size(), 1U) << p;
      const auto closest = std::min_element(points.begin(), points.end(), [&](const P& a, const P& b) {
        return CGAL::has_smaller_distance_to_point(p, a, b);
      });
      EXPECT_EQ(diagram.sites()[regions.front()].point, *closest) << p;   // each point is a region
      nearest.insert(regions.front());
    }
  EXPECT_EQ(nearest.size(), 3U);
  // in one cell, and without edges
  EXPECT_EQ(SC::to_arrangement(diagram, 0.01, CGAL::Bbox_2(10, -1, 11, 0)).arrangement.number_of_faces(), 2U);
}

// The disk around a sample touches both sites of an edge of the diagram, at the parameters of the sample.
void expect_feet(const SC::Voronoi_diagram_of_curves_2<K>& diagram, const Curves& curves, std::size_t edge,
                 const SC::Voronoi_sample_2<K>& sample)
{
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& site = diagram.sites()[diagram.edges()[edge].sites[side]];
    const P foot = site.is_point ? site.point : curves[*site.curve](*sample.parameters[side]);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(sample.point, foot)), sample.radius, 1e-9 * sample.radius)
        << "edge " << edge << " side " << side << " at " << sample.point;
  }
}

// An edge of the arrangement is all of the chord between two samples, or a part of it that the box cuts.
void expect_chord_of_samples(const Voronoi_arrangement::Arrangement::Halfedge& edge,
                             const SC::Voronoi_sample_2<K>& from, const SC::Voronoi_sample_2<K>& to)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto exact = [](const P& p) { return Exact_kernel::Point_2(p.x(), p.y()); };
  const Exact_kernel::Segment_2 chord(exact(from.point), exact(to.point));
  EXPECT_TRUE(chord.has_on(edge.source()->point()));
  EXPECT_TRUE(chord.has_on(edge.target()->point()));
}

// On the left of each halfedge there is the site that it knows, the disk of each vertex touches its footpoints, and
// labels of edges lead to disks that touch both sites.
TEST(VoronoiArrangement, RecordsKnowTheirSites)
{
  const Curves curves{SC::bezier_curve(std::vector<P>{P(0, 0), P(1, 2), P(2, -2), P(3, 0)}),
                      SC::bezier_curve(std::vector<P>{P(0, 3), P(1, 5), P(2, 2), P(3, 4)})};
  const auto diagram = SC::voronoi_diagram(curves, {P(5, 1)});
  ASSERT_TRUE(diagram.is_complete());
  for (const auto& vertex : diagram.vertices()) {
    EXPECT_EQ(vertex.footpoints.size(), vertex.edges.size());
    for (const auto& footpoint : vertex.footpoints)
      if (!vertex.is_at_infinity) {
        const auto& site = diagram.sites()[footpoint.site];
        const P touched = site.is_point ? site.point : curves[*site.curve](*footpoint.parameter);
        EXPECT_NEAR(std::sqrt(CGAL::squared_distance(*vertex.point, touched)), *vertex.radius, 1e-9);
      }
  }
  const auto result = SC::to_arrangement(diagram, 1e-4, CGAL::Bbox_2(-5, -6, 9, 9));
  EXPECT_TRUE(result.has_same_topology);
  EXPECT_EQ(result.arrangement.number_of_faces(), 4U);
  std::size_t checked = 0;
  for (auto h = result.arrangement.halfedges_begin(); h != result.arrangement.halfedges_end(); ++h)
    if (h->data()) {
      const auto p = CGAL::midpoint(h->source()->point(), h->target()->point());
      const auto d = h->target()->point() - h->source()->point();
      const double length = std::sqrt(CGAL::to_double(d.squared_length()));
      if (length < 0.01)
        continue;
      const double step = 1e-3 / length;   // to the left, farther than the chord is from the edge
      const P left(CGAL::to_double(p.x() - step * d.y()), CGAL::to_double(p.y() + step * d.x()));
      const auto nearest = diagram.nearest_sites(left);
      checked += nearest.size() == 1;
      EXPECT_EQ(diagram.sites()[nearest.front()].region, diagram.sites()[*h->data()].region);
      EXPECT_EQ(h->face()->data(), std::vector<std::size_t>{diagram.sites()[*h->data()].region});
    }
  EXPECT_GT(checked, 100U);
  std::size_t edges_of_diagram = 0, sides_of_box = 0;
  for (auto edge = result.arrangement.edges_begin(); edge != result.arrangement.edges_end(); ++edge) {
    EXPECT_GT(edge->curve().data().size(), 0U);
    for (const auto& label : edge->curve().data())
      if (label.curve < diagram.edges().size()) {
        expect_chord_of_samples(*edge, result.polylines[label.curve][label.chord],
                                result.polylines[label.curve][label.chord + 1]);
        for (const std::size_t i : {label.chord, label.chord + 1})
          expect_feet(diagram, curves, label.curve, result.polylines[label.curve][i]);
        ++edges_of_diagram;
      } else {
        EXPECT_EQ(label.curve, diagram.edges().size());
        EXPECT_LT(label.chord, 4U);
        ++sides_of_box;
      }
  }
  EXPECT_GT(edges_of_diagram, 100U);
  EXPECT_GE(sides_of_box, 4U);
}

// CGAL's streams know the geometry, without labels and records.
TEST(VoronoiArrangement, Streams)
{
  const auto result = SC::to_arrangement(
      SC::voronoi_diagram(std::vector{SC::bezier_curve(std::vector<P>{P(0, 0), P(1, 2), P(3, -1), P(4, 1)})},
                          std::vector<P>{P(1, 2), P(3, 2)}),
      0.01, CGAL::Bbox_2(-2, -2, 6, 4));
  Voronoi_arrangement::Arrangement back;
  std::stringstream stream;
  stream.precision(17);
  stream << result.arrangement;
  stream >> back;
  EXPECT_GT(back.number_of_faces(), 3U);
  EXPECT_EQ(back.number_of_vertices(), result.arrangement.number_of_vertices());
  EXPECT_EQ(back.number_of_edges(), result.arrangement.number_of_edges());
  EXPECT_EQ(back.number_of_faces(), result.arrangement.number_of_faces());
}

TEST(VoronoiArrangement, BadInput)
{
  const auto diagram = SC::voronoi_diagram(Curves(), {P(0, 0), P(4, 0)});
  EXPECT_THROW(SC::to_arrangement(diagram, 0.1, CGAL::Bbox_2(0, 0, 0, 1)), SC::Invalid_input);
  EXPECT_THROW(SC::to_arrangement(SC::voronoi_diagram(Curves()), 0.1, CGAL::Bbox_2(0, 0, 1, 1)), SC::Invalid_input);
  EXPECT_THROW(SC::to_arrangement(diagram, 0, 10), SC::Invalid_input);
  EXPECT_THROW(SC::to_arrangement(diagram, 0.1, std::numeric_limits<double>::infinity()), SC::Invalid_input);
  for (const double size : {1e80, 1e140, 1e200, 1e300, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(SC::to_arrangement(diagram, size / 100, CGAL::Bbox_2(-size, -1, 1, 1)), SC::Invalid_input);
  for (const double error : {std::numeric_limits<double>::quiet_NaN(), -1.0, 0.0, 1e-300, 1e-9, 1e14})
    EXPECT_THROW(SC::to_arrangement(diagram, error, CGAL::Bbox_2(-1, -1e30, 1, 1e30)), SC::Invalid_input);
  const auto fine = SC::to_arrangement(diagram, 1e-8, CGAL::Bbox_2(-1, -1e6, 5, 1e6));
  EXPECT_TRUE(fine.has_same_topology);
  EXPECT_EQ(fine.arrangement.number_of_faces(), 3U);
  // doubles do not tell parameters of so large disks
  const auto large = SC::to_arrangement(diagram, 1e20, CGAL::Bbox_2(-1, -1e30, 5, 1e30));
  EXPECT_TRUE(large.has_same_topology);
  EXPECT_EQ(large.arrangement.number_of_faces(), 3U);
  for (const double far : {1e80, -1e160, 1e300})
    EXPECT_THROW((void)diagram.nearest_sites(P(1, far)), SC::Invalid_input);
  EXPECT_EQ(diagram.nearest_sites(P(1, 1e-300)), std::vector<std::size_t>{0});
}

// What bounds in doubles can tell is decided, all else refused: none of it is without an answer, or without an end.
TEST(VoronoiArrangement, Magnitudes)
{
  const auto segment = [](double size) { return SC::bezier_curve(std::vector<P>{{0, 0}, {size, size}}); };
  const auto triangle = [](double size) {
    return SC::planar_region(SC::polyline_curve(std::vector<P>{{0, 0}, {size, 0}, {0, size}, {0, 0}}));
  };
  for (const double size : {1e-75, 1e-30, 1e30, 1e74}) {
    const auto diagram = SC::voronoi_diagram(Curves{segment(size)}, {P(0, size)});
    EXPECT_TRUE(diagram.is_complete());
    EXPECT_EQ(diagram.nearest_sites(P(0.1 * size, 0.9 * size)).size(), 1U);
    EXPECT_EQ(SC::to_arrangement(diagram, 0.01 * size, CGAL::Bbox_2(-size, -size, 2 * size, 2 * size))
                  .arrangement.number_of_faces(),
              3U);
    EXPECT_TRUE(SC::trimmed_bisector(segment(size), P(0, size)).is_complete());
    EXPECT_EQ(SC::medial_axis(triangle(size)).edges().size(), 3U);
  }
  for (const double size : {1e-300, 1e-200, 1e-100, 1e100, 1e150, 1e200, 1e300}) {
    EXPECT_THROW(SC::voronoi_diagram(Curves{segment(size)}), SC::Invalid_input);
    EXPECT_THROW(SC::voronoi_diagram(Curves(), {P(0, 0), P(size, 0)}), SC::Invalid_input);
    EXPECT_THROW(SC::trimmed_bisector(segment(size), P(0, size)), SC::Invalid_input);
    EXPECT_THROW(SC::trimmed_bisector(P(0, 0), P(0, size)), SC::Invalid_input);
    EXPECT_THROW(SC::trimmed_self_bisector(segment(size)), SC::Invalid_input);
    EXPECT_THROW(SC::medial_axis(triangle(size)), SC::Invalid_input);
  }
}

} // namespace voronoi_arrangement_2_test
