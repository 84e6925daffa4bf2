// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// B-spline surfaces near surfaces of solutions: one for a disk, such as the positions of an arm, and atlases of
// surfaces that are no disks. Writes the charts of half a torus in the g2 format, and draws those of the tangle cube,
// with the curves between polynomial pieces.

#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/write_g2.h>
#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surface_fitting.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;

void print(const std::string& name, const SC::Surface_atlas_d& atlas, double tolerance)
{
  std::size_t pieces = 0;
  for (const SC::Fitted_surface_d& chart : atlas.charts)
    pieces += chart.number_of_pieces();
  std::cout << name << ": " << atlas.charts.size() << " charts, Euler characteristic " << atlas.euler_characteristic()
            << ", " << pieces << " pieces, error " << (atlas.error <= tolerance ? "below " : "above ") << tolerance
            << " at " << atlas.test_points << " points; complete: " << (atlas.is_complete() ? "yes" : "no") << '\n';
}

// A mesh of one chart.
CGAL::Surface_mesh<K::Point_3> tiles_of(const Surface& surface, int tiles)
{
  CGAL::Surface_mesh<K::Point_3> mesh;
  std::vector<CGAL::Surface_mesh<K::Point_3>::Vertex_index> vertices;
  for (int i = 0; i <= tiles; ++i)
    for (int j = 0; j <= tiles; ++j)
      vertices.push_back(mesh.add_vertex(surface(static_cast<double>(i) / tiles, static_cast<double>(j) / tiles)));
  const auto vertex = [&](int i, int j) { return vertices[static_cast<std::size_t>(i * (tiles + 1) + j)]; };
  for (int i = 0; i < tiles; ++i)
    for (int j = 0; j < tiles; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

void draw(std::ostream& out, const SC::Surface_atlas_d& atlas)
{
  using Color = CGAL::IO::Color;
  static const std::array<Color, 6> colors{Color(222, 184, 112), Color(126, 176, 213), Color(178, 224, 127),
                                           Color(253, 180, 160), Color(205, 170, 206), Color(139, 211, 199)};
  SC::Scene_3 scene;
  constexpr int tiles = 8, chords = 16;
  constexpr double nearer = 0.1;
  std::vector<std::size_t> color_of;
  for (std::size_t c = 0; c < atlas.charts.size(); ++c) {
    std::vector<bool> is_taken(colors.size(), false); // by neighbours
    for (const SC::Fitted_edge_d& edge : atlas.edges)
      if (std::find(edge.charts.begin(), edge.charts.end(), c) != edge.charts.end())
        for (const std::size_t other : edge.charts)
          if (other < c)
            is_taken[color_of[other]] = true;
    const auto free = std::find(is_taken.begin(), is_taken.end(), false);
    color_of.push_back(free == is_taken.end() ? 0 : static_cast<std::size_t>(free - is_taken.begin()));
    const Surface surface = atlas.charts[c].surface_3<K>();
    scene.add(tiles_of(surface, tiles), {.color = colors[color_of[c]], .back = colors[color_of[c]]});
    for (const int axis : {0, 1}) {
      std::vector<double> breaks = atlas.charts[c].knots[static_cast<std::size_t>(axis)];
      breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
      for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
        std::vector<K::Point_3> line;
        for (int k = 0; k <= chords; ++k) {
          const double t = static_cast<double>(k) / chords;
          line.push_back(axis == 0 ? surface(breaks[i], t) : surface(t, breaks[i]));
        }
        scene.add_polyline(line, {.color = "#666", .width = 0.7, .nearer = nearer});
      }
    }
  }
  for (const SC::Fitted_edge_d& edge : atlas.edges) {
    const auto curve = edge.curve_3<K>();
    std::vector<K::Point_3> line;
    for (int k = 0; k <= chords; ++k)
      line.push_back(curve(static_cast<double>(k) / chords));
    scene.add_polyline(line, {.color = "#222", .width = 2, .nearer = nearer});
  }
  scene.write(out);
}

int main()
{
  const SC::Exact_rational half = SC::Exact_rational(1) / 2;

  // A sphere above a plane: a disk.
  const auto [a, b, c] = SC::unknowns({-2, 2}, {-2, 2}, {0, 2});
  print("half a sphere", SC::fit_bspline_surfaces(SC::solve_surfaces(square(a) + square(b) + square(c) == 1)), 1e-3);

  // All positions of an arm of two bars with its end (u, v) above a line; its joint (x, y) turns by 60 degrees at most.
  const auto [x, y, u, v] = SC::unknowns({half, 1}, {0, 1}, {-2, 2}, {1, 2});
  const auto positions = SC::solve_surfaces(square(x) + square(y) == 1, square(u - x) + square(v - y) == half);
  print("workspace", SC::fit_bspline_surfaces(positions, SC::Vector_expression<3>(u, v, x)), 1e-3);

  // Two boundaries, and handles.
  const auto ring = square(a) + square(b);
  const auto torus = square(ring + square(c) + SC::Exact_rational(91) / 100) - 4 * ring;
  const SC::Surface_atlas_d half_torus = SC::fit_bspline_surfaces(SC::solve_surfaces(torus == 0));
  print("half a torus", half_torus, 1e-3);
  std::ofstream file("half_torus.g2");
  for (const SC::Fitted_surface_d& chart : half_torus.charts)
    SC::IO::write_g2(file, chart.surface_3<K>());

  const auto [p, q, r] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto well = [](const SC::Expression& t) { return 5 * square(square(t)) - 25 * square(t); };
  const SC::Surface_atlas_d tangle =
      SC::fit_bspline_surfaces(SC::solve_surfaces(well(p) + well(q) + well(r) + 59 == 0), {.tolerance = 1e-2});
  print("tangle cube", tangle, 1e-2);
  std::ofstream picture("fit_surface.svg");
  draw(picture, tangle);
}
