// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_INTERSECTION_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_INTERSECTION_FINDER_H

#include <CGAL/Spline_constraints_d/operations/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/internal/Coincidence.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The common points of two patches: the solutions of A = B, told apart by what is known of the ends of parameters. Whether the only solution in a region is at an end is a system in one unknown
less, in that region.

A pole is an edge of a surface that is one point. Where the other operand goes through it, a whole range of parameters stands for one common point. A box of parameters around them is proved to hold
no other one, and is left out.
*/
template <int d>
class Intersection_finder
{
  using Solution = Solution_d<double>;

  // A solution with its parameters, and a region where it is the only one.
  struct Answer
  {
    std::optional<Solution> solution;   // none without unknowns
    Parameter_box parameters, region;
  };

  struct Pole
  {
    std::size_t operand;
    Parameter_end end;
    Spline_patch<d> point;
  };

  Patch_pair<d> m_pair;
  Summing_solver& m_solve;

public:
  Intersection_finder(Patch_pair<d> pair, Summing_solver& solve) : m_pair(std::move(pair)), m_solve(solve) {}

  // Each common point once: on the seam of a closed operand, with the lower parameter.
  std::vector<Common_point> operator()()
  {
    std::vector<Common_point> result = with_seams();
    std::erase_if(result, [&](const Common_point& x) { return is_repeated(x); });
    const auto is_before = [](const Common_point& x, const Common_point& y) {
      return std::lexicographical_compare(x.parameters.begin(), x.parameters.end(), y.parameters.begin(), y.parameters.end());
    };
    std::sort(result.begin(), result.end(), is_before);
    return result;
  }

private:
  // With those on both sides of a seam.
  std::vector<Common_point> with_seams()
  {
    std::vector<Common_point> result;
    std::vector<Parameter_region> regions{{m_pair.domain(), std::vector<bool>(m_pair.number_of_parameters(), false)}};
    for (const Pole& pole : poles())
      for (const Common_point& point : points_at(pole)) {
        std::vector<Parameter_region> rest;
        for (const Parameter_region& region : regions)
          append(rest, without(region, point.neighbourhood));
        regions = std::move(rest);
        result.push_back(point);
      }
    for (const Parameter_region& region : regions)
      for (const Answer& answer : answers(Coincidence<d>(m_pair.part(region.box)), region.is_open))
        result.push_back(classified(answer));
    return result;
  }

  template <class T>
  static void append(std::vector<T>& all, const std::vector<T>& more) { all.insert(all.end(), more.begin(), more.end()); }

  std::vector<Answer> answers(const Coincidence<d>& equations, const std::vector<bool>& is_open)
  {
    std::vector<Answer> result;
    if (equations.unknown_ranges().empty()) {
      if (equations.holds(is_open))
        result.push_back({std::nullopt, equations.all_parameters({}), equations.with_whole_ranges({})});
      return result;
    }
    for (const Solution& solution : m_solve(equations.system(is_open))) {
      const Parameter_box box = solution.exact_box(), region = solution.uniqueness_region().empty() ? box : solution.exact_uniqueness_region();
      result.push_back({solution, equations.all_parameters(box), equations.with_whole_ranges(region)});
    }
    return result;
  }

  std::vector<Answer> answers(const Patch_pair<d>& pair) { return answers(Coincidence<d>(pair), std::vector<bool>(pair.number_of_parameters(), false)); }

  Common_point classified(const Answer& answer)
  {
    Common_point result{kind_of(answer.solution), answer.parameters, std::vector<bool>(m_pair.number_of_parameters(), false), answer.solution, {}};
    if (!is_one_point(answer.solution))
      return result;
    for (const Parameter_end& end : m_pair.ends()) {
      if (!touches(answer.parameters, end))
        continue;
      const CGAL::Uncertain<bool> is_at_end = has_common_point(m_pair.at(end, answer.region));
      if (!CGAL::is_certain(is_at_end))
        return {Intersection_kind::UNDECIDED, answer.parameters, std::vector<bool>(m_pair.number_of_parameters(), false), answer.solution, {}};
      if (CGAL::certainly_not(is_at_end))
        continue;
      result.parameters[end.parameter] = {end.value, end.value};
      result.is_at_end[end.parameter] = true;
      if (result.kind != Intersection_kind::TANGENT)
        result.kind = Intersection_kind::END_POINT;
    }
    return result;
  }

  static Intersection_kind kind_of(const std::optional<Solution>& solution)
  {
    if (!solution)
      return Intersection_kind::TRANSVERSAL;
    switch (solution->kind()) {
    case Solution_kind::CERTIFIED: return Intersection_kind::TRANSVERSAL;
    case Solution_kind::CLUSTER: return Intersection_kind::TANGENT;
    case Solution_kind::CONTINUUM: return Intersection_kind::OVERLAP;
    case Solution_kind::UNDECIDED: break;
    }
    return Intersection_kind::UNDECIDED;
  }

  // One point at most, which is proved to be a common point, or is one if it is at an end.
  static bool is_one_point(const std::optional<Solution>& solution)
  {
    return !solution || solution->kind() == Solution_kind::CERTIFIED || solution->kind() == Solution_kind::CLUSTER || is_undecided_at_end(*solution);
  }

