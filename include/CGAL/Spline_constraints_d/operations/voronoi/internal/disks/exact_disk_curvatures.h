// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_EXACT_DISK_CURVATURES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_EXACT_DISK_CURVATURES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The curvature k of a disk with the center p + n / k, which touches the point p with the normal n there and something
else: a rational number and a square root, because the length of n is a root. Of the two disks that touch a line or a
circle, the smaller one is meant: the one that has the circle outside if p is, and around it if p is inside.
*/

// rational + sqrt(square)
struct Number_with_root
{
  Exact_rational rational = 0, square = 0;

  friend bool operator==(const Number_with_root& x, const Number_with_root& y)
  {
    const Exact_rational difference(y.rational - x.rational);
    if (sign_of(difference) == 0)
      return x.square == y.square;
    // sqrt(y.square) and sqrt(x.square), if they are equal
    const Exact_rational root((x.square - difference * difference - y.square) / (2 * difference)),
        other(root + difference);
    return sign_of(root) >= 0 && sign_of(other) >= 0 && root * root == y.square && other * other == x.square;
  }
};

// Of a k + b = c and a k + b = -c, where c squared is given.
inline std::optional<Number_with_root> greater_solution(const Exact_rational& a, const Exact_rational& b,
                                                        const Exact_rational& square_of_c)
{
  if (sign_of(a) == 0)
    return std::nullopt;
  return Number_with_root{Exact_rational(-b / a), Exact_rational(square_of_c / (a * a))};
}

// With a factor greater than 1, disks that are scaled by its root pass through the point.
inline std::optional<Number_with_root> curvature_of_disk_through(const Exact_pair& point, const Exact_pair& p,
                                                                 const Exact_pair& n,
                                                                 const Exact_rational& squared_factor)
{
  const Exact_pair d{Exact_rational(point[0] - p[0]), Exact_rational(point[1] - p[1])};
  if (squared_factor > 1)
    return greater_solution(
        exact_dot(d, d), Exact_rational(-exact_dot(n, d)),
        Exact_rational(exact_dot(n, d) * exact_dot(n, d) + (squared_factor - 1) * exact_dot(n, n) * exact_dot(d, d)));
  return greater_solution(exact_dot(d, d), Exact_rational(-2 * exact_dot(n, d)), 0);
}

inline std::optional<Number_with_root> curvature_of_disk_on_line(const Exact_pair& begin, const Exact_pair& end,
                                                                 const Exact_pair& p, const Exact_pair& n,
                                                                 const Exact_rational& squared_factor)
{
  const Exact_pair along{Exact_rational(end[0] - begin[0]), Exact_rational(end[1] - begin[1])},
      d{Exact_rational(p[0] - begin[0]), Exact_rational(p[1] - begin[1])};
  return greater_solution(exact_cross(along, d), exact_cross(along, n),
                          Exact_rational(exact_dot(along, along) * exact_dot(n, n) * squared_factor));
}

inline std::optional<Number_with_root> curvature_of_disk_on_circle(const Exact_pair& center,
                                                                   const Exact_rational& squared_radius,
                                                                   const Exact_pair& p, const Exact_pair& n)
{
  const Exact_pair d{Exact_rational(p[0] - center[0]), Exact_rational(p[1] - center[1])};
  return greater_solution(Exact_rational(exact_dot(d, d) - squared_radius), Exact_rational(2 * exact_dot(n, d)),
                          Exact_rational(4 * squared_radius * exact_dot(n, n)));
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_EXACT_DISK_CURVATURES_H
