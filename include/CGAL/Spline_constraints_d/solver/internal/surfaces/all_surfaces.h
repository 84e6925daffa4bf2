// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ALL_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ALL_SURFACES_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_factors.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Cell_pyramid.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_complex.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/inequalities_as_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/touching_points.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
All surfaces of a system of equalities. The curves on the faces of the cells, where cells of breaks or the domain end,
are found first, once for the cells on both sides; then each cell is subdivided.
*/
template <class Traits>
class All_surfaces
{
  const Constraint_system_d& m_system;
  const Solver_options& m_options;
  Run_control& m_control;
  Exact_ranges m_domain;
  std::vector<double> m_widths;
  std::vector<std::vector<Exact_rational>> m_breaks;
  Surface_findings m_found;
  std::map<std::tuple<int, Exact_rational, Exact_ranges>, Arc_indices> m_faces; // whose arcs are known
  std::vector<Touching_point> m_touching;

public:
  All_surfaces(const Constraint_system_d& system, const Solver_options& options, Run_control& control)
    : m_system(system), m_options(options), m_control(control), m_domain(domain_of(system))
  {}

  Surface_findings operator()()
  {
    for (const auto& [lower, upper] : m_domain)
      m_widths.push_back(CGAL::to_double(Exact_rational(upper - lower)));
    for (const Cell& cell : possible_cells())
      find_in(box_of(cell));
    place_touching_points();
    return std::move(m_found);
  }

private:
  std::vector<Cell> possible_cells()
  {
    std::vector<Cell> cells;
    try {
      const System_layout layout(m_system);
      const Exact_source source(m_system, layout, &m_control);
      m_breaks = source.breaks();
      Cell_pyramid(m_system, m_breaks, &m_control).visit_possible_cells([&](const Cell& cell) {
        cells.push_back(cell);
      });
    } catch (const Run_stopped& stop) {
      m_found.undecided.push_back({m_domain, {}, stop.reason});
      cells.clear();
    }
    return cells;
  }

  Exact_ranges box_of(const Cell& cell) const
  {
    Exact_ranges box = m_domain;
    for (std::size_t j = 0; j < box.size(); ++j)
      if (m_breaks[j].size() > 2)
        box[j] = {m_breaks[j][cell[j]], m_breaks[j][cell[j] + 1]};
    return box;
  }

  void find_in(const Exact_ranges& box)
  {
    Arc_indices arcs;
    for (int axis = 0; axis < m_system.dimension(); ++axis)
      for (const Exact_rational& end : {box[axis].first, box[axis].second}) {
        const Arc_indices& on_face = arcs_on_face(box, axis, end);
        arcs.insert(arcs.end(), on_face.begin(), on_face.end());
      }
    Surface_subdivision<Traits>(m_system, box, m_widths, m_options, m_control, m_found).run(box, arcs);
  }

  const Arc_indices& arcs_on_face(const Exact_ranges& box, int axis, const Exact_rational& value)
  {
    Exact_ranges face = box;
    face[axis] = {value, value};
    const auto [entry, is_new] = m_faces.try_emplace({axis, value, face});
    if (is_new && !m_control.must_stop(true))
      entry->second = found_on_face(face, axis, value);
    return entry->second;
  }

  // The arcs on a face of a cell. What is not decided there is kept apart, so that no patch reaches it.
  Arc_indices found_on_face(const Exact_ranges& face, int axis, const Exact_rational& value)
  {
    const Constraint_system_d spline = on_plane(m_system, face, axis, value);
    const Exact_ranges box = domain_of(spline);
    const Constraint_system_d plane = on_cell(spline, box);
    const auto lifted = [&](Exact_ranges part) {
      part.insert(part.begin() + axis, {value, value});
      return part;
    };
    Curve_findings found{Curve_vertices(m_options, true)};
    std::vector<std::size_t> known;
    for (int j = 0; j < plane.dimension(); ++j)
      for (const Exact_rational& end : {box[j].first, box[j].second}) {
        const auto on_edge = found.vertices.on_plane(plane, box, j, end, known, false);
        for (const std::size_t i : *on_edge)
          if (std::find(known.begin(), known.end(), i) == known.end())
            known.push_back(i);
      }
    if (found.vertices.meets_continuum(box)) {
      m_found.open_parts.push_back(face);
      return {};
    }
    find_curves(plane, box, m_options, m_control, (std::numeric_limits<std::size_t>::max)(), false, found);
    m_found.summary.nodes += found.summary.nodes + found.vertices.work().nodes;
    for (const Undecided_box& undecided : found.undecided)
      m_found.open_parts.push_back(lifted(undecided.box));
    std::vector<bool> has_piece(found.vertices.size(), false);
    for (const Curve_piece& piece : found.pieces)
      for (const std::size_t end : piece.ends)
        has_piece[end] = true;
    std::vector<Plane_point> points;
    for (std::size_t i = 0; i < found.vertices.size(); ++i)
      points.push_back(with_plane(found.vertices[i], axis, value));
    const std::vector<std::size_t> vertices = m_found.arcs.add_vertices(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].kind == Plane_point::UNKNOWN)
        m_found.open_parts.push_back(points[i].region);
      else if (!has_piece[i])
        m_touching.push_back({points[i], vertices[i], axis});
    return m_found.arcs.add_arcs(found.pieces, vertices, axis, value);
  }

  // Points on faces where curves on these do not end. Some are ends of arcs on other faces.
  void place_touching_points()
  {
    std::set<std::size_t> known;
    for (const Stored_arc& arc : m_found.arcs.arcs())
      known.insert(arc.ends.begin(), arc.ends.end());
    for (const Touching_point& point : m_touching)
      if (known.insert(point.index).second)
        switch (position_of(point, m_system)) {
        case Touching_position::INSIDE:
          break;
        case Touching_position::OUTSIDE:
          m_found.points.push_back(point.index);
          break;
        case Touching_position::UNKNOWN:
          m_found.undecided.push_back({point.vertex.box, {}, Undecided_reason::TOLERANCE});
        }
  }
};

