// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_GROWING_WINDOWS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_GROWING_WINDOWS_H

#include <CGAL/Spline_constraints_d/internal/Parallel_loop.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Chain_window.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Covers all solutions of a chain of constraints by boxes. The chain is cut into windows of a few constraints, and each
window has a list of boxes in its own unknowns, its cells: wherever a solution lies, there is a cell of each window that
holds its part in the unknowns of the window, so that the cells of neighbouring windows meet in the unknowns that they
share. So a cell goes that meets none of a neighbour, others are narrowed to what they share with those they meet, and
all are narrowed by the constraints of their window. Cells are split in all windows: the work is a sum over the windows
where it would be a product for boxes in all unknowns. Each two neighbouring windows become one, windows with some
constraints in common, when not many of their cells meet; when there is one window left, its cells are the boxes.
*/
class Growing_windows
{
  // Between a window and the next one: the places of unknowns that they share, and cells that meet.
  struct Link
  {
    Pairs shared, cells;
  };
  // Where the cells that an old one was split into begin.
  struct Descendants
  {
    std::vector<int> first; // of each old cell, and one more
  };

  std::function<void()> m_check;
  Parallel_loop m_loop;
  std::vector<Chain_window> m_windows;
  std::vector<Link> m_links;
  Box_of_ranges m_cell;
  std::vector<Interval> m_first_support, m_second_support;
  std::vector<char> m_has_first_support, m_has_second_support;
  std::size_t m_work = 0;

public:
  // Cuts constraints, in the order of the chain, into windows.
  Growing_windows(const std::vector<Polynomial_constraint>& chain, const Box_of_ranges& domain,
                  const std::function<void()>& check, const Parallel_loop& loop);

  // One round of narrowing, then windows that can are joined, or cells are split.
  void advance();

  bool is_empty() const
  {
    return std::ranges::any_of(m_windows, [](const Chain_window& window) { return window.cells.size() == 0; });
  }
  // One window is left, or no solution.
  bool is_done() const { return m_windows.size() == 1 || is_empty(); }
  // How many cells were narrowed.
  std::size_t work() const { return m_work; }
  std::size_t cells() const
  {
    std::size_t result = 0;
    for (const Chain_window& window : m_windows)
      result += window.cells.size();
    return result;
  }
  // The cells of the last window, with the ranges that other unknowns have in a box; none where there is no solution.
  std::vector<Box_of_ranges> boxes(const Box_of_ranges& domain) const
  {
    std::vector<Box_of_ranges> result;
    if (is_empty())
      return result;
    const Chain_window& window = m_windows.front();
    for (std::size_t i = 0; i < window.cells.size(); ++i) {
      Box_of_ranges& box = result.emplace_back(domain);
      for (std::size_t p = 0; p < window.unknowns.size(); ++p)
        box[window.unknowns[p]] = window.cells[i][p];
    }
    return result;
  }

private:
  // Extends the hull of what was shared so far.
  static void extend_to(Interval& hull, const Interval& part, bool is_first)
  {
    hull = is_first ? part : Interval((std::min)(hull.inf(), part.inf()), (std::max)(hull.sup(), part.sup()));
  }
  // How wide a range is, where numbers below one are alike and others are seen by their orders of magnitude.
  static double size(const Interval& range) { return std::asinh(range.sup()) - std::asinh(range.inf()); }

