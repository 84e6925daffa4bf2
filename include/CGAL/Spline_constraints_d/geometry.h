// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_H

// All of the floor of geometry: curves and surfaces, conversions from and to those of CGAL, and healing of rounded
// data. Adaptors to OpenCASCADE are in geometry/conversions/opencascade.h.
#include <CGAL/Spline_constraints_d/geometry/Implicit_hypersurface.h>
#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/Parametric_locus.h>
#include <CGAL/Spline_constraints_d/geometry/Parametric_spline.h>
#include <CGAL/Spline_constraints_d/geometry/Point_locus.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/bezier_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/circle_segment_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/circular_arcs.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/conic_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_cgal_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/mesh_faces.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/spline_streams.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_surface.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Evolute_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Proper_reparametrization.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/clipped_lines.h>
#include <CGAL/Spline_constraints_d/geometry/curves/conic_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/cubic_interpolation.h>
#include <CGAL/Spline_constraints_d/geometry/curves/hermite_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/proper_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/smooth_joints.h>
#include <CGAL/Spline_constraints_d/geometry/curves/spline_fitting.h>
#include <CGAL/Spline_constraints_d/geometry/healing/Primitive_kind.h>
#include <CGAL/Spline_constraints_d/geometry/healing/exact_primitives.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Surface_atlas_d.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/canal_surfaces.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/dupin_cyclides.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/rational_offset.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_H
