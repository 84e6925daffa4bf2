// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Oscillators in the first terms of their Fourier series: what is exact are the polynomial systems that averaging and
// harmonic balance give, of which all solutions are found, by proof; how near they are to the oscillators is not.
//
//   limit_cycles
//
// All limit cycles of an oscillator of Liénard with small damping, and which of them attract; the limit cycle of van der
// Pol's oscillator with strong damping, in three harmonics; and the amplitudes of Duffing's oscillator, with the folds
// between which there are three. Writes limit_cycles.svg. Exit status: 0 when all counts are as they are known to be, 1
// when not.
//
// Source: R. Zippel, Symbolic/numeric techniques in modeling and simulation, 1991, for averaging.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/solver.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;

namespace {

// The sum of cosine[k] cos(k t) + sine[k] sin(k t).
struct Fourier_sum
{
  std::vector<SC::Expression> cosine, sine;

  explicit Fourier_sum(std::size_t highest) : cosine(highest + 1, 0), sine(highest + 1, 0) {}

  static Fourier_sum constant(const SC::Expression& value)
  {
    Fourier_sum result(0);
    result.cosine[0] = value;
    return result;
  }

  std::size_t highest() const { return cosine.size() - 1; }

  Fourier_sum derivative() const
  {
    Fourier_sum result(highest());
    for (std::size_t k = 0; k <= highest(); ++k) {
      result.cosine[k] = sine[k] * static_cast<int>(k);
      result.sine[k] = cosine[k] * -static_cast<int>(k);
    }
    return result;
  }

  friend Fourier_sum operator+(const Fourier_sum& a, const Fourier_sum& b)
  {
    Fourier_sum result(std::max(a.highest(), b.highest()));
    for (const Fourier_sum* sum : {&a, &b})
      for (std::size_t k = 0; k <= sum->highest(); ++k) {
        result.cosine[k] = result.cosine[k] + sum->cosine[k];
        result.sine[k] = result.sine[k] + sum->sine[k];
      }
    return result;
  }

