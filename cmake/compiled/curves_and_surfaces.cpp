// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is found on one or two curves or surfaces: common points and curves, contacts, silhouettes, umbilics, distances,
// bisectors, envelopes; primitives made exact. What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED
#define CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS

#include <CGAL/Spline_constraints_d/geometry/curves/internal/traced_curves.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/Primitive_healer.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/strips_of_edges.h>
#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Arc_germ.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Sign_sequence.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/critical_values.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/integral_of_quotient.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/internal/Height_comparison.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_arcs_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_features_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/ray_traps_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Circle_emptiness.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Common_normal_finder.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Farthest_point_search.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Implicit_foot_finder.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/nearest_points_in_doubles.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/prepared_splines.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/near_special_points.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Contact_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Height_field.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Patch_inverse.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Self_intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/common_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Regular_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/found_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/repeated_parts.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Offset_self_intersection.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/pair_loci.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/self_bisector.h>
#include <CGAL/Spline_constraints_d/operations/loci/point_curve_bisector_2.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_piece_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Trimmed_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/curves_on_bisectors_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/zeros_on_bisector.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/region_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_circular_polygons_2.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Neighborhood.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Oriented_mesh.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Patch_coefficients.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Access_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Silhouette_event_finder.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_curve_collector.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Sweep_event_finder.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Umbilic_finder.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/self_intersections_of_surface.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/silhouettes_of_sweep.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/zeros_on_surface.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/locus_intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_element_2.h>

namespace CGAL::Spline_constraints::internal {
namespace Common {

template class Spline_patch<2>;
template class Spline_patch<3>;
template class Patch_pair<2>;
template class Patch_pair<3>;

} // namespace Common
namespace Intersections {

template std::optional<Elementary_points<2>> elementary_points<2>(const Elementary_operand<2>&,
                                                                  const Elementary_operand<2>&);
template std::optional<Elementary_points<3>> elementary_points<3>(const Elementary_operand<3>&,
                                                                  const Elementary_operand<3>&);
template std::optional<Elementary_points<2>> crossing_points<2>(const Elementary_operand<2>&,
                                                                const Elementary_operand<2>&);
template std::optional<Elementary_points<3>> crossing_points<3>(const Elementary_operand<3>&,
                                                                const Elementary_operand<3>&);
template Regular_points<2> regular_points<2>(const Elementary_operand<2>&, const Elementary_operand<2>&,
                                             Budgeted_solver&);
template Regular_points<3> regular_points<3>(const Elementary_operand<3>&, const Elementary_operand<3>&,
                                             Budgeted_solver&);
template std::vector<Common_point> common_points<2>(const Patch_pair<2>&, Budgeted_solver&, const Known_solutions&);
template std::vector<Common_point> common_points<3>(const Patch_pair<3>&, Budgeted_solver&, const Known_solutions&);
template std::vector<Common_point> self_common_points<2>(const Spline_patch<2>&, Budgeted_solver&);
template std::vector<Common_point> self_common_points<3>(const Spline_patch<3>&, Budgeted_solver&);
template int times_over_itself<2>(const Spline_patch<2>&);
template int times_over_itself<3>(const Spline_patch<3>&);
template Found_implicit_equation implicit_equation_of<2>(const Exact_map<2>&, int, const Solver_options&);
template Found_implicit_equation implicit_equation_of<3>(const Exact_map<3>&, int, const Solver_options&);

} // namespace Intersections
namespace Distances {

template Found_distances<2> projections_of<2>(const Exact_map<2>&, const Exact_map<2>&, const Solver_options&);
template Found_distances<3> projections_of<3>(const Exact_map<3>&, const Exact_map<3>&, const Solver_options&);
template Found_distances<2> nearest_points_of<2>(const Exact_map<2>&, const Exact_map<2>&, const Solver_options&);
template Found_distances<3> nearest_points_of<3>(const Exact_map<3>&, const Exact_map<3>&, const Solver_options&);
template Found_coincidences<2> near_coincidences_of<2>(const std::vector<Exact_map<2>>&, bool, std::optional<double>,
                                                       const Solver_options&);
template Found_coincidences<3> near_coincidences_of<3>(const std::vector<Exact_map<3>>&, bool, std::optional<double>,
                                                       const Solver_options&);
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(, double, 2)
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(, double, 3)
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(, Exact_rational, 2)
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(, Exact_rational, 3)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(, double, 2)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(, double, 3)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(, Exact_rational, 2)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(, Exact_rational, 3)
template Found_hausdorff_distance<2> hausdorff_distance_of<2>(const Exact_map<2>&, const Exact_map<2>&, double, bool,
                                                              const Solver_options&);
template Found_hausdorff_distance<3> hausdorff_distance_of<3>(const Exact_map<3>&, const Exact_map<3>&, double, bool,
                                                              const Solver_options&);

} // namespace Distances
} // namespace CGAL::Spline_constraints::internal
