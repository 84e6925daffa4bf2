// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_POINT_FILTER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_POINT_FILTER_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

inline std::array<Mpfr_interval, 3> gradient_of(const Power_polynomial& polynomial,
                                                const std::vector<Mpfr_interval>& box)
{
  std::array<Mpfr_interval, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = polynomial.derivative(static_cast<int>(i)).value(std::span<const Mpfr_interval>(box));
  return result;
}

// Whether the product of a gradient with the normals of a surface is not zero: then two points on one of the normals,
// at which the polynomial has the same value, are the same point, by the mean value theorem.
inline bool crosses_normals(const std::array<Mpfr_interval, 3>& gradient, const Spline_patch<3>& surface)
{
  // on both sides of a break the tangents have other lengths
  const std::vector<Exact_rational> u = surface.breaks(0), v = surface.breaks(1);
  for (std::size_t i = 1; i < u.size(); ++i)
    for (std::size_t j = 1; j < v.size(); ++j) {
      const Spline_patch<3> cell = surface.part({{u[i - 1], u[i]}, {v[j - 1], v[j]}});
      const Vector_bounds<3> s = cell.tangents(0), t = cell.tangents(1);
      Mpfr_interval slope(0);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        const Rational_interval normal = s[l] * t[m] - s[m] * t[l];
        slope += gradient[k] * Mpfr_interval(normal.lower, normal.upper);
      }
      if (!CGAL::certainly(slope.sign() != CGAL::ZERO))
        return false;
    }
  return true;
}

inline std::array<Mpfr_interval, 3> cross_product(const std::array<Mpfr_interval, 3>& p,
                                                  const std::array<Mpfr_interval, 3>& q)
{
  std::array<Mpfr_interval, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = p[j] * q[k] - p[k] * q[j];
  }
  return result;
}

// Whether two gradients and a direction are independent: then two points at which both polynomials have the same
// values, and whose difference is perpendicular to the direction, are the same point.
inline bool are_independent(const std::array<Mpfr_interval, 3>& p, const std::array<Mpfr_interval, 3>& q,
                            const std::array<Mpfr_interval, 3>& direction)
{
  const std::array<Mpfr_interval, 3> product = cross_product(p, q);
  Mpfr_interval determinant(0);
  for (std::size_t i = 0; i < 3; ++i)
    determinant += direction[i] * product[i];
  return CGAL::certainly(determinant.sign() != CGAL::ZERO);
}

/*
Of curves of pairs of points of two parametric surfaces A and B, those of common points A = B.

Along a regular curve in one cell of both surfaces A - B is analytic: it is zero everywhere, if it is around one vertex,
which a test has to prove. Curves of other pairs are in boxes where A and B are apart.
*/
class Common_point_filter
{
public:
  // Whether all pairs near a solution that satisfy the equations are one point, given a box that has both points.
  using Test = std::function<bool(const std::vector<Mpfr_interval>&, const Exact_ranges&)>;

  // How often a curve counts, by the boxes of a piece of it and of a regular point on this piece.
  using Multiplicity = std::function<int(const Exact_ranges&, const Exact_ranges&)>;

private:
  const Surface_equations& m_surfaces;
  const Test m_is_one_point;
  const Multiplicity m_multiplicity;   // none: that in the equations that were solved

public:
  Common_point_filter(const Surface_equations& surfaces, Test is_one_point, Multiplicity multiplicity = {})
    : m_surfaces(surfaces), m_is_one_point(std::move(is_one_point)), m_multiplicity(std::move(multiplicity))
  {}

