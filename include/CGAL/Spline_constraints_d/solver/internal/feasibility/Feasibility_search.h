// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_SEARCH_H

#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Box_exclusion.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Critical_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_problem.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_run.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Least_violation.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Rational_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Relaxation.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/exact_quadric_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/solutions_of_equalities.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Branch and bound for one problem. A box is dropped when a constraint, or a combination of them, is violated on all of
it; points are sought in it by relaxation, and by a local minimum of the largest function, whose multipliers are those
of the combination. What is left is split, the least violated boxes first. Boxes in which that minimum is zero as far as
doubles tell hold sets that touch, and are decided by their facets, which are problems with one unknown less, and by the
critical points between.
*/
class Feasibility_search
{
  struct Node
  {
    Double_box box;
    double violation; // of its middle

    bool operator<(const Node& other) const { return violation > other.violation; }
  };

  enum class Fate
  {
    DROPPED,
    FOUND,
    SPLIT,
    ENDED
  };

  const Feasibility_problem& m_problem;
  Feasibility_run& m_run;
  bool m_is_main; // its boxes are the record of the run
  Polynomial_family<Interval> m_enclosures;
  Polynomial_family<double> m_values;
  Rational_points m_points;
  Box_exclusion m_exclusion;
  std::vector<Relation> m_relations;
  Double_box m_root;
  std::vector<double> m_scales; // of the functions: they become about one on the domain
  bool m_has_inequations;
  std::size_t m_equalities, m_nodes = 0;
  std::priority_queue<Node> m_queue;
  std::vector<std::pair<Double_box, std::vector<std::size_t>>> m_touching; // with what may be violated there
  Feasibility_outcome m_outcome{Feasibility::INFEASIBLE, {}, {}, {}};

  // Of the node at hand.
  std::vector<std::size_t> m_active; // inequalities that may be violated
  std::vector<double> m_weights;     // per unknown: how much of the bound is lost in its direction

public:
  Feasibility_search(const Feasibility_problem& problem, Feasibility_run& run, bool is_main)
    : m_problem(problem), m_run(run), m_is_main(is_main),
      m_enclosures(problem.functions(), problem.dimension(), [&run] { run.check(); }),
      m_values(problem.functions(), problem.dimension(), [&run] { run.check(); }), m_points(problem, m_enclosures),
      m_exclusion(problem, m_enclosures, run, is_main),
      m_has_inequations(std::any_of(problem.conditions().begin(), problem.conditions().end(),
                                    [](const auto& c) { return c.relation == Relation::NOT_EQUAL; })),
      m_equalities(problem.number_of_equalities())
  {
    for (const auto& condition : problem.conditions())
      m_relations.push_back(condition.relation);
    for (const auto& range : problem.domain()) {
      const auto [lower, upper] = to_double_range(range);
      m_root.lower.push_back(lower);
      m_root.upper.push_back(range.first < range.second ? upper : lower);
    }
  }

  Feasibility_outcome operator()()
  {
    const std::vector<int> unknowns = m_problem.free_unknowns();
    if (unknowns.empty())
      return outcome_of_point();
    if (std::any_of(m_problem.conditions().begin(), m_problem.conditions().end(), [](const auto& condition) {
          return condition.relation == Relation::NOT_EQUAL && condition.function.is_zero();
        })) {
      m_exclusion.exclude(m_root, std::vector<double>());
      return {Feasibility::INFEASIBLE, {}, {}, {}};
    }
    if (m_equalities >= unknowns.size())
      return outcome_of_square_system(unknowns);
    set_scales();
    push(m_root);
    while (!m_queue.empty() && m_outcome.status != Feasibility::FEASIBLE && !m_run.must_stop()) {
      Double_box box = m_queue.top().box;
      m_queue.pop();
      m_run.add_nodes(1);
      ++m_nodes;
      if (look_at(box) == Fate::SPLIT)
        split(box);
    }
    while (!m_touching.empty() && m_outcome.status != Feasibility::FEASIBLE && !m_run.must_stop()) {
      m_active = m_touching.back().second;
      const Double_box box = m_touching.back().first;
      m_touching.pop_back();
      decide_touching(box);
    }
    if (m_outcome.status != Feasibility::FEASIBLE)
      leave_rest();
    return std::move(m_outcome);
  }

private:
  Feasibility_outcome outcome_of_point() const
  {
    Rational_point point;
    for (const auto& range : m_problem.domain())
      point.push_back(range.first);
    return m_problem.is_satisfied_at(point) ? feasible_in(m_problem.domain(), "exact signs at a rational point")
                                            : Feasibility_outcome{Feasibility::INFEASIBLE, {}, {}, {}};
  }

