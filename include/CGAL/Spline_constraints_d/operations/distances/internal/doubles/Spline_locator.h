// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_SPLINE_LOCATOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_SPLINE_LOCATOR_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/Located_hit.h>
#include <CGAL/Spline_constraints_d/operations/distances/Located_point.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Prepared_spline.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/prepared_splines.h>
#endif
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// What `Curve_locator` and `Surface_locator_3` have in common: a B-spline, and what is prepared of it.
template <class Spline, SplineKernel Kernel, int d>
class Spline_locator
{
  using NT = Spline_number<typename Kernel::FT>;

  Spline m_spline;
  std::shared_ptr<const Rounded_spline<d>> m_prepared;

protected:
  explicit Spline_locator(Spline spline)
    : m_spline(std::move(spline)), m_prepared(prepared<NT, d>(m_spline.representation()))
  {}

  const Spline& spline() const { return m_spline; }

  template <class Point>
  Located_point<Kernel, d> nearest(const Point& p) const
  {
    if (const std::optional<Nearest_location<d>> location =
            nearest_location<NT, d>(Distance_operand_of<Point>::get(p).point, *m_prepared))
      return Located_point<Kernel, d>(*location);
    return Located_point<Kernel, d>(Spline_constraints::closest_points(p, m_spline), Spline::number_of_parameters);
  }

  // Where doubles do not decide, by all intersections, which a function finds.
  template <class Ray, class Intersect>
  std::optional<Located_hit<Kernel, d>> first_on(const Ray& ray, const Intersect& intersect) const
  {
    const auto coordinates = [](const auto& p) { return Distance_operand_of<std::decay_t<decltype(p)>>::get(p).point; };
    const First_hit<d> hit = first_hit<NT, d>(coordinates(ray.source()), coordinates(ray.second_point()), *m_prepared);
    if (hit.is_decided)
      return hit.is_found ? std::optional(Located_hit<Kernel, d>(hit)) : std::nullopt;
    const auto all = intersect(ray, m_spline);
    return all.empty() ? std::nullopt : std::optional(Located_hit<Kernel, d>(all[0]));
  }

public:
  // For the package.
  Distance_operand<NT, d> operand() const { return {&m_spline.representation(), m_prepared.get(), {}}; }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_SPLINE_LOCATOR_H
