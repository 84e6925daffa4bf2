// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CONTACT_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CONTACT_FINDER_H

#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Coincidence.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/settle_undecided_contacts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A polynomial piece of a surface, the upper ends of its ranges that do not belong to it, and its edges (axis, side)
// that are poles and do not belong to it either.
struct Contact_piece
{
  Spline_patch<3> patch;
  std::array<bool, 2> is_without_end;
  std::array<std::array<bool, 2>, 2> is_pole;
};

// A pole where the surface has a tangent plane.
struct Smooth_pole
{
  Parameter_box parameters;   // all that stand for it
  int axis;                   // the one that is fixed
  Exact_vector<3> point;
  std::array<Exact_vector<3>, 2> tangents;
};

// The ranges between breaks. Unless there is a crease, the end of a range is the begin of the next one.
inline std::vector<Axis_part> polynomial_ranges(const Spline_patch<3>& surface, int axis)
{
  const std::vector<Exact_rational> breaks = surface.breaks(axis);
  const std::size_t cells = breaks.size() - 1;
  const auto cell = [&](std::size_t i) { return Parameter_range(breaks[i], breaks[i + 1]); };
  const bool is_closed = surface.is_closed(axis);
  std::vector<Axis_part> result;
  for (std::size_t i = 0; i < cells; ++i) {
    const bool goes_on = i + 1 < cells || is_closed;
    result.push_back({cell(i),
                      goes_on &&
                          have_same_direction<3>(surface.one_sided_tangent(axis, cell(i), 1),
                                                 surface.one_sided_tangent(axis, cell((i + 1) % cells), 0))});
  }
  return result;
}

/*
The points where two surfaces touch: A = B, and the derivatives of A are orthogonal to the normal of B. With a regular
contact these equations are regular: let both be graphs over the common tangent plane; then the first two coordinates
are equal, and the gradients are, whose difference has the difference of the Hessian matrices as its derivative.

At a pole derivatives vanish, and with them two of the equations. Poles are cut off, and tried alone: there, the
derivatives in all directions have to be orthogonal to the normal.
*/
class Contact_finder
{
  using Solution = Solution_d<double>;

  Patch_pair<3> m_pair;
  Budgeted_solver& m_solve;
  std::vector<Common_point> m_result;

public:
  Contact_finder(Patch_pair<3> pair, Budgeted_solver& solve) : m_pair(std::move(pair)), m_solve(solve) {}

