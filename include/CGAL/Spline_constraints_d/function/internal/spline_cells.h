// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SPLINE_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SPLINE_CELLS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A tensor product spline as Bézier pieces, one for each cell of a grid of breaks, and back. Cells along each axis lie
behind each other in one dense tensor: all Bézier points of the first cell, then those of the second, ...
*/

template <class NT>
using Break_grid = std::vector<std::vector<Break<NT>>>;

// The control points seen as a dense tensor: its index bounds, as degrees.
template <class NT>
std::vector<int> extents(const std::vector<Knot_axis<NT>>& axes)
{
  std::vector<int> result;
  for (const Knot_axis<NT>& axis : axes)
    result.push_back(static_cast<int>(axis.size()) - 1);
  return result;
}

// One less than the number of cells of each axis.
template <class NT>
std::vector<int> last_cells(const Break_grid<NT>& breaks)
{
  std::vector<int> result;
  for (const auto& axis : breaks)
    result.push_back(static_cast<int>(axis.size()) - 2);
  return result;
}

// Where the entries of the cells of an axis are: one cell begins `stride` after the one before.
struct Cell_layout
{
  std::vector<int> extents, strides;

  void add_axis(int degree, std::size_t cells, bool share_ends)
  {
    strides.push_back(share_ends ? degree : degree + 1);
    extents.push_back(strides.back() * static_cast<int>(cells) - (share_ends ? 0 : 1));
  }

  std::vector<int> first_of_cell(std::vector<int> cell) const
  {
    for (std::size_t j = 0; j < cell.size(); ++j)
      cell[j] *= strides[j];
    return cell;
  }
};

// Whether the control points are the Bézier points of the cells, which share those at the breaks: all knots occur as
// often as they can.
template <class NT>
bool has_bezier_points(const Knot_axis<NT>& axis, std::size_t cells)
{
  return axis.is_clamped() && axis.size() == static_cast<std::size_t>(axis.degree) * cells + 1;
}

#define CGAL_SPLINE_CONSTRAINTS_SPLINE_CELLS(EXTERN, NT)                                                               \
  EXTERN template std::vector<Bernstein_tensor<NT>> pieces_on_cells<NT>(const std::vector<Knot_axis<NT>>&,             \
                                                                        std::vector<NT>, const Break_grid<NT>&);       \
  EXTERN template std::pair<std::vector<Knot_axis<NT>>, std::vector<NT>> assembled_cells<NT>(                          \
      const std::vector<int>&, const Break_grid<NT>&, const std::vector<Bernstein_tensor<NT>>&);

// The polynomials on the cells, each on the unit box, in row-major order of the cells, last axis fastest. The grid is
// as fine as the knots at least.
template <class NT>
std::vector<Bernstein_tensor<NT>> pieces_on_cells(const std::vector<Knot_axis<NT>>& axes, std::vector<NT> data,
                                                  const Break_grid<NT>& breaks)
{
  std::vector<int> degrees, extent = extents(axes);
  Cell_layout layout;
  for (std::size_t j = 0; j < axes.size(); ++j) {
    const std::size_t cells = breaks[j].size() - 1;
    const bool has_points = has_bezier_points(axes[j], cells);
    degrees.push_back(axes[j].degree);
    layout.add_axis(axes[j].degree, cells, has_points);
    if (!has_points)
      data = transform_axis(data, axis_view(extent, j), extraction_matrix(axes[j], breaks[j]));
    extent[j] = layout.extents[j];
  }
  std::vector<Bernstein_tensor<NT>> pieces;
  for_each_index(last_cells(breaks), [&](const std::vector<int>& cell) {
    pieces.emplace_back(degrees, tensor_block(data, extent, layout.first_of_cell(cell), degrees));
  });
  return pieces;
}

// The spline with these pieces, as clamped axes and control points. It is as smooth at the breaks as their
// multiplicities promise.
template <class NT>
std::pair<std::vector<Knot_axis<NT>>, std::vector<NT>> assembled_cells(const std::vector<int>& degrees,
                                                                       const Break_grid<NT>& breaks,
                                                                       const std::vector<Bernstein_tensor<NT>>& pieces)
{
  std::vector<Knot_axis<NT>> axes;
  Cell_layout layout;
  for (std::size_t j = 0; j < degrees.size(); ++j) {
    axes.push_back(clamped(degrees[j], breaks[j]));
    layout.add_axis(degrees[j], breaks[j].size() - 1, has_bezier_points(axes[j], breaks[j].size() - 1));
  }
  std::vector<int> extent = layout.extents;
  std::vector<NT> data(checked_tensor_size<NT>(extent, "Bspline_function"), NT(0));
  auto piece = pieces.begin();
  for_each_index(last_cells(breaks), [&](const std::vector<int>& cell) {
    place_tensor_block(data, extent, layout.first_of_cell(cell), (piece++)->coefficients(), degrees);
  });
  for (std::size_t j = 0; j < degrees.size(); ++j) {
    if (layout.strides[j] > degrees[j])
      data = transform_axis(data, axis_view(extent, j), assembly_matrix(axes[j], breaks[j]));
    extent[j] = static_cast<int>(axes[j].size()) - 1;
  }
  return {std::move(axes), std::move(data)};
}

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_SPLINE_CELLS(extern, double)
CGAL_SPLINE_CONSTRAINTS_SPLINE_CELLS(extern, Exact_rational)
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SPLINE_CELLS_H
