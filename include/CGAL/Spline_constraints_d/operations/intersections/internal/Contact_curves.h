// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CONTACT_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CONTACT_CURVES_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Common_point_filter.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/equations_of_pairs.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Face_factor.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_factors.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Regular_pair.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The common points of two parametric surfaces A(u,v) and B(s,t) that touch along a curve, where f(A) = 0 for a polynomial
f.

On a contact curve the equations A = B are singular. If f(B) has repeated factors, let g be the product of its factors
without the exponents. All common points satisfy

  <A - B, B_s> = <A - B, B_t> = 0, g(s,t) = 0,

and these are regular where the surfaces touch, and g is. Other solutions are pairs of points of f = 0 on a normal of B.
By the mean value theorem 0 = f(A) - f(B) = lambda <grad f, n>, with n = B_s x B_t, A - B = lambda n, and the gradient
at some point between: so both are the same point where <grad f, n> is not zero around them.

Where a contact curve runs along a break, a seam or an edge of a surface, those equations do not say so, since no one of
them is zero there. If B, too, has an equation h(B) = 0, let B be a surface on which g = 0 is such a line, with the
tangent T = B_s or B_t. All common points satisfy

  g(s,t) = 0, h(A(u,v)) = 0 without repeated factors, <A - B, T> = 0,

where the lines are factors. Both points of a solution are common zeros of f and h. If these are those of a regular pair
p = q = 0, and grad p, grad q and T are independent in a box around both points, they are the same point: p, q and the
product with T are the same.
*/
class Contact_curves
{
  const Surface_equations& m_surfaces;
  const std::size_t m_implicit, m_other;   // the indices of A and B
  const Power_polynomial m_polynomial;
  const Simple_factors m_factors;   // of f(B)

  // What is known of contacts along a line of B.
  struct Line
  {
    int axis;                  // of the parameter along it
    Simple_factors factors;    // of h(A)
    Regular_pair common_zeros;
  };
  std::optional<Line> m_line;

public:
  // With A as the surface of an index, and the equations of both surfaces, as far as they are known. Nothing if f(B)
  // has no repeated factors, if the tangents of B jump, or if the surfaces may touch along a break or an edge of A.
  static std::optional<Contact_curves> make(const Surface_equations& surfaces,
                                            const std::array<std::optional<Power_polynomial>, 2>& polynomials,
                                            std::size_t implicit)
  {
    const std::array<const Spline_patch<3>*, 2> patches{&*surfaces.surface(implicit).patch,
                                                        &*surfaces.surface(1 - implicit).patch};
    const auto &polynomial = polynomials[implicit], &other = polynomials[1 - implicit];
    const bool is_one_piece = patches[0]->breaks(0).size() == 2 && patches[0]->breaks(1).size() == 2 &&
        !patches[0]->is_closed(0) && !patches[0]->is_closed(1);
    if (!polynomial || has_creases(*patches[1]) ||
        !(is_one_piece || (other && !may_vanish_on_break(*other, *patches[0]))))
      return std::nullopt;
    Contact_curves result(surfaces, implicit, *polynomial, Simple_factors(incidence(*polynomial, *patches[1])));
    return result.m_factors.is_simpler() ? std::optional(std::move(result)) : std::nullopt;
  }

  // Those for contacts along lines of B of both directions, if there are some and a regular pair is known.
  static std::vector<Contact_curves> along_lines(const Surface_equations& surfaces,
                                                 const std::array<std::optional<Power_polynomial>, 2>& polynomials,
                                                 std::size_t implicit, const std::optional<Regular_pair>& common_zeros)
  {
    const Spline_patch<3>&a = *surfaces.surface(implicit).patch, &b = *surfaces.surface(1 - implicit).patch;
    std::vector<Contact_curves> result;
    if (!common_zeros || has_creases(b))
      return result;
    Contact_curves contact(surfaces, implicit, *polynomials[implicit],
                           Simple_factors(incidence(*polynomials[implicit], b)));
    for (const int axis : {0, 1})
      if (contact.m_factors.is_simpler() && has_line(contact.m_factors.system(), axis)) {
        contact.m_line.emplace(Line{axis, Simple_factors(incidence(*polynomials[1 - implicit], a)), *common_zeros});
        result.push_back(contact);
      }
    return result;
  }

