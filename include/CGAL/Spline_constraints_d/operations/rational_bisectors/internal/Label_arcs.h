// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LABEL_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LABEL_ARCS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Label_tree.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Cell_arrangement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
The arcs of a tree that bound faces, as chains of chords. Their points are between two numbers at which the label is
known; a point on the side of several boxes is found once.
*/
class Label_arcs
{
  using Node = Label_tree::Node;
  using Point = std::array<double, 2>;
  using Range = std::array<double, 2>;

  // On a line where one parameter is constant.
  struct Crossing
  {
    int axis; // of this parameter
    double value;
    Range range; // of the other one
  };

  Label_tree& m_tree;
  double m_error; // of chords
  const Operation_budget& m_budget;
  std::vector<Crossing> m_crossings;
  std::map<std::pair<int, double>, std::vector<std::size_t>> m_on_line;

public:
  // \pre rounding is upwards, here and below
  Label_arcs(Label_tree& tree, double error, const Operation_budget& budget)
    : m_tree(tree), m_error(error), m_budget(budget)
  {}

  // The faces that arcs leave of a box; none if their points are not found.
  std::optional<Surface_regions::Cell_faces> faces(std::size_t block)
  {
    const Label_tree::Box& box = m_tree.node(block).box;
    Surface_regions::Cell_curves curves;
    std::vector<std::array<Surface_regions::Parameters, 2>> samples;
    std::map<std::size_t, std::size_t> vertices; // of crossings
    for (const std::size_t arc : m_tree.arcs(block)) {
      m_budget.check();
      const Node& node = m_tree.node(arc);
      const std::optional<std::array<std::size_t, 2>> ends = ends_of(node);
      const auto beside = ends ? samples_beside(node) : std::nullopt;
      if (!beside)
        return std::nullopt;
      samples.push_back({local(box, (*beside)[0]), local(box, (*beside)[1])});
      Curve_piece piece{{}, 1 - node.axis, {}};
      for (const std::size_t axis : {0, 1})
        piece.box.push_back({local(box, axis, node.box[axis][0]), local(box, axis, node.box[axis][1])});
      for (const std::size_t end : {0, 1}) {
        const auto [known, is_new] = vertices.try_emplace((*ends)[end], curves.vertices.size());
        if (is_new)
          curves.vertices.push_back(vertex(box, m_crossings[(*ends)[end]]));
        piece.ends[end] = known->second;
      }
      auto points = chords(node, *ends, box);
      if (!points)
        return std::nullopt;
      points->front() = curves.vertices[piece.ends[0]].point();
      points->back() = curves.vertices[piece.ends[1]].point();
      curves.pieces.push_back({piece, 0, 0, *points});
    }
    curves.number_of_curves = curves.number_of_polynomials = 1;
    const std::vector<Surface_regions::Cell_polynomial> no_polynomials;
    return Surface_regions::Cell_arrangement(no_polynomials, std::move(curves)).faces(samples);
  }

private:
  static Exact_rational local(const Label_tree::Box& box, std::size_t axis, double value)
  {
    const Exact_rational begin(box[axis][0]), end(box[axis][1]);
    return Exact_rational((Exact_rational(value) - begin) / Exact_rational(end - begin));
  }

  static Surface_regions::Parameters local(const Label_tree::Box& box, const Point& point)
  {
    return {local(box, 0, point[0]), local(box, 1, point[1])};
  }

  static Curve_vertex vertex(const Label_tree::Box& box, const Crossing& crossing)
  {
    Curve_vertex result{Curve_vertex::Exact_box(2), false, false, false};
    const std::size_t axis = static_cast<std::size_t>(crossing.axis);
    const Exact_rational value = local(box, axis, crossing.value);
    result.box[axis] = {value, value};
    result.box[1 - axis] = {local(box, 1 - axis, crossing.range[0]), local(box, 1 - axis, crossing.range[1])};
    result.is_on_boundary = value == 0 || value == 1;
    return result;
  }

  // Where the sign changes on a line, between numbers with different signs.
  std::optional<Range> crossing(const Node& node, int axis, double value, Range range, std::array<double, 2> powers)
  {
    constexpr double width = 0x1p-36, widest = 0x1p-26;
    constexpr int most_steps = 100;
    const auto power = [&](double t) {
      return m_tree.least_power(node, axis == 0 ? Point{value, t} : Point{t, value});
    };
    int last = -1;
    for (int step = 0; step < most_steps && range[1] - range[0] > width; ++step) {
      // by the rule of false position with halved values, or in the middle
      double t = range[0] + (range[1] - range[0]) * (powers[0] / (powers[0] - powers[1]));
      const double middle = 0.5 * (range[0] + range[1]), slack = 0.25 * width;
      if (!(t > range[0] && t < range[1]) || step % 4 == 3)
        t = middle;
      else
        t += t < middle ? slack : -slack;
      const auto [sign, found] = power(t);
      if (sign == 0)
        break;
      const int side = (sign > 0) == (powers[0] > 0) ? 0 : 1;
      if (last == side)
        powers[static_cast<std::size_t>(1 - side)] *= 0.5;
      last = side;
      range[static_cast<std::size_t>(side)] = t;
      powers[static_cast<std::size_t>(side)] = sign * (std::max)(std::abs(found), 1e-300);
    }
    return range[1] - range[0] <= widest ? std::optional(range) : std::nullopt;
  }

