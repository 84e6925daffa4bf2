// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_PLANAR_REGION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_PLANAR_REGION_2_H

#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/pairwise_intersections.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

A bounded region of the plane, of one or more parts, with or without holes, whose boundaries are made of B-spline curves.

The curves may be given in any order and direction: each is a boundary by itself, if it is closed, or goes on in another one, with exactly the same end point. Boundaries must be simple and must not meet; that is proved. A point belongs to the region if an odd number of boundaries go around it.
The boundaries are in the direction that has the region on the left: outer ones counterclockwise, those of holes clockwise.

\tparam Kernel_ a `SplineKernel`.
*/
template <SplineKernel Kernel_>
class Planar_region_2
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_2;
  using Curve = Bspline_curve_2<Kernel>;

  //! a curve of a boundary.
  struct Arc
  {
    std::size_t curve;   ///< its index
    bool is_reversed;    ///< whether the boundary runs along it from its end to its begin
  };

  //! a closed boundary.
  struct Boundary
  {
    std::vector<Arc> arcs;   ///< in order; each begins in the point where the one before ends
    bool is_hole;            ///< whether it is that of a hole, and clockwise
    std::size_t outer;       ///< the index of the outer boundary of the same part of the region
  };

private:
  std::vector<Curve> m_curves;
  std::vector<Boundary> m_boundaries;
  std::vector<internal::Boundary_loop_2> m_loops;

public:
  /*!
  the region between these curves.
  \param curves the curves.
  \param options those of the solver that looks for common points.
  \throws Invalid_input when there is no curve; one ends where no other one goes on, or several do; a boundary crosses or touches itself or another one; or it is not proved that it does not, as where it turns back in a cusp. The
  message names the curves and the parameters.
  */
  template <std::ranges::input_range Range>
    requires std::convertible_to<std::ranges::range_value_t<Range>, Bspline_curve_2<Kernel_>>
  explicit Planar_region_2(const Range& curves, const Solver_options& options = {}) : m_curves(std::ranges::begin(curves), std::ranges::end(curves))
  {
    if (m_curves.empty())
      throw Invalid_input("Planar_region_2: there are no curves");
    make_boundaries();
    check_boundaries(options);
    orient_boundaries();
  }

  //! the curves, as they were given.
  const std::vector<Curve>& curves() const { return m_curves; }

  //! the boundaries.
  const std::vector<Boundary>& boundaries() const { return m_boundaries; }

  //! the number of boundaries of holes.
  std::size_t number_of_holes() const { return std::count_if(m_boundaries.begin(), m_boundaries.end(), [](const Boundary& boundary) { return boundary.is_hole; }); }

  //! where a point is; decided exactly.
  CGAL::Bounded_side bounded_side(const Point& point) const
  {
    return bounded_side(internal::Exact_pair{internal::converted_number<Exact_rational>(point.x()), internal::converted_number<Exact_rational>(point.y())});
  }

#ifndef DOXYGEN_RUNNING
  CGAL::Bounded_side bounded_side(const internal::Exact_pair& p) const
  {
    constexpr int halvings = 24;
    int turns = 0;
    for (const internal::Boundary_loop_2& loop : m_loops) {
      if (loop.may_contain(p, halvings) && !intersections(internal::Exact_kernel::Point_2(p[0], p[1]), loop.curve()).empty())
        return CGAL::ON_BOUNDARY;
      turns += loop.winding_number(p);
    }
    return turns > 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
  }
