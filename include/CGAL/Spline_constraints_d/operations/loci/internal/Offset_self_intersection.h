// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_OFFSET_SELF_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_OFFSET_SELF_INTERSECTION_H

#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_composition.h>
#include <CGAL/Spline_constraints_d/function/internal/substitution.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Locus_system.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Locus_intersection.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

// A polynomial piece of a curve, and whether its end does not belong to the next one.
struct Offset_piece
{
  Differentiated_map curve;
  bool has_end;
};

// An end that two pieces have in common, as a corner of their parameters, and the signed lengths of their ranges from
// there.
struct Common_end
{
  Exact_rational u, v, u_length, v_length;
};

/*
What makes the points at u < v on two pieces of a curve the same point C(u) + r N(u) / q of its offset: with the chord D
= C(u) - C(v),

  A = q <D, C'(v)> + r <N(u), C'(v)> = 0,   B = q |D|^2 + 2 r <D, N(u)> = 0,   q^2 = |N(u)|^2,

and the point is on the right side of the curve at v. All u = v satisfy this as well, and are removed by divisions.
*/
class Offset_self_intersection
{
  const Exact_rational& m_distance;
  const Offset_piece &m_first, &m_second;
  std::pair<Exact_rational, Exact_rational> m_domain;
  Unknown_domains m_ranges;          // of u, v, q
  std::vector<Unknown> m_unknowns;
  Expression m_a = 0, m_b = 0, m_length = 0, m_side = 0;

public:
  Offset_self_intersection(const Exact_rational& distance, const Offset_piece& first, const Offset_piece& second,
                           const std::pair<Exact_rational, Exact_rational>& domain);

  std::vector<Locus_intersection<2>> solutions(Budgeted_solver& solve) const;

private:
  // The next piece after the first one, or, on a closed curve, the one before it.
  std::optional<Common_end> common_end() const;

  /*
  Pieces with a common end: a blow-up of it. With the distances x, y in [0,1] of u, v from the end, in units of the
  lengths of the pieces, one chart has x = c s y with s in [0,1], the other one c y = s x; c is not 1, since symmetric
  curves have solutions with x = y. Where the tangent is continuous, A has the factor y (or x), and B its square; what
  is left vanishes in the end only if 1 - r k does there. Nothing when there are no such factors.
  */
  std::optional<std::vector<Locus_intersection<2>>> solutions_beside(const Common_end& end,
                                                                     Budgeted_solver& solve) const;

  void add_open_ends(const Expression& u, const Expression& v, std::vector<Constraint>& constraints) const;

