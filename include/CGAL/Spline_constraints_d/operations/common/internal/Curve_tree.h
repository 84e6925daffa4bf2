// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVE_TREE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVE_TREE_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Bernstein_net.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// a + t b
template <std::size_t d>
std::array<Double_interval, d> moved_along(const std::array<Double_interval, d>& a, const Double_interval& t,
                                           const std::array<Double_interval, d>& b)
{
  std::array<Double_interval, d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = a[i] + t * b[i];
  return result;
}

inline Double_interval rounded(const Rational_interval& x)
{
  return {to_double_interval(x.lower).first, to_double_interval(x.upper).second};
}

/*
A part of a curve with bounds of its points and derivatives, and the smaller parts that it consists of, which are made
when they are asked for: of the whole curve the pieces between breaks, with exact bounds; of these their halves, and so
on, in intervals.
*/
template <int d>
class Curve_tree
{
  Parameter_range m_range;
  Exact_rational m_middle;
  Double_interval m_width;
  std::shared_ptr<const Spline_patch<d>> m_patch;   // of the whole curve only
  int m_level = 0;
  std::optional<Bernstein_net<d>> m_net;   // of a part of a piece only
  Double_intervals<d> m_middle_point, m_values, m_tangents;
  mutable std::vector<Curve_tree> m_children;

public:
  explicit Curve_tree(const Spline_patch<d>& curve) : Curve_tree(curve, curve.domain(0))
  {
    m_patch = std::make_shared<const Spline_patch<d>>(curve);
  }

  const Spline_patch<d>& patch() const { return *m_patch; }
  const Parameter_range& range() const { return m_range; }
  const Exact_rational& middle() const { return m_middle; }
  const Double_intervals<d>& middle_point() const { return m_middle_point; }
  const Double_intervals<d>& tangents() const { return m_tangents; }
  double radius() const { return (m_width / 2.0).sup(); }

  // Whether rounding may keep the bounds of smaller parts from being better.
  bool is_tiny() const { return m_level > 44; }

  // The differences of parameters from the middle.
  Double_interval steps() const { return {-radius(), radius()}; }

  const std::vector<Curve_tree>& children() const
  {
    if (m_children.empty() && m_patch != nullptr)
      add_pieces();
    else if (m_children.empty())
      add_halves();
    return m_children;
  }

  // Bounds of the squared distances of the points from another one, by the mean value theorem.
  Double_interval squared_distance_bounds(const Double_intervals<d>& point) const
  {
    const Double_intervals<d> offset = m_values - point;
    const Double_interval direct = squared_norm(offset),
                          by_slopes = squared_norm(m_middle_point - point) + 2.0 * dot(offset, m_tangents) * steps();
    return {(std::max)(direct.inf(), by_slopes.inf()), (std::min)(direct.sup(), by_slopes.sup())};
  }

  // Bounds of the derivative where the parameter is in a range that meets this part, from parts that are not much
  // longer.
  Double_intervals<d> tangents_over(const Parameter_range& range) const
  {
    if ((range.first <= m_range.first && m_range.second <= range.second) ||
        m_range.second - m_range.first <= range.second - range.first)
      return m_tangents;
    std::optional<Double_intervals<d>> result;
    for (const Curve_tree& child : children())
      if (child.m_range.first <= range.second && range.first <= child.m_range.second) {
        const Double_intervals<d> part = child.tangents_over(range);
        for (std::size_t i = 0; result && i < d; ++i)
          (*result)[i] = hull_of((*result)[i], part[i]);
        if (!result)
          result = part;
      }
    return *result;
  }

