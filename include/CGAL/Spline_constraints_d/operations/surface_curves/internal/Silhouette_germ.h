// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTE_GERM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTE_GERM_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Silhouette_event_kind.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Plane_grid.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

/*
What a function f of a surface and the time looks like around a point where it is zero: by the branches of the curve f =
0 that begin at the point. None: the point is isolated, a curve is born or dies there. Four around a point, two on an
edge: a reconnection. Two around a point, one on an edge: nothing changes.
*/
struct Silhouette_germ
{
  int branches = 0;
  int around = 0;       // the sign of f around the point if there are no branches
  bool is_known = true; // whether the signs are
  bool is_on_edge = false;
  bool is_at_corner = false;

  static Silhouette_germ unknown() { return {0, 0, false, false, false}; }

  // By the signs along the lines that begin at a vertex: in between, f is nearly linear.
  static Silhouette_germ at_vertex(const std::vector<int>& along_u, const std::vector<int>& along_v)
  {
    Silhouette_germ germ;
    germ.is_on_edge = along_u.size() == 1 || along_v.size() == 1;
    germ.is_at_corner = along_u.size() == 1 && along_v.size() == 1;
    germ.around = along_u[0];
    for (const int a : along_u)
      for (const int b : along_v) {
        germ.is_known = germ.is_known && a != 0 && b != 0;
        germ.branches += a == b ? 0 : 1;
      }
    return germ;
  }

  // What happens, with the sign of the derivative of f by the time. None: nothing changes.
  std::optional<Silhouette_event_kind> event(int velocity) const
  {
    if (!is_known || (branches == 0 && velocity == 0))
      return Silhouette_event_kind::DEGENERATE;
    if (branches == 0)
      return around == velocity ? Silhouette_event_kind::DEATH : Silhouette_event_kind::BIRTH;
    if (is_at_corner && branches == 1)
      return Silhouette_event_kind::PASSAGE;
    if (branches > (is_on_edge ? 1 : 2))
      return Silhouette_event_kind::RECONNECTION;
    return std::nullopt;
  }
};

// The germs of f = <n,P> at points of a grid of tangent planes n, for an eye P.
class Germs_of_sight
{
  using Germ = Silhouette_germ;

  const Plane_grid& m_grid;
  const Sight_equations& m_equations;

public:
  Germs_of_sight(const Plane_grid& grid, const Sight_equations& equations) : m_grid(grid), m_equations(equations) {}

  // By the second derivatives where the first ones are zero.
  Germ inside(const Plane_cell& cell, const Parameter_box& box) const
  {
    const auto value = [&](std::size_t i) { return m_equations.value(cell.second[i], box); };
    const Rational_interval uu = value(0), uv = value(1), vv = value(2);
    const int determinant = sign_of(uu * vv - square(uv));
    return {determinant < 0 ? 4 : 0, determinant > 0 ? sign_of(uu) : 0, determinant != 0, false, false};
  }

  // Where all first derivatives vanish at a vertex: the branches are those of the quadratic forms in its cells, and the
  // lines along which f is zero.
  Germ at_critical_vertex(const std::array<std::size_t, 2>& line, const Parameter_range& time) const
  {
    Germ germ;
    germ.is_on_edge = m_grid.sides(0, line[0]).size() == 1 || m_grid.sides(1, line[1]).size() == 1;
    // along a line with one plane, f is zero when it is zero somewhere
    const std::array<bool, 2> is_zero_along{m_grid.has_one_plane(1, line[1]), m_grid.has_one_plane(0, line[0])};
    for (const int axis : {0, 1})
      if (is_zero_along[axis])
        germ.branches += static_cast<int>(m_grid.sides(axis, line[axis]).size());
    germ.is_known = !(germ.is_on_edge && germ.branches > 0);
    m_grid.visit_corners(line, [&](const Plane_cell& cell, Parameter_box box, int direction, int factor) {
      box.push_back(time);
      const auto sign = [&](std::size_t i) { return sign_of(m_equations.value(cell.second[i], box)) * factor; };
      const int uu = sign(0), uv = sign(1) * direction, vv = sign(2);
      const Germ whole = inside(cell, box);
      germ.is_known = germ.is_known && whole.is_known && (uu != 0 || is_zero_along[0]) && (vv != 0 || is_zero_along[1]);
      if (is_zero_along[0] || is_zero_along[1])
        germ.branches += is_zero_along[0] && is_zero_along[1] ? 0 : uv == (is_zero_along[0] ? vv : uu) ? 0 : 1;
      else if (uu != vv)
        ++germ.branches;
      else if (whole.branches > 0) {
        germ.is_known = germ.is_known && uv != 0;
        germ.branches += uv == uu ? 0 : 2;
      }
      germ.around = uu;
    });
    return germ;
  }

  // The sign of f beside a line where it is zero, on one side.
  int slope(int axis, const Plane_side& side, const Plane_cell& cell, Parameter_box box) const
  {
    box[axis] = {side.value, side.value};
    return sign_of(m_equations.value(cell.first[axis], box)) * side.direction * side.factor;
  }

  // Whether f grows across a line from one side to the other: its zeros are a graph over the line.
  static bool is_monotone(const std::vector<int>& slopes)
  {
    return slopes.size() == 2 && slopes[0] != 0 && slopes[0] == -slopes[1];
  }
};

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTE_GERM_H
