// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SHARED_EDGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SHARED_EDGES_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The function of one parameter with its domain mapped onto another one, from the end to the begin if it is reversed.
inline Exact_function with_domain(const Exact_function& f, const Parameter_range& range, bool is_reversed)
{
  const auto [begin, end] = f.domain(0);
  const Exact_rational scale((range.second - range.first) / (end - begin));
  std::vector<Exact_rational> knots, coefficients = f.coefficients();
  for (const Exact_rational& knot : f.knots(0))
    knots.push_back(is_reversed ? Exact_rational(range.second - scale * (knot - begin))
                                : Exact_rational(range.first + scale * (knot - begin)));
  if (is_reversed) {
    std::reverse(knots.begin(), knots.end());
    std::reverse(coefficients.begin(), coefficients.end());
  }
  return Exact_function({f.degree(0)}, {std::move(knots)}, std::move(coefficients));
}

// An edge of a surface: an end of the range of a parameter.
struct Surface_edge
{
  int axis, side;
};

/*
The edges that two surfaces have in common, with parameters that are proportional: there, patches of one model end at
each other. Near such an edge, the points of one surface are e + x a, where e is a point of the edge, x >= 0 and a the
derivative across the edge, and those of the other one e' + y b; by the mean value theorem, the difference e - e' is a
multiple of the derivative c along the edge. If for a vector n the determinants det(c, a, n) and det(c, b, n) have
different signs, both are equal only for x = y = 0: the edge is all they have in common, and they touch where det(c, a,
b) = 0.
*/
class Shared_edges
{
  struct Pair
  {
    std::array<Surface_edge, 2> edges;
    bool is_reversed;
  };

  const Patch_pair<3>& m_surfaces;
  std::vector<Pair> m_pairs;

public:
  explicit Shared_edges(const Patch_pair<3>& surfaces) : m_surfaces(surfaces)
  {
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        for (const int other_axis : {0, 1})
          for (const int other_side : {0, 1})
            add({axis, side}, {other_axis, other_side});
  }

  /*
  The contacts of two polynomial pieces of the surfaces in a box of their parameters, if all are on an edge and decided.
  Of some ranges, the upper ends do not belong to the pieces.
  */
  std::optional<std::vector<Common_point>> contacts(const Patch_pair<3>& pieces, const std::vector<bool>& is_open,
                                                    const Parameter_box& box, Budgeted_solver& solve) const
  {
    for (const Pair& pair : m_pairs)
      if (has_interior(box) && meet_only_at(pair, box))
        return contacts_at(pair, pieces, is_open, box, solve);
    return std::nullopt;
  }

private:
  Spline_patch<3> curve(std::size_t operand, const Surface_edge& edge) const
  {
    const Exact_rational end = value(operand, edge);
    return m_surfaces[operand].part(edge.axis, {end, end});
  }

  Exact_rational value(std::size_t operand, const Surface_edge& edge) const
  {
    const Parameter_range range = m_surfaces[operand].domain(edge.axis);
    return edge.side == 0 ? range.first : range.second;
  }

  void add(const Surface_edge& edge, const Surface_edge& other_edge)
  {
    const Spline_patch<3> a = curve(0, edge), b = curve(1, other_edge);
    const std::vector<Exact_rational> begin{a.domain(0).first}, end{a.domain(0).second}, other_begin{b.domain(0).first},
        other_end{b.domain(0).second};
    for (const bool is_reversed : {false, true}) {
      if (a(begin) != b(is_reversed ? other_end : other_begin) || a(end) != b(is_reversed ? other_begin : other_end) ||
          a.is_one_point())
        continue;
      const auto moved = [&](const Exact_function& f) { return with_domain(f, a.domain(0), is_reversed); };
      const Exact_function weight = moved(b.weight());
      const auto is_equal = [&](int i) { return a.numerators()[i] * weight == moved(b.numerators()[i]) * a.weight(); };
      if (is_equal(0) && is_equal(1) && is_equal(2))
        m_pairs.push_back({{edge, other_edge}, is_reversed});
    }
  }

