// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_NUMBER_OF_COMPONENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_NUMBER_OF_COMPONENTS_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Connected parts of a mesh.
inline std::size_t number_of_components(const CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>& mesh)
{
  std::size_t result = mesh.number_of_faces();
  std::vector<std::size_t> rank(result), parent(result);
  boost::disjoint_sets<std::size_t*, std::size_t*> parts(rank.data(), parent.data());
  for (const auto face : mesh.faces())
    parts.make_set(static_cast<std::size_t>(face));
  for (const auto edge : mesh.edges()) {
    if (mesh.is_border(edge))
      continue;
    const std::size_t one = parts.find_set(static_cast<std::size_t>(mesh.face(mesh.halfedge(edge, 0)))),
                      other = parts.find_set(static_cast<std::size_t>(mesh.face(mesh.halfedge(edge, 1))));
    if (one != other) {
      parts.link(one, other);
      --result;
    }
  }
  return result;
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_NUMBER_OF_COMPONENTS_H
