// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_BY_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_BY_ZEROS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Cell_arrangement.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/cell_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Puts the faces of cells together, and finds out which of them are neighbours.
class Trimmed_cells
{
  using Range = Surface_cell_3::Range;

  struct Border
  {
    std::vector<Border_interval> intervals; // in parameters of the surface, with indices of all faces
    Cell_polynomial zeros;
  };

  // A place where two faces may be neighbours, along so short a part of a border that it may be none.
  struct Doubtful_pair
  {
    std::size_t first, second;
    int axis;
    Exact_rational value;
    Range range;
  };

  const Trimming& m_trimming;
  Operation_budget& m_budget;
  std::vector<Surface_face_3> m_faces;
  std::vector<Border> m_borders; // of the cells
  std::vector<std::pair<std::size_t, std::size_t>> m_neighbours;
  std::vector<Doubtful_pair> m_doubtful;
  std::vector<Undecided_part> m_undecided;

public:
  Trimmed_cells(const Trimming& trimming, Operation_budget& budget) : m_trimming(trimming), m_budget(budget) {}

  Trimmed_surface_3 trimmed(double error)
  {
    for (std::size_t cell = 0; cell < m_trimming.cells.size(); ++cell)
      add_cell(cell, error);
    for (std::size_t a = 0; a < m_trimming.cells.size(); ++a)
      for (std::size_t b = 0; b < m_trimming.cells.size(); ++b)
        for (const int axis : {0, 1})
          if (follows(a, b, axis))
            add_neighbours(a, b, axis);
    std::vector<Surface_region_3> regions = united();
    Summary work = m_budget.total();
    work.seconds = m_budget.seconds();
    work.is_complete = m_undecided.empty();
    work.why_not = m_undecided.empty() ? Undecided_reason::NONE : m_budget.reason();
    if (!m_undecided.empty() && work.why_not == Undecided_reason::NONE)
      work.why_not = Undecided_reason::TOLERANCE;
    return {m_trimming.cells, std::move(m_faces), std::move(regions), std::move(m_undecided), work};
  }

private:
  const Surface_cell_3& cell_at(std::size_t cell) const { return m_trimming.cells[cell]; }

  void add_undecided(const std::array<Range, 2>& box, const std::string& reason)
  {
    std::vector<Undecided_part::Range> ranges{to_double_range(box[0]), to_double_range(box[1])};
    m_undecided.push_back({{}, {{0, std::move(ranges)}}, reason});
  }

  void add_cell(std::size_t cell, double error)
  {
    Border& border = m_borders.emplace_back();
    const std::size_t first = m_faces.size();
    try {
      m_budget.check();
      Cell_faces found = faces_of_cell(m_trimming.zeros(cell), error, m_budget);
      for (const Undecided_part& part : found.undecided)
        add_undecided({range_in(cell, 0, part.place[0]), range_in(cell, 1, part.place[1])}, part.reason);
      for (Surface_face_3& face : found.faces)
        m_faces.push_back(moved(cell, first, std::move(face)));
      border = {std::move(found.border), std::move(found.zeros)};
      for (Border_interval& interval : border.intervals) {
        interval.face += first;
        interval.range = {cell_at(cell).parameter(1 - interval.axis, interval.range.first),
                          cell_at(cell).parameter(1 - interval.axis, interval.range.second)};
      }
      for (std::size_t f = first; f < m_faces.size(); ++f) {
        m_budget.check();
        m_faces[f].label = m_trimming.label(cell, m_faces[f].sample);
        if (!m_faces[f].label)
          add_undecided(box_of(m_faces[f]), "the label of the face is not decided");
      }
    } catch (const Run_stopped& stop) {
      m_faces.resize(first);
      border = {};
      add_undecided(cell_at(cell).domain, in_words(stop.reason));
    }
  }

  Range range_in(std::size_t cell, int axis, const Undecided_part::Range& local) const
  {
    return {cell_at(cell).parameter(axis, Exact_rational(local.first)),
            cell_at(cell).parameter(axis, Exact_rational(local.second))};
  }

  static std::array<Range, 2> box_of(const Surface_face_3& face)
  {
    std::array<Range, 2> result{Range(face.sample[0], face.sample[0]), Range(face.sample[1], face.sample[1])};
    for (const Surface_face_edge_3& edge : face.loops.front())
      for (const int axis : {0, 1}) {
        Range& range = result[static_cast<std::size_t>(axis)];
        const Exact_rational x = edge.source.cartesian(axis);
        range = {(std::min)(range.first, x), (std::max)(range.second, x)};
      }
    return result;
  }

