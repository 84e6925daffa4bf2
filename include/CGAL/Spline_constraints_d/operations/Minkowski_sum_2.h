// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/Curve_pair_sample.h>
#include <CGAL/Spline_constraints_d/operations/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Sum_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

The Minkowski sum of two regions, or of a region and a curve: all sums of a point of one and a point of the other. A region, whose boundaries consist of arcs that are sums of points of two curves with the same direction.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Minkowski_sum_2
{
public:
  using Point = typename Kernel::Point_2;
  using Sample = Curve_pair_sample<Kernel>;

  //! an arc of a boundary: the sums of points of a part of a curve of the first operand and a part of one of the second operand. One of these may be a point.
  struct Arc
  {
    std::array<std::size_t, 2> curves;                  ///< the indices of the curves
    std::array<std::array<double, 2>, 2> parameters;    ///< of each curve, where the arc begins and ends
  };

  //! a boundary, with the region on its left.
  struct Boundary
  {
    std::vector<Arc> arcs;   ///< in order; each begins where the one before ends
    bool is_closed;          ///< whether the last arc ends where the first one begins; false only where something is not decided
    bool is_hole;            ///< whether it is clockwise
  };

private:
  // What was computed, in the order in which each refers to those before.
  struct Model
  {
    std::array<std::vector<internal::Boundary_loop_2>, 2> loops;
    internal::Region_elements_2 first, second;
    internal::Sum_interior_2 interior;
    internal::Convolution_2 convolution;
    internal::Sum_boundary_2 boundary;

    Model(std::vector<internal::Boundary_loop_2> a, std::vector<internal::Boundary_loop_2> b)
      : loops{std::move(a), std::move(b)}, first(loops[0]), second(loops[1]), interior(first, second), convolution(first, second, interior), boundary(convolution, interior)
    {}
  };

  std::shared_ptr<const Model> m_model;
  std::vector<Boundary> m_boundaries;

public:
#ifndef DOXYGEN_RUNNING
  // Of the sets with these boundaries.
  Minkowski_sum_2(std::vector<internal::Boundary_loop_2> a, std::vector<internal::Boundary_loop_2> b)
  {
    const Upward_rounding_guard guard;
    m_model = std::make_shared<const Model>(std::move(a), std::move(b));
    for (const Chain& chain : m_model->boundary.chains())
      m_boundaries.push_back(boundary(chain));
  }
#endif

  //! the boundaries.
  const std::vector<Boundary>& boundaries() const { return m_boundaries; }

  //! whether these are all, by proof.
  bool is_complete() const { return m_model->boundary.undecided().empty(); }

  //! boxes outside of which the boundaries are proved. Within them there may be others, or an arc may be inside of the sum.
  std::vector<CGAL::Bbox_2> undecided() const
  {
    std::vector<CGAL::Bbox_2> result;
    for (const internal::Interval_pair& box : m_model->boundary.undecided())
      result.emplace_back(box[0].inf(), box[1].inf(), box[0].sup(), box[1].sup());
    return result;
  }

  //! whether a point is inside of the sum; indeterminate on the boundary, and where it is not decided. This does not use the boundaries.
  CGAL::Uncertain<bool> has_in_interior(const Point& point) const
  {
    const Upward_rounding_guard guard;
    const auto enclosed = [](const auto& x) { return internal::interval_of(internal::converted_number<Exact_rational>(x)); };
    return m_model->interior.contains({enclosed(point.x()), enclosed(point.y())});
  }

  /*!
  points along an arc of a boundary, so many that it passes the middles of their chords at no more than a given distance.
  \param boundary the index of the boundary.
  \param arc the index of the arc there.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t boundary, std::size_t arc, double error) const
  {
    check_error(error);
    const Upward_rounding_guard guard;
    const Section& section = m_model->boundary.chains()[boundary].sections[arc];
    std::vector<Sample> result;
    for (const auto& [t, place] : samples_along(section, error)) {
      Sample sample{internal::kernel_object<Kernel, Point>(place), {}};
      for (std::size_t k = 0; k < 2; ++k)
        sample.parameters[k] = origin(section, k, t).second;
      result.push_back(sample);
    }
    return result;
  }

  /*!
  polygons next to the sum: the closed boundaries as polylines, holes with the innermost polygon that they are in. Boundaries that are not closed are left out, and holes of those.
  \param error the error of the polylines, which do not meet if it is small enough; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons_with_holes(double error) const
  {
    check_error(error);
    const Upward_rounding_guard guard;
    std::vector<CGAL::Polygon_with_holes_2<Kernel>> result;
    std::vector<CGAL::Polygon_2<Kernel>> holes;
    for (std::size_t i = 0; i < m_boundaries.size(); ++i)
      if (m_boundaries[i].is_closed) {
        CGAL::Polygon_2<Kernel> polygon;
        for (const auto& p : points_along(m_model->boundary.chains()[i], error))
          polygon.push_back(internal::kernel_object<Kernel, Point>(p));
        if (m_boundaries[i].is_hole)
          holes.push_back(std::move(polygon));
        else
          result.emplace_back(std::move(polygon));
      }
    for (const CGAL::Polygon_2<Kernel>& hole : holes) {   // others may be around the innermost one
      auto around = result.end();
      for (auto polygon = result.begin(); polygon != result.end(); ++polygon)
        if (polygon->outer_boundary().bounded_side(hole[0]) == CGAL::ON_BOUNDED_SIDE && (around == result.end() || polygon->outer_boundary().area() < around->outer_boundary().area()))
          around = polygon;
      if (around != result.end())
        around->add_hole(hole);
    }
    return result;
  }

private:
  using Section = internal::Sum_boundary_2::Section;
  using Chain = internal::Sum_boundary_2::Chain;
  using Double_point = std::array<double, 2>;

  static void check_error(double error)
  {
    if (!(error > 0))
      throw Invalid_input("Minkowski_sum_2: the error must be positive");
  }

  // The curve of a region, and its parameter, that a point of a section comes from.
  std::pair<std::size_t, double> origin(const Section& section, std::size_t region, double t) const
  {
    const internal::Convolution_piece_2& piece = m_model->boundary.piece(section);
    return (region == 0 ? m_model->first : m_model->second).origin(piece.element(region).arc, piece.parameters(t)[region]);
  }

  Double_point point(const Section& section, double t) const
  {
    const internal::Interval_pair p = m_model->boundary.piece(section)({t, t}).point;
    return {p[0].inf() / 2 + p[0].sup() / 2, p[1].inf() / 2 + p[1].sup() / 2};
  }

  Boundary boundary(const Chain& chain) const
  {
    Boundary result{{}, chain.is_closed, false};
    for (const Section& section : chain.sections) {
      Arc arc;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto [curve, begin] = origin(section, k, section.range.begin);
        arc.curves[k] = curve;
        arc.parameters[k] = {begin, origin(section, k, section.range.end).second};
      }
      result.arcs.push_back(arc);
    }
    result.is_hole = chain.is_closed && is_clockwise(points_along(chain, std::numeric_limits<double>::infinity()));
    return result;
  }

  static bool is_clockwise(const std::vector<Double_point>& points)
  {
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Double_point &p = points[i], &q = points[(i + 1) % points.size()];
      area += (p[0] - points[0][0]) * (q[1] - points[0][1]) - (q[0] - points[0][0]) * (p[1] - points[0][1]);
    }
    return area < 0;
  }

  // Without the ends of the sections, where the next ones begin.
  std::vector<Double_point> points_along(const Chain& chain, double error) const
  {
    std::vector<Double_point> result;
    for (const Section& section : chain.sections) {
      for (const auto& [t, place] : samples_along(section, error))
        result.push_back(place);
      if (chain.is_closed || &section != &chain.sections.back())
        result.pop_back();
    }
    return result;
  }

  // Parameters and points.
  using Samples = std::vector<std::pair<double, Double_point>>;

  Samples samples_along(const Section& section, double error) const
  {
    const auto sample = [&](double t) { return Samples::value_type{t, point(section, t)}; };
    const auto between = [&](const auto& from, const auto& to) { return sample(from.first / 2 + to.first / 2); };
    const auto is_chord = [&](const auto& from, const auto& middle, const auto& to) { return internal::distance_from_middle(from.second, middle.second, to.second) <= error; };
    Samples result{sample(section.range.begin)};
    internal::append_samples(result, sample(section.range.end), between, is_chord);
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_2_H
