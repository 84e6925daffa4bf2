// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Planar operations after exact rotations, translations and scalings: the same numbers of vertices and edges with the
// same parameters, and lengths, areas and distances that are scaled.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace rigid_motions {

namespace SC = CGAL::Spline_constraints;
using R = SC::Exact_rational;
using K = CGAL::Simple_cartesian<R>;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Diagram = SC::Voronoi_diagram_of_curves_2<K>;
using Range = std::pair<R, R>;

struct Motion
{
  R scale, cosine, sine, x, y;

  CGAL::Aff_transformation_2<K> map() const
  {
    const R c(scale * cosine), s(scale * sine);
    return {c, R(-s), x, s, c, y};
  }
  P operator()(const P& p) const { return map()(p); }
  Curves operator()(const Curves& curves) const
  {
    Curves result;
    for (const Curve& curve : curves)
      result.push_back(curve.transformed(map()));
    return result;
  }
};

const std::vector<Motion> motions{{R(1), R(3, 5), R(4, 5), R(0), R(0)},
                                  {R(1), R(-5, 13), R(12, 13), R(17, 3), R(-22, 7)},
                                  {R(1), R(1), R(0), R(1000, 9), R(-1, 3)},
                                  {R(3, 7), R(0), R(-1), R(0), R(1)},
                                  {R(64), R(-24, 25), R(-7, 25), R(-5), R(2)}};

// Those for what takes longer.
const std::vector<Motion> some_motions{motions[1], motions[4]};

R in_64ths(std::mt19937& random, double low, double high)
{
  return R(static_cast<int>(std::round(64 * std::uniform_real_distribution<double>(low, high)(random))), 64);
}

P point_in_cell(std::mt19937& random, double x, double y)
{
  const R left = in_64ths(random, x + 0.5, x + 9.5), low = in_64ths(random, y + 0.5, y + 9.5);
  return P(left, low);
}

Curves curves_in_cells(std::mt19937& random, int count, int degree)
{
  Curves result;
  for (int i = 0; i < count; ++i) {
    std::vector<P> points;
    for (int k = 0; k <= degree; ++k)
      points.push_back(point_in_cell(random, 10 * (i % 3), 10 * (i / 3)));
    result.push_back(SC::bezier_curve(points));
  }
  return result;
}

// A periodic cubic spline around a point, the radii of every other control point of which are multiplied by a number:
// if this is small, there are inflections.
Curve closed_spline(std::mt19937& random, double x, double y, double least, double greatest, int n, double share = 1)
{
  std::vector<R> period;
  std::vector<P> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n,
                 radius = std::uniform_real_distribution<double>(least, greatest)(random) * (i % 2 == 0 ? 1 : share);
    period.emplace_back(i);
    points.emplace_back(R(static_cast<int>(std::round(64 * (x + radius * std::cos(angle)))), 64),
                        R(static_cast<int>(std::round(64 * (y + radius * std::sin(angle)))), 64));
  }
  period.emplace_back(n);
  return Curve::from_periodic(3, period, points);
}

// Both hold the same number.
void expect_common(const Range& a, const Range& b, double most_width = 1e-9)
{
  EXPECT_LE(a.first, b.second);
  EXPECT_LE(b.first, a.second);
  EXPECT_LE(SC::to_nearest_double(R(a.second - a.first)), most_width);
}

Range divided(const Range& range, const R& number) { return {R(range.first / number), R(range.second / number)}; }

// The edges of two boundaries, which may begin with different ones: kinds, curves and ranges of parameters.
struct Boundary_edge
{
  int kind;
  std::array<std::size_t, 2> curves;
  std::array<Range, 2> parameters;
};

bool are_same_boundaries(const std::vector<Boundary_edge>& a, const std::vector<Boundary_edge>& b)
{
  const auto are_same = [](const Boundary_edge& e, const Boundary_edge& f) {
    const auto meet = [](const Range& r, const Range& s) { return r.first <= s.second && s.first <= r.second; };
    return e.kind == f.kind && e.curves == f.curves && meet(e.parameters[0], f.parameters[0]) &&
        meet(e.parameters[1], f.parameters[1]);
  };
  bool is_found = false;
  for (std::size_t shift = 0; shift < b.size() && !is_found; ++shift) {
    std::vector<Boundary_edge> shifted(b);
    std::rotate(shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(shift), shifted.end());
    is_found = std::equal(a.begin(), a.end(), shifted.begin(), shifted.end(), are_same);
  }
  return is_found;
}

