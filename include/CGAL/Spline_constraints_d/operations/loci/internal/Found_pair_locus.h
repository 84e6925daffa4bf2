// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_FOUND_PAIR_LOCUS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_FOUND_PAIR_LOCUS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_curve.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

class Constraint_system_d;

namespace internal {
namespace Loci {

using Double_pair = std::array<double, 2>;

struct Pair_of_points;

// The point of the plane that belongs to two points, and to the unknowns of a solution.
using Point_of_pair = std::function<Double_pair(const Pair_of_points&, const std::vector<double>&)>;

// The curves of two parts, complete in Pair_locus_collector.h.
struct Pair_locus_part;

// A vertex of the solutions of one of the parts.
struct Vertex_of_part
{
  std::size_t part, vertex;

  friend auto operator<=>(const Vertex_of_part&, const Vertex_of_part&) = default;
};

// A locus of two curves, for those of all kernels.
struct Found_pair_locus
{
  Point_of_pair point;
  std::array<std::size_t, 2> operands{0, 1}; // of both parameters, in the order of the input
  std::shared_ptr<std::vector<Pair_locus_part>> parts = {};
  std::vector<Curve_pair_curve> curves = {};
  std::vector<Curve_vertex> points = {}, singular_points = {};
  std::vector<Undecided_region> undecided = {};
  std::vector<std::size_t> parts_of_undecided = {};
  std::size_t poles = 0;
  Summary summary = {};
};

// Points along a curve with both parameters, so near that chords are seen from the radius with this error; defined in
// Pair_locus_collector.h, as what follows.
std::vector<std::pair<Double_pair, Double_pair>>
samples_of_curve(const Found_pair_locus& found, const Curve_pair_curve& curve, double error, double radius);
bool ends_at_infinity(const Found_pair_locus& found, const Curve_pair_curve& curve, int side);
const Curve_solution_set_d& solutions_of_part(const Found_pair_locus& found, std::size_t part);
const Constraint_system_d& system_of_part(const Found_pair_locus& found, std::size_t part);
std::vector<Undecided_part> undecided_parts_of(const Found_pair_locus& found);

// The loci of two curves, or of one; defined in pair_loci.h and self_bisector.h.
Found_pair_locus bisector_of(const Exact_map<2>& first, const Exact_map<2>& second, const Solver_options& options);
Found_pair_locus alpha_sector_of(const Exact_map<2>& first, const Exact_map<2>& second, const Exact_rational& share,
                                 const Solver_options& options);
Found_pair_locus envelope_of(const Exact_map<2>& first, const Exact_map<2>& second, bool is_same_direction,
                             const Solver_options& options);
Found_pair_locus self_bisector_of(const Exact_map<2>& curve, const Solver_options& options);

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_FOUND_PAIR_LOCUS_H
