// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What planar operations say of random scenes, and whether dense samples agree: a summary with times. The scenes are
// the same ones each time.
//
//   survey_scenes KIND [FIRST END]
//
// with a KIND of offsets, lines, crossings, cusps, copies, hulls, kernels, bisectors, sectors, visible, circles, small,
// mixed, forks, near_forks, joined_forks, fork_offsets, fork_hulls, fork_sectors, rotated and smoothed.
//
// Scenes are those with the numbers from FIRST to before END. Of diagrams, the vertices and samples of edges with
// narrow bounds are counted, too.
// - offsets: of 2 to 50 cubics, half of them crossing each other; the area beside that of 4,000 random points.
// - lines: diagrams of one to three curves of degrees one to three with small integers as coordinates, which have
// common tangents; the disks of samples of edges beside samples of curves.
// - crossings: diagrams of 2 to 12 cubics in one square; the same.
// - cusps: diagrams of one or two cubics with a cusp inside, at a quarter, a half or three quarters, and in each third
// scene a segment; the same.
// - copies: diagrams of two to six cubics, of which some are given once more, forward or backward; differing is what
// has other numbers of sites, vertices or edges than without these.
// - hulls: of up to 20 curves with small integers as coordinates, circles and copies; beside the support function of
// samples.
// - kernels: of regions of quadratic and cubic pieces with integers as coordinates that turn around the origin; points
// a little inside see 400 tangents, and points a little outside do not.
// - bisectors: of two cubics in neighbouring squares; differing is what is not one chain. From scene 100 on, of two
// cubics in one square.
// - sectors: of two cubics in one square, with alpha from 1/8 to 7/8 but for 1/2; the distances of their points beside
// those from samples. From scene 40 on, of cubics that touch; from scene 240 on, of a chain that touches itself and a
// cubic.
// - visible: from a point, of which some are on curves, with up to 8 segments, circles and curves with small integers
// as coordinates; 200 rays beside chords of samples.
// - circles: diagrams of two to nine circles apart from each other, half of them with integers, the others with decimal
// numbers; the vertices beside those of CGAL's Apollonius graph.
// - small: diagrams of one to three cubics in a square, and one to three others whose size is 2^-10 to 2^-29 of that;
// the same as of crossings.
// - mixed: diagrams of segments, quadratics, cubics, ellipses, points, copies and chains that touch in a joint, with
// integers as coordinates and common ends; the same.
// - forks: diagrams of a segment, a quadratic, a cubic or a circle, and one to three curves that begin in points of it,
// with its tangent there, forward or backward; the same.
// - near_forks: diagrams of a slanted segment or a circle with decimal numbers, and one or two curves that begin in
// points of it, but for rounding; the same.
// - joined_forks: of the same curves after with_exact_joints().
// - fork_offsets: of the curves of forks, with three distances; the distances of their points, and what they cover,
// beside samples.
// - fork_hulls: of the same curves; the same as of hulls.
// - fork_sectors: of the first two of the same curves, and their bisectors; the same as of sectors.
// - rotated: diagrams of closed chains that would be smooth, ellipses, rounded rectangles and closed splines of 4 to 8
// cubics, rotated by some angle, so that they have kinks of rounding errors; the same.
// - smoothed: the same chains after with_smooth_joints().
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/smooth_joints.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/joints/exact_joints_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include "polygon_area.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;
using Vector = K::Vector_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;

