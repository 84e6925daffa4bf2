// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SHARED_EDGES_OF_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SHARED_EDGES_OF_CELLS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Connected_regions_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Disjoint_sets.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/cell_polynomials.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Unites regions of surfaces across sides of cells that are the same curves.
class Shared_edges_of_cells
{
  using Range = Surface_cell_3::Range;
  using Point = std::array<Exact_rational, 3>;
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>; // of regions

  // A part of a side that belongs to one region, in the local parameter of the side.
  struct Interval
  {
    Range range;
    std::size_t region; // counted through all surfaces
  };

  struct Side
  {
    std::size_t surface;
    std::array<Cell_polynomial, 4> coordinates;
    std::array<std::optional<Point>, 2> ends;
    std::vector<Interval> intervals;
    CGAL::Bbox_3 box = {};
    mutable std::map<Point, Exact_rational> places = {};
  };

  const std::vector<Trimmed_surface_3>& m_surfaces;
  std::vector<Connected_regions_3::Part> m_parts; // all regions
  std::vector<std::size_t> m_first;               // the number of the first one of each surface
  std::vector<Side> m_sides;

public:
  explicit Shared_edges_of_cells(const std::vector<Trimmed_surface_3>& surfaces) : m_surfaces(surfaces)
  {
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      m_first.push_back(m_parts.size());
      for (std::size_t r = 0; r < surfaces[s].regions().size(); ++r)
        m_parts.push_back({s, r});
      add_sides(s);
    }
  }

  Connected_regions_3 united() const
  {
    Disjoint_sets sets(m_parts.size());
    Pairs neighbours, doubtful;
    for (std::size_t i = 0; i < m_sides.size(); ++i)
      for (std::size_t j = i + 1; j < m_sides.size(); ++j)
        if (m_sides[i].surface != m_sides[j].surface)
          add_neighbours(m_sides[i], m_sides[j], neighbours, doubtful);
    for (const auto& [a, b] : neighbours)
      if (label_of(a) == label_of(b))
        sets.unite(a, b);
    const auto is_complete = [](const Trimmed_surface_3& surface) { return surface.is_complete(); };
    Connected_regions_3 result{{}, std::ranges::all_of(m_surfaces, is_complete)};
    for (const auto& [a, b] : doubtful)
      if (label_of(a) == label_of(b) && !sets.are_united(a, b))
        result.is_proved = false;
    for (const std::vector<std::size_t>& members : sets.sets()) {
      auto& region = result.regions.emplace_back(Connected_regions_3::Region{label_of(members.front()), {}});
      for (const std::size_t r : members)
        region.parts.push_back(m_parts[r]);
    }
    return result;
  }

