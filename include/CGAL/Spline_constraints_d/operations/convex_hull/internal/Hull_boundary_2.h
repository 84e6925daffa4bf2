// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_BOUNDARY_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_chain_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_contacts_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_supports_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

/*
The convex hull of pieces of curves and points, by polygons in it that grow. All numbers are exact.

The polygon is the hull of the ends of pieces. A piece with all control points in the polygon is in the hull anyway. A
vertex is *supported* if a line through it has all on its left: a point of the boundary of the hull. Between two
supported vertices that follow each other, the boundary is a chain of pieces if these are convex and all others are in
the polygon; or part of a chain, a segment that touches it, and part of another chain, if two convex chains are not and
are in order in all directions between those of the two lines. Otherwise the pieces that are not in the polygon there
are halved.
*/
class Hull_boundary_2
{
  static constexpr int halvings_between_proofs = 6, most_halvings = 64;   // of one piece

  using Edges = std::vector<Hull_edge_2>;

  // The vertices of the polygon from one that is supported to the next one, with indices that may go around, and the
  // pieces that are not in the polygon there.
  struct Part
  {
    std::size_t first, last;
    std::vector<std::size_t> pieces;
  };

  // Parameters where pieces are cut.
  using Cuts = std::map<std::size_t, std::set<Exact_rational>>;

  Run_of_steps& m_run;
  Hull_contacts_2 m_contacts;
  std::vector<Hull_piece_2> m_pieces;
  // of all pieces; in each round where they overlap, all must be halved
  std::size_t m_halvings_left = 0;
  std::map<Exact_pair, Boundary_vertex_2> m_points;       // whose hull is the polygon
  std::set<Exact_pair> m_covered;                      // points on pieces that are not ends of these
  Hull_polygon_2 m_polygon;
  Hull_supports_2 m_supports;
  std::map<std::array<Exact_pair, 2>, Edges> m_parts;  // of the boundary, between supported vertices
  Edges m_edges;
  std::vector<Undecided_part> m_undecided;

public:
  // When the run ends, the edges are those of the last round.
  // \throws Run_stopped before there are any
  Hull_boundary_2(const std::vector<Hull_chain>& curves, std::map<Exact_pair, Boundary_vertex_2> points,
                  Run_of_steps& run)
    : m_run(run), m_contacts(run), m_points(std::move(points))
  {
    try {
      for (const Hull_chain& curve : curves)
        for (const Hull_piece_2& piece : curve)
          add(piece);
      m_halvings_left = 1000 + 300 * m_pieces.size();
      do {
        make_polygon();
        m_pieces = m_polygon.pieces_outside(std::move(m_pieces), m_run);
        m_supports.add(m_polygon, m_pieces, m_run);
      } while (make_edges());
    } catch (const Run_stopped& stop) {
      if (m_edges.empty())
        throw;
      for (Undecided_part& part : m_undecided)
        part.reason = in_words(stop.reason);
    }
  }

  const Edges& edges() const { return m_edges; }
  const std::vector<Exact_pair>& polygon() const { return m_polygon.vertices(); }

  // Parts of the boundary where edges are undecided.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

private:
  // Unless it is there.
  void add(Hull_piece_2 piece)
  {
    m_run.check();
    const Hull_piece_2 reversed = piece.reversed();
    if (std::any_of(m_pieces.begin(), m_pieces.end(),
                    [&](const Hull_piece_2& other) { return piece.is_same(other) || reversed.is_same(other); }))
      return;
    const Boundary_piece& curve = piece.curve();
    for (std::size_t k = 0; k < 2; ++k)
      m_points.try_emplace(k == 0 ? piece.begin() : piece.end(),
                           Boundary_vertex_2{curve.curve, {curve.parameters[k], curve.parameters[k]}});
    if (piece.points().size() > 1)   // else it is a point
      m_pieces.push_back(std::move(piece));
  }

