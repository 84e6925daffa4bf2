// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SWEEP_EVENT_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SWEEP_EVENT_FINDER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Plane_grid.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Sweep_sight.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

/*
Events of the silhouettes F = G = 0 of a sweep, on a part of the surface with continuous tangent planes and a part of
the motion with a continuous velocity: in cells, on their faces and edges, as those of a surface that stands still. F
does not depend on the time of the eye: on the surface F = 0, the zeros of G change.
*/
class Sweep_events_on_part
{
  using Index = std::array<std::size_t, 3>; // of a cell, along u, v, t

  const Plane_grid& m_grid;
  std::vector<Exact_rational> m_times;
  Sweep_sight m_sight;
  Parameter_range m_eye_times;
  Budgeted_solver& m_solver;
  Found_silhouette_events& m_found;
  std::vector<Parameter_box> m_at_poles; // where curves pass a pole

public:
  Sweep_events_on_part(const Spline_patch<3>& surface, const Plane_grid& grid, const Smooth_motion& motion,
                       const Space_map& eye, Budgeted_solver& solver, Found_silhouette_events& found)
    : m_grid(grid), m_sight(surface, motion, eye), m_eye_times(eye.domain(0)), m_solver(solver), m_found(found)
  {
    for (const Space_map& map : motion.maps)
      m_times = united(m_times.empty() ? map.breaks(0) : m_times, map.breaks(0));
  }

  void operator()()
  {
    if (seems_to_slide()) {
      m_found.undecided_boxes.emplace_back(
          Parameter_box{m_grid.domain(0), m_grid.domain(1), {m_times.front(), m_times.back()}, m_eye_times},
          Undecided_reason::CONTINUUM);
      return;
    }
    visit_cells({0, 0, 0}, {size(0), size(1), size(2)}, [&](const Index& index) { find_inside(index); });
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t line = 0; line < number_of_lines(axis); ++line)
        if (!is_passed_over(axis, line))
          find_on_face(axis, line);
        else if (!m_grid.is_smooth(static_cast<int>(axis), line))
          find_at_plane(axis, line);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t first = 0; first < number_of_lines((axis + 1) % 3); ++first)
        for (std::size_t second = 0; second < number_of_lines((axis + 2) % 3); ++second)
          if (!is_passed_over((axis + 1) % 3, first) && !is_passed_over((axis + 2) % 3, second))
            find_on_edge(axis, first, second);
  }

