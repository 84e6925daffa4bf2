// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_RAY_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_RAY_SEARCH_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Part_stack.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Piece_point.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Rounded_spline.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Where a ray meets a spline: ranges that hold exactly one common point.
template <int d>
struct Ray_hit
{
  std::array<int, 2> cell{};
  std::array<Double_range, 2> ranges{}; // in the piece
  Interval along;                       // the parameter of the ray
  std::array<Interval, d> point;
};

/*
The common points of a ray o + t v and a spline with d - 1 parameters, from the source on, as far as doubles decide.

With the coordinate i in which v is longest, the point x/w is on the line where v_i (x_j - o_j w) - v_j (x_i - o_i w) is
zero for all other j: d - 1 equations. A part of a piece is left out if the coefficients of one have one sign. Where
Newton's method in intervals stays inside of a part, this has exactly one common point.
*/
template <int d>
class Ray_search
{
  using Hit = Ray_hit<d>;
  using Node = typename Rounded_spline<d>::Node;
  using Vector = std::array<Interval, d>;

  static constexpr int equations = d - 1;
  static constexpr double margin = 0x1p-16;      // of a part, inside of its edges
  static constexpr std::size_t most_parts = 400; // of a piece

  struct Task
  {
    double begin; // a lower bound of the parameters of the ray
    int node;
  };

  std::array<double, d> m_source;
  Vector m_direction;
  Interval m_squared_length;
  int m_axis = 0; // along which the direction is longest
  Part_stack m_parts;
  std::vector<Task> m_tasks;
  std::vector<Hit> m_hits;
  double m_upper = 0, m_undecided = 0;

public:
  // The first one, and others whose order along the ray is not known. The direction is known as intervals. Rounding has
  // to be upward.
  void find_first(const std::array<double, d>& source, const Vector& direction, const Rounded_spline<d>& spline)
  {
    m_source = source;
    m_direction = direction;
    m_squared_length = Interval(0);
    m_axis = 0;
    for (int i = 0; i < d; ++i) {
      m_squared_length += CGAL::square(direction[i]);
      if (magnitude(direction[i]) > magnitude(direction[m_axis]))
        m_axis = i;
    }
    m_hits.clear();
    m_upper = m_undecided = std::numeric_limits<double>::infinity();
    m_tasks.clear();
    push(spline, 0);
    while (!m_tasks.empty()) {
      const Task task = m_tasks.back();
      m_tasks.pop_back();
      const Node& node = spline.node(task.node);
      if (task.begin > m_upper)
        continue;
      if (node.child < 0)
        search(spline.piece(node.cell), node.cell, task.begin);
      else
        push_children(spline, node.child);
    }
    std::erase_if(m_hits, [&](const Hit& hit) { return hit.along.inf() > m_upper; });
  }

  // Whether the first common point, if there is one, is among the hits.
  bool is_decided() const { return m_undecided > m_upper || m_undecided == std::numeric_limits<double>::infinity(); }
  const std::vector<Hit>& hits() const { return m_hits; }

private:
  static double magnitude(const Interval& x) { return (std::max)(-x.inf(), x.sup()); }

  static Interval range_of(const Node& node, int axis) { return {node.box.lower[axis], node.box.upper[axis]}; }

  // The parameters at which the ray is in a box; none if it passes by.
  std::optional<Interval> parameters_in(const Node& node) const
  {
    Interval result(0, std::numeric_limits<double>::infinity());
    for (int i = 0; i < d; ++i) {
      const Interval offset = range_of(node, i) - Interval(m_source[i]);
      if (certain_sign(m_direction[i]) == 0) {
        if (m_direction[i].inf() == 0 && m_direction[i].sup() == 0 && certain_sign(offset) != 0)
          return std::nullopt;
        continue;
      }
      const Interval own = offset / m_direction[i];
      const double lower = (std::max)(result.inf(), own.inf()), upper = (std::min)(result.sup(), own.sup());
      if (lower > upper)
        return std::nullopt;
      result = Interval(lower, upper);
    }
    return result;
  }

  void push(const Rounded_spline<d>& spline, int node)
  {
    if (const auto range = parameters_in(spline.node(node)); range && !(range->inf() > m_upper))
      m_tasks.push_back({range->inf(), node});
  }