  static Parameter_range along(const Pair& pair, std::size_t operand, const Parameter_box& box)
  {
    return box[2 * operand + 1 - pair.edges[operand].axis];
  }

  // The parameter on an edge of one operand, of a point of the edge of the other one.
  Exact_rational parameter_on(std::size_t operand, const Pair& pair, const Exact_rational& other) const
  {
    const Parameter_range own_range = m_surfaces[operand].domain(1 - pair.edges[operand].axis),
                          other_range = m_surfaces[1 - operand].domain(1 - pair.edges[1 - operand].axis);
    const Exact_rational share((other - other_range.first) / (other_range.second - other_range.first));
    return own_range.first +
        (own_range.second - own_range.first) * (pair.is_reversed ? Exact_rational(1 - share) : share);
  }

  Parameter_range range_on(std::size_t operand, const Pair& pair, const Parameter_range& other) const
  {
    const Exact_rational a = parameter_on(operand, pair, other.first), b = parameter_on(operand, pair, other.second);
    return {(std::min)(a, b), (std::max)(a, b)};
  }

  // Whether the edge is all that the surfaces have in common in a box.
  bool meet_only_at(const Pair& pair, const Parameter_box& box, int depth = 8) const
  {
    for (const std::size_t operand : {0, 1})
      if (const auto& [lower, upper] = box[2 * operand + pair.edges[operand].axis];
          !(pair.edges[operand].side == 0 ? lower == value(operand, pair.edges[operand])
                                          : upper == value(operand, pair.edges[operand])))
        return false;
    const Patch_pair<3> part = m_surfaces.part(box);
    const Vector_bounds<3> gap = part[0].values() - part[1].values();
    if (std::any_of(gap.begin(), gap.end(), [](const Rational_interval& x) { return !has_zero(x); }) ||
        lead_apart(pair, part, box))
      return true;
    const auto halves = [](const Parameter_range& range) {
      return std::array<Parameter_range, 2>{{{range.first, middle_of(range)}, {middle_of(range), range.second}}};
    };
    if (depth > 0)
      for (const Parameter_range& a : halves(along(pair, 0, box)))
        for (const Parameter_range& b : halves(along(pair, 1, box))) {
          Parameter_box quarter = box;
          quarter[1 - pair.edges[0].axis] = a;
          quarter[3 - pair.edges[1].axis] = b;
          if (!meet_only_at(pair, quarter, depth - 1))
            return false;
        }
    return depth > 0;
  }

