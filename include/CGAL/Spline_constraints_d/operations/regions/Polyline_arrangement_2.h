// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_POLYLINE_ARRANGEMENT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_POLYLINE_ARRANGEMENT_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRegions

What an edge of an arrangement belongs to: chord `chord` of polyline `curve`, from its point `chord` to the next one.
The parameters there are those of the samples that the polyline was made of.
*/
struct Chord_label
{
  std::size_t curve; ///< index of the polyline
  std::size_t chord; ///< index of its point where the chord begins

  bool operator==(const Chord_label&) const = default;
};

namespace internal {
namespace Regions {

using Chord_segment_traits_2 = CGAL::Arr_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
using Chord_traits_2 = CGAL::Arr_consolidated_curve_data_traits_2<Chord_segment_traits_2, Chord_label>;

} // namespace Regions
} // namespace internal

//! \ingroup PkgSplineConstraintsDRegions
//! an exact arrangement of chords; `edge->curve().data()` lists the labels of an edge, several where chords overlap.
using Polyline_arrangement_2 = CGAL::Arrangement_2<internal::Regions::Chord_traits_2>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_POLYLINE_ARRANGEMENT_2_H
