// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ON_IMPLICIT_PATCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ON_IMPLICIT_PATCH_H

#include <CGAL/Spline_constraints_d/function/internal/substitution.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/patch_cells.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Curves_through_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Implicit_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Joined_parts.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Face_factor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Where a linear function is not negative on a surface.
struct Range_of_side
{
  enum { EVERYWHERE, NOWHERE, ON_EDGE, IN_PART } where;
  int axis = 0, end = 0;   // the edge across this axis, if it is ON_EDGE
};

inline Range_of_side range_of_side(const Power_polynomial& side, const Spline_patch<3>& surface)
{
  bool is_positive = true, is_negative = true;
  // where alone it is zero, and negative elsewhere
  std::array<std::array<bool, 2>, 2> is_edge{{{true, true}, {true, true}}};
  for_each_cell(surface, [&](const Patch_cell& cell) {
    const auto value = composed(side, 1, cell.functions);
    const auto [least, greatest] = value.bounds();
    is_positive = is_positive && least >= 0;
    is_negative = is_negative && greatest < 0;
    const auto zeros = [](const auto& tensor) {
      return std::count(tensor.coefficients().begin(), tensor.coefficients().end(), Exact_rational(0));
    };
    for (const int axis : {0, 1})
      for (const int end : {0, 1}) {
        const auto face = value.face(axis, end);
        const bool vanishes_on_face = zeros(face) == static_cast<std::ptrdiff_t>(face.coefficients().size()) &&
            zeros(value) == zeros(face) && greatest == 0;
        is_edge[axis][end] = is_edge[axis][end] && (cell.is_at_edge[axis][end] ? vanishes_on_face : greatest < 0);
      }
  });
  if (is_positive)
    return {Range_of_side::EVERYWHERE};
  if (is_negative)
    return {Range_of_side::NOWHERE};
  for (const int axis : {0, 1})
    for (const int end : {0, 1})
      if (is_edge[axis][end])
        return {Range_of_side::ON_EDGE, axis, end};
  return {Range_of_side::IN_PART};
}

/*
The common points of two parametric surfaces A and B where A is a part of the zeros of a polynomial, see Implicit_patch:
the curves f(B(s,t)) = 0 where the sides are not negative, which are on A as a whole or not at all. They are all on A,
or there is no answer.

Where B has no point on the positive side of an edge of A but those of one of its own edges, they are all that both may
have in common; they are, if f is zero on this edge.
*/
class Curves_on_implicit_patch
{
  const Surface_equations& m_surfaces;
  const std::size_t m_implicit;
  const Implicit_patch& m_a;
  const Spline_patch<3>& m_b;
  std::vector<Power_polynomial> m_sides;      // that are negative on a part of B
  std::optional<Range_of_side> m_edge;        // of B
  bool m_is_apart = false, m_is_known = true;

public:
  Curves_on_implicit_patch(const Surface_equations& surfaces, std::size_t implicit, const Implicit_patch& patch)
    : m_surfaces(surfaces), m_implicit(implicit), m_a(patch), m_b(*surfaces.surface(1 - implicit).patch)
  {
    for (const Power_polynomial& side : m_a.sides()) {
      const Range_of_side range = range_of_side(side, m_b);
      m_is_apart = m_is_apart || range.where == Range_of_side::NOWHERE;
      if (range.where == Range_of_side::IN_PART)
        m_sides.push_back(side);
      if (range.where != Range_of_side::ON_EDGE)
        continue;
      m_is_known = m_is_known && !m_edge;
      m_edge = range;
    }
  }

  // Whether other equations may tell of more, if the answer is not complete: where B crosses the plane of an edge of A.
  bool has_sides() const { return !m_sides.empty(); }

  // Nothing if it is not proved that all curves are on A.
  std::optional<Solved_part> operator()(Operation_budget& budget) const
  {
    if (m_is_apart)
      return Solved_part{Surface_equations(m_surfaces, m_implicit, std::nullopt),
                         Curve_solution_set_d({}, {}, {}, {}, {}, Summary())};
    const std::optional<Constraint_system_d> equations = system();
    if (!equations)
      return std::nullopt;
    Surface_equations surfaces(m_surfaces, m_implicit, *equations);
    Curve_search search{.closed_unknowns = surfaces.closed_unknowns()};
    for (const Surface_pole& pole : surfaces.poles())
      search.points.emplace_back(pole.unknown, pole.value);
    const std::vector<Common_pole> poles = Common_poles(
        surfaces, [&](std::size_t) { return &m_a.polynomial(); }, budget)();
    if (!std::all_of(poles.begin(), poles.end(),
                     [&](const Common_pole& common) { return is_within_sides(common.pole); }))
      return std::nullopt;
    Solved_part result = joined_at_poles(std::move(surfaces), curves_within_budget(*equations, budget, search), poles);
    return are_on_patch(result.surfaces, result.solutions) ? std::optional(std::move(result)) : std::nullopt;
  }

private:
  std::optional<Constraint_system_d> system() const
  {
    const Constraint_system_d incidence =
        Surface_equations(Surface_shape(m_a.polynomial()), Surface_shape(m_b)).system();
    std::optional<Constraint_system_d> result = m_edge ? equation_of_edge(incidence) : incidence;
    if (!m_is_known || !result)
      return std::nullopt;
    const Vector_expression<3> point = Parametric_vector<3>(m_b)(unknowns_in(domain_of(incidence)));
    for (const Power_polynomial& side : m_sides)
      result->add(substituted(side, point) >= 0);
    return result;
  }

