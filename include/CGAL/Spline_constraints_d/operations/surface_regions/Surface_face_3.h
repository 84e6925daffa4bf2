// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_FACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_FACE_3_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

A part of a surface over a box of parameters where it is one rational function of them.
*/
struct Surface_cell_3
{
  //! a range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! \f$x,y,z\f$ and the weight.
  using Coordinates = std::array<Bernstein_tensor<Exact_rational>, 4>;

  std::array<Range, 2> domain; ///< the ranges of both parameters
  Coordinates coordinates;     ///< on the unit box, which is mapped onto the domain

  //! a parameter of an axis, from the unit range.
  Exact_rational parameter(int axis, const Exact_rational& local) const
  {
    const auto& [begin, end] = domain[axis];
    return Exact_rational(begin + (end - begin) * local);
  }

  //! the place of a parameter of an axis in the unit range.
  Exact_rational local_parameter(int axis, const Exact_rational& parameter) const
  {
    const auto& [begin, end] = domain[axis];
    return Exact_rational((parameter - begin) / (end - begin));
  }

  //! whether the parameters are in the domain.
  bool contains(const Exact_rational& u, const Exact_rational& v) const
  {
    return domain[0].first <= u && u <= domain[0].second && domain[1].first <= v && v <= domain[1].second;
  }
};

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

A chord of the boundary of a face. Of a chord that stands for an arc of a curve, the two ends are points of it up to
rounding; on the border of a cell, chord and arc are the same.
*/
struct Surface_face_edge_3
{
  //! the point of parameters where it begins; the next edge of the loop begins where it ends.
  CGAL::Simple_cartesian<Exact_rational>::Point_2 source;

  //! the index of the face on the other side in the same cell; none on the border of the cell.
  std::optional<std::size_t> neighbour;
};

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

A face of the arrangement that curves cut a cell of a surface into: a connected, open set of parameters, without a point
of the curves in it.
*/
struct Surface_face_3
{
  //! the index of the cell.
  std::size_t cell;

  //! parameters of a point inside of the face that is bounded by the curves themselves, by proof; exact.
  std::array<Exact_rational, 2> sample;

  //! the boundary: the outer loop counterclockwise, in the plane of parameters, behind it those of holes, clockwise.
  //! Loops of different faces do not cross.
  std::vector<std::vector<Surface_face_edge_3>> loops;

  //! what holds on the whole face, as decided at its sample; none if it is undecided.
  std::optional<int> label = {};

  //! the index of the region that it belongs to.
  std::size_t region = 0;
};

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

A part of the border of a cell that belongs to one face: between two neighbouring points where curves meet this side of
the cell, or corners.
*/
struct Surface_border_3
{
  std::size_t face;            ///< the index of the face
  int axis;                    ///< the axis whose parameter is constant
  int side;                    ///< 0 at the lower end of the cell, 1 at the upper one
  Surface_cell_3::Range range; ///< numbers that are certainly between the two points, with ends next to them
};

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

Faces with the same label that are connected through arcs, or across borders of cells and seams.
*/
struct Surface_region_3
{
  std::optional<int> label;       ///< the label of the faces
  std::vector<std::size_t> faces; ///< their indices
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_FACE_3_H
