// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves that run over themselves: how often almost all of their points are taken, and where they turn back.
//
//   curve_properness [FILE] [--output OUT.svg] [--time-limit S]
//
// FILE is of GoTools (.g2) or IRIT (.itd); its curves are taken as the decimals they are. For each, the tracing index,
// the degree as a product of that of the proper curve and of the function of the parameter before it, and the folds.
// The last line repeats that with the greatest index, and degree. The picture shows this curve, if it is in the plane:
// as it is run through, its strands side by side, and its proper version. Red is what is covered more than once.
// Without arguments, a cubic curve whose parameter goes forth, back and forth again, drawn into curve_properness.svg.
// Exit status: 0 when all was looked at, 3 when not, 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/proper_curves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;
using K = CGAL::Simple_cartesian<double>;
using Picture_curve = SC::Bspline_curve_2<K>;

double rounded(const SC::Curve_stretch::Range& range)
{
  return CGAL::to_double(SC::Exact_rational((range.first + range.second) / 2));
}

// The cubic curve with these control points after 6 t - 15 t^2 + 10 t^3, which turns back twice.
SC::Bspline_curve_2<Exact> forth_back_and_forth()
{
  const int x[] = {0, 2, 4, 6}, y[] = {0, 9, -8, 2}, binomial[] = {1, 3, 3, 1};
  const std::vector<SC::Exact_rational> knots{0, 0, 0, 0, 1, 1, 1, 1};
  const SC::Bspline_function<SC::Exact_rational> u({3}, {knots}, {0, 2, -1, 1}), rest = -u + SC::Exact_rational(1);
  std::array<SC::Bspline_function<SC::Exact_rational>, 2> coordinates{u * SC::Exact_rational(0),
                                                                      u * SC::Exact_rational(0)};
  for (int i = 0; i < 4; ++i) {
    SC::Bspline_function<SC::Exact_rational> bernstein = u * SC::Exact_rational(0) + SC::Exact_rational(binomial[i]);
    for (int k = 0; k < 3; ++k)
      bernstein = bernstein * (k < i ? u : rest);
    coordinates[0] = coordinates[0] + bernstein * SC::Exact_rational(x[i]);
    coordinates[1] = coordinates[1] + bernstein * SC::Exact_rational(y[i]);
  }
  return SC::Bspline_curve_2<Exact>::from_homogeneous_coordinates(coordinates,
                                                                  u * SC::Exact_rational(0) + SC::Exact_rational(1));
}

// The picture of a curve in the plane.
class Properness_picture
{
  const SC::Proper_reparametrization<2>& m_proper;
  std::vector<Picture_curve> m_components;

public:
  explicit Properness_picture(const SC::Proper_reparametrization<2>& proper) : m_proper(proper)
  {
    for (const auto& component : proper.components)
      m_components.emplace_back(component.curve);
  }

  void write(std::ostream& out, const std::string& given, const std::string& proper) const
  {
    CGAL::Bbox_2 box;
    for (std::size_t i = 0; i < m_components.size(); ++i)
      for (int k = 0; k <= steps; ++k) {
        const auto [begin, end] = m_components[i].domain();
        box += moved(i, begin + (end - begin) * k / steps, 0).bbox();
      }
    const double size = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin()), gap = 0.15 * size,
                 right = box.xmax() - box.xmin() + 2 * gap;
    SC::SVG_writer picture(
        out, CGAL::Bbox_2(box.xmin() - gap, box.ymin() - gap, box.xmax() + right + gap, box.ymax() + 2 * gap), 760);
    add_strands(picture, 0.05 * size);
    add_components(picture, right);
    picture.label(K::Point_2(box.xmin() - gap / 2, box.ymax() + 1.2 * gap), given, "black", 15);
    picture.label(K::Point_2(box.xmin() + right, box.ymax() + 1.2 * gap), proper, "black", 15);
  }

