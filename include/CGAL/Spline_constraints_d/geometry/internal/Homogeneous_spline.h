// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_HOMOGENEOUS_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_HOMOGENEOUS_SPLINE_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Local_weights.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A map from a box of parameters into d-space: d numerators and, unless it is polynomial, a weight, all on the same knots.
The weight is positive everywhere, proved at construction. Curves and surfaces are views of it in the terms of a kernel.
*/
template <class NT, int d>
class Homogeneous_spline
{
public:
  using Function = Bspline_function<NT>;
  using Coordinates = std::array<NT, d>;

private:
  // The numerators, then the weight if there is one.
  std::vector<Function> m_functions;

public:
  // On any knots, numerators and weight, which may be missing. `who` begins the messages of what is thrown.
  Homogeneous_spline(std::vector<Function> functions, const std::string& who) : m_functions(std::move(functions))
  {
    for (std::size_t i = 1; i < m_functions.size(); ++i)
      for (int j = 0; j < m_functions[0].dimension(); ++j)
        if (m_functions[i].domain(j) != m_functions[0].domain(j))
          throw Invalid_input(who + ": the homogeneous coordinates have different domains on axis " +
                              std::to_string(j));
    // A constant weight leaves the knots of the numerators alone.
    drop_constant_weight();
    bring_to_common_knots(m_functions);
    normalise_weight(who);
  }

  // From control points, row-major, and weights if there are any.
  Homogeneous_spline(const std::vector<int>& degrees, const std::vector<std::vector<NT>>& knots,
                     const std::vector<Coordinates>& points, const std::vector<NT>& weights, const std::string& who)
  {
    check_weights(weights, points.size(), who);
    // Equal weights are none: nothing need be multiplied, which would round.
    const bool has_weight = std::any_of(weights.begin(), weights.end(), [&](const NT& w) { return w != weights[0]; });
    m_functions.reserve(d + 1);
    for (int i = 0; i < d; ++i) {
      std::vector<NT> numerator;
      numerator.reserve(points.size());
      for (std::size_t k = 0; k < points.size(); ++k)
        numerator.push_back(has_weight ? NT(weights[k] * points[k][i]) : points[k][i]);
      add_function(degrees, knots, std::move(numerator));
    }
    if (has_weight)
      add_function(degrees, knots, weights);
    normalise_weight(who);
  }

  const Function& numerator(int i) const { return m_functions[i]; }
  bool is_rational() const { return m_functions.size() > d; }
  int dimension() const { return m_functions[0].dimension(); }
  const std::vector<Function>& functions() const { return m_functions; }

  // Degree 0 where it is the constant 1, so that products with it stay small.
  Function weight() const
  {
    if (is_rational())
      return m_functions[d];
    std::vector<std::vector<NT>> knots;
    for (int j = 0; j < dimension(); ++j)
      knots.push_back({m_functions[0].domain(j).first, m_functions[0].domain(j).second});
    return Function(std::vector<int>(dimension(), 0), std::move(knots), {NT(1)});
  }

  NT control_weight(std::size_t k) const { return is_rational() ? m_functions[d].coefficients()[k] : NT(1); }

  Coordinates control_point(std::size_t k) const
  {
    const NT weight = control_weight(k);
    if (weight == NT(0))
      throw Invalid_input("control point " + std::to_string(k) + " has weight 0 and is no point");
    Coordinates result;
    for (int i = 0; i < d; ++i)
      result[i] = is_rational() ? NT(m_functions[i].coefficients()[k] / weight) : m_functions[i].coefficients()[k];
    return result;
  }

  // The partial derivatives of total order up to `order`, by their orders along the axes; at a knot from the right.
  std::map<std::vector<int>, Coordinates> derivatives(std::span<const NT> u, int order) const
  {
    std::map<std::vector<int>, Coordinates> result;
    const auto homogeneous = homogeneous_derivatives(u, order);
    // In this order all derivatives of lower order along some axis, and of none higher along the others, come before:
    // the quotient rule is a recursion.
    for (const auto& [orders, values] : homogeneous) {
      Coordinates derivative;
      std::copy_n(values.begin(), d, derivative.begin());
      if (is_rational())
        divide_by_weight(derivative, orders, homogeneous, result);
      result.emplace(orders, std::move(derivative));
    }
    return result;
  }

  Coordinates operator()(std::span<const NT> u) const { return derivatives(u, 0).begin()->second; }

  // The map with every homogeneous coordinate changed in the same linear way.
  template <class Operation>
  Homogeneous_spline mapped(const Operation& operation) const
  {
    std::vector<Function> functions;
    for (const Function& f : m_functions)
      functions.push_back(operation(f));
    return Homogeneous_spline(std::move(functions), "the result of an operation");
  }