  void make_polygon()
  {
    std::vector<Exact_kernel::Point_2> points;
    for (const auto& [point, place] : m_points)
      if (m_covered.count(point) == 0)
        points.emplace_back(point[0], point[1]);
    m_polygon = Hull_polygon_2(points);
    std::map<Exact_pair, Boundary_vertex_2> vertices;
    for (const Exact_pair& vertex : m_polygon.vertices())
      vertices.insert(*m_points.find(vertex));
    m_points = std::move(vertices);
  }

  // The edges between supported vertices; false when they are final, true when pieces were halved or dropped.
  bool make_edges()
  {
    Edges all;
    std::vector<Undecided_part> undecided;
    std::set<std::size_t> to_drop;
    Cuts cuts;
    const std::size_t covered = m_covered.size();
    for (const Part& part : parts()) {
      const std::array<Exact_pair, 2> ends{m_polygon.vertex(part.first), m_polygon.vertex(part.last)};
      auto known = m_parts.find(ends);
      if (known == m_parts.end())
        if (std::optional<Edges> edges = edges_of(part))
          known = m_parts.emplace(ends, std::move(*edges)).first;
      if (known != m_parts.end())
        all.insert(all.end(), known->second.begin(), known->second.end());
      else {
        append_segments(part, Hull_edge_kind::UNDECIDED, all);
        undecided.push_back(undecided_part(part));
        if (!m_run.must_stop() && part.pieces.size() <= m_halvings_left &&
            !decide_otherwise(part, to_drop, cuts))
          for (std::size_t i : part.pieces)
            if (m_pieces[i].halvings() < most_halvings)
              cuts[i].insert(one_half());
      }
    }
    m_edges = std::move(all);
    m_undecided = std::move(undecided);
    if (cuts.empty() && to_drop.empty() && covered == m_covered.size())
      return false;
    std::vector<Hull_piece_2> pieces = std::move(m_pieces);
    m_pieces.clear();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (to_drop.count(i) > 0)
        continue;
      else if (cuts.count(i) == 0)
        m_pieces.push_back(std::move(pieces[i]));
      else {
        for (Hull_piece_2& part : pieces[i].parts(cuts.at(i)))
          add(std::move(part));
        m_halvings_left -= (std::min)(m_halvings_left, cuts.at(i).size());
      }
    return true;
  }

  std::vector<Part> parts() const
  {
    std::vector<std::size_t> supported;
    for (std::size_t i = 0; i < m_polygon.size(); ++i)
      if (m_supports.hold(m_polygon.vertex(i)))
        supported.push_back(i);
    if (supported.empty())
      supported.push_back(0);
    std::vector<Part> result;
    for (std::size_t i = 0; i < supported.size(); ++i) {
      Part part{supported[i], i + 1 < supported.size() ? supported[i + 1] : supported[0] + m_polygon.size(), {}};
      std::set<std::size_t> pieces;
      for (std::size_t edge = part.first; edge < part.last; ++edge)
        pieces.insert(m_polygon.beyond(edge).begin(), m_polygon.beyond(edge).end());
      part.pieces.assign(pieces.begin(), pieces.end());
      result.push_back(std::move(part));
    }
    return result;
  }

  // The boundary is within the hull of the vertices and of the pieces that are not in the polygon there.
  Undecided_part undecided_part(const Part& part) const
  {
    std::vector<Undecided_part::Range> box;
    std::vector<Undecided_part::Parameters> parameters;
    for (std::size_t i = part.first; i <= part.last; ++i) {
      const auto& [x, y] = m_polygon.vertex(i);
      box = united_box(std::move(box), {to_double_interval(x), to_double_interval(y)});
    }
    for (const std::size_t i : part.pieces) {
      const Boundary_piece& piece = m_pieces[i].curve();
      box = united_box(std::move(box), piece.box());
      const auto& [begin, end] = std::minmax(piece.parameters[0], piece.parameters[1]);
      parameters.push_back({piece.curve, {{to_double_interval(begin).first, to_double_interval(end).second}}});
    }
    return {std::move(box), std::move(parameters),
            m_run.is_stopped() ? in_words(m_run.reason()) : "what touches the boundary is not told apart"};
  }

