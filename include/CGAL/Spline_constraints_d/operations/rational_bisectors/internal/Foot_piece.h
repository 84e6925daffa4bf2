// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_PIECE_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/unit_normal_of_piece.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

using Tensor = Bernstein_tensor<Exact_rational>;

// Of the lowest common degrees.
inline std::vector<Tensor> tensors_of(const std::vector<Power_polynomial>& polynomials)
{
  std::vector<int> degrees(2, 0);
  for (const Power_polynomial& f : polynomials)
    for (const int axis : {0, 1})
      degrees[axis] = (std::max)(degrees[axis], f.degree(axis));
  std::vector<Tensor> result;
  for (const Power_polynomial& f : polynomials)
    result.push_back(tensor_of(f, degrees));
  return result;
}

// The factor by which the values on one side of the unit box differ from those of others on another side, all along it,
// if there is one.
inline std::optional<Exact_rational> ratio_of_sides(const std::vector<Tensor>& a, int side_of_a,
                                                    const std::vector<Tensor>& b, int side_of_b, int axis)
{
  std::optional<Exact_rational> result;
  for (std::size_t f = 0; f < a.size(); ++f) {
    const int degree = (std::max)(a[f].degree(1 - axis), b[f].degree(1 - axis));
    const std::vector<Exact_rational> x = a[f].face(axis, side_of_a).elevated({degree}).coefficients(),
                                      y = b[f].face(axis, side_of_b).elevated({degree}).coefficients();
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] == 0 && y[i] == 0)
        continue;
      if (x[i] == 0 || y[i] == 0 || (result && x[i] != *result * y[i]))
        return std::nullopt;
      result = Exact_rational(x[i] / y[i]);
    }
  }
  return result;
}

/*
Numerators and weight of a piece of a surface X / w, its normal n in the lowest degree, and polynomials of its
curvatures with respect to n. With a = w X_u - w_u X and b = w X_v - w_v X, the first form is that of a and b divided by
w^4, and the second one is

  (w <X_uu,n> - w_uu <X,n>) / (w^2 |n|) and so on;

b1 / (|n| b0) is the sum and b2 / (|n|^2 b0) the product of the principal curvatures. What polynomials have in
common, as at poles of spheres, is divided out, in the end also from numerators and denominators of the square of the
sum and of the product, which are constant for spheres and cylinders.
*/
struct Foot_piece
{
  std::vector<Tensor> coordinates, normal;
  // numerator and denominator of the square of the sum of both curvatures, and of their product; or of the sum and the
  // product times |n| and |n|^2, and the latter
  std::vector<Tensor> squared_sum, product;
  std::vector<Tensor> sign_of_sum; // two factors
  std::vector<Tensor> orientation; // of the cross product of the derivatives, with respect to the normal

  static std::optional<Foot_piece> of(const Homogeneous_polynomials& surface)
  {
    const std::vector<Power_polynomial> cross_product = normal_of(surface);
    if (cross_product[0].is_zero() && cross_product[1].is_zero() && cross_product[2].is_zero())
      return std::nullopt;
    const std::vector<Power_polynomial> normal = oriented_normal(cross_product);
    const Polynomial_vector x{surface[0], surface[1], surface[2]}, n{normal[0], normal[1], normal[2]};
    const Power_polynomial& w = surface[3];
    const auto derivative = [](const Polynomial_vector& f, int axis) {
      return Polynomial_vector{f[0].derivative(axis), f[1].derivative(axis), f[2].derivative(axis)};
    };
    const auto tangent = [&](int axis) { return w * derivative(x, axis) - w.derivative(axis) * x; };
    const auto second = [&](int first, int other) {
      return w * dot(derivative(derivative(x, first), other), n) - w.derivative(first).derivative(other) * dot(x, n);
    };
    const Polynomial_vector a = tangent(0), b = tangent(1);
    const Power_polynomial e = dot(a, a), f = dot(a, b), g = dot(b, b), l = second(0, 0), m = second(0, 1),
                           k = second(1, 1), ww = w * w;
    const std::vector<Power_polynomial> forms = without_common_factors(
        {e * g - f * f, ww * (e * k + g * l - Power_polynomial(2) * f * m), ww * ww * (l * k - m * m)});
    return Foot_piece{tensors_of(surface),
                      tensors_of(normal),
                      quotients({forms[1], forms[0]}, 2, normal),
                      quotients({forms[2], forms[0]}, 1, normal),
                      {tensors_of({forms[1]}).front(), tensors_of({forms[0]}).front()},
                      tensors_of({dot({cross_product[0], cross_product[1], cross_product[2]}, n)})};
  }

private:
  // A power of p / q divided by |n|^2, in the lowest degree; p, q and |n|^2 if that is high.
  static std::vector<Tensor> quotients(const std::vector<Power_polynomial>& quotient, int power,
                                       const std::vector<Power_polynomial>& normal)
  {
    constexpr int greatest_degree = 12;
    const std::vector<Power_polynomial> simple = without_common_factors(quotient);
    const Power_polynomial length = squared_length(normal);
    if (power * simple[1].total_degree() + length.total_degree() <= 2 * greatest_degree) {
      const std::vector<Power_polynomial> all =
          without_common_factors({pow(simple[0], power), pow(simple[1], power) * length});
      if (all[0].total_degree() <= greatest_degree && all[1].total_degree() <= greatest_degree)
        return tensors_of(all);
    }
    std::vector<Tensor> result = tensors_of(simple);
    result.push_back(tensors_of({length}).front());
    return result;
  }
};

// The pieces of a surface, and how many of them there are along both axes.
struct Foot_pieces
{
  std::vector<Foot_piece> pieces;
  std::array<std::size_t, 2> shape;

  //! \pre no piece is a curve.
  static Foot_pieces of(const std::vector<Polynomial_piece>& all, const Operation_budget& budget)
  {
    Foot_pieces result;
    for (const Polynomial_piece& piece : all) {
      budget.check();
      result.pieces.push_back(Foot_piece::of(piece.coordinates).value());
    }
    const auto is_in_first_row = [&](const Polynomial_piece& piece) { return piece.domain[0] == all[0].domain[0]; };
    result.shape[1] = static_cast<std::size_t>(std::ranges::count_if(all, is_in_first_row));
    result.shape[0] = all.size() / result.shape[1];
    return result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_PIECE_H
