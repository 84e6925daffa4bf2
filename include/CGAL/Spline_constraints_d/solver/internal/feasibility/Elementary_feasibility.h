// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_ELEMENTARY_FEASIBILITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_ELEMENTARY_FEASIBILITY_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/jets.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/numbers.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_run.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Constraint_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Elementary_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/solutions_by_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/Constraints_on_unknowns.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Whether constraints with elementary functions have a solution in a box, by branch and bound: boxes are narrowed by
constraint propagation, which proves that some are empty; from others Newton's method goes to a point, where all
unknowns but as many as there are equalities get their values, and the solver of points certifies the rest. The box
whose middle is the least violated comes first.
*/
class Elementary_feasibility
{
  using Domain = std::vector<Constraint_system_d::Domain>;
  using Point = std::vector<double>;
  using Jet = elementary::Jet<double>;

  // A box with what propagation has left of it.
  struct Node
  {
    Box_of_ranges box, narrowed;
    double violation;

    bool operator<(const Node& other) const { return violation > other.violation; }
  };

  const Domain& m_domain;
  const std::vector<Polynomial_constraint>& m_constraints;
  const Elementary_values& m_values;
  Feasibility_run& m_run;
  Elementary_system m_elementary;
  Sparse_system m_system;
  Constraint_propagation m_propagation;
  std::size_t m_equalities = 0;
  std::priority_queue<Node> m_waiting;
  std::vector<Undecided_part> m_undecided;

public:
  Elementary_feasibility(const Domain& domain, const std::vector<Polynomial_constraint>& constraints,
                         const Elementary_values& values, Feasibility_run& run)
    : m_domain(domain), m_constraints(constraints), m_values(values), m_run(run),
      m_elementary(static_cast<int>(domain.size()), constraints, values, [&run] { run.check(); }),
      m_system(
          m_elementary.dimension(), m_elementary.constraints(), [&run] { run.check(); }, m_elementary.terms(),
          m_elementary.defined()),
      m_propagation(m_system)
  {
    for (const auto& [polynomial, relation] : constraints)
      m_equalities += relation == Relation::EQUAL;
  }

  Feasibility_outcome operator()();

private:
  std::size_t dimension() const { return m_domain.size(); }

  void add(const Box_of_ranges& box, Box_of_ranges narrowed);
  void split(const Node& node, std::size_t unknown);
  std::optional<std::size_t> unknown_to_split(const Box_of_ranges& box) const;

  std::optional<std::vector<Jet>> jets_at(const Point& point) const;
  double violation_at(const Point& point) const;
  std::optional<Point> point_near(Point point, const Box_of_ranges& box) const;
  std::optional<Feasibility_outcome> certified(const Point& point);
  std::optional<Feasibility_outcome> certified_exactly(const std::vector<Exact_rational>& point) const;
  std::optional<Feasibility_outcome> certified_with_equalities(const Point& point);
  std::vector<int> dependent_unknowns(const Point& point) const;
};

inline std::vector<double> middle_of_ranges(const Box_of_ranges& box, std::size_t dimension)
{
  std::vector<double> result;
  for (std::size_t j = 0; j < dimension; ++j)
    result.push_back(middle(box[j]));
  return result;
}

