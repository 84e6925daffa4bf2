// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_SEARCH_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Distance_form.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Part_function.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Piece_point.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/newton_steps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Where two pieces may be nearest to each other: parameters of both, in ranges that hold exactly one pair of points
// where the derivatives by the parameters inside of the pieces are zero.
template <int d>
struct Nearest_candidate
{
  std::array<std::array<int, 2>, 2> cells{}; // of the pieces
  std::array<int, 2> sides{-1, -1};          // of each parameter: -1 inside of the piece, or the end where it is
  std::array<double, 2> parameters{};        // in the pieces
  std::array<Double_range, 2> ranges{};
  Interval squared_distance;
  double deviation = 0; // from the squared distance at the parameters
  std::array<std::array<Interval, d>, 2> points;
};

/*
The nearest points of two Bezier pieces with one or two parameters together, by branch and bound on the Bernstein
coefficients of their squared distance f. A part is left out if its coefficients are greater than the squared distance
of two points that are known, or if f is monotone along an axis; only the face remains where that is an edge of the
piece.

On a part where the second derivatives show f to be strongly convex, it has one minimum at most. Let m be a lower bound
of the eigenvalues of the second derivative, x a point that Newton's method finds, and r = |grad f(x)| / m. On the
sphere of radius 2r around x, f is not less than at x; if it is inside of the part, so is the minimum. It is at most r
away from x, and f is less there by m r^2 / 2 at most. That is a candidate, and nothing else of the part is one.
*/
template <int d>
class Piece_search
{
  using Candidate = Nearest_candidate<d>;
  using Part = Bernstein_part;

  static constexpr std::size_t most_parts = 600;

  enum class Edge
  {
    NONE,
    REACHED,
    MISSED
  };

  // Bounds of f - |c|^2 on a part, and of its derivatives times the weight.
  struct Bounds
  {
    Interval value;
    std::array<Interval, 2> slopes;
  };

  double m_upper = std::numeric_limits<double>::infinity();
  double m_undecided = std::numeric_limits<double>::infinity(); // lower bound of what is
  std::size_t m_number_of_parts = 0;
  std::vector<Candidate> m_candidates;
  Candidate m_best; // of the points that were looked at
  double m_best_value = std::numeric_limits<double>::infinity();

  const Rounded_piece<d>*m_a = nullptr, *m_b = nullptr;
  std::array<std::array<int, 2>, 2> m_cells{};
  Part_stack m_parts;
  bool m_is_rational = false, m_is_finite = true;
  Interval m_constant;

public:
  // Forgets everything but its storage.
  void restart()
  {
    m_upper = m_undecided = m_best_value = std::numeric_limits<double>::infinity();
    m_number_of_parts = 0;
    m_candidates.clear();
  }

  // No pair of nearest points has a larger squared distance.
  double upper() const { return m_upper; }
  // Those of all parts that are neither left out nor candidates are not less.
  double undecided() const { return m_undecided; }
  std::size_t number_of_parts() const { return m_number_of_parts; }
  std::vector<Candidate>& candidates() { return m_candidates; }
  const std::vector<Candidate>& candidates() const { return m_candidates; }

  // Two points whose distance is at most `upper()`, nearly.
  const Candidate& best() const { return m_best; }

  // Of pieces in these cells. Rounding has to be upward.
  void search(const Rounded_piece<d>& a, const Rounded_piece<d>& b, const std::array<std::array<int, 2>, 2>& cells)
  {
    m_a = &a;
    m_b = &b;
    m_cells = cells;
    const std::size_t size = size_of(a.form_degrees) * size_of(b.form_degrees);
    const Distance_form<d> form(a, b, m_parts.begin(size), size);
    m_is_rational = form.is_rational;
    m_constant = form.constant;
    m_is_finite = std::isfinite(form.greatest);
    m_parts.push(form.degrees, a.axes + b.axes, m_is_rational ? 2 : 1, {form.error, form.weight_error},
                 {form.greatest, form.greatest_weight});
    while (!m_parts.empty()) {
      ++m_number_of_parts;
      look_at(m_parts.top());
    }
  }

private:
  // \pre The part is the last one.
  Part_function function_on(const Part& part)
  {
    return {part, m_parts.coefficients(), m_is_rational ? m_parts.coefficients(1) : nullptr};
  }

