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
exception. If graphs end at an edge ahead, psi at p may be positive instead, if p does not move towards the edge.
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
      m_towards(m_eye ? Meeting_function::middle_of(rays.direction.middle) : rays.direction.middle)
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
    set_coordinates();
  }

  // Whether an end of the surface may be in one of the neighbourhoods.
  bool is_near_end() const
  {
    const double reach = smallest_reach() * std::exp2(number_of_sizes());
    for (const std::size_t axis : {0, 1}) {
      const auto [begin, end] = m_sheet.domain(axis);
      if (m_sheet.period(axis) == 0 &&
          (m_source.box[axis].first - reach < begin || m_source.box[axis].second + reach > end))
        return true;
    }
    return false;
  }

  // The same with the axes in the other order, as where graphs end at an edge along the first one.
  Rim_shadow with_other_axes() const
  {
    Rim_shadow result(*this);
    std::swap(result.m_x, result.m_y);
    result.set_coordinates();
    return result;
  }

  // Directions in which rays come to meet the surface near their origins: in a rectangle that has all parts of the
  // surface, given by the rectangles of `near`, that are not known to be behind or ahead. Calls visit() with such a
  // rectangle and the directions, for greater ones until it returns true.
  template <class Visitor>
  void visit_directions(const std::vector<Parameter_rectangle>& near, const std::array<double, 2>& widths,
                        const Visitor& visit) const
  {
    visit_neighbourhoods(near, [&](const Neighbourhood& around) {
      const Projection &p = around.source, &q = around.projection;
      const auto [psi_x, psi_y] = gradient(q);
      std::array<Interval, 2> rises; // of psi
      rises[m_x] = psi_x + psi_y * ((p.first[1][0] - q.first[1][0]) / q.first[1][1]);
      rises[m_y] = psi_y * (p.first[1][1] / q.first[1][1]);
      if (!around.is_proved || Direction_set::increasing(rises, widths).is_empty())
        return false;
      const int at_end = sign_at_end(around);
      const bool is_told_by_start = at_end == 0 && around.has_edge_ahead;
      const int sign = is_told_by_start ? sign_of(psi(around.source)) : at_end;
      if (sign == 0)
        return false;
      Direction_set directions =
          Direction_set::increasing({Interval(-sign) * rises[0], Interval(-sign) * rises[1]}, widths);
      if (is_told_by_start)
        directions.restrict_to(Direction_set::not_against(m_x, !around.is_ahead_upwards));
      return visit(around.box, directions);
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
      else if (const int end = sign_at_end(around); end == (increases ? 1 : -1))
        result = true;
      else if (end != 0 && around.has_edge_ahead)
        result = false;
      return result.has_value();
    });
    return result;
  }

  // A fold before an edge in which rays end to meet the surface: with sigma psi increasing along all graphs to their
  // ends at the edge, a ray meets it if and only if sigma psi is negative, and its mean up to the edge is not.
  // Directions in which both increase, and the sign of <O,n> where sigma psi is positive. \pre The rest is not met.
  std::optional<Fold_at_edge> fold_at_edge(const std::vector<Parameter_rectangle>& near,
                                           const std::array<double, 2>& widths) const
  {
    std::optional<Fold_at_edge> result;
    visit_neighbourhoods(near, [&](const Neighbourhood& around) {
      const Projection &p = around.source, &q = around.projection;
      const auto [psi_x, psi_y] = gradient(q);
      const Interval bend = psi_x + psi_y * around.slope;
      if (!around.is_proved || !around.has_edge_ahead || has_zero(bend))
        return false;
      const int sigma = is_positive(bend) == around.is_ahead_upwards ? 1 : -1;
      const Interval share(0, 1); // of the way of p, that a point of its graph goes along x
      std::array<Interval, 2> rises;
      rises[m_x] =
          Interval(sigma) * (share * psi_x + psi_y * ((p.first[1][0] - share * q.first[1][0]) / q.first[1][1]));
      rises[m_y] = Interval(sigma) * psi_y * (p.first[1][1] / q.first[1][1]);
      const Direction_set directions = Direction_set::increasing(rises, widths);
      if (directions.is_empty())
        return false;
      // psi = -c <O, S_x x S_y> / g_y, c > 0
      const int turn = is_positive(q.first[1][1]) == (m_x == 0) ? -1 : 1;
      result = Fold_at_edge{directions, sigma * turn, std::pair(m_x, std::size_t(around.is_ahead_upwards ? 1 : 0))};
      return true;
    });
    return result;
  }

