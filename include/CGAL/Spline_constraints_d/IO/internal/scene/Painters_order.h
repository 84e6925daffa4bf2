// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PAINTERS_ORDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PAINTERS_ORDER_H

#include <CGAL/Spline_constraints_d/IO/internal/scene/Picture_grid.h>
#include <CGAL/Spline_constraints_d/IO/internal/scene/Projected_facets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Scene {

/*
Facets in an order in which each may be painted over those before: in each point of the picture the last one is the
nearest one, or farther by the rounding at most. Facets that pass through each other by more are split where they meet.
Where facets cover each other in a circle, one of them is split: where it passes through the next one, if only by the
rounding, else along the outline of that one, into what is behind it and the rest. Without rounding, depths in one point
of the picture form no circle, so that this ends, when each part is one cell of the arrangement of all edges at the
latest. Of facets with the same depth, the later one is painted later.

A mesh that passes through itself everywhere, as many needles at a tip do, would fall into as many parts as there are
pairs: beyond a number of splits, facets are painted whole, the one whose mean depth is nearer later.

Complexity: a comparison, exact, per pair of facets whose boxes meet in the picture.
*/
class Painters_order
{
  std::size_t m_splits_left, m_unsplit = 0;
  Picture_grid m_grid;
  std::vector<Facet> m_facets;
  std::vector<bool> m_is_split;

  // Another facet, which covers one.
  struct Cover
  {
    std::size_t facet;
    bool is_crossing, is_clear;   // is it also farther somewhere; is it nearer by more than the rounding
    bool is_unsplit;              // both are nearer by more somewhere
  };
  std::vector<std::vector<Cover>> m_nearer;   // of each facet

public:
  Painters_order(const std::array<double, 4>& picture, const std::vector<Grid_triangle>& triangles,
                 std::size_t most_splits)
    : m_splits_left(most_splits), m_grid(picture, triangles.size())
  {
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (turn(triangles[i][0], triangles[i][1], triangles[i][2]) > 0)   // else nothing is seen of it
        insert(Facet(i, triangles[i]));
  }

  std::vector<Facet> facets()
  {
    std::optional<std::vector<std::size_t>> order;
    while (!order)
      order = order_or_split();
    std::vector<Facet> result;
    for (const std::size_t i : *order)
      result.push_back(m_facets[i]);
    return result;
  }

  // Pairs of facets that pass through each other still.
  std::size_t number_of_unsplit() const { return m_unsplit; }

private:
  void insert(Facet facet)
  {
    std::vector<Facet> open{std::move(facet)};
    while (!open.empty()) {
      Facet next = std::move(open.back());
      open.pop_back();
      std::vector<Cover> nearer, farther;
      if (const std::optional<std::size_t> crossed = compare_with_all(next, nearer, farther)) {
        for (auto& part : split_at_plane(next, m_facets[*crossed]))
          open.push_back(next.part(std::move(part)));
        --m_splits_left;
        continue;
      }
      const std::size_t index = m_facets.size();
      for (const auto* covers : {&nearer, &farther})
        m_unsplit += std::count_if(covers->begin(), covers->end(), [](const Cover& cover) { return cover.is_unsplit; });
      for (const Cover& cover : farther)
        m_nearer[cover.facet].push_back({index, cover.is_crossing, cover.is_clear, cover.is_unsplit});
      m_nearer.push_back(std::move(nearer));
      m_grid.add(next.box);
      m_facets.push_back(std::move(next));
      m_is_split.push_back(false);
    }
  }

  // Those nearer and farther than a facet; returns one that clearly passes through it.
  std::optional<std::size_t> compare_with_all(const Facet& facet, std::vector<Cover>& nearer,
                                              std::vector<Cover>& farther) const
  {
    std::optional<std::size_t> crossed;
    m_grid.visit(facet.box, [&](std::size_t i) {
      if (m_is_split[i] || crossed)
        return;
      const Overlap overlap = overlap_of(facet, m_facets[i]);
      if (overlap.is_empty)
        return;
      const bool is_unsplit = overlap.first_is_clear && overlap.second_is_clear;
      if (is_unsplit && m_splits_left > 0)
        crossed = i;
      else {
        const bool is_nearer = is_unsplit ? mean_depth(facet) > mean_depth(m_facets[i])
                                          : is_nearer_by_signs(overlap, facet.source > m_facets[i].source);
        const bool is_clear = !is_unsplit && (overlap.first_is_clear || overlap.second_is_clear);
        (is_nearer ? farther : nearer).push_back({i, overlap.is_crossing(), is_clear, is_unsplit});
      }
    });
    return crossed;
  }

  // Of the first facet of a pair.
  static bool is_nearer_by_signs(const Overlap& overlap, bool is_later)
  {
    if (overlap.first_is_clear != overlap.second_is_clear)
      return overlap.first_is_clear;
    return overlap.first_is_nearer == overlap.second_is_nearer ? is_later : overlap.first_is_nearer;
  }

  static double mean_depth(const Facet& facet)
  {
    double sum = 0;
    for (const Exact_point& p : facet.outline())
      sum += CGAL::to_double(p[2]);
    return sum / static_cast<double>(facet.outline().size());
  }

  static std::array<std::vector<Exact_point>, 2> split_at_plane(const Facet& facet, const Facet& other)
  {
    std::vector<Exact_rational> values;
    for (const Exact_point& p : facet.outline())
      values.push_back(height_over(other.exact_plane, p));
    return split_outline(facet.outline(), values);
  }

