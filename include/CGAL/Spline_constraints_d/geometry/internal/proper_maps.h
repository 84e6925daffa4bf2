// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_PROPER_MAPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_PROPER_MAPS_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Echelon_form.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/decompositions_declarations.h>
#include <CGAL/Spline_constraints_d/function/internal/left_components.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Proper {

// The map from a line to a curve: numerators and, last, the weight, as polynomials in one unknown without a common
// factor. Equal maps have equal representations: the leading coefficient of the weight is positive.
using Curve_map = std::vector<Integer_coefficients>;
using Homogeneous_point = std::vector<Big_integer>;

inline std::size_t degree_of(const Curve_map& map)
{
  std::size_t size = 1;
  for (const Integer_coefficients& f : map)
    size = (std::max)(size, f.size());
  return size - 1;
}

inline Integer_coefficients common_divisor_of(const Curve_map& polynomials)
{
  Integer_polynomial result;
  for (const Integer_coefficients& f : polynomials)
    if (!f.empty())
      result = common_divisor(result, Integer_polynomial(f));
  return primitive_part(result.coefficients());
}

// \pre The weight is not zero.
inline Curve_map in_lowest_terms(Curve_map map)
{
  if (const Integer_coefficients common = common_divisor_of(map); common.size() > 1)
    for (Integer_coefficients& f : map)
      f = exact_quotient(std::move(f), common).value();
  divide_by_common_content(map);
  if (map.back().back() < 0)
    for (Integer_coefficients& f : map)
      for (Big_integer& x : f)
        x = -x;
  return map;
}

// After a function that is not constant.
inline Curve_map composed(const Curve_map& map, const Polynomial_quotient& h)
{
  const std::size_t n = degree_of(map);
  const std::vector<Integer_coefficients> p = powers_of(h.numerator_coefficients(), n + 1),
                                          q = powers_of(h.denominator_coefficients(), n + 1);
  Curve_map result;
  for (const Integer_coefficients& f : map) {
    Integer_coefficients& own = result.emplace_back();
    for (std::size_t k = 0; k < f.size(); ++k)
      add_multiple(own, product_of(p[k], q[n - k]), f[k]);
    own = trimmed(std::move(own));
  }
  return in_lowest_terms(std::move(result));
}

inline Homogeneous_point point_at(const Curve_map& map, const Exact_rational& t)
{
  const std::size_t n = degree_of(map);
  Homogeneous_point result;
  for (const Integer_coefficients& f : map)
    result.push_back(homogeneous_value(f, n, numerator_of(t), denominator_of(t)));
  return result;
}

inline Homogeneous_point point_at_infinity(const Curve_map& map)
{
  const std::size_t n = degree_of(map);
  Homogeneous_point result;
  for (const Integer_coefficients& f : map)
    result.push_back(f.size() == n + 1 ? f.back() : Big_integer(0));
  return result;
}

inline bool are_same_point(const Homogeneous_point& a, const Homogeneous_point& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (a[i] * b[j] != a[j] * b[i])
        return false;
  return true;
}

// A polynomial whose zeros are the parameters of a point with a weight that is not zero.
inline Integer_coefficients parameters_of_point(const Curve_map& map, const Homogeneous_point& point)
{
  Curve_map equations;
  for (std::size_t i = 0; i + 1 < map.size(); ++i) {
    Integer_coefficients& equation = equations.emplace_back();
    add_multiple(equation, map[i], point.back());
    add_multiple(equation, map.back(), Big_integer(-point[i]));
    equation = trimmed(std::move(equation));
  }
  return common_divisor_of(equations);
}

// A point of a curve at a rational parameter, with all of its parameters, infinity being none.
struct Fibre_of_point
{
  Homogeneous_point point;
  Integer_coefficients parameters;
};

// For the next number of a sequence, if it has such a one.
inline std::optional<Fibre_of_point> fibre_at(const Curve_map& map, const Exact_rational& t)
{
  Homogeneous_point point = point_at(map, t);
  if (point.back() == 0 || are_same_point(point, point_at_infinity(map)))
    return std::nullopt;
  Integer_coefficients parameters = parameters_of_point(map, point);
  return Fibre_of_point{std::move(point), std::move(parameters)};
}

