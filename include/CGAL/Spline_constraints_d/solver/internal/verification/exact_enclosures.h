// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_EXACT_ENCLOSURES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_EXACT_ENCLOSURES_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
What `verify` knows of splines: exact enclosures of values and derivatives on boxes. Nothing here is shared with the
subdivision, so that an error there cannot hide here.
*/
namespace verification {

struct Range
{
  Exact_rational lower, upper;
};

using Box = std::vector<Range>;
using Point = std::vector<Exact_rational>;

inline bool is_zero(const Exact_rational& x) { return CGAL::sign(x) == CGAL::ZERO; }

inline Exact_rational absolute(const Exact_rational& x)
{
  return CGAL::sign(x) == CGAL::NEGATIVE ? Exact_rational(-x) : x;
}

inline Point middle_of(const Box& box)
{
  Point result;
  for (const Range& range : box)
    result.emplace_back((range.lower + range.upper) / Exact_rational(2));
  return result;
}

inline Point radius_of(const Box& box)
{
  Point result;
  for (const Range& range : box)
    result.emplace_back((range.upper - range.lower) / Exact_rational(2));
  return result;
}

// The smallest range with both.
inline void extend(Range& range, const Exact_rational& lower, const Exact_rational& upper)
{
  if (lower < range.lower)
    range.lower = lower;
  if (range.upper < upper)
    range.upper = upper;
}

// A dense polynomial in power form, the last axis fastest, of the variables of a term.
struct Polynomial
{
  std::vector<int> degrees;
  std::vector<Exact_rational> coefficients;

  std::size_t inner(std::size_t axis) const
  {
    std::size_t result = 1;
    for (std::size_t j = axis + 1; j < degrees.size(); ++j)
      result *= static_cast<std::size_t>(degrees[j]) + 1;
    return result;
  }

  // p(x) -> p(centre + x)
  void move_origin(const Point& centre)
  {
    for (std::size_t j = 0; j < degrees.size(); ++j) {
      const std::size_t step = inner(j), line = step * (degrees[j] + 1);
      for (std::size_t i = 0; i < coefficients.size(); ++i)
        if (i % line < step)   // i begins a line along the axis: divide by x - centre again and again
          for (std::size_t done = 0; done < static_cast<std::size_t>(degrees[j]); ++done)
            for (std::size_t k = degrees[j]; k-- > done;)
              coefficients[i + k * step] += centre[j] * coefficients[i + (k + 1) * step];
    }
  }

  // The polynomial of the remaining axes that is left when one variable has a value.
  Polynomial with(std::size_t axis, const Exact_rational& value) const
  {
    Polynomial result{degrees, {}};
    result.degrees[axis] = 0;
    const std::size_t step = inner(axis), line = step * (degrees[axis] + 1);
    for (std::size_t begin = 0; begin < coefficients.size(); begin += line)
      for (std::size_t i = begin; i < begin + step; ++i) {
        Exact_rational sum = coefficients[i + line - step];
        for (std::size_t k = degrees[axis]; k-- > 0;)
          sum = sum * value + coefficients[i + k * step];
        result.coefficients.push_back(std::move(sum));
      }
    return result;
  }

  Exact_rational operator()(const Point& point) const
  {
    if (degrees.empty())
      return coefficients[0];
    Polynomial rest = with(degrees.size() - 1, point.back());
    for (std::size_t j = degrees.size() - 1; j-- > 0;)
      rest = rest.with(j, point[j]);
    return rest.coefficients[0];
  }

  Polynomial derivative(std::size_t axis) const
  {
    Polynomial result{degrees, {}};
    result.degrees[axis] = (std::max)(0, degrees[axis] - 1);
    const std::size_t step = inner(axis);
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      const std::size_t k = i / step % (degrees[axis] + 1);
      if (k > 0 || degrees[axis] == 0)
        result.coefficients.emplace_back(coefficients[i] * Exact_rational(static_cast<int>(k)));
    }
    return result;
  }
};

// The parts of a point that a term sees.
inline Point restricted(const Point& point, const Spline_term& term)
{
  Point result;
  for (int v : term.variables)
    result.push_back(point[v]);
  return result;
}

// Calls visit(piece, cell per axis) for every piece of a term whose closed cell meets the box. The outermost cells
// reach to infinity.
template <class Visitor>
void visit_pieces(const Spline_term& term, const Box& box, const Visitor& visit)
{
  const std::size_t axes = term.variables.size();
  std::vector<std::size_t> first, last;
  for (std::size_t j = 0; j < axes; ++j) {
    const Range& range = box[term.variables[j]];
    const auto& breaks = term.breaks[j];
    const std::size_t end = term.cells(j) - 1;
    first.push_back(0);
    while (first[j] < end && breaks[first[j] + 1] < range.lower)
      ++first[j];
    last.push_back(first[j]);
    while (last[j] < end && breaks[last[j] + 1] <= range.upper)
      ++last[j];
  }
  std::vector<std::size_t> cell = first;
  for (bool is_done = false; !is_done;) {
    std::size_t index = 0;
    for (std::size_t j = 0; j < axes; ++j)
      index = index * term.cells(j) + cell[j];
    visit(Polynomial{term.degrees, term.pieces[index]}, cell);
    is_done = true;
    for (std::size_t j = axes; is_done && j-- > 0;) {
      is_done = cell[j] == last[j];
      cell[j] = is_done ? first[j] : cell[j] + 1;
    }
  }
}