  // Those of the solutions that are common points. What is neither proved to be that nor not to be is undecided.
  Curve_solution_set_d operator()(const Curve_solution_set_d& all) const
  {
    std::vector<Solution_curve> curves;
    std::vector<std::size_t> points, singular_points;
    std::vector<Undecided_region> undecided;
    for (const Solution_curve& curve : all.curves()) {
      const CGAL::Uncertain<bool> is_common = has_common_points(all, curve);
      if (!CGAL::is_certain(is_common))
        undecided.push_back(region_of(curve));
      else if (CGAL::get_certain(is_common))
        curves.push_back(m_multiplicity ? counted(all, curve) : curve);
    }
    for (auto [from, to] : {std::pair(&all.points(), &points), std::pair(&all.singular_points(), &singular_points)})
      for (const std::size_t i : *from) {
        const CGAL::Uncertain<bool> is_common = is_common_point(all.vertices()[i].box);
        if (!CGAL::is_certain(is_common))
          undecided.push_back({{all.vertices()[i].box}, {i}, Undecided_reason::TOLERANCE});
        else if (CGAL::get_certain(is_common))
          to->push_back(i);
      }
    for (Undecided_region region : all.undecided_regions()) {
      std::erase_if(region.boxes, [&](const Exact_ranges& box) { return are_surfaces_apart(box); });
      if (!region.boxes.empty())
        undecided.push_back(std::move(region));
    }
    return with_used_vertices(all, std::move(curves), std::move(points), std::move(singular_points),
                              std::move(undecided));
  }

  // A part of a surface, a little larger than a box.
  static Spline_patch<3> part(const Surface_equations& surfaces, std::size_t surface, const Exact_ranges& box)
  {
    const Spline_patch<3>& patch = *surfaces.surface(surface).patch;
    const std::size_t first = surfaces.parameter(surface, 0).unknown;
    constexpr double share = 0x1p-30;
    std::vector<Parameter_range> ranges;
    for (int axis = 0; axis < 2; ++axis) {
      const Parameter_range domain = patch.domain(axis), range = box[first + static_cast<std::size_t>(axis)];
      const Exact_rational margin((domain.second - domain.first) * Exact_rational(share));
      ranges.emplace_back((std::max)(domain.first, Exact_rational(range.first - margin)),
                          (std::min)(domain.second, Exact_rational(range.second + margin)));
    }
    return patch.part(ranges);
  }

private:
  const Spline_patch<3>& patch(std::size_t surface) const { return *m_surfaces.surface(surface).patch; }
  std::size_t first_unknown(std::size_t surface) const { return m_surfaces.parameter(surface, 0).unknown; }

  bool are_surfaces_apart(const Exact_ranges& box) const
  {
    return are_apart(part(m_surfaces, 0, box).values(), part(m_surfaces, 1, box).values());
  }

  // The same, by halves of the box.
  bool are_apart_in_parts(const Exact_ranges& box, int most_halvings = 8) const
  {
    if (are_surfaces_apart(box))
      return true;
    if (most_halvings == 0)
      return false;
    std::size_t longest = 0;
    Exact_rational length(0);   // a share of the domain
    for (const std::size_t surface : {0, 1})
      for (int axis = 0; axis < 2; ++axis) {
        const std::size_t unknown = first_unknown(surface) + static_cast<std::size_t>(axis);
        const Parameter_range domain = patch(surface).domain(axis);
        const Exact_rational share((box[unknown].second - box[unknown].first) / (domain.second - domain.first));
        if (length < share) {
          length = share;
          longest = unknown;
        }
      }
    Exact_ranges lower = box, upper = box;
    lower[longest].second = upper[longest].first = (box[longest].first + box[longest].second) / 2;
    return are_apart_in_parts(lower, most_halvings - 1) && are_apart_in_parts(upper, most_halvings - 1);
  }

