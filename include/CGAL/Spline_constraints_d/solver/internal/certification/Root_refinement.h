// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_REFINEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_REFINEMENT_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/allocate_parts.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A box with exactly one root of C f (and so at most one of f when there are more equalities than unknowns), and what
proves it: in the coordinates of the box, Q = bounds >= |I - C J| for all Jacobians J on it, and Q d <= contraction d <
d with the weights d, where row k of C acts on the functions of `source` scaled by 2^-scale.
*/
template <class Coordinate>
struct Certified_region
{
  std::vector<Coordinate> lower, upper;
  std::vector<double> inverse;   // C, unknowns x equalities
  std::vector<long> scale;
  std::vector<double> bounds;    // unknowns x unknowns
  double contraction = 1;
  std::vector<double> weights;   // positive; empty: ones
  std::vector<double> start;     // where to begin, in [0,1]^n; empty: in the middle
  Exact_source* source = nullptr;
  std::vector<Short_integer> matrix;   // of the source
};

template <class Coordinate>
struct Root_enclosure
{
  std::vector<Coordinate> lower, upper;
  double error = 0;   // largest half width in units of the resolution
};

// The step of one unknown: at double precision, or rounded to a dyadic number of `bits` bits after the binary point.
inline double stepped(double x, double step, int) { return x + step; }

inline Exact_rational stepped(const Exact_rational& x, double step, int bits)
{
  if (!std::isfinite(step))
    return x;
  const Exact_rational unit = power_of_two(bits);
  const Big_integer scaled =
      numerator_of((x + Exact_rational(step)) * unit) / denominator_of((x + Exact_rational(step)) * unit);
  return scaled_rational(scaled, -bits);
}

// How close to x a root in a region of some width is sought: a unit in the last place, but not endlessly close to zero;
// or 2^-bits.
inline double resolution(double x, double width, int)
{
  return (std::max)(next_above(std::abs(x)) - std::abs(x), 0x1p-80 * width);
}
inline double resolution(const Exact_rational&, double, int bits) { return std::ldexp(1.0, -bits); }

inline double below(double x, double radius) { return next_below(x - radius); }
inline double above(double x, double radius) { return next_above(x + radius); }
inline Exact_rational below(const Exact_rational& x, double radius) { return x - Exact_rational(radius); }
inline Exact_rational above(const Exact_rational& x, double radius) { return x + Exact_rational(radius); }

/*
Newton's iteration in double, on the coefficients of a box: where the one with exact residuals, of which each costs
more, may begin. Proves nothing.
*/
class Approximate_refinement
{
  std::vector<double> m_values, m_next, m_work, m_binomials;

public:
  // Moves a point, in the coordinates [0,1]^n of the box, as close to the root as steps shrink; `inverse` has a column
  // per equality.
  void refine(const System_layout& layout, const double* coefficients, const std::vector<double>& inverse,
              std::vector<double>& point)
  {
    const std::size_t n = point.size(), m = inverse.size() / n;
    m_next.resize(n);
    for (double last = 0.5;;) {
      values(layout, coefficients, point);
      double largest = 0;
      for (std::size_t j = 0; j < n; ++j) {
        double step = 0;
        for (std::size_t i = 0; i < m; ++i)
          step += inverse[j * m + i] * m_values[i];
        m_next[j] = (std::min)((std::max)(point[j] - step, 0.0), 1.0);
        largest = std::abs(step) <= largest ? largest : std::abs(step);   // what is no number ends it
      }
      if (!(largest < 0.5 * last))
        return;
      std::swap(point, m_next);
      if (largest / last * largest < 0x1p-53)
        return;   // the next step, at this rate, would be lost in the last place
      last = largest;
    }
  }

