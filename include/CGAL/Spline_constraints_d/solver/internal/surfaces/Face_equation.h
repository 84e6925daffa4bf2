// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_FACE_EQUATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_FACE_EQUATION_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Face_factor.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Factor_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Space_equation.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/inequalities_as_unknowns.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// An edge of a face, where an unknown is at an end of its range, and how often the equality is zero there.
struct Edge_of_face
{
  int unknown;
  Exact_rational value;
  int exponent;
};

/*
Whether a polynomial on a face, where an unknown is fixed, seems to have no repeated factors, and to be zero on none of
its edges: modulo a prime, along a line and on an edge. It says so wrongly only by chance, and then no more is lost than
an answer that would have been possible.
*/
class Face_glance
{
  using Field = Prime_field_polynomial;
  using Point = std::vector<Field::Number>;

  std::vector<std::pair<const Monomial*, Field::Number>> m_terms;
  std::vector<int> m_unknowns;
  std::size_t m_degree, m_dimension;

public:
  // Of a polynomial that stays where it is.
  Face_glance(const Power_polynomial& function, int dimension)
    : m_unknowns(function.variables()), m_degree(static_cast<std::size_t>(function.total_degree())),
      m_dimension(static_cast<std::size_t>(dimension))
  {
    for (const auto& [monomial, coefficient] : function.terms())
      m_terms.emplace_back(&monomial, Field::residue(coefficient));
  }

  bool is_square_free(int axis, const Exact_rational& value) const
  {
    Point point = point_on_face(axis, value);
    std::vector<Field::Number> values;
    for (std::size_t t = 0; t <= m_degree; ++t) {
      values.push_back(value_at(point));
      for (std::size_t j = 0; j < m_dimension; ++j)
        if (j != static_cast<std::size_t>(axis))
          point[j] = (point[j] + 577 + 215 * j) % Field::prime;
    }
    const Field on_line = Field::interpolation(std::move(values));
    return !on_line.is_zero() && (on_line.degree() < 2 || !on_line.has_common_zero(on_line.derivative()));
  }

  // Of the face of a box.
  bool is_zero_on_no_edge(int axis, const Exact_rational& value, const Exact_ranges& box) const
  {
    const Point point = point_on_face(axis, value);
    return std::none_of(m_unknowns.begin(), m_unknowns.end(), [&](int j) {
      const auto is_zero_at = [&](const Exact_rational& end) {
        return value_at(with(point, j, Field::residue(end))) == 0;
      };
      const auto& [lower, upper] = box[static_cast<std::size_t>(j)];
      return j != axis && (is_zero_at(lower) || is_zero_at(upper));
    });
  }

private:
  Point point_on_face(int axis, const Exact_rational& value) const
  {
    constexpr Field::Number first = 2718281, step = 314159;
    Point result;
    for (std::size_t j = 0; j < m_dimension; ++j)
      result.push_back(first + step * (j * j + j));
    return with(std::move(result), axis, Field::residue(value));
  }

  static Point with(Point point, int unknown, Field::Number value)
  {
    point[static_cast<std::size_t>(unknown)] = value;
    return point;
  }

  Field::Number value_at(const Point& point) const
  {
    Field::Number sum = 0;
    for (const auto& [monomial, coefficient] : m_terms) {
      Field::Number term = coefficient;
      for (const auto& [unknown, exponent] : monomial->powers)
        for (int k = 0; k < exponent; ++k)
          term = term * point[static_cast<std::size_t>(unknown)] % Field::prime;
      sum += term;
    }
    return sum % Field::prime;
  }
};

// The equalities on a cell as polynomials; zero for long ones, which are not looked at.
class Cell_equalities
{
  const Constraint_system_d m_system;
  const std::optional<Space_equation> m_space;
  std::vector<Power_polynomial> m_functions;
  std::vector<Face_glance> m_glances;

public:
  explicit Cell_equalities(Constraint_system_d cell) : m_system(std::move(cell)), m_space(Space_equation::of(m_system))
  {
    constexpr std::size_t most_coefficients = 1000;
    for (const Spline_function& equality : m_system.equalities()) {
      std::size_t coefficients = 0;
      for (const Spline_term& term : equality.terms())
        coefficients += term.pieces[0].size();
      m_functions.push_back(coefficients > most_coefficients
                                ? Power_polynomial()
                                : *restricted(equality, Partial_point(static_cast<std::size_t>(m_system.dimension()))));
    }
    for (const Power_polynomial& function : m_functions)
      m_glances.emplace_back(function, m_system.dimension());
  }
  Cell_equalities(const Cell_equalities&) = delete;
  Cell_equalities& operator=(const Cell_equalities&) = delete;

