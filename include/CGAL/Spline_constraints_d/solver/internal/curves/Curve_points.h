// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_POINTS_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_refinement.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_factors.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Finds the points of pieces for given values of their parameters.
class Curve_points
{
  using Point = std::vector<double>;

  const Constraint_system_d m_system;
  System_layout m_layout;
  Exact_source m_source;
  std::vector<Exact_source::Value> m_values;
  Cell m_cell; // that the source is at home in
  // The coefficients on it, of function f scaled by 2^-m_scale[f], in doubles.
  std::vector<double> m_lower, m_upper, m_coefficients, m_errors;
  std::vector<long> m_scale;
  Approximate_refinement m_approximate;
  Point m_local, m_local_values; // in coordinates from 0 to 1 on the cell
  std::vector<double> m_inverse, m_rows;
  bool m_is_simple = false;
  std::unique_ptr<Curve_points> m_simpler; // of the system with simple factors, when it was needed

public:
  explicit Curve_points(const Constraint_system_d& system)
    : m_system(equalities_of(system)), m_layout(m_system), m_source(m_system, m_layout)
  {}

  // The point of a piece with the same parameter as one near it. Where Newton's method does not find it, the solver
  // does.
  Point on_curve(const Curve_piece& piece, const Point& near)
  {
    Point result = near;
    const bool has_moved = move_by_doubles(piece.parameter, result) || move_to_curve(piece.parameter, result);
    for (std::size_t j = 0; j < result.size(); ++j)
      if (piece.box[j].first == piece.box[j].second)
        result[j] = near[j]; // in a face of the domain
    if (has_moved && is_in(piece.box, result))
      return result;
    if (Curve_points* const sampler = has_moved ? nullptr : simpler())
      return sampler->on_curve(piece, near);
    const auto slice = Subdivision_solver_d<Certified_solver_traits>()(
        on_plane(m_system, piece.box, piece.parameter, Exact_rational(near[piece.parameter])));
    if (slice.empty())
      return near; // beside the end of the piece, since the ends are rounded
    result = slice.begin()->point();
    result.insert(result.begin() + piece.parameter, near[piece.parameter]);
    return result;
  }

private:
  int n() const { return m_system.dimension(); }

  // Newton's method does not converge along curves that are there several times.
  Curve_points* simpler()
  {
    if (!std::exchange(m_is_simple, true))
      if (const Simple_factors factors(m_system); factors.is_simpler()) {
        m_simpler = std::make_unique<Curve_points>(factors.system());
        m_simpler->m_is_simple = true;
      }
    return m_simpler.get();
  }

  static bool is_in(const Exact_ranges& box, const Point& point)
  {
    for (std::size_t j = 0; j < point.size(); ++j)
      if (point[j] < to_double_interval(box[j].first).first || to_double_interval(box[j].second).second < point[j])
        return false;
    return true;
  }

  // The method with doubles and the derivatives where it begins, and then with values that are exact for doubles until
  // steps are short: mostly one.
  bool move_by_doubles(int parameter, Point& point)
  {
    enter(point);
    m_local.resize(point.size());
    for (std::size_t j = 0; j < point.size(); ++j)
      m_local[j] = (point[j] - m_lower[j]) / (m_upper[j] - m_lower[j]);
    if (!set_inverse(parameter))
      return false;
    m_approximate.refine(m_layout, m_coefficients.data(), m_inverse, m_local);
    Point moved = point;
    for (std::size_t j = 0; j < point.size(); ++j)
      if (static_cast<int>(j) != parameter)
        moved[j] = m_lower[j] + m_local[j] * (m_upper[j] - m_lower[j]);
    constexpr int most_steps = 3;
    for (int step = 0; step < most_steps; ++step) {
      const double longest = step_by_inverse(moved);
      if (longest < 0x1p-48) {
        point = std::move(moved);
        return true;
      }
      if (!(longest < 0x1p-30))
        return false;
    }
    return false;
  }

  // Moves a point by the inverse times values that are exact for doubles; the longest step in local coordinates.
  double step_by_inverse(Point& point)
  {
    const std::vector<double> values = values_at(point, &m_scale);
    const std::size_t equations = static_cast<std::size_t>(n()) - 1;
    double longest = 0;
    for (std::size_t j = 0; j < point.size(); ++j) {
      double step = 0;
      for (std::size_t i = 0; i < equations; ++i)
        step += m_inverse[j * equations + i] * values[i];
      point[j] -= step * (m_upper[j] - m_lower[j]);
      longest = std::abs(step) <= longest ? longest : std::abs(step); // what is no number stays
    }
    return longest;
  }

