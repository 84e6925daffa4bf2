// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SPARSE_ELIMINATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SPARSE_ELIMINATION_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Gauss-Jordan of sparse rows with interval right-hand sides, weighed as by Row_elimination: by what a row can still
contract; of pivots that are about as good, the one that makes the fewest new entries (Markowitz). Entries far below the
interval part of their row are dropped, so that the inverse stays sparse where its entries decay; what is done with the
rows does not depend on it, for they are formed anew with the multipliers that come out. A row that is the sum of many
is taken away from rows without a pivot only: those that have one keep its unknown, as in Gauss's elimination, and bound
their own one after it, if they are used in the reverse order of solved_rows().
*/
class Sparse_elimination
{
public:
  using Entry = std::pair<int, double>;
  using Row = std::vector<Entry>;

private:
  struct Own
  {
    Row entries, multipliers;
    double radius = 0, scale = 0, size = 0, largest = 0;
    int candidate = -1, pivot = -1; // a column with a large entry and few others; that of the pivot
  };

  int m_size;
  std::vector<Own> m_rows;
  std::vector<char> m_is_done;             // of columns
  std::vector<std::vector<int>> m_rows_of; // where a column may have an entry
  std::vector<double> m_work;
  std::vector<char> m_mark;
  std::vector<int> m_touched, m_others, m_solved_rows;

  static constexpr double least_entry = 1e-3; // beside the radius of the row
  static constexpr double about_as_good = 0.9;
  static constexpr std::size_t most_multipliers = 64; // that are added to rows which have a pivot

public:
  explicit Sparse_elimination(int size)
    : m_size(size), m_rows(size), m_is_done(size), m_rows_of(size), m_work(size), m_mark(size, 0)
  {}

  // Empties the rows, of which there are so many now, at most as many as at first.
  void begin(int size)
  {
    m_size = size;
    for (int i = 0; i < m_size; ++i) {
      m_rows[i].entries.clear();
      m_rows[i].multipliers.assign(1, {i, 1.0});
      m_rows[i].pivot = -1;
      m_rows_of[i].clear();
      m_is_done[i] = 0;
    }
    m_solved_rows.clear();
  }
  void add_entry(int row, int column, double value)
  {
    if (value != 0)
      m_rows[row].entries.emplace_back(column, value);
  }
  void set_radius(int row, double radius) { m_rows[row].radius = radius; }

  // `check()` may end the work by an exception.
  void run(const std::function<void()>& check);

  // Those with a pivot, in the order of their elimination.
  const std::vector<int>& solved_rows() const { return m_solved_rows; }
  // The column that a row was solved for, or -1.
  int pivot(int row) const { return m_rows[row].pivot; }
  // The multiples of rows that it is the sum of now.
  const Row& multipliers(int row) const { return m_rows[row].multipliers; }

private:
  void find_candidate(Own& row) const
  {
    row.largest = 0;
    row.candidate = -1;
    for (const auto& [column, value] : row.entries)
      if (m_is_done[column] == 0)
        row.largest = (std::max)(row.largest, std::abs(value));
    for (const auto& [column, value] : row.entries)
      if (m_is_done[column] == 0 && std::abs(value) >= about_as_good * row.largest &&
          std::abs(value) > 2 * row.radius &&
          (row.candidate < 0 || m_rows_of[column].size() < m_rows_of[row.candidate].size()))
        row.candidate = column;
  }

