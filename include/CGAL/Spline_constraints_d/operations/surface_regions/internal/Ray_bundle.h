// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_BUNDLE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_BUNDLE_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Interval_jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
Directions in a rectangle of two parameters, as a set of these: the unit vectors at multiples of 1/16 of a turn, in
coordinates in which the rectangle is a square.
*/
class Direction_set
{
  std::uint32_t m_bits = 0;

public:
  static constexpr int number = 16;

  static Direction_set all()
  {
    Direction_set result;
    result.m_bits = (std::uint32_t(1) << number) - 1;
    return result;
  }

  // Those along which a function with a gradient in these ranges increases; \pre in an Upward_rounding_guard.
  static Direction_set increasing(const std::array<Interval, 2>& gradient, const std::array<double, 2>& widths)
  {
    Direction_set result;
    for (int k = 0; k < number; ++k) {
      const std::array<double, 2> d = direction(k);
      const Interval slope = gradient[0] * Interval(d[0] * widths[0]) + gradient[1] * Interval(d[1] * widths[1]);
      if (is_positive(slope))
        result.m_bits |= std::uint32_t(1) << k;
    }
    return result;
  }

  // Those along which a parameter does not decrease, or does not increase.
  static Direction_set not_against(std::size_t axis, bool is_upwards)
  {
    Direction_set result;
    for (int k = 0; k < number; ++k)
      if (is_upwards ? direction(k)[axis] >= 0 : direction(k)[axis] <= 0)
        result.m_bits |= std::uint32_t(1) << k;
    return result;
  }

  static std::array<double, 2> direction(int k)
  {
    constexpr std::array<double, 5> cosines{1, 0.921875, 0.703125, 0.3828125, 0};
    const auto cosine = [&](int i) {
      const int j = ((i % number) + number) % number, folded = j <= number / 2 ? j : number - j;
      return folded <= number / 4 ? cosines[static_cast<std::size_t>(folded)]
                                  : -cosines[static_cast<std::size_t>(number / 2 - folded)];
    };
    return {cosine(k), cosine(k - number / 4)};
  }

  void restrict_to(const Direction_set& other) { m_bits &= other.m_bits; }
  bool is_empty() const { return m_bits == 0; }
  bool contains(int k) const { return (m_bits >> k & 1u) != 0; }

  // Along an axis, upwards or downwards.
  bool contains_axis(std::size_t axis, bool is_upwards) const
  {
    return contains((axis == 0 ? 0 : number / 4) + (is_upwards ? 0 : number / 2));
  }

  // In the middle of the longest row of neighbouring ones. \pre It is not empty.
  int middle() const
  {
    int best = 0, longest = 0;
    for (int k = 0; k < number; ++k) {
      int length = 0;
      while (length < number && contains((k + length) % number))
        ++length;
      if (length > longest) {
        longest = length;
        best = (k + (length - 1) / 2) % number;
      }
    }
    return best;
  }
};

// Of a rectangle with a fold of the surface and what an edge behind it casts on it: directions in which rays first come
// to meet the surface and then leave it, at the silhouette.
struct Fold_at_edge
{
  Direction_set directions;
  int side_behind;                                         // the sign of <O,n> behind the silhouette
  std::optional<std::pair<std::size_t, std::size_t>> edge; // the axis and the end where a side is the edge, if one is
};

// The rays S + l O, l > 0, from all points of a part of a surface, and where they end, if they do.
struct Ray_bundle
{
  Interval_jet origin, direction;
  std::optional<Interval_vector> eye;

  // What is behind one of the rays, or beyond its end, at all parameters of a part of another surface.
  bool passes_beside(const Interval_jet& other) const
  {
    return is_negative(ahead(other)) || (eye && is_positive(dot(other.value - *eye, direction.value)));
  }

  // What is ahead of all rays and before their end.
  bool faces(const Interval_jet& other) const { return is_positive(ahead(other)) && is_before_end(other); }

  bool is_before_end(const Interval_jet& other) const
  {
    return !eye || is_negative(dot(other.value - *eye, direction.value));
  }

  // A multiple of l at the other surface.
  Interval ahead(const Interval_jet& other) const { return dot(other.value - origin.value, direction.value); }

  Interval length(const Interval_jet& other) const
  {
    const Interval square = dot(direction.value, direction.value);
    return is_positive(square) ? ahead(other) / square : Interval(-1e300, 1e300);
  }
};

/*
The function F = (K - S) x O of the parameters of rays and those of another surface, zero where a ray meets it: its
value in the middle, and ranges of derivatives by the four parameters.
*/
struct Meeting_function
{
  Interval_vector middle;
  std::array<Interval_vector, 2> by_ray, by_other;
  std::array<Interval, 2> ray, other; // offsets of parameters from the middle

  Meeting_function(const Ray_bundle& rays, const Interval_jet& k)
    : middle(cross(k.middle - rays.origin.middle, rays.direction.middle))
  {
    const Interval_vector chord = k.value - rays.origin.value;
    for (const std::size_t i : {0, 1}) {
      by_ray[i] = cross(chord, rays.direction.first[i]) - cross(rays.origin.first[i], rays.direction.value);
      by_other[i] = cross(k.first[i], rays.direction.value);
      ray[i] = rays.origin.offset(i);
      other[i] = k.offset(i);
    }
  }

  // What a component along a constant vector has.
  Interval range(const Interval_vector& along) const
  {
    Interval result = dot(middle, along);
    for (const std::size_t i : {0, 1})
      result += dot(by_ray[i], along) * ray[i] + dot(by_other[i], along) * other[i];
    return result;
  }

  Interval component(std::size_t c) const
  {
    Interval result = middle[c];
    for (const std::size_t i : {0, 1})
      result += by_ray[i][c] * ray[i] + by_other[i][c] * other[i];
    return result;
  }

  // Whether it certainly has no zero: a component along an axis, or across the derivative by a parameter, has none.
  bool has_no_zero(const Ray_bundle& rays) const
  {
    for (std::size_t c = 0; c < 3; ++c)
      if (!Surface_regions::has_zero(component(c)))
        return true;
    const Interval_vector o = middle_of(rays.direction.middle);
    for (const std::size_t i : {0, 1})
      if (!Surface_regions::has_zero(range(cross(o, middle_of(by_other[i])))))
        return true;
    return false;
  }

  // How far apart rays are, and points of the other surface whose parameters differ along one axis.
  double extent_of_rays() const { return extent(by_ray[0], ray[0]) + extent(by_ray[1], ray[1]); }
  double extent_of_other(std::size_t axis) const { return extent(by_other[axis], other[axis]); }

  static Interval_vector middle_of(const Interval_vector& v)
  {
    return {Interval(Surface_regions::middle_of(v[0])), Interval(Surface_regions::middle_of(v[1])),
            Interval(Surface_regions::middle_of(v[2]))};
  }

private:
  static double extent(const Interval_vector& by, const Interval& offset)
  {
    double square = 0;
    for (const Interval& x : by) {
      const double m = (std::max)(-x.inf(), x.sup());
      square += m * m;
    }
    return std::sqrt(square) * offset.sup();
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_BUNDLE_H