  // The one that the ray enters first comes next.
  void push_children(const Rounded_spline<d>& spline, int child)
  {
    const std::size_t size = m_tasks.size();
    push(spline, child);
    push(spline, child + 1);
    if (m_tasks.size() == size + 2 && m_tasks[size].begin < m_tasks[size + 1].begin)
      std::swap(m_tasks[size], m_tasks[size + 1]);
  }

  // The coefficients of the equations.
  void make_equations(const Rounded_piece<d>& piece)
  {
    const std::size_t size = size_of(piece.degrees);
    double* storage = m_parts.begin(size);
    std::array<double, 2> errors{}, greatest{};
    int equation = 0;
    for (int j = 0; j < d; ++j) {
      if (j == m_axis)
        continue;
      double* f = storage + static_cast<std::size_t>(equation) * size;
      for (std::size_t k = 0; k < size; ++k) {
        const Interval value = m_direction[m_axis] * offset(piece, j, k) - m_direction[j] * offset(piece, m_axis, k);
        f[k] = value.inf() / 2 + value.sup() / 2;
        errors[equation] = (std::max)(errors[equation], value.sup() - value.inf());
      }
      greatest[equation] = greatest_magnitude(f, size) + errors[equation];
      errors[equation] += 8 * unit * greatest[equation];
      ++equation;
    }
    m_parts.push(piece.degrees, equations, equations, errors, greatest);
  }

  Interval offset(const Rounded_piece<d>& piece, int axis, std::size_t k) const
  {
    const Rounded_tensor &x = piece.points[axis], &w = piece.weights;
    const Interval numerator = Interval(x.begin[k]) + Interval(-x.error, x.error), origin(m_source[axis]);
    return piece.is_rational() ? numerator - origin * (Interval(w.begin[k]) + Interval(-w.error, w.error))
                               : numerator - origin;
  }

  void search(const Rounded_piece<d>& piece, const std::array<int, 2>& cell, double begin)
  {
    make_equations(piece);
    for (std::size_t parts = 0; !m_parts.empty();)
      if (is_left_out() || add_hit(piece, cell))
        m_parts.pop();
      else if (++parts < most_parts && m_parts.is_divisible() && std::isfinite(m_parts.top().errors[0]))
        m_parts.divide(widest_axis());
      else {
        m_undecided = (std::min)(m_undecided, begin);
        return;
      }
  }

  bool is_left_out()
  {
    const Bernstein_part& part = m_parts.top();
    const std::size_t size = size_of(part.degrees);
    for (int equation = 0; equation < equations; ++equation) {
      const auto [least, greatest] =
          std::minmax_element(m_parts.coefficients(equation), m_parts.coefficients(equation) + size);
      if (*least > part.errors[equation] || *greatest < -part.errors[equation])
        return true;
    }
    return false;
  }

  // The axis along which the functions change most.
  int widest_axis()
  {
    std::array<double, 2> change{};
    for (int axis = 0; axis < equations; ++axis)
      for (int equation = 0; equation < equations; ++equation)
        change[axis] = (std::max)(change[axis], magnitude(slope(equation, axis)));
    return change[0] >= change[1] ? 0 : 1;
  }

  Interval slope(int equation, int axis)
  {
    const Bernstein_part& part = m_parts.top();
    return Coefficient_ranges(part.degrees, m_parts.coefficients(equation), part.errors[equation]).first(axis);
  }

  template <class Number>
  using Matrix = std::array<std::array<Number, equations>, equations>;

  template <class Number>
  static Number determinant(const Matrix<Number>& m)
  {
    if constexpr (equations == 1)
      return m[0][0];
    else
      return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  }

  // The solution of m step = -values.
  template <class Number>
  static std::array<Number, 2> newton_step(const Matrix<Number>& m, const std::array<Number, equations>& values)
  {
    if constexpr (equations == 1)
      return {-values[0] / m[0][0], Number(0)};
    else {
      const Number d0 = determinant(m);
      return {(m[0][1] * values[1] - m[1][1] * values[0]) / d0, (m[1][0] * values[0] - m[0][0] * values[1]) / d0};
    }
  }