  // Whether the parameters are at ends of the domain is known where they are single numbers; else a box at an end is
  // not decided.
  Locus_intersection<2> intersection(const Solution_d<double>& solution, const Unknown_domains& box) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE
Offset_self_intersection::Offset_self_intersection(const Exact_rational& distance, const Offset_piece& first,
                                                   const Offset_piece& second,
                                                   const std::pair<Exact_rational, Exact_rational>& domain)
  : m_distance(distance), m_first(first), m_second(second), m_domain(domain)
{
  const Unknown_domains range{first.curve.map().domain(0)};
  const Vector_formula<2> tangent_of_first = [&](std::span<const Unknown> u) { return first.curve(1, u[0]); };
  m_ranges = {range[0], second.curve.map().domain(0),
              length_range<2>(tangent_of_first, range, "self_intersections: the derivative of the curve")};
  m_unknowns = unknowns_in(m_ranges);
  const Unknown &u = m_unknowns[0], &v = m_unknowns[1], &q = m_unknowns[2];
  const Vector_expression<2> chord = first.curve(0, u) - second.curve(0, v), normal = perpendicular(first.curve(1, u)),
                             tangent = second.curve(1, v);
  m_a = dot(chord, tangent) * q + m_distance * dot(normal, tangent);
  m_b = squared_norm(chord) * q + 2 * m_distance * dot(chord, normal);
  m_length = q * q - squared_norm(normal);
  m_side = m_distance * (dot(chord, perpendicular(tangent)) * q + m_distance * dot(normal, perpendicular(tangent)));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Locus_intersection<2>>
Offset_self_intersection::solutions(Budgeted_solver& solve) const
{
  if (&m_first != &m_second)
    if (const std::optional<Common_end> end = common_end())
      if (const auto result = solutions_beside(*end, solve))
        return *result;
  const Unknown &u = m_unknowns[0], &v = m_unknowns[1];
  std::vector<Constraint> constraints{m_length == 0, m_side > 0, u < v};
  if (&m_first == &m_second) {
    // A / (u - v) and B / (u - v)^2 are the same where u = v, |C'|^2 (1 - r k) with the curvature k. So their
    // difference has this factor as well, and no cusp with k' != 0 satisfies what is left.
    const Expression b = divided_exactly(m_b, u - v, 2);
    constraints.push_back(b == 0);
    constraints.push_back(divided_exactly(divided_exactly(m_a, u - v) - b, u - v) == 0);
  } else {
    constraints.push_back(m_a == 0);
    constraints.push_back(m_b == 0);
  }
  add_open_ends(u, v, constraints);
  std::vector<Locus_intersection<2>> result;
  for (const Solution_d<double>& solution : solve(constraints))
    result.push_back(intersection(solution, solution.exact_box()));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Common_end> Offset_self_intersection::common_end() const
{
  const auto& [begin, end] = m_ranges[0];
  const auto& [other_begin, other_end] = m_ranges[1];
  if (end == other_begin)
    return Common_end{end, end, Exact_rational(begin - end), Exact_rational(other_end - other_begin)};
  if (begin == m_domain.first && other_end == m_domain.second && !m_second.has_end)
    return Common_end{begin, other_end, Exact_rational(end - begin), Exact_rational(other_begin - other_end)};
  return std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::vector<Locus_intersection<2>>>
Offset_self_intersection::solutions_beside(const Common_end& end, Budgeted_solver& solve) const
{
  std::vector<Locus_intersection<2>> result;
  const Exact_rational c = Exact_rational(5) / 7;
  for (const bool is_u_nearer : {true, false}) {
    const Exact_rational scale = is_u_nearer ? c : Exact_rational(1 / c);
    const std::vector<Unknown> unknowns = unknowns_in({{0, 1}, {0, 1}, m_ranges[2]}); // s, the larger distance, q
    const Unknown &s = unknowns[0], &t = unknowns[1];
    const Expression near = scale * s * t, u = end.u + end.u_length * (is_u_nearer ? near : t),
                     v = end.v + end.v_length * (is_u_nearer ? t : near);
    const auto in_chart = [&](const Expression& f) {
      return substituted(numerator_polynomial(f), std::array<Expression, 3>{u, v, unknowns[2]});
    };
    const Power_polynomial a = in_chart(m_a).polynomial(), b = in_chart(m_b).polynomial();
    if (monomial_content(a).exponent(1) < 1 || monomial_content(b).exponent(1) < 2)
      return std::nullopt;
    const auto divided_by_power = [&](const Power_polynomial& f, int exponent) {
      return Expression(divided(f, Monomial{{{1, exponent}}}), Monomial(), s.symbols());
    };
    std::vector<Constraint> constraints{divided_by_power(a, 1) == 0, divided_by_power(b, 2) == 0,
                                        in_chart(m_length) == 0, in_chart(m_side) > 0, t > 0};
    if (!is_u_nearer) {
      constraints.push_back(s < 1);
      constraints.push_back(near <= 1);
    }
    add_open_ends(u, v, constraints);
    for (const Solution_d<double>& solution : solve(constraints)) {
      const auto box = solution.exact_box();
      const auto range = [&](const Exact_rational& begin, const Exact_rational& length, bool is_near) {
        const Rational_interval distance = is_near
            ? Rational_interval(scale) * Rational_interval(box[0]) * Rational_interval(box[1])
            : Rational_interval(box[1]);
        const Rational_interval parameter = Rational_interval(begin) + Rational_interval(length) * distance;
        return std::pair(parameter.lower, parameter.upper);
      };
      result.push_back(intersection(
          solution, {range(end.u, end.u_length, is_u_nearer), range(end.v, end.v_length, !is_u_nearer), box[2]}));
    }
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Offset_self_intersection::add_open_ends(const Expression& u, const Expression& v,
                                                                            std::vector<Constraint>& constraints) const
{
  if (!m_first.has_end)
    constraints.push_back(u < m_ranges[0].second);
  if (!m_second.has_end)
    constraints.push_back(v < m_ranges[1].second);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Locus_intersection<2>
Offset_self_intersection::intersection(const Solution_d<double>& solution, const Unknown_domains& box) const
{
  const std::vector<std::vector<Locus_parameter>> parameters{{{box[0], m_domain}}, {{box[1], m_domain}}};
  Intersection_kind kind = intersection_kind(solution.kind());
  for (const auto& parameter : parameters)
    if (kind == Intersection_kind::TRANSVERSAL && parameter[0].is_at_end)
      kind = Intersection_kind::END_POINT;
    else if (kind != Intersection_kind::OVERLAP && !parameter[0].is_at_end &&
             (parameter[0].range.first == m_domain.first || parameter[0].range.second == m_domain.second))
      kind = Intersection_kind::UNDECIDED;
  const Vector_expression<2> point =
      m_first.curve(0, m_unknowns[0]) + perpendicular(m_first.curve(1, m_unknowns[0])) * (m_distance / m_unknowns[2]);
  return {kind, coordinate_ranges<2>(point, m_unknowns, box), parameters, solution};
}
#endif

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_OFFSET_SELF_INTERSECTION_H
