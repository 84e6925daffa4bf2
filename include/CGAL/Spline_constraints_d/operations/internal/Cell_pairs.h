// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CELL_PAIRS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CELL_PAIRS_H

#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>
#include <CGAL/Spline_constraints_d/operations/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_patch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Whether n x S_u x S_v is positive for some n and all derivatives within their bounds, on a rectangle that is the union of parts of a surface. Then S(P) = S(Q) for no P != Q: the difference is (u - s) x + (v - t) y, where x
and y are means of the derivatives, which have the same bounds.
*/
inline bool is_one_to_one(const std::vector<Spline_patch<3>>& parts)
{
  const auto tangents = [&](int axis) {
    Vector_bounds<3> result = parts.front().tangents(axis);
    for (std::size_t k = 1; k < parts.size(); ++k) {
      const Vector_bounds<3> other = parts[k].tangents(axis);
      for (std::size_t i = 0; i < 3; ++i)
        result[i] = hull(result[i], other[i]);
    }
    return result;
  };
  const auto middle = [](const Vector_bounds<3>& x) { return Exact_vector<3>{middle_of({x[0].lower, x[0].upper}), middle_of({x[1].lower, x[1].upper}), middle_of({x[2].lower, x[2].upper})}; };
  const Vector_bounds<3> x = tangents(0), y = tangents(1);
  const Exact_vector<3> n = exact_cross(middle(x), middle(y));
  const Vector_bounds<3> normal{Rational_interval(n[0]), Rational_interval(n[1]), Rational_interval(n[2])}, across{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  return dot(normal, across).lower > 0;
}

/*
The unordered pairs P != Q of points of the domain of a surface with S(P) = S(Q) lie in products of two cells each, all within polynomial pieces: of one cell with itself, of two that are apart, and of two near each other
for which nothing is known. All other pairs are proved to have different points:

Two cells with a common edge or corner are halved until they are apart, or the surface is one-to-one on the rectangle around both of them; so on both sides of a break only pairs of distant points are left. The ends of a
closed parameter are an edge in common as well. In cells that have the same pole, an edge that is one point, all pairs on it have the same point; what is near it, they have in common too.
*/
class Cell_pairs
{
  using Cell = std::array<Parameter_range, 2>;
  using Shift = std::array<Exact_rational, 2>;   // of the second cell, by periods of closed parameters, that brings it next to the first one

  static constexpr int most_halvings = 10;

  Spline_patch<3> m_patch;
  std::array<std::optional<Exact_rational>, 2> m_periods;
  std::vector<std::pair<int, Exact_rational>> m_poles;   // axis and parameter
  std::vector<Parameter_box> m_apart, m_undecided;
  std::vector<Spline_patch<3>> m_single;

public:
  explicit Cell_pairs(const Spline_patch<3>& patch) : m_patch(patch)
  {
    for (const int axis : {0, 1}) {
      const auto [begin, end] = patch.domain(axis);
      if (patch.is_closed(axis))
        m_periods[axis] = Exact_rational(end - begin);
      for (const Exact_rational& value : {begin, end})
        if (patch.part(axis, {value, value}).is_one_point())
          m_poles.emplace_back(axis, value);
    }
    std::vector<Cell> cells;
    for (const Parameter_range& u : ranges(0))
      for (const Parameter_range& v : ranges(1))
        cells.push_back({u, v});
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
  // The pieces along an axis. Of a closed one at least three, so that two of them are neighbours in one way only; the places of further cuts are simple, but none where a symmetric surface has something special.
  std::vector<Parameter_range> ranges(int axis) const
  {
    std::vector<Parameter_range> result;
    const std::vector<Exact_rational> breaks = m_patch.breaks(axis);
    for (std::size_t i = 1; i < breaks.size(); ++i)
      result.emplace_back(breaks[i - 1], breaks[i]);
    while (m_periods[axis] && result.size() < 3) {
      const Parameter_range last = result.back();
      const Exact_rational cut(last.first + (last.second - last.first) * Exact_rational(3, 7));
      result.back().second = cut;
      result.emplace_back(cut, last.second);
    }
    return result;
  }

  void add(const Cell& cell, int halvings)
  {
    if (is_one_to_one({part(cell)}))
      return;
    const std::optional<int> axis = axis_of_common_pole(cell, cell);
    if (!axis)
      m_single.push_back(part(cell));
    else if (halvings == 0)
      m_undecided.push_back(product(cell, cell));
    else {
      const auto [a, b] = halves(cell, *axis);
      add(a, halvings - 1);
      add(b, halvings - 1);
      add(a, b, {}, halvings - 1);
    }
  }

  void add(const Cell& first, const Cell& second, const Shift& shift, int halvings)
  {
    if (have_distant_points(first, second))
      return;
    if (!are_neighbours(first, second, shift))
      m_apart.push_back(product(first, second));
    else if (is_one_to_one(rectangle_around(first, moved(second, shift))))
      return;
    else if (halvings == 0)
      m_undecided.push_back(product(first, second));
    else
      add_halves(first, second, shift, halvings);
  }

  void add_halves(const Cell& first, const Cell& second, const Shift& shift, int halvings)
  {
    const int axis = axis_of_common_pole(first, second).value_or(halvings % 2);
    for (const Cell& half : halves(first, axis))
      if (are_neighbours(half, second, shift))
        for (const Cell& other : halves(second, axis))
          add(half, other, shift, halvings - 1);
      else
        add(half, second, shift, halvings - 1);
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

  Spline_patch<3> part(const Cell& cell) const { return m_patch.part({cell[0], cell[1]}); }

  // The parts of the surface over the rectangle around two cells, which may go on across seams.
  std::vector<Spline_patch<3>> rectangle_around(const Cell& a, const Cell& b) const
  {
    std::array<std::vector<Parameter_range>, 2> pieces;
    for (const int axis : {0, 1}) {
      const Parameter_range whole{(std::min)(a[axis].first, b[axis].first), (std::max)(a[axis].second, b[axis].second)}, domain = m_patch.domain(axis);
      std::vector<Exact_rational> ways_back{0};
      if (m_periods[axis])
        ways_back.insert(ways_back.end(), {*m_periods[axis], Exact_rational(-*m_periods[axis])});
      for (const Exact_rational& back : ways_back) {
        const Parameter_range own = moved(whole, back), piece{(std::max)(own.first, domain.first), (std::min)(own.second, domain.second)};
        if (piece.first < piece.second)
          pieces[axis].push_back(piece);
      }
    }
    std::vector<Spline_patch<3>> result;
    for (const Parameter_range& u : pieces[0])
      for (const Parameter_range& v : pieces[1])
        result.push_back(part({u, v}));
    return result;
  }

  static Parameter_box product(const Cell& first, const Cell& second) { return {first[0], first[1], second[0], second[1]}; }

  static bool ends_at(const Parameter_range& range, const Exact_rational& value) { return range.first == value || range.second == value; }
  static bool meet(const Parameter_range& a, const Parameter_range& b) { return a.first <= b.second && b.first <= a.second; }

  static Parameter_range moved(const Parameter_range& range, const Exact_rational& shift) { return {Exact_rational(range.first + shift), Exact_rational(range.second + shift)}; }
  static Cell moved(const Cell& cell, const Shift& shift) { return {moved(cell[0], shift[0]), moved(cell[1], shift[1])}; }

  static std::array<Cell, 2> halves(const Cell& cell, int axis)
  {
    std::array<Cell, 2> result{cell, cell};
    result[0][axis].second = result[1][axis].first = middle_of(cell[axis]);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CELL_PAIRS_H
