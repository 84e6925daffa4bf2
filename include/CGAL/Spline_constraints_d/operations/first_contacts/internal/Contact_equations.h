// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_EQUATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_EQUATIONS_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Boundary_element.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// A solution of the equations of two elements: the parameters on their pieces, zero in a vertex, and the time.
struct Contact_candidate
{
  std::array<std::size_t, 2> elements; // of the moving region, and of the fixed one
  std::array<bool, 2> is_at_vertex;    // whether the first point of the element meets
  std::array<Parameter_range, 2> parameters;
  Parameter_range time;
  Solution_d<double> solution;
  bool is_alone = true; // or else there may be others in the enclosure

  // Whether there is a contact.
  bool is_proved() const { return solution.kind() != Solution_kind::UNDECIDED; }
};

// The coefficients of a motion in a part of the time.
class Motion_part
{
  using Function = Bspline_function<Exact_rational>;

  Parameter_range m_time;
  std::array<std::array<Interval, 2>, 3> m_entries; // of M / w, and c / w
  std::array<std::array<Function, 2>, 3> m_columns;
  Function m_weight;
  std::array<Spline_map<1, 2>, 2> m_axes; // the columns of M
  Spline_map<1, 3> m_path;                // c and w
  Linear_bounds m_linear_bounds;

public:
  Motion_part(const Rational_motion_2& motion, const Parameter_range& time)
    : m_time(time), m_columns(parts(motion, time)),
      m_weight(part_of(motion.weight(), 0, time)), m_axes{Spline_map<1, 2>(m_columns[0]),
                                                          Spline_map<1, 2>(m_columns[1])},
      m_path({m_columns[2][0], m_columns[2][1], m_weight})
  {
    const Rational_interval weights(m_weight.bounds());
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 2; ++i) {
        // The control points of the weight may have both signs, though it has not.
        const Rational_interval values(m_columns[k][i].bounds());
        if (k < 2)
          m_linear_bounds[k][i] = values;
        const Rational_interval entry = weights.lower > 0 ? values / weights : Rational_interval();
        m_entries[k][i] = weights.lower > 0 ? interval_of({entry.lower, entry.upper}) : any_number();
      }
  }

  const Parameter_range& time() const { return m_time; }

  // Of w M.
  const Linear_bounds& linear_bounds() const { return m_linear_bounds; }

  // A box around the images of the points of a box; with upward rounding.
  std::array<Interval, 2> image(const std::array<Interval, 2>& box) const
  {
    std::array<Interval, 2> result;
    for (std::size_t i = 0; i < 2; ++i)
      result[i] = m_entries[0][i] * box[0] + m_entries[1][i] * box[1] + m_entries[2][i];
    return result;
  }

  // w times the image of a point in homogeneous coordinates, and times its weight.
  Vector_expression<3> image(const Vector_expression<3>& point, const Unknown& time) const
  {
    const Vector_expression<2> linear = direction({point[0], point[1]}, time);
    const Vector_expression<3> path = m_path(time);
    return {linear[0] + path[0] * point[2], linear[1] + path[1] * point[2], path[2] * point[2]};
  }

  // w times the image of a direction.
  Vector_expression<2> direction(const Vector_expression<2>& vector, const Unknown& time) const
  {
    return m_axes[0](time) * vector[0] + m_axes[1](time) * vector[1];
  }

  // Whether a point is on a line, through two points, at all times.
  bool keeps_on_line(const Exact_pair& point, const Exact_pair& a, const Exact_pair& b) const
  {
    const Exact_pair normal{Exact_rational(a[1] - b[1]), Exact_rational(b[0] - a[0])};
    const auto along_normal = [&](std::size_t k) { return m_columns[k][0] * normal[0] + m_columns[k][1] * normal[1]; };
    return vanishes(along_normal(0) * point[0] + along_normal(1) * point[1] + along_normal(2) -
                    m_weight * exact_dot(normal, a));
  }

  // Whether a line, through two points, is the same at all times, seen from the moving region.
  bool keeps_fixed_line(const Exact_pair& a, const Exact_pair& b) const
  {
    const Exact_pair normal{Exact_rational(a[1] - b[1]), Exact_rational(b[0] - a[0])};
    std::array<Function, 3> line; // its coefficients there
    for (std::size_t k = 0; k < 3; ++k)
      line[k] = m_columns[k][0] * normal[0] + m_columns[k][1] * normal[1];
    line[2] = line[2] - m_weight * exact_dot(normal, a);
    const std::array<Exact_rational, 1> begin{m_time.first};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < k; ++i)
        if (!vanishes(line[i] * line[k](begin) - line[k] * line[i](begin)))
          return false;
    return true;
  }

  // Whether a moving line, through two points, is the same at all times.
  bool keeps_moving_line(const Exact_pair& a, const Exact_pair& b) const
  {
    const Exact_pair from = image(a), to = image(b);
    return keeps_on_line(a, from, to) && keeps_on_line(b, from, to);
  }

  // Whether a moving line goes through a fixed point all the time.
  bool keeps_line_through(const Exact_pair& point, const Exact_pair& a, const Exact_pair& b) const
  {
    const Exact_pair side{Exact_rational(b[0] - a[0]), Exact_rational(b[1] - a[1])};
    std::array<Function, 2> line, way;
    for (std::size_t i = 0; i < 2; ++i) {
      line[i] = m_columns[0][i] * side[0] + m_columns[1][i] * side[1];
      way[i] = m_columns[0][i] * a[0] + m_columns[1][i] * a[1] + m_columns[2][i] - m_weight * point[i];
    }
    return vanishes(line[0] * way[1] - line[1] * way[0]);
  }

