// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CUBIC_INTERPOLATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CUBIC_INTERPOLATION_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/interpolation_data.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <Eigen/Sparse>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// below x_{i-1} + diagonal x_i + above x_{i+1} = right, with one right-hand side per coordinate.
template <class NT, int d>
struct Tridiagonal_row
{
  NT below, diagonal, above;
  std::array<NT, d> right;
};

// Gaussian elimination without pivoting: the rows are diagonally dominant. Exact for exact numbers.
template <class NT, int d>
std::vector<std::array<NT, d>> solved(std::vector<Tridiagonal_row<NT, d>> rows)
{
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const NT factor = rows[i].below / rows[i - 1].diagonal;
    rows[i].diagonal -= factor * rows[i - 1].above;
    for (int k = 0; k < d; ++k)
      rows[i].right[k] -= factor * rows[i - 1].right[k];
  }
  std::vector<std::array<NT, d>> result(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;)
    for (int k = 0; k < d; ++k) {
      NT rest = rows[i].right[k];
      if (i + 1 < rows.size())
        rest -= rows[i].above * result[i + 1][k];
      result[i][k] = rest / rows[i].diagonal;
    }
  return result;
}

template <int d>
std::vector<std::array<double, d>> solved(const std::vector<Tridiagonal_row<double, d>>& rows)
{
  const int n = static_cast<int>(rows.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Matrix<double, Eigen::Dynamic, d> right(n, d);
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, rows[i].diagonal);
    if (i > 0)
      entries.emplace_back(i, i - 1, rows[i].below);
    if (i + 1 < n)
      entries.emplace_back(i, i + 1, rows[i].above);
    for (int k = 0; k < d; ++k)
      right(i, k) = rows[i].right[k];
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success)
    throw Invalid_input("cubic_interpolation_curve: the parameters are too far apart for doubles");
  const Eigen::Matrix<double, Eigen::Dynamic, d> solution = factors.solve(right);
  std::vector<std::array<double, d>> result(rows.size());
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < d; ++k)
      result[i][k] = solution(i, k);
  return result;
}

// First derivatives at the points of the cubic spline that is twice continuously differentiable, with given derivatives
// at the ends or second derivatives zero there.
template <class NT, int d>
class Cubic_interpolation
{
  using Coordinates = std::array<NT, d>;
  using Row = Tridiagonal_row<NT, d>;

  const std::vector<Coordinates>& m_points;
  const std::vector<NT>& m_parameters;

public:
  Cubic_interpolation(const std::vector<Coordinates>& points, const std::vector<NT>& parameters)
    : m_points(points), m_parameters(parameters)
  {}

  std::vector<Coordinates> control_points(const std::optional<std::pair<Coordinates, Coordinates>>& ends) const
  {
    const std::vector<Coordinates> slopes = solved(rows(ends));
    const std::size_t n = m_points.size() - 1;
    std::vector<Coordinates> result{m_points[0], ahead(0, slopes)};
    // The blossom of a piece at three successive parameters.
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const NT ratio = NT(m_parameters[i + 2] - m_parameters[i]) / length(i);
      const Coordinates near = ahead(i, slopes), far = behind(i + 1, slopes);
      result.push_back(combined([&](int k) { return NT(near[k] + NT(ratio * NT(far[k] - near[k]))); }));
    }
    result.push_back(behind(n, slopes));
    result.push_back(m_points[n]);
    return result;
  }

private:
  NT length(std::size_t i) const { return NT(m_parameters[i + 1] - m_parameters[i]); }
  NT chord_slope(std::size_t i, int k) const { return NT(NT(m_points[i + 1][k] - m_points[i][k]) / length(i)); }

  // The inner Bézier points beside point i.
  Coordinates ahead(std::size_t i, const std::vector<Coordinates>& slopes) const
  {
    return combined([&](int k) { return NT(m_points[i][k] + NT(NT(length(i) * slopes[i][k]) / NT(3))); });
  }

  Coordinates behind(std::size_t i, const std::vector<Coordinates>& slopes) const
  {
    return combined([&](int k) { return NT(m_points[i][k] - NT(NT(length(i - 1) * slopes[i][k]) / NT(3))); });
  }

  std::vector<Row> rows(const std::optional<std::pair<Coordinates, Coordinates>>& ends) const
  {
    const std::size_t n = m_points.size() - 1;
    std::vector<Row> result;
    if (ends)
      result.push_back({NT(0), NT(1), NT(0), ends->first});
    else
      result.push_back({NT(0), NT(2), NT(1), combined([&](int k) { return NT(NT(3) * chord_slope(0, k)); })});
    for (std::size_t i = 1; i < n; ++i) {
      const NT before = length(i - 1), after = length(i);
      result.push_back({after, NT(NT(2) * NT(before + after)), before, combined([&](int k) {
                          return NT(NT(3) * NT(NT(after * chord_slope(i - 1, k)) + NT(before * chord_slope(i, k))));
                        })});
    }
    if (ends)
      result.push_back({NT(0), NT(1), NT(0), ends->second});
    else
      result.push_back({NT(1), NT(2), NT(0), combined([&](int k) { return NT(NT(3) * chord_slope(n - 1, k)); })});
    return result;
  }

  template <class Coordinate>
  static Coordinates combined(const Coordinate& coordinate)
  {
    Coordinates result;
    for (int k = 0; k < d; ++k)
      result[k] = coordinate(k);
    return result;
  }
};

