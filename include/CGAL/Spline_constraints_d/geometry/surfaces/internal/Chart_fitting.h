// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_CHART_FITTING_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_CHART_FITTING_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Spline_surfaces.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Surface_projection.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// How far splines may be from a surface, and how many pieces they may have along an axis.
struct Fit_limits
{
  int degree;
  double tolerance;
  std::size_t most_spans;
};

/*
Curves and surfaces near a surface of solutions. What is fitted are points of it that Newton's method finds from those
of a first spline, and then from the last one: so a parameter means the same point from round to round, nearly, the
points depend on parameters as smoothly as splines do, and what is left is the distance from the surface. Spans where it
is too great are halved.
*/
class Chart_fitting
{
  Surface_projection& m_projection;
  Fit_limits m_limits;
  double m_error = 0;            // of what was measured last
  bool m_is_regular = true;      // without folds
  std::size_t m_test_points = 0; // that were compared

public:
  using Coordinates = Surface_projection::Coordinates;

  Chart_fitting(Surface_projection& projection, const Fit_limits& limits) : m_projection(projection), m_limits(limits)
  {}

  double error() const { return m_error; }
  bool is_regular() const { return m_is_regular; }
  std::size_t test_points() const { return m_test_points; }
  const Fit_limits& limits() const { return m_limits; }

  // A curve with few pieces beside points, as rows, with parameters from 0 to 1, about as near to them as these are to
  // each other. The points of the surface beside it exist. `directions`: its derivatives at the ends that have them.
  std::optional<Spline_curve> first_curve(const std::vector<double>& parameters, const Eigen::MatrixXd& points,
                                          const std::vector<int>& fixed,
                                          const std::array<std::optional<Coordinates>, 2>& directions)
  {
    const bool is_free = directions[0] || directions[1]; // chords of triangles go to and fro
    const double smoothing = is_free ? 1e-4 : 1e-6, share = is_free ? 2 : 0.5;
    const Eigen::Index last = points.rows() - 1;
    double longest = 0;
    for (Eigen::Index k = 0; k < last; ++k)
      longest = (std::max)(longest, m_projection.distance(points.row(k), points.row(k + 1)));
    const std::vector<double> inner(parameters.begin() + 1, parameters.end() - 1);
    for (std::size_t spans = 1; spans <= 2 * inner.size() + 2; spans *= 2) {
      const Spline_axis axis = clamped(m_limits.degree, even_breaks(spans));
      const double step = 1 / static_cast<double>(spans * static_cast<std::size_t>(m_limits.degree));
      std::array<Eigen::MatrixXd, 2> ends{points.row(0), points.row(last)};
      if (axis.size() >= 4)
        for (const Eigen::Index end : {0, 1})
          if (const auto& direction = directions[static_cast<std::size_t>(end)]) {
            Eigen::MatrixXd& own = ends[static_cast<std::size_t>(end)];
            own.conservativeResize(2, Eigen::NoChange);
            own.row(1 - end) = own.row(0) + (end == 0 ? step : -step) * *direction;
            own.row(end) = points.row(end == 0 ? 0 : last);
          }
      const Spline_curve curve = fitted_curve(axis, inner, points.middleRows(1, last - 1), ends, smoothing);
      const Eigen::MatrixXd at_points = curve.at(parameters);
      double error = 0;
      for (Eigen::Index k = 0; k <= last; ++k)
        error = (std::max)(error, m_projection.distance(points.row(k), at_points.row(k)));
      if (error <= share * longest &&
          projected(curve.at(Sample_parameters(even_breaks(spans), m_limits.degree).all), fixed))
        return curve;
    }
    return std::nullopt;
  }