private:
  // Exactly the same along parallel rays. From an eye, any coordinates will do.
  void set_coordinates()
  {
    m_across_f = cross(m_towards, Meeting_function::middle_of(m_source.first[m_y]));
    m_across_g = cross(m_across_f, m_towards);
  }

  // One point has neighbourhoods of all sizes.
  double own_width() const { return (std::max)(m_source.half_width(m_x), m_source.half_width(m_y)); }
  bool is_point() const { return own_width() < 0x1p-40; }
  double smallest_reach() const { return 1.25 * (is_point() ? 0x1p-26 : own_width()); } // without a doubling
  int number_of_sizes() const { return is_point() ? 20 : 6; }

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
    Projection source, projection;
    Interval slope;
    bool is_proved = false, is_ahead_upwards = false;
    bool has_edge_ahead = false; // where the graphs end
  };

  // Calls visit() with rectangles that have all of `near` in them, until it returns true.
  template <class Visitor>
  void visit_neighbourhoods(const std::vector<Parameter_rectangle>& near, const Visitor& visit) const
  {
    const auto p = projection(m_source);
    if (!p || has_zero(p->first[1][1]))
      return;
    const double steepness = std::abs(middle_of(p->first[1][0] / p->first[1][1]));
    double reach = smallest_reach();
    for (int i = 0; i < number_of_sizes(); ++i) {
      reach *= 2;
      Parameter_rectangle box = m_source.box;
      widen(box[m_x], reach);
      widen(box[m_y], (reach + 2 * m_source.half_width(m_x)) * (1.2 * steepness + 0.15) + own_width());
      const std::array<bool, 2> is_cut = cut_at_ends(box, m_x);
      cut_at_ends(box, m_y);
      bool covers = true;
      for (const Parameter_rectangle& part : near)
        covers = covers && contains(box, part);
      if (!covers)
        continue;
      const auto around = neighbourhood(box, is_cut, *p);
      if (!around || visit(*around))
        return;
    }
  }

  // Whether ends of the surface are in the way.
  std::array<bool, 2> cut_at_ends(Parameter_rectangle& box, std::size_t axis) const
  {
    if (m_sheet.period(axis) > 0)
      return {false, false};
    const auto [begin, end] = m_sheet.domain(axis);
    const bool is_cut_below = box[axis].first < begin, is_cut_above = end < box[axis].second;
    box[axis] = {(std::max)(box[axis].first, begin), (std::min)(box[axis].second, end)};
    return {is_cut_below, is_cut_above};
  }

  std::optional<Neighbourhood> neighbourhood(const Parameter_rectangle& box, const std::array<bool, 2>& is_cut,
                                             const Projection& p) const
  {
    const auto jet = m_sheet.jet(box, true);
    if (!jet || (m_eye && !is_negative(dot(jet->value - *m_eye, m_direction))))
      return std::nullopt;
    const auto q = projection(*jet);
    if (!q || has_zero(q->first[1][1]))
      return std::nullopt;
    Neighbourhood result{box, p, *q, -(q->first[1][0] / q->first[1][1])};
    const Interval depth = dot(jet->first[m_x], m_direction) + result.slope * dot(jet->first[m_y], m_direction);
    const auto& [first, last] = m_source.box[m_x];
    const Interval rise = result.slope * (Interval(box[m_x].first, box[m_x].second) - Interval(first, last));
    result.is_ahead_upwards = is_positive(depth);
    result.has_edge_ahead = is_cut[result.is_ahead_upwards ? 1 : 0];
    result.is_proved = !has_zero(depth) && m_source.box[m_y].second + rise.sup() <= box[m_y].second &&
        m_source.box[m_y].first + rise.inf() >= box[m_y].first;
    return result;
  }

  static int sign_of(const Interval& x) { return is_positive(x) ? 1 : is_negative(x) ? -1 : 0; }

  // The range of a function on the part of the graphs between distances from the range of all p, or in this.
  struct Slab
  {
    Interval psi, bend; // along the graphs, upwards
  };

  std::optional<Slab> slab(const Neighbourhood& around, double begin, double end, bool is_source) const
  {
    const auto& [first, last] = m_source.box[m_x];
    const bool is_upwards = around.is_ahead_upwards;
    Parameter_rectangle box = m_source.box;
    if (!is_source)
      box[m_x] = is_upwards
          ? std::pair((std::min)(last + begin, around.box[m_x].second), (std::min)(last + end, around.box[m_x].second))
          : std::pair((std::max)(first - end, around.box[m_x].first), (std::max)(first - begin, around.box[m_x].first));
    const Interval distance = Interval(box[m_x].first, box[m_x].second) - Interval(first, last);
    const Interval rise = around.slope *
        (is_upwards ? Interval((std::max)(distance.inf(), 0.), distance.sup())
                    : Interval(distance.inf(), (std::min)(distance.sup(), 0.)));
    const Interval place = Interval(m_source.box[m_y].first, m_source.box[m_y].second) + rise;
    box[m_y] = {(std::max)(place.inf(), around.box[m_y].first), (std::min)(place.sup(), around.box[m_y].second)};
    const auto jet = m_sheet.jet(box, true);
    const auto q = jet ? projection(*jet) : std::nullopt;
    if (!q || has_zero(q->first[1][1]))
      return std::nullopt;
    const auto [psi_x, psi_y] = gradient(*q);
    return Slab{psi(*q), psi_x - psi_y * (q->first[1][0] / q->first[1][1])};
  }

  // That of the mean of psi from all p to the end of the neighbourhood ahead; 0 if it is not known.
  int sign_at_end(const Neighbourhood& around) const
  {
    constexpr int slabs = 12;
    const auto& [first, last] = m_source.box[m_x];
    const Interval length = around.is_ahead_upwards ? Interval(around.box[m_x].second) - Interval(last)
                                                    : Interval(first) - Interval(around.box[m_x].first);
    const Interval width = Interval(last) - Interval(first), up(around.is_ahead_upwards ? 1 : -1);
    const auto own = slab(around, 0, 0, true); // the part that may be ahead of some p only
    if (!own)
      return 0;
    const Interval start = psi(around.source), within(0, width.sup());
    const Interval psi_at_own = common(own->psi, start + up * own->bend * within);
    Interval sum(0), begin = start + up * own->bend * within;
    for (int i = 0; i < slabs && length.sup() > 0; ++i) {
      const auto part = slab(around, length.sup() * i / slabs, length.sup() * (i + 1) / slabs, false);
      if (!part)
        return 0;
      const Interval step = length / Interval(slabs);
      sum += common(part->psi, begin + up * part->bend * Interval(0, step.sup())) * step;
      begin += up * part->bend * step;
    }
    const Interval all = sum + psi_at_own * within;
    const bool is_up = (sum.inf() >= 0 && is_positive(psi_at_own)) || (is_positive(sum) && is_positive(all));
    const bool is_down = (sum.sup() <= 0 && is_negative(psi_at_own)) || (is_negative(sum) && is_negative(all));
    return is_up ? 1 : is_down ? -1 : 0;
  }

  // Of two ranges of the same numbers.
  static Interval common(const Interval& a, const Interval& b)
  {
    const double lower = (std::max)(a.inf(), b.inf()), upper = (std::min)(a.sup(), b.sup());
    return lower <= upper ? Interval(lower, upper) : a;
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
