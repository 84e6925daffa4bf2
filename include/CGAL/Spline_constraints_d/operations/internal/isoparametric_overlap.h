// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_ISOPARAMETRIC_OVERLAP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_ISOPARAMETRIC_OVERLAP_H

#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/internal/Overlap_ends.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A curve that runs along a line of a surface where one parameter is constant and the other one is affine in that of the curve: C(t) = S(c, a t + b), or the other way round.

The parameters on the surface of two points of the curve give c, a and b. They need not be proved: whether the functions are the same is decided exactly.
*/
class Isoparametric_curve
{
  using Point = std::array<Exact_rational, 2>;

  Spline_patch<3> m_curve, m_surface;
  Summing_solver& m_solve;

public:
  // The range of the parameter of the curve, and those of the surface.
  struct Overlap
  {
    Parameter_range curve;
    Parameter_box surface;
  };

  Isoparametric_curve(Spline_patch<3> curve, Spline_patch<3> surface, Summing_solver& solve) : m_curve(std::move(curve)), m_surface(std::move(surface)), m_solve(solve) {}

  // From two points with parameters in a range.
  std::optional<Overlap> operator()(const Parameter_range& range) const
  {
    const auto between = [&](int from, int to) {   // simple, so that the parameters on the surface are
      const auto part = [&](int k) { return Exact_rational(range.first + (range.second - range.first) * k / 8); };
      return simplest_rational_between(part(from), part(to));
    };
    const std::array<Exact_rational, 2> at{between(2, 3), between(5, 6)};
    const std::vector<Point> first = points_on_surface(at[0]), second = first.empty() ? first : points_on_surface(at[1]);
    for (const Point& p : first)
      for (const Point& q : second)
        for (const int axis : {0, 1})
          if (p[axis] == q[axis] && p[1 - axis] != q[1 - axis])
            if (const auto overlap = along(axis, p, Exact_rational((q[1 - axis] - p[1 - axis]) / (at[1] - at[0])), at[0]))
              return overlap;
    return std::nullopt;
  }

private:
  // The simplest parameters in the ranges that are found.
  std::vector<Point> points_on_surface(const Exact_rational& t) const
  {
    const Spline_patch<3> point(m_curve(std::array<Exact_rational, 1>{t}));
    std::vector<Point> result;
    for (const Common_point& found : Intersection_finder<3>(Patch_pair<3>(point, m_surface), m_solve)())
      result.push_back({simplest_rational_between(found.parameters[0].first, found.parameters[0].second), simplest_rational_between(found.parameters[1].first, found.parameters[1].second)});
    return result;
  }

  // With the parameters of a point at t, where the other parameter grows with a slope.
  std::optional<Overlap> along(int axis, const Point& point, const Exact_rational& slope, const Exact_rational& t) const
  {
    const auto other = [&](const Exact_rational& x) { return Exact_rational(point[1 - axis] + slope * (x - t)); };
    const auto inverse = [&](const Exact_rational& y) { return Exact_rational(t + (y - point[1 - axis]) / slope); };
    const auto [begin, end] = m_surface.domain(1 - axis);
    const auto [curve_begin, curve_end] = m_curve.domain(0);
    const Parameter_range ends = std::minmax({inverse(begin), inverse(end)}), range((std::max)(ends.first, curve_begin), (std::min)(ends.second, curve_end));
    if (!(range.first < range.second))
      return std::nullopt;
    Overlap result{range, Parameter_box(2)};
    result.surface[axis] = {point[axis], point[axis]};
    result.surface[1 - axis] = std::minmax({other(range.first), other(range.second)});
    if (!is_same_curve(m_curve.part(0, range), m_surface.part(result.surface), range, slope < 0))
      return std::nullopt;
    return result;
  }

  static bool is_same_curve(const Spline_patch<3>& curve, const Spline_patch<3>& line, const Parameter_range& range, bool is_backwards)
  {
    const auto along_curve = [&](const Exact_function& f) { return with_domain(is_backwards ? reversed(f, 0) : f, 0, range.first, range.second); };
    const Exact_function weight = along_curve(line.weight());
    for (int i = 0; i < 3; ++i)
      if (!(curve.numerators()[i] * weight == along_curve(line.numerators()[i]) * curve.weight()))
        return false;
    return true;
  }
};

// With what there is beside the overlap: the rest of the curve. The overlap is looked for in the longest range where something is undecided.
inline std::optional<std::vector<Common_point>> common_points_of_isoparametric_curve(const Patch_pair<3>& pair, const std::vector<Common_point>& points, Summing_solver& solve)
{
  const std::size_t curve = pair[0].number_of_parameters() == 1 ? 0 : 1;
  Parameter_range longest(Exact_rational(0), Exact_rational(0));
  for (const Common_point& point : points)
    if (const Parameter_range& range = point.parameters[pair.first_parameter(curve)]; point.kind == Intersection_kind::UNDECIDED && longest.second - longest.first < range.second - range.first)
      longest = range;
  if (longest.first == longest.second)
    return std::nullopt;
  const auto overlap = Isoparametric_curve(pair[curve], pair[1 - curve], solve)(longest);
  if (!overlap)
    return std::nullopt;
  Parameter_box ranges = overlap->surface;
  ranges.insert(curve == 0 ? ranges.begin() : ranges.end(), overlap->curve);
  std::vector<Common_point> result{{Intersection_kind::OVERLAP, std::move(ranges), std::vector<bool>(3, false), std::nullopt, false}};
  const auto [begin, end] = pair[curve].domain(0);
  for (const Parameter_range& rest : {Parameter_range(begin, overlap->curve.first), Parameter_range(overlap->curve.second, end)})
    if (rest.first < rest.second)
      for (Common_point& point : Intersection_finder<3>(pair.with(curve, pair[curve].part(0, rest)), solve)())
        result.push_back(std::move(point));
  drop_ends_of_overlaps(pair, result);
  std::sort(result.begin(), result.end(), [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
  return result;
}

// The common points of two operands. Where a curve and a surface take many nodes, the curve may run along the surface.
template <int d>
std::vector<Common_point> common_points(const Patch_pair<d>& pair, Summing_solver& solve)
{
  constexpr std::size_t many_nodes = 250;
  if constexpr (d == 3)
    if (pair.number_of_parameters() == 3) {
      Summing_solver limited = solve.limited(many_nodes);
      std::vector<Common_point> points = Intersection_finder<3>(pair, limited)();
      solve.add_work_of(limited);
      const bool is_complete = std::none_of(points.begin(), points.end(), [](const Common_point& x) { return x.kind == Intersection_kind::UNDECIDED; });
      if (is_complete)
        return points;
      if (auto others = common_points_of_isoparametric_curve(pair, points, solve))
        return std::move(*others);
      if (!limited.has_reached_node_limit() || solve.has_reached_node_limit())
        return points;
    }
  return Intersection_finder<d>(pair, solve)();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_ISOPARAMETRIC_OVERLAP_H
