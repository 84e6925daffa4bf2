// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICITIZATION_IMPLICIT_EQUATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICITIZATION_IMPLICIT_EQUATION_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Echelon_form.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/Found_implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_rows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The polynomial f of a given degree with f(S) = 0, for a curve in the plane or a surface S = X/w, if there is one up to a
factor; or of all of them, as for a curve in space.

On a piece of S of the degrees (m, n), w^d f(X/w) is a polynomial of the degrees (d m, d n). So f(S) = 0 on the piece if
and only if this holds at d m + 1 times d n + 1 of its points: linear equations for the coefficients of f. Of a curve it
is the same with one degree.
*/
template <int d, int axes = d - 1>
class Implicit_equation
{
  using Homogeneous_point = std::array<Exact_rational, d + 1>; // numerators and weight
  using Piece = std::array<std::size_t, axes>;

  const Spline_patch<d>& m_spline;
  const int m_degree;
  const std::function<void()> m_check;
  std::vector<std::array<int, d>> m_monomials;
  std::array<std::vector<Exact_rational>, axes> m_breaks;

public:
  // `check()` is called before each linear equation, and may end the work by an exception.
  Implicit_equation(
      const Spline_patch<d>& spline, int degree, std::function<void()> check = [] {})
    : m_spline(spline), m_degree(degree), m_check(std::move(check))
  {
    for_each_index(std::vector<int>(d, degree), [&](const std::vector<int>& exponents) {
      if (std::accumulate(exponents.begin(), exponents.end(), 0) <= degree)
        std::copy(exponents.begin(), exponents.end(), m_monomials.emplace_back().begin());
    });
    for (int axis = 0; axis < axes; ++axis)
      m_breaks[static_cast<std::size_t>(axis)] = spline.breaks(axis);
  }

  // The one that is determined by the first piece, if it is zero on all others, too.
  std::optional<Power_polynomial> operator()() const
  {
    if (has_no_solution_modulo_prime())
      return std::nullopt;
    Echelon_form rows;
    add_piece(rows, {});
    if (rows.rank() + 1 != m_monomials.size())
      return std::nullopt;
    const std::vector<Exact_rational> coefficients = rows.orthogonal_vector(m_monomials.size());
    return vanishes_everywhere(coefficients) ? std::optional(polynomial(coefficients)) : std::nullopt;
  }

  // How many linearly independent ones there are, and if it is one, this; pieces of several curves or surfaces have the
  // product of their equations.
  std::pair<std::size_t, std::optional<Power_polynomial>> of_all_pieces() const
  {
    if (has_no_solution_modulo_prime())
      return {0, std::nullopt};
    if (std::optional<Power_polynomial> result = (*this)())
      return {1, std::move(result)};
    Echelon_form rows;
    visit_pieces([&](const Piece& piece) { return add_piece(rows, piece); });
    const std::size_t count = m_monomials.size() - rows.rank();
    return {count, count == 1 ? std::optional(polynomial(rows.orthogonal_vector(m_monomials.size()))) : std::nullopt};
  }

  // A basis of all of them.
  std::vector<Power_polynomial> basis() const
  {
    Echelon_form rows;
    visit_pieces([&](const Piece& piece) { return add_piece(rows, piece); });
    std::vector<Power_polynomial> result;
    for (const std::vector<Exact_rational>& coefficients : rows.kernel(m_monomials.size()))
      result.push_back(polynomial(coefficients));
    return result;
  }

private:
  // Whether there may be a solution still.
  bool add_piece(Echelon_form& rows, const Piece& piece) const
  {
    visit_points(piece, [&](const Homogeneous_point& x) {
      rows.add(exact_values(x));
      return rows.rank() < m_monomials.size();
    });
    return rows.rank() < m_monomials.size();
  }

