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
#include <CGAL/Spline_constraints_d/operations/common/internal/critical_values.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/reason_of.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
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
inline std::ostream& operator<<(std::ostream& out, Curve_feature_kind kind)
{
  static const char* const names[] = {"inflection", "maximum",  "minimum", "stationary",
                                      "constant",   "singular", "break",   "undecided"};
  return out << names[static_cast<int>(kind)];
}

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
inline bool is_singular(const std::vector<Differentiated_map>& pieces, const Sign_event& event, Budgeted_solver& solve)
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

inline Curve_feature_kind kind_of_extreme(const Sign_event& event)
{
  if (event.before * event.after < 0)
    return event.before > 0 ? Curve_feature_kind::MAXIMUM : Curve_feature_kind::MINIMUM;
  return event.is_family() ? Curve_feature_kind::CONSTANT : Curve_feature_kind::STATIONARY;
}

inline Curve_feature_kind kind_of_inflection(const Sign_event& event)
{
  const Curve_feature_kind kind = kind_of_extreme(event);
  return kind == Curve_feature_kind::MAXIMUM || kind == Curve_feature_kind::MINIMUM ? Curve_feature_kind::INFLECTION
                                                                                    : kind;
}

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
inline Exact_rational signed_squared_curvature(const Differentiated_map& piece, const Exact_rational& t)
{
  const Exact_pair tangent = piece.at(1, t);
  const Exact_rational product = exact_cross(tangent, piece.at(2, t)), squared_speed = exact_dot(tangent, tangent);
  return Exact_rational(sign_of(product) * product * product / (squared_speed * squared_speed * squared_speed));
}

inline bool have_common_curvature(const Differentiated_map& before, const Differentiated_map& after)
{
  return have_common_tangent(before, after) &&
      signed_squared_curvature(before, before.end()) == signed_squared_curvature(after, after.begin());
}

/*
Heights of the points of a curve in a direction, compared. Ranges of heights come from the coefficients of the curve on
the range of the parameter: about the critical points that are compared, heights differ by the square of its width.
Heights that are not told apart by that are zeros of polynomials, which decide whether they are equal.
*/
class Height_comparison
{
  struct Candidate
  {
    std::pair<Exact_rational, Exact_rational> parameters, heights;
    bool has_heights;
    bool is_exact() const { return has_heights && heights.first == heights.second; }
  };

  const std::vector<Differentiated_map>& m_pieces;
  Exact_pair m_direction;
  Bspline_function<Exact_rational> m_height, m_weight;
  Budgeted_solver& m_solve;
  std::vector<Candidate> m_candidates;

public:
  template <class Curve>
  Height_comparison(const Curve& curve, const std::vector<Differentiated_map>& pieces, const Exact_pair& direction,
                    const std::vector<Sign_event>& events, Budgeted_solver& solve)
    : m_pieces(pieces), m_direction(direction),
      m_height(curve.homogeneous_coordinates()[0] * direction[0] + curve.homogeneous_coordinates()[1] * direction[1]),
      m_weight(curve.weight()), m_solve(solve)
  {
    for (const Sign_event& event : events)
      m_candidates.push_back(candidate(event));
  }

  // Whether no candidate is higher (sign 1), or lower (sign -1), than one of them.
  CGAL::Uncertain<bool> is_global(std::size_t i, int sign) const
  {
    CGAL::Uncertain<bool> result = true;
    for (std::size_t j = 0; j < m_candidates.size(); ++j) {
      if (m_solve.must_stop())
        return CGAL::Uncertain<bool>::indeterminate();
      const CGAL::Uncertain<CGAL::Sign> comparison =
          i == j ? CGAL::Uncertain<CGAL::Sign>(CGAL::ZERO) : compare(m_candidates[j], m_candidates[i]);
      if (!comparison.is_certain())
        result = CGAL::Uncertain<bool>::indeterminate();
      else if (comparison.make_certain() * sign > 0)
        return false;
    }
    return result;
  }

private:
  Candidate candidate(const Sign_event& event) const
  {
    const auto& [lower, upper] = event.range;
    Candidate result{event.range, {}, true};
    if (lower == upper || event.is_family()) {
      const std::array<Exact_rational, 1> t{lower};
      result.heights.first = result.heights.second = Exact_rational(m_height(t) / m_weight(t));
      return result;
    }
    const Bspline_function<Exact_rational> h = m_height.restricted(0, lower, upper),
                                           w = m_weight.restricted(0, lower, upper);
    bool is_first = true;
    for (const auto& [a, b] : quotients(h, w)) {
      if (sign_of(b) == 0 || sign_of(b) != sign_of(w.coefficients()[0])) {
        result.has_heights = false;
        return result;
      }
      const Exact_rational quotient(a / b);
      result.heights.first = is_first ? quotient : (std::min)(result.heights.first, quotient);
      result.heights.second = is_first ? quotient : (std::max)(result.heights.second, quotient);
      is_first = false;
    }
    return result;
  }

