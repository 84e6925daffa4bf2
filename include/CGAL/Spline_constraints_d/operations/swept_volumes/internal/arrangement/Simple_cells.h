// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SIMPLE_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SIMPLE_CELLS_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_shells.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

/*
Tells of cells whether they can be inside or outside without another topology of the boundary, by a sufficient
condition: the cell is a ball, what it has in common with the inside is a disk of triangles, and so is what it has in
common with the outside. As the boundary joins triangles that the inside is between, and not those that the outside is
between, no other triangle of the boundary may end in a vertex inside of the first disk.
*/
class Simple_cells
{
  const Triangle_complex& m_complex;
  const Triangle_shells& m_shells;
  const std::vector<bool>& m_is_inside;
  std::vector<std::vector<std::size_t>> m_sides; // of shells: 2 triangle + side
  std::vector<int> m_kept;                       // triangles of the boundary at a vertex

public:
  Simple_cells(const Triangle_complex& complex, const Triangle_shells& shells, const std::vector<bool>& is_inside)
    : m_complex(complex), m_shells(shells), m_is_inside(is_inside), m_sides(shells.number_of_shells()),
      m_kept(complex.points.size(), 0)
  {
    for (std::size_t triangle = 0; triangle < complex.triangles.size(); ++triangle) {
      for (int side : {0, 1})
        m_sides[shells.shell_of(triangle, side)].push_back(2 * triangle + static_cast<std::size_t>(side));
      if (is_kept(triangle))
        for (const std::size_t corner : complex.triangles[triangle])
          ++m_kept[corner];
    }
  }

  bool operator()(std::size_t shell) const
  {
    const std::vector<std::size_t>& sides = m_sides[shell];
    std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> edges; // with the sides at them, by position
    std::map<std::size_t, std::array<int, 3>> vertices; // triangles to the inside, to the outside, of the boundary
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const std::size_t triangle = sides[i] / 2;
      const Corners& corners = m_complex.triangles[triangle];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = corners[k], to = corners[(k + 1) % 3];
        edges[{(std::min)(from, to), (std::max)(from, to)}].push_back(i);
        std::array<int, 3>& count = vertices[from];
        ++count[is_beyond_inside(sides[i]) ? 0 : 1];
        count[2] += is_kept(triangle);
      }
    }
    if (std::any_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second.size() != 2; }) ||
        vertices.size() + sides.size() != edges.size() + 2)
      return false; // of a connected surface, only a sphere has this characteristic
    for (const auto& [vertex, count] : vertices)
      if (count[1] == 0 && m_kept[vertex] != count[2])
        return false;
    return number_of_regions(sides, edges) == 2;
  }

  // Whether no triangle around the cell is one of the boundary.
  bool is_enclosed(std::size_t shell) const
  {
    return std::none_of(m_sides[shell].begin(), m_sides[shell].end(),
                        [&](std::size_t side) { return is_kept(side / 2); });
  }

private:
  bool is_kept(std::size_t triangle) const
  {
    return m_is_inside[m_shells.shell_of(triangle, 0)] != m_is_inside[m_shells.shell_of(triangle, 1)];
  }

  bool is_beyond_inside(std::size_t side) const
  {
    return m_is_inside[m_shells.shell_of(side / 2, side % 2 == 0 ? 1 : 0)];
  }

  // Parts of a shell that only touch cells inside, or only such outside.
  std::size_t number_of_regions(const std::vector<std::size_t>& sides,
                                const std::map<std::array<std::size_t, 2>, std::vector<std::size_t>>& edges) const
  {
    boost::disjoint_sets_with_storage<> regions(sides.size());
    for (const auto& [ends, both] : edges)
      if (is_beyond_inside(sides[both[0]]) == is_beyond_inside(sides[both[1]]))
        regions.union_set(both[0], both[1]);
    return regions.count_sets(boost::counting_iterator<std::size_t>(0),
                              boost::counting_iterator<std::size_t>(sides.size()));
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SIMPLE_CELLS_H