namespace {

struct Answer
{
  bool is_asked = true;         // whether the scene is one of those
  bool is_complete = false;
  bool is_differing = false;    // from what samples tell
  std::size_t size = 0;         // arcs or edges
  // of diagrams, those at infinity left out; and those whose bounds are narrower than 10^-9 (1 + radius), and hold what
  // is rounded
  std::size_t vertices = 0, bounded = 0;
  std::size_t samples = 0, known = 0;      // of edges of diagrams; and those whose radius has such bounds
};

std::vector<Point> samples(const Curves& curves, int count)
{
  std::vector<Point> result;
  for (const auto& curve : curves) {
    const auto [begin, end] = curve.domain();
    for (int i = 0; i <= count; ++i)
      result.push_back(curve(begin + (end - begin) * i / count));
  }
  return result;
}

double number(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Point point(std::mt19937& random, double left, double low, double size)
{
  const double x = left + number(random, 0, size), y = low + number(random, 0, size);
  return Point(x, y);
}

SC::Bspline_curve_2<K> cubic(std::mt19937& random, double left)
{
  std::vector<Point> points;
  for (int k = 0; k < 4; ++k)
    points.push_back(point(random, left, 0, 1));
  return SC::bezier_curve(points);
}

double distance(const Point& p, const std::vector<Point>& along)
{
  double result = std::numeric_limits<double>::infinity();
  for (const Point& q : along)
    result = std::min(result, CGAL::squared_distance(p, q));
  return std::sqrt(result);
}

Point lattice_point(std::mt19937& random, int most)
{
  const int x = std::uniform_int_distribution<int>(0, most)(random),
            y = std::uniform_int_distribution<int>(0, most)(random);
  return Point(x, y);
}

// The control points of a curve of degree one to three.
std::vector<Point> lattice_points(std::mt19937& random, int most)
{
  std::vector<Point> result;
  const std::size_t degree = 1 + random() % 3;
  while (result.size() <= degree)
    result.push_back(lattice_point(random, most));
  return result;
}

// 2 to 50 cubics, each number twice: in cells, or in squares of twice the width around these.
Answer offset(unsigned scene)
{
  constexpr double distance = 0.2;
  constexpr int queries = 4000;
  std::mt19937 random(scene);
  const unsigned count = 2 + scene % 49;
  const bool are_crossing = scene >= 49;
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  Curves curves;
  for (unsigned i = 0; i < count; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 4; ++k)
      points.push_back(point(random, static_cast<int>(i) % columns - (are_crossing ? 0.5 : -0.1),
                             static_cast<int>(i) / columns - (are_crossing ? 0.5 : -0.1), are_crossing ? 2 : 0.8));
    curves.push_back(SC::bezier_curve(points));
  }
  const auto result = SC::trimmed_offset(curves, distance);
  Answer answer;
  answer.is_complete = result.is_complete();
  for (const auto& boundary : result.boundaries())
    answer.size += boundary.arcs.size();
  const std::vector<Point> along = samples(curves, 200);
  const double low = -1, width = columns + 2;
  int covered = 0;
  for (int i = 0; i < queries; ++i) {
    const Point q = point(random, low, low, width);
    covered += std::any_of(along.begin(), along.end(),
                           [&](const Point& p) { return CGAL::squared_distance(p, q) < distance * distance; });
  }
  const double share = static_cast<double>(covered) / queries,
               deviation = std::sqrt(std::max(share * (1 - share), 1e-3) / queries);
  answer.is_differing =
      std::abs(total_area(result.polygons_with_holes(1e-4)) / (width * width) - share) > 5 * deviation;
  return answer;
}

template <class Given_point>
Point rounded(const Given_point& p)
{
  return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

template <class Vertex>
bool has_narrow_bounds(const Vertex& vertex)
{
  const Point p = rounded(*vertex.point);
  const auto holds = [&](double low, double value, double high) {
    return low <= value && value <= high && high - low < 1e-9 * (1 + *vertex.radius);
  };
  const auto& box = vertex.box;
  return holds(box.xmin(), p.x(), box.xmax()) && holds(box.ymin(), p.y(), box.ymax()) &&
      holds(vertex.radius_bounds[0], *vertex.radius, vertex.radius_bounds[1]);
}

// Of a diagram of curves, which may be exact, and points: the disks of samples of edges touch both sites, or the first
// one where bounds are wide, and none contains a point or a sample of a curve.
template <class Given_curves>
Answer answer_of_diagram(const Given_curves& given, const Curves& curves, const std::vector<Point>& points = {})
{
  constexpr double error = 0.01, most_radius = 100, most_difference = 1e-8;
  std::vector<typename Given_curves::value_type::Kernel::Point_2> given_points;
  for (const Point& p : points)
    given_points.emplace_back(p.x(), p.y());
  const auto diagram = SC::voronoi_diagram(given, given_points);
  Answer answer;
  answer.is_complete = diagram.is_complete();
  answer.size = diagram.edges().size();
  for (const auto& vertex : diagram.vertices())
    if (!vertex.is_at_infinity) {
      ++answer.vertices;
      answer.bounded += has_narrow_bounds(vertex);
    }
  std::vector<Point> along = samples(curves, 500);
  along.insert(along.end(), points.begin(), points.end());
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, error, most_radius)) {
      const Point center = rounded(sample.point);
      const double allowed = most_difference * (1 + sample.radius), low = sample.radius_bounds[0],
                   high = sample.radius_bounds[1];
      const bool is_known = high - low < allowed;
      const auto foot = [&](std::size_t side) {
        const auto& site = diagram.sites()[diagram.edges()[e].sites[side]];
        return site.is_point ? rounded(site.point) : curves[*site.curve](*sample.parameters[side]);
      };
      // the center of the least disk
      const Point foot0 = foot(0),
                  inner = sample.radius > 0 ? foot0 + (center - foot0) * (low / sample.radius) : center;
      ++answer.samples;
      answer.known += is_known;
      for (std::size_t side = 0; side < (is_known ? 2 : 1); ++side)
        answer.is_differing = answer.is_differing ||
            !(std::abs(std::sqrt(CGAL::squared_distance(center, foot(side))) - sample.radius) < allowed);
      answer.is_differing = answer.is_differing ||
          !(low <= sample.radius + allowed && sample.radius <= high + allowed &&
            distance(inner, along) > low - allowed);
    }
  return answer;
}

Answer answer_of_diagram(const Curves& curves) { return answer_of_diagram(curves, curves); }

Answer lines(unsigned scene)
{
  std::mt19937 random(scene);
  Curves curves;
  for (unsigned i = 0; i <= scene % 3; ++i) {
    const std::vector<Point> points = lattice_points(random, 4);
    if (std::adjacent_find(points.begin(), points.end()) == points.end())
      curves.push_back(SC::bezier_curve(points));
  }
  return curves.empty() ? Answer{false} : answer_of_diagram(curves);
}

