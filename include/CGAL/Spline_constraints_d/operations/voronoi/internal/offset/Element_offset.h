// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ELEMENT_OFFSET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ELEMENT_OFFSET_H

#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The centers O(u) = X + r N / |N| of the disks of one radius that touch an element.
*/
class Element_offset
{
  const Site_graph_2<>& m_graph;
  const Oriented_element<>& m_element;
  Interval m_radius;

public:
  Element_offset(const Site_graph_2<>& graph, std::size_t element, const Interval& radius)
    : m_graph(graph), m_element(graph.elements()[element]), m_radius(radius)
  {}

  Interval_pair point(const Range& range) const
  {
    const Interval_pair naive = center(m_graph.element_jet(m_element, range));
    if (range.is_number())
      return naive;
    const double u = range.middle();
    return common_part(
        naive, center(m_graph.element_jet(m_element, {u, u})) + (range.interval() - Interval(u)) * derivative(range));
  }

  Interval_pair derivative(const Range& range) const
  {
    const Element_jet<> x = m_graph.element_jet(m_element, range);
    const Interval square = squared_norm(x.normal);
    if (!(square.inf() > 0))
      return {any_number(), any_number()};
    const Interval along = dot(x.normal, x.normal_derivative) / square;
    return x.point_derivative + (m_radius / CGAL::sqrt(square)) * (x.normal_derivative - along * x.normal);
  }

  // Parameters from one to another one, so that the offset is no farther than an error from the lines of the chords.
  std::vector<double> stops(double begin, double end, double error) const
  {
    const auto between = [](double from, double to) { return from / 2 + to / 2; };
    const auto is_chord = [&](double from, double, double to) {
      return height({(std::min)(from, to), (std::max)(from, to)}) <= error;
    };
    std::vector<double> result{begin};
    append_samples(result, end, between, is_chord, {0, 24});
    return result;
  }

private:
  Interval_pair center(const Element_jet<>& x) const
  {
    return x.point + (m_radius / CGAL::sqrt(squared_norm(x.normal))) * x.normal;
  }

  // A bound of the distance from the line of the chord.
  double height(const Range& range) const
  {
    const Interval_pair chord = point({range.end, range.end}) - point({range.begin, range.begin});
    const Interval length = CGAL::sqrt(squared_norm(chord));
    if (!(length.inf() > 0)) {   // as far as the offset goes at all
      const Interval_pair box = point(range);
      return CGAL::sqrt(CGAL::square(box[0] - box[0]) + CGAL::square(box[1] - box[1])).sup();
    }
    // at most half of the way up
    const Interval rise = dot(turned_left(chord), derivative(range)) / length *
        (Interval(range.end) - Interval(range.begin)) / Interval(2);
    return (std::max)(rise.sup(), -rise.inf());
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ELEMENT_OFFSET_H
