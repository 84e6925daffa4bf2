// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_DIFFERENTIALS_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_DIFFERENTIALS_D_H

#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/internal/Jet.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/number/concepts.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

A point of a curve with its first three derivatives, and what they tell of the curve: tangent, curvature and torsion.

The derivatives are by one of the unknowns, the parameter. Where a square root is taken the result is a `Real`: an
enclosure if `NT` is one, else a double.

\tparam NT a `SplineNumberType`.
*/
template <SplineNumberType NT>
class Curve_differentials_d
{
public:
  //! the numbers of results that need a square root.
  using Real = std::conditional_t<Number_traits<NT>::is_enclosure, CGAL::Interval_nt<false>, double>;

private:
  using Guard = typename Number_traits<NT>::Rounding_guard;
  using Jet = internal::Jet<NT>;

  std::vector<Exact_rational> m_place;   // tells pieces of splines
  std::vector<Jet> m_coordinates;
  int m_parameter;

public:
  //! those that an operation has found near a place.
  Curve_differentials_d(std::vector<Exact_rational> place, std::vector<Jet> coordinates, int parameter)
    : m_place(std::move(place)), m_coordinates(std::move(coordinates)), m_parameter(parameter)
  {}

  //! number of coordinates.
  int dimension() const { return static_cast<int>(m_coordinates.size()); }

  //! the unknown that derivatives are taken by; the curve is passed in the direction in which it increases.
  int parameter() const { return m_parameter; }

  //! the point.
  std::vector<NT> point() const
  {
    return coordinates([](const Jet& x) { return x.value; });
  }

  //! the first derivative by the parameter.
  std::vector<NT> first_derivative() const
  {
    return coordinates([](const Jet& x) { return x.first; });
  }

  //! the second derivative by the parameter.
  std::vector<NT> second_derivative() const
  {
    return coordinates([](const Jet& x) { return x.second; });
  }

  //! the third derivative by the parameter.
  std::vector<NT> third_derivative() const
  {
    return coordinates([](const Jet& x) { return x.third; });
  }

  //! the second derivative by the arc length: it is orthogonal to the tangent, and as long as the curvature.
  std::vector<NT> curvature_vector() const
  {
    [[maybe_unused]] const Guard guard;
    const NT speed = dot(&Jet::first, &Jet::first), share = dot(&Jet::first, &Jet::second) / speed;
    return coordinates([&](const Jet& x) -> NT { return (x.second - share * x.first) / speed; });
  }

  //! the square of the curvature.
  NT squared_curvature() const
  {
    [[maybe_unused]] const Guard guard;
    NT result = Number_traits<NT>::from_double(0);
    for (const NT& x : curvature_vector())
      result += x * x;
    return result;
  }

  //! the first derivative by the arc length.
  std::vector<Real> unit_tangent() const
  {
    [[maybe_unused]] const Guard guard;
    std::vector<Real> result;
    for (const Jet& x : m_coordinates)
      result.push_back(signed_root(x.first, x.first * x.first / dot(&Jet::first, &Jet::first)));
    return result;
  }

  //! the curvature, not negative.
  Real curvature() const { return root(squared_curvature()); }

  //! the curvature of a plane curve, positive where it bends to the left.
  //! \throws Invalid_input when there are not two coordinates.
  Real signed_curvature() const
  {
    if (dimension() != 2)
      throw Invalid_input("Curve_differentials_d: a signed curvature in " + std::to_string(dimension()) +
                          " dimensions");
    [[maybe_unused]] const Guard guard;
    const NT cross =
        m_coordinates[0].first * m_coordinates[1].second - m_coordinates[1].first * m_coordinates[0].second;
    return signed_root(cross, squared_curvature());
  }

