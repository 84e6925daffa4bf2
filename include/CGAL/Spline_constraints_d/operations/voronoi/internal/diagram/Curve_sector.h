// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_SECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_SECTOR_H

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

// Complete in Traced_sector.h.
class Traced_sector;

// A trimmed alpha-sector without a kernel.
struct Curve_sector
{
  std::vector<Trimmed_alpha_sector_arc_2> arcs;
  std::vector<Trimmed_alpha_sector_chain_2> chains;
  std::vector<Undecided_part> undecided;
  Summary summary;
  std::shared_ptr<const Traced_sector> traced;   // none if the graph of the sites was not finished
};

// A point of an arc.
struct Sector_sample
{
  std::array<double, 2> point, distances;
  std::array<std::optional<double>, 2> parameters;
};

// The points whose distances from two operands have the ratio alpha : 1 - alpha. With a tag for parallel work, elements
// are handed to all cores. Defined in traced_sectors.h.
template <class Concurrency_tag>
Curve_sector sector_of_operands(const Ordered_operands& operands, const Exact_rational& alpha,
                                const Solver_options& options);

// Defined in Traced_sector.h.
std::vector<Sector_sample> samples_of_arc(const Curve_sector& sector, std::size_t arc, double error);

#define CGAL_SPLINE_CONSTRAINTS_SECTORS(EXTERN, TAG)                                                                   \
  EXTERN template Curve_sector sector_of_operands<TAG>(const Ordered_operands&, const Exact_rational&,                 \
                                                       const Solver_options&);

CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(CGAL_SPLINE_CONSTRAINTS_SECTORS)

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_SECTOR_H
