// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SPLINE_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SPLINE_SURFACES_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Tensor_spline.h>

#include <Eigen/Sparse>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Places in the unit square, and the points of a surface there, as rows.
struct Scattered_points
{
  std::vector<std::array<double, 2>> places;
  Eigen::MatrixXd points;
};

// The boundary of a surface: curves along u at v = 0 and v = 1, and along v at u = 0 and u = 1, with common corners.
struct Square_boundary
{
  std::array<Spline_curve, 2> along_u, along_v;
};

// The surface with this boundary whose other control points are zero.
inline Tensor_spline surface_with_boundary(const Square_boundary& boundary)
{
  Tensor_spline result{{boundary.along_u[0].axis, boundary.along_v[0].axis}, {}};
  const auto rows = static_cast<Eigen::Index>(result.axes[0].size()),
             columns = static_cast<Eigen::Index>(result.axes[1].size());
  for (Eigen::Index k = 0; k < boundary.along_u[0].control_points.cols(); ++k) {
    Eigen::MatrixXd& own = result.control_points.emplace_back(Eigen::MatrixXd::Zero(rows, columns));
    own.col(0) = boundary.along_u[0].control_points.col(k);
    own.col(columns - 1) = boundary.along_u[1].control_points.col(k);
    own.row(0) = boundary.along_v[0].control_points.col(k).transpose();
    own.row(rows - 1) = boundary.along_v[1].control_points.col(k).transpose();
  }
  return result;
}

// The points of a surface over a grid of parameters after it has been moved to another boundary with the same corners:
// by the Coons patch of the differences of both.
inline Grid points_with_boundary(const Tensor_spline& surface, const Square_boundary& boundary,
                                 const std::vector<double>& u, const std::vector<double>& v)
{
  Grid result = surface.at(u, v);
  const Grid along_u = surface.at(u, {0, 1}), along_v = surface.at({0, 1}, v);
  const std::array<Eigen::MatrixXd, 2> new_along_u{boundary.along_u[0].at(u), boundary.along_u[1].at(u)},
      new_along_v{boundary.along_v[0].at(v), boundary.along_v[1].at(v)};
  for (std::size_t k = 0; k < result.size(); ++k) {
    const auto coordinate = static_cast<Eigen::Index>(k);
    for (Eigen::Index i = 0; i < result[k].rows(); ++i)
      for (Eigen::Index j = 0; j < result[k].cols(); ++j)
        for (const Eigen::Index side : {0, 1}) {
          const auto s = static_cast<std::size_t>(side);
          const double at_u = u[static_cast<std::size_t>(i)], at_v = v[static_cast<std::size_t>(j)];
          result[k](i, j) += (side == 0 ? 1 - at_v : at_v) * (new_along_u[s](i, coordinate) - along_u[k](i, side)) +
              (side == 0 ? 1 - at_u : at_u) * (new_along_v[s](j, coordinate) - along_v[k](side, j));
        }
  }
  return result;
}

// Integrals over the axis of products of two basis functions, or of their derivatives of an order, by a sum.
inline Eigen::MatrixXd gram_matrix(const Spline_axis& axis, int order)
{
  const Spline_breaks breaks = breaks_of(axis);
  const Sample_parameters samples(breaks, axis.degree);
  Eigen::MatrixXd rows = basis_matrix(axis, samples.all, order);
  for (std::size_t k = 0; k < samples.all.size(); ++k) {
    const std::size_t span = samples.span(k);
    rows.row(static_cast<Eigen::Index>(k)) *=
        std::sqrt((breaks[span + 1].value - breaks[span].value) / static_cast<double>(samples.per_span));
  }
  return rows.transpose() * rows;
}

