// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_SLOPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_SLOPE_H

#include <CGAL/Spline_constraints_d/function/internal/polynomial_of_powers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Blown_up_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/powers_of_zeros.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
How the curvature k of a disk that touches an element in X(a) changes where the point Y(b) of an arc that it passes
through moves away from an end of the arc, b = 0; near an end of the element, a = 0. With Z = Y - X, k and its
derivative have the signs of the polynomials

  <N, Z>   and   <N, Y_b> |Z|^2 - 2 <N, Z> <Z, Y_b>.

These decide what intervals cannot: where element and arc meet or join, and where the order of footpoints is a tie at
the end of the element, as with circles and their tangents.

Where the derivative of an arc is zero in its end, Y_b = m D with m > 0 behind that, and D takes its place. Next to the
end a distance there is as a power of the parameter: where element and arc meet, both parameters are replaced by powers
of others, so that both distances are the same power of these. If the element is of that arc, Z has a factor b - a, k is
a quotient of what <N, Z> and |Z|^2 are without (b - a)^2, and the derivative has the factor (b - a)^4.
*/
class Disk_slope
{
  using Polynomial_pair = std::array<Power_polynomial, 2>;

  // A curve in homogeneous coordinates, and its derivative times the square of the weight, without zeros in the ends.
  struct Polynomial_curve
  {
    Polynomial_pair point;
    Power_polynomial weight;
    Polynomial_pair tangent;
  };

  bool m_is_singular;   // whether element and arc meet where a derivative is zero
  bool m_has_positive_denominator = false;   // of k, if only as a square
  double m_scale = 1;   // of the parameter of the arc
  int m_element_power = 1, m_arc_power = 1;   // of the variables of the polynomials, which the parameters are
  Blown_up_polynomial m_sign_of_value{Power_polynomial()}, m_slope{Power_polynomial()};
  Blown_up_polynomial m_numerator{Power_polynomial()}, m_denominator{Power_polynomial()};   // of k

public:
  Disk_slope(const Site_graph_2<>& graph, const Oriented_element<>& element, bool element_end, const Arc_end& end,
             bool is_by_distance)
  {
    const Arc_end own{element.object, element_end};
    const bool do_meet = (element.is_normal_cone ? element.object : graph.vertex_of(own)) == graph.vertex_of(end);
    const auto is_stationary = [&](const Arc_end& e) { return graph.arcs()[e.arc].is_curvature_stationary(e.is_end); };
    m_is_singular = do_meet && !(graph.is_regular(end) && (element.is_normal_cone || graph.is_regular(own)));
    const bool is_own = !element.is_normal_cone && own == end;
    if (is_by_distance)
      find_powers(graph, element, element_end, end);
    m_scale = is_own ? 1 : scale(graph, element, element_end, end);
    const Polynomial_curve y = polynomial_curve(graph, end, 1, Exact_rational(m_scale));
    Polynomial_pair normal, z;
    Power_polynomial weight(1);   // of the element
    if (element.is_normal_cone) {
      const Exact_pair &from = element.exact_normals[element_end], &to = element.exact_normals[!element_end],
                       &p = graph.vertices()[element.object].exact_point;
      for (std::size_t k = 0; k < 2; ++k) {
        normal[k] = Power_polynomial(from[k]) +
            Power_polynomial::variable(0) * Power_polynomial(Exact_rational(to[k] - from[k]));
        z[k] = y.point[k] - y.weight * Power_polynomial(p[k]);
      }
    } else {
      const Polynomial_curve x = polynomial_curve(graph, {element.object, element_end}, 0, Exact_rational(1));
      const Power_polynomial way(element.is_reversed == element_end ? 1 : -1);
      normal = {-way * x.tangent[1], way * x.tangent[0]};
      for (std::size_t k = 0; k < 2; ++k)
        z[k] = y.point[k] * x.weight - x.point[k] * y.weight;
      weight = x.weight;
    }
    const int squares = is_own ? 1 : 0;   // of b - a, in <N, Z> and in |Z|^2
    const Power_polynomial nz = product(normal, z),
                           slope = product(normal, y.tangent) * product(z, z) -
        Power_polynomial(2) * nz * product(z, y.tangent);
    if (is_by_distance && do_meet && !m_is_singular &&
        (is_stationary(end) || (!element.is_normal_cone && is_stationary(own))))
      find_powers(slope);
    m_sign_of_value = Blown_up_polynomial::without_common_powers(
        with_powers(without_difference(nz, 2 * squares) * weight * y.weight));
    m_slope = Blown_up_polynomial::without_common_powers(with_powers(without_difference(slope, 4 * squares)));
    m_numerator =
        Blown_up_polynomial(with_powers(Power_polynomial(2) * without_difference(nz, 2 * squares) * y.weight));
    m_denominator = Blown_up_polynomial(with_powers(without_difference(product(z, z), 2 * squares) * weight));
    m_has_positive_denominator = m_is_singular && weight.is_constant() && sign_of(weight.constant_term()) > 0;
  }

