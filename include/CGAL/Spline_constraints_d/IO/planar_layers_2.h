// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_PLANAR_LAYERS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_PLANAR_LAYERS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

template <SplineKernel Kernel> class Convex_hull_2;
template <SplineKernel Kernel> class Minkowski_sum_2;
template <SplineKernel Kernel> class Planar_region_2;
template <SplineKernel Kernel> class Region_distance_2;
template <SplineKernel Kernel> class Region_kernel_2;
template <SplineKernel Kernel> class Trimmed_alpha_sector_2;
template <SplineKernel Kernel> class Trimmed_bisector_2;
template <SplineKernel Kernel> class Trimmed_offset_2;
template <SplineKernel Kernel> class Visible_part_2;
template <SplineKernel Kernel> class Voronoi_diagram_of_curves_2;

/*!
\ingroup PkgSplineConstraintsDIO

A part of a planar result under a name, in objects of CGAL, which have its stream operators.
*/
template <SplineKernel Kernel>
struct Planar_layer_2
{
  std::string name;                                           ///< what it is
  std::string color;                                          ///< one of SVG
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> areas;      ///< polygons
  std::vector<std::vector<typename Kernel::Point_2>> lines;   ///< polylines of two points or more
  std::vector<typename Kernel::Point_2> points;               ///< isolated points
};

//! \ingroup PkgSplineConstraintsDIO
//! the layers of a planar result; those without an object are left out.
template <SplineKernel Kernel>
using Planar_layers_2 = std::vector<Planar_layer_2<Kernel>>;

namespace internal {

inline constexpr const char* color_of_areas = "#dbe9f6";
inline constexpr const char* color_of_curves = "#d62728";
inline constexpr const char* color_of_segments = "#1f77b4";

// Layers with names and colors, in this order, for objects to be added.
template <SplineKernel Kernel>
class Planar_layer_collector
{
  using Point = typename Kernel::Point_2;

  Planar_layers_2<Kernel> m_layers;

public:
  Planar_layer_collector(std::initializer_list<std::pair<const char*, const char*>> names_and_colors)
  {
    for (const auto& [name, color] : names_and_colors)
      m_layers.push_back({name, color, {}, {}, {}});
  }

  void add_areas(const std::string& name, std::vector<CGAL::Polygon_with_holes_2<Kernel>> areas)
  {
    layer(name).areas = std::move(areas);
  }

  void add_area(const std::string& name, const CGAL::Polygon_2<Kernel>& area)
  {
    if (area.size() > 2)
      add_areas(name, {CGAL::Polygon_with_holes_2<Kernel>(area)});
  }

  // Of points, or of samples whose member `point` is one; one alone is isolated.
  template <class Range>
  void add_line(const std::string& name, const Range& samples)
  {
    std::vector<Point> line;
    for (const auto& sample : samples)
      if constexpr (requires { sample.point; })
        line.push_back(sample.point);
      else
        line.push_back(sample);
    if (line.size() > 1)
      layer(name).lines.push_back(std::move(line));
    else if (!line.empty())
      add_point(name, line.front());
  }

  void add_point(const std::string& name, const Point& point) { layer(name).points.push_back(point); }

