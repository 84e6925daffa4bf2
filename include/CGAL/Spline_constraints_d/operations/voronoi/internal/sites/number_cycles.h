// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_NUMBER_CYCLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_NUMBER_CYCLES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Oriented_element_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Numbers the cycles in which elements follow each other, and the connected sets that they belong to: those of both
// sides of an arc are connected. The sides of arc i are elements 2 i and 2 i + 1.
template <Enclosing_number Interval>
void number_cycles(std::vector<Oriented_element<Interval>>& elements)
{
  std::vector<char> is_visited(elements.size(), false);
  std::size_t cycles = 0;
  for (std::size_t first = 0; first < elements.size(); ++first)
    if (!is_visited[first]) {
      for (std::size_t f = first; !is_visited[f]; f = elements[f].next) {
        is_visited[f] = true;
        elements[f].cycle = cycles;
      }
      ++cycles;
    }
  boost::disjoint_sets_with_storage<> sets(cycles);
  for (std::size_t f = 0; f < elements.size() && !elements[f].is_normal_cone; f += 2)
    sets.union_set(elements[f].cycle, elements[f + 1].cycle);
  for (Oriented_element<Interval>& element : elements)
    element.component = sets.find_set(element.cycle);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_NUMBER_CYCLES_H
