// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OWN_SHADOW_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OWN_SHADOW_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/access_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/exact_triples.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/surface_cells.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
What a surface hides of itself, if it lies on a plane or a quadric Q and its edges are in planes. On the ray S + t O,

  Q(S + t O) = t (b + t a), a = <O, A O> and b = <grad Q(S), O> for Q(x) = <x, A x> + <l, x> + c,

so there is one other point of the quadric, at t = -b/a. That it is on the ray changes where b = 0, on the silhouettes.
Whether it is on the surface changes where it passes an edge: in a plane <n,x> + d = 0, where (<n,S> + d) a = b <n,O>.
*/
class Own_shadow
{
  struct Plane
  {
    Exact_triple normal;
    Exact_rational offset;
  };

  Spline_patch<3> m_surface;
  std::array<Exact_triple, 3> m_matrix{}; // twice A
  Exact_triple m_linear{};
  std::vector<Plane> m_edges;
  bool m_is_flat = false, m_is_supported = true;

public:
  Own_shadow(const Spline_patch<3>& surface, const Operation_budget& budget) : m_surface(surface)
  {
    std::optional<Power_polynomial> equation;
    for (const int degree : {1, 2})
      if (!equation) {
        budget.check();
        equation = Intersections::Implicit_equation(surface, degree)();
        m_is_flat = equation && degree == 1;
      }
    if (!equation) {
      m_is_supported = false;
      return;
    }
    const Exact_triple origin{};
    for (int i = 0; i < 3; ++i) {
      const Power_polynomial slope = equation->derivative(i);
      m_linear[static_cast<std::size_t>(i)] = slope(origin);
      for (int j = 0; j < 3; ++j)
        m_matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = slope.derivative(j)(origin);
    }
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        if (!m_is_flat && !surface.is_closed(axis))
          add_edge(axis, side);
    m_is_supported = m_is_supported && (m_is_flat || covers_without_folds(budget));
  }

  // Whether all that follows is known.
  bool is_supported() const { return m_is_supported; }

  // What vanishes where the surface begins or ends to hide itself.
  std::vector<Cell_polynomial> zeros(const Surface_cell_3& cell, const Cell_vector& direction) const
  {
    if (m_is_flat)
      return {};
    const Cell_vector x = numerators_of(cell);
    const Cell_polynomial& w = cell.coordinates[3];
    Cell_vector gradient, bent; // w grad Q(X/w), 2 A O
    for (std::size_t i = 0; i < 3; ++i) {
      gradient[i] = dot(constant_vector(m_matrix[i]), x) + w * m_linear[i];
      bent[i] = dot(constant_vector(m_matrix[i]), direction);
    }
    const Cell_polynomial slope = dot(gradient, direction), bend = dot(bent, direction) * Exact_rational(1, 2);
    std::vector<Cell_polynomial> result{slope};
    for (const Plane& plane : m_edges) {
      const Cell_vector normal = constant_vector(plane.normal);
      result.push_back((dot(normal, x) + w * plane.offset) * bend - slope * dot(normal, direction));
    }
    return result;
  }

  // Whether the surface has another point on the ray from one of its points, before the eye, if there is one; nothing
  // if that is not decided. What looks along the surface hits it.
  std::optional<bool> is_hit(const Exact_triple& point, const Exact_triple& direction,
                             const std::optional<Exact_triple>& eye, Operation_budget& budget) const
  {
    Exact_rational slope(0), bend(0);
    for (std::size_t i = 0; i < 3; ++i) {
      slope += direction[i] * (m_linear[i] + dot(m_matrix[i], point));
      bend += direction[i] * dot(m_matrix[i], direction) / 2;
    }
    if (bend == 0)
      return slope == 0;
    const Exact_rational place(-slope / bend);
    if (!(place > 0))
      return false;
    if (eye && !(place * dot(direction, direction) < dot(difference(*eye, point), direction)))
      return false;
    Exact_triple hit = point;
    for (std::size_t i = 0; i < 3; ++i)
      hit[i] += place * direction[i];
    Common::Budgeted_solver solve(budget);
    const auto found = Intersections::common_points<3>(Patch_pair<3>(Spline_patch<3>(hit), m_surface), solve);
    budget = solve.budget();
    if (found.empty())
      return false;
    const auto is_known = [](const Common_point& x) { return x.kind != Intersection_kind::UNDECIDED; };
    return std::ranges::any_of(found, is_known) ? std::optional(true) : std::nullopt;
  }

private:
  // Whether the normal is on one side of the quadric everywhere. Where the surface turns back on it, it would end
  // there, too.
  bool covers_without_folds(const Operation_budget& budget) const
  {
    int sign = 0;
    for (const Surface_cell_3& cell : cells_of(m_surface)) {
      budget.check();
      const Cell_vector x = numerators_of(cell);
      Cell_vector gradient;
      for (std::size_t i = 0; i < 3; ++i)
        gradient[i] = dot(constant_vector(m_matrix[i]), x) + cell.coordinates[3] * m_linear[i];
      const Cell_polynomial side = dot(normal_of(cell), gradient);
      if (is_zero(side))
        return false;
      try {
        const int own = certified_weight_sign(without_sides(side), {.maximal_depth = 12, .maximal_parts = 500});
        if (sign != 0 && own != sign)
          return false;
        sign = own;
      } catch (const Invalid_input&) {
        return false;
      }
    }
    return true;
  }

  // The plane of an edge; one of those through a straight one. Poles are left out: rays meet them from single points.
  void add_edge(int axis, int side)
  {
    const auto [begin, end] = m_surface.domain(axis);
    const Exact_rational value = side == 0 ? begin : end;
    const Spline_patch<3> edge = m_surface.part(axis, {value, value});
    if (edge.is_one_point())
      return;
    constexpr int samples = 5;
    std::vector<Exact_triple> points;
    for (int i = 0; i <= samples; ++i) {
      const auto [first, last] = edge.domain(0);
      const std::array<Exact_rational, 1> at{Exact_rational(first + (last - first) * Exact_rational(i, samples))};
      points.push_back(edge(at));
    }
    Exact_triple along{}, normal{};
    for (const Exact_triple& p : points) {
      const Exact_triple chord = difference(p, points.front());
      if (dot(along, along) == 0)
        along = chord;
      if (dot(normal, normal) == 0)
        normal = cross(along, chord);
    }
    for (std::size_t i = 0; i < 3 && dot(normal, normal) == 0; ++i) {
      Exact_triple unit{};
      unit[i] = 1;
      normal = cross(along, unit);
    }
    const Plane plane{normal, Exact_rational(-dot(normal, points.front()))};
    Exact_function distance = edge.weight() * plane.offset;
    for (std::size_t i = 0; i < 3; ++i)
      distance = distance + edge.numerators()[i] * plane.normal[i];
    const auto [least, greatest] = distance.bounds();
    m_is_supported = m_is_supported && least == 0 && greatest == 0;
    m_edges.push_back(plane);
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OWN_SHADOW_H