  const Constraint_system_d& system() const { return m_system; }
  const std::optional<Space_equation>& space() const { return m_space; }
  const std::vector<Power_polynomial>& functions() const { return m_functions; }
  const Face_glance& glance(std::size_t equality) const { return m_glances[equality]; }
};

// The remainder of the division by a polynomial whose coefficient at the highest power of an unknown is a constant.
inline Power_polynomial remainder(Power_polynomial f, const Power_polynomial& divisor, int unknown)
{
  const auto leading = [&](const Power_polynomial& p, int degree) {
    Power_polynomial result;
    for (const auto& [monomial, coefficient] : p.terms())
      if (monomial.exponent(unknown) == degree) {
        Power_polynomial term(coefficient);
        for (const auto& [own, exponent] : monomial.powers)
          if (own != unknown)
            term *= pow(Power_polynomial::variable(own), exponent);
        result += std::move(term);
      }
    return result;
  };
  const int own_degree = divisor.degree(unknown);
  const Power_polynomial own_leading = leading(divisor, own_degree);
  for (int degree = f.degree(unknown); degree >= own_degree; degree = f.degree(unknown))
    f -= leading(f, degree) * pow(Power_polynomial::variable(unknown), degree - own_degree) * divisor / own_leading;
  return f;
}

inline bool has_constant_leading_term(const Power_polynomial& function, int unknown)
{
  const int degree = function.degree(unknown);
  return degree > 0 && std::all_of(function.terms().begin(), function.terms().end(), [&](const auto& term) {
           return term.first.exponent(unknown) < degree || term.first.total_degree() == degree;
         });
}

// Simpler polynomials that are equal to one where another one is zero: without one of the terms, or higher powers of an
// unknown.
inline std::vector<Power_polynomial> reductions(const Power_polynomial& f, const Power_polynomial& zero)
{
  std::vector<Power_polynomial> result;
  for (const int unknown : f.variables())
    if (has_constant_leading_term(zero, unknown) && f.degree(unknown) >= zero.degree(unknown))
      result.push_back(remainder(f, zero, unknown));
  for (const auto& [monomial, coefficient] : f.terms())
    if (const auto same = zero.terms().find(monomial); same != zero.terms().end())
      result.push_back(f - Power_polynomial(coefficient / same->second) * zero);
  return result;
}

/*
An equality on a face of a cell, where it has repeated factors or is zero on edges: a product of powers of the distances
from these edges, of a polynomial with even exponents, and of one with odd ones. Surfaces cross the face where the last
one is zero: there the equality changes its sign. Where the one with even exponents is zero they touch the face, and the
derivative across the face tells from which side.

Edges are those of the equality in space, which consist of solutions, up to the ranges of what others give. Where
another equality is zero on an edge nothing follows for solutions, which have to be zeros of all.

On the face of an unknown that one equality gives, another one is reduced modulo this.
*/
class Face_equation
{
  std::shared_ptr<const Cell_equalities> m_cell;
  int m_axis;
  Exact_rational m_value;
  std::size_t m_equality;
  Power_polynomial m_function; // that it is, also off the face
  // on the face
  Power_polynomial m_crossing = Power_polynomial(1), m_touching = Power_polynomial(1);
  std::vector<Edge_of_face> m_edges = {};

  Face_equation(std::shared_ptr<const Cell_equalities> cell, int axis, const Exact_rational& value,
                std::size_t equality, Power_polynomial function)
    : m_cell(std::move(cell)), m_axis(axis), m_value(value), m_equality(equality), m_function(std::move(function))
  {}

public:
  // Of one of the equalities; none if nothing is special about these on the face.
  static std::optional<Face_equation> of(const std::shared_ptr<const Cell_equalities>& cell, int axis,
                                         const Exact_rational& value)
  {
    const std::vector<Power_polynomial>& functions = cell->functions();
    std::vector<std::size_t> with_axis;
    for (std::size_t e = 0; e < functions.size(); ++e)
      if (functions[e].degree(axis) > 0) {
        with_axis.push_back(e);
        if (auto result = of(cell, axis, value, e, functions[e], cell->glance(e)))
          return result;
      }
    if (with_axis.size() != 1)
      return std::nullopt;
    const Power_polynomial& given = functions[with_axis.front()];
    for (std::size_t e = 0; e < functions.size(); ++e)
      for (const Power_polynomial& reduced :
           e == with_axis.front() ? std::vector<Power_polynomial>() : reductions(functions[e], given))
        if (auto result = of(cell, axis, value, e, reduced, Face_glance(reduced, cell->system().dimension())))
          return result;
    return std::nullopt;
  }

  int axis() const { return m_axis; }
  const Exact_rational& value() const { return m_value; }
  const std::vector<Edge_of_face>& edges() const { return m_edges; }

