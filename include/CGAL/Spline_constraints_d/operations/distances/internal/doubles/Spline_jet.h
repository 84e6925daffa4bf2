// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_SPLINE_JET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_SPLINE_JET_H

#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/number/Double_word.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/near_fraction.h>
#include <CGAL/Spline_constraints_d/number/two_words.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
The integers modulo the prime 2^61 - 1. Doubles are rational numbers with residues, as powers of two are units. What is
zero is zero here; what is zero here hardly ever is not.
*/
class Residue
{
  static constexpr std::uint64_t prime = (std::uint64_t(1) << 61) - 1;

  std::uint64_t m_value; // below the prime

  struct Reduced
  {};
  Residue(Reduced, std::uint64_t value) : m_value(value) {}

public:
  explicit Residue(std::int64_t x)
    : m_value(x < 0 ? prime - static_cast<std::uint64_t>(-x) % prime : static_cast<std::uint64_t>(x) % prime)
  {
    m_value = m_value == prime ? 0 : m_value;
  }

  // \pre finite
  static Residue of(double x)
  {
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    Residue result(digits);
    const int turn = (((exponent - 53) % 61) + 61) % 61; // 2^61 = 1: digits go round
    if (turn != 0)
      result.m_value = ((result.m_value << turn) & prime) | (result.m_value >> (61 - turn));
    return result;
  }

  friend Residue operator+(const Residue& a, const Residue& b)
  {
    const std::uint64_t sum = a.m_value + b.m_value;
    return {Reduced(), sum >= prime ? sum - prime : sum};
  }
  friend Residue operator-(const Residue& a, const Residue& b)
  {
    return {Reduced(), a.m_value >= b.m_value ? a.m_value - b.m_value : a.m_value + prime - b.m_value};
  }
  friend Residue operator*(const Residue& a, const Residue& b)
  {
    const Unsigned_two_words product = static_cast<Unsigned_two_words>(a.m_value) * b.m_value;
    const std::uint64_t sum = static_cast<std::uint64_t>(product & prime) + static_cast<std::uint64_t>(product >> 61);
    return {Reduced(), sum >= prime ? sum - prime : sum};
  }
  // \pre b is not zero
  friend Residue operator/(const Residue& a, const Residue& b)
  {
    Residue result = a, power = b; // b^(p - 2) is its inverse
    for (std::uint64_t exponent = prime - 2; exponent != 0; exponent >>= 1, power = power * power)
      if (exponent & 1)
        result = result * power;
    return result;
  }
  friend bool operator==(const Residue& a, const Residue& b) = default;
};

template <class Field, class NT>
Field field_element(const NT& x)
{
  if constexpr (std::is_same_v<Field, Residue>)
    return Residue::of(x);
  else if constexpr (std::is_same_v<Field, Double_word> || std::is_same_v<Field, Common::Interval>)
    return Field(x);
  else
    return converted_number<Field>(x);
}

// The index of the knot where a cell begins.
template <class NT>
std::size_t span_of_cell(const std::vector<NT>& knots, int degree, int cell)
{
  auto span = static_cast<std::size_t>(degree);
  for (int k = 0;; ++span)
    if (knots[span] < knots[span + 1] && k++ == cell)
      return span;
}

/*
The homogeneous coordinates (the weight is last) of a point of a spline, and their derivatives by the places in a cell,
in any field, or in what encloses numbers: at a fraction of the cell along each axis, by de Boor's algorithm.
*/
template <class Field, int d>
class Spline_jet
{
  using Coordinates = std::array<Field, d + 1>;
  using Fields = boost::container::small_vector<Field, 16>;

  static Coordinates zero() { return filled(std::make_index_sequence<d + 1>()); }
  template <std::size_t... i>
  static Coordinates filled(std::index_sequence<i...>)
  {
    return {((void)i, field_element<Field>(0.0))...};
  }

public:
  Coordinates value = zero();
  std::array<Coordinates, 2> derivatives{zero(), zero()};

  // A point, which has no derivatives.
  template <class NT>
  explicit Spline_jet(const std::array<NT, d>& point)
  {
    for (int k = 0; k < d; ++k)
      value[k] = field_element<Field>(point[k]);
    value[d] = field_element<Field>(1.0);
  }