  std::optional<std::size_t> crossing_on_side(const Node& node, int axis, int side, const std::array<int, 2>& signs)
  {
    const double value = node.box[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)];
    const Range& range = node.box[static_cast<std::size_t>(1 - axis)];
    std::vector<std::size_t>& known = m_on_line[{axis, value}];
    for (const std::size_t k : known)
      if (range[0] < m_crossings[k].range[0] && m_crossings[k].range[1] < range[1])
        return k;
    const auto found =
        crossing(node, axis, value, range, {static_cast<double>(signs[0]), static_cast<double>(signs[1])});
    if (!found)
      return std::nullopt;
    m_crossings.push_back({axis, value, *found});
    known.push_back(m_crossings.size() - 1);
    return known.back();
  }

  Point point_of(const Crossing& crossing) const
  {
    const double other = 0.5 * (crossing.range[0] + crossing.range[1]);
    return crossing.axis == 0 ? Point{crossing.value, other} : Point{other, crossing.value};
  }

  // In the order of the parameter that the arc is a graph over.
  std::optional<std::array<std::size_t, 2>> ends_of(const Node& node)
  {
    std::vector<std::size_t> result;
    for (const int axis : {0, 1})
      for (const int side : {0, 1}) {
        const auto sign = [&](int other) {
          return node.corners[static_cast<std::size_t>(axis == 0 ? 2 * side + other : 2 * other + side)];
        };
        if (sign(0) == sign(1))
          continue;
        const std::optional<std::size_t> found = crossing_on_side(node, axis, side, {sign(0), sign(1)});
        if (!found)
          return std::nullopt;
        result.push_back(*found);
      }
    const auto parameter = [&](std::size_t k) {
      return point_of(m_crossings[k])[static_cast<std::size_t>(1 - node.axis)];
    };
    if (result.size() != 2 || parameter(result[0]) == parameter(result[1]))
      return std::nullopt;
    if (parameter(result[1]) < parameter(result[0]))
      std::swap(result[0], result[1]);
    return std::array<std::size_t, 2>{result[0], result[1]};
  }

  // To the left and to the right of the arc.
  std::optional<std::array<Point, 2>> samples_beside(const Node& node)
  {
    std::array<std::optional<Point>, 2> result;
    const int sign_on_left = node.axis == 0 ? -node.trend : node.trend;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::optional<Point>& sample = result[node.corners[corner] == sign_on_left ? 0 : 1];
      for (double step = 0.25; !sample && step > 0x1p-30; step *= 0.25) {
        Point p;
        for (const std::size_t axis : {0, 1}) {
          const Range& range = node.box[axis];
          const bool is_upper = axis == 0 ? corner >= 2 : corner % 2 == 1;
          const double inward = step * (range[1] - range[0]);
          p[axis] = is_upper ? range[1] - inward : range[0] + inward;
        }
        if (m_tree.least_power(node, p).first == node.corners[corner])
          sample = p;
      }
    }
    if (!result[0] || !result[1])
      return std::nullopt;
    return std::array<Point, 2>{*result[0], *result[1]};
  }

  // The points of an arc, in parameters of a box.
  std::optional<std::vector<std::vector<double>>> chords(const Node& node, const std::array<std::size_t, 2>& ends,
                                                         const Label_tree::Box& box)
  {
    std::vector<Point> points{point_of(m_crossings[ends[0]])};
    if (!add_points(points, node, Point(points[0]), point_of(m_crossings[ends[1]]), box, 0))
      return std::nullopt;
    std::vector<std::vector<double>> result;
    for (const Point& p : points)
      result.push_back({to_nearest_double(local(box, 0, p[0])), to_nearest_double(local(box, 1, p[1]))});
    return result;
  }

  // Those behind the first one, up to the last one.
  bool add_points(std::vector<Point>& result, const Node& node, const Point& first, const Point& last,
                  const Label_tree::Box& box, int depth)
  {
    constexpr int most_depth = 6;
    if (depth < most_depth) {
      const std::optional<Point> middle = point_between(node, first, last);
      if (!middle)
        return false;
      double distance = 0;
      for (const std::size_t axis : {0, 1})
        distance = (std::max)(
            distance, std::abs((*middle)[axis] - 0.5 * (first[axis] + last[axis])) / (box[axis][1] - box[axis][0]));
      if (distance > m_error)
        return add_points(result, node, first, *middle, box, depth + 1) &&
            add_points(result, node, *middle, last, box, depth + 1);
    }
    result.push_back(last);
    return true;
  }

  // On the arc, where the parameter is in the middle of those of two other points.
  std::optional<Point> point_between(const Node& node, const Point& first, const Point& last)
  {
    const std::size_t axis = static_cast<std::size_t>(node.axis);
    Point result;
    for (const std::size_t a : {0, 1})
      result[a] = 0.5 * (first[a] + last[a]);
    const Range& all = node.box[axis];
    const double guess = result[axis];
    for (double width = 0x1p-6 * (all[1] - all[0]);; width *= 8) {
      const Range range{(std::max)(all[0], guess - width), (std::min)(all[1], guess + width)};
      std::array<double, 2> powers;
      for (const std::size_t end : {0, 1}) {
        Point p(result);
        p[axis] = range[end];
        const auto [sign, power] = m_tree.least_power(node, p);
        powers[end] = sign * std::abs(power);
      }
      if ((powers[0] < 0 && powers[1] > 0) || (powers[0] > 0 && powers[1] < 0)) {
        const auto found = crossing(node, 1 - node.axis, result[1 - axis], range, powers);
        if (!found)
          return std::nullopt;
        result[axis] = 0.5 * ((*found)[0] + (*found)[1]);
        return result;
      }
      if (range == all)
        return std::nullopt;
    }
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LABEL_ARCS_H