  // The inverse of the derivatives at the local point, by differences; with a row of zeros for the parameter.
  bool set_inverse(int parameter)
  {
    const std::size_t unknowns = m_local.size(), equations = unknowns - 1, length = 2 * equations;
    m_rows.assign(equations * length, 0);
    m_local_values = m_approximate.values(m_layout, m_coefficients.data(), m_local);
    for (std::size_t j = 0, column = 0; j < unknowns; ++j) {
      if (static_cast<int>(j) == parameter)
        continue;
      constexpr double distance = 0x1p-24;
      const double place = std::exchange(m_local[j], m_local[j] + distance);
      const std::vector<double>& moved = m_approximate.values(m_layout, m_coefficients.data(), m_local);
      for (std::size_t i = 0; i < equations; ++i)
        m_rows[i * length + column] = (moved[i] - m_local_values[i]) / distance;
      m_local[j] = place;
      m_rows[column * length + equations + column] = 1;
      ++column;
    }
    const std::vector<int> row_of =
        gauss_jordan(m_rows, length, equations, equations, [](double x) { return std::abs(x); });
    if (row_of.empty())
      return false;
    m_inverse.assign(unknowns * equations, 0);
    for (std::size_t j = 0, column = 0; j < unknowns; ++j)
      if (static_cast<int>(j) != parameter) {
        const double* row = &m_rows[static_cast<std::size_t>(row_of[column++]) * length + equations];
        std::copy(row, row + equations, m_inverse.begin() + static_cast<std::ptrdiff_t>(j * equations));
      }
    return true;
  }

  // Newton's method with values that are exact for doubles, and differences of these for derivatives.
  bool move_to_curve(int parameter, Point& point)
  {
    constexpr int most_steps = 12;
    double last = 0;
    for (int step = 0; step < most_steps; ++step) {
      const std::vector<double> values = values_at(point);
      const std::size_t length = static_cast<std::size_t>(n()); // n - 1 unknowns and the values
      std::vector<double> rows((length - 1) * length);
      double size = 0;
      for (int j = 0, column = 0; j < n(); ++j) {
        if (j == parameter)
          continue;
        size = (std::max)(size, std::abs(point[j]));
        Point moved = point;
        moved[j] += 0x1p-20 * (std::max)(std::abs(point[j]), 0x1p-10);
        const double distance = moved[j] - point[j];
        const std::vector<double> other = values_at(moved);
        for (std::size_t i = 0; i + 1 < length; ++i)
          rows[i * length + column] = (other[i] - values[i]) / distance;
        ++column;
      }
      for (std::size_t i = 0; i + 1 < length; ++i)
        rows[i * length + length - 1] = values[i];
      const std::vector<int> row_of =
          gauss_jordan(rows, length, length - 1, length - 1, [](double x) { return std::abs(x); });
      if (row_of.empty())
        return false;
      double longest = 0;
      for (int j = 0, column = 0; j < n(); ++j)
        if (j != parameter) {
          const double change = rows[row_of[column++] * length + length - 1];
          point[j] -= change;
          longest = (std::max)(longest, std::abs(change));
        }
      if (!std::isfinite(longest))
        return false;
      // if steps become shorter at the same rate; they do so faster
      const double next = step == 0 ? longest : longest * (longest / last);
      if (next <= 0x1p-50 * (std::max)(size, 0x1p-20))
        return true;
      last = longest;
    }
    return false;
  }

  // Makes values in the cell of a point cheap: exact ones take several times as long, and those with 127 bits are more
  // than doubles need.
  void enter(const Point& point)
  {
    const Cell& cell = m_source.cell_of(std::span<const double>(point));
    if (cell == m_cell)
      return;
    m_cell = cell;
    m_lower.clear();
    m_upper.clear();
    for (int v = 0; v < n(); ++v) {
      const std::vector<Exact_rational>& breaks = m_source.breaks()[v];
      const auto [begin, end] =
          breaks.empty() ? m_system.domain(v) : std::pair(breaks[m_cell[v]], breaks[m_cell[v] + 1]);
      m_lower.push_back(to_double_interval(begin).first);
      m_upper.push_back(to_double_interval(end).second);
    }
    const std::span<const double> lower(m_lower), upper(m_upper);
    m_source.set_home(m_cell, lower, upper);
    m_coefficients.resize(m_layout.size);
    m_errors.resize(m_layout.errors);
    m_source.bernstein_coefficients(m_cell, lower, upper, m_coefficients.data(), m_errors.data(), m_scale);
  }

  // Of the equalities, up to a power of two, or times those of a scale.
  std::vector<double> values_at(const Point& point, const std::vector<long>* scale = nullptr)
  {
    constexpr long largest_exponent = 900;
    enter(point);
    m_source.evaluate_closely(m_cell, std::span<const double>(point), m_values);
    std::vector<double> result;
    result.reserve(m_values.size());
    for (std::size_t f = 0; f < m_values.size(); ++f) {
      const long exponent = m_values[f].exponent - (scale == nullptr ? 0 : (*scale)[f]);
      result.push_back(
          std::ldexp(m_values[f].mantissa,
                     static_cast<int>((std::max)(-largest_exponent, (std::min)(exponent, largest_exponent)))));
    }
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Point_on_piece points_on_pieces(const Constraint_system_d& system)
{
  return [points = std::make_shared<Curve_points>(system)](const Curve_piece& piece, const std::vector<double>& near) {
    return points->on_curve(piece, near);
  };
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_POINTS_H