  static bool is_undecided_at_end(const Solution& solution)
  {
    const Undecided_reason reason = solution.reason();
    return reason == Undecided_reason::DOMAIN_BOUNDARY || reason == Undecided_reason::INEQUALITY || reason == Undecided_reason::OVERDETERMINED;
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

  // At the upper end of a closed operand, where the lower one is the same point. A cluster may hold more than that.
  bool is_repeated(const Common_point& x) const
  {
    const bool is_alone = x.kind == Intersection_kind::END_POINT || (x.kind == Intersection_kind::TANGENT && x.solution && x.solution->multiplicity() == 2);
    if (!is_alone)
      return false;
    const std::vector<Parameter_end> ends = m_pair.ends();
    return std::any_of(ends.begin(), ends.end(), [&](const Parameter_end& end) {
      return end.is_upper && x.is_at_end[end.parameter] && x.parameters[end.parameter].first == end.value && m_pair.is_closed(end.parameter);
    });
  }

  std::vector<Pole> poles() const
  {
    std::vector<Pole> result;
    for (const std::size_t operand : {std::size_t(0), std::size_t(1)})
      for (int axis = 0; axis < 2 && m_pair[operand].number_of_parameters() == 2; ++axis)
        for (const bool is_upper : {false, true}) {
          const auto [begin, end] = m_pair[operand].domain(axis);
          const Exact_rational& value = is_upper ? end : begin;
          const Spline_patch<d> edge = m_pair[operand].part(axis, {value, value});
          if (edge.is_one_point())
            result.push_back({operand, {m_pair.first_parameter(operand) + axis, is_upper, value}, Spline_patch<d>(edge(edge.first_corner()))});
        }
    return result;
  }

  // What is proved to be a common point at a pole, with boxes of parameters that hold no other one, or else are undecided.
  std::vector<Common_point> points_at(const Pole& pole)
  {
    std::vector<Common_point> result;
    for (const Common_point& point : Intersection_finder(m_pair.with(pole.operand, pole.point), m_solve).with_seams()) {
      if (point.kind == Intersection_kind::UNDECIDED || point.kind == Intersection_kind::OVERLAP)
        continue;
      Common_point& all = result.emplace_back(Common_point{Intersection_kind::END_POINT, m_pair.domain(), std::vector<bool>(m_pair.number_of_parameters(), false), std::nullopt, {}});
      const std::size_t begin = m_pair.first_parameter(1 - pole.operand);
      std::copy(point.parameters.begin(), point.parameters.end(), all.parameters.begin() + static_cast<std::ptrdiff_t>(begin));
      std::copy(point.is_at_end.begin(), point.is_at_end.end(), all.is_at_end.begin() + static_cast<std::ptrdiff_t>(begin));
      all.parameters[pole.end.parameter] = {pole.end.value, pole.end.value};
      all.is_at_end[pole.end.parameter] = true;
      if (!find_neighbourhood(pole, all)) {
        all.kind = Intersection_kind::UNDECIDED;
        all.parameters = all.neighbourhood;
      }
    }
    return result;
  }

  /*
  Let the other operand be at the pole P at t0. For all t and all parameters v of the surface away from the pole, C(t) - P = (t - t0) a and S - P = (v - v0) b, with vectors in the bounds of C' and
  of the derivative of S. If no such a and b are parallel, then C(t) = S only at P.
  */
  bool find_neighbourhood(const Pole& pole, Common_point& point) const
  {
    constexpr int halvings = 12;
    const Parameter_box domain = m_pair.domain();
    const std::size_t other = 1 - pole.operand, begin = m_pair.first_parameter(pole.operand);
    for (int i = 2; i <= halvings; ++i) {
      point.neighbourhood = point.parameters;
      for (std::size_t j = 0; j < domain.size(); ++j)
        if (j == pole.end.parameter || j < begin || j >= begin + 2) {
          const Exact_rational margin((domain[j].second - domain[j].first) / (1 << i));
          point.neighbourhood[j].first -= margin;
          point.neighbourhood[j].second += margin;
        }
      point.neighbourhood = clipped(point.neighbourhood, domain);
      const Patch_pair<d> near = m_pair.part(point.neighbourhood);
      const int axis = static_cast<int>(pole.end.parameter - begin);
      if (near[other].number_of_parameters() == 0 ? is_nonzero(near[pole.operand], axis) : differs(near[pole.operand], axis, near[other].tangents(0)))
        return true;
    }
    return false;
  }

  static bool has_zero(const Rational_interval& x) { return x.lower <= 0 && x.upper >= 0; }

  static bool are_parallel(const Vector_bounds<d>& a, const Vector_bounds<d>& b)
  {
    for (int i = 0; i < d; ++i)
      for (int k = 0; k < i; ++k)
        if (!has_zero(a[i] * b[k] - a[k] * b[i]))
          return false;
    return true;
  }

  static bool is_nonzero(const Spline_patch<d>& surface, int axis)
  {
    return holds_on_parts(surface, axis, [](const Vector_bounds<d>& tangent) { return !std::all_of(tangent.begin(), tangent.end(), has_zero); });
  }

  static bool differs(const Spline_patch<d>& surface, int axis, const Vector_bounds<d>& direction)
  {
    return holds_on_parts(surface, axis, [&](const Vector_bounds<d>& tangent) { return !are_parallel(tangent, direction); });
  }

  // Whether the derivatives by an axis have a property, on the parts of the other axis that are small enough.
  template <class Property>
  static bool holds_on_parts(const Spline_patch<d>& surface, int axis, const Property& property, int depth = 6)
  {
    if (property(surface.tangents(axis)))
      return true;
    const auto halves = surface.halves(1 - axis);
    return depth > 0 && holds_on_parts(halves[0], axis, property, depth - 1) && holds_on_parts(halves[1], axis, property, depth - 1);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_INTERSECTION_FINDER_H
