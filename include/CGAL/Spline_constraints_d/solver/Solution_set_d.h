// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLUTION_SET_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLUTION_SET_D_H

#include <CGAL/number_utils.h>

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
What is proved of the box of a solution.
*/
enum class Solution_kind {
  /// exactly one solution of the equalities, and it is regular, in the domain, and satisfies all inequalities
  CERTIFIED,
  CLUSTER,     ///< at least one solution, not regular or not told apart from others; no solution elsewhere near the box
  CONTINUUM,   ///< infinitely many solutions: all that lie in the box, or in the boxes of `Solution_d::cover()`
  UNDECIDED    ///< may hold solutions; `Solution_d::reason()` says what stopped the solver
};

/*!
\ingroup PkgSplineConstraintsDSolver
Why a box is `UNDECIDED`.
*/
enum class Undecided_reason {
  NONE,        ///< the box is decided
  TOLERANCE,   ///< the box is smaller than the tolerance, or cannot be split any more in its coordinate type
  CONTINUUM,   ///< the number of boxes grows as it does around a continuum of solutions, which is not proved
  TIME,        ///< the time limit was reached
  NODES,       ///< the node limit was reached
  STOPPED,     ///< the visitor stopped the solver
  /// one regular solution of the equalities, on or next to the boundary of the domain: inside or outside is not decided
  DOMAIN_BOUNDARY,
  /// more equalities than unknowns, and the one point that can be a solution does not satisfy all of them certainly
  OVERDETERMINED,
  /// one regular solution of the equalities, on or next to the boundary of an inequality: not decided
  INEQUALITY
};

inline std::ostream& operator<<(std::ostream& out, Solution_kind kind)
{
  static const char* const names[] = {"certified", "cluster", "continuum", "undecided"};
  return out << names[static_cast<int>(kind)];
}

std::ostream& operator<<(std::ostream& out, Undecided_reason reason);

