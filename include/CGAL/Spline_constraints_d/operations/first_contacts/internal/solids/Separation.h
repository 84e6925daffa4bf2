// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SEPARATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SEPARATION_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_element.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// The control points of a polynomial or rational piece of a surface, in intervals. Rounding has to be upwards.
class Control_net_3
{
  using Homogeneous = std::array<Interval, 4>;
  using Direction = std::array<double, 3>;

  std::array<std::size_t, 2> m_sizes; // of both axes
  std::vector<Homogeneous> m_controls;
  std::vector<Box_3> m_points; // projected; none, where weights are not positive

public:
  //! \pre the patch has no inner breaks
  explicit Control_net_3(const Spline_patch<3>& patch)
  {
    const std::vector<int> degrees = common_degrees(patch);
    std::array<std::vector<Exact_rational>, 4> coefficients;
    for (std::size_t i = 0; i < 4; ++i)
      coefficients[i] =
          (i < 3 ? patch.numerators()[i] : patch.weight()).bezier_pieces().front().elevated(degrees).coefficients();
    m_sizes = {static_cast<std::size_t>(degrees[0]) + 1, static_cast<std::size_t>(degrees[1]) + 1};
    for (std::size_t k = 0; k < coefficients[0].size(); ++k) {
      const auto around = [&](std::size_t i) { return interval_around(Rational_interval(coefficients[i][k])); };
      m_controls.push_back({around(0), around(1), around(2), around(3)});
    }
    project();
  }

  std::array<Control_net_3, 2> halves(int axis) const
  {
    std::array<Control_net_3, 2> result{*this, *this};
    const std::size_t inner = axis == 0 ? m_sizes[1] : 1, count = m_sizes[static_cast<std::size_t>(axis)];
    for (std::size_t row = 0; row < m_controls.size() / count; ++row) {
      const std::size_t first = axis == 0 ? row : row * count;
      for (std::size_t step = 1; step < count; ++step) { // de Casteljau's scheme in the second half
        auto& b = result[1].m_controls;
        for (std::size_t k = 0; k + step < count; ++k)
          for (std::size_t i = 0; i < 4; ++i)
            b[first + k * inner][i] = (b[first + k * inner][i] + b[first + (k + 1) * inner][i]) * Interval(0.5);
        result[0].m_controls[first + step * inner] = b[first];
      }
    }
    for (Control_net_3& half : result)
      half.project();
    return result;
  }

  // Across the axis along which the corners are farther from each other.
  std::array<Control_net_3, 2> halves() const
  {
    return halves(length(corner(0, 0), corner(1, 0)) + length(corner(0, 1), corner(1, 1)) <
                          length(corner(0, 0), corner(0, 1)) + length(corner(1, 0), corner(1, 1))
                      ? 1
                      : 0);
  }

  // About how large it is.
  double size() const { return (std::max)(length(corner(0, 0), corner(1, 1)), length(corner(0, 1), corner(1, 0))); }

  // Whether a plane between both nets is known: they are in the convex hulls of their points.
  friend bool are_separate(const Control_net_3& a, const Control_net_3& b)
  {
    if (a.m_points.empty() || b.m_points.empty())
      return false;
    return std::ranges::any_of(std::array<Direction, 6>{Direction{1, 0, 0}, Direction{0, 1, 0}, Direction{0, 0, 1},
                                                        a.normal(), b.normal(),
                                                        difference(a.corner(0, 0), b.corner(0, 0))},
                               [&](const Direction& direction) {
                                 const Interval own = a.range_along(direction), other = b.range_along(direction);
                                 return own.sup() < other.inf() || other.sup() < own.inf();
                               });
  }

private:
  static std::vector<int> common_degrees(const Spline_patch<3>& patch)
  {
    std::vector<int> result = patch.weight().degrees();
    for (const Exact_function& f : patch.numerators())
      for (std::size_t axis : {0, 1})
        result[axis] = (std::max)(result[axis], f.degrees()[axis]);
    return result;
  }

  void project()
  {
    m_points.clear();
    if (std::ranges::any_of(m_controls, [](const Homogeneous& c) { return !(c[3].inf() > 0); }))
      return;
    for (const auto& [x, y, z, w] : m_controls)
      m_points.push_back({x / w, y / w, z / w});
  }

  Direction corner(int u, int v) const
  {
    const auto& [x, y, z, w] = m_controls[(u == 0 ? 0 : m_sizes[0] - 1) * m_sizes[1] + (v == 0 ? 0 : m_sizes[1] - 1)];
    return {x.sup() / w.sup(), y.sup() / w.sup(), z.sup() / w.sup()};
  }

  static Direction difference(const Direction& a, const Direction& b)
  {
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  }

  static double length(const Direction& a, const Direction& b)
  {
    const Direction d = difference(a, b);
    return std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
  }

  // Of both diagonals, about.
  Direction normal() const
  {
    const Direction a = difference(corner(0, 0), corner(1, 1)), b = difference(corner(0, 1), corner(1, 0));
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Interval range_along(const Direction& direction) const
  {
    const auto along = [&](const Box_3& p) {
      return Interval(direction[0]) * p[0] + Interval(direction[1]) * p[1] + Interval(direction[2]) * p[2];
    };
    Interval result = along(m_points.front());
    for (const Box_3& p : m_points)
      result = hull(result, along(p));
    return result;
  }
};

// Whether it is proved that surfaces do not meet: they are halved until planes separate them, but no more than so many
// pairs.
inline bool are_separate(const std::vector<Spline_patch<3>>& a, const std::vector<Spline_patch<3>>& b, std::size_t most)
{
  const Upward_rounding_guard guard;
  std::vector<Control_net_3> own(a.begin(), a.end()), other(b.begin(), b.end());
  std::vector<std::pair<Control_net_3, Control_net_3>> pairs;
  for (const Control_net_3& x : own)
    for (const Control_net_3& y : other)
      pairs.emplace_back(x, y);
  for (std::size_t looked_at = 0; !pairs.empty();) {
    const auto [x, y] = std::move(pairs.back());
    pairs.pop_back();
    if (are_separate(x, y))
      continue;
    if (++looked_at > most)
      return false;
    const bool is_first = y.size() < x.size();
    for (const Control_net_3& half : (is_first ? x : y).halves())
      pairs.emplace_back(is_first ? half : x, is_first ? y : half);
  }
  return true;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SEPARATION_H
