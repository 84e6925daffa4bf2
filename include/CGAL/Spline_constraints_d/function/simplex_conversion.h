// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SIMPLEX_CONVERSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SIMPLEX_CONVERSION_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDFunctions
//! the vertices of a simplex, by their coordinates.
template <int d>
using Simplex_vertices = std::array<std::array<Exact_rational, d>, d + 1>;

namespace internal {

template <int d>
[[noreturn]] void throw_flat_simplex()
{
  throw Invalid_input("simplex: vertices 0.." + std::to_string(d) +
                      (d == 1       ? " are equal"
                           : d == 2 ? " are collinear"
                                    : " are coplanar"));
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions
the barycentric coordinates of a point: the numbers with sum 1 such that it is the sum of the vertices times these.
\throws Invalid_input when the simplex is flat.
*/
template <int d>
std::array<Exact_rational, d + 1> barycentric_coordinates(const Simplex_vertices<d>& vertices,
                                                          const std::array<Exact_rational, d>& point)
{
  // Elimination of the unknowns in (x_1 - x_0, ..., x_d - x_0) t = p - x_0.
  std::array<std::array<Exact_rational, d + 1>, d> rows;
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < d; ++j)
      rows[i][j] = vertices[j + 1][i] - vertices[0][i];
    rows[i][d] = point[i] - vertices[0][i];
  }
  for (int column = 0; column < d; ++column) {
    int pivot = column;
    while (pivot < d && CGAL::is_zero(rows[pivot][column]))
      ++pivot;
    if (pivot == d)
      internal::throw_flat_simplex<d>();
    std::swap(rows[pivot], rows[column]);
    for (int i = 0; i < d; ++i) {
      if (i == column || CGAL::is_zero(rows[i][column]))
        continue;
      const Exact_rational factor = rows[i][column] / rows[column][column];
      for (int j = column; j <= d; ++j)
        rows[i][j] -= Exact_rational(factor * rows[column][j]);
    }
  }
  std::array<Exact_rational, d + 1> result;
  result[0] = Exact_rational(1);
  for (int i = 0; i < d; ++i) {
    result[i + 1] = rows[i][d] / rows[i][i];
    result[0] -= result[i + 1];
  }
  return result;
}

namespace internal {

// The simplex of the origin and the unit vectors, and others in its barycentric coordinates.
template <int d>
Simplex_vertices<d> standard_simplex()
{
  Simplex_vertices<d> result;
  for (int i = 0; i <= d; ++i)
    for (int j = 0; j < d; ++j)
      result[i][j] = Exact_rational(i == j + 1 ? 1 : 0);
  return result;
}

template <int d>
std::array<std::array<Exact_rational, d + 1>, d + 1> barycentric_vertices(const Simplex_vertices<d>& simplex,
                                                                          const Simplex_vertices<d>& points)
{
  std::array<std::array<Exact_rational, d + 1>, d + 1> result;
  for (int i = 0; i <= d; ++i)
    result[i] = barycentric_coordinates<d>(simplex, points[i]);
  return result;
}

// Exponents of x_1, ..., x_d as those of barycentric coordinates in a degree.
template <int d>
std::array<int, d + 1> homogeneous_exponents(const Monomial& monomial, int degree)
{
  std::array<int, d + 1> result{};
  result[0] = degree;
  for (const auto& [variable, exponent] : monomial.powers) {
    result[variable + 1] = exponent;
    result[0] -= exponent;
  }
  return result;
}

// From the polar forms of powers of coordinates, with the origin in all other arguments, to those at the vertices
// 0, e_1, ..., e_d: sums with binomial numbers along each axis; or back, with signs.
template <int d>
void sum_with_binomials(std::vector<Exact_rational>& coefficients, int degree, bool is_inverse)
{
  for (int i = 1; i <= d; ++i) {
    std::vector<Exact_rational> sums(coefficients.size(), Exact_rational(0));
    for (Simplex_index<d> index(degree); index.is_valid(); ++index) {
      std::array<int, d + 1> exponents;
      for (int l = 0; l <= d; ++l)
        exponents[l] = index.exponent(l);
      const int total = exponents[i];
      const std::vector<Exact_rational> numbers = binomials<Exact_rational>(total);
      for (int k = 0; k <= total; ++k) {
        exponents[0] = index.exponent(0) + total - k;
        exponents[i] = k;
        const Exact_rational term = numbers[k] * coefficients[Simplex_index<d>::position_of(exponents)];
        if (is_inverse && (total - k) % 2 == 1)
          sums[index.position()] -= term;
        else
          sums[index.position()] += term;
      }
    }
    coefficients = std::move(sums);
  }
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

a polynomial in the unknowns 0, ..., \f$d-1\f$ in Bernstein form on a simplex, in its own total degree: first on the
simplex of the origin and the unit vectors, where the polar forms of monomials are quotients of binomial numbers, then
by the polar form at the vertices.
\throws Invalid_input when the simplex is flat, the polynomial has other unknowns, or a total degree above 30.
*/
template <int d>
Bernstein_simplex<Exact_rational, d> to_bernstein_simplex(const Power_polynomial& polynomial,
                                                          const Simplex_vertices<d>& vertices)
{
  if (!polynomial.is_constant() && polynomial.variables().back() >= d)
    throw Invalid_input("to_bernstein_simplex: unknown " + std::to_string(polynomial.variables().back()) +
                        " in a polynomial of " + std::to_string(d) + " coordinates");
  const int degree = polynomial.total_degree();
  using Simplex = Bernstein_simplex<Exact_rational, d>;
  if (degree > Simplex::maximal_degree)
    throw Invalid_input("to_bernstein_simplex: degree " + std::to_string(degree) + " is above " +
                        std::to_string(Simplex::maximal_degree));
  barycentric_coordinates<d>(vertices, vertices[0]); // whether it is flat
  const std::vector<Exact_rational> numbers = internal::multinomials<Exact_rational, d>(degree);
  std::vector<Exact_rational> coefficients(numbers.size(), Exact_rational(0));
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    const std::size_t i = internal::Simplex_index<d>::position_of(internal::homogeneous_exponents<d>(monomial, degree));
    coefficients[i] = coefficient / numbers[i];
  }
  internal::sum_with_binomials<d>(coefficients, degree, false);
  return Simplex(degree, std::move(coefficients))
      .restricted(internal::barycentric_vertices<d>(internal::standard_simplex<d>(), vertices));
}

/*!
\ingroup PkgSplineConstraintsDFunctions
the polynomial in the unknowns 0, ..., \f$d-1\f$ that has this Bernstein form on a simplex.
\throws Invalid_input when the simplex is flat.
*/
template <int d>
Power_polynomial to_power_polynomial(const Bernstein_simplex<Exact_rational, d>& form,
                                     const Simplex_vertices<d>& vertices)
{
  const auto on_standard_simplex =
      form.restricted(internal::barycentric_vertices<d>(vertices, internal::standard_simplex<d>()));
  std::vector<Exact_rational> coefficients = on_standard_simplex.coefficients();
  internal::sum_with_binomials<d>(coefficients, form.degree(), true);
  const std::vector<Exact_rational> numbers = internal::multinomials<Exact_rational, d>(form.degree());
  Power_polynomial result;
  for (internal::Simplex_index<d> index(form.degree()); index.is_valid(); ++index) {
    Power_polynomial term(Exact_rational(coefficients[index.position()] * numbers[index.position()]));
    for (int i = 1; i <= d; ++i)
      term *= pow(Power_polynomial::variable(i - 1), index.exponent(i));
    result += std::move(term);
  }
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SIMPLEX_CONVERSION_H
