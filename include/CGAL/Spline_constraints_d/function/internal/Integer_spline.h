// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_SPLINE_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/bernstein_product.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Breaks_of_axis = std::vector<Exact_rational>;

inline std::size_t cells_between(const Breaks_of_axis& breaks) { return breaks.empty() ? 1 : breaks.size() - 1; }

Breaks_of_axis united(const Breaks_of_axis& a, const Breaks_of_axis& b);

// The cell that begins at or before a number; the first or last one beyond the breaks.
std::size_t cell_at(const Breaks_of_axis& breaks, const Exact_rational& x);

/*
A piecewise polynomial in power form with integer coefficients: cells, and the coefficients of each, in row-major order,
last axis fastest; no breaks on an axis: one polynomial everywhere. Since the powers are those of the parameters
themselves, pieces keep their coefficients when breaks are added.
*/
template <class Integer>
struct Integer_pieces
{
  std::vector<int> degrees;
  std::vector<Breaks_of_axis> breaks;
  std::vector<std::vector<Integer>> pieces;

  std::vector<int> last_cells() const
  {
    std::vector<int> result;
    for (const Breaks_of_axis& axis : breaks)
      result.push_back(static_cast<int>(cells_between(axis)) - 1);
    return result;
  }

  // Lowers degrees whose leading coefficients vanish in all pieces, and removes breaks between equal pieces.
  void simplify()
  {
    for (std::size_t j = 0; j < degrees.size(); ++j) {
      lower_degree(j);
      for (std::size_t k = cells_between(breaks[j]); k-- > 1;)
        remove_break(j, k);
    }
  }

  // Removes the axes that nothing depends on, and returns the others.
  std::vector<int> remove_trivial_axes()
  {
    std::vector<int> kept, kept_degrees;
    std::vector<Breaks_of_axis> kept_breaks;
    for (std::size_t j = 0; j < degrees.size(); ++j)
      if (degrees[j] > 0 || breaks[j].size() > 2) {
        kept.push_back(static_cast<int>(j));
        kept_degrees.push_back(degrees[j]);
        kept_breaks.push_back(std::move(breaks[j]));
      }
    degrees = std::move(kept_degrees);
    breaks = std::move(kept_breaks);
    return kept;
  }

private:
  void lower_degree(std::size_t axis)
  {
    const Axis_view view = axis_view(degrees, axis);
    int degree = view.degree;
    const auto is_zero_layer = [&](const std::vector<Integer>& piece) {
      for (std::size_t o = 0; o < view.outer; ++o)
        for (std::size_t i = 0; i < view.inner; ++i)
          if (piece[(o * (view.degree + 1) + degree) * view.inner + i] != 0)
            return false;
      return true;
    };
    while (degree > 0 && std::all_of(pieces.begin(), pieces.end(), is_zero_layer))
      --degree;
    if (degree == view.degree)
      return;
    for (std::vector<Integer>& piece : pieces) {
      std::vector<Integer> lower;
      for (std::size_t o = 0; o < view.outer; ++o) {
        const auto first = piece.begin() + o * (view.degree + 1) * view.inner;
        lower.insert(lower.end(), first, first + (degree + 1) * view.inner);
      }
      piece = std::move(lower);
    }
    degrees[axis] = degree;
  }

  void remove_break(std::size_t axis, std::size_t k)
  {
    const Axis_view view = axis_view(last_cells(), axis);
    const std::size_t cells = static_cast<std::size_t>(view.degree) + 1;
    const auto at = [&](std::size_t o, std::size_t cell, std::size_t i) { return (o * cells + cell) * view.inner + i; };
    for (std::size_t o = 0; o < view.outer; ++o)
      for (std::size_t i = 0; i < view.inner; ++i)
        if (pieces[at(o, k - 1, i)] != pieces[at(o, k, i)])
          return;
    std::vector<std::vector<Integer>> fewer;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      if (p / view.inner % cells != k)
        fewer.push_back(std::move(pieces[p]));
    pieces = std::move(fewer);
    breaks[axis].erase(breaks[axis].begin() + k);
  }
};

// Horner's scheme along an axis of a tensor of coefficients of powers.
template <class NT>
std::vector<NT> contracted(const std::vector<NT>& values, const Axis_view& view, const NT& x)
{
  std::vector<NT> result;
  for (std::size_t o = 0; o < view.outer; ++o)
    for (std::size_t i = 0; i < view.inner; ++i) {
      NT sum(Exact_rational(0));
      for (int k = view.degree; k >= 0; --k)
        sum = sum * x + values[(o * (view.degree + 1) + k) * view.inner + i];
      result.push_back(sum);
    }
  return result;
}