Answer crossings(unsigned scene)
{
  std::mt19937 random(scene);
  Curves curves;
  for (unsigned i = 0; i < 2 + scene % 11; ++i)
    curves.push_back(cubic(random, 0));
  return answer_of_diagram(curves);
}

Answer small(unsigned scene)
{
  std::mt19937 random(scene);
  Curves curves;
  for (unsigned i = 0; i <= scene % 3; ++i)
    curves.push_back(cubic(random, 0));
  for (unsigned i = 0; i <= scene / 3 % 3; ++i) {
    const Point place = point(random, 0, 0, 1);
    const double size = std::ldexp(1., -10 - static_cast<int>(scene % 20));
    std::vector<Point> points;
    for (int k = 0; k < 4; ++k)
      points.push_back(place + size * (point(random, 0, 0, 1) - CGAL::ORIGIN));
    curves.push_back(SC::bezier_curve(points));
  }
  return answer_of_diagram(curves);
}

// Two chains of two quadratics each, which touch in their joints.
Curves chains_that_touch(std::mt19937& random, int most)
{
  const Point joint = lattice_point(random, most);
  const Vector tangent(static_cast<int>(random() % 3) - 1, 1);
  Curves result;
  for (const int length : {1, 2}) {
    const Point first = lattice_point(random, most), last = lattice_point(random, most);
    result.emplace_back(2, std::vector<double>{0, 0, 0, 1, 1, 2, 2, 2},
                        std::vector<Point>{first, joint - length * tangent, joint, joint + length * tangent, last});
  }
  return result;
}

Answer mixed(unsigned scene)
{
  constexpr int most = 8;
  std::mt19937 random(scene);
  Curves curves;
  std::vector<Point> points, ends;
  const auto end_of_site = [&] {
    return ends.empty() || random() % 5 < 3 ? lattice_point(random, most) : ends[random() % ends.size()];
  };
  const auto append = [&](const std::vector<Point>& control_points) {
    if (std::adjacent_find(control_points.begin(), control_points.end()) == control_points.end())
      curves.push_back(SC::bezier_curve(control_points));
  };
  for (unsigned count = 2 + random() % 5; count > 0; --count) {
    const Point a = end_of_site(), b = end_of_site(), c = lattice_point(random, most), d = lattice_point(random, most);
    switch (random() % 7) {
    case 0: append({a, b}); break;
    case 1: append({a, c, b}); break;
    case 2: append({a, c, d, b}); break;
    case 3:
      curves.push_back(SC::ellipse_curve(a, Vector(1 + static_cast<int>(random() % 3), 0),
                                         Vector(0, 1 + static_cast<int>(random() % 3))));
      break;
    case 4: points.push_back(a); break;
    case 5:
      if (!curves.empty())
        curves.push_back(curves[random() % curves.size()]);
      break;
    default:
      for (const auto& curve : chains_that_touch(random, most))
        curves.push_back(curve);
    }
    ends.insert(ends.end(), {a, b});
  }
  return curves.empty() ? Answer{false} : answer_of_diagram(curves, curves, points);
}

// A point of a curve, and the tangent there.
using Fork = std::pair<Point, Vector>;
using Trunk = std::pair<Curves, std::function<Fork()>>;   // a curve, and where others leave it

Fork fork_at(double t, std::vector<Point> control_points)
{
  const auto degree = static_cast<double>(control_points.size() - 1);
  for (; control_points.size() > 2; control_points.pop_back())
    for (std::size_t i = 0; i + 1 < control_points.size(); ++i)
      control_points[i] = control_points[i] + t * (control_points[i + 1] - control_points[i]);
  const Vector way = control_points[1] - control_points[0];
  return {control_points[0] + t * way, degree * way};
}

Fork fork_of_circle(std::mt19937& random, const Point& center, double radius)
{
  const std::array<Vector, 4> axes{Vector(1, 0), Vector(0, 1), Vector(-1, 0), Vector(0, -1)};
  const std::size_t k = random() % 4;
  return Fork(center + radius * axes[k], axes[(k + 1) % 4]);
}

// A segment on which points are, exactly, a quadratic or cubic whose coordinates are exact at some parameters, or a
// circle; and where it forks.
Trunk trunk(std::mt19937& random, unsigned scene, const std::function<Point()>& dyadic_point)
{
  if (scene % 4 == 0) {
    const double unit = scene % 8 == 0 ? 0.1 : 0x1p-50;
    return {{SC::bezier_curve(std::vector{Point(0, 0), Point(8, 0)})},
            [&random, unit] { return Fork(Point(std::round(number(random, 1, 7) / unit) * unit, 0), Vector(1, 0)); }};
  }
  if (scene % 4 == 3) {
    const Point center = dyadic_point();
    const double radius = 0.125 * (4 + static_cast<double>(random() % 16));
    return {{SC::circle_curve(center, radius)},
            [&random, center, radius] { return fork_of_circle(random, center, radius); }};
  }
  std::vector<Point> points;
  for (unsigned k = 0; k < 2 + scene % 4; ++k)
    points.push_back(dyadic_point());
  return {{SC::bezier_curve(points)},
          [&random, points] { return fork_at(0.25 * (1 + static_cast<double>(random() % 3)), points); }};
}

