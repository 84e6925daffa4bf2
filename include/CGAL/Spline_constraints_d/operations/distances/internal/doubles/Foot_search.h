// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_FOOT_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_FOOT_SEARCH_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Nearest_search.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
All feet of perpendiculars from a point to a spline: parameters inside of its pieces where the gradient of the squared
distance is zero. A part on which a derivative has one sign has none. Where Newton's method in intervals, with the
second derivatives of a whole part, stays inside of it, there is exactly one; other parts are divided. Feet at breaks
are not decided.
*/
template <int d>
class Foot_search
{
  using Candidate = Nearest_candidate<d>;
  using Part = Bernstein_part;

  static constexpr std::size_t most_parts = 600; // of a piece

  Part_stack m_parts;
  const Rounded_piece<d>*m_point = nullptr, *m_piece = nullptr;
  std::array<int, 2> m_cell{};
  bool m_is_rational = false, m_is_decided = false;
  std::size_t m_number_of_parts = 0;
  std::vector<Candidate> m_feet;

public:
  // Rounding has to be upward. Ends early where something is not decided.
  void find(const Point_operand<d>& point, const Rounded_spline<d>& spline)
  {
    m_feet.clear();
    m_number_of_parts = 0;
    m_is_decided = true;
    for (int i = 0; i < spline.number_of_cells(0); ++i)
      for (int j = 0; j < spline.number_of_cells(1) && m_is_decided; ++j)
        search(point.piece({0, 0}), spline.piece({i, j}), {i, j});
  }

  bool is_decided() const { return m_is_decided; }
  std::size_t number_of_parts() const { return m_number_of_parts; }
  // The point is the first operand.
  const std::vector<Candidate>& candidates() const { return m_feet; }

private:
  void search(const Rounded_piece<d>& point, const Rounded_piece<d>& piece, const std::array<int, 2>& cell)
  {
    m_point = &point;
    m_piece = &piece;
    m_cell = cell;
    const std::size_t size = size_of(piece.form_degrees), most = m_number_of_parts + most_parts;
    const Distance_form<d> form(point, piece, m_parts.begin(size), size);
    m_is_rational = form.is_rational;
    m_parts.push(form.degrees, piece.axes, m_is_rational ? 2 : 1, {form.error, form.weight_error},
                 {form.greatest, form.greatest_weight});
    for (m_is_decided = std::isfinite(form.greatest); !m_parts.empty() && m_is_decided;)
      if (is_settled())
        m_parts.pop();
      else if (++m_number_of_parts < most && m_parts.is_divisible())
        m_parts.divide(function().most_curved_axis());
      else
        m_is_decided = false;
  }

  Part_function function()
  {
    return {m_parts.top(), m_parts.coefficients(), m_is_rational ? m_parts.coefficients(1) : nullptr};
  }

  // Whether the last part has no foot, or one that is known.
  bool is_settled()
  {
    const Part& part = m_parts.top();
    const Interval value = function().value();
    std::array<Interval, 2> slopes{Interval(0), Interval(0)};
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0) {
        slopes[axis] = function().weighted_slope(axis, value);
        if (certain_sign(slopes[axis]) != 0)
          return true;
      }
    const Second_jet<Interval> second = function().second_derivatives(value, slopes);
    if (!is_regular(part, second))
      return false;
    const std::optional<Stationary_point<d>> point = stationary_point(function(), part, *m_point, *m_piece);
    if (!point)
      return false;
    const std::array<Double_range, 2> ranges = newton_ranges(*point, part, second);
    if (!are_inside(ranges, part))
      return false;
    add(*point, part, ranges);
    return true;
  }

  static bool is_regular(const Part& part, const Second_jet<Interval>& second)
  {
    if (part.sides[0] >= 0 || part.sides[1] >= 0)
      return certain_sign(second.second[part.sides[0] >= 0 ? 1 : 0]) != 0;
    return certain_sign(second.second[0] * second.second[1] - CGAL::square(second.mixed)) != 0;
  }

  static bool are_inside(const std::array<Double_range, 2>& ranges, const Part& part)
  {
    for (const int axis : {0, 1}) {
      const double margin = part_margin * part.width(axis);
      if (part.sides[axis] < 0 &&
          !(ranges[axis].lower > part.begin[axis] + margin && ranges[axis].upper < part.end[axis] - margin))
        return false;
    }
    return true;
  }

  void add(const Stationary_point<d>& point, const Part& part, const std::array<Double_range, 2>& ranges)
  {
    Candidate foot;
    foot.cells[1] = m_cell;
    foot.sides = part.sides;
    foot.points = point.distance.points;
    foot.ranges = ranges;
    foot.parameters = point.parameters;
    const Second_jet<Interval> jet = narrow_ranges(foot, function(), point, part);
    const double error = deviation(part, foot.ranges, point.parameters, jet);
    foot.squared_distance = point.distance.squared_distance + Interval(-error, error);
    foot.squared_distance =
        Interval((std::max)(foot.squared_distance.inf(), 0.0), (std::max)(foot.squared_distance.sup(), 0.0));
    m_is_decided = std::isfinite(foot.squared_distance.sup());
    m_feet.push_back(foot);
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_FOOT_SEARCH_H
