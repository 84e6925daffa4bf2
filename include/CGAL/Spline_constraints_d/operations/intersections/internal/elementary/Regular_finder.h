// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_REGULAR_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_REGULAR_FINDER_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/doubles/Crossing_search.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/regular_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The common points of two polynomial operands in one piece each: the solutions of A = B, written with the doubles that
they consist of. Most pairs have only regular ones away from all ends, or where both curves end in the same point, and
nothing is left to decide. No exact patch is made for these.
*/
template <int d>
class Regular_finder
{
  using Operand = Elementary_operand<d>;
  static constexpr std::size_t most_nodes = d == 2 ? 500 : 250; // those after which others look at the pair

  const Operand &m_first, &m_second;
  std::size_t m_split, m_size;

public:
  Regular_finder(const Operand& first, const Operand& second)
    : m_first(first), m_second(second), m_split(number_of_parameters(first)),
      m_size(m_split + number_of_parameters(second))
  {}

  // Those of two planar curves that cross in all common points, if doubles prove that.
  std::optional<Elementary_points<d>> crossings() const
  {
    if constexpr (d == 2)
      if (has_direct_equations() && Crossing_search::can_search(m_first.coefficients) &&
          Crossing_search::can_search(m_second.coefficients)) {
        Crossing_search search(m_first.coefficients, m_second.coefficients);
        const std::size_t most_points = static_cast<std::size_t>(m_first.degrees[0] * m_second.degrees[0]);
        auto solutions = search(200 + 20 * most_points);
        if (!solutions || !are_seen_to_be_regular(*solutions))
          return std::nullopt;
        Elementary_points<d> result = regular_points(std::move(*solutions));
        result.nodes = search.nodes();
        return result;
      }
    return std::nullopt;
  }

  Regular_points<d> operator()(Budgeted_solver& solve) const
  {
    if (!has_direct_equations())
      return {};
    Budgeted_solver limited = solve.limited(most_nodes);
    Solution_set_d<double> solutions = limited(system());
    solve.add_work_of(limited);
    if (limited.has_reached_node_limit())
      return {};
    if (!are_seen_to_be_regular(solutions))
      return {std::move(solutions)};
    return {std::nullopt, regular_points(std::move(solutions).solutions())};
  }

private:
  static std::size_t number_of_parameters(const Operand& x) { return x.kind == Elementary_kind::PATCH ? 2 : 1; }

  // As many equations as unknowns, in the unit box, none of which is eliminated better.
  bool has_direct_equations() const
  {
    const auto is_curved = [](const Operand& x) {
      const bool is_spline = x.kind == Elementary_kind::CURVE || x.kind == Elementary_kind::PATCH;
      return is_spline && x.is_one_piece() && (x.degrees[0] > 1 || x.degrees[1] > 1) &&
          std::all_of(x.domain.begin(), x.domain.end(), [](const auto& range) {
               return range == std::array<double, 2>{0, 1};
             });
    };
    return m_size == d && is_curved(m_first) && is_curved(m_second);
  }

  Constraint_system_d system() const
  {
    Constraint_system_d result(std::vector<Constraint_system_d::Domain>(m_size, {0, 1}));
    for (std::size_t i = 0; i < d; ++i)
      result.add(coordinate(m_first, i, 0, 1) + coordinate(m_second, i, m_split, -1), Relation::EQUAL);
    return result;
  }

  static Spline_function coordinate(const Operand& x, std::size_t i, std::size_t first_unknown, double sign)
  {
    std::vector<double> coefficients;
    coefficients.reserve(x.coefficients[i].size());
    for (const double c : x.coefficients[i])
      coefficients.push_back(sign * c);
    std::vector<int> degrees, unknowns;
    for (std::size_t axis = 0; axis < number_of_parameters(x); ++axis) {
      degrees.push_back(x.degrees[axis]);
      unknowns.push_back(static_cast<int>(first_unknown + axis));
    }
    return Spline_function::from_bernstein(std::move(unknowns),
                                           Bernstein_tensor<double>(std::move(degrees), std::move(coefficients)));
  }

  template <class Solutions>
  Elementary_points<d> regular_points(Solutions solutions) const
  {
    Elementary_points<d> result{m_split, m_size};
    for (Solution_d<double>& solution : solutions) {
      const auto end = common_end(solution);
      Elementary_point<d> point{Intersection_kind::TRANSVERSAL, {}, {}, 1, std::nullopt, {}, std::move(solution)};
      for (std::size_t j = 0; j < m_size; ++j)
        point.parameters[j] = (*point.solution)[j];
      if (end) {
        point.kind = Intersection_kind::END_POINT;
        for (const std::size_t j : {0, 1}) {
          point.parameters[j] = {(*end)[j], (*end)[j]};
          point.is_at_end[j] = true;
        }
      }
      set_point(point);
      result.points.push_back(std::move(point));
    }
    result.points.sort(is_before<d>);
    return result;
  }

  template <class Solutions>
  bool are_seen_to_be_regular(const Solutions& solutions) const
  {
    return std::all_of(solutions.begin(), solutions.end(), [&](const auto& x) { return is_seen_to_be_regular(x); });
  }

  // Whether there is no more to tell of a solution.
  bool is_seen_to_be_regular(const Solution_d<double>& solution) const
  {
    return solution.is_certified() &&
        (std::all_of(solution.box().begin(), solution.box().end(),
                     [](const auto& range) { return range.first > 0 && range.second < 1; }) ||
         common_end(solution));
  }

  // Where two curves that are not closed end in the same point, which is the solution then: the ends.
  std::optional<std::array<double, 2>> common_end(const Solution_d<double>& solution) const
  {
    std::array<double, 2> ends{};
    if (m_size != 2)
      return std::nullopt;
    for (const std::size_t j : {0, 1}) {
      const auto [lower, upper] = solution[j];
      if ((lower <= 0) == (upper >= 1))
        return std::nullopt;
      ends[j] = lower <= 0 ? 0 : 1;
    }
    for (std::size_t i = 0; i < d; ++i)
      if (end(m_first, i, ends[0]) != end(m_second, i, ends[1]))
        return std::nullopt;
    return is_closed(m_first) || is_closed(m_second) ? std::nullopt : std::optional(ends);
  }

  static double end(const Operand& curve, std::size_t i, double t)
  {
    return t == 0 ? curve.coefficients[i].front() : curve.coefficients[i].back();
  }

  static bool is_closed(const Operand& curve)
  {
    for (std::size_t i = 0; i < d; ++i)
      if (end(curve, i, 0) != end(curve, i, 1))
        return false;
    return true;
  }

  // The point of the curve in the middle of its range, rounded.
  void set_point(Elementary_point<d>& point) const
  {
    const bool is_first = m_first.kind == Elementary_kind::CURVE;
    const Operand& curve = is_first ? m_first : m_second;
    const auto [lower, upper] = point.parameters[is_first ? 0 : m_split];
    const double t = lower + (upper - lower) / 2;
    for (std::size_t i = 0; i < d; ++i)
      point.point[i] = rounded_value(curve.coefficients[i], t);
  }
};

template <int d>
std::optional<Elementary_points<d>> crossing_points(const Elementary_operand<d>& first,
                                                    const Elementary_operand<d>& second)
{
  return Regular_finder<d>(first, second).crossings();
}

template <int d>
Regular_points<d> regular_points(const Elementary_operand<d>& first, const Elementary_operand<d>& second,
                                 Budgeted_solver& solve)
{
  return Regular_finder<d>(first, second)(solve);
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_REGULAR_FINDER_H