  void append_segments(const Part& part, Hull_edge_kind kind, Edges& edges) const
  {
    for (std::size_t i = part.first; i < part.last; ++i)
      edges.push_back({kind, m_points.at(m_polygon.vertex(i)), m_points.at(m_polygon.vertex(i + 1))});
  }

  std::optional<Edges> edges_of(const Part& part)
  {
    Edges result;
    if (part.pieces.empty()) {
      append_segments(part, Hull_edge_kind::SEGMENT, result);
      return result;
    }
    std::vector<std::size_t> rest = part.pieces;
    const Hull_chain first = chain_from(m_polygon.vertex(part.first), rest);
    if (rest.empty() && !first.empty() && first.back().end() == m_polygon.vertex(part.last)) {
      if (!is_convex(first) || !has_vertices(part, first, {}))
        return std::nullopt;
      append_arcs(first, result);
      return result;
    }
    const Hull_chain second = reversed(chain_from(m_polygon.vertex(part.last), rest));
    if (!rest.empty() || !is_convex(first) || !is_convex(second) || !has_vertices(part, first, second) ||
        !are_in_order(part, first, second))
      return std::nullopt;
    return edges_with_segment(part, first, second);
  }

  // The pieces that follow each other from a point on, taken out of a list.
  Hull_chain chain_from(Exact_pair point, std::vector<std::size_t>& pieces) const
  {
    Hull_chain result;
    for (auto i = pieces.begin(); i != pieces.end();) {
      if (i == pieces.begin())
        m_run.check();
      const Hull_piece_2& piece = m_pieces[*i];
      if (piece.begin() == point || piece.end() == point) {
        result.push_back(piece.begin() == point ? piece : piece.reversed());
        point = result.back().end();
        pieces.erase(i);
        i = pieces.begin();
      } else
        ++i;
    }
    return result;
  }

  // Whether all vertices of the polygon in a part are ends of pieces of chains.
  bool has_vertices(const Part& part, const Hull_chain& first, const Hull_chain& second) const
  {
    for (std::size_t i = part.first + 1; i < part.last; ++i)
      if (!has_end(first, m_polygon.vertex(i)) && !has_end(second, m_polygon.vertex(i)))
        return false;
    return true;
  }

  // Whether all points of the second chain are further than those of the first one along all lines with directions
  // between the two supporting ones: then there is exactly one at which the higher chain changes.
  bool are_in_order(const Part& part, const Hull_chain& first, const Hull_chain& second) const
  {
    const Exact_pair &before = m_supports.normals(m_polygon.vertex(part.first))[1],
                     &after = m_supports.normals(m_polygon.vertex(part.last))[0];
    const std::vector<Exact_pair> a = points_of(first, m_polygon.vertex(part.first)),
                                  b = points_of(second, m_polygon.vertex(part.last));
    return exact_cross(before, after) > 0 && have_order(a, b, before) && have_order(a, b, after);
  }

  // Arcs up to the contact of the common tangent with the first chain, and from that with the second one on.
  std::optional<Edges> edges_with_segment(const Part& part, const Hull_chain& first, const Hull_chain& second)
  {
    for (const Hull_contact_operand& a : operands(first, m_polygon.vertex(part.first)))
      for (const Hull_contact_operand& b : operands(second, m_polygon.vertex(part.last)))
        if (const auto contacts = m_contacts.common_tangent(a, b)) {
          const Boundary_vertex_2 source =
              a.piece != nullptr ? vertex_on(*a.piece, contacts->front()) : m_points.at(a.point);
          const Boundary_vertex_2 target =
              b.piece != nullptr ? vertex_on(*b.piece, contacts->back()) : m_points.at(b.point);
          Edges result;
          if (a.piece != nullptr) {
            append_arcs({first.data(), a.piece}, result);
            result.push_back({Hull_edge_kind::ARC, vertex_on(*a.piece, {0, 0}), source});
          }
          result.push_back({Hull_edge_kind::SEGMENT, source, target});
          if (b.piece != nullptr) {
            result.push_back({Hull_edge_kind::ARC, target, vertex_on(*b.piece, {1, 1})});
            append_arcs({b.piece + 1, second.data() + second.size()}, result);
          }
          return result;
        }
    return std::nullopt;
  }

