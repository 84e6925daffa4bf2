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
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Connected_regions_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Disjoint_sets.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/cell_polynomials.h>

#include <algorithm>
#include <array>
#include <cstddef>
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
      Side side{s, {}, {}, std::move(own)};
      for (std::size_t i = 0; i < 4; ++i)
        side.coordinates[i] =
            surface.cells()[place[0]].coordinates[i].face(static_cast<int>(place[1]), static_cast<int>(place[2]));
      side.ends = {point_of(side.coordinates, 0), point_of(side.coordinates, 1)};
      m_sides.push_back(std::move(side));
    }
  }

  static Cell_polynomial reversed(const Cell_polynomial& f)
  {
    return Cell_polynomial(f.degrees(), {f.coefficients().rbegin(), f.coefficients().rend()});
  }

  static bool is_same_curve(const std::array<Cell_polynomial, 4>& a, const std::array<Cell_polynomial, 4>& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(a[i] * b[3] == b[i] * a[3]))
        return false;
    return true;
  }

  static void add_neighbours(const Side& a, const Side& b, Pairs& neighbours, Pairs& doubtful)
  {
    for (const bool is_reversed : {false, true}) {
      if (!a.ends[0] || !a.ends[1] || a.ends[0] != b.ends[is_reversed ? 1 : 0] ||
          a.ends[1] != b.ends[is_reversed ? 0 : 1])
        continue;
      std::array<Cell_polynomial, 4> other = b.coordinates;
      std::vector<Interval> intervals = b.intervals;
      if (is_reversed) {
        std::ranges::transform(other, other.begin(), reversed);
        std::ranges::reverse(intervals);
        for (Interval& interval : intervals)
          interval.range = {Exact_rational(1 - interval.range.second), Exact_rational(1 - interval.range.first)};
      }
      if (is_same_curve(a.coordinates, other) && !is_point(a.coordinates, *a.ends[0])) {
        add_neighbours(a.intervals, intervals, neighbours, doubtful);
        return;
      }
    }
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