// A trunk, and some curves that fork.
Curves with_forks(std::mt19937& random, Trunk trunk, unsigned count, unsigned least_points,
                  const std::function<Point()>& any_point)
{
  auto& [curves, fork] = trunk;
  for (; count > 0; --count) {
    const auto [place, tangent] = fork();
    const Vector way = (random() % 2 ? 0.5 : -0.5) * tangent;
    std::vector<Point> points{place, place + way};
    if (random() % 4 == 0)
      points.push_back(place + 2 * way);   // no curvature there, or a segment
    for (unsigned others = random() % 2 + least_points; others > 0; --others)
      points.push_back(any_point());
    curves.push_back(SC::bezier_curve(points));
  }
  return curves;
}

// One to three of them.
Curves forking_curves(unsigned scene)
{
  std::mt19937 random(scene);
  const std::function<Point()> dyadic_point = [&] {
    const double x = std::round(number(random, 0, 512)) / 64, y = std::round(number(random, 0, 512)) / 64;
    return Point(x, y);
  };
  const Trunk from = trunk(random, scene, dyadic_point);
  const unsigned count = 1 + random() % 3;
  return with_forks(random, from, count, scene % 4 == 0, dyadic_point);
}

// One or two curves that leave a slanted segment or a circle with decimal numbers, in points that are on it but for
// rounding.
Curves nearly_forking_curves(unsigned scene)
{
  std::mt19937 random(scene);
  const auto decimal = [&](double begin, double end) { return std::round(number(random, begin, end) * 10) * 0.1; };
  const std::function<Point()> decimal_point = [&] {
    const double x = decimal(0, 8), y = decimal(0, 8);
    return Point(x, y);
  };
  Trunk from;
  if (scene % 2 == 0) {
    const Point begin = decimal_point();
    const Vector way = decimal_point() - begin;
    from = {{SC::bezier_curve(std::vector{begin, begin + way})},
            [&random, begin, way] { return Fork(begin + 0.1 * (1 + static_cast<double>(random() % 9)) * way, way); }};
  } else {
    const Point center = decimal_point();
    const double radius = decimal(0.5, 2);
    from = {{SC::circle_curve(center, radius)},
            [&random, center, radius] { return fork_of_circle(random, center, radius); }};
  }
  return with_forks(random, from, 1 + scene / 2 % 2, scene % 2 == 0, decimal_point);
}

Answer forks(unsigned scene) { return answer_of_diagram(forking_curves(scene)); }

Answer near_forks(unsigned scene) { return answer_of_diagram(nearly_forking_curves(scene)); }

Answer joined_forks(unsigned scene)
{
  constexpr double most_distance = 1e-12, most_angle = 1e-12;
  const auto joined = SC::with_exact_joints<CGAL::Simple_cartesian<SC::Exact_rational>>(nearly_forking_curves(scene),
                                                                                        most_distance, most_angle)
                          .curves;
  return answer_of_diagram(joined, Curves(joined.begin(), joined.end()));
}

bool covers(const CGAL::Polygon_with_holes_2<K>& polygon, const Point& p)
{
  return polygon.outer_boundary().bounded_side(p) == CGAL::ON_BOUNDED_SIDE &&
      std::all_of(polygon.holes_begin(), polygon.holes_end(),
                  [&](const auto& hole) { return hole.bounded_side(p) == CGAL::ON_UNBOUNDED_SIDE; });
}

Answer fork_offsets(unsigned scene)
{
  constexpr int queries = 2000;
  constexpr double allowed = 2e-3;
  const Curves curves = forking_curves(scene);
  const std::vector<Point> along = samples(curves, 2000);
  std::mt19937 random(scene);
  Answer answer;
  answer.is_complete = true;
  for (const double radius : {0.0625, 0.3, 1.0}) {
    const auto result = SC::trimmed_offset(curves, radius);
    answer.is_complete = answer.is_complete && result.is_complete();
    answer.size += result.arcs().size();
    for (std::size_t i = 0; i < result.arcs().size(); ++i)
      for (const Point& p : result.polyline(i, 1e-4))
        answer.is_differing = answer.is_differing || std::abs(distance(p, along) - radius) > allowed;
    const auto polygons = result.polygons_with_holes(1e-4);
    for (int i = 0; i < queries && result.is_complete(); ++i) {
      const Point p = point(random, -2, -2, 12);
      const double height = distance(p, along) - radius;
      const bool is_covered =
          std::any_of(polygons.begin(), polygons.end(), [&](const auto& polygon) { return covers(polygon, p); });
      answer.is_differing = answer.is_differing || (std::abs(height) > allowed && is_covered != (height < 0));
    }
  }
  return answer;
}

// The points where pieces begin, and the tangents there: the control points of a closed chain of cubics.
std::vector<std::vector<Point>> closed_chain(const std::vector<Point>& points, const std::vector<Vector>& tangents)
{
  std::vector<std::vector<Point>> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    result.push_back({points[i], points[i] + tangents[i], points[next] - tangents[next], points[next]});
  }
  return result;
}

