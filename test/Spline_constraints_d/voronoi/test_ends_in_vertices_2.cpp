// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of arcs that end in a vertex of their curve, where the derivative of the curvature is zero, as half
// a parabola does, or next to one: alone, in corners, and where two of them join.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/powers_of_zeros.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace ends_in_vertices_2_test {

// y = x^2 / scale, from the vertex to the right.
Curve half_parabola(double scale = 1) { return bezier({P(0, 0), P(0.5 * scale, 0), P(scale, scale)}); }

Curve mirrored(const Curve& curve) { return curve.transformed(K::Aff_transformation_2(-1, 0, 0, 1)); }

// A quarter of the ellipse with the half axes |a| and |b|, from (a, 0) to (0, b).
Curve quarter_ellipse(double a, double b) { return SC::bezier_curve<K>({P(a, 0), P(a, b), P(0, b)}, {1, 1, 2}); }

void expect_valid(const Diagram& diagram, const Curves& curves)
{
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves, 0.02, 20);
}

// The number of vertices in which an edge ends that have a radius and are at a point.
std::size_t tips(const Diagram& diagram, const P& p, double radius)
{
  return static_cast<std::size_t>(
      std::count_if(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
        return !v.is_at_infinity && v.edges.size() == 1 && distance(*v.point, p) < 1e-9 &&
            std::abs(*v.radius - radius) < 1e-9;
      }));
}

// The disk that touches (t, t^2) and the vertex of the parabola has the center (-t^3, (1 + 3 t^2) / 2).
TEST(EndsInVertices, HalfParabola)
{
  for (const bool is_mirrored : {false, true}) {
    const double side = is_mirrored ? -1 : 1;
    const Curves curves{is_mirrored ? mirrored(half_parabola()) : half_parabola()};
    const Diagram diagram = SC::voronoi_diagram(curves);
    expect_valid(diagram, curves);
    EXPECT_EQ(tips(diagram, P(0, 0.5), 0.5), 1U);
    EXPECT_EQ(diagram.edges().size(), 2U);   // behind it, that of both ends
    std::size_t samples = 0;
    for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
      const auto& sites = diagram.edges()[e].sites;
      const std::size_t arc = diagram.sites()[sites[0]].is_point ? 1 : 0;
      if (diagram.sites()[sites[arc]].is_point)
        continue;
      for (const auto& sample : diagram.polyline(e, 0.001, 100)) {
        ++samples;
        const double t = *sample.parameters[arc];
        EXPECT_NEAR(CGAL::to_double(sample.point.x()), -side * t * t * t, 1e-9);
        EXPECT_NEAR(CGAL::to_double(sample.point.y()), (1 + 3 * t * t) / 2, 1e-9);
      }
    }
    EXPECT_GT(samples, 10U);
  }
}

const K::Aff_transformation_2 rotated_and_scaled(1.1, -0.3, 3.1, 0.3, 1.1, 2.7);

// y = h x / 2 + (1 - h) x^2 / 8 has its vertex just behind the end of the arc, or for h < 0 before it, where x = 2 |h|
// / (1 + |h|): then there is a tip in the center of curvature, and the edge from there goes over from the arc to its
// end.
TEST(EndsInVertices, VerticesNextToEnds)
{
  const auto arc = [](double h) { return bezier({P(0, 0), P(2, h), P(4, 2)}); };
  for (int digits = 4; digits <= 15; ++digits) {
    const double h = std::pow(10., -digits);
    for (const bool is_inside : {false, true}) {
      const Curve curve = arc(is_inside ? -h : h), rotated = curve.transformed(rotated_and_scaled);
      const Diagram diagram = SC::voronoi_diagram(Curves{curve});
      expect_valid(diagram, {curve});
      EXPECT_EQ(diagram.edges().size(), is_inside ? 3U : 2U) << "h = " << h;
      EXPECT_EQ(tips(diagram, is_inside ? P(2 * h / (1 + h), (4 - h * h / 2) / (1 + h)) : P(0, 4),
                     is_inside ? 4 / (1 + h) : 4),
                digits > 9 || is_inside ? 1U : 0U)
          << "h = " << h;
      expect_valid(SC::voronoi_diagram(Curves{rotated}), {rotated});
    }
  }
}

// Two arcs that leave a point with directions that differ by a tiny angle: each of them is hidden from the other side
// of the other one.
TEST(EndsInVertices, ThinCorners)
{
  for (int digits = 4; digits <= 15; ++digits) {
    const double height = std::pow(10., -digits);
    const Curves curves{bezier({P(0, 0), P(4, 0)}), bezier({P(0, 0), P(2, height), P(4, 1)})},
        rotated{curves[0].transformed(rotated_and_scaled),
                bezier({P(3.1, 2.7), P(5.3 - 0.3 * height, 3.3 + 1.1 * height), P(7.2, 5)})};
    for (const Curves& corner : {curves, rotated}) {
      const Diagram diagram = SC::voronoi_diagram(corner);
      expect_valid(diagram, corner);
      EXPECT_EQ(tips(diagram, rounded(corner[0](0)), 0), 1U) << "height " << height;
    }
  }
}