  /*
  The signs of k_b for all disks that touch the element at some distance from its end, where b runs over a range, but
  for disks of less than some curvature. With n less than d, the lowest degrees of numerator and denominator of k, k
  a^(d-n) depends mostly on the ratio b/a. If a share is attained by k a^(d-n) for all a, by the points of the arc at
  one ratio, the largest disk of each a has that share or more, whatever it touches: disks with less of it are none of
  these, and do not matter either.
  */
  Path_signs slopes(const Range& a, const Range& b, double least) const
  {
    const double least_share = share_of_largest(a);
    return m_slope.signs(root(a, m_element_power), scaled(b), [&](const Blown_up_polynomial::Chart_range& range) {
      return is_curvature_less(range, least) || (least_share > 0 && share(range).sup() < least_share);
    });
  }

  // Where a derivative is zero, the largest disks have at least such a share of that power of the distance from the end
  // of the element, or of its root; 0 if nothing is known.
  double share_of_largest(const Range& a) const
  {
    return m_is_singular && m_element_power <= 2 ? attained_share(root(a, m_element_power)) : 0;
  }
  int power_of_share() const
  {
    return static_cast<int>(m_denominator.degree()) - static_cast<int>(m_numerator.degree());
  }
  bool has_powers() const { return m_element_power != m_arc_power; }
  bool is_share_of_root() const { return m_element_power == 2; }

  // Whether no disk of a range is in the half-plane of its normal.
  bool is_value_negative(const Range& a, const Range& b) const
  {
    const Sign_pattern pattern = m_sign_of_value.pattern(root(a, m_element_power), scaled(b));
    return pattern == Sign_pattern::NEGATIVE || pattern == Sign_pattern::ZERO;
  }

  // A curvature that all disks exceed that touch the element no farther from its end, where element and arc meet.
  double attained_curvature(const Range& a) const
  {
    const Range radius = root(a, m_element_power);
    Interval result(attained_share(radius));
    for (std::size_t i = m_numerator.degree(); i < m_denominator.degree(); ++i)
      result /= Interval(radius.end);
    return std::isfinite(result.inf()) ? result.inf() : 0;
  }

private:
  // Where k is not bounded next to the vertex: times the power of the distance of the element that it is inversely
  // proportional to, nearly.
  Interval share(const Blown_up_polynomial::Chart_range& range) const
  {
    Interval result = m_numerator(range) / m_denominator(range);
    for (std::size_t i = m_numerator.degree(); range.is_far && i < m_denominator.degree(); ++i)
      result *= range.ratio;
    return result;
  }

  // A share that the largest disks exceed, or 0: by those through points whose distance has one of some ratios to that
  // of the element.
  double attained_share(const Range& radius) const
  {
    constexpr int most_halvings = 8;
    double result = 0;
    if (m_numerator.is_zero() || m_numerator.degree() >= m_denominator.degree())
      return result;
    for (int i = -2 * most_halvings; i <= 2 * most_halvings; ++i) {
      const Interval ratio(std::exp2(i / 2.0));
      Interval b(m_scale);
      for (int j = 0; j < m_arc_power; ++j)
        b *= Interval(radius.end) * ratio;
      if (b.sup() <= 1)
        result = (std::max)(result, share({radius.interval(), ratio, false}).inf());
    }
    return std::isfinite(result) ? result : 0;
  }

  // With a distance from the vertex for which both parameters are powers.
  void find_powers(const Site_graph_2<>& graph, const Oriented_element<>& element, bool element_end, const Arc_end& end)
  {
    const Arc_end own{element.object, element_end};
    if (element.is_normal_cone || own == end || graph.vertex_of(own) != graph.vertex_of(end))
      return;
    const int a = graph.arcs()[own.arc].zeros_of_derivative(own.is_end) + 1,
              b = graph.arcs()[end.arc].zeros_of_derivative(end.is_end) + 1, common = std::gcd(a, b);
    m_element_power = b / common;
    m_arc_power = a / common;
  }

