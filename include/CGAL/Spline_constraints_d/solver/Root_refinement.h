// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_REFINEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_REFINEMENT_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Exact_source.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A box with exactly one root of C f (and so at most one of f when there are more equalities than unknowns), and what proves it: in the coordinates of the
box, |I - C J| <= bounds for all Jacobians J on it, with row sums <= contraction < 1, where row k of C acts on the functions scaled by 2^-scale.
*/
template <class Coordinate>
struct Certified_region
{
  std::vector<Coordinate> lower, upper;
  std::vector<double> inverse;   // C, unknowns x equalities
  std::vector<long> scale;
  std::vector<double> bounds;    // unknowns x unknowns
  double contraction = 1;
  std::vector<double> start;     // where to begin, in [0,1]^n; empty: in the middle
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
  const Big_integer scaled = numerator_of((x + Exact_rational(step)) * unit) / denominator_of((x + Exact_rational(step)) * unit);
  return scaled_rational(scaled, -bits);
}

// How close to x a root in a region of some width is sought: a unit in the last place, but not endlessly close to zero; or 2^-bits.
inline double resolution(double x, double width, int)
{
  return (std::max)(std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x), 0x1p-80 * width);
}
inline double resolution(const Exact_rational&, double, int bits) { return std::ldexp(1.0, -bits); }

inline double below(double x, double radius) { return std::nextafter(x - radius, -HUGE_VAL); }
inline double above(double x, double radius) { return std::nextafter(x + radius, HUGE_VAL); }
inline Exact_rational below(const Exact_rational& x, double radius) { return x - Exact_rational(radius); }
inline Exact_rational above(const Exact_rational& x, double radius) { return x + Exact_rational(radius); }

/*
Newton iteration with a fixed inverse and exact residuals, to the full precision of the coordinates. The enclosure follows from
x* - z = -C f(z) + (I - C J)(x* - z): in box coordinates, with Q >= |I - C J| and q its largest row sum, d = |x* - z| satisfies d <= |C f(z)| / (1 - q) in the
maximum norm, and then d <= |C f(z)| + Q d axis by axis, which tells thin axes from wide ones.
*/
template <class Coordinate>
class Root_refinement
{
  const System_layout& m_layout;
  Exact_source& m_source;
  std::vector<Exact_source::Value> m_values;
  std::vector<double> m_step, m_radius, m_distance, m_best_radius, m_width;
  std::vector<Coordinate> m_point, m_best;

public:
  Root_refinement(const System_layout& layout, Exact_source& source)
    : m_layout(layout), m_source(source), m_step(layout.dimension), m_radius(layout.dimension), m_width(layout.dimension)
  {}

  // An enclosure of the root of the region; `bits` after the binary point are aimed at where coordinates are rational.
  Root_enclosure<Coordinate> refine(const Certified_region<Coordinate>& region, int bits)
  {
    const int n = m_layout.dimension;
    m_point.resize(n);
    for (int j = 0; j < n; ++j) {
      m_width[j] = CGAL::to_double(Coordinate(region.upper[j] - region.lower[j])) * (1 + 0x1p-50);
      m_point[j] = stepped(region.lower[j], (region.start.empty() ? 0.5 : region.start[j]) * m_width[j], bits);
    }
    double best = HUGE_VAL;
    for (int iteration = 0; iteration < 200; ++iteration) {
      const double error = newton_step(region, bits);
      const bool converges = error < 0.95 * best;
      if (error < best) {
        best = error;
        m_best = m_point;
        m_best_radius = m_radius;
      }
      if (!converges || best <= 0.5)
        break;
      for (int j = 0; j < n; ++j) {
        m_point[j] = stepped(m_point[j], -m_step[j] * m_width[j], bits);
        m_point[j] = (std::min)((std::max)(m_point[j], region.lower[j]), region.upper[j]);
      }
    }
    Root_enclosure<Coordinate> result;
    for (int j = 0; j < n; ++j) {
      const double radius = 1.5 * m_best_radius[j] + resolution(m_best[j], m_width[j], bits);
      result.lower.push_back(below(m_best[j], radius));
      result.upper.push_back(above(m_best[j], radius));
    }
    result.error = best;
    return result;
  }

private:
  // Fills m_step with C f(point) in box coordinates and m_radius with bounds on the distance of the root from the point; returns the largest
  // of these in units of the resolution.
  double newton_step(const Certified_region<Coordinate>& region, int bits)
  {
    const int n = m_layout.dimension, m = m_layout.equalities;
    m_source.evaluate(m_source.cell_of(std::span<const Coordinate>(m_point)), std::span<const Coordinate>(m_point), m_values);
    double largest = 0;
    for (int j = 0; j < n; ++j) {
      double step = 0, size = 0;
      for (int i = 0; i < m; ++i) {
        const long exponent = (std::max)(-3000L, (std::min)(m_values[i].exponent - region.scale[i], 3000L));
        const double value = std::ldexp(m_values[i].mantissa, static_cast<int>(exponent));
        step += region.inverse[j * m + i] * value;
        size += std::abs(region.inverse[j * m + i]) * (std::abs(value) + 0x1p-900);
      }
      m_step[j] = step;
      m_radius[j] = std::abs(step) + 0x1p-44 * size;
      largest = (std::max)(largest, m_radius[j]);
    }
    m_distance.assign(n, largest / (1 - region.contraction) * (1 + 0x1p-40));
    for (int sweep = 0; sweep < 3; ++sweep)
      for (int j = 0; j < n; ++j) {
        double bound = m_radius[j];
        for (int k = 0; k < n; ++k)
          bound += region.bounds[j * n + k] * m_distance[k];
        m_distance[j] = (std::min)(m_distance[j], bound * (1 + 0x1p-40));
      }
    double error = 0;
    for (int j = 0; j < n; ++j) {
      m_radius[j] = m_distance[j] * m_width[j] * (1 + 0x1p-40);
      error = (std::max)(error, m_radius[j] / resolution(m_point[j], m_width[j], bits));
    }
    return error;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_REFINEMENT_H