Curves rotated_chain(unsigned scene)
{
  constexpr double quarter = 0.5522847498;   // the length of the tangents of a quarter of a circle
  std::mt19937 random(scene);
  const double a = number(random, 1, 3), b = number(random, 1, 3), angle = number(random, 0, CGAL_PI);
  std::vector<std::vector<Point>> chain;
  if (scene % 3 == 0)
    chain = closed_chain(
        {Point(a, 0), Point(0, b), Point(-a, 0), Point(0, -b)},
        {Vector(0, quarter * b), Vector(-quarter * a, 0), Vector(0, -quarter * b), Vector(quarter * a, 0)});
  else if (scene % 3 == 1) {
    const double radius = number(random, 0.1, 0.9), t = quarter * radius;
    const std::vector<Point> begins{Point(a, radius - b), Point(a - radius, b), Point(-a, b - radius),
                                    Point(radius - a, -b)},
        ends{Point(a, b - radius), Point(radius - a, b), Point(-a, radius - b), Point(a - radius, -b)};
    const std::vector<Vector> tangents{Vector(0, t), Vector(-t, 0), Vector(0, -t), Vector(t, 0)};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      chain.push_back({begins[i], ends[i]});
      chain.push_back({ends[i], ends[i] + tangents[i], begins[next] - tangents[next], begins[next]});
    }
  } else {
    std::vector<Point> points;
    std::vector<Vector> tangents;
    const std::size_t count = 4 + scene / 3 % 5;
    for (std::size_t i = 0; i < count; ++i) {
      const double direction = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(count),
                   radius = number(random, 1, 2);
      points.emplace_back(radius * std::cos(direction), radius * std::sin(direction));
    }
    for (std::size_t i = 0; i < count; ++i)
      tangents.push_back((points[(i + 1) % count] - points[(i + count - 1) % count]) / 6);
    chain = closed_chain(points, tangents);
  }
  Curves curves;
  for (std::vector<Point>& points : chain) {
    for (Point& p : points)
      p = Point(std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y());
    curves.push_back(SC::bezier_curve(points));
  }
  return curves;
}

Answer rotated(unsigned scene) { return answer_of_diagram(rotated_chain(scene)); }

Answer smoothed(unsigned scene)
{
  const Curves chain = rotated_chain(scene);
  const auto curves = SC::with_smooth_joints<CGAL::Simple_cartesian<SC::Exact_rational>>(chain, 1e-9).curves;
  return answer_of_diagram(curves, Curves(curves.begin(), curves.end()));
}

// C' = 3 (t - t0) (E + t F) with integers, E and F not parallel: the control points are exact.
SC::Bspline_curve_2<K> cuspidal_cubic(std::mt19937& random)
{
  const auto integers = [&] {
    const int x = static_cast<int>(random() % 5) - 2, y = static_cast<int>(random() % 5) - 2;
    return Vector(x, y);
  };
  const double t0 = (1 + random() % 3) / 4.0;
  const Point begin = CGAL::ORIGIN + integers();
  Vector e = integers(), f = integers();
  while (CGAL::determinant(e, f) == 0) {
    e = integers();
    f = integers();
  }
  const Vector c1 = -t0 * e, c2 = (e - t0 * f) / 2;   // a third of the coefficients of t and t^2
  return SC::bezier_curve(std::vector<Point>{begin, begin + c1, begin + 2 * c1 + c2, begin + 3 * (c1 + c2) + f});
}

Answer cusps(unsigned scene)
{
  std::mt19937 random(scene);
  Curves curves{cuspidal_cubic(random)};
  if (scene % 3 != 0)
    curves.push_back(cuspidal_cubic(random));
  if (scene % 3 == 2) {
    const Point p = lattice_points(random, 8)[0];
    curves.push_back(SC::bezier_curve(std::vector<Point>{p, p + Vector(1 + random() % 4, 2.0 - random() % 5)}));
  }
  return answer_of_diagram(curves);
}

Answer copies(unsigned scene)
{
  std::mt19937 random(scene);
  Curves curves;
  for (unsigned i = 0; i < 2 + scene % 5; ++i)
    curves.push_back(cubic(random, 0));
  const auto expected = SC::voronoi_diagram(curves);
  for (std::size_t i = 0, count = curves.size(); i < count; ++i)
    if (i == 0 || random() % 2 == 0)
      curves.push_back(random() % 2 == 0 ? curves[i] : curves[i].reversed());
  const auto diagram = SC::voronoi_diagram(curves);
  Answer answer;
  answer.is_complete = diagram.is_complete();
  answer.size = diagram.edges().size();
  answer.is_differing = diagram.sites().size() != expected.sites().size() ||
      diagram.vertices().size() != expected.vertices().size() || diagram.edges().size() != expected.edges().size();
  return answer;
}

