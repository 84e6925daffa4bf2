// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What intersect is asked, what it prints, and its picture.
#ifndef INTERSECT_OUTPUT_H
#define INTERSECT_OUTPUT_H

#include "near_coincidences.h"
#include "solve_system_output.h"

#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using File = SC::Spline_file<K>;
using Kind = SC::Intersection_kind;

struct Arguments
{
  std::vector<std::string> files;
  std::string picture;
  SC::Solver_options options;
  std::optional<double> healing_tolerance = {}, near_distance = {};
};

inline Arguments parse(int argc, char* argv[], const Arguments& without_arguments)
{
  Arguments result;
  if (argc == 1)
    return without_arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool is_option = word == "--svg" || word == "--time-limit" || word == "--heal" || word == "--near";
    if (is_option && ++i == argc)
      throw SC::Invalid_input(word + " needs a value");
    if (word == "--svg") result.picture = argv[i];
    else if (word == "--time-limit") result.options.time_limit = number(word, argv[i]);
    else if (word == "--heal") result.healing_tolerance = number(word, argv[i]);
    else if (word == "--near") result.near_distance = number(word, argv[i]);
    else if (word.starts_with("--") || result.files.size() == 2) throw SC::Invalid_input("unknown argument " + word);
    else result.files.push_back(word);
  }
  if (result.files.empty())
    throw SC::Invalid_input("usage: intersect [A [B]] [--heal TOLERANCE] [--near DISTANCE] [--svg OUT] "
                            "[--time-limit S], with files .svg, .itd or .g2. All intersections of curves and surfaces "
                            "of A with those of B; without B, within A");
  return result;
}

// Curves in space are seen in a parallel projection.
inline SC::Bspline_curve_2<K> flat(const SC::Bspline_curve_2<K>& curve) { return curve; }

inline SC::Bspline_curve_2<K> flat(const SC::Bspline_curve_3<K>& curve)
{
  const auto [x, y, z] = curve.homogeneous_coordinates();
  return SC::Bspline_curve_2<K>::from_homogeneous_coordinates({x - y * K::FT(3, 5), z + (x + y) * K::FT(1, 5)},
                                                              curve.weight());
}

inline K::Point_2 flat(const K::Point_2& p) { return p; }
inline K::Point_2 flat(const K::Point_3& p) { return {p.x() - p.y() * 3 / 5, p.z() + (p.x() + p.y()) / 5}; }

// From the coordinates in which intersections are computed to those of the files.
struct Motions
{
  K::Aff_transformation_2 in_the_plane{CGAL::IDENTITY};
  K::Aff_transformation_3 in_space{CGAL::IDENTITY};

  K::Point_2 operator()(const K::Point_2& p) const { return in_the_plane.transform(p); }
  K::Point_3 operator()(const K::Point_3& p) const { return in_space.transform(p); }
  SC::Bspline_curve_2<K> operator()(const SC::Bspline_curve_2<K>& c) const { return c.transformed(in_the_plane); }
  SC::Bspline_curve_3<K> operator()(const SC::Bspline_curve_3<K>& c) const { return c.transformed(in_space); }
};

class Report
{
  struct Style { Kind kind; const char *singular, *plural, *color; };

  struct Drawn_curve { SC::Bspline_curve_2<K> curve; double width; };

  static constexpr const char* curve_color = "#17becf";
  static constexpr std::array<Style, 5> styles{{{Kind::TRANSVERSAL, "transversal", "transversal", "#2ca02c"},
                                                {Kind::TANGENT, "tangent", "tangent", "#d62728"},
                                                {Kind::END_POINT, "end point", "end points", "#9467bd"},
                                                {Kind::OVERLAP, "overlap", "overlaps", "#e377c2"},
                                                {Kind::UNDECIDED, "undecided", "undecided", "#ff9900"}}};

  const File &m_a, &m_b;
  Motions m_moved;
  SC::Summary m_total;
  std::array<std::size_t, styles.size()> m_count{};
  std::vector<std::pair<K::Point_2, Kind>> m_points;
  std::vector<SC::Bspline_curve_2<K>> m_overlaps, m_curves;   // m_curves: those of two surfaces
  std::size_t m_near_coincidences = 0;
  bool m_has_all_near_coincidences = true;

public:
  Report(const File& a, const File& b, Motions moved) : m_a(a), m_b(b), m_moved(std::move(moved))
  {
    const auto is_flat = [](const File& file) { return !file.curves_2.empty(); };
    const auto is_in_space = [](const File& file) { return !file.curves_3.empty() || !file.surfaces_3.empty(); };
    if (!(is_flat(a) && is_flat(b)) && !(is_in_space(a) && is_in_space(b)))
      throw SC::Invalid_input("there are no curves or surfaces in the same space");
  }

