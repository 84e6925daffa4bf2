// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_PARTS_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Bernstein_net.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A range of the cells between breaks along an axis; of a single cell also a part of it, as a fraction, which may be
// one of its ends.
struct Axis_range
{
  int first = 0, last = 1;
  double begin = 0, end = 1;

  bool is_cell() const { return last - first == 1; }
  bool is_at_end() const { return begin == end; }
  bool has_first() const { return begin == 0; }   // the first break
  bool has_last() const { return end == 1; }
};

// A part of a patch, with bounds of its points; in a single cell also with bounds of the derivatives, by the place in
// the part.
template <int d>
struct Patch_part
{
  std::array<Axis_range, 2> ranges;
  std::optional<Bernstein_net<d>> net;   // none: several cells
  bool has_bounds = false;
  Double_intervals<d> corner, values;   // the point with the least parameters is known in a single cell
  std::array<Double_intervals<d>, 2> derivatives;
};

/*
The parts of a point, curve or surface: ranges of cells are bounded by the control points, single cells and their halves
by Bernstein coefficients.
*/
template <int d>
class Patch_parts
{
  using Part = Patch_part<d>;
  using Cell = std::array<int, 2>;

  Spline_patch<d> m_patch;
  std::vector<std::vector<Exact_rational>> m_breaks;
  std::array<std::vector<std::size_t>, 2> m_spans;   // the last control point of each cell along an axis
  std::vector<Double_intervals<d>> m_control_points;   // none: control points do not bound the cells
  mutable std::map<int, Spline_patch<d>> m_strips;
  mutable std::map<Cell, Part> m_cells;

public:
  explicit Patch_parts(const Spline_patch<d>& patch) : m_patch(patch)
  {
    for (int axis = 0; axis < patch.number_of_parameters(); ++axis)
      m_breaks.push_back(patch.breaks(axis));
    if (number_of_cells() > 1)
      set_control_points();
  }

  int number_of_axes() const { return m_patch.number_of_parameters(); }
  const std::vector<Exact_rational>& breaks(int axis) const { return m_breaks[axis]; }

  Part whole() const
  {
    std::array<Axis_range, 2> ranges;
    for (int axis = 0; axis < number_of_axes(); ++axis)
      ranges[axis].last = static_cast<int>(m_breaks[axis].size()) - 1;
    return part(ranges);
  }

  // The parts before and after the middle of an axis. \pre It is not one of the ends.
  std::array<Part, 2> halves(const Part& whole, int axis) const
  {
    std::array<std::array<Axis_range, 2>, 2> ranges{whole.ranges, whole.ranges};
    const Axis_range& range = whole.ranges[axis];
    if (!range.is_cell()) {
      ranges[0][axis].last = ranges[1][axis].first = (range.first + range.last) / 2;
      return {part(ranges[0]), part(ranges[1])};
    }
    ranges[0][axis].end = ranges[1][axis].begin = (range.begin + range.end) / 2;
    const std::array<Bernstein_net<d>, 2> nets = whole.net->halves(axis);
    return {part(ranges[0], nets[0]), part(ranges[1], nets[1])};
  }

  // The part at an end (0 or 1) of an axis. \pre A single cell.
  Part face(const Part& whole, int axis, int side) const
  {
    std::array<Axis_range, 2> ranges = whole.ranges;
    (side == 0 ? ranges[axis].end : ranges[axis].begin) = side == 0 ? ranges[axis].begin : ranges[axis].end;
    return part(ranges, whole.net->face(axis, side));
  }

  // The parameters of a part.
  Parameter_range parameters(const Part& part, int axis) const
  {
    const Axis_range& range = part.ranges[axis];
    const Exact_rational &first = m_breaks[axis][range.first], &last = m_breaks[axis][range.last];
    const auto at = [&](double x) {
      return x == 0 ? first : x == 1 ? last : Exact_rational(first + (last - first) * to_rational(x));
    };
    return {at(range.begin), at(range.end)};
  }

private:
  std::size_t number_of_cells() const
  {
    std::size_t result = 1;
    for (const auto& breaks : m_breaks)
      result *= breaks.size() - 1;
    return result;
  }

