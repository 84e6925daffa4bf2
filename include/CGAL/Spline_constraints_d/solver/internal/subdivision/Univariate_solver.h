// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_SOLVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_SOLVER_H

#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Univariate_cell.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Univariate_walk.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
All solutions of a system in one unknown. Cell by cell, the roots in the interior come from `Univariate_walk`, those at
its ends from exact division, and the inequalities are decided, in exact arithmetic where intervals do not decide them;
then the cells are joined, and regions laid between neighbours. So nothing is undecided unless a limit is reached.
*/
class Univariate_solver
{
  using Solution = Solution_d<double>;

  // What is known of a cell. The multiplicities at its ends are 0 where the equalities do not vanish there.
  struct Cell_answers
  {
    std::vector<Univariate_answer> inside;
    // the common one of the equalities, without its roots at the ends; zero where all of them are
    Integer_polynomial polynomial;
    int lower_multiplicity = 0, upper_multiplicity = 0;
  };

  const Constraint_system_d& m_system;
  double m_start;   // on the clock of the control
  Univariate_walk m_walk;
  std::vector<Univariate_cell> m_cells;
  std::vector<Cell_answers> m_found;          // per cell
  std::vector<Univariate_answer> m_answers;   // from left to right

public:
  Univariate_solver(const Constraint_system_d& system, const Solver_options& options, Run_control& control,
                    Summary& summary)
    : m_system(system), m_start(control.seconds()), m_walk(options, control, summary), m_cells(univariate_cells(system))
  {
    summary.setup_seconds = control.seconds() - m_start;
  }

  std::vector<Solution> solve()
  {
    for (const Univariate_cell& cell : m_cells)
      m_found.push_back(solve(cell));
    join();
    std::vector<Solution> solutions;
    for (std::size_t i = 0; i < m_answers.size(); ++i)
      if (m_answers[i].is_solution)
        solutions.push_back(reported(i));
    return solutions;
  }

private:
  Cell_answers solve(const Univariate_cell& cell)
  {
    Cell_answers result;
    result.polynomial = cell.common_equality();
    if (result.polynomial.is_zero()) {
      result.inside = satisfying_parts(cell);
      return result;
    }
    result.lower_multiplicity = result.polynomial.remove_root(cell.lower);
    if (cell.lower < cell.upper)
      result.upper_multiplicity = result.polynomial.remove_root(cell.upper);
    result.inside = m_walk.run(result.polynomial, cell.lower, cell.upper, share_of(cell));
    for (Univariate_answer& answer : result.inside)
      if (answer.kind != Solution_kind::UNDECIDED && !cell.inequalities.empty()) {
        Exact_root root = m_walk.exact_root(answer);
        const Exact_rational width = root.width();
        answer.is_solution = satisfies_inequalities(cell, root);
        if (answer.exact || root.width() < width)
          answer.exact = std::move(root);
      }
    return result;
  }

  // The part of the domain that the cell is.
  double share_of(const Univariate_cell& cell) const
  {
    const auto& [lower, upper] = m_system.domain(0);
    return m_cells.size() == 1 ? 1 : CGAL::to_double(Exact_rational((cell.upper - cell.lower) / (upper - lower)));
  }

  bool satisfies_inequalities(const Univariate_cell& cell, Exact_root& root) const
  {
    for (std::size_t i = 0; i < cell.inequalities.size(); ++i)
      if (!is_satisfied(m_system.inequalities()[i].relation, root.sign_of_value(cell.inequalities[i])))
        return false;
    return true;
  }

  bool satisfies_inequalities(const Univariate_cell& cell, const Exact_rational& x) const
  {
    Exact_root point(x);
    return satisfies_inequalities(cell, point);
  }

