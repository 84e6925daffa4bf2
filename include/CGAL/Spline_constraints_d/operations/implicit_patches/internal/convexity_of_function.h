// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_OF_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_OF_FUNCTION_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Subdivided_simplex.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_finders.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/curvature_forms.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/quadratic_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

/*
The matrix of second derivatives, in coordinates along the edges from vertex 0, is in Bernstein form with matrices A_mu
as coefficients: definite or semidefinite on a part if all of these are so. At the vertices of a part it is a
coefficient, so where that is not semidefinite the function is not convex. For degrees 2 and 3, in which it is constant
and affine, this decides without subdivision.
*/
class Function_shape_finder
{
  Simplex_vertices<3> m_whole;
  Function_shape::Found m_found;
  bool m_is_not_strict = false;

public:
  explicit Function_shape_finder(const Simplex_vertices<3>& whole) : m_whole(whole) {}

  Function_shape operator()(const Simplex_function_3& function, const Solver_options& options)
  {
    Common::Run_of_steps run(options);
    const std::vector<Simplex_part> left = subdivided(
        part_of(function), options, run, [&](Simplex_part& part) { return is_settled(part); },
        [&] { return m_found.against_convexity && m_found.against_concavity && m_is_not_strict; });
    m_found.convexity = {answer_of_parts(m_found.against_convexity.has_value(), 0, left),
                         answer_of_parts(m_found.against_concavity.has_value(), 1, left),
                         answer_of_parts(m_is_not_strict, 2, left)};
    for (const Simplex_part& part : left)
      m_found.undecided.push_back(undecided_part(part, m_whole, run));
    m_found.summary = run.summary(left.empty());
    return Function_shape(std::move(m_found));
  }

private:
  static Simplex_part part_of(const Simplex_function_3& function)
  {
    const auto along = [](const Form& form, int axis) { return form.derivative(0, axis + 1); };
    const std::array<Form, 3> gradient{along(function.form(), 0), along(function.form(), 1), along(function.form(), 2)};
    const std::array<Form, 6> hessian = second_derivatives(gradient, along);
    return {vertices_of_whole(), {hessian.begin(), hessian.end()}, ~0u};
  }

  static Exact_matrix matrix_at(const Simplex_part& part, std::size_t coefficient)
  {
    Exact_matrix result(3);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        result[i].push_back(part.forms[place_of_entry(i, j)].coefficients()[coefficient]);
    return result;
  }

  // In coordinates along the edges of the whole.
  bool is_settled(Simplex_part& part)
  {
    look_at_vertices(part);
    bool is_convex = true, is_concave = true, is_positive = true, is_negative = true;
    for (std::size_t k = 0; k < part.forms[0].coefficients().size(); ++k) {
      const Exact_matrix A = matrix_at(part, k);
      const bool is_singular = CGAL::is_zero(determinant_of_three(A));
      is_convex = is_convex && !negative_direction(A);
      is_concave = is_concave && !negative_direction(negated(A));
      is_positive = is_positive && is_convex && !is_singular;
      is_negative = is_negative && is_concave && !is_singular;
    }
    const bool is_open[] = {!is_convex && !m_found.against_convexity, !is_concave && !m_found.against_concavity,
                            !is_positive && !is_negative && !m_is_not_strict};
    part.open_questions = 0;
    for (int q = 0; q < 3; ++q)
      part.open_questions |= static_cast<unsigned>(is_open[q]) << q;
    return part.open_questions == 0;
  }

  void look_at_vertices(const Simplex_part& part)
  {
    for (int vertex = 0; vertex < 4; ++vertex) {
      Form::Exponents exponents{};
      exponents[vertex] = part.forms[0].degree();
      const Exact_matrix A = matrix_at(part, Form::position_of(exponents));
      const auto down = negative_direction(A), up = negative_direction(negated(A));
      if (down && !m_found.against_convexity)
        m_found.against_convexity = witness(part, vertex, *down);
      if (up && !m_found.against_concavity)
        m_found.against_concavity = witness(part, vertex, *up);
      m_is_not_strict = m_is_not_strict || (down && up) || CGAL::is_zero(determinant_of_three(A));
    }
  }

  Hessian_witness witness(const Simplex_part& part, int vertex, const Exact_vector& along_edges) const
  {
    std::array<Exact_rational, 3> direction{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        direction[axis] += Exact_rational(along_edges[i] * (m_whole[i + 1][axis] - m_whole[0][axis]));
    return {point_of(coordinates_of(m_whole, part.vertices[vertex])), {direction[0], direction[1], direction[2]}};
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Function_shape convexity_of_function(const Simplex_function_3& function,
                                                                    const Solver_options& options)
{
  return Function_shape_finder(function.vertices())(function, options);
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_OF_FUNCTION_H
