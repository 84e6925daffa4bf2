// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds all intersections of the curves and surfaces of two files, or of one: prints one line for each, and draws them.
//
//   intersect [A [B]] [--heal TOLERANCE] [--near DISTANCE] [--svg OUT] [--time-limit S]
//
// Files are drawings (.svg), data of IRIT (.itd) or of GoTools (.g2). Each object of A is intersected with each one of
// B that is in the same space; without B, all pairs in A. Two surfaces have curves in common, with their ends, singular
// points, where the surfaces touch (tangent), and single points on edges (end points). With --heal, primitives (lines,
// circles, planes, spheres, cylinders, cones, tori) are made exact, moved by no more than the tolerance, before. Ends,
// corners, seams and poles that nearly coincide, up to the last digits or the distance given by --near, are named
// besides; they change no answer. The time limit is for all pairs together. Without arguments: data/drawing.svg with
// data/route.itd, drawn into intersect.svg. Exit status: 0 when every intersection is accounted for, 3 when not, 2 for
// bad input.
#include "arguments.h"
#include "healing.h"
#include "intersect_output.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/operations/distances/near_coincidences.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/pairwise_intersections.h>

#include <iostream>
#include <optional>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

#ifndef DATA_DIRECTORY
#define DATA_DIRECTORY "data/"
#endif

File read(const std::string& path)
{
  if (path.ends_with(".g2")) return SC::IO::read_g2<K>(path);
  if (path.ends_with(".itd")) return SC::IO::read_IRIT<K>(path);
  if (!path.ends_with(".svg")) throw SC::Invalid_input(path + ": only files .svg, .itd and .g2 can be read");
  File file;
  for (const auto& element : SC::IO::read_SVG<K>(path))
    file.curves_2.push_back(
        {element.curve,
         (element.id.empty() ? element.element : element.id) + '#' + std::to_string(file.curves_2.size() + 1),
         element.line, element.column});
  return file;
}

template <class Entry>
void intersect_curves(const std::vector<Entry>& a, const std::vector<Entry>& b, const SC::Solver_options& options,
                      Report& report)
{
  const auto curves = [](const auto& entries) {
    return std::views::transform(entries, [](const Entry& entry) { return entry.object; });
  };
  const auto result = &a == &b ? SC::pairwise_intersections(curves(a), options)
                               : SC::pairwise_intersections(curves(a), curves(b), options);
  for (const auto& [i, j, intersections] : result.pairs())
    report.add(a[i], b[j], intersections);
  for (const SC::Undecided_part& part : result.undecided())
    if (part.parameters.size() == 1)   // a curve whose pairs were not all looked at
      report.add(part);
  report.add(result.summary());
}

template <class Entry, class Other_entry, class Operation>
void intersect_pairs(const std::vector<Entry>& a, const std::vector<Other_entry>& b, Report& report,
                     const Operation& operation)
{
  for (const Entry& first : a)
    for (const Other_entry& second : b)
      if (static_cast<const void*>(&first) < static_cast<const void*>(&second) ||
          static_cast<const void*>(&a) != static_cast<const void*>(&b)) {
        const auto intersections = operation(first.object, second.object);
        report.add(first, second, intersections);
        report.add(intersections.summary());
      }
}

// Of curves, or of surfaces.
template <class Entry>
void find_near_coincidences(const std::vector<Entry>& a, const std::vector<Entry>& b, std::optional<double> distance,
                            const SC::Solver_options& options, Report& report)
{
  std::vector<const Entry*> entries;
  for (const Entry& entry : a)
    entries.push_back(&entry);
  if (&a != &b)
    for (const Entry& entry : b)
      entries.push_back(&entry);
  const auto objects = std::views::transform(entries, [](const Entry* entry) -> const auto& { return entry->object; });
  const auto near = SC::near_coincidences(objects, distance, options);
  for (const auto& pair : near)
    if (&a == &b || (pair.object(0) < a.size() && pair.object(1) >= a.size()))
      report.add_near(*entries[pair.object(0)], *entries[pair.object(1)], pair);
  report.add_near(near.is_complete());
}

