// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_ALL_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_ALL_CURVES_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_chains.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curves_on_face.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Found_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_factors.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/United_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Cell_pyramid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The curves of solutions of a system: the domain is cut along the breaks of the splines into cells, and these are
// subdivided. Tasks that have used up a budget become several ones, which know nothing of each other but the vertices
// on their boundaries: so the answer does not depend on how many of them run at the same time.
template <class Traits, class Concurrency_tag>
class All_curves
{
  const Constraint_system_d& m_system;
  const Constraint_system_d m_equalities;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary m_summary;
  Curve_vertices m_vertices;
  std::vector<Curve_piece> m_pieces;
  std::vector<Undecided_box> m_undecided;
  std::vector<Curve_task> m_tasks;
  std::vector<std::vector<Exact_rational>> m_breaks;
  std::vector<double> m_widths;
  const std::function<bool()> m_gives_up;
  std::size_t m_checked = 0;   // of the vertices
  bool m_is_asked = false, m_is_over = false;

public:
  // Asks gives_up() when curves seem to be singular, once.
  All_curves(
      const Constraint_system_d& system, const Solver_options& options, Run_control& control,
      std::function<bool()> gives_up = [] { return false; })
    : m_system(system), m_equalities(equalities_of(system)), m_options(options), m_control(control),
      m_vertices(options), m_gives_up(std::move(gives_up))
  {}

  Found_curves operator()()
  {
    const Exact_ranges domain = domain_of(m_system);
    for (const auto& [lower, upper] : domain)
      m_widths.push_back(CGAL::to_double(Exact_rational(upper - lower)));
    std::vector<Cell> cells;
    try {
      cells = possible_cells();
    } catch (const Run_stopped& stop) {
      m_undecided.push_back({domain, {}, stop.reason});
    }
    if (!cells.empty()) {
      const Vertex_indices vertices = vertices_on_boundary(domain);
      split_cells(domain, cells, vertices);
    }
    run_tasks();
    if (m_is_over)
      m_undecided.push_back({domain, {}, Undecided_reason::CONTINUUM});
    Vertex_indices points = isolated_points();
    m_summary.nodes += m_vertices.work().nodes;
    return {std::move(m_vertices), std::move(m_pieces), std::move(m_undecided), std::move(points), m_summary};
  }

private:
  // Whether to stop. A box is left at the tolerance, or a curve does not cross a plane at an angle: that may happen
  // along all of it.
  bool is_over()
  {
    if (m_is_asked)
      return m_is_over;
    m_is_asked = std::any_of(m_undecided.begin(), m_undecided.end(),
                             [](const Undecided_box& box) { return box.reason == Undecided_reason::TOLERANCE; });
    for (; m_checked < m_vertices.size() && !m_is_asked; ++m_checked)
      m_is_asked = m_vertices[m_checked].kind != Plane_point::REGULAR && !m_vertices[m_checked].is_singular;
    m_is_over = m_is_asked && !m_control.must_stop(true) && m_gives_up();
    return m_is_over;
  }

  std::vector<Cell> possible_cells()
  {
    const System_layout layout(m_system);
    const Exact_source source(m_system, layout, &m_control);
    m_breaks = source.breaks();
    std::vector<Cell> cells;
    Cell_pyramid(m_system, m_breaks, &m_control).visit_possible_cells([&](const Cell& cell) { cells.push_back(cell); });
    return cells;
  }

  Vertex_indices vertices_on_boundary(const Exact_ranges& domain)
  {
    Vertex_indices result;
    for (int axis = 0; axis < m_system.dimension(); ++axis)
      for (const Exact_rational& end : {domain[axis].first, domain[axis].second}) {
        const auto on_face = m_vertices.on_plane(m_equalities, domain, axis, end, result, false);
        for (const std::size_t i : *on_face)
          if (std::find(result.begin(), result.end(), i) == result.end())
            result.push_back(i);
        if (is_over() || m_control.must_stop(true))
          return result;
      }
    return result;
  }

  // Cuts the cells in two groups along a break, until there is one cell.
  void split_cells(const Exact_ranges& box, const std::vector<Cell>& cells, const Vertex_indices& vertices)
  {
    if (is_over())
      return;
    if (m_control.must_stop(true)) {
      m_undecided.push_back({box, vertices, m_control.reason()});
      return;
    }
    const auto [axis, index] = middle_break(box);
    if (axis < 0) {
      m_tasks.push_back({box, box, vertices, 0});
      return;
    }
    const Exact_rational value = m_breaks[axis][index];
    const Vertex_indices on_plane = *m_vertices.on_plane(m_equalities, box, axis, value, vertices, false);
    for (const bool is_upper : {false, true}) {
      Exact_ranges part = box;
      (is_upper ? part[axis].first : part[axis].second) = value;
      std::vector<Cell> own;
      std::copy_if(cells.begin(), cells.end(), std::back_inserter(own),
                   [&, axis = axis, index = index](const Cell& cell) {
                     return (cell[axis] >= static_cast<int>(index)) == is_upper;
                   });
      if (own.empty())
        continue;
      Vertex_indices known = on_plane;
      for (const std::size_t i : vertices)
        if (std::find(on_plane.begin(), on_plane.end(), i) == on_plane.end()) {
          const auto& [lower, upper] = m_vertices[i].box[axis];
          if (is_upper ? value < upper : lower < value)
            known.push_back(i);
        }
      split_cells(part, own, known);
    }
  }