  template <class Target>
  Homogeneous_spline<Target, d> converted(const std::string& who) const
  {
    std::vector<Bspline_function<Target>> functions;
    for (const Function& f : m_functions)
      functions.push_back(f.template converted<Target>([](const NT& x) { return converted_number<Target>(x); }));
    for (int j = 0; j < dimension(); ++j)
      check_number_of_pieces(m_functions[0], functions[0], j);
    return Homogeneous_spline<Target, d>(std::move(functions), who);
  }

  // The map of the functions as stored, in exact numbers.
  Homogeneous_spline<Exact_rational, d> exact() const
  {
    if constexpr (std::is_same_v<NT, Exact_rational>)
      return *this;
    else
      return converted<Exact_rational>("an exact copy");
  }

  // On one occurrence of a knot less, if this is the same map; decided exactly.
  std::optional<Homogeneous_spline> without_knot(int axis, const NT& t) const
  {
    const std::pair<NT, NT> domain = m_functions[0].domain(axis);
    const std::vector<NT>& knots = m_functions[0].knots(axis);
    if (!(domain.first < t && t < domain.second) || std::find(knots.begin(), knots.end(), t) == knots.end())
      throw Invalid_input("the knot to remove on axis " + std::to_string(axis) +
                          " is not there, or not inside the domain");
    const Homogeneous_spline<Exact_rational, d> fine = exact();
    std::vector<Exact_function> functions;
    for (const Exact_function& f : fine.functions()) {
      std::optional<Exact_function> coarser = internal::without_knot(f, axis, converted_number<Exact_rational>(t));
      if (!coarser)
        return std::nullopt;
      functions.push_back(std::move(*coarser));
    }
    return Homogeneous_spline<Exact_rational, d>(std::move(functions), "a removed knot")
        .template converted<NT>("a removed knot");
  }

  /*
  An interval for each coordinate that contains it on the whole domain: the hull of the Euclidean control points, which
  holds where all control weights are positive; elsewhere parts are halved until they are.
  */
  std::array<CGAL::Interval_nt<false>, d> bounds() const
  {
    Upward_rounding_guard guard;
    std::array<CGAL::Interval_nt<false>, d> result;
    for (int i = 0; i < d; ++i) {
      std::optional<CGAL::Interval_nt<false>> hull;
      const auto add_quotients = [&](const auto& numerators, const auto& weights) {
        for (std::size_t k = 0; k < numerators.size(); ++k) {
          CGAL::Interval_nt<false> x = enclosed(numerators[k]);
          if (!weights.empty())
            x /= enclosed(weights[k]);
          hull =
              hull ? CGAL::Interval_nt<false>((std::min)(hull->inf(), x.inf()), (std::max)(hull->sup(), x.sup())) : x;
        }
      };
      if (!is_rational())
        add_quotients(m_functions[i].coefficients(), std::vector<NT>());
      else if (common_sign(m_functions[d].bounds()) > 0)
        add_quotients(m_functions[i].coefficients(), m_functions[d].coefficients());
      else
        for_each_part_of_one_sign(exact_pieces(m_functions[i]), exact_pieces(m_functions[d]), Weight_options(),
                                  [&](const auto& numerator, const auto& weight) {
                                    add_quotients(numerator.coefficients(), weight.coefficients());
                                  });
      result[i] = *hull;
    }
    return result;
  }

  // The image under x -> A x + b, `matrix(i, j)` with column d for b.
  template <class Matrix>
  Homogeneous_spline transformed(const Matrix& matrix) const
  {
    std::vector<Function> functions = m_functions;
    for (int i = 0; i < d; ++i) {
      std::vector<NT> image;
      for (std::size_t k = 0; k < functions[i].coefficients().size(); ++k) {
        NT x = NT(matrix(i, d) * control_weight(k));
        for (int j = 0; j < d; ++j)
          x += matrix(i, j) * m_functions[j].coefficients()[k];
        image.push_back(x);
      }
      functions[i] = with_coefficients(functions[i], std::move(image));
    }
    return Homogeneous_spline(std::move(functions), "the image of a spline");
  }

  // Whether both are the same map on the same domain, exactly, whatever their knots, degrees and weights.
  bool is_same_map(const Homogeneous_spline& other) const
  {
    for (int j = 0; j < dimension(); ++j)
      if (m_functions[0].domain(j) != other.m_functions[0].domain(j))
        return false;
    const Homogeneous_spline<Exact_rational, d> a = exact(), b = other.exact();
    const Exact_function weight_of_a = a.weight(), weight_of_b = b.weight();
    for (int i = 0; i < d; ++i)
      if (!(a.numerator(i) * weight_of_b == b.numerator(i) * weight_of_a))
        return false;
    return true;
  }

private:
  static CGAL::Interval_nt<false> enclosed(double x) { return CGAL::Interval_nt<false>(x); }
  static CGAL::Interval_nt<false> enclosed(const Exact_rational& x)
  {
    return Number_traits<Exact_rational>::enclosure(x);
  }

