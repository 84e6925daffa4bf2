// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a node says of its functions, beside the same numbers in exact arithmetic: blocks of all shapes, since there are
// several ways to pass over them.

#include <CGAL/Spline_constraints_d/solver/Node_view.h>

#include <CGAL/Spline_constraints_d/number/Number_traits.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace Node_view_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using SC::internal::Block;
using SC::internal::System_layout;

System_layout block_layout(const std::vector<int>& degrees, int functions)
{
  System_layout layout;
  layout.dimension = (std::max)(1, static_cast<int>(degrees.size()));
  layout.equalities = layout.functions = functions;
  Block& block = layout.blocks.emplace_back();
  block.axes.resize(degrees.size());
  std::iota(block.axes.begin(), block.axes.end(), 0);
  block.degrees = degrees;
  block.functions.resize(functions);
  std::iota(block.functions.begin(), block.functions.end(), 0);
  for (int degree : degrees)
    block.points *= static_cast<std::size_t>(degree) + 1;
  layout.place_blocks();
  return layout;
}

// The least and the largest of some numbers.
struct Range
{
  Rational least, most;
  bool is_empty = true;

  void add(const Rational& x)
  {
    least = is_empty || x < least ? x : least;
    most = is_empty || x > most ? x : most;
    is_empty = false;
  }
};

// The range lies between the bounds, and they are hardly wider.
void expect_bounds(const Range& exact, double lower, double upper)
{
  ASSERT_FALSE(exact.is_empty);
  EXPECT_LE(Rational(lower), exact.least);
  EXPECT_GE(Rational(upper), exact.most);
  EXPECT_LE(exact.least - Rational(lower), Rational(0x1p-36));
  EXPECT_LE(Rational(upper) - exact.most, Rational(0x1p-36));
}

class Expected
{
  const Block& m_block;
  const std::vector<double>& m_coefficients;

public:
  Expected(const Block& block, const std::vector<double>& coefficients) : m_block(block), m_coefficients(coefficients)
  {}

  Rational value(std::size_t point, std::size_t f) const
  {
    return Rational(m_coefficients[point * m_block.functions.size() + f]);
  }
  std::size_t points_in_layer(std::size_t j) const { return m_block.lengths[j + 1] / m_block.functions.size(); }
  int index(std::size_t point, std::size_t j) const
  {
    return static_cast<int>(point / points_in_layer(j)) % (m_block.degrees[j] + 1);
  }

  Range values(std::size_t f) const
  {
    Range range;
    for (std::size_t p = 0; p < m_block.points; ++p)
      range.add(value(p, f));
    return range;
  }

  Range rest(std::size_t f, const double* slopes) const
  {
    Range range;
    for (std::size_t p = 0; p < m_block.points; ++p) {
      Rational x = value(p, f);
      for (std::size_t j = 0; j < m_block.axes.size(); ++j)
        if (m_block.degrees[j] > 0)
          x -= Rational(slopes[j]) * (Rational(index(p, j)) / m_block.degrees[j] - Rational(0.5));
      range.add(x);
    }
    return range;
  }

  // Mean of the last layer less that of the first.
  Rational slope(std::size_t f, std::size_t j) const
  {
    Rational sum = 0;
    for (std::size_t p = 0; p < m_block.points; ++p) {
      if (index(p, j) == m_block.degrees[j])
        sum += value(p, f);
      if (index(p, j) == 0)
        sum -= value(p, f);
    }
    return sum * (m_block.degrees[j] + 1) / static_cast<long>(m_block.points);
  }

  Range derivatives(std::size_t f, std::size_t j) const
  {
    Range range;
    for (std::size_t p = 0; p < m_block.points; ++p)
      if (index(p, j) < m_block.degrees[j])
        range.add(m_block.degrees[j] * (value(p + points_in_layer(j), f) - value(p, f)));
    return range;
  }
};

void check(const std::vector<int>& degrees, int functions, std::mt19937_64& engine)
{
  const System_layout layout = block_layout(degrees, functions);
  std::vector<double> coefficients(layout.size), errors(layout.errors, 0.0);
  std::uniform_real_distribution<double> number(-1, 1);
  for (double& x : coefficients)
    x = number(engine);
  SC::Node_view view(layout);
  view.reset(coefficients.data(), errors.data());
  const Expected expected(layout.blocks[0], coefficients);
  for (int f = 0; f < functions; ++f) {
    expect_bounds(expected.values(f), view.lower(f), view.upper(f));
    expect_bounds(expected.rest(f, view.slopes(f)), view.rest_lower(f), view.rest_upper(f));
    for (std::size_t j = 0; j < degrees.size(); ++j) {
      EXPECT_LE(CGAL::abs(expected.slope(f, j) - Rational(view.slopes(f)[j])), Rational(0x1p-40));
      if (degrees[j] > 0)
        expect_bounds(expected.derivatives(f, j), view.derivative_lower(f)[j], view.derivative_upper(f)[j]);
    }
  }
}

} // namespace

TEST(NodeView, BlocksOfAllShapes)
{
  std::mt19937_64 engine(1);
  for (int functions = 1; functions <= 7; ++functions)
    for (const std::vector<int>& degrees : {std::vector<int>{},
                                            {0},
                                            {1},
                                            {5},
                                            {2, 2},
                                            {3, 0},
                                            {1, 6},
                                            {4, 12},
                                            {2, 2, 2},
                                            {1, 3, 2},
                                            {2, 1, 1, 2},
                                            {1, 1, 1, 1, 1}}) {
      SCOPED_TRACE(testing::Message() << functions << " functions, " << degrees.size() << " axes");
      check(degrees, functions, engine);
    }
}

// More coefficients than are kept in registers.
TEST(NodeView, LargeBlocks)
{
  std::mt19937_64 engine(2);
  for (int functions : {1, 2, 3, 4})
    for (const std::vector<int>& degrees : {std::vector<int>{30, 20}, {9, 9, 9}, {5, 4, 5, 4}})
      check(degrees, functions, engine);
}

} // namespace Node_view_test
