// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CONVEX_BOUND_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CONVEX_BOUND_H

#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/semidefinite.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

struct Double_box
{
  std::vector<double> lower, upper;

  std::size_t size() const { return lower.size(); }
  double middle(std::size_t j) const { return lower[j] + 0.5 * (upper[j] - lower[j]); }
  std::vector<double> middle() const
  {
    std::vector<double> result;
    for (std::size_t j = 0; j < size(); ++j)
      result.push_back(middle(j));
    return result;
  }
  double radius(std::size_t j) const { return 0.5 * (upper[j] - lower[j]); }
  double clamped(std::size_t j, double x) const { return (std::min)((std::max)(x, lower[j]), upper[j]); }
};

/*
A linear function from below to a combination L of polynomials on a box: c + s (x - p) <= L(x).

With the enclosure of the Hessian of L on the box, a diagonal a >= 0 is found for which P = L - 1/2 sum a_j (x_j - l_j)
(u_j - x_j) is convex there; P <= L, and P is at least its tangent at p, near the least point of P (the underestimator
alpha-BB of C. S. Adjiman, S. Dallwig, C. A. Floudas, A. Neumaier, 1998). For a convex quadric a = 0, and the bound is
its least value: then one node is enough, whatever the number of unknowns.
*/
class Convex_bound
{
  std::vector<double> m_point;
  Interval m_constant{0};
  std::vector<Interval> m_slopes;
  const Double_box& m_box;
  bool m_is_convex = false;

public:
  // The point is a guess of where the combination is least.
  Convex_bound(Polynomial_family<Interval>& family, const std::vector<Interval>& coefficients, const Double_box& box,
               const std::vector<double>& guess)
    : m_point(guess), m_slopes(box.size(), Interval(0)), m_box(box)
  {
    std::vector<Interval> ranges;
    for (std::size_t j = 0; j < box.size(); ++j)
      ranges.emplace_back(box.lower[j], box.upper[j]);
    family.set_point(ranges);
    const auto curvature = missing_curvature(family.hessian(coefficients));
    if (!curvature) {
      m_constant = family.value(coefficients);
      return;
    }
    for (int step = 0; step < 4; ++step) {
      set_tangent(family, coefficients, curvature->diagonal);
      if (!descend(*curvature))
        return;
    }
    set_tangent(family, coefficients, curvature->diagonal);
  }

  // L itself is convex.
  bool is_convex() const { return m_is_convex; }

  // Of L on the box.
  double lower() const
  {
    Interval sum = m_constant;
    for (std::size_t j = 0; j < m_slopes.size(); ++j)
      sum += Interval(least_part(j));
    return sum.inf();
  }

  // Keeps what may satisfy L <= 0; false when nothing is left.
  bool contract(Double_box& box) const
  {
    Interval sum = m_constant;
    for (std::size_t j = 0; j < m_slopes.size(); ++j)
      sum += Interval(least_part(j));
    if (sum.inf() > 0)
      return false;
    for (std::size_t j = 0; j < m_slopes.size(); ++j) {
      if (!(m_slopes[j].inf() > 0 || m_slopes[j].sup() < 0) || box.lower[j] == box.upper[j])
        continue;
      const Interval others = Interval(sum.inf()) - Interval(least_part(j)),
                     end = Interval(m_point[j]) - Interval(others.inf()) / m_slopes[j];
      if (m_slopes[j].inf() > 0 && end.sup() < box.upper[j])
        box.upper[j] = end.sup();
      if (m_slopes[j].sup() < 0 && end.inf() > box.lower[j])
        box.lower[j] = end.inf();
      if (!(box.lower[j] <= box.upper[j]))
        return false;
    }
    return true;
  }

private:
  struct Curvature
  {
    std::vector<double> hessian;  // in the middle of the enclosure, plus the diagonal
    std::vector<double> diagonal; // a
  };

  double least_part(std::size_t j) const
  {
    const Interval reach = Interval(m_box.lower[j], m_box.upper[j]) - Interval(m_point[j]);
    return (m_slopes[j] * reach).inf();
  }