  bool vanishes_everywhere(const std::vector<Exact_rational>& coefficients) const
  {
    bool result = true;
    visit_pieces([&](const Piece& piece) {
      if (piece != Piece{}) // of which it is known
        visit_points(piece, [&](const Homogeneous_point& x) {
          const std::vector<Exact_rational> monomials = exact_values(x);
          return result = std::inner_product(monomials.begin(), monomials.end(), coefficients.begin(),
                                             Exact_rational(0)) == 0;
        });
      return result;
    });
    return result;
  }

  // Most surfaces have no equation: this tells in no time. The first piece may have one that others do not have, as
  // where coordinates were rounded: points of these are taken as well, as long as they tell something. Coordinates are
  // integers, so that a determinant that is not zero modulo the prime is not zero.
  bool has_no_solution_modulo_prime() const
  {
    using Field = Prime_field_polynomial;
    Prime_field_rows rows;
    const auto add = [&](const Homogeneous_point& x) {
      std::array<Field::Number, d + 1> residues;
      std::transform(x.begin(), x.end(), residues.begin(), Field::residue);
      return rows.add(values(residues, [](Field::Number a, Field::Number b) { return a * b % Field::prime; }));
    };
    const auto is_open = [&] { return rows.rank() < m_monomials.size(); };
    visit_pieces([&](const Piece& piece) {
      visit_points(piece, [&](const Homogeneous_point& x) {
        const bool tells = add(x);
        return is_open() && (tells || piece == Piece{});
      });
      return is_open();
    });
    return !is_open();
  }

  // Calls visit(piece) for all pieces, until it returns false.
  template <class Visit>
  void visit_pieces(const Visit& visit) const
  {
    std::vector<int> last;
    for (const std::vector<Exact_rational>& breaks : m_breaks)
      last.push_back(static_cast<int>(breaks.size()) - 2);
    bool goes_on = true;
    for_each_index(last, [&](const std::vector<int>& index) {
      Piece piece;
      std::copy(index.begin(), index.end(), piece.begin());
      goes_on = goes_on && visit(piece);
    });
  }

  // Calls visit(numerators and weight, as integers) for enough points of a piece, until it returns false.
  template <class Visit>
  void visit_points(const Piece& piece, const Visit& visit) const
  {
    std::array<std::vector<Exact_rational>, axes> parameters;
    std::vector<int> last;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      parameters[axis] = parameters_in(static_cast<int>(axis), piece[axis]);
      last.push_back(static_cast<int>(parameters[axis].size()) - 1);
    }
    bool goes_on = true;
    for_each_index(last, [&](const std::vector<int>& index) {
      if (!goes_on)
        return;
      m_check();
      std::array<Exact_rational, axes> u;
      for (std::size_t axis = 0; axis < axes; ++axis)
        u[axis] = parameters[axis][static_cast<std::size_t>(index[axis])];
      goes_on = visit(point_at(u));
    });
  }

  Homogeneous_point point_at(const std::array<Exact_rational, axes>& u) const
  {
    Homogeneous_point result;
    for (std::size_t i = 0; i < d; ++i)
      result[i] = m_spline.numerators()[i](u);
    result[d] = m_spline.weight()(u);
    for (std::size_t i = 0; i <= d; ++i) {
      const Exact_rational denominator = scaled_rational(denominator_of(result[i]), 0);
      if (denominator != 1)
        for (Exact_rational& x : result)
          x *= denominator;
    }
    return result;
  }

  // Those inside of the piece first, which no other one has.
  std::vector<Exact_rational> parameters_in(int axis, std::size_t piece) const
  {
    int degree = m_spline.weight().degree(axis);
    for (const Exact_function& numerator : m_spline.numerators())
      degree = (std::max)(degree, numerator.degree(axis));
    const std::vector<Exact_rational>& breaks = m_breaks[static_cast<std::size_t>(axis)];
    const Exact_rational &begin = breaks[piece], &end = breaks[piece + 1];
    const int last = (std::max)(1, m_degree * degree);
    std::vector<Exact_rational> result;
    for (int i = 0; i <= last; ++i)
      result.push_back(begin + (end - begin) * Exact_rational((i + last / 2) % (last + 1), last));
    return result;
  }

  std::vector<Exact_rational> exact_values(const Homogeneous_point& x) const
  {
    return values(x, [](const Exact_rational& a, const Exact_rational& b) { return Exact_rational(a * b); });
  }

  // Of the monomials, times w^d.
  template <class Number, class Product>
  std::vector<Number> values(const std::array<Number, d + 1>& x, const Product& product) const
  {
    std::array<std::vector<Number>, d + 1> powers;
    for (std::size_t i = 0; i <= d; ++i) {
      powers[i].push_back(Number(1));
      for (int k = 0; k < m_degree; ++k)
        powers[i].push_back(product(powers[i].back(), x[i]));
    }
    std::vector<Number> result;
    for (const std::array<int, d>& exponents : m_monomials) {
      int rest = m_degree;
      Number value(1);
      for (std::size_t i = 0; i < d; ++i) {
        rest -= exponents[i];
        value = product(value, powers[i][static_cast<std::size_t>(exponents[i])]);
      }
      result.push_back(product(value, powers[d][static_cast<std::size_t>(rest)]));
    }
    return result;
  }

  Power_polynomial polynomial(const std::vector<Exact_rational>& coefficients) const
  {
    Power_polynomial result;
    for (std::size_t m = 0; m < coefficients.size(); ++m) {
      Power_polynomial term(coefficients[m]);
      for (int i = 0; i < d; ++i)
        term *= pow(Power_polynomial::variable(i), m_monomials[m][static_cast<std::size_t>(i)]);
      result += term;
    }
    return result;
  }
};