  // A curve with the same ends within the tolerance, if there are enough pieces.
  std::optional<Spline_curve> fit(Spline_curve curve, const std::vector<int>& fixed)
  {
    Spline_breaks breaks = breaks_of(curve.axis);
    const std::array<Eigen::MatrixXd, 2> ends{curve.control_points.row(0),
                                              curve.control_points.row(curve.control_points.rows() - 1)};
    for (;;) {
      const Sample_parameters samples(breaks, m_limits.degree);
      const std::optional<Eigen::MatrixXd> points = projected(curve.at(samples.all), fixed);
      if (!points)
        return std::nullopt;
      curve = fitted_curve(clamped(m_limits.degree, breaks), samples.fitted, samples.fitted_rows(*points), ends);
      const Eigen::MatrixXd at_samples = curve.at(samples.all);
      std::vector<bool> is_coarse(breaks.size() - 1, false);
      m_error = 0;
      for (std::size_t k = 0; k < samples.all.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        const double error = m_projection.distance(at_samples.row(row), points->row(row));
        m_error = (std::max)(m_error, error);
        is_coarse[samples.span(k)] = is_coarse[samples.span(k)] || error > m_limits.tolerance;
      }
      if (!(m_error > m_limits.tolerance) || 2 * is_coarse.size() > m_limits.most_spans)
        return curve;
      breaks = with_halved_spans(breaks, is_coarse);
    }
  }

  // A surface beside some points: the smoothest one from which Newton's method finds the points of the surface, without
  // stretching or folding it. `orientation`: as Surface_projection::orientation() has it.
  std::optional<Tensor_spline> first_surface(const Square_boundary& boundary, const Scattered_points& data,
                                             int orientation)
  {
    const Smooth_surface smooth(boundary, data);
    for (const double weight : {1e-12, 1.0, 1e2, 1e4, 1e6, 1e8}) {
      Tensor_spline surface = smooth(weight);
      const std::array<Sample_parameters, 2> samples = samples_of(surface);
      const Grid own = surface.at(samples[0].all, samples[1].all);
      const std::optional<Grid> points = projected(own);
      if (points && !is_stretched(own, *points) && is_regular(*points, orientation))
        return surface;
    }
    return std::nullopt;
  }

  // A surface within the tolerance, if there are enough pieces; none where points are not found. `breaks`: at least
  // those of the first surface; `boundary` makes the boundary with finer ones.
  template <class Boundary>
  std::optional<Tensor_spline> fit(Tensor_spline surface, std::array<Spline_breaks, 2> breaks, const Boundary& boundary,
                                   int orientation)
  {
    for (;;) {
      const std::array<Sample_parameters, 2> samples{Sample_parameters(breaks[0], m_limits.degree),
                                                     Sample_parameters(breaks[1], m_limits.degree)};
      const Square_boundary around = boundary(breaks);
      const std::optional<Grid> points =
          projected(points_with_boundary(surface, around, samples[0].all, samples[1].all));
      if (!points)
        return std::nullopt;
      Grid_fit next = fitted_surface(around, samples, *points);
      surface = std::move(next.surface);
      if (greatest_distance(next.rest) <= m_limits.tolerance || !halve(breaks, samples, next))
        return measure(surface, orientation) ? std::optional(std::move(surface)) : std::nullopt;
    }
  }

private:
  std::array<Sample_parameters, 2> samples_of(const Tensor_spline& surface) const
  {
    return {Sample_parameters(breaks_of(surface.axes[0]), m_limits.degree),
            Sample_parameters(breaks_of(surface.axes[1]), m_limits.degree)};
  }

