// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FINDERS_H

// What finds common points: with the compiled library the declarations alone.
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/regular_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Contact_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Self_intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/common_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Regular_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/repeated_parts.h>
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FINDERS_H
