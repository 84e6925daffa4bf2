// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_POLE_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_POLE_SYSTEMS_H

#include <CGAL/Spline_constraints_d/function/internal/substitution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Common_point_filter.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/equations_of_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Equations, and a proof that solutions are common points.
struct Pole_system
{
  Constraint_system_d system;
  Common_point_filter::Test is_one_point;
};

/*
Equations of the common points of two parametric surfaces A(u,v) and B(s,t) that are regular at poles.

Where a pole of A lies on B, A = B says nothing of the parameter along the pole. If f(B) = 0 for a polynomial f, the
equation f(A(u,v)) = 0 does, divided by the factor that is zero at the pole. With

  <A - B, B_s> = <A - B, B_t> = 0

it has the common points as regular solutions, where the surfaces cross and B has no pole. Other solutions are pairs of
points of f = 0 on a normal of B.

Where h(A) = 0, too, other equations are

  f(A(u,v)) = 0, h(B(s,t)) = 0, <A - B, grad f x grad h> = 0

with the gradients at B. Other solutions are pairs of common zeros of f and h in a plane that the common curve crosses
in B.
*/
class Pole_systems
{
  using Polynomials = std::array<std::optional<Power_polynomial>, 2>;

  const Surface_equations& m_surfaces;
  const Polynomials& m_polynomials;

public:
  Pole_systems(const Surface_equations& surfaces, const Polynomials& polynomials)
    : m_surfaces(surfaces), m_polynomials(polynomials)
  {}

  // Those with the tangents of a surface that has an equation, and no poles on the other one; and that with both
  // equations, which is the simplest one of two spheres.
  std::vector<Pole_system> operator()(const std::array<bool, 2>& has_common_pole) const
  {
    std::vector<Pole_system> result;
    for (const std::size_t surface : {0, 1})
      if (m_polynomials[surface] && !has_common_pole[surface])
        result.push_back(with_tangents(surface));
    if (m_polynomials[0] && m_polynomials[1])
      result.insert(are_spheres() ? result.begin() : result.end(), with_gradients());
    return result;
  }

private:
  // That the equation of a surface holds on the other one.
  Spline_function incidence_of(std::size_t surface) const
  {
    return in_all_unknowns(
        incidence(*m_polynomials[surface], *m_surfaces.surface(1 - surface).patch).equalities().front(), m_surfaces,
        1 - surface);
  }

  Pole_system with_tangents(std::size_t surface) const
  {
    Constraint_system_d system(domain_of(m_surfaces.system()));
    system.add(incidence_of(surface), Relation::EQUAL);
    for (const int axis : {0, 1})
      system.add(projection(m_surfaces, surface, axis), Relation::EQUAL);
    return {std::move(system),
            [&surfaces = m_surfaces, &polynomial = *m_polynomials[surface],
             surface](const std::vector<Mpfr_interval>& both, const Exact_ranges& solution) {
              return crosses_normals(gradient_of(polynomial, both),
                                     Common_point_filter::part(surfaces, surface, solution));
            }};
  }

  Pole_system with_gradients() const
  {
    Constraint_system_d system(domain_of(m_surfaces.system()));
    for (const std::size_t surface : {0, 1})
      system.add(incidence_of(surface), Relation::EQUAL);
    const std::vector<Unknown> all = unknowns_in(domain_of(m_surfaces.system()));
    const auto point = [&](std::size_t surface) {
      return formula(Parametric_vector<3>(*m_surfaces.surface(surface).patch), m_surfaces, surface, all);
    };
    const Vector_expression<3> a = point(0), b = point(1);
    const std::array<Power_polynomial, 3> tangent = product_of_gradients();
    system.add(dot(a - b, vector_of<3>([&](std::size_t i) { return substituted(tangent[i], b); })) == 0);
    return {std::move(system),
            [&surfaces = m_surfaces, &polynomials = m_polynomials](const std::vector<Mpfr_interval>& both,
                                                                   const Exact_ranges& solution) {
              const std::array<Mpfr_interval, 3> p = gradient_of(*polynomials[0], both),
                                                 q = gradient_of(*polynomials[1], both);
              const Vector_bounds<3> bounds = Common_point_filter::part(surfaces, 1, solution).values();
              std::vector<Mpfr_interval> b;
              for (std::size_t i = 0; i < 3; ++i)
                b.emplace_back(bounds[i].lower, bounds[i].upper);
              return are_independent(p, q,
                                     cross_product(gradient_of(*polynomials[0], b), gradient_of(*polynomials[1], b)));
            }};
  }

  // The product of both gradients. Terms that cancel, as those of the squares of two spheres do, are gone before a
  // point is put in.
  std::array<Power_polynomial, 3> product_of_gradients() const
  {
    const auto derivative = [&](std::size_t surface, std::size_t i) {
      return m_polynomials[surface]->derivative(static_cast<int>(i));
    };
    std::array<Power_polynomial, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      result[i] = derivative(0, j) * derivative(1, k) - derivative(0, k) * derivative(1, j);
    }
    return result;
  }

  // Or quadrics that differ by a plane and a factor, as spheres do.
  bool are_spheres() const
  {
    const std::array<Power_polynomial, 3> product = product_of_gradients();
    return m_polynomials[0]->total_degree() == 2 && m_polynomials[1]->total_degree() == 2 &&
        std::all_of(product.begin(), product.end(), [](const Power_polynomial& p) { return p.total_degree() <= 1; });
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_POLE_SYSTEMS_H
