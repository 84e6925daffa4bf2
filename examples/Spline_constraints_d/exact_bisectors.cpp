// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of a point and a parabola as rational curves, and the edges of the Voronoi diagram that are parts of
// these: their points have the same distance from both, exactly. Drawn into exact_bisectors.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/point_curve_bisector_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_edge_curves_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;

int main()
{
  const auto parabola = SC::bezier_curve(std::vector<Point>{{-2, 4}, {0, -4}, {2, 4}});   // y = x^2
  const Point point(0, -1);
  const auto bisector = SC::point_curve_bisector(point, parabola);
  std::cout << "untrimmed: " << bisector.curves().size() << " curves of degree " << bisector.curves().front().degree()
            << ", " << bisector.poles().size() << " poles\n";

  const auto diagram = SC::voronoi_diagram(std::vector{parabola}, std::vector{point});
  std::ofstream file("exact_bisectors.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-4, -4, 4, 4), 480);
  picture.curve(parabola, "black", 2);
  picture.point(point, "black");
  std::size_t edges = 0;
  bool is_equal = true;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    if (const auto curve = SC::exact_edge_curve(diagram, e, std::vector{parabola})) {
      ++edges;
      picture.curve(*curve, "#d62728", 2);
      const auto [begin, end] = curve->domain();
      const SC::Exact_rational t = (begin + 2 * end) / 3;
      const Point center = (*curve)(t);
      is_equal = is_equal && CGAL::squared_distance(center, point) == CGAL::squared_distance(center, parabola(t));
    }
  std::cout << "edges: " << edges << ", with equal distances: " << (is_equal ? "yes" : "no") << '\n';
  return bisector.is_complete() && diagram.is_complete() && is_equal && edges > 0 ? 0 : 1;
}
