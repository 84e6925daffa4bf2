// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_IMPLICITIZATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_IMPLICITIZATION_H

#include <CGAL/Spline_constraints_d/geometry/Implicit_hypersurface.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/Found_implicit_equation.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#endif
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

The equation of a curve in the plane (`d` is 2) or a surface in space (3), or a proof that it has none of a low degree.
*/
template <int d>
class Implicitization
{
  std::optional<Implicit_hypersurface<d>> m_equation;
  int m_least_degree;
  Summary m_summary;

public:
  //! what `implicitization()` has found.
  explicit Implicitization(internal::Intersections::Found_implicit_equation found)
    : m_least_degree(found.least_degree), m_summary(found.summary)
  {
    if (!found.polynomial)
      return;
    typename Implicit_hypersurface<d>::Box box;
    std::copy(found.box.begin(), found.box.end(), box.begin());
    m_equation.emplace(std::move(*found.polynomial), box);
  }

  //! the zeros of the polynomial, in a box around the curve or surface, all of which lies on them; nothing if there is
  //! no polynomial of the degrees that were asked for, or the run was ended. Other points of the box may be zeros, too.
  const std::optional<Implicit_hypersurface<d>>& equation() const { return m_equation; }

  //! the degree of the polynomial, or one that it reaches at least: every polynomial of a lower degree is not zero
  //! somewhere on the curve or surface, or zero everywhere, by proof.
  int least_degree() const { return m_least_degree; }

  //! whether all degrees that were asked for were looked at.
  bool is_complete() const { return m_summary.is_complete; }

  //! the time, and why the run was ended, if it was.
  const Summary& summary() const { return m_summary; }
};

namespace internal {
namespace Intersections {

// A curve in the plane or a surface in space, or an object of CGAL that is converted to one.
template <class Object>
concept Implicitized_operand = Intersection_operand<Object>::is_bounded &&
    Intersection_operand<Object>::number_of_parameters == Intersection_operand<Object>::dimension - 1;

} // namespace Intersections
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

the polynomial of the least degree that is zero on a curve in the plane or on a surface, if that is at most the given
one.

The coefficients are the solution of linear equations: \f$f\f$ is zero on a piece if it is zero at so many points that
\f$w^k f(X/w)\f$ can have no others. They are solved exactly; that there is no solution is mostly told modulo a prime,
which proves it. So the equation holds on the whole curve or surface, and there is none of a lower degree: it is
irreducible if the curve or surface is one piece, or its pieces continue each other. If they do not, as those of a
polygon, it is the product of their equations. Only a constant factor is left open.

A planar curve of degree \f$n\f$ has an equation of degree \f$n\f$ at most, a surface of the degrees \f$(m, n)\f$ one of
degree \f$2mn\f$ at most, and quadrics, tori and cyclides have one of degree 2 or 4, whatever the degrees of their
splines.

\tparam Object a model of `ParametricCurve_2` or `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param object the curve or surface.
\param most_degree the degree up to which equations are looked for, from 1 to 20.
\param options those of the solver, of which the time limit and the visitor are used.
\throws Invalid_input when another degree is asked for, all points are the same one, a part of a surface is a curve or a
point, a weight is not proved to have one sign, or an option makes no sense.

Complexity: for each degree \f$k\f$, that of a system of linear equations in \f${k+d \choose d}\f$ unknowns. Source:
\cgalCite{pm-sicad-02}.
*/
template <class Object>
requires internal::Intersections::Implicitized_operand<Object>
auto implicitization(const Object& object, int most_degree = 6, const Solver_options& options = {})
{
  using Operand = internal::Common::Intersection_operand<Object>;
  return Implicitization<Operand::dimension>(
      internal::Intersections::implicit_equation_of<Operand::dimension>(Operand::map(object), most_degree, options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_IMPLICITIZATION_H
