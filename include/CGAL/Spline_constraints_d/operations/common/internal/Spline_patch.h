// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_PATCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_PATCH_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/internal/Values_at_point.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Parameter_range = std::pair<Exact_rational, Exact_rational>;
using Exact_function = Bspline_function<Exact_rational>;

template <int d>
using Vector_of_functions = std::array<Exact_function, d>;

inline Exact_rational middle_of(const Parameter_range& range)
{
  return Exact_rational((range.first + range.second) / 2);
}

// With the parameter of an axis in a range. Where that is one number, without this axis.
inline Exact_function part_of(const Exact_function& f, int axis, const Parameter_range& range)
{
  if (range.first < range.second)
    return range == f.domain(axis) ? f : f.restricted(axis, range.first, range.second);
  return f.slice(axis, range.first);
}

template <int d>
Vector_of_functions<d> part_of(Vector_of_functions<d> functions, int axis, const Parameter_range& range)
{
  for (Exact_function& f : functions)
    f = part_of(f, axis, range);
  return functions;
}

/*
A point, curve or surface, or a part of one: a rational map x/w of none, one or two parameters, with w > 0. All answers
are exact.
*/
template <int d>
class Spline_patch
{
  Vector_of_functions<d> m_numerators;
  Exact_function m_weight;
  bool m_is_rational = false;

public:
  explicit Spline_patch(const std::array<Exact_rational, d>& point) : Spline_patch(exact_map<d>(point)) {}

  //! \throws Invalid_input when the weight is not proved to have one sign.
  explicit Spline_patch(Exact_map<d> map)
    : m_numerators(std::move(map.numerators)), m_weight(std::move(map.weight)), m_is_rational(map.is_rational)
  {
    if (!m_is_rational || certified_weight_sign(m_weight, {}) > 0)
      return;
    m_weight = -m_weight;
    for (Exact_function& numerator : m_numerators)
      numerator = -numerator;
  }

  //! \throws Invalid_input when the weight is not proved to have one sign.
  template <ParametricMap Map>
  explicit Spline_patch(const Map& map) : Spline_patch(exact_map<d>(map))
  {}

  //! \pre the weight is positive; it is the constant one if the map is not rational
  Spline_patch(Vector_of_functions<d> numerators, Exact_function weight, bool is_rational)
    : m_numerators(std::move(numerators)), m_weight(std::move(weight)), m_is_rational(is_rational)
  {}

  // One coordinate alone.
  Spline_patch<1> coordinate(int i) const { return {{m_numerators[i]}, m_weight, m_is_rational}; }

  // The same parameters and weight with other numerators.
  Spline_patch with_numerators(Vector_of_functions<d> numerators) const
  {
    Spline_patch result(*this);
    result.m_numerators = std::move(numerators);
    return result;
  }

  const Vector_of_functions<d>& numerators() const { return m_numerators; }
  const Exact_function& weight() const { return m_weight; }
  bool is_rational() const { return m_is_rational; }
  int number_of_parameters() const { return m_weight.dimension(); }
  Parameter_range domain(int axis) const { return m_weight.domain(axis); }

  std::vector<Exact_rational> breaks(int axis) const
  {
    std::vector<Exact_rational> result = m_weight.breaks(axis);
    for (const Exact_function& numerator : m_numerators)
      result = internal::united(result, numerator.breaks(axis));
    return result;
  }

  // The same with one more break, where the tangent may jump.
  Spline_patch with_break(int axis, const Exact_rational& value) const
  {
    Spline_patch result(*this);
    const auto refine = [&](Exact_function& f) {
      for (int i = 0; i < f.degree(axis); ++i)
        f = f.with_knot(axis, value);
    };
    std::for_each(result.m_numerators.begin(), result.m_numerators.end(), refine);
    refine(result.m_weight);
    return result;
  }

  // The breaks inside of an axis where the tangent may jump, by the multiplicities of knots.
  std::vector<Exact_rational> possible_kinks(int axis) const
  {
    std::vector<Exact_rational> result;
    const auto add_kinks = [&](const Exact_function& f) {
      std::vector<Exact_rational> kinks;
      for (const auto& [value, multiplicity] : breaks_of(f.axes()[axis]))
        if (f.domain(axis).first < value && value < f.domain(axis).second && multiplicity >= f.degree(axis))
          kinks.push_back(value);
      result = internal::united(result, kinks);
    };
    for (const Exact_function& numerator : m_numerators)
      add_kinks(numerator);
    if (m_is_rational)
      add_kinks(m_weight);
    return result;
  }

