// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_PIECE_ELIMINATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_PIECE_ELIMINATION_H

#include <CGAL/Spline_constraints_d/operations/common/internal/elimination_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Integer_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_root.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

using Integer_matrix = std::vector<std::vector<Integer_coefficients>>;

// Of a matrix with one row less than columns: the minors without one of the columns each, by Laplace's expansion along
// the first row. Each minor of the last rows is found once.
inline std::vector<Integer_coefficients> maximal_minors(const Integer_matrix& rows, const std::function<void()>& check)
{
  const std::size_t n = rows.size() + 1, all = (std::size_t(1) << n) - 1;
  std::vector<Integer_coefficients> minors(all + 1); // by sets of columns
  minors[0] = {Big_integer(1)};
  for (std::size_t size = 1; size < n; ++size)
    for (std::size_t columns = 1; columns < all; ++columns) {
      if (static_cast<std::size_t>(std::popcount(columns)) != size)
        continue;
      check();
      int sign = 1;
      for (std::size_t j = 0; j < n; ++j)
        if (const std::size_t column = std::size_t(1) << j; (columns & column) != 0) {
          add_signed_product(minors[columns], rows[n - 1 - size][j], minors[columns ^ column], sign);
          sign = -sign;
        }
    }
  std::vector<Integer_coefficients> result;
  for (std::size_t j = 0; j < n; ++j)
    result.push_back(std::move(minors[all ^ (std::size_t(1) << j)]));
  return result;
}

// The value of a polynomial.
inline Exact_rational value_at(const Integer_polynomial& f, const Exact_rational& x)
{
  Exact_rational result(0);
  for (std::size_t k = f.coefficients().size(); k-- > 0;)
    result = Exact_rational(result * x + scaled_rational(f.coefficients()[k], 0));
  return result;
}

// Bounds of a polynomial at a root.
inline Rational_interval range_at(const Integer_polynomial& f, const Exact_root& root)
{
  if (root.is_point() || f.degree() < 1)
    return Rational_interval(value_at(f, root.lower()));
  const auto [values, exponent] = f.bernstein(root.lower(), root.upper());
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const Exact_rational unit = power_of_two(exponent) / scaled_rational(f.denominator(), 0);
  return {Exact_rational(scaled_rational(*least, 0) * unit), Exact_rational(scaled_rational(*greatest, 0) * unit)};
}

// How often a polynomial is zero at a root. \pre It is not zero everywhere.
inline int order_at(Integer_polynomial f, Exact_root& root)
{
  int result = 0;
  for (; root.sign_of_value(f) == CGAL::ZERO; ++result)
    f = f.derivative();
  return result;
}

// The parameter of the point on the other piece, for a root of the eliminated polynomial: whether there is one in
// [0,1], and as which quotient of polynomials.
struct Partner
{
  enum class Place
  {
    NONE,
    LOWER_END,
    INSIDE,
    UPPER_END
  };

  Place place = Place::NONE;
  std::size_t quotient = 0;
};

/*
Of a piece C of a planar curve and another one D, both without breaks: the polynomial of the parameter t of C that is
zero where C(t) lies on the algebraic curve of D, the determinant of the Bezout matrix B of D at C(t); it is the zero
polynomial where C runs along this curve.

Let t be a zero of it. The zeros s of both x W - w X and y W - w Y, real or not or infinite, counted with
multiplicities, are as many as the corank of B. If this is one, then s is the only parameter of the point, the adjoint
matrix of B is a multiple of the matrix of all s^(i+j), i, j < n, and t is a zero as often as the common point (t, s)
counts: the order of the determinant is the sum of the multiplicities of all common points with this t. So the entries
(0, 0) and (0, 1) of the adjoint tell s, if the first one is not zero; if it is, but the last one, (n-1, n-1), is not,
s is infinite; if both are zero, the point has more than one parameter on D, which this does not tell. The entries
(0, j) and (1, n-1) are the same multiple of 1, s, ..., s^n.
*/
class Planar_elimination
{
  struct Quotient
  {
    Integer_polynomial dividend, divisor, difference; // divisor - dividend
    std::vector<Integer_coefficients> powers;         // the divisor times 1, s, ..., s^n; the last one where wanted
  };

