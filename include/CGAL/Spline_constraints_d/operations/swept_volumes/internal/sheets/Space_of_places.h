// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SPACE_OF_PLACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SPACE_OF_PLACES_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Moving_surface.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// A place of one of the patches of a solid.
struct Place_of_solid
{
  std::size_t patch;
  Place place;

  friend auto operator<=>(const Place_of_solid&, const Place_of_solid&) = default;
};

// The boxes of all places of the moving patches of a solid, each a unit square times the time, cut at some times. Some
// of their faces and edges are the same: where patches are glued, at the ends of a closed motion, at poles; edges and
// corners that stand still are the same at all times. Parameters along sides are multiples of 2^-50, so that x = 1 - (1
// - x).
class Space_of_places
{
  const Solid_boundary& m_solid;
  std::vector<double> m_times;
  bool m_is_closed;                               // the motion
  std::vector<std::array<Glued_side, 4>> m_first; // of two glued sides, the first one
  std::vector<std::size_t> m_corners;             // 4 patch + corner: one of all that are the same
  std::vector<bool> m_is_fixed_corner;
  std::vector<std::array<bool, 4>> m_is_fixed_side;

public:
  // \pre The solid lives longer. The cuts of the time begin and end with its ends.
  Space_of_places(const Solid_boundary& solid, const Rational_motion_3& motion, std::vector<double> times,
                  bool is_closed)
    : m_solid(solid), m_times(std::move(times)), m_is_closed(is_closed)
  {
    join_sides();
    find_what_stands_still(motion);
  }

  const Solid_boundary& solid() const { return m_solid; }
  const std::vector<double>& times() const { return m_times; }
  bool is_closed() const { return m_is_closed; }
  std::size_t number_of_times() const { return m_times.size() - 1; } // ranges

  double length(int axis) const { return axis == 2 ? m_times.back() - m_times.front() : 1; }
  bool is_pole(const Patch_side& side) const { return !m_solid.glued(side); }

  // Whether a parameter is that of a face of a box.
  bool is_cut(int axis, double value) const
  {
    return axis == 2 ? std::binary_search(m_times.begin(), m_times.end(), value) : value == 0 || value == 1;
  }

  static double snapped(double x) { return std::round(x * 0x1p50) * 0x1p-50; }

  // With a parameter along a side as a multiple.
  static Place snapped(Place place)
  {
    for (const std::size_t axis : {0u, 1u})
      if (place[axis] == 0 || place[axis] == 1)
        place[1 - axis] = snapped(place[1 - axis]);
    return place;
  }

  // One of the places that are the same point at the same time.
  Place_of_solid canonical(Place_of_solid own) const
  {
    Place& place = own.place;
    if (m_is_closed && place[2] == m_times.back())
      place[2] = m_times.front();
    const std::optional<Patch_side> side = side_of(own);
    if (!side)
      return own;
    const double x = place[static_cast<std::size_t>(side->free_axis())];
    if (x == 0 || x == 1 || is_pole(*side))
      return at_corner(m_corners[4 * own.patch + static_cast<std::size_t>(side->corner(x == 1 ? 1 : 0))], place[2]);
    return on_side(m_first[own.patch][static_cast<std::size_t>(side->side)], x,
                   m_is_fixed_side[own.patch][static_cast<std::size_t>(side->side)] ? m_times.front() : place[2]);
  }

  // A line along an axis on a side or at a corner, as one of those that are the same.
  struct Line
  {
    Place_of_solid key; // without the parameter on the line
    int axis;
    bool is_reversed;

    double parameter(double own) const { return is_reversed ? 1 - own : own; } // and back

    Place_of_solid at(double parameter) const
    {
      Place_of_solid result = key;
      result.place[static_cast<std::size_t>(axis)] = parameter;
      return result;
    }
  };
  Line line(std::size_t patch, int axis, Place place) const
  {
    if (axis == 2) {
      const Place_of_solid key = canonical({patch, place});
      return {Line{key, 2, false}.at(0), 2, false};
    }
    const Patch_side side{patch, 2 * (1 - axis) + (place[static_cast<std::size_t>(1 - axis)] == 0 ? 0 : 1)};
    const Glued_side& first = m_first[patch][static_cast<std::size_t>(side.side)];
    place[static_cast<std::size_t>(axis)] = 0.5;
    const double time = canonical({patch, place}).place[2];
    const int own_axis = first.side.free_axis();
    return {Line{on_side(first, 0, time), own_axis, false}.at(0), own_axis, first.is_reversed};
  }

private:
  static Place_of_solid on_side(const Glued_side& first, double x, double time)
  {
    Place_of_solid result{first.side.patch, {0, 0, time}};
    result.place[static_cast<std::size_t>(first.side.axis())] = first.side.end();
    result.place[static_cast<std::size_t>(first.side.free_axis())] = first.parameter(x);
    return result;
  }

