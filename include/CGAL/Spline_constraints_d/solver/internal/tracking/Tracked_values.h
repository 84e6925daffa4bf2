// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKED_VALUES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKED_VALUES_H

#include <CGAL/Spline_constraints_d/function/Graph_evaluation.h>
#include <CGAL/Spline_constraints_d/solver/Tracking_step.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>
#include <CGAL/Spline_constraints_d/solver/internal/tracking/Tracked_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Values of tracked formulas at points of the basic domain at one time: in doubles with gradients, as the family of
functions of a relaxation; and whether an exact point satisfies all of them.
*/
class Tracked_values
{
  using Node = Expression_graph::Node;
  template <class NT>
  struct Evaluation
  {
    Graph_evaluation<NT> values;
    std::vector<NT> point; // with the splines of the time

    Evaluation(const Expression_graph& graph) : values(graph), point(graph.number_of_unknowns(), graph_constant<NT>(0))
    {}
  };

  struct Gradient
  {
    std::vector<Node> partials;
    std::size_t number; // of its list of operations
  };

  Tracked_formulas& m_tracked;
  std::vector<Tracked_formula> m_formulas;
  std::vector<Relation> m_relations;
  std::vector<std::optional<Gradient>> m_gradients; // made when they are needed
  std::vector<Operation_count> m_own_operations;
  Operation_count m_all_operations;
  Evaluation<double> m_double;
  Evaluation<Interval> m_interval;
  Evaluation<Exact_rational> m_exact;
  Tracking_step* m_step = nullptr;
  bool m_is_evaluated = false;

public:
  explicit Tracked_values(Tracked_formulas& tracked)
    : m_tracked(tracked), m_formulas(tracked.formulas()), m_gradients(m_formulas.size()), m_double(tracked.graph()),
      m_interval(tracked.graph()), m_exact(tracked.graph())
  {
    std::vector<Node> functions;
    for (const auto& [function, relation] : m_formulas) {
      functions.push_back(function);
      m_relations.push_back(relation);
      m_own_operations.push_back(tracked.graph().operations(function));
      m_exact.values.prepare({&function, 1});
    }
    m_double.values.prepare(functions);
    m_interval.values.prepare(functions);
    m_all_operations = tracked.graph().operations(functions);
  }

  const std::vector<Relation>& relations() const { return m_relations; }
  const Operation_count& operations_of_check() const { return m_all_operations; }

  // What follows is at these values of the splines of the time, and its operations are those of this step.
  void begin(Tracking_step& step, const std::vector<Exact_rational>& splines)
  {
    m_step = &step;
    set_splines(m_double, splines);
    set_splines(m_interval, splines);
    set_splines(m_exact, splines);
  }

  // As a family of functions.
  void set_point(std::span<const double> point)
  {
    set(m_double, point);
    m_is_evaluated = false;
  }
  std::size_t coefficients(std::size_t i) const { return i; }
  double value(std::size_t i)
  {
    if (!m_is_evaluated) // all at once
      evaluate(0, m_step->values);
    m_is_evaluated = true;
    const double result = m_double.values[m_formulas[i].function];
    return std::isnan(result) ? HUGE_VAL : result;
  }
  std::vector<double> gradient(std::size_t i)
  {
    if (!m_gradients[i])
      m_gradients[i] = gradient_of(m_formulas[i].function);
    m_step->violated += m_own_operations[i];
    evaluate(m_gradients[i]->number, m_step->gradients);
    std::vector<double> result;
    for (const Node& partial : m_gradients[i]->partials)
      result.push_back(m_double.values[partial]);
    return result;
  }

  // \pre the rounding mode is upward
  bool are_satisfied_at(const std::vector<Exact_rational>& point)
  {
    std::vector<Interval> enclosure;
    for (const Exact_rational& x : point)
      enclosure.push_back(rounded_to<Interval>(x));
    set(m_interval, std::span<const Interval>(enclosure));
    m_interval.values.evaluate();
    std::vector<std::size_t> uncertain;
    for (std::size_t i = 0; i < m_formulas.size(); ++i) {
      ++m_step->enclosures;
      const auto sign = Number_traits<Interval>::sign(m_interval.values[m_formulas[i].function]);
      if (!is_certain(sign))
        uncertain.push_back(i);
      else if (!is_satisfied(m_relations[i], get_certain(sign)))
        return false;
    }
    return uncertain.empty() || are_exactly_satisfied_at(point, uncertain);
  }

private:
  Gradient gradient_of(const Node& function)
  {
    std::vector<Node> partials = m_tracked.graph().gradient(function);
    partials.resize(m_tracked.dimension(), partials[0]);
    partials[m_tracked.time()] = m_tracked.graph().constant(0); // is not moved
    const std::size_t number = m_double.values.prepare(partials);
    return {std::move(partials), number};
  }

  bool are_exactly_satisfied_at(const std::vector<Exact_rational>& point, const std::vector<std::size_t>& formulas)
  try {
    set(m_exact, std::span<const Exact_rational>(point));
    for (const std::size_t i : formulas) {
      ++m_step->exact_signs;
      m_exact.values.evaluate(i);
      if (!is_satisfied(m_relations[i], CGAL::sign(m_exact.values[m_formulas[i].function])))
        return false;
    }
    return true;
  } catch (const Invalid_input&) { // a divisor is zero: the formula says nothing
    return false;
  }

  void evaluate(std::size_t number, Operation_count& count)
  {
    m_double.values.reset_operations();
    m_double.values.evaluate(number);
    count += m_double.values.operations();
  }

  template <class NT>
  void set(Evaluation<NT>& evaluation, std::span<const NT> point)
  {
    std::copy(point.begin(), point.end(), evaluation.point.begin());
    evaluation.values.set_point(evaluation.point);
  }
  template <class NT>
  void set_splines(Evaluation<NT>& evaluation, const std::vector<Exact_rational>& splines)
  {
    for (std::size_t k = 0; k < splines.size(); ++k)
      evaluation.point[m_tracked.dimension() + k] = graph_constant<NT>(splines[k]);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_TRACKED_VALUES_H
