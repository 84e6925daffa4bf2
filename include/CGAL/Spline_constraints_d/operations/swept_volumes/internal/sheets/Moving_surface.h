// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_MOVING_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_MOVING_SURFACE_H

#include <CGAL/Spline_constraints_d/function/internal/Values_at_point.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_complex.h>

#include <CGAL/determinant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Two parameters of a surface, and a time.
using Place = std::array<double, 3>;

// The velocity of a moving surface T times its normal T_u x T_v.
template <class NT>
NT speed_along_normal(const std::array<Bspline_function<NT>, 3>& numerators, const Bspline_function<NT>& weight,
                      const std::array<std::array<Bspline_function<NT>, 3>, 4>& columns,
                      const Bspline_function<NT>& motion_weight, const std::array<NT, 3>& place)
{
  const std::span<const NT> parameters(place.data(), 2), time(place.data() + 2, 1);
  const auto s = weight.value_and_gradient(parameters);
  const auto w = motion_weight.value_and_gradient(time);
  std::array<NT, 3> x, velocity;
  std::array<std::array<NT, 3>, 2> along, tangent{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto f = numerators[i].value_and_gradient(parameters);
    x[i] = f.value / s.value;
    for (std::size_t j = 0; j < 2; ++j)
      along[j][i] = (f.gradient[j] - x[i] * s.gradient[j]) / s.value;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = columns[3][i].value_and_gradient(time);
    NT value = c.value, change = c.gradient[0];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto m = columns[k][i].value_and_gradient(time);
      value += m.value * x[k];
      change += m.gradient[0] * x[k];
      for (std::size_t j = 0; j < 2; ++j)
        tangent[j][i] += m.value * along[j][k];
    }
    velocity[i] = change - value / w.value * w.gradient[0];
  }
  return CGAL::determinant(velocity[0], velocity[1], velocity[2], tangent[0][0], tangent[0][1], tangent[0][2],
                           tangent[1][0], tangent[1][1], tangent[1][2]);
}

// A moving surface in doubles, but for signs.
class Moving_surface
{
  using Function = Bspline_function<double>;
  using Point = Double_kernel::Point_3;

  const Common::Spline_patch<3>& m_surface;
  const Rational_motion_3& m_motion;
  bool m_has_outer_normals; // T_u x T_v points outwards
  std::array<Function, 3> m_numerators;
  Function m_weight;
  std::array<std::array<Function, 3>, 4> m_columns;
  Function m_motion_weight;
  Place m_lower, m_upper;
  mutable double m_time = std::numeric_limits<double>::quiet_NaN(); // of the map that is known
  mutable std::array<std::array<double, 3>, 4> m_map;

public:
  Moving_surface(const Common::Spline_patch<3>& surface, const Rational_motion_3& motion, bool has_outer_normals)
    : m_surface(surface), m_motion(motion), m_has_outer_normals(has_outer_normals)
  {
    for (std::size_t i = 0; i < 3; ++i)
      m_numerators[i] = in_doubles(surface.numerators()[i]);
    m_weight = in_doubles(surface.weight());
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        m_columns[k][i] = in_doubles(motion.columns()[k][i]);
    m_motion_weight = in_doubles(motion.weight());
    for (int axis = 0; axis < 3; ++axis) {
      const auto& [begin, end] = axis < 2 ? surface.domain(axis) : motion.domain();
      m_lower[static_cast<std::size_t>(axis)] = to_nearest_double(begin);
      m_upper[static_cast<std::size_t>(axis)] = to_nearest_double(end);
    }
  }

  Point operator()(const Place& place) const
  {
    const Values_at_point<double> value(m_weight, std::span<const double>(place.data(), 2));
    const double s = value(m_weight);
    const std::array<double, 3> x{value(m_numerators[0]) / s, value(m_numerators[1]) / s, value(m_numerators[2]) / s};
    if (!(place[2] == m_time))
      set_time(place[2]);
    const auto coordinate = [&](std::size_t i) {
      return m_map[0][i] * x[0] + m_map[1][i] * x[1] + m_map[2][i] * x[2] + m_map[3][i];
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
  }

  // How fast the surface moves along T_u x T_v, times the length of that, about.
  double speed(const Place& place) const
  {
    return speed_along_normal(m_numerators, m_weight, m_columns, m_motion_weight, place);
  }

  // The unit normal into the solid at a place of the envelope where the surface touches it from inside, about: a point
  // of space that is there lies in the solid just before and after.
  std::optional<Double_kernel::Vector_3> inner_normal_of_fold(const Place& place) const
  {
    constexpr double step = 0x1p-14;
    const auto beside = [&](const Place& direction, double length) {
      Place result;
      for (std::size_t a = 0; a < 3; ++a)
        result[a] = (std::clamp)(place[a] + length * direction[a], m_lower[a], m_upper[a]);
      return result;
    };
    std::array<Double_kernel::Vector_3, 3> change; // for unit changes of the place
    for (std::size_t a = 0; a < 3; ++a) {
      Place axis{};
      axis[a] = m_upper[a] - m_lower[a];
      const Place from = beside(axis, -step), to = beside(axis, step);
      change[a] = ((*this)(to) - (*this)(from)) / (to[a] - from[a]);
    }
    const auto &u = change[0], &v = change[1], &t = change[2];
    const Double_kernel::Vector_3 normal = CGAL::cross_product(u, v);
    const double size = normal.squared_length();
    if (!(size > 0))
      return std::nullopt;
    // the point of the surface that is at this place of space runs against the velocity
    Place run{CGAL::cross_product(v, t) * normal / size, CGAL::cross_product(t, u) * normal / size, 1};
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      longest = (std::max)(longest, std::abs(run[a]) / (m_upper[a] - m_lower[a]));
    const double before = speed(beside(run, -step / longest)), after = speed(beside(run, step / longest));
    if (m_has_outer_normals ? !(after > before) : !(after < before))
      return std::nullopt;
    return normal * ((m_has_outer_normals ? -1 : 1) / std::sqrt(size));
  }

  // Whether the surface moves against its outer normal there, by proof.
  bool is_inward(const Place& place) const
  {
    const Exact_rational speed = speed_along_normal(
        m_surface.numerators(), m_surface.weight(), m_motion.columns(), m_motion.weight(),
        std::array<Exact_rational, 3>{Exact_rational(place[0]), Exact_rational(place[1]), Exact_rational(place[2])});
    return m_has_outer_normals ? speed < 0 : speed > 0;
  }

private:
  void set_time(double t) const
  {
    const std::span<const double> time(&t, 1);
    const double w = m_motion_weight(time);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        m_map[k][i] = m_columns[k][i](time) / w;
    m_time = t;
  }

  static Function in_doubles(const Bspline_function<Exact_rational>& f)
  {
    return f.converted<double>([](const Exact_rational& x) { return to_nearest_double(x); });
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_MOVING_SURFACE_H
