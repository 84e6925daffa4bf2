// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_CLUSTERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_CLUSTERS_H

#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_collection.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Subdivision.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Why a root is undecided that has a proof.
inline Undecided_reason reason_of(Position position)
{
  return position == Position::ON_DOMAIN_BOUNDARY ? Undecided_reason::DOMAIN_BOUNDARY
         : position == Position::ON_INEQUALITY    ? Undecided_reason::INEQUALITY
         : position == Position::ON_EQUALITY      ? Undecided_reason::OVERDETERMINED
                                                  : Undecided_reason::NONE;
}

// A regular root, unless it lies outside of the domain.
template <class NT, class Coordinate>
void report_root(Found_root<Coordinate> root, std::vector<Solution_d<Coordinate>>& solutions)
{
  if (root.position == Position::OUTSIDE)
    return;
  const Undecided_reason reason = reason_of(root.position);
  const Solution_kind kind = reason == Undecided_reason::NONE ? Solution_kind::CERTIFIED : Solution_kind::UNDECIDED;
  solutions.emplace_back(kind, std::move(root.enclosure), std::move(root.region), Number_traits<NT>::name, reason, 1);
}

template <class Coordinate>
bool boxes_meet(const Open_box<Coordinate>& a, const Open_box<Coordinate>& b)
{
  for (std::size_t j = 0; j < a.lower.size(); ++j)
    if (a.upper[j] < b.lower[j] || b.upper[j] < a.lower[j])
      return false;
  return true;
}

// Replaces boxes that meet by their hulls until no two meet: sweeps along the first axis.
template <class Coordinate>
void merge_boxes_that_meet(std::vector<Open_box<Coordinate>>& boxes)
{
  for (bool has_merged = true; has_merged;) {
    has_merged = false;
    std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.lower < b.lower; });
    std::vector<Open_box<Coordinate>> merged;
    std::vector<std::size_t> active;   // boxes of `merged` that the sweep has not left behind
    for (auto& box : boxes) {
      std::erase_if(active, [&](std::size_t i) { return merged[i].upper[0] < box.lower[0]; });
      const auto partner =
        std::find_if(active.begin(), active.end(), [&](std::size_t i) { return boxes_meet(merged[i], box); });
      if (partner == active.end()) {
        active.push_back(merged.size());
        merged.push_back(std::move(box));
        continue;
      }
      has_merged = true;
      Open_box<Coordinate>& target = merged[*partner];
      for (std::size_t j = 0; j < box.lower.size(); ++j) {
        target.lower[j] = (std::min)(target.lower[j], box.lower[j]);
        target.upper[j] = (std::max)(target.upper[j], box.upper[j]);
      }
      if (target.reason == Undecided_reason::TOLERANCE)
        target.reason = box.reason;
    }
    boxes = std::move(merged);
  }
}

// Narrow beside its place on all axes: what it holds cannot be told apart, and it is not the cover of a long curve.
template <class Coordinate>
bool is_small(const Open_box<Coordinate>& box)
{
  for (std::size_t j = 0; j < box.lower.size(); ++j) {
    const double lower = CGAL::to_double(box.lower[j]), upper = CGAL::to_double(box.upper[j]);
    if (upper - lower > 1e-4 * (std::max)({1.0, std::abs(lower), std::abs(upper)}))
      return false;
  }
  return true;
}

// The simplest rational point of a box and the domain when it solves the system; empty otherwise.
template <class Coordinate>
std::vector<Exact_rational> rational_solution_in(const Constraint_system_d& system, const Open_box<Coordinate>& box)
{
  std::vector<Exact_rational> point;
  for (std::size_t j = 0; j < box.lower.size(); ++j) {
    const Exact_rational lower = (std::max)(Exact_rational(box.lower[j]), system.domain(static_cast<int>(j)).first);
    const Exact_rational upper = (std::min)(Exact_rational(box.upper[j]), system.domain(static_cast<int>(j)).second);
    if (upper < lower)
      return {};
    point.push_back(simplest_rational_between(lower, upper));
  }
  return satisfies(system, point) ? point : std::vector<Exact_rational>();
}

// A solution in a small box, in the interior of the domain, with some rational coordinates, if that can be proved; one
// that is only near the box may be that of another box.
// Chance puts a rational of about log2(1/width) bits into any range: only clearly shorter ones are tried.
template <class Coordinate>
Partly_rational_solution partly_rational_solution_in(const Constraint_system_d& system, const Open_box<Coordinate>& box)
{
  const Partly_rational_solution none{Partial_point(box.lower.size()), {}, {}};
  if (!system.inequalities().empty())
    return none;
  double width = 0;
  for (std::size_t j = 0; j < box.lower.size(); ++j) {
    const Exact_rational lower(box.lower[j]), upper(box.upper[j]), margin(upper - lower);
    if (lower - margin < system.domain(static_cast<int>(j)).first ||
        system.domain(static_cast<int>(j)).second < upper + margin)
      return none;
    width = (std::max)(width, CGAL::to_double(margin));
  }
  const std::vector<Exact_rational> lower(box.lower.begin(), box.lower.end()),
      upper(box.upper.begin(), box.upper.end());
  Partly_rational_solution result =
      partly_rational_solution(system, lower, upper, static_cast<long>(-0.6 * std::log2(width)));
  for (std::size_t j = 0; j < lower.size(); ++j)
    if (result.is_proved() && (result.lower[j] < lower[j] || upper[j] < result.upper[j]))
      return none;
  return result;
}

/*
What an open box is, after those that meet have become one. Everything around such a group was proved empty, so when it
is small and provably holds a root, all or some of whose coordinates are rational, it is a cluster; the rest stays
undecided. `is_zero_of_factor`: of a common factor of the equalities; there it has no multiplicity.
*/
template <class NT, class Coordinate>
Solution_d<Coordinate> classified(const Constraint_system_d& system, const Open_box<Coordinate>& box,
                                  bool is_zero_of_factor = false)
{
  Solution_kind kind = Solution_kind::UNDECIDED;
  Undecided_reason reason = box.reason;
  int multiplicity = 0;
  if (reason == Undecided_reason::TOLERANCE && !is_small(box))
    reason = Undecided_reason::CONTINUUM;
  if (reason == Undecided_reason::TOLERANCE) {
    if (const auto point = rational_solution_in(system, box); !point.empty()) {
      kind = Solution_kind::CLUSTER;
      reason = Undecided_reason::NONE;
      multiplicity = is_zero_of_factor ? 0 : local_structure(system, point).multiplicity;
    } else if (partly_rational_solution_in(system, box).is_proved()) {
      kind = Solution_kind::CLUSTER;
      reason = Undecided_reason::NONE;
    }
  }
  return {kind, make_box(box.lower, box.upper), {}, Number_traits<NT>::name, reason, multiplicity};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_CLUSTERS_H
