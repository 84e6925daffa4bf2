// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_FACE_SIGNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_FACE_SIGNS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

using Form = Bernstein_simplex<Exact_rational, 3>;

// Divided by a power of two, so that the greatest coefficient is near to 1: doubles next to coefficients, and to those
// of products, are finite.
inline Form scaled_to_one(const Form& form)
{
  const auto [least, greatest] = form.bounds();
  const Exact_rational largest = (std::max)(Exact_rational(-least), greatest);
  if (CGAL::is_zero(largest))
    return form;
  Exact_rational factor(1);
  Number_traits<Exact_rational>::scale_by_power_of_two(
      factor, static_cast<int>(bit_length(denominator_of(largest)) - bit_length(numerator_of(largest))));
  return form * factor;
}

// What coefficients tell of a function within a face: on the points whose barycentric coordinates of the vertices of
// the face are positive, and no others.
enum class Face_sign
{
  ZERO,
  POSITIVE,
  NEGATIVE,
  UNKNOWN
};

/*
For all 15 faces of a tetrahedron, which are sets of vertices as bits. Within a face all Bernstein polynomials of its
vertices are positive. So the function is positive there if a coefficient is, and none negative, and zero if all are.
*/
class Face_signs
{
  static constexpr int number_of_sets = 16;

  std::array<bool, number_of_sets> m_has_positive{}, m_has_negative{};

public:
  explicit Face_signs(const Form& form)
  {
    for (Simplex_index<3> index(form.degree()); index.is_valid(); ++index) {
      const CGAL::Sign sign = CGAL::sign(form.coefficients()[index.position()]);
      if (sign != CGAL::ZERO)
        (sign == CGAL::POSITIVE ? m_has_positive : m_has_negative)[index.support()] = true;
    }
    for (unsigned vertex = 1; vertex < number_of_sets; vertex *= 2)
      for (unsigned face = 1; face < number_of_sets; ++face)
        if ((face & vertex) != 0) {
          m_has_positive[face] = m_has_positive[face] || m_has_positive[face & ~vertex];
          m_has_negative[face] = m_has_negative[face] || m_has_negative[face & ~vertex];
        }
  }

  Face_sign operator[](unsigned face) const
  {
    if (m_has_positive[face])
      return m_has_negative[face] ? Face_sign::UNKNOWN : Face_sign::POSITIVE;
    return m_has_negative[face] ? Face_sign::NEGATIVE : Face_sign::ZERO;
  }

  bool has_sign(unsigned face) const
  {
    return (*this)[face] == Face_sign::POSITIVE || (*this)[face] == Face_sign::NEGATIVE;
  }
};

// Whether a face is an edge.
constexpr bool is_edge(unsigned face)
{
  const unsigned rest = face & (face - 1);
  return rest != 0 && (rest & (rest - 1)) == 0;
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_FACE_SIGNS_H
