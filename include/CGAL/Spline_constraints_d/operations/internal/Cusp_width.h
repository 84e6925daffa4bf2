// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CUSP_WIDTH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CUSP_WIDTH_H

#include <CGAL/Spline_constraints_d/operations/internal/Site_graph_2.h>

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

/*
Two arcs X and Y that leave a point in the same direction: how much curvature all disks have that touch the front of X up to some width. The disk in X(u) that passes through Y(c u), where c makes speeds equal, has the curvature 2 <N, D> / |D|^2, D = Y(c u) - X(u). Numerator and denominator are polynomials, expanded exactly, with u^i and u^j as factors, i < j; what is left of them is bounded by its Bernstein coefficients.
*/
struct Cusp_width
{
  double curvature;   // that of the largest disks, times a power of the distance, is more
  int power;
  double gap;         // between the arcs at the width, in units of the derivative of X

  // With the front of X on the left of it, or on the right; nothing if there is no bound.
  static std::optional<Cusp_width> of(const Site_graph_2& graph, const Arc_end& own, const Arc_end& other, bool is_left, double width)
  {
    const auto ratio = ratio_of_speeds(graph, own, other);
    if (!ratio || *ratio * to_rational(width) > 1)
      return std::nullopt;
    const Exact_rational longer = to_rational(width) * (1 + to_rational(most_error));   // ends of arcs may not be known exactly
    const auto [x, y, w] = piece(graph, own, longer);
    const auto [u, v, s] = piece(graph, other, *ratio * longer);
    const Tensor dx = u * w - x * s, dy = v * w - y * s;
    const Tensor ax = x.derivative(0) * w - x * w.derivative(0), ay = y.derivative(0) * w - y * w.derivative(0);
    const Tensor numerator = (is_left ? ax * dy - ay * dx : ay * dx - ax * dy) * (w * s), denominator = (dx * dx + dy * dy) * (w * w);
    const auto least = without_power(numerator), greatest = without_power(denominator);
    if (!least || !greatest || least->power >= greatest->power || sign_of(least->bounds.first) <= 0)
      return std::nullopt;
    const Interval share = Interval(1 - 4 * greatest->power * most_error) * interval_of(Exact_rational(least->bounds.first / greatest->bounds.second));
    Cusp_width result{0, greatest->power - least->power, 0};
    Interval scale = Interval(2) / Interval(width);   // N is a derivative by u
    for (int i = 0; i < result.power; ++i)
      scale *= Interval(width);
    result.curvature = (share * scale).inf();
    const std::array<Exact_rational, 1> end{1};
    result.gap = width * CGAL::to_double(Exact_rational(numerator(end) / (ax(end) * ax(end) + ay(end) * ay(end))));   // of one weight where it is one
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

  // Where the arcs have the same speeds in units of their parameters.
  static std::optional<Exact_rational> ratio_of_speeds(const Site_graph_2& graph, const Arc_end& own, const Arc_end& other)
  {
    const Exact_pair a = graph.arcs()[own.arc].derivative_at(own.is_end), b = graph.arcs()[other.arc].derivative_at(other.is_end);
    const std::size_t k = CGAL::abs(a[0]) < CGAL::abs(a[1]);
    if (!graph.is_exact(own) || !graph.is_exact(other) || sign_of(a[k]) == 0 || sign_of(b[k]) == 0)
      return std::nullopt;
    return CGAL::abs(Exact_rational(a[k] / b[k]));
  }

  static std::array<Tensor, 3> piece(const Site_graph_2& graph, const Arc_end& end, const Exact_rational& width)
  {
    std::array<Tensor, 3> result = graph.arcs()[end.arc].piece().coordinates;
    for (Tensor& tensor : result)
      tensor = tensor.restricted(0, Exact_rational(end.is_end), Exact_rational(end.is_end ? Exact_rational(1 - width) : width));
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

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CUSP_WIDTH_H
