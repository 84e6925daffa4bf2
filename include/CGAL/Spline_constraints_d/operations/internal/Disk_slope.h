// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_SLOPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_SLOPE_H

#include <CGAL/Spline_constraints_d/operations/internal/Blown_up_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/internal/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/internal/Site_graph_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
How the curvature k of a disk that touches a front in X(a) changes where the point Y(b) of an arc that it passes through moves away from an end of the arc, b = 0; near an end of the front, a = 0. With Z = Y - X, k and its derivative have the signs of the polynomials

  <N, Z>   and   <N, Y_b> |Z|^2 - 2 <N, Z> <Z, Y_b>.

These decide what intervals cannot: where front and arc meet or join, and where the order of contacts is a tie at the end of the front, as with circles and their tangents.
*/
class Disk_slope
{
  using Polynomial_pair = std::array<Power_polynomial, 2>;

  // A curve in homogeneous coordinates, and its derivative times the square of the weight.
  struct Polynomial_curve
  {
    Polynomial_pair point;
    Power_polynomial weight;
    Polynomial_pair derivative;
    Polynomial_pair tangent;   // without zeros of the derivative in the ends
  };

  double m_scale = 1;   // of the parameter of the arc
  Blown_up_polynomial m_sign_of_value{Power_polynomial()}, m_slope{Power_polynomial()};
  Blown_up_polynomial m_numerator{Power_polynomial()}, m_denominator{Power_polynomial()};   // of k

public:
  Disk_slope(const Site_graph_2& graph, const Front& front, bool front_end, const Arc_end& end)
  {
    m_scale = scale(graph, front, front_end, end);
    const Polynomial_curve y = polynomial_curve(graph, end, 1, Exact_rational(m_scale));
    Polynomial_pair normal, z;
    Power_polynomial weight(1);   // of the front
    if (front.is_fan) {
      const Exact_pair &from = front.exact_normals[front_end], &to = front.exact_normals[!front_end], &p = graph.vertices()[front.object].exact_point;
      for (std::size_t k = 0; k < 2; ++k) {
        normal[k] = Power_polynomial(from[k]) + Power_polynomial::variable(0) * Power_polynomial(Exact_rational(to[k] - from[k]));
        z[k] = y.point[k] - y.weight * Power_polynomial(p[k]);
      }
    } else {
      const Polynomial_curve x = polynomial_curve(graph, {front.object, front_end}, 0, Exact_rational(1));
      const Power_polynomial way(front.is_reversed == front_end ? 1 : -1);
      normal = {-way * x.tangent[1], way * x.tangent[0]};
      for (std::size_t k = 0; k < 2; ++k)
        z[k] = y.point[k] * x.weight - x.point[k] * y.weight;
      weight = x.weight;
    }
    const Power_polynomial nz = product(normal, z);
    m_sign_of_value = Blown_up_polynomial::without_common_powers(nz * weight * y.weight);
    m_slope = Blown_up_polynomial::without_common_powers(product(normal, y.derivative) * product(z, z) - Power_polynomial(2) * nz * product(z, y.derivative));
    m_numerator = Blown_up_polynomial(Power_polynomial(2) * nz * y.weight);
    m_denominator = Blown_up_polynomial(product(z, z) * weight);
  }

  // The signs of k_b for all disks that touch the front at some distance from its end, where b runs over a range, but for disks of less than some curvature.
  Path_signs slopes(const Range& a, const Range& b, double least) const
  {
    return m_slope.signs(a, scaled(b), [&](const Blown_up_polynomial::Chart_range& range) { return curvature(range).sup() < least; });
  }

