// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_SUBDIVISION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_SUBDIVISION_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Graph_box_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_crossings.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_finder.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Layer_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Link_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Plane_crossings.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_findings.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/arc_loops.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The curves of a system of polynomials on a box, where these vertices are all on its boundary; or, if one needs
// regular ones, what tells that some are not.
inline void find_curves(const Constraint_system_d& system, const Exact_ranges& box, const Solver_options& options,
                        Run_control& control, std::size_t budget, bool needs_regular, Curve_findings& found)
{
  std::vector<double> widths;
  for (const auto& [lower, upper] : box)
    widths.push_back(CGAL::to_double(Exact_rational(upper - lower)));
  std::vector<std::size_t> vertices(found.vertices.size());
  Curve_subdivision<Certified_solver_traits>(system, box, widths, options, control, found, needs_regular)
      .run({box, box, std::move(vertices), 0}, budget, 0);
}

/*
The surfaces in one cell, where all functions are polynomials. The arcs on the boundary of a box are known before it is
looked at: the curves on the plane that it is split along are found before it is split, after the points where they
meet the arcs, which are cut there, and both halves get them. A plane is taken when all of this is proved to be regular.

A box is finished when it has no solutions, or when they are a graph over two unknowns whose boundary is one loop: seen
along the other unknowns the loop is a simple closed curve, and the graph is the disk that it bounds. Without arcs the
graph would have no boundary, and there is none. With several loops, unless they have a common vertex and bound disks,
the box is split.
*/
template <class Traits>
class Surface_subdivision : Graph_box_search<Traits>
{
  using Search = Graph_box_search<Traits>;
  using Search::has_doubles, Search::m_analysis, Search::m_control, Search::m_driver, Search::m_equalities,
      Search::m_graph, Search::m_layout, Search::m_options, Search::m_source, Search::m_summary;
  using typename Search::Node;

public:
  // What the driver keeps for a box.
  struct State
  {
    Exact_ranges box;
    Arc_indices arcs; // on its boundary
    int age = 0;      // changes since the coefficients were exact
  };

private:
  Cone_finder m_cones;
  // of the task
  const Task_environment* m_environment = nullptr;
  Task_findings* m_found = nullptr;
  Arc_store* m_store = nullptr;
  Task_budget m_budget{};
  std::size_t m_cell = 0, m_splits = 0;
  Node m_below, m_above;             // parts of a box that is to be split
  std::vector<std::unique_ptr<Layer_curves>> m_layers; // per axis; none where exact functions have to be asked at once

  // That a box is split along.
  struct Plane
  {
    int axis;
    double place; // between the ends of the node
    Arc_indices below, above;
  };

public:
  Surface_subdivision(const Constraint_system_d& system, const Exact_ranges& cell,
                      const std::vector<double>& domain_widths, const Solver_options& options, Run_control& control,
                      Summary& summary)
    : Search(system, cell, 2, domain_widths, options, control, summary), m_cones(m_equalities)
  {
    m_below.allocate(m_layout);
    m_above.allocate(m_layout);
    if (has_doubles && Layer_curves::fit(m_layout))
      m_layers.resize(static_cast<std::size_t>(m_layout.dimension));
  }

  void run(const Surface_task& task, const Task_budget& budget, const Task_environment& environment,
           Task_findings& found)
  {
    m_environment = &environment;
    m_found = &found;
    m_store = &found.arcs.store();
    m_budget = budget;
    m_cell = task.cell;
    m_splits = 0;
    m_summary = Summary();
    m_cones.learn(environment.cones);
    this->enter(task.box);
    m_driver.run(*this, State{task.box, found.arcs.indices()}, task.depth);
    m_source->leave_home();
    found.cones = m_cones.known();
    found.summary = m_summary;
  }

  // For the driver: false when a limit or the budget is reached.
  bool goes_on(const Node&, State& state, int depth)
  {
    if (const Undecided_reason reason = this->limit(); reason != Undecided_reason::NONE) {
      m_found->undecided.push_back({std::move(state.box), std::move(state.arcs), reason});
      return false;
    }
    if (m_splits >= m_budget.splits || m_summary.nodes >= m_budget.nodes) {
      m_found->pending.push_back({m_cell, std::move(state.box), std::move(state.arcs), depth});
      return false;
    }
    ++m_summary.nodes;
    m_summary.depth = (std::max)(m_summary.depth, depth);
    return true;
  }

  Box_verdict examine(Node& node, State& state, int)
  {
    state.arcs = m_store->parts_of(state.arcs); // boxes on the other side, in this task, may have cut them
    const Box_verdict verdict =
        this->examine_box(node, state.box, state.age, [&] { return is_patch(state.box, state.arcs); });
    return verdict == Box_verdict::SPLIT && is_cone(state.box, state.arcs) ? Box_verdict::DONE : verdict;
  }

