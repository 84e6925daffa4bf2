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
A box with exactly one root of C f (and so at most one of f when there are more equalities than unknowns), and what proves it: in the coordinates of the box, |I - C J| <= contraction < 1 for all Jacobians J on it, where row k of C
acts on the functions scaled by 2^-scale.
*/
template <class Coordinate>
struct Certified_region
{
  std::vector<Coordinate> lower, upper;
  std::vector<double> inverse;   // C, unknowns x equalities
  std::vector<long> scale;
  double contraction = 1;
  std::vector<double> start;     // where to begin, in [0,1]^n; empty: in the middle
};

template <class Coordinate>
struct Root_enclosure
{
  std::vector<Coordinate> lower, upper;
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
x* - z = -C f(z) + (I - C J)(x* - z): in box coordinates |x* - z| <= |C f(z)| / (1 - contraction).
*/
template <class Coordinate>
class Root_refinement
{
  const System_layout& m_layout;
  Exact_source& m_source;
  std::vector<Exact_source::Value> m_values;
  std::vector<double> m_step, m_width;
  std::vector<Coordinate> m_point, m_best;

public:
  Root_refinement(const System_layout& layout, Exact_source& source)
    : m_layout(layout), m_source(source), m_step(layout.dimension), m_width(layout.dimension)
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
      const double distance = newton_step(region);
      const bool improves = distance < best;
      const bool converges = distance < 0.7 * best;
      if (improves) {
        best = distance;
        m_best = m_point;
      }
      if (!converges || is_fine_enough(best, bits))
        break;
      for (int j = 0; j < n; ++j) {
        m_point[j] = stepped(m_point[j], -m_step[j] * m_width[j], bits);
        m_point[j] = (std::min)((std::max)(m_point[j], region.lower[j]), region.upper[j]);
      }
    }
    Root_enclosure<Coordinate> result;
    for (int j = 0; j < n; ++j) {
      const double radius = 1.5 * best * m_width[j] + resolution(m_best[j], m_width[j], bits);
      result.lower.push_back(below(m_best[j], radius));
      result.upper.push_back(above(m_best[j], radius));
    }
    return result;
  }

private:
  // Fills m_step with C f(point) and returns a bound on the distance of the root from the point, both in box coordinates.
  double newton_step(const Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension, m = m_layout.equalities;
    m_source.evaluate(m_source.cell_of(std::span<const Coordinate>(m_point)), std::span<const Coordinate>(m_point), m_values);
    double largest = 0;
    for (int j = 0; j < n; ++j) {
      double step = 0, size = 0;
      for (int i = 0; i < m; ++i) {
        const long exponent = m_values[i].exponent - region.scale[i];
        const double value = std::ldexp(m_values[i].mantissa, static_cast<int>((std::max)(-3000L, (std::min)(exponent, 3000L))));
        step += region.inverse[j * m + i] * value;
        size += std::abs(region.inverse[j * m + i]) * (std::abs(value) + 0x1p-900);
      }
      m_step[j] = step;
      largest = (std::max)(largest, std::abs(step) + 0x1p-44 * size);
    }
    return largest / (1 - region.contraction) * (1 + 0x1p-40);
  }

  bool is_fine_enough(double distance, int bits) const
  {
    for (int j = 0; j < m_layout.dimension; ++j)
      if (distance * m_width[j] > 0.5 * resolution(m_best[j], m_width[j], bits))
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_REFINEMENT_H
