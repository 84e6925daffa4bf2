// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAR_SPECIAL_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAR_SPECIAL_POINTS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_coincidences.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/near_boxes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// The special points of one object: where special parameters of all axes meet.
template <int d>
class Special_points_of_object
{
  // A parameter at which points are special.
  struct Special_parameter
  {
    Exact_rational value;
    Special_point_kind kind;
    bool is_pole = false;
  };

  const Spline_patch<d>& m_patch;
  std::size_t m_object;

public:
  Special_points_of_object(const Spline_patch<d>& patch, std::size_t object) : m_patch(patch), m_object(object) {}

  void append_to(std::vector<Special_point<d>>& result, Run_of_steps& run) const
  {
    const std::vector<Special_parameter> along = special_parameters(0);
    if (m_patch.number_of_parameters() == 1)
      for (const Special_parameter& t : along) {
        run.check();
        result.push_back(at(t.kind, {{t.value, t.value}}));
      }
    else
      append_points_of_surface(along, special_parameters(1), result, run);
  }

private:
  // The ends, and the breaks between them. Both ends of a closed object are one.
  std::vector<Special_parameter> special_parameters(int axis) const
  {
    const bool is_surface = m_patch.number_of_parameters() == 2, is_closed = m_patch.is_closed(axis);
    const Special_point_kind kind_of_ends = is_closed ? Special_point_kind::SEAM
        : is_surface                                  ? Special_point_kind::CORNER
                                                      : Special_point_kind::END;
    const auto [begin, end] = m_patch.domain(axis);
    const auto is_pole = [&](const Exact_rational& t) { return is_surface && m_patch.pole(axis, t); };
    std::vector<Special_parameter> result{{begin, kind_of_ends, is_pole(begin)}};
    for (const Exact_rational& t : m_patch.possible_kinks(axis))
      result.push_back({t, Special_point_kind::BREAK});
    if (!is_closed)
      result.push_back({end, kind_of_ends, is_pole(end)});
    return result;
  }

  void append_points_of_surface(const std::vector<Special_parameter>& first,
                                const std::vector<Special_parameter>& second, std::vector<Special_point<d>>& result,
                                Run_of_steps& run) const
  {
    for (const Special_parameter& u : first)
      if (u.is_pole)
        result.push_back(at(Special_point_kind::POLE, {{u.value, u.value}, m_patch.domain(1)}));
    for (const Special_parameter& v : second)
      if (v.is_pole)
        result.push_back(at(Special_point_kind::POLE, {m_patch.domain(0), {v.value, v.value}}));
    for (const Special_parameter& u : first)
      for (const Special_parameter& v : second)
        if (!u.is_pole && !v.is_pole) {
          run.check();
          result.push_back(at(common_kind(u.kind, v.kind), {{u.value, u.value}, {v.value, v.value}}));
        }
  }

  static Special_point_kind common_kind(Special_point_kind a, Special_point_kind b)
  {
    for (const Special_point_kind kind : {Special_point_kind::SEAM, Special_point_kind::BREAK})
      if (a == kind || b == kind)
        return kind;
    return Special_point_kind::CORNER;
  }

  Special_point<d> at(Special_point_kind kind, std::vector<Parameter_range> parameters) const
  {
    std::vector<Exact_rational> begin;
    for (const Parameter_range& range : parameters)
      begin.push_back(range.first);
    return {m_object, kind, std::move(parameters), m_patch(begin)};
  }
};

// How large the coordinates of an object are: not more than the greatest of them.
template <int d>
double size_of_coordinates(const Spline_patch<d>& patch)
{
  const auto greatest = [](const Exact_function& f) {
    double result = 0;
    for (const Exact_rational& x : f.coefficients())
      result = (std::max)(result, std::abs(to_nearest_double(x)));
    return result;
  };
  double result = 0;
  for (const Exact_function& numerator : patch.numerators())
    result = (std::max)(result, greatest(numerator));
  const double quotient = result / greatest(patch.weight());
  return std::isfinite(quotient) ? quotient : (std::numeric_limits<double>::max)();
}

template <int d>
Exact_rational squared_distance_of(const std::array<Exact_rational, d>& p, const std::array<Exact_rational, d>& q)
{
  Exact_rational result(0);
  for (int i = 0; i < d; ++i) {
    const Exact_rational difference = p[i] - q[i];
    result += difference * difference;
  }
  return result;
}

// Pairs of different points that are not farther from each other than the tolerance.
template <int d>
std::vector<Found_coincidence<d>> near_pairs(const std::vector<Special_point<d>>& points, bool are_different,
                                             double tolerance, Run_of_steps& run)
{
  std::vector<Indexed_box<d>> boxes;
  for (const Special_point<d>& point : points) {
    std::array<std::pair<double, double>, d> ranges;
    std::transform(point.point.begin(), point.point.end(), ranges.begin(), to_double_interval);
    boxes.push_back(widened_box<d>(ranges, tolerance / 2, boxes.size()));
  }
  const Exact_rational bound = to_rational(tolerance), most(bound * bound);
  std::vector<Found_coincidence<d>> result;
  for (const auto& [second, first] : meeting_pairs<d>(std::move(boxes))) {
    run.check();
    const Special_point<d>&p = points[first], &q = points[second];
    if (are_different && p.object == q.object)
      continue;
    Exact_rational square = squared_distance_of<d>(p.point, q.point);
    if (square > 0 && square <= most)
      result.push_back({{p, q}, std::move(square)});
  }
  std::sort(result.begin(), result.end(), [](const auto& x, const auto& y) {
    const auto order = [](const Found_coincidence<d>& pair) {
      return std::tie(pair.points[0].object, pair.points[1].object, pair.points[0].parameters,
                      pair.points[1].parameters);
    };
    return order(x) < order(y);
  });
  return result;
}

template <int d>
Found_coincidences<d> near_coincidences_of(const std::vector<Exact_map<d>>& objects, bool are_different,
                                           std::optional<double> tolerance, const Solver_options& options)
{
  Run_of_steps run(options);
  std::vector<Spline_patch<d>> patches;
  for (const Exact_map<d>& object : objects)
    patches.emplace_back(object);
  try {
    std::vector<Special_point<d>> points;
    double size = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      Special_points_of_object<d>(patches[i], i).append_to(points, run);
      size = (std::max)(size, size_of_coordinates(patches[i]));
    }
    std::vector<Found_coincidence<d>> pairs =
        near_pairs(points, are_different, tolerance ? *tolerance : rounding_of_coordinates * size, run);
    return {std::move(pairs), {}, run.summary(true)};
  } catch (const Run_stopped& stopped) {
    std::vector<Undecided_part> undecided;
    for (std::size_t i = 0; i < patches.size(); ++i)
      undecided.push_back({double_ranges(patches[i].values()), {{i, {}}}, in_words(stopped.reason)});
    return {{}, std::move(undecided), run.summary(false)};
  }
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAR_SPECIAL_POINTS_H
