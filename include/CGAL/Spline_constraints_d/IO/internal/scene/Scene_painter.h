// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_SCENE_PAINTER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_SCENE_PAINTER_H

#include <CGAL/Spline_constraints_d/IO/internal/scene/Hidden_parts.h>
#include <CGAL/Spline_constraints_d/IO/internal/scene/Painters_order.h>
#include <CGAL/Spline_constraints_d/IO/internal/scene/Scene_content.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Scene {

// From coordinates of the picture to pixels, which are rounded to a grid.
class Picture_frame
{
  CGAL::Bbox_3 m_box;
  double m_scale = 1, m_margin = 0, m_height = 0, m_units = 100, m_depth_units = 100;

public:
  explicit Picture_frame(const Scene_content& scene)
  {
    const auto include = [&](const Triple& p, double nearer) {
      m_box += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2] + nearer);
    };
    for (const auto& face : scene.faces())
      for (const Triple& p : face.corners)
        include(p, 0);
    for (const auto& line : scene.lines())
      for (const Triple& p : line.points)
        include(p, std::abs(line.style.nearer));
    for (const auto& mark : scene.marks())
      include(mark.point, std::abs(mark.style.nearer));
    constexpr double tallest = 3;   // beside the width
    const double extent = (std::max)(m_box.xmax() - m_box.xmin(), (m_box.ymax() - m_box.ymin()) / tallest);
    if (!(extent > 0))
      throw Invalid_input("Scene_3: what is drawn has no extent in the picture");
    m_margin = scene.width() / 40;
    m_scale = (scene.width() - 2 * m_margin) / extent;
    m_height = m_scale * (m_box.ymax() - m_box.ymin()) + 2 * m_margin;
    constexpr double most = most_coordinate - 2.;
    while (m_units > 1 && (std::max)(scene.width(), m_height) * m_units > most)
      m_units /= 10;
    if (m_height * m_units > most)
      throw Invalid_input("Scene_3: the picture is too high");
    m_depth_units = (std::min)(m_units, most / ((m_box.zmax() - m_box.zmin()) * m_scale + 1));
  }

  double height() const { return m_height; }

  Grid_point grid_point(const Triple& p, double nearer = 0) const
  {
    const auto rounded = [](double x) { return static_cast<std::int64_t>(std::llround(x)); };
    return {rounded((m_margin + m_scale * (p[0] - m_box.xmin())) * m_units),
            rounded((m_margin + m_scale * (p[1] - m_box.ymin())) * m_units),
            rounded(m_scale * (p[2] + nearer - m_box.zmin()) * m_depth_units)};
  }

  std::array<double, 2> pixels(const Exact_point& p) const
  {
    return {to_nearest_double(p[0]) / m_units, to_nearest_double(p[1]) / m_units};
  }

  std::array<double, 2> pixels(const Grid_point& p) const
  {
    return {static_cast<double>(p[0]) / m_units, static_cast<double>(p[1]) / m_units};
  }

  std::array<double, 4> grid_box(double width) const { return {0, 0, width * m_units, m_height * m_units}; }
};

class Scene_painter
{
  using Point = std::array<double, 2>;

  const Scene_content& m_scene;
  Picture_frame m_frame;
  std::vector<Grid_triangle> m_triangles;   // counterclockwise where something is seen of them
  std::vector<int> m_facing;                // 1: the front is seen, -1: the back, 0: the edge
  SVG_writer m_picture;

public:
  Scene_painter(const Scene_content& scene, std::ostream& out)
    : m_scene(scene), m_frame(scene),
      m_picture(out, CGAL::Bbox_2(0, 0, scene.width(), m_frame.height()), scene.width())
  {
    for (const Scene_content::Face& face : scene.faces()) {
      Grid_triangle triangle{m_frame.grid_point(face.corners[0]), m_frame.grid_point(face.corners[1]),
                             m_frame.grid_point(face.corners[2])};
      m_facing.push_back(sign_of(turn(triangle[0], triangle[1], triangle[2])));
      if (m_facing.back() < 0)
        std::swap(triangle[1], triangle[2]);
      m_triangles.push_back(triangle);
    }
  }

  // Returns the number of pairs of faces that pass through each other still.
  std::size_t paint()
  {
    const std::array<double, 4> box = m_frame.grid_box(m_scene.width());
    Painters_order order(box, m_triangles, m_scene.most_splits());
    paint_faces(order.facets());
    const Hidden_parts hidden(box, m_triangles);
    for (const Scene_content::Line& line : m_scene.lines())
      paint_line(line, hidden, true);
    paint_edges(hidden);
    for (const Scene_content::Line& line : m_scene.lines())
      paint_line(line, hidden, false);
    for (const Scene_content::Mark& mark : m_scene.marks())
      paint_mark(mark, hidden);
    return order.number_of_unsplit();
  }

private:
  void paint_faces(const std::vector<Facet>& facets)
  {
    constexpr double edge = 0.6;   // less, and programs that smooth edges show gaps
    for (const Facet& facet : facets) {
      std::vector<Point> outline;
      for (const Exact_point& p : facet.outline())
        outline.push_back(m_frame.pixels(p));
      const Scene_content::Face& face = m_scene.faces()[facet.source];
      m_picture.polygon(outline, m_facing[facet.source] > 0 ? face.front : face.back, edge);
    }
  }

