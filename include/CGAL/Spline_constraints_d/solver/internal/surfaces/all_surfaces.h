// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ALL_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ALL_SURFACES_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_factors.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Cell_pyramid.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Edge_arcs.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Face_equation.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_complex.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_findings.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_rounds.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/inequalities_as_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/lone_curves.h>
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

// A face of a cell, with the unknown that it fixes.
struct Cell_face
{
  int axis;
  Exact_rational value;
  Exact_ranges box;

  bool operator<(const Cell_face& other) const
  {
    return std::tie(axis, value, box) < std::tie(other.axis, other.value, other.box);
  }
};

/*
All surfaces of a system of equalities. The curves on the faces of the cells, where cells of breaks or the domain end,
are found first, once for the cells on both sides; then the cells are subdivided.
*/
template <class Traits, class Concurrency_tag>
class All_surfaces
{
  const Constraint_system_d& m_system;
  const Solver_options& m_options;
  Run_control& m_control;
  Exact_ranges m_domain;
  std::vector<double> m_widths;
  std::vector<std::vector<Exact_rational>> m_breaks;
  Surface_findings m_found;
  std::vector<Touching_point> m_touching;
  std::vector<Lone_part> m_lone_parts;

  // What is found on a face.
  struct Curves_on_face
  {
    Cell_face face;
    std::size_t cell; // one that has it
    Curve_findings curves;
    bool is_open = false; // all of it is undecided
    Arc_indices arcs = {};
    std::optional<Face_equation> equation = std::nullopt; // where it has edges, or repeated factors
    Touching_curves touching = {};
  };

public:
  All_surfaces(const Constraint_system_d& system, const Solver_options& options, Run_control& control)
    : m_system(system), m_options(options), m_control(control), m_domain(domain_of(system))
  {}

  Surface_findings operator()()
  {
    for (const auto& [lower, upper] : m_domain)
      m_widths.push_back(CGAL::to_double(Exact_rational(upper - lower)));
    std::vector<Exact_ranges> cells;
    for (const Cell& cell : possible_cells())
      cells.push_back(box_of(cell));
    Surface_rounds<Traits, Concurrency_tag>(m_system, cells, m_widths, m_options, m_control, m_found)(tasks_of(cells));
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

  // The cells, with the arcs on their faces.
  std::vector<Surface_task> tasks_of(const std::vector<Exact_ranges>& cells)
  {
    std::map<Cell_face, std::size_t> places;
    std::vector<Curves_on_face> faces;
    std::vector<std::vector<std::size_t>> faces_of(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (int axis = 0; axis < m_system.dimension(); ++axis)
        for (const Exact_rational& end : {cells[c][axis].first, cells[c][axis].second}) {
          Cell_face face{axis, end, cells[c]};
          face.box[axis] = {end, end};
          const auto [entry, is_new] = places.try_emplace(face, faces.size());
          if (is_new)
            faces.push_back({std::move(face), c, {Curve_vertices(m_options, true)}});
          faces_of[c].push_back(entry->second);
        }
    find_equations(faces, cells);
    const std::vector<std::pair<std::size_t, std::size_t>> edges = common_edges(faces);
    parallel_for<Concurrency_tag>(faces.size(), [&](std::size_t i, std::size_t) {
      if (!m_control.must_stop(true))
        find_curves_on(faces[i], faces);
    });
    for (Curves_on_face& face : faces)
      take(face);
    for (const auto& [first, second] : edges)
      if (!faces[first].is_open && !faces[second].is_open)
        add_edge(faces[first], *faces[second].equation);
    std::vector<Surface_task> result;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      result.push_back({c, cells[c], {}});
      for (const std::size_t f : faces_of[c])
        result.back().arcs.insert(result.back().arcs.end(), faces[f].arcs.begin(), faces[f].arcs.end());
    }
    return result;
  }

  // Of faces of the domain, if there is something special about these.
  void find_equations(std::vector<Curves_on_face>& faces, const std::vector<Exact_ranges>& cells) const
  {
    std::shared_ptr<const Cell_equalities> cell; // of faces that follow each other
    std::size_t last = cells.size();
    for (Curves_on_face& face : faces) {
      const auto& [axis, value, box] = face.face;
      if (value != m_domain[axis].first && value != m_domain[axis].second)
        continue;
      if (std::exchange(last, face.cell) != face.cell)
        cell = std::make_shared<const Cell_equalities>(on_cell(m_system, cells[face.cell]));
      face.equation = Face_equation::of(cell, axis, value);
    }
  }

  // The faces that have a common edge on which the equality in space is zero. A face with another such edge is as if
  // nothing was known about it, and so are those beside it.
  static std::vector<std::pair<std::size_t, std::size_t>> common_edges(std::vector<Curves_on_face>& faces)
  {
    for (;;) {
      std::vector<std::pair<std::size_t, std::size_t>> result;
      std::vector<std::size_t> count(faces.size(), 0);
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t k = i + 1; k < faces.size(); ++k)
          if (faces[i].equation && faces[k].equation && faces[i].cell == faces[k].cell &&
              Edge_arcs(*faces[i].equation, *faces[k].equation).is_regular()) {
            result.emplace_back(i, k);
            ++count[i];
            ++count[k];
          }
      bool are_known = true;
      for (std::size_t i = 0; i < faces.size(); ++i)
        if (faces[i].equation && faces[i].equation->edges().size() != count[i]) {
          faces[i].equation.reset();
          are_known = false;
        }
      if (are_known)
        return result;
    }
  }

