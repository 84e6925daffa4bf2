// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_DIAGRAM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_DIAGRAM_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/internal/compiled_tags.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_cell_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_coincidence_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_footpoint_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_parts_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Complete in Traced_diagram.h.
class Traced_diagram;

// A Voronoi diagram or a medial axis without a kernel: points of sites are exact, others doubles.
struct Curve_diagram
{
  struct Site
  {
    bool is_point;
    Exact_vector<2> point;
    std::optional<std::size_t> curve;
    std::array<double, 2> parameters;
    std::size_t region;
  };

  struct Vertex
  {
    std::optional<std::array<double, 2>> point;   // none at infinity
    std::optional<double> radius;
    std::vector<std::size_t> edges;
    std::vector<Voronoi_footpoint_2> footpoints;
    bool is_at_infinity, is_resolved;
    std::array<std::array<double, 2>, 2> box;   // of each coordinate, the least and the greatest one
    std::array<double, 2> radius_bounds;
  };

  std::vector<Site> sites;
  std::vector<Vertex> vertices;
  std::vector<Voronoi_edge_2> edges;
  std::vector<Voronoi_coincidence_2> coincident_parts;
  std::size_t number_of_regions = 0;
  std::vector<Undecided_part> undecided;
  Summary summary;
  std::shared_ptr<const Traced_diagram> traced;   // none if the graph of the sites was not finished
};

// The edges of a diagram that have one of two operands on each side.
struct Bisecting_chains
{
  Curve_diagram diagram;   // what is undecided has the numbers of operands; sites, those of curves
  std::vector<Trimmed_bisector_chain_2> chains;
};

// A point of an edge.
struct Disk_sample
{
  std::array<double, 2> center;
  double radius;
  std::array<std::optional<double>, 2> parameters;
  std::array<double, 2> radius_bounds;
};

// With a tag for parallel work, elements are handed to all cores. `operation` begins the messages of what is thrown.
// Defined in traced_diagrams.h.
template <class Concurrency_tag>
Curve_diagram diagram_of_curves(const Planar_operands& operands, const Solver_options& options,
                                const std::string& operation);
template <class Concurrency_tag>
Curve_diagram diagram_of_region(const Region_operand& region, const Solver_options& options);
template <class Concurrency_tag>
Bisecting_chains bisector_of_operands(const Ordered_operands& operands, const Solver_options& options);

// Of a diagram; defined in Traced_diagram.h.
std::vector<Disk_sample> samples_of_edge(const Curve_diagram& diagram, std::size_t edge, double error,
                                         double most_radius);
Voronoi_cell_2 cell_of_sites(const Curve_diagram& diagram, const std::vector<std::size_t>& sites);
std::vector<std::size_t> sites_of_curve(const Curve_diagram& diagram, std::size_t curve);
std::vector<std::size_t> nearest_sites(const Curve_diagram& diagram, const Exact_vector<2>& point);

#define CGAL_SPLINE_CONSTRAINTS_DIAGRAMS(EXTERN, TAG)                                                                  \
  EXTERN template Curve_diagram diagram_of_curves<TAG>(const Planar_operands&, const Solver_options&,                  \
                                                       const std::string&);                                            \
  EXTERN template Curve_diagram diagram_of_region<TAG>(const Region_operand&, const Solver_options&);                  \
  EXTERN template Bisecting_chains bisector_of_operands<TAG>(const Ordered_operands&, const Solver_options&);

CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(CGAL_SPLINE_CONSTRAINTS_DIAGRAMS)

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_CURVE_DIAGRAM_H
