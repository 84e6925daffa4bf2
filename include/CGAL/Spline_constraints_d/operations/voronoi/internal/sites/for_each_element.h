// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_FOR_EACH_ELEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_FOR_EACH_ELEMENT_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// What has not been searched of each element: what is behind a parameter; and why. All of it, before it is searched.
struct Rest_of_search
{
  std::vector<double> begins;
  Undecided_reason why_not = Undecided_reason::NONE;

  explicit Rest_of_search(std::size_t elements) : begins(elements, 0) {}

  // Why a range of an element is not decided.
  Undecided_reason why_not_decided(std::size_t element, const Range& range) const
  {
    return range.end > begins[element] ? why_not_connected() : Undecided_reason::TOLERANCE;
  }

  // Why something is not connected to anything else: where all has been searched, that is not certain.
  Undecided_reason why_not_connected() const
  {
    return why_not == Undecided_reason::NONE ? Undecided_reason::TOLERANCE : why_not;
  }
};

// Calls search(element) for elements, until the control, which is asked for each of them, ends that. With a tag for
// parallel work, on all cores.
template <class Concurrency_tag, class Search>
void for_each_element(const std::vector<std::size_t>& elements, Search_control& control, const Search& search)
{
  parallel_for<Concurrency_tag>(elements.size(), [&](std::size_t i, std::size_t) {
    if (control.must_end())
      return;
    const Upward_rounding_guard guard;
    search(elements[i]);
    control.add_progress(1.0 / static_cast<double>(elements.size()));
  });
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_FOR_EACH_ELEMENT_H
