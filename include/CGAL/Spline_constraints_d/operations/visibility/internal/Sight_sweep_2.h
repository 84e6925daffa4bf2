// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_SWEEP_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_SWEEP_2_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/joined_edges.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Visible_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_crossing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

/*
What is seen from a point. All numbers are exact.

Between the directions of ends of arcs and of crossings, the order of arcs along the ray is always the same: it is
decided in one rational direction of each sector. Directions that are not told apart make one cluster. It is certain
what is seen there if they are proved to be one direction, but for those of points that are behind what is seen on both
sides.
*/
class Sight_sweep_2
{
  static constexpr int most_refinements = 40;

  // A direction in which an arc ends, or a crossing is seen; or an axis, without a curve.
  struct Event
  {
    Rational_interval direction, distance;
    std::optional<std::pair<std::size_t, int>> end;   // of an arc
    std::optional<std::size_t> curve;
    Parameter_range range;
    bool operator<(const Event& other) const { return direction.lower < other.direction.lower; }
  };

  // Events that are not told apart.
  struct Cluster
  {
    Rational_interval direction;
    std::vector<Event> events;
  };

  enum class Sight { ARC, NOTHING, UNKNOWN };

  // What is seen in a sector.
  struct Front
  {
    Sight sight;
    std::size_t arc;
  };

  Run_of_steps& m_run;
  const Curve_parts_2& m_parts;
  std::vector<Sight_crossing> m_crossings;
  std::vector<Sight_arc_2> m_arcs;
  std::vector<Cluster> m_clusters;                                   // the last one is the first one after a full turn
  std::vector<std::array<std::size_t, 2>> m_span;                    // of each arc, the clusters at its ends
  std::vector<Rational_interval> m_distances;                        // of each arc
  std::vector<Front> m_fronts;                                       // from each cluster to the next one
  std::vector<Visible_edge_2> m_edges;
  bool m_is_complete = true;

public:
  // \throws Run_stopped
  Sight_sweep_2(const Curve_parts_2& parts, const Exact_pair& viewpoint, std::vector<Sight_crossing> crossings,
                Run_of_steps& run)
    : m_run(run), m_parts(parts), m_crossings(std::move(crossings))
  {
    const std::vector<bool> are_copies = copies();
    std::erase_if(m_crossings, [&](const Sight_crossing& crossing) {
      return are_copies[crossing.curves[0]] || are_copies[crossing.curves[1]];
    });
    for (Sight_crossing& crossing : m_crossings) {
      m_run.check();
      settle(crossing);
    }
    for (std::size_t i = 0; i < parts.number_of_curves(); ++i)
      if (!are_copies[i])
        for (const Hull_piece_2& piece : parts.pieces()[i]) {
          m_run.check();
          append_sight_arcs(piece.curve(), viewpoint, m_arcs);
        }
    for (const Sight_arc_2& arc : m_arcs) {
      m_run.check();
      m_distances.push_back(arc.distance(arc.range()));
    }
    make_clusters(viewpoint);
    find_spans();
    for (std::size_t s = 0; s + 1 < m_clusters.size(); ++s) {
      m_fronts.push_back(front_of(s));
      m_run.add_progress(1 / static_cast<double>(m_clusters.size()));
    }
    make_edges();
    join_arcs();
  }

  const std::vector<Visible_edge_2>& edges() const { return m_edges; }
  bool is_complete() const { return m_is_complete; }

private:
  // Which curves are parts of others, all of them, and so hide nothing: of those that are the same the first one stays.
  std::vector<bool> copies() const
  {
    std::vector<bool> result(m_parts.number_of_curves(), false);
    for (const Sight_crossing& crossing : m_crossings)
      for (std::size_t k = 0; k < 2; ++k)
        if (const auto [copy, other] = std::pair(crossing.curves[k], crossing.curves[1 - k]);
            crossing.kind == Intersection_kind::OVERLAP && is_part_of(copy, other) &&
            (other < copy || !is_part_of(other, copy)))
          result[copy] = true;
    return result;
  }

