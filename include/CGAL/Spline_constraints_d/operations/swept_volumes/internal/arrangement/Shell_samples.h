// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SHELL_SAMPLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SHELL_SAMPLES_H

#include <CGAL/Spline_constraints_d/internal/aabb_trees.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_shells.h>

#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// A point of the cell that a shell bounds, and its distance from all triangles.
struct Shell_sample
{
  Double_kernel::Point_3 point;
  double depth;
};

// Finds points in cells: over the middles of triangles, halfway to the next triangle. That a point lies in the cell is
// proved by exact numbers: the segment to the middle meets no other triangle.
class Shell_samples
{
  using Point = Double_kernel::Point_3;
  using Vector = Double_kernel::Vector_3;

  template <class Kernel>
  struct Primitive
  {
    using Id = std::size_t;
    using Point = typename Kernel::Point_3;
    using Datum = typename Kernel::Triangle_3;
    using Datum_reference = const Datum&;

    const Datum* triangle;
    Id index;

    Primitive(typename std::vector<std::pair<const Datum*, Id>>::const_iterator both)
      : triangle(both->first), index(both->second)
    {}
    Datum_reference datum() const { return *triangle; }
    Point reference_point() const { return triangle->vertex(0); }
    Id id() const { return index; }
  };
  template <class Kernel>
  using Tree = Aabb_tree_3<Kernel, Primitive<Kernel>>;

  std::vector<Exact_kernel::Triangle_3> m_exact;
  std::vector<Double_kernel::Triangle_3> m_rounded;
  Tree<Exact_kernel> m_exact_tree;
  Tree<Double_kernel> m_rounded_tree;
  std::vector<std::vector<std::pair<double, std::size_t>>> m_sides; // of shells, by their areas: 2 triangle + side
  std::vector<double> m_volumes;                                    // that shells enclose

public:
  Shell_samples(const Triangle_complex& complex, const Triangle_shells& shells)
    : m_sides(shells.number_of_shells()), m_volumes(shells.number_of_shells(), 0)
  {
    std::vector<Point> points;
    for (const auto& point : complex.points)
      points.push_back(Swept_volumes::rounded(point));
    for (const Corners& corners : complex.triangles) {
      m_exact.emplace_back(complex.points[corners[0]], complex.points[corners[1]], complex.points[corners[2]]);
      m_rounded.emplace_back(points[corners[0]], points[corners[1]], points[corners[2]]);
    }
    fill(m_exact_tree, m_exact);
    fill(m_rounded_tree, m_rounded);
    for (std::size_t triangle = 0; triangle < m_exact.size(); ++triangle) {
      const Double_kernel::Triangle_3& own = m_rounded[triangle];
      const Point& origin = m_rounded.front().vertex(0); // so that volumes of small cells are not lost in rounding
      const double volume =
          CGAL::determinant(own.vertex(0) - origin, own.vertex(1) - origin, own.vertex(2) - origin) / 6;
      for (int side = 0; side < 2; ++side) {
        const std::size_t shell = shells.shell_of(triangle, side);
        m_sides[shell].emplace_back(-own.squared_area(), 2 * triangle + side);
        m_volumes[shell] += side == 0 ? -volume : volume;
      }
    }
    for (auto& sides : m_sides)
      std::sort(sides.begin(), sides.end());
  }

  // The deepest point that was found for a shell; of those of an unbounded cell, one may be far away.
  std::optional<Shell_sample> operator()(std::size_t shell) const
  {
    const auto& sides = m_sides[shell];
    std::optional<Shell_sample> result;
    for (const std::size_t index : tried_of(sides.size()))
      if (const auto sample = sample_over(sides[index].second / 2, sides[index].second % 2))
        if (!result || sample->depth > result->depth)
          result = sample;
    return result;
  }

  // The greatest depth that a point can have by the volume that the shell encloses; none if it surrounds its cell
  // together with others, or alone from within.
  std::optional<double> depth_bound(std::size_t shell) const
  {
    const double volume = m_volumes[shell];
    return volume > 0 ? std::optional(std::cbrt(volume * 0.75 / std::numbers::pi)) : std::nullopt;
  }

  // Of a point from all triangles.
  double distance(const Point& point) const { return std::sqrt(m_rounded_tree.squared_distance(point)); }

private:
  template <class Kernel>
  static void fill(Tree<Kernel>& tree, const std::vector<typename Kernel::Triangle_3>& triangles)
  {
    std::vector<std::pair<const typename Kernel::Triangle_3*, std::size_t>> all;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (!triangles[i].is_degenerate())
        all.emplace_back(&triangles[i], i);
    tree.insert(all.cbegin(), all.cend());
    tree.build();
  }

  // The largest ones, and some of all.
  static std::vector<std::size_t> tried_of(std::size_t count)
  {
    constexpr std::size_t large = 8, spread = 8;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < (std::min)(large, count); ++i)
      result.push_back(i);
    for (std::size_t i = 0; i < spread; ++i)
      if (const std::size_t index = (2 * i + 1) * count / (2 * spread); index >= large)
        result.push_back(index);
    return result;
  }

  std::optional<Shell_sample> sample_over(std::size_t triangle, int side) const
  {
    const Double_kernel::Triangle_3& rounded = m_rounded[triangle];
    const Vector normal =
        CGAL::cross_product(rounded.vertex(1) - rounded.vertex(0), rounded.vertex(2) - rounded.vertex(0));
    const double length = std::sqrt(normal.squared_length());
    if (!(length > 0))
      return std::nullopt;
    const Point middle = CGAL::centroid(rounded);
    const Vector outward = normal * ((side == 0 ? 1 : -1) / length);
    const Point point = middle + outward * (0.5 * distance_along(middle, outward, triangle));
    if (!sees(point, triangle, side))
      return std::nullopt;
    return Shell_sample{point, distance(point)};
  }

  // To the next triangle, or out of all.
  double distance_along(const Point& from, const Vector& direction, std::size_t own) const
  {
    const CGAL::Bbox_3 bounds = m_rounded_tree.bbox();
    double result = 2 * (bounds.xmax() - bounds.xmin() + bounds.ymax() - bounds.ymin() + bounds.zmax() - bounds.zmin());
    std::vector<std::size_t> met;
    m_rounded_tree.all_intersected_primitives(Double_kernel::Ray_3(from, direction), std::back_inserter(met));
    for (std::size_t index : met)
      if (index != own) {
        const Double_kernel::Triangle_3& other = m_rounded[index];
        const Vector normal = CGAL::cross_product(other.vertex(1) - other.vertex(0), other.vertex(2) - other.vertex(0));
        const double distance = ((other.vertex(0) - from) * normal) / (direction * normal);
        if (distance > 0 && distance < result)
          result = distance;
      }
    return result;
  }

  // Whether the segment from the exact middle of a triangle to a point goes to this side, and meets no other triangle.
  bool sees(const Point& point, std::size_t triangle, int side) const
  {
    const Exact_kernel::Point_3 end(point.x(), point.y(), point.z());
    const Exact_kernel::Triangle_3& own = m_exact[triangle];
    if (CGAL::orientation(own.vertex(0), own.vertex(1), own.vertex(2), end) !=
        (side == 0 ? CGAL::POSITIVE : CGAL::NEGATIVE))
      return false;
    std::vector<std::size_t> met;
    m_exact_tree.all_intersected_primitives(Exact_kernel::Segment_3(CGAL::centroid(own), end), std::back_inserter(met));
    return met.size() == 1;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SHELL_SAMPLES_H
