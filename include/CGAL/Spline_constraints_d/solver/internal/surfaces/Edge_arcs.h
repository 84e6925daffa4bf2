// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_EDGE_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_EDGE_ARCS_H

#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_store.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Face_equation.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Space_equation.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/lone_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The point where all unknowns in space are at these ends of their ranges, if it is in the domain.
inline std::optional<Plane_point> corner_of(const Space_equation& space, const Exact_ranges& domain,
                                            const std::map<int, Exact_rational>& ends)
{
  Exact_ranges in_space;
  std::vector<bool> is_fixed(domain.size(), false);
  for (const int j : space.unknowns()) {
    in_space.emplace_back(ends.at(j), ends.at(j));
    is_fixed[static_cast<std::size_t>(j)] = true;
  }
  const Exact_ranges place = space.with_values(in_space);
  return is_within(place, domain) ? std::optional(Plane_point{Plane_point::REGULAR, place, place, std::move(is_fixed)})
                                  : std::nullopt;
}

// Whether the edges of a face on which the equality in space is zero end on the face of another unknown in corners.
inline bool have_edges_corners(const Face_equation& face, int axis)
{
  return face.edges().empty() || face.space()->place_of(axis);
}

// The corners where edges of a face on which the equality in space is zero end on another face, as points of that one;
// but for those at which the other factors are zero. \pre `have_edges_corners(face, axis)`
inline std::vector<Plane_point> ends_of_edges(const Face_equation& face, int axis, const Exact_rational& value)
{
  std::vector<Plane_point> result;
  for (const Edge_of_face& edge : face.edges())
    if (edge.unknown != axis)
      if (std::optional<Plane_point> corner =
              corner_of(*face.space(), domain_of(face.system()),
                        {{face.axis(), face.value()}, {edge.unknown, edge.value}, {axis, value}}))
        if (!vanishes_at(face.crossing(), corner->box))
          result.push_back(*std::move(corner));
  return result;
}

/*
An edge of the domain on which the equality in space is zero, between two faces. Where one of the derivatives across
these is not zero the surface is regular. It comes to the edge from inside of the domain where the equality has
different signs on the faces beside it; where it has the same, it only touches the domain there. This changes at
points where curves on the faces end, which are vertices.
*/
class Edge_arcs
{
  const Face_equation &m_first, &m_second;
  const std::optional<Space_equation>& m_space; // that the faces are about
  const Exact_ranges m_domain;
  int m_parameter = -1;
  std::array<Power_polynomial, 2> m_slopes; // across the first face, and the second

public:
  // What comes of an edge.
  struct Result
  {
    Arc_indices arcs = {};
    std::vector<Exact_ranges> open = {}; // where the surface may be singular
    bool has_lone_part = false;
  };

  // Of two faces of a cell.
  Edge_arcs(const Face_equation& first, const Face_equation& second)
    : m_first(first), m_second(second), m_space(first.space()),
      m_domain(domain_of(first.system())), m_slopes{on_edge(first.function().derivative(first.axis())),
                                                    on_edge(first.function().derivative(second.axis()))}
  {
    for (std::size_t k = 0; m_space && k < 3; ++k)
      if (const int j = m_space->unknowns()[k]; j != first.axis() && j != second.axis())
        m_parameter = j;
  }

  // Whether they have an edge in common on which the equality in space is zero, and the surface is not singular along
  // all of it.
  bool is_regular() const
  {
    return m_space && m_first.edge(m_second.axis(), m_second.value()) &&
        m_second.edge(m_first.axis(), m_first.value()) && m_space->index() == m_first.equality() &&
        m_first.function() == m_second.function() && m_space->place_of(m_first.axis()) &&
        m_space->place_of(m_second.axis()) && (!m_slopes[0].is_zero() || !m_slopes[1].is_zero());
  }

  // Makes the arcs, after the curves on all faces are known.
  Result operator()(Arc_store& store) const
  {
    Result result;
    for (const Exact_rational& end : {range().first, range().second})
      add_corner(store, end);
    const std::vector<std::size_t> vertices = vertices_of(store);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const Exact_ranges& own = store.vertex(vertices[k]).box;
      if (!is_regular_at(own))
        result.open.push_back(own);
      if (k > 0)
        add_part(store, vertices[k - 1], vertices[k], result);
    }
    return result;
  }

  // Where surfaces lie outside.
  Lone_part lone_part() const
  {
    return {{{m_first.axis(), m_first.value()}, {m_second.axis(), m_second.value()}},
            on_edge(m_first.crossing() * m_second.crossing())};
  }

  // The equalities that are not zero on the edge.
  Constraint_system_d other_equalities() const
  {
    Constraint_system_d result(m_domain);
    for (std::size_t e = 0; e < m_first.system().equalities().size(); ++e)
      if (e != m_first.equality())
        result.add(m_first.system().equalities()[e], Relation::EQUAL);
    return result;
  }

