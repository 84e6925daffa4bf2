// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_PARAMETER_MAPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_PARAMETER_MAPS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_face_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Takes local parameters of a cell to those of another one: s = a u + b and t = c v + d, or with u and v exchanged.
struct Parameter_map
{
  std::array<std::pair<Exact_rational, Exact_rational>, 2> lines; // by the axis of the first cell: factor and offset
  bool is_exchanged;

  std::size_t image(std::size_t axis) const { return is_exchanged ? 1 - axis : axis; }

  // The number of an axis that is taken to this one.
  Exact_rational preimage(std::size_t axis, const Exact_rational& x) const
  {
    return Exact_rational((x - lines[axis].second) / lines[axis].first);
  }
};

/*
Finds an affine map q of the parameters with A = B o q for two cells, as polynomials. Candidates are proved by
substitution. They come from the leading coefficients of the products of highest powers: with A = k B o q, for u^m v^n

  a_mn = k a^m c^n b_mn,  a_{m-1,n} = k a^{m-1} c^n (b_{m-1,n} + m b b_mn),

so that a is the ratio of (a_mn)^2 to the wedge product of both vectors, and from coordinates that are linear functions
of one parameter.
*/
class Parameter_maps
{
  using Homogeneous = std::array<Power_polynomial, 4>;
  using Vector = std::array<Exact_rational, 4>;
  using Line = std::pair<Exact_rational, Exact_rational>;

  Homogeneous m_first, m_second;

public:
  Parameter_maps(const Surface_cell_3& first, const Surface_cell_3& second)
    : m_first(polynomials(first)), m_second(polynomials(second))
  {}

  std::optional<Parameter_map> operator()() const
  {
    for (const bool is_exchanged : {false, true}) {
      const Homogeneous other = is_exchanged ? exchanged(m_second) : m_second;
      for (const auto& candidate : {by_leading_coefficients(other), by_linear_coordinates(other)})
        if (candidate && is_map(other, *candidate))
          return Parameter_map{*candidate, is_exchanged};
    }
    return std::nullopt;
  }

private:
  using Lines = std::array<Line, 2>;

  static Homogeneous polynomials(const Surface_cell_3& cell)
  {
    Homogeneous result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = polynomial_of(cell.coordinates[i]);
    return result;
  }

  static Homogeneous exchanged(const Homogeneous& f)
  {
    Homogeneous result;
    for (std::size_t i = 0; i < 4; ++i)
      for (const auto& [monomial, coefficient] : f[i].terms())
        result[i] += Power_polynomial(coefficient) * pow(Power_polynomial::variable(0), monomial.exponent(1)) *
            pow(Power_polynomial::variable(1), monomial.exponent(0));
    return result;
  }

  static int degree(const Homogeneous& f, int axis)
  {
    int result = 0;
    for (const Power_polynomial& x : f)
      for (const auto& [monomial, coefficient] : x.terms())
        result = (std::max)(result, static_cast<int>(monomial.exponent(axis)));
    return result;
  }

  static Vector coefficient(const Homogeneous& f, int m, int n)
  {
    Vector result{};
    for (std::size_t i = 0; i < 4; ++i)
      for (const auto& [monomial, value] : f[i].terms())
        if (monomial.exponent(0) == m && monomial.exponent(1) == n)
          result[i] = value;
    return result;
  }

  static bool is_zero(const Vector& v)
  {
    return std::ranges::all_of(v, [](const Exact_rational& x) { return x == 0; });
  }

  // The factor by which the first vector is the second one.
  static std::optional<Exact_rational> ratio(const std::vector<Exact_rational>& a, const std::vector<Exact_rational>& b)
  {
    const auto pivot = std::ranges::find_if(b, [](const Exact_rational& x) { return x != 0; });
    if (pivot == b.end())
      return std::nullopt;
    const Exact_rational factor(a[static_cast<std::size_t>(pivot - b.begin())] / *pivot);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != factor * b[i])
        return std::nullopt;
    return factor == 0 ? std::nullopt : std::optional(factor);
  }

  static std::vector<Exact_rational> wedge(const Vector& a, const Vector& b)
  {
    std::vector<Exact_rational> result;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        result.push_back(Exact_rational(a[i] * b[j] - a[j] * b[i]));
    return result;
  }

  std::optional<Lines> by_leading_coefficients(const Homogeneous& other) const
  {
    const int m = degree(m_first, 0), n = degree(m_first, 1);
    if (degree(other, 0) != m || degree(other, 1) != n || m == 0 || n == 0)
      return std::nullopt;
    const Vector a = coefficient(m_first, m, n), b = coefficient(other, m, n);
    const auto leading = ratio({a.begin(), a.end()}, {b.begin(), b.end()});
    if (!leading)
      return std::nullopt;
    Lines result;
    for (const std::size_t axis : {0, 1}) {
      const Vector below_a = coefficient(m_first, axis == 0 ? m - 1 : m, axis == 0 ? n : n - 1),
                   below_b = coefficient(other, axis == 0 ? m - 1 : m, axis == 0 ? n : n - 1);
      const auto area = ratio(wedge(below_a, a), wedge(below_b, b));
      if (!area)
        return std::nullopt;
      const Exact_rational factor(*leading * *leading / *area);
      // a_{m-1,n} factor / leading - b_{m-1,n} = m offset b_mn
      Vector rest;
      for (std::size_t i = 0; i < 4; ++i)
        rest[i] = below_a[i] * factor / *leading - below_b[i];
      const auto offset =
          is_zero(rest) ? std::optional(Exact_rational(0)) : ratio({rest.begin(), rest.end()}, {b.begin(), b.end()});
      if (!offset)
        return std::nullopt;
      result[axis] = {factor, Exact_rational(*offset / (axis == 0 ? m : n))};
    }
    return result;
  }

  // c_0 + c_1 u for the coordinate of a polynomial surface.
  static std::optional<Line> linear(const Homogeneous& f, std::size_t coordinate, int axis)
  {
    if (!f[3].is_constant())
      return std::nullopt;
    Line result(0, 0);
    for (const auto& [monomial, value] : f[coordinate].terms()) {
      if (monomial.exponent(1 - axis) > 0 || monomial.exponent(axis) > 1)
        return std::nullopt;
      (monomial.exponent(axis) == 1 ? result.first : result.second) = value / f[3].constant_term();
    }
    return result.first == 0 ? std::nullopt : std::optional(result);
  }

  std::optional<Lines> by_linear_coordinates(const Homogeneous& other) const
  {
    Lines result;
    for (const std::size_t axis : {0, 1}) {
      bool is_known = false;
      for (std::size_t i = 0; i < 3 && !is_known; ++i) {
        const auto own = linear(m_first, i, static_cast<int>(axis)), line = linear(other, i, static_cast<int>(axis));
        if (!own || !line)
          continue;
        result[axis] = {Exact_rational(own->first / line->first),
                        Exact_rational((own->second - line->second) / line->first)};
        is_known = true;
      }
      if (!is_known)
        return std::nullopt;
    }
    return result;
  }

  bool is_map(const Homogeneous& other, const Lines& lines) const
  {
    Homogeneous image = other;
    for (Power_polynomial& f : image)
      for (const int axis : {0, 1}) {
        const auto& [factor, offset] = lines[static_cast<std::size_t>(axis)];
        f = f.substituted(axis, Power_polynomial(factor) * Power_polynomial::variable(axis) + Power_polynomial(offset));
      }
    for (std::size_t i = 0; i < 3; ++i)
      if (!(m_first[i] * image[3] == image[i] * m_first[3]))
        return false;
    return true;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_PARAMETER_MAPS_H
