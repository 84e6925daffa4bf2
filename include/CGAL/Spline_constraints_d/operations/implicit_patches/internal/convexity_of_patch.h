// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_OF_PATCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_OF_PATCH_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Signs_on_zeros.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Subdivided_simplex.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Witness_finder.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/common_factors.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_finders.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/curvature_forms.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/singular_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

// What is asked of a patch.
enum Patch_question
{
  IS_CONVEX,
  IS_CONCAVE,
  IS_STRICT,
  IS_REGULAR,
  number_of_questions
};
using Patch_answers = std::array<bool, number_of_questions>;

/*
The form d^T H d on tangents is positive definite exactly where E2 > 0 and E1 > 0, positive semidefinite where E2 >= 0
and E1 >= 0, see curvature_forms.h. The tetrahedron is cut until for each face of each part, without its boundary, the
coefficients tell that it has no point of the patch, or which signs E2 and E1 have. Where f is zero on all of a face, a
vertex for instance, or an edge has ends on both sides, there is a point of the patch, and signs refute.
*/
class Patch_shape_finder
{
  const Simplex_function_3& m_function;
  Form m_form; // of the function, divided by a power of two
  Patch_shape::Found m_found;
  Patch_answers m_is_refuted{};
  bool m_has_points = false;
  int m_attempts = 32; // to find a singular point

  // Functions of a part: the one itself, also in the degrees of E2 and E1; these; rests, see whole().
  enum Function
  {
    VALUE,
    GAUSSIAN,
    GAUSSIAN_VALUE,
    GAUSSIAN_REST,
    MEAN,
    MEAN_VALUE,
    MEAN_REST
  };

  // Of a face.
  struct Signs
  {
    Face_sign gaussian, mean;
  };

public:
  explicit Patch_shape_finder(const Simplex_function_3& function)
    : m_function(function), m_form(scaled_to_one(function.form()))
  {}

  Patch_shape operator()(const Solver_options& options)
  {
    Common::Run_of_steps run(options);
    check();
    const std::vector<Simplex_part> left = subdivided(
        whole(), options, run, [&](Simplex_part& part) { return is_settled(part); },
        [&] { return has_singular_point() || is_neither(); });
    tell(left, run);
    return Patch_shape(std::move(m_found));
  }

private:
  bool has_singular_point() const { return m_found.singular_point.has_value(); }
  bool is_neither() const { return m_is_refuted[IS_CONVEX] && m_is_refuted[IS_CONCAVE]; }

  void check() const
  {
    const auto [least, greatest] = m_function.form().bounds();
    if (least == greatest)
      throw Invalid_input("patch_convexity: the function is constant");
    constexpr int greatest_degree = 8; // for which curvatures are formed in tenths of seconds
    if (m_form.degree() > greatest_degree)
      throw Invalid_input("patch_convexity: degree " + std::to_string(m_form.degree()) + " is above " +
                          std::to_string(greatest_degree));
  }

  // The function with E2 and E1, in coordinates along the edges from vertex 0. If E2 and f have a common factor h, E2
  // is zero on the zeros of h, which are all of the patch where f / h has a sign; the same of E1.
  Simplex_part whole() const
  {
    const Form form = m_form.elevated((std::max)(m_form.degree(), 2));
    const auto along = [](const Form& f, int axis) { return f.derivative(0, axis + 1); };
    const std::array<Form, 3> gradient{along(form, 0), along(form, 1), along(form, 2)};
    const std::array<Form, 6> hessian = second_derivatives(gradient, along);
    const auto [gaussian, mean] = curvature_forms(gradient, hessian);

    std::array<Edge_form, 3> gradient_on_line;
    std::array<Edge_form, 6> hessian_on_line;
    for (std::size_t i = 0; i < 3; ++i)
      gradient_on_line[i] = gradient[i].restricted(some_line());
    for (std::size_t i = 0; i < 6; ++i)
      hessian_on_line[i] = hessian[i].restricted(some_line());
    const auto on_line = curvature_forms(gradient_on_line, hessian_on_line);
    return {vertices_of_whole(),
            {form, gaussian, form.elevated(gaussian.degree()), rest(gaussian, on_line.gaussian), mean,
             form.elevated((std::max)(mean.degree(), form.degree())), rest(mean, on_line.mean)},
            ~0u};
  }

