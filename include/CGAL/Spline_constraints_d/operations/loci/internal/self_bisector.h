// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_SELF_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_SELF_BISECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_chart.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_locus_collector.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/center_of_tangent_circle.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

// Where both points are one and the same, the center of curvature there.
inline Double_pair center_of_tangent_or_osculating_circle(const Pair_of_points& pair)
{
  const Double_pair& tangent = pair.tangents[0];
  if (pair.chord != Double_pair{0, 0} || cross(tangent, pair.tangents[1]) != 0)
    return center_of_tangent_circle(pair);
  const double factor = dot(tangent, tangent) / cross(tangent, pair.second_derivative);
  return {pair.points[0][0] - factor * tangent[1], pair.points[0][1] + factor * tangent[0]};
}

// The places of a curve where its tangent turns continuously: all but some breaks and, unless it is closed, the ends.
class Smooth_places
{
  Exact_pair m_ends;
  bool m_is_closed;
  std::vector<Exact_rational> m_corners;

public:
  Smooth_places(const std::vector<Differentiated_map>& pieces, bool is_closed)
    : m_ends{pieces.front().begin(), pieces.back().end()}, m_is_closed(is_closed)
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (i + 1 < pieces.size() ? !have_common_tangent(pieces[i], pieces[i + 1])
                                : !is_closed || !have_common_tangent(pieces[i], pieces[0]))
        m_corners.push_back(pieces[i].end());
  }

  // What is left of the place of a solution if curves go on there: not on the diagonal. With u at the begin of a closed
  // curve it is in the order (v, end).
  std::optional<Joint_place> operator()(std::optional<Joint_place> place) const
  {
    if (!place || place->line[0] == place->line[1] ||
        (place->line[0][0] == place->line[0][1] && place->line[1][0] == place->line[1][1]))
      return std::nullopt;
    if (is_at(*place, 0, m_ends[0])) {
      for (Exact_pair& p : place->line)
        p = {p[1], m_ends[1]};
      place->ranges = {place->ranges[1], {m_ends[1], m_ends[1]}};
    }
    const auto is_on_corner = [&](const Exact_rational& corner) {
      return is_at(*place, 0, corner) || is_at(*place, 1, corner);
    };
    return std::any_of(m_corners.begin(), m_corners.end(), is_on_corner) ? std::nullopt : place;
  }

  // A pair of parameters on two pieces, the same for all parts that have the same solutions there.
  std::optional<Joint_corner> corner(const std::optional<Exact_pair>& pair, const Differentiated_map& first,
                                     const Differentiated_map& second) const
  {
    if (!pair)
      return std::nullopt;
    Joint_corner result{*pair, {(*pair)[0] == first.begin() ? 1 : -1, (*pair)[1] == second.begin() ? 1 : -1}};
    if (result.pair[0] == m_ends[0]) {
      result.pair = {result.pair[1], m_ends[1]};
      std::swap(result.sides[0], result.sides[1]);
    }
    for (const std::size_t k : {0, 1})
      if (std::find(m_corners.begin(), m_corners.end(), result.pair[k]) == m_corners.end())
        result.sides[k] = 0;
    return result;
  }

  // Whether it is the pair of both ends of a closed curve.
  bool is_seam(const std::optional<Exact_pair>& pair) const { return m_is_closed && pair == m_ends; }

private:
  static bool is_at(const Joint_place& place, std::size_t i, const Exact_rational& value)
  {
    return place.line[0][i] == value && place.line[1][i] == value;
  }
};

// Adds the curves of a chart.
inline void add_self_bisector(Pair_locus_collector& locus, const Differentiated_map& first,
                              const Differentiated_map& second, const Pair_chart& chart, const Smooth_places& smooth,
                              Budgeted_solver& solve)
{
  Pair_of_parts parts{
      first,
      second,
      [chart](const std::vector<double>& unknowns) { return chart.parameters(unknowns); },
      {},
      [chart, smooth](const Curve_vertex::Exact_box& box) { return smooth(chart.place(box)); },
      [=](const Curve_vertex::Exact_box& box) { return smooth.corner(chart.pair(box), first, second); },
      [=](const Curve_vertex::Exact_box& box) { return chart.is_on_diagonal(box) || smooth.is_seam(chart.pair(box)); },
      [chart](const Curve_vertex::Exact_box& box) { return chart.image(box); }};
  if (solve.must_stop()) {
    locus.add_undecided(parts, chart.unknowns(), solve.reason());
    return;
  }
  const auto [u, v] = parameters(first.map(), second.map());
  const Vector_expression<2> d = first(0, u) - second(0, v), a = first(1, u), b = second(1, v);
  // On the diagonal, the determinants divided by v - u and its square are C' x C'' and -1/2 of it. So the second
  // equation has one factor more than the second determinant, and inflections do not satisfy what is left of it.
  const std::vector<Constraint> at_infinity{chart(determinant(a, b)) == 0,
                                            chart(determinant(a, b) * (v - u) + 2 * determinant(a, d)) == 0};
  if (at_infinity[0].function.is_zero() && at_infinity[1].function.is_zero())
    return; // both parts lie on one line
  const Constraint equation = chart(dot(a, d) * determinant(b, d) + dot(b, d) * determinant(a, d)) == 0;
  std::vector<Solution_d<double>> poles;
  if (!equation.function.is_zero()) {
    const Solution_set_d<double> solutions = solve(at_infinity, chart.unknowns());
    locus.add_work(solutions.summary());
    poles.assign(solutions.begin(), solutions.end());
  }
  locus.add(parts, {equation}, chart.unknowns(), solve.budget(), poles);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_pair_locus self_bisector_of(const Exact_map<2>& c, const Solver_options& options)
{
  Pair_locus_collector result([](const Pair_of_points& pair,
                                 const std::vector<double>&) { return center_of_tangent_or_osculating_circle(pair); },
                              {0, 0});
  Budgeted_solver solve(options);
  const Planar_map curve = planar_map(c);
  const std::vector<Differentiated_map> pieces = polynomial_pieces(curve, 2);
  for (const Differentiated_map& piece : pieces)
    // where the derivative is zero, the equation is satisfied by all pairs with this point
    speed_range(piece, "self_bisector_curves");
  const bool is_closed = curve.is_closed();
  const Smooth_places smooth(pieces, is_closed);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    add_self_bisector(result, pieces[i], pieces[i], chart_of_piece(pieces[i]), smooth, solve);
    for (std::size_t j = i + 1; j < pieces.size(); ++j)
      for (const Pair_chart& chart :
           charts_of_pieces(pieces[i], pieces[j], j == i + 1, is_closed && i == 0 && j + 1 == pieces.size()))
        add_self_bisector(result, pieces[i], pieces[j], chart, smooth, solve);
  }
  result.join_parts();
  return result.found();
}

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_SELF_BISECTOR_H