  // The equations above.
  Constraint_system_d system() const
  {
    Constraint_system_d result(domain_of(m_surfaces.system()));
    for (const int axis : {0, 1})
      if (!m_line || m_line->axis == axis)
        result.add(projection(m_surfaces, m_other, axis), Relation::EQUAL);
    result.add(in_all_unknowns(m_factors.system().equalities().front(), m_surfaces, m_other), Relation::EQUAL);
    if (m_line)
      result.add(in_all_unknowns(m_line->factors.system().equalities().front(), m_surfaces, m_implicit),
                 Relation::EQUAL);
    return result;
  }

  // Those of the solutions of the system that are common points. What is neither proved to be that nor not to be is
  // undecided.
  Curve_solution_set_d common_points(const Curve_solution_set_d& all) const
  {
    const auto is_one_point = [&](const std::vector<Mpfr_interval>& both, const Exact_ranges& solution) {
      const Spline_patch<3> other = Common_point_filter::part(m_surfaces, m_other, solution);
      return m_line ? is_one_point_on_line(both, other) : crosses_normals(gradient_of(m_polynomial, both), other);
    };
    const auto own = [&](const Exact_ranges& box) {
      const auto first = box.begin() + static_cast<std::ptrdiff_t>(m_surfaces.parameter(m_other, 0).unknown);
      return Exact_ranges(first, first + 2);
    };
    // in f(B)
    const auto multiplicity = [&](const Exact_ranges& piece, const Exact_ranges& vertex) {
      return m_factors.multiplicity(own(piece), own(vertex));
    };
    return Common_point_filter(m_surfaces, is_one_point, multiplicity)(all);
  }

private:
  Contact_curves(const Surface_equations& surfaces, std::size_t implicit, Power_polynomial polynomial,
                 Simple_factors factors)
    : m_surfaces(surfaces), m_implicit(implicit), m_other(1 - implicit), m_polynomial(std::move(polynomial)),
      m_factors(std::move(factors))
  {}

  // Whether tangents jump.
  static bool has_creases(const Spline_patch<3>& patch)
  {
    const auto jumps = [&](int axis) {
      const std::vector<Axis_part> parts = parts_of(patch, axis, perpendicular_before);
      return std::any_of(parts.begin(), parts.end(),
                         [](const Axis_part& part) { return part.range.first == part.range.second; });
    };
    return jumps(0) || jumps(1);
  }

  // Whether an equation of two unknowns is zero along an edge or a break on which one of them varies.
  static bool has_line(const Constraint_system_d& system, int axis)
  {
    const std::vector<Exact_rational> places = places_of_faces(system, 1 - axis);
    return std::any_of(places.begin(), places.end(), [&](const Exact_rational& place) {
      return Face_factor(system.equalities().front(), 1 - axis, system.domain(1 - axis), place).divides();
    });
  }

  // Whether a polynomial is zero in some points of a piece of a break or an edge of a surface.
  static bool may_vanish_on_break(const Power_polynomial& polynomial, const Spline_patch<3>& surface)
  {
    constexpr int tries = 4;
    for (const int axis : {0, 1}) {
      const std::vector<Exact_rational> breaks = surface.breaks(1 - axis);
      for (const Exact_rational& end : surface.breaks(axis))
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
          int zeros = 0;
          for (int k = 0; k < tries; ++k) {
            std::vector<Exact_rational> parameters{
                end, Exact_rational(breaks[i] + (breaks[i + 1] - breaks[i]) * Exact_rational(2 * k + 1, 2 * tries))};
            if (axis == 1)
              std::swap(parameters[0], parameters[1]);
            zeros += CGAL::is_zero(polynomial(surface(parameters))) ? 1 : 0;
          }
          if (zeros == tries)
            return true;
        }
    }
    return false;
  }

  // Whether two common zeros of the polynomials in a box are the same, if their difference is perpendicular to the
  // tangent of the line in a part of B.
  bool is_one_point_on_line(const std::vector<Mpfr_interval>& box, const Spline_patch<3>& part) const
  {
    const Vector_bounds<3> bounds = part.tangents(m_line->axis);
    std::array<Mpfr_interval, 3> tangent;
    for (std::size_t i = 0; i < 3; ++i)
      tangent[i] = Mpfr_interval(bounds[i].lower, bounds[i].upper);
    const auto& [p, q] = m_line->common_zeros.polynomials();
    return are_independent(gradient_of(p, box), gradient_of(q, box), tangent);
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CONTACT_CURVES_H