  // About how fast the point of this curve that is nearest to a point of another one moves when that does, <A', B'> /
  // <B', B'>: any number will do.
  double speed_along(const Curve_tree& other) const
  {
    const auto middle = [](const Double_interval& x) { return (x.inf() + x.sup()) / 2; };
    double product = 0, square = 0;
    for (std::size_t i = 0; i < d; ++i) {
      product += middle(m_tangents[i]) * middle(other.m_tangents[i]);
      square += middle(m_tangents[i]) * middle(m_tangents[i]);
    }
    const float speed = static_cast<float>(product / square);   // short, so that products are
    return std::isfinite(speed) ? speed : 0;
  }

private:
  // The whole curve, or a piece of it.
  Curve_tree(const Spline_patch<d>& patch, const Parameter_range& range)
    : m_range(range), m_middle(middle_of(range)),
      m_width(to_double_interval(Exact_rational(range.second - range.first)))
  {
    const std::array<Exact_rational, d> point = patch(patch.middle());
    const Vector_bounds<d> values = patch.values(), tangents = patch.tangents(0);
    for (std::size_t i = 0; i < d; ++i) {
      m_middle_point[i] = to_double_interval(point[i]);
      m_values[i] = rounded(values[i]);
      m_tangents[i] = rounded(tangents[i]);
    }
  }

  void add_pieces() const
  {
    const std::vector<Exact_rational> breaks = m_patch->breaks(0);
    for (std::size_t k = 1; k < breaks.size(); ++k) {
      const Parameter_range range(breaks[k - 1], breaks[k]);
      const Spline_patch<d> piece = m_patch->part(0, range);
      m_children.push_back(Curve_tree(piece, range));
      m_children.back().m_net = Bernstein_net<d>(piece);
    }
  }

  void add_halves() const
  {
    const Curve_tree whole(*this);
    std::array<Bernstein_net<d>, 2> halves = m_net->halves(0);
    for (const int side : {0, 1}) {
      Curve_tree& half = m_children.emplace_back(whole);
      (side == 0 ? half.m_range.second : half.m_range.first) = m_middle;
      half.m_net = std::move(halves[side]);
      half.improve_bounds();
    }
  }

  // The bounds of a half of what they were for; they remain where the weights do not show that they are positive.
  void improve_bounds()
  {
    m_middle = middle_of(m_range);
    m_width = 0.5 * m_width;
    ++m_level;
    if (!m_net->has_bounds()) {
      m_middle_point = m_values;
      return;
    }
    m_middle_point = m_net->halves(0)[1].corner();
    m_values = m_net->values();
    m_tangents = m_net->derivatives(0, m_values);
    for (Double_interval& x : m_tangents)
      x = x / m_width;
  }
};

// Whether sqrt(upper) - sqrt(lower), which is at most (upper - lower) / sqrt(upper), is proved to be at most a
// tolerance.
inline bool roots_are_within(double lower, double upper, double tolerance)
{
  if (upper <= lower)
    return true;
  const Double_interval difference = Double_interval(upper) - Double_interval(lower);
  return square(difference).sup() <= (square(Double_interval(tolerance)) * Double_interval(upper)).inf();
}

// A point of a curve that is about as near as any to some point: the middle of a part. And a lower bound of the squared
// distance of that one from the curve.
template <int d>
struct Nearest_point
{
  double lower;
  const Curve_tree<d>* node;
};

// By branch and bound, until the distance is known up to a tolerance, or the part that may be nearest is tiny.
template <int d>
Nearest_point<d> nearest_point(const Curve_tree<d>& curve, const Double_intervals<d>& point, double tolerance)
{
  struct Task
  {
    const Curve_tree<d>* node;
    double lower;
  };
  const auto is_farther = [](const Task& p, const Task& q) { return p.lower > q.lower; };
  std::vector<Task> tasks;
  const Curve_tree<d>* nearest = &curve;
  double upper = squared_norm(curve.middle_point() - point).sup();
  const auto push = [&](const Curve_tree<d>& node) {
    if (const double at_middle = squared_norm(node.middle_point() - point).sup(); at_middle < upper) {
      upper = at_middle;
      nearest = &node;
    }
    tasks.push_back({&node, node.squared_distance_bounds(point).inf()});
    std::push_heap(tasks.begin(), tasks.end(), is_farther);
  };
  push(curve);
  while (!roots_are_within(tasks.front().lower, upper, tolerance) && !tasks.front().node->is_tiny()) {
    std::pop_heap(tasks.begin(), tasks.end(), is_farther);
    const Curve_tree<d>* node = tasks.back().node;
    tasks.pop_back();
    for (const Curve_tree<d>& child : node->children())
      push(child);
  }
  return {(std::min)(tasks.front().lower, upper), nearest};
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVE_TREE_H
