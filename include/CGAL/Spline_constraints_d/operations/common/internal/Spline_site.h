// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_SITE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_SITE_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A point or vector that depends on none, one or two unknowns.
template <int d>
class Parametric_vector
{
  std::variant<std::array<Exact_rational, d>, Spline_map<1, d>, Spline_map<2, d>> m_map;

public:
  explicit Parametric_vector(const Vector_of_functions<d>& coordinates) : m_map(constant(coordinates))
  {
    if (coordinates[0].dimension() == 1)
      m_map = Spline_map<1, d>(coordinates);
    else if (coordinates[0].dimension() == 2)
      m_map = Spline_map<2, d>(coordinates);
  }

  explicit Parametric_vector(const Spline_patch<d>& patch) : Parametric_vector(patch.numerators())
  {
    if (!patch.is_rational())
      return;
    if (patch.number_of_parameters() == 0)
      m_map = patch({});
    else if (patch.number_of_parameters() == 1)
      m_map = Spline_map<1, d>(patch.numerators(), patch.weight());
    else
      m_map = Spline_map<2, d>(patch.numerators(), patch.weight());
  }

  Vector_expression<d> operator()(std::span<const Unknown> u) const
  {
    if (u.empty())
      return vector_of<d>([&](std::size_t i) { return Expression(std::get<0>(m_map)[i]); });
    return u.size() == 1 ? std::get<1>(m_map)(u[0]) : std::get<2>(m_map)(u[0], u[1]);
  }

  //! \pre There is such a parameter.
  Parametric_vector tangent(int axis) const
  {
    Parametric_vector result(*this);
    if (m_map.index() == 1)
      result.m_map = derivative(std::get<1>(m_map));
    else
      result.m_map = derivative(std::get<2>(m_map), axis);
    return result;
  }

private:
  static std::array<Exact_rational, d> constant(const Vector_of_functions<d>& coordinates)
  {
    std::array<Exact_rational, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = coordinates[i].coefficients().front();
    return result;
  }
};

// What is asked of the inner products <own point - other point, tangent> where the tangent jumps, with the tangents
// before and after the jump.
struct Joint_rule
{
  Relation before, after;
  bool has_open_ends;   // whether the ends of an open axis are sites; they have a tangent on one side only
};

// The distance to the other point is least at the joint, and its derivative is not zero on the side of a piece that
// contains the joint: that is the one after it, or the only one.
inline constexpr Joint_rule least_distance{Relation::LESS_EQUAL, Relation::GREATER, true};

// The derivative of the distance is zero on the side before only, whose piece does not contain the joint.
inline constexpr Joint_rule perpendicular_before{Relation::EQUAL, Relation::NOT_EQUAL, false};

// A part of the axis of a parameter: a range without jumps of the tangent, or one number, with the neighbouring ranges
// between breaks on both sides, if any.
struct Axis_part
{
  Parameter_range range;
  bool is_without_end = false;
  std::optional<Parameter_range> before = {}, after = {};
};

// Whether one vector is the other one times a positive constant.
template <int d>
bool have_same_direction(const Vector_of_functions<d>& a, const Vector_of_functions<d>& b)
{
  std::vector<Exact_rational> middle;
  for (int axis = 0; axis < a[0].dimension(); ++axis)
    middle.push_back(middle_of(a[0].domain(axis)));
  for (int i = 0; i < d; ++i)
    if (const Exact_rational value = b[i](middle); value != 0) {
      const Exact_rational ratio(a[i](middle) / value);
      return ratio > 0 &&
          std::equal(a.begin(), a.end(), b.begin(),
                     [&](const Exact_function& x, const Exact_function& y) { return x == y * ratio; });
    }
  return a == b;
}

