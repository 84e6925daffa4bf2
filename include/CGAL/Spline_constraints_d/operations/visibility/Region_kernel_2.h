// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNEL_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNEL_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Kernel_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_of_region_2.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/visibility/internal/kernel_of_region.h>
#endif

#include <CGAL/Polygon_2.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVisibility

The kernel of a region of the plane: the points from which all of the region is seen. It is convex: what is on the left
of all tangents of the boundary. Its own boundary, counterclockwise, consists of arcs of the curves, where these turn
left, and of segments of tangents of inflections and at ends.

\tparam Kernel_ a `SplineKernel`.
*/
template <SplineKernel Kernel_>
class Region_kernel_2
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_2;

  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;

private:
  internal::Visibility::Kernel_of_region_2 m_kernel;

public:
  /*!
  the kernel of a region.
  \param region the region. One with holes, or of several parts, has no kernel, other than a point where parts touch. Of
  one that is not complete, the kernel is undecided.
  \param options limits of time and nodes, a visitor; the rest of the options has no effect.
  \throws Invalid_input when an option makes no sense.
  */
  explicit Region_kernel_2(const Planar_region_2<Kernel>& region, const Solver_options& options = {})
  {
    options.check();
    if (!region.is_complete()) {
      m_kernel.undecided = region.undecided();
      m_kernel.summary = region.summary();
    } else if (region.boundaries().size() == 1 || region.has_touching_boundaries())
      m_kernel = internal::Visibility::kernel_of_region(internal::Regions::pieces_of_curves(region.curves()),
                                                        region.loops(), options);
    else
      m_kernel.may_have_interior = false;
  }

  //! whether no point sees all of the region; indeterminate if neither a point that does nor a proof that there is none
  //! was found.
  CGAL::Uncertain<bool> is_empty() const
  {
    const bool is_proved_empty = !m_kernel.may_have_interior && m_kernel.flat.empty(),
               is_proved_not_empty = has_interior() || (m_kernel.is_straight && !m_kernel.flat.empty());
    return {is_proved_empty, !is_proved_not_empty};
  }

  //! whether the kernel has an interior, by proof.
  bool has_interior() const { return m_kernel.centre.has_value(); }

  /*!
  the boundary: each part begins in the point where the one before ends. Arcs of a closed curve end at its seam. None if
  the kernel has no interior.
  */
  const std::vector<Kernel_edge_2>& edges() const { return m_kernel.edges; }

  //! corners of a segment, or a point, that the kernel lies in if it has no interior; it is the whole of it if all
  //! curves of the region are straight. None if it is empty.
  std::vector<Point> flat_part() const
  {
    std::vector<Point> result;
    for (const internal::Exact_pair& p : m_kernel.flat)
      result.push_back(internal::kernel_object<Kernel, Point>(p));
    return result;
  }

  //! whether all of the boundary is proved, or that the kernel is empty, or what it is if it has no interior.
  bool is_complete() const { return m_kernel.undecided.empty(); }

  //! what is not decided: boxes, outside of which it is known what belongs to the kernel. When a limit was reached, or
  //! the visitor stopped the run, a box that the kernel lies in.
  const std::vector<Undecided_part>& undecided() const { return m_kernel.undecided; }

  //! the work; a node is what is done between two questions whether to go on.
  const Summary& summary() const { return m_kernel.summary; }

  //! a point in the interior. \pre `has_interior()`
  Point centre() const
  {
    CGAL_precondition(has_interior());
    return internal::kernel_object<Kernel, Point>(*m_kernel.centre);
  }

  //! ranges of the coordinates of the point where an edge begins; each is one number where it is known exactly.
  std::array<Range, 2> source_ranges(std::size_t edge) const
  {
    const auto& [x, y] = m_kernel.vertices[edge];
    return {Range{x.lower, x.upper}, Range{y.lower, y.upper}};
  }

  //! the point at the middle of these ranges, rounded where the kernel is not exact.
  Point source(std::size_t edge) const
  {
    const auto& [x, y] = m_kernel.vertices[edge];
    return internal::kernel_object<Kernel, Point>(
        internal::Exact_pair{Exact_rational((x.lower + x.upper) / 2), Exact_rational((y.lower + y.upper) / 2)});
  }

  /*!
  points along a part of the boundary, from its source to its target, so that no point of it is farther from the chords
  between them than a given distance, but for the rounding of coordinates.
  \param edge the index of the part.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Point> polyline(std::size_t edge, double error) const
  {
    internal::check_error(error, "Region_kernel_2");
    std::vector<Point> result{source(edge)};
    if (m_kernel.edges[edge].kind == Kernel_edge_kind::ARC)
      m_kernel.parts.append_samples<Kernel>(m_kernel.edges[edge].curve, m_kernel.edges[edge].parameter(0),
                                            m_kernel.edges[edge].parameter(1), to_rational(error), result);
    else
      result.push_back(source(m_kernel.after(edge)));
    return result;
  }

  /*!
  the polygon of these points of all parts, all on the boundary of the kernel but for the widths of ranges and rounding;
  empty if the kernel has no interior.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  CGAL::Polygon_2<Kernel> polygon(double error) const
  {
    internal::check_error(error, "Region_kernel_2");
    CGAL::Polygon_2<Kernel> result;
    for (std::size_t i = 0; i < m_kernel.edges.size(); ++i) {
      const std::vector<Point> points = polyline(i, error);
      result.insert(result.vertices_end(), points.begin(), points.end() - 1);
    }
    return result;
  }

  /*!
  bounds of the area; the same number twice where all vertices are known exactly and the curves are polynomial. They are
  as close as the ranges of vertices.
  \param error how far from each other the bounds may be in addition; positive.
  \pre `is_complete()`
  \throws Invalid_input when the error is not positive.
  */
  Range area(double error = 1e-12) const
  {
    internal::check_error(error, "Region_kernel_2");
    CGAL_precondition(is_complete());
    return internal::Visibility::area_of_kernel(m_kernel, error);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNEL_2_H
