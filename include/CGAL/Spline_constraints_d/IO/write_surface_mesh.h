// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SURFACE_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SURFACE_MESH_H

#include <CGAL/Spline_constraints_d/IO/write_VTP.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>

#include <CGAL/Surface_mesh.h>

#include <string>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/boost/graph/IO/STL.h>
#include <CGAL/boost/graph/helpers.h>

#include <fstream>
#endif

namespace CGAL {
namespace Spline_constraints {
namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

writes a mesh into a file, in the format that the ending of its name tells, with all digits of the coordinates.
\param path the name of the file, with the ending `.off`, `.ply`, `.stl` or `.vtp`.
\param mesh the mesh; for `.stl` all faces are triangles.
\throws Invalid_input when the name ends otherwise, a face for `.stl` is no triangle, or the file cannot be written.
*/
void write_surface_mesh(const std::string& path, const Solution_surface_mesh::Mesh& mesh);

/*!
\ingroup PkgSplineConstraintsDIO

writes surfaces of solutions into a file: into `.off`, `.ply` and `.stl` their triangles alone, into `.vtp` with all
unknowns, normals and curvatures.
\param path the name of the file.
\param surfaces the mesh with its properties.
\throws Invalid_input as the function for meshes.
*/
void write_surface_mesh(const std::string& path, const Solution_surface_mesh& surfaces);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void write_surface_mesh(const std::string& path, const Solution_surface_mesh::Mesh& mesh)
{
  if (path.ends_with(".stl") && !CGAL::is_triangle_mesh(mesh))
    throw Invalid_input(path + ": a face of the mesh is no triangle");
  if (!path.ends_with(".off") && !path.ends_with(".ply") && !path.ends_with(".stl") && !path.ends_with(".vtp"))
    throw Invalid_input(path + " ends neither with .off, .ply or .stl nor with .vtp");
  std::ofstream out(path);
  out.precision(17);
  if (path.ends_with(".off"))
    CGAL::IO::write_OFF(out, mesh);
  else if (path.ends_with(".ply"))
    CGAL::IO::write_PLY(out, mesh);
  else if (path.ends_with(".stl"))
    CGAL::IO::write_STL(out, mesh);
  else
    write_VTP(out, mesh);
  if (!out.flush())
    throw Invalid_input(path + " cannot be written");
}

CGAL_SPLINE_CONSTRAINTS_INLINE void write_surface_mesh(const std::string& path, const Solution_surface_mesh& surfaces)
{
  if (!path.ends_with(".vtp"))
    return write_surface_mesh(path, surfaces.mesh);
  std::ofstream out(path);
  write_VTP(out, surfaces);
  if (!out.flush())
    throw Invalid_input(path + " cannot be written");
}
#endif

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SURFACE_MESH_H
