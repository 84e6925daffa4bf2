// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes curves of solutions as polylines: into .txt with all unknowns, into .vtp with the first three, into .svg as a
// picture of the first two.
#ifndef CURVE_OUTPUT_H
#define CURVE_OUTPUT_H

#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_VTP.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

using Polyline = std::vector<std::vector<double>>;

inline void write_text(std::ostream& out, const std::vector<std::string>& names, const std::vector<Polyline>& polylines)
{
  for (const std::string& name : names)
    out << (&name == &names.front() ? "# " : " ") << name;
  out << '\n';
  out.precision(17);
  for (const Polyline& polyline : polylines)
    for (const std::vector<double>& point : polyline) {
      for (const double coordinate : point)
        out << coordinate << ' ';
      out << (&point == &polyline.back() ? "\n\n" : "\n");
    }
}

inline void write_polydata(std::ostream& out, const std::vector<Polyline>& polylines)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<std::vector<Point>> in_space;
  for (const Polyline& polyline : polylines) {
    in_space.emplace_back();
    for (const std::vector<double>& point : polyline)
      in_space.back().emplace_back(point[0], point[1], point.size() > 2 ? point[2] : 0);
  }
  CGAL::Spline_constraints::IO::write_VTP(out, in_space);
}

inline void draw(std::ostream& out, const std::vector<std::string>& names, const CGAL::Bbox_2& view,
                 const CGAL::Spline_constraints::Curve_solution_set_d& set, const std::vector<Polyline>& polylines)
{
  using Point = CGAL::Simple_cartesian<double>::Point_2;
  const double margin = 0.08 * (view.xmax() - view.xmin());
  CGAL::Spline_constraints::SVG_writer picture(
      out, CGAL::Bbox_2(view.xmin() - margin, view.ymin() - margin, view.xmax() + margin, view.ymax() + margin), 600);
  const std::vector<Point> frame{{view.xmin(), view.ymin()},
                                 {view.xmax(), view.ymin()},
                                 {view.xmax(), view.ymax()},
                                 {view.xmin(), view.ymax()},
                                 {view.xmin(), view.ymin()}};
  picture.curve(CGAL::Spline_constraints::polyline_curve(frame), "#99a", 1);
  for (std::size_t i = 0; i < polylines.size(); ++i) {
    std::vector<Point> points;
    for (const std::vector<double>& point : polylines[i])
      points.emplace_back(point[0], point[1]);
    picture.curve(CGAL::Spline_constraints::polyline_curve(points), set.curves()[i].is_closed ? "#2ca02c" : "#1f77b4",
                  2);
  }
  for (const auto* points : {&set.singular_points(), &set.points()})
    for (const std::size_t i : *points)
      picture.point(Point(set.vertices()[i].point()[0], set.vertices()[i].point()[1]), "#d62728", 8);
  picture.label(Point(view.xmax(), view.ymin() - 0.6 * margin), names[0], "black", 14);
  picture.label(Point(view.xmin() - 0.6 * margin, view.ymax()), names[1], "black", 14);
}

// Behind the curves, single and singular points: no curve need pass them.
inline std::vector<Polyline> with_points(const CGAL::Spline_constraints::Curve_solution_set_d& set,
                                         std::vector<Polyline> polylines)
{
  for (const auto* points : {&set.points(), &set.singular_points()})
    for (const std::size_t i : *points)
      polylines.push_back({set.vertices()[i].point()});
  return polylines;
}

// Chords are a thousandth of the domain from the curves at most.
inline void write_curves(const std::string& path, const std::vector<std::string>& names,
                         const CGAL::Spline_constraints::Constraint_system_d& system,
                         const CGAL::Spline_constraints::Curve_solution_set_d& set)
{
  using CGAL::Spline_constraints::Invalid_input;
  const auto range = [&](int unknown) {
    return std::pair(CGAL::to_double(system.domain(unknown).first), CGAL::to_double(system.domain(unknown).second));
  };
  double size = 0;
  for (int v = 0; v < system.dimension(); ++v)
    size = (std::max)(size, range(v).second - range(v).first);
  std::vector<Polyline> polylines;
  for (const auto& curve : set.curves())
    polylines.push_back(CGAL::Spline_constraints::to_polyline(system, set, curve, 1e-3 * size));

  std::ofstream out(path);
  if (path.ends_with(".svg"))
    draw(out, names, CGAL::Bbox_2(range(0).first, range(1).first, range(0).second, range(1).second), set, polylines);
  else if (path.ends_with(".vtp"))
    write_polydata(out, with_points(set, polylines));
  else if (path.ends_with(".txt"))
    write_text(out, names, with_points(set, polylines));
  else
    throw Invalid_input("--output: " + path + " ends neither with .svg nor with .vtp or .txt");
  if (!out.flush())
    throw Invalid_input("--output: " + path + " cannot be written");
}

#endif // CURVE_OUTPUT_H