private:
  // Whether F is zero at some points of the first cell: the surface moves along itself, or stands still.
  bool seems_to_slide() const
  {
    const Index first{0, 0, 0};
    const Parameter_box box = box_of(first);
    const Sweep_equations e = m_sight.equations(cell(first), times(first), box, false);
    for (const int i : {1, 2, 3, 4}) {
      std::vector<Exact_rational> point;
      for (std::size_t j = 0; j < 4; ++j)
        point.push_back(
            Exact_rational(box[j].first + (box[j].second - box[j].first) * Exact_rational(i, 5 + static_cast<int>(j))));
      if (e.envelope(point) != 0)
        return false;
    }
    return true;
  }

  std::size_t size(std::size_t axis) const
  {
    return axis < 2 ? m_grid.size(static_cast<int>(axis)) : m_times.size() - 1;
  }

  std::size_t number_of_lines(std::size_t axis) const
  {
    return axis < 2 ? m_grid.number_of_lines(static_cast<int>(axis)) : m_times.size();
  }

  std::vector<Plane_side> sides(std::size_t axis, std::size_t line) const
  {
    if (axis < 2)
      return m_grid.sides(static_cast<int>(axis), line);
    std::vector<Plane_side> result;
    if (line > 0)
      result.push_back({line - 1, m_times[line], -1, 1});
    if (line < size(2))
      result.push_back({line, m_times[line], 1, 1});
    return result;
  }

  // A line of the surface with one tangent plane: the equations there are those of one point.
  bool is_passed_over(std::size_t axis, std::size_t line) const
  {
    return axis < 2 && m_grid.has_one_plane(static_cast<int>(axis), line);
  }

  const Plane_cell& cell(const Index& index) const { return m_grid.cell(0, index[0], index[1]); }

  Parameter_range times(const Index& index) const { return {m_times[index[2]], m_times[index[2] + 1]}; }

  Parameter_box box_of(const Index& index) const
  {
    return {cell(index).box[0], cell(index).box[1], times(index), m_eye_times};
  }

  template <class Visit>
  static void visit_cells(const Index& begin, const Index& end, const Visit& visit)
  {
    Index i;
    for (i[0] = begin[0]; i[0] < end[0]; ++i[0])
      for (i[1] = begin[1]; i[1] < end[1]; ++i[1])
        for (i[2] = begin[2]; i[2] < end[2]; ++i[2])
          visit(i);
  }

  // F = G = 0 with parallel gradients by u, v, t: one of them is a multiple of the other one, by -1 to 1.
  void find_inside(const Index& index)
  {
    const Parameter_box domain = box_of(index);
    std::vector<Parameter_box> known;
    for (const bool is_multiple_of_first : {true, false}) {
      m_solver.budget().check();
      const Sweep_equations e = m_sight.equations(cell(index), times(index), domain, true);
      std::vector<Constraint> constraints{e.envelope == 0, e.sight == 0};
      for (std::size_t i = 0; i < 3; ++i) {
        const Expression f = derivative(e.envelope, e.unknowns[i]), g = derivative(e.sight, e.unknowns[i]);
        constraints.push_back((is_multiple_of_first ? g - e.unknowns[4] * f : f - e.unknowns[4] * g) == 0);
      }
      for (const Sight_solution& s : solutions(constraints, e, domain)) {
        const auto is_known = [&](const Parameter_box& box) { return touch(box, s.box); };
        const bool is_unclear = !s.is_certified() && !s.is_one();
        if (!is_unclear && std::any_of(known.begin(), known.end(), is_known))
          continue;
        if (!is_unclear)
          known.push_back(s.box);
        const bool is_on_side =
            touches_end(s.box, domain, 0) || touches_end(s.box, domain, 1) || touches_end(s.box, domain, 2);
        if (s.is_one() && is_at_pole(s.box, domain))
          m_at_poles.push_back(s.box);
        else if (!s.is_certified())
          add_unclear(s);
        else
          add_with(index, s.box,
                   [&](const Sweep_germs& germs) { return is_on_side ? Silhouette_germ::unknown() : germs.inside(); });
      }
    }
  }

  // On a face where one of u, v, t is constant: the gradients by the two others are parallel.
  void find_on_face(std::size_t axis, std::size_t line)
  {
    const std::vector<Plane_side> both = sides(axis, line);
    Index begin{0, 0, 0}, end{size(0), size(1), size(2)};
    begin[axis] = both.back().cell;
    end[axis] = begin[axis] + 1;
    visit_cells(begin, end, [&](const Index& index) {
      m_solver.budget().check();
      Parameter_box domain = box_of(index);
      domain[axis] = {both.back().value, both.back().value};
      const Sweep_equations e = m_sight.equations(cell(index), times(index), domain, false);
      const std::size_t a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
      for (const Sight_solution& s : solutions({e.envelope == 0, e.sight == 0, e.minor(0, 1) == 0}, e, domain)) {
        const bool is_at_end = touches_end(s.box, domain, a) || touches_end(s.box, domain, b);
        Silhouette_germ germ;
        germ.is_on_edge = both.size() == 1;
        std::vector<int> slopes;
        for (const Plane_side& side : both)
          with_germs(moved(index, axis, side.cell), moved(s.box, axis, side.value), [&](const Sweep_germs& germs) {
            germ.around = germs.bend(axis) * side.factor;
            slopes.push_back(germs.slope(axis, {a, b}) * side.direction * side.factor);
          });
        germ.is_known = germ.around != 0 && !is_at_end;
        for (const int slope : slopes) {
          germ.is_known = germ.is_known && slope != 0;
          germ.branches += slope == germ.around ? 0 : 2;
        }
        if (slopes.size() == 2 && slopes[0] != 0 && slopes[0] == -slopes[1])
          continue;
        if (!s.is_certified())
          add_unclear(s);
        else
          add_with(moved(index, axis, both.back().cell), s.box, [&](const Sweep_germs&) { return germ; });
      }
    });
  }

  // Where two of u, v, t are constant, F = G = 0.
  void find_on_edge(std::size_t axis, std::size_t first_line, std::size_t second_line)
  {
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    const std::vector<Plane_side> first = sides(a, first_line), second = sides(b, second_line);
    for (std::size_t along = 0; along < size(axis); ++along) {
      m_solver.budget().check();
      Index index;
      index[axis] = along;
      index[a] = first.back().cell;
      index[b] = second.back().cell;
      Parameter_box domain = box_of(index);
      domain[a] = {first.back().value, first.back().value};
      domain[b] = {second.back().value, second.back().value};
      const Sweep_equations e = m_sight.equations(cell(index), times(index), domain, false);
      for (const Sight_solution& s : solutions({e.envelope == 0, e.sight == 0}, e, domain)) {
        const auto slopes = [&](std::size_t moving, const std::vector<Plane_side>& its_sides, const Plane_side& other) {
          std::vector<int> result;
          for (const Plane_side& side : its_sides)
            with_germs(moved(index, moving, side.cell), moved(s.box, moving, side.value),
                       [&](const Sweep_germs& germs) {
                         result.push_back(germs.slope(moving, {axis}) * side.direction * side.factor * other.factor);
                       });
          return result;
        };
        const std::vector<int> along_a = slopes(a, first, second.back()), along_b = slopes(b, second, first.back());
        const auto is_monotone = [](const std::vector<int>& x) { return x.size() == 2 && x[0] != 0 && x[0] == -x[1]; };
        if (is_monotone(along_a) || is_monotone(along_b))
          continue;
        if (!s.is_certified())
          add_unclear(s);
        else
          add_with(index, s.box, [&](const Sweep_germs&) {
            return touches_end(s.box, domain, axis) ? Silhouette_germ::unknown()
                                                    : Silhouette_germ::at_vertex(along_a, along_b);
          });
      }
    }
  }

  bool is_at_pole(const Parameter_box& box, const Parameter_box& domain) const
  {
    for (const int axis : {0, 1})
      for (const Exact_rational& end : {domain[axis].first, domain[axis].second})
        if (box[axis].first <= end && end <= box[axis].second &&
            m_grid.is_smooth_pole(axis, *m_grid.line_at(axis, end)))
          return true;
    return false;
  }

  // Whether two branches begin at a pole, so that a curve passes it.
  bool is_passed(const Parameter_box& pole, int other) const
  {
    std::vector<Parameter_box> branches;
    const auto is_there = [&](const Parameter_box& box) { return touch(box, pole); };
    for (const Parameter_box& box : m_at_poles)
      if (is_there(box)) {
        const Parameter_box here = m_grid.canonical(box);
        if (std::none_of(branches.begin(), branches.end(), [&](const auto& known) { return touch(known, here); }))
          branches.push_back(here);
      }
    return m_grid.is_seam(other) && branches.size() == 2;
  }

  // At a pole, or another line with one tangent plane, where both equations are zero all along the line.
  void find_at_plane(std::size_t axis, std::size_t line)
  {
    const Plane_side own = sides(axis, line).back();
    for (std::size_t k = 0; k < size(2); ++k) {
      Index index{0, 0, k};
      index[axis] = own.cell;
      Parameter_box domain = box_of(index);
      const std::size_t other = 1 - axis;
      domain[axis] = {own.value, own.value};
      domain[other].second = domain[other].first;
      const Sweep_equations e = m_sight.equations(cell(index), times(index), domain, false);
      for (Sight_solution& s : solutions({e.envelope == 0, e.sight == 0}, e, domain)) {
        s.box[other] = m_grid.domain(static_cast<int>(other));
        if (!s.is_certified())
          add_unclear(s);
        else if (!m_grid.is_smooth_pole(static_cast<int>(axis), line) || !is_passed(s.box, static_cast<int>(other)))
          add(s.box, Silhouette_event_kind::DEGENERATE);
      }
    }
  }

  std::vector<Sight_solution> solutions(const std::vector<Constraint>& constraints, const Sweep_equations& equations,
                                        const Parameter_box& domain)
  {
    std::vector<Sight_solution> result;
    for (const Solution_d<double>& solution : m_solver(constraints, equations.unknowns)) {
      Parameter_box box = domain;
      auto next = solution.exact_box();
      std::size_t unknown = 0;
      for (Parameter_range& range : box)
        if (range.first < range.second)
          range = next[unknown++];
      result.push_back({clipped(with_short_ends(std::move(box)), domain),
                        {},
                        solution.kind(),
                        solution.kind() == Solution_kind::CONTINUUM ? Undecided_reason::CONTINUUM : solution.reason()});
    }
    return result;
  }

  static Index moved(Index index, std::size_t axis, std::size_t cell)
  {
    index[axis] = cell;
    return index;
  }

  static Parameter_box moved(Parameter_box box, std::size_t axis, const Exact_rational& value)
  {
    box[axis] = {value, value};
    return box;
  }

  static bool touches_end(const Parameter_box& box, const Parameter_box& domain, std::size_t axis)
  {
    return box[axis].first <= domain[axis].first || domain[axis].second <= box[axis].second;
  }

  template <class Use>
  void with_germs(const Index& index, const Parameter_box& box, const Use& use) const
  {
    const Sweep_equations whole = m_sight.equations(cell(index), times(index), box_of(index), false);
    const Sweep_germs germs(whole, box);
    use(germs);
  }

  // Adds the event of the germ that a function makes of those of a cell.
  template <class Make>
  void add_with(const Index& index, const Parameter_box& box, const Make& make)
  {
    with_germs(index, box, [&](const Sweep_germs& germs) {
      if (const auto kind = make(germs).event(germs.velocity()))
        add(box, *kind);
    });
  }

  void add_unclear(const Sight_solution& solution)
  {
    if (solution.kind == Solution_kind::CLUSTER)
      add(solution.box, Silhouette_event_kind::DEGENERATE);
    else
      m_found.undecided_boxes.emplace_back(solution.box, solution.reason);
  }

  // Degenerate ones may come from several cells.
  void add(const Parameter_box& box, Silhouette_event_kind kind)
  {
    const auto is_same = [&](const auto& known) { return known.kind == kind && touch(known.box, box); };
    if (kind != Silhouette_event_kind::DEGENERATE ||
        std::none_of(m_found.events.begin(), m_found.events.end(), is_same))
      m_found.events.push_back({kind, box, {}});
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Found_silhouette_events sweep_silhouette_events_of(const Exact_map<3>& surface,
                                                                                  const Exact_map<3>& path,
                                                                                  const std::vector<Exact_map<3>>& axes,
                                                                                  const Exact_map<3>& eye,
                                                                                  const Solver_options& options)
{
  Budgeted_solver solver(options);
  const Spline_patch<3> patch(surface);
  const Space_map eye_map = space_map(eye);
  const std::vector<Smooth_motion> motion = smooth_parts(path, axes);
  const Parameter_range first_time = motion.front().maps[0].domain(0), last_time = motion.back().maps[0].domain(0);
  const Parameter_box everywhere{
      patch.domain(0), patch.domain(1), {first_time.first, last_time.second}, eye_map.domain(0)};
  Found_silhouette_events found;
  try {
    const auto check = [&] { solver.budget().check(); };
    for (const Continuous_part<4>& part : tangent_planes(patch, check)) {
      if (part.functions.is_zero()) {
        found.undecided_boxes.emplace_back(everywhere, Undecided_reason::CONTINUUM);
        continue;
      }
      const Plane_grid grid(patch, part.functions, check);
      for (const Smooth_motion& smooth : motion)
        Sweep_events_on_part(patch, grid, smooth, eye_map, solver, found)();
    }
  } catch (const Run_stopped& stop) {
    found.undecided_boxes.emplace_back(everywhere, stop.reason);
  }
  std::vector<Spline_patch<3>> maps{Spline_patch<3>(path)};
  for (const Exact_map<3>& axis : axes)
    maps.emplace_back(axis);
  finish(found, place_in_motion(patch, maps, motion), solver, eye_map.domain(0));
  return found;
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SWEEP_EVENT_FINDER_H
