// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_EVENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_EVENTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Jet_sheet.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_bundle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Whether each ray of a bundle meets a sheet near a point that is found by Newton's method: Miranda's theorem for two
// components of F, multiplied by the inverse of their derivative there, on a rectangle around it.
class Hit_test
{
  const Ray_bundle& m_rays;
  const Jet_sheet& m_sheet;
  std::array<std::size_t, 2> m_components{};

public:
  Hit_test(const Ray_bundle& rays, const Jet_sheet& sheet) : m_rays(rays), m_sheet(sheet) {}

  bool operator()(const Interval_jet& start)
  {
    const std::optional<std::size_t> along = component_of_direction();
    if (!along)
      return false;
    m_components = {(*along + 1) % 3, (*along + 2) % 3};
    std::array<double, 2> q{middle_of(start.box[0]), middle_of(start.box[1])};
    const std::array<double, 2> reach{4 * start.half_width(0), 4 * start.half_width(1)};
    const std::array<double, 2> first = q;
    std::array<double, 2> spread{};
    constexpr int steps = 5;
    for (int i = 0; i < steps; ++i) {
      const auto jet = m_sheet.jet({{{q[0], q[0]}, {q[1], q[1]}}}, false);
      if (!jet)
        return false;
      const Meeting_function f(m_rays, *jet);
      const auto inverse = inverse_of(f);
      if (!inverse)
        return false;
      for (const std::size_t k : {0, 1}) {
        q[k] -= middle_of(product(*inverse, k, f.middle));
        spread[k] = 0;
        for (const std::size_t axis : {0, 1}) {
          const Interval moved = product(*inverse, k, f.by_ray[axis]);
          spread[k] += (std::max)(moved.sup(), -moved.inf()) * f.ray[axis].sup();
        }
        if (!(std::abs(q[k] - first[k]) <= reach[k]))
          return false;
      }
    }
    for (const double factor : {1.4, 3.})
      if (is_met_around(q, {factor * spread[0] + 1e-7 * reach[0], factor * spread[1] + 1e-7 * reach[1]}))
        return true;
    return false;
  }

private:
  using Matrix = std::array<std::array<Interval, 2>, 2>;

  // One that is nowhere zero: then two other components of F are zero only where F is.
  std::optional<std::size_t> component_of_direction() const
  {
    std::optional<std::size_t> result;
    double greatest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Interval& x = m_rays.direction.value[c];
      const double least = (std::max)(x.inf(), -x.sup());
      if (least > greatest) {
        greatest = least;
        result = c;
      }
    }
    return result;
  }

  std::optional<Matrix> inverse_of(const Meeting_function& f) const
  {
    std::array<std::array<double, 2>, 2> m;
    for (const std::size_t i : {0, 1})
      for (const std::size_t j : {0, 1})
        m[i][j] = middle_of(f.by_other[j][m_components[i]]);
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    if (!(std::abs(determinant) > 0))
      return std::nullopt;
    return Matrix{{{Interval(m[1][1] / determinant), Interval(-m[0][1] / determinant)},
                   {Interval(-m[1][0] / determinant), Interval(m[0][0] / determinant)}}};
  }

  Interval product(const Matrix& m, std::size_t row, const Interval_vector& v) const
  {
    return m[row][0] * v[m_components[0]] + m[row][1] * v[m_components[1]];
  }

  bool is_met_around(const std::array<double, 2>& q, const std::array<double, 2>& radius) const
  {
    const auto jet = m_sheet.jet({{{q[0] - radius[0], q[0] + radius[0]}, {q[1] - radius[1], q[1] + radius[1]}}}, false);
    if (!jet || !m_rays.faces(*jet))
      return false;
    const Meeting_function f(m_rays, *jet);
    const auto inverse = inverse_of(f);
    if (!inverse)
      return false;
    for (const std::size_t k : {0, 1}) {
      Interval rest = product(*inverse, k, f.middle);
      for (const std::size_t axis : {0, 1})
        rest += product(*inverse, k, f.by_ray[axis]) * f.ray[axis];
      rest += product(*inverse, k, f.by_other[1 - k]) * f.other[1 - k];
      // From the middle to the sides, which are not less than this far away.
      const Interval slope = product(*inverse, k, f.by_other[k]);
      const auto [begin, end] = jet->box[k];
      const double middle = middle_of(jet->box[k]);
      if (!is_positive(rest + slope * (Interval(end) - Interval(middle))) ||
          !is_negative(rest - slope * (Interval(middle) - Interval(begin))))
        return false;
    }
    return true;
  }
};

