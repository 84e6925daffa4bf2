// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Gauss_newton_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The same polynomial in the differences from a point.
inline Power_polynomial centred(Power_polynomial polynomial, const Exact_point& point)
{
  for (std::size_t j = 0; j < point.size(); ++j)
    polynomial = polynomial.substituted(static_cast<int>(j),
                                        Power_polynomial::variable(static_cast<int>(j)) + Power_polynomial(point[j]));
  return polynomial;
}

/*
The n - 1 equations of curves as polynomials in one cell, and their tangents: the maximal minors of the Jacobian, with
alternating signs. Where all of these are zero, the curves are singular.
*/
class Curve_polynomials
{
  std::vector<Power_polynomial> m_equations, m_tangent; // the latter per unknown
  Polynomials_with_gradients<Exact_rational> m_exact;   // all of them
  Polynomials_with_gradients<double> m_rounded;
  std::size_t m_work_of_step = 100; // elimination, and evaluations

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
      for (const Power_polynomial& polynomial : *polynomials) {
        m_exact.add(polynomial);
        m_rounded.add(polynomial);
        for (std::size_t j = 0; j < n; ++j) {
          const Power_polynomial derivative = polynomial.derivative(static_cast<int>(j));
          m_work_of_step += derivative.terms().size() * static_cast<std::size_t>(1 + derivative.total_degree());
        }
      }
  }

  std::size_t dimension() const { return m_tangent.size(); }
  const std::vector<Power_polynomial>& equations() const { return m_equations; }
  const std::vector<Power_polynomial>& tangent() const { return m_tangent; }

  // Of the Gauss-Newton method, about in additions of coefficients.
  std::size_t work_of_step() const { return m_work_of_step; }

  // A box with the only singular point in a box: of several there is no answer, nor after many nodes, as of a
  // continuum, nor where the run ends.
  std::optional<Exact_ranges> singular_point_in(const Exact_ranges& box, Run_control& control) const
  {
    constexpr std::size_t most_nodes = 1000;
    Constraint_system_d system(box);
    for (const auto* polynomials : {&m_equations, &m_tangent})
      for (const Power_polynomial& polynomial : *polynomials)
        if (!polynomial.is_zero())
          system.add(polynomial, Relation::EQUAL);
    if (system.equalities().size() < dimension())
      return std::nullopt;
    const Solution_set_d<double> points =
        Subdivision_solver_d<Certified_solver_traits>({.node_limit = most_nodes, .visitor = control})(system);
    constexpr std::size_t boxes_of_node = 4; // the minors are long
    control.charge(boxes_of_node * points.summary().nodes);
    if (points.size() != 1 || !points.is_complete() || points.begin()->kind() == Solution_kind::CONTINUUM)
      return std::nullopt;
    return points.begin()->exact_box();
  }

  bool is_singular_at(const Exact_point& point) const
  {
    const auto vanishes = [&](const Power_polynomial& polynomial) { return CGAL::is_zero(polynomial(point)); };
    return std::all_of(m_equations.begin(), m_equations.end(), vanishes) &&
        std::all_of(m_tangent.begin(), m_tangent.end(), vanishes);
  }

  // A singular point in a box with rational coordinates, if one is found. First in doubles: with more digits only where
  // these come so close to a singular point that they cannot tell more. Adds the work.
  std::optional<Exact_point> rational_singular_point_in(const Exact_ranges& box, std::size_t& work) const
  {
    // of a step with many digits, compared with one in doubles; more in fact
    constexpr std::size_t work_of_digits = 8;
    const auto is_singular = [this](const Exact_point& point) { return is_singular_at(point); };
    Gauss_newton_search<double> quick(m_rounded, box, is_singular);
    Search_result found = quick();
    work += quick.steps() * m_work_of_step / work_of_digits;
    if (!found.is_unclear)
      return found.point;
    Gauss_newton_search<Exact_rational> slow(m_exact, box, is_singular);
    found = slow();
    work += slow.steps() * m_work_of_step;
    return found.point;
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
      const Power_polynomial term =
          m_equations[row].derivative(static_cast<int>(columns[k])) * determinant(row + 1, others);
      if (k % 2 == 0)
        result += term;
      else
        result -= term;
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_POLYNOMIALS_H
