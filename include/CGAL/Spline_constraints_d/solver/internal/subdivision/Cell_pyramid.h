// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_CELL_PYRAMID_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_CELL_PYRAMID_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_position.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The cells of the domain that may hold a solution, without looking at each of them: two splines with a thousand pieces
each make a million cells, most of which are far from any solution.

Every term of the constraints is bounded on the cells of its own unknowns only, a thousand numbers per spline rather
than a million; and these bounds are united over pairs of neighbouring cells along each axis, pairs of pairs, and so on.
The cells are visited as a tree from the top of that pyramid; a group in which the sum of the bounds excludes a
constraint is left out at once. For curves that meet, this is the simultaneous descent in their trees of bounding boxes.
*/
class Cell_pyramid
{
  using Interval = CGAL::Interval_nt<false>;   // within an Upward_rounding_guard
  using Bounds = std::pair<double, double>;
  using Sizes = std::vector<int>;

  struct Level
  {
    Sizes sizes;                  // groups of cells along each axis of the term
    std::vector<Bounds> bounds;   // of the term in a group, the last axis fastest
  };

  struct Bounded_term
  {
    std::vector<int> axes;
    std::vector<Level> levels;   // the last one is a single group
  };

  struct Bounded_function
  {
    Relation relation;
    std::vector<Bounded_term> terms;
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<Sizes> m_sizes;   // of all groups, per level and unknown
  std::vector<Bounded_function> m_functions;

  Run_control* m_control;   // null: none

public:
  // With a control, the constructor throws Run_stopped when it says so: there may be a million cells.
  Cell_pyramid(const Constraint_system_d& system, const std::vector<std::vector<Exact_rational>>& breaks,
               Run_control* control = nullptr)
    : m_control(control)
  {
    const Upward_rounding_guard guard;
    make_sizes(breaks);
    for (const Spline_function& function : system.equalities())
      m_functions.push_back(bounded(system, breaks, function, Relation::EQUAL));
    for (const Constraint_system_d::Inequality& inequality : system.inequalities())
      m_functions.push_back(bounded(system, breaks, inequality.function, inequality.relation));
  }

  // Calls visit(cell) for every cell where the bounds admit a solution.
  template <class Visitor>
  void visit_possible_cells(const Visitor& visit) const
  {
    const Upward_rounding_guard guard;
    visit_group(m_sizes.size() - 1, Cell(m_sizes[0].size(), 0), visit);
  }

private:
  static Sizes halved(Sizes sizes)
  {
    for (int& size : sizes)
      size = (size + 1) / 2;
    return sizes;
  }

  static bool is_one_group(const Sizes& sizes)
  {
    return std::all_of(sizes.begin(), sizes.end(), [](int size) { return size == 1; });
  }

  void make_sizes(const std::vector<std::vector<Exact_rational>>& breaks)
  {
    Sizes& cells = m_sizes.emplace_back();
    for (const std::vector<Exact_rational>& of_axis : breaks)
      cells.push_back(of_axis.size() > 2 ? static_cast<int>(of_axis.size()) - 1 : 1);
    while (!is_one_group(m_sizes.back()))
      m_sizes.push_back(halved(m_sizes.back()));
  }

  Bounded_function bounded(const Constraint_system_d& system, const std::vector<std::vector<Exact_rational>>& breaks,
                           const Spline_function& function, Relation relation) const
  {
    Bounded_function result{relation, {}};
    for (const Spline_term& term : function.terms()) {
      result.terms.push_back({term.variables, {cell_bounds(system, breaks, term)}});
      for (std::vector<Level>& levels = result.terms.back().levels; !is_one_group(levels.back().sizes);)
        levels.push_back(united_pairs(levels.back()));
    }
    return result;
  }

