// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_TRIMMED_BISECTOR_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_TRIMMED_BISECTOR_3_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_part_label.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

A rational bisector within a sphere, and which of its regions have the foot on the surface as the nearest point of it.
*/
class Trimmed_bisector_3
{
  Rational_bisector_3 m_bisector;
  std::vector<Trimmed_surface_3> m_surfaces;
  Summary m_summary;

public:
  //! what an operation has found.
  Trimmed_bisector_3(Rational_bisector_3 bisector, std::vector<Trimmed_surface_3> surfaces);

  //! the bisector, untrimmed.
  const Rational_bisector_3& bisector() const { return m_bisector; }

  //! its regions, labelled `OUT_OF_REACH`, `NEAREST` or `NOT_NEAREST`; one surface for each part that is continuous.
  const std::vector<Trimmed_surface_3>& surfaces() const { return m_surfaces; }

  //! the number of regions with a label.
  std::size_t number_of_regions(int label) const;

  //! whether all regions have a label, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the regions without a label, with boxes of parameters: beside places where two feet come together, as a rule.
  std::vector<Undecided_part> undecided() const;

  //! the work.
  const Summary& summary() const { return m_summary; }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_bisector_3::Trimmed_bisector_3(Rational_bisector_3 bisector,
                                                                      std::vector<Trimmed_surface_3> surfaces)
  : m_bisector(std::move(bisector)), m_surfaces(std::move(surfaces)), m_summary(m_bisector.summary())
{
  // the work of one surface has that of those before it
  if (!m_surfaces.empty())
    m_summary += m_surfaces.back().summary();
  for (const Trimmed_surface_3& surface : m_surfaces)
    m_summary.is_complete = m_summary.is_complete && surface.is_complete();
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t Trimmed_bisector_3::number_of_regions(int label) const
{
  std::size_t result = 0;
  for (const Trimmed_surface_3& surface : m_surfaces)
    result += surface.number_of_regions(label);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Undecided_part> Trimmed_bisector_3::undecided() const
{
  std::vector<Undecided_part> result = m_bisector.undecided();
  for (const Trimmed_surface_3& surface : m_surfaces)
    result.insert(result.end(), surface.undecided().begin(), surface.undecided().end());
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_TRIMMED_BISECTOR_3_H
