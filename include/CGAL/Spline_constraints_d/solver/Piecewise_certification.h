// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PIECEWISE_CERTIFICATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PIECEWISE_CERTIFICATION_H

#include <CGAL/Spline_constraints_d/solver/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Root_refinement.h>
#include <CGAL/Spline_constraints_d/solver/matrix_inverse.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Certification on a box that reaches over a break, where a spline is another polynomial on the other side. A root there is never certified on the extension
of one piece: a continuous piecewise polynomial satisfies f(x) - f(z) = J (x - z) with J in the convex hull of the Jacobians of all pieces that meet
the box (the segment argument holds piece by piece), so Krawczyk's operator with *one* C and the hull over the pieces proves as much as it does for one polynomial.
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
  Node_view m_view;
  std::vector<double> m_coefficients, m_errors;
  std::vector<double> m_work, m_lower, m_upper;   // equalities x unknowns: derivatives in box coordinates, functions scaled by 2^-scale
  std::vector<Exact_source::Value> m_values;
  std::vector<Coordinate> m_centre;

public:
  Piecewise_certification(const System_layout& layout, Exact_source& source)
    : m_layout(layout), m_source(source), m_view(layout), m_coefficients(layout.size), m_errors(layout.errors)
  {}

  // The box reaches beyond the breaks around a cell, into another cell.
  bool crosses_break(const Cell& cell, const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper) const
  {
    for (int v = 0; v < m_layout.dimension; ++v) {
      const std::vector<Exact_rational>& breaks = m_source.breaks(v);
      if (breaks.size() > 2 && ((cell[v] > 0 && Exact_rational(lower[v]) < breaks[cell[v]]) ||
                                (cell[v] + 2 < static_cast<int>(breaks.size()) && breaks[cell[v] + 1] < Exact_rational(upper[v]))))
        return true;
    }
    return false;
  }

  // Decides the box of the region and fills in the proof. Only for as many equalities as unknowns.
  Verdict certify(Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension;
    if (m_layout.equalities != n)
      return OPEN;
    bound_derivatives(region);
    region.inverse.resize(n * n);
    region.bounds.resize(n * n);
    m_work.resize(n * n);
    for (int i = 0; i < n * n; ++i)
      m_work[i] = 0.5 * (m_lower[i] + m_upper[i]);
    if (!invert(n, m_work, region.inverse))
      return OPEN;

    // The centre is a coordinate, not quite the middle of the box: distances from it reach a little further than one half.
    double off_centre = 0;
    for (int j = 0; j < n; ++j) {
      const double width = CGAL::to_double(Coordinate(region.upper[j] - region.lower[j]));
      const double place = CGAL::to_double(Coordinate(m_centre[j] - region.lower[j])) / width;
      off_centre = (std::max)(off_centre, std::abs(place - 0.5) + analysis_error);
    }
    const double reach = 0.5 + off_centre;

    bool is_mapped_inside = true;
    region.contraction = 0;
    for (int j = 0; j < n; ++j) {
      const double* inverse = region.inverse.data() + j * n;
      const double sum = contraction_row(
        n, n, j, inverse, [&](int i, int k) { return m_lower[i * n + k]; }, [&](int i, int k) { return m_upper[i * n + k]; },
        region.bounds.data() + j * n);
      double step = 0, slack = 0;
      for (int i = 0; i < n; ++i) {
        const long exponent = (std::max)(-2000L, (std::min)(m_values[i].exponent - region.scale[i], 2000L));
        const double value = std::ldexp(m_values[i].mantissa, static_cast<int>(exponent));
        step += inverse[i] * value;
        slack += analysis_error * std::abs(inverse[i] * value);
      }
      if (std::abs(step) - slack > reach * (1 + sum))
        return NO_ROOT;
      is_mapped_inside = is_mapped_inside && std::abs(step) + slack + reach * sum < 0.5 - off_centre;
      region.contraction = (std::max)(region.contraction, sum);
    }
    return is_mapped_inside ? ONE_ROOT : OPEN;
  }

private:
  // The hull over all pieces that meet the box, each extended to the whole box; the values at its centre on the way.
  void bound_derivatives(Certified_region<Coordinate>& region)
  {
    const int n = m_layout.dimension;
    m_centre.resize(n);
    for (int j = 0; j < n; ++j)
      m_centre[j] = place_between(region.lower[j], region.upper[j], 0.5);
    m_source.evaluate(m_source.cell_of(std::span<const Coordinate>(m_centre)), std::span<const Coordinate>(m_centre), m_values);
    m_lower.assign(n * n, HUGE_VAL);
    m_upper.assign(n * n, -HUGE_VAL);
    bool is_first = true;
    std::vector<long> scale;
    m_source.visit_cells(std::span<const Coordinate>(region.lower), std::span<const Coordinate>(region.upper), [&](const Cell& cell) {
      m_source.bernstein_coefficients(cell, std::span<const Coordinate>(region.lower), std::span<const Coordinate>(region.upper),
                                      m_coefficients.data(), m_errors.data(), scale);
      if (is_first)
        region.scale = scale;
      is_first = false;
      m_view.reset(m_coefficients.data(), m_errors.data());
      for (int i = 0; i < n; ++i) {
        const int shift = static_cast<int>((std::max)(-2000L, (std::min)(scale[i] - region.scale[i], 2000L)));
        for (int j = 0; j < n; ++j) {
          m_lower[i * n + j] = (std::min)(m_lower[i * n + j], std::ldexp(m_view.derivative_lower(i)[j], shift));
          m_upper[i * n + j] = (std::max)(m_upper[i * n + j], std::ldexp(m_view.derivative_upper(i)[j], shift));
        }
      }
    });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PIECEWISE_CERTIFICATION_H
