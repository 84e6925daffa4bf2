// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_EXTREMES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_EXTREMES_H

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/function/internal/Jet.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

What is proved of a point where a quantity is stationary along a curve of solutions.
*/
enum class Curve_extreme_kind {
  MAXIMUM,    ///< a local maximum: the quantity is smaller on both sides
  MINIMUM,    ///< a local minimum
  /// neither is proved: a singular point of the curve, a point where the second derivative is zero as well, or an
  /// answer of the solver that is not certified
  UNDECIDED
};

//! \ingroup PkgSplineConstraintsDSolver
//! writes `maximum`, `minimum` or `undecided`.
std::ostream& operator<<(std::ostream& out, Curve_extreme_kind kind);

/*!
\ingroup PkgSplineConstraintsDSolver

All points of curves of solutions where a quantity is stationary.
*/
struct Curve_extremes_d
{
  //! a point with what is proved of it.
  struct Extreme
  {
    Curve_extreme_kind kind;      ///< what is proved
    Solution_d<double> solution;  ///< the point, with the proof that it is one
  };

  //! the points.
  std::vector<Extreme> extremes;

  //! the work; complete when there are no others, by proof.
  Summary summary;
};

namespace internal {

inline Expression left_side(const Constraint& constraint)
{
  return Expression(constraint.function, Monomial(), constraint.symbols);
}

// By expansion along the first row.
Expression determinant_of(const std::vector<std::vector<Expression>>& matrix);

// A quantity along the curves of solutions of constraints between unknowns.
class Curve_quantity
{
  std::vector<Constraint> m_constraints;
  std::vector<Unknown> m_unknowns;
  std::vector<Expression> m_tangent;   // as fast as the gradients of the equations are long

public:
  Curve_quantity(std::span<const Constraint> constraints, const std::string& name);

  const std::vector<Unknown>& unknowns() const { return m_unknowns; }
  const std::vector<Expression>& tangent() const { return m_tangent; }

  // The derivative of a formula along the tangent.
  Expression derivative_along(const Expression& formula) const;

  // Where its derivative along the tangent, a positive multiple of `rate`, is zero.
  Curve_extremes_d stationary_points(const Expression& rate, const Solver_options& options) const;

private:
  // The cofactors of a row that is added to the Jacobian: they are orthogonal to all gradients.
  void make_tangent(const std::vector<Expression>& equations);

