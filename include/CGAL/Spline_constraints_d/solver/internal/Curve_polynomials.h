// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVE_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVE_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/rational_coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_point = std::vector<Exact_rational>;

// The same polynomial in the differences from a point.
inline Power_polynomial centred(Power_polynomial polynomial, const Exact_point& point)
{
  for (std::size_t j = 0; j < point.size(); ++j)
    polynomial = polynomial.substituted(static_cast<int>(j), Power_polynomial::variable(static_cast<int>(j)) + Power_polynomial(point[j]));
  return polynomial;
}

/*
The n - 1 equations of curves as polynomials in one cell, and their tangents: the maximal minors of the Jacobian, with alternating signs. Where all of these are zero, the curves are singular.
*/
class Curve_polynomials
{
  std::vector<Power_polynomial> m_equations, m_tangent;   // the latter per unknown
  std::vector<std::vector<Power_polynomial>> m_gradients;   // of all of them
  std::size_t m_work_of_step = 100;   // elimination, and evaluations

public:
  // The system has no breaks.
  explicit Curve_polynomials(const Constraint_system_d& system)
  {
    const std::size_t n = static_cast<std::size_t>(system.dimension());
    for (const Spline_function& function : system.equalities())
      m_equations.push_back(*restricted(function, Partial_point(n)));
    for (std::size_t omitted = 0; omitted < n; ++omitted) {
      std::vector<std::size_t> columns;
      for (std::size_t j = 0; j < n; ++j)
        if (j != omitted)
          columns.push_back(j);
      m_tangent.push_back(omitted % 2 == 0 ? determinant(0, columns) : -determinant(0, columns));
    }
    for (const auto* polynomials : {&m_equations, &m_tangent})
      for (const Power_polynomial& polynomial : *polynomials)
        for (std::vector<Power_polynomial>& gradient = m_gradients.emplace_back(); gradient.size() < n;)
          gradient.push_back(polynomial.derivative(static_cast<int>(gradient.size())));
    for (const std::vector<Power_polynomial>& gradient : m_gradients)
      for (const Power_polynomial& derivative : gradient)
        m_work_of_step += derivative.terms().size() * static_cast<std::size_t>(1 + derivative.total_degree());
  }

  std::size_t dimension() const { return m_tangent.size(); }
  const std::vector<Power_polynomial>& equations() const { return m_equations; }
  const std::vector<Power_polynomial>& tangent() const { return m_tangent; }

  // Of the Gauss-Newton method, about in additions of coefficients.
  std::size_t work_of_step() const { return m_work_of_step; }

  // A box with the only singular point in a box: of several there is no answer.
  std::optional<Exact_ranges> singular_point_in(const Exact_ranges& box) const
  {
    Constraint_system_d system(box);
    for (const auto* polynomials : {&m_equations, &m_tangent})
      for (const Power_polynomial& polynomial : *polynomials)
        if (!polynomial.is_zero())
          system.add(polynomial, Relation::EQUAL);
    if (system.equalities().size() < dimension())
      return std::nullopt;
    const Solution_set_d<double> points = Subdivision_solver_d<Certified_solver_traits>()(system);
    if (points.size() != 1 || !points.is_complete() || points.begin()->kind() == Solution_kind::CONTINUUM)
      return std::nullopt;
    return points.begin()->exact_box();
  }

  bool is_singular_at(const Exact_point& point) const
  {
    const auto vanishes = [&](const Power_polynomial& polynomial) { return CGAL::is_zero(polynomial(point)); };
    return std::all_of(m_equations.begin(), m_equations.end(), vanishes) && std::all_of(m_tangent.begin(), m_tangent.end(), vanishes);
  }

