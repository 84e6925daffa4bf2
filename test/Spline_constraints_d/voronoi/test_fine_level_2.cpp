// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The level above doubles of Voronoi diagrams: its numbers and enclosures against exact rational ones, and diagrams
// that doubles cannot decide.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Nearest_sites_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Fine_level.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Envelope_arc_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Maximal_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Disk_reach.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/site_graphs_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

using SC::Exact_rational;
using SC::internal::Exact_pair;
using SC::internal::Common::Exact_arc_2;
using SC::internal::Common::Fine_interval;
using SC::internal::Common::Interval;
using SC::internal::Common::Range;

// The least of what the enclosures of sites ask of a number.
class Least_number
{
  Interval m_x{0};

  Least_number(const Interval& x, int) : m_x(x) {}

public:
  Least_number() = default;
  Least_number(double x) : m_x(x) {}
  Least_number(double lower, double upper) : m_x(lower, upper) {}
  Least_number(const Interval& x) : m_x(x) {}
  explicit Least_number(const Exact_rational& x) : m_x(SC::internal::Common::interval_of(x)) {}

  double inf() const { return m_x.inf(); }
  double sup() const { return m_x.sup(); }

  Least_number& operator+=(const Least_number& y)
  {
    m_x += y.m_x;
    return *this;
  }
  Least_number& operator-=(const Least_number& y)
  {
    m_x -= y.m_x;
    return *this;
  }
  Least_number& operator*=(const Least_number& y)
  {
    m_x *= y.m_x;
    return *this;
  }
  Least_number& operator/=(const Least_number& y)
  {
    m_x /= y.m_x;
    return *this;
  }
  friend Least_number operator-(const Least_number& x) { return {-x.m_x, 0}; }
  friend Least_number operator+(Least_number x, const Least_number& y) { return x += y; }
  friend Least_number operator-(Least_number x, const Least_number& y) { return x -= y; }
  friend Least_number operator*(Least_number x, const Least_number& y) { return x *= y; }
  friend Least_number operator/(Least_number x, const Least_number& y) { return x /= y; }
  friend Least_number hull(const Least_number& x, const Least_number& y)
  {
    return {SC::internal::Common::hull(x.m_x, y.m_x), 0};
  }
  friend Least_number common_part(const Least_number& x, const Least_number& y)
  {
    return {SC::internal::Common::common_part(x.m_x, y.m_x), 0};
  }
};

namespace CGAL {

template <>
class Algebraic_structure_traits<Least_number>
  : public Algebraic_structure_traits_base<Least_number, Field_with_sqrt_tag>
{
public:
  struct Square
  {
    using argument_type = Least_number;
    using result_type = Least_number;
    Least_number operator()(const Least_number& x) const { return x * x; }
  };

  struct Sqrt
  {
    using argument_type = Least_number;
    using result_type = Least_number;
    Least_number operator()(const Least_number& x) const
    {
      return {std::sqrt(x.inf()) * (1 - 0x1p-50), std::sqrt(x.sup()) * (1 + 0x1p-50)};
    }
  };
};

} // namespace CGAL

static_assert(SC::internal::Common::Enclosing_number<Least_number> &&
              SC::internal::Common::Enclosing_number<Fine_interval>);
template class SC::internal::Voronoi::Disk_curvature<Least_number>;
template class SC::internal::Voronoi::Disk_reach<Least_number>;
template class SC::internal::Voronoi::Nearest_sites<Least_number>;

