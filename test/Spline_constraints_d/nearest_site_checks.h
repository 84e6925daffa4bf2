// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random scenes of the kinds that Voronoi diagrams are made of, and answers of diagrams and their arrangements in
// random points beside distances from the curves that do without any of both.
#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_NEAREST_SITE_CHECKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_NEAREST_SITE_CHECKS_H

#include "arrangement_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/cubic_interpolation.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Arr_batched_point_location.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace nearest_site_checks {

namespace SC = CGAL::Spline_constraints;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Curve = SC::Bspline_curve_2<Kernel>;
using Diagram = SC::Voronoi_diagram_of_curves_2<Kernel>;

struct Scene
{
  std::string kind;
  std::vector<Curve> curves;
  std::vector<Point> points;
  bool is_region = false;   // whose medial axis is asked for
};

class Scene_maker
{
  std::mt19937 m_random;

public:
  explicit Scene_maker(unsigned seed) : m_random(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }

  Point point(double left, double low, double size)
  {
    const double x = left + number(0.1, 0.9) * size, y = low + number(0.1, 0.9) * size;
    return Point(x, y);
  }

  // In a cell, with increasing x or y, so that graphs of functions go through them.
  std::vector<Point> monotone_points(double left, double low, double size, int count)
  {
    const bool is_upward = number(0, 1) < 0.5;
    std::vector<Point> result;
    for (int i = 0; i < count; ++i) {
      const double along = (i + number(0.1, 0.9)) / count * size, across = number(0.1, 0.9) * size;
      result.push_back(is_upward ? Point(left + across, low + along) : Point(left + along, low + across));
    }
    return result;
  }

  // A periodic cubic spline of four to eight pieces around a point.
  Curve closed_spline(const Point& center, double size)
  {
    const int n = 4 + static_cast<int>(number(0, 5));
    std::vector<double> period;
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
      const double direction = 2 * CGAL_PI * i / n, radius = number(0.6, 1) * size;
      period.push_back(i);
      points.emplace_back(center.x() + radius * std::cos(direction), center.y() + radius * std::sin(direction));
    }
    period.push_back(n);
    return Curve::from_periodic(3, period, points);
  }

  double dyadic(double low, double high) { return std::round(64 * number(low, high)) / 64; }

  // One to three quarters of a circle, which are exactly circular in doubles, too.
  Curve arc(double left, double low, double size)
  {
    const Point center(left + size / 2, low + size / 2);
    const double y = dyadic(0.1, 0.3) * size, x = dyadic(-0.3, 0.3) * size;
    const CGAL::Vector_2<Kernel> radius(x, y), quarter = radius.perpendicular(CGAL::COUNTERCLOCKWISE);
    const double turn = number(0, 3);
    return SC::circular_arc_curve(center, center + radius,
                                  center +
                                      (turn < 1       ? quarter
                                           : turn < 2 ? -radius
                                                      : -quarter));
  }

  Curve circle(double x, double y, double least, double greatest)
  {
    return SC::circle_curve(Point(x, y), dyadic(least, greatest));
  }
};

// Of the number of the kind; the same one for the same seed. What is in one of the cells of a grid does not cross what
// is in others, but for curves that cross.
inline Scene scene(int kind, unsigned seed, int cells = 9)
{
  Scene_maker make(seed);
  Scene result;
  const auto for_each_cell = [cells](auto action) {
    for (int i = 0; i < cells; ++i)
      action(10.0 * (i % 3), 10.0 * (i / 3), i);
  };
  switch (kind) {
  case 0:
    result.kind = "points and segments";
    for_each_cell([&](double x, double y, int i) {
      const Point p = make.point(x, y, 10), q = make.point(x, y, 10);
      if (i % 3 == 0)
        result.points.push_back(p);
      else
        result.curves.push_back(SC::segment_curve(p, q));
    });
    break;
  case 1:
    result.kind = "circles";   // some of them in others
    for_each_cell([&](double x, double y, int i) {
      result.curves.push_back(make.circle(x, y, 3, 4.5));
      if (i % 2 == 0) {
        const double low = y + make.dyadic(-0.5, 0.5), left = x + make.dyadic(-0.5, 0.5);
        result.curves.push_back(make.circle(left, low, 0.5, 2));
      }
    });
    break;
  case 2:
    result.kind = "circular arcs";
    for_each_cell([&](double x, double y, int) { result.curves.push_back(make.arc(x, y, 10)); });
    break;
  case 3:
    result.kind = "splines";
    for_each_cell([&](double x, double y, int) {
      result.curves.push_back(Curve(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, make.monotone_points(x, y, 10, 7)));
    });
    break;
  case 4:
    result.kind = "closed curves";   // some of them in others
    for (int i = 0; i < cells / 2; ++i) {
      const double low = 10 * (i / 2) + make.number(-0.5, 0.5), left = 10 * (i % 2) + make.number(-0.5, 0.5);
      const Point center(left, low);
      result.curves.push_back(make.closed_spline(center, 5));
      if (i % 2 == 0)
        result.curves.push_back(make.closed_spline(center, 2));
    }
    break;
  case 5:
    result.kind = "curves that cross";
    for_each_cell([&](double x, double y, int) {
      result.curves.push_back(SC::bezier_curve(
          std::vector<Point>{make.point(x, y, 20), make.point(x, y, 20), make.point(x, y, 20), make.point(x, y, 20)}));
    });
    break;
  case 6:
    result.kind = "all of these";
    for_each_cell([&](double x, double y, int i) {
      switch (i % 5) {
      case 0: result.curves.push_back(SC::bezier_curve(make.monotone_points(x, y, 10, 4))); break;
      case 1: result.curves.push_back(make.arc(x, y, 10)); break;
      case 2: result.curves.push_back(make.closed_spline(Point(x + 5, y + 5), 4)); break;
      case 3: result.curves.push_back(make.circle(x + 5, y + 5, 1, 4)); break;
      default: result.curves.push_back(SC::polyline_curve(make.monotone_points(x, y, 10, 3)));
      }
      if (i % 2 == 1) {
        const double low = y + make.number(4, 6), left = x + make.number(4, 6);
        result.points.push_back(Point(left, low));
      }
    });
    break;
  default:
    result.kind = "medial axis";   // of a region with three holes
    result.is_region = true;
    result.curves.push_back(make.closed_spline(Point(0, 0), 12));
    result.curves.push_back(make.closed_spline(Point(3, 0), 2));
    result.curves.push_back(make.closed_spline(Point(-3, 2), 1.5));
    result.curves.push_back(make.circle(-1, -3, 0.4, 1.2));
  }
  return result;
}
constexpr int number_of_kinds = 8;

