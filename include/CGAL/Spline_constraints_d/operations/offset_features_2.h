// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_OFFSET_FEATURES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_OFFSET_FEATURES_2_H

#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/geometry/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/Locus_intersection.h>
#include <CGAL/Spline_constraints_d/operations/internal/Locus_system.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What makes the points at u and v on pieces of a curve the same point of its offset, which is C(u) + r N(u) / q: two equations, the side of the curve, and that u is before v.
class Offset_self_intersection
{
  const Exact_rational& m_distance;
  const Differentiated_map &m_first, &m_second;
  std::vector<Unknown> m_unknowns;   // u, v, q

public:
  Offset_self_intersection(const Exact_rational& distance, const Differentiated_map& first, const Differentiated_map& second)
    : m_distance(distance), m_first(first), m_second(second)
  {
    const Vector_formula<2> tangent = [&](std::span<const Unknown> u) { return first(1, u[0]); };
    const Unknown_domains range{first.map().domain(0)};
    m_unknowns = unknowns_in({range[0], second.map().domain(0), length_range<2>(tangent, range, "self_intersections: the derivative of the curve")});
  }

  // On one piece, both equations have factors u - v, and what is left of them is the same where u = v: |C'|^2 (1 - r k) with the curvature k. So their difference has this factor as well.
  std::vector<Constraint> constraints(const Exact_rational& period) const
  {
    const Unknown &u = m_unknowns[0], &v = m_unknowns[1], &q = m_unknowns[2];
    const Vector_expression<2> chord = m_first(0, u) - m_second(0, v), normal = perpendicular(m_first(1, u)), tangent = m_second(1, v);
    Expression direction = dot(chord, tangent) * q + m_distance * dot(normal, tangent);                    // q <P - C(v), C'(v)>
    Expression distance = squared_norm(chord) * q + 2 * m_distance * dot(chord, normal);                   // q (|P - C(v)|^2 - r^2)
    const Expression side = m_distance * (dot(chord, perpendicular(tangent)) * q + m_distance * dot(normal, perpendicular(tangent)));   // q r <P - C(v), N(v)>
    if (&m_first == &m_second) {
      distance = divided_exactly(distance, u - v, 2);
      direction = divided_exactly(divided_exactly(direction, u - v) - distance, u - v);
    }
    std::vector<Constraint> result{direction == 0, distance == 0, q * q == squared_norm(normal), side > 0, u < v};
    if (period != 0)
      result.push_back(v < u + period);
    return result;
  }