namespace fine_level_2_test {

SC::internal::Common::Homogeneous_piece random_piece(std::mt19937& random, bool is_rational)
{
  std::uniform_int_distribution<int> coordinate(-1000, 1000), weight(1, 9);
  std::array<std::vector<Exact_rational>, 3> c;
  for (int i = 0; i < 4; ++i) {
    const Exact_rational w(is_rational ? weight(random) : 1);
    c[0].push_back(w * coordinate(random) / 7);
    c[1].push_back(w * coordinate(random) / 7);
    c[2].push_back(w);
  }
  return {{0, 1},
          {SC::Bernstein_tensor<Exact_rational>({3}, c[0]), SC::Bernstein_tensor<Exact_rational>({3}, c[1]),
           SC::Bernstein_tensor<Exact_rational>({3}, c[2])}};
}

// Whether a number is enclosed, up to an error relative to some size: the distance is computed on the fine level.
bool is_enclosed_within(const Fine_interval& x, const Exact_rational& exact, double error)
{
  const Fine_interval difference = x - Fine_interval(exact);
  return difference.inf() <= 0 && difference.sup() >= 0 && difference.sup() - difference.inf() <= error;
}

TEST(FineLevel, NumbersEncloseExactOnes)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> part(-100000, 100000);
  for (int i = 0; i < 1000; ++i) {
    const Exact_rational a = Exact_rational(part(random)) / 99991, b = Exact_rational(part(random) + 200001) / 99989;
    const Fine_interval x(a), y(b);
    EXPECT_TRUE(is_enclosed_within(x + y, a + b, 0x1p-120));
    EXPECT_TRUE(is_enclosed_within(x - y, a - b, 0x1p-120));
    EXPECT_TRUE(is_enclosed_within(x * y, a * b, 0x1p-120));
    EXPECT_TRUE(is_enclosed_within(x / y, a / b, 0x1p-120));
    EXPECT_TRUE(is_enclosed_within(CGAL::square(x), a * a, 0x1p-120));
    EXPECT_TRUE(is_enclosed_within(CGAL::square(CGAL::sqrt(y)), b, 0x1p-120));
    EXPECT_TRUE(is_enclosed_within(common_part(hull(x, y), x), a, 0x1p-120));
    EXPECT_LE(hull(x, y).inf(), (std::min)(x.inf(), y.inf()));
    EXPECT_GE(hull(x, y).sup(), (std::max)(x.sup(), y.sup()));
  }
}

TEST(FineLevel, NumbersThatAreNotBoundedEncloseAll)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const Fine_interval& x : {Fine_interval(nan), Fine_interval(nan, 1), Fine_interval(2, 1),
                                 Fine_interval(infinity), Fine_interval(1) / Fine_interval(-1, 1),
                                 Fine_interval(-infinity, infinity) - Fine_interval(-infinity, infinity)}) {
    EXPECT_EQ(x.inf(), -infinity);
    EXPECT_EQ(x.sup(), infinity);
    EXPECT_EQ(SC::internal::Common::certain_sign(x), 0);
  }
  EXPECT_EQ((Fine_interval(0) * Fine_interval(-infinity, infinity)).sup(), 0);
  EXPECT_EQ(CGAL::square(Fine_interval(-2, 1)).inf(), 0);
  EXPECT_EQ(SC::internal::Common::certain_sign(Fine_interval(0x1p-1074)), 1);
}

// In points, with 100 bits; over ranges, inside of the enclosures in doubles.
TEST(FineLevel, EnclosuresOfArcs)
{
  const SC::Upward_rounding_guard guard;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> parameter(0, 1);
  for (int i = 0; i < 40; ++i) {
    const Exact_arc_2 exact(random_piece(random, i % 2 == 1));
    const SC::internal::Common::Site_arc_2<> arc(exact);
    const SC::internal::Common::Site_arc_2<Fine_interval> fine(exact);
    for (int j = 0; j < 10; ++j) {
      const double u = parameter(random), v = u + (1 - u) * parameter(random);
      const auto at = fine.jet({u, u});
      const Exact_pair point = exact.at(Exact_rational(u)), derivative = exact.derivative_at(Exact_rational(u));
      const auto over = fine.jet({u, v});
      const auto in_doubles = arc.jet({u, v});
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(is_enclosed_within(at[0][k], point[k], 0x1p-100));
        EXPECT_TRUE(is_enclosed_within(at[1][k], derivative[k], 0x1p-100));
        for (std::size_t order = 0; order <= SC::internal::Common::jet_order; ++order) {
          EXPECT_GE(over[order][k].inf(), in_doubles[order][k].inf());
          EXPECT_LE(over[order][k].sup(), in_doubles[order][k].sup());
        }
      }
    }
  }
}

// Four cubics that are nearly an ellipse, with control points rounded: they join nearly smoothly, and their disks touch
// all of them nearly.
Curves rounded_ellipse(double angle, double ratio, double unit)
{
  constexpr double k = 0.552285;
  const auto rounded = [&](double x) { return std::round(x / unit) * unit; };
  const auto at = [&](double x, double y) {
    return P(rounded(std::cos(angle) * x - std::sin(angle) * ratio * y),
             rounded(std::sin(angle) * x + std::cos(angle) * ratio * y));
  };
  Curves result;
  double x = 1, y = 0;
  for (int i = 0; i < 4; ++i) {
    const double next_x = -y, next_y = x;
    result.push_back(
        bezier({at(x, y), at(x + k * next_x, y + k * next_y), at(next_x + k * x, next_y + k * y), at(next_x, next_y)}));
    x = next_x;
    y = next_y;
  }
  return result;
}

