// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_WITNESS_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_WITNESS_FINDER_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Patch_shape.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Subdivided_simplex.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/common_factors.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/curvature_forms.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/quadratic_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

/*
Segments with a point of the patch, on which the second derivative of f along t = grad f x c has one sign. A rational c
is found in a rational point m next to the patch: where the first coordinate of the gradient is not zero, the vectors
grad f x e_1 and grad f x e_2 are a basis of the directions orthogonal to it, and so on; in that basis the form is a
matrix of two rows. The sign on all of the segment is that of the coefficients of t^T H t there, and the segment is
halved, with the change of sign of f, until they tell.
*/
class Witness_finder
{
  using Barycentric = Form::Barycentric;
  using Vector = std::array<Exact_rational, 3>;

  const Simplex_function_3& m_function;
  std::array<Form, 3> m_gradient;
  std::array<Form, 6> m_hessian;

public:
  explicit Witness_finder(const Simplex_function_3& function)
    : m_function(function), m_gradient{function.derivative(0), function.derivative(1), function.derivative(2)},
      m_hessian(second_derivatives(m_gradient, [&](const Form& form, int axis) {
        return Simplex_function_3(function.vertices(), form).derivative(axis);
      }))
  {}

  // \pre At the point of the patch on the segment the second derivative has this sign, not zero, along some tangent; f
  // has opposite signs at the ends, or is 0 in all of the segment.
  Curvature_witness operator()(Barycentric first, Barycentric second, CGAL::Sign sign) const
  {
    if (CGAL::sign(value(first)) == CGAL::POSITIVE)
      std::swap(first, second);
    if (CGAL::is_zero(value(first)))
      second = first;
    for (int bits = 8;; ++bits) {
      const Barycentric middle = half_sum(first, second);
      if (first != second && CGAL::is_zero(value(middle)))
        first = second = middle;
      if (const std::optional<Vector> axis = axis_at(middle, sign))
        for (const Vector& candidate : {rounded(*axis, bits), *axis})
          if (has_sign_on(first, second, candidate, sign))
            return {point_of(coordinates_of(m_function.vertices(), first)),
                    point_of(coordinates_of(m_function.vertices(), second)),
                    {candidate[0], candidate[1], candidate[2]}};
      if (first != second)
        (CGAL::sign(value(middle)) == CGAL::POSITIVE ? second : first) = middle;
    }
  }

private:
  Exact_rational value(const Barycentric& p) const { return m_function.form()(p); }

  static Barycentric half_sum(const Barycentric& a, const Barycentric& b)
  {
    Barycentric result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = Number_traits<Exact_rational>::half_sum(a[i], b[i]);
    return result;
  }

  template <class Ring>
  static std::array<Ring, 3> cross(const std::array<Ring, 3>& g, const Vector& c)
  {
    return {Ring(g[1] * c[2]) - Ring(g[2] * c[1]), Ring(g[2] * c[0]) - Ring(g[0] * c[2]),
            Ring(g[0] * c[1]) - Ring(g[1] * c[0])};
  }

  template <class Ring>
  static Ring form_of(const std::array<Ring, 6>& H, const std::array<Ring, 3>& u, const std::array<Ring, 3>& v)
  {
    Ring result = Ring(H[0] * Ring(u[0] * v[0]));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (i + j > 0)
          result += Ring(H[place_of_entry(i, j)] * Ring(u[i] * v[j]));
    return result;
  }

  std::optional<Vector> axis_at(const Barycentric& tau, CGAL::Sign sign) const
  {
    std::array<Exact_rational, 3> g;
    std::array<Exact_rational, 6> H;
    for (std::size_t i = 0; i < 3; ++i)
      g[i] = m_gradient[i](tau);
    for (std::size_t i = 0; i < 6; ++i)
      H[i] = m_hessian[i](tau);
    for (std::size_t i = 0; i < 3; ++i) {
      if (CGAL::is_zero(g[i]))
        continue;
      std::array<Vector, 2> axes{};
      std::array<std::array<Exact_rational, 3>, 2> tangents;
      for (std::size_t k = 0; k < 2; ++k) {
        axes[k][(i + k + 1) % 3] = Exact_rational(1);
        tangents[k] = cross(g, axes[k]);
      }
      Exact_matrix A(2);
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t l = 0; l < 2; ++l)
          A[k].push_back(form_of(H, tangents[k], tangents[l]));
      const auto direction = negative_direction(sign == CGAL::NEGATIVE ? A : negated(A));
      if (!direction)
        return std::nullopt;
      Vector result{};
      for (std::size_t k = 0; k < 2; ++k)
        result[(i + k + 1) % 3] = (*direction)[k];
      return result;
    }
    return std::nullopt;
  }

  // Divided by its largest coordinate, to so many bits.
  static Vector rounded(const Vector& x, int bits)
  {
    const int digits = (std::min)(bits, 50);
    std::array<double, 3> y;
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = to_nearest_double(x[i]);
      largest = (std::max)(largest, std::abs(y[i]));
    }
    if (!std::isfinite(largest) || largest == 0)
      return x;
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = to_rational(std::ldexp(std::nearbyint(std::ldexp(y[i] / largest, digits)), -digits));
    return result;
  }

  bool has_sign_on(const Barycentric& first, const Barycentric& second, const Vector& axis, CGAL::Sign sign) const
  {
    const std::array<Barycentric, 2> ends{first, second};
    std::array<Edge_form, 3> g;
    std::array<Edge_form, 6> H;
    for (std::size_t i = 0; i < 3; ++i)
      g[i] = m_gradient[i].restricted(ends);
    for (std::size_t i = 0; i < 6; ++i)
      H[i] = m_hessian[i].restricted(ends);
    const std::array<Edge_form, 3> tangent = cross(g, axis);
    return CGAL::certainly(form_of(H, tangent, tangent).sign() == sign);
  }
};

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_WITNESS_FINDER_H