  void narrow_cells(Chain_window& window, const std::vector<std::size_t>& asked);
  void narrow_by_neighbours(std::size_t link);
  void narrow_by_support(Chain_window& window, const Pairs& shared, bool is_first);
  static std::vector<int> remove_cells_of(Chain_window& window);
  void remove_cells();
  double largest_size() const;
  void split_cells();
  bool join_windows();
  void leave_out_windows();
  void join_neighbours();
  Chain_window joined(std::size_t index, std::vector<int>& first_of, std::vector<int>& second_of);
  static bool covers(const Chain_window& a, const Chain_window& b, const Chain_window& between);
  void relink(Link& link, const Chain_window& a, const Chain_window& b, const Descendants& of_a,
              const Descendants& of_b);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE
Growing_windows::Growing_windows(const std::vector<Polynomial_constraint>& chain, const Box_of_ranges& domain,
                                 const std::function<void()>& check, const Parallel_loop& loop)
  : m_check(check), m_loop(loop)
{
  constexpr std::size_t constraints_of_window = 2;
  for (std::size_t first = 0; first < chain.size(); first += constraints_of_window) {
    const std::size_t last = (std::min)(first + constraints_of_window, chain.size());
    Chain_window& window =
        m_windows.emplace_back(chain_window_of({chain.begin() + first, chain.begin() + last}, m_check));
    window.first = static_cast<int>(first);
    window.last = static_cast<int>(last);
    m_cell.clear();
    for (const int j : window.unknowns)
      m_cell.push_back(domain[j]);
    window.cells.push_back(m_cell);
    window.is_left.assign(1, 1);
    narrow_cells(window, {0});
    remove_cells_of(window);
    if (first == 0)
      continue;
    Link& link = m_links.emplace_back();
    link.shared = shared_unknowns(*(m_windows.end() - 2), window);
    link.cells.emplace_back(0, 0);
  }
}

// Narrows some cells, those that are asked for, by all constraints of the window; they go where nothing is left.
CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::narrow_cells(Chain_window& window,
                                                                  const std::vector<std::size_t>& asked)
{
  constexpr std::size_t cells_of_task = 64;
  m_work += asked.size();
  window.narrowings.resize((std::max)(window.narrowings.size(), m_loop.slots()));
  m_loop((asked.size() + cells_of_task - 1) / cells_of_task, [&](std::size_t task, std::size_t slot) {
    m_check();
    const Upward_rounding_guard guard;
    std::unique_ptr<Cell_narrowing>& narrowing = window.narrowings[slot];
    if (narrowing == nullptr)
      narrowing = std::make_unique<Cell_narrowing>(*window.system, m_check);
    Box_of_ranges cell;
    for (std::size_t k = task * cells_of_task; k < (std::min)((task + 1) * cells_of_task, asked.size()); ++k) {
      window.cells.get(asked[k], cell);
      window.is_left[asked[k]] = (*narrowing)(cell) ? 1 : 0;
      window.cells.set(asked[k], cell);
    }
  });
}

// Narrows the cells of two windows to what they share with those they meet.
CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::narrow_by_neighbours(std::size_t index)
{
  m_check();
  Link& link = m_links[index];
  Chain_window &a = m_windows[index], &b = m_windows[index + 1];
  const std::size_t width = link.shared.size();
  m_first_support.resize(a.cells.size() * width);
  m_second_support.resize(b.cells.size() * width);
  m_has_first_support.assign(a.cells.size(), 0);
  m_has_second_support.assign(b.cells.size(), 0);
  std::erase_if(link.cells, [&](const std::pair<int, int>& pair) {
    const auto [i, j] = pair;
    const Interval *first = a.cells[i], *second = b.cells[j];
    if (a.is_left[i] == 0 || b.is_left[j] == 0 || !meet(first, second, link.shared))
      return true;
    for (std::size_t s = 0; s < width; ++s) {
      const Interval part = common_part(first[link.shared[s].first], second[link.shared[s].second]);
      extend_to(m_first_support[i * width + s], part, m_has_first_support[i] == 0);
      extend_to(m_second_support[j * width + s], part, m_has_second_support[j] == 0);
    }
    m_has_first_support[i] = m_has_second_support[j] = 1;
    return false;
  });
  narrow_by_support(a, link.shared, true);
  narrow_by_support(b, link.shared, false);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::narrow_by_support(Chain_window& window, const Pairs& shared,
                                                                       bool is_first)
{
  constexpr double much = 0.9; // of the width: then the constraints are asked again
  const std::vector<char>& has_support = is_first ? m_has_first_support : m_has_second_support;
  const std::vector<Interval>& support = is_first ? m_first_support : m_second_support;
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < window.cells.size(); ++i) {
    if (window.is_left[i] == 0)
      continue;
    if (has_support[i] == 0) {
      window.is_left[i] = 0;
      continue;
    }
    window.cells.get(i, m_cell);
    bool is_narrowed_much = false;
    for (std::size_t s = 0; s < shared.size(); ++s) {
      Interval& range = m_cell[is_first ? shared[s].first : shared[s].second];
      const Interval& to = support[i * shared.size() + s];
      is_narrowed_much = is_narrowed_much || internal::width(to) < much * internal::width(range);
      range = to;
    }
    if (is_narrowed_much)
      asked.push_back(i);
    window.cells.set(i, m_cell);
  }
  narrow_cells(window, asked);
}

// Those that are not left; how many are before each cell, and in all.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<int> Growing_windows::remove_cells_of(Chain_window& window)
{
  std::vector<int> before{0};
  Box_list left(window.unknowns.size());
  for (std::size_t i = 0; i < window.cells.size(); ++i) {
    if (window.is_left[i] != 0)
      left.push_back(window.cells[i]);
    before.push_back(static_cast<int>(left.size()));
  }
  window.cells = std::move(left);
  window.is_left.assign(window.cells.size(), 1);
  return before;
}

// Those that are not left, from windows and links.
CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::remove_cells()
{
  std::vector<std::vector<int>> before;
  for (Chain_window& window : m_windows)
    before.push_back(remove_cells_of(window));
  for (std::size_t k = 0; k < m_links.size(); ++k)
    std::erase_if(m_links[k].cells, [&](std::pair<int, int>& pair) {
      const bool is_left = before[k][pair.first] < before[k][pair.first + 1] &&
          before[k + 1][pair.second] < before[k + 1][pair.second + 1];
      pair = {before[k][pair.first], before[k + 1][pair.second]};
      return !is_left || !meet(m_windows[k].cells[pair.first], m_windows[k + 1].cells[pair.second], m_links[k].shared);
    });
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::advance()
{
  for (std::size_t k = 0; k < m_links.size(); ++k)
    narrow_by_neighbours(k);
  for (std::size_t k = m_links.size(); k-- > 1;)
    narrow_by_neighbours(k - 1);
  remove_cells();
  if (!is_done() && !join_windows())
    split_cells();
}

CGAL_SPLINE_CONSTRAINTS_INLINE double Growing_windows::largest_size() const
{
  double largest = 0;
  for (const Chain_window& window : m_windows)
    for (std::size_t i = 0; i < window.cells.size(); ++i)
      for (std::size_t j = 0; j < window.unknowns.size(); ++j)
        largest = (std::max)(largest, window.weight[j] * size(window.cells[i][j]));
  return largest;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::split_cells()
{
  constexpr double nearly_largest = 0.7;
  const double largest = largest_size();
  std::vector<Descendants> descendants(m_windows.size());
  for (std::size_t k = 0; k < m_windows.size(); ++k) {
    m_check();
    Box_list old(m_windows[k].unknowns.size());
    std::swap(old, m_windows[k].cells);
    Chain_window& window = m_windows[k];
    std::vector<std::size_t> asked, first;
    for (std::size_t i = 0; i < old.size(); ++i) {
      first.push_back(window.cells.size());
      const Interval* cell = old[i];
      std::size_t widest = 0;
      for (std::size_t j = 1; j < window.unknowns.size(); ++j)
        if (size(cell[j]) * window.weight[j] > size(cell[widest]) * window.weight[widest])
          widest = j;
      const double lower = std::asinh(cell[widest].inf()), upper = std::asinh(cell[widest].sup());
      const double at = std::sinh(lower + 0.5 * (upper - lower));
      old.get(i, m_cell);
      if (window.weight[widest] * (upper - lower) < nearly_largest * largest ||
          !(at > cell[widest].inf() && at < cell[widest].sup())) {
        window.cells.push_back(m_cell);
        continue;
      }
      for (const Interval& half : {Interval(cell[widest].inf(), at), Interval(at, cell[widest].sup())}) {
        asked.push_back(window.cells.size());
        m_cell[widest] = half;
        window.cells.push_back(m_cell);
      }
    }
    first.push_back(window.cells.size());
    window.is_left.assign(window.cells.size(), 1);
    narrow_cells(window, asked);
    const std::vector<int> before = remove_cells_of(window);
    for (const std::size_t i : first)
      descendants[k].first.push_back(before[i]);
  }
  for (std::size_t k = 0; k < m_links.size(); ++k)
    relink(m_links[k], m_windows[k], m_windows[k + 1], descendants[k], descendants[k + 1]);
}

// The pairs of descendants that meet.
CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::relink(Link& link, const Chain_window& a, const Chain_window& b,
                                                            const Descendants& of_a, const Descendants& of_b)
{
  Pairs result;
  for (const auto& [i, j] : link.cells) {
    const int first_i = of_a.first[i], last_i = of_a.first[i + 1];
    const int first_j = of_b.first[j], last_j = of_b.first[j + 1];
    for (int p = first_i; p < last_i; ++p)
      for (int q = first_j; q < last_j; ++q)
        if (meet(a.cells[p], b.cells[q], link.shared))
          result.emplace_back(p, q);
  }
  link.cells = std::move(result);
}

// As soon as few enough cells meet: the shorter the windows, the more of what meets goes by the constraints of both.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Growing_windows::join_windows()
{
  constexpr double coarse = 1;           // cells of more than one order of magnitude
  constexpr std::size_t long_enough = 8; // to do without every second one
  const std::size_t length = m_windows.front().constraints.size();
  const double most_pairs = length <= 2 ? 20 : length <= 4 ? 10 : 6; // for each cell
  if (largest_size() > coarse)
    return false;
  std::size_t pairs = 0;
  for (const Link& link : m_links)
    pairs += link.cells.size();
  if (static_cast<double>(pairs) > most_pairs * static_cast<double>(cells()))
    return false;
  if (length >= long_enough)
    leave_out_windows();
  join_neighbours();
  return true;
}

// Every second window is left out, as its constraints are in those beside it; cells that are two links apart meet.
CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::leave_out_windows()
{
  for (std::size_t k = 0; k + 2 < m_windows.size(); ++k) {
    if (!covers(m_windows[k], m_windows[k + 2], m_windows[k + 1]))
      continue;
    Link& link = m_links[k];
    std::vector<std::vector<int>> next(m_windows[k + 1].cells.size());
    for (const auto& [i, j] : m_links[k + 1].cells)
      next[i].push_back(j);
    link.shared = shared_unknowns(m_windows[k], m_windows[k + 2]);
    Pairs result;
    for (const auto& [i, j] : link.cells)
      for (const int q : next[j])
        if (meet(m_windows[k].cells[i], m_windows[k + 2].cells[q], link.shared))
          result.emplace_back(i, q);
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    link.cells = std::move(result);
    m_windows.erase(m_windows.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    m_links.erase(m_links.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    --k;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Growing_windows::covers(const Chain_window& a, const Chain_window& b,
                                                            const Chain_window& between)
{
  return between.last <= a.last || b.first <= a.last;
}

// Each window and the next one become one: those that result have a window in common.
CGAL_SPLINE_CONSTRAINTS_INLINE void Growing_windows::join_neighbours()
{
  std::vector<Chain_window> windows;
  std::vector<Link> links;
  std::vector<int> of_second; // of the cells of the last window that was made: where they come from
  for (std::size_t k = 0; k + 1 < m_windows.size(); ++k) {
    m_check();
    std::vector<int> first_of, second_of;
    windows.push_back(joined(k, first_of, second_of));
    if (k > 0) {
      Link& link = links.emplace_back();
      link.shared = shared_unknowns(windows[k - 1], windows[k]);
      std::vector<std::vector<int>> with_first(m_windows[k].cells.size());
      for (std::size_t i = 0; i < first_of.size(); ++i)
        with_first[first_of[i]].push_back(static_cast<int>(i));
      for (std::size_t i = 0; i < of_second.size(); ++i)
        for (const int j : with_first[of_second[i]])
          if (meet(windows[k - 1].cells[i], windows[k].cells[j], link.shared))
            link.cells.emplace_back(static_cast<int>(i), j);
    }
    of_second = std::move(second_of);
  }
  m_windows = std::move(windows);
  m_links = std::move(links);
}

// A window and the next one: cells that meet, narrowed, and which they were.
CGAL_SPLINE_CONSTRAINTS_INLINE Chain_window Growing_windows::joined(std::size_t index, std::vector<int>& first_of,
                                                                    std::vector<int>& second_of)
{
  const Chain_window &a = m_windows[index], &b = m_windows[index + 1];
  std::vector<Polynomial_constraint> constraints = a.constraints;
  const int skipped = (std::max)(0, a.last - b.first);
  constraints.insert(constraints.end(), b.constraints.begin() + skipped, b.constraints.end());
  Chain_window result = chain_window_of(std::move(constraints), m_check);
  result.first = a.first;
  result.last = b.last;
  const auto places = [&](const Chain_window& part) {
    std::vector<int> own;
    for (const int j : part.unknowns)
      own.push_back(static_cast<int>(std::ranges::lower_bound(result.unknowns, j) - result.unknowns.begin()));
    return own;
  };
  const std::vector<int> places_of_a = places(a), places_of_b = places(b);
  for (const auto& [i, j] : m_links[index].cells) {
    m_cell.resize(result.unknowns.size());
    for (std::size_t p = 0; p < places_of_a.size(); ++p)
      m_cell[places_of_a[p]] = a.cells[i][p];
    for (std::size_t p = 0; p < places_of_b.size(); ++p)
      m_cell[places_of_b[p]] = b.cells[j][p];
    for (const auto& [p, q] : m_links[index].shared)
      m_cell[places_of_a[p]] = common_part(a.cells[i][p], b.cells[j][q]);
    result.cells.push_back(m_cell);
  }
  result.is_left.assign(result.cells.size(), 1);
  std::vector<std::size_t> all(result.cells.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  narrow_cells(result, all);
  const std::vector<int> before = remove_cells_of(result);
  for (const std::size_t i : all)
    if (before[i] < before[i + 1]) {
      first_of.push_back(m_links[index].cells[i].first);
      second_of.push_back(m_links[index].cells[i].second);
    }
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_GROWING_WINDOWS_H