  // Next to a vertex of a curve, with powers that are proportional where the slope is zero.
  void find_powers(const Power_polynomial& slope)
  {
    if (const auto powers = powers_of_zeros(slope))
      std::tie(m_element_power, m_arc_power) = *powers;
  }

  // With the parameters replaced by powers.
  Power_polynomial with_powers(const Power_polynomial& p) const
  {
    if (m_element_power == 1 && m_arc_power == 1)
      return p;
    return p.substituted(0, pow(Power_polynomial::variable(0), m_element_power))
        .substituted(1, pow(Power_polynomial::variable(1), m_arc_power));
  }

  // Divided by a power of b - a, which is a factor: by Horner's rule.
  static Power_polynomial without_difference(Power_polynomial p, int power)
  {
    for (; power > 0; --power) {
      std::vector<Power_polynomial> coefficients(static_cast<std::size_t>(p.degree(1)) + 1);   // of the powers of b
      for (const auto& [monomial, coefficient] : p.terms())
        coefficients[static_cast<std::size_t>(monomial.exponent(1))] +=
            Power_polynomial(coefficient) * pow(Power_polynomial::variable(0), monomial.exponent(0));
      Power_polynomial quotient, rest;
      for (std::size_t k = coefficients.size(); k-- > 1;) {
        rest = rest * Power_polynomial::variable(0) + coefficients[k];
        quotient += rest * pow(Power_polynomial::variable(1), static_cast<int>(k) - 1);
      }
      p = std::move(quotient);
    }
    return p;
  }

  // Numbers of which a range holds the powers.
  static Range root(const Range& range, int power)
  {
    return power == 1 ? range : Range{root(range.begin, power, -1), root(range.end, power, 1)};
  }

  // A number whose power is not greater, or not less, than x.
  static double root(double x, int power, int side)
  {
    if (x == 0)
      return 0;
    const double result = std::pow(x, 1.0 / power) * (1 + side * 0x1p-40);
    Interval value(1);
    for (int i = 0; i < power; ++i)
      value *= Interval(result);
    if (side < 0)
      return value.sup() <= x ? result : 0;
    return value.inf() >= x ? result : (std::max)(x, 1.0);
  }

  bool is_curvature_less(const Blown_up_polynomial::Chart_range& range, double least) const
  {
    return (m_numerator.degree() == m_denominator.degree() && mean_value_of_curvature(range).sup() < least) ||
        curvature(range).sup() < least;
  }

  // Where the curvatures of two arcs in their joint differ by little, so do those of all disks there, more than bounds
  // of numerator and denominator tell.
  Interval mean_value_of_curvature(const Blown_up_polynomial::Chart_range& range) const
  {
    const auto [n, n_by_ratio] = m_numerator.with_slope(range);
    const auto [d, d_by_ratio] = m_denominator.with_slope(range);
    const Interval k = n / d, middle((range.ratio.inf() + range.ratio.sup()) / 2);
    if (!std::isfinite(k.sup() - k.inf()))
      return k;
    const Blown_up_polynomial::Chart_range center{range.radius, middle, range.is_far};
    return m_numerator(center) / m_denominator(center) + (n_by_ratio - k * d_by_ratio) / d * (range.ratio - middle);
  }

  Interval curvature(const Blown_up_polynomial::Chart_range& range) const
  {
    constexpr int pieces = 8;   // of the ratio, on which k depends most
    if (m_numerator.is_zero())
      return Interval(0);
    if (m_numerator.degree() < m_denominator.degree())
      return share(range).sup() <= 0 ? Interval(-std::numeric_limits<double>::infinity(), 0) : any_number();
    if (m_has_positive_denominator && m_numerator(range).sup() <= 0)
      return Interval(-std::numeric_limits<double>::infinity(), 0);
    std::optional<Interval> result;
    for (int i = 0; i < pieces; ++i) {
      const double begin = range.ratio.inf(), step = (range.ratio.sup() - begin) / pieces;
      const Blown_up_polynomial::Chart_range piece{
          range.radius, Interval(begin + i * step, i + 1 == pieces ? range.ratio.sup() : begin + (i + 1) * step),
          range.is_far};
      const Interval k = m_numerator(piece) / m_denominator(piece);
      result = result ? hull(*result, k) : k;
    }
    for (std::size_t i = m_denominator.degree(); i < m_numerator.degree(); ++i)
      *result *= range.radius;
    return *result;
  }

