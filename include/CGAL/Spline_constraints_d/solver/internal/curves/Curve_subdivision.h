// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_SUBDIVISION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_SUBDIVISION_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Layer_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Singular_branch_finder.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Graph_box_search.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Vertex_indices = std::vector<std::size_t>;

// A box that was left undecided, with the vertices on its boundary.
struct Undecided_box
{
  Exact_ranges box;
  Vertex_indices vertices;
  Undecided_reason reason;
};

// A box in a cell, where all functions are polynomials, with the vertices on its boundary.
struct Curve_task
{
  Exact_ranges cell, box;
  Vertex_indices vertices;
  int depth;
};

// What came of a task. Its vertices are numbered 0, 1, ...; new ones follow.
struct Curve_findings
{
  Curve_vertices vertices;
  std::vector<Curve_piece> pieces = {};
  std::vector<Undecided_box> undecided = {};
  std::vector<Curve_task> pending = {}; // what is left when the budget is used up
  Summary summary = {};

  // Numbers the vertices as the map says.
  void renumber(const Vertex_indices& map)
  {
    const auto change = [&](std::size_t& i) { i = map[i]; };
    for (Curve_piece& piece : pieces)
      std::for_each(piece.ends.begin(), piece.ends.end(), change);
    for (Undecided_box& box : undecided)
      std::for_each(box.vertices.begin(), box.vertices.end(), change);
    for (Curve_task& task : pending)
      std::for_each(task.vertices.begin(), task.vertices.end(), change);
  }
};

/*
The curves in one cell, where all functions are polynomials. The vertices on the boundary of a box are known before it
is looked at: those on the plane that it is split along are found before it is split, and both halves get them. A box is
finished when it has no solutions, or when they are a graph over one unknown: then the vertices in the order of that
unknown are the ends of the pieces; or when all of them end in one singular point.

Inequalities that neither hold everywhere in a box nor exclude it have their zeros among the vertices of a graph, so
that they hold for all points between two vertices or for none.

Who needs regular curves only wants to know nothing else: singular points are not looked for, and the first box that is
left undecided ends the search.
*/
template <class Traits>
class Curve_subdivision : Graph_box_search<Traits>
{
  using Search = Graph_box_search<Traits>;
  using Search::has_doubles, Search::m_analysis, Search::m_control, Search::m_driver, Search::m_equalities,
      Search::m_graph, Search::m_layout, Search::m_open_inequalities, Search::m_options, Search::m_source,
      Search::m_summary, Search::m_system;
  using typename Search::Node;

public:
  // What the driver keeps for a box.
  struct State
  {
    Exact_ranges box;
    Vertex_indices vertices; // on its boundary
    int age = 0;             // changes since the coefficients were exact
  };

private:
  const Constraint_system_d m_closure; // without inequations
  Curve_vertices& m_vertices;
  Singular_branch_finder m_singular_branches;
  const bool m_needs_regular;
  std::size_t m_budget = 0, m_open_before = 0;
  Node m_below, m_above;                                // parts of a box that is to be split
  std::vector<std::unique_ptr<Face_points>> m_on_layer; // per axis; none where exact functions have to be asked at once
  std::vector<Curve_piece>& m_pieces;
  std::vector<Undecided_box>& m_undecided;
  std::vector<Curve_task>& m_pending;

public:
  Curve_subdivision(const Constraint_system_d& system, const Exact_ranges& cell,
                    const std::vector<double>& domain_widths, const Solver_options& options, Run_control& control,
                    Curve_findings& findings, bool needs_regular = false)
    : Search(system, cell, 1, domain_widths, options, control, findings.summary),
      m_closure(without_inequations(m_system)), m_vertices(findings.vertices),
      m_singular_branches(m_system, domain_widths, findings.vertices, control), m_needs_regular(needs_regular),
      m_pieces(findings.pieces), m_undecided(findings.undecided), m_pending(findings.pending)
  {
    // of larger functions in two unknowns, roots on lines are found faster exactly than these are built anew
    constexpr std::size_t largest_in_plane = 128;
    if (has_doubles && Face_restriction::has_moderate_degrees(m_layout) &&
        (m_layout.dimension > 2 || m_layout.size <= largest_in_plane)) {
      m_below.allocate(m_layout);
      m_above.allocate(m_layout);
      m_on_layer.resize(static_cast<std::size_t>(m_layout.dimension));
    }
  }

