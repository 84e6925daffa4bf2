// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OVERLAP_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OVERLAP_FINDER_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/patch_cells.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_overlap_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Parameter_maps.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/overlap_declarations.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/surface_cells.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
The parts of a surface A that lie on another one, B. Let f be the irreducible polynomial of a cell of A, of degree four
at most. A cell of B with an open part in common satisfies f = 0, too. Where it is regular, it maps neighbourhoods onto
neighbourhoods in f = 0, so that the regions are bounded by the edges of such cells, and by breaks at which they fold
back: these are among the zeros of polynomials that vanish on an edge, but not on A. In each face a point of A is
decided: it is on B, if B has a point with two equal coordinates, the third one next to its own, and f is strictly
monotone along this one there.

Cells without such a polynomial are compared as maps. Where A = B o q, the region is a rectangle.
*/
class Overlap_finder
{
  using Exact_point = std::array<Exact_rational, 3>;
  enum class Relation_of_cells
  {
    APART,
    SAME_SIDE, // the same equation, and the normal is on the side of the gradient
    OTHER_SIDE,
    SAME_MAP,
    UNKNOWN
  };
  using Relations = std::vector<Relation_of_cells>; // to the cells of the other surface

  struct Equation
  {
    Power_polynomial polynomial;
    Relations relations;
  };
  static constexpr int most_degree_of_surface = 4, most_degree_of_edge = 6;

  const Spline_patch<3>&m_own, &m_other;
  Operation_budget& m_budget;
  std::vector<Surface_cell_3> m_cells, m_other_cells;
  std::vector<Equation> m_equations;
  std::vector<std::optional<std::size_t>> m_equation_of; // the cells
  std::vector<Relations> m_relations;                    // of the cells
  std::vector<std::vector<Parameter_map>> m_maps;        // where they are the same map

public:
  Overlap_finder(const Spline_patch<3>& own, const Spline_patch<3>& other, Operation_budget& budget)
    : m_own(own), m_other(other), m_budget(budget), m_cells(cells_of(own)), m_other_cells(cells_of(other)),
      m_equation_of(m_cells.size()), m_relations(m_cells.size()), m_maps(m_cells.size())
  {}

  Trimmed_surface_3 operator()()
  {
    Trimming trimming{m_cells, {m_own.is_closed(0), m_own.is_closed(1)}, {}, {}};
    trimming.zeros = [this](std::size_t cell) {
      compare(cell);
      return zeros(cell);
    };
    trimming.label = [this](std::size_t cell, const Parameters& p) {
      const std::optional<Overlap> result = overlap(cell, p);
      return result ? std::optional(static_cast<int>(*result)) : std::nullopt;
    };
    return trimmed_by_zeros(trimming, m_budget);
  }

private:
  static Spline_patch<3> part_of_cell(const Spline_patch<3>& patch, const Surface_cell_3& cell)
  {
    return patch.part({cell.domain[0], cell.domain[1]});
  }

  static bool vanishes(const Power_polynomial& f, const Surface_cell_3& cell)
  {
    return is_zero(composed(f, f.total_degree(), cell.coordinates));
  }

  // Its equation, or one that is known already.
  void find_equation(std::size_t cell)
  {
    for (std::size_t k = 0; k < m_equations.size() && !m_equation_of[cell]; ++k)
      if (vanishes(m_equations[k].polynomial, m_cells[cell]))
        m_equation_of[cell] = k;
    const Spline_patch<3> part = part_of_cell(m_own, m_cells[cell]);
    for (int degree = 1; degree <= most_degree_of_surface && !m_equation_of[cell]; ++degree)
      if (auto polynomial = Implicit_equation(part, degree, [this] { m_budget.check(); })()) {
        m_equation_of[cell] = m_equations.size();
        m_equations.push_back({*polynomial, {}});
        for (const Surface_cell_3& other : m_other_cells)
          m_equations.back().relations.push_back(relation_to(*polynomial, other));
      }
  }

  void compare(std::size_t cell)
  {
    if (!m_relations[cell].empty())
      return;
    find_equation(cell);
    if (m_equation_of[cell]) {
      m_relations[cell] = m_equations[*m_equation_of[cell]].relations;
      return;
    }
    const Vector_bounds<3> bounds = part_of_cell(m_own, m_cells[cell]).values();
    for (const Surface_cell_3& other : m_other_cells) {
      m_budget.check();
      m_relations[cell].push_back(relation_of_maps(cell, bounds, other));
    }
  }

