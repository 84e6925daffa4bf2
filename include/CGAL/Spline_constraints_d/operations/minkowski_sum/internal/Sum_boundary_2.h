// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_BOUNDARY_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Boundary_balance_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Convolution_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Convolution_cuts_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Crossing_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_interior_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Vertex_star_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/turn_around.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
The boundary of the Minkowski sum of two regions, as sections of the pieces of their convolution.

The pieces are cut where they cross, or touch. Then each section, together with those that it alone goes on as, is on
the boundary as a whole, or inside of the sum as a whole: the boundary, which has no ends, is made of sections, and can
leave one only in a vertex that others have too. One point beside a section tells which.
*/
class Sum_boundary_2
{
public:
  struct Section
  {
    std::size_t piece;
    Range range;                             // of the parameter of the piece; up to small ranges at the ends
    Range outer_range;                       // with these
    std::array<std::size_t, 2> vertices{};   // at the begin and end
  };

  struct Chain
  {
    std::vector<Section> sections;
    bool is_closed;
    bool is_hole = false;                       // whether it is clockwise
    std::optional<std::size_t> outer = {};      // the chain around the same part of the sum
  };

  // A box with points that may be on the boundary and are not on the chains, or where these may not be the boundary;
  // a part of a piece, if it comes from one.
  struct Doubt
  {
    Interval_pair box;
    std::optional<std::pair<std::size_t, Range>> part;
    std::string reason;
  };

private:
  static constexpr int most_trials = 16;
  static constexpr double share_of_cuts = 0.25, share_of_chains = 0.5;   // of the work of all of a sum, about

  const Sum_interior_2& m_interior;
  Run_of_steps& m_control;
  Convolution_cuts_2 m_cuts;
  double m_size = 0;
  std::vector<Chain> m_chains;
  std::vector<Doubt> m_doubts;

public:
  // When the run ends while chains are told to be on the boundary or not, those that are known make up the boundary.
  // \throws Run_stopped before
  Sum_boundary_2(const Convolution_2& convolution, const Sum_interior_2& interior, Run_of_steps& control)
    : m_interior(interior), m_control(control), m_cuts(convolution.pieces(), interior, control), m_size(size_of_all())
  {
    for (const auto& [piece, range, box] : m_cuts.undecided())
      m_doubts.push_back({box, std::pair(piece, range), "it is not told how arcs meet"});
    for (const Interval_pair& box : convolution.doubtful())
      m_doubts.push_back({box, std::nullopt, "the sign of the sum of both curvatures is not certain"});
    m_control.add_progress(share_of_cuts);
    m_chains = linked(boundary_sections(convolution.doubtful()), true);
    check_chains();
    nest_chains();
  }

  const std::vector<Chain>& chains() const { return m_chains; }
  const Convolution_piece_2& piece(std::size_t index) const { return m_cuts.pieces()[index]; }

  const std::vector<Doubt>& doubts() const { return m_doubts; }

private:
  void doubt(const Section& section, const std::string& reason)
  {
    m_doubts.push_back({curves()[section.piece](section.range).point, std::pair(section.piece, section.range),
                        m_control.is_stopped() ? in_words(m_control.reason()) : reason});
  }

  const std::vector<Traced_curve_2>& curves() const { return m_cuts.curves(); }

  double size_of_all() const
  {
    if (curves().empty())
      return 0;
    Interval_pair box = curves().front().whole().box();
    for (const Traced_curve_2& curve : curves())
      box = hull(box, curve.whole().box());
    return (std::max)(box[0].sup() - box[0].inf(), box[1].sup() - box[1].inf());
  }

  // The sections between cuts.
  std::vector<Section> all_sections() const
  {
    std::vector<Section> result;
    for (std::size_t i = 0; i < curves().size(); ++i)
      for (std::size_t k = 1; k < m_cuts.cuts(i).size(); ++k) {
        const Convolution_cuts_2::Cut &a = m_cuts.cuts(i)[k - 1], &b = m_cuts.cuts(i)[k];
        result.push_back(
            {i, {a.range.end, b.range.begin}, {a.range.begin, b.range.end}, {m_cuts.vertex(a), m_cuts.vertex(b)}});
      }
    return result;
  }

