// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTION_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTION_FINDER_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Coincidence.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Overlap_ends.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Eliminated_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/settle_undecided_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The common points of two patches: the solutions of A = B, told apart by what is known of the ends of parameters. Whether
the only solution in a region is at an end is a system in one unknown less, in that region.

A pole is an edge of a surface that is one point. Where the other operand goes through it, a whole range of a parameter
stands for one common point. In two unknowns the solver finds this segment. In three, a box of parameters around it is
proved to hold no other common point, and left out.
*/
template <int d>
class Intersection_finder
{
  using Solution = Solution_d<double>;

  // A solution with its parameters, and a region where it is the only one.
  struct Answer
  {
    std::optional<Solution> solution; // none without unknowns
    Parameter_box parameters, region;
  };

  struct Pole
  {
    Parameter_end end;
    Spline_patch<d> point;
  };

  Patch_pair<d> m_pair;
  Budgeted_solver& m_solve;
  Known_solutions m_known;

public:
  Intersection_finder(Patch_pair<d> pair, Budgeted_solver& solve, Known_solutions known = std::nullopt)
    : m_pair(std::move(pair)), m_solve(solve), m_known(std::move(known))
  {}

  // Each common point once: on the seam of a closed operand, with the lower parameter.
  std::vector<Common_point> operator()()
  {
    std::vector<Common_point> result = found();
    std::erase_if(result, [](const Common_point& x) { return x.is_repeated; });
    if (!m_solve.must_stop())
      settle_undecided_points(m_pair, result);
    if constexpr (d == 2)
      if (is_pair_of_curves())
        settle_corners(m_pair, result, m_solve);
    drop_ends_of_overlaps(m_pair, result);
    if constexpr (d == 2)
      if (is_pair_of_curves())
        decide_passages(m_pair, result, m_solve);
    std::sort(result.begin(), result.end(),
              [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
    return result;
  }

private:
  /*
  With those on both sides of a seam. Near curves that nearly coincide the solver takes as many boxes as they are long
  against their distance: where these multiply without being decided, the parameters of curves are eliminated.
  */
  std::vector<Common_point> found()
  {
    if (!is_pair_of_curves())
      return with_seams();
    const Budgeted_solver whole = m_solve;
    m_solve = whole.limited(many_nodes());
    std::vector<Common_point> result = with_seams();
    const Budgeted_solver limited = std::exchange(m_solve, whole);
    m_solve.add_work_of(limited);
    if (std::none_of(result.begin(), result.end(), is_undecided) || m_solve.must_stop())
      return result;
    if (std::optional<std::vector<Common_point>> others = eliminated_points())
      return std::move(*others);
    return limited.has_reached_node_limit() && !m_solve.has_reached_node_limit() && !m_solve.must_stop() ? with_seams()
                                                                                                         : result;
  }

  // Several times as many as curves with so many pieces next to each other need that do not nearly coincide.
  std::size_t many_nodes() const
  {
    constexpr std::size_t first_pair = 500, next_pair = 100;
    const auto is_one_piece = [&](std::size_t k) {
      const Exact_function& x = m_pair[k].numerators()[0];
      return x.coefficients().size() == static_cast<std::size_t>(x.degree(0)) + 1;
    };
    return is_one_piece(0) && is_one_piece(1) ? first_pair
                                              : first_pair + next_pair * number_of_meeting_pieces(m_pair[0], m_pair[1]);
  }

  std::optional<std::vector<Common_point>> eliminated_points()
  {
    const double begin = m_solve.budget().seconds(), solved = m_solve.total().seconds;
    std::optional<std::vector<Common_point>> result;
    try {
      const auto check = [this] { m_solve.budget().check(); };
      const auto solve_part = [this](const Parameter_box& box) {
        return Intersection_finder(m_pair.part(box), m_solve).with_seams();
      };
      result = Eliminated_points<d>(m_pair, check, solve_part)();
    } catch (const Run_stopped&) { // what the solver has found is left
    }
    Summary work;
    work.seconds = m_solve.budget().seconds() - begin - (m_solve.total().seconds - solved);
    m_solve.budget().add(work);
    return result;
  }

  bool is_pair_of_curves() const { return m_pair.number_of_parameters() == 2 && m_pair.first_parameter(1) == 1; }

  static bool is_undecided(const Common_point& point) { return point.kind == Intersection_kind::UNDECIDED; }

  std::vector<Common_point> with_seams()
  {
    const Coincidence<d> equations(m_pair);
    std::vector<Common_point> result;
    std::vector<Parameter_region> regions{{m_pair.domain(), none()}};
    for (const Pole& pole : poles(equations))
      for (Common_point& point : points_at(pole)) {
        const Parameter_box hole = with_neighbourhood(pole, point);
        std::vector<Parameter_region> rest;
        for (const Parameter_region& region : regions)
          append(rest, without(region, hole));
        regions = std::move(rest);
        result.push_back(std::move(point));
      }
    if (result.empty()) {
      append(result, classified(answers(equations, none())));
      return result;
    }
    m_known.reset();   // those of the whole domain
    for (const Parameter_region& region : regions)
      append(result, classified(answers(Coincidence<d>(m_pair.part(region.box)), region.is_open)));
    return result;
  }

  std::vector<bool> none() const { return std::vector<bool>(m_pair.number_of_parameters(), false); }

  template <class T>
  static void append(std::vector<T>& all, std::vector<T> more)
  {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }

  std::vector<Answer> answers(const Coincidence<d>& equations, const std::vector<bool>& is_open)
  {
    std::vector<Answer> result;
    const std::vector<Unknown> u = equations.unknowns();
    const std::vector<Constraint> constraints = equations.constraints(u, is_open);
    if (u.empty()) {
      if (hold(constraints))
        result.push_back({std::nullopt, equations.all_parameters({}), equations.with_whole_ranges({})});
      return result;
    }
    for (const Solution& solution : solutions(constraints, u)) {
      const Parameter_box box = solution.exact_box(),
                          region = solution.uniqueness_region().empty() ? box : solution.exact_uniqueness_region();
      result.push_back({solution, equations.all_parameters(box), equations.with_whole_ranges(region)});
    }
    return result;
  }

  // Those that are known are of the equations in all parameters; a second time they are looked for with other limits.
  Solution_set_d<double> solutions(const std::vector<Constraint>& constraints, const std::vector<Unknown>& u)
  {
    const Known_solutions known = std::exchange(m_known, std::nullopt);
    return known && u.size() == m_pair.number_of_parameters() ? *known : m_solve(constraints, u);
  }

  std::vector<Answer> answers(const Patch_pair<d>& pair)
  {
    return answers(Coincidence<d>(pair), std::vector<bool>(pair.number_of_parameters(), false));
  }

  std::vector<Common_point> classified(const std::vector<Answer>& answers)
  {
    std::vector<Common_point> result;
    for (const Answer& answer : answers)
      result.push_back(classified(answer));
    return result;
  }

  Common_point classified(const Answer& answer)
  {
    Common_point result{kind_of(answer.solution), answer.parameters, none(), answer.solution,
                        is_repeated_at_end(answer.parameters)};
    if (result.kind == Intersection_kind::TANGENT && answer.solution->multiplicity() == 1 &&
        !holds_inner_breaks(answer.parameters))
      result.kind = Intersection_kind::TRANSVERSAL; // it was hard to see, but is regular
    const std::optional<std::size_t> surface =
        result.kind == Intersection_kind::OVERLAP ? set_pole(result) : std::nullopt;
    if (!surface && !is_one_point(answer.solution))
      return result;
    for (const Parameter_end& end : m_pair.ends()) {
      if (m_pair.operand_of(end.parameter) == surface || !touches(answer.parameters, end))
        continue;
      const CGAL::Uncertain<bool> is_at_end = has_common_point(m_pair.at(end, answer.region));
      if (!CGAL::is_certain(is_at_end))
        return {Intersection_kind::UNDECIDED, answer.parameters, none(), answer.solution, false};
      if (CGAL::certainly(is_at_end))
        set_end(result, end, answer.region);
    }
    return result;
  }

  // Whether derivatives may jump in a box.
  bool holds_inner_breaks(const Parameter_box& box) const
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (holds_inner_break(m_pair[m_pair.operand_of(j)], m_pair.axis_of(j), box[j]))
        return true;
    return false;
  }

  void set_end(Common_point& point, const Parameter_end& end, const Parameter_box& region)
  {
    if (point.kind != Intersection_kind::TANGENT)
      point.kind = Intersection_kind::END_POINT;
    point.parameters[end.parameter] = {end.value, end.value};
    point.is_at_end[end.parameter] = true;
    point.is_repeated = point.is_repeated || (is_repeated_at_end(point.parameters) && is_alone(point, region));
  }

  // Whether a common point in a region is the only one there; a cluster of unknown multiplicity may hold more.
  bool is_alone(const Common_point& point, const Parameter_box& region)
  {
    return point.kind == Intersection_kind::END_POINT ||
        (point.solution && (point.solution->multiplicity() == 2 || !has_extent(point.solution->exact_box()))) ||
        has_one_point_at_breaks(region);
  }

  // Whether a region that reaches over breaks has one common point only: in the parts between them, the point is a
  // corner. Where the derivatives jump there is no multiplicity that tells so much.
  bool has_one_point_at_breaks(const Parameter_box& region)
  {
    std::vector<Parameter_box> parts{region}, points;
    for (std::size_t j = 0; j < region.size(); ++j)
      for (const Exact_rational& value : m_pair[m_pair.operand_of(j)].breaks(m_pair.axis_of(j)))
        for (std::size_t i = 0, size = parts.size(); i < size; ++i)
          if (parts[i][j].first < value && value < parts[i][j].second) {
            parts.push_back(parts[i]);
            parts[i][j].second = parts.back()[j].first = value;
          }
    if (parts.size() == 1)
      return false;
    for (const Parameter_box& part : parts)
      for (const Common_point& point : Intersection_finder(m_pair.part(part), m_solve).with_seams()) {
        if (point.kind == Intersection_kind::UNDECIDED || has_extent(point.parameters))
          return false;
        points.push_back(point.parameters);
      }
    return !points.empty() && std::adjacent_find(points.begin(), points.end(), std::not_equal_to<>()) == points.end();
  }

  // At the upper end of a parameter whose points are found elsewhere.
  bool is_repeated_at_end(const Parameter_box& parameters) const
  {
    const std::vector<Parameter_end> ends = m_pair.ends();
    return std::any_of(ends.begin(), ends.end(), [&](const Parameter_end& end) {
      return end.is_upper && is_at(parameters, end) && m_pair.is_repeated_at_end(end.parameter);
    });
  }

  static bool is_at(const Parameter_box& parameters, const Parameter_end& end)
  {
    return parameters[end.parameter] == Parameter_range(end.value, end.value);
  }

  // A segment of solutions may be the pole of a surface: of which operand.
  std::optional<std::size_t> set_pole(Common_point& point) const
  {
    for (const Parameter_end& end : m_pair.ends())
      if (is_at(point.parameters, end) && m_pair.pole(end)) {
        point.is_at_end[end.parameter] = true;
        point.kind = Intersection_kind::END_POINT;
        return m_pair.operand_of(end.parameter);
      }
    return std::nullopt;
  }

  static Intersection_kind kind_of(const std::optional<Solution>& solution)
  {
    if (!solution)
      return Intersection_kind::TRANSVERSAL;
    switch (solution->kind()) {
    case Solution_kind::CERTIFIED:
      return Intersection_kind::TRANSVERSAL;
    case Solution_kind::CLUSTER:
      return Intersection_kind::TANGENT;
    case Solution_kind::CONTINUUM:
      return Intersection_kind::OVERLAP;
    case Solution_kind::UNDECIDED:
      break;
    }
    return Intersection_kind::UNDECIDED;
  }

  // One point at most, which is proved to be a common point, or is one if it is at an end.
  static bool is_one_point(const std::optional<Solution>& solution)
  {
    return !solution || solution->kind() == Solution_kind::CERTIFIED || solution->kind() == Solution_kind::CLUSTER ||
        is_undecided_at_end(*solution);
  }

  static bool is_undecided_at_end(const Solution& solution)
  {
    const Undecided_reason reason = solution.reason();
    return reason == Undecided_reason::DOMAIN_BOUNDARY || reason == Undecided_reason::INEQUALITY ||
        reason == Undecided_reason::OVERDETERMINED;
  }

  static bool touches(const Parameter_box& box, const Parameter_end& end)
  {
    const Parameter_range& range = box[end.parameter];
    return range.first <= end.value && end.value <= range.second;
  }

  CGAL::Uncertain<bool> has_common_point(const Patch_pair<d>& pair)
  {
    const std::vector<Answer> found = answers(pair);
    if (found.empty())
      return false;
    for (const Answer& answer : found) {
      if (!answer.solution || answer.solution->kind() != Solution_kind::UNDECIDED)
        return true;
      if (is_undecided_at_end(*answer.solution))
        for (const Parameter_end& end : pair.ends())
          if (touches(answer.parameters, end) && CGAL::certainly(has_common_point(pair.at(end, answer.region))))
            return true;
    }
    return CGAL::Uncertain<bool>::indeterminate();
  }

  // Poles that the solver does not find.
  std::vector<Pole> poles(const Coincidence<d>& equations) const
  {
    std::vector<Pole> result;
    for (const Parameter_end& end : m_pair.ends())
      if (!equations.has_eliminated(1 - m_pair.operand_of(end.parameter)))
        if (const auto point = m_pair.pole(end))
          result.push_back({end, *point});
    return result;
  }

  // What is proved to be a common point at a pole.
  std::vector<Common_point> points_at(const Pole& pole)
  {
    const std::size_t surface = m_pair.operand_of(pole.end.parameter);
    std::vector<Common_point> result;
    for (const Common_point& point : Intersection_finder(m_pair.with(surface, pole.point), m_solve).with_seams()) {
      if (point.kind == Intersection_kind::UNDECIDED || point.kind == Intersection_kind::OVERLAP)
        continue;
      Common_point all{Intersection_kind::END_POINT, m_pair.domain(), none(), std::nullopt, point.is_repeated};
      const auto begin = static_cast<std::ptrdiff_t>(m_pair.first_parameter(1 - surface));
      std::copy(point.parameters.begin(), point.parameters.end(), all.parameters.begin() + begin);
      std::copy(point.is_at_end.begin(), point.is_at_end.end(), all.is_at_end.begin() + begin);
      all.parameters[pole.end.parameter] = {pole.end.value, pole.end.value};
      all.is_at_end[pole.end.parameter] = true;
      result.push_back(std::move(all));
    }
    return result;
  }

  /*
  A box around a common point at a pole that has no other one, or else is undecided. Let the other operand C be at the
  pole P at t0. For all t and all parameters v of the surface away from the pole, C(t) - P = (t - t0) a and S - P = (v -
  v0) b, with vectors in the bounds of C' and of the derivative of S. If no such a and b are parallel, then C(t) = S
  only at P.
  */
  Parameter_box with_neighbourhood(const Pole& pole, Common_point& point) const
  {
    const Parameter_box domain = m_pair.domain();
    const std::size_t surface = m_pair.operand_of(pole.end.parameter);
    Parameter_box result;
    for (const int divisor : {4, 8, 16, 32, 64}) {
      result = point.parameters;
      for (std::size_t j = 0; j < domain.size(); ++j) {
        const Exact_rational margin((domain[j].second - domain[j].first) / divisor);
        result[j].first -= margin;
        result[j].second += margin;
      }
      result = clipped(result, domain);
      const Patch_pair<d> near = m_pair.part(result);
      if (differs(near[surface], m_pair.axis_of(pole.end.parameter), near[1 - surface].tangents(0)))
        return result;
    }
    point = {Intersection_kind::UNDECIDED, result, none(), std::nullopt, false};
    return result;
  }

  // Whether no derivative of a surface by an axis is parallel to a direction, on the parts of the other axis that are
  // small enough.
  static bool differs(const Spline_patch<d>& surface, int axis, const Vector_bounds<d>& direction, int depth = 6)
  {
    if (!may_be_parallel<d>(surface.tangents(axis), direction))
      return true;
    const auto halves = surface.halves(1 - axis);
    return depth > 0 && differs(halves[0], axis, direction, depth - 1) &&
        differs(halves[1], axis, direction, depth - 1);
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTION_FINDER_H
