// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/function/rational_decomposition.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/proper_curves.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace proper_curves_test {

using namespace CGAL::Spline_constraints;

namespace {

using Exact = CGAL::Simple_cartesian<Exact_rational>;
using Curve = Bspline_curve<Exact, 2>;
using Range = Curve_stretch::Range;

const Power_polynomial t = Power_polynomial::variable(0);

// The curve with these numerators and this weight, from one parameter to another.
template <int d = 2>
Bspline_curve<Exact, d> curve_of(const std::array<Power_polynomial, d>& numerators, const Power_polynomial& weight,
                                 const Exact_rational& begin, const Exact_rational& end)
{
  int degree = weight.degree(0);
  for (const Power_polynomial& f : numerators)
    degree = std::max(degree, f.degree(0));
  const auto function = [&](const Power_polynomial& f) {
    std::vector<Exact_rational> powers(static_cast<std::size_t>(degree) + 1, Exact_rational(0));
    for (const auto& [monomial, coefficient] : f.terms())
      powers[static_cast<std::size_t>(monomial.exponent(0))] = coefficient;
    const std::array<Range, 1> box{Range(begin, end)};
    std::vector<Exact_rational> knots(static_cast<std::size_t>(degree) + 1, begin);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, end);
    return Bspline_function<Exact_rational>(
        {degree}, {knots}, Bernstein_tensor<Exact_rational>::from_power_on_box({degree}, powers, box).coefficients());
  };
  std::array<Bspline_function<Exact_rational>, d> functions;
  std::transform(numerators.begin(), numerators.end(), functions.begin(), function);
  return Bspline_curve<Exact, d>::from_homogeneous_coordinates(functions, function(weight));
}

Curve circle_after(const Polynomial_quotient& h, const Exact_rational& begin, const Exact_rational& end)
{
  const Power_polynomial p = h.numerator(), q = h.denominator();
  return curve_of({q * q - p * p, 2 * p * q}, p * p + q * q, begin, end);
}

Range at(const Exact_rational& x) { return {x, x}; }

// Where a component is at a parameter of the curve.
template <int d>
Exact_rational parameter_of(const Proper_reparametrization<d>& proper, const Curve_stretch& stretch,
                            const Exact_rational& parameter)
{
  const std::optional<Exact_rational> u = stretch.h(parameter);
  if (!proper.components[stretch.component].is_closed)
    return u.value();
  return !u ? Exact_rational(2) : *u >= -1 && *u <= 1 ? *u : Exact_rational(2 - 1 / *u);
}

// All that holds for every curve.
template <int d>
Proper_reparametrization<d> checked(const Bspline_curve<Exact, d>& curve)
{
  const Proper_reparametrization<d> result = proper_reparametrization(curve);
  EXPECT_TRUE(result.is_complete());
  EXPECT_TRUE(result.undecided().empty());
  EXPECT_EQ(result.tracing_index(), tracing_index(curve));
  EXPECT_EQ(result.stretches.front().begin, at(curve.domain().first));
  EXPECT_EQ(result.stretches.back().end, at(curve.domain().second));
  for (const auto& component : result.components) {
    EXPECT_EQ(tracing_index(component.curve), 1);
    EXPECT_EQ(component.curve.degree(), component.degree);
    EXPECT_EQ(component.coverage.front().begin.first, component.curve.domain().first);
    EXPECT_EQ(component.coverage.back().end.second, component.curve.domain().second);
  }
  for (std::size_t i = 0; i < result.stretches.size(); ++i) {
    const Curve_stretch& stretch = result.stretches[i];
    EXPECT_TRUE(i == 0 || stretch.begin == result.stretches[i - 1].end);
    EXPECT_EQ(stretch.h.degree() % stretch.index, 0);
    // the same points, in order
    std::optional<Exact_rational> previous;
    for (int k = 1; k < 6; ++k) {
      const Exact_rational parameter = stretch.begin.second + (stretch.end.first - stretch.begin.second) * k / 6,
                           u = parameter_of(result, stretch, parameter);
      const auto& component = result.components[stretch.component];
      EXPECT_EQ(component.curve(u), curve(parameter));
      EXPECT_TRUE(!previous || (u < *previous) == stretch.is_reversed);
      previous = u;
      const Range &lower = stretch.is_reversed ? stretch.image_end : stretch.image_begin,
                  &upper = stretch.is_reversed ? stretch.image_begin : stretch.image_end;
      EXPECT_TRUE(lower.first <= u && u <= upper.second);
      // as often covered as there are stretches there
      const auto range = std::find_if(component.coverage.begin(), component.coverage.end(),
                                      [&](const auto& part) { return part.begin.second < u && u < part.end.first; });
      const auto stretches = std::count_if(result.stretches.begin(), result.stretches.end(), [&](const auto& other) {
        const auto [least, greatest] = std::minmax(other.image_begin, other.image_end);
        return other.component == stretch.component && least.first <= u && u <= greatest.second;
      });
      EXPECT_TRUE(range == component.coverage.end() || range->times == stretches);
    }
  }
  return result;
}