// The parts of an axis: pieces between jumps of the tangent, without their upper end if another part follows; jumps;
// and ends. The seam of a closed axis is a joint like others.
template <int d>
std::vector<Axis_part> parts_of(const Spline_patch<d>& patch, int axis, const Joint_rule& rule)
{
  const std::vector<Exact_rational> breaks = patch.breaks(axis);
  const auto cell = [&](std::size_t i) { return Parameter_range(breaks[i], breaks[i + 1]); };
  const auto at = [&](std::size_t i) { return Parameter_range(breaks[i], breaks[i]); };
  const std::size_t last = breaks.size() - 2;
  std::vector<Axis_part> result;
  const std::vector<Exact_rational> kinks = patch.possible_kinks(axis);
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    if (!std::binary_search(kinks.begin(), kinks.end(), breaks[i]))
      continue;
    const Vector_of_functions<d> before = patch.one_sided_tangent(axis, cell(i - 1), 1),
                                 after = patch.one_sided_tangent(axis, cell(i), 0);
    if (before == after)
      continue;
    result.push_back({{breaks[begin], breaks[i]}, true});
    if (!have_same_direction<d>(before, after))
      result.push_back({at(i), false, cell(i - 1), cell(i)});
    begin = i;
  }
  const bool is_closed = patch.is_closed(axis);
  result.push_back({{breaks[begin], breaks.back()}, is_closed});
  if (is_closed) {
    if (!have_same_direction<d>(patch.one_sided_tangent(axis, cell(last), 1),
                                patch.one_sided_tangent(axis, cell(0), 0)))
      result.push_back({at(0), false, cell(last), cell(0)});
  } else if (rule.has_open_ends) {
    result.push_back({at(0), false, std::nullopt, cell(0)});
    result.push_back({at(last + 1), false, cell(last), std::nullopt});
  }
  return result;
}

/*
A smooth piece of a point, curve or surface, an edge of one, or a corner: the points with parameters in a product of
parts of the axes. What takes time is computed when it is asked for: many sites are too far away.
*/
template <int d>
class Spline_site
{
  struct Slope
  {
    Parametric_vector<d> tangent;
    Relation relation;
  };

  struct Formulas
  {
    Parametric_vector<d> point;
    std::vector<Slope> slopes;
  };

  std::vector<Axis_part> m_parts;
  Joint_rule m_rule;
  Spline_patch<d> m_whole, m_patch;
  Vector_bounds<d> m_bounds;
  std::vector<int> m_free_axes;
  mutable std::optional<Formulas> m_formulas;

public:
  Spline_site(const Spline_patch<d>& whole, std::vector<Axis_part> parts, const Joint_rule& rule)
    : m_parts(std::move(parts)), m_rule(rule), m_whole(whole), m_patch(whole.part(ranges())), m_bounds(m_patch.values())
  {
    if (m_patch.number_of_parameters() == 1 && m_patch.is_one_point())
      m_patch = m_patch.part({at_begin(m_patch.domain(0))});
    else
      for (std::size_t axis = 0; axis < m_parts.size(); ++axis)
        if (m_parts[axis].range.first < m_parts[axis].range.second)
          m_free_axes.push_back(static_cast<int>(axis));
  }

  // Of all parameters; those that are fixed at a joint have a range of one number.
  std::vector<Parameter_range> ranges() const
  {
    std::vector<Parameter_range> result;
    for (const Axis_part& part : m_parts)
      result.push_back(part.range);
    return result;
  }

  // The site as a patch of the parameters that it depends on.
  const Spline_patch<d>& patch() const { return m_patch; }

  // Bounds of the points.
  const Vector_bounds<d>& bounds() const { return m_bounds; }

  // The parameters that it depends on.
  const std::vector<int>& free_axes() const { return m_free_axes; }

  Vector_expression<d> point(std::span<const Unknown> u) const { return formulas().point(u); }

  // What the rule asks of the point with these parameters and another one.
  void add_constraints(std::span<const Unknown> u, const Vector_expression<d>& other,
                       std::vector<Constraint>& constraints) const
  {
    const Vector_expression<d> offset = point(u) - other;
    for (const Slope& slope : formulas().slopes)
      constraints.push_back(compared_with_zero(dot(offset, slope.tangent(u)), slope.relation));
    for (std::size_t i = 0; i < u.size(); ++i)
      if (const Axis_part& part = m_parts[m_free_axes[i]]; part.is_without_end)
        constraints.push_back(u[i] < part.range.second);
  }

private:
  static Parameter_range at_begin(const Parameter_range& range) { return {range.first, range.first}; }

