// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <Eigen/Dense>

int main()
{
  using CGAL::Spline_constraints::Exact_rational;

  // One third is not a double: the sum below is 1 in exact arithmetic only.
  const Exact_rational third = Exact_rational(1) / Exact_rational(3);
  const bool is_exact = third + third + third == 1 && third != Exact_rational(1.0 / 3.0);
  return is_exact && Eigen::Matrix2d::Identity().determinant() == 1 ? 0 : 1;
}
