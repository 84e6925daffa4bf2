// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_IMPROVEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_IMPROVEMENT_H

#include <CGAL/Spline_constraints_d/function/Value_and_gradient.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <CGAL/FPU.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
Why `improve_point()` stopped. The step is the least-norm Newton step at the point; it is tiny when none of its entries exceeds \f$2^{-50}\f$ times the largest
coordinate.
*/
enum class Newton_status {
  CONVERGED,       ///< all equalities vanish exactly; or no entry of the step exceeds a unit in the last place of its coordinate; or the step is tiny and lowers the residual no further
  STAGNATED,       ///< the step is not tiny, and neither it nor any of its halves down to \f$2^{-12}\f$ lowers the residual as a linear function would by half
  SINGULAR,        ///< the Jacobian, rows scaled to largest entry 1, has smaller numerical rank than there are equalities
  LEFT_DOMAIN,     ///< the step, not tiny, leads out of the domain, and no step along the faces that the point lies on lowers the residual
  ITERATION_LIMIT  ///< none of these after `Newton_options::maximal_iterations` steps
};

inline std::ostream& operator<<(std::ostream& out, Newton_status status)
{
  static const char* const names[] = {"converged", "stagnated", "singular", "left the domain", "iteration limit"};
  return out << names[static_cast<int>(status)];
}

/*!
\ingroup PkgSplineConstraintsDSolver
Options of `improve_point()`, to be used with designated initialisers.
*/
struct Newton_options
{
  //! most steps that are taken.
  int maximal_iterations = 100;

  //! the Jacobian has the rank of the number of pivots of its rank-revealing QR decomposition above this multiple of the largest one.
  double rank_tolerance = 1e-13;

  //! \throws Invalid_input when a value makes no sense.
  void check() const
  {
    if (maximal_iterations < 0)
      throw Invalid_input("Newton_options: the number of iterations must not be negative");
    if (!(rank_tolerance > 0 && rank_tolerance < 1))
      throw Invalid_input("Newton_options: the rank tolerance must lie between 0 and 1");
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver
What `improve_point()` found.
*/
struct Newton_result
{
  std::vector<double> point;    ///< in the domain
  Newton_status status = Newton_status::ITERATION_LIMIT;
  double residual = 0;          ///< the largest absolute value of an equality at the point, evaluated exactly and rounded
  int iterations = 0;           ///< steps taken
};

namespace internal {

// Value and derivatives of a function by all unknowns of a system at a point of the domain; at a break those from the right.
inline Value_and_gradient<Exact_rational> exact_value_and_gradient(const Spline_function& function, const std::vector<Exact_rational>& point)
{
  Value_and_gradient<Exact_rational> result{Exact_rational(0), std::vector<Exact_rational>(point.size(), Exact_rational(0))};
  for (const Spline_term& term : function.terms()) {
    std::size_t cell = 0;
    Contraction_weights<Exact_rational> weights;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      const Exact_rational& x = point[term.variables[j]];
      const std::vector<Exact_rational>& breaks = term.breaks[j];
      const auto next = breaks.empty() ? breaks.end() : std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
      cell = cell * term.cells(j) + (breaks.empty() ? 0 : next - breaks.begin() - 1);
      std::vector<Exact_rational> powers(1, Exact_rational(1)), slopes(1, Exact_rational(0));
      for (int k = 1; k <= term.degrees[j]; ++k) {
        slopes.push_back(Exact_rational(k) * powers.back());
        powers.push_back(powers.back() * x);
      }
      weights.push_back({std::move(powers), std::move(slopes)});
    }
    const auto part = contracted_gradient(term.pieces[cell], weights);
    result.value += part.value;
    for (std::size_t j = 0; j < term.variables.size(); ++j)
      result.gradient[term.variables[j]] += part.gradient[j];
  }
  return result;
}

/*
The iteration of improve_point(). Values and derivatives are exact and rounded only after row i has been divided by its largest derivative m_scale[i]: the residual
f_i / m_scale[i] is a length, a first-order bound from below on the distance to the zero set of f_i, and nothing overflows.
*/
class Newton_iteration
{
  using Vector = Eigen::VectorXd;

  const Constraint_system_d& m_system;
  const double m_rank_tolerance;
  const std::size_t m_unknowns, m_equalities;
  std::vector<std::pair<double, double>> m_domain;   // the doubles of the domain
  std::vector<double> m_point;
  std::vector<Value_and_gradient<Exact_rational>> m_functions;   // at the point
  std::vector<Exact_rational> m_scale;
  Eigen::MatrixXd m_jacobian;
  Vector m_residual;

public:
  Newton_iteration(const Constraint_system_d& system, const Newton_options& options)
    : m_system(system), m_rank_tolerance(options.rank_tolerance), m_unknowns(system.dimension()), m_equalities(system.equalities().size()),
      m_jacobian(m_equalities, m_unknowns), m_residual(m_equalities)
  {
    for (std::size_t j = 0; j < m_unknowns; ++j) {
      const auto& [lower, upper] = system.domain(static_cast<int>(j));
      m_domain.emplace_back(to_double_interval(lower).second, to_double_interval(upper).first);
      if (m_domain.back().second < m_domain.back().first)
        throw Invalid_input("improve_point: the domain of unknown " + std::to_string(j) + " holds no double");
    }
  }

  Newton_result run(std::vector<double> start, int maximal_iterations)
  {
    Newton_result result;
    m_point = std::move(start);
    clamp(m_point);
    m_functions = evaluated(m_point);
    std::optional<Newton_status> status;
    while (!(status = improved())) {
      if (result.iterations == maximal_iterations) {
        status = Newton_status::ITERATION_LIMIT;
        break;
      }
      ++result.iterations;
      if ((status = advance()))
        break;
    }
    result.status = *status;
    for (const auto& function : m_functions)
      result.residual = (std::max)(result.residual, std::abs(CGAL::to_double(function.value)));
    result.point = std::move(m_point);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif
