// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CELL_BOUNDARIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CELL_BOUNDARIES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Halfedges along which a set of sites borders on others, each one the next one of that before, counterclockwise.
struct Halfedge_chain
{
  std::vector<std::size_t> halfedges;
  bool is_closed;
};

// The boundary of the union of the cells of some sites, out of their halfedges.
template <class Is_inside>
class Cell_boundaries
{
  const Disk_diagram& m_diagram;
  const Is_inside& m_is_inside;   // of a halfedge: whether its element is one of the sites

public:
  Cell_boundaries(const Disk_diagram& diagram, const Is_inside& is_inside) : m_diagram(diagram), m_is_inside(is_inside)
  {}

  std::vector<Halfedge_chain> operator()(const std::vector<std::size_t>& halfedges) const
  {
    std::set<std::size_t> left, followers;
    for (const std::size_t h : halfedges)
      if (is_on_boundary(h)) {
        left.insert(h);
        followers.insert(next_on_boundary(h));
      }
    std::vector<Halfedge_chain> result;
    for (const std::size_t h : halfedges)
      if (left.contains(h) && !followers.contains(h))
        result.push_back({chain(h, left), false});
    for (const std::size_t h : halfedges)
      if (left.contains(h))
        result.push_back({chain(h, left), true});
    return result;
  }

private:
  const Disk_diagram::Halfedge& halfedge(std::size_t h) const { return m_diagram.halfedges()[h]; }

  bool is_on_boundary(std::size_t h) const
  {
    return halfedge(h).twin != Disk_diagram::none && !m_is_inside(halfedge(h).twin);
  }

  std::vector<std::size_t> chain(std::size_t first, std::set<std::size_t>& left) const
  {
    std::vector<std::size_t> result;
    for (std::size_t h = first; left.erase(h) > 0; h = next_on_boundary(h))
      result.push_back(h);
    return result;
  }

  // Elements are traversed with the centers of disks on the left, so that the cells are on the right of halfedges: the
  // boundary goes on with what comes before, past edges between two of the sites. It ends at infinity, at what is not
  // resolved, and where the foot goes over to another site.
  std::size_t next_on_boundary(std::size_t h) const
  {
    while (!halfedge(h).begins_unresolved) {
      const std::size_t before = halfedge(h).previous, twin = halfedge(before).twin;
      if (twin == Disk_diagram::none || !m_is_inside(before))
        break;
      if (!m_is_inside(twin))
        return before;
      h = twin;
    }
    return Disk_diagram::none;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CELL_BOUNDARIES_H
