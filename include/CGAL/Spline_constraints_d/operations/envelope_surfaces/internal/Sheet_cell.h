// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SHEET_CELL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SHEET_CELL_H

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Touching_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
The solutions in a box of the equations of a pair of operands that balls touch, two more unknowns than equations. In a
graph all but two unknowns are functions of these two, the parameters, wherever there is a solution in the box: the
matrix of the derivatives by the others, times an approximate inverse of one of its values, is nearer to the identity
than one. It is full if there is a solution for all values of the parameters.
*/
template <class Pair>
class Sheet_cell
{
public:
  static constexpr std::size_t equations = Pair::equations, unknowns = Pair::unknowns;
  using Interval = CGAL::Interval_nt<false>;
  using Box = typename Pair::Box;
  using Graph = typename Pair::Graph;

  enum class State
  {
    EMPTY,
    GRAPH,
    UNKNOWN
  };

private:
  using Matrix = Eigen::Matrix<double, static_cast<int>(equations), static_cast<int>(equations)>;
  using Bounds = Linear_bounds<equations, unknowns>;

  // The equations, times a matrix: those of the other unknowns are nearly the identity.
  struct Preconditioned
  {
    std::array<Interval, equations> values;
    std::array<std::array<Interval, unknowns>, equations> slopes;
    Interval distance; // of the part of the others from the identity
  };

  Box m_box;
  std::array<std::size_t, equations> m_others{};
  std::array<std::size_t, 2> m_parameters{};
  State m_state = State::UNKNOWN;
  bool m_has_axes = false, m_is_full = false;

public:
  //! \pre rounding is upwards, here and below.
  explicit Sheet_cell(const Box& box) : m_box(box) {}

  const Box& box() const { return m_box; }
  State state() const { return m_state; }
  bool is_full() const { return m_is_full; }
  const std::array<std::size_t, 2>& parameters() const { return m_parameters; }
  double width(std::size_t i) const { return m_box[i].sup() - m_box[i].inf(); }

  // Looks for a graph, and makes the box narrower.
  void contract(const Pair& pair)
  {
    constexpr int most_rounds = 3;
    for (int round = 0; round < most_rounds; ++round) {
      const Box last = m_box;
      if (!contract_once(pair)) {
        m_state = State::EMPTY;
        return;
      }
      double ratio = 1;
      for (std::size_t i = 0; i < unknowns; ++i)
        if (last[i].sup() > last[i].inf())
          ratio = (std::min)(ratio, width(i) / (last[i].sup() - last[i].inf()));
      if (ratio > 0.75)
        return;
    }
  }

  // Tries a box that is wider on the axes of the others, within the unit boxes, to know that the graph is full: as wide
  // as a graph through the box may be over the ranges of the parameters.
  void try_to_fill(const Pair& pair)
  {
    if (m_state != State::GRAPH || m_is_full)
      return;
    const auto feet = pair.feet(m_box);
    if (!feet)
      return;
    const auto all = slopes(std::as_const(*this).preconditioned(pair, *feet));
    Sheet_cell wider(*this);
    for (const std::size_t i : m_others) {
      constexpr double share = 0.125;
      double margin = share * width(i) + 0x1p-40;
      for (const std::size_t k : {0, 1})
        margin += CGAL::abs(all[i][k]).sup() * width(m_parameters[k]);
      const Interval range(m_box[i].inf() - margin, m_box[i].sup() + margin);
      wider.m_box[i] = i + 1 < unknowns ? intersection(range, Interval(0, 1)) : range;
    }
    wider.contract(pair);
    if (wider.m_is_full && wider.m_state == State::GRAPH)
      *this = wider;
  }

  // Over a part of the ranges of the parameters.
  Sheet_cell part(const std::array<Interval, 2>& ranges) const
  {
    Sheet_cell result(*this);
    for (const std::size_t k : {0, 1})
      result.m_box[m_parameters[k]] = ranges[k];
    return result;
  }

  // With a range on one axis; nothing is known of it.
  Sheet_cell cut(std::size_t axis, const Interval& range) const
  {
    Sheet_cell result(m_box);
    result.m_box[axis] = range;
    return result;
  }