namespace internal {

std::string in_words(Undecided_reason reason);

struct Answer_bytes; // sends answers to other processes

// The least range of doubles around a range of numbers.
template <class Coordinate>
Undecided_part::Range to_double_range(const std::pair<Coordinate, Coordinate>& range)
{
  if constexpr (std::same_as<Coordinate, double>)
    return range;
  else
    return {to_double_interval(range.first).first, to_double_interval(range.second).second};
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::string in_words(Undecided_reason reason)
{
  std::ostringstream out;
  out << reason;
  return out.str();
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

One answer of the solver: a box with what is proved of it.

`Coordinate` is `double`, or `Exact_rational` for the number types whose boxes are finer than doubles. An answer of
`Certified_solver_traits` that took more precision than doubles have holds both: `exact_box()` is the box that the proof
is about, and `box()` the smallest box of doubles around it, which other answers may share.
*/
template <class Coordinate>
class Solution_d
{
public:
  using Range = std::pair<Coordinate, Coordinate>;
  using Box = std::vector<Range>;
  using Exact_box = std::vector<std::pair<Exact_rational, Exact_rational>>;

private:
  friend struct internal::Answer_bytes;

  // What most answers do not have: they are kept small.
  struct Details
  {
    Exact_box box = {}, region = {};   // where they differ from those in `Coordinate`
    int precision = 0, dimension = 0;
    std::vector<Exact_box> cover = {};
    std::vector<std::vector<Exact_rational>> ends = {};
  };

  Solution_kind m_kind = Solution_kind::UNDECIDED;
  Undecided_reason m_reason = Undecided_reason::NONE;
  int m_multiplicity = 0;
  const char* m_number_type = "";
  Box m_box, m_region;
  std::shared_ptr<const Details> m_details;   // null: none

  const Details& details() const
  {
    static const Details none;
    return m_details == nullptr ? none : *m_details;
  }

public:
  //! an answer without unknowns that is undecided.
  Solution_d() = default;

  //! an answer in a box; with a region that holds no other one, or an empty one.
  Solution_d(Solution_kind kind, Box box, Box region, const char* number_type,
             Undecided_reason reason = Undecided_reason::NONE, int multiplicity = 0)
    : m_kind(kind), m_reason(reason), m_multiplicity(multiplicity), m_number_type(number_type), m_box(std::move(box)),
      m_region(std::move(region))
  {}

  //! an answer with finer coordinates, found with `precision` bits.
  Solution_d(const Solution_d<Exact_rational>& fine, int precision) requires(!std::same_as<Coordinate, Exact_rational>)
    : m_kind(fine.kind()), m_reason(fine.reason()), m_multiplicity(fine.multiplicity()),
      m_number_type(fine.number_type()),
      m_details(std::make_shared<const Details>(
          Details{.box = fine.box(), .region = fine.uniqueness_region(), .precision = precision}))
  {
    for (const auto& [lower, upper] : fine.box())
      m_box.emplace_back(to_double_interval(lower).first, to_double_interval(upper).second);
    for (const auto& [lower, upper] : fine.uniqueness_region())
      m_region.emplace_back(to_double_interval(lower).second, to_double_interval(upper).first);
  }

  //! a continuum of the given dimension that some boxes cover; or the segment between two points; or what looks like
  //! one, `UNDECIDED`.
  Solution_d(Solution_kind kind, int dimension, std::vector<Exact_box> cover,
             std::vector<std::vector<Exact_rational>> ends)
    : m_kind(kind), m_reason(kind == Solution_kind::UNDECIDED ? Undecided_reason::CONTINUUM : Undecided_reason::NONE),
      m_number_type("exact")
  {
    Exact_box box = cover.front();
    for (const Exact_box& part : cover)
      for (std::size_t j = 0; j < part.size(); ++j) {
        box[j].first = (std::min)(box[j].first, part[j].first);
        box[j].second = (std::max)(box[j].second, part[j].second);
      }
    for (const auto& [lower, upper] : box)
      if constexpr (std::same_as<Coordinate, Exact_rational>)
        m_box.emplace_back(lower, upper);
      else
        m_box.emplace_back(to_double_interval(lower).first, to_double_interval(upper).second);
    m_details = std::make_shared<const Details>(
        Details{.box = std::move(box), .dimension = dimension, .cover = std::move(cover), .ends = std::move(ends)});
  }

  //! what is proved.
  Solution_kind kind() const { return m_kind; }
  bool is_certified() const { return m_kind == Solution_kind::CERTIFIED; }

  //! why the box is undecided.
  Undecided_reason reason() const { return m_reason; }

  //! the enclosure: a closed range per unknown.
  const Box& box() const { return m_box; }
  const Range& operator[](std::size_t unknown) const { return m_box[unknown]; }

  //! the enclosure that the proof is about, which `box()` contains.
  Exact_box exact_box() const { return details().box.empty() ? Exact_box(m_box.begin(), m_box.end()) : details().box; }

  //! the middle of the enclosure, rounded to doubles.
  std::vector<double> point() const
  {
    std::vector<double> result;
    for (const Range& range : m_box)
      result.push_back(CGAL::to_double(Coordinate((range.first + range.second) / Coordinate(2))));
    return result;
  }

  //! a box around the enclosure that holds no other solution of the equalities, for a certified solution; of a cluster,
  //! a box around it without any solution in the domain outside of the cluster's box. Empty for other answers. In
  //! doubles it is rounded inwards: where `exact_box()` is finer than doubles, a range may be empty, its lower end
  //! above the upper one.
  const Box& uniqueness_region() const { return m_region; }

  //! the same without rounding.
  Exact_box exact_uniqueness_region() const
  {
    return details().region.empty() ? Exact_box(m_region.begin(), m_region.end()) : details().region;
  }

  //! the dimension of the set of solutions that a `CONTINUUM` is. With `UNDECIDED` and a `cover()`: they have at most
  //! this one, but for what lies in tiny boxes. 0 for other answers.
  int dimension() const { return details().dimension; }

  //! boxes that hold all solutions of a `CONTINUUM`, or of what looks like one but is `UNDECIDED`; empty for other
  //! answers. They touch each other; one or several connected components run through them. Each box of a `CONTINUUM`
  //! holds solutions of its dimension, except for tiny ones where it has a singular point, only touches the box, or
  //! leaves the set that the inequalities describe.
  const std::vector<Exact_box>& cover() const { return details().cover; }

  //! the two end points of a `CONTINUUM` that is a segment, exactly: all points between them are solutions, in the
  //! closure of what the inequalities allow. Empty otherwise.
  const std::vector<std::vector<Exact_rational>>& ends() const { return details().ends; }

#ifndef DOXYGEN_RUNNING
  // Another region, which holds the enclosure.
  void set_uniqueness_region(Exact_box region)
  {
    m_region.clear();
    for (const auto& [lower, upper] : region)
      if constexpr (std::same_as<Coordinate, Exact_rational>)
        m_region.emplace_back(lower, upper);
      else
        m_region.emplace_back(to_double_interval(lower).second, to_double_interval(upper).first);
    Details changed = details();
    changed.region = std::move(region);
    m_details = std::make_shared<const Details>(std::move(changed));
  }
#endif

  //! number of solutions in the box counted with multiplicity; 1 when certified, 0 when not known.
  int multiplicity() const { return m_multiplicity; }

  //! the number type that decided: "double", "interval", "multiprecision" or "exact".
  const char* number_type() const { return m_number_type; }

  //! the precision that it took, in bits, when `number_type()` is "multiprecision" and the solver chose it; else 0.
  int precision() const { return details().precision; }
};

/*!
\ingroup PkgSplineConstraintsDSolver
How a run of the solver went.
*/
struct Summary
{
  std::size_t nodes = 0;             ///< boxes looked at
  std::size_t restarts = 0;          ///< boxes rebuilt from the exact functions
  int depth = 0;                     ///< largest number of splits on one path since a rebuild
  double seconds = 0;                ///< wall-clock time of the whole run
  double setup_seconds = 0;          ///< of it: laying out the system, exact integers
  double rebuild_seconds = 0;        ///< of it: exact Bernstein coefficients
  bool is_complete = true;           ///< every solution lies in a certified, cluster or continuum box
  Undecided_reason why_not = Undecided_reason::NONE;   ///< the first reason when it is not

  //! adds the work of another run; complete if both are.
  Summary& operator+=(const Summary& other);
};

std::ostream& operator<<(std::ostream& out, const Summary& s);

/*!
\ingroup PkgSplineConstraintsDSolver

All answers of a run, ordered by kind and then by the lower corners of their boxes. Every solution in the domain lies in
the box of one of them: exactly one for certified solutions.
*/
template <class Coordinate>
class Solution_set_d
{
public:
  using Solution = Solution_d<Coordinate>;
  using const_iterator = typename std::vector<Solution>::const_iterator;

private:
  friend struct internal::Answer_bytes;

  std::vector<Solution> m_solutions;
  Summary m_summary;

public:
  //! no answers.
  Solution_set_d() = default;

  //! these answers, in any order, and the work.
  Solution_set_d(std::vector<Solution> solutions, const Summary& summary)
    : m_solutions(std::move(solutions)), m_summary(summary)
  {
    std::sort(m_solutions.begin(), m_solutions.end(), [](const Solution& a, const Solution& b) {
      return a.kind() != b.kind() ? a.kind() < b.kind()
          : a.box() != b.box()    ? a.box() < b.box()
                                  : a.exact_box() < b.exact_box();
    });
  }

  const_iterator begin() const { return m_solutions.begin(); }
  const_iterator end() const { return m_solutions.end(); }
  std::size_t size() const { return m_solutions.size(); }
  bool empty() const { return m_solutions.empty(); }
  const Solution& operator[](std::size_t i) const { return m_solutions[i]; }

  //! the answers, out of a set that is not used any more.
  std::vector<Solution> solutions() && { return std::move(m_solutions); }

  //! number of answers of a kind.
  std::size_t count(Solution_kind kind) const
  {
    return std::count_if(begin(), end(), [=](const Solution& s) { return s.kind() == kind; });
  }

  //! whether every solution is accounted for by a certified, cluster or continuum box.
  bool is_complete() const { return m_summary.is_complete; }

  //! the boxes that are undecided.
  std::vector<Undecided_part> undecided() const
  {
    std::vector<Undecided_part> result;
    for (const Solution& solution : m_solutions)
      if (solution.kind() == Solution_kind::UNDECIDED) {
        Undecided_part part{{}, {}, internal::in_words(solution.reason())};
        for (const typename Solution::Range& range : solution.box())
          part.place.push_back(internal::to_double_range(range));
        result.push_back(std::move(part));
      }
    return result;
  }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, Undecided_reason reason)
{
  static const char* const names[] = {
      "none",    "tolerance",       "continuum suspected", "time limit",         "node limit",
      "stopped", "domain boundary", "overdetermined",      "inequality boundary"};
  return out << names[static_cast<int>(reason)];
}

CGAL_SPLINE_CONSTRAINTS_INLINE Summary& Summary::operator+=(const Summary& other)
{
  nodes += other.nodes;
  restarts += other.restarts;
  depth = (std::max)(depth, other.depth);
  seconds += other.seconds;
  setup_seconds += other.setup_seconds;
  rebuild_seconds += other.rebuild_seconds;
  if (is_complete)
    why_not = other.why_not;
  is_complete = is_complete && other.is_complete;
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Summary& s)
{
  out << (s.is_complete ? "complete" : "incomplete");
  if (!s.is_complete)
    out << " (" << s.why_not << ')';
  return out << ", " << s.nodes << " nodes, " << s.restarts << " exact rebuilds, depth " << s.depth << ", " << s.seconds
             << " s";
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLUTION_SET_D_H