  std::optional<Eigen::MatrixXd> projected(Eigen::MatrixXd points, const std::vector<int>& fixed)
  {
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
      Coordinates point = points.row(k);
      if (!m_projection.project(point, fixed))
        return std::nullopt;
      points.row(k) = point;
    }
    return points;
  }

  static Coordinates point_of(const Grid& grid, Eigen::Index i, Eigen::Index j)
  {
    Coordinates result(static_cast<Eigen::Index>(grid.size()));
    for (std::size_t k = 0; k < grid.size(); ++k)
      result[static_cast<Eigen::Index>(k)] = grid[k](i, j);
    return result;
  }

  std::optional<Grid> projected(Grid grid)
  {
    for (Eigen::Index i = 0; i < grid[0].rows(); ++i)
      for (Eigen::Index j = 0; j < grid[0].cols(); ++j) {
        Coordinates point = point_of(grid, i, j);
        if (!m_projection.project(point))
          return std::nullopt;
        for (std::size_t k = 0; k < grid.size(); ++k)
          grid[k](i, j) = point[static_cast<Eigen::Index>(k)];
      }
    return grid;
  }

  // Whether neighbours on a grid are much farther from each other after they have moved to the surface.
  bool is_stretched(const Grid& before, const Grid& after) const
  {
    constexpr double most = 2;
    const auto length = [&](const Grid& grid, Eigen::Index i, Eigen::Index j, Eigen::Index k, Eigen::Index l) {
      return m_projection.distance(point_of(grid, i, j), point_of(grid, k, l));
    };
    for (Eigen::Index i = 0; i < before[0].rows(); ++i)
      for (Eigen::Index j = 0; j < before[0].cols(); ++j)
        if ((i > 0 && length(after, i - 1, j, i, j) > most * length(before, i - 1, j, i, j)) ||
            (j > 0 && length(after, i, j - 1, i, j) > most * length(before, i, j - 1, i, j)))
          return true;
    return false;
  }

  // Whether the points of a surface over a grid have the same orientation everywhere.
  bool is_regular(const Grid& points, int orientation)
  {
    for (Eigen::Index i = 0; i + 1 < points[0].rows(); ++i)
      for (Eigen::Index j = 0; j + 1 < points[0].cols(); ++j) {
        const Coordinates own = point_of(points, i, j);
        if (m_projection.orientation(own, point_of(points, i + 1, j) - own, point_of(points, i, j + 1) - own) !=
            orientation)
          return false;
      }
    return true;
  }

  double length_at(const Grid& grid, Eigen::Index i, Eigen::Index j) const
  {
    return point_of(grid, i, j).head(static_cast<Eigen::Index>(m_projection.place_coordinates())).norm();
  }

  double greatest_distance(const Grid& rest) const
  {
    double result = 0;
    for (Eigen::Index i = 0; i < rest[0].rows(); ++i)
      for (Eigen::Index j = 0; j < rest[0].cols(); ++j)
        result = (std::max)(result, length_at(rest, i, j));
    return result;
  }

  // Halves the spans where one axis alone leaves more than half of the tolerance; where none does, those of all points
  // that are too far away. False when there are too many.
  bool halve(std::array<Spline_breaks, 2>& breaks, const std::array<Sample_parameters, 2>& samples,
             const Grid_fit& fit) const
  {
    std::array<std::vector<bool>, 2> is_marked;
    for (std::size_t axis = 0; axis < 2; ++axis)
      is_marked[axis].assign(breaks[axis].size() - 1, false);
    const auto mark = [&](std::size_t axis, const Grid& rest, double most) {
      for (Eigen::Index i = 0; i < rest[0].rows(); ++i)
        for (Eigen::Index j = 0; j < rest[0].cols(); ++j)
          if (length_at(rest, i, j) > most)
            is_marked[axis][samples[axis].span(static_cast<std::size_t>(axis == 0 ? i : j))] = true;
    };
    const auto count = [&](std::size_t axis) {
      return static_cast<std::size_t>(std::count(is_marked[axis].begin(), is_marked[axis].end(), true));
    };
    for (std::size_t axis = 0; axis < 2; ++axis)
      mark(axis, fit.along_axis[axis], 0.5 * m_limits.tolerance);
    if (count(0) + count(1) == 0)
      for (std::size_t axis = 0; axis < 2; ++axis)
        mark(axis, fit.rest, m_limits.tolerance);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (is_marked[axis].size() + count(axis) > m_limits.most_spans)
        return false;
      breaks[axis] = with_halved_spans(breaks[axis], is_marked[axis]);
    }
    return true;
  }

  // Compares a surface with the points beside it; false if they are not found.
  bool measure(const Tensor_spline& surface, int orientation)
  {
    const std::array<Sample_parameters, 2> samples = samples_of(surface);
    Grid points = surface.at(samples[0].all, samples[1].all);
    m_error = 0;
    m_test_points = 0;
    for (Eigen::Index i = 0; i < points[0].rows(); ++i)
      for (Eigen::Index j = 0; j < points[0].cols(); ++j) {
        const Coordinates own = point_of(points, i, j);
        Coordinates on_surface = own;
        if (!m_projection.project_into_domain(on_surface))
          return false;
        for (std::size_t k = 0; k < points.size(); ++k)
          points[k](i, j) = on_surface[static_cast<Eigen::Index>(k)];
        m_error = (std::max)(m_error, m_projection.distance(own, on_surface));
        if (!samples[0].is_fitted(static_cast<std::size_t>(i)) || !samples[1].is_fitted(static_cast<std::size_t>(j)))
          ++m_test_points;
      }
    m_is_regular = is_regular(points, orientation);
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_CHART_FITTING_H
