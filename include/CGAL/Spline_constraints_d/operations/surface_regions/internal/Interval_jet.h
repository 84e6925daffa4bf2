// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_INTERVAL_JET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_INTERVAL_JET_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/surface_cells.h>

#include <CGAL/Interval_nt.h>

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
namespace Surface_regions {

using Interval = CGAL::Interval_nt<false>; // within an Upward_rounding_guard
using Interval_vector = std::array<Interval, 3>;

// Ranges of two parameters; one may be a number.
using Parameter_rectangle = std::array<std::pair<double, double>, 2>;

inline Interval interval_of(const Exact_rational& x)
{
  const auto [lower, upper] = to_double_interval(x);
  return {lower, upper};
}

inline Interval hull_of(const Interval& a, const Interval& b)
{
  return {(std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup())};
}

inline Interval_vector hull_of(const Interval_vector& a, const Interval_vector& b)
{
  return {hull_of(a[0], b[0]), hull_of(a[1], b[1]), hull_of(a[2], b[2])};
}

inline double middle_of(const std::pair<double, double>& range) { return 0.5 * (range.first + range.second); }

inline bool is_positive(const Interval& x) { return x.inf() > 0; }
inline bool is_negative(const Interval& x) { return x.sup() < 0; }
inline bool has_zero(const Interval& x) { return !is_positive(x) && !is_negative(x); }
inline double middle_of(const Interval& x) { return 0.5 * (x.inf() + x.sup()); }
inline Interval around_zero(double radius) { return {-radius, radius}; }

inline Interval dot(const Interval_vector& a, const Interval_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Interval_vector cross(const Interval_vector& a, const Interval_vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Interval_vector operator+(const Interval_vector& a, const Interval_vector& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Interval_vector operator-(const Interval_vector& a, const Interval_vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Interval_vector operator*(const Interval& f, const Interval_vector& a) { return {f * a[0], f * a[1], f * a[2]}; }

// A point of a rational map of two parameters over the middle of a rectangle, and ranges over all of it: of points, and
// of derivatives by uu, uv, vv if these are asked for.
struct Interval_jet
{
  Parameter_rectangle box;
  Interval_vector middle, value;
  std::array<Interval_vector, 2> first;
  std::array<Interval_vector, 3> second;

  // What is reached from the middle along an axis, at most.
  double half_width(std::size_t axis) const
  {
    const auto [begin, end] = box[axis];
    const double middle = middle_of(box[axis]);
    return (std::max)(end - middle, middle - begin);
  }

  Interval offset(std::size_t axis) const { return around_zero(half_width(axis)); }
};

// Places in the unit interval, multiples of a power of two, so that 1 - t is exact.
struct Unit_range
{
  double begin, end;

  static Unit_range around(const Interval& first, const Interval& last)
  {
    return {lower(first.inf()), -lower(-last.sup())};
  }

  static double lower(double t) { return std::floor(std::clamp(t, -1., 1.) * 0x1p50) * 0x1p-50; }
};

// A polynomial in two parameters with intervals as coefficients.
class Interval_tensor
{
public:
  // The lower end times -1, and the upper one: rounded upwards, both move outwards.
  struct Coefficient
  {
    double minus_lower, upper;

    Interval range() const { return {-minus_lower, upper}; }
  };
  using Coefficients = std::vector<Coefficient>;

private:
  std::array<std::size_t, 2> m_degrees;
  Coefficients m_coefficients;

public:
  explicit Interval_tensor(const Cell_polynomial& f)
    : m_degrees{static_cast<std::size_t>(f.degree(0)), static_cast<std::size_t>(f.degree(1))}
  {
    for (const Exact_rational& c : f.coefficients()) {
      const Interval x = interval_of(c);
      m_coefficients.push_back({-x.inf(), x.sup()});
    }
  }

  // The coefficients over a rectangle in the unit box.
  void restrict_to(const std::array<Unit_range, 2>& ranges, Coefficients& result) const
  {
    result = m_coefficients;
    const std::size_t columns = m_degrees[1] + 1;
    if (m_degrees[0] > 0)
      for (std::size_t j = 0; j < columns; ++j)
        restrict_line(&result[j], columns, m_degrees[0], ranges[0]);
    if (m_degrees[1] > 0)
      for (std::size_t i = 0; i <= m_degrees[0]; ++i)
        restrict_line(&result[i * columns], 1, m_degrees[1], ranges[1]);
  }

private:
  // By de Casteljau's algorithm: to what is before the end, and of that to what is behind the beginning.
  static void restrict_line(Coefficient* c, std::size_t step, std::size_t degree, const Unit_range& range)
  {
    const auto mean = [&](std::size_t i, std::size_t j, double rest, double t) {
      const Coefficient &a = c[i * step], &b = c[j * step];
      return Coefficient{rest * a.minus_lower + t * b.minus_lower, rest * a.upper + t * b.upper};
    };
    if (range.end != 1) {
      const double rest = 1 - range.end;
      for (std::size_t k = 1; k <= degree; ++k)
        for (std::size_t i = degree; i >= k; --i)
          c[i * step] = mean(i - 1, i, rest, range.end);
    }
    if (range.begin == 0)
      return;
    const double ratio = Unit_range::lower((Interval(range.begin) / Interval(range.end)).inf()), rest = 1 - ratio;
    for (std::size_t k = 1; k <= degree; ++k)
      for (std::size_t i = 0; i + k <= degree; ++i)
        c[i * step] = mean(i, i + 1, rest, ratio);
  }
};

// A rational map X/w of two parameters without breaks over a rectangle, with w > 0. Derivatives are quotients of
// polynomials, too.
class Interval_piece
{
  std::array<Interval, 4> m_domain;                 // the ends of both parameters
  std::vector<std::vector<Interval_tensor>> m_maps; // by nothing, u, v, uu, uv, vv

public:
  Interval_piece(const Surface_cell_3::Coordinates& coordinates, const std::array<Surface_cell_3::Range, 2>& domain)
    : m_domain{interval_of(domain[0].first), interval_of(domain[0].second), interval_of(domain[1].first),
               interval_of(domain[1].second)}
  {
    const Cell_polynomial& w = coordinates[3];
    const bool is_rational = !std::ranges::all_of(w.coefficients(), [](const Exact_rational& c) { return c == 1; });
    const auto derivative = [&](const Cell_polynomial& f, int axis) {
      const auto& [begin, end] = domain[static_cast<std::size_t>(axis)];
      return f.derivative(axis) * Exact_rational(1 / (end - begin));
    };
    // X / w^k has the derivative (X' w - k X w') / w^(k+1).
    const auto quotient = [&](const Cell_vector& x, int power, int axis) {
      Cell_vector result = x;
      for (Cell_polynomial& f : result)
        f = is_rational ? derivative(f, axis) * w - f * derivative(w, axis) * Exact_rational(power)
                        : derivative(f, axis);
      return result;
    };
    const auto add = [&](const Cell_vector& x, int power) {
      std::vector<Interval_tensor>& map = m_maps.emplace_back();
      std::vector<Cell_polynomial> all(x.begin(), x.end());
      if (is_rational) {
        all.push_back(w);
        for (int k = 1; k < power; ++k)
          all.back() *= w;
      }
      std::vector<int> degrees{0, 0};
      for (const Cell_polynomial& f : all)
        for (const std::size_t axis : {0, 1})
          degrees[axis] = (std::max)(degrees[axis], f.degree(static_cast<int>(axis)));
      for (const Cell_polynomial& f : all)
        map.emplace_back(f.elevated(degrees));
    };
    const Cell_vector x{coordinates[0], coordinates[1], coordinates[2]}, u = quotient(x, 1, 0), v = quotient(x, 1, 1);
    add(x, 1);
    add(u, 2);
    add(v, 2);
    add(quotient(u, 2, 0), 3);
    add(quotient(u, 2, 1), 3);
    add(quotient(v, 2, 1), 3);
  }

  // \pre The rectangle is in the domain.
  Interval_jet jet(const Parameter_rectangle& box, bool has_second) const
  {
    Interval_jet result{box, {}, {}, {}, {}};
    const std::array<Unit_range, 2> ends = local(box);
    std::array<Interval_tensor::Coefficients, 4> memory;
    result.value = range(0, ends, memory);
    result.first = {range(1, ends, memory), range(2, ends, memory)};
    if (has_second)
      result.second = {range(3, ends, memory), range(4, ends, memory), range(5, ends, memory)};
    Parameter_rectangle middle = box;
    for (auto& x : middle)
      x.first = x.second = middle_of(x);
    result.middle = range(0, local(middle), memory);
    return result;
  }

private:
  std::array<Unit_range, 2> local(const Parameter_rectangle& box) const
  {
    std::array<Unit_range, 2> result;
    for (const std::size_t axis : {0, 1}) {
      const Interval &begin = m_domain[2 * axis], width = m_domain[2 * axis + 1] - begin;
      const auto place = [&](double x) {
        const Interval t = (Interval(x) - begin) / width;
        return Interval(std::clamp(t.inf(), 0., 1.), std::clamp(t.sup(), 0., 1.));
      };
      result[axis] = Unit_range::around(place(box[axis].first), place(box[axis].second));
    }
    return result;
  }

  // In the hull of the quotients of coefficients.
  Interval_vector range(std::size_t map, const std::array<Unit_range, 2>& ends,
                        std::array<Interval_tensor::Coefficients, 4>& memory) const
  {
    Interval_vector result;
    const std::size_t number = m_maps[map].size();
    for (std::size_t i = 0; i < number; ++i)
      m_maps[map][i].restrict_to(ends, memory[i]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < memory[i].size(); ++k) {
        const Interval x = number == 4 ? memory[i][k].range() / memory[3][k].range() : memory[i][k].range();
        result[i] = k == 0 ? x : hull_of(result[i], x);
      }
    return result;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_INTERVAL_JET_H