  // Of all functions at a point, axis by axis of each block; they stay until the next call.
  const std::vector<double>& values(const System_layout& layout, const double* coefficients,
                                    const std::vector<double>& point)
  {
    m_values.assign(static_cast<std::size_t>(layout.functions), 0.0);
    m_work.resize(layout.size);
    double* work = m_work.data();
    for (const Block& block : layout.blocks) {
      const double* rest = coefficients + block.offset;
      for (std::size_t j = 0; j < block.axes.size(); ++j, rest = work) {
        const int degree = block.degrees[j];
        const std::size_t inner = block.lengths[j + 1];
        const double t = point[block.axes[j]], one_less = 1 - t, *binomials = binomials_of(degree);
        for_each_place(inner, [&](auto type, std::size_t i) {   // Horner's scheme for Bernstein polynomials
          auto sum = load(type, rest + i);
          double power = 1;
          for (int k = 1; k <= degree; ++k) {
            power *= t;
            sum = sum * one_less + load(type, rest + k * inner + i) * (binomials[k] * power);
          }
          store(work + i, sum);
        });
      }
      add_to_values(block.functions, rest);
    }
    return m_values;
  }

private:
  // Two by two where the functions follow each other: numbers that are stored one by one wait before they are read as a
  // pair.
  void add_to_values(const std::vector<int>& functions, const double* addend)
  {
    const std::size_t count = functions.size();
    if (functions[count - 1] - functions[0] + std::size_t(1) == count)
      for_each_place(count, [&, first = m_values.data() + functions[0]](auto type, std::size_t i) {
        store(first + i, load(type, first + i) + load(type, addend + i));
      });
    else
      for (std::size_t i = 0; i < count; ++i)
        m_values[functions[i]] += addend[i];
  }

  const double* binomials_of(int degree)
  {
    if (m_binomials.size() != static_cast<std::size_t>(degree) + 1) {
      m_binomials.assign(static_cast<std::size_t>(degree) + 1, 1.0);
      for (int k = 1; k <= degree; ++k)
        m_binomials[k] = m_binomials[k - 1] * (degree - k + 1) / k;
    }
    return m_binomials.data();
  }
};

/*
Newton iteration with a fixed inverse and exact residuals, to the full precision of the coordinates. The enclosure
follows from x* - z = -C f(z) + (I - C J)(x* - z): in box coordinates, e = |x* - z| satisfies |e| <= |C f(z)| / (1 - q)
in the weighted maximum norm in which q bounds Q >= |I - C J|, and then e <= |C f(z)| + Q e axis by axis, which tells
thin axes from wide ones.
*/
template <class Coordinate>
class Root_refinement
{
  std::vector<Exact_source::Value> m_values;
  std::vector<double> m_numbers;   // all of the following lies in one piece
  std::span<double> m_value, m_value_error, m_step, m_step_error, m_radius, m_distance, m_best_radius, m_width,
      m_shortest, m_last_step;
  std::vector<Coordinate> m_point, m_last_point, m_best;
  Root_enclosure<Coordinate> m_enclosure;

public:
  // What refine() found last.
  const Root_enclosure<Coordinate>& enclosure() const { return m_enclosure; }