Power_polynomial chebyshev(int n)
{
  Power_polynomial previous(1), own = t;
  for (int k = 1; k < n; ++k)
    previous = std::exchange(own, 2 * t * own - previous);
  return own;
}

TEST(Proper_curves, a_parabola_forth_and_back)
{
  const auto proper = checked(curve_of({pow(t, 2), pow(t, 4)}, 1, -1, 1));
  EXPECT_EQ(proper.tracing_index(), 2);
  ASSERT_EQ(proper.components.size(), 1u);
  EXPECT_EQ(proper.components[0].curve, curve_of({t, t * t}, 1, 0, 1));
  EXPECT_EQ(proper.components[0].degree, 2);
  EXPECT_FALSE(proper.components[0].is_closed);
  ASSERT_EQ(proper.stretches.size(), 2u);
  EXPECT_EQ(proper.stretches[0].h, Polynomial_quotient(t * t));
  EXPECT_EQ(proper.stretches[0].image_begin, at(1));
  EXPECT_EQ(proper.stretches[0].image_end, at(0));
  EXPECT_EQ(proper.folds(), std::vector<Range>{at(0)});
  EXPECT_EQ(proper.times(), 2);
  // a part of it that does not turn back
  const auto half = checked(curve_of({pow(t, 2), pow(t, 4)}, 1, 1, 2));
  EXPECT_EQ(half.tracing_index(), 2);
  EXPECT_TRUE(half.folds().empty());
  EXPECT_EQ(half.times(), 1);
}

TEST(Proper_curves, a_segment_as_a_quadratic_curve)
{
  const auto proper = checked(curve_of({t * t, 2 * t * t}, 1, -1, 1));
  EXPECT_EQ(proper.tracing_index(), 2);
  EXPECT_EQ(proper.components[0].curve, curve_of({t, 2 * t}, 1, 0, 1));
  EXPECT_EQ(proper.folds(), std::vector<Range>{at(0)});
}

TEST(Proper_curves, circles)
{
  const Curve circle = circle_after(Polynomial_quotient(t), -1, 1);
  EXPECT_EQ(tracing_index(circle), 1);
  EXPECT_TRUE(is_proper(circle));
  EXPECT_TRUE(is_proper(circle.elevated(5)));
  const auto three_times = checked(circle_after(Polynomial_quotient(t * t * t), -1, 1));
  EXPECT_EQ(three_times.tracing_index(), 3);
  EXPECT_EQ(three_times.components[0].degree, 2);
  EXPECT_EQ(three_times.components[0].curve, circle);
  EXPECT_TRUE(three_times.folds().empty()); // the slope of t^3 is zero at 0, and does not change its sign
  EXPECT_EQ(three_times.stretches.size(), 1u);
}

TEST(Proper_curves, corners_of_a_square_that_two_fingers_hold)
{
  const Power_polynomial c = 1 - t * t, s = 2 * t, w = 1 + t * t; // cosine and sine of an angle, by its half
  const auto corner = checked(curve_of({c * c, c * s}, w * w, -2, 2));
  EXPECT_EQ(corner.tracing_index(), 2);
  EXPECT_EQ(corner.components[0].degree, 2);
  EXPECT_TRUE(left_component(corner.stretches[0].h, Polynomial_quotient(2 * t, 1 - t * t))); // the tangent
  EXPECT_TRUE(corner.components[0].is_closed);
  EXPECT_EQ(corner.times(), 2);
  EXPECT_TRUE(corner.folds().empty());
  for (const int a : {1, 2}) // a cardioid, a limacon
    EXPECT_EQ(tracing_index(curve_of({(a * w + c) * c, (a * w + c) * s}, w * w, -2, 2)), 1);
}

TEST(Proper_curves, chebyshev_curves)
{
  const auto proper = checked(curve_of({chebyshev(6), chebyshev(4)}, 1, -1, 1));
  EXPECT_EQ(proper.tracing_index(), 2);
  EXPECT_EQ(proper.components[0].degree, 3);
  EXPECT_EQ(proper.folds(), std::vector<Range>{at(0)});
  EXPECT_TRUE(is_proper(curve_of({chebyshev(3), chebyshev(2)}, 1, -1, 1)));
  EXPECT_EQ(tracing_index(curve_of<3>({chebyshev(12), chebyshev(8), chebyshev(20)}, 1, -1, 1)), 4);
}

