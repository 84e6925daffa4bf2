// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_LOCUS_COLLECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_LOCUS_COLLECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/hull_of_region.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Found_pair_locus.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_cuts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

struct Pair_locus_part
{
  Pair_of_parts parts;
  Constraint_system_d system;
  Curve_solution_set_d solutions;
};

// The part and the vertex where a curve that is not closed begins or ends.
inline std::pair<std::size_t, const Curve_vertex*> vertex_at_end(const Found_pair_locus& found,
                                                                 const Curve_pair_curve& curve, int side)
{
  const Curve_pair_arc& arc = side == 0 ? curve.arcs.front() : curve.arcs.back();
  const Curve_solution_set_d& set = (*found.parts)[arc.part].solutions;
  const std::vector<Curve_piece>& pieces = set.curves()[arc.index].pieces;
  return {arc.part, &set.vertices()[(side == 0) != arc.is_reversed ? pieces.front().ends[0] : pieces.back().ends[1]]};
}

// Joins the curves of parts, one after the other.
class Pair_locus_collector
{
  Found_pair_locus m_found;
  std::vector<Vertex_of_part> m_point_vertices, m_singular_vertices; // those of the points that are found

public:
  explicit Pair_locus_collector(Point_of_pair point, const std::array<std::size_t, 2>& operands = {0, 1})
    : m_found{std::move(point), operands, std::make_shared<std::vector<Pair_locus_part>>()}
  {}

  const Found_pair_locus& found() const { return m_found; }

  // The solutions of an equation for two parts, cut where the point is at infinity.
  void add(const Pair_of_parts& parts, const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns,
           Operation_budget& budget, const std::vector<Solution_d<double>>& points_at_infinity = {})
  {
    std::vector<Curve_vertex::Exact_box> poles, rest;
    for (const Solution_d<double>& point : points_at_infinity)
      (point.is_certified() ? poles : rest).push_back(point.exact_box());
    const std::size_t multiple = rest.size();
    const Constraint_system_d system = system_of(constraints, unknowns);
    (*m_found.parts)
        .push_back({parts, system, internal::Curve_cuts(curves_within_budget(system, budget))(poles, rest)});
    const Curve_solution_set_d& set = (*m_found.parts).back().solutions;
    const Seam_joints joints(system, set, parts.closed_unknowns);
    const std::size_t part = (*m_found.parts).size() - 1;
    for (const Intersection_curve& curve : joints.curves()) {
      m_found.curves.push_back({{}, curve.is_closed});
      for (const Intersection_arc& arc : curve.arcs)
        m_found.curves.back().arcs.push_back({part, arc.index, arc.is_reversed});
    }
    std::vector<std::size_t> points = joints.points();
    if (parts.is_one_point)
      std::erase_if(points, [&](std::size_t i) { return parts.is_one_point(set.vertices()[i].box); });
    add_special_points(points, m_point_vertices, m_found.points);
    add_special_points(joints.without_repetitions(set.singular_points()), m_singular_vertices, m_found.singular_points);
    for (const Undecided_region& region : set.undecided_regions())
      add_undecided(part, region);
    for (const Curve_vertex::Exact_box& box : rest)
      add_undecided(part, {{box}, {}, Undecided_reason::DOMAIN_BOUNDARY});
    for (const std::size_t i : joints.unmatched())
      add_undecided(part, {{set.vertices()[i].box}, {i}, Undecided_reason::DOMAIN_BOUNDARY});
    m_found.poles += poles.size() + multiple - rest.size();
    m_found.summary += set.summary();
    m_found.summary.is_complete = m_found.summary.is_complete && rest.empty() && joints.unmatched().empty();
  }

  // Two parts whose equation is not solved.
  void add_undecided(const Pair_of_parts& parts, const std::vector<Unknown>& unknowns, Undecided_reason reason)
  {
    Curve_vertex::Exact_box domain;
    for (const Unknown& unknown : unknowns)
      domain.push_back(unknown.domain());
    m_found.parts->push_back({parts, Constraint_system_d(domain), Curve_solution_set_d({}, {}, {}, {}, {}, Summary())});
    add_undecided(m_found.parts->size() - 1, {{domain}, {}, reason});
  }