  Integer_matrix m_rows;
  Integer_polynomial m_polynomial;
  std::vector<Quotient> m_quotients;
  std::optional<Integer_polynomial> m_last_minor;
  std::function<void()> m_check;

public:
  // If the other piece is a point, the polynomial is zero. `check` is called often, and may throw.
  Planar_elimination(const Integer_piece<2>& curve, const Integer_piece<2>& other, std::function<void()> check)
    : m_check(std::move(check))
  {
    const std::vector<std::array<Big_integer, 3>> c = other.vectors(), vectors = bezout_vectors(c);
    const auto product = [&](const std::array<Big_integer, 3>& v) {
      Integer_coefficients sum;
      for (std::size_t i = 0; i < 3; ++i)
        add_multiple(sum, curve[i], v[i]);
      return sum;
    };
    const std::size_t n = c.size() - 1;
    if (n == 0)
      return;
    m_rows.resize(n);
    for (std::size_t i = 0; i < n * n; ++i)
      m_rows[i / n].push_back(product(vectors[i]));
    if (n == 1) {
      m_polynomial = primitive(m_rows[0][0]);
      for (const std::size_t i : {0, 1}) { // the equation of a coordinate
        const auto coefficient = [&](const std::array<Big_integer, 3>& a, int sign) {
          std::array<Big_integer, 3> v{Big_integer(0), Big_integer(0), Big_integer(sign * a[i])};
          v[i] = -sign * a[2];
          return product(v);
        };
        add_quotient({coefficient(c[1], 1), coefficient(c[0], -1)});
      }
      return;
    }
    std::vector<Integer_coefficients> minors =
        maximal_minors(Integer_matrix(m_rows.begin() + 1, m_rows.end()), m_check);
    Integer_coefficients determinant;
    for (std::size_t j = 0; j < n; ++j) {
      add_signed_product(determinant, m_rows[0][j], minors[j], j % 2 == 0 ? 1 : -1);
      if (j % 2 != 0)
        for (Big_integer& x : minors[j])
          x = -x;
    }
    m_polynomial = primitive(std::move(determinant));
    add_quotient(std::move(minors));
  }

  // Up to a positive factor.
  const Integer_polynomial& polynomial() const { return m_polynomial; }

  // Nothing where the point has more than one parameter, real or complex.
  std::optional<Partner> partner(Exact_root& root)
  {
    for (std::size_t k = 0; k < m_quotients.size(); ++k) {
      const Quotient& q = m_quotients[k];
      const int sign = root.sign_of_value(q.divisor);
      if (sign == 0)
        continue;
      const int above_begin = sign * root.sign_of_value(q.dividend);
      if (above_begin <= 0)
        return Partner{above_begin < 0 ? Partner::Place::NONE : Partner::Place::LOWER_END, k};
      const int below_end = sign * root.sign_of_value(q.difference);
      return Partner{below_end < 0        ? Partner::Place::NONE
                         : below_end == 0 ? Partner::Place::UPPER_END
                                          : Partner::Place::INSIDE,
                     k};
    }
    if (m_rows.size() > 1 && root.sign_of_value(last_minor()) == CGAL::ZERO)
      return std::nullopt;
    return Partner();
  }

  // Bounds of the parameter, if the root is known well enough.
  std::optional<Rational_interval> range(const Partner& partner, const Exact_root& root) const
  {
    const Quotient& q = m_quotients[partner.quotient];
    const Rational_interval divisor = range_at(q.divisor, root), dividend = range_at(q.dividend, root);
    if (divisor.lower > 0)
      return dividend / divisor;
    if (divisor.upper < 0)
      return (Rational_interval(0) - dividend) / (Rational_interval(0) - divisor);
    return std::nullopt;
  }