private:
  const std::pair<Exact_rational, Exact_rational>& range() const
  {
    return m_domain[static_cast<std::size_t>(m_parameter)];
  }

  Power_polynomial on_edge(const Power_polynomial& function) const
  {
    return function.substituted(m_first.axis(), Power_polynomial(m_first.value()))
        .substituted(m_second.axis(), Power_polynomial(m_second.value()));
  }

  // In all unknowns, with bounds of those that others give.
  Exact_ranges part(const Exact_rational& from, const Exact_rational& to) const
  {
    Exact_ranges in_space;
    for (const int j : m_space->unknowns())
      in_space.push_back(j == m_first.axis()        ? std::pair(m_first.value(), m_first.value())
                             : j == m_second.axis() ? std::pair(m_second.value(), m_second.value())
                                                    : std::pair(from, to));
    return m_space->with_values(in_space);
  }

  bool is_on_edge(const Plane_point& point) const
  {
    const auto is_on = [&](const Face_equation& face) {
      const auto axis = static_cast<std::size_t>(face.axis());
      return point.is_fixed[axis] && point.box[axis].first == face.value();
    };
    const auto& [lower, upper] = point.box[static_cast<std::size_t>(m_parameter)];
    return is_on(m_first) && is_on(m_second) && range().first <= lower && upper <= range().second;
  }

  // A corner of the domain, if curves on other faces do not end there.
  void add_corner(Arc_store& store, const Exact_rational& end) const
  {
    for (std::size_t i = 0; i < store.number_of_vertices(); ++i)
      if (const Plane_point& known = store.vertex(i);
          is_on_edge(known) && known.box[static_cast<std::size_t>(m_parameter)] == std::pair(end, end))
        return;
    if (std::optional<Plane_point> corner =
            corner_of(*m_space, m_domain,
                      {{m_first.axis(), m_first.value()}, {m_second.axis(), m_second.value()}, {m_parameter, end}}))
      store.add_vertex(*std::move(corner));
  }

  // Along the edge.
  std::vector<std::size_t> vertices_of(const Arc_store& store) const
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < store.number_of_vertices(); ++i)
      if (is_on_edge(store.vertex(i)))
        result.push_back(i);
    const auto place = [&](std::size_t i) { return store.vertex(i).box[static_cast<std::size_t>(m_parameter)]; };
    std::stable_sort(result.begin(), result.end(),
                     [&](std::size_t i, std::size_t k) { return place(i).first < place(k).first; });
    return result;
  }

  bool is_regular_at(const Exact_ranges& box) const
  {
    return std::any_of(m_slopes.begin(), m_slopes.end(), [&](const Power_polynomial& slope) {
      return CGAL::certainly(sign_on(slope, box) != CGAL::ZERO);
    });
  }

  // Between two vertices that follow each other.
  void add_part(Arc_store& store, std::size_t first, std::size_t second, Result& result) const
  {
    const Exact_ranges &before = store.vertex(first).box, &behind = store.vertex(second).box;
    const auto parameter = static_cast<std::size_t>(m_parameter);
    const auto &from = before[parameter].second, &to = behind[parameter].first;
    if (!(from < to)) {
      result.open.push_back(part(before[parameter].first, behind[parameter].second));
      return;
    }
    const Exact_ranges middle = part(Exact_rational((from + to) / 2), Exact_rational((from + to) / 2));
    if (!is_within(middle, m_domain))
      return;
    std::vector<Exact_rational> place;
    for (const auto& [value, same] : middle)
      place.push_back(value);
    const int sign = CGAL::sign(m_first.crossing()(place)) * CGAL::sign(m_second.crossing()(place));
    if (sign >= 0) {
      result.has_lone_part = true;
      if (sign == 0)
        result.open.push_back(middle);
      return;
    }
    result.arcs.push_back(
        store.add_arc({std::make_shared<const Exact_ranges>(part(before[parameter].first, behind[parameter].second)),
                       is_first_better(before, behind) ? m_first.axis() : m_second.axis(),
                       m_parameter,
                       {first, second},
                       {},
                       true}));
  }

  // Whether the equality on the first face is regular on an edge, up to its ends, or at least inside. Else it is on the
  // second one.
  bool is_first_better(const Exact_ranges& first_end, const Exact_ranges& second_end) const
  {
    const auto is_good = [&](std::size_t face) {
      const Power_polynomial& slope = m_slopes[1 - face];
      return CGAL::certainly(sign_on(slope, first_end) != CGAL::ZERO) &&
          CGAL::certainly(sign_on(slope, second_end) != CGAL::ZERO);
    };
    return is_good(0) || (!is_good(1) && !m_slopes[1].is_zero());
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_EDGE_ARCS_H
