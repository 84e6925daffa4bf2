// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SEPARATED_SIMPLICES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SEPARATED_SIMPLICES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

using Interval = CGAL::Interval_nt<false>;

inline std::optional<CGAL::Sign> certain_sign(const Exact_rational& x) { return CGAL::sign(x); }

inline std::optional<CGAL::Sign> certain_sign(const Interval& x)
{
  const CGAL::Uncertain<CGAL::Sign> sign = Number_traits<Interval>::sign(x);
  return CGAL::is_certain(sign) ? std::optional(sign.inf()) : std::nullopt;
}

template <class NT, int d>
using Row = std::array<NT, static_cast<std::size_t>(d)>;

template <class NT, std::size_t d>
NT product_of(const std::array<NT, d>& a, const std::array<NT, d>& b)
{
  NT result(a[0] * b[0]);
  for (std::size_t i = 1; i < d; ++i)
    result += a[i] * b[i];
  return result;
}

template <class NT>
NT determinant_of_columns(const std::array<const Row<NT, 4>*, 3>& rows, const std::array<int, 3>& c)
{
  const auto minor = [&](int i, int j) {
    return NT((*rows[1])[c[i]] * (*rows[2])[c[j]] - (*rows[1])[c[j]] * (*rows[2])[c[i]]);
  };
  return NT((*rows[0])[c[0]] * minor(1, 2) - (*rows[0])[c[1]] * minor(0, 2) + (*rows[0])[c[2]] * minor(0, 1));
}

// A vector that is orthogonal to d - 1 others.
template <class NT>
Row<NT, 2> orthogonal_to(const std::array<const Row<NT, 2>*, 1>& rows)
{
  return {NT(-(*rows[0])[1]), (*rows[0])[0]};
}

template <class NT>
Row<NT, 3> orthogonal_to(const std::array<const Row<NT, 3>*, 2>& rows)
{
  const auto &a = *rows[0], &b = *rows[1];
  return {NT(a[1] * b[2] - a[2] * b[1]), NT(a[2] * b[0] - a[0] * b[2]), NT(a[0] * b[1] - a[1] * b[0])};
}

template <class NT>
Row<NT, 4> orthogonal_to(const std::array<const Row<NT, 4>*, 3>& rows)
{
  return {determinant_of_columns<NT>(rows, {1, 2, 3}), NT(-determinant_of_columns<NT>(rows, {0, 2, 3})),
          determinant_of_columns<NT>(rows, {0, 1, 3}), NT(-determinant_of_columns<NT>(rows, {0, 1, 2}))};
}

/*
Whether vectors, which span the space, lie in an open half-space. If they do, their cone has no line in it, and the
inner normals of its facets, each of which is orthogonal to d - 1 of the vectors, have a sum that is positive on all of
them. So that sum decides.
*/
template <std::size_t d>
std::optional<bool> lie_in_half_space(const std::vector<std::array<Exact_rational, d>>& vectors)
{
  std::array<Exact_rational, d> sum{};
  std::vector<bool> is_chosen(vectors.size(), false);
  std::fill(is_chosen.begin(), is_chosen.begin() + (d - 1), true);
  do {
    std::array<const std::array<Exact_rational, d>*, d - 1> rows{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i)
      if (is_chosen[i])
        rows[count++] = &vectors[i];
    const std::array<Exact_rational, d> normal = orthogonal_to<Exact_rational>(rows);
    CGAL::Sign side = CGAL::ZERO;
    bool is_facet = true;
    for (std::size_t i = 0; i < vectors.size() && is_facet; ++i) {
      const CGAL::Sign sign = is_chosen[i] ? CGAL::ZERO : CGAL::sign(product_of(normal, vectors[i]));
      is_facet = side * sign >= 0;
      if (side == CGAL::ZERO)
        side = sign;
    }
    for (std::size_t k = 0; k < d && is_facet; ++k)
      sum[k] += static_cast<int>(side) * normal[k];
  } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
  return std::all_of(vectors.begin(), vectors.end(), [&](const auto& vector) { return product_of(sum, vector) > 0; });
}

