// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CELL_FUNCTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CELL_FUNCTIONS_H

#include <CGAL/Spline_constraints_d/operations/common/Surface_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

/*
k polynomials of two parameters on each cell of a grid, of the same degrees on all cells, which count up to a common
factor that is not zero: what is asked is where they vanish, or the direction of a vector. From one cell to the next
they may jump.
*/
template <std::size_t k>
class Cell_functions
{
  using Functions = std::array<Exact_function, k>;

  std::array<std::vector<Exact_rational>, 2> m_breaks;
  std::vector<Functions> m_cells; // row-major

public:
  // By a function of the part of a patch that lies over a cell.
  Cell_functions(const Spline_patch<3>& patch, const std::function<Functions(const Spline_patch<3>&)>& make)
    : m_breaks{patch.breaks(0), patch.breaks(1)}
  {
    for (std::size_t i = 0; i < size(0); ++i)
      for (std::size_t j = 0; j < size(1); ++j)
        m_cells.push_back(elevated(make(patch.part({range(0, i), range(1, j)}))));
  }

  // Those of all cells, in row-major order.
  Cell_functions(std::array<std::vector<Exact_rational>, 2> breaks, std::vector<Functions> cells)
    : m_breaks(std::move(breaks)), m_cells(std::move(cells))
  {
    std::vector<int> degrees(2, 0);
    for (const Functions& functions : m_cells)
      raise(degrees, functions);
    for (Functions& functions : m_cells)
      for (Exact_function& f : functions)
        f = f.elevated(degrees);
  }

  // One function of k others in each cell.
  template <class Make>
  Cell_functions<1> mapped(const Make& make) const
  {
    Cell_functions<1> result(m_breaks);
    for (const Functions& functions : m_cells)
      result.m_cells.push_back({make(functions)});
    return result;
  }

  std::size_t size(int axis) const { return m_breaks[axis].size() - 1; }
  const std::vector<Exact_rational>& breaks(int axis) const { return m_breaks[axis]; }
  Parameter_range domain(int axis) const { return {m_breaks[axis].front(), m_breaks[axis].back()}; }

  // The cells of an axis from the first one to that before the last one.
  Cell_functions part(int axis, std::size_t first, std::size_t last) const
  {
    Cell_functions result(m_breaks);
    result.m_breaks[axis] = {m_breaks[axis].begin() + first, m_breaks[axis].begin() + last + 1};
    const std::array<std::size_t, 2> begin{axis == 0 ? first : 0, axis == 1 ? first : 0};
    for (std::size_t i = 0; i < result.size(0); ++i)
      for (std::size_t j = 0; j < result.size(1); ++j)
        result.m_cells.push_back(cell(begin[0] + i, begin[1] + j));
    return result;
  }

  // Whether they are zero on the whole of the first cell of all.
  bool is_zero() const { return vanish(m_cells.front()); }

  // Whether there is a cell in a strip of cells, all those with one index along an axis, on which they are zero.
  bool has_zero_cell(int axis, std::size_t strip) const
  {
    const std::vector<std::size_t> cells = cells_of(axis, strip);
    return std::any_of(cells.begin(), cells.end(), [&](std::size_t c) { return vanish(m_cells[c]); });
  }

  // Divides the functions on a strip by a factor that vanishes on the line at one of its sides only, and is one on the
  // other side, if they vanish on that line.
  bool divide_out(int axis, std::size_t strip, int side)
  {
    const std::vector<std::size_t> cells = cells_of(axis, strip);
    if (has_zero_cell(axis, strip) ||
        !std::all_of(cells.begin(), cells.end(), [&](std::size_t c) { return vanish_on(m_cells[c], axis, side); }))
      return false;
    for (const std::size_t c : cells)
      for (Exact_function& f : m_cells[c])
        f = divided(f, axis, side);
    return true;
  }

  // The factor by which the functions at the begin of a strip differ from those at the end of another one all along the
  // line, if there is one.
  std::optional<Exact_rational> ratio(int axis, std::size_t before, std::size_t after) const
  {
    std::optional<Exact_rational> result;
    if (has_zero_cell(axis, before) || has_zero_cell(axis, after))
      return result;
    const std::vector<std::size_t> first = cells_of(axis, before), second = cells_of(axis, after);
    for (std::size_t other = 0; other < first.size(); ++other)
      for (std::size_t f = 0; f < k; ++f) {
        const std::vector<Exact_rational> end = m_cells[first[other]][f].face(axis, 1).coefficients(),
                                          begin = m_cells[second[other]][f].face(axis, 0).coefficients();
        for (std::size_t i = 0; i < end.size(); ++i) {
          if (end[i] == 0 && begin[i] == 0)
            continue;
          if (end[i] == 0 || begin[i] == 0 || (result && end[i] != *result * begin[i]))
            return std::nullopt;
          result = Exact_rational(end[i] / begin[i]);
        }
      }
    return result;
  }

  void multiply(int axis, std::size_t strip, const Exact_rational& factor)
  {
    for (const std::size_t c : cells_of(axis, strip))
      for (Exact_function& f : m_cells[c])
        f = f * factor;
  }

  // Of one function, of the degrees of the highest one, in row-major order.
  std::vector<Bernstein_tensor<Exact_rational>> pieces(std::size_t f) const
  {
    const std::vector<int> degrees = common_degrees();
    std::vector<Bernstein_tensor<Exact_rational>> result;
    for (const Functions& functions : m_cells)
      result.push_back(functions[f].elevated(degrees).bezier_pieces().front());
    return result;
  }

