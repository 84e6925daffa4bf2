// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_SOAK_COMPARISON_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_SOAK_COMPARISON_H

#include "soak_systems.h"

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace solver_test {

/*
What came of random systems that were solved with Certified_solver_traits and with Exact_solver_traits.

- matched: roots that both certified;
- lost: planted solutions, and roots that only Exact_solver_traits certified, for which Certified_solver_traits has no
  answer at all;
- extra: the other way round; answers that count one root twice; certified ones that hold no planted solution where all
  are planted; and clusters with another multiplicity than the planted one;
- the roots that one certified and the other left open, the answers that verify() did not prove, the runs that are not
  complete, and of these those that reached a limit.
*/
struct Soak_counts
{
  enum Count
  {
    SYSTEMS,
    PLANTED,
    MATCHED,
    LOST,
    EXTRA,
    OPEN_IN_CERTIFIED,
    OPEN_IN_EXACT,
    UNPROVED,
    CERTIFIED_INCOMPLETE,
    CERTIFIED_LIMITED,
    EXACT_INCOMPLETE,
    EXACT_LIMITED,
    COUNT
  };
  static constexpr const char* names[] = {"systems",
                                          "planted",
                                          "matched",
                                          "lost",
                                          "extra",
                                          "open in certified",
                                          "open in exact",
                                          "not proved",
                                          "certified incomplete",
                                          "at a limit",
                                          "exact incomplete",
                                          "at a limit"};

  std::vector<std::uint64_t> values = std::vector<std::uint64_t>(COUNT, 0);

  std::uint64_t& operator[](Count count) { return values[count]; }
  std::uint64_t operator[](Count count) const { return values[count]; }

  Soak_counts& operator+=(const Soak_counts& other)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += other.values[i];
    return *this;
  }
};

// Nodes after which runs end, so that the counts are the same on every machine; what was not looked at is undecided
// then. Nearly all roots are found with these; most of the time would be spent on the few systems that take more.
struct Soak_limits
{
  std::size_t exact = 50, certified = 2000;
};

// The system of a seed, solved by both.
class Soak_comparison
{
  using Solution_kind = SC::Solution_kind;
  using Box = std::vector<std::pair<Rational, Rational>>;

  struct Answer
  {
    Solution_kind kind;
    int multiplicity;
    std::vector<Box> boxes; // one, or those of a cover
    Box region;
  };

  struct Run
  {
    std::vector<Answer> answers;
    bool is_complete, is_limited;
  };

  Soak_system m_problem;
  Soak_counts m_counts;

public:
  Soak_comparison(std::uint64_t seed, const Soak_limits& limits = {}, const SC::Visitor_reference& visitor = {})
    : Soak_comparison(Soak_systems(seed).make(), limits, visitor)
  {}

  Soak_comparison(Soak_system problem, const Soak_limits& limits = {}, const SC::Visitor_reference& visitor = {})
    : m_problem(std::move(problem))
  {
    const Run certified = solved<SC::Certified_solver_traits>(limits.certified, visitor);
    const Run exact = solved<SC::Exact_solver_traits>(limits.exact, visitor);
    const std::size_t missing_in_exact = compare(certified, exact, Soak_counts::OPEN_IN_EXACT, true);
    const std::size_t missing_in_certified = compare(exact, certified, Soak_counts::OPEN_IN_CERTIFIED, false);
    m_counts[Soak_counts::SYSTEMS] = 1;
    m_counts[Soak_counts::PLANTED] = m_problem.planted.size();
    m_counts[Soak_counts::LOST] += missing_in_certified + count_lost(certified);
    m_counts[Soak_counts::EXTRA] += missing_in_exact + count_lost(exact) + count_wrong(certified) + count_wrong(exact);
    m_counts[Soak_counts::CERTIFIED_INCOMPLETE] = !certified.is_complete;
    m_counts[Soak_counts::CERTIFIED_LIMITED] = certified.is_limited;
    m_counts[Soak_counts::EXACT_INCOMPLETE] = !exact.is_complete;
    m_counts[Soak_counts::EXACT_LIMITED] = exact.is_limited;
  }

  const Soak_system& problem() const { return m_problem; }
  const Soak_counts& counts() const { return m_counts; }

private:
  static bool meet(const Box& a, const Box& b)
  {
    for (std::size_t j = 0; j < a.size(); ++j)
      if (a[j].second < b[j].first || b[j].second < a[j].first)
        return false;
    return true;
  }

  static bool is_inside(const Box& inner, const Box& outer)
  {
    for (std::size_t j = 0; j < inner.size(); ++j)
      if (inner[j].first < outer[j].first || outer[j].second < inner[j].second)
        return false;
    return !outer.empty();
  }

  static Box box_of(const Point& point)
  {
    Box box;
    for (const Coordinate& c : point)
      box.emplace_back(c.lower, c.upper);
    return box;
  }

  static bool holds(const Answer& answer, const Box& box)
  {
    return std::any_of(answer.boxes.begin(), answer.boxes.end(), [&](const Box& own) { return meet(own, box); });
  }

  static bool is_certified(const Answer& answer) { return answer.kind == Solution_kind::CERTIFIED; }

