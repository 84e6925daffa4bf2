// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_OPPOSITE_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_OPPOSITE_SITES_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Sites that disks of one radius r on an element may touch, but only opposite to the element, and never hold: parallel
walls at the distance 2 r, and what is behind them. Bounds cannot tell such disks from larger and smaller ones, but the
coordinates are rational, and all is decided by exact computation.

An element that lies behind the tangent in one of its ends, X, has all its disks in the half-plane up to the parallel at
the distance 2 r, as <N, O - X> <= r |N|; they reach that line only where the element is on the tangent and has its
normal. All disks of a normal cone are in the disk of the radius 2 r around its vertex. A site beyond the border, with
all Bernstein coefficients of its distance, is touched at most where that is zero: in one of its ends, or all of it; or,
of a segment beside a normal cone, in one point. Nor do disks of a segment reach what is outside of the last one, and
behind its center. Where an arc ends in a crossing that is not known exactly, an arc that is a little longer takes its
place; what would touch in such an end is not decided.

Disks there count as covered: the offset is the limit of those at greater distances. On both sides of a range of
parallel walls, offsets are the same and bound nothing; where they touch in one point, each ends in it.
*/
class Opposite_sites
{
  // Where disks are touched from opposite, and the way from there to their centers.
  struct Tie
  {
    Exact_rational begin, end;
    Exact_pair way;
  };

  using Points = std::vector<Exact_pair>;
  using Coordinates = std::array<Bernstein_tensor<Exact_rational>, 3>;
  using Coefficients = std::array<std::vector<Exact_rational>, 3>;

  static constexpr std::array<bool, 2> both_ends{false, true};

  const Site_graph_2<>& m_graph;
  const Oriented_element<>& m_element;
  Exact_rational m_square;   // of 2 r
  std::vector<bool> m_ends;  // of an arc, behind the tangents in which it lies
  std::map<std::pair<Disk_candidate<>::Kind, std::size_t>, bool> m_is_beyond;
  std::vector<Tie> m_ties;

public:
  Opposite_sites(const Site_graph_2<>& graph, std::size_t element, const Exact_rational& radius)
    : m_graph(graph), m_element(graph.elements()[element]), m_square(4 * radius * radius)
  {
    if (!m_element.is_normal_cone)
      for (const bool end : {false, true})
        if (is_behind_tangent(end) && !(end && is_segment()))
          m_ends.push_back(end);
  }

  // Whether no disk holds a candidate. The places where it is touched are kept.
  template <Enclosing_number Number>
  bool contain(const Disk_candidate<Number>& candidate)
  {
    const auto [position, is_new] = m_is_beyond.try_emplace({candidate.kind, candidate.index}, false);
    if (is_new)
      position->second = candidate.kind == Candidate_kind::ARC
          ? add_arc(candidate.index)
          : candidate.kind == Candidate_kind::VERTEX && add_vertex(candidate.index);
    return position->second;
  }

  // Whether the element is an arc of a circle, and all of it is opposite to one of a circle with the same center.
  bool are_circles() const
  {
    if (m_element.is_normal_cone || !own_arc().circle() || !m_graph.are_ends_exact(m_element.object))
      return false;
    const auto& [center, square] = *own_arc().circle();
    const bool is_inside =
        sign_of(exact_dot(m_graph.exact_normal(m_element, 0), exact_difference(own_arc().at(0), center))) < 0;
    const auto are_on_one_ray = [&](const Exact_pair& x, const Exact_pair& y) {
      return sign_of(exact_cross(exact_difference(x, center), exact_difference(y, center))) == 0 &&
          sign_of(exact_dot(exact_difference(x, center), exact_difference(y, center))) > 0;
    };
    const auto is_opposite = [&](std::size_t index) {
      const Site_arc_2<>& arc = m_graph.arcs()[index];
      if (!arc.circle() || arc.circle()->first != center || (arc.circle()->second < square) != is_inside ||
          !m_graph.are_ends_exact(index))
        return false;
      const Exact_rational sum = square + arc.circle()->second - m_square;   // of squared radii: (R1 - R2)^2 = 4 r^2
      if (sign_of(sum) < 0 || sum * sum != 4 * square * arc.circle()->second)
        return false;
      const bool is_other_way = !are_on_one_ray(own_arc().at(0), arc.at(0));
      return are_on_one_ray(own_arc().at(0), arc.at(is_other_way)) &&
          are_on_one_ray(own_arc().at(1), arc.at(!is_other_way)) &&
          side_of_chord(own_arc()) == (is_other_way ? -1 : 1) * side_of_chord(arc);
    };
    for (std::size_t i = 0; i < m_graph.arcs().size(); ++i)
      if (is_opposite(i))
        return true;
    return false;
  }

