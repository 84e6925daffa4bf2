// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_SCENE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_SCENE_3_H

#include <CGAL/Spline_constraints_d/IO/internal/scene/Scene_content.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/IO/internal/scene/Scene_painter.h>
#endif
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Point_3.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

Draws meshes, polylines, points and labels in space as SVG: in parallel projection, without what is hidden, shaded.

Coordinates are rounded once, to a hundredth of a pixel in the picture (a tenth or one in pictures of more than 2600 or
26000 pixels) and as finely in depth. For the rounded triangles the picture is right, but for depths that differ by two
of these units at most: faces are painted in an order in which none covers a nearer one; those that pass through each
other are split where they meet, and those that cover each other in a circle are split, too; all this with exact
arithmetic. So are the parts of polylines and points that triangles hide, those strictly behind one. Of several
triangles at the same depth, the one that was added last is seen.

Faces get darker the more they turn away from the light, which comes from the viewer, from above and from the left; both
sides are lit. Silhouettes, boundaries and creases of meshes are drawn as lines.

Complexity: a comparison per pair of triangles whose boxes meet in the picture, and a path in the file per triangle,
about 90 characters. Source: the painter's algorithm with an order of its own, see \ref Spline_constraints_d_scenes.
*/
class Scene_3
{
  internal::Scene::Scene_content m_content;

public:
  /*!
  begins a scene.
  \throws Invalid_input when a number of the view is not finite, the width is not positive or beyond 260000, the
  direction to the viewer has no length or is that which goes up.
  */
  explicit Scene_3(const View_3& view = View_3()) : m_content(view) {}

  /*!
  adds a mesh of triangles.
  \throws Invalid_input when a face is no triangle or a coordinate not finite.
  */
  template <SplineKernel Kernel>
  void add(const CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh, const Face_style_3& style = Face_style_3())
  {
    add(mesh, style, [&](const auto&) { return style.color; });
  }

  //! adds a mesh as above, with a color for each face: `color_of` maps a face of the mesh to a `CGAL::IO::Color`.
  template <SplineKernel Kernel, class ColorOfFace>
  void add(const CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh, const Face_style_3& style,
           const ColorOfFace& color_of)
  {
    internal::Scene::Mesh_content content;
    std::vector<std::size_t> vertices(mesh.num_vertices()), faces(mesh.num_faces());
    for (const auto vertex : mesh.vertices()) {
      vertices[vertex] = content.points.size();
      content.points.push_back(coordinates(mesh.point(vertex)));
    }
    for (const auto face : mesh.faces()) {
      faces[face] = content.triangles.size();
      std::vector<std::size_t> corners;
      for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
        corners.push_back(vertices[vertex]);
      if (corners.size() != 3)
        throw Invalid_input("Scene_3: a face has " + std::to_string(corners.size()) + " corners");
      content.triangles.push_back({corners[0], corners[1], corners[2]});
      content.colors.push_back(color_of(face));
    }
    for (const auto edge : mesh.edges()) {
      const auto halfedge = mesh.halfedge(edge);
      content.edges.push_back({{vertices[mesh.source(halfedge)], vertices[mesh.target(halfedge)]}, {}});
      for (const auto side : {halfedge, mesh.opposite(halfedge)})
        if (!mesh.is_border(side))
          content.edges.back().faces.push_back(faces[mesh.face(side)]);
    }
    m_content.add(content, style);
  }

  /*!
  adds a polyline.
  \param points a range of points of a kernel in space.
  \param style how it is drawn.
  \throws Invalid_input when a coordinate, the width or `Line_style_3::nearer` is not finite.
  */
  template <std::ranges::forward_range Range>
  void add_polyline(const Range& points, const Line_style_3& style = Line_style_3())
  {
    std::vector<std::array<double, 3>> line;
    for (const auto& p : points)
      line.push_back(coordinates(p));
    m_content.add_line(std::move(line), style);
  }

  //! adds a point as a disk, and a text beside it unless this is empty; style is as for polylines, its width the
  //! diameter. A hidden point is left out, or else drawn small. \throws Invalid_input as for polylines.
  template <SplineKernel Kernel>
  void add_point(const CGAL::Point_3<Kernel>& point, const Line_style_3& style, const std::string& label = "")
  {
    m_content.add_point(coordinates(point), style, label);
  }

  /*!
  draws what was added so far.
  \returns the number of pairs of faces that pass through each other and were painted whole, since there were more than
  `View_3::most_splits`: where they do, a farther one may be seen. 0 for all others.
  \throws Invalid_input when that has no extent in the picture.
  */
  std::size_t write(std::ostream& out) const { return internal::Scene::paint(m_content, out); }

private:
  template <class Point>
  static std::array<double, 3> coordinates(const Point& p)
  {
    return {internal::converted_number<double>(p.x()), internal::converted_number<double>(p.y()),
            internal::converted_number<double>(p.z())};
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_SCENE_3_H
