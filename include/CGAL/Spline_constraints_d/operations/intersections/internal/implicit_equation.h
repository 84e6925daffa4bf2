// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICIT_EQUATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICIT_EQUATION_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Echelon_form.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/patch_cells.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_rows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The polynomial f of a given degree with f(S) = 0, for a surface S = X/w, if there is one up to a factor.

On a piece of S of the degrees (m, n), w^d f(X/w) is a polynomial of the degrees (d m, d n). So f(S) = 0 on the piece if
this holds at d m + 1 times d n + 1 of its points: linear equations for the coefficients of f, which are solved exactly
on the first piece, and f is composed with all of them.
*/
class Implicit_equation
{
  const Spline_patch<3>& m_surface;
  const int m_degree;
  std::vector<std::array<int, 3>> m_monomials;

public:
  Implicit_equation(const Spline_patch<3>& surface, int degree) : m_surface(surface), m_degree(degree)
  {
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k)
          m_monomials.push_back({i, j, k});
  }

  std::optional<Power_polynomial> operator()() const
  {
    if (has_no_solution_modulo_prime())
      return std::nullopt;
    Echelon_form rows;
    visit_points({0, 0}, [&](const std::array<Exact_rational, 4>& x) {
      rows.add(values(x, [](const Exact_rational& a, const Exact_rational& b) { return Exact_rational(a * b); }));
      return rows.rank() < m_monomials.size();
    });
    if (rows.rank() + 1 != m_monomials.size())
      return std::nullopt;
    Power_polynomial result = polynomial(rows.orthogonal_vector(m_monomials.size()));
    return vanishes_everywhere(result) ? std::optional(std::move(result)) : std::nullopt;
  }

private:
  bool vanishes_everywhere(const Power_polynomial& polynomial) const
  {
    bool result = true;
    for_each_cell(m_surface, [&](const Patch_cell& cell) {
      if (result) {
        const auto [least, greatest] = composed(polynomial, m_degree, cell.functions).bounds();
        result = least == 0 && greatest == 0;
      }
    });
    return result;
  }

  // Most surfaces have no equation: this tells in no time. The first piece may have one that others do not have, as
  // where coordinates were rounded: points of these are taken as well, as long as they tell something.
  bool has_no_solution_modulo_prime() const
  {
    using Field = Prime_field_polynomial;
    Prime_field_rows rows;
    using Point = std::array<Exact_rational, 4>;
    const auto is_open = [&] { return rows.rank() < m_monomials.size(); };
    const auto add = [&](const Point& x) {
      std::array<Field::Number, 4> residues;
      std::transform(x.begin(), x.end(), residues.begin(), Field::residue);
      return rows.add(values(residues, [](Field::Number a, Field::Number b) { return a * b % Field::prime; }));
    };
    visit_points({0, 0}, [&](const Point& x) {
      add(x);
      return is_open();
    });
    for (std::size_t i = 0; i + 1 < m_surface.breaks(0).size(); ++i)
      for (std::size_t j = i == 0 ? 1 : 0; j + 1 < m_surface.breaks(1).size() && is_open(); ++j)
        visit_points({i, j}, [&](const Point& x) { return add(x) && is_open(); });
    return !is_open();
  }

  // Calls visit(numerators and weight) for enough points of a piece, until it returns false.
  template <class Visit>
  void visit_points(const std::array<std::size_t, 2>& piece, const Visit& visit) const
  {
    const std::vector<Exact_rational> u = parameters(0, piece[0]), v = parameters(1, piece[1]);
    for (const Exact_rational& x : u)
      for (const Exact_rational& y : v) {
        const std::array parameters{x, y};
        if (!visit({m_surface.numerators()[0](parameters), m_surface.numerators()[1](parameters),
                    m_surface.numerators()[2](parameters), m_surface.weight()(parameters)}))
          return;
      }
  }

  // Those inside of the piece first, which no other one has.
  std::vector<Exact_rational> parameters(int axis, std::size_t piece) const
  {
    int degree = m_surface.weight().degree(axis);
    for (const Exact_function& numerator : m_surface.numerators())
      degree = (std::max)(degree, numerator.degree(axis));
    const std::vector<Exact_rational> breaks = m_surface.breaks(axis);
    const Exact_rational &begin = breaks[piece], &end = breaks[piece + 1];
    const int last = (std::max)(1, m_degree * degree);
    std::vector<Exact_rational> result;
    for (int i = 0; i <= last; ++i)
      result.push_back(begin + (end - begin) * Exact_rational((i + last / 2) % (last + 1), last));
    return result;
  }

  // Of the monomials, times w^d.
  template <class Number, class Product>
  std::vector<Number> values(const std::array<Number, 4>& x, const Product& product) const
  {
    std::array<std::vector<Number>, 4> powers;
    for (std::size_t i = 0; i < 4; ++i) {
      powers[i].push_back(Number(1));
      for (int k = 0; k < m_degree; ++k)
        powers[i].push_back(product(powers[i].back(), x[i]));
    }
    std::vector<Number> result;
    for (const auto& [i, j, k] : m_monomials)
      result.push_back(
          product(product(powers[0][i], powers[1][j]), product(powers[2][k], powers[3][m_degree - i - j - k])));
    return result;
  }

  Power_polynomial polynomial(const std::vector<Exact_rational>& coefficients) const
  {
    Power_polynomial result;
    for (std::size_t m = 0; m < coefficients.size(); ++m) {
      Power_polynomial term(coefficients[m]);
      for (int i = 0; i < 3; ++i)
        term *= pow(Power_polynomial::variable(i), m_monomials[m][i]);
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

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICIT_EQUATION_H
