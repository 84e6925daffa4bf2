// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTOR_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/curve_sectors.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_parts_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

A trimmed \f$\alpha\f$-sector: all points whose distances from two curves or points, each from the nearest of its
points, have the ratio \f$\alpha : 1 - \alpha\f$.

It consists of closed curves, chains of arcs: on each, the nearest points are on the same piece of each curve, or the
same end or corner. Arcs are connected by proof, and where something is not decided, `is_complete()` is false, and
`undecided()` tells where that is; chains that are affected are not closed.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Trimmed_alpha_sector_2
{
public:
  using Point = typename Kernel::Point_2;

  using Arc = Trimmed_alpha_sector_arc_2;
  using Chain = Trimmed_alpha_sector_chain_2;

  //! a point of the sector.
  struct Sample
  {
    Point point;                         ///< the point, rounded
    std::array<double, 2> distances;     ///< from both operands
    std::array<std::optional<double>, 2> parameters;   ///< of the nearest points; none, if the nearest one is an end
  };

private:
  internal::Voronoi::Curve_sector m_sector;

public:
  //! a sector without arcs. Others are made by `trimmed_alpha_sector()`.
  Trimmed_alpha_sector_2() = default;

  //! a sector that an operation has found.
  explicit Trimmed_alpha_sector_2(internal::Voronoi::Curve_sector sector) : m_sector(std::move(sector)) {}

  //! the arcs.
  const std::vector<Arc>& arcs() const { return m_sector.arcs; }

  //! the chains; each arc belongs to one.
  const std::vector<Chain>& chains() const { return m_sector.chains; }

  //! whether all of the sector is proved.
  bool is_complete() const { return m_sector.summary.is_complete; }

  //! the parts of operands, whose indices are 0 and 1, beside which the sector is not proved: it is not known whether
  //! their points are nearest to points of the sector, or which chain goes on there. Of an operand that is a point
  //! there are no ranges. If curves are not proved to be disjoint elsewhere, all of each curve.
  const std::vector<Undecided_part>& undecided() const { return m_sector.undecided; }

  //! the work; nodes are the ranges of curves and of normals in their ends that were looked at.
  const Summary& summary() const { return m_sector.summary; }

  /*!
  points along an arc, so many that it passes the middles of their chords at no more than a given distance.

  \param arc the index of the arc.
  \param error the distance; positive.
  \throws Invalid_input when there is no such arc, or the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t arc, double error) const
  {
    std::vector<Sample> result;
    for (const internal::Voronoi::Sector_sample& sample : internal::Voronoi::samples_of_arc(m_sector, arc, error))
      result.push_back(
          {internal::kernel_object<Kernel, Point>(sample.point), sample.distances, sample.parameters});
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTOR_2_H
