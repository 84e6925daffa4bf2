// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_BY_PROPAGATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_BY_PROPAGATION_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Common_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Explicit_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Krawczyk_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Propagation_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>
#include <CGAL/Spline_constraints_d/solver/internal/union_of_boxes.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/solution_set.h>
#endif

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
All solutions of polynomial constraints in a box: what the search finds; what it leaves open, multiple roots and roots
on the boundary, is settled by the solver that has tensors, on boxes around it, where these are small enough.
*/
class Solutions_by_propagation
{
  using Solution = Solution_d<double>;

  const std::vector<Constraint_system_d::Domain>& m_domain;
  const std::vector<Polynomial_constraint>& m_constraints;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_summary;
  std::vector<Solution> m_solutions;
  std::vector<Proved_root> m_roots; // of the solutions that are certified
  std::vector<Box_of_ranges> m_open;

public:
  Solutions_by_propagation(const std::vector<Constraint_system_d::Domain>& domain,
                           const std::vector<Polynomial_constraint>& constraints, const Solver_options& options,
                           Run_control& control, Summary& summary)
    : m_domain(domain), m_constraints(constraints), m_options(options), m_control(control), m_summary(summary)
  {}

  // In no order.
  std::vector<Solution> operator()()
  {
    try {
      search();
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

  void search();
  void search(const Sparse_system& system, const Box_of_ranges& box, const Explicit_unknowns& explicit_unknowns);
  void add_root(const Proved_root& root, const Sparse_system& system, const Explicit_unknowns& explicit_unknowns);
  void settle_open();
  void settle(const Box_of_ranges& box);
  void add_settled(Solution solution);
};

// Throws where they do not fit each other.
void check_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                       const std::vector<Polynomial_constraint>& constraints);

// All of it: the answers, with the work.
Solution_set_d<double> solution_set_by_propagation(const std::vector<Constraint_system_d::Domain>& domain,
                                                   const std::vector<Polynomial_constraint>& constraints,
                                                   const Solver_options& options);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
enum class Whereabouts
{
  OUTSIDE,
  INSIDE,
  OPEN
};

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
Takes the unknown that stands for the common part away from a root: a region without it still has no other root where
the values of the common part on it lie in the range that the unknown had. False when no such region is found.
*/
inline bool forgets_common_part(Proved_root& root, const Sparse_system& system)
{
  constexpr int most_steps = 60;
  const Interval range = root.region.back();
  Box_of_ranges& region = root.region;
  bool is_found = false;
  for (int step = 0; step < most_steps && !is_found; ++step) {
    region.back() = Interval(0);
    const Interval value = system.value(system.constraints() - 1, region);
    is_found = value.inf() >= range.inf() && value.sup() <= range.sup();
    for (std::size_t j = 0; j + 1 < region.size() && !is_found; ++j) {
      const Interval& enclosure = root.enclosure[j];
      region[j] = Interval((std::min)(0.5 * region[j].inf() + 0.5 * enclosure.inf(), enclosure.inf()),
                           (std::max)(0.5 * region[j].sup() + 0.5 * enclosure.sup(), enclosure.sup()));
    }
  }
  region.pop_back();
  root.enclosure.pop_back();
  return is_found;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::search()
{
  const auto check = [this] { m_control.check(); };
  const Explicit_unknowns explicit_unknowns(box_of_domain(), m_constraints, check);
  const int dimension = explicit_unknowns.dimension();
  Box_of_ranges box = explicit_unknowns.reduced(box_of_domain());
  const Common_part common(explicit_unknowns.constraints(), dimension, check);
  if (common.is_found()) {
    const Sparse_system system(dimension + 1, common.constraints(), check);
    box.push_back(Interval(0));
    box.back() = system.value(system.constraints() - 1, box);
    if (is_finite(box.back())) {
      search(system, box, explicit_unknowns);
      return;
    }
    box.pop_back();
  }
  search(Sparse_system(dimension, explicit_unknowns.constraints(), check), box, explicit_unknowns);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::search(const Sparse_system& system,
                                                                     const Box_of_ranges& box,
                                                                     const Explicit_unknowns& explicit_unknowns)
{
  const int dimension = explicit_unknowns.dimension();
  const auto expanded = [&](Box_of_ranges ranges) {
    ranges.resize(dimension);
    return explicit_unknowns.expanded(ranges);
  };
  Propagation_search search(system, m_options, m_control);
  search.run(box);
  m_summary.nodes += search.nodes();
  for (Proved_root& root : search.roots())
    if (system.dimension() == dimension || forgets_common_part(root, system))
      add_root(root, system, explicit_unknowns);
    else
      m_open.push_back(expanded(root.enclosure));
  for (const Box_of_ranges& open : search.undecided())
    m_open.push_back(expanded(open));
  if (!search.rest().empty()) {
    Box_of_ranges hull = search.rest().front();
    for (const Box_of_ranges& part : search.rest())
      extend(hull, part);
    add_undecided(expanded(hull), search.reason());
  }
}

// The simplest rational point of an enclosure, if it is the root.
inline std::vector<Exact_rational> rational_root(const Box_of_ranges& enclosure,
                                                 const std::vector<Polynomial_constraint>& constraints)
{
  std::vector<Exact_rational> point;
  for (const Interval& range : enclosure)
    point.push_back(simplest_rational_between(Exact_rational(range.inf()), Exact_rational(range.sup())));
  const bool is_root =
      std::all_of(constraints.begin(), constraints.end(), [&](const Polynomial_constraint& constraint) {
        return constraint.second != Relation::EQUAL || constraint.first(point) == 0;
      });
  return is_root ? point : std::vector<Exact_rational>();
}

// Whether a point is in the domain and satisfies the inequalities.
inline Whereabouts place_of_point(const std::vector<Exact_rational>& point,
                                  const std::vector<Constraint_system_d::Domain>& domain,
                                  const std::vector<Polynomial_constraint>& constraints)
{
  for (std::size_t j = 0; j < point.size(); ++j)
    if (point[j] < domain[j].first || domain[j].second < point[j])
      return Whereabouts::OUTSIDE;
  const bool satisfies =
      std::all_of(constraints.begin(), constraints.end(), [&](const Polynomial_constraint& constraint) {
        return is_satisfied(constraint.second, CGAL::sign(constraint.first(point)));
      });
  return satisfies ? Whereabouts::INSIDE : Whereabouts::OUTSIDE;
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
  if (place == Whereabouts::OPEN)
    if (const auto point = rational_root(root.enclosure, m_constraints); !point.empty())
      place = place_of_point(point, m_domain, m_constraints);
  if (place == Whereabouts::OPEN)
    m_open.push_back(root.enclosure);
  else if (place == Whereabouts::INSIDE) {
    m_solutions.emplace_back(Solution_kind::CERTIFIED, plain(root.enclosure), plain(root.region), "interval",
                             Undecided_reason::NONE, 1);
    m_roots.push_back(std::move(root));
  }
}

// Boxes that touch are settled together.
CGAL_SPLINE_CONSTRAINTS_INLINE void Solutions_by_propagation::settle_open()
{
  std::vector<Exact_ranges> boxes;
  for (const Box_of_ranges& open : m_open) {
    Exact_ranges& ranges = boxes.emplace_back();
    for (const Interval& range : open)
      ranges.emplace_back(Exact_rational(range.inf()), Exact_rational(range.sup()));
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
  if (m_control.reason() != Undecided_reason::NONE || tensor_size(m_constraints) > most_coefficients) {
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

CGAL_SPLINE_CONSTRAINTS_INLINE void check_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                                                      const std::vector<Polynomial_constraint>& constraints)
{
  const Constraint_system_d checked(domain); // throws when a range is empty
  std::size_t equalities = 0;
  for (const auto& [polynomial, relation] : constraints) {
    equalities += relation == Relation::EQUAL;
    if (const auto unknowns = polynomial.variables();
        !unknowns.empty() && unknowns.back() >= static_cast<int>(domain.size()))
      throw Invalid_input("Propagation_solver_d: unknown " + std::to_string(unknowns.back()) +
                          " of a polynomial has no range");
  }
  if (equalities != domain.size())
    throw Invalid_input("Propagation_solver_d: " + std::to_string(equalities) + " equalities for " +
                        std::to_string(domain.size()) +
                        " unknowns, where it takes as many; see solve(), solve_curves(), solve_surfaces() and "
                        "find_feasible_point()");
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solution_set_d<double>
solution_set_by_propagation(const std::vector<Constraint_system_d::Domain>& domain,
                            const std::vector<Polynomial_constraint>& constraints, const Solver_options& options)
{
  check_polynomials(domain, constraints);
  const Upward_rounding_guard guard;
  const Mpfr_precision_scope precision(options.precision);
  Run_control control(options);
  Summary summary;
  auto solutions = Solutions_by_propagation(domain, constraints, options, control, summary)();
  return finished_set(std::move(solutions), summary, control);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_BY_PROPAGATION_H
