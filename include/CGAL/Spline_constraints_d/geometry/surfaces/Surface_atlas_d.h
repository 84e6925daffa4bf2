// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACE_ATLAS_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACE_ATLAS_D_H

#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The kernel's point with the first three of some coordinates.
template <class Kernel>
CGAL::Point_3<Kernel> fitted_point(const std::vector<double>& coordinates)
{
  return kernel_object<Kernel, CGAL::Point_3<Kernel>>(
      std::array<double, 3>{coordinates[0], coordinates[1], coordinates[2]});
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

A B-spline curve over \f$[0,1]\f$, in space or in a space of any dimension, between charts of a `Surface_atlas_d`.
*/
struct Fitted_edge_d
{
  int degree; ///< of the polynomials

  //! the clamped knots from 0 to 1.
  std::vector<double> knots;

  //! the control points, see `Fitted_surface_d::control_points`.
  std::vector<std::vector<double>> control_points;

  //! indices of the vertices of the atlas at its ends.
  std::array<std::size_t, 2> ends;

  //! indices of the charts beside it: one where the surface ends, two elsewhere.
  std::vector<std::size_t> charts;

  //! measured: the distance from the surface, or the curve that bounds it, as `Surface_atlas_d::error`.
  double error;

  //! the curve in space. \throws Invalid_input when points have less than three coordinates.
  template <SplineKernel Kernel>
  Bspline_curve_3<Kernel> curve_3() const
  {
    std::vector<CGAL::Point_3<Kernel>> points;
    for (const std::vector<double>& p : control_points)
      points.push_back(internal::fitted_point<Kernel>(p));
    return Bspline_curve_3<Kernel>(degree, std::vector<typename Kernel::FT>(knots.begin(), knots.end()), points);
  }
};

/*!
\ingroup PkgSplineConstraintsDGeometry

A tensor-product B-spline surface over \f$[0,1]^2\f$ near a disk on a surface: a chart of a `Surface_atlas_d`.
*/
struct Fitted_surface_d
{
  //! An edge of the atlas on the boundary of the square.
  struct Side
  {
    std::size_t edge;                                ///< its index
    bool is_reversed;                                ///< whether its parameter decreases along the boundary
    std::array<std::array<double, 2>, 2> parameters; ///< the ends of the line over which it lies, as it begins and ends
  };

  std::size_t surface; ///< index of the surface of solutions that it is near
  int degree;          ///< in both parameters

  //! the clamped knots from 0 to 1. Where edges of the atlas meet inside of a side of the square, the knot has the
  //! multiplicity of the degree.
  std::array<std::vector<double>, 2> knots;

  //! the control points, those with the same place along the first parameter one after another. The coordinates are
  //! those in space, if there is a map to space, and all unknowns, those of inequalities at the end.
  std::vector<std::vector<double>> control_points;

  //! the boundary: counterclockwise around the square, from its corner (0, 0).
  std::vector<Side> boundary;

  //! measured, see `Surface_atlas_d::error`.
  double error;

  //! whether the surface has the same orientation at all points that were compared. It need not have beside a corner
  //! of the square where the boundary of the chart is smooth.
  bool is_regular;

  //! number of polynomial pieces.
  std::size_t number_of_pieces() const
  {
    return (internal::breaks_of(axis(0)).size() - 1) * (internal::breaks_of(axis(1)).size() - 1);
  }

  //! the point at parameters between 0 and 1.
  std::vector<double> operator()(double u, double v) const
  {
    const std::array<internal::Knot_axis<double>, 2> axes{axis(0), axis(1)};
    const std::array<double, 2> place{u, v};
    std::array<std::size_t, 2> span;
    std::array<std::vector<double>, 2> weights;
    for (std::size_t i = 0; i < 2; ++i) {
      span[i] = internal::span_of(axes[i], place[i]);
      weights[i] = internal::derivative_weights(axes[i], span[i], place[i], 0);
      span[i] -= static_cast<std::size_t>(degree);
    }
    std::vector<double> result(control_points.front().size(), 0);
    for (std::size_t i = 0; i < weights[0].size(); ++i)
      for (std::size_t j = 0; j < weights[1].size(); ++j)
        for (std::size_t k = 0; k < result.size(); ++k)
          result[k] += weights[0][i] * weights[1][j] * control_points[(span[0] + i) * axes[1].size() + span[1] + j][k];
    return result;
  }

  //! the surface in space, of the first three coordinates. \throws Invalid_input when there are less.
  template <SplineKernel Kernel>
  Bspline_surface_3<Kernel> surface_3() const
  {
    using FT = typename Kernel::FT;
    std::vector<CGAL::Point_3<Kernel>> points;
    for (const std::vector<double>& p : control_points)
      points.push_back(internal::fitted_point<Kernel>(p));
    return Bspline_surface_3<Kernel>({degree, degree}, std::vector<FT>(knots[0].begin(), knots[0].end()),
                                     std::vector<FT>(knots[1].begin(), knots[1].end()), points);
  }

  //! the boundary in the plane of the parameters: for each of its sides a line over \f$[0,1]\f$, with the parameters of
  //! the edge.
  template <SplineKernel Kernel>
  std::vector<Bspline_curve_2<Kernel>> trimming_curves_2() const
  {
    using FT = typename Kernel::FT;
    std::vector<Bspline_curve_2<Kernel>> result;
    for (const Side& side : boundary) {
      std::vector<CGAL::Point_2<Kernel>> ends;
      for (const std::array<double, 2>& p : side.parameters)
        ends.push_back(internal::kernel_object<Kernel, CGAL::Point_2<Kernel>>(p));
      result.emplace_back(1, std::vector<FT>{FT(0), FT(0), FT(1), FT(1)}, ends);
    }
    return result;
  }

private:
  internal::Knot_axis<double> axis(std::size_t i) const { return {degree, knots[i]}; }
};

/*!
\ingroup PkgSplineConstraintsDGeometry

B-spline surfaces near all surfaces of solutions, see `fit_bspline_surfaces()`: charts, which are disks, and meet in
common edges and vertices.
*/
struct Surface_atlas_d
{
  std::vector<Fitted_surface_d> charts;      ///< the surfaces
  std::vector<Fitted_edge_d> edges;          ///< curves on the boundaries of charts
  std::vector<std::vector<double>> vertices; ///< ends of edges, with the coordinates of control points

  /*!
  the largest distance that was measured between a point of a chart, or an edge, and a point of the true surface, found
  from it by Newton's method; so it bounds the distance from one to the other both ways, at these points. It is a
  measurement, no proof: nothing is known between the points.
  */
  double error = 0;

  //! how many points of charts were compared with the surface although they had no part in the fit.
  std::size_t test_points = 0;

  std::vector<Undecided_part> undecided_parts = {}; ///< see `undecided()`

  //! whether all surfaces are covered, and were found near enough.
  bool is_complete() const { return undecided_parts.empty(); }

  //! what is undecided of the surfaces, and charts that were not fitted, or are farther away than the tolerance.
  const std::vector<Undecided_part>& undecided() const { return undecided_parts; }

  //! vertices less edges plus charts; that of the surfaces if all are covered. `surface`: of one surface of solutions.
  int euler_characteristic(std::optional<std::size_t> surface = std::nullopt) const
  {
    int result = 0;
    std::vector<bool> is_counted(vertices.size(), false);
    const auto is_asked = [&](std::size_t chart) { return !surface || charts[chart].surface == *surface; };
    for (std::size_t chart = 0; chart < charts.size(); ++chart)
      result += is_asked(chart) ? 1 : 0;
    for (const Fitted_edge_d& edge : edges)
      if (!edge.charts.empty() && is_asked(edge.charts.front())) {
        --result;
        for (const std::size_t end : edge.ends)
          if (!is_counted[end]) {
            is_counted[end] = true;
            ++result;
          }
      }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACE_ATLAS_D_H