template <SplineKernel Kernel, int d, class Point, class Vector>
Bspline_curve<Kernel, d> interpolating_cubic(const std::vector<Point>& points,
                                             std::vector<typename Kernel::FT> parameters,
                                             const std::optional<std::pair<Vector, Vector>>& ends)
{
  using FT = typename Kernel::FT;
  using NT = Spline_number<FT>;
  parameters = interpolation_parameters(std::move(parameters), points.size(), "cubic_interpolation_curve");
  std::vector<std::array<NT, d>> values;
  for (const Point& p : points)
    values.push_back(array_of_coordinates<NT, d>(p));
  std::vector<NT> own;
  for (const FT& t : parameters)
    own.push_back(converted_number<NT>(t));
  std::optional<std::pair<std::array<NT, d>, std::array<NT, d>>> slopes;
  if (ends)
    slopes.emplace(array_of_coordinates<NT, d>(ends->first), array_of_coordinates<NT, d>(ends->second));

  std::vector<Point> control_points;
  for (const std::array<NT, d>& x : Cubic_interpolation<NT, d>(values, own).control_points(slopes))
    control_points.push_back(kernel_object<Kernel, Point>(x));
  std::vector<FT> knots(3, parameters.front());
  knots.insert(knots.end(), parameters.begin(), parameters.end());
  knots.insert(knots.end(), 3, parameters.back());
  return Bspline_curve<Kernel, d>(3, knots, control_points);
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the natural cubic spline through points at increasing parameters, the integers from 0 on if none are given: twice
continuously differentiable, with the second derivative zero at both ends. Exact where the kernel is, with numbers whose
length grows linearly with the number of points; doubles are solved for by Eigen.
\throws Invalid_input for less than two points, a number of parameters that differs from that of the points, parameters
that do not increase, and numbers that are not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> cubic_interpolation_curve(const std::vector<CGAL::Point_2<Kernel>>& points,
                                                  const std::vector<typename Kernel::FT>& parameters = {})
{
  return internal::interpolating_cubic<Kernel, 2>(
      points, parameters, std::optional<std::pair<CGAL::Vector_2<Kernel>, CGAL::Vector_2<Kernel>>>());
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> cubic_interpolation_curve(const std::vector<CGAL::Point_3<Kernel>>& points,
                                                  const std::vector<typename Kernel::FT>& parameters = {})
{
  return internal::interpolating_cubic<Kernel, 3>(
      points, parameters, std::optional<std::pair<CGAL::Vector_3<Kernel>, CGAL::Vector_3<Kernel>>>());
}

//! the cubic spline with given first derivatives at its ends; otherwise as above.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> cubic_interpolation_curve(const std::vector<CGAL::Point_2<Kernel>>& points,
                                                  const std::vector<typename Kernel::FT>& parameters,
                                                  const CGAL::Vector_2<Kernel>& begin_tangent,
                                                  const CGAL::Vector_2<Kernel>& end_tangent)
{
  return internal::interpolating_cubic<Kernel, 2>(points, parameters,
                                                  std::optional(std::pair(begin_tangent, end_tangent)));
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> cubic_interpolation_curve(const std::vector<CGAL::Point_3<Kernel>>& points,
                                                  const std::vector<typename Kernel::FT>& parameters,
                                                  const CGAL::Vector_3<Kernel>& begin_tangent,
                                                  const CGAL::Vector_3<Kernel>& end_tangent)
{
  return internal::interpolating_cubic<Kernel, 3>(points, parameters,
                                                  std::optional(std::pair(begin_tangent, end_tangent)));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CUBIC_INTERPOLATION_H
