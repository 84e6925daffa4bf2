// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_CONTACTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_CONTACTS_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/critical_values.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

// What a line touches: a piece of a curve, or a point.
struct Hull_contact_operand
{
  const Hull_piece_2* piece;   // null: a point
  Exact_pair point;
};

// What is asked of the solver for the hull of curves.
class Hull_contacts_2
{
  Run_of_steps& m_run;

public:
  // What is not solved before the run ends is not decided.
  explicit Hull_contacts_2(Run_of_steps& run) : m_run(run) {}

  // The line from one operand to another one that touches both, in the direction in which pieces run: ranges on [0,1]
  // of their parameters, if there is one line, which has them in these ranges. Ranges of points mean nothing.
  std::optional<std::array<Parameter_range, 2>> common_tangent(const Hull_contact_operand& first,
                                                               const Hull_contact_operand& second)
  {
    if (first.piece == nullptr && second.piece == nullptr)
      return std::array<Parameter_range, 2>{};
    const std::array<const Hull_contact_operand*, 2> operands{&first, &second};
    std::vector<Unknown> u = unknowns(first.piece != nullptr && second.piece != nullptr ? 2 : 1, {Bound(0), Bound(1)});
    std::vector<Vector_expression<2>> points, tangents;
    for (const Hull_contact_operand* operand : operands) {
      const Unknown& parameter = operand == &first ? u.front() : u.back();
      if (operand->piece != nullptr) {
        const Differentiated_map curve{Planar_map(exact_curve(*operand->piece)), 1};
        points.push_back(curve(0, parameter));
        tangents.push_back(curve(1, parameter));
      } else {
        points.emplace_back(operand->point[0], operand->point[1]);
        tangents.emplace_back(0, 0);
      }
    }
    const Vector_expression<2> line = points[1] - points[0];
    std::vector<Constraint> constraints;
    for (std::size_t i = 0; i < 2; ++i)
      if (operands[i]->piece != nullptr) {
        constraints.push_back(cross(line, tangents[i]) == 0);
        if (constraints.back().function.is_zero())   // straight
          return std::nullopt;
        constraints.push_back(dot(line, tangents[i]) > 0);
      }
    const auto solutions = solve(constraints, u);
    if (solutions.size() != 1 || !is_proved(solutions[0]))
      return std::nullopt;
    std::vector<Parameter_range> ranges;
    for (const auto& [lower, upper] : solutions[0].exact_box())
      ranges.emplace_back((std::max)(lower, Exact_rational(0)), (std::min)(upper, Exact_rational(1)));
    return std::array<Parameter_range, 2>{ranges.front(), ranges.back()};
  }

  /*
  Whether the line from one operand to another one that touches both also touches one between them. That is decided for
  lines with rational slope, as copies of a shape in a row have: the simplest direction that is possible is tried, and
  the highest points of all three in the direction of its normal are compared exactly.
  */
  bool have_common_tangent(const Hull_contact_operand& first, const Hull_contact_operand& between,
                           const Hull_contact_operand& second)
  {
    const auto contacts = common_tangent(first, second);
    if (!contacts)
      return false;
    const Vector_bounds<2> line = bounds(second, (*contacts)[1]) - bounds(first, (*contacts)[0]);
    // the one that the line is nearly parallel to
    const std::size_t axis =
        has_zero(line[0]) || (!has_zero(line[1]) && CGAL::abs(line[0].lower) < CGAL::abs(line[1].lower)) ? 1 : 0;
    if (has_zero(line[axis]))
      return false;
    const int sign = sign_of(line[axis].lower);
    const Rational_interval slope = sign > 0
        ? line[1 - axis] / line[axis]
        : (Rational_interval(Exact_rational(0)) - line[1 - axis]) / (Rational_interval(Exact_rational(0)) - line[axis]);
    Exact_pair direction;
    direction[axis] = sign;
    direction[1 - axis] = sign * simplest_rational_between(slope.lower, slope.upper);
    const Exact_pair normal{direction[1], Exact_rational(-direction[0])};
    return have_common_height({summit(first, normal), summit(between, normal), summit(second, normal)});
  }

