// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_CURVE_PROBLEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_CURVE_PROBLEMS_H

#include "curve_intersection.h"

#include <string>
#include <vector>

// Pairs of Bezier curves whose intersections are known.
namespace peers {

struct Curve_problem
{
  std::string name;
  std::string description;
  Bezier_curve first, second;
  Intersections truth;
};

inline Bezier_curve transposed(Bezier_curve curve)
{
  for (Control_point& p : curve)
    p = {p.y, p.x};
  return curve;
}

// The part of a curve up to the parameter t, or from it on, by de Casteljau's scheme.
inline Bezier_curve part(Bezier_curve curve, double t, bool is_first)
{
  Bezier_curve result;
  for (; !curve.empty(); curve.pop_back()) {
    result.push_back(is_first ? curve.front() : curve.back());
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
      curve[i] = {(1 - t) * curve[i].x + t * curve[i + 1].x, (1 - t) * curve[i].y + t * curve[i + 1].y};
  }
  return is_first ? result : Bezier_curve(result.rbegin(), result.rend());
}

// The control points (i/10, (-1)^i).
inline Bezier_curve wiggly_curve_of_degree_10()
{
  Bezier_curve curve;
  for (int i = 0; i <= 10; ++i)
    curve.push_back({i / 10.0, i % 2 == 0 ? 1.0 : -1.0});
  return curve;
}

// y = T_d(x) on [-1,1].
inline Bezier_curve chebyshev_curve(int degree)
{
  const auto binomial = [](int n, int k) {
    double result = 1;   // exact as long as it is an integer of 53 bits
    for (int i = 1; i <= k; ++i)
      result = result * (n - k + i) / i;
    return result;
  };
  Bezier_curve curve;
  for (int i = 0; i <= degree; ++i) {
    const double y = binomial(2 * degree, 2 * i) / binomial(degree, i);
    curve.push_back({-1 + 2.0 * i / degree, (degree - i) % 2 == 0 ? y : -y});
  }
  return curve;
}

inline std::vector<Curve_problem> curve_problems()
{
  const Bezier_curve wiggly = wiggly_curve_of_degree_10();
  const Bezier_curve cubic{{0, 0}, {1, 2}, {2, -2}, {3, 0}}, other_cubic{{0, -1}, {1, 1.5}, {2, -0.5}, {3, 0.2}};
  const Bezier_curve steep_cubic{{-3, -3}, {-1, 15}, {1, -15}, {3, 3}};
  const Bezier_curve chebyshev = chebyshev_curve(9);
  const Bezier_curve parabola{{-1, 1}, {0, -1}, {1, 1}};
  const auto line = [](double height) { return Bezier_curve{{-1.5, height}, {1.25, height}}; };
  const Intersections none, one_overlap{.overlaps = 1};
  const auto points = [](int count) { return Intersections{.points = count}; };
  return {{"b1", "degree 10 and its transpose", wiggly, transposed(wiggly), points(4)},
          {"b2", "two cubics", cubic, other_cubic, points(1)},
          {"b3", "cubic and its transpose", steep_cubic, transposed(steep_cubic), points(9)},
          {"b4", "Chebyshev curve of degree 9 and its transpose", chebyshev, transposed(chebyshev), points(81)},
          {"b5+", "parabola and a line 1e-10 above its vertex", parabola, line(1e-10), points(2)},
          {"b5-", "parabola and a line 1e-10 below its vertex", parabola, line(-1e-10), none},
          {"b6", "parabola and its tangent", parabola, line(0), points(1)},
          {"b7", "overlapping pieces of one cubic", part(cubic, 0.75, true), part(cubic, 0.25, false), one_overlap}};
}

} // namespace peers

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_CURVE_PROBLEMS_H
