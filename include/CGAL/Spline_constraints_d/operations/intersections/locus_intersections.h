// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/Parametric_locus.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Locus_system.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Locus_intersection.h>
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

/*
The common points of several curves and surfaces: for each choice of a piece of every operand, the solutions of its
system, told apart by what is known of the ends of curves. Whether an end is a common point is a system with one unknown
less.
*/
template <int d>
class Locus_intersector
{
  using Solution = Solution_d<double>;
  using Box = Solution::Exact_box;
  using Range = std::pair<Exact_rational, Exact_rational>;
  using Intersection = Locus_intersection<d>;
  using Pieces = std::vector<Locus_piece<d>>;

  struct Operand
  {
    Pieces pieces;
    std::vector<Locus_end<d>> ends;
    std::vector<Range> domains;   // of the parameters
  };

  // A common point at an end of an operand, or perhaps none: the unknown with this one as its value, and ranges of all
  // of them.
  struct Incidence
  {
    std::size_t unknown;
    Box box;
    bool is_certain;
    bool is_excluded;   // the end is left to the begin of a closed curve
  };

  std::vector<Operand> m_operands;
  Budgeted_solver m_solve;
  std::vector<Intersection> m_result;

public:
  template <class... Loci>
  Locus_intersector(const Solver_options& options, const Loci&... loci) : m_operands{operand(loci)...}, m_solve(options)
  {}

  Locus_intersections<d> operator()()
  {
    for_each_choice({}, [&](const Pieces& pieces) {
      if (!m_solve.must_stop())
        intersect(pieces);
    });
    if (m_solve.reason() != Undecided_reason::NONE) { // one answer stands for all choices that were not looked at
      std::vector<std::vector<Range>> domains;
      for (const Operand& operand : m_operands)
        domains.push_back(operand.domains);
      m_result.push_back(undecided_locus_intersection<d>(domains, m_solve.reason()));
    }
    return ordered_by_kind(std::move(m_result), m_solve.total());
  }

private:
  template <class L>
  static Operand operand(const L& locus)
  {
    Operand result{locus.locus_pieces(), locus.locus_ends(), {}};
    if constexpr (L::number_of_parameters > 0)
      for (int axis = 0; axis < L::number_of_parameters; ++axis)
        result.domains.push_back(locus.domain(axis));
    return result;
  }

  template <class Visit>
  void for_each_choice(Pieces chosen, const Visit& visit) const
  {
    if (chosen.size() == m_operands.size())
      return visit(chosen);
    for (const Locus_piece<d>& piece : m_operands[chosen.size()].pieces) {
      chosen.push_back(piece);
      for_each_choice(chosen, visit);
      chosen.pop_back();
    }
  }

  void intersect(const Pieces& pieces)
  {
    const Locus_system<d> system(pieces);
    if (system.is_void() || (system.unknowns().empty() && !hold(system.constraints())))
      return;
    if (system.unknowns().empty()) {   // a point, decided by signs
      m_result.emplace_back(Intersection_kind::TRANSVERSAL, system.coordinates({}),
                            std::vector<std::vector<Locus_parameter>>(m_operands.size()),
                            Solution(Solution_kind::CERTIFIED, {}, {}, "exact", Undecided_reason::NONE, 1));
      return;
    }
    const Solution_set_d<double> solutions = m_solve(system.constraints());
    std::vector<Incidence> incidences;
    if (system.unknowns().size() > 1 && std::any_of(solutions.begin(), solutions.end(), [&](const Solution& s) {
          return is_near_end(s.exact_box(), system);
        }))
      incidences = incidences_of(pieces, system);
    for (const Solution& solution : solutions)
      if (auto intersection = classified(solution, system, incidences))
        m_result.push_back(std::move(*intersection));
  }

  // Calls visit(operand, axis, unknown) for all parameters.
  template <class Visit>
  void for_each_parameter(const Locus_system<d>& system, const Visit& visit) const
  {
    for (std::size_t i = 0; i < m_operands.size(); ++i)
      for (std::size_t axis = 0; axis < m_operands[i].domains.size(); ++axis)
        visit(i, axis, system.first_unknown(i) + axis);
  }