  // The parameter within (0,1) where a piece has a cusp or turns back, if there is one and it is rational.
  std::optional<Exact_rational> rational_singularity(const Hull_piece_2& piece)
  {
    const Differentiated_map curve{Planar_map(exact_curve(piece)), 1};
    const std::vector<Unknown> u = unknowns({{Bound(0), Bound(1)}});
    const Vector_expression<2> tangent = curve(1, u[0]);
    const auto solutions = solve({tangent.x() == 0, tangent.y() == 0}, u);
    if (solutions.size() != 1 || !is_proved(solutions[0]))
      return std::nullopt;
    const auto [lower, upper] = solutions[0].exact_box()[0];
    const Exact_rational t =
        simplest_rational_between((std::max)(lower, Exact_rational(0)), (std::min)(upper, Exact_rational(1)));
    return t > 0 && t < 1 && curve.at(1, t) == Exact_pair{0, 0} ? std::optional<Exact_rational>(t) : std::nullopt;
  }

  // Ranges on [0,1] where two pieces are the same, if they have nothing else in common.
  std::optional<std::array<Parameter_range, 2>> overlap(const Hull_piece_2& first, const Hull_piece_2& second) const
  {
    if (m_run.must_stop() || !may_meet(first.boxes(), second.boxes()))
      return std::nullopt;
    const std::vector<Common_point> common = all_common_points(patch(first), patch(second));
    if (common.size() != 1 || common[0].kind != Intersection_kind::OVERLAP)
      return std::nullopt;
    return std::array<Parameter_range, 2>{common[0].parameters[0], common[0].parameters[1]};
  }

  // Whether a piece and a chain have one common point at most, or the piece is a part of one of those of the chain.
  bool meet_once_or_overlap(const Hull_piece_2& piece, const std::vector<Hull_piece_2>& chain) const
  {
    std::size_t count = 0;
    for (const Hull_piece_2& other : chain) {
      if (!may_meet(piece.boxes(), other.boxes()))
        continue;
      const std::vector<Common_point> common = all_common_points(patch(piece), patch(other));
      if (has_any(common, Intersection_kind::UNDECIDED))
        return false;
      if (has_any(common, Intersection_kind::OVERLAP))
        return common.size() == 1 && has_point({other}, piece.begin()) && has_point({other}, piece.end());
      const bool is_joint_known =
          &other != &chain.front() && (other.begin() == piece.begin() || other.begin() == piece.end());
      count += common.size() - (is_joint_known ? 1 : 0);
    }
    return count <= 1;
  }

  bool has_point(const std::vector<Hull_piece_2>& chain, const Exact_pair& point) const
  {
    return std::any_of(chain.begin(), chain.end(), [&](const Hull_piece_2& piece) {
      if (!may_meet({enclosed(point)}, piece.boxes()))
        return false;
      const std::vector<Common_point> common = all_common_points(Spline_patch<2>(point), patch(piece));
      return !common.empty() && !has_any(common, Intersection_kind::UNDECIDED);
    });
  }

  bool is_apart_from_segment(const std::vector<Hull_piece_2>& chain, const std::array<Exact_pair, 2>& ends) const
  {
    std::vector<Exact_kernel::Point_2> points;
    for (const auto& [x, y] : ends)
      points.emplace_back(x, y);
    const Spline_patch<2> segment(bezier_curve(points));
    return std::all_of(chain.begin(), chain.end(),
                       [&](const Hull_piece_2& piece) { return all_common_points(segment, patch(piece)).empty(); });
  }

private:
  Solution_set_d<double> solve(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns) const
  {
    Budgeted_solver solver(m_run.options_of_systems());
    Solution_set_d<double> result = solver(constraints, unknowns);
    m_run.add_nodes(solver.total().nodes);
    return result;
  }

  std::vector<Common_point> all_common_points(const Spline_patch<2>& first, const Spline_patch<2>& second) const
  {
    Budgeted_solver solver(m_run.options_of_systems());
    std::vector<Common_point> result = common_points<2>(Patch_pair<2>(first, second), solver);
    m_run.add_nodes(solver.total().nodes);
    return result;
  }

