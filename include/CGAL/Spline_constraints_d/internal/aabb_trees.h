// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_AABB_TREES_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_AABB_TREES_H

// CGAL's trees of boxes in space: their traits have another header and name since CGAL 6.

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/AABB_tree.h>
#if CGAL_VERSION_NR < 1060000000
#include <CGAL/AABB_traits.h>
#else
#include <CGAL/AABB_traits_3.h>
#endif

namespace CGAL {
namespace Spline_constraints {
namespace internal {

#if CGAL_VERSION_NR < 1060000000
template <class Kernel, class Primitive>
using Aabb_tree_3 = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#else
template <class Kernel, class Primitive>
using Aabb_tree_3 = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_AABB_TREES_H