// Two halves are the whole: the diagram is the part of the axis above the center of curvature.
TEST(EndsInVertices, HalvesThatGoOnInEachOther)
{
  const Curves same{half_parabola(), mirrored(half_parabola())};
  const Diagram diagram = SC::voronoi_diagram(same);
  expect_valid(diagram, same);
  EXPECT_EQ(tips(diagram, P(0, 0.5), 0.5), 1U);
  EXPECT_EQ(diagram.edges().size(), 2U);

  // The edge ends in the center of the greater curvature, whichever half that is of.
  for (const double scale : {0.5, 2.}) {
    const Curves curves{half_parabola(), mirrored(half_parabola(scale))};
    const Diagram other = SC::voronoi_diagram(curves);
    expect_valid(other, curves);
    const double radius = (std::min)(1., scale) / 2;
    EXPECT_EQ(tips(other, P(0, radius), radius), 1U);
  }
}

// A segment goes on tangentially, or leaves the vertex in a corner.
TEST(EndsInVertices, SegmentsAtTheVertex)
{
  for (const P& end : {P(-2, 0), P(-1, -0.5), P(-0.25, -1)}) {
    const Curves curves{half_parabola(), bezier({P(0, 0), end})};
    const Diagram diagram = SC::voronoi_diagram(curves);
    expect_valid(diagram, curves);
    EXPECT_EQ(tips(diagram, P(0, 0.5), 0.5), 1U);
  }
}

// The axis of an ellipse of half axes 2 and 1 ends in (3/2, 0). So does that of an egg of two halves, the other one
// with half axes 2 and 3/2: the curvature is greatest where they join.
TEST(EndsInVertices, EllipsesAndEggs)
{
  const Curves half{quarter_ellipse(2, 1), quarter_ellipse(-2, 1)};
  const Diagram diagram = SC::voronoi_diagram(half);
  expect_valid(diagram, half);
  EXPECT_EQ(tips(diagram, P(1.5, 0), 0.5), 1U);
  EXPECT_EQ(tips(diagram, P(-1.5, 0), 0.5), 1U);

  const Curves egg{quarter_ellipse(2, 1), quarter_ellipse(-2, 1), quarter_ellipse(-2, -1.5), quarter_ellipse(2, -1.5)};
  const Diagram axis = SC::medial_axis(SC::planar_region(egg));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.vertices().size(), axis.edges().size() + 1);
  EXPECT_EQ(tips(axis, P(1.5, 0), 0.5), 1U);
  EXPECT_EQ(tips(axis, P(-1.5, 0), 0.5), 1U);
  EXPECT_EQ(counts(axis).tips, 2U);
}

// Where a circle joins an ellipse in its vertex.
TEST(EndsInVertices, CircleAtTheVertex)
{
  for (const double radius : {0.25, 1.5}) {
    const Curves curves{quarter_ellipse(2, 1),
                        SC::bezier_curve<K>({P(2, 0), P(2, -radius), P(2 - radius, -radius)}, {1, 1, 2})};
    const Diagram diagram = SC::voronoi_diagram(curves);
    expect_valid(diagram, curves);
    const double least = (std::min)(radius, 0.5);
    EXPECT_EQ(tips(diagram, P(2 - least, 0), least), 1U);
  }
}

// The first halves of symmetric cubics end in vertices, in any place and direction.
TEST(EndsInVertices, HalvesOfSymmetricCubics)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> number(1, 15);
  for (int i = 0; i < 12; ++i) {
    const double x = number(random), z = number(random), y = number(random), c = number(random), s = number(random);
    const auto at = [&](double u, double v) { return P(c * u - s * v, s * u + c * v); };
    // (0,0), (-x,y), (z+x,y), (z,0), halved
    const Curves curves{
        bezier({at(0, 0), at(-x / 2, y / 2), at((z - 2 * x) / 4 + x / 4, 0.75 * y), at(z / 2, 0.75 * y)})};
    const Diagram diagram = SC::voronoi_diagram(curves);
    EXPECT_TRUE(diagram.is_complete()) << x << ' ' << z << ' ' << y;
    expect_euler(diagram);
    expect_empty_disks(diagram, curves, 1, 1000);
  }
}

// Only one edge of the Newton polygon of 16 a^5 - 2 a b (a + b) - 2 b^5 has ends of different signs: there 8 a^3 is
// nearly b.
TEST(EndsInVertices, PowersOfZeros)
{
  const auto a = SC::Power_polynomial::variable(0), b = SC::Power_polynomial::variable(1);
  const auto times = [](int factor, const SC::Power_polynomial& p) { return SC::Power_polynomial(factor) * p; };
  using Powers = std::pair<int, int>;
  EXPECT_EQ(
      SC::internal::Voronoi::powers_of_zeros(times(16, pow(a, 5)) - times(2, a * b * (a + b)) - times(2, pow(b, 5))),
      Powers(1, 3));
  EXPECT_EQ(SC::internal::Voronoi::powers_of_zeros(a - pow(b, 3)), Powers(3, 1));
  EXPECT_EQ(SC::internal::Voronoi::powers_of_zeros(a * pow(b, 2) - pow(a, 2) * b), Powers(1, 1));
  EXPECT_FALSE(SC::internal::Voronoi::powers_of_zeros(a + pow(b, 3)).has_value());
  EXPECT_FALSE(SC::internal::Voronoi::powers_of_zeros(pow(a, 4) - a * b + pow(b, 4)).has_value());
  EXPECT_FALSE(SC::internal::Voronoi::powers_of_zeros(SC::Power_polynomial()).has_value());
}

} // namespace ends_in_vertices_2_test
