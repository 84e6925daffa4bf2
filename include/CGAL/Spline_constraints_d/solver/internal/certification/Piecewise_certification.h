// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_PIECEWISE_CERTIFICATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_PIECEWISE_CERTIFICATION_H

#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_refinement.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/matrix_inverse.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Certification on a box that reaches over a break, where a spline is another polynomial on the other side. A root there
is never certified on the extension of one piece: a continuous piecewise polynomial satisfies f(x) - f(z) = J (x - z)
with J in the convex hull of the Jacobians of all pieces that meet the box (the segment argument holds piece by piece),
so the Newton operator with *one* C and the hull over the pieces proves as much as it does for one polynomial.
*/
template <class NT>
class Piecewise_certification
{
public:
  using Coordinate = typename Number_traits<NT>::Coordinate;
  enum Verdict { NO_ROOT, ONE_ROOT, OPEN };

private:
  const System_layout& m_layout;
  Exact_source& m_source;
  std::optional<Node_view> m_view;   // made when it is needed for the first time
  std::vector<double> m_coefficients, m_errors;
  // pieces x equalities x unknowns: derivatives in box coordinates, functions scaled by 2^-scale
  std::vector<double> m_work, m_lower, m_upper;
  std::vector<Exact_source::Value> m_values;
  std::vector<double> m_step, m_slack;   // C f at the centre, and its rounding
  std::vector<double> m_trial, m_image;
  std::vector<Coordinate> m_centre;
  double m_off_centre = 0, m_radius = 0;

public:
  Piecewise_certification(const System_layout& layout, Exact_source& source)
    : m_layout(layout), m_source(source)
  {}

  // The box reaches beyond the breaks around a cell, into another cell.
  bool crosses_break(const Cell& cell, const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper) const
  {
    for (int v = 0; v < m_layout.dimension; ++v) {
      const std::vector<Exact_rational>& breaks = m_source.breaks(v);
      if (breaks.size() > 2 &&
          ((cell[v] > 0 && Exact_rational(lower[v]) < breaks[cell[v]]) ||
           (cell[v] + 2 < static_cast<int>(breaks.size()) && breaks[cell[v] + 1] < Exact_rational(upper[v]))))
        return true;
    }
    return false;
  }