  //! the torsion of a curve in space; nothing where the curvature is not proved to be positive.
  //! \throws Invalid_input when there are not three coordinates.
  std::optional<NT> torsion() const
  {
    if (dimension() != 3)
      throw Invalid_input("Curve_differentials_d: a torsion in " + std::to_string(dimension()) + " dimensions");
    [[maybe_unused]] const Guard guard;
    NT volume = Number_traits<NT>::from_double(0), square = volume;
    for (std::size_t i = 0; i < 3; ++i) {
      const Jet &a = m_coordinates[(i + 1) % 3], &b = m_coordinates[(i + 2) % 3];
      const NT binormal = a.first * b.second - b.first * a.second;
      volume += binormal * m_coordinates[i].third;
      square += binormal * binormal;
    }
    return Number_traits<NT>::enclosure(square).inf() > 0 ? std::optional<NT>(volume / square) : std::nullopt;
  }

  /*!
  the same point, tangent and so on of the image of the curve under a map, such as a surface \f$S(u,v)\f$, by the chain
  rule; where the map has breaks, of the piece behind them.
  \param map formulas in the unknowns.
  \throws Invalid_input when the formulas are of other unknowns, or a divisor is zero.
  */
  template <int d>
  Curve_differentials_d image(const Vector_expression<d>& map) const
  {
    [[maybe_unused]] const Guard guard;
    std::vector<Jet> result;
    for (int i = 0; i < d; ++i)
      result.push_back(internal::expression_value(map[i], std::span<const Exact_rational>(m_place),
                                                  std::span<const Jet>(m_coordinates)));
    return {m_place, std::move(result), m_parameter};
  }

private:
  template <class Function>
  std::vector<NT> coordinates(const Function& function) const
  {
    std::vector<NT> result;
    for (const Jet& x : m_coordinates)
      result.push_back(function(x));
    return result;
  }

  NT dot(NT Jet::*a, NT Jet::*b) const
  {
    NT result = Number_traits<NT>::from_double(0);
    for (const Jet& x : m_coordinates)
      result += x.*a * x.*b;
    return result;
  }

  static Real root(const NT& square)
  {
    if constexpr (Number_traits<NT>::is_enclosure) {
      const CGAL::Protect_FPU_rounding<true> guard;
      const CGAL::Interval_nt<false> x = Number_traits<NT>::enclosure(square);
      return CGAL::sqrt(CGAL::Interval_nt<false>((std::max)(0.0, x.inf()), (std::max)(0.0, x.sup())));
    } else
      return std::sqrt(CGAL::to_double(square));
  }

  // The root with the sign of another number, which is zero only if the square is.
  static Real signed_root(const NT& sign, const NT& square)
  {
    const Real result = root(square);
    if constexpr (Number_traits<NT>::is_enclosure) {
      const CGAL::Interval_nt<false> x = Number_traits<NT>::enclosure(sign);
      return x.inf() >= 0 ? result : x.sup() <= 0 ? -result : CGAL::Interval_nt<false>(-result.sup(), result.sup());
    } else
      return sign < NT(0) ? -result : result;
  }
};

namespace internal {

// The numbers of a range, or its middle if the numbers enclose nothing.
template <class NT>
NT number_of_range(const std::pair<Exact_rational, Exact_rational>& range)
{
  if constexpr (std::is_same_v<NT, Mpfr_interval>)
    return Mpfr_interval(range.first, range.second);
  else if constexpr (Number_traits<NT>::is_enclosure)
    return NT(to_double_interval(range.first).first, to_double_interval(range.second).second);
  else
    return Number_traits<NT>::from_rational(Exact_rational((range.first + range.second) / 2));
}

/*
The derivatives of the curve of solutions through a point: f(x(t)) = 0 with a tangent a = x' is J a = 0, and J x'' = -h
where h = a^T H a is the second derivative of f along the straight line with the direction a; in the same way J x''' =
-k with the third derivative k of f along the parabola with the derivatives a and x''.
*/
template <class NT>
class Implicit_differentiation
{
  using Jets = std::vector<Jet<NT>>;

  const Constraint_system_d& m_system;
  std::vector<Exact_rational> m_place;
  std::vector<NT> m_point;

public:
  Implicit_differentiation(const Constraint_system_d& system, const Curve_vertex::Exact_box& box) : m_system(system)
  {
    check_position(box);
    for (const auto& range : box) {
      m_place.push_back(range.first);
      m_point.push_back(number_of_range<NT>(range));
    }
  }