private:
  // At the begin.
  Exact_pair image(const Exact_pair& x) const
  {
    const std::array<Exact_rational, 1> begin{m_time.first};
    const auto coordinate = [&](std::size_t i) {
      return Exact_rational((m_columns[0][i](begin) * x[0] + m_columns[1][i](begin) * x[1] + m_columns[2][i](begin)) /
                            m_weight(begin));
    };
    return {coordinate(0), coordinate(1)};
  }

  static bool vanishes(const Function& f) { return f.bounds() == std::pair(Exact_rational(0), Exact_rational(0)); }

  static std::array<std::array<Function, 2>, 3> parts(const Rational_motion_2& motion, const Parameter_range& time)
  {
    std::array<std::array<Function, 2>, 3> result = motion.columns();
    for (auto& column : result)
      column = part_of<2>(column, 0, time);
    return result;
  }
};

/*
The equations of a contact of an element of the moving region with one of the fixed region, in a part of the time. Each
of both is a point of the piece, with a parameter as unknown, or its first point. All solutions are points that the
boundaries have in common at that time.
*/
class Contact_equations
{
  const Boundary_element &m_moving, &m_fixed;
  const Motion_part& m_motion;
  bool m_keeps_orientation;

public:
  Contact_equations(const Boundary_element& moving, const Boundary_element& fixed, const Motion_part& motion,
                    bool keeps_orientation)
    : m_moving(moving), m_fixed(fixed), m_motion(motion), m_keeps_orientation(keeps_orientation)
  {}

  // Whether there is nothing to solve.
  bool are_void(const std::array<bool, 2>& is_at_vertex) const
  {
    return are_identities(is_at_vertex) || hold_in_overlap(is_at_vertex);
  }

