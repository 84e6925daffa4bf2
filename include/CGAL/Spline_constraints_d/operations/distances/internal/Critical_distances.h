// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCES_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distance.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Pair_of_sites.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Site_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <CGAL/number_utils.h>

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
namespace Distances {

/*
The critical points of the squared distance of two operands. For every pair of sites there is a system, whose unknowns
are the parameters of both that are not fixed.

The least distance is looked for in regions that hold all pairs of nearest points. Where a region ends inside of an
operand, there are none.
*/
template <int d>
class Critical_distances
{
  using Site = Spline_site<d>;
  using Pair_of_sites = internal::Distances::Pair_of_sites<d>;
  using Solution = Solution_d<double>;
  using Box = Solution::Exact_box;

  static constexpr int refinements = 128; // of a solution that is not certified

  struct Found
  {
    Pair_of_sites sites;
    std::vector<Box> boxes; // of their parameters, which together hold it
    bool is_exact;
    Critical_distance distance;
  };

  std::array<Spline_patch<d>, 2> m_operands;
  Site_pairs<d> m_pairs;
  Budgeted_solver m_solver;
  Exact_rational m_upper; // no pair of closest points has a larger squared distance
  Exact_rational m_least; // of the bounds of what was found
  std::vector<Found> m_found;
  std::optional<Critical_distance> m_rest; // all pairs of points, where the run ended early
  Undecided_reason m_reason = Undecided_reason::NONE;

public:
  Critical_distances(const Spline_patch<d>& a, const Spline_patch<d>& b, const Joint_rule& rule,
                     const Solver_options& options)
    : m_operands{a, b}, m_pairs(m_operands, rule), m_solver(options),
      m_upper(squared_distance_of<d>(a(a.middle()), b(b.middle())))
  {}

  // All of them, by increasing distance.
  std::vector<Critical_distance> all()
  {
    m_pairs.find_all();
    for (const Pair_of_sites& sites : m_pairs.pairs())
      if (goes_on())
        find_critical_distances(sites);
    for (Found& found : m_found)
      enclose(found);
    return sorted();
  }

  // Those that may be the least distance.
  std::vector<Critical_distance> nearest()
  {
    try {
      m_pairs.find_nearest(m_upper, [this] { m_solver.budget().check(); });
    } catch (const Run_stopped&) { // before there were pairs of sites
      goes_on();
      return sorted();
    }
    for (const Pair_of_sites& sites : m_pairs.pairs())
      if (!is_too_far(squared_norm(sites.a->bounds() - sites.b->bounds())) && goes_on())
        find_critical_distances(sites);
    drop_those_too_far();
    for (Found& found : m_found)
      enclose(found);
    if (goes_on())
      find_crossing();
    drop_those_too_far();
    std::erase_if(m_found, [&](Found& x) {
      return x.distance.kind != Solution_kind::CERTIFIED && !m_solver.must_stop() && is_too_far(refined(x));
    });
    return sorted();
  }

  // After `nearest()`: the square of the least distance lies in this range.
  std::pair<Exact_rational, Exact_rational> least_squared_distance() const { return {m_least, m_upper}; }

  // Why the answers are undecided that are.
  std::vector<Undecided_part> undecided(const std::vector<Critical_distance>& answers) const
  {
    std::vector<Undecided_part> result;
    for (const Critical_distance& answer : answers)
      if (answer.kind == Solution_kind::UNDECIDED) {
        Undecided_part part{double_ranges(m_operands[0].part(answer.ranges[0]).values()),
                            {},
                            in_words(answer.solution ? answer.solution->reason() : m_reason)};
        for (const std::size_t operand : {0, 1})
          if (!answer.ranges[operand].empty())
            part.parameters.push_back({operand, double_ranges(answer.ranges[operand])});
        result.push_back(std::move(part));
      }
    return result;
  }

  Summary summary(const std::vector<Critical_distance>& answers) const
  {
    Summary result = m_solver.total();
    result.is_complete =
        std::none_of(answers.begin(), answers.end(), [](const auto& x) { return x.kind == Solution_kind::UNDECIDED; });
    if (!result.is_complete && result.why_not == Undecided_reason::NONE)
      result.why_not = m_reason;
    return result;
  }

private:
  // Whether the run goes on. Where it ends, there may be others of any parameters.
  bool goes_on()
  {
    if (!m_solver.must_stop())
      return true;
    if (!m_rest) {
      m_reason = m_solver.reason();
      m_rest = Critical_distance{Solution_kind::UNDECIDED, {}, {}, {}, std::nullopt};
      for (const std::size_t operand : {0, 1}) {
        for (int axis = 0; axis < m_operands[operand].number_of_parameters(); ++axis)
          m_rest->ranges[operand].push_back(m_operands[operand].domain(axis));
        m_rest->sample[operand] = m_operands[operand].middle();
      }
      m_rest->squared_distance =
          Rational_interval(squared_norm(m_operands[0].values() - m_operands[1].values()).lower,
                            squared_distance_of<d>(m_operands[0](m_rest->sample[0]), m_operands[1](m_rest->sample[1])));
    }
    return false;
  }

