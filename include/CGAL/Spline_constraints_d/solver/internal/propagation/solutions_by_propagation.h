// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_BY_PROPAGATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_BY_PROPAGATION_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/Parallel_loop.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Elementary_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Explicit_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Krawczyk_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Precise_zeros.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Propagation_run.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Propagation_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/check_constraints.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>
#include <CGAL/Spline_constraints_d/solver/internal/union_of_boxes.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/solution_set.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

enum class Whereabouts
{
  OUTSIDE,
  INSIDE,
  OPEN
};

/*
All solutions of polynomial constraints in a box: what the search finds; what it leaves open, multiple roots and roots
on the boundary, is settled by the solver that has tensors, on boxes around it, where these are small enough. With
values of elementary functions, regular roots are settled by numbers of many bits; others stay open, unless they are
rational by the laws of the functions.
*/
class Solutions_by_propagation
{
  using Solution = Solution_d<double>;

  const std::vector<Constraint_system_d::Domain>& m_domain;
  const std::vector<Polynomial_constraint>& m_constraints;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_summary;
  Parallel_loop m_loop;
  const Elementary_values* m_values; // null: none
  std::optional<Precise_zeros> m_precise_zeros;
  std::vector<Solution> m_solutions;
  std::vector<Proved_root> m_roots; // of the solutions that are certified
  std::vector<Box_of_ranges> m_open;
  std::optional<Propagation_run> m_run; // of polynomials
  bool m_is_stopped = false;            // before there was a search

public:
  Solutions_by_propagation(const std::vector<Constraint_system_d::Domain>& domain,
                           const std::vector<Polynomial_constraint>& constraints, const Solver_options& options,
                           Run_control& control, Summary& summary, const Parallel_loop& loop,
                           const Elementary_values* values = nullptr)
    : m_domain(domain), m_constraints(constraints), m_options(options), m_control(control), m_summary(summary),
      m_loop(loop), m_values(values != nullptr && !values->all().empty() ? values : nullptr)
  {
    if (m_values != nullptr)
      m_precise_zeros.emplace(domain, constraints, *m_values, control);
  }

  // Of polynomials: goes on with the search until it has ended, or so many boxes were looked at in all (0: any number);
  // whether it has ended. The rounding is upward.
  bool advance(std::size_t most_nodes);
  // Boxes looked at by the search so far.
  std::size_t nodes() const { return m_run ? m_run->nodes() : 0; }

  // In no order.
  std::vector<Solution> operator()()
  {
    if (m_values == nullptr)
      advance(m_options.node_limit);
    return found();
  }

  // What the search has found, and what it left: it ends with this.
  std::vector<Solution> found()
  {
    try {
      if (m_values != nullptr)
        search_with_values();
      else if (!m_is_stopped)
        add_found();
      settle_open();
    } catch (const Run_stopped& stopped) {
      add_undecided(box_of_domain(), stopped.reason);
    }
    return std::move(m_solutions);
  }

private:
  int dimension() const { return static_cast<int>(m_domain.size()); }

  Box_of_ranges box_of_domain() const
  {
    Box_of_ranges result;
    for (const auto& [lower, upper] : m_domain)
      result.emplace_back(enclosure_of(lower).inf(), enclosure_of(upper).sup());
    return result;
  }

  static Solution::Box plain(const Box_of_ranges& box)
  {
    Solution::Box result;
    for (const Interval& range : box)
      result.emplace_back(range.inf(), range.sup());
    return result;
  }

  void add_undecided(const Box_of_ranges& box, Undecided_reason reason)
  {
    m_solutions.emplace_back(Solution_kind::UNDECIDED, plain(box), Solution::Box(), "interval", reason);
  }

