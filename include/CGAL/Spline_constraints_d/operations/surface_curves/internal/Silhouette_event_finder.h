// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTE_EVENT_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTE_EVENT_FINDER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Plane_grid.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Silhouette_germ.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

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

// Events in a continuous part of the tangent planes n of a surface, for an eye P(t): times where the curves f = <n,P> =
// 0 change near a point.
class Silhouette_events_on_part
{
  using Germ = Silhouette_germ;

  const Plane_grid& m_grid;
  Sight_equations& m_equations;
  Germs_of_sight m_germs;
  Found_silhouette_events& m_found;
  std::vector<Parameter_box> m_settled; // solutions on lines of the grid that are dealt with

public:
  Silhouette_events_on_part(const Plane_grid& grid, Sight_equations& equations, Found_silhouette_events& found)
    : m_grid(grid), m_equations(equations), m_germs(grid, equations), m_found(found)
  {}

  void operator()()
  {
    find_in_cells();
    for (const int axis : {0, 1})
      for (std::size_t line = 0; line < m_grid.number_of_lines(axis); ++line)
        if (m_grid.is_smooth_pole(axis, line))
          find_at_pole(axis, line);
        else if (m_grid.has_one_plane(axis, line))
          find_along_plane(axis, line);
        else
          find_on_line(axis, line);
    find_at_vertices();
  }

private:
  // f = f_u = f_v = 0.
  void find_in_cells()
  {
    for (const Plane_cell& cell : m_grid.cells()) {
      const Parameter_box domain{cell.box[0], cell.box[1], m_equations.times()};
      for (const Sight_solution& s : m_equations.solve({cell.planes, cell.first[0], cell.first[1]}, domain)) {
        std::vector<std::pair<int, Exact_rational>> lines;
        for (const int axis : {0, 1})
          for (const Exact_rational& end : {cell.box[axis].first, cell.box[axis].second})
            if (s.box[axis].first <= end && end <= s.box[axis].second)
              lines.emplace_back(axis, end);
        if (!(lines.empty() ? s.is_certified() : s.is_one()))
          add_unclear(s);
        else if (lines.empty())
          add(s.box, m_germs.inside(cell, s.box), velocity(cell, s.box));
        else if (lines.size() == 1)
          settle_on_line(cell, lines[0].first, lines[0].second, s);
        else
          settle_at_vertex(cell, lines, s);
      }
    }
  }

  // A solution in a cell that may be on one of its sides: whether it is, and a solution in the next cell, too.
  void settle_on_line(const Plane_cell& cell, int axis, const Exact_rational& value, const Sight_solution& solution)
  {
    const std::size_t line = *m_grid.line_at(axis, value);
    Parameter_box box = widened(solution.region, cell);
    box[axis] = {value, value};
    std::vector<Plane_functions> functions;
    for (const Plane_functions& f : {cell.planes, cell.first[0], cell.first[1]})
      functions.push_back(on_face(f, box));
    std::vector<Sight_solution> found = m_equations.solve(functions, box);
    if (found.empty()) {
      if (solution.is_certified())
        add(solution.box, m_germs.inside(cell, solution.box), velocity(cell, solution.box));
      else
        add_unclear(solution);
      return;
    }
    const std::vector<Plane_side> sides = m_grid.sides(axis, line);
    const std::size_t across = index_across(cell, axis);
    Germ germ;
    germ.is_on_edge = sides.size() == 1;
    bool is_one = found.size() == 1 && found[0].is_certified();
    for (const Plane_side& side : sides)
      if (const Plane_cell& next = m_grid.cell(axis, side.cell, across); is_one && &next != &cell) {
        Parameter_box there = box;
        there[axis] = {side.value, side.value};
        functions.push_back(on_face(next.first[axis], there));
        found = m_equations.solve(functions, box);
        is_one = found.size() == 1 && found[0].is_certified();
      }
    const Parameter_box point = is_one ? found[0].box : solution.box;
    if (is_again(m_settled, m_grid.canonical(point)))
      return;
    m_settled.push_back(m_grid.canonical(point));
    if (m_grid.is_smooth_pole(axis, line))
      return;
    germ.is_known = is_one;
    for (const Plane_side& side : sides) {
      Parameter_box there = point;
      there[axis] = {side.value, side.value};
      const Plane_cell& next = m_grid.cell(axis, side.cell, across);
      const Germ half = is_one ? m_germs.inside(next, there) : Germ{};
      germ.is_known = germ.is_known && half.is_known;
      germ.branches += half.branches / 2;
      germ.around = half.around * side.factor;
    }
    // Along an edge with one plane, the edge itself is a branch.
    germ.is_known = germ.is_known && !(germ.is_on_edge && m_grid.has_one_plane(axis, line));
    add(point, germ, velocity(cell, point));
  }