  // Whether all disks of a range are known to be touched from opposite.
  bool touch(const Range& range) const
  {
    return std::any_of(m_ties.begin(), m_ties.end(), [&](const Tie& tie) {
      return tie.begin < tie.end && tie.begin <= range.begin && tie.end >= range.end;
    });
  }

  // Takes the places where disks are touched from ranges where they are free otherwise.
  void cut(Free_ranges& ranges)
  {
    unite_ties();
    for (const Tie& tie : m_ties) {
      std::erase_if(ranges.undecided,
                    [&](const Range& range) { return tie.begin <= range.begin && tie.end >= range.end; });
      std::vector<Free_range> parts;
      for (const Free_range& range : ranges.free)
        cut(range, tie, parts, ranges.undecided);
      ranges.free = std::move(parts);
    }
  }

private:
  const Site_arc_2<>& own_arc() const { return m_graph.arcs()[m_element.object]; }
  bool is_segment() const { return !m_element.is_normal_cone && own_arc().is_segment(); }
  bool is_own_end_exact(bool end) const { return m_graph.is_exact({m_element.object, end}); }
  Exact_pair own_end(bool end) const { return own_arc().at(Exact_rational(end ? 1 : 0)); }   // of the piece

  // How much farther than to an end of its piece an arc may go.
  Exact_rational error(const Arc_end& end) const
  {
    return m_graph.is_exact(end) ? Exact_rational(0) : m_graph.arcs()[end.arc].error();
  }

  // Of an arc, or one that it is a part of.
  Coordinates coordinates(std::size_t arc) const
  {
    Coordinates result = m_graph.arcs()[arc].piece().coordinates;
    if (!m_graph.are_ends_exact(arc))
      for (Bernstein_tensor<Exact_rational>& tensor : result)
        tensor = tensor.restricted(0, Exact_rational(-error({arc, false})), Exact_rational(1 + error({arc, true})));
    return result;
  }

  // The Bernstein coefficients of the coordinates and the weight, which is positive; none where that is not certain.
  std::optional<Coefficients> coefficients(std::size_t arc) const
  {
    const Coordinates all = coordinates(arc);
    Coefficients result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = all[k].elevated({m_graph.arcs()[arc].degree()}).coefficients();
    return std::all_of(result[2].begin(), result[2].end(), [](const Exact_rational& w) { return sign_of(w) > 0; })
        ? std::optional(result)
        : std::nullopt;
  }

  static int side_of_chord(const Site_arc_2<>& arc)
  {
    return sign_of(exact_cross(exact_difference(arc.at(1), arc.at(0)),
                               exact_difference(arc.at(Exact_rational(1) / 2), arc.at(0))));
  }