  void add_found();
  void search_with_values();
  void leave_rest(Propagation_search& search, std::size_t nodes,
                  const std::function<Box_of_ranges(Box_of_ranges)>& expanded);
  void add_root(const Proved_root& root, const Sparse_system& system, const Explicit_unknowns& explicit_unknowns);
  void add_root(Proved_root root, Whereabouts place);
  std::optional<Whereabouts> exact_place(const Box_of_ranges& enclosure) const;
  bool settle_by_precision(const Box_of_ranges& box);
  void settle_open();
  void settle(const Box_of_ranges& box);
  void add_settled(Solution solution);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
// Where an enclosure lies beside the domain.
inline Whereabouts place_in_domain(const Box_of_ranges& box, const std::vector<Constraint_system_d::Domain>& domain)
{
  Whereabouts result = Whereabouts::INSIDE;
  for (std::size_t j = 0; j < domain.size(); ++j) {
    const Interval lower = enclosure_of(domain[j].first), upper = enclosure_of(domain[j].second);
    if (box[j].sup() < lower.inf() || box[j].inf() > upper.sup())
      return Whereabouts::OUTSIDE;
    if (box[j].inf() < lower.sup() || box[j].sup() > upper.inf())
      result = Whereabouts::OPEN;
  }
  return result;
}

// Whether the inequalities hold on an enclosure of a root.
inline Whereabouts place_in_inequalities(const Box_of_ranges& box, const Sparse_system& system,
                                         const std::vector<Polynomial_constraint>& constraints)
{
  Whereabouts result = Whereabouts::INSIDE;
  for (int i = 0; i < static_cast<int>(constraints.size()); ++i) {
    const Relation relation = constraints[i].second;
    if (relation == Relation::EQUAL)
      continue;
    const Interval value = system.value(i, box);
    if (!(value.inf() > 0 || value.sup() < 0))
      result = Whereabouts::OPEN;
    else if (!is_satisfied(relation, value.inf() > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE))
      return Whereabouts::OUTSIDE;
  }
  return result;
}

/*
Takes the last unknowns, which the last constraints define, away from a root: a region without them still has no other
root where their values on it lie in the ranges that the unknowns had. False when no such region is found.
*/
inline bool forgets_defined_unknowns(Proved_root& root, const Sparse_system& system, int count)
{
  constexpr int most_steps = 60;
  const Box_of_ranges ranges = root.region;
  const int kept = system.dimension() - count;
  Box_of_ranges& region = root.region;
  bool is_found = false;
  for (int step = 0; step < most_steps && !is_found; ++step) {
    is_found = true;
    for (int j = kept; j < system.dimension() && is_found; ++j) {
      region[j] = Interval(0);
      region[j] = system.value(system.definition(j), region);
      is_found = region[j].inf() >= ranges[j].inf() && region[j].sup() <= ranges[j].sup();
    }
    for (int j = 0; j < kept && !is_found; ++j) {
      const Interval& enclosure = root.enclosure[j];
      region[j] = Interval((std::min)(0.5 * region[j].inf() + 0.5 * enclosure.inf(), enclosure.inf()),
                           (std::max)(0.5 * region[j].sup() + 0.5 * enclosure.sup(), enclosure.sup()));
    }
  }
  region.resize(kept);
  root.enclosure.resize(kept);
  return is_found;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Solutions_by_propagation::advance(std::size_t most_nodes)
{
  if (m_is_stopped)
    return true;
  try {
    if (!m_run)
      m_run.emplace(box_of_domain(), m_constraints, m_options, m_control, m_loop);
    return m_run->advance(most_nodes);
  } catch (const Run_stopped& stopped) {
    m_is_stopped = true;
    add_undecided(box_of_domain(), stopped.reason);
    return true;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::add_found()
{
  const Explicit_unknowns& explicit_unknowns = m_run->explicit_unknowns();
  const Sparse_system& system = m_run->system();
  const int dimension = explicit_unknowns.dimension();
  const auto expanded = [&](Box_of_ranges ranges) {
    ranges.resize(dimension);
    return explicit_unknowns.expanded(ranges);
  };
  Propagation_search& search = m_run->search();
  search.end(search.reason() == Undecided_reason::NONE ? Undecided_reason::NODES : search.reason());
  for (Proved_root& root : search.roots())
    if (const int common = system.dimension() - dimension;
        common == 0 || forgets_defined_unknowns(root, system, common))
      add_root(root, system, explicit_unknowns);
    else
      m_open.push_back(expanded(root.enclosure));
  leave_rest(search, m_run->nodes(), expanded);
}

// What is open, and what a limit left.
CGAL_SPLINE_CONSTRAINTS_INLINE void
Solutions_by_propagation::leave_rest(Propagation_search& search, std::size_t nodes,
                                     const std::function<Box_of_ranges(Box_of_ranges)>& expanded)
{
  m_summary.nodes += nodes;
  for (const Box_of_ranges& open : search.undecided())
    m_open.push_back(expanded(open));
  if (!search.rest().empty()) {
    Box_of_ranges hull = search.rest().front();
    for (const Box_of_ranges& part : search.rest())
      extend(hull, part);
    add_undecided(expanded(hull), search.reason());
  }
}

// Every value is defined in the regions of roots: the proofs ask for derivatives there.
CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::search_with_values()
{
  const auto check = [this] { m_control.check(); };
  const Elementary_system elementary(dimension(), m_constraints, *m_values, check);
  const Sparse_system system(elementary.dimension(), elementary.constraints(), check, elementary.terms(),
                             elementary.defined());
  Box_of_ranges box = box_of_domain();
  if (!set_defined_unknowns(system, box))
    return;
  Propagation_search search(system, m_options, m_control, m_loop);
  search.run(box);
  const auto shortened = [this](Box_of_ranges ranges) {
    ranges.resize(dimension());
    return ranges;
  };
  for (Proved_root& root : search.roots()) {
    const Box_of_ranges enclosure = root.enclosure;
    if (!forgets_defined_unknowns(root, system, system.defined())) {
      m_open.push_back(root.enclosure);
      continue;
    }
    const Whereabouts place = place_in_domain(root.enclosure, m_domain);
    const Whereabouts other = place_in_inequalities(enclosure, system, elementary.constraints());
    add_root(std::move(root), place == Whereabouts::OUTSIDE || other == Whereabouts::INSIDE ? place : other);
  }
  leave_rest(search, search.nodes(), shortened);
}

// Where the simplest rational point of an enclosure lies beside the domain and the inequalities, if it is the root.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Whereabouts>
Solutions_by_propagation::exact_place(const Box_of_ranges& enclosure) const
{
  std::vector<Exact_rational> point;
  for (const Interval& range : enclosure)
    point.push_back(simplest_rational_between(Exact_rational(range.inf()), Exact_rational(range.sup())));
  std::optional<std::vector<Exact_rational>> values;
  if (m_values != nullptr && !(values = m_values->rational_values(point)))
    return std::nullopt;
  const auto sign_at_point = [&](const Power_polynomial& polynomial) {
    return CGAL::sign(values ? m_values->rational_value(polynomial, point, *values) : polynomial(point));
  };
  Whereabouts result = Whereabouts::INSIDE;
  for (const auto& [polynomial, relation] : m_constraints)
    if (relation == Relation::EQUAL && sign_at_point(polynomial) != CGAL::ZERO)
      return std::nullopt;
  for (const auto& [polynomial, relation] : m_constraints)
    if (!is_satisfied(relation, sign_at_point(polynomial)))
      result = Whereabouts::OUTSIDE;
  for (std::size_t j = 0; j < point.size(); ++j)
    if (point[j] < m_domain[j].first || m_domain[j].second < point[j])
      result = Whereabouts::OUTSIDE;
  return result;
}

// With the values of explicit unknowns. In the region no other root has those that it has there, whichever they are.
CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::add_root(const Proved_root& found,
                                                                       const Sparse_system& system,
                                                                       const Explicit_unknowns& explicit_unknowns)
{
  Proved_root root{explicit_unknowns.expanded(found.enclosure), explicit_unknowns.expanded(found.region)};
  extend(root.region, root.enclosure);
  Whereabouts place = place_in_domain(root.enclosure, m_domain);
  if (place != Whereabouts::OUTSIDE) {
    // a common part is subtracted from inequalities, too: its unknown is its value there
    Box_of_ranges box = found.enclosure;
    if (system.dimension() > explicit_unknowns.dimension()) {
      box.push_back(Interval(0));
      box.back() = system.value(system.constraints() - 1, box);
    }
    const auto other = place_in_inequalities(box, system, explicit_unknowns.constraints());
    if (other != Whereabouts::INSIDE)
      place = other;
  }
  add_root(std::move(root), place);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::add_root(Proved_root root, Whereabouts place)
{
  if (place == Whereabouts::OPEN)
    place = exact_place(root.enclosure).value_or(Whereabouts::OPEN);
  if (place == Whereabouts::OPEN && m_values != nullptr)
    if (const auto is_solution = m_precise_zeros->is_solution(root))
      place = *is_solution ? Whereabouts::INSIDE : Whereabouts::OUTSIDE;
  if (place == Whereabouts::OPEN && m_values != nullptr)
    add_undecided(root.enclosure,
                  place_in_domain(root.enclosure, m_domain) == Whereabouts::OPEN ? Undecided_reason::DOMAIN_BOUNDARY
                                                                                 : Undecided_reason::INEQUALITY);
  else if (place == Whereabouts::OPEN)
    m_open.push_back(root.enclosure);
  else if (place == Whereabouts::INSIDE) {
    m_solutions.emplace_back(Solution_kind::CERTIFIED, plain(root.enclosure), plain(root.region), "interval",
                             Undecided_reason::NONE, 1);
    m_roots.push_back(std::move(root));
  }
}

// Whether a box is in a region that has one zero, and this is known to be a solution or not.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Solutions_by_propagation::settle_by_precision(const Box_of_ranges& box)
{
  auto zero = m_precise_zeros->around(box);
  if (zero && zero->is_solution &&
      std::ranges::none_of(m_roots, [&](const Proved_root& other) { return are_equal(zero->root, other); }))
    add_root(std::move(zero->root), Whereabouts::INSIDE);
  return zero.has_value();
}

// Boxes that touch are settled together; with functions, whose bounds leave gaps in between, boxes that nearly do.
// So many that they cover a continuum, or what a limit has left, are one box at once.
CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::settle_open()
{
  constexpr std::size_t most_apart = 4096;
  if (const bool is_stopped = m_control.reason() != Undecided_reason::NONE;
      m_values != nullptr && !m_open.empty() && (is_stopped || m_open.size() > most_apart)) {
    Box_of_ranges hull = m_open.front();
    for (const Box_of_ranges& open : m_open)
      extend(hull, open);
    add_undecided(hull, is_stopped ? m_control.reason() : Undecided_reason::CONTINUUM);
    return;
  }
  std::vector<Exact_ranges> boxes;
  for (const Box_of_ranges& open : m_open) {
    Exact_ranges& ranges = boxes.emplace_back();
    for (const Interval& range : open) {
      const Exact_rational gap(m_values == nullptr ? 0 : 1e3 * m_options.tolerance * (std::max)(1.0, magnitude(range)));
      ranges.emplace_back(Exact_rational(range.inf()) - gap, Exact_rational(range.sup()) + gap);
    }
  }
  const std::vector<std::size_t> roots = roots_of_touching(boxes);
  std::map<std::size_t, Box_of_ranges> hulls;
  for (std::size_t i = 0; i < roots.size(); ++i)
    extend(hulls.try_emplace(roots[i], m_open[i]).first->second, m_open[i]);
  for (const auto& [root, hull] : hulls)
    settle(hull);
}

// A little is added around the box, within the domain, so that its own sides are far from what it holds.
CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::settle(const Box_of_ranges& box)
{
  constexpr double most_coefficients = 0x1p18;
  if (m_values != nullptr && settle_by_precision(box))
    return;
  if (m_values != nullptr && exact_place(box) == Whereabouts::INSIDE) {
    m_solutions.emplace_back(Solution_kind::CLUSTER, plain(box), Solution::Box(), "rational");
    return;
  }
  if (m_control.reason() != Undecided_reason::NONE || m_values != nullptr ||
      tensor_size(m_constraints) > most_coefficients) {
    add_undecided(box, m_control.reason() != Undecided_reason::NONE ? m_control.reason() : Undecided_reason::TOLERANCE);
    return;
  }
  std::vector<Constraint_system_d::Domain> around;
  for (int j = 0; j < dimension(); ++j) {
    const double margin = width(box[j]) + 4 * m_options.tolerance * (std::max)(1.0, magnitude(box[j]));
    around.emplace_back(
        (std::max)(Exact_rational((Interval(box[j].inf()) - Interval(margin)).inf()), m_domain[j].first),
        (std::min)(Exact_rational((Interval(box[j].sup()) + Interval(margin)).sup()), m_domain[j].second));
    if (around.back().second < around.back().first)
      return;
  }
  Constraint_system_d system(std::move(around));
  for (const auto& [polynomial, relation] : m_constraints)
    system.add(polynomial, relation);
  Summary work;
  Solver_options options = m_options;
  options.tolerance *= 1e-3; // of boxes that are about as wide as it
  for (Solution& solution :
       all_solutions<Certified_solver_traits, CGAL::Sequential_tag>(system, options, m_control, work))
    add_settled(std::move(solution));
  m_summary += work;
}

// Unless it is certified and known.
CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::add_settled(Solution solution)
{
  if (solution.is_certified()) {
    Proved_root root;
    for (const auto& [lower, upper] : solution.box())
      root.enclosure.emplace_back(lower, upper);
    // a region that has no doubles inside holds no other enclosure
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const auto& [lower, upper] : solution.uniqueness_region())
      root.region.push_back(lower <= upper ? Interval(lower, upper) : Interval(infinity, infinity));
    if (std::any_of(m_roots.begin(), m_roots.end(), [&](const Proved_root& other) { return are_equal(root, other); }))
      return;
    m_roots.push_back(std::move(root));
  }
  m_solutions.push_back(std::move(solution));
}

// All of it: the answers, with the work.
template <class Concurrency_tag>
Solution_set_d<double> solution_set_by_propagation(const std::vector<Constraint_system_d::Domain>& domain,
                                                   const std::vector<Polynomial_constraint>& constraints,
                                                   const Solver_options& options, const Elementary_values& values)
{
  check_polynomials(domain, constraints, values);
  const Upward_rounding_guard guard;
  const Mpfr_precision_scope precision(options.precision);
  Run_control control(options);
  Summary summary;
  auto solutions = Solutions_by_propagation(domain, constraints, options, control, summary,
                                            Parallel_loop::of<Concurrency_tag>(), &values)();
  return finished_set(std::move(solutions), summary, control);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_BY_PROPAGATION_H
