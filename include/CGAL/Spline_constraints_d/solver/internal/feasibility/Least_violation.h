// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_LEAST_VIOLATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_LEAST_VIOLATION_H

#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/semidefinite.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A row of the functions whose maximum is to be small: a multiple of a polynomial.
struct Violation_row
{
  std::size_t polynomial;
  double factor;     // negative for the second row of an equality
  double offset = 0; // is added
};

/*
A local minimum of the largest of some functions on a box, in doubles, with multipliers lambda >= 0, sum 1, for which
sum lambda_i f_i is stationary there: near a minimum they give the combination that proves that the functions have no
common negative point. Proximal Newton steps: the largest of the linear parts plus a quadratic form, the Hessian of the
combination at hand made positive, is minimised in the box by its dual, coordinate by coordinate.
*/
class Least_violation
{
  Polynomial_family<double>& m_family;
  std::vector<Violation_row> m_rows;
  const Double_box& m_box;
  std::vector<std::size_t> m_axes; // that are not one number
  std::vector<double> m_point, m_multipliers;
  double m_value = 0;
  bool m_is_any_enough;
  std::function<bool()> m_must_stop;

  struct Linear_parts
  {
    std::vector<double> values, slopes; // of the rows; in the coordinates of the box
    double largest = -HUGE_VAL;
  };

public:
  // Roughly, as far as it takes to see that the minimum is positive: then `refine()` finds it to the last places. Both
  // end early at a point where all functions are negative if `is_any_enough`.
  Least_violation(Polynomial_family<double>& family, std::vector<Violation_row> rows, const Double_box& box,
                  std::vector<double> start, bool is_any_enough, std::function<bool()> must_stop)
    : m_family(family), m_rows(std::move(rows)), m_box(box), m_point(std::move(start)),
      m_multipliers(m_rows.size(), 1.0 / static_cast<double>(m_rows.size())), m_is_any_enough(is_any_enough),
      m_must_stop(std::move(must_stop))
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (box.lower[j] < box.upper[j])
        m_axes.push_back(j);
    minimise(true);
  }

  // The box may have become smaller.
  void refine()
  {
    m_axes.clear();
    for (std::size_t j = 0; j < m_box.size(); ++j) {
      m_point[j] = m_box.clamped(j, m_point[j]);
      if (m_box.lower[j] < m_box.upper[j])
        m_axes.push_back(j);
    }
    minimise(false);
  }

  const std::vector<double>& point() const { return m_point; }

  // The largest function there.
  double value() const { return m_value; }

  // Of the polynomials.
  std::vector<double> multipliers() const
  {
    std::vector<double> result(m_family.size(), 0.0);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      result[m_rows[i].polynomial] += m_multipliers[i] * m_rows[i].factor;
    return result;
  }

