// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_CURVE_FEATURES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_CURVE_FEATURES_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Sign_sequence.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/reason_of.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/internal/Height_comparison.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

What is proved of a point, or piece, where a quantity along a curve may have an extreme, or change its sign.
*/
enum class Curve_feature_kind {
  INFLECTION,   ///< the curvature changes its sign
  MAXIMUM,      ///< a local maximum: smaller on both sides; at an end of the curve, on one
  MINIMUM,      ///< a local minimum
  /// the equation is satisfied and its sign does not change, or it is an end of the curve: neither of the above
  STATIONARY,
  /// the equation is satisfied on a whole piece, and nothing else is known: straight for inflections, an arc of a
  /// circle for extremes of curvature
  CONSTANT,
  SINGULAR,     ///< the derivative of the curve is zero: no curvature there
  BREAK,        ///< a corner of the curve; for extremes of curvature also a jump of the curvature
  UNDECIDED     ///< nothing is proved; only when a limit ended the run
};

//! \ingroup PkgSplineConstraintsDCurveFeatures
//! writes `inflection`, `maximum`, `minimum`, `stationary`, `constant`, `singular`, `break` or `undecided`.
std::ostream& operator<<(std::ostream& out, Curve_feature_kind kind);

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

A point of a planar curve with what is proved of it; or a piece of the curve, all of whose points are like that.
*/
template <SplineKernel Kernel>
class Curve_feature_2
{
  Curve_feature_kind m_kind;
  Point_on_spline<Kernel, 1, 2> m_point;
  bool m_is_family, m_is_at_break;
  CGAL::Uncertain<bool> m_is_global;
  std::vector<Solution_d<double>> m_solutions;

public:
  //! a feature that an operation has found.
  Curve_feature_2(Curve_feature_kind kind, Point_on_spline<Kernel, 1, 2> point,
                  const internal::Common::Sign_event& event, CGAL::Uncertain<bool> is_global)
    : m_kind(kind), m_point(std::move(point)), m_is_family(event.is_family()), m_is_at_break(event.is_break),
      m_is_global(is_global), m_solutions(event.zeros)
  {}

  //! what is proved.
  Curve_feature_kind kind() const { return m_kind; }

  //! the point: its parameter lies in the range, which is a single number where it is rational. Of a family, the range
  //! is the piece and the point is in its middle.
  const Point_on_spline<Kernel, 1, 2>& point_on_curve() const { return m_point; }

  //! whether all points of the range are solutions.
  bool is_family() const { return m_is_family; }

  //! whether it is at a break of the curve, or a family that contains one; the seam of a closed curve is one.
  bool is_at_break() const { return m_is_at_break; }

  //! for `extreme_points()`: whether no point of the curve is further on the side of this extreme. Indeterminate where
  //! heights differ by less than their enclosures; ties do not.
  CGAL::Uncertain<bool> is_global() const { return m_is_global; }

  //! the answers of the solver, with their proofs: none at a break where the sign jumps, several where pieces meet.
  const std::vector<Solution_d<double>>& solutions() const { return m_solutions; }
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

The features of a curve in the order of their parameters.
*/
template <SplineKernel Kernel>
class Curve_features_2 : public Answer_list<Curve_feature_2<Kernel>>
{
public:
  using Answer_list<Curve_feature_2<Kernel>>::Answer_list;

  //! all features, by increasing parameters.
  const std::vector<Curve_feature_2<Kernel>>& features() const { return this->answers(); }