  static bool has_any(const std::vector<Common_point>& points, Intersection_kind kind)
  {
    return std::any_of(points.begin(), points.end(), [=](const Common_point& point) { return point.kind == kind; });
  }

  static bool is_proved(const Solution_d<double>& solution)
  {
    return solution.kind() == Solution_kind::CERTIFIED || solution.kind() == Solution_kind::CLUSTER;
  }

  static bool may_meet(const std::vector<Interval_pair>& a, const std::vector<Interval_pair>& b)
  {
    const auto hull = [](const std::vector<Interval_pair>& boxes, std::size_t axis) {
      Interval result = boxes.front()[axis];
      for (const Interval_pair& box : boxes)
        result = Interval((std::min)(result.inf(), box[axis].inf()), (std::max)(result.sup(), box[axis].sup()));
      return result;
    };
    return hull(a, 0).do_overlap(hull(b, 0)) && hull(a, 1).do_overlap(hull(b, 1));
  }

  static Bspline_curve_2<Exact_kernel> exact_curve(const Hull_piece_2& piece)
  {
    return Boundary_loop_2({piece.curve()}).curve();
  }
  static Spline_patch<2> patch(const Hull_piece_2& piece) { return Spline_patch<2>(exact_curve(piece)); }

  // Of the points of an operand in a range.
  static Vector_bounds<2> bounds(const Hull_contact_operand& operand, const Parameter_range& range)
  {
    std::vector<Exact_pair> points{operand.point};
    if (operand.piece != nullptr)
      points = Hull_piece_2(restricted(operand.piece->curve(), range.first, range.second)).points();
    const auto coordinate = [](std::size_t axis) {
      return [axis](const Exact_pair& a, const Exact_pair& b) { return a[axis] < b[axis]; };
    };
    Vector_bounds<2> result;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), coordinate(axis));
      result[axis] = {(*least)[axis], (*greatest)[axis]};
    }
    return result;
  }

  // The greatest height of an operand in a direction: a number, or the only critical value of a quotient in a range.
  struct Summit
  {
    Rational_interval height;
    std::optional<std::array<Exact_tensor, 2>> quotient;
  };

  // \pre pieces are convex and turn left, by less than a right angle
  static Summit summit(const Hull_contact_operand& operand, const Exact_pair& normal)
  {
    if (operand.piece == nullptr)
      return {Rational_interval(exact_dot(operand.point, normal)), std::nullopt};
    const std::vector<Exact_pair>& points = operand.piece->points();
    if (exact_dot(exact_difference(points[1], points[0]), normal) <= 0)
      return {Rational_interval(exact_dot(points.front(), normal)), std::nullopt};
    if (exact_dot(exact_difference(points.back(), points[points.size() - 2]), normal) >= 0)
      return {Rational_interval(exact_dot(points.back(), normal)), std::nullopt};
    Rational_interval height(exact_dot(points[0], normal));
    for (const Exact_pair& point : points)
      height = hull(height, Rational_interval(exact_dot(point, normal)));
    const auto& [x, y, w] = operand.piece->curve().coordinates;
    return {height, std::array<Exact_tensor, 2>{x * normal[0] + y * normal[1], w}};
  }

  // Whether all are proved to be the same.
  bool have_common_height(const std::vector<Summit>& summits)
  {
    Rational_interval range = summits[0].height;
    for (const Summit& summit : summits)
      range = hull(range, summit.height);
    const std::vector<Unknown> height = unknowns({{Bound(range.lower), Bound(range.upper)}});
    std::vector<Constraint> all;
    for (const auto& [value, quotient] : summits) {
      all.push_back((quotient
                         ? Expression(critical_value_polynomial((*quotient)[0], (*quotient)[1], height[0].numerator()),
                                      Monomial(), height[0].symbols())
                         : height[0] - value.lower) == 0);
      if (all.back().function.is_zero() || !has_one_solution({all.back()}, height))
        return false;
    }
    return has_one_solution(all, height);
  }

  bool has_one_solution(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns)
  {
    const auto solutions = solve(constraints, unknowns);
    return solutions.size() == 1 && is_proved(solutions[0]);
  }
};

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_CONTACTS_2_H
