// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FARTHEST_POINT_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FARTHEST_POINT_SEARCH_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Curve_tree.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
max_u min_v |A(u) - B(v)|^2, by branch and bound. At the middle of a range of u, the least distance from B is bounded
from below: so is the maximum. On the range, it is bounded from above by the distances from points of B that move with
u.
*/
template <int d>
class Farthest_point_search
{
  struct Task
  {
    const Curve_tree<d>* node;
    double upper;
  };

  const Curve_tree<d>&m_from, &m_to;
  const double m_tolerance;
  Run_control& m_control;

public:
  struct Result
  {
    double lower, upper;                       // of the squared distance
    std::array<const Curve_tree<d>*, 2> nodes; // with the points in their middles
    std::size_t nodes_looked_at = 0;
    std::vector<const Curve_tree<d>*> rest = {}; // parts of the curve that may be farther than the tolerance allows
  };

  Farthest_point_search(const Curve_tree<d>& from, const Curve_tree<d>& to, double tolerance, Run_control& control)
    : m_from(from), m_to(to), m_tolerance(tolerance), m_control(control)
  {}

  // Makes bounds of a known distance those of the larger one of that and this.
  void include_in(Result& best) const
  {
    const auto is_nearer = [](const Task& p, const Task& q) { return p.upper < q.upper; };
    std::vector<Task> tasks;
    const auto push = [&](const Curve_tree<d>& node, double upper) {
      const Nearest_point<d> nearest = nearest_point<d>(m_to, node.middle_point(), m_tolerance / 4);
      if (nearest.lower > best.lower) {
        best.lower = nearest.lower;
        best.nodes = {&node, nearest.node};
      }
      ++best.nodes_looked_at;
      tasks.push_back({&node, (std::min)(upper, upper_bound(node, *nearest.node))});
      std::push_heap(tasks.begin(), tasks.end(), is_nearer);
    };
    push(m_from, std::numeric_limits<double>::infinity());
    const auto is_settled = [&](const Task& task) { return roots_are_within(best.lower, task.upper, m_tolerance); };
    while (!is_settled(tasks.front()) && !tasks.front().node->is_tiny() && !m_control.must_stop(true)) {
      std::pop_heap(tasks.begin(), tasks.end(), is_nearer);
      const Task task = tasks.back();
      tasks.pop_back();
      for (const Curve_tree<d>& child : task.node->children())
        push(child, task.upper);
    }
    best.upper = (std::max)({best.upper, best.lower, tasks.front().upper});
    for (const Task& task : tasks)
      if (!is_settled(task))
        best.rest.push_back(task.node);
  }

private:
  // Of the distances of a range of A from B: from the point of B in the middle of a part, and from points B(v + s(u -
  // m)) that follow A(u).
  double upper_bound(const Curve_tree<d>& from, const Curve_tree<d>& nearest) const
  {
    const double from_point = from.squared_distance_bounds(nearest.middle_point()).sup(),
                 speed = nearest.speed_along(from);
    const Exact_rational reach(to_rational(from.radius()) * to_rational(std::abs(speed)));
    const Parameter_range range(Exact_rational(nearest.middle() - reach), Exact_rational(nearest.middle() + reach));
    const auto [first, last] = m_to.patch().domain(0);
    if (reach == 0 || range.first < first || last < range.second)
      return from_point;
    return (std::min)(from_point,
                      moving_distance_bound(from, nearest.middle_point(), m_to.tangents_over(range), speed));
  }

  // By the mean value theorem, D = A - B lies in D(m) + (A' - s B') (u - m), and the derivative of |D|^2 in 2 <D, A' -
  // s B'>.
  static double moving_distance_bound(const Curve_tree<d>& a, const Double_intervals<d>& b_middle,
                                      const Double_intervals<d>& b_tangents, double speed)
  {
    const Double_intervals<d> slope = moved_along(a.tangents(), -speed, b_tangents),
                              at_middle = a.middle_point() - b_middle,
                              offset = moved_along(at_middle, a.steps(), slope);
    return (std::min)(squared_norm(offset).sup(),
                      (squared_norm(at_middle) + 2.0 * dot(offset, slope) * a.steps()).sup());
  }
};

template <int d>
Found_hausdorff_distance<d> hausdorff_distance_of(const Exact_map<d>& first, const Exact_map<d>& second,
                                                  double tolerance, bool is_one_sided, const Solver_options& options)
{
  options.check();
  Run_control control(options);
  const std::array<Curve_tree<d>, 2> curves{Curve_tree<d>(Spline_patch<d>(first)),
                                            Curve_tree<d>(Spline_patch<d>(second))};
  typename Farthest_point_search<d>::Result result{-1, 0, {}}; // any distance is larger
  std::size_t curve = 0, rest_of_first = 0;
  {
    [[maybe_unused]] const Upward_rounding_guard guard;
    Farthest_point_search<d>(curves[0], curves[1], tolerance, control).include_in(result);
    rest_of_first = result.rest.size();
    if (!is_one_sided) {
      const double known = result.lower;
      Farthest_point_search<d>(curves[1], curves[0], tolerance, control).include_in(result);
      curve = result.lower > known ? 1 : 0;
    }
  }
  if (curve == 1)
    std::swap(result.nodes[0], result.nodes[1]);
  const auto parameter = [&](std::size_t i) { return result.nodes[i]->middle(); };
  const auto point = [&](std::size_t i) { return curves[i].patch()(std::array{parameter(i)}); };
  Found_hausdorff_distance<d> found{{to_rational(result.lower), to_rational(result.upper)},
                                    curve,
                                    {parameter(0), parameter(1)},
                                    {point(0), point(1)},
                                    {},
                                    {}};
  const Undecided_reason reason =
      control.reason() == Undecided_reason::NONE ? Undecided_reason::TOLERANCE : control.reason();
  for (std::size_t i = 0; i < result.rest.size(); ++i) {
    const std::size_t operand = i < rest_of_first ? 0 : 1;
    const Parameter_range range = result.rest[i]->range();
    found.undecided.push_back({double_ranges(curves[operand].patch().part(0, range).values()),
                               {{operand, {double_range(range)}}},
                               in_words(reason)});
  }
  found.summary.nodes = result.nodes_looked_at;
  found.summary.seconds = control.seconds();
  found.summary.is_complete = found.undecided.empty();
  found.summary.why_not = found.summary.is_complete ? Undecided_reason::NONE : reason;
  return found;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FARTHEST_POINT_SEARCH_H