  // Those that are not empty.
  Planar_layers_2<Kernel> layers() &&
  {
    std::erase_if(m_layers,
                  [](const auto& layer) { return layer.areas.empty() && layer.lines.empty() && layer.points.empty(); });
    return std::move(m_layers);
  }

private:
  Planar_layer_2<Kernel>& layer(const std::string& name)
  {
    return *std::find_if(m_layers.begin(), m_layers.end(), [&](const auto& layer) { return layer.name == name; });
  }
};

// Of a boundary of edges of several kinds: an area, and a layer for each kind, with its name.
template <SplineKernel Kernel, class Result>
Planar_layers_2<Kernel> layers_by_kinds(const Result& result, double error)
{
  Planar_layer_collector<Kernel> collector{{"area", color_of_areas},
                                           {"arc", color_of_curves},
                                           {"segment", color_of_segments},
                                           {"open", color_of_segments},
                                           {"undecided", color_of_segments}};
  collector.add_area("area", result.polygon(error));
  for (std::size_t i = 0; i < result.edges().size(); ++i) {
    std::ostringstream kind;
    kind << result.edges()[i].kind;
    collector.add_line(kind.str(), result.polyline(i, error));
  }
  return std::move(collector).layers();
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIO

what planar operations return, as layers of polygons, polylines and points, to be drawn, `draw()`, written,
`IO::write_WKT()`, or handed to CGAL. There is an overload for each kind of result. This one is for Voronoi diagrams and
medial axes: `edges`, and `vertices`, those of degree three or more.

\param diagram the result.
\param error the distance between curves and chords, as of its `polyline()`; positive.
\param most_radius edges are cut where the radius of the disks is larger, and so are vertices; positive.
\throws Invalid_input when the error is not positive; the radius is not positive, or infinite where it has to be finite.

Complexity: linear in the number of points.
*/
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Voronoi_diagram_of_curves_2<Kernel>& diagram, double error,
                                      double most_radius)
{
  internal::Planar_layer_collector<Kernel> collector{{"edges", internal::color_of_curves},
                                                     {"vertices", internal::color_of_curves}};
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    collector.add_line("edges", diagram.polyline(e, error, most_radius));
  for (const auto& vertex : diagram.vertices())
    if (!vertex.is_at_infinity && *vertex.radius <= most_radius && vertex.edges.size() > 2)
      collector.add_point("vertices", *vertex.point);
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of a trimmed bisector: `bisector`. As above; the radius is finite.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Trimmed_bisector_2<Kernel>& bisector, double error, double most_radius)
{
  internal::Planar_layer_collector<Kernel> collector{{"bisector", internal::color_of_curves}};
  for (const auto& chain : bisector.chains())
    for (const auto& line : bisector.polylines(chain, error, most_radius))
      collector.add_line("bisector", line);
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of a trimmed \f$\alpha\f$-sector: `sector`. As above.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Trimmed_alpha_sector_2<Kernel>& sector, double error)
{
  internal::Planar_layer_collector<Kernel> collector{{"sector", internal::color_of_curves}};
  for (std::size_t arc = 0; arc < sector.arcs().size(); ++arc)
    collector.add_line("sector", sector.polyline(arc, error));
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of a trimmed offset: `area`, without boundaries that are not closed; `curve` and `circle`, the arcs beside curves
//! and around points. As above.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Trimmed_offset_2<Kernel>& offset, double error)
{
  internal::Planar_layer_collector<Kernel> collector{{"area", internal::color_of_areas},
                                                     {"curve", internal::color_of_curves},
                                                     {"circle", internal::color_of_segments}};
  collector.add_areas("area", offset.polygons_with_holes(error));
  for (std::size_t arc = 0; arc < offset.arcs().size(); ++arc)
    collector.add_line(offset.arcs()[arc].is_circular ? "circle" : "curve", offset.polyline(arc, error));
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of a Minkowski sum or a swept area: `area`, without boundaries that are not closed; and `boundary`. As above.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Minkowski_sum_2<Kernel>& sum, double error)
{
  internal::Planar_layer_collector<Kernel> collector{{"area", internal::color_of_areas},
                                                     {"boundary", internal::color_of_curves}};
  collector.add_areas("area", sum.polygons_with_holes(error));
  for (std::size_t b = 0; b < sum.boundaries().size(); ++b)
    for (std::size_t arc = 0; arc < sum.boundaries()[b].arcs.size(); ++arc)
      collector.add_line("boundary", sum.polyline(b, arc, error));
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of a region: `area`. As above.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Planar_region_2<Kernel>& region, double error)
{
  internal::Planar_layer_collector<Kernel> collector{{"area", internal::color_of_areas}};
  collector.add_areas("area", region.polygons_with_holes(error));
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of a convex hull: `area`, and the parts of the boundary by their kinds, `arc`, `segment` and `undecided`. As above.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Convex_hull_2<Kernel>& hull, double error)
{
  return internal::layers_by_kinds<Kernel>(hull, error);
}

//! \ingroup PkgSplineConstraintsDIO
//! of the kernel of a region: as of a convex hull; of one without interior `flat`, a segment or a point that it lies
//! in.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Region_kernel_2<Kernel>& kernel, double error)
{
  if (kernel.has_interior())
    return internal::layers_by_kinds<Kernel>(kernel, error);
  internal::Planar_layer_collector<Kernel> collector{{"flat", internal::color_of_segments}};
  collector.add_line("flat", kernel.flat_part());
  return std::move(collector).layers();
}

//! \ingroup PkgSplineConstraintsDIO
//! of what is seen from a point: as of a convex hull, and `open`, between rays along which no curve is seen.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Visible_part_2<Kernel>& visible, double error)
{
  return internal::layers_by_kinds<Kernel>(visible, error);
}

//! \ingroup PkgSplineConstraintsDIO
//! of the distance of two regions: `distance`, the segments between nearest points, or these points if regions touch.
//! These are not curves: no error matters.
template <SplineKernel Kernel>
Planar_layers_2<Kernel> planar_layers(const Region_distance_2<Kernel>& distance, double)
{
  internal::Planar_layer_collector<Kernel> collector{{"distance", internal::color_of_segments}};
  for (const auto& pair : distance.pairs()) {
    std::vector<typename Kernel::Point_2> ends{pair.points.point(0), pair.points.point(1)};
    if (ends[0] == ends[1])
      ends.pop_back();
    collector.add_line("distance", ends);
  }
  return std::move(collector).layers();
}

namespace internal {

template <class Result>
concept Planar_result = requires(const Result& result) { planar_layers(result, 1.); };

template <class Result>
concept Unbounded_planar_result = requires(const Result& result) { planar_layers(result, 1., 1.); };

} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_PLANAR_LAYERS_2_H
