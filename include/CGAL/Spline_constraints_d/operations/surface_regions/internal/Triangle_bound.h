// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIANGLE_BOUND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIANGLE_BOUND_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_face_3.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Points of a cell X/w, and how far it is from triangles. Used with rounding upwards, see `Rounding_guard`.
class Triangle_bound
{
  using Interval = CGAL::Interval_nt<false>;
  using Net = std::vector<Interval>; // Bernstein coefficients, row-major

public:
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Local_point = std::array<Interval, 2>;

private:
  std::array<int, 2> m_degrees{};
  std::array<Net, 4> m_nets;

public:
  explicit Triangle_bound(const Surface_cell_3& cell)
  {
    for (const auto& f : cell.coordinates)
      for (const std::size_t axis : {0, 1})
        m_degrees[axis] = (std::max)(m_degrees[axis], f.degrees()[axis]);
    for (std::size_t i = 0; i < 4; ++i)
      for (const Exact_rational& c : cell.coordinates[i].elevated({m_degrees[0], m_degrees[1]}).coefficients())
        m_nets[i].push_back(Interval(to_double_interval(c)));
  }

  // A point near that at parameters; none at a pole.
  std::optional<Point> point(const Local_point& at) const
  {
    std::array<double, 4> x;
    for (std::size_t i = 0; i < 4; ++i) {
      const Net net = restricted(restricted(m_nets[i], 0, at[0], at[0]), 1, at[1], at[1]);
      x[i] = 0.5 * (net[0].inf() + net[0].sup());
    }
    const Point result(x[0] / x[3], x[1] / x[3], x[2] / x[3]);
    return std::isfinite(result.x()) && std::isfinite(result.y()) && std::isfinite(result.z()) ? std::optional(result)
                                                                                               : std::nullopt;
  }

  // An upper bound of |X/w - L| over a triangle of parameters, for the affine map L onto the triangle of these points.
  double operator()(const std::array<Local_point, 3>& parameters, const std::array<Point, 3>& points) const
  {
    const std::array<Interval, 2> begin = corner(parameters, false), end = corner(parameters, true);
    std::array<Net, 4> nets;
    for (std::size_t i = 0; i < 4; ++i)
      nets[i] = restricted(restricted(m_nets[i], 0, begin[0], end[0]), 1, begin[1], end[1]);
    const Interval weight = least_absolute_value(nets[3]);
    if (!(weight.inf() > 0))
      return std::numeric_limits<double>::infinity();
    const auto corners = affine_corners(parameters, points, begin, end);
    const int p = m_degrees[0] + 1, q = m_degrees[1] + 1;
    Interval greatest(0);
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) {
        std::array<Interval, 3> difference{0, 0, 0};
        for (const int a : {0, 1})
          for (const int b : {0, 1})
            add_product(difference, nets, corners[static_cast<std::size_t>(2 * a + b)], {i, j}, {a, b});
        Interval square(0);
        for (const Interval& x : difference)
          square += CGAL::square(x);
        if (!std::isfinite(square.sup()))
          return std::numeric_limits<double>::infinity();
        greatest = Interval(0, (std::max)(greatest.sup(), square.sup()));
      }
    return (CGAL::sqrt(greatest) / (weight * Interval(p * q))).sup();
  }

private:
  // A corner of the box around a triangle.
  static std::array<Interval, 2> corner(const std::array<Local_point, 3>& parameters, bool is_upper)
  {
    std::array<Interval, 2> result;
    for (const std::size_t axis : {0, 1}) {
      double value = is_upper ? parameters[0][axis].sup() : parameters[0][axis].inf();
      for (const Local_point& p : parameters)
        value = is_upper ? (std::max)(value, p[axis].sup()) : (std::min)(value, p[axis].inf());
      result[axis] = Interval(value);
    }
    return result;
  }

  static Interval least_absolute_value(const Net& net)
  {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const Interval& x : net) {
      least = (std::min)(least, x.inf());
      greatest = (std::max)(greatest, x.sup());
    }
    return Interval(least > 0 ? least : greatest < 0 ? -greatest : 0);
  }

  // The affine map at the four corners of the box.
  static std::array<std::array<Interval, 3>, 4> affine_corners(const std::array<Local_point, 3>& parameters,
                                                               const std::array<Point, 3>& points,
                                                               const std::array<Interval, 2>& begin,
                                                               const std::array<Interval, 2>& end)
  {
    const auto side = [&](std::size_t i, std::size_t axis) -> Interval {
      return parameters[i][axis] - parameters[0][axis];
    };
    const Interval determinant = side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0);
    std::array<std::array<Interval, 3>, 4> result;
    for (int c = 0; c < 3; ++c) {
      const Interval origin(points[0][c]), first = Interval(points[1][c]) - origin,
                                           second = Interval(points[2][c]) - origin;
      const Interval along_u = (first * side(2, 1) - second * side(1, 1)) / determinant,
                     along_v = (second * side(1, 0) - first * side(2, 0)) / determinant;
      for (const std::size_t a : {0, 1})
        for (const std::size_t b : {0, 1})
          result[2 * a + b][static_cast<std::size_t>(c)] = origin +
              along_u * ((a == 0 ? begin : end)[0] - parameters[0][0]) +
              along_v * ((b == 0 ? begin : end)[1] - parameters[0][1]);
    }
    return result;
  }

  // Adds to p q times the coefficient of X - w L, of degree (p,q), what the coefficients of X and w and a corner of L
  // give to it.
  void add_product(std::array<Interval, 3>& sum, const std::array<Net, 4>& nets, const std::array<Interval, 3>& corner,
                   const std::array<int, 2>& index, const std::array<int, 2>& from) const
  {
    Interval factor(1);
    for (const std::size_t axis : {0, 1})
      factor *= Interval(from[axis] == 1 ? index[axis] : m_degrees[axis] + 1 - index[axis]);
    if (factor.inf() == 0)
      return;
    const std::size_t k = static_cast<std::size_t>((index[0] - from[0]) * (m_degrees[1] + 1) + index[1] - from[1]);
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += factor * (nets[c][k] - nets[3][k] * corner[c]);
  }

  // Over a part of the range of an axis, by the algorithm of de Casteljau: the coefficients are the values of the polar
  // form at arguments that are all one end or the other.
  Net restricted(Net net, int axis, const Interval& begin, const Interval& end) const
  {
    const int n = m_degrees[static_cast<std::size_t>(axis)], columns = m_degrees[1] + 1;
    const int lines = axis == 0 ? columns : m_degrees[0] + 1, step = axis == 0 ? columns : 1;
    const Interval rest_of_end = Interval(1) - end;
    for (int line = 0; line < lines; ++line) {
      Interval* const values = net.data() + (axis == 0 ? line : line * columns);
      for (int round = 1; round <= n; ++round) // up to the end
        for (int i = n; i >= round; --i)
          values[i * step] = rest_of_end * values[(i - 1) * step] + end * values[i * step];
      if (begin.inf() == 0 && begin.sup() == 0)
        continue;
      const Interval place = begin / end, rest = (end - begin) / end; // in what is left
      for (int round = 1; round <= n; ++round)
        for (int i = 0; i <= n - round; ++i)
          values[i * step] = rest * values[i * step] + place * values[(i + 1) * step];
    }
    return net;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIANGLE_BOUND_H