  bool is_too_far(const Rational_interval& squared_distance) const { return squared_distance.lower > m_upper; }

  void drop_those_too_far()
  {
    std::erase_if(m_found, [&](const Found& x) { return is_too_far(x.distance.squared_distance); });
  }

  std::vector<Critical_distance> sorted()
  {
    std::vector<Critical_distance> result;
    for (Found& found : m_found)
      result.push_back(std::move(found.distance));
    if (m_rest)
      result.push_back(*m_rest);
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& x, const auto& y) { return x.squared_distance.lower < y.squared_distance.lower; });
    m_least = result.empty() ? m_upper : result.front().squared_distance.lower;
    return result;
  }

  static std::vector<Unknown> unknowns_in(const Box& box)
  {
    std::vector<std::array<Bound, 2>> ranges;
    for (const auto& [lower, upper] : box)
      ranges.push_back({Bound(lower), Bound(upper)});
    return ranges.empty() ? std::vector<Unknown>() : unknowns(ranges);
  }

  static Box domain_of(const Site& a, const Site& b)
  {
    Box result;
    for (const Spline_patch<d>* patch : {&a.patch(), &b.patch()})
      for (int axis = 0; axis < patch->number_of_parameters(); ++axis)
        result.push_back(patch->domain(axis));
    return result;
  }

  static Box clipped(Box box, const Box& domain)
  {
    for (std::size_t i = 0; i < box.size(); ++i) {
      box[i].first = (std::max)(box[i].first, domain[i].first);
      box[i].second = (std::min)(box[i].second, domain[i].second);
    }
    return box;
  }

  static std::vector<Constraint> distance_constraints(const Site& a, const Site& b, std::span<const Unknown> u)
  {
    const auto of_a = u.first(a.free_axes().size()), of_b = u.subspan(a.free_axes().size());
    std::vector<Constraint> result;
    a.add_constraints(of_a, b.point(of_b), result);
    b.add_constraints(of_b, a.point(of_a), result);
    return result;
  }

  void find_critical_distances(const Pair_of_sites& sites)
  {
    const auto& [a, b, boxes] = sites;
    const std::vector<Unknown> u = unknowns_in(domain_of(*a, *b));
    const std::vector<Constraint> constraints = distance_constraints(*a, *b, u);
    if (u.empty()) {
      if (std::all_of(constraints.begin(), constraints.end(), [](const Constraint& c) {
            return is_satisfied(c.relation, CGAL::sign(c.function.constant_term()));
          }))
        add(sites, Solution_kind::CERTIFIED, {{}}, {}, true, std::nullopt);
      return;
    }
    const Solution_set_d<double> solutions = m_solver(constraints);
    for (const Solution& solution : solutions) {
      if (!goes_on())
        return;
      if (const Box box = sites.with_fixed_parameters(clipped(solution.exact_box(), domain_of(*a, *b)));
          std::any_of(boxes->begin(), boxes->end(), [&](const Box& x) { return meet(x, box); }))
        add_solution(sites, constraints, solution);
    }
  }

  void add_solution(const Pair_of_sites& sites, const std::vector<Constraint>& constraints, const Solution& solution)
  {
    const Box domain = domain_of(*sites.a, *sites.b);
    Box box = clipped(solution.exact_box(), domain);
    std::vector<Exact_rational> simplest;
    for (const auto& [lower, upper] : box)
      simplest.push_back(simplest_rational_between(lower, upper));
    if (!solution.is_certified())
      look_at(sites, simplest);
    else if (is_solution(constraints, simplest))
      for (std::size_t i = 0; i < box.size(); ++i)
        box[i] = {simplest[i], simplest[i]};
    std::vector<Box> boxes(1, box);
    if (!solution.cover().empty()) {
      boxes = solution.cover();
      for (Box& part : boxes)
        part = clipped(std::move(part), domain);
    }
    const bool is_exact = is_connected_continuum(solution, constraints) ||
        std::all_of(box.begin(), box.end(), [](const Parameter_range& x) { return x.first == x.second; });
    const std::vector<Exact_rational> sample = sample_of(solution, boxes.front());
    add(sites, solution.kind(), std::move(boxes), sample, is_exact, solution);
    m_found.back().distance.ranges = sites.ranges_of(box);
  }

  // Bounds of a distance that are close together.
  void enclose(Found& found)
  {
    if (found.is_exact || m_solver.must_stop())
      return;
    const std::optional<Rational_interval> bounds = range_on(found.sites, found.boxes);
    if (!bounds)
      return;
    Rational_interval& range = found.distance.squared_distance;
    range = *bounds;
    const Solution& solution = *found.distance.solution;
    if (range.lower == 0 && range.upper > 0 && is_crossing(found.sites, solution)) {
      range = Rational_interval(Exact_rational(0));
      m_upper = Exact_rational(0);
    } else if (solution.kind() != Solution_kind::UNDECIDED)
      m_upper = (std::min)(m_upper, range.upper);
  }

  // An interval, a segment, or all of the sites: a connected set on which the derivatives of the distance are zero, so
  // that it is constant.
  static bool is_connected_continuum(const Solution& solution, const std::vector<Constraint>& constraints)
  {
    if (solution.kind() != Solution_kind::CONTINUUM)
      return false;
    return solution.box().size() == 1 || !solution.ends().empty() ||
        std::all_of(constraints.begin(), constraints.end(), is_identically_satisfied);
  }

  // Of an equation. Inequalities do not matter.
  static bool is_identically_satisfied(const Constraint& constraint)
  {
    return constraint.relation != Relation::EQUAL || is_zero_everywhere(constraint.spline_function());
  }

  // What the boxes hold together, with the parameters of a point in the first one. Whether it is exact: the distance is
  // that of this point.
  void add(const Pair_of_sites& sites, Solution_kind kind, std::vector<Box> boxes,
           const std::vector<Exact_rational>& sample, bool is_exact, const std::optional<Solution>& solution)
  {
    const Exact_rational at_point = sites.squared_distance_at(sample);
    Critical_distance result{kind,
                             sites.ranges_of(boxes.front()),
                             {},
                             Rational_interval(is_exact ? at_point : Exact_rational(0), at_point),
                             solution};
    Box at_sample;
    for (const Exact_rational& x : sample)
      at_sample.emplace_back(x, x);
    const auto points = sites.ranges_of(at_sample);
    for (const std::size_t operand : {0, 1})
      for (const Parameter_range& x : points[operand])
        result.sample[operand].push_back(x.first);
    m_upper = (std::min)(m_upper, result.squared_distance.upper);
    m_found.push_back({sites, std::move(boxes), is_exact, std::move(result)});
  }

  // In the middle of a segment of solutions, or of a box.
  static std::vector<Exact_rational> sample_of(const Solution& solution, const Box& box)
  {
    std::vector<Exact_rational> result;
    const auto& ends = solution.ends();
    for (std::size_t i = 0; i < box.size(); ++i)
      result.push_back(ends.empty() ? middle_of(box[i]) : middle_of({ends[0][i], ends[1][i]}));
    return result;
  }

  // Of the squared distance; none if the run ends before it is known.
  std::optional<Rational_interval> range_on(const Pair_of_sites& sites, const std::vector<Box>& boxes) const
  {
    std::optional<Rational_interval> result;
    for (const Box& box : boxes) {
      if (m_solver.must_stop())
        return std::nullopt;
      const Rational_interval range = sites.range_on(box);
      result = result ? hull(*result, range) : range;
    }
    return result;
  }

  // With a better bound from below, by subdivision of the boxes with the least bounds.
  const Rational_interval& refined(Found& found) const
  {
    struct Part
    {
      Box box;
      Exact_rational lower;
    };
    Rational_interval& range = found.distance.squared_distance;
    if (found.is_exact)
      return range;
    const auto is_farther = [](const Part& p, const Part& q) { return p.lower > q.lower; };
    std::vector<Part> parts;
    const auto push = [&](Box box) {
      const Exact_rational lower = found.sites.range_on(box).lower;
      parts.push_back({std::move(box), lower});
      std::push_heap(parts.begin(), parts.end(), is_farther);
    };
    for (const Box& box : found.boxes)
      push(box);
    for (int i = 0; i < refinements && !(parts.front().lower > m_upper) && !m_solver.must_stop(); ++i) {
      std::pop_heap(parts.begin(), parts.end(), is_farther);
      Box box = std::move(parts.back().box);
      parts.pop_back();
      const auto is_shorter = [](const Parameter_range& p, const Parameter_range& q) {
        return p.second - p.first < q.second - q.first;
      };
      Parameter_range& longest = *std::max_element(box.begin(), box.end(), is_shorter);
      const Parameter_range whole = longest;
      const Exact_rational quarter((whole.second - whole.first) / 4);
      const Exact_rational cut =
          simplest_rational_between(Exact_rational(whole.first + quarter), Exact_rational(whole.second - quarter));
      longest.second = cut;
      push(box);
      longest = {cut, whole.second};
      push(std::move(box));
    }
    range.lower = (std::max)(range.lower, parts.front().lower);
    return range;
  }

  // A pair of points whose distance is an upper bound of the least one.
  void look_at(const Pair_of_sites& sites, const std::vector<Exact_rational>& parameters)
  {
    m_upper = (std::min)(m_upper, sites.squared_distance_at(parameters));
  }

  static bool is_solution(const std::vector<Constraint>& constraints, const std::vector<Exact_rational>& point)
  {
    return std::all_of(constraints.begin(), constraints.end(), [&](const Constraint& c) {
      return c.relation != Relation::EQUAL || c.symbols->value(c.function, point) == 0;
    });
  }

  // Whether a critical point is a regular solution of A = B, by proof. As such ones are critical points, it is enough
  // that there is one where no other critical point is.
  bool is_crossing(const Pair_of_sites& sites, const Solution& solution)
  {
    const Undecided_reason reason = solution.reason();
    const bool is_regular = solution.is_certified() || reason == Undecided_reason::INEQUALITY ||
        reason == Undecided_reason::DOMAIN_BOUNDARY;
    if (!is_regular || solution.box().size() > d)
      return false;
    const Box region = solution.uniqueness_region().empty() ? solution.exact_box() : solution.exact_uniqueness_region();
    return common_points(*sites.a, *sites.b, clipped(region, domain_of(*sites.a, *sites.b)))
               .count(Solution_kind::CERTIFIED) > 0;
  }

  // With as many parameters as coordinates.
  Solution_set_d<double> common_points(const Site& a, const Site& b, const Box& box)
  {
    const std::vector<Unknown> u = unknowns_in(box);
    const std::span<const Unknown> all(u);
    const Vector_expression<d> difference =
        a.point(all.first(a.free_axes().size())) - b.point(all.subspan(a.free_axes().size()));
    std::vector<Constraint> constraints;
    for (int i = 0; i < d; ++i)
      constraints.push_back(difference[i] == 0);
    return m_solver(constraints);
  }

  // Where an edge crosses the other operand, the distance is critical in all directions: that is a candidate of the
  // sites beside, which may be undecided. One crossing is enough to know that the least distance is zero.
  void find_crossing()
  {
    const bool may_be_zero = m_upper > 0 && std::any_of(m_found.begin(), m_found.end(), [](const Found& x) {
                               return x.distance.squared_distance.lower == 0;
                             });
    for (const Pair_of_sites& sites : m_pairs.pairs()) {
      if (!may_be_zero || !goes_on())
        return;
      const Site &a = *sites.a, &b = *sites.b;
      if (sites.unknowns() != d || squared_norm(a.bounds() - b.bounds()).lower > 0)
        continue;
      const Solution_set_d<double> solutions = common_points(a, b, domain_of(a, b));
      if (solutions.count(Solution_kind::CERTIFIED) == 0)
        continue;
      const Box box = clipped(solutions[0].exact_box(), domain_of(a, b));
      add(sites, Solution_kind::CERTIFIED, {box}, sample_of(solutions[0], box), true, solutions[0]);
      m_found.back().distance.squared_distance = Rational_interval(Exact_rational(0));
      m_upper = Exact_rational(0);
      return;
    }
  }
};

template <int d>
Found_distances<d> located(const std::vector<Critical_distance>& answers, const Spline_patch<d>& first,
                           const Spline_patch<d>& second, const Critical_distances<d>& search)
{
  const auto [least, upper] = search.least_squared_distance();
  Found_distances<d> result{
      {}, {Deferred_rational(least), Deferred_rational(upper)}, search.undecided(answers), search.summary(answers)};
  for (const Critical_distance& answer : answers)
    result.pairs.push_back(located<d>(answer, {first(answer.sample[0]), second(answer.sample[1])}));
  return result;
}

template <int d>
Found_distances<d> projections_of(const Exact_map<d>& point, const Exact_map<d>& object, const Solver_options& options)
{
  const Spline_patch<d> a(point), b(object);
  Critical_distances<d> search(a, b, perpendicular_before, options);
  return located<d>(search.all(), a, b, search);
}

template <int d>
Found_distances<d> nearest_points_of(const Exact_map<d>& first, const Exact_map<d>& second,
                                     const Solver_options& options)
{
  const Spline_patch<d> a(first), b(second);
  Critical_distances<d> search(a, b, least_distance, options);
  return located<d>(search.nearest(), a, b, search);
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCES_H
