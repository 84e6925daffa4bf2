// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is true of every Voronoi diagram: Euler's formula, and empty disks that touch both sites of an edge.
#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_VORONOI_CHECKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_VORONOI_CHECKS_H

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Diagram = SC::Voronoi_diagram_of_curves_2<K>;

inline Curve bezier(const std::vector<P>& points) { return SC::bezier_curve(points); }

inline double distance(const P& p, const P& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Of a point of any kernel.
template <class Point>
P rounded(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

// The number of connected components, with all vertices at infinity in one.
template <class Kernel>
std::size_t components(const SC::Voronoi_diagram_of_curves_2<Kernel>& diagram)
{
  std::vector<std::size_t> parent(diagram.vertices().size() + 1);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::size_t v) {
    while (parent[v] != v)
      v = parent[v];
    return v;
  };
  for (std::size_t v = 0; v < diagram.vertices().size(); ++v)
    if (diagram.vertices()[v].is_at_infinity)
      parent[root(v)] = root(diagram.vertices().size());
  for (const auto& edge : diagram.edges())
    parent[root(edge.vertices[0])] = root(edge.vertices[1]);
  std::size_t result = 0;
  for (std::size_t v = 0; v < parent.size(); ++v)
    result += parent[v] == v;
  return result;
}

// V - E + F = 1 + C on the sphere, where infinity is one vertex.
template <class Kernel>
void expect_euler(const SC::Voronoi_diagram_of_curves_2<Kernel>& diagram)
{
  const auto far = std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                                 [](const auto& v) { return v.is_at_infinity; });
  const bool has_far = far > 0;
  const std::size_t vertices = diagram.vertices().size() - static_cast<std::size_t>(far) + has_far,
                    separate = components(diagram) - !has_far;
  EXPECT_EQ(vertices + diagram.number_of_regions(), diagram.edges().size() + 1 + separate);
  EXPECT_EQ(diagram.is_complete(), diagram.undecided().empty());
}

struct Counts
{
  std::size_t tips = 0, passing = 0, branching = 0, far = 0, edges = 0;
  bool operator==(const Counts&) const = default;
};

template <class Kernel>
Counts counts(const SC::Voronoi_diagram_of_curves_2<Kernel>& diagram)
{
  Counts result;
  for (const auto& vertex : diagram.vertices())
    ++(vertex.is_at_infinity          ? result.far
           : vertex.edges.size() <= 1 ? result.tips
           : vertex.edges.size() == 2 ? result.passing
                                      : result.branching);
  result.edges = diagram.edges().size();
  return result;
}

// The bounds of every vertex that is resolved are narrow, and hold what is rounded.
template <class Kernel>
void expect_vertex_bounds(const SC::Voronoi_diagram_of_curves_2<Kernel>& diagram)
{
  for (const auto& vertex : diagram.vertices()) {
    const bool is_proved = vertex.is_resolved && !vertex.is_at_infinity;
    EXPECT_NE(vertex.point.has_value(), vertex.is_at_infinity);
    EXPECT_NE(vertex.radius.has_value(), vertex.is_at_infinity);
    const auto& box = vertex.box;
    EXPECT_EQ(std::isfinite(box.xmax() - box.xmin() + box.ymax() - box.ymin() + vertex.radius_bounds[1]), is_proved);
    if (!is_proved)
      continue;
    const double error = 1e-6 * (1 + *vertex.radius), x = CGAL::to_double(vertex.point->x()),
                 y = CGAL::to_double(vertex.point->y());
    EXPECT_LE((std::max)({x - box.xmin(), box.xmax() - x, y - box.ymin(), box.ymax() - y,
                          *vertex.radius - vertex.radius_bounds[0], vertex.radius_bounds[1] - *vertex.radius}),
              error)
        << "vertex at " << *vertex.point;
    EXPECT_TRUE(box.xmin() <= x && x <= box.xmax() && box.ymin() <= y && y <= box.ymax() &&
                vertex.radius_bounds[0] <= *vertex.radius && *vertex.radius <= vertex.radius_bounds[1])
        << "vertex at " << *vertex.point;
    for (const auto& footpoint : vertex.footpoints)
      if (!diagram.sites()[footpoint.site].is_point) {
        EXPECT_LE((*footpoint.parameter_bounds)[0], *footpoint.parameter);
        EXPECT_LE(*footpoint.parameter, (*footpoint.parameter_bounds)[1]);
      }
  }
}

// Every sample has its radius as the distance from both sites, with bounds as narrow as those of vertices, and nothing
// is nearer than that: not even one of many points on all curves.
template <class Kernel>
void expect_empty_disks(const SC::Voronoi_diagram_of_curves_2<Kernel>& diagram,
                        const std::vector<SC::Bspline_curve_2<Kernel>>& curves, double error = 0.01,
                        double most_radius = 100)
{
  std::vector<P> points;
  for (const auto& site : diagram.sites()) {
    points.push_back(rounded(site.point));
    for (int i = 1; i < 64 && !site.is_point; ++i)
      points.push_back(
          rounded(curves[*site.curve](site.parameters[0] + (site.parameters[1] - site.parameters[0]) * i / 64)));
  }
  std::size_t samples = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, error, most_radius)) {
      const P center = rounded(sample.point);
      ++samples;
      const double most_width = 1e-6 * (1 + sample.radius);
      EXPECT_TRUE(sample.radius - most_width <= sample.radius_bounds[0] &&
                  sample.radius_bounds[0] <= sample.radius * (1 + 1e-14))
          << "edge " << e << " radius " << sample.radius << " at least " << sample.radius_bounds[0];
      EXPECT_TRUE(sample.radius * (1 - 1e-14) <= sample.radius_bounds[1] &&
                  sample.radius_bounds[1] <= sample.radius + most_width)
          << "edge " << e << " radius " << sample.radius << " at most " << sample.radius_bounds[1];
      for (std::size_t side = 0; side < 2; ++side) {
        const auto& site = diagram.sites()[diagram.edges()[e].sites[side]];
        const P foot = rounded(site.is_point ? site.point : curves[*site.curve](*sample.parameters[side]));
        EXPECT_NEAR(distance(center, foot), sample.radius, 1e-8 * (1 + sample.radius))
            << "edge " << e << " side " << side;
      }
      for (const P& p : points)
        EXPECT_GT(distance(center, p), sample.radius - 1e-8 * (1 + sample.radius)) << "edge " << e;
    }
  EXPECT_GT(samples, diagram.edges().size());
  expect_vertex_bounds(diagram);
}

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_VORONOI_CHECKS_H
