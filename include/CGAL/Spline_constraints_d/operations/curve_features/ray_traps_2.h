// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_RAY_TRAPS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_RAY_TRAPS_2_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

A closed path of a ray that is reflected once by each of some curves, one after the other.
*/
template <SplineKernel Kernel>
class Ray_trap_2
{
  std::vector<typename Kernel::Point_2> m_points;
  Solution_d<double> m_solution;

public:
  //! a path with these points of reflection.
  Ray_trap_2(std::vector<typename Kernel::Point_2> points, Solution_d<double> solution)
    : m_points(std::move(points)), m_solution(std::move(solution))
  {}

  //! the points of reflection: of each curve the one in the middle of the range of its parameter.
  const std::vector<typename Kernel::Point_2>& points() const { return m_points; }

  //! the answer of the solver, with its proof: the unknowns are the parameters on the curves, in their order. Nothing
  //! is proved about an `UNDECIDED` one.
  const Solution_d<double>& solution() const { return m_solution; }
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

The ray-traps of some curves.
*/
template <SplineKernel Kernel>
class Ray_traps_2 : public Answer_list<Ray_trap_2<Kernel>>
{
public:
  using Answer_list<Ray_trap_2<Kernel>>::Answer_list;

  //! what was found: certified ones, clusters, families (a `CONTINUUM`, of which the middle of the cover is given), and
  //! what is undecided.
  const std::vector<Ray_trap_2<Kernel>>& traps() const { return this->answers(); }
};

namespace internal {
namespace Curve_features {

// The conditions for the ray that comes from `before` to be reflected towards `after` at the point of a curve, seed
// 000, equation 6: equal angles with the tangent T and the normal N, which
// <in,T>/|in| = -<out,T>/|out| says, squared. The normal components have the same sign; they have opposite ones where
// the ray goes straight on. Where the ray comes back to where it came from, it goes along the normal.
std::vector<Constraint> reflection(const Vector_expression<2>& point, const Vector_expression<2>& tangent,
                                   const Vector_expression<2>& before, const Vector_expression<2>& after, bool returns);

// A part of a curve that has tangents, without those of its ends that are corners, or that count as the begin of the
// next part.
struct Mirror
{
  Differentiated_map curve;
  bool has_begin, has_end;
};

std::vector<Mirror> mirrors(const Planar_map& curve);

// The reflection at one mirror of each curve.
std::vector<Constraint> ray_trap_constraints(const std::vector<const Mirror*>& mirrors);

// What is undecided of the paths with parameters in a box.
Undecided_part undecided_trap(const std::vector<Planar_map>& curves, const std::vector<Exact_range>& box,
                              Undecided_reason reason);

template <SplineKernel Kernel>
Ray_trap_2<Kernel> ray_trap(const std::vector<Spline_map<1, 2>>& curves, const Solution_d<double>& solution)
{
  const auto box = solution.exact_box();
  std::vector<typename Kernel::Point_2> points;
  for (std::size_t i = 0; i < curves.size(); ++i)
    points.push_back(Point_on_spline<Kernel, 1, 2>(curves[i], {box[i]}).point());
  return {std::move(points), solution};
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Constraint> reflection(const Vector_expression<2>& point,
                                                                  const Vector_expression<2>& tangent,
                                                                  const Vector_expression<2>& before,
                                                                  const Vector_expression<2>& after, bool returns)
{
  const Vector_expression<2> in = before - point, out = after - point, normal = perpendicular(tangent);
  if (returns)
    return {dot(in, tangent) == 0, squared_norm(in) != 0};
  return {square(dot(in, normal)) * squared_norm(out) == square(dot(out, normal)) * squared_norm(in),
          dot(in, normal) * dot(out, normal) > 0};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Mirror> mirrors(const Planar_map& curve)
{
  const std::vector<Smooth_part> parts = smooth_parts(curve);
  const bool is_closed = curve.is_closed();
  std::vector<Mirror> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_begin = i == 0 && !is_closed, is_end = i + 1 == parts.size() && !is_closed;
    const Smooth_part& previous = i == 0 ? parts.back() : parts[i - 1];
    result.push_back({parts[i].curve, is_begin || !previous.has_end, is_end});
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Constraint> ray_trap_constraints(const std::vector<const Mirror*>& mirrors)
{
  const std::size_t n = mirrors.size();
  std::vector<std::array<Bound, 2>> ranges;
  for (const Mirror* mirror : mirrors)
    ranges.push_back({Bound(mirror->curve.begin()), Bound(mirror->curve.end())});
  const std::vector<Unknown> u = unknowns(ranges);
  std::vector<Vector_expression<2>> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(mirrors[i]->curve(0, u[i]));

  std::vector<Constraint> result;
  for (std::size_t i = 0; i < n; ++i) {
    for (Constraint& constraint :
         reflection(points[i], mirrors[i]->curve(1, u[i]), points[(i + n - 1) % n], points[(i + 1) % n], n == 2))
      result.push_back(std::move(constraint));
    if (!mirrors[i]->has_begin)
      result.push_back(u[i] > mirrors[i]->curve.begin());
    if (!mirrors[i]->has_end)
      result.push_back(u[i] < mirrors[i]->curve.end());
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Undecided_part undecided_trap(const std::vector<Planar_map>& curves,
                                                             const std::vector<Exact_range>& box,
                                                             Undecided_reason reason)
{
  std::vector<Curve_range> parts;
  for (std::size_t i = 0; i < curves.size(); ++i)
    parts.push_back({curves[i], i, box[i]});
  return undecided_on_curves(parts, in_words(reason));
}
#endif

} // namespace Curve_features
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

all ray-traps of length \f$n \ge 2\f$: points \f$P_i = C_i(u_i)\f$, one on each curve, such that a ray from
\f$P_{i-1}\f$ to \f$P_i\f$ is reflected there towards \f$P_{i+1}\f$, and after the last one towards the first. Curves do
not stop rays: those that meet other points of the curves on their way count.

These are \f$n\f$ equations in \f$n\f$ unknowns. Since the law of reflection is squared, they are also satisfied where
the ray goes straight on; there an inequality is violated, which the solver proves. Rays that graze a curve are no
traps. Traps of two curves are their common normals. A trap at the seam of a closed curve is reported with the first
parameter of the seam.

At a corner there is no law of reflection, so what passes through one is no trap: curves are taken apart there, into
parts without that point. A path that would be reflected there according to one of the tangents is excluded by proof, or
is `UNDECIDED`. The ends of a curve that is not closed belong to it.

\tparam Curves a range of curves that are models of `ParametricCurve_2`.
\param curves the curves, in the order in which they reflect.
\param options those of the solver; limits hold for the operation as a whole.
\return a `Ray_traps_2` with the kernel of the curves.
\throws Invalid_input for fewer than two curves; when an option makes no sense.

Complexity: that of a system of \f$n\f$ equations for each choice of one smooth part of each curve.

Source: \cgalCite{ek-gcs-01}, section 3.1.
*/
template <std::ranges::input_range Curves>
requires ParametricCurve_2<std::ranges::range_value_t<Curves>>
auto ray_traps(Curves&& curves, const Solver_options& options = {})
{
  using namespace internal::Curve_features;
  using Kernel = typename std::ranges::range_value_t<Curves>::Kernel;
  std::vector<internal::Planar_map> maps;
  for (const auto& curve : curves)
    maps.emplace_back(curve);
  if (maps.size() < 2)
    throw Invalid_input("ray_traps: " + std::to_string(maps.size()) + " curves, at least 2 are needed");
  std::vector<std::vector<Mirror>> all_mirrors;
  std::vector<int> last;
  for (const internal::Planar_map& map : maps) {
    all_mirrors.push_back(mirrors(map));
    last.push_back(static_cast<int>(all_mirrors.back().size()) - 1);
  }
  internal::Common::Budgeted_solver solve(options);
  std::vector<Ray_trap_2<Kernel>> traps;
  std::vector<Undecided_part> undecided;
  internal::for_each_index(last, [&](const std::vector<int>& choice) {
    if (solve.must_stop())
      return;
    std::vector<const Mirror*> chosen;
    for (std::size_t i = 0; i < choice.size(); ++i)
      chosen.push_back(&all_mirrors[i][choice[i]]);
    for (const Solution_d<double>& solution : solve(ray_trap_constraints(chosen))) {
      traps.push_back(ray_trap<Kernel>(maps, solution));
      if (solution.kind() == Solution_kind::UNDECIDED)
        undecided.push_back(undecided_trap(maps, solution.exact_box(), solution.reason()));
    }
  });
  if (solve.reason() != Undecided_reason::NONE) { // one part stands for all mirrors that were not looked at
    std::vector<internal::Exact_range> domains;
    for (const internal::Planar_map& map : maps)
      domains.push_back(map.domain(0));
    undecided.push_back(undecided_trap(maps, domains, solve.reason()));
  }
  return Ray_traps_2<Kernel>(std::move(traps), std::move(undecided), solve.total());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_RAY_TRAPS_2_H