  // Whether the solution in a box is a common point, and so are all near it.
  CGAL::Uncertain<bool> is_common_point(const Exact_ranges& solution) const
  {
    const Vector_bounds<3> a = part(m_surfaces, 0, solution).values(), b = part(m_surfaces, 1, solution).values();
    if (are_apart(a, b))
      return false;
    const Mpfr_precision_scope precision(128);
    std::vector<Mpfr_interval> both;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational_interval range = hull(a[i], b[i]);
      both.emplace_back(range.lower, range.upper);
    }
    return m_is_one_point(both, solution) ? CGAL::Uncertain<bool>(true) : CGAL::Uncertain<bool>::indeterminate();
  }

  // Whether a curve has common points only, or none.
  CGAL::Uncertain<bool> has_common_points(const Curve_solution_set_d& all, const Solution_curve& curve) const
  {
    std::optional<CGAL::Uncertain<bool>> result;
    for (auto begin = curve.pieces.begin(); begin != curve.pieces.end();) {
      const auto end = std::find_if(begin, curve.pieces.end(),
                                    [&](const Curve_piece& piece) { return cell_of(piece) != cell_of(*begin); });
      const CGAL::Uncertain<bool> is_common = has_common_points(all, std::span(begin, end));
      if (!CGAL::is_certain(is_common) || (result && CGAL::get_certain(is_common) != CGAL::get_certain(*result)))
        return CGAL::Uncertain<bool>::indeterminate();
      result = is_common;
      begin = end;
    }
    return *result;
  }

  // The same of pieces in one cell: all points are common ones, if those around a vertex are.
  CGAL::Uncertain<bool> has_common_points(const Curve_solution_set_d& all, std::span<const Curve_piece> pieces) const
  {
    for (const Curve_piece& piece : pieces)
      for (const std::size_t i : piece.ends)
        if (!all.vertices()[i].is_singular && CGAL::certainly(is_common_point(all.vertices()[i].box)))
          return true;
    return std::all_of(pieces.begin(), pieces.end(),
                       [&](const Curve_piece& piece) { return are_apart_in_parts(piece.box); })
        ? CGAL::Uncertain<bool>(false)
        : CGAL::Uncertain<bool>::indeterminate();
  }

  // The pieces of both surfaces that it lies on.
  std::vector<std::size_t> cell_of(const Curve_piece& piece) const
  {
    std::vector<std::size_t> result;
    for (const std::size_t surface : {0, 1})
      for (int axis = 0; axis < 2; ++axis) {
        const auto& [lower, upper] = piece.box[first_unknown(surface) + static_cast<std::size_t>(axis)];
        result.push_back(cell_at(patch(surface).breaks(axis), Exact_rational((lower + upper) / 2)));
      }
    return result;
  }

  Solution_curve counted(const Curve_solution_set_d& all, Solution_curve curve) const
  {
    for (Curve_piece& piece : curve.pieces) {
      piece.multiplicity = 0;
      for (const std::size_t i : piece.ends)
        if (piece.multiplicity == 0 && !all.vertices()[i].is_singular)
          piece.multiplicity = m_multiplicity(piece.box, all.vertices()[i].box);
    }
    return curve;
  }

  static Undecided_region region_of(const Solution_curve& curve)
  {
    Undecided_region result{{}, {}, Undecided_reason::TOLERANCE};
    for (const Curve_piece& piece : curve.pieces)
      result.boxes.push_back(piece.box);
    return result;
  }

  static Curve_solution_set_d with_used_vertices(const Curve_solution_set_d& all, std::vector<Solution_curve> curves,
                                                 std::vector<std::size_t> points,
                                                 std::vector<std::size_t> singular_points,
                                                 std::vector<Undecided_region> undecided)
  {
    std::vector<Curve_vertex> vertices;
    std::map<std::size_t, std::size_t> place;
    const auto renumber = [&](std::size_t& i) {
      const auto [entry, is_new] = place.try_emplace(i, vertices.size());
      if (is_new)
        vertices.push_back(all.vertices()[i]);
      i = entry->second;
    };
    for (Solution_curve& curve : curves)
      for (Curve_piece& piece : curve.pieces)
        std::for_each(piece.ends.begin(), piece.ends.end(), renumber);
    std::for_each(points.begin(), points.end(), renumber);
    std::for_each(singular_points.begin(), singular_points.end(), renumber);
    for (Undecided_region& region : undecided) {
      std::erase_if(region.vertices, [&](std::size_t i) { return !place.contains(i); });
      std::for_each(region.vertices.begin(), region.vertices.end(), renumber);
    }
    Summary summary = all.summary();
    summary.is_complete = undecided.empty();
    if (!undecided.empty())
      summary.why_not = undecided.front().reason;
    return Curve_solution_set_d(std::move(vertices), std::move(curves), std::move(points), std::move(singular_points),
                                std::move(undecided), summary);
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_POINT_FILTER_H