  /*
  A singular point in a box with rational coordinates, if one is found: the Gauss-Newton method in rational numbers of some hundred bits, with the simplest rationals near its iterates. At points of high multiplicity
  steps become shorter by a constant factor, so that two of them tell how far all others will go. Every other one only leads back to a curve, wherever this is bent. Adds the work.
  */
  std::optional<Exact_point> rational_singular_point_in(const Exact_ranges& box, std::size_t& work) const
  {
    constexpr int most_rounds = 12, most_exits = 3;
    Exact_point place;
    Exact_rational shortest(0);   // of steps where a rational with small numbers would have been found
    for (const auto& [lower, upper] : box) {
      place.push_back(Exact_rational((lower + upper) / 2));
      shortest = (std::max)(shortest, Exact_rational(0x1p-80 * (upper - lower)));
    }
    for (int round = 0, exits = 0; round < most_rounds; ++round) {
      std::vector<Exact_point> steps;   // each of two
      Exact_rational first_residual;
      for (int i = 0; i < 4; ++i) {
        work += m_work_of_step;
        const auto [step, residual] = gauss_newton_step(place);
        if (step.empty())
          return is_singular_at(place) ? std::optional(place) : std::nullopt;
        if (i == 0)
          first_residual = residual;
        else if (i == 2 && 2 * residual > first_residual)
          return std::nullopt;   // there seems to be a minimum
        if (i % 2 == 0)
          steps.emplace_back(step.size(), Exact_rational(0));
        add(steps.back(), step);
        add(place, step);
        if (!move_into(place, box) && ++exits == most_exits)
          return std::nullopt;
        if (std::optional<Exact_point> point = simplest_singular_point(place, length(step), box))
          return point;
      }
      if (length(steps[1]) < shortest)
        return std::nullopt;
      const Exact_rational square = product(steps[0], steps[0]), ratio = CGAL::is_zero(square) ? Exact_rational(0) : Exact_rational(product(steps[0], steps[1]) / square);
      if (ratio > 0 && ratio < Exact_rational(63, 64)) {
        for (Exact_rational& x : steps[1])
          x *= ratio / (1 - ratio);
        add(place, steps[1]);
        if (std::optional<Exact_point> point = simplest_singular_point(place, length(steps[1]), box))
          return point;
      }
    }
    return std::nullopt;
  }

private:
  // Of the derivatives of the equations from a row on, by the unknowns in the columns.
  Power_polynomial determinant(std::size_t row, const std::vector<std::size_t>& columns) const
  {
    if (columns.empty())
      return Power_polynomial(Exact_rational(1));
    Power_polynomial result;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      std::vector<std::size_t> others = columns;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      const Power_polynomial term = m_equations[row].derivative(static_cast<int>(columns[k])) * determinant(row + 1, others);
      if (k % 2 == 0)
        result += term;
      else
        result -= term;
    }
    return result;
  }

  // The least squares solution of the linearized equations, empty where it is not unique; and the sum of the squares of the values.
  std::pair<Exact_point, Exact_rational> gauss_newton_step(const Exact_point& place) const
  {
    const std::size_t n = dimension(), length = n + 1;
    Exact_rational residual(0);
    std::vector<Exact_rational> rows(n * length, Exact_rational(0));   // the normal equations
    for (std::size_t i = 0; i < m_gradients.size(); ++i) {
      const Exact_rational value = (i < m_equations.size() ? m_equations[i] : m_tangent[i - m_equations.size()])(place);
      residual += value * value;
      Exact_point gradient;
      for (const Power_polynomial& derivative : m_gradients[i])
        gradient.push_back(derivative(place));
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < n; ++k)
          rows[j * length + k] += gradient[j] * gradient[k];
        rows[j * length + n] -= gradient[j] * value;
      }
    }
    const std::vector<int> row_of = gauss_jordan(rows, length, n, n, [](const Exact_rational& x) { return CGAL::is_zero(x) ? 0.0 : (std::max)(std::abs(CGAL::to_double(x)), 1e-300); });
    Exact_point result;
    for (std::size_t j = 0; j < row_of.size(); ++j)
      result.push_back(rows[static_cast<std::size_t>(row_of[j]) * length + n]);
    return {result, residual};
  }

  // Rounded to a fixed number of bits.
  static void add(Exact_point& place, const Exact_point& step)
  {
    constexpr int bits = 256;
    const Exact_rational unit = power_of_two(bits);
    for (std::size_t j = 0; j < place.size(); ++j) {
      const Exact_rational scaled = (place[j] + step[j]) * unit;
      place[j] = scaled_rational(Big_integer(numerator_of(scaled) / denominator_of(scaled)), -bits);
    }
  }

  // False if a point is not in the box: then it is moved to its boundary.
  static bool move_into(Exact_point& point, const Exact_ranges& box)
  {
    const Exact_point before = point;
    for (std::size_t j = 0; j < point.size(); ++j)
      point[j] = (std::min)((std::max)(point[j], box[j].first), box[j].second);
    return point == before;
  }

  std::optional<Exact_point> simplest_singular_point(const Exact_point& place, const Exact_rational& margin, const Exact_ranges& box) const
  {
    Exact_point point;
    for (std::size_t j = 0; j < place.size(); ++j) {
      const Exact_rational lower = (std::max)(Exact_rational(place[j] - margin), box[j].first), upper = (std::min)(Exact_rational(place[j] + margin), box[j].second);
      if (upper < lower)
        return std::nullopt;
      point.push_back(simplest_rational_between(lower, upper));
    }
    return is_singular_at(point) ? std::optional(std::move(point)) : std::nullopt;
  }

  static Exact_rational product(const Exact_point& a, const Exact_point& b)
  {
    Exact_rational result(0);
    for (std::size_t j = 0; j < a.size(); ++j)
      result += a[j] * b[j];
    return result;
  }

  static Exact_rational length(const Exact_point& step)
  {
    Exact_rational result(0);
    for (const Exact_rational& x : step)
      result = (std::max)(result, Exact_rational(CGAL::abs(x)));
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVE_POLYNOMIALS_H
