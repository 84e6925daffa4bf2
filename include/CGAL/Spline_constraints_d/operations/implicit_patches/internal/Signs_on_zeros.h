// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SIGNS_ON_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SIGNS_ON_ZEROS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Face_signs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

// A function g in points where f is zero is g + m f as well, for any constant m: the one with which it changes least
// across the zeros of f, nearly, in the center of a simplex. f comes in the degree of g.
inline Form nearly_constant_across_zeros(const Form& g, const Form& f)
{
  const auto in_doubles = [](const Form& h) {
    return h.converted<double>([](const Exact_rational& x) { return to_nearest_double(x); });
  };
  const auto rounded_g = in_doubles(g), rounded_f = in_doubles(f);
  const std::array<double, 4> center{0.25, 0.25, 0.25, 0.25};
  double numerator = 0, denominator = 0;
  for (int axis = 1; axis <= 3; ++axis) {
    const double slope = rounded_f.derivative(0, axis)(center);
    numerator -= slope * rounded_g.derivative(0, axis)(center);
    denominator += slope * slope;
  }
  const float few_bits = static_cast<float>(numerator / denominator);
  return std::isfinite(few_bits) ? g + f * to_rational(few_bits) : g;
}

// Signs within faces of what a function is in the zeros of another one.
class Signs_on_zeros
{
  Face_signs m_own, m_changed;
  Face_signs m_rest;

public:
  // `rest` is such that g is 0 in the zeros of f where `rest` is not.
  Signs_on_zeros(const Form& g, const Form& f, const Form& rest)
    : m_own(g), m_changed(m_own[15] == Face_sign::UNKNOWN ? Face_signs(nearly_constant_across_zeros(g, f)) : m_own),
      m_rest(rest)
  {}

  Face_sign operator[](unsigned face) const
  {
    if (m_rest.has_sign(face))
      return Face_sign::ZERO;
    return m_own[face] == Face_sign::UNKNOWN ? m_changed[face] : m_own[face];
  }
};

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SIGNS_ON_ZEROS_H
