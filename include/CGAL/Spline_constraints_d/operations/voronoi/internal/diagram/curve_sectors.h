// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_SECTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_SECTORS_H

// What makes trimmed sectors: with the compiled library the declarations alone. It has what runs on all
// cores where there was TBB.
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_sector.h>
#ifdef CGAL_SPLINE_CONSTRAINTS_NEEDS_DEFINITIONS_OF_TAGS
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/traced_sectors.h>
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_SECTORS_H
