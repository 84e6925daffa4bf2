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
  std::optional<bool> label; // the same everywhere
  Direction_set directions;  // along which it may only change from false to true
};

/*
The faces of a rectangle in which a label only changes from false to true along a direction d.

Lines along d enter the rectangle through one part of its boundary and leave it through the other one. From each point
that is false a line leads back through points that are false to the boundary, from each one that is true it leads on to
the boundary. So if the label changes on the boundary twice, there is one face of either kind; if it does not change,
there is one face. What separates two faces is a graph over the lines, since the same holds for directions near d.
*/
class Monotone_cell
{
public:
  using Oracle = std::function<Box_answer(const Parameter_rectangle&)>;

private:
  using Place = std::array<double, 2>;

  // A change between two points next to each other, in the order along the boundary.
  struct Change
  {
    Place before, after;
    std::size_t side;
    bool label_after;

    Place middle() const { return {0.5 * (before[0] + after[0]), 0.5 * (before[1] + after[1])}; }
  };

  const Oracle& m_oracle;
  Parameter_rectangle m_box;
  Direction_set m_directions;
  double m_error;
  std::array<bool, 4> m_labels{}; // at the corners, counterclockwise
  std::vector<Change> m_changes;  // counterclockwise
  std::array<std::optional<Place>, 2> m_samples;

public:
  Monotone_cell(const Oracle& oracle, const Parameter_rectangle& box, const Direction_set& directions, double error)
    : m_oracle(oracle), m_box(box), m_directions(directions), m_error(error)
  {}