  void add(const SC::Summary& summary) { m_total += summary; }

  // What is undecided apart from the answers.
  void add(const SC::Undecided_part& part)
  {
    ++m_count[static_cast<std::size_t>(Kind::UNDECIDED)];
    std::cout << part << '\n';
  }

  template <class First, class Second, class Intersections>
  void add(const SC::Spline_file_entry<First>& first, const SC::Spline_file_entry<Second>& second,
           const Intersections& intersections)
  {
    for (const auto& x : intersections) {
      add_point(first, second, x);
      if constexpr (First::number_of_parameters == 1)
        if (x.kind() == Kind::OVERLAP && x.parameter_range(0).first < x.parameter_range(0).second)
          m_overlaps.push_back(
              flat(m_moved(first.object.restricted(x.parameter_range(0).first, x.parameter_range(0).second))));
    }
  }

  // Curves, and the points that are not just some of many along them.
  template <class First, class Second>
  void add(const SC::Spline_file_entry<First>& first, const SC::Spline_file_entry<Second>& second,
           const SC::Surface_intersection<K>& set)
  {
    const CGAL::Bbox_3 box = first.object.bbox();
    const double error = 1e-3 * (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    for (const SC::Intersection_curve& curve : set.curves()) {
      std::cout << "curve " << (curve.is_closed ? "closed, " : "open, ") << curve.kind();
      print_name(first);
      print_name(second);
      print_place(m_moved(set.end(curve, 0).point()));
      m_curves.push_back(flat(m_moved(SC::polyline_curve(set.polyline(curve, error)))));
    }
    const auto undecided = set.undecided_points();
    for (const auto* points : {&set.points(), &set.singular_points(), &undecided})
      for (const auto& point : *points)
        add_point(first, second, point);
  }

  // Special points that nearly coincide.
  template <class First, class Second, class Near_coincidence>
  void add_near(const SC::Spline_file_entry<First>& first, const SC::Spline_file_entry<Second>& second,
                const Near_coincidence& near)
  {
    ++m_near_coincidences;
    print_near_coincidence<First::number_of_parameters, Second::number_of_parameters>(
        near, [&] { print_name(first); }, [&] { print_name(second); });
    print_place(m_moved(near.point(0)));
  }
  void add_near(bool is_complete) { m_has_all_near_coincidences = m_has_all_near_coincidences && is_complete; }
  bool has_all_near_coincidences() const { return m_has_all_near_coincidences; }

  bool is_complete() const { return m_total.is_complete && m_count[static_cast<std::size_t>(Kind::UNDECIDED)] == 0; }

  void print_summary() const
  {
    std::cout << "intersections: ";
    for (std::size_t i = 0; i < styles.size(); ++i)
      std::cout << (i == 0 ? "" : ", ") << (styles[i].kind == Kind::UNDECIDED ? counted_curves() + ", " : "")
                << counted(i);
    std::cout << "; complete: " << (is_complete() ? "yes" : "no") << "; near coincidences "
              << (m_has_all_near_coincidences ? "" : "at least ") << m_near_coincidences << "; nodes " << m_total.nodes
              << "; seconds " << std::setprecision(4) << m_total.seconds << '\n';
  }

  // The first file in blue, the second one in orange.
  void draw(const std::string& path) const
  {
    const std::vector<Drawn_curve> first = drawn_curves(m_a),
                                   second = &m_a == &m_b ? std::vector<Drawn_curve>() : drawn_curves(m_b);
    CGAL::Bbox_2 box;
    for (const auto* curves : {&first, &second})
      for (const Drawn_curve& drawn : *curves)
        box += bbox_of_points(drawn.curve);
    constexpr double width = 720;
    const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), margin = size / 20,
                 pixel = (box.xmax() - box.xmin() + 2 * margin) / width;
    const double top = box.ymax() + margin + 24 * pixel;
    std::ofstream file(path);
    if (!file)
      throw SC::Invalid_input(path + ": cannot be written");
    SC::SVG_writer picture(file, CGAL::Bbox_2(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin, top),
                           width);
    for (const auto& [curve, line_width] : first)
      picture.curve(curve, "#1f77b4", line_width);
    for (const auto& [curve, line_width] : second)
      picture.curve(curve, "#ff7f0e", line_width);
    for (const auto& curve : m_overlaps)
      picture.curve(curve, styles[3].color, 5);
    for (const auto& curve : m_curves)
      picture.curve(curve, curve_color, 3);
    for (const auto& [point, kind] : m_points)
      if (kind != Kind::OVERLAP)
        picture.point(point, styles[static_cast<std::size_t>(kind)].color, 8);
    double x = box.xmin() - margin / 2;
    const auto label = [&](const std::string& text, const char* color) {
      picture.label(K::Point_2(x, top - 20 * pixel), text, color);
      x += 130 * pixel;
    };
    for (std::size_t i = 0; i < styles.size(); ++i)
      if (m_count[i] > 0)
        label(counted(i), styles[i].color);
    if (!m_curves.empty())
      label(counted_curves(), curve_color);
    label(is_complete() ? "complete: yes" : "complete: no", "black");
  }

private:
  static std::string counted(std::size_t number, const char* singular, const char* plural)
  {
    return std::to_string(number) + ' ' + (number == 1 ? singular : plural);
  }
  std::string counted(std::size_t i) const
  {
    return (is_complete() || styles[i].kind == Kind::UNDECIDED ? "" : "at least ") +
        counted(m_count[i], styles[i].singular, styles[i].plural);
  }
  std::string counted_curves() const
  {
    return is_complete() ? counted(m_curves.size(), "curve", "curves")
                         : counted(m_curves.size(), "curve or part of one", "curves or parts of curves");
  }

