// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the floors below the operations have but for the solvers by subdivision: numbers, functions, splines, readers and
// writers of files; propagation, feasibility, Newton's method, proofs of answers.
#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/read_minibex.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_VTP.h>
#include <CGAL/Spline_constraints_d/IO/write_minibex.h>
#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>
#include <CGAL/Spline_constraints_d/function.h>
#include <CGAL/Spline_constraints_d/function/internal/Local_weights.h>
#include <CGAL/Spline_constraints_d/function/internal/decompositions.h>
#include <CGAL/Spline_constraints_d/function/internal/expanded.h>
#include <CGAL/Spline_constraints_d/function/internal/graph/graph_derivatives.h>
#include <CGAL/Spline_constraints_d/function/internal/graph/graph_operations.h>
#include <CGAL/Spline_constraints_d/function/internal/integer_factors.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_composition.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/spline_streams.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/conic_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/bezier_chords.h>
#include <CGAL/Spline_constraints_d/geometry/curves/spline_fitting.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/geometry/internal/unit_normal_of_piece.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/canal_surfaces.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/rational_offset.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surface_fitting.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number.h>
#include <CGAL/Spline_constraints_d/solver.h>
#include <CGAL/Spline_constraints_d/solver/internal/Newton_iteration.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/proof_by_parts.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Elementary_feasibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/feasibility_of.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/solutions_of_polynomials.h>
#include <CGAL/Spline_constraints_d/solver/internal/tracking/tracking_steps.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/Elementary_proof.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/proof_of_answer.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/surface_proof.h>

namespace CGAL::Spline_constraints {

template class Bernstein_tensor<double>;
template class Bernstein_tensor<Exact_rational>;
template class Bspline_function<double>;
template class Bspline_function<Exact_rational>;

CGAL_SPLINE_CONSTRAINTS_BSPLINE_CURVES(, double)
CGAL_SPLINE_CONSTRAINTS_BSPLINE_CURVES(, Exact_rational)
CGAL_SPLINE_CONSTRAINTS_BSPLINE_SURFACES(, double)
CGAL_SPLINE_CONSTRAINTS_BSPLINE_SURFACES(, Exact_rational)
CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(, Mpfr_interval)
CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(, Exact_rational)

namespace internal {

template std::size_t checked_tensor_size<double>(const std::vector<int>&, std::string_view);
template std::size_t checked_tensor_size<Exact_rational>(const std::vector<int>&, std::string_view);
CGAL_SPLINE_CONSTRAINTS_SPLINE_CELLS(, double)
CGAL_SPLINE_CONSTRAINTS_SPLINE_CELLS(, Exact_rational)
template int certified_weight_sign(const Bspline_function<double>&, const Weight_options&);
template int certified_weight_sign(const Bspline_function<Exact_rational>&, const Weight_options&);
template class Local_weights<double>;
template class Local_weights<Exact_rational>;
template class Homogeneous_spline<double, 2>;
template class Homogeneous_spline<double, 3>;
template class Homogeneous_spline<Exact_rational, 2>;
template class Homogeneous_spline<Exact_rational, 3>;

CGAL_SPLINE_CONSTRAINTS_PROPAGATION(, CGAL::Sequential_tag)
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB
CGAL_SPLINE_CONSTRAINTS_PROPAGATION(, CGAL::Parallel_tag)
#endif

} // namespace internal
} // namespace CGAL::Spline_constraints
