// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CONIC_STRUCTURE_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CONIC_STRUCTURE_TEST_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_polynomials.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Isolated_zero_test.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline Exact_ranges as_box(const Exact_point& point)
{
  Exact_ranges result;
  for (const Exact_rational& x : point)
    result.emplace_back(x, x);
  return result;
}

/*
Proves that the solutions in a box are branches between a rational singular point p and the boundary of the box, and
nothing else, whatever the order of the singularity.

Let |x - p|^2 = sum (x_j - p_j)^2 / w_j^2, and t the tangent of the curves by the minors. If p is the only solution in
the box with t . grad |x - p|^2 = 0, then the solutions but for p are regular, and along each connected piece of them
the distance from p increases or decreases strictly. So there is no closed curve, and no piece with both ends in p. If
the curves cross the boundary of the box in some points, all regular and in one face only, and in each of them the
distance from p decreases into the box, then every piece has just one end there, and the other one in p: one piece for
each of these points.

p is the only such solution in a small neighbourhood, if the singular point is isolated: algebraic sets are cones
locally, with |x - p| for the distance from the apex (J. Milnor, Singular Points of Complex Hypersurfaces,
1968, section 2).
*/
class Conic_structure_test
{
  Exact_point m_point;
  std::vector<Power_polynomial> m_equations, m_tangent;   // in the differences from the point
  Power_polynomial m_growth;   // of half the square of the distance, along the tangent
  Exact_ranges m_region;       // where it is zero in the point only

public:
  // A singular point, and the lengths w.
  Conic_structure_test(const Curve_polynomials& curves, const Exact_point& point, const std::vector<double>& lengths)
    : m_point(point), m_equations(all_centred(curves.equations(), point)),
      m_tangent(all_centred(curves.tangent(), point)), m_growth(growth(m_tangent, lengths)), m_region(as_box(point))
  {
    const Isolated_zero_test test(with(m_equations, m_growth), point.size());
    for (double share = 0x1p-2; share >= 0x1p-12; share /= 2) {
      std::vector<Exact_rational> distances;
      for (const double length : lengths)
        distances.emplace_back(share * length);
      if (test.is_alone_in(distances)) {
        for (std::size_t j = 0; j < point.size(); ++j)
          m_region[j] = {Exact_rational(point[j] - distances[j]), Exact_rational(point[j] + distances[j])};
        return;
      }
    }
  }

  const Exact_point& point() const { return m_point; }

  // A box around the point, in which no other point of the curves is singular, or has a tangent that is orthogonal to
  // the direction from the point.
  const Exact_ranges& region() const { return m_region; }

  // Whether the distance from the point decreases into a box, by proof, where a curve crosses the face at a value of an
  // unknown.
  bool approaches(const Exact_ranges& crossing, int unknown, bool is_upper_face) const
  {
    const Mpfr_precision_scope precision(128);
    std::vector<Mpfr_interval> place;
    for (std::size_t j = 0; j < m_point.size(); ++j)
      place.emplace_back(Exact_rational(crossing[j].first - m_point[j]),
                         Exact_rational(crossing[j].second - m_point[j]));
    const CGAL::Uncertain<CGAL::Sign>
        growth = m_growth.value(std::span<const Mpfr_interval>(place)).sign(),
        tangent = m_tangent[static_cast<std::size_t>(unknown)].value(std::span<const Mpfr_interval>(place)).sign();
    return CGAL::is_certain(growth) && CGAL::is_certain(tangent) &&
        CGAL::get_certain(growth) * CGAL::get_certain(tangent) == (is_upper_face ? CGAL::POSITIVE : CGAL::NEGATIVE);
  }

  // Whether a function is zero at the point, and at no other solution in a box.
  bool is_only_zero_of(const Power_polynomial& function, const Exact_ranges& box) const
  {
    return CGAL::is_zero(function(m_point)) &&
        Isolated_zero_test(with(m_equations, centred(function, m_point)), m_point.size()).is_alone_in(distances(box));
  }

private:
  static std::vector<Power_polynomial> all_centred(std::vector<Power_polynomial> polynomials, const Exact_point& point)
  {
    for (Power_polynomial& polynomial : polynomials)
      polynomial = centred(std::move(polynomial), point);
    return polynomials;
  }

  static std::vector<Power_polynomial> with(std::vector<Power_polynomial> polynomials, const Power_polynomial& other)
  {
    polynomials.push_back(other);
    return polynomials;
  }

  // The lengths are changed a little: any will do, but with simple ratios the sum might be zero along a complex branch,
  // as x^2 + y^2 is for x^3 + x y^2.
  static Power_polynomial growth(const std::vector<Power_polynomial>& tangent, const std::vector<double>& lengths)
  {
    Power_polynomial result;
    for (std::size_t j = 0; j < tangent.size(); ++j)
      result += Power_polynomial(Exact_rational(power_of_two(-2 * std::ilogb(lengths[j])) *
                                                Exact_rational(static_cast<int>(16 + 3 * j), 16))) *
          Power_polynomial::variable(static_cast<int>(j)) * tangent[j];
    return result;
  }

  std::vector<Exact_rational> distances(const Exact_ranges& box) const
  {
    std::vector<Exact_rational> result;
    for (std::size_t j = 0; j < box.size(); ++j)
      result.push_back(
          (std::max)(Exact_rational(m_point[j] - box[j].first), Exact_rational(box[j].second - m_point[j])));
    const Exact_rational largest = *std::max_element(result.begin(), result.end());
    for (Exact_rational& distance : result)
      if (CGAL::is_zero(distance))
        distance = largest;   // a larger box, with a volume
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CONIC_STRUCTURE_TEST_H
