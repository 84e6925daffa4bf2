// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_VTP_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_VTP_H

#include <CGAL/Spline_constraints_d/IO/internal/decimal_text.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>

#include <CGAL/Point_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline void begin_data(std::ostream& out, const char* type, const char* name, std::size_t components)
{
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
      << "\" format=\"ascii\">\n";
}

// The property map with a name, if there is one; before its version 6 CGAL has a pair.
template <class Index, class Value, class Mesh>
auto property_map_of(const Mesh& mesh, const char* name)
{
  auto found = mesh.template property_map<Index, Value>(name);
  if constexpr (requires { found.second; })
    return found.second ? std::optional(found.first) : std::nullopt;
  else
    return found;
}

// The faces of a mesh as polygons, with what `write_data(out)` writes of its points and cells.
template <class Point, class Write_data>
void write_polygons(std::ostream& out, const CGAL::Surface_mesh<Point>& mesh, const Write_data& write_data)
{
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << mesh.number_of_vertices()
      << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << mesh.number_of_faces()
      << "\">\n";
  write_data(out);
  out << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  std::vector<std::size_t> index(mesh.num_vertices());
  std::size_t number = 0;
  for (const auto vertex : mesh.vertices()) {
    index[vertex] = number++;
    const Point& p = mesh.point(vertex);
    for (int k = 0; k < 3; ++k)
      out << double_text(converted_number<double>(p.cartesian(k))) << (k < 2 ? ' ' : '\n');
  }
  out << "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::vector<std::size_t> offsets;
  std::size_t corners = 0;
  for (const auto face : mesh.faces()) {
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      out << index[vertex] << ' ';
      ++corners;
    }
    out << '\n';
    offsets.push_back(corners);
  }
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (const std::size_t offset : offsets)
    out << offset << '\n';
  out << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

writes polylines in space as `PolyData` of VTK, in XML with numbers as text, which ParaView and others read: those of
one point as vertices, all others as lines. The cell data `component` are the indices of the polylines. Coordinates are
rounded to double.
\param out where they are written to.
\param polylines the points of each polyline; those of a closed one begin and end with the same point.
*/
template <SplineKernel Kernel>
void write_VTP(std::ostream& out, const std::vector<std::vector<CGAL::Point_3<Kernel>>>& polylines)
{
  std::vector<std::size_t> order; // that of the cells: vertices come first in this format
  for (std::size_t i = 0; i < polylines.size(); ++i)
    order.push_back(i);
  const auto lines =
      std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return polylines[i].size() == 1; });
  std::size_t points = 0;
  for (const auto& polyline : polylines)
    points += polyline.size();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"" << lines - order.begin() << "\" NumberOfLines=\""
      << order.end() - lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
      << "<CellData Scalars=\"component\">\n<DataArray type=\"Int64\" Name=\"component\" format=\"ascii\">\n";
  for (const std::size_t i : order)
    out << i << '\n';
  out << "</DataArray>\n</CellData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         "format=\"ascii\">\n";
  for (const std::size_t i : order)
    for (const CGAL::Point_3<Kernel>& p : polylines[i])
      for (int k = 0; k < 3; ++k)
        out << internal::double_text(internal::converted_number<double>(p.cartesian(k))) << (k < 2 ? ' ' : '\n');
  out << "</DataArray>\n</Points>\n";
  std::size_t first = 0;
  const auto write_cells = [&](const char* name, auto begin, auto end) {
    std::size_t size = 0;
    std::for_each(begin, end, [&](std::size_t i) { size += polylines[i].size(); });
    out << '<' << name << ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    for (std::size_t k = 0; k < size; ++k)
      out << first + k << '\n';
    out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    std::size_t offset = 0;
    std::for_each(begin, end, [&](std::size_t i) { out << (offset += polylines[i].size()) << '\n'; });
    out << "</DataArray>\n</" << name << ">\n";
    first += size;
  };
  if (lines != order.begin())
    write_cells("Verts", order.begin(), lines);
  write_cells("Lines", lines, order.end());
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

