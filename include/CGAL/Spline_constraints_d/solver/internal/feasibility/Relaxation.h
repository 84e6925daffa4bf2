// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_RELAXATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_RELAXATION_H

#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Polynomial_family.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The relaxation of Agmon, Motzkin and Schoenberg with the gradients of nonlinear functions, in doubles: of the functions
that violate their relation, the one that is the farthest from zero, as its tangent has it, moves the point

  x <- x - rho (d + delta) n,   d = f / |grad f|,   n = grad f / |grad f|,

where rho in (0, 2]. With delta = 0 a curved boundary is only approached; delta > 0 leads inside. The point does not
leave the box. Where the gradient of a function is zero, it is the turn of the next one. Functions are those of a family
that has their values and gradients at a point.
*/
template <class Family = Polynomial_family<double>>
class Relaxation
{
  Family& m_family;
  const std::vector<Relation>& m_relations; // =, <, <= to zero; others are not looked at
  double m_factor, m_offset;

public:
  Relaxation(Family& family, const std::vector<Relation>& relations, double factor, double offset)
    : m_family(family), m_relations(relations), m_factor(factor), m_offset(offset)
  {}

  // False where no function moves the point.
  bool step(std::vector<double>& point, const Double_box& box)
  {
    m_family.set_point(point);
    double distance = 0;
    std::vector<double> direction;
    for (std::size_t i = 0; i < m_relations.size(); ++i) {
      if (m_relations[i] == Relation::NOT_EQUAL)
        continue;
      const double value = m_family.value(m_family.coefficients(i));
      const bool is_equality = m_relations[i] == Relation::EQUAL;
      if (is_equality ? value == 0 : m_relations[i] == Relation::LESS ? value < 0 : value <= 0)
        continue;
      std::vector<double> gradient = m_family.gradient(m_family.coefficients(i));
      double length = 0;
      for (std::size_t j = 0; j < gradient.size(); ++j)
        length += box.lower[j] < box.upper[j] ? gradient[j] * gradient[j] : 0;
      length = std::sqrt(length);
      if (!(length > 0) || !(length < HUGE_VAL))
        continue;
      const double own = std::abs(value) / length + (is_equality ? 0 : m_offset);
      if (own <= distance)
        continue;
      distance = own;
      direction = std::move(gradient);
      for (double& d : direction)
        d /= value < 0 ? -length : length;
    }
    if (direction.empty())
      return false;
    for (std::size_t j = 0; j < point.size(); ++j)
      if (box.lower[j] < box.upper[j])
        point[j] = box.clamped(j, point[j] - m_factor * distance * direction[j]);
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_RELAXATION_H
