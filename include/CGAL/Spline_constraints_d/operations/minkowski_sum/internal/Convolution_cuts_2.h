// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_CUTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_CUTS_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Chord_cone_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Convolution_graph_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Crossing_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_interior_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Vertex_classes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
The pieces of a convolution, cut where they cross, touch, or end in others. Outside of the cuts they have nothing in
common, but inside of the sum.

Crossings are found with intervals of doubles. Where these do not tell, rational points are tried first, and then the
level above doubles.
*/
class Convolution_cuts_2
{
public:
  // A part of a piece where it meets others, with the number of the vertex.
  struct Cut
  {
    Range range;
    std::size_t vertex;
    bool is_certain;
  };

private:
  static constexpr int most_rounds = 6;

  // Two pieces that meet.
  struct Meeting
  {
    std::array<std::size_t, 2> pieces;
    std::vector<Crossing_2> crossings;
    bool is_fine;   // whether these are found on the level above doubles
  };

  const Sum_interior_2& m_interior;
  Run_of_steps& m_control;
  Convolution_graph_2 m_graph;
  std::vector<Traced_curve_2> m_curves;   // of the pieces
  std::vector<Meeting> m_meetings;
  std::vector<std::vector<Cut>> m_cuts;   // of each piece, in order
  Vertex_classes m_vertices{0};

public:
  // \throws Run_stopped
  Convolution_cuts_2(const std::vector<Convolution_piece_2>& pieces, const Sum_interior_2& interior,
                     Run_of_steps& control)
    : m_interior(interior), m_control(control), m_graph(pieces, control)
  {
    find_meetings();
    make_cuts();
    for (int round = 0; round < most_rounds; ++round) {
      if (m_graph.split_at(possible_vertices(), m_control))
        find_meetings();
      else if (!refine_meetings())
        break;
      make_cuts();
    }
  }

  const std::vector<Convolution_piece_2>& pieces() const { return m_graph.pieces(); }
  const std::vector<Traced_curve_2>& curves() const { return m_curves; }
  const std::vector<Cut>& cuts(std::size_t piece) const { return m_cuts[piece]; }
  std::size_t vertex(const Cut& cut) const { return m_vertices.of(cut.vertex); }

  // A part of a piece, and a box around it, where it is not decided how the piece meets others, and that is not inside
  // of the sum.
  struct Uncertain_part
  {
    std::size_t piece;
    Range range;
    Interval_pair box;
  };

  // \throws Run_stopped
  std::vector<Uncertain_part> undecided() const
  {
    std::vector<Uncertain_part> result;
    for_each_uncertain_cut([&](std::size_t piece, const Cut& cut, const Interval_pair& box) {
      result.push_back({piece, cut.range, box});
    });
    return result;
  }

private:
  bool is_inside(const Interval_pair& box) const { return CGAL::certainly(m_interior.contains(box, m_control)); }