  // Without the same equation, cells have curves in common at most.
  Relation_of_cells relation_to(const Power_polynomial& f, const Surface_cell_3& other) const
  {
    m_budget.check();
    if (!vanishes(f, other))
      return Relation_of_cells::APART;
    Cell_vector gradient;
    for (int i = 0; i < 3; ++i)
      gradient[static_cast<std::size_t>(i)] = composed(f.derivative(i), f.total_degree() - 1, other.coordinates);
    const Cell_polynomial side = dot(normal_of(other), gradient);
    if (is_zero(side))
      return Relation_of_cells::UNKNOWN;
    try {
      return certified_weight_sign(without_sides(side), {.maximal_depth = 12, .maximal_parts = 500}) > 0
          ? Relation_of_cells::SAME_SIDE
          : Relation_of_cells::OTHER_SIDE;
    } catch (const Invalid_input&) { // it may be folded
      return Relation_of_cells::UNKNOWN;
    }
  }

  Relation_of_cells relation_of_maps(std::size_t cell, const Vector_bounds<3>& bounds, const Surface_cell_3& other)
  {
    if (squared_norm(bounds - part_of_cell(m_other, other).values()).lower > 0)
      return Relation_of_cells::APART;
    const auto map = Parameter_maps(m_cells[cell], other)();
    if (!map)
      return Relation_of_cells::UNKNOWN;
    m_maps[cell].push_back(*map);
    return Relation_of_cells::SAME_MAP;
  }

  static bool have_same_equation(Relation_of_cells relation)
  {
    return relation == Relation_of_cells::SAME_SIDE || relation == Relation_of_cells::OTHER_SIDE;
  }

  std::vector<Cell_polynomial> zeros(std::size_t cell) const
  {
    std::vector<Cell_polynomial> result;
    for (const Parameter_map& map : m_maps[cell])
      for (const std::size_t axis : {0, 1})
        for (const int end : {0, 1})
          if (const Exact_rational x = map.preimage(axis, Exact_rational(end)); 0 < x && x < 1)
            result.push_back(line(axis, x));
    for (std::size_t k = 0; k < m_other_cells.size(); ++k)
      if (have_same_equation(m_relations[cell][k]))
        for (const int axis : {0, 1})
          for (const int side : {0, 1})
            if (!continues(cell, k, axis, side))
              add_edge(m_cells[cell], m_other_cells[k], axis, side, result);
    return result;
  }

  // x on the axis, less a number.
  static Cell_polynomial line(std::size_t axis, const Exact_rational& x)
  {
    std::vector<int> degrees{0, 0};
    degrees[axis] = 1;
    return Cell_polynomial(degrees, {Exact_rational(-x), Exact_rational(1 - x)});
  }

  // Whether the next cell of the other surface goes on along the same side of the same zeros, so that what they have in
  // common bounds nothing.
  bool continues(std::size_t cell, std::size_t other, int axis, int side) const
  {
    const std::size_t along = static_cast<std::size_t>(axis);
    const auto& domain = m_other_cells[other].domain;
    const Parameter_range whole = m_other.domain(axis);
    Exact_rational end = side == 0 ? domain[along].first : domain[along].second;
    if (end == (side == 0 ? whole.first : whole.second)) {
      if (!m_other.is_closed(axis))
        return false;
      end = side == 0 ? whole.second : whole.first;
    }
    for (std::size_t k = 0; k < m_other_cells.size(); ++k)
      if (m_other_cells[k].domain[1 - along] == domain[1 - along] &&
          (side == 0 ? m_other_cells[k].domain[along].second : m_other_cells[k].domain[along].first) == end)
        return m_relations[cell][k] == m_relations[cell][other];
    return false;
  }

  // \throws Run_stopped; an edge without a polynomial leaves the cell undecided.
  void add_edge(const Surface_cell_3& cell, const Surface_cell_3& other, int axis, int side,
                std::vector<Cell_polynomial>& result) const
  {
    const auto& [begin, end] = other.domain[static_cast<std::size_t>(axis)];
    const Exact_rational value = side == 0 ? begin : end;
    const Spline_patch<3> edge = part_of_cell(m_other, other).part(axis, {value, value});
    if (edge.is_one_point())
      return;
    for (int degree = 1; degree <= most_degree_of_edge; ++degree)
      for (const Power_polynomial& f : Implicit_equation<3, 1>(edge, degree, [this] { m_budget.check(); }).basis()) {
        Cell_polynomial zeros = composed(f, f.total_degree(), cell.coordinates);
        if (!is_zero(zeros)) {
          result.push_back(without_factors_of(cell.coordinates[3], zeros));
          return;
        }
      }
    result.push_back(Cell_polynomial::constant(2, Exact_rational(0)));
  }