  // Whether no disk of a range is in the half-plane of its normal.
  bool is_value_negative(const Range& a, const Range& b) const
  {
    const Sign_pattern pattern = m_sign_of_value.pattern(a, scaled(b));
    return pattern == Sign_pattern::NEGATIVE || pattern == Sign_pattern::ZERO;
  }

private:
  Interval curvature(const Blown_up_polynomial::Chart_range& range) const
  {
    constexpr int pieces = 8;   // of the ratio, on which k depends most
    if (m_numerator.is_zero())
      return Interval(0);
    if (m_numerator.degree() < m_denominator.degree())
      return any_number();
    std::optional<Interval> result;
    for (int i = 0; i < pieces; ++i) {
      const double begin = range.ratio.inf(), step = (range.ratio.sup() - begin) / pieces;
      const Blown_up_polynomial::Chart_range piece{range.radius, Interval(begin + i * step, i + 1 == pieces ? range.ratio.sup() : begin + (i + 1) * step), range.is_far};
      const Interval k = m_numerator(piece) / m_denominator(piece);
      result = result ? hull(*result, k) : k;
    }
    for (std::size_t i = m_denominator.degree(); i < m_numerator.degree(); ++i)
      *result *= range.radius;
    return *result;
  }

  Range scaled(const Range& b) const { return {b.begin / m_scale, b.end / m_scale}; }

  static Power_polynomial product(const Polynomial_pair& a, const Polynomial_pair& b) { return a[0] * b[0] + a[1] * b[1]; }

  // The ratio of the speeds of front and arc, as a power of 2.
  static double scale(const Site_graph_2& graph, const Front& front, bool front_end, const Arc_end& end)
  {
    if (front.is_fan)
      return 1;
    const auto speed = [&](const Arc_end& e) {
      const Interval square = squared_norm(graph.arcs()[e.arc].jet({e.parameter(), e.parameter()}, 1)[1]);
      return std::sqrt(square.sup());
    };
    const double ratio = speed({front.object, front_end}) / speed(end);
    return ratio > 0 && std::isfinite(ratio) ? std::exp2(std::round(std::log2(ratio))) : 1;
  }

  // From an end, with a parameter in units of the scale.
  static Polynomial_curve polynomial_curve(const Site_graph_2& graph, const Arc_end& end, int variable, const Exact_rational& scale)
  {
    const auto polynomial = [&](const Bernstein_tensor<Exact_rational>& tensor) {
      std::vector<Exact_rational> coefficients = tensor.coefficients();
      if (end.is_end)
        std::reverse(coefficients.begin(), coefficients.end());
      const std::vector<Exact_rational> powers = Bernstein_tensor<Exact_rational>(tensor.degrees(), std::move(coefficients)).power_coefficients();
      const Power_polynomial t = Power_polynomial::variable(variable) * Power_polynomial(scale);
      Power_polynomial result;
      for (auto c = powers.rbegin(); c != powers.rend(); ++c)
        result = result * t + Power_polynomial(*c);
      return result;
    };
    const Site_arc_2& arc = graph.arcs()[end.arc];
    const auto& [x, y, w] = arc.piece().coordinates;
    Polynomial_curve result{{polynomial(x), polynomial(y)}, polynomial(w), {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      result.derivative[k] = result.point[k].derivative(variable) * result.weight - result.point[k] * result.weight.derivative(variable);
      result.tangent[k] = arc.has_singular_end() ? Power_polynomial(end.is_end ? -1 : 1) * polynomial(arc.tangent()[k]) : result.derivative[k];
    }
    return result;
  }
};

// Those of one front, made when they are needed.
class Disk_slopes
{
  const Site_graph_2& m_graph;
  const Front& m_front;
  std::map<std::tuple<bool, std::size_t, bool>, Disk_slope> m_slopes;

public:
  Disk_slopes(const Site_graph_2& graph, std::size_t front) : m_graph(graph), m_front(graph.fronts()[front]) {}

  const Disk_slope& operator()(bool front_end, const Arc_end& end)
  {
    const std::tuple key(front_end, end.arc, end.is_end);
    const auto position = m_slopes.find(key);
    return position != m_slopes.end() ? position->second : m_slopes.emplace(key, Disk_slope(m_graph, m_front, front_end, end)).first->second;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_SLOPE_H
