// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ALONG_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ALONG_SURFACES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Overlap_ends.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The polynomial with given values at as many parameters, on a range.
inline Exact_function interpolant(std::span<const Exact_rational> at, std::vector<Exact_rational> values,
                                  const Parameter_range& range)
{
  const std::size_t count = at.size();
  for (std::size_t r = 1; r < count; ++r)   // divided differences
    for (std::size_t k = count - 1; k >= r; --k)
      values[k] = Exact_rational((values[k] - values[k - 1]) / (at[k] - at[k - r]));
  std::vector<Exact_rational> power(count, Exact_rational(0));
  for (std::size_t k = count; k-- > 0;) {
    for (std::size_t i = count - 1; i > 0; --i)
      power[i] = Exact_rational(power[i - 1] - power[i] * at[k]);
    power[0] = Exact_rational(values[k] - power[0] * at[k]);
  }
  return Exact_function::from_tensor(Bernstein_tensor<Exact_rational>::from_power_on_box(
                                         {static_cast<int>(count) - 1}, power, std::array<Parameter_range, 1>{range}),
                                     {range});
}

/*
A curve that runs along a surface, C(t) = S(q(t)), where q is a polynomial of low degree: a line where one parameter is
constant, another line of the domain, a curve that was made on the surface.

The parameters on the surface of some points of the curve give q. They need not be proved: whether C(t) = S(q(t)) is
decided exactly. Between breaks of both sides it is an equation of polynomials, and holds everywhere if it holds at as
many parameters as its degree, and one more.
*/
class Curve_along_surface
{
  using Point = std::vector<Exact_rational>;
  using Path = std::array<Exact_function, 2>;

  static constexpr std::size_t most_samples = 4;   // one more than the degree of q

  Spline_patch<3> m_curve, m_surface;
  Budgeted_solver& m_solve;

public:
  // The range of the parameter of the curve, those of the surface, and the parameters on the surface of both ends.
  struct Overlap
  {
    Parameter_range curve;
    Parameter_box surface;
    std::array<Point, 2> ends;
  };

  Curve_along_surface(Spline_patch<3> curve, Spline_patch<3> surface, Budgeted_solver& solve)
    : m_curve(std::move(curve)), m_surface(std::move(surface)), m_solve(solve)
  {}

  // From points with parameters in a range.
  std::vector<Overlap> operator()(const Parameter_range& range) const
  {
    std::vector<Exact_rational> at;
    std::vector<std::vector<Point>> choices(1);
    for (std::size_t k = 0; k < most_samples; ++k) {
      at.push_back(parameter_within(range, k));
      choices = with_next(choices, points_on_surface(at.back()));
      if (k == 0)
        continue;
      for (const std::vector<Point>& points : choices)
        if (const Path path = path_through(at, points); are_same_at(path, parameter_within(range, most_samples)))
          if (std::vector<Overlap> result = along(path); !result.empty())
            return result;
    }
    return {};
  }

private:
  // Simple ones, so that the parameters on the surface are.
  static Exact_rational parameter_within(const Parameter_range& range, std::size_t k)
  {
    const auto part = [&](int i) { return Exact_rational(range.first + (range.second - range.first) * i / 12); };
    const int from = std::array<int, most_samples + 1>{3, 8, 1, 10, 5}[k];
    return simplest_rational_between(part(from), part(from + 1));
  }

  // The simplest parameters in the ranges that are found.
  std::vector<Point> points_on_surface(const Exact_rational& t) const
  {
    const Spline_patch<3> point(m_curve(std::array<Exact_rational, 1>{t}));
    std::vector<Point> result;
    for (const Common_point& found : Intersection_finder<3>(Patch_pair<3>(point, m_surface), m_solve)())
      result.push_back({simplest_rational_between(found.parameters[0].first, found.parameters[0].second),
                        simplest_rational_between(found.parameters[1].first, found.parameters[1].second)});
    return result;
  }

  static std::vector<std::vector<Point>> with_next(const std::vector<std::vector<Point>>& choices,
                                                   const std::vector<Point>& points)
  {
    std::vector<std::vector<Point>> result;
    for (const std::vector<Point>& choice : choices)
      for (const Point& point : points) {
        result.push_back(choice);
        result.back().push_back(point);
      }
    return result;
  }

  Path path_through(std::span<const Exact_rational> at, const std::vector<Point>& points) const
  {
    Path result;
    for (const std::size_t axis : {0, 1}) {
      std::vector<Exact_rational> values;
      for (const Point& point : points)
        values.push_back(point[axis]);
      result[axis] = interpolant(at, values, m_curve.domain(0));
    }
    return result;
  }

  // The pieces of the curve on the surface, if all parameters where the path meets a break are rational.
  std::vector<Overlap> along(const Path& path) const
  {
    const auto cuts = cuts_of(path);
    std::vector<Overlap> result;
    for (std::size_t i = 1; cuts && i < cuts->size(); ++i) {
      const Parameter_range cell((*cuts)[i - 1], (*cuts)[i]);
      if (!is_same_curve(path, cell))
        continue;
      if (result.empty() || result.back().curve.second != cell.first)
        result.push_back({{cell.first, cell.first}, {}, {}});
      result.back().curve.second = cell.second;
    }
    for (Overlap& overlap : result) {
      overlap.ends = {point_on(path, overlap.curve.first), point_on(path, overlap.curve.second)};
      for (const int axis : {0, 1})
        overlap.surface.push_back(path[axis].restricted(0, overlap.curve.first, overlap.curve.second).bounds());
      overlap.surface = clipped(overlap.surface, {m_surface.domain(0), m_surface.domain(1)});
    }
    return result;
  }