  // In the coordinates of the unit box, in which the diagonal that is sought is a multiple of the unit matrix beside
  // what the width of the enclosure takes.
  std::optional<Curvature> missing_curvature(const std::vector<Interval>& hessian)
  {
    const std::size_t n = m_box.size();
    std::vector<double> middle(n * n), width(n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const Interval entry = hessian[i * n + j] * Interval(m_box.radius(i)) * Interval(m_box.radius(j));
        if (!(std::abs(entry.inf()) < HUGE_VAL) || !(std::abs(entry.sup()) < HUGE_VAL))
          return std::nullopt;
        middle[i * n + j] = middle[j * n + i] = 0.5 * (entry.inf() + entry.sup());
        const Interval rest = entry - Interval(middle[i * n + j]);
        width[i] += (std::max)(-rest.inf(), rest.sup()); // rounded upward
        if (i != j)
          width[j] += (std::max)(-rest.inf(), rest.sup());
      }
    const std::vector<double> none(n, 0.0);
    const double shift = semidefinite_shift(middle, none);
    if (!(shift < HUGE_VAL))
      return std::nullopt;
    m_is_convex = shift == 0;
    Curvature result{std::vector<double>(n * n), std::vector<double>(n, 0.0)};
    for (std::size_t i = 0; i < n; ++i) {
      const double r = m_box.radius(i);
      if (const double needed = shift + width[i]; r > 0 && needed > 0) {
        result.diagonal[i] = needed / r / r * (1 + 0x1p-48);
        m_is_convex = m_is_convex && width[i] == 0;
      }
      for (std::size_t j = 0; j < n; ++j)
        result.hessian[i * n + j] = 0.5 * (hessian[i * n + j].inf() + hessian[i * n + j].sup());
      result.hessian[i * n + i] += result.diagonal[i];
    }
    return result;
  }

  void set_tangent(Polynomial_family<Interval>& family, const std::vector<Interval>& coefficients,
                   const std::vector<double>& diagonal)
  {
    const std::vector<Interval> place(m_point.begin(), m_point.end());
    family.set_point(place);
    m_constant = family.value(coefficients);
    m_slopes = family.gradient(coefficients);
    for (std::size_t j = 0; j < m_slopes.size(); ++j)
      if (diagonal[j] > 0) {
        const Interval below = place[j] - Interval(m_box.lower[j]), above = Interval(m_box.upper[j]) - place[j];
        m_constant -= Interval(0.5 * diagonal[j]) * below * above;
        m_slopes[j] -= Interval(0.5 * diagonal[j]) * (above - below);
      }
  }

  // Moves the point towards the least one of P by its Hessian, a coordinate at a time; false when it is there.
  bool descend(const Curvature& curvature)
  {
    const std::size_t n = m_point.size();
    std::vector<double> slopes(n);
    for (std::size_t j = 0; j < n; ++j)
      slopes[j] = 0.5 * (m_slopes[j].inf() + m_slopes[j].sup());
    double moved = 0;
    for (int sweep = 0; sweep < 60; ++sweep) {
      double step = 0;
      for (std::size_t j = 0; j < n; ++j) {
        if (m_box.lower[j] == m_box.upper[j] || slopes[j] == 0)
          continue;
        const double own = curvature.hessian[j * n + j];
        const double target = own > 0 ? m_point[j] - slopes[j] / own : slopes[j] > 0 ? m_box.lower[j] : m_box.upper[j];
        const double d = m_box.clamped(j, target) - m_point[j];
        if (!(std::abs(d) > 0))
          continue;
        m_point[j] = m_box.clamped(j, target);
        for (std::size_t k = 0; k < n; ++k)
          slopes[k] += d * curvature.hessian[k * n + j];
        step = (std::max)(step, std::abs(d) / m_box.radius(j));
      }
      moved = (std::max)(moved, step);
      if (step < 1e-13)
        break;
    }
    return moved > 1e-14;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CONVEX_BOUND_H