  // Looks at no more boxes than the budget allows. `open_before`: how many have been left undecided elsewhere.
  void run(const Curve_task& task, std::size_t budget, std::size_t open_before)
  {
    m_budget = budget;
    m_open_before = open_before;
    Vertex_indices vertices(task.vertices.size());
    std::iota(vertices.begin(), vertices.end(), std::size_t(0));
    this->enter(task.box);
    m_driver.run(*this, State{task.box, std::move(vertices)}, task.depth);
    m_source->leave_home();
  }

  // For the driver: false when a limit or the budget is reached.
  bool goes_on(const Node&, State& state, int depth)
  {
    if (const Undecided_reason reason = this->limit(); reason != Undecided_reason::NONE) {
      m_undecided.push_back({std::move(state.box), std::move(state.vertices), reason});
      return false;
    }
    if (m_summary.nodes >= m_budget || (m_needs_regular && !m_undecided.empty())) {
      m_pending.push_back({domain_of(m_system), std::move(state.box), std::move(state.vertices), depth});
      return false;
    }
    ++m_summary.nodes;
    m_summary.depth = (std::max)(m_summary.depth, depth);
    return true;
  }

  Box_verdict examine(Node& node, State& state, int depth)
  {
    auto& [box, vertices, age] = state;
    const Box_verdict verdict =
        this->examine_box(node, box, age, [&] { return joined(state.box, state.vertices, m_graph.parameter()); });
    if (verdict == Box_verdict::AGAIN) // nothing was proved of these: there are none
      std::erase_if(vertices, [&, &own = box](std::size_t i) { return !touch(m_vertices[i].box, own); });
    return verdict == Box_verdict::SPLIT && has_singular_point(box, vertices, depth) ? Box_verdict::DONE : verdict;
  }

  // None for a box that is too small.
  std::optional<Box_split<State>> split(const Node& node, State& state, int)
  {
    const std::optional<Plane> plane = plane_of_split(node, state.box, state.vertices);
    if (!plane) {
      m_undecided.push_back({std::move(state.box), std::move(state.vertices), Undecided_reason::TOLERANCE});
      return std::nullopt;
    }
    auto [below, above] = distributed(state.vertices, *plane);
    Exact_ranges lower_box = std::move(state.box), upper_box = lower_box;
    upper_box[plane->axis].first = lower_box[plane->axis].second = plane->value;
    return Box_split<State>{plane->axis,
                            plane->place,
                            {std::move(lower_box), std::move(below), state.age},
                            {std::move(upper_box), std::move(above), state.age}};
  }

private:
  // That a box is split along, with the vertices on it.
  struct Plane
  {
    int axis;
    double place; // between the ends of the node
    Exact_rational value;
    Vertex_indices vertices;
  };

  // Makes the pieces of a box whose only solutions are branches that end in one singular point.
  bool has_singular_point(const Exact_ranges& box, const Vertex_indices& vertices, int depth)
  {
    if (m_needs_regular || depth % m_layout.dimension != 0 || (m_layout.equalities == 1 && !may_gradient_vanish()))
      return false;
    const std::optional<Singular_branches> branches = m_singular_branches(box, vertices, m_open_inequalities);
    for (std::size_t i = 0; branches && i < branches->ends.size(); ++i)
      m_pieces.push_back({box, -1, {branches->centre, branches->ends[i]}});
    return branches.has_value();
  }

  bool may_gradient_vanish()
  {
    for (int j = 0; j < m_layout.dimension; ++j)
      if (m_analysis.view.derivative_lower(0)[j] > 0 || m_analysis.view.derivative_upper(0)[j] < 0)
        return false;
    return true;
  }

  // Those on the plane of a split belong to both parts.
  std::pair<Vertex_indices, Vertex_indices> distributed(const Vertex_indices& vertices, const Plane& plane) const
  {
    std::pair<Vertex_indices, Vertex_indices> result{plane.vertices, plane.vertices};
    for (const std::size_t i : vertices)
      if (std::find(plane.vertices.begin(), plane.vertices.end(), i) == plane.vertices.end())
        (m_vertices[i].box[plane.axis].second <= plane.value ? result.first : result.second).push_back(i);
    return result;
  }

