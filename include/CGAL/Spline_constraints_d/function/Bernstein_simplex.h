// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_SIMPLEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_SIMPLEX_H

#include <CGAL/Spline_constraints_d/function/internal/simplex/Simplex_index.h>
#include <CGAL/Spline_constraints_d/function/internal/simplex/simplex_kernels.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/concepts.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A polynomial of total degree \f$k\f$ in Bernstein form on a simplex:
\f$f(\tau) = \sum_{|\lambda| = k} b_\lambda \frac{k!}{\lambda!} \tau^\lambda\f$ with barycentric coordinates
\f$\tau_0 + \dots + \tau_d = 1\f$. The vertices are not stored: as `Bernstein_tensor` is on the unit box, this is on any
simplex. A cubic in space has 20 coefficients, 64 on a box.

Coefficients are in lexicographic order of exponents, from \f$(k,0,\dots,0)\f$ down to \f$(0,\dots,0,k)\f$. They are the
values of the polar form, the symmetric function \f$F\f$ of \f$k\f$ points, affine in each, with
\f$F(\tau,\dots,\tau) = f(\tau)\f$, at the vertices: \f$b_\lambda\f$ has \f$\lambda_i\f$ times vertex \f$i\f$. All
operations are exact when `NT` is; interval types enclose, under their rounding guard; `double` rounds.

\tparam NT a model of `SplineNumberType`.
\tparam d the dimension, at least 1.

Source: Ramshaw, Blossoming, 1987; Farin, Triangular Bernstein-Bézier patches, 1986.
*/
template <SplineNumberType NT, int d>
class Bernstein_simplex
{
  static_assert(d >= 1, "Bernstein_simplex: a simplex has at least two vertices");

  using Index = internal::Simplex_index<d>;

  int m_degree = 0;
  std::vector<NT> m_coefficients;

  template <SplineNumberType Other, int m>
  friend class Bernstein_simplex;

  // Results of operations: nothing left to check.
  struct Unchecked
  {};
  Bernstein_simplex(Unchecked, int degree, std::vector<NT> coefficients)
    : m_degree(degree), m_coefficients(std::move(coefficients))
  {}

public:
  //! the type of coefficients and values.
  using Number_type = NT;

  //! barycentric coordinates of a point.
  using Barycentric = std::array<NT, d + 1>;

  //! exponents of barycentric coordinates.
  using Exponents = std::array<int, d + 1>;

  //! number of barycentric coordinates less one.
  static constexpr int dimension = d;

  //! greatest degree of what the constructor takes.
  static constexpr int maximal_degree = 30;

  //! greatest degree of what operations make.
  static constexpr int maximal_degree_of_results = 4 * maximal_degree;

  //! the constant zero.
  Bernstein_simplex() : m_coefficients(1, NT(0)) {}

  //! \throws Invalid_input when the degree is negative or above 30, the number of coefficients is not
  //! `number_of_coefficients(degree)`, or one is not finite.
  Bernstein_simplex(int degree, std::vector<NT> coefficients)
    : m_degree(degree), m_coefficients(std::move(coefficients))
  {
    check_degree(degree, maximal_degree);
    internal::check_count(m_coefficients.size(), number_of_coefficients(degree),
                          "Bernstein_simplex: number of coefficients");
    internal::check_finite(m_coefficients, "Bernstein_simplex: coefficient");
  }

  //! the constant function.
  static Bernstein_simplex constant(const NT& value) { return Bernstein_simplex(0, {value}); }

  //! the affine function with these values at the vertices.
  static Bernstein_simplex affine(const std::array<NT, d + 1>& values)
  {
    return Bernstein_simplex(1, {values.begin(), values.end()});
  }

  //! \f$\binom{k+d}{d}\f$.
  static std::size_t number_of_coefficients(int degree) { return internal::simplex_size(degree, d); }

  //! the place of a coefficient.
  static std::size_t position_of(const Exponents& exponents) { return Index::position_of(exponents); }

  int degree() const { return m_degree; }