  std::optional<Overlap> overlap(std::size_t cell, const Parameters& parameters) const
  {
    const Surface_cell_3& own = m_cells[cell];
    const Parameters local{own.local_parameter(0, parameters[0]), own.local_parameter(1, parameters[1])};
    for (const Parameter_map& map : m_maps[cell])
      if (is_in_unit_box(map, local))
        return Overlap::COMMON;
    const auto has = [&](Relation_of_cells x) { return std::ranges::count(m_relations[cell], x) > 0; };
    if (has(Relation_of_cells::UNKNOWN) || has(Relation_of_cells::SAME_MAP))
      return std::nullopt;
    if (!std::ranges::any_of(m_relations[cell], have_same_equation))
      return Overlap::OWN;
    Exact_point point = value_of(numerators_of(own), local);
    const Exact_rational weight = own.coordinates[3](local);
    for (Exact_rational& x : point)
      x /= weight;
    const Power_polynomial& f = m_equations[*m_equation_of[cell]].polynomial;
    if (!has(Relation_of_cells::APART))
      return has_point(m_other, f, point);
    for (std::size_t k = 0; k < m_other_cells.size(); ++k)
      if (have_same_equation(m_relations[cell][k]))
        if (const auto result = has_point(part_of_cell(m_other, m_other_cells[k]), f, point); result != Overlap::OWN)
          return result;
    return Overlap::OWN;
  }

  static bool is_in_unit_box(const Parameter_map& map, const Parameters& local)
  {
    return std::ranges::all_of(std::array<std::size_t, 2>{0, 1}, [&](std::size_t axis) {
      const Exact_rational image(map.lines[axis].first * local[axis] + map.lines[axis].second);
      return 0 <= image && image <= 1;
    });
  }

  // Whether a point with f = 0 is on a patch with f = 0.
  std::optional<Overlap> has_point(const Spline_patch<3>& patch, const Power_polynomial& f,
                                   const Exact_point& point) const
  {
    std::array<Exact_rational, 3> slopes;
    for (int i = 0; i < 3; ++i)
      slopes[static_cast<std::size_t>(i)] = CGAL::abs(f.derivative(i)(point));
    const std::size_t height = static_cast<std::size_t>(std::ranges::max_element(slopes) - slopes.begin());
    if (slopes[height] == 0)
      return std::nullopt;
    const Parameter_box domain{patch.domain(0), patch.domain(1)};
    const std::vector<Unknown> u = unknowns_in(domain);
    const Vector_expression<3> image = Parametric_vector<3>(patch)(u);
    std::vector<Constraint> constraints;
    for (std::size_t i = 0; i < 3; ++i)
      if (i != height)
        constraints.push_back(image[i] == Expression(point[i]));
    Budgeted_solver solve(m_budget);
    const Solution_set_d<double> solutions = solve(constraints, u);
    m_budget = solve.budget();
    bool is_decided = true;
    for (const Solution_d<double>& solution : solutions) {
      const Parameter_box box = clipped(solution.exact_box(), domain);
      Rational_interval range = patch.part(1, box[1]).part(0, box[0]).values()[height];
      if (point[height] < range.lower || range.upper < point[height])
        continue;
      const bool is_one = solution.kind() == Solution_kind::CERTIFIED || solution.kind() == Solution_kind::CLUSTER;
      if (is_one && is_monotone(f, point, height, range))
        return Overlap::COMMON;
      is_decided = false;
    }
    return is_decided ? std::optional(Overlap::OWN) : std::nullopt;
  }

  // Whether f has one zero over the range of a coordinate, with the others as they are.
  static bool is_monotone(const Power_polynomial& f, const Exact_point& point, std::size_t height,
                          const Rational_interval& range)
  {
    Power_polynomial slope = f.derivative(static_cast<int>(height));
    for (std::size_t i = 0; i < 3; ++i)
      if (i != height)
        slope = slope.substituted(static_cast<int>(i), Power_polynomial(point[i]));
    Rational_interval sum(Exact_rational(0)), power(Exact_rational(1));
    for (int k = 0; k <= slope.total_degree(); ++k, power = power * range)
      for (const auto& [monomial, coefficient] : slope.terms())
        if (monomial.total_degree() == k)
          sum = sum + power * Rational_interval(coefficient);
    return sum.lower > 0 || sum.upper < 0;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Trimmed_surface_3, 2>
overlap_of(const Exact_map<3>& first, const Exact_map<3>& second, const Solver_options& options)
{
  Operation_budget budget(options);
  const Spline_patch<3> a(first), b(second);
  Trimmed_surface_3 on_first = Overlap_finder(a, b, budget)();
  return {std::move(on_first), Overlap_finder(b, a, budget)()};
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OVERLAP_FINDER_H