  // \pre it is a graph.
  std::optional<Graph> graph(const Pair& pair) const
  {
    const auto feet = pair.feet(m_box);
    if (!feet)
      return std::nullopt;
    Graph result;
    result.box = m_box;
    result.feet = *feet;
    result.bounds = pair.bounds(m_box);
    result.slopes = slopes(preconditioned(pair, *feet));
    result.middle = m_box;
    result.middle_feet = *feet;
    result.half_widths = {0, 0};
    if (!m_is_full)
      return result;
    const std::array<Interval, 2> middle{Foot_grid::midpoint(m_box[m_parameters[0]]),
                                         Foot_grid::midpoint(m_box[m_parameters[1]])};
    const std::optional<Box> own = solution_at(pair, middle);
    const auto feet_of_own = own ? pair.feet(*own) : std::nullopt;
    if (!feet_of_own)
      return std::nullopt;
    result.middle = *own;
    result.middle_feet = *feet_of_own;
    for (const std::size_t k : {0, 1}) {
      const Interval& range = m_box[m_parameters[k]];
      result.half_widths[k] =
          (std::max)((Interval(range.sup()) - middle[k]).sup(), (middle[k] - Interval(range.inf())).sup());
    }
    return result;
  }

  // A small box around the only solution for these values of the parameters; or none.
  std::optional<Box> solution_at(const Pair& pair, const std::array<Interval, 2>& values) const
  {
    Sheet_cell point = part(values);
    constexpr int most_rounds = 6;
    double last = 0;
    for (int round = 0; round < most_rounds; ++round) {
      if (!point.contract_once(pair))
        return std::nullopt;
      double size = 0;
      for (const std::size_t i : m_others)
        size = (std::max)(size, point.width(i));
      if (round > 0 && !(size < 0.25 * last))
        break;
      last = size;
    }
    return point.m_box;
  }

private:
  // False if there is no solution.
  bool contract_once(const Pair& pair)
  {
    const auto feet = pair.feet(m_box);
    if (!feet) {
      m_state = State::UNKNOWN;
      return true;
    }
    const std::optional<Interval> steps = pair.steps(*feet);
    Interval& x = m_box.back();
    if (!steps || !have_common_point(*steps, x))
      return false;
    if (!m_has_axes)
      x = intersection(*steps, x);
    return contract_by(preconditioned(pair, *feet));
  }

  Preconditioned preconditioned(const Pair& pair, const typename Pair::Feet& feet)
  {
    const Bounds all = pair.linear(feet, m_box.back());
    if (!m_has_axes)
      choose_axes(all);
    return static_cast<const Sheet_cell*>(this)->preconditioned(pair, feet);
  }

  Preconditioned preconditioned(const Pair& pair, const typename Pair::Feet& feet) const
  {
    const Bounds all = pair.linear(feet, m_box.back());
    Matrix matrix;
    for (std::size_t i = 0; i < equations; ++i)
      for (std::size_t k = 0; k < equations; ++k)
        matrix(static_cast<int>(i), static_cast<int>(k)) = Foot_grid::midpoint(all.slopes[i][m_others[k]]);
    const Matrix inverse = matrix.inverse();
    Preconditioned result;
    Box middle;
    for (std::size_t j = 0; j < unknowns; ++j)
      middle[j] = Foot_grid::midpoint(m_box[j]);
    result.distance = Interval(0);
    const auto feet_of_middle = pair.feet(middle);
    if (!inverse.allFinite() || !feet_of_middle) {
      result.distance = Interval(2);
      return result;
    }
    const Bounds at_middle = pair.linear(*feet_of_middle, middle.back());
    for (std::size_t i = 0; i < equations; ++i) {
      const auto product = [&](const auto& entry) {
        Interval sum(0);
        for (std::size_t k = 0; k < equations; ++k)
          sum += Interval(inverse(static_cast<int>(i), static_cast<int>(k))) * entry(k);
        return sum;
      };
      result.values[i] = product([&](std::size_t k) { return at_middle.values[k]; });
      for (std::size_t j = 0; j < unknowns; ++j)
        result.slopes[i][j] = product([&](std::size_t k) { return all.slopes[k][j]; });
      Interval row(0);
      for (std::size_t k = 0; k < equations; ++k)
        row += CGAL::abs(result.slopes[i][m_others[k]] - Interval(k == i ? 1 : 0));
      result.distance = (std::max)(result.distance.sup(), row.sup());
    }
    return result;
  }

