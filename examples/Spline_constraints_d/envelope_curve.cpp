// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The envelope of a closed curve B that is moved along a closed curve A: all sums of points with parallel tangents.
// Those with tangents in the same direction are the convolution of the curves; the boundary of the Minkowski sum of the
// two regions is a part of it.
//
// If B is a circle, the envelope is the offset curves of A.
//
// Writes envelope_curve.svg and envelope_of_circle.svg. Exit status: 0 when nothing is undecided, 3 when something is,
// 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/envelope_curves_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

// A smooth closed cubic spline.
Curve closed_curve(const std::vector<K::Point_2>& points)
{
  std::vector<double> knots;
  for (std::size_t i = 0; i <= points.size(); ++i)
    knots.push_back(static_cast<double>(i));
  return Curve::from_periodic(3, knots, points);
}

void draw(SC::SVG_writer& picture, const SC::Curve_pair_locus_2<K>& envelope, const std::string& color, double width)
{
  for (const auto& curve : envelope.curves())
    picture.polyline(envelope.polyline(curve, 5e-3, 100), color, width);
}

// The curve that moves in some of its positions, the envelope, with the convolution in red, and the other curve.
bool draw(const Curve& a, const Curve& b, double step, const std::string& path)
{
  const auto any = SC::envelope_curves(a, b, SC::Tangent_directions::ANY), same = SC::envelope_curves(a, b);
  const CGAL::Bbox_2 box = a.bbox(), moved = b.bbox();
  std::ofstream file(path);
  SC::SVG_writer picture(file,
                         CGAL::Bbox_2(box.xmin() + moved.xmin(), box.ymin() + moved.ymin(), box.xmax() + moved.xmax(),
                                      box.ymax() + moved.ymax()),
                         700);
  for (double t = 0; t < a.domain().second; t += step)
    picture.curve(b.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, a(t) - CGAL::ORIGIN)), "#ddd", 1);
  draw(picture, any, "#1f77b4", 1.5);
  draw(picture, same, "#d62728", 3);
  picture.curve(a, "black", 3);
  std::cout << "all:            " << any << "\nsame direction: " << same << '\n';
  return any.is_complete() && same.is_complete();
}

int main()
{
  try {
    const Curve a = closed_curve({{7, 0}, {4, 7}, {0, 2}, {-5, 6}, {-6, -2}, {-2, -6}, {1, -2}, {5, -6}});
    const Curve b = closed_curve({{3, 0}, {0, 2}, {-2, 1}, {-2, -2}, {1, -2}});
    const bool is_complete = draw(a, b, 0.25, "envelope_curve.svg"),
               is_complete_for_circle =
                   draw(a, SC::circle_curve(K::Point_2(0, 0), 1.75), 0.5, "envelope_of_circle.svg");
    return is_complete && is_complete_for_circle ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