  /*
  Where halving does not help: what touches the boundary from within is proved to, and left out; pieces are cut at
  cusps, and where overlaps end. Whether there was anything.
  */
  bool decide_otherwise(const Part& part, std::set<std::size_t>& dropped, Cuts& cuts)
  {
    const int halvings = least_halvings(part);
    if (halvings == 0 || halvings % halvings_between_proofs != 0)
      return false;
    return cut_at_singularities(part, cuts) || cut_where_pieces_overlap(part, cuts) ||
        cover_points_behind_pieces(part) || drop_pieces_behind_others(part, dropped) ||
        leave_out_what_touches_segment(part, dropped);
  }

  bool cut_at_singularities(const Part& part, Cuts& cuts)
  {
    const std::size_t cut_before = cuts.size();
    for (std::size_t i : part.pieces)
      if (const auto t = m_contacts.rational_singularity(m_pieces[i]))
        cuts[i].insert(*t);
    return cuts.size() > cut_before;
  }

  // At the ends of overlaps: pieces that are the same count once.
  bool cut_where_pieces_overlap(const Part& part, Cuts& cuts)
  {
    const std::size_t cut_before = cuts.size();
    for (std::size_t k = 0; k < part.pieces.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (const auto overlap = m_contacts.overlap(m_pieces[part.pieces[k]], m_pieces[part.pieces[l]]))
          for (const std::size_t side : {0, 1})
            for (const Exact_rational& end : {(*overlap)[side].first, (*overlap)[side].second})
              if (end > 0 && end < 1)
                cuts[part.pieces[side == 0 ? k : l]].insert(end);
    return cuts.size() > cut_before;
  }

  int least_halvings(const Part& part) const
  {
    int result = most_halvings;
    for (std::size_t i : part.pieces)
      result = (std::min)(result, m_pieces[i].halvings());
    return result;
  }

  // Vertices that are points of a piece between vertices, or between it and its chord.
  bool cover_points_behind_pieces(const Part& part)
  {
    bool result = false;
    const auto is_vertex = [&](const Exact_pair& point) {
      return m_points.count(point) > 0 && m_covered.count(point) == 0;
    };
    for (std::size_t i = part.first + 1; i < part.last; ++i)
      for (std::size_t k : part.pieces) {
        const Hull_piece_2& piece = m_pieces[k];
        if (is_vertex(piece.begin()) && is_vertex(piece.end()) && m_polygon.vertex(i) != piece.begin() &&
            m_polygon.vertex(i) != piece.end() &&
            (m_contacts.has_point({piece}, m_polygon.vertex(i)) || is_between_chord_and({piece}, m_polygon.vertex(i)) ||
             is_between_chord_and({piece.reversed()}, m_polygon.vertex(i))))
          result |= m_covered.insert(m_polygon.vertex(i)).second;
      }
    return result;
  }

  // Whether a point on the right of the chord of a convex chain is on its side of the chain: nothing is in the way to
  // the middle of the chord.
  bool is_between_chord_and(const Hull_chain& chain, const Exact_pair& point) const
  {
    const Exact_pair &first = chain.front().begin(), &last = chain.back().end(), both = sum(first, last);
    return exact_cross(exact_difference(last, first), exact_difference(point, first)) < 0 && is_convex(chain) &&
        m_contacts.is_apart_from_segment(chain, {point, {Exact_rational(both[0] / 2), Exact_rational(both[1] / 2)}});
  }

  // A piece that begins and ends in the polygon, or behind a convex chain above edges of it, cannot get out there if it
  // has only one common point with the chain.
  bool drop_pieces_behind_others(const Part& part, std::set<std::size_t>& dropped)
  {
    const std::size_t dropped_before = dropped.size();
    for (std::size_t i : part.pieces)
      if (dropped.count(i) == 0)
        if (const Hull_chain chain = chain_above(part, i, dropped); !chain.empty() &&
            begins_and_ends_behind(m_pieces[i], chain) && m_contacts.meet_once_or_overlap(m_pieces[i], chain))
          dropped.insert(i);
    return dropped.size() > dropped_before;
  }

  // The convex chain of others, each above one edge from vertex to vertex, above the edges of a part that a piece is
  // beyond, if it is not beyond any others.
  Hull_chain chain_above(const Part& part, std::size_t piece, const std::set<std::size_t>& dropped) const
  {
    std::size_t first = part.first, last = part.last;
    while (first < last && m_polygon.is_beyond_only(piece, first + 1, last))
      ++first;
    while (first < last && m_polygon.is_beyond_only(piece, first, last - 1))
      --last;
    Hull_chain result;
    for (std::size_t edge = first; edge < last; ++edge)
      for (std::size_t k : m_polygon.beyond(edge))
        if (const Hull_piece_2 other =
                m_pieces[k].begin() == m_polygon.vertex(edge) ? m_pieces[k] : m_pieces[k].reversed();
            k != piece && dropped.count(k) == 0 && other.begin() == m_polygon.vertex(edge) &&
            other.end() == m_polygon.vertex(edge + 1) && m_polygon.is_beyond_only(k, edge, edge + 1)) {
          result.push_back(other);
          break;
        }
    const bool is_above = result.size() == last - first && m_polygon.is_beyond_only(piece, first, last);
    return is_above && is_convex(result) ? result : Hull_chain();
  }

  // Ends are in the polygon, or points of a chain, or between it and its chord.
  bool begins_and_ends_behind(const Hull_piece_2& piece, const Hull_chain& chain) const
  {
    const Exact_pair &first = chain.front().begin(), &last = chain.back().end();
    const auto is_behind = [&](const Exact_pair& end) {
      return exact_cross(exact_difference(last, first), exact_difference(end, first)) >= 0 ||
          m_contacts.has_point(chain, end) || is_between_chord_and(chain, end);
    };
    return is_behind(piece.begin()) && is_behind(piece.end());
  }

  // Convex pieces, and vertices, between two chains that touch the segment that touches both of these.
  bool leave_out_what_touches_segment(const Part& part, std::set<std::size_t>& dropped)
  {
    std::vector<std::size_t> rest = part.pieces;
    const Hull_chain first = chain_from(m_polygon.vertex(part.first), rest),
                     second = reversed(chain_from(m_polygon.vertex(part.last), rest));
    if (!is_convex(first) || !is_convex(second))
      return false;
    bool result = false;
    for (std::size_t i : rest)
      for (const Hull_piece_2& piece : {m_pieces[i], m_pieces[i].reversed()})
        if (is_convex({piece}) && m_polygon.is_beyond_only(i, part.first, part.last) &&
            are_in_order(part, first, {piece}) && are_in_order(part, {piece}, second) &&
            have_common_tangent(part, first, {&piece, {}}, second)) {
          dropped.insert(i);
          m_covered.insert({piece.begin(), piece.end()});
          result = true;
        }
    for (std::size_t i = part.first + 1; i < part.last; ++i)
      if (!first.empty() || !second.empty())
        if (!has_end(first, m_polygon.vertex(i)) && !has_end(second, m_polygon.vertex(i)) &&
            have_common_tangent(part, first, {nullptr, m_polygon.vertex(i)}, second))
          result |= m_covered.insert(m_polygon.vertex(i)).second;
    return result;
  }

  bool have_common_tangent(const Part& part, const Hull_chain& first, const Hull_contact_operand& between,
                           const Hull_chain& second)
  {
    for (const Hull_contact_operand& a : operands(first, m_polygon.vertex(part.first)))
      for (const Hull_contact_operand& b : operands(second, m_polygon.vertex(part.last)))
        if (m_contacts.have_common_tangent(a, between, b))
          return true;
    return false;
  }
};

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_BOUNDARY_2_H