/*
Whether each ray of a bundle meets a sheet in a rectangle, by the degree of F: along the boundary of the rectangle F
winds around zero. So it is near cusps of contours, where three points of the sheet on a ray become one.
*/
class Winding_test
{
  const Ray_bundle& m_rays;
  const Jet_sheet& m_sheet;
  std::array<std::size_t, 2> m_components;
  int m_quarter_turns = 0;
  std::optional<int> m_last;

public:
  Winding_test(const Ray_bundle& rays, const Jet_sheet& sheet, std::size_t along)
    : m_rays(rays), m_sheet(sheet), m_components{(along + 1) % 3, (along + 2) % 3}
  {}

  bool operator()(const Parameter_rectangle& box)
  {
    const auto jet = m_sheet.jet(box, false);
    if (!jet || !m_rays.faces(*jet))
      return false;
    const auto [u, v] = std::pair(box[0], box[1]);
    constexpr int depth = 5;
    const auto side = [&](double a, double b, double c, double d) { return add(a, b, c, d, depth); };
    const bool is_known = side(u.first, v.first, u.second, v.first) && side(u.second, v.first, u.second, v.second) &&
        side(u.second, v.second, u.first, v.second) && side(u.first, v.second, u.first, v.first) &&
        side(u.first, v.first, u.second, v.first); // the first one again closes the path
    return is_known && m_quarter_turns / 4 != 0;
  }

private:
  // Along a segment from one point of parameters to another one: in which of four half-planes F is on all of it.
  bool add(double u, double v, double to_u, double to_v, int depth)
  {
    const auto jet = m_sheet.jet({{std::minmax(u, to_u), std::minmax(v, to_v)}}, false);
    if (!jet)
      return false;
    const Meeting_function f(m_rays, *jet);
    const Interval x = f.component(m_components[0]), y = f.component(m_components[1]);
    const int half_plane = is_positive(x) ? 0 : is_positive(y) ? 1 : is_negative(x) ? 2 : is_negative(y) ? 3 : 4;
    if (half_plane < 4) {
      if (m_last)
        m_quarter_turns += (half_plane - *m_last + 5) % 4 - 1;
      m_last = half_plane;
      return true;
    }
    const double middle_u = 0.5 * (u + to_u), middle_v = 0.5 * (v + to_v);
    return depth > 0 && add(u, v, middle_u, middle_v, depth - 1) && add(middle_u, middle_v, to_u, to_v, depth - 1);
  }
};

/*
Directions in the parameters of the source in which a ray can only come to meet the part of a sheet that a node is, and
not leave it. With n = K_s x K_t and the velocity V = S_d + l O_d of its point at K for a step in the direction d, a ray
that meets K

- touches it where <n,O> = 0: it comes to meet it if II(O) <n,V> > 0 for the second fundamental form with respect to n;
- has K in its beginning where l = 0: l changes by -<n,V>/<n,O>;
- passes an edge where s or t is constant: s changes by <V, K_t x O>/<n,O>, and t by <V, O x K_s>/<n,O>.
*/
inline Direction_set directions_into(const Ray_bundle& rays, Jet_sheet& sheet, const Jet_sheet::Node& node,
                                     const std::array<double, 2>& widths)
{
  const Interval_jet& k = node.jet;
  const Interval_vector &o = rays.direction.value, n = cross(k.first[0], k.first[1]);
  const Interval slope = dot(n, o), length = rays.length(k);
  const bool is_ahead = is_positive(rays.ahead(k));
  Direction_set result = Direction_set::all();
  if (!rays.is_before_end(k))
    return Direction_set();
  std::array<Interval_vector, 2> velocity;
  for (const std::size_t i : {0, 1})
    velocity[i] = rays.origin.first[i] + length * rays.direction.first[i];
  const auto restrict_to = [&](const Interval& factor, const Interval_vector& along) {
    result.restrict_to(
        Direction_set::increasing({factor * dot(along, velocity[0]), factor * dot(along, velocity[1])}, widths));
  };
  if (has_zero(slope)) {
    if (!is_ahead || node.has_edge())
      return Direction_set();
    sheet.full_jet(node);
    const Interval a = dot(cross(o, k.first[1]), n), b = dot(cross(k.first[0], o), n);
    restrict_to(a * a * dot(n, k.second[0]) + Interval(2) * a * b * dot(n, k.second[1]) + b * b * dot(n, k.second[2]),
                n);
    return result;
  }
  const Interval sign(is_positive(slope) ? 1 : -1);
  if (!is_ahead)
    restrict_to(-sign, n);
  for (const std::size_t axis : {0, 1})
    for (const std::size_t end : {0, 1})
      if (node.has_edge(axis, end))
        restrict_to(end == 0 ? sign : -sign, axis == 0 ? cross(k.first[1], o) : cross(o, k.first[0]));
  return result;
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_EVENTS_H