// Its medial axis. With doubles alone some vertices stay unresolved.
TEST(FineLevel, RoundedEllipse)
{
  const Curves curves = rounded_ellipse(0.33, 1.5, 0x1p-24);
  const auto region = SC::planar_region(curves);
  const Diagram diagram = SC::medial_axis(region);
  EXPECT_FALSE(SC::medial_axis(region, {.ladder_precision = 64}).is_complete());
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.edges().size(), 13U);
  EXPECT_EQ(diagram.vertices().size(), 14U);
  expect_empty_disks(diagram, curves, 0.05, 20);
}

// Envelope arcs of elements, of each fourth one, follow each other, up to ranges that hold an event, or are said to be
// unresolved.
void expect_nothing_left_out(const Curves& curves)
{
  using SC::internal::Voronoi::Disk_event;
  constexpr double widest_event = 0x1p-12;
  const SC::Upward_rounding_guard guard;
  const auto graph = SC::internal::Voronoi::site_graph(curves, std::vector<P>());
  const SC::internal::Voronoi::Site_tree_2 tree(*graph);
  const SC::internal::Voronoi::Cusps_2 cusps = SC::internal::Voronoi::Cusp_finder_2(*graph, tree)();
  const SC::internal::Voronoi::Fine_level fine_level(*graph);
  for (std::size_t f = 0; f < graph->elements().size(); f += 4) {
    SCOPED_TRACE(f);
    const auto envelope_arcs = SC::internal::Voronoi::Maximal_disks<>(*graph, tree, cusps, &fine_level)(f);
    ASSERT_FALSE(envelope_arcs.empty());
    EXPECT_TRUE(envelope_arcs.front().range.begin == 0 || envelope_arcs.front().events[0] == Disk_event::UNRESOLVED);
    EXPECT_TRUE(envelope_arcs.back().range.end == 1 || envelope_arcs.back().events[1] == Disk_event::UNRESOLVED);
    for (std::size_t i = 0; i < envelope_arcs.size(); ++i) {
      const auto& boxes = envelope_arcs[i].boxes;
      for (std::size_t k = 1; k < boxes.size(); ++k)
        EXPECT_EQ(boxes[k - 1].first.end, boxes[k].first.begin);
      EXPECT_EQ(boxes.front().first.begin, envelope_arcs[i].range.begin);
      EXPECT_EQ(boxes.back().first.end, envelope_arcs[i].range.end);
      if (i > 0) {
        const Disk_event event = envelope_arcs[i].events[0];
        const double gap = envelope_arcs[i].range.begin - envelope_arcs[i - 1].range.end;
        EXPECT_EQ(envelope_arcs[i - 1].events[1], event);
        EXPECT_TRUE(event == Disk_event::UNRESOLVED || (event != Disk_event::NONE && 0 <= gap && gap <= widest_event));
      }
    }
  }
}

// With several events that are closer to each other than parameters tell, next to an end.
TEST(FineLevel, SweepsLeaveNothingOut) { expect_nothing_left_out(rounded_ellipse(0.33, 2, 0x1p-60)); }