  const std::vector<NT>& coefficients() const& { return m_coefficients; }

  //! the same, moved out of a simplex that is not needed any more.
  std::vector<NT> coefficients() && { return std::move(m_coefficients); }

  //! the coefficient with these exponents, whose sum is the degree.
  const NT& coefficient(const Exponents& exponents) const
  {
    const std::size_t position = position_of(exponents);
    CGAL_precondition(position < m_coefficients.size());
    return m_coefficients[position];
  }

  //! the coefficients with exponents, in order: `visitor(exponents, coefficient)`.
  template <class Visitor>
  void visit_coefficients(const Visitor& visitor) const
  {
    for (Index index(m_degree); index.is_valid(); ++index) {
      Exponents exponents;
      for (int i = 0; i <= d; ++i)
        exponents[i] = index.exponent(i);
      visitor(exponents, m_coefficients[index.position()]);
    }
  }

  /// \name Values and parts
  /// @{

  /*!
  the value at a point, inside of the simplex or not, by de Casteljau's algorithm. In `double`, and inside, the error is
  at most \f$\gamma_m \max|b|\f$ with \f$m = (d+2)k\f$, \f$\gamma_m = m\epsilon/(1-m\epsilon)\f$,
  \f$\epsilon = 2^{-52}\f$. Complexity: \f$(d+1)\binom{k+d}{d+1}\f$ multiplications.
  */
  NT operator()(const Barycentric& tau) const
  {
    std::vector<NT> net = m_coefficients;
    for (int k = m_degree; k > 0; --k)
      internal::contract_simplex<d>(net, k, tau);
    return net[0];
  }

  //! the polar form at as many points as the degree says, in any order. \throws Invalid_input when they are more or
  //! fewer.
  NT blossom(std::span<const Barycentric> points) const
  {
    internal::check_count(points.size(), static_cast<std::size_t>(m_degree), "Bernstein_simplex: arguments of blossom");
    std::vector<NT> net = m_coefficients;
    for (int k = m_degree; k > 0; --k)
      internal::contract_simplex<d>(net, k, points[k - 1]);
    return net[0];
  }

  //! the same polynomial on the simplex in which a point takes the place of a vertex; the simplex may be a flat one.
  Bernstein_simplex replaced(int vertex, const Barycentric& point) const
  {
    CGAL_precondition(0 <= vertex && vertex <= d);
    return replaced<1>({vertex}, point)[0];
  }

  //! the parts into which a point cuts the simplex: in part \f$i\f$ it takes the place of vertex \f$i\f$.
  std::array<Bernstein_simplex, d + 1> split(const Barycentric& point) const
  {
    std::array<int, d + 1> all;
    for (int i = 0; i <= d; ++i)
      all[i] = i;
    return replaced<d + 1>(all, point);
  }

  //! the parts into which the point \f$(1-t)\,x_i + t\,x_j\f$ of an edge cuts the simplex: the one with vertex \f$i\f$,
  //! where it takes the place of \f$x_j\f$, and the one with vertex \f$j\f$.
  std::pair<Bernstein_simplex, Bernstein_simplex> split(int i, int j, const NT& t) const
  {
    CGAL_precondition(is_edge(i, j));
    Barycentric point;
    point.fill(NT(0));
    point[i] = NT(1) - t;
    point[j] = t;
    auto parts = replaced<2>({j, i}, point);
    return {std::move(parts[0]), std::move(parts[1])};
  }

  //! the same at one half.
  std::pair<Bernstein_simplex, Bernstein_simplex> split(int i, int j) const
  {
    return split(i, j, Number_traits<NT>::from_double(0.5));
  }

