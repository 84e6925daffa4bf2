// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_LOCI_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_LOCI_H

#include <CGAL/Spline_constraints_d/geometry/internal/tangent_direction.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_locus_collector.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/center_of_tangent_circle.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

// The point P = C1 + t N1 = C2 + ratio t N2 with normals of different lengths |N1| and |ratio N2|: one solution t by
// least squares even where they are parallel.
inline Double_pair point_of_alpha_sector(double ratio, const Pair_of_points& pair)
{
  const Double_pair &a = pair.tangents[0], &b = pair.tangents[1], difference{ratio * b[1] - a[1], a[0] - ratio * b[0]};
  const double t = -dot(pair.chord, difference) / dot(difference, difference);
  return {pair.points[0][0] - t * a[1], pair.points[0][1] + t * a[0]};
}

// Adds what an equation has on two parts, unless the run ends here: then it is undecided.
template <class Add>
void add_within(Operation_budget& budget, Pair_locus_collector& locus, const Pair_of_parts& parts,
                const std::vector<Unknown>& unknowns, const Add& add)
{
  if (budget.must_stop())
    locus.add_undecided(parts, unknowns, budget.reason());
  else
    add();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_pair_locus bisector_of(const Exact_map<2>& first, const Exact_map<2>& second,
                                                            const Solver_options& options)
{
  Pair_locus_collector result(
      [](const Pair_of_points& pair, const std::vector<double>&) { return center_of_tangent_circle(pair); });
  Budgeted_solver solve(options);
  visit_pairs_of_parts(
      parts_with_tangents(planar_map(first)), parts_with_tangents(planar_map(second)),
      [&](const Pair_of_parts& parts, const Unknown& u, const Unknown& v) {
        add_within(solve.budget(), result, parts, {u, v}, [&] {
          const Vector_expression<2> d = parts.first(0, u) - parts.second(0, v), a = parts.first(1, u),
                                     b = parts.second(1, v);
          const Solution_set_d<double> at_infinity = solve({determinant(a, b) == 0, determinant(a, d) == 0}, {u, v});
          result.add_work(at_infinity.summary());
          result.add(parts, {dot(a, d) * determinant(b, d) + dot(b, d) * determinant(a, d) == 0}, {u, v},
                     solve.budget(), {at_infinity.begin(), at_infinity.end()});
        });
      });
  return result.found();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_pair_locus alpha_sector_of(const Exact_map<2>& first, const Exact_map<2>& second,
                                                                const Exact_rational& share,
                                                                const Solver_options& options)
{
  const Exact_rational rest(1 - share);
  if (share == rest)
    return bisector_of(first, second, options);
  Operation_budget budget(options);
  const double factor = to_nearest_double(Exact_rational(rest / share));
  Pair_locus_collector result([factor](const Pair_of_points& pair, const std::vector<double>& unknowns) {
    return point_of_alpha_sector(factor * unknowns[2], pair);
  });
  visit_pairs_of_smooth_parts(
      planar_map(first), planar_map(second), [&](Pair_of_parts parts, const Unknown&, const Unknown&) {
        std::erase_if(parts.closed_unknowns, [&](std::size_t k) {
          return !has_same_derivative(k == 0 ? parts.first : parts.second, k == 0 ? parts.first : parts.second);
        });
        const Exact_rational bound =
            2 * speed_range(parts.first, "alpha_sectors").second / speed_range(parts.second, "alpha_sectors").first;
        const std::vector<Unknown> unknowns =
            unknowns_in({parts.first.map().domain(0), parts.second.map().domain(0), {Exact_rational(-bound), bound}});
        add_within(budget, result, parts, unknowns, [&] {
          const Unknown &u = unknowns[0], &v = unknowns[1], &q = unknowns[2];
          const Vector_expression<2> d = parts.first(0, u) - parts.second(0, v), a = parts.first(1, u),
                                     b = parts.second(1, v);
          result.add(parts, {rest * q * dot(d, b) == share * dot(d, a), q * q * squared_norm(b) == squared_norm(a)},
                     unknowns, budget);
        });
      });
  return result.found();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_pair_locus envelope_of(const Exact_map<2>& first, const Exact_map<2>& second,
                                                            bool is_same_direction, const Solver_options& options)
{
  Operation_budget budget(options);
  Pair_locus_collector result([](const Pair_of_points& pair, const std::vector<double>&) {
    const auto& [p, q] = pair.points;
    return Double_pair{p[0] + q[0], p[1] + q[1]};
  });
  visit_pairs_of_smooth_parts(planar_map(first), planar_map(second),
                              [&](const Pair_of_parts& parts, const Unknown& u, const Unknown& v) {
                                add_within(budget, result, parts, {u, v}, [&] {
                                  const Vector_expression<2> a = parts.first(1, u), b = parts.second(1, v);
                                  std::vector<Constraint> constraints{determinant(a, b) == 0};
                                  if (is_same_direction)
                                    constraints.push_back(dot(a, b) > 0);
                                  result.add(parts, constraints, {u, v}, budget);
                                });
                              });
  return result.found();
}

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_LOCI_H
