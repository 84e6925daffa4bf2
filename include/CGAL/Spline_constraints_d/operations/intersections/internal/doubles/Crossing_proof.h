// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_CROSSING_PROOF_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_CROSSING_PROOF_H

#include <CGAL/Spline_constraints_d/number/Double_word.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/doubles/Halved_curve.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A pair of parameters of a common point, in ranges that are proved to hold exactly one.
struct Crossing
{
  std::array<std::pair<double, double>, 2> ranges; // narrow ones
  std::array<std::pair<double, double>, 2> around; // in which there is no other, either
};

/*
Proves that two polynomial Bezier curves A and B over [0,1] meet once in a box around two parameters, by Krawczyk's test
of F(t,s) = A(t) - B(s): F in two words, derivatives in intervals. So the ranges are about as narrow as doubles can be.
*/
class Crossing_proof
{
  using Coordinates = std::array<std::span<const double>, 2>;

  std::array<Coordinates, 2> m_curves;

public:
  Crossing_proof(const Coordinates& first, const Coordinates& second) : m_curves{first, second} {}

  // At parameters near the common point, and with derivatives of both curves near to those there.
  std::optional<Crossing> operator()(const std::array<double, 2>& place, const Plane_vector& a,
                                     const Plane_vector& b) const
  {
    const std::array<Double_word, 2> difference{value(m_curves[0][0], place[0]) - value(m_curves[1][0], place[1]),
                                                value(m_curves[0][1], place[0]) - value(m_curves[1][1], place[1])};
    const double det = determinant(a, b);
    // about the inverse of the matrix (A', -B')
    const std::array<std::array<double, 2>, 2> inverse{{{b.y / det, -b.x / det}, {a.y / det, -a.x / det}}};
    if (!difference[0].is_finite() || !difference[1].is_finite() || !(std::abs(inverse[0][0]) < HUGE_VAL))
      return std::nullopt;

    const Upward_rounding_guard guard;
    const Interval_pair f{enclosure(difference[0]), enclosure(difference[1])};
    const Interval_pair step = product(inverse, f);
    std::array<double, 2> radius{};
    for (const std::size_t k : {0, 1})
      radius[k] = 2 * greatest_magnitude(step[k]) + 0x1p-50 * std::abs(place[k]) + 0x1p-90;
    constexpr int most_attempts = 2;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      const Interval_pair box{around(place[0], radius[0]), around(place[1], radius[1])};
      const Interval_pair tangent = derivative(0, box[0]), other = derivative(1, box[1]);
      const Interval_pair first = product(inverse, tangent), second = product(inverse, {-other[0], -other[1]});
      const Interval x(-radius[0], radius[0]), y(-radius[1], radius[1]);
      const Interval_pair result{Interval(place[0]) - step[0] + ((Interval(1) - first[0]) * x - second[0] * y),
                                 Interval(place[1]) - step[1] + ((Interval(1) - second[1]) * y - first[1] * x)};
      if (is_inside(result[0], box[0]) && is_inside(result[1], box[1]))
        return Crossing{{ends(result[0]), ends(result[1])}, {ends(box[0]), ends(box[1])}};
      for (const std::size_t k : {0, 1})
        radius[k] = 4 * greatest_magnitude(result[k] - Interval(place[k]));
    }
    return std::nullopt;
  }

private:
  static std::pair<double, double> ends(const Interval& x) { return {x.inf(), x.sup()}; }
  static double greatest_magnitude(const Interval& x) { return (std::max)(std::abs(x.inf()), std::abs(x.sup())); }
  static bool is_inside(const Interval& x, const Interval& box) { return box.inf() < x.inf() && x.sup() < box.sup(); }
  static Interval around(double x, double radius) { return Interval(x) + Interval(-radius, radius); }

  static Interval enclosure(const Double_word& x)
  {
    const double rest = x.error_with() + Halved_curve::unit * std::abs(x.nearest()); // the low word, too
    return around(x.nearest(), rest);
  }

  static Interval_pair product(const std::array<std::array<double, 2>, 2>& matrix, const Interval_pair& v)
  {
    return {Interval(matrix[0][0]) * v[0] + Interval(matrix[0][1]) * v[1],
            Interval(matrix[1][0]) * v[0] + Interval(matrix[1][1]) * v[1]};
  }

  // The value of a polynomial in Bernstein form by Horner's scheme for it.
  static Double_word value(std::span<const double> coefficients, double t)
  {
    const std::size_t degree = coefficients.size() - 1;
    const Double_word place(t), rest = Double_word(1.0) - place;
    Double_word power(1.0), result = Double_word(coefficients[0]) * rest;
    double binomial = 1;
    for (std::size_t i = 1; i < degree; ++i) {
      power = power * place;
      binomial = binomial * static_cast<double>(degree - i + 1) / static_cast<double>(i); // an exact integer
      result = (result + power * Double_word(binomial) * Double_word(coefficients[i])) * rest;
    }
    return result + power * place * Double_word(coefficients[degree]);
  }

  Interval_pair derivative(std::size_t curve, const Interval& t) const
  {
    return {derivative(m_curves[curve][0], t), derivative(m_curves[curve][1], t)};
  }

  static Interval derivative(std::span<const double> coefficients, const Interval& t)
  {
    const std::size_t degree = coefficients.size() - 1;
    std::array<Interval, Halved_curve::greatest_degree> row;
    for (std::size_t i = 0; i < degree; ++i)
      row[i] = Interval(coefficients[i + 1]) - Interval(coefficients[i]);
    const Interval rest = Interval(1) - t;
    for (std::size_t last = degree - 1; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i)
        row[i] = rest * row[i] + t * row[i + 1];
    return Interval(static_cast<double>(degree)) * row[0];
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_DOUBLES_CROSSING_PROOF_H