// The distance from a part of a curve, by points of it, and golden sections around those that may be next to the
// nearest one.
class Sampled_arc
{
  const Curve* m_curve;
  double m_begin, m_step;
  std::vector<Point> m_points;
  double m_longest = 0;   // chord

  double at(double i) const { return m_begin + i * m_step; }

  double least_between(const Point& q, double low, double high) const
  {
    constexpr double section = 0.6180339887498949;
    // the parameter is known to the root of the precision of doubles then, and the distance to this precision
    constexpr int steps = 45;
    const auto value = [&](double t) { return CGAL::squared_distance(q, (*m_curve)(t)); };
    double a = high - section * (high - low), b = low + section * (high - low), at_a = value(a), at_b = value(b);
    for (int i = 0; i < steps; ++i) {
      if (at_a < at_b) {
        high = b;
        b = a, at_b = at_a;
        a = high - section * (high - low), at_a = value(a);
      } else {
        low = a;
        a = b, at_a = at_b;
        b = low + section * (high - low), at_b = value(b);
      }
    }
    return std::min(at_a, at_b);
  }

public:
  Sampled_arc(const Curve& curve, double begin, double end, int samples)
    : m_curve(&curve), m_begin(begin), m_step((end - begin) / samples)
  {
    for (int i = 0; i <= samples; ++i) {
      m_points.push_back(curve(i == samples ? end : at(i)));
      m_longest = i == 0 ? 0 : std::max(m_longest, std::sqrt(CGAL::squared_distance(m_points[i - 1], m_points[i])));
    }
  }

  // Not less than the distance; and not more, but for rounding, if it is less than the given number.
  double distance(const Point& q, double most = std::numeric_limits<double>::infinity()) const
  {
    std::vector<double> squares;
    for (const Point& p : m_points)
      squares.push_back(CGAL::squared_distance(q, p));
    double result = *std::min_element(squares.begin(), squares.end());
    const double near = std::min(std::sqrt(result), most) + m_longest;
    const int last = static_cast<int>(squares.size()) - 1;
    for (int i = 0; i <= last; ++i)
      if (squares[i] <= near * near && (i == 0 || squares[i] <= squares[i - 1]) &&
          (i == last || squares[i] <= squares[i + 1]))
        result = std::min(result, least_between(q, at(std::max(i - 1, 0)), i == last ? at(last) : at(i + 1)));
    return std::sqrt(result);
  }
};

struct Answers
{
  std::size_t queries = 0;
  std::size_t regions = 0;        // that were found for some query
  // that do not have one region, or one that is farther than the nearest curve or point by more than twice the error of
  // chords
  std::size_t wrong_faces = 0;
  std::size_t wrong_sites = 0;    // of which one is farther than the nearest curve or point, by more than rounding
  std::size_t other_regions = 0;  // of faces that do not have the region of a nearest site: next to edges
  bool is_complete = false;
  bool has_same_topology = false;
};

class Nearest_site_check
{
  const Scene& m_scene;
  Diagram m_diagram;
  std::vector<Sampled_arc> m_arcs;         // of all curves
  std::vector<Sampled_arc> m_site_arcs;    // of the sites that are no points, which are the first ones