  // A common multiple of the powers of the partner, up to as many as the degree of the other piece.
  const std::vector<Integer_coefficients>& powers(std::size_t quotient)
  {
    std::vector<Integer_coefficients>& result = m_quotients[quotient].powers;
    const std::size_t n = m_rows.size();
    if (result.size() == n) {
      Integer_matrix rows = m_rows;
      rows.erase(rows.begin() + 1);
      Integer_coefficients last = std::move(maximal_minors(rows, m_check).back());
      if (n % 2 != 0)
        for (Big_integer& x : last)
          x = -x;
      result.push_back(std::move(last));
    }
    return result;
  }

private:
  void add_quotient(std::vector<Integer_coefficients> powers)
  {
    Integer_coefficients difference = powers[0];
    add_multiple(difference, powers[1], Big_integer(-1));
    Quotient quotient{Integer_polynomial(powers[1]), Integer_polynomial(powers[0]),
                      Integer_polynomial(std::move(difference)), std::move(powers)};
    m_quotients.push_back(std::move(quotient));
  }

  static Integer_polynomial primitive(Integer_coefficients f)
  {
    Big_integer content(0);
    for (const Big_integer& x : f)
      content = gcd(content, x);
    if (content > 1)
      for (Big_integer& x : f)
        x /= content;
    return Integer_polynomial(std::move(f));
  }

  const Integer_polynomial& last_minor()
  {
    if (!m_last_minor)
      m_last_minor.emplace(maximal_minors(Integer_matrix(m_rows.begin(), m_rows.end() - 1), m_check).back());
    return *m_last_minor;
  }
};

// A zero in (0,1) of an eliminated polynomial.
struct Eliminated_root
{
  Exact_root root;
  int multiplicity;
};

/*
The same for pieces of curves in the plane or in space. There, they are projected to a plane: their common points are
those of the projections at which a third coordinate is equal, too, and the difference of these is a polynomial of t by
the powers of s.
*/
template <int d>
class Piece_elimination
{
  // Linear forms that are zero along a direction, and a coordinate that is not.
  struct Projection
  {
    std::array<std::array<int, 3>, 2> forms;
    std::size_t third;
  };

  // Along the axes, and along directions of which any three are linearly independent.
  static constexpr std::array<Projection, 6> m_projections{{{{{{1, 0, 0}, {0, 1, 0}}}, 2},
                                                            {{{{0, 1, 0}, {0, 0, 1}}}, 0},
                                                            {{{{0, 0, 1}, {1, 0, 0}}}, 1},
                                                            {{{{1, -1, 0}, {0, 1, -1}}}, 0},
                                                            {{{{2, -1, 0}, {0, 1, 2}}}, 0},
                                                            {{{{1, 2, 0}, {0, 1, 1}}}, 0}}};

  Integer_piece<d> m_curve, m_other;
  std::function<void()> m_check;
  std::vector<Planar_elimination> m_planes;                   // the one that is solved first
  std::array<std::optional<Integer_polynomial>, 2> m_offsets; // by the quotients of this one
  std::size_t m_next_projection = 0, m_third = 0;

public:
  Piece_elimination(const Integer_piece<d>& curve, const Integer_piece<d>& other, const std::function<void()>& check)
    : m_curve(curve), m_other(other), m_check(check)
  {
    if constexpr (d == 2)
      m_planes.emplace_back(curve, other, check);
    else
      while (add_plane()) {
        m_third = m_projections[m_next_projection - 1].third;
        if (!m_planes.back().polynomial().is_zero())
          return;
        m_planes.clear();
      }
  }

  // Whether the piece is seen on the algebraic curve of the other one everywhere; also if this is not known.
  bool is_zero() const { return m_planes.empty() || polynomial().is_zero(); }

  const Integer_polynomial& polynomial() const { return m_planes.front().polynomial(); }