void expect_same_boundary(const std::vector<Boundary_edge>& a, const std::vector<Boundary_edge>& b)
{
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  EXPECT_TRUE(are_same_boundaries(a, b));
  for (const Boundary_edge& edge : b)
    for (const Range& range : edge.parameters)
      EXPECT_LE(SC::to_nearest_double(R(range.second - range.first)), 1e-9);
}

template <class Edge>
std::vector<Boundary_edge> boundary(const std::vector<Edge>& edges)
{
  std::vector<Boundary_edge> result;
  for (const Edge& edge : edges)
    result.push_back({static_cast<int>(edge.kind),
                      {edge.source.curve, edge.target.curve},
                      {edge.source.parameters, edge.target.parameters}});
  return result;
}

std::vector<Boundary_edge> boundary(const std::vector<SC::Kernel_edge_2>& edges)
{
  std::vector<Boundary_edge> result;
  for (const SC::Kernel_edge_2& edge : edges)
    result.push_back({static_cast<int>(edge.kind), {edge.curve, edge.curve}, edge.parameters});
  return result;
}

template <class Result>
void expect_same_boundary_and_area(const Result& before, const Result& after, const R& scale)
{
  EXPECT_TRUE(before.is_complete());
  EXPECT_TRUE(after.is_complete());
  expect_same_boundary(boundary(before.edges()), boundary(after.edges()));
  const Range area = divided(after.area(), R(scale * scale));
  EXPECT_GT(area.first, 0);
  expect_common(area, before.area());
}

TEST(RigidMotions, ConvexHulls)
{
  std::mt19937 random(1);
  for (int run = 0; run < 4; ++run) {
    const Curves curves = curves_in_cells(random, 5, 3);
    const std::vector<P> points{point_in_cell(random, 20, 10)};
    const auto hull = SC::convex_hull(curves, points);
    for (const Motion& motion : motions)
      expect_same_boundary_and_area(hull, SC::convex_hull(motion(curves), std::vector<P>{motion(points[0])}),
                                    motion.scale);
  }
}

TEST(RigidMotions, RegionKernels)
{
  std::mt19937 random(2);
  std::size_t edges = 0;
  for (int run = 0; run < 2; ++run) {
    const Curves boundary{closed_spline(random, 1, 2, 5, 6, 8, 0.5)};
    const auto kernel = SC::region_kernel(boundary);
    ASSERT_TRUE(kernel.has_interior());
    edges += kernel.edges().size();
    for (const Motion& motion : some_motions)
      expect_same_boundary_and_area(kernel, SC::region_kernel(motion(boundary)), motion.scale);
  }
  EXPECT_GT(edges, 12U);
}

TEST(RigidMotions, VisibleParts)
{
  std::mt19937 random(3);
  for (int run = 0; run < 4; ++run) {
    Curves curves = curves_in_cells(random, 6, 3);
    curves.push_back(SC::polyline_curve(std::vector<P>{P(-5, -4), P(37, -6), P(34, 25), P(-3, 27), P(-5, -4)}));
    const P viewpoint(13, 10);
    const auto seen = SC::visible_part(viewpoint, curves);
    for (const Motion& motion : motions)
      expect_same_boundary_and_area(seen, SC::visible_part(motion(viewpoint), motion(curves)), motion.scale);
  }
}

TEST(RigidMotions, RegionDistances)
{
  std::mt19937 random(4);
  for (int run = 0; run < 4; ++run) {
    const Curves first{closed_spline(random, 0, 0, 3, 6, 7)}, second{closed_spline(random, 14, 3, 3, 6, 6)};
    const auto distance = SC::region_distance(SC::planar_region(first), SC::planar_region(second));
    EXPECT_TRUE(distance.is_complete());
    EXPECT_GT(distance.squared_distance_range().first, 0);
    for (const Motion& motion : motions) {
      const auto moved = SC::region_distance(SC::planar_region(motion(first)), SC::planar_region(motion(second)));
      EXPECT_TRUE(moved.is_complete());
      expect_common(divided(moved.squared_distance_range(), R(motion.scale * motion.scale)),
                    distance.squared_distance_range());
      ASSERT_EQ(moved.pairs().size(), distance.pairs().size());
      for (std::size_t i = 0; i < moved.pairs().size(); ++i)
        for (const std::size_t k : {0, 1})
          expect_common(moved.pairs()[i].points.parameter_range(k), distance.pairs()[i].points.parameter_range(k),
                        1e-6);
    }
  }
}

// What does not depend on the order of vertices and edges, nor on directions of edges, with radii divided by the scale.
using Vertex_key = std::tuple<std::vector<std::size_t>, bool, double>;
using Edge_key = std::tuple<std::array<std::size_t, 2>, std::array<double, 4>>;