  // A cell where all equalities vanish: the roots of the inequalities cut it into parts that are solutions as a whole,
  // or not at all.
  std::vector<Univariate_answer> satisfying_parts(const Univariate_cell& cell)
  {
    if (cell.lower == cell.upper)
      return {};
    Integer_polynomial product(std::vector<Big_integer>(1, Big_integer(1)));
    for (const Integer_polynomial& inequality : cell.inequalities)
      if (!inequality.is_zero())
        product = product * inequality;
    product.remove_root(cell.lower);
    product.remove_root(cell.upper);
    std::vector<std::pair<Exact_root, int>> cuts;
    if (product.degree() > 0)
      cuts = m_walk.exact_roots(product, cell.lower, cell.upper);
    if (!cell.inequalities.empty() && m_walk.is_over())
      return {interval_answer(Solution_kind::UNDECIDED, cell.lower, cell.upper, m_walk.reason())};

    const auto begin_of_part = [&](std::size_t i) { return i == 0 ? cell.lower : cuts[i - 1].first.upper(); };
    const auto end_of_part = [&](std::size_t i) { return i == cuts.size() ? cell.upper : cuts[i].first.lower(); };
    std::vector<bool> is_part_in, is_cut_in;
    for (std::size_t i = 0; i <= cuts.size(); ++i)
      is_part_in.push_back(
          satisfies_inequalities(cell, Exact_rational((begin_of_part(i) + end_of_part(i)) / Exact_rational(2))));
    for (auto& [root, multiplicity] : cuts)
      is_cut_in.push_back(satisfies_inequalities(cell, root));

    std::vector<Univariate_answer> answers;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      if (is_part_in[i]) {
        const Exact_rational begin = i == 0 ? cell.lower : cuts[i - 1].first.lower();
        while (i < cuts.size() && is_cut_in[i] && is_part_in[i + 1])
          ++i;
        answers.push_back(
            interval_answer(Solution_kind::CONTINUUM, begin, i == cuts.size() ? cell.upper : cuts[i].first.upper()));
      } else if (i < cuts.size() && is_cut_in[i] && !is_part_in[i + 1])
        answers.push_back({Solution_kind::CLUSTER, Undecided_reason::NONE, 0, cuts[i].first});
    }
    return answers;
  }

  // Puts the answers of the cells and those at their ends one after the other. Continua, and undecided intervals, that
  // meet become one.
  void join()
  {
    const bool is_point = m_cells.front().lower == m_cells.front().upper;
    for (std::size_t i = 0; i <= m_cells.size(); ++i) {
      if (i == 0 || !is_point)
        add_end(i == m_cells.size() ? m_cells[i - 1].upper : m_cells[i].lower, i);
      if (i < m_cells.size())
        for (Univariate_answer& answer : m_found[i].inside)
          add(std::move(answer));
    }
  }

  // The point between the cells i - 1 and i, or at an end of the domain. Where a continuum begins or ends it adds
  // nothing but that two of them are one.
  void add_end(const Exact_rational& x, std::size_t i)
  {
    const bool has_left = i > 0, has_right = i < m_cells.size();
    const auto vanishes = [](const Cell_answers& found, int multiplicity) {
      return found.polynomial.is_zero() || multiplicity > 0;
    };
    if ((has_left && !vanishes(m_found[i - 1], m_found[i - 1].upper_multiplicity)) ||
        (has_right && !vanishes(m_found[i], m_found[i].lower_multiplicity)))
      return;
    const bool is_solution = satisfies_inequalities(m_cells[has_right ? i : i - 1], x);
    const bool ends_continuum = has_left && !m_answers.empty() && m_answers.back().kind == Solution_kind::CONTINUUM &&
        m_answers.back().end() == x;
    const bool begins_continuum = has_right && !m_found[i].inside.empty() &&
        m_found[i].inside.front().kind == Solution_kind::CONTINUUM && m_found[i].inside.front().begin() == x;
    if (ends_continuum || begins_continuum) {
      if (ends_continuum && begins_continuum && is_solution) {
        m_found[i].inside.front() =
            interval_answer(Solution_kind::CONTINUUM, m_answers.back().begin(), m_found[i].inside.front().end());
        m_answers.pop_back();
      }
      return;
    }
    Univariate_answer answer{Solution_kind::CLUSTER, Undecided_reason::NONE, 0, Exact_root(x)};
    answer.is_solution = is_solution;
    if (!has_left || !has_right)
      answer.multiplicity = has_right ? m_found[i].lower_multiplicity : m_found[i - 1].upper_multiplicity;
    else if (is_monotonic_around(x, m_cells[i - 1], m_cells[i]))
      answer.multiplicity = 1;
    else if (const int left = m_found[i - 1].upper_multiplicity; left > 1 && left == m_found[i].lower_multiplicity)
      answer.multiplicity = local_structure(m_system, {x}).multiplicity;   // unless a derivative that matters jumps
    if (answer.multiplicity == 1)
      answer.kind = Solution_kind::CERTIFIED;
    m_answers.push_back(std::move(answer));
  }

  // Some equality increases, or decreases, on both sides of a break with a slope that is not zero.
  static bool is_monotonic_around(const Exact_rational& x, const Univariate_cell& left, const Univariate_cell& right)
  {
    for (std::size_t i = 0; i < left.equalities.size(); ++i)
      if (left.equalities[i].derivative().sign_at(x) * right.equalities[i].derivative().sign_at(x) > 0)
        return true;
    return false;
  }

  void add(Univariate_answer answer)
  {
    if (!m_answers.empty() && answer.kind == Solution_kind::UNDECIDED &&
        m_answers.back().kind == Solution_kind::UNDECIDED && m_answers.back().end() == answer.begin())
      m_answers.back() =
          interval_answer(Solution_kind::UNDECIDED, m_answers.back().begin(), answer.end(), answer.reason);
    else
      m_answers.push_back(std::move(answer));
  }

  Solution reported(std::size_t i) const { return m_answers[i].exact ? exact_solution(i) : double_solution(i); }

  // The region of a root ends half way to the next answers, of those that do not satisfy the inequalities too; at the
  // ends of the domain, or beyond them if it lies there.
  Solution double_solution(std::size_t i) const
  {
    const Univariate_answer& answer = m_answers[i];
    const auto [first, last] = m_system.domain(0);
    double begin = i == 0 ? to_double_interval(first).second : upper_end(m_answers[i - 1]);
    double end = i + 1 == m_answers.size() ? to_double_interval(last).first : lower_end(m_answers[i + 1]);
    if (i > 0)
      begin = middle(begin, answer.lower);
    if (i + 1 < m_answers.size())
      end = middle(end, answer.upper);
    const Solution::Box region{{(std::min)(begin, answer.lower), (std::max)(end, answer.upper)}};
    return Solution(answer.kind, {{answer.lower, answer.upper}}, region, Number_traits<double>::name, answer.reason,
                    answer.multiplicity);
  }

  Solution exact_solution(std::size_t i) const
  {
    using Fine = Solution_d<Exact_rational>;
    const Univariate_answer& answer = m_answers[i];
    const Exact_rational &begin = answer.exact->lower(), &end = answer.exact->upper(), two(2);
    Fine::Box region;
    if (answer.kind == Solution_kind::CERTIFIED) {
      const auto [first, last] = m_system.domain(0);
      const Exact_rational lower = i > 0 ? Exact_rational((m_answers[i - 1].end() + begin) / two)
          : first < begin                ? first
                                         : beyond(begin, m_found.front().polynomial, -1);
      const bool has_right = i + 1 < m_answers.size();
      const Exact_rational upper = has_right ? Exact_rational((m_answers[i + 1].begin() + end) / two)
          : end < last                       ? last
                                             : beyond(end, m_found.back().polynomial, 1);
      region.emplace_back(lower, upper);
    }
    if (answer.kind == Solution_kind::CLUSTER) {   // within the domain
      const auto [first, last] = m_system.domain(0);
      const Exact_rational lower =
          i > 0 ? Exact_rational((m_answers[i - 1].end() + begin) / two) : (std::min)(first, begin);
      const Exact_rational upper =
          i + 1 < m_answers.size() ? Exact_rational((m_answers[i + 1].begin() + end) / two) : (std::max)(last, end);
      region.emplace_back(lower, upper);
    }
    if (answer.kind == Solution_kind::CONTINUUM)
      return Solution(answer.kind, 1, {{{begin, end}}}, {});
    return Solution(Fine(answer.kind, {{begin, end}}, region, Number_traits<Exact_rational>::name, answer.reason,
                         answer.multiplicity),
                    0);
  }

  static double lower_end(const Univariate_answer& answer)
  {
    return answer.exact ? to_double_interval(answer.exact->lower()).first : answer.lower;
  }
  static double upper_end(const Univariate_answer& answer)
  {
    return answer.exact ? to_double_interval(answer.exact->upper()).second : answer.upper;
  }

  // Between the end of another answer, which is not given, and that of this one.
  static double middle(double other, double own)
  {
    const double result = other / 2 + own / 2;
    return result == other ? own : result;
  }

  // A point beyond an end of the domain, up to which a polynomial that does not vanish at the end has no root.
  Exact_rational beyond(const Exact_rational& end, const Integer_polynomial& polynomial, int direction) const
  {
    const Exact_rational domain = m_system.domain(0).second - m_system.domain(0).first;
    for (Exact_rational reach =
             direction * (domain == Exact_rational(0) ? Exact_rational(1) : domain) / Exact_rational(4);
         ; reach /= Exact_rational(16)) {
      const auto dyadic_near = [&](const Exact_rational& a, const Exact_rational& b) {
        return simple_dyadic_between((std::min)(a, b), (std::max)(a, b));
      };
      const Exact_rational far = dyadic_near(end + reach / Exact_rational(2), end + reach),
                           near = dyadic_near(end, end - reach / Exact_rational(8));
      const std::vector<Big_integer> values = polynomial.bernstein((std::min)(far, near), (std::max)(far, near)).values;
      if (sign_variations(values) == 0 && values.front() != 0 && values.back() != 0)
        return far;
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_SOLVER_H
