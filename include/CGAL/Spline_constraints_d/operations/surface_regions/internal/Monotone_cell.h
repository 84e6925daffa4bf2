// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_MONOTONE_CELL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_MONOTONE_CELL_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_bundle.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// What is known of a label with two values, a function of two parameters, on a rectangle.
struct Box_answer
{
  std::optional<bool> label;             // the same everywhere
  Direction_set directions;              // along which it may only change from false to true
  std::optional<Fold_at_edge> fold = {}; // along which it is false, true, and false again
};

/*
The faces of a rectangle in which a level only increases along a direction d.

Lines along d enter the rectangle through one part of its boundary and leave it through the other one. For each
number k, a line leads back from each point below k through such points to the boundary, and on from each other one. So
if the boundary passes k twice, there is one face below and one above; if it does not, there is one. What separates two
faces is a graph over the lines, since the same holds for directions near d.

Levels are the values of a label, false and true; or, of a fold before an edge, the numbers 0, 1 and 2 of what is
false, true, and false behind the silhouette. On the edge there is nothing between 0 and 2, and elsewhere there is: so
between two arcs there is one face, too, and along a segment off the edge the label tells when the level changes.
*/
class Monotone_cell
{
public:
  using Place = std::array<double, 2>;
  using Oracle = std::function<Box_answer(const Parameter_rectangle&)>;
  // On which side of the silhouettes a point or a segment is; 0 if it is on none.
  using Side_oracle = std::function<int(const Parameter_rectangle&)>;

private:
  // A change between two points next to each other, in the order along the boundary.
  struct Change
  {
    Place before, after;
    std::size_t side;
    int level_before, level_after;

    Place middle() const { return {0.5 * (before[0] + after[0]), 0.5 * (before[1] + after[1])}; }
    bool passes(int level) const { return (level_before < level) != (level_after < level); }
  };

  // What separates the points below a level, with the changes at its ends.
  struct Border_arc
  {
    std::array<std::size_t, 2> ends;
    std::vector<Place> points;
  };

  static constexpr std::size_t most_corners = 1000;

  const Oracle& m_oracle;
  Parameter_rectangle m_box;
  Direction_set m_directions;
  double m_error;
  const Side_oracle* m_side_oracle = nullptr;
  std::optional<Fold_at_edge> m_fold;
  std::array<int, 4> m_levels{};                     // at the corners, counterclockwise
  std::vector<Change> m_changes;                     // counterclockwise
  std::array<std::optional<Place>, 3> m_samples;     // of the levels
  std::array<std::optional<std::size_t>, 3> m_faces; // of the levels
  std::array<Border_arc, 3> m_arcs{};                // below the levels

public:
  Monotone_cell(const Oracle& oracle, const Parameter_rectangle& box, const Direction_set& directions, double error)
    : m_oracle(oracle), m_box(box), m_directions(directions), m_error(error)
  {}

  Monotone_cell(const Oracle& oracle, const Side_oracle& side_oracle, const Parameter_rectangle& box,
                const Fold_at_edge& fold, double error)
    : m_oracle(oracle), m_box(box), m_directions(fold.directions), m_error(error), m_side_oracle(&side_oracle),
      m_fold(fold)
  {}

  // Nothing if the level on the boundary is not known, or changes more often. Labels are 0 and 1.
  std::optional<Cell_faces> faces()
  {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::optional<int> level = level_at(corner(i));
      if (!level)
        return std::nullopt;
      m_levels[i] = *level;
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (!add_changes(i, corner(i), corner(i + 1), m_levels[i], m_levels[(i + 1) % 4], 7))
        return std::nullopt;
    if (m_changes.empty())
      return whole(m_box, m_levels[0] == 1);
    return faces_between_arcs();
  }

  // One face.
  static Cell_faces whole(const Parameter_rectangle& box, bool label)
  {
    Cell_faces result;
    Surface_face_3 face{0, {Exact_rational(1) / 2, Exact_rational(1) / 2}, {{}}, label ? 1 : 0};
    for (std::size_t i = 0; i < 4; ++i)
      face.loops[0].push_back({point(box, corner(box, i)), std::nullopt});
    result.faces.push_back(face);
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        result.borders.push_back({0, axis, side, {Exact_rational(0), Exact_rational(1)}});
    return result;
  }

private:
  static Place corner(const Parameter_rectangle& box, std::size_t i)
  {
    i %= 4;
    return {i == 1 || i == 2 ? box[0].second : box[0].first, i >= 2 ? box[1].second : box[1].first};
  }
  Place corner(std::size_t i) const { return corner(m_box, i); }

