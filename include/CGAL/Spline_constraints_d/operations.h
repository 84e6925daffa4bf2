// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_H

// All operations on curves and surfaces, of all subjects.
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_kind.h>
#include <CGAL/Spline_constraints_d/operations/common/Surface_curve.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/Boundary_vertex_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/Convex_hull_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/Hull_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/bitangents_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_arcs_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_features_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/ray_traps_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/tangent_circles_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>
#include <CGAL/Spline_constraints_d/operations/distances/Located_hit.h>
#include <CGAL/Spline_constraints_d/operations/distances/Located_point.h>
#include <CGAL/Spline_constraints_d/operations/distances/Surface_locator_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/distances/hausdorff_distance.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Locus_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection_point.h>
#include <CGAL/Spline_constraints_d/operations/intersections/contact_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/locus_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/pairwise_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>
#include <CGAL/Spline_constraints_d/operations/joints/exact_joints_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_curve.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_sample.h>
#include <CGAL/Spline_constraints_d/operations/loci/alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/envelope_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/point_curve_bisector_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/self_bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/Minkowski_sum_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/Minkowski_sum_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_piece_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/curves_on_bisectors_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/Polyline_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_region_streams_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_circular_polygons_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_general_polygons_2.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/locus_intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/parabolic_lines.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/plane_sections.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/self_intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/umbilics.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_face_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Kernel_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Region_kernel_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Visible_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Visible_part_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Trimmed_alpha_sector_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Trimmed_bisector_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Trimmed_offset_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_cell_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_coincidence_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_footpoint_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_sample_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_site_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_edge_curves_2.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_H