  // A solution that may be at a corner of its cell: whether it is, and a solution in all cells there.
  void settle_at_vertex(const Plane_cell& cell, const std::vector<std::pair<int, Exact_rational>>& lines,
                        const Sight_solution& solution)
  {
    Parameter_box point = widened(solution.region, cell);
    std::array<std::size_t, 2> line{};
    bool is_vertex = lines.size() == 2 && lines[0].first != lines[1].first, is_at_pole = false;
    for (const auto& [axis, value] : lines) {
      point[axis] = {value, value};
      line[axis] = *m_grid.line_at(axis, value);
      is_at_pole = is_at_pole || m_grid.is_smooth_pole(axis, line[axis]);
    }
    if (is_again(m_settled, m_grid.canonical(point)))
      return;
    m_settled.push_back(m_grid.canonical(point));
    if (is_at_pole)
      return;
    std::vector<Plane_functions> functions;
    if (is_vertex)
      m_grid.visit_corners(line, [&](const Plane_cell& next, const Parameter_box& corner, int, int) {
        for (const Plane_functions& f : {next.planes, next.first[0], next.first[1]})
          functions.push_back(on_face(f, corner));
      });
    const std::vector<Sight_solution> found =
        is_vertex ? m_equations.solve(functions, point) : std::vector<Sight_solution>();
    const bool is_one = found.size() == 1 && found[0].is_certified();
    add(is_one ? found[0].box : solution.box,
        is_one ? m_germs.at_critical_vertex(line, found[0].box[2]) : Germ::unknown(), velocity(cell, solution.box));
  }

  // f and its derivative along a line are zero.
  void find_on_line(int axis, std::size_t line)
  {
    const int other = 1 - axis;
    const std::vector<Plane_side> sides = m_grid.sides(axis, line);
    const Plane_side& own = sides.back();
    for (std::size_t across = 0; across < m_grid.size(other); ++across) {
      const Plane_cell& cell = m_grid.cell(axis, own.cell, across);
      Parameter_box box{cell.box[0], cell.box[1], m_equations.times()};
      box[axis] = {own.value, own.value};
      const std::vector<Plane_functions> functions{on_face(cell.planes, box), on_face(cell.first[other], box)};
      for (const Sight_solution& s : m_equations.solve(functions, box)) {
        Germ germ;
        germ.is_on_edge = sides.size() == 1;
        germ.around = sign_of(m_equations.value(cell.along(other), s.box)) * own.factor;
        germ.is_known = germ.around != 0;
        std::vector<int> slopes;
        for (const Plane_side& side : sides) {
          slopes.push_back(m_germs.slope(axis, side, m_grid.cell(axis, side.cell, across), s.box));
          germ.is_known = germ.is_known && slopes.back() != 0;
          germ.branches += slopes.back() == germ.around ? 0 : 2;
        }
        if (Germs_of_sight::is_monotone(slopes))
          continue;
        const bool is_known = is_again(m_settled, m_grid.canonical(s.box));
        if (!s.is_certified() && !(is_known && is_small(s.box, box)))
          add_unclear(s);
        else if (is_known)
          continue;
        else if (!is_at_end(cell, other, functions, s))
          add(s.box, germ, velocity(cell, s.box));
      }
    }
  }

  // Where the eye passes the plane that is tangent all along a line: nothing happens if the line is none in space.
  void find_along_plane(int axis, std::size_t line)
  {
    if (m_grid.is_smooth(axis, line))
      return;
    const Plane_side own = m_grid.sides(axis, line).back();
    Parameter_box box{m_grid.domain(0), m_grid.domain(1), m_equations.times()};
    box[axis] = {own.value, own.value};
    const Plane_cell& cell = m_grid.cell(axis, own.cell, 0);
    for (Sight_solution& s : solve_at_corner(cell, axis, own)) {
      s.box[1 - axis] = box[1 - axis];
      if (s.is_certified())
        add(s.box, Germ::unknown(), 0);
      else
        add_unclear(s);
    }
  }

