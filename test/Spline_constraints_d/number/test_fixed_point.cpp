// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fixed-point numbers against exact ones: errors stay within their bounds.

#include <CGAL/Spline_constraints_d/number/fixed_point.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

namespace fixed_point_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::internal::Big_integer;
using SC::internal::Fixed_point;
using SC::internal::Unsigned_fixed_point;
using Engine = std::mt19937_64;

Exact_rational exact(Unsigned_fixed_point x)
{
  Exact_rational result(0);
  for (int shift = 96; shift >= 0; shift -= 32)
    result = result * Exact_rational(4294967296.0) +
        Exact_rational(static_cast<double>(static_cast<std::uint32_t>(x >> shift)));
  return result;
}

Exact_rational exact(Fixed_point x)
{
  return x < 0 ? Exact_rational(-exact(SC::internal::magnitude(x))) : exact(static_cast<Unsigned_fixed_point>(x));
}

Exact_rational power_of_two(long exponent) { return SC::internal::power_of_two(exponent); }

// In [0,1], with all kinds of lengths.
double random_factor(Engine& engine)
{
  const double x = static_cast<double>(engine() >> 11) * 0x1p-53;
  return engine() % 3 == 0 ? std::ldexp(std::nearbyint(std::ldexp(x, 5)), -5)
                           : std::ldexp(x, -static_cast<int>(engine() % 20));
}

TEST(Fixed_point, ProductsAreOffBySixUnits)
{
  Engine engine(1);
  for (int i = 0; i < 20000; ++i) {
    const Unsigned_fixed_point bits = Unsigned_fixed_point(engine()) << 64 | engine();
    const Fixed_point value = static_cast<Fixed_point>(bits) >> (2 + engine() % 80);
    const Unsigned_fixed_point factor = i % 5 == 0
        ? SC::internal::fixed_point_one
        : (Unsigned_fixed_point(engine()) << 64 | engine()) >> (1 + engine() % 70);
    const Exact_rational difference =
        exact(value) * exact(factor) * power_of_two(-127) - exact(SC::internal::multiplied(value, factor));
    ASSERT_TRUE(0 <= difference && difference < 6) << difference;
    const double rounded = SC::internal::approximate(value);
    const Exact_rational error = Exact_rational(rounded) - exact(value);
    ASSERT_TRUE(abs(error) <= abs(exact(value)) * power_of_two(-52)) << rounded;
  }
}

TEST(Fixed_point, ParametersAreOffByLessThanAUnit)
{
  Engine engine(2);
  for (const auto& [lower, upper] :
       {std::pair(0.0, 1.0), std::pair(-1.0, 1.0), std::pair(-2.0, 2.0), std::pair(0.1, 0.7), std::pair(3.0, 3.5),
        std::pair(-1e-30, 1.0), std::pair(-1e8, 1e8), std::pair(1e-20, 3e-20), std::pair(5.0, 5.0 + 0x1p-40)}) {
    const SC::internal::Fixed_point_range range(lower, upper);
    EXPECT_TRUE(range(lower) == 0 && range(upper) == SC::internal::fixed_point_one);
    for (int i = 0; i < 500; ++i) {
      const double x = (std::min)((std::max)(lower + random_factor(engine) * (upper - lower), lower), upper);
      const Exact_rational t =
          (Exact_rational(x) - Exact_rational(lower)) / (Exact_rational(upper) - Exact_rational(lower));
      ASSERT_TRUE(abs(t * power_of_two(127) - exact(range(x))) < 1) << lower << ' ' << upper << ' ' << x;
    }
  }
}

// A function with one term per set of unknowns.
SC::Spline_function random_function(Engine& engine, const std::vector<std::vector<int>>& variables, int degree,
                                    bool has_breaks)
{
  SC::Spline_function result;
  for (const std::vector<int>& own : variables) {
    SC::Spline_term term;
    term.variables = own;
    std::size_t cells = 1;
    for (int v : own) {
      term.degrees.push_back(1 + static_cast<int>(engine() % degree));
      term.breaks.emplace_back();
      if (has_breaks && v == 0) {
        term.breaks.back() = {Exact_rational(-2), Exact_rational(1) / Exact_rational(3), Exact_rational(2)};
        cells *= 2;
      }
    }
    for (std::size_t c = 0; c < cells; ++c) {
      auto& piece = term.pieces.emplace_back();
      for (std::size_t i = 0; i < term.piece_size(); ++i)
        piece.push_back(Exact_rational(static_cast<double>(engine() % 2001) - 1000) /
                        Exact_rational(static_cast<double>(1 + engine() % 7)));
    }
    result += SC::Spline_function(std::move(term));
  }
  return result;
}

struct Coefficients
{
  std::vector<double> values, errors;
  std::vector<long> scale;
};

Coefficients coefficients(SC::internal::Exact_source& source, const SC::internal::Cell& cell,
                          const std::vector<double>& lower, const std::vector<double>& upper)
{
  Coefficients result{std::vector<double>(source.layout().size), std::vector<double>(source.layout().errors), {}};
  source.bernstein_coefficients(cell, std::span<const double>(lower), std::span<const double>(upper),
                                result.values.data(), result.errors.data(), result.scale);
  return result;
}

