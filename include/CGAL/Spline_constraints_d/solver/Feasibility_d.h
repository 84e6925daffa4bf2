// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_FEASIBILITY_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_FEASIBILITY_D_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
Whether constraints can be satisfied.
*/
enum class Feasibility
{
  FEASIBLE,   ///< a point satisfies all constraints: it is given, or a box with a certificate
  INFEASIBLE, ///< no point of the domain does, by proof
  UNDECIDED   ///< neither is proved; `Feasibility_d::undecided()` says where and why
};

inline std::ostream& operator<<(std::ostream& out, Feasibility status)
{
  static const char* const names[] = {"feasible", "infeasible", "undecided"};
  return out << names[static_cast<int>(status)];
}

/*!
\ingroup PkgSplineConstraintsDSolver

The answer whether constraints can be satisfied, with what proves it.
*/
class Feasibility_d
{
public:
  //! a closed range for each unknown.
  using Box = std::vector<std::pair<Exact_rational, Exact_rational>>;

  /*!
  A part of the domain without solutions, with numbers \f$\lambda_i\f$ that prove it: with the constraints written as
  \f$g_i \le 0\f$, or \f$g_i = 0\f$, the combination \f$\sum \lambda_i g_i\f$ is positive on the box, where
  \f$\lambda_i \ge 0\f$ for inequalities; or it is not negative, and one with \f$\lambda_i > 0\f$ is strict. It may be
  zero on a face that other parts share.
  */
  struct Excluded_part
  {
    std::vector<Undecided_part::Range> place; ///< a range for each unknown

    /// one for each constraint: equalities, then inequalities of the system, then polynomials, in their order. Empty
    /// where critical points that do not exist, or do not satisfy the constraints, are the proof, or constraint
    /// propagation is, or a function that must not be zero is zero everywhere.
    std::vector<Exact_rational> multipliers;
  };

private:
  Feasibility m_status = Feasibility::UNDECIDED;
  Box m_box;
  std::string m_certificate;
  std::vector<Undecided_part> m_undecided;
  std::vector<Excluded_part> m_excluded;
  std::vector<std::vector<double>> m_path;
  Summary m_summary;

public:
  //! not decided.
  Feasibility_d() = default;

#ifndef DOXYGEN_RUNNING
  Feasibility_d(Feasibility status, Box box, std::string certificate, std::vector<Undecided_part> undecided,
                std::vector<Excluded_part> excluded, std::vector<std::vector<double>> path, const Summary& summary)
    : m_status(status), m_box(std::move(box)), m_certificate(std::move(certificate)), m_undecided(std::move(undecided)),
      m_excluded(std::move(excluded)), m_path(std::move(path)), m_summary(summary)
  {}
#endif

  //! what is proved.
  Feasibility status() const { return m_status; }
  bool is_feasible() const { return m_status == Feasibility::FEASIBLE; }
  bool is_infeasible() const { return m_status == Feasibility::INFEASIBLE; }

  //! whether one or the other is proved.
  bool is_complete() const { return m_status != Feasibility::UNDECIDED; }

  //! where it is feasible: a box that holds a point which satisfies all constraints. Unknowns whose value is known, for
  //! example since it was chosen, have a range of one number.
  const Box& box() const { return m_box; }

  //! whether the point is known exactly: all ranges of the box are one number, and all signs were checked there.
  bool has_point() const
  {
    return !m_box.empty() &&
        std::all_of(m_box.begin(), m_box.end(), [](const auto& range) { return range.first == range.second; });
  }

  //! the point. \pre `has_point()`
  std::vector<Exact_rational> point() const
  {
    CGAL_precondition(has_point());
    std::vector<Exact_rational> result;
    for (const auto& range : m_box)
      result.push_back(range.first);
    return result;
  }

  //! what proves that it is feasible, in words.
  const std::string& certificate() const { return m_certificate; }

  //! the boxes that are undecided, each with the reason; empty where the status is decided.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! parts of the domain that were proved to hold no solution; where it is infeasible they cover the domain. At most a
  //! hundred thousand are kept.
  const std::vector<Excluded_part>& excluded() const { return m_excluded; }

  //! the points of the relaxation in the first box, in doubles.
  const std::vector<std::vector<double>>& path() const { return m_path; }

  //! the work.
  const Summary& summary() const { return m_summary; }

  //! writes `feasibility: feasible; complete: yes; nodes 1; seconds 0.001`.
  friend std::ostream& operator<<(std::ostream& out, const Feasibility_d& answer)
  {
    return out << "feasibility: " << answer.status() << "; complete: " << (answer.is_complete() ? "yes" : "no")
               << "; nodes " << answer.summary().nodes << "; seconds " << answer.summary().seconds;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_FEASIBILITY_D_H
