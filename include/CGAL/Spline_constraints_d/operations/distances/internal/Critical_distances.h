// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCES_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Nearest_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

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
The critical points of the squared distance of two operands. For every pair of sites there is a system, whose unknowns
are the parameters of both that are not fixed.

The least distance is looked for in regions that hold all pairs of nearest points. Where a region ends inside of an
operand, there are none.
*/
template <int d>
class Critical_distances
{
  using Site = Spline_site<d>;
  using Solution = Solution_d<double>;
  using Box = Solution::Exact_box;

  static constexpr int refinements = 128;   // of a solution that is not certified

  struct Region
  {
    std::array<std::vector<Site>, 2> sites;
    std::vector<Box> boxes;   // of all parameters, which together hold the pairs that are looked for
  };

  struct Pair_of_sites
  {
    const Site *a, *b;
    const Region* region;
  };

  struct Found
  {
    Pair_of_sites sites;
    std::vector<Box> boxes;   // of their parameters, which together hold it
    bool is_exact;
    Critical_distance distance;
  };

  std::array<Spline_patch<d>, 2> m_operands;
  Joint_rule m_rule;
  std::array<std::vector<std::vector<Axis_part>>, 2> m_parts;
  std::vector<Region> m_regions;
  Subdivision_solver_d<Certified_solver_traits> m_solver;
  Exact_rational m_upper;   // no pair of closest points has a larger squared distance
  Exact_rational m_least;   // of the bounds of what was found
  std::vector<Found> m_found;
  Summary m_summary;

public:
  Critical_distances(const Spline_patch<d>& a, const Spline_patch<d>& b, const Joint_rule& rule,
                     const Solver_options& options)
    : m_operands{a, b}, m_rule(rule), m_parts{parts_of_axes(a, rule), parts_of_axes(b, rule)}, m_solver(options),
      m_upper(squared_distance_of<d>(a(a.middle()), b(b.middle())))
  {}

  // All of them, by increasing distance.
  std::vector<Critical_distance> all()
  {
    m_regions = {
        {{sites_of(m_operands[0], m_parts[0], m_rule), sites_of(m_operands[1], m_parts[1], m_rule)}, {whole_domain()}}};
    for (const Pair_of_sites& sites : pairs_of_sites())
      find_critical_distances(sites);
    for (Found& found : m_found)
      enclose(found);
    return sorted();
  }

  // Those that may be the least distance.
  std::vector<Critical_distance> nearest()
  {
    find_regions();
    for (const Pair_of_sites& sites : pairs_of_sites())
      if (!is_too_far(squared_norm(sites.a->bounds() - sites.b->bounds())))
        find_critical_distances(sites);
    drop_those_too_far();
    for (Found& found : m_found)
      enclose(found);
    find_crossing();
    drop_those_too_far();
    std::erase_if(m_found,
                  [&](Found& x) { return x.distance.kind != Solution_kind::CERTIFIED && is_too_far(refined(x)); });
    return sorted();
  }

  // After `nearest()`: the square of the least distance lies in this range.
  std::pair<Exact_rational, Exact_rational> least_squared_distance() const { return {m_least, m_upper}; }

  const Summary& summary() const { return m_summary; }

private:
  bool is_too_far(const Rational_interval& squared_distance) const { return squared_distance.lower > m_upper; }

  void drop_those_too_far()
  {
    std::erase_if(m_found, [&](const Found& x) { return is_too_far(x.distance.squared_distance); });
  }

  Box whole_domain() const
  {
    Box result;
    for (const Spline_patch<d>& operand : m_operands)
      for (int axis = 0; axis < operand.number_of_parameters(); ++axis)
        result.push_back(operand.domain(axis));
    return result;
  }

  // The joints of an operand, by its breaks. Both ends of a closed axis are the same.
  Joints joints_of(std::size_t operand) const
  {
    Joints result;
    for (int axis = 0; axis < m_operands[operand].number_of_parameters(); ++axis) {
      const std::vector<Exact_rational> breaks = m_operands[operand].breaks(axis);
      std::vector<bool>& is_joint = result.emplace_back(breaks.size(), false);
      for (const Axis_part& part : m_parts[operand][axis])
        if (part.range.first == part.range.second)
          is_joint[static_cast<std::size_t>(std::lower_bound(breaks.begin(), breaks.end(), part.range.first) -
                                            breaks.begin())] = true;
      if (m_operands[operand].is_closed(axis))
        is_joint.back() = is_joint.front();
    }
    return result;
  }