  Place_of_solid at_corner(std::size_t corner, double time) const
  {
    return {corner / 4,
            {static_cast<double>(corner % 4 / 2), static_cast<double>(corner % 2),
             m_is_fixed_corner[corner] ? m_times.front() : time}};
  }

  // Of two, one that is a pole.
  std::optional<Patch_side> side_of(const Place_of_solid& own) const
  {
    std::optional<Patch_side> result;
    for (const int axis : {0, 1})
      if (const double x = own.place[static_cast<std::size_t>(axis)]; x == 0 || x == 1)
        if (const Patch_side side{own.patch, 2 * axis + (x == 0 ? 0 : 1)}; !result || is_pole(side))
          result = side;
    return result;
  }

  void join_sides()
  {
    std::vector<std::size_t> rank(4 * m_solid.size()), parent(4 * m_solid.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> corners(rank.data(), parent.data());
    for (std::size_t i = 0; i < parent.size(); ++i)
      corners.make_set(i);
    const auto corner = [](const Patch_side& side, int end) {
      return 4 * side.patch + static_cast<std::size_t>(side.corner(end));
    };
    for (std::size_t patch = 0; patch < m_solid.size(); ++patch) {
      m_first.emplace_back();
      for (int k = 0; k < 4; ++k) {
        const Patch_side side{patch, k};
        const std::optional<Glued_side>& other = m_solid.glued(side);
        m_first.back()[static_cast<std::size_t>(k)] = other && other->side < side ? *other : Glued_side{side, false};
        if (!other)
          corners.union_set(corner(side, 0), corner(side, 1));
        else
          for (const int end : {0, 1})
            corners.union_set(corner(side, end), corner(other->side, other->parameter(end)));
      }
    }
    for (std::size_t i = 0; i < parent.size(); ++i)
      m_corners.push_back(corners.find_set(i));
  }

  void find_what_stands_still(const Rational_motion_3& motion)
  {
    const auto is_fixed = [&](const std::array<Exact_rational, 3>& p) {
      const std::array<Exact_rational, 1> begin{motion.domain().first};
      const Exact_rational w = motion.weight()(begin);
      for (std::size_t i = 0; i < 3; ++i) {
        const Common::Exact_function x = motion.columns()[0][i] * p[0] + motion.columns()[1][i] * p[1] +
            motion.columns()[2][i] * p[2] + motion.columns()[3][i];
        if (!(x * w == motion.weight() * x(begin)))
          return false;
      }
      return true;
    };
    m_is_fixed_corner.assign(4 * m_solid.size(), false);
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      if (m_corners[i] == i) {
        const std::array<Exact_rational, 2> parameters{Exact_rational(static_cast<int>(i % 4 / 2)),
                                                       Exact_rational(static_cast<int>(i % 2))};
        m_is_fixed_corner[i] = is_fixed(m_solid[i / 4](parameters));
      }
    m_is_fixed_side.assign(m_solid.size(), {});
    for (std::size_t patch = 0; patch < m_solid.size(); ++patch)
      for (int k = 0; k < 4; ++k)
        m_is_fixed_side[patch][static_cast<std::size_t>(k)] = is_fixed_side({patch, k}, is_fixed);
  }

  // The points that stand still are a flat, so that it is enough to look at one more point between two breaks than the
  // degree is.
  template <class Is_fixed>
  bool is_fixed_side(const Patch_side& side, const Is_fixed& is_fixed) const
  {
    for (const int end : {0, 1})
      if (!m_is_fixed_corner[m_corners[4 * side.patch + static_cast<std::size_t>(side.corner(end))]])
        return false;
    const Exact_rational value(side.end());
    const Solid_boundary::Patch curve = m_solid[side.patch].part(side.axis(), {value, value});
    int degree = curve.weight().degree(0);
    for (const auto& f : curve.numerators())
      degree = (std::max)(degree, f.degree(0));
    const std::vector<Exact_rational> breaks = curve.breaks(0);
    for (std::size_t i = 1; i < breaks.size(); ++i)
      for (int k = 0; k <= degree; ++k) {
        const std::array<Exact_rational, 1> parameter{
            Exact_rational(breaks[i - 1] + (breaks[i] - breaks[i - 1]) * Exact_rational(k) / (degree + 1))};
        if (!is_fixed(curve(parameter)))
          return false;
      }
    return true;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SPACE_OF_PLACES_H
