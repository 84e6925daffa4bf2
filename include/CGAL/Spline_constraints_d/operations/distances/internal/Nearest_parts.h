// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAREST_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAREST_PARTS_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// For each axis of an operand the breaks at which nearest points may be though the derivative of the distance is not
// zero on either side.
using Joints = std::vector<std::vector<bool>>;

/*
Where two operands may be nearest to each other, by branch and bound in intervals of doubles: pairs of parts, which hold
all pairs of nearest points.

A pair of parts is left out if its points are farther from each other than two points that are known; or if the distance
is monotone along an axis, unless it decreases towards a joint: then only the face there is kept.
*/
template <int d>
class Nearest_parts
{
  using Part = Patch_part<d>;

  struct Pair
  {
    std::array<Part, 2> parts;
    double lower = 0;   // bound of the squared distances
  };

  static constexpr std::size_t most_pairs = 512;
  static constexpr double least_width = 0x1p-6;   // of a part of a cell

  std::array<Patch_parts<d>, 2> m_operands;
  std::array<Joints, 2> m_joints;
  double m_upper;   // bound of the least squared distance
  std::vector<Pair> m_pairs;

public:
  // With the squared distance of some points. Before each pair `check()` may end the work by an exception.
  template <class Check>
  Nearest_parts(const Spline_patch<d>& a, const Spline_patch<d>& b, std::array<Joints, 2> joints,
                const Exact_rational& known, const Check& check)
    : m_operands{Patch_parts<d>(a), Patch_parts<d>(b)}, m_joints(std::move(joints)),
      m_upper(to_double_interval(known).second)
  {
    const Upward_rounding_guard rounding;
    add(m_pairs, {m_operands[0].whole(), m_operands[1].whole()});
    bool is_divided = true;
    while (is_divided && m_pairs.size() <= most_pairs && !are_settled()) {
      is_divided = false;
      std::vector<Pair> pairs;
      for (Pair& pair : m_pairs) {
        check();
        is_divided = divide(pair, pairs) || is_divided;
      }
      m_pairs = std::move(pairs);
      std::erase_if(m_pairs, [&](const Pair& pair) { return pair.lower > m_upper; });
    }
  }

  // No pair of nearest points has a larger squared distance.
  double upper() const { return m_upper; }

  // The boxes of parameters, those of the first operand first. A range that is one number is a joint at which the
  // derivative is not zero.
  std::vector<std::vector<Parameter_range>> boxes() const
  {
    return ranges_of_pairs(
        [&](const Part& part, std::size_t operand, int axis) { return m_operands[operand].parameters(part, axis); });
  }

  // The same with ranges from break to break.
  std::vector<std::vector<Parameter_range>> boxes_of_cells() const
  {
    return ranges_of_pairs([&](const Part& part, std::size_t operand, int axis) {
      const std::vector<Exact_rational>& breaks = m_operands[operand].breaks(axis);
      return Parameter_range(breaks[part.ranges[axis].first], breaks[part.ranges[axis].last]);
    });
  }

private:
  template <class Range_of>
  std::vector<std::vector<Parameter_range>> ranges_of_pairs(const Range_of& range_of) const
  {
    std::vector<std::vector<Parameter_range>> result;
    for (const Pair& pair : m_pairs) {
      result.emplace_back();
      for (const std::size_t operand : {0, 1})
        for (int axis = 0; axis < m_operands[operand].number_of_axes(); ++axis)
          result.back().push_back(range_of(pair.parts[operand], operand, axis));
    }
    return result;
  }

  void add(std::vector<Pair>& pairs, std::array<Part, 2> parts)
  {
    Pair pair{std::move(parts)};
    if (!bound(pair))
      return;
    pairs.push_back(std::move(pair));
  }

  // Whether nearest points may be there. The pair becomes a face of it where all of them are.
  bool bound(Pair& pair)
  {
    const auto& [a, b] = pair.parts;
    if (!a.has_bounds || !b.has_bounds)
      return true;
    const Double_intervals<d> offset = a.values - b.values;
    const Double_interval whole = squared_norm(offset);
    m_upper = (std::min)(m_upper, whole.sup());
    pair.lower = whole.inf();
    if (!a.net || !b.net || pair.lower > m_upper)
      return pair.lower <= m_upper;
    Double_interval by_slopes = squared_norm(a.corner - b.corner);
    m_upper = (std::min)(m_upper, by_slopes.sup());
    for (const std::size_t operand : {0, 1})
      for (int axis = 0; axis < m_operands[operand].number_of_axes(); ++axis) {
        const Double_interval half_slope =
            (operand == 0 ? 1.0 : -1.0) * dot(offset, pair.parts[operand].derivatives[axis]);
        if (half_slope.inf() > 0 || half_slope.sup() < 0)
          return is_joint(pair.parts[operand], operand, axis, half_slope.inf() > 0 ? 0 : 1) &&
              bound_face(pair, operand, axis, half_slope.inf() > 0 ? 0 : 1);
        by_slopes = by_slopes + 2.0 * half_slope * Double_interval(0, 1);
      }
    pair.lower = (std::max)(pair.lower, by_slopes.inf());
    return pair.lower <= m_upper;
  }