  // Joins the curves of different parts. An end that may go on in another part, but not in just one curve there, is
  // undecided.
  void join_parts()
  {
    std::vector<std::pair<Curve_end, Joint_place>> ends;
    for (std::size_t c = 0; c < m_found.curves.size(); ++c)
      for (const int side : {0, 1})
        if (const auto [part, vertex] = vertex_at_end(m_found, m_found.curves[c], side); !m_found.curves[c].is_closed &&
            (*m_found.parts)[part].parts.place && vertex->is_on_boundary && !vertex->is_on_inequality)
          if (const auto place = (*m_found.parts)[part].parts.place(vertex->box))
            ends.push_back({{c, side}, *place});
    const Matched_ends matched = matched_ends(ends, m_found.curves.size(),
                                              [](const Joint_place& a, const Joint_place& b) { return a.may_be(b); });
    for (const Curve_end& end : matched.unmatched) {
      const auto [part, vertex] = vertex_at_end(m_found, m_found.curves[end.curve], end.side);
      add_undecided(part, {{vertex->box}, {}, Undecided_reason::DOMAIN_BOUNDARY});
    }
    m_found.curves = joined_curves(m_found.curves, matched);
    remove_repetitions();
  }

  void add_work(const Summary& work) { m_found.summary += work; }

private:
  void add_undecided(std::size_t part, Undecided_region region)
  {
    m_found.undecided.push_back(std::move(region));
    m_found.parts_of_undecided.push_back(part);
    m_found.summary.is_complete = false;
  }

  // Those of the last part.
  void add_special_points(const std::vector<std::size_t>& vertices, std::vector<Vertex_of_part>& list,
                          std::vector<Curve_vertex>& points)
  {
    for (const std::size_t i : vertices) {
      list.push_back({(*m_found.parts).size() - 1, i});
      points.push_back((*m_found.parts).back().solutions.vertices()[i]);
    }
  }

  // A point that several parts have comes once; a single one not at all if it is on a curve of another part. If it is
  // not known which point of the other part it is, it is undecided.
  void remove_repetitions()
  {
    remove_repetitions(m_point_vertices, m_found.points, false);
    remove_repetitions(m_singular_vertices, m_found.singular_points, true);
  }

  void remove_repetitions(std::vector<Vertex_of_part>& list, std::vector<Curve_vertex>& points, bool counts_on_curves)
  {
    const std::vector<Vertex_of_part> all = std::exchange(list, {});
    points.clear();
    for (const Vertex_of_part& point : all) {
      const Curve_vertex& vertex = (*m_found.parts)[point.part].solutions.vertices()[point.vertex];
      const auto is_listed_before = [&](const Vertex_of_part& same) {
        return std::find(all.begin(), all.end(), same) == all.end() ? !counts_on_curves : same < point;
      };
      const std::vector<Vertex_of_part> at_place = others_at_place_of(point), in_corner = others_in_corner_of(point);
      if (at_place.size() > 1) {
        add_undecided(point.part, {{vertex.box}, {}, Undecided_reason::DOMAIN_BOUNDARY});
      } else if (std::none_of(at_place.begin(), at_place.end(), is_listed_before) &&
                 std::none_of(in_corner.begin(), in_corner.end(), is_listed_before)) {
        list.push_back(point);
        points.push_back(vertex);
      }
    }
  }

  std::optional<Joint_place> place_of(const Vertex_of_part& point) const
  {
    const auto& [parts, system, solutions] = (*m_found.parts)[point.part];
    return parts.place ? parts.place(solutions.vertices()[point.vertex].box) : std::nullopt;
  }

  // The other vertices that are the same pair of parameters.
  std::vector<Vertex_of_part> others_in_corner_of(const Vertex_of_part& point) const
  {
    const auto own = corner_of(point);
    return own ? others(point, [&](const Vertex_of_part& other) { return corner_of(other) == own; })
               : std::vector<Vertex_of_part>();
  }

  std::optional<Joint_corner> corner_of(const Vertex_of_part& point) const
  {
    const auto& [parts, system, solutions] = (*m_found.parts)[point.part];
    return parts.corner ? parts.corner(solutions.vertices()[point.vertex].box) : std::nullopt;
  }

