// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_OF_REGIONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_OF_REGIONS_2_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/Minkowski_sum_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/undecided_region.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
Minkowski sums without a kernel, for all kernels; defined in Sum_model_2.h.
*/

// The boundaries of a set, made of so many curves; or why it is undecided what they are.
struct Sum_operand_2
{
  std::vector<Boundary_loop_2> loops;
  std::size_t number_of_curves;
  std::vector<Undecided_part> undecided = {};
  Undecided_reason reason = Undecided_reason::NONE;
};

// Curves are counted from a number on.
template <class Region>
Sum_operand_2 sum_operand(const Region& region, std::size_t first_curve)
{
  const std::size_t curves = region.curves().size();
  if (!region.is_complete())
    return {{}, curves, {undecided_region(region, first_curve)}, region.summary().why_not};
  return {region.loops(), curves};
}

// A point of an arc, and the parameters of the points that it is the sum of.
struct Sum_sample_2
{
  std::array<double, 2> point, parameters;
};

// All that was computed.
class Sum_model_2;

struct Sum_of_regions_2
{
  std::shared_ptr<const Sum_model_2> model;   // none if an operand is undecided
  std::vector<Minkowski_sum_boundary_2> boundaries;
  std::vector<Undecided_part> undecided;
  Summary summary;
};

// \throws Invalid_input as `minkowski_sum()`
Sum_of_regions_2 sum_of_regions(const std::array<Sum_operand_2, 2>& operands, const Solver_options& options);

CGAL::Uncertain<bool> has_in_interior(const Sum_model_2& sum, const Exact_pair& point);

std::vector<Sum_sample_2> samples_along_arc(const Sum_model_2& sum, std::size_t boundary, std::size_t arc,
                                            double error);

// Without the ends of arcs, where the next ones begin.
std::vector<std::array<double, 2>> points_along_boundary(const Sum_model_2& sum, std::size_t boundary, double error);

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_OF_REGIONS_2_H
