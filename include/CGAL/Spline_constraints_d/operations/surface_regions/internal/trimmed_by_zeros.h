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
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Disjoint_sets.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/cell_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
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

  // A place where two faces may be neighbours, along so short a part of a border that it may be none.
  struct Doubtful_pair
  {
    std::size_t first, second;
    int axis;
    Exact_rational value;
    Range range;
  };

  static constexpr int most_depth = 8;

  const Trimming& m_trimming;
  Operation_budget& m_budget;
  double m_error;
  std::vector<Surface_cell_3> m_cells;
  std::vector<std::vector<Cell_polynomial>> m_zeros;    // of the cells
  std::vector<std::vector<Surface_border_3>> m_borders; // of the cells
  std::vector<Surface_face_3> m_faces;
  std::vector<std::pair<std::size_t, std::size_t>> m_neighbours;
  std::vector<Doubtful_pair> m_doubtful;
  std::vector<Undecided_part> m_undecided;

public:
  Trimmed_cells(const Trimming& trimming, Operation_budget& budget, double error)
    : m_trimming(trimming), m_budget(budget), m_error(error)
  {}

  Trimmed_surface_3 trimmed()
  {
    for (std::size_t whole = 0; whole < m_trimming.cells.size(); ++whole)
      try {
        m_budget.check();
        if (std::optional<std::vector<Labelled_part>> parts = m_trimming.parts ? m_trimming.parts(whole) : std::nullopt)
          add_labelled_parts(whole, *std::move(parts));
        else
          add_part(whole, m_trimming.cells[whole], m_trimming.zeros(whole), 0);
      } catch (const Run_stopped& stop) {
        add_without_faces(m_trimming.cells[whole], {m_trimming.cells[whole].domain}, in_words(stop.reason));
      }
    for (const int axis : {0, 1})
      add_neighbours(axis);
    std::vector<Surface_region_3> regions = united();
    std::vector<Surface_border_3> borders;
    for (const auto& of_cell : m_borders)
      borders.insert(borders.end(), of_cell.begin(), of_cell.end());
    Summary work = m_budget.total();
    work.seconds = m_budget.seconds();
    work.is_complete = m_undecided.empty();
    work.why_not = m_undecided.empty() ? Undecided_reason::NONE : m_budget.reason();
    if (!m_undecided.empty() && work.why_not == Undecided_reason::NONE)
      work.why_not = Undecided_reason::TOLERANCE;
    return {std::move(m_cells), std::move(m_faces),     std::move(regions),
            std::move(borders), std::move(m_undecided), work};
  }

