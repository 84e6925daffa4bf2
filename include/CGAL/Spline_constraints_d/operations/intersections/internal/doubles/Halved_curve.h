// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_HALVED_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_HALVED_CURVE_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

struct Plane_vector
{
  double x = 0, y = 0;

  friend Plane_vector operator+(const Plane_vector& a, const Plane_vector& b) { return {a.x + b.x, a.y + b.y}; }
  friend Plane_vector operator-(const Plane_vector& a, const Plane_vector& b) { return {a.x - b.x, a.y - b.y}; }
  friend Plane_vector operator*(double s, const Plane_vector& a) { return {s * a.x, s * a.y}; }
};

inline double determinant(const Plane_vector& a, const Plane_vector& b) { return a.x * b.y - a.y * b.x; }
inline double sum_norm(const Plane_vector& a) { return std::abs(a.x) + std::abs(a.y); }
inline double greatest_norm(const Plane_vector& a) { return (std::max)(std::abs(a.x), std::abs(a.y)); }

/*
A planar polynomial Bezier curve over [0,1] in doubles, its halves, their halves, and so on, which are made when they
are asked for. Control points have errors with a bound; that holds whatever the rounding mode, where an operation errs
by `unit` times its result at most.
*/
class Halved_curve
{
public:
  static constexpr double unit = 0x1p-52;
  static constexpr std::size_t greatest_degree = 24;
  // How far a part is continued on both sides, in shares of its range.
  static constexpr double margin = 0x1p-7;

  struct Part
  {
    double begin = 0, width = 1;      // of its range: binary fractions
    double error = 0;                 // of the coordinates of its control points
    Plane_vector lower, upper;        // of the control points
    Plane_vector normal;              // of the chord, as long as that
    double least_side, greatest_side; // the range of <normal, control points>
    double step = 0;                  // the greatest one, by the sum of coordinates
    double step_error = 0;            // where steps are taken for derivatives over the degree, also of what continues
    std::size_t first = 0;            // of its control points, and then the steps between them
    std::size_t halves = 0;           // the first one's number; 0: not made
  };

private:
  std::size_t m_degree;
  double m_size = 0; // the greatest coordinate
  Scratch_vector<Plane_vector> m_vectors;
  Scratch_vector<Part> m_parts;

public:
  //! \pre The degree is positive and at most the greatest one.
  explicit Halved_curve(const std::array<std::span<const double>, 2>& coordinates) : m_degree(coordinates[0].size() - 1)
  {
    constexpr std::size_t usual_parts = 31;
    m_parts.reserve(usual_parts);
    m_vectors.reserve(usual_parts * (2 * m_degree + 1));
    for (std::size_t i = 0; i <= m_degree; ++i) {
      m_vectors.push_back({coordinates[0][i], coordinates[1][i]});
      m_size = (std::max)(m_size, greatest_norm(m_vectors.back()));
    }
    add_part(0, 1, 0);
  }

  std::size_t degree() const { return m_degree; }
  double size() const { return m_size; }
  const Part& operator[](std::size_t part) const { return m_parts[part]; }
  std::span<const Plane_vector> points(const Part& part) const { return {&m_vectors[part.first], m_degree + 1}; }
  std::span<const Plane_vector> steps(const Part& part) const
  {
    return {&m_vectors[part.first + m_degree + 1], m_degree};
  }

  // The number of the first half; the other one is the next.
  std::size_t halves(std::size_t part)
  {
    if (m_parts[part].halves == 0)
      add_halves(part);
    return m_parts[part].halves;
  }

  struct Position
  {
    Plane_vector point, derivative;
  };

  // Rounded, at a place in the part from 0 to 1: by de Casteljau's scheme.
  Position position(const Part& part, double place) const
  {
    std::array<Plane_vector, greatest_degree + 1> row;
    const std::span<const Plane_vector> own = points(part);
    std::copy(own.begin(), own.end(), row.begin());
    for (std::size_t last = m_degree; last > 1; --last)
      for (std::size_t i = 0; i < last; ++i)
        row[i] = row[i] + place * (row[i + 1] - row[i]);
    const Plane_vector step = row[1] - row[0];
    return {row[0] + place * step, static_cast<double>(m_degree) * step};
  }

private:
  // The control points are the last vectors.
  void add_part(double begin, double width, double error)
  {
    Part part;
    part.begin = begin;
    part.width = width;
    part.error = error;
    part.first = m_vectors.size() - m_degree - 1;
    for (std::size_t i = 0; i < m_degree; ++i)
      m_vectors.push_back(m_vectors[part.first + i + 1] - m_vectors[part.first + i]);
    set_bounds(part);
    m_parts.push_back(part);
  }