  // Whether the parameters are at ends of the domain is known where they are single numbers; else a box at an end is not decided.
  Locus_intersection<2> intersection(const Solution_d<double>& solution, const std::pair<Exact_rational, Exact_rational>& domain) const
  {
    const Solution_d<double>::Exact_box box = solution.exact_box();
    const std::vector<std::vector<Locus_parameter>> parameters{{{box[0], domain}}, {{box[1], domain}}};
    Intersection_kind kind = intersection_kind(solution.kind());
    for (const auto& parameter : parameters)
      if (kind == Intersection_kind::TRANSVERSAL && parameter[0].is_at_end)
        kind = Intersection_kind::END_POINT;
      else if (kind != Intersection_kind::OVERLAP && !parameter[0].is_at_end && (parameter[0].range.first == domain.first || parameter[0].range.second == domain.second))
        kind = Intersection_kind::UNDECIDED;
    const Vector_expression<2> point = m_first(0, m_unknowns[0]) + perpendicular(m_first(1, m_unknowns[0])) * (m_distance / m_unknowns[2]);
    return {kind, coordinate_ranges<2>(point, m_unknowns, box), parameters, solution};
  }
};

} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDOperations
@{
*/

/*!
the cusps of an offset: where \f$1 - r\kappa = 0\f$ with the signed curvature \f$\kappa\f$ of the curve, so that the derivative of the offset vanishes. There it meets the evolute of the curve, with
the same parameter, and that is how answers are to be read: a `TRANSVERSAL` one, or one of odd multiplicity, is a cusp; where the multiplicity is even, \f$1 - r\kappa\f$ does not change its sign, and the
offset goes on; an `OVERLAP` is an arc whose offset is its center. At breaks where the curvature jumps an offset may turn back without a zero; this is not reported.

\param offset the offset; operand 0 of the answers.
\param options those of the solver; limits hold for each piece.
\throws Invalid_input when an option makes no sense.

Complexity: one system in one unknown per polynomial piece, \f$r^2 (C' \times C'')^2 = |C'|^6\f$ with \f$r\,(C' \times C'') > 0\f$. Nothing is undecided unless a limit is reached.
*/
inline Locus_intersections<2> cusps(const Offset_curve_2& offset, const Solver_options& options = {})
{
  internal::Summing_solver solve(options);
  const Exact_rational& r = offset.distance();
  const auto pieces = internal::polynomial_pieces(offset.curve(), 2);
  const bool is_closed = offset.curve().is_closed();
  const auto is_cusp_at_begin = [&](const internal::Differentiated_map& piece) {
    const internal::Exact_pair tangent = piece.at(1, piece.begin());
    const Exact_rational turn(r * internal::exact_cross(tangent, piece.at(2, piece.begin()))), square = internal::exact_dot(tangent, tangent);
    return turn > 0 && turn * turn == square * square * square;
  };
  std::vector<Locus_intersection<2>> result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto [u] = parameters(pieces[i].map());
    const Vector_expression<2> tangent = pieces[i](1, u);
    const Expression turn = r * determinant(tangent, pieces[i](2, u));
    std::vector<Constraint> constraints{turn * turn == pow(squared_norm(tangent), 3), turn > 0};
    if ((i + 1 < pieces.size() || is_closed) && is_cusp_at_begin(pieces[(i + 1) % pieces.size()]))
      constraints.push_back(u < pieces[i].end());   // it is found there
    const Vector_expression<2> center = pieces[i](0, u) + perpendicular(tangent) * (r * squared_norm(tangent) / turn);
    for (const Solution_d<double>& solution : solve(constraints)) {
      const auto box = solution.exact_box();
      result.push_back({internal::intersection_kind(solution.kind()), internal::coordinate_ranges<2>(center, {u}, box), {{{box[0], offset.domain()}}}, solution});
    }
  }
  return Locus_intersections<2>(std::move(result), solve.total());
}

/*!
where an offset meets itself: all pairs of parameters \f$u < v\f$ with the same point. The parameters are those of operands 0 and 1 of the answers, which both are the offset.

On one polynomial piece, the solutions \f$u = v\f$ are removed exactly, by division, the cusps among them: what remains of the equations there is \f$1 - r\kappa = 0\f$ and the derivative of the curvature. On different
pieces they only meet in common ends, a singular solution; where the solver cannot exclude it, an undecided answer next to the break remains.

\param offset the offset.
\param options those of the solver; limits hold for each pair of pieces.
\throws Invalid_input when an option makes no sense.

Complexity: a system of three equations in three unknowns, \f$u, v\f$ and \f$|C'(u)|\f$, for each pair of polynomial pieces. Source: \cgalCite{p-cgl-03}.
*/
inline Locus_intersections<2> self_intersections(const Offset_curve_2& offset, const Solver_options& options = {})
{
  internal::Summing_solver solve(options);
  const auto pieces = internal::polynomial_pieces(offset.curve(), 1);
  const auto domain = offset.domain();
  std::vector<Locus_intersection<2>> result;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i; j < pieces.size(); ++j) {
      const internal::Offset_self_intersection system(offset.distance(), pieces[i], pieces[j]);
      const bool are_at_seam = i == 0 && j + 1 == pieces.size() && offset.curve().is_closed();
      const auto& [begin, end] = domain;
      for (const Solution_d<double>& solution : solve(system.constraints(are_at_seam ? Exact_rational(end - begin) : Exact_rational(0))))
        result.push_back(system.intersection(solution, domain));
    }
  return Locus_intersections<2>(std::move(result), solve.total());
}

/*!
@}
*/

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_OFFSET_FEATURES_2_H
