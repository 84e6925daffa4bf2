// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_ELEMENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_ELEMENTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_element_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

// Parts of pieces between inflections, in the order of the boundary.
struct Turning_part
{
  Kernel_element_2 element;
  int turn;   // 1 to the left, -1 to the right, 0 straight
};

// \throws Run_stopped
inline std::vector<Turning_part> turning_parts(const std::vector<Tangent_family>& tangents, const Exact_pair& origin,
                                               Run_of_steps& run)
{
  std::vector<Turning_part> result;
  for (const Tangent_family& family : tangents) {
    run.check();
    const Exact_tensor curvature = family.curvature();
    std::vector<Exact_root> cuts{Exact_root(Exact_rational(0))};
    for (Exact_root& root : inner_roots(curvature, narrow_sight()))
      cuts.push_back(std::move(root));
    cuts.emplace_back(Exact_rational(1));
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const std::array<Exact_rational, 1> middle{Exact_rational((cuts[i].upper() + cuts[i + 1].lower()) / 2)};
      result.push_back({Kernel_element_2(family, origin, {cuts[i], cuts[i + 1]}), CGAL::sign(curvature(middle))});
    }
  }
  return result;
}

/*
The elements that bound a kernel around the origin, single tangents first. Of a part that turns to the right the
tangents at its ends suffice: the height of the others in a direction is less. At an inflection this is the tangent at
the end of a part that turns left; so it is left out there. No tangent is given twice, other than one of two arcs, which
is an element too. Throws Run_stopped.
*/
inline std::vector<Kernel_element_2> kernel_elements(const std::vector<Tangent_family>& tangents,
                                                     const Exact_pair& origin, Run_of_steps& run)
{
  const std::vector<Turning_part> parts = turning_parts(tangents, origin, run);
  std::vector<Kernel_element_2> lines, arcs;
  std::set<Exact_pair> duals_of_lines;
  std::map<Exact_pair, Exact_pair> ends_of_arcs;   // of dual points
  const auto append_line = [&](const Kernel_element_2& element, int end) {
    if (const auto dual = element.dual_of_end(end); dual && duals_of_lines.insert(*dual).second)
      lines.push_back(element.tangent_at(end));
  };
  const auto append_arc = [&](const auto& self, const Kernel_element_2& arc) -> void {
    if (arc.is_short())
      arcs.push_back(arc);
    else
      for (const Kernel_element_2& half : arc.halves())
        self(self, half);
  };
  for (const auto& [element, turn] : parts) {
    run.check();
    if (turn > 0) {
      append_arc(append_arc, element);
      for (int end = 0; end < 2; ++end)
        if (const auto dual = element.dual_of_end(end); dual &&
            ends_of_arcs.try_emplace(*dual, *element.point_of_end(end)).first->second != *element.point_of_end(end))
          append_line(element, end);
    } else if (turn == 0)
      append_line(element, 0);
  }
  for (const auto& [element, turn] : parts)
    for (int end = 0; end < 2 && turn < 0; ++end)
      if (const auto dual = element.dual_of_end(end); dual && ends_of_arcs.count(*dual) == 0)
        append_line(element, end);
  lines.insert(lines.end(), arcs.begin(), arcs.end());
  return lines;
}

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_ELEMENTS_H