// The function takes rational values at irrational folds, and irrational ones.
TEST(Proper_curves, irrational_folds)
{
  const Power_polynomial h = pow(t, 4) - 4 * t * t + t / 5;
  for (const Power_polynomial& inner : {pow(t, 4) - 4 * t * t, h}) {
    const auto proper = checked(curve_of({inner, inner * inner + inner}, 1, -2, 2));
    EXPECT_EQ(proper.tracing_index(), 4);
    ASSERT_EQ(proper.folds().size(), 3u);
    EXPECT_LT(proper.folds()[0].first, proper.folds()[0].second);
    EXPECT_EQ(proper.components[0].curve.domain().first == -4, inner != h);
  }
}

TEST(Proper_curves, functions_with_poles)
{
  // from -5/2 over -2 and infinity to 2 and 5/2: there is a gap around 0
  const auto gap = checked(circle_after(Polynomial_quotient(t * t + 1, t), -2, 2));
  EXPECT_EQ(gap.tracing_index(), 2);
  EXPECT_EQ(gap.folds(), (std::vector<Range>{at(-1), at(1)}));
  EXPECT_FALSE(gap.components[0].is_closed);
  EXPECT_EQ(gap.times(), 2);
  // all of the line, from -8/3 to 8/3 twice
  const auto all = checked(circle_after(Polynomial_quotient(t * t - 1, t), -3, 3));
  EXPECT_EQ(all.tracing_index(), 2);
  EXPECT_TRUE(all.folds().empty());
  EXPECT_TRUE(all.components[0].is_closed);
  EXPECT_TRUE(all.components[0].curve.is_closed());
  EXPECT_EQ(all.times(), 2);
}

TEST(Proper_curves, pieces_of_one_curve_are_taken_together)
{
  const Curve circle(circle_curve<Exact>(CGAL::Point_2<Exact>(1, 2), Exact_rational(3)));
  ASSERT_GT(circle.breaks().size(), 3u);
  const auto once = checked(circle);
  EXPECT_EQ(once.tracing_index(), 1);
  ASSERT_EQ(once.components.size(), 1u);
  EXPECT_TRUE(once.components[0].is_closed);
  EXPECT_EQ(once.components[0].degree, 2);
  EXPECT_EQ(once.times(), 1);
  EXPECT_TRUE(once.folds().empty());
  // half of it does not need a closed component
  EXPECT_FALSE(checked(circle.restricted(circle.breaks()[0], circle.breaks()[2])).components[0].is_closed);
  EXPECT_TRUE(have_same_support(circle.restricted(circle.breaks()[0], circle.breaks()[1]), circle));
}

TEST(Proper_curves, polygons_that_run_over_themselves)
{
  using Point = CGAL::Point_2<Exact>;
  const auto proper =
      checked(polyline_curve<Exact>({Point(0, 0), Point(2, 0), Point(1, 0), Point(3, 1), Point(3, 0), Point(4, 0)}));
  EXPECT_EQ(proper.tracing_index(), 1);
  // the line y = 0 is covered in two ranges that are apart
  ASSERT_EQ(proper.components.size(), 4u);
  EXPECT_EQ(proper.folds(), std::vector<Range>{at(1)});
  EXPECT_EQ(proper.times(), 2);
  EXPECT_EQ(proper.stretches[0].component, proper.stretches[1].component);
  EXPECT_NE(proper.stretches[0].component, proper.stretches[4].component);
  EXPECT_TRUE(have_same_support(proper.components[proper.stretches[0].component].curve,
                                proper.components[proper.stretches[4].component].curve));
}

TEST(Proper_curves, supports)
{
  const Curve parabola = curve_of({t, t * t}, 1, 0, 1);
  EXPECT_TRUE(have_same_support(parabola, curve_of({2 * t * t - 1, pow(2 * t * t - 1, 2)}, 1, 3, 4)));
  EXPECT_TRUE(have_same_support(parabola, curve_of({(t - 1) * (t + 5), (t - 1) * (t - 1)}, (t + 5) * (t + 5), 2, 4)));
  EXPECT_FALSE(have_same_support(parabola, curve_of({t, t * t + 1}, 1, 0, 1)));
  EXPECT_FALSE(have_same_support(parabola, curve_of({t, t}, 1, 0, 1)));
  EXPECT_FALSE(have_same_support(parabola, curve_of({t, t * t * t}, 1, 0, 1)));
}

