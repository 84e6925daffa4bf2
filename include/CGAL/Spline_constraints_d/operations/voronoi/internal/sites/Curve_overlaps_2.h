// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CURVE_OVERLAPS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CURVE_OVERLAPS_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Arc_germ.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Coincident_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The overlaps of two polynomial or rational pieces, as far as they are proved exactly: pieces with the same polynomials,
one of them perhaps backwards or of a higher degree, pieces of lines and circles, and others of one curve that turn by
less than a right angle, whatever their speeds.
*/
class Overlap_of_pieces
{
  using Tensor = Bernstein_tensor<Exact_rational>;

  const Spline_patch<2> &m_first, &m_second;
  Search_control* m_control;   // none: nothing ends the search

public:
  Overlap_of_pieces(const Spline_patch<2>& first, const Spline_patch<2>& second, Search_control* control)
    : m_first(first), m_second(second), m_control(control)
  {}

  // Returns whether there is a proof wherever the pieces overlap.
  bool append_to(std::vector<Curve_overlap_2>& result) const
  {
    Search_control::Watch watch(m_control);
    Budgeted_solver solve(watch.options());
    std::vector<Curve_overlap_2> proved;
    bool are_all_proved = true;
    for (const Common_point& common : common_points<2>(Patch_pair<2>(m_first, m_second), solve))
      if (common.kind == Intersection_kind::OVERLAP && has_extent(common.parameters))
        are_all_proved = append_proved({common.parameters[0], common.parameters[1]}, proved) && are_all_proved;
    if (!are_all_proved) {
      proved.clear();
      append_between_common_ends(proved);
      are_all_proved = !proved.empty();
    }
    result.insert(result.end(), proved.begin(), proved.end());
    return are_all_proved;
  }

private:
  using Parameters = std::array<Exact_rational, 2>;

