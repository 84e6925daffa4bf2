// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_NARROWED_ANSWER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_NARROWED_ANSWER_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Whether the range of an unknown has a width of at most `share`, relative to its size where that is above one.
inline bool is_narrow(const Constraint_system_d::Domain& range, double share)
{
  const Exact_rational size =
      (std::max)(Exact_rational(CGAL::abs(range.first)), Exact_rational(CGAL::abs(range.second)));
  return range.second - range.first <= Exact_rational(share) * (std::max)(size, Exact_rational(1));
}

/*
A proved answer of the parts of a system in which unknowns that were eliminated with steep slopes have wide ranges, as
the whole system has it in a box around it without other solutions, where it is solved in a few nodes. A cluster that
stays wide is undecided: the parts do not tell its place.
*/
template <class Traits, class Concurrency_tag>
class Narrowed_answer
{
  using Solution = Solution_d<Coordinate_of<Traits>>;

  static constexpr double wide_share = 0x1p-44, widest_share_of_cluster = 1e-4;
  static constexpr std::size_t most_nodes = 64;

  const Constraint_system_d& m_system;
  const System_decomposition& m_decomposition;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_work;

public:
  Narrowed_answer(const Constraint_system_d& system, const System_decomposition& decomposition,
                  const Solver_options& options, Run_control& control, Summary& work)
    : m_system(system), m_decomposition(decomposition), m_options(options), m_control(control), m_work(work)
  {}

  Solution operator()(Solution answer)
  {
    if (answer.kind() >= Solution_kind::CONTINUUM || is_narrow_enough(answer, wide_share))
      return answer;
    if (!m_control.must_stop(true))
      answer = of_whole_system(std::move(answer));
    if (answer.kind() == Solution_kind::CLUSTER && !is_narrow_enough(answer, widest_share_of_cluster))
      return {Solution_kind::UNDECIDED,
              answer.box(),
              {},
              answer.number_type(),
              m_control.must_stop(false) ? m_control.reason() : Undecided_reason::TOLERANCE};
    return answer;
  }

private:
  bool is_narrow_enough(const Solution& answer, double share) const
  {
    if (m_decomposition.eliminated.empty())
      return true;
    const Exact_box box = answer.exact_box();
    return std::all_of(m_decomposition.eliminated.begin(), m_decomposition.eliminated.end(),
                       [&](const Eliminated_unknown& e) { return is_narrow(box[e.unknown], share); });
  }

  Solution of_whole_system(Solution answer)
  {
    const Exact_box region = answer.exact_uniqueness_region();
    Constraint_system_d system(surroundings(answer.exact_box(), region));
    for (const Spline_function& equality : m_system.equalities())
      system.add(equality, Relation::EQUAL);
    for (const auto& [function, relation] : m_system.inequalities())
      system.add(function, relation);
    Solver_options options = rest_of(m_options, m_work);
    options.node_limit = options.node_limit == 0 ? most_nodes : (std::min)(options.node_limit, most_nodes);
    Summary own;
    auto found = all_solutions<Traits, Concurrency_tag>(system, options, m_control, own);
    m_work += own;
    if (found.size() != 1 || found.front().kind() != answer.kind())
      return answer;
    const Exact_box box = found.front().exact_box();
    for (std::size_t j = 0; j < box.size(); ++j)
      if (box[j].first < region[j].first || region[j].second < box[j].second)
        return answer;
    found.front().set_uniqueness_region(region);
    return std::move(found.front());
  }

  // A box in the domain and in the region, with some room around the answer where these allow it.
  Exact_box surroundings(const Exact_box& box, const Exact_box& region) const
  {
    Exact_box result;
    for (std::size_t j = 0; j < box.size(); ++j) {
      const auto& [lower, upper] = m_system.domain(static_cast<int>(j));
      const Exact_rational room = (upper - lower) * Exact_rational(0x1p-30) + box[j].second - box[j].first;
      const Exact_rational begin = (std::max)(region[j].first, Exact_rational(box[j].first - room)),
                           end = (std::min)(region[j].second, Exact_rational(box[j].second + room));
      result.emplace_back((std::max)(lower, (std::min)(box[j].first, begin)),
                          (std::min)(upper, (std::max)(box[j].second, end)));
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_NARROWED_ANSWER_H
