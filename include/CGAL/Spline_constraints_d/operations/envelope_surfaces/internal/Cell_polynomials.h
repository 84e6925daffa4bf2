// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_CELL_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_CELL_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// The breaks of each unknown, both ends of its range included.
using Cell_breaks = std::vector<std::vector<Exact_rational>>;

/*
A polynomial of some unknowns on each cell of a grid, in Bernstein form. Sums and products are those of the cells, so
nothing is assumed about what happens between them.
*/
class Cell_polynomials
{
  using Tensor = Bernstein_tensor<Exact_rational>;

  std::shared_ptr<const Cell_breaks> m_breaks;
  std::vector<Tensor> m_cells; // row-major

public:
  // A spline of the unknowns with the indices `axes`; its breaks are among those of the grid.
  Cell_polynomials(std::shared_ptr<const Cell_breaks> breaks, const Exact_function& f, const std::vector<int>& axes)
    : m_breaks(std::move(breaks))
  {
    std::map<std::vector<int>, Tensor> known; // by the indices along the axes of the spline
    visit_cells([&](const std::vector<int>& cell) {
      std::vector<int> own;
      for (const int axis : axes)
        own.push_back(cell[static_cast<std::size_t>(axis)]);
      const auto [entry, is_new] = known.try_emplace(own);
      if (is_new) {
        Exact_function part = f;
        for (std::size_t j = 0; j < axes.size(); ++j) {
          const std::vector<Exact_rational>& ends = (*m_breaks)[static_cast<std::size_t>(axes[j])];
          part = part_of(part, static_cast<int>(j),
                         {ends[static_cast<std::size_t>(own[j])], ends[static_cast<std::size_t>(own[j]) + 1]});
        }
        entry->second = part.bezier_pieces().front().embedded(static_cast<int>(m_breaks->size()), axes);
      }
      m_cells.push_back(entry->second);
    });
  }