/*
The smoothest surface with a boundary near some points: it has the least sum of a bending energy, the integral of
|S_uu|^2 + |S_vv|^2, and the mean of the squared distances from the points times a weight. Without weight and with
straight sides it is bilinear.
*/
class Smooth_surface
{
  Tensor_spline m_boundary;
  Eigen::Index m_rows, m_columns;
  Eigen::SparseMatrix<double> m_energy, m_distances; // of the inner control points
  Eigen::MatrixXd m_energy_right, m_distances_right;

public:
  Smooth_surface(const Square_boundary& boundary, const Scattered_points& data)
    : m_boundary(surface_with_boundary(boundary)), m_rows(m_boundary.control_points[0].rows()),
      m_columns(m_boundary.control_points[0].cols())
  {
    const std::array<Eigen::MatrixXd, 2> values{gram_matrix(m_boundary.axes[0], 0), gram_matrix(m_boundary.axes[1], 0)},
        bends{gram_matrix(m_boundary.axes[0], 2), gram_matrix(m_boundary.axes[1], 2)};
    std::vector<Entry> entries;
    const Eigen::Index degree = m_boundary.axes[0].degree;
    for (Eigen::Index i = 0; i < m_rows; ++i)
      for (Eigen::Index j = 0; j < m_columns; ++j)
        for (Eigen::Index k = (std::max)(Eigen::Index(0), i - degree); k <= (std::min)(m_rows - 1, i + degree); ++k)
          for (Eigen::Index l = (std::max)(Eigen::Index(0), j - degree); l <= (std::min)(m_columns - 1, j + degree);
               ++l)
            entries.push_back({i, j, k, l, bends[0](i, k) * values[1](j, l) + values[0](i, k) * bends[1](j, l)});
    set_equations(entries, m_energy, m_energy_right);
    set_distances(data);
  }

  Tensor_spline operator()(double weight) const
  {
    Tensor_spline result = m_boundary;
    if (m_energy.rows() == 0)
      return result;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(m_energy + weight * m_distances);
    const Eigen::MatrixXd solution = factors.solve(m_energy_right + weight * m_distances_right);
    for (Eigen::Index k = 0; k < solution.cols(); ++k)
      for (Eigen::Index i = 1; i + 1 < m_rows; ++i)
        for (Eigen::Index j = 1; j + 1 < m_columns; ++j)
          result.control_points[static_cast<std::size_t>(k)](i, j) = solution(inner_index(i, j), k);
    return result;
  }

private:
  // Of the matrix of a quadratic form: those of control points (i, j) and (k, l).
  struct Entry
  {
    Eigen::Index i, j, k, l;
    double value;
  };

  bool is_inside(Eigen::Index i, Eigen::Index j) const { return 0 < i && i + 1 < m_rows && 0 < j && j + 1 < m_columns; }
  Eigen::Index inner_index(Eigen::Index i, Eigen::Index j) const { return (i - 1) * (m_columns - 2) + j - 1; }

  // The equations of inner control points; what those of the boundary make of them goes to the right.
  void set_equations(const std::vector<Entry>& entries, Eigen::SparseMatrix<double>& matrix,
                     Eigen::MatrixXd& right) const
  {
    const Eigen::Index size = (m_rows - 2) * (m_columns - 2);
    std::vector<Eigen::Triplet<double>> triplets;
    right = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(m_boundary.coordinates()));
    for (const Entry& entry : entries)
      if (is_inside(entry.i, entry.j)) {
        const Eigen::Index row = inner_index(entry.i, entry.j);
        if (is_inside(entry.k, entry.l))
          triplets.emplace_back(row, inner_index(entry.k, entry.l), entry.value);
        else
          for (std::size_t c = 0; c < m_boundary.coordinates(); ++c)
            right(row, static_cast<Eigen::Index>(c)) -= entry.value * m_boundary.control_points[c](entry.k, entry.l);
      }
    matrix.resize(size, size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
  }

