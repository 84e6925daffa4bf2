// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_kind.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_solution.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace Common {

// What is known of a common point, or of several, with the parameters of both operands one after the other.
struct Common_point
{
  Intersection_kind kind;
  Parameter_box parameters;
  std::vector<bool> is_at_end;
  std::optional<Solution_d<double>> solution;
  // at the upper end of a closed operand, or of an open part of one: another parameter stands for the same point
  bool is_repeated;
  // how often it counts, where that is not in the solution; 0: this is not known
  std::optional<int> multiplicity = std::nullopt;
  // of two planar curves that go on
  std::optional<Passage> passage = std::nullopt;
};

// How often a common point counts; 0 where that is not known.
inline int multiplicity_of(const Common_point& point)
{
  return point.multiplicity                          ? *point.multiplicity
      : point.solution                               ? point.solution->multiplicity()
      : point.kind == Intersection_kind::TRANSVERSAL ? 1
                                                     : 0;
}

// The width of the widest range of an operand, as a part of its domain; zero where it has no parameters.
template <int d>
Exact_rational widest_part(const Patch_pair<d>& operands, const Parameter_box& ranges, std::size_t operand)
{
  Exact_rational result(0);
  for (int axis = 0; axis < operands[operand].number_of_parameters(); ++axis) {
    const auto& [lower, upper] = ranges[operands.first_parameter(operand) + static_cast<std::size_t>(axis)];
    const auto [begin, end] = operands[operand].domain(axis);
    if (lower < upper)
      result = (std::max)(result, Exact_rational((upper - lower) / (end - begin)));
  }
  return result;
}

// What stands for all common points with parameters in a box, where none were looked for.
inline Common_point undecided_common_point(const Parameter_box& box, Undecided_reason reason)
{
  return {Intersection_kind::UNDECIDED, box, std::vector<bool>(box.size(), false), undecided_solution(box, reason),
          false};
}

} // namespace Common
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

An intersection of two operands, each a point, a curve or a surface: parameters on both, within ranges that are proved
to hold those of the common point, or of the common piece.

Operands are numbered 0 and 1, their parameters, the axes, 0 and 1 on a surface and 0 on a curve; a point has none.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Intersection
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  internal::Common::Common_point m_common;
  internal::Common::Double_ranges m_ranges{};   // of the parameters, unless the exact ones are known
  std::array<bool, internal::Common::most_parameters> m_is_at_end{};
  std::size_t m_split, m_size;                  // numbers of parameters, of the first operand and of both
  Point m_point;

public:
  //! a common point that an operation has found, of these operands.
  Intersection(internal::Common::Common_point common, const internal::Common::Patch_pair<d>& operands)
    : m_common(std::move(common)), m_split(operands.first_parameter(1)), m_size(operands.number_of_parameters())
  {
    using namespace internal::Common;
    std::copy(m_common.is_at_end.begin(), m_common.is_at_end.end(), m_is_at_end.begin());
    const Parameter_box ranges = clipped(with_short_ends(m_common.parameters), operands.domain());
    const std::size_t operand = m_common.kind != Intersection_kind::OVERLAP &&
            widest_part(operands, ranges, 1) < widest_part(operands, ranges, 0)
        ? 1
        : 0;
    const auto split = ranges.begin() + static_cast<std::ptrdiff_t>(m_split);
    const Parameter_box own = operand == 0 ? Parameter_box(ranges.begin(), split) : Parameter_box(split, ranges.end());
    m_point = internal::kernel_object<Kernel, Point>(operands[operand](internal::middle_of(own)));
  }

  //! one that an operation has found in doubles.
  Intersection(internal::Common::Elementary_point<d> common, std::size_t split, std::size_t number_of_parameters)
    : m_common{common.kind, std::move(common.exact_parameters), {}, std::move(common.solution), false,
               common.multiplicity, common.passage},
      m_ranges(common.parameters), m_is_at_end(common.is_at_end), m_split(split), m_size(number_of_parameters),
      m_point(internal::kernel_object<Kernel, Point>(common.point))
  {}

  //! what is proved.
  Intersection_kind kind() const { return m_common.kind; }

  //! the parameters of an operand along an axis: those of a common point lie in the range, those of an overlap too. At
  //! a pole of a surface, where one parameter is free, its range is the whole domain.
  Range parameter_range(std::size_t operand, std::size_t axis = 0) const
  {
    if (!m_common.parameters.empty())
      return m_common.parameters[index(operand, axis)];
    const auto [lower, upper] = m_ranges[index(operand, axis)];
    return {to_rational(lower), to_rational(upper)};
  }

  //! the middle of the range, rounded to double.
  double parameter(std::size_t operand, std::size_t axis = 0) const
  {
    return to_nearest_double(internal::Common::middle_of(parameter_range(operand, axis)));
  }

  //! the point of an operand in the middle of its ranges: of the one whose ranges are narrower, as parts of its domain,
  //! or else of the first one, and so for an overlap; where they are narrower than 256 binary digits tell, next to it.
  //! Where they are one number each, as for a point, and the kernel is exact, it is the common point itself. In kernels
  //! of doubles it may be rounded more than once.
  const Point& point() const { return m_point; }

  //! whether the common point is at an end of the range of a parameter, decided exactly: an end of a curve, an edge or
  //! pole of a surface, or a seam.
  bool is_at_end(std::size_t operand, std::size_t axis) const { return m_is_at_end[index(operand, axis)]; }

  //! whether it is at an end of any parameter of an operand.
  bool is_at_end(std::size_t operand) const
  {
    const auto begin = m_is_at_end.begin() + static_cast<std::ptrdiff_t>(operand == 0 ? 0 : m_split),
               end = m_is_at_end.begin() + static_cast<std::ptrdiff_t>(operand == 0 ? m_split : m_size);
    return std::find(begin, end, true) != end;
  }

  //! how often the common point counts; 1 when the operands cross, 0 when not known, as at a pole.
  int multiplicity() const { return internal::Common::multiplicity_of(m_common); }

  //! how two curves in the plane pass through a common point that is `TRANSVERSAL`, `TANGENT`, or an `END_POINT` on a
  //! seam: whether they cross or touch there, decided exactly, also at corners of one or both. Nothing for other
  //! operands and kinds, and where one of the curves ends.
  std::optional<Passage> passage() const
  {
    const bool are_planar_curves = d == 2 && m_split == 1 && m_size == 2;
    return are_planar_curves && m_common.kind == Intersection_kind::TRANSVERSAL ? Passage::CROSSES : m_common.passage;
  }

  //! the answer of the solver, with its proof. Its unknowns are all parameters, those of the first operand first, or
  //! those of one operand, if the points of the other one are affine in its parameters: a point, a segment, a
  //! parallelogram. None without unknowns, at poles that were found otherwise, and where fewer unknowns decided what
  //! the solver did not: of curves that nearly coincide, at breaks of planar curves, at contacts on common edges of
  //! surfaces or of ruled ones; and where closed forms decide.
  const std::optional<Solution_d<double>>& solution() const { return m_common.solution; }