// A map as one that takes almost no point twice, after a function h.
struct Proper_map
{
  Curve_map map;
  Polynomial_quotient h;

  int tracing_index() const { return h.degree(); }
};

// The map with map o (p/q) = the given one, if there is one.
inline std::optional<Curve_map> left_component_of_map(const Curve_map& map, const Pencil& pencil)
{
  const std::size_t n = degree_of(map), k = pencil.p.size() - 1;
  if (n % k != 0)
    return std::nullopt;
  const Left_components components(pencil, n / k);
  std::vector<std::vector<Exact_rational>> result;
  for (const Integer_coefficients& f : map) {
    auto own = components(f);
    if (!own)
      return std::nullopt;
    result.push_back(std::move(*own));
  }
  return in_lowest_terms(with_integers(result));
}

/*
Almost all points have as many parameters as the map has the tracing index k, the others more or fewer, but those whose
parameters are all finite have at least k: they are the zeros of h - h(a). Two points with the fewest so far give a
candidate for h, with a zero in the parameters of the first and poles in those of the second. It is right exactly if the
map factors through it: then k is a multiple of its degree, which is at least k. Finitely many points mislead.
*/
inline Proper_map proper_map(const Curve_map& map, Interruption& interruption)
{
  const std::size_t n = degree_of(map);
  const Polynomial_quotient identity(Integer_coefficients{Big_integer(0), Big_integer(1)},
                                     Integer_coefficients(1, Big_integer(1)));
  std::vector<Fibre_of_point> fewest;
  for (int index = 0;; ++index) {
    interruption.add_work(64 * (n + 1) * (n + 1));
    std::optional<Fibre_of_point> fibre = fibre_at(map, small_rational(index));
    if (!fibre)
      continue;
    if (fibre->parameters.size() == 2)
      return {map, identity};
    if (!fewest.empty() && fewest.front().parameters.size() < fibre->parameters.size())
      continue;
    if (!fewest.empty() && fewest.front().parameters.size() > fibre->parameters.size())
      fewest.clear();
    for (const Fibre_of_point& other : fewest)
      if (!are_same_point(other.point, fibre->point)) {
        const Pencil pencil(other.parameters, fibre->parameters);
        if (std::optional<Curve_map> result = left_component_of_map(map, pencil))
          return {std::move(*result), pencil.function()};
      }
    fewest.push_back(std::move(*fibre));
  }
}

/*
The fractional linear function m with a o m = b, for proper maps, if there is one: if they have the same image. Then
almost all points of b have one parameter of a; three of them determine m. A point without one, at infinity neither,
proves that the images are different.
*/
inline std::optional<Polynomial_quotient> map_between(const Curve_map& a, const Curve_map& b,
                                                      Interruption& interruption)
{
  const std::size_t n = degree_of(a);
  if (degree_of(b) != n)
    return std::nullopt;
  Echelon_form equations; // of m0, ..., m3 with (m0 v + m1) / (m2 v + m3) = u
  for (int index = 0; equations.rank() < 3; ++index) {
    interruption.add_work(64 * (n + 1) * (n + 1));
    const Exact_rational v = small_rational(index);
    const Homogeneous_point point = point_at(b, v);
    if (point.back() == 0)
      continue;
    const Integer_coefficients parameters = parameters_of_point(a, point);
    if (parameters.size() == 1 && !are_same_point(point, point_at_infinity(a)))
      return std::nullopt;
    if (parameters.size() != 2 || are_same_point(point, point_at_infinity(a)))
      continue;
    const Exact_rational u = -scaled_rational(parameters[0], 0) / scaled_rational(parameters[1], 0);
    equations.add({v, Exact_rational(1), Exact_rational(-u * v), Exact_rational(-u)});
  }
  Integer_coefficients m = with_integers({equations.orthogonal_vector(4)})[0];
  m.resize(4, Big_integer(0));
  Polynomial_quotient result(Integer_coefficients{m[1], m[0]}, Integer_coefficients{m[3], m[2]});
  return result.degree() == 1 && composed(a, result) == b ? std::optional(std::move(result)) : std::nullopt;
}

} // namespace Proper
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_PROPER_MAPS_H