/*
Neighbouring pieces that meet the box agree on the break between them, as polynomials: the function is continuous on the
box.
*/
inline bool is_continuous(const Spline_function& function, const Box& box)
{
  bool result = true;
  for (const Spline_term& term : function.terms())
    visit_pieces(term, box, [&](const Polynomial& piece, const std::vector<std::size_t>& cell) {
      std::size_t stride = 1;
      for (std::size_t j = cell.size(); j-- > 0;) {
        if (cell[j] + 1 < term.cells(j) && term.breaks[j][cell[j] + 1] <= box[term.variables[j]].upper) {
          std::size_t index = 0;
          for (std::size_t i = 0; i < cell.size(); ++i)
            index = index * term.cells(i) + cell[i];
          const Exact_rational& at = term.breaks[j][cell[j] + 1];
          const Polynomial neighbour{term.degrees, term.pieces[index + stride]};
          result = result && piece.with(j, at).coefficients == neighbour.with(j, at).coefficients;
        }
        stride *= term.cells(j);
      }
    });
  return result;
}

// Taylor's polynomial about y of a piece, and the same with absolute values, P: for |h| <= r the piece differs from its
// value at y by at most P(r) - P(0), and its partial derivative j from that at y by at most P_j(r) - P_j(0).
struct Taylor_form
{
  Polynomial polynomial, majorant;

  Taylor_form(const Polynomial& piece, const Point& centre) : polynomial(piece)
  {
    polynomial.move_origin(centre);
    majorant = polynomial;
    for (Exact_rational& coefficient : majorant.coefficients)
      coefficient = absolute(coefficient);
  }

  static Range around(const Polynomial& p, const Polynomial& majorant, const Point& radius)
  {
    const Exact_rational deviation = majorant(radius) - majorant.coefficients[0];
    return {Exact_rational(p.coefficients[0] - deviation), Exact_rational(p.coefficients[0] + deviation)};
  }
};

// Encloses the values of a function on a box; exact, and a single number, when the box is a point and the function
// continuous there.
inline Range values(const Spline_function& function, const Box& box)
{
  const Point centre = middle_of(box), radius = radius_of(box);
  Range sum{Exact_rational(0), Exact_rational(0)};
  for (const Spline_term& term : function.terms()) {
    std::vector<Range> ranges;
    visit_pieces(term, box, [&](const Polynomial& piece, const std::vector<std::size_t>&) {
      const Taylor_form form(piece, restricted(centre, term));
      ranges.push_back(Taylor_form::around(form.polynomial, form.majorant, restricted(radius, term)));
      extend(ranges.front(), ranges.back().lower, ranges.back().upper);
    });
    sum.lower += ranges.front().lower;
    sum.upper += ranges.front().upper;
  }
  return sum;
}

using Functions = std::vector<const Spline_function*>;

// Taylor's coefficients about a point of several functions: for every monomial one number per function.
using Taylor_coefficients = std::map<std::vector<int>, Point>;

// On a break, those of one of the pieces that meet there.
inline Taylor_coefficients taylor_coefficients(const Functions& functions, const Point& centre)
{
  Box place;
  for (const Exact_rational& x : centre)
    place.push_back({x, x});
  Taylor_coefficients result;
  for (std::size_t k = 0; k < functions.size(); ++k)
    for (const Spline_term& term : functions[k]->terms()) {
      Polynomial polynomial;
      visit_pieces(term, place, [&](const Polynomial& piece, const std::vector<std::size_t>&) { polynomial = piece; });
      polynomial.move_origin(restricted(centre, term));
      for (std::size_t i = 0; i < polynomial.coefficients.size(); ++i)
        if (!is_zero(polynomial.coefficients[i])) {
          std::vector<int> exponents(centre.size(), 0);
          for (std::size_t j = 0; j < term.variables.size(); ++j)
            exponents[term.variables[j]] = static_cast<int>(i / polynomial.inner(j) % (term.degrees[j] + 1));
          result.try_emplace(std::move(exponents), functions.size(), Exact_rational(0)).first->second[k] +=
              polynomial.coefficients[i];
        }
    }
  return result;
}

} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_EXACT_ENCLOSURES_H
