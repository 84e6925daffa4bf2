// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_ARRANGEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_ARRANGEMENT_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/polyline_arrangements.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Cell_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/cell_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
The faces of a unit box that curves of solutions leave.

Each piece of a curve becomes chords in its box, as of `to_arrangement()`, and each side of the unit box the chords
between the vertices on it; so the faces of the chords are those of the curves. A point of such a face need not be in
that of the curves, since these pass beside their chords. But where a piece is a graph over a parameter t, on a line t =
const its box has one zero only; so a part of this line with an end in the side of the box and without a zero is beside
the piece on a known side, and within the face of the curves there. In the same way it is within a face if it begins on
a side of the unit box, at a number that is between the vertices there. Curves of several polynomials that were not
multiplied are `Crossing_arcs`.
*/
class Cell_arrangement
{
  using Arrangement = Polyline_arrangement_2;
  using Point = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;
  using Halfedge = Arrangement::Halfedge_const_handle;
  using Range = Surface_cell_3::Range;

  const std::vector<Cell_polynomial>& m_zeros;
  Cell_curves m_curves;
  std::vector<std::vector<Point>> m_polylines; // of the pieces, and behind them of the sides
  std::vector<Surface_border_3> m_border;      // one for each chord of the sides
  bool m_is_proved = true;
  Arrangement m_arrangement;
  std::map<std::pair<std::size_t, std::size_t>, Halfedge> m_halfedges; // along each chord
  std::map<const void*, std::size_t> m_faces;                          // the index of a face

public:
  Cell_arrangement(const std::vector<Cell_polynomial>& zeros, Cell_curves curves)
    : m_zeros(zeros), m_curves(std::move(curves))
  {
    for (const Cell_curves::Piece& own : m_curves.pieces) {
      auto& polyline = m_polylines.emplace_back();
      for (const std::vector<double>& p : own.points)
        polyline.emplace_back(p[0], p[1]);
    }
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        add_side(axis, side);
    check_points();
    m_arrangement = Regions::polyline_arrangement<Arrangement>(m_polylines);
    m_is_proved = m_is_proved && Regions::is_crossing_free(m_arrangement, m_polylines);
    if (m_is_proved)
      number_halfedges_and_faces();
  }

  // The faces, or none if one is not proved. For faces without a part of the sides, points of pieces are asked for, if
  // the boxes of pieces hold no others.
  std::optional<Cell_faces> faces(const Point_on_piece& point_on_piece, const Operation_budget& budget)
  {
    if (!m_is_proved)
      return std::nullopt;
    Cell_faces result = faces_without_samples();
    std::vector<bool> has_sample(result.faces.size(), false);
    add_samples_on_border(result, has_sample);
    if (point_on_piece)
      add_samples_beside_pieces(result, has_sample, point_on_piece, budget);
    else if (each_has_one_arc())
      while (add_samples_between_arcs(result, has_sample)) {
      }
    if (std::find(has_sample.begin(), has_sample.end(), false) != has_sample.end())
      return std::nullopt;
    result.borders = std::move(m_border);
    return result;
  }

  // The faces of curves for which points beside each piece are known, to its left and to its right; none if one is not
  // proved.
  std::optional<Cell_faces> faces(const std::vector<std::array<Parameters, 2>>& beside_pieces)
  {
    if (!m_is_proved)
      return std::nullopt;
    Cell_faces result = faces_without_samples();
    std::vector<bool> has_sample(result.faces.size(), false);
    for (std::size_t k = 0; k < beside_pieces.size(); ++k) {
      const Halfedge along = m_halfedges.at({k, 0});
      for (const std::size_t side : {0, 1}) {
        const std::size_t face = index_of(side == 0 ? along->face() : along->twin()->face());
        result.faces[face].sample = beside_pieces[k][side];
        has_sample[face] = true;
      }
    }
    if (std::find(has_sample.begin(), has_sample.end(), false) != has_sample.end())
      return std::nullopt;
    result.borders = std::move(m_border);
    return result;
  }

private:
  Cell_faces faces_without_samples() const
  {
    Cell_faces result;
    result.faces.resize(m_faces.size());
    for (auto face = m_arrangement.faces_begin(); face != m_arrangement.faces_end(); ++face)
      if (!face->is_unbounded())
        result.faces[index_of(face)].loops = loops_of(face);
    return result;
  }

