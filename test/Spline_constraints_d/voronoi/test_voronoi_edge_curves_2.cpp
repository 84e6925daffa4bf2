// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Edges between a point and a curve as exact rational curves: all of their points have exactly the same distance from
// both, and they end where the edges end. Points know the curve that they are on.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_edge_curves_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace voronoi_edge_curves_test {

using Q = SC::Exact_rational;
using E = CGAL::Simple_cartesian<Q>;

TEST(VoronoiEdgeCurves, EquidistantExactly)
{
  const std::vector<SC::Bspline_curve_2<E>> curves{
      SC::bezier_curve(std::vector<E::Point_2>{{0, 0}, {8, 0}}),
      SC::bezier_curve(std::vector<E::Point_2>{{0, 4}, {3, 7}, {5, 3}, {8, 5}})};
  const auto diagram = SC::voronoi_diagram(curves, std::vector<E::Point_2>{{4, 2}});
  ASSERT_TRUE(diagram.is_complete());
  std::size_t found = 0, infinite = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
    const auto& edge = diagram.edges()[e];
    const bool first_is_point = diagram.sites()[edge.sites[0]].is_point;
    const auto curve = SC::exact_edge_curve(diagram, e, curves);
    if (first_is_point == diagram.sites()[edge.sites[1]].is_point) {
      EXPECT_FALSE(curve.has_value());
      continue;
    }
    ASSERT_TRUE(curve.has_value()) << e;
    ++found;
    const std::size_t side = first_is_point ? 1 : 0;
    const auto& piece = diagram.sites()[edge.sites[side]];
    const E::Point_2 point = diagram.sites()[edge.sites[1 - side]].point;
    const auto [begin, end] = curve->domain();
    for (int i = 0; i <= 4; ++i) {
      const Q t(begin + (end - begin) * i / 4);
      const E::Point_2 center = (*curve)(t), foot = curves[*piece.curve](t);
      EXPECT_EQ(CGAL::squared_distance(center, point), CGAL::squared_distance(center, foot));
      if (piece.curve == 0) {   // a parabola over the segment
        EXPECT_EQ(center.x(), foot.x());
        EXPECT_EQ(2 * (point.y() - 0) * center.y(), CGAL::squared_distance(point, E::Point_2(foot.x(), 0)));
      }
    }
    const bool is_reversed = (*edge.parameters[side])[1] < (*edge.parameters[side])[0];
    for (const std::size_t k : {0, 1}) {
      const auto& vertex = diagram.vertices()[edge.vertices[is_reversed ? 1 - k : k]];
      const E::Point_2 last = k == 0 ? (*curve)(begin) : (*curve)(end);
      if (vertex.is_at_infinity)
        ++infinite;
      else
        EXPECT_NEAR(SC::to_nearest_double(CGAL::squared_distance(last, *vertex.point)), 0,
                    1e-16 * (1 + *vertex.radius * *vertex.radius));
    }
  }
  EXPECT_GE(found, 3U);
  EXPECT_THROW((void)SC::exact_edge_curve(diagram, 0, curves, 0.5), SC::Invalid_input);
}

TEST(VoronoiEdgeCurves, PointsKnowTheirCurves)
{
  const Curves curves{bezier({P(0, 0), P(1, 1)}), SC::polyline_curve(std::vector<P>{P(1, 1), P(2, 0), P(3, 0)})};
  const Diagram diagram = SC::voronoi_diagram(curves, {P(9, 9)});
  std::size_t on_curves = 0, isolated = 0;
  for (const auto& site : diagram.sites())
    if (site.is_point && site.curve) {
      ++on_curves;
      EXPECT_EQ(site.parameters[0], site.parameters[1]);
      EXPECT_EQ(curves[*site.curve](site.parameters[0]), site.point);
      EXPECT_EQ(site.curve, site.point.x() <= 1 ? 0U : 1U);   // in the common end, the lower index
    } else
      isolated += site.is_point;
  EXPECT_EQ(on_curves, 4U);
  EXPECT_EQ(isolated, 1U);
}

} // namespace voronoi_edge_curves_test
