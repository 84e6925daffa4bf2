// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_HAUSDORFF_DISTANCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_HAUSDORFF_DISTANCE_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Curve_tree.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

The Hausdorff distance of two curves, or a one-sided one, within certain bounds; and a point that is as far from the
other curve as these say.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Hausdorff_distance
{
public:
  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  Range m_squared_distance;
  std::size_t m_curve;
  std::array<Exact_rational, 2> m_parameters;
  std::array<Point, 2> m_points;

public:
#ifndef DOXYGEN_RUNNING
  Hausdorff_distance(Range squared_distance, std::size_t curve, const std::array<Exact_rational, 2>& parameters,
                     const std::array<Point, 2>& points)
    : m_squared_distance(std::move(squared_distance)), m_curve(curve), m_parameters(parameters), m_points(points)
  {}
#endif

  //! the square of the distance lies between these numbers.
  const Range& squared_distance_range() const { return m_squared_distance; }

  //! the distance lies between these doubles.
  std::pair<double, double> distance_range() const { return internal::Distances::root_range(m_squared_distance); }

  //! the curve that has the far point, 0 or 1.
  std::size_t curve() const { return m_curve; }

  //! the parameter on the first (0) or second (1) curve: on `curve()`, of a point whose distance from the other curve
  //! lies in the range as well, by proof; on the other one, of a point near the one that is nearest to it.
  const Exact_rational& parameter(std::size_t curve) const { return m_parameters[curve]; }

  //! the point with this parameter.
  const Point& point(std::size_t curve) const { return m_points[curve]; }
};

namespace internal {
namespace Distances {

// Curves in the same space.
template <class A, class B>
concept Curves_of_one_space = (ParametricCurve_2<A> && ParametricCurve_2<B>) ||
    (ParametricCurve_3<A> && ParametricCurve_3<B>);

template <class Curve>
using Hausdorff_distance_of = Hausdorff_distance<typename Curve::Kernel, ParametricCurve_2<Curve> ? 2 : 3>;

/*
max_u min_v |A(u) - B(v)|^2, by branch and bound. At the middle of a range of u, the least distance from B is bounded
from below: so is the maximum. On the range, it is bounded from above by the distances from points of B that move with
u.
*/
template <int d>
class Farthest_point_search
{
  struct Task
  {
    const Curve_tree<d>* node;
    double upper;
  };

  const Curve_tree<d> &m_from, &m_to;
  const double m_tolerance;

public:
  struct Result
  {
    double lower, upper;   // of the squared distance
    std::array<const Curve_tree<d>*, 2> nodes;   // with the points in their middles
  };

  Farthest_point_search(const Curve_tree<d>& from, const Curve_tree<d>& to, double tolerance)
    : m_from(from), m_to(to), m_tolerance(tolerance)
  {}

  // Makes bounds of a known distance those of the larger one of that and this.
  void include_in(Result& best) const
  {
    const auto is_nearer = [](const Task& p, const Task& q) { return p.upper < q.upper; };
    std::vector<Task> tasks;
    const auto push = [&](const Curve_tree<d>& node, double upper) {
      const Nearest_point<d> nearest = nearest_point<d>(m_to, node.middle_point(), m_tolerance / 4);
      if (nearest.lower > best.lower) {
        best.lower = nearest.lower;
        best.nodes = {&node, nearest.node};
      }
      tasks.push_back({&node, (std::min)(upper, upper_bound(node, *nearest.node))});
      std::push_heap(tasks.begin(), tasks.end(), is_nearer);
    };
    push(m_from, std::numeric_limits<double>::infinity());
    while (!roots_are_within(best.lower, tasks.front().upper, m_tolerance) && !tasks.front().node->is_tiny()) {
      std::pop_heap(tasks.begin(), tasks.end(), is_nearer);
      const Task task = tasks.back();
      tasks.pop_back();
      for (const Curve_tree<d>& child : task.node->children())
        push(child, task.upper);
    }
    best.upper = (std::max)({best.upper, best.lower, tasks.front().upper});
  }

private:
  // Of the distances of a range of A from B: from the point of B in the middle of a part, and from points B(v + s(u -
  // m)) that follow A(u).
  double upper_bound(const Curve_tree<d>& from, const Curve_tree<d>& nearest) const
  {
    const double from_point = from.squared_distance_bounds(nearest.middle_point()).sup(),
                 speed = nearest.speed_along(from);
    const Exact_rational reach(to_rational(from.radius()) * to_rational(std::abs(speed)));
    const Parameter_range range(Exact_rational(nearest.middle() - reach), Exact_rational(nearest.middle() + reach));
    const auto [first, last] = m_to.patch().domain(0);
    if (reach == 0 || range.first < first || last < range.second)
      return from_point;
    return (std::min)(from_point,
                      moving_distance_bound(from, nearest.middle_point(), m_to.tangents_over(range), speed));
  }