  // The side between its corners and the vertices on it.
  void add_side(int axis, int side)
  {
    const std::size_t other = static_cast<std::size_t>(1 - axis);
    const Range here{side, side};
    std::set<std::size_t> vertices;
    for (const Cell_curves::Piece& own : m_curves.pieces)
      for (const std::size_t v : own.piece.ends)
        if (m_curves.vertices[v].box[static_cast<std::size_t>(axis)] == here)
          vertices.insert(v);
    std::vector<std::pair<Range, double>> places{{{0, 0}, 0}, {{1, 1}, 1}};
    for (const std::size_t v : vertices)
      if (const Range& range = m_curves.vertices[v].box[other]; range != places[0].first && range != places[1].first)
        places.emplace_back(range, m_curves.vertices[v].point()[other]);
    std::sort(places.begin(), places.end());
    auto& polyline = m_polylines.emplace_back();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double at = places[i].second;
      polyline.push_back(axis == 0 ? Point(side, at) : Point(at, side));
      if (i == 0)
        continue;
      m_is_proved = m_is_proved && places[i - 1].first.second < places[i].first.first;
      m_border.push_back({0, axis, side, {places[i - 1].first.second, places[i].first.first}});
    }
  }

  // Rounding must not have united points.
  void check_points()
  {
    std::map<Point, std::size_t> vertex_at;
    std::size_t number_of_inner_points = 0;
    std::set<Point> points;
    for (std::size_t k = 0; k < m_polylines.size(); ++k) {
      const std::vector<Point>& polyline = m_polylines[k];
      points.insert(polyline.begin(), polyline.end());
      if (k >= m_curves.pieces.size())
        continue;
      number_of_inner_points += polyline.size() - 2;
      for (const int i : {0, 1})
        if (const std::size_t v = m_curves.pieces[k].piece.ends[static_cast<std::size_t>(i)];
            vertex_at.emplace(i == 0 ? polyline.front() : polyline.back(), v).first->second != v)
          m_is_proved = false;
    }
    std::size_t corners = 0;
    for (const int x : {0, 1})
      for (const int y : {0, 1})
        corners += vertex_at.count(Point(x, y)) == 0;
    m_is_proved = m_is_proved &&
        points.size() + m_curves.number_of_crossings == vertex_at.size() + number_of_inner_points + corners;
  }

  void number_halfedges_and_faces()
  {
    for (auto face = m_arrangement.faces_begin(); face != m_arrangement.faces_end(); ++face)
      if (!face->is_unbounded())
        m_faces.emplace(&*face, m_faces.size());
    for (auto edge = m_arrangement.edges_begin(); edge != m_arrangement.edges_end(); ++edge) {
      const Chord_label label = *edge->curve().data().begin();
      const bool is_along = edge->source()->point() == m_polylines[label.curve][label.chord];
      const Halfedge halfedge = edge;
      m_halfedges.emplace(std::pair(label.curve, label.chord), is_along ? halfedge : halfedge->twin());
    }
    std::size_t interval = 0;
    for (std::size_t k = m_curves.pieces.size(); k < m_polylines.size(); ++k)
      for (std::size_t chord = 0; chord + 1 < m_polylines[k].size(); ++chord) {
        const Halfedge halfedge = m_halfedges.at({k, chord});
        m_border[interval++].face =
            index_of(halfedge->face()->is_unbounded() ? halfedge->twin()->face() : halfedge->face());
      }
  }

  std::size_t index_of(Arrangement::Face_const_handle face) const { return m_faces.at(&*face); }

  std::vector<std::vector<Surface_face_edge_3>> loops_of(Arrangement::Face_const_handle face) const
  {
    std::vector<std::vector<Surface_face_edge_3>> result;
    const auto add_loop = [&](Arrangement::Ccb_halfedge_const_circulator first) {
      auto& loop = result.emplace_back();
      auto edge = first;
      do {
        const Point& p = edge->source()->point();
        const Arrangement::Face_const_handle beyond = edge->twin()->face();
        loop.push_back({{Exact_rational(CGAL::to_double(p.x())), Exact_rational(CGAL::to_double(p.y()))},
                        beyond->is_unbounded() ? std::nullopt : std::optional(index_of(beyond))});
      } while (++edge != first);
    };
    for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer)
      add_loop(*outer);
    for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner)
      add_loop(*inner);
    return result;
  }

  // Straight into the box from a point that is between the vertices of a side.
  void add_samples_on_border(Cell_faces& result, std::vector<bool>& has_sample) const
  {
    for (const Surface_border_3& interval : m_border) {
      if (has_sample[interval.face])
        continue;
      const Exact_rational at = simple_number_between(interval.range);
      const Exact_rational end(interval.side);
      for (const int k : {1, 2, 4, 8, 16, 32, 50}) {
        const Exact_rational inside =
            interval.side == 0 ? inverse_power_of_two(k) : Exact_rational(1 - inverse_power_of_two(k));
        if (!has_no_zeros(1 - interval.axis, at, (std::min)(inside, end), (std::max)(inside, end)))
          continue;
        set_sample(result.faces[interval.face], interval.axis, inside, at);
        has_sample[interval.face] = true;
        break;
      }
    }
  }

  // On a line where the parameter of an axis is constant, between two numbers.
  bool has_no_zeros(int axis, const Exact_rational& at, const Exact_rational& begin, const Exact_rational& end) const
  {
    return std::ranges::all_of(
        m_zeros, [&](const Cell_polynomial& f) { return has_no_zero(slice_of(f, axis, at), begin, end); });
  }

  static void set_sample(Surface_face_3& face, int axis, const Exact_rational& value, const Exact_rational& other)
  {
    face.sample[static_cast<std::size_t>(axis)] = value;
    face.sample[static_cast<std::size_t>(1 - axis)] = other;
  }

  void add_samples_beside_pieces(Cell_faces& result, std::vector<bool>& has_sample,
                                 const Point_on_piece& point_on_piece, const Operation_budget& budget) const
  {
    for (std::size_t k = 0; k < m_curves.pieces.size(); ++k) {
      if (m_curves.pieces[k].piece.parameter < 0)
        continue;
      const std::size_t chord = (m_polylines[k].size() - 1) / 2;
      const Halfedge along = m_halfedges.at({k, chord});
      const std::array<std::size_t, 2> faces{index_of(along->face()), index_of(along->twin()->face())};
      if (has_sample[faces[0]] && has_sample[faces[1]])
        continue;
      budget.check();
      const std::size_t parameter = static_cast<std::size_t>(m_curves.pieces[k].piece.parameter);
      const auto coordinate = [&](std::size_t i, std::size_t axis) {
        return CGAL::to_double(m_polylines[k][chord + i][static_cast<int>(axis)]);
      };
      const std::vector<double> middle{0.5 * (coordinate(0, 0) + coordinate(1, 0)),
                                       0.5 * (coordinate(0, 1) + coordinate(1, 1))};
      if (!is_between_ends(m_curves.pieces[k].piece, middle[parameter]))
        continue;
      const std::vector<double> point = point_on_piece(m_curves.pieces[k].piece, middle);
      const bool is_increasing = coordinate(0, parameter) < coordinate(1, parameter);
      for (const int side : {0, 1}) {
        // To the left of increasing u is greater v, to the left of increasing v is less u.
        const bool is_left = (side == 1) == (is_increasing == (parameter == 0));
        const std::size_t face = faces[is_left ? 0 : 1];
        if (has_sample[face])
          continue;
        const std::optional<Exact_rational> value = value_beside(m_curves.pieces[k].piece, point, side);
        if (!value)
          continue;
        set_sample(result.faces[face], 1 - static_cast<int>(parameter), *value, Exact_rational(point[parameter]));
        has_sample[face] = true;
      }
    }
  }

  // Whether each polynomial has one curve at most, a simple one, so that its sign tells the sides of this.
  bool each_has_one_arc() const
  {
    std::map<std::size_t, std::size_t> curve_of;
    return std::ranges::all_of(m_curves.pieces, [&](const Cell_curves::Piece& own) {
      return own.piece.multiplicity == 1 && curve_of.emplace(own.polynomial, own.curve).first->second == own.curve;
    });
  }

  std::vector<CGAL::Sign> signs_at(const Parameters& p) const
  {
    std::vector<CGAL::Sign> result;
    for (const Cell_polynomial& f : m_zeros)
      result.push_back(CGAL::sign(f(p)));
    return result;
  }

  // Arcs of which each two cross once at most have one face for each combination of their sides: beyond an arc from a
  // face with a sample, its polynomial alone has the other sign. Whether there is a new sample.
  bool add_samples_between_arcs(Cell_faces& result, std::vector<bool>& has_sample) const
  {
    bool is_new = false;
    for (const auto& [chord, along] : m_halfedges)
      for (const Halfedge& halfedge : {along, Halfedge(along->twin())}) {
        if (chord.first >= m_curves.pieces.size())
          continue;
        const std::size_t known = index_of(halfedge->face()), face = index_of(halfedge->twin()->face());
        if (!has_sample[known] || has_sample[face])
          continue;
        std::vector<CGAL::Sign> signs = signs_at(result.faces[known].sample);
        CGAL::Sign& changed = signs[m_curves.pieces[chord.first].polynomial];
        changed = CGAL::opposite(changed);
        const std::vector<Surface_face_edge_3>& loop = result.faces[face].loops.front();
        Parameters middle{0, 0};
        for (const Surface_face_edge_3& edge : loop)
          for (const int axis : {0, 1})
            middle[static_cast<std::size_t>(axis)] += edge.source.cartesian(axis) / static_cast<int>(loop.size());
        if (signs_at(middle) != signs)
          continue;
        result.faces[face].sample = middle;
        has_sample[face] = is_new = true;
      }
    return is_new;
  }

  // Whether a parameter is certainly between those of the two ends of a piece.
  bool is_between_ends(const Curve_piece& piece, double t) const
  {
    const std::size_t parameter = static_cast<std::size_t>(piece.parameter);
    Range first = m_curves.vertices[piece.ends[0]].box[parameter],
          last = m_curves.vertices[piece.ends[1]].box[parameter];
    if (last < first)
      std::swap(first, last);
    return first.second < Exact_rational(t) && Exact_rational(t) < last.first;
  }

  // On the line through a point of the piece, another one towards the lower or upper side of its box, with the piece on
  // the other side of it.
  std::optional<Exact_rational> value_beside(const Curve_piece& piece, const std::vector<double>& point, int side) const
  {
    const std::size_t parameter = static_cast<std::size_t>(piece.parameter), other = 1 - parameter;
    const Exact_rational near(point[other]), end = side == 0 ? piece.box[other].first : piece.box[other].second;
    if (side == 0 ? !(end < near) : !(near < end))
      return std::nullopt;
    for (const int k : {1, 2, 4, 8, 16, 32}) {
      const Exact_rational value(near + (end - near) * inverse_power_of_two(k));
      if (has_no_zeros(piece.parameter, Exact_rational(point[parameter]), (std::min)(value, end),
                       (std::max)(value, end)))
        return value;
    }
    return std::nullopt;
  }
};

