// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_JOINED_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_JOINED_PARTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Solved_part.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
Joins the curves of one or several parts. Several ones are pairs of points of one surface: products of cells that cover
all pairs that may be equal, each in one of its orders.

A regular solution on the boundary of a part that is not on an edge of the surface lies on the boundary of other parts
too, and its curve goes on in one of them. All parts that have a place on their boundary know all solutions there, so if
the enclosure of one meets just one in another part, they are the same point. Places are compared in both orders of a
pair, and across seams.
*/
class Joined_parts
{
  const std::vector<Solved_part>& m_parts;
  std::array<std::optional<Exact_rational>, 2> m_periods;
  std::vector<Intersection_curve> m_curves;
  std::vector<Part_vertex> m_points, m_singular_points, m_equal_pairs, m_unmatched;

public:
  // \pre Each part has a system.
  explicit Joined_parts(const std::vector<Solved_part>& parts) : m_parts(parts)
  {
    for (std::size_t k = 0; k < parts.size(); ++k)
      collect(k);
    if (parts.size() > 1) {
      find_periods();
      join_curves();
      remove_repetitions();
    }
  }

  const std::vector<Intersection_curve>& curves() const { return m_curves; }

  // Single points, and singular ones.
  const std::vector<Part_vertex>& points() const { return m_points; }
  const std::vector<Part_vertex>& singular_points() const { return m_singular_points; }

  // Pairs of equal points, where curves end.
  const std::vector<Part_vertex>& equal_pairs() const { return m_equal_pairs; }

  // Where it is not known how a curve goes on.
  const std::vector<Part_vertex>& unmatched() const { return m_unmatched; }

private:
  void collect(std::size_t part)
  {
    const auto& [surfaces, solutions, poles, is_overlap] = m_parts[part];
    const Seam_joints joints(surfaces.system(), solutions, surfaces.closed_unknowns(), poles, surfaces.exchange());
    for (Intersection_curve& curve : joints.curves()) {
      for (Intersection_arc& arc : curve.arcs)
        arc.part = part;
      m_curves.push_back(std::move(curve));
    }
    const auto append = [&](std::vector<Part_vertex>& list, const std::vector<std::size_t>& vertices) {
      for (const std::size_t i : vertices)
        list.push_back({part, i});
    };
    append(m_points, joints.points());
    append(m_singular_points, joints.without_repetitions(solutions.singular_points()));
    append(m_equal_pairs, joints.equal_pairs());
    append(m_unmatched, joints.unmatched());
  }

  void find_periods()
  {
    const Surface_equations& surfaces = m_parts.front().surfaces;
    for (const int axis : {0, 1})
      if (surfaces.is_closed(0, axis)) {
        const auto [begin, end] = surfaces.parameter_domain(0, axis);
        m_periods[axis] = Exact_rational(end - begin);
      }
  }

  void join_curves()
  {
    std::vector<std::pair<Curve_end, std::vector<Parameter_box>>> ends;
    for (std::size_t c = 0; c < m_curves.size(); ++c)
      for (const int side : {0, 1})
        if (const Part_vertex end = end_of(m_curves[c], side); !m_curves[c].is_closed && goes_on(end))
          ends.push_back({{c, side}, images(place(end))});
    const auto may_be_same = [](const std::vector<Parameter_box>& a, const std::vector<Parameter_box>& b) {
      return std::any_of(a.begin(), a.end(), [&](const Parameter_box& image) { return meet(image, b.front()); });
    };
    const Matched_ends matched = matched_ends(ends, m_curves.size(), may_be_same);
    for (const Curve_end& end : matched.unmatched)
      m_unmatched.push_back(end_of(m_curves[end.curve], end.side));
    m_curves = joined_curves(m_curves, matched);
  }

  Part_vertex end_of(const Intersection_curve& curve, int side) const
  {
    const Intersection_arc& arc = side == 0 ? curve.arcs.front() : curve.arcs.back();
    const std::vector<Curve_piece>& pieces = m_parts[arc.part].solutions.curves()[arc.index].pieces;
    return {arc.part, (side == 0) != arc.is_reversed ? pieces.front().ends[0] : pieces.back().ends[1]};
  }

  // Whether a curve that ends there in its part is a part of a longer one.
  bool goes_on(const Part_vertex& end) const
  {
    const Curve_solution_set_d& set = m_parts[end.part].solutions;
    const Curve_vertex& vertex = set.vertices()[end.vertex];
    const auto has_it = [&](const Undecided_region& region) {
      return std::find(region.vertices.begin(), region.vertices.end(), end.vertex) != region.vertices.end();
    };
    return vertex.is_on_boundary && !vertex.is_singular && !vertex.is_on_inequality && !is_on_edge(place(end)) &&
        std::find(m_unmatched.begin(), m_unmatched.end(), end) == m_unmatched.end() &&
        std::none_of(set.undecided_regions().begin(), set.undecided_regions().end(), has_it);
  }