  std::optional<int> level_at(const Place& p) const
  {
    const Parameter_rectangle point{{{p[0], p[0]}, {p[1], p[1]}}};
    const int side = m_fold ? (*m_side_oracle)(point) : 0;
    if (m_fold && side == 0)
      return std::nullopt;
    if (m_fold && side == m_fold->side_behind)
      return 2;
    const std::optional<bool> label = m_oracle(point).label;
    return label ? std::optional(*label ? 1 : 0) : std::nullopt;
  }

  bool is_on_edge(std::size_t side) const
  {
    return m_fold && m_fold->edge && m_fold->edge->first == (side % 2 == 0 ? 1u : 0u) &&
        m_fold->edge->second == (side == 1 || side == 2 ? 1u : 0u);
  }

  // The changes on a part of a side between two points with known levels.
  bool add_changes(std::size_t side, const Place& from, const Place& to, int level, int level_at_end, int depth)
  {
    const std::size_t axis = side % 2 == 0 ? 0 : 1;
    const auto is_monotone = [&](const Direction_set& directions) {
      return directions.contains_axis(axis, true) || directions.contains_axis(axis, false);
    };
    bool is_settled = is_monotone(m_directions);
    if (!is_settled) {
      const Parameter_rectangle segment{std::minmax(from[0], to[0]), std::minmax(from[1], to[1])};
      const int side_of_segment = m_fold ? (*m_side_oracle)(segment) : 0;
      if (m_fold && side_of_segment == m_fold->side_behind)
        return true;
      const Box_answer answer = m_oracle(segment);
      const bool is_told_by_label = !is_on_edge(side) || side_of_segment != 0;
      if (answer.label && (is_told_by_label || *answer.label))
        return true;
      is_settled = (is_told_by_label && is_monotone(answer.directions)) ||
          (m_fold && answer.fold && is_monotone(answer.fold->directions));
    }
    if (is_settled)
      return level == level_at_end || add_located({from, to, side, level, level_at_end});
    const Place middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
    const std::optional<int> level_between = depth > 0 ? level_at(middle) : std::nullopt;
    return level_between && add_changes(side, from, middle, level, *level_between, depth - 1) &&
        add_changes(side, middle, to, *level_between, level_at_end, depth - 1) && m_changes.size() <= 4;
  }

  // The changes between two points of a side between which the level increases, or decreases.
  bool add_located(Change change)
  {
    change = located(change, 0x1p-24);
    if (const std::optional<int> between = level_in(change)) {
      const Place middle = change.middle();
      return add_located({change.before, middle, change.side, change.level_before, *between}) &&
          add_located({middle, change.after, change.side, *between, change.level_after});
    }
    if (std::abs(change.level_after - change.level_before) > 1 && !is_on_edge(change.side))
      return false;
    m_changes.push_back(change);
    return true;
  }

  // In the middle, if it is another one than at both ends.
  std::optional<int> level_in(const Change& change) const
  {
    const Place middle = change.middle();
    if (std::abs(change.level_after - change.level_before) < 2 || middle == change.before || middle == change.after)
      return std::nullopt;
    const std::optional<int> result = level_at(middle);
    return result && *result != change.level_before && *result != change.level_after ? result : std::nullopt;
  }

  // Between points that are nearer, or around a point with a level in between.
  Change located(Change change, double width) const
  {
    while (std::hypot(change.after[0] - change.before[0], change.after[1] - change.before[1]) > width) {
      const Place middle = change.middle();
      const std::optional<int> level =
          middle == change.before || middle == change.after ? std::nullopt : level_at(middle);
      if (level == change.level_after)
        change.after = middle;
      else if (level == change.level_before)
        change.before = middle;
      else
        break;
    }
    return change;
  }

