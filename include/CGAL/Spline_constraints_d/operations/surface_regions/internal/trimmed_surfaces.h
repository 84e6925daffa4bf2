// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_SURFACES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_mesh_3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Polynomials in two parameters, on the unit box.
using Cell_polynomial = Bernstein_tensor<Exact_rational>;
using Parameters = std::array<Exact_rational, 2>;

// The faces that the zeros of polynomials leave of a cell, in parameters of the unit box; or why they are not known.
// Borders have ranges that are certainly between the ends of curves.
struct Cell_faces
{
  std::vector<Surface_face_3> faces = {};
  std::vector<Surface_border_3> borders = {};
  std::vector<Undecided_part> undecided = {};
  std::vector<Cell_polynomial> zeros = {}; // those whose zeros are the curves
};

// Chords are at most `error` beside the arcs that they stand for, in the unit box. Polynomials must not vanish on a
// whole side of the box. The first function knows all curves of the product of the polynomials, with their singular
// points; it does not matter how often they vanish. The other one takes less time for several ones, and knows them if
// they are `Crossing_arcs`. Defined in Cell_arrangement.h.
Cell_faces faces_of_product(const std::vector<Cell_polynomial>& zeros, double error, Operation_budget& budget);
Cell_faces faces_of_arcs(const std::vector<Cell_polynomial>& zeros, double error, Operation_budget& budget);

// A part of a cell, in local parameters, with its faces and their labels.
struct Labelled_part
{
  std::array<Surface_cell_3::Range, 2> box;
  Cell_faces faces; // in parameters of the part
};

// What a surface is cut by and into.
struct Trimming
{
  std::vector<Surface_cell_3> cells;
  std::array<bool, 2> is_closed{}; // whether the ends of an axis are the same points

  // The polynomials of a cell whose zeros bound faces, and the label at parameters in a cell. They may throw
  // Run_stopped. Where the faces of a cell are not found, it is split; these are asked with the index of the whole.
  std::function<std::vector<Cell_polynomial>(std::size_t)> zeros;
  std::function<std::optional<int>(std::size_t, const Parameters&)> label;

  // The parts of a cell, which cover it, if other curves bound faces in it; none if only the polynomials do. Those
  // without labels get them as above.
  std::function<std::optional<std::vector<Labelled_part>>(std::size_t)> parts = {};
};

// Defined in trimmed_by_zeros.h.
Trimmed_surface_3 trimmed_by_zeros(const Trimming& trimming, Operation_budget& budget, double error = 0x1p-10);

// The faces with a label as triangles; defined in Cell_triangulation.h.
Trimmed_surface_mesh_3 mesh_of_label(const Trimmed_surface_3& surface, int label, double error,
                                     const Solver_options& options);

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_SURFACES_H