  // On facets there may be as many equalities as unknowns.
  Feasibility_outcome outcome_of_square_system(const std::vector<int>& unknowns)
  {
    constexpr std::size_t most_nodes = 20000;
    Exact_ranges ranges;
    for (const int j : unknowns)
      ranges.push_back(m_problem.domain()[j]);
    Constraint_system_d system(ranges);
    for (const auto& [function, relation] : m_problem.conditions())
      system.add(renumbered(function, unknowns), relation);
    return outcome_of(solutions_of(system, most_nodes, m_run), m_problem, unknowns, m_points,
                      "a certified solution of the equalities, other unknowns chosen");
  }

  void set_scales()
  {
    m_values.set_point(m_root.middle());
    for (std::size_t i = 0; i < m_problem.size(); ++i) {
      m_run.check();
      const std::vector<double> gradient = m_values.gradient(m_values.coefficients(i)),
                                hessian = m_values.hessian(m_values.coefficients(i));
      double size = 0;
      for (std::size_t j = 0; j < gradient.size(); ++j) {
        size += std::abs(gradient[j]) * m_root.radius(j);
        for (std::size_t k = 0; k < gradient.size(); ++k)
          size += 0.5 * std::abs(hessian[j * gradient.size() + k]) * m_root.radius(j) * m_root.radius(k);
      }
      m_scales.push_back(size > 0 && size < HUGE_VAL ? 1 / size : 1);
    }
  }

  void push(Double_box box)
  {
    m_values.set_point(box.middle());
    double violation = 0;
    for (std::size_t i = 0; i < m_problem.size(); ++i) {
      const double value = m_scales[i] * m_values.value(m_values.coefficients(i));
      violation = (std::max)(violation, m_relations[i] == Relation::EQUAL ? std::abs(value) : value);
    }
    m_queue.push({std::move(box), violation});
  }

  Fate look_at(Double_box& box)
  {
    if (m_exclusion.by_constraints(box, m_active))
      return Fate::DROPPED;
    std::vector<double> point = box.middle();
    if (finds_solution(point, "exact signs at a rational point"))
      return Fate::FOUND;
    if (m_active.empty() && m_equalities == 0)
      return end_if_narrow(box, "the points of a box that were tried lie where a function must not be zero");
    if (relax(point, box))
      return Fate::FOUND;
    const auto must_stop = [this] { return m_run.must_stop(); };
    Least_violation least(m_values, rows(0), box, point, m_equalities == 0, must_stop);
    if (finds_solution(least.point(), "exact signs at a rational point"))
      return Fate::FOUND;
    if (m_exclusion.by_combination(box, least.multipliers(), least.point()))
      return Fate::DROPPED;
    least.refine();
    if (finds_solution(least.point(), "exact signs at a rational point"))
      return Fate::FOUND;
    Fate fate = combine(least, box);
    // It costs more than a node.
    const bool is_tried = m_nodes <= 16 || (m_nodes & (m_nodes - 1)) == 0;
    if (fate == Fate::SPLIT && m_equalities > 0 && is_tried && least.value() < 1e-6 &&
        solves_equalities(least.point(), box))
      return Fate::FOUND;
    return fate == Fate::SPLIT ? end_if_narrow(box, "tolerance") : fate;
  }

  bool finds_solution(const std::vector<double>& point, const char* certificate)
  {
    const auto found = m_points.at(point);
    if (found)
      m_outcome = feasible_in(box_of_point(*found), certificate);
    return found.has_value();
  }

  // With offsets that become smaller, so that small sets are not jumped over. Leaves the last point.
  bool relax(std::vector<double>& point, const Double_box& box)
  {
    double size = 0;
    for (std::size_t j = 0; j < box.size(); ++j)
      size = (std::max)(size, box.radius(j));
    const bool is_first = m_is_main && m_run.path().empty();
    if (is_first)
      m_run.path().push_back(point);
    for (const double offset : {0x1p-4, 0x1p-8}) {
      Relaxation relaxation(m_values, m_relations, 1, offset * size);
      for (int step = 0; step < 8 && relaxation.step(point, box); ++step) {
        if (is_first)
          m_run.path().push_back(point);
        if (m_equalities == 0 && finds_solution(point, "exact signs at a rational point"))
          return true;
      }
    }
    return false;
  }

  // `margin`: by how much, relative to their scales, inequalities are to be satisfied.
  std::vector<Violation_row> rows(double margin) const
  {
    std::vector<Violation_row> result;
    for (const std::size_t i : m_active)
      result.push_back({i, m_scales[i], margin});
    for (std::size_t i = 0; i < m_problem.size(); ++i)
      if (m_relations[i] == Relation::EQUAL) {
        result.push_back({i, m_scales[i]});
        result.push_back({i, -m_scales[i]});
      }
    return result;
  }

