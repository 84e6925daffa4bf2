// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_APPROXIMATE_POLYGON_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_APPROXIMATE_POLYGON_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Edge_strip_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Signature_location.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Banded_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/polygons_of_bands.h>
#endif

#include <CGAL/Polygon_2.h>
#include <CGAL/Uncertain.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDApproximatePolygons

A polygon whose edges are known up to bands: all polygons that have one edge in each band, from end to end of it. These
are its models. The line of an edge is any one that passes through both ends of its band; all of these lines together,
one for each band, bound a simple polygon. See `approximate_polygon()` for how to make one, `locate()` for what it
answers, and `signature_cells()` for all answers.

The <em>signature</em> of a point is a letter for each edge, in the order of the edges: `R` if the point is on the side
of the interior of the line of this edge, `L` if it is on the other one. (For a clockwise polygon that is the right and
the left side.) A point on one of the lines has none.

What a model is, and that a signature decides whether a point is inside, needs that the ends of a band do not overlap,
and that bands that are no neighbours have no point in common. Else there is an exception that names the edges.

All numbers are exact. Source: \cgalCite{s-rplap-91}.
*/
class Approximate_polygon_2
{
public:
  using Number = Exact_rational;           //!< coordinates.
  using Kernel = internal::Exact_kernel;   //!< `Simple_cartesian<Number>`.
  using Point = Kernel::Point_2;           //!< a point.
  using Polygon = CGAL::Polygon_2<Kernel>; //!< a polygon.

private:
  internal::Approximate_polygons::Banded_polygon_2 m_banded;

public:
  /*!
  \param polygon one of the models, in any orientation.
  \param strips that of each edge, from `polygon.vertex(i)` to the next one. They have these edges in them.
  \throws Invalid_input if there are less than three vertices, edges that follow each other are parallel, a strip has no
  interior or not its edge in it, the corners at both ends of a band overlap, or bands that are no neighbours meet. It
  names the edges.

  Complexity: \f$O(n^2)\f$.
  */
  Approximate_polygon_2(Polygon polygon, const std::vector<Edge_strip_2>& strips)
    : m_banded(internal::Approximate_polygons::banded_polygon(std::move(polygon), strips))
  {}

  //! number of edges.
  std::size_t size() const { return m_banded.size(); }

  //! the model that it was made from.
  const Polygon& polygon() const { return m_banded.polygon; }

  //! the band of an edge: inner corners at the tail and the head, outer corners at the head and the tail.
  Polygon band(std::size_t edge) const
  {
    const auto corners = m_banded.bands[edge].corners();
    return Polygon(corners.begin(), corners.end());
  }

  //! whether the interior angle between an edge and the one before it is more than a straight one, in all models.
  bool is_reflex(std::size_t edge) const { return m_banded.is_reflex[edge]; }

  //! whether a polygon is a model: with its edges in the same order and orientation, each through both ends of its
  //! band.
  bool is_model(const Polygon& polygon) const { return internal::Approximate_polygons::is_model_of(m_banded, polygon); }

  //! the model whose line of edge \f$i\f$ divides the tail of its band, and the head, in these ratios: 0 is the inner
  //! corner, 1 the outer one.
  //! \throws Invalid_input if the number of pairs is not that of the edges, or a ratio is not between 0 and 1.
  Polygon model(const std::vector<std::pair<Number, Number>>& ratios) const
  {
    return internal::Approximate_polygons::model_of(m_banded, ratios);
  }

  //! the signature of a point in a model, or nothing where it is on the line of an edge.
  //! \throws Invalid_input if the polygon is no model.
  std::optional<std::string> signature(const Polygon& model, const Point& point) const
  {
    return internal::Approximate_polygons::signature_in(m_banded, model, point);
  }

  //! whether a point is inside in all models, or in none; uncertain in the bands.
  //! \throws Invalid_input if a coordinate is not finite.
  template <SplineKernel PointKernel>
  CGAL::Uncertain<bool> is_inside(const CGAL::Point_2<PointKernel>& point) const
  {
    return internal::Approximate_polygons::is_inside_of(m_banded, internal::exact_object(point));
  }

  //! on which side a point is, on which side of each edge it is being all that is known of it: neither where the point
  //! is, nor where the edges are.
  //! \throws Invalid_input if the signature has another length than the polygon has edges, or other letters than `L`
  //! and `R`.
  //!
  //! Complexity: \f$O(n^2)\f$ parts of the plane at most, each cut by \f$O(n)\f$ lines.
  Signature_location locate(const std::string& signature) const
  {
    return internal::Approximate_polygons::location_of(m_banded, signature);
  }

  /// \cond
  const internal::Approximate_polygons::Banded_polygon_2& banded() const { return m_banded; }
  /// \endcond
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_APPROXIMATE_POLYGON_2_H