  int next_pivot() const;
  std::pair<int, double> cheapest_pivot(double least_weight) const;
  void eliminate(int pivot_row);
  template <class Stays>
  void add_multiple(Row& target, double factor, const Row& source, const Stays& stays);
  template <class Stays>
  void add_short_multiple(Row& target, double factor, const Row& source, const Stays& stays);
  template <class Stays>
  void add_long_multiple(Row& target, double factor, const Row& source, const Stays& stays);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Sparse_elimination::run(const std::function<void()>& check)
{
  for (int i = 0; i < m_size; ++i) {
    Own& row = m_rows[i];
    row.size = row.radius;
    for (const auto& [column, value] : row.entries) {
      row.size += std::abs(value);
      m_rows_of[column].push_back(i);
    }
    const double total = row.size + 2 * row.radius;
    row.scale = total > 0 ? 1 / total : 0;
    find_candidate(row);
  }
  for (int row = next_pivot(); row >= 0; row = next_pivot()) {
    check();
    eliminate(row);
  }
}

// Of rows that can still contract, and weigh nearly as much as any; or less, where that would fill many rows.
CGAL_SPLINE_CONSTRAINTS_INLINE int Sparse_elimination::next_pivot() const
{
  constexpr double many_entries = 4096, still_good = 0.05;
  double best = 1e-16;
  for (const Own& row : m_rows)
    if (row.pivot < 0 && row.candidate >= 0)
      best = (std::max)(best, row.largest * row.scale);
  const auto [result, cost] = cheapest_pivot(about_as_good * best);
  return cost > many_entries ? cheapest_pivot(still_good * best).first : result;
}

// With the bound for new entries.
CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<int, double> Sparse_elimination::cheapest_pivot(double least_weight) const
{
  std::pair<int, double> result(-1, 0.0);
  for (int i = 0; i < m_size; ++i) {
    const Own& row = m_rows[i];
    if (row.pivot >= 0 || row.candidate < 0 || !(row.largest * row.scale >= least_weight))
      continue;
    const double cost = (row.entries.size() - 1.0) * (m_rows_of[row.candidate].size() - 1.0);
    if (result.first < 0 || cost < result.second)
      result = {i, cost};
  }
  return result;
}

// `stays(place, value, is_new)`: whether an entry that was changed is kept.
template <class Stays>
void Sparse_elimination::add_multiple(Row& target, double factor, const Row& source, const Stays& stays)
{
  constexpr std::size_t times_as_long = 8;
  if (target.size() > times_as_long * source.size())
    add_short_multiple(target, factor, source, stays);
  else
    add_long_multiple(target, factor, source, stays);
}

// To a long row, of which most is left as it is.
template <class Stays>
void Sparse_elimination::add_short_multiple(Row& target, double factor, const Row& source, const Stays& stays)
{
  for (const auto& [place, value] : source) {
    const auto found =
        std::find_if(target.begin(), target.end(), [&, &p = place](const Entry& entry) { return entry.first == p; });
    const bool is_new = found == target.end();
    const double sum = factor * value + (is_new ? 0 : found->second);
    const bool is_kept = stays(place, sum, is_new);
    if (is_kept && is_new)
      target.emplace_back(place, sum);
    else if (is_kept)
      found->second = sum;
    else if (!is_new) {
      *found = target.back();
      target.pop_back();
    }
  }
}

template <class Stays>
void Sparse_elimination::add_long_multiple(Row& target, double factor, const Row& source, const Stays& stays)
{
  enum : char
  {
    ABSENT,
    OLD,
    NEW
  };
  m_touched.clear();
  for (const auto& [place, value] : target) {
    m_work[place] = value;
    m_mark[place] = OLD;
    m_touched.push_back(place);
  }
  for (const auto& [place, value] : source) {
    if (m_mark[place] == ABSENT) {
      m_mark[place] = NEW;
      m_work[place] = 0;
      m_touched.push_back(place);
    }
    m_work[place] += factor * value;
  }
  target.clear();
  for (const int place : m_touched) {
    if (stays(place, m_work[place], m_mark[place] == NEW))
      target.emplace_back(place, m_work[place]);
    m_mark[place] = ABSENT;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Sparse_elimination::eliminate(int pivot_row)
{
  Own& solved = m_rows[pivot_row];
  const int column = solved.pivot = solved.candidate;
  m_is_done[column] = 1;
  double entry = 0;
  for (const auto& [place, value] : solved.entries)
    if (place == column)
      entry = value;
  for (auto& [place, value] : solved.entries)
    value /= entry;
  for (auto& [place, value] : solved.multipliers)
    value /= entry;
  solved.radius /= std::abs(entry);
  m_solved_rows.push_back(pivot_row);
  const bool is_sum_of_many = solved.multipliers.size() > most_multipliers;
  m_others.swap(m_rows_of[column]);
  m_rows_of[column].clear();
  for (const int i : m_others) {
    Own& row = m_rows[i];
    if (is_sum_of_many && row.pivot >= 0)
      continue;
    double factor = 0;
    if (i != pivot_row)
      for (const auto& [place, value] : row.entries)
        if (place == column)
          factor = value;
    if (factor == 0)
      continue;
    row.radius += std::abs(factor) * solved.radius;
    const double least = least_entry * row.radius;
    add_multiple(row.entries, -factor, solved.entries, [&](int place, double value, bool is_new) {
      const bool stays = place != column && std::abs(value) > least;
      if (stays && is_new)
        m_rows_of[place].push_back(i);
      return stays;
    });
    add_multiple(row.multipliers, -factor, solved.multipliers,
                 [&](int place, double value, bool) { return std::abs(value) * m_rows[place].size > least; });
    if (row.pivot < 0)
      find_candidate(row);
  }
}

#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SPARSE_ELIMINATION_H