  // Silhouettes, where the front is seen on one side only, boundaries and creases.
  void paint_edges(const Hidden_parts& hidden)
  {
    constexpr double strong = 1.2, weak = 0.7;
    for (const Scene_content::Edge& edge : m_scene.edges()) {
      const bool is_boundary = edge.faces.size() < 2;
      const bool is_silhouette = !is_boundary && m_facing[edge.faces[0]] * m_facing[edge.faces[1]] <= 0;
      if (!is_boundary && !is_silhouette && !edge.is_crease)
        continue;
      for (const auto& chain : chains({edge.ends[0], edge.ends[1]}, 0, hidden, false))
        m_picture.polyline(chain, edge.color, is_boundary || is_silhouette ? strong : weak);
    }
  }

  void paint_line(const Scene_content::Line& line, const Hidden_parts& hidden, bool paints_hidden)
  {
    const Line_style_3& style = line.style;
    if (paints_hidden && style.hidden == Hidden_line::LEFT_OUT)
      return;
    const double width = paints_hidden ? style.width / 2 : style.width;
    for (const auto& chain : chains(line.points, style.nearer, hidden, paints_hidden))
      if (paints_hidden && style.hidden == Hidden_line::DASHED)
        for (const auto& dash : dashes(chain))
          m_picture.polyline(dash, style.color, width);
      else
        m_picture.polyline(chain, style.color, width);
  }

  void paint_mark(const Scene_content::Mark& mark, const Hidden_parts& hidden)
  {
    const Grid_point at = m_frame.grid_point(mark.point, mark.style.nearer);
    const bool is_hidden = hidden.is_hidden(at);
    if (is_hidden && mark.style.hidden == Hidden_line::LEFT_OUT)
      return;
    const Point pixels = m_frame.pixels(at);
    using Kernel = CGAL::Simple_cartesian<double>;
    const Kernel::Point_2 p(pixels[0], pixels[1]);
    m_picture.point(p, mark.style.color, is_hidden ? mark.style.width / 2 : mark.style.width);
    if (!mark.label.empty())
      m_picture.label(Kernel::Point_2(p.x() + mark.style.width, p.y() + mark.style.width / 2), mark.label);
  }

  // The hidden or the visible parts of a polyline, joined.
  std::vector<std::vector<Point>> chains(const std::vector<Triple>& points, double nearer, const Hidden_parts& hidden,
                                         bool are_hidden) const
  {
    std::vector<std::vector<Point>> result;
    bool goes_on = false;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Grid_point p = m_frame.grid_point(points[i], nearer), q = m_frame.grid_point(points[i + 1], nearer);
      if (p[0] == q[0] && p[1] == q[1])
        continue;
      for (const Segment_part& part : hidden.parts(p, q)) {
        if (part.is_hidden == are_hidden) {
          if (!goes_on)
            result.push_back({at(p, q, part.begin)});
          result.back().push_back(at(p, q, part.end));
        }
        goes_on = part.is_hidden == are_hidden;
      }
    }
    return result;
  }

  Point at(const Grid_point& p, const Grid_point& q, const Exact_rational& parameter) const
  {
    const Point from = m_frame.pixels(p), to = m_frame.pixels(q);
    const double t = to_nearest_double(parameter);
    return {std::lerp(from[0], to[0], t), std::lerp(from[1], to[1], t)};
  }

  static std::vector<std::vector<Point>> dashes(const std::vector<Point>& chain)
  {
    constexpr double dash = 5, gap = 4;   // pixels
    std::vector<std::vector<Point>> result{{chain.front()}};
    bool is_drawn = true;
    double left = dash;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const double length = std::hypot(chain[i + 1][0] - chain[i][0], chain[i + 1][1] - chain[i][1]);
      double done = 0;
      for (; length - done > left; is_drawn = !is_drawn, left = is_drawn ? dash : gap) {
        done += left;
        const Point at{std::lerp(chain[i][0], chain[i + 1][0], done / length),
                       std::lerp(chain[i][1], chain[i + 1][1], done / length)};
        if (is_drawn)
          result.back().push_back(at);
        else
          result.push_back({at});
      }
      left -= length - done;
      if (is_drawn)
        result.back().push_back(chain[i + 1]);
    }
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t paint(const Scene_content& scene, std::ostream& out)
{
  return Scene_painter(scene, out).paint();
}

} // namespace Scene
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_SCENE_PAINTER_H