TEST(Proper_curves, knots_and_degrees_do_not_matter)
{
  const Curve curve = curve_of({pow(t, 2) - t, pow(t * t - t, 2)}, 1 + t * t - t, 0, 2);
  const auto proper = checked(curve);
  EXPECT_EQ(proper.folds(), std::vector<Range>{at(Exact_rational(1) / 2)});
  const auto finer = checked(curve.elevated(6).with_knot(Exact_rational(1) / 3).with_knot(1));
  EXPECT_EQ(finer.stretches.size(), proper.stretches.size());
  EXPECT_EQ(finer.components[0].curve, proper.components[0].curve);
  // common zeros, outside of the domain and complex ones
  const Power_polynomial common = (t + 3) * (1 + t * t);
  const auto reducible =
      checked(curve_of({(pow(t, 2) - t) * common, pow(t * t - t, 2) * common}, (1 + t * t - t) * common, 0, 2));
  EXPECT_EQ(reducible.components[0].curve, proper.components[0].curve);
  // doubles, as the numbers they are: to be rounded makes a curve proper
  using Doubles = CGAL::Simple_cartesian<double>;
  EXPECT_EQ(tracing_index(Bspline_curve<Doubles, 2>(curve_of({t * t, 2 * t * t}, 1, -1, 1))), 2);
  EXPECT_EQ(tracing_index(Bspline_curve<Doubles, 2>(curve)), 1);
}

TEST(Proper_curves, random_compositions)
{
  std::mt19937 random(17);
  const auto number = [&](int least, int greatest) {
    return std::uniform_int_distribution<int>(least, greatest)(random);
  };
  const auto polynomial = [&](int degree) {
    Power_polynomial result = Power_polynomial(number(1, 3)) * pow(t, degree);
    for (int k = 0; k < degree; ++k)
      result += Power_polynomial(number(-4, 4)) * pow(t, k);
    return result;
  };
  int folds = 0, curves = 0;
  for (int i = 0; i < 150; ++i) {
    const int degree = number(1, 3);
    const std::array<Power_polynomial, 3> outer{polynomial(degree), polynomial(number(0, degree)),
                                                polynomial(number(1, degree))};
    const Power_polynomial weight = i % 2 == 0 ? Power_polynomial(1) : 1 + pow(polynomial(1), 2);
    const Polynomial_quotient h = i % 3 == 0 ? Polynomial_quotient(polynomial(number(2, 4)))
                                             : Polynomial_quotient(polynomial(number(2, 3)), polynomial(2));
    if (h.degree() < 2)
      continue;
    const int order = std::max(degree, weight.degree(0));
    const auto after = [&](const Power_polynomial& f) {
      Power_polynomial result;
      for (const auto& [monomial, coefficient] : f.terms())
        result += Power_polynomial(coefficient) * pow(h.numerator(), monomial.exponent(0)) *
            pow(h.denominator(), order - monomial.exponent(0));
      return result;
    };
    try {
      const auto curve = curve_of<3>({after(outer[0]), after(outer[1]), after(outer[2])}, after(weight), -1, 1);
      const auto proper = checked(curve);
      const int index = tracing_index(curve_of<3>(outer, weight, 0, 1));
      EXPECT_EQ(proper.tracing_index(), index * h.degree());
      EXPECT_TRUE(left_component(proper.stretches[0].h, h));
      folds += static_cast<int>(proper.folds().size());
      ++curves;
    } catch (const Invalid_input&) { // the weight has a zero
    }
  }
  EXPECT_GT(curves, 80);
  EXPECT_GT(folds, 60);
}

TEST(Proper_curves, bad_input_and_limits)
{
  const Curve point = curve_of({2 * (1 + t * t), 3 * (1 + t * t)}, 1 + t * t, 0, 1);
  EXPECT_THROW(tracing_index(point), Invalid_input);
  EXPECT_THROW(is_proper(point), Invalid_input);
  EXPECT_THROW(proper_reparametrization(point), Invalid_input);
  EXPECT_THROW(have_same_support(point, point), Invalid_input);
  const Curve curve = curve_of({pow(t, 2), pow(t, 4)}, 1, -1, 1);
  EXPECT_THROW(proper_reparametrization(curve, {.time_limit = -1}), Invalid_input);
  const auto stopped = proper_reparametrization(curve, {.time_limit = 1e-9});
  EXPECT_FALSE(stopped.is_complete());
  ASSERT_EQ(stopped.undecided().size(), 1u);
  EXPECT_EQ(stopped.undecided()[0].parameters[0].ranges[0], (std::pair<double, double>(-1, 1)));
  EXPECT_EQ(stopped.tracing_index(), 0);
}

} // namespace

} // namespace proper_curves_test