  // By the determinants, with n for the middle of the bounds.
  bool lead_apart(const Pair& pair, const Patch_pair<3>& part, const Parameter_box& box) const
  {
    const Parameter_range own = along(pair, 0, box), other = range_on(0, pair, along(pair, 1, box));
    const Vector_bounds<3> c = curve(0, pair.edges[0])
                                   .part(0, {(std::min)(own.first, other.first), (std::max)(own.second, other.second)})
                                   .tangents(0);
    std::array<Vector_bounds<3>, 2> normals;   // c x a, c x b
    std::array<double, 3> n{};
    for (const std::size_t k : {0, 1}) {
      Vector_bounds<3> across = part[k].tangents(pair.edges[k].axis);
      if (pair.edges[k].side == 1)
        across = Vector_bounds<3>{} - across;
      double length = 0;
      std::array<double, 3> middle;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
        normals[k][i] = c[next] * across[last] - c[last] * across[next];
        middle[i] = CGAL::to_double(normals[k][i].lower + normals[k][i].upper) / 2;
        length = (std::max)(length, std::abs(middle[i]));
      }
      if (!(length > 0))
        return false;
      for (std::size_t i = 0; i < 3; ++i)
        n[i] += (k == 0 ? 1 : -1) * middle[i] / length;
    }
    Vector_bounds<3> direction;
    for (std::size_t i = 0; i < 3; ++i)
      direction[i] = Rational_interval(Exact_rational(n[i]));
    return dot(normals[0], direction).lower > 0 && dot(normals[1], direction).upper < 0;
  }

  // \pre The edge is all they have in common in the box.
  std::optional<std::vector<Common_point>> contacts_at(const Pair& pair, const Patch_pair<3>& pieces,
                                                       const std::vector<bool>& is_open, const Parameter_box& box,
                                                       Budgeted_solver& solve) const
  {
    using Points = std::vector<Common_point>;
    for (const std::size_t k : {0, 1})
      if (pair.edges[k].side == 1 && is_open[2 * k + pair.edges[k].axis])
        return Points();
    const Parameter_range own = along(pair, 0, box), other = range_on(0, pair, along(pair, 1, box));
    const Parameter_range range{(std::max)(own.first, other.first), (std::min)(own.second, other.second)};
    if (range.second < range.first)
      return Points();
    const auto point = [&](Intersection_kind kind, const Parameter_range& at) {
      Common_point result{kind, box, std::vector<bool>(4, false), std::nullopt, false};
      for (const std::size_t k : {0, 1}) {
        const Exact_rational end = value(k, pair.edges[k]);
        result.parameters[2 * k + pair.edges[k].axis] = {end, end};
        result.parameters[2 * k + 1 - pair.edges[k].axis] = k == 0 ? at : range_on(1, pair, at);
      }
      return result;
    };
    const auto is_without = [&](const Exact_rational& x) {
      const auto is_end = [&](std::size_t k, const Exact_rational& u) {
        return is_open[2 * k + 1 - pair.edges[k].axis] && u == pieces[k].domain(1 - pair.edges[k].axis).second;
      };
      return is_end(0, x) || is_end(1, parameter_on(1, pair, x));
    };
    const Exact_function f = determinant_on(pair, pieces, range);
    const bool is_zero =
        std::all_of(f.coefficients().begin(), f.coefficients().end(), [](const Exact_rational& x) { return x == 0; });
    if (range.first == range.second)
      return is_zero && !is_without(range.first) ? Points{point(Intersection_kind::TANGENT, range)} : Points();
    if (is_zero)
      return Points{point(Intersection_kind::OVERLAP, range)};
    const std::vector<Unknown> u = unknowns({{Bound(range.first), Bound(range.second)}});
    std::vector<Constraint> constraints{Spline_map<1, 2>({f, f})(u[0])[0] == 0};
    if (is_without(range.first))
      constraints.push_back(u[0] > u[0].domain().first);
    if (is_without(range.second))
      constraints.push_back(u[0] < u[0].domain().second);
    Points result;
    for (const Solution_d<double>& solution : solve(constraints, u)) {
      if (solution.kind() != Solution_kind::CERTIFIED && solution.kind() != Solution_kind::CLUSTER)
        return std::nullopt;
      result.push_back(point(Intersection_kind::TANGENT, clipped(solution.exact_box(), {range})[0]));
    }
    return result;
  }

  // det(a, c, b) on a range of the parameter of the first edge; a constant for one point.
  Exact_function determinant_on(const Pair& pair, const Patch_pair<3>& pieces, const Parameter_range& range) const
  {
    const auto on_edge = [&](std::size_t k, int axis) {
      Vector_of_functions<3> result = tangent_direction(pieces[k], axis);
      for (Exact_function& f : result) {
        f = part_of(f.face(pair.edges[k].axis, pair.edges[k].side), 0, k == 0 ? range : range_on(1, pair, range));
        if (k == 1 && f.dimension() > 0)
          f = with_domain(f, range, pair.is_reversed);
      }
      return Vector_function<3>(result);
    };
    return dot(cross(on_edge(0, pair.edges[0].axis), on_edge(0, 1 - pair.edges[0].axis)),
               on_edge(1, pair.edges[1].axis))
        .function();
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SHARED_EDGES_H
