// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_MOTION_FIELD_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_MOTION_FIELD_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
A part of a motion T = (M x + c) / w on which its field of velocities is continuous up to positive factors. The field is
seen from the moving space: up to factors it is B(t) x + b(t), where

  B = w adj(M) M' - w' det(M) I,   b = adj(M) (w c' - w' c).

What these twelve polynomials have in common is divided out, so that B and b have the degrees of 2 Im(conj(a) a') for a
rotation by a quaternion a: constants for a turn about an axis. The velocity itself, seen from the moving space, is
B(t) x + b(t) times speed / scale.
*/
struct Motion_part
{
  std::vector<Exact_rational> times;                          // the breaks
  std::array<Exact_function, 12> entries;                     // B, row by row, and b
  std::vector<Bernstein_tensor<Exact_rational>> speed, scale; // between neighbouring breaks

  bool is_translation() const
  {
    return std::all_of(entries.begin(), entries.begin() + 9, [](const Exact_function& f) {
      return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                         [](const Exact_rational& x) { return x == 0; });
    });
  }
};

// The field between two neighbouring breaks, in a time that runs from 0 to 1.
class Field_of_piece
{
  std::vector<Power_polynomial> m_entries = std::vector<Power_polynomial>(12);
  Power_polynomial m_speed{1}, m_scale{1}; // the velocity is the field times their quotient

public:
  Field_of_piece(const Rational_motion_3& motion, const Exact_rational& begin, const Exact_rational& end)
  {
    const auto piece = [&](const Exact_function& f) {
      return polynomial_of(part_of(f, 0, {begin, end}).bezier_pieces().front());
    };
    std::array<std::array<Power_polynomial, 3>, 4> m, slope;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        m[k][i] = piece(motion.columns()[k][i]);
        slope[k][i] = m[k][i].derivative(0);
      }
    const Power_polynomial w = piece(motion.weight()), w_slope = w.derivative(0);
    const auto adjoint = [&](std::size_t row, std::size_t column) { // m[k][i] is the entry (i, k)
      const std::size_t a = (column + 1) % 3, b = (column + 2) % 3, c = (row + 1) % 3, d = (row + 2) % 3;
      return m[c][a] * m[d][b] - m[d][a] * m[c][b];
    };
    Power_polynomial determinant;
    for (std::size_t i = 0; i < 3; ++i)
      determinant += adjoint(0, i) * m[0][i];
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        Power_polynomial sum;
        for (std::size_t j = 0; j < 3; ++j)
          sum += adjoint(i, j) * (k < 3 ? w * slope[k][j] : w * slope[k][j] - w_slope * m[k][j]);
        m_entries[k < 3 ? 3 * i + k : 9 + i] = k == i ? sum - w_slope * determinant : sum;
      }
    reduce(w * determinant * Power_polynomial(Exact_rational(end - begin)));
  }

  bool is_zero() const
  {
    return std::all_of(m_entries.begin(), m_entries.end(), [](const Power_polynomial& f) { return f.is_zero(); });
  }

  int degree() const
  {
    int result = 0;
    for (const Power_polynomial& f : m_entries)
      result = (std::max)(result, f.degree(0));
    return result;
  }

  std::vector<Exact_rational> at(const Exact_rational& time) const
  {
    std::vector<Exact_rational> result;
    for (const Power_polynomial& f : m_entries)
      result.push_back(f(std::array{time}));
    return result;
  }

  void multiply(const Exact_rational& factor)
  {
    for (Power_polynomial& f : m_entries)
      f *= Power_polynomial(factor);
    m_scale *= Power_polynomial(factor);
  }

  Bernstein_tensor<Exact_rational> entry(std::size_t k, int degree) const { return tensor(m_entries[k], degree); }
  Bernstein_tensor<Exact_rational> speed() const { return tensor(m_speed, m_speed.degree(0)); }
  Bernstein_tensor<Exact_rational> scale() const { return tensor(m_scale, m_scale.degree(0)); }

