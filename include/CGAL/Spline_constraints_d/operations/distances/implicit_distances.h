// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_IMPLICIT_DISTANCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_IMPLICIT_DISTANCES_H

#include <CGAL/Spline_constraints_d/geometry/Implicit_hypersurface.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_implicit_feet.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/distances/internal/Implicit_foot_finder.h>
#endif

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

The points of an implicit curve or surface at which its distance to a point is critical.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Implicit_feet
{
public:
  //! a closed range of exact numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

  //! one of the points.
  struct Foot
  {
    Point point;                        ///< the point, up to rounding
    std::array<Range, d> box;           ///< ranges of its coordinates, by proof
    std::pair<double, double> distance; ///< a range of its distance
    Solution_kind kind;                 ///< certified, a cluster, or a continuum of points
    bool is_inside;                     ///< whether it is not only critical on a face of the box
  };

private:
  std::vector<Foot> m_feet;
  std::optional<Range> m_squared_distance;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what `implicit_feet()` has found, with points of the kernel.
  explicit Implicit_feet(internal::Distances::Found_implicit_feet found)
    : m_undecided(std::move(found.undecided)), m_summary(found.summary)
  {
    for (const auto& foot : found.feet) {
      std::array<double, d> middle;
      std::array<Range, d> box;
      for (std::size_t i = 0; i < d; ++i) {
        box[i] = foot.box[i];
        middle[i] = to_nearest_double(Exact_rational((box[i].first + box[i].second) / 2));
      }
      const Range square(foot.squared_distance.lower, foot.squared_distance.upper);
      m_feet.push_back({internal::kernel_object<Kernel, Point>(middle), box, internal::Distances::root_range(square),
                        foot.kind, foot.is_inside});
      m_squared_distance = m_squared_distance ? Range((std::min)(m_squared_distance->first, square.first),
                                                      (std::min)(m_squared_distance->second, square.second))
                                              : square;
    }
    for (const auto& distance : found.undecided_distances)
      if (m_squared_distance && distance.lower < m_squared_distance->first)
        m_squared_distance->first = distance.lower;
  }

  //! the points, the nearest ones first: feet of perpendiculars, singular points, and those that are critical on a face
  //! or an edge of the box only, where the curve or surface ends.
  const std::vector<Foot>& feet() const { return m_feet; }

  //! a range of the squared distance to the nearest point; nothing if no point is proved to be in the box.
  const std::optional<Range>& squared_distance_range() const { return m_squared_distance; }

  //! two doubles between which the distance lies.
  std::optional<std::pair<double, double>> distance_range() const
  {
    return m_squared_distance ? std::optional(internal::Distances::root_range(*m_squared_distance)) : std::nullopt;
  }

  //! where nothing is proved: boxes in the space of the curve or surface.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! whether these are all of them, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

/*!
\ingroup PkgSplineConstraintsDDistances

all points of an implicit curve or surface at which the distance to a point is critical, and with these the distance.

The offset from the point \f$p\f$ to a foot \f$x\f$ is parallel to the gradient: in the plane, \f$f = (x-p) \times
\nabla f = 0\f$; in space \f$x - p = \lambda \nabla f\f$ or \f$\mu\,(x - p) = \nabla f\f$, with factors from -1 to 1, so
that singular points of the surface are solutions, too. The same is solved on the faces and edges of its box.

Where all points of a curve are as near, as those of a circle are to its center, they are one answer, a continuum; the
distance then has the range of the boxes around it.

\param point a point of CGAL, with \f$d\f$ coordinates.
\param locus the curve or surface, within its box.
\param options those of the solver; limits hold for all systems together.
\throws Invalid_input when a coordinate is not finite, or an option makes no sense.

Complexity: two equations in two unknowns, or twice four in four; and those of the faces. Source:
\cgalCite{pm-sicad-02}.
*/
template <class Point, int d>
requires(Point::Ambient_dimension::value ==
         d) Implicit_feet<typename Point::R, d> implicit_feet(const Point& point, const Implicit_hypersurface<d>& locus,
                                                              const Solver_options& options = {})
{
  const auto exact = internal::exact_object(point);
  std::vector<Exact_rational> p;
  for (int i = 0; i < d; ++i)
    p.push_back(exact[i]);
  return Implicit_feet<typename Point::R, d>(internal::Distances::implicit_feet_of(
      {locus.polynomial()}, {locus.box().begin(), locus.box().end()}, p, options));
}

/*!
\ingroup PkgSplineConstraintsDDistances

the same for the curve in which two implicit surfaces meet: \f$f = g = \det(x - p, \nabla f, \nabla g) = 0\f$ within
both boxes, and its ends on their faces. Singular points of the curve, where the gradients are parallel, are answers,
too; a curve along which the surfaces touch is undecided.

\param point a point of CGAL in space.
\param first,second the surfaces. Where their boxes do not meet, nothing is found.
\param options those of the solver; limits hold for all systems together.
\throws Invalid_input as for one of them.

Complexity: three equations in three unknowns; and those of the faces. Source: \cgalCite{pm-sicad-02}.
*/
template <class Point>
requires(Point::Ambient_dimension::value ==
         3) Implicit_feet<typename Point::R, 3> implicit_feet(const Point& point, const Implicit_hypersurface<3>& first,
                                                              const Implicit_hypersurface<3>& second,
                                                              const Solver_options& options = {})
{
  const auto exact = internal::exact_object(point);
  std::vector<Exact_rational> p;
  std::vector<std::pair<Exact_rational, Exact_rational>> box;
  bool is_void = false;
  for (int i = 0; i < 3; ++i) {
    p.push_back(exact[i]);
    box.emplace_back((std::max)(first.box()[i].first, second.box()[i].first),
                     (std::min)(first.box()[i].second, second.box()[i].second));
    is_void = is_void || box.back().second < box.back().first;
  }
  options.check();
  if (is_void)
    return Implicit_feet<typename Point::R, 3>(internal::Distances::Found_implicit_feet());
  return Implicit_feet<typename Point::R, 3>(
      internal::Distances::implicit_feet_of({first.polynomial(), second.polynomial()}, box, p, options));
}

/*!
\ingroup PkgSplineConstraintsDDistances
the distance to first order, \f$|f(p)|/|\nabla f(p)|\f$, rounded: what Newton's step moves the point by. Near a regular
point of the curve or surface it differs from the distance by a square of it; nothing where the gradient is zero.
\throws Invalid_input when a coordinate is not finite. Source: \cgalCite{pm-sicad-02}.
*/
template <class Point, int d>
requires(Point::Ambient_dimension::value ==
         d) std::optional<double> first_order_distance(const Point& point, const Implicit_hypersurface<d>& locus)
{
  const auto exact = internal::exact_object(point);
  std::array<Exact_rational, d> p;
  for (int i = 0; i < d; ++i)
    p[i] = exact[i];
  const Exact_rational value = locus(p);
  Exact_rational square(0);
  for (const Exact_rational& slope : locus.gradient(p))
    square += Exact_rational(slope * slope);
  if (square == 0)
    return std::nullopt;
  return internal::Distances::near_root(Exact_rational(value * value / square));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_IMPLICIT_DISTANCES_H
