// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes surfaces of solutions, in their first three unknowns, as meshes: into .off, .ply and .stl triangles alone,
// into .vtp with all unknowns, normals and curvatures, into .svg as a picture.
#ifndef SURFACE_OUTPUT_H
#define SURFACE_OUTPUT_H

#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <CGAL/IO/Color.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>

// Seen with the third unknown upwards; each surface in a color of its own.
inline void draw_surfaces(std::ostream& out, const CGAL::Spline_constraints::Solution_surface_mesh& surfaces,
                          const CGAL::Spline_constraints::View_3& view = {})
{
  using Color = CGAL::IO::Color;
  static const std::array<Color, 6> colors{Color(222, 184, 112), Color(126, 176, 213), Color(178, 224, 127),
                                           Color(253, 127, 111), Color(189, 126, 190), Color(139, 211, 199)};
  CGAL::Spline_constraints::Scene_3 scene(view);
  scene.add(surfaces.mesh, {}, [&](const auto& face) { return colors[surfaces.surface[face] % colors.size()]; });
  scene.write(out);
}

// `chord_error`: how far triangles may be from the surfaces.
inline void write_surfaces(const std::string& path, const CGAL::Spline_constraints::Surface_solution_set_d& set,
                           double chord_error)
{
  using CGAL::Spline_constraints::View_3;
  const auto surfaces = CGAL::Spline_constraints::to_surface_mesh(set, {.chord_error = chord_error});
  if (path.ends_with(".svg")) {
    std::ofstream out(path);
    draw_surfaces(out, surfaces, set.dimension() > 3 ? View_3{.most_splits = 2000} : View_3()); // may cross themselves
    if (!out.flush())
      throw CGAL::Spline_constraints::Invalid_input("--output: " + path + " cannot be written");
  } else
    CGAL::Spline_constraints::IO::write_surface_mesh(path, surfaces);
  std::cout << "mesh: " << surfaces.mesh.number_of_vertices() << " vertices, " << surfaces.mesh.number_of_faces()
            << " triangles, error " << surfaces.error << '\n';
}

#endif // SURFACE_OUTPUT_H