  // All facets, each after those that it covers; none when one of a circle was split.
  std::optional<std::vector<std::size_t>> order_or_split()
  {
    std::vector<std::size_t> waits_for(m_facets.size()), result;
    std::vector<bool> is_left(m_facets.size());
    std::vector<std::vector<std::size_t>> covered(m_facets.size()); // by each facet; it waits for those that are left
    for (std::size_t i = 0; i < m_facets.size(); ++i) {
      is_left[i] = !m_is_split[i];
      if (is_left[i])
        for (const Cover& cover : m_nearer[i]) {
          ++waits_for[cover.facet];
          covered[cover.facet].push_back(i);
        }
    }
    std::vector<std::size_t> place(m_facets.size(), m_facets.size()); // on a path; none between paths
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready;
    for (std::size_t i = 0; i < m_facets.size(); ++i)
      if (is_left[i] && waits_for[i] == 0)
        ready.push(i);
    std::size_t first_left = 0;
    for (;;) {
      while (!ready.empty()) {
        const std::size_t i = ready.top();
        ready.pop();
        result.push_back(i);
        is_left[i] = false;
        for (const Cover& cover : m_nearer[i])
          if (is_left[cover.facet] && --waits_for[cover.facet] == 0)
            ready.push(cover.facet);
      }
      while (first_left < is_left.size() && !is_left[first_left])
        ++first_left;
      if (first_left == is_left.size())
        return result;
      const std::optional<std::size_t> freed = break_circle(circle_from(first_left, is_left, covered, place));
      if (!freed)
        return std::nullopt;
      if (--waits_for[*freed] == 0)
        ready.push(*freed);
    }
  }

  // Facets each of which covers the next one, and the last one the first, behind one that waits. What a facet does not
  // wait for any more is taken off its list.
  std::vector<std::size_t> circle_from(std::size_t start, const std::vector<bool>& is_left,
                                       std::vector<std::vector<std::size_t>>& covered, std::vector<std::size_t>& place)
  {
    std::vector<std::size_t> path;
    std::size_t i = start;
    while (place[i] == m_facets.size()) {
      place[i] = path.size();
      path.push_back(i);
      while (!is_left[covered[i].back()] || cover_of(covered[i].back(), i) == m_nearer[covered[i].back()].end())
        covered[i].pop_back();
      i = covered[i].back();
    }
    const std::vector<std::size_t> circle(path.begin() + static_cast<std::ptrdiff_t>(place[i]), path.end());
    for (const std::size_t facet : path)
      place[facet] = m_facets.size();
    return circle;
  }

  // Splits a facet; or else gives up that one is painted after the next one of the circle, and returns it. In one
  // point of the picture, the depths are in order: of facets that do not cross, not all have the same outline.
  std::optional<std::size_t> break_circle(const std::vector<std::size_t>& circle)
  {
    const auto next = [&](std::size_t i) { return circle[(i + 1) % circle.size()]; };
    const auto give_up = [&](std::size_t i) {
      m_nearer[next(i)].erase(cover_of(next(i), circle[i]));
      return circle[i];
    };
    for (std::size_t i = 0; i < circle.size(); ++i)
      if (const Cover cover = *cover_of(next(i), circle[i]); cover.is_crossing && !cover.is_clear)
        return give_up(i);   // either may be painted over the other one
    if (m_splits_left == 0) {
      ++m_unsplit;
      return give_up(0);
    }
    --m_splits_left;
    for (std::size_t i = 0; i < circle.size(); ++i)
      if (cover_of(next(i), circle[i])->is_crossing) {
        std::vector<Facet> parts;
        for (auto& part : split_at_plane(m_facets[circle[i]], m_facets[next(i)]))
          parts.push_back(m_facets[circle[i]].part(std::move(part)));
        replace(circle[i], std::move(parts));
        return std::nullopt;
      }
    for (std::size_t i = 0; i < circle.size(); ++i)
      for (const auto& [split, knife] : {std::pair(circle[i], next(i)), std::pair(next(i), circle[i])})
        if (std::vector<Facet> parts = split_along_outline(m_facets[split], m_facets[knife]); parts.size() > 1) {
          replace(split, std::move(parts));
          return std::nullopt;
        }
    return give_up(0);   // not reached
  }

  std::vector<Cover>::iterator cover_of(std::size_t covered, std::size_t facet)
  {
    auto& covers = m_nearer[covered];
    return std::find_if(covers.begin(), covers.end(), [&](const Cover& cover) { return cover.facet == facet; });
  }

  void replace(std::size_t facet, std::vector<Facet> parts)
  {
    m_is_split[facet] = true;
    for (Facet& part : parts)
      insert(std::move(part));
  }

  static std::vector<Facet> split_along_outline(const Facet& facet, const Facet& knife)
  {
    std::vector<Facet> result;
    Facet rest = facet;
    const auto edges = knife.outline();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      std::vector<Exact_rational> values;
      bool has_inside = false, has_outside = false;
      for (const Exact_point& p : rest.outline()) {
        values.push_back(turn(edges[i], edges[(i + 1) % edges.size()], p));
        has_inside = has_inside || values.back() > 0;
        has_outside = has_outside || values.back() < 0;
      }
      if (!has_inside || !has_outside)
        continue;
      auto [inside, outside] = split_outline(rest.outline(), values);
      result.push_back(facet.part(std::move(outside)));
      rest = facet.part(std::move(inside));
    }
    result.push_back(std::move(rest));
    return result;
  }
};

} // namespace Scene
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PAINTERS_ORDER_H