  /*!
  the same polynomial on another simplex, of the same or a lower dimension \f$m\f$, with these vertices: the polar form
  at them. It may be anywhere, and flat. Complexity: \f$O(k^{d+m})\f$.
  */
  template <std::size_t count>
  Bernstein_simplex<NT, static_cast<int>(count) - 1> restricted(const std::array<Barycentric, count>& vertices) const
  {
    Bernstein_simplex<NT, static_cast<int>(count) - 1> result;
    result.m_degree = m_degree;
    result.m_coefficients.assign(internal::simplex_size(m_degree, static_cast<int>(count) - 1), NT(0));
    std::array<int, count> exponents{};
    fill_restriction(result, vertices, 0, m_degree, m_coefficients, exponents);
    return result;
  }

  //! the restriction to a face, with its vertices in this order: the coefficients that have no others.
  template <std::size_t count>
  Bernstein_simplex<NT, static_cast<int>(count) - 1> face(const std::array<int, count>& vertices) const
  {
    using Face = Bernstein_simplex<NT, static_cast<int>(count) - 1>;
    std::vector<NT> coefficients;
    for (internal::Simplex_index<static_cast<int>(count) - 1> index(m_degree); index.is_valid(); ++index) {
      Exponents exponents{};
      for (std::size_t i = 0; i < count; ++i)
        exponents[vertices[i]] = index.exponent(static_cast<int>(i));
      coefficients.push_back(m_coefficients[position_of(exponents)]);
    }
    return Face(typename Face::Unchecked(), m_degree, std::move(coefficients));
  }

  //! the coefficient, and value, at a vertex.
  const NT& at_vertex(int i) const
  {
    Exponents exponents{};
    exponents[i] = m_degree;
    return coefficient(exponents);
  }

  /// @}

  /// \name Derivatives
  /// @{

  //! the derivative of the homogeneous polynomial in \f$\tau_0,\dots,\tau_d\f$ by one of them, of degree \f$k-1\f$;
  //! the coefficients of its second derivatives are \f$k(k-1)\, b_{\mu+e_i+e_j}\f$.
  Bernstein_simplex partial_derivative(int i) const
  {
    if (m_degree == 0)
      return Bernstein_simplex();
    std::vector<NT> coefficients;
    for (Index index(m_degree - 1); index.is_valid(); ++index)
      coefficients.push_back(NT(m_degree) * m_coefficients[index.raised()[i]]);
    return Bernstein_simplex(Unchecked(), m_degree - 1, std::move(coefficients));
  }

  //! the derivative along the vector that is the difference of two points with these differences of barycentric
  //! coordinates, whose sum is 0.
  Bernstein_simplex derivative(const Barycentric& direction) const
  {
    if (m_degree == 0)
      return Bernstein_simplex();
    std::vector<NT> net = m_coefficients;
    internal::contract_simplex<d>(net, m_degree, direction);
    for (NT& x : net)
      x *= NT(m_degree);
    return Bernstein_simplex(Unchecked(), m_degree - 1, std::move(net));
  }

  //! the derivative along the edge from vertex \f$i\f$ to vertex \f$j\f$.
  Bernstein_simplex derivative(int i, int j) const
  {
    CGAL_precondition(is_edge(i, j));
    Barycentric direction;
    direction.fill(NT(0));
    direction[i] = NT(-1);
    direction[j] = NT(1);
    return derivative(direction);
  }

  //! the value of that derivative at vertex \f$i\f$: \f$k\,(b_{(k-1)e_i+e_j} - b_{k e_i})\f$.
  NT derivative_at_vertex(int i, int j) const
  {
    CGAL_precondition(is_edge(i, j));
    if (m_degree == 0)
      return NT(0);
    Exponents next{};
    next[i] = m_degree - 1;
    next[j] = 1;
    return NT(m_degree) * NT(coefficient(next) - at_vertex(i));
  }

  /// @}

  /// \name Bounds and signs
  /// @{

  //! least and greatest coefficient, which bound the function on the simplex. \sa Bernstein_tensor::bounds()
  std::pair<NT, NT> bounds() const { return internal::least_and_greatest(m_coefficients); }

