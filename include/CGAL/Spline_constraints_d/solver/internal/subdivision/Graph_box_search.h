// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_GRAPH_BOX_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_GRAPH_BOX_SEARCH_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Graph_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_position.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Dense_preconditioner.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_analysis.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/cell_boxes.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Depth_first_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/splitters.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Whether the solutions of a system may have a dimension. \throws Invalid_input, in the name of a function, if not
inline void check_codimension(const Constraint_system_d& system, int dimension_of_solutions, const std::string& name)
{
  const int n = system.dimension();
  if (n <= dimension_of_solutions || static_cast<int>(system.equalities().size()) != n - dimension_of_solutions)
    throw Invalid_input(name + ": " + std::to_string(system.equalities().size()) + " equalities for " +
                        std::to_string(n) + " unknowns");
  for (int v = 0; v < n; ++v)
    if (!(system.domain(v).first < system.domain(v).second))
      throw Invalid_input(name + ": the range of unknown " + std::to_string(v) + " is one number");
}

/*
What a search for boxes that hold a graph, part of a curve or of a surface of solutions, does with one box in a cell,
where all functions are polynomials: it is excluded, recognised as a graph, shrunk, or to be split along one of some
axes. Those who use it say what a split and a graph mean.
*/
template <class Traits>
class Graph_box_search
{
protected:
  using NT = typename Traits::Number_type;
  using Coordinate = typename Number_traits<NT>::Coordinate;
  using Node = Box_node<NT>;
  static constexpr bool has_doubles = std::is_same_v<NT, double>;

  const Constraint_system_d m_system, m_equalities;
  const System_layout m_layout;
  std::optional<Exact_source> m_source; // none where nodes are made from those of another search
  Summary& m_summary;
  Node_analysis<NT> m_analysis;
  Graph_test m_graph;
  const Solver_options& m_options;
  Run_control& m_control;
  Depth_first_subdivision<NT> m_driver;
  std::vector<std::size_t> m_open_inequalities; // of the node
  const std::vector<double>& m_domain_widths;

private:
  typename Traits::Splitter m_splitter;
  Dense_preconditioner m_combinations;
  Local_box m_part; // of the node: what may hold solutions
  bool m_has_rows = false, m_is_combined = false;
  std::vector<double> m_combination; // that was applied last

protected:
  // `parameters`: of the graphs, the number of unknowns that they are over.
  Graph_box_search(const Constraint_system_d& system, const Exact_ranges& cell, int parameters,
                   const std::vector<double>& domain_widths, const Solver_options& options, Run_control& control,
                   Summary& summary)
    : m_system(on_cell(system, cell)), m_equalities(equalities_of(m_system)), m_layout(m_system),
      m_source(std::in_place, m_system, m_layout), m_summary(summary),
      m_analysis(m_layout, *m_source, m_summary, Traits::tracks_rounding),
      m_graph(m_layout.dimension, m_layout.equalities, parameters), m_options(options), m_control(control),
      m_driver(m_layout), m_domain_widths(domain_widths)
  {}

  // For equalities that are known by the coefficients of nodes alone.
  Graph_box_search(const System_layout& layout, int parameters, const std::vector<double>& domain_widths,
                   const Solver_options& options, Run_control& control, Summary& summary)
    : m_system(Exact_ranges(static_cast<std::size_t>(layout.dimension), {Exact_rational(0), Exact_rational(1)})),
      m_equalities(m_system), m_layout(layout), m_summary(summary), m_analysis(m_layout, m_summary),
      m_graph(m_layout.dimension, m_layout.equalities, parameters), m_options(options), m_control(control),
      m_driver(m_layout), m_domain_widths(domain_widths)
  {}

  // Makes a box the root of the driver.
  void enter(const Exact_ranges& box)
  {
    Node& root = m_driver.root();
    for (std::size_t j = 0; j < box.size(); ++j)
      std::tie(root.lower[j], root.upper[j]) =
          dyadic_hull<Coordinate>(box[j].first, box[j].second, m_options.precision);
    m_source->set_home(Cell(box.size(), 0), std::span<const Coordinate>(root.lower),
                       std::span<const Coordinate>(root.upper));
    m_analysis.rebuild(Cell(box.size(), 0), root);
  }

  Undecided_reason limit() { return m_control.must_stop(true) ? m_control.reason() : Undecided_reason::NONE; }

  // What becomes of a box: AGAIN when it was shrunk, and no solution lies in what was cut off. `age`: changes since the
  // coefficients were exact; accepts() is asked whether a graph finishes the box.
  template <std::predicate Accepts>
  Box_verdict examine_box(Node& node, Exact_ranges& box, int& age, const Accepts& accepts)
  {
    constexpr int oldest = 12; // rounding errors do not matter yet
    if (age == oldest) {
      m_analysis.rebuild(Cell(box.size(), 0), node);
      age = 0;
    }
    ++age;
    return examine_node(node, accepts, [&] { return shrink(node, box); });
  }

  // The same for a node that has no other box than its own.
  template <std::predicate Accepts>
  Box_verdict examine_node(Node& node, const Accepts& accepts)
  {
    return examine_node(node, accepts, [&] {
      const auto lower = node.lower, upper = node.upper;
      shrink(node);
      return node.lower != lower || node.upper != upper;
    });
  }