/*!
\ingroup PkgSplineConstraintsDIO

writes the faces of a mesh in the same format, as polygons.
\param out where it is written to.
\param mesh the mesh.
*/
template <SplineKernel Kernel>
void write_VTP(std::ostream& out, const CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh)
{
  internal::write_polygons(out, mesh, [](std::ostream&) {});
}

/*!
\ingroup PkgSplineConstraintsDIO

writes the triangles of surfaces of solutions in the same format, with their properties: of points `unknowns`,
`normal`, `gaussian_curvature`, `mean_curvature`, `principal_curvatures` and `principal_direction_0` and `_1`; of cells
`surface`. A property map `"v:distances"`, as bisectors have it, gives `distances`.
\param out where they are written to.
\param surfaces the mesh with its properties.
*/
void write_VTP(std::ostream& out, const Solution_surface_mesh& surfaces);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void write_VTP(std::ostream& out, const Solution_surface_mesh& surfaces)
{
  using Mesh = Solution_surface_mesh::Mesh;
  const Mesh& mesh = surfaces.mesh;
  const auto write_vector = [&](const Surface_differentials_3::Vector& vector) {
    for (int k = 0; k < 3; ++k)
      out << internal::double_text(vector[k]) << (k < 2 ? ' ' : '\n');
  };
  const auto write_of_vertices = [&](const char* name, std::size_t components, const auto& write) {
    internal::begin_data(out, "Float64", name, components);
    for (const Mesh::Vertex_index v : mesh.vertices())
      write(v);
    out << "</DataArray>\n";
  };
  internal::write_polygons(out, mesh, [&](std::ostream&) {
    out << "<PointData Normals=\"normal\" Scalars=\"gaussian_curvature\">\n";
    const std::size_t unknowns = mesh.is_empty() ? 1 : surfaces.unknowns[*mesh.vertices().begin()].size();
    write_of_vertices("unknowns", unknowns, [&](Mesh::Vertex_index v) {
      for (const double unknown : surfaces.unknowns[v])
        out << internal::double_text(unknown) << ' ';
      out << '\n';
    });
    write_of_vertices("normal", 3, [&](Mesh::Vertex_index v) { write_vector(surfaces.differentials[v].normal); });
    write_of_vertices("gaussian_curvature", 1, [&](Mesh::Vertex_index v) {
      out << internal::double_text(surfaces.differentials[v].gaussian_curvature()) << '\n';
    });
    write_of_vertices("mean_curvature", 1, [&](Mesh::Vertex_index v) {
      out << internal::double_text(surfaces.differentials[v].mean_curvature()) << '\n';
    });
    write_of_vertices("principal_curvatures", 2, [&](Mesh::Vertex_index v) {
      const auto& [least, most] = surfaces.differentials[v].curvatures;
      out << internal::double_text(least) << ' ' << internal::double_text(most) << '\n';
    });
    for (const std::size_t k : {0u, 1u})
      write_of_vertices(k == 0 ? "principal_direction_0" : "principal_direction_1", 3,
                        [&](Mesh::Vertex_index v) { write_vector(surfaces.differentials[v].directions[k]); });
    const auto distances = internal::property_map_of<Mesh::Vertex_index, std::vector<double>>(mesh, "v:distances");
    const auto first = mesh.vertices().begin();
    if (distances && !mesh.is_empty() && !(*distances)[*first].empty())
      write_of_vertices("distances", (*distances)[*first].size(), [&](Mesh::Vertex_index v) {
        for (const double distance : (*distances)[v])
          out << internal::double_text(distance) << ' ';
        out << '\n';
      });
    out << "</PointData>\n<CellData Scalars=\"surface\">\n";
    internal::begin_data(out, "Int64", "surface", 1);
    for (const Mesh::Face_index f : mesh.faces())
      out << surfaces.surface[f] << '\n';
    out << "</DataArray>\n</CellData>\n";
  });
}
#endif

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_VTP_H
