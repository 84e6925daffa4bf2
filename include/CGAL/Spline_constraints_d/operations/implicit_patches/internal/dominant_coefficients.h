// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_DOMINANT_COEFFICIENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_DOMINANT_COEFFICIENTS_H

#include <CGAL/Spline_constraints_d/function/internal/simplex/Simplex_index.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

using Form = Simplex_function_3::Form;

// A linear function of the coefficients, by their places.
using Coefficient_sum = std::map<std::size_t, Exact_rational>;

// Adds the coefficient with the exponents mu of the second derivative along two axes, times a constant.
inline void add_entry(Coefficient_sum& sum, const Simplex_function_3& function, const Form::Exponents& mu,
                      int first_axis, int second_axis, int factor)
{
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Exact_rational weight = function.direction(first_axis)[i] * function.direction(second_axis)[j];
      Form::Exponents exponents = mu;
      ++exponents[i];
      ++exponents[j];
      if (!CGAL::is_zero(weight))
        sum[Form::position_of(exponents)] += Exact_rational(factor * weight);
    }
}

// What is not negative where all these matrices are diagonally dominant: with a for the diagonal entry of a row, and b
// and c for the others, a + b + c, a + b - c, a - b + c and a - b - c.
inline std::vector<Coefficient_sum> conditions_of_dominance(const Simplex_function_3& function)
{
  std::vector<Coefficient_sum> result;
  for (Simplex_index<3> index(function.form().degree() - 2); index.is_valid(); ++index) {
    const Form::Exponents mu{index.exponent(0), index.exponent(1), index.exponent(2), index.exponent(3)};
    for (int row = 0; row < 3; ++row)
      for (const int first : {1, -1})
        for (const int second : {1, -1}) {
          Coefficient_sum& sum = result.emplace_back();
          add_entry(sum, function, mu, row, row, 1);
          add_entry(sum, function, mu, row, (row + 1) % 3, first);
          add_entry(sum, function, mu, row, (row + 2) % 3, second);
        }
  }
  return result;
}

// The unknowns of the program are the changes of the coefficients.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Simplex_function_3>
nearest_dominant_function(const Simplex_function_3& function, const std::vector<Form::Exponents>& fixed)
{
  const Form& form = function.form();
  if (form.degree() > 3)
    throw Invalid_input("nearby_convex_function: degree " + std::to_string(form.degree()) + " is above 3");
  if (form.degree() < 2)
    return function;
  CGAL::Quadratic_program<CGAL::Gmpq> program(CGAL::LARGER, false, 0, false, 0);
  for (std::size_t i = 0; i < form.coefficients().size(); ++i)
    program.set_d(static_cast<int>(i), static_cast<int>(i), 2);
  for (const Form::Exponents& exponents : fixed) {
    int sum = 0;
    for (const int exponent : exponents) {
      if (exponent < 0)
        throw Invalid_input("nearby_convex_function: a negative exponent of a fixed coefficient");
      sum += exponent;
    }
    if (sum != form.degree())
      throw Invalid_input("nearby_convex_function: exponents of a fixed coefficient have the sum " +
                          std::to_string(sum) + " in degree " + std::to_string(form.degree()));
    const int place = static_cast<int>(Form::position_of(exponents));
    program.set_l(place, true, 0);
    program.set_u(place, true, 0);
  }
  int row = 0;
  for (const Coefficient_sum& condition : conditions_of_dominance(function)) {
    Exact_rational present(0);
    for (const auto& [place, factor] : condition) {
      program.set_a(static_cast<int>(place), row, converted_number<CGAL::Gmpq>(factor));
      present += Exact_rational(factor * form.coefficients()[place]);
    }
    program.set_b(row++, converted_number<CGAL::Gmpq>(Exact_rational(-present)));
  }
  const auto solution = CGAL::solve_quadratic_program(program, CGAL::Gmpq());
  if (solution.is_infeasible())
    return std::nullopt;
  std::vector<Exact_rational> coefficients = form.coefficients();
  auto change = solution.variable_values_begin();
  for (Exact_rational& x : coefficients) {
    const CGAL::Gmpq quotient = change->numerator() / change->denominator();
    x += converted_number<Exact_rational>(quotient);
    ++change;
  }
  return Simplex_function_3(function.vertices(), Form(form.degree(), std::move(coefficients)));
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_DOMINANT_COEFFICIENTS_H
