// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_PAIR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_PAIR_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Parameter_box = std::vector<Parameter_range>;

// An end of the range of a parameter.
struct Parameter_end
{
  std::size_t parameter;
  bool is_upper;
  Exact_rational value;
};

// Two operands. Their parameters are numbered together, those of the first one before those of the second one.
template <int d>
class Patch_pair
{
  std::array<Spline_patch<d>, 2> m_patches;
  std::array<bool, 2> m_is_open{};

public:
  // An open operand is a part of a curve whose end belongs to the next part.
  Patch_pair(Spline_patch<d> first, Spline_patch<d> second, const std::array<bool, 2>& is_open = {})
    : m_patches{std::move(first), std::move(second)}, m_is_open(is_open)
  {}

  const Spline_patch<d>& operator[](std::size_t operand) const { return m_patches[operand]; }

  std::size_t number_of_parameters() const
  {
    return static_cast<std::size_t>(m_patches[0].number_of_parameters() + m_patches[1].number_of_parameters());
  }

  // The number of the first parameter of an operand.
  std::size_t first_parameter(std::size_t operand) const
  {
    return operand == 0 ? 0 : static_cast<std::size_t>(m_patches[0].number_of_parameters());
  }

  Parameter_box domain() const
  {
    Parameter_box result;
    for (const Spline_patch<d>& patch : m_patches)
      for (int axis = 0; axis < patch.number_of_parameters(); ++axis)
        result.push_back(patch.domain(axis));
    return result;
  }

  std::vector<Parameter_end> ends() const
  {
    const Parameter_box ranges = domain();
    std::vector<Parameter_end> result;
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      result.push_back({j, false, ranges[j].first});
      result.push_back({j, true, ranges[j].second});
    }
    return result;
  }

  // The operand that a parameter belongs to.
  std::size_t operand_of(std::size_t parameter) const { return parameter < first_parameter(1) ? 0 : 1; }

  // The number of a parameter on its operand.
  int axis_of(std::size_t parameter) const
  {
    return static_cast<int>(parameter - first_parameter(operand_of(parameter)));
  }

  // Whether the points at the upper end of a parameter are found elsewhere: at the lower end of a closed operand, or on
  // the next part of a curve.
  bool is_repeated_at_end(std::size_t parameter) const
  {
    const std::size_t operand = operand_of(parameter);
    return m_is_open[operand] || m_patches[operand].is_closed(axis_of(parameter));
  }

  // The point that an edge of a surface consists of, if it is a pole.
  std::optional<Spline_patch<d>> pole(const Parameter_end& end) const
  {
    const Spline_patch<d>& surface = m_patches[operand_of(end.parameter)];
    if (surface.number_of_parameters() < 2)
      return std::nullopt;
    const auto point = surface.pole(axis_of(end.parameter), end.value);
    return point ? std::optional(Spline_patch<d>(*point)) : std::nullopt;
  }

  // With the parameters in these ranges. Those whose range is one number are parameters no more.
  Patch_pair part(const Parameter_box& box) const
  {
    const auto split = box.begin() + static_cast<std::ptrdiff_t>(first_parameter(1));
    return {m_patches[0].part(Parameter_box(box.begin(), split)), m_patches[1].part(Parameter_box(split, box.end()))};
  }

  // The part of a box where a parameter is at an end.
  Patch_pair at(const Parameter_end& end, Parameter_box box) const
  {
    box[end.parameter] = {end.value, end.value};
    return part(box);
  }

  // With another operand in the place of one.
  Patch_pair with(std::size_t operand, Spline_patch<d> patch) const
  {
    Patch_pair result(*this);
    result.m_patches[operand] = std::move(patch);
    return result;
  }
};

Parameter_box clipped(Parameter_box box, const Parameter_box& domain);

// A box that holds another one and has ends of about 256 digits: those around irrational roots may have thousands,
// which enclosures of points do not need.
Parameter_box with_short_ends(Parameter_box box);

inline bool has_interior(const Parameter_box& box)
{
  return std::all_of(box.begin(), box.end(), [](const Parameter_range& range) { return range.first < range.second; });
}

// Whether it is more than one point.
inline bool has_extent(const Parameter_box& box)
{
  return std::any_of(box.begin(), box.end(), [](const Parameter_range& range) { return range.first < range.second; });
}

bool have_common_part(const Parameter_box& a, const Parameter_box& b);

// A box of parameters, without the upper ends of some of its ranges.
struct Parameter_region
{
  Parameter_box box;
  std::vector<bool> is_open;
};

// A region without a box, in parts that have no common points. Of the boundary of the box, parts may be left.
std::vector<Parameter_region> without(Parameter_region region, const Parameter_box& hole);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template class Patch_pair<2>;
extern template class Patch_pair<3>;
#endif

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Parameter_box clipped(Parameter_box box, const Parameter_box& domain)
{
  for (std::size_t j = 0; j < box.size(); ++j) {
    box[j].first = (std::max)(box[j].first, domain[j].first);
    box[j].second = (std::min)(box[j].second, domain[j].second);
  }
  return box;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Parameter_box with_short_ends(Parameter_box box)
{
  constexpr int digits = 256;
  const auto outwards = [](const Exact_rational& end, int direction) {
    const Exact_rational rounded = round_to_dyadic(end, digits), error(CGAL::abs(Exact_rational(rounded - end)));
    return error == 0 ? end : Exact_rational(rounded + direction * round_to_dyadic(Exact_rational(2 * error), 1));
  };
  for (Parameter_range& range : box)
    if (range.first < range.second)
      range = {outwards(range.first, -1), outwards(range.second, 1)};
  return box;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool have_common_part(const Parameter_box& a, const Parameter_box& b)
{
  for (std::size_t j = 0; j < a.size(); ++j)
    if (a[j].second < b[j].first || b[j].second < a[j].first)
      return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Parameter_region> without(Parameter_region region, const Parameter_box& hole)
{
  const Parameter_box common = clipped(hole, region.box);
  if (!has_interior(common))
    return {region};
  std::vector<Parameter_region> result;
  for (std::size_t j = 0; j < common.size(); ++j) {
    const Parameter_range whole = region.box[j];
    const bool is_open = region.is_open[j];
    if (whole.first < common[j].first) {
      region.box[j].second = common[j].first;
      region.is_open[j] = true;
      result.push_back(region);
    }
    if (common[j].second < whole.second) {
      region.box[j] = {common[j].second, whole.second};
      region.is_open[j] = is_open;
      result.push_back(region);
    }
    region.box[j] = common[j];
    region.is_open[j] = is_open || common[j].second < whole.second;
  }
  return result;
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_PAIR_H
