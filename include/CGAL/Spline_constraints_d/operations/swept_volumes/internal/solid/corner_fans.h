// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_CORNER_FANS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_CORNER_FANS_H

#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Moving_surface.h>

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
namespace Swept_volumes {

// A polynomial patch on the unit square cut along the diagonal from a corner, 2 u + v: with p and q the parameters seen
// from this corner, as (p, q) = (x, x y) and (x y, y). Both have a pole there, in whose neighbourhood directions are
// told apart, and the same parameters on the other sides. \pre The patch has no breaks.
inline std::array<Common::Spline_patch<3>, 2> fan_at(const Common::Spline_patch<3>& patch, int corner)
{
  const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1);
  const bool is_mirrored = corner == 1 || corner == 2; // keeps orientations with x and y exchanged
  const auto part = [&](bool is_second) {
    const auto &own = is_mirrored ? y : x, &other = is_mirrored ? x : y;
    std::array<Power_polynomial, 2> to{is_second ? own * other : own, is_second ? other : own * other};
    if (corner / 2 == 1)
      to[0] = 1 - to[0];
    if (corner % 2 == 1)
      to[1] = 1 - to[1];
    const auto composed = [&](const Common::Exact_function& f) {
      Power_polynomial result = polynomial_of(f.bezier_pieces().front(), 2); // of the variables 2 and 3
      result = result.substituted(2, to[0]).substituted(3, to[1]);
      return Common::Exact_function::from_tensor(
          tensor_of(result, {(std::max)(result.degree(0), 0), (std::max)(result.degree(1), 0)}), {{0, 1}, {0, 1}});
    };
    Common::Vector_of_functions<3> numerators;
    for (std::size_t i = 0; i < 3; ++i)
      numerators[i] = composed(patch.numerators()[i]);
    return Common::Spline_patch<3>(std::move(numerators), composed(patch.weight()), patch.is_rational());
  };
  return {part(false), part(true)};
}

// Finds corners of moving patches that move in the tangent plane of the patch all the time, during a part of the
// motion: there the envelope runs along an edge of the box of places.
class Touching_corners
{
  using Patch = Common::Spline_patch<3>;

  const Rational_motion_3& m_motion;
  std::vector<std::vector<Exact_rational>> m_times; // in each range of times without breaks, more than F has zeros

public:
  explicit Touching_corners(const Rational_motion_3& motion) : m_motion(motion)
  {
    std::vector<Exact_rational> breaks = motion.weight().breaks(0);
    int degree = motion.weight().degree(0);
    for (const auto& column : motion.columns())
      for (const auto& f : column) {
        breaks = internal::united(breaks, f.breaks(0));
        degree = (std::max)(degree, f.degree(0));
      }
    const int count = 4 * degree + 1;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
      m_times.emplace_back();
      for (int k = 1; k <= count; ++k)
        m_times.back().push_back(
            Exact_rational(breaks[i - 1] + (breaks[i] - breaks[i - 1]) * Exact_rational(k) / (count + 1)));
    }
  }

  // The first one that is neither at a pole nor on a side that does so all along.
  std::optional<int> operator()(const Patch& patch) const
  {
    for (const int u : {0, 1})
      for (const int v : {0, 1})
        if (!patch.pole(0, u) && !patch.pole(1, v) && moves_along_patch(patch, u, v) &&
            !moves_along_patch(patch, u, Exact_rational(Exact_rational(1) / 3)) &&
            !moves_along_patch(patch, Exact_rational(Exact_rational(1) / 3), v))
          return 2 * u + v;
    return std::nullopt;
  }

private:
  bool moves_along_patch(const Patch& patch, const Exact_rational& u, const Exact_rational& v) const
  {
    return std::any_of(m_times.begin(), m_times.end(), [&](const auto& times) {
      return std::all_of(times.begin(), times.end(), [&](const Exact_rational& time) {
        return speed_along_normal(patch.numerators(), patch.weight(), m_motion.columns(), m_motion.weight(),
                                  std::array<Exact_rational, 3>{u, v, time}) == 0;
      });
    });
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_CORNER_FANS_H
