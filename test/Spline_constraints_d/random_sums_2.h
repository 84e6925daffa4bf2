// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random Minkowski sums and swept areas, some with areas in closed form, and which points are proved by samples of both
// boundaries to be inside or outside.

#ifndef SPLINE_CONSTRAINTS_D_TEST_RANDOM_SUMS_2_H
#define SPLINE_CONSTRAINTS_D_TEST_RANDOM_SUMS_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace random_sums {

namespace SC = CGAL::Spline_constraints;

// A region, and another one or a path.
template <class K>
struct Scene
{
  using Curve = SC::Bspline_curve_2<K>;

  std::vector<Curve> region, other;
  bool is_sweep = false;
  std::optional<double> area{};   // in closed form

  SC::Minkowski_sum_2<K> result() const
  {
    return is_sweep ? SC::swept_area(SC::planar_region(region), other[0])
                    : SC::minkowski_sum(SC::planar_region(region), SC::planar_region(other));
  }
};

// Scenes with coordinates in 64ths, which are exact in each kernel.
template <class K>
class Scenes
{
  using FT = typename K::FT;
  using Point = typename K::Point_2;
  using Vector = typename K::Vector_2;
  using Curve = SC::Bspline_curve_2<K>;
  using Curves = std::vector<Curve>;
  using Pair = std::array<double, 2>;

  std::mt19937 m_random;

public:
  static constexpr unsigned kinds = 6;

  explicit Scenes(unsigned seed) : m_random(seed) {}

  // Of two ellipses; a convex polygon and a disk; regions with inflections, and polygons or others of these; a region
  // with a hole; and regions with corners between cubics.
  Scene<K> sum(unsigned kind)
  {
    switch (kind) {
    case 0: return two_ellipses();
    case 1: return polygon_and_disk();
    case 2: return {{spline(3, 6, 7)}, {star_polygon(1, 3, 6)}};
    case 3: return {{spline(3, 6, 7)}, {spline(1, 3, 5)}};
    case 4: return {{spline(5, 7, 7), circle(1.5)}, {spline(0.5, 1.5, 5)}};
    default: return {cornered(3, 6), {spline(1, 3, 5)}};
    }
  }

  // Of an ellipse along a segment; a disk along a circle; regions with inflections along a cubic, or a closed spline;
  // polygons along a cubic; and regions along polylines.
  Scene<K> sweep(unsigned kind)
  {
    switch (kind) {
    case 0: return ellipse_along_segment();
    case 1: return disk_along_circle();
    case 2: return {{spline(1, 3, 6)}, {cubic(6)}, true};
    case 3: return {{spline(0.5, 2, 5)}, {spline(3, 7, 6)}, true};
    case 4: return {{star_polygon(1, 3, 7)}, {cubic(6)}, true};
    default:
      return {{spline(1, 3, 6)},
              {SC::polyline_curve(std::vector<Point>{point(-6, 6), point(-6, 6), point(-6, 6), point(-6, 6)})},
              true};
    }
  }

private:
  static double rounded(double x) { return std::round(64 * x) / 64; }
  double number(double low, double high)
  {
    return rounded(std::uniform_real_distribution<double>(low, high)(m_random));
  }
  Pair pair(double low, double high)
  {
    const double x = number(low, high);
    return {x, number(low, high)};
  }
  static Point at(const Pair& p) { return Point(FT(p[0]), FT(p[1])); }
  static Vector along(const Pair& p) { return Vector(FT(p[0]), FT(p[1])); }
  Point point(double low, double high) { return at(pair(low, high)); }