  // As often as it is a factor of the equation of a system, twice if that is zero everywhere; nothing if it is none.
  std::optional<Constraint_system_d> equation_of_edge(const Constraint_system_d& system) const
  {
    const int axis = m_edge->axis;
    const Parameter_range range = m_b.domain(axis);
    const Exact_rational& value = m_edge->end == 0 ? range.first : range.second;
    const Power_polynomial factor = Power_polynomial::variable(axis) - Power_polynomial(value);
    Spline_function function = system.equalities().front();
    const int exponent = function.terms().empty() ? 2 : Face_factor::divide_out(function, axis, range, value);
    if (exponent == 0 || m_b.is_closed(axis))
      return std::nullopt;
    Constraint_system_d result(domain_of(system));
    result.add(pow(factor, exponent), Relation::EQUAL);
    return result;
  }

  // Whether no edge of A passes a pole of B.
  bool is_within_sides(const Surface_pole& pole) const
  {
    const auto point = m_b.pole(pole.axis, pole.value);
    return std::all_of(m_a.sides().begin(), m_a.sides().end(),
                       [&](const Power_polynomial& side) { return side(*point) > 0; });
  }

  bool are_on_patch(const Surface_equations& surfaces, const Curve_solution_set_d& solutions) const
  {
    const auto is_on_patch = [&](const Exact_ranges& box) {
      const std::vector<double> unknowns{CGAL::to_double(middle_of(box[0])), CGAL::to_double(middle_of(box[1]))};
      return !has_tips(box, 0) && m_a.contains(bounds(box), surfaces.parameters(m_implicit, unknowns));
    };
    const auto is_vertex_on_patch = [&](std::size_t i) { return is_on_patch(solutions.vertices()[i].box); };
    const auto is_curve_on_patch = [&](const Solution_curve& curve) {
      const std::vector<std::size_t> vertices = curve.vertices();
      const bool has_point = std::any_of(vertices.begin(), vertices.end(), is_vertex_on_patch) ||
          std::any_of(curve.pieces.begin(), curve.pieces.end(), [&](const Curve_piece& piece) {
                               return is_line(piece) &&
                                   is_on_patch({{middle_of(piece.box[0]), middle_of(piece.box[0])},
                                                {middle_of(piece.box[1]), middle_of(piece.box[1])}});
                             });
      return has_point && std::none_of(curve.pieces.begin(), curve.pieces.end(), [&](const Curve_piece& piece) {
               return has_tips(piece.box);
             });
    };
    return std::all_of(solutions.curves().begin(), solutions.curves().end(), is_curve_on_patch) &&
        std::all_of(solutions.points().begin(), solutions.points().end(), is_vertex_on_patch) &&
        std::all_of(solutions.singular_points().begin(), solutions.singular_points().end(), is_vertex_on_patch);
  }

  // It has all points of its box.
  static bool is_line(const Curve_piece& piece)
  {
    return piece.box[0].first == piece.box[0].second || piece.box[1].first == piece.box[1].second;
  }

  Vector_bounds<3> bounds(const Exact_ranges& box) const { return m_b.part(box).values(); }

  // Whether B may have a tip of A in a box.
  bool has_tips(const Exact_ranges& box, int most_halvings = 12) const
  {
    if (m_a.tips().empty())
      return false;
    const Vector_bounds<3> values = bounds(box);
    const auto has = [&](const std::array<Exact_rational, 3>& tip) {
      return values[0].lower <= tip[0] && tip[0] <= values[0].upper && values[1].lower <= tip[1] &&
          tip[1] <= values[1].upper && values[2].lower <= tip[2] && tip[2] <= values[2].upper;
    };
    if (std::none_of(m_a.tips().begin(), m_a.tips().end(), has))
      return false;
    const std::size_t axis = box[0].second - box[0].first < box[1].second - box[1].first ? 1 : 0;
    if (most_halvings == 0)
      return true;
    Exact_ranges lower = box, upper = box;
    lower[axis].second = upper[axis].first = middle_of(box[axis]);
    return has_tips(lower, most_halvings - 1) || has_tips(upper, most_halvings - 1);
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ON_IMPLICIT_PATCH_H
