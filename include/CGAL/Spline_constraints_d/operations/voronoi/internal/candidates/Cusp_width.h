// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSP_WIDTH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSP_WIDTH_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Two arcs X and Y that leave a point in the same direction: how much curvature all disks have that touch the element of X
up to some width. The disk in X(u) that passes through Y(c u), where c makes speeds equal, has the curvature 2 <N, D> /
|D|^2, D = Y(c u) - X(u). Numerator and denominator are polynomials, expanded exactly, with u^i and u^j as factors, i <
j; what is left of them is bounded by its Bernstein coefficients.

In a cusp of one curve the derivatives are zero: they are u and a vector, which N is perpendicular to.
*/
struct Cusp_width
{
  double curvature;   // that of the largest disks, times a power of the distance, is more
  int power;
  double gap;         // between the arcs at the width, in units of the derivative of X

  // With the element of X on the left of it, or on the right; nothing if there is no bound.
  static std::optional<Cusp_width> of(const Site_graph_2<>& graph, const Arc_end& own, const Arc_end& other,
                                      bool is_left, double width)
  {
    const auto ratio = ratio_of_speeds(graph, own, other);
    if (!ratio || *ratio * to_rational(width) > 1)
      return std::nullopt;
    // ends of arcs may not be known exactly
    const Exact_rational longer = to_rational(width) * (1 + to_rational(most_error));
    const auto [dx, dy, w, s] = difference(graph, own, other, longer, *ratio);
    const auto [ax, ay] = tangent(graph, own, longer);
    const bool is_regular = graph.is_regular(own);
    const Tensor square = dx * dx + dy * dy, numerator = (is_left ? ax * dy - ay * dx : ay * dx - ax * dy) * (w * s),
                 denominator = is_regular ? square * (w * w) : square;
    const auto least = without_power(numerator), greatest = without_power(denominator);
    if (!least || !greatest || least->power >= greatest->power || sign_of(least->bounds.first) <= 0)
      return std::nullopt;
    const Interval share = Interval(1 - 4 * greatest->power * most_error) *
        interval_of(Exact_rational(least->bounds.first / greatest->bounds.second));
    Cusp_width result{0, greatest->power - least->power, 0};
    Interval scale = is_regular ? Interval(2) / Interval(width) : Interval(2);   // N is a derivative by u there
    for (int i = 0; i < result.power; ++i)
      scale *= Interval(width);
    result.curvature = (share * scale).inf();
    const std::array<Exact_rational, 1> end{1};
    // of one weight where it is one
    result.gap = (is_regular ? width : 1 / width) *
        CGAL::to_double(Exact_rational(numerator(end) / (ax(end) * ax(end) + ay(end) * ay(end))));
    return result.curvature > 0 ? std::optional(result) : std::nullopt;
  }

  // The same where distances from Y are divided by c > 1: the disk in X(u) with a radius of |D| / (c - 1), on either
  // side of X, has Y(c u) inside when scaled. `share` is (c - 1) |N|, at least; there is no gap.
  static std::optional<Cusp_width> of_scaled(const Site_graph_2<>& graph, const Arc_end& own, const Arc_end& other,
                                             const Interval& share, double width)
  {
    const auto ratio = ratio_of_speeds(graph, own, other);
    const Exact_rational longer = to_rational(width) * (1 + to_rational(most_error));
    if (!ratio || !graph.is_regular(own) || *ratio * longer > 1 - to_rational(most_error))
      return std::nullopt;
    const auto [dx, dy, w, s] = difference(graph, own, other, longer, *ratio);
    const auto greatest = without_power(dx * dx + dy * dy);
    const std::vector<Exact_rational> weights = (w * s).coefficients();
    const Exact_rational weight = *std::min_element(weights.begin(), weights.end());
    if (!greatest || sign_of(weight) <= 0)
      return std::nullopt;
    Cusp_width result{0, greatest->power / 2, 0};
    Interval scale = share * interval_of(weight) / CGAL::sqrt(interval_of(greatest->bounds.second));
    for (int i = 0; i < result.power; ++i)
      scale *= Interval(width);
    result.curvature = scale.inf();
    return result.curvature > 0 ? std::optional(result) : std::nullopt;
  }

private:
  using Tensor = Bernstein_tensor<Exact_rational>;

  static constexpr double most_error = 0x1p-9;   // twice that of the ends of arcs

  struct Factor
  {
    int power;
    std::pair<Exact_rational, Exact_rational> bounds;
  };

  static Exact_rational to_rational(double x) { return Exact_rational(x); }

