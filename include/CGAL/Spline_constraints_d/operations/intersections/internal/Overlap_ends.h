// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_OVERLAP_ENDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_OVERLAP_ENDS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Curve_parts.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The ends of the overlaps of two operands, which are common points that are known already. They are found once more where
other pieces begin or at a seam.

An answer is such an end if its parameters are those of the end, or stand for the same point on a seam; or if they hold
the end, and it is proved that they hold no other common point: it counts once; or one operand has exact parameters, and
the other one has no point twice; or there is none of two curves outside of the overlaps.
*/
template <int d>
class Overlap_ends
{
  struct End
  {
    std::vector<Exact_rational> parameters;
    const Common_point* overlap;
  };

  const Patch_pair<d>& m_pair;
  std::vector<End> m_ends;
  std::optional<Curve_parts<d>> m_parts;
  bool m_has_overlaps = false;

public:
  Overlap_ends(const Patch_pair<d>& pair, const std::vector<Common_point>& points) : m_pair(pair)
  {
    if (pair.number_of_parameters() == 2 && pair.first_parameter(1) == 1)
      m_parts.emplace(pair, points);
    for (const Common_point& point : points)
      if (point.kind == Intersection_kind::OVERLAP) {
        m_has_overlaps = true;
        add_ends(point);
      }
  }

  bool hold(const Common_point& point)
  {
    const bool is_inside_of_pieces = point.multiplicity && has_interior(point.parameters);   // found by elimination
    if (is_inside_of_pieces)
      return false;
    const auto is_end = [&](const End& end) {
      if (!has_extent(point.parameters))
        return is_same_point(point.parameters, end);
      const bool counts_once = point.solution && point.solution->is_certified();   // unlike the pole of a surface
      return holds(point.parameters, end) &&
          (counts_once || is_only_parameter_of_point(point.parameters) || is_only_common_point(point.parameters, end));
    };
    return point.kind != Intersection_kind::OVERLAP &&
        (std::any_of(m_ends.begin(), m_ends.end(), is_end) || is_part_of_overlaps(point.parameters));
  }

private:
  // The corners of its ranges that are common points.
  void add_ends(const Common_point& overlap)
  {
    std::vector<std::vector<Exact_rational>> corners(1);
    for (const auto& [begin, end] : overlap.parameters) {
      std::vector<std::vector<Exact_rational>> longer;
      for (const std::vector<Exact_rational>& corner : corners)
        for (const Exact_rational& next :
             begin < end ? std::vector<Exact_rational>{begin, end} : std::vector<Exact_rational>{begin}) {
          longer.push_back(corner);
          longer.back().push_back(next);
        }
      corners = std::move(longer);
    }
    const auto split = static_cast<std::ptrdiff_t>(m_pair.first_parameter(1));
    for (const std::vector<Exact_rational>& corner : corners)
      if (m_pair[0](std::vector<Exact_rational>(corner.begin(), corner.begin() + split)) ==
          m_pair[1](std::vector<Exact_rational>(corner.begin() + split, corner.end())))
        m_ends.push_back({corner, &overlap});
  }

  // The lower end of a closed operand stands for the upper one.
  bool is_same_point(const Parameter_box& parameters, const End& end) const
  {
    const Parameter_box domain = m_pair.domain();
    for (std::size_t j = 0; j < domain.size(); ++j) {
      const Exact_rational &x = parameters[j].first, &y = end.parameters[j];
      const auto is_at_end = [&](const Exact_rational& value) {
        return value == domain[j].first || value == domain[j].second;
      };
      if (x != y && !(is_at_end(x) && is_at_end(y) && m_pair.is_repeated_at_end(j)))
        return false;
    }
    return true;
  }

  static bool holds(const Parameter_box& box, const End& end)
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (end.parameters[j] < box[j].first || box[j].second < end.parameters[j])
        return false;
    return true;
  }

  // The parameters of one operand are exact, and its point is no other point of the other one in the box: where
  // derivatives are not zero and not parallel, different parameters have different points.
  bool is_only_parameter_of_point(const Parameter_box& box) const
  {
    const auto split = box.begin() + static_cast<std::ptrdiff_t>(m_pair.first_parameter(1));
    const std::array<Parameter_box, 2> own{Parameter_box(box.begin(), split), Parameter_box(split, box.end())};
    for (const std::size_t k : {0, 1})
      if (!has_extent(own[1 - k])) {
        const Spline_patch<d> part = m_pair[k].part(own[k]);
        return part.number_of_parameters() == 1 ? squared_norm(part.tangents(0)).lower > 0
                                                : !may_be_parallel<d>(part.tangents(0), part.tangents(1));
      }
    return false;
  }

  // Of two curves, whether all common points in a box belong to overlaps, whose ends need not be known.
  bool is_part_of_overlaps(const Parameter_box& box)
  {
    return m_parts && m_has_overlaps && has_extent(box) && m_parts->holds_only(box, {});
  }

  // Of two curves, where all others belong to the overlap.
  bool is_only_common_point(const Parameter_box& box, const End& end)
  {
    return m_parts && m_parts->holds_only(box, {end.parameters}, &end.overlap->parameters);
  }
};

template <int d>
void drop_ends_of_overlaps(const Patch_pair<d>& pair, std::vector<Common_point>& points)
{
  const std::vector<Common_point> all = points;
  Overlap_ends<d> ends(pair, all);
  std::erase_if(points, [&](const Common_point& point) { return ends.hold(point); });
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_OVERLAP_ENDS_H