// Over random parts of the elements of cubics, disks that touch a segment or a circle, from both sides: their curvature
// is the greatest one along the arc, in points, and its derivatives are those of difference quotients; expansions over
// parts hold those of points.
template <SC::internal::Common::Enclosing_number Interval>
void expect_expansions_of_tangent_disks()
{
  const Curves curves{SC::bezier_curve(std::vector{P(0, 0), P(8, 0)}), SC::circle_curve(P(4, 5), 2),
                      SC::bezier_curve(std::vector{P(1, 1), P(3, 3), P(5, -1), P(7, 2)}),
                      SC::bezier_curve(std::vector{P(3, 5), P(4, 6), P(5, 4), P(5, 5)})};
  const SC::Upward_rounding_guard guard;
  const SC::internal::Voronoi::Site_graph_2<Interval> graph(
      *SC::internal::Voronoi::site_graph(curves, std::vector<P>()));
  const SC::internal::Voronoi::Disk_curvature<Interval> curvature(graph);
  const auto meet = [](const Interval& x, const Interval& y) { return x.inf() <= y.sup() && y.inf() <= x.sup(); };
  std::mt19937 random(1);
  std::array<std::size_t, 2> found{0, 0}; // on the segment, and on circles
  for (int i = 0; i < 2000; ++i) {
    const std::size_t f = random() % graph.elements().size(), arc = random() % graph.arcs().size();
    const double width = std::exp2(-2 - std::uniform_real_distribution<double>(0, 20)(random)),
                 begin = std::uniform_real_distribution<double>(0, 1 - width)(random);
    const auto part_over = [&](const Range& range) { return curvature.part(f, range); };
    const auto disks_over = [&](const Range& range) {
      return tangent_disks(graph, curvature, part_over(range), {SC::internal::Voronoi::Disk_footpoint::Kind::ARC, arc});
    };
    const Range range{begin, begin + width};
    const auto disks = disks_over(range);
    if (graph.elements()[f].is_normal_cone || graph.elements()[f].object == arc || !disks)
      continue;
    const Interval shift = SC::internal::Common::interval_of<Interval>(range) - Interval(range.middle());
    const double u = range.begin + std::uniform_real_distribution<double>(0, 1)(random) * width, step = 1e-4 * width;
    const auto there = disks_over({u, u}), before = disks_over({u - step, u - step}),
               behind = disks_over({u + step, u + step});
    ASSERT_TRUE(there && before && behind);
    EXPECT_TRUE(meet(there->value(), disks->value()) && meet(there->value(), disks->expansion().value(shift)));
    EXPECT_TRUE(meet(there->expansion().slope, disks->expansion().derivative(shift)) &&
                meet(there->expansion().second_derivative, disks->expansion().second_derivative));
    const auto greatest = largest_curvature(graph, curvature, part_over({u, u}),
                                            {{SC::internal::Voronoi::Disk_footpoint::Kind::ARC, arc}, {0, 1}});
    EXPECT_TRUE(meet(greatest.curvature, there->value()));
    EXPECT_LT(there->value().sup() - there->value().inf(), 1e-9 * there->value().sup());
    const double quotient = (behind->value() - before->value()).sup() / (2 * step),
                 rounding = (there->value().sup() - there->value().inf()) / step,
                 size = std::abs(disks->expansion().slope.inf()) + std::abs(disks->expansion().slope.sup());
    EXPECT_NEAR(quotient, there->expansion().slope.sup(), 1e-3 * size + 4 * rounding);
    ++found[graph.arcs()[arc].is_straight() ? 0 : 1];
  }
  EXPECT_GT(found[0], 20U);
  EXPECT_GT(found[1], 20U);
}

TEST(FineLevel, DisksThatTouchLinesAndCircles)
{
  expect_expansions_of_tangent_disks<SC::internal::Common::Interval>();
  expect_expansions_of_tangent_disks<Fine_interval>();
}

// Two curves that leave a point, with directions that differ by rounding, or some more.
Curves thin_corner(double height)
{
  const P corner(3.1, 2.7);
  const K::Vector_2 along(1.1, 0.3), up(-0.3, 1.1);
  return {bezier({corner, corner + 4 * along}),
          bezier({corner, corner + 2 * along + height * up, corner + 4 * along + up})};
}

// Next to the corner doubles know no upper bound of the curvature: disks are those of numbers of higher precision, and
// no larger than one through the other curve.
TEST(FineLevel, DisksInAThinCorner)
{
  for (const double height : {1e-16, 3e-16, 1e-15}) {
    const auto graph = SC::internal::Voronoi::site_graph(thin_corner(height), std::vector<P>());
    const SC::Upward_rounding_guard guard;
    const SC::internal::Voronoi::Fine_level fine_level(*graph);
    const SC::internal::Voronoi::Disk_curvature<> curvature(*graph);
    const SC::internal::Voronoi::Envelope_arc_disks disks(*graph, curvature, fine_level);
    const auto& elements = graph->elements();
    const auto left = static_cast<std::size_t>(std::find_if(elements.begin(), elements.end(),
                                                            [](const auto& element) {
                                                              return !element.is_normal_cone && !element.is_reversed &&
                                                                  element.object == 0;
                                                            }) -
                                               elements.begin());
    ASSERT_LT(left, elements.size());
    const double u = 0x1p-50;
    const SC::internal::Voronoi::Located_footpoint footpoint{{SC::internal::Voronoi::Disk_footpoint::Kind::ARC, 1},
                                                             {0, 4 * u}};
    const SC::internal::Voronoi::Envelope_arc envelope_arc{footpoint.footpoint, {0, 1}, {}, {{{0, 1}, footpoint}}};
    ASSERT_FALSE(
        std::isfinite(largest_curvature(*graph, curvature, curvature.part(left, {u, u}), footpoint).curvature.sup()));

    const Exact_pair x = graph->exact_point_at(elements[left], u), y = graph->arcs()[1].at(u),
                     n = graph->exact_normal(elements[left], u),
                     chord{Exact_rational(y[0] - x[0]), Exact_rational(y[1] - x[1])};
    const double through_other =
        CGAL::to_double(Exact_rational(2 * SC::internal::exact_dot(n, chord) / SC::internal::exact_dot(chord, chord)));
    const auto disk = disks.estimated(left, envelope_arc, u);
    EXPECT_GT(disk.curvature.inf(), through_other * (1 - 1e-9)) << "height " << height;
    EXPECT_TRUE(std::isfinite(disk.curvature.sup()));
    EXPECT_GE(disk.curvature.sup(), disk.bounds.inf());
  }
}

