// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_JOINED_ANSWER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_JOINED_ANSWER_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
One answer of each part of a system, as an answer of the whole system. The kind is that of which the least is proved;
the multiplicity of a point is the product, as the ring of functions near it is the tensor product.
*/
template <class Coordinate>
class Joined_answer
{
  using Solution = Solution_d<Coordinate>;
  using Exact_range = Constraint_system_d::Domain;
  using Exact_point = std::vector<Exact_rational>;

  const Constraint_system_d& m_system;
  const System_decomposition& m_decomposition;
  const std::vector<const Solution*>& m_answers; // one for each part

public:
  Joined_answer(const Constraint_system_d& system, const System_decomposition& decomposition,
                const std::vector<const Solution*>& answers)
    : m_system(system), m_decomposition(decomposition), m_answers(answers)
  {}

  Solution solution() const
  {
    for (const Solution* answer : m_answers)
      if (is_open(*answer))
        return simple(Solution_kind::UNDECIDED, answer->reason());
    const auto kind = (*std::max_element(m_answers.begin(), m_answers.end(), [](const auto* a, const auto* b) {
                        return a->kind() < b->kind();
                      }))->kind();
    return kind < Solution_kind::CONTINUUM ? simple(kind, Undecided_reason::NONE) : covered(kind);
  }

private:
  static bool is_open(const Solution& answer)
  {
    return answer.kind() == Solution_kind::UNDECIDED && answer.cover().empty();
  }

  // With one box.
  Solution simple(Solution_kind kind, Undecided_reason reason) const
  {
    Exact_box box(static_cast<std::size_t>(m_system.dimension())), region = box;
    int multiplicity = 1, precision = 0;
    bool is_finer = false; // than doubles
    const char* number_type = "";
    for (std::size_t i = 0; i < m_answers.size(); ++i) {
      const Solution& answer = *m_answers[i];
      const Exact_box own = answer.exact_box(), own_region = answer.exact_uniqueness_region();
      place(own, i, box);
      place(own_region.empty() ? own : own_region, i, region);
      multiplicity *= answer.multiplicity();
      precision = (std::max)(precision, answer.precision());
      is_finer = is_finer || own != Exact_box(answer.box().begin(), answer.box().end());
      if (rank(number_type) < rank(answer.number_type()))
        number_type = answer.number_type();
    }
    for (const Eliminated_unknown& eliminated : m_decomposition.eliminated) {
      const Exact_range range = range_of(eliminated, box), domain = m_system.domain(eliminated.unknown);
      if (reason == Undecided_reason::INEQUALITY && (range.first < domain.first || domain.second < range.second))
        reason = Undecided_reason::DOMAIN_BOUNDARY;
      box[eliminated.unknown] = within(range, domain);
      region[eliminated.unknown] = around(range, domain);
    }
    if (kind == Solution_kind::UNDECIDED) {
      multiplicity = 0;
      region.clear();
    }
    if constexpr (!std::same_as<Coordinate, Exact_rational>)
      if (is_finer)
        return Solution(Solution_d<Exact_rational>(kind, box, region, number_type, reason, multiplicity),
                        number_type == std::string_view("multiprecision") ? precision : 0);
    typename Solution::Box rounded, rounded_region;
    for (const auto& range : box)
      rounded.push_back(outwards(range));
    for (std::size_t j = 0; j < region.size(); ++j)
      rounded_region.push_back(inwards(region[j], rounded[j]));
    Solution result(kind, std::move(rounded), std::move(rounded_region), number_type, reason, multiplicity);
    if (kind == Solution_kind::CLUSTER)
      result.set_uniqueness_region(std::move(region));
    return result;
  }

  static constexpr std::size_t most_boxes = 10000; // of a cover

