// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_SCENE_CONTENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_SCENE_CONTENT_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDIO
//! from where a scene is seen, and how large.
struct View_3
{
  std::array<double, 3> to_viewer{-0.41, -0.72, 0.56};   ///< the direction to the viewer, of any length
  std::array<double, 3> up{0, 0, 1};                     ///< a direction that goes up in the picture
  double width = 640;                                    ///< in pixels
  std::size_t most_splits = 1000;                        ///< of faces that pass through others
};

//! \ingroup PkgSplineConstraintsDIO
//! how the faces of a mesh are drawn.
struct Face_style_3
{
  CGAL::IO::Color color{190, 210, 235};              ///< in full light
  std::optional<CGAL::IO::Color> back = std::nullopt;   ///< of the other side of faces; else a duller one of `color`
  bool has_edges = true;                             ///< whether silhouettes, boundaries and creases are drawn
  double crease = 40;                                ///< edges with a larger angle, in degrees, are creases
};

//! \ingroup PkgSplineConstraintsDIO
//! what is drawn of the parts of a line that faces hide.
enum class Hidden_line
{
  LEFT_OUT,   ///< nothing
  DASHED,     ///< dashes
  THIN        ///< a thin line
};

//! \ingroup PkgSplineConstraintsDIO
//! how a polyline or a point is drawn.
struct Line_style_3
{
  std::string color = "black";                  ///< of SVG
  double width = 1.5;                           ///< in pixels
  Hidden_line hidden = Hidden_line::LEFT_OUT;   ///< what is drawn of hidden parts
  double nearer = 0;   ///< it is taken to be so much nearer to the viewer, for lines on surfaces with a coarse mesh
};