// Samples of edges whose radius no number tells say so, and have disks that touch the first site; the others touch both
// sites. The least disks are empty.
TEST(FineLevel, RadiiThatAreNotKnown)
{
  const P joint(1. / 3, 0.3);
  // a segment, and a curve that goes on with a kink of rounding errors
  const Curves curves{bezier({joint, P(8, 0.7)}),
                      bezier({joint, P(1. / 3 - 5 + 1e-13, 0.3 - 5 * (0.4 / (8 - 1. / 3))), P(-6, 1)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_FALSE(diagram.is_complete());
  std::vector<P> points;
  for (const Curve& curve : curves)
    for (int i = 0; i <= 200; ++i)
      points.push_back(rounded(curve(i / 200.)));
  std::size_t known = 0, unknown = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, 0.01, 100)) {
      const auto& [low, high] = sample.radius_bounds;
      EXPECT_TRUE(low <= sample.radius * (1 + 1e-14) && sample.radius * (1 - 1e-14) <= high)
          << sample.radius << " between " << low << " and " << high;
      const double allowed = 1e-8 * (1 + sample.radius);
      const bool is_known = high - low < allowed;
      ++(is_known ? known : unknown);
      const auto foot = [&](std::size_t side) {
        const auto& site = diagram.sites()[diagram.edges()[e].sites[side]];
        return rounded(site.is_point ? site.point : curves[*site.curve](*sample.parameters[side]));
      };
      for (std::size_t side = 0; side < (is_known ? 2 : 1); ++side)
        EXPECT_NEAR(distance(sample.point, foot(side)), sample.radius, allowed) << "edge " << e << " side " << side;
      const P inner = sample.radius > 0 ? foot(0) + (sample.point - foot(0)) * (low / sample.radius) : sample.point;
      for (const P& p : points)
        EXPECT_GT(distance(inner, p), low - allowed) << "edge " << e;
    }
  EXPECT_GT(known, 10U);
  EXPECT_GE(unknown, 1U);
  EXPECT_LT(unknown, 5U);
}

// A curvature with two equal maxima, which no bounds tell apart: 1 - 8 (v - a)^2 (v - b)^2.
template <SC::internal::Common::Enclosing_number Interval>
void expect_bounds_of_two_maxima()
{
  const Interval a = Interval(1) / Interval(3), b = Interval(2) / Interval(3);
  const auto at = [&](const SC::internal::Common::Range& range) {
    const Interval v = SC::internal::Common::interval_of<Interval>(range), p = (v - a) * (v - b),
                   dp = Interval(2) * v - a - b;
    SC::internal::Voronoi::Curvature_bounds<Interval> k;
    k.value = Interval(1) - Interval(8) * CGAL::square(v - a) * CGAL::square(v - b);
    k.dv = Interval(-16) * p * dp;
    k.dvv = Interval(-16) * (CGAL::square(dp) + Interval(2) * p);
    return k;
  };
  const auto greatest = SC::internal::Voronoi::bounded_curvature<Interval>(at, {0, 1}, 0);
  EXPECT_TRUE(greatest.is_attained);
  EXPECT_LE(greatest.curvature.inf(), 1);
  EXPECT_GE(greatest.curvature.sup(), 1);
  EXPECT_LT(greatest.curvature.sup() - greatest.curvature.inf(), 1e-12);
  EXPECT_LT(greatest.range.begin, 1. / 3);
  EXPECT_GT(greatest.range.end, 2. / 3);
  const auto lower = SC::internal::Voronoi::bounded_curvature<Interval>(at, {0, 1}, 1.5); // than what is asked for
  EXPECT_FALSE(lower.is_attained);
  EXPECT_LE(lower.curvature.inf(), 1);
  EXPECT_GE(lower.curvature.sup(), 1);
}

TEST(LargestCurvature, TwoMaxima)
{
  const SC::Upward_rounding_guard guard;
  expect_bounds_of_two_maxima<SC::internal::Common::Interval>();
  expect_bounds_of_two_maxima<SC::internal::Common::Fine_interval>();
}

} // namespace fine_level_2_test