  // Of enclosures that are not exact, the ends are found again: they are ends of one of the pieces.
  void append_between_common_ends(std::vector<Curve_overlap_2>& result) const
  {
    std::vector<Parameters> ends;
    append_common_ends(0, ends);
    append_common_ends(1, ends);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const auto& [first, second] = std::minmax(ends[i - 1][1], ends[i][1]);
      append_proved({Parameter_range(ends[i - 1][0], ends[i][0]), Parameter_range(first, second)}, result);
    }
  }

  // The ends of a piece that are on the other one at rational parameters.
  void append_common_ends(std::size_t k, std::vector<Parameters>& result) const
  {
    const Spline_patch<2>&own = k == 0 ? m_first : m_second, &other = k == 0 ? m_second : m_first;
    const auto [begin, end] = own.domain(0);
    for (const Exact_rational& t : {begin, end}) {
      const Exact_pair point = own(std::array<Exact_rational, 1>{t});
      Search_control::Watch watch(m_control);
      Budgeted_solver solve(watch.options());
      for (const Common_point& common : common_points<2>(Patch_pair<2>(Spline_patch<2>(point), other), solve)) {
        const Exact_rational s = simplest_rational_between(common.parameters[0].first, common.parameters[0].second);
        if (other(std::array<Exact_rational, 1>{s}) == point)
          result.push_back(k == 0 ? Parameters{t, s} : Parameters{s, t});
      }
    }
  }

  // Whether there is an overlap with exactly these parameters, by proof.
  bool append_proved(const std::array<Parameter_range, 2>& parameters, std::vector<Curve_overlap_2>& result) const
  {
    if (!(parameters[0].first < parameters[0].second && parameters[1].first < parameters[1].second))
      return false;
    const Homogeneous_piece first = piece(m_first, parameters[0]), second = piece(m_second, parameters[1]);
    const Site_arc_2<> a(first), b(second);
    for (const bool is_reversed : {false, true})
      if (a.at(0) == b.at(is_reversed) && a.at(1) == b.at(!is_reversed) &&
          (are_equal(first, is_reversed ? reversed(second) : second) || is_part_of_segment(b, a) ||
           are_equal_circular_arcs(a, b) || are_on_one_curve(a, b, is_reversed))) {
        result.push_back({parameters, is_reversed});
        return true;
      }
    return false;
  }

  // Whether both pieces run along one curve, at different speeds: next to their common point they have more
  // coefficients in common than different curves of their degrees may have (Bezout), and as they go on in this
  // direction, they end there, too, in one place of the curve.
  static bool are_on_one_curve(const Site_arc_2<>& a, const Site_arc_2<>& b, bool is_reversed)
  {
    const Upward_rounding_guard guard;
    const auto goes_on = [](const Site_arc_2<>& arc) { return turns_by_less_than_right_angle(arc.jet(Range(), 1)[1]); };
    if (!are_same_directions(outgoing_direction(a, false), outgoing_direction(b, is_reversed)) || !goes_on(a) ||
        !goes_on(b))
      return false;
    const std::size_t order = static_cast<std::size_t>(a.degree() * b.degree()) + 1;
    const Arc_germ germ(a, false, order);
    return germ.is_known() && germ == Arc_germ(b, is_reversed, order);
  }

  static Homogeneous_piece piece(const Spline_patch<2>& patch, const Parameter_range& range)
  {
    const Spline_patch<2> part = patch.part(0, range);
    const auto tensor = [](const Exact_function& f) { return f.bezier_pieces().front(); };
    return {range, {tensor(part.numerators()[0]), tensor(part.numerators()[1]), tensor(part.weight())}};
  }

  static bool are_equal(const Homogeneous_piece& a, const Homogeneous_piece& b)
  {
    const auto& [x, y, w] = a.coordinates;
    const auto& [u, v, s] = b.coordinates;
    return x * s == u * w && y * s == v * w;
  }

  // Whether the points of a straight piece are on the segment between its ends, which are those of another straight
  // piece.
  static bool is_part_of_segment(const Site_arc_2<>& part, const Site_arc_2<>& whole)
  {
    if (!part.is_straight() || !whole.is_straight())
      return false;
    const Exact_pair a = part.at(0), b = part.at(1), along{Exact_rational(b[0] - a[0]), Exact_rational(b[1] - a[1])};
    const auto& [x, y, w] = part.piece().coordinates;
    // times the weight
    const auto height = [&, &x = x, &y = y, &w = w](const Exact_pair& from) {
      return (x - w * from[0]) * along[0] + (y - w * from[1]) * along[1];
    };
    return w.bounds().first > 0 && height(a).bounds().first >= 0 && height(b).bounds().second <= 0;
  }

  // Whether pieces of a circle with the same ends are on the same side of these. Of degree two, they pass no point
  // twice.
  static bool are_equal_circular_arcs(const Site_arc_2<>& a, const Site_arc_2<>& b)
  {
    const auto is_quadratic = [](const Site_arc_2<>& arc) {
      return std::all_of(arc.piece().coordinates.begin(), arc.piece().coordinates.end(),
                         [](const Tensor& tensor) { return tensor.degree(0) <= 2; });
    };
    if (!a.circle() || a.circle() != b.circle() || a.at(0) == a.at(1) || !is_quadratic(a) || !is_quadratic(b))
      return false;
    const Exact_pair begin = a.at(0), end = a.at(1),
                     chord{Exact_rational(end[0] - begin[0]), Exact_rational(end[1] - begin[1])};
    const auto side = [&](const Site_arc_2<>& arc) {
      const Exact_pair middle = arc.at(one_half());
      return sign_of(
          exact_cross(chord, Exact_pair{Exact_rational(middle[0] - begin[0]), Exact_rational(middle[1] - begin[1])}));
    };
    return side(a) == side(b);
  }

  static Exact_rational one_half() { return Exact_rational(1) / 2; }
};

// The overlaps of two curves that are known to overlap within a range of each, as far as they are proved.
struct Overlaps_of_curves
{
  std::vector<Curve_overlap_2> overlaps;
  bool are_all_proved = true;
};

inline Overlaps_of_curves overlaps_of_curves(const Spline_patch<2>& first, const Spline_patch<2>& second,
                                             const std::array<Parameter_range, 2>& ranges,
                                             Search_control* control = nullptr)
{
  const auto pieces = [](const Spline_patch<2>& curve, const Parameter_range& range) {
    const std::vector<Exact_rational> breaks = curve.breaks(0);
    std::vector<Spline_patch<2>> result;
    for (std::size_t i = 1; i < breaks.size(); ++i)
      if (const Parameter_range part((std::max)(breaks[i - 1], range.first), (std::min)(breaks[i], range.second));
          part.first < part.second)
        result.push_back(curve.part(0, part));
    return result;
  };
  const std::vector<Spline_patch<2>> a = pieces(first, ranges[0]), b = pieces(second, ranges[1]);
  Overlaps_of_curves result;
  for (const auto& [i, j] : pairs_with_meeting_boxes(a, b))
    result.are_all_proved = Overlap_of_pieces(a[i], b[j], control).append_to(result.overlaps) &&
        result.are_all_proved;
  result.are_all_proved = result.are_all_proved && !result.overlaps.empty();
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CURVE_OVERLAPS_2_H
