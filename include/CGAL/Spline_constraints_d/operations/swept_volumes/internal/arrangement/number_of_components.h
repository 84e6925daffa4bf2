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

#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Connected parts of a mesh.
inline std::size_t number_of_components(const CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>& mesh)
{
  boost::disjoint_sets_with_storage<> parts(mesh.number_of_faces());
  const auto face = [&](const auto edge, unsigned side) {
    return static_cast<std::size_t>(mesh.face(mesh.halfedge(edge, side)));
  };
  for (const auto edge : mesh.edges())
    if (!mesh.is_border(edge))
      parts.union_set(face(edge, 0), face(edge, 1));
  return parts.count_sets(boost::counting_iterator<std::size_t>(0),
                          boost::counting_iterator<std::size_t>(mesh.number_of_faces()));
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_NUMBER_OF_COMPONENTS_H