  // Knots and numbers of control points are checked once, and shared.
  void add_function(const std::vector<int>& degrees, const std::vector<std::vector<NT>>& knots,
                    std::vector<NT> coefficients)
  {
    if (m_functions.empty()) {
      m_functions.emplace_back(degrees, knots, std::move(coefficients));
      return;
    }
    check_finite(coefficients, "Bspline_function: control point");
    m_functions.push_back(Function::on_axes(m_functions[0].axes(), std::move(coefficients)));
  }

  static void check_weights(const std::vector<NT>& weights, std::size_t number_of_points, const std::string& who)
  {
    if (weights.empty())
      return;
    check_count(weights.size(), number_of_points, who + ": weights");
    check_finite(weights, who + ": weight");
    for (std::size_t k = 0; k < weights.size(); ++k)
      if (weights[k] == NT(0))
        throw Invalid_input(who + ": weight " + std::to_string(k) + " is zero");
  }

  // Makes the weight positive, or throws, and leaves it out where it is constant.
  void normalise_weight(const std::string& who)
  {
    if (!is_rational())
      return;
    if (sign_of_weight(who) < 0)
      for (Function& f : m_functions)
        f = -f;
    drop_constant_weight();
  }

  // Leaves out a weight that is constantly one, or can be made so exactly.
  void drop_constant_weight()
  {
    if (!is_rational())
      return;
    const std::pair<NT, NT> range = m_functions[d].bounds();
    if (range.first != range.second || range.first == NT(0) || (std::is_floating_point_v<NT> && range.first != NT(1)))
      return;
    m_functions.pop_back();
    if (range.first != NT(1))
      for (Function& f : m_functions)
        f = f * NT(NT(1) / range.first);
  }

  int sign_of_weight(const std::string& who) const
  {
    try {
      return certified_weight_sign(m_functions[d], Weight_options());
    } catch (const Invalid_input& error) {
      // Which control weights are to blame is known here only.
      const std::vector<NT>& weights = m_functions[d].coefficients();
      const auto bad = std::find_if(weights.begin(), weights.end(),
                                    [&](const NT& w) { return !((w > NT(0)) == (weights[0] > NT(0)) && w != NT(0)); });
      throw Invalid_input(who + ": the weight is not positive everywhere (control weight " +
                          std::to_string(bad - weights.begin()) + "): " + error.what());
    }
  }

  // The derivatives of numerators and weight, from one set of basis functions for all of them.
  std::map<std::vector<int>, std::vector<NT>> homogeneous_derivatives(std::span<const NT> u, int order) const
  {
    if (order < 0)
      throw Invalid_input("the order of a derivative is negative");
    const Local_weights<NT> weights(m_functions[0].axes(), u, order, "");
    std::map<std::vector<int>, std::vector<NT>> result;
    for (const Function& f : m_functions)
      weights.derivatives(f.coefficients(), order, [&](const std::vector<int>& derivative, const NT& value) {
        result[derivative].push_back(value);
      });
    return result;
  }

  // Leibniz' rule for numerator = weight * quotient, solved for the highest derivative of the quotient.
  static void divide_by_weight(Coordinates& derivative, const std::vector<int>& orders,
                               const std::map<std::vector<int>, std::vector<NT>>& homogeneous,
                               const std::map<std::vector<int>, Coordinates>& lower)
  {
    const std::size_t n = orders.size();
    for_each_index(orders, [&](const std::vector<int>& part) {
      if (part == std::vector<int>(n, 0))
        return;
      NT factor = homogeneous.at(part)[d];
      std::vector<int> rest = orders;
      for (std::size_t j = 0; j < n; ++j) {
        factor *= binomials<NT>(orders[j])[part[j]];
        rest[j] -= part[j];
      }
      const Coordinates& other = lower.at(rest);
      for (int i = 0; i < d; ++i)
        derivative[i] -= factor * other[i];
    });
    const NT& weight = homogeneous.at(std::vector<int>(n, 0))[d];
    for (NT& x : derivative)
      x /= weight;
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template int certified_weight_sign(const Bspline_function<double>&, const Weight_options&);
extern template int certified_weight_sign(const Bspline_function<Exact_rational>&, const Weight_options&);
extern template class Homogeneous_spline<double, 2>;
extern template class Homogeneous_spline<double, 3>;
extern template class Homogeneous_spline<Exact_rational, 2>;
extern template class Homogeneous_spline<Exact_rational, 3>;
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_HOMOGENEOUS_SPLINE_H