  bool is_behind_tangent(bool end) const
  {
    if (is_segment() || !is_own_end_exact(end))
      return is_segment();
    const auto c = coefficients(m_element.object);
    if (!c)
      return false;
    const Exact_pair p = own_end(end), n = m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0));
    std::vector<int> sides;
    for (std::size_t i = 0; i < (*c)[2].size(); ++i)
      sides.push_back(sign_of(exact_dot(
          n,
          Exact_pair{Exact_rational((*c)[0][i] - p[0] * (*c)[2][i]), Exact_rational((*c)[1][i] - p[1] * (*c)[2][i])})));
    // on it in this end only
    return *std::max_element(sides.begin(), sides.end()) <= 0 && (end ? sides.front() : sides.back()) < 0;
  }

  // The ends in which an arc touches a border, if all Bernstein coefficients of its distance from that have signs that
  // are not negative. Nothing if it is not beyond.
  std::optional<Points> touching_ends(std::size_t arc, const std::vector<int>& sides) const
  {
    const auto touches = [&](bool end) { return (end ? sides.back() : sides.front()) == 0; };
    if (*std::min_element(sides.begin(), sides.end()) < 0 ||
        std::any_of(both_ends.begin(), both_ends.end(), [&](bool end) {
          return touches(end) && !m_graph.is_exact({arc, end});
        }))
      return std::nullopt;
    Points result;
    for (const bool end : both_ends)
      if (touches(end))
        result.push_back(m_graph.arcs()[arc].at(Exact_rational(end ? 1 : 0)));
    return result;
  }

  static bool is_on_border(const std::vector<int>& sides)
  {
    return std::all_of(sides.begin(), sides.end(), [](int s) { return s == 0; });
  }

  // On which side of the parallel at the distance 2 r of the tangent in an end a homogeneous point is.
  int side_of_parallel(bool end, const Exact_rational& x, const Exact_rational& y, const Exact_rational& w) const
  {
    const Exact_pair p = own_end(end), n = m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0));
    const Exact_rational height = exact_dot(n, Exact_pair{Exact_rational(x - p[0] * w), Exact_rational(y - p[1] * w)});
    return sign_of(height) <= 0 ? -1 : sign_of(Exact_rational(height * height - m_square * exact_dot(n, n) * w * w));
  }

  std::vector<int> sides_of_parallel(bool end, const Coefficients& c) const
  {
    std::vector<int> result;
    for (std::size_t i = 0; i < c[2].size(); ++i)
      result.push_back(side_of_parallel(end, c[0][i], c[1][i], c[2][i]));
    return result;
  }

  // On which side of a circle an arc has the Bernstein coefficients of its squared distance from the center.
  std::vector<int> sides_of_circle(std::size_t arc, const Exact_pair& p, const Exact_rational& square) const
  {
    const auto [x, y, w] = coordinates(arc);
    const auto dx = x - w * p[0], dy = y - w * p[1];
    std::vector<int> result;
    for (const Exact_rational& c : (dx * dx + dy * dy - w * w * square).coefficients())
      result.push_back(sign_of(c));
    return result;
  }

  bool add_arc(std::size_t arc)
  {
    if (m_element.is_normal_cone)
      return add_arc_beside_normal_cone(arc);
    const auto c = coefficients(arc);
    const auto is_beyond = [&](bool end) {
      const std::vector<int> sides = sides_of_parallel(end, *c);
      // what it does not touch next to a crossing that is not known exactly, the next arc of its curve does
      if (is_on_border(sides))
        return add_tie(m_graph.arcs()[arc].at(0), m_graph.arcs()[arc].at(1), end);
      return add_ties(touching_ends(arc, sides), end);
    };
    return c &&
        (std::any_of(m_ends.begin(), m_ends.end(), is_beyond) || (is_segment() && is_behind_last_disk(arc, *c)));
  }

  // Whether an arc is outside of the disk at an end of a straight element, and behind its center: then it is outside of
  // all other ones.
  bool is_behind_last_disk(std::size_t arc, const Coefficients& c)
  {
    const Exact_pair n = m_graph.exact_normal(m_element, 0);
    const auto ratio = rational_square_root(Exact_rational(m_square / (4 * exact_dot(n, n))));
    return ratio && std::any_of(both_ends.begin(), both_ends.end(), [&](bool end) {
      if (!is_own_end_exact(end))
        return false;
      const Exact_pair p = own_end(end), outward = exact_difference(p, own_end(!end)),
                       center{Exact_rational(p[0] + *ratio * n[0]), Exact_rational(p[1] + *ratio * n[1])};
      for (std::size_t i = 0; i < c[2].size(); ++i)
        if (sign_of(exact_dot(outward,
                              Exact_pair{Exact_rational(c[0][i] - center[0] * c[2][i]),
                                         Exact_rational(c[1][i] - center[1] * c[2][i])})) < 0)
          return false;
      const auto touching = touching_ends(arc, sides_of_circle(arc, center, Exact_rational(m_square / 4)));
      if (touching && std::any_of(touching->begin(), touching->end(), [&](const Exact_pair& y) { return y != p; }))
        add_tie_at(end, exact_difference(center, p));
      return touching.has_value();
    });
  }

  bool add_arc_beside_normal_cone(std::size_t index)
  {
    const Site_arc_2<>& arc = m_graph.arcs()[index];
    const Exact_pair& p = m_graph.vertices()[m_element.object].exact_point;
    const std::vector<int> sides = sides_of_circle(index, p, m_square);
    if (!arc.is_straight())
      return !is_on_border(sides) && add_ties(touching_ends(index, sides));
    const Exact_pair a = arc.at(0), d = exact_difference(arc.at(1), a), to_p = exact_difference(p, a);
    const Exact_rational cross = exact_cross(d, to_p), dd = exact_dot(d, d), t = exact_dot(d, to_p) / dd;
    const int side = sign_of(Exact_rational(cross * cross - m_square * dd));
    if (side < 0)
      return add_ties(touching_ends(index, sides));
    if (side > 0 || (t < 0 && m_graph.is_exact({index, false})) || (t > 1 && m_graph.is_exact({index, true})))
      return true;
    return is_certain(index, t, t) &&
        add_ties(t >= 0 && t <= 1 ? Points{{Exact_rational(a[0] + t * d[0]), Exact_rational(a[1] + t * d[1])}}
                                  : Points());
  }

  // Whether an end of an arc that is not known exactly is not between the ends of a range that should be on it, or
  // there is nothing but that range.
  bool is_certain(std::size_t arc, const Exact_rational& first, const Exact_rational& last) const
  {
    return std::all_of(both_ends.begin(), both_ends.end(), [&](bool end) {
      const Exact_rational e = error({arc, end}), t(end ? 1 : 0);
      return m_graph.is_exact({arc, end}) || last < t - e || first > t + e || (first <= t - e && last >= t + e);
    });
  }

  bool add_vertex(std::size_t vertex)
  {
    if (!m_graph.vertices()[vertex].is_exact)
      return false;
    const Exact_pair& q = m_graph.vertices()[vertex].exact_point;
    const auto points = [&](int side) {
      return side < 0 ? std::nullopt : std::optional(side == 0 ? Points{q} : Points());
    };
    if (m_element.is_normal_cone) {
      const Exact_pair d = exact_difference(q, m_graph.vertices()[m_element.object].exact_point);
      return add_ties(points(sign_of(Exact_rational(exact_dot(d, d) - m_square))));
    }
    return std::any_of(m_ends.begin(), m_ends.end(),
                       [&](bool end) { return add_ties(points(side_of_parallel(end, q[0], q[1], 1)), end); });
  }

  // Disks are touched in some points. Returns whether they are known.
  bool add_ties(const std::optional<Points>& points, bool end = false)
  {
    return points && std::all_of(points->begin(), points->end(), [&](const Exact_pair& y) {
             return m_element.is_normal_cone ? add_tie_of_normal_cone(y) : add_tie(y, y, end);
           });
  }

  // The same for all points between two of them, on a parallel.
  bool add_tie(const Exact_pair& y, const Exact_pair& z, bool end)
  {
    return is_segment() ? add_tie_of_segment(y, z) : add_tie_at_end(y, z, end);
  }

  bool add_tie_of_normal_cone(const Exact_pair& y)
  {
    const Exact_pair d = exact_difference(y, m_graph.vertices()[m_element.object].exact_point);
    const auto& [from, to] = m_element.exact_normals;
    // clockwise from the first to the second one
    const Exact_rational a = exact_cross(d, from), b = exact_cross(to, d);
    if (sign_of(a) < 0 || sign_of(b) < 0 || sign_of(Exact_rational(a + b)) == 0 ||
        (sign_of(exact_dot(d, from)) <= 0 && sign_of(exact_dot(d, to)) <= 0))
      return true;
    const Exact_rational u = a / (a + b);
    m_ties.push_back({u, u, half(d)});
    return true;
  }

  static Exact_pair half(const Exact_pair& d) { return {Exact_rational(d[0] / 2), Exact_rational(d[1] / 2)}; }

  bool add_tie_of_segment(const Exact_pair& y, const Exact_pair& z)
  {
    const auto [first, last] = std::minmax({own_arc().parameter_of_foot(y), own_arc().parameter_of_foot(z)});
    if (!is_certain(m_element.object, first, last))
      return false;
    m_ties.push_back({first, last, half(exact_difference(y, own_arc().at(own_arc().parameter_of_foot(y))))});
    return true;
  }

  bool add_tie_at_end(const Exact_pair& y, const Exact_pair& z, bool end)
  {
    const Exact_pair p = own_end(end), n = m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0)),
                     to_y = exact_difference(y, p);
    if (sign_of(exact_cross(n, to_y)) * sign_of(exact_cross(n, exact_difference(z, p))) > 0)
      return true;
    const Exact_rational share = exact_dot(n, to_y) / (2 * exact_dot(n, n));
    add_tie_at(end, {Exact_rational(share * n[0]), Exact_rational(share * n[1])});
    return true;
  }

  void add_tie_at(bool end, const Exact_pair& way)
  {
    const Exact_rational u(end ? 1 : 0);
    m_ties.push_back({u, u, way});
  }

  void unite_ties()
  {
    std::sort(m_ties.begin(), m_ties.end(), [](const Tie& a, const Tie& b) { return a.begin < b.begin; });
    std::vector<Tie> result;
    for (const Tie& tie : m_ties)
      if (!result.empty() && tie.begin <= result.back().end)
        result.back().end = (std::max)(result.back().end, tie.end);
      else
        result.push_back(tie);
    m_ties = std::move(result);
  }

  Exact_disk disk_at(const Exact_rational& u, const Exact_pair& way) const
  {
    return Exact_disk(m_graph.exact_point_at(m_element, u), way);
  }

  Free_end end_at(const Exact_rational& u, const Exact_pair& way) const
  {
    const Interval x = interval_of(u);
    return {Free_end::Kind::TIE, {(std::max)(x.inf(), 0.0), (std::min)(x.sup(), 1.0)}, {}, {}, disk_at(u, way)};
  }

  // Whether a disk touches a vertex, an end of an arc, or a segment. Then the footpoint begins there, as it does so
  // once only where it may.
  bool touches(const Exact_disk& disk, const Disk_footpoint& footpoint) const
  {
    const auto is_touched = [&](std::size_t vertex) {
      return m_graph.vertices()[vertex].is_exact && disk.touches(m_graph.vertices()[vertex].exact_point);
    };
    if (footpoint.kind != Disk_footpoint::Kind::ARC)
      return footpoint.kind == Disk_footpoint::Kind::VERTEX && is_touched(footpoint.index);
    const Site_arc_2<>& arc = m_graph.arcs()[footpoint.index];
    if (std::any_of(both_ends.begin(), both_ends.end(), [&](bool end) {
          return is_touched(m_graph.vertex_of({footpoint.index, end}));
        }))
      return true;
    const Exact_rational foot = arc.is_segment() ? arc.parameter_of_foot(disk.center) : Exact_rational(-1);
    return foot >= 0 && foot <= 1 && disk.touches(arc.at(foot));
  }

  // A tie cuts off what is behind or before it. Where another end is as close as it is known, what is between is not
  // decided.
  void cut(const Free_range& range, const Tie& tie, std::vector<Free_range>& parts, std::vector<Range>& undecided) const
  {
    const Range &first = range[0].location, &last = range[1].location;
    if (tie.end < first.begin || tie.begin > last.end) {
      parts.push_back(range);
      return;
    }
    for (const Free_end& end : range)
      for (const Exact_rational& u : {tie.begin, tie.end})
        if (end.kind != Free_end::Kind::TIE && !end.location.is_number() && u >= end.location.begin &&
            u <= end.location.end && !touches(disk_at(u, tie.way), end.footpoint))
          undecided.push_back(end.location);
    if (tie.begin > first.end)
      parts.push_back({range[0], end_at(tie.begin, tie.way)});
    if (tie.end < last.begin)
      parts.push_back({end_at(tie.end, tie.way), range[1]});
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_OPPOSITE_SITES_H