  template <class First, class Second, class Point>
  void add_point(const SC::Spline_file_entry<First>& first, const SC::Spline_file_entry<Second>& second, const Point& x)
  {
    ++m_count[static_cast<std::size_t>(x.kind())];
    std::cout << x.kind();
    if constexpr (requires { x.multiplicity(); })   // one is that of a corner
      if (x.kind() == Kind::TANGENT && x.multiplicity() > 1)
        std::cout << " of multiplicity " << x.multiplicity();
    if constexpr (requires { x.passage(); })
      if (x.passage() && x.kind() != Kind::TRANSVERSAL)
        std::cout << ", " << *x.passage();
    print_parameters<First::number_of_parameters>(first, x, 0);
    print_parameters<Second::number_of_parameters>(second, x, 1);
    const auto point = m_moved(x.point());
    print_place(point);
    m_points.emplace_back(flat(point), x.kind());
  }

  template <class Entry>
  static void print_name(const Entry& entry)
  {
    std::cout << "  " << (entry.name.empty() ? "" : entry.name + ':') << entry.line << ':' << entry.column;
  }

  template <class Point>
  static void print_place(const Point& point)
  {
    std::cout << std::setprecision(6);
    for (int i = 0; i < point.dimension(); ++i)
      std::cout << (i == 0 ? "  near (" : ", ") << CGAL::to_double(point.cartesian(i));
    std::cout << ")\n";
  }

  // Tighter than that of the control points.
  static CGAL::Bbox_2 bbox_of_points(const SC::Bspline_curve_2<K>& curve)
  {
    constexpr int steps = 64;
    const auto [begin, end] = curve.domain();
    CGAL::Bbox_2 result;
    for (int k = 0; k <= steps; ++k)
      result += curve(begin + (end - begin) * k / steps).bbox();
    return result;
  }

  // The object by its name and place in the file, and the ranges of its parameters.
  template <int number_of_parameters, class Entry, class Intersection>
  static void print_parameters(const Entry& entry, const Intersection& x, std::size_t operand)
  {
    const char* const names[] = {number_of_parameters == 1 ? "t" : "u", "v"};
    print_name(entry);
    std::cout << " with" << std::setprecision(17);
    for (std::size_t axis = 0; axis < number_of_parameters; ++axis) {
      const auto [lower, upper] = as_doubles(x.parameter_range(operand, axis));
      std::cout << ' ' << names[axis] << " in [" << lower << ',' << upper << ']';
    }
  }

  // With thin lines for surfaces.
  static std::vector<Drawn_curve> drawn_curves(const File& file)
  {
    std::vector<Drawn_curve> result;
    for (const auto& entry : file.curves_2)
      result.push_back({entry.object, 1.5});
    for (const auto& entry : file.curves_3)
      result.push_back({flat(entry.object), 1.5});
    constexpr int lines = 8;
    for (const auto& entry : file.surfaces_3)
      for (const int axis : {0, 1}) {
        const auto [begin, end] = entry.object.domain(axis);
        for (int k = 0; k <= lines; ++k)
          result.push_back({flat(entry.object.iso_curve(axis, begin + (end - begin) * k / lines)), 0.5});
      }
    return result;
  }
};

#endif // INTERSECT_OUTPUT_H