  void set_bounds(Part& part) const
  {
    const std::span<const Plane_vector> own = points(part), differences = steps(part);
    const Plane_vector chord = own.back() - own.front();
    part.lower = part.upper = own[0];
    part.normal = {-chord.y, chord.x};
    part.least_side = part.greatest_side = side(part, own[0]);
    for (const Plane_vector& p : own.subspan(1)) {
      part.lower = {(std::min)(part.lower.x, p.x), (std::min)(part.lower.y, p.y)};
      part.upper = {(std::max)(part.upper.x, p.x), (std::max)(part.upper.y, p.y)};
      const double own_side = side(part, p);
      part.least_side = (std::min)(part.least_side, own_side);
      part.greatest_side = (std::max)(part.greatest_side, own_side);
    }
    double bend = 0;
    for (std::size_t i = 0; i < m_degree; ++i) {
      part.step = (std::max)(part.step, sum_norm(differences[i]));
      if (i > 0)
        bend = (std::max)(bend, greatest_norm(differences[i] - differences[i - 1]));
    }
    // Beyond its range the second derivative is at most (1 + 2 margin)^(n - 2) < 2 times that of the part.
    const double rounding = 2 * part.error + 2 * unit * m_size;
    part.step_error = rounding + 2.1 * margin * static_cast<double>(m_degree - 1) * (bend + 2 * rounding);
  }

public:
  static double side(const Part& part, const Plane_vector& p) { return part.normal.x * p.x + part.normal.y * p.y; }

private:
  // By de Casteljau's scheme: each of its n rows of means errs by a unit of the size, and passes errors on.
  void add_halves(std::size_t number)
  {
    const Part whole = m_parts[number];
    const double error = whole.error + 1.01 * unit * static_cast<double>(m_degree) * m_size;
    std::array<Plane_vector, greatest_degree + 1> row, left;
    const std::span<const Plane_vector> own = points(whole);
    std::copy(own.begin(), own.end(), row.begin());
    for (std::size_t last = m_degree, r = 0; r <= m_degree; --last, ++r) {
      left[r] = row[0];
      for (std::size_t i = 0; i < last; ++i)
        row[i] = 0.5 * (row[i] + row[i + 1]);
    }
    m_parts[number].halves = m_parts.size();
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(m_degree) + 1;
    m_vectors.insert(m_vectors.end(), left.begin(), left.begin() + size);
    add_part(whole.begin, 0.5 * whole.width, error);
    m_vectors.insert(m_vectors.end(), row.begin(), row.begin() + size);
    add_part(whole.begin + 0.5 * whole.width, 0.5 * whole.width, error);
  }
};

// Whether no point of a part of a curve is on a part of another one, by the sides of one line that control points are
// on, or of the axes. With greater coordinates than those of both.
inline bool are_apart(const Halved_curve& first, const Halved_curve::Part& a, const Halved_curve& second,
                      const Halved_curve::Part& b, double size)
{
  const double error = a.error + b.error + 8 * Halved_curve::unit * size;
  if (a.lower.x - b.upper.x > error || b.lower.x - a.upper.x > error || a.lower.y - b.upper.y > error ||
      b.lower.y - a.upper.y > error)
    return true;
  const auto are_apart_by_chord = [&](const Halved_curve::Part& p, const Halved_curve& curve,
                                      const Halved_curve::Part& q) {
    const double length = sum_norm(p.normal);
    if (!(length > 0x1p-100 * size)) // products of shorter ones may be rounded to zero
      return false;
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (const Plane_vector& point : curve.points(q)) {
      const double side = Halved_curve::side(p, point);
      least = (std::min)(least, side);
      greatest = (std::max)(greatest, side);
    }
    return (std::max)(least - p.greatest_side, p.least_side - greatest) > length * error;
  };
  return are_apart_by_chord(a, second, b) || are_apart_by_chord(b, first, a);
}

/*
Whether two parts, and what continues them by the margin, meet in one point at most: where no tangent of one is parallel
to one of the other. The difference of A(t) - B(s) at two places is a mean of A' times the difference of t, less one of
B' times that of s, and means are in the convex hulls of the control points of derivatives.
*/
inline bool meet_once_at_most(const Halved_curve& first, const Halved_curve::Part& a, const Halved_curve& second,
                              const Halved_curve::Part& b)
{
  const double least = 1.01 *
      (a.step_error * b.step + b.step_error * a.step + 2 * a.step_error * b.step_error +
       4 * Halved_curve::unit * a.step * b.step);
  const std::span<const Plane_vector> steps = first.steps(a), others = second.steps(b);
  const double sign = determinant(steps.front(), others.front()) > 0 ? 1 : -1;
  return std::all_of(steps.begin(), steps.end(), [&](const Plane_vector& p) {
    return std::all_of(others.begin(), others.end(),
                       [&](const Plane_vector& q) { return sign * determinant(p, q) > least; });
  });
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_HALVED_CURVE_H