// The polynomial of the least degree, which is at most four, that is zero on a surface; nothing if there is none:
// planes, quadrics, cubic ruled surfaces, tori and cyclides have one. Nothing if `stops()` before a degree is tried.
template <class Stops>
std::optional<Power_polynomial> implicit_equation(const Spline_patch<3>& surface, const Stops& stops)
{
  constexpr int most = 4;
  for (int degree = 1; degree <= most && !stops(); ++degree)
    if (std::optional<Power_polynomial> result = Implicit_equation(surface, degree)())
      return result;
  return std::nullopt;
}

// A box around a patch; of a flat one also beside it.
template <int d>
std::vector<Parameter_range> box_around(const Spline_patch<d>& patch)
{
  const Vector_bounds<d> values = patch.values();
  Exact_rational extent(0);
  for (const Rational_interval& range : values)
    extent = (std::max)(extent, Exact_rational(range.upper - range.lower));
  std::vector<Parameter_range> result;
  for (const Rational_interval& range : values)
    if (range.lower < range.upper)
      result.emplace_back(range.lower, range.upper);
    else
      result.emplace_back(Exact_rational(range.lower - extent / 2), Exact_rational(range.upper + extent / 2));
  return result;
}

template <int d>
Found_implicit_equation implicit_equation_of(const Exact_map<d>& map, int most_degree, const Solver_options& options)
{
  constexpr int greatest = 20;
  if (most_degree < 1 || most_degree > greatest)
    throw Invalid_input("implicitization: degrees up to " + std::to_string(most_degree) + "; from 1 to " +
                        std::to_string(greatest) + " are possible");
  const Operation_budget budget(options);
  const Spline_patch<d> patch(map);
  if (patch.is_one_point())
    throw Invalid_input("implicitization: all points are the same one");
  Found_implicit_equation result;
  result.box = box_around(patch);
  try {
    for (; result.least_degree <= most_degree; ++result.least_degree) {
      const Implicit_equation equation(patch, result.least_degree, [&] { budget.check(); });
      auto [count, polynomial] = equation.of_all_pieces();
      if (count > 1)
        throw Invalid_input("implicitization: a part of the surface is a curve or a point");
      result.polynomial = std::move(polynomial);
      if (result.polynomial)
        break;
    }
    result.summary.is_complete = true;
  } catch (const Run_stopped& stop) {
    result.summary.is_complete = false;
    result.summary.why_not = stop.reason;
  }
  result.summary.seconds = budget.seconds();
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICITIZATION_IMPLICIT_EQUATION_H
