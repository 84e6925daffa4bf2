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
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

Parts are not halved: nearest points of symmetric operands are at halves.
*/
template <int d>
class Piece_search
{
  using Candidate = Nearest_candidate<d>;
  using Part = Distance_part;

  static constexpr double cut = 0.46875;    // of a part
  static constexpr double margin = 0x1p-16; // of a part, inside of its edges
  static constexpr double least_width = 0x1p-24;
  static constexpr std::size_t most_slots = 64, most_parts = 400;

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
  std::vector<double> m_storage;
  std::vector<Part> m_parts;
  std::size_t m_size = 0; // of a tensor
  bool m_is_rational = false;
  Interval m_constant;
  double m_greatest = 0, m_greatest_weight = 0;

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
    m_size = size_of(a.form_degrees) * size_of(b.form_degrees);
    m_storage.resize((std::max)(m_storage.size(), 2 * m_size * most_slots));
    const Distance_form<d> form(a, b, m_storage.data(), m_size);
    m_is_rational = form.is_rational;
    m_constant = form.constant;
    m_greatest = form.greatest;
    m_greatest_weight = form.greatest_weight;
    m_parts.clear();
    m_parts.reserve(most_slots);
    m_parts.push_back({form.degrees, {0, 0}, {1, 1}, {-1, -1}, form.error, form.weight_error});
    for (const int axis : {0, 1})
      if (axis >= a.axes + b.axes)
        m_parts[0].sides[axis] = 0;
    while (!m_parts.empty()) {
      ++m_number_of_parts;
      look_at(m_parts.back());
    }
  }