  // A point on the boundary of several parts comes once, and not at all if it is on a curve.
  void remove_repetitions()
  {
    std::vector<Part_vertex> unclear;
    const auto remove = [&](std::vector<Part_vertex>& points, const auto& replaces) {
      const std::vector<Part_vertex> all = std::exchange(points, {});
      for (const Part_vertex& point : all) {
        bool is_replaced = false;
        for (std::size_t part = 0; part < m_parts.size() && !is_replaced; ++part) {
          const std::vector<std::size_t> same =
              part == point.part ? std::vector<std::size_t>{} : found_in(part, place(point));
          if (same.size() > 1 && std::find(unclear.begin(), unclear.end(), point) == unclear.end())
            unclear.push_back(point);
          is_replaced = same.size() > 1 || (same.size() == 1 && replaces(point, Part_vertex{part, same.front()}));
        }
        if (!is_replaced)
          points.push_back(point);
      }
    };
    remove(m_points, [&](const Part_vertex& point, const Part_vertex& other) {
      return is_on_curve(other) || other.part < point.part;
    });
    remove(m_singular_points, [&](const Part_vertex& point, const Part_vertex& other) {
      return other.part < point.part && vertex_of(other).is_singular;
    });
    m_unmatched.insert(m_unmatched.end(), unclear.begin(), unclear.end());
  }

  // The vertices of a part that may be a point, if this lies in the part.
  std::vector<std::size_t> found_in(std::size_t part, const Parameter_box& point) const
  {
    std::vector<std::size_t> result;
    const Constraint_system_d& system = m_parts[part].surfaces.system();
    for (const Parameter_box& image : images(point)) {
      bool is_inside = true;
      for (std::size_t j = 0; j < image.size(); ++j)
        is_inside = is_inside && system.domain(static_cast<int>(j)).first <= image[j].first &&
            image[j].second <= system.domain(static_cast<int>(j)).second;
      for (std::size_t i = 0; is_inside && i < m_parts[part].solutions.vertices().size(); ++i)
        if (meet(image, place({part, i})) && std::find(result.begin(), result.end(), i) == result.end())
          result.push_back(i);
    }
    return result;
  }

  bool is_on_curve(const Part_vertex& point) const
  {
    const std::vector<Solution_curve>& curves = m_parts[point.part].solutions.curves();
    return std::any_of(curves.begin(), curves.end(), [&](const Solution_curve& curve) {
      const std::vector<std::size_t> vertices = curve.vertices();
      return std::find(vertices.begin(), vertices.end(), point.vertex) != vertices.end();
    });
  }

  const Curve_vertex& vertex_of(const Part_vertex& point) const
  {
    return m_parts[point.part].solutions.vertices()[point.vertex];
  }

  // Ranges of the parameters of both points.
  Parameter_box place(const Part_vertex& point) const
  {
    const Curve_vertex::Exact_box& box = vertex_of(point).box;
    return {box.begin(), box.begin() + 4};
  }

  // Whether one of the parameters is at an end, by proof, which is not a seam.
  bool is_on_edge(const Parameter_box& box) const
  {
    for (std::size_t j = 0; j < box.size(); ++j) {
      const int axis = static_cast<int>(j % 2);
      const auto [begin, end] = m_parts.front().surfaces.parameter_domain(0, axis);
      if (!m_periods[axis] && box[j].first == box[j].second && (box[j].first == begin || box[j].first == end))
        return true;
    }
    return false;
  }

  // The same pair in both orders, and with its parameters on both sides of seams; first as it is.
  std::vector<Parameter_box> images(const Parameter_box& box) const
  {
    std::vector<Parameter_box> result{box, {box[2], box[3], box[0], box[1]}};
    for (std::size_t j = 0; j < box.size(); ++j)
      if (const auto& period = m_periods[j % 2])
        for (std::size_t i = 0, size = result.size(); i < size; ++i)
          for (const Exact_rational& shift : {*period, Exact_rational(-*period)}) {
            const Parameter_range range{Exact_rational(result[i][j].first + shift),
                                        Exact_rational(result[i][j].second + shift)},
                domain = m_parts.front().surfaces.parameter_domain(0, static_cast<int>(j % 2));
            if (domain.second < range.first || range.second < domain.first)
              continue;
            result.push_back(result[i]);
            result.back()[j] = range;
          }
    return result;
  }

  static bool meet(const Parameter_box& a, const Parameter_box& b)
  {
    for (std::size_t j = 0; j < a.size(); ++j)
      if (a[j].second < b[j].first || b[j].second < a[j].first)
        return false;
    return true;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Joined_curves joined_curves(const std::vector<Solved_part>& parts)
{
  const Joined_parts joined(parts);
  return {joined.curves(), joined.points(), joined.singular_points(), joined.equal_pairs(), joined.unmatched()};
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_JOINED_PARTS_H