  // As splines, which have no breaks along an axis where they are constant. \pre They do not jump.
  Functions splines() const
  {
    Break_grid<Exact_rational> grid(2);
    const std::vector<int> degrees = common_degrees();
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const Exact_rational& value : m_breaks[axis])
        grid[axis].push_back({value, degrees[axis]});
    Functions result;
    for (std::size_t f = 0; f < k; ++f) {
      auto [axes, coefficients] = assembled_cells(degrees, grid, pieces(f));
      result[f] = Exact_function(degrees, {*axes[0].knots, *axes[1].knots}, std::move(coefficients));
    }
    return result;
  }

private:
  template <std::size_t>
  friend class Cell_functions;

  explicit Cell_functions(std::array<std::vector<Exact_rational>, 2> breaks) : m_breaks(std::move(breaks)) {}

  Parameter_range range(int axis, std::size_t i) const { return {m_breaks[axis][i], m_breaks[axis][i + 1]}; }
  const Functions& cell(std::size_t i, std::size_t j) const { return m_cells[i * size(1) + j]; }

  // Indices of the cells of a strip.
  std::vector<std::size_t> cells_of(int axis, std::size_t strip) const
  {
    std::vector<std::size_t> result;
    for (std::size_t other = 0; other < size(1 - axis); ++other)
      result.push_back(axis == 0 ? strip * size(1) + other : other * size(1) + strip);
    return result;
  }

  std::vector<int> common_degrees() const
  {
    std::vector<int> result(2, 0);
    for (const Functions& functions : m_cells)
      raise(result, functions);
    return result;
  }

  // All of the degrees of the highest one.
  static Functions elevated(Functions functions)
  {
    std::vector<int> degrees(2, 0);
    raise(degrees, functions);
    for (Exact_function& f : functions)
      f = f.elevated(degrees);
    return functions;
  }

  // To those of functions, where these are higher.
  static void raise(std::vector<int>& degrees, const Functions& functions)
  {
    for (const Exact_function& f : functions)
      for (int axis = 0; axis < 2; ++axis)
        degrees[axis] = (std::max)(degrees[axis], f.degree(axis));
  }

  static bool is_zero(const Exact_function& f)
  {
    return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                       [](const Exact_rational& x) { return x == 0; });
  }

  static bool vanish(const Functions& functions)
  {
    return std::all_of(functions.begin(), functions.end(), [](const Exact_function& f) { return is_zero(f); });
  }

  static bool vanish_on(const Functions& functions, int axis, int side)
  {
    return std::all_of(functions.begin(), functions.end(),
                       [&](const Exact_function& f) { return is_zero(f.face(axis, side)); });
  }

  // By the distance from a side, with the width of the cell as the unit: t B_{i-1}^{n-1}(t) = (i/n) B_i^n(t).
  static Exact_function divided(const Exact_function& f, int axis, int side)
  {
    std::vector<int> degrees = f.degrees();
    const int n = degrees[axis]--;
    const std::size_t columns = f.size(1);
    std::vector<Exact_rational> coefficients;
    for (std::size_t i = 0; i < f.size(0); ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const int index = static_cast<int>(axis == 0 ? i : j), factor = side == 0 ? index : n - index;
        if (factor > 0)
          coefficients.push_back(Exact_rational(f.coefficients()[i * columns + j] * n / factor));
      }
    std::vector<std::vector<Exact_rational>> knots{f.knots(0), f.knots(1)};
    knots[axis] = {knots[axis].begin() + 1, knots[axis].end() - 1};
    return Exact_function(degrees, std::move(knots), std::move(coefficients));
  }
};

// A part of a grid, over which functions are continuous after division by known factors.
template <std::size_t k>
struct Continuous_part
{
  Cell_functions<k> functions;
  std::vector<Constant_parameter> lines; // where the factors vanish
};

/*
Divides functions by factors that vanish on a line of the grid, and multiplies them by constants on strips of cells,
such that they become continuous. Where constants will not do, the grid is cut, and cells on which all functions are
zero are parts of their own.
*/
template <std::size_t k>
std::vector<Continuous_part<k>> continuous_parts(const Cell_functions<k>& functions, bool keeps_sign)
{
  Continuous_part<k> part{functions, {}};
  Cell_functions<k>& own = part.functions;
  for (int axis = 0; axis < 2; ++axis)
    for (std::size_t strip = 0; strip < own.size(axis); ++strip)
      for (const int side : {0, 1})
        while (own.divide_out(axis, strip, side))
          part.lines.push_back({axis, own.breaks(axis)[strip + side]});
  for (int axis = 0; axis < 2; ++axis)
    for (std::size_t strip = 1; strip < own.size(axis); ++strip) {
      const std::optional<Exact_rational> factor = own.ratio(axis, strip - 1, strip);
      if (factor && (!keeps_sign || *factor > 0)) {
        own.multiply(axis, strip, *factor);
        continue;
      }
      std::vector<Continuous_part<k>> result = continuous_parts(functions.part(axis, 0, strip), keeps_sign),
                                      others =
                                          continuous_parts(functions.part(axis, strip, own.size(axis)), keeps_sign);
      std::move(others.begin(), others.end(), std::back_inserter(result));
      return result;
    }
  return {std::move(part)};
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CELL_FUNCTIONS_H