private:
  static Bernstein_tensor<Exact_rational> tensor(const Power_polynomial& f, int degree)
  {
    std::vector<Exact_rational> powers(static_cast<std::size_t>(degree) + 1, Exact_rational(0));
    for (const auto& [monomial, coefficient] : f.terms())
      powers[static_cast<std::size_t>(monomial.exponent(0))] = coefficient;
    return Bernstein_tensor<Exact_rational>::from_power({degree}, std::move(powers));
  }

  // Without common factors, in the same direction as before at a time where that is not zero. `factor` is that by which
  // the entries before differ from the velocity.
  void reduce(const Power_polynomial& factor)
  {
    if (is_zero())
      return;
    m_scale = factor;
    while (auto common = common_factor(m_entries)) {
      m_entries = std::move(common->cofactors);
      m_speed *= common->factor;
    }
    if (is_negative(m_speed))
      multiply(Exact_rational(-1));
    const std::vector<Power_polynomial> fraction = without_common_factors({m_speed, m_scale});
    m_speed = fraction[0];
    m_scale = fraction[1];
  }

  // At a time where it is not zero.
  static bool is_negative(const Power_polynomial& f)
  {
    for (int n = 2;; ++n) // ends: polynomials have finitely many zeros
      if (const Exact_rational value = f(std::array{Exact_rational(Exact_rational(1) / n)}); value != 0)
        return value < 0;
  }
};

// The positive factor by which the begin of a field differs from the end of the one before, if there is one.
inline std::optional<Exact_rational> positive_ratio(const std::vector<Exact_rational>& before,
                                                    const std::vector<Exact_rational>& after)
{
  std::optional<Exact_rational> result;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k] == 0 && after[k] == 0)
      continue;
    if (before[k] == 0 || after[k] == 0 || (result && before[k] != *result * after[k]))
      return std::nullopt;
    result = Exact_rational(before[k] / after[k]);
  }
  return result && *result > 0 ? result : std::nullopt;
}

inline Motion_part motion_part(const std::vector<Exact_rational>& times, const std::vector<Field_of_piece>& fields)
{
  int degree = 0;
  for (const Field_of_piece& field : fields)
    degree = (std::max)(degree, field.degree());
  Motion_part result{times, {}, {}, {}};
  const bool is_constant = degree == 0; // one value, as the fields are continuous
  std::vector<Exact_rational> knots(static_cast<std::size_t>(degree) + 1, times.front());
  for (std::size_t i = 1; i + 1 < times.size() && !is_constant; ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(degree), times[i]);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, times.back());
  for (std::size_t k = 0; k < 12; ++k) {
    std::vector<Exact_rational> coefficients = fields.front().entry(k, degree).coefficients();
    for (std::size_t f = 1; f < fields.size() && !is_constant; ++f) {
      const std::vector<Exact_rational> next = fields[f].entry(k, degree).coefficients();
      coefficients.insert(coefficients.end(), next.begin() + 1, next.end());
    }
    result.entries[k] = Exact_function({degree}, {knots}, std::move(coefficients));
  }
  for (const Field_of_piece& field : fields) {
    result.speed.push_back(field.speed());
    result.scale.push_back(field.scale());
  }
  return result;
}

// The parts of a motion, cut where a velocity jumps, and where it begins and ends to stand still.
inline std::vector<Motion_part> motion_parts(const Rational_motion_3& motion)
{
  std::vector<Exact_rational> times = motion.weight().breaks(0);
  for (const auto& column : motion.columns())
    for (const Exact_function& f : column)
      times = united(times, f.breaks(0));
  std::vector<Motion_part> result;
  std::vector<Exact_rational> own{times.front()};
  std::vector<Field_of_piece> fields;
  for (std::size_t i = 1; i < times.size(); ++i) {
    Field_of_piece field(motion, times[i - 1], times[i]);
    if (!fields.empty()) {
      const bool both_stand_still = field.is_zero() && fields.back().is_zero();
      const auto ratio = positive_ratio(fields.back().at(Exact_rational(1)), field.at(Exact_rational(0)));
      if (ratio)
        field.multiply(*ratio);
      else if (!both_stand_still) {
        result.push_back(motion_part(own, fields));
        fields.clear();
        own = {times[i - 1]};
      }
    }
    fields.push_back(std::move(field));
    own.push_back(times[i]);
  }
  result.push_back(motion_part(own, fields));
  return result;
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_MOTION_FIELD_H