  // A plane that the curves cross, if there are solutions on it at all, and that is not too close to a known vertex or
  // singular point. There are many planes through a small box that will do, unless it is too small.
  std::optional<Plane> plane_of_split(const Node& node, const Exact_ranges& box, const Vertex_indices& vertices)
  {
    constexpr double far = 0.2;
    const Exact_point* singular_point = m_singular_branches.known_point_in(box);
    for (const int axis : this->rated_axes(node, m_open_before + m_undecided.size()))
      for (const double place : {125.0 / 256, 137.0 / 256, 113.0 / 256, 149.0 / 256, 65.0 / 256, 189.0 / 256}) {
        const Exact_rational value(place_between(node.lower[axis], node.upper[axis], place));
        if (value <= box[axis].first || box[axis].second <= value)
          continue;
        if (singular_point &&
            CGAL::to_double(Exact_rational(CGAL::abs((*singular_point)[axis] - value))) < far * this->width(node, axis))
          continue;
        std::optional<Vertex_indices> on_plane;
        if constexpr (has_doubles)
          on_plane = points_on_layer(node, box, axis, place, value, vertices);
        if (!on_plane)
          on_plane = m_vertices.on_plane(m_equalities, box, axis, value, vertices, true);
        if (on_plane)
          return Plane{axis, place, value, std::move(*on_plane)};
      }
    return std::nullopt;
  }

  // The regular points on a plane from the layer of the coefficients there, if they are certain, and inside of the box:
  // the node may be a little larger.
  std::optional<Vertex_indices> points_on_layer(const Node& node, const Exact_ranges& box, int axis, double place,
                                                const Exact_rational& value, const Vertex_indices& vertices)
  {
    const auto is_near = [&](std::size_t i) {
      const auto& [lower, upper] = m_vertices[i].box[axis];
      return lower <= value && value <= upper;
    };
    if (m_on_layer.empty() || std::any_of(vertices.begin(), vertices.end(), is_near))
      return std::nullopt;
    m_below.copy_from(node);
    m_below.split(m_layout, axis, place, m_above);
    m_analysis.rebuild(Cell(box.size(), 0), m_below); // its errors are those of the points
    m_analysis.look_at(m_below);
    auto& on_layer = m_on_layer[static_cast<std::size_t>(axis)];
    if (on_layer == nullptr)
      on_layer = std::make_unique<Face_points>(m_layout, axis);
    ++m_summary.nodes;
    auto roots = (*on_layer)(m_below, true);
    if (!roots)
      return std::nullopt;
    std::vector<Plane_point> points;
    for (Layer_points::Root& root : *roots) {
      if (!is_narrow(root.box, axis) && !narrowed(root.box, axis, *on_layer))
        return std::nullopt;
      std::vector<bool> is_fixed(box.size(), false);
      is_fixed[static_cast<std::size_t>(axis)] = true;
      points.push_back({Plane_point::REGULAR, exact_ranges(root.box), exact_ranges(root.region), std::move(is_fixed)});
      for (std::size_t j = 0; j < box.size(); ++j)
        if (static_cast<int>(j) != axis &&
            !(box[j].first < points.back().box[j].first && points.back().box[j].second < box[j].second))
          return std::nullopt;
    }
    Vertex_indices result;
    for (Plane_point& point : points)
      result.push_back(m_vertices.add(std::move(point)));
    return result;
  }

  // Whether a point is known as well as those who ask for curves may expect; for those who need to know that they are
  // regular any box will do.
  bool is_narrow(const Layer_points::Box& box, int axis) const
  {
    constexpr double narrow = 0x1p-48;
    for (std::size_t j = 0; j < box.size() && !m_needs_regular; ++j)
      if (static_cast<int>(j) != axis && box[j].second - box[j].first > narrow * this->m_domain_widths[j])
        return false;
    return true;
  }