  // It has the sign of the equality inside of the face, but for the zeros of the other factors.
  const Power_polynomial& crossing() const { return m_crossing; }

  // Positive where surfaces lie beyond a face that they touch, so that nothing of them but this is in the cell.
  Power_polynomial outside() const
  {
    return m_crossing * on_face_of(m_function.derivative(m_axis)) *
        Power_polynomial(m_value == system().domain(m_axis).first ? 1 : -1);
  }

  // On the cell, in all unknowns.
  const Constraint_system_d& system() const { return m_cell->system(); }
  const std::optional<Space_equation>& space() const { return m_cell->space(); }
  const Power_polynomial& function() const { return m_function; }
  std::size_t equality() const { return m_equality; }

  // With these factors in the place of the equality.
  Constraint_system_d crossing_system() const { return with_equality(system(), m_equality, m_crossing); }
  bool has_touching() const { return !m_touching.is_constant(); }
  Constraint_system_d touching_system() const { return with_equality(system(), m_equality, m_touching); }

  // The edge where another unknown has a value.
  const Edge_of_face* edge(int unknown, const Exact_rational& value) const
  {
    const auto found = std::find_if(m_edges.begin(), m_edges.end(), [&](const Edge_of_face& edge) {
      return edge.unknown == unknown && edge.value == value;
    });
    return found == m_edges.end() ? nullptr : &*found;
  }

private:
  Power_polynomial on_face_of(const Power_polynomial& function) const
  {
    return function.substituted(m_axis, Power_polynomial(m_value));
  }

  // Of a function that may be put in the place of an equality.
  static std::optional<Face_equation> of(const std::shared_ptr<const Cell_equalities>& cell, int axis,
                                         const Exact_rational& value, std::size_t equality,
                                         const Power_polynomial& function, const Face_glance& glance)
  {
    const std::optional<Space_equation>& space = cell->space();
    const bool is_in_space =
        space && space->index() == equality && space->place_of(axis) && &function == &cell->functions()[equality];
    const bool has_edges = is_in_space && !glance.is_zero_on_no_edge(axis, value, domain_of(cell->system()));
    if (function.degree(axis) < 1 || (!has_edges && glance.is_square_free(axis, value)))
      return std::nullopt;
    Face_equation result(cell, axis, value, equality, function);
    return result.factor(has_edges) ? std::optional(std::move(result)) : std::nullopt;
  }

  // Takes it apart; false if nothing is special about it.
  bool factor(bool has_edges)
  {
    const Power_polynomial on_face = on_face_of(m_function);
    if (on_face.is_zero())
      return false;
    const Power_polynomial inner = has_edges ? without_edges(on_face) : on_face;
    bool is_special = !m_edges.empty();
    const std::vector<Power_polynomial> factors =
        inner.is_constant() ? std::vector<Power_polynomial>{inner} : square_free_factors(inner);
    for (std::size_t k = 0; k < factors.size(); ++k)
      if (k == 0 || may_be_zero(factors[k])) {
        (k % 2 == 0 ? m_crossing : m_touching) *= factors[k];
        is_special = is_special || (k > 0 && !factors[k].is_constant());
      }
    if (!is_special)
      return false;
    const int sign = sign_of_quotient(on_face);
    m_crossing *= Power_polynomial(sign);
    return sign != 0;
  }

  // Divided by the distances from edges.
  Power_polynomial without_edges(const Power_polynomial& on_face)
  {
    Spline_function rest(on_face);
    for (const int j : on_face.variables())
      for (const Exact_rational& end : {system().domain(j).first, system().domain(j).second})
        if (const int exponent = Face_factor::divide_out(rest, j, system().domain(j), end); exponent > 0)
          m_edges.push_back({j, end, exponent});
    return *restricted(rest, Partial_point(static_cast<std::size_t>(system().dimension())));
  }

  // In the cell.
  bool may_be_zero(const Power_polynomial& function) const
  {
    const auto [least, most] = bounds_in_domain(Spline_function(function), system());
    return least <= 0 && 0 <= most;
  }

  // The sign of the equality inside of the face over that of the factor with odd exponents: 0 if they are zero at all
  // points that are tried.
  int sign_of_quotient(const Power_polynomial& on_face) const
  {
    constexpr int tries = 97;
    for (int t = 1; t < tries; ++t) {
      std::vector<Exact_rational> point;
      for (int j = 0; j < system().dimension(); ++j) {
        const auto& [lower, upper] = system().domain(j);
        point.push_back(
            Exact_rational(lower + (upper - lower) * Exact_rational(1 + (t * (2 * j + 3)) % tries) / (tries + 1)));
      }
      if (const int sign = CGAL::sign(on_face(point)) * CGAL::sign(m_crossing(point)); sign != 0)
        return sign;
    }
    return 0;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_FACE_EQUATION_H