Answer answer_of_hull(const Curves& curves)
{
  constexpr int directions = 360;
  Answer answer;
  const auto result = SC::convex_hull(curves);
  answer.is_complete = result.is_complete();
  answer.size = result.edges().size();
  const std::vector<Point> along = samples(curves, 400);
  const CGAL::Polygon_2<K> polygon = result.polygon(1e-6);
  const auto height = [](const auto& points, const Vector& n) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Point& p : points)
      most = std::max(most, (p - CGAL::ORIGIN) * n);
    return most;
  };
  for (int i = 0; i < directions && answer.is_complete; ++i) {
    const Vector n(std::cos(2 * CGAL_PI * i / directions), std::sin(2 * CGAL_PI * i / directions));
    answer.is_differing = answer.is_differing || std::abs(height(polygon.container(), n) - height(along, n)) > 1e-3;
  }
  return answer;
}

Answer hull(unsigned scene)
{
  std::mt19937 random(scene);
  Curves curves;
  for (unsigned i = 0; i <= scene % 20; ++i) {
    const std::vector<Point> points = lattice_points(random, 12);
    if (i > 0 && random() % 4 == 0)
      curves.push_back(curves[random() % curves.size()].transformed(
          CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, points[0] - CGAL::ORIGIN)));
    else if (random() % 4 == 0)
      curves.push_back(SC::circle_curve(points[0], 1.0 + static_cast<double>(random() % 4)));
    else if (points.front() != points.back())
      curves.push_back(SC::bezier_curve(points));
  }
  return curves.empty() ? Answer{false} : answer_of_hull(curves);
}

Answer fork_hulls(unsigned scene) { return answer_of_hull(forking_curves(scene)); }

// Around the origin, with a control point in each of eight to twelve directions, of which the first of each piece is a
// corner.
Answer kernel(unsigned scene)
{
  std::mt19937 random(scene);
  const int degree = 2 + static_cast<int>(scene % 2), pieces = 4, n = degree * pieces;
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n, radius = number(random, 25, 50);
    points.emplace_back(std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)));
  }
  Curves curves;
  for (int i = 0; i < n; i += degree) {
    std::vector<Point> piece;
    for (int k = 0; k <= degree; ++k)
      piece.push_back(points[static_cast<std::size_t>((i + k) % n)]);
    curves.push_back(SC::bezier_curve(piece));
  }
  const auto result = SC::region_kernel(SC::planar_region(curves));
  Answer answer;
  answer.is_asked = result.has_interior();
  if (!answer.is_asked)
    return answer;
  answer.is_complete = result.is_complete();
  answer.size = result.edges().size();
  const auto is_on_the_left_of_all = [&](const Point& p) {
    for (const auto& curve : curves)
      for (int i = 0; i <= 100; ++i) {
        const Point q = curve(i / 100.0);
        if (CGAL::determinant(curve.tangent(i / 100.0), p - q) < 0)
          return false;
      }
    return true;
  };
  const Point centre = result.centre();
  for (std::size_t e = 0; e < result.edges().size() && answer.is_complete; ++e) {
    const Vector way = result.source(e) - centre;
    answer.is_differing = answer.is_differing || !is_on_the_left_of_all(centre + 0.999 * way) ||
        is_on_the_left_of_all(centre + 1.01 * way);
  }
  return answer;
}

Answer bisector(unsigned scene)
{
  const bool is_one_square = scene >= 100;
  std::mt19937 random(scene);
  const auto first = cubic(random, 0), second = cubic(random, is_one_square ? 0 : 1);
  const auto result = SC::trimmed_bisector(first, second);
  Answer answer;
  answer.is_complete = result.is_complete();
  for (const auto& chain : result.chains())
    answer.size += chain.arcs.size();
  answer.is_differing = answer.is_complete && !is_one_square && result.chains().size() != 1;
  return answer;
}

Point point_in_sixteenths(std::mt19937& random)
{
  return CGAL::ORIGIN + (lattice_point(random, 12) - CGAL::ORIGIN) / 16;
}

// Two with sixteenths as coordinates, the second of which begins in the begin of the first one, or in its middle, in
// the same direction; none if there is no direction.
Curves touching_cubics(std::mt19937& random)
{
  const auto next_point = [&] { return point_in_sixteenths(random); };
  std::array<Point, 4> a;
  for (Point& p : a)
    p = next_point();
  const bool is_in_middle = random() % 2 == 0;
  const Point begin = is_in_middle ? a[0] + ((a[3] - a[0]) + 3 * (a[1] - a[0]) + 3 * (a[2] - a[0])) / 8 : a[0];
  const Vector tangent = is_in_middle ? (a[3] - a[0]) + (a[2] - a[1]) : a[1] - a[0];
  const Point second = begin + (1.0 + static_cast<double>(random() % 8)) / 4 * tangent, third = next_point(),
              last = next_point();
  return tangent == CGAL::NULL_VECTOR ? Curves()
                                      : Curves{SC::bezier_curve(std::vector<Point>(a.begin(), a.end())),
                                               SC::bezier_curve(std::vector<Point>{begin, second, third, last})};
}

