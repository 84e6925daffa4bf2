// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_PLANE_GRID_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_PLANE_GRID_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Sight_equations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// The tangent planes of a part of a surface over one cell of its grid, with their derivatives.
struct Plane_cell
{
  Parameter_box box;
  Plane_functions planes;
  std::array<Plane_functions, 2> first;  // by u, v
  std::array<Plane_functions, 3> second; // by uu, uv, vv

  // The second derivative along an axis.
  const Plane_functions& along(int axis) const { return second[axis == 0 ? 0 : 2]; }
};

// The cells at one side of a line of the grid.
struct Plane_side
{
  std::size_t cell;     // their index along the axis
  Exact_rational value; // the parameter of the line there: a seam has two
  int direction;        // 1: the parameter grows from the line on, -1: it falls
  int factor;           // the sign that makes functions continuous, across a seam
};

// The cells of a continuous part of the tangent planes of a surface, and the lines between them. A seam is one line.
class Plane_grid
{
  const Spline_patch<3>& m_patch;
  std::array<std::vector<Exact_rational>, 2> m_breaks;
  std::array<int, 2> m_seam{0, 0}; // the sign by which functions differ, 0: none
  std::vector<Plane_cell> m_cells;

public:
  // Before each cell `check()` may end the work by an exception.
  template <class Check>
  Plane_grid(const Spline_patch<3>& patch, const Cell_functions<4>& functions, const Check& check)
    : m_patch(patch), m_breaks{functions.breaks(0), functions.breaks(1)}
  {
    for (const int axis : {0, 1})
      if (functions.domain(axis) == patch.domain(axis) && patch.is_closed(axis))
        if (const auto ratio = functions.ratio(axis, functions.size(axis) - 1, 0))
          m_seam[axis] = *ratio > 0 ? 1 : -1;
    for (std::size_t i = 0; i < functions.size(0); ++i)
      for (std::size_t j = 0; j < functions.size(1); ++j) {
        check();
        m_cells.push_back(made(functions.part(0, i, i + 1).part(1, j, j + 1)));
      }
  }

  const std::vector<Plane_cell>& cells() const { return m_cells; }
  std::size_t size(int axis) const { return m_breaks[axis].size() - 1; }
  Parameter_range domain(int axis) const { return {m_breaks[axis].front(), m_breaks[axis].back()}; }
  bool is_seam(int axis) const { return m_seam[axis] != 0; }
  std::size_t number_of_lines(int axis) const { return size(axis) + (is_seam(axis) ? 0 : 1); }

  const Plane_cell& cell(int axis, std::size_t along, std::size_t across) const
  {
    return axis == 0 ? m_cells[along * size(1) + across] : m_cells[across * size(1) + along];
  }

  // One side of a line, an edge, or both.
  std::vector<Plane_side> sides(int axis, std::size_t line) const
  {
    std::vector<Plane_side> result;
    if (line > 0)
      result.push_back({line - 1, m_breaks[axis][line], -1, 1});
    else if (is_seam(axis))
      result.push_back({size(axis) - 1, m_breaks[axis].back(), -1, m_seam[axis]});
    if (line < size(axis))
      result.push_back({line, m_breaks[axis][line], 1, 1});
    return result;
  }

  // The line at a parameter.
  std::optional<std::size_t> line_at(int axis, const Exact_rational& value) const
  {
    const auto found = std::find(m_breaks[axis].begin(), m_breaks[axis].end(), value);
    if (found == m_breaks[axis].end())
      return std::nullopt;
    const auto line = static_cast<std::size_t>(found - m_breaks[axis].begin());
    return is_seam(axis) && line == size(axis) ? 0 : line;
  }

  // Calls `visit(cell, point, direction, factor)` for the cells at a vertex, the point as one of the cell, with the
  // product of the directions in which both parameters leave it.
  template <class Visit>
  void visit_corners(const std::array<std::size_t, 2>& line, const Visit& visit) const
  {
    for (const Plane_side& u : sides(0, line[0]))
      for (const Plane_side& v : sides(1, line[1]))
        visit(cell(0, u.cell, v.cell), {{u.value, u.value}, {v.value, v.value}}, u.direction * v.direction,
              u.factor * v.factor);
  }

  // For comparisons: with the parameters of seams at their lower ends.
  Parameter_box canonical(Parameter_box box) const
  {
    for (const int axis : {0, 1})
      if (Parameter_range& range = box[static_cast<std::size_t>(axis)];
          is_seam(axis) && range.second == m_breaks[axis].back())
        range = {m_breaks[axis].front(), m_breaks[axis].front()};
    return box;
  }