  // With all combinations of the boxes of covers, each in one box where they are too many; with ends, when all but one
  // of the answers are points.
  Solution covered(Solution_kind kind) const
  {
    std::vector<Exact_box> cover(1, Exact_box(static_cast<std::size_t>(m_system.dimension())));
    std::vector<Exact_point> ends(2, Exact_point(static_cast<std::size_t>(m_system.dimension())));
    int dimension = 0, segments = 0;
    for (std::size_t i = 0; i < m_answers.size(); ++i) {
      const Solution& answer = *m_answers[i];
      const bool is_in_one_box = answer.cover().empty() || most_boxes / cover.size() < answer.cover().size();
      const auto own = is_in_one_box ? std::vector<Exact_box>{answer.exact_box()} : answer.cover();
      std::vector<Exact_box> combined;
      for (const Exact_box& before : cover)
        for (const Exact_box& box : own) {
          combined.push_back(before);
          place(box, i, combined.back());
        }
      cover = std::move(combined);
      dimension += answer.dimension();
      if (!answer.ends().empty()) {
        ++segments;
        place(answer.ends()[0], i, ends[0]);
        place(answer.ends()[1], i, ends[1]);
      } else if (const Exact_box& box = own.front(); own.size() == 1 && is_point(box)) {
        place(middle_of(box), i, ends[0]);
        place(middle_of(box), i, ends[1]);
      } else
        segments = 2; // or more: no ends
    }
    if (segments != 1)
      ends.clear();
    for (const Eliminated_unknown& eliminated : m_decomposition.eliminated) {
      for (Exact_box& box : cover)
        box[eliminated.unknown] = within(range_of(eliminated, box), m_system.domain(eliminated.unknown));
      for (Exact_point& end : ends)
        end[eliminated.unknown] = value_of(eliminated, end);
    }
    if (ends.size() == 2 && ends[1] < ends[0])
      std::swap(ends[0], ends[1]);
    return Solution(kind, dimension, std::move(cover), std::move(ends));
  }

  template <class T>
  void place(const std::vector<T>& part, std::size_t i, std::vector<T>& whole) const
  {
    const std::vector<int>& unknowns = m_decomposition.parts[i].unknowns;
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      whole[unknowns[j]] = part[j];
  }

  static bool is_point(const Exact_box& box)
  {
    return std::all_of(box.begin(), box.end(), [](const Exact_range& range) { return range.first == range.second; });
  }

  static Exact_rational value_of(const Eliminated_unknown& eliminated, const Exact_point& point)
  {
    Exact_rational result = eliminated.constant;
    for (const auto& [unknown, slope] : eliminated.slopes)
      result += slope * point[unknown];
    return result;
  }

  // What of a range lies in the domain, where all solutions do; all of it when none of it does, which only an undecided
  // box can say.
  static Exact_range within(const Exact_range& range, const Exact_range& domain)
  {
    const Exact_range result((std::max)(range.first, domain.first), (std::min)(range.second, domain.second));
    return result.second < result.first ? range : result;
  }

  // Of some room on both sides: whatever its values, an unknown that others give makes no further solutions.
  static Exact_range around(const Exact_range& range, const Exact_range& domain)
  {
    const Exact_range result((std::min)(range.first, domain.first), (std::max)(range.second, domain.second));
    const Exact_rational room = result.second - result.first + 1;
    return {Exact_rational(result.first - room), Exact_rational(result.second + room)};
  }

  static typename Solution::Range outwards(const Exact_range& range)
  {
    if constexpr (std::same_as<Coordinate, Exact_rational>)
      return range;
    else
      return {to_double_interval(range.first).first, to_double_interval(range.second).second};
  }

  // Holds the enclosure.
  static typename Solution::Range inwards(const Exact_range& range, const typename Solution::Range& enclosure)
  {
    if constexpr (std::same_as<Coordinate, Exact_rational>)
      return range;
    else
      return {(std::min)(to_double_interval(range.first).second, enclosure.first),
              (std::max)(to_double_interval(range.second).first, enclosure.second)};
  }

  static int rank(std::string_view number_type)
  {
    constexpr std::string_view names[] = {"", "double", "interval", "multiprecision", "exact"};
    return static_cast<int>(std::find(std::begin(names), std::end(names), number_type) - std::begin(names));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_JOINED_ANSWER_H