  // By the mean value theorem, D = A - B lies in D(m) + (A' - s B') (u - m), and the derivative of |D|^2 in 2 <D, A' -
  // s B'>.
  static double moving_distance_bound(const Curve_tree<d>& a, const Double_intervals<d>& b_middle,
                                      const Double_intervals<d>& b_tangents, double speed)
  {
    const Double_intervals<d> slope = moved_along(a.tangents(), -speed, b_tangents),
                              at_middle = a.middle_point() - b_middle,
                              offset = moved_along(at_middle, a.steps(), slope);
    return (std::min)(squared_norm(offset).sup(),
                      (squared_norm(at_middle) + 2.0 * dot(offset, slope) * a.steps()).sup());
  }
};

template <class C1, class C2>
Hausdorff_distance_of<C1> hausdorff_distance(const C1& c1, const C2& c2, double tolerance, bool is_one_sided)
{
  constexpr int d = ParametricCurve_2<C1> ? 2 : 3;
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw Invalid_input("hausdorff_distance: the tolerance must be positive and finite");
  using Point = typename Hausdorff_distance_of<C1>::Point;
  const std::array<Curve_tree<d>, 2> curves{Curve_tree<d>(Spline_patch<d>(c1)), Curve_tree<d>(Spline_patch<d>(c2))};
  typename Farthest_point_search<d>::Result result{-1, 0, {}};   // any distance is larger
  std::size_t curve = 0;
  {
    [[maybe_unused]] const Upward_rounding_guard guard;
    Farthest_point_search<d>(curves[0], curves[1], tolerance).include_in(result);
    if (!is_one_sided) {
      const double known = result.lower;
      Farthest_point_search<d>(curves[1], curves[0], tolerance).include_in(result);
      curve = result.lower > known ? 1 : 0;
    }
  }
  if (curve == 1)
    std::swap(result.nodes[0], result.nodes[1]);
  const auto parameter = [&](std::size_t i) { return result.nodes[i]->middle(); };
  const auto point = [&](std::size_t i) {
    return kernel_object<typename C1::Kernel, Point>(curves[i].patch()(std::array{parameter(i)}));
  };
  return {{to_rational(result.lower), to_rational(result.upper)},
          curve,
          {parameter(0), parameter(1)},
          {point(0), point(1)}};
}

} // namespace Distances
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDDistances

the Hausdorff distance of two curves in the plane or in space, the largest distance of a point of one of them from the
other one: \f$\max(h(C_1,C_2), h(C_2,C_1))\f$ with
\f$h(A,B) = \max_u \min_v |A(u) - B(v)|\f$. The bounds are certified, and their difference is at most the tolerance,
unless that is so small (about \f$10^{-12}\f$ times the size of the curves) that the rounding of doubles shows. Curves
may have corners.

Ranges of the curve's parameter are bisected, those with the largest upper bounds first. For the middle \f$m\f$ of one,
the least distance from \f$B\f$ is bounded from below, by another branch and bound. With a point \f$B(v)\f$ next to
\f$A(m)\f$, the distances of the whole range are bounded from above by those of \f$A(u)\f$ from \f$B(v)\f$ and from
\f$B(v + s(u-m))\f$, where \f$s\f$ makes the point follow \f$A(u)\f$. Their error is of second order in the length of
the range where \f$h\f$ is attained on smooth pieces, so that few ranges are left at every length, and where the curves
are parallel.

\tparam C1,C2 models of `ParametricCurve_2`, or of `ParametricCurve_3`; points of the result are those of the kernel of
`C1`.
\param c1 the first curve.
\param c2 the second curve.
\param tolerance the largest difference of the bounds that is good enough.
\throws Invalid_input when the tolerance is not positive and finite, or the weight of a curve is not proved to have one
sign.
*/
template <class C1, class C2>
  requires internal::Distances::Curves_of_one_space<C1, C2>
auto hausdorff_distance(const C1& c1, const C2& c2, double tolerance = 1e-6)
{
  return internal::Distances::hausdorff_distance(c1, c2, tolerance, false);
}

/*!
\ingroup PkgSplineConstraintsDDistances

the largest distance of a point of the first curve from the second curve, \f$h(C_1,C_2)\f$; otherwise as
`hausdorff_distance()`.
*/
template <class C1, class C2>
  requires internal::Distances::Curves_of_one_space<C1, C2>
auto one_sided_hausdorff_distance(const C1& c1, const C2& c2, double tolerance = 1e-6)
{
  return internal::Distances::hausdorff_distance(c1, c2, tolerance, true);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_HAUSDORFF_DISTANCE_H