// The same, by a vector that the perceptron finds. A no is no proof: then there are hardly any such vectors.
template <std::size_t d>
std::optional<bool> lie_in_half_space(const std::vector<std::array<Interval, d>>& vectors)
{
  std::vector<std::array<double, d>> units;
  for (const auto& vector : vectors) {
    std::array<double, d> unit;
    double square = 0;
    for (std::size_t k = 0; k < d; ++k) {
      unit[k] = CGAL::to_double(vector[k]);
      square += unit[k] * unit[k];
    }
    for (double& x : unit)
      x /= std::sqrt(square);
    units.push_back(unit);
  }
  std::array<double, d> sum{};
  const auto add = [&](const std::array<double, d>& unit) {
    for (std::size_t k = 0; k < d; ++k)
      sum[k] += unit[k];
  };
  std::for_each(units.begin(), units.end(), add);
  constexpr int most_steps = 400;
  constexpr double least_product = 1e-6, hopeless_cosine = -0.01;
  double lowest = 0;
  for (int step = 0; step < most_steps && !(lowest > least_product); ++step) {
    const auto at = std::min_element(units.begin(), units.end(), [&](const auto& a, const auto& b) {
      return product_of(sum, a) < product_of(sum, b);
    });
    lowest = product_of(sum, *at);
    if (!(lowest > least_product))
      add(*at);
  }
  if (lowest < hopeless_cosine * std::sqrt(product_of(sum, sum)))
    return false;
  std::array<Interval, d> separating;
  std::copy(sum.begin(), sum.end(), separating.begin());
  const bool is_proved = std::all_of(vectors.begin(), vectors.end(),
                                     [&](const auto& vector) { return product_of(separating, vector).inf() > 0; });
  return is_proved ? std::optional(true) : std::nullopt;
}

/*
Whether two tetrahedra, neither of them flat, meet in the convex hull of their common vertices only. They do if and only
if an affine function is zero at these, positive at the other vertices of the one and negative at those of the other:
modulo the hull, they are two cones with nothing in common but the apex, so that the cone of differences has no line
in it. In intervals, only a yes is proved.
*/
template <class NT>
class Pair_of_tetrahedra
{
  using Point = std::array<NT, 3>;

  const std::vector<Point>& m_points;
  std::vector<std::size_t> m_common, m_first, m_second; // vertices

public:
  Pair_of_tetrahedra(const std::vector<Point>& points, const std::array<std::size_t, 4>& first,
                     const std::array<std::size_t, 4>& second)
    : m_points(points)
  {
    const auto has = [](const auto& vertices, std::size_t v) {
      return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
    };
    for (const std::size_t v : first)
      (has(second, v) ? m_common : m_first).push_back(v);
    for (const std::size_t v : second)
      if (!has(m_common, v))
        m_second.push_back(v);
  }

  std::optional<bool> meet_in_common_face() const
  {
    switch (m_common.size()) {
    case 0:
      return anywhere();
    case 1:
      return lie_in_half_space(all<3>([&](const Point& p) { return from(m_common[0], p); }));
    case 2:
      return beside_edge();
    default:
      return beside_face();
    }
  }

private:
  Point from(std::size_t vertex, const Point& p) const
  {
    const Point& o = m_points[vertex];
    return {NT(p[0] - o[0]), NT(p[1] - o[1]), NT(p[2] - o[2])};
  }

  // Those of the first tetrahedron, and the opposite ones of the second.
  template <int d, class Map>
  std::vector<Row<NT, d>> all(const Map& map) const
  {
    std::vector<Row<NT, d>> result;
    for (const std::size_t v : m_first)
      result.push_back(map(m_points[v]));
    for (const std::size_t v : m_second) {
      result.push_back(map(m_points[v]));
      for (NT& x : result.back())
        x = NT(-x);
    }
    return result;
  }

  // With the size as the fourth coordinate, for angles that are not small.
  std::optional<bool> anywhere() const
  {
    double size = 0;
    for (const NT& x : from(m_first[0], m_points[m_first[1]]))
      size = (std::max)(size, CGAL::abs(CGAL::to_double(x)));
    return lie_in_half_space(all<4>([&](const Point& p) {
      const Point x = from(m_first[0], p);
      return Row<NT, 4>{x[0], x[1], x[2], NT(size)};
    }));
  }

  // Along the common edge they are projected to the plane.
  std::optional<bool> beside_edge() const
  {
    const Point along = from(m_common[0], m_points[m_common[1]]);
    int axis = -1; // the longest one, for which no sign is lost
    for (int i = 0; i < 3; ++i)
      if (const auto sign = certain_sign(along[i]); sign && *sign != CGAL::ZERO &&
          (axis == -1 || CGAL::to_double(CGAL::abs(along[i])) > CGAL::to_double(CGAL::abs(along[axis]))))
        axis = i;
    if (axis == -1)
      return std::nullopt;
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    return lie_in_half_space(all<2>([&](const Point& p) {
      const Point x = from(m_common[0], p);
      return Row<NT, 2>{NT(x[j] * along[axis] - x[axis] * along[j]), NT(x[k] * along[axis] - x[axis] * along[k])};
    }));
  }

  std::optional<bool> beside_face() const
  {
    const Point a = from(m_common[0], m_points[m_common[1]]), b = from(m_common[0], m_points[m_common[2]]);
    const Point normal = orthogonal_to<NT>(std::array<const Row<NT, 3>*, 2>{&a, &b});
    const auto first = certain_sign(product_of(normal, from(m_common[0], m_points[m_first[0]])));
    const auto second = certain_sign(product_of(normal, from(m_common[0], m_points[m_second[0]])));
    if (!first || !second)
      return std::nullopt;
    return *first * *second < 0;
  }
};

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SEPARATED_SIMPLICES_H