// The value of a tensor of coefficients of powers.
template <class NT>
NT tensor_value(const std::vector<Exact_rational>& coefficients, const std::vector<int>& degrees,
                std::span<const NT> point)
{
  std::vector<NT> values;
  for (const Exact_rational& coefficient : coefficients)
    values.push_back(NT(coefficient));
  for (std::size_t j = point.size(); j-- > 0;)
    values = contracted(values, axis_view({degrees.begin(), degrees.begin() + j + 1}, j), point[j]);
  return values[0];
}

/*
An exact spline over one common denominator, as formulas use it: operations are convolutions of integers. Continuous
unless said otherwise.
*/
class Integer_spline
{
  Integer_pieces<Big_integer> m_pieces;
  Big_integer m_denominator = 1;

public:
  Integer_spline(Integer_pieces<Big_integer> pieces, Big_integer denominator)
    : m_pieces(std::move(pieces)), m_denominator(std::move(denominator))
  {
    m_pieces.simplify();
  }

  explicit Integer_spline(const Bspline_function<Exact_rational>& function);

  int dimension() const { return static_cast<int>(m_pieces.degrees.size()); }
  const std::vector<int>& degrees() const { return m_pieces.degrees; }
  const std::vector<Breaks_of_axis>& breaks() const { return m_pieces.breaks; }
  const std::vector<std::vector<Big_integer>>& pieces() const { return m_pieces.pieces; }
  const Big_integer& denominator() const { return m_denominator; }

  bool is_constant() const { return m_pieces.pieces.size() == 1 && m_pieces.pieces[0].size() == 1; }
  Exact_rational constant() const { return quotient(m_pieces.pieces[0][0], m_denominator); }

  friend bool operator==(const Integer_spline& a, const Integer_spline& b)
  {
    return a.m_denominator == b.m_denominator && a.degrees() == b.degrees() && a.breaks() == b.breaks() &&
        a.pieces() == b.pieces();
  }

  // The axes that the spline depends on, and the spline of these.
  std::pair<std::vector<int>, Integer_spline> without_trivial_axes() const;

  // On a part of the domain of an axis. Where the part is a single point, on the cell that holds it.
  Integer_spline restricted(int axis, const Exact_rational& begin, const Exact_rational& end) const;

  // On the face where an axis has a value, as a function that is constant along it.
  Integer_spline face(int axis, const Exact_rational& value) const;

  Integer_spline operator-() const;

  // The piece of a cell of finer breaks.
  const std::vector<Big_integer>& piece_on(const std::vector<Breaks_of_axis>& finer,
                                           const std::vector<int>& cell) const;

  // The derivative of the pieces, which need not be continuous.
  Integer_spline piecewise_derivative(int axis) const;

  // On the same domain, piece by piece.
  friend Integer_spline operator*(const Integer_spline& a, const Integer_spline& b);

  // a - factor b, on the same domain, piece by piece.
  static Integer_spline difference(const Integer_spline& a, const Integer_spline& b, int factor);

  // The value at a point of the domain.
  Exact_rational operator()(std::span<const Exact_rational> point) const { return value(point, point); }

  // The value, with the numbers of a ring that rationals convert to, of the piece that a place is in.
  template <class NT>
  NT value(std::span<const Exact_rational> place, std::span<const NT> point) const
  {
    std::size_t index = 0;
    for (int j = 0; j < dimension(); ++j)
      index = index * cells_between(breaks()[j]) + cell_at(breaks()[j], place[j]);
    return tensor_value(rational(index), degrees(), point) * NT(Exact_rational(1 / scaled_rational(m_denominator, 0)));
  }

  // Throws when neighbouring pieces differ where they meet.
  void check_continuity(const std::string& what) const;

private:
  static std::vector<Breaks_of_axis> common_breaks(const Integer_spline& a, const Integer_spline& b);

  // To lowest terms.
  static void reduce(Power_form& form);

  std::vector<Exact_rational> rational(std::size_t piece) const;

