// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CRITICAL_DISTANCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CRITICAL_DISTANCES_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_site.h>
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

// Parameters of two operands where the derivatives of their distance are as a `Joint_rule` asks.
struct Critical_distance
{
  Solution_kind kind;
  std::array<std::vector<Parameter_range>, 2> ranges;
  std::array<std::vector<Exact_rational>, 2> sample;   // in these ranges
  Rational_interval squared_distance;
  std::optional<Solution_d<double>> solution;
};

/*
The critical points of the squared distance of two operands. For every pair of sites there is a system, whose unknowns are the parameters of both that are not fixed.
*/
template <int d>
class Critical_distances
{
  using Site = Spline_site<d>;
  using Solution = Solution_d<double>;
  using Box = Solution::Exact_box;

  static constexpr int refinements = 128;   // of a solution that is not certified

  struct Found
  {
    const Site *a, *b;
    std::vector<Box> boxes;   // of their parameters, which together hold it
    Critical_distance distance;
  };

  std::array<std::vector<Site>, 2> m_sites;
  Subdivision_solver_d<Certified_solver_traits> m_solver;
  Exact_rational m_upper;   // no pair of closest points has a larger squared distance
  Exact_rational m_least;   // of the bounds of what was found
  std::vector<Found> m_found;
  Summary m_summary;

public:
  Critical_distances(const Spline_patch<d>& a, const Spline_patch<d>& b, const Joint_rule& rule, const Solver_options& options)
    : m_sites{sites_of(a, rule), sites_of(b, rule)}, m_solver(options), m_upper(squared_distance_of<d>(a(a.middle()), b(b.middle())))
  {}

  // All of them, by increasing distance.
  std::vector<Critical_distance> all()
  {
    for (const Site& a : m_sites[0])
      for (const Site& b : m_sites[1])
        find_critical_distances(a, b);
    for (Found& found : m_found)
      enclose(found);
    return sorted();
  }

  // Those that may be the least distance.
  std::vector<Critical_distance> nearest()
  {
    for (const auto& [a, b] : pairs_of_sites())
      if (!is_too_far(squared_norm(a->bounds() - b->bounds())))
        find_critical_distances(*a, *b);
    drop_those_too_far();
    for (Found& found : m_found)
      enclose(found);
    find_crossing();
    drop_those_too_far();
    std::erase_if(m_found, [&](Found& x) { return x.distance.kind != Solution_kind::CERTIFIED && is_too_far(refined(x)); });
    return sorted();
  }

  // After `nearest()`: the square of the least distance lies in this range.
  std::pair<Exact_rational, Exact_rational> least_squared_distance() const { return {m_least, m_upper}; }

  const Summary& summary() const { return m_summary; }

private:
  bool is_too_far(const Rational_interval& squared_distance) const { return squared_distance.lower > m_upper; }

  void drop_those_too_far() { std::erase_if(m_found, [&](const Found& x) { return is_too_far(x.distance.squared_distance); }); }

  // Those with few unknowns first: they make others too far.
  std::vector<std::pair<const Site*, const Site*>> pairs_of_sites() const
  {
    std::vector<std::pair<const Site*, const Site*>> result;
    for (const Site& a : m_sites[0])
      for (const Site& b : m_sites[1])
        result.emplace_back(&a, &b);
    const auto unknowns = [](const auto& pair) { return pair.first->free_axes().size() + pair.second->free_axes().size(); };
    std::stable_sort(result.begin(), result.end(), [&](const auto& x, const auto& y) { return unknowns(x) < unknowns(y); });
    return result;
  }

