// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's exact sweep over Bezier curves.
#include "curve_intersection.h"

#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Surface_sweep_2_algorithms.h>

#include <iterator>
#include <vector>

namespace peers {
namespace {

using Number_traits = CGAL::CORE_algebraic_number_traits;
using Rational_kernel = CGAL::Cartesian<Number_traits::Rational>;
using Algebraic_kernel = CGAL::Cartesian<Number_traits::Algebraic>;
using Traits = CGAL::Arr_Bezier_curve_traits_2<Rational_kernel, Algebraic_kernel, Number_traits>;

Traits::Curve_2 bezier_curve(const Bezier_curve& curve)
{
  std::vector<Rational_kernel::Point_2> points;
  for (const Control_point& p : curve)
    points.emplace_back(Number_traits::Rational(p.x), Number_traits::Rational(p.y));
  return Traits::Curve_2(points.begin(), points.end());
}

// The sweep reports points inside of a curve, or all ends: the ends that two curves share are for the caller to count.
int common_ends(const Bezier_curve& a, const Bezier_curve& b)
{
  int count = 0;
  for (const Control_point& p : {a.front(), a.back()})
    for (const Control_point& q : {b.front(), b.back()})
      count += p.x == q.x && p.y == q.y;
  return count;
}

} // namespace

Run intersect_with_bezier_traits(const Bezier_curve& a, const Bezier_curve& b)
{
  const std::vector<Traits::Curve_2> curves{bezier_curve(a), bezier_curve(b)};
  Traits traits;
  std::vector<Traits::Point_2> points;
  CGAL::compute_intersection_points(curves.begin(), curves.end(), std::back_inserter(points), false, traits);
  return {.answer = {.points = static_cast<int>(points.size()) + common_ends(a, b)}, .phases = {}};
}

} // namespace peers