  /*
  The sections that are on the boundary. Each chain is, or is not, as a whole, and the boundary has the sum on the left;
  so what is known of some chains tells about others that they meet, as about the tiny ones at a joint that is nearly
  smooth, where points beside them tell nothing. All that a piece may have in common with others is in its cuts, with
  their vertices, or inside of the sum; so each vertex, with all of its cuts, is balanced if nothing doubtful reaches
  it.
  */
  std::vector<Section> boundary_sections(const std::vector<Interval_pair>& doubtful)
  {
    const std::vector<Chain> chains = linked(all_sections(), false);
    std::vector<std::array<std::size_t, 2>> ends;
    for (const Chain& chain : chains)
      ends.push_back({chain.sections.front().vertices[0], chain.sections.back().vertices[1]});
    Boundary_balance_2 balance(ends, vertices_near(doubtful));
    const bool are_all_tried = try_chains(chains, balance);
    std::vector<Section> result;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const std::vector<Section>& sections = chains[i].sections;
      const std::optional<bool> is_boundary = balance.is_boundary(i);
      if (!is_boundary)
        for (const Section& section : sections)
          doubt(section, "it is not told whether an arc is inside of the sum");
      if (is_boundary.value_or(are_all_tried))   // what remains undecided is taken for a part of the boundary
        result.insert(result.end(), sections.begin(), sections.end());
    }
    return result;
  }

  // Returns whether the run did not end before.
  bool try_chains(const std::vector<Chain>& chains, Boundary_balance_2& balance)
  {
    const std::vector<std::size_t> order = by_size(chains);
    try {
      for (const std::size_t i : order) {
        if (!balance.is_boundary(i))
          if (const CGAL::Uncertain<bool> is_boundary = is_on_boundary(chains[i]); is_boundary.is_certain())
            balance.set(i, is_boundary.make_certain());
        m_control.add_progress(share_of_chains / static_cast<double>(chains.size()));
      }
    } catch (const Run_stopped&) {
      return false;
    }
    return true;
  }

  // The numbers of some chains, large ones first: points beside these tell more easily.
  std::vector<std::size_t> by_size(const std::vector<Chain>& chains) const
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      m_control.check();
      order.emplace_back(-extent(chains[i]), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> result;
    for (const auto& [extent, i] : order)
      result.push_back(i);
    return result;
  }

  // About.
  double extent(const Chain& chain) const
  {
    double result = 0;
    for (const Section& section : chain.sections) {
      const Interval_pair a = curves()[section.piece]({section.range.begin, section.range.begin}).point,
                          b = curves()[section.piece]({section.range.end, section.range.end}).point;
      result = (std::max)({result, std::abs(a[0].inf() - b[0].inf()), std::abs(a[1].inf() - b[1].inf())});
    }
    return result;
  }

  std::set<std::size_t> vertices_near(const std::vector<Interval_pair>& boxes) const
  {
    std::set<std::size_t> result;
    if (!boxes.empty())
      for (std::size_t i = 0; i < curves().size(); ++i)
        for (const Convolution_cuts_2::Cut& cut : m_cuts.cuts(i))
          if (const Interval_pair place = curves()[i](cut.range).point;
              std::any_of(boxes.begin(), boxes.end(), [&](const Interval_pair& box) { return may_meet(place, box); }))
            result.insert(m_cuts.vertex(cut));
    return result;
  }

  // Long sections tell more easily.
  CGAL::Uncertain<bool> is_on_boundary(const Chain& chain) const
  {
    for (const Section& section : long_first(chain.sections))
      if (const CGAL::Uncertain<bool> is_inside = has_inside_beside(section); is_inside.is_certain())
        return !is_inside;
    return CGAL::Uncertain<bool>::indeterminate();
  }

  static std::vector<Section> long_first(std::vector<Section> sections)
  {
    std::sort(sections.begin(), sections.end(),
              [](const Section& a, const Section& b) { return a.range.width() > b.range.width(); });
    return sections;
  }

  /*
  Whether the points on the right of a section are inside of the sum, as those on the left are: by a point so near that
  no other piece comes between. The piece itself does not, since its directions differ by less than
  90 degrees from that in a point of the section. Points beside different places are tried, since the boundaries may
  touch for one.
  */
  CGAL::Uncertain<bool> has_inside_beside(const Section& section) const
  {
    constexpr std::array<double, 4> places{0.5, 0.40625, 0.578125, 0.4609375};
    double distance = m_size / 128;
    for (int trial = 0; trial < most_trials; ++trial, distance /= 4) {
      const double t =
          section.range.begin + places[static_cast<std::size_t>(trial) % places.size()] * section.range.width();
      const Traced_jet jet = curves()[section.piece]({t, t});
      const Interval_pair& point = jet.point;
      const double x = jet.direction[0].inf(), y = jet.direction[1].inf(), length = std::hypot(x, y);
      if (!(length > 0) || !std::isfinite(length))
        continue;
      const Interval_pair p{Interval(point[0].inf() + distance * y / length),
                            Interval(point[1].inf() - distance * x / length)},
          between = hull(p, point);
      bool is_free = true;
      for (std::size_t i = 0; is_free && i < curves().size(); ++i)
        is_free = i == section.piece || Crossing_finder_2<>::is_apart(curves()[i], curves()[i].whole(), between);
      if (!is_free)
        continue;
      if (const CGAL::Uncertain<bool> result = m_interior.contains(p, m_control); result.is_certain())
        return result;
    }
    return CGAL::Uncertain<bool>::indeterminate();
  }

  // Sections one after the other: where one alone ends and one alone begins; or, of the boundary, so that the region is
  // between them.
  std::vector<Chain> linked(const std::vector<Section>& sections, bool are_boundary) const
  {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    const std::size_t n = sections.size();
    // of each vertex, the sections that begin there and those that end
    std::map<std::size_t, std::array<std::vector<std::size_t>, 2>> stars;
    for (std::size_t i = 0; i < n; ++i)
      for (const std::size_t e : {0, 1})
        stars[sections[i].vertices[e]][e].push_back(i);
    std::vector<std::size_t> next(n, none);
    std::vector<bool> has_previous(n, false), is_used(n, false);
    for (const auto& [vertex, star] : stars) {
      const auto& [begins, ends] = star;
      if (begins.size() != ends.size() || (begins.size() > 1 && !are_boundary))
        continue;
      if (const auto successors = begins.size() == 1
              ? std::optional(std::vector<std::size_t>{0})
              : Vertex_star_2(rays(sections, ends, 1), rays(sections, begins, 0)).successors())
        for (std::size_t k = 0; k < ends.size(); ++k) {
          next[ends[k]] = begins[(*successors)[k]];
          has_previous[next[ends[k]]] = true;
        }
    }
    std::vector<Chain> result;
    for (const bool is_closed : {false, true})
      for (std::size_t i = 0; i < n; ++i)
        if (!is_used[i] && (is_closed || !has_previous[i])) {
          result.push_back({{}, is_closed});
          for (std::size_t k = i; k != none && !is_used[k]; k = next[k]) {
            is_used[k] = true;
            result.back().sections.push_back(sections[k]);
          }
        }
    return result;
  }

  // How sections leave the vertex at their begin (0) or end (1): bounds for the range that it is in.
  std::vector<Star_ray_2> rays(const std::vector<Section>& sections, const std::vector<std::size_t>& indices,
                               std::size_t end) const
  {
    std::vector<Star_ray_2> result;
    for (const std::size_t i : indices) {
      const Range &range = sections[i].range, &outer = sections[i].outer_range;
      const Traced_jet jet =
          curves()[sections[i].piece](end == 0 ? Range{outer.begin, range.begin} : Range{range.end, outer.end});
      if (end == 0)
        result.push_back({jet.direction, jet.curvature});
      else
        result.push_back({{-jet.direction[0], -jet.direction[1]}, -jet.curvature});
    }
    return result;
  }

  // The boundary has no ends, and encloses some area. A chain that is not proved to is no outer one, and no hole.
  void check_chains()
  {
    for (std::size_t c = 0; c < m_chains.size(); ++c) {
      Chain& chain = m_chains[c];
      const Section &first = chain.sections.front(), &last = chain.sections.back();
      if (!chain.is_closed) {
        doubt({first.piece, {first.range.begin, first.range.begin}, {}}, "it is not told where a boundary comes from");
        doubt({last.piece, {last.range.end, last.range.end}, {}}, "it is not told where a boundary goes on");
      }
      else if (const int sign = sign_of_area(chain); sign < 0)
        chain.is_hole = true;
      else if (sign > 0)
        chain.outer = c;
      else
        doubt(first, "the sign of the area within a boundary is not certain");
    }
  }

  void nest_chains()
  {
    for (const std::size_t hole : find_outer_boundaries(
             m_chains, [&](std::size_t c, std::size_t other) { return is_around(m_chains[c], m_chains[other]); }))
      doubt(m_chains[hole].sections.front(), "the outer boundary around a hole is not certain");
  }

  // Whether a closed chain is around another one, if that is certain: around a point between the ends of a section,
  // where chains do not meet.
  CGAL::Uncertain<bool> is_around(const Chain& chain, const Chain& other) const
  {
    constexpr std::size_t most_sections = 4;
    const std::vector<Section> sections = long_first(other.sections);
    for (std::size_t k = 0; k < (std::min)(sections.size(), most_sections) && !m_control.must_stop(); ++k) {
      const double t = sections[k].range.middle();
      if (const std::optional<double> turn = turn_around_point(curves()[sections[k].piece]({t, t}).point, chain))
        return full_turns(*turn) != 0;
    }
    return CGAL::Uncertain<bool>::indeterminate();
  }

  // The angle along a closed chain. It goes on from one section to the next one in a vertex that is within the ranges
  // of both ends.
  std::optional<double> turn_around_point(const Interval_pair& p, const Chain& chain) const
  {
    double result = 0;
    for (std::size_t k = 0; k < chain.sections.size(); ++k) {
      const Section &section = chain.sections[k], &next = chain.sections[(k + 1) % chain.sections.size()];
      const auto path = [&](const Range& range) { return curves()[section.piece](range).point; };
      const auto way = [&](const Section& of, double from, double to) {
        return curves()[of.piece]({from, to}).point - p;
      };
      const auto angle = turn_around(p, path, section.range.begin, section.range.end);
      const auto angle_at_vertex = angle_within(hull(way(section, section.range.end, section.outer_range.end),
                                                     way(next, next.outer_range.begin, next.range.begin)),
                                                way(section, section.range.end, section.range.end),
                                                way(next, next.range.begin, next.range.begin));
      if (!angle || !angle_at_vertex)
        return std::nullopt;
      result += *angle + *angle_at_vertex;
    }
    return result;
  }

  int sign_of_area(const Chain& chain) const
  {
    constexpr int most_parts = 1024;
    int result = 0;
    for (int parts = 1; result == 0 && parts <= most_parts && !m_control.must_stop(); parts *= 4)
      result = certain_sign(twice_area(chain, parts));
    return result;
  }

  // The area of the polygon of points of a closed chain, with some parts of each section, and of what is between it and
  // the chain.
  Interval twice_area(const Chain& chain, int parts) const
  {
    const Section& first = chain.sections.front();
    const Interval_pair vertex = curves()[first.piece]({first.outer_range.begin, first.range.begin}).point;
    const Interval_pair origin{Interval(vertex[0].inf()), Interval(vertex[1].inf())};
    Interval result(0);
    for (const Section& section : chain.sections) {
      const Range &range = section.range, &outer = section.outer_range;
      Range last{outer.begin, range.begin};   // the vertex is anywhere there
      const auto add_chord_to = [&](const Range& next) {
        const Interval_pair a = curves()[section.piece](last).point, b = curves()[section.piece](next).point;
        result += cross(a - origin, b - origin) + twice_area_of_segment(section.piece, last, next);
        last = next;
      };
      for (int k = 0; k < parts; ++k) {
        const double t = range.begin + static_cast<double>(k) / parts * range.width();
        add_chord_to({t, t});
      }
      add_chord_to({range.end, range.end});
      add_chord_to({range.end, outer.end});
    }
    return result;
  }

  // Between a chord and its part of a piece, positive if this turns to the left: at most that of the triangle of the
  // chord and both tangents.
  Interval twice_area_of_segment(std::size_t index, const Range& from, const Range& to) const
  {
    const Convolution_piece_2& piece = m_cuts.pieces()[index];
    const Traced_curve_2& curve = curves()[index];
    if (!piece.is_convex())
      return Interval(-2, 2) * CGAL::square(diameter(curve(united(from, to)).point));
    const Interval squared_chord = squared_norm(curve(to).point - curve(from).point);
    return hull(Interval(0),
                squared_chord / Interval(2) * tangent_of_half_angle(piece.direction(from), piece.direction(to)));
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_BOUNDARY_2_H