  // Empty when the rank of the Jacobian is not seen to be full. Without a parameter, by the best one.
  std::optional<Curve_differentials_d<NT>> operator()(const std::optional<int>& parameter) const
  {
    const std::size_t n = m_point.size(), length = n + n - 1;
    const std::vector<std::size_t> unknowns = with_last(parameter);
    std::vector<NT> rows = jacobian_beside_unit_matrix(unknowns);
    const std::vector<int> row_of =
        gauss_jordan(rows, length, parameter ? n - 1 : n, n - 1, [](const NT& x) { return magnitude(x); });
    if (row_of.empty())
      return std::nullopt;
    // n - 1 if there is none
    const std::size_t free = static_cast<std::size_t>(std::find(row_of.begin(), row_of.end(), -1) - row_of.begin());
    std::vector<NT> first(n, number(0)), second(n, number(0)), third(n, number(0));
    first[unknowns[free]] = number(1);
    for (std::size_t j = 0; j < n; ++j)
      if (j != free)
        first[unknowns[j]] = -rows[row_of[j] * length + free];
    const auto subtract_solution = [&](std::vector<NT>& x, const Jets& values, NT Jet<NT>::*right_side) {
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; j != free && i + 1 < n; ++i)
          x[unknowns[j]] -= rows[row_of[j] * length + n + i] * values[i].*right_side;
    };
    subtract_solution(second, along(first), &Jet<NT>::second);
    subtract_solution(third, along(first, second), &Jet<NT>::third);
    Jets result;
    for (std::size_t j = 0; j < n; ++j) {
      if (!std::isfinite(magnitude(first[j])) || !std::isfinite(magnitude(second[j])))
        return std::nullopt;
      result.emplace_back(m_point[j], first[j], second[j], third[j]);
    }
    return Curve_differentials_d<NT>(m_place, std::move(result), static_cast<int>(unknowns[free]));
  }

private:
  static NT number(double x) { return Number_traits<NT>::from_double(x); }

  // Zero for zero only.
  static double magnitude(const NT& x)
  {
    const CGAL::Interval_nt<false> range = Number_traits<NT>::enclosure(x);
    return (std::max)(std::abs(range.inf()), std::abs(range.sup()));
  }

  // The unknowns, a chosen one at the end.
  std::vector<std::size_t> with_last(const std::optional<int>& chosen) const
  {
    std::vector<std::size_t> result(m_point.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    if (chosen)
      std::rotate(result.begin() + *chosen, result.begin() + *chosen + 1, result.end());
    return result;
  }

  std::vector<NT> jacobian_beside_unit_matrix(const std::vector<std::size_t>& unknowns) const
  {
    const std::size_t n = m_point.size(), length = n + n - 1;
    std::vector<NT> rows((n - 1) * length, number(0));
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<NT> axis(n, number(0));
      axis[unknowns[j]] = number(1);
      const Jets derivatives = along(axis);
      for (std::size_t i = 0; i + 1 < n; ++i)
        rows[i * length + j] = derivatives[i].first;
    }
    for (std::size_t i = 0; i + 1 < n; ++i)
      rows[i * length + n + i] = number(1);
    return rows;
  }

  // The equations along a straight line, or a parabola.
  Jets along(const std::vector<NT>& direction, const std::vector<NT>& second = {}) const
  {
    Jets line, result;
    for (std::size_t j = 0; j < m_point.size(); ++j)
      line.emplace_back(m_point[j], direction[j], second.empty() ? number(0) : second[j]);
    for (const Spline_function& function : m_system.equalities())
      result.push_back(
          spline_value(function, std::span<const Exact_rational>(m_place), std::span<const Jet<NT>>(line)));
    return result;
  }