  //! the sign that the function has on all of the closed simplex, if the coefficients tell.
  CGAL::Uncertain<CGAL::Sign> sign() const
  {
    const CGAL::Uncertain<CGAL::Sign> first = Number_traits<NT>::sign(m_coefficients.front());
    if (!CGAL::is_certain(first))
      return first;
    for (const NT& x : m_coefficients)
      if (!CGAL::certainly(Number_traits<NT>::sign(x) == first))
        return CGAL::Uncertain<CGAL::Sign>::indeterminate();
    return first;
  }

  //! A sign, and the vertices where the function is 0 instead.
  struct Sign_but_at_vertices
  {
    CGAL::Uncertain<CGAL::Sign> sign = CGAL::Uncertain<CGAL::Sign>::indeterminate();
    std::array<bool, d + 1> is_zero{};
  };

  //! the sign, not zero, that the function has on all of the closed simplex but at some of its vertices, where it is
  //! zero: no coefficient has the other sign, and none of the edges has coefficients 0 only.
  Sign_but_at_vertices sign_but_at_vertices() const
  {
    std::array<std::array<bool, d + 1>, d + 1> has_sign{}; // of edges, and of vertices
    CGAL::Sign sign = CGAL::ZERO;
    for (Index index(m_degree); index.is_valid(); ++index) {
      const CGAL::Uncertain<CGAL::Sign> own = Number_traits<NT>::sign(m_coefficients[index.position()]);
      if (!CGAL::is_certain(own) || own.inf() * sign < 0)
        return {};
      if (own.inf() == CGAL::ZERO)
        continue;
      sign = own.inf();
      for (int i = 0; i <= d; ++i)
        for (int j = 0; j <= d; ++j)
          if ((index.support() & ~(1u << i | 1u << j)) == 0)
            has_sign[i][j] = true;
    }
    Sign_but_at_vertices result;
    for (int i = 0; i <= d; ++i) {
      for (int j = 0; j < i; ++j)
        if (!has_sign[i][j])
          return {};
      result.is_zero[i] = !has_sign[i][i];
    }
    result.sign = sign;
    return result;
  }

  /// @}

  /// \name Arithmetic
  /// @{

  //! the same function with a higher degree. \throws Invalid_input when it is lower than the present one, or above 120.
  Bernstein_simplex elevated(int degree) const
  {
    check_degree(degree, maximal_degree_of_results);
    if (degree < m_degree)
      throw Invalid_input("Bernstein_simplex: degree " + std::to_string(m_degree) + " cannot be elevated to " +
                          std::to_string(degree));
    Bernstein_simplex result = *this;
    for (int k = m_degree; k < degree; ++k)
      result.m_coefficients = internal::elevated_simplex<d>(result.m_coefficients, k);
    result.m_degree = degree;
    return result;
  }

  //! sum; a lower degree is elevated.
  Bernstein_simplex& operator+=(const Bernstein_simplex& other)
  {
    return combine(other, [](NT& a, const NT& b) { a += b; });
  }

  //! difference; a lower degree is elevated.
  Bernstein_simplex& operator-=(const Bernstein_simplex& other)
  {
    return combine(other, [](NT& a, const NT& b) { a -= b; });
  }

  //! product; degrees add up. Complexity: a multiplication for each pair of coefficients. \throws Invalid_input when
  //! the degree becomes larger than 120.
  Bernstein_simplex& operator*=(const Bernstein_simplex& other)
  {
    check_degree(m_degree + other.m_degree, maximal_degree_of_results);
    m_coefficients = internal::simplex_product<d>(m_coefficients, m_degree, other.m_coefficients, other.m_degree);
    m_degree += other.m_degree;
    return *this;
  }

  //! multiplies by a constant, which comes by value since it may be one of the coefficients.
  Bernstein_simplex& operator*=(NT factor)
  {
    for (NT& x : m_coefficients)
      x *= factor;
    return *this;
  }