  // f without what it has in common with another function, which comes with its restriction to a line; 0 if that is
  // nothing.
  Form rest(const Form& other, const Edge_form& on_line) const
  {
    if (have_no_common_factor(m_form.restricted(some_line()), on_line))
      return Form();
    const Simplex_vertices<3> unit = standard_simplex<3>();
    const Power_polynomial f = to_power_polynomial<3>(m_form, unit), g = to_power_polynomial<3>(other, unit);
    if (g.is_zero())
      return Form::constant(Exact_rational(1));
    const auto common = common_factor({f, g});
    return common ? to_bernstein_simplex<3>(common->cofactors[0], unit) : Form();
  }

  bool is_settled(Simplex_part& part)
  {
    Patch_answers is_settled;
    is_settled.fill(true);
    const Face_signs values(part.forms[VALUE]);
    if (values.has_sign(15) && values.has_sign(1) && values.has_sign(2) && values.has_sign(4) && values.has_sign(8))
      return true; // there are points of the patch in no face: each has a vertex whose coefficient is not 0
    const Signs_on_zeros gaussian(part.forms[GAUSSIAN], part.forms[GAUSSIAN_VALUE], part.forms[GAUSSIAN_REST]),
        mean(part.forms[MEAN], part.forms[MEAN_VALUE], part.forms[MEAN_REST]);
    const std::vector<Face_signs> derivatives = signs_of_derivatives(part.forms[VALUE]);
    for (unsigned face = 1; face < 16; ++face) {
      if (values.has_sign(face))
        continue;
      const Signs signs{gaussian[face], mean[face]};
      const bool has_gradient = std::any_of(derivatives.begin(), derivatives.end(),
                                            [&](const Face_signs& signs) { return signs.has_sign(face); });
      if (has_point(values, face))
        refute(part, face, signs, has_gradient);
      settle(signs, has_gradient, is_settled);
    }
    if (!is_settled[IS_REGULAR])
      look_for_singular_point(part);
    part.open_questions = 0;
    for (int q = 0; q < number_of_questions; ++q)
      if (!is_settled[q] && !m_is_refuted[q])
        part.open_questions |= 1u << q;
    return part.open_questions == 0;
  }

  static std::vector<Face_signs> signs_of_derivatives(const Form& form)
  {
    std::vector<Face_signs> result;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        result.emplace_back(form.derivative(i, j));
    return result;
  }

  // Whether it is certain that there is a point of the patch within a face.
  static bool has_point(const Face_signs& values, unsigned face)
  {
    if (values[face] == Face_sign::ZERO)
      return true;
    const unsigned first = face & (~face + 1);
    return is_edge(face) && values.has_sign(first) && values.has_sign(face & ~first) &&
        values[first] != values[face & ~first];
  }

  static void settle(const Signs& signs, bool has_gradient, Patch_answers& is_settled)
  {
    const auto is_one_of = [](Face_sign sign, Face_sign a, Face_sign b) { return sign == a || sign == b; };
    const bool is_semidefinite = is_one_of(signs.gaussian, Face_sign::POSITIVE, Face_sign::ZERO);
    const Patch_answers own{is_semidefinite && is_one_of(signs.mean, Face_sign::POSITIVE, Face_sign::ZERO),
                            is_semidefinite && is_one_of(signs.mean, Face_sign::NEGATIVE, Face_sign::ZERO),
                            signs.gaussian == Face_sign::POSITIVE,
                            has_gradient || is_one_of(signs.gaussian, Face_sign::POSITIVE, Face_sign::NEGATIVE) ||
                                is_one_of(signs.mean, Face_sign::POSITIVE, Face_sign::NEGATIVE)};
    for (int q = 0; q < number_of_questions; ++q)
      is_settled[q] = is_settled[q] && own[q];
  }

