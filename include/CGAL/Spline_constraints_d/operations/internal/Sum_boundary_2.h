// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_BOUNDARY_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Convolution_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Crossing_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Sum_interior_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The boundary of the Minkowski sum of two regions, as sections of the pieces of their convolution.

The pieces are cut where they cross. Then each section is on the boundary as a whole, or inside of the sum as a whole: the boundary, which has no ends, is made of sections, and can leave one only in a crossing. One point
beside a section tells which.
*/
class Sum_boundary_2
{
public:
  struct Section
  {
    std::size_t piece;
    Range range;                                         // of the parameter of the piece; up to small ranges at the ends
    std::array<std::optional<std::size_t>, 2> crossings; // at the begin and end, where these are not those of the piece
  };

  struct Chain
  {
    std::vector<Section> sections;
    bool is_closed;
  };

private:
  static constexpr int most_trials = 16;
  static constexpr double least_width = 0x1p-20;

  const Convolution_2& m_convolution;
  const Sum_interior_2& m_interior;
  std::vector<Traced_curve_2> m_curves;          // of the pieces
  double m_size = 0;
  std::vector<std::vector<std::pair<Range, std::size_t>>> m_cuts;   // of each piece, with the number of the crossing
  std::size_t m_crossings = 0;
  std::vector<Section> m_sections;
  std::vector<Chain> m_chains;
  std::vector<Interval_pair> m_undecided;

public:
  Sum_boundary_2(const Convolution_2& convolution, const Sum_interior_2& interior) : m_convolution(convolution), m_interior(interior), m_cuts(convolution.pieces().size())
  {
    for (const Convolution_piece_2& piece : convolution.pieces())
      m_curves.emplace_back([&piece](const Range& range) { return piece(range); }, piece.range(), piece.inner_range());
    m_size = size_of_all();
    check_doubtful();
    find_crossings();
    find_sections();
    link_sections();
  }

  const std::vector<Chain>& chains() const { return m_chains; }
  const Convolution_piece_2& piece(const Section& section) const { return m_convolution.pieces()[section.piece]; }

  // Boxes with points that may be on the boundary and are not on the chains, or where these may not be the boundary.
  const std::vector<Interval_pair>& undecided() const { return m_undecided; }

private:
  double size_of_all() const
  {
    Interval_pair box = m_curves.front().whole().box();
    for (const Traced_curve_2& curve : m_curves)
      box = hull(box, curve.whole().box());
    return (std::max)(box[0].sup() - box[0].inf(), box[1].sup() - box[1].inf());
  }

  bool is_inside(const Interval_pair& box) const { return CGAL::certainly(m_interior.contains(box)); }

  void check_doubtful()
  {
    for (const Interval_pair& box : m_convolution.doubtful())
      if (!is_inside(box))
        m_undecided.push_back(box);
  }

  void find_crossings()
  {
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      for (std::size_t j = i + 1; j < m_curves.size(); ++j)
        if (may_meet(m_curves[i].whole().box(), m_curves[j].whole().box()))
          for (const Crossing_2& crossing : Crossing_finder_2(Traced_view_2(m_curves[i]), Traced_view_2(m_curves[j]), common_end(i, j))())
            add_crossing(i, j, crossing);
  }

  // Inside of the sum it does not matter what is not decided.
  void add_crossing(std::size_t i, std::size_t j, const Crossing_2& crossing)
  {
    if (!crossing.is_certain) {
      const Interval_pair p = m_curves[i](crossing.ranges[0]).point, q = m_curves[j](crossing.ranges[1]).point;
      if (!may_meet(p, q) || is_inside(common_part(p, q)))
        return;
      m_undecided.push_back(common_part(p, q));
    }
    m_cuts[i].emplace_back(crossing.ranges[0], m_crossings);
    m_cuts[j].emplace_back(crossing.ranges[1], m_crossings);
    ++m_crossings;
  }

  // The ends of two pieces that are the same, one of which goes on as the other one.
  std::optional<std::array<int, 2>> common_end(std::size_t i, std::size_t j) const
  {
    for (const int end : {0, 1})
      if (Convolution_piece_2::are_same(m_convolution.pieces()[i], end, m_convolution.pieces()[j], 1 - end))
        return std::array<int, 2>{end, 1 - end};
    return std::nullopt;
  }