  // Those inside of the piece, in any order. \pre `!is_zero()`
  std::vector<Eliminated_root> inner_roots() const
  {
    Integer_polynomial f = polynomial();
    const Exact_rational zero(0), one(1);
    f.remove_root(zero);
    f.remove_root(one);
    std::vector<Eliminated_root> result;
    if (sign_variations(f.bernstein(zero, one).values) == 0)
      return result;
    for (auto& [factor, exponent] : f.square_free_factors()) {
      m_check();
      const auto is_stopped = [&] {
        m_check();
        return false;
      };
      for (Exact_root& root : isolate_roots(std::make_shared<const Integer_polynomial>(std::move(factor)), zero, one,
                                            is_stopped, [](const auto&, const auto&) {}))
        result.push_back({std::move(root), exponent});
    }
    return result;
  }

  // Of a root, or of an end of the piece that is one.
  std::optional<Partner> partner(Exact_root& root)
  {
    std::optional<Partner> result = m_planes.front().partner(root);
    if constexpr (d == 3)
      if (result && result->place != Partner::Place::NONE && root.sign_of_value(offset(result->quotient)) != CGAL::ZERO)
        return Partner();
    return result;
  }

  std::optional<Rational_interval> range(const Partner& partner, const Exact_root& root) const
  {
    return m_planes.front().range(partner, root);
  }

  /*
  How often a root, or an end, counts as a common point, if it has one partner; 0: several times, but it is not known
  how often; nothing: not known. Smooth curves in space that touch have a contact of the same order in all projections
  but those along directions in the plane of the tangent and of the leading difference; the least one of three
  projections along independent directions is that order.
  */
  std::optional<int> multiplicity(Exact_root& root)
  {
    int result = order_at(polynomial(), root);
    if constexpr (d == 3)
      if (result > 1) {
        if (is_singular(root))
          return 0;
        for (std::size_t i = 0, known = 0; known < 3; ++i) {
          if (i == m_planes.size() && !add_plane())
            return std::nullopt;
          Planar_elimination& plane = m_planes[i];
          if (plane.polynomial().is_zero() || !plane.partner(root))
            continue;
          result = (std::min)(result, order_at(plane.polynomial(), root));
          ++known;
        }
      }
    return result;
  }

private:
  // Whether the derivative of the curve is zero.
  bool is_singular(Exact_root& root) const
  {
    for (Integer_coefficients coordinate : m_curve.tangent())
      if (root.sign_of_value(Integer_polynomial(std::move(coordinate))) != CGAL::ZERO)
        return false;
    return true;
  }

  // Adds the next projection in which the other piece has the degree that it has in space, if there is one.
  bool add_plane() requires(d == 3)
  {
    while (m_next_projection < m_projections.size()) {
      const auto& forms = m_projections[m_next_projection++].forms;
      const Integer_piece<2> other = m_other.projected(forms);
      if (other.degree() != m_other.degree())
        continue;
      m_planes.emplace_back(m_curve.projected(forms), other, m_check);
      return true;
    }
    return false;
  }

  // Z w - W z, by the powers of the partner.
  const Integer_polynomial& offset(std::size_t quotient) requires(d == 3)
  {
    std::optional<Integer_polynomial>& result = m_offsets[quotient];
    if (!result) {
      Integer_coefficients sum;
      const std::vector<Integer_coefficients>& powers = m_planes.front().powers(quotient);
      for (std::size_t k = 0; k < powers.size(); ++k) {
        Integer_coefficients difference;
        if (k < m_other.weight().size())
          add_multiple(difference, m_curve[m_third], m_other.weight()[k]);
        if (k < m_other[m_third].size())
          add_multiple(difference, m_curve.weight(), Big_integer(-m_other[m_third][k]));
        add_signed_product(sum, difference, powers[k], 1);
      }
      result.emplace(std::move(sum));
    }
    return *result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_PIECE_ELIMINATION_H
