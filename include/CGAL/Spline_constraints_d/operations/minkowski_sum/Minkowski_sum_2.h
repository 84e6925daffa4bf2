// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_sample.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

The Minkowski sum of two regions, or of a region and a curve: all sums of a point of one and a point of the other. A
region, whose boundaries consist of arcs that are sums of points of two curves with the same direction.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Minkowski_sum_2
{
public:
  using Point = typename Kernel::Point_2;
  using Sample = Curve_pair_sample<Kernel>;

  //! an arc of a boundary: the sums of points of a part of a curve of the first operand and a part of one of the second
  //! operand. One of these may be a point.
  struct Arc
  {
    std::array<std::size_t, 2> curves;                  ///< the indices of the curves
    std::array<std::array<double, 2>, 2> parameters;    ///< of each curve, where the arc begins and ends
  };

  //! a boundary, with the region on its left. Where parts of the region touch in a point, they are apart: each boundary
  //! is one of the region near it, and may pass through a point twice. So a hole that touches the outer boundary is a
  //! part of this one, as in an arrangement.
  struct Boundary
  {
    std::vector<Arc> arcs;   ///< in order; each begins where the one before ends
    /// whether the last arc ends where the first one begins; false only where something is not decided
    bool is_closed;
    bool is_hole;            ///< whether it is clockwise, as is proved by bounds of the area
    /// the index of the outer boundary of the same part of the sum, as is proved by winding numbers; if it is not
    /// known, no index
    std::size_t outer;
  };

private:
  // What was computed, in the order in which each refers to those before.
  struct Model
  {
    std::array<std::vector<internal::Regions::Boundary_loop_2>, 2> loops;
    internal::Minkowski_sum::Region_elements_2 first, second;
    internal::Minkowski_sum::Sum_interior_2 interior;
    internal::Minkowski_sum::Convolution_2 convolution;
    internal::Minkowski_sum::Sum_boundary_2 boundary;

    Model(std::vector<internal::Regions::Boundary_loop_2> a, std::vector<internal::Regions::Boundary_loop_2> b)
      : loops{std::move(a), std::move(b)}, first(loops[0]), second(loops[1]), interior(first, second),
        convolution(first, second, interior), boundary(convolution, interior)
    {}
  };

  std::shared_ptr<const Model> m_model;
  std::vector<Boundary> m_boundaries;
  std::vector<CGAL::Bbox_2> m_undecided;

public:
#ifndef DOXYGEN_RUNNING
  // Of the sets with these boundaries.
  Minkowski_sum_2(std::vector<internal::Regions::Boundary_loop_2> a, std::vector<internal::Regions::Boundary_loop_2> b)
  {
    Exact_rational greatest(0);
    for (const auto* loops : {&a, &b})
      for (const internal::Regions::Boundary_loop_2& loop : *loops)
        greatest = (std::max)(greatest, loop.greatest_coordinate());
    internal::check_greatest_coordinate(greatest, "Minkowski_sum_2");
    const Upward_rounding_guard guard;
    m_model = std::make_shared<const Model>(std::move(a), std::move(b));
    for (const Chain& chain : m_model->boundary.chains())
      m_boundaries.push_back(boundary(chain));
    for (const internal::Common::Interval_pair& box : m_model->boundary.undecided())
      m_undecided.emplace_back(box[0].inf(), box[1].inf(), box[0].sup(), box[1].sup());
  }
#endif

  //! the boundaries.
  const std::vector<Boundary>& boundaries() const { return m_boundaries; }

  //! whether these are all, by proof.
  bool is_complete() const { return m_undecided.empty(); }

  //! boxes outside of which the boundaries are proved. Within them there may be others, or an arc may be inside of the
  //! sum.
  const std::vector<CGAL::Bbox_2>& undecided() const { return m_undecided; }

  //! whether a point is inside of the sum; indeterminate on the boundary, and where it is not decided. This does not
  //! use the boundaries.
  CGAL::Uncertain<bool> has_in_interior(const Point& point) const
  {
    const Upward_rounding_guard guard;
    const auto enclosed = [](const auto& x) {
      return internal::Common::interval_of(internal::converted_number<Exact_rational>(x));
    };
    return m_model->interior.contains({enclosed(point.x()), enclosed(point.y())});
  }

  /*!
  points along an arc of a boundary, so many that their chords are proved to be no farther from the arc than a given
  distance, and the arc from them. An arc is halved at most 20 times.
  \param boundary the index of the boundary.
  \param arc the index of the arc there.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t boundary, std::size_t arc, double error) const
  {
    internal::check_error(error, "Minkowski_sum_2");
    const Upward_rounding_guard guard;
    const Section& section = m_model->boundary.chains()[boundary].sections[arc];
    std::vector<Sample> result;
    for (const Arc_point& place : samples_along(section, error)) {
      Sample sample{internal::kernel_object<Kernel, Point>(place.middle()), {}};
      for (std::size_t k = 0; k < 2; ++k)
        sample.parameters[k] = origin(section, k, place.parameter).second;
      result.push_back(sample);
    }
    return result;
  }

  /*!
  polygons next to the sum, one for each part: the boundaries as polylines. Those that are not closed, or whose outer
  boundary is not known, are left out. Boundaries that touch themselves do so in a point that is a vertex of the polygon
  twice, up to rounding.
  \param error the error of the polylines, as of `polyline()`, up to rounding in vertices between arcs; positive. They
  do not meet otherwise if it is small enough.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons_with_holes(double error) const
  {
    internal::check_error(error, "Minkowski_sum_2");
    const Upward_rounding_guard guard;
    return internal::Regions::polygons_of_parts<CGAL::Polygon_with_holes_2<Kernel>>(m_boundaries, [&](std::size_t b) {
      CGAL::Polygon_2<Kernel> polygon;
      for (const auto& p : points_along(m_model->boundary.chains()[b], error))
        polygon.push_back(internal::kernel_object<Kernel, Point>(p));
      return polygon;
    });
  }

private:
  using Section = internal::Minkowski_sum::Sum_boundary_2::Section;
  using Chain = internal::Minkowski_sum::Sum_boundary_2::Chain;
  using Double_point = std::array<double, 2>;

  // The curve of a region, and its parameter, that a point of a section comes from.
  std::pair<std::size_t, double> origin(const Section& section, std::size_t region, double t) const
  {
    const internal::Minkowski_sum::Convolution_piece_2& piece = m_model->boundary.piece(section);
    return (region == 0 ? m_model->first : m_model->second)
        .origin(piece.element(region).arc, piece.parameters(t)[region]);
  }

  Boundary boundary(const Chain& chain) const
  {
    Boundary result{{}, chain.is_closed, chain.is_hole, chain.outer};
    for (const Section& section : chain.sections) {
      Arc arc;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto [curve, begin] = origin(section, k, section.range.begin);
        arc.curves[k] = curve;
        arc.parameters[k] = {begin, origin(section, k, section.range.end).second};
      }
      result.arcs.push_back(arc);
    }
    return result;
  }

  // Without the ends of the sections, where the next ones begin.
  std::vector<Double_point> points_along(const Chain& chain, double error) const
  {
    std::vector<Double_point> result;
    for (const Section& section : chain.sections) {
      for (const Arc_point& sample : samples_along(section, error))
        result.push_back(sample.middle());
      if (chain.is_closed || &section != &chain.sections.back())
        result.pop_back();
    }
    return result;
  }

  // A point of an arc, and a direction of its tangent there.
  struct Arc_point
  {
    double parameter;
    internal::Common::Interval_pair point, direction;

    Double_point middle() const
    {
      return {point[0].inf() / 2 + point[0].sup() / 2, point[1].inf() / 2 + point[1].sup() / 2};
    }
  };

  std::vector<Arc_point> samples_along(const Section& section, double error) const
  {
    constexpr internal::Common::Halvings halvings{2, 20};
    const internal::Minkowski_sum::Convolution_piece_2& piece = m_model->boundary.piece(section);
    const auto sample = [&](double t) { return Arc_point{t, piece({t, t}).point, piece.direction({t, t})}; };
    const auto between = [&](const Arc_point& from, const Arc_point& to) {
      return sample(from.parameter / 2 + to.parameter / 2);
    };
    const auto is_chord = [&](const Arc_point& from, const Arc_point&, const Arc_point& to) {
      return chord_error(piece, from, to) <= error;
    };
    std::vector<Arc_point> result{sample(section.range.begin)};
    internal::Common::append_samples(result, sample(section.range.end), between, is_chord, halvings);
    return result;
  }

  /*
  A bound of the distance between a chord and its part of an arc, either way. This turns to one side, by an angle a, so
  it is in a triangle of the chord and both tangents, with a height of at most tan(a / 2) times half of the chord. Near
  an inflection it is a bound of the size of that part.
  */
  static double chord_error(const internal::Minkowski_sum::Convolution_piece_2& piece, const Arc_point& from,
                            const Arc_point& to)
  {
    using internal::Common::operator-;
    if (!piece.is_convex())
      return internal::Minkowski_sum::diameter(piece({from.parameter, to.parameter}).point).sup();
    const internal::Common::Interval half_chord =
        CGAL::sqrt(internal::Common::squared_norm(to.point - from.point)) / internal::Common::Interval(2);
    return (half_chord * CGAL::abs(internal::Minkowski_sum::tangent_of_half_angle(from.direction, to.direction)) +
            internal::Minkowski_sum::diameter(from.point) + internal::Minkowski_sum::diameter(to.point))
        .sup();
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_2_H