  // In rounds. The budget of the first one is small: it makes the tasks of the others.
  void run_tasks()
  {
    constexpr std::size_t first_budget = 256, budget = 4096;
    for (std::size_t share = first_budget; !is_over() && !m_tasks.empty(); share = budget) {
      const std::size_t left = m_options.node_limit == 0
          ? m_tasks.size() * share
          : m_options.node_limit - (std::min)(m_options.node_limit, m_summary.nodes);
      if (left == 0 || m_control.must_stop(true))
        return give_up(left == 0 ? Undecided_reason::NODES : m_control.reason());
      const std::vector<Curve_task> tasks = std::exchange(m_tasks, {});
      const std::size_t count = (std::min)(tasks.size(), (left + share - 1) / share);
      std::vector<Curve_findings> found;
      for (std::size_t i = 0; i < count; ++i)
        found.push_back({Curve_vertices(m_options, m_vertices, tasks[i].vertices)});
      parallel_for<Concurrency_tag>(count, [&](std::size_t i, std::size_t) {
        [[maybe_unused]] const typename Number_traits<typename Traits::Number_type>::Rounding_guard guard;
        [[maybe_unused]] const Mpfr_precision_scope precision(m_options.precision);
        Curve_subdivision<Traits>(m_system, tasks[i].cell, m_widths, m_options, m_control, found[i])
            .run(tasks[i], (std::min)(share, left - i * share), m_undecided.size());
      });
      for (std::size_t i = 0; i < count; ++i)
        take(std::move(found[i]), tasks[i].vertices);
      m_tasks.insert(m_tasks.end(), tasks.begin() + static_cast<std::ptrdiff_t>(count), tasks.end());
    }
  }

  void take(Curve_findings&& found, const Vertex_indices& known)
  {
    found.renumber(m_vertices.merge(std::move(found.vertices), known));
    m_pieces.insert(m_pieces.end(), found.pieces.begin(), found.pieces.end());
    m_undecided.insert(m_undecided.end(), found.undecided.begin(), found.undecided.end());
    m_tasks.insert(m_tasks.end(), found.pending.begin(), found.pending.end());
    m_summary += found.summary;
  }

  void give_up(Undecided_reason reason)
  {
    for (const Curve_task& task : std::exchange(m_tasks, {}))
      m_undecided.push_back({task.box, task.vertices, reason});
  }

  // The vertices that neither pieces nor undecided boxes have, if they satisfy the inequalities.
  Vertex_indices isolated_points()
  {
    std::vector<bool> is_met(m_vertices.size(), false);
    for (const Curve_piece& piece : m_pieces)
      for (const std::size_t i : piece.ends)
        is_met[i] = true;
    for (const Undecided_box& box : m_undecided)
      for (const std::size_t i : box.vertices)
        is_met[i] = true;
    Vertex_indices result;
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      if (!is_met[i] && !m_vertices[i].is_singular_point()) {
        const CGAL::Uncertain<bool> is_solution = m_system.inequalities().empty()
            ? CGAL::Uncertain<bool>(true)
            : m_vertices.satisfies_inequalities(m_system, i);
        if (!CGAL::is_certain(is_solution))
          m_undecided.push_back({m_vertices[i].box, {i}, Undecided_reason::INEQUALITY});
        else if (CGAL::certainly(is_solution))
          result.push_back(i);
      }
    return result;
  }

  // The axis with the most cells in a box, and the break in the middle of them; -1 when there is one cell only.
  std::pair<int, std::size_t> middle_break(const Exact_ranges& box) const
  {
    std::pair<int, std::size_t> result(-1, 0);
    std::size_t most = 0;
    for (int v = 0; v < m_system.dimension(); ++v) {
      const auto first = std::upper_bound(m_breaks[v].begin(), m_breaks[v].end(), box[v].first),
                 last = std::lower_bound(m_breaks[v].begin(), m_breaks[v].end(), box[v].second);
      if (first < last && static_cast<std::size_t>(last - first) > most) {
        most = static_cast<std::size_t>(last - first);
        result = {v, static_cast<std::size_t>(first - m_breaks[v].begin()) + most / 2};
      }
    }
    return result;
  }
};

// What to do with the curves of a system in a face of the domain, or a plane of breaks.
enum class Use_of_face { FIND, SKIP, LEAVE };

inline Use_of_face use_of_face(const Curve_search& search, const Constraint_system_d& system,
                               const Vanishing_face& face)
{
  const auto& [lower, upper] = system.domain(face.axis);
  if (lower < face.value && face.value < upper)
    return Use_of_face::FIND;
  const auto axis = static_cast<std::size_t>(face.axis);
  if (std::find(search.points.begin(), search.points.end(), std::pair(axis, face.value)) != search.points.end())
    return Use_of_face::SKIP;
  if (search.are_faces_undecided)
    return Use_of_face::LEAVE;
  const bool is_closed =
      std::find(search.closed_unknowns.begin(), search.closed_unknowns.end(), axis) != search.closed_unknowns.end();
  return face.value == upper && is_closed ? Use_of_face::SKIP : Use_of_face::FIND;
}

