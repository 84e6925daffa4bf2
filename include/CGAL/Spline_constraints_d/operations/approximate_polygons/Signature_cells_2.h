// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_SIGNATURE_CELLS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_SIGNATURE_CELLS_2_H

#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Approximate_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDApproximatePolygons

All points that have one signature in one model at least of an approximate polygon. Cells of different signatures
overlap where lines of an edge pass.
*/
struct Signature_cell_2
{
  std::string signature;       ///< a letter for each edge, as of `Approximate_polygon_2`
  Signature_location location; ///< where these points are in these models: inside or outside

  //! convex polygons with disjoint interiors, counterclockwise, whose union is the closure of the cell, in the window.
  std::vector<Approximate_polygon_2::Polygon> parts;
};

/*!
\ingroup PkgSplineConstraintsDApproximatePolygons

The signatures that points have in models of an approximate polygon, with their cells: see `signature_cells()`.
*/
class Signature_cells_2
{
public:
  using Polygon = Approximate_polygon_2::Polygon; //!< of the exact kernel.

private:
  std::vector<Signature_cell_2> m_cells;
  Polygon m_window;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what the operation has found.
  Signature_cells_2(std::vector<Signature_cell_2> cells, Polygon window, std::vector<Undecided_part> undecided,
                    const Summary& summary)
    : m_cells(std::move(cells)), m_window(std::move(window)), m_undecided(std::move(undecided)), m_summary(summary)
  {}

  //! one for each signature, in lexicographical order. If the answer is complete, no model has a point with another
  //! signature.
  const std::vector<Signature_cell_2>& cells() const { return m_cells; }

  //! the cell of a signature, or a null pointer if there is none.
  const Signature_cell_2* find(const std::string& signature) const
  {
    const auto found =
        std::lower_bound(m_cells.begin(), m_cells.end(), signature,
                         [](const Signature_cell_2& cell, const std::string& s) { return cell.signature < s; });
    return found != m_cells.end() && found->signature == signature ? &*found : nullptr;
  }

  //! a rectangle to which cells are cut off. All corners of cells are in its interior, so that cells go on beyond it
  //! without an end, exactly if they meet its boundary.
  const Polygon& window() const { return m_window; }

  //! whether all cells are there, and all of each.
  bool is_complete() const { return m_summary.is_complete; }

  //! what is not decided, where a limit has ended the run: boxes in which there may be further parts of cells.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work; nodes are parts of the plane.
  const Summary& summary() const { return m_summary; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_SIGNATURE_CELLS_2_H