  // The combination of a minimum: drops or contracts the box, or decides it where sets touch.
  Fate combine(const Least_violation& least, Double_box& box)
  {
    constexpr double touching = 1e-9;
    const std::vector<double> multipliers = least.multipliers();
    if (m_exclusion.by_combination(box, multipliers, least.point()))
      return Fate::DROPPED;
    set_weights(multipliers, box);
    if (least.value() > touching || least.value() < -touching)
      return Fate::SPLIT;
    if (const auto simple = m_points.simple_near(least.point())) {
      m_outcome = feasible_in(box_of_point(*simple), "exact signs at a rational point where sets touch");
      return Fate::FOUND;
    }
    if (const auto exact = exact_multipliers(m_problem, multipliers, exact_box(box)); !exact.empty()) {
      m_exclusion.exclude(box, exact);
      return Fate::DROPPED;
    }
    // Where the equalities can be solved, the multipliers of both of their signs cancel: then they say nothing.
    double size = 0;
    for (std::size_t i = 0; i < multipliers.size(); ++i)
      size += std::abs(multipliers[i]) / m_scales[i];
    const Convex_bound bound(m_enclosures, m_enclosures.combination(multipliers), box, least.point());
    if (size < 1e-3 || bound.lower() < -touching)
      return Fate::SPLIT;
    if (m_equalities > 0 && solves_equalities(least.point(), box))
      return Fate::FOUND;
    if (solves_tight_constraints(least.point()))
      return Fate::FOUND;
    m_touching.emplace_back(box, m_active); // others may hold points that are found at less cost
    return Fate::ENDED;
  }

  void set_weights(const std::vector<double>& multipliers, const Double_box& box)
  {
    m_values.set_point(box.middle());
    const std::vector<double> hessian = m_values.hessian(m_values.combination(multipliers));
    m_weights.assign(box.size(), 0.0);
    for (std::size_t j = 0; j < box.size(); ++j)
      for (std::size_t k = 0; k < box.size(); ++k)
        m_weights[j] += std::abs(hessian[j * box.size() + k]) * box.radius(j) * box.radius(k);
  }

  // The equalities are solved near the point, after it was moved away from where inequalities are zero, if possible.
  bool solves_equalities(const std::vector<double>& point, const Double_box& box)
  {
    if (m_nodes > 16 && (m_nodes & (m_nodes - 1)) != 0) // it costs more than a node
      return false;
    for (const double margin : {1e-2, 1e-4, 1e-7, 0.0}) {
      if (m_active.empty() && margin > 0)
        continue;
      Least_violation least(m_values, rows(margin), box, point, false, [this] { return m_run.must_stop(); });
      least.refine();
      if (!(least.value() < 1e-9))
        continue;
      if (const auto simple = m_points.simple_near(least.point())) {
        m_outcome = feasible_in(box_of_point(*simple), "exact signs at a rational point");
        return true;
      }
      if (auto found = solution_of_equalities_near(m_problem, m_values, m_root, least.point(), m_run)) {
        m_outcome = feasible_in(std::move(*found), "a certified solution of the equalities, other unknowns chosen");
        return true;
      }
    }
    return false;
  }

  // The same with inequalities that are nearly zero as equalities, as many of them as are independent.
  bool solves_tight_constraints(const std::vector<double>& point)
  {
    if (m_has_inequations)
      return false;
    Feasibility_problem tight(m_problem.domain());
    const std::vector<std::size_t> chosen = independent_constraints(m_values, m_problem, m_active, m_root, point);
    bool is_changed = false;
    for (std::size_t i = 0; i < m_problem.size(); ++i) {
      const bool is_tight =
          m_relations[i] == Relation::LESS_EQUAL && std::find(chosen.begin(), chosen.end(), i) != chosen.end();
      is_changed = is_changed || is_tight;
      tight.add(m_problem[i].function, is_tight ? Relation::EQUAL : m_relations[i]);
    }
    auto found =
        is_changed ? solution_of_equalities_near(tight, m_values, m_root, point, m_run) : std::optional<Exact_ranges>();
    if (found)
      m_outcome = feasible_in(std::move(*found), "a certified point where sets touch");
    return found.has_value();
  }

  Exact_ranges exact_box(const Double_box& box) const
  {
    Exact_ranges result;
    for (int j = 0; j < m_problem.dimension(); ++j) {
      const auto& [lower, upper] = m_problem.domain()[j];
      result.push_back(m_problem.is_free(j) ? std::pair((std::max)(lower, Exact_rational(box.lower[j])),
                                                        (std::min)(upper, Exact_rational(box.upper[j])))
                                            : m_problem.domain()[j]);
    }
    return result;
  }