  // With the parameter of an axis in a range. Where that is one number, without this axis.
  Spline_patch part(int axis, const Parameter_range& range) const
  {
    Spline_patch result(*this);
    result.m_numerators = part_of<d>(m_numerators, axis, range);
    result.m_weight = part_of(m_weight, axis, range);
    return result;
  }

  Spline_patch part(const std::vector<Parameter_range>& ranges) const
  {
    Spline_patch result(*this);
    for (int axis = number_of_parameters(); axis-- > 0;)
      result = result.part(axis, ranges[axis]);
    return result;
  }

  std::array<Exact_rational, d> operator()(std::span<const Exact_rational> parameters) const
  {
    const Values_at_point<Exact_rational> value(m_numerators[0], parameters);
    std::array<Exact_rational, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = value(m_numerators[i]);
    if (const Exact_rational w = value(m_weight); w != 1)
      for (Exact_rational& x : result)
        x /= w;
    return result;
  }

  std::vector<Exact_rational> middle() const
  {
    std::vector<Exact_rational> result;
    for (int axis = 0; axis < number_of_parameters(); ++axis)
      result.push_back(middle_of(domain(axis)));
    return result;
  }

  std::vector<Exact_rational> first_corner() const { return corner(&Parameter_range::first); }
  std::vector<Exact_rational> last_corner() const { return corner(&Parameter_range::second); }

  // The point that an edge of a surface consists of, if it is a pole.
  std::optional<std::array<Exact_rational, d>> pole(int axis, const Exact_rational& value) const
  {
    const Spline_patch edge = part(axis, {value, value});
    return edge.is_one_point() ? std::optional(edge(edge.first_corner())) : std::nullopt;
  }

  // Rational ones are mostly told by two corners.
  bool is_one_point() const
  {
    const auto is_constant = [](const Exact_function& f) {
      return std::adjacent_find(f.coefficients().begin(), f.coefficients().end(), std::not_equal_to<>()) ==
          f.coefficients().end();
    };
    if (!m_is_rational)
      return std::all_of(m_numerators.begin(), m_numerators.end(), is_constant);
    if (m_weight.coefficients().front() == 0 || m_weight.coefficients().back() == 0)
      return false; // at infinity, which only loci reach
    const std::array<Exact_rational, d> point = (*this)(first_corner());
    if (point != (*this)(last_corner()))
      return false;
    for (int i = 0; i < d; ++i)
      if (!(m_numerators[i] == m_weight * point[i]))
        return false;
    return true;
  }

  // The two parts on both sides of the middle of an axis.
  std::array<Spline_patch, 2> halves(int axis) const
  {
    const auto [begin, end] = domain(axis);
    const Exact_rational middle = middle_of({begin, end});
    return {part(axis, {begin, middle}), part(axis, {middle, end})};
  }

  // A positive multiple of the derivative by a parameter at an end (0 or 1) of a range between two neighbouring breaks,
  // as functions of the other parameter.
  Vector_of_functions<d> one_sided_tangent(int axis, const Parameter_range& cell, int side) const
  {
    const auto value = [&](const Exact_function& f) { return part_of(f, axis, cell).face(axis, side); };
    const auto slope = [&](const Exact_function& f) {
      return part_of(f, axis, cell).restricted(axis, cell.first, cell.second).derivative(axis).face(axis, side);
    };
    Vector_of_functions<d> result;
    for (int i = 0; i < d; ++i)
      result[i] = slope(m_numerators[i]);
    if (!m_is_rational)
      return result;
    const Exact_function w = value(m_weight), w_slope = slope(m_weight);
    for (int i = 0; i < d; ++i)
      result[i] = result[i] * w - value(m_numerators[i]) * w_slope;
    return result;
  }

  bool is_closed(int axis) const
  {
    const auto have_same_faces = [axis](const Exact_function& x) { return x.face(axis, 0) == x.face(axis, 1); };
    if (!m_is_rational)
      return std::all_of(m_numerators.begin(), m_numerators.end(), have_same_faces);
    const Exact_function w[] = {m_weight.face(axis, 0), m_weight.face(axis, 1)};
    return std::all_of(m_numerators.begin(), m_numerators.end(),
                       [&](const Exact_function& x) { return x.face(axis, 0) * w[1] == x.face(axis, 1) * w[0]; });
  }