// Whether a short polynomial has repeated factors; for a long one, or one in many unknowns, or a spline, this is not
// looked at.
inline bool is_seen_to_be_repeated(const Spline_function& function, int dimension)
{
  constexpr std::size_t most_unknowns = 3;
  constexpr std::size_t short_polynomial = 200;
  const auto size = [](const Spline_term& term) {
    return term.pieces.size() == 1 ? term.pieces[0].size() : short_polynomial;
  };
  std::size_t coefficients = 0;
  std::set<int> unknowns;
  for (const Spline_term& term : function.terms()) {
    coefficients += size(term);
    unknowns.insert(term.variables.begin(), term.variables.end());
  }
  return coefficients < short_polynomial && unknowns.size() <= most_unknowns &&
      square_free_factors(*restricted(function, Partial_point(static_cast<std::size_t>(dimension)))).size() > 1;
}

/*
The surfaces of equalities. If these have repeated factors they are left out, and the equalities replaced. Of short
polynomials this is known at once. For others it is asked when boxes are left at the tolerance, as where surfaces count
several times.
*/
template <class Traits>
Surface_findings surfaces_of_simple_factors(std::shared_ptr<const Constraint_system_d>& equalities,
                                            const Solver_options& options, Run_control& control)
{
  const auto is_small = [](const Undecided_surface_box& box) { return box.reason == Undecided_reason::TOLERANCE; };
  const auto is_repeated = [&](const Spline_function& f) { return is_seen_to_be_repeated(f, equalities->dimension()); };
  Surface_findings found;
  if (std::none_of(equalities->equalities().begin(), equalities->equalities().end(), is_repeated)) {
    found = All_surfaces<Traits>(*equalities, options, control)();
    if (std::none_of(found.undecided.begin(), found.undecided.end(), is_small))
      return found;
  }
  const Simple_factors factors(*equalities);
  if (!factors.is_simpler())
    return found;
  const std::size_t nodes = found.summary.nodes;
  equalities = std::make_shared<const Constraint_system_d>(factors.system());
  Solver_options rest = options;
  if (options.node_limit > 0)
    rest.node_limit = (std::max)(options.node_limit - (std::min)(nodes, options.node_limit), std::size_t(1));
  found = All_surfaces<Traits>(*equalities, rest, control)();
  found.summary.nodes += nodes;
  return found;
}

// All surfaces of solutions of a system.
template <class Traits>
Surface_solution_set_d all_surfaces(const Constraint_system_d& system, const Solver_options& options,
                                    Run_control& control, const std::vector<Spline_function>& features)
{
  [[maybe_unused]] const typename Number_traits<typename Traits::Number_type>::Rounding_guard guard;
  [[maybe_unused]] const Mpfr_precision_scope precision(options.precision);
  check_codimension(system, 2, "solve_surfaces");
  auto equalities = std::make_shared<const Constraint_system_d>(inequalities_as_unknowns(system, features));
  Surface_findings found;
  if (std::any_of(system.equalities().begin(), system.equalities().end(), is_zero_everywhere))
    found.undecided.push_back({domain_of(*equalities), {}, Undecided_reason::CONTINUUM});
  else
    found = surfaces_of_simple_factors<Traits>(equalities, control.options_of_parts(options), control);
  found.summary.seconds = control.seconds();
  return Surface_complex(std::move(found)).solution_set(std::move(equalities), system.dimension());
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ALL_SURFACES_H