namespace internal {
namespace Scene {

using Triple = std::array<double, 3>;

inline double product(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Triple sum(const Triple& a, const Triple& b, double factor = 1)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

// Zero stays zero.
inline Triple normalized(const Triple& a)
{
  const double length = std::hypot(a[0], a[1], a[2]);
  return length > 0 ? Triple{a[0] / length, a[1] / length, a[2] / length} : Triple{0, 0, 0};
}

// Where triangles meet.
struct Edge_content
{
  std::array<std::size_t, 2> ends;
  std::vector<std::size_t> faces;   // one or two
};

struct Mesh_content
{
  std::vector<Triple> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<CGAL::IO::Color> colors;
  std::vector<Edge_content> edges;
};

// What is drawn, in coordinates of the picture: to the right, up, to the viewer.
class Scene_content
{
public:
  struct Face
  {
    std::array<Triple, 3> corners;
    std::string front, back;   // colors
  };
  struct Edge
  {
    std::array<Triple, 2> ends;
    std::vector<std::size_t> faces;
    bool is_crease;
    std::string color;
  };
  struct Line
  {
    std::vector<Triple> points;
    Line_style_3 style;
  };
  struct Mark
  {
    Triple point;
    Line_style_3 style;
    std::string label;
  };

private:
  double m_width;
  std::size_t m_most_splits;
  Triple m_right, m_up, m_to_viewer, m_light;
  std::vector<Face> m_faces;
  std::vector<Edge> m_edges;
  std::vector<Line> m_lines;
  std::vector<Mark> m_marks;

public:
  explicit Scene_content(const View_3& view);

  double width() const { return m_width; }
  std::size_t most_splits() const { return m_most_splits; }
  const std::vector<Face>& faces() const { return m_faces; }
  const std::vector<Edge>& edges() const { return m_edges; }
  const std::vector<Line>& lines() const { return m_lines; }
  const std::vector<Mark>& marks() const { return m_marks; }

  void add(const Mesh_content& mesh, const Face_style_3& style);

  void add_line(std::vector<Triple> points, const Line_style_3& style);

  void add_point(const Triple& point, const Line_style_3& style, const std::string& label);

private:
  static std::vector<Triple> normals_of(const Mesh_content& mesh);

  // The mean over the corners of a triangle of the normals around them, without those beyond creases.
  static std::vector<Triple> smoothed(const Mesh_content& mesh, const std::vector<Triple>& normals,
                                      double least_cosine);

  // Before the faces are.
  void add_edges(const Mesh_content& mesh, const std::vector<Triple>& normals, double least_cosine);

  Triple seen(const Triple& p) const { return {product(p, m_right), product(p, m_up), product(p, m_to_viewer)}; }

  static void check_finite(const Triple& p, const std::string& what);

  static void check_style(const Line_style_3& style);

  static CGAL::IO::Color duller(const CGAL::IO::Color& color)
  {
    const auto mixed = [](unsigned char part, int gray) { return static_cast<unsigned char>((2 * part + gray) / 3); };
    return CGAL::IO::Color(mixed(color.red(), 120), mixed(color.green(), 110), mixed(color.blue(), 130));
  }

  // Of so much light.
  static std::string text_of(const CGAL::IO::Color& color, double light);
};

// Draws a scene and returns the number of pairs of faces that pass through each other still; defined in
// Scene_painter.h.
std::size_t paint(const Scene_content& scene, std::ostream& out);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Scene_content::Scene_content(const View_3& view)
  : m_width(view.width), m_most_splits(view.most_splits),
    m_right(normalized(cross(normalized(view.up), normalized(view.to_viewer)))), m_to_viewer(normalized(view.to_viewer))
{
  check_finite(view.to_viewer, "the direction to the viewer");
  check_finite(view.up, "the direction that goes up");
  constexpr double most_pixels = 260000, nearly_parallel = 1e-6;
  if (!(view.width > 0 && view.width <= most_pixels))
    throw Invalid_input("Scene_3: the width of the picture is not between 0 and 260000 pixels");
  if (std::hypot(m_right[0], m_right[1], m_right[2]) < 0.5 ||
      std::abs(product(normalized(view.up), m_to_viewer)) > 1 - nearly_parallel * nearly_parallel)
    throw Invalid_input("Scene_3: the direction to the viewer has no length, or is the one that goes up");
  m_up = cross(m_to_viewer, m_right);
  m_light = normalized(sum(sum(m_to_viewer, m_up, 0.8), m_right, -0.6));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Scene_content::add(const Mesh_content& mesh, const Face_style_3& style)
{
  for (const Triple& p : mesh.points)
    check_finite(p, "a vertex of a mesh");
  const double least_cosine = std::cos(style.crease * std::acos(-1.) / 180);
  const std::vector<Triple> normals = normals_of(mesh), smooth = smoothed(mesh, normals, least_cosine);
  if (style.has_edges)
    add_edges(mesh, normals, least_cosine);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const double side = product(normals[i], m_to_viewer) > 0 ? 1 : -1;
    const double light = 0.63 + 0.37 * side * product(smooth[i], m_light);
    const CGAL::IO::Color back = style.back.value_or(duller(mesh.colors[i]));
    Face face{{}, text_of(mesh.colors[i], light), text_of(back, light)};
    for (int k = 0; k < 3; ++k)
      face.corners[k] = seen(mesh.points[mesh.triangles[i][k]]);
    m_faces.push_back(std::move(face));
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Scene_content::add_line(std::vector<Triple> points, const Line_style_3& style)
{
  for (Triple& p : points) {
    check_finite(p, "a point of a polyline");
    p = seen(p);
  }
  check_style(style);
  m_lines.push_back({std::move(points), style});
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Scene_content::add_point(const Triple& point, const Line_style_3& style,
                                                             const std::string& label)
{
  check_finite(point, "a point");
  check_style(style);
  m_marks.push_back({seen(point), style, label});
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Triple> Scene_content::normals_of(const Mesh_content& mesh)
{
  std::vector<Triple> result;
  for (const auto& [a, b, c] : mesh.triangles)
    result.push_back(
        normalized(cross(sum(mesh.points[b], mesh.points[a], -1), sum(mesh.points[c], mesh.points[a], -1))));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Triple>
Scene_content::smoothed(const Mesh_content& mesh, const std::vector<Triple>& normals, double least_cosine)
{
  std::vector<std::vector<std::size_t>> around(mesh.points.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::size_t corner : mesh.triangles[i])
      around[corner].push_back(i);
  std::vector<Triple> result;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Triple mean{0, 0, 0};
    for (const std::size_t corner : mesh.triangles[i]) {
      Triple here{0, 0, 0};
      for (const std::size_t j : around[corner])
        if (product(normals[i], normals[j]) >= least_cosine)
          here = sum(here, normals[j]);
      mean = sum(mean, normalized(here));
    }
    result.push_back(normalized(mean));
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Scene_content::add_edges(const Mesh_content& mesh,
                                                             const std::vector<Triple>& normals, double least_cosine)
{
  for (const Edge_content& edge : mesh.edges) {
    Edge drawn{{seen(mesh.points[edge.ends[0]]), seen(mesh.points[edge.ends[1]])}, edge.faces, false, "#404040"};
    drawn.is_crease = edge.faces.size() == 2 && product(normals[edge.faces[0]], normals[edge.faces[1]]) < least_cosine;
    if (!edge.faces.empty())
      drawn.color = text_of(mesh.colors[edge.faces[0]], 0.4);
    for (std::size_t& face : drawn.faces)
      face += m_faces.size();
    m_edges.push_back(std::move(drawn));
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Scene_content::check_finite(const Triple& p, const std::string& what)
{
  constexpr double most = 1e100; // squares are finite, too
  for (const double x : p)
    if (!(std::abs(x) <= most))
      throw Invalid_input("Scene_3: " + what + " is not finite, or beyond 1e100");
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Scene_content::check_style(const Line_style_3& style)
{
  check_finite({style.width, style.nearer, 0}, "the width of a line, or how much it is nearer,");
  if (style.width < 0)
    throw Invalid_input("Scene_3: the width of a line is negative");
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string Scene_content::text_of(const CGAL::IO::Color& color, double light)
{
  std::string result = "#";
  for (const unsigned char part : {color.red(), color.green(), color.blue()}) {
    const int value = static_cast<int>(std::lround((std::min)(part * light, 255.)));
    result += "0123456789abcdef"[value / 16];
    result += "0123456789abcdef"[value % 16];
  }
  return result;
}
#endif

} // namespace Scene
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_SCENE_CONTENT_H
