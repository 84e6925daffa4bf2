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
  Cell m_cell;   // that the source is at home in
  bool m_is_simple = false;
  std::unique_ptr<Curve_points> m_simpler;   // of the system with simple factors, when it was needed

public:
  explicit Curve_points(const Constraint_system_d& system)
    : m_system(equalities_of(system)), m_layout(m_system), m_source(m_system, m_layout)
  {}

  // The point of a piece with the same parameter as one near it. Where Newton's method does not find it, the solver
  // does.
  Point on_curve(const Curve_piece& piece, const Point& near)
  {
    Point result = near;
    const bool has_moved = move_to_curve(piece.parameter, result);
    for (std::size_t j = 0; j < result.size(); ++j)
      if (piece.box[j].first == piece.box[j].second)
        result[j] = near[j];   // in a face of the domain
    if (has_moved && is_in(piece.box, result))
      return result;
    if (Curve_points* const sampler = has_moved ? nullptr : simpler())
      return sampler->on_curve(piece, near);
    const auto slice = Subdivision_solver_d<Certified_solver_traits>()(
        on_plane(m_system, piece.box, piece.parameter, Exact_rational(near[piece.parameter])));
    if (slice.empty())
      return near;   // beside the end of the piece, since the ends are rounded
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

  // Newton's method with values that are exact for doubles, and differences of these for derivatives.
  bool move_to_curve(int parameter, Point& point)
  {
    constexpr int most_steps = 12;
    double last = 0;
    for (int step = 0; step < most_steps; ++step) {
      const std::vector<double> values = values_at(point);
      const std::size_t length = static_cast<std::size_t>(n());   // n - 1 unknowns and the values
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

  // Makes values in a cell cheap: exact ones take several times as long, and those with 127 bits are more than doubles
  // need.
  void enter(const Cell& cell)
  {
    m_cell = cell;
    std::vector<double> lower, upper;
    for (int v = 0; v < n(); ++v) {
      const std::vector<Exact_rational>& breaks = m_source.breaks()[v];
      const auto [begin, end] = breaks.empty() ? m_system.domain(v) : std::pair(breaks[cell[v]], breaks[cell[v] + 1]);
      lower.push_back(to_double_interval(begin).first);
      upper.push_back(to_double_interval(end).second);
    }
    m_source.set_home(cell, std::span<const double>(lower), std::span<const double>(upper));
  }

  // Of the equalities, up to a power of two.
  std::vector<double> values_at(const Point& point)
  {
    constexpr long largest_exponent = 900;
    const Cell cell = m_source.cell_of(std::span<const double>(point));
    if (cell != m_cell)
      enter(cell);
    m_source.evaluate_closely(cell, std::span<const double>(point), m_values);
    std::vector<double> result;
    for (const Exact_source::Value& value : m_values)
      result.push_back(
          std::ldexp(value.mantissa,
                     static_cast<int>((std::max)(-largest_exponent, (std::min)(value.exponent, largest_exponent)))));
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
