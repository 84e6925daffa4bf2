// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_BEZIER_ROWS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_BEZIER_ROWS_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/bernstein_doubles.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
How B-spline coefficients along an axis become Bernstein coefficients of its pieces, by blossoms: those of the piece
between the breaks a and b are the values of the blossom at a, ..., a, b, ..., b (Ramshaw 1989). All are convex
combinations.
*/
class Bezier_rows
{
  int m_degree;
  Scratch_vector<double> m_knots;
  Scratch_vector<std::size_t> m_spans; // knots[span] is the begin of a piece, knots[span + 1] its end

public:
  Bezier_rows(int degree, Scratch_vector<double> own_knots) : m_degree(degree), m_knots(std::move(own_knots))
  {
    const Scratch_vector<double>& knots = m_knots;
    const auto n = static_cast<std::size_t>(degree);
    for (std::size_t k = n; k + n + 1 < knots.size(); ++k)
      if (knots[k] < knots[k + 1])
        m_spans.push_back(k);
  }

  const Scratch_vector<double>& knots() const { return m_knots; }
  const Scratch_vector<std::size_t>& spans() const { return m_spans; }

  // Of coefficients with a number of lines beside each other, `step` from one coefficient of a line to the next; their
  // greatest error becomes that of the results. Rounding has to be upward.
  Scratch_vector<double> operator()(Scratch_vector<double> coefficients, double& error, std::size_t lines,
                                    std::size_t skip, std::size_t step) const
  {
    if (m_spans.size() == 1 && is_clamped(m_spans[0]))
      return coefficients;
    const auto order = static_cast<std::size_t>(m_degree) + 1;
    const std::size_t size = m_spans.size() * order;
    Scratch_vector<double> result(size * lines);
    Scratch_vector<Interval> control(order);
    double greatest_error = error;
    // In the result, lines are beside each other in the same way.
    const std::size_t result_skip = step == 1 ? size : 1, result_step = step == 1 ? 1 : lines;
    for (std::size_t line = 0; line < lines; ++line)
      for (std::size_t piece = 0; piece < m_spans.size(); ++piece)
        for (std::size_t j = 0; j < order; ++j) {
          const auto coefficient = [&](std::size_t i) {
            return coefficients[line * skip + (m_spans[piece] + 1 - order + i) * step];
          };
          double& value = result[line * result_skip + (piece * order + j) * result_step];
          if (is_clamped(m_spans[piece])) {
            value = coefficient(j);
            continue;
          }
          for (std::size_t i = 0; i < order; ++i)
            control[i] = Interval(coefficient(i)) + Interval(-error, error);
          const Interval blossom = blossom_at(m_spans[piece], control, j);
          value = blossom.inf() / 2 + blossom.sup() / 2;
          greatest_error = (std::max)(greatest_error, (std::max)(value - blossom.inf(), blossom.sup() - value));
        }
    error = greatest_error;
    return result;
  }

private:
  bool is_clamped(std::size_t span) const
  {
    const auto n = static_cast<std::size_t>(m_degree);
    return n == 0 || (m_knots[span + 1 - n] == m_knots[span] && m_knots[span + n] == m_knots[span + 1]);
  }

  // With the end of the piece as the last `ends` arguments, its begin as the others.
  Interval blossom_at(std::size_t span, Scratch_vector<Interval>& control, std::size_t ends) const
  {
    const auto n = static_cast<std::size_t>(m_degree);
    for (std::size_t r = 1; r <= n; ++r) {
      const double x = r + ends > n ? m_knots[span + 1] : m_knots[span];
      for (std::size_t j = n; j >= r; --j) {
        const double low = m_knots[span - n + j], high = m_knots[span + j + 1 - r];
        const Interval weight = (Interval(x) - Interval(low)) / (Interval(high) - Interval(low));
        control[j] = control[j - 1] + weight * (control[j] - control[j - 1]);
      }
    }
    return control[n];
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_BEZIER_ROWS_H
