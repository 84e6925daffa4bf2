// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_HIDDEN_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_HIDDEN_PARTS_H

#include <CGAL/Spline_constraints_d/IO/internal/scene/Picture_grid.h>
#include <CGAL/Spline_constraints_d/IO/internal/scene/Projected_facets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Scene {

// A part of a segment, by its parameters in [0,1].
struct Segment_part
{
  Exact_rational begin, end;
  bool is_hidden;
};

/*
What triangles hide of segments and points: what is strictly behind them, their edges included. Exact for the rounded
triangles. Complexity: a comparison per triangle whose box is met in the picture.
*/
class Hidden_parts
{
  const std::vector<Grid_triangle>& m_triangles;   // counterclockwise, or without an area
  Picture_grid m_grid;

public:
  Hidden_parts(const std::array<double, 4>& picture, const std::vector<Grid_triangle>& triangles)
    : m_triangles(triangles), m_grid(picture, triangles.size())
  {
    for (const Grid_triangle& t : triangles)
      m_grid.add(box_of(t));
  }

  bool is_hidden(const Grid_point& p) const
  {
    bool result = false;
    m_grid.visit(box_of(std::array<Grid_point, 1>{p}), [&](std::size_t i) {
      const Grid_triangle& t = m_triangles[i];
      result = result ||
          (turn(t[0], t[1], t[2]) > 0 && Facet_pair<std::int64_t>::covers(t, p) && height_over(t, p) < 0);
    });
    return result;
  }

  // The parts of a segment from p to q, one after the other.
  std::vector<Segment_part> parts(const Grid_point& p, const Grid_point& q) const
  {
    std::vector<std::pair<Exact_rational, Exact_rational>> hidden;
    m_grid.visit(box_of(std::array<Grid_point, 2>{p, q}),
                 [&](std::size_t i) { add_hidden(m_triangles[i], p, q, hidden); });
    std::sort(hidden.begin(), hidden.end());
    std::vector<Segment_part> result;
    Exact_rational reached(0);
    for (const auto& [begin, end] : hidden) {
      if (begin > reached)
        result.push_back({reached, begin, false});
      if (end <= reached)
        continue;
      if (result.empty() || !result.back().is_hidden)
        result.push_back({(std::max)(begin, reached), end, true});
      result.back().end = reached = end;
    }
    if (reached < 1)
      result.push_back({reached, Exact_rational(1), false});
    return result;
  }

private:
  template <class Points>
  static std::array<double, 4> box_of(const Points& points)
  {
    std::array<double, 4> result{most_coordinate * 2., most_coordinate * 2., -most_coordinate * 2.,
                                 -most_coordinate * 2.};
    for (const Grid_point& p : points)
      for (int k = 0; k < 2; ++k) {
        result[k] = (std::min)(result[k], static_cast<double>(p[k]));
        result[k + 2] = (std::max)(result[k + 2], static_cast<double>(p[k]));
      }
    return result;
  }

  // Where the segment is within all edges and behind the plane.
  static void add_hidden(const Grid_triangle& t, const Grid_point& p, const Grid_point& q,
                         std::vector<std::pair<Exact_rational, Exact_rational>>& hidden)
  {
    if (turn(t[0], t[1], t[2]) <= 0)
      return;
    std::array<std::pair<std::int64_t, std::int64_t>, 4> ends;
    ends[0] = {-height_over(t, p), -height_over(t, q)};
    if (ends[0].first <= 0 && ends[0].second <= 0)
      return;
    for (int i = 0; i < 3; ++i) {
      ends[i + 1] = {turn(t[i], t[(i + 1) % 3], p), turn(t[i], t[(i + 1) % 3], q)};
      if (ends[i + 1].first < 0 && ends[i + 1].second < 0)
        return;
    }
    Exact_rational begin(0), end(1);
    for (const auto& [first, last] : ends)
      if ((first < 0) != (last < 0)) {
        const Exact_rational root = ratio(first, last);
        if (first < 0)
          begin = (std::max)(begin, root);
        else
          end = (std::min)(end, root);
      }
    if (begin < end)
      hidden.emplace_back(std::move(begin), std::move(end));
  }

  // The zero of the linear function with these values at 0 and 1.
  static Exact_rational ratio(std::int64_t first, std::int64_t last)
  {
    const auto exact = [](std::int64_t x) -> Exact_rational {   // of two halves, which are doubles
      constexpr std::int64_t half = std::int64_t(1) << 31;
      return Exact_rational(static_cast<double>(x / half)) * static_cast<double>(half) + static_cast<double>(x % half);
    };
    const Exact_rational a(exact(first)), b(exact(last));
    return Exact_rational(a / (a - b));
  }
};

} // namespace Scene
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_HIDDEN_PARTS_H