  bool bound_face(Pair& pair, std::size_t operand, int axis, int side)
  {
    pair.parts[operand] = m_operands[operand].face(pair.parts[operand], axis, side);
    return bound(pair);
  }

  // Whether an end (0 or 1) of a part of a cell is one.
  bool is_joint(const Part& part, std::size_t operand, int axis, int side) const
  {
    const Axis_range& range = part.ranges[axis];
    return side == 0 ? range.has_first() && m_joints[operand][axis][range.first]
                     : range.has_last() && m_joints[operand][axis][range.last];
  }

  // Adds the halves along the axis where there are most cells, or which is longest; or the pair itself if all are
  // short. Returns whether it has been divided.
  bool divide(Pair& pair, std::vector<Pair>& pairs)
  {
    if (pair.lower > m_upper)
      return false;
    double longest = 0;
    std::size_t operand = 0;
    int axis = 0;
    for (const std::size_t i : {0, 1})
      for (int j = 0; j < m_operands[i].number_of_axes(); ++j)
        if (const double length = length_of(pair.parts[i], j); length > longest) {
          longest = length;
          operand = i;
          axis = j;
        }
    if (longest == 0) {
      pairs.push_back(std::move(pair));
      return false;
    }
    for (Part& half : m_operands[operand].halves(pair.parts[operand], axis)) {
      Pair next(pair);
      next.parts[operand] = std::move(half);
      add(pairs, std::move(next.parts));
    }
    return true;
  }

  // Ranges of several cells are longer than any cell.
  static double length_of(const Part& part, int axis)
  {
    const Axis_range& range = part.ranges[axis];
    if (!range.is_cell())
      return (std::numeric_limits<double>::max)() * (1 - 1.0 / (range.last - range.first));
    if (!part.net || range.end - range.begin <= least_width)
      return 0;
    double result = range.end - range.begin;
    for (const Double_interval& x : part.derivatives[axis])
      result = part.has_bounds ? (std::max)(result, (std::max)(-x.inf(), x.sup())) : result;
    return result;
  }

  // Whether what remains is in one pair of cells, away from joints or at them.
  bool are_settled() const
  {
    return std::all_of(m_pairs.begin(), m_pairs.end(), [&](const Pair& pair) {
      bool result = true;
      for (const std::size_t operand : {0, 1})
        for (int axis = 0; axis < m_operands[operand].number_of_axes(); ++axis) {
          const Part& part = pair.parts[operand];
          const Axis_range &range = part.ranges[axis], &other = m_pairs.front().parts[operand].ranges[axis];
          result = result && range.is_cell() && range.first == other.first && range.last == other.last &&
                   (range.is_at_end() || (!is_joint(part, operand, axis, 0) && !is_joint(part, operand, axis, 1)));
        }
      return result;
    });
  }
};

// Boxes without common points, each around some of the given ones, which are in exactly one of them.
inline std::vector<std::vector<Parameter_range>> separate_hulls(const std::vector<std::vector<Parameter_range>>& boxes)
{
  const auto meet = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](const Parameter_range& x, const Parameter_range& y) {
      return x.first <= y.second && y.first <= x.second;
    });
  };
  std::vector<std::vector<Parameter_range>> result;
  for (std::vector<Parameter_range> box : boxes) {
    for (auto other = std::find_if(result.begin(), result.end(), [&](const auto& x) { return meet(x, box); });
         other != result.end();
         other = std::find_if(result.begin(), result.end(), [&](const auto& x) { return meet(x, box); })) {
      for (std::size_t i = 0; i < box.size(); ++i)
        box[i] = {(std::min)(box[i].first, (*other)[i].first), (std::max)(box[i].second, (*other)[i].second)};
      result.erase(other);
    }
    result.push_back(std::move(box));
  }
  return result;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAREST_PARTS_H
