// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_CENTRE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_CENTRE_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_element_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

/*
A point that is strictly on the left of all tangents of a boundary, or a proof that there is none: the half-planes of
some tangents have no common point, or their common points have no interior.

A polygon that contains the kernel is cut by tangents that do not have its centroid on their left, each of which takes
away at least a fraction 1/e of it (Gruenbaum 1960).
*/
class Kernel_centre_2
{
  static constexpr int most_cuts = 400, most_halvings = 30;

  const std::vector<Tangent_family>& m_tangents;
  std::vector<Exact_pair> m_polygon;
  std::optional<Exact_pair> m_centre;

public:
  // \throws Run_stopped
  Kernel_centre_2(const std::vector<Tangent_family>& tangents, std::vector<Exact_pair> polygon, Run_of_steps& run)
    : m_tangents(tangents), m_polygon(std::move(polygon))
  {
    for (int cuts = 0; cuts < most_cuts && !is_flat() && !m_centre;) {
      const Exact_pair candidate = centroid();
      bool is_inside = true;
      for (const Tangent_family& tangents_of_piece : m_tangents) {
        run.check();
        if (const auto t = violated(tangents_of_piece.at(candidate))) {
          cut(tangents_of_piece, *t);
          is_inside = false;
          ++cuts;
        }
      }
      if (is_inside)
        m_centre = candidate;
    }
    if (is_flat())
      for (const Tangent_family& tangents_of_piece : m_tangents)
        for (int end = 0; end < 2; ++end)
          cut(tangents_of_piece, Exact_rational(end));
  }

  const std::optional<Exact_pair>& centre() const { return m_centre; }

  // Contains the kernel, and is empty if that is; flat if the kernel has no interior.
  const std::vector<Exact_pair>& polygon() const { return m_polygon; }
  bool is_flat() const
  {
    return m_polygon.empty() || std::all_of(m_polygon.begin(), m_polygon.end(), [&](const Exact_pair& p) {
             return exact_cross(exact_difference(m_polygon[1 % m_polygon.size()], m_polygon[0]),
                                exact_difference(p, m_polygon[0])) == 0;
           });
  }

private:
  // About the centroid, with few digits.
  Exact_pair centroid() const
  {
    Exact_pair sum{0, 0};
    Exact_rational twice_area(0);
    for (std::size_t i = 1; i + 1 < m_polygon.size(); ++i) {
      const Exact_pair p = exact_difference(m_polygon[i], m_polygon[0]),
                       q = exact_difference(m_polygon[i + 1], m_polygon[0]);
      const Exact_rational area = exact_cross(p, q);
      twice_area += area;
      for (std::size_t k = 0; k < 2; ++k)
        sum[k] += area * (p[k] + q[k]);
    }
    Exact_pair result = m_polygon[0];
    for (std::size_t k = 0; k < 2; ++k)
      result[k] = rounded(Exact_rational(result[k] + sum[k] / (3 * twice_area)), k);
    return result;
  }

  // To a number with few digits, about a thousandth of the extent of the polygon away.
  Exact_rational rounded(const Exact_rational& x, std::size_t axis) const
  {
    const auto [least, greatest] =
        std::minmax_element(m_polygon.begin(), m_polygon.end(),
                            [&](const Exact_pair& p, const Exact_pair& q) { return p[axis] < q[axis]; });
    const Exact_rational reach((*greatest)[axis] - (*least)[axis]);
    return simple_dyadic_between(Exact_rational(x - reach / 1000), Exact_rational(x + reach / 1000));
  }

  // A parameter of [0,1] where a function is not positive: about where it is least among some, or one that halving
  // leaves.
  static std::optional<Exact_rational> violated(const Exact_tensor& f)
  {
    if (f.bounds().first > 0)
      return std::nullopt;
    constexpr int samples = 32;
    std::pair<Exact_rational, int> least(1, -1);
    for (int i = 0; i <= samples; ++i)
      if (const Exact_rational value = f(std::array<Exact_rational, 1>{Exact_rational(i) / samples});
          least.second < 0 || value < least.first)
        least = {value, i};
    if (!(least.first > 0))
      return Exact_rational(least.second) / samples;
    return violated(f, Exact_rational(0), Exact_rational(1), most_halvings);
  }

  static std::optional<Exact_rational> violated(const Exact_tensor& f, const Exact_rational& lower,
                                                const Exact_rational& upper, int halvings)
  {
    if (f.bounds().first > 0)
      return std::nullopt;
    if (!(f.coefficients().front() > 0) || halvings == 0)
      return lower;
    if (!(f.coefficients().back() > 0))
      return upper;
    const auto [f0, f1] = f.split(0);
    const Exact_rational middle((lower + upper) / 2);
    const auto result = violated(f0, lower, middle, halvings - 1);
    return result ? result : violated(f1, middle, upper, halvings - 1);
  }

  void cut(const Tangent_family& tangents, const Exact_rational& t)
  {
    const std::array<Exact_rational, 1> u{t};
    const Exact_rational a = tangents.a(u), b = tangents.b(u), c = tangents.c(u);
    const auto side = [&](const Exact_pair& p) { return Exact_rational(a * p[0] + b * p[1] + c); };
    std::vector<Exact_pair> result;
    const auto append = [&](const Exact_pair& p) {
      if (result.empty() || (result.back() != p && result.front() != p))
        result.push_back(p);
    };
    for (std::size_t i = 0; i < m_polygon.size(); ++i) {
      const Exact_pair &p = m_polygon[i], &q = m_polygon[(i + 1) % m_polygon.size()];
      const Exact_rational s = side(p), r = side(q);
      if (s >= 0)
        append(p);
      if ((s > 0 && r < 0) || (s < 0 && r > 0)) {
        const Exact_rational part(s / (s - r));
        append({Exact_rational(p[0] + part * (q[0] - p[0])), Exact_rational(p[1] + part * (q[1] - p[1]))});
      }
    }
    m_polygon = std::move(result);
  }
};

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_CENTRE_2_H