  // Where the eye passes the tangent plane at a pole: by the number of branches around it.
  void find_at_pole(int axis, std::size_t line)
  {
    const int other = 1 - axis;
    const Plane_side own = m_grid.sides(axis, line).back();
    for (Sight_solution& pole : solve_at_corner(m_grid.cell(axis, own.cell, 0), axis, own)) {
      Germ germ;
      germ.is_known = pole.is_certified();
      germ.is_on_edge = !m_grid.is_seam(other);
      std::vector<Parameter_box> branches;
      for (std::size_t across = 0; across < m_grid.size(other) && germ.is_known; ++across) {
        const Plane_cell& cell = m_grid.cell(axis, own.cell, across);
        Parameter_box box{cell.box[0], cell.box[1], widened(pole.region, cell)[2]};
        box[axis] = {own.value, own.value};
        for (const Sight_solution& s :
             m_equations.solve({on_face(cell.planes, box), on_face(cell.first[axis], box)}, box)) {
          germ.is_known = germ.is_known && s.is_certified();
          if (!is_again(branches, m_grid.canonical(s.box)))
            branches.push_back(m_grid.canonical(s.box));
        }
      }
      germ.branches = static_cast<int>(branches.size());
      // A point of an open edge at its end, or an odd number around a pole: not what is counted here.
      for (const Parameter_box& branch : branches)
        germ.is_known = germ.is_known && !(germ.is_on_edge && touches_end(branch, other));
      germ.is_known = germ.is_known && (germ.is_on_edge || germ.branches % 2 == 0);
      const Plane_cell& first = m_grid.cell(axis, own.cell, 0);
      Parameter_box corner = pole.box;
      corner[other] = {first.box[other].first, first.box[other].first};
      if (germ.branches == 0 && germ.is_known) {
        germ.around = m_germs.slope(axis, own, first, corner);
        germ.is_known = germ.around != 0;
      }
      pole.box[other] = m_grid.domain(other);
      if (pole.kind == Solution_kind::UNDECIDED || pole.kind == Solution_kind::CONTINUUM)
        add_unclear(pole);
      else
        add(pole.box, germ, velocity(first, corner));
    }
  }

  // f = 0 where lines cross.
  void find_at_vertices()
  {
    for (std::size_t i = 0; i < m_grid.number_of_lines(0); ++i)
      for (std::size_t j = 0; j < m_grid.number_of_lines(1); ++j)
        if (!m_grid.is_smooth_pole(0, i) && !m_grid.is_smooth_pole(1, j))
          find_at_vertex(m_grid.sides(0, i), m_grid.sides(1, j));
  }

  void find_at_vertex(const std::vector<Plane_side>& u_sides, const std::vector<Plane_side>& v_sides)
  {
    const Plane_side &u = u_sides.back(), &v = v_sides.back();
    const Plane_cell& cell = m_grid.cell(0, u.cell, v.cell);
    const Parameter_box box{{u.value, u.value}, {v.value, v.value}, m_equations.times()};
    for (const Sight_solution& s : m_equations.solve({on_face(cell.planes, box)}, box)) {
      const auto slopes = [&](int axis, const std::vector<Plane_side>& sides, const Plane_side& other) {
        std::vector<int> result;
        for (const Plane_side& side : sides)
          result.push_back(m_germs.slope(axis, side, m_grid.cell(axis, side.cell, other.cell), s.box) * other.factor);
        return result;
      };
      const std::vector<int> along_u = slopes(0, u_sides, v), along_v = slopes(1, v_sides, u);
      if (Germs_of_sight::is_monotone(along_u) || Germs_of_sight::is_monotone(along_v))
        continue;
      if (is_again(m_settled, s.box) && (s.is_certified() || is_small(s.box, box)))
        continue;
      if (s.is_certified())
        add(s.box, Germ::at_vertex(along_u, along_v), velocity(cell, s.box));
      else
        add_unclear(s);
    }
  }

  // The sign of the derivative of f by the time.
  int velocity(const Plane_cell& cell, const Parameter_box& box) const
  {
    Parameter_box wide = box;
    wide[2] = widened(box, cell)[2];
    return sign_of(m_equations.velocity(cell.planes, wide));
  }

  // Whether a box is a tiny part of another one: next to a settled point, what the tolerance leaves of it.
  static bool is_small(const Parameter_box& part, const Parameter_box& whole)
  {
    for (std::size_t j = 0; j < part.size(); ++j)
      if ((part[j].second - part[j].first) * 1024 > whole[j].second - whole[j].first)
        return false;
    return true;
  }

