// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PROJECTED_FACETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PROJECTED_FACETS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Scene {

/*
Points of a picture: to the right, up, to the viewer. They are rounded to integers, once, and what is drawn is right
for the rounded ones: up to most_coordinate, all determinants below are exact in 64 bits. Parts of facets have exact
rational coordinates.
*/
using Grid_point = std::array<std::int64_t, 3>;
using Exact_point = std::array<Exact_rational, 3>;
using Interval_point = std::array<CGAL::Interval_nt<false>, 3>;   // enclosures of them
using Grid_triangle = std::array<Grid_point, 3>;
constexpr std::int64_t most_coordinate = std::int64_t(1) << 18;

template <class NT>
int sign_of(const NT& x)
{
  return (x > 0) - (x < 0);
}

// Throws CGAL::Uncertain_conversion_exception when the interval does not tell.
inline int sign_of(const CGAL::Interval_nt<false>& x) { return CGAL::sign(x).make_certain(); }

// Twice the area of a triangle of the picture, positive if it is counterclockwise.
template <class NT>
NT turn(const std::array<NT, 3>& p, const std::array<NT, 3>& q, const std::array<NT, 3>& r)
{
  return NT((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
}

// Of which sign how much a point is nearer than the plane of a counterclockwise triangle.
template <class NT>
NT height_over(const std::array<std::array<NT, 3>, 3>& plane, const std::array<NT, 3>& p)
{
  std::array<NT, 3> a, b, c;
  for (int i = 0; i < 3; ++i) {
    a[i] = plane[1][i] - plane[0][i];
    b[i] = plane[2][i] - plane[0][i];
    c[i] = p[i] - plane[0][i];
  }
  return NT((a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] +
            (a[0] * b[1] - a[1] * b[0]) * c[2]);
}

// Which of two facets is nearer in some point that both cover, and in some point by more than the rounding explains.
struct Overlap
{
  bool first_is_nearer = false, second_is_nearer = false, first_is_clear = false, second_is_clear = false;
  bool is_empty = true;

  bool is_crossing() const { return first_is_nearer && second_is_nearer; }

  // Of a depth, as a fraction with a positive denominator.
  template <class NT>
  void note(const NT& numerator, const NT& denominator)
  {
    constexpr int rounding = 2;   // units of the grid
    const int sign = sign_of(numerator);
    if (sign > 0) {
      first_is_nearer = true;
      first_is_clear = first_is_clear || sign_of(NT(numerator - rounding * denominator)) > 0;
    } else if (sign < 0) {
      second_is_nearer = true;
      second_is_clear = second_is_clear || sign_of(NT(numerator + rounding * denominator)) < 0;
    }
  }
};

/*
Two convex facets in space, counterclockwise in the picture. The difference of their depths is linear on what both
cover, so that its signs in the corners of that polygon tell all: in corners of one facet that are in the other one, and
where edges cross.
*/
template <class NT>
class Facet_pair
{
  using Point = std::array<NT, 3>;
  using Corners = std::span<const Point>;

  Corners m_first, m_second;
  const std::array<Point, 3>&m_first_plane, &m_second_plane;

public:
  Facet_pair(Corners first, const std::array<Point, 3>& first_plane, Corners second,
             const std::array<Point, 3>& second_plane)
    : m_first(first), m_second(second), m_first_plane(first_plane), m_second_plane(second_plane)
  {
  }

  Overlap overlap() const
  {
    Overlap result;
    if (is_separated(m_first, m_second) || is_separated(m_second, m_first))
      return result;
    result.is_empty = false;
    const NT first_area = turn(m_first_plane[0], m_first_plane[1], m_first_plane[2]),
             second_area = turn(m_second_plane[0], m_second_plane[1], m_second_plane[2]);
    for (const Point& p : m_first)
      if (covers(m_second, p))
        result.note(height_over(m_second_plane, p), second_area);
    for (const Point& p : m_second)
      if (covers(m_first, p))
        result.note(NT(-height_over(m_first_plane, p)), first_area);
    for (std::size_t i = 0; i < m_first.size(); ++i)
      for (std::size_t j = 0; j < m_second.size(); ++j)
        note_crossing(m_first[i], m_first[(i + 1) % m_first.size()], m_second[j], m_second[(j + 1) % m_second.size()],
                      result);
    return result;
  }

  static bool covers(Corners facet, const Point& p)
  {
    for (std::size_t i = 0; i < facet.size(); ++i)
      if (sign_of(turn(facet[i], facet[(i + 1) % facet.size()], p)) < 0)
        return false;
    return true;
  }

private:
  // Whether an edge of one facet has the other one on its outer side.
  static bool is_separated(Corners facet, Corners other)
  {
    for (std::size_t i = 0; i < facet.size(); ++i)
      if (std::all_of(other.begin(), other.end(), [&](const Point& p) {
            return sign_of(turn(facet[i], facet[(i + 1) % facet.size()], p)) <= 0;
          }))
        return true;
    return false;
  }

  // The depths of two edges where their interiors cross.
  static void note_crossing(const Point& p, const Point& q, const Point& r, const Point& s, Overlap& overlap)
  {
    if (sign_of(turn(r, s, p)) * sign_of(turn(r, s, q)) >= 0 || sign_of(turn(p, q, r)) * sign_of(turn(p, q, s)) >= 0)
      return;
    const NT across = NT((q[0] - p[0]) * (s[1] - r[1]) - (q[1] - p[1]) * (s[0] - r[0]));
    const NT along_first = NT((r[0] - p[0]) * (s[1] - r[1]) - (r[1] - p[1]) * (s[0] - r[0]));
    const NT along_second = NT((r[0] - p[0]) * (q[1] - p[1]) - (r[1] - p[1]) * (q[0] - p[0]));
    const NT nearer = NT((p[2] - r[2]) * across + along_first * (q[2] - p[2]) - along_second * (s[2] - r[2]));
    if (sign_of(across) > 0)
      overlap.note(nearer, across);
    else
      overlap.note(NT(-nearer), NT(-across));
  }
};

// A triangle of a mesh as it is seen, or a convex part of it.
struct Facet
{
  std::size_t source;                  // the index of the triangle
  Grid_triangle plane;                 // the triangle, counterclockwise
  std::array<Exact_point, 3> exact_plane;
  std::vector<Exact_point> corners;    // of a part, counterclockwise; empty: all of the triangle
  std::array<Interval_point, 3> plane_in_doubles;
  std::vector<Interval_point> enclosed_corners;
  std::array<double, 4> box;           // least and largest coordinates, rounded outwards

  Facet(std::size_t index, const Grid_triangle& triangle) : source(index), plane(triangle)
  {
    for (int i = 0; i < 3; ++i) {
      exact_plane[i] = exact(plane[i]);
      plane_in_doubles[i] = enclosure(exact_plane[i]);
    }
    enclosed_corners.assign(plane_in_doubles.begin(), plane_in_doubles.end());
    box = box_of(std::vector<Exact_point>(exact_plane.begin(), exact_plane.end()));
  }

  Facet part(std::vector<Exact_point> part_corners) const
  {
    Facet result(*this);
    result.box = box_of(part_corners);
    result.enclosed_corners.clear();
    for (const Exact_point& p : part_corners)
      result.enclosed_corners.push_back(enclosure(p));
    result.corners = std::move(part_corners);
    return result;
  }

  std::span<const Exact_point> outline() const
  {
    return corners.empty() ? std::span<const Exact_point>(exact_plane) : std::span<const Exact_point>(corners);
  }

  static Exact_point exact(const Grid_point& p)
  {
    return {Exact_rational(static_cast<double>(p[0])), Exact_rational(static_cast<double>(p[1])),
            Exact_rational(static_cast<double>(p[2]))};
  }

private:
  static Interval_point enclosure(const Exact_point& p)
  {
    return {CGAL::to_interval(p[0]), CGAL::to_interval(p[1]), CGAL::to_interval(p[2])};
  }

  static std::array<double, 4> box_of(const std::vector<Exact_point>& points)
  {
    std::array<double, 4> result{most_coordinate * 2., most_coordinate * 2., -most_coordinate * 2.,
                                 -most_coordinate * 2.};
    for (const Exact_point& p : points)
      for (int i = 0; i < 2; ++i) {
        result[i] = (std::min)(result[i], CGAL::to_interval(p[i]).first);
        result[i + 2] = (std::max)(result[i + 2], CGAL::to_interval(p[i]).second);
      }
    return result;
  }
};

// With integers, or intervals, or else rational numbers.
inline Overlap overlap_of(const Facet& a, const Facet& b)
{
  if (a.corners.empty() && b.corners.empty())
    return Facet_pair<std::int64_t>(a.plane, a.plane, b.plane, b.plane).overlap();
  try {
    const CGAL::Protect_FPU_rounding<true> rounding;
    return Facet_pair<CGAL::Interval_nt<false>>(a.enclosed_corners, a.plane_in_doubles, b.enclosed_corners,
                                                b.plane_in_doubles)
        .overlap();
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return Facet_pair<Exact_rational>(a.outline(), a.exact_plane, b.outline(), b.exact_plane).overlap();
  }
}

// The parts of a facet where a linear function, given by its values in the corners, is not negative, and not positive.
inline std::array<std::vector<Exact_point>, 2> split_outline(std::span<const Exact_point> outline,
                                                             const std::vector<Exact_rational>& values)
{
  std::array<std::vector<Exact_point>, 2> result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    const int here = sign_of(values[i]), there = sign_of(values[next]);
    if (here >= 0)
      result[0].push_back(outline[i]);
    if (here <= 0)
      result[1].push_back(outline[i]);
    if (here * there < 0) {
      const Exact_rational t(values[i] / (values[i] - values[next]));
      Exact_point at;
      for (int k = 0; k < 3; ++k)
        at[k] = outline[i][k] + t * (outline[next][k] - outline[i][k]);
      result[0].push_back(at);
      result[1].push_back(at);
    }
  }
  return result;
}

} // namespace Scene
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PROJECTED_FACETS_H