  // The same after the exact functions were asked near the point, where coefficients and their errors are small.
  bool narrowed(Layer_points::Box& box, int axis, Face_points& on_layer)
  {
    double widest = 0;
    for (const auto& [lower, upper] : box)
      widest = (std::max)(widest, upper - lower);
    for (int j = 0; j < m_layout.dimension; ++j) {
      const auto& [lower, upper] = box[static_cast<std::size_t>(j)];
      m_above.lower[j] = (std::max)((std::min)(lower - widest, next_below(lower)), m_below.lower[j]);
      m_above.upper[j] = j == axis ? upper : (std::min)(upper + widest, m_below.upper[j]);
    }
    m_analysis.rebuild(Cell(box.size(), 0), m_above);
    m_analysis.look_at(m_above);
    on_layer.refine(m_above, box);
    return is_narrow(box, axis);
  }

  // Finishes a box where the solutions are a graph over one unknown; false when something cannot be decided.
  bool joined(const Exact_ranges& box, Vertex_indices vertices, int parameter)
  {
    const std::size_t before = m_vertices.size();
    Undecided_reason reason = m_vertices.meets_continuum(box) ? Undecided_reason::CONTINUUM : Undecided_reason::NONE;
    for (auto g = m_open_inequalities.begin(); g != m_open_inequalities.end() && reason == Undecided_reason::NONE; ++g)
      reason = m_vertices.add_zeros(m_equalities, m_system.inequalities(), *g, box, vertices);
    if (reason == Undecided_reason::NONE && add_pieces(box, vertices, parameter))
      return true;
    m_vertices.resize(before);
    if (reason != Undecided_reason::CONTINUUM)
      return false;
    std::erase_if(vertices, [&](std::size_t i) { return i >= before; });
    // along a curve that an inequality is zero on, or that lies in a face: smaller boxes would not help
    m_undecided.push_back({box, std::move(vertices), reason});
    return true;
  }

  /*
  Makes the pieces between vertices on a graph over one unknown. At a regular point inside a face the curve goes through
  the face, so that it is in the box on just one side of the point, and pieces begin and end at such points in turns. On
  edges of the box, where the curve touches it, and wherever inequalities matter, a slice between this vertex and the
  next one tells whether there is a piece. False when the order of the vertices or a slice cannot be decided.
  */
  bool add_pieces(const Exact_ranges& box, Vertex_indices& vertices, int parameter)
  {
    const auto place = [&](std::size_t i) -> const std::pair<Exact_rational, Exact_rational>& {
      return m_vertices[i].box[parameter];
    };
    std::sort(vertices.begin(), vertices.end(),
              [&](std::size_t i, std::size_t j) { return place(i).first < place(j).first; });
    for (std::size_t k = 0; k < vertices.size(); ++k)
      if (m_vertices[vertices[k]].kind == Plane_point::UNKNOWN ||
          (k > 0 && place(vertices[k]).first <= place(vertices[k - 1]).second))
        return false;
    std::vector<Curve_piece> pieces;
    bool is_inside = false;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      if (is_inside)
        pieces.push_back({box, parameter, {vertices[k - 1], vertices[k]}});
      const Plane_point& vertex = m_vertices[vertices[k]];
      if (m_open_inequalities.empty() && vertex.kind == Plane_point::REGULAR && vertex.planes() == 1)
        is_inside = !is_inside;
      else if (k + 1 == vertices.size())
        is_inside = false;
      else if (const std::optional<bool> answer =
                   has_solution_between(box, parameter, place(vertices[k]).second, place(vertices[k + 1]).first))
        is_inside = *answer;
      else
        return false;
    }
    if (is_inside)
      return false;
    m_pieces.insert(m_pieces.end(), pieces.begin(), pieces.end());
    return true;
  }

  // Whether the box has solutions with an unknown between two values, all or none of which have one.
  std::optional<bool> has_solution_between(const Exact_ranges& box, int unknown, const Exact_rational& lower,
                                           const Exact_rational& upper)
  {
    const Solution_set_d<double> slice =
        m_vertices.solve(on_plane(m_closure, box, unknown, Exact_rational((lower + upper) / 2)));
    if (slice.count(Solution_kind::CERTIFIED) > 0)
      return true;
    return slice.is_complete() && slice.empty() ? std::optional(false) : std::nullopt;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_SUBDIVISION_H