// The sum over the blocks of a function is what counts: constants move between them.
Exact_rational value_at_first_corner(const SC::internal::System_layout& layout, const Coefficients& c, int f,
                                     bool is_error)
{
  Exact_rational sum(0);
  for (const SC::internal::Block& block : layout.blocks)
    for (std::size_t m = 0; m < block.functions.size(); ++m)
      if (block.functions[m] == f)
        sum += Exact_rational(is_error ? c.errors[block.first_error + m] : c.values[block.offset + m]);
  return sum * power_of_two(c.scale[f]);
}

TEST(Fixed_point, CoefficientsAndValuesKeepTheirBounds)
{
  Engine engine(3);
  int compared = 0, rebuilt = 0, evaluated = 0;
  for (int round = 0; round < 60; ++round) {
    const bool has_breaks = round % 3 == 2;
    SC::Constraint_system_d system({{Exact_rational(-2), Exact_rational(2)},
                                    {Exact_rational(0), Exact_rational(1)},
                                    {Exact_rational(1), Exact_rational(4)}});
    const std::vector<std::vector<std::vector<int>>> shapes = {{{0, 1, 2}}, {{0, 1}, {2}}, {{0}, {1}, {2}}};
    for (int f = 0; f < 3; ++f)
      system.add(random_function(engine, shapes[(round + f) % 3], 4, has_breaks), SC::Relation::EQUAL);
    const SC::internal::System_layout layout(system);
    SC::internal::Exact_source source(system, layout), fixed(system, layout);   // the first one without a home
    const std::vector<double> home_lower{has_breaks ? 0.375 : -2.0, 0, 1}, home_upper{2, 1, 4};
    const SC::internal::Cell cell = source.cell_of(std::span<const double>(home_upper));
    fixed.set_home(cell, std::span<const double>(home_lower), std::span<const double>(home_upper));
    for (int i = 0; i < 4; ++i)
      coefficients(fixed, cell, home_lower, home_upper);   // makes it worth while
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<double> lower, upper, point;
      for (int j = 0; j < 3; ++j) {
        const double a = home_lower[j] + random_factor(engine) * (home_upper[j] - home_lower[j]);
        lower.push_back((std::min)(a, std::nextafter(home_upper[j], 0.0)));
        upper.push_back((std::min)(home_upper[j], lower[j] + (std::max)(0x1p-40, random_factor(engine))));
        point.push_back(lower[j]);
      }
      const Coefficients expected = coefficients(source, cell, lower, upper),
                         found = coefficients(fixed, cell, lower, upper);
      rebuilt += expected.values != found.values;
      std::vector<SC::internal::Exact_source::Value> exact_values, values;
      source.evaluate(cell, std::span<const double>(point), exact_values);
      fixed.evaluate_closely(cell, std::span<const double>(point), values);
      for (int f = 0; f < 3; ++f) {
        const Exact_rational difference =
            value_at_first_corner(layout, expected, f, false) - value_at_first_corner(layout, found, f, false);
        const Exact_rational bound =
            value_at_first_corner(layout, expected, f, true) + value_at_first_corner(layout, found, f, true);
        ASSERT_TRUE(abs(difference) <= bound) << round << ' ' << trial << ' ' << f;
        ASSERT_TRUE(bound <= power_of_two(found.scale[f] - 40));
        // Differences of neighbours within a block stay, whatever moves between blocks.
        for (const SC::internal::Block& block : layout.blocks)
          for (std::size_t m = 0; m < block.functions.size(); ++m)
            if (block.functions[m] == f)
              for (std::size_t k = 1; k < block.points; ++k) {
                const auto step = [&](const Coefficients& c) -> Exact_rational {
                  const double* values_of_block = c.values.data() + block.offset + m;
                  return (Exact_rational(values_of_block[k * block.functions.size()]) -
                          Exact_rational(values_of_block[0])) *
                      power_of_two(c.scale[f]);
                };
                const auto error = [&](const Coefficients& c) -> Exact_rational {
                  return 2 * Exact_rational(c.errors[block.first_error + m]) * power_of_two(c.scale[f]);
                };
                ASSERT_TRUE(abs(step(expected) - step(found)) <= error(expected) + error(found))
                    << round << ' ' << trial << ' ' << f << ' ' << k;
                ++compared;
              }
        const Exact_rational truth = Exact_rational(exact_values[f].mantissa) * power_of_two(exact_values[f].exponent);
        const Exact_rational close = Exact_rational(values[f].mantissa) * power_of_two(values[f].exponent);
        const Exact_rational error = Exact_rational(values[f].error) * power_of_two(values[f].exponent);
        ASSERT_TRUE(abs(truth - close) <= abs(truth) * power_of_two(-42) + error);
        ASSERT_TRUE(error <= power_of_two(expected.scale[f] - 40));
        evaluated += exact_values[f].mantissa != values[f].mantissa;
      }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(rebuilt, 100);   // by other arithmetic
  EXPECT_GT(evaluated, 100);
}

} // namespace

} // namespace fixed_point_test