  void check_position(const Curve_vertex::Exact_box& box) const
  {
    const auto fail = [](const std::string& what) { throw Invalid_input("curve_differentials: " + what); };
    const int n = m_system.dimension();
    if (static_cast<int>(m_system.equalities().size()) != n - 1)
      fail(std::to_string(m_system.equalities().size()) + " equalities for " + std::to_string(n) + " unknowns");
    if (static_cast<int>(box.size()) != n)
      fail("a point with " + std::to_string(box.size()) + " coordinates for " + std::to_string(n) + " unknowns");
    for (const Spline_function& function : m_system.equalities())
      for (const Spline_term& term : function.terms())
        for (std::size_t j = 0; j < term.variables.size(); ++j)
          for (const Exact_rational& at : term.breaks[j])
            if (const auto& [lower, upper] = box[term.variables[j]]; lower < at && at < upper)
              fail("the range of unknown " + std::to_string(term.variables[j]) + " lies on both sides of a break");
  }
};

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

derivatives, tangent, curvature and torsion of the curve of solutions through a point, by implicit differentiation of
its equations. At a break of a spline they are those of the piece behind it.

With `NT = Exact_rational` all is exact, and belongs to the curve \f$f(x) = f(p)\f$ through the point \f$p\f$ given,
which rounding has moved off the solutions a little. With an enclosure, `Mpfr_interval` or `CGAL::Interval_nt<false>`,
and a box that is proved to hold a solution, as that of a `Curve_vertex`, the results enclose those of the solution.

\tparam NT a `SplineNumberType`.
\param system the system that was solved, with one equality less than unknowns.
\param box ranges of the unknowns around the point; of numbers that enclose nothing, the middle is taken.
\param parameter the unknown to differentiate by; by default, one that varies along the curve as fast as the others or
nearly so.
\return nothing where the gradients of the equations are not proved to be independent: at a singular point; or where the
chosen parameter is stationary.
\throws Invalid_input when the number of equalities or ranges is another one, there is no such parameter, or a range
lies on both sides of a break.

Complexity: \f$n + 2\f$ evaluations of the equations and an elimination. Source: \cgalCite{kes-gcps-05}, equations 9-17
and 34-37, for any number of unknowns.
*/
template <SplineNumberType NT>
std::optional<Curve_differentials_d<NT>> curve_differentials(const Constraint_system_d& system,
                                                             const Curve_vertex::Exact_box& box,
                                                             std::optional<int> parameter = std::nullopt)
{
  if (parameter && (*parameter < 0 || *parameter >= system.dimension()))
    throw Invalid_input("curve_differentials: no unknown " + std::to_string(*parameter));
  [[maybe_unused]] const typename Number_traits<NT>::Rounding_guard guard;
  return internal::Implicit_differentiation<NT>(system, box)(parameter);
}

// The two number types that follow.
#define CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(EXTERN, NT)                                                        \
  EXTERN template std::optional<Curve_differentials_d<NT>> curve_differentials<NT>(                                    \
      const Constraint_system_d&, const Curve_vertex::Exact_box&, std::optional<int>);
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(extern, Mpfr_interval)
CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(extern, Exact_rational)
#endif

//! \ingroup PkgSplineConstraintsDSolver
//! the same at a vertex of a curve, as enclosures that hold for the exact solution.
inline std::optional<Curve_differentials_d<Mpfr_interval>>
curve_differentials(const Constraint_system_d& system, const Curve_vertex& vertex,
                    std::optional<int> parameter = std::nullopt)
{
  return curve_differentials<Mpfr_interval>(system, vertex.box, parameter);
}

//! \ingroup PkgSplineConstraintsDSolver
//! the same at a point of a polyline, exactly for the curve \f$f(x) = f(p)\f$ through it. \throws Invalid_input also
//! when a coordinate is not finite.
inline std::optional<Curve_differentials_d<Exact_rational>>
curve_differentials(const Constraint_system_d& system, const std::vector<double>& point,
                    std::optional<int> parameter = std::nullopt)
{
  Curve_vertex::Exact_box box;
  for (const double x : point)
    box.emplace_back(to_rational(x), to_rational(x));
  return curve_differentials<Exact_rational>(system, box, parameter);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_DIFFERENTIALS_D_H