  // Whether a solution on a line is at an end of a cell, where it is found as a vertex.
  bool is_at_end(const Plane_cell& cell, int other, const std::vector<Plane_functions>& functions,
                 const Sight_solution& solution)
  {
    for (const Exact_rational& end : {cell.box[other].first, cell.box[other].second}) {
      if (end < solution.box[other].first || solution.box[other].second < end)
        continue;
      std::vector<Plane_functions> there = functions;
      for (Plane_functions& planes : there)
        for (Exact_function& f : planes)
          f = f.slice(0, end);
      Parameter_box box = widened(solution.region, cell);
      for (const int axis : {0, 1})
        box[axis] = axis == other ? Parameter_range(end, end) : solution.box[axis];
      const std::vector<Sight_solution> found = m_equations.solve(there, box);
      if (found.empty())
        continue;
      if (std::ranges::none_of(found, [](const Sight_solution& s) { return s.is_certified(); }))
        add_unclear(solution);
      return true;
    }
    return false;
  }

  std::vector<Sight_solution> solve_at_corner(const Plane_cell& cell, int axis, const Plane_side& side)
  {
    Parameter_box box{cell.box[0], cell.box[1], m_equations.times()};
    box[axis] = {side.value, side.value};
    box[1 - axis].second = box[1 - axis].first;
    return m_equations.solve({on_face(cell.planes, box)}, box);
  }

  std::size_t index_across(const Plane_cell& cell, int axis) const
  {
    const auto index = static_cast<std::size_t>(&cell - m_grid.cells().data());
    return axis == 0 ? index % m_grid.size(1) : index / m_grid.size(1);
  }

  bool touches_end(const Parameter_box& box, int axis) const
  {
    return box[axis].first <= m_grid.domain(axis).first || m_grid.domain(axis).second <= box[axis].second;
  }

  // A little wider, within the cell.
  Parameter_box widened(Parameter_box box, const Plane_cell& cell) const
  {
    const Parameter_box domain{cell.box[0], cell.box[1], m_equations.times()};
    for (std::size_t j = 0; j < box.size(); ++j) {
      const Exact_rational margin((domain[j].second - domain[j].first) * power_of_two(-40));
      box[j] = {Exact_rational(box[j].first - margin), Exact_rational(box[j].second + margin)};
    }
    return clipped(std::move(box), domain);
  }

  static bool is_again(const std::vector<Parameter_box>& known, const Parameter_box& box)
  {
    return std::any_of(known.begin(), known.end(), [&](const Parameter_box& other) { return touch(other, box); });
  }

  void add_unclear(const Sight_solution& solution)
  {
    if (solution.kind == Solution_kind::CLUSTER)
      add(solution.box, Germ::unknown(), 0);
    else
      m_found.undecided_boxes.emplace_back(solution.box, solution.reason);
  }

  void add(const Parameter_box& box, const Germ& germ, int velocity)
  {
    const auto kind = germ.event(velocity);
    const auto is_same = [&](const auto& known) { return known.kind == kind && touch(known.box, box); };
    if (kind &&
        (kind != Silhouette_event_kind::DEGENERATE ||
         std::none_of(m_found.events.begin(), m_found.events.end(), is_same)))
      m_found.events.push_back({*kind, box, {}});
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Found_silhouette_events silhouette_events_of(const Exact_map<3>& surface,
                                                                            const Exact_map<3>& path, bool is_parallel,
                                                                            const Solver_options& options)
{
  const Spline_patch<3> patch(surface), eye(path);
  const auto& [x, y, z] = eye.numerators();
  Sight_equations equations({x, y, z, is_parallel ? eye.weight() * Exact_rational(0) : eye.weight()}, options);
  Found_silhouette_events found;
  try {
    const auto check = [&] { equations.solver().budget().check(); };
    for (const Continuous_part<4>& part : tangent_planes(patch, check)) {
      if (part.functions.is_zero()) {
        found.undecided_boxes.emplace_back(
            Parameter_box{part.functions.domain(0), part.functions.domain(1), equations.times()},
            Undecided_reason::CONTINUUM);
        continue;
      }
      const Plane_grid grid(patch, part.functions, check);
      Silhouette_events_on_part(grid, equations, found)();
    }
  } catch (const Run_stopped& stop) {
    found.undecided_boxes.emplace_back(Parameter_box{patch.domain(0), patch.domain(1), equations.times()}, stop.reason);
  }
  finish(found, place_on_surface(patch), equations.solver(), equations.times());
  return found;
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SILHOUETTE_EVENT_FINDER_H
