// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_ANSWER_LIST_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_ANSWER_LIST_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

The answers of an operation one after the other, with what is undecided and the work.

\tparam Answer_ the type of an answer.
*/
template <class Answer_>
class Answer_list
{
public:
  //! an answer.
  using Answer = Answer_;
  //! passes the answers.
  using const_iterator = typename std::vector<Answer>::const_iterator;

private:
  std::vector<Answer> m_answers;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! nothing was found, and nothing is undecided.
  Answer_list() = default;

  //! these answers. The list is complete if nothing is undecided.
  Answer_list(std::vector<Answer> answers, std::vector<Undecided_part> undecided, const Summary& work)
    : m_answers(std::move(answers)), m_undecided(std::move(undecided)), m_summary(work)
  {
    m_summary.is_complete = m_undecided.empty();
  }

  //! @{ the answers.
  const_iterator begin() const { return m_answers.begin(); }
  const_iterator end() const { return m_answers.end(); }
  std::size_t size() const { return m_answers.size(); }
  bool empty() const { return m_answers.empty(); }
  const Answer& operator[](std::size_t i) const { return m_answers[i]; }
  const std::vector<Answer>& answers() const { return m_answers; }
  //! @}

  //! whether there are no others, by proof, and none is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! what is undecided: where on the operands, and why. Answers that are undecided come here, too.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_ANSWER_LIST_H