  // From the unit box into the cell, with faces numbered from `first` on.
  Surface_face_3 moved(std::size_t cell, std::size_t first, Surface_face_3 face) const
  {
    const Surface_cell_3& place = cell_at(cell);
    face.cell = cell;
    face.sample = {place.parameter(0, face.sample[0]), place.parameter(1, face.sample[1])};
    for (auto& loop : face.loops)
      for (Surface_face_edge_3& edge : loop) {
        edge.source = {place.parameter(0, edge.source.x()), place.parameter(1, edge.source.y())};
        if (edge.neighbour)
          *edge.neighbour += first;
      }
    return face;
  }

  // Whether the upper border of a cell along an axis is the lower one of another cell, or the same cell.
  bool follows(std::size_t a, std::size_t b, int axis) const
  {
    const std::size_t own = static_cast<std::size_t>(axis);
    const auto &first = cell_at(a).domain, &second = cell_at(b).domain;
    if (first[1 - own] != second[1 - own])
      return false;
    const auto is_last = [&](const Surface_cell_3& cell) { return !(first[own].second < cell.domain[own].second); };
    const auto is_first = [&](const Surface_cell_3& cell) { return !(cell.domain[own].first < second[own].first); };
    return first[own].second == second[own].first ||
        (m_trimming.is_closed[own] && std::ranges::all_of(m_trimming.cells, is_last) &&
         std::ranges::all_of(m_trimming.cells, is_first));
  }

  std::vector<Border_interval> side_of(std::size_t cell, int axis, int side) const
  {
    std::vector<Border_interval> result;
    for (const Border_interval& interval : m_borders[cell].intervals)
      if (interval.axis == axis && interval.side == side)
        result.push_back(interval);
    return result;
  }

  // Faces are neighbours across a border if intervals of theirs have a common part. Where points that separate these
  // are not told apart, those on both sides are one if the curves meet the border in the same points.
  void add_neighbours(std::size_t a, std::size_t b, int axis)
  {
    const std::vector<Border_interval> before = side_of(a, axis, 1), after = side_of(b, axis, 0);
    if (before.empty() || after.empty())
      return;
    for (const Border_interval& first : before)
      for (const Border_interval& second : after)
        if ((std::max)(first.range.first, second.range.first) < (std::min)(first.range.second, second.range.second))
          m_neighbours.emplace_back(first.face, second.face);
    if (are_proportional(m_borders[a].zeros.face(axis, 1), m_borders[b].zeros.face(axis, 0)))
      return;
    for (std::size_t i = 0; i + 1 < before.size(); ++i)
      for (std::size_t j = 0; j + 1 < after.size(); ++j) {
        const Range first(before[i].range.second, before[i + 1].range.first),
            second(after[j].range.second, after[j + 1].range.first);
        if (first.second < second.first || second.second < first.first ||
            (first == second && first.first == first.second))
          continue;
        const Exact_rational value = cell_at(a).domain[static_cast<std::size_t>(axis)].second;
        m_doubtful.push_back({before[i].face, after[j + 1].face, axis, value, first});
        m_doubtful.push_back({before[i + 1].face, after[j].face, axis, value, first});
      }
  }

  // The regions.
  std::vector<Surface_region_3> united()
  {
    for (std::size_t f = 0; f < m_faces.size(); ++f)
      for (const auto& loop : m_faces[f].loops)
        for (const Surface_face_edge_3& edge : loop)
          if (edge.neighbour)
            m_neighbours.emplace_back(f, *edge.neighbour);
    std::vector<std::size_t> root(m_faces.size());
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto root_of = [&](std::size_t f) {
      while (root[f] != f)
        f = root[f] = root[root[f]];
      return f;
    };
    for (const auto& [f, g] : m_neighbours)
      if (m_faces[f].label == m_faces[g].label)
        root[root_of(g)] = root_of(f);
    for (const Doubtful_pair& pair : m_doubtful)
      if (m_faces[pair.first].label == m_faces[pair.second].label && root_of(pair.first) != root_of(pair.second)) {
        std::array<Range, 2> box{pair.range, pair.range};
        box[static_cast<std::size_t>(pair.axis)] = {pair.value, pair.value};
        add_undecided(box, "it is not decided whether faces are neighbours");
      }
    std::vector<Surface_region_3> result;
    std::map<std::size_t, std::size_t> region_of;
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
      const auto [known, is_new] = region_of.emplace(root_of(f), result.size());
      if (is_new)
        result.push_back({m_faces[f].label, {}});
      m_faces[f].region = known->second;
      result[known->second].faces.push_back(f);
    }
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_surface_3 trimmed_by_zeros(const Trimming& trimming, Operation_budget& budget,
                                                                  double error)
{
  return Trimmed_cells(trimming, budget).trimmed(error);
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_BY_ZEROS_H