  // Leaves the last part out, makes it a candidate, or divides it.
  void look_at(Part& part)
  {
    Bounds bounds;
    double lower = 0;
    for (Edge edge = Edge::REACHED; edge == Edge::REACHED;) {
      bounds.value = function_on(part).value();
      lower = (m_constant + bounds.value).inf();
      edge = lower > m_upper ? Edge::MISSED : restrict_to_edge(part, bounds);
      if (edge == Edge::MISSED) {
        m_parts.pop();
        return;
      }
      look_at_corners(part);
    }
    if (part.sides[0] >= 0 && part.sides[1] >= 0)
      add_corner(part);
    else if (const double least = function_on(part).least_eigenvalue(bounds.value, bounds.slopes);
             least > 0 && add_minimum(part, least)) {
    } else if (m_number_of_parts <= most_parts && m_parts.is_divisible() && m_is_finite) {
      m_parts.divide(function_on(part).most_curved_axis());
      return;
    } else
      m_undecided = std::isfinite(lower) ? (std::min)(m_undecided, lower) : -std::numeric_limits<double>::infinity();
    m_parts.pop();
  }

  // They are values of f.
  void look_at_corners(const Part& part)
  {
    for (const int i : {0, 1})
      for (const int j : {0, 1}) {
        const double upper = (m_constant + function_on(part).corner(i, j)).sup();
        if (!(upper < m_upper))
          continue;
        m_upper = upper;
        if (m_best_value > upper) {
          m_best_value = upper;
          m_best.cells = m_cells;
          m_best.parameters = {i == 0 ? part.begin[0] : part.end[0], j == 0 ? part.begin[1] : part.end[1]};
        }
      }
  }

  // If f is monotone along an axis, only the edge of the piece is left, or nothing, where the part does not reach it.
  Edge restrict_to_edge(Part& part, Bounds& bounds)
  {
    for (const int axis : {0, 1}) {
      Interval& slope = bounds.slopes[axis] = Interval(0);
      if (part.sides[axis] >= 0)
        continue;
      slope = function_on(part).weighted_slope(axis, bounds.value);
      if (const int sign = certain_sign(slope); sign != 0)
        return m_parts.restrict_to_edge(axis, sign > 0 ? 0 : 1) ? Edge::REACHED : Edge::MISSED;
    }
    return Edge::NONE;
  }

  // The minimum of a convex part, if it is inside for certain.
  bool add_minimum(const Part& part, double least_eigenvalue)
  {
    const std::optional<Stationary_point<d>> point = stationary_point(function_on(part), part, *m_a, *m_b);
    if (!point)
      return false;
    const std::array<Interval, 2> gradient = point->gradient(part);
    const Interval square = CGAL::square(gradient[0]) + CGAL::square(gradient[1]);
    const double radius = (CGAL::sqrt(square) / Interval(least_eigenvalue)).sup();
    Candidate candidate;
    candidate.cells = m_cells;
    candidate.sides = part.sides;
    candidate.parameters = point->parameters;
    candidate.squared_distance = point->distance.squared_distance;
    candidate.points = point->distance.points;
    for (const int axis : {0, 1}) {
      const double x = point->parameters[axis], error = radius * part.width(axis) * (1 + 4 * unit);
      candidate.ranges[axis] = part.sides[axis] < 0 ? Double_range{-(error - x), x + error} : Double_range{x, x};
      const double place = (x - part.begin[axis]) / part.width(axis);
      if (part.sides[axis] < 0 && !(place - 2 * radius > part_margin && place + 2 * radius < 1 - part_margin))
        return false;
    }
    narrow_ranges(candidate, function_on(part), *point, part);
    const double lower = (candidate.squared_distance - square / Interval(2 * least_eigenvalue)).inf();
    candidate.squared_distance = Interval((std::max)(lower, 0.0), candidate.squared_distance.sup());
    add(candidate);
    return true;
  }

  void add_corner(const Part& part)
  {
    const Distance_jet<d> at(*m_a, *m_b, part.begin);
    Candidate candidate;
    candidate.cells = m_cells;
    candidate.sides = part.sides;
    candidate.parameters = part.begin;
    for (const int axis : {0, 1})
      candidate.ranges[axis] = {part.begin[axis], part.begin[axis]};
    candidate.squared_distance = at.squared_distance;
    candidate.points = at.points;
    add(candidate);
  }

  void add(const Candidate& candidate)
  {
    const double lower = candidate.squared_distance.inf(), upper = candidate.squared_distance.sup();
    if (!(upper >= 0)) // not a number
      m_undecided = -std::numeric_limits<double>::infinity();
    else if (lower <= m_upper) {
      m_candidates.push_back(candidate);
      m_upper = (std::min)(m_upper, upper);
      if (upper < m_best_value || m_best_value > m_upper) {
        m_best = candidate;
        m_best_value = upper;
      }
    }
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_SEARCH_H