  static bool has(const Range& range, const Exact_rational& x) { return range.first <= x && x <= range.second; }

  bool is_near_end(const Box& box, const Locus_system<d>& system) const
  {
    bool result = false;
    for_each_parameter(system, [&](std::size_t i, std::size_t axis, std::size_t unknown) {
      const Range& domain = m_operands[i].domains[axis];
      result = result || has(box[unknown], domain.first) || has(box[unknown], domain.second);
    });
    return result;
  }

  // The common points at ends of the curves that these pieces are the first or last ones of.
  std::vector<Incidence> incidences_of(const Pieces& pieces, const Locus_system<d>& system)
  {
    std::vector<Incidence> result;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const Locus_end<d>& end : m_operands[i].ends) {
        if (!has(pieces[i].parameters[0], end.parameter))
          continue;
        Pieces others = pieces;
        others[i] = end.piece;
        const bool is_excluded = pieces[i].is_without_end[0] && end.parameter == pieces[i].parameters[0].second;
        for (const Solution& solution : m_solve(Locus_system<d>(others).constraints())) {
          Box box = solution.exact_box();
          box.insert(box.begin() + system.first_unknown(i), {end.parameter, end.parameter});
          result.push_back({system.first_unknown(i), std::move(box), is_one_point(solution), is_excluded});
        }
      }
    return result;
  }

  // The intersection that a solution stands for; none when it is at the end of a closed curve, which is its begin. A
  // regular solution on the boundary of the domain, or of an inequality, is undecided until it is known to be an end.
  std::optional<Intersection> classified(const Solution& solution, const Locus_system<d>& system,
                                         const std::vector<Incidence>& incidences) const
  {
    Box box = solution.exact_box();
    Intersection_kind kind = intersection_kind(solution.kind());
    const bool is_at_boundary = solution.reason() == Undecided_reason::DOMAIN_BOUNDARY,
               is_point = is_one_point(solution) || is_at_boundary;
    if (is_point || solution.reason() == Undecided_reason::INEQUALITY) {
      const Box region = solution.uniqueness_region().empty() ? box : solution.exact_uniqueness_region();
      for (const Incidence& incidence : incidences) {
        if (!meets(box, incidence.box))
          continue;
        if (!incidence.is_certain || !holds(region, incidence.box)) {
          kind = Intersection_kind::UNDECIDED;   // too close to tell
          break;
        }
        if (incidence.is_excluded)
          return std::nullopt;
        box[incidence.unknown] = incidence.box[incidence.unknown];
        if (is_at_boundary)
          kind = Intersection_kind::END_POINT;
      }
    }
    std::vector<std::vector<Locus_parameter>> parameters(m_operands.size());
    for_each_parameter(system, [&](std::size_t i, std::size_t axis, std::size_t unknown) {
      const Range& domain = m_operands[i].domains[axis];
      const Locus_parameter& parameter = parameters[i].emplace_back(box[unknown], domain);
      const bool has_known_ends = !m_operands[i].ends.empty() || system.unknowns().size() == 1;
      if (is_point && !parameter.is_at_end && !has_known_ends &&
          (has(parameter.range, domain.first) || has(parameter.range, domain.second)))
        kind = Intersection_kind::UNDECIDED;
      if (is_point && parameter.is_at_end && kind == Intersection_kind::TRANSVERSAL)
        kind = Intersection_kind::END_POINT;
    });
    return Intersection(kind, system.coordinates(box), std::move(parameters), solution);
  }

  static bool is_one_point(const Solution& solution)
  {
    return solution.kind() == Solution_kind::CERTIFIED || solution.kind() == Solution_kind::CLUSTER;
  }

  static bool meets(const Box& a, const Box& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](const Range& x, const Range& y) { return x.first <= y.second && y.first <= x.second; });
  }

  static bool holds(const Box& a, const Box& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](const Range& x, const Range& y) { return x.first <= y.first && y.second <= x.second; });
  }
};

template <class T>
concept Locus_operand = requires(const T& operand) { to_locus(operand); };

template <class T>
using Locus_of = decltype(to_locus(std::declval<const T&>()));

