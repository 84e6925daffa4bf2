// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_EDGE_SAMPLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_EDGE_SAMPLES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/parameters_within_radius.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Points of the edges of a diagram, and the disks around them.
class Edge_samples
{
  using Point = std::array<double, 2>;
  using Sample = Disk_sample;
  using Part = Disk_diagram::Part;
  using Bounds = std::array<double, 2>;

  const Site_graph_2<>& m_graph;
  const Disk_diagram& m_diagram;

public:
  Edge_samples(const Site_graph_2<>& graph, const Disk_diagram& diagram) : m_graph(graph), m_diagram(diagram) {}

  // The disk that touches the element of a part in a point.
  Sample operator()(const Part& part, double u) const
  {
    const Oriented_element<>& element = m_diagram.element(part);
    const Disk_footpoint& footpoint = m_diagram.envelope_arc(part).footpoint;
    const Envelope_arc_disks::Disk disk = m_diagram.estimated_disk(part, u);
    const std::array<std::optional<double>, 2> parameters{
        curve_parameter(element.is_normal_cone, element.object, u),
        curve_parameter(footpoint.kind == Disk_footpoint::Kind::VERTEX, footpoint.index, disk.parameter)};
    if (disk.is_point)
      return {middle(disk.center), 0, parameters, {0, 0}};
    const Element_jet<> x = m_graph.element_jet(element, {u, u});
    const Interval radius = radius_of_disk(x.normal, disk.bounds);
    const Bounds bounds{radius.inf(), radius.sup()};
    if (!std::isfinite(disk.curvature.sup() - disk.curvature.inf()))   // a corner
      return {middle(x.point), 0, parameters, bounds};
    if (!(disk.curvature.inf() > 0))
      return {Point{0, 0}, infinity, parameters, bounds};
    // one number for the curvature, whatever its bounds: so the disk touches the element
    const Interval curvature(std::clamp(middle(disk.curvature), disk.bounds.inf(), disk.bounds.sup()));
    return {middle(with_curvature(x, curvature)), middle(radius_of_disk(x.normal, curvature)), parameters, bounds};
  }

  // Appends the samples of a part that are not too far away.
  void append(const Part& part, double error, double most_radius, std::vector<Sample>& samples) const
  {
    if (m_diagram.envelope_arc(part).corner) {
      append_corner(part, most_radius, samples);
      return;
    }
    const auto radius_at = [&](double u) { return (*this)(part, u).radius; };
    const std::array<double, 2> all{m_diagram.end_parameter(part, false), m_diagram.end_parameter(part, true)};
    const std::optional<double> inner = any_within(all, radius_at, most_radius);
    if (!inner)
      return;
    const std::array last{last_within(*inner, all[0], radius_at, most_radius),
                          last_within(*inner, all[1], radius_at, most_radius)};
    using Located = std::pair<double, Sample>;
    const auto located = [&](double u) { return Located(u, (*this)(part, u)); };
    const auto between = [&](const Located& from, const Located& to) { return located(from.first / 2 + to.first / 2); };
    const auto is_chord = [&](const Located& from, const Located& middle, const Located& to) {
      return height_over_chord(from.second, middle.second, to.second) <= error;
    };
    std::vector<Located> along{located(last[0].parameter)};
    append_samples(along, located(last[1].parameter), between, is_chord);
    for (const bool end : {false, true})
      if (const auto& next = last[end].jump)   // from there on, the edge goes along the normal, up to rounding
        along.insert(end ? along.end() : along.begin(),
                     {*next,
                      with_radius(part, *next, most_radius, end ? along.back().second : along.front().second,
                                  (*this)(part, *next))});
    for (std::size_t i = samples.empty() ? 0 : 1; i < along.size(); ++i)
      samples.push_back(along[i].second);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The centers of the disks in a pocket are on a line, up to rounding: from the corner to the disk at the other end,
  // or as far as radii go.
  void append_corner(const Part& part, double most_radius, std::vector<Sample>& samples) const
  {
    // of the traversal
    const bool is_end = m_diagram.envelope_arc(part).corner->is_end != m_diagram.element(part).is_reversed;
    const double u = m_diagram.end_parameter(part, is_end);
    Sample corner = (*this)(part, u);
    corner.radius_bounds = {0, 0};
    Sample last = (*this)(part, m_diagram.end_parameter(part, !is_end));
    if (last.radius > most_radius)
      last = with_radius(part, u, most_radius, corner, last);
    if (samples.empty())
      samples.push_back(is_end ? last : corner);
    samples.push_back(is_end ? corner : last);
  }

  // The disk of a given radius between a smaller one and a larger one, which touch the element in the same point up to
  // rounding.
  Sample with_radius(const Part& part, double u, double radius, const Sample& smaller, const Sample& larger) const
  {
    const Element_jet<> x = m_graph.element_jet(m_diagram.element(part), {u, u});
    const bool is_between = smaller.radius_bounds[1] <= radius && radius <= larger.radius_bounds[0];
    const Bounds bounds = is_between ? Bounds{radius, radius}
                                     : Bounds{(std::min)(smaller.radius_bounds[0], larger.radius_bounds[0]),
                                              (std::max)(smaller.radius_bounds[1], larger.radius_bounds[1])};
    return {middle(with_curvature(x, CGAL::sqrt(squared_norm(x.normal)) / Interval(radius))), radius, larger.parameters,
            bounds};
  }

  static Interval_pair with_curvature(const Element_jet<>& x, const Interval& k)
  {
    return {x.point[0] + x.normal[0] / k, x.point[1] + x.normal[1] / k};
  }

  std::optional<double> curve_parameter(bool is_point, std::size_t arc, double u) const
  {
    return is_point ? std::nullopt : std::optional(m_graph.curve_parameter(arc, u));
  }

  static double middle(const Interval& x) { return x.inf() / 2 + x.sup() / 2; }
  static Point middle(const Interval_pair& p) { return {middle(p[0]), middle(p[1])}; }

  static double height_over_chord(const Sample& from, const Sample& middle, const Sample& to)
  {
    const Point &p = from.center, &q = middle.center, &r = to.center;
    const double length = std::hypot(r[0] - p[0], r[1] - p[1]);
    return length > 0 ? std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / length
                      : std::hypot(q[0] - p[0], q[1] - p[1]);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_EDGE_SAMPLES_H