  // An enclosure of the root of the region, which stays until the next call; `bits` after the binary point are aimed at
  // where coordinates are rational.
  const Root_enclosure<Coordinate>& refine(const Certified_region<Coordinate>& region, int bits)
  {
    const int n = static_cast<int>(region.lower.size());
    region.source->set_matrix(region.matrix);
    if (m_point.size() != region.lower.size())
      allocate(region.lower.size(), region.inverse.size() / region.lower.size());
    for (int j = 0; j < n; ++j) {
      m_width[j] = CGAL::to_double(Coordinate(region.upper[j] - region.lower[j])) * (1 + 0x1p-50);
      m_point[j] = stepped(region.lower[j], (region.start.empty() ? 0.5 : region.start[j]) * m_width[j], bits);
    }
    m_best = m_point;   // with the whole region around it, should no step be finite
    std::copy(m_width.begin(), m_width.end(), m_best_radius.begin());
    constexpr double goal = 0.6;   // half a unit, and what the bounds add
    double best = HUGE_VAL;
    const auto keep_if_best = [&](double error) {
      if (error < best) {
        best = error;
        m_best = m_point;
        std::copy(m_radius.begin(), m_radius.end(), m_best_radius.begin());
      }
      return best <= goal;
    };
    int idle = 0;   // iterations in which no step became shorter: the coordinates are not fine enough for more
    std::fill(m_shortest.begin(), m_shortest.end(), HUGE_VAL);
    std::fill(m_last_step.begin(), m_last_step.end(), 0.0);
    for (int iteration = 0; iteration < 1000 && idle < 6; ++iteration) {
      const double error = newton_step(region, bits);
      if (keep_if_best(error))
        break;
      ++idle;
      for (int j = 0; j < n; ++j)
        if (std::abs(m_step[j]) < 0.98 * m_shortest[j]) {
          m_shortest[j] = std::abs(m_step[j]);
          idle = 0;
        }
      m_last_point = m_point;
      for (int j = 0; j < n; ++j) {
        m_point[j] = stepped(m_point[j], -extrapolated_step(j, iteration) * m_width[j], bits);
        m_point[j] = (std::min)((std::max)(m_point[j], region.lower[j]), region.upper[j]);
      }
      if (m_point == m_last_point)
        break;   // the coordinates are not fine enough for the step
      if (!std::isfinite(error))
        continue;
      if (const double next = error_after_step(region, bits); next <= goal) {
        keep_if_best(next);
        break;
      }
    }
    for (int j = 0; j < n; ++j) {
      const double radius = 1.5 * m_best_radius[j] + resolution(m_best[j], m_width[j], bits);
      // beyond the region there may be others
      m_enclosure.lower[j] = (std::max)(below(m_best[j], radius), region.lower[j]);
      m_enclosure.upper[j] = (std::min)(above(m_best[j], radius), region.upper[j]);
    }
    m_enclosure.error = best;
    return m_enclosure;
  }

private:
  void allocate(std::size_t unknowns, std::size_t equalities)
  {
    allocate_parts<double>(m_numbers,
                           {{&m_value, equalities},
                            {&m_value_error, equalities},
                            {&m_step, unknowns},
                            {&m_step_error, unknowns},
                            {&m_radius, unknowns},
                            {&m_distance, unknowns},
                            {&m_best_radius, unknowns},
                            {&m_width, unknowns},
                            {&m_shortest, unknowns},
                            {&m_last_step, unknowns}});
    for (auto* v : {&m_point, &m_last_point, &m_best, &m_enclosure.lower, &m_enclosure.upper})
      v->resize(unknowns);
  }

  // At a kink C is not the inverse on either side, and steps shrink by a constant factor: every other one goes to the
  // limit of the geometric series. Steps that do not shrink any more are the rounding of the coordinate.
  double extrapolated_step(int j, int iteration)
  {
    const double ratio = m_step[j] / m_last_step[j];
    m_last_step[j] = m_step[j];
    return iteration % 2 == 1 && std::abs(ratio) > 0.1 && std::abs(ratio) < 0.95 ? m_step[j] / (1 - ratio) : m_step[j];
  }

