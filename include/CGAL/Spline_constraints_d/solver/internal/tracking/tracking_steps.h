// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKING_STEPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKING_STEPS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Tracker_options.h>
#include <CGAL/Spline_constraints_d/solver/Tracking_step.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_run.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Relaxation.h>
#include <CGAL/Spline_constraints_d/solver/internal/tracking/Tracked_formulas.h>
#include <CGAL/Spline_constraints_d/solver/internal/tracking/Tracked_values.h>
#include <CGAL/Spline_constraints_d/solver/internal/tracking/conditions_at_time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The domains and constraints of a tracker, the last point, and, made again after a change, the graph.
class Tracking
{
  struct Graph
  {
    Tracked_formulas formulas;
    Tracked_values values;

    Graph(const std::vector<Linked_domain>& domains, int time,
          const std::vector<std::optional<Constraint>>& constraints)
      : formulas(domains, time, constraints), values(formulas)
    {}
  };

  Tracker_options m_options;
  int m_time;
  std::vector<Linked_domain> m_domains;
  std::vector<std::optional<Constraint>> m_constraints; // none where one was removed
  std::vector<Exact_rational> m_point;
  std::unique_ptr<Graph> m_graph;

public:
  Tracking(const Unknown& time, std::vector<Exact_rational> start, const Tracker_options& options)
    : m_options(options), m_time(time.index()), m_domains{{time.symbols(), {}}}, m_point(std::move(start))
  {
    m_options.check();
    check_count(m_point.size(), domain().size(), "Constraint_tracker: coordinates of the start");
    if (domain().size() < 2)
      throw Invalid_input("Constraint_tracker: no unknown was made together with the time");
    for (std::size_t j = 0; j < m_point.size(); ++j)
      m_point[j] = in_domain(j, m_point[j]);
  }

  const std::vector<Exact_rational>& point() const { return m_point; }

  void link(std::span<const Unknown> unknowns, std::vector<Expression> formulas)
  {
    if (unknowns.empty())
      throw Invalid_input("Constraint_tracker: no unknowns to link");
    const std::shared_ptr<Symbol_table>& symbols = unknowns[0].symbols();
    const Unknown_domains& ranges = symbols->domains();
    check_count(unknowns.size(), ranges.size(), "Constraint_tracker: unknowns to link");
    check_count(formulas.size(), unknowns.size(), "Constraint_tracker: formulas for unknowns");
    if (index_of_domain(m_domains, symbols.get()))
      throw Invalid_input("Constraint_tracker: the unknowns are linked already");
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const std::string name = "Constraint_tracker: unknown " + std::to_string(i) + " to link";
      if (unknowns[i].symbols() != symbols || unknowns[i].index() != static_cast<int>(i))
        throw Invalid_input(name + " is not the one of this index of one call of unknowns()");
      if (formulas[i].symbols() != nullptr && !index_of_domain(m_domains, formulas[i].symbols().get()))
        throw Invalid_input(name + ": the unknowns of its formula are not linked");
      const auto& [lower, upper] = domain()[m_time];
      if (is_time(formulas[i]) && (lower < ranges[i].first || ranges[i].second < upper))
        throw Invalid_input(name + " is the time, but has a smaller range");
    }
    m_domains.push_back({symbols, std::move(formulas)});
    m_graph.reset();
  }

  std::size_t add(const Constraint& constraint)
  {
    const std::string name = "Constraint_tracker: constraint " + std::to_string(m_constraints.size());
    if (constraint.relation == Relation::EQUAL)
      throw Invalid_input(name + " is an equality; one with a tolerance is two inequalities");
    if (constraint.symbols == nullptr)
      throw Invalid_input(name + " has no unknown");
    if (!index_of_domain(m_domains, constraint.symbols.get()))
      throw Invalid_input(name + ": its unknowns are not linked");
    m_constraints.push_back(constraint);
    m_graph.reset();
    return m_constraints.size() - 1;
  }

  void remove(std::size_t number)
  {
    if (number >= m_constraints.size() || !m_constraints[number])
      throw Invalid_input("Constraint_tracker: no constraint " + std::to_string(number));
    m_constraints[number].reset();
    m_graph.reset();
  }

  Operation_count operations_of_check() { return graph().values.operations_of_check(); }

  Tracking_step advance(const Exact_rational& time)
  {
    if (time < domain()[m_time].first || domain()[m_time].second < time)
      throw Invalid_input("Constraint_tracker: the time is out of its range");
    const Upward_rounding_guard guard;
    Run_control control(m_options.search);
    Tracking_step step;
    step.time = time;
    const std::vector<Exact_rational> splines = graph().formulas.splines_at(time);
    graph().values.begin(step, splines);
    std::vector<Exact_rational> point = m_point;
    point[m_time] = time;
    std::size_t nodes = 0;
    if (graph().values.are_satisfied_at(point))
      accept(step, Tracking_status::HELD, std::move(point));
    else if (auto repaired = relaxed(step, control))
      accept(step, Tracking_status::REPAIRED, std::move(*repaired));
    else if (m_options.is_search_allowed)
      nodes = search(step, splines, control);
    else
      step.undecided_parts.push_back({place_of(domain_at(time)), {}, "relaxation found nothing"});
    step.work = summary_of(control, nodes, control.reason(), step.is_complete());
    return step;
  }

