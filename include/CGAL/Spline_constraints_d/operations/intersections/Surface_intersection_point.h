// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_POINT_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

A point that two surfaces have in common and that is not just one of many along a curve: where a curve ends, a singular
point, or a single point. Its parameters lie in ranges that are proved to hold them.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Surface_intersection_point
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel.
  using Point = typename Kernel::Point_3;

private:
  Intersection_kind m_kind;
  std::array<std::vector<Range>, 2> m_ranges;   // of parametric surfaces
  std::array<std::array<double, 2>, 2> m_parameters{};
  std::array<std::array<bool, 2>, 2> m_is_at_end{};
  Point m_point;

public:
#ifndef DOXYGEN_RUNNING
  Surface_intersection_point(const internal::Intersections::Surface_equations& surfaces, Intersection_kind kind,
                             const Curve_vertex::Exact_box& box)
    : m_kind(kind)
  {
    std::vector<Exact_rational> middle;
    for (const Range& range : box)
      middle.push_back(internal::Common::middle_of(range));
    m_point = internal::kernel_object<Kernel, Point>(surfaces.point(middle));
    for (std::size_t surface = 0; surface < 2; ++surface) {
      if (!surfaces.is_parametric(surface))
        continue;
      std::vector<double> unknowns;
      for (const Exact_rational& x : middle)
        unknowns.push_back(to_nearest_double(x));
      m_parameters[surface] = surfaces.parameters(surface, unknowns);
      for (const Range& range : surfaces.parameter_ranges(surface, box)) {
        const Range domain = surfaces.parameter_domain(surface, static_cast<int>(m_ranges[surface].size()));
        m_is_at_end[surface][m_ranges[surface].size()] =
            range.first == range.second && (range.first == domain.first || range.first == domain.second);
        m_ranges[surface].push_back(range);
      }
    }
  }
#endif

  //! `END_POINT` on an edge of a surface, or of the box of an implicit one; `TANGENT` where the surfaces have a common
  //! tangent plane, or one is singular; `UNDECIDED` where nothing is proved.
  Intersection_kind kind() const { return m_kind; }

  //! whether a surface, 0 or 1, has parameters: planes, spheres and implicit surfaces have none.
  bool has_parameters(std::size_t surface) const { return !m_ranges[surface].empty(); }

  //! the range that the parameter of a surface along an axis, 0 or 1, lies in; near the seam of a surface that is given
  //! by its equation the range begins before the seam. \pre It has parameters.
  const Range& parameter_range(std::size_t surface, std::size_t axis) const { return m_ranges[surface][axis]; }

  //! the parameter in the middle of the ranges, rounded to double. \pre It has parameters.
  double parameter(std::size_t surface, std::size_t axis) const { return m_parameters[surface][axis]; }

  //! whether it is at an end of the range of a parameter: on an edge or a seam, by proof. Not known of a surface that
  //! is given by its equation.
  bool is_at_end(std::size_t surface, std::size_t axis) const { return m_is_at_end[surface][axis]; }

  //! the point in the middle of the ranges.
  const Point& point() const { return m_point; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_POINT_H