  std::vector<Common_point> operator()()
  {
    if (are_apart(m_pair[0].values(), m_pair[1].values()))
      return {};
    const std::array<std::vector<Contact_piece>, 2> pieces{pieces_of(m_pair[0]), pieces_of(m_pair[1])};
    const std::array<std::vector<Smooth_pole>, 2> poles{poles_of(m_pair[0]), poles_of(m_pair[1])};
    for (const Contact_piece& a : pieces[0])
      for (const Contact_piece& b : pieces[1])
        find_contacts({a, b});
    for (const std::size_t operand : {0, 1})
      for (const Smooth_pole& pole : poles[operand])
        for (const Contact_piece& piece : pieces[1 - operand])
          find_contacts_at(pole, operand, piece);
    for (const Smooth_pole& a : poles[0])
      for (const Smooth_pole& b : poles[1])
        find_contact_of(a, b);
    std::sort(m_result.begin(), m_result.end(),
              [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
    return std::move(m_result);
  }

private:
  static std::optional<Spline_patch<3>> pole_of(const Spline_patch<3>& surface, int axis, int side)
  {
    const Exact_rational end = side == 0 ? surface.domain(axis).first : surface.domain(axis).second;
    const Spline_patch<3> edge = surface.part(axis, {end, end});
    return edge.is_one_point() ? std::optional(edge) : std::nullopt;
  }

  static std::vector<Contact_piece> pieces_of(const Spline_patch<3>& surface)
  {
    const auto is_pole = [&](const Axis_part& part, int axis, int side) {
      const auto [begin, end] = surface.domain(axis);
      return (side == 0 ? part.range.first == begin : part.range.second == end) &&
          pole_of(surface, axis, side).has_value();
    };
    const std::array<std::vector<Axis_part>, 2> ranges{polynomial_ranges(surface, 0), polynomial_ranges(surface, 1)};
    std::vector<Contact_piece> result;
    for (const Axis_part& u : ranges[0])
      for (const Axis_part& v : ranges[1])
        result.push_back({surface.part(std::vector<Parameter_range>{u.range, v.range}),
                          {u.is_without_end, v.is_without_end},
                          {{{is_pole(u, 0, 0), is_pole(u, 0, 1)}, {is_pole(v, 1, 0), is_pole(v, 1, 1)}}}});
    return result;
  }

  static std::vector<Smooth_pole> poles_of(const Spline_patch<3>& surface)
  {
    std::vector<Smooth_pole> result;
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        if (const auto edge = pole_of(surface, axis, side))
          if (const auto tangents = tangents_at_pole(surface, axis, side)) {
            const Exact_rational end = side == 0 ? surface.domain(axis).first : surface.domain(axis).second;
            Parameter_box parameters{surface.domain(0), surface.domain(1)};
            parameters[axis] = {end, end};
            result.push_back({parameters, axis, (*edge)(edge->first_corner()), *tangents});
          }
    return result;
  }

  void find_contacts(const std::array<Contact_piece, 2>& pieces)
  {
    if (are_apart(pieces[0].patch.values(), pieces[1].patch.values()))
      return;
    const Patch_pair<3> patches(pieces[0].patch, pieces[1].patch);
    if (m_solve.must_stop())
      return m_result.push_back(undecided_common_point(patches.domain(), m_solve.reason()));
    const Coincidence<3> equations(patches);
    if (const std::size_t plane = equations.has_eliminated(0) ? 0 : 1; equations.has_eliminated(plane))
      find_contacts_with_plane(equations, plane, pieces[1 - plane]);
    else if (const auto without_cap = without_undecided_cap(pieces))
      find_contacts(*without_cap);
    else
      find_curved_contacts(equations, pieces);
  }

  void find_curved_contacts(const Coincidence<3>& equations, const std::array<Contact_piece, 2>& pieces)
  {
    const std::vector<Unknown> u = equations.unknowns();
    std::vector<bool> is_open;
    for (const Contact_piece& piece : pieces)
      is_open.insert(is_open.end(), piece.is_without_end.begin(), piece.is_without_end.end());
    std::vector<Constraint> constraints = equations.constraints(u, is_open);
    const Vector_expression<3> normal = equations.normal(1, u);
    for (const int axis : {0, 1})
      constraints.push_back(dot(equations.tangent(0, axis, u), normal) == 0);
    for (const std::size_t operand : {0, 1})
      exclude_poles(pieces[operand], std::span(u).subspan(2 * operand, 2), constraints);
    std::vector<Common_point> points;
    for (const Solution& solution : m_solve(constraints, u))
      points.push_back({kind_of(solution), equations.all_parameters(solution.exact_box()), std::vector<bool>(4, false),
                        solution, false});
    if (std::any_of(points.begin(), points.end(),
                    [](const Common_point& point) { return point.kind == Intersection_kind::UNDECIDED; }) &&
        !m_solve.must_stop())
      settle_undecided_contacts(Shared_edges(m_pair), {pieces[0].patch, pieces[1].patch}, is_open, points, m_solve);
    std::move(points.begin(), points.end(), std::back_inserter(m_result));
  }

  // In coordinates in which the plane is z = 0, with the numerator of z and its derivatives. In the place of z stands z
  // + z_u, for the gradient of z vanishes where all are zero.
  void find_contacts_with_plane(const Coincidence<3>& equations, std::size_t plane, const Contact_piece& piece)
  {
    const std::vector<Unknown> u = equations.unknowns();
    std::vector<bool> is_open(4, false);
    std::copy(piece.is_without_end.begin(), piece.is_without_end.end(),
              is_open.begin() + static_cast<std::ptrdiff_t>(2 - 2 * plane));
    std::vector<Constraint> constraints = equations.constraints(u, is_open);
    const Exact_function& z = equations.position().numerators()[2];
    const Vector_of_functions<3> contact{z + z.derivative(0), z.derivative(0), z.derivative(1)};
    const Vector_expression<3> values = Parametric_vector<3>(contact)(u);
    constraints.front() = values[0] == 0;
    for (const int axis : {0, 1})
      constraints.push_back(values[1 + axis] == 0);
    exclude_poles(piece, u, constraints);
    for (const Solution& solution : m_solve(constraints, u))
      if (!is_at_pole(solution, piece, contact))
        add(kind_of(solution), equations.all_parameters(solution.exact_box()), solution);
  }

  static void exclude_poles(const Contact_piece& piece, std::span<const Unknown> u,
                            std::vector<Constraint>& constraints)
  {
    for (const int axis : {0, 1}) {
      if (piece.is_pole[axis][0])
        constraints.push_back(u[axis] > u[axis].domain().first);
      if (piece.is_pole[axis][1])
        constraints.push_back(u[axis] < u[axis].domain().second);
    }
  }

  // Whether a regular solution of which it is not known if it is at a pole, is.
  bool is_at_pole(const Solution& solution, const Contact_piece& piece, const Vector_of_functions<3>& contact)
  {
    if (solution.reason() != Undecided_reason::DOMAIN_BOUNDARY && solution.reason() != Undecided_reason::INEQUALITY)
      return false;
    const Parameter_box domain{piece.patch.domain(0), piece.patch.domain(1)};
    const Parameter_box box = clipped(
        solution.uniqueness_region().empty() ? solution.exact_box() : solution.exact_uniqueness_region(), domain);
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        if (const Exact_rational& end = side == 0 ? domain[axis].first : domain[axis].second;
            piece.is_pole[axis][side] && box[axis].first <= end && end <= box[axis].second) {
          const Parametric_vector<3> edge(part_of<3>(part_of<3>(contact, axis, {end, end}), 0, box[1 - axis]));
          const std::vector<Unknown> u = unknowns({{Bound(box[1 - axis].first), Bound(box[1 - axis].second)}});
          const Vector_expression<3> values = edge(u);
          const Solution_set_d<double> found = m_solve({values[0] == 0, values[1] == 0, values[2] == 0}, u);
          if (found.is_complete() && !found.empty())
            return true;
        }
    return false;
  }

  // Where a pole of one of the pieces is on the other one, the equations are singular: it is cut off, and what is near
  // it remains undecided.
  std::optional<std::array<Contact_piece, 2>> without_undecided_cap(const std::array<Contact_piece, 2>& pieces)
  {
    for (const std::size_t operand : {0, 1})
      for (const int axis : {0, 1})
        for (const int side : {0, 1}) {
          const Spline_patch<3>& patch = pieces[operand].patch;
          if (!pieces[operand].is_pole[axis][side] ||
              !has_point(pieces[1 - operand].patch, *pole_of(patch, axis, side)))
            continue;
          const auto [begin, end] = patch.domain(axis);
          const Exact_rational share = Exact_rational(side == 0 ? 1 : 15) / 16, cut(begin + share * (end - begin));
          Parameter_box cap = Patch_pair<3>(pieces[0].patch, pieces[1].patch).domain();
          cap[2 * operand + axis] = side == 0 ? Parameter_range(begin, cut) : Parameter_range(cut, end);
          add(Intersection_kind::UNDECIDED, cap, std::nullopt);
          std::array<Contact_piece, 2> result = pieces;
          result[operand].patch = patch.part(axis, side == 0 ? Parameter_range(cut, end) : Parameter_range(begin, cut));
          result[operand].is_pole[axis][side] = false;
          return result;
        }
    return std::nullopt;
  }

  // The point is an edge.
  bool has_point(const Spline_patch<3>& surface, const Spline_patch<3>& edge)
  {
    const Coincidence<3> equations(Patch_pair<3>(Spline_patch<3>(edge(edge.first_corner())), surface));
    const std::vector<Unknown> u = equations.unknowns();
    return !m_solve(equations.constraints(u, {false, false}), u).empty();
  }

  void add(Intersection_kind kind, Parameter_box parameters, std::optional<Solution> solution)
  {
    m_result.push_back({kind, std::move(parameters), std::vector<bool>(4, false), std::move(solution), false});
  }

  static Intersection_kind kind_of(const Solution& solution)
  {
    switch (solution.kind()) {
    case Solution_kind::CERTIFIED:
    case Solution_kind::CLUSTER: return Intersection_kind::TANGENT;
    case Solution_kind::CONTINUUM: return Intersection_kind::OVERLAP;
    case Solution_kind::UNDECIDED: break;
    }
    return Intersection_kind::UNDECIDED;
  }

  // Of a pole of an operand with a piece of the other one.
  void find_contacts_at(const Smooth_pole& pole, std::size_t operand, const Contact_piece& piece)
  {
    const Coincidence<3> equations(Patch_pair<3>(Spline_patch<3>(pole.point), piece.patch));
    const std::vector<Unknown> u = equations.unknowns();
    std::vector<Constraint> constraints = equations.constraints(u, {piece.is_without_end[0], piece.is_without_end[1]});
    const Vector_expression<3> normal = equations.normal(1, u);
    for (const Exact_vector<3>& tangent : pole.tangents)
      constraints.push_back(dot(normal, Vector_expression<3>(tangent[0], tangent[1], tangent[2])) == 0);
    if (!u.empty())
      exclude_poles(piece, u, constraints);
    const auto add_pole = [&](Intersection_kind kind, const Parameter_box& box, std::optional<Solution> solution) {
      Common_point point{kind, pole.parameters, std::vector<bool>(4, false), std::move(solution), false};
      const Parameter_box other = equations.all_parameters(box);
      point.parameters.insert(operand == 0 ? point.parameters.end() : point.parameters.begin(), other.begin(),
                              other.end());
      point.is_at_end[2 * operand + pole.axis] = true;
      m_result.push_back(std::move(point));
    };
    if (u.empty() && hold(constraints))
      add_pole(Intersection_kind::TANGENT, {}, std::nullopt);
    else if (!u.empty())
      for (const Solution& solution : m_solve(constraints, u))
        add_pole(kind_of(solution), solution.exact_box(), solution);
  }

  void find_contact_of(const Smooth_pole& a, const Smooth_pole& b)
  {
    const Exact_vector<3> normal = exact_cross(a.tangents[0], a.tangents[1]);
    if (a.point != b.point || !are_orthogonal(normal, b.tangents[0]) || !are_orthogonal(normal, b.tangents[1]))
      return;
    Common_point point{Intersection_kind::TANGENT, a.parameters, std::vector<bool>(4, false), std::nullopt, false};
    point.parameters.insert(point.parameters.end(), b.parameters.begin(), b.parameters.end());
    point.is_at_end[a.axis] = point.is_at_end[2 + b.axis] = true;
    m_result.push_back(std::move(point));
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Common_point> contacts_of_surfaces(const Patch_pair<3>& pair,
                                                                              Budgeted_solver& solve)
{
  return Contact_finder(pair, solve)();
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CONTACT_FINDER_H
