// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A curve that is prepared once for thousands of queries: how far the points of a grid are from it, and where the rays
// of a lamp meet it first; drawn into locators.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

constexpr double pi = 3.14159265358979;

// A closed cubic spline with five leaves around a point.
Curve flower(double x, double y)
{
  std::vector<double> knots;
  std::vector<K::Point_2> points;
  for (int i = 0; i <= 30; ++i)
    knots.push_back(i);
  for (int i = 0; i < 30; ++i) {
    const double angle = pi * i / 15, radius = 2.1 + 0.9 * std::cos(5 * angle);
    points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return Curve::from_periodic(3, knots, points);
}

// Bands of equal distances from the curve, by rows of a grid; returns how many points have one nearest point, by proof.
std::size_t draw_bands(SC::SVG_writer& picture, const SC::Curve_locator_2<K>& locator, double size, int cells)
{
  const std::string colors[] = {"#f7fbff", "#deebf7", "#c6dbef", "#9ecae1"};
  const double step = 2 * size / cells;
  std::size_t unique = 0;
  for (int i = 0; i < cells; ++i) {
    const double y = -size + step * (i + 0.5);
    int begin = 0, last_band = -1;
    for (int j = 0; j <= cells; ++j) {
      int band = -1;
      if (j < cells) {
        const auto nearest = locator.closest_point(K::Point_2(-size + step * (j + 0.5), y));
        unique += nearest.is_unique();
        band = static_cast<int>(nearest.distance_range().first / 0.2) % 4;
      }
      if (band != last_band && last_band >= 0)
        picture.curve(SC::segment_curve(K::Point_2(-size + step * begin, y), K::Point_2(-size + step * j, y)),
                      colors[last_band], 1.1 * step / picture.pixel());
      if (band != last_band)
        begin = j;
      last_band = band;
    }
  }
  return unique;
}

// Rays from a point to where they meet the curve first; returns how many do.
int draw_rays(SC::SVG_writer& picture, const SC::Curve_locator_2<K>& locator, const K::Point_2& lamp, int rays)
{
  int hits = 0;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2 * pi * (i + 0.5) / rays;
    const K::Point_2 target(lamp.x() + std::cos(angle), lamp.y() + std::sin(angle));
    if (const auto hit = locator.first_intersection(K::Ray_2(lamp, target))) {
      picture.curve(SC::segment_curve(lamp, hit->point()), "#fdae6b", 1);
      ++hits;
    }
  }
  picture.point(lamp, "#e6550d", 9);
  return hits;
}

int main()
{
  const SC::Curve_locator left(flower(0, 0)), right(flower(7, 0));
  std::ofstream out("locators.svg");
  SC::SVG_writer picture(out, CGAL::Bbox_2(-3.4, -3.4, 10.4, 3.4), 780);
  const int cells = 104, rays = 150;
  const std::size_t unique = draw_bands(picture, left, 3.25, cells);
  const int hits = draw_rays(picture, right, K::Point_2(7.5, 0.3), rays);
  for (const auto* locator : {&left, &right})
    picture.curve(locator->curve(), "#08519c", 2);
  const auto nearest = left.closest_point(K::Point_2(3.2, 1.5));
  std::cout.precision(15);
  std::cout << cells * cells << " points, " << unique << " with one nearest point\n"
            << rays << " rays, " << hits << " meet the curve\n"
            << "the distance of (3.2, 1.5) is between " << nearest.distance_range().first << " and "
            << nearest.distance_range().second << ", at the parameter " << nearest.parameter() << '\n';
  return unique == static_cast<std::size_t>(cells) * cells && hits == rays ? 0 : 1;
}