  friend Bernstein_simplex operator+(Bernstein_simplex a, const Bernstein_simplex& b) { return std::move(a += b); }
  friend Bernstein_simplex operator-(Bernstein_simplex a, const Bernstein_simplex& b) { return std::move(a -= b); }
  friend Bernstein_simplex operator*(Bernstein_simplex a, const Bernstein_simplex& b) { return std::move(a *= b); }
  friend Bernstein_simplex operator*(Bernstein_simplex a, const NT& b) { return std::move(a *= b); }
  friend Bernstein_simplex operator*(const NT& a, Bernstein_simplex b) { return std::move(b *= a); }
  friend Bernstein_simplex operator-(Bernstein_simplex a) { return std::move(a *= NT(-1)); }

  //! whether two are the same polynomial, in whatever degree.
  friend bool operator==(const Bernstein_simplex& a,
                         const Bernstein_simplex& b) requires internal::Totally_comparable<NT>
  {
    const int degree = (std::max)(a.m_degree, b.m_degree);
    return a.elevated(degree).m_coefficients == b.elevated(degree).m_coefficients;
  }

  //! with images of the coefficients. \throws Invalid_input when one is not finite.
  template <SplineNumberType Target, class Conversion>
  Bernstein_simplex<Target, d> converted(const Conversion& conversion) const
  {
    std::vector<Target> images;
    images.reserve(m_coefficients.size());
    for (const NT& x : m_coefficients)
      images.push_back(conversion(x));
    internal::check_finite(images, "Bernstein_simplex: coefficient");
    using Result = Bernstein_simplex<Target, d>;
    return Result(typename Result::Unchecked(), m_degree, std::move(images));
  }

  /// @}

private:
  static bool is_edge(int i, int j) { return 0 <= i && i <= d && 0 <= j && j <= d && i != j; }

  static void check_degree(int degree, int greatest)
  {
    if (degree < 0)
      throw Invalid_input("Bernstein_simplex: negative degree " + std::to_string(degree));
    if (degree > greatest)
      throw Invalid_input("Bernstein_simplex: degree " + std::to_string(degree) + " is above " +
                          std::to_string(greatest));
  }

  // Coefficients of the part in which the point takes the place of a vertex have the point in as many arguments as the
  // old ones have the vertex: these are the numbers of de Casteljau's algorithm that do not refer to the vertex.
  template <std::size_t count>
  std::array<Bernstein_simplex, count> replaced(const std::array<int, count>& vertices, const Barycentric& point) const
  {
    std::array<Bernstein_simplex, count> result;
    result.fill(*this);
    std::vector<NT> net = m_coefficients;
    for (int times = 1; times <= m_degree; ++times) {
      internal::contract_simplex<d>(net, m_degree - times + 1, point);
      for (Index index(m_degree - times); index.is_valid(); ++index)
        for (std::size_t part = 0; part < count; ++part)
          if (index.exponent(vertices[part]) == 0)
            result[part].m_coefficients[index.raised(vertices[part], times)] = net[index.position()];
    }
    return result;
  }

  // `net` has the polar form with the first vertices as arguments, as many times as the exponents say.
  template <std::size_t count, class Result>
  static void fill_restriction(Result& result, const std::array<Barycentric, count>& vertices, std::size_t vertex,
                               int degree, std::vector<NT> net, std::array<int, count>& exponents)
  {
    const bool is_last = vertex + 1 == count;
    for (int k = degree;; --k) {
      if (!is_last || k == 0) {
        exponents[vertex] = degree - k;
        if (is_last)
          result.m_coefficients[Result::position_of(exponents)] = net[0];
        else
          fill_restriction(result, vertices, vertex + 1, k, net, exponents);
      }
      if (k == 0)
        return;
      internal::contract_simplex<d>(net, k, vertices[vertex]);
    }
  }

  template <class Combination>
  Bernstein_simplex& combine(const Bernstein_simplex& other, const Combination& combination)
  {
    if (m_degree < other.m_degree)
      *this = elevated(other.m_degree);
    if (m_degree > other.m_degree)
      return combine(other.elevated(m_degree), combination);
    for (std::size_t i = 0; i < m_coefficients.size(); ++i)
      combination(m_coefficients[i], other.m_coefficients[i]);
    return *this;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_SIMPLEX_H