  Range scaled(const Range& b) const { return root({b.begin / m_scale, b.end / m_scale}, m_arc_power); }

  static Power_polynomial product(const Polynomial_pair& a, const Polynomial_pair& b)
  {
    return a[0] * b[0] + a[1] * b[1];
  }

  // The ratio of the speeds of element and arc, as a power of 2.
  static double scale(const Site_graph_2<>& graph, const Oriented_element<>& element, bool element_end,
                      const Arc_end& end)
  {
    if (element.is_normal_cone)
      return 1;
    const auto speed = [&](const Arc_end& e) {
      return std::sqrt(squared_norm(graph.arcs()[e.arc].direction_over({e.parameter(), e.parameter()})).sup()) /
          (graph.arcs()[e.arc].zeros_of_derivative(e.is_end) + 1);
    };
    const double ratio = std::pow(speed({element.object, element_end}) / speed(end),
                                  1.0 / (graph.arcs()[end.arc].zeros_of_derivative(end.is_end) + 1));
    return ratio > 0 && std::isfinite(ratio) ? std::exp2(std::round(std::log2(ratio))) : 1;
  }

  // From an end, with a parameter in units of the scale.
  static Polynomial_curve polynomial_curve(const Site_graph_2<>& graph, const Arc_end& end, int variable,
                                           const Exact_rational& scale)
  {
    const auto polynomial = [&](const Bernstein_tensor<Exact_rational>& tensor) {
      return polynomial_of_powers(
          tensor.degrees(), (end.is_end ? reversed(tensor) : tensor).power_coefficients(),
          [&](std::size_t) { return Power_polynomial::variable(variable) * Power_polynomial(scale); });
    };
    const Exact_arc_2& arc = graph.arcs()[end.arc];
    const auto& [x, y, w] = arc.piece().coordinates;
    Polynomial_curve result{{polynomial(x), polynomial(y)}, polynomial(w), {}};
    for (std::size_t k = 0; k < 2; ++k)
      result.tangent[k] = arc.has_singular_end()
          ? Power_polynomial(end.is_end ? -1 : 1) * polynomial(arc.tangent()[k])
          : result.point[k].derivative(variable) * result.weight - result.point[k] * result.weight.derivative(variable);
    return result;
  }
};

// Those of one element, made when they are needed.
class Disk_slopes
{
  const Site_graph_2<>& m_graph;
  const Oriented_element<>& m_element;
  std::map<std::tuple<bool, std::size_t, bool, bool>, Disk_slope> m_slopes;

public:
  Disk_slopes(const Site_graph_2<>& graph, std::size_t element) : m_graph(graph), m_element(graph.elements()[element])
  {}

  // A curvature that all disks exceed, or 0: of a part of the element that begins or ends in a vertex in which a
  // derivative is zero.
  double attained_curvature(const Range& range)
  {
    double result = 0;
    for (const bool element_end : {false, true}) {
      if (element_end ? range.end < 1 : range.begin > 0)
        continue;
      const Arc_end own{m_element.object, element_end};
      if (!m_element.is_normal_cone && !m_graph.is_exact(own))
        continue;
      for (const Arc_end& end :
           m_graph.vertices()[m_element.is_normal_cone ? m_element.object : m_graph.vertex_of(own)].ends)
        if (m_graph.is_exact(end) &&
            !(m_graph.is_regular(end) && (m_element.is_normal_cone || m_graph.is_regular(own))))
          result = (std::max)(result,
                              (*this)(element_end, end)
                                  .attained_curvature(element_end ? Range{1 - range.end, 1 - range.begin} : range));
    }
    return result;
  }

  // In parameters whose powers are u and v, if distances next to a common vertex are not the same powers of these; or
  // in u and v.
  const Disk_slope& operator()(bool element_end, const Arc_end& end, bool is_by_distance = true)
  {
    const std::tuple key(element_end, end.arc, end.is_end, is_by_distance);
    const auto position = m_slopes.find(key);
    return position != m_slopes.end()
        ? position->second
        : m_slopes.emplace(key, Disk_slope(m_graph, m_element, element_end, end, is_by_distance)).first->second;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_SLOPE_H