  // A term on every cell of its unknowns, by Bernstein coefficients.
  Level cell_bounds(const Constraint_system_d& system, const std::vector<std::vector<Exact_rational>>& breaks,
                    const Spline_term& term) const
  {
    const std::size_t dimension = term.variables.size();
    Level result;
    std::vector<std::vector<Row_matrix<Interval>>> conversions(dimension);   // per axis and cell
    // where the cell lies in the term's own grid
    std::vector<std::vector<std::size_t>> pieces(dimension);
    for (std::size_t j = 0; j < dimension; ++j) {
      const int unknown = term.variables[j];
      result.sizes.push_back(m_sizes[0][unknown]);
      for (int k = 0; k < result.sizes[j]; ++k) {
        const auto [begin, end] =
            result.sizes[j] == 1 ? system.domain(unknown) : std::pair(breaks[unknown][k], breaks[unknown][k + 1]);
        conversions[j].push_back(
            from_power_matrix(term.degrees[j], Interval(to_double_interval(begin)), Interval(to_double_interval(end))));
        pieces[j].push_back(cell_at(term.breaks[j], begin));
      }
    }
    constexpr std::size_t many_cells = 256;   // between two questions whether to go on
    for_each_index(last_of(result.sizes), [&](const std::vector<int>& cell) {
      if (m_control != nullptr && result.bounds.size() % many_cells == 0)
        m_control->check();
      std::size_t piece = 0;
      for (std::size_t j = 0; j < dimension; ++j)
        piece = piece * term.cells(j) + pieces[j][cell[j]];
      std::vector<Interval> coefficients;
      for (const Exact_rational& coefficient : term.pieces[piece])
        coefficients.emplace_back(to_double_interval(coefficient));
      for (std::size_t j = 0; j < dimension; ++j)
        coefficients = transform_axis(coefficients, axis_view(term.degrees, j), conversions[j][cell[j]]);
      result.bounds.push_back(bounds_of(coefficients));
    });
    return result;
  }

  static Bounds bounds_of(const std::vector<Interval>& coefficients)
  {
    Bounds result(infinity, -infinity);
    for (const Interval& x : coefficients) {
      if (!is_finite_number(x))
        return {-infinity, infinity};   // beyond the range of doubles
      result = united(result, {x.inf(), x.sup()});
    }
    return result;
  }

  static Bounds united(const Bounds& a, const Bounds& b)
  {
    return {(std::min)(a.first, b.first), (std::max)(a.second, b.second)};
  }

  static std::vector<int> last_of(std::vector<int> sizes)
  {
    for (int& size : sizes)
      --size;
    return sizes;
  }

  static std::size_t position_of(const std::vector<int>& index, const Sizes& sizes)
  {
    std::size_t position = 0;
    for (std::size_t j = 0; j < index.size(); ++j)
      position = position * sizes[j] + index[j];
    return position;
  }

  static Level united_pairs(const Level& fine)
  {
    Level result{halved(fine.sizes), {}};
    result.bounds.assign(position_of(last_of(result.sizes), result.sizes) + 1, Bounds(infinity, -infinity));
    auto next = fine.bounds.begin();
    for_each_index(last_of(fine.sizes), [&](std::vector<int> index) {
      for (int& k : index)
        k /= 2;
      Bounds& bounds = result.bounds[position_of(index, result.sizes)];
      bounds = united(bounds, *next++);
    });
    return result;
  }

  bool may_hold_solution(std::size_t level, const Cell& group) const
  {
    return std::none_of(m_functions.begin(), m_functions.end(), [&](const Bounded_function& function) {
      Interval sum(0);
      for (const Bounded_term& term : function.terms) {
        const Level& on_level = term.levels[(std::min)(level, term.levels.size() - 1)];
        std::vector<int> index;
        for (int unknown : term.axes)
          index.push_back(group[unknown]);
        sum += Interval(on_level.bounds[position_of(index, on_level.sizes)]);
      }
      return is_certainly_violated(function.relation, sum.inf(), sum.sup());
    });
  }

  template <class Visitor>
  void visit_group(std::size_t level, const Cell& group, const Visitor& visit) const
  {
    if (!may_hold_solution(level, group))
      return;
    if (level == 0)
      visit(group);
    else
      visit_parts(level - 1, group, 0, visit);
  }

  // The parts of a group, whose index is doubled, and perhaps one more, from an axis on.
  template <class Visitor>
  void visit_parts(std::size_t level, Cell part, std::size_t axis, const Visitor& visit) const
  {
    if (axis == part.size())
      return visit_group(level, part, visit);
    part[axis] *= 2;
    visit_parts(level, part, axis + 1, visit);
    if (++part[axis] < m_sizes[level][axis])
      visit_parts(level, part, axis + 1, visit);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_CELL_PYRAMID_H
