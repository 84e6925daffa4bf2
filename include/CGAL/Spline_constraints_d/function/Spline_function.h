// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SPLINE_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SPLINE_FUNCTION_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Short_integer.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

One summand of a `Spline_function`: a piecewise polynomial of the unknowns `variables`, exact, in power form.

Axis `j` belongs to the unknown `variables[j]` (increasing) and is cut at `breaks[j]` (increasing; empty when the term
is one polynomial everywhere). `pieces` holds a dense coefficient tensor per cell, cells and coefficients both in
row-major order with the last axis fastest: entry \f$(k_0,k_1,\dots)\f$ of a piece is the coefficient of \f$\prod_j
x_{v_j}^{k_j}\f$.
*/
struct Spline_term
{
  std::vector<int> variables;
  std::vector<int> degrees;
  std::vector<std::vector<Exact_rational>> breaks;
  std::vector<std::vector<Exact_rational>> pieces;

  //! number of coefficients of one piece.
  std::size_t piece_size() const
  {
    std::size_t size = 1;
    for (int d : degrees)
      size *= static_cast<std::size_t>(d) + 1;
    return size;
  }

  //! number of cells along an axis.
  std::size_t cells(std::size_t axis) const { return breaks[axis].empty() ? 1 : breaks[axis].size() - 1; }

  //! whether two terms have the same unknowns, degrees, breaks and coefficients.
  bool operator==(const Spline_term&) const = default;
};

/*!
\ingroup PkgSplineConstraintsDFunctions

A multivariate spline as the solver wants it: a sum of terms, each on its own subset of the unknowns, with exact
rational coefficients.

Terms are kept apart as long as their unknowns are, since the range of a sum over disjoint unknowns is the sum of the
ranges:
\f$C_1(t) - C_2(s)\f$ costs \f$d_1 + d_2 + 2\f$ coefficients instead of \f$(d_1+1)(d_2+1)\f$.
*/
class Spline_function
{
  std::vector<Spline_term> m_terms;

public:
  //! the function that is zero everywhere.
  Spline_function() = default;

  //! most coefficients that one piece of a term may have.
  static constexpr std::size_t maximal_piece_size = std::size_t(1) << 22;

  //! splits a polynomial into terms that share no unknown (the connected components of "occurs in one monomial with").
  //! \throws Invalid_input when the dense tensor of a term would have more than `maximal_piece_size` coefficients.
  Spline_function(const Power_polynomial& polynomial);

  //! a single term.
  //! \throws Invalid_input when sizes do not match or breaks do not increase.
  explicit Spline_function(Spline_term term);

  //! the term of a spline given by its Bézier pieces: `breaks` per axis (at least two each), `pieces` in row-major
  //! order of the cells on the local unit boxes.
  //! \throws Invalid_input when sizes do not match, breaks do not increase or variables do not increase.
  static Spline_function from_bezier_pieces(std::vector<int> variables, std::vector<std::vector<Exact_rational>> breaks,
                                            const std::vector<Bernstein_tensor<Exact_rational>>& pieces);

  //! the same with control points in doubles, which are exact numbers. \throws Invalid_input likewise.
  static Spline_function from_bezier_pieces(std::vector<int> variables, std::vector<std::vector<Exact_rational>> breaks,
                                            const std::vector<Bernstein_tensor<double>>& pieces);

  //! one polynomial everywhere, given by its Bernstein coefficients on the unit box; axis `j` belongs to the unknown
  //! `variables[j]`.
  //! \throws Invalid_input when sizes do not match or variables do not increase.
  static Spline_function from_bernstein(std::vector<int> variables, const Bernstein_tensor<Exact_rational>& polynomial);
  static Spline_function from_bernstein(std::vector<int> variables, const Bernstein_tensor<double>& polynomial);

  //! the summands.
  const std::vector<Spline_term>& terms() const { return m_terms; }

  //! adds the terms of another function.
  Spline_function& operator+=(Spline_function other);

  //! multiplies by a constant.
  Spline_function& operator*=(const Exact_rational& factor);

  friend Spline_function operator+(Spline_function a, Spline_function b) { return std::move(a += std::move(b)); }
  friend Spline_function operator-(Spline_function a, Spline_function b);

private:
  template <class NT>
  static Spline_function from_pieces(std::vector<int> variables, std::vector<std::vector<Exact_rational>> breaks,
                                     std::span<const Bernstein_tensor<NT>> pieces);
};

