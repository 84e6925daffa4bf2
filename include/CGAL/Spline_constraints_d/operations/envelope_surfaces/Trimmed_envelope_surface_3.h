// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TRIMMED_ENVELOPE_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TRIMMED_ENVELOPE_SURFACE_3_H

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

Whether the points of a bisector or sector have, in both of their feet, the nearest points of the operands.
*/
enum class Nearest_feet_label
{
  NEAREST,     ///< no point of an operand is nearer
  NOT_NEAREST, ///< some point of an operand is nearer
  BOTH,        ///< one arc divides a cell into points with either label
  UNDECIDED    ///< nothing is proved
};

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

A box of parameters of the operands with the label of all solutions in it. Boxes cover the surface, and may overlap.
*/
struct Trimmed_cell_3
{
  std::size_t part;                       ///< index of the part of the surface
  std::vector<Undecided_part::Range> box; ///< ranges of the parameters, in the order of the unknowns
  Nearest_feet_label label;               ///< what is proved of it
};

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

A bisector or sector, and where its points have their feet as the nearest points of the operands: cells with proved
labels, and triangles that are cut where labels change.
*/
class Trimmed_envelope_surface_3
{
public:
  //! the label of a solution of a part, with the parameters that are given first.
  using Label = std::function<Nearest_feet_label(std::size_t, std::span<const double>)>;

private:
  Envelope_surface_3 m_untrimmed;
  std::vector<Trimmed_cell_3> m_cells;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;
  Label m_label;

public:
  //! what an operation has found.
  Trimmed_envelope_surface_3(Envelope_surface_3 untrimmed, std::vector<Trimmed_cell_3> cells,
                             const std::vector<Undecided_part>& undecided, const Summary& summary, Label label)
    : m_untrimmed(std::move(untrimmed)), m_cells(std::move(cells)), m_undecided(m_untrimmed.undecided()),
      m_summary(summary), m_label(std::move(label))
  {
    m_undecided.insert(m_undecided.end(), undecided.begin(), undecided.end());
  }

  //! the surface, untrimmed.
  const Envelope_surface_3& untrimmed() const { return m_untrimmed; }

  //! the cells.
  const std::vector<Trimmed_cell_3>& cells() const { return m_cells; }

  //! the number of cells with a label.
  std::size_t number_of_cells(Nearest_feet_label label) const
  {
    return static_cast<std::size_t>(
        std::ranges::count_if(m_cells, [&](const Trimmed_cell_3& cell) { return cell.label == label; }));
  }

  //! the label of the solution of a part that is nearest to unknowns, as of a vertex of a mesh, by proof up to the
  //! rounding of these numbers: `NEAREST`, `NOT_NEAREST` or `UNDECIDED`.
  Nearest_feet_label label(std::size_t part, std::span<const double> unknowns) const { return m_label(part, unknowns); }

  //! whether all of the surface is there, and all cells have a label, by proof.
  bool is_complete() const { return m_undecided.empty() && m_summary.is_complete; }

  //! what is undecided: of the surface, and cells that touch each other, with boxes of parameters around them.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work, with that for the untrimmed surface; a node of the rest is a cell that was looked at.
  const Summary& summary() const { return m_summary; }

  /*!
  triangles of what is kept, and of what is undecided: those of the untrimmed surface, cut where labels change between
  the ends of edges. A point of the border is between a vertex with the label `NEAREST` and a point `NOT_NEAREST`, or
  one that is not decided, on the surface and next to it. The map `"f:label"` of `Nearest_feet_label` tells both kinds
  of triangles apart. What is smaller than triangles may be missing.
  \param options how fine the triangles are, in space.
  \param run the limit of time, and a visitor.
  \throws Invalid_input when a bound is not positive.
  */
  Solution_surface_mesh mesh(const Surface_mesh_options& options = {}, const Solver_options& run = {}) const;
};

//! writes one line with the counts.
//! \relates Trimmed_envelope_surface_3
std::ostream& operator<<(std::ostream& out, const Trimmed_envelope_surface_3& surface);

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TRIMMED_ENVELOPE_SURFACE_3_H
