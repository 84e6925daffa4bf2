// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Region_boundaries_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/regions/internal/region_boundaries.h>
#endif

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRegions

A bounded region of the plane, of one or more parts, with or without holes, whose boundaries are made of B-spline
curves.

The curves may be given in any order and direction: each is a boundary by itself, if it is closed, or goes on in another
one, with exactly the same end point. They must not cross; that is proved. A point belongs to the region if an odd
number of boundaries go around it. Boundaries are simple, and in the direction that has the region on the left: outer
ones counterclockwise, those of holes clockwise.

Curves may touch themselves and each other, in points with rational parameters. There they are cut: two lobes that touch
in a point have two boundaries, and so have a region and a hole that touches its outer boundary. Pieces of curves that
are there twice, as where an outline leads to a hole and back on the same way, have the region on both sides, or on
none. They are no part of the boundaries. So are parts of pieces, as where one room has a part of a wall in common with
another one, if they begin and end at rational parameters, and both curves run through them at proportional speeds.

\tparam Kernel_ a `SplineKernel`.
*/
template <SplineKernel Kernel_>
class Planar_region_2
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_2;
  using Curve = Bspline_curve_2<Kernel>;

  using Arc = Planar_region_arc_2;
  using Boundary = Planar_region_boundary_2;

private:
  std::vector<Curve> m_curves;
  internal::Regions::Region_boundaries_2 m_region;

public:
  /*!
  the region between these curves.
  \param curves the curves.
  \param options limits, a visitor, and those of the solver that looks for common points. When a limit is reached, or
  the visitor stops the run, before it is proved that the region is valid, `is_complete()` is false: there is no
  region then, and what asks for its boundaries throws.
  \throws Invalid_input when there is no curve; a piece of a curve is a point; an odd number of ends of curves are the
  same point, as where no other one goes on; a curve crosses itself or another one, or is there twice; parts of pieces
  coincide other than as above; or it is not proved that none of this is so: where curves meet in a point that is not
  rational, or turn back in a cusp. The message names the curves and the parameters.
  */
  template <std::ranges::input_range Range>
    requires std::convertible_to<std::ranges::range_value_t<Range>, Bspline_curve_2<Kernel_>>
  explicit Planar_region_2(const Range& curves, const Solver_options& options = {})
    : m_curves(std::ranges::begin(curves), std::ranges::end(curves))
  {
    if (m_curves.empty())
      throw Invalid_input("Planar_region_2: there are no curves");
    std::vector<std::vector<internal::Regions::Boundary_piece>> pieces;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      pieces.push_back(internal::Regions::boundary_pieces(m_curves[i], i));
      for (const internal::Regions::Boundary_piece& piece : pieces.back())
        internal::Common::check_is_no_point(piece.coordinates, {piece.parameters[0], piece.parameters[1]}, i,
                                            "Planar_region_2: ");
    }
    m_region = internal::Regions::region_boundaries(std::move(pieces), options);
  }

  //! the curves, as they were given.
  const std::vector<Curve>& curves() const { return m_curves; }

  //! whether it is proved that this is a region. It is, unless a limit was reached or a visitor stopped the run.
  bool is_complete() const { return m_region.undecided.empty(); }

  //! a box around all curves, if the region is not complete.
  const std::vector<Undecided_part>& undecided() const { return m_region.undecided; }

  //! the work; nodes are those of the solver, and steps between two questions whether to go on.
  const Summary& summary() const { return m_region.summary; }

  //! the boundaries.
  //! \throws Invalid_input when the region is not complete, as all functions below do.
  const std::vector<Boundary>& boundaries() const { return complete().boundaries; }

  //! whether boundaries have vertices in common.
  bool has_touching_boundaries() const { return complete().have_common_vertices; }

  //! the number of boundaries of holes.
  std::size_t number_of_holes() const
  {
    return std::count_if(boundaries().begin(), boundaries().end(),
                         [](const Boundary& boundary) { return boundary.is_hole; });
  }

  //! where a point is; decided exactly.
  CGAL::Bounded_side bounded_side(const Point& point) const
  {
    return bounded_side(internal::Exact_pair{internal::converted_number<Exact_rational>(point.x()),
                                             internal::converted_number<Exact_rational>(point.y())});
  }

#ifndef DOXYGEN_RUNNING
  CGAL::Bounded_side bounded_side(const internal::Exact_pair& p) const
  {
    return internal::Regions::bounded_side(loops(), p);
  }
#endif

  /*!
  bounds of the area; the same number twice where all curves are polynomial.
  \param error the bounds differ by twice this number at most; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::pair<Exact_rational, Exact_rational> area(double error = 1e-12) const
  {
    internal::check_error(error, "Planar_region_2");
    const Exact_rational part(to_rational(error) / Exact_rational(static_cast<int>(loops().size())));
    internal::Common::Rational_interval result(Exact_rational(0), Exact_rational(0));
    for (const internal::Regions::Boundary_loop_2& loop : loops())
      result = result + loop.signed_area(part);
    return {result.lower, result.upper};
  }

  /*!
  the region as polygons, one for each part, with chords of the curves as edges: if the error is small enough for these
  not to meet elsewhere, the polygons are simple. Ends of polynomial pieces are corners of the polygons.
  \param error the distance of curves from their chords, at most, up to rounding of the corners; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons_with_holes(double error) const
  {
    internal::check_error(error, "Planar_region_2");
    return internal::Regions::polygons_of_parts<CGAL::Polygon_with_holes_2<Kernel>>(boundaries(), [&](std::size_t b) {
      CGAL::Polygon_2<Kernel> polygon;
      for (const internal::Regions::Boundary_piece& piece : loops()[b].pieces()) {
        polygon.push_back(internal::kernel_object<Kernel, Point>(piece.at(0)));
        for (const std::array<double, 2>& corner : piece.inner_corners(error))
          polygon.push_back(internal::kernel_object<Kernel, Point>(corner));
      }
      return polygon;
    });
  }

  //! puts these polygons to an output iterator.
  template <std::output_iterator<CGAL::Polygon_with_holes_2<Kernel>> OutputIterator>
  OutputIterator polygons_with_holes(double error, OutputIterator out) const
  {
    return std::ranges::copy(polygons_with_holes(error), out).out;
  }

#ifndef DOXYGEN_RUNNING
  // The boundaries in pieces, and the arcs of each curve in its direction, for the package.
  const std::vector<internal::Regions::Boundary_loop_2>& loops() const { return complete().loops; }
  const std::vector<std::vector<Arc>>& arcs_of_curves() const { return complete().arcs_of_curves; }
#endif

private:
  const internal::Regions::Region_boundaries_2& complete() const
  {
    if (!is_complete())
      throw Invalid_input("Planar_region_2: the region is not decided (" + m_region.undecided.front().reason + ')');
    return m_region;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_2_H
