// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PATCH_INVERSE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PATCH_INVERSE_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Bernstein_net.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

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
namespace Intersections {

// The parameters of points of a patch.
class Patch_inverse
{
  using Parameters = std::array<double, 2>;
  using Coordinates = std::array<double, 3>;

  Surface_shape m_surface;
  std::array<std::pair<double, double>, 2> m_domain;
  std::array<bool, 2> m_is_closed;
  std::vector<std::pair<Parameters, Coordinates>> m_samples;

public:
  // \pre It is parametric.
  explicit Patch_inverse(const Surface_shape& surface);

  // The nearest that Newton's method finds in doubles, from the nearest sample.
  Parameters operator()(const Coordinates& target) const;

  // Ranges that have all parameters of the points in some bounds; near a seam they begin before it. In intervals of
  // doubles, which tell enough.
  std::array<Parameter_range, 2> ranges(const Vector_bounds<3>& bounds) const;

private:
  struct Part
  {
    std::array<Parameter_range, 2> ranges;
    Bernstein_net<3> net;
  };

  // The cells that may have points in some bounds.
  std::vector<Part> parts_in(const Double_intervals<3>& target) const;

  static std::array<Part, 2> halves(const Part& part, int axis);

  static bool may_meet(const Bernstein_net<3>& net, const Double_intervals<3>& target);

  // Of all parts, or the whole domain where there are none; where an axis is closed and they are next to its ends, of
  // those at its upper end a period before.
  Parameter_range range(const std::vector<Part>& parts, int axis) const;

  Coordinates point(const Parameters& uv) const { return m_surface.point(std::vector<double>{uv[0], uv[1]}); }

  static double squared_distance(const Coordinates& a, const Coordinates& b);

  // Closed axes go on at their other end.
  Parameters within(Parameters uv) const;