  // Cells that may hold nearest points are in one region if they are neighbours.
  void find_regions()
  {
    const Nearest_parts<d> nearest(m_operands[0], m_operands[1], {joints_of(0), joints_of(1)}, m_upper);
    if (std::isfinite(nearest.upper()))   // as squares of doubles need not be
      m_upper = (std::min)(m_upper, to_rational(nearest.upper()));
    const std::vector<Box> boxes = nearest.boxes();
    for (const Box& hull : separate_hulls(nearest.boxes_of_cells())) {
      Region& region = m_regions.emplace_back();
      std::size_t next = 0;
      for (const std::size_t operand : {0, 1}) {
        std::vector<std::vector<Axis_part>> parts;
        for (const std::vector<Axis_part>& all : m_parts[operand])
          parts.push_back(parts_within(all, hull[next++]));
        region.sites[operand] = sites_of(m_operands[operand], parts, m_rule);
      }
      std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(region.boxes),
                   [&](const Box& box) { return meet(box, hull); });
    }
  }

  static bool meet(const Box& a, const Box& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(), [](const Parameter_range& x, const Parameter_range& y) {
      return x.first <= y.second && y.first <= x.second;
    });
  }

  // Whether a box may hold one of the pairs that are looked for, with the parameters of these sites: those of a piece
  // are not at a joint where the derivative is not zero.
  static bool may_be_in(const Box& box, const Pair_of_sites& sites)
  {
    Box ranges = sites.a->ranges();
    const Box others = sites.b->ranges();
    ranges.insert(ranges.end(), others.begin(), others.end());
    return std::equal(
        box.begin(), box.end(), ranges.begin(), [](const Parameter_range& x, const Parameter_range& range) {
          return range.first == range.second ? x.first <= range.first && range.first <= x.second
                                             : x.first < x.second && x.first < range.second && range.first < x.second;
        });
  }

  // Those with few unknowns first: they make others too far.
  std::vector<Pair_of_sites> pairs_of_sites() const
  {
    std::vector<Pair_of_sites> result;
    for (const Region& region : m_regions)
      for (const Site& a : region.sites[0])
        for (const Site& b : region.sites[1]) {
          const Pair_of_sites sites{&a, &b, &region};
          if (std::any_of(region.boxes.begin(), region.boxes.end(),
                          [&](const Box& box) { return may_be_in(box, sites); }))
            result.push_back(sites);
        }
    const auto unknowns = [](const Pair_of_sites& sites) {
      return sites.a->free_axes().size() + sites.b->free_axes().size();
    };
    std::stable_sort(result.begin(), result.end(),
                     [&](const auto& x, const auto& y) { return unknowns(x) < unknowns(y); });
    return result;
  }

  std::vector<Critical_distance> sorted()
  {
    std::vector<Critical_distance> result;
    for (Found& found : m_found)
      result.push_back(std::move(found.distance));
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& x, const auto& y) { return x.squared_distance.lower < y.squared_distance.lower; });
    m_summary.is_complete =
        std::none_of(result.begin(), result.end(), [](const auto& x) { return x.kind == Solution_kind::UNDECIDED; });
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
    const auto& [a, b, region] = sites;
    const std::vector<Unknown> u = unknowns_in(domain_of(*a, *b));
    const std::vector<Constraint> constraints = distance_constraints(*a, *b, u);
    if (u.empty()) {
      if (std::all_of(constraints.begin(), constraints.end(), [](const Constraint& c) {
            return is_satisfied(c.relation, CGAL::sign(c.function.constant_term()));
          }))
        add(sites, Solution_kind::CERTIFIED, {{}}, {}, true, std::nullopt);
      return;
    }
    const Solution_set_d<double> solutions = m_solver(make_system(constraints));
    m_summary += solutions.summary();
    for (const Solution& solution : solutions)
      if (const Box box = with_fixed_parameters(sites, clipped(solution.exact_box(), domain_of(*a, *b)));
          std::any_of(region->boxes.begin(), region->boxes.end(), [&](const Box& x) { return meet(x, box); }))
        add_solution(sites, constraints, solution);
  }

  // All parameters, where those that are free are in a box.
  static Box with_fixed_parameters(const Pair_of_sites& sites, const Box& box)
  {
    Box result;
    auto next = box.begin();
    for (const Site* site : {sites.a, sites.b}) {
      const Box ranges = site->ranges();
      for (int axis = 0; axis < static_cast<int>(ranges.size()); ++axis)
        result.push_back(std::find(site->free_axes().begin(), site->free_axes().end(), axis) != site->free_axes().end()
                             ? *next++
                             : ranges[axis]);
    }
    return result;
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
    m_found.back().distance.ranges = ranges_of(sites, box);
  }

  // Bounds of a distance that are close together.
  void enclose(Found& found)
  {
    if (found.is_exact)
      return;
    Rational_interval& range = found.distance.squared_distance;
    range = hull_of(found.boxes, [&](const Box& part) { return range_on(found.sites, part); });
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

  static std::array<std::vector<Parameter_range>, 2> ranges_of(const Pair_of_sites& sites, const Box& box)
  {
    const Box all = with_fixed_parameters(sites, box);
    const auto split = all.begin() + static_cast<std::ptrdiff_t>(sites.a->ranges().size());
    return {std::vector<Parameter_range>(all.begin(), split), std::vector<Parameter_range>(split, all.end())};
  }

  // What the boxes hold together, with the parameters of a point in the first one. Whether it is exact: the distance is
  // that of this point.
  void add(const Pair_of_sites& sites, Solution_kind kind, std::vector<Box> boxes,
           const std::vector<Exact_rational>& sample, bool is_exact, const std::optional<Solution>& solution)
  {
    const Exact_rational at_point = squared_distance_at(sites, sample);
    Critical_distance result{kind,
                             ranges_of(sites, boxes.front()),
                             {},
                             Rational_interval(is_exact ? at_point : Exact_rational(0), at_point),
                             solution};
    Box at_sample;
    for (const Exact_rational& x : sample)
      at_sample.emplace_back(x, x);
    const auto points = ranges_of(sites, at_sample);
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

  static Exact_rational squared_distance_at(const Pair_of_sites& sites, const std::vector<Exact_rational>& point)
  {
    const std::span<const Exact_rational> parameters(point);
    const auto split = static_cast<std::size_t>(sites.a->patch().number_of_parameters());
    return squared_distance_of<d>(sites.a->patch()(parameters.first(split)),
                                  sites.b->patch()(parameters.subspan(split)));
  }

  static Rational_interval range_on(const Pair_of_sites& sites, const Box& box)
  {
    const auto split = box.begin() + sites.a->patch().number_of_parameters();
    return squared_distance_bounds<d>(sites.a->patch().part(Box(box.begin(), split)),
                                      sites.b->patch().part(Box(split, box.end())));
  }

  template <class Range_on>
  static Rational_interval hull_of(const std::vector<Box>& boxes, const Range_on& range_on)
  {
    Rational_interval result = range_on(boxes.front());
    for (std::size_t i = 1; i < boxes.size(); ++i)
      result = hull(result, range_on(boxes[i]));
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
      const Exact_rational lower = range_on(found.sites, box).lower;
      parts.push_back({std::move(box), lower});
      std::push_heap(parts.begin(), parts.end(), is_farther);
    };
    for (const Box& box : found.boxes)
      push(box);
    for (int i = 0; i < refinements && !(parts.front().lower > m_upper); ++i) {
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
    m_upper = (std::min)(m_upper, squared_distance_at(sites, parameters));
  }

  static bool is_solution(const std::vector<Constraint>& constraints, const std::vector<Exact_rational>& point)
  {
    return std::all_of(constraints.begin(), constraints.end(), [&](const Constraint& c) {
      return c.relation != Relation::EQUAL || c.symbols->value(c.function, point) == 0;
    });
  }

  // Whether a critical point is a regular solution of A = B, by proof. As such ones are critical points, it is enough
  // that there is one where no other critical point is.
  bool is_crossing(const Pair_of_sites& sites, const Solution& solution) const
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
  Solution_set_d<double> common_points(const Site& a, const Site& b, const Box& box) const
  {
    const std::vector<Unknown> u = unknowns_in(box);
    const std::span<const Unknown> all(u);
    const Vector_expression<d> difference =
        a.point(all.first(a.free_axes().size())) - b.point(all.subspan(a.free_axes().size()));
    std::vector<Constraint> constraints;
    for (int i = 0; i < d; ++i)
      constraints.push_back(difference[i] == 0);
    return m_solver(make_system(constraints));
  }

  // Where an edge crosses the other operand, the distance is critical in all directions: that is a candidate of the
  // sites beside, which may be undecided. One crossing is enough to know that the least distance is zero.
  void find_crossing()
  {
    const bool may_be_zero = m_upper > 0 && std::any_of(m_found.begin(), m_found.end(), [](const Found& x) {
                               return x.distance.squared_distance.lower == 0;
                             });
    for (const Pair_of_sites& sites : pairs_of_sites()) {
      const Site &a = *sites.a, &b = *sites.b;
      if (!may_be_zero || a.free_axes().size() + b.free_axes().size() != d ||
          squared_norm(a.bounds() - b.bounds()).lower > 0)
        continue;
      const Solution_set_d<double> solutions = common_points(a, b, domain_of(a, b));
      m_summary += solutions.summary();
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

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCES_H