// A chain of four cubics, of which the fourth one begins where the second one does, with the same tangent or the
// opposite one; and another cubic.
Curves chain_that_touches_itself_and_cubic(std::mt19937& random)
{
  const Point touched(0.375, 0.375);
  const Vector tangent(static_cast<int>(random() % 5) - 2, 1 + static_cast<int>(random() % 2)),
      again = random() % 2 == 0 ? tangent : -tangent;
  const auto speed = [&] { return (1.0 + static_cast<double>(random() % 3)) / 16; };
  const auto next_point = [&] { return point_in_sixteenths(random); };
  std::vector<Point> chain{
      next_point(), next_point(), touched - speed() * tangent, touched, touched + speed() * tangent,
      next_point(), next_point()};
  chain.push_back(chain[6] + (chain[6] - chain[5]));
  chain.insert(chain.end(),
               {touched - speed() * again, touched, touched + speed() * again, next_point(), next_point()});
  return {SC::Bspline_curve_2<K>(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4}, chain),
          SC::bezier_curve(std::vector<Point>{next_point(), next_point(), next_point(), next_point()})};
}

Answer answer_of_sectors(const SC::Bspline_curve_2<K>& first, const SC::Bspline_curve_2<K>& second)
{
  const std::vector<Point> along_first = samples({first}, 4000), along_second = samples({second}, 4000);
  Answer answer;
  answer.is_complete = true;
  for (const double alpha : {1 / 8., 1 / 4., 3 / 8., 5 / 8., 3 / 4., 7 / 8.}) {
    const auto result = SC::trimmed_alpha_sector(first, second, alpha);
    answer.is_complete = answer.is_complete && result.is_complete();
    answer.size += result.arcs().size();
    for (std::size_t i = 0; i < result.arcs().size(); ++i)
      for (const auto& sample : result.polyline(i, 0.1))
        answer.is_differing = answer.is_differing ||
            (result.is_complete() && sample.distances[0] + sample.distances[1] < 5 &&
             (std::abs(distance(sample.point, along_first) - sample.distances[0]) > 5e-3 ||
              std::abs(distance(sample.point, along_second) - sample.distances[1]) > 5e-3));
  }
  return answer;
}

Answer sectors(unsigned scene)
{
  constexpr unsigned first_that_touch = 40, first_that_touch_themselves = 240;
  std::mt19937 random(scene);
  const Curves curves = scene < first_that_touch ? Curves{cubic(random, 0), cubic(random, 0)}
      : scene < first_that_touch_themselves      ? touching_cubics(random)
                                                 : chain_that_touches_itself_and_cubic(random);
  return curves.empty() ? Answer{false} : answer_of_sectors(curves[0], curves[1]);
}

Answer fork_sectors(unsigned scene)
{
  const Curves curves = forking_curves(scene);
  Answer answer = answer_of_sectors(curves[0], curves[1]);
  answer.is_complete = answer.is_complete && SC::trimmed_bisector(curves[0], curves[1]).is_complete();
  return answer;
}

// How far a ray from a point in a direction goes before it meets a chain.
double sight(const Point& p, const Vector& ray, const std::vector<std::vector<Point>>& chains)
{
  double result = std::numeric_limits<double>::infinity();
  for (const auto& chain : chains)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const double from = CGAL::determinant(ray, chain[i] - p), to = CGAL::determinant(ray, chain[i + 1] - p);
      if ((from < 0) == (to < 0))
        continue;
      const double along = (chain[i] + from / (from - to) * (chain[i + 1] - chain[i]) - p) * ray;
      if (along > 1e-3)   // others pass through the viewpoint
        result = std::min(result, along);
    }
  return result;
}

Answer visible(unsigned scene)
{
  constexpr int rays = 200;
  std::mt19937 random(scene);
  Curves curves{SC::circle_curve(Point(6, 6), 20.0)};
  for (unsigned i = 0; i <= scene % 8; ++i) {
    const std::vector<Point> points = lattice_points(random, 12);
    if (random() % 3 == 0)
      curves.push_back(SC::circle_curve(points[0], 1.0 + static_cast<double>(random() % 3)));
    else if (std::adjacent_find(points.begin(), points.end()) == points.end())
      curves.push_back(SC::bezier_curve(points));
  }
  const Point viewpoint = scene % 5 == 0 ? curves.back()(curves.back().domain().first) : lattice_point(random, 12);
  const auto result = SC::visible_part(viewpoint, curves);
  Answer answer;
  answer.is_complete = result.is_complete();
  answer.size = result.edges().size();
  std::vector<std::vector<Point>> chains, seen;
  for (const auto& curve : curves)
    chains.push_back(samples({curve}, 2000));
  for (std::size_t i = 0; i < result.edges().size(); ++i)
    if (result.edges()[i].kind == SC::Visible_edge_kind::ARC)
      seen.push_back(result.polyline(i, 1e-4));
  for (int k = 0; k < rays; ++k) {
    const double angle = number(random, 0, 2 * CGAL_PI);
    const bool is_near_vertex = std::any_of(result.edges().begin(), result.edges().end(), [&](const auto& edge) {
      const Vector way = result.point(edge.source) - viewpoint;
      return std::abs(std::remainder(std::atan2(way.y(), way.x()) - angle, 2 * CGAL_PI)) < 0.01;
    });
    const Vector ray(std::cos(angle), std::sin(angle));
    answer.is_differing = answer.is_differing ||
        (!is_near_vertex && std::abs(sight(viewpoint, ray, chains) - sight(viewpoint, ray, seen)) > 0.02);
  }
  return answer;
}