private:
  const Unknown_domains& domain() const { return m_domains[0].symbols->domains(); }

  Exact_rational in_domain(std::size_t j, const Exact_rational& x) const
  {
    const auto& [lower, upper] = domain()[j];
    return x < lower ? lower : upper < x ? upper : x;
  }

  Exact_ranges domain_at(const Exact_rational& time) const
  {
    Exact_ranges result = domain();
    result[m_time] = {time, time};
    return result;
  }

  // A coordinate of a domain that is the time by formulas that are single unknowns.
  bool is_time(const Expression& formula) const
  {
    if (formula.symbols() == nullptr || !formula.denominator().powers.empty() || formula.numerator().is_constant())
      return false;
    const std::size_t from = *index_of_domain(m_domains, formula.symbols().get());
    const int symbol = formula.numerator().variables()[0];
    if (!(formula.numerator() == Power_polynomial::variable(symbol)) || !formula.symbols()->is_unknown(symbol))
      return false;
    return from == 0 ? symbol == m_time : is_time(m_domains[from].formulas[symbol]);
  }

  Graph& graph()
  {
    if (m_graph == nullptr) {
      if (std::none_of(m_constraints.begin(), m_constraints.end(), [](const auto& c) { return c.has_value(); }))
        throw Invalid_input("Constraint_tracker: no constraint");
      m_graph = std::make_unique<Graph>(m_domains, m_time, m_constraints);
    }
    return *m_graph;
  }

  void accept(Tracking_step& step, Tracking_status status, std::vector<Exact_rational> point)
  {
    step.status = status;
    step.point = m_point = std::move(point);
  }

  // A point that the relaxation leads to from the last one, in doubles, and that satisfies all constraints.
  std::optional<std::vector<Exact_rational>> relaxed(Tracking_step& step, Run_control& control)
  {
    const Exact_ranges exact_box = domain_at(step.time);
    Double_box box;
    double size = 0;
    std::vector<double> point;
    for (std::size_t j = 0; j < exact_box.size(); ++j) {
      const auto [lower, upper] = to_double_range(exact_box[j]);
      box.lower.push_back(lower);
      box.upper.push_back(exact_box[j].first < exact_box[j].second ? upper : lower);
      size = (std::max)(size, box.radius(j));
      point.push_back(box.clamped(j, CGAL::to_double(m_point[j])));
    }
    step.path.push_back(point);
    for (std::size_t k = 0; k < m_options.most_steps && !control.must_stop(true); ++k) {
      const double offset = m_options.offset * size * std::exp2(-2.0 * static_cast<double>(k / 4 % 4));
      Relaxation relaxation(graph().values, graph().values.relations(), m_options.relaxation, offset);
      if (!relaxation.step(point, box) ||
          !std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
        break;
      step.path.push_back(point);
      std::vector<Exact_rational> exact;
      for (std::size_t j = 0; j < point.size(); ++j)
        exact.push_back(static_cast<int>(j) == m_time ? step.time : in_domain(j, Exact_rational(point[j])));
      if (graph().values.are_satisfied_at(exact))
        return exact;
    }
    return std::nullopt;
  }

  // In boxes around the last point that grow up to the domain. Returns the nodes.
  std::size_t search(Tracking_step& step, const std::vector<Exact_rational>& splines, Run_control& control)
  {
    std::size_t nodes = 0;
    const Exact_ranges all = domain_at(step.time);
    const auto leave_undecided = [&](const std::string& reason) {
      step.undecided_parts.push_back({place_of(all), {}, reason});
    };
    try {
      const auto conditions = conditions_at_time(graph().formulas, all, splines, [&] { control.check(); });
      for (const int share : {16, 4, 1}) {
        Solver_options options = control.options_of_parts(m_options.search);
        if (options.node_limit > 0)
          options.node_limit = nodes < options.node_limit ? options.node_limit - nodes : 1;
        const Feasibility_d answer =
            Feasibility_solver_d(options)(share == 1 ? all : around_last_point(all, share), conditions);
        nodes += answer.summary().nodes;
        if (answer.has_point() && graph().values.are_satisfied_at(answer.point())) {
          accept(step, Tracking_status::FOUND, answer.point());
          return nodes;
        }
        if (share > 1)
          continue;
        if (answer.is_infeasible())
          step.status = Tracking_status::INFEASIBLE;
        else if (answer.is_feasible())
          leave_undecided(answer.has_point() ? "the point that was found has a divisor of zero"
                                             : "a point exists, but no rational one was found");
        else
          step.undecided_parts = answer.undecided();
      }
    } catch (const Run_stopped& stopped) {
      leave_undecided(in_words(stopped.reason));
    } catch (const Invalid_input& error) { // a formula that is too long when it is expanded
      leave_undecided(std::string("the search is not possible: ") + error.what());
    }
    return nodes;
  }

  Exact_ranges around_last_point(Exact_ranges box, int share) const
  {
    for (std::size_t j = 0; j < box.size(); ++j) {
      if (static_cast<int>(j) == m_time)
        continue;
      const Exact_rational reach = (box[j].second - box[j].first) / share;
      box[j] = {in_domain(j, Exact_rational(m_point[j] - reach)), in_domain(j, Exact_rational(m_point[j] + reach))};
    }
    return box;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::shared_ptr<Tracking>
tracking_from(const Unknown& time, std::vector<Exact_rational> start, const Tracker_options& options)
{
  return std::make_shared<Tracking>(time, std::move(start), options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void add_link(Tracking& tracking, std::span<const Unknown> unknowns,
                                             std::vector<Expression> formulas)
{
  tracking.link(unknowns, std::move(formulas));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t add_constraint(Tracking& tracking, const Constraint& constraint)
{
  return tracking.add(constraint);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void remove_constraint(Tracking& tracking, std::size_t number)
{
  tracking.remove(number);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Tracking_step advanced(Tracking& tracking, const Exact_rational& time)
{
  return tracking.advance(time);
}

CGAL_SPLINE_CONSTRAINTS_INLINE const std::vector<Exact_rational>& point_of(const Tracking& tracking)
{
  return tracking.point();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Operation_count operations_of_check(Tracking& tracking)
{
  return tracking.operations_of_check();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKING_STEPS_H
