// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/solver/internal/node/Row_elimination.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace row_elimination_test {

using CGAL::Spline_constraints::internal::Row_elimination;

struct Rows
{
  int rows, columns;
  std::vector<double> entries, radii;

  template <int size>
  Row_elimination<size> eliminated() const
  {
    Row_elimination<size> result(rows, columns);
    for (int i = 0; i < rows; ++i) {
      double row_size = 0;
      for (int k = 0; k < columns; ++k)
        row_size += std::abs(entries[i * columns + k]);
      result.set_row(i, entries.data() + i * columns, row_size, radii[i]);
    }
    result.run();
    return result;
  }
};

// Small integers, so that there are zeros, equal entries and matrices without an inverse.
Rows random_rows(std::mt19937& engine, int rows, int columns)
{
  std::uniform_int_distribution<int> entry(-3, 3), radius(0, 9);
  Rows result{rows, columns, std::vector<double>(rows * columns), std::vector<double>(rows)};
  for (double& x : result.entries)
    x = entry(engine);
  for (double& x : result.radii)
    x = radius(engine) == 0 ? 0.75 : 0;
  return result;
}

// The part that a row takes of the equations, applied to their rows, leaves one of its own unknown and nothing of those
// that other rows were solved for.
template <int size>
void expect_solved(const Rows& rows, const Row_elimination<size>& elimination)
{
  for (int row = 0; row < rows.rows; ++row)
    for (int pivot = 0; pivot < elimination.rank(); ++pivot) {
      double sum = 0;
      for (int k = 0; k < rows.rows; ++k)
        sum += elimination.part(row, k) *
            rows.entries[elimination.equation(k) * rows.columns + elimination.unknown(pivot)];
      EXPECT_NEAR(sum, row == pivot ? 1 : 0, 1e-12);
    }
}

template <int size>
int compare_with_unknown_size(int count)
{
  std::mt19937 engine(size);
  int regular = 0;
  for (int i = 0; i < count; ++i) {
    const Rows rows = random_rows(engine, size, size);
    const auto known = rows.eliminated<size>();
    const auto unknown = rows.eliminated<0>();
    expect_solved(rows, known);
    EXPECT_EQ(known.rank(), unknown.rank());
    for (int row = 0; row < size; ++row) {
      EXPECT_EQ(known.equation(row), unknown.equation(row));
      EXPECT_EQ(known.unknown(row), unknown.unknown(row));
      for (int k = 0; k < size; ++k)
        EXPECT_EQ(known.part(row, k), unknown.part(row, k));
    }
    regular += known.rank() == size;
  }
  return regular;
}

TEST(Row_elimination, Known_and_unknown_size_do_the_same)
{
  EXPECT_GT(compare_with_unknown_size<1>(500), 250);
  EXPECT_GT(compare_with_unknown_size<2>(500), 250);
  EXPECT_GT(compare_with_unknown_size<3>(500), 250);
  EXPECT_GT(compare_with_unknown_size<4>(500), 250);
}

TEST(Row_elimination, More_rows_than_columns_or_fewer)
{
  std::mt19937 engine(5);
  int full = 0;
  for (int i = 0; i < 500; ++i) {
    const Rows rows = random_rows(engine, 2 + i % 5, 2 + i / 5 % 5);
    const auto elimination = rows.eliminated<0>();
    expect_solved(rows, elimination);
    full += elimination.rank() == (std::min)(rows.rows, rows.columns);
  }
  EXPECT_GT(full, 250);
}

TEST(Row_elimination, Stops_at_rows_that_bound_nothing)
{
  const Rows rows{3, 3, {0, 4, 0, 2, 0, 0, 1, 1, 1}, {0, 0, 2}};   // the last row is wider than half its entries
  const auto elimination = rows.eliminated<3>();
  ASSERT_EQ(elimination.rank(), 2);
  EXPECT_EQ(elimination.equation(2), 2);
  for (int row : {0, 1})
    EXPECT_EQ(elimination.part(row, row), elimination.equation(row) == 0 ? 0.25 : 0.5);
  EXPECT_EQ(elimination.part(2, 2), 1);
}

} // namespace row_elimination_test