// Why the faces of a cell are not known: all of it is undecided.
inline Cell_faces without_faces(const std::string& reason)
{
  Cell_faces result;
  result.undecided.push_back({{{0, 1}, {0, 1}}, {}, reason});
  return result;
}

inline Cell_faces proved_faces(std::optional<Cell_faces> faces, std::vector<Cell_polynomial> zeros)
{
  if (!faces)
    return without_faces("curves or points are not told apart");
  faces->zeros = std::move(zeros);
  return std::move(*faces);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Cell_faces faces_of_arcs(const std::vector<Cell_polynomial>& zeros, double error,
                                                        Operation_budget& budget)
{
  std::optional<Cell_curves> arcs = Crossing_arcs(error, budget)(zeros);
  budget.check();
  return proved_faces(arcs ? Cell_arrangement(zeros, std::move(*arcs)).faces({}, budget) : std::nullopt, zeros);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Cell_faces faces_of_product(const std::vector<Cell_polynomial>& zeros, double error,
                                                           Operation_budget& budget)
{
  const std::vector<Cell_polynomial> product{product_of(zeros)};
  const Constraint_system_d system = system_of_zeros(product);
  const Curve_solution_set_d set =
      zeros.empty() ? Curve_solution_set_d({}, {}, {}, {}, {}, Summary()) : curves_within_budget(system, budget, {});
  if (!set.is_complete()) {
    Cell_faces result;
    result.undecided = set.undecided();
    return result.undecided.empty() ? without_faces(in_words(set.summary().why_not)) : result;
  }
  budget.check();
  Cell_curves curves;
  curves.add(system, set, error, budget);
  return proved_faces(Cell_arrangement(product, std::move(curves)).faces(points_on_pieces(system), budget), product);
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_ARRANGEMENT_H
