// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTIONS_AT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTIONS_AT_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/reason_of.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Where one of the answers may be in space and on two operands; a curve with itself is the first one twice.
template <class Answer, int d>
Undecided_part undecided_part(const Answer& answer, const Patch_pair<d>& operands,
                              const std::array<std::size_t, 2>& indices)
{
  Undecided_part result{{}, {}, reason_of(answer.solution())};
  for (const std::size_t operand : {0, 1}) {
    Parameter_box box;
    for (int axis = 0; axis < operands[operand].number_of_parameters(); ++axis)
      box.push_back(answer.parameter_range(operand, static_cast<std::size_t>(axis)));
    Parameter_box domain;
    for (int axis = 0; axis < operands[operand].number_of_parameters(); ++axis)
      domain.push_back(operands[operand].domain(axis));
    box = clipped(with_short_ends(box), domain);
    if (operand == 0)
      result.place = double_ranges(operands[operand].part(box).values());
    if (!box.empty())
      result.parameters.push_back({indices[operand], double_ranges(box)});
  }
  return result;
}

// Sentences about the operands that are curves and run over a part of themselves more than once.
template <int d>
std::vector<std::string> remarks_on(const Patch_pair<d>& operands, const std::array<std::size_t, 2>& indices)
{
  const bool is_one = indices[0] == indices[1];
  std::vector<std::string> result;
  for (std::size_t operand = 0; operand < (is_one ? 1u : 2u); ++operand)
    if (const int times = times_over_itself(operands[operand]); times > 1)
      result.push_back((is_one ? "the curve" : "operand " + std::to_string(indices[operand])) + " traces itself " +
                       std::to_string(times) + " times: use proper_reparametrization()");
  return result;
}

// The answers of an operation that has found the common points of two operands, with its work.
template <SplineKernel Kernel, int d>
Spline_constraints::Intersections<Kernel, d> intersections_at(std::vector<Common_point> points,
                                                              const Patch_pair<d>& operands, const Summary& work,
                                                              const std::array<std::size_t, 2>& indices = {0, 1})
{
  std::vector<Intersection<Kernel, d>> result;
  result.reserve(points.size());
  // A run that was ended explains itself, and whoever ended it does not wait.
  const auto is_end = [](Undecided_reason reason) {
    return reason == Undecided_reason::TIME || reason == Undecided_reason::STOPPED;
  };
  bool is_complete = true, has_continuum = false, is_ended = is_end(work.why_not);
  for (Common_point& point : points) {
    is_ended = is_ended || (point.solution && is_end(point.solution->reason()));
    is_complete = is_complete && point.kind != Intersection_kind::UNDECIDED;
    has_continuum = has_continuum || point.kind == Intersection_kind::OVERLAP;
    result.emplace_back(std::move(point), operands);
  }
  std::function<Undecided_part(const Intersection<Kernel, d>&)> part;
  std::function<std::vector<std::string>()> remarks;
  if (!is_complete)
    part = [operands, indices](const Intersection<Kernel, d>& answer) {
      return undecided_part(answer, operands, indices);
    };
  if (!is_ended && (!is_complete || has_continuum))
    remarks = [operands, indices] { return remarks_on(operands, indices); };
  return Spline_constraints::Intersections<Kernel, d>(std::move(result), work, std::move(part), std::move(remarks));
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTIONS_AT_H