private:
  std::optional<int> label_of(std::size_t region) const
  {
    const auto& [surface, index] = m_parts[region];
    return m_surfaces[surface].regions()[index].label;
  }

  static std::optional<Point> point_of(const std::array<Cell_polynomial, 4>& f, const Exact_rational& t)
  {
    const std::array<Exact_rational, 1> at{t};
    const Exact_rational w = f[3](at);
    if (w == 0)
      return std::nullopt;
    return Point{Exact_rational(f[0](at) / w), Exact_rational(f[1](at) / w), Exact_rational(f[2](at) / w)};
  }

  // Around a curve with positive weights, or everything.
  static CGAL::Bbox_3 box_of(const std::array<Cell_polynomial, 4>& f)
  {
    std::vector<int> degrees{0};
    for (const Cell_polynomial& x : f)
      degrees[0] = (std::max)(degrees[0], x.degree(0));
    std::array<std::vector<Exact_rational>, 4> points;
    for (std::size_t i = 0; i < 4; ++i)
      points[i] = f[i].elevated(degrees).coefficients();
    constexpr double all = std::numeric_limits<double>::infinity();
    CGAL::Bbox_3 result;
    for (std::size_t k = 0; k < points[0].size(); ++k) {
      if (!(points[3][k] > 0))
        return {-all, -all, -all, all, all, all};
      const auto range = [&](std::size_t i) { return to_double_interval(Exact_rational(points[i][k] / points[3][k])); };
      const auto x = range(0), y = range(1), z = range(2);
      result += CGAL::Bbox_3(x.first, y.first, z.first, x.second, y.second, z.second);
    }
    return result;
  }

  void add_sides(std::size_t s)
  {
    const Trimmed_surface_3& surface = m_surfaces[s];
    std::map<std::array<std::size_t, 3>, std::vector<Interval>> intervals;
    for (const Surface_border_3& border : surface.borders()) {
      const Surface_face_3& face = surface.faces()[border.face];
      const Surface_cell_3& cell = surface.cells()[face.cell];
      const int other = 1 - border.axis;
      intervals[{face.cell, static_cast<std::size_t>(border.axis), static_cast<std::size_t>(border.side)}].push_back(
          {{cell.local_parameter(other, border.range.first), cell.local_parameter(other, border.range.second)},
           m_first[s] + face.region});
    }
    for (auto& [place, own] : intervals) {
      Side side{s, {}, {}, std::move(own), {}, {}};
      for (std::size_t i = 0; i < 4; ++i)
        side.coordinates[i] =
            surface.cells()[place[0]].coordinates[i].face(static_cast<int>(place[1]), static_cast<int>(place[2]));
      side.ends = {point_of(side.coordinates, 0), point_of(side.coordinates, 1)};
      side.box = box_of(side.coordinates);
      m_sides.push_back(std::move(side));
    }
  }

  static bool is_same_curve(const std::array<Cell_polynomial, 4>& a, const std::array<Cell_polynomial, 4>& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(a[i] * b[3] == b[i] * a[3]))
        return false;
    return true;
  }

  // Where a point is on a side, if it is at a multiple of the width of the smallest parts that cells are split into.
  static std::optional<Exact_rational> place_on(const Side& side, const Point& point)
  {
    constexpr int parts = 64;
    if (side.places.empty())
      for (int i = 0; i <= parts; ++i) {
        const Exact_rational t(i, parts);
        if (const auto p = point_of(side.coordinates, t))
          side.places.emplace(*p, t);
      }
    const auto known = side.places.find(point);
    return known == side.places.end() ? std::nullopt : std::optional(known->second);
  }

  void add_neighbours(const Side& a, const Side& b, Pairs& neighbours, Pairs& doubtful) const
  {
    if (CGAL::do_overlap(a.box, b.box) && !add_neighbours_on(a, b, neighbours, doubtful))
      add_neighbours_on(b, a, neighbours, doubtful);
  }

  // If the first side is a part of the second one.
  static bool add_neighbours_on(const Side& part, const Side& whole, Pairs& neighbours, Pairs& doubtful)
  {
    if (!part.ends[0] || !part.ends[1] || is_point(part.coordinates, *part.ends[0]))
      return false;
    const auto begin = place_on(whole, *part.ends[0]), end = place_on(whole, *part.ends[1]);
    if (!begin || !end || *begin == *end)
      return false;
    const auto [lower, upper] = std::minmax(*begin, *end);
    std::array<Cell_polynomial, 4> restricted = whole.coordinates;
    for (Cell_polynomial& f : restricted)
      f = f.substituted_affine(0, *begin, Exact_rational(*end - *begin));
    if (!is_same_curve(part.coordinates, restricted))
      return false;
    std::vector<Interval> intervals;
    for (const Interval& interval : whole.intervals) {
      const Exact_rational from = (std::max)(interval.range.first, lower),
                           to = (std::min)(interval.range.second, upper);
      if (!(from < to))
        continue;
      const auto local = [&](const Exact_rational& t) { return Exact_rational((t - *begin) / (*end - *begin)); };
      intervals.push_back({std::minmax(local(from), local(to)), interval.region});
    }
    if (*end < *begin)
      std::ranges::reverse(intervals);
    add_neighbours(part.intervals, intervals, neighbours, doubtful);
    return true;
  }

  static bool is_point(const std::array<Cell_polynomial, 4>& f, const Point& point)
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(f[i] == f[3] * point[i]))
        return false;
    return true;
  }

  // Regions are neighbours if intervals of theirs have a common part; between them, ends that are not told apart may
  // leave a short one.
  static void add_neighbours(const std::vector<Interval>& a, const std::vector<Interval>& b, Pairs& neighbours,
                             Pairs& doubtful)
  {
    for (const Interval& first : a)
      for (const Interval& second : b) {
        const Exact_rational begin = (std::max)(first.range.first, second.range.first),
                             end = (std::min)(first.range.second, second.range.second);
        if (begin < end)
          neighbours.emplace_back(first.region, second.region);
      }
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
      for (std::size_t j = 0; j + 1 < b.size(); ++j) {
        const Range first(a[i].range.second, a[i + 1].range.first), second(b[j].range.second, b[j + 1].range.first);
        const bool is_same_point = first == second && first.first == first.second;
        if (first.second < second.first || second.second < first.first || is_same_point)
          continue;
        doubtful.emplace_back(a[i].region, b[j + 1].region);
        doubtful.emplace_back(a[i + 1].region, b[j].region);
      }
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Connected_regions_3 united_regions(const std::vector<Trimmed_surface_3>& surfaces)
{
  return Shared_edges_of_cells(surfaces).united();
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SHARED_EDGES_OF_CELLS_H