Answer circles(unsigned scene)
{
  using Traits = CGAL::Apollonius_graph_traits_2<K>;
  std::mt19937 random(scene);
  const double unit = scene % 2 == 0 ? 1 : 0.01;
  const auto rounded = [&](double low, double high) { return std::round(number(random, low, high) / unit) * unit; };
  Curves curves;
  CGAL::Apollonius_graph_2<Traits> graph;
  for (unsigned i = 0; i < 2 + scene % 8; ++i) {
    const double x = 10 * (i % 3) + rounded(3, 7), y = 10 * (i / 3) + rounded(3, 7), radius = rounded(1, 2.9);
    curves.push_back(SC::circle_curve(Point(x, y), radius));
    graph.insert(Traits::Site_2(Point(x, y), radius));
  }
  const auto diagram = SC::voronoi_diagram(curves);
  Answer answer;
  answer.is_complete = diagram.is_complete();
  answer.size = diagram.edges().size();
  std::size_t faces = 0;
  for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face, ++faces) {
    const Point p = Traits().construct_Apollonius_vertex_2_object()(face->vertex(0)->site(), face->vertex(1)->site(),
                                                                    face->vertex(2)->site());
    answer.is_differing =
        answer.is_differing || std::none_of(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
          return !v.is_at_infinity && std::sqrt(CGAL::squared_distance(*v.point, p)) < 1e-6 * (1 + *v.radius);
        });
  }
  const auto branching = std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                                       [](const auto& v) { return !v.is_at_infinity && v.edges.size() > 2; });
  answer.is_differing = answer.is_differing || faces != static_cast<std::size_t>(branching);
  return answer;
}

struct Survey
{
  std::function<Answer(unsigned)> ask;
  unsigned scenes;
};

const std::map<std::string, Survey> surveys{{"offsets", {offset, 98}},
                                            {"lines", {lines, 600}},
                                            {"crossings", {crossings, 70}},
                                            {"cusps", {cusps, 120}},
                                            {"copies", {copies, 60}},
                                            {"hulls", {hull, 220}},
                                            {"kernels", {kernel, 100}},
                                            {"bisectors", {bisector, 200}},
                                            {"sectors", {sectors, 340}},
                                            {"visible", {visible, 50}},
                                            {"circles", {circles, 40}},
                                            {"small", {small, 60}},
                                            {"mixed", {mixed, 200}},
                                            {"forks", {forks, 240}},
                                            {"near_forks", {near_forks, 40}},
                                            {"joined_forks", {joined_forks, 40}},
                                            {"fork_offsets", {fork_offsets, 240}},
                                            {"fork_hulls", {fork_hulls, 240}},
                                            {"fork_sectors", {fork_sectors, 240}},
                                            {"rotated", {rotated, 30}},
                                            {"smoothed", {smoothed, 30}}};

} // namespace

int main(int argc, char* argv[])
{
  const auto survey = surveys.find(argc > 1 ? argv[1] : "");
  if (survey == surveys.end()) {
    std::cerr << "survey_scenes "
                 "offsets|lines|crossings|cusps|copies|hulls|kernels|bisectors|sectors|visible|circles|small|mixed|"
                 "forks|near_forks|joined_forks|fork_offsets|fork_hulls|fork_sectors|rotated|smoothed [FIRST END]\n";
    return 2;
  }
  const unsigned first = argc > 3 ? static_cast<unsigned>(std::atoi(argv[2])) : 0,
                 end = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : survey->second.scenes;
  std::size_t scenes = 0, complete = 0, differing = 0, size = 0, vertices = 0, bounded = 0, samples = 0, known = 0,
              refused = 0;
  double total = 0, greatest = 0;
  for (unsigned scene = first; scene < end; ++scene) {
    const auto begin = std::chrono::steady_clock::now();
    Answer answer;
    try {
      answer = survey->second.ask(scene);
    } catch (const SC::Invalid_input&) {
      ++refused;
      continue;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!answer.is_asked)
      continue;
    ++scenes;
    complete += answer.is_complete;
    differing += answer.is_differing;
    size += answer.size;
    vertices += answer.vertices;
    bounded += answer.bounded;
    samples += answer.samples;
    known += answer.known;
    total += seconds;
    greatest = std::max(greatest, seconds);
    if (!answer.is_complete || answer.is_differing)
      std::cout << "scene " << scene << ": " << (answer.is_differing ? "differs from samples" : "not complete") << " ("
                << seconds << " s)" << std::endl;
  }
  std::cout << survey->first << ": " << scenes << " scenes, " << complete << " complete, " << differing
            << " differing from samples, " << refused << " refused; " << size << " arcs or edges; " << bounded << " of "
            << vertices << " vertices with narrow bounds, " << known << " of " << samples << " samples; " << total
            << " s, at most " << greatest << " s\n";
}
