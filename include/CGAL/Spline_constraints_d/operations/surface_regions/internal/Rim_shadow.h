// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RIM_SHADOW_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RIM_SHADOW_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Jet_sheet.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_bundle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
What a surface hides of itself next to its silhouettes, where points on a ray are near its origin.

Rays are seen as points by the projection P along them, from the eye or in parallel, to two coordinates f and g. Where
g_y is not zero, the points with the g of a point p are a graph over x, along which f has the derivative psi =
f_x - f_y g_x / g_y; with m the mean of psi between p and another such point q, both are on one ray if and only if m is
zero. Let q be ahead for greater x, by the sign of the derivative of the depth along the graph. If m is positive for q
at the end of a neighbourhood, a ray from p meets it if and only if the least m from p on is not positive; and if m
decreases for all q while p moves in a direction, with the difference of x the same, so does the least one. The same
holds with other signs. At a fold psi is zero, at a cusp its derivative along the graph is, too; neither is an
exception.
*/
class Rim_shadow
{
  const Jet_sheet& m_sheet;
  std::optional<Interval_vector> m_eye;
  Interval_jet m_source; // of the surface, over the rectangle of p
  Interval_vector m_direction, m_towards, m_across_f, m_across_g;
  std::size_t m_x = 0, m_y = 1; // the axes of parameters

  // The derivatives of f and g by x and y.
  struct Projection
  {
    std::array<std::array<Interval, 2>, 2> first;  // of f, g
    std::array<std::array<Interval, 3>, 2> second; // by xx, xy, yy
  };

public:
  Rim_shadow(const Jet_sheet& sheet, const Ray_bundle& rays, Interval_jet source)
    : m_sheet(sheet), m_eye(rays.eye), m_source(std::move(source)), m_direction(rays.direction.value),
      m_towards(Meeting_function::middle_of(rays.direction.middle))
  {
    const std::array<Interval_vector, 2> across{cross(m_towards, m_source.first[0]),
                                                cross(m_towards, m_source.first[1])};
    const auto size = [](const Interval_vector& v) {
      double result = 0;
      for (const Interval& x : v)
        result += middle_of(x) * middle_of(x);
      return result;
    };
    if (size(across[0]) > size(across[1]))
      std::swap(m_x, m_y);
    m_across_f = Meeting_function::middle_of(across[m_y]);
    m_across_g = Meeting_function::middle_of(cross(m_across_f, m_towards));
  }

  // Directions in which rays come to meet the surface near their origins: in a rectangle that has all parts of the
  // surface, given by the rectangles of `near`, that are not known to be behind or ahead. Calls visit() with such a
  // rectangle and the directions, for greater ones until it returns true.
  template <class Visitor>
  void visit_directions(const std::vector<Parameter_rectangle>& near, const std::array<double, 2>& widths,
                        const Visitor& visit) const
  {
    visit_neighbourhoods(near, [&](const Neighbourhood& around) {
      const int sign = around.is_proved ? sign_at_end(around) : 0;
      if (sign == 0)
        return false;
      const Projection &p = around.source, &q = around.projection;
      const auto [psi_x, psi_y] = gradient(q);
      std::array<Interval, 2> falls;
      falls[m_x] = Interval(-sign) * (psi_x + psi_y * ((p.first[1][0] - q.first[1][0]) / q.first[1][1]));
      falls[m_y] = Interval(-sign) * psi_y * (p.first[1][1] / q.first[1][1]);
      return visit(around.box, Direction_set::increasing(falls, widths));
    });
  }

  // Whether rays from all p meet the surface in its parts `near`, if psi has the sign that it has at one of the points
  // p at all of them, and all of the neighbourhood is near a fold: along the graph psi increases, or decreases.
  std::optional<bool> label_beside_fold(const Interval_jet& one_of_them,
                                        const std::vector<Parameter_rectangle>& near) const
  {
    std::optional<bool> result;
    const auto one = projection(one_of_them);
    if (!one || has_zero(one->first[1][1]))
      return result;
    const Interval begin = psi(*one);
    visit_neighbourhoods(near, [&](const Neighbourhood& around) {
      const auto [psi_x, psi_y] = gradient(around.projection);
      const Interval bend = psi_x + psi_y * around.slope;
      if (!around.is_proved || has_zero(bend) || has_zero(begin))
        return false;
      const bool increases = is_positive(bend) == around.is_ahead_upwards;
      if (increases == is_positive(begin))
        result = false;
      else if (sign_at_end(around) == (increases ? 1 : -1))
        result = true;
      return result.has_value();
    });
    return result;
  }

private:
  static void widen(std::pair<double, double>& range, double by)
  {
    range.first -= by;
    range.second += by;
  }

  static bool contains(const Parameter_rectangle& box, const Parameter_rectangle& part)
  {
    for (const std::size_t axis : {0, 1})
      if (part[axis].first < box[axis].first || part[axis].second > box[axis].second)
        return false;
    return true;
  }

  // A rectangle around all p on which the graphs through them go from end to end.
  struct Neighbourhood
  {
    Parameter_rectangle box;
    double reach; // beyond all p, on both sides
    Projection source, projection;
    Interval slope;
    bool is_proved = false, is_ahead_upwards = false;
  };