  // They bound cells if all functions have the same knots, and all weights are positive.
  void set_control_points()
  {
    const Upward_rounding_guard rounding;
    const Exact_function& first = m_patch.numerators()[0];
    const auto has_same_axes = [&](const Exact_function& f) { return f.axes() == first.axes(); };
    if (!std::all_of(m_patch.numerators().begin(), m_patch.numerators().end(), has_same_axes) ||
        (m_patch.is_rational() && !has_same_axes(m_patch.weight())))
      return;
    m_control_points.resize(first.coefficients().size());
    for (int i = 0; i < d; ++i)
      for (std::size_t k = 0; k < m_control_points.size(); ++k)
        m_control_points[k][i] = to_double_interval(m_patch.numerators()[i].coefficients()[k]);
    for (std::size_t k = 0; m_patch.is_rational() && k < m_control_points.size(); ++k) {
      const Double_interval weight = to_double_interval(m_patch.weight().coefficients()[k]);
      if (weight.inf() <= 0) {
        m_control_points.clear();
        return;
      }
      for (Double_interval& x : m_control_points[k])
        x = x / weight;
    }
    for (int axis = 0; axis < number_of_axes(); ++axis) {
      const std::vector<Exact_rational>& knots = first.knots(axis);
      std::size_t span = 0;
      for (std::size_t cell = 0; cell + 1 < m_breaks[axis].size(); ++cell) {
        while (knots[span + 1] <= m_breaks[axis][cell])
          ++span;
        m_spans[axis].push_back(span);
      }
    }
  }

  Part part(const std::array<Axis_range, 2>& ranges) const
  {
    if (!ranges[0].is_cell() || !ranges[1].is_cell())
      return cells(ranges);
    const Cell cell{ranges[0].first, ranges[1].first};
    auto known = m_cells.find(cell);
    if (known == m_cells.end())
      known = m_cells.emplace(cell, part(ranges, Bernstein_net<d>(patch_on(cell)))).first;
    return known->second;
  }

  // Of a surface by way of the strip of cells along the second axis, so that the other strips are looked at once only.
  Spline_patch<d> patch_on(const Cell& cell) const
  {
    if (number_of_axes() == 0)
      return m_patch;
    auto strip = m_strips.find(cell[0]);
    if (strip == m_strips.end())
      strip = m_strips.emplace(cell[0], m_patch.part(0, range_of(0, cell[0]))).first;
    return number_of_axes() == 1 ? strip->second : strip->second.part(1, range_of(1, cell[1]));
  }

  Parameter_range range_of(int axis, int cell) const { return {m_breaks[axis][cell], m_breaks[axis][cell + 1]}; }

  Part part(const std::array<Axis_range, 2>& ranges, const Bernstein_net<d>& net) const
  {
    Part result;
    result.ranges = ranges;
    result.net = net;
    result.has_bounds = net.has_bounds();
    if (result.has_bounds) {
      result.corner = net.corner();
      result.values = net.values();
      for (int axis = 0; axis < number_of_axes(); ++axis)
        result.derivatives[axis] = net.derivatives(axis, result.values);
    }
    return result;
  }

  // Several cells, by the control points that they depend on.
  Part cells(const std::array<Axis_range, 2>& ranges) const
  {
    Part result;
    result.ranges = ranges;
    result.has_bounds = !m_control_points.empty();
    if (!result.has_bounds)
      return result;
    std::array<std::size_t, 2> begin{0, 0}, end{1, 1};
    for (int axis = 0; axis < number_of_axes(); ++axis) {
      begin[axis] = m_spans[axis][ranges[axis].first] - static_cast<std::size_t>(m_patch.numerators()[0].degree(axis));
      end[axis] = m_spans[axis][ranges[axis].last - 1] + 1;
    }
    const std::size_t row = number_of_axes() == 2 ? m_patch.numerators()[0].size(1) : 1;
    result.values = m_control_points[begin[0] * row + begin[1]];
    for (std::size_t i = begin[0]; i < end[0]; ++i)
      for (std::size_t j = begin[1]; j < end[1]; ++j)
        result.values = hull_of(result.values, m_control_points[i * row + j]);
    return result;
  }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_PARTS_H