  void find_meetings()
  {
    m_curves.clear();
    for (const Convolution_piece_2& piece : m_graph.pieces())
      m_curves.emplace_back([&piece](const Range& range) { return piece(range); }, piece.range(), piece.inner_range(),
                            [&piece](double t) { return piece.fine_point(t); });
    m_meetings.clear();
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      m_control.check();
      for (std::size_t j = i + 1; j < m_curves.size(); ++j)
        if (may_meet(m_curves[i].whole().box(), m_curves[j].whole().box()) && !meet_only_in_common_end(i, j) &&
            !go_on_over_inflection(i, j) && !go_on_over_inflection(j, i))
          if (std::vector<Crossing_2> crossings = crossings_of<Interval>(i, j); !crossings.empty())
            m_meetings.push_back({{i, j}, std::move(crossings), false});
    }
  }

  // Other than those inside of the sum that are not decided: there it does not matter.
  template <Enclosing_number Number>
  std::vector<Crossing_2> crossings_of(std::size_t i, std::size_t j) const
  {
    std::vector<Crossing_2> result =
        Crossing_finder_2<Number>(Traced_view_2(m_curves[i]), Traced_view_2(m_curves[j]), common_ends(i, j))(m_control);
    std::erase_if(result, [&](const Crossing_2& crossing) {
      if (crossing.is_certain)
        return false;
      const Interval_pair p = m_curves[i](crossing.ranges[0]).point, q = m_curves[j](crossing.ranges[1]).point;
      return !may_meet(p, q) || is_inside(common_part(p, q));
    });
    return result;
  }

  bool meet_only_in_common_end(std::size_t i, std::size_t j) const
  {
    for (const int d : {0, 1})
      for (const int e : {0, 1})
        if (m_graph.vertex(i, d) == m_graph.vertex(j, e)) {
          const auto a = m_graph.pieces()[i].chord_cone(d), b = m_graph.pieces()[j].chord_cone(e);
          if (a && b && Chord_cone_2::are_disjoint(*a, *b))
            return true;
        }
    return false;
  }

  // Whether one piece goes on as the other one, over a small part of a moving arc that holds an inflection, and all
  // three run forward along one direction: then they do not meet. Of the first and the last piece this is known from
  // the directions of their ends, between which they turn, or from bounds of all their directions.
  bool go_on_over_inflection(std::size_t i, std::size_t j) const
  {
    for (std::size_t k = 0; k < m_curves.size(); ++k)
      if (!m_graph.pieces()[k].is_convex() && m_graph.vertex(k, 0) == m_graph.vertex(i, 1) &&
          m_graph.vertex(k, 1) == m_graph.vertex(j, 0)) {
        const Interval_pair directions = m_curves[k].whole().direction(),
                            one{Interval(directions[0].inf()), Interval(directions[1].inf())};
        const auto runs_forward = [&](std::size_t piece) {
          const auto& ends = m_graph.pieces()[piece].ends();
          const bool are_ends_forward =
              m_graph.pieces()[piece].is_convex() &&
              std::all_of(ends.begin(), ends.end(), [&](const Convolution_end& end) {
                return end.direction &&
                    certain_sign(dot(one, {interval_of((*end.direction)[0]), interval_of((*end.direction)[1])})) > 0;
              });
          return are_ends_forward || certain_sign(dot(one, m_curves[piece].whole().direction())) > 0;
        };
        if (certain_sign(dot(one, directions)) > 0 && runs_forward(i) && runs_forward(j))
          return true;
      }
    return false;
  }

  std::vector<Common_end> common_ends(std::size_t i, std::size_t j) const
  {
    std::vector<Common_end> result;
    for (const int d : {0, 1})
      for (const int e : {0, 1})
        if (m_graph.vertex(i, d) == m_graph.vertex(j, e)) {
          const auto &a = m_graph.pieces()[i].end(d).direction, &b = m_graph.pieces()[j].end(e).direction;
          result.push_back({{d, e}, a && b && sign_of(exact_cross(*a, *b)) == 0});
        }
    return result;
  }

  // What meets a piece in the same place is one vertex.
  void make_cuts()
  {
    m_vertices = Vertex_classes(m_graph.number_of_vertices());
    m_cuts.clear();
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      const Range range = m_curves[i].range(), inner = m_curves[i].inner_range();
      m_cuts.push_back({Cut{{range.begin, inner.begin}, m_graph.vertex(i, 0), true},
                        Cut{{inner.end, range.end}, m_graph.vertex(i, 1), true}});
    }
    for (const Meeting& meeting : m_meetings)
      for (const Crossing_2& crossing : meeting.crossings) {
        const std::size_t vertex = m_vertices.add();
        for (const std::size_t k : {0, 1})
          m_cuts[meeting.pieces[k]].push_back({crossing.ranges[k], vertex, crossing.is_certain});
      }
    for (std::vector<Cut>& cuts : m_cuts)
      merge(cuts);
  }

  // Cuts that are not told apart become one.
  void merge(std::vector<Cut>& cuts)
  {
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.range.begin < b.range.begin; });
    std::vector<Cut> result;
    for (const Cut& cut : cuts)
      if (!result.empty() && cut.range.begin <= result.back().range.end) {
        m_vertices.join(result.back().vertex, cut.vertex);
        result.back().range = united(result.back().range, cut.range);
        result.back().is_certain = false;
      } else
        result.push_back(cut);
    cuts = std::move(result);
  }

  // Rational points of pieces where they may meet others.
  std::vector<Exact_pair> possible_vertices() const
  {
    std::vector<Exact_pair> result;
    for_each_uncertain_cut([&](std::size_t i, const Cut& cut, const Interval_pair&) {
      const Convolution_piece_2& piece = m_graph.pieces()[i];
      const Range inner = piece.inner_range();
      if (const auto t = Convolution_piece_2::simple_number(cut.range);
          t && to_rational(inner.begin) < *t && *t < to_rational(inner.end))
        if (const auto point = piece.exact_point(*t))
          result.push_back(*point);
    });
    return result;
  }

  // Finds crossings that are not decided, or not told apart, on the level above doubles. Returns whether there are any
  // that were not found there before.
  bool refine_meetings()
  {
    std::vector<char> is_to_be_refined(m_meetings.size(), false);
    for_each_uncertain_cut([&](std::size_t i, const Cut& cut, const Interval_pair&) {
      for (std::size_t m = 0; m < m_meetings.size(); ++m)
        for (const std::size_t k : {0, 1})
          if (const Meeting& meeting = m_meetings[m]; meeting.pieces[k] == i && !meeting.is_fine)
            is_to_be_refined[m] = is_to_be_refined[m] ||
                std::any_of(meeting.crossings.begin(), meeting.crossings.end(),
                            [&](const Crossing_2& crossing) { return crossing.ranges[k].meets(cut.range); });
    });
    for (std::size_t m = 0; m < m_meetings.size(); ++m)
      if (is_to_be_refined[m])
        m_meetings[m] = {m_meetings[m].pieces,
                         crossings_of<Fine_interval>(m_meetings[m].pieces[0], m_meetings[m].pieces[1]), true};
    return std::find(is_to_be_refined.begin(), is_to_be_refined.end(), true) != is_to_be_refined.end();
  }

  template <class Function>
  void for_each_uncertain_cut(const Function& function) const
  {
    for (std::size_t i = 0; i < m_cuts.size(); ++i)
      for (const Cut& cut : m_cuts[i])
        if (!cut.is_certain)
          if (const Interval_pair box = m_curves[i](cut.range).point; !is_inside(box))
            function(i, cut, box);
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_CUTS_2_H
