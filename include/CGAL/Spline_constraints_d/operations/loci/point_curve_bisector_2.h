// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_POINT_CURVE_BISECTOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_POINT_CURVE_BISECTOR_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

The bisector of a point and a planar curve: rational curves with exact coefficients.
*/
class Point_curve_bisector_2
{
public:
  //! the kernel of the curves.
  using Kernel = CGAL::Simple_cartesian<Exact_rational>;
  //! a range of the parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;

private:
  std::vector<Bspline_curve_2<Kernel>> m_curves;
  std::vector<Range> m_poles;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what `point_curve_bisector()` has found.
  Point_curve_bisector_2(std::vector<Bspline_curve_2<Kernel>> curves, std::vector<Range> poles,
                         std::vector<Undecided_part> undecided, const Summary& work)
    : m_curves(std::move(curves)), m_poles(std::move(poles)), m_undecided(std::move(undecided)), m_summary(work)
  {
    m_summary.is_complete = m_undecided.empty();
  }

  //! the curves, by increasing parameters, which are those of the given curve.
  const std::vector<Bspline_curve_2<Kernel>>& curves() const { return m_curves; }

  //! ranges of parameters that are proved to hold a pole, where the bisector goes to infinity and comes back from the
  //! other side, or a point of the curve that is the given point. Each one alone, unless it is a multiple one.
  const std::vector<Range>& poles() const { return m_poles; }

  //! whether nothing is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! ranges of parameters of the curve, which is operand 1, where nothing is proved; where they are in the plane is not
  //! told.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

namespace internal {
namespace Loci {

/*
The bisector of a point Q and the curve X / w, in terms of E = X - w Q:

  P = Q + E / (2 w) + E^ (w <E,E'> - w' |E|^2) / (2 w^2 (E x E')),

with E^ = E turned by 90 degrees: on the perpendicular bisector of both points, and on the normal of the curve.
*/
class Point_curve_bisector
{
  using Function = Bspline_function<Exact_rational>;
  using Curve = Bspline_curve_2<Point_curve_bisector_2::Kernel>;

  Exact_pair m_point;
  std::array<Function, 2> m_coordinates;
  Function m_weight;

public:
  Point_curve_bisector(const Exact_pair& point, const Exact_map<2>& c)
    : m_point(point), m_coordinates(c.numerators), m_weight(c.weight)
  {
    if (!c.is_rational)
      m_weight = Function({0}, {{m_coordinates[0].domain(0).first, m_coordinates[0].domain(0).second}}, {1});
  }

  template <ParametricCurve_2 C>
  Point_curve_bisector(const Exact_pair& point, const C& c) : Point_curve_bisector(point, exact_map<2>(c))
  {}

  // Those of all splines.
  std::vector<Exact_rational> breaks() const
  {
    return united(united(m_coordinates[0].breaks(0), m_coordinates[1].breaks(0)), m_weight.breaks(0));
  }