// Of the same space, with common points that are isolated as a rule; two of them are not both parametric.
template <class First, class... Others>
concept Locus_operands = Locus_operand<First> &&(Locus_operand<Others>&&...) &&
    (sizeof...(Others) > 1 || (Locus<First> || ... || Locus<Others>)) &&
    ((Locus_of<First>::dimension == Locus_of<Others>::dimension) && ...) &&
    (Locus_of<First>::codimension + ... + Locus_of<Others>::codimension) >= Locus_of<First>::dimension;

} // namespace Intersections
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

all intersections of two curves in the plane, or of a curve and a surface in space, or of a point with one of these, of
which one at least is implicit or procedural.

| operands | unknowns | equations |
|---|---|---|
| point, implicit | none | \f$f(p) = 0\f$, an exact sign |
| point, procedural | parameters | \f$p\f$ satisfies the conditions of the procedural one |
| parametric, implicit | parameters | \f$f(C(u)) = 0\f$: for a curve one equation in one unknown |
| implicit, implicit | coordinates | \f$f = g = 0\f$ |
| parametric, procedural | parameters of both | the point satisfies the conditions of the procedural one |
| procedural, implicit | parameter, auxiliary ones | those of the procedural one, and \f$f = 0\f$ |
| procedural, procedural | parameters of both, auxiliary ones of the first | all conditions |

All operands are taken exactly, and so are all decisions. A point at the seam of a closed curve, or on a knot, is
reported once, a seam with the first parameter. Whether a common point is an end of a curve is decided by a system with
one unknown less. Pieces that curves have in common are reported as `OVERLAP`, with `Solution_d::cover()`; with exact
parameters where a parametric curve lies on an implicit one, or in an implicit surface.

\tparam A,B models of `Locus`, `CGAL::Point_2`, `CGAL::Point_3`, `ParametricCurve_2`, `ParametricCurve_3` or
`ParametricSurface_3` in the same space; at least one a `Locus`. The codimensions add up to that of a point, or more.
\param a the first operand.
\param b the second operand.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense, a coordinate is not finite, or a weight is not proved to have one
sign.

Complexity: that of one system for each pair of smooth pieces; and of smaller ones for ends of curves, if common points
are near. Source: the classification of intersections by rational, procedural and implicit representations,
\cgalCite{p-cgl-03}.
*/
template <class A, class B>
  requires internal::Intersections::Locus_operands<A, B>
auto intersections(const A& a, const B& b, const Solver_options& options = {})
{
  return internal::Intersections::Locus_intersector<internal::Intersections::Locus_of<A>::dimension>(
      options, to_locus(a), to_locus(b))();
}

/*!
\ingroup PkgSplineConstraintsDIntersections

all points that three operands have in common: three surfaces in space, or the curve of intersection of two and a third
one. All may be parametric; the unknowns are the parameters of all of them then.

\tparam A,B,C as those of two operands, but for that all may be parametric.
\param a the first operand.
\param b the second operand.
\param c the third operand.
\param options those of the solver.
\throws Invalid_input as for two operands.
*/
template <class A, class B, class C>
  requires internal::Intersections::Locus_operands<A, B, C>
auto intersections(const A& a, const B& b, const C& c, const Solver_options& options = {})
{
  return internal::Intersections::Locus_intersector<internal::Intersections::Locus_of<A>::dimension>(
      options, to_locus(a), to_locus(b), to_locus(c))();
}

/*!
\ingroup PkgSplineConstraintsDIntersections

all points that four operands have in common: four surfaces in space, or the curves of intersection of two and two.
There are more equations than unknowns: common points are proved where their coordinates or parameters are rational or
in a number field of low degree, and excluded elsewhere.

\tparam A,B,C,D as those of three operands.
\param a the first operand.
\param b the second operand.
\param c the third operand.
\param d the fourth operand.
\param options those of the solver.
\throws Invalid_input as for two operands.
*/
template <class A, class B, class C, class D>
requires internal::Intersections::Locus_operands<A, B, C, D>
auto intersections(const A& a, const B& b, const C& c, const D& d, const Solver_options& options = {})
{
  return internal::Intersections::Locus_intersector<internal::Intersections::Locus_of<A>::dimension>(
      options, to_locus(a), to_locus(b), to_locus(c), to_locus(d))();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTIONS_H
