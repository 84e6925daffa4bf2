// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The faces of an arrangement of curves of solutions: where T5(x) is larger than T6(y), drawn into
// curve_arrangement.svg. Across each edge of the curve, the sign changes.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_arrangement_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <fstream>
#include <iostream>
#include <map>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Face = SC::Polyline_arrangement_2::Face_const_handle;
using Point = SC::Polyline_arrangement_2::Point_2;

int main()
{
  auto [x, y] = SC::unknowns({-1.05, 1.05}, {-1.05, 1.05});
  const auto t5 = [](const SC::Expression& t) { return 16*pow(t, 5) - 20*pow(t, 3) + 5*t; };
  const auto t6 = [](const SC::Expression& t) { return 32*pow(t, 6) - 48*pow(t, 4) + 18*square(t) - 1; };
  const std::vector<SC::Constraint> constraints{t5(x) == t6(y)};
  const SC::Constraint_system_d system = make_system(constraints);
  const SC::Curve_solution_set_d set = SC::solve_curves(system);

  // The curves, and behind them the boundary of the domain.
  auto polylines = SC::to_arrangement(system, set, 1e-3).polylines;
  const std::size_t frame = polylines.size();
  polylines.push_back(
      {Point(-1.05, -1.05), Point(1.05, -1.05), Point(1.05, 1.05), Point(-1.05, 1.05), Point(-1.05, -1.05)});
  const SC::Polyline_arrangement_2 arrangement = SC::to_arrangement(polylines);

  // From each face to its neighbours. The first one inside has the corner (-1.05, -1.05), where T5 is negative and T6
  // is positive.
  std::map<Face, bool> is_positive{{arrangement.unbounded_face(), false}};
  std::vector<Face> faces{arrangement.unbounded_face()};
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (auto e = arrangement.halfedges_begin(); e != arrangement.halfedges_end(); ++e) {
      const SC::Chord_label label = *e->curve().data().begin();
      const bool is_corner = label.curve == frame &&
          (e->source()->point() == polylines[frame][0] || e->target()->point() == polylines[frame][0]);
      if (e->face() == faces[i] && (label.curve != frame || (i == 0 && is_corner)) &&
          is_positive.emplace(e->twin()->face(), is_positive[faces[i]] != (label.curve != frame)).second)
        faces.push_back(e->twin()->face());
    }

  std::ofstream file("curve_arrangement.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-1.15, -1.15, 1.15, 1.25), 600);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    std::vector<Point> polygon;
    auto e = faces[i]->outer_ccb();
    do
      polygon.push_back(e->source()->point());
    while (++e != faces[i]->outer_ccb());
    picture.polygon(polygon, is_positive[faces[i]] ? "#fdd0a2" : "#c6dbef");
  }
  for (const std::size_t i : set.singular_points())
    picture.point(Point(set.vertices()[i].point()[0], set.vertices()[i].point()[1]), "#d62728", 7);
  picture.label(Point(-1.05, 1.12), "T5(x) > T6(y) (orange), T5(x) < T6(y) (blue), 10 nodes (red)");
  std::cout << set << '\n'
            << arrangement.number_of_faces() << " faces, " << faces.size() - 1 << " of them in the domain\n";
  return set.is_complete() && set.singular_points().size() == 10 && faces.size() == arrangement.number_of_faces() ? 0
                                                                                                                  : 1;
}
