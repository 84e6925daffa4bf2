// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_EQUAL_POINT_PAIRS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_EQUAL_POINT_PAIRS_H

#include <CGAL/Spline_constraints_d/function/internal/polynomial_composition.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

/*
The equations of the unordered pairs of points P = (u,v), Q = (s,t) of a surface of one polynomial piece with S(P) =
S(Q), P != Q.

P - Q = h d with a direction d and h >= 0, and S(P) - S(Q) = h (d_0 A + d_1 B) with polynomials A and B: the diagonal is
divided out. With a parameter m in [-1,1], d is a half-turn about e; the unknowns are u, v, s, t and m. At h = 0 what is
left is the derivative along d, so that the only solutions are where S_u and S_v are dependent: pinch points, where
curves end.

Lengths are in units of the widths of the domain. e is neither along an axis nor a diagonal: on symmetric surfaces there
are curves with P - Q along one of these, and they would lie where m is at its end; but these directions have rational
parameters.
*/
class Equal_point_pairs
{
  static constexpr std::array<int, 2> e{4, 3};

  std::array<Parameter_range, 4> m_ranges;
  Vector_expression<3> m_difference;   // S(P) - S(Q)
  std::array<Power_polynomial, 2> m_offset;   // P - Q

public:
  explicit Equal_point_pairs(const Spline_patch<3>& patch)
    : m_ranges{patch.domain(0), patch.domain(1), patch.domain(0), patch.domain(1)}, m_difference(difference(patch))
  {
    for (const int axis : {0, 1})
      m_offset[axis] =
          (Power_polynomial::variable(axis) - Power_polynomial::variable(axis + 2)) / Power_polynomial(width(axis));
  }

  Constraint_system_d system() const
  {
    Constraint_system_d result({m_ranges[0], m_ranges[1], m_ranges[2], m_ranges[3], {-1, 1}});
    const Power_polynomial m = Power_polynomial::variable(4), cosine = number(1) - m * m, sine = number(2) * m;
    const std::array<Power_polynomial, 2> d{number(e[0]) * cosine - number(e[1]) * sine,
                                            number(e[1]) * cosine + number(e[0]) * sine};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = divided_differences(numerator_polynomial(m_difference[i]));
      result.add(d[0] * a + d[1] * b, Relation::EQUAL);
    }
    result.add(m_offset[0] * d[1] - m_offset[1] * d[0], Relation::EQUAL);
    result.add(m_offset[0] * d[0] + m_offset[1] * d[1], Relation::GREATER_EQUAL);
    return result;
  }

private:
  static Power_polynomial number(int x) { return Power_polynomial(Exact_rational(x)); }

  Vector_expression<3> difference(const Spline_patch<3>& patch) const
  {
    const std::vector<Unknown> unknowns = unknowns_in({m_ranges.begin(), m_ranges.end()});
    const Parametric_vector<3> point(patch);
    return point(std::span(unknowns).first(2)) - point(std::span(unknowns).subspan(2));
  }

  Exact_rational width(int axis) const { return Exact_rational(m_ranges[axis].second - m_ranges[axis].first); }

  // f(u,v,s,t), which is zero where (u,v) = (s,t), as (u - s) a + (v - t) b in units of the widths: by way of (s,v).
  std::pair<Power_polynomial, Power_polynomial> divided_differences(const Power_polynomial& f) const
  {
    const auto x = [](int i) { return Power_polynomial::variable(i); };
    const Power_polynomial between = composed(f, {x(2), x(1), x(2), x(3)});
    const auto quotient = [&](const Power_polynomial& g, int axis) {
      return *Polynomial_divisor(m_offset[axis]).quotient(g);
    };
    return {quotient(f - between, 0), quotient(between, 1)};
  }
};

// The same of ordered pairs in two cells without common points, u, v, s and t in these ranges.
inline Constraint_system_d equal_points_of(const Spline_patch<3>& patch, const Parameter_box& cells)
{
  Constraint_system_d result(cells);
  const std::vector<Unknown> unknowns = unknowns_in(cells);
  const auto point = [&](std::size_t first) {
    return Parametric_vector<3>(patch.part({cells[first], cells[first + 1]}))(std::span(unknowns).subspan(first, 2));
  };
  const Vector_expression<3> difference = point(0) - point(2);
  for (std::size_t i = 0; i < 3; ++i)
    result.add(difference[i] == 0);
  return result;
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_EQUAL_POINT_PAIRS_H
