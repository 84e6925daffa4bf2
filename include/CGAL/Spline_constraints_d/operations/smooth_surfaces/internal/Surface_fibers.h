// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SURFACE_FIBERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SURFACE_FIBERS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Surface_data.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/certified_patches.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

/*
A sixth part of a neighbourhood at a facet: what is over the triangle of a corner p, the middle m of an edge at it,
and the center w. Its fibres begin in a p + b m + c w, go along the normal to a p + b m + c t, with t for the apex, and
from there to a p + b x + c t, with x for the gap point; in the same way below.
*/
struct Flag
{
  std::size_t facet;
  int corner; // the corner
  int edge;   // the edge, from this corner or to it

  bool is_edge_from_corner() const { return corner == edge; }
};

// A point of a patch, in doubles.
struct Surface_point
{
  std::size_t patch;
  std::array<double, 4> barycentric;
};

// The points of a certified surface on its fibres: there is one on each.
class Surface_fibers
{
  using Coordinates = std::array<double, 4>; // barycentric
  using Weights = std::array<double, 3>;     // of corner, middle of the edge, center

  const Surface_data& m_data;
  std::vector<Interval_form> m_forms;

public:
  explicit Surface_fibers(const Surface_data& data) : m_data(data)
  {
    const Upward_rounding_guard guard;
    for (const Form& form : data.forms)
      m_forms.push_back(
          form.converted<Interval>([](const Exact_rational& x) { return Number_traits<Interval>::from_rational(x); }));
  }

  bool is_certified(const Flag& flag) const
  {
    if (m_data.certificates.empty()) // the run has ended before there were patches
      return false;
    for (const int side : {OUTER, INNER})
      if (!m_data.certificates[facet_patch(flag, side)].is_certified() ||
          !m_data.certificates[gap_patch(flag, side)].is_certified())
        return false;
    return true;
  }

  // The sum of the weights is 1 without rounding, and that of the corner is less. \pre The flag is certified.
  Surface_point operator()(const Flag& flag, const Weights& weights) const
  {
    const auto& [a, b, c] = weights;
    const std::size_t outer = facet_patch(flag, OUTER);
    const int p = place_of_corner(flag, outer);
    const Coordinates foot = coordinates(p, c, a + b / 2, b / 2, 0), knee = coordinates(p, 0, a + b / 2, b / 2, c);
    const CGAL::Sign at_foot = sign_at(outer, foot);
    if (at_foot == CGAL::ZERO)
      return {outer, foot};
    const int side = at_foot == CGAL::NEGATIVE ? OUTER : INNER;
    if (c > 0) {
      const std::size_t patch = facet_patch(flag, side);
      const CGAL::Sign at_knee = sign_at(patch, knee);
      if (at_knee == CGAL::ZERO)
        return {patch, knee};
      if (at_knee != at_foot)
        return {patch, zero_between(patch, foot, knee, at_foot)};
    }
    const std::size_t gap = gap_patch(flag, side);
    const int q = place_of_corner(flag, gap);
    return {gap, zero_between(gap, coordinates(q, 0, a + b / 2, b / 2, c), coordinates(q, b, a, 0, c), at_foot)};
  }

private:
  std::size_t facet_patch(const Flag& flag, int side) const
  {
    return Neighborhood::facet_patch(flag.facet, flag.edge, side);
  }

  std::size_t gap_patch(const Flag& flag, int side) const
  {
    const std::size_t edge = m_data.mesh.edges_of_facets[flag.facet][flag.edge];
    return Neighborhood::gap_patch(m_data.mesh, edge, side, m_data.mesh.edges[edge].facets[0] == flag.facet ? 0 : 1);
  }

  // Which of the nodes 1 and 2 of a patch is the corner.
  int place_of_corner(const Flag& flag, std::size_t patch) const
  {
    return m_data.neighborhood.patches[patch].nodes[1] == m_data.mesh.facets[flag.facet][flag.corner] ? 1 : 2;
  }

  static Coordinates coordinates(int corner, double first, double at_corner, double at_other, double last)
  {
    Coordinates result{first, at_other, at_other, last};
    result[corner] = at_corner;
    return result;
  }

  static Interval_form::Barycentric as_intervals(const Coordinates& x)
  {
    return {Interval(x[0]), Interval(x[1]), Interval(x[2]), Interval(x[3])};
  }

  static Form::Barycentric as_rationals(const Coordinates& x)
  {
    return {rational_of_finite(x[0]), rational_of_finite(x[1]), rational_of_finite(x[2]), rational_of_finite(x[3])};
  }

  CGAL::Sign sign_at(std::size_t patch, const Coordinates& x) const
  {
    const Upward_rounding_guard guard;
    const auto sign = certain_sign(m_forms[patch](as_intervals(x)));
    return sign ? *sign : CGAL::sign(m_data.forms[patch](as_rationals(x)));
  }

  // In a range of the width 2^-43 of the segment, at whose ends signs are certain to be different.
  Coordinates zero_between(std::size_t patch, const Coordinates& first, const Coordinates& last,
                           CGAL::Sign at_first) const
  {
    const double s = share_of_zero(patch, first, last, at_first);
    Coordinates result;
    for (int i = 0; i < 4; ++i)
      result[i] = (1 - s) * first[i] + s * last[i];
    return result;
  }

  double share_of_zero(std::size_t patch, const Coordinates& first, const Coordinates& last, CGAL::Sign at_first) const
  {
    constexpr double width = 0x1p-44;
    {
      const Upward_rounding_guard guard;
      const auto line =
          m_forms[patch].restricted(std::array<Interval_form::Barycentric, 2>{as_intervals(first), as_intervals(last)});
      const double s = zero_of_middle(line, at_first);
      const auto sign = [&](double t) {
        return t <= 0 ? at_first
            : t >= 1  ? CGAL::opposite(at_first)
                      : certain_sign(line({Interval(1) - Interval(t), Interval(t)})).value_or(CGAL::ZERO);
      };
      if (sign(s - width) * sign(s + width) < 0)
        return s;
    }
    const auto line =
        m_data.forms[patch].restricted(std::array<Form::Barycentric, 2>{as_rationals(first), as_rationals(last)});
    double lower = 0, upper = 1; // multiples of 2^-44
    while (upper - lower > width) {
      const double middle = (lower + upper) / 2;
      const Exact_rational t = rational_of_finite(middle);
      (CGAL::sign(line({Exact_rational(1 - t), t})) == at_first ? lower : upper) = middle;
    }
    return (lower + upper) / 2;
  }

  // Of a function near that.
  static double zero_of_middle(const Bernstein_simplex<Interval, 1>& line, CGAL::Sign at_first)
  {
    std::array<double, 4> b;
    for (int i = 0; i < 4; ++i)
      b[i] = (line.coefficients()[i].inf() + line.coefficients()[i].sup()) / 2;
    const auto value = [&](double t) {
      const double u = 1 - t;
      return u * u * u * b[0] + 3 * u * t * (u * b[1] + t * b[2]) + t * t * t * b[3];
    };
    double lower = 0, upper = 1;
    while (upper - lower > 0x1p-48) {
      const double middle = (lower + upper) / 2;
      ((value(middle) > 0) == (at_first == CGAL::POSITIVE) ? lower : upper) = middle;
    }
    return (lower + upper) / 2;
  }
};

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SURFACE_FIBERS_H
