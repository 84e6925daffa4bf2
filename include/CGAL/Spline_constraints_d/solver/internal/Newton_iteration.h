// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NEWTON_ITERATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NEWTON_ITERATION_H

#include <CGAL/Spline_constraints_d/function/Value_and_gradient.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>

#include <CGAL/FPU.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Value and derivatives of a function by all unknowns of a system at a point of the domain; at a break those from the
// right.
inline Value_and_gradient<Exact_rational> exact_value_and_gradient(const Spline_function& function,
                                                                   const std::vector<Exact_rational>& point)
{
  Value_and_gradient<Exact_rational> result{Exact_rational(0),
                                            std::vector<Exact_rational>(point.size(), Exact_rational(0))};
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
The iteration of improve_point(). Values and derivatives are exact and rounded only after row i has been divided by its
largest derivative m_scale[i]: the residual f_i / m_scale[i] is a length, a first-order bound from below on the distance
to the zero set of f_i, and nothing overflows.
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
    : m_system(system), m_rank_tolerance(options.rank_tolerance), m_unknowns(system.dimension()),
      m_equalities(system.equalities().size()), m_jacobian(m_equalities, m_unknowns), m_residual(m_equalities)
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
    move_to(std::move(start));
    for (;; ++result.iterations)
      if (const std::optional<Newton_status> status = advance(result.iterations < maximal_iterations)) {
        result.status = *status;
        break;
      }
    for (const auto& function : m_functions)
      result.residual = (std::max)(result.residual, std::abs(to_nearest_double(function.value)));
    result.point = std::move(m_point);
    return result;
  }