  static Diagram diagram_of(const Scene& scene)
  {
    return scene.is_region ? SC::medial_axis(SC::planar_region(scene.curves))
                           : SC::voronoi_diagram(scene.curves, scene.points);
  }

  double least_distance(const Point& q) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const Point& p : m_scene.points)
      result = std::min(result, std::sqrt(CGAL::squared_distance(p, q)));
    for (const Sampled_arc& arc : m_arcs)
      result = std::min(result, arc.distance(q, result));
    return result;
  }

  double site_distance(std::size_t site, const Point& q) const
  {
    return m_diagram.sites()[site].is_point ? std::sqrt(CGAL::squared_distance(m_diagram.sites()[site].point, q))
                                            : m_site_arcs[site].distance(q);
  }

  double region_distance(std::size_t region, const Point& q) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_diagram.sites().size(); ++i)
      if (m_diagram.sites()[i].region == region)
        result = std::min(result, site_distance(i, q));
    return result;
  }

  CGAL::Bbox_2 box() const
  {
    CGAL::Bbox_2 result;
    for (const auto& site : m_diagram.sites())
      result += site.point.bbox();
    const double margin = m_scene.is_region ? 3 : 8;
    return {result.xmin() - margin, result.ymin() - margin, result.xmax() + margin, result.ymax() + margin};
  }

  std::vector<Point> random_queries(std::size_t number, const CGAL::Bbox_2& box, unsigned seed) const
  {
    Scene_maker make(seed);
    std::vector<Point> result;
    const auto is_asked = [&,
                           region = m_scene.is_region ? std::vector{SC::planar_region(m_scene.curves)}
                                                      : std::vector<SC::Planar_region_2<Kernel>>()](const Point& q) {
      return region.empty() || region.front().bounded_side(q) == CGAL::ON_BOUNDED_SIDE;
    };
    while (result.size() < number) {
      const double x = make.number(box.xmin(), box.xmax()), y = make.number(box.ymin(), box.ymax());
      if (is_asked(Point(x, y)))
        result.emplace_back(x, y);
    }
    return result;
  }

public:
  explicit Nearest_site_check(const Scene& scene, int samples = 64) : m_scene(scene), m_diagram(diagram_of(scene))
  {
    for (const Curve& curve : scene.curves) {
      const auto breaks = curve.breaks();
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        m_arcs.emplace_back(curve, breaks[i], breaks[i + 1], samples);
    }
    for (const auto& site : m_diagram.sites())
      if (!site.is_point)
        m_site_arcs.emplace_back(scene.curves[*site.curve], site.parameters[0], site.parameters[1], samples);
  }

  const Diagram& diagram() const { return m_diagram; }

  Answers answers(std::size_t queries, double error, unsigned seed) const
  {
    using Arrangement = SC::Voronoi_arrangement_2<Kernel>::Arrangement;
    const auto voronoi = SC::to_arrangement(m_diagram, error, box());
    Answers result;
    result.is_complete = m_diagram.is_complete();
    result.has_same_topology = voronoi.has_same_topology;
    std::vector<Arrangement::Point_2> points;
    std::map<std::pair<double, double>, std::vector<std::size_t>> regions_at;
    const std::vector<Point> asked = random_queries(queries, box(), seed);
    for (const Point& q : asked)
      points.emplace_back(q.x(), q.y());
    std::vector<std::pair<Arrangement::Point_2, CGAL::Arr_point_location_result<Arrangement>::Type>> located;
    CGAL::locate(voronoi.arrangement, points.begin(), points.end(), std::back_inserter(located));
    for (const auto& [q, found] : located)
      if (const auto* face = get_if<Arrangement::Face_const_handle>(&found))
        regions_at[{CGAL::to_double(q.x()), CGAL::to_double(q.y())}] = (*face)->data();
    std::vector<bool> is_found(m_diagram.number_of_regions(), false);
    for (const Point& q : asked) {
      const double least = least_distance(q);
      const auto sites = m_diagram.nearest_sites(q);
      const auto& regions = regions_at[{q.x(), q.y()}];
      ++result.queries;
      result.wrong_sites += sites.empty() || std::any_of(sites.begin(), sites.end(), [&](std::size_t site) {
                              return site_distance(site, q) > least + 1e-11;
                            });
      const bool is_one = regions.size() == 1;
      const bool is_other = is_one && std::none_of(sites.begin(), sites.end(), [&](std::size_t site) {
                              return m_diagram.sites()[site].region == regions.front();
                            });
      result.other_regions += is_other;
      result.wrong_faces += !is_one || region_distance(regions.front(), q) > least + 2 * error;
      if (is_one)
        is_found[regions.front()] = true;
    }
    result.regions = static_cast<std::size_t>(std::count(is_found.begin(), is_found.end(), true));
    return result;
  }
};

} // namespace nearest_site_checks

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_NEAREST_SITE_CHECKS_H