  // Nothing if the label on the boundary is not known, or changes more often.
  std::optional<Cell_faces> faces()
  {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::optional<bool> label = label_at(corner(i));
      if (!label)
        return std::nullopt;
      m_labels[i] = *label;
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (!add_changes(i, corner(i), corner(i + 1), m_labels[i], m_labels[(i + 1) % 4], 7))
        return std::nullopt;
    if (m_changes.empty())
      return whole(m_box, m_labels[0]);
    if (m_changes.size() != 2)
      return std::nullopt;
    return two_faces();
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

  std::optional<bool> label_at(const Place& p) const { return m_oracle({{{p[0], p[0]}, {p[1], p[1]}}}).label; }

  // The changes on a part of a side between two points with known labels.
  bool add_changes(std::size_t side, const Place& from, const Place& to, bool label, bool label_at_end, int depth)
  {
    const std::size_t axis = side % 2 == 0 ? 0 : 1;
    const auto is_monotone = [&](const Direction_set& directions) {
      return directions.contains_axis(axis, true) || directions.contains_axis(axis, false);
    };
    bool is_settled = is_monotone(m_directions);
    if (!is_settled) {
      const Box_answer answer = m_oracle({{std::minmax(from[0], to[0]), std::minmax(from[1], to[1])}});
      if (answer.label)
        return true;
      is_settled = is_monotone(answer.directions);
    }
    if (is_settled) {
      if (label != label_at_end)
        m_changes.push_back(located({from, to, side, label_at_end}, 0x1p-24));
      return true;
    }
    const Place middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
    const std::optional<bool> label_between = depth > 0 ? label_at(middle) : std::nullopt;
    return label_between && add_changes(side, from, middle, label, *label_between, depth - 1) &&
        add_changes(side, middle, to, *label_between, label_at_end, depth - 1) && m_changes.size() <= 2;
  }

  // Between points that are nearer.
  Change located(Change change, double width) const
  {
    while (std::hypot(change.after[0] - change.before[0], change.after[1] - change.before[1]) > width) {
      const Place middle = change.middle();
      const std::optional<bool> label =
          middle == change.before || middle == change.after ? std::nullopt : label_at(middle);
      if (!label)
        break;
      (*label == change.label_after ? change.after : change.before) = middle;
    }
    return change;
  }

  std::optional<Cell_faces> two_faces()
  {
    std::vector<Place> arc{m_changes[0].middle()};
    refine(arc, m_changes[0].middle(), m_changes[1].middle(), 7);
    if (!has_samples())
      return std::nullopt;
    Cell_faces result;
    for (const bool label : {false, true})
      result.faces.push_back({0, exact(*m_samples[label]), {loop_of(label, arc)}, label ? 1 : 0});
    for (std::size_t side = 0; side < 4; ++side)
      add_borders(result, side);
    return result;
  }

  bool is_inside(const Place& p) const
  {
    return m_box[0].first < p[0] && p[0] < m_box[0].second && m_box[1].first < p[1] && p[1] < m_box[1].second;
  }

  // Points of the arc between two ones, the last one with them: where lines along d through middles of chords meet it.
  void refine(std::vector<Place>& arc, const Place& from, const Place& to, int depth)
  {
    const Place middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
    const std::optional<Change> change =
        depth > 0 ? change_through(middle, std::hypot(to[0] - from[0], to[1] - from[1])) : std::nullopt;
    if (change) {
      const Place between = change->middle();
      if (depth == 7 || std::hypot(between[0] - middle[0], between[1] - middle[1]) > 0.25 * m_error) {
        refine(arc, from, between, depth - 1);
        refine(arc, between, to, depth - 1);
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

  // Along d, from false to true, in the rectangle.
  std::optional<Change> change_through(const Place& place, double size)
  {
    const std::array<double, 2> unit = Direction_set::direction(m_directions.middle());
    const Place d{unit[0] * (m_box[0].second - m_box[0].first), unit[1] * (m_box[1].second - m_box[1].first)};
    const double scale = 0.125 * size / std::hypot(d[0], d[1]);
    const std::optional<bool> here = label_at(place);
    if (!here || !is_inside(place))
      return std::nullopt;
    Place last = place;
    const double end = length_inside(place, d, *here ? -1 : 1);
    for (double length = (std::min)(scale, end);; length = (std::min)(2 * length, end)) {
      const double step = *here ? -length : length;
      const Place next{place[0] + step * d[0], place[1] + step * d[1]};
      const std::optional<bool> label = is_inside(next) && next != last ? label_at(next) : std::nullopt;
      if (!label)
        return std::nullopt;
      if (*label != *here) {
        Change change = *here ? Change{next, last, 0, true} : Change{last, next, 0, true};
        m_samples[0] = m_samples[0] ? m_samples[0] : change.before;
        m_samples[1] = m_samples[1] ? m_samples[1] : change.after;
        return located(change, 0x1p-18);
      }
      last = next;
    }
  }

  // Points of both faces: if none are known, beside the changes on the boundary, towards the middle.
  bool has_samples()
  {
    const Place middle{middle_of(m_box[0]), middle_of(m_box[1])};
    for (const Change& change : m_changes)
      for (const Place& place : {change.before, change.after, corner(change.side), corner(change.side + 1)})
        for (double t = 0.25; t > 0x1p-20 && !(m_samples[0] && m_samples[1]); t *= 0.25) {
          const Place p{place[0] + t * (middle[0] - place[0]), place[1] + t * (middle[1] - place[1])};
          const std::optional<bool> label = label_at(p);
          if (label && !m_samples[*label])
            m_samples[*label] = p;
        }
    return m_samples[0] && m_samples[1];
  }

  std::vector<Surface_face_edge_3> loop_of(bool label, const std::vector<Place>& arc) const
  {
    // The boundary has this label behind the change to it.
    const std::size_t begin = m_changes[0].label_after == label ? 0 : 1;
    const Change &first = m_changes[begin], &last = m_changes[1 - begin];
    std::vector<Surface_face_edge_3> result{{point(m_box, first.middle()), std::nullopt}};
    const std::size_t turns = last.side + (begin == 0 ? 0 : 4);
    for (std::size_t i = first.side; i < turns; ++i)
      result.push_back({point(m_box, corner(i + 1)), std::nullopt});
    std::vector<Place> back(arc);
    if (begin == 0)
      std::ranges::reverse(back);
    for (std::size_t i = 0; i + 1 < back.size(); ++i)
      result.push_back({point(m_box, back[i]), std::size_t(label ? 0 : 1)});
    return result;
  }

  void add_borders(Cell_faces& result, std::size_t side) const
  {
    const std::size_t axis = side % 2 == 0 ? 0 : 1; // along the side
    std::vector<std::pair<Surface_cell_3::Range, bool>> intervals;
    Place begin = corner(side);
    bool label = m_labels[side];
    const auto add = [&](const Place& end) {
      const Exact_rational a = local(m_box, begin, axis), b = local(m_box, end, axis);
      if (a != b)
        intervals.push_back({a < b ? Surface_cell_3::Range(a, b) : Surface_cell_3::Range(b, a), label});
    };
    for (const Change& change : m_changes)
      if (change.side == side) {
        add(change.before);
        begin = change.after;
        label = change.label_after;
      }
    add(corner(side + 1));
    if (side >= 2)
      std::ranges::reverse(intervals);
    const int across = static_cast<int>(1 - axis), at = side == 1 || side == 2 ? 1 : 0;
    for (const auto& [range, own] : intervals)
      result.borders.push_back({own ? std::size_t(1) : std::size_t(0), across, at, range});
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