  //! number of features of a kind.
  std::size_t count(Curve_feature_kind kind) const
  {
    return static_cast<std::size_t>(
        std::count_if(this->begin(), this->end(), [=](const auto& feature) { return feature.kind() == kind; }));
  }
};

namespace internal {
namespace Curve_features {

// Whether the derivative of the curve is zero at the only zero in the range of an event.
bool is_singular(const std::vector<Differentiated_map>& pieces, const Sign_event& event, Budgeted_solver& solve);

Curve_feature_kind kind_of_extreme(const Sign_event& event);

Curve_feature_kind kind_of_inflection(const Sign_event& event);

// Features of a curve, those among them that are undecided, and the work.
template <class Kernel>
Curve_features_2<Kernel> curve_features(std::vector<Curve_feature_2<Kernel>> features, const Planar_map& curve,
                                        const Summary& work)
{
  std::vector<Undecided_part> undecided;
  for (const Curve_feature_2<Kernel>& feature : features)
    if (feature.kind() == Curve_feature_kind::UNDECIDED)
      undecided.push_back(undecided_on_curves({{curve, 0, feature.point_on_curve().parameter_range()}},
                                              reason_of(feature.solutions())));
  return {std::move(features), std::move(undecided), work};
}

// The features that the signs of a formula of the curvature make.
template <class Kernel, class Kind>
Curve_features_2<Kernel> curvature_features(const Planar_map& curve, const std::vector<Differentiated_map>& pieces,
                                            const Sign_sequence& signs, const Kind& kind_of_event,
                                            Budgeted_solver& solve)
{
  std::vector<Curve_feature_2<Kernel>> result;
  for (const Sign_event& event : signs.events()) {
    Curve_feature_kind kind = kind_of_event(event);
    if (event.is_cut)
      kind = Curve_feature_kind::BREAK;
    else if (event.is_undecided())
      kind = Curve_feature_kind::UNDECIDED;
    else if (!event.is_family() && is_singular(pieces, event, solve))
      kind = Curve_feature_kind::SINGULAR;
    result.emplace_back(kind, Point_on_spline<Kernel, 1, 2>(curve, {event.range}), event, false);
  }
  return curve_features(std::move(result), curve, solve.total());
}

// The square of the curvature, with its sign.
Exact_rational signed_squared_curvature(const Differentiated_map& piece, const Exact_rational& t);

inline bool have_common_curvature(const Differentiated_map& before, const Differentiated_map& after)
{
  return have_common_tangent(before, after) &&
      signed_squared_curvature(before, before.end()) == signed_squared_curvature(after, after.begin());
}

// The ends of an open curve, that the formula need not be zero at, as the places where the derivative of the height
// changes its sign.
std::vector<Sign_event> events_with_ends(const Sign_sequence& signs, const Planar_map& curve);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE bool is_singular(const std::vector<Differentiated_map>& pieces, const Sign_event& event,
                                                Budgeted_solver& solve)
{
  for (const Differentiated_map& piece : pieces) {
    const Exact_rational lower = (std::max)(event.range.first, piece.begin()),
                         upper = (std::min)(event.range.second, piece.end());
    if (lower > upper)
      continue;
    const std::vector<Unknown> u = unknowns({{Bound(lower), Bound(upper)}});
    const Vector_expression<2> tangent = piece(1, u[0]);
    if (lower == upper ? piece.at(1, lower) == Exact_pair{0, 0} : !solve({tangent.x() == 0, tangent.y() == 0}).empty())
      return true;
  }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_feature_kind kind_of_extreme(const Sign_event& event)
{
  if (event.before * event.after < 0)
    return event.before > 0 ? Curve_feature_kind::MAXIMUM : Curve_feature_kind::MINIMUM;
  return event.is_family() ? Curve_feature_kind::CONSTANT : Curve_feature_kind::STATIONARY;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_feature_kind kind_of_inflection(const Sign_event& event)
{
  const Curve_feature_kind kind = kind_of_extreme(event);
  return kind == Curve_feature_kind::MAXIMUM || kind == Curve_feature_kind::MINIMUM ? Curve_feature_kind::INFLECTION
                                                                                    : kind;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational signed_squared_curvature(const Differentiated_map& piece,
                                                                       const Exact_rational& t)
{
  const Exact_pair tangent = piece.at(1, t);
  const Exact_rational product = exact_cross(tangent, piece.at(2, t)), squared_speed = exact_dot(tangent, tangent);
  return Exact_rational(sign_of(product) * product * product / (squared_speed * squared_speed * squared_speed));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Sign_event> events_with_ends(const Sign_sequence& signs,
                                                                        const Planar_map& curve)
{
  std::vector<Sign_event> events = signs.events();
  if (curve.is_closed())
    return events;
  const auto& [begin, end] = curve.domain(0);
  if (signs.first_sign() != 0)
    events.insert(events.begin(), {{begin, begin}, 0, signs.first_sign()});
  if (signs.last_sign() != 0)
    events.push_back({{end, end}, signs.last_sign(), 0});
  events.front().before = -events.front().after;
  if (events.size() > 1)
    events.back().after = -events.back().before;
  return events;
}
#endif

} // namespace Curve_features
} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDCurveFeatures
@{
*/

/*!
all inflections of a planar curve: the zeros of \f$C' \times C''\f$, and breaks where it changes its sign.

The sign on both sides of each zero is known exactly, from a value between it and the next one. `INFLECTION` says that
the curvature changes its sign, also across a straight piece (`Curve_feature_2::is_family()`); `STATIONARY` that it does
not, or that an open curve ends there; `CONSTANT` is a straight piece without that. Pieces of the curve are joined where
they have a common tangent; corners are reported as `BREAK`. On a closed curve what is at the seam is reported with the
first parameter.

\tparam Curve a model of `ParametricCurve_2`.
\param curve the curve; exact, as doubles are rational numbers.
\param options those of the solver; limits hold for the operation as a whole. Nothing depends on a tolerance.
\throws Invalid_input when an option makes no sense.

Complexity: one system in one unknown per polynomial piece, of degree \f$2d-4\f$ for polynomial curves of degree
\f$d\f$, and one per zero.
*/
template <ParametricCurve_2 Curve>
Curve_features_2<typename Curve::Kernel> inflections(const Curve& curve, const Solver_options& options = {})
{
  internal::Common::Budgeted_solver solve(options);
  const internal::Planar_map map(curve);
  const auto pieces = internal::polynomial_pieces(map, 2);
  const auto turn = [](const internal::Differentiated_map& c, const Unknown& u) { return cross(c(1, u), c(2, u)); };
  const internal::Common::Sign_sequence signs(pieces, map.is_closed(), turn, internal::have_common_tangent, solve);
  return internal::Curve_features::curvature_features<typename Curve::Kernel>(
      map, pieces, signs, internal::Curve_features::kind_of_inflection, solve);
}

/*!
the vertices of a planar curve: the local extremes of its signed curvature \f$\kappa = (C' \times C'')/\|C'\|^3\f$,
which are zeros of
\f[ (C' \times C''')\, \|C'\|^2 - 3\, (C' \times C'')\, \langle C', C''\rangle, \f]
the numerator of \f$\kappa'\f$, and breaks where it changes its sign.

A zero without a change of sign is `STATIONARY`, a circular arc or straight piece a family: `CONSTANT`, or an extreme if
the curvature is smaller, or larger, on both sides. Corners, and breaks where the curvature jumps, are reported as
`BREAK`. Pieces are joined where the curvature is continuous, whether the derivatives are or not.

\tparam Curve a model of `ParametricCurve_2`.
\param curve the curve.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: one system in one unknown per piece, and one per zero.
*/
template <ParametricCurve_2 Curve>
Curve_features_2<typename Curve::Kernel> curvature_extremes(const Curve& curve, const Solver_options& options = {})
{
  internal::Common::Budgeted_solver solve(options);
  const internal::Planar_map map(curve);
  const auto pieces = internal::polynomial_pieces(map, 3);
  const auto slope_of_curvature = [](const internal::Differentiated_map& c, const Unknown& u) {
    const auto first = c(1, u), second = c(2, u);
    return cross(first, c(3, u)) * squared_norm(first) - 3 * cross(first, second) * dot(first, second);
  };
  const internal::Common::Sign_sequence signs(pieces, map.is_closed(), slope_of_curvature,
                                              internal::Curve_features::have_common_curvature, solve);
  return internal::Curve_features::curvature_features<typename Curve::Kernel>(
      map, pieces, signs, internal::Curve_features::kind_of_extreme, solve);
}

/*!
the points of a planar curve that are extreme in a direction: the zeros of \f$\langle C', d\rangle\f$, corners where it
changes its sign, and the ends of an open curve.

Each is proved to be a local `MAXIMUM` or `MINIMUM` of \f$\langle C, d\rangle\f$, or neither (`STATIONARY`); a piece at
constant height is a family. `Curve_feature_2::is_global()` tells those that no point of the curve surpasses. Ties are
decided exactly: critical heights are zeros of a polynomial, a resultant.

\tparam Curve a model of `ParametricCurve_2`.
\param curve the curve.
\param direction the direction, not zero.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when the direction is zero or an option makes no sense.

Complexity: one system in one unknown per piece, \f$O(n^2)\f$ comparisons of \f$n\f$ heights, and at most as many
systems where they are close.
*/
template <ParametricCurve_2 Curve>
Curve_features_2<typename Curve::Kernel> extreme_points(const Curve& curve,
                                                        const typename Curve::Kernel::Vector_2& direction,
                                                        const Solver_options& options = {})
{
  const internal::Exact_pair d{internal::converted_number<Exact_rational>(direction.x()),
                               internal::converted_number<Exact_rational>(direction.y())};
  if (d == internal::Exact_pair{0, 0})
    throw Invalid_input("extreme_points: the direction is zero");
  internal::Common::Budgeted_solver solve(options);
  const internal::Planar_map map(curve);
  const auto pieces = internal::polynomial_pieces(map, 1);
  const auto slope = [&](const internal::Differentiated_map& c, const Unknown& u) {
    return dot(c(1, u), Vector_expression<2>(d[0], d[1]));
  };
  const auto is_continuous = [](const auto&, const auto&) { return true; };
  const internal::Common::Sign_sequence signs(pieces, map.is_closed(), slope, is_continuous, solve);
  const std::vector<internal::Common::Sign_event> events = internal::Curve_features::events_with_ends(signs, map);

  std::vector<Curve_feature_2<typename Curve::Kernel>> result;
  const internal::Curve_features::Height_comparison heights(curve, pieces, d, events, solve);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Curve_feature_kind kind =
        events[i].is_undecided() ? Curve_feature_kind::UNDECIDED : internal::Curve_features::kind_of_extreme(events[i]);
    const bool may_be_global = kind != Curve_feature_kind::STATIONARY && kind != Curve_feature_kind::UNDECIDED;
    const CGAL::Uncertain<bool> is_global = may_be_global
        ? heights.is_global(i, kind == Curve_feature_kind::MINIMUM ? -1 : 1)
        : CGAL::Uncertain<bool>(false);
    result.emplace_back(kind, Point_on_spline<typename Curve::Kernel, 1, 2>(map, {events[i].range}), events[i],
                        is_global);
  }
  return internal::Curve_features::curve_features(std::move(result), map, solve.total());
}

/*!
@}
*/

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, Curve_feature_kind kind)
{
  static const char* const names[] = {"inflection", "maximum",  "minimum", "stationary",
                                      "constant",   "singular", "break",   "undecided"};
  return out << names[static_cast<int>(kind)];
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_CURVE_FEATURES_2_H