  // None for a box that is too small.
  std::optional<Box_split<State>> split(const Node& node, State& state, int)
  {
    std::optional<Plane> plane = plane_of_split(node, state.box, state.arcs);
    if (!plane) {
      const Undecided_reason reason = this->limit();
      m_found->undecided.push_back({std::move(state.box), std::move(state.arcs),
                                    reason == Undecided_reason::NONE ? Undecided_reason::TOLERANCE : reason});
      return std::nullopt;
    }
    ++m_splits;
    const Exact_rational value(place_between(node.lower[plane->axis], node.upper[plane->axis], plane->place));
    Exact_ranges lower_box = std::move(state.box), upper_box = lower_box;
    upper_box[plane->axis].first = lower_box[plane->axis].second = value;
    return Box_split<State>{plane->axis,
                            plane->place,
                            {std::move(lower_box), std::move(plane->below), state.age},
                            {std::move(upper_box), std::move(plane->above), state.age}};
  }

private:
  bool touches_open_part(const Exact_ranges& box) const
  {
    return std::any_of(m_environment->open_parts.begin(), m_environment->open_parts.end(),
                       [&](const Exact_ranges& part) { return touch(part, box); });
  }

  // Finishes a box where the solutions are a graph, if its arcs are loops around disks, or there are none.
  bool is_patch(const Exact_ranges& box, const Arc_indices& arcs)
  {
    if (touches_open_part(box))
      return false;
    if (arcs.empty())
      return true;
    const std::array<int, 2> parameters{m_graph.parameters()[0], m_graph.parameters()[1]};
    std::optional<std::vector<Arc_loop>> loops = loops_around_disks(*m_store, arcs, parameters);
    for (std::size_t k = 0; loops && k < loops->size(); ++k)
      m_found->patches.push_back({box, parameters, this->sign_of_minor(), std::move((*loops)[k])});
    return loops.has_value();
  }

  // Finishes a box where the solutions are the cone over its arcs, with a singular point as the apex: a disk for each
  // loop. Faces of the domain that the box reaches have no solutions there but the apex, or they cross the cone.
  bool is_cone(const Exact_ranges& box, const Arc_indices& arcs)
  {
    if (!m_cones.space() || !may_gradient_vanish() || touches_open_part(box) || touches_changed_face(box))
      return false;
    const Cone_point* const point = m_cones(box, m_environment->domain);
    if (!point)
      return false;
    const Exact_ranges place = m_cones.space()->with_values(point->point);
    const std::optional<Cone_crossings> crossings = Cone_crossings::of(*m_store, arcs, m_environment->domain, place);
    if (!crossings || touches_elsewhere(box, place) ||
        !std::all_of(crossings->faces.begin(), crossings->faces.end(),
                     [&](const Domain_face& face) { return m_cones.is_crossed(*point, box, face.unknown); }) ||
        !Link_test(*point, *m_cones.space(), box, crossings->faces)(*m_store, arcs))
      return false;
    std::optional<std::vector<Arc_loop>> loops = loops_of_arcs(*m_store, arcs, crossings->apex);
    if (!loops)
      return false;
    const std::size_t apex = crossings->apex ? *crossings->apex : m_store->add_vertex(Plane_point::singular(place));
    if (loops->empty())
      m_found->points.push_back(apex);
    for (Arc_loop& loop : *loops)
      m_found->patches.push_back({box, {-1, -1}, 0, std::move(loop), 0, apex});
    return true;
  }

  // Whether there may be solutions on faces of the domain where no curve ends but a point.
  bool touches_elsewhere(const Exact_ranges& box, const Exact_ranges& point) const
  {
    return std::any_of(m_environment->touching.begin(), m_environment->touching.end(),
                       [&](const Plane_point& other) { return touch(other.box, box) && !is_at(other, point); });
  }

  // A face where not all solutions are on arcs, or some on edges.
  const Changed_face* changed_face(const Exact_ranges& box, int axis, const Exact_rational& value) const
  {
    const auto& faces = m_environment->changed_faces;
    const auto found =
        std::find_if(faces.begin(), faces.end(), [&](const Changed_face& face) { return face.has(axis, value, box); });
    return found == faces.end() ? nullptr : &*found;
  }

  bool touches_changed_face(const Exact_ranges& box) const
  {
    const auto& faces = m_environment->changed_faces;
    return std::any_of(faces.begin(), faces.end(), [&](const Changed_face& face) { return touch(face.box, box); });
  }