  void find_curves_on(Curves_on_face& face, const std::vector<Curves_on_face>& faces) const
  {
    const auto on_own_plane = [&](const Constraint_system_d& system) {
      return on_plane(system, face.face.box, face.face.axis, face.face.value);
    };
    const Constraint_system_d spline = on_own_plane(face.equation ? face.equation->crossing_system() : m_system);
    const Exact_ranges box = domain_of(spline);
    const Constraint_system_d plane = on_cell(spline, box);
    Curve_findings& found = face.curves;
    if (face.equation)
      face.touching = touching_curves(*face.equation, m_options, m_control);
    std::vector<std::size_t> known;
    for (int j = 0; j < plane.dimension(); ++j)
      for (const Exact_rational& end : {box[j].first, box[j].second}) {
        const Face_equation* const special = equation_at_edge(face, j + (j >= face.face.axis ? 1 : 0), end, faces);
        const auto on_edge = found.vertices.on_plane(special ? on_own_plane(special->crossing_system()) : plane, box, j,
                                                     end, known, false);
        for (const std::size_t i : *on_edge)
          if (std::find(known.begin(), known.end(), i) == known.end())
            known.push_back(i);
        if (special && !(face.equation && special == &*face.equation))
          for (Plane_point& corner : ends_of_edges(*special, face.face.axis, face.face.value))
            if (!face.equation || vanishes_at(face.equation->crossing(), corner.box))
              add_corner(without_axis(std::move(corner), face.face.axis), found.vertices, known);
      }
    face.is_open = found.vertices.meets_continuum(box);
    if (!face.is_open)
      find_curves(plane, box, m_options, m_control, (std::numeric_limits<std::size_t>::max)(), false, found);
  }

  static void add_corner(Plane_point&& corner, Curve_vertices& vertices, std::vector<std::size_t>& known)
  {
    if (std::none_of(known.begin(), known.end(), [&](std::size_t i) {
          return vertices[i].is_fixed == corner.is_fixed && vertices[i].box == corner.box;
        }))
      known.push_back(vertices.add(std::move(corner)));
  }

  // What is special about an edge of a face: the same for both faces that have it, so that they have the same points
  // there. Nothing if the equality is zero on the edge, or that does not help.
  static const Face_equation* equation_at_edge(const Curves_on_face& face, int axis, const Exact_rational& value,
                                               const std::vector<Curves_on_face>& faces)
  {
    const Face_equation* const own = face.equation ? &*face.equation : nullptr;
    if (own && own->edge(axis, value))
      return nullptr;
    const auto other = std::find_if(faces.begin(), faces.end(), [&](const Curves_on_face& beside) {
      return beside.equation && beside.cell == face.cell && beside.face.axis == axis && beside.face.value == value;
    });
    return other != faces.end() && (!own || axis < own->axis()) && have_edges_corners(*other->equation, face.face.axis)
        ? &*other->equation
        : own;
  }

