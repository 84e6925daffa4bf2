// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_CROSSING_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_CROSSING_SEARCH_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/doubles/Crossing_proof.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/doubles/Halved_curve.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
All common points of two planar polynomial Bezier curves over [0,1] that cross in all of them, in doubles with bounds of
errors and without exact numbers.

Parts of both curves are halved until they are apart, or meet once at most since none of their tangents are parallel. In
the latter case Newton's method finds a common point, which has then to be proved, in these parts or just outside of
them; if it finds none, parts are halved further, and are apart soon. A point just outside of parts is one of their
neighbours', too, or has a parameter outside of [0,1]; it is found once, as the parts of the neighbours that hold it are
done with.
*/
class Crossing_search
{
  using Coordinates = std::array<std::span<const double>, 2>;
  using Parts = std::array<std::size_t, 2>;
  static constexpr double least_width = 0x1p-30;
  static constexpr double least_size = 0x1p-300, greatest_size = 0x1p+300; // products are far from under- and overflow

  std::array<Halved_curve, 2> m_curves;
  Crossing_proof m_proof;
  double m_size;
  Scratch_vector<Crossing> m_crossings;
  Scratch_vector<Solution_d<double>> m_solutions; // of the same number
  std::size_t m_nodes = 0;

public:
  Crossing_search(const Coordinates& first, const Coordinates& second)
    : m_curves{Halved_curve(first), Halved_curve(second)}, m_proof(first, second),
      m_size((std::max)(m_curves[0].size(), m_curves[1].size()))
  {}

  static bool can_search(const Coordinates& curve)
  {
    const std::size_t size = curve[0].size();
    return 1 < size && size <= Halved_curve::greatest_degree + 1 &&
        std::all_of(curve.begin(), curve.end(), [](std::span<const double> coefficients) {
             return std::all_of(coefficients.begin(), coefficients.end(),
                                [](double c) { return std::abs(c) < greatest_size; });
           });
  }

  // The pairs of parameters of common points; nothing where not all of them are proved to be crossings. A range that
  // goes beyond [0,1] holds the only solution near it, which may be beyond it.
  std::optional<Scratch_vector<Solution_d<double>>> operator()(std::size_t most_nodes)
  {
    if (!(m_size > least_size))
      return std::nullopt;
    Scratch_vector<Parts> tasks;
    tasks.reserve(64);
    tasks.push_back({0, 0});
    while (!tasks.empty()) {
      const Parts parts = tasks.back();
      tasks.pop_back();
      if (++m_nodes > most_nodes)
        return std::nullopt;
      const State state = look_at(parts);
      if (state == State::FAILED)
        return std::nullopt;
      if (state == State::OPEN && !halve(parts, tasks))
        return std::nullopt;
    }
    return std::move(m_solutions);
  }

  // Pairs of parts that were looked at.
  std::size_t nodes() const { return m_nodes; }

private:
  enum class State
  {
    DONE,
    OPEN,
    FAILED
  };

  const Halved_curve::Part& part(const Parts& parts, std::size_t k) const { return m_curves[k][parts[k]]; }

  State look_at(const Parts& parts)
  {
    const Halved_curve::Part &a = part(parts, 0), &b = part(parts, 1);
    if (are_apart(m_curves[0], a, m_curves[1], b, m_size))
      return State::DONE;
    if (!meet_once_at_most(m_curves[0], a, m_curves[1], b))
      return State::OPEN;
    if (std::any_of(m_crossings.begin(), m_crossings.end(),
                    [&](const Crossing& crossing) { return are_around(a, b, crossing.ranges); }))
      return State::DONE;
    const std::optional<Crossing> crossing = crossing_of(a, b);
    if (!crossing || !are_around(a, b, crossing->ranges))
      return State::OPEN;
    return add(*crossing, a, b) ? State::DONE : State::FAILED;
  }

  // The range of a part and of what continues it.
  static std::pair<double, double> range_of(const Halved_curve::Part& part)
  {
    const double margin = Halved_curve::margin * part.width;
    return {part.begin - margin, part.begin + part.width + margin};
  }

  static bool are_around(const Halved_curve::Part& a, const Halved_curve::Part& b,
                         const std::array<std::pair<double, double>, 2>& ranges)
  {
    return is_in(ranges[0], range_of(a)) && is_in(ranges[1], range_of(b));
  }

  static bool is_in(const std::pair<double, double>& range, const std::pair<double, double>& outer)
  {
    return outer.first <= range.first && range.second <= outer.second;
  }

  // One in or near two parts that meet once at most, if Newton's method finds one.
  std::optional<Crossing> crossing_of(const Halved_curve::Part& a, const Halved_curve::Part& b) const
  {
    constexpr int most_steps = 10;
    constexpr double last_step = 0x1p-28;
    double u = 0.5, v = 0.5;
    for (int k = 0; k < most_steps; ++k) {
      const auto p = m_curves[0].position(a, u), q = m_curves[1].position(b, v);
      const Plane_vector difference = p.point - q.point;
      const double det = determinant(p.derivative, q.derivative);
      const double x = determinant(q.derivative, difference) / det, y = determinant(p.derivative, difference) / det;
      u += x;
      v += y;
      if (!(std::abs(u - 0.5) < 1 && std::abs(v - 0.5) < 1))
        return std::nullopt;
      if ((std::max)(std::abs(x), std::abs(y)) < last_step)
        return is_near(u) && is_near(v) ? m_proof({a.begin + u * a.width, b.begin + v * b.width},
                                                  (1 / a.width) * p.derivative, (1 / b.width) * q.derivative)
                                        : std::nullopt;
    }
    return std::nullopt;
  }

  // Whether a place is in a part or what continues it.
  static bool is_near(double place) { return -Halved_curve::margin <= place && place <= 1 + Halved_curve::margin; }

  // Whether it is certainly one of those that are known, or none of them.
  bool add(const Crossing& crossing, const Halved_curve::Part& a, const Halved_curve::Part& b)
  {
    for (const Crossing& known : m_crossings) {
      const auto meet = [&](std::size_t k) {
        return crossing.ranges[k].first <= known.around[k].second && known.around[k].first <= crossing.ranges[k].second;
      };
      if (meet(0) && meet(1))
        return is_in(crossing.ranges[0], known.around[0]) && is_in(crossing.ranges[1], known.around[1]);
    }
    m_crossings.push_back(crossing);
    const auto is_outside = [](const std::pair<double, double>& range) { return range.second < 0 || range.first > 1; };
    if (!is_outside(crossing.ranges[0]) && !is_outside(crossing.ranges[1]))
      m_solutions.emplace_back(Solution_kind::CERTIFIED,
                               Solution_d<double>::Box(crossing.ranges.begin(), crossing.ranges.end()),
                               Solution_d<double>::Box{range_of(a), range_of(b)}, "double", Undecided_reason::NONE, 1);
    return true;
  }

  // Makes the pairs of halves tasks, if they are not too short.
  bool halve(const Parts& parts, Scratch_vector<Parts>& tasks)
  {
    if ((std::min)(part(parts, 0).width, part(parts, 1).width) < least_width)
      return false;
    const std::size_t first = m_curves[0].halves(parts[0]), second = m_curves[1].halves(parts[1]);
    for (const std::size_t i : {0, 1})
      for (const std::size_t k : {0, 1})
        tasks.push_back({first + i, second + k});
    return true;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_CROSSING_SEARCH_H