  bool contract_by(const Preconditioned& rows)
  {
    m_state = rows.distance.sup() < 1 ? State::GRAPH : State::UNKNOWN;
    if (rows.distance.sup() >= 2)
      return true;
    bool is_inside = true;
    Box result = m_box;
    for (std::size_t i = 0; i < equations; ++i) {
      Interval rest = rows.values[i];
      for (std::size_t j = 0; j < unknowns; ++j) {
        const bool is_own = j == m_others[i];
        rest += (is_own ? rows.slopes[i][j] - Interval(1) : rows.slopes[i][j]) *
            (m_box[j] - Interval(Foot_grid::midpoint(m_box[j])));
      }
      const Interval& range = m_box[m_others[i]];
      const Interval image = Interval(Foot_grid::midpoint(range)) - rest;
      if (!have_common_point(image, range))
        return false;
      is_inside = is_inside && range.inf() < image.inf() && image.sup() < range.sup();
      result[m_others[i]] = intersection(image, range);
    }
    m_is_full = m_is_full || (is_inside && m_state == State::GRAPH);
    m_box = result;
    return true;
  }

  // Of others by the parameters: A D = -B with |A - I| <= r < 1 has the solutions |D| <= |B| / (1 - r).
  std::array<std::array<Interval, 2>, unknowns> slopes(const Preconditioned& rows) const
  {
    std::array<std::array<Interval, 2>, unknowns> result;
    const Interval rest = Interval(1) - Interval(rows.distance.sup());
    for (const std::size_t k : {0, 1}) {
      for (const std::size_t other : {0, 1})
        result[m_parameters[other]][k] = other == k ? 1 : 0;
      Interval greatest(0);
      for (std::size_t i = 0; i < equations; ++i)
        greatest = (std::max)(greatest.sup(), CGAL::abs(rows.slopes[i][m_parameters[k]]).sup());
      greatest = rest.inf() > 0 ? greatest / rest : Interval::largest();
      for (std::size_t i = 0; i < equations; ++i)
        result[m_others[i]][k] = Interval(-greatest.sup(), greatest.sup());
      constexpr int rounds = 2;
      for (int round = 0; round < rounds; ++round) {
        const auto last = result;
        for (std::size_t i = 0; i < equations; ++i) {
          Interval sum = -rows.slopes[i][m_parameters[k]];
          for (std::size_t j = 0; j < equations; ++j)
            sum -= (rows.slopes[i][m_others[j]] - Interval(j == i ? 1 : 0)) * last[m_others[j]][k];
          result[m_others[i]][k] = intersection(sum, last[m_others[i]][k]);
        }
      }
    }
    return result;
  }

  // By elimination with the greatest pivots: those of the others have a large determinant. The last unknown is a length
  // and is measured by the greatest derivative of the points.
  void choose_axes(const Bounds& all)
  {
    Eigen::Matrix<double, static_cast<int>(equations), static_cast<int>(unknowns)> matrix;
    double greatest = 0;
    for (std::size_t i = 0; i < equations; ++i)
      for (std::size_t j = 0; j < unknowns; ++j) {
        matrix(static_cast<int>(i), static_cast<int>(j)) = Foot_grid::midpoint(all.slopes[i][j]);
        if (j + 1 < unknowns)
          greatest = (std::max)(greatest, std::abs(Foot_grid::midpoint(all.slopes[i][j])));
      }
    matrix.col(static_cast<int>(unknowns) - 1) *= greatest;
    const Eigen::FullPivLU<decltype(matrix)> factors(matrix);
    const auto& order = factors.permutationQ().indices();
    for (std::size_t k = 0; k < unknowns; ++k) {
      const auto axis = static_cast<std::size_t>(order(static_cast<int>(k)));
      if (k < equations)
        m_others[k] = axis;
      else
        m_parameters[k - equations] = axis;
    }
    m_has_axes = true;
  }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SHEET_CELL_H