std::vector<Vertex_key> vertex_keys(const Diagram& diagram, double scale)
{
  std::vector<Vertex_key> result;
  for (const auto& vertex : diagram.vertices()) {
    std::vector<std::size_t> sites;
    for (const auto& footpoint : vertex.footpoints)
      sites.push_back(footpoint.site);
    std::sort(sites.begin(), sites.end());
    result.emplace_back(sites, vertex.is_at_infinity, vertex.radius.value_or(0) / scale);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Edge_key> edge_keys(const Diagram& diagram)
{
  const auto ends = [](const auto& parameters) { return parameters.value_or(std::array<double, 2>{-1, -1}); };
  std::vector<Edge_key> result;
  for (const auto& edge : diagram.edges()) {
    const std::array<double, 2> right = ends(edge.parameters[0]), left = ends(edge.parameters[1]);
    const Edge_key forward({edge.sites[0], edge.sites[1]}, {right[0], right[1], left[0], left[1]});
    const Edge_key backward({edge.sites[1], edge.sites[0]}, {left[1], left[0], right[1], right[0]});
    result.push_back((std::min)(forward, backward));
  }
  std::sort(result.begin(), result.end());
  return result;
}

double length(const Diagram& diagram, double error, double most_radius)
{
  double result = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
    const auto samples = diagram.polyline(e, error, most_radius);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      result += std::sqrt(CGAL::to_double(CGAL::squared_distance(samples[i].point, samples[i + 1].point)));
  }
  return result;
}

void expect_same_diagram(const Diagram& before, const Diagram& after, const Motion& motion)
{
  constexpr double most_error = 1e-9, chord_error = 1e-3, most_radius = 50;
  const double scale = CGAL::to_double(motion.scale);
  EXPECT_TRUE(before.is_complete());
  EXPECT_TRUE(after.is_complete());
  ASSERT_EQ(before.sites().size(), after.sites().size());
  for (std::size_t i = 0; i < before.sites().size(); ++i) {
    ASSERT_EQ(before.sites()[i].is_point, after.sites()[i].is_point);
    EXPECT_LE(CGAL::to_double(CGAL::squared_distance(motion(before.sites()[i].point), after.sites()[i].point)),
              most_error * most_error);
  }
  const auto vertices = vertex_keys(before, 1), moved_vertices = vertex_keys(after, scale);
  ASSERT_EQ(vertices.size(), moved_vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(std::get<0>(vertices[i]), std::get<0>(moved_vertices[i]));
    EXPECT_EQ(std::get<1>(vertices[i]), std::get<1>(moved_vertices[i]));
    EXPECT_NEAR(std::get<2>(vertices[i]), std::get<2>(moved_vertices[i]), most_error * (1 + std::get<2>(vertices[i])));
  }
  const auto edges = edge_keys(before), moved_edges = edge_keys(after);
  ASSERT_EQ(edges.size(), moved_edges.size());
  ASSERT_FALSE(edges.empty());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(std::get<0>(edges[i]), std::get<0>(moved_edges[i]));
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(std::get<1>(edges[i])[k], std::get<1>(moved_edges[i])[k], most_error);
  }
  const double expected = length(before, chord_error, most_radius);
  EXPECT_NEAR(length(after, scale * chord_error, scale * most_radius) / scale, expected, 1e-3 * expected);
}

TEST(RigidMotions, MedialAxes)
{
  std::mt19937 random(5);
  const Curves boundary{closed_spline(random, 0, 0, 7, 10, 5), SC::circle_curve(P(-3, -1), R(1, 2))};
  const Diagram axis = SC::medial_axis(SC::planar_region(boundary));
  EXPECT_EQ(axis.number_of_regions(), 2U);
  for (const Motion& motion : some_motions)
    expect_same_diagram(axis, SC::medial_axis(SC::planar_region(motion(boundary))), motion);
}

TEST(RigidMotions, TrimmedBisectors)
{
  std::mt19937 random(6);
  for (int run = 0; run < 2; ++run) {
    const Curves curves = curves_in_cells(random, 2, 2);
    const auto bisector = SC::trimmed_bisector(curves[0], curves[1]);
    ASSERT_EQ(bisector.chains().size(), 1U);
    for (const Motion& motion : some_motions) {
      const Curves moved = motion(curves);
      const auto other = SC::trimmed_bisector(moved[0], moved[1]);
      expect_same_diagram(bisector.diagram(), other.diagram(), motion);
      ASSERT_EQ(other.chains().size(), 1U);
      EXPECT_EQ(bisector.chains()[0].arcs.size(), other.chains()[0].arcs.size());
      EXPECT_EQ(bisector.chains()[0].is_closed, other.chains()[0].is_closed);
    }
  }
}