  const Formulas& formulas() const
  {
    if (!m_formulas)
      m_formulas = Formulas{Parametric_vector<d>(m_patch), slopes()};
    return *m_formulas;
  }

  std::vector<Slope> slopes() const
  {
    std::vector<Slope> result;
    const Parametric_vector<d> point(m_patch);
    for (std::size_t i = 0; i < m_free_axes.size(); ++i)
      result.push_back({point.tangent(static_cast<int>(i)), Relation::EQUAL});
    for (std::size_t axis = 0; axis < m_parts.size(); ++axis) {
      if (const auto& before = m_parts[axis].before)
        add_slopes(axis, *before, 1,
                   m_rule.before == Relation::LESS_EQUAL && !m_parts[axis].after ? Relation::LESS : m_rule.before,
                   result);
      if (const auto& after = m_parts[axis].after)
        add_slopes(axis, *after, 0, m_rule.after, result);
    }
    return result;
  }

  // An edge that is one point, such as the pole of a sphere, is a corner with many tangents. Where one of them is
  // orthogonal, that is a solution on the pieces that end there; so they are asked for signs, a few of them.
  void add_slopes(std::size_t axis, const Parameter_range& cell, int side, Relation relation,
                  std::vector<Slope>& slopes) const
  {
    const Vector_of_functions<d> tangent = m_whole.one_sided_tangent(static_cast<int>(axis), cell, side);
    if (m_parts.size() == 1)
      slopes.push_back({Parametric_vector<d>(tangent), relation});
    else if (const Axis_part& other = m_parts[1 - axis];
             m_free_axes.empty() && other.range.first < other.range.second) {
      for (const Exact_rational& at : tangent[0].breaks(0))
        if (other.range.first <= at && at <= other.range.second)
          slopes.push_back({Parametric_vector<d>(part_of<d>(tangent, 0, {at, at})), relation});
    } else
      slopes.push_back({Parametric_vector<d>(part_of<d>(tangent, 0, other.range)), relation});
  }

  static Constraint compared_with_zero(const Expression& a, Relation relation)
  {
    Constraint result = a == 0;   // tangents have no divisors, and weights are positive
    result.relation = relation;
    return result;
  }
};

// The parts of each axis.
template <int d>
std::vector<std::vector<Axis_part>> parts_of_axes(const Spline_patch<d>& patch, const Joint_rule& rule)
{
  std::vector<std::vector<Axis_part>> result;
  for (int axis = 0; axis < patch.number_of_parameters(); ++axis)
    result.push_back(parts_of(patch, axis, rule));
  return result;
}

// What a range of the parameter has of the parts of an axis.
inline std::vector<Axis_part> parts_within(const std::vector<Axis_part>& parts, const Parameter_range& range)
{
  std::vector<Axis_part> result;
  for (Axis_part part : parts) {
    const auto [begin, end] = part.range;
    part.range = {(std::max)(begin, range.first), (std::min)(end, range.second)};
    part.is_without_end = part.is_without_end && part.range.second == end;
    if (part.range.first < part.range.second || (begin == end && part.range.first == part.range.second))
      result.push_back(std::move(part));
  }
  return result;
}

// All sites of a point, curve or surface with these parts of its axes, those of fewest parameters first.
template <int d>
std::vector<Spline_site<d>> sites_of(const Spline_patch<d>& patch, const std::vector<std::vector<Axis_part>>& axes,
                                     const Joint_rule& rule)
{
  std::vector<std::vector<Axis_part>> products(1);
  for (const std::vector<Axis_part>& parts : axes) {
    std::vector<std::vector<Axis_part>> longer;
    for (const Axis_part& part : parts)
      for (std::vector<Axis_part> product : products) {
        product.push_back(part);
        longer.push_back(std::move(product));
      }
    products = std::move(longer);
  }
  std::vector<Spline_site<d>> result;
  result.reserve(products.size());
  for (std::vector<Axis_part>& product : products)
    result.emplace_back(patch, std::move(product), rule);
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.free_axes().size() < b.free_axes().size(); });
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_SITE_H