  // The least squares of the linear equations.
  Parameters newton_step(const Parameters& uv, const Coordinates& target) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Patch_inverse::Patch_inverse(const Surface_shape& surface) : m_surface(surface)
{
  constexpr int samples_of_cell = 4;
  std::array<std::vector<double>, 2> places;
  for (int axis = 0; axis < 2; ++axis) {
    m_is_closed[axis] = surface.patch->is_closed(axis);
    const std::vector<Exact_rational> breaks = surface.patch->breaks(axis);
    m_domain[axis] = {CGAL::to_double(breaks.front()), CGAL::to_double(breaks.back())};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      for (int k = 0; k < samples_of_cell; ++k) {
        const double begin = CGAL::to_double(breaks[i]), end = CGAL::to_double(breaks[i + 1]);
        places[axis].push_back(begin + (end - begin) * (k + 0.5) / samples_of_cell);
      }
  }
  for (const double u : places[0])
    for (const double v : places[1])
      m_samples.push_back({{u, v}, point({u, v})});
}

CGAL_SPLINE_CONSTRAINTS_INLINE Patch_inverse::Parameters Patch_inverse::operator()(const Coordinates& target) const
{
  const auto nearest = std::min_element(m_samples.begin(), m_samples.end(), [&](const auto& a, const auto& b) {
    return squared_distance(a.second, target) < squared_distance(b.second, target);
  });
  Parameters result = nearest->first;
  double error = squared_distance(nearest->second, target);
  constexpr int most_steps = 40, most_halvings = 8;
  for (int step = 0; step < most_steps && error > 0; ++step) {
    const Parameters move = newton_step(result, target);
    double factor = 1;
    int halvings = 0;
    for (; halvings < most_halvings; ++halvings, factor /= 2)
      if (const Parameters next = within({result[0] + factor * move[0], result[1] + factor * move[1]});
          squared_distance(point(next), target) < error) {
        result = next;
        error = squared_distance(point(next), target);
        break;
      }
    if (halvings == most_halvings)
      break;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Parameter_range, 2>
Patch_inverse::ranges(const Vector_bounds<3>& bounds) const
{
  constexpr int halvings = 24;
  constexpr std::size_t most_parts = 64;
  const Upward_rounding_guard guard;
  Double_intervals<3> target;
  for (std::size_t i = 0; i < 3; ++i)
    target[i] = {to_double_interval(bounds[i].lower).first, to_double_interval(bounds[i].upper).second};
  std::vector<Part> parts = parts_in(target);
  for (int k = 0; k < halvings && parts.size() < most_parts; ++k) {
    std::vector<Part> next;
    for (const Part& part : parts)
      for (Part& half : halves(part, k % 2))
        if (may_meet(half.net, target))
          next.push_back(std::move(half));
    if (next.empty())
      break;
    parts = std::move(next);
  }
  return {range(parts, 0), range(parts, 1)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Patch_inverse::Part>
Patch_inverse::parts_in(const Double_intervals<3>& target) const
{
  const Spline_patch<3>& patch = *m_surface.patch;
  const std::array<std::vector<Exact_rational>, 2> breaks{patch.breaks(0), patch.breaks(1)};
  std::vector<Part> result;
  for (std::size_t i = 1; i < breaks[0].size(); ++i)
    for (std::size_t j = 1; j < breaks[1].size(); ++j) {
      const Parameter_range u(breaks[0][i - 1], breaks[0][i]), v(breaks[1][j - 1], breaks[1][j]);
      Part part{{u, v}, Bernstein_net<3>(patch.part({u, v}))};
      if (may_meet(part.net, target))
        result.push_back(std::move(part));
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Patch_inverse::Part, 2> Patch_inverse::halves(const Part& part, int axis)
{
  std::array<Bernstein_net<3>, 2> nets = part.net.halves(axis);
  std::array<Part, 2> result{Part{part.ranges, std::move(nets[0])}, Part{part.ranges, std::move(nets[1])}};
  result[0].ranges[axis].second = result[1].ranges[axis].first = middle_of(part.ranges[axis]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Patch_inverse::may_meet(const Bernstein_net<3>& net,
                                                            const Double_intervals<3>& target)
{
  if (!net.has_bounds())
    return true;
  const Double_intervals<3> values = net.values();
  for (std::size_t i = 0; i < 3; ++i)
    if (values[i].sup() < target[i].inf() || target[i].sup() < values[i].inf())
      return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Parameter_range Patch_inverse::range(const std::vector<Part>& parts, int axis) const
{
  const auto [begin, end] = m_surface.patch->domain(axis);
  const Exact_rational quarter((end - begin) / 4);
  const auto is_low = [&, low = Exact_rational(begin + quarter)](const Part& part) {
    return part.ranges[axis].second <= low;
  };
  const auto is_high = [&, high = Exact_rational(end - quarter)](const Part& part) {
    return high <= part.ranges[axis].first;
  };
  const bool is_at_seam = m_is_closed[axis] && std::any_of(parts.begin(), parts.end(), is_low) &&
      std::any_of(parts.begin(), parts.end(), is_high) &&
      std::all_of(parts.begin(), parts.end(), [&](const Part& part) { return is_low(part) || is_high(part); });
  std::optional<Parameter_range> result;
  for (const Part& part : parts) {
    const Exact_rational shift(is_at_seam && is_high(part) ? end - begin : Exact_rational(0));
    const Exact_rational lower(part.ranges[axis].first - shift), upper(part.ranges[axis].second - shift);
    result = result ? Parameter_range((std::min)(result->first, lower), (std::max)(result->second, upper))
                    : Parameter_range(lower, upper);
  }
  return result ? *result : Parameter_range(begin, end);
}

CGAL_SPLINE_CONSTRAINTS_INLINE double Patch_inverse::squared_distance(const Coordinates& a, const Coordinates& b)
{
  double result = 0;
  for (std::size_t i = 0; i < 3; ++i)
    result += (a[i] - b[i]) * (a[i] - b[i]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Patch_inverse::Parameters Patch_inverse::within(Parameters uv) const
{
  for (int axis = 0; axis < 2; ++axis) {
    const auto [begin, end] = m_domain[axis];
    if (m_is_closed[axis] && (uv[axis] < begin || uv[axis] > end))
      uv[axis] -= (end - begin) * std::floor((uv[axis] - begin) / (end - begin));
    uv[axis] = (std::min)((std::max)(uv[axis], begin), end);
  }
  return uv;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Patch_inverse::Parameters Patch_inverse::newton_step(const Parameters& uv,
                                                                                    const Coordinates& target) const
{
  const Coordinates x = point(uv);
  std::array<Coordinates, 2> tangents;
  for (int axis = 0; axis < 2; ++axis) {
    const auto [begin, end] = m_domain[axis];
    const double h = (end - begin) * 0x1p-26 * (uv[axis] > (begin + end) / 2 ? -1 : 1);
    Parameters moved = uv;
    moved[axis] += h;
    const Coordinates y = point(moved);
    for (std::size_t i = 0; i < 3; ++i)
      tangents[axis][i] = (y[i] - x[i]) / h;
  }
  std::array<std::array<double, 2>, 2> products{};
  Parameters right{};
  for (int axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < 3; ++i) {
      for (int other = 0; other < 2; ++other)
        products[axis][other] += tangents[axis][i] * tangents[other][i];
      right[axis] += tangents[axis][i] * (target[i] - x[i]);
    }
  for (int axis = 0; axis < 2; ++axis)
    products[axis][axis] += 1e-12 * (products[0][0] + products[1][1]); // at poles a tangent is zero
  const double determinant = products[0][0] * products[1][1] - products[0][1] * products[1][0];
  if (!(determinant > 0))
    return {};
  return {(right[0] * products[1][1] - right[1] * products[0][1]) / determinant,
          (right[1] * products[0][0] - right[0] * products[1][0]) / determinant};
}
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PATCH_INVERSE_H