namespace internal {

void check(const Spline_term& term);

// Calls visit(first number, distance of the next) for every row of a tensor along an axis.
template <class NT, class Visitor>
void visit_rows(std::vector<NT>& coefficients, const std::vector<int>& degrees, std::size_t axis, const Visitor& visit)
{
  std::size_t inner = 1;
  for (std::size_t j = axis + 1; j < degrees.size(); ++j)
    inner *= static_cast<std::size_t>(degrees[j]) + 1;
  const std::size_t line = inner * (degrees[axis] + 1);
  for (std::size_t begin = 0; begin < coefficients.size(); begin += line)
    for (std::size_t i = begin; i < begin + inner; ++i)
      visit(coefficients.data() + i, inner);
}

// Substitutes x -> shift + scale x along an axis of a dense power-form tensor, by repeated synthetic division.
template <class NT>
void substitute_affine(std::vector<NT>& coefficients, const std::vector<int>& degrees, std::size_t axis,
                       const NT& shift, const NT& scale)
{
  const int degree = degrees[axis];
  visit_rows(coefficients, degrees, axis, [&](NT* a, std::size_t step) {
    for (int r = 0; r < degree; ++r)
      for (int k = degree - 1; k >= r; --k)
        a[step * k] += shift * a[step * (k + 1)];
    NT power(1);
    for (int k = 1; k <= degree; ++k) {
      power *= scale;
      a[step * k] *= power;
    }
  });
}

// Bernstein coefficients to coefficients of powers, along one axis of a tensor of integers: binomials times
// differences.
void bernstein_to_power(std::vector<Short_integer>& coefficients, const std::vector<int>& degrees, std::size_t axis);

/*
Powers of t = (x - begin) / (end - begin) to those of x, along one axis of a tensor of integers over a common
denominator. With begin = b / u and end - begin = w / u that is t = (u x - b) / w: coefficient k is multiplied by
w^(d-k), over w^d, then all are shifted by b, then multiplied by u^k.
*/
void substitute_range(std::vector<Short_integer>& coefficients, Short_integer& denominator,
                      const std::vector<int>& degrees, std::size_t axis, const Exact_rational& begin,
                      const Exact_rational& end);

// Coefficients of powers over a common denominator.
struct Power_form
{
  std::vector<Short_integer> numerators;
  Short_integer denominator;
};

// The powers of the parameters of a piece given on the local unit box. Where an axis has no breaks, they are those of
// the local parameter; else the cells are numbered in row-major order.
template <class NT>
Power_form power_form(const Bernstein_tensor<NT>& piece, const std::vector<std::vector<Exact_rational>>& breaks,
                      std::size_t cell)
{
  Power_form result;
  result.denominator = over_common_denominator(piece.coefficients(), result.numerators);
  for (std::size_t j = breaks.size(); j-- > 0;) {
    bernstein_to_power(result.numerators, piece.degrees(), j);
    if (breaks[j].empty())
      continue;
    const std::size_t cells = breaks[j].size() - 1, k = cell % cells;
    cell /= cells;
    if (const Exact_rational& begin = breaks[j][k], &end = breaks[j][k + 1]; begin != 0 || end != 1)
      substitute_range(result.numerators, result.denominator, piece.degrees(), j, begin, end);
  }
  return result;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void check(const Spline_term& term)
{
  if (term.degrees.size() != term.variables.size() || term.breaks.size() != term.variables.size())
    throw Invalid_input("Spline_term: variables, degrees and breaks differ in number");
  std::size_t cells = 1;
  for (std::size_t j = 0; j < term.variables.size(); ++j) {
    const auto at = [&] { return " (axis " + std::to_string(j) + ")"; };
    if (term.variables[j] < 0 || (j > 0 && term.variables[j] <= term.variables[j - 1]))
      throw Invalid_input("Spline_term: variables must increase and be non-negative" + at());
    if (term.degrees[j] < 0)
      throw Invalid_input("Spline_term: negative degree" + at());
    if (term.breaks[j].size() == 1)
      throw Invalid_input("Spline_term: a single break" + at());
    for (std::size_t k = 1; k < term.breaks[j].size(); ++k)
      if (!(term.breaks[j][k - 1] < term.breaks[j][k]))
        throw Invalid_input("Spline_term: breaks must increase" + at() + ", break " + std::to_string(k));
    cells *= term.cells(j);
  }
  if (term.pieces.size() != cells)
    throw Invalid_input("Spline_term: " + std::to_string(term.pieces.size()) + " pieces for " + std::to_string(cells) +
                        " cells");
  for (std::size_t c = 0; c < cells; ++c)
    if (term.pieces[c].size() != term.piece_size())
      throw Invalid_input("Spline_term: wrong number of coefficients in piece " + std::to_string(c));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void bernstein_to_power(std::vector<Short_integer>& coefficients,
                                                       const std::vector<int>& degrees, std::size_t axis)
{
  const int degree = degrees[axis];
  visit_rows(coefficients, degrees, axis, [&](Short_integer* a, std::size_t step) {
    for (int r = 1; r <= degree; ++r)
      for (int k = degree; k >= r; --k)
        a[step * k] -= a[step * (k - 1)];
    Short_integer binomial(1);
    for (int k = 1; k < degree; ++k) {
      binomial *= degree - k + 1;
      binomial /= k;
      a[step * k] *= binomial;
    }
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE void substitute_range(std::vector<Short_integer>& coefficients,
                                                     Short_integer& denominator, const std::vector<int>& degrees,
                                                     std::size_t axis, const Exact_rational& begin,
                                                     const Exact_rational& end)
{
  const int degree = degrees[axis];
  Short_integer unit(1);
  extend_common_denominator(unit, begin);
  extend_common_denominator(unit, end);
  const Short_integer offset = -numerator_over(begin, unit), width = numerator_over(end, unit) + offset;
  std::vector<Short_integer> powers_of_width(1, Short_integer(1)), powers_of_unit(1, Short_integer(1));
  for (int k = 1; k <= degree; ++k) {
    powers_of_width.push_back(powers_of_width.back() * width);
    powers_of_unit.push_back(powers_of_unit.back() * unit);
  }
  denominator *= powers_of_width.back();
  visit_rows(coefficients, degrees, axis, [&](Short_integer* a, std::size_t step) {
    for (int k = 0; k <= degree; ++k)
      a[step * k] *= powers_of_width[degree - k];
    for (int r = 0; r < degree; ++r)
      for (int k = degree - 1; k >= r; --k)
        add_product(a[step * k], offset, a[step * (k + 1)]);
    for (int k = 1; k <= degree; ++k)
      a[step * k] *= powers_of_unit[k];
  });
}
#endif

} // namespace internal

inline Spline_function::Spline_function(Spline_term term)
{
  internal::check(term);
  m_terms.push_back(std::move(term));
}

// Where an axis has no breaks, the piece belongs to the unit interval, and goes on beyond it.
template <class NT>
Spline_function Spline_function::from_pieces(std::vector<int> variables,
                                             std::vector<std::vector<Exact_rational>> breaks,
                                             std::span<const Bernstein_tensor<NT>> pieces)
{
  Spline_term term;
  term.variables = std::move(variables);
  term.breaks = std::move(breaks);
  const std::size_t dimension = term.variables.size();
  if (pieces.empty() || term.breaks.size() != dimension)
    throw Invalid_input("Spline_function: no pieces, or breaks and variables differ in number");
  term.degrees.assign(dimension, 0);
  for (const auto& piece : pieces) {
    if (piece.degrees().size() != dimension)
      throw Invalid_input("Spline_function: a piece has the wrong number of axes");
    for (std::size_t j = 0; j < dimension; ++j)
      term.degrees[j] = (std::max)(term.degrees[j], piece.degrees()[j]);
  }
  term.pieces.reserve(pieces.size());
  for (std::size_t c = 0; c < pieces.size(); ++c) {
    internal::Power_form power;
    if (pieces[c].degrees() == term.degrees)
      power = internal::power_form(pieces[c], term.breaks, c);
    else {
      const std::vector<NT>& bernstein = pieces[c].coefficients();
      power = internal::power_form(
          Bernstein_tensor<Exact_rational>(pieces[c].degrees(), {bernstein.begin(), bernstein.end()})
              .elevated(term.degrees),
          term.breaks, c);
    }
    std::vector<Exact_rational>& piece = term.pieces.emplace_back(power.numerators.size());
    for (std::size_t k = 0; k < piece.size(); ++k)
      internal::set_quotient(piece[k], power.numerators[k], power.denominator);
  }
  return Spline_function(std::move(term));
}

namespace internal {

void check_breaks_of_pieces(const std::vector<std::vector<Exact_rational>>& breaks);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void check_breaks_of_pieces(const std::vector<std::vector<Exact_rational>>& breaks)
{
  for (std::size_t j = 0; j < breaks.size(); ++j)
    if (breaks[j].size() < 2)
      throw Invalid_input("Spline_function: fewer than two breaks on axis " + std::to_string(j));
}
#endif

} // namespace internal

inline Spline_function Spline_function::from_bezier_pieces(std::vector<int> variables,
                                                           std::vector<std::vector<Exact_rational>> breaks,
                                                           const std::vector<Bernstein_tensor<Exact_rational>>& pieces)
{
  internal::check_breaks_of_pieces(breaks);
  return from_pieces(std::move(variables), std::move(breaks), std::span(pieces));
}

inline Spline_function Spline_function::from_bezier_pieces(std::vector<int> variables,
                                                           std::vector<std::vector<Exact_rational>> breaks,
                                                           const std::vector<Bernstein_tensor<double>>& pieces)
{
  internal::check_breaks_of_pieces(breaks);
  return from_pieces(std::move(variables), std::move(breaks), std::span(pieces));
}

inline Spline_function Spline_function::from_bernstein(std::vector<int> variables,
                                                       const Bernstein_tensor<Exact_rational>& polynomial)
{
  return from_pieces(std::move(variables), std::vector<std::vector<Exact_rational>>(polynomial.degrees().size()),
                     std::span(&polynomial, 1));
}

inline Spline_function Spline_function::from_bernstein(std::vector<int> variables,
                                                       const Bernstein_tensor<double>& polynomial)
{
  return from_pieces(std::move(variables), std::vector<std::vector<Exact_rational>>(polynomial.degrees().size()),
                     std::span(&polynomial, 1));
}

namespace internal {

bool is_zero_everywhere(const Spline_function& function);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool is_zero_everywhere(const Spline_function& function)
{
  const auto is_zero_piece = [](const std::vector<Exact_rational>& piece) {
    return std::all_of(piece.begin(), piece.end(),
                       [](const Exact_rational& coefficient) { return CGAL::is_zero(coefficient); });
  };
  return std::all_of(function.terms().begin(), function.terms().end(), [&](const Spline_term& term) {
    return std::all_of(term.pieces.begin(), term.pieces.end(), is_zero_piece);
  });
}
#endif

} // namespace internal
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Spline_function& Spline_function::operator+=(Spline_function other)
{
  m_terms.insert(m_terms.end(), std::make_move_iterator(other.m_terms.begin()),
                 std::make_move_iterator(other.m_terms.end()));
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Spline_function& Spline_function::operator*=(const Exact_rational& factor)
{
  for (Spline_term& term : m_terms)
    for (auto& piece : term.pieces)
      for (Exact_rational& coefficient : piece)
        coefficient *= factor;
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Spline_function operator-(Spline_function a, Spline_function b)
{
  for (Spline_term& term : b.m_terms)
    for (auto& piece : term.pieces)
      for (Exact_rational& coefficient : piece)
        coefficient = -coefficient;
  return std::move(a += std::move(b));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Spline_function::Spline_function(const Power_polynomial& polynomial)
{
  // Union-find over the unknowns: those of one monomial belong together.
  const std::vector<int> variables = polynomial.variables();
  std::map<int, int> parent;
  for (int v : variables)
    parent[v] = v;
  const auto root = [&](int v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [monomial, coefficient] : polynomial.terms())
    for (const auto& power : monomial.powers)
      parent[root(power.first)] = root(monomial.powers.front().first);

  std::map<int, std::size_t> term_of_root;
  for (int v : variables) {
    const auto [position, is_new] = term_of_root.emplace(root(v), m_terms.size());
    if (is_new)
      m_terms.emplace_back();
    Spline_term& term = m_terms[position->second];
    term.variables.push_back(v);
    term.degrees.push_back(polynomial.degree(v));
    term.breaks.emplace_back();
  }
  if (m_terms.empty())
    m_terms.emplace_back(); // a constant: a term without unknowns
  for (const Spline_term& term : m_terms) {
    double size = 1;
    for (int d : term.degrees)
      size *= d + 1.0;
    if (size > static_cast<double>(maximal_piece_size))
      throw Invalid_input("Spline_function: a polynomial in " + std::to_string(term.variables.size()) +
                          " connected unknowns has too many coefficients as a dense tensor");
  }
  for (Spline_term& term : m_terms)
    term.pieces.assign(1, std::vector<Exact_rational>(term.piece_size(), Exact_rational(0)));

  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Spline_term& term = m_terms[monomial.powers.empty() ? 0 : term_of_root[root(monomial.powers.front().first)]];
    std::size_t index = 0, p = 0;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      const bool occurs = p < monomial.powers.size() && monomial.powers[p].first == term.variables[j];
      index = index * (static_cast<std::size_t>(term.degrees[j]) + 1) + (occurs ? monomial.powers[p++].second : 0);
    }
    term.pieces[0][index] += coefficient;
  }
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SPLINE_FUNCTION_H