  template <class NT>
  Spline_jet(const Homogeneous_spline<NT, d>& spline, const std::array<int, 2>& cells,
             const std::array<Fraction, 2>& at)
  {
    const auto& functions = spline.functions();
    if (const auto index = control_point_at(functions[0], at)) {
      for (int k = 0; k <= d; ++k)
        value[k] = k < d || spline.is_rational() ? field_element<Field>(functions[k].coefficients()[*index])
                                                 : field_element<Field>(1.0);
      return;
    }
    std::array<std::size_t, 2> spans{0, 0};
    for (int axis = 0; axis < spline.dimension(); ++axis)
      spans[axis] = span_of_cell(functions[0].knots(axis), functions[0].degree(axis), cells[axis]);
    const int axes = spline.dimension(), rows = functions[0].degree(0),
              columns = axes == 2 ? functions[0].degree(1) : 0;
    const std::size_t stride = axes == 2 ? functions[0].size(1) : 1;
    const Fields weights = blend_weights(functions[0].knots(0), rows, spans[0], at[0]),
                 other_weights = axes == 2 ? blend_weights(functions[0].knots(1), columns, spans[1], at[1]) : Fields();
    for (int k = 0; k <= d; ++k) {
      if (k == d && !spline.is_rational()) {
        value[d] = field_element<Field>(1.0);
        return;
      }
      Fields values, slopes;
      for (int i = 0; i <= rows; ++i) {
        const NT* row = functions[k].coefficients().data() + (spans[0] - static_cast<std::size_t>(rows - i)) * stride +
            (axes == 2 ? spans[1] - static_cast<std::size_t>(columns) : 0);
        Fields line;
        for (int j = 0; j <= columns; ++j)
          line.push_back(field_element<Field>(row[j]));
        const auto [at_row, slope] = blended(line, other_weights, columns);
        values.push_back(at_row);
        slopes.push_back(slope);
      }
      std::tie(value[k], derivatives[0][k]) = blended(values, weights, rows);
      if (axes == 2)
        derivatives[1][k] = blended(slopes, weights, rows).first;
    }
  }

private:
  // Which control point of a single piece is a corner of it; derivatives by no parameter are asked for there.
  template <class NT>
  static std::optional<std::size_t> control_point_at(const Bspline_function<NT>& f, const std::array<Fraction, 2>& at)
  {
    std::size_t result = 0;
    for (int axis = 0; axis < f.dimension(); ++axis) {
      const std::vector<NT>& knots = f.knots(axis);
      const auto n = static_cast<std::size_t>(f.degree(axis));
      if ((at[axis].numerator != 0 && at[axis].numerator != at[axis].denominator) || f.size(axis) != n + 1 ||
          knots[0] != knots[n] || knots[n + 1] != knots[2 * n + 1])
        return std::nullopt;
      result = result * (n + 1) + (at[axis].numerator == 0 ? 0 : n);
    }
    return result;
  }

  // The weights of de Boor's algorithm in the order in which they are used.
  template <class NT>
  static Fields blend_weights(const std::vector<NT>& knots, int degree, std::size_t span, const Fraction& at)
  {
    const auto knot = [&](std::size_t k) { return field_element<Field>(knots[k]); };
    const Field x = knot(span) +
        field_element<Field>(at.numerator) / field_element<Field>(at.denominator) * (knot(span + 1) - knot(span));
    const auto n = static_cast<std::size_t>(degree);
    Fields result;
    for (std::size_t r = 1; r <= n; ++r)
      for (std::size_t j = n; j >= r; --j) {
        const std::size_t low = span - n + j, high = span + j + 1 - r;
        // Between the same knots as before, the weight is the same.
        const bool is_known = j < n && knots[low] == knots[low + 1] && knots[high] == knots[high + 1];
        result.push_back(is_known ? Field(result.back()) : Field((x - knot(low)) / (knot(high) - knot(low))));
      }
    return result;
  }

  // The value and the derivative by the place in the cell.
  static std::pair<Field, Field> blended(Fields& control, const Fields& weights, int degree)
  {
    Field slope(0.0);
    const auto n = static_cast<std::size_t>(degree);
    auto weight = weights.begin();
    for (std::size_t r = 1; r <= n; ++r)
      for (std::size_t j = n; j >= r; --j, ++weight) {
        const Field difference = control[j] - control[j - 1];
        if (r == n)
          slope = difference;
        control[j] = control[j - 1] + *weight * difference;
      }
    return {control[n], n == 0 ? slope : Field(field_element<Field>(static_cast<double>(n)) * slope)};
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_SPLINE_JET_H
