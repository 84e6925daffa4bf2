// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_DIAGRAMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_DIAGRAMS_H

// What makes Voronoi diagrams of curves: with the compiled library the declarations alone. It has what runs on all
// cores where there was TBB.
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_diagram.h>
#ifdef CGAL_SPLINE_CONSTRAINTS_NEEDS_DEFINITIONS_OF_TAGS
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/traced_diagrams.h>
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_DIAGRAMS_H