  // At equal angles around the origin, about.
  std::vector<Pair> star(double least, double greatest, int n)
  {
    std::vector<Pair> result;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * i / n, radius = number(least, greatest);
      result.push_back({rounded(radius * std::cos(angle)), rounded(radius * std::sin(angle))});
    }
    return result;
  }

  static std::vector<Point> points(const std::vector<Pair>& pairs)
  {
    std::vector<Point> result;
    for (const Pair& p : pairs)
      result.push_back(at(p));
    return result;
  }

  Curve spline(double least, double greatest, int n)
  {
    std::vector<FT> period;
    for (int i = 0; i <= n; ++i)
      period.emplace_back(i);
    return Curve::from_periodic(3, period, points(star(least, greatest, n)));
  }

  static Curve closed_polyline(std::vector<Point> points)
  {
    points.push_back(Point(points.front()));
    return SC::polyline_curve(points);
  }

  Curve star_polygon(double least, double greatest, int n) { return closed_polyline(points(star(least, greatest, n))); }
  Curve cubic(double size)
  {
    return SC::bezier_curve(
        std::vector<Point>{point(-size, size), point(-size, size), point(-size, size), point(-size, size)});
  }
  static Curve circle(double radius) { return SC::circle_curve(Point(FT(0), FT(0)), FT(radius)); }

  // Of four cubics.
  Curves cornered(double least, double greatest)
  {
    constexpr std::size_t degree = 3, n = 12;
    const std::vector<Point> p = points(star(least, greatest, n));
    Curves result;
    for (std::size_t i = 0; i < n; i += degree)
      result.push_back(SC::bezier_curve(std::vector<Point>{p[i], p[i + 1], p[i + 2], p[(i + degree) % n]}));
    return result;
  }

  // With half of its axes.
  struct Ellipse
  {
    Pair a, b;

    double area() const { return CGAL_PI * std::abs(a[0] * b[1] - a[1] * b[0]); }
    double support(const Pair& n) const { return std::hypot(a[0] * n[0] + a[1] * n[1], b[0] * n[0] + b[1] * n[1]); }
    Curve curve() const { return SC::ellipse_curve(Point(FT(0), FT(0)), along(a), along(b)); }
  };

  Ellipse ellipse()
  {
    for (;;)
      if (const Ellipse result{pair(-3, 3), pair(-3, 3)}; result.area() > 3)
        return result;
  }

  // The areas, and the integral of the support function of one over the other one's boundary: the trapezoidal rule
  // converges exponentially.
  Scene<K> two_ellipses()
  {
    constexpr int steps = 4096;
    const Ellipse e = ellipse(), f = ellipse();
    double mixed = 0;
    for (int i = 0; i < steps; ++i) {
      const double c = std::cos(2 * CGAL_PI * i / steps), s = std::sin(2 * CGAL_PI * i / steps);
      mixed += f.support({c * e.b[1] - s * e.a[1], s * e.a[0] - c * e.b[0]}) * 2 * CGAL_PI / steps;
    }
    return {{e.curve()}, {f.curve()}, false, e.area() + f.area() + mixed};
  }

  Scene<K> polygon_and_disk()
  {
    constexpr int n = 7;
    const std::vector<Pair> vertices = star(5.5, 6, n);   // so that each is a convex corner
    const double radius = number(0.5, 3);
    double area = CGAL_PI * radius * radius;
    for (std::size_t i = 0; i < n; ++i) {
      const Pair &p = vertices[i], &q = vertices[(i + 1) % n];
      area += (p[0] * q[1] - p[1] * q[0]) / 2 + radius * std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    return {{closed_polyline(points(vertices))}, {circle(radius)}, false, area};
  }

  Scene<K> ellipse_along_segment()
  {
    const Ellipse e = ellipse();
    const Pair way = pair(1, 6);
    return {{e.curve()},
            {SC::segment_curve(Point(FT(0), FT(0)), at(way))},
            true,
            e.area() + 2 * e.support({-way[1], way[0]})};
  }

  Scene<K> disk_along_circle()
  {
    const double radius = number(0.5, 2), path = number(3, 6);
    return {{circle(radius)}, {circle(path)}, true, 4 * CGAL_PI * radius * path};
  }
};

// Points of the boundaries of a region, or of a path. Between two of them each point is nearer to one than the gap, if
// arcs between them turn by less than a right angle and corners are among them: 0.71 times the chord.
class Samples
{
  std::vector<std::vector<std::array<double, 2>>> m_curves;
  bool m_is_region;
  double m_gap = 0;

public:
  template <class Curve>
  Samples(const std::vector<Curve>& curves, int count, bool is_region) : m_is_region(is_region)
  {
    for (const Curve& curve : curves) {
      const auto [begin, end] = curve.domain();   // integers, as all knots
      const int spans = static_cast<int>(std::round(CGAL::to_double(end - begin))),
                steps = spans * ((count + spans - 1) / spans);
      std::vector<std::array<double, 2>>& points = m_curves.emplace_back();
      for (int i = 0; i <= steps; ++i) {
        const auto p = curve(begin + (end - begin) * i / steps);
        points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
        if (i > 0)
          m_gap = std::max(m_gap,
                           0.75 *
                               std::hypot(points[points.size() - 1][0] - points[points.size() - 2][0],
                                          points[points.size() - 1][1] - points[points.size() - 2][1]));
      }
    }
  }

  double gap() const { return m_gap; }

  // The largest value of a function of the points, or the first one above a bound.
  template <class Value>
  double most(const Value& value, double enough) const
  {
    double result = -std::numeric_limits<double>::infinity();
    for (const auto& curve : m_curves)
      for (const auto& p : curve)
        if (result = std::max(result, value(p)); result > enough)
          return result;
    return result;
  }

  // The distance from the nearest sample, negative outside. Curves are closed, or together.
  double depth(double x, double y) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    bool is_inside = false;
    for (const auto& curve : m_curves)
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const auto& p = curve[i];
        nearest = std::min(nearest, (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y));
        const auto& q = curve[i > 0 ? i - 1 : 0];
        if (m_is_region && (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) * (q[0] - p[0]) / (q[1] - p[1]))
          is_inside = !is_inside;
      }
    return (is_inside ? 1 : -1) * std::sqrt(nearest);
  }
};