  // Bounds of the points; of one point, such as a pole, exactly.
  Vector_bounds<d> tight_values() const
  {
    if (!is_one_point())
      return values();
    Vector_bounds<d> result;
    const std::array<Exact_rational, d> point = (*this)(first_corner());
    for (int i = 0; i < d; ++i)
      result[i] = Rational_interval(point[i]);
    return result;
  }

  // Bounds of the points.
  Vector_bounds<d> values() const
  {
    Vector_bounds<d> result;
    if (!m_is_rational) {
      for (int i = 0; i < d; ++i)
        result[i] = Rational_interval(m_numerators[i].bounds());
      return result;
    }
    return over_parts([](const Spline_patch& part) {
      const Rational_interval w(part.m_weight.bounds());
      Vector_bounds<d> result;
      for (int i = 0; i < d; ++i)
        result[i] = Rational_interval(part.m_numerators[i].bounds()) / w;
      return result;
    });
  }

  // Bounds of the derivative by a parameter, kinks included: (x' - (x/w) w') / w.
  Vector_bounds<d> tangents(int axis) const
  {
    Vector_bounds<d> result;
    if (!m_is_rational) {
      for (int i = 0; i < d; ++i)
        result[i] = Rational_interval(m_numerators[i].derivative_bounds(axis));
      return result;
    }
    return over_parts([axis](const Spline_patch& part) {
      const Rational_interval w(part.m_weight.bounds()), slope(part.m_weight.derivative_bounds(axis));
      Vector_bounds<d> result;
      for (int i = 0; i < d; ++i)
        result[i] = (Rational_interval(part.m_numerators[i].derivative_bounds(axis)) -
                     Rational_interval(part.m_numerators[i].bounds()) / w * slope) /
            w;
      return result;
    });
  }

private:
  std::vector<Exact_rational> corner(Exact_rational Parameter_range::* end) const
  {
    std::vector<Exact_rational> result;
    for (int axis = 0; axis < number_of_parameters(); ++axis)
      result.push_back(domain(axis).*end);
    return result;
  }

  // The control points of the weight are positive on parts that are small enough.
  template <class Bounds>
  Vector_bounds<d> over_parts(const Bounds& bounds) const
  {
    if (m_weight.bounds().first > 0)
      return bounds(*this);
    int widest = 0;
    for (int axis = 1; axis < number_of_parameters(); ++axis)
      if (domain(widest).second - domain(widest).first < domain(axis).second - domain(axis).first)
        widest = axis;
    const std::array<Spline_patch, 2> both = halves(widest);
    Vector_bounds<d> result = both[0].over_parts(bounds);
    const Vector_bounds<d> other = both[1].over_parts(bounds);
    for (int i = 0; i < d; ++i)
      result[i] = hull(result[i], other[i]);
    return result;
  }
};

template <int d>
Exact_rational squared_distance_of(const std::array<Exact_rational, d>& a, const std::array<Exact_rational, d>& b)
{
  Exact_rational result(0);
  for (int i = 0; i < d; ++i) {
    const Exact_rational difference(a[i] - b[i]);
    result += Exact_rational(difference * difference);
  }
  return result;
}

// Bounds of the squared distances between the points of two patches; where its derivatives are small, their error is
// that times the width, by the mean value theorem.
template <int d>
Rational_interval squared_distance_bounds(const Spline_patch<d>& a, const Spline_patch<d>& b)
{
  const Vector_bounds<d> offset = a.values() - b.values();
  Rational_interval by_slopes(squared_distance_of<d>(a(a.middle()), b(b.middle())));
  for (const Spline_patch<d>* patch : {&a, &b})
    for (int axis = 0; axis < patch->number_of_parameters(); ++axis) {
      const auto [begin, end] = patch->domain(axis);
      // twice the distance from the middle, and the derivative is twice the inner product
      const Exact_rational width(end - begin);
      by_slopes = by_slopes + dot(offset, patch->tangents(axis)) * Rational_interval(Exact_rational(-width), width);
    }
  return intersection(squared_norm(offset), by_slopes);
}

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template class Spline_patch<2>;
extern template class Spline_patch<3>;
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_PATCH_H
