// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_ELEMENT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_ELEMENT_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_arc_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

/*
The tangents of a piece of a boundary: a point p is on the left of the tangent at t, or on it, if a(t) x + b(t) y + c(t)
>= 0.
*/
struct Tangent_family
{
  Boundary_piece piece;
  Exact_tensor a, b, c;

  // Factors that all coefficients have at an end are left out: the tangents are their limits there.
  explicit Tangent_family(const Boundary_piece& p);

  Exact_tensor at(const Exact_pair& p) const { return a * p[0] + b * p[1] + c; }

  // Its sign is that of the curvature.
  Exact_tensor curvature() const;

private:
  static bool vanishes_at(int end, const Exact_tensor& f)
  {
    return (end == 0 ? f.coefficients().front() : f.coefficients().back()) == 0;
  }
};

/*
Tangents that bound a kernel, seen from a point in its interior, the origin: those of an arc that turns left, or one.
The tangent n x + m y <= 1 is the point (n, m) of the dual plane, in which the kernel becomes the convex hull of these
points. The height of the hull in a direction is the inverse of the distance of the boundary of the kernel.
*/
class Kernel_element_2
{
  Boundary_piece m_piece;
  Exact_tensor m_n, m_m, m_one;           // the dual curve, in homogeneous coordinates
  std::array<Exact_root, 2> m_ends;       // in the order of parameters; the same one of a tangent

public:
  // Of what its dual points have the greatest height in a direction: at the begin, at the end, or between them.
  enum class Place { BEGIN, END, INSIDE };

  struct Summit
  {
    Rational_interval height;
    Place place;
    Parameter_range range;   // local
  };

  Kernel_element_2(const Tangent_family& tangents, const Exact_pair& origin, std::array<Exact_root, 2> ends)
    : m_piece(tangents.piece), m_n(-tangents.a), m_m(-tangents.b), m_one(tangents.at(origin)), m_ends(std::move(ends))
  {
    for (std::size_t k = 0; k < 2; ++k)
      m_piece.coordinates[k] -= m_piece.coordinates[2] * origin[k];
  }

  std::size_t curve() const { return m_piece.curve; }
  bool is_line() const
  {
    return m_ends[0].is_point() && m_ends[1].is_point() && m_ends[0].lower() == m_ends[1].lower();
  }
  Parameter_range range_of_end(int end) const { return {m_ends[end].lower(), m_ends[end].upper()}; }

  // The dual point of an end that is known exactly.
  std::optional<Exact_pair> dual_of_end(int end) const;

  std::optional<Exact_pair> point_of_end(int end) const
  {
    return m_ends[end].is_point() ? std::optional<Exact_pair>(m_piece.at(m_ends[end].lower())) : std::nullopt;
  }

  Kernel_element_2 tangent_at(int end) const;

  // Whether it spans less than a half-turn around the origin.
  bool is_short() const
  {
    return is_line() || exact_cross(m_piece.at(m_ends[0].upper()), m_piece.at(m_ends[1].lower())) > 0;
  }

  std::array<Kernel_element_2, 2> halves() const;

  // The summit in the direction d: where the ray from the origin passes through the arc, or at an end. \pre it is short
  Summit summit(const Exact_pair& d) const;

  // Of the dual points of a range.
  Rational_interval height(const Parameter_range& range, const Exact_pair& d) const;

  // Parameters of the curve for local ones.
  Parameter_range on_curve(const Parameter_range& range) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Tangent_family::Tangent_family(const Boundary_piece& p) : piece(p)
{
  const auto& [x, y, w] = piece.coordinates;
  const Exact_tensor dx = x.derivative(0), dy = y.derivative(0), dw = w.derivative(0);
  a = y * dw - dy * w;
  b = dx * w - x * dw;
  c = x * dy - y * dx;
  for (const int end : {0, 1})
    while (a.degree(0) > 0 && vanishes_at(end, a) && vanishes_at(end, b) && vanishes_at(end, c))
      for (Exact_tensor* f : {&a, &b, &c})
        *f = without_zero_at(end, *f);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_tensor Tangent_family::curvature() const
{
  const auto& [x, y, w] = piece.coordinates;
  const std::array<Exact_tensor, 3> first{x.derivative(0), y.derivative(0), w.derivative(0)},
      second{first[0].derivative(0), first[1].derivative(0), first[2].derivative(0)};
  return x * (first[1] * second[2] - first[2] * second[1]) - y * (first[0] * second[2] - first[2] * second[0]) +
      w * (first[0] * second[1] - first[1] * second[0]);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_pair> Kernel_element_2::dual_of_end(int end) const
{
  if (!m_ends[end].is_point())
    return std::nullopt;
  const std::array<Exact_rational, 1> u{m_ends[end].lower()};
  const Exact_rational one = m_one(u);
  return Exact_pair{Exact_rational(m_n(u) / one), Exact_rational(m_m(u) / one)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Kernel_element_2 Kernel_element_2::tangent_at(int end) const
{
  Kernel_element_2 result(*this);
  result.m_ends[1 - end] = m_ends[end];
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Kernel_element_2, 2> Kernel_element_2::halves() const
{
  const Exact_root middle(simple_dyadic_between(m_ends[0].upper(), m_ends[1].lower()));
  std::array<Kernel_element_2, 2> result{*this, *this};
  result[0].m_ends[1] = result[1].m_ends[0] = middle;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Kernel_element_2::Summit Kernel_element_2::summit(const Exact_pair& d) const
{
  if (!is_line()) {
    const auto& [x, y, w] = m_piece.coordinates;
    const Integer_polynomial side = integer_polynomial(y * d[0] - x * d[1]); // increases through zero at the ray
    const Exact_rational &lower = m_ends[0].upper(), &upper = m_ends[1].lower();
    if (side.sign_at(lower) < 0 && side.sign_at(upper) > 0) {
      Exact_root root(std::make_shared<const Integer_polynomial>(side), lower, upper, CGAL::NEGATIVE);
      narrow(root, narrow_sight());
      const Parameter_range range{root.lower(), root.upper()};
      return {height(range, d), Place::INSIDE, range};
    }
  }
  const Rational_interval begin = height(range_of_end(0), d), end = height(range_of_end(1), d);
  return begin.lower > end.lower
      ? Summit{{begin.lower, (std::max)(begin.upper, end.upper)}, Place::BEGIN, range_of_end(0)}
      : Summit{{end.lower, (std::max)(begin.upper, end.upper)}, Place::END, range_of_end(1)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_interval Kernel_element_2::height(const Parameter_range& range,
                                                                          const Exact_pair& d) const
{
  const Exact_tensor value = (m_n * d[0] + m_m * d[1]).restricted(0, range.first, range.second),
                     one = m_one.restricted(0, range.first, range.second);
  const auto quotient = [&](std::size_t k) {
    return Rational_interval(Exact_rational(value.coefficients()[k] / one.coefficients()[k]));
  };
  Rational_interval result = quotient(0);
  for (std::size_t k = 1; k < value.coefficients().size() && range.first < range.second; ++k)
    result = hull(result, quotient(k));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Parameter_range Kernel_element_2::on_curve(const Parameter_range& range) const
{
  const auto value = [&](const Exact_rational& t) {
    return Exact_rational(m_piece.parameters[0] + t * (m_piece.parameters[1] - m_piece.parameters[0]));
  };
  const Exact_rational first = value(range.first), second = value(range.second);
  return {(std::min)(first, second), (std::max)(first, second)};
}
#endif

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_ELEMENT_2_H