  // The arcs on a face of a cell. What is not decided there is kept apart, so that no patch reaches it.
  void take(Curves_on_face& face)
  {
    const auto& [axis, value, box] = face.face;
    const Curve_findings& found = face.curves;
    if (face.is_open) {
      m_found.open_parts.push_back(box);
      return;
    }
    m_found.summary.nodes += found.summary.nodes + found.vertices.work().nodes + face.touching.nodes;
    if (face.equation)
      take(face.face, *face.equation, face.touching);
    for (const Undecided_box& undecided : found.undecided) {
      m_found.open_parts.push_back(undecided.box);
      m_found.open_parts.back().insert(m_found.open_parts.back().begin() + axis, {value, value});
    }
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
      else if (!has_piece[i]) {
        m_touching.push_back({points[i], vertices[i]});
        m_found.touching.push_back(points[i]);
      }
    face.arcs = m_found.arcs.add_arcs(found.pieces, vertices, axis, value);
  }

  // What is special about a face.
  void take(const Cell_face& face, const Face_equation& equation, Touching_curves& touching)
  {
    m_found.changed_faces.push_back({face.axis, face.box, equation.crossing_system()});
    m_found.open_parts.insert(m_found.open_parts.end(), touching.open.begin(), touching.open.end());
    add_lone_curves(std::move(touching.part), std::move(touching.outside));
  }

  void add_lone_curves(Lone_part&& part, std::optional<Curve_solution_set_d>&& curves)
  {
    if (!curves)
      return;
    m_lone_parts.push_back(std::move(part));
    m_found.lone_curves.push_back(*std::move(curves));
  }

  // The arcs on an edge between two faces, of which the first one gets them.
  void add_edge(Curves_on_face& face, const Face_equation& other)
  {
    const Edge_arcs edge(*face.equation, other);
    const Edge_arcs::Result found = edge(m_found.arcs);
    face.arcs.insert(face.arcs.end(), found.arcs.begin(), found.arcs.end());
    m_found.open_parts.insert(m_found.open_parts.end(), found.open.begin(), found.open.end());
    if (found.has_lone_part)
      add_lone_curves(
          edge.lone_part(),
          curves_on_faces<CGAL::Sequential_tag>(edge.other_equalities(), edge.lone_part(), m_options, m_control));
  }

  // Points on faces where curves on these do not end. Some are ends of arcs on other faces, or singular points.
  void place_touching_points()
  {
    std::set<std::size_t> known;
    for (const Stored_arc& arc : m_found.arcs.arcs())
      known.insert(arc.ends.begin(), arc.ends.end());
    std::vector<Exact_ranges> singular;
    for (const Surface_patch& patch : m_found.patches)
      if (patch.apex)
        singular.push_back(m_found.arcs.vertex(*patch.apex).box);
    for (const std::size_t i : m_found.points)
      singular.push_back(m_found.arcs.vertex(i).box);
    const auto is_found = [&](const Plane_point& point) {
      return std::any_of(singular.begin(), singular.end(),
                         [&](const Exact_ranges& own) { return is_at(point, own); }) ||
          std::any_of(m_lone_parts.begin(), m_lone_parts.end(), [&](const Lone_part& part) { return part.has(point); });
    };
    for (const Touching_point& point : m_touching)
      if (known.insert(point.index).second && !is_found(point.vertex))
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
template <class Traits, class Concurrency_tag>
Surface_findings surfaces_of_simple_factors(std::shared_ptr<const Constraint_system_d>& equalities,
                                            const Solver_options& options, Run_control& control)
{
  const auto is_small = [](const Undecided_surface_box& box) { return box.reason == Undecided_reason::TOLERANCE; };
  const auto is_repeated = [&](const Spline_function& f) { return is_seen_to_be_repeated(f, equalities->dimension()); };
  Surface_findings found;
  if (std::none_of(equalities->equalities().begin(), equalities->equalities().end(), is_repeated)) {
    found = All_surfaces<Traits, Concurrency_tag>(*equalities, options, control)();
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
  found = All_surfaces<Traits, Concurrency_tag>(*equalities, rest, control)();
  found.summary.nodes += nodes;
  return found;
}

// All surfaces of solutions of a system.
template <class Traits, class Concurrency_tag>
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
    found = surfaces_of_simple_factors<Traits, Concurrency_tag>(equalities, control.options_of_parts(options), control);
  found.summary.seconds = control.seconds();
  return Surface_complex(std::move(found)).solution_set<Concurrency_tag>(std::move(equalities), system.dimension());
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ALL_SURFACES_H