private:
  static constexpr int steps = 120;

  // The curve, moved to the side with each fold, so that all of its strands are seen.
  void add_strands(SC::SVG_writer& picture, double width) const
  {
    const auto& stretches = m_proper.stretches;
    double level = -static_cast<double>(m_proper.folds().size()) / 2;
    std::vector<K::Point_2> line, turns;
    const char* last_color = "";
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const bool is_after_fold = i > 0 && turns_between(stretches[i - 1], stretches[i]),
                 is_before_fold = i + 1 < stretches.size() && turns_between(stretches[i], stretches[i + 1]);
      level += is_after_fold ? 1 : 0;
      const double begin = rounded(stretches[i].image_begin), end = rounded(stretches[i].image_end);
      for (int k = 0; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps, u = begin + (end - begin) * share,
                     turn = (is_after_fold ? -bend(share) : 0) + (is_before_fold ? bend(1 - share) : 0);
        const char* const own = color(stretches[i].component, u);
        line.push_back(moved(stretches[i].component, u, (level + turn) * width));
        if (own != last_color) {
          draw(picture, line, last_color);
          last_color = own;
        }
      }
      if (is_before_fold)
        turns.push_back(line.back());
      if (i == 0)
        picture.point(moved(stretches[0].component, begin, level * width), "black", 6);
      if (i + 1 == stretches.size())
        picture.point(line.back(), "black", 6);
    }
    draw(picture, line, last_color);
    for (const K::Point_2& p : turns)
      picture.point(p, "#d62728", 9);
  }

  // Draws a line, of which the end is left as the begin of the next one.
  static void draw(SC::SVG_writer& picture, std::vector<K::Point_2>& line, const char* color)
  {
    if (line.size() > 1)
      picture.polyline(line, color, 2.5);
    line.erase(line.begin(), line.end() - 1);
  }

  // From a half at a fold to zero, along a quarter of a circle.
  static double bend(double share)
  {
    const double rest = std::max(0.0, 1 - 16 * share);
    return 0.5 * (1 - std::sqrt(1 - rest * rest));
  }

  static bool turns_between(const SC::Curve_stretch& before, const SC::Curve_stretch& after)
  {
    return before.component == after.component && before.is_reversed != after.is_reversed;
  }

  K::Point_2 moved(std::size_t component, double u, double distance) const
  {
    const Picture_curve& curve = m_components[component];
    const auto [begin, end] = curve.domain();
    u = std::clamp(u, begin, end);
    const K::Vector_2 normal = curve.normal(u);
    const double length = std::sqrt(normal.squared_length());
    return length > 0 ? curve(u) + normal * (distance / length) : curve(u);
  }

  const char* color(std::size_t component, double u) const
  {
    for (const auto& range : m_proper.components[component].coverage)
      if (range.times > 1 && rounded(range.begin) <= u && u <= rounded(range.end))
        return "#d62728";
    return "black";
  }

  void add_components(SC::SVG_writer& picture, double right) const
  {
    const K::Aff_transformation_2 motion(CGAL::TRANSLATION, K::Vector_2(right, 0));
    for (std::size_t i = 0; i < m_components.size(); ++i) {
      const Picture_curve curve = m_components[i].transformed(motion);
      const auto [first, last] = curve.domain();
      for (const auto& range : m_proper.components[i].coverage) {
        const double begin = std::max(first, rounded(range.begin)), end = std::min(last, rounded(range.end));
        if (begin < end)
          picture.curve(curve.restricted(begin, end), range.times > 1 ? "#d62728" : "black", 2.5);
      }
      for (const double u : {first, last})
        picture.point(curve(u), "black", 6);
    }
  }
};

// What is said of the curves so far.
struct Report
{
  std::string text, picture; // of the curve with the greatest tracing index, and of these the greatest degree
  std::pair<int, int> greatest{0, 0};
  bool is_complete = true;

  template <int d>
  void add(const std::string& name, const SC::Bspline_curve<Exact, d>& curve, const SC::Solver_options& options)
  {
    const auto proper = SC::proper_reparametrization(curve, options);
    is_complete = is_complete && proper.is_complete();
    for (const SC::Undecided_part& part : proper.undecided())
      std::cout << name << ": " << part << '\n';
    if (!proper.is_complete())
      return;
    const auto folds = proper.folds();
    const auto worst = std::max_element(proper.stretches.begin(), proper.stretches.end(),
                                        [](const auto& a, const auto& b) { return a.index < b.index; });
    const int degree = proper.components[worst->component].degree;
    std::ostringstream line;
    line << "tracing index " << worst->index << ", degree " << degree * worst->index << " = " << degree << " * "
         << worst->index << ", " << folds.size() << " folds";
    std::cout << name << ": " << line.str() << "; components: " << proper.components.size() << ", covered up to "
              << proper.times() << " times\n";
    for (const auto& fold : folds)
      std::cout << "  turns back at " << rounded(fold) << '\n';
    if (const std::pair own(worst->index, degree); own > greatest)
      greatest = own;
    else
      return;
    text = line.str();
    picture.clear();
    if constexpr (d == 2) {
      std::ostringstream out;
      const std::string turns = folds.size() == 1 ? " fold" : " folds";
      Properness_picture(proper).write(out,
                                       "as given: degree " + std::to_string(degree * worst->index) + ", " +
                                           std::to_string(folds.size()) + turns,
                                       "proper: degree " + std::to_string(degree));
      picture = out.str();
    }
  }
};

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options limits;
    std::string output;
    std::vector<std::string> files;
    const std::vector<std::string> words = arguments_and_time_limit(argc, argv, limits);
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--output" && i + 1 < words.size())
        output = words[++i];
      else
        files.push_back(words[i]);
    if (files.size() > 1 || (!output.empty() && !output.ends_with(".svg")))
      throw SC::Invalid_input("usage: curve_properness [FILE] [--output OUT.svg] [--time-limit S]");

    const Options_of_program options(limits);
    Report report;
    if (files.empty()) {
      if (output.empty())
        output = "curve_properness.svg";
      report.add("cubic curve, forth, back and forth", forth_back_and_forth(), options());
    } else {
      const auto file =
          files[0].ends_with(".g2") ? SC::IO::read_g2<Exact>(files[0]) : SC::IO::read_IRIT<Exact>(files[0]);
      for (const auto& entry : file.curves_2)
        report.add("curve in line " + std::to_string(entry.line), entry.object, options());
      for (const auto& entry : file.curves_3)
        report.add("curve in line " + std::to_string(entry.line), entry.object, options());
      if (file.curves_2.empty() && file.curves_3.empty())
        throw SC::Invalid_input(files[0] + ": no curves");
    }
    if (!output.empty() && !report.picture.empty())
      std::ofstream(output) << report.picture;
    std::cout << (report.is_complete ? report.text : "undecided; complete: no") << '\n';
    return report.is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