  // Calls visit() with rectangles that have all of `near` in them, until it returns true.
  template <class Visitor>
  void visit_neighbourhoods(const std::vector<Parameter_rectangle>& near, const Visitor& visit) const
  {
    const auto p = projection(m_source);
    if (!p || has_zero(p->first[1][1]))
      return;
    const double steepness = std::abs(middle_of(p->first[1][0] / p->first[1][1]));
    const double width = (std::max)(m_source.half_width(m_x), m_source.half_width(m_y));
    for (const double factor : {2.5, 5., 10., 20., 40., 80.}) {
      const double reach = factor * width;
      Parameter_rectangle box = m_source.box;
      widen(box[m_x], reach);
      widen(box[m_y], reach * (1.2 * steepness + 0.15) + width);
      bool covers = true;
      for (const Parameter_rectangle& part : near)
        covers = covers && contains(box, part);
      if (!covers)
        continue;
      const auto around = neighbourhood(box, reach, *p);
      if (!around || visit(*around))
        return;
    }
  }

  std::optional<Neighbourhood> neighbourhood(const Parameter_rectangle& box, double reach, const Projection& p) const
  {
    const auto jet = m_sheet.jet(box, true);
    if (!jet || (m_eye && !is_negative(dot(jet->value - *m_eye, m_direction))))
      return std::nullopt;
    const auto q = projection(*jet);
    if (!q || has_zero(q->first[1][1]))
      return std::nullopt;
    Neighbourhood result{box, reach, p, *q, -(q->first[1][0] / q->first[1][1])};
    const Interval depth = dot(jet->first[m_x], m_direction) + result.slope * dot(jet->first[m_y], m_direction);
    const Interval rise = result.slope * around_zero(reach + 2 * m_source.half_width(m_x));
    result.is_ahead_upwards = is_positive(depth);
    result.is_proved = !has_zero(depth) && m_source.box[m_y].second + rise.sup() <= box[m_y].second &&
        m_source.box[m_y].first + rise.inf() >= box[m_y].first;
    return result;
  }

  // That of the mean of psi from all p to the end of the neighbourhood ahead; 0 if it is not known.
  int sign_at_end(const Neighbourhood& around) const
  {
    constexpr int slabs = 12;
    const double width = 2 * m_source.half_width(m_x);
    Interval sum(0);
    for (int i = -1; i < slabs; ++i) { // behind the part that may be ahead of some p only
      Parameter_rectangle box = m_source.box;
      const double begin = around.reach * i / slabs, end = around.reach * (i + 1) / slabs;
      if (i >= 0) {
        const auto [first, last] = m_source.box[m_x];
        box[m_x] =
            around.is_ahead_upwards ? std::pair(last + begin, last + end) : std::pair(first - end, first - begin);
      }
      const double far = (i < 0 ? 0 : end) + width;
      const Interval rise = around.slope * (around.is_ahead_upwards ? Interval(0, far) : Interval(-far, 0));
      box[m_y] = {-((std::max)(0., -rise.inf()) - m_source.box[m_y].first),
                  m_source.box[m_y].second + (std::max)(0., rise.sup())};
      const auto jet = m_sheet.jet(box, true);
      const auto q = jet ? projection(*jet) : std::nullopt;
      if (!q || has_zero(q->first[1][1]))
        return 0;
      sum += psi(*q) * (i < 0 ? Interval(0, width) : Interval(box[m_x].second) - Interval(box[m_x].first));
    }
    return is_positive(sum) ? 1 : is_negative(sum) ? -1 : 0;
  }

  static Interval psi(const Projection& q) { return q.first[0][0] - q.first[0][1] * q.first[1][0] / q.first[1][1]; }

  // Of psi.
  std::array<Interval, 2> gradient(const Projection& q) const
  {
    const auto& [f, g] = q.first;
    const auto& [ff, gg] = q.second;
    const Interval ratio = g[0] / g[1];
    std::array<Interval, 2> result;
    for (const std::size_t i : {0, 1})
      result[i] = ff[i] - ff[i + 1] * ratio - f[1] * (gg[i] - ratio * gg[i + 1]) / g[1];
    return result;
  }

  // Nothing if points may be as deep as the eye.
  std::optional<Projection> projection(const Interval_jet& jet) const
  {
    const std::array<Interval_vector, 2> along{m_across_f, m_across_g};
    const auto second = [&](std::size_t i, std::size_t j) -> const Interval_vector& { return jet.second[i + j]; };
    const std::array<std::size_t, 2> axes{m_x, m_y};
    Projection result;
    const auto pair = [](std::size_t k) { return std::pair<std::size_t, std::size_t>(k == 2 ? 1 : 0, k == 0 ? 0 : 1); };
    if (!m_eye) {
      for (const std::size_t c : {0, 1}) {
        for (const std::size_t i : {0, 1})
          result.first[c][i] = dot(along[c], jet.first[axes[i]]);
        for (std::size_t k = 0; k < 3; ++k)
          result.second[c][k] = dot(along[c], second(axes[pair(k).first], axes[pair(k).second]));
      }
      return result;
    }
    const Interval_vector from_eye = jet.value - *m_eye;
    const Interval z = dot(m_towards, from_eye);
    if (has_zero(z))
      return std::nullopt;
    for (const std::size_t c : {0, 1}) {
      const Interval place = dot(along[c], from_eye) / z;
      const auto slope = [&](std::size_t i) {
        return (dot(along[c], jet.first[axes[i]]) - place * dot(m_towards, jet.first[axes[i]])) / z;
      };
      for (const std::size_t i : {0, 1})
        result.first[c][i] = slope(i);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [i, j] = pair(k);
        const Interval_vector& s = second(axes[i], axes[j]);
        result.second[c][k] =
            (dot(along[c], s) - place * dot(m_towards, s) - slope(i) * dot(m_towards, jet.first[axes[j]]) -
             slope(j) * dot(m_towards, jet.first[axes[i]])) /
            z;
      }
    }
    return result;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RIM_SHADOW_H