  // Between two parameters without a break or a pole between them.
  Curve operator()(const Exact_rational& begin, const Exact_rational& end) const;
};

Point_curve_bisector_2 point_curve_bisector_of(const Exact_pair& q, const Exact_map<2>& c, const Exact_rational& margin,
                                               const Solver_options& options);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Point_curve_bisector::Curve
Point_curve_bisector::operator()(const Exact_rational& begin, const Exact_rational& end) const
{
  const Function w = m_weight.restricted(0, begin, end);
  const auto difference = [&](std::size_t i) { return m_coordinates[i].restricted(0, begin, end) - w * m_point[i]; };
  const Function x = difference(0), y = difference(1), dx = x.derivative(0), dy = y.derivative(0);
  const Function turn = x * dy - y * dx, denominator = w * w * turn * Exact_rational(2);
  Function slope = w * (x * dx + y * dy);
  if (w.degree(0) > 0)
    slope = slope - w.derivative(0) * (x * x + y * y);
  return Curve::from_homogeneous_coordinates(
      {denominator * m_point[0] + w * turn * x - slope * y, denominator * m_point[1] + w * turn * y + slope * x},
      denominator);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Point_curve_bisector_2 point_curve_bisector_of(const Exact_pair& q,
                                                                              const Exact_map<2>& c,
                                                                              const Exact_rational& margin,
                                                                              const Solver_options& options)
{
  using Range = Point_curve_bisector_2::Range;
  const Point_curve_bisector bisector(q, c);
  Budgeted_solver solve(options);
  std::vector<Bspline_curve_2<Point_curve_bisector_2::Kernel>> curves;
  std::vector<Range> known_poles;
  std::vector<std::pair<Range, Undecided_reason>> undecided;
  const Planar_map curve = planar_map(c);
  const std::vector<Exact_rational> breaks = bisector.breaks();
  for (std::size_t b = 1; b < breaks.size(); ++b) {
    if (solve.must_stop()) {
      undecided.push_back({{breaks[b - 1], breaks.back()}, solve.reason()});
      break;
    }
    const Differentiated_map piece(curve.restricted(0, breaks[b - 1], breaks[b]), 1);
    const auto [u] = parameters(piece.map());
    const Constraint equation = determinant(piece(0, u) - Vector_expression<2>(q[0], q[1]), piece(1, u)) == 0;
    const Solution_set_d<double> poles = solve({equation}, {u});
    std::vector<Range> ranges;
    for (const Solution_d<double>& pole : poles) {
      ranges.push_back(pole.exact_box()[0]); // one at a break belongs to both pieces
      if (pole.kind() != Solution_kind::UNDECIDED) {
        if (known_poles.empty() || known_poles.back() != ranges.back())
          known_poles.push_back(ranges.back());
      } else if (undecided.empty() || undecided.back().first != ranges.back())
        undecided.emplace_back(ranges.back(), pole.reason());
    }
    std::sort(ranges.begin(), ranges.end());
    ranges.emplace_back(piece.end(), piece.end());
    Exact_rational begin = piece.begin();
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const Exact_rational left_out = margin * (ranges[i].first - begin);
      if (left_out > 0)
        curves.push_back(bisector(i > 0 ? Exact_rational(begin + left_out) : begin,
                                  i + 1 < ranges.size() ? Exact_rational(ranges[i].first - left_out) : piece.end()));
      begin = ranges[i].second;
    }
  }
  std::vector<Undecided_part> parts;
  for (const auto& [range, reason] : undecided)
    parts.push_back({{}, {{1, {double_range(range)}}}, in_words(reason)});
  return {std::move(curves), std::move(known_poles), std::move(parts), solve.total()};
}
#endif

} // namespace Loci
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDLoci

the bisector of a point \f$Q\f$ and a curve, untrimmed: the centers of all circles through the point that touch the
curve. It is a rational curve, of degree \f$3p-1\f$ for a polynomial one of degree \f$p\f$, and \f$4p-1\f$ for a
rational one,
\f[ P = C - \frac{|C-Q|^2}{2\,\langle C-Q, N\rangle}\, N, \f]
with the parameter and the normal \f$N\f$ of the curve. It has poles where the tangent goes through the point; these are
the zeros of the denominator, which are solved for and certified. Between them, and between the breaks of the curve, its
coefficients are computed exactly.

A curve of the answer has to end before a pole: it leaves out a share of the parameters between the two poles or breaks.
A segment on a line through the point, for which all points are poles, has no curve. Where the curve passes through the
point, the center of curvature is the limit; this is treated as a pole.

\tparam C a model of `ParametricCurve_2`.
\param point the point.
\param c the curve.
\param margin the share that is left out at each pole; between 0 and 1/2.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when the margin is not inside of (0, 1/2), or an option makes no sense.

Complexity: one system in one unknown for each polynomial piece, and products of splines of one parameter. Source:
\cgalCite{ek-crb-99}.
*/
template <ParametricCurve_2 C>
Point_curve_bisector_2 point_curve_bisector(const typename C::Kernel::Point_2& point, const C& c,
                                            double margin = 0x1p-10, const Solver_options& options = {})
{
  if (!(0 < margin && margin < 0.5))
    throw Invalid_input("point_curve_bisector: the margin is not between 0 and 1/2");
  const internal::Exact_pair q{internal::converted_number<Exact_rational>(point.x()),
                               internal::converted_number<Exact_rational>(point.y())};
  return internal::Loci::point_curve_bisector_of(q, internal::Common::exact_map<2>(c), Exact_rational(margin), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_POINT_CURVE_BISECTOR_2_H
