// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_RATIONAL_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_RATIONAL_POINTS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_problem.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Rational_point = std::vector<Exact_rational>;

inline Exact_ranges box_of_point(const Rational_point& point)
{
  Exact_ranges result;
  for (const Exact_rational& x : point)
    result.emplace_back(x, x);
  return result;
}

// Rational points near approximate ones that satisfy a problem, checked by exact signs.
class Rational_points
{
  const Feasibility_problem& m_problem;
  Polynomial_family<Interval>& m_family;

public:
  Rational_points(const Feasibility_problem& problem, Polynomial_family<Interval>& family)
    : m_problem(problem), m_family(family)
  {}

  // The point itself, moved into the domain.
  std::optional<Rational_point> at(const std::vector<double>& point)
  {
    if (is_certainly_no_solution(point))
      return std::nullopt;
    Rational_point exact;
    for (int j = 0; j < m_problem.dimension(); ++j)
      exact.push_back(in_domain(j, m_problem.is_free(j) ? Exact_rational(point[j]) : m_problem.domain()[j].first));
    return checked(std::move(exact));
  }

  // Points with simple coordinates beside it, the nearest ones first: solutions without neighbours are often such.
  std::optional<Rational_point> simple_near(const std::vector<double>& point)
  {
    for (const double reach : {0x1p-44, 0x1p-34, 0x1p-26, 0x1p-18}) {
      Rational_point exact;
      for (int j = 0; j < m_problem.dimension(); ++j) {
        const double size =
            (std::max)(std::abs(point[j]), CGAL::to_double(m_problem.domain()[j].second - m_problem.domain()[j].first));
        exact.push_back(m_problem.is_free(j)
                            ? in_domain(j,
                                        simplest_rational_between(Exact_rational(point[j] - reach * size),
                                                                  Exact_rational(point[j] + reach * size)))
                            : m_problem.domain()[j].first);
      }
      if (auto found = checked(std::move(exact)))
        return found;
    }
    return std::nullopt;
  }

  // The one with the simplest coordinates in a box.
  std::optional<Rational_point> simplest_in(const Exact_ranges& box)
  {
    Rational_point exact;
    for (int j = 0; j < m_problem.dimension(); ++j)
      exact.push_back(in_domain(j, simplest_rational_between(box[j].first, box[j].second)));
    return checked(std::move(exact));
  }

private:
  std::optional<Rational_point> checked(Rational_point point) const
  {
    return m_problem.is_satisfied_at(point) ? std::optional(std::move(point)) : std::nullopt;
  }

  Exact_rational in_domain(int j, const Exact_rational& x) const
  {
    const auto& [lower, upper] = m_problem.domain()[j];
    return x < lower ? lower : upper < x ? upper : x;
  }

  // By intervals, which saves most exact signs. Points beside the domain are moved by less than the double below the
  // least one in it: their intervals reach as far.
  bool is_certainly_no_solution(const std::vector<double>& point)
  {
    std::vector<Interval> place;
    for (const double x : point)
      place.emplace_back(next_below(x), next_above(x));
    m_family.set_point(place);
    for (std::size_t i = 0; i < m_problem.size(); ++i) {
      const Interval value = m_family.value(m_family.coefficients(i));
      const bool is_equality = m_problem[i].relation == Relation::EQUAL;
      if ((value.inf() > 0 && m_problem[i].relation != Relation::NOT_EQUAL) || (is_equality && value.sup() < 0))
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_RATIONAL_POINTS_H
