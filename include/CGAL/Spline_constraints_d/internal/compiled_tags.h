// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_COMPILED_TAGS_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_COMPILED_TAGS_H

#include <CGAL/tags.h>

// INSTANCES(extern, TAG) for each concurrency tag that the compiled library has instances for: none without it.
#if !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED)
#define CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(INSTANCES)
#elif !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB)
#define CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(INSTANCES) INSTANCES(extern, CGAL::Sequential_tag)
#else
#define CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(INSTANCES)                                                            \
  INSTANCES(extern, CGAL::Sequential_tag) INSTANCES(extern, CGAL::Parallel_tag)
#endif

// Whether the definitions are needed: of all tags, or of those that the library does not have.
#if !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED) ||                                                                      \
    (defined(CGAL_LINKED_WITH_TBB) && !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB))
#define CGAL_SPLINE_CONSTRAINTS_NEEDS_DEFINITIONS_OF_TAGS
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_COMPILED_TAGS_H
