// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SVG_VORONOI_DIAGRAM_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SVG_VORONOI_DIAGRAM_2_H

#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <ostream>
#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

draws the Voronoi diagram or medial axis of curves in layers with the names `cells`, `edges`, `sites` and `vertices`:
the cells of each curve and of each isolated point in one of seven colors, edges and vertices of degree three or more in
red, curves and isolated points in black.

Edges are drawn up to a quarter of a pixel, and as far as the radius of their disks is at most the larger extent of the
view. What lies between an edge and the feet of its points belongs to the cells of its two sites; so are the cells
drawn, in quadrangles.

\param picture where to.
\param diagram the diagram.
\param range what it was made from, a range of `Bspline_curve_2`.

Complexity: linear in the number of points that are drawn.
*/
template <SplineKernel Kernel, std::ranges::input_range Range>
  requires std::convertible_to<std::ranges::range_value_t<Range>, Bspline_curve_2<Kernel>>
void draw(SVG_writer& picture, const Voronoi_diagram_of_curves_2<Kernel>& diagram, Range&& range)
{
  std::vector<Bspline_curve_2<Kernel>> curves;
  for (auto&& curve : range)
    curves.push_back(curve);
  constexpr std::array<const char*, 7> colors{"#eeeeee", "#aec7e8", "#ffbb78", "#98df8a",
                                              "#ff9896", "#c5b0d5", "#f7d7a0"};
  std::vector<std::vector<Voronoi_sample_2<Kernel>>> edges;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    edges.push_back(diagram.polyline(e, picture.pixel() / 4, picture.extent()));

  picture.layer("cells");
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t index = diagram.edges()[e].sites[side];
      const Voronoi_site_2<Kernel>& site = diagram.sites()[index];
      std::vector<typename Kernel::Point_2> cell;
      for (const auto& sample : edges[e])
        cell.push_back(sample.point);
      for (auto sample = edges[e].rbegin(); sample != edges[e].rend(); ++sample)
        cell.push_back(site.is_point ? site.point : curves[*site.curve](*sample->parameters[side]));
      if (!cell.empty())
        picture.polygon(cell, colors[site.curve.value_or(index) % colors.size()]);
    }
  picture.layer("edges");
  for (const auto& edge : edges)
    picture.polyline(edge, "#d62728");
  picture.layer("sites");
  for (const auto& curve : curves)
    picture.curve(curve, "black", 3);
  for (const auto& site : diagram.sites())
    if (site.is_point && !site.curve)
      picture.point(site.point);
  picture.layer("vertices");
  for (const auto& vertex : diagram.vertices())
    if (!vertex.is_at_infinity && vertex.edges.size() > 2)
      picture.point(*vertex.point, "#d62728", 6);
}

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

draws the Voronoi diagram or medial axis of curves, with a margin of a thirtieth of their extent; see `draw()`.
\param out where the drawing is written to.
\param range what the diagram was made from, a range of one `Bspline_curve_2` or more.
\param diagram the diagram.
\throws Invalid_input when there are no curves, or they are all one point.
*/
template <SplineKernel Kernel, std::ranges::input_range Range>
  requires std::convertible_to<std::ranges::range_value_t<Range>, Bspline_curve_2<Kernel>>
void write_SVG(std::ostream& out, Range&& range, const Voronoi_diagram_of_curves_2<Kernel>& diagram)
{
  std::vector<Bspline_curve_2<Kernel>> curves;
  for (auto&& curve : range)
    curves.push_back(curve);
  SVG_writer picture(out, curves, 700);
  draw(picture, diagram, curves);
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SVG_VORONOI_DIAGRAM_2_H