  // Whether overlaps with another curve cover all of a curve.
  bool is_part_of(std::size_t curve, std::size_t other) const
  {
    std::vector<Parameter_range> ranges;
    for (const Sight_crossing& crossing : m_crossings)
      for (std::size_t k = 0; k < 2; ++k)
        if (crossing.kind == Intersection_kind::OVERLAP && crossing.curves[k] == curve &&
            crossing.curves[1 - k] == other)
          ranges.push_back(crossing.ranges[k]);
    std::sort(ranges.begin(), ranges.end());
    const auto& pieces = m_parts.pieces()[curve];
    Exact_rational covered = pieces.front().curve().parameters[0];
    for (const Parameter_range& range : ranges)
      if (range.first <= covered)
        covered = (std::max)(covered, range.second);
    return covered >= pieces.back().curve().parameters[1];
  }

  // The only common point in ranges has the simplest rational parameters of these, if that is a common point.
  void settle(Sight_crossing& crossing) const
  {
    std::array<Exact_rational, 2> simplest;
    for (std::size_t k = 0; k < 2; ++k)
      simplest[k] = crossing.ranges[k].first < crossing.ranges[k].second
          ? simplest_rational_between(crossing.ranges[k].first, crossing.ranges[k].second)
          : crossing.ranges[k].first;
    if (is_common_point(crossing) &&
        m_parts.point(crossing.curves[0], simplest[0]) == m_parts.point(crossing.curves[1], simplest[1]))
      for (std::size_t k = 0; k < 2; ++k)
        crossing.ranges[k] = {simplest[k], simplest[k]};
  }

  void make_clusters(const Exact_pair& viewpoint)
  {
    std::vector<Event> events;
    for (int axis = 0; axis < 4; ++axis)
      events.push_back({Rational_interval(Exact_rational(axis)), {}, std::nullopt, std::nullopt, {}});
    for (std::size_t i = 0; i < m_arcs.size(); ++i) {
      m_run.check();
      for (int end = 0; end < 2; ++end) {
        const Rational_interval& direction = m_arcs[i].direction(end);
        const Parameter_range range = m_arcs[i].range_of_end(end);
        events.push_back({direction.lower == 4 ? Rational_interval(Exact_rational(0)) : direction,
                          m_arcs[i].distance(range), std::pair(i, end), m_arcs[i].curve(), m_arcs[i].on_curve(range)});
      }
    }
    for (const Sight_crossing& crossing : m_crossings) {
      m_run.check();
      if (crossing.kind != Intersection_kind::OVERLAP)
        append_directions(crossing, viewpoint, events);
    }
    std::sort(events.begin(), events.end());
    for (Event& event : events)
      if (!m_clusters.empty() && event.direction.lower <= m_clusters.back().direction.upper) {
        m_clusters.back().direction.upper = (std::max)(m_clusters.back().direction.upper, event.direction.upper);
        m_clusters.back().events.push_back(std::move(event));
      } else
        m_clusters.push_back({event.direction, {event}});
    join_around_first_axis();
    m_clusters.push_back(m_clusters.front());
    m_clusters.back().direction = m_clusters.front().direction + Rational_interval(Exact_rational(4));
  }

  // Directions that may be 4 are at the first axis.
  void join_around_first_axis()
  {
    if (m_clusters.back().direction.upper < 4)
      return;
    Cluster last = std::move(m_clusters.back());
    m_clusters.pop_back();
    Cluster& first = m_clusters.front();
    const Rational_interval turn(Exact_rational(4));
    first.direction = hull(first.direction, last.direction - turn);
    for (Event& event : last.events)
      event.direction = event.direction - turn;
    first.events.insert(first.events.end(), last.events.begin(), last.events.end());
  }

  static bool is_known(const Event& event) { return event.direction.lower == event.direction.upper; }

  // Those of both curves; of one, if there, as on a line through the viewpoint, it is known exactly.
  void append_directions(const Sight_crossing& crossing, const Exact_pair& viewpoint, std::vector<Event>& events) const
  {
    std::array<std::vector<Event>, 2> found;
    for (std::size_t k = 0; k < 2; ++k)
      append_directions(crossing.curves[k], crossing.ranges[k], viewpoint, found[k]);
    for (std::size_t k = 0; k < 2; ++k)
      if (is_common_point(crossing) && !found[k].empty() && std::all_of(found[k].begin(), found[k].end(), is_known))
        found[1 - k].clear();
    for (const std::vector<Event>& of_curve : found)
      events.insert(events.end(), of_curve.begin(), of_curve.end());
  }

