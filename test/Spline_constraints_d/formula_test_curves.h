// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_FORMULA_TEST_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_FORMULA_TEST_CURVES_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>

#include <array>
#include <random>
#include <span>
#include <utility>
#include <vector>

// Curves and surfaces for tests of formulas.
namespace formula_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using Spline = SC::Bspline_function<Rational>;

inline Rational ratio(int a, int b) { return Rational(a) / Rational(b); }

// A circle as four rational quadratic pieces, with the parameter in [0,4]: with continuous derivatives, though those of
// the homogeneous coordinates jump.
struct Circle
{
  static constexpr int number_of_parameters = 1;
  Rational x, y, radius;

  Spline spline(const std::array<int, 9>& base, const Rational& scale, const Rational& shift) const
  {
    static constexpr int weights[] = {1, 1, 2, 1, 1, 1, 2, 1, 1};
    std::vector<Rational> coefficients;
    for (int i = 0; i < 9; ++i)
      coefficients.push_back(scale * Rational(base[i]) + shift * Rational(weights[i]));
    std::vector<Rational> knots;
    for (int t : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4})
      knots.push_back(Rational(t));
    return Spline({2}, {knots}, coefficients);
  }

  bool is_rational() const { return true; }
  Spline weight() const { return spline({}, Rational(0), Rational(1)); }

  std::array<Spline, 2> homogeneous_coordinates() const
  {
    return {spline({1, 1, 0, -1, -1, -1, 0, 1, 1}, radius, x), spline({0, 1, 2, 1, 0, -1, -2, -1, 0}, radius, y)};
  }

  SC::Spline_map<1, 2> map() const { return SC::Spline_map(*this); }
};

// A spline with given knots and control points drawn from a few fractions.
inline Spline random_spline(std::mt19937& random, std::vector<int> degrees, std::vector<std::vector<Rational>> knots,
                            bool is_positive = false)
{
  std::size_t size = 1;
  for (std::size_t j = 0; j < degrees.size(); ++j)
    size *= knots[j].size() - degrees[j] - 1;
  std::vector<Rational> coefficients;
  for (std::size_t i = 0; i < size; ++i)
    coefficients.push_back(ratio(is_positive ? 1 + static_cast<int>(random() % 9) : static_cast<int>(random() % 19) - 9,
                                 1 + static_cast<int>(random() % 4)));
  return Spline(degrees, std::move(knots), std::move(coefficients));
}

// A Bézier curve with integer control points on [0,1].
inline SC::Spline_map<1, 2> bezier_curve(const std::vector<std::array<int, 2>>& points)
{
  const int degree = static_cast<int>(points.size()) - 1;
  std::vector<Rational> knots(degree + 1, Rational(0)), x, y;
  knots.insert(knots.end(), degree + 1, Rational(1));
  for (const auto& point : points) {
    x.push_back(Rational(point[0]));
    y.push_back(Rational(point[1]));
  }
  return SC::Spline_map<1, 2>({Spline({degree}, {knots}, x), Spline({degree}, {knots}, y)});
}

// The curve (x(t), y(t)) for power coefficients of x and y, on a range.
inline SC::Spline_map<1, 2> polynomial_curve(const std::vector<int>& x, const std::vector<int>& y, int begin, int end)
{
  const auto spline = [&](const std::vector<int>& powers) {
    const std::vector<std::pair<Rational, Rational>> range{{Rational(begin), Rational(end)}};
    return Spline::from_tensor(
        SC::Bernstein_tensor<Rational>::from_power_on_box({static_cast<int>(powers.size()) - 1},
                                                          std::vector<Rational>(powers.begin(), powers.end()), range),
        range);
  };
  return SC::Spline_map<1, 2>({spline(x), spline(y)});
}

// The value of an expanded constraint, term by term and power by power.
inline Rational value(const SC::Spline_function& function, std::span<const Rational> point)
{
  Rational sum(0);
  for (const SC::Spline_term& term : function.terms()) {
    std::size_t cell = 0;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      std::size_t k = 0;
      while (k + 1 < term.cells(j) && term.breaks[j][k + 1] <= point[term.variables[j]])
        ++k;
      cell = cell * term.cells(j) + k;
    }
    for (std::size_t i = 0; i < term.pieces[cell].size(); ++i) {
      Rational product = term.pieces[cell][i];
      std::size_t rest = i;
      for (std::size_t j = term.variables.size(); j-- > 0;) {
        for (std::size_t e = rest % (term.degrees[j] + 1); e > 0; --e)
          product *= point[term.variables[j]];
        rest /= term.degrees[j] + 1;
      }
      sum += product;
    }
  }
  return sum;
}

inline std::size_t number_of_coefficients(const SC::Spline_function& function)
{
  std::size_t result = 0;
  for (const SC::Spline_term& term : function.terms())
    result += term.pieces.size() * term.piece_size();
  return result;
}

inline std::vector<Rational> random_point(std::mt19937& random, const SC::Unknown_domains& domains)
{
  std::vector<Rational> result;
  for (const auto& [lower, upper] : domains)
    result.push_back(lower + (upper - lower) * ratio(static_cast<int>(random() % 101), 100));
  return result;
}

} // namespace formula_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_FORMULA_TEST_CURVES_H
