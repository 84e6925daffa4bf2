// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The level above doubles of trimmed offsets: curves that are nearly twice the distance apart, or nearly parallel at
// it. What differs is far below the rounding errors of doubles; the ends of arcs are known in closed form.
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fine_offsets_2_test {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using K = CGAL::Simple_cartesian<Exact_rational>;
using P = K::Point_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;
using Offset = SC::Trimmed_offset_2<K>;

Exact_rational power_of_half(int exponent)
{
  Exact_rational result(1);
  for (int i = 0; i < exponent; ++i)
    result /= 2;
  return result;
}

// y = height + bend (x - center)^2 for x from begin to end.
SC::Bspline_curve_2<K> parabola(const Exact_rational& begin, const Exact_rational& end, const Exact_rational& center,
                                const Exact_rational& height, const Exact_rational& bend)
{
  const auto y = [&](const Exact_rational& x) { return Exact_rational(height + bend * (x - center) * (x - center)); };
  const Exact_rational middle = (begin + end) / 2;
  return SC::bezier_curve(std::vector<P>{
      P(begin, y(begin)), P(middle, Exact_rational(y(begin) + 2 * bend * (begin - center) * (middle - begin))),
      P(end, y(end))});
}

SC::Bspline_curve_2<K> segment(const P& p, const P& q) { return SC::bezier_curve(std::vector<P>{p, q}); }

std::size_t number_of_components(const Offset& offset)
{
  EXPECT_TRUE(offset.is_complete());
  return static_cast<std::size_t>(std::count_if(offset.boundaries().begin(), offset.boundaries().end(),
                                                [](const auto& boundary) { return !boundary.is_hole; }));
}

// The parameters where arcs of a curve begin or end inside of it, in order.
std::vector<double> cuts(const Offset& offset, std::size_t curve)
{
  std::vector<double> result;
  for (const auto& arc : offset.arcs())
    if (!arc.is_circular && arc.curve == curve)
      for (const double t : arc.parameters)
        if (t > 0 && t < 1)
          result.push_back(t);
  std::sort(result.begin(), result.end());
  return result;
}

// Two parabolas y = a +- (1 + gap + x^2 / 4) that do not touch: disks in the middle are free, or, with a negative gap,
// covered between two crossings. There the center is on the axis: with the slope x/2, 1 + gap + x^2 / 4 = 1 / sqrt(1 +
// x^2 / 4).
TEST(FineOffsets, GapBetweenParabolas)
{
  for (const int exponent : {40, 52, 60, 80}) {
    const Exact_rational gap = power_of_half(exponent), center(Exact_rational(1) / 7);
    const auto parabolas = [&](const Exact_rational& g) {
      return Curves{parabola(-1, 2, center, Exact_rational(-1 - g), Exact_rational(-1) / 4),
                    parabola(-2, 2, center, Exact_rational(1 + g), Exact_rational(1) / 4)};
    };
    const Offset apart = SC::trimmed_offset(parabolas(gap), 1), together = SC::trimmed_offset(parabolas(-gap), 1);
    EXPECT_EQ(number_of_components(apart), 2U) << exponent;
    EXPECT_EQ(apart.arcs().size(), 8U);
    EXPECT_EQ(number_of_components(together), 1U) << exponent;
    EXPECT_EQ(together.arcs().size(), 10U);
    const double way = std::sqrt(8.0 / 3) * std::exp2(-exponent / 2);   // of x from the center, as far as it is small
    for (const std::size_t curve : {0U, 1U}) {
      const std::vector<double> ends = cuts(together, curve);
      ASSERT_EQ(ends.size(), 2U);
      const double length = curve == 0 ? 3 : 4;
      EXPECT_NEAR((ends[1] - ends[0]) * length / (2 * way), 1, 2e-3) << exponent;
      EXPECT_NEAR((ends[0] + ends[1]) / 2 * length, 1.0 / 7 + (curve == 0 ? 1 : 2), 1e-12 + way * way);
    }
  }
}

// At twice the distance, but for a tiny angle: one end of the gap is closed.
TEST(FineOffsets, SegmentsThatAreNearlyParallel)
{
  for (const int exponent : {40, 60, 80}) {
    const Exact_rational rise = power_of_half(exponent);
    const Offset offset = SC::trimmed_offset(
        Curves{segment(P(0, 0), P(3, 0)), segment(P(0, Exact_rational(2 - rise)), P(3, Exact_rational(2 + 2 * rise)))},
        1);
    EXPECT_EQ(number_of_components(offset), 1U) << exponent;
    EXPECT_EQ(offset.arcs().size(), 8U);
    for (const std::size_t curve : {0U, 1U}) {
      const std::vector<double> ends = cuts(offset, curve);
      ASSERT_EQ(ends.size(), 1U);
      // contacts are told by doubles, and distances by twice their bits
      EXPECT_NEAR(ends[0], 1.0 / 3, 1e-12 + std::exp2(exponent - 100));
    }
  }
}

// A point that is nearly twice the distance away from a segment: the centers of disks that touch both are at sqrt(1 -
// (1 - gap)^2) from its foot.
TEST(FineOffsets, PointOppositeToSegment)
{
  for (const int exponent : {52, 60, 80}) {
    const Exact_rational gap = power_of_half(exponent), foot(Exact_rational(8) / 7);
    const auto offset = [&](const Exact_rational& g) {
      return SC::trimmed_offset(Curves{segment(P(0, 0), P(3, 0))}, 1, {P(foot, Exact_rational(2 + g))});
    };
    EXPECT_EQ(number_of_components(offset(gap)), 2U) << exponent;
    const Offset together = offset(-gap);
    EXPECT_EQ(number_of_components(together), 1U) << exponent;
    const std::vector<double> ends = cuts(together, 0);
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR((ends[1] - ends[0]) * 3 / (2 * std::sqrt(2.0) * std::exp2(-exponent / 2)), 1, 2e-3) << exponent;
  }
}

} // namespace fine_offsets_2_test
