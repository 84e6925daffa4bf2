// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_APPROXIMATE_POLYGONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_APPROXIMATE_POLYGONS_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Approximate_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Signature_cells_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/strips_of_edges.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/cells_of_signatures.h>
#endif

#include <CGAL/Polygon_2.h>

#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDApproximatePolygons
/// @{

/*!
the polygon whose edges are known up to a distance of their own.

\tparam Range a range of numbers of the kernel.
\param polygon the polygon, in any orientation.
\param half_widths for each edge the distance to both sides up to which its line is in its band. Where the length of an
edge is irrational, the band is wider, by a factor of less than \f$1 + 2^{-40}\f$.
\throws Invalid_input when a coordinate is not finite, there is not one half width for each edge, or one is not
positive; and as the constructor of `Approximate_polygon_2`.

Complexity: \f$O(n^2)\f$. Source: \cgalCite{s-rplap-91}.
*/
template <SplineKernel Kernel, std::ranges::input_range Range>
Approximate_polygon_2 approximate_polygon(const CGAL::Polygon_2<Kernel>& polygon, const Range& half_widths)
{
  const auto exact = internal::Approximate_polygons::exact_polygon(polygon);
  std::vector<Exact_rational> widths;
  for (const auto& width : half_widths)
    widths.push_back(internal::converted_number<Exact_rational>(typename Kernel::FT(width)));
  return {exact, internal::Approximate_polygons::strips_of_width(exact, widths)};
}

//! the polygon whose edges are all known up to one distance.
//! \throws Invalid_input as above.
template <SplineKernel Kernel>
Approximate_polygon_2 approximate_polygon(const CGAL::Polygon_2<Kernel>& polygon, const typename Kernel::FT& half_width)
{
  return approximate_polygon(polygon, std::vector<typename Kernel::FT>(polygon.size(), half_width));
}

//! the polygon between two others: the band of an edge is bounded by the lines of this edge in both, which are
//! parallel.
//! \throws Invalid_input when the numbers of edges differ, or edges of the same number are not parallel; and as the
//! constructor of `Approximate_polygon_2`, for the outer polygon.
template <SplineKernel Kernel>
Approximate_polygon_2 approximate_polygon_between(const CGAL::Polygon_2<Kernel>& inner,
                                                  const CGAL::Polygon_2<Kernel>& outer)
{
  const auto exact = internal::Approximate_polygons::exact_polygon(outer);
  return {exact,
          internal::Approximate_polygons::strips_between(internal::Approximate_polygons::exact_polygon(inner), exact)};
}

/*!
all signatures that points have in models of an approximate polygon, with the points that have them, and whether these
are inside. A signature that is missing is impossible: no model has a point on these sides of its edges.

The plane is cut into convex parts by the lines of each band in turn. In a part, each edge has one side, or both in
different models, as its line can be chosen independently of all others.

\param polygon the polygon.
\param options those of the solver; limits hold for the operation as a whole. Nodes are parts of the plane, each time
that they are cut or get a signature.
\throws Invalid_input when an option makes no sense.

Complexity: \f$O(n^2)\f$ parts, each cut by \f$O(n)\f$ lines; where the lines of \f$k\f$ bands pass through a part, it
has \f$2^k\f$ signatures. Source: \cgalCite{s-rplap-91}, Lemmas 1 and 2 and Theorem 1.
*/
inline Signature_cells_2 signature_cells(const Approximate_polygon_2& polygon, const Solver_options& options = {})
{
  return internal::Approximate_polygons::cells_of_signatures(polygon.banded(), options);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_APPROXIMATE_POLYGONS_2_H