// A point is inside of the sum A + B if p - a is inside of B for a point a of the boundary of A, or p - b inside of A;
// it is outside if there is no such a or b, and the boundaries of A and p - B are apart.
class Sampled_sum
{
  static constexpr double margin = 1e-3;   // for the error of polygons

  Samples m_first, m_second;

public:
  enum class Place { INSIDE, OUTSIDE, NEAR_BOUNDARY };

  struct Answer
  {
    Place place;
    bool is_inside;   // most likely
  };

  template <class K>
  Sampled_sum(const Scene<K>& scene, int count)
    : m_first(scene.region, count, true), m_second(scene.other, count, !scene.is_sweep)
  {}

  // The width of the strip along the boundary where samples do not tell, about.
  double gap() const { return m_first.gap() + m_second.gap() + margin; }

  Answer operator()(double x, double y) const
  {
    const auto depth = [&](const Samples& samples) {
      return [&samples, x, y](const std::array<double, 2>& p) { return samples.depth(x - p[0], y - p[1]); };
    };
    const double first = m_second.most(depth(m_first), m_first.gap() + margin);
    if (first > m_first.gap() + margin)
      return {Place::INSIDE, true};
    const double second = m_first.most(depth(m_second), m_second.gap() + margin), deepest = std::max(first, second);
    if (second > m_second.gap() + margin)
      return {Place::INSIDE, true};
    return {deepest < -gap() ? Place::OUTSIDE : Place::NEAR_BOUNDARY, deepest > 0};
  }
};

// How a result differs from what random points in its box, a little enlarged, tell.
struct Comparison
{
  std::size_t points = 0, near_boundary = 0, inside = 0, outside = 0;
  // of those inside or outside; the sum is asked every tenth of these
  std::size_t wrong_in_polygons = 0, wrong_in_sum = 0, uncertain = 0;
  double area = 0;                                                      // of polygons
  // of the area by the share of points, and its standard error
  double estimate = 0, deviation = 0;
};

template <class K>
Comparison compare(const Scene<K>& scene, const SC::Minkowski_sum_2<K>& sum, std::size_t points, int samples,
                   unsigned seed)
{
  using Place = Sampled_sum::Place;
  constexpr double polygon_error = 1e-5, enlarged_by = 0.5;
  const auto polygons = sum.polygons_with_holes(polygon_error);
  CGAL::Bbox_2 box;
  Comparison result;
  for (const auto& polygon : polygons) {
    box += polygon.bbox();
    result.area += CGAL::to_double(polygon.outer_boundary().area());
    for (const auto& hole : polygon.holes())
      result.area += CGAL::to_double(hole.area());
  }
  // the member proves each time that the polygon is simple
  const auto side = [](const CGAL::Polygon_2<K>& polygon, const typename K::Point_2& p) {
    return CGAL::bounded_side_2(polygon.vertices_begin(), polygon.vertices_end(), p, K());
  };
  const auto is_in_polygons = [&](const typename K::Point_2& p) {
    return std::any_of(polygons.begin(), polygons.end(), [&](const auto& polygon) {
      return side(polygon.outer_boundary(), p) == CGAL::ON_BOUNDED_SIDE &&
          std::all_of(polygon.holes_begin(), polygon.holes_end(),
                      [&](const auto& hole) { return side(hole, p) == CGAL::ON_UNBOUNDED_SIDE; });
    });
  };
  const Sampled_sum sampled(scene, samples);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> left(box.xmin() - enlarged_by, box.xmax() + enlarged_by),
      low(box.ymin() - enlarged_by, box.ymax() + enlarged_by);
  std::size_t likely_inside = 0;
  for (; result.points < points; ++result.points) {
    const double x = left(random), y = low(random);
    const auto [place, is_inside] = sampled(x, y);
    likely_inside += is_inside;
    if (place == Place::NEAR_BOUNDARY) {
      ++result.near_boundary;
      continue;
    }
    ++(is_inside ? result.inside : result.outside);
    const typename K::Point_2 p(x, y);
    result.wrong_in_polygons += is_in_polygons(p) != is_inside;
    if (result.points % 10 == 0) {
      const CGAL::Uncertain<bool> answer = sum.has_in_interior(p);
      result.uncertain += !answer.is_certain();
      result.wrong_in_sum += CGAL::certainly(answer != is_inside);
    }
  }
  const double whole = (left.max() - left.min()) * (low.max() - low.min()),
               share = static_cast<double>(likely_inside) / static_cast<double>(points);
  result.estimate = share * whole;
  result.deviation = whole * std::sqrt(share * (1 - share) / static_cast<double>(points));
  return result;
}

} // namespace random_sums

#endif // SPLINE_CONSTRAINTS_D_TEST_RANDOM_SUMS_2_H