  // `shrinks()`: shrinks the node, and tells whether it has become smaller.
  template <std::predicate Accepts, std::predicate Shrinks>
  Box_verdict examine_node(Node& node, const Accepts& accepts, const Shrinks& shrinks)
  {
    m_analysis.look_at(node);
    m_is_combined = false;
    if (is_excluded() || is_empty_or_graph(m_analysis.view, accepts))
      return Box_verdict::DONE;
    m_part.reset(m_layout.dimension);
    if (!contract_by_rows(m_analysis.view))
      return Box_verdict::DONE;
    if (Node_view* combined = is_worth_a_pass(node) ? nullptr : combined_equalities()) {
      m_is_combined = true;
      if (is_empty_or_graph(*combined, accepts) || !contract_by_rows(*combined))
        return Box_verdict::DONE;
    }
    return is_worth_a_pass(node) && shrinks() ? Box_verdict::AGAIN : Box_verdict::SPLIT;
  }

  // Some constraint is violated on all of the node that was looked at last.
  bool is_excluded()
  {
    for (int f = 0; f < m_layout.equalities; ++f)
      if (is_certainly_violated(Relation::EQUAL, m_analysis.view.lower(f), m_analysis.view.upper(f)))
        return true;
    m_open_inequalities.clear();
    for (std::size_t g = 0; g < m_system.inequalities().size(); ++g) {
      const int f = m_layout.equalities + static_cast<int>(g);
      const double lower = m_analysis.view.lower(f), upper = m_analysis.view.upper(f);
      if (is_certainly_violated(m_system.inequalities()[g].relation, lower, upper))
        return true;
      if (!is_certainly_satisfied(m_system.inequalities()[g].relation, lower, upper))
        m_open_inequalities.push_back(g);
    }
    return false;
  }

  // Where a graph is accepted: the sign of the minor of the derivatives of the equalities that it is solved by.
  int sign_of_minor() const
  {
    const std::vector<Exact_rational> combination(m_combination.begin(), m_combination.end());
    return m_graph.sign_of_minor() *
        (m_is_combined ? sign_of_determinant(combination, static_cast<std::size_t>(m_layout.equalities)) : 1);
  }

  static double width(const Node& node, int j) { return CGAL::to_double(Coordinate(node.upper[j] - node.lower[j])); }

  // The axes that can be split, the best one first. `open`: how many boxes have been left undecided.
  std::vector<int> rated_axes(const Node& node, std::size_t open)
  {
    constexpr double thinnest = 0.125, coarsening = 4;
    // after so many more have been left undecided, others may be wider: the number of boxes does not grow with the
    // tolerance
    constexpr std::size_t many_boxes = 128;
    const double tolerance = m_options.tolerance * std::pow(coarsening, static_cast<double>(open / many_boxes));
    const int n = m_layout.dimension;
    std::vector<double> widths, rating;
    double widest = 0;
    for (int j = 0; j < n; ++j) {
      widths.push_back(width(node, j) / m_domain_widths[j]);
      widest = (std::max)(widest, widths.back());
    }
    m_splitter.rate(m_analysis.view, widths, rating);
    std::vector<int> result;
    for (int j = 0; j < n; ++j)
      if (width(node, j) > tolerance * magnitude(node, j) && widths[j] >= thinnest * widest)
        result.push_back(j);
    std::stable_sort(result.begin(), result.end(), [&](int i, int j) { return rating[i] > rating[j] * (1 + 1e-9); });
    return result;
  }

private:
  static double magnitude(const Node& node, int j)
  {
    return (std::max)({1.0, std::abs(CGAL::to_double(node.lower[j])), std::abs(CGAL::to_double(node.upper[j]))});
  }

  // Whether a box is finished by what the equalities, or combinations of them, say.
  template <class Accepts>
  bool is_empty_or_graph(Node_view& equalities, const Accepts& accepts)
  {
    m_has_rows = m_graph.eliminate(equalities);
    return m_has_rows && (m_graph.is_empty(equalities) || (m_graph.is_graph() && accepts()));
  }

  // The combinations that were eliminated last as functions of their own; null if there are none. What cancels between
  // equalities does so before anything is bounded.
  Node_view* combined_equalities()
  {
    if (!m_has_rows || m_layout.equalities == 1)
      return nullptr;
    m_combination = m_graph.transform();
    m_combinations.prepare(m_layout);
    return &m_combinations.apply(m_analysis.view, m_graph.transform());
  }

  // Shrinks the part of the node that may hold solutions; false when there are none.
  bool contract_by_rows(Node_view& equalities)
  {
    if (!m_analysis.linear.contract_by_equations(equalities, m_part))
      return false;
    m_analysis.linear.precondition(equalities);
    return m_analysis.linear.contract_by_preconditioned(m_part);
  }

  // Nothing shrinks below the tolerance.
  auto least_shares(const Node& node) const
  {
    return [this, &node](int j) {
      return (std::max)(Box_contraction::thinnest, m_options.tolerance * magnitude(node, j) / width(node, j));
    };
  }

  bool is_worth_a_pass(const Node& node) const { return Box_contraction::is_worth_a_pass(m_part, least_shares(node)); }

  // Shrinks a node to the part that may hold solutions. There are none on the faces that are moved, so that it keeps
  // what is known of its boundary.
  void shrink(Node& node)
  {
    Box_contraction::widen(m_part, least_shares(node));
    node.restrict_to(m_layout, m_part, Box_contraction::least_gain);
  }

  // And its exact box; false when it stays as it is.
  bool shrink(Node& node, Exact_ranges& box)
  {
    shrink(node);
    bool is_smaller = false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const Exact_rational lower(node.lower[j]), upper(node.upper[j]);
      is_smaller = is_smaller || box[j].first < lower || upper < box[j].second;
      box[j] = {(std::max)(box[j].first, lower), (std::min)(box[j].second, upper)};
    }
    return is_smaller;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_GRAPH_BOX_SEARCH_H