  // Both boxes hold the same root of the equalities: each holds one, and the region of one of them, in which there is
  // no other, holds the other box; or both hold one and the same planted solution.
  bool have_same_root(const Answer& a, const Answer& b) const
  {
    return is_certified(a) && is_certified(b) && meet(a.boxes[0], b.boxes[0]) &&
        (is_inside(b.boxes[0], a.region) || is_inside(a.boxes[0], b.region) ||
         std::any_of(m_problem.planted.begin(), m_problem.planted.end(), [&](const Point& point) {
           return is_inside(box_of(point), a.boxes[0]) && is_inside(box_of(point), b.boxes[0]);
         }));
  }

  template <class Traits>
  Run solved(std::size_t nodes, const SC::Visitor_reference& visitor)
  {
    constexpr double many_seconds = 30;
    const auto solutions = SC::Subdivision_solver_d<Traits>(
        {.time_limit = many_seconds, .node_limit = nodes, .visitor = visitor})(m_problem.system);
    const SC::Undecided_reason reason = solutions.summary().why_not;
    Run run{{}, solutions.is_complete(), reason == SC::Undecided_reason::NODES || reason == SC::Undecided_reason::TIME};
    for (const auto& solution : solutions) {
      run.answers.push_back({solution.kind(), solution.multiplicity(),
                             solution.cover().empty() ? std::vector<Box>{solution.exact_box()} : solution.cover(),
                             solution.exact_uniqueness_region()});
      m_counts[Soak_counts::UNPROVED] +=
          solution.kind() < Solution_kind::CONTINUUM && !verify(m_problem.system, solution);
    }
    return run;
  }

  // Looks for the certified roots of one run in the other; returns how many are not there in any way.
  std::size_t compare(const Run& run, const Run& other, Soak_counts::Count open, bool counts_matched)
  {
    std::size_t missing = 0;
    for (const Answer& answer : run.answers) {
      if (!is_certified(answer))
        continue;
      const auto is_same = [&](const Answer& another) { return have_same_root(answer, another); };
      const auto same = std::count_if(other.answers.begin(), other.answers.end(), is_same);
      m_counts[Soak_counts::MATCHED] += same == 1 && counts_matched;
      m_counts[Soak_counts::EXTRA] += same > 1;
      m_counts[Soak_counts::EXTRA] += std::count_if(run.answers.begin(), run.answers.end(), is_same) > 1;
      if (same == 0 && std::any_of(other.answers.begin(), other.answers.end(), [&](const Answer& another) {
            return holds(another, answer.boxes[0]);
          }))
        ++m_counts[open];
      else
        missing += same == 0;
    }
    return missing;
  }

  std::size_t count_lost(const Run& run) const
  {
    return std::count_if(m_problem.planted.begin(), m_problem.planted.end(), [&](const Point& point) {
      return std::none_of(run.answers.begin(), run.answers.end(),
                          [&](const Answer& answer) { return holds(answer, box_of(point)); });
    });
  }

  // Answers that are proved, and are not what was planted.
  std::size_t count_wrong(const Run& run) const
  {
    return std::count_if(run.answers.begin(), run.answers.end(), [&](const Answer& answer) {
      if (answer.kind >= Solution_kind::CONTINUUM)
        return false;
      std::vector<std::size_t> held;
      for (std::size_t i = 0; i < m_problem.planted.size(); ++i)
        if (holds(answer, box_of(m_problem.planted[i])))
          held.push_back(i);
      if (m_problem.are_all && held.empty())
        return true;
      if (m_problem.multiplicities.empty() || held.size() != 1 || answer.multiplicity == 0)
        return false;
      const int planted = m_problem.multiplicities[held[0]];
      return planted != 0 && planted != answer.multiplicity;
    });
  }
};

// Counts of each kind, and a line for each system with lost or extra roots, as text and back.
struct Soak_report
{
  std::map<std::string, Soak_counts> kinds;
  std::string findings;

  void add(std::uint64_t seed, const Soak_comparison& comparison)
  {
    const Soak_counts& counts = comparison.counts();
    kinds[comparison.problem().kind] += counts;
    if (counts[Soak_counts::LOST] + counts[Soak_counts::EXTRA] > 0) {
      std::ostringstream text;
      text << "seed " << seed << " (" << comparison.problem().kind << ", " << comparison.problem().system.dimension()
           << " unknowns): " << counts[Soak_counts::LOST] << " lost, " << counts[Soak_counts::EXTRA] << " extra\n";
      findings += text.str();
    }
  }

  void add(const Soak_report& other)
  {
    for (const auto& [kind, counts] : other.kinds)
      kinds[kind] += counts;
    findings += other.findings;
  }

  Soak_counts sum() const
  {
    Soak_counts result;
    for (const auto& [kind, counts] : kinds)
      result += counts;
    return result;
  }

  std::string text() const
  {
    std::ostringstream out;
    for (const auto& [kind, counts] : kinds) {
      out << kind << '\n';
      for (const std::uint64_t value : counts.values)
        out << value << ' ';
      out << '\n';
    }
    out << '\n' << findings;
    return out.str();
  }

  static Soak_report read(const std::string& text)
  {
    Soak_report report;
    std::istringstream in(text);
    for (std::string kind; std::getline(in, kind) && !kind.empty(); in.ignore(2))
      for (std::uint64_t& value : report.kinds[kind].values)
        in >> value;
    for (std::string line; std::getline(in, line);)
      report.findings += line + '\n';
    return report;
  }
};

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_SOAK_COMPARISON_H