// Of curves and surfaces.
template <class Curve_entry, class Surface_entry>
void find_mixed_near_coincidences(const std::vector<Curve_entry>& curves, const std::vector<Surface_entry>& surfaces,
                                  std::optional<double> distance, const Options_of_program& options, Report& report)
{
  for (const Curve_entry& curve : curves)
    for (const Surface_entry& surface : surfaces) {
      const auto near = SC::near_coincidences(curve.object, surface.object, distance, options());
      for (const auto& pair : near)
        report.add_near(curve, surface, pair);
      report.add_near(near.is_complete());
    }
}

// Primitives of both files made exact, in coordinates in which they are simple.
Motions heal(File& a, File& b, double tolerance, const Options_of_program& options)
{
  const auto objects = [&](auto File::*member) {
    auto result = std::vector<std::remove_cvref_t<decltype((a.*member).front().object)>>();
    for (const File* file : {&a, &b})
      for (const auto& entry : file->*member)
        result.push_back(entry.object);
    return result;
  };
  const auto replace = [&](auto File::*member, const auto& healed) {
    auto next = healed.begin();
    for (File* file : {&a, &b})
      for (auto& entry : file->*member)
        entry.object = *next++;
  };
  const auto curves_2 = SC::with_exact_primitives<K>(objects(&File::curves_2), tolerance, options());
  const auto [curves_3, surfaces] = SC::with_exact_primitives<K>(
      objects(&File::curves_3), objects(&File::surfaces_3), tolerance, options());
  print_healing(curves_2, curves_3, surfaces);
  replace(&File::curves_2, curves_2.simple_splines());
  replace(&File::curves_3, curves_3.simple_splines());
  replace(&File::surfaces_3, surfaces.simple_splines());
  return {curves_2.frame, surfaces.frame};
}

int main(int argc, char* argv[])
try {
  const Arguments arguments =
      parse(argc, argv, {{DATA_DIRECTORY "drawing.svg", DATA_DIRECTORY "route.itd"}, "intersect.svg", {}});
  const Options_of_program options(arguments.options);
  const File given = read(arguments.files[0]), other = arguments.files.size() == 2 ? read(arguments.files[1]) : File();
  File a = given, second = other;
  const bool has_two = arguments.files.size() == 2;
  const Motions moved =
      arguments.healing_tolerance ? heal(a, second, *arguments.healing_tolerance, options) : Motions();
  const File& b = has_two ? second : a;
  Report report(given, has_two ? other : given, moved);
  const std::optional<double> near = arguments.near_distance;
  find_near_coincidences(a.curves_2, b.curves_2, near, options(), report);
  find_near_coincidences(a.curves_3, b.curves_3, near, options(), report);
  find_near_coincidences(a.surfaces_3, b.surfaces_3, near, options(), report);
  find_mixed_near_coincidences(a.curves_3, b.surfaces_3, near, options, report);
  if (&a != &b)
    find_mixed_near_coincidences(b.curves_3, a.surfaces_3, near, options, report);
  intersect_curves(a.curves_2, b.curves_2, options(), report);
  intersect_curves(a.curves_3, b.curves_3, options(), report);
  const auto intersect = [&](const auto& curve, const auto& surface) {
    return SC::intersections(curve, surface, options());
  };
  intersect_pairs(a.curves_3, b.surfaces_3, report, intersect);
  if (&a != &b)
    intersect_pairs(b.curves_3, a.surfaces_3, report, intersect);
  intersect_pairs(a.surfaces_3, b.surfaces_3, report, [&](const auto& s1, const auto& s2) {
    SC::Solver_options curve_options = options();
    curve_options.tolerance = 1e-8;
    return SC::intersection_curves(s1, s2, curve_options);
  });
  report.print_summary();
  if (!arguments.picture.empty())
    report.draw(arguments.picture);
  return report.is_complete() && report.has_all_near_coincidences() ? 0 : 3;
} catch (const std::exception& error) {
  std::cerr << "intersect: " << error.what() << '\n';
  return 2;
}
