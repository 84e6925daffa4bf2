// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_DECOMPOSED_SOLUTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_DECOMPOSED_SOLUTIONS_H

#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Glance_at_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Joined_answer.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Narrowed_answer.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#endif

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Calls visit() for every choice of one element of each list, in lexicographic order, until it returns false; then
// returns false.
template <class T, class Visitor>
bool for_each_choice(const std::vector<std::vector<T>>& lists, std::vector<const T*>& chosen, const Visitor& visit)
{
  if (chosen.size() == lists.size())
    return visit();
  return std::all_of(lists[chosen.size()].begin(), lists[chosen.size()].end(), [&](const T& element) {
    chosen.push_back(&element);
    const bool goes_on = for_each_choice(lists, chosen, visit);
    chosen.pop_back();
    return goes_on;
  });
}

// One box around answers, undecided for the given reason.
template <class Coordinate>
Solution_d<Coordinate> undecided_hull(const std::vector<Solution_d<Coordinate>>& answers, Undecided_reason reason)
{
  auto box = answers.front().box();
  for (const auto& answer : answers)
    for (std::size_t j = 0; j < box.size(); ++j) {
      box[j].first = (std::min)(box[j].first, answer[j].first);
      box[j].second = (std::max)(box[j].second, answer[j].second);
    }
  return {Solution_kind::UNDECIDED, std::move(box), {}, answers.front().number_type(), reason};
}

// However early a run ends, so many of the answers that were found by then are told one by one.
constexpr std::size_t answers_told_in_any_case = 1000;

// All combinations of the answers of the parts, as `finished(answer)` returns them; where the run ends before, the rest
// is in one undecided box.
template <class Coordinate, class Finished>
std::vector<Solution_d<Coordinate>> combined_answers(const Constraint_system_d& system,
                                                     const System_decomposition& decomposition,
                                                     const std::vector<std::vector<Solution_d<Coordinate>>>& answers,
                                                     Run_control& control, Finished finished)
{
  std::vector<Solution_d<Coordinate>> result;
  std::vector<const Solution_d<Coordinate>*> chosen;
  const auto join = [&] { return Joined_answer<Coordinate>(system, decomposition, chosen).solution(); };
  const bool are_all = for_each_choice(answers, chosen, [&] {
    if (result.size() >= answers_told_in_any_case && control.must_stop(result.size() % 64 == 0))
      return false;
    result.push_back(finished(join()));
    return true;
  });
  if (are_all)
    return result;
  std::vector<Solution_d<Coordinate>> hulls;
  for (const auto& of_part : answers)
    hulls.push_back(undecided_hull(of_part, control.reason()));
  for (const auto& hull : hulls)
    chosen.push_back(&hull);
  result.push_back(join());
  return result;
}

// All solutions of a system, in the nodes that other ones have left; the work is added to theirs.
template <class Traits, class Concurrency_tag>
std::vector<Solution_d<Coordinate_of<Traits>>> all_solutions_after(const Constraint_system_d& system,
                                                                   const Solver_options& options, Run_control& control,
                                                                   Summary& work)
{
  const Solver_options rest = rest_of(options, work); // of the time the control knows
  Summary own;
  control.begin_part();
  auto result = all_solutions<Traits, Concurrency_tag>(system, rest, control, own);
  work += own;
  return result;
}

/*
All solutions of a decomposed system, in no order, each part solved on its own. A part without solutions ends the work:
the whole system has none. The limit on nodes is for all parts together.
*/
template <class Traits, class Concurrency_tag>
std::vector<Solution_d<Coordinate_of<Traits>>>
solutions_of_parts(const Constraint_system_d& system, const System_decomposition& decomposition,
                   const Solver_options& options, Run_control& control, Summary& summary)
{
  if (decomposition.is_without_solutions)
    return {};
  if (decomposition.parts.empty())
    return all_solutions_after<Traits, Concurrency_tag>(system, options, control, summary);
  std::vector<std::vector<Solution_d<Coordinate_of<Traits>>>> answers;
  for (const System_part& part : decomposition.parts) {
    answers.push_back(all_solutions_after<Traits, Concurrency_tag>(part.system, options, control, summary));
    if (answers.back().empty())
      return {};
  }
  return combined_answers(system, decomposition, answers, control,
                          Narrowed_answer<Traits, Concurrency_tag>(system, decomposition, options, control, summary));
}

template <class Coordinate>
bool is_decided(const std::vector<Solution_d<Coordinate>>& answers)
{
  return std::none_of(answers.begin(), answers.end(),
                      [](const auto& answer) { return answer.kind() == Solution_kind::UNDECIDED; });
}

// Something is undecided since the run was ended.
template <class Coordinate>
bool has_limits_reached(const std::vector<Solution_d<Coordinate>>& answers)
{
  return std::any_of(answers.begin(), answers.end(), [](const auto& answer) {
    return answer.reason() == Undecided_reason::TIME || answer.reason() == Undecided_reason::NODES ||
        answer.reason() == Undecided_reason::STOPPED;
  });
}

// What was left at the limit of a trial is undecided since the run as a whole has ended.
template <class Coordinate>
void replace_limit_of_nodes(std::vector<Solution_d<Coordinate>>& answers, Undecided_reason reason)
{
  for (Solution_d<Coordinate>& answer : answers)
    if (answer.reason() == Undecided_reason::NODES)
      answer = {Solution_kind::UNDECIDED, answer.box(), {}, answer.number_type(), reason};
}

// Nodes in which a system is to be solved that is not worth being decomposed.
constexpr std::size_t nodes_of_small_system = 256;

/*
All solutions of a system, in no order. What is solved in a few nodes is solved as it is: decomposing it would take
longer. These nodes are lost in other systems, unless a glance shows that decomposing them promises nothing. What the
parts leave undecided, without limits, may be decided by the whole.
*/
template <class Traits, class Concurrency_tag>
std::vector<Solution_d<Coordinate_of<Traits>>> decomposed_solutions(const Constraint_system_d& system,
                                                                    const Solver_options& options, Run_control& control,
                                                                    Summary& summary)
{
  const bool may_be_large = options.node_limit == 0 || options.node_limit > nodes_of_small_system;
  if (!may_be_large || system.dimension() == 1 || !Glance_at_system(system).is_promising())
    return all_solutions<Traits, Concurrency_tag>(system, options, control, summary);

  Solver_options few_nodes = options;
  few_nodes.node_limit = nodes_of_small_system;
  Summary trial;
  std::vector<Solution_d<Coordinate_of<Traits>>> result =
      all_solutions<Traits, Concurrency_tag>(system, few_nodes, control, trial);
  summary += trial;
  const bool is_at_end = trial.nodes < nodes_of_small_system && !has_limits_reached(result);
  if (is_decided(result) || is_at_end)
    return result;

  System_decomposition decomposition;
  const double start = control.seconds();
  try {
    decomposition = decomposition_of(system, [&] { control.check(); });
  } catch (const Run_stopped& stopped) {
    replace_limit_of_nodes(result, stopped.reason);
    return result;
  }
  summary.setup_seconds += control.seconds() - start;
  result = solutions_of_parts<Traits, Concurrency_tag>(system, decomposition, options, control, summary);
  if (decomposition.parts.empty() || has_limits_reached(result) || is_decided(result))
    return result;
  auto whole = all_solutions_after<Traits, Concurrency_tag>(system, options, control, summary);
  return has_limits_reached(whole) ? result : whole;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_DECOMPOSED_SOLUTIONS_H