  // Fills m_step with C f(point) in box coordinates and m_radius with bounds on the distance of the root from the
  // point; returns the largest of these in units of the resolution, infinity where a value left the range of double.
  double newton_step(const Certified_region<Coordinate>& region, int bits)
  {
    const int n = static_cast<int>(region.lower.size());
    const Cell& cell = region.source->cell_of(std::span<const Coordinate>(m_point));
    region.source->evaluate_closely(cell, std::span<const Coordinate>(m_point), m_values);
    if (!form_step(region, bits)) {
      region.source->evaluate(cell, std::span<const Coordinate>(m_point), m_values);
      form_step(region, bits);
    }
    const auto weight = [&](int j) { return region.weights.empty() ? 1.0 : region.weights[j]; };
    double largest = 0;
    for (int j = 0; j < n; ++j) {
      m_radius[j] = std::abs(m_step[j]) + m_step_error[j];
      if (!std::isfinite(m_radius[j]))
        return HUGE_VAL;   // out of the range of double: no distance is known
      largest = (std::max)(largest, m_radius[j] / weight(j));
    }
    for (int j = 0; j < n; ++j)
      m_distance[j] = weight(j) * largest / (1 - region.contraction) * (1 + 0x1p-40);
    bool is_better = true;
    for (int sweep = 0; sweep < 100 && is_better; ++sweep) {
      is_better = false;
      for (int j = 0; j < n; ++j) {
        double bound = m_radius[j];
        for (int k = 0; k < n; ++k)
          bound += region.bounds[j * n + k] * m_distance[k];
        bound *= 1 + 0x1p-40;
        is_better = is_better || bound < 0.9 * m_distance[j];
        m_distance[j] = (std::min)(m_distance[j], bound);
      }
    }
    for (int j = 0; j < n; ++j)
      m_radius[j] = m_distance[j] * m_width[j] * (1 + 0x1p-40);
    return largest_error(bits);
  }

  // Fills m_step with C times the values, and m_step_error. Returns whether the errors that the values tell of are far
  // below the resolution.
  bool form_step(const Certified_region<Coordinate>& region, int bits)
  {
    const int n = static_cast<int>(region.lower.size()), m = static_cast<int>(region.inverse.size()) / n;
    for (int i = 0; i < m; ++i) {
      const double unit = times_power_of_two(1, m_values[i].exponent - region.scale[i]);
      // infinity, beyond the range of double, is no value of zero
      const auto scaled = [&](double x) { return x == 0 ? 0 : x * unit; };
      m_value[i] = scaled(m_values[i].mantissa);
      m_value_error[i] = scaled(m_values[i].error);
    }
    bool is_fine = true;
    for (int j = 0; j < n; ++j) {
      double step = 0, size = 0, error = 0;
      for (int i = 0; i < m; ++i) {
        const double factor = region.inverse[j * m + i];
        step += factor * m_value[i];
        size += std::abs(factor) * (std::abs(m_value[i]) + 0x1p-900);
        error += std::abs(factor) * m_value_error[i];
      }
      m_step[j] = step;
      m_step_error[j] = 0x1p-42 * size + error * (1 + 0x1p-40);   // of the values, and of the sum
      is_fine = is_fine && error * m_width[j] <= 0x1p-10 * resolution(m_point[j], m_width[j], bits);
    }
    return is_fine;
  }

  // The same after the step from m_last_point to m_point, without another residual: x* - (z - C f(z)) = (I - C J)(x* -
  // z), and m_point is z - C f(z) but for rounding. Where the step went elsewhere, the difference counts as rounding.
  // \pre newton_step() found finite distances
  double error_after_step(const Certified_region<Coordinate>& region, int bits)
  {
    const int n = static_cast<int>(region.lower.size());
    for (int j = 0; j < n; ++j) {
      double bound = m_step_error[j];
      for (int k = 0; k < n; ++k)
        bound += region.bounds[j * n + k] * m_distance[k];
      const double wanted = m_step[j] * m_width[j], taken = CGAL::to_double(Coordinate(m_last_point[j] - m_point[j]));
      const double rounding = std::abs(wanted - taken) + 0x1p-47 * (std::abs(wanted) + std::abs(taken));
      m_radius[j] = (bound * m_width[j] + rounding) * (1 + 0x1p-40) + 0x1p-1020;
    }
    return largest_error(bits);
  }

  // The largest entry of m_radius in units of the resolution.
  double largest_error(int bits) const
  {
    double error = 0;
    for (std::size_t j = 0; j < m_radius.size(); ++j)
      error = (std::max)(error, m_radius[j] / resolution(m_point[j], m_width[j], bits));
    return error;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_REFINEMENT_H