  static std::string text_of(const Exact_rational& x)
  {
    const Big_integer numerator = numerator_of(x), denominator = denominator_of(x);
    return denominator == 1 ? numerator.str() : numerator.str() + "/" + denominator.str();
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline::Integer_spline(const Bspline_function<Exact_rational>& function)
{
  m_pieces.degrees = function.degrees();
  for (int j = 0; j < function.dimension(); ++j)
    m_pieces.breaks.push_back(function.breaks(j));
  std::vector<Power_form> forms;
  Short_integer common(1);
  for (const Bernstein_tensor<Exact_rational>& piece : function.bezier_pieces()) {
    forms.push_back(power_form(piece, m_pieces.breaks, forms.size()));
    reduce(forms.back());
    common *= forms.back().denominator / gcd(common, forms.back().denominator);
  }
  m_denominator = common.to_big_integer();
  for (const Power_form& form : forms) {
    const Short_integer factor = common / form.denominator;
    auto& integers = m_pieces.pieces.emplace_back();
    for (const Short_integer& coefficient : form.numerators)
      integers.push_back((coefficient * factor).to_big_integer());
  }
  m_pieces.simplify();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline Integer_spline::restricted(int axis, const Exact_rational& begin,
                                                                         const Exact_rational& end) const
{
  const Breaks_of_axis& own = breaks()[axis];
  const std::size_t first = cell_at(own, begin);
  std::size_t last = first + 1;
  while (last + 1 < own.size() && own[last] < end)
    ++last;
  const Axis_view cells = axis_view(m_pieces.last_cells(), axis);
  Integer_pieces<Big_integer> result{degrees(), {}, {}};
  for (int j = 0; j < dimension(); ++j)
    if (j == axis)
      result.breaks.emplace_back(own.begin() + first, own.begin() + last + 1);
    else
      result.breaks.push_back(breaks()[j]);
  if (begin < end) {
    result.breaks[axis].front() = begin;
    result.breaks[axis].back() = end;
  }
  for (std::size_t o = 0; o < cells.outer; ++o) { // only the cells of the part are touched
    const auto row = pieces().begin() + o * (cells.degree + 1) * cells.inner;
    result.pieces.insert(result.pieces.end(), row + first * cells.inner, row + last * cells.inner);
  }
  return Integer_spline(std::move(result), m_denominator);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline Integer_spline::face(int axis, const Exact_rational& value) const
{
  const Integer_spline slab = restricted(axis, value, value);
  const Axis_view view = axis_view(slab.degrees(), axis);
  const Big_integer p = numerator_of(value), q = denominator_of(value);
  Integer_pieces<Big_integer> result{slab.degrees(), slab.breaks(), {}};
  result.degrees[axis] = 0;
  result.breaks[axis].clear();
  for (const auto& piece : slab.pieces()) {
    auto& values = result.pieces.emplace_back();
    for (std::size_t o = 0; o < view.outer; ++o)
      for (std::size_t i = 0; i < view.inner; ++i) {
        Big_integer sum = 0, power_of_q = 1;
        for (int k = view.degree; k >= 0; --k, power_of_q *= q)
          sum = Big_integer(sum * p + piece[(o * (view.degree + 1) + k) * view.inner + i] * power_of_q);
        values.push_back(std::move(sum));
      }
  }
  return Integer_spline(std::move(result), Big_integer(m_denominator * pow(q, static_cast<unsigned>(view.degree))));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline Integer_spline::piecewise_derivative(int axis) const
{
  const Axis_view view = axis_view(degrees(), axis);
  Integer_pieces<Big_integer> result;
  result.breaks = breaks();
  result.degrees = degrees();
  const int degree = (std::max)(view.degree - 1, 0);
  result.degrees[axis] = degree;
  for (const auto& piece : pieces()) {
    auto& derivative = result.pieces.emplace_back();
    for (std::size_t o = 0; o < view.outer; ++o)
      for (int k = 0; k <= degree; ++k)
        for (std::size_t i = 0; i < view.inner; ++i)
          derivative.push_back(view.degree == 0
                                   ? Big_integer(0)
                                   : Big_integer(piece[(o * (view.degree + 1) + k + 1) * view.inner + i] * (k + 1)));
  }
  return Integer_spline(std::move(result), m_denominator);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline operator*(const Integer_spline& a, const Integer_spline& b)
{
  const Convolution_shape shape(a.degrees(), b.degrees());
  Integer_pieces<Big_integer> result{shape.result, Integer_spline::common_breaks(a, b), {}};
  for_each_index(result.last_cells(), [&](const std::vector<int>& cell) {
    result.pieces.push_back(convolved(shape, a.piece_on(result.breaks, cell), b.piece_on(result.breaks, cell)));
  });
  return Integer_spline(std::move(result), Big_integer(a.m_denominator * b.m_denominator));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline Integer_spline::difference(const Integer_spline& a,
                                                                         const Integer_spline& b, int factor)
{
  Integer_pieces<Big_integer> result{a.degrees(), common_breaks(a, b), {}};
  for (std::size_t j = 0; j < result.degrees.size(); ++j)
    result.degrees[j] = (std::max)(a.degrees()[j], b.degrees()[j]);
  const Big_integer denominator = lcm(a.m_denominator, b.m_denominator), a_scale = denominator / a.m_denominator,
                    b_scale = -factor * (denominator / b.m_denominator);
  const std::vector<int> origin(result.degrees.size(), 0);
  for_each_index(result.last_cells(), [&](const std::vector<int>& cell) {
    auto& sum = result.pieces.emplace_back(tensor_size(result.degrees), Big_integer(0));
    for (const auto& summand : {std::pair(&a, &a_scale), std::pair(&b, &b_scale)}) {
      auto next = summand.first->piece_on(result.breaks, cell).begin();
      for_each_position(result.degrees, origin, summand.first->degrees(),
                        [&](std::size_t position) { add_product(sum[position], *next++, *summand.second); });
    }
  });
  return Integer_spline(std::move(result), denominator);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Integer_spline::check_continuity(const std::string& what) const
{
  for (std::size_t j = 0; j < degrees().size(); ++j)
    for (std::size_t k = 1; k < cells_between(breaks()[j]); ++k) {
      const Axis_view cells = axis_view(m_pieces.last_cells(), j), view = axis_view(degrees(), j);
      const Exact_rational& at = breaks()[j][k];
      for (std::size_t o = 0; o < cells.outer; ++o)
        for (std::size_t i = 0; i < cells.inner; ++i) {
          const std::size_t after = (o * (cells.degree + 1) + k) * cells.inner + i;
          if (contracted(rational(after - cells.inner), view, at) != contracted(rational(after), view, at))
            throw Invalid_input(what + " is not continuous at the parameter " + text_of(at) + " of axis " +
                                std::to_string(j) + "; split there");
        }
    }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Integer_spline::reduce(Power_form& form)
{
  Short_integer common = form.denominator;
  for (auto coefficient = form.numerators.begin(); common != 1 && coefficient != form.numerators.end(); ++coefficient)
    common = gcd(common, *coefficient);
  if (common == 1)
    return;
  form.denominator /= common;
  for (Short_integer& coefficient : form.numerators)
    coefficient /= common;
}
#endif

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline Integer_spline::operator-() const
{
  Integer_spline result(*this);
  for (auto& piece : result.m_pieces.pieces)
    for (Big_integer& coefficient : piece)
      coefficient = -coefficient;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const std::vector<Big_integer>&
Integer_spline::piece_on(const std::vector<Breaks_of_axis>& finer, const std::vector<int>& cell) const
{
  std::size_t index = 0;
  for (std::size_t j = 0; j < cell.size(); ++j)
    index = index * cells_between(breaks()[j]) + (finer[j].empty() ? 0 : cell_at(breaks()[j], finer[j][cell[j]]));
  return m_pieces.pieces[index];
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Breaks_of_axis> Integer_spline::common_breaks(const Integer_spline& a,
                                                                                         const Integer_spline& b)
{
  std::vector<Breaks_of_axis> result;
  for (int j = 0; j < a.dimension(); ++j)
    result.push_back(united(a.breaks()[j], b.breaks()[j]));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_rational> Integer_spline::rational(std::size_t piece) const
{
  std::vector<Exact_rational> result;
  for (const Big_integer& coefficient : pieces()[piece])
    result.push_back(scaled_rational(coefficient, 0));
  return result;
}
#endif

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Breaks_of_axis united(const Breaks_of_axis& a, const Breaks_of_axis& b)
{
  Breaks_of_axis result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t cell_at(const Breaks_of_axis& breaks, const Exact_rational& x)
{
  if (breaks.size() < 3)
    return 0;
  return static_cast<std::size_t>(std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x) - breaks.begin()) - 1;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<std::vector<int>, Integer_spline> Integer_spline::without_trivial_axes() const
{
  Integer_spline result(*this);
  std::vector<int> axes = result.m_pieces.remove_trivial_axes();
  return {std::move(axes), std::move(result)};
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_SPLINE_H