  // The two changes past a level, as numbers; nothing if there are others.
  std::optional<std::array<std::size_t, 2>> changes_past(int level) const
  {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < m_changes.size(); ++i)
      if (m_changes[i].passes(level))
        found.push_back(i);
    return found.size() == 2 ? std::optional(std::array<std::size_t, 2>{found[0], found[1]}) : std::nullopt;
  }

  std::optional<Cell_faces> faces_between_arcs()
  {
    for (const int level : {1, 2}) {
      if (std::ranges::none_of(m_changes, [&](const Change& c) { return c.passes(level); }))
        continue;
      const auto ends = changes_past(level);
      if (!ends)
        return std::nullopt;
      const Place from = m_changes[ends->front()].middle(), to = m_changes[ends->back()].middle();
      Border_arc& arc = m_arcs[static_cast<std::size_t>(level)];
      arc = {*ends, {from}};
      refine(level, arc.points, from, to, 7);
    }
    Cell_faces result;
    for (const int level : {0, 1, 2}) {
      const std::size_t k = static_cast<std::size_t>(level);
      if (std::ranges::none_of(m_changes, [&](const Change& c) { return c.level_after == level; }))
        continue;
      if (!find_sample(level))
        return std::nullopt;
      m_faces[k] = result.faces.size();
      result.faces.push_back({0, exact(*m_samples[k]), {}, level == 1 ? 1 : 0});
    }
    for (const int level : {0, 1, 2})
      if (const std::optional<std::size_t> face = m_faces[static_cast<std::size_t>(level)]) {
        const auto loop = loop_of(level);
        if (!loop)
          return std::nullopt;
        result.faces[*face].loops.push_back(*loop);
      }
    for (std::size_t side = 0; side < 4; ++side)
      add_borders(result, side);
    return result;
  }

  bool is_inside(const Place& p) const
  {
    return m_box[0].first < p[0] && p[0] < m_box[0].second && m_box[1].first < p[1] && p[1] < m_box[1].second;
  }

  // Points of the arc between two ones, the last one with them: where lines along d through middles of chords meet it.
  void refine(int level, std::vector<Place>& arc, const Place& from, const Place& to, int depth)
  {
    const Place middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
    const std::optional<Change> change =
        depth > 0 ? change_through(level, middle, std::hypot(to[0] - from[0], to[1] - from[1])) : std::nullopt;
    if (change) {
      const Place between = change->middle();
      if (depth == 7 || std::hypot(between[0] - middle[0], between[1] - middle[1]) > 0.25 * m_error) {
        refine(level, arc, from, between, depth - 1);
        refine(level, arc, between, to, depth - 1);
        return;
      }
    }
    arc.push_back(to);
  }

  // How far to go from a point along a vector, or back, without leaving the rectangle.
  double length_inside(const Place& place, const Place& d, int sign) const
  {
    double result = 1;
    for (const std::size_t axis : {0, 1})
      if (d[axis] != 0) {
        const double end = d[axis] * sign > 0 ? m_box[axis].second : m_box[axis].first;
        result = (std::min)(result, std::abs((end - place[axis]) / d[axis]));
      }
    return result * (1 - 0x1p-10);
  }

  // Along d, from below a level to it, in the rectangle.
  std::optional<Change> change_through(int level, const Place& place, double size)
  {
    const std::array<double, 2> unit = Direction_set::direction(m_directions.middle());
    const Place d{unit[0] * (m_box[0].second - m_box[0].first), unit[1] * (m_box[1].second - m_box[1].first)};
    const double scale = 0.125 * size / std::hypot(d[0], d[1]);
    const std::optional<int> here = level_at(place);
    if (!here || !is_inside(place))
      return std::nullopt;
    const bool is_above = *here >= level;
    Place last = place;
    int last_level = *here;
    const double end = length_inside(place, d, is_above ? -1 : 1);
    for (double length = (std::min)(scale, end);; length = (std::min)(2 * length, end)) {
      const double step = is_above ? -length : length;
      const Place next{place[0] + step * d[0], place[1] + step * d[1]};
      const std::optional<int> found = is_inside(next) && next != last ? level_at(next) : std::nullopt;
      if (!found)
        return std::nullopt;
      if ((*found >= level) != is_above) {
        const Change change =
            is_above ? Change{next, last, 0, *found, last_level} : Change{last, next, 0, last_level, *found};
        keep_sample(change.before, change.level_before);
        keep_sample(change.after, change.level_after);
        return located_past(level, change, 0x1p-18);
      }
      last = next;
      last_level = *found;
    }
  }

  // Between points that are nearer, on both sides of a level.
  Change located_past(int level, Change change, double width) const
  {
    while (std::hypot(change.after[0] - change.before[0], change.after[1] - change.before[1]) > width) {
      const Place middle = change.middle();
      const std::optional<int> found =
          middle == change.before || middle == change.after ? std::nullopt : level_at(middle);
      if (!found)
        break;
      ((*found < level) == (change.level_before < level) ? change.before : change.after) = middle;
    }
    return change;
  }

  void keep_sample(const Place& place, int level)
  {
    std::optional<Place>& sample = m_samples[static_cast<std::size_t>(level)];
    if (!sample)
      sample = place;
  }

  // A point of a face: if none is known, beside the changes on the boundary and between them, towards the middle.
  bool find_sample(int level)
  {
    const std::optional<Place>& sample = m_samples[static_cast<std::size_t>(level)];
    const Place middle{middle_of(m_box[0]), middle_of(m_box[1])};
    for (std::size_t i = 0; i < m_changes.size(); ++i) {
      const Change &change = m_changes[i], &next = m_changes[(i + 1) % m_changes.size()];
      const Place between{0.5 * (change.after[0] + next.before[0]), 0.5 * (change.after[1] + next.before[1])};
      for (const Place& place : {change.before, change.after, corner(change.side), corner(change.side + 1), between})
        for (double t = 0.25; t > 0x1p-20 && !sample; t *= 0.25) {
          const Place p{place[0] + t * (middle[0] - place[0]), place[1] + t * (middle[1] - place[1])};
          if (const std::optional<int> found = level_at(p))
            keep_sample(p, *found);
        }
    }
    return sample.has_value();
  }

  // Along the boundary from a change to this level to the next one, back along the arc that begins there, and on. All
  // of the boundary with this level must come to be in it, and arcs must not cross.
  std::optional<std::vector<Surface_face_edge_3>> loop_of(int level) const
  {
    const auto is_begin = [&](const Change& c) { return c.level_after == level; };
    const auto number = static_cast<std::size_t>(std::ranges::count_if(m_changes, is_begin));
    const auto start = static_cast<std::size_t>(std::ranges::find_if(m_changes, is_begin) - m_changes.begin());
    std::vector<Surface_face_edge_3> result;
    std::size_t at = start, used = 0;
    do {
      if (is_begin(m_changes[at])) {
        add_boundary(result, at);
        at = (at + 1) % m_changes.size();
        ++used;
      }
      const bool is_upwards = m_changes[at].level_after > level;
      const Border_arc& arc = m_arcs[static_cast<std::size_t>(is_upwards ? level + 1 : level)];
      const std::optional<std::size_t> beyond = m_faces[static_cast<std::size_t>(is_upwards ? level + 1 : level - 1)];
      if (!beyond || (at != arc.ends[0] && at != arc.ends[1]) || result.size() > most_corners)
        return std::nullopt;
      std::vector<Place> points(arc.points);
      if (at != arc.ends[0])
        std::ranges::reverse(points);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        result.push_back({point(m_box, points[i]), beyond});
      at = at == arc.ends[0] ? arc.ends[1] : arc.ends[0];
    } while (at != start);
    return used == number && (!m_fold || is_simple(result)) ? std::optional(result) : std::nullopt;
  }

  void add_boundary(std::vector<Surface_face_edge_3>& loop, std::size_t begin) const
  {
    const Change &first = m_changes[begin], &last = m_changes[(begin + 1) % m_changes.size()];
    loop.push_back({point(m_box, first.middle()), std::nullopt});
    const std::size_t turns = last.side + (begin + 1 < m_changes.size() ? 0 : 4);
    for (std::size_t i = first.side; i < turns; ++i)
      loop.push_back({point(m_box, corner(i + 1)), std::nullopt});
  }

  static bool is_simple(const std::vector<Surface_face_edge_3>& loop)
  {
    std::vector<CGAL::Simple_cartesian<Exact_rational>::Point_2> points;
    for (const Surface_face_edge_3& edge : loop)
      points.push_back(edge.source);
    return CGAL::is_simple_2(points.begin(), points.end(), CGAL::Simple_cartesian<Exact_rational>());
  }

  void add_borders(Cell_faces& result, std::size_t side) const
  {
    const std::size_t axis = side % 2 == 0 ? 0 : 1; // along the side
    std::vector<std::pair<Surface_cell_3::Range, int>> intervals;
    Place begin = corner(side);
    int level = m_levels[side];
    const auto add = [&](const Place& end) {
      const Exact_rational a = local(m_box, begin, axis), b = local(m_box, end, axis);
      if (a != b)
        intervals.push_back({a < b ? Surface_cell_3::Range(a, b) : Surface_cell_3::Range(b, a), level});
    };
    for (const Change& change : m_changes)
      if (change.side == side) {
        add(change.before);
        begin = change.after;
        level = change.level_after;
      }
    add(corner(side + 1));
    if (side >= 2)
      std::ranges::reverse(intervals);
    const int across = static_cast<int>(1 - axis), at = side == 1 || side == 2 ? 1 : 0;
    for (const auto& [range, own] : intervals)
      result.borders.push_back({*m_faces[static_cast<std::size_t>(own)], across, at, range});
  }

  static Exact_rational local(const Parameter_rectangle& box, const Place& p, std::size_t axis)
  {
    const Exact_rational begin(box[axis].first), end(box[axis].second);
    return Exact_rational((Exact_rational(p[axis]) - begin) / (end - begin));
  }

  std::array<Exact_rational, 2> exact(const Place& p) const { return {local(m_box, p, 0), local(m_box, p, 1)}; }

  static CGAL::Simple_cartesian<Exact_rational>::Point_2 point(const Parameter_rectangle& box, const Place& p)
  {
    return {local(box, p, 0), local(box, p, 1)};
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_MONOTONE_CELL_H