#endif

  /*!
  bounds of the area; the same number twice where all curves are polynomial.
  \param error the bounds differ by twice this number at most; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::pair<Exact_rational, Exact_rational> area(double error = 1e-12) const
  {
    internal::check_error(error, "Planar_region_2");
    const Exact_rational part(to_rational(error) / Exact_rational(static_cast<int>(m_loops.size())));
    internal::Rational_interval result(Exact_rational(0), Exact_rational(0));
    for (const internal::Boundary_loop_2& loop : m_loops)
      result = result + loop.signed_area(part);
    return {result.lower, result.upper};
  }

  /*!
  the region as polygons, one for each part, with chords of the curves as edges: if the error is small enough for these not to meet elsewhere, the polygons are simple. Ends of polynomial pieces are corners of the polygons.
  \param error the distance of curves from their chords, at most, up to rounding of the corners; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons_with_holes(double error) const
  {
    internal::check_error(error, "Planar_region_2");
    return internal::polygons_of_parts<CGAL::Polygon_with_holes_2<Kernel>>(m_boundaries, [&](std::size_t b) {
      CGAL::Polygon_2<Kernel> polygon;
      for (const internal::Boundary_piece& piece : m_loops[b].pieces()) {
        polygon.push_back(internal::kernel_object<Kernel, Point>(piece.at(0)));
        for (const std::array<double, 2>& corner : piece.inner_corners(error))
          polygon.push_back(internal::kernel_object<Kernel, Point>(corner));
      }
      return polygon;
    });
  }

#ifndef DOXYGEN_RUNNING
  // The boundaries in pieces, for the package.
  const std::vector<internal::Boundary_loop_2>& loops() const { return m_loops; }
#endif

private:
  using End = internal::Curve_end;

  static std::string name(std::size_t curve, const Exact_rational& parameter) { return "curve " + std::to_string(curve) + " at parameter " + std::to_string(to_nearest_double(parameter)); }

  // Joins the curves in their common ends.
  void make_boundaries()
  {
    std::vector<std::vector<internal::Boundary_piece>> pieces;
    std::map<internal::Exact_pair, std::vector<End>> ends_at;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      pieces.push_back(internal::boundary_pieces(m_curves[i], i));
      ends_at[pieces[i].front().at(0)].push_back({i, 0});
      ends_at[pieces[i].back().at(1)].push_back({i, 1});
    }
    std::vector<std::array<End, 2>> next(m_curves.size());
    const auto name_of_end = [&](const End& end) { return name(end.curve, end.side == 0 ? pieces[end.curve].front().parameters[0] : pieces[end.curve].back().parameters[1]); };
    for (const auto& [point, ends] : ends_at) {
      if (ends.size() == 1)
        throw Invalid_input("Planar_region_2: the boundary is open: " + name_of_end(ends[0]) + " ends where no other one goes on");
      if (ends.size() > 2)
        throw Invalid_input("Planar_region_2: more than two ends of curves are the same point: " + name_of_end(ends[0]) + ", " + name_of_end(ends[1]) + " and " + name_of_end(ends[2]));
      next[ends[0].curve][ends[0].side] = ends[1];
      next[ends[1].curve][ends[1].side] = ends[0];
    }
    const std::vector<bool> is_closed(m_curves.size(), false);
    for (const Intersection_curve& chain : internal::chains_of_curves(is_closed, [&](const End& end) { return std::optional<End>(next[end.curve][end.side]); })) {
      Boundary boundary{{}, false, 0};
      std::vector<internal::Boundary_piece> all;
      for (const Intersection_arc& arc : chain.arcs) {
        boundary.arcs.push_back({arc.index, arc.is_reversed});
        internal::Boundary_loop_2 part(pieces[arc.index]);
        if (arc.is_reversed)
          part.reverse();
        all.insert(all.end(), part.pieces().begin(), part.pieces().end());
      }
      m_boundaries.push_back(std::move(boundary));
      m_loops.emplace_back(std::move(all));
    }
  }

  // \throws Invalid_input when boundaries meet themselves or each other.
  void check_boundaries(const Solver_options& options) const
  {
    std::vector<Bspline_curve_2<internal::Exact_kernel>> all;
    for (const internal::Boundary_loop_2& loop : m_loops)
      all.push_back(loop.curve());
    for (const auto& pair : pairwise_intersections(all, options, Self_intersections::INCLUDED).pairs) {
      const auto& meeting = pair.intersections[0];
      const auto name_of_operand = [&](std::size_t operand) {
        const auto [curve, parameter] = m_loops[operand == 0 ? pair.first : pair.second].origin(internal::middle_of(meeting.parameter_range(operand)));
        return name(curve, parameter);
      };
      throw Invalid_input("Planar_region_2: " + name_of_operand(0) + " and " + name_of_operand(1) + (meeting.kind() == Intersection_kind::UNDECIDED ? " are not proved not to meet" : " meet"));
    }
  }

  // Turns the boundaries around so that the region is on their left: those within an even number of others are counterclockwise. Of the others, the innermost one around each belongs to the same part.
  void orient_boundaries()
  {
    std::vector<std::vector<std::size_t>> around(m_loops.size());
    for (std::size_t i = 0; i < m_loops.size(); ++i)
      for (std::size_t k = 0; k < m_loops.size(); ++k)
        if (k != i && m_loops[k].winding_number(m_loops[i].source()) != 0)
          around[i].push_back(k);
    for (std::size_t i = 0; i < m_loops.size(); ++i) {
      Boundary& boundary = m_boundaries[i];
      boundary.is_hole = around[i].size() % 2 == 1;
      boundary.outer = boundary.is_hole ? *std::max_element(around[i].begin(), around[i].end(), [&](std::size_t a, std::size_t b) { return around[a].size() < around[b].size(); }) : i;
      if (m_loops[i].is_counterclockwise() != boundary.is_hole)
        continue;
      m_loops[i].reverse();
      std::reverse(boundary.arcs.begin(), boundary.arcs.end());
      for (Arc& arc : boundary.arcs)
        arc.is_reversed = !arc.is_reversed;
    }
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_PLANAR_REGION_2_H
