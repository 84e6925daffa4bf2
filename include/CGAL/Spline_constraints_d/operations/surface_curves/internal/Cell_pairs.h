// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_CELL_PAIRS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_CELL_PAIRS_H

#include <CGAL/Spline_constraints_d/number/Number_traits_exact.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

using Interval_vector = std::array<CGAL::Interval_nt<false>, 3>;   // within an Upward_rounding_guard

template <class NT>
std::array<NT, 3> cross_product(const std::array<NT, 3>& a, const std::array<NT, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The convex cones that hold the derivatives of a surface by its parameters, by vectors that generate them.
using Tangent_cones = std::array<std::vector<Interval_vector>, 2>;

/*
Whether det(n, a, b) > 0 for some n and all a and b in the two cones of the derivatives on a rectangle. Then S(P) = S(Q)
for no P != Q in it: the difference is (u - s) a + (v - t) b, where a and b are means of derivatives, which lie in the
same cones.
*/
inline bool is_one_to_one(const Tangent_cones& tangents)
{
  const Upward_rounding_guard rounding;
  std::array<Interval_vector, 2> sums;
  for (const std::size_t axis : {0, 1}) {
    sums[axis] = {0, 0, 0};
    for (const Interval_vector& vector : tangents[axis])
      for (std::size_t i = 0; i < 3; ++i)
        sums[axis][i] += CGAL::to_double(vector[i]);
  }
  Interval_vector n = cross_product(sums[0], sums[1]);
  for (CGAL::Interval_nt<false>& x : n)
    x = CGAL::to_double(x);
  return std::all_of(tangents[0].begin(), tangents[0].end(), [&](const Interval_vector& a) {
    const Interval_vector across = cross_product(n, a);
    return std::all_of(tangents[1].begin(), tangents[1].end(), [&](const Interval_vector& b) {
      return (across[0] * b[0] + across[1] * b[1] + across[2] * b[2]).inf() > 0;
    });
  });
}

/*
The unordered pairs P != Q of points of the domain of a surface with S(P) = S(Q) lie in products of two cells each, all
within polynomial pieces: of one cell with itself, of two that are apart, and of two near each other for which nothing
is known. All other pairs are proved to have different points:

Two cells with a common edge or corner are divided until they are apart, or the surface is one-to-one on the rectangle
around both of them; so on both sides of a break only pairs of distant points are left. The ends of a closed parameter
are an edge in common as well. In cells that have the same pole, an edge that is one point, all pairs on it have the
same point; what is near it, they have in common too.
*/
class Cell_pairs
{
  using Cell = std::array<Parameter_range, 2>;
  // of the second cell, by periods of closed parameters, that brings it next to the first one
  using Shift = std::array<Exact_rational, 2>;

  struct Piece
  {
    Spline_patch<3> patch;
    std::array<Vector_of_functions<3>, 2> tangents;   // of any lengths
  };

  // of both axes; across a pole, where the other axis does not count, one counts for two
  static constexpr int most_halvings = 16;

  std::function<void()> m_check;
  std::array<std::optional<Exact_rational>, 2> m_periods;
  std::array<std::vector<Parameter_range>, 2> m_ranges;
  std::vector<Piece> m_pieces;   // over the products of ranges
  std::vector<std::pair<int, Exact_rational>> m_poles;   // axis and parameter
  std::vector<Parameter_box> m_apart, m_undecided;
  std::vector<Spline_patch<3>> m_single;

public:
  // Before each cell and each pair of them `check()` may end the work by an exception.
  Cell_pairs(const Spline_patch<3>& patch, std::function<void()> check) : m_check(std::move(check))
  {
    for (const int axis : {0, 1}) {
      const auto [begin, end] = patch.domain(axis);
      if (patch.is_closed(axis))
        m_periods[axis] = Exact_rational(end - begin);
      for (const Exact_rational& value : {begin, end})
        if (patch.pole(axis, value))
          m_poles.emplace_back(axis, value);
      m_ranges[axis] = ranges(patch.breaks(axis), m_periods[axis].has_value());
    }
    std::vector<Cell> cells;
    for (const Parameter_range& u : m_ranges[0])
      for (const Parameter_range& v : m_ranges[1]) {
        m_check();
        cells.push_back({u, v});
        const Spline_patch<3> piece = patch.part({u, v});
        m_pieces.push_back({piece, {tangent_direction(piece, 0), tangent_direction(piece, 1)}});
      }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      add(cells[i], most_halvings);
      for (std::size_t j = i + 1; j < cells.size(); ++j)
        add(cells[i], cells[j], shift(cells[i], cells[j]), most_halvings);
    }
  }

  // Cells whose pairs may have equal points.
  const std::vector<Spline_patch<3>>& single_cells() const { return m_single; }

  // Ranges of u, v, s, t: two cells that are apart, whose points may be equal.
  const std::vector<Parameter_box>& cells_apart() const { return m_apart; }

  // The same of two cells that are next to each other, where nothing is proved.
  const std::vector<Parameter_box>& undecided() const { return m_undecided; }

private:
  // The pieces along an axis. Of a closed one at least three, so that two of them are neighbours in one way only.
  static std::vector<Parameter_range> ranges(const std::vector<Exact_rational>& breaks, bool is_closed)
  {
    std::vector<Parameter_range> result;
    for (std::size_t i = 1; i < breaks.size(); ++i)
      result.emplace_back(breaks[i - 1], breaks[i]);
    while (is_closed && result.size() < 3) {
      const Exact_rational cut = cut_of(result.back()), end = std::exchange(result.back().second, cut);
      result.emplace_back(cut, end);
    }
    return result;
  }

  void add(const Cell& cell, int halvings)
  {
    m_check();
    if (is_one_to_one(tangents(cell)))
      return;
    const std::optional<int> axis = axis_of_common_pole(cell, cell);
    if (!axis)
      m_single.push_back(part(cell));
    else if (halvings <= 0)
      m_undecided.push_back(product(cell, cell));
    else {
      const auto [a, b] = halves(cell, *axis);
      add(a, halvings - 2);
      add(b, halvings - 2);
      add(a, b, {}, halvings - 2);
    }
  }

  void add(const Cell& first, const Cell& second, const Shift& shift, int halvings)
  {
    m_check();
    if (have_distant_points(first, second) || is_one_to_one(tangents(hull_of(first, moved(second, shift)))))
      return;
    if (!are_neighbours(first, second, shift))
      m_apart.push_back(product(first, second));
    else if (halvings <= 0)
      m_undecided.push_back(product(first, second));
    else
      add_halves(first, second, shift, halvings);
  }

  void add_halves(const Cell& first, const Cell& second, const Shift& shift, int halvings)
  {
    const std::optional<int> pole = axis_of_common_pole(first, second);
    const int axis = pole.value_or(halvings % 2), left = halvings - (pole ? 2 : 1);
    for (const Cell& half : halves(first, axis))
      if (are_neighbours(half, second, shift))
        for (const Cell& other : halves(second, axis))
          add(half, other, shift, left);
      else
        add(half, second, shift, left);
  }

  // Whether two cells have common points by nature.
  bool are_neighbours(const Cell& first, const Cell& second, const Shift& shift) const
  {
    const Cell other = moved(second, shift);
    return (meet(first[0], other[0]) && meet(first[1], other[1])) || axis_of_common_pole(first, second);
  }

  std::optional<int> axis_of_common_pole(const Cell& first, const Cell& second) const
  {
    for (const auto& [axis, end] : m_poles)
      if (ends_at(first[axis], end) && ends_at(second[axis], end))
        return axis;
    return std::nullopt;
  }

  // By boxes around them. Neighbours have common points.
  bool have_distant_points(const Cell& first, const Cell& second) const
  {
    const Vector_bounds<3> a = part(first).values(), b = part(second).values();
    for (std::size_t i = 0; i < 3; ++i)
      if (a[i].upper < b[i].lower || b[i].upper < a[i].lower)
        return true;
    return false;
  }

  Shift shift(const Cell& first, const Cell& second) const
  {
    Shift result;
    for (const int axis : {0, 1})
      if (m_periods[axis] && !meet(first[axis], second[axis]))
        for (const Exact_rational& period : {*m_periods[axis], Exact_rational(-*m_periods[axis])})
          if (meet(first[axis], moved(second[axis], period)))
            result[axis] = period;
    return result;
  }

  // The part of the surface over a cell.
  Spline_patch<3> part(const Cell& cell) const
  {
    const std::size_t i = pieces_within(cell[0], 0).front().first, j = pieces_within(cell[1], 1).front().first;
    return piece(i, j).patch.part({cell[0], cell[1]});
  }

  // The derivatives over a rectangle, which may go on across breaks and seams: coefficients of polynomials generate
  // cones that hold their values.
  Tangent_cones tangents(const Cell& rectangle) const
  {
    Tangent_cones result;
    for (const auto& [i, u] : pieces_within(rectangle[0], 0))
      for (const auto& [j, v] : pieces_within(rectangle[1], 1))
        for (const std::size_t axis : {0, 1}) {
          const Vector_of_functions<3> tangent = part_of<3>(part_of<3>(piece(i, j).tangents[axis], 0, u), 1, v);
          for (std::size_t k = 0; k < tangent[0].coefficients().size(); ++k)
            result[axis].push_back({Number_traits<Exact_rational>::enclosure(tangent[0].coefficients()[k]),
                                    Number_traits<Exact_rational>::enclosure(tangent[1].coefficients()[k]),
                                    Number_traits<Exact_rational>::enclosure(tangent[2].coefficients()[k])});
        }
    return result;
  }

  const Piece& piece(std::size_t i, std::size_t j) const { return m_pieces[i * m_ranges[1].size() + j]; }

  // What a range has of the pieces along an axis: their indices, and parts of them.
  std::vector<std::pair<std::size_t, Parameter_range>> pieces_within(const Parameter_range& range, int axis) const
  {
    std::vector<Exact_rational> ways_back{0};
    if (m_periods[axis])
      ways_back.insert(ways_back.end(), {*m_periods[axis], Exact_rational(-*m_periods[axis])});
    std::vector<std::pair<std::size_t, Parameter_range>> result;
    for (const Exact_rational& back : ways_back)
      for (std::size_t i = 0; i < m_ranges[axis].size(); ++i) {
        const Parameter_range own = moved(range, back), &piece = m_ranges[axis][i],
                              common{(std::max)(own.first, piece.first), (std::min)(own.second, piece.second)};
        if (common.first < common.second)
          result.emplace_back(i, common);
      }
    return result;
  }

  static Cell hull_of(const Cell& a, const Cell& b)
  {
    Cell result;
    for (const int axis : {0, 1})
      result[axis] = {(std::min)(a[axis].first, b[axis].first), (std::max)(a[axis].second, b[axis].second)};
    return result;
  }

  static Parameter_box product(const Cell& first, const Cell& second)
  {
    return {first[0], first[1], second[0], second[1]};
  }

  static bool ends_at(const Parameter_range& range, const Exact_rational& value)
  {
    return range.first == value || range.second == value;
  }
  static bool meet(const Parameter_range& a, const Parameter_range& b)
  {
    return a.first <= b.second && b.first <= a.second;
  }

  static Parameter_range moved(const Parameter_range& range, const Exact_rational& shift)
  {
    return {Exact_rational(range.first + shift), Exact_rational(range.second + shift)};
  }
  static Cell moved(const Cell& cell, const Shift& shift)
  {
    return {moved(cell[0], shift[0]), moved(cell[1], shift[1])};
  }

  // Not in the middle, where symmetric surfaces have something special.
  static Exact_rational cut_of(const Parameter_range& range)
  {
    return Exact_rational(range.first + (range.second - range.first) * Exact_rational(15, 32));
  }

  static std::array<Cell, 2> halves(const Cell& cell, int axis)
  {
    std::array<Cell, 2> result{cell, cell};
    result[0][axis].second = result[1][axis].first = cut_of(cell[axis]);
    return result;
  }
};

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_CELL_PAIRS_H