  // Of the equality in space.
  bool may_gradient_vanish()
  {
    const int equality = static_cast<int>(m_cones.space()->index());
    const double* const lower = m_analysis.view.derivative_lower(equality);
    const double* const upper = m_analysis.view.derivative_upper(equality);
    const auto& unknowns = m_cones.space()->unknowns();
    return std::none_of(unknowns.begin(), unknowns.end(), [&](int j) { return lower[j] > 0 || upper[j] < 0; });
  }

  // A plane where a part of the box is seen to be empty, or that surfaces cross; there are many through a small box
  // that will do, unless it is too small. Tasks side by side try different ones: they may not meet arcs in one point.
  std::optional<Plane> plane_of_split(const Node& node, const Exact_ranges& box, const Arc_indices& arcs)
  {
    constexpr std::array shifts{0, 8, -4, 10, -6, 12, -8, 14};
    const double shift = shifts[m_environment->number % shifts.size()] / 256.0;
    for (const int axis : this->rated_axes(node, m_environment->undecided + m_found->undecided.size()))
      for (const double middle : {125.0 / 256, 137.0 / 256, 113.0 / 256, 149.0 / 256, 65.0 / 256, 189.0 / 256}) {
        const double place = middle + shift;
        const Exact_rational value(place_between(node.lower[axis], node.upper[axis], place));
        if (value <= box[axis].first || box[axis].second <= value)
          continue;
        if (m_cones.is_near(box, axis, value, this->width(node, axis)))
          continue;
        if (m_control.must_stop(true))
          return std::nullopt;
        if (const auto [is_below, is_above] = possible_parts(node, axis, place); !is_below || !is_above)
          return Plane{axis, place, is_below ? arcs : Arc_indices(), is_above ? arcs : Arc_indices()};
        if (auto parts = parts_at(box, arcs, axis, value))
          return Plane{axis, place, std::move(parts->first), std::move(parts->second)};
      }
    return std::nullopt;
  }

  // Whether there may be solutions in the two parts of a node, each with its boundary.
  std::pair<bool, bool> possible_parts(const Node& node, int axis, double place)
  {
    m_below.copy_from(node);
    m_below.split(m_layout, axis, place, m_above);
    m_analysis.look_at(m_below);
    const bool is_below = !this->is_excluded();
    m_analysis.look_at(m_above);
    return {is_below, !this->is_excluded()};
  }

  // Finds the arcs on a plane, cuts those that it meets, and tells which are on which side of it. None, and nothing has
  // changed, when something there is not regular, or not certain.
  std::optional<std::pair<Arc_indices, Arc_indices>> parts_at(const Exact_ranges& box, const Arc_indices& arcs,
                                                              int axis, const Exact_rational& value)
  {
    const Plane_crossings crossings(*m_store, arcs, axis, value);
    if (meets_open_part(box, axis, value) || !crossings.are_ends_beside())
      return std::nullopt;
    std::optional<Plane_arcs> found;
    if constexpr (has_doubles)
      if (!crossings.meet_edges())
        found = arcs_on_layer(box, crossings, axis, value);
    if (!found)
      found = arcs_on_plane(box, crossings, axis, value);
    if (!found || !m_store->sort(found->cuts, found->points))
      return std::nullopt;
    const std::vector<std::size_t> vertices = m_store->add_vertices(std::move(found->points));
    return divided(arcs, found->cuts, vertices, m_store->add_arcs(found->pieces, vertices, axis, value), axis, value);
  }

  // From the layer of the lower part of the node, if its box is the exact one.
  std::optional<Plane_arcs> arcs_on_layer(const Exact_ranges& box, const Plane_crossings& crossings, int axis,
                                          const Exact_rational& value)
  {
    if (m_layers.empty() || !has_box(m_below, box, axis))
      return std::nullopt;
    auto& own_layer = m_layers[static_cast<std::size_t>(axis)];
    if (own_layer == nullptr)
      own_layer = std::make_unique<Layer_curves>(m_layout, axis, m_options, m_control);
    Layer_curves& layer = *own_layer;
    m_analysis.rebuild(Cell(box.size(), 0), m_below); // its errors are those of the points
    m_analysis.look_at(m_below);
    layer.start(m_below);
    Plane_arcs result;
    const auto add_new_points = [&] {
      for (std::size_t i = result.points.size(); i < layer.points().size(); ++i)
        result.points.push_back(point_on_layer(layer.points()[i], axis, value));
    };
    const auto add_points = [&](int face, const Exact_rational& place) {
      const bool is_upper = place == box[face].second;
      if (!(is_upper || place == box[face].first) || !layer.add_points_on_side(face - (face > axis ? 1 : 0), is_upper))
        return false;
      add_new_points();
      return true;
    };
    const bool is_certain = crossings.find_on_faces(add_points, result) && layer.find_curves();
    m_summary.nodes += layer.nodes();
    if (!is_certain)
      return std::nullopt;
    add_new_points();
    for (const Layer_curves::Piece& piece : layer.pieces())
      result.pieces.push_back({exact_ranges(piece.box), piece.parameter, piece.ends});
    return result;
  }