  // By problems on the facets of the box, and critical points between them.
  void decide_touching(const Double_box& box)
  {
    const Exact_ranges place = exact_box(box);
    Feasibility_problem local(place);
    for (std::size_t i = 0; i < m_problem.size(); ++i)
      if (!m_problem[i].is_inequality() || std::binary_search(m_active.begin(), m_active.end(), i))
        local.add(m_problem[i].function, m_problem[i].relation);
    std::vector<Undecided_part> undecided;
    for (const int j : local.free_unknowns())
      for (const Exact_rational& end : {place[j].first, place[j].second}) {
        Exact_ranges facet = place;
        facet[j] = {end, end};
        const Feasibility_problem on_facet = local.on(facet);
        if (takes(Feasibility_search(on_facet, m_run, false)(), undecided))
          return;
        if (m_has_inequations && undecided.empty() && !is_without_solutions(on_facet.without_inequations()))
          undecided.push_back({place_of(facet), {}, "sets may touch where a function must not be zero"});
      }
    if (local.free_unknowns().empty()) {
      const Feasibility_problem point = local.on(place);
      if (takes(Feasibility_search(point, m_run, false)(), undecided))
        return;
    } else if (takes(Critical_points(local, m_points, m_run)(), undecided))
      return;
    if (undecided.empty()) {
      m_exclusion.exclude(box, std::vector<double>());
      return;
    }
    m_outcome.status = Feasibility::UNDECIDED;
    m_outcome.undecided.push_back({place_of(place), {}, undecided.front().reason});
    m_run.end_at_tolerance();
  }

  bool is_without_solutions(const Feasibility_problem& problem)
  {
    return Feasibility_search(problem, m_run, false)().status == Feasibility::INFEASIBLE;
  }

  // Whether an outcome of a part is a solution, else adds what is undecided.
  bool takes(Feasibility_outcome part, std::vector<Undecided_part>& undecided)
  {
    if (part.status == Feasibility::FEASIBLE) {
      m_outcome = std::move(part);
      return true;
    }
    undecided.insert(undecided.end(), part.undecided.begin(), part.undecided.end());
    return false;
  }

  Fate end_if_narrow(const Double_box& box, const std::string& reason)
  {
    bool can_be_split = false;
    for (std::size_t j = 0; j < box.size(); ++j) {
      const double size = (std::max)({1.0, std::abs(box.lower[j]), std::abs(box.upper[j])}), middle = box.middle(j);
      can_be_split = can_be_split ||
          (box.upper[j] - box.lower[j] > m_run.tolerance() * size && box.lower[j] < middle && middle < box.upper[j]);
    }
    if (can_be_split)
      return Fate::SPLIT;
    leave_undecided(box, reason);
    m_run.end_at_tolerance();
    return Fate::ENDED;
  }

  void leave_undecided(const Double_box& box, const std::string& reason)
  {
    m_outcome.status = Feasibility::UNDECIDED;
    Undecided_part part{{}, {}, reason};
    for (std::size_t j = 0; j < box.size(); ++j)
      part.place.emplace_back(box.lower[j], box.upper[j]);
    m_outcome.undecided.push_back(std::move(part));
  }

  // Where the run has ended early.
  void leave_rest()
  {
    constexpr std::size_t most_told = 1000;
    std::vector<Double_box> rest;
    for (; !m_queue.empty(); m_queue.pop())
      rest.push_back(m_queue.top().box);
    for (const auto& [box, active] : m_touching)
      rest.push_back(box);
    while (rest.size() > most_told) { // the last ones in one box
      Double_box &last = rest[rest.size() - 1], &before = rest[rest.size() - 2];
      for (std::size_t j = 0; j < last.size(); ++j) {
        before.lower[j] = (std::min)(before.lower[j], last.lower[j]);
        before.upper[j] = (std::max)(before.upper[j], last.upper[j]);
      }
      rest.pop_back();
    }
    for (const Double_box& box : rest)
      leave_undecided(box, in_words(m_run.reason()));
  }

  // Among the unknowns whose ranges are nearly the widest, compared with the domain, the one whose curvature costs the
  // most.
  void split(const Double_box& box)
  {
    double widest = 0;
    for (std::size_t j = 0; j < box.size(); ++j)
      if (m_root.radius(j) > 0)
        widest = (std::max)(widest, box.radius(j) / m_root.radius(j));
    std::size_t axis = box.size();
    for (std::size_t j = 0; j < box.size(); ++j) {
      const double middle = box.middle(j);
      if (!(box.lower[j] < middle && middle < box.upper[j]) || box.radius(j) / m_root.radius(j) < 0.45 * widest)
        continue;
      if (axis == box.size() || (j < m_weights.size() && m_weights[j] > m_weights[axis]))
        axis = j;
    }
    if (axis == box.size())
      return leave_undecided(box, "tolerance");
    Double_box lower = box, upper = box;
    lower.upper[axis] = upper.lower[axis] = box.middle(axis);
    push(std::move(lower));
    push(std::move(upper));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_SEARCH_H