  // Y(c u) - X(u) up to a width, times both weights, and these.
  static std::array<Tensor, 4> difference(const Site_graph_2<>& graph, const Arc_end& own, const Arc_end& other,
                                          const Exact_rational& width, const Exact_rational& ratio)
  {
    const auto [x, y, w] = piece(graph, own, width);
    const auto [u, v, s] = piece(graph, other, ratio * width);
    return {u * w - x * s, v * w - y * s, w, s};
  }

  // Where the arcs have the same speeds in units of their parameters.
  static std::optional<Exact_rational> ratio_of_speeds(const Site_graph_2<>& graph, const Arc_end& own,
                                                       const Arc_end& other)
  {
    const auto zeros = [&](const Arc_end& end) { return graph.arcs()[end.arc].zeros_of_derivative(end.is_end); };
    if (!graph.is_exact(own) || !graph.is_exact(other) || zeros(own) != zeros(other) || zeros(own) > 1)
      return std::nullopt;
    const Exact_pair a = speed(graph, own), b = speed(graph, other);
    const std::size_t k = CGAL::abs(a[0]) < CGAL::abs(a[1]);
    if (sign_of(a[k]) == 0 || sign_of(b[k]) == 0)   // of arcs whose other ends are not known exactly
      return std::nullopt;
    const Exact_rational ratio = CGAL::abs(Exact_rational(a[k] / b[k]));
    return zeros(own) == 0 ? ratio : rational_square_root(ratio);
  }

  // The derivative in an end, or the second one where that is zero.
  static Exact_pair speed(const Site_graph_2<>& graph, const Arc_end& end)
  {
    const Site_arc_2<>& arc = graph.arcs()[end.arc];
    if (graph.is_regular(end))
      return arc.derivative_at(end.is_end);
    const std::array<Exact_rational, 1> t{Exact_rational(end.is_end)};
    const Exact_rational w = arc.piece().coordinates[2](t);
    const auto& [x, y] = arc.tangent();
    return {Exact_rational(x(t) / (w * w)), Exact_rational(y(t) / (w * w))};
  }

  // What the element's normal is perpendicular to, times the square of the weight where that is a derivative, from an
  // end on.
  static std::array<Tensor, 2> tangent(const Site_graph_2<>& graph, const Arc_end& end, const Exact_rational& width)
  {
    if (graph.is_regular(end)) {
      const auto [x, y, w] = piece(graph, end, width);
      return {x.derivative(0) * w - x * w.derivative(0), y.derivative(0) * w - y * w.derivative(0)};
    }
    std::array<Tensor, 2> result = graph.arcs()[end.arc].tangent();
    for (Tensor& tensor : result)
      tensor = end.is_end ? -from_end(tensor, end, width) : from_end(tensor, end, width);
    return result;
  }

  static Tensor from_end(const Tensor& tensor, const Arc_end& end, const Exact_rational& width)
  {
    return tensor.restricted(0, Exact_rational(end.is_end),
                             Exact_rational(end.is_end ? Exact_rational(1 - width) : width));
  }

  static std::array<Tensor, 3> piece(const Site_graph_2<>& graph, const Arc_end& end, const Exact_rational& width)
  {
    std::array<Tensor, 3> result = graph.arcs()[end.arc].piece().coordinates;
    for (Tensor& tensor : result)
      tensor = from_end(tensor, end, width);
    return result;
  }

  // t^k times a polynomial with the Bernstein coefficients b_{i+k} (n over i+k) / (n-k over i).
  static std::optional<Factor> without_power(const Tensor& tensor)
  {
    const std::vector<Exact_rational>& b = tensor.coefficients();
    const auto first = std::find_if(b.begin(), b.end(), [](const Exact_rational& c) { return sign_of(c) != 0; });
    if (first == b.end())
      return std::nullopt;
    const int n = tensor.degree(0), k = static_cast<int>(first - b.begin());
    std::vector<Exact_rational> rest;
    Exact_rational factor(1);   // (n over k)
    for (int i = 0; i < k; ++i)
      factor *= Exact_rational(n - i) / Exact_rational(i + 1);
    for (int i = 0; i + k <= n; ++i) {
      rest.push_back(b[static_cast<std::size_t>(i + k)] * factor);
      if (i + k < n)
        factor *= Exact_rational(i + 1) / Exact_rational(i + k + 1);   // n - k - i cancels
    }
    const auto [least, greatest] = std::minmax_element(rest.begin(), rest.end());
    return Factor{k, {*least, *greatest}};
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSP_WIDTH_H
