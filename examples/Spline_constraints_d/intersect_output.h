// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What intersect is asked, what it prints, and its picture.
#ifndef INTERSECT_OUTPUT_H
#define INTERSECT_OUTPUT_H

#include "solve_system_output.h"

#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
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
};

inline Arguments parse(int argc, char* argv[], const Arguments& without_arguments)
{
  Arguments result;
  if (argc == 1)
    return without_arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool is_option = word == "--svg" || word == "--time-limit";
    if (is_option && ++i == argc)
      throw SC::Invalid_input(word + " needs a value");
    if (word == "--svg") result.picture = argv[i];
    else if (word == "--time-limit") result.options.time_limit = number(word, argv[i]);
    else if (word.starts_with("--") || result.files.size() == 2) throw SC::Invalid_input("unknown argument " + word);
    else result.files.push_back(word);
  }
  if (result.files.empty())
    throw SC::Invalid_input("usage: intersect [A [B]] [--svg OUT] [--time-limit S], with files .svg, .itd or .g2. All "
                            "intersections of curves with curves and surfaces, and where surfaces touch"
                            " (not their curves of intersection), of A with B; without B, within A");
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

class Report
{
  struct Style { Kind kind; const char *singular, *plural, *color; };

  struct Drawn_curve { SC::Bspline_curve_2<K> curve; double width; };

  static constexpr std::array<Style, 5> styles{{{Kind::TRANSVERSAL, "transversal", "transversal", "#2ca02c"},
                                                {Kind::TANGENT, "tangent", "tangent", "#d62728"},
                                                {Kind::END_POINT, "end point", "end points", "#9467bd"},
                                                {Kind::OVERLAP, "overlap", "overlaps", "#e377c2"},
                                                {Kind::UNDECIDED, "undecided", "undecided", "#ff9900"}}};

  const File &m_a, &m_b;
  SC::Summary m_total;
  std::array<std::size_t, styles.size()> m_count{};
  std::vector<std::pair<K::Point_2, Kind>> m_points;
  std::vector<SC::Bspline_curve_2<K>> m_overlaps;

public:
  Report(const File& a, const File& b) : m_a(a), m_b(b)
  {
    const auto is_flat = [](const File& file) { return !file.curves_2.empty(); };
    const auto is_in_space = [](const File& file) { return !file.curves_3.empty() || !file.surfaces_3.empty(); };
    if (!(is_flat(a) && is_flat(b)) && !(is_in_space(a) && is_in_space(b)))
      throw SC::Invalid_input("there are no curves or surfaces in the same space");
  }

  void add(const SC::Summary& summary) { m_total += summary; }

  template <class First, class Second, class Intersections>
  void add(const SC::Spline_file_entry<First>& first, const SC::Spline_file_entry<Second>& second,
           const Intersections& intersections)
  {
    for (const auto& x : intersections) {
      ++m_count[static_cast<std::size_t>(x.kind())];
      std::cout << x.kind();
      if (x.kind() == Kind::TANGENT && x.multiplicity() > 0)
        std::cout << " of multiplicity " << x.multiplicity();
      print_parameters<First::number_of_parameters>(first, x, 0);
      print_parameters<Second::number_of_parameters>(second, x, 1);
      std::cout << std::setprecision(6);
      for (int i = 0; i < First::ambient_dimension; ++i)
        std::cout << (i == 0 ? "  near (" : ", ") << CGAL::to_double(x.point().cartesian(i));
      std::cout << ")\n";
      m_points.emplace_back(flat(x.point()), x.kind());
      if constexpr (First::number_of_parameters == 1)
        if (x.kind() == Kind::OVERLAP && x.parameter_range(0).first < x.parameter_range(0).second)
          m_overlaps.push_back(flat(first.object.restricted(x.parameter_range(0).first, x.parameter_range(0).second)));
    }
  }

  bool is_complete() const { return m_total.is_complete && m_count[static_cast<std::size_t>(Kind::UNDECIDED)] == 0; }

  void print_summary() const
  {
    std::cout << "intersections: ";
    for (std::size_t i = 0; i < styles.size(); ++i)
      std::cout << (i == 0 ? "" : ", ") << counted(i);
    std::cout << "; complete: " << (is_complete() ? "yes" : "no") << "; nodes " << m_total.nodes << "; seconds "
              << std::setprecision(4) << m_total.seconds << '\n';
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
    for (const auto& [point, kind] : m_points)
      if (kind != Kind::OVERLAP)
        picture.point(point, styles[static_cast<std::size_t>(kind)].color, 8);
    double x = box.xmin() - margin / 2;
    for (std::size_t i = 0; i < styles.size(); ++i)
      if (m_count[i] > 0) {
        picture.label(K::Point_2(x, top - 20 * pixel), counted(i), styles[i].color);
        x += 130 * pixel;
      }
    picture.label(K::Point_2(x, top - 20 * pixel), is_complete() ? "complete: yes" : "complete: no");
  }

private:
  std::string counted(std::size_t i) const
  {
    return std::to_string(m_count[i]) + ' ' + (m_count[i] == 1 ? styles[i].singular : styles[i].plural);
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
    std::cout << "  " << (entry.name.empty() ? "" : entry.name + ':') << entry.line << ':' << entry.column << " with"
              << std::setprecision(17);
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
