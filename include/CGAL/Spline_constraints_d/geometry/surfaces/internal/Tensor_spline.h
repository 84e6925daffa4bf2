// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_TENSOR_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_TENSOR_SPLINE_H

#include <CGAL/Spline_constraints_d/function/knot_vector.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Spline_axis = Knot_axis<double>;
using Spline_breaks = std::vector<Break<double>>;

// The values of all basis functions, or their derivatives of an order, at parameters: a row for each of these.
inline Eigen::MatrixXd basis_matrix(const Spline_axis& axis, const std::vector<double>& parameters, int order = 0)
{
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(parameters.size()), static_cast<Eigen::Index>(axis.size()));
  for (std::size_t r = 0; r < parameters.size(); ++r) {
    const std::size_t span = span_of(axis, parameters[r]);
    const std::vector<double> weights = derivative_weights(axis, span, parameters[r], order);
    for (std::size_t i = 0; i < weights.size(); ++i)
      result(static_cast<Eigen::Index>(r),
             static_cast<Eigen::Index>(span - static_cast<std::size_t>(axis.degree) + i)) = weights[i];
  }
  return result;
}

// Breaks from 0 to 1 that divide the interval evenly.
inline Spline_breaks even_breaks(std::size_t spans)
{
  Spline_breaks result;
  for (std::size_t i = 0; i <= spans; ++i)
    result.push_back({static_cast<double>(i) / static_cast<double>(spans), 1});
  return result;
}

// Halves the marked spans.
inline Spline_breaks with_halved_spans(const Spline_breaks& breaks, const std::vector<bool>& is_marked)
{
  Spline_breaks result;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    result.push_back(breaks[i]);
    if (is_marked[i])
      result.push_back({0.5 * (breaks[i].value + breaks[i + 1].value), 1});
  }
  result.push_back(breaks.back());
  return result;
}

// The breaks of both, with the greater multiplicity.
inline Spline_breaks common_breaks(const Spline_breaks& a, const Spline_breaks& b, int degree)
{
  return common_breaks(degree, clamped(degree, a), clamped(degree, b));
}

/*
Parameters in all spans of an axis: in each of them as many are fitted as polynomials of the degree have coefficients;
the others, between these and beside the ends, are only compared.
*/
struct Sample_parameters
{
  std::vector<double> all, fitted;
  std::size_t per_span; // of all

  Sample_parameters(const Spline_breaks& breaks, int degree) : per_span(2 * static_cast<std::size_t>(degree) + 3)
  {
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      for (std::size_t k = 0; k < per_span; ++k) {
        const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(per_span);
        all.push_back(breaks[i].value + t * (breaks[i + 1].value - breaks[i].value));
        if (is_fitted(k))
          fitted.push_back(all.back());
      }
  }

  bool is_fitted(std::size_t index) const { return index % per_span % 2 == 1; }
  std::size_t span(std::size_t index) const { return index / per_span; }

  // The rows of these parameters that are fitted.
  Eigen::MatrixXd fitted_rows(const Eigen::MatrixXd& rows) const
  {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(fitted.size()), rows.cols());
    for (std::size_t k = 0, to = 0; k < all.size(); ++k)
      if (is_fitted(k))
        result.row(static_cast<Eigen::Index>(to++)) = rows.row(static_cast<Eigen::Index>(k));
    return result;
  }
};

// A curve: each column has one coordinate of the control points.
struct Spline_curve
{
  Spline_axis axis;
  Eigen::MatrixXd control_points;

  Eigen::MatrixXd at(const std::vector<double>& parameters) const
  {
    return basis_matrix(axis, parameters) * control_points;
  }
};

// The curve nearest to points, which are rows, whose first and last control points are given. With a smoothing factor,
// which is the weight of the integral of the squared second derivative, there may be fewer points than control points.
inline Spline_curve fitted_curve(const Spline_axis& axis, const std::vector<double>& parameters,
                                 const Eigen::MatrixXd& points, const std::array<Eigen::MatrixXd, 2>& ends,
                                 double smoothing = 0)
{
  Eigen::MatrixXd rows = basis_matrix(axis, parameters), right = points;
  if (smoothing > 0) {
    const Spline_breaks breaks = breaks_of(axis);
    const Sample_parameters samples(breaks, axis.degree);
    const double factor = std::sqrt(smoothing / static_cast<double>(samples.all.size()));
    const Eigen::MatrixXd bends = factor * basis_matrix(axis, samples.all, 2);
    rows.conservativeResize(rows.rows() + bends.rows(), Eigen::NoChange);
    rows.bottomRows(bends.rows()) = bends;
    right.conservativeResize(rows.rows(), Eigen::NoChange);
    right.bottomRows(bends.rows()).setZero();
  }
  const Eigen::Index size = rows.cols(), first = ends[0].rows(), last = ends[1].rows(), free = size - first - last;
  Spline_curve result{axis, Eigen::MatrixXd(size, points.cols())};
  result.control_points.topRows(first) = ends[0];
  result.control_points.bottomRows(last) = ends[1];
  if (free > 0) {
    right -= rows.leftCols(first) * ends[0] + rows.rightCols(last) * ends[1];
    result.control_points.middleRows(first, free) = rows.middleCols(first, free).householderQr().solve(right);
  }
  return result;
}

// Values on a grid of parameters, for each coordinate.
using Grid = std::vector<Eigen::MatrixXd>;

// A surface: a matrix for each coordinate of the control points.
struct Tensor_spline
{
  std::array<Spline_axis, 2> axes;
  Grid control_points;

  std::size_t coordinates() const { return control_points.size(); }

  // On the grid of parameters.
  Grid at(const std::vector<double>& u, const std::vector<double>& v) const
  {
    const Eigen::MatrixXd rows = basis_matrix(axes[0], u), columns = basis_matrix(axes[1], v).transpose();
    Grid result;
    for (const Eigen::MatrixXd& own : control_points)
      result.push_back(rows * own * columns);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_TENSOR_SPLINE_H