  // By a face that has a point of the patch.
  void refute(const Simplex_part& part, unsigned face, const Signs& signs, bool has_gradient)
  {
    m_has_points = true;
    if (!has_gradient && (face & (face - 1)) == 0)
      look_for_singular_point_at_vertex(part, face);
    const auto [first, second] = ends_of_face(part.vertices, face);
    const bool is_saddle = signs.gaussian == Face_sign::NEGATIVE;
    if (is_saddle || signs.mean == Face_sign::NEGATIVE)
      refute_by(IS_CONVEX, m_found.against_convexity, first, second, CGAL::NEGATIVE);
    if (is_saddle || signs.mean == Face_sign::POSITIVE)
      refute_by(IS_CONCAVE, m_found.against_concavity, first, second, CGAL::POSITIVE);
    if ((is_saddle || signs.gaussian == Face_sign::ZERO) && !m_is_refuted[IS_STRICT]) {
      m_is_refuted[IS_STRICT] = true;
      if (!is_saddle)
        m_found.against_strictness = {point_of(first), point_of(second)};
    }
  }

  void refute_by(Patch_question question, std::optional<Curvature_witness>& witness, const Form::Barycentric& first,
                 const Form::Barycentric& second, CGAL::Sign sign)
  {
    if (m_is_refuted[question])
      return;
    m_is_refuted[question] = true;
    witness = Witness_finder(m_function)(first, second, sign);
  }

  // Of an edge its ends, and of others, where f is zero, the center.
  static std::array<Form::Barycentric, 2> ends_of_face(const std::array<Form::Barycentric, 4>& vertices, unsigned face)
  {
    std::vector<Form::Barycentric> corners;
    for (int i = 0; i < 4; ++i)
      if ((face >> i & 1) != 0)
        corners.push_back(vertices[i]);
    if (corners.size() == 2)
      return {corners[0], corners[1]};
    Form::Barycentric center{};
    for (int k = 0; k < 4; ++k) {
      for (const auto& corner : corners)
        center[k] += corner[k];
      center[k] /= Exact_rational(static_cast<int>(corners.size()));
    }
    return {center, center};
  }

  void look_for_singular_point_at_vertex(const Simplex_part& part, unsigned vertex)
  {
    for (int i = 0; i < 4; ++i)
      if (vertex == 1u << i && is_singular_point(m_form, part.vertices[i]))
        m_found.singular_point = point_of(part.vertices[i]);
  }

  void look_for_singular_point(const Simplex_part& part)
  {
    if (has_singular_point() || m_attempts == 0)
      return;
    --m_attempts;
    if (const auto found = rational_singular_point(m_form, ends_of_face(part.vertices, 15)[0]))
      m_found.singular_point = point_of(*found);
  }

  Exact_kernel::Point_3 point_of(const Form::Barycentric& tau) const
  {
    return Implicit_patches::point_of(coordinates_of(m_function.vertices(), tau));
  }

  void tell(const std::vector<Simplex_part>& left, const Common::Run_of_steps& run)
  {
    // Then not all parts were looked at.
    const bool has_ended_early = has_singular_point() || is_neither();
    const auto answer = [&](Patch_question question) {
      return has_ended_early && !m_is_refuted[question] ? CGAL::Uncertain<bool>::indeterminate()
                                                        : answer_of_parts(m_is_refuted[question], question, left);
    };
    m_found.convexity = {answer(IS_CONVEX), answer(IS_CONCAVE), answer(IS_STRICT)};
    m_found.is_regular = has_singular_point() ? CGAL::Uncertain<bool>(false) : answer(IS_REGULAR);
    m_found.is_empty = CGAL::Uncertain<bool>(false);
    if (!m_has_points && !has_singular_point())
      m_found.is_empty = left.empty() ? CGAL::Uncertain<bool>(true) : CGAL::Uncertain<bool>::indeterminate();
    for (const Simplex_part& part : left) {
      m_found.tetrahedra.push_back(tetrahedron_of(part, m_function.vertices()));
      m_found.undecided.push_back(undecided_part(part, m_function.vertices(), run));
    }
    m_found.summary = run.summary(left.empty());
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Patch_shape convexity_of_patch(const Simplex_function_3& function,
                                                              const Solver_options& options)
{
  return Patch_shape_finder(function)(options);
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_OF_PATCH_H
