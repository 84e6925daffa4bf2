// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_CURVE_OFFSET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_CURVE_OFFSET_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/internal/compiled_tags.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_parts_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Complete in Traced_offset.h.
class Traced_offset;

// A trimmed offset without a kernel.
struct Curve_offset
{
  struct Arc
  {
    std::optional<Exact_vector<2>> center;   // of an arc around a point
    std::optional<std::size_t> curve;
    std::array<double, 2> parameters;
  };

  std::vector<Arc> arcs;
  std::vector<Trimmed_offset_boundary_2> boundaries;
  std::vector<Undecided_part> undecided;
  Summary summary;
  std::shared_ptr<const Traced_offset> traced;   // none if the graph of the sites was not finished
};

// The offset at a positive radius. With a tag for parallel work, elements are handed to all cores. Defined in
// traced_offsets.h.
template <class Concurrency_tag>
Curve_offset offset_of_curves(const Planar_operands& operands, const Exact_rational& radius,
                              const Solver_options& options);

// The offset of a region that has grown, or shrunk, by a distance other than zero.
template <class Concurrency_tag>
Curve_offset offset_of_region(const Region_operand& region, const Exact_rational& distance,
                              const Solver_options& options);

// Defined in Traced_offset.h.
std::vector<std::array<double, 2>> points_of_arc(const Curve_offset& offset, std::size_t arc, double error);

#define CGAL_SPLINE_CONSTRAINTS_OFFSETS(EXTERN, TAG)                                                                   \
  EXTERN template Curve_offset offset_of_curves<TAG>(const Planar_operands&, const Exact_rational&,                    \
                                                     const Solver_options&);                                           \
  EXTERN template Curve_offset offset_of_region<TAG>(const Region_operand&, const Exact_rational&,                     \
                                                     const Solver_options&);

CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(CGAL_SPLINE_CONSTRAINTS_OFFSETS)

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_CURVE_OFFSET_H
