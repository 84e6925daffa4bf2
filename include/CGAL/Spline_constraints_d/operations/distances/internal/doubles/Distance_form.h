// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_DISTANCE_FORM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_DISTANCE_FORM_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Rounded_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
The squared distance of two Bezier pieces x/w and y/v with at most two parameters together, as a quotient of Bernstein
polynomials: with points r and s next to them, c = r - s, z = x - r w and u = y - s v,

  |x/w - y/v|^2 = |c|^2 + Q / (w^2 v^2),
  Q = |z|^2 v^2 + |u|^2 w^2 - 2 (z w) (u v) + 2 c ((z w) v^2 - (u v) w^2).

However far the pieces are from each other, no digits of Q are lost.
*/
template <int d>
struct Distance_form
{
  Degrees degrees{0, 0};
  bool is_rational = false;
  double error = 0, weight_error = 0; // of the coefficients of Q and of w^2 v^2
  double greatest = 0, greatest_weight = 1;
  Interval constant; // |c|^2

  // Writes Q, and w^2 v^2 if it is not 1, behind each other at distance `stride`. Rounding has to be upward.
  Distance_form(const Rounded_piece<d>& a, const Rounded_piece<d>& b, double* storage, std::size_t stride)
    : is_rational(a.is_rational() || b.is_rational()), constant(0)
  {
    int axis = 0;
    for (int i = 0; i < a.axes; ++i)
      degrees[axis++] = a.form_degrees[i];
    for (int i = 0; i < b.axes; ++i)
      degrees[axis++] = b.form_degrees[i];
    std::array<double, d> c;
    for (int i = 0; i < d; ++i) {
      const Interval difference = Interval(a.reference[i]) - Interval(b.reference[i]);
      constant += CGAL::square(difference);
      c[i] = a.reference[i] - b.reference[i];
    }
    const std::size_t size_a = size_of(a.form_degrees), size_b = size_of(b.form_degrees);
    for (std::size_t i = 0; i < size_a; ++i)
      for (std::size_t j = 0; j < size_b; ++j, ++storage) {
        const double w = a.is_rational() ? a.weight_square.begin[i] : 1,
                     v = b.is_rational() ? b.weight_square.begin[j] : 1;
        double mixed = 0, offset = 0;
        for (int k = 0; k < d; ++k) {
          const double z = a.linear[k].begin[i], u = b.linear[k].begin[j];
          mixed += z * u;
          offset += c[k] * (z * v - u * w);
        }
        *storage = a.square.begin[i] * v + b.square.begin[j] * w + 2 * (offset - mixed);
        if (is_rational)
          storage[stride] = w * v;
      }
    bound_errors(a, b, c);
  }

private:
  static Rounded_tensor weight_of(const Rounded_piece<d>& piece)
  {
    return piece.is_rational() ? piece.weight_square : Rounded_tensor{nullptr, 0, 1};
  }

  static double error_of_product(const Rounded_tensor& f, const Rounded_tensor& g)
  {
    return f.error * g.greatest + g.error * (f.greatest + f.error);
  }

  void bound_errors(const Rounded_piece<d>& a, const Rounded_piece<d>& b, const std::array<double, d>& c)
  {
    const Rounded_tensor w = weight_of(a), v = weight_of(b);
    error = error_of_product(a.square, v) + error_of_product(b.square, w);
    greatest = a.square.greatest * v.greatest + b.square.greatest * w.greatest;
    for (int k = 0; k < d; ++k) {
      const Rounded_tensor &z = a.linear[k], &u = b.linear[k];
      const double of_c = unit * std::abs(c[k]), offset = z.greatest * v.greatest + u.greatest * w.greatest;
      error += 2 *
          (error_of_product(z, u) + of_c * offset + std::abs(c[k]) * (error_of_product(z, v) + error_of_product(u, w)));
      greatest += 2 * (z.greatest * u.greatest + std::abs(c[k]) * offset);
    }
    greatest *= 1.001;
    error = 1.001 * error + (8 + 4 * d) * unit * greatest;
    weight_error = is_rational ? 1.001 * error_of_product(w, v) + 8 * unit * w.greatest * v.greatest : 0;
    greatest_weight = 1.001 * w.greatest * v.greatest;
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_DISTANCE_FORM_H