  // A crossing is seen in the directions of its part of the curve. One that is not told from the viewpoint is seen in
  // all directions.
  void append_directions(std::size_t curve, const Parameter_range& range, const Exact_pair& viewpoint,
                         std::vector<Event>& events) const
  {
    std::vector<Exact_pair> points;
    if (range.first == range.second)
      points.push_back(exact_difference(m_parts.point(curve, range.first), viewpoint));
    else
      for (const Hull_piece_2& piece : m_parts.between(curve, range.first, range.second))
        for (const Exact_pair& point : piece.points())
          points.push_back(exact_difference(point, viewpoint));
    if (points.size() == 1 && points[0] == Exact_pair{0, 0})   // there, arcs end
      return;
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
      const Rational_interval all(Exact_rational(quadrant), Exact_rational(quadrant + 1));
      std::optional<Rational_interval> direction, distance;
      for (const Exact_pair& point : points) {
        const Exact_rational sum(point[0] + point[1]);
        const Rational_interval one = sum > 0 ? Rational_interval(Exact_rational(quadrant + point[1] / sum)) : all,
                                away((std::max)(sum, Exact_rational(0)), CGAL::abs(sum));
        direction = direction ? hull(*direction, one) : one;
        distance = distance ? hull(*distance, away) : away;
      }
      const bool may_be_here =
          std::any_of(points.begin(), points.end(), [](const Exact_pair& p) { return p[0] >= 0; }) &&
          std::any_of(points.begin(), points.end(), [](const Exact_pair& p) { return p[1] >= 0; });
      if (may_be_here && direction->upper >= all.lower && direction->lower < all.upper)
        events.push_back({intersection(*direction, all), *distance, std::nullopt, curve, range});
      for (Exact_pair& point : points)
        point = normal_on_the_right(point);
    }
  }

  // Whether all points of a cluster that are not farther than a limit, if there is one, are proved to be in one
  // direction.
  bool is_one_direction(const Cluster& cluster, const std::optional<Exact_rational>& limit) const
  {
    std::vector<Event> events;
    for (const Event& event : cluster.events)
      if (event.curve && !(limit && event.distance.lower > *limit))
        events.push_back(event);
    if (events.empty() || std::all_of(events.begin(), events.end(), [&](const Event& e) {
          return e.curve == events[0].curve && e.range == events[0].range && e.end;
        }))
      return true;
    const auto known = std::find_if(cluster.events.begin(), cluster.events.end(), is_known);
    if (known == cluster.events.end())
      return are_one_crossing(events);
    const Exact_rational& direction = known->direction.lower;
    return std::all_of(events.begin(), events.end(),
                       [&](const Event& e) {
                         return is_known(e) ? e.direction.lower == direction : is_end_in(e, direction);
                       }) ||
        are_one_crossing(events);
  }

  bool is_end_in(const Event& event, const Exact_rational& direction) const
  {
    if (!event.end)
      return false;
    const auto& [arc, end] = *event.end;
    const int quadrant = m_arcs[arc].quadrant();
    const Exact_rational own(direction + (direction == 0 && quadrant == 3 ? 4 : 0));
    return own >= quadrant && own <= quadrant + 1 && m_arcs[arc].is_seen_in(end, own);
  }

  // Whether all events are those of one common point of two curves.
  bool are_one_crossing(const std::vector<Event>& events) const
  {
    return std::any_of(m_crossings.begin(), m_crossings.end(), [&](const Sight_crossing& crossing) {
      return is_common_point(crossing) && std::all_of(events.begin(), events.end(), [&](const Event& e) {
               return !e.end &&
                   ((e.curve == crossing.curves[0] && e.range == crossing.ranges[0]) ||
                    (e.curve == crossing.curves[1] && e.range == crossing.ranges[1]));
             });
    });
  }

  static bool is_common_point(const Sight_crossing& crossing)
  {
    return crossing.kind != Intersection_kind::OVERLAP && crossing.kind != Intersection_kind::UNDECIDED;
  }

  void find_spans()
  {
    m_span.resize(m_arcs.size());
    for (std::size_t c = 0; c + 1 < m_clusters.size(); ++c)
      for (const Event& event : m_clusters[c].events)
        if (event.end) {
          const auto& [arc, end] = *event.end;
          const bool is_full_turn = c == 0 && m_arcs[arc].quadrant() == 3;
          m_span[arc][end] = is_full_turn ? m_clusters.size() - 1 : c;
        }
  }

  bool is_in_sector(std::size_t arc, std::size_t sector) const
  {
    return m_span[arc][0] <= sector && sector < m_span[arc][1];
  }

  // An arc, the root that is seen in a direction, and the distance there.
  struct Candidate
  {
    std::size_t arc;
    std::optional<Exact_root> root;
    Rational_interval distance;
  };

  // What is nearest in a sector, from a cluster to the next one.
  Front front_of(std::size_t sector) const
  {
    m_run.check();
    const Exact_rational direction =
        simple_dyadic_between(m_clusters[sector].direction.upper, m_clusters[sector + 1].direction.lower);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      if (is_in_sector(i, sector))
        candidates.push_back({i, std::nullopt, m_distances[i]});
    if (candidates.empty())
      return {Sight::NOTHING, 0};
    for (int refinements = 0; refinements < most_refinements; ++refinements) {
      Exact_rational nearest = candidates[0].distance.upper;
      for (const Candidate& candidate : candidates)
        nearest = (std::min)(nearest, candidate.distance.upper);
      std::erase_if(candidates, [&](const Candidate& candidate) { return candidate.distance.lower > nearest; });
      if (candidates.size() == 1)
        return {Sight::ARC, candidates[0].arc};
      for (Candidate& candidate : candidates) {
        m_run.check();
        refine(candidate, direction);
      }
    }
    const bool are_the_same = std::all_of(candidates.begin() + 1, candidates.end(),
                                          [&](const Candidate& other) { return do_overlap(candidates[0], other); });
    return {are_the_same ? Sight::ARC : Sight::UNKNOWN, candidates[0].arc};
  }

  void refine(Candidate& candidate, const Exact_rational& direction) const
  {
    const Sight_arc_2& arc = m_arcs[candidate.arc];
    if (!candidate.root)
      candidate.root = arc.root_at(direction);
    for (int k = 0; k < 4; ++k)
      candidate.root->halve();
    candidate.distance = arc.distance({candidate.root->lower(), candidate.root->upper()});
  }

  // Whether two arcs are parts of an overlap of their curves.
  bool do_overlap(const Candidate& a, const Candidate& b) const
  {
    const auto is_within = [&](const Candidate& c, std::size_t curve, const Parameter_range& range) {
      const Parameter_range place = m_arcs[c.arc].on_curve({c.root->lower(), c.root->upper()});
      return m_arcs[c.arc].curve() == curve && range.first <= place.first && place.second <= range.second;
    };
    return std::any_of(m_crossings.begin(), m_crossings.end(), [&](const Sight_crossing& crossing) {
      const auto are_parts = [&](int k) {
        return is_within(a, crossing.curves[k], crossing.ranges[k]) &&
            is_within(b, crossing.curves[1 - k], crossing.ranges[1 - k]);
      };
      return crossing.kind == Intersection_kind::OVERLAP && (are_parts(0) || are_parts(1));
    });
  }

  // Where an arc that is in a sector beside a cluster is seen at that cluster; local parameters.
  Parameter_range place(std::size_t arc, std::size_t cluster) const
  {
    for (int end = 0; end < 2; ++end)
      if (m_span[arc][end] == cluster)
        return m_arcs[arc].range_of_end(end);
    return m_arcs[arc].range_at(m_clusters[cluster].direction);
  }

  Rational_interval distance_at(std::size_t arc, std::size_t cluster) const
  {
    return m_arcs[arc].distance(place(arc, cluster));
  }
  Boundary_vertex_2 vertex(std::size_t arc, std::size_t cluster) const
  {
    return {m_arcs[arc].curve(), m_arcs[arc].on_curve(place(arc, cluster))};
  }

  // Arcs, and what is between the end of one and the begin of the next one. Sectors where no arc is seen are passed
  // over.
  void make_edges()
  {
    const std::size_t sectors = m_fronts.size();
    std::size_t first = 0;
    for (; first < sectors && m_fronts[first].sight != Sight::ARC; ++first)
      m_is_complete =
          m_is_complete && m_fronts[first].sight == Sight::NOTHING && is_one_direction(m_clusters[first], std::nullopt);
    for (std::size_t s = first; s < sectors;) {
      m_run.check();
      const std::size_t arc = m_fronts[s].arc, begin = s;
      m_edges.push_back({Visible_edge_kind::ARC, vertex(arc, s), vertex(arc, s + 1)});
      Visible_edge_kind kind = Visible_edge_kind::SEGMENT;
      while (m_fronts[++s % sectors].sight != Sight::ARC) {
        m_run.check();
        const bool is_decided = m_fronts[s % sectors].sight == Sight::NOTHING && kind != Visible_edge_kind::UNDECIDED &&
            is_one_direction(m_clusters[s % sectors], std::nullopt);
        kind = is_decided ? Visible_edge_kind::OPEN : Visible_edge_kind::UNDECIDED;
      }
      append_step(arc, begin + 1, s % sectors, kind);
    }
  }

  // What is between the arc that is seen before a cluster and that which is seen in a sector after it.
  void append_step(std::size_t arc, std::size_t cluster, std::size_t sector, Visible_edge_kind kind)
  {
    const std::size_t next_arc = m_fronts[sector].arc;
    const Boundary_vertex_2 source = vertex(arc, cluster), target = vertex(next_arc, sector);
    const Rational_interval a = distance_at(arc, cluster), b = distance_at(next_arc, sector);
    const bool is_decided = kind == Visible_edge_kind::SEGMENT
        ? is_one_direction(m_clusters[sector], (std::max)(a.upper, b.upper))
        : is_one_direction(m_clusters[sector], std::nullopt);
    if (!is_decided)
      kind = Visible_edge_kind::UNDECIDED;
    if (kind == Visible_edge_kind::SEGMENT) {
      if (is_same(source, target) || are_one_point(source, target))
        return;
      if (!(a.upper < b.lower || b.upper < a.lower))
        kind = Visible_edge_kind::UNDECIDED;
    }
    m_is_complete = m_is_complete && kind != Visible_edge_kind::UNDECIDED;
    m_edges.push_back({kind, source, target});
  }

  static bool is_same(const Boundary_vertex_2& a, const Boundary_vertex_2& b)
  {
    return a.curve == b.curve && a.parameters == b.parameters;
  }

  bool are_one_point(const Boundary_vertex_2& a, const Boundary_vertex_2& b) const
  {
    const auto is_known = [](const Boundary_vertex_2& v) { return v.parameters.first == v.parameters.second; };
    if (is_known(a) && is_known(b) &&
        m_parts.point(a.curve, a.parameters.first) == m_parts.point(b.curve, b.parameters.first))
      return true;
    const auto meets = [](const Boundary_vertex_2& v, std::size_t curve, const Parameter_range& range) {
      return v.curve == curve && v.parameters.first <= range.second && range.first <= v.parameters.second;
    };
    return std::any_of(m_crossings.begin(), m_crossings.end(), [&](const Sight_crossing& crossing) {
      const auto are_at = [&](int k) {
        return meets(a, crossing.curves[k], crossing.ranges[k]) &&
            meets(b, crossing.curves[1 - k], crossing.ranges[1 - k]);
      };
      return is_common_point(crossing) && (are_at(0) || are_at(1));
    });
  }

  // One edge for successive arcs of one curve; the first one does not go on from the last one.
  void join_arcs()
  {
    const auto goes_on = [](const Visible_edge_2& edge, const Visible_edge_2& next) {
      return edge.kind == Visible_edge_kind::ARC && next.kind == Visible_edge_kind::ARC &&
          edge.target.curve == next.source.curve && edge.target.parameters == next.source.parameters &&
          edge.is_reversed() == next.is_reversed();
    };
    m_edges = joined_edges(std::move(m_edges), goes_on,
                           [](Visible_edge_2& edge, const Visible_edge_2& next) { edge.target = next.target; });
  }
};

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_SWEEP_2_H
