// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the programs for trimmed bisectors do with an answer: a mesh or a picture of what is kept, and the line that
// sums up.
#ifndef TRIMMED_BISECTOR_PROGRAM_H
#define TRIMMED_BISECTOR_PROGRAM_H

#include "bisector_scene.h"

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/trimmed_bisectors_3.h>

#include <chrono>

// `seconds` is the time that was taken until here.
inline int report(const SC::Trimmed_bisector_3& bisector, const Surface& surface, const K::Point_3& center,
                  const Bisector_arguments& arguments, double seconds)
{
  std::size_t parts = 0;
  bool is_complete = bisector.is_complete();
  if (bisector.bisector().is_complete())
    for (const SC::Trimmed_surface_3& part : SC::bisector_parts(bisector.bisector(), arguments.options)) {
      parts += part.number_of_regions(SC::WITH_POSITIVE_WEIGHT) + part.number_of_regions(SC::WITH_NEGATIVE_WEIGHT);
      is_complete = is_complete && part.is_complete();
    }
  if (!arguments.output.empty()) {
    const CGAL::Bbox_3 box = surface(surface.domain(0).first, surface.domain(1).first).bbox() + center.bbox();
    const double error =
        arguments.error > 0 ? arguments.error : 0.01 * (1 + box.xmax() - box.xmin() + box.ymax() - box.ymin());
    const Mesh mesh = mesh_of(bisector.surfaces(), {SC::NEAREST}, error);
    if (arguments.output.ends_with(".svg")) {
      Scene scene;
      Group group(scene, K::Vector_3(0, 0, 0));
      group.add(surface);
      group.add(center);
      group.add(mesh);
      std::ofstream file(arguments.output);
      scene.write(file);
    } else
      SC::IO::write_surface_mesh(arguments.output, mesh);
  }
  const char* const least = is_complete ? "" : "at least ";
  std::cout << "bisector: degree (" << bisector.bisector().degree(0) << ',' << bisector.bisector().degree(1) << "), "
            << least << parts << " parts, " << least << bisector.number_of_regions(SC::NEAREST) << " faces kept, "
            << bisector.undecided().size() << " undecided; complete: " << (is_complete ? "yes" : "no") << "; seconds "
            << seconds << '\n';
  return is_complete ? 0 : 3;
}

// Of the surface of a file and a point or center, whose coordinates are the next words: `trimmed(center, surface,
// reach)` is the bisector.
template <class Trimmed>
int of_file(const Bisector_arguments& arguments, const Trimmed& trimmed)
{
  const Surface surface = read_surface(arguments.words[0]);
  const auto number = [&](std::size_t i) { return number_of<double>(arguments.words[i]); };
  const K::Point_3 center(number(1), number(2), number(3));
  std::vector<K::Point_3> points = points_of(surface);
  points.push_back(center);
  const auto begin = std::chrono::steady_clock::now();
  const SC::Trimmed_bisector_3 bisector = trimmed(center, surface, reach_around(points, arguments.reach));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return report(bisector, surface, center, arguments, seconds.count());
}

#endif // TRIMMED_BISECTOR_PROGRAM_H
