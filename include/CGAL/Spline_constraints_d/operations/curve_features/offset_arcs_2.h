// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_OFFSET_ARCS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_OFFSET_ARCS_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_features_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Locus_intersection.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

A point of an offset.
*/
struct Offset_sample_2
{
  std::array<double, 2> point;   ///< the point, rounded
  double parameter;              ///< that of the curve
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

A part of an offset without cusps, corners and gaps inside.
*/
struct Offset_arc_2
{
  std::vector<Offset_sample_2> samples;   ///< points along it, the ends included
  std::array<bool, 2> is_at_cusp;         ///< whether the first and the last point are cusps
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

An offset as polylines.
*/
class Offset_arcs_2
{
  std::vector<Offset_arc_2> m_arcs;
  Locus_intersections<2> m_cusps;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what `offset_arcs()` has found; `undecided` are parts of the curve without arcs.
  Offset_arcs_2(std::vector<Offset_arc_2> arcs, Locus_intersections<2> cusps, std::vector<Undecided_part> undecided);

  //! the arcs, by increasing parameters.
  const std::vector<Offset_arc_2>& arcs() const { return m_arcs; }

  //! the cusps, certified, as `cusps()` finds them.
  const Locus_intersections<2>& cusps() const { return m_cusps; }

  //! whether these are all arcs and cusps.
  bool is_complete() const { return m_summary.is_complete; }

  //! the parts of the curve whose offsets are not there, or for which it is undecided whether there is a cusp.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

an offset, untrimmed, as polylines with so many points that it passes the middles of their chords at no more than a
given distance; that on the other side of the curve is the offset with the negative distance.

The offset is cut at its cusps, which are certified, and where the derivative of the curve jumps: at corners it has
gaps. All breaks of the curve are among the points. A zero of \f$1 - r\kappa\f$ without a change of sign is no cusp.

\param offset the offset.
\param error the distance; positive.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when the error is not positive, or an option makes no sense.

Complexity: that of `cusps()`, and one exact evaluation of the curve and its derivative per point.
*/
Offset_arcs_2 offset_arcs(const Offset_curve_2& offset, double error, const Solver_options& options = {});

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Offset_arcs_2::Offset_arcs_2(std::vector<Offset_arc_2> arcs,
                                                            Locus_intersections<2> cusps,
                                                            std::vector<Undecided_part> undecided)
  : m_arcs(std::move(arcs)), m_cusps(std::move(cusps)), m_undecided(std::move(undecided)), m_summary(m_cusps.summary())
{
  for (Undecided_part& cusp : m_cusps.undecided())
    m_undecided.push_back(std::move(cusp));
  m_summary.is_complete = m_undecided.empty();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Offset_arcs_2 offset_arcs(const Offset_curve_2& offset, double error,
                                                         const Solver_options& options)
{
  using namespace internal;
  using namespace internal::Curve_features;
  internal::check_error(error, "offset_arcs");
  Operation_budget budget(options);
  Locus_intersections<2> all_cusps = cusps(offset, budget.remaining());
  std::vector<Offset_arc_2> arcs;
  std::vector<Undecided_part> undecided;
  const auto is_cusp_at = [&](const Exact_rational& t) {
    return std::any_of(all_cusps.begin(), all_cusps.end(), [&](const auto& cusp) {
      return cusp.kind() != Intersection_kind::OVERLAP && cusp.multiplicity() % 2 == 1 &&
          cusp.parameter_range(0).first <= t && t <= cusp.parameter_range(0).second;
    });
  };
  for (const Smooth_part& part : smooth_parts(offset.curve())) {
    if (budget.must_stop()) {
      undecided.push_back(undecided_on_curves(
          {{offset.curve(), 0, {part.curve.begin(), offset.curve().domain(0).second}}}, in_words(budget.reason())));
      undecided.back().place.clear(); // that is where the curve is, not its offset
      break;
    }
    std::vector<Exact_rational> stops = part.curve.map().breaks(0);
    for (const auto& cusp : all_cusps)
      if (const Exact_rational t(cusp.parameter(0)); part.curve.begin() < t && t < part.curve.end())
        stops.push_back(t);
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    const auto between = [&](const Offset_sample_2& from, const Offset_sample_2& to) {
      const double t = from.parameter / 2 + to.parameter / 2;
      return Offset_sample_2{offset_point(part.curve, offset.distance(), Exact_rational(t)), t};
    };
    const auto is_chord = [&](const Offset_sample_2& from, const Offset_sample_2& middle, const Offset_sample_2& to) {
      return distance_from_middle(from.point, middle.point, to.point) <= error;
    };
    const auto sample_at = [&](const Exact_rational& t) {
      return Offset_sample_2{offset_point(part.curve, offset.distance(), t), to_nearest_double(t)};
    };
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const bool begins_at_cusp = is_cusp_at(stops[i]);
      if (i == 0 || begins_at_cusp)
        arcs.push_back({{sample_at(stops[i])}, {begins_at_cusp, false}});
      Offset_arc_2& arc = arcs.back();
      append_samples(arc.samples, sample_at(stops[i + 1]), between, is_chord, {2, 20});
      arc.is_at_cusp[1] = is_cusp_at(stops[i + 1]);
    }
  }
  return {std::move(arcs), std::move(all_cusps), std::move(undecided)};
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_OFFSET_ARCS_2_H