private:
  void minimise(bool is_rough)
  {
    Linear_parts parts = linear_parts(m_point);
    double size = 0;
    for (const double slope : parts.slopes)
      size = (std::max)(size, std::abs(slope));
    double proximity = 0.1 * size + 1e-300;
    m_value = parts.largest;
    for (int step = 0; step < 60 && m_value < HUGE_VAL && !m_must_stop(); ++step) {
      if (m_is_any_enough && m_value < 0)
        return;
      std::vector<double> multipliers = m_multipliers;
      const std::vector<double> move = proximal_step(parts, proximity, multipliers);
      std::vector<double> next = m_point;
      double length = 0, expected = -HUGE_VAL;
      for (std::size_t a = 0; a < m_axes.size(); ++a) {
        next[m_axes[a]] = m_box.clamped(m_axes[a], m_point[m_axes[a]] + move[a] * m_box.radius(m_axes[a]));
        length = (std::max)(length, std::abs(move[a]));
      }
      for (std::size_t i = 0; i < m_rows.size(); ++i) {
        double value = parts.values[i];
        for (std::size_t a = 0; a < m_axes.size(); ++a)
          value += parts.slopes[i * m_axes.size() + a] * move[a];
        expected = (std::max)(expected, value);
      }
      Linear_parts there = linear_parts(next);
      m_multipliers = std::move(multipliers);
      if (there.largest < m_value) {
        const bool is_good = there.largest - m_value < 0.5 * (expected - m_value);
        m_point = std::move(next);
        parts = std::move(there);
        m_value = parts.largest;
        proximity *= is_good ? 0.1 : 1;
      } else
        proximity = (std::max)(8 * proximity, 1e-3 * size);
      const bool is_clear = is_rough && m_value > 0 && expected > 0.8 * m_value && length < 0.1;
      if (length < 1e-14 || proximity > 1e20 * size || is_clear)
        return;
    }
  }

  Linear_parts linear_parts(const std::vector<double>& point)
  {
    m_family.set_point(point);
    Linear_parts result;
    for (const Violation_row& row : m_rows) {
      const std::vector<double>& coefficients = m_family.coefficients(row.polynomial);
      const double value = row.factor * m_family.value(coefficients) + row.offset;
      result.values.push_back(value);
      result.largest = value == value ? (std::max)(result.largest, value) : HUGE_VAL;
      const std::vector<double> gradient = m_family.gradient(coefficients);
      for (const std::size_t j : m_axes)
        result.slopes.push_back(row.factor * gradient[j] * m_box.radius(j));
    }
    return result;
  }

  // The Hessian of the combination at hand, at the point of the last linear parts that were kept, plus what makes it
  // positive, inverted.
  std::vector<double> inverse_metric(double proximity)
  {
    const std::size_t n = m_axes.size();
    m_family.set_point(m_point);
    const std::vector<double> all = m_family.hessian(m_family.combination(multipliers()));
    std::vector<double> metric(n * n);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        metric[a * n + b] =
            all[m_axes[a] * m_box.size() + m_axes[b]] * m_box.radius(m_axes[a]) * m_box.radius(m_axes[b]);
    const std::vector<double> none(n, 0.0);
    double shift = semidefinite_shift(metric, none);
    shift = shift < HUGE_VAL ? 1.05 * shift + proximity : proximity;
    for (std::size_t a = 0; a < n; ++a)
      metric[a * n + a] += shift;
    return inverse(metric, n);
  }

  static std::vector<double> inverse(std::vector<double> matrix, std::size_t n)
  {
    std::vector<double> result(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      result[i * n + i] = 1;
    for (std::size_t c = 0; c < n; ++c) { // positive definite: no pivoting
      const double pivot = matrix[c * n + c] > 0 ? 1 / matrix[c * n + c] : 0;
      for (std::size_t j = 0; j < n; ++j) {
        matrix[c * n + j] *= pivot;
        result[c * n + j] *= pivot;
      }
      for (std::size_t i = 0; i < n; ++i)
        if (const double multiple = matrix[i * n + c]; i != c && multiple != 0)
          for (std::size_t j = 0; j < n; ++j) {
            matrix[i * n + j] -= multiple * matrix[c * n + j];
            result[i * n + j] -= multiple * result[c * n + j];
          }
    }
    return result;
  }

  /*
  The step d that makes max(v_i + s_i d) + 1/2 d M d least with the point in the box. Its dual has a multiplier for each
  row, sum 1, and for each face of the box; pairs of the former and single ones of the latter are improved in turn,
  those first that are the farthest from optimal.
  */
  std::vector<double> proximal_step(const Linear_parts& parts, double proximity, std::vector<double>& multipliers)
  {
    const std::size_t n = m_axes.size(), rows = m_rows.size(), all = rows + 2 * n;
    const std::vector<double> inverse = inverse_metric(proximity);
    std::vector<double> normals(parts.slopes), levels(parts.values), solved(all * n, 0.0);
    normals.resize(all * n, 0.0);
    for (std::size_t a = 0; a < n; ++a) {
      const double place = (m_point[m_axes[a]] - m_box.middle(m_axes[a])) / m_box.radius(m_axes[a]);
      normals[(rows + a) * n + a] = 1;
      levels.push_back((std::min)(place - 1, 0.0));
    }
    for (std::size_t a = 0; a < n; ++a) {
      const double place = (m_point[m_axes[a]] - m_box.middle(m_axes[a])) / m_box.radius(m_axes[a]);
      normals[(rows + n + a) * n + a] = -1;
      levels.push_back((std::min)(-1 - place, 0.0));
    }
    for (std::size_t z = 0; z < all; ++z)
      for (std::size_t b = 0; b < n; ++b)
        if (const double x = normals[z * n + b]; x != 0)
          for (std::size_t a = 0; a < n; ++a)
            solved[z * n + a] += inverse[a * n + b] * x;
    std::vector<double> gram(all * all, 0.0), dual(all, 0.0), excess(all); // excess: a_z d + level_z
    for (std::size_t y = 0; y < all; ++y)
      for (std::size_t z = 0; z < all; ++z)
        for (std::size_t a = 0; a < n; ++a)
          gram[y * all + z] += normals[y * n + a] * solved[z * n + a];
    std::copy(multipliers.begin(), multipliers.end(), dual.begin());
    excess = levels;
    for (std::size_t y = 0; y < all; ++y)
      for (std::size_t z = 0; z < rows; ++z)
        excess[y] -= gram[y * all + z] * dual[z];
    double size = 0;
    for (const double value : parts.values)
      size = (std::max)(size, std::abs(value));
    const double accuracy = 1e-24 * size;
    const auto add = [&](std::size_t z, double amount) {
      dual[z] += amount;
      for (std::size_t y = 0; y < all; ++y)
        excess[y] -= gram[y * all + z] * amount;
    };
    for (std::size_t step = 0; step < 40 * all; ++step) {
      std::size_t best = 0, worst = rows, face = rows;
      double gain_of_face = 0;
      for (std::size_t z = 0; z < rows; ++z) {
        best = excess[z] > excess[best] ? z : best;
        if (dual[z] > 0 && (worst == rows || excess[z] < excess[worst]))
          worst = z;
      }
      for (std::size_t z = rows; z < all; ++z) {
        const double off = dual[z] > 0 ? std::abs(excess[z]) : (std::max)(excess[z], 0.0);
        const double gain = gram[z * all + z] > 0 ? off * off / gram[z * all + z] : 0;
        if (gain > gain_of_face) {
          gain_of_face = gain;
          face = z;
        }
      }
      const double off = worst < rows ? excess[best] - excess[worst] : 0;
      const double curvature =
          worst < rows ? gram[best * all + best] + gram[worst * all + worst] - 2 * gram[best * all + worst] : 0;
      const double gain_of_pair = off > 0 && curvature > 0 ? off * off / curvature : off > 0 ? HUGE_VAL : 0;
      if (!(gain_of_pair > accuracy) && !(gain_of_face > accuracy))
        break;
      if (gain_of_pair >= gain_of_face) {
        const double amount = curvature > 0 ? (std::min)(off / curvature, dual[worst]) : dual[worst];
        const bool is_all = amount == dual[worst];
        add(best, amount);
        add(worst, -amount);
        if (is_all)
          dual[worst] = 0;
      } else
        add(face, (std::max)(excess[face] / gram[face * all + face], -dual[face]));
    }
    std::copy(dual.begin(), dual.begin() + static_cast<std::ptrdiff_t>(rows), multipliers.begin());
    std::vector<double> move(n, 0.0);
    for (std::size_t z = 0; z < all; ++z)
      if (dual[z] != 0)
        for (std::size_t a = 0; a < n; ++a)
          move[a] -= solved[z * n + a] * dual[z];
    return move;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_LEAST_VIOLATION_H
