// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_TIME_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_TIME_SEARCH_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
Finds the solutions of equations of contact, one part of the time after the other. A part is halved as long as many
pairs of elements have boxes that meet in it: where operands are far from each other, nothing is solved. Knots of the
motion are ends of parts.

A model `Own` derives from it. It has a type `Part`, of what is known in a part of the time; `motion()`;
`numbers_of_elements()` of both operands; `part(time)`; `do_meet(part, pair)`, which may be true of pairs that do not
meet; and `append_candidates(pair, part, found)`.
*/
template <class Own, class Candidate>
class Time_search
{
public:
  using Pair = std::array<std::size_t, 2>; // of elements of what moves, and of what is fixed

  // Is told the candidates of a part of the time, and says whether to go on.
  using Visitor = std::function<bool(const Parameter_range&, std::vector<Candidate>)>;

private:
  using Pairs = std::vector<Pair>;

  Budgeted_solver& m_solve;
  std::optional<Exact_rational> m_stop;

public:
  explicit Time_search(Budgeted_solver& solve) : m_solve(solve) {}

  // Where the run was ended by a limit: before this time all is found.
  const std::optional<Exact_rational>& stop() const { return m_stop; }

  void operator()(const Visitor& visitor)
  {
    if (m_solve.has_ended()) {
      m_stop = own().motion().domain().first;
      return;
    }
    const auto [moving, fixed] = own().numbers_of_elements();
    Pairs all;
    for (std::size_t i = 0; i < moving; ++i)
      for (std::size_t k = 0; k < fixed; ++k)
        all.push_back({i, k});
    const std::vector<Exact_rational> breaks = breaks_of_motion();
    const int depth = static_cast<int>(std::bit_width(breaks.size() - 1)) - 1;
    for (std::size_t i = 1; i < breaks.size(); ++i)
      if (!search({breaks[i - 1], breaks[i]}, all, depth, visitor))
        return;
  }

protected:
  Budgeted_solver& solver() { return m_solve; }

  // Where the motion is no polynomial one, so that what is true all the time within a part is an identity.
  std::vector<Exact_rational> breaks_of_motion() const
  {
    std::vector<Exact_rational> result = own().motion().weight().breaks(0);
    for (const auto& column : own().motion().columns())
      for (const auto& f : column)
        result = internal::united(result, f.breaks(0));
    return result;
  }

private:
  Own& own() { return static_cast<Own&>(*this); }
  const Own& own() const { return static_cast<const Own&>(*this); }

  bool search(const Parameter_range& time, const Pairs& pairs, int depth, const Visitor& visitor)
  {
    constexpr int least_depth = 3, greatest_depth = 8;
    constexpr std::size_t few = 8;
    if (m_solve.has_ended()) {
      m_stop = time.first;
      return false;
    }
    const typename Own::Part part = own().part(time);
    Pairs near;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(near),
                 [&](const Pair& pair) { return own().do_meet(part, pair); });
    if (near.empty())
      return true;
    if (depth < least_depth || (depth < greatest_depth && near.size() > few)) {
      // Not in the middle, where contacts are more likely than elsewhere: it would be found in both parts.
      const Exact_rational middle(time.first + (time.second - time.first) * 31 / 64);
      return search({time.first, middle}, near, depth + 1, visitor) &&
          search({middle, time.second}, near, depth + 1, visitor);
    }
    std::vector<Candidate> found;
    for (const Pair& pair : near) {
      if (m_solve.has_ended())
        m_stop = time.first;
      else
        own().append_candidates(pair, part, found);
    }
    return visitor(time, std::move(found)) && !m_stop;
  }
};

// A range of a parameter or of the time, of an enclosure. By rounding it may be larger than the domain, while solutions
// are in both.
inline Parameter_range within(const Parameter_range& range, const Parameter_range& domain)
{
  return {(std::max)(range.first, domain.first), (std::min)(range.second, domain.second)};
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_TIME_SEARCH_H
