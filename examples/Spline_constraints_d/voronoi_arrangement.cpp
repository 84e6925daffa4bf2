// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of curves as an arrangement of CGAL: its vertices, edges and faces know sites, and point location
// finds what is nearest. Writes voronoi_arrangement.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <array>
#include <fstream>
#include <iostream>
#include <variant>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Arrangement = SC::Voronoi_arrangement_2<K>::Arrangement;

// The face that point location has found, if it is one. Variants are those of Boost before CGAL 6.
template <class Found>
const Arrangement::Face_const_handle* face_of(const Found& found)
{
#if CGAL_VERSION_NR < 1060000000
  return boost::get<Arrangement::Face_const_handle>(&found);
#else
  return std::get_if<Arrangement::Face_const_handle>(&found);
#endif
}

int main()
{
  // A wave, a circle, a bent wall, and a point.
  const std::vector<SC::Bspline_curve_2<K>> curves{
      SC::bezier_curve(std::vector<Point>{{1, 4}, {3, 9}, {5, 1}, {8, 6}}), SC::circle_curve(Point(3, 2), K::FT(1)),
      SC::segment_curve<K>(Point(6, 1), Point(9, 1)), SC::segment_curve<K>(Point(9, 1), Point(10, 4))};
  const CGAL::Bbox_2 box(0, 0, 11, 8);
  const auto diagram = SC::voronoi_diagram(curves, {Point(10, 7)});
  const auto result = SC::to_arrangement(diagram, 1e-3, box);

  // Each vertex has the footpoints of its disk.
  std::size_t branching = 0;
  for (auto vertex = result.arrangement.vertices_begin(); vertex != result.arrangement.vertices_end(); ++vertex)
    branching += vertex->data() && diagram.vertices()[*vertex->data()].footpoints.size() > 2;

  // A face knows to which of the connected sets of curves and points all of it is nearest.
  constexpr std::array<const char*, 4> colors{"#1f77b4", "#ff7f0e", "#2ca02c", "#9467bd"};
  std::ofstream file("voronoi_arrangement.svg");
  SC::SVG_writer picture(file, box, 700);
  const CGAL::Arr_walk_along_line_point_location<Arrangement> location(result.arrangement);
  std::size_t located = 0, confirmed = 0;
  for (double x = 0.125; x < box.xmax(); x += 0.25)
    for (double y = 0.125; y < box.ymax(); y += 0.25) {
      const auto found = location.locate({x, y});
      if (const auto* face = face_of(found)) {
        const std::size_t region = (*face)->data().front();
        ++located;
        // by distances, proved
        confirmed += diagram.sites()[diagram.nearest_sites(Point(x, y)).front()].region == region;
        picture.point(Point(x, y), colors[region % colors.size()], 5);
      }
    }
  for (auto edge = result.arrangement.edges_begin(); edge != result.arrangement.edges_end(); ++edge)
    picture.polyline(std::vector{edge->source()->point(), edge->target()->point()}, "#d62728", 2);
  for (const auto& curve : curves)
    picture.curve(curve, "black", 3);
  picture.point(Point(10, 7), "black", 8);

  std::cout << "faces in the box: " << result.arrangement.number_of_faces() - 1
            << "; vertices of degree three or more: " << branching << "; " << confirmed << " of " << located
            << " points have the nearest site that point location finds; topology of the diagram: "
            << (result.has_same_topology ? "yes" : "no") << '\n';
  return diagram.is_complete() && result.has_same_topology && located > 0 && confirmed == located ? 0 : 1;
}