  // Coefficients on common knots.
  static std::vector<std::pair<Exact_rational, Exact_rational>> quotients(const Bspline_function<Exact_rational>& h,
                                                                          const Bspline_function<Exact_rational>& w)
  {
    const Bspline_function<Exact_rational> zero = h * Exact_rational(0) + w * Exact_rational(0), a = h + zero,
                                           b = w + zero;
    std::vector<std::pair<Exact_rational, Exact_rational>> result;
    for (std::size_t i = 0; i < a.coefficients().size(); ++i)
      result.emplace_back(a.coefficients()[i], b.coefficients()[i]);
    return result;
  }

  CGAL::Uncertain<CGAL::Sign> compare(const Candidate& a, const Candidate& b) const
  {
    if (a.has_heights && b.has_heights) {
      if (a.heights.first > b.heights.second)
        return CGAL::POSITIVE;
      if (a.heights.second < b.heights.first)
        return CGAL::NEGATIVE;
    }
    if ((a.is_exact() && b.is_exact()) || (a.is_exact() && attains(b, a.heights.first)) ||
        (b.is_exact() && attains(a, b.heights.first)) ||
        (a.has_heights && b.has_heights && !a.is_exact() && !b.is_exact() && have_common_height(a, b)))
      return CGAL::ZERO;
    return CGAL::Uncertain<CGAL::Sign>::indeterminate();
  }

  // Whether the polynomials of the heights of two critical points have one zero each where both heights are, and it is
  // the same.
  bool have_common_height(const Candidate& a, const Candidate& b) const
  {
    const std::vector<Unknown> height = unknowns(
        {{Bound((std::min)(a.heights.first, b.heights.first)), Bound((std::max)(a.heights.second, b.heights.second))}});
    const std::array<Expression, 2> polynomials{height_polynomial(a, height[0]), height_polynomial(b, height[0])};
    if (polynomials[0].numerator().is_zero() || polynomials[1].numerator().is_zero())
      return false;
    return m_solve({polynomials[0] == 0}).size() == 1 && m_solve({polynomials[1] == 0}).size() == 1 &&
        m_solve({polynomials[0] == 0, polynomials[1] == 0}).size() == 1;
  }

  Expression height_polynomial(const Candidate& candidate, const Unknown& height) const
  {
    const auto piece = std::find_if(m_pieces.begin(), m_pieces.end(),
                                    [&](const auto& p) { return candidate.parameters.second <= p.end(); });
    const auto tensor = [&](const Bspline_function<Exact_rational>& function) {
      return function.restricted(0, piece->begin(), piece->end()).bezier_pieces().front();
    };
    return Expression(critical_value_polynomial(tensor(m_height), tensor(m_weight), height.numerator()), Monomial(),
                      height.symbols());
  }

  // Whether the critical point in a range has a given height: a system of two equations in one unknown, decided
  // exactly.
  bool attains(const Candidate& candidate, const Exact_rational& height) const
  {
    for (const Differentiated_map& piece : m_pieces) {
      const Exact_rational lower = (std::max)(candidate.parameters.first, piece.begin()),
                           upper = (std::min)(candidate.parameters.second, piece.end());
      if (!(lower < upper))
        continue;
      const std::vector<Unknown> u = unknowns({{Bound(lower), Bound(upper)}});
      const Vector_expression<2> direction{m_direction[0], m_direction[1]};
      if (!m_solve({dot(piece(1, u[0]), direction) == 0, dot(piece(0, u[0]), direction) == height}).empty())
        return true;
    }
    return false;
  }
};

// The ends of an open curve, that the formula need not be zero at, as the places where the derivative of the height
// changes its sign.
inline std::vector<Sign_event> events_with_ends(const Sign_sequence& signs, const Planar_map& curve)
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

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_CURVE_FEATURES_2_H