private:
  void add_undecided(const std::array<Range, 2>& box, const std::string& reason)
  {
    std::vector<Undecided_part::Range> ranges{to_double_range(box[0]), to_double_range(box[1])};
    m_undecided.push_back({{}, {{0, std::move(ranges)}}, reason});
  }

  void add_without_faces(const Surface_cell_3& cell, const std::vector<std::array<Range, 2>>& boxes,
                         const std::string& reason)
  {
    m_cells.push_back(cell);
    m_zeros.emplace_back();
    m_borders.emplace_back();
    for (const std::array<Range, 2>& box : boxes)
      add_undecided(box, reason);
  }

  void add_labelled_parts(std::size_t whole, std::vector<Labelled_part> parts)
  {
    for (Labelled_part& part : parts) {
      const Surface_cell_3 own = part_of(m_trimming.cells[whole], part.box);
      if (part.faces.undecided.empty())
        add_faces(whole, own, std::move(part.faces));
      else
        add_without_faces(own, {own.domain}, part.faces.undecided.front().reason);
    }
  }

  static Surface_cell_3 part_of(const Surface_cell_3& cell, const std::array<Range, 2>& box)
  {
    if (box == std::array<Range, 2>{Range(0, 1), Range(0, 1)})
      return cell;
    Surface_cell_3 result{{Range(cell.parameter(0, box[0].first), cell.parameter(0, box[0].second)),
                           Range(cell.parameter(1, box[1].first), cell.parameter(1, box[1].second))},
                          cell.coordinates};
    for (Cell_polynomial& f : result.coordinates)
      f = f.restricted_to_box(box);
    return result;
  }

  // The faces of a part of a cell. Where they are not found, it is split, so that the rest is small.
  void add_part(std::size_t whole, const Surface_cell_3& part, const std::vector<Cell_polynomial>& zeros, int depth)
  {
    const std::optional<std::vector<Cell_polynomial>> curves = curves_of(zeros);
    if (!curves) {
      add_without_faces(part, {part.domain}, in_words(Undecided_reason::CONTINUUM));
      return;
    }
    try {
      m_budget.check();
      Cell_faces found = faces_of(*curves, depth);
      m_budget.check();
      if (found.undecided.empty()) {
        add_faces(whole, part, std::move(found));
        return;
      }
      if (depth == most_depth || m_budget.has_ended()) {
        std::vector<std::array<Range, 2>> boxes;
        for (const Undecided_part& u : found.undecided)
          boxes.push_back({range_in(part, 0, u.place[0]), range_in(part, 1, u.place[1])});
        add_without_faces(part, boxes, found.undecided.front().reason);
        return;
      }
    } catch (const Run_stopped& stop) {
      add_without_faces(part, {part.domain}, in_words(stop.reason));
      return;
    }
    add_quarters(whole, part, *curves, depth);
  }

  // The singular points of a product are proved where this is cheap, or all else has failed: most of several curves
  // are simple arcs in small parts.
  Cell_faces faces_of(const std::vector<Cell_polynomial>& curves, int depth)
  {
    constexpr int most_degrees_at_first = 8, most_degrees = 16;
    const int degrees = sum_of_degrees(curves);
    if (curves.size() <= 1 || (depth == 0 && degrees <= most_degrees_at_first))
      return faces_of_product(curves, m_error, m_budget);
    Cell_faces result = faces_of_arcs(curves, m_error, m_budget);
    if (!result.undecided.empty() && depth == most_depth && degrees <= most_degrees)
      return faces_of_product(curves, m_error, m_budget);
    return result;
  }

  // Not in the middle, where curves cross in symmetrical scenes.
  void add_quarters(std::size_t whole, const Surface_cell_3& part, const std::vector<Cell_polynomial>& curves,
                    int depth)
  {
    const Exact_rational cut(15, 32);
    const std::array<Range, 2> halves{Range(0, cut), Range(cut, 1)};
    for (const Range& u : halves)
      for (const Range& v : halves) {
        const std::vector<Range> box{u, v};
        std::vector<Cell_polynomial> own = curves;
        for (Cell_polynomial& f : own)
          f = f.restricted_to_box(box);
        add_part(whole, part_of(part, {u, v}), own, depth + 1);
      }
  }

  // \throws Run_stopped, with nothing added.
  void add_faces(std::size_t whole, const Surface_cell_3& part, Cell_faces found)
  {
    const std::size_t first = m_faces.size();
    std::vector<Surface_face_3> faces;
    for (Surface_face_3& face : found.faces) {
      if (!face.label)
        m_budget.check();
      faces.push_back(moved(part, first, std::move(face)));
      if (!faces.back().label)
        faces.back().label = m_trimming.label(whole, faces.back().sample);
    }
    for (Surface_face_3& face : faces) {
      if (!face.label)
        add_undecided(box_of(face), "the label of the face is not decided");
      m_faces.push_back(std::move(face));
    }
    for (Surface_border_3& border : found.borders) {
      border.face += first;
      border.range = {part.parameter(1 - border.axis, border.range.first),
                      part.parameter(1 - border.axis, border.range.second)};
    }
    m_cells.push_back(part);
    m_zeros.push_back(std::move(found.zeros));
    m_borders.push_back(std::move(found.borders));
  }

  static Range range_in(const Surface_cell_3& cell, int axis, const Undecided_part::Range& local)
  {
    return {cell.parameter(axis, Exact_rational(local.first)), cell.parameter(axis, Exact_rational(local.second))};
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

  // From the unit box into the next cell, with faces numbered from `first` on.
  Surface_face_3 moved(const Surface_cell_3& place, std::size_t first, Surface_face_3 face) const
  {
    face.cell = m_cells.size();
    face.sample = {place.parameter(0, face.sample[0]), place.parameter(1, face.sample[1])};
    for (auto& loop : face.loops)
      for (Surface_face_edge_3& edge : loop) {
        edge.source = {place.parameter(0, edge.source.x()), place.parameter(1, edge.source.y())};
        if (edge.neighbour)
          *edge.neighbour += first;
      }
    return face;
  }

  // The part that the upper border of a cell along an axis has in common with the lower one of another cell, or of the
  // same cell; empty if there is none.
  Range common_border(std::size_t a, std::size_t b, int axis) const
  {
    const std::size_t other = static_cast<std::size_t>(1 - axis);
    const Range &first = m_cells[a].domain[other], &second = m_cells[b].domain[other];
    return {(std::max)(first.first, second.first), (std::min)(first.second, second.second)};
  }

  // Of each cell and those that begin where it ends along an axis; behind the last ones are the first ones, if the axis
  // is closed.
  void add_neighbours(int axis)
  {
    const std::size_t own = static_cast<std::size_t>(axis);
    std::map<Exact_rational, std::vector<std::size_t>> beginning;
    std::optional<Exact_rational> last;
    for (std::size_t cell = 0; cell < m_cells.size(); ++cell) {
      const Range& range = m_cells[cell].domain[own];
      beginning[range.first].push_back(cell);
      if (!last || *last < range.second)
        last = range.second;
    }
    for (std::size_t a = 0; a < m_cells.size(); ++a) {
      const Exact_rational& end = m_cells[a].domain[own].second;
      const bool is_last = m_trimming.is_closed[own] && end == *last;
      const auto next = is_last ? beginning.begin() : beginning.find(end);
      if (next == beginning.end())
        continue;
      for (const std::size_t b : next->second)
        if (const Range common = common_border(a, b, axis); common.first < common.second)
          add_neighbours(a, b, axis);
    }
  }

  std::vector<Surface_border_3> side_of(std::size_t cell, int axis, int side) const
  {
    std::vector<Surface_border_3> result;
    for (const Surface_border_3& border : m_borders[cell])
      if (border.axis == axis && border.side == side)
        result.push_back(border);
    return result;
  }

  // Faces are neighbours across a border if intervals of theirs have a common part. Where points that separate these
  // are not told apart, those on both sides are one if the curves meet the border in the same points.
  void add_neighbours(std::size_t a, std::size_t b, int axis)
  {
    const std::vector<Surface_border_3> before = side_of(a, axis, 1), after = side_of(b, axis, 0);
    if (before.empty() || after.empty())
      return;
    for (const Surface_border_3& first : before)
      for (const Surface_border_3& second : after)
        if ((std::max)(first.range.first, second.range.first) < (std::min)(first.range.second, second.range.second))
          m_neighbours.emplace_back(first.face, second.face);
    if (have_same_zeros_on_border(a, b, axis))
      return;
    for (std::size_t i = 0; i + 1 < before.size(); ++i)
      for (std::size_t j = 0; j + 1 < after.size(); ++j) {
        const Range first(before[i].range.second, before[i + 1].range.first),
            second(after[j].range.second, after[j + 1].range.first);
        if (first.second < second.first || second.second < first.first ||
            (first == second && first.first == first.second))
          continue;
        const Exact_rational value = m_cells[a].domain[static_cast<std::size_t>(axis)].second;
        m_doubtful.push_back({before[i].face, after[j + 1].face, axis, value, first});
        m_doubtful.push_back({before[i + 1].face, after[j].face, axis, value, first});
      }
  }

  // Whether the polynomials of two cells are the same on their common border, but for constant factors.
  bool have_same_zeros_on_border(std::size_t a, std::size_t b, int axis) const
  {
    if (m_trimming.parts)
      return false;
    const Range common = common_border(a, b, axis);
    const auto on_border = [&](std::size_t cell, int side) {
      return product_of(m_zeros[cell])
          .face(axis, side)
          .restricted(0, m_cells[cell].local_parameter(1 - axis, common.first),
                      m_cells[cell].local_parameter(1 - axis, common.second));
    };
    return are_proportional(on_border(a, 1), on_border(b, 0));
  }

  // The regions.
  std::vector<Surface_region_3> united()
  {
    for (std::size_t f = 0; f < m_faces.size(); ++f)
      for (const auto& loop : m_faces[f].loops)
        for (const Surface_face_edge_3& edge : loop)
          if (edge.neighbour)
            m_neighbours.emplace_back(f, *edge.neighbour);
    Disjoint_sets sets(m_faces.size());
    for (const auto& [f, g] : m_neighbours)
      if (m_faces[f].label == m_faces[g].label)
        sets.unite(f, g);
    for (const Doubtful_pair& pair : m_doubtful)
      if (m_faces[pair.first].label == m_faces[pair.second].label && !sets.are_united(pair.first, pair.second)) {
        std::array<Range, 2> box{pair.range, pair.range};
        box[static_cast<std::size_t>(pair.axis)] = {pair.value, pair.value};
        add_undecided(box, "it is not decided whether faces are neighbours");
      }
    std::vector<Surface_region_3> result;
    for (std::vector<std::size_t>& members : sets.sets()) {
      for (const std::size_t f : members)
        m_faces[f].region = result.size();
      result.push_back({m_faces[members.front()].label, std::move(members)});
    }
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_surface_3 trimmed_by_zeros(const Trimming& trimming, Operation_budget& budget,
                                                                  double error)
{
  return Trimmed_cells(trimming, budget, error).trimmed();
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_TRIMMED_BY_ZEROS_H