  friend Fourier_sum operator*(const Fourier_sum& a, const Fourier_sum& b)
  {
    Fourier_sum result(a.highest() + b.highest());
    for (std::size_t i = 0; i <= a.highest(); ++i)
      for (std::size_t j = 0; j <= b.highest(); ++j) {
        const SC::Expression half_of_cosines = a.cosine[i] * b.cosine[j] / 2, half_of_sines = a.sine[i] * b.sine[j] / 2,
                             first = a.sine[i] * b.cosine[j] / 2, second = a.cosine[i] * b.sine[j] / 2;
        const std::size_t difference = i > j ? i - j : j - i;
        result.cosine[i + j] = result.cosine[i + j] + half_of_cosines - half_of_sines;
        result.cosine[difference] = result.cosine[difference] + half_of_cosines + half_of_sines;
        result.sine[i + j] = result.sine[i + j] + first + second;
        result.sine[difference] = result.sine[difference] + (i > j ? first - second : second - first);
      }
    return result;
  }
};

Fourier_sum operator*(const SC::Expression& factor, const Fourier_sum& sum)
{
  return Fourier_sum::constant(factor) * sum;
}

// x'' + e f(x) x' + x = 0 with a polynomial f in x^2, and x = r cos(t + phase): the mean of r', divided by e.
SC::Expression averaged_rate(const std::vector<Number>& f, const SC::Expression& r)
{
  Fourier_sum x(1), power = Fourier_sum::constant(1), damping(0);
  x.cosine[1] = r;
  for (const Number& coefficient : f) {
    damping = damping + coefficient * power;
    power = power * x * x;
  }
  return (damping * x.derivative()).sine[1] / 2;
}

std::vector<Point> spiral(const SC::Expression& rate, double r, double turns)
{
  std::vector<Point> result;
  constexpr int steps_of_turn = 60;
  for (int k = 0; k <= turns * steps_of_turn; ++k) {
    const double angle = 2 * std::acos(-1.) * k / steps_of_turn;
    result.emplace_back(r * std::cos(angle), -r * std::sin(angle));
    r += 0.3 / steps_of_turn * CGAL::to_double(rate(std::vector<Number>{Number(r)}));
  }
  return result;
}

// Averaged, limit cycles are zeros of the rate, and attract where it decreases.
bool show_averaged(std::ostream& svg)
{
  const auto [r] = SC::unknowns({Number(1) / 100, 5});
  const SC::Expression pol = averaged_rate({-1, 1}, r),
                       rate = averaged_rate({-2, Number(98) / 9, Number(-56) / 9, Number(32) / 45}, r);
  const auto pol_cycles = SC::solve(pol == 0), cycles = SC::solve(rate == 0),
             attracting = SC::solve(rate == 0, derivative(rate, r) < 0);

  SC::SVG_writer picture(svg, CGAL::Bbox_2(-4, -4.6, 4, 4), 320);
  picture.polyline(spiral(rate, 0.15, 8), "#8a94a0", 1);
  picture.polyline(spiral(rate, 1.97, 6), "#8a94a0", 1);
  picture.polyline(spiral(rate, 2.03, 6), "#8a94a0", 1);
  picture.polyline(spiral(rate, 3.5, 4), "#8a94a0", 1);
  for (const auto& cycle : cycles) {
    const double radius = cycle.point()[0];
    const bool is_attracting = std::any_of(attracting.begin(), attracting.end(),
                                           [&](const auto& other) { return other.box() == cycle.box(); });
    picture.circle(Point(0, 0), radius, is_attracting ? "#2ca02c" : "#d62728", 3);
    std::cout << "cycle of radius " << radius << (is_attracting ? ", attracts\n" : ", repels\n");
  }
  picture.label(Point(-3.8, -4.4), "Liénard: attracts (green), repels (red)");
  std::cout << "van der Pol, averaged: " << pol_cycles.size() << " cycle, of radius " << pol_cycles[0].point()[0]
            << '\n';
  return pol_cycles.is_complete() && pol_cycles.size() == 1 && cycles.is_complete() && cycles.size() == 3 &&
      attracting.is_complete() && attracting.size() == 2;
}

// x'' + e (x^2 - 1) x' + x = 0 for e = 1 in the harmonics 1, 3 and 5 of a frequency w; time begins so that x has no
// sin(w t).
bool show_balanced(std::ostream& svg)
{
  const auto [a1, a3, b3, a5, b5, w] = SC::unknowns({1, 3}, {-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}, {0.5, 1.5});
  Fourier_sum x(5);
  x.cosine = {0, a1, 0, a3, 0, a5};
  x.sine = {0, 0, 0, b3, 0, b5};
  const Fourier_sum speed = w * x.derivative(),
                    rest = w * speed.derivative() + (x * x + Fourier_sum::constant(-1)) * speed + x;
  const auto cycles = SC::solve(rest.cosine[1] == 0, rest.sine[1] == 0, rest.cosine[3] == 0, rest.sine[3] == 0,
                                rest.cosine[5] == 0, rest.sine[5] == 0);

  SC::SVG_writer picture(svg, CGAL::Bbox_2(-3.2, -3.68, 3.2, 3.2), 320);
  picture.circle(Point(0, 0), 2, "#8a94a0", 1);
  const double pi = std::acos(-1.);
  for (const auto& cycle : cycles) {
    const std::vector<double> middle = cycle.point();
    const std::vector<Number> values(middle.begin(), middle.end());
    const auto at = [&](const Fourier_sum& sum, double t) {
      double result = 0;
      for (std::size_t k = 0; k <= sum.highest(); ++k)
        result += CGAL::to_double(sum.cosine[k](values)) * std::cos(k * t) +
            CGAL::to_double(sum.sine[k](values)) * std::sin(k * t);
      return result;
    };
    std::vector<Point> points;
    for (int k = 0; k <= 120; ++k)
      points.emplace_back(at(x, k * pi / 60), at(speed, k * pi / 60));
    picture.polyline(points, "#2ca02c", 3);
    std::cout << "van der Pol, e = 1, three harmonics: " << cycle.kind() << ", period " << 2 * pi / middle[5] << '\n';
  }
  picture.label(Point(-3, -3.5), "van der Pol: e = 1 (green), small e (gray)");
  return cycles.is_complete() && cycles.size() == 1;
}

// x'' + g x' + x + x^3 = F cos(w t + phase) with x = A cos(w t).
bool show_resonance(std::ostream& svg)
{
  const auto [w, A] = SC::unknowns({0, 3}, {0.01, 3});
  const Number damping = Number(1) / 5;
  Fourier_sum x(1);
  x.cosine[1] = A;
  const Fourier_sum force = w * w * x.derivative().derivative() + damping * w * x.derivative() + x + x * x * x;
  const SC::Expression squared_force = square(force.cosine[1]) + square(force.sine[1]);

  SC::SVG_writer picture(svg, CGAL::Bbox_2(-0.15, -0.27, 3, 3.1), 320);
  picture.polyline(std::vector<Point>{{0, 3}, {0, 0}, {3, 0}}, "#8a94a0", 1);
  bool is_right = true;
  const std::vector<std::pair<Number, std::size_t>> forces{{Number(1) / 10, 0}, {Number(1) / 2, 2}, {1, 2}};
  for (const auto& [F, expected] : forces) {
    const SC::Constraint on_curve = squared_force == F * F;
    const SC::Expression slope = derivative(squared_force, A);
    const auto whole = SC::solve_curves(on_curve);
    const auto folds = SC::solve(on_curve, slope == 0);
    const auto draw = [&](const SC::Constraint& side, const std::string& color) {
      const std::vector<SC::Constraint> constraints{on_curve, side};
      const SC::Constraint_system_d system = make_system(constraints);
      const SC::Curve_solution_set_d set = SC::solve_curves(system);
      for (const SC::Solution_curve& curve : set.curves())
        picture.polyline(SC::to_polyline(system, set, curve, 1e-3), color, 2.5);
      return set.is_complete() ? set.curves().size() : 0;
    };
    const std::size_t stable = draw(slope >= 0, "#2ca02c"), unstable = draw(slope <= 0, "#d62728");
    for (const auto& fold : folds)
      picture.point(Point(fold.point()[0], fold.point()[1]), "black", 8);
    std::cout << "Duffing, F = " << F << ": " << whole.curves().size() << " curve, " << folds.size() << " folds, "
              << stable << " stable parts, " << unstable << " unstable parts\n";
    is_right = is_right && whole.is_complete() && whole.curves().size() == 1 && folds.is_complete() &&
        folds.size() == expected && stable == 1 + expected / 2 && unstable == expected / 2;
  }
  picture.label(Point(0.05, -0.2), "Duffing: amplitude over frequency");
  return is_right;
}

} // namespace

int main()
{
  std::ofstream file("limit_cycles.svg");
  file << "<svg xmlns='http://www.w3.org/2000/svg' width='1000' height='350'>\n<rect width='1000' height='350' "
          "fill='white'/>\n";
  const bool is_averaged = show_averaged(file);
  file << "<g transform='translate(335 0)'>\n";
  const bool is_balanced = show_balanced(file);
  file << "</g>\n<g transform='translate(670 0)'>\n";
  const bool is_resonance = show_resonance(file);
  file << "</g>\n</svg>\n";
  return is_averaged && is_balanced && is_resonance ? 0 : 1;
}