inline std::vector<Undecided_part::Range> places_of(const Box_of_ranges& box, std::size_t dimension)
{
  std::vector<Undecided_part::Range> result;
  for (std::size_t j = 0; j < dimension; ++j)
    result.emplace_back(box[j].inf(), box[j].sup());
  return result;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Feasibility_outcome Elementary_feasibility::operator()()
{
  constexpr std::size_t always_tried = 16, tried_every = 8;
  Box_of_ranges domain;
  for (const auto& [lower, upper] : m_domain)
    domain.emplace_back(enclosure_of(lower).inf(), enclosure_of(upper).sup());
  Box_of_ranges narrowed = domain;
  if (!set_defined_unknowns(m_system, narrowed))
    m_run.exclude(places_of(domain, dimension()), {});
  else {
    m_propagation.wake_all();
    add(domain, narrowed);
  }
  for (std::size_t k = 0; !m_waiting.empty() && !m_run.must_stop(); ++k) {
    const Node node = m_waiting.top();
    m_waiting.pop();
    m_run.add_nodes(1);
    if (k < always_tried || k % tried_every == 0)
      if (const auto point = point_near(middle_of_ranges(node.narrowed, dimension()), node.narrowed))
        if (auto outcome = certified(*point))
          return *outcome;
    if (const auto unknown = unknown_to_split(node.narrowed)) {
      split(node, *unknown);
      continue;
    }
    m_run.end_at_tolerance();
    m_undecided.push_back({places_of(node.narrowed, dimension()), {}, in_words(Undecided_reason::TOLERANCE)});
  }
  for (; !m_waiting.empty(); m_waiting.pop())
    m_undecided.push_back({places_of(m_waiting.top().narrowed, dimension()), {}, in_words(m_run.reason())});
  return {m_undecided.empty() ? Feasibility::INFEASIBLE : Feasibility::UNDECIDED, {}, {}, std::move(m_undecided)};
}

// With the constraints that are awake.
CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_feasibility::add(const Box_of_ranges& box, Box_of_ranges narrowed)
{
  if (!m_propagation.narrow(narrowed)) {
    m_run.exclude(places_of(box, dimension()), {});
    return;
  }
  const double violation = violation_at(middle_of_ranges(narrowed, dimension()));
  m_waiting.push({box, std::move(narrowed), violation});
}

// The halves of the box are those of all that propagation has cut off, too.
CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_feasibility::split(const Node& node, std::size_t unknown)
{
  const double at = middle(node.narrowed[unknown]);
  for (const bool is_lower : {true, false}) {
    Box_of_ranges box = node.box, narrowed = node.narrowed;
    for (Box_of_ranges* part : {&box, &narrowed}) {
      Interval& range = (*part)[unknown];
      range = is_lower ? Interval(range.inf(), at) : Interval(at, range.sup());
    }
    m_propagation.wake_constraints_of(static_cast<int>(unknown));
    add(box, std::move(narrowed));
  }
}

// The one whose range is the widest beside its domain, of those that are wide beside the tolerance.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::size_t>
Elementary_feasibility::unknown_to_split(const Box_of_ranges& box) const
{
  std::optional<std::size_t> result;
  double widest = 0;
  for (std::size_t j = 0; j < dimension(); ++j) {
    const Interval& range = box[j];
    if (width(range) < m_run.tolerance() * (std::max)(1.0, magnitude(range)) ||
        !(range.inf() < middle(range) && middle(range) < range.sup()))
      continue;
    const double all = CGAL::to_double(Exact_rational(m_domain[j].second - m_domain[j].first));
    if (const double share = width(range) / all; !result || share > widest) {
      widest = share;
      result = j;
    }
  }
  return result;
}

// In doubles. Nothing where a function is not defined or has no derivative.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::vector<Elementary_feasibility::Jet>>
Elementary_feasibility::jets_at(const Point& point) const
{
  struct Known
  {
    double value;
    std::optional<double> derivative;
  };
  const auto number = [](const Exact_rational& x) { return CGAL::to_double(x); };
  const auto values = elementary::jets_of_values<double>(
      m_values, point, number, [](const Elementary_value& value, double at) -> std::optional<Known> {
        const elementary::Operation operation = elementary::operation_of(value);
        const Interval x(at);
        if (!std::isfinite(at) || !elementary::is_in_domain(operation, x))
          return std::nullopt;
        const Interval result = elementary::range_of_values(operation, x);
        const Interval slope = elementary::range_of_derivative(operation, x, result);
        if (!is_finite(result) || !is_finite(slope))
          return std::nullopt;
        return Known{middle(result), middle(slope)};
      });
  if (!values)
    return std::nullopt;
  std::vector<Jet> result;
  for (const auto& [polynomial, relation] : m_constraints)
    result.push_back(elementary::jet_of<double>(polynomial, point, *values, number));
  return result;
}

// How much a constraint is violated by a value of its function, with a sign: by what the value is to change.
inline double excess(Relation relation, double value)
{
  switch (relation) {
  case Relation::EQUAL:
    return value;
  case Relation::LESS:
  case Relation::LESS_EQUAL:
    return value > 0 ? value : 0;
  case Relation::GREATER:
  case Relation::GREATER_EQUAL:
    return value < 0 ? value : 0;
  default:
    return 0;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE double Elementary_feasibility::violation_at(const Point& point) const
{
  const auto jets = jets_at(point);
  if (!jets)
    return std::numeric_limits<double>::infinity();
  double result = 0;
  for (std::size_t i = 0; i < jets->size(); ++i)
    result = (std::max)(result, std::abs(excess(m_constraints[i].second, (*jets)[i].value)));
  return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

/*
Newton's method for the constraints that are violated, by the shortest steps beside the widths of a box, within it;
inequalities are over-satisfied by a tenth.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Elementary_feasibility::Point>
Elementary_feasibility::point_near(Point point, const Box_of_ranges& box) const
{
  constexpr int most_steps = 20;
  constexpr double overshoot = 1.1, regularization = 1e-14, arrived = 1e-15;
  const Eigen::Index n = static_cast<Eigen::Index>(dimension());
  for (int step = 0; step < most_steps; ++step) {
    const auto jets = jets_at(point);
    if (!jets)
      return std::nullopt;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < jets->size(); ++i)
      if (excess(m_constraints[i].second, (*jets)[i].value) != 0)
        rows.push_back(i);
    if (rows.empty())
      break;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), n);
    Eigen::VectorXd right(static_cast<Eigen::Index>(rows.size()));
    for (Eigen::Index r = 0; r < right.size(); ++r) {
      const std::size_t i = rows[r];
      double size = 0;
      for (const auto& [unknown, derivative] : (*jets)[i].gradient) {
        matrix(r, unknown) = derivative * width(box[unknown]);
        size = (std::max)(size, std::abs(matrix(r, unknown)));
      }
      if (!(size > 0) || !std::isfinite(size) || !std::isfinite((*jets)[i].value))
        return std::nullopt;
      matrix.row(r) /= size;
      right(r) = (*jets)[i].value / size * (m_constraints[i].second == Relation::EQUAL ? 1 : overshoot);
    }
    Eigen::MatrixXd square = matrix * matrix.transpose();
    square.diagonal().array() += regularization;
    const Eigen::VectorXd move = matrix.transpose() * square.ldlt().solve(right);
    double longest = 0;
    for (Eigen::Index j = 0; j < n; ++j) {
      const Interval& range = box[j];
      const double moved = (std::min)((std::max)(point[j] - move(j) * width(range), range.inf()), range.sup());
      longest = (std::max)(longest, std::abs(moved - point[j]) / (std::max)(1.0, std::abs(moved)));
      point[j] = moved;
    }
    if (!(longest > arrived))
      break;
  }
  return point;
}

// Where the other unknowns have their values there, the point itself, and one with simple coordinates beside it.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Feasibility_outcome> Elementary_feasibility::certified(const Point& point)
{
  constexpr double nearby = 1e-9;
  std::vector<Exact_rational> exact, simple;
  for (std::size_t j = 0; j < dimension(); ++j) {
    const Exact_rational x = (std::min)((std::max)(Exact_rational(point[j]), m_domain[j].first), m_domain[j].second);
    const Exact_rational margin(nearby * (std::max)(1.0, std::abs(point[j])));
    exact.push_back(x);
    simple.push_back(simplest_rational_between((std::max)(Exact_rational(x - margin), m_domain[j].first),
                                               (std::min)(Exact_rational(x + margin), m_domain[j].second)));
  }
  if (auto result = certified_exactly(exact))
    return result;
  if (auto result = certified_exactly(simple))
    return result;
  return m_equalities > 0 && m_equalities < dimension() ? certified_with_equalities(point) : std::nullopt;
}

// By enclosures, or by values that are rational.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Feasibility_outcome>
Elementary_feasibility::certified_exactly(const std::vector<Exact_rational>& point) const
{
  const auto result = [&](const char* certificate) {
    Exact_ranges ranges;
    for (const Exact_rational& x : point)
      ranges.emplace_back(x, x);
    return feasible_in(std::move(ranges), certificate);
  };
  if (m_equalities == 0) {
    Box_of_ranges box;
    for (const Exact_rational& x : point)
      box.push_back(enclosure_of(x));
    if (set_defined_unknowns(m_system, box)) {
      bool is_defined = true;
      for (int k = 0; k < m_system.functions() && is_defined; ++k)
        is_defined = elementary::is_in_domain(m_system.function(k).operation, m_system.function(k).argument(box));
      if (is_defined && place_in_inequalities(box, m_system, m_elementary.constraints()) == Whereabouts::INSIDE)
        return result("enclosures of all functions at the point have the signs that are asked for");
    }
  }
  const auto values = m_values.rational_values(point);
  if (!values || !std::ranges::all_of(m_constraints, [&](const Polynomial_constraint& constraint) {
        return is_satisfied(constraint.second, CGAL::sign(m_values.rational_value(constraint.first, point, *values)));
      }))
    return std::nullopt;
  return result("signs at the point, where all values are rational");
}

// As many as there are equalities, by elimination with complete pivoting, columns as wide as the domain; none where
// their gradients are nearly dependent.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<int> Elementary_feasibility::dependent_unknowns(const Point& point) const
{
  constexpr double dependent = 1e-10;
  const auto jets = jets_at(point);
  std::vector<std::map<int, double>> rows;
  for (std::size_t i = 0; jets && i < jets->size(); ++i)
    if (m_constraints[i].second == Relation::EQUAL) {
      std::map<int, double>& row = rows.emplace_back((*jets)[i].gradient);
      double size = 0;
      for (auto& [unknown, x] : row) {
        x *= CGAL::to_double(Exact_rational(m_domain[unknown].second - m_domain[unknown].first));
        size = (std::max)(size, std::abs(x));
      }
      for (auto& [unknown, x] : row)
        x /= size > 0 ? size : 1;
    }
  std::vector<int> result;
  while (!rows.empty()) {
    std::size_t pivot_row = 0;
    int pivot = -1;
    double largest = dependent;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [unknown, x] : rows[i])
        if (std::abs(x) > largest) {
          largest = std::abs(x);
          pivot_row = i;
          pivot = unknown;
        }
    if (pivot < 0)
      return {};
    const std::map<int, double> row = std::move(rows[pivot_row]);
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(pivot_row));
    for (std::map<int, double>& other : rows)
      if (const auto entry = other.find(pivot); entry != other.end()) {
        const double multiple = entry->second / row.at(pivot);
        elementary::add_multiple(other, -multiple, row);
        other.erase(pivot);
      }
    result.push_back(pivot);
  }
  std::sort(result.begin(), result.end());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Feasibility_outcome>
Elementary_feasibility::certified_with_equalities(const Point& point)
{
  constexpr double nearby = 1e-6;
  constexpr std::size_t most_nodes = 100;
  const std::vector<int> unknowns = dependent_unknowns(point);
  if (unknowns.empty())
    return std::nullopt;
  Exact_ranges box;
  std::vector<Exact_rational> chosen;
  for (std::size_t j = 0; j < dimension(); ++j) {
    const Exact_rational x = (std::min)((std::max)(Exact_rational(point[j]), m_domain[j].first), m_domain[j].second);
    box.emplace_back(x, x);
    chosen.push_back(x);
  }
  Domain around;
  for (const int j : unknowns) {
    const Exact_rational margin(nearby * (std::max)(1.0, std::abs(point[j])));
    around.emplace_back((std::max)(Exact_rational(box[j].first - margin), m_domain[j].first),
                        (std::min)(Exact_rational(box[j].first + margin), m_domain[j].second));
  }
  try {
    const Constraints_on_unknowns rest(m_constraints, m_values, chosen, unknowns);
    const auto solutions = solution_set_by_propagation<CGAL::Sequential_tag>(
        around, rest.constraints, m_run.options_of_system(most_nodes), rest.values);
    m_run.add_nodes(solutions.summary().nodes);
    for (const auto& solution : solutions)
      if (solution.is_certified()) {
        const auto ranges = solution.exact_box();
        for (std::size_t k = 0; k < unknowns.size(); ++k)
          box[unknowns[k]] = {ranges[k].first, ranges[k].second};
        return feasible_in(std::move(box), "a certified solution of the equalities, the other unknowns being chosen");
      }
  } catch (const Invalid_input&) { // a function is not defined there
  }
  return std::nullopt;
}
#endif

// The whole run. Defined here and declared in Feasibility_solver_d.h.
Feasibility_d feasibility_with_values(const std::vector<Constraint_system_d::Domain>& domain,
                                      const std::vector<Polynomial_constraint>& constraints,
                                      const Elementary_values& values, const Solver_options& options);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Feasibility_d feasibility_with_values(
    const std::vector<Constraint_system_d::Domain>& domain, const std::vector<Polynomial_constraint>& constraints,
    const Elementary_values& values, const Solver_options& options)
{
  check_unknowns_of(domain, constraints, values, "Feasibility_solver_d");
  const auto equalities = std::ranges::count(constraints, Relation::EQUAL, &Polynomial_constraint::second);
  if (constraints.empty())
    throw Invalid_input("Feasibility_solver_d: no constraint");
  if (equalities == static_cast<std::ptrdiff_t>(domain.size()))
    throw Invalid_input("Feasibility_solver_d: as many equalities as unknowns; see solve()");
  const Upward_rounding_guard guard;
  const Mpfr_precision_scope precision(options.precision);
  Run_control control(options);
  Feasibility_run run(options, control);
  Feasibility_outcome outcome;
  try {
    outcome = Elementary_feasibility(domain, constraints, values, run)();
  } catch (const Run_stopped& stopped) {
    Exact_ranges box(domain.begin(), domain.end());
    outcome = {Feasibility::UNDECIDED, {}, {}, {{place_of(box), {}, in_words(stopped.reason)}}};
  }
  return run.ended_with(std::move(outcome));
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_ELEMENTARY_FEASIBILITY_H