  // By the sign of the derivative of the rate, where the rate is zero.
  Curve_extreme_kind kind(const Expression& rate, const Solution_d<double>::Exact_box& box) const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Expression determinant_of(const std::vector<std::vector<Expression>>& matrix)
{
  if (matrix.empty())
    return 1;
  Expression result = 0;
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    std::vector<std::vector<Expression>> minor(matrix.begin() + 1, matrix.end());
    for (auto& row : minor)
      row.erase(row.begin() + j);
    result += (j % 2 == 0 ? 1 : -1) * matrix[0][j] * determinant_of(minor);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_quantity::Curve_quantity(std::span<const Constraint> constraints,
                                                              const std::string& name)
  : m_constraints(constraints.begin(), constraints.end())
{
  const std::size_t n = common_domains(constraints).size();
  std::vector<Expression> equations;
  for (const Constraint& constraint : constraints) {
    if (constraint.symbols != nullptr)
      while (m_unknowns.size() < n)
        m_unknowns.emplace_back(constraint.symbols, static_cast<int>(m_unknowns.size()));
    if (constraint.relation == Relation::EQUAL)
      equations.push_back(left_side(constraint));
  }
  if (equations.size() + 1 != n)
    throw Invalid_input(name + ": " + std::to_string(equations.size()) + " equalities for " + std::to_string(n) +
                        " unknowns");
  make_tangent(equations);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression Curve_quantity::derivative_along(const Expression& formula) const
{
  Expression result = 0;
  for (std::size_t j = 0; j < m_unknowns.size(); ++j)
    result += derivative(formula, m_unknowns[j]) * m_tangent[j];
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_extremes_d Curve_quantity::stationary_points(const Expression& rate,
                                                                                  const Solver_options& options) const
{
  std::vector<Constraint> constraints = m_constraints;
  constraints.push_back(rate == 0);
  const Solution_set_d<double> solutions =
      Subdivision_solver_d<Certified_solver_traits>(options)(make_system(constraints));
  Curve_extremes_d result{{}, solutions.summary()};
  for (const Solution_d<double>& solution : solutions)
    result.extremes.push_back(
        {solution.is_certified() ? kind(rate, solution.exact_box()) : Curve_extreme_kind::UNDECIDED, solution});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Curve_quantity::make_tangent(const std::vector<Expression>& equations)
{
  const std::size_t n = m_unknowns.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<std::vector<Expression>> minor;
    for (const Expression& equation : equations) {
      minor.emplace_back();
      for (std::size_t j = 0; j < n; ++j)
        if (j != k)
          minor.back().push_back(derivative(equation, m_unknowns[j]));
    }
    m_tangent.push_back((k % 2 == 0 ? 1 : -1) * determinant_of(minor));
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_extreme_kind Curve_quantity::kind(const Expression& rate,
                                                                       const Solution_d<double>::Exact_box& box) const
{
  using NT = Mpfr_interval;
  std::vector<Exact_rational> place;
  std::vector<Jet<NT>> still, moving;
  for (const auto& [lower, upper] : box) {
    place.push_back(lower);
    still.emplace_back(NT(lower, upper), NT(0), NT(0));
  }
  for (std::size_t j = 0; j < box.size(); ++j)
    moving.emplace_back(
        still[j].value,
        expression_value(m_tangent[j], std::span<const Exact_rational>(place), std::span<const Jet<NT>>(still)).value,
        NT(0));
  const CGAL::Uncertain<CGAL::Sign> sign =
      expression_value(rate, std::span<const Exact_rational>(place), std::span<const Jet<NT>>(moving)).first.sign();
  if (CGAL::certainly(sign == CGAL::NEGATIVE))
    return Curve_extreme_kind::MAXIMUM;
  return CGAL::certainly(sign == CGAL::POSITIVE) ? Curve_extreme_kind::MINIMUM : Curve_extreme_kind::UNDECIDED;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

all turning points of the curves of solutions: points where an unknown is stationary along the curve. They solve the
equations together with the one that says that the tangent has no component in that direction: a minor of the Jacobian
is zero. The sign of the second derivative, over the box of the solution, tells maxima from minima.

Singular points of the curves are solutions as well, and undecided. If the unknown is constant on a whole curve, that
curve is what the solver reports of a continuum.

\param constraints the constraints; one equality less than unknowns. Inequalities hold for the points.
\param u the unknown.
\param options those of the solver.
\throws Invalid_input as `make_system()`; when the number of equalities is another one, the unknown comes from another
call of `unknowns()`, or the derivative of a spline jumps.

Complexity: that of the solver, for equations of \f$n-1\f$ times the degree.
*/
Curve_extremes_d turning_points(std::span<const Constraint> constraints, const Unknown& u,
                                const Solver_options& options = {});

namespace internal {

// 2 D K' - 3 K D' of a plane curve.
Expression rate_of_signed_curvature(const Curve_quantity& curve);

// D N' - 3 N D' of a curve in space.
Expression rate_of_squared_curvature(const Curve_quantity& curve);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Expression rate_of_signed_curvature(const Curve_quantity& curve)
{
  const Expression &f_y = curve.tangent()[0], f_x = -curve.tangent()[1];
  const auto by = [&](const Expression& formula, std::size_t i) { return derivative(formula, curve.unknowns()[i]); };
  const Expression k = by(f_x, 0) * square(f_y) - 2 * by(f_x, 1) * f_x * f_y + by(f_y, 1) * square(f_x),
                   d = square(f_x) + square(f_y);
  return 2 * d * curve.derivative_along(k) - 3 * k * curve.derivative_along(d);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression rate_of_squared_curvature(const Curve_quantity& curve)
{
  Expression d = 0, mixed = 0, bend = 0;
  for (const Expression& component : curve.tangent()) {
    const Expression change = curve.derivative_along(component);
    d += square(component);
    mixed += component * change;
    bend += square(change);
  }
  const Expression n = d * bend - square(mixed);
  return d * curve.derivative_along(n) - 3 * n * curve.derivative_along(d);
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

all points of curves where their curvature is stationary: the vertices of a plane curve \f$F(x,y) = 0\f$, or those of
curves in space.

With \f$K = F_{xx} F_y^2 - 2 F_{xy} F_x F_y + F_{yy} F_x^2\f$ and \f$D = F_x^2 + F_y^2\f$ the curvature in the plane is
\f$K / D^{3/2}\f$, positive where
\f$F < 0\f$ is convex: a maximum is one of this, so where it is negative the curve bends least there. The equation is
\f$2 D K' = 3 K D'\f$, with derivatives along the curve; at its zeros the sign of its own derivative tells maxima from
minima.

In three and more unknowns, with the tangent \f$T\f$ of cofactors of the Jacobian, \f$D = |T|^2\f$ and \f$N = D\,|T'|^2
- \langle T, T'\rangle^2\f$, the squared curvature is \f$N / D^3\f$, and the equation \f$D N' = 3 N D'\f$; the curvature
itself has no sign, and points where it is zero are minima.

Singular points of the curves are solutions as well, and undecided. Circles and straight lines are what the solver
reports of a continuum.

\param constraints the constraints; one equality less than unknowns. Inequalities hold for the points.
\param options those of the solver.
\throws Invalid_input as `make_system()`; when the number of equalities is another one, or one of the first three
derivatives of a spline jumps.

Complexity: that of the solver, for an equation of about five times the degree in the plane, and nine times the degree
of the tangent in space.
*/
Curve_extremes_d curvature_extremes(std::span<const Constraint> constraints, const Solver_options& options = {});

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, Curve_extreme_kind kind)
{
  return out << (kind == Curve_extreme_kind::MAXIMUM       ? "maximum"
                     : kind == Curve_extreme_kind::MINIMUM ? "minimum"
                                                           : "undecided");
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_extremes_d turning_points(std::span<const Constraint> constraints,
                                                               const Unknown& u, const Solver_options& options)
{
  const internal::Curve_quantity quantity(constraints, "turning_points");
  internal::common_symbols(quantity.unknowns().front().symbols(), u.symbols());
  return quantity.stationary_points(quantity.tangent()[u.index()], options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_extremes_d curvature_extremes(std::span<const Constraint> constraints,
                                                                   const Solver_options& options)
{
  const internal::Curve_quantity curve(constraints, "curvature_extremes");
  const bool is_plane = curve.unknowns().size() == 2;
  return curve.stationary_points(
      is_plane ? internal::rate_of_signed_curvature(curve) : internal::rate_of_squared_curvature(curve), options);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_EXTREMES_H