  // Polynomials of one unknown, one for each range between its neighbouring breaks.
  Cell_polynomials(std::shared_ptr<const Cell_breaks> breaks, const std::vector<Tensor>& pieces, int axis)
    : m_breaks(std::move(breaks))
  {
    visit_cells([&](const std::vector<int>& cell) {
      m_cells.push_back(pieces[static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)])].embedded(
          static_cast<int>(m_breaks->size()), {axis}));
    });
  }

  const Cell_breaks& breaks() const { return *m_breaks; }
  const std::vector<Tensor>& cells() const { return m_cells; }

  friend Cell_polynomials operator+(Cell_polynomials a, const Cell_polynomials& b)
  {
    return combined(std::move(a), b, [](Tensor& x, const Tensor& y) { x += y; });
  }
  friend Cell_polynomials operator-(Cell_polynomials a, const Cell_polynomials& b)
  {
    return combined(std::move(a), b, [](Tensor& x, const Tensor& y) { x -= y; });
  }
  friend Cell_polynomials operator*(Cell_polynomials a, const Cell_polynomials& b)
  {
    return combined(std::move(a), b, [](Tensor& x, const Tensor& y) { x *= y; });
  }

  // By an unknown.
  Cell_polynomials derivative(int axis) const
  {
    Cell_polynomials result(*this);
    const std::vector<Exact_rational>& ends = (*m_breaks)[static_cast<std::size_t>(axis)];
    std::size_t c = 0;
    visit_cells([&](const std::vector<int>& cell) {
      const auto i = static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)]);
      result.m_cells[c] = m_cells[c].derivative(axis) * Exact_rational(1 / Exact_rational(ends[i + 1] - ends[i]));
      ++c;
    });
    return result;
  }

  bool is_zero() const
  {
    return std::all_of(m_cells.begin(), m_cells.end(), [](const Tensor& cell) { return is_zero(cell); });
  }

  // Number of the last break of an unknown.
  std::size_t last_break(int axis) const { return (*m_breaks)[static_cast<std::size_t>(axis)].size() - 1; }

  // Whether it is zero on the plane where an unknown has the value of a break, in all cells on both sides.
  bool is_zero_on(int axis, std::size_t place) const
  {
    bool result = true;
    visit_sides(axis, place, [&](std::size_t c, int side) { result = result && is_zero(m_cells[c].face(axis, side)); });
    return result;
  }

  // Whether it is the same on both sides of a break.
  bool is_continuous_at(int axis, std::size_t place) const
  {
    std::vector<Tensor> before, after;
    visit_sides(axis, place,
                [&](std::size_t c, int side) { (side == 1 ? before : after).push_back(m_cells[c].face(axis, side)); });
    return before.empty() || after.empty() || before == after;
  }

  // Divided by a factor that is zero on the plane of a break, linear up to the next ones, and constant beyond. It has
  // two signs where there are cells on both sides. \pre the function is zero there
  Cell_polynomials divided_at(int axis, std::size_t place) const
  {
    Cell_polynomials result(*this);
    visit_sides(axis, place, [&](std::size_t c, int side) { result.m_cells[c] = divided(m_cells[c], axis, side); });
    if (place == 0 || place == last_break(axis))
      return result;
    const std::vector<Exact_rational>& ends = (*m_breaks)[static_cast<std::size_t>(axis)];
    const Exact_rational ratio = (ends[place] - ends[place + 1]) / Exact_rational(ends[place] - ends[place - 1]);
    std::size_t c = 0;
    visit_cells([&](const std::vector<int>& cell) {
      if (static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)]) < place)
        result.m_cells[c] *= ratio;
      ++c;
    });
    return result;
  }

  // Divided by a function of one unknown as often as that is a factor on all cells. \pre it has no zeros
  Cell_polynomials without_factor(const Exact_function& factor, int axis) const
  {
    const std::vector<Exact_rational>& ends = (*m_breaks)[static_cast<std::size_t>(axis)];
    std::vector<std::vector<Exact_rational>> divisors; // in powers
    for (std::size_t i = 1; i < ends.size(); ++i) {
      divisors.push_back(part_of(factor, 0, {ends[i - 1], ends[i]}).bezier_pieces().front().power_coefficients());
      while (divisors.back().size() > 1 && divisors.back().back() == 0)
        divisors.back().pop_back();
    }
    if (std::all_of(divisors.begin(), divisors.end(), [](const auto& divisor) { return divisor.size() == 1; }))
      return *this;
    Cell_polynomials result(*this);
    while (!result.is_zero()) {
      std::vector<Tensor> quotients;
      bool is_factor = true;
      visit_cells([&](const std::vector<int>& cell) {
        if (!is_factor)
          return;
        auto own = quotient(result.m_cells[quotients.size()], axis,
                            divisors[static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)])]);
        is_factor = own.has_value();
        if (own)
          quotients.push_back(std::move(*own));
      });
      if (!is_factor)
        break;
      result.m_cells = std::move(quotients);
    }
    return result;
  }

  // Without factors of the weight of a surface in the first two unknowns, if it is a product of functions of one.
  Cell_polynomials without_weights(const Spline_patch<3>& surface) const
  {
    const Exact_function& weight = surface.weight();
    if (!surface.is_rational())
      return *this;
    const std::array<Exact_function, 2> sides{weight.face(1, 0), weight.face(0, 0)};
    const std::vector<Parameter_range> square{surface.domain(0), surface.domain(1)};
    if (!(sides[0].embedded(square, {0}) * sides[1].embedded(square, {1}) == weight * weight(surface.first_corner())))
      return *this;
    return without_factor(sides[0], 0).without_factor(sides[1], 1);
  }

  // The sign on a cell of the plane of a break where it has one by its coefficients; 1 if there is no such cell.
  int sign_on(int axis, const Exact_rational& value) const
  {
    const std::vector<Exact_rational>& ends = (*m_breaks)[static_cast<std::size_t>(axis)];
    const auto place = static_cast<std::size_t>(std::find(ends.begin(), ends.end(), value) - ends.begin());
    int result = 0;
    visit_sides(axis, place, [&](std::size_t c, int side) {
      const Tensor face = m_cells[c].face(axis, side);
      for (const Exact_rational& x : face.coefficients())
        if (result == 0 && is_one_sided(face))
          result = x > 0 ? 1 : x < 0 ? -1 : 0;
    });
    return result == 0 ? 1 : result;
  }

  // Of three unknowns, the first two on a line where one of them has its first or last value, and the third one at a
  // place of its first range that runs from 0 to 1: polynomials of the other one between its breaks.
  std::vector<Tensor> on_line(int axis, std::size_t end, const Exact_rational& place) const
  {
    std::vector<Tensor> result;
    std::vector<std::vector<int>> cells;
    visit_cells([&](const std::vector<int>& cell) { cells.push_back(cell); });
    visit_sides(axis, end, [&](std::size_t c, int side) {
      if (cells[c][2] == 0)
        result.push_back(m_cells[c].split(2, place).first.face(2, 1).face(axis, side));
    });
    return result;
  }

  // Times a positive number, so that the greatest coefficient is one.
  Cell_polynomials normalized() const
  {
    Exact_rational most(0);
    for (const Tensor& cell : m_cells)
      for (const Exact_rational& x : cell.coefficients())
        most = (std::max)(most, Exact_rational(abs(x)));
    Cell_polynomials result(*this);
    for (Tensor& cell : result.m_cells)
      if (most > 0)
        cell *= Exact_rational(1 / most);
    return result;
  }

  Spline_function function() const
  {
    std::vector<int> unknowns(m_breaks->size());
    std::iota(unknowns.begin(), unknowns.end(), 0);
    return Spline_function::from_bezier_pieces(std::move(unknowns), *m_breaks, m_cells);
  }

