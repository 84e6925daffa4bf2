// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's exact bivariate algebraic kernel on the polynomials C1(t) - C2(s), with integer coefficients.
#include "curve_intersection.h"

#include <CGAL/Algebraic_kernel_d_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <iterator>
#include <utility>
#include <vector>

namespace peers {
namespace {

using Kernel = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;
using Polynomial_1 = Kernel::Polynomial_1;
using Polynomial_2 = Kernel::Polynomial_2;

// The power coefficients of a coordinate: b_i -> sum_i (-1)^(k-i) C(d,k) C(k,i) b_i.
std::vector<CGAL::Gmpq> power_coefficients(const Bezier_curve& curve, double Control_point::*axis)
{
  std::vector<CGAL::Gmpq> result;
  for (const Control_point& p : curve)
    result.emplace_back(p.*axis);
  const int degree = static_cast<int>(curve.size()) - 1;
  for (int r = 1; r <= degree; ++r)   // differences
    for (int k = degree; k >= r; --k)
      result[k] -= result[k - 1];
  CGAL::Gmpq binomial(1);
  for (int k = 1; k <= degree; ++k) {
    binomial *= CGAL::Gmpq(degree - k + 1, k);
    result[k] *= binomial;
  }
  return result;
}

// p(t) - q(s), times the common denominator.
Polynomial_2 difference(const std::vector<CGAL::Gmpq>& p, const std::vector<CGAL::Gmpq>& q)
{
  CGAL::Gmpz denominator(1);
  for (const auto* coefficients : {&p, &q})
    for (const CGAL::Gmpq& c : *coefficients)
      denominator *= CGAL::integral_division(c.denominator(), CGAL::gcd(denominator, c.denominator()));
  const auto integer = [&](const CGAL::Gmpq& c) {
    return c.numerator() * CGAL::integral_division(denominator, c.denominator());
  };
  std::vector<CGAL::Gmpz> in_t;
  for (const CGAL::Gmpq& c : p)
    in_t.push_back(integer(c));
  in_t[0] -= integer(q[0]);
  std::vector<Polynomial_1> in_s(1, Polynomial_1(in_t.begin(), in_t.end()));
  for (std::size_t k = 1; k < q.size(); ++k)
    in_s.push_back(Polynomial_1(-integer(q[k])));
  return CGAL::canonicalize(Polynomial_2(in_s.begin(), in_s.end()));
}

} // namespace

Run intersect_with_algebraic_kernel(const Bezier_curve& a, const Bezier_curve& b)
{
  const Kernel kernel;   // with empty caches
  const Polynomial_2 f = difference(power_coefficients(a, &Control_point::x), power_coefficients(b, &Control_point::x));
  const Polynomial_2 g = difference(power_coefficients(a, &Control_point::y), power_coefficients(b, &Control_point::y));
  Run run;
  // What solve_2 requires. A common factor is not clipped to the unit square here.
  if (!kernel.is_coprime_2_object()(f, g)) {
    run.answer.overlaps = 1;
    return run;
  }
  const auto square_free = kernel.make_square_free_2_object();
  std::vector<std::pair<Kernel::Algebraic_real_2, Kernel::Multiplicity_type>> roots;
  kernel.solve_2_object()(square_free(f), square_free(g), 0, 1, 0, 1, std::back_inserter(roots));
  run.answer.points = static_cast<int>(roots.size());
  return run;
}

} // namespace peers