  static Point point_on(const Path& path, const Exact_rational& t)
  {
    return {path[0](std::array{t}), path[1](std::array{t})};
  }

  bool is_on_surface(const Path& path, const Exact_rational& t) const
  {
    const Point point = point_on(path, t);
    const auto is_within = [&](int axis) {
      return m_surface.domain(axis).first <= point[axis] && point[axis] <= m_surface.domain(axis).second;
    };
    return is_within(0) && is_within(1);
  }

  // Breaks of the curve, and parameters where the path meets a break of the surface. None if one of them is not known.
  std::optional<std::vector<Exact_rational>> cuts_of(const Path& path) const
  {
    std::vector<Exact_rational> result = m_curve.breaks(0);
    const auto [begin, end] = m_curve.domain(0);
    const std::vector<Unknown> t = unknowns(std::vector<std::array<Bound, 2>>{{Bound(begin), Bound(end)}});
    const Vector_expression<2> point = Parametric_vector<2>(path)(t);
    for (const int axis : {0, 1})
      for (const Exact_rational& value : m_surface.breaks(axis)) {
        const auto [least, greatest] = path[axis].bounds();
        if (least == greatest || value < least || greatest < value)
          continue;
        for (const Solution_d<double>& solution : m_solve(std::vector<Constraint>{point[axis] == value}, t)) {
          const Parameter_box box = clipped(solution.exact_box(), {{begin, end}});
          result.push_back(simplest_rational_between(box[0].first, box[0].second));
          if (path[axis](std::array{result.back()}) != value)
            return std::nullopt;
        }
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // On a range between cuts.
  bool is_same_curve(const Path& path, const Parameter_range& range) const
  {
    int degree = 0, degree_on_surface = 0;
    const auto add_degrees = [&](const Spline_patch<3>& patch, int& sum, int axis) {
      int highest = patch.weight().degree(axis);
      for (const Exact_function& numerator : patch.numerators())
        highest = (std::max)(highest, numerator.degree(axis));
      sum += highest;
    };
    add_degrees(m_curve, degree, 0);
    for (const int axis : {0, 1})
      add_degrees(m_surface, degree_on_surface, axis);
    degree += path[0].degree(0) * degree_on_surface;
    for (int k = 0; k <= degree; ++k)
      if (!are_same_at(path, Exact_rational(range.first + (range.second - range.first) * (k + 1) / (degree + 2))))
        return false;
    return true;
  }

  bool are_same_at(const Path& path, const Exact_rational& t) const
  {
    return is_on_surface(path, t) && m_curve(std::array{t}) == m_surface(point_on(path, t));
  }
};

// With what there is beside the overlaps: the rest of the curve. They are looked for in the longest range where
// something is undecided.
inline std::optional<std::vector<Common_point>>
common_points_of_curve_along_surface(const Patch_pair<3>& pair, const std::vector<Common_point>& points,
                                     Budgeted_solver& solve)
{
  const std::size_t curve = pair[0].number_of_parameters() == 1 ? 0 : 1, parameter = pair.first_parameter(curve),
                    first_of_surface = pair.first_parameter(1 - curve);
  Parameter_range longest(Exact_rational(0), Exact_rational(0));
  for (const Common_point& point : points)
    if (const Parameter_range& range = point.parameters[parameter];
        point.kind == Intersection_kind::UNDECIDED && longest.second - longest.first < range.second - range.first)
      longest = range;
  if (longest.first == longest.second)
    return std::nullopt;
  const std::vector<Curve_along_surface::Overlap> overlaps =
      Curve_along_surface(pair[curve], pair[1 - curve], solve)(longest);
  if (overlaps.empty())
    return std::nullopt;

  std::vector<Common_point> result;
  const auto is_end = [&](const Common_point& point, const Curve_along_surface::Overlap& overlap, int side) {
    const Exact_rational& t = side == 0 ? overlap.curve.first : overlap.curve.second;
    const auto holds = [&](std::size_t axis) {
      const Parameter_range& range = point.parameters[first_of_surface + axis];
      return range.first <= overlap.ends[side][axis] && overlap.ends[side][axis] <= range.second;
    };
    return point.kind != Intersection_kind::UNDECIDED && point.parameters[parameter] == Parameter_range(t, t) &&
        holds(0) && holds(1);
  };
  const auto add_rest = [&](const Parameter_range& rest) {
    if (!(rest.first < rest.second))
      return;
    for (Common_point& point : Intersection_finder<3>(pair.with(curve, pair[curve].part(0, rest)), solve)())
      if (std::none_of(overlaps.begin(), overlaps.end(),
                       [&](const auto& overlap) { return is_end(point, overlap, 0) || is_end(point, overlap, 1); }))
        result.push_back(std::move(point));
  };
  Exact_rational begin = pair[curve].domain(0).first;
  for (const Curve_along_surface::Overlap& overlap : overlaps) {
    add_rest({begin, overlap.curve.first});
    begin = overlap.curve.second;
    Parameter_box ranges = overlap.surface;
    ranges.insert(curve == 0 ? ranges.begin() : ranges.end(), overlap.curve);
    result.push_back({Intersection_kind::OVERLAP, std::move(ranges), std::vector<bool>(3, false), std::nullopt, false});
  }
  add_rest({begin, pair[curve].domain(0).second});
  drop_ends_of_overlaps(pair, result);
  std::sort(result.begin(), result.end(),
            [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ALONG_SURFACES_H