  void set_distances(const Scattered_points& data)
  {
    std::vector<Entry> entries;
    const double share = 1 / static_cast<double>((std::max)(std::size_t(1), data.places.size()));
    std::vector<std::array<Eigen::Index, 2>> first;
    std::vector<std::array<std::vector<double>, 2>> weights;
    for (const std::array<double, 2>& place : data.places) {
      first.emplace_back();
      weights.emplace_back();
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t span = span_of(m_boundary.axes[axis], place[axis]);
        weights.back()[axis] = derivative_weights(m_boundary.axes[axis], span, place[axis], 0);
        first.back()[axis] = static_cast<Eigen::Index>(span) - m_boundary.axes[axis].degree;
      }
      const auto order = static_cast<Eigen::Index>(weights.back()[0].size());
      const auto& [of_u, of_v] = weights.back();
      for (Eigen::Index a = 0; a < order * order * order * order; ++a) {
        const Eigen::Index i = a % order, j = a / order % order, k = a / order / order % order,
                           l = a / order / order / order;
        entries.push_back({first.back()[0] + i, first.back()[1] + j, first.back()[0] + k, first.back()[1] + l,
                           share * of_u[static_cast<std::size_t>(i)] * of_v[static_cast<std::size_t>(j)] *
                               of_u[static_cast<std::size_t>(k)] * of_v[static_cast<std::size_t>(l)]});
      }
    }
    set_equations(entries, m_distances, m_distances_right);
    for (std::size_t p = 0; p < data.places.size(); ++p)
      for (std::size_t i = 0; i < weights[p][0].size(); ++i)
        for (std::size_t j = 0; j < weights[p][1].size(); ++j)
          if (const Eigen::Index row = first[p][0] + static_cast<Eigen::Index>(i),
              column = first[p][1] + static_cast<Eigen::Index>(j);
              is_inside(row, column))
            m_distances_right.row(inner_index(row, column)) +=
                share * weights[p][0][i] * weights[p][1][j] * data.points.row(static_cast<Eigen::Index>(p));
  }
};

/*
The surface with a boundary that is nearest to points over a grid of parameters, of which those are fitted that have a
part in it along both axes; and how much of what is left, at all of them, comes from each axis. The grid makes the
least squares a product: one small system for each axis.
*/
struct Grid_fit
{
  Tensor_spline surface;
  Grid rest;                      // of the points, beyond the surface
  std::array<Grid, 2> along_axis; // beyond what is the nearest along one axis alone
};

inline Grid_fit fitted_surface(const Square_boundary& boundary, const std::array<Sample_parameters, 2>& samples,
                               const Grid& points)
{
  Grid_fit result{surface_with_boundary(boundary), {}, {}};
  const Grid of_boundary = result.surface.at(samples[0].all, samples[1].all);
  std::array<Eigen::MatrixXd, 2> rows, solver; // inner basis functions at all parameters, inverse at the fitted ones
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Eigen::MatrixXd all = basis_matrix(result.surface.axes[axis], samples[axis].all);
    rows[axis] = all.middleCols(1, all.cols() - 2);
    const Eigen::MatrixXd fitted = samples[axis].fitted_rows(rows[axis]);
    solver[axis] = fitted.householderQr().solve(Eigen::MatrixXd::Identity(fitted.rows(), fitted.rows()));
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::MatrixXd own = points[k] - of_boundary[k];
    const Eigen::MatrixXd fitted_u = samples[0].fitted_rows(own),
                          fitted_v = samples[1].fitted_rows(own.transpose()).transpose(),
                          fitted = samples[1].fitted_rows(fitted_u.transpose()).transpose();
    const Eigen::MatrixXd inner = solver[0] * fitted * solver[1].transpose();
    Eigen::MatrixXd& all = result.surface.control_points[k];
    all.block(1, 1, inner.rows(), inner.cols()) = inner;
    result.rest.push_back(own - rows[0] * inner * rows[1].transpose());
    result.along_axis[0].push_back(own - rows[0] * (solver[0] * fitted_u));
    result.along_axis[1].push_back(own - (fitted_v * solver[1].transpose()) * rows[1].transpose());
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SPLINE_SURFACES_H