  // Decides the box of the region and fills in the proof; the box grows when the roots it may hold reach over its
  // faces. Only for as many equalities as unknowns.
  Verdict certify(Certified_region<Coordinate>& region)
  {
    constexpr int most_attempts = 3;
    if (m_layout.equalities != m_layout.dimension)
      return OPEN;
    region.source = &m_source;
    region.matrix = m_source.matrix();
    for (int attempt = 1;; ++attempt) {
      if (!bound_contraction(region))
        return OPEN;
      const Verdict verdict = test_image(region);
      if (verdict != OPEN || attempt == most_attempts || !enlarge(region))
        return verdict;
    }
  }

private:
  // Fills in C and the bounds on |I - C J|, and C f at the centre; false when they are not finite.
  bool bound_contraction(Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension;
    bound_derivatives(region);
    region.inverse.resize(n * n);
    m_work.assign(n * n, 0);
    for (int entry = 0; entry < n * n; ++entry) {
      double lower = HUGE_VAL, upper = -HUGE_VAL;
      for (std::size_t c = entry; c < m_lower.size(); c += n * n) {
        lower = (std::min)(lower, m_lower[c]);
        upper = (std::max)(upper, m_upper[c]);
      }
      m_work[entry] = 0.5 * (lower + upper);
    }
    if (!invert(n, m_work, region.inverse, 1e-100))
      return false;
    // C J piece by piece: what the rows have in common cancels before the hull is taken.
    region.bounds.assign(n * n, 0);
    m_work.resize(n);
    for (int j = 0; j < n; ++j) {
      const double* inverse = region.inverse.data() + j * n;
      for (std::size_t c = 0; c < m_lower.size(); c += n * n) {
        contraction_row(
            n, n, j, inverse,
            [&](int i, int k) { return Derivative_range(m_lower[c + i * n + k], m_upper[c + i * n + k]); },
            m_work.data());
        for (int k = 0; k < n; ++k) {
          if (!(m_work[k] < HUGE_VAL))
            return false;   // an overflow bounds nothing, and maxima would lose a NaN
          region.bounds[j * n + k] = (std::max)(region.bounds[j * n + k], m_work[k]);
        }
      }
    }
    m_step.assign(n, 0);
    m_slack.assign(n, 0);
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const long exponent = (std::max)(-2000L, (std::min)(m_values[i].exponent - region.scale[i], 2000L));
        const double value = region.inverse[j * n + i] * std::ldexp(m_values[i].mantissa, static_cast<int>(exponent));
        m_step[j] += value;
        m_slack[j] += analysis_error * std::abs(value);
      }
      if (!std::isfinite(m_step[j]))
        return false;
    }
    return true;
  }

  /*
  With Q >= |I - C J| and weights d such that Q d <= q d with q < 1, s -> s - C f(s) contracts the whole box in the norm
  max |s_j| / d_j: it holds at most one root, which lies in the ball of radius |C f(c)| / (1 - q) around the centre c;
  if the ball lies in the box, the ball is mapped into itself and holds one. At a kink no other norm may do: what jumps
  from one side to the other does not become smaller with the box.
  */
  Verdict test_image(Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension;
    // The centre is a coordinate, not quite the middle of the box: distances from it reach a little further than one
    // half.
    m_off_centre = 0;
    for (int j = 0; j < n; ++j) {
      const double width = CGAL::to_double(Coordinate(region.upper[j] - region.lower[j]));
      const double place = CGAL::to_double(Coordinate(m_centre[j] - region.lower[j])) / width;
      m_off_centre = (std::max)(m_off_centre, std::abs(place - 0.5) + analysis_error);
    }
    const double reach = 0.5 + m_off_centre;
    for (int j = 0; j < n; ++j) {
      double sum = 0;
      for (int k = 0; k < n; ++k)
        sum += region.bounds[j * n + k] * (1 + analysis_error);
      if (std::abs(m_step[j]) - m_slack[j] > reach * (1 + sum))
        return NO_ROOT;
    }
    weigh(region);
    if (!(region.contraction < 1))
      return OPEN;
    bool is_inside = true;
    for (int j = 0; j < n; ++j)
      is_inside = is_inside && m_radius * region.weights[j] < 0.5 - m_off_centre;
    return is_inside ? ONE_ROOT : OPEN;
  }

  // Chooses the weights d in (0, 1] and q < 1 with Q d <= q d: of the steps from ones towards the eigenvector of Q,
  // those with the smallest ball.
  void weigh(Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension;
    region.contraction = m_radius = HUGE_VAL;
    m_trial.assign(n, 1.0);
    m_image.resize(n);
    for (int round = 0; round < 30; ++round) {
      double q = 0, radius = 0, largest = 0;
      for (int j = 0; j < n; ++j) {
        m_image[j] = 0;
        for (int k = 0; k < n; ++k)
          m_image[j] += region.bounds[j * n + k] * m_trial[k];
        q = (std::max)(q, m_image[j] / m_trial[j] * (1 + analysis_error));
        radius = (std::max)(radius, (std::abs(m_step[j]) + m_slack[j]) / m_trial[j] * (1 + analysis_error));
        largest = (std::max)(largest, m_image[j]);
      }
      radius = q < 1 ? radius / (1 - q) * (1 + analysis_error) : HUGE_VAL;
      if (radius < m_radius) {
        region.contraction = q;
        region.weights = m_trial;
        m_radius = radius;
      }
      if (!(largest > 0) || !(largest < HUGE_VAL))
        break;
      for (int j = 0; j < n; ++j)
        m_trial[j] = 0.1 * m_trial[j] + 0.9 * m_image[j] / largest;
    }
  }

  // Makes room for the ball that holds the roots of the box; false when there is no ball, or it is much larger than the
  // box.
  bool enlarge(Certified_region<Coordinate>& region) const
  {
    if (!(m_radius < 64))
      return false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const double width = CGAL::to_double(Coordinate(region.upper[j] - region.lower[j]));
      const double margin = width * (std::max)(0.0, 2 * m_radius * region.weights[j] + 2 * m_off_centre - 0.4);
      region.lower[j] = below(region.lower[j], margin);
      region.upper[j] = above(region.upper[j], margin);
    }
    return true;
  }

  // For all pieces that meet the box, each extended to the whole box; the values at its centre on the way.
  void bound_derivatives(Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension;
    if (!m_view)
      m_view.emplace(m_layout);
    m_coefficients.resize(m_layout.size);
    m_errors.resize(m_layout.errors);
    m_centre.resize(n);
    for (int j = 0; j < n; ++j)
      m_centre[j] = place_between(region.lower[j], region.upper[j], 0.5);
    m_source.evaluate(m_source.cell_of(std::span<const Coordinate>(m_centre)), std::span<const Coordinate>(m_centre),
                      m_values);
    m_lower.clear();
    m_upper.clear();
    bool is_first = true;
    std::vector<long> scale;
    m_source.visit_cells(
        std::span<const Coordinate>(region.lower), std::span<const Coordinate>(region.upper), [&](const Cell& cell) {
          m_source.bernstein_coefficients(cell, std::span<const Coordinate>(region.lower),
                                          std::span<const Coordinate>(region.upper), m_coefficients.data(),
                                          m_errors.data(), scale);
          if (is_first)
            region.scale = scale;
          is_first = false;
          m_view->reset(m_coefficients.data(), m_errors.data());
          for (int i = 0; i < n; ++i) {
            const int shift = static_cast<int>((std::max)(-2000L, (std::min)(scale[i] - region.scale[i], 2000L)));
            for (int j = 0; j < n; ++j) {
              m_lower.push_back(std::ldexp(m_view->derivative_lower(i)[j], shift));
              m_upper.push_back(std::ldexp(m_view->derivative_upper(i)[j], shift));
            }
          }
        });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_PIECEWISE_CERTIFICATION_H