  template <class Number>
  Second_jet<Number> jet(int equation, const std::array<Number, 2>& place)
  {
    const Bernstein_part& part = m_parts.top();
    const double *f = m_parts.coefficients(equation), error = part.errors[equation];
    return jet_at<Number>(
        part.degrees,
        [&](std::size_t k) {
          if constexpr (std::is_same_v<Number, double>)
            return f[k];
          else
            return Interval(f[k]) + Interval(-error, error);
        },
        place);
  }

  // Whether the last part has just one common point with the line. It is a hit if it is not behind the source.
  bool add_hit(const Rounded_piece<d>& piece, const std::array<int, 2>& cell)
  {
    Matrix<Interval> slopes;
    for (int equation = 0; equation < equations; ++equation)
      for (int axis = 0; axis < equations; ++axis)
        slopes[equation][axis] = slope(equation, axis);
    if (certain_sign(determinant(slopes)) == 0)
      return false;
    std::array<double, 2> place{0.5, equations == 2 ? 0.5 : 0.0};
    if (!find_zero(place))
      return false;
    const std::array<Interval, 2> ranges = newton_ranges(place, slopes);
    for (int axis = 0; axis < equations; ++axis)
      if (!(place[axis] >= 0 && place[axis] <= 1 && ranges[axis].inf() > margin && ranges[axis].sup() < 1 - margin))
        return false;
    for (int equation = 0; equation < equations; ++equation) { // once more, with better bounds of the slopes
      const Second_jet<Interval> f = jet<Interval>(equation, ranges);
      for (int axis = 0; axis < equations; ++axis)
        slopes[equation][axis] = f.first[axis];
    }
    const std::array<Interval, 2> better = newton_ranges(place, slopes);
    Hit hit;
    hit.cell = cell;
    std::array<Interval, 2> parameters{Interval(0), Interval(0)};
    for (int axis = 0; axis < equations; ++axis) {
      const Bernstein_part& part = m_parts.top();
      const Interval own(better[axis].inf() > ranges[axis].inf() ? better[axis].inf() : ranges[axis].inf(),
                         better[axis].sup() < ranges[axis].sup() ? better[axis].sup() : ranges[axis].sup());
      parameters[axis] = Interval(part.begin[axis]) + own * Interval(part.width(axis));
      hit.ranges[axis] = {parameters[axis].inf(), parameters[axis].sup()};
    }
    hit.point = Piece_point<d>(piece, parameters).point;
    Interval product(0);
    for (int i = 0; i < d; ++i)
      product += (hit.point[i] - Interval(m_source[i])) * m_direction[i];
    hit.along = product / m_squared_length;
    add(hit);
    return true;
  }

  void add(const Hit& hit)
  {
    if (hit.along.inf() >= 0) {
      m_hits.push_back(hit);
      m_upper = (std::min)(m_upper, hit.along.sup());
    } else if (!(hit.along.sup() < 0))
      m_undecided = 0; // next to the source
  }

  // By Newton's method; false if it leaves the part.
  bool find_zero(std::array<double, 2>& place)
  {
    for (int i = 0; i < 8; ++i) {
      Matrix<double> slopes;
      std::array<double, equations> values;
      for (int equation = 0; equation < equations; ++equation) {
        const Second_jet<double> f = jet<double>(equation, place);
        values[equation] = f.value;
        for (int axis = 0; axis < equations; ++axis)
          slopes[equation][axis] = f.first[axis];
      }
      const std::array<double, 2> step = newton_step(slopes, values);
      double length = 0;
      for (int axis = 0; axis < equations; ++axis) {
        length = (std::max)(length, std::abs(step[axis]));
        place[axis] += step[axis];
        if (!(place[axis] > -0.5 && place[axis] < 1.5))
          return false;
      }
      if (length < 0x1p-48)
        break;
    }
    return true;
  }

  std::array<Interval, 2> newton_ranges(const std::array<double, 2>& place, const Matrix<Interval>& slopes)
  {
    const std::array<Interval, 2> at{Interval(place[0]), Interval(place[1])};
    std::array<Interval, equations> values;
    for (int equation = 0; equation < equations; ++equation)
      values[equation] = jet<Interval>(equation, at).value;
    const std::array<Interval, 2> step = newton_step(slopes, values);
    return {at[0] + step[0], at[1] + step[1]};
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_RAY_SEARCH_H
