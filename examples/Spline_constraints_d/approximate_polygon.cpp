// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a point is inside of a polygon, when neither the point nor the edges are known exactly, but on which side of
// each edge the point is.
//
//   approximate_polygon
//
// Writes approximate_polygon.svg: the bands of the edges (orange), two polygons that have their edges in them (black),
// and the points that have the same signature in all of these polygons, green where they are inside, blue where they
// are outside. Pale green and gray: inside and outside too, but lines of different such polygons pass on both sides.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/approximate_polygons_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Number>;
using Point = K::Point_2;
using Polygon = CGAL::Polygon_2<K>;

namespace {

std::string color_of(const SC::Signature_cell_2& cell, std::size_t number)
{
  static const std::vector<std::string> greens{"#74c476", "#41ab5d", "#a1d99b"}, blues{"#deebf7", "#c6dbef", "#b3cde3"};
  return (cell.location == SC::Signature_location::INSIDE ? greens : blues)[number % 3];
}

template <class Points>
Point center_of(const Points& points)
{
  K::Vector_2 sum = CGAL::NULL_VECTOR;
  for (const Point& p : points)
    sum = sum + (p - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / Number(static_cast<unsigned long>(points.size()));
}

void draw_outline(SC::SVG_writer& picture, const Polygon& polygon, const std::string& color, double width)
{
  std::vector<Point> points(polygon.begin(), polygon.end());
  points.push_back(points.front());
  picture.polyline(points, color, width);
}

} // namespace

int main()
{
  const std::vector<Point> corners{{0, 0}, {0, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 0}};
  const SC::Approximate_polygon_2 polygon =
      SC::approximate_polygon(Polygon(corners.begin(), corners.end()), Number(1) / 4);
  const SC::Signature_cells_2 cells = SC::signature_cells(polygon);

  std::cout << cells.cells().size() << " of " << (1u << polygon.size()) << " signatures, inside:";
  for (const SC::Signature_cell_2& cell : cells.cells())
    if (cell.location == SC::Signature_location::INSIDE)
      std::cout << ' ' << cell.signature;
  std::cout << '\n';
  for (const std::string signature : {"RRRLRR", "RRRLLR", "LLLLLL"})
    std::cout << signature << ": " << polygon.locate(signature) << '\n';

  // A part of the plane is in the cells of all signatures that its points have in any of these polygons.
  std::map<std::vector<Point>, int> signatures_of_part;
  for (const SC::Signature_cell_2& cell : cells.cells())
    for (const Polygon& part : cell.parts)
      ++signatures_of_part[{part.begin(), part.end()}];

  std::ofstream file("approximate_polygon.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-3.5, -3, 9.5, 9), 800);
  picture.layer("lines pass");
  for (const auto& [part, signatures] : signatures_of_part)
    if (signatures > 1)
      picture.polygon(part, CGAL::possibly(polygon.is_inside(center_of(part))) ? "#e5f5e0" : "#e8e8e8");
  picture.layer("one signature");
  std::size_t number = 0;
  for (const SC::Signature_cell_2& cell : cells.cells()) {
    const Polygon* largest = nullptr;
    for (const Polygon& part : cell.parts)
      if (signatures_of_part[{part.begin(), part.end()}] == 1) {
        picture.polygon(part, color_of(cell, number));
        if (largest == nullptr || abs(part.area()) > abs(largest->area()))
          largest = &part;
      }
    if (largest != nullptr && cell.location == SC::Signature_location::INSIDE)
      picture.label(center_of(*largest), cell.signature);
    ++number;
  }
  picture.layer("bands");
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Polygon band = polygon.band(i);
    picture.polygon(band, "#fdae6b");
    draw_outline(picture, band, "#d94801", 1);
  }
  picture.layer("two models");
  const std::vector<std::pair<Number, Number>> one(polygon.size(), {0, 1}), other(polygon.size(), {1, Number(1) / 4});
  draw_outline(picture, polygon.model(one), "black", 1.5);
  draw_outline(picture, polygon.model(other), "black", 1.5);
  return cells.is_complete() ? 0 : 3;
}