private:
  double* values() { return m_storage.data() + 2 * m_size * (m_parts.size() - 1); }
  double* weights() { return values() + m_size; }

  // \pre The part is the last one.
  Part_function function_on(const Part& part) { return {part, values(), m_is_rational ? weights() : nullptr}; }

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
        m_parts.pop_back();
        return;
      }
      look_at_corners(part);
    }
    if (part.sides[0] >= 0 && part.sides[1] >= 0)
      add_corner(part);
    else if (const double least = function_on(part).least_eigenvalue(bounds.value, bounds.slopes);
             least > 0 && add_minimum(part, least)) {
    } else if (m_number_of_parts <= most_parts && m_parts.size() < most_slots && !is_tiny(part) &&
               std::isfinite(m_greatest)) {
      divide(part);
      return;
    } else
      m_undecided = std::isfinite(lower) ? (std::min)(m_undecided, lower) : -std::numeric_limits<double>::infinity();
    m_parts.pop_back();
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
      const int side = certain_sign(slope) > 0 ? 0 : 1;
      if (certain_sign(slope) == 0)
        continue;
      if ((side == 0 ? part.begin[axis] : part.end[axis]) != side)
        return Edge::MISSED;
      Degrees degrees = part.degrees;
      if (m_is_rational)
        restrict_to_face(degrees, axis, side, weights());
      degrees = part.degrees;
      restrict_to_face(degrees, axis, side, values());
      part.degrees = degrees;
      part.sides[axis] = side;
      part.begin[axis] = part.end[axis] = side;
      return Edge::REACHED;
    }
    return Edge::NONE;
  }

  // The minimum of a convex part, if it is inside for certain.
  bool add_minimum(const Part& part, double least_eigenvalue)
  {
    std::array<double, 2> place;
    Second_jet<double> jet;
    if (!find_minimum(part, place, jet))
      return false;
    std::array<double, 2> x, width;
    for (const int axis : {0, 1}) {
      width[axis] = part.end[axis] - part.begin[axis];
      x[axis] = part.begin[axis] + place[axis] * width[axis];
    }
    const std::array<double, 2> first_x = x;
    Distance_jet<d> at(*m_a, *m_b, x);
    // One more step with a gradient that has all digits.
    std::array<double, 2> gradient;
    for (const int axis : {0, 1})
      gradient[axis] =
          part.sides[axis] >= 0 ? 0 : (at.half_gradient[axis].inf() + at.half_gradient[axis].sup()) * width[axis];
    const std::array<double, 2> step = newton_step(part, jet, gradient);
    bool is_better = false;
    for (const int axis : {0, 1}) {
      const double distance = part.sides[axis] >= 0 ? 0 : step[axis] * width[axis];
      x[axis] += distance;
      is_better = is_better || std::abs(distance) > unit;
    }
    if (is_better)
      at = Distance_jet<d>(*m_a, *m_b, x);
    else
      x = first_x;
    Interval square(0);
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0)
        square += CGAL::square(Interval(2 * width[axis]) * at.half_gradient[axis]);
    const double radius = (CGAL::sqrt(square) / Interval(least_eigenvalue)).sup();
    Candidate candidate{m_cells, part.sides, x, {}, at.squared_distance, at.points};
    for (const int axis : {0, 1}) {
      candidate.ranges[axis] = {x[axis], x[axis]};
      if (part.sides[axis] >= 0)
        continue;
      const double place_in_part = (x[axis] - part.begin[axis]) / width[axis];
      if (!(place_in_part - 2 * radius > margin && place_in_part + 2 * radius < 1 - margin))
        return false;
      const double error = radius * width[axis] * (1 + 4 * unit);
      candidate.ranges[axis] = {-(error - x[axis]), x[axis] + error};
    }
    contract(part, at, width, candidate);
    const double lower = (at.squared_distance - square / Interval(2 * least_eigenvalue)).inf();
    candidate.squared_distance = Interval((std::max)(lower, 0.0), at.squared_distance.sup());
    add(candidate);
    return true;
  }

  // A step of Newton's method in intervals, with the second derivatives on the ranges that are known: these have a
  // smaller least eigenvalue than the whole part.
  void contract(const Part& part, const Distance_jet<d>& at, const std::array<double, 2>& width, Candidate& candidate)
  {
    std::array<Interval, 2> place{Interval(0), Interval(0)}, gradient = place, step = place;
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0) {
        const Double_range& range = candidate.ranges[axis];
        place[axis] = (Interval(range.lower, range.upper) - Interval(part.begin[axis])) / Interval(width[axis]);
        gradient[axis] = Interval(2 * width[axis]) * at.half_gradient[axis];
      }
    const Second_jet<Interval> jet = function_on(part).jet(place);
    if (part.sides[0] < 0 && part.sides[1] < 0) {
      const Interval determinant = jet.second[0] * jet.second[1] - CGAL::square(jet.mixed);
      step = {(jet.mixed * gradient[1] - jet.second[1] * gradient[0]) / determinant,
              (jet.mixed * gradient[0] - jet.second[0] * gradient[1]) / determinant};
    } else
      for (const int axis : {0, 1})
        step[axis] = part.sides[axis] < 0 ? -gradient[axis] / jet.second[axis] : Interval(0);
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0) {
        const Interval better = Interval(candidate.parameters[axis]) + step[axis] * Interval(width[axis]);
        Double_range& range = candidate.ranges[axis];
        range = {better.inf() > range.lower ? better.inf() : range.lower,
                 better.sup() < range.upper ? better.sup() : range.upper};
        candidate.parameters[axis] = (std::min)((std::max)(candidate.parameters[axis], range.lower), range.upper);
      }
  }

  static std::array<double, 2> newton_step(const Part& part, const Second_jet<double>& f,
                                           const std::array<double, 2>& gradient)
  {
    if (part.sides[0] >= 0)
      return {0, -gradient[1] / f.second[1]};
    if (part.sides[1] >= 0)
      return {-gradient[0] / f.second[0], 0};
    const double determinant = f.second[0] * f.second[1] - f.mixed * f.mixed;
    return {(f.mixed * gradient[1] - f.second[1] * gradient[0]) / determinant,
            (f.mixed * gradient[0] - f.second[0] * gradient[1]) / determinant};
  }

  // By Newton's method; false if it goes to an edge of the part.
  bool find_minimum(const Part& part, std::array<double, 2>& place, Second_jet<double>& jet)
  {
    place = {part.sides[0] >= 0 ? 0 : 0.5, part.sides[1] >= 0 ? 0 : 0.5};
    for (int i = 0; i < 8; ++i) {
      jet = function_on(part).jet(place);
      const std::array<double, 2> step = newton_step(part, jet, {jet.first[0], jet.first[1]});
      double length = 0;
      for (const int axis : {0, 1}) {
        if (part.sides[axis] >= 0)
          continue;
        length = (std::max)(length, std::abs(step[axis]));
        place[axis] += step[axis];
        if (!(place[axis] > -0.5 && place[axis] < 1.5))
          return false;
        place[axis] = (std::min)((std::max)(place[axis], 0.0), 1.0);
      }
      if (length < 0x1p-20)
        break;
    }
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0 && !(place[axis] > margin && place[axis] < 1 - margin))
        return false;
    return true;
  }

  void add_corner(const Part& part)
  {
    const Distance_jet<d> at(*m_a, *m_b, part.begin);
    add({m_cells,
         part.sides,
         part.begin,
         {Double_range{part.begin[0], part.begin[0]}, Double_range{part.begin[1], part.begin[1]}},
         at.squared_distance,
         at.points});
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

  bool is_tiny(const Part& part) const
  {
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0 && part.end[axis] - part.begin[axis] > least_width)
        return false;
    return true;
  }

  // Across the axis along which f is least linear. The half that may be nearer is last.
  void divide(Part& part)
  {
    const int axis = function_on(part).most_curved_axis();
    const std::size_t size = size_of(part.degrees);
    double *lower = values(), *upper = lower + 2 * m_size;
    split(part.degrees, axis, cut, lower, upper);
    if (m_is_rational)
      split(part.degrees, axis, cut, lower + m_size, upper + m_size);
    part.error += split_error(part.degrees, axis) * m_greatest;
    part.weight_error += split_error(part.degrees, axis) * m_greatest_weight;
    Part other = part;
    part.end[axis] = other.begin[axis] = part.begin[axis] + cut * (part.end[axis] - part.begin[axis]);
    if (*std::min_element(lower, lower + size) < *std::min_element(upper, upper + size)) {
      std::swap(part, other);
      std::swap_ranges(lower, lower + 2 * m_size, upper);
    }
    m_parts.push_back(other);
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PIECE_SEARCH_H