  std::vector<Critical_distance> sorted()
  {
    std::vector<Critical_distance> result;
    for (Found& found : m_found)
      result.push_back(std::move(found.distance));
    std::stable_sort(result.begin(), result.end(), [](const auto& x, const auto& y) { return x.squared_distance.lower < y.squared_distance.lower; });
    m_summary.is_complete = std::none_of(result.begin(), result.end(), [](const auto& x) { return x.kind == Solution_kind::UNDECIDED; });
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

  void find_critical_distances(const Site& a, const Site& b)
  {
    const std::vector<Unknown> u = unknowns_in(domain_of(a, b));
    const std::vector<Constraint> constraints = distance_constraints(a, b, u);
    if (u.empty()) {
      if (std::all_of(constraints.begin(), constraints.end(), [](const Constraint& c) { return is_satisfied(c.relation, CGAL::sign(c.function.constant_term())); }))
        add(a, b, Solution_kind::CERTIFIED, {}, {}, std::nullopt);
      return;
    }
    const Solution_set_d<double> solutions = m_solver(make_system(constraints));
    m_summary += solutions.summary();
    for (const Solution& solution : solutions)
      add_solution(a, b, constraints, solution);
  }

  void add_solution(const Site& a, const Site& b, const std::vector<Constraint>& constraints, const Solution& solution)
  {
    const Box domain = domain_of(a, b);
    Box box = clipped(solution.exact_box(), domain);
    std::vector<Exact_rational> simplest;
    for (const auto& [lower, upper] : box)
      simplest.push_back(simplest_rational_between(lower, upper));
    if (!solution.is_certified())
      look_at(a, b, simplest);
    else if (is_solution(constraints, simplest))
      for (std::size_t i = 0; i < box.size(); ++i)
        box[i] = {simplest[i], simplest[i]};
    std::vector<Box> boxes(1, box);
    if (!solution.cover().empty()) {
      boxes = solution.cover();
      for (Box& part : boxes)
        part = clipped(std::move(part), domain);
    }
    const std::vector<Exact_rational> sample = sample_of(solution, boxes.front());
    add(a, b, solution.kind(), box, sample, solution);
    m_found.back().boxes = boxes;
    if (!is_connected_continuum(solution, constraints))
      m_found.back().distance.squared_distance = hull_of(boxes, [&](const Box& part) { return rough_range(a, b, part); });
  }

  // Brings bounds of a distance that may matter close together.
  void enclose(Found& found)
  {
    Rational_interval& range = found.distance.squared_distance;
    if (range.lower == range.upper)
      return;
    range = hull_of(found.boxes, [&](const Box& part) { return range_on(*found.a, *found.b, part); });
    const Solution& solution = *found.distance.solution;
    if (range.lower == 0 && range.upper > 0 && is_crossing(*found.a, *found.b, solution)) {
      range = Rational_interval(Exact_rational(0));
      m_upper = Exact_rational(0);
    } else if (solution.kind() != Solution_kind::UNDECIDED)
      m_upper = (std::min)(m_upper, range.upper);
  }

  // An interval, a segment, or all of the sites: a connected set on which the derivatives of the distance are zero, so that it is constant.
  static bool is_connected_continuum(const Solution& solution, const std::vector<Constraint>& constraints)
  {
    if (solution.kind() != Solution_kind::CONTINUUM)
      return false;
    return solution.box().size() == 1 || !solution.ends().empty() || std::all_of(constraints.begin(), constraints.end(), is_identically_satisfied);
  }

  // Of an equation. Inequalities do not matter.
  static bool is_identically_satisfied(const Constraint& constraint)
  {
    if (constraint.relation != Relation::EQUAL)
      return true;
    const auto is_zero = [](const std::vector<Exact_rational>& piece) { return std::all_of(piece.begin(), piece.end(), [](const Exact_rational& x) { return x == 0; }); };
    const Spline_function function = constraint.spline_function();
    return std::all_of(function.terms().begin(), function.terms().end(), [&](const Spline_term& term) {
      return std::all_of(term.pieces.begin(), term.pieces.end(), is_zero);
    });
  }

  void add(const Site& a, const Site& b, Solution_kind kind, const Box& box, const std::vector<Exact_rational>& sample, const std::optional<Solution>& solution)
  {
    Critical_distance result{kind, {a.ranges(), b.ranges()}, {}, Rational_interval(squared_distance_at(a, b, sample)), solution};
    std::size_t next = 0;
    for (const auto& [operand, site] : {std::pair(0, &a), std::pair(1, &b)}) {
      for (const Parameter_range& range : result.ranges[operand])
        result.sample[operand].push_back(range.first);
      for (int axis : site->free_axes()) {
        result.ranges[operand][axis] = box[next];
        result.sample[operand][axis] = sample[next++];
      }
    }
    m_upper = (std::min)(m_upper, result.squared_distance.upper);
    m_found.push_back({&a, &b, {box}, std::move(result)});
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

  static Exact_rational squared_distance_at(const Site& a, const Site& b, const std::vector<Exact_rational>& point)
  {
    const std::span<const Exact_rational> parameters(point);
    const auto split = static_cast<std::size_t>(a.patch().number_of_parameters());
    return squared_distance_of<d>(a.patch()(parameters.first(split)), b.patch()(parameters.subspan(split)));
  }

  static Rational_interval range_on(const Site& a, const Site& b, const Box& box)
  {
    const auto split = box.begin() + a.patch().number_of_parameters();
    return squared_distance_bounds<d>(a.patch().part(Box(box.begin(), split)), b.patch().part(Box(split, box.end())));
  }

  template <class Range_on>
  static Rational_interval hull_of(const std::vector<Box>& boxes, const Range_on& range_on)
  {
    Rational_interval result = range_on(boxes.front());
    for (std::size_t i = 1; i < boxes.size(); ++i)
      result = hull(result, range_on(boxes[i]));
    return result;
  }

  // The same from the bounds of the derivatives on the sites.
  static Rational_interval rough_range(const Site& a, const Site& b, const Box& box)
  {
    const Vector_bounds<d> offset = a.bounds() - b.bounds();
    Rational_interval result(squared_distance_at(a, b, middle_of(box)));
    std::size_t axis = 0;
    for (const Site* site : {&a, &b})
      for (const Vector_bounds<d>& tangent : site->tangents()) {
        const Exact_rational width(box[axis].second - box[axis].first);   // twice the distance from the middle, and the derivative is twice the inner product
        result = result + dot(offset, tangent) * Rational_interval(Exact_rational(-width), width);
        ++axis;
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
    if (range.lower == range.upper)
      return range;
    const auto is_farther = [](const Part& p, const Part& q) { return p.lower > q.lower; };
    std::vector<Part> parts;
    const auto push = [&](Box box) {
      const Exact_rational lower = range_on(*found.a, *found.b, box).lower;
      parts.push_back({std::move(box), lower});
      std::push_heap(parts.begin(), parts.end(), is_farther);
    };
    for (const Box& box : found.boxes)
      push(box);
    for (int i = 0; i < refinements && !(parts.front().lower > m_upper); ++i) {
      std::pop_heap(parts.begin(), parts.end(), is_farther);
      Box box = std::move(parts.back().box);
      parts.pop_back();
      const auto is_shorter = [](const Parameter_range& p, const Parameter_range& q) { return p.second - p.first < q.second - q.first; };
      Parameter_range& longest = *std::max_element(box.begin(), box.end(), is_shorter);
      const Parameter_range whole = longest;
      const Exact_rational quarter((whole.second - whole.first) / 4);
      const Exact_rational cut = simplest_rational_between(Exact_rational(whole.first + quarter), Exact_rational(whole.second - quarter));
      longest.second = cut;
      push(box);
      longest = {cut, whole.second};
      push(std::move(box));
    }
    range.lower = (std::max)(range.lower, parts.front().lower);
    return range;
  }

  // A pair of points whose distance is an upper bound of the least one.
  void look_at(const Site& a, const Site& b, const std::vector<Exact_rational>& parameters)
  {
    m_upper = (std::min)(m_upper, squared_distance_at(a, b, parameters));
  }

  static bool is_solution(const std::vector<Constraint>& constraints, const std::vector<Exact_rational>& point)
  {
    return std::all_of(constraints.begin(), constraints.end(), [&](const Constraint& c) {
      return c.relation != Relation::EQUAL || c.symbols->value(c.function, point) == 0;
    });
  }

  // Whether a critical point is a regular solution of A = B, by proof. As such ones are critical points, it is enough that there is one where no other critical point is.
  bool is_crossing(const Site& a, const Site& b, const Solution& solution) const
  {
    const Undecided_reason reason = solution.reason();
    const bool is_regular = solution.is_certified() || reason == Undecided_reason::INEQUALITY || reason == Undecided_reason::DOMAIN_BOUNDARY;
    if (!is_regular || solution.box().size() > d)
      return false;
    const Box region = solution.uniqueness_region().empty() ? solution.exact_box() : solution.exact_uniqueness_region();
    return common_points(a, b, clipped(region, domain_of(a, b))).count(Solution_kind::CERTIFIED) > 0;
  }

  // With as many parameters as coordinates.
  Solution_set_d<double> common_points(const Site& a, const Site& b, const Box& box) const
  {
    const std::vector<Unknown> u = unknowns_in(box);
    const std::span<const Unknown> all(u);
    const Vector_expression<d> difference = a.point(all.first(a.free_axes().size())) - b.point(all.subspan(a.free_axes().size()));
    std::vector<Constraint> constraints;
    for (int i = 0; i < d; ++i)
      constraints.push_back(difference[i] == 0);
    return m_solver(make_system(constraints));
  }

  // Where an edge crosses the other operand, the distance is critical in all directions: that is a candidate of the sites beside, which may be undecided. One crossing is
  // enough to know that the least distance is zero.
  void find_crossing()
  {
    const bool may_be_zero = m_upper > 0 && std::any_of(m_found.begin(), m_found.end(), [](const Found& x) { return x.distance.squared_distance.lower == 0; });
    for (const auto& [a, b] : pairs_of_sites()) {
      if (!may_be_zero || a->free_axes().size() + b->free_axes().size() != d || squared_norm(a->bounds() - b->bounds()).lower > 0)
        continue;
      const Solution_set_d<double> solutions = common_points(*a, *b, domain_of(*a, *b));
      m_summary += solutions.summary();
      if (solutions.count(Solution_kind::CERTIFIED) == 0)
        continue;
      const Box box = clipped(solutions[0].exact_box(), domain_of(*a, *b));
      add(*a, *b, Solution_kind::CERTIFIED, box, sample_of(solutions[0], box), solutions[0]);
      m_found.back().boxes = {box};
      m_found.back().distance.squared_distance = Rational_interval(Exact_rational(0));
      m_upper = Exact_rational(0);
      return;
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CRITICAL_DISTANCES_H