// How often curves count that were found without the repeated factors. A piece has one regular vertex at least, unless
// both of its ends are singular points.
template <class Multiplicity>
void count_multiplicities(std::vector<Curve_piece>& pieces, const Curve_vertices& vertices,
                          const Multiplicity& multiplicity)
{
  for (Curve_piece& piece : pieces) {
    piece.multiplicity = 0;
    for (const std::size_t i : piece.ends)
      if (piece.multiplicity == 0 && !vertices[i].is_singular_point())
        piece.multiplicity = multiplicity(piece.box, vertices[i].box);
  }
}

/*
Where boxes are left at the tolerance, or singular points are on cutting planes, a curve may be one that an equality
counts several times. So the solver looks for repeated factors then and, if there are some, begins again without them.
Of two polynomials in three unknowns this is seen before.
*/
template <class Traits, class Concurrency_tag>
Found_curves curves_of_simple_factors(const Constraint_system_d& system, const Solver_options& options,
                                      Run_control& control, const Curve_search& search)
{
  std::optional<Simple_factors> factors;
  const auto has_simpler = [&] {
    factors.emplace(system, &control);
    return factors->is_simpler();
  };
  std::size_t nodes = 0;
  if (const auto polynomials = two_polynomials_in_space(system);
      !polynomials || !seem_to_touch_along_curves(*polynomials) || !has_simpler()) {
    Found_curves result = All_curves<Traits, Concurrency_tag>(
        system, options, control, [&] { return (!factors && has_simpler()) || search.gives_up(); })();
    if (!factors || !factors->is_simpler())
      return result;
    nodes = result.summary.nodes;
  }
  Solver_options rest = options;
  if (options.node_limit > 0)
    rest.node_limit = (std::max)(options.node_limit - (std::min)(nodes, options.node_limit), std::size_t(1));
  const auto curves_of = [&](const Constraint_system_d& simple, const auto& multiplicity) {
    Found_curves result = All_curves<Traits, Concurrency_tag>(simple, rest, control)();
    count_multiplicities(result.pieces, result.vertices, multiplicity);
    return result;
  };
  Found_curves simple = curves_of(factors->system(), [&](const Exact_ranges& box, const Exact_ranges& vertex) {
    return factors->multiplicity(box, vertex);
  });
  if (const auto& other = factors->other_system()) {
    Constraint_system_d both = factors->system();
    for (const Spline_function& equality : other->equalities())
      both.add(equality, Relation::EQUAL);
    Found_curves others = curves_of(*other, [&](const Exact_ranges&, const Exact_ranges& vertex) {
      return factors->multiplicity_in_other(vertex);
    });
    simple = United_curves(std::move(simple), std::move(others), both)(Curve_vertices(rest).solve(both));
  }
  simple.summary.nodes += nodes;
  return simple;
}

// What is found of a system: curves that lie in a face of the domain or a plane of breaks, where an equality has a
// factor that is zero there, apart from the others.
template <class Traits, class Concurrency_tag>
Found_curves found_curves(const Constraint_system_d& system, const Solver_options& options, Run_control& control,
                          const Curve_search& search)
{
  if (std::any_of(system.equalities().begin(), system.equalities().end(), is_zero_everywhere)) {
    Found_curves nothing{Curve_vertices(options)};
    nothing.undecided.push_back({domain_of(system), {}, Undecided_reason::CONTINUUM});
    return nothing;
  }
  const std::optional<Vanishing_face> face = vanishing_face(system);
  if (!face)
    return curves_of_simple_factors<Traits, Concurrency_tag>(system, options, control, search);
  const auto [rest, exponent] = without_face(system, *face);
  Found_curves result = found_curves<Traits, Concurrency_tag>(rest, options, control, search);
  Curves_on_face on_face(*face, exponent, result);
  const Use_of_face use = use_of_face(search, system, *face);
  if (use == Use_of_face::LEAVE)
    on_face.leave_undecided(domain_of(system));
  else if (const std::optional<Constraint_system_d> curves =
               use == Use_of_face::FIND ? system_on_face(system, *face) : std::nullopt)
    on_face.add(found_curves<Traits, Concurrency_tag>(*curves, options, control, search));
  return result;
}

// All curves of solutions of a system.
template <class Traits, class Concurrency_tag>
Curve_solution_set_d all_curves(const Constraint_system_d& system, const Solver_options& options, Run_control& control,
                                const Curve_search& search)
{
  check_codimension(system, 1, "solve_curves");
  Found_curves found =
      found_curves<Traits, Concurrency_tag>(system, control.options_of_parts(options), control, search);
  found.summary.seconds = control.seconds();
  const Exact_ranges domain = domain_of(system);
  return Curve_chains(domain, found.vertices, std::move(found.pieces), std::move(found.undecided))
      .solution_set(std::move(found.points), found.summary);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_ALL_CURVES_H