private:
  // One step, or the reason why there is none.
  std::optional<Newton_status> advance(bool may_step)
  {
    if (std::all_of(m_functions.begin(), m_functions.end(), [](const auto& f) { return CGAL::is_zero(f.value); }))
      return Newton_status::CONVERGED;
    std::vector<bool> is_held(m_unknowns, false);
    if (!linearise())
      return Newton_status::SINGULAR;
    const std::optional<Vector> step = least_norm_step(is_held);
    if (!step)
      return Newton_status::SINGULAR;
    const bool is_last_place = is_within_last_place(*step);
    if (is_last_place || !may_step) {
      if (is_last_place)
        try_step(*step, 1, 1);
      return is_last_place ? Newton_status::CONVERGED : Newton_status::ITERATION_LIMIT;
    }

    const std::optional<Vector> inner = step_along_faces(*step, is_held);
    for (int halvings = 0; inner && halvings <= 12; ++halvings)
      if (const double part = std::ldexp(1.0, -halvings); try_step(*inner, part, 1 - part / 2))
        return std::nullopt;
    if (is_tiny(*step)) {
      try_step(*step, 1, 1);
      return Newton_status::CONVERGED;
    }
    return is_inside(*step * 0x1p-12) ? Newton_status::STAGNATED : Newton_status::LEFT_DOMAIN;
  }

  // Jacobian and residuals at the point, rows divided by their largest derivatives; false when all derivatives of a
  // function vanish.
  bool linearise()
  {
    m_scale.clear();
    for (std::size_t i = 0; i < m_equalities; ++i) {
      const auto& [value, gradient] = m_functions[i];
      Exact_rational largest(0);
      for (const Exact_rational& derivative : gradient)
        largest = (std::max)(largest, Exact_rational(CGAL::abs(derivative)));
      if (CGAL::is_zero(largest))
        return false;
      for (std::size_t j = 0; j < m_unknowns; ++j)
        m_jacobian(i, j) = to_nearest_double(gradient[j] / largest);
      m_residual[i] = to_nearest_double(value / largest);
      m_scale.push_back(std::move(largest));
    }
    return m_residual.allFinite();
  }

  // The shortest step to the zero of the linearisation that leaves the held unknowns alone (Elber and Kim 2001, Section
  // 2.2); none when there are fewer independent rows than rows.
  std::optional<Vector> least_norm_step(const std::vector<bool>& is_held) const
  {
    Eigen::MatrixXd jacobian = m_jacobian;
    for (std::size_t j = 0; j < m_unknowns; ++j)
      if (is_held[j])
        jacobian.col(j).setZero();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(m_rank_tolerance);
    decomposition.compute(jacobian);
    if (decomposition.rank() < jacobian.rows())
      return std::nullopt;
    Vector step = decomposition.solve(-m_residual);
    return step.allFinite() ? std::optional<Vector>(std::move(step)) : std::nullopt;
  }

  // The same with all unknowns held that it would move out of the domain from where they are.
  std::optional<Vector> step_along_faces(std::optional<Vector> step, std::vector<bool>& is_held) const
  {
    for (bool is_new = true; is_new && step;) {
      is_new = false;
      for (std::size_t j = 0; j < m_unknowns; ++j) {
        const auto& [lower, upper] = m_domain[j];
        if (!is_held[j] && ((m_point[j] <= lower && (*step)[j] < 0) || (m_point[j] >= upper && (*step)[j] > 0)))
          is_held[j] = is_new = true;
      }
      if (is_new)
        step = least_norm_step(is_held);
    }
    return step;
  }

  // Goes a part of a step, as far as the domain reaches, when this multiplies the norm of the residual by at most
  // `factor`.
  bool try_step(const Vector& step, double part, double factor)
  {
    std::vector<double> target = m_point;
    for (std::size_t j = 0; j < m_unknowns; ++j)
      target[j] += part * step[j];
    clamp(target);
    std::vector<Value_and_gradient<Exact_rational>> functions = evaluated(target);
    Vector residual(m_equalities);
    for (std::size_t i = 0; i < m_equalities; ++i)
      residual[i] = to_nearest_double(functions[i].value / m_scale[i]);
    if (!(residual.stableNorm() <= factor * m_residual.stableNorm()))
      return false;
    m_point = std::move(target);
    m_functions = std::move(functions);
    return true;
  }

  void move_to(std::vector<double> point)
  {
    clamp(point);
    m_functions = evaluated(point);
    m_point = std::move(point);
  }

  std::vector<Value_and_gradient<Exact_rational>> evaluated(const std::vector<double>& point) const
  {
    std::vector<Exact_rational> exact;
    for (double x : point)
      exact.push_back(rational_of_finite(x));
    std::vector<Value_and_gradient<Exact_rational>> result;
    for (const Spline_function& function : m_system.equalities())
      result.push_back(exact_value_and_gradient(function, exact));
    return result;
  }

  void clamp(std::vector<double>& point) const
  {
    for (std::size_t j = 0; j < m_unknowns; ++j)
      point[j] = std::clamp(point[j], m_domain[j].first, m_domain[j].second);
  }

  bool is_inside(const Vector& step) const
  {
    for (std::size_t j = 0; j < m_unknowns; ++j)
      if (m_point[j] + step[j] < m_domain[j].first || m_domain[j].second < m_point[j] + step[j])
        return false;
    return true;
  }

  bool is_within_last_place(const Vector& step) const
  {
    const double unit = 0x1p-80 * largest_coordinate();   // a coordinate that tends to zero has no last place
    for (std::size_t j = 0; j < m_unknowns; ++j) {
      const double x = std::abs(m_point[j]);
      if (std::abs(step[j]) > (std::max)(std::nextafter(x, HUGE_VAL) - x, unit))
        return false;
    }
    return true;
  }

  bool is_tiny(const Vector& step) const { return step.lpNorm<Eigen::Infinity>() <= 0x1p-50 * largest_coordinate(); }

  double largest_coordinate() const
  {
    double largest = 0;
    for (double x : m_point)
      largest = (std::max)(largest, std::abs(x));
    return largest;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Newton_result improved_point(const Constraint_system_d& system,
                                                            std::vector<double> start, const Newton_options& options)
{
  options.check();
  const std::size_t unknowns = system.dimension();
  if (system.equalities().size() > unknowns)
    throw Invalid_input("improve_point: " + std::to_string(system.equalities().size()) + " equalities for " +
                        std::to_string(unknowns) + " unknowns");
  if (start.size() != unknowns)
    throw Invalid_input("improve_point: the start has " + std::to_string(start.size()) + " coordinates for " +
                        std::to_string(unknowns) + " unknowns");
  for (std::size_t j = 0; j < unknowns; ++j)
    if (!std::isfinite(start[j]))
      throw Invalid_input("improve_point: coordinate " + std::to_string(j) + " of the start is not finite");
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  return Newton_iteration(system, options).run(std::move(start), options.maximal_iterations);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NEWTON_ITERATION_H