  // The other vertices that may be the same point, where curves may go on in another part.
  std::vector<Vertex_of_part> others_at_place_of(const Vertex_of_part& point) const
  {
    const auto own = place_of(point);
    const auto may_be_it = [&](const Vertex_of_part& other) {
      const auto place = place_of(other);
      return place && place->may_be(*own);
    };
    return own ? others(point, may_be_it) : std::vector<Vertex_of_part>();
  }

  template <class Is_same>
  std::vector<Vertex_of_part> others(const Vertex_of_part& point, const Is_same& is_same) const
  {
    std::vector<Vertex_of_part> result;
    for (std::size_t part = 0; part < (*m_found.parts).size(); ++part)
      for (std::size_t i = 0; i < (*m_found.parts)[part].solutions.vertices().size(); ++i)
        if (const Vertex_of_part other{part, i}; other != point && is_same(other))
          result.push_back(other);
    return result;
  }
};

// A point of the plane in the stereographic projection to a sphere that lies on the origin: far points are close to
// each other there, and to the north pole, which is infinity.
inline std::array<double, 3> on_sphere(const Double_pair& point, double radius)
{
  const double x = point[0] / (2 * radius), y = point[1] / (2 * radius), share = 1 / (1 + x * x + y * y);
  if (!(share > 0))
    return {0, 0, 2 * radius};
  return {2 * radius * x * share, 2 * radius * y * share, 2 * radius * (1 - share)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool ends_at_infinity(const Found_pair_locus& found, const Curve_pair_curve& curve,
                                                     int side)
{
  return !curve.is_closed && found.poles > 0 && vertex_at_end(found, curve, side).second->is_on_inequality;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<Double_pair, Double_pair>>
samples_of_curve(const Found_pair_locus& found, const Curve_pair_curve& curve, double error, double radius)
{
  if (!(error > 0) || !(radius > 0))
    throw Invalid_input("Curve_pair_locus_2: the error and the radius must be positive");
  struct Image
  {
    Double_pair point;
    std::array<double, 3> on_sphere;
  };
  const auto is_chord = [&](const auto& from, const auto& between, const auto& to) {
    return distance_from_middle(from.image.on_sphere, between.image.on_sphere, to.image.on_sphere) <= error;
  };
  std::vector<std::pair<Double_pair, Double_pair>> result; // the ends may be at infinity
  for (const Curve_pair_arc& arc : curve.arcs) {
    const Pair_locus_part& part = (*found.parts)[arc.part];
    const auto image = [&](const std::vector<double>& unknowns) {
      const Double_pair p = found.point(part.parts.points(unknowns), unknowns);
      return Image{p, on_sphere(p, radius)};
    };
    auto more = curve_samples(part.system, part.solutions, part.solutions.curves()[arc.index], image, is_chord);
    if (arc.is_reversed)
      std::reverse(more.begin(), more.end());
    for (const auto& [unknowns, place] : more)
      result.emplace_back(place.point, part.parts.parameters(unknowns));
  }
  if (ends_at_infinity(found, curve, 0))
    result.erase(result.begin());
  if (ends_at_infinity(found, curve, 1))
    result.pop_back();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Curve_solution_set_d& solutions_of_part(const Found_pair_locus& found,
                                                                             std::size_t part)
{
  return (*found.parts)[part].solutions;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Constraint_system_d& system_of_part(const Found_pair_locus& found,
                                                                         std::size_t part)
{
  return (*found.parts)[part].system;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Undecided_part> undecided_parts_of(const Found_pair_locus& found)
{
  std::vector<Undecided_part> result;
  for (std::size_t i = 0; i < found.undecided.size(); ++i) {
    const Pair_of_parts& parts = (*found.parts)[found.parts_of_undecided[i]].parts;
    const std::array<Exact_range, 2> ranges = parts.ranges(hull_of(found.undecided[i]));
    result.push_back({{},
                      {{found.operands[0], {double_range(ranges[0])}}, {found.operands[1], {double_range(ranges[1])}}},
                      in_words(found.undecided[i].reason)});
  }
  return result;
}

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_LOCUS_COLLECTOR_H