// With parameters that may differ by 10^-9.
std::vector<Boundary_edge> boundary(const SC::Trimmed_offset_2<K>& offset, std::size_t index)
{
  const R error(1, 2000000000);
  std::vector<Boundary_edge> result;
  for (const std::size_t i : offset.boundaries()[index].arcs) {
    const auto& arc = offset.arcs()[i];
    const auto range = [&](double parameter) {
      return Range(R(SC::to_rational(parameter) - error), R(SC::to_rational(parameter) + error));
    };
    result.push_back({arc.is_circular, {*arc.curve, *arc.curve}, {range(arc.parameters[0]), range(arc.parameters[1])}});
  }
  return result;
}

double area(const SC::Trimmed_offset_2<K>& offset, double error)
{
  double result = 0;
  for (const auto& polygon : offset.polygons_with_holes(error)) {
    result += CGAL::to_double(polygon.outer_boundary().area());
    for (const auto& hole : polygon.holes())
      result += CGAL::to_double(hole.area());
  }
  return result;
}

// Each boundary is that of one of the others, of the same kind.
void expect_same_offset(const SC::Trimmed_offset_2<K>& before, const SC::Trimmed_offset_2<K>& after,
                        const Motion& motion)
{
  constexpr double chord_error = 1e-5;
  const double scale = CGAL::to_double(motion.scale);
  EXPECT_TRUE(before.is_complete());
  EXPECT_TRUE(after.is_complete());
  EXPECT_EQ(before.arcs().size(), after.arcs().size());
  ASSERT_EQ(before.boundaries().size(), after.boundaries().size());
  ASSERT_FALSE(before.boundaries().empty());
  for (std::size_t i = 0; i < before.boundaries().size(); ++i) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < after.boundaries().size(); ++k)
      found += before.boundaries()[i].is_hole == after.boundaries()[k].is_hole &&
          are_same_boundaries(boundary(before, i), boundary(after, k));
    EXPECT_EQ(found, 1U) << "boundary " << i;
  }
  std::vector<P> centers, moved_centers;
  for (const auto& arc : before.arcs())
    if (arc.is_circular)
      centers.push_back(motion(*arc.center));
  for (const auto& arc : after.arcs())
    if (arc.is_circular)
      moved_centers.push_back(*arc.center);
  // exactly
  EXPECT_TRUE(std::is_permutation(centers.begin(), centers.end(), moved_centers.begin(), moved_centers.end()));
  const double expected = area(before, chord_error);
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(area(after, scale * chord_error) / (scale * scale), expected, 1e-6 * expected);
}

// Of curves and a point, and of a region with a hole that grows and shrinks.
TEST(RigidMotions, TrimmedOffsets)
{
  std::mt19937 random(7);
  const Curves curves = curves_in_cells(random, 3, 3);
  const std::vector<P> points{point_in_cell(random, 20, 10)};
  const Curves outline{closed_spline(random, 0, 0, 7, 10, 6),
                       SC::polyline_curve(std::vector<P>{P(-2, -1), P(1, -2), P(0, 2), P(-2, -1)})};
  const R distance(3, 4);
  const auto around_curves = SC::trimmed_offset(curves, distance, points),
             grown = SC::trimmed_offset(SC::planar_region(outline), distance),
             shrunk = SC::trimmed_offset(SC::planar_region(outline), R(-distance));
  EXPECT_TRUE(std::any_of(around_curves.arcs().begin(), around_curves.arcs().end(),
                          [](const auto& arc) { return arc.is_circular; }));
  EXPECT_EQ(grown.boundaries().size(), 2U);
  EXPECT_EQ(shrunk.boundaries().size(), 2U);
  for (const Motion& motion : {Motion{R(1), R(3, 5), R(4, 5), R(17, 3), R(-22, 7)}, motions[4]}) {
    const R moved_distance(motion.scale * distance);
    const auto moved = SC::planar_region(motion(outline));
    expect_same_offset(around_curves, SC::trimmed_offset(motion(curves), moved_distance, {motion(points[0])}), motion);
    expect_same_offset(grown, SC::trimmed_offset(moved, moved_distance), motion);
    expect_same_offset(shrunk, SC::trimmed_offset(moved, R(-moved_distance)), motion);
  }
}

} // namespace rigid_motions