  // Whether a node has these ends, but for those of an axis.
  static bool has_box(const Node& node, const Exact_ranges& box, int axis)
  {
    for (int j = 0; j < static_cast<int>(box.size()); ++j)
      if (j != axis &&
          !(box[j].first == Exact_rational(node.lower[j]) && box[j].second == Exact_rational(node.upper[j])))
        return false;
    return true;
  }

  static Plane_point point_on_layer(const Layer_curves::Point& point, int axis, const Exact_rational& value)
  {
    std::vector<bool> is_fixed(point.box.size(), false);
    is_fixed[static_cast<std::size_t>(point.fixed)] = true;
    return with_plane({Plane_point::REGULAR, exact_ranges(point.box), exact_ranges(point.region), std::move(is_fixed)},
                      axis, value);
  }

  // From the exact functions.
  std::optional<Plane_arcs> arcs_on_plane(const Exact_ranges& box, const Plane_crossings& crossings, int axis,
                                          const Exact_rational& value)
  {
    const Constraint_system_d plane = on_plane(m_equalities, box, axis, value);
    Exact_ranges reduced = box;
    reduced.erase(reduced.begin() + axis);
    Curve_findings found{Curve_vertices(m_options, true)};
    Plane_arcs result;
    const auto add_new_points = [&] {
      for (std::size_t i = result.points.size(); i < found.vertices.size(); ++i)
        result.points.push_back(with_plane(found.vertices[i], axis, value));
    };
    const auto add_points = [&](int face, const Exact_rational& place) {
      const Changed_face* const own = changed_face(box, face, place);
      if (!found.vertices.on_plane(own ? on_plane(own->system, box, axis, value) : plane, reduced,
                                   face - (face > axis ? 1 : 0), place, {}, true))
        return false;
      add_new_points();
      return true;
    };
    const auto add_point = [&](const Plane_point& point) {
      found.vertices.add(without_axis(point, axis));
      add_new_points();
    };
    if ((crossings.meet_edges() && !crossings.find_on_edges(*m_cones.space(), add_point, result)) ||
        !crossings.find_on_faces(add_points, result) || !find_regular_curves(plane, found))
      return std::nullopt;
    add_new_points();
    result.pieces = std::move(found.pieces);
    return result;
  }

  // Whether a curve on the plane might end where nothing is known.
  bool meets_open_part(const Exact_ranges& box, int axis, const Exact_rational& value) const
  {
    return std::any_of(m_environment->open_parts.begin(), m_environment->open_parts.end(),
                       [&](const Exact_ranges& part) {
                         return part[axis].first <= value && value <= part[axis].second && touch(part, box);
                       });
  }

  bool is_above(std::size_t vertex, int axis, const Exact_rational& value) const
  {
    return value < m_store->vertex(vertex).box[axis].first;
  }

  // The curves on a plane; false when not all of them are proved to be regular.
  bool find_regular_curves(const Constraint_system_d& plane, Curve_findings& found)
  {
    constexpr std::size_t budget = 4096;
    find_curves(plane, domain_of(plane), m_options, m_control, budget, true, found);
    m_summary.nodes += found.summary.nodes + found.vertices.work().nodes;
    if (!found.undecided.empty() || !found.pending.empty())
      return false;
    for (std::size_t i = 0; i < found.vertices.size(); ++i)
      if (found.vertices[i].kind != Plane_point::REGULAR || found.vertices[i].is_singular)
        return false;
    return std::all_of(found.pieces.begin(), found.pieces.end(),
                       [](const Curve_piece& piece) { return piece.parameter >= 0; });
  }

  // Cuts arcs, and puts the parts on both sides of the plane, with the new arcs on it. `vertices`: of the points that
  // the cuts refer to.
  std::pair<Arc_indices, Arc_indices> divided(const Arc_indices& arcs, const Arc_store::Cuts& cuts,
                                              const std::vector<std::size_t>& vertices, const Arc_indices& on_plane,
                                              int axis, const Exact_rational& value)
  {
    std::pair<Arc_indices, Arc_indices> result{on_plane, on_plane};
    for (const std::size_t a : arcs) {
      bool is_upper = is_above(m_store->arcs()[a].ends[0], axis, value);
      std::vector<std::size_t> own;
      if (const auto place = cuts.find(a); place != cuts.end())
        for (const std::size_t i : place->second)
          own.push_back(vertices[i]);
      for (const std::size_t part : own.empty() ? Arc_indices{a} : m_store->cut(a, own)) {
        (is_upper ? result.second : result.first).push_back(part);
        is_upper = !is_upper;
      }
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_SUBDIVISION_H