private:
  template <class Visit>
  void visit_cells(const Visit& visit) const
  {
    std::vector<int> last;
    for (const std::vector<Exact_rational>& ends : *m_breaks)
      last.push_back(static_cast<int>(ends.size()) - 2);
    for_each_index(last, visit);
  }

  // Calls `visit(index, side)` for the cells at a break, with the side of the cell that this is.
  template <class Visit>
  void visit_sides(int axis, std::size_t place, const Visit& visit) const
  {
    std::size_t c = 0;
    visit_cells([&](const std::vector<int>& cell) {
      const auto own = static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)]);
      if (own == place || own + 1 == place)
        visit(c, own == place ? 0 : 1);
      ++c;
    });
  }

  template <class Combine>
  static Cell_polynomials combined(Cell_polynomials a, const Cell_polynomials& b, const Combine& combine)
  {
    for (std::size_t c = 0; c < a.m_cells.size(); ++c)
      combine(a.m_cells[c], b.m_cells[c]);
    return a;
  }

  static bool is_zero(const Tensor& f)
  {
    return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                       [](const Exact_rational& x) { return x == 0; });
  }

  // By a polynomial of one unknown in powers, the last one not zero, if there is no remainder.
  static std::optional<Tensor> quotient(const Tensor& f, int axis, const std::vector<Exact_rational>& divisor)
  {
    const auto place = static_cast<std::size_t>(axis);
    std::vector<int> degrees = f.degrees();
    const std::size_t length = static_cast<std::size_t>(degrees[place]) + 1, order = divisor.size() - 1;
    std::size_t stride = 1;
    for (std::size_t j = place + 1; j < degrees.size(); ++j)
      stride *= static_cast<std::size_t>(degrees[j]) + 1;
    std::vector<Exact_rational> powers = f.power_coefficients();
    const std::size_t kept = length > order ? length - order : 1;
    std::vector<Exact_rational> result(powers.size() / length * kept, Exact_rational(0));
    for (std::size_t row = 0; row < powers.size() / length; ++row) {
      const std::size_t outer = row / stride, inner = row % stride;
      const auto own = [&](std::size_t k) -> Exact_rational& { return powers[(outer * length + k) * stride + inner]; };
      for (std::size_t k = length; k-- > order;) {
        const Exact_rational factor = own(k) / divisor.back();
        for (std::size_t m = 0; m <= order && factor != 0; ++m)
          own(k - order + m) -= factor * divisor[m];
        result[(outer * kept + (k - order)) * stride + inner] = factor;
      }
      for (std::size_t k = 0; k < (std::min)(order, length); ++k)
        if (own(k) != 0)
          return std::nullopt;
    }
    degrees[place] = static_cast<int>(kept) - 1;
    return Tensor::from_power(std::move(degrees), std::move(result));
  }

  // Whether no two coefficients have different signs.
  static bool is_one_sided(const Tensor& f)
  {
    const auto [least, most] = f.bounds();
    return !(least < 0 && most > 0);
  }

  // t B_{i-1}^{n-1}(t) = (i/n) B_i^n(t).
  static Tensor divided(const Tensor& f, int axis, int side)
  {
    if (is_zero(f))
      return f;
    std::vector<int> degrees = f.degrees();
    const auto place = static_cast<std::size_t>(axis);
    const int n = degrees[place]--;
    std::size_t stride = 1;
    for (std::size_t j = place + 1; j < degrees.size(); ++j)
      stride *= static_cast<std::size_t>(degrees[j]) + 1;
    std::vector<Exact_rational> coefficients;
    for (std::size_t k = 0; k < f.coefficients().size(); ++k) {
      const int index = static_cast<int>(k / stride % (static_cast<std::size_t>(n) + 1)),
                factor = side == 0 ? index : n - index;
      if (factor > 0)
        coefficients.push_back(Exact_rational(f.coefficients()[k] * n / factor));
    }
    return Tensor(std::move(degrees), std::move(coefficients));
  }
};

using Cell_vector = std::array<Cell_polynomials, 3>;

inline Cell_polynomials determinant(const Cell_vector& a, const Cell_vector& b, const Cell_vector& c)
{
  const auto minor = [&](std::size_t i, std::size_t k) { return a[i] * b[k] - a[k] * b[i]; };
  return minor(1, 2) * c[0] + minor(2, 0) * c[1] + minor(0, 1) * c[2];
}

// Three functions of the first two unknowns.
inline Cell_vector cell_vector(const Vector_of_functions<3>& x, const std::shared_ptr<const Cell_breaks>& breaks)
{
  const auto coordinate = [&](std::size_t i) { return Cell_polynomials(breaks, x[i], {0, 1}); };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

inline Cell_vector derivative(const Cell_vector& x, int axis)
{
  return {x[0].derivative(axis), x[1].derivative(axis), x[2].derivative(axis)};
}

// The derivative of a surface X / s, whose parameters are the first two unknowns, times s^2.
inline Cell_vector scaled_tangent(const Spline_patch<3>& surface, const std::shared_ptr<const Cell_breaks>& breaks,
                                  int axis)
{
  const Cell_vector x = cell_vector(surface.numerators(), breaks);
  if (!surface.is_rational())
    return derivative(x, axis);
  const Cell_polynomials s(breaks, surface.weight(), {0, 1}), slope = s.derivative(axis);
  const auto coordinate = [&](std::size_t i) { return x[i].derivative(axis) * s - x[i] * slope; };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_CELL_POLYNOMIALS_H