  // Whether an edge is one point in space with one tangent plane.
  bool is_smooth_pole(int axis, std::size_t line) const
  {
    if (is_seam(axis) || (line > 0 && line < size(axis)))
      return false;
    const Exact_rational& value = m_breaks[axis][line];
    return m_patch.part(axis, {value, value}).part(0, domain(1 - axis)).is_one_point() && has_one_plane(axis, line);
  }

  // Whether the tangent planes along a line are all the same.
  bool has_one_plane(int axis, std::size_t line) const
  {
    std::optional<std::array<Exact_rational, 4>> plane;
    bool result = true;
    visit_coefficients(axis, sides(axis, line).back(), &Plane_cell::planes, [&](const auto& n) {
      if (!plane && n != std::array<Exact_rational, 4>())
        plane = n;
      result = result && (!plane || minors(*plane, n) == std::array<Exact_rational, 6>());
    });
    return result && plane;
  }

  // Whether the derivatives across a line with one plane differ by a positive factor and multiples of that plane only.
  // Silhouettes pass such a line as if it were none.
  bool is_smooth(int axis, std::size_t line) const
  {
    const std::vector<Plane_side> both = sides(axis, line);
    if (both.size() < 2)
      return false;
    std::array<std::vector<Exact_rational>, 2> slopes;
    std::optional<std::array<Exact_rational, 4>> plane;
    visit_coefficients(axis, both[0], &Plane_cell::planes, [&](const auto& n) {
      if (!plane && n != std::array<Exact_rational, 4>())
        plane = n;
    });
    for (const std::size_t i : {0, 1}) {
      const auto add = [&](const std::array<Exact_rational, 4>& n) {
        for (const Exact_rational& minor : minors(*plane, n))
          slopes[i].push_back(Exact_rational(minor * both[i].factor));
      };
      for (std::size_t j = 0; j < size(1 - axis); ++j)
        add_coefficients(face(axis, both[i], j, cell(axis, both[i].cell, j).first[axis]), add);
    }
    return are_positive_multiples(slopes[0], slopes[1]);
  }

  // Functions of a cell at the line on one of its sides.
  Plane_functions face(int axis, const Plane_side& side, std::size_t across, const Plane_functions& functions) const
  {
    Parameter_box box = cell(axis, side.cell, across).box;
    box[static_cast<std::size_t>(axis)] = {side.value, side.value};
    return on_face(functions, box);
  }

private:
  static Plane_cell made(const Cell_functions<4>& functions)
  {
    Plane_cell result{{functions.domain(0), functions.domain(1)}, functions.splines(), {}, {}};
    for (const int axis : {0, 1})
      result.first[axis] = derivative(result.planes, axis);
    result.second = {derivative(result.first[0], 0), derivative(result.first[0], 1), derivative(result.first[1], 1)};
    return result;
  }

  template <class Visit>
  static void add_coefficients(const Plane_functions& f, const Visit& visit)
  {
    for (std::size_t i = 0; i < f[0].coefficients().size(); ++i)
      visit(std::array<Exact_rational, 4>{f[0].coefficients()[i], f[1].coefficients()[i], f[2].coefficients()[i],
                                          f[3].coefficients()[i]});
  }

  template <class Visit>
  void visit_coefficients(int axis, const Plane_side& side, Plane_functions Plane_cell::*functions,
                          const Visit& visit) const
  {
    for (std::size_t j = 0; j < size(1 - axis); ++j)
      add_coefficients(face(axis, side, j, cell(axis, side.cell, j).*functions), visit);
  }

  static std::array<Exact_rational, 6> minors(const std::array<Exact_rational, 4>& a,
                                              const std::array<Exact_rational, 4>& b)
  {
    std::array<Exact_rational, 6> result;
    auto next = result.begin();
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        *next++ = Exact_rational(a[i] * b[j] - a[j] * b[i]);
    return result;
  }

  static bool are_positive_multiples(const std::vector<Exact_rational>& a, const std::vector<Exact_rational>& b)
  {
    std::optional<Exact_rational> factor;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == 0 && b[i] == 0)
        continue;
      if (a[i] == 0 || b[i] == 0 || (factor && a[i] != *factor * b[i]))
        return false;
      factor = Exact_rational(a[i] / b[i]);
    }
    return factor && *factor > 0;
  }
};

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_PLANE_GRID_H