  // The sections between cuts that are on the boundary.
  void find_sections()
  {
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      auto& cuts = m_cuts[i];
      std::sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first.begin < b.first.begin; });
      Section section{i, m_curves[i].inner_range(), {}};
      for (std::size_t k = 0; k <= cuts.size(); ++k) {
        const bool is_last = k == cuts.size();
        section.range.end = is_last ? m_curves[i].inner_range().end : cuts[k].first.begin;
        section.crossings[1] = is_last ? std::nullopt : std::optional<std::size_t>(cuts[k].second);
        if (!(section.range.begin < section.range.end))   // crossings that are not told apart
          m_undecided.push_back(m_curves[i]({section.range.end, section.range.begin}).point);
        else if (const CGAL::Uncertain<bool> is_on_boundary = !has_inside_beside(section); CGAL::possibly(is_on_boundary)) {
          m_sections.push_back(section);
          if (!is_on_boundary.is_certain())
            m_undecided.push_back(m_curves[i](section.range).point);
        }
        if (!is_last)
          section = {i, {cuts[k].first.end, 0}, {cuts[k].second, std::nullopt}};
      }
    }
  }

  /*
  Whether the points on the right of a section are inside of the sum, as those on the left are: by a point so near that no other piece comes between. The piece itself does not, since its directions differ by less than
  90 degrees from that in the middle of the section.
  */
  CGAL::Uncertain<bool> has_inside_beside(const Section& section) const
  {
    const double t = section.range.middle();
    const auto [point, tangent] = m_curves[section.piece]({t, t});
    const double x = tangent[0].inf(), y = tangent[1].inf(), length = std::hypot(x, y);
    if (!(length > 0) || !std::isfinite(length))
      return CGAL::Uncertain<bool>::indeterminate();
    double distance = m_size / 128;
    for (int trial = 0; trial < most_trials; ++trial, distance /= 4) {
      const Interval_pair p{Interval(point[0].inf() + distance * y / length), Interval(point[1].inf() - distance * x / length)}, between = hull(p, point);
      bool is_free = true;
      for (std::size_t i = 0; is_free && i < m_curves.size(); ++i)
        is_free = i == section.piece || is_apart(m_curves[i], m_curves[i].whole(), between);
      if (!is_free)
        continue;
      if (const CGAL::Uncertain<bool> result = m_interior.contains(p); result.is_certain())
        return result;
    }
    return CGAL::Uncertain<bool>::indeterminate();
  }

  static bool is_apart(const Traced_curve_2& curve, const Traced_curve_2::Part& part, const Interval_pair& box)
  {
    if (!may_meet(part.box(), box))
      return true;
    if (part.range().width() <= least_width)
      return false;
    const auto& halves = curve.halves(part);
    return is_apart(curve, halves[0], box) && is_apart(curve, halves[1], box);
  }

  // Whether a section ends where another one begins.
  bool is_followed_by(const Section& a, const Section& b) const
  {
    if (a.crossings[1] || b.crossings[0])
      return a.crossings[1] == b.crossings[0];
    return Convolution_piece_2::are_same(piece(a), 1, piece(b), 0);
  }

  void link_sections()
  {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    const std::size_t n = m_sections.size();
    std::vector<std::size_t> next(n, none), previous(n, none);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        if (is_followed_by(m_sections[i], m_sections[k])) {
          if (next[i] != none || previous[k] != none)   // the boundary passes through a point twice
            m_undecided.push_back(m_curves[m_sections[k].piece]({m_sections[k].range.begin, m_sections[k].range.begin}).point);
          else {
            next[i] = k;
            previous[k] = i;
          }
        }
    std::vector<bool> is_used(n, false);
    for (const bool is_open : {true, false})
      for (std::size_t i = 0; i < n; ++i)
        if (!is_used[i] && (!is_open || previous[i] == none)) {
          Chain chain{{}, !is_open};
          std::size_t k = i;
          for (; k != none && !is_used[k]; k = next[k]) {
            is_used[k] = true;
            chain.sections.push_back(m_sections[k]);
          }
          if (is_open)
            m_undecided.push_back(m_curves[m_sections[i].piece]({m_sections[i].range.begin, m_sections[i].range.begin}).point);
          m_chains.push_back(std::move(chain));
        }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_BOUNDARY_2_H