private:
  std::size_t index(std::size_t operand, std::size_t axis) const { return operand == 0 ? axis : m_split + axis; }
};

/*!
\ingroup PkgSplineConstraintsDIntersections

The answers of an operation that finds common points, and whether they are all.

\tparam Answer_ `Intersection` or `Locus_intersection`.
*/
template <class Answer_>
class Intersection_set
{
public:
  //! an answer.
  using Answer = Answer_;
  //! passes the answers.
  using const_iterator = typename std::vector<Answer>::const_iterator;

private:
  std::vector<Answer> m_answers;
  Summary m_summary;
  std::function<Undecided_part(const Answer&)> m_undecided_part; // is called where somebody asks
  std::function<std::vector<std::string>()> m_remarks;           // the same; or empty

public:
  //! these answers. `undecided_part` tells where one of the kind `UNDECIDED` is, and why; `remarks`, what is said of
  //! the operands.
  Intersection_set(std::vector<Answer> answers, const Summary& work,
                   std::function<Undecided_part(const Answer&)> undecided_part,
                   std::function<std::vector<std::string>()> remarks = {})
    : m_answers(std::move(answers)), m_summary(work), m_undecided_part(std::move(undecided_part)),
      m_remarks(std::move(remarks))
  {
    m_summary.is_complete = count(Intersection_kind::UNDECIDED) == 0;
    if (m_summary.is_complete)
      m_summary.why_not = Undecided_reason::NONE;
  }

  //! no answers, and nothing is undecided.
  Intersection_set() = default;

  //! @{ the answers.
  const_iterator begin() const { return m_answers.begin(); }
  const_iterator end() const { return m_answers.end(); }
  std::size_t size() const { return m_answers.size(); }
  bool empty() const { return m_answers.empty(); }
  const Answer& operator[](std::size_t i) const { return m_answers[i]; }
  //! @}

  //! number of answers of a kind.
  std::size_t count(Intersection_kind kind) const
  {
    return static_cast<std::size_t>(
        std::count_if(begin(), end(), [=](const Answer& answer) { return answer.kind() == kind; }));
  }

  //! whether there are no others, by proof, and none is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  /*!
  sentences that explain answers which are `OVERLAP` or `UNDECIDED`: one for each curve that is proved to run over a
  part of itself more than once, as by an improper parametrisation, which multiplies its common points. They are found
  when this function or `undecided()` is called, within 0.3 s for each operand, or left out; none are, where a limit of
  time or the visitor ended the run.
  */
  std::vector<std::string> remarks() const { return m_remarks ? m_remarks() : std::vector<std::string>(); }

  //! what is undecided, where in space and on the operands, and why, with the remarks: the answers of the kind
  //! `UNDECIDED`.
  std::vector<Undecided_part> undecided() const
  {
    std::vector<Undecided_part> result;
    for (const Answer& answer : m_answers)
      if (answer.kind() == Intersection_kind::UNDECIDED)
        result.push_back(m_undecided_part(answer));
    if (!result.empty())
      for (const std::string& remark : remarks())
        for (Undecided_part& part : result)
          part.reason += "; " + remark;
    return result;
  }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

/*!
\ingroup PkgSplineConstraintsDIntersections

The intersections of two operands, ordered by the parameters of the first one, or where these are the same, by those of
the second: on a ray, from its source on.
*/
template <SplineKernel Kernel, int d>
using Intersections = Intersection_set<Intersection<Kernel, d>>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_H