  // The unknowns are the parameters of those that are no vertices, and the time.
  Solution_set_d<double> solutions(const std::array<bool, 2>& is_at_vertex, Budgeted_solver& solve) const
  {
    const std::vector<Unknown> x = unknowns_in(domain(is_at_vertex));
    const Unknown& time = x.back();
    const Vector_expression<3> p = m_motion.image(point(m_moving, is_at_vertex[0], x[0]), time),
                               q = point(m_fixed, is_at_vertex[1], x[x.size() - (x.size() == 1 ? 1 : 2)]);
    std::vector<Constraint> constraints{p[0] * q[2] == q[0] * p[2], p[1] * q[2] == q[1] * p[2]};
    if (!is_at_vertex[0] && !is_at_vertex[1]) {
      // Regions are on the left of their boundaries: where they touch from outside, these run in opposite directions.
      const Vector_expression<2> a = m_motion.direction(tangent(m_moving, x[0]), time), b = tangent(m_fixed, x[1]);
      constraints.push_back(cross(a, b) == 0);
      constraints.push_back(m_keeps_orientation ? dot(a, b) <= 0 : dot(a, b) >= 0);
    }
    return solve(constraints, x);
  }

private:
  // The ends of straight pieces that touch along a line are vertices of others; and where a vertex moves along a line,
  // or a curve slides on one, what changes does so where an end comes, or where another solution is.
  bool are_identities(const std::array<bool, 2>& is_at_vertex) const
  {
    const auto [is_moving_vertex, is_fixed_vertex] = is_at_vertex;
    if (!is_moving_vertex && !is_fixed_vertex)
      return (m_moving.is_straight && m_fixed.is_straight) ||
          (m_fixed.is_straight && m_motion.keeps_fixed_line(m_fixed.vertex, m_fixed.piece->at(Exact_rational(1)))) ||
          (m_moving.is_straight && m_motion.keeps_moving_line(m_moving.vertex, m_moving.piece->at(Exact_rational(1))));
    if (is_moving_vertex && !is_fixed_vertex)
      return m_fixed.is_straight &&
          m_motion.keeps_on_line(m_moving.vertex, m_fixed.vertex, m_fixed.piece->at(Exact_rational(1)));
    if (!is_moving_vertex)
      return m_moving.is_straight &&
          m_motion.keeps_line_through(m_fixed.vertex, m_moving.vertex, m_moving.piece->at(Exact_rational(1)));
    return false;
  }

  // Whether regions overlap in all solutions, or there is none. In the ends of pieces that may be corners, which have
  // solutions of their own.
  bool hold_in_overlap(const std::array<bool, 2>& is_at_vertex) const
  {
    const Contact_cone a = moved(is_at_vertex[0] ? m_moving.cone_in_vertex : m_moving.cone_on_piece,
                                 m_motion.linear_bounds(), m_keeps_orientation),
                       &b = is_at_vertex[1] ? m_fixed.cone_in_vertex : m_fixed.cone_on_piece;
    return is_at_vertex[0] || is_at_vertex[1] ? pass_each_other(a, b) : are_never_opposite(a, b);
  }

  std::vector<Parameter_range> domain(const std::array<bool, 2>& is_at_vertex) const
  {
    std::vector<Parameter_range> result;
    for (const bool is_vertex : is_at_vertex)
      if (!is_vertex)
        result.emplace_back(Exact_rational(0), Exact_rational(1));
    result.push_back(m_motion.time());
    return result;
  }

  // In homogeneous coordinates.
  static Vector_expression<3> point(const Boundary_element& element, bool is_vertex, const Unknown& parameter)
  {
    if (is_vertex)
      return {Expression(element.vertex[0]), Expression(element.vertex[1]), Expression(Exact_rational(1))};
    const Vector_expression<3> x = element.map(parameter);
    return {x[0], x[1], element.piece->is_polynomial() ? Expression(Exact_rational(1)) : x[2]};
  }

  // The derivative times the square of the weight.
  static Vector_expression<2> tangent(const Boundary_element& element, const Unknown& parameter)
  {
    const Vector_expression<3> x = element.map(parameter), d = derivative(element.map)(parameter);
    if (element.piece->is_polynomial())
      return {d[0], d[1]};
    return {d[0] * x[2] - x[0] * d[2], d[1] * x[2] - x[1] * d[2]};
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_EQUATIONS_H
